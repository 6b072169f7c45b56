"""Markdown as it is found: formulas without dollars, macros, pictures of equations, and LaTeX in the rows of an arm."""

import time
from pathlib import Path

import pytest

from armproof.verification.check import verify_text
from armproof.verification.document import parse_document
from armproof.verification.document.formula_links import formulas_in_html
from armproof.verification.document.markdown import read_markdown
from armproof.verification.document.model import Display
from armproof.verification.document.sentences import PROSE

FRONT = r"""---
arm: {dh: classic, rows: [{a: l_1, alpha: 0, d: 0, theta: theta_1}, {a: l_2, alpha: 0, d: 0, theta: theta_2}]}
quantities: {p_x: {origin: 2, component: x}, p_y: {origin: 2, component: y}}
---
"""
FORMS = {
    "GitHub's dollars": "Words.\n\n$`p_x = <>`$\n",
    "GitHub's dollars behind a number": "Words.\n\nIV. $`p_x = <>`$\n",
    "GitHub's dollars before others": "Words.\n\n$`p_x = <>`$ et\n",
    "behind a number": "Words.\n\n(2) $p_x = <>$\n",
    "a fence": "Words\n```math\np_x = <>\n```\n",
    "brackets": "Words\n\\[\np_x = <>\n\\]\nand words\n",
    "double brackets": "Words\n\n\\\\[ p_x = <> \\\\]\n",
    "an environment": "Words\n\\begin{equation}\np_x = <>\n\\end{equation}\nwords\n",
    "several lines": "> \\begin{align*}\n> p_x &= <> \\\\\n> p_y &= l_1 s_1 + l_2 s_{12}\n> \\end{align*}\n",
    "under words, with a blank line": "Words:\n$$\np_x = <> \\\\\n\np_y = l_1 s_1 + l_2 s_{12}\n$$\u200b\nand words\n",
    "a tab of MkDocs": '=== "Python"\n\n    Words.\n\n    $$ p_x = <> $$\n\nWords.\n',
    "a box of MkDocs": '!!! note "On the tool"\n    Words.\n\n    $$\n    p_x = <>\n    $$\n',
    "a box within a tab": '=== "One"\n\n    ??? note\n\n        Words.\n\n        $$ p_x = <> $$\n',
    "an item of a list": "Words:\n\n1. $p_x = <>$\n2. $l_1 = 2$\n",
    "macros": "$\\def\\C#1{\\cos\\theta_{#1}}\\newcommand{\\x}{p_x}$\n\n$$ \\x = <> + \\C1 - c_1 $$\n",
}


def found_in(text: str) -> list[Display]:
    """Return what a text holds but the marks for words between."""
    return [each for each in read_markdown(text, 1)[0] if each.latex != PROSE]


@pytest.mark.parametrize("form", FORMS)
def test_a_display_is_found_in_every_form_and_a_false_twin_refuted(form: str):
    for right, verdict in (("l_1 c_1 + l_2 c_{12}", "proved"), ("l_1 c_1 - l_2 c_{12}", "refuted")):
        records = verify_text(FRONT + FORMS[form].replace("<>", right)).equations
        assert [record.verdict.value for record in records] == [verdict]


def test_the_places_of_displays_without_dollars_are_known():
    text = "Words\n\\[\n1 = 1\n\\]\n> \\begin{align}\n> 2 &= 2\n> \\end{align}\n\n$`3 = 3`$\n"
    displays = found_in(text)
    lines = text.split("\n")
    assert [display.line for display in displays] == [2, 5, 9]
    for display in displays:
        assert display.pieces
        for piece in display.pieces:
            part = display.latex[piece.at : piece.at + piece.length]
            assert lines[piece.line - 1][piece.column :].startswith(part)


NONE = ["```\n\\[ 1 = 1 \\]\n```\n", "    \\[ 1 = 1 \\]\n", "\\[link\\](x) and \\[1\\] too\n", "`\\begin{equation}`\n", "\\begin{tikzpicture}\n\\end{tikzpicture}\n",
        "\\begin{equation}\n1 = 1\n\nnever ends\n", "text $`a`$ and $`b = c`$\n", "Give $`b = c`$\n", "a) $b = 2$\n"]  # fmt: skip


@pytest.mark.parametrize("text", NONE)
def test_what_is_no_display_is_none(text: str):
    assert parse_document(Path("page.md"), text).displays == ()


def test_displays_in_a_paragraph_pair_as_they_are_written():
    text = "Here $$ a\n= 1\n$$ and\n$$\nb = 2\n\n= 2\n$$\u200b\nwords\n\n$$ c = 3\n$$\nwords, $$ d = 4 $$ and\n\n$$ e = 5 $$\n"
    displays = found_in(text)
    assert [" ".join(display.latex.split()) for display in displays] == [
        "a = 1",
        "b = 2 = 2",
        "c = 3",
        "d = 4",
        "e = 5",
    ]
    assert all(display.closed for display in displays)
    displays = found_in("Words\n$$\na = 1\n$$$$\nb = 2\n$$\nwords\n\n$$\nc = 3 \\\n$$\n")
    assert [" ".join(display.latex.split()) for display in displays] == ["a = 1", "b = 2", "c = 3 \\"]
    open_one, other = found_in("Words\n$$\na = 1\n\nwords\n\nwords\n")[0], "a = 1"
    assert not open_one.closed and other in open_one.latex


def test_the_end_of_a_row_begins_no_display():
    (display,), _ = read_markdown("$$\n\\begin{aligned}\na &= 1\n\\\\[1ex]\nb &= [2\n\\\\]\n\\end{aligned}\n$$\n", 1)
    assert "\\\\[1ex]" in display.latex


@pytest.mark.parametrize(
    "text", ["\\begin{equation}\n" * 3000, "\\[ a\n" * 3000 + "\\]", "> \\[ x\n" * 2000, "a\n$$\nx\n" * 2000]
)
def test_nothing_takes_long(text: str):
    started = time.process_time()
    read_markdown(text, 1)
    assert time.process_time() - started < 2


PICTURES = [
    (
        "![eq](https://latex.codecogs.com/svg.latex?x=1) and ![Equation 3](a.png)\n\n![x](eq_2.png)",
        ["2 equations are images"],
    ),
    ('<img src="https://render.githubusercontent.com/render/mathml?x">', ["1 equation is an image"]),
    ('<img src="https://render.githubusercontent.com/render/math?math=x">', []),
    ("![robot](arm.png) and ![](frequency.png) $$ 1 = 1 $$", []),
]


@pytest.mark.parametrize(("text", "told"), PICTURES)
def test_pictures_of_equations_are_counted(text: str, told: list[str]):
    assert [str(remark).split(":")[0] for remark in parse_document(Path("page.md"), text).remarks] == told


def test_a_picture_stands_on_its_line():
    picture = '<img src="https://latex.codecogs.com/svg.image?x=1">'
    assert [*formulas_in_html(f"\n<p>\n{picture}")] == [(2, "x=1", True)]
    assert [*formulas_in_html(f"\nwords {picture}")] == [(1, "x=1", False)]


ADDRESSES = {
    "codecogs": '<img src="https://latex.codecogs.com/gif.latex?\\inline&space;p_x&space;=&space;<>"/>',
    "codecogs, in a paragraph": '<p align="center">\n<img src="https://latex.codecogs.com/svg.image?p_x=<>" title="it" />\n</p>',
    "codecogs, in Markdown": "![formula](https://latex.codecogs.com/png.latex?\\dpi{150}p_x=<>)",
    "GitHub": "Words:\n\n![](https://render.githubusercontent.com/render/math?mode=display&math=p_x=<>)\n\nwords",
    "Zhihu": '<img src="https://www.zhihu.com/equation?tex=p_x%3D<>" alt="it" class="ee_img tr_noresize">',
}


@pytest.mark.parametrize("form", ADDRESSES)
def test_a_picture_that_has_its_latex_in_its_address_is_a_display(form: str):
    for sign, verdict in (("&plus;" if "codecogs" in form else "%2B", "proved"), ("-", "refuted")):
        text = ADDRESSES[form].replace("<>", f"l_1c_1{sign}l_2c_{{12}}")
        (record,) = verify_text(f"{FRONT}{text}\n").equations
        assert record.verdict.value == verdict


def test_a_picture_within_text_or_of_one_letter_is_no_display():
    link = "https://latex.codecogs.com/gif.latex?"
    text = f'with <img src="{link}p_x=1"/> here\n\n<img src="{link}p_x"/>\n\n| x | ![]({link}a_1) |\n|--|--|\n| $$a = 1$$ | $$0$$ |\n'
    displays = found_in(text)
    assert [each.latex for each in displays if each.opening != "$"] == ["a = 1"]
    assert [each.latex for each in displays if each.opening == "$"] == ["p_x=1", "p_x", "a_1"]


ROWS = {
    "flow": "arm: {dh: classic, rows: [{a: l_{1}, alpha: 0, d: 0, theta: \\theta_{1} - \\frac{\\pi}{2}}, {a: a_{4e2}, alpha: 0, d: -120 mm, theta: \\theta_2^*}], joints: [\\theta_1, \\theta_2]}",
    "block": "arm:\n  dh: classic\n  rows:\n    - {a: l_1, alpha: 0, d: 0, theta: '\\theta_1 - \\frac{\\pi}{2}'}\n    - a: a_{4e2}\n      alpha: 0^\\circ\n      d: -12 cm\n      theta: \"\\theta_2\"",
}  # fmt: skip


@pytest.mark.parametrize("rows", ROWS)
def test_rows_of_an_arm_may_be_written_in_latex(rows: str):
    front = (
        f"---\n{ROWS[rows]}\nquantities: {{p_x: {{origin: 2, component: x}}, p_z: {{origin: 2, component: z}}}}\n---\n"
    )
    body = "$$ p_x = l_1 s_1 {} a_{{4e2}} s_{{12}} $$\n\n$$ p_z = {} $$\n"
    assert [r.verdict.value for r in verify_text(front + body.format("+", "-0.12")).equations] == ["proved", "proved"]
    assert [r.verdict.value for r in verify_text(front + body.format("-", "0.12")).equations] == [
        "refuted",
        "refuted",
    ]


@pytest.mark.parametrize("name", ["aligned", "gathered", "split"])
def test_an_inner_environment_alone_is_a_display(name: str):
    body = f"\\begin{{{name}}}\nx &= l_1 c_1 {{}} l_2 c_{{12}}\n\\end{{{name}}}\n"
    front = "---\narm: planar_2r\n---\n\n"
    found = [verify_text(front + body.replace("{}", sign)).equations for sign in "+-"]
    assert [[record.verdict.value for record in each] for each in found] == [["proved"], ["refuted"]]


def test_formulas_alone_in_a_paragraph_are_displays():
    front = "---\narm: planar_2r\n---\n\n"
    body = "Words with $l_1 = a$ in them.\n\n$p_x = l_1 c_1 {} l_2 c_{{12}}$.\n$p_y = l_1 s_1 + l_2 s_{{12}}$\n\n- $l_1 = 2$\n\n$\\theta_1$\n"
    found = [verify_text(front + body.format(sign)).equations for sign in "+-"]
    assert [[record.verdict.value for record in each] for each in found] == [
        ["proved", "proved"],
        ["refuted", "proved"],
    ]
    assert [record.line for record in found[0]] == [7, 8]
