"""Rows without a joint, and the poses of base and tool, in a document's table and in its front matter."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.tables.arms.frame_names import end_effectors

FRONT = """---
arm:
  dh: classic
  base: {xyz: [0, 0, h], rpy: [0, 0, pi/2]}
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: theta_1}
    - {a: l_2, alpha: 0, d: 0, theta: theta_2}
  tool: {xyz: [l_3, 0, 0], rpy: [pi/2, 0, 0]}
---

"""
X_0 = "l_1 c_1 + (l_2 + l_3) c_{12}"
Y_0 = "l_1 s_1 + (l_2 + l_3) s_{12}"
COLUMN = "\\begin{{bmatrix}} {} \\\\ {} \\\\ {} \\end{{bmatrix}}".format
HEAD = "| Link | a | alpha | d | theta |\n|---|---|---|---|---|\n"
ROWS = "| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |\n"
POSE = "$$ {} = \\begin{{bmatrix}} c_{{12}} & -s_{{12}} & 0 & {} \\\\ s_{{12}} & c_{{12}} & 0 & {} \\\\ 0 & 0 & 1 & {} \\\\ 0 & 0 & 0 & 1 \\end{{bmatrix}} $$\n\n".format
TWO = POSE("T_2^0", "l_1 c_1 + l_2 c_{12}", "l_1 s_1 + l_2 s_{12}", "0")


def verdict(text: str) -> str:
    return verify_text(text).equations[-1].verdict.value


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("{}^Bp_E = " + COLUMN("-" + Y_0.replace("+ (", "- ("), X_0, "h"), "{}^Bp_E = " + COLUMN("-" + Y_0, X_0, "h")),
        ("{}^0p_E = " + COLUMN(X_0, Y_0, "0"), "{}^0p_E = " + COLUMN(X_0, Y_0, "h")),
        ("{}^2z_E = " + COLUMN("0", "-1", "0"), "{}^2z_E = " + COLUMN("0", "1", "0")),
        ("{}^Bx_0 = " + COLUMN("0", "1", "0"), "{}^Bx_0 = " + COLUMN("1", "0", "0")),
    ],
)
def test_base_and_tool_stand_before_and_behind_the_rows_of_the_front_matter(right: str, wrong: str) -> None:
    assert verdict(f"{FRONT}$$ {right} $$\n") == "proved"
    assert verdict(f"{FRONT}$$ {wrong} $$\n") == "refuted"


def test_what_tells_no_frame_of_reference_may_be_seen_from_the_base_or_from_frame_0() -> None:
    both = [COLUMN(X_0.replace("(l_2 + l_3)", "l_2"), Y_0.replace("(l_2 + l_3)", "l_2"), "0"),
            COLUMN("-l_1 s_1 - l_2 s_{12}", "l_1 c_1 + l_2 c_{12}", "h")]  # fmt: skip
    assert [verdict(f"{FRONT}$$ p_2 = {one} $$\n") for one in both] == ["proved"] * 2
    assert verdict(f"{FRONT}$$ p_2 = {both[1].replace('- l_2', '+ l_2')} $$\n") == "refuted"


def test_a_row_without_a_joint_is_a_fixed_step_of_the_document_s_arm() -> None:
    table = HEAD + ROWS + "| 3 | 0 | 0 | $h$ | 0 |\n\n"
    three = POSE("T_3^0", "l_1 c_1 + l_2 c_{12}", "l_1 s_1 + l_2 s_{12}", "h")
    result = verify_text(table + TWO + three)
    assert [record.verdict.value for record in result.equations] == ["proved", "proved"]
    assert "joints: [theta_1, theta_2]" in result.arms[0].front_matter
    wrong = verify_text(table + TWO + three.replace("l_2 s_{12}", "l_2 c_{12}"))
    assert wrong.equations[-1].verdict == "refuted"
    other = verify_text(table + TWO + three.replace("& h", "& 2 h")).equations[-1]
    assert other.verdict == "unchecked" and "nothing else that is decided tells which is right" in other.message


@pytest.mark.parametrize("label", ["tool", "E", "2→E", "$2 \\to 3$", "EE", "3"])
def test_the_label_names_the_frame_of_a_fixed_row(label: str) -> None:
    named = {"2→E": "E", "EE": "EE"}.get(label, "E" if label in ("tool", "E") else "3")
    table = f"{HEAD}{ROWS}| {label} | 0 | 0 | $h$ | 0 |\n\n"
    pose = POSE("T_{%s}^0" % named, "l_1 c_1 + l_2 c_{12}", "l_1 s_1 + l_2 s_{12}", "h")
    assert verdict(table + TWO + pose) == "proved"
    assert verdict(table + TWO + pose.replace("& h", "& -h")) == "unchecked"


def test_no_arm_is_taken_where_a_fixed_row_has_a_joint_elsewhere() -> None:
    table = HEAD + ROWS + "| 3 | $l_3$ | 0 | 0 | 0 |\n\n"
    result = verify_text(table + TWO + "$$ x = l_1 c_1 + l_2 c_{12} + l_3 c_{123} $$\n")
    assert not result.arms and "the document speaks of joint 3" in result.tables[0].message


def test_a_transform_to_a_tool_that_the_arm_has_not_is_no_identity() -> None:
    """{}^2T_E does not say that its length is 0."""
    tool = POSE("{}^2T_E", "0", "0", "d_g").replace("c_{12} & -s_{12}", "1 & 0").replace("s_{12} & c_{12}", "0 & 1")
    text = HEAD + ROWS + "\n" + TWO + tool
    assert verdict(
        text + "$$ {}^0p_E = %s $$\n" % COLUMN("l_1 c_1 + l_2 c_{12} + d_g", "l_1 s_1 + l_2 s_{12}", "0")
    ) in (
        "unchecked",
        "refuted",
    )


BESIDE = [("2→G", "2→E"), ("E1", "E2"), ("EE", "EE"), ("2e1 (nozzle)", "2e2 (gripper)"), ("tool 1", "tool 2")]


def two_tools(labels: tuple[str, str], theta: str = "0") -> str:
    ends = [f"| {label} | $b_{k}$ | 0 | 0 | {theta} |\n" for k, label in enumerate(labels, start=1)]
    return HEAD.replace("Link", "Link *i*") + ROWS + "".join(ends) + "\n"


@pytest.mark.parametrize("labels", BESIDE)
def test_of_two_end_effectors_the_arm_has_the_first_and_the_second_follows_no_other(labels: tuple[str, str]) -> None:
    table = two_tools(labels)
    assert verdict(table + TWO) == "proved"
    assert verdict(table + TWO + TWO.replace("l_2 s_{12}", "l_2 c_{12}")) == "refuted"
    assert "b_2" not in verify_text(table + TWO).arms[0].front_matter


@pytest.mark.parametrize("label", ["plate", "offset"])
def test_two_fixed_rows_of_one_name_are_no_end_effectors(label: str) -> None:
    joints = ["theta_1", "theta_2", "", ""]
    assert end_effectors(["1", "2", "tool 1", "tool 2"], joints) == (2, "E")
    assert end_effectors(["1", "2", f"{label} 1", f"{label} 2"], joints) is None


def test_end_effectors_at_a_joint_of_their_own_share_it() -> None:
    table = two_tools(("3e1", "3e2"), "$\\theta_3$")
    tool = "$$ {}^0p_{e1} = \\begin{bmatrix} l_1 c_1 + l_2 c_{12} + b_1 c_{123} \\\\ l_1 s_1 + l_2 s_{12} + b_1 s_{123} \\\\ 0 \\end{bmatrix} $$\n"
    assert verdict(table + TWO + tool) == "proved"
    assert verdict(table + TWO + tool.replace("b_1 s_{123}", "b_1 s_{12}")) in ("refuted", "unchecked")


@pytest.mark.parametrize(
    "wrong", ["p = " + COLUMN("l_1 c_1 + l_2 c_{12}", "l_1 s_1 - l_2 s_{12}", "0"), "\\det J_v = l_1 l_2 c_2"]
)
def test_what_does_not_say_of_which_end_effector_it_is_is_not_refuted(wrong: str) -> None:
    assert verdict(HEAD + ROWS + "\n" + TWO + f"$$ {wrong} $$\n") == "refuted"
    result = verify_text(two_tools(("E1", "E2")) + TWO + f"$$ {wrong} $$\n")
    assert result.equations[-1].verdict == "unchecked"
    assert "shows several end effectors" in result.equations[-1].message


def test_tools_one_behind_the_other_are_steps_of_one_arm() -> None:
    table = HEAD + ROWS + "| 2→F | $b_1$ | 0 | 0 | 0 |\n| F→E | $b_2$ | 0 | 0 | 0 |\n\n"
    assert "b_2" in verify_text(table + TWO).arms[0].front_matter


@pytest.mark.parametrize(("angle", "joints"), [("$\\theta_3 = 0$", 2), ("$\\theta_3$", 3)])
def test_a_last_row_that_alone_gives_its_angle_a_number_has_no_joint(angle: str, joints: int) -> None:
    last = f"| 3 | 0 | 0 | $l_3$ | {angle} |\n\n"
    (arm,) = verify_text(HEAD + ROWS + last + TWO).arms
    assert len(arm.front["arm"]["joints"]) == joints


def test_angles_that_all_have_numbers_are_those_of_a_posture() -> None:
    rows = ROWS.replace("\\theta_1$", "\\theta_1 = 0$").replace("\\theta_2$", "\\theta_2 = 0$")
    (arm,) = verify_text(HEAD + rows + "\n" + TWO).arms
    assert arm.front["arm"]["joints"] == ["theta_1", "theta_2"]


def test_indices_in_html_are_indices() -> None:
    rows = ROWS.replace("$l_1$", "l<sub>1</sub>").replace("$\\theta_2$", "θ<sub>2</sub>")
    right, wrong = (HEAD + rows + "\n" + text for text in (TWO, TWO.replace("l_2 s_{12}", "l_1 s_{12}")))
    assert verdict(right) == "proved" != verdict(wrong)
