"""Which definitions count where a document without an arm says otherwise by several lines."""

from __future__ import annotations

from armproof.verification.check import verify_text

TEXT = r"""# Two angles of a triangle

$$ k_1 = l_1 + l_2\cos\theta_2 $$

$$ k_2 = l_2\sin\theta_2 $$

$$ r = \sqrt{k_1^2 + k_2^2} $$

$$ \gamma = \operatorname{atan2}(k_2, k_1) $$

$$ \sin\gamma = \frac{k_2}{r} $$

$$ \cos\gamma = \frac{k_1}{r} $$

$$ \tan\gamma = \frac{k_2}{k_1} $$

"""
EXCHANGED = TEXT.replace("(k_2, k_1)", "(k_1, k_2)")


def verdicts(text: str, last: str) -> list[str]:
    """Return what becomes of the equations behind the definitions."""
    return [each.verdict.value for each in verify_text(f"{text}$$ {last} $$\n").equations[4:]]


def test_what_holds_with_an_angle_that_more_than_two_lines_contradict_is_left_open():
    assert verdicts(TEXT, r"\cos\gamma = \frac{k_1}{r}") == ["proved"] * 4
    assert verdicts(EXCHANGED, r"\cos\gamma = \frac{k_2}{r}") == ["unchecked"] * 4


def test_what_does_not_hold_with_an_angle_that_all_else_confirms_is_refuted():
    assert verdicts(TEXT, r"\cos\gamma = \frac{k_2}{r}") == ["proved"] * 3 + ["refuted"]
