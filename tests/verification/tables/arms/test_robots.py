"""The arm of a URDF in a document's code is taken where its equations hold for it, and is none where the chain is not told."""

from __future__ import annotations

import pytest

from armproof import verify_text

URDF = """
```xml
<robot name="elbow">
  <joint name="joint_1" type="revolute">
    <parent link="base"/><child link="turret"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="joint_2" type="continuous">
    <parent link="turret"/><child link="upper"/><origin xyz="0 0 0" rpy="1.5708 0 0"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="joint_3" type="revolute">
    <parent link="upper"/><child link="fore"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="tool_joint" type="fixed"><parent link="fore"/><child link="tool0"/><origin xyz="0.4 0 0"/></joint>
</robot>
```
"""
X = r"""
$$ x = \cos\theta_1 (0.5 \cos\theta_2 + 0.4 \cos(\theta_2 + \theta_3)) $$
"""
Z = r"""
$$ z = 0.3 + 0.5 \sin\theta_2 + 0.4 \sin(\theta_2 + \theta_3) $$
"""
REACH = r"""
$$ x^2 + y^2 + (z - 0.3)^2 = 0.41 + 0.4 \cos\theta_3 $$
"""


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


def test_its_equations_are_proved() -> None:
    assert verdicts(URDF + X + Z + REACH) == ["proved"] * 3


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"0.4 \cos(\theta_2 + \theta_3))", r"0.4 \cos\theta_3)"),
        (r"+ 0.4 \sin", r"- 0.4 \sin"),
        (r"0.4 \cos\theta_3 $$", r"0.2 \cos\theta_3 $$"),
    ],
)
def test_a_slip_is_refuted(right: str, wrong: str) -> None:
    text = X + Z + REACH
    assert text.count(right) == 1
    found = verdicts(URDF + text.replace(right, wrong))
    assert sorted(found) == ["proved", "proved", "refuted"]
    assert found.index("refuted") == [right in each for each in (X, Z, REACH)].index(True)


def test_an_axis_that_points_the_other_way_turns_the_other_way() -> None:
    text = URDF.replace('rpy="1.5708 0 0"/><axis xyz="0 0 1"/>', 'rpy="1.5708 0 0"/><axis xyz="0 0 -1"/>')
    formulas = X.replace(r"\theta_2 + \theta_3", r"\theta_3 - \theta_2") + Z.replace(r"+ 0.5", "- 0.5").replace(
        r"\theta_2 + \theta_3", r"\theta_3 - \theta_2"
    )
    assert verdicts(text + formulas) == ["proved"] * 2
    assert "refuted" not in verdicts(text + X + Z)


@pytest.mark.parametrize(
    ("told", "otherwise"),
    [
        ("joint_1", "joint_3a_2"),  # numbers that are not those of the places
        ('type="continuous"', 'type="planar"'),
        ('xyz="0 0 0" rpy="1.5708 0 0"', 'xyz="0 0 0" rpy="0.7 0 0"'),
        ('<origin xyz="0.5 0 0"/>', '<origin xyz="0.5 0 0"/><mimic joint="joint_2"/>'),
        ('<parent link="upper"/>', '<parent link="base"/>'),  # two branches
        ("<robot", "<!DOCTYPE robot><robot"),
    ],
)
def test_what_is_not_told_gives_no_arm(told: str, otherwise: str) -> None:
    assert not verify_text(URDF.replace(told, otherwise) + X + Z).arms


def test_the_robot_of_an_example_is_not_that_of_the_formulas() -> None:
    formulas = r"""
$$ x = 0.8 \cos\theta_1 + 0.7 \cos(\theta_1 + \theta_2) $$

$$ y = 0.8 \sin\theta_1 + 0.7 \sin(\theta_1 + \theta_2) $$
"""
    assert "refuted" not in verdicts(URDF + formulas)


def test_letters_are_those_of_the_document() -> None:
    text = URDF.replace('xyz="0.5 0 0"', 'xyz="${l2} 0 0"').replace('xyz="0.4 0 0"', 'xyz="${l3} 0 0"')
    formulas = (X + Z).replace("0.5", "l_2").replace("0.4", "l_3")
    assert verdicts(text + formulas) == ["proved"] * 2
    assert verdicts(text + formulas + Z.replace("0.3 + 0.5", "0.3 - l_2").replace("0.4", "l_3"))[-1] == "refuted"
