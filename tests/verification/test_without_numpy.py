"""What reads a document, and its exact values, needs no NumPy and no Drake: it works where importing them raises."""

from __future__ import annotations

import pkgutil
import subprocess
import sys
from pathlib import Path

import pytest

import armproof.verification

SAMPLES = ("sampled",)  # the algebra of samples, and the arm's at them
ROOT = Path(armproof.verification.__path__[0])
PROGRAM = """
import importlib, sys
sys.modules.update(numpy=None, pydrake=None)
for name in sys.argv[1:]:
    importlib.import_module(name)
"""


def modules_of(room: str) -> list[str]:
    """Return the names of all modules of a room of verification."""
    found = pkgutil.walk_packages([str(ROOT / room)], f"armproof.verification.{room}.")
    return [module.name for module in found]


def imported(*names: str) -> subprocess.CompletedProcess[str]:
    """Return what became of importing modules where importing NumPy or Drake raises."""
    return subprocess.run([sys.executable, "-c", PROGRAM, *names], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("room", ["document", "latex", "naming", "algebra", "evaluation"])
def test_what_reads_and_what_proves_imports_neither_numpy_nor_drake(room: str) -> None:
    modules = [name for name in modules_of(room) if name.rpartition(".")[2] not in SAMPLES]
    assert len(modules) > 4
    found = imported(*modules)
    assert found.returncode == 0, found.stderr


@pytest.mark.parametrize("name", [f"evaluation.{name}" for name in SAMPLES])
def test_what_samples_imports_numpy(name: str) -> None:
    found = imported(f"armproof.verification.{name}")
    assert found.returncode == 1
    assert "import of numpy halted" in found.stderr
