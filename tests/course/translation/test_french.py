"""The course in French: the same displays with the same verdicts, the listed terms, and no English words on its pages."""

import re
from functools import cache
from html import unescape
from pathlib import Path

import pytest

from armproof.course.feedback import open_lesson
from armproof.course.printing.document import Edition, make_sheet
from armproof.course.printing.printing import write_html
from armproof.course.sources.editions import student_notebook
from armproof.course.sources.lesson_source import read_lesson_source
from armproof.course.sources.places import COURSE
from armproof.course.translation.documents import translated
from armproof.models.language import use
from armproof.verification.check import check_document
from armproof.verification.document import parse_document, read_document
from armproof.verification.document.catalogue import translation_of
from armproof.verification.verdict import DocumentResult, Verdict
from tests.translations.catalogues import problems
from tests.translations.documents import DOCUMENTS, catalogue_of, said_in
from tests.translations.terms import misused, misused_in, read_terms, terms_file

ENGLISH = re.compile(r"\b(?:the|of|and|to|is|that|it|for|with|are|be|by|this|from|which|not|its|your|you|has|have)\b")
KR210 = COURSE.root / "handouts" / "kr210-001.md"


def french(path: Path) -> str:
    return translated(path, path.read_text(encoding="utf-8"), translation_of(path, "fr"), "fr")


@cache
def checked(path: Path) -> DocumentResult:
    return check_document(read_document(path), confirm=False)


def verdicts(result: DocumentResult) -> list[tuple[int, Verdict, bool]]:
    return [(record.line, record.verdict, record.erratum) for record in (*result.equations, *result.tables)]


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.stem)
def test_a_french_document_has_the_displays_and_the_verdicts_of_its_source(path: Path) -> None:
    source, made = read_document(path), parse_document(path, french(path))
    assert [display.latex for display in made.displays] == [display.latex for display in source.displays]
    assert verdicts(check_document(made, confirm=False)) == verdicts(checked(path))


def test_a_wrong_number_under_french_heads_is_refuted() -> None:
    wrong = french(KR210).replace("| joint_2 | link_1 | link_2 | 0.35 |", "| joint_2 | link_1 | link_2 | 0.53 |")
    assert wrong != french(KR210)
    tables = check_document(parse_document(KR210, wrong), confirm=False).tables
    assert [table.verdict for table in tables].count(Verdict.REFUTED) == 1


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.stem)
def test_a_french_sheet_holds_hardly_an_english_word(path: Path, tmp_path: Path) -> None:
    if path.suffix == ".md":
        sheet = make_sheet(read_document(path), checked(path), Edition(True, True, "fr"), tmp_path)
        page = re.sub(r"<(style|math|svg|code)\b.*?</\1>", " ", write_html(sheet), flags=re.DOTALL)
        text = unescape(re.sub(r"<[^>]+>", " ", page))
    else:
        with use("fr"):
            text = student_notebook(read_lesson_source(path, "fr")).decode()
        text = re.sub(r"from [\w.]+ import|`[^`]*`", " ", text)
    words = re.findall(r"[^\W\d_]+", text)
    assert len(ENGLISH.findall(text)) < 0.005 * len(words)


def test_english_words_are_counted() -> None:
    assert len(ENGLISH.findall("The pose of the tool is that of frame 2")) == 5


def test_a_lesson_in_french_speaks_french() -> None:
    lesson = open_lesson("frames", lang="fr")
    assert lesson.title != open_lesson("frames", lang="en").title
    assert str(lesson.predict.check([0, 2, 0])).startswith("✓ predict\u00a0: juste (démontré)")
    assert lesson.predict.check("0 ; 2,0 ; 0").is_right and not lesson.predict.check("0 ; 2,5 ; 0").is_right
    wrong = lesson.predict.check([2, 0, 0])
    assert not ENGLISH.search(wrong.message) and wrong.message
    assert "Indication 1 sur 3" in str(lesson.predict.hint())
    assert str(open_lesson("frames", lang="en").predict.check([0, 2, 0])).startswith("✓ predict: correct (proved)")


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.stem)
def test_a_catalogue_translates_its_document_with_the_listed_terms(path: Path) -> None:
    catalogue = catalogue_of(path, "fr")
    assert problems(catalogue, "fr", said_in(path)) == []
    assert misused_in(catalogue, "fr") == []


def test_another_term_than_the_listed_one_is_found() -> None:
    terms = read_terms(terms_file("fr"))
    assert len(terms) >= 150
    assert list(misused(terms, "The joint turns about its axis", "Le joint tourne autour de son axe"))
    assert list(misused(terms, "a Jacobian", "un jacobien"))
    assert not list(
        misused(terms, "The joints turn about their axes", "Les articulations tournent autour de leurs axes")
    )
    assert not list(misused(terms, "a Jacobian", "une jacobienne"))
