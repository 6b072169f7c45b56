"""What ARCHITECTURE.md and CONTRIBUTING.md say of the house is so: files, storeys, make targets."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
PLAN = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
ROOMS = ("models", "verification", "course")
SUFFIXES = (".py", ".md", ".txt", ".lark", ".yaml", ".toml")


def named_files(text: str) -> set[str]:
    """Return what a page names as a file or a folder: `algebra/`, `check.py`."""
    return {name for name in re.findall(r"`([\w./-]+)`", text) if name.endswith("/") or Path(name).suffix in SUFFIXES}


def is_there(name: str) -> bool:
    """Whether a file or folder stands at the top level or somewhere in a room."""
    stem = name.rstrip("/")
    return (ROOT / stem).exists() or any(next((ROOT / room).rglob(stem), None) for room in (*ROOMS, "tests"))


def storeys_on_the_page(text: str, room: str) -> list[set[str]]:
    """Return what stands on each storey of a room's table, from the top."""
    table = text.split(f"### `{room}/`", 1)[1].split("\n#", 1)[0]
    rows = re.findall(r"^\| \d+ \| ([^|]*) \|", table, re.MULTILINE)
    return [set(re.findall(r"`(\w+)(?:/|\.py)`", row)) for row in rows]


def storeys_of_the_contract(room: str) -> list[set[str]]:
    (found,) = (c for c in CONTRACTS if c.get("containers") == [f"armproof.{room}"])
    return [set(layer.split(" | ")) for layer in found["layers"]]


@pytest.mark.parametrize("room", ROOMS)
def test_the_plan_shows_the_storeys_that_the_contracts_hold(room: str) -> None:
    assert storeys_on_the_page(PLAN, room) == storeys_of_the_contract(room)


def test_a_room_on_another_storey_is_noticed() -> None:
    moved = PLAN.replace("`evaluation/` |", "`algebra/` |", 1)
    assert storeys_on_the_page(moved, "verification") != storeys_of_the_contract("verification")


@pytest.mark.parametrize("page", ["ARCHITECTURE.md", "CONTRIBUTING.md"])
def test_what_a_page_names_is_there(page: str) -> None:
    named = named_files((ROOT / page).read_text(encoding="utf-8"))
    assert len(named) > 4
    assert {name for name in named if not is_there(name)} == set()


def test_a_file_that_is_not_there_is_noticed() -> None:
    (name,) = named_files("as `equations/sidez.py` has it, with `numpy`")
    assert not is_there(name)


def test_the_plan_is_no_longer_than_can_be_read() -> None:
    assert len(PLAN.splitlines()) <= 150


def test_the_make_targets_that_contributors_are_told_exist() -> None:
    targets = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    told = set(
        re.findall(r"(?:`|^    )make ([a-z]+)", (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.MULTILINE)
    )
    assert {"test", "lint", "format", "sweep", "mutation"} <= told
    assert told <= targets
