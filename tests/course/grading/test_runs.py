"""What becomes of submissions, ordinary and hostile, in a server that is started once for this file."""

import contextlib
import csv
import os
import tempfile
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof.course.grading.judging import judge
from armproof.course.grading.notebook import Notebook
from armproof.course.grading.results import Graded, Status
from armproof.course.grading.running.client import Client
from armproof.course.grading.running.client import _environment as client_environment
from armproof.course.grading.running.keeper import _environment as run_environment
from armproof.course.grading.running.protections import ATTEMPTS
from armproof.course.grading.sandbox.limits import MEGABYTE, Limits
from armproof.course.grading.submissions import Submission
from armproof.course.grading.tables import TABLES
from armproof.models.language import use
from armproof.verification.cli import app
from tests.course.grading.hostile import KINDS

LIMITS = Limits(seconds=20, memory=512 * MEGABYTE)
SHORT = Limits(seconds=0.7, memory=512 * MEGABYTE)
QUICK = ("exits", "deletes-a-folder", "kills-everybody", "leaves-grandchildren", "10-gb", "forges-feedback")
OPEN = "from armproof import open_lesson\nlesson = open_lesson('scara_jacobian')"
RIGHT = "lesson.determinant.check(lesson.determinant.right[0])"


@pytest.fixture(scope="module")
def client(bwrap):
    with Client(1, LIMITS, ["scara_jacobian"]) as client:
        yield client


@pytest.fixture
def run(client):
    def run(*cells: str, limits: Limits = LIMITS) -> Graded:
        ended = client.run(cells, limits)
        found = Notebook(cells, ("scara_jacobian",))
        return judge(Submission("a", Path("a.ipynb"), "a.ipynb"), found, ended, client.catalogue, limits)

    return run


@pytest.fixture
def scratch():
    """A folder with a file, where anybody may write but for the sandbox."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "precious").write_text("precious", encoding="utf-8")
        (Path(folder) / "precious").chmod(0o666)
        Path(folder).chmod(0o777)
        yield Path(folder)


def outcomes(graded: Graded) -> dict[str, str]:
    return {result.task: result.outcome for result in graded.results if result.outcome != "not attempted"}


def test_the_last_check_of_each_task_is_its_result(run):
    graded = run(OPEN, "lesson.determinant.check('a_1')", RIGHT, "lesson.rank.check(-7)")
    assert graded.status is Status.GRADED
    assert outcomes(graded) == {"determinant": "correct (proved)", "rank": "wrong"}
    assert graded.right == 1 and len(graded.results) > 2


def test_a_cell_that_raises_does_not_end_the_notebook(run):
    graded = run(OPEN, "def f():\n    return 1 / 0\n\nf()", RIGHT)
    [error] = graded.errors
    assert (error.cell, error.line, error.type) == (2, 2, "ZeroDivisionError")
    assert outcomes(graded) == {"determinant": "correct (proved)"}
    assert not run(OPEN, "f = 1", RIGHT).errors


def test_a_cell_that_is_no_python_is_an_error_at_its_line(run):
    [error] = run("x = 1\ny = = 2", "x = 1").errors
    assert (error.cell, error.line, error.type) == (1, 2, "SyntaxError")


def test_magics_and_display_are_skipped(run):
    graded = run(
        "%matplotlib inline\nx = 2", "!ls", "from IPython.display import SVG\ndisplay(SVG('x'), x)", "print(x)"
    )
    assert not graded.errors and graded.output.strip() == "2"
    assert [note.partition(":")[0] for note in graded.notes] == ["cell 1", "cell 2"]


def test_the_figures_of_a_lesson_are_drawn_and_nobody_looks(run):
    draw = "from armproof.course.figures.registry import draw_kind, find_kind\nfrom armproof.models.catalogue import load_arm\n"
    assert run(draw + "draw_kind(find_kind('sketch'), load_arm('scara'))").errors == ()


def test_nothing_of_one_run_is_left_for_the_next(run):
    run("import os, numpy\nnumpy.x = 1\nopen('file', 'w').close()\nos.environ['LEFT'] = '1'")
    graded = run("import os, numpy\nprint(hasattr(numpy, 'x'), os.listdir('.'), 'LEFT' in os.environ)")
    assert graded.output.strip() == "False [] False"


def test_nothing_of_the_teachers_environment_is_seen(run, monkeypatch):
    assert "HOME" in os.environ
    seen = run("import os\nprint(sorted(os.environ), os.environ['HOME'] == os.getcwd(), os.read(0, 1))").output
    assert "True b''" in seen and not {"USER", "PYTEST_CURRENT_TEST", "PYTEST_VERSION"} & set(seen.split("'"))


def test_a_run_answers_in_the_language_of_the_grading(tmp_path, monkeypatch):
    with use("fr"):
        monkeypatch.setenv("LANGUAGE", client_environment()["LANGUAGE"])
    assert run_environment(tmp_path)["LANGUAGE"] == "fr" and client_environment()["LANGUAGE"] == "en"


def test_what_was_checked_before_the_time_was_up_counts(run):
    graded = run(OPEN, RIGHT, "import time\ntime.sleep(60)", "lesson.rank.check(3)", limits=Limits(seconds=3))
    assert graded.status is Status.TIMED_OUT and "code cell 3" in graded.reason
    assert outcomes(graded) == {"determinant": "correct (proved)"}


@pytest.mark.parametrize("kind", QUICK)
def test_a_hostile_submission_is_marked_and_does_no_harm(kind, run, client, scratch):
    hostile = KINDS[kind]
    missing = [ATTEMPTS[name] for name in hostile.needs if not client.held[name]]
    if missing:
        pytest.skip(f"this system does not have: a submission {missing[0]}")
    precious = scratch / "precious"
    graded = run(OPEN, hostile.cell.format(scratch=str(scratch), process=os.getpid()))
    assert graded.status in hostile.statuses, graded
    assert "ESCAPED" not in graded.output
    assert precious.read_text(encoding="utf-8") == "precious" and len(list(scratch.iterdir())) == 1
    assert graded.right == 0
    assert run(OPEN, RIGHT).right == 1  # the next one is graded as ever


def test_an_endless_loop_is_ended(run):
    assert run("while True: pass", limits=SHORT).status is Status.TIMED_OUT
    assert run("for _ in range(10): pass").status is Status.GRADED


def test_a_function_of_the_checks_that_was_replaced_is_named(run):
    graded = run(OPEN, KINDS["patches-the-check"].cell)
    assert graded.remarks == ("it changed what checks the answers: armproof.course.feedback.task.Task._judge",)
    assert outcomes(graded)["jacobian"] == "error"
    assert not run(OPEN, RIGHT).remarks


def test_a_class_is_graded_into_tables_and_pages(client, write, tmp_path, monkeypatch):
    monkeypatch.setattr("armproof.course.grading.grading.Client", lambda *_, **__: contextlib.nullcontext(client))
    write("anna.ipynb", OPEN, RIGHT)
    write('l\'élève "x"/<b>.ipynb', OPEN, "import os", "os._exit(0)")
    result = CliRunner().invoke(app, ["grade", str(tmp_path / "class"), "--out", str(tmp_path / "out"), "--jobs", "1"])
    assert result.exit_code == 1, result.output
    assert "2 submissions: 1 graded, 1 crashed" in result.stdout and "code cell 3 by exit code 0" in result.stdout
    with (tmp_path / "out/results.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["outcome"] != "not attempted"]
    assert [(row["student"], row["task"], row["outcome"]) for row in rows] == [
        ("anna", "determinant", "correct (proved)")
    ]
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"index.html", "anna.html", "l-eleve-x.html", *TABLES}  # fmt: skip


def test_a_class_is_graded_without_bubblewrap_only_if_that_is_asked_for(write, tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda *_: None)
    write("anna.ipynb", OPEN, RIGHT)
    command = ["grade", str(tmp_path / "class"), "--out", str(tmp_path / "out"), "--jobs", "1"]
    refused = CliRunner().invoke(app, command)
    assert refused.exit_code == 2 and "there is no program 'bwrap'" in refused.stderr
    assert "--unprotected" in refused.stderr and not (tmp_path / "out").exists()
    result = CliRunner().invoke(app, [*command, "--unprotected"])
    assert "1 submission: 1 graded" in result.stdout, result.output
    assert f"not so on this system: a submission {ATTEMPTS['read']}" in " ".join(result.stderr.split())
    assert "✗ not in force" in (tmp_path / "out/index.html").read_text(encoding="utf-8")
