"""General statements: the link matrix with index i, in the classic and the modified convention."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Any

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.alignment import align, different_entries, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.link_letters import letterings
from armproof.verification.equations.misreadings import ELEMENTARY
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import greek
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.quantities import is_inverse_link
from armproof.verification.verdict import HOLDS, Verdict

MIXED = 9  # as many where indices of both conventions are mixed, which is nobody's own definition
NEARLY = 6  # a matrix with at most so many wrong entries is meant to be that link matrix


LINKS = {convention: n.Name("link", sub=convention) for convention in ("classic", "modified")}
ANGLES = frozenset([*greek.ANGLES, "q", "pi"])
LENGTHS = frozenset(["a", "d", "l", "b", "r"])


_PARAMETERS = ("theta", "alpha", "a", "d")


def _letters(node: n.Node) -> frozenset[tuple[str, str]]:
    """The names of a tree but for π and the axes of elementary matrices."""
    axes = {id(b.arguments[0]) for b in n.walk(node) if n.is_call(b, *ELEMENTARY)}
    names = (below for below in n.names(node) if id(below) not in axes)
    return frozenset((name.base, name.sub) for name in names if name.key != "pi")


class GeneralStatements:
    """Checks chains about `{}^{i-1}T_i` and its inverse, whose index i stands for any link.

    α, a, d, θ are free symbols there, whatever arm the document is about. A convention named in the front matter
    ({link: classic} or {link: modified}) decides; else the indices do: a_{i-1}, α_{i-1} belong to the modified
    convention, a_i, α_i to the classic one.
    """

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        names = checker.names
        links = {link.key: Quantity("link", convention) for convention, link in LINKS.items()}
        general = replace(names, arm=None, quantities={**names.quantities, **links}, general=True)
        self._general = self._usual = ChainChecker(general, replace_arm(checker), checker.sampled)

    def check(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome] | None:
        """Return the outcomes of a chain with a link matrix of any link if they are about that, else None."""
        chain = of_link_i(chain)
        if any(m.key in self.checker.names.quantities for m in chain.members if isinstance(m, n.Name)):
            return None
        self._general = self._nearest_letters(chain)
        self._general.confirm = self.checker.confirm
        heads = self._heads(chain)
        if any(
            head is not None and _of_another_link(_composed(m, self.checker.names.transforms))
            for head, m in zip(heads, chain.members, strict=True)
        ):
            return None
        named = any(quantity.kind == "link" for quantity in self.checker.names.quantities.values())
        # letters of both conventions: the one that is nearer is meant
        readings = [(convention, self._members(chain, heads, convention)) for convention in self._conventions(chain)]
        if not readings:
            return None
        counts = [self._wrong_entries(*members) for _, members in readings]
        wrong, (convention, (_, members)) = min(zip(counts, readings, strict=True), key=lambda pair: pair[0])
        bound = MIXED if len(readings) > 1 else NEARLY
        if not named and wrong > (0 if self._is_defined(chain) else bound):
            return None
        outcomes = self._general.check(replace(chain, members=members), equation, line, define)
        if define and outcomes and all(outcome.verdict is Verdict.PROVED for outcome in outcomes):
            self._bind_links(chain)
        return [self._noted(outcome, convention) for outcome in outcomes] or None

    def _nearest_letters(self, chain: n.Chain) -> ChainChecker:
        """Return the checker in which the letters for a and d mean what makes fewest entries of the link matrix wrong."""
        arm = self.checker.names.arm
        is_modified = arm is not None and arm.dh is not None and arm.dh.convention == "modified"
        tried = [self._in_letters(meant) for meant in letterings(chain, is_modified)]
        nearest = min(tried, key=lambda each: self._wrong_in(each, chain)) if len(tried) > 1 else tried[0]
        if nearest is not self._usual:
            self._write_in(nearest.names.symbols, chain)
        return nearest

    def _write_in(self, meant: Mapping[str, str], chain: n.Chain) -> None:
        """Let what is corrected be written in the document's letters."""
        state = self.checker.names.state
        names = [below for member in chain.members for below in n.names(member)]
        own = {meant[name.key]: name.text for name in names if name.key in meant and name.text}
        state.notation = replace(state.notation, symbols={**state.notation.symbols, **own})

    def _in_letters(self, meant: dict[str, str]) -> ChainChecker:
        if not meant:
            return self._usual
        names = replace(self._usual.names, symbols={**self._usual.names.symbols, **meant})
        return ChainChecker(names, replace_arm(self.checker), self.checker.sampled)

    def _wrong_in(self, checker: ChainChecker, chain: n.Chain) -> int:
        self._general = checker
        return self._nearest(chain, [self._is_inverse(member) for member in chain.members])

    def _bind_links(self, chain: n.Chain) -> None:
        """Let T_1, T_2, … be the links of the arm where T_i is the link matrix of any: else they are usually poses in the base."""
        arm = self.checker.names.arm
        if arm is None:
            return
        for name in (member for member in map(bare, chain.members) if isinstance(member, n.Name)):
            if name.base == "T" and name.sub == "i" and not (name.sup or name.pre_sub or name.pre_sup or name.primes):
                for before, frame in pairwise(arm.frames):
                    self.checker.names.state.infer_usual(f"T_{frame}", Quantity("pose", frame, before))

    def _heads(self, chain: n.Chain) -> list[bool | None]:
        """Return of each member whether it is the inverse of a link matrix; None where it is neither.

        Where nothing has told yet which index of T_i^{i-1} is the reference, what stands beside it does.
        """
        names, heads = self.checker.names, [self._is_inverse(member) for member in chain.members]
        if names.stated_transforms or names.state.transforms:
            return heads
        names.state.transforms = "lower"
        turned = [self._is_inverse(member) for member in chain.members]
        names.state.transforms = ""
        upper, lower = ((self._nearest(chain, each) if turned != heads else MIXED) for each in (heads, turned))
        if min(upper, lower) < NEARLY:
            names.state.transforms = "lower" if lower < upper else "upper"
        return turned if names.state.transforms == "lower" else heads

    def _nearest(self, chain: n.Chain, heads: list[bool | None]) -> int:
        """Return how many entries are wrong in the convention in which fewest are."""
        counts = (self._wrong_entries(*self._members(chain, heads, each)) for each in self._conventions(chain))
        return min(counts, default=MIXED)

    def _members(self, chain: n.Chain, heads: list[bool | None], convention: str) -> tuple[n.Node, tuple[n.Node, ...]]:
        """Return the link matrix of a convention, and the chain with it (or its inverse) in the place of its name."""
        link = replace(LINKS[convention], span=chain.members[0].span)
        members = tuple(
            member if head is None else n.Postfix(link, "-1") if head else link
            for head, member in zip(heads, chain.members, strict=True)
        )
        return next(m for m, head in zip(members, heads, strict=True) if head is not None), members

    def _is_defined(self, chain: n.Chain) -> bool:
        """Whether the document has given the link matrix a meaning of its own: then only what is exactly one is judged here."""
        return any(isinstance(below, n.Name) and below.key in self.checker.names.state.definitions
                   for member in chain.members if self._is_inverse(member) is not None for below in n.walk(member))  # fmt: skip

    def identity(self, chain: n.Chain, equation: int, line: int) -> list[Outcome] | None:
        """Return the outcomes of an identity in letters that are no arm's: R_z(θ) = […], cos² θ + sin² θ = 1; else None.

        An elementary matrix in the letters of its own arguments is a claim. Any other equation between angles may be
        a condition of its figure, and counts only where it is an identity.
        """
        members = [(_letters(member), member) for member in chain.members]
        elementary = any(n.is_call(b, *ELEMENTARY) for _, m in members for b in n.walk(m))
        known = ANGLES | (LENGTHS if elementary else frozenset())
        letters = frozenset[tuple[str, str]]().union(*(found for found, _ in members))
        if not letters or any(base not in known for base, _ in letters) or any(map(_has_q_alone, chain.members)):
            return None
        outcomes = self._general.check(chain, equation, line, False)
        if all(outcome.verdict in HOLDS for outcome in outcomes):
            return outcomes
        claimed = elementary and any(found == letters for found, m in members if not isinstance(m, n.Name))
        return outcomes if claimed and all(o.verdict is not Verdict.UNCHECKED for o in outcomes) else None

    def product(self, chain: n.Chain, equation: int, line: int) -> list[Outcome] | None:
        """Return the outcomes of what is printed for a product of printed matrices in letters that are no arm's; else None."""
        written = _product_in_letters(chain)
        return self._general.check(written, equation, line, False) if written is not None else None

    def _noted(self, outcome: Outcome, convention: str) -> Outcome:
        if outcome.verdict is Verdict.PROVED:
            outcome.findings = (say(Kind.LINK_MATRIX, convention=convention),)
        return outcome

    def _wrong_entries(self, node: n.Node, members: tuple[n.Node, ...]) -> int:
        """How many entries of the chain's worst matrix differ from the link matrix; beyond NEARLY it is somebody's own definition.

        The link matrix printed for its inverse, or the inverse for it, is no definition: it counts as one wrong entry.
        """
        reference = self._general.member(node).value
        other = self._general.member(node.base if isinstance(node, n.Postfix) else n.Postfix(node, "-1")).value
        most = 0
        for member in members:
            value = self._general.member(member)
            if not value.known or not isinstance(value.value, Matrix) or len(members) < 2:
                return MIXED + 1
            wrong = min(self._differences(reference, value.value), 1 + NEARLY * self._differences(other, value.value))
            most = max(most, wrong)
        return most

    def _differences(self, reference: Matrix, printed: Matrix) -> int:
        try:
            return min(
                len(different_entries(pair, exactly_equal)) for pair in align(reference, printed, self._general.exact)
            )
        except EvaluationError:
            return MIXED + 1

    def _is_inverse(self, node: n.Node) -> bool | None:
        return is_inverse_link(_composed(node, self.checker.names.transforms), self.checker.names.transforms)

    def _conventions(self, chain: n.Chain) -> tuple[str, ...]:
        """The convention that the front matter names, else those to which the indices of a and α belong."""
        for quantity in self.checker.names.quantities.values():
            if quantity.kind == "link":
                return (quantity.frame,)
        meant = self._general.names.symbols
        keys = {meant.get(below.key, below.key) for member in chain.members for below in n.names(member)}
        modified, classic = not keys.isdisjoint(("a_i-1", "alpha_i-1")), not keys.isdisjoint(("a_i", "alpha_i"))
        return (("classic",) if classic else ()) + (("modified",) if modified else ())


def _composed(node: n.Node, transforms: str) -> n.Node:
    """Return T_i^{i-1} for T_{i'}^{i-1} T_i^{i'}, whatever frame stands between; any other node as it is."""
    inner = bare(node)
    names = (
        [factor for factor in map(bare, inner.factors) if isinstance(factor, n.Name)]
        if isinstance(inner, n.Product)
        else []
    )
    if not isinstance(inner, n.Product) or not len(names) == len(inner.factors) == 2 or "×" in inner.operators:
        return node
    one, other = names
    if one.base != other.base or any(each != n.Name(each.base, each.sub, each.sup) for each in names):
        return node
    if transforms == "upper" and one.sub and one.sub == other.sup:
        return replace(one, sub=other.sub, text="")
    return replace(one, sup=other.sup, text="") if transforms == "lower" and one.sup and one.sup == other.sub else node


def _product_in_letters(chain: n.Chain) -> n.Chain | None:
    """Return the members of a chain that are a product of printed matrices and what is printed for it, [Z][X] = […] […] = […]."""
    printed = [member for member in chain.members if _is_printed(bare(member))]
    letters = {_letters(member) for member in printed}
    if not any(isinstance(bare(member), n.Product) for member in printed) or len(printed) < 2 or len(letters) != 1:
        return None
    known = all(base in ANGLES | LENGTHS and not sub.isdigit() for base, sub in next(iter(letters)))
    return replace(chain, members=tuple(printed), relations=("=",) * (len(printed) - 1)) if known else None


def _is_printed(node: n.Node) -> bool:
    """Whether a tree is a matrix with its entries, or a product of such."""
    return isinstance(node, n.Matrix) or (
        isinstance(node, n.Product) and all(isinstance(bare(f), n.Matrix) for f in node.factors)
    )


def _of_another_link(member: n.Node) -> bool:
    """Whether a link matrix keeps an index of its own, T_k^{k-1} beside θ_i: what is told is of two links."""
    names = n.names(member)
    return any({*name.sub.split(","), name.sup, name.pre_sub, name.pre_sup} - {"i", "i-1", ""} for name in names)


def of_link_i(chain: n.Chain) -> n.Chain:
    """Return a chain about link n with the index i: T_n^{n-1} = Rot(z, θ_n) …, A_n = […] or {}^jT_{j+1} = […] of θ_j or θ_{j+1}."""
    chain = _with_index(chain)
    names = n.names(chain)
    scripts = {script for name in names for script in name.scripts}
    own = {name.sub for name in names if name.base in ("theta", "alpha", "a", "d")}
    next_one = next((letter for letter in "ijkn" if {letter, f"{letter}+1"} <= scripts), "")
    letter = next((letter for letter in "jkn" if {letter, f"{letter}-1"} <= scripts or own == {letter}), "")
    if next_one and own == {next_one} and any((name.sub, name.sup) == (next_one, f"{next_one}+1") for name in names):
        return chain  # A_i^{i+1} of θ_i is A_i^{i-1} with a slip, or counts from 0
    if next_one and f"{next_one}-1" not in scripts:
        spelt = {next_one: "i-1", f"{next_one}+1": "i"}
        inner = {next_one: "i"} if own == {next_one} else spelt
    elif letter and not scripts & {"i", "i-1"}:
        spelt = inner = {letter: "i", f"{letter}-1": "i-1"}
    else:
        return chain
    for name in names:
        meant = spelt if name.base in "TAHRM" else inner
        sub, sup, below, above = (meant.get(each, each) for each in name.scripts)
        changed = replace(name, sub=sub, sup=sup, pre_sub=below, pre_sup=above)
        chain = n.substitute(chain, name, changed) if changed != name else chain  # type: ignore[assignment]
    return chain


def _with_index(chain: n.Chain) -> n.Chain:
    """Return T = [cos θ, -sin θ cos α, …] with the index i: of the modified convention where the first row holds no α."""
    matrix = next((bare(each) for each in chain.members if isinstance(bare(each), n.Matrix)), None)
    names = [below for below in n.names(chain) if below.key != "pi"]
    told = {name.base for name in names if name.base in _PARAMETERS}
    if not isinstance(matrix, n.Matrix) or any(any(each.scripts) for each in names) or not {"theta", "alpha"} <= told:
        return chain
    is_classic = any(below.base == "alpha" for c in matrix.rows[0] for below in n.names(c))
    indices = {"theta": "i", "d": "i", **dict.fromkeys(("a", "alpha"), "i" if is_classic else "i-1")}
    for name in names:
        index = indices.get(name.base, "i" if name.base in "TAHM" else "")
        changed = replace(name, sub=index)
        chain = n.substitute(chain, name, changed) if index else chain  # type: ignore[assignment]
    return chain


def is_sum_of_indices(chain: n.Chain) -> bool:
    """Whether a chain says what c_{ij} abbreviates, as everybody means it: cos(θ_i + θ_j)."""
    if len(chain.members) != 2:
        return False
    name, call = map(n.bare, chain.members)
    if not (isinstance(name, n.Name) and isinstance(call, n.Call) and len(call.arguments) == 1):
        return False
    angle = n.bare(call.arguments[0])
    terms = angle.terms if isinstance(angle, n.Sum) else ()
    added = [term for sign, term in terms if sign == "+" and isinstance(term, n.Name)]
    one_letter = len({term.base for term in added}) == 1 and added[0].base in ("theta", "q")
    indices = "".join(term.sub for term in added)
    function = {"c": "cos", "s": "sin"}.get(name.base.lower())
    return one_letter and len(added) == len(terms) and (name.sub.replace(",", ""), function) == (indices, call.function)


def replace_arm(checker: ChainChecker) -> Any:
    """Return an exact algebra over the same ring in which no arm binds any symbol."""
    from armproof.verification.evaluation.exact import ExactAlgebra

    return ExactAlgebra(checker.exact.ring, None)


def _has_q_alone(node: n.Node) -> bool:
    """Whether q stands in no function: it is all joint variables, or a quaternion, and no angle."""
    if isinstance(node, n.Call):
        return node.function in ("abs", "norm") and any(map(_has_q_alone, n.children(node)))
    return (isinstance(node, n.Name) and node.base == "q" and not node.sub) or any(map(_has_q_alone, n.children(node)))
