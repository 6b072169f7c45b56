"""Grade 200 generated submissions, a third of them hostile: all are graded, the hostile ones marked, nothing else is affected.

    python -m tests.sweeps.grading [SUBMISSIONS] [JOBS]

The ordinary ones are the lessons of the course, solved and as students get them; each is to have the results that it has alone.
What harms is in tests/course/grading/hostile.py; a kind whose protection is not in force on this system is left out, and said.
"""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import armproof.course
from armproof.course.grading.grades import Grades
from armproof.course.grading.pages import render_index
from armproof.course.grading.results import Graded, Status
from armproof.course.grading.running.client import Client
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import Submission
from armproof.course.sources.editions import instructor_notebook, student_notebook
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.models.errors import ArmproofError
from armproof.verification.running.processes import cores
from tests.course.grading.conftest import notebook
from tests.course.grading.hostile import BROKEN, KINDS

SECONDS, MEMORY = 15, 700
OPEN = "from armproof import open_lesson\nlesson = open_lesson('scara_jacobian')"
RIGHT = "lesson.determinant.check(lesson.determinant.right[0])"
GRADE = [sys.executable, "-c", "from armproof.verification.cli import main; main()", "grade"]
Expected = dict[str, tuple[Status, ...]]


def main(number: int, jobs: int) -> int:
    """Grade so many submissions; 0 if everything is as it should be."""
    held = _held()
    print(f"protections in force: {', '.join(name for name, is_held in held.items() if is_held) or 'none'}")
    with tempfile.TemporaryDirectory(prefix="grading-sweep-") as name:
        folder = Path(name)
        folder.chmod(0o755)
        scratch = folder / "scratch"
        scratch.mkdir()
        _put_precious(scratch)
        hostile = dict(_write_hostile(folder / "class", scratch, held))
        ordinary = _write_ordinary(folder / "class", number - len(hostile))
        before = _processes(), _listing(folder / "class"), _listing(scratch)
        seconds = _grade(folder / "class", folder / "out", jobs)
        after = _processes(), _listing(folder / "class"), _listing(scratch)
        faults = _check(folder / "out", hostile, ordinary)
        faults += [f"{what} changed" for what, one, two in zip(("the class", "the scratch folder"), before[1:], after[1:], strict=True)
                   if one != two]  # fmt: skip
        faults += [f"a process is left: {left}" for left in after[0] - before[0]]
        faults += [
            f"escaped: {place}"
            for place in ("/tmp", "/var/tmp", "/dev/shm")
            if os.path.exists(f"{place}/armproof-escaped")
        ]
        alone = _grade_ordinary(folder, ordinary, jobs)
    faults += _lose_the_server()
    for fault in faults:
        print(f"FAULT {fault}")
    print(f"{number} submissions, {len(hostile)} hostile, {jobs} at once, limit {SECONDS} s: {seconds:.1f} s, "
          f"{number / seconds / jobs:.2f} a second and core")  # fmt: skip
    print(
        f"the {len(ordinary)} ordinary ones alone: {alone:.1f} s, {len(ordinary) / alone / jobs:.2f} a second and core"
    )
    print("all as it should be" if not faults else f"{len(faults)} faults")
    return 1 if faults else 0


def _held() -> dict[str, bool]:
    """Return the protections in force, after a run that does nothing."""
    with Client(1, Limits(seconds=SECONDS)) as client:
        assert client.run(["print('ready')"]).output == "ready\n"
        return client.held


def _put_precious(scratch: Path) -> None:
    """Put up what hostile submissions try to destroy: anybody may write there, but for the sandbox."""
    for number in range(20):
        (scratch / f"file-{number}").write_text("precious", encoding="utf-8")
        (scratch / f"file-{number}").chmod(0o666)
    (scratch / "precious").write_text("precious", encoding="utf-8")
    (scratch / "precious").chmod(0o666)
    scratch.chmod(0o777)


def _write_hostile(folder: Path, scratch: Path, held: dict[str, bool]) -> Iterator[tuple[str, tuple[Status, ...]]]:
    """Write the hostile submissions; yields each one's file with the statuses that it may get."""
    for kind, hostile in KINDS.items():
        missing = [name for name in hostile.needs if not held[name]]
        if missing:
            print(f"not tried, as this system does not protect from it: {kind} ({', '.join(missing)})")
            continue
        target = str(folder / "solved-1") if kind == "deletes-a-folder" else str(scratch)
        cell = hostile.cell.format(scratch=target, process=os.getpid())
        yield _write(folder, f"hostile {kind}", notebook(OPEN, cell)), hostile.statuses
    for kind, data in BROKEN.items():
        yield _write(folder, f"broken {kind}", data), (Status.UNREADABLE,)
    link = folder / "a link" / '<script>é".ipynb'
    link.parent.mkdir()
    link.symlink_to(folder / "solved-1" / "lesson.ipynb")
    yield 'a link/<script>é".ipynb', (Status.UNREADABLE,)
    os.mkfifo(folder / "pipe.ipynb")
    yield "pipe.ipynb", (Status.UNREADABLE,)
    yield _write(folder, "many cells", notebook(OPEN, *["x = 1"] * 3000)), (Status.GRADED,)


def _write_ordinary(folder: Path, number: int) -> dict[str, bool]:
    """Write the ordinary submissions; returns each one's file, and whether it is solved."""
    sources = list(_lessons())
    ordinary = {}
    for place in range(number):
        source, solved = sources[place // 2 % len(sources)], place % 4 != 3
        data = instructor_notebook(source) if solved else student_notebook(source)
        ordinary[_write(folder, f"{'solved' if solved else 'blank'}-{place}", data)] = solved
    return ordinary


def _lessons() -> Iterator[LessonSource]:
    for path in sorted((Path(armproof.course.__path__[0]) / "lessons").glob("*.py")):
        try:
            yield read_lesson_source(path)
        except ArmproofError as error:
            print(f"left out: {error}")


def _write(folder: Path, student: str, data: bytes) -> str:
    path = folder / student / "lesson.ipynb"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    return f"{student}/lesson.ipynb"


def _grade(folder: Path, out: Path, jobs: int) -> float:
    """Run the command; returns the seconds that it took."""
    started = time.monotonic()
    options = ["--out", str(out), "--jobs", str(jobs), "--seconds", str(SECONDS), "--memory", str(MEMORY)]
    run = subprocess.run([*GRADE, str(folder), *options], capture_output=True, text=True, check=False)
    seconds = time.monotonic() - started
    print(run.stdout, run.stderr, sep="", end="")
    return seconds


def _grade_ordinary(folder: Path, ordinary: dict[str, bool], jobs: int) -> float:
    """Grade the ordinary submissions alone; returns the seconds that it took."""
    kept = {folder / "class" / file for file in ordinary}
    for path in [path for path in (folder / "class").rglob("*.ipynb") if path not in kept]:
        path.unlink()
    return _grade(folder / "class", folder / "alone", jobs)


def _check(out: Path, hostile: Expected, ordinary: dict[str, bool]) -> list[str]:
    """Return what is not as it should be in the tables and pages."""
    rows = {row["file"]: row for row in _rows(out / "submissions.csv")}
    faults = [f"no line for {file}" for file in {*hostile, *ordinary} - set(rows)]
    print("statuses:", dict(Counter(row["status"] for row in rows.values())))
    for file, statuses in hostile.items():
        if file in rows and rows[file]["status"] not in {status.value for status in statuses}:
            faults.append(f"{file}: {rows[file]['status']} ({rows[file]['reason']})")
        if file in rows and int(rows[file]["right"]):
            faults.append(f"{file}: {rows[file]['right']} right")
    for file, solved in ordinary.items():
        right, tasks = int(rows[file]["right"]), int(rows[file]["tasks"])
        if rows[file]["status"] != "graded" or not tasks or right != (tasks if solved else 0):
            faults.append(f"{file}: {rows[file]['status']} {rows[file]['reason']}, {right} of {tasks} right")
    outcomes = Counter(row["outcome"] for row in _rows(out / "results.csv") if row["file"] in ordinary)
    print("outcomes of the ordinary ones:", dict(outcomes))
    faults += [
        f"ESCAPED in {page.name}" for page in out.glob("*.html") if "ESCAPED" in page.read_text(encoding="utf-8")
    ]
    faults += [
        f"markup in {page.name}" for page in out.glob("*.html") if "<script>alert" in page.read_text(encoding="utf-8")
    ]
    evil = Graded(Submission("<script>alert", Path(), ""), Status.GRADED)
    assert "&lt;" in render_index(Grades((evil,), {}, Limits()), {"<script>alert": ""}, lambda _: "")  # the control
    return faults


def _rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


def _listing(folder: Path) -> str:
    """Return what is in a folder, with sizes, modes and times of change."""
    states = {str(path): os.lstat(path) for path in sorted(folder.rglob("*"))}
    return json.dumps({path: (state.st_size, state.st_mode, state.st_mtime_ns) for path, state in states.items()})


def _processes() -> set[str]:
    """Return the processes that work in a folder of a run."""
    found = set()
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            place = os.readlink(entry / "cwd")
        except OSError:
            continue
        if "armproof-grade-" in place:
            found.add(entry.name)
    return found


def _lose_the_server() -> list[str]:
    """Kill the server: the next submission starts it anew."""
    with Client(1, Limits(seconds=SECONDS)) as client:
        client._server.kill()
        client._server.wait()
        return [] if client.run(["print(1)"]).output == "1\n" else ["a lost server was not started anew"]


if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:]]
    sys.exit(main(*(given + [200, cores()][len(given) :])))
