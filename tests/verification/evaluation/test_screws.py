"""Exponentials of twists: each solves its differential equation, and what a document prints of them is proved or refuted."""

from __future__ import annotations

from fractions import Fraction

import pytest

from armproof.verification.algebra.calculus import derivative, substitute
from armproof.verification.algebra.matrix import Matrix, inverse_pose, is_zero
from armproof.verification.algebra.ring import Ring
from armproof.verification.check import verify_text
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.screws import Twist, twist_in

AXES = [((0, 0, 1), (0, 0, 0)), ((0, -1, 0), (0, 0, -2)), ((1, 0, 0), (3, -2, 1)), ((0, 0, 0), (0, 1, 0))]
UNIT = (Fraction(2, 7), Fraction(3, 7), Fraction(6, 7))


def twist_of(algebra: ExactAlgebra, omega: tuple[Fraction | int, ...], v: tuple[Fraction | int, ...]) -> Twist:
    return Twist(*(tuple(algebra.rational(Fraction(each)) for each in part) for part in (omega, v)))


@pytest.mark.parametrize(("omega", "v"), [*AXES, (UNIT, (1, 2, 3))], ids=str)
def test_an_exponential_solves_its_differential_equation(omega, v):
    algebra = ExactAlgebra(Ring(), None)
    theta, twist = algebra.symbol("theta_1"), twist_of(algebra, omega, v)
    motion = twist.motion(algebra, theta)
    rate = motion.map(lambda cell: derivative(cell, theta))
    at_zero = motion.map(lambda cell: substitute(cell, {"theta_1": algebra.rational(Fraction(0))}))
    assert is_zero(rate + -(twist.matrix(algebra) @ motion))
    assert is_zero(at_zero @ motion + -motion)
    assert twist_in(rate @ inverse_pose(motion)) == twist or is_zero(
        rate @ inverse_pose(motion) + -twist.matrix(algebra)
    )


def test_an_axis_of_another_length_has_no_such_exponential():
    algebra = ExactAlgebra(Ring(), None)
    assert twist_of(algebra, (0, 0, 2), (0, 0, 0)).motion(algebra, algebra.symbol("theta_1")) is None


def test_the_inverse_of_a_motion_takes_it_back():
    algebra = ExactAlgebra(Ring(), None)
    motion = twist_of(algebra, UNIT, (1, 2, 3)).motion(algebra, algebra.symbol("theta_1"))
    unit = Matrix(tuple(tuple(algebra.rational(Fraction(int(r == c))) for c in range(4)) for r in range(4)))
    assert is_zero(inverse_pose(motion) @ motion + -unit)


HEAD = (
    r"$$ M = \begin{bmatrix} 1 & 0 & 0 & L_1 + L_2 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n"
)
SCREWS = r"$$ \mathcal{S}_1 = (0, 0, 1, 0, 0, 0), \quad \mathcal{S}_2 = (0, 0, 1, 0, %s, 0) $$" "\n"
PRODUCT = r"$$ T(\theta) = e^{[\mathcal{S}_1]\theta_1} e^{[\mathcal{S}_2]\theta_2} M $$" "\n"
POSE = r"$$ T(\theta) = \begin{bmatrix} c_{12} & -s_{12} & 0 & %s \\ s_{12} & c_{12} & 0 & L_1 s_1 + L_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"


@pytest.mark.parametrize(
    ("screw", "x", "verdict"),
    [
        ("-L_1", "L_1 c_1 + L_2 c_{12}", "proved"),
        ("-L_1", "L_1 c_1 - L_2 c_{12}", "refuted"),
        ("-L_1", "L_1 c_1 + L_2 c_2", "refuted"),
        ("L_1", "L_1 c_1 + L_2 c_{12}", "unchecked"),  # the slip is in the twist, and the pose that of another one
    ],
)
def test_a_pose_is_that_of_the_twists_given(screw, x, verdict):
    result = verify_text(HEAD + SCREWS % screw + PRODUCT + POSE % x)
    assert result.equations[-1].verdict.value == verdict
    assert "refuted" not in [record.verdict.value for record in result.equations[:-1]]


COLUMN = r"$$ \xi_2' = \begin{bmatrix} L_1 s_1 & -L_1 %s & 0 & 0 & 0 & 1 \end{bmatrix}^T $$"
SKEW = r"$$ \hat\xi_2 = \begin{bmatrix} 0 & -1 & 0 & 0 \\ 1 & 0 & 0 & %s \\ 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \end{bmatrix} $$"


@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        (COLUMN % "c_1", "proved"),
        (COLUMN % "c_2", "unchecked"),
        (SKEW % "-L_1", "proved"),
        (SKEW % "L_1", "unchecked"),
    ],
)
def test_a_twist_has_its_column_and_its_matrix(display, verdict):
    twists = r"$$ \xi_1 = (0, 0, 0, 0, 0, 1), \quad \xi_2 = (0, -L_1, 0, 0, 0, 1) $$" "\n"
    product = r"$$ g(\theta) = e^{\hat\xi_1\theta_1} e^{\hat\xi_2\theta_2} M $$" "\n"
    assert verify_text(HEAD + twists + product + display).equations[-1].verdict.value == verdict
