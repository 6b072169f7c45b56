"""What the words around a display say of it: that it is so elsewhere, in a case, of another point, or not at all."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.conditions.link_conventions import unless_of_other_convention
from armproof.verification.conditions.other_meanings import OtherMeanings
from armproof.verification.conditions.to_first_order import holds_to_first_order
from armproof.verification.conditions.told_branches import ToldBranches
from armproof.verification.conditions.told_directions import ToldDirections
from armproof.verification.conditions.told_indices import unless_told_otherwise
from armproof.verification.conditions.told_jacobians import unless_of_told_jacobian
from armproof.verification.conditions.told_motions import at_told_motion
from armproof.verification.conditions.told_names import ToldNames
from armproof.verification.conditions.told_notation import ATAN2, written_as_told
from armproof.verification.conditions.told_numbers import unless_of_told_numbers
from armproof.verification.conditions.told_operations import unless_of_told_operation
from armproof.verification.conditions.told_otherwise import ToldOtherwise, is_of_other_build
from armproof.verification.conditions.told_relative import unless_relative
from armproof.verification.document import Display
from armproof.verification.document.first_order import FIRST_ORDER
from armproof.verification.document.other_meanings import ANEW, BASE_AT, FRAME, FROM_SHOULDER
from armproof.verification.document.sentences import EVERYWHERE, SAME_POINT, not_known_in, quoted
from armproof.verification.document.strange_letters import STRANGE_LETTER
from armproof.verification.document.subjects import WRIST
from armproof.verification.document.told_constraints import CONSTRAINED, NEGATIVE
from armproof.verification.equations.argument_order import as_told
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.conventions import INNER_POINTS, is_usual
from armproof.verification.verdict import DECIDED, HOLDS, Verdict

_OF_ANGLES = ("cos", "sin", "tan")
_OF_A_SIGN = ("sqrt", "acos", "asin", "atan")
PLANAR_WITH_HAND = 3  # joints: two place the wrist, the last turns the hand


class WordsAround:
    """Leaves open what is decided, where words around its display say it of something else."""

    def __init__(self, circumstances: Circumstances) -> None:
        self.circumstances = circumstances
        self.meanings = OtherMeanings(circumstances.checker, circumstances.given)
        self.directions = ToldDirections(circumstances.checker)
        self.otherwise = ToldOtherwise(circumstances.checker)
        self.branches = ToldBranches(circumstances.checker)
        self.names = circumstances.names
        self.told = ToldNames(self.names, self._has_hand)

    def judge(self, outcome: Outcome, display: Display) -> Outcome:
        """Leave open what the words around a display say to be so elsewhere, in a case, of another point, or not at all."""
        if display.said_next and not display.erratum:
            outcome = self.circumstances.judge_behind(outcome, display.said_next)
        if display.meant and not display.erratum:
            outcome = at_told_motion(outcome, display.meant)
        if display.supposed:
            outcome = replace(outcome.unless_refuted(say(Kind.IS_SUPPOSED)), as_usual=None)
        is_elsewhere = display.of_other_point or (bool(display.meant) and self._is_of_other_frame(display))
        is_elsewhere |= self._is_from_other_base(display)
        is_elsewhere |= any(f"{SAME_POINT} {line}" in display.meant for line in self.names.state.elsewhere)
        if is_elsewhere or (outcome.as_usual is not None and outcome.as_usual.of_another):
            self.names.state.elsewhere.add(display.line)
        if is_elsewhere:
            outcome = self._unless_of_the_tool(
                outcome, is_of_wrist=not display.of_other_point and _is_of_wrist(display)
            )
        if display.in_other_frame and outcome.verdict in DECIDED and any(map(self._is_in_base, _names_in(outcome))):
            outcome = outcome.left_open(say(Kind.OF_OTHER_POINT))
        if display.meant and not display.erratum and outcome.verdict is not Verdict.UNCHECKED:
            outcome = self._unless_noted(outcome, display)
        if display.meant and not display.erratum and outcome.verdict in DECIDED:
            outcome = self.meanings.of_quantity(self.meanings.judge(outcome, display.meant), display.meant)
            outcome = self.meanings.of_arm(outcome, display.meant)
            outcome = self.otherwise.judge(outcome, display.meant)
            outcome = self.branches.judge(outcome, display.meant)
            outcome = unless_of_told_operation(
                unless_of_told_jacobian(outcome, display, self.names), display, self.names
            )
            outcome = unless_of_told_numbers(outcome, display.meant)
        elif display.meant and not display.erratum and outcome.tells(Kind.SIGNED_DISTANCE):
            outcome = self.branches.judge(outcome, display.meant)
        tells = any(each.startswith((ANEW, STRANGE_LETTER)) for each in display.meant)
        if tells and not display.erratum and outcome.as_usual is not None:
            outcome = self._unless_usual_is_open(outcome, display.meant)
        if FIRST_ORDER in display.meant and not display.erratum and holds_to_first_order(outcome, self.names):
            outcome = outcome.left_open(say(Kind.TO_FIRST_ORDER))
        if not display.erratum and _is_told_otherwise(outcome, display.meant):
            outcome = outcome.left_open(say(Kind.IS_SUPPOSED))
        if display.meant and not display.erratum:
            outcome = self.told.judge(outcome, display.meant)
            outcome = self.meanings.in_order(outcome, display.meant)
            outcome = unless_relative(outcome, display.meant, self.names)
        outcome = self.meanings.of_entries(outcome)
        if display.directions:
            outcome = self.directions.judge(outcome, display.directions, self.meanings.raised(display.meant))
            outcome = unless_told_otherwise(outcome, display, self.names)
            outcome = unless_of_other_convention(outcome, display.directions)
        if is_of_other_build(display.meant) or display.denied or display.strange or display.may_not_print:
            outcome = replace(outcome, as_usual=None)  # nor is what its name usually means claimed of the arm
        if display.denied and outcome.verdict is not Verdict.UNCHECKED:
            outcome = replace(outcome.left_open(say(Kind.DENIED)), defines=())
        if (
            display.faulted
            and outcome.verdict is not Verdict.UNCHECKED
            and (outcome.verdict not in HOLDS or outcome.defines)
        ):
            outcome = replace(outcome.left_open(say(Kind.DENIED)), defines=())
        if display.may_not_print and outcome.verdict is not Verdict.UNCHECKED:
            outcome = outcome.left_open(say(Kind.MAY_NOT_PRINT))
        if display.strange and outcome.verdict is not Verdict.UNCHECKED:
            words = ", ".join(not_known_in(display.strange))
            outcome = outcome.left_open(say(Kind.STRANGE_WORDS, text=quoted(display.strange), words=words))
        return outcome

    def _is_from_other_base(self, display: Display) -> bool:
        """Whether the text has the shoulder at a height that is no length of the arm, or counts from a shoulder that is not in the base."""
        if FROM_SHOULDER in display.meant and self._has_column():
            return True
        told = [each.removeprefix(BASE_AT) for each in display.meant if each.startswith(BASE_AT)]
        lengths: set[str | None] = {*self.circumstances.given.lengths}
        return any(self.names.known_symbol(self.names.reader.key_of(each)) not in lengths for each in told)

    def _has_column(self) -> bool:
        """Whether what the first joint turns stands at a height of its own: the shoulder is above the base."""
        arm = self.names.arm
        if arm is None or len(arm.frames) < 2:
            return False
        origin = self.circumstances.checker.exact.quantity(Quantity("origin", arm.frames[1], arm.frames[0]))
        assert isinstance(origin, Matrix)
        height = origin.cells[-1]
        return not height.is_zero() and symbols_in([height]).isdisjoint(self.names.joints)

    def _unless_usual_is_open(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Return an outcome without what it would be with usual meanings, where the text leaves that open."""
        assert outcome.as_usual is not None
        usual = outcome.as_usual.outcome
        left = self.otherwise.judge(self.meanings.judge(usual, meant), meant)
        is_open = usual.verdict in DECIDED and left.verdict not in DECIDED
        return replace(outcome, as_usual=None) if is_open else outcome

    def _unless_noted(self, outcome: Outcome, display: Display) -> Outcome:
        """Leave open what is written in a notation that the text says to be another, and a rank that it says to be so everywhere and that is not."""
        noted = written_as_told(outcome, display, self.names.reader)
        if noted is not None:
            told = self._in_told_order(outcome) if noted == ATAN2 else None
            return told or outcome.left_open(say(Kind.MEANT_OTHERWISE, name=noted))
        if EVERYWHERE in display.meant and outcome.verdict in HOLDS:  # what is refuted of almost all is so of all
            return self.circumstances.of_rank_everywhere(outcome)
        return outcome

    def _in_told_order(self, outcome: Outcome) -> Outcome | None:
        """Return an equation that holds as the text has the arguments of atan2, and not as they usually stand."""
        check = self.circumstances.checker.check
        try:
            return as_told(outcome, lambda chain: check(chain, outcome.equation, 0, define=False))
        except (ArmproofError, RecursionError):
            return None

    def _is_of_other_frame(self, display: Display) -> bool:
        """Whether the sentence beside a display is of the origin of another frame than the last."""
        frames = {each.partition(" ")[2] for each in display.meant if each.startswith(FRAME)}
        arm = self.names.arm
        return arm is not None and bool(frames - {arm.frames[-1] if self._has_hand() else WRIST, arm.frames[-1]})

    def _has_hand(self) -> bool:
        """Whether the arm has joints behind its wrist: more than three, or three in the plane x, y of which the last moves the tool."""
        arm = self.names.arm
        if arm is None or len(arm.joints) != PLANAR_WITH_HAND:
            return arm is not None and len(arm.joints) > PLANAR_WITH_HAND
        whole = self.circumstances.checker.exact.jacobian(arm.frames[-1], arm.frames[0])
        moves = any(not row[-1].is_zero() for row in whole.rows[:2])  # else the wrist is where the tool is
        return moves and all(cell.is_zero() for row in whole.rows[2:5] for cell in row)

    def _is_in_base(self, name: n.Name) -> bool:
        """Whether a name is taken as of the base, and no index, no front matter and no matrix of the document says so."""
        state = self.names.state
        return (
            name.key not in self.names.quantities
            and name.key not in state.inferred.keys() - state.conventional
            and self.names.quantity(replace(name, dots=0)) is not None
            and not re.search(r"\^|_[bs]\b", name.key)
        )

    def _unless_of_the_tool(self, outcome: Outcome, *, is_of_wrist: bool) -> Outcome:
        """Leave open what is decided by a name that convention alone binds to the tool, where the text speaks of another point.

        What is solved for a joint, "Base: q_1 = atan2(y, x)", is of no point, and P_w is of the wrist where the text is.
        """
        if any(map(self._is_joint, outcome.nodes)):
            return outcome
        by_convention = self.names.state.conventional | ({"J"} - {*self.names.quantities})
        plain = [replace(name, dots=0) for name in _names_in(outcome)]
        if outcome.conditions or outcome.verdict is Verdict.REFUTED:  # what a name means there is forgotten behind them
            by_convention |= {name.key for name in plain if is_usual(name) and self.names.is_open(name)}
        of_wrist = self._of_inner_frames() if is_of_wrist else set()
        if outcome.verdict in HOLDS:  # x_{elbow} is of the elbow, as the text is
            plain = [name for name in plain if name.sub not in INNER_POINTS]
        named = {name.key for name in plain} & by_convention - of_wrist
        is_open = outcome.as_usual is None and all(re.search(r"[\d^]|_[bs]\b", key) for key in named)
        if is_open or (outcome.as_usual is None and outcome.verdict not in DECIDED):
            return outcome
        return replace(outcome.left_open(say(Kind.OF_OTHER_POINT)), as_usual=None)

    def _of_inner_frames(self) -> set[str]:
        """Return the names that convention binds to the origin of another frame than the last: P_w of the wrist."""
        arm, inferred = self.names.arm, self.names.state.inferred
        last = arm.frames[-1] if arm is not None else ""
        return {
            key for key, each in inferred.items() if arm is not None and each.kind == "origin" and each.frame != last
        }

    def _is_joint(self, node: n.Node) -> bool:
        if isinstance(node, n.Call) and node.function in _OF_ANGLES and len(node.arguments) == 1:
            node = node.arguments[0]  # cos θ_3 = …
        key = bare_key(node)
        return key is not None and self.names.known_symbol(key) in self.names.joints


def _is_of_wrist(display: Display) -> bool:
    """Whether the words beside a display are of the wrist, and of no other place."""
    return {each for each in display.meant if each.startswith(FRAME)} == {f"{FRAME} {WRIST}"}


def _is_told_otherwise(outcome: Outcome, meant: Sequence[str]) -> bool:
    """Whether what is refuted are rates of a tool that the text constrains, or the negative root of what it says to be negative."""
    if outcome.verdict is not Verdict.REFUTED:
        return False
    if CONSTRAINED in meant and any(map(n.has_rates, outcome.nodes)):
        return True
    sums = (each for node in outcome.nodes for each in n.walk(node) if isinstance(each, n.Sum))
    return NEGATIVE in meant and any(map(_takes_off, sums))


def _takes_off(node: n.Sum) -> bool:
    """Whether a sum takes a root or an arc function off: −√(1 − c²)."""
    return any(sign == "-" and n.is_call(n.bare(term), *_OF_A_SIGN) for sign, term in node.terms)


def _names_in(outcome: Outcome) -> Iterator[n.Name]:
    """Yield the names in an equation, or in the equations of an implication."""
    nodes = (*outcome.nodes, *outcome.conditions)
    return (below for node in nodes for below in n.names(node))
