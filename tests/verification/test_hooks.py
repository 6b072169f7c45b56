"""The hooks for pre-commit run the command as it is, on the files that it reads."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from armproof.verification.document import SUFFIXES

ROOT = Path(__file__).resolve().parents[2]
HOOKS = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
FRONT = "---\narm: planar_2r\n---\n\n"


@pytest.mark.parametrize("hook", HOOKS, ids=[hook["id"] for hook in HOOKS])
def test_a_hook_fails_on_a_wrong_document_and_passes_on_a_right_one(hook: dict[str, str], tmp_path: Path) -> None:
    command = shlex.split(hook["entry"])
    command[0] = str(Path(sys.executable).with_name(command[0]))
    for name, formula, code in (("right.md", "C_{12} = C_1 C_2 - S_1 S_2", 0), ("wrong.md", "C_{12} = C_1", 1)):
        path = tmp_path / name
        path.write_text(f"{FRONT}$$ {formula} $$\n", encoding="utf-8")
        assert subprocess.run([*command, path], capture_output=True, timeout=60, check=False).returncode == code


@pytest.mark.parametrize("hook", HOOKS, ids=[hook["id"] for hook in HOOKS])
def test_a_hook_takes_the_files_that_are_documents(hook: dict[str, str]) -> None:
    files = re.compile(hook["files"])
    assert {suffix for suffix in SUFFIXES if files.search(f"course/page{suffix}")} == set(SUFFIXES) - {".py"}
    assert not files.search("models/arm.yaml")
