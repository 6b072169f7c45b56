"""The numbers of equations: in order, the same in every edition and language, and what refers to them."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from armproof.course.printing.printing import render
from armproof.course.sheet.model import Display, Quote, Sheet, walk
from armproof.course.sheet.numbers import Numbers

RIGHT = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"
WRONG = RIGHT.replace("l_2 S", "l_1 S")
EQUAL = r"$$ {} = {} $$" + "\n\n"
ERRATUM = "> **Erratum** (slide 3)\n>\n> " + WRONG
HANDOUTS = Path(__file__).resolve().parents[3] / "course" / "handouts"


def numbers(sheet: Sheet) -> list[str]:
    return [block.number for block in walk(sheet.blocks) if isinstance(block, Display)]


def numbered(sheet: Sheet) -> dict[str, str]:
    shown = [block for block in walk(sheet.blocks) if isinstance(block, Display) and not block.record.erratum]
    return {block.number: block.record.latex for block in shown}


def test_equations_are_counted_in_their_order_and_errata_are_not(document, make):
    sheet = make(document(RIGHT + ERRATUM + RIGHT + "- item\n\n  " + RIGHT), solutions=True)
    assert numbers(sheet) == ["1", "", "2", "3"]
    assert next(block for block in walk(sheet.blocks) if isinstance(block, Quote)).kind == "erratum"


@pytest.mark.parametrize("name", ["planar-2r-002", "scara-000"])
def test_an_equation_has_one_number_in_every_edition_and_language(name: str, make, monkeypatch):
    monkeypatch.setattr("armproof.course.printing.document.draw_figures", lambda *_: [])  # they hold no equation
    teachers, students, french = (
        numbered(make(HANDOUTS / f"{name}.md", **edition))
        for edition in ({"solutions": True}, {}, {"solutions": True, "lang": "fr"})
    )
    assert teachers == french and [*teachers] == sorted(teachers, key=int)
    assert 0 < len(students) < len(teachers) and students.items() <= teachers.items()


def test_a_number_of_the_authors_own_stays_and_is_not_given_again(document, make):
    tagged = RIGHT.replace(" $$\n", r" \tag{2} $$" + "\n")
    assert numbers(make(document(RIGHT + tagged + RIGHT))) == ["1", "2", "3"]
    assert numbers(make(document(RIGHT + RIGHT + tagged), draft=True)) == ["1", "3", "2"]


LABELLED = [
    (r"$$ x = x \label{a} $$", r"By \eqref{a} and \ref{a}.", "By (1) and 1."),
    (r"$$ x = x \label{a} $$", r"By $\eqref{a}$.", "By"),
    ("$$ x = x $$ {#eq-a}", "By @eq-a, and so.", "By (1), and so."),
    ("$$ x = x $$ (a)", "By {eq}`a`.", "By (1)."),
    ("```{math}\n:label: a\nx = x\n```", "By {eq}`a`.", "By (1)."),
]


@pytest.mark.parametrize(("display", "words", "expected"), LABELLED)
def test_words_refer_to_an_equation_by_its_number(display: str, words: str, expected: str, document, make):
    page = re.sub(
        r"\s*<[^>]*>\s*", " ", render(make(document(f"{words}\n\n{display}\n\n{RIGHT}"), draft=True), "html").decode()
    )
    assert expected in page and not re.search(r"eqref|@eq|\{eq\}", page)


@pytest.mark.parametrize("words", [r"By \eqref{b}.", "By @eq-b.", "Mail a@eq-a.org."])
def test_a_reference_that_leads_nowhere_stays_as_it_is(words: str, document, make):
    assert words in render(make(document(f"{words}\n\n$$ x = x $$ {{#eq-a}}\n"), draft=True), "html").decode()


def test_a_label_is_that_of_the_display_before_it_in_its_own_cell(document, make, tmp_path):
    cells = [
        {"cell_type": "markdown", "source": "$$ x = x $$\n\n$$ y = y $$ (second)", "metadata": {}},
        {"cell_type": "markdown", "source": "By {eq}`second`, not {eq}`third`.\n\n$$ z = z $$ (third)", "metadata": {}},
    ]
    path = tmp_path / "lesson.ipynb"
    path.write_text(json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}), encoding="utf-8")
    assert "By (2), not (3)." in render(make(path, draft=True), "html").decode()


def test_a_reference_within_a_display_or_code_is_no_words():
    known = Numbers(("1",), {"a": "1"})
    for text in (r"$$ x = y \quad \eqref{a} $$", "```\n\\eqref{a}\n```", r"\begin{align} x &= \eqref{a} \end{align}"):
        assert known.referred(text) == text
    assert known.referred(r"$$ x $$ \eqref{a}") == "$$ x $$ (1)"


def test_a_number_stands_beside_its_formula_on_paper_and_on_the_page(document, make, pdf_text):
    path = document(RIGHT + RIGHT)
    assert re.search(r"\(1\)(?s:.*)\(2\)", pdf_text(path))
    assert render(make(path), "html").decode().count('<span class="tag">') == 2


def test_a_wide_formula_and_its_number_have_room_on_one_line(document, make, pdf_text):
    wide = " + ".join(f"l_1 C_{{{1 if k % 2 else 12}}}" for k in range(60))
    assert "(1)" in pdf_text(document(EQUAL.format(wide, wide)))
