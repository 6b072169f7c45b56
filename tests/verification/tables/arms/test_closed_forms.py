"""The arm of a closed form: the coordinates of a chain of turns and slides in a plane, or of one that a first joint turns."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from armproof import verify_text
from armproof.verification.errors import TooComplex
from armproof.verification.findings import Kind, say

PLANAR = "$$ x = l_1 c_1 + l_2 c_{12} $$\n\n$$ y = l_1 s_1 + l_2 s_{12} $$\n\n"
TURNED = "$$ x = c_1 (l_2 c_2 + l_3 c_{23}) $$\n\n$$ y = s_1 (l_2 c_2 + l_3 c_{23}) $$\n\n$$ z = l_1 + l_2 s_2 + l_3 s_{23} $$\n\n"
JACOBIAN = (
    r"$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & LAST \end{bmatrix} $$"
    + "\n\n"
)


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


@pytest.mark.parametrize(("text", "joints"), [(PLANAR, 2), (TURNED, 3)])
def test_coordinates_that_pin_an_arm_give_it(text: str, joints: int) -> None:
    (arm,) = verify_text(text).arms
    assert (arm.source, arm.line, arm.convention) == ("closed form", 1, "classic")
    assert arm.front_matter.count("theta: ") == joints


def test_sums_with_known_limits_are_coordinates_written_out() -> None:
    def along(function: str) -> str:
        return rf"\sum_{{k=1}}^{{3}} L_k \{function}\left( \sum_{{i=1}}^{{k}} \theta_i \right)"

    sums = f"$$ x = {along('cos')}, \\quad y = {along('sin')} $$\n\n"
    rate = r"$$ \frac{\partial x}{\partial \theta_2} = -L_2 \sin(\theta_1 + \theta_2) - L_3 \sin(\theta_1 + \theta_2 + \theta_3) $$"
    (arm,) = verify_text(sums + rate).arms
    assert arm.front_matter.count("theta: ") == 3 and verdicts(sums + rate) == ["proved"] * 2
    assert verdicts(sums + rate.replace("- L_3", "+ L_3")) == ["unchecked", "refuted"]


def test_what_the_arm_was_taken_from_is_data_until_something_else_confirms_it() -> None:
    assert set(verdicts(PLANAR)) == {"unchecked"}
    right = PLANAR + JACOBIAN.replace("LAST", "l_2 c_{12}")
    assert verdicts(right) == ["proved"] * 3


def test_a_wrong_entry_is_refuted_where_another_claim_confirms_the_arm() -> None:
    wrong = PLANAR + JACOBIAN.replace("LAST", "l_1 c_{12}") + "$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2 $$"
    result = verify_text(wrong)
    assert result.equations[2].verdict == "refuted"
    (entry,) = result.equations[2].entries
    assert (entry.row, entry.column, entry.correct) == (2, 2, "l_2 c_{12}")


@pytest.mark.parametrize("other", ["l_1 s_1 + l_3 s_{12}", "-l_1 s_1 - l_2 s_{12}"])
def test_coordinates_that_are_not_of_one_arm_give_none(other: str) -> None:
    assert not verify_text(PLANAR.replace("l_1 s_1 + l_2 s_{12}", other)).arms


@pytest.mark.parametrize("other", ["l_1 s_1 + l_2 s_2", "l_1 s_1 - l_2 s_{12}"])
def test_one_coordinate_tells_the_arm_where_the_other_has_a_slip(other: str) -> None:
    wrong = PLANAR.replace("l_1 s_1 + l_2 s_{12}", other)
    alone, confirmed = verify_text(wrong), verify_text(wrong + JACOBIAN.replace("LAST", "l_2 c_{12}"))
    assert [record.verdict for record in alone.equations] == ["unchecked"] * 2
    assert "nothing else that is decided tells which is right" in alone.equations[1].message
    assert [record.verdict for record in confirmed.equations] == ["proved", "refuted", "proved"]


def test_a_coordinate_without_one_link_is_wrong_where_the_jacobian_tells_it() -> None:
    wrong = PLANAR.replace("l_1 s_1 + l_2 s_{12}", "l_1 s_1")
    alone, confirmed = verify_text(wrong), verify_text(wrong + JACOBIAN.replace("LAST", "l_2 c_{12}"))
    assert [record.verdict for record in alone.equations] == ["unchecked"] * 2
    assert [record.verdict for record in confirmed.equations] == ["proved", "refuted", "proved"]
    assert "l_2 s_{12} is missing" in confirmed.equations[1].message


def test_the_points_of_an_elbow_are_no_slips_in_those_of_the_hand() -> None:
    elbow = "$$ x = l_1 c_1 $$\n\n$$ y = l_1 s_1 $$\n\n"
    result = verify_text(PLANAR + JACOBIAN.replace("LAST", "l_2 c_{12}") + elbow)
    assert [record.verdict for record in result.equations] == ["proved"] * 3 + ["unchecked"] * 2


def test_a_turned_arm_needs_its_height() -> None:
    assert not verify_text(TURNED.partition("$$ z")[0]).arms


def test_a_jacobian_shows_the_arm_where_another_display_holds_of_it() -> None:
    printed = JACOBIAN.replace("LAST", "l_2 c_{12}")
    rate = r"$$ \dot x = -l_1 s_1 \dot\theta_1 - l_2 s_{12} (\dot\theta_1 - \dot\theta_2) $$"
    confirmed = verify_text(printed + r"$$ \det J = l_1 l_2 s_2 $$" + "\n\n" + rate)
    assert [arm.source for arm in confirmed.arms] == ["closed form"]
    assert [record.verdict for record in confirmed.equations] == ["proved", "proved", "refuted"]
    assert not verify_text(printed).arms
    assert not verify_text(printed + r"$$ \det J = l_1 l_2 c_2 $$").arms


def test_an_entry_that_is_no_derivative_is_wrong_where_the_determinant_is_that_of_the_arm() -> None:
    turned = JACOBIAN.replace("LAST", "-l_2 c_{12}")
    told = verify_text(turned + r"$$ \det J = l_1 l_2 s_2 $$")
    assert [record.verdict for record in told.equations] == ["refuted", "proved"]
    assert [(entry.row, entry.column) for entry in told.equations[0].entries] == [(2, 2)]
    assert not verify_text(turned).arms
    assert not verify_text(turned + r"$$ \det J = l_1 l_2 c_2 $$").arms


@pytest.mark.parametrize("matrix", [r"l_1 s_2 & 0 \\ l_1 c_2 + l_2 & l_2", r"-l_1 s_1 & -l_2 s_2 \\ l_1 c_1 & l_2 c_2"])
def test_a_jacobian_that_is_no_planar_arms_shows_none(matrix: str) -> None:
    determinant = r"l_1 l_2 s_2" if "s_1" not in matrix else r"l_1 l_2 \sin(\theta_2 - \theta_1)"
    text = rf"$$ J = \begin{{bmatrix}} {matrix} \end{{bmatrix}} $$" + "\n\n" + rf"$$ \det J = {determinant} $$"
    assert not verify_text(text).arms
    given, claimed = (record.verdict for record in verify_text(text).equations)
    assert claimed == "proved" and given in ("defined", "unchecked")  # a determinant does not show every entry


POLAR = r"$$ x = d_2 \cos\theta_1, \quad y = d_2 \sin\theta_1 $$" + "\n\n"
RADIUS = r"$$ x = r \cos\theta, \quad y = r \sin\theta $$" + "\n\n"
RATE = r"$$ \dot x = \dot r \cos\theta - r \sin\theta \dot\theta $$" + "\n\n"


@pytest.mark.parametrize(
    ("text", "joints"),
    [
        (POLAR, "theta_1, d_2"),
        (RADIUS + RATE, "theta, r"),
        (
            (RADIUS + RATE).replace(r"\dot r", r"\dot{r}_a").replace(" r ", " r_a ").replace("= r ", "= r_a "),
            "theta, r_a",
        ),
        (RADIUS, ""),  # a circle
        (POLAR.replace("y = d_2", "y = -d_2"), ""),
        (r"$$ x = d_2 c_1 + l_3 c_{13}, \quad y = d_2 s_1 + l_3 s_{13} $$", "theta_1, d_2, theta_3"),
        (r"$$ x = d_2 c_1 + 2 d_3 c_1, \quad y = d_2 s_1 + 2 d_3 s_1 $$", ""),
        (r"$$ x = q_1 + l_2 \cos q_2, \quad y = l_2 \sin q_2 $$", "q_1, q_2"),
        (r"$$ x = d_3 c_1, \quad y = d_3 s_1, \quad z = h + d_2 $$", "theta_1, d_2, d_3"),
        (r"$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12}, \quad z = h - d_3 $$", "theta_1, theta_2, d_3"),
        (r"$$ x = d_1, \quad y = d_2, \quad z = d_3 $$", "d_1, d_2, d_3"),
        (r"$$ x = d_1, \quad y = d_2, \quad z = h $$", ""),
        (TURNED.replace("l_3", "d_4"), "theta_1, theta_2, theta_3"),  # a length: the Puma's
        (r"$$ x = c_1 q_3 c_2, \quad y = s_1 q_3 c_2, \quad z = l_1 + q_3 s_2 $$", "theta_1, theta_2, q_3"),
        ("$$ x = c_1 + c_{12}, \\quad y = s_1 + s_{12} $$", ""),  # numbers for lengths: an example
    ],
)
def test_a_joint_that_slides_has_a_rate_or_the_number_that_the_angles_leave_out(text: str, joints: str) -> None:
    arms = verify_text(text).arms
    assert [f"joints: [{joints}]" in arm.front_matter for arm in arms] == [True] * bool(joints)


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"\det J = -d_2", "proved"),
        (r"\det J = d_2^2", "refuted"),
        (
            r"R = \begin{bmatrix} 0 & -s_1 & c_1 \\ 0 & c_1 & s_1 \\ 1 & 0 & 0 \end{bmatrix}",
            "unchecked",
        ),  # its own frame
        (r"p_1 = \begin{bmatrix} d_2 c_1 \\ d_2 s_1 \\ 0 \end{bmatrix}", "unchecked"),
    ],
)
def test_coordinates_tell_nothing_of_the_frames(claim: str, verdict: str) -> None:
    columns = r"$$ J = \begin{bmatrix} -d_2 s_1 & c_1 \\ d_2 c_1 & s_1 \end{bmatrix} $$"
    assert verdicts(f"{POLAR}{columns}\n\n$$ {claim} $$")[-1] == verdict


@pytest.mark.parametrize(("numbers", "verdict"), [(("theta", "r"), "unchecked"), (("theta_1", "r_2"), "refuted")])
def test_columns_may_come_in_another_order_where_joints_have_no_numbers(numbers: tuple[str, str], verdict: str) -> None:
    angle, radius = numbers
    text = (
        RADIUS
        + RATE
        + r"$$ J = \begin{bmatrix} c & -r s \\ s & r c \end{bmatrix} $$"
        + "\n\n"
        + r"$$ x^2 + y^2 = r^2 $$"
    )
    for old, new in (
        ("c &", r"\cos\theta &"),
        ("r c", r"r \cos\theta"),
        ("r s", r"r \sin\theta"),
        ("s &", r"\sin\theta &"),
    ):
        text = text.replace(old, new)
    text = text.replace(r"\theta", f"\\{angle}").replace(" r ", f" {radius} ").replace(r"\dot r", rf"\dot {radius}")
    assert verdicts(text.replace("r^2", f"{radius}^2"))[2:] == [verdict, "proved"]


POSE = r"\begin{bmatrix} c_{12} & -s_{12} & 0 & l_1 c_1 + l_2 c_{12} \\ s_{12} & c_{12} & 0 & l_1 s_1 + l_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
COLUMN = r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \end{bmatrix}"


@pytest.mark.parametrize(
    "shown",
    [
        rf"T_2^0(\theta_1, \theta_2) = {POSE} \in SE(3)",
        rf"\begin{{bmatrix}} x \\ y \end{{bmatrix}} = {COLUMN}",
        rf"p(q) = {COLUMN}",
        rf"P_e = {COLUMN}",
    ],
)
def test_a_point_or_a_pose_of_the_tool_shows_its_coordinates(shown: str) -> None:
    jacobian = r"$$ J(q) = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & %sl_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix} $$"
    right = verify_text(f"$$ {shown} $$\n\n{jacobian % '-'}\n")
    assert right.arms[0].source == "closed form" and right.equations[-1].verdict == "proved"
    assert verify_text(f"$$ {shown} $$\n\n{jacobian % ''}\n").equations[-1].verdict != "proved"


def test_a_row_of_another_pair_of_letters_shows_no_tool() -> None:
    assert verify_text(f"$$ [u; v] = {COLUMN} $$ \n\n$$ T_1^0 = {POSE} $$").arms == ()


def test_a_pose_with_a_row_too_short_shows_no_coordinates() -> None:
    pose = r"$$ T_2^0 = \begin{bmatrix} n_x & o_x & a_x & p_x \\ n_y & o_y & a_y \\ n_z & o_z & a_z & p_z \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    assert verdicts(pose + "\n\n" + PLANAR + JACOBIAN.replace("LAST", "l_2 c_{12}"))[1:] == ["proved"] * 3


REACH = "$$ r = l_2 c_2 + l_3 c_{23} $$\n\n"
BY_REACH = "$$ p_x = r c_1 $$\n\n$$ p_y = r s_1 $$\n\n$$ p_z = l_1 + l_2 s_2 + l_3 s_{23} $$\n\n"
SQUARE = "$$ p_x^2 + p_y^2 + (p_z - l_1)^2 = l_2^2 + l_3^2 %s 2 l_2 l_3 c_3 $$\n\n"


def test_a_letter_in_the_coordinates_is_what_the_document_says_it_is() -> None:
    text = REACH + BY_REACH
    (arm,) = verify_text(text).arms
    assert arm.source == "closed form" and arm.front_matter.count("theta: ") == 3
    assert verdicts(text + SQUARE % "+")[-1] == "proved"
    column = r"$$ \frac{\partial p_x}{\partial \theta_1} = -p_y $$" + "\n\n"
    assert verdicts(text + column + SQUARE % "+" + SQUARE % "-")[-1] == "refuted"


def test_a_letter_that_is_said_in_two_ways_or_not_at_all_gives_no_arm() -> None:
    assert not verify_text(BY_REACH).arms
    assert not verify_text(REACH + REACH.replace("+", "-") + BY_REACH).arms


LAST = r"$$ %s = \operatorname{atan2}(s_5, c_5) $$" + "\n\n"
TABLE = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | 0 | $\\pi/2$ | $d_1$ | $\\theta_1$ |\n| 2 | $a_2$ | 0 | 0 | $\\theta_2$ |\n| 3 | $a_3$ | 0 | 0 | $\\theta_3$ |\n\n"


@pytest.mark.parametrize(
    "other",
    [
        "## A wrist\n\n" + LAST % r"\theta_5",
        "## Six joints\n\n$$ T_0^6 = T_0^5 T_5^6 $$\n\n",
        "## Another\n\n" + TABLE + "$$ p_z = d_1 + a_2 s_2 + a_3 s_{23} $$\n\n",
    ],
)
def test_the_closed_form_of_an_example_is_not_that_of_a_later_section_with_other_joints(other: str) -> None:
    first = "## An example\n\n" + PLANAR + JACOBIAN.replace("LAST", "l_2 c_{12}")
    result = verify_text(first + other)
    assert result.arms[0].source == "closed form"
    assert [record.verdict.value for record in result.equations][:3] == ["proved"] * 3
    assert "refuted" not in verdicts(first + other)
    wrong = verdicts(
        first.replace("LAST", "l_2 s_{12}").replace("l_2 c_{12} \\end", "l_1 c_{12} \\end")
        + "$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2 $$\n\n"
        + other
    )
    assert wrong[2] == "refuted"


def test_a_table_with_as_many_joints_is_that_of_the_closed_form_above_it() -> None:
    two = (
        TABLE.replace("| 3 | $a_3$ | 0 | 0 | $\\theta_3$ |\n", "")
        .replace("$\\pi/2$ | $d_1$", "0 | 0")
        .replace("| 1 | 0", "| 1 | $l_1$")
        .replace("$a_2", "$l_2")
    )
    result = verify_text(
        "## An example\n\n" + PLANAR + "## Its table\n\n" + two + JACOBIAN.replace("LAST", "l_2 c_{12}")
    )
    assert [arm.source for arm in result.arms] == ["table"]
    assert [record.verdict.value for record in result.equations] == ["proved"] * 3


POINTS = r"""
$$ x_1 = l_1 \cos\theta_1, \quad y_1 = l_1 \sin\theta_1 $$

$$ x_2 = x_1 + l_2 \cos(\theta_1 + \theta_2), \quad y_2 = y_1 + l_2 \sin(\theta_1 + \theta_2) $$

"""


def test_the_last_point_of_a_chain_is_the_tool() -> None:
    assert verdicts(POINTS + JACOBIAN.replace("LAST", "l_2 c_{12}")) == ["proved"] * 3
    assert verdicts(POINTS + JACOBIAN.replace("LAST", "l_1 c_{12}"))[-1] == "refuted"


def test_points_in_the_middle_of_links_are_no_chain() -> None:
    masses = POINTS.replace(r"l_1 \cos\theta_1, \quad y_1 = l_1", r"r_1 \cos\theta_1, \quad y_1 = r_1")
    masses = masses.replace("x_1 +", r"l_1 \cos\theta_1 +").replace("y_1 +", r"l_1 \sin\theta_1 +")
    assert not verify_text(masses + JACOBIAN.replace("LAST", "l_2 c_{12}")).arms


def test_a_letter_of_a_coordinate_is_no_height() -> None:
    """Rows 2 and 3 are exchanged in the pose: it has y where z belongs, and y is right."""
    pose = r"$$ T_{02} = \begin{bmatrix} c_{12} & -s_{12} & 0 & x \\ s_{12} & c_{12} & 0 & y \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    rows = pose.split(r" \\ ")
    exchanged = r" \\ ".join([rows[0], rows[2], rows[1], rows[3]])
    tip = POINTS.split("\n\n")[0].replace("x_1", "x").replace("y_1", "y")
    tip = tip.replace(r"\theta_1,", r"\theta_1 + l_2 c_{12},").replace(r"\sin\theta_1", r"\sin\theta_1 + l_2 s_{12}")
    jacobian = JACOBIAN.replace("LAST", "l_2 c_{12}")
    assert verdicts(f"{tip}\n\n{pose}\n\n{jacobian}") == ["proved"] * 3
    assert verdicts(f"{tip}\n\n{exchanged}\n\n{jacobian}") == ["proved", "unchecked", "proved"]


def test_a_slip_in_a_coordinate_with_a_slide_is_one_beside_what_the_other_coordinate_shows() -> None:
    x = r"$$ x = d_1 + l_2 c_2 + l_3 c_{23} $$"
    rest = r"""
$$ y = l_2 s_2 + l_3 s_{23} $$

$$ \dot x = \dot d_1 - (l_2 s_2 + l_3 s_{23}) \dot\theta_2 - l_3 s_{23} \dot\theta_3 $$

$$ \dot y = (l_2 c_2 + l_3 c_{23}) \dot\theta_2 + l_3 c_{23} \dot\theta_3 $$
"""
    assert verdicts(x + "\n" + rest) == ["proved"] * 4
    for slip in ("2 l_3 c_{23}", "l_3 c_2", "l_3 s_{23}"):
        first, *others = verdicts(x.replace("l_3 c_{23}", slip) + "\n" + rest)
        assert first in ("refuted", "unchecked") and "refuted" not in others


GREEK = r"""
$$ x = a\cos ONE + b\cos(ONE+TWO) $$

$$ y = a\sin ONE + b\sin(ONE+TWO) $$

$$ x^2 + y^2 = a^2 + b^2 + 2ab LAST $$

"""


@pytest.mark.parametrize(
    ("angles", "are_joints"),
    [
        (r"\alpha \beta", True),
        (r"\alpha_1 \alpha_2", True),
        (r"\chi_1 \chi_2", True),
        (r"\psi_1 \psi_2", True),
        (r"\alpha_1 \beta_2", False),
        (r"\theta_1 \alpha", False),
        (r"\theta_1 \alpha_2", False),
        (r"\alpha \gamma", False),
        (r"\theta \beta", False),
    ],
)
def test_joints_may_be_called_by_the_first_letters_and_what_stands_beside_a_theta_does_not_move(
    angles: str, are_joints: bool
) -> None:
    one, two = angles.split()
    page = GREEK.replace("ONE", one).replace("TWO", two)
    right, wrong = (verify_text(page.replace("LAST", rf"\{function} {two}")) for function in ("cos", "sin"))
    assert bool(right.arms) is are_joints
    assert [record.verdict.value for record in right.equations][2] == "proved"
    assert [record.verdict.value for record in wrong.equations][2] in ("refuted", "unchecked")


def test_an_angle_without_a_rate_behind_one_that_has_one_is_no_joint() -> None:
    bent = GREEK.replace("ONE", r"\alpha").replace("TWO", r"\beta").replace("LAST", r"\cos\beta")
    speed = r"$$ \dot x = -(a\sin\alpha + b\sin(\alpha+\beta))\dot\alpha REST $$" + "\n"
    assert not verify_text(bent + speed.replace("REST", "")).arms
    assert verify_text(bent + speed.replace("REST", r"- b\sin(\alpha+\beta)\dot\beta")).arms


def test_an_arm_that_takes_too_long_to_find_costs_no_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a slow machine spent the time of the search, nothing of the document was verified."""

    def spent(*_: object) -> None:
        raise TooComplex(say(Kind.OUT_OF_TIME))

    monkeypatch.setattr("armproof.verification.tables.arms.inference.candidates_of_closed_form", spent)
    result = verify_text(PLANAR)
    assert not result.arms
    assert [record.verdict.value for record in result.equations] == ["unchecked", "unchecked"]


LETTERS = r"""
$$ x = a\cos\alpha + b\cos(\alpha+\beta) $$
$$ y = a\sin\alpha - b\sin(\alpha+\beta) $$
$$ J = \begin{bmatrix} -a\sin\alpha - b\sin(\alpha+\beta) & -b\sin(\alpha+\beta) \\ a\cos\alpha + b\cos(\alpha+\beta) & b\cos(\alpha+\beta) \end{bmatrix} $$
"""


@pytest.mark.parametrize("seed", ["0", "1"])  # by which sets of letters have other orders
def test_letters_without_numbers_have_one_order_however_they_are_hashed(seed: str) -> None:
    code = f"from armproof import verify_text; print([e.verdict.value for e in verify_text({LETTERS!r}).equations])"
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    assert said.stdout.strip() == "['proved', 'refuted', 'proved']"


NUMBERED = r"""
$$ x_1 = L_1 \cos\theta_1 + L_2 \cos(\theta_1 + \theta_2) $$

$$ x_2 = L_1 \sin\theta_1 + SECOND $$

$$ \dot x_2 = L_1 \dot\theta_1 \cos\theta_1 + L_2 (\dot\theta_1 + \dot\theta_2) \cos(\theta_1 + \theta_2) $$

$$ v_e = \begin{bmatrix} \dot x_1 \\ \dot x_2 \end{bmatrix} = J_1(\theta) \dot\theta_1 + J_2(\theta) \dot\theta_2 $$

$$ J_2 = \begin{bmatrix} -L_2 \sin(\theta_1 + \theta_2) \\ SIGN L_2 \cos(\theta_1 + \theta_2) \end{bmatrix} $$
"""


def test_numbers_may_count_the_coordinates_of_the_tool() -> None:
    page = NUMBERED.replace("SECOND", r"L_2 \sin(\theta_1 + \theta_2)")
    assert {each.verdict.value for each in verify_text(page.replace("SIGN", "")).equations} == {"proved"}
    assert verify_text(page.replace("SIGN", "-")).equations[-1].verdict.value == "refuted"


@pytest.mark.parametrize("second", [r"L_2 \sin\theta_2", "L_3 \\sin\\theta_2", "L_3"])
def test_what_numbers_count_is_not_known_where_the_second_is_no_such_coordinate(second: str) -> None:
    result = verify_text(NUMBERED.replace("SECOND", second).replace("SIGN", ""))
    assert result.equations[1].verdict.value in ("unchecked", "refuted")


LETTERED = r"""
$$ x_B = L_1 \cos\theta_1 + L_2 \cos(\theta_1 + \theta_2) $$

$$ y_B = L_1 \sin\theta_1 + L_2 \sin(\theta_1 + \theta_2) $$

$$ \cos\theta_2 = \frac{x_B^2 + y_B^2 - L_1^2 - L_2^2}{2 L_1 L_2} $$

$$ \dot y_B = L_1 \cos\theta_1 \dot\theta_1 + L_2 \cos(\theta_1 + \theta_2) (\dot\theta_1 + \dot\theta_2) $$
"""


def test_the_tool_may_be_a_lettered_point_of_a_figure() -> None:
    assert {each.verdict.value for each in verify_text(LETTERED).equations} <= {"proved", "confirmed"}
    for old, new in (
        (r"L_2 \sin(\theta_1 + \theta_2)", r"L_2 \sin\theta_2"),
        (r"- L_1^2", r"+ L_1^2"),
        (r"\dot\theta_1 + L_2", r"\dot\theta_1 - L_2"),
    ):
        found = [each.verdict.value for each in verify_text(LETTERED.replace(old, new)).equations]
        assert found.count("refuted") == 1


SLIDES = r"""
$$ {}^0T_1 = \begin{bmatrix} c_1 & -s_1 & 0 & 0 \\ s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ {}^1T_2 = \begin{bmatrix} 1 & 0 & 0 & r \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ x = r \cos\theta_1 $$

$$ y = r \sin\theta_1 $$

$$ \dot x = \dot r \cos\theta_1 - r \sin\theta_1 \dot\theta_1 $$

$$ x^2 + y^2 = r^2 $$
"""


def test_a_slide_along_x_keeps_the_frame_before_it_as_it_is() -> None:
    assert {each.verdict.value for each in verify_text(SLIDES).equations} == {"proved"}
    for old, new in (
        (r"& -s_1 &", r"& s_1 &"),
        (r"- r \sin", r"+ r \sin"),
        (r"= r^2", r"= r"),
    ):
        assert "refuted" in [each.verdict.value for each in verify_text(SLIDES.replace(old, new)).equations], new


SCARA = r"""
$$ p = \begin{bmatrix} a_1 c_1 + a_2 c_{12} \\ a_1 s_1 + a_2 s_{12} \\ d_1 - d_3 \end{bmatrix} $$

$$ \phi = \theta_1 + \theta_2 - \theta_4 $$

$$ J = \begin{bmatrix} -a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 & 0 \\ a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 & 0 \\ 0 & 0 & -1 & 0 \\ 1 & 1 & 0 & -1 \end{bmatrix} $$

$$ \det J = a_1 a_2 s_2 $$
"""


def test_a_hand_behind_a_slide_downwards_turns_as_two_lines_say() -> None:
    assert {each.verdict.value for each in verify_text(SCARA).equations} <= {"proved", "defined"}
    wrong = [each.verdict.value for each in verify_text(SCARA.replace("- \\theta_4", "+ \\theta_4")).equations]
    assert wrong == ["unchecked"] * 4  # of two lines one is wrong, and nothing tells which
    alone = verify_text(SCARA.partition("$$ J")[0] + r"$$ p_x^2 + p_y^2 = a_1^2 + a_2^2 + 2 a_1 a_2 c_2 $$").equations
    assert alone[1].verdict.value == "unchecked"


def test_coordinates_that_are_sums_with_known_limits_give_the_arm() -> None:
    x, y = (rf"\sum_{{k=1}}^{{3}} L_k \{each}\!\left( \sum_{{i=1}}^{{k}} \theta_i \right)" for each in ("cos", "sin"))
    derived = r"\frac{{\partial x}}{{\partial\theta_2}} = -L_2 \sin(\theta_1 + \theta_2) {} L_3 \sin(\theta_1 + \theta_2 + \theta_3)".format
    shown = [f"x = {x}, \\quad y = {y}", r"\phi = \theta_1 + \theta_2 + \theta_3", derived("-"), derived("+")]
    result = verify_text("\n\n".join(f"$$ {each} $$" for each in shown))
    assert [arm.source for arm in result.arms] == ["closed form"]
    assert [each.verdict.value for each in result.equations] == ["proved", "proved", "proved", "refuted"]


def test_a_sum_to_an_unknown_number_gives_no_arm() -> None:
    text = r"$$ x = \sum_{k=1}^{N} L_k \cos\theta_k, \quad y = \sum_{k=1}^{N} L_k \sin\theta_k $$"
    assert not verify_text(text).arms
