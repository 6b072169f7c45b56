"""What a text tells of directions, beside the arm that formulas give: where they part, what rests on it is left open."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from armproof.verification.algebra.calculus import angles_in, derivative, substitute, symbols_in
from armproof.verification.algebra.matrix import as_matrix, stacked
from armproof.verification.algebra.quantity import COMPONENTS
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.orientations import AT_ZERO, AXIS_DOWN, FALLS, OF_LEVEL, RISES
from armproof.verification.document.sentences import quoted
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED

_HANGS = regex(  # what angles are counted from that are zero where the arm hangs
    r"downward vertical|vertical(?:ly)? down|verticale? (?:descendante?|(?:dirigée? )?vers le bas)|senkrechten nach unten|nach unten (?:zeigenden|gerichteten) senkrechten|vertical (?:descendente|hacia abajo)|verticale (?:discendente|verso il basso)"
)


class ToldDirections:
    """Leaves open what is written with an angle that the text counts otherwise than the formulas do, or with an axis that it turns round.

    An arm that a table, matrices or the front matter give has its frames from there, whichever axis points down; from where its
    angles are counted, and which way, the text may tell otherwise.
    """

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names

    def judge(self, outcome: Outcome, told: Sequence[str], raised: Collection[str] = ()) -> Outcome:
        """Leave open what the told directions make doubtful, and what it defines; of `raised` angles the arm stands up at zero, as it is told."""
        if not (outcome.verdict in DECIDED or outcome.defines):
            return outcome
        facts = [(fact, text) for fact, _, text in (each.partition("\n") for each in told)]
        facts = [each for each in facts if not self._counts_from_vertical(*each, raised)]
        shown = self._shown(facts) if self.names.arm is None else set()
        doubted = next((text for fact, text in facts if fact not in shown and self._is_doubted(outcome, fact)), None)
        if doubted is None:
            return outcome
        left = outcome.left_open(say(Kind.TOLD_DIRECTION, text=quoted(doubted)))
        return replace(left, defines=(), as_usual=None)

    def _counts_from_vertical(self, fact: str, text: str, raised: Collection[str]) -> bool:
        """Whether a sentence only calls an angle an elevation that another one counts from the vertical."""
        if OF_LEVEL.search(text.lower()):
            return False
        which = fact.removeprefix(RISES).strip() if fact.startswith(RISES) else ""
        return bool(which) and self.names.known_symbol(self.names.reader.key_of(which)) in raised

    def _shown(self, facts: Sequence[tuple[str, str]]) -> set[str]:
        """Return the facts that the height shows which a document without an arm gives: it grows with an angle of elevation, and upside down where its axis points down."""
        axis, height = self._height()
        if height is None:
            return set()
        down = f"{AXIS_DOWN} {axis}"
        sign = -1 if any(fact == down for fact, _ in facts) else 1
        turns = {RISES: sign, FALLS: -sign}
        found = {
            fact
            for fact, _ in facts
            for kind, wanted in turns.items()
            if fact.startswith(kind) and self._grows(height, fact.removeprefix(kind).strip(), wanted)
        }
        hangs = any(fact == down and _HANGS.search(text.lower()) for fact, text in facts)
        if found or (hangs and (self._size(self._at(height, [*angles_in(height)])) or 0) > 0):
            found.add(down)
        return found

    def _height(self) -> tuple[str, Scalar | None]:
        """Return the vertical coordinate that a document gives, and its axis: z, the last of three of p, else y."""
        made, exact = self.names.state.definitions, self.checker.exact
        for axis, key, place in (*((axis, axis, 0) for axis in "zZ"), *(("z", key, 2) for key in "pP"), ("y", "y", 0)):
            try:
                value = as_matrix(stacked(self.names.defined_value(key, exact))) if key in made else None
            except (EvaluationError, UnboundName):
                value = None
            if value is not None and len(value.cells) == place + 1 and isinstance(value.cells[place], Scalar):
                return axis.lower(), value.cells[place]
        return "", None

    def _grows(self, height: Scalar, letter: str, sign: int) -> bool:
        """Whether a height grows, or falls, with an angle where all are zero."""
        key = self.names.reader.key_of(letter)
        slope = self._size(self._at(derivative(height, height.ring.symbol(key)), [*angles_in(height), key]))
        return (slope or 0) * sign > 0

    def _is_doubted(self, outcome: Outcome, told: str) -> bool:
        kind = next((each for each in (AXIS_DOWN, RISES, FALLS, AT_ZERO) if told.startswith(each)), None)
        if kind is None:
            return False
        which = told.removeprefix(kind).strip()
        if kind == AXIS_DOWN:
            of_formulas = self.names.arm is None or self.names.is_of_formulas
            return of_formulas and which in self._coordinates(outcome)
        if kind == AT_ZERO:
            joints = self._other_at_zero(which)
            return bool(joints) and not joints.isdisjoint(self._written(outcome)) and bool(self._coordinates(outcome))
        key = self.names.reader.key_of(which)
        letter = self.names.known_symbol(key) or key
        if letter not in self._written(outcome):
            return False
        return not self._turns_so(letter, -1 if kind == FALLS else 1)

    def _coordinates(self, outcome: Outcome) -> set[str]:
        """Return which coordinates an equation is written with: all, of a matrix."""
        below = [each for node in outcome.nodes for each in n.walk(node)]
        if any(isinstance(each, n.Matrix) for each in below):
            return {*COMPONENTS}
        return {axis for each in below if isinstance(each, n.Name) for axis in _axes_of(each)}

    def _written(self, outcome: Outcome) -> set[str]:
        """Return the symbols that an equation is written with."""
        sides = (outcome.pair.true, outcome.pair.printed) if outcome.pair is not None else ()
        symbols = symbols_in(cell for side in sides for cell in side.cells if isinstance(cell, Scalar))
        keys = {each.undotted.key for node in outcome.nodes for each in n.names(node)}
        sums = [each for node in outcome.nodes for each in n.walk(node) if isinstance(each, n.JointAngles)]  # of c_{12}
        angles = [self.checker.members.evaluate(each).value for each in sums]
        of_angles = symbols_in([each for each in angles if isinstance(each, Scalar)])
        known = {self.names.known_symbol(key) for key in keys} - {None}
        return {each.rpartition(" ")[2] for each in symbols} | keys | of_angles | {str(key) for key in known}

    def _turns_so(self, letter: str, sign: int) -> bool:
        """Whether a joint, at 0 and what is behind it, lifts or lowers the tool straight from the horizontal."""
        arm = self.names.arm
        joint = next((each for each in arm.joints if each.symbol == letter), None) if arm is not None else None
        if arm is None or joint is None:
            return False
        behind = [each.symbol for each in arm.joints if each.kind == "revolute" and each.index >= joint.index]
        rows = self.checker.exact.jacobian(arm.frames[-1], arm.frames[0]).rows
        moved = [self._at(row[joint.index - 1], behind) for row in rows[:3]]
        up = 2 if self._is_spatial() else 1
        rise = self._size(moved[up])
        if rise is None or rise * sign <= 0:
            return False
        level = [each for axis, each in enumerate(moved) if axis != up]
        return all(each.is_zero() for each in level) if self._is_spatial() or joint.index == 1 else True

    def _other_at_zero(self, direction: str) -> set[str]:
        """Return the joints that may begin elsewhere, where the arm at zero does not lie in a direction: the first of them, where it lies along another axis."""
        arm = self.names.arm
        if arm is None:
            return {*self.names.joints}
        turning = [each.symbol for each in arm.joints if each.kind == "revolute"]
        whole = self.checker.exact.pose(arm.frames[-1], arm.frames[0])
        point = [self._size(self._at(row[3], turning)) for row in whole.rows[:3]]
        up = 2 if self._is_spatial() else 1
        axis = up if direction in ("up", "down") else [*COMPONENTS].index(direction[-1])
        sign = -1 if direction == "down" or direction.startswith("-") else 1
        beside = [each for k, each in enumerate(point) if k != axis and (k != up or axis == up or up == 1)]
        if None not in point and (point[axis] or 0) * sign > 0 and not any(beside):
            return set()
        return {*turning[:1]} if not self._is_spatial() and [*map(bool, point[:2])].count(True) == 1 else {*turning}

    def _at(self, value: Scalar, zeros: Sequence[str]) -> Scalar:
        return substitute(value, {each: self.checker.exact.ring.rational(0) for each in zeros}).normal()

    def _size(self, value: Scalar) -> float | None:
        """Return a length at lengths of 1, None where something moves it."""
        ones = {each: self.checker.exact.ring.rational(1) for each in symbols_in([value])}
        found = substitute(value, ones).normal().as_fraction()
        return None if found is None else float(found)

    def _is_spatial(self) -> bool:
        """Whether the arm moves its tool out of the plane x, y by turning."""
        arm = self.names.arm
        assert arm is not None
        rows = self.checker.exact.jacobian(arm.frames[-1], arm.frames[0]).rows
        turning = [each.index - 1 for each in arm.joints if each.kind == "revolute"]
        return any(not rows[2][column].is_zero() for column in turning)


def _axes_of(name: n.Name) -> Iterator[str]:
    """Yield which coordinate a name is, by its letter or its index: x, y_e, p_x; all of a point."""
    if name.base.lower() in COMPONENTS:
        yield name.base.lower()
    elif name.base in "pP":
        found = [axis for axis in COMPONENTS if axis in name.sub]
        yield from found or COMPONENTS
