"""A slip in one definition that lines of several kinds show: it is refuted, and they are decided by what is meant."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

HEAD = r"""# A bent forearm

An upper arm of length $a$ at the angle $\phi$, a forearm at the angle $\psi$, which goes on at a right angle.

$$ \xi = c\cos\psi + b\sin\psi $$

$$ \eta = c\sin\psi - b\cos\psi $$

$$ x = a\cos\phi + \xi $$

"""
ORDINATE, SLIPPED = r"y = a\sin\phi + \eta", r"y = a\sin\phi - \eta"
DISTANCE = r"x^2 + y^2 = a^2 + c^2 + b^2 + 2 a c\cos(\psi - \phi) + 2 a b\sin(\psi - \phi)"
WRONG_DISTANCE = DISTANCE.replace("- \\phi", "+ \\phi")  # as it would be with the slip
TURNED = r"y\cos\psi - x\sin\psi = a\sin(\phi - \psi) - b"
RATE, WRONG_RATE = (rf"\dot y = a\cos\phi\,\dot\phi {sign} \xi\,\dot\psi" for sign in "+-")
ACCELERATION = r"\ddot y = a\cos\phi\,\ddot\phi - a\sin\phi\,\dot\phi^2 + \xi\,\ddot\psi - \eta\,\dot\psi^2"
WRONG_ACCELERATION = r"\ddot y = a\cos\phi\,\ddot\phi - a\sin\phi\,\dot\phi^2 - \xi\,\ddot\psi + \eta\,\dot\psi^2"


def verdicts(*displays: str) -> list[str]:
    """Return what becomes of the displays behind the first three."""
    text = HEAD + "".join(f"$$ {each} $$\n\n" for each in displays)
    return [each.verdict.value for each in verify_text(text).equations[3:]]


def test_a_slip_that_a_position_and_a_velocity_show_is_refuted_and_they_are_proved():
    assert verdicts(ORDINATE, TURNED, DISTANCE, RATE, ACCELERATION) == ["defined", *["proved"] * 4]
    assert verdicts(SLIPPED, TURNED, DISTANCE, RATE, ACCELERATION) == ["refuted", *["proved"] * 4]


def test_what_is_meant_is_told():
    text = HEAD + "".join(f"$$ {each} $$\n\n" for each in (SLIPPED, TURNED, RATE))
    (slip,) = verify_text(text).equations[3].entries
    assert (slip.printed, slip.correct) == (r"a \sin\phi - \eta", r"a \sin\phi + \eta")


def test_a_line_that_is_wrong_with_what_is_meant_is_refuted():
    wrong = DISTANCE.replace("+ c^2", "- c^2")
    assert verdicts(SLIPPED, TURNED, wrong, RATE) == ["refuted", "proved", "refuted", "proved"]


@pytest.mark.parametrize("displays", [(SLIPPED, TURNED), (SLIPPED, DISTANCE), (SLIPPED, RATE, ACCELERATION)])
def test_one_line_alone_or_one_and_its_derivative_refute_no_definition(displays: tuple[str, ...]):
    assert verdicts(*displays) == ["unchecked"] * len(displays)


@pytest.mark.parametrize(
    "displays",
    [
        (SLIPPED, TURNED, WRONG_RATE),  # the slip is carried on
        (ORDINATE, WRONG_DISTANCE, WRONG_RATE),  # it was made behind what is right
        (ORDINATE, WRONG_RATE, WRONG_ACCELERATION),
        (ORDINATE, WRONG_DISTANCE),
    ],
)
def test_a_slip_that_is_carried_through_decides_nothing(displays: tuple[str, ...]):
    assert verdicts(*displays) == ["unchecked"] * len(displays)


def test_what_holds_only_as_it_is_printed_clears_a_definition():
    assert verdicts(ORDINATE, TURNED, WRONG_DISTANCE, WRONG_RATE) == ["unchecked", "proved", "unchecked", "unchecked"]
