"""What reads a document needs no NumPy and no Drake: it works where importing them raises."""

from __future__ import annotations

import subprocess
import sys

import pytest

READING = "document", "latex.reader", "latex.writer", "latex.mathml.writer", "naming.state"
PROGRAM = """
import importlib, sys
sys.modules.update(numpy=None, pydrake=None)
for name in sys.argv[1:]:
    importlib.import_module(f"armproof.verification.{name}")
"""


def imported(*names: str) -> subprocess.CompletedProcess[str]:
    """Return what became of importing modules of verification where importing NumPy or Drake raises."""
    return subprocess.run([sys.executable, "-c", PROGRAM, *names], capture_output=True, text=True, check=False)


def test_what_reads_a_document_imports_neither_numpy_nor_drake() -> None:
    found = imported(*READING)
    assert found.returncode == 0, found.stderr


@pytest.mark.parametrize("name", ["evaluation.sampled", "evaluation.plant_samples"])
def test_what_samples_imports_numpy(name: str) -> None:
    found = imported(name)
    assert found.returncode == 1
    assert "import of numpy halted" in found.stderr
