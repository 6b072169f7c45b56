"""`armproof start`: the front matter that fixes what is inferred, in each format's head."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof import verify
from armproof.verification.cli import app
from tests.verification.tables.arms.test_inference import CLASSIC, PLAIN, verdicts

PAGE = PLAIN + "\n" + CLASSIC
COMMENTED = "---\ntitle: 'Two  links' # ours\nauthor: [A,B]\n---\n" + PAGE
TEX = (
    "%!TEX root = main.tex\n% notes of ours\n\\documentclass{article}\n\\begin{document}\n"
    + CLASSIC
    + "\\end{document}\n"
)
FENCED = "% ---\n% title: Two links\n% ---\n" + CLASSIC
RST = "Two links\n=========\n\n" + "".join(
    f".. math::\n\n   {display.strip()}\n\n" for display in CLASSIC.split("$$")[1::2]
)
CELLS = {
    "cells": [{"cell_type": "markdown", "id": "a", "metadata": {}, "source": [PAGE]}],
    "metadata": {},
    "nbformat": 4,
    "nbformat_minor": 5,
}
PERCENT = "# ---\n# jupyter: {}\n# ---\n\n# %% [markdown]\n" + "".join(f"# {line}\n" for line in PAGE.split("\n"))
FORMATS = {
    "page.md": PAGE,
    "commented.md": COMMENTED,
    "crlf.md": COMMENTED.replace("\n", "\r\n"),
    "bom.md": "\ufeff" + PAGE,
    "page.tex": TEX,
    "fenced.tex": FENCED,
    "page.rst": RST,
    "comment.rst": "..\n   title: Two links\n\n" + RST,
    "page.ipynb": json.dumps(CELLS, indent=1),
    "page.py": PERCENT,
}


def start(*arguments: object) -> tuple[int, str, str]:
    found = CliRunner().invoke(app, ["start", *map(str, arguments)])
    return found.exit_code, found.stdout, found.stderr


@pytest.mark.parametrize("name", FORMATS)
def test_what_is_inserted_fixes_the_arm_and_leaves_all_else_as_it_was(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(FORMATS[name].encode())
    before = verify(path)
    assert [arm.source for arm in before.arms] != ["front matter"] and set(verdicts(before)) == {"proved"}
    assert start(path, "--write")[0] == 0
    written = path.read_bytes()
    after = verify(path)
    assert [arm.source for arm in after.arms] == ["front matter"] and set(verdicts(after)) == {"proved"}
    old = FORMATS[name].encode().splitlines(keepends=True)
    kept = iter(written.splitlines(keepends=True))
    assert all(
        any(line.removeprefix(b"\xef\xbb\xbf") == kept_line.removeprefix(b"\xef\xbb\xbf") for kept_line in kept)
        for line in old[1:]
    )
    assert (b"\r\n" in written) == (b"\r\n" in FORMATS[name].encode()) and b"\r\n" not in written.replace(b"\r\n", b"")
    assert start(path, "--write")[0] == 0 and path.read_bytes() == written


def test_what_is_printed_is_front_matter(tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text(PAGE, encoding="utf-8")
    code, printed, said = start(path)
    assert code == 0 and "taken from the table at line 1" in said and path.read_text(encoding="utf-8") == PAGE
    path.write_text(printed + PAGE, encoding="utf-8")
    assert verify(path).arms[0].source == "front matter" and set(verdicts(verify(path))) == {"proved"}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("$$ a = b $$\n", "no DH table and no link matrices"),
        (PLAIN, "write convention: classic or convention: modified"),
        ("# A\n\n" + PAGE + "# B\n\n" + PAGE.replace("l_2", "b_2"), "it shows 2 arms, at lines 3, 16"),
    ],
)
def test_where_no_one_arm_is_inferred_the_reason_is_told(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "page.md"
    path.write_text(text, encoding="utf-8")
    for option in ((), ("--write",)):
        code, printed, said = start(path, *option)
        assert code == 2 and not printed and reason in said and path.read_text(encoding="utf-8") == text


def test_a_document_that_names_its_arm_stays_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text("---\narm: planar_2r\n---\n" + PAGE, encoding="utf-8")
    code, printed, said = start(path, "--write")
    assert code == 0 and not printed and "names the arm already" in said
    assert start(tmp_path / "none.md")[0] == 2
