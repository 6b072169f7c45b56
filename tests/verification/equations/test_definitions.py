"""Names that get their meaning from the display they stand in: by what they equal, by their place, by a brace."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import DocumentResult

FRONT = {"arm": "planar_2r", "quantities": {"p": {"origin": 2}, "T": {"pose": 2}}}
ROW = r"\begin{bmatrix} X & Y & 0 \end{bmatrix}"
X, Y, ON_X = "X = l_1 c_1 + l_2 c_{12}", "Y = l_1 s_1 + l_2 s_{12}", "Y = l_1 s_1"
SQUARE = "l_1^2 + l_2^2 + 2 l_1 l_2 c_2"


@pytest.mark.parametrize(
    ("displays", "verdicts"),
    [
        # by its place in a matrix: what is known there is checked, and a name stands for one value
        ([f"{ROW}^T = p", X, Y, ON_X], "defined proved proved refuted"),
        ([f"p = {ROW}^T", f"X^2 + Y^2 = {SQUARE}"], "defined proved"),
        ([f"p = {ROW}^{{-1}}", ON_X], "unchecked unchecked"),
        (["p = (X, Y, 0)", X, ON_X], "defined proved refuted"),
        (["p = (X, Y, 0)^T", X, ON_X], "defined proved refuted"),
        (["p = (X, Y, 1)^T", X, ON_X], "refuted proved refuted"),
        (["p = (X, X, 0)^T"], "refuted"),
        (["p - p = (X, X, 0)^T", "X = 0"], "defined proved"),
        (["p = (X, Y + u, 0)^T", ON_X], "unchecked unchecked"),
        (["p = (X, Y, Z)^T", "Z = 0", "Z = 1"], "defined proved refuted"),
        (["p = (X, Y)^T"], "unchecked"),
        # by its block
        ([r"T = \begin{bmatrix} R & d \\ 0 & 1 \end{bmatrix}", "d = p", "R^T R = I", "R^T R = 2 I"], "defined proved proved refuted"),
        ([r"T = \begin{bmatrix} R & d \\ 1 & 1 \end{bmatrix}"], "refuted"),
        # by its square
        ([f"k^2 = {SQUARE}", "p^T p = k^2", "k^2 = l_1^2"], "defined proved refuted"),
        # by the label of a brace
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{m} + 2 l_1 l_2 c_2", "p^T p = m + 2 l_1 l_2 c_2", "m = l_1^2"], "proved proved refuted"),
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{l_1^2} + 2 l_1 l_2 c_2"], "refuted"),
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{l_2^2 + l_1^2} + 2 l_1 l_2 c_2"], "proved"),
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{u + w} + 2 l_1 l_2 c_2"], "unchecked"),
        # by nothing that is known
        (["u = v + w", "a = b", "u + v = w + x", "u = l_1"], "unchecked unchecked unchecked unchecked"),
    ],
    ids=lambda part: part[0] if isinstance(part, list) else "",
)  # fmt: skip
def test_a_name_means_what_its_display_gives_it(
    check: Callable[..., DocumentResult], displays: list[str], verdicts: str
) -> None:
    assert " ".join(record.verdict.value for record in check(*displays, **FRONT).equations) == verdicts


def test_a_wrong_entry_is_marked_and_a_wrong_block_is_said(check: Callable[..., DocumentResult]) -> None:
    entry, twice, block = check(
        "p = (X, Y, 1)^T", "p = (U, U, 0)^T", r"T = \begin{bmatrix} R & d \\ 1 & 1 \end{bmatrix}", **FRONT
    ).equations
    assert [(e.row, e.column, e.correct) for e in entry.entries] == [(3, 1, "0")]
    assert [(e.row, e.column, e.printed) for e in twice.entries] == [(2, 1, "U")]
    assert block.message == "a block differs" and not block.entries
