"""LaTeX and reStructuredText on paper: the displays that were checked, the words between them, nothing dropped unsaid."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from armproof.course.errors import PrintError
from armproof.course.printing.printing import render
from armproof.course.printing.tex import tex_body
from armproof.course.sheet.model import (
    Blank,
    Display,
    Heading,
    Listed,
    Listing,
    Picture,
    Quote,
    Sheet,
    Table,
    plain,
    walk,
)
from armproof.verification.document import read_document

POSE = r"p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}"
WRONG = POSE.replace("l_2 S", "l_1 S")
ONE = r"\cos^2\theta_1 + \sin^2\theta_1 = 1"
TEX = rf"""% ---
% arm: planar_2r
% source: A test
% figures: []
% ---
\documentclass{{article}}
\newcommand{{\arm}}[1]{{\textbf{{#1}}}}
\newcommand{{\so}}{{\sin}}
\title{{Le mod\`ele du \arm{{bras}}}}
\begin{{document}}
\maketitle
\section{{\'Enonc\'e}}
Un \arm{{bras}} de longueurs $l_1$ et~$l_2$ -- voir \emph{{la figure}}, 50\% des points\footnote{{au plus}}. % unseen
\begin{{enumerate}}
  \item Calculer \texttt{{p\_2}} :
    \begin{{equation}}\label{{eq:p_2}}
      {POSE}
    \end{{equation}}
  \item Par \eqref{{eq:p_2}} :
    \[ \cos^2\theta_1 + \so^2\theta_1 = 1 \]
\end{{enumerate}}
\begin{{erratum}}[page 3]
  $$ {WRONG} $$
\end{{erratum}}
\subsection*{{Solution}}
\begin{{align}}
  x &= l_1 C_1 + l_2 C_{{12}} \\
  y &= l_1 S_1 + l_2 S_{{12}}
\end{{align}}
\section{{Table}}
\begin{{tabular}}{{|c|c|c|c|c|}} \hline
$i$ & $a_i$ & $\alpha_i$ & $d_i$ & $\theta_i$ \\ \hline
1 & $l_1$ & 0 & 0 & $\theta_1$ \\
2 & $l_2$ & 0 & 0 & $\theta_2$ \\ \hline
\end{{tabular}}
\begin{{verbatim}}
x = 1  % kept
\end{{verbatim}}
\end{{document}}
"""
RST = rf"""
Le modèle du *bras*
===================

:arm: planar_2r
:source: A test
:figures: []

Un **bras** de longueur :math:`l_1`, ``p_2``, voir :eq:`pose`.

Énoncé
------

1. Calculer

   .. math::
      :label: pose

      {POSE}

2. Par :eq:`pose`

.. math:: {ONE}

.. erratum:: page 3

   .. math:: {WRONG}

Solution
--------

.. math::

   {ONE.replace("1", "2", 2)}

   {ONE}

Table
-----

===  ===========
i    :math:`d_i`
===  ===========
1    0
===  ===========

.. code-block:: python

   x = 1  # kept
"""


@pytest.fixture(params=["tex", "rst"])
def path(request: pytest.FixtureRequest, document) -> Path:
    if request.param == "rst":
        pytest.importorskip("docutils", reason="the extra 'print' is not installed")
    return document(TEX if request.param == "tex" else RST, name=f"sheet.{request.param}", front="")


def blocks(sheet: Sheet, kind: type) -> list:
    return [block for block in walk(sheet.blocks) if isinstance(block, kind)]


def test_a_sheet_has_the_displays_of_its_document_in_their_order_and_numbered(path, make):
    shown = blocks(make(path, solutions=True), Display)
    inline = [display.latex for display in read_document(path).displays if display.opening == "$"]
    assert [block.record.latex for block in shown] == [
        display.latex for display in read_document(path).displays if display.latex not in inline
    ]
    assert [block.number for block in shown if not block.record.erratum] == [str(k + 1) for k in range(len(shown) - 1)]


def test_title_sections_lists_tables_and_code_are_what_they_are_in_the_document(path, make):
    sheet = make(path, solutions=True)
    assert plain(sheet.title) == "Le modèle du bras" and plain(sheet.source) == "A test"
    assert [plain(heading.parts) for heading in blocks(sheet, Heading)] == ["Énoncé", "Solution", "Table"]
    assert [len(listing.items) for listing in blocks(sheet, Listing) if listing.start] == [2]
    assert len(blocks(sheet, Table)[0].header) in (2, 5) and "kept" in blocks(sheet, Listed)[0].text
    page = re.sub(r"<[^>]*>", "", render(sheet, "html").decode())
    assert re.search(r"[Pp]ar \(1\)", page) and "p_2" in page and "unseen" not in page
    assert not re.search(r"\\[a-z]+|\*\*|:math:|\$", page)


def test_solutions_and_errata_are_the_teachers(path, make):
    students, teachers = make(path), make(path, solutions=True)
    assert len(blocks(students, Blank)) == 1 and not blocks(teachers, Blank)
    assert [quote.kind for quote in blocks(students, Quote)] == ["erratum"]
    assert [block.record.erratum for block in blocks(students, Display)].count(True) == 0
    assert [block.record.erratum for block in blocks(teachers, Display)].count(True) == 1


def test_what_is_wrong_is_not_printed(path, make):
    path.write_text(path.read_text(encoding="utf-8").replace(POSE, WRONG), encoding="utf-8")
    with pytest.raises(PrintError, match="does not pass, so it is not printed"):
        make(path)


def test_it_is_typeset(path, pdf_text):
    text = pdf_text(path, solutions=True)
    assert "Énoncé" in text and re.search(r"\d equations proved against Drake", text)


def test_a_table_of_latex_is_printed_with_its_verdict(document, make):
    path = document(TEX.replace("2 & $l_2$", "2 & $l_1$"), name="sheet.tex", front="")
    table = blocks(make(path, draft=True), Table)[0]
    assert table.record is not None and table.record.verdict.value == "refuted"
    right = blocks(make(document(TEX, name="right.tex", front=""), draft=True), Table)[0]
    assert right.record is not None and right.record.verdict.value == "proved"


def latex(body: str, tmp_path: Path, expected: int = 0) -> str:
    read = tex_body(tmp_path / "x.tex", body)
    assert len(read.warnings) == expected, read.warnings
    return read.text


@pytest.mark.parametrize(
    ("words", "markdown"),
    [
        (r"{\bf all} \textit{so} \underline{u}", "**all** *so* u"),
        (r"\c{c}a \^\i\ le cr\`eme na\"{\i}ve \oe uf", "ça î le crème naïve œuf"),
        (r"\og mot \fg{} et ``two''--three", "«\u00a0mot\u00a0» et “two”–three"),
        (r"a\_b 3\% \#1 x*y <z> [w]", r"a\_b 3% \#1 x\*y \<z\> \[w\]"),
        (r"\href{https://x.org/a_b}{here} \url{https://x.org}", "[here](<https://x.org/a_b>) <https://x.org>"),
        (r"\noindent\vspace{3mm}Words\label{x} \hspace*{1cm}on", "Words on"),
        (r"1. not a list", r"1\. not a list"),
        (r"from \ref{b} and \eqref{a_1}", r"from \ref{b} and \eqref{a_1}"),
        (r"costs \$5 and $x$", r"costs \$5 and $x$"),
        (r"code \verb|a_$b$| here", "code `a_$b$` here"),
        ("\\begin{itemize}\\item one\\item two\\end{itemize}", "- one\n\n- two"),
        ("\\begin{verbatim}\n$x = 1$\n\\end{verbatim}", "```\n$x = 1$\n```"),
    ],
)
def test_words_of_latex_are_words(words: str, markdown: str, tmp_path):
    assert latex(words, tmp_path).strip() == markdown


def test_a_reference_to_a_section_is_its_title_and_one_to_something_else_stays(tmp_path):
    body = "See \\ref{s} and \\ref{f}.\n\n\\section{The arm}\\label{s}\n\\begin{figure}\\label{f}\\caption{Words}\\end{figure}"
    assert "See “The arm” and \\ref{f}." in latex(body, tmp_path)


def test_an_unknown_command_keeps_its_words_and_is_named_once(tmp_path):
    assert "kept too" in latex(r"\foo{kept} \foo{too}", tmp_path, expected=1).replace("  ", " ")
    assert (
        tex_body(tmp_path / "x.tex", "\n\n\\foo{kept}")
        .warnings[0]
        .endswith(r"x.tex:3: '\foo' is not printed; the words in its braces are")
    )


def test_a_drawing_is_left_out_and_said_to_be(tmp_path):
    drawn = "Before\n\\begin{tikzpicture}\\draw (0,0) -- (1,1);\\end{tikzpicture}\nafter"
    assert "draw" not in latex(drawn, tmp_path, expected=1)
    assert "after" in latex(drawn, tmp_path, expected=1)


def test_a_figure_has_its_caption_and_a_theorem_its_name(document, make, tmp_path):
    from tests.course.printing.test_reading import PIXEL

    (tmp_path / "arm.png").write_bytes(PIXEL)
    body = r"\begin{figure}[h]\centering\includegraphics[width=3cm]{arm}\caption{The \emph{arm}}\end{figure}" + "\n"
    body += r"\begin{theorem}[Of the elbow] It bends. \end{theorem}"
    sheet = make(document(body, name="sheet.tex", front=""))
    assert [(block.path.name, plain(block.caption)) for block in blocks(sheet, Picture)] == [("arm.png", "The arm")]
    assert "Of the elbow" in render(sheet, "html").decode()


def test_what_docutils_does_not_know_is_a_quote_and_files_are_not_included(document, make):
    pytest.importorskip("docutils", reason="the extra 'print' is not installed")
    body = f".. theorem:: Of one\n   :label: t\n\n   .. math:: {ONE}\n\n.. include:: /etc/passwd\n\n.. raw:: html\n\n   <script>\n"
    sheet = make(document(body, name="sheet.rst", front=""))
    assert len(blocks(sheet, Display)) == 1 and "Of one" in render(sheet, "html").decode()
    assert len(sheet.warnings) == 2 and "sheet.rst:6" in sheet.warnings[0]
    page = render(sheet, "html").decode()
    assert "root:" not in page and "<script" not in page


def test_without_docutils_it_is_said_what_to_install(document, make, monkeypatch):
    monkeypatch.setattr("armproof.course.printing.document.find_spec", lambda name: None)
    with pytest.raises(PrintError, match=r"pip install 'armproof\[print\]'"):
        make(document("Words.\n", name="sheet.rst", front=""))


@pytest.mark.parametrize("name", ["sheet.tex", "sheet.rst"])
def test_what_is_nested_too_deeply_is_an_error_with_a_message(name: str, document, make):
    pytest.importorskip("docutils", reason="the extra 'print' is not installed")
    deep = "{" * 3000 if name.endswith("tex") else "\n\n".join(" " * k + "- x" for k in range(0, 600, 2))
    with pytest.raises(PrintError, match="nested too deeply"):
        make(document(deep, name=name, front=""))
    shallow = "{" * 30 + "x" + "}" * 30 if name.endswith("tex") else "- x\n\n  - y\n"
    assert make(document(shallow, name=name, front="")).blocks
