"""The arm of a law of cosines: the cosine of a joint by the distance of a point and two lengths."""

from __future__ import annotations

import pytest

from armproof import verify_text

PLANAR = r"""
$$ D = \frac{w_x^2 + w_z^2 - L_1^2 - L_2^2}{2 L_1 L_2} $$

$$ \theta_2 = \operatorname{atan2}(\pm\sqrt{1 - D^2}, D) $$

$$ \theta_1 = \operatorname{atan2}(w_z, w_x) - \operatorname{atan2}(L_2 \sin\theta_2, L_1 + L_2 \cos\theta_2) $$
"""
ELBOW = r"""
$$ \theta_1 = \operatorname{atan2}(y_w, x_w) $$

$$ r = \sqrt{x_w^2 + y_w^2} $$

$$ s = z_w - d_1 $$

$$ D = \frac{r^2 + s^2 - a_2^2 - a_3^2}{2 a_2 a_3} $$

$$ \theta_3 = \operatorname{atan2}(\pm\sqrt{1 - D^2}, D) $$

$$ \theta_2 = \operatorname{atan2}(s, r) - \operatorname{atan2}(a_3 \sin\theta_3, a_2 + a_3 \cos\theta_3) $$
"""


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


def test_a_law_gives_the_arm_in_the_plane_of_its_links() -> None:
    (arm,) = verify_text(PLANAR).arms
    assert (arm.source, arm.line, arm.convention) == ("closed form", 2, "classic")
    assert verdicts(PLANAR) == ["defined", "proved", "proved"]


def test_with_a_radius_and_a_height_it_gives_an_arm_in_space() -> None:
    (arm,) = verify_text(ELBOW).arms
    assert arm.front_matter.count("theta: ") == 3
    assert verdicts(ELBOW) == ["confirmed", "defined", "defined", "defined", "proved", "confirmed"]


@pytest.mark.parametrize("text", [PLANAR, ELBOW])
def test_nothing_is_refuted_where_the_joint_before_does_not_turn_as_the_law_says(text: str) -> None:
    wrong = text.replace(r"+ L_2 \cos", r"- L_2 \cos").replace(r"+ a_3 \cos", r"- a_3 \cos")
    assert verdicts(wrong)[-1] == "unchecked"
    assert "refuted" not in verdicts(wrong)


def test_with_that_joint_another_wrong_solution_is_refuted() -> None:
    wrong = (
        PLANAR
        + r"$$ \theta_1 = \operatorname{atan2}(w_z, w_x) - \operatorname{atan2}(L_1 \sin\theta_2, L_1 + L_2 \cos\theta_2) $$"
    )
    assert verdicts(wrong) == ["defined", "proved", "proved", "refuted"]


@pytest.mark.parametrize(
    "other",
    [
        r"\frac{L_1^2 + L_2^2 - w_x^2 - w_z^2}{2 L_1 L_2}",  # of the angle between the links
        r"\frac{w_x^2 + w_z^2 - L_1^2 + L_2^2}{2 L_1 L_2}",
        r"\frac{w_x^2 + v_z^2 - L_1^2 - L_2^2}{2 L_1 L_2}",
    ],
)
def test_another_quotient_is_no_law(other: str) -> None:
    assert not verify_text(PLANAR.replace(r"\frac{w_x^2 + w_z^2 - L_1^2 - L_2^2}{2 L_1 L_2}", other)).arms


FORWARD = r"""
$$ x = l_1 \cos q_1 + l_2 \cos(q_1 + q_2), \quad y = l_1 \sin q_1 + l_2 \sin(q_1 + q_2) $$

$$ \frac{\partial x}{\partial q_2} = -l_2 \sin(q_1 + q_2) $$

$$ r^2 = x_d^2 + y_d^2 $$

$$ \cos q_2 = \frac{r^2 - l_1^2 - l_2^2}{2 l_1 l_2} $$
"""


def test_the_point_of_the_law_is_the_tool_of_the_closed_form() -> None:
    assert verdicts(FORWARD)[-2:] == ["defined", "proved"]


def test_a_point_beside_the_tool_is_another() -> None:
    assert verdicts(FORWARD + r"$$ e = x_d - x $$")[-1] == "unchecked"


HAND = r"""
$$ x_w = x - l_3 \cos\phi $$

$$ y_w = y - l_3 \sin\phi $$

$$ D = \frac{x_w^2 + y_w^2 - l_1^2 - l_2^2}{2 l_1 l_2} $$

$$ \theta_2 = \operatorname{atan2}(\pm\sqrt{1 - D^2}, D) $$

$$ \theta_1 = \operatorname{atan2}(y_w, x_w) - \operatorname{atan2}(l_2 \sin\theta_2, l_1 + l_2 \cos\theta_2) $$

$$ \theta_3 = \phi - \theta_1 - \theta_2 $$
"""


def test_a_link_behind_the_point_of_the_law_is_the_third() -> None:
    (arm,) = verify_text(HAND).arms
    assert arm.front_matter.count("theta: ") == 3
    assert verdicts(HAND) == ["proved", "proved", "defined", "proved", "proved", "proved"]


@pytest.mark.parametrize(
    ("right", "other"),
    [
        (r"y - l_3 \sin\phi", r"y + l_3 \sin\phi"),
        (r"y - l_3 \sin\phi", r"y - l_4 \sin\phi"),
        (r"\phi - \theta_1 - \theta_2", r"\phi - \theta_1 + \theta_2"),
        (r"$$ x_w", r"$$ \phi = \operatorname{atan2}(y, x) $$" + "\n\n$$ x_w"),
    ],
)
def test_it_is_none_where_anything_of_it_is_otherwise(right: str, other: str) -> None:
    (arm,) = verify_text(HAND.replace(right, other)).arms
    assert arm.front_matter.count("theta: ") == 2
    assert "refuted" not in verdicts(HAND.replace(right, other))


def test_a_described_arm_has_the_names_of_its_law_for_a_target() -> None:
    text = r"""A planar arm with two revolute joints has links of lengths $l_1$ and $l_2$ and joint angles $\theta_1$ and $\theta_2$.

$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12} $$

For a desired position $(x_d, y_d)$:

$$ \cos\theta_2 = \frac{x_d^2 + y_d^2 - l_1^2 - l_2^2}{2 l_1 l_2} $$

$$ \theta_1 = \operatorname{atan2}(y_d, x_d) - \operatorname{atan2}(l_2 s_2, l_1 + l_2 c_2) $$
"""
    assert verdicts(text) == ["proved"] * 3
    assert verdicts(text.replace("l_1 + l_2 c_2)", "l_1 - l_2 c_2)"))[-1] == "refuted"
