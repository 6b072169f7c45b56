"""One usual name for several points of a section, and wrists that are none."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

PLANAR, SPATIAL = "---\narm: planar_3r\n---\n", "---\narm: spatial_rrr\n---\n"
WRIST, TOOL, ELBOW = "l_1 c_1 + l_2 c_{12}", "l_1 c_1 + l_2 c_{12} + l_3 c_{123}", "l_1 c_1"


def verdicts(head: str, *displays: str) -> list[str]:
    """Return what is said of displays that stand one below another."""
    text = head + "# Points\n\n" + "\n\n".join(f"Words.\n\n$$ {each} $$" for each in displays)
    return [each.verdict.value for each in verify_text(text).equations]


@pytest.mark.parametrize(("value", "verdict"), [(WRIST, "proved"), (TOOL, "unchecked"), (ELBOW, "unchecked")])
def test_the_wrist_of_a_planar_arm_is_where_its_last_joint_is(value: str, verdict: str) -> None:
    assert verdicts(PLANAR, f"x_w = {value}") == [verdict]


def test_the_letter_of_the_manipulability_is_of_no_wrist() -> None:
    head = PLANAR.replace("planar_3r", "spherical_wrist")
    assert verdicts(head, "w = |\\sin\\theta_5|") == verdicts(head, "\\mu = |\\sin\\theta_5|")


def test_a_name_of_two_points_is_left_open_but_for_what_convention_says_first_where_it_stands_first() -> None:
    tool, elbow = "x = c_1 (l_2 c_2 + l_3 s_{23})", "y = l_2 s_1 c_2"
    assert verdicts(SPATIAL, tool, elbow) == ["proved", "unchecked"]
    assert verdicts(SPATIAL, elbow, tool) == ["unchecked", "unchecked"]
    assert verdicts(SPATIAL, elbow) == ["proved"]


def test_another_section_may_be_of_another_point() -> None:
    assert verdicts(SPATIAL, "y = l_2 s_1 c_2 $$\n\n# The tool\n\n$$ x = c_1 (l_2 c_2 + l_3 s_{23})") == ["proved"] * 2
