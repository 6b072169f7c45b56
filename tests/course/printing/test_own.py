"""What a sheet adds to its source is marked: the display or table below the comment, or the whole section of a heading."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from armproof.course.printing.printing import render
from armproof.course.sheet.model import Display, Sheet, Table, walk

ONE, TWO = (rf"$$ \cos^2\theta_{k} + \sin^2\theta_{k} = 1 $$" + "\n\n" for k in (1, 2))
OWN = "<!-- own -->\n"
ERRATUM = "> **Erratum** (slide 3)\n> $$ l_1 = l_2 $$\n\n"
TABLE = "| a | b |\n|---|---|\n| 1 | 2 |\n\n"
HANDOUTS = Path(__file__).resolve().parents[3] / "course" / "handouts"


def marks(sheet: Sheet) -> str:
    """Return a sign for each display and table in its order: + for one that is marked."""
    return "".join("+" if block.own else "-" for block in walk(sheet.blocks) if isinstance(block, Display | Table))


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (ONE + TWO, "--"),
        (OWN + ONE + TWO, "+-"),
        (f"Words.\n{OWN}{ONE}{TWO}", "+-"),
        (f"{OWN}Words first.\n\n{ONE}{TWO}", "+-"),
        (f"{OWN}{TABLE}{ONE}", "+-"),
        (f"{OWN}## Ours\n\n{ONE}### Part\n\n{TWO}## The source's\n\n{ONE}", "++-"),
        (f"## Theirs\n\n{ONE}{OWN}### Ours\n\n{TWO}### Theirs again\n\n{ONE}", "-+-"),
        (f"{OWN}## Ours\n\n{ERRATUM}{ONE}", "-+"),
        (f"<!-- owner -->\n{ONE}", "-"),
        (f"`{OWN.strip()}` in code\n\n{ONE}", "-"),
    ],
)
def test_a_mark_is_of_the_next_display_or_of_a_section(body: str, expected: str, document, make):
    sheet = make(document(body), solutions=True, draft=True)
    assert marks(sheet) == expected and sheet.has_own == ("+" in expected)


@pytest.mark.parametrize(("lang", "words"), [("en", "added by the course"), ("fr", "ajouté par le cours")])
def test_a_sheet_with_marks_says_what_they_mean_and_no_other_does(lang: str, words: str, document, make, pdf_text):
    marked, plain = document(OWN + ONE + TWO), document(ONE + TWO, name="plain.md")
    text = re.sub(r"\s+", " ", pdf_text(marked, lang=lang))
    assert words in text and text.count("†") == 2
    assert "†" not in pdf_text(plain, lang=lang)
    page = render(make(marked, lang=lang), "html").decode()
    assert page.count("<abbr title=") == 1 and words in page
    assert "†" not in render(make(plain, lang=lang), "html").decode()


def test_the_mark_stands_in_both_editions_and_prints_nothing_of_the_comment(document, make):
    path = document(f"{OWN}## Ours\n\n{ONE}### Solution\n\n{TWO}")
    assert marks(make(path)) == "+" and marks(make(path, solutions=True)) == "++"
    assert "own --" not in render(make(path), "html").decode() and not make(path).warnings


def test_sheets_of_a_source_mark_what_the_course_adds(make):
    """What the title of a section, or its first words, calls our own is marked, and what a slide shows is not."""
    sheet = make(HANDOUTS / "planar-2r-002.md", solutions=True)
    own = {block.record.section: block.own for block in walk(sheet.blocks) if isinstance(block, Display)}
    assert own["Singular configurations"] and own["The pose and the whole Jacobian"]
    first = next(block for block in walk(sheet.blocks) if isinstance(block, Display))
    assert not first.own and "-" in marks(sheet)


@pytest.mark.parametrize("path", sorted(HANDOUTS.glob("*.md")), ids=lambda path: path.stem)
def test_a_section_that_says_to_be_our_own_is_marked(path: Path):
    """Only a document that is our own as a whole needs no marks."""
    text = path.read_text(encoding="utf-8")
    if "source: Our own" in text:
        assert "<!-- own -->" not in text
        return
    for section in re.split(r"\n(?=(?:\n|<!-- own -->\n)## )", text):
        if re.search(r"^(?:Our own|Not on the slides)", section, re.MULTILINE):
            assert section.startswith("<!-- own -->\n## "), section[:80]
