"""What follows from a definition alone does not show that its formula is right; what it says of the arm does."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

HEAD = "---\narm: planar_2r\n---\n\n"
TIP = r"$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12} $$"
ALONE = (  # a sentence, what it defines, what follows from that alone
    ("The projection of the outer bar on the horizontal is", r"\kappa = l_2 c_2", r"\kappa / l_2 = c_2"),
    ("The lever of the tool's weight is", r"\Lambda = l_1 s_1 + l_2 s_{12}", r"l_2 s_{12} = \Lambda - l_1 s_1"),
    ("La pente de la droite de la base à l'outil est", r"\nu = \frac{x}{y}", r"\nu \, y - x = 0"),
    ("The height of the elbow is", r"\eta = l_1 c_1", r"\dot\eta = -l_1 s_1 \dot\theta_1"),
    ("The trace is", r"\Xi = l_2 c_{12} - l_1 s_1", r"\Xi + l_1 s_1 = l_2 c_{12}"),
)
OF_ARM = (  # what says something of the arm with it
    ("The projection of the outer bar on the horizontal is", r"\kappa = l_2 c_{12}", r"x = l_1 c_1 + \kappa"),
    ("The reach of the arm is", r"\rho_0 = \sqrt{x^2 + y^2}", r"\rho_0^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2"),
    ("With the abbreviation", r"\Xi = l_1 + l_2 c_2", r"x = \Xi c_1 - l_2 s_1 s_2"),
)  # fmt: skip


def verdicts(sentence: str, defined: str, used: str) -> list[Verdict]:
    text = f"{HEAD}{TIP}\n\n{sentence}\n\n$$ {defined} $$\n\nand so\n\n$$ {used} $$\n"
    return [record.verdict for record in verify_text(text).equations[-2:]]


@pytest.mark.parametrize(("sentence", "defined", "used"), ALONE)
def test_what_follows_from_a_definition_alone_shows_nothing(sentence: str, defined: str, used: str) -> None:
    assert verdicts(sentence, defined, used) == [Verdict.UNCHECKED, Verdict.UNCHECKED]


@pytest.mark.parametrize(("sentence", "defined", "used"), OF_ARM)
def test_what_says_something_of_the_arm_shows_it(sentence: str, defined: str, used: str) -> None:
    assert verdicts(sentence, defined, used) == [Verdict.DEFINED, Verdict.PROVED]


def test_a_chain_of_definitions_is_not_shown_by_itself() -> None:
    text = rf"""{HEAD}The height of the elbow is $$ \eta = l_1 c_1 $$ and that of the tool is $$ \chi = \eta + l_2 c_{{12}} $$ so that

$$ \chi - l_2 c_{{12}} = l_1 c_1 $$
"""
    assert {record.verdict for record in verify_text(text).equations} == {Verdict.UNCHECKED}
