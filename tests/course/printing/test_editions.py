"""The students' sheet and the edition with solutions; drafts; what stands at the foot."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from armproof.course.errors import PrintError
from armproof.course.printing.document import Edition, make_sheet
from armproof.course.printing.printing import render
from armproof.course.sheet.model import Blank, Display, Heading, Paragraph, Picture, Quote, Sheet, Text, walk
from armproof.course.sheet.proof import proof_line
from armproof.models.errors import LanguageError
from armproof.verification.check import check_document
from armproof.verification.document import read_document
from armproof.verification.verdict import Record, Verdict

RIGHT = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"
WRONG = RIGHT.replace("l_2 S", "l_1 S")
ERRATUM = "".join(f"> {line}\n" for line in ("**Erratum** (slide 3)", WRONG.strip())) + "\n"
HANDOUTS = Path(__file__).resolve().parents[3] / "course" / "handouts"


def displays(sheet) -> list[Display]:
    return [block for block in walk(sheet.blocks) if isinstance(block, Display)]


def titles(sheet) -> list[str]:
    return [
        part.text
        for block in walk(sheet.blocks)
        if isinstance(block, Heading)
        for part in block.parts
        if isinstance(part, Text)
    ]


def records_in(quote: Quote) -> list[Record]:
    return [block.record for block in walk(quote.blocks) if isinstance(block, Display)]


def proof_of(sheet: Sheet) -> str:
    return proof_line(sheet.records, sheet.lang, sheet.arm)


def test_a_document_that_does_not_pass_is_not_printed(document, make):
    with pytest.raises(PrintError, match="does not pass, so it is not printed"):
        make(document(WRONG))


def test_a_draft_of_it_is_and_says_so_on_every_page(document, pdf_text):
    text = pdf_text(document(WRONG + "\n\n".join(["many words"] * 200) + "\n\n" + RIGHT), draft=True)
    assert text.count("DRAFT") == text.count("equation proved") > 1
    assert "refuted" in text


def test_a_document_that_passes_is_no_draft(document, pdf_text):
    text = pdf_text(document(RIGHT))
    assert "DRAFT" not in text and "refuted" not in text
    assert "1 equation proved against Drake by Armproof" in text


def test_the_formulas_of_errata_are_left_out_of_the_students_sheet(document, make):
    path = document(RIGHT + ERRATUM)
    students = make(path)
    assert [display.record.erratum for display in displays(students)] == [False]
    assert [block.kind for block in students.blocks if isinstance(block, Quote)] == ["erratum"]
    assert [display.record.erratum for display in displays(make(path, solutions=True))] == [False, True]


@pytest.mark.parametrize("title", ["Solution", "Solution 2", "Solution: the pose", "Worked solution", "Corrigé"])
def test_a_section_that_is_a_solution_becomes_blank_space(title: str, document, make):
    path = document(f"## Exercise\n\nFind it.\n\n### {title}\n\n{RIGHT}#### Detail\n\nwords\n\n## Next\n\n{RIGHT}")
    students = make(path)
    assert titles(students) == ["Exercise", "Next"]
    assert len(displays(students)) == 1
    assert sum(isinstance(block, Blank) for block in students.blocks) == 1
    teachers = make(path, solutions=True)
    assert len(displays(teachers)) == 2
    assert [block.kind for block in teachers.blocks if isinstance(block, Quote)] == ["solution"]


def test_a_block_quote_that_begins_with_solution_is_one(document, make):
    path = document("Find it.\n\n> **Solution**\n> " + RIGHT)
    assert [type(block) for block in make(path).blocks][-1] is Blank
    assert len(displays(make(path, solutions=True))) == 1


@pytest.mark.parametrize("title", ["How many solutions", "Solution set of the system", "Is the solution unique?"])
def test_a_section_about_solutions_is_none(title: str, document, make):
    assert len(displays(make(document(f"## {title}\n\n{RIGHT}")))) == 1


def test_the_space_for_a_solution_stands_on_the_page_of_its_question(document, make):
    path = document(f"Read.\n\nFind it.\n\n## Solution\n\n{RIGHT}")
    for solutions in (False, True):
        other, question = [block for block in make(path, solutions=solutions).blocks if isinstance(block, Paragraph)]
        assert question.leads and not other.leads


@pytest.mark.parametrize("name", ["scara-000", "scara-004", "spatial-rrr-002", "planar-3r-002"])
def test_the_solutions_of_the_exercises_are_on_the_teachers_sheet_only(name: str, tmp_path):
    read = read_document(HANDOUTS / f"{name}.md")
    read.front["figures"] = []
    result = check_document(read, confirm=False)
    students, teachers = (make_sheet(read, result, Edition(solutions=flag), tmp_path) for flag in (False, True))
    count = len(re.findall(r"^#+ Solution$", (HANDOUTS / f"{name}.md").read_text(encoding="utf-8"), re.MULTILINE))
    assert titles(teachers).count("Solution") == count >= 3
    assert "Solution" not in titles(students)
    assert sum(isinstance(block, Blank) for block in students.blocks) == count
    hidden = [
        record
        for block in teachers.blocks
        if isinstance(block, Quote) and block.kind == "solution"
        for record in records_in(block)
    ]
    assert len(hidden) > len(teachers.records) / 2
    assert not {id(record) for record in hidden} & {id(record) for record in students.records}
    assert not teachers.warnings


def test_a_figure_of_the_solutions_is_on_the_teachers_sheet_only(document, make):
    path = document(RIGHT, front="---\ntitle: x\narm: planar_2r\nfigures: [sketch, {solutions: singular}]\n---\n\n")

    def figures(**edition: object) -> list[str]:
        return [block.path.stem for block in make(path, **edition).blocks if isinstance(block, Picture)]

    assert figures() == ["sketch"]
    assert figures(solutions=True) == ["sketch", "singular"]


def test_a_longer_solution_gets_more_space(document, make):
    def space(body: str) -> float:
        return sum(
            block.height for block in make(document(f"## Solution\n\n{body}")).blocks if isinstance(block, Blank)
        )

    assert space("One line.") < space(RIGHT) < space(RIGHT * 3) < space(RIGHT * 50) <= 110


def test_a_document_without_solutions_says_so(document, make):
    assert any("no solution in it" in warning for warning in make(document(RIGHT), solutions=True).warnings)
    assert not make(document("## Solution\n\n" + RIGHT), solutions=True).warnings


def test_the_foot_counts_what_stands_on_the_sheet(document, make):
    path = document(RIGHT + ERRATUM + "## Solution\n\n" + RIGHT)
    assert proof_of(make(path)).startswith("1 equation proved against Drake")
    assert proof_of(make(path, solutions=True)).startswith("2 equations proved against Drake")
    assert proof_of(make(path, solutions=True, lang="fr")).startswith("2 équations démontrées avec Drake")


def test_an_equation_about_no_arm_is_not_proved_against_drake(document, make):
    sheet = make(document(r"$$ \cos^2 x + \sin^2 x = 1 $$", front="---\ntitle: General\n---\n\n"))
    assert proof_of(sheet).startswith("1 equation proved by Armproof")


def test_what_is_unchecked_is_counted_as_such(document, tmp_path):
    read = read_document(document(RIGHT + RIGHT))
    result = check_document(read, confirm=False)
    unchecked = replace(result.equations[1], verdict=Verdict.UNCHECKED)
    sheet = make_sheet(read, replace(result, equations=(result.equations[0], unchecked)), Edition(), tmp_path)
    assert proof_of(sheet).startswith("1 equation proved") and proof_of(sheet).endswith("; 1 not checked")


@pytest.mark.parametrize(("lang", "words"), [("en", "Teacher"), ("fr", "Édition de l’enseignant")])
def test_the_sheet_speaks_its_language(lang: str, words: str, document, pdf_text):
    assert words in pdf_text(document(RIGHT), solutions=True, lang=lang)


def test_the_words_within_a_formula_are_in_the_language_of_the_sheet(document, make):
    path = document(r"$$ \det J_2 = 0 \iff \theta_2 = 0 \text{ or } \theta_2 = \pi \qquad x = \text{floor} $$")
    words = {
        lang: re.findall(r"<mtext>\s*(\w+)", render(make(path, lang=lang, draft=True), "html").decode())
        for lang in ("en", "fr")
    }
    assert words["en"] == ["or", "floor"] and words["fr"] == ["ou", "floor"]


def test_an_unknown_language_is_refused(document, make):
    with pytest.raises(LanguageError, match="no language 'de'; the languages are en, fr"):
        make(document(RIGHT), lang="de")
