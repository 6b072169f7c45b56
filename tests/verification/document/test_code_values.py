"""Entries of tables in code as LaTeX: numbers of joints are counted as the language does, and what is no sum has none."""

import pytest

from armproof.verification.document.code_values import MOST, NoEntry, entry, parsed

VALUES = {
    "half": parsed("pi/2"),
    "upper": parsed("half + 1"),
    "a": parsed("3"),
    "a1": parsed("4"),
    "loop": parsed("-loop"),
}


@pytest.mark.parametrize(
    ("code", "latex"),
    [
        ("q(1)", "q_{1}"),
        ("q[1]", "q_{2}"),
        ("self.th[0]", r"\theta_{1}"),
        ("float(+d2_var)", "d_{2}"),
        ("a1", "a_{1}"),  # a letter with an index is one, whatever the code gives it
        ("a", "3"),
        ("L", "L"),
        ("upper", r"\frac{\pi}{2} + 1"),
        ("-(a1 - d2)*2", r"(-(a_{1} - d_{2})) \cdot 2"),
        ("a1 - -d2 + pi", r"a_{1} - (-d_{2}) + \pi"),
        ("radians(a1 + 1)", r"(a_{1} + 1) \cdot \frac{\pi}{180}"),
        ("1e-3", "0.001"),
    ],
)
def test_an_entry_is_what_the_code_says(code: str, latex: str) -> None:
    assert entry(parsed(code), VALUES) == latex


@pytest.mark.parametrize("code", ["loop", "other", "f(a1, 2)", "q[i]", "a1 % 2", "'a'", "True", "not a1", "a1 +"])
def test_what_is_no_sum_of_letters_and_numbers_has_no_entry(code: str) -> None:
    with pytest.raises(NoEntry):
        entry(parsed(code), VALUES)


def test_an_entry_is_not_as_long_as_one_likes() -> None:
    assert entry(parsed("1".rjust(MOST))) == "1"
    with pytest.raises(NoEntry):
        parsed("1".rjust(MOST + 1))
