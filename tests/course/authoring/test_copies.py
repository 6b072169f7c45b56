"""`armproof lesson begin` gives a student copies to work in, and `armproof lesson progress` says how far they are."""

from __future__ import annotations

import json
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof.course.authoring.beginning import copies
from armproof.course.authoring.beginning.copies import begin
from armproof.course.authoring.command import lesson as group
from armproof.course.feedback import course, open_lesson
from armproof.course.feedback.progress import VARIABLE
from armproof.course.sources.places import COURSE


def run(*arguments: object):
    return CliRunner().invoke(group, [str(argument) for argument in arguments])


def test_a_lesson_is_copied_once_and_a_students_work_stays(tmp_path: Path):
    first = run("begin", "12", "--into", tmp_path / "mine")
    copy = tmp_path / "mine" / "12_scara_jacobian.ipynb"
    assert first.exit_code == 0 and first.stdout == f"{copy}\n"
    assert copy.read_bytes() == (COURSE.notebooks / copy.name).read_bytes()
    again = run("begin", "12", "--into", tmp_path / "mine")
    assert again.exit_code == 0 and again.stdout == "" and f"{copy}: is here already and stays as it is" in again.stderr
    copy.write_text("my work")
    more = run("begin", "12", "scara_forward", "--into", tmp_path / "mine")
    assert more.stdout == f"{tmp_path / 'mine' / '06_scara_forward.ipynb'}\n"
    assert copy.read_text() == "my work"


def test_all_lessons_are_begun_in_the_language_asked_for(tmp_path: Path):
    new, kept = begin([], tmp_path, "fr")
    assert (sorted(new), kept) == (sorted(tmp_path.iterdir()), [])
    assert [path.stem for path in sorted(tmp_path.iterdir())] == [source.stem for source in COURSE.sources()]
    cells = json.loads((tmp_path / "01_frames.ipynb").read_bytes())["cells"]
    assert 'lang="fr"' in "".join(line for cell in cells for line in cell["source"])


@pytest.mark.parametrize("folder", [COURSE.notebooks, COURSE.root, COURSE.notebooks / "mine"])
def test_nobody_works_in_the_course_itself(folder: Path):
    before = sorted(COURSE.notebooks.iterdir())
    result = run("begin", "12", "--into", folder)
    assert result.exit_code == 2 and "the course itself is here; work in a folder of your own" in result.stderr
    assert sorted(COURSE.notebooks.iterdir()) == before


def test_what_is_interrupted_is_begun_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def fail(path: Path, data: bytes) -> None:
        raise OSError(28, os.strerror(28))

    monkeypatch.setattr(copies, "write_atomically", fail)
    result = run("begin", "12", "--into", tmp_path)
    assert result.exit_code == 2 and "12_scara_jacobian.ipynb: cannot be written: No space left" in result.stderr
    monkeypatch.undo()
    [new], kept = begin(["12"], tmp_path)
    assert kept == [] and new.read_bytes() == (COURSE.notebooks / new.name).read_bytes()
    (tmp_path / "file").touch()
    assert "cannot be written" in run("begin", "12", "--into", tmp_path / "file" / "below").stderr
    assert "no lesson 'scara'" in run("begin", "scara", "--into", tmp_path).stderr


def test_begun_twice_at_once_it_is_whole(tmp_path: Path):
    with ThreadPoolExecutor(4) as several:
        found = list(several.map(lambda _: begin(["12"], tmp_path), range(4)))
    assert sum(len(new) + len(kept) for new, kept in found) == 4
    [only] = tmp_path.iterdir()
    assert only.read_bytes() == (COURSE.notebooks / only.name).read_bytes()


def test_a_solved_task_is_a_point_in_the_bars(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv(VARIABLE, str(tmp_path / "progress.json"))
    lesson = open_lesson("scara_jacobian")
    monkeypatch.delitem(
        lesson._reached, "determinant", raising=False
    )  # another test of this process may have solved it
    before, count = course().points
    lesson.determinant.check(r"a_1 a_2 \sin\theta_2")
    assert course().points == (before, count)
    lesson.determinant.check(r"-a_1 a_2 \sin\theta_2")
    assert course().points == (before + 1, count)
    told = run("progress").stdout
    assert f"{before + 1} of {count} points" in told and "12 · SCARA: geometric Jacobian" in told
    page = course()._repr_html_()
    assert "▰" in repr(lesson) and f"<td>{lesson.points} / {len(lesson.tasks)}</td>" in page


def test_a_seed_gives_a_notebook_numbers_of_its_own(tmp_path: Path):
    assert run("begin", "12", "--into", tmp_path, "--seed", "Ana P.").exit_code == 0
    text = (tmp_path / "12_scara_jacobian.ipynb").read_text()
    numbers = open_lesson("scara_jacobian", seed="Ana P.").prediction.numbers
    assert json.loads(text) and 'open_lesson(\\"scara_jacobian\\", seed=\\"Ana P.\\")' in text
    assert f"$a_1 = {numbers['a_1']:g}$" in text and "$a_1 = 0.325$" not in text
    refused = run("begin", "12", "--into", tmp_path / "other", "--seed", 'x", folder="/')
    assert refused.exit_code == 2 and "is no seed" in refused.stderr
