r"""Torques that a force at a point asks for, where the document gives the point itself: τ_2 = x f_y - y f_x is F · ∂p/∂θ_2.

The index of a torque names the variable by which the point is derived: τ_α, τ_2 of θ_2, f_ρ of a slide ρ.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from armproof.verification.algebra.calculus import angles_in, derivative, symbols_in
from armproof.verification.algebra.matrix import as_matrix, as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, agree_exactly, is_near
from armproof.verification.equations.forces import TORQUES
from armproof.verification.equations.of_points import ANGLES, ENDS
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import AXES
from armproof.verification.verdict import Role, Verdict

FORCES = ("F", "f")
_COUNTED = ("theta", "q", "phi", "d", "r")  # letters of joints that a number tells


@dataclass(frozen=True)
class TorquesOfPoint:
    """Compares what is said of a torque with what the force in it makes of the document's own point."""

    members: Members

    def judge(self, outcome: Outcome) -> Outcome:
        """Return a claim where a torque is F · ∂p/∂q; what is a slip away is refuted where another torque has shown that they are."""
        name = bare(outcome.printed.node) if outcome.printed is not None else None
        value = as_scalar(outcome.true.value) if outcome.true is not None else None
        is_effort = isinstance(name, n.Name) and name.base in (*TORQUES, *FORCES) and bool(name.sub)
        if not (is_effort and isinstance(value, Scalar) and outcome.defines):
            return outcome
        state = self.members.names.state
        consulted = frozenset(state.consulted)
        pairs = [Pair(as_matrix(each), as_matrix(value), is_scalar=True) for each in self._torques(name, value)]  # type: ignore[arg-type]
        if any(map(agree_exactly, pairs)):
            state.balanced.setdefault((TORQUES[0], state.exercise))
            return replace(outcome, verdict=Verdict.PROVED, findings=(), role=Role.CLAIM)
        judged = self._unless_near(outcome, pairs) if len(pairs) == 1 else outcome
        if judged is outcome:
            state.consulted.intersection_update(consulted)  # it rests on no point
        return judged

    def _unless_near(self, outcome: Outcome, pairs: list[Pair]) -> Outcome:
        state = self.members.names.state
        (pair,) = pairs
        turned = replace(pair, true=pair.true.map(lambda cell: -cell))
        is_said = any((TORQUES[0], exercise) in state.balanced for exercise in (state.exercise, ""))
        if not is_near(pair) and not (agree_exactly(turned) and is_said):
            return outcome
        doubt = say(Kind.NEAR_TORQUE, names=sorted(outcome.defines))
        for name in outcome.defines:
            self.members.names.leave_open(name, doubt)
        if is_said:
            return outcome.as_wrong_claim(pair, [(0, 0)])
        return replace(outcome, verdict=Verdict.UNCHECKED, findings=(doubt,), role=Role.DEFINITION)

    def _torques(self, name: n.Name, value: Scalar) -> Iterator[Scalar]:
        """Yield what the force in a value makes of the point by the variable of a torque; nothing where something else stands in it."""
        components, moments = self._loads(value)
        keys = self._point({axis for _, axis in components})
        point = self._values(keys)
        variable = self._variable(name, [*point.values()])
        if (
            not (components and variable)
            or len(moments) > 1
            or not self._is_of(value, [key for key, _ in components] + moments)
        ):
            return
        exact, by = self.members.exact, value.ring.symbol(variable)
        slopes = {axis: derivative(each, by).normal() for axis, each in point.items()}
        power = [exact.symbol(key) * slopes[axis] for key, axis in components]
        self._rest_on({keys[axis] for axis, each in slopes.items() if not each.is_zero()}, {*keys.values()})
        work = sum(power[1:], power[0])
        for angle in self._angles(point) if moments else [value.ring.zero]:
            yield (work + (exact.symbol(moments[0]) * derivative(angle, by) if moments else angle)).normal()

    def _is_of(self, value: Scalar, loads: list[str]) -> bool:
        """Whether a value is made of loads alone: no gravity, no friction, no other force."""
        rest = value
        for load in map(self.members.exact.symbol, loads):
            rest = rest - derivative(value, load) * load
        return bool(rest.normal().is_zero())

    def _rest_on(self, needed: set[str], asked: set[str]) -> None:
        """Let a torque rest on the coordinates that its variable moves, and on no other one."""
        state = self.members.names.state
        idle = {(key, state.definitions[key].line) for key in asked - needed}
        state.consulted -= idle

    def _loads(self, value: Scalar) -> tuple[list[tuple[str, str]], list[str]]:
        """Return the components of the one force in a value and of it elsewhere, each with its axis, and the moments that act."""
        spelling = self.members.names.reader.spelling
        held = symbols_in([value])
        letters = {base for base, _, axis in (key.partition("_") for key in held) if base in FORCES and axis in [*AXES]}
        if len(letters) != 1:
            return [], []
        (letter,) = letters
        keys = [(f"{letter}_{axis}", axis) for axis in AXES]
        moments = sorted(spelling.moments | {key for key in held | spelling.loads if key in ("M_z", "m_z")})
        return [each for each in keys if each[0] in held | spelling.loads], moments

    def _point(self, axes: set[str]) -> dict[str, str]:
        """Return the names of the tool's coordinates along some axes that the document gives: x and y, or X and Y, of one point."""
        made = self.members.names.state.definitions
        for end in ENDS:
            for letters in (AXES, AXES.upper()):
                keys = {axis: f"{letter}{end}" for axis, letter in zip(AXES, letters, strict=True) if axis in axes}
                if keys and all(key in made for key in keys.values()):
                    return keys
        return {}

    def _values(self, keys: dict[str, str]) -> dict[str, Scalar]:
        found = {axis: value for axis, key in keys.items() if (value := self._value(key)) is not None}
        return found if len(found) == len(keys) else {}

    def _angles(self, point: dict[str, Scalar]) -> list[Scalar]:
        """Return the angles of the tool in its plane that the document gives: sums of those that place it."""
        made = self.members.names.state.definitions
        turning = {angle for each in point.values() for angle in angles_in(each)}
        found = [each for key in ANGLES if key in made and (each := self._value(key)) is not None]
        return [each for each in found if len(symbols_in([each])) > 1 and symbols_in([each]) <= turning]

    def _value(self, key: str) -> Scalar | None:
        try:
            value = as_scalar(self.members.names.defined_value(key, self.members.exact))
        except (EvaluationError, UnboundName):
            return None
        return value if isinstance(value, Scalar) else None

    def _variable(self, name: n.Name, point: list[Scalar]) -> str:
        """Return the variable of a point that the index of a torque names, "" where it names none, or several."""
        held = symbols_in(point) | {angle for each in point for angle in angles_in(each)}
        found = (
            [name.sub]
            if name.sub in held
            else [f"{letter}_{name.sub}" for letter in _COUNTED if f"{letter}_{name.sub}" in held]
        )
        return found[0] if len(found) == 1 else ""
