"""The link behind the last row of a modified table: its length is that of the tool where the document's equations show it."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from armproof.verification.verdict import Verdict

TABLE = """| j | $\\alpha_j$ | $d_j$ | $\\theta_j$ | $r_j$ |
|---|---|---|---|---|
| 1 | 0 | 0 | $\\theta_1$ | 0 |
| 2 | $-90^\\circ$ | $D_2$ | $\\theta_2$ | 0 |
| 3 | 0 | $D_3$ | $\\theta_3$ | 0 |

$$ ^0T_1 = \\begin{bmatrix} c_1 & -s_1 & 0 & 0 \\\\ s_1 & c_1 & 0 & 0 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$

$$ ^1T_2 = \\begin{bmatrix} c_2 & -s_2 & 0 & D_2 \\\\ 0 & 0 & 1 & 0 \\\\ -s_2 & -c_2 & 0 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$
"""
ALONG = {
    "x": ("c_1(D_2 + D_3 c_2 + # c_{23})", "s_1(D_2 + D_3 c_2 + # c_{23})", "-D_3 s_2 - # s_{23}", "D_3 # s_3"),
    "z": ("c_1(D_2 + D_3 c_2) - # s_1", "s_1(D_2 + D_3 c_2) + # c_1", "-D_3 s_2", None),
}
LETTERS = ("R_4", "L_4", "D_4", "l")


@pytest.mark.parametrize("axis", ALONG)
@pytest.mark.parametrize("letter", LETTERS)
def test_its_length_is_that_of_the_tool(axis: str, letter: str) -> None:
    x, y, z, lever = (each and each.replace("#", letter) for each in ALONG[axis])
    more = f"$$ \\det J = {lever} (D_2 + D_3 c_2 + {letter} c_{{23}}) $$\n" if lever else ""
    assert _verdicts(f"$$ P = \\begin{{bmatrix}} {x} \\\\ {y} \\\\ {z} \\end{{bmatrix}} $$\n{more}")[2:] == [
        Verdict.PROVED
    ] * (1 + bool(more))


@pytest.mark.parametrize("letter", LETTERS)
def test_a_formula_with_a_slip_is_none_that_shows_it(letter: str) -> None:
    x, y, z, lever = (str(each).replace("#", letter) for each in ALONG["x"])
    wrong = f"$$ \\det J = {lever.replace('s_3', 'c_3')} (D_2 + D_3 c_2 + {letter} c_{{23}}) $$\n"
    right = f"$$ P = \\begin{{bmatrix}} {x} \\\\ {y} \\\\ {z} \\end{{bmatrix}} $$\n"
    open_ones = _verdicts(right + wrong)[2:]  # as much speaks against the tool as for it
    assert not {*open_ones} & {Verdict.PROVED, Verdict.REFUTED}
    more = f"$$ x^2 + y^2 = (D_2 + D_3 c_2 + {letter} c_{{23}})^2 $$\n"
    assert _verdicts(right + more + wrong)[2:] == [Verdict.PROVED, Verdict.PROVED, Verdict.REFUTED]
    turned = f"$$ P = \\begin{{bmatrix}} {x} \\\\ {y} \\\\ {z[1:]} \\end{{bmatrix}} $$\n"
    assert not {*_verdicts(turned)[2:]} & {Verdict.PROVED, Verdict.CONFIRMED, Verdict.DEFINED}


def _verdicts(body: str) -> list[Verdict]:
    return [each.verdict for each in check_document(parse_document(Path("arm.md"), f"{TABLE}\n{body}")).equations]
