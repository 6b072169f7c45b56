r"""Numbers that the text gives: what they lead to is claimed, and what is written in letters behind them holds for any."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import HOLDS, Verdict

PLANAR = "---\narm: planar_2r\n---\n\n"


def last(text: str) -> Verdict:
    return verify_text(text).equations[-1].verdict


@pytest.mark.parametrize(
    ("example", "law"),
    [
        ("Example: $l_1 = 0.5$, $l_2 = 0.4$, $\\theta_1 = 90^\\circ$, $\\theta_2 = -90^\\circ$. Then", "Inverse kinematics (law of cosines):"),
        ("Exemple : $l_1 = 0.5$, $l_2 = 0.4$, $\\theta_1 = 90^\\circ$, $\\theta_2 = -90^\\circ$. Alors", "Modèle inverse (théorème d'Al-Kashi) :"),
        ("Beispiel: $l_1 = 0.5$, $l_2 = 0.4$, $\\theta_1 = 90^\\circ$, $\\theta_2 = -90^\\circ$. Dann ist", "Rückwärtsrechnung (Kosinussatz):"),
        ("Ejemplo: $l_1 = 0.5$, $l_2 = 0.4$, $\\theta_1 = 90^\\circ$, $\\theta_2 = -90^\\circ$. Entonces", "Cinemática inversa (teorema del coseno):"),
        ("Esempio: $l_1 = 0.5$, $l_2 = 0.4$, $\\theta_1 = 90^\\circ$, $\\theta_2 = -90^\\circ$. Allora", "Cinematica inversa (teorema del coseno):"),
        ("Exemplo: $l_1 = 0.5$, $l_2 = 0.4$, $\\theta_1 = 90^\\circ$, $\\theta_2 = -90^\\circ$. Então", "Cinemática inversa (lei dos cossenos):"),
    ],
)  # fmt: skip
def test_a_law_in_letters_behind_an_example_is_general(example: str, law: str) -> None:
    page = f"{PLANAR}$$ x = l_1 c_1 + l_2 c_{{12}} $$\n\n$$ y = l_1 s_1 + l_2 s_{{12}} $$\n\n{example}\n\n$$ x = 0.4 $$\n\n{law}\n\n$$ \\cos\\theta_2 = \\frac{{x^2 + y^2 - l_1^2 - l_2^2}}{{FACTOR l_1 l_2}} $$\n"
    assert last(page.replace("FACTOR", "2")) is Verdict.PROVED
    assert last(page.replace("FACTOR", "")) is Verdict.REFUTED  # both are 0 there


def test_what_no_longer_holds_a_joint_may_be_meant_there() -> None:
    page = f"{PLANAR}Take $\\theta_2 = 90^\\circ$.\n\n$$ x = l_1 c_1 - l_2 s_1 $$\n\nThe ordinate follows:\n\n$$ y = {{}} $$\n"
    assert last(page.format("l_1 s_1 + l_2 c_1")) is not Verdict.REFUTED
    assert last(page.format("l_1 s_1 - l_2 c_{12}")) is Verdict.REFUTED


@pytest.mark.parametrize(
    "lead",
    [
        "With $l_1 = 1$, $l_2 = 0.8$, $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$:",
        "Pour $l_1 = 1$, $l_2 = 0{,}8$ et $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$ :",
        "Zahlenbeispiel mit $l_1 = 1$, $l_2 = 0.8$ für $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$:",
        "Ejemplo con $l_1 = 1$, $l_2 = 0.8$ para $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$:",
        "Esempio con $l_1 = 1$, $l_2 = 0.8$ per $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$:",
        "Exemplo com $l_1 = 1$, $l_2 = 0.8$ para $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$:",
    ],
)
def test_a_number_to_which_values_of_all_joints_lead_is_claimed(lead: str) -> None:
    page = f"{PLANAR}$$ x = l_1 c_1 + l_2 c_{{12}} $$\n\n$$ y = l_1 s_1 + l_2 s_{{12}} $$\n\n{lead}\n\n$$ x = 0.866 $$\n\n$$ y = HEIGHT $$\n"
    assert last(page.replace("HEIGHT", "1.30")) in HOLDS
    assert last(page.replace("HEIGHT", "1.80")) is Verdict.REFUTED
    assert last(page.replace("HEIGHT", "130")) is not Verdict.REFUTED  # in centimetres


@pytest.mark.parametrize(
    "lead",
    [
        "With $l_1 = 1$, $l_2 = 0.8$ and $\\theta_2 = 60^\\circ$:",
        "From $l_1 = 1$, $l_2 = 0.8$, $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$ the arm moves to",
        "For $l_1 = 1$, $l_2 = 0.8$, $\\theta_1 = 30^\\circ$, $\\theta_2 = 60^\\circ$ the goal is",
        "Pour $l_1 = 1$, $l_2 = 0.8$, $\\theta_1 = 30^\\circ$ et $\\theta_2 = 60^\\circ$, la cible est",
        "Für $l_1 = 1$, $l_2 = 0.8$, $\\theta_1 = 30^\\circ$ und $\\theta_2 = 60^\\circ$ ist das Ziel",
    ],
)
def test_where_the_tool_is_to_be_is_no_claim(lead: str) -> None:
    page = f"{PLANAR}$$ x = l_1 c_1 + l_2 c_{{12}} $$\n\n{lead}\n\n$$ x = 1.25 $$\n"
    assert last(page) is not Verdict.REFUTED


@pytest.mark.parametrize(
    ("leads_on", "is_of_above"),
    [
        ("The singular configuration is", "in the singular configuration."),
        ("La configuration singulière est", "dans la configuration singulière."),
        ("The arm is therefore singular for", "when the arm is stretched."),
    ],
)
def test_a_determinant_is_not_that_of_the_place_to_which_the_text_leads_on(leads_on: str, is_of_above: str) -> None:
    page = f"{PLANAR}$$ \\det J = {{}} $$\n\n{{}}\n\n$$ \\theta_2 = 0 $$\n"
    first = [verify_text(page.format(*each)).equations[0].verdict for each in (("l_1 l_2 s_2", leads_on), ("l_1 l_2 c_2", leads_on), ("l_1 l_2", is_of_above))]  # fmt: skip
    assert first == [Verdict.PROVED, Verdict.REFUTED, Verdict.UNCHECKED]
