"""The hooks for pre-commit run the command as it is, on the files that it reads."""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path

import pytest
import yaml
from typer.testing import CliRunner

from armproof.verification.cli import app
from armproof.verification.document import SUFFIXES

ROOT = Path(__file__).resolve().parents[2]
HOOKS = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
FRONT = "---\narm: planar_2r\n---\n\n"


@pytest.mark.parametrize("hook", HOOKS, ids=[hook["id"] for hook in HOOKS])
def test_a_hook_fails_on_a_wrong_document_and_passes_on_a_right_one(hook: dict[str, str], tmp_path: Path) -> None:
    name, *arguments = shlex.split(hook["entry"])
    assert Path(sys.executable).with_name(name).exists()  # which pre-commit installs; test_cli.py runs it
    right, wrong = tmp_path / "right.md", tmp_path / "wrong.md"
    right.write_text(f"{FRONT}$$ C_{{12}} = C_1 C_2 - S_1 S_2 $$\n", encoding="utf-8")
    wrong.write_text(f"{FRONT}$$ C_{{12}} = C_1 $$\n", encoding="utf-8")
    assert CliRunner().invoke(app, [*arguments, str(right)]).exit_code == 0
    assert CliRunner().invoke(app, [*arguments, str(wrong)]).exit_code == 1


@pytest.mark.parametrize("hook", HOOKS, ids=[hook["id"] for hook in HOOKS])
def test_a_hook_takes_the_files_that_are_documents(hook: dict[str, str]) -> None:
    files = re.compile(hook["files"])
    assert {suffix for suffix in SUFFIXES if files.search(f"course/page{suffix}")} == set(SUFFIXES) - {".py"}
    assert not files.search("models/arm.yaml")
