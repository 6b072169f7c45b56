"""Two points side by side are a vector of the arm, unless the document gives the letters values of their own."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import DocumentResult

REACH = r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \\ 0 \end{bmatrix}"


@pytest.mark.parametrize(
    ("displays", "verdicts"),
    [
        ([f"OE = {REACH}"], "proved"),
        ([f"O_0O_2 = {REACH}"], "proved"),
        ([rf"\overrightarrow{{OE}} = {REACH}"], "proved"),
        ([rf"\overrightarrow{{OE}} = {REACH.replace('+', '-', 1)}"], "refuted"),
        ([rf"\overrightarrow{{O'E}} = {REACH}"], "unchecked"),
        ([rf"\overrightarrow{{O\dot E}} = {REACH}"], "unchecked"),
        ([rf"\overrightarrow{{O E^1}} = {REACH}"], "unchecked"),
        ([rf"\overrightarrow{{O_0 A_1}} = {REACH}"], "unchecked"),
        (["OE = l_1 l_2"], "unchecked"),
        (["O = l_1", "E = l_2", "OE = l_1 l_2"], "defined defined proved"),
        (["O = l_1", "E = l_2", "OE = l_1 + l_2"], "defined defined refuted"),
        (["O = l_1", f"OE = {REACH}"], "unchecked unchecked"),
    ],
    ids=lambda part: part[-1] if isinstance(part, list) else "",
)
def test_points_are_a_vector_where_nothing_else_is_meant(
    check: Callable[..., DocumentResult], displays: list[str], verdicts: str
) -> None:
    assert " ".join(record.verdict.value for record in check(*displays, arm="planar_2r").equations) == verdicts
