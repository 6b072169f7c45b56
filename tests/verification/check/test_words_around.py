"""How far words beside a display reach: what takes it back, or is of another place, and what only looks so."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n"
RIGHT, WRONG = "$$ x = l_1 c_1 + l_2 c_{12} $$", "$$ x = l_1 c_1 - l_2 c_{12} $$"


def verdicts_of(*lines: str) -> list[str]:
    return [record.verdict.value for record in verify_text(FRONT + "\n".join(lines) + "\n").equations]


@pytest.mark.parametrize(
    ("heading", "right"),
    [
        ("## Lab 2: the two joints, and three mistakes you will make", "proved"),
        ("## Le modèle direct et les erreurs à éviter", "proved"),
        ("## Das direkte Modell und häufige Fehler", "proved"),
        ("## Common mistakes", "unchecked"),
        ("## A wrong formula, and how it was found", "unchecked"),
        ("## Erreurs fréquentes", "unchecked"),
    ],
)
def test_below_a_heading_of_mistakes_and_of_another_thing_stands_what_is_right(heading: str, right: str) -> None:
    assert verdicts_of(heading, "", RIGHT) == [right]
    assert verdicts_of(heading, "", WRONG) == ["unchecked"]  # it may be one of the mistakes


def test_below_such_a_heading_nothing_is_defined() -> None:
    assert (
        verdicts_of("## Two joints, and mistakes", "", "$$ k = l_1 c_2 $$", "", "$$ k^2 = l_1^2 c_2^2 $$")[0]
        == "unchecked"
    )


@pytest.mark.parametrize(
    "label",
    ["**Mistake 2.** A positive angle", "**Erreur 1 :** Un angle positif", "**Fehler 3.** Ein positiver Winkel"],
)
def test_a_numbered_mistake_is_what_stands_behind_its_label(label: str) -> None:
    assert verdicts_of(RIGHT, "", f"{label} is counted to the wrong side.", "", RIGHT)[0] == "proved"
    assert verdicts_of("**Mistake 1.** Writing the other sign,", "", WRONG, "", "We have", "", RIGHT) == [
        "unchecked",
        "proved",
    ]


@pytest.mark.parametrize(
    "behind",
    [
        "Your code forgot the second angle.",
        "The simulation has a wrong sign there.",
        "A common mistake is to forget the second angle.",
    ],
)
def test_what_finds_fault_with_something_else_leaves_a_right_display(behind: str) -> None:
    assert verdicts_of(RIGHT, "", behind) == ["proved"]
    assert verdicts_of(WRONG, "", behind) == ["unchecked"]


@pytest.mark.parametrize(
    "behind",
    [
        "This line forgot the second angle.",
        "This is a common mistake.",
        "The formula in the code is wrong.",
        "The sign is wrong here.",
    ],
)
def test_what_finds_fault_with_the_display_denies_it(behind: str) -> None:
    assert verdicts_of(RIGHT, "", behind) == ["unchecked"]


@pytest.mark.parametrize(
    ("behind", "verdict"),
    [
        ("provided $l_1 > 0$.", "proved"),
        ("as long as $l_1 > 0$.", "proved"),
        ("pourvu que $l_1 > 0$.", "proved"),
        ("only if $l_1 > l_2$.", "unchecked"),
        ("unless $l_1 > l_2$.", "unchecked"),
    ],
)
def test_what_holds_always_holds_provided_that_something_is_so(behind: str, verdict: str) -> None:
    assert verdicts_of(RIGHT, behind) == [verdict]


@pytest.mark.parametrize(
    ("harmless", "denies"),
    [
        ("The minus in the second row is no slip: the axis points down.", "The minus in the second row is not right."),
        ("It does not contain $\\theta_3$, as it must not.", "It does not hold, as it must not."),
        ("This says nothing about the arm.", "This is nothing that holds."),
        ("Une permutation circulaire des lignes ne le change pas.", "Les lignes sont permutées."),
        ("On the contrary, it holds in every posture.", "It is the contrary that holds."),
        ("It has no term in $d_3$.", "It has no term that is right."),
        ("The last row is never interesting.", "The last row is never right."),
        ("The first factor has nothing to do with singularities.", "The first factor has nothing right in it."),
        ("We will not need the other entries.", "We must change the other entries."),
        ("It is a mistake to divide by it near the boundary.", "It is a mistake to write this."),
        ("Students tend to forget the base rotation.", "Students who forget the sine write this."),
        ("Your program forgot the base rotation.", "Your program forgot it, and so does this formula."),
        ("Nobody will need the other rows of the table.", "Do not use this formula."),
    ],
)
def test_what_denies_nothing_is_no_denial(harmless: str, denies: str) -> None:
    assert verdicts_of(RIGHT, "", harmless) == ["proved"]
    assert verdicts_of(RIGHT, "", denies) == ["unchecked"]


@pytest.mark.parametrize(
    ("harmless", "denies"),
    [
        ("Most textbooks print the same formula:", "Most textbooks print, wrongly,"),
        ("Notice that the height does not show up:", "Notice that we do not have"),
        (
            "Unlike the one of last week, this arm has no vertical slide:",
            "Unlike the one of last week, it is not so that",
        ),
        ("You will not need more than the addition theorems to see that", "You will not be able to claim that"),
        ("On n'oubliera pas que l'angle du coude est relatif :", "On n'écrira pas que"),
        ("Il ne reste plus qu'à projeter :", "Il n'est plus vrai que"),
        ("Personne ne s'étonnera de trouver", "Personne ne devrait écrire"),
    ],
)
def test_what_leads_to_a_display_denies_it_or_not(harmless: str, denies: str) -> None:
    assert verdicts_of(harmless, "", RIGHT) == ["proved"]
    assert verdicts_of(denies, "", RIGHT) == ["unchecked"]


def test_rows_that_the_text_lists_by_their_rates_are_those_of_the_jacobian() -> None:
    told = "The rows of the Jacobian are $(\\omega_z, \\dot x, \\dot y)$:"
    rows = ["1 & 1", "-l_1 s_1 - l_2 s_{12} & -l_2 s_{12}", "l_1 c_1 + l_2 c_{12} & l_2 c_{12}"]
    turned = [rows[0], rows[2], rows[1]]
    spoiled = [rows[0], rows[1].replace("-l_1", "l_1"), rows[2]]
    matrix = "$$ J = \\begin{{bmatrix}} {} \\end{{bmatrix}} $$"
    found = [verdicts_of(told, "", matrix.format(" \\\\ ".join(each))) for each in (rows, turned, spoiled)]
    assert found == [["proved"], ["refuted"], ["refuted"]]


def test_the_order_of_the_joints_is_of_their_vector_and_of_no_joint_alone() -> None:
    told = "The joint vector is $q = (\\theta_2, \\theta_1)$, in this order."
    jacobian = "$$ J = \\begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\\\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \\end{bmatrix} $$"
    assert verdicts_of(told, "", "$$ q_1 + q_2 = \\theta_1 + \\theta_2 $$", "", RIGHT)[-1] == "proved"
    assert verdicts_of(told, "", jacobian) == ["unchecked"]


PLANAR_3R = """---
arm:
  dh: classic
  rows:
    - {a: 0, alpha: pi/2, d: d_1, theta: theta_1}
    - {a: a_2, alpha: 0, d: 0, theta: theta_2}
    - {a: a_3, alpha: 0, d: 0, theta: theta_3}
---
"""


@pytest.mark.parametrize(
    ("lead", "display", "verdict"),
    [
        ("## Position du centre du poignet", "x = c_1 (a_2 c_2 + a_3 c_{23})", "proved"),
        ("## Position of the wrist centre", "x = s_1 (a_2 c_2 + a_3 c_{23})", "unchecked"),
        ("## Position du centre du bras", "x = c_1 (a_2 c_2 + a_3 c_{23})", "unchecked"),
        ("The shoulder offset gives the equation", "-s_1 x + c_1 y = 0", "proved"),
        ("The shoulder is offset by $e$ from the column.", "-s_1 x + c_1 y = 0", "unchecked"),
        ("The elbow:", "\\cos\\theta_3 = \\frac{x^2 + y^2 + (z - d_1)^2 - a_2^2 - a_3^2}{2 a_2 a_3}", "proved"),
        ("The elbow:", "z = d_1 + a_2 s_2 + a_3 s_{23}", "unchecked"),
        ("The tool frame turns with the forearm.", "x = c_1 (a_2 c_2 + a_3 c_{23})", "proved"),
        (
            "The components are given in the frame that turns with the forearm.",
            "x = c_1 (a_2 c_2 + a_3 c_{23})",
            "unchecked",
        ),
    ],
)
def test_where_words_are_of_another_place_and_where_of_the_tool(lead: str, display: str, verdict: str) -> None:
    (record,) = verify_text(f"{PLANAR_3R}{lead}\n\n$$ {display} $$\n").equations
    assert record.verdict.value == verdict


def test_what_a_letter_is_in_a_section_changes_it_where_it_stood_above_that() -> None:
    told = "The first bar has the length $l_1$. In this section $l_1$ is the length of the first link."
    assert verdicts_of("## A", "", told, "", RIGHT) == ["proved"]
    assert verdicts_of("## A", "", RIGHT, "", "## B", "", told, "", RIGHT) == ["proved", "unchecked"]


@pytest.mark.parametrize(
    "asked",
    [
        "Determine all $\\theta_2$ with",
        "Trouvez les configurations telles que",
        "Bestimme alle Stellungen mit",
        "Sketch the postures for which",
        "The configuration is such that",
        "We look for angles that satisfy",
        "Which postures fulfil",
    ],
)
def test_what_is_sought_is_a_condition_and_no_claim(asked: str) -> None:
    assert verdicts_of(asked, "", "$$ \\det J = -l_1 l_2 $$") == ["unchecked"]


@pytest.mark.parametrize(
    "said", ["Determine the Jacobian; its determinant is", "We find the determinant, with two angles:"]
)
def test_what_is_found_is_a_claim(said: str) -> None:
    assert verdicts_of(said, "", "$$ \\det J = -l_1 l_2 $$") == ["refuted"]


def test_a_law_by_which_a_joint_is_to_move_claims_nothing_and_one_of_velocities_does() -> None:
    slip = "$$ \\omega_z = \\dot\\theta_1 - \\dot\\theta_2 $$"
    assert verdicts_of("We choose the law", "", "$$ \\dot\\theta_2 = -\\theta_2 $$", "", "and", "", slip) == [
        "unchecked",
        "refuted",
    ]
