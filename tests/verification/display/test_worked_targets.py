"""Numbers that are a slip of the pen away from those that are right."""

from math import radians

import pytest

from armproof.verification.display.worked_targets import is_misprint
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader


def _number(latex: str) -> n.Node:
    (statement,) = Reader().read(latex)
    assert isinstance(statement, n.Chain)
    return statement.members[-1]


@pytest.mark.parametrize(
    ("printed", "true", "right"),
    [
        ("a = 110.08^\\circ", radians(100.08), "100.08"),
        ("a = 1.8732", 1.8732, None),  # it is right
        ("a = 1.3872", 1.8372, "1.8372"),  # two digits swapped
        ("a = -0.7312", 0.7312, "0.7312"),  # a sign too many
        ("a = 100.09^\\circ", radians(100.08), None),  # rounded on the way
        ("a = 100.08", radians(100.08), None),  # degrees without their sign are another number
    ],
)
def test_a_misprint_is_told_from_what_is_rounded(printed: str, true: float, right: str | None) -> None:
    found = is_misprint(_number(printed), true)
    numbers = [below.text for below in n.walk(found) if isinstance(below, n.Number)] if found is not None else [None]
    assert numbers == [right]


def test_a_misprint_in_degrees_is_mended_in_degrees() -> None:
    found = is_misprint(_number("a = 110.08^\\circ"), radians(100.08))
    assert isinstance(found, n.Postfix) and found.operator == "deg"
