r"""Torques of a document without an arm: what its own point and the force in them make of them."""

from __future__ import annotations

import pytest

from armproof import verify_text

CRANK = r"""
The lever of length $a$ makes the angle $\mu$ with the ground, the rod of length $b$ the angle $\nu$. The tip is at

$$ X = a\cos\mu + b\cos\nu, \qquad Y = a\sin\mu + b\sin\nu $$

{said}

"""
PUSHES = "The tip pushes with the force $(f_x, f_y)$ on the part."
FIRST = r"\tau_\mu = a (f_y\cos\mu - f_x\sin\mu)"


def verdicts_of(*displays: str, said: str = PUSHES) -> list[str]:
    text = CRANK.format(said=said) + "\n\n".join(f"$$ {each} $$" for each in displays) + "\n"
    return [record.verdict.value for record in verify_text(text).equations]


@pytest.mark.parametrize(
    ("second", "verdict"),
    [
        (r"\tau_\nu = b (f_y\cos\nu - f_x\sin\nu)", "proved"),
        (r"\tau_\nu = b (f_y\cos\nu + f_x\sin\nu)", "refuted"),
        (r"\tau_\nu = b (f_x\sin\nu - f_y\cos\nu)", "refuted"),  # of the other sign than the first
        (r"\tau_\nu = b (f_y\cos\nu - f_x\sin\nu) - d \dot\nu", "unchecked"),  # friction
        (r"\tau_\mu = X f_y - Y f_x", "unchecked"),  # about the joint, and not by the angle
        (r"\tau_2 = b (f_y\cos\nu - f_x\sin\nu)", "unchecked"),
    ],
)
def test_a_torque_is_what_the_force_makes_of_the_point(second: str, verdict: str) -> None:
    assert verdicts_of(FIRST, second)[1:] == ["proved", verdict]


def test_a_slip_alone_is_left_open() -> None:
    assert verdicts_of(FIRST.replace("- f_x", "+ f_x"))[-1] == "unchecked"


def test_torques_that_hold_a_force_from_outside_have_the_other_sign() -> None:
    said = "An external force $f = (f_x, f_y)$ acts on the hand. The torques that hold the arm still are:"
    assert "proved" not in verdicts_of(FIRST, said=said)


@pytest.mark.parametrize(("rest", "verdict"), [("+ m", "proved"), ("- m", "unchecked"), ("", "unchecked")])
def test_a_moment_turns_with_the_angle_of_the_tool(rest: str, verdict: str) -> None:
    text = (
        "The tip is at\n\n$$ \\psi = \\theta_1 + \\theta_2 $$\n\n$$ x = a\\cos\\theta_1 + b\\cos\\psi, \\qquad y = a\\sin\\theta_1 + b\\sin\\psi $$\n\n"
        "It exerts $(f_x, f_y)$ and the moment $m$.\n\n"
        f"$$ \\tau_2 = b (f_y\\cos\\psi - f_x\\sin\\psi) {rest} $$\n"
    )
    assert verify_text(text).equations[-1].verdict.value == verdict
