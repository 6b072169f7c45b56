"""Of what a text says that an arm is no longer where it was: it has moved, or grown."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.document import parse_document
from armproof.verification.document.moving_on import MOVED, MOVED_BEHIND, RESIZED, said_of_motion
from armproof.verification.document.subjects import OPERATED
from armproof.verification.verdict import Verdict

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
    ("Both links have the length 1.", [RESIZED]),
    ("Now both links are two metres long.", [RESIZED]),
    (r"Both links measure $50\,\mathrm{cm}$.", [RESIZED]),
    ("Le second segment ne mesure plus que 50 cm.", [RESIZED]),
    ("A smaller sibling of this arm has segments of 30 cm and 20 cm.", [RESIZED]),
    ("The arm of section B has a forearm as long as its upper arm.", [RESIZED]),
    ("Le robot réel est dix fois plus grand que la maquette.", [RESIZED]),
    ("The links have lengths $l_1$ and $l_2$.", []),
    ("The links have the same length, $l_1 = l_2 = 1$.", []),
    ("The robot's workspace is larger.", []),
    ("The arm stands 0.5 m from the wall.", []),
    ("What if the links were 2 m long?", []),
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
    assert [OPERATED in " ".join(each.meant) for each in (first, second)] == [True, False]


SIZES = "Let $l_1 = 1$ m and $l_2 = 0.5$ m.\n\n$$ x = l_1 c_1 + l_2 c_{12}, \\quad y = l_1 s_1 + l_2 s_{12} $$\n\n%s For $\\theta_1 = 0$ and $\\theta_2 = 90^\\circ$ we get\n\n$$ \\det J = %s $$\n"


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("", Verdict.CONFIRMED),
        ("The links turn in one plane.", Verdict.CONFIRMED),
        ("Now both links are two metres long.", Verdict.UNCHECKED),
        ("The large robot has links of twice that size.", Verdict.UNCHECKED),
        ("L'avant-bras ne mesure plus que 20 cm.", Verdict.UNCHECKED),
    ],
)
def test_numbers_behind_are_of_no_lengths_that_stood_before(said: str, verdict: Verdict) -> None:
    assert verify_text(SIZES % (said, "0.5")).equations[-1].verdict is verdict
