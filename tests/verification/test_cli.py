"""The command: exit codes, the three reports, and what stands on which stream."""

import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from armproof.models.catalogue import arm_names
from armproof.models.errors import ModelError
from armproof.verification import check as checking
from armproof.verification.cli import app
from armproof.verification.cli.documents import Progress, check_paths
from armproof.verification.findings import Kind, say
from armproof.verification.report.github import github_report
from armproof.verification.report.json_ import json_report
from armproof.verification.report.text import text_report, to_ascii
from armproof.verification.running import processes
from armproof.verification.running.processes import check_each
from armproof.verification.verdict import DocumentResult, Failure, Record, Verdict, WrongEntry

ARMPROOF = Path(sys.executable).with_name("armproof")
FRONT = "---\narm: planar_2r\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n\n# The Jacobian\n\n"
RIGHT = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"
WRONG = (
    r"$$ J_v = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix} $$"
    + "\n\n"
)
ERRATUM = "> **Erratum** (as printed)\n> $$ C_{12} = S_{12} $$\n\n"
TRUE_ERRATUM = "> **Erratum**\n> $$ C_{12} = C_{12} $$\n\n"
UNBOUND = "$$ C_{12} = k_9 + k_8 $$\n\n"
UNREADABLE = "$$ C_{12} = } $$\n\n"


@dataclass(frozen=True)
class Run:
    """What a command did."""

    code: int
    stdout: str
    stderr: str


@pytest.fixture
def armproof(capsys: pytest.CaptureFixture[str]) -> Callable[..., Run]:
    """Run the command in this process."""

    def run(*arguments: object) -> Run:
        with pytest.raises(SystemExit) as end:
            app([str(argument) for argument in arguments], prog_name="armproof")
        captured = capsys.readouterr()
        return Run(int(end.value.code or 0), captured.out, captured.err)

    return run


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., Path]:
    """Write a document of the parts given."""

    def to_file(*parts: str, name: str = "page.md") -> Path:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(FRONT + "".join(parts), encoding="utf-8")
        return path

    return to_file


def spawn(*arguments: object, **options: object) -> Run:
    """Run the command as its own process."""
    run = subprocess.run([ARMPROOF, *map(str, arguments)], capture_output=True, text=True, timeout=60, **options)
    return Run(run.returncode, run.stdout, run.stderr)


# -- exit codes --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("parts", "code", "strict_code"),
    [
        ((RIGHT,), 0, 0),
        ((RIGHT, ERRATUM), 0, 0),
        ((RIGHT, UNBOUND), 0, 1),
        ((RIGHT, WRONG), 1, 1),
        ((RIGHT, TRUE_ERRATUM), 1, 1),
        ((RIGHT, UNREADABLE), 1, 1),
    ],
)
def test_the_exit_code_says_whether_everything_passes(
    armproof, write, parts: tuple[str, ...], code: int, strict_code: int
):
    path = write(*parts)
    assert armproof("verify", path).code == code
    assert armproof("verify", "--strict", path).code == strict_code


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["verify", "--format", "html"], "'html' is not one of 'text', 'json', 'github'"),
        (["verify", "--frobnicate"], "No such option: --frobnicate"),
        (["prove"], "No such command 'prove'"),
        (["view"], "Missing argument 'ARM'"),
    ],
)
def test_a_usage_error_exits_with_2_and_says_what_is_valid(armproof, arguments: list[str], message: str):
    run = armproof(*arguments)
    assert (run.code, run.stdout) == (2, "")
    assert message in re.sub(r"\s+", " ", run.stderr)


def test_one_document_that_cannot_be_checked_does_not_hide_the_others(armproof, write, tmp_path: Path):
    good, bad = write(RIGHT, name="good.md"), tmp_path / "bad.md"
    bad.write_text("---\narm: skara\n---\n", encoding="utf-8")
    run = armproof("verify", tmp_path / "missing.md", bad, good, "--format", "json")
    report = json.loads(run.stdout)
    assert run.code == 2
    assert [document["path"] for document in report["documents"]] == [str(good)]
    assert report["documents"][0]["passed"] is True
    assert [(error["path"], error["line"]) for error in report["errors"]] == [
        (str(tmp_path / "missing.md"), None),
        (str(bad), 2),
    ]
    first, second = run.stderr.splitlines()
    assert first == f"armproof: {tmp_path / 'missing.md'}: no such file or folder"
    assert second.startswith(f"armproof: {bad}:2: no arm 'skara'; an arm is one of kr210, planar_2r")


def test_a_fault_of_our_own_is_reported_without_a_traceback(armproof, write, monkeypatch: pytest.MonkeyPatch):
    good, other = write(RIGHT, name="good.md"), write(RIGHT, name="other.md")
    verify = checking.verify
    monkeypatch.setattr(checking, "verify", lambda path, **options: {}["theta_9"] if path == other else verify(path))
    run = armproof("verify", other, good)
    assert run.code == 2
    assert f"passes {good}" in run.stdout
    fault = "internal error of Armproof, please report it: KeyError: 'theta_9'"
    assert re.fullmatch(rf"armproof: {re.escape(f'{other}: {fault}')}( at .*)?\n", run.stderr)


# -- JSON --------------------------------------------------------------------------------------------------------------


def test_the_json_report_keeps_the_contract(armproof, write):
    path = write(RIGHT, WRONG, ERRATUM, UNBOUND, UNREADABLE)
    run = armproof("verify", path, "--format", "json")
    report = json.loads(run.stdout)
    assert list(report) == ["documents", "summary"]
    assert report["summary"] == {
        "proved": 1,
        "confirmed": 0,
        "defined": 0,
        "beyond": 0,
        "refuted": 2,
        "unchecked": 1,
        "unreadable": 1,
    }
    [document] = report["documents"]
    assert {"path": str(path), "arm": "planar_2r", "passed": False}.items() <= document.items()
    assert len(document["equations"]) == path.read_text().count("$$") / 2
    keys = [
        "line",
        "latex",
        "verdict",
        "erratum",
        "message",
        "findings",
        "outcomes",
        "entries",
        "counterexample",
        "samples",
        "max_error",
        "arm_index",
    ]
    assert all(list(equation) == keys for equation in document["equations"])
    proved, refuted, erratum, *_ = document["equations"]
    assert (proved["line"], proved["verdict"], proved["samples"]) == (9, "proved", 1000)
    assert proved["max_error"] < 1e-12
    assert (refuted["line"], refuted["verdict"], refuted["erratum"]) == (11, "refuted", False)
    [entry] = refuted["entries"]
    assert (entry["equation"], entry["row"], entry["column"]) == (1, 1, 2)
    assert entry["printed"] == "l_2 S_{12}"
    assert set(refuted["counterexample"]) == {"theta_1", "theta_2"}
    assert (erratum["verdict"], erratum["erratum"]) == ("refuted", True)


def test_nothing_but_the_json_object_is_written_on_standard_output(write):
    run = spawn("verify", write(RIGHT, WRONG), "--format", "json")
    assert (run.code, run.stderr) == (1, "")
    assert json.loads(run.stdout)["summary"]["refuted"] == 1
    assert run.stdout.isascii()


def test_strict_reports_an_unchecked_document_as_failed(armproof, write):
    path = write(RIGHT, UNBOUND)
    reports = [json.loads(armproof("verify", path, "--format", "json", *flag).stdout) for flag in ([], ["--strict"])]
    assert [report["documents"][0]["passed"] for report in reports] == [True, False]


def test_numbers_that_json_cannot_write_become_null():
    record = Record(1, "x", Verdict.PROVED, max_error=float("nan"), counterexample={"theta_1": float("inf")})
    report = json.loads(json_report([DocumentResult("a.md", "", (record,))]), parse_constant=pytest.fail)
    [equation] = report["documents"][0]["equations"]
    assert (equation["max_error"], equation["counterexample"]) == (None, {"theta_1": None})


# -- text --------------------------------------------------------------------------------------------------------------


def test_the_text_report_shows_each_wrong_entry_with_its_correction(armproof, write):
    path = write(RIGHT, WRONG, ERRATUM, TRUE_ERRATUM, UNBOUND)
    out = armproof("verify", path).stdout
    assert out.splitlines()[0].startswith(
        f"FAILS  {path} (planar_2r)  5 displays: 2 proved, 1 refuted, 1 unchecked, 1 erratum"
    )
    assert "line 11  refuted  The Jacobian" in out
    printed, correct = re.search(r"row 1, column 2 +printed  (.+)\n +correct  (.+?)(?:   \(.*)?\n", out).groups()
    assert (printed, re.sub(r"\s", "", correct)) == ("l_2 S_{12}", "-l_2S_{12}")
    assert re.search(r"for example at theta_1 = -?\d.*, theta_2 = -?\d", out)
    assert "line 17  erratum not refuted but proved" in out
    assert "line 19  unchecked" in out
    assert "'k_9' is not bound" in out
    assert "errata refuted, as they must be: line 14" in out
    assert "1 document, 5 displays: 2 proved, 1 refuted, 1 unchecked, 1 erratum refuted" in out
    verdict, *causes = out.splitlines()[-2:]
    assert verdict == "1 document does not pass; 1 of 5 equations not decided"
    assert causes == ["  1 × a name is not bound: bind it in the front matter: quantities: …"]


def test_an_endless_entry_is_cut_short_for_people_and_whole_for_programs():
    entry = WrongEntry(1, None, None, "a", "a + " * 1_000 + "a")
    results = [DocumentResult("page.md", "", (Record(3, "x", Verdict.REFUTED, entries=(entry,)),))]
    assert max(len(text) for line in text_report(results) for text, _ in line) == 600
    assert json.loads(json_report(results))["documents"][0]["equations"][0]["entries"][0]["correct"] == entry.correct


def test_an_entry_names_its_equation_where_there_are_several():
    entry = WrongEntry(2, 1, 3, "a", "b")
    for latex, place in (("p = a", "row 1, column 3"), ("p = q = a", "equation 2, row 1, column 3")):
        lines = text_report([DocumentResult("page.md", "", (Record(3, latex, Verdict.REFUTED, entries=(entry,)),))])
        assert f"        {place}   printed  a" in ["".join(text for text, _ in line) for line in lines]


def test_what_passes_takes_one_line(armproof, write):
    out = armproof("verify", write(RIGHT, name="a.md"), write(RIGHT, RIGHT, name="b.md")).stdout.splitlines()
    assert [line.split("  ")[-1] for line in out[:2]] == ["1 display: 1 proved", "2 displays: 2 proved"]
    assert out[2:4] == ["", "2 documents, 3 displays: 3 proved"]
    assert re.fullmatch(
        r"evaluated on Drake's numerical plant at 1,000 configurations: largest error \d\.\de-1\d, in .*[ab]\.md",
        out[4],
    )
    assert out[5:] == ["everything passes"]


def test_a_notebook_is_reported_by_cell(armproof, tmp_path: Path):
    path = tmp_path / "lesson.ipynb"
    cells = [{"cell_type": "markdown", "source": source} for source in (FRONT, "First.\n\n" + WRONG)]
    path.write_text(json.dumps({"cells": cells}), encoding="utf-8")
    assert "cell 1, line 3  refuted" in armproof("verify", path).stdout
    assert (
        f"::error file={path},title=Armproof%3A refuted::cell 1, line 3%0A"
        in armproof("verify", path, "--format", "github").stdout
    )


def test_the_text_report_is_ascii_in_the_c_locale(tmp_path: Path):
    path = tmp_path / "page.md"
    path.write_text(
        "---\ntitle: x\n---\n\n# Cinématique, θ × ω\n\n$$ \\det(1 = 2 $$\n\n$$ 1 = 2 $$\n", encoding="utf-8"
    )
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("LC_", "LANG", "PYTHON"))}
    run = spawn("verify", path, env={**environment, "LC_ALL": "C"})
    assert run.code == 1
    assert run.stdout.isascii()
    assert "Cinematique, theta x omega" in run.stdout


def test_every_character_has_an_ascii_spelling():
    assert to_ascii("θ₁ ⇒ é ≤ ±1 ☃") == r"theta_1 => e <= +-1 \u2603"


def test_control_characters_of_a_document_never_reach_the_terminal(armproof, write):
    run = armproof("verify", write("$$ C_{12} = \x1b[31m\x07 $$\n"))
    assert "unreadable" in run.stdout
    assert not re.search(r"[\x00-\x09\x0b-\x1f]", run.stdout)


# -- GitHub ------------------------------------------------------------------------------------------------------------


def test_github_gets_one_annotation_a_finding(armproof, write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    path = write(RIGHT, WRONG, ERRATUM, TRUE_ERRATUM, UNBOUND, name="sheets/a,b.md")
    lines = armproof("verify", path, "missing.md", "--format", "github").stdout.splitlines()
    commands = [line for line in lines if line.startswith("::")]
    assert [command.partition("::Armproof")[0].split(",title")[0] for command in commands] == [
        "::error file=sheets/a%2Cb.md,line=11",
        "::error file=sheets/a%2Cb.md,line=17",
        "::warning file=sheets/a%2Cb.md,line=19",
        "::error file=missing.md",
    ]
    assert "title=Armproof%3A refuted::" in commands[0]
    assert "%0Arow 1, column 2: printed l_2 S_{12}, correct -l_2 S_{12}" in commands[0]
    assert commands[-1].endswith("cannot be checked::no such file or folder")
    assert lines[-2] == "1 document does not pass; 1 could not be checked; 1 of 5 equations not decided"
    strict = armproof("verify", path, "--strict", "--format", "github").stdout
    assert "::error file=sheets/a%2Cb.md,line=19" in strict


def test_github_commands_escape_what_would_end_them():
    record = Record(
        3,
        "x",
        Verdict.REFUTED,
        findings=(say(Kind.PROBLEM, reason="100%\nof ::error"),),
        entries=(WrongEntry(1, None, None, "a", "b"),),
    )
    [command, *_] = github_report([DocumentResult("a:b.md", "", (record,))])
    assert (
        command == "::error file=a%3Ab.md,line=3,title=Armproof%3A refuted::100%25%0Aof ::error%0Aprinted a, correct b"
    )


# -- many documents ----------------------------------------------------------------------------------------------------


def without_times(results: list[DocumentResult | Failure]) -> list[DocumentResult | Failure]:
    return [replace(result, seconds=0.0) if isinstance(result, DocumentResult) else result for result in results]


def test_several_processes_give_the_results_of_one_in_the_same_order(write, tmp_path: Path):
    paths = [
        write(*[part] * count, name=f"{k}.md") for k, (part, count) in enumerate([(RIGHT, 1), (WRONG, 2), (UNBOUND, 9)])
    ]
    paths.insert(1, tmp_path / "missing.md")
    assert without_times(list(check_each(paths, workers=2))) == without_times(list(check_each(paths, workers=1)))


def test_a_document_that_ends_its_process_fails_alone(write, monkeypatch: pytest.MonkeyPatch):
    paths = [write(RIGHT, name=f"{k}.md") for k in range(4)]
    check = processes.check_one

    def check_one(path: Path, **options: object) -> DocumentResult | Failure:
        if path == paths[1]:
            os._exit(134)  # as Drake does when it aborts
        return check(path)

    check_one.__module__, check_one.__qualname__ = "armproof.verification.running.processes", "check_one"
    monkeypatch.setattr(processes, "check_one", check_one)
    results = list(check_each(paths, workers=2))
    assert [isinstance(result, Failure) for result in results] == [False, True, False, False]
    assert results[1].message == f"{paths[1]}: the process that checked it ended; Drake may have aborted on its arm"


def test_a_document_named_twice_is_reported_once(write):
    path = write(RIGHT)
    assert [result.path for result in check_paths([path, path.parent, path])] == [str(path)]


def test_the_default_is_the_course_of_the_working_folder(
    armproof, write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    write(RIGHT, name="course/page.md")
    write(WRONG, name="elsewhere.md")
    monkeypatch.chdir(tmp_path)
    run = armproof("verify")
    assert run.code == 0
    assert run.stdout.startswith("passes course/page.md")


def test_the_default_is_the_installed_course_elsewhere(armproof, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(
        "armproof.verification.cli.verify.check_each_path",
        lambda paths, **_: [Failure(str(path), say(Kind.PROBLEM, reason="seen")) for path in paths],
    )
    report = json.loads(armproof("verify", "--format", "json").stdout)
    assert [Path(error["path"]) for error in report["errors"]] == [Path(processes.__file__).parents[2] / "course"]


def test_a_report_that_nobody_takes_ends_without_a_traceback(write):
    with open("/dev/full", "w") as full:
        run = subprocess.run(
            [ARMPROOF, "verify", write(RIGHT)], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60
        )
    assert (run.returncode, run.stderr) == (2, "armproof: cannot write the report: No space left on device\n")


def test_documents_that_end_processes_fail_alone_among_many(write, monkeypatch: pytest.MonkeyPatch):
    paths = [write(RIGHT, name=f"{k}.md") for k in range(40)]
    check = processes.check_one

    def check_one(path: Path, **options: object) -> DocumentResult | Failure:
        if path in (paths[3], paths[37]):
            os._exit(134)
        return check(path)

    check_one.__module__, check_one.__qualname__ = "armproof.verification.running.processes", "check_one"
    monkeypatch.setattr(processes, "check_one", check_one)
    monkeypatch.setattr(processes, "AHEAD", 2)
    results = list(check_each(paths, workers=2))
    assert [result.path for result in results] == [str(path) for path in paths]
    assert [k for k, result in enumerate(results) if isinstance(result, Failure)] == [3, 37]


def test_results_come_one_by_one_and_no_more_are_begun_than_are_needed(write, monkeypatch: pytest.MonkeyPatch):
    begun: list[Path] = []
    check = processes.check_one
    monkeypatch.setattr(processes, "check_one", lambda path, **options: begun.append(path) or check(path))
    paths = [write(RIGHT, name=f"{k}.md") for k in range(4)]
    results = check_each(paths, 1)
    assert next(results).path == str(paths[0])
    assert begun == paths[:1]


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_the_number_of_processes_changes_nothing_in_the_report(armproof, write, jobs: str):
    folder = write(RIGHT, WRONG, name="sheets/a.md").parent
    write(RIGHT, UNBOUND, name="sheets/b.md")
    reports = [armproof("verify", "-j", number, folder, "--format", "json").stdout for number in (jobs, "1")]
    assert reports[0] == reports[1]
    assert reports[0] == json.dumps(json.loads(reports[0]), indent=1) + "\n"


def test_no_process_at_all_is_refused(armproof, write):
    run = armproof("verify", "--jobs", "0", write(RIGHT))
    assert run.code == 2
    assert "Invalid value for '--jobs' / '-j'" in run.stderr


def test_the_bar_is_shown_on_a_terminal_alone_and_taken_away(monkeypatch: pytest.MonkeyPatch):
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    for stream, shown in ((Terminal(), True), (io.StringIO(), False)):
        monkeypatch.setattr(sys, "stderr", stream)
        monkeypatch.setattr("armproof.verification.cli.documents.SILENT", -1.0)
        with Progress(3) as progress:
            progress.advance()
            assert ("1 of 3 documents" in stream.getvalue()) == shown
            progress.advance()
        assert stream.getvalue().endswith("\r\x1b[K") == shown


# -- the other commands ------------------------------------------------------------------------------------------------


def test_help_and_version_load_neither_drake_nor_numpy():
    heavy = "{'pydrake', 'numpy', 'lark', 'yaml', 'flint', 'rich', 'markdown_it'}"
    program = f"import sys, armproof.verification.cli; print(sorted({heavy} & set(sys.modules)))"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert run.stdout == "[]\n", run.stderr


def test_the_version_is_that_of_the_package(armproof):
    run = armproof("--version")
    assert run.code == 0
    assert re.fullmatch(r"armproof \d+\.\d+\.\d+\n", run.stdout)


def test_arms_lists_every_arm_with_its_joints_lengths_and_frames(armproof):
    out = armproof("arms").stdout
    assert [line.split()[0] for line in out.splitlines()[::2]] == list(arm_names())
    assert "joints theta_1 theta_2 d_3 theta_4;  lengths a_1 a_2 d_4;  frames 0 1 2 3 4" in out


def test_arms_describes_one_arm(armproof):
    out = armproof("arms", "scara").stdout
    assert re.search(r"d_3 +prismatic +0 to 0\.21 m", out)
    assert re.search(r"theta_1 +revolute +-105 to 105 deg", out)
    assert re.search(r"a_1 +0\.325 m", out)
    assert re.search(r"frames +0, 1, 2, 3, 4", out)


@pytest.mark.parametrize("command", ["arms", "view"])
def test_an_unknown_arm_is_answered_with_the_known_ones(armproof, command: str):
    run = armproof(command, "skara")
    assert (run.code, run.stdout) == (2, "")
    assert run.stderr.startswith(f"armproof: no arm 'skara'; an arm is one of {', '.join(arm_names())}, a path to")


def test_view_shows_the_arm_named(armproof, monkeypatch: pytest.MonkeyPatch):
    shown = []
    monkeypatch.setattr(
        "armproof.models.showing.viewer.view_arm", lambda arm, browser: shown.append((arm.name, browser))
    )
    assert armproof("view", "scara", "--no-browser").code == 0
    assert shown == [("scara", False)]


def test_view_says_why_an_arm_cannot_be_shown(armproof, monkeypatch: pytest.MonkeyPatch):
    def refuse(arm, browser):
        raise ModelError("arm 'scara' has no shape")

    monkeypatch.setattr("armproof.models.showing.viewer.view_arm", refuse)
    assert armproof("view", "scara") == Run(2, "", "armproof: arm 'scara' has no shape\n")


def test_a_report_without_findings_is_not_called_a_failure():
    lines = ["".join(text for text, _ in line) for line in text_report([DocumentResult("empty.md", "", ())])]
    assert lines == ["passes empty.md  0 displays", "", "1 document, 0 displays", "no claim was found"]
