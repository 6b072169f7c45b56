"""What the text between displays says of letters: a meaning that serves until a display gives another."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n"


def verdicts_of(*lines: str) -> list[str]:
    return [record.verdict.value for record in verify_text(FRONT + "\n".join(lines) + "\n").equations]


@pytest.mark.parametrize(
    ("said", "display", "verdict"),
    [
        ("with $k = l_1 c_1$", "x = k + l_2 c_{12}", "proved"),
        ("with $k = l_1 c_1$", "x = k - l_2 c_{12}", "refuted"),
        (r"with $\gamma = \theta_1$", r"x = l_1 \cos\gamma + l_2 c_{12}", "proved"),
        (r"with $\gamma = \theta_1$", r"x = l_1 \sin\gamma + l_2 c_{12}", "refuted"),
        (r"with $\gamma = \theta_2$", r"x = l_1 \cos\gamma + l_2 c_{12}", "refuted"),  # another joint is a slip
        ("with $k = l_1 c_1$", "x = k^2 l_2 - s_1", "unchecked"),  # no slip: the text may mean something else
        ("with $k$ of the figure", "x = k + l_2 c_{12}", "unchecked"),
        ("with $k = 2$", "x = k + l_2 c_{12}", "unchecked"),  # a number of the text is that of one case
        ("with $l_1 = l_2 c_1$", "x = l_1 c_1 + l_2 c_{12}", "proved"),  # l_1 has a meaning
        ("with $R = l_1 c_1$", "x = R + l_2 c_{12}", "proved"),  # no rotation
        ("with $R = l_1 c_1$", "x = R - l_2 c_{12}", "refuted"),
        ("with $v = l_1 c_1$", "x = v + l_2 c_{12}", "unchecked"),  # v is usually a velocity
    ],
)
def test_a_letter_of_the_text_has_its_meaning(said: str, display: str, verdict: str) -> None:
    assert verdicts_of(f"{said}", f"$$ {display} $$")[-1] == verdict


@pytest.mark.parametrize(("printed", "verdict"), [("l_2 c_{12}", "proved"), ("l_1 c_1 + l_2 c_{12}", "unchecked")])
def test_who_has_another_name_for_a_coordinate_means_something_else_by_the_usual_one(
    printed: str, verdict: str
) -> None:
    lines = ["$$ p_x = l_1 c_1 + l_2 c_{12} $$", "with $x = p_x - l_1 c_1$", f"$$ x = {printed} $$"]
    assert verdicts_of(*lines) == ["proved", verdict]


def test_a_display_gives_a_letter_of_the_text_another_meaning() -> None:
    lines = ["with $k = l_1 c_1$", "$$ k = l_1 s_1 $$", "$$ y = k + l_2 s_{12} $$", "$$ x = k + l_2 c_{12} $$"]
    assert verdicts_of(*lines) == ["defined", "proved", "unchecked"]  # the text has the last one right


@pytest.mark.parametrize(("sign", "verdict"), [("+", "proved"), ("-", "refuted")])
def test_the_text_behind_displays_tells_their_letters(sign: str, verdict: str) -> None:
    lines = ["$$ x = \\rho c_1 - \\sigma s_1 $$", "", f"$$ y = \\rho s_1 {sign} \\sigma c_1 $$", "", "where $\\rho = l_1 + l_2 c_2$ and $\\sigma = l_2 s_2$."]  # fmt: skip
    assert verdicts_of(*lines) == ["proved", verdict]


def test_what_stands_under_another_heading_tells_nothing_of_the_displays_above() -> None:
    lines = ["$$ x = \\rho c_1 $$", "## Next", "where $\\rho = l_1 + l_2 c_{12}$", "$$ p_1 = \\rho $$"]
    assert verdicts_of(*lines)[0] == "unchecked"


def test_a_letter_that_the_display_gives_a_meaning_has_that() -> None:
    lines = ["$$ \\rho = l_1 s_1 \\\\ y = \\rho + l_2 s_{12} $$", "where $\\rho = l_1 c_1$"]
    assert verdicts_of(*lines) == ["proved"]


LENGTHS = "The links measure $l_1 = 0.5$ m and $l_2 = 0.3$ m."
AT = "For $\\theta_1 = 30^\\circ$ and $\\theta_2 = 60^\\circ$:"
P_2 = "$$ p_2 = \\begin{{bmatrix}} {} \\\\ {} \\\\ 0 \\end{{bmatrix}} $$"
RIGHT = P_2.format("0.433", "0.55")


@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        (RIGHT, "confirmed"),
        ("$$ x = 0.433, \\quad y = 0.55 $$", "confirmed"),
        ("$$ \\det J \\approx 0.13 $$", "confirmed"),
        (P_2.format("0.433", "0.65"), "refuted"),  # one of two is right: they are of this configuration
        (P_2.format("0.733", "0.65"), "unchecked"),  # they may be of another one
        (P_2.format("0.5", "0.65"), "unchecked"),  # 0.5 is rounded too coarsely to tell
        ("$$ \\det J = 0.23 $$", "refuted"),  # the sentence leads to it, and no unit makes 0.23 of 0.13
        ("$$ \\det J = 130 $$", "unchecked"),  # in another unit, perhaps
    ],
)
def test_numbers_are_those_of_the_values_that_the_text_before_gives(display: str, verdict: str) -> None:
    assert verdicts_of(LENGTHS, "", AT, "", display) == [verdict]


@pytest.mark.parametrize(
    ("between", "verdict"),
    [
        ("and once more", "confirmed"),
        ("For $\\theta_1 = 0$ and $\\theta_2 = 60^\\circ$:", "unchecked"),
        ("For $\\theta_1 = 30^\\circ$:", "unchecked"),  # nobody knows what θ_2 is now
        ("# Next", "unchecked"),
        ("Now $l_2 = 0.4$.", "unchecked"),
        ("$$ l_2 = 0.4 $$", "unchecked"),  # a display goes before the text
    ],
)
def test_the_values_of_the_text_hold_until_others_are_given(between: str, verdict: str) -> None:
    assert verdicts_of(LENGTHS, "", AT, "", RIGHT, "", between, "", RIGHT)[-1] == verdict


@pytest.mark.parametrize(
    "said",
    [
        "for $\\theta_1=30°$, $\\theta_2=60°$ and $l_1 = 0.5$ m, $l_2 = 0.3$ m, we get",
        "for $\\theta_1 = 30^{\\circ}$, $\\theta_2 = \\pi/3$ rad, $l_1 = 0.5\\,\\text{m}$ and $l_2 = 0.3\\,\\mathrm{m}$:",
        "with $l_1 = .5$ m, $l_2=0.3$m and $\\theta = (30°, 60°)$",
        "$(\\theta_1, \\theta_2) = (30°, 60°)$ with $l_1 = 0.5$, $l_2 = 0.3$ gives",
        "at $q = [\\pi/6, \\pi/3]^T$ with $l_1 = 0.5$ and $l_2 = 0.3$",
        "for $θ_1 = 30 °$ and $θ_2 = +60°$, $l_1 = 0.5$ m, $l_2 = 0.3$ m",
    ],
)
def test_signs_and_units_may_stand_in_the_formulas_of_the_text(said: str) -> None:
    assert verdicts_of(said, "", RIGHT) == ["confirmed"]
    assert verdicts_of(said, "", P_2.format("0.433", "-0.55")) == ["refuted"]
    assert verdicts_of(said, "", P_2.format("0.343", "0.65")) == ["unchecked"]


def test_only_numbers_right_behind_the_values_are_refuted() -> None:
    wrong = P_2.format("0.433", "-0.55")
    assert verdicts_of(LENGTHS, "", AT, "", RIGHT, "", "With the other elbow", "", wrong) == ["confirmed", "unchecked"]


def test_a_number_is_corrected_to_as_many_decimals_behind_the_same_mark() -> None:
    text = "\n".join([FRONT, LENGTHS, "", AT, "", P_2.format("0{,}433", "0{,}650"), ""])
    (entry,) = verify_text(text).equations[0].entries
    assert (entry.row, entry.correct) == (2, "0{,}550")


def test_a_premise_is_not_a_number_of_the_text() -> None:
    lines = ["Stretched out, at $\\theta_2 = 0$:", "$$ \\sin\\theta_2 = 0 \\Rightarrow \\det J = 0 $$"]
    assert verdicts_of(*lines) == ["proved"]
    assert verdicts_of(lines[0], lines[1].replace("sin", "cos")) == ["refuted"]


@pytest.mark.parametrize(
    ("said", "display", "verdict"),
    [
        ("For $\\sin\\theta_2 < 0$ we have", "\\sqrt{1 - c_2^2} = -s_2", "confirmed"),  # a bound tells the sign
        ("For $\\sin\\theta_2 > 0$ we have", "\\sqrt{1 - c_2^2} = -s_2", "unchecked"),
        ("For $\\sin\\theta_2$ we have", "\\sqrt{1 - c_2^2} = -s_2", "refuted"),
        ("For $\\theta_1 > 0$ we have", "x = l_1 c_1 - l_2 c_{12}", "refuted"),  # a bound mends no formula
        ("When $\\sin\\theta_2 = 0$,", "x = (l_1 - l_2) c_1", "unchecked"),  # one of the two postures in which it is 0
        ("When $\\sin\\theta_2 = 0$,", "x = (l_1 + 2 l_2) c_1", "refuted"),
    ],
)  # fmt: skip
def test_a_bound_or_a_condition_in_the_text_tells_where_an_equation_may_hold(
    said: str, display: str, verdict: str
) -> None:
    assert verdicts_of(said, "", f"$$ {display} $$")[-1] == verdict


@pytest.mark.parametrize(
    ("said", "display", "verdict"),
    [
        ("For a **revolute joint**:", "\\begin{bmatrix} z_{i-1} \\times (p_n - p_{i-1}) \\\\ z_{i-1} \\end{bmatrix}", "proved"),
        ("For a prismatic joint", "\\begin{bmatrix} z_{i-1} \\\\ 0 \\end{bmatrix}", "proved"),
        ("For a revolute joint", "\\begin{bmatrix} z_{i-1} \\\\ 0 \\end{bmatrix}", "unchecked"),
        ("For revolute and prismatic joints", "\\begin{bmatrix} z_{i-1} \\\\ 0 \\end{bmatrix}", "unchecked"),
        ("For a joint", "\\begin{bmatrix} z_{i-1} \\\\ 0 \\end{bmatrix}", "unchecked"),
    ],
)  # fmt: skip
def test_the_text_tells_of_which_joints_a_law_is(said: str, display: str, verdict: str) -> None:
    rows = "[{a: a_1, alpha: 0, d: 0, theta: theta_1}, {a: a_2, alpha: 0, d: 0, theta: theta_2}, {a: 0, alpha: 0, d: d_3, theta: 0}]"
    text = f"---\narm: {{dh: classic, rows: {rows}}}\n---\n{said}\n\n$$ J_i = {display} $$\n"
    assert [record.verdict.value for record in verify_text(text).equations] == [verdict]


@pytest.mark.parametrize(
    ("said", "display", "verdict"),
    [
        ("At the singular configuration,", "\\det J = -l_1 l_2 s_2", "unchecked"),  # there it is so
        ("At the singular configuration,", "\\det J = l_1 l_2 (1 + s_2)", "refuted"),  # at no quarter turn
        ("With the elbow at $90^\\circ$,", "x^2 + y^2 = l_1^2 + l_2^2 - 2 l_1 l_2 c_2", "unchecked"),
        ("Quand le coude fait un angle droit,", "x^2 + y^2 = l_1^2 + l_2^2", "unchecked"),
        ("With joint axes at right angles to the plane,", "x^2 + y^2 = l_1^2 + l_2^2 - 2 l_1 l_2 c_2", "refuted"),
        ("With the first link along the $x$ axis,", "x = l_1 c_1 + l_2 c_2", "unchecked"),
        ("With the first link along the $x$ axis,", "x = l_1 c_1 + l_2 c_2 + l_1", "refuted"),
        ("The position is", "x = l_1 c_1 + l_2 c_2", "refuted"),
        ("The determinant vanishes when the arm is stretched:", "\\det J = -l_1 l_2 s_2", "refuted"),
        ("When the arm is stretched, the determinant vanishes:", "\\det J = -l_1 l_2 s_2", "unchecked"),
    ],
)  # fmt: skip
def test_what_holds_at_quarter_turns_may_be_meant_of_a_posture_in_words(said: str, display: str, verdict: str) -> None:
    assert verdicts_of(said, "", f"$$ {display} $$") == [verdict]


ELBOW = "$\\theta_2 = 0$ or $\\theta_2 = \\pi$"


@pytest.mark.parametrize("said", [f"{{}}\n\nThe arm is singular for {ELBOW}.", f"The arm is singular for {ELBOW}.\n\n{{}}"])  # fmt: skip
@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        ("x = l_1 c_1 + l_2 c_{12}", "proved"),
        ("x = l_1 c_1 + l_2 s_{12}", "refuted"),  # holds in neither posture
        ("x = l_1 c_1 + l_2 c_1", "unchecked"),  # holds where the arm is stretched
        ("x = l_1 c_1 - l_2 c_1", "unchecked"),  # holds where it is folded
    ],
)
def test_two_values_of_a_joint_are_two_postures(said: str, display: str, verdict: str) -> None:
    assert verdicts_of(said.format(f"$$ {display} $$")) == [verdict]


@pytest.mark.parametrize("said", ["The arm is stretched.\n\n{}", "{}\n\nThe arm is stretched."])
@pytest.mark.parametrize(
    ("display", "verdict"),
    [("(l_1 + l_2) c_1 \\\\ (l_1 + l_2) s_1", "proved"), ("(l_1 + l_2) c_1 \\\\ (l_1 - l_2) s_1", "refuted")],
)
def test_what_says_itself_where_it_holds_needs_no_words_for_it(said: str, display: str, verdict: str) -> None:
    there = f"$$ \\left. p_2 \\right|_{{\\theta_2 = 0}} = \\begin{{bmatrix}} {display} \\\\ 0 \\end{{bmatrix}} $$"
    assert verdicts_of(said.format(there)) == [verdict]


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        (r"Let $\mu = \theta_1$ and $\nu = \theta_1 + \theta_2$, the absolute angles of both links.", "proved"),
        (r"Let $\nu = \theta_1 + \theta_2$, the angle of the second link to the horizontal.", "proved"),
        (r"Let $\mu = \theta_1$ and $\nu = \theta_2$, the absolute angles of both links.", "unchecked"),
        (r"Let $\mu = \theta_2$ and $\nu = \theta_1 + \theta_2$, the absolute angles of both links.", "unchecked"),
        (r"Let $\nu = \theta_1 + \theta_2$, the angles being absolute angles.", "unchecked"),
        (r"With $\nu = \theta_1 + \theta_2$, the angle of link 2 being $\theta_2$ to the horizontal.", "unchecked"),
    ],
)
def test_what_stands_beside_a_sum_of_angles_is_said_of_that_sum(said: str, verdict: str) -> None:
    assert verdicts_of(said, "", r"$$ x = l_1 c_1 + l_2 c_{12} $$") == [verdict]


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("Joint and segment angles are also referred to as relative and absolute angles, respectively.", "proved"),
        ("Joint angles are called relative angles, and segment angles are called absolute angles.", "proved"),
        ("Segment and joint angles are also referred to as relative and absolute angles, respectively.", "unchecked"),
        ("The angles are given as absolute angles.", "unchecked"),
    ],
)
def test_joint_angles_beside_absolute_ones_are_relative(said: str, verdict: str) -> None:
    assert verdicts_of(said, "", r"$$ x = l_1 c_1 + l_2 c_{12} $$") == [verdict]
