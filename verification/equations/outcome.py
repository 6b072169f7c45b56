"""What became of one equation of a display: its verdict, and its role."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Identity, Matrix, as_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, is_near
from armproof.verification.equations.sides import Member
from armproof.verification.errors import NoValue
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition
from armproof.verification.verdict import DECIDED, HOLDS, EquationResult, Role, Verdict, worst

DEFINES = {Kind.DEFINES, Kind.DEFINES_ENTRIES, Kind.DEFINES_WITHOUT_VALUE, Kind.NUMBER_HERE, Kind.SIGN}


@dataclass(frozen=True)
class AsUsual:
    """What became of an equation while its names meant what they usually do; without meanings, what the text says of them.

    A coordinate that is exactly that `of_another` point is a slip only where the others beside it are not that point's.
    `before` is what the name of a second meaning was defined as, by which the equation then is a slip.
    """

    outcome: Outcome
    meanings: Mapping[str, Quantity]
    of_another: bool = False
    before: tuple[str, Definition] | None = None


@dataclass
class Outcome:
    """What became of one equation of a display."""

    verdict: Verdict
    findings: tuple[Finding, ...] = ()
    equation: int = 1
    true: Member | None = None
    printed: Member | None = None
    pair: Pair | None = None
    wrong: list[tuple[int, int]] = field(default_factory=list)
    samples: int = 0
    max_error: float | None = None
    sampled_only: bool = False
    defines: tuple[str, ...] = ()
    gives: Mapping[str, n.Node] = field(default_factory=dict)  # lengths that its numbers state
    there: Mapping[str, float] = field(default_factory=dict)  # the stated values at which its numbers are wrong
    repeats: tuple[str, int] | None = None  # a definition, by its name and the line of its display
    role: Role = Role.CLAIM
    read_as: str = ""
    uses: frozenset[tuple[str, int]] = frozenset()
    coarse: list[tuple[int, int]] = field(default_factory=list)  # entries whose numbers are rounded too much to tell
    conditions: tuple[n.Node, ...] = ()  # the sides of an implication
    as_usual: AsUsual | None = None  # what it would be if its names meant what they usually do, or what the text says

    def also(self, finding: Finding) -> None:
        """Add a finding to those of the equation."""
        self.findings = (*self.findings, finding)

    def left_open(self, reason: Finding) -> Outcome:
        """Return the outcome where it is not known what the equation says."""
        return replace(self, verdict=Verdict.UNCHECKED, findings=(reason,), wrong=[], pair=None)

    def unless_refuted(self, reason: Finding) -> Outcome:
        """Return the outcome, left open where it is refuted."""
        return self.left_open(reason) if self.verdict is Verdict.REFUTED else self

    def as_wrong_claim(self, pair: Pair, wrong: list[tuple[int, int]]) -> Outcome:
        """Return a definition as the wrong claim that it is: what is printed for its name is another value than the name's."""
        assert self.printed is not None
        value = pair.true.cells[0] if pair.is_scalar else pair.true
        return replace(
            self, verdict=Verdict.REFUTED, findings=(), role=Role.CLAIM, true=replace(self.printed, value=value, problem=None),
            printed=self.true, pair=pair, wrong=wrong, defines=(),
        )  # fmt: skip

    @property
    def is_slip(self) -> bool:
        """Whether it is refuted, and a slip away from what is true."""
        return self.verdict is Verdict.REFUTED and self.pair is not None and is_near(self.pair)

    def unless_slip(self, reason: Finding) -> Outcome:
        """Return the outcome, left open where it is refuted and its value shows no slip: whether one mends it, the diagnosis tells."""
        if self.is_slip or self.verdict is not Verdict.REFUTED:
            return self
        return replace(self.left_open(reason), as_usual=AsUsual(self, {}))

    def result(self, line: int) -> EquationResult:
        """Return what the report keeps of it, for a display at a line."""
        return EquationResult(
            self.equation,
            self.role,
            self.verdict,
            self.read_as,
            tuple(finding.at(self.equation) for finding in self.findings),
            self.samples,
            self.max_error,
            frozenset([*((key, line) for key in self.defines), *([self.repeats] if self.repeats else [])]),
            self.uses,
            alone=frozenset(key for node in self.nodes if (key := n.bare_key(node)) is not None),
        )

    @property
    def sides(self) -> list[Member]:
        """Its two sides, what is taken for true first."""
        return [side for side in (self.true, self.printed) if side is not None]

    @property
    def nodes(self) -> list[n.Node]:
        """The trees of its two sides."""
        return [side.node for side in self.sides]

    @property
    def matrices(self) -> list[Matrix]:
        """The values of its sides that are matrices."""
        return [side.value for side in self.sides if isinstance(side.value, Matrix)]

    def tells(self, *kinds: Kind) -> bool:
        """Whether one of its findings is of one of these kinds."""
        return any(finding.kind in kinds for finding in self.findings)

    @property
    def is_condition(self) -> bool:
        """Whether the equation gives a configuration or a condition, and claims nothing."""
        return self.verdict is Verdict.DEFINED and self.tells(Kind.CONDITION, Kind.CONFIGURATION)

    @property
    def holds_there(self) -> bool:
        """Whether the equation holds at the values stated before it, and not everywhere."""
        return self.verdict is Verdict.CONFIRMED and self.tells(Kind.HOLDS_THERE, Kind.TO_DECIMALS_THERE)

    @property
    def is_mismatch(self) -> bool:
        """Whether two values of different sizes were equated."""
        known = self.true is not None and self.printed is not None and self.true.known and self.printed.known
        return self.verdict is Verdict.REFUTED and known and self.pair is None and not self.wrong

    @property
    def names_value(self) -> bool:
        """Whether a matrix or a formula that is written out is given one name."""
        written = self.true is not None and self.true.rank == 1 and isinstance(self.true.value, Matrix | Scalar)
        return self.verdict is Verdict.DEFINED and len(self.defines) == 1 and written

    @property
    def gives_numbers(self) -> bool:
        """Whether the equation gives names numbers for their meaning: φ = 0, R = I."""
        value = self.true.value if self.defines and self.true is not None else None
        if not isinstance(value, Scalar | Matrix):
            return isinstance(value, Identity)
        cells = as_matrix(value).cells
        return all(isinstance(cell, Scalar) for cell in cells) and not symbols_in(cells)

    @property
    def states_values(self) -> bool:
        """Whether the equation says itself where it holds: J|_{θ_2 = 0}."""
        return any(isinstance(below, n.At) for node in self.nodes for below in n.walk(node))

    @property
    def is_overloaded(self) -> bool:
        """Whether a formula without a value, for the sizes in it, stands in the equation."""
        return (
            self.verdict is Verdict.REFUTED and self.printed is not None and isinstance(self.printed.problem, NoValue)
        )


def new_one(old: Outcome, before: list[Outcome], after: list[Outcome]) -> Outcome:
    """Return what became of the same equation when its display was checked again, or the old outcome where that is not sure.

    It is the only one of its number both times, or holds the same printed member: of several that do, the worst.
    """
    same = [outcome for outcome in after if outcome.equation == old.equation]
    if len(same) == 1 and sum(outcome.equation == old.equation for outcome in before) == 1:
        return same[0]
    if old.printed is None:
        return old
    alike = [o for o in same if o.printed is not None and o.printed.node == old.printed.node]
    return next((o for o in alike if o.verdict is worst([each.verdict for each in alike])), old)


def with_role(outcome: Outcome, chain: n.Chain, names: Names) -> Outcome:
    """Give an outcome its role, which allows only some verdicts; what decides nothing is unchecked."""
    kinds = {finding.kind for finding in outcome.findings}
    if outcome.verdict is Verdict.DEFINED and kinds & DEFINES:
        outcome.role = Role.DEFINITION
    elif outcome.verdict is Verdict.DEFINED and kinds & {Kind.CONFIGURATION, Kind.VALUES_OF_LENGTHS}:
        outcome.role = Role.DATA
    elif outcome.verdict is Verdict.DEFINED and Kind.NO_EQUATION in kinds:
        outcome.role, outcome.verdict = Role.REMARK, Verdict.UNCHECKED
    elif outcome.verdict is Verdict.DEFINED:
        outcome.role = Role.CONDITION if Kind.CONDITION in kinds else Role.CLAIM
        outcome.verdict = Verdict.UNCHECKED
    if outcome.verdict is Verdict.UNCHECKED and not is_kinematics(chain, names):
        outcome.role = Role.REMARK
        outcome.also(say(Kind.BEYOND))
    return outcome


def is_kinematics(chain: n.Chain, names: Names) -> bool:
    """Whether an equation holds anything of the arm's or of the document's kinematics, or could: a joint, a quantity, a name."""
    return any(_is_of_kinematics(below, names) for below in n.walk(chain))


def _is_of_kinematics(node: n.Node, names: Names) -> bool:
    if isinstance(node, n.JointAngles | n.Matrix):
        return True
    if isinstance(node, n.Call):
        return node.function not in ("name", "exp", "ln", "log", "min", "max", "sqrt", "abs", "norm")
    if not isinstance(node, n.Name) or node.base == "words":
        return False
    key = node.key
    plain = replace(node, dots=0)
    return (
        key in names.quantities
        or key in names.state.definitions
        or names.known_symbol(plain.key) is not None
        or names.quantity(plain) is not None
        or bool(node.pre_sub or node.pre_sup)
        or (_is_expected(plain, names) and _is_of_moving_frame(plain, names))
    )


def _is_expected(name: n.Name, names: Names) -> bool:
    """Whether a name is likely to be meant as usual: it is common and has an index, or a configuration is given."""
    return bool(names.state.configuration) or (bool(name.sub) and is_usual(name))


def _is_of_moving_frame(name: n.Name, names: Names) -> bool:
    """Whether convention has a meaning for a name with an index, and not of the base: P_x, x_2."""
    return names.arm is not None and any(quantity.frame != names.arm.frames[0] for quantity in names.usual(name))


def hold(outcomes: list[Outcome]) -> bool:
    """Whether all of what is decided holds."""
    return all(outcome.verdict in HOLDS for outcome in outcomes if outcome.verdict in DECIDED)
