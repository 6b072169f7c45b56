"""Which notebooks there are, whose they are, and what is no notebook."""

import os

import pytest

from armproof.course.errors import GradingError
from armproof.course.grading.notebook import UnreadableError, read_notebook
from armproof.course.grading.submissions import find_submissions
from armproof.course.grading.text import as_cell, clean, clean_lines
from tests.course.grading.hostile import BROKEN


def test_a_student_is_a_file_or_a_folder_of_files(write, tmp_path):
    for name in ("anna.ipynb", "José Núñez/08.ipynb", "José Núñez/week 2/09.ipynb"):
        write(name, "x = 1")
    for hidden in (".hidden.ipynb", "anna/.ipynb_checkpoints/08-checkpoint.ipynb"):
        write(hidden, "x = 1")
    (tmp_path / "class/notes.txt").write_text("no notebook", encoding="utf-8")
    found = find_submissions(tmp_path / "class")
    assert [(each.student, each.file) for each in found] == [
        ("anna", "anna.ipynb"),
        ("José Núñez", "José Núñez/08.ipynb"),
        ("José Núñez", "José Núñez/week 2/09.ipynb"),
    ]


def test_folders_and_files_of_moodle_are_their_students(write, tmp_path):
    for name in ("Ana Pérez_71_assignsubmission_file/01.ipynb", "Bo_72_assignsubmission_file_01.ipynb",
                 "Bo_72_assignsubmission_file_02.ipynb", "c_3.ipynb"):  # fmt: skip
        write(name, "x = 1")
    found = [(each.student, each.participant) for each in find_submissions(tmp_path / "class")]
    assert found == [("Ana Pérez", "71"), ("Bo", "72"), ("Bo", "72"), ("c_3", "")]
    write("Bo_73_assignsubmission_file_01.ipynb", "x = 1")
    with pytest.raises(GradingError, match="the student 'Bo' is there twice"):
        find_submissions(tmp_path / "class")


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ((), "class: no notebooks in it; put each student's .ipynb files there"),
        (("anna.ipynb", "anna/08.ipynb"), "the student 'anna' is there twice: 'anna' and 'anna.ipynb'"),
        (("Anna/08.ipynb", "anna/09.ipynb"), "is there twice: 'Anna' and 'anna'; put all of a student's notebooks into one folder"),
    ],
)  # fmt: skip
def test_a_class_that_cannot_be_graded_is_refused(names, message, write, tmp_path):
    (tmp_path / "class").mkdir()
    for name in names:
        write(name, "x = 1")
    with pytest.raises(GradingError, match=message):
        find_submissions(tmp_path / "class")


def test_a_folder_that_is_none_is_refused(tmp_path):
    with pytest.raises(GradingError, match="there is no such folder"):
        find_submissions(tmp_path / "none")
    (tmp_path / "file").touch()
    with pytest.raises(GradingError, match="not a folder"):
        find_submissions(tmp_path / "file")


def test_a_notebook_says_its_lessons_and_title(write):
    read = read_notebook(
        write("a.ipynb", "lesson = open_lesson('frames')\nlesson", "lesson.x.solution()", title='"Frames"')
    )
    assert read.lessons == ("frames",) and read.title == "Frames" and len(read.cells) == 2 and read.asks_solutions
    plain = read_notebook(write("b.ipynb", "x = 1"))
    assert plain.lessons == () and plain.title == "" and not plain.asks_solutions


def test_a_notebook_says_the_seeds_of_its_lessons(write):
    cells = (
        "open_lesson('frames', lang='fr', seed='Ana P.')",
        'open_lesson("frames", seed=7)',
        "open_lesson('quintic')",
    )
    read = read_notebook(write("a.ipynb", *cells))
    assert read.lessons == ("frames", "quintic") and read.seeded == ("frames=Ana%20P.", "frames=7")


@pytest.mark.parametrize("kind", BROKEN)
def test_what_is_no_notebook_is_unreadable(kind, tmp_path):
    path = tmp_path / "a.ipynb"
    path.write_bytes(BROKEN[kind])
    with pytest.raises(UnreadableError):
        read_notebook(path)


def test_links_and_pipes_are_not_opened(write, tmp_path):
    target = write("anna.ipynb", "x = 1")
    (tmp_path / "link.ipynb").symlink_to(target)
    os.mkfifo(tmp_path / "pipe.ipynb")
    for name, message in (("link", "link to another file"), ("pipe", "not a file")):
        with pytest.raises(UnreadableError, match=message):
            read_notebook(tmp_path / f"{name}.ipynb")
    assert read_notebook(target).cells == ("x = 1",)


def test_text_of_students_is_tamed():
    assert clean("a\x1b[31m\nb\u202ec\udc80 ") == "a�[31m b�c�"
    assert clean_lines("a\nb" * 10, 3) == "a\nb…"
    assert [as_cell(text) for text in ("=1+1", "@x", "-l_2", "l_2 - 1", "")] == ["'=1+1", "'@x", "'-l_2", "l_2 - 1", ""]
