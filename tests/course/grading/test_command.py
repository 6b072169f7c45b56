"""What `armproof grade` refuses; what it does is in test_runs."""

import pytest
from typer.testing import CliRunner

from armproof.course.grading.grades import Grades
from armproof.verification.cli import app


def run(*arguments: object):
    return CliRunner().invoke(app, ["grade", *map(str, arguments)])


@pytest.fixture
def no_server(monkeypatch):
    """Grade without running anything: what is refused is refused before."""
    monkeypatch.setattr(
        "armproof.course.grading.grading.grade", lambda submissions, limits, *_, **__: Grades((), {}, limits)
    )


def test_what_cannot_be_graded_is_refused_before_anything_runs(write, tmp_path, no_server):
    assert "there is no such folder" in run(tmp_path / "none").stderr
    (tmp_path / "class").mkdir()
    assert "no notebooks in it" in run(tmp_path / "class", "--out", tmp_path / "out").stderr
    write("anna.ipynb", "x = 1")
    assert run(tmp_path / "class", "--out", tmp_path / "out").exit_code == 0
    (tmp_path / "file").touch()
    result = run(tmp_path / "class", "--out", tmp_path / "file")
    assert result.exit_code == 2 and "file: not a folder; --out takes" in result.stderr
    assert "cannot be written" in run(tmp_path / "class", "--out", tmp_path / "file/out").stderr
    write("anna/08.ipynb", "x = 1")
    assert "is there twice" in run(tmp_path / "class", "--out", tmp_path / "out").stderr


@pytest.mark.parametrize("option", [("--jobs", 0), ("--seconds", 0), ("--memory", 1)])
def test_a_limit_that_is_none_is_refused(option, write, tmp_path, no_server):
    write("anna.ipynb", "x = 1")
    assert run(tmp_path / "class", *option).exit_code == 2
