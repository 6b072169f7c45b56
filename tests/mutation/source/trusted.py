"""The trusted base, as the table of ARCHITECTURE.md has it, and the tests that speak of each of its files."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
COURSE = ("tests/verification/test_soundness.py", "course/handouts")  # false twins are refuted, what is right is proved
FEW = 4  # what more tests import than that, they use and are not about
NEAREST = {  # the tests of a room that has no folder of its own name, or that are spread over others
    "models/exact": ("tests/models/exact", "tests/models/dh", "tests/models/loading"),
    "verification/functions/tracing": ("tests/verification/functions",),
    "verification": (
        "tests/verification/check/test_documents.py",
        "tests/verification/test_verdict.py",
        "tests/verification/test_equation.py",
        "tests/verification/diagnosis/test_display.py",
    ),
}


def trusted_files() -> list[str]:
    """Return the files of the trusted base, from the project's folder."""
    plan = (ROOT / "ARCHITECTURE.md").read_text("utf-8").split("## The trusted base")[1]
    rows = [line.split("|")[2] for line in plan.splitlines() if line.startswith("|") and "`" in line]
    return sorted({file for row in rows for file in _of_row(row)})


def _of_row(row: str) -> list[str]:
    """Return the files of a row: `room/` alone is all of it, but for what stands behind "but"; files follow their room."""
    named, _, excepted = row.partition(" but ")
    rooms: dict[str, list[str]] = {}
    room = ""
    for place in re.findall(r"`([\w/]+(?:\.py)?)`|`([\w/]+/)`", named):
        folder, _, name = "".join(place).rpartition("/")
        room = folder or room
        rooms.setdefault(room, []).extend([name] if name else [])
    return [
        file for room, names in rooms.items() for file in (_places(room, names) if names else _all_of(room, excepted))
    ]


def _folder(room: str) -> str:
    return room if room.startswith("models") else f"verification/{room}".rstrip("/")


def _places(room: str, names: list[str]) -> list[str]:
    """Return where files stand: in their room, or loose beside the rooms."""
    inside = [f"{_folder(room)}/{name}" for name in names]
    return [file if (ROOT / file).exists() else f"verification/{Path(file).name}" for file in inside]


def _all_of(room: str, excepted: str) -> list[str]:
    files = (path for path in (ROOT / _folder(room)).glob("*.py") if path.stem != "__init__")
    return [path.relative_to(ROOT).as_posix() for path in files if f"`{path.name}`" not in excepted]


def selection(file: str) -> tuple[list[str], list[str], list[str]]:
    """Return the tests to run on a change of a file: those that are about it, of its room, and of the course."""
    path = Path(file)
    room = path.parent.as_posix()
    folders = [folder for folder in NEAREST.get(room, (f"tests/{room}",)) if (ROOT / folder).exists()]
    own = {found for folder in folders for found in (ROOT / folder).glob(f"test_{path.stem}*.py")}
    importing = _importing(".".join(path.with_suffix("").parts))
    tests = [*sorted(own), *(sorted(importing - own) if len(importing) <= FEW else ())]
    return [found.relative_to(ROOT).as_posix() for found in tests], folders, list(COURSE)


@cache
def _texts() -> dict[Path, str]:
    rooms = (ROOT / "tests/models", ROOT / "tests/verification")
    return {path: path.read_text("utf-8") for room in rooms for path in room.rglob("test_*.py")}


def _importing(module: str) -> set[Path]:
    """Return the tests that import a module."""
    return {path for path, text in _texts().items() if f"from armproof.{module} import" in text}
