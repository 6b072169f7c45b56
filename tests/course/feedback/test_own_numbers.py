"""A seed gives each student other lengths, another arm, another spoiled sheet; right and wrong are known as well as of the usual ones."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from armproof.course.authoring.beginning.copies import begin
from armproof.course.feedback import Number, Outcome, Task, lessons, open_lesson
from armproof.course.feedback.number_slips import worked_out
from armproof.course.tasks.proofread import SPOILED
from armproof.verification.check import verify
from armproof.verification.verdict import Verdict
from tests.laws import is_in_part

OWN = [(lesson.name, task.name) for lesson in lessons() for task in lesson.tasks if task.own]
DIGITS = 5e-4  # of a number that is written with four of them
SEEDS = ["Ana", "Léo", "7", *map(str, range(100, 117))]


def seeded(lesson: str, name: str, seed: str) -> Task:
    return getattr(open_lesson(lesson, seed=seed), name)  # type: ignore[no-any-return]


@pytest.mark.parametrize(("lesson", "name"), OWN)
def test_right_answers_are_proved_and_wrong_ones_told_for_every_seed(lesson: str, name: str) -> None:
    tasks = [seeded(lesson, name, seed) for seed in SEEDS]
    for task in tasks:
        assert {task.check(answer).outcome for answer in task.right} == {Outcome.PROVED}
        for wrong in task.wrong:
            feedback = task.check(wrong.answer)
            assert feedback.outcome is Outcome.WRONG
            assert wrong.words in feedback.message
    if not tasks[0].numbers:
        return
    assert len({task.text for task in tasks}) >= 15
    usual = getattr(open_lesson(lesson), name)
    alike = [task for task in tasks if task.check(usual.right[0]).is_right]  # a sum may be the same
    assert len(alike) <= len(tasks) // 5


NUMBERS = [(lesson.name, task.name) for lesson in lessons() for task in lesson.tasks if isinstance(task.asks, Number)]


def several(lesson: str, name: str) -> list[Task]:
    """Return a task with the numbers that are printed, and with those of some seeds."""
    seeds = [seed for k, seed in enumerate(SEEDS) if is_in_part(k, 10)] if (lesson, name) in OWN else []
    return [getattr(open_lesson(lesson), name), *(seeded(lesson, name, seed) for seed in seeds)]


@pytest.mark.parametrize(("lesson", "name"), NUMBERS)
def test_no_two_known_mistakes_give_one_number_and_none_the_right_one(lesson: str, name: str) -> None:
    for task in several(lesson, name):
        known = [(np.array(wrong.answer, dtype=float), wrong.words) for wrong in task.wrong if wrong.own]
        for answer, words in known:
            assert not np.allclose(answer, np.array(task.asks.value), rtol=DIGITS)
            alike = [other for same, other in known if same.shape == answer.shape and np.allclose(same, answer, DIGITS)]
            assert all(other in task.check(answer.tolist()).message for other in alike), words


@pytest.mark.parametrize(("lesson", "name"), NUMBERS)
def test_of_two_slips_with_one_number_both_are_told_or_none(lesson: str, name: str) -> None:
    for task in several(lesson, name):
        asks = task.asks.told_in(task.text)
        right = np.atleast_1d(np.array(asks.value, dtype=float))
        ways = worked_out(right, asks.labels or [""] * right.size, asks.known, asks.stated, asks.way)
        for place, worked in ways.items():
            told: dict[float, set[str]] = {}
            for value, *words in worked.coincidences():
                told.setdefault(round(value, 9), set()).update(words)
            for value, said in told.items():
                answer = np.where(np.arange(right.size) == place, value, right)
                words = asks.judge(answer.tolist()).message.partition(": ")[2]
                assert words not in said or words.endswith("alone")  # a value, whichever the way to it


def test_a_teacher_reproduces_the_numbers_of_a_seed() -> None:
    assert OWN != []
    task = open_lesson("scara_jacobian", seed="Ana").prediction
    assert dict(task.numbers) == {"a_1": 0.365, "a_2": 0.195}  # on every machine, in every version of Python
    assert open_lesson("scara_jacobian", seed=7).prediction is open_lesson("scara_jacobian", seed="7").prediction
    assert not open_lesson("scara_jacobian").prediction.numbers
    assert "Your numbers (m): a₁ = 0.365, a₂ = 0.195." in str(task.check())
    assert "Your numbers" not in str(task.check(task.right[0]))
    french = open_lesson("scara_jacobian", lang="fr", seed="Ana").prediction
    assert "$a_1 = 0.365$" in french.text


def test_the_printed_numbers_are_told_to_be_others_than_ones_own() -> None:
    usual = open_lesson("scara_jacobian").prediction
    task = open_lesson("scara_jacobian", seed="Ana").prediction
    assert "right with the numbers that the lesson prints" in task.check(usual.right[0]).message
    assert "the lesson prints" not in task.check([0, 0.7, 0]).message
    assert (
        "leçon imprime" in open_lesson("scara_jacobian", lang="fr", seed="Ana").prediction.check(usual.right[0]).message
    )


def test_a_known_wrong_number_is_none_that_is_right_where_that_one_is_wrong() -> None:
    merged = open_lesson("kr210_table").merged
    assert "rounded to too few digits" in merged.check([0.75, 1.5, 0.3]).message
    assert "oblique" in merged.check([0.75, 1.501, 0.303]).message


def test_each_seed_has_an_arm_of_the_family() -> None:
    arms = {str(seeded("own_frames", "transfer", seed).asks.scheme.spec) for seed in SEEDS}  # type: ignore[attr-defined]
    assert len(arms) >= 6


def sheet_of(folder: Path, seed: str) -> str:
    """Return the sheet that stands in the notebook of a seed."""
    [notebook], _ = begin(["proofread"], folder / (seed or "usual"), seed=seed)
    cells = ["".join(cell["source"]) for cell in json.loads(notebook.read_bytes())["cells"]]
    (found,) = (re.search(r'^sheet = r"""(.*?)"""', cell, re.DOTALL) for cell in cells if cell.startswith("sheet = "))
    assert found is not None
    return found[1]


@pytest.mark.parametrize("seed", ["", "Ana", "3", "8"])
def test_what_a_sheet_prints_wrongly_is_what_its_task_calls_wrong(seed: str, tmp_path: Path) -> None:
    file = tmp_path / "sheet.md"
    file.write_text(sheet_of(tmp_path, seed), encoding="utf-8")
    records = {re.search(r"tag\{(\d)\}", each.latex)[1]: each.verdict for each in verify(file).records}  # type: ignore[index]
    wrong = {number for number, verdict in records.items() if verdict is Verdict.REFUTED}
    task = seeded("proofread", "wrong_displays", seed)
    assert wrong == set(task.right[0]) and len(records) == 8
    assert {records[number] for number in set(records) - wrong} == {Verdict.PROVED}


def test_sheets_differ_and_a_teacher_reproduces_them(tmp_path: Path) -> None:
    sheets = [sheet_of(tmp_path, f"student {seed}") for seed in range(12)]
    assert len(set(sheets)) >= 10
    assert sheets[3] == sheet_of(tmp_path / "again", "student 3")


def at_zero(latex: str) -> list[object]:
    """Return the entries of a printed display at the zero pose, for two lengths."""
    text = re.sub(r" \\tag.*", "", latex.split(r"\end")[0])
    text = re.sub(r"S_(?:\{12\}|\d)", "0", re.sub(r"C_(?:\{12\}|\d)", "1", text)).replace("^", "**")
    entries = re.split(r"&|\\\\", text)
    lengths = {"l_1": 2.0, "l_2": 3.0}
    return [eval(re.sub(r"(?<=\w) (?=\w)", "*", entry.strip()), lengths) for entry in entries]  # noqa: S307


RIGHT = {
    "2": r"C_2 & -S_2 & 0 & l_2 C_2 \\ S_2 & C_2 & 0 & l_2 S_2",
    "3": r"l_1^2 + l_2^2 + 2 l_1 l_2 C_2 \tag{3}",
    "4": r"-l_1 S_1 - l_2 S_{12} & -l_2 S_{12}",
    "5": r"l_1 l_2 S_2 \tag{5}",
    "8": r"C_{12} \\ S_{12} \\ 0 \end{bmatrix} \tag{8}",
}


@pytest.mark.parametrize("number", SPOILED)
def test_what_holds_at_the_zero_pose_is_known(number: str) -> None:
    for latex, holds in SPOILED[number]:
        assert (at_zero(latex) == at_zero(RIGHT[number])) is holds, latex
