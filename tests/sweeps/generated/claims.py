"""Random claims about a random arm, half of them with one slip; whether one is true, the plant and the evaluator say."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from random import Random

import numpy as np

from tests.labelled.evaluator import evaluate
from tests.sweeps.generated.arms import RandomArm
from tests.sweeps.generated.polynomials import (
    Polynomial,
    PolynomialMatrix,
    add,
    atom,
    count_terms,
    derivative,
    times,
    to_latex,
)

MOST_TERMS = 40
Meaning = Callable[[np.ndarray, np.ndarray], np.ndarray]  # joint values, rates → the value of the left side


@dataclass(frozen=True)
class Claim:
    """A display, its role, whether it is true, and the displays that stand before it."""

    latex: str
    role: str
    true: bool
    before: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sides:
    """What stands on both sides: names of the arm with their meaning, and a formula for it."""

    role: str
    left: str
    meaning: Meaning
    value: PolynomialMatrix
    write: Callable[[str], str] = "{}".format  # the display of a formula
    before: tuple[str, ...] = ()
    at: Callable[[np.ndarray], np.ndarray] = np.asarray  # the configurations that are meant


class Claims:
    """Draws claims about one arm; `quantities` is what the front matter must bind for them."""

    def __init__(self, arm: RandomArm, rng: Random) -> None:
        self.arm = arm
        self.rng = rng
        self.n = len(arm.joints)
        self.notation = rng.choice(["c_", "C_", "cos", "cos()", "c{}"])
        self.matrix = rng.choice(["bmatrix", "pmatrix"])
        self.points = [np.array([rng.uniform(-1.4, 1.4) for _ in arm.joints]) for _ in range(3)]
        self.rates = [np.array([rng.uniform(-1, 1) for _ in arm.joints]) for _ in range(3)]

    @property
    def front(self) -> str:
        """The front matter with the names that the claims use."""
        parts = {f"P_{x}": f"{{origin: {self.n}, component: {x}}}" for x in "xyz"} | {"J_b": f"{{jacobian: {self.n}}}"}
        return self.arm.front + "quantities:\n" + "".join(f"  {name}: {spec}\n" for name, spec in parts.items())

    def draw(self, count: int) -> Iterator[Claim]:
        """Yield so many claims, each of them true or with one slip."""
        kinds = [self.pose, self.rotation, self.origin, self.axis, self.component, self.rate, self.partial, self.column,
                 self.chain, self.used, self.convention, self.inverse, self.carried, self.implied]  # fmt: skip
        made = 0
        for attempt in range(20 * count):
            sides = self.rng.choice(kinds)(attempt)
            if sides is None or not 0 < count_terms(sides.value) <= MOST_TERMS:
                continue
            yield self.finish(sides)
            made += 1
            if made == count:
                return

    def finish(self, sides: Sides) -> Claim:
        """Make a slip in every second claim and ask the plant which are true."""
        value = self.slip(sides.value) if self.rng.random() < 0.5 else sides.value
        formula = self.print(value)
        true = all(
            np.allclose(evaluate(formula, self.arm.truth.values(q, v)), sides.meaning(q, v), atol=1e-9)
            for q, v in zip(map(sides.at, self.points), self.rates, strict=True)
        )
        number = all(not any(cell) for row in value for cell in row) and len(value) == 1
        return Claim(sides.write(formula), "number" if number else sides.role, true, sides.before)

    # -- printing ---------------------------------------------------------------------------------------------------------

    def print(self, value: PolynomialMatrix) -> str:
        """Print a scalar or a matrix."""
        if len(value) == len(value[0]) == 1:
            return to_latex(value[0][0], self.spell)
        rows = r" \\ ".join(" & ".join(to_latex(cell, self.spell) for cell in row) for row in value)
        return rf"\begin{{{self.matrix}}} {rows} \end{{{self.matrix}}}"

    def spell(self, factor: str) -> str:
        """Write one factor in the document's notation."""
        if factor[0] not in "cs" or not factor[1:].isdigit():
            return rf"\{factor}" if factor.startswith(("theta", "dot")) and "_" in factor else factor
        function, index = {"c": "cos", "s": "sin"}[factor[0]], factor[1:]
        angle = self.arm.joints[int(index) - 1]
        angle = rf"\{angle}" if angle.startswith("theta") else angle
        spelt = {"c_": f"{factor[0]}_{index}", "C_": f"{factor[0].upper()}_{index}", "c{}": f"{factor[0]}_{{{index}}}"}
        return spelt.get(self.notation) or (
            rf"\{function}({angle})" if self.notation == "cos()" else rf"\{function} {angle}"
        )

    def slip(self, value: PolynomialMatrix) -> PolynomialMatrix:
        """Return the matrix with one slip in one entry."""
        places = [(r, c) for r, row in enumerate(value) for c, cell in enumerate(row) if cell]
        r, c = self.rng.choice(places)
        changed = [list(row) for row in value]
        changed[r][c] = self.slip_in(changed[r][c])
        return changed

    def slip_in(self, cell: Polynomial) -> Polynomial:
        """Return a polynomial with one slip: a sign, a term, a sine for a cosine, another index."""
        factors = self.rng.choice(sorted(cell))
        coefficient, rest = cell[factors], {key: value for key, value in cell.items() if key != factors}
        kind = self.rng.choice(["sign", "term", "trig", "index", "number"])
        trig = [k for k, factor in enumerate(factors) if factor[0] in "cs" and factor[1:].isdigit()]
        if kind == "term" and rest:
            return rest
        if kind in ("trig", "index") and trig:
            k = self.rng.choice(trig)
            others = [angle for angle in self.arm.angles if angle and angle != factors[k][1:]]
            letter, index = factors[k][0], factors[k][1:]
            new = (
                f"{'s' if letter == 'c' else 'c'}{index}"
                if kind == "trig" or not others
                else letter + self.rng.choice(others)
            )
            return add(rest, {tuple(sorted((*factors[:k], new, *factors[k + 1 :]))): coefficient})
        return add(rest, {factors: coefficient * (2 if kind == "number" else -1)})

    # -- roles ------------------------------------------------------------------------------------------------------------

    def pair(self) -> tuple[int, int]:
        """Return a reference frame and a later frame."""
        first = self.rng.randrange(self.n)
        return first, self.rng.randint(first + 1, min(self.n, first + 3))

    def pose(self, _: int) -> Sides:
        i, j = self.pair()
        name = self.rng.choice([f"{{}}^{i}T_{j}", f"{{}}^{i}_{j}T", f"T^{i}_{j}", f"A^{i}_{j}"])
        return Sides(
            "pose", name, lambda q, v: self.arm.truth.pose(q, str(j), str(i)), self.arm.pose(i, j), _equals(name)
        )

    def rotation(self, _: int) -> Sides:
        i, j = self.pair()
        name = self.rng.choice([f"{{}}^{i}R_{j}", f"R^{i}_{j}", rf"{{}}^{i}\mathbf{{R}}_{j}"])
        value = [row[:3] for row in self.arm.pose(i, j)[:3]]
        return Sides(
            "rotation", name, lambda q, v: self.arm.truth.pose(q, str(j), str(i))[:3, :3], value, _equals(name)
        )

    def origin(self, _: int) -> Sides:
        i, j = self.pair()
        name = self.rng.choice([f"{{}}^{i}p_{j}", f"{{}}^{i}P_{j}"] + ([f"p_{j}"] if i == 0 else []))
        value = [row[3:] for row in self.arm.pose(i, j)[:3]]
        return Sides("origin", name, lambda q, v: self.arm.truth.pose(q, str(j), str(i))[:3, 3:], value, _equals(name))

    def axis(self, _: int) -> Sides:
        i, j = self.pair()
        name = self.rng.choice([f"{{}}^{i}z_{j}"] + ([f"z_{j}"] if i == 0 else []))
        value = [row[2:3] for row in self.arm.pose(i, j)[:3]]
        return Sides("axis", name, lambda q, v: self.arm.truth.pose(q, str(j), str(i))[:3, 2:3], value, _equals(name))

    def tool(self) -> tuple[int, str, Polynomial]:
        k = self.rng.randrange(3)
        return k, f"P_{'xyz'[k]}", self.arm.pose(0, self.n)[k][3]

    def at_tool(self, k: int) -> Meaning:
        return lambda q, v: self.arm.truth.pose(q, str(self.n))[k, 3]

    def component(self, _: int) -> Sides:
        k, name, value = self.tool()
        return Sides("component", name, self.at_tool(k), [[value]], _equals(name))

    def rate(self, _: int) -> Sides:
        k, name, value = self.tool()
        total: Polynomial = {}
        for joint, angle in zip(self.arm.joints, self.arm.angles, strict=True):
            dot = f"dot\\{joint}" if joint.startswith("theta") else f"dot {joint}"
            total = add(total, times(derivative(value, joint, angle), atom(dot)))
        meaning: Meaning = lambda q, v: (self.arm.truth.jacobian(q, str(self.n)) @ v)[k]  # noqa: E731
        return Sides("rate", name, meaning, [[total]], _equals(rf"\dot {name}"))

    def partial(self, _: int) -> Sides:
        k, name, value = self.tool()
        i = self.rng.randrange(self.n)
        joint = self.arm.joints[i]
        by = rf"\{joint}" if joint.startswith("theta") else joint
        left = rf"\frac{{\partial {name}}}{{\partial {by}}}"
        found = derivative(value, joint, self.arm.angles[i])
        return Sides(
            "partial", left, lambda q, v: self.arm.truth.jacobian(q, str(self.n))[k, i], [[found]], _equals(left)
        )

    def column(self, _: int) -> Sides | None:
        if self.n > 3:
            return None
        tool = self.arm.pose(0, self.n)
        pairs = list(zip(self.arm.joints, self.arm.angles, strict=True))
        value = [[derivative(tool[k][3], joint, angle) for joint, angle in pairs] for k in range(3)]
        left = r"\begin{bmatrix} I_3 & 0_{3 \times 3} \end{bmatrix} J_b"
        return Sides("Jacobian", left, lambda q, v: self.arm.truth.jacobian(q, str(self.n))[:3], value, _equals(left))

    def chain(self, _: int) -> Sides | None:
        k, name, value = self.tool()
        if not value or count_terms([[value]]) > MOST_TERMS:
            return None
        true = to_latex(value, self.spell)
        write = self.rng.choice(["{0} = {1} = {2}", "{0} = {2} = {1}"])
        return Sides("chain", name, self.at_tool(k), [[value]], lambda text: write.format(name, true, text))

    def used(self, number: int) -> Sides | None:
        """A letter is defined by some of the terms, and stands for them."""
        k, name, value = self.tool()
        if len(value) < 2:
            return None
        items = list(value.items())
        part, rest = dict(items[:1]), dict(items[1:])
        letter = f"u_{{{number}}}"
        before = (f"{letter} = {to_latex(part, self.spell)}",)
        left = f"{name} - {letter}"
        part_of = to_latex(part, self.spell)

        def meaning(q: np.ndarray, v: np.ndarray) -> np.ndarray:
            return self.at_tool(k)(q, v) - evaluate(part_of, self.arm.truth.values(q, v))

        return Sides("definition used", left, meaning, [[rest]], lambda text: f"{name} = {letter} + ({text})", before)

    def convention(self, _: int) -> Sides:
        k = self.rng.randrange(3)
        letter = "xyz"[k]
        value, meaning = [[self.arm.pose(0, self.n)[k][3]]], self.at_tool(k)
        name = self.rng.choice([f"{letter}_e", f"p_{{{self.n}{letter}}}", f"{letter}_{self.n}", f"p_{letter}"])
        return Sides("convention", name, meaning, value, _equals(name))

    def inverse(self, _: int) -> Sides | None:
        """The inverse of a rotation is its transpose."""
        i, j = self.pair()
        pose = self.arm.pose(i, j)
        value = [[pose[c][r] for c in range(3)] for r in range(3)]
        left = self.rng.choice([f"{{}}^{j}R_{i}", f"({{}}^{i}R_{j})^T", f"({{}}^{i}R_{j})^{{-1}}"])
        return Sides("inverse", left, lambda q, v: self.arm.truth.pose(q, str(i), str(j))[:3, :3], value, _equals(left))

    def carried(self, number: int) -> Sides:
        """Behind an equation stands what could carry it past: a set, a bound, a second equation of unknowns."""
        k, name, value = self.tool()
        tail = self.rng.choice([r" \in \mathbb{R}", r" \qquad \forall q", rf", \quad W_{{{number}}} = F G"])
        return Sides("carried", name, self.at_tool(k), [[value]], lambda text: f"{name} = {text}{tail}")

    def implied(self, _: int) -> Sides | None:
        """At a value of one angle."""
        k, name, value = self.tool()
        indices = [angle for angle in self.arm.angles if angle]
        if not indices:
            return None
        index = self.rng.choice(indices)
        joint = self.arm.joints[int(index) - 1]
        by = rf"\{joint}" if joint.startswith("theta") else joint
        found = _at_zero(value, index)

        def at(q: np.ndarray) -> np.ndarray:
            return np.where(np.arange(self.n) == int(index) - 1, 0.0, q)

        return Sides(
            "implication",
            name,
            self.at_tool(k),
            [[found]],
            lambda text: rf"{by} = 0 \Rightarrow {name} = {text}",
            (),
            at,
        )


def _equals(left: str) -> Callable[[str], str]:
    return lambda text: f"{left} = {text}"


def _at_zero(value: Polynomial, index: str) -> Polynomial:
    total: Polynomial = {}
    for factors, coefficient in value.items():
        if f"s{index}" not in factors:
            rest = tuple(factor for factor in factors if factor != f"c{index}")
            total = add(total, {rest: Fraction(coefficient)})
    return total
