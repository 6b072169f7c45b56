"""The report's folder: whole at every moment, and nothing of anybody else's is touched."""

import os
import random
import signal
import time
from pathlib import Path

import pytest

from armproof.verification.report.html.folder import ReportFolderError, new_report
from armproof.verification.report.html.site import VERDICTS
from armproof.verification.report.html.templating import GENERATOR

PAGES = 30
KILLS = 100 if os.environ.get("ARMPROOF_SWEEP") else 25


def write(folder: Path, content: str, count: int = PAGES) -> None:
    for k in range(count):
        head = f'<meta name="generator" content="{GENERATOR}">'
        (folder / f"page-{k}.html").write_text(f"{head}{content}", encoding="utf-8")


def contents(folder: Path) -> set[str]:
    found = [page.read_text(encoding="utf-8") for page in folder.iterdir()]
    assert len(found) == PAGES
    return set(found)


def test_a_report_replaces_the_one_before_whole(tmp_path: Path) -> None:
    target = tmp_path / "new" / "report"
    for content in ("first", "second"):
        with new_report(target) as part:
            assert part != target
            write(part, content)
        assert len(contents(target)) == 1 and content in contents(target).pop()
    assert [path.name for path in target.parent.iterdir()] == ["report"]
    assert target.stat().st_mode & 0o777 == 0o777 & ~_umask()


def test_an_error_leaves_the_report_before(tmp_path: Path) -> None:
    with new_report(tmp_path / "report") as part:
        write(part, "first")
    with pytest.raises(KeyboardInterrupt), new_report(tmp_path / "report") as part:
        write(part, "second", 3)
        raise KeyboardInterrupt
    assert "first" in contents(tmp_path / "report").pop()
    assert [path.name for path in tmp_path.iterdir()] == ["report"]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_kills_at_random_leave_a_whole_report(tmp_path: Path) -> None:
    target = tmp_path / "report"
    for content in ("first", "0"):
        started = time.perf_counter()
        with new_report(target) as part:
            write(part, content)
    wait = 3 * (time.perf_counter() - started) + 0.01
    chance = random.Random(11)
    seen = set()
    for _ in range(KILLS):
        child = os.fork()
        if child == 0:
            round_ = 0
            while True:
                round_ += 1
                with new_report(target) as part:
                    write(part, str(round_))
        time.sleep(chance.uniform(0.0, wait))
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        found = contents(target)
        assert len(found) == 1
        seen |= found
        wait *= 1.1 if len(seen) == 1 else 1.0  # until some finish: a child of a large process begins slowly
    assert len(seen) > 1  # some finished a report before they were killed at the next
    with new_report(target) as part:
        write(part, "last")
    assert [path.name for path in tmp_path.iterdir()] == ["report"]  # what the killed ones left is gone


@pytest.mark.parametrize("name", ["notes.txt", "page.html", VERDICTS + "/inside"])
def test_a_folder_that_holds_anything_else_is_not_touched(tmp_path: Path, name: str) -> None:
    target = tmp_path / "folder"
    (target / name).parent.mkdir(parents=True)
    (target / name).write_text("mine", encoding="utf-8")
    with pytest.raises(ReportFolderError, match="which is no part of a report"), new_report(target):
        pass
    assert (target / name).read_text(encoding="utf-8") == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]


def test_a_file_the_working_folder_and_what_cannot_be_written_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("mine", encoding="utf-8")
    for target, words in (("file", "not a folder"), ("file/report", "the report cannot be written")):
        with pytest.raises(ReportFolderError, match=words), new_report(tmp_path / target):
            pass
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    with pytest.raises(ReportFolderError, match="the working folder"), new_report(Path(".")):
        pass
    with pytest.raises(ReportFolderError, match="cannot be written"), new_report(Path("/proc/report")):
        pass


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
