"""New lessons: they pass as they are written, for every arm and for documents."""

from __future__ import annotations

import ast
import json
from pathlib import Path

import pytest

from armproof.course.authoring.beginning.drafts import as_task, drafts_of_arm
from armproof.course.authoring.beginning.exact_text import as_matrix, write_quantity
from armproof.course.authoring.beginning.new import new_lesson
from armproof.course.authoring.beginning.python_text import NotPython, write_python
from armproof.course.authoring.beginning.slips import slips
from armproof.course.authoring.checking.answers import check_answers
from armproof.course.authoring.checking.lessons import check_lesson
from armproof.course.authoring.checking.tasks import load_tasks
from armproof.course.errors import AuthoringError
from armproof.course.feedback import Outcome
from armproof.course.sources.lesson_source import read_lesson_source
from armproof.course.sources.places import COURSE, Place
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.quantity_kinds import as_front_matter
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.quantities import read_quantity

TABLE = """---
title: Two links, "drawn"
arm:
  dh: classic
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: theta_1}
    - {a: l_2, alpha: 0, d: 0, theta: theta_2}
symbols: {m_1: l_1}
quantities:
  J_v: {jacobian: 2, rows: [1, 2]}
---

$$ p_2 = \\begin{bmatrix} m_1 C_1 + l_2 C_{12} \\\\ m_1 S_1 + l_2 S_{12} \\\\ 0 \\end{bmatrix} $$

$$ \\det J_v = m_1 l_2 \\sin\\theta_2 $$

$$ J_v = \\begin{bmatrix} -m_1 S_1 & -l_2 S_{12} \\\\ m_1 C_1 & l_2 C_{12} \\end{bmatrix} $$
"""


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path / "own")


def problems(place: Place) -> list[str]:
    [source] = place.sources()
    read = read_lesson_source(source)
    return list(check_answers(place, read, load_tasks(place, read)))


@pytest.mark.parametrize("arm", arm_names())
def test_a_new_lesson_passes_as_it_is_written(place, arm: str):
    pytest.importorskip("nbclient")
    written = new_lesson(place, "my_lesson", arm)
    assert [path.relative_to(place.root).as_posix() for path in written] == [
        "lessons/01_my_lesson.py",
        "tasks/my_lesson.py",
        "notebooks/01_my_lesson.ipynb",
    ]
    report = check_lesson(place, place.sources()[0])
    assert report.problems == ()
    assert report.tasks == 2 and report.right >= 6 and report.wrong >= 8


@pytest.mark.parametrize("arm", ["scara", "polar_rp"])
def test_the_answers_of_a_new_lesson_are_accepted_and_its_slips_named(place, arm: str):
    new_lesson(place, "my_lesson", arm)
    assert problems(place) == []


def test_a_spoiled_answer_of_a_new_lesson_is_noticed(place):
    new_lesson(place, "my_lesson", "polar_rp")
    tasks = place.tasks / "my_lesson.py"
    tasks.write_text(tasks.read_text().replace("m.cos(", "m.sin("))
    assert any("right answer 1" in problem and "wrong: " in problem for problem in problems(place))


def test_a_documents_proved_displays_become_tasks(place, tmp_path):
    document = tmp_path / "sheet.md"
    document.write_text(TABLE, encoding="utf-8")
    new_lesson(place, "two_links", None, document)
    lesson = load_tasks(place, read_lesson_source(place.sources()[0]))
    assert [task.name for task in lesson.tasks] == ["p_2", "det_j_v"]  # the last display is refuted
    assert lesson.title == 'Two links, "drawn"'
    assert problems(place) == []
    assert lesson.p_2.check(r"\begin{bmatrix} m_1 C_1 + l_2 C_{12} \\ m_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}").is_right
    assert lesson.det_j_v.check(r"m_1 l_2 \cos\theta_2").outcome is Outcome.WRONG


@pytest.mark.parametrize("name", ["planar-2r-002", "scara-000", "spatial-rrr-002"])
def test_a_handout_makes_a_lesson(place, name: str):
    new_lesson(place, "from_handout", None, COURSE.root / "handouts" / f"{name}.md")
    lesson = load_tasks(place, read_lesson_source(place.sources()[0]))
    assert len(lesson.tasks) >= 3 and problems(place) == []
    notebook = json.loads(place.notebook(place.sources()[0]).read_bytes())
    code = "".join("".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code")
    assert not any(answer in code for task in lesson.tasks for answer in task.right if isinstance(answer, str))


def test_the_next_lesson_gets_the_next_number_and_none_is_overwritten(place):
    new_lesson(place, "one", "polar_rp")
    new_lesson(place, "two", "polar_rp")
    assert [path.name for path in place.sources()] == ["01_one.py", "02_two.py"]
    before = (place.tasks / "one.py").read_bytes()
    with pytest.raises(AuthoringError, match="there is a lesson 'one' already"):
        new_lesson(place, "one", "scara")
    assert (place.tasks / "one.py").read_bytes() == before


def test_a_document_about_another_arm_is_refused(place):
    with pytest.raises(AuthoringError, match=r"scara-000.md is about another arm; leave --arm out"):
        new_lesson(place, "one", "rx90", COURSE.root / "handouts" / "scara-000.md")
    with pytest.raises(ArmproofError, match=r"none\.md"):
        new_lesson(place, "one", "rx90", Path("none.md"))
    assert not place.root.exists()


@pytest.mark.parametrize("arm", ["planar_2r", "rx90"])
def test_slips_are_wrong_and_no_two_are_the_same(arm: str):
    drafts = drafts_of_arm(load_arm(arm), arm)
    for draft in drafts:
        task = as_task(draft)
        found = [latex for latex, _ in zip(slips(draft.latex, load_arm(arm)), range(8), strict=False)]
        assert len(found) == len(set(found)) and draft.latex not in found
        outcomes = [task.check(latex).outcome for latex in found]
        assert outcomes.count(Outcome.WRONG) >= len(found) - 1  # a slip may change nothing


@pytest.mark.parametrize(
    ("latex", "python"),
    [
        (r"-a_1 \sin(\theta_1 + \theta_2) - 2", "-a_1 * m.sin(theta_1 + theta_2) - 2"),
        (r"\frac{a + b}{a b}", "(a + b) / (a * b)"),
        (r"\frac{1}{2} \cos^2(\theta)", "(1 / 2) * m.cos(theta)**2"),
        (r"a - (b - c)", "a - (b - c)"),
        (r"0.054 \sqrt{a}", "0.054 * m.sqrt(a)"),
    ],
)
def test_formulas_are_written_as_python(latex: str, python: str):
    assert write_python(Reader().read_expression(latex)) == python
    ast.parse(python)


@pytest.mark.parametrize("latex", [r"a \times b", r"\pm a", r"\begin{bmatrix} a \end{bmatrix}", r"q", r"a'"])
def test_what_is_no_python_is_refused(latex: str):
    with pytest.raises(NotPython, match="no Python"):
        write_python(Reader().read_expression(latex))


@pytest.mark.parametrize(
    "spec",
    [
        {"pose": 4, "in": 2},
        {"origin": 4, "component": "x"},
        {"axis": 3, "along": "x"},
        {"difference": [3, 1]},
        {"jacobian": 4, "rows": [1, 2, 6], "columns": [1, 2]},
        {"pose": 4, "component": [1, 4]},
    ],
)
def test_a_quantity_is_written_back_as_the_front_matter_has_it(spec):
    arm = load_arm("scara")
    quantity = read_quantity("asked", spec, arm)
    assert read_quantity("asked", as_front_matter(quantity), arm) == quantity


def test_what_is_too_long_to_type_is_not_written(monkeypatch):
    from armproof.course.authoring.beginning import exact_text

    arm = load_arm("kr210")
    assert write_quantity(arm, {"jacobian": 6}) is not None
    monkeypatch.setattr(exact_text, "LONGEST", 100)
    assert write_quantity(arm, {"jacobian": 6}) is None
    assert as_matrix((("a",),)) == "a"


def test_a_quantity_that_takes_too_long_is_not_written(monkeypatch):
    from armproof.course.authoring.beginning import exact_text

    arm = load_arm("rx90")
    assert write_quantity(arm, {"jacobian": 6}) is not None
    monkeypatch.setattr(exact_text, "SECONDS", -1.0)  # the budget is one of processor time, as everywhere
    assert write_quantity(arm, {"jacobian": 6}) is None
