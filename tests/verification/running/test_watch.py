"""Watching: what is saved is checked again at once, however an editor saves it; what vanishes is said."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from armproof.verification.cli import app
from armproof.verification.running.watch import Event, Gone, Settled, Told, Watch
from armproof.verification.verdict import DocumentResult, Failure, Verdict
from tests.forked import armproof

ARMPROOF = Path(sys.executable).with_name("armproof")
FRONT = "---\narm: planar_2r\n---\n"
RIGHT = "$$ C_{12} = C_1 C_2 - S_1 S_2 $$\n"
WRONG = RIGHT.replace("-", "+")
OTHER = "$$ S_{12} = S_1 C_2 + C_1 S_2 $$\n"


def write(path: Path, *displays: str) -> None:
    path.write_text(FRONT + "".join(f"\n{display}" for display in displays), encoding="utf-8")


class Session:
    """A watch whose events are asked for; between two looks it waits a moment."""

    def __init__(self, folder: Path) -> None:
        self.watch = Watch(lambda: sorted(folder.glob("*.md")), sleep=lambda _: time.sleep(0.002))
        list(self.watch.begin())
        self.events = self.watch.events()

    def until_settled(self) -> list[Event]:
        """Return the events up to the next result of a document, or that one is gone."""
        found: list[Event] = []
        for event in self.events:
            found.append(event)
            if not isinstance(event, Told):
                return found
        return found


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write(tmp_path / "a.md", RIGHT, OTHER)
    write(tmp_path / "b.md", RIGHT)
    return tmp_path


def test_the_changed_display_is_told_and_then_its_document(folder: Path) -> None:
    session = Session(folder)
    assert [result.passed for result in session.watch.results if isinstance(result, DocumentResult)] == [True, True]
    write(folder / "a.md", WRONG, OTHER)
    told, settled = session.until_settled()
    assert isinstance(told, Told) and (told.path.name, told.record.line, told.record.verdict) == (
        "a.md",
        5,
        Verdict.REFUTED,
    )
    assert told.seconds < 5
    assert isinstance(settled, Settled) and isinstance(settled.result, DocumentResult) and not settled.result.passed
    write(folder / "a.md", RIGHT, OTHER)
    told, settled = session.until_settled()
    assert isinstance(told, Told) and told.record.verdict is Verdict.PROVED
    assert isinstance(settled, Settled) and settled.result == session.watch.results[0]


def test_an_editor_that_saves_by_renaming_is_followed(folder: Path) -> None:
    session = Session(folder)
    write(folder / ".a.md.swp", WRONG, OTHER)
    os.replace(folder / ".a.md.swp", folder / "a.md")
    told, _ = session.until_settled()
    assert isinstance(told, Told) and told.record.verdict is Verdict.REFUTED


def test_a_save_that_changes_nothing_tells_no_display(folder: Path) -> None:
    session = Session(folder)
    os.utime(folder / "a.md")
    [settled] = session.until_settled()
    assert isinstance(settled, Settled)


def test_a_document_that_vanishes_is_said_once_and_followed_when_it_is_back(folder: Path) -> None:
    session = Session(folder)
    (folder / "a.md").unlink()
    assert session.until_settled() == [Gone(folder / "a.md")]
    assert any(isinstance(result, Failure) for result in session.watch.results)
    write(folder / "b.md", WRONG)
    assert [event.path.name for event in session.until_settled()] == ["b.md", "b.md"]
    write(folder / "a.md", RIGHT, OTHER)
    assert isinstance(session.until_settled()[-1], Settled)
    assert not any(isinstance(result, Failure) for result in session.watch.results)


def test_a_document_that_cannot_be_checked_is_told_and_mended(folder: Path) -> None:
    session = Session(folder)
    (folder / "a.md").write_text("---\narm: skara\n---\n" + RIGHT, encoding="utf-8")
    [settled] = session.until_settled()
    assert isinstance(settled, Settled) and isinstance(settled.result, Failure)
    assert "a.md:2: no arm 'skara'" in settled.result.message
    write(folder / "a.md", RIGHT)
    *_, settled = session.until_settled()
    assert isinstance(settled, Settled) and isinstance(settled.result, DocumentResult) and settled.result.passed


def test_a_new_document_of_the_folder_is_watched(folder: Path) -> None:
    session = Session(folder)
    write(folder / "c.md", WRONG)
    told, settled = session.until_settled()
    assert isinstance(told, Told) and told.path.name == "c.md" and isinstance(settled, Settled)


# -- the command -------------------------------------------------------------------------------------------------------


@pytest.fixture
def command(folder: Path) -> Iterator[subprocess.Popen[str]]:
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen([ARMPROOF, "verify", "--watch", folder], **options) as process:  # type: ignore[call-overload]
        yield process
        process.kill()


def read_until(process: subprocess.Popen[str], mark: str) -> list[str]:
    lines: list[str] = []
    assert process.stdout is not None
    for line in process.stdout:
        lines.append(line)
        if mark in line:
            return lines
    raise AssertionError((mark, lines))


@pytest.mark.parametrize("wrong", [False, True])
def test_the_command_tells_verdicts_until_it_is_ended(command, folder: Path, wrong: bool) -> None:
    assert "everything passes\n" in read_until(command, "watching 2 documents; Ctrl-C ends")
    write(folder / "b.md", WRONG)
    lines = read_until(command, "FAILS ")
    assert f"{folder / 'b.md'}:5  refuted" in lines[0]
    assert any("printed" in line for line in lines)
    if not wrong:
        write(folder / "b.md", RIGHT)
        assert f"{folder / 'b.md'}:5  proved" in read_until(command, "passes ")[0]
    command.send_signal(signal.SIGINT)
    _, errors = command.communicate(timeout=30)
    assert (command.returncode, errors) == (int(wrong), "")


def test_a_watch_that_is_ended_before_its_first_report_was_interrupted(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> Iterator[Event]:
        raise KeyboardInterrupt

    monkeypatch.setattr(Watch, "begin", interrupted)
    with pytest.raises(SystemExit) as end:
        app(["verify", "--watch", str(folder)], prog_name="armproof")
    assert (end.value.code, capsys.readouterr()) == (130, ("", ""))


@pytest.mark.parametrize(
    "options", [["--format", "json"], ["--report", "out"], ["--errata", "errata.md"], ["--scheduler", "localhost:1"]]
)
def test_a_watch_writes_text_alone(folder: Path, options: list[str]) -> None:
    run = armproof("verify", "--watch", *options, folder, folder=folder, environment=os.environ)
    assert (run.returncode, run.stdout) == (2, "")
    (told,) = run.stderr.splitlines()
    assert (
        told == "armproof: --watch writes text for people: give it none of --format, --report, --errata and --scheduler"
    )
