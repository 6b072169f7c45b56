"""A coordinate that one display alone says otherwise than it usually is: where all the rest holds as usual, that display has the slip."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

HEAD = r"""# An arm with a waist

$$ x = \cos\theta_1 (l_2\cos\theta_2 + l_3\cos(\theta_2 + \theta_3)) $$

"""
ORDINATE = r"y = \sin\theta_1 (l_2\cos\theta_2 + l_3\cos(\theta_2 + \theta_3))"
SLIPPED = ORDINATE.replace(r"y = \sin", r"y = \cos")
HEIGHT = r"z = l_1 + l_2\sin\theta_2 + l_3\sin(\theta_2 + \theta_3)"
TURNED_HEIGHT = HEIGHT.replace("+ l_2", "- l_2").replace("+ l_3", "- l_3")
FROM_SHOULDER = HEIGHT.replace("l_1 + ", "")
REACH = r"\sqrt{x^2 + y^2} = \sqrt{(l_2\cos\theta_2 + l_3\cos(\theta_2 + \theta_3))^2}"
WAIST = r"x \sin\theta_1 - y \cos\theta_1 = 0"
RATE = r"\dot y = \cos\theta_1 (l_2\cos\theta_2 + l_3\cos(\theta_2 + \theta_3)) \dot\theta_1 - \sin\theta_1 (l_2\sin\theta_2\dot\theta_2 + l_3\sin(\theta_2 + \theta_3)(\dot\theta_2 + \dot\theta_3))"
ELBOW = r"\cos\theta_3 = \frac{x^2 + y^2 + (z - l_1)^2 - l_2^2 - l_3^2}{2 l_2 l_3}"
ELBOW_FROM_SHOULDER = ELBOW.replace("(z - l_1)", "z")


def verdicts(*displays: str) -> list[str]:
    """Return what becomes of the displays behind x."""
    text = HEAD + "".join(f"$$ {each} $$\n\n" for each in displays)
    return [each.verdict.value for each in verify_text(text).equations[1:]]


def test_a_cosine_for_a_sine_in_all_terms_is_refuted_and_the_rest_decided():
    assert "refuted" not in verdicts(ORDINATE, HEIGHT, REACH, WAIST, ELBOW)
    first, *rest = verdicts(SLIPPED, HEIGHT, REACH, WAIST, ELBOW)
    assert first == "refuted" and set(rest) <= {"proved", "confirmed"}


def test_a_slip_of_their_own_in_other_lines_is_found_beside_it():
    wrong = RATE.replace(r"- \sin\theta_1", r"+ \sin\theta_1")
    assert verdicts(SLIPPED, HEIGHT, REACH, WAIST, wrong, ELBOW)[0::4] == ["refuted", "refuted"]


@pytest.mark.parametrize("behind", [[ELBOW_FROM_SHOULDER], [ELBOW_FROM_SHOULDER, ELBOW]])
def test_a_height_that_is_counted_from_elsewhere_is_not_refuted(behind: list[str]):
    assert "refuted" not in verdicts(ORDINATE, FROM_SHOULDER, REACH, *behind)[:2]


def test_what_the_lines_behind_hold_of_as_it_is_said_is_not_refuted():
    own = r"y + x = 2 \cos\theta_1 (l_2\cos\theta_2 + l_3\cos(\theta_2 + \theta_3))"
    assert verdicts(SLIPPED, HEIGHT, own)[0] != "refuted"
