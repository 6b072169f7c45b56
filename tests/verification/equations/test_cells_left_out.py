r"""Cells that dots leave to the reader: those of the arm's joints, where the first and the last differ in an index alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text

HEAD = r"""
| i | a | α | d | θ |
|---|---|---|---|---|
| 1 | 0 | π/2 | $d_1$ | $\theta_1$ |
| 2 | $a_2$ | 0 | 0 | $\theta_2$ |
| 3 | $a_3$ | 0 | 0 | $\theta_3$ |

$$ A_2 = \begin{bmatrix} c_2 & -s_2 & 0 & a_2 c_2 \\ s_2 & c_2 & 0 & a_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""
FIRST, LAST = r"z_0 \times (p_n - p_0)", r"z_{n-1} \times (p_n - p_{n-1})"


def verdict(first: str, between: str, last: str) -> str:
    """Return what is said of a Jacobian whose middle is left out."""
    display = (
        rf"$$ J = \begin{{bmatrix}} {first} {between} & \cdots & {last} \\ z_0 & \cdots & z_{{n-1}} \end{{bmatrix}} $$"
    )
    document = verify_text(HEAD + display, "md", path=Path("a.md"), confirm=False)
    return str(document.equations[-1].verdict.value)


def test_cells_between_the_first_and_the_last_are_those_of_the_joints():
    assert verdict(FIRST, "", LAST) == "proved"


@pytest.mark.parametrize(
    "last",
    [
        r"z_{n-1} \times (p_n + p_{n-1})",
        r"-z_{n-1} \times (p_n - p_{n-1})",
        r"(p_n - p_{n-1}) \times z_{n-1}",
        r"2 z_{n-1} \times (p_n - p_{n-1})",
        r"z_{n-1} \times (p_n - p_n)",
        r"z_n \times (p_n - p_{n-1})",
    ],
)
def test_a_last_cell_that_is_written_otherwise_leaves_the_dots(last: str):
    assert verdict(FIRST, "", last) == "unchecked"


@pytest.mark.parametrize("second", [r"z_1 \times (p_n + p_1)", r"z_1 \times (p_n - p_2)", r"z_2 \times (p_n - p_1)"])
def test_a_second_cell_that_the_first_does_not_make_leaves_the_dots(second: str):
    assert verdict(FIRST, f"& {second}", LAST) == "unchecked"
