"""The page of a lesson: valid, escaped, whole, and without the solutions unless it is the edition that has them."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from armproof.course.errors import PrintError, SiteError
from armproof.course.site.cells import Cell, cells_of
from armproof.course.site.reading import LessonReader
from armproof.verification.check import check_document
from armproof.verification.document import read_document
from tests.course.site.conftest import LESSON, NOT_ATTEMPTED, RIGHT, SECRET, STREAM
from tests.verification.report.test_pages import Outline

OUTPUTS = {4: [STREAM, NOT_ATTEMPTED], 5: [NOT_ATTEMPTED]}
ATTACK = "<script>window.attacked=1</script><img src=x onerror=window.attacked=1>"


def visible(html: str) -> str:
    """Return the text of a page without its style and script."""
    return re.sub(r"<(style|script)>.*?</\1>|<[^>]*>", "", html, flags=re.DOTALL)


def check_valid(html: str) -> Outline:
    outline = Outline(html)
    assert max(outline.ids.values(), default=1) == 1
    assert outline.references <= set(outline.ids)
    assert outline.headings[0] == 1 and outline.headings.count(1) == 1
    assert all(after - before <= 1 for before, after in zip(outline.headings, outline.headings[1:], strict=False))
    assert not any(name == "style" or name.startswith("on") for name, _ in outline.attributes)
    return outline


@pytest.mark.parametrize("solutions", [False, True])
def test_a_page_is_valid_and_shows_mathematics_not_latex(page, solutions):
    html = page(OUTPUTS, solutions=solutions)
    check_valid(html)
    assert not re.search(r"[$\\]", visible(html))
    assert html.count("<mtable") >= 1 and "the source is wrong here" in html


def test_a_heading_left_out_is_noticed_by_these_checks():
    with pytest.raises(AssertionError):
        check_valid("<h1>a</h1><h3>b</h3>")


def test_the_page_of_a_student_holds_no_solution(page):
    student, teacher = page(OUTPUTS), page({4: [RIGHT], 5: [RIGHT]}, solutions=True)
    assert "found = " not in visible(student) and SECRET not in student and "answer = 0.45" not in visible(student)
    assert "your code here" in visible(student) and "SOLUTION" not in student
    assert visible(teacher).count(SECRET) == 2 and "answer = 0.45" in visible(teacher) and "SOLUTION" not in teacher
    assert "Edition with solutions" in teacher and "Edition with solutions" not in student


def test_solutions_are_folded_behind_the_hints(page):
    html = page({4: [RIGHT]}, solutions=True)
    section = html[html.index('id="task-1"') : html.index('id="task-2"')]
    assert section.index("Hint 1 of 2") < section.index("Hint 2 of 2") < section.index('<details class="solution">')
    assert section.index('<details class="solution">') < section.index(SECRET) < section.index("correct (proved)")


def test_a_task_not_attempted_shows_its_question_and_not_that_it_was_not_attempted(page):
    html = page(OUTPUTS)
    assert "Task 1 of 2" in html and "What is the rank of" in html and "not attempted" not in html
    assert "rank: None" in html
    failing = {**NOT_ATTEMPTED, "data": {"text/plain": "! rank: error"}}
    assert "! rank: error" in page({4: [failing]})


def test_what_a_lesson_says_when_it_is_opened_stands_at_the_head_of_the_page_instead(page):
    opening = {"output_type": "execute_result", "data": {"text/plain": "0 of 2 tasks solved"}}
    html = page({2: [opening]})
    assert "0 of 2 tasks" not in html and "2 tasks" in html and "Find " in html
    listed = page(words="In this lesson you\n#\n# 1. do this,\n# 2. do that.")
    assert "What you will be able to do" in html and "What you will be able to do" not in listed


def test_links_lead_to_lessons_of_this_site_and_to_pages_of_the_network_only_when_followed(page):
    html = page()
    assert '<a href="04_other.html" rel="noreferrer">the next one</a>' in html
    assert 'rel="next" href="04_other.html"' in html and "Another &lt;lesson&gt;" in html
    assert '<a href="https://example.org/x" rel="noreferrer">a page</a>' in html
    assert not re.search(r"""(?:src|action|data-page)=["']?(?:https?:)?//|@import|url\(""", html)


def test_markdown_that_a_cell_gives_adds_no_heading_and_keeps_the_numbers_of_its_displays(page):
    output = {"output_type": "display_data", "data": {"text/markdown": "# A sheet\n\n$$ a = b \\tag{7} $$\n\n$$ c $$"}}
    html = page({4: [output]})
    check_valid(html)
    assert "<strong>A sheet</strong>" in html and html.count('<span class="tag">') == 1
    assert '<span class="tag">(7)</span>' in html and not re.search(r"[$\\]", visible(html))


def test_a_lesson_named_by_its_number_is_linked_but_not_within_a_link_or_a_heading(page):
    html = page(words="Lesson 4, lesson 44 and [lesson 4 there](https://example.org).\n#\n# ## As in lesson 4")
    check_valid(html)
    assert html.count('<a href="04_other.html" rel="noreferrer">Lesson 4</a>') == 1
    assert '<a href="https://example.org" rel="noreferrer">lesson 4 there</a>' in html
    assert '<h2 id="as-in-lesson-4">As in lesson 4</h2>' in html and "lesson 44 and" in html


def test_hostile_titles_words_and_outputs_are_shown_as_text_or_dropped(page):
    output = {"output_type": "display_data", "data": {"text/html": f"<p onclick='x()'>shown</p>{ATTACK}"}}
    html = page({4: [output]}, title=f'{ATTACK} "t"', objective=ATTACK, words=ATTACK.replace("\n", " "))
    check_valid(html)
    assert html.count("<script>") == 1 and "onerror=" not in re.sub(r"&lt;img[^<]*", "", html)
    assert "shown" in html and "&lt;script&gt;window.attacked=1" in html


def test_styles_of_outputs_stand_once_at_the_head_and_under_the_policy(page):
    html = page({4: [RIGHT], 5: [RIGHT]}, solutions=True)
    assert html.count("<style>.armproof { color: inherit; }</style>") == 1
    assert html.index("color: inherit") < html.index("<body")
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', html)
    assert (
        policy is not None and policy.group(1).count("sha256-") == 3 and "default-src &#39;none&#39;" in policy.group(1)
    )


def test_headings_that_are_called_alike_or_as_a_part_of_the_page_have_anchors_of_their_own(page):
    html = page(words="\n#\n# ## Reference\n#\n# ## Objectives\n#\n# ## Task 1\n#\n# ## Task 1")
    outline = check_valid(html)
    assert {"reference", "reference-2", "task-1", "task-1-2", "task-1-3", "where-the-tool-is"} <= set(outline.ids)


def test_a_lesson_with_a_wrong_equation_has_no_page(page):
    wrong = LESSON.replace("l_1 S_1 + l_2 S", "l_1 S_1 - l_2 S")
    with pytest.raises(SiteError, match=r"03_tiny_\d+\.py:\d+: an equation does not pass, so the page is not built"):
        page(source=wrong)


def test_every_display_has_its_verdict_and_every_verdict_its_display(lesson):
    source, _ = lesson()
    document = read_document(source.path)
    result = check_document(document, confirm=False)
    cells = [cell for cell in cells_of(source) if cell.kind == "markdown"]

    def read(equations):
        reader = LessonReader(document, replace(result, equations=equations), {}, solutions=True)
        for cell in cells:
            reader.cell(cell)
        reader.close()

    read(result.equations)
    for equations in (result.equations[1:], result.equations[:-1], (*result.equations, result.equations[0])):
        with pytest.raises(PrintError):
            read(equations)


def test_a_cell_names_the_tasks_that_it_calls():
    cell = Cell("code", "lesson.a.check(x); lesson.b.show(x); other.c.check(x)\nlesson.a.check(y)", "", 0)
    assert cell.calls("check") == ("a",) and cell.calls("show") == ("b",) and cell.calls("hint") == ()
