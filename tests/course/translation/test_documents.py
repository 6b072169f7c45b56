"""A document in another language: its prose is the catalogue's, all else the source's, on the same lines."""

from pathlib import Path

import pytest

from armproof.course.sources.places import COURSE
from armproof.course.translation.documents import translated
from armproof.course.translation.markdown import segments, translated_markdown
from armproof.verification.document import Display, parse_document
from armproof.verification.document.prose import read_prose

DOCUMENTS = [*COURSE.sources(), *sorted((COURSE.root / "handouts").glob("*.md"))]
MARKDOWN = """# A title

Frame $i$ of `arm` [here](a.md) is
turned by $90°$, and

$$ x = 1 $$

> **Erratum** (as printed)
> $$ x = 2 $$

| joint | $a_i$ | what it does |
|---|---|---|
| 1 | $a_1$ | it turns $x$ \\| $y$ |

- one
  and two
- $x$
"""
WORDS = ["A title", "Frame {1} of {2} [here]({3}) is turned by {4}, and", "**Erratum** (as printed)", "joint", "what it does",
         "it turns {1} | {2}", "one and two"]  # fmt: skip


def foreign(text: str) -> str:
    return " ".join(word if "{" in word or word[:1] in "*[" else f"{word}ö" for word in text.split(" "))


def test_prose_is_found_with_placeholders_and_without_displays_and_formulas():
    assert [segment.prose.text for segment in segments(MARKDOWN)] == WORDS


def test_a_translated_text_differs_in_its_prose_alone():
    made = translated_markdown(MARKDOWN, foreign)
    assert made.replace("ö", "").split() == MARKDOWN.split() and made.count("ö") > 15
    assert made.count("\n") == MARKDOWN.count("\n")


def test_a_longer_translation_keeps_the_number_of_lines_and_opens_no_block():
    long = "Ce que dit {1} - + 1. # > de {2} [ici]({3}) - - - - - - - - - - - - - - - - {4} et"
    made = translated_markdown(MARKDOWN, lambda text: long if text == WORDS[1] else text)
    assert made.count("\n") == MARKDOWN.count("\n")
    assert [segment.prose.text for segment in segments(made)][1] == long


def test_braces_of_the_author_are_no_placeholders():
    prose = read_prose("joint {i-1} to {2}")
    assert prose.text == "joint {i-1} to {1}" and prose.filled(prose.text) == "joint {i-1} to {2}"


def equations_of(display: Display) -> list[str]:
    """Return what the text before a display says in formulas: the words for a posture are those of the language."""
    return [latex for latex in display.said if not latex.startswith(r"\text{")]


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.stem)
def test_displays_and_tables_of_formulas_are_the_same_in_every_language(path: Path):
    text = path.read_text(encoding="utf-8")
    source, made = parse_document(path, text), parse_document(path, translated(path, text, foreign, "fr"))
    assert [display.latex for display in made.displays] == [display.latex for display in source.displays]
    assert [display.line for display in made.displays] == [display.line for display in source.displays]
    assert [equations_of(display) for display in made.displays] == [
        equations_of(display) for display in source.displays
    ]
    assert [table.line for table in made.tables] == [table.line for table in source.tables]
    assert translated(path, text, str, "fr").replace(', lang="fr"', "") == text
