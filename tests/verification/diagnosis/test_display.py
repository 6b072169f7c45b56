"""A handout whose matrix is wrong as a whole is told the likely mistake, as a function is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]


def matrix(*rows: str) -> str:
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"


ABOVE = r"-a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 & 0", r"a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 & 0"
BELOW = "0 & 0 & 0 & 0", "0 & 0 & 0 & 0", "1 & 1 & 0 & -1"
DISPLAYS: list[tuple[str, str, dict[str, Any]]] = [
    (r"T^0_4 = A^0_1 A^2_3 A^1_2 A^3_4", "", {}),
    (r"T^0_4 = A^3_4 A^2_3 A^1_2 A^0_1", "multiplied in the wrong order, from the last to the first", {}),
    (r"{}^0T_6 = {}^0T_1 \, {}^1T_2 \, {}^2T_3 \, {}^4T_5 \, {}^5T_6", "the link matrix ^3T_4 is missing from the product", {"arm": "rx90"}),
    (r"{}^0T_6 = {}^0T_1 \, {}^1T_2 \, {}^3T_4 \, {}^2T_3 \, {}^4T_5 \, {}^5T_6", "^2T_3 and ^3T_4 are multiplied in the wrong order", {"arm": "rx90"}),
    (r"p_4 = " + matrix(r"(a_1 + a_2) c_{12}", r"(a_1 + a_2) s_{12}", "d_3 - d_4"), "the link matrices take a, α of the row above", {}),
    (r"p_4 = " + matrix(r"(a_1 + a_2) c_{12}", r"(a_1 + a_2) s_{12}", "-d_3 - d_4"), "the link matrices take a of the row above", {}),
    (r"p_6 = " + matrix(r"c_1 (a_3 - d_3 s_{23})", r"s_1 (a_3 - d_3 s_{23})", "d_3 c_{23}"), "the link matrices take a of the row below", {"arm": "rx90"}),
    (r"p_2 = " + matrix(r"a_1 c_1 + a_2 c_2 + a_2", r"a_1 s_1 + a_2 s_2", "0"), "", {}),
    (r"p_3 = " + matrix(r"l_1 s_1 + l_2 s_{12} + l_3 s_{123}", r"-l_1 c_1 - l_2 c_{12} - l_3 c_{123}", "0"), "theta_1 is counted from another zero: off by -π/2", {"arm": "planar_3r"}),
    (r"J = " + matrix(*(row.replace("-1 &", "0 &") for row in ABOVE), "0 & 0 & -1 & 0", "0 & 0 & 0 & 0", "0 & 0 & 0 & 0", r"1 & 1 & 1 & -1"), "", {}),
    (r"J = " + matrix(r"a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 & 0", r"-a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 & 0", "0 & 0 & -1 & 0", *BELOW), "rows 1 and 2, x and y of v, are swapped", {}),
    (r"J = " + matrix(r"-l_1 s_1 - l_2 s_{12} - l_3 s_{123} & -l_2 s_{12} - l_3 s_{123} & -l_3 s_{123}", r"l_1 c_1 + l_2 c_{12} + l_3 c_{123} & l_2 c_{12} + l_3 c_{123} & l_3 c_{123}", "0 & 0 & 0", "0 & 0 & 0", "0 & 0 & 0", "1 & 0 & 0"), "zeros stand in its place, in the angular part of columns 2, 3 alone", {"arm": "planar_3r"}),
    (r"J_v = " + matrix(r"-l_1 s_1 & -l_2 s_{12} & -l_3 s_{123}", r"l_1 c_1 & l_2 c_{12} & l_3 c_{123}", "0 & 0 & 0"), "the chain rule is missing", {"arm": "planar_3r"}),
    (r"J_v = " + matrix(r"a_1 s_1 + a_2 s_{12} & a_2 s_{12} & 0 & 0", r"-a_1 c_1 - a_2 c_{12} & -a_2 c_{12} & 0 & 0", "0 & 0 & -1 & 0"), "the sign of the cross product is wrong", {}),
]  # fmt: skip


@pytest.mark.parametrize(("latex", "words", "front"), DISPLAYS, ids=[str(k) for k in range(len(DISPLAYS))])
def test_the_likely_mistake_is_named(judge: Judge, latex: str, words: str, front: dict[str, Any]) -> None:
    record = judge(latex, **front)
    assert record.verdict in (Verdict.REFUTED, Verdict.PROVED)
    assert words in record.message
    if words:
        assert record.verdict is Verdict.REFUTED
