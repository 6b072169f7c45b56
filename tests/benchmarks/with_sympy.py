"""The same proofs by sympy.simplify: `python -m tests.benchmarks.with_sympy pose|jacobian|determinant` prints seconds.

What SymPy is given is made ready before the clock starts: the link matrices of the modified convention, and the
printed formulas as SymPy expressions. It multiplies, differentiates and simplifies the differences.
"""

from __future__ import annotations

import subprocess
import sys
import time
from dataclasses import dataclass
from typing import Any

from armproof.verification.algebra.budget import Budget

PARTS = ("pose", "jacobian", "determinant")
TABLE = ((0, 0, 0), (0, 90, 0), ("a_3", 0, 0), (0, -90, "d_3"), (0, 90, 0), (0, -90, 0))  # a, α, d of each row


@dataclass(frozen=True)
class Simplification:
    """How long SymPy took, a lower bound where it was stopped; how many entries it found equal."""

    seconds: float
    stopped: bool
    equal: int
    entries: int


def simplify_in_subprocess(part: str, timeout: float) -> Simplification:
    """Run one part in a process of its own, for at most so many seconds."""
    command = [sys.executable, "-m", "tests.benchmarks.with_sympy", part]
    try:
        done = subprocess.run(command, timeout=timeout, capture_output=True, text=True, check=True)
    except subprocess.TimeoutExpired:
        return Simplification(timeout, True, 0, 0)
    seconds, equal, entries = done.stdout.split()
    return Simplification(float(seconds), False, int(equal), int(entries))


def _main(part: str) -> None:
    import sympy

    from armproof.models.catalogue import load_arm
    from armproof.verification.evaluation.evaluator import Evaluator
    from armproof.verification.naming.reading import read_names
    from tests.benchmarks.rx90 import read_claims, right_sides

    claims = read_claims()
    names = read_names(load_arm("rx90"), claims.document.front)
    algebra: Any = _SympyAlgebra()
    pose, jacobian, determinant = right_sides(claims)
    printed_pose = [Evaluator(names, algebra).evaluate(node) for node in pose]
    for component, value in zip(("P_x", "P_y", "P_z"), printed_pose[9:], strict=True):
        algebra.named[component] = value
    printed_jacobian = sympy.Matrix(Evaluator(names, algebra).evaluate(jacobian).rows)
    printed_determinant = Evaluator(names, algebra).evaluate(determinant)

    started = time.perf_counter()
    poses = _poses()
    if part == "pose":
        whole = poses[-1]
        differences = [
            whole[r, c] - value
            for value, (c, r) in zip(printed_pose, [(c, r) for c in range(4) for r in range(3)], strict=True)
        ]
    else:
        traced = _jacobian(poses)
        differences = list(traced - printed_jacobian) if part == "jacobian" else [traced.det() - printed_determinant]
    equal = sum(sympy.simplify(difference) == 0 for difference in differences)
    print(time.perf_counter() - started, equal, len(differences))


def _poses() -> list[Any]:
    """Return the poses of frames 1 … 6 in frame 0, products of link matrices."""
    import sympy

    poses = [sympy.eye(4)]
    for index, (a, alpha, d) in enumerate(TABLE, 1):
        length, offset = sympy.sympify(a) if not a else sympy.Symbol(a), sympy.sympify(d) if not d else sympy.Symbol(d)
        theta, twist = sympy.Symbol(f"theta_{index}"), sympy.pi * alpha / 180
        c, s, ca, sa = sympy.cos(theta), sympy.sin(theta), sympy.cos(twist), sympy.sin(twist)
        rows = [
            [c, -s, 0, length],
            [s * ca, c * ca, -sa, -offset * sa],
            [s * sa, c * sa, ca, offset * ca],
            [0, 0, 0, 1],
        ]
        poses.append(poses[-1] * sympy.Matrix(rows))
    return poses[1:]


def _jacobian(poses: list[Any]) -> Any:
    """Return the geometric Jacobian [v; ω] of frame 6 in frame 0."""
    import sympy

    origin = poses[-1][:3, 3]
    linear = origin.jacobian([sympy.Symbol(f"theta_{k}") for k in range(1, 7)])
    return sympy.Matrix.vstack(linear, sympy.Matrix.hstack(*(pose[:3, 2] for pose in poses)))


class _SympyAlgebra:
    """Just enough of an algebra for the handout's formulas to become SymPy expressions."""

    def __init__(self) -> None:
        self.named: dict[str, Any] = {}

    budget = Budget()  # as long as it takes: the formulas are read before the clock starts

    def rational(self, value: Any) -> Any:
        import sympy

        return sympy.Rational(value.numerator, value.denominator)

    def symbol(self, name: str) -> Any:
        import sympy

        return sympy.Symbol(name)

    def cos_sin(self, angle: Any) -> tuple[Any, Any]:
        import sympy

        return sympy.cos(angle), sympy.sin(angle)

    def divide_by(self, denominator: Any) -> None:
        """Divide by anything."""


if __name__ == "__main__":
    _main(sys.argv[1])
