"""`T_0_1 =` on a line of text, and its matrix in the display below."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.document import parse_document
from armproof.verification.running.corrected_copy import correct_text

HEAD = "---\narm: {dh: classic, rows: [{a: L_1, alpha: 0, d: 0, theta: q_1}, {a: L_2, alpha: 0, d: 0, theta: q_2}]}\ntransforms: upper\n---\n"
LINK = r"""
\[\begin{bmatrix} \cos(q1) & -\sin(q1) & 0 & L1\cos(q1) \\ \sin(q1) & \cos(q1) & 0 & HERE \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}\]
"""


@pytest.mark.parametrize("left", ["T_0_1 =", "T_0_1 =  ", "$T^0_1 =$", "$T_{01}$ =", "- **T_{01} =**"])
@pytest.mark.parametrize(("entry", "verdict"), [(r"L1\sin(q1)", "proved"), (r"L1\cos(q1)", "refuted")])
def test_the_line_above_names_what_the_display_prints(left: str, entry: str, verdict: str) -> None:
    text = f"{HEAD}The first link:\n{left}{LINK.replace('HERE', entry)}"
    assert [record.verdict.value for record in verify_text(text).equations] == [verdict]


def test_what_is_wrong_is_corrected_in_its_place() -> None:
    text = f"{HEAD}T_0_1 ={LINK.replace('HERE', 'L1' + chr(92) + 'cos(q1)')}"
    assert correct_text(Path("a.md"), text).after == f"{HEAD}T_0_1 ={LINK.replace('HERE', 'L1' + chr(92) + 'sin(q1)')}"


@pytest.mark.parametrize(
    "above", ["The matrix is", "This holds for n = 3", "x + y =", "where $a = 3$", "=", "T_0_1 = T"]
)
def test_another_line_names_nothing(above: str) -> None:
    document = parse_document(Path("a.md"), f"{HEAD}{above}{LINK}")
    assert "=" not in document.displays[0].latex


def test_a_display_that_states_something_keeps_to_it() -> None:
    document = parse_document(Path("a.md"), f"T_0_1 =\n$$ A = {LINK.strip()[2:-2]} $$\n")
    assert document.displays[0].latex.strip().startswith("A =")


def test_a_long_line_takes_no_time() -> None:
    parse_document(Path("a.md"), "T" + "_a" * 20_000 + f" = x{LINK}")
