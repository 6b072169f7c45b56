"""Several arms in a document: a second table, or a first link matrix that differs in another section, begins a part of its own."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.findings import Kind
from tests.verification.tables.arms.test_inference import (
    CLASSIC,
    CRAIG,
    FIRST,
    PLAIN,
    SECOND,
    WHOLE,
    link,
    pose,
    verdicts,
    whole,
)

SLIDE = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | 0 | 0 | $q_1$ | 0 |\n| 2 | 0 | 0 | $q_2$ | 0 |\n\n"
OF_SLIDE = (
    r"$$ {}^0T_2 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & q_1 + q_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    + "\n\n"
)
OF_CRAIG = CRAIG + pose(WHOLE, "c_{12}", "s_{12}", "l_1 + l_2 c_1", "l_2 s_1")


@pytest.mark.parametrize("heading", ["## Exercise 2\n\n", ""], ids=["in its section", "at its place"])
def test_each_table_has_its_own_arm_and_names(heading: str) -> None:
    first, second = "## Exercise 1\n\n" + PLAIN + "\n" + CLASSIC, heading + SLIDE + OF_SLIDE
    result = verify_text(first + second)
    assert [arm.source for arm in result.arms] == ["table", "table"] and set(verdicts(result)) == {"proved"}
    assert [record.arm_index for record in result.equations] == [0, 0, 0, 1]
    wrong = verify_text(first + second.replace("q_1 + q_2", "q_1 - q_2"))
    assert verdicts(wrong)[:3] == ["proved"] * 3 and verdicts(wrong)[3] != "proved"


def test_what_holds_of_another_arm_of_the_document_is_not_refuted_by_that_of_its_part() -> None:
    """Who goes back to the first arm says nothing wrong; what holds of neither is."""
    begun = "## Exercise 1\n\n" + PLAIN + "\n" + CLASSIC + "## Exercise 2\n\n" + SLIDE + OF_SLIDE
    back = verify_text(begun + whole())
    assert verdicts(back) == ["proved"] * 4 + ["unchecked"] and back.equations[-1].says(Kind.HOLDS_OF_OTHER_ARM)
    assert verdicts(verify_text(begun + whole(y="l_1 s_1 - l_2 s_{12}")))[-1] == "refuted"


def test_the_same_table_once_more_is_the_same_arm() -> None:
    result = verify_text(
        "# A\n\n" + PLAIN + "\n" + link(1, FIRST) + "# B\n\n" + PLAIN + "\n" + link(2, SECOND) + whole()
    )
    assert len(result.arms) == 1 and verdicts(result) == ["proved"] * 3


def test_a_table_of_numbers_beside_one_of_letters_is_no_other_arm() -> None:
    numbers = PLAIN.replace("$l_1$", "0.3").replace("$l_2$", "0.2")
    result = verify_text("# A\n\n" + PLAIN + "\n# B\n\n" + numbers + "\n" + CLASSIC)
    assert [arm.line for arm in result.arms] == [3] and verdicts(result) == ["proved"] * 3


def test_other_link_matrices_under_another_heading_are_another_arm() -> None:
    result = verify_text("# A\n\n" + CLASSIC + "# B\n\n" + OF_CRAIG)
    assert [arm.convention for arm in result.arms] == ["classic", "modified"] and verdicts(result) == ["proved"] * 6
    wrong = verify_text("# A\n\n" + CLASSIC + "# B\n\n" + OF_CRAIG.replace("l_2 s_1", "l_2 c_1"))
    assert verdicts(wrong) == ["proved"] * 3 + ["defined"] * 2 + ["refuted"]


def test_a_first_link_matrix_begins_a_part_behind_later_ones_of_another_arm() -> None:
    two = link(2, SECOND).replace("l_", "b_") + link(3, "{}^2T_3").replace("l_", "b_")
    result = verify_text("# A\n\n" + two + "# B\n\n" + CLASSIC)
    assert [arm.line for arm in result.arms][-1:] == [9] and verdicts(result)[2:] == ["proved"] * 3
    wrong = verify_text("# A\n\n" + two + "# B\n\n" + CLASSIC.replace("l_1 s_1 + l_2 s_{12}", "l_1 s_1 - l_2 s_{12}"))
    assert verdicts(wrong)[-1] == "refuted"
    same = verify_text("# A\n\n" + link(2, SECOND) + "# B\n\n" + CLASSIC)
    assert len(same.arms) == 1 and verdicts(same) == ["proved"] * 4


SCARA = "| i | theta | d | a | alpha |\n|---|---|---|---|---|\n| 1 | $\\theta_1$ | 0 | $l_1$ | 0 |\n| 2 | $\\theta_2$ | 0 | $l_2$ | 180 |\n| 3 | 0 | $d_3$ | 0 | 0 |\n\n"
PLANE = r"$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12} $$" + "\n\n"


def test_the_coordinates_in_the_plane_of_a_scara_are_of_the_table_behind_them() -> None:
    rest = (
        "## Table\n\n"
        + SCARA
        + "## Velocity\n\n"
        + r"$$ \dot x = -(l_1 s_1 + l_2 s_{12}) \dot\theta_1 - l_2 s_{12} \dot\theta_2, \quad z = -d_3 $$"
    )
    result = verify_text("## Forward\n\n" + PLANE + rest)
    assert [arm.source for arm in result.arms] == ["table"] and verdicts(result) == ["proved"] * 2
    wrong = verify_text("## Forward\n\n" + PLANE.replace("l_2 s_{12}", "l_2 c_{12}") + rest)
    assert verdicts(wrong) == ["refuted", "proved"]
    other = SCARA.replace("| 0 | $d_3$ | 0 | 0 |", "| $\\theta_3$ | 0 | $l_3$ | 0 |")  # a third link is of another arm
    assert (
        len(verify_text("## Forward\n\n" + PLANE + "## Table\n\n" + other).arms) != 1
        or verdicts(verify_text("## Forward\n\n" + PLANE + "## Table\n\n" + other))[0] != "refuted"
    )


def test_headings_of_html_part_a_document_as_others_do() -> None:
    result = verify_text("<h2>A</h2>\n\n" + CLASSIC + "<h2 id='b'><b>B</b></h2>\n\n" + OF_CRAIG)
    assert [arm.convention for arm in result.arms] == ["classic", "modified"] and verdicts(result) == ["proved"] * 6
    wrong = verify_text("<h2>A</h2>\n\n" + CLASSIC + "<h2>B</h2>\n\n" + OF_CRAIG.replace("l_2 s_1", "l_2 c_1"))
    assert verdicts(wrong)[-1] == "refuted"


@pytest.mark.parametrize(
    ("angle", "verdict"), [(r"\theta_3", "unchecked"), (r"\theta3", "unchecked"), (r"\theta_2", "refuted")]
)
def test_a_heading_of_the_same_words_elsewhere_is_another_section(angle: str, verdict: str) -> None:
    pythagoras = rf"$$ \cos({angle})^2 + \sin({angle})^2 = 1 $$"
    wrong = whole(y="l_1 s_1 - l_2 s_{12}")
    page = f"# Arms\n\n## One\n\n### Solution\n\n{CLASSIC}## Solution\n\n{pythagoras}\n\n{wrong}"
    assert verdicts(verify_text(page))[-1] == verdict


def test_link_matrices_of_another_exercise_are_not_refuted_by_the_table_of_the_first() -> None:
    result = verify_text("# A\n\n" + PLAIN + "\n" + CLASSIC + "# B\n\n" + OF_CRAIG)
    assert [arm.source for arm in result.arms] == ["table", "matrices"] and verdicts(result) == ["proved"] * 6


def test_the_arm_of_one_exercise_refutes_nothing_in_the_next() -> None:
    wrong = whole(y="l_1 s_1 - l_2 s_{12}")
    for heading, verdict in (("## Problem 2", "unchecked"), ("## The tool", "refuted")):
        result = verify_text(f"## Problem 1\n\n{PLAIN}\n{CLASSIC}{heading}\n\n{wrong}")
        assert verdicts(result) == ["proved"] * 3 + [verdict]
    assert verdicts(verify_text(f"{PLAIN}\n{CLASSIC}## Problem 2\n\n{wrong}"))[-1] == "refuted"  # that of all of them


def test_other_letters_than_those_of_the_joints_refute_nothing_until_they_are_told() -> None:
    links = CLASSIC.replace("c_", r"\cos q_").replace("s_", r"\sin q_").replace("q_{12}", "(q_1 + q_2)")
    right = r"$$ x = l_1 \cos %s_1 + l_2 \cos(%s_1 + %s_2) $$"
    wrong = right.replace("+ l_2", "- l_2")
    for letter, verdict in ((r"\theta", "unchecked"), ("q", "refuted")):
        said = [text % (letter, letter, letter) for text in (right, wrong)]
        assert [verdicts(verify_text(links + text))[-1] for text in said] == ["proved", verdict]


TEX_TABLE = r"""\begin{tabular}{ccccc} $i$ & $a$ & $\alpha$ & $d$ & $\theta$ \\ 1 & $l_1$ & 0 & 0 & $\theta_1$ \\ 2 & $l_2$ & 0 & 0 & $\theta_2$ \\ \end{tabular}
"""
TEX_POSE = r"""\[ T^0_2 = \begin{bmatrix} c_{12} & -s_{12} & 0 & l_1 c_1 + l_2 c_{12} \\ s_{12} & c_{12} & 0 & l_1 s_1 + l_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \]
"""
OTHER = r"\[ R^1_2 = \begin{bmatrix} 1 & 0 & 0 \\ 0 & c_2 & -s_2 \\ 0 & s_2 & c_2 \end{bmatrix} \]" + "\n"


def tex(*exercises: str, name: str = "homeworkProblem") -> list[str]:
    """Return the verdicts of a LaTeX document of exercises, each in an environment of the author's own."""
    parts = (f"\\begin{{{name}}}[{k}]\n{each}\\end{{{name}}}\n" for k, each in enumerate(exercises, 1))
    text = "\\documentclass{article}\\begin{document}\n" + "".join(parts) + "\\end{document}\n"
    return [record.verdict.value for record in verify_text(text, path="page.tex").equations]


@pytest.mark.parametrize("name", ["homeworkProblem", "exercise", "Aufgabe", "question*"])
def test_exercises_in_environments_are_told_apart(name: str) -> None:
    shown = r"\subsection{Solution for (a)}" + "\n" + TEX_TABLE + TEX_POSE
    assert tex(OTHER, shown, name=name) == ["unchecked", "proved"]
    assert tex(shown, OTHER, name=name) == ["proved", "unchecked"]
    assert tex(shown + r"\subsection{Solution for (b)}" + "\n" + OTHER, name=name) == ["proved", "refuted"]


def test_an_exercise_about_the_robot_of_another_goes_on_with_its_arm() -> None:
    first = "Find the table.\n" + TEX_TABLE + TEX_POSE
    for words, verdict in (
        ("Find the Jacobian of the manipulator in Question 1. ", "refuted"),
        ("Find that of the robot arm\nof Problem 1.", "refuted"),
        ("Find the Jacobian of the manipulator in the figure. ", "unchecked"),
        ("Find the Jacobian of the manipulator of Exercise 7. ", "unchecked"),
        ("Read Question 1. A manipulator is drawn. ", "unchecked"),
    ):
        assert tex(first, words + OTHER) == ["proved", verdict]


def test_points_in_the_option_of_an_exercise_are_not_its_number() -> None:
    """Two exercises of ten points are two."""
    first, other = ("\\begin{problem}[10 points]\n%s\\end{problem}\n" % each for each in (TEX_TABLE + TEX_POSE, OTHER))
    told = verify_text("\\begin{document}" + first + other + "\\end{document}", path="page.tex").equations
    assert [record.verdict.value for record in told] == ["proved", "unchecked"]


def test_an_environment_that_is_no_exercise_parts_nothing() -> None:
    assert tex(TEX_TABLE + TEX_POSE, OTHER, name="itemize") == ["proved", "refuted"]


SCARA_IN_STAGES = r"""## Direct geometry

$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1 + \theta_2), \quad y = l_1 \sin\theta_1 + l_2 \sin(\theta_1 + \theta_2) $$

{beside}

## Inverse geometry

$$ x^2 + y^2 = l_1^2 + l_2^2 {sign} 2 l_1 l_2 \cos\theta_2 $$

$$ \theta_4 = \psi - \theta_1 - \theta_2 $$
"""


def test_a_joint_that_stands_beside_a_closed_form_ends_it_nowhere() -> None:
    beside = r"$$ \psi = \theta_1 + \theta_2 + \theta_4 $$"
    found = [verify_text(SCARA_IN_STAGES.format(beside=beside, sign=sign)).equations for sign in "+-"]
    assert [records[2].verdict.value for records in found] == ["proved", "refuted"]
    alone = [verify_text(SCARA_IN_STAGES.format(beside="", sign=sign)).equations for sign in "+-"]
    assert alone[1][1].verdict.value == "unchecked"  # of another arm, it may be


def test_a_closed_form_that_takes_too_long_to_be_an_arm_costs_no_other_display_its_verdict() -> None:
    reach = r"\ell_2 \cos\alpha + \ell_3 \sin(\alpha+\beta) - (\ell_4+\ell_5)\cos(\alpha+\beta+\gamma)"
    tangent = r"\frac{l_1 + l_2 (\sin\alpha - \cos(\alpha + \beta)) - z}{l_2 (\cos\alpha + \sin(\alpha + \beta)) - \frac{y}{\sin\theta}}"
    large = (
        f"## Position\n\n$$ x = \\cos\\theta ({reach}) $$\n\n$$ y = \\sin\\theta ({reach}) $$\n\n"
        r"$$ z = \ell_1 + \ell_2 \sin\alpha - \ell_3 \cos(\alpha+\beta) - (\ell_4+\ell_5)\sin(\alpha+\beta+\gamma) $$"
        f"\n\n$$ \\gamma = \\tan^{{-1}} ({tangent}) - \\alpha - \\beta $$\n"
    )
    result = verify_text("## Exercise 1\n\n$$ \\cos^2 a + \\sin^2 a = 1 $$\n\n" + large)
    assert verdicts(result)[0] == "proved" and len(result.equations) == 5


SLIDING = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | 0 | 0 | 0 | $\\theta_1$ |\n| 2 | 0 | $\\pi/2$ | $d_2$ | 0 |\n\n"
OF_SLIDING = (
    r"$$ {}^0T_2 = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    + "\n\n"
)


def test_link_matrices_whose_joint_slides_in_the_table_of_another_exercise_are_of_another_arm() -> None:
    others = "# B\n\n" + link(1, FIRST) + link(2, SECOND) + whole()
    result = verify_text("# A\n\n" + SLIDING + OF_SLIDING + others)
    assert [arm.source for arm in result.arms] == ["table", "matrices"]
    assert verdicts(result) == ["proved"] * 4
    third = "# C\n\n" + PLAIN.replace("l_", "b_") + "\n" + CLASSIC.replace("l_", "b_")
    assert [arm.source for arm in verify_text("# A\n\n" + SLIDING + OF_SLIDING + others + third).arms] == [
        "table",
        "matrices",
        "table",
    ]
    wrong = verify_text("# A\n\n" + SLIDING + OF_SLIDING.replace("d_2", "-d_2") + others)
    assert verdicts(wrong)[0] != "proved" and verdicts(wrong)[1:] == ["proved"] * 3
