"""LaTeX, reStructuredText, Quarto and MyST: every display once, at its line, with its mark, its section and its place."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import armproof.course
from armproof.verification.check import check_document, verify
from armproof.verification.document import Display, Document, find_documents, parse_document, read_document
from armproof.verification.document.rewriting import change_of, rewrite
from armproof.verification.document.sentences import FROM_VALUES
from armproof.verification.errors import DocumentError
from armproof.verification.verdict import Verdict

HANDOUTS = find_documents([Path(armproof.course.__path__[0]) / "handouts"])

# A block with its display k (False: what looks like one and is not), and whether it is an erratum.
TEX = {
    "prose": ("Some prose with $a_{k}$, $b$$c$ and 100\\% of it\\\\[2mm] here.", False, False),
    "dollars": ("$$ a_{k} = 1 $$", True, False),
    "dollars on lines": ("It follows\n$$\na_{k}\n= 1\n$$ at once.", True, False),
    "brackets": ("\\[ a_{k} = 1 \\]", True, False),
    "equation": ("\\begin{equation}\\label{eq:{k}}\n  a_{k} = 1\n\\end{equation}", True, False),
    "equation*": ("\\begin{equation*}\na_{k} = 1\n\\end{equation*}", True, False),
    "align": ("\\begin{align}\n  a_{k} &= 1 \\nonumber\n\\end{align}", True, False),
    "align*": ("\\begin{align*} a_{k} &= 1 \\end{align*}", True, False),
    "alignat": ("\\begin{alignat}{2} a_{k} &= 1 \\end{alignat}", True, False),
    "gather": ("\\begin{gather}\na_{k} = 1\n\\end{gather}", True, False),
    "eqnarray": ("\\begin{eqnarray} a_{k} &=& 1 \\end{eqnarray}", True, False),
    "macro": ("\\begin{equation} \\eqs{a_{k}}{\\one} \\end{equation}", True, False),
    "environment by macro": ("\\be a_{k} = 1 \\ee", True, False),
    "comment behind": ("\\[ a_{k} % \\[ and } {\n  = 1 % $$\n\\]", True, False),
    "in a list": ("\\begin{itemize}\\item so \\[ a_{k} = 1 \\]\\end{itemize}", True, False),
    "comment": ("% \\[ a_{k} = 1 \\]", False, False),
    "verbatim": ("\\begin{verbatim}\n\\[ a_{k} = 1 \\]\n\\end{verbatim}", False, False),
    "verb": ("\\verb|$$ a_{k} = 1 $$| is its source", False, False),
    "section": ("\\section{Part {k}}", False, False),
    "erratum": ("\\begin{erratum}[slide 3]\n\\[ a_{k} = 1 \\]\n\\end{erratum}", True, True),
    "quoted erratum": ("\\begin{quote}\\textbf{Erratum} (as printed)\n\\[ a_{k} = 1 \\]\\end{quote}", True, True),
    "titled erratum": ("\\begin{tcolorbox}[title=Erratum]\n\\[ a_{k} = 1 \\]\n\\end{tcolorbox}", True, True),
    "marked erratum": ("% Erratum, as printed\n\\[ a_{k} = 1 \\]", True, True),
    "no erratum": ("\\begin{quote} An erratum looks so:\n\\[ a_{k} = 1 \\]\\end{quote}", True, False),
}  # fmt: skip
PREAMBLE = (
    "\\documentclass{article}\n\\newcommand{\\one}{1}\n\\newcommand{\\eqs}[2]{#1 = #2}\n"
    "\\newcommand{\\be}{\\begin{equation}}\n\\def\\ee{\\end{equation}}\n\\begin{document}\n"
)
RST = {
    "prose": ("Prose with :math:`a_{k} = 1` and $$ in it.", False, False),
    "block": (".. math::\n\n   a_{k} = 1", True, False),
    "argument": (".. math:: a_{k} = 1", True, False),
    "options": (".. math::\n   :label: eq-{k}\n   :nowrap:\n\n   a_{k}\n   = 1", True, False),
    "at once": (".. math::\n   a_{k} = 1", True, False),
    "in a list": ("- first\n\n  .. math::\n\n     a_{k} = 1", True, False),
    "comment": ("..\n   .. math:: a_{k} = 1", False, False),
    "code": (".. code-block:: rst\n\n   .. math:: a_{k} = 1", False, False),
    "literal": ("As in::\n\n  .. math:: a_{k} = 1", False, False),
    "section": ("Part {k}\n--------", False, False),
    "note": (".. note:: Remember\n\n   .. math:: a_{k} = 1", True, False),
    "erratum": (".. admonition:: Erratum (as printed)\n\n   .. math:: a_{k} = 1", True, True),
    "own erratum": (".. erratum::\n\n   .. math::\n\n      a_{k} = 1", True, True),
    "quoted erratum": ("As follows.\n\n  **Erratum** (slide 3)\n\n  .. math:: a_{k} = 1", True, True),
}  # fmt: skip
MYST = {
    "prose": ("Prose with {math}`a_{k} = 1` in it.", False, False),
    "dollars": ("$$ a_{k} = 1 $$ (eq-{k})", True, False),
    "quarto label": ("$$\na_{k} = 1\n$$ {#eq-{k}}", True, False),
    "fence": ("```{math}\na_{k} = 1\n```", True, False),
    "fence with options": ("```{math}\n:label: eq-{k}\n\na_{k}\n= 1\n```", True, False),
    "fence with yaml": ("```{math}\n---\nlabel: eq-{k}\n---\na_{k} = 1\n```", True, False),
    "colon fence": (":::{math}\na_{k} = 1\n:::", True, False),
    "code": ("```{code-cell} python\n'$$ a_{k} = 1 $$'\n```", False, False),
    "executable": ("```{python}\n# $$ a_{k} = 1 $$\n```", False, False),
    "callout": ("::: {.callout-note}\nSo $$ a_{k} = 1 $$\n:::", True, False),
    "admonition": ("````{admonition} Note\n```{math}\na_{k} = 1\n```\n````", True, False),
    "erratum": (":::{admonition} Erratum\n:class: warning\n$$ a_{k} = 1 $$\n:::", True, True),
    "quarto erratum": ("::: {.callout-warning}\n## Erratum\n\n$$ a_{k} = 1 $$\n:::", True, True),
    "div of errata": ("::: {.erratum}\n$$\na_{k} = 1\n$$\n:::", True, True),
    "erratum in a fence": ("````{admonition} Erratum\n```{math}\na_{k} = 1\n```\n````", True, True),
}  # fmt: skip
DISPLAY_MARKS = re.compile(
    r"\$\$|\\\[|\\begin\{(?:equation|align|alignat|gather|eqnarray)\*?\}|\\be |\.\. math::|```\{math\}|:::\{math\}"
)


def assert_found(
    text: str, blocks: dict[str, tuple[str, bool, bool]], names: list[str], name: str, newline: str
) -> None:
    """Every block's display is found once, at its line, with its mark, and at its place in the text."""
    expected = []
    for k, block_name in enumerate(names):
        block, holds_display, erratum = blocks[block_name]
        if holds_display:
            opening = DISPLAY_MARKS.search(block)
            assert opening is not None
            expected.append((text.count("\n") + 1 + block[: opening.start()].count("\n"), f"a_{{{k}}}=1", erratum))
        text += block.replace("{k}", f"{{{k}}}") + "\n\n"
    text = text.replace("\n", newline)
    document = parse_document(Path(name), text)
    found = [
        (d.line, re.sub(r"\s|&|\\label\{[^}]*\}\}?|\\nonumber", "", d.latex), d.erratum) for d in document.displays
    ]
    assert found == expected
    for display in document.displays:
        pieces = "".join(display.latex[p.at : p.at + p.length] for p in display.pieces)
        assert "".join(pieces.split()) == "".join(display.latex.split())
        at = display.latex.rindex("1", 0, display.latex.index("=") + 6)
        change = change_of(display, at, at + 1, "2", in_notebook=False)
        assert change is not None
        changed = parse_document(Path(name), rewrite(Path(name).suffix, text, [change])).displays
        assert [d.latex.split() for d in changed] == [
            (d.latex[:at] + "2" + d.latex[at + 1 :] if d is display else d.latex).split() for d in document.displays
        ]


@given(st.lists(st.sampled_from(sorted(TEX)), max_size=8), st.sampled_from(["\n", "\r\n"]))
def test_every_display_of_latex_is_found(names: list[str], newline: str) -> None:
    assert_found(PREAMBLE, TEX, names, "page.tex", newline)


@given(st.lists(st.sampled_from(sorted(RST)), max_size=8), st.sampled_from(["\n", "\r\n"]))
def test_every_display_of_restructured_text_is_found(names: list[str], newline: str) -> None:
    assert_found("Title\n=====\n\n", RST, names, "page.rst", newline)


@given(st.lists(st.sampled_from(sorted(MYST)), max_size=8), st.sampled_from(["page.md", "page.qmd"]))
def test_every_display_of_quarto_and_myst_is_found(names: list[str], name: str) -> None:
    assert_found("# Title\n\n", MYST, names, name, "\n")


# -- front matter ------------------------------------------------------------------------------------------------------

FRONTS = {
    "fenced.tex": "% !TEX root = main.tex\n% ---\n% arm: scara\n% quantities:\n%   p_e: {origin: 4}\n% ---\n\\[ 1 = 1 \\]\n",
    "bare.tex": "% arm: scara\n% quantities:\n%   p_e: {origin: 4}\n\\documentclass{article}\n\\[ 1 = 1 \\]\n",
    "after.tex": "%%\n%% A course.\n%%\n%% arm: scara\n%% quantities: {p_e: {origin: 4}}\n\n\\[ 1 = 1 \\]\n",
    "comment.rst": "..\n   arm: scara\n   quantities:\n     p_e: {origin: 4}\n\nTitle\n=====\n\n.. math:: 1 = 1\n",
    "fenced.rst": "..\n  ---\n  arm: scara\n  quantities:\n    p_e: {origin: 4}\n  ---\n\n.. math:: 1 = 1\n",
    "fields.rst": ":arm: scara\n:quantities: {p_e: {origin: 4}}\n\n.. math:: 1 = 1\n",
    "titled.rst": "Title\n=====\n\n:arm: scara\n:quantities:\n    p_e: {origin: 4}\n\n.. math:: 1 = 1\n",
    "ruled.rst": "=====\nTitle\n=====\n:arm: scara\n:quantities: {p_e: {origin: 4}}\n\n.. math:: 1 = 1\n",
    "page.qmd": "---\narm: scara\nquantities:\n  p_e: {origin: 4}\nexecute:\n  echo: false\n---\n$$ 1 = 1 $$\n",
}  # fmt: skip


@pytest.mark.parametrize("name", FRONTS)
def test_front_matter_is_read_in_every_format(name: str) -> None:
    document = parse_document(Path(name), FRONTS[name])
    front = {key: value for key, value in document.front.items() if key != "execute"}
    assert front == {"arm": "scara", "quantities": {"p_e": {"origin": 4}}}
    for key in ("arm", "quantities"):
        line = FRONTS[name].splitlines()[document.lines[key] - 1]
        assert re.match(rf"\W*{key}\W", line), (key, line)
    assert len(document.displays) == 1


@pytest.mark.parametrize(
    ("name", "text", "line"),
    [
        ("page.tex", "% ---\n% arm: scara\n% arm: x\n% ---\n", 3),
        ("page.tex", "\n% arm: scara\n% quantities: {\n", 3),
        ("page.tex", "% ---\n% arm: scara\n\\[ 1 = 1 \\]\n", 1),
        ("page.rst", "..\n   arm: scara\n   quantities: {\n", 3),
        ("page.rst", "Title\n=====\n\n:arm: scara\n:quantities: {\n", 5),
    ],
)
def test_a_fault_in_front_matter_is_told_with_its_line(name: str, text: str, line: int) -> None:
    with pytest.raises(DocumentError, match=rf"^{re.escape(name)}:{line}: "):
        parse_document(Path(name), text)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("page.tex", "% A comment: not ours.\n\\[ 1 = 1 \\]\n"),
        ("page.rst", ".. A comment: not ours.\n\n.. math:: 1 = 1\n"),
        ("page.rst", ".. note:: arm\n\n.. math:: 1 = 1\n"),
        ("page.rst", "Title\n=====\n\nText.\n\n.. math:: 1 = 1\n"),
    ],
)
def test_other_comments_are_no_front_matter(name: str, text: str) -> None:
    document = parse_document(Path(name), text)
    assert document.front == {} and len(document.displays) == 1


# -- LaTeX -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "line", "opening"),
    [
        ("\\[ 1 = 1\n\nMore.", 1, "\\["),
        ("x\n\\begin{equation}\n1 = 1\n", 2, "\\begin{equation}"),
        ("\\begin{align} 1 &= 1 \\end{align*}", 1, "\\begin{align}"),
        ("\\[ 1 = 1 \\begin{equation}", 1, "\\["),
        ("\\[ 1\n\n\\[ 2 = 2 \\]", 1, "\\["),
        ("$$ 1 = 1", 1, "$$"),
        ("\\newcommand{\\be}{\\begin{equation}}\n\\be 1 = 1", 2, "\\be"),
    ],
)
def test_an_environment_that_is_never_closed_is_unreadable_at_its_line(text: str, line: int, opening: str) -> None:
    document = parse_document(Path("page.tex"), text)
    first = document.displays[0]
    assert (first.line, first.closed, first.opening) == (line, False, opening)
    record = check_document(document).equations[0]
    assert (record.verdict, record.message) == (Verdict.UNREADABLE, f"the display opened by {opening} never ends")


def test_a_macro_stands_for_its_body() -> None:
    macros = r"\newcommand*{\cs}[1]{\cos\theta_{#1}}\newcommand\s[2][1]{s_{#1#2}}\def\l#1{l_#1}\DeclareMathOperator{\rk}{rank}"
    text = macros + "\n" + r"\[ \l1 \cs{1} + \cs{12} x + \s{2} + \s[3]{4} + \cs2c_1 = \rk J \]"
    [display] = parse_document(Path("page.tex"), text).displays
    assert (
        re.sub(r"\s+", " ", display.latex).strip()
        == r"l_1 \cos\theta_{1} + \cos\theta_{12} x + s_{12} + s_{34} + \cos\theta_{2}c_1 = \operatorname{rank}J"
    )


def test_a_macro_is_what_it_was_defined_to_be_before_and_in_its_group() -> None:
    text = r"\newcommand{\x}{a}\[ \x = 1 \]\renewcommand{\x}{b}\[ \x = 2 \]{\def\x{c}\[ \x = 3 \]}\providecommand{\x}{d}\[ \x = 4 \]"
    displays = parse_document(Path("page.tex"), text).displays
    assert [display.latex.strip() for display in displays] == ["a= 1", "b= 2", "c= 3", "b= 4"]


@pytest.mark.parametrize("macros", [r"\newcommand{\x}{\x}", r"\def\x{\y\y}\def\y{\x\x}", r"\newcommand{\x}[2]{#1}"])
def test_a_macro_without_end_is_left_as_it_stands(macros: str) -> None:
    [display] = parse_document(Path("page.tex"), macros + r"\[ a = \x \]").displays
    assert display.latex.strip() == r"a = \x"


def test_a_macro_is_corrected_as_a_whole_or_not_at_all() -> None:
    text = "\\newcommand{\\two}{1 + 1}\n\\[ a = \\two \\]\n"
    [display] = parse_document(Path("page.tex"), text).displays
    at = display.latex.index("1 + 1")
    assert change_of(display, at, at + 1, "2", in_notebook=False) is None
    change = change_of(display, at, at + 5, "3", in_notebook=False)
    assert change is not None
    assert rewrite(".tex", text, [change]) == text.replace("\\two \\]", "3 \\]")


HIDDEN_IN_TEX = {
    "a branch": r"\if0 \[ b \] \fi \[ a \]",
    "the other branch": r"\iftrue \[ a \] \else \[ b \] \fi",
    "one within another": r"\iffalse \ifnum1=2 x\fi \[ b \] \fi \[ a \]",
    "a switch": r"\newif\ifold \ifold \[ b \] \fi \oldtrue \ifold \[ a \] \fi",
    "a switch that is set in a branch that does not print": r"\newif\ifold \iffalse \oldtrue \fi \ifold \[ b \] \else \[ a \] \fi",
    "numbers": r"\ifnum 1 > 2 \[ b \] \else \[ a \] \fi",
    "the argument of a macro": r"\newcommand{\hide}[1]{} \hide{\[ b \]} \[ a \]",
    "one of two arguments": r"\providecommand{\first}[2]{#1} \first{\[ a \]}{\[ b \]}",
    "an environment that is excluded": r"\excludecomment{old} \begin{old} \[ b \] \end{old} \[ a \]",
    "an equivalence is no conditional": r"\iffalse $b \iff c$ \[ b \] \fi \[ a \]",
}


@pytest.mark.parametrize("text", HIDDEN_IN_TEX.values(), ids=[*HIDDEN_IN_TEX])
def test_what_tex_does_not_print_is_no_display(text: str) -> None:
    [display] = [each for each in parse_document(Path("page.tex"), text).displays if each.opening == "\\["]
    assert (display.latex.strip(), display.may_not_print) == ("a", False)


@pytest.mark.parametrize(
    "text",
    [
        r"\ifdefined\x \[ a \] \else \[ b \] \fi",
        r"\newif\ifold \ifx\a\b \oldtrue \fi \ifold \[ a \] \else \[ b \] \fi",
    ],
)
def test_what_may_not_be_printed_is_not_decided(text: str) -> None:
    displays = parse_document(Path("page.tex"), text).displays
    assert [(display.latex.strip(), display.may_not_print) for display in displays] == [("a", True), ("b", True)]
    page = "% arm: planar_2r\n\\ifdefined\\x\n\\[ D = l_2 \\]\n\\fi\n\\[ x = l_1 c_1 + D c_{12} \\]\n"
    records = check_document(parse_document(Path("page.tex"), page)).equations
    assert {record.verdict for record in records} == {Verdict.UNCHECKED}


HIDDEN_IN_MARKDOWN = {
    "an element": "<div class='a' hidden>\n\n<div>\n\n$$ b $$\n\n</div>\n\n$$ b $$\n\n</div>",
    "a style": '<p style="color: red; display: none">\n\n$$ b $$\n\n</p>',
    "lines of MyST": "% $$\n% b\n% $$",
    "Obsidian": "%%\n$$ b $$\n\n$$ b $$\n%%",
    "Jekyll": "{% comment %}\n$$ b $$\n{% endcomment %}",
    "Hugo": "{{% comment %}}\n$$ b $$\n{{% /comment %}}",
    "a tag of Jekyll": "{% include figure.html\n    src=site.arm\n    width='50%' %}",
    "an output of Liquid": "{{ page.title | escape }}",
    "a shortcode of Hugo": '{{< figure src="arm.png" title="The arm, wrong" >}}',
    "Quarto": "::: {.content-hidden}\n\n$$ b $$\n\n:::",
}


@pytest.mark.parametrize("hidden", HIDDEN_IN_MARKDOWN.values(), ids=[*HIDDEN_IN_MARKDOWN])
def test_what_markdown_does_not_show_is_no_display(hidden: str) -> None:
    text = f"$$ a $$\n\n{hidden}\n\n$$ c $$\n"
    displays = parse_document(Path("page.md"), text).displays
    assert [(display.latex.strip(), display.line) for display in displays] == [
        ("a", 1),
        ("c", 5 + hidden.count("\n")),
    ]


def test_a_tag_is_no_sentence_beside_a_display() -> None:
    front = "---\narm: planar_2r\n---\n\n"
    claim = "$$ x = l_1 \\cos\\theta_1 + l_2 \\cos(\\theta_1 + \\theta_2) $$\n"
    told = [
        check_document(parse_document(Path("page.md"), f"{front}{before}\n\n{claim}")).equations[-1].verdict
        for before in ("{% include drawing.html name=wobbly.arm %}", "The drawing glimmers wobbly:")
    ]
    assert told == [Verdict.PROVED, Verdict.UNCHECKED]


@pytest.mark.parametrize(
    "shown",
    [
        "```matlab\n%% One\n```\n\n$$ b $$\n\n```matlab\n%% Two\n```",
        "`%%`\n\n$$ b $$\n\n`%%`",
        "about 50\n% of it is\n\n$$ b $$",
        "<div hidden>\n\n$$ b $$",
        "`<div hidden>`\n\n$$ b $$\n\n</div>",
        "$$\nb %% one\n%% two\n$$",
        "{% raw %}\n\n$$ b $$\n\n{% endraw %}",
        "$$\nb {%\n} + {c%}\n$$",
        "$$\nb + {{c}}\n$$",
    ],
)
def test_what_only_looks_hidden_is_a_display(shown: str) -> None:
    displays = parse_document(Path("page.md"), f"{shown}\n").displays
    assert [display.latex.strip()[:1] for display in displays if display.opening == "$$"] == ["b"]


def test_a_tabular_is_a_table() -> None:
    text = (
        "% arm: planar_2r\n\\section{Bras}\n\\begin{tabular}{c|cccc}\n \\hline $i$ & $a_i$ & $\\alpha_i$ & $d_i$ & $\\theta_i$ \\\\ \\hline\n"
        " 1 & $l_1$ & 0 & 0 & $\\theta_1$ \\\\\n 2 & $l_1$ & 0 & 0 & $\\theta_2$ \\\\ \\hline\n\\end{tabular}\n"
    )
    document = parse_document(Path("page.tex"), text)
    [table] = document.tables
    assert (table.line, table.section, table.header[1], table.rows[1]) == (
        3,
        "Bras",
        "a_i",
        ("2", "l_1", "0", "0", "\\theta_2"),
    )
    [record] = check_document(document).tables
    assert record.verdict is Verdict.REFUTED
    assert record.message.startswith("row 2: a is l_1, should be l_2")


def test_sections_of_latex_and_rst() -> None:
    text = (
        "\\[ 0 = 0 \\]\\section*{The \\emph{first} {one}}\\[ 1 = 1 \\]\n\\subsection[x]{Second --- 2--3}\n\\[ 2 = 2 \\]"
    )
    assert [d.section for d in parse_document(Path("p.tex"), text).displays] == [
        "",
        "The \\emph{first} {one}",
        "Second — 2–3",
    ]
    text = ".. math:: 0 = 0\n\nFirst\n=====\n\n.. math:: 1 = 1\n\n------\nÉtude\n------\n\n.. math:: 2 = 2\n"
    assert [d.section for d in parse_document(Path("p.rst"), text).displays] == ["", "First", "Étude"]


def test_equations_of_one_block_with_blank_lines_between_are_several() -> None:
    text = ".. math::\n\n   a = 1\n\n   b = \\begin{bmatrix} 1 \\\\\n\n   2 \\end{bmatrix}\n"
    displays = parse_document(Path("page.rst"), text).displays
    assert [(d.line, d.latex) for d in displays] == [(1, "a = 1"), (5, "b = \\begin{bmatrix} 1 \\\\\n2 \\end{bmatrix}")]


# -- the handouts, in other formats ------------------------------------------------------------------------------------


def as_tex(document: Document) -> str:
    """Write a handout's front matter and displays as LaTeX, in one environment after the other."""
    front = document.path.read_text(encoding="utf-8").split("---\n")[1]
    text = "% ---\n" + "".join(f"% {line}\n" for line in front.splitlines()) + "% ---\n\\begin{document}\n"
    around = (
        ("\\[", "\\]"),
        ("$$", "$$"),
        *((f"\\begin{{{e}}}", f"\\end{{{e}}}") for e in ("equation", "align*", "gather")),
    )
    for k, display in enumerate(document.displays):
        opening, closing = around[k % len(around)]
        block = f"{opening}\n{display.latex.strip()} % as printed\n{closing}\n"
        text += f"\n\\section{{{display.section}}}\n" + (
            f"\\begin{{erratum}}\n{block}\\end{{erratum}}\n" if display.erratum else block
        )
    return text + "\\end{document}\n"


def as_rst(document: Document) -> str:
    front = document.path.read_text(encoding="utf-8").split("---\n")[1]
    text = "..\n" + "".join(f"   {line}\n" for line in front.splitlines()) + "\n"
    for display in document.displays:
        lines = [line for line in display.latex.strip().splitlines() if line.strip()]
        block = ".. math::\n\n" + "".join(f"   {line}\n" for line in lines)
        if display.erratum:
            block = ".. admonition:: Erratum\n\n" + "".join(f"   {line}\n" for line in block.splitlines())
        text += f"\n{block}\n"
    return text


@pytest.mark.parametrize("path", HANDOUTS[::3], ids=[path.stem for path in HANDOUTS[::3]])
@pytest.mark.parametrize("write", [as_tex, as_rst])
def test_a_handout_in_another_format_has_the_same_verdicts(path: Path, write, tmp_path: Path) -> None:
    document = read_document(path)
    copy = tmp_path / f"page.{write.__name__[3:]}"
    copy.write_text(write(document), encoding="utf-8")
    original = check_document(Document(path, document.front, document.displays, ()), confirm=False)
    result = verify(copy, confirm=False)
    assert [(r.verdict, r.erratum) for r in result.equations] == [(r.verdict, r.erratum) for r in original.equations]


def test_a_folder_holds_documents_of_every_format(tmp_path: Path) -> None:
    texts = {"a.tex": "\\[ 1 = 1 \\]", "b.rst": ".. math:: 1 = 1", "c.qmd": "$$ 1 = 1 $$", "d.md": "```{math}\n1 = 1\n```",
             "e.tex": "% arm: scara\n", "n.tex": "No formula.", "n.rst": "None.", "n.qmd": "None."}  # fmt: skip
    for name, text in texts.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    assert [path.name for path in find_documents([tmp_path])] == ["a.tex", "b.rst", "c.qmd", "d.md", "e.tex"]


def test_the_name_of_a_format_may_be_in_capitals(tmp_path: Path) -> None:
    path = tmp_path / "README.TEX"
    path.write_text("% arm: planar_2r\n\\[ z_1 = (0, 0, 1)^T \\]\n")
    assert find_documents([path]) == find_documents([tmp_path]) == [path]
    [display] = read_document(path).displays
    assert display.line == 2


def test_an_unreadable_token_is_told_with_its_line_in_the_file() -> None:
    text = "x\n\\begin{equation} % the first\n  a = 1 + \n  2 } \n\\end{equation}\n"
    [record] = check_document(parse_document(Path("page.tex"), text)).equations
    assert record.message.startswith("line 4, column 5 of the display: ")


def places(display: Display) -> list[tuple[int, int]]:
    return [(piece.line, piece.column) for piece in display.pieces]


def test_the_places_of_a_display_are_those_of_the_file() -> None:
    text = "So\n\\begin{equation} a\n   = 1 % x\n\\end{equation}"
    [display] = parse_document(Path("page.tex"), text).displays
    assert places(display) == [(2, 16), (3, 0)]
    [display] = parse_document(Path("page.md"), "> > So $$ a\n> > = 1 $$ here").displays
    assert places(display) == [(1, 10), (2, 4)]


# -- what the text between displays says -----------------------------------------------------------------------------------

STATED = r"l_1 = 0.4, \quad l_2 = 0.3, \quad \theta_1 = 0, \quad \theta_2 = 0"
PLACE = r"p_2 = \begin{bmatrix} 0.9 \\ 0 \\ 0 \end{bmatrix}"
SAID_IN = {
    ".md": "---\narm: planar_2r\n---\n$$ %s $$\n\nFor $%s$:\n\n$$ %s $$\n",
    ".tex": "%% arm: planar_2r\n\\[ %s \\]\nFor \\(%s\\):\n\\[ %s \\]\n",
    ".rst": ":arm: planar_2r\n\n.. math:: %s\n\nFor :math:`%s`:\n\n.. math:: %s\n",
    ".py": "# %%%% [markdown]\n# ---\n# arm: planar_2r\n# ---\n# $$ %s $$\n#\n# For $%s$:\n\n# %%%% [markdown]\n# $$ %s $$\n",
}


@pytest.mark.parametrize("suffix", SAID_IN)
@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        (r"\theta_1 = \frac{\pi}{2}", Verdict.UNCHECKED),
        (r"q = (\frac{\pi}{2}, 0)", Verdict.UNCHECKED),
        (r"l_1 = 0.6", Verdict.CONFIRMED),  # 0.6 + 0.3
        (r"l_1 = 0.7", Verdict.UNCHECKED),
        (r"\theta_1 \approx 1.57", Verdict.UNCHECKED),
        (r"\theta_1 = }", Verdict.UNCHECKED),
        (r"P_x = l_1 c_1", Verdict.REFUTED),
        (r"\theta_1", Verdict.REFUTED),
    ],
)
def test_numbers_are_not_judged_at_values_that_the_text_replaces(suffix: str, said: str, verdict: Verdict) -> None:
    document = parse_document(Path(f"page{suffix}"), SAID_IN[suffix] % (STATED, said, PLACE))
    heard = [tuple(each for each in display.said if each != FROM_VALUES) for display in document.displays]
    assert heard == [(), (said,) if said != r"\theta_1" else ()]
    assert check_document(document).equations[-1].verdict is verdict


@pytest.mark.parametrize("suffix", [".md", ".tex", ".rst"])
@pytest.mark.parametrize(
    ("said", "claim", "verdict"),
    [
        (r"\theta_2 = \frac{\pi}{2}", r"\det J = l_1 l_2", Verdict.PROVED),
        (r"\theta_2 = \frac{\pi}{2}", r"\det J = l_1^2", Verdict.REFUTED),
        (r"c_2 = 1", r"p_2 = [(l_1 + l_2) c_1, (l_1 + l_2) s_1, 0]^T", Verdict.PROVED),
        (r"\theta_1 + \theta_2 = \pi", r"p_2 = [l_1 c_1 - l_2, l_1 s_1, 0]^T", Verdict.PROVED),
        (r"l_1 = l_2", r"\det J = l_1^2 s_2", Verdict.PROVED),
    ],
)
def test_what_holds_at_values_that_lead_to_it_is_proved(suffix: str, said: str, claim: str, verdict: Verdict) -> None:
    document = parse_document(Path(f"page{suffix}"), SAID_IN[suffix] % (r"s_{12} = s_{12}", said, claim))
    assert check_document(document).equations[-1].verdict is verdict


@pytest.mark.parametrize("suffix", SAID_IN)
@pytest.mark.parametrize(
    ("said", "claim", "verdict"),
    [
        (r"\theta_2 = \frac{\pi}{2}", r"\det J = -l_1 l_2", Verdict.REFUTED),
        (r"\theta_2 = 0", r"\det J = l_1 l_2", Verdict.REFUTED),
        (r"P_x = 0.5", r"\det J = l_1 l_2", Verdict.REFUTED),
        (r"\theta_2 = k\pi", r"\det J = l_1 l_2", Verdict.REFUTED),
        (r"\theta_2 = \frac{\pi}{2}", r"\det J = l_1 l_2 s_2", Verdict.PROVED),
        (r"c_2 = 1", r"p_2 = [(l_1 - l_2) c_1, (l_1 - l_2) s_1, 0]^T", Verdict.REFUTED),
        (r"\theta_1 + \theta_2 = \pi", r"p_2 = [l_1 c_1 + l_2, l_1 s_1, 0]^T", Verdict.REFUTED),
        (r"l_1 = l_2", r"\det J = l_1^2 c_2", Verdict.REFUTED),
        (r"c_{12} = c_1 c_2 - s_1 s_2", r"\det J = l_1 l_2", Verdict.REFUTED),
    ],
)
def test_what_holds_at_the_values_of_the_text_is_not_refuted(
    suffix: str, said: str, claim: str, verdict: Verdict
) -> None:
    document = parse_document(Path(f"page{suffix}"), SAID_IN[suffix] % (r"s_{12} = s_{12}", said, claim))
    assert check_document(document).equations[-1].verdict is verdict


@pytest.mark.parametrize("suffix", SAID_IN)
@pytest.mark.parametrize(
    ("words", "claim", "verdict"),
    [
        ("the arm stretched out along $x_0$", r"p_2 = [l_1 + l_2, 0, 0]^T", Verdict.UNCHECKED),
        ("le bras tendu", PLACE, Verdict.UNCHECKED),
        ("the tool at the origin", r"p_2 = 0", Verdict.UNCHECKED),
        ("the arm stretched out", r"\det J = l_1 l_2 c_2", Verdict.REFUTED),
        ("the arm of the figure", PLACE, Verdict.REFUTED),
        ("the straightforward case", PLACE, Verdict.REFUTED),
    ],
)
def test_what_may_hold_in_a_posture_that_the_text_names_is_not_refuted(
    suffix: str, words: str, claim: str, verdict: Verdict
) -> None:
    page = SAID_IN[suffix].replace(r"\(%s\)", "%s").replace(":math:`%s`", "%s").replace("For $%s$", "For %s")
    document = parse_document(Path(f"page{suffix}"), page % (STATED, words.replace("$", ""), claim))
    assert check_document(document).equations[-1].verdict is verdict


def test_a_line_of_rst_that_holds_an_equation_alone_is_a_display() -> None:
    front = "..\n   arm: planar_2r\n\n"
    body = "| :math:`p_x` = :math:`l_1 c_1 {} l_2 c_{{12}}`\n\n:math:`p_y = l_1 s_1 + l_2 s_{{12}}`.\n\nWords with :math:`l_1 = a`.\n"
    found = [check_document(parse_document(Path("a.rst"), front + body.format(sign))).equations for sign in "+-"]
    assert [[record.verdict.value for record in each] for each in found] == [
        ["proved", "proved"],
        ["refuted", "proved"],
    ]


def test_an_equation_of_rst_goes_on_behind_its_sign_of_equality(tmp_path: Path) -> None:
    text = ".. math::\n\n   a =\n\n   = b\n\n   c = d\n\n   e =\n\n   f\n"
    (tmp_path / "sheet.rst").write_text(text)
    assert [(each.line, each.latex.split()) for each in read_document(tmp_path / "sheet.rst").displays] == [
        (1, ["a", "=", "b"]),
        (7, ["c", "=", "d"]),
        (9, ["e", "=", "f"]),
    ]
