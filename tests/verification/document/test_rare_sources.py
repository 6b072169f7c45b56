"""What stands rarely in a source: every display is found at its line all the same, and keeps its verdict."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.document import parse_document
from armproof.verification.document.cells import percent_cells
from armproof.verification.document.model import Words
from armproof.verification.document.tex import read_parts
from armproof.verification.document.tex_tables import tabular_cells

TEX = "% ---\n% arm: planar_2r\n% ---\n"
PERCENT = "# %% [markdown]\n# ---\n# arm: planar_2r\n# ---\n\n"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.tex", TEX + r"\newcommand{\by}{\cdot}" + "\n$$ l_1 \\by c_1 = l_1 c_1 $$\n$$ l_1 \\by c_1 = l_1 s_1 $$\n"),
        ("a.tex", TEX + r"\newcommand{\by}{\cdot" + "\n$$ l_1 c_1 = l_1 c_1 $$\n$$ l_1 c_1 = l_1 s_1 $$\n"),  # never closed
        ("a.tex", TEX + r"\newcommand{\by}[1]{\cdot#1}" + "\n$$ l_1 \\by{c_1} = l_1 c_1 $$\n$$ l_1 \\by{c_1} = l_1 s_1 $$\n"),
        ("a.tex", TEX + "\\iffalse\n$$ c_1 = s_2 $$\n\\fi\n$$ c_1 = c_1 $$\n\\iffalse x \\else\n$$ c_1 = s_1 $$\n\\fi\n"),
        ("a.rst", ":arm: planar_2r\n\n.. math::\n   c_1 = c_1\n\n   c_1 = s_1\n"),
        ("a.py", PERCENT + "# %% [markdown]\n\n\n# $$ c_1 = c_1 $$\n#\n# $$ c_1 = s_1 $$\n"),
        ("a.py", PERCENT + "# %% [markdown] tags=[1,]\n# $$ c_1 = c_1 $$\n\n# %% [markdown]\n# $$ c_1 = s_1 $$\n"),
    ],
)  # fmt: skip
def test_a_rare_source_hides_no_display(name: str, text: str) -> None:
    records = verify_text(text, path=name).equations
    assert [record.verdict.value for record in records] == ["proved", "refuted"]
    rows = text.split("\n")
    assert ["= " in rows[record.line - 1] or "math" in rows[record.line - 1] for record in records] == [True, True]


@pytest.mark.parametrize("name", ["a.tex", "a.md", "a.rst"])
def test_a_display_may_begin_the_file_and_end_it(name: str) -> None:
    text = {"a.tex": "$$x = 1$$", "a.md": "$$x = 1$$", "a.rst": ".. math:: x = 1"}[name]
    for before in ("", "\n", "\n\n"):
        [display] = parse_document(Path(name), before + text).displays
        assert (display.line, display.latex.strip()) == (1 + len(before), "x = 1")


def test_the_cells_of_a_program_know_the_lines_of_their_markers_and_texts() -> None:
    text = "# %% [markdown]\n\n# one\n\n# %%\nx = 1\n\n\n# %% A title [raw]\n# two\n"
    found = [(cell.kind, cell.marker, cell.line, cell.text) for cell in percent_cells(text)]
    assert found == [("markdown", 1, 3, "one"), ("code", 5, 6, "x = 1"), ("raw", 9, 10, "two")]


PARTS = r"""\newcommand{\arm}{planar arm}\newcommand{\one}{l_1}
\title{The {planar} arm}
\begin{document}
The \arm{} is % not a \arm
shown by \verb|$$|.
\[ x = \one c_1 \]
So $y = 2$ and
\begin{verbatim}
\arm \[ no display \]
\end{verbatim}
a table
\begin{tabular}{cc} 1 & 2 \\ 3 & 4 \end{tabular}, and
\begin{equation} z = 0 \end{equation} end.
\end{document}
behind"""


def test_words_and_displays_make_up_a_latex_file() -> None:
    parts = [
        (part.line, " ".join((part.text if isinstance(part, Words) else f"[{part.latex}]").split()))
        for part in read_parts(Path("a.tex"), PARTS.replace("\n", "\r\n"))
    ]
    assert [part for part in parts if part[1]] == [
        (2, r"\title{The {planar} arm}"),
        (3, r"The planar arm{} is shown by \verb|$$|."),
        (6, "[ x = l_1c_1 ]"),
        (6, "So $y = 2$ and"),
        (8, r"\begin{verbatim} \arm \[ no display \] \end{verbatim}"),
        (10, "a table"),
        (12, r"\begin{tabular}{cc} 1 & 2 \\ 3 & 4 \end{tabular}"),
        (12, ", and"),
        (13, "[ z = 0 ]"),
        (13, "end."),
    ]


def test_the_title_of_a_piece_of_a_document_stands_where_it_stands() -> None:
    """What is input into another file has no beginning of its own, before which a title would be."""
    parts = list(read_parts(Path("a.tex"), "\\title{A sheet}\n$$ x = 1 $$\n"))
    assert [part.text.strip() for part in parts if isinstance(part, Words)] == [r"\title{A sheet}", ""]


@pytest.mark.parametrize(
    ("tabular", "cells"),
    [
        (r"\begin{tabular}{|c|c|}\hline 1 & {a & b} \\ \hline \{2 & 3\tabularnewline \\ z\\[2pt]\end{tabular}", [["1", "{a & b}"], [r"\{2", "3"], ["z"]]),
        (r"\begin{tabular}{c}\multicolumn{3}{c}{x} & y \\ \multirow{2}{*}{z} & \end{tabular}", [["{x}", "", "", "y"], ["{z}", ""]]),
        (r"a & b \\ c", [["a", "b"], ["c"]]),
        (r"\begin{tabular*}{c} a} & b \\ \end{tabular*}", [[r"a} & b \\"]]),
    ],
)  # fmt: skip
def test_the_cells_of_a_tabular_are_cut_outside_braces(tabular: str, cells: list[list[str]]) -> None:
    assert tabular_cells(tabular) == cells
