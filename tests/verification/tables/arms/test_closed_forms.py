"""The arm of a closed form: the coordinates of a planar chain, or of one that a first joint turns."""

from __future__ import annotations

import pytest

from armproof import verify_text

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


@pytest.mark.parametrize("other", ["l_1 s_1 + l_2 s_2", "l_1 s_1 - l_2 s_{12}", "l_1 s_1 + l_3 s_{12}", "l_1 s_1"])
def test_coordinates_that_are_not_of_one_arm_give_none(other: str) -> None:
    assert not verify_text(PLANAR.replace("l_1 s_1 + l_2 s_{12}", other)).arms


def test_a_turned_arm_needs_its_height() -> None:
    assert not verify_text(TURNED.partition("$$ z")[0]).arms
