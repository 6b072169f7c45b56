r"""What holds of any Jacobian: \dot x = J \dot q, τ = J^T F, τ^T \dot q = F^T \dot x, J^+ = J^T (J J^T)^{-1}, damped least squares.

A statement is evaluated with Jacobians of letters, square, wide and tall. It is a law where it holds in each of these sizes in
which it has a value, the square one among them, and another one but for J^{-1}.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from operator import mul

from armproof.verification.algebra.matrix import Matrix, as_matrix, is_zero, stacked
from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.algebra.ring import Ring
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import DocumentState

SECONDS = 0.5
SIZES = ((2, 2), (2, 3), (3, 2))  # rows and columns of J
JACOBIAN, RATES, OTHER_RATES, VELOCITY, FORCE, TORQUE = KINDS = (
    "jacobian", "rates", "otherrates", "velocity", "force", "torque",
)  # fmt: skip
OF_JACOBIAN, OF_RATES, OF_VELOCITY = "jacobianrate", "accelerations", "acceleration"  # their derivatives in time
_IN_TIME = {JACOBIAN: OF_JACOBIAN, RATES: OF_RATES, VELOCITY: OF_VELOCITY}
_TERMS = ((JACOBIAN, OF_RATES), (OF_JACOBIAN, RATES))  # of \\ddot x
_JOINTS, _TASK = ("q", "theta", "Theta"), ("x", "X", "p", "P", "r")
_DIRECT = ("f", "h", "FK", "fk")
_OF_TOOL = (
    "", "e", "E", "ee", "EE", "ef", "eff", "EF", "end", "tip", "tool", "tcp", "TCP", "effector", "endeffector", "ext", "t", "d", "des", "n", "c",
)  # fmt: skip
_SEEN = (
    "J",
    "v",
    "V",
    "F",
    "f",
    "h",
    "gamma",
    "nu",
    "xi",
    *_TASK,
)  # what is seen from a frame, as torques and joint rates are not
_FREE = ("w", "z", "y", "u", "zeta")  # of what is projected into the null space of J
_SIGNS = ("d", "delta")  # of what is small; Δq = J^+ e is one step, and Δx = J Δq holds nearly
_DAMPING = ("lambda", "mu", "rho", "k", "alpha", "epsilon", "sigma")


def tells_jacobian(chain: n.Chain) -> bool:
    r"""Whether a law that holds tells which matrix J is, and not its transpose: \dot x = J \dot q, τ = J^T F."""
    spoken: set[tuple[str, str]] = set()
    for member in _of_one_frame(chain).members:
        _usual(member, spoken)
    kinds = {kind for kind, _ in spoken}
    return JACOBIAN in kinds and ({RATES, VELOCITY} <= kinds or {FORCE, TORQUE} <= kinds)


def is_step_along_gradient(chain: n.Chain) -> bool:
    r"""Whether a chain may choose rates along a gradient, \dot q = J^T \dot x, and claim nothing."""
    spoken: set[tuple[str, str]] = set()
    first, *others = (_usual(member, spoken) for member in chain.members)
    kinds = {kind for kind, _ in spoken}
    turned = {each.operator for other in others for each in n.walk(other) if isinstance(each, n.Postfix)}
    return first == n.Name(RATES) and kinds == {RATES, JACOBIAN, VELOCITY} and turned == {"T"}


def holds_of_any_jacobian(chain: n.Chain, names: Names) -> bool:
    """Whether a chain of = about a Jacobian, joint rates, velocities, forces and torques holds whatever these are."""
    law = _law_of(chain, names)
    if law is None:
        return False
    square, *oblong = [law.holds(*size) for size in SIZES]
    return square is True and False not in oblong and (True in oblong or _has_inverse(law.members))


def holds_of_size(chain: n.Chain, names: Names, is_wide: bool) -> bool:
    """Whether a law of any Jacobian holds, and has a value, where J has more columns than rows, or else more rows than columns."""
    law = _law_of(chain, names)
    return law is not None and all(
        law.holds(*size) is True for size in SIZES if size == ((2, 3) if is_wide else (3, 2))
    )


def is_of_motion_or_load(chain: n.Chain, names: Names) -> bool:
    """Whether rates, velocities, forces or torques stand in a law of any Jacobian, which says what J maps."""
    law = _law_of(chain, names)
    return law is not None and not {RATES, VELOCITY, FORCE, TORQUE}.isdisjoint(law.kinds)


@dataclass(frozen=True)
class _Law:
    """What a chain says of Jacobians: its members in the usual names, the kinds of what stands there, and letters of damping."""

    members: Sequence[n.Node]
    names: Names
    kinds: frozenset[str]
    damping: Collection[str]

    def holds(self, rows: int, columns: int) -> bool | None:
        """Whether it holds of Jacobians of a size; None where a member has no value then."""
        return _Size(rows, columns, self.names, self.kinds, self.damping).holds(self.members)


def _law_of(chain: n.Chain, names: Names) -> _Law | None:
    """Return what may be a law of any Jacobian; None of what says more."""
    if len(chain.members) < 2 or set(chain.relations) != {"="} or not _may_be_of_jacobian(chain):
        return None
    if any(isinstance(b, n.Matrix) and len(b.cells) == 1 for member in chain.members for b in n.walk(member)):
        return None  # the one component that a bracket holds is no vector
    if any(n.is_rank(b) for member in chain.members for b in n.walk(member)) and any(map(n.is_number, chain.members)):
        return None  # all of these sizes have the rank 2
    of_two = names.reader.spelling.of_two
    if of_two and any(each.base == "J" and each.sub in of_two for member in chain.members for each in n.names(member)):
        return None  # of ω, and of another velocity: nobody knows which
    spoken: set[tuple[str, str]] = set()
    chain = _with_jacobians(_of_one_label(_of_one_frame(chain), names), names)
    members = [_usual(member, spoken) for member in chain.members]
    kinds = [kind for kind, _ in spoken]
    if any(
        isinstance(alone := bare(member), n.Name) and alone.dots == 0 and _kind_of(alone) == VELOCITY
        for member in chain.members
    ):
        return None  # v = J \dot q says what v is
    others = {each.key for member in members for each in n.names(member)} - set(kinds)
    is_about = not {JACOBIAN, OF_JACOBIAN}.isdisjoint(kinds) or {RATES, VELOCITY, FORCE, TORQUE} <= set(kinds)
    damping = others - {"I"}
    if not is_about or len(set(kinds)) < len(kinds) or any(key.partition("_")[0] not in _DAMPING for key in damping):
        return None  # what is said of two velocities holds of them alone
    return _Law(members, names, frozenset(kinds), damping)


def weighs_forces(node: n.Sum) -> bool:
    """Whether torques and forces stand in one sum: its sign tells which acts on which, and is a convention."""
    kinds = {_kind_of(each) for each in n.names(node)}
    return {FORCE, TORQUE} <= kinds


def names_its_columns(chain: n.Chain, names: Names) -> bool:
    """Whether a chain says no more than that J_1, J_2, …, J_n are the columns of J, as they are of any: [J_1 J_2 ⋯ J_n]."""
    whole, row = (map(bare, chain.members)) if len(chain.members) == 2 and chain.relations == ("=",) else (None, None)
    whole = bare(whole.arguments[0]) if whole is not None and n.is_call(whole, "name") else whole
    if not (isinstance(whole, n.Name) and isinstance(row, n.Matrix) and len(row.rows) == 1 and whole.base == "J"):
        return False
    cells = [*map(bare, row.rows[0])]
    columns = [each for each in cells if isinstance(each, n.Name) and each == n.Name("J", each.sub)]
    dots = [place for place, each in enumerate(cells) if isinstance(each, n.Dots)]
    numbers = [each.sub for each in columns]
    if len(columns) + len(dots) != len(cells) or len(columns) < 2 or dots not in ([], [len(cells) - 2]):
        return False
    counted = [str(number) for number in range(1, len(numbers) + 1)]
    count = str(len(names.arm.joints)) if names.arm is not None else ""
    ends = (
        numbers[-1] in ("n", "N", count) if dots else numbers[-1] in (counted[-1], "n") and count in ("", counted[-1])
    )
    return ends and numbers[:-1] == counted[:-1]


def _of_one_frame(chain: n.Chain) -> n.Chain:
    """Return a chain without the frame in which all of it is seen: τ = {}^0J^T {}^0F."""
    named = [each for member in chain.members for each in n.names(member)]
    seen = [each for each in named if each.base in _SEEN and each.sub in _OF_TOOL]
    if {each.pre_sup for each in seen} in (set(), {""}) or len({each.pre_sup for each in seen}) > 1:
        return chain
    plain = {id(each): replace(each, pre_sup="") for each in seen}
    return replace(chain, members=tuple(n.substitute_each(member, plain) for member in chain.members))


def _of_one_label(chain: n.Chain, names: Names) -> n.Chain:
    r"""Return a chain without the letter that tells its Jacobian, and the velocity that this gives, from another one: \ddot r_ω = J_ω \ddot q + ….

    One that has been given a value, and numbers, which are of points, stay.
    """
    named = [each for member in chain.members for each in n.names(member)]
    told = [each for each in named if each.base == "J" or (each.dots and each.base in _TASK)]
    labels = {each.sub for each in told}
    label = next(iter(labels)) if len(labels) == 1 else ""
    is_label = label.isalpha() and label not in _OF_TOOL and {"J"} < {each.base for each in told}
    if not is_label or names.state.definitions.get(f"J_{label}") is not None:
        return chain
    plain = {id(each): replace(each, sub="") for each in told}
    return replace(chain, members=tuple(n.substitute_each(member, plain) for member in chain.members))


def _with_jacobians(chain: n.Chain, names: Names) -> n.Chain:
    """Return a chain with J for the derivatives of the task by all joints, as the chain names it: ∂x/∂q, ∂f(q)/∂q."""
    nodes = [each for member in chain.members for each in n.walk(member)]
    named = next((each for each in nodes if isinstance(each, n.Name) and _kind_of(each) == JACOBIAN), None)
    derived = [each for each in nodes if isinstance(each, n.Derivative) and _is_jacobian(each, names)]
    if named is None or not derived:
        return chain
    meant = {id(each): named for each in derived}
    return replace(chain, members=tuple(n.substitute_each(member, meant) for member in chain.members))


def _is_jacobian(node: n.Derivative, names: Names) -> bool:
    """Whether a derivative is that of the task, or of the direct kinematics, by the vector of all joints."""
    name, by = bare(node.operand), bare(node.variable)
    if n.is_call(name, "name") and [bare_key(each) for each in name.arguments[1:]] == [bare_key(by)]:
        name = bare(name.arguments[0])  # f(q)
    if not (isinstance(name, n.Name) and isinstance(by, n.Name)) or node.order != 1 or name.dots or by.dots:
        return False
    own = names.arm is not None and any(joint.symbol == by.key for joint in names.arm.joints)
    is_told = any(key.partition("(")[0] == name.key for key in names.state.definitions)
    return by.key in _JOINTS and not own and not is_told and name.base in (*_TASK, *_DIRECT) and name.sub in _OF_TOOL


def _has_inverse(members: Sequence[n.Node]) -> bool:
    """Whether J^{-1} tells that J is square."""
    below = (each for member in members for each in n.walk(member) if isinstance(each, n.Postfix))
    return any(each.operator in ("-1", "-T") and bare(each.base) == n.Name(JACOBIAN) for each in below)


def _may_be_of_jacobian(chain: n.Chain) -> bool:
    bases = {each.base for member in chain.members for each in n.names(member)}
    return bool(bases & {"J", "tau"})


def _usual(node: n.Node, spoken: set[tuple[str, str]]) -> n.Node:
    """Return a tree with one name for what is of a kind; collect the kinds with the names that they have."""
    node = bare(node)
    if n.is_call(node, "name"):
        node = bare(node.arguments[0])
    if isinstance(node, n.Derivative) and isinstance(name := bare(node.operand), n.Name):
        in_time = isinstance(node.variable, n.Name) and node.variable.key == "t" and node.order == 1
        node = replace(name, dots=1) if in_time and not name.dots else node
    if isinstance(node, n.Product):
        node = _with_displacements(node)
    if isinstance(node, n.Product) and _is_in_null_space(node):
        spoken |= {(OTHER_RATES, node.factors[-1].key)}  # type: ignore[attr-defined]
        node = replace(node, factors=(*node.factors[:-1], n.Name(OTHER_RATES)))
    if isinstance(node, n.Name):
        kind = _kind_of(node)
        spoken |= {(kind, node.key)} if kind else set()
        return n.Name(kind) if kind else node
    return n.substitute_each(node, {id(below): _usual(below, spoken) for below in n.children(node)})


def _with_displacements(node: n.Product) -> n.Node:
    r"""Return a product with \dot q for each Δq: one step of what has rates."""
    factors, operators = [*node.factors], ["", *node.operators]
    for at in reversed(range(1, len(factors))):
        sign, name = map(bare, factors[at - 1 : at + 1])
        if not (isinstance(name, n.Name) and isinstance(sign, n.Name)) or operators[at] or name.dots:
            continue
        signs = (*_SIGNS, "Delta") if name.base in _JOINTS else _SIGNS
        if sign.key in signs and name.base in (*_JOINTS, *_TASK):
            factors[at - 1 : at + 1] = [replace(name, dots=1)]
            del operators[at]
    return factors[0] if len(factors) == 1 else replace(node, factors=tuple(factors), operators=tuple(operators[1:]))


def _is_in_null_space(node: n.Product) -> bool:
    """Whether a product is (I - J^+ J) w, of any vector w."""
    *factors, last = map(bare, node.factors)
    if len(factors) != 1 or not isinstance(last, n.Name) or not isinstance(factors[0], n.Sum) or any(last.scripts):
        return False
    terms = [bare(term) for _, term in factors[0].terms]
    return last.base in _FREE and not (last.dots or last.primes) and n.Name("I") in terms and len(terms) == 2


def _kind_of(name: n.Name) -> str:
    """Return of which kind a name is by convention, or an empty text."""
    if name.primes or name.sup or name.pre_sub or name.pre_sup or name.dots > 2:
        return ""
    if name.dots == 2 or (name.dots and name.base in ("J", "v", "V", "nu", "xi")):
        return _IN_TIME.get(_kind_of(replace(name, dots=name.dots - 1)), "")
    if name.dots:
        if name.base in _JOINTS:
            return RATES if name.sub in ("", "d") else OTHER_RATES if name.sub in ("0", "N", "null") else ""
        return VELOCITY if name.base in _TASK and name.sub in _OF_TOOL else ""
    if name.base == "J":
        return JACOBIAN if name.sub in ("", "v", "A", "a", "P", "p", "L") else ""
    if name.base in ("v", "V", "nu", "xi", "e") and name.sub in _OF_TOOL:
        return VELOCITY
    if name.base in ("F", "f", "w", "W") and name.sub in _OF_TOOL:
        return FORCE
    if name.base in ("h", "gamma") and name.sub in ("e", "E", "ee"):
        return FORCE
    return TORQUE if name.base == "tau" and not name.sub else ""


@dataclass(frozen=True)
class _Size:
    """A Jacobian of letters with so many rows and columns."""

    rows: int
    columns: int
    names: Names
    kinds: Collection[str]
    damping: Collection[str]

    def holds(self, members: Sequence[n.Node]) -> bool | None:
        """Whether a chain of these members holds; None where one has no value, such as the inverse of what is not square."""
        algebra = ExactAlgebra(Ring(), None)
        with algebra.budget.of(SECONDS):
            try:
                return self._are_equal(members, algebra) or self._is_solution(members, algebra)
            except (EvaluationError, RecursionError):
                return None

    def _are_equal(self, members: Sequence[n.Node], algebra: ExactAlgebra) -> bool:
        first, *others = map(as_matrix, self._values(members, algebra, free_velocity=False))
        return all(_is_equal(first, other) for other in others)

    def _is_solution(self, members: Sequence[n.Node], algebra: ExactAlgebra) -> bool:
        r"""Whether \dot q = J^+ v says the rates of least squares, J^T J \dot q = J^T v, or damped ones, (J^T J + μ I) \dot q = J^T v."""
        first, *others = members
        damping = [each for member in others for each in map(_damping, n.walk(member)) if each is not None]
        if bare(first) != n.Name(RATES) or VELOCITY not in self.kinds or len(damping) > 1:
            return False
        nodes = [n.Name(JACOBIAN), n.Name(VELOCITY), *(damping or [n.Number(Fraction(0))]), *others]
        j, v, scale, *rates = self._values(nodes, algebra, free_velocity=True)
        j, v = as_matrix(j), as_matrix(v)
        return all(
            _is_equal(j.transpose @ (j @ each) + each.map(partial(mul, scale)), j.transpose @ v)
            for each in map(as_matrix, rates)
        )

    def _values(self, nodes: Sequence[n.Node], algebra: ExactAlgebra, free_velocity: bool) -> list[Value]:
        letters = {letter: letter for letter in self.damping}
        names = Names(None, letters, reader=self.names.reader, state=DocumentState())
        for kind, value in self._meanings(free_velocity).items():
            names.define(kind, value)
        evaluator = Evaluator(names, algebra)
        return [stacked(evaluator.evaluate(node)) for node in nodes]

    def _meanings(self, free_velocity: bool) -> dict[str, partial[Matrix]]:
        m, k = self.rows, self.columns
        letters = {
            JACOBIAN: (m, k),
            RATES: (k, 1),
            OTHER_RATES: (k, 1),
            FORCE: (m, 1),
            OF_JACOBIAN: (m, k),
            OF_RATES: (k, 1),
        }
        found = {kind: partial(_letters, kind, *size) for kind, size in letters.items()}
        one, other = (partial(_product, found[left], found[right], False) for left, right in _TERMS)
        of_letters = partial(_letters, VELOCITY, m, 1)
        velocity = of_letters if free_velocity else partial(_product, found[JACOBIAN], found[RATES], False)
        torque = partial(_product, found[JACOBIAN], found[FORCE], True)
        return {**found, VELOCITY: velocity, TORQUE: torque, OF_VELOCITY: partial(_sum, one, other)}


def _letters(kind: str, rows: int, columns: int, algebra: Algebra) -> Matrix:
    cells = (tuple(algebra.symbol(f"{kind}_{r}{c}") for c in range(columns)) for r in range(rows))
    return Matrix(tuple(cells))


def _product(jacobian: partial[Matrix], other: partial[Matrix], is_transposed: bool, algebra: Algebra) -> Matrix:
    matrix = jacobian(algebra)
    return (matrix.transpose if is_transposed else matrix) @ other(algebra)


def _sum(one: partial[Matrix], other: partial[Matrix], algebra: Algebra) -> Matrix:
    return one(algebra) + other(algebra)


def _damping(node: n.Node) -> n.Node | None:
    """Return the scalar μ of a (… + μ I)^{-1}."""
    if not (isinstance(node, n.Postfix) and node.operator == "-1" and isinstance(added := bare(node.base), n.Sum)):
        return None
    for sign, term in added.terms:
        factors = term.factors if isinstance(term, n.Product) else (term,)
        rest = [factor for factor in factors if bare(factor) != n.Name("I")]
        if sign == "+" and len(rest) == len(factors) - 1:
            return (
                n.Product(tuple(rest), ("",) * (len(rest) - 1)) if len(rest) > 1 else (*rest, n.Number(Fraction(1)))[0]
            )
    return None


def _is_equal(one: Matrix, other: Matrix) -> bool:
    same = one.shape == other.shape
    return same and all(is_zero(a - b) for a, b in zip(one.cells, other.cells, strict=True))
