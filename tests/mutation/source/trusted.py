"""The trusted base, as ARCHITECTURE.md has it, and the tests that speak of each of its files."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
TRUSTED = {  # a room → the names of its files that are trusted; "-" before names: all but these
    "models/loading": "",
    "models/dh": "",
    "models/exact": "trace symbolic chain polynomial numbers offset",
    "verification/document": "",
    "verification/latex": "- writer",
    "verification/naming": "",
    "verification/equations": "definitions new_letters given_values general_links readings roles"
    " chain equality alignment sides second_route inequalities",
    "verification/evaluation": "- sampled",
    "verification/algebra": "ring polynomials roots angles calculus matrix protocol",
    "verification/conditions": "",
    "verification/singularities": "half_angles decomposition elimination factors minors variety probe",
    "verification/tables": "- mend plant",
    "verification/functions/tracing": "",
    "verification/functions": "proof traced_function",
    "verification": "display check verdict",
}
COURSE = ("tests/verification/test_soundness.py", "course/handouts")  # false twins are refuted, what is right is proved
NEAREST = {  # the tests of a room that has no folder of its own name, or that are spread over others
    "models/exact": ("tests/models/exact", "tests/models/dh", "tests/models/loading"),
    "verification/functions/tracing": ("tests/verification/functions",),
    "verification": (
        "tests/verification/test_check.py",
        "tests/verification/test_verdict.py",
        "tests/verification/test_equation.py",
        "tests/verification/diagnosis/test_display.py",
    ),
}


def trusted_files() -> list[str]:
    """Return the files of the trusted base, from the project's folder."""
    return [file for room, names in TRUSTED.items() for file in _of_room(room, names.split())]


def _of_room(room: str, names: list[str]) -> list[str]:
    present = sorted(path.stem for path in (ROOT / room).glob("*.py") if path.stem != "__init__")
    if not names or names[0] == "-":
        return [f"{room}/{stem}.py" for stem in present if stem not in names]
    return [f"{room}/{stem}.py" for stem in names]


def selection(file: str) -> tuple[list[str], list[str], list[str]]:
    """Return the tests to run on a change of a file: those that are named after it, of its room, and of the course."""
    path = Path(file)
    room = path.parent.as_posix()
    folders = [folder for folder in NEAREST.get(room, (f"tests/{room}",)) if (ROOT / folder).exists()]
    own = [
        found.relative_to(ROOT).as_posix()
        for folder in folders
        for found in (ROOT / folder).glob(f"test_{path.stem}*.py")
    ]
    return sorted(own), folders, list(COURSE)
