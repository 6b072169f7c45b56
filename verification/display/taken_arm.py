"""What an arm that was taken from the document refutes and what it leaves open: it may not be the arm that is spoken of."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.verification.document import Display, Document, Table
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.quantities import leads_outwards, tells_frame
from armproof.verification.naming.state import DocumentState, links_told
from armproof.verification.verdict import TakenArm, Verdict


class OfTakenArm:
    """Judges what is refuted in a document for an arm that was taken from it."""

    def __init__(self, checker: ChainChecker, document: Document, taken: TakenArm) -> None:
        self.checker, self.document, self.taken = checker, document, taken
        self.names, self.arm = checker.names, checker.names.arm

    def judge(self, outcome: Outcome) -> Outcome:
        """The arm of one exercise refutes nothing in another, which may be about one that is only drawn; nor in other variables."""
        if outcome.verdict is not Verdict.REFUTED:
            return outcome
        taken, where = self.taken, self._exercise_of_arm()
        links = links_told(self.names.state.section)
        is_other = (
            links not in (None, self._links_where_shown()) and self.arm is not None and links != len(self.arm.joints)
        )
        if is_other or where not in (0, self.names.state.apart):
            return outcome.left_open(say(Kind.ARM_OF_OTHER_EXERCISE, line=taken.line))
        if (other := next(filter(self._is_other_variable, names_in(outcome)), None)) is not None:
            joint = self.names.known_symbol(other.key)
            return outcome.left_open(say(Kind.UNTOLD_VARIABLE, name=other.key, joint=str(joint)))
        if self._is_of_untold_direction(outcome):
            return outcome.left_open(say(Kind.WHICH_INDEX))
        if outcome.tells(Kind.RAGGED_BLOCK_ROWS) and any(name.base == "J" for name in names_in(outcome)):
            return outcome.left_open(outcome.findings[0])  # J in four blocks is that of another number of joints
        if taken.is_part and outcome.tells(Kind.NO_SUCH_ANGLE):
            return outcome.left_open(outcome.findings[0])
        if taken.several_tools and (untold := next(filter(self._is_of_any_tool, names_in(outcome)), None)) is not None:
            return outcome.left_open(say(Kind.SEVERAL_TOOLS, line=taken.line, name=untold.text))
        return outcome

    def _links_where_shown(self) -> int | None:
        """Return how many links the heading tells under which the arm was shown: of six joints it may show three."""
        taken = self.taken
        both: list[Display | Table] = [*self.document.displays, *self.document.tables]
        shown = (each for each in both if (each.cell, each.line) == (taken.cell, taken.line))
        return next((links_told(each.section) for each in shown), None)

    def _exercise_of_arm(self) -> int:
        """The exercise with an arm of its own in which the arm was shown, counted from 1; 0 where it holds for all of them."""
        taken = self.taken
        both: list[Display | Table] = [*self.document.displays, *self.document.tables]
        parts = sorted(both, key=lambda one: (one.cell or 0, one.line))
        begun = DocumentState()
        for part in parts:
            if (part.cell or 0, part.line) <= (taken.cell or 0, taken.line):
                begun.enter(part.section)
        return begun.apart

    def _is_of_untold_direction(self, outcome: Outcome) -> bool:
        """Whether nothing tells which index is the reference, and names such as T_0^3 lead outwards if that is the lower one."""
        if self.names.stated_transforms or self.names.state.transforms or self.arm is None:
            return False
        indexed = [name for name in names_in(outcome) if name.base in "TAHR" and name.sub and name.sup]
        return bool(indexed) and all(leads_outwards(name, self.arm, "lower") for name in indexed)

    def _is_of_any_tool(self, name: n.Name) -> bool:
        """Whether a name stands for a quantity of the last frame without saying so, or did until it was refuted."""
        usual = self.names.usual(name) if is_usual(name) else ()
        quantity = self.checker.quantity_of(name) or next(iter(usual), None)
        return quantity is not None and not tells_frame(name, quantity)

    def _is_other_variable(self, node: n.Name) -> bool:
        """Whether a θ_2 stands where the arm's joint is q_2, and the document, which has both, does not say what it is by that."""
        told = (
            self.names.reader.spelling.variables != "both" or self.names.offset_joints
        )  # what a table has beside q_2 is θ_2
        if told or self.arm is None:
            return False
        joints = {joint.symbol for joint in self.arm.joints}
        return node.key not in joints and node.base in ("theta", "q") and self.names.known_symbol(node.key) in joints


def names_in(outcome: Outcome) -> Iterator[n.Name]:
    """Yield the names in both sides of an equation."""
    return (below for node in outcome.nodes for below in n.names(node))
