"""`armproof lesson`: what it writes and prints, and its exit codes."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from armproof.course.authoring.checking import lessons as checking
from armproof.course.authoring.checking.report import Report
from armproof.course.authoring.command import lesson as group
from armproof.course.sources import kernel
from armproof.course.sources.places import Place
from armproof.verification.cli.application import as_command


def run(*arguments: object):
    return CliRunner().invoke(group, [str(argument) for argument in arguments])


@pytest.fixture
def small(lesson) -> Place:
    return lesson()[0]


def test_build_writes_what_changed_and_nothing_else(small):
    first = run("build", "--folder", small.root)
    assert first.exit_code == 0 and first.stdout.strip() == str(small.notebook(small.sources()[0]))
    before = small.notebook(small.sources()[0]).stat().st_mtime_ns
    second = run("build", "--folder", small.root)
    assert second.exit_code == 0 and second.stdout == "" and "1 notebook up to date" in second.stderr
    assert small.notebook(small.sources()[0]).stat().st_mtime_ns == before


def test_build_check_names_what_is_stale_and_writes_nothing(small):
    assert run("build", "--check", "--folder", small.root).exit_code == 1
    assert not small.notebooks.exists()
    run("build", "--folder", small.root)
    assert run("build", "--check", "--folder", small.root).exit_code == 0
    source = small.sources()[0]
    source.write_text(source.read_text().replace("Return the area", "Give the area"))
    notebook = small.notebook(source)
    before = notebook.read_bytes()
    result = run("build", "--check", "--folder", small.root)
    assert result.exit_code == 1 and result.stdout == f"{notebook}: out of date\n"
    assert notebook.read_bytes() == before


def test_a_notebook_that_somebody_has_worked_in_is_not_overwritten(small):
    run("build", "--folder", small.root)
    notebook = small.notebook(small.sources()[0])
    answered = json.loads(notebook.read_bytes())
    answered["cells"][5]["execution_count"] = 1
    notebook.write_text(json.dumps(answered))
    result = run("build", "--folder", small.root)
    assert (
        result.exit_code == 2 and "03_small.ipynb: somebody has worked in this notebook; move it away" in result.stderr
    )
    assert json.loads(notebook.read_bytes()) == answered
    assert run("build", "--check", "--folder", small.root).exit_code == 1
    assert run("build", "--force", "--folder", small.root).exit_code == 0
    assert json.loads(notebook.read_bytes()) != answered


def test_a_notebook_that_no_source_gives_is_named(small):
    run("build", "--folder", small.root)
    (small.notebooks / "02_gone.ipynb").write_text("{}")
    result = run("build", "--check", "--folder", small.root)
    assert result.exit_code == 1 and "02_gone.ipynb: no source gives this notebook" in result.stderr
    assert (small.notebooks / "02_gone.ipynb").exists()


@pytest.mark.parametrize(
    ("option", "name"), [("--instructor", "03_small.ipynb"), ("--nbgrader", "03_small/03_small.ipynb")]
)
def test_other_editions_are_written_into_a_folder_of_their_own(small, tmp_path, option: str, name: str):
    result = run("build", option, "--out", tmp_path / "out", "--folder", small.root)
    assert result.exit_code == 0, result.output
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == [tmp_path / "out" / name]
    assert "corner = a**2 / 2" in (tmp_path / "out" / name).read_text()
    assert not small.notebooks.exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["build", "--instructor"], "an edition with solutions is written into a folder of its own: --out DIR"),
        (["build", "--instructor", "--out", "{notebooks}"], "the students' notebooks are here; solutions are written elsewhere"),
        (["build", "--instructor", "--nbgrader", "--out", "x"], "two editions; build one at a time"),
        (["build", "--out", "x"], "--out is for --instructor or --nbgrader"),
        (["build", "large"], "no lesson 'large'; the lessons are 03_small"),
        (["check", "4"], "no lesson '4'; the lessons are 03_small"),
        (["new", "large"], "which arm is the lesson about? Say --arm ARM, one of kr210, planar_2r"),
        (["new", "large", "--arm", "puma"], "no arm 'puma'; a lesson is about kr210, planar_2r"),
        (["new", "2 arms", "--arm", "scara"], "'2 arms' is no name for a lesson: a lesson is named by lower-case letters"),
        (["new", "Large-Lesson", "--arm", "scara"], "beginning with a letter, such as large_lesson"),
        (["new", "class", "--arm", "scara"], "'class' is no name for a lesson"),
        (["new", "small", "--arm", "scara"], "03_small.py: there is a lesson 'small' already; remove it or choose another"),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_refused_and_nothing_written(small, arguments: list[str], message: str):
    before = sorted(small.root.rglob("*"))
    filled = [argument.format(notebooks=small.notebooks) for argument in arguments]
    result = run(*filled, "--folder", small.root)
    assert result.exit_code == 2 and message in result.stderr
    assert sorted(small.root.rglob("*")) == before


def test_a_malformed_source_is_named_and_no_notebook_written(lesson):
    place, source = lesson(("    ### END SOLUTION\n", ""))
    result = run("build", "--folder", place.root)
    assert result.exit_code == 2 and f"{source}:33: '### BEGIN SOLUTION' without '### END SOLUTION'" in result.stderr
    assert not place.notebooks.exists()


@pytest.mark.parametrize("command", ["list", "build", "check"])
def test_a_folder_without_lessons_is_named(tmp_path, command: str):
    result = run(command, "--folder", tmp_path)
    assert result.exit_code == 2 and "no lesson here; a lesson is a file such as 12_scara_jacobian.py" in result.stderr
    assert "none: no such folder" in run(command, "--folder", tmp_path / "none").stderr


@pytest.mark.parametrize("name", ["small", "3", "03", "03_small", "lessons/03_small.py", "03_small.ipynb"])
def test_a_lesson_may_be_named_in_several_ways(small, name: str):
    assert small.named([name]) == small.sources()


def test_the_list_has_number_name_title_tasks_and_arms(small):
    result = run("list", "--folder", small.root)
    assert result.exit_code == 0
    assert [line.split() for line in result.stdout.splitlines()] == [
        ["name", "title", "tasks", "arms"],
        ["3", "small", "Small", "3", "none"],
    ]


@pytest.mark.parametrize(
    ("problems", "cannot_run", "code", "verdict"),
    [((), False, 0, "passes"), (("a.py:1: bad",), False, 1, "does not pass"), (("a.py:1: bad",), True, 2, "cannot be")],
)
def test_check_prints_a_table_then_the_problems(
    small, monkeypatch, problems, cannot_run: bool, code: int, verdict: str
):
    def check(place: Place, source: Path, lang: str) -> Report:
        return Report(source, problems, cannot_run, 3, 9, 12, {"proved": 4}, 1.25, 1.0, (0.02, 0.03, 0.04))

    monkeypatch.setattr(checking, "check_lesson", check)
    result = run("check", "--folder", small.root)
    assert result.exit_code == code
    [row] = [line for line in result.stdout.splitlines() if line.startswith("03_small")]
    assert row.split()[1:12] == "3 9 + 12 4 proved 1.2 s 1.0 s 30".split() and verdict in row
    assert ("a.py:1: bad" in result.stdout) == bool(problems)
    written = json.loads(run("check", "--folder", small.root, "--format", "json").stdout)
    assert written["lessons"][0]["problems"] == list(problems)


def test_a_slow_lesson_is_marked(small, monkeypatch):
    monkeypatch.setattr(checking, "check_lesson", lambda place, source, lang: Report(source, seconds=9.0))
    assert "passes, slow" in run("check", "--folder", small.root).stdout


def test_without_jupyter_check_says_what_to_install(small, monkeypatch):
    monkeypatch.setattr(kernel, "find_spec", lambda name: None if name == "nbclient" else object())
    result = run("check", "--folder", small.root)
    assert (
        result.exit_code == 2
        and "nbclient: not installed; lessons run with: pip install 'armproof[lab]'" in result.stderr
    )
    assert run("build", "--folder", small.root).exit_code == 0


def test_an_entry_point_may_be_a_group_or_a_function():
    def alone() -> None:
        """Do one thing."""
        typer.echo("alone")

    app = typer.Typer()
    app.command("one")(alone)
    app.command("two")(lambda: typer.echo("two"))
    assert (
        sorted(as_command("several", app).commands) == ["one", "two"] and as_command("several", app).name == "several"
    )
    assert as_command("alone", alone).name == "alone"


def test_help_loads_neither_drake_nor_jupyter():
    import subprocess

    code = (
        "import sys; from armproof.course.authoring.command import lesson; lesson(['--help'], standalone_mode=False); \
print([name for name in ('pydrake', 'nbclient', 'nbformat', 'numpy') if name in sys.modules])"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert result.stdout.strip().endswith("[]"), result.stdout + result.stderr
    for name in ("list", "build", "check", "new", "site"):
        assert f"  {name} " in result.stdout
