"""General statements: the link matrix with index i, in the classic and the modified convention."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from verification.compare import align, different_entries, exactly_equal
from verification.equation import ChainChecker, Outcome
from verification.errors import EvaluationError
from verification.latex import nodes as n
from verification.matrix import Matrix
from verification.names import Names
from verification.quantities import Quantity
from verification.verdict import Verdict

PAIRS = {("i-1", "i"): False, ("i", "i-1"): True}
NEARLY = 6  # a matrix with at most so many wrong entries is meant to be that link matrix


class GeneralStatements:
    """Checks chains about `{}^{i-1}T_i` and its inverse, whose index i stands for any link.

    α, a, d, θ are free symbols there, whatever arm the document is about. A convention named in the front matter
    ({link: classic} or {link: modified}) decides; else the indices do: a_{i-1}, α_{i-1} belong to the modified
    convention, a_i, α_i to the classic one.
    """

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        names = checker.names
        general = Names(None, names.symbols, names.quantities, names.transforms, names.definitions, names.reader)
        self._general = ChainChecker(general, replace_arm(checker), checker.sampled)

    def check(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome] | None:
        """Return the outcomes if the chain is about the general link matrix, else None."""
        heads = [self._link_pair(member) for member in chain.members]
        if not any(heads) or any(m.key in self.checker.names.quantities for m in chain.members if isinstance(m, n.Name)):
            return None
        inverse = next(head for head in heads if head is not None)[1]
        convention = self._convention(chain)
        if convention is None:
            return None
        self._general.confirm = self.checker.confirm
        self._general.sampled = self.checker.sampled
        true = self._general.exact.quantity(Quantity("link", convention))
        node: n.Node = n.Name("link", sub=convention, span=chain.members[0].span)
        self._general.names.quantities = {**self._general.names.quantities, node.key: Quantity("link", convention)}  # type: ignore[attr-defined]
        if inverse:
            node = n.Postfix(node, "-1")
            true = true.transpose
        members = tuple(node if head is not None else member for head, member in zip(heads, chain.members, strict=True))
        named = any(quantity.kind == "link" for quantity in self.checker.names.quantities.values())
        if not named and not self._plausible(node, members):
            return None
        outcomes = self._general.check(replace(chain, members=members), equation, line, define)
        return [self._noted(outcome, convention) for outcome in outcomes] or None

    def _noted(self, outcome: Outcome, convention: str) -> Outcome:
        if outcome.verdict is Verdict.PROVED:
            outcome.message = f"the {convention} link matrix"
        return outcome

    def _plausible(self, node: n.Node, members: tuple[n.Node, ...]) -> bool:
        """Whether every matrix in the chain is the link matrix or nearly so; else it is somebody's own definition."""
        reference = self._general.member(node)
        for member in members:
            value = self._general.member(member)
            if not value.known:
                return False
            if not isinstance(value.value, Matrix):
                return False
            try:
                counts = [len(different_entries(pair, exactly_equal)) for pair in align(reference.value, value.value, self._general.exact)]
            except EvaluationError:
                return False
            if min(counts) > NEARLY:
                return False
        return len(members) > 1

    def _link_pair(self, node: n.Node) -> tuple[bool, bool] | None:
        """Return (True, whether inverse) for {}^{i-1}T_i, T_i^{i-1}, {}^{i-1}_iT, A_i and their inverses."""
        if not isinstance(node, n.Name) or node.base not in ("T", "A", "H") or node.primes or node.dots:
            return None
        if node.key in self.checker.names.definitions:
            return None
        if node.pre_sup and (node.sub or node.pre_sub) and not node.sup:
            pair = (node.pre_sup, node.sub or node.pre_sub)
        elif node.sub and node.sup:
            upper = self.checker.names.transforms == "upper"
            pair = (node.sup, node.sub) if upper else (node.sub, node.sup)
        elif node.sub == "i" and not node.sup and not node.pre_sup and node.base in ("A", "H", "T"):
            pair = ("i-1", "i")
        else:
            return None
        return (True, PAIRS[pair]) if pair in PAIRS else None

    def _convention(self, chain: n.Chain) -> str | None:
        for quantity in self.checker.names.quantities.values():
            if quantity.kind == "link":
                return quantity.frame
        subs = {(below.base, below.sub) for member in chain.members for below in n.walk(member) if isinstance(below, n.Name)}
        modified = any(base in ("a", "alpha") and sub == "i-1" for base, sub in subs)
        classic = any(base in ("a", "alpha") and sub == "i" for base, sub in subs)
        if modified == classic:
            return None
        return "modified" if modified else "classic"


def replace_arm(checker: ChainChecker) -> Any:
    """Return an exact algebra over the same ring in which no arm binds any symbol."""
    from verification.algebras import ExactAlgebra

    return ExactAlgebra(checker.exact.ring, None)
