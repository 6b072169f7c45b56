"""What tells the convention of a table where no pose does: the link matrix that the document prints for any link."""

from __future__ import annotations

import pytest

from armproof import verify_text

TABLE = r"""| i | $a$ | $\alpha$ | $d$ | $\theta$ |
|---|---|---|---|---|
| 1 | 0 | $\pi/2$ | $d_1$ | $\theta_1$ |
| 2 | $a_2$ | 0 | 0 | $\theta_2$ |
| 3 | $a_3$ | 0 | 0 | $\theta_3$ |

"""
CLASSIC = r"""\begin{bmatrix} \cos\theta & -\sin\theta\cos\alpha & \sin\theta\sin\alpha & a\cos\theta \\
\sin\theta & \cos\theta\cos\alpha & -\cos\theta\sin\alpha & a\sin\theta \\
0 & \sin\alpha & \cos\alpha & d \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
STEPS = r"Rot(x, \alpha_{i-1}) Trans(x, a_{i-1}) Rot(z, \theta_i) Trans(z, d_i)"
RIGHT = r"$$ s_1 p_x = c_1 p_y $$" + "\n\n"  # holds in both conventions
HEIGHT = r"$$ p_z = d_1 + a_2 s_2 + a_3 s_{23} $$" + "\n"


def shown(matrix: str) -> str:
    return f"$$ {matrix} $$\n\n"


def test_a_table_whose_poses_are_not_printed_is_read_as_the_general_link_matrix_shows() -> None:
    for general, convention in ((f"T = {CLASSIC}", "classic"), (f"T_i = {STEPS}", "modified")):
        (arm,) = verify_text(TABLE + shown(general) + shown("x = 1")).arms
        assert arm.convention == convention
    assert not verify_text(TABLE + shown("x = 1")).arms


def test_what_is_claimed_then_is_decided_and_a_false_twin_is_not_proved() -> None:
    text = TABLE.replace("$d_1$", "0.3").replace("$a_2$", "0.4").replace("$a_3$", "0.5") + shown(f"T = {CLASSIC}")
    result = verify_text(text + HEIGHT)
    assert [record.verdict.value for record in result.equations][1:] == ["proved"]
    assert verify_text(text + HEIGHT.replace("+ a_3", "- a_3")).equations[1].verdict == "unchecked"


@pytest.mark.parametrize(
    "matrix",
    [
        f"T = {CLASSIC.replace('& d', '& -d')}",  # a slip: of no convention
        f"T = {CLASSIC} $$\n\n$$ T_i = {STEPS}",  # both are shown
        f"A_1 = {CLASSIC.replace('theta', 'theta_1').replace('alpha', 'alpha_1').replace('& a', '& a_1').replace('& d', '& d_1')}",
    ],
)
def test_what_shows_no_convention_or_two_tells_nothing(matrix: str) -> None:
    assert not verify_text(TABLE + shown(matrix) + shown("x = 1")).arms


HEAD = "| i | $a$ | $\\alpha$ | $d$ | $\\theta$ |\n|---|---|---|---|---|\n"
TWO = HEAD + "| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |\n\n"


def pose(y: str = "l_1 s_1 + l_2 s_{12}") -> str:
    rows = rf"c_{{12}} & -s_{{12}} & 0 & l_1 c_1 + l_2 c_{{12}} \\ s_{{12}} & c_{{12}} & 0 & {y} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1"
    return shown(rf"{{}}^0T_2 = \begin{{bmatrix}} {rows} \end{{bmatrix}}")


def test_the_first_part_of_an_arm_is_taken_where_a_pose_of_its_own_frames_holds() -> None:
    """The tool of the whole is none of its frames: what does not say its frame is not decided."""
    wrist = shown(r"x = l_1 c_1 + l_2 c_{12}") + shown(r"r_{13} = 0") + shown(r"R_3^2 = c_3")
    result = verify_text(TWO + pose() + wrist)
    assert [record.verdict.value for record in result.equations] == ["proved", "unchecked", "unchecked", "unchecked"]
    assert result.arms
    first = shown(r"{}^0R_1 = \begin{bmatrix} c_1 & -s_1 & 0 \\ s_1 & c_1 & 0 \\ 0 & 0 & 1 \end{bmatrix}")
    twisted = verify_text(TWO + pose() + first + first.replace("R_1", "R_2") + wrist)
    assert twisted.equations[2].verdict == "refuted"


def test_no_part_of_an_arm_is_taken_where_its_pose_fails() -> None:
    text = shown(r"\theta_3 = q_3 + \pi")
    assert not verify_text(TWO + pose("l_1 s_1 - l_2 s_{12}") + text).arms
    assert verify_text(TWO + pose() + text).arms


LINK_2 = r"\begin{bmatrix} c_2 & -s_2 & 0 & a_2 c_2 \\ s_2 & c_2 & 0 & a_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"


def test_where_the_link_matrix_of_any_joint_is_called_so_its_names_with_numbers_are_links() -> None:
    """T_1 T_2 T_3 is then a product of links, and no product of poses in the base."""
    general = shown(
        "T_i = "
        + CLASSIC.replace(r"\theta", r"\theta_i")
        .replace(r"\alpha", r"\alpha_i")
        .replace("& a", "& a_i")
        .replace("& d", "& d_i")
    )
    product, wrong = shown(r"{}^0T_3 = T_1 T_2 T_3"), shown(r"{}^0T_3 = T_1 T_3 T_2")
    told = verify_text(TABLE + general + product + wrong).equations
    assert [record.verdict.value for record in told] == ["proved", "proved", "refuted"]
    assert verify_text(TABLE + general + shown(f"{{}}^1T_2 = {LINK_2}") + wrong).equations[-1].verdict == "refuted"
    assert verify_text(TABLE + HEIGHT + shown(f"{{}}^1T_2 = {LINK_2}") + product).equations[-1].verdict != "refuted"


OFFSET = r"""| i | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ | %s |
|---|---|---|---|---|---|
| 1 | $q_1$ | $d_1$ | 0 | $\pi/2$ | 0 |
| 2 | $q_2$ | 0 | $a_2$ | 0 | %s |

"""


@pytest.mark.parametrize(("header", "quarter"), [("offset", r"$\pi/2$"), ("Offset (deg)", "90")])
def test_a_column_of_offsets_beside_the_column_of_d_adds_to_the_variable(header: str, quarter: str) -> None:
    for sign, verdict in (("+", "proved"), ("-", "refuted")):
        text = OFFSET % (header, quarter) + shown(rf"p_z = d_1 {sign} a_2 \cos q_2") + shown(r"p_x = -a_2 c_1 \sin q_2")
        assert verify_text(text + shown(r"p_y = -a_2 s_1 \sin q_2")).equations[0].verdict.value == verdict
    plain = OFFSET % ("offset", "0") + shown("p_z = d_1 + a_2 s_2") + shown("p_x = a_2 c_1 c_2")
    assert [record.verdict.value for record in verify_text(plain).equations] == ["proved"] * 2


def test_a_column_of_offsets_alone_is_that_of_d() -> None:
    text = OFFSET.replace("| $d_i$ ", "").replace("---|---|---|---|---|---|", "---|---|---|---|---|").replace(
        "| $d_1$ ", ""
    ).replace("| $q_2$ | 0 ", "| $q_2$ ") % ("offset", "0")
    text = text.replace("| $\\pi/2$ | 0 |", "| $\\pi/2$ | $d_1$ |")
    told = verify_text(text + shown("p_z = d_1 + a_2 s_2") + shown("p_x = a_2 c_1 c_2")).equations
    assert [record.verdict.value for record in told] == ["proved"] * 2


def test_a_product_that_may_be_written_the_other_way_round_is_left_open_until_a_matrix_tells_the_direction() -> None:
    """T_0^3 = A_1 A_2 A_3 = [R_{11} …]: nothing tells that the upper index is the reference, and no inverse is printed."""
    letters = r"R_{%d1} & R_{%d2} & R_{%d3} & X_{%d}"
    rows = r" \\ ".join(letters % ((k,) * 4) for k in (1, 2, 3)) + r" \\ 0 & 0 & 0 & 1"
    product = shown(rf"T_0^3 = A_1(q_1) A_2(q_2) A_3(q_3) = \begin{{bmatrix}} {rows} \end{{bmatrix}}")
    first = r"\begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    assert verify_text(TABLE + HEIGHT + "\n" + product).equations[-1].verdict == "unchecked"
    told = verify_text(
        TABLE + HEIGHT + "\n" + shown(f"T^0_1 = {first}") + product.replace("A_3(q_3) = ", "A_3(q_3) = T_0^3 = ")
    ).equations
    assert [record.verdict.value for record in told][:2] == ["proved"] * 2 and told[-1].verdict != "proved"
    wrong = shown(f"T^0_1 = {first.replace('-c_1', 'c_1')}")
    assert verify_text(TABLE + HEIGHT + "\n" + shown(f"T^0_1 = {first}") + wrong).equations[-1].verdict == "refuted"
