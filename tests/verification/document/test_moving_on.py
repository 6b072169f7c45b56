"""Of what a text says that an arm is no longer where it was: it has moved, or grown."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import parse_document
from armproof.verification.document.moving_on import MOVED, MOVED_BEHIND, RESIZED, said_of_motion

HEARD = [
    ("The elbow now turns by a quarter turn.", [MOVED]),
    ("Then both angles change their signs, and we get", [MOVED]),
    ("L'épaule tourne d'un demi-tour.", [MOVED]),
    ("In the mirrored configuration", [MOVED]),
    ("Deux secondes plus tard :", [MOVED]),
    ("The elbow is bent by $\\Delta\\theta_2 = 10^\\circ$ and moves on.", [MOVED]),
    ("Let $\\theta_1 = 0$. Then the arm swings back.", [MOVED_BEHIND]),
    ("Both links are twice as long.", [MOVED, RESIZED]),
    ("En doublant toutes les longueurs :", [MOVED, RESIZED]),
    ("The first motor turns with $\\dot\\theta_1 = 1$.", []),
    ("It turns out that the arm is singular.", []),
    ("At these angles of the joints the Jacobian is", []),
    ("How fast does the arm move?", []),
    ("Both links have the length 1.", []),
]


@pytest.mark.parametrize(("text", "said"), HEARD)
def test_what_moves_the_arm_is_heard(text: str, said: list[str]) -> None:
    assert [*said_of_motion(text)] == said


@pytest.mark.parametrize(
    ("between", "inherits"), [("\n", True), ("\n(b)\n\n", True), ("\nand\n\n", True), ("\nHence\n\n", False)]
)
def test_what_a_sentence_leads_to_goes_on_up_to_the_next_words(between: str, inherits: bool) -> None:
    text = f"The velocity of the elbow is\n\n$$ a = 1 $$\n{between}$$ b = 2 $$\n"
    assert [each.of_other_point for each in parse_document(Path("x.md"), text).displays] == [True, inherits]


def test_which_quantity_a_sentence_names_is_said_of_the_first_display_alone() -> None:
    first, second = parse_document(
        Path("x.md"), "The transpose of the Jacobian is\n\n$$ a = 1 $$\n\n$$ b = 2 $$\n"
    ).displays
    assert first.meant and not second.meant
