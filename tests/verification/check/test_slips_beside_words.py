"""A slip is refuted whatever the text says of where a joint stands, or of singularities; one in a printed column may be in the column."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

POLAR = r"""# Polar manipulator

Consider the planar robot with one revolute joint $\theta$ at the origin and one prismatic joint that moves the tool along the link, so that its distance from the origin is $r$.

The position of the tool is

$$ x = r\cos\theta, \qquad y = r\sin\theta $$

In matrix form

$$ \begin{bmatrix} \dot x \\ \dot y \end{bmatrix} = \begin{bmatrix} -r\sin\theta & \cos\theta \\ r\cos\theta & %s\sin\theta \end{bmatrix} \begin{bmatrix} \dot\theta \\ \dot r \end{bmatrix} $$

The determinant of this Jacobian is

$$ \det J = -r $$

so the only singularity is at $r = 0$.
"""


def test_a_joint_at_the_origin_is_no_posture_of_the_arm() -> None:
    for sign, verdicts in (("", ["proved"] * 3), ("-", ["proved", "refuted", "proved"])):
        assert [each.verdict.value for each in verify_text(POLAR % sign).equations] == verdicts


TOLD = r"""Consider the planar arm with two revolute joints and links of length $l_1$ and $l_2$.

$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12} $$

%s

$$ \dot x = -l_1 s_1 \dot\theta_1 %s l_2 s_{12} (\dot\theta_1 + \dot\theta_2) $$
"""


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("The base of the arm, a joint, is at the origin.", "refuted"),
        ("The joint $\\theta_1$ is fixed at the origin.", "refuted"),
        ("With the tip at the origin,", "unchecked"),
    ],
)
def test_what_is_at_the_origin_tells_whether_it_is_a_posture(words: str, verdict: str) -> None:
    assert verify_text(TOLD % (words, "-")).equations[1].verdict.value == "proved"
    assert verify_text(TOLD % (words, "+")).equations[1].verdict.value == verdict


TOLD_ARM = r"It has two links of length $L_1$ and $L_2$. The shoulder angle $\alpha$ is measured from the horizontal and the elbow angle $\beta$ from the extension of the upper arm."
HAND = r"""A robot arm moves in a vertical plane. %s

The hand is at

$$ \begin{pmatrix} x_h \\ y_h \end{pmatrix} = \begin{pmatrix} L_1\cos\alpha + L_2\cos(\alpha+\beta) \\ L_1\sin\alpha + L_2\sin(\alpha%s\beta) \end{pmatrix} $$

The velocity of the hand is

$$ \dot x_h = -L_1\dot\alpha\sin\alpha - L_2(\dot\alpha+\dot\beta)\sin(\alpha+\beta) $$

$$ \dot y_h = L_1\dot\alpha\cos\alpha + L_2(\dot\alpha+\dot\beta)\cos(\alpha+\beta) $$
"""


def test_a_line_is_not_refuted_by_a_column_that_may_hold_the_slip_itself() -> None:
    right, wrong = ([each.verdict.value for each in verify_text(HAND % ("", sign)).equations] for sign in "+-")
    assert right[1:] == ["proved", "proved"]
    assert wrong[2] == "unchecked" and wrong[0] != "defined"


def test_with_the_arm_in_words_the_column_is_refuted_and_the_lines_are_proved() -> None:
    found = verify_text(HAND % (TOLD_ARM, "-")).equations
    assert [each.verdict.value for each in found] == ["refuted", "proved", "proved"]
