"""Notebooks of the tests' own."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

Write = Callable[..., Path]


def notebook(*cells: str, title: str = "") -> bytes:
    """Return a notebook of code cells, with a title in its front matter."""
    front = [{"cell_type": "raw", "metadata": {}, "source": f"---\ntitle: {title}\n---"}] if title else []
    code = [
        {"cell_type": "code", "metadata": {}, "source": cell, "outputs": [], "execution_count": None} for cell in cells
    ]
    return json.dumps({"cells": front + code, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}).encode()


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Write a notebook into the folder of a class."""

    def put(name: str, *cells: str, title: str = "") -> Path:
        path = tmp_path / "class" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(notebook(*cells, title=title))
        return path

    return put


@pytest.fixture(scope="session")
def bwrap() -> str:
    """Bubblewrap, which .ci/run installs."""
    if (found := shutil.which("bwrap")) is None:
        if os.environ.get("CI"):
            pytest.fail("bubblewrap is not installed")
        pytest.skip("bubblewrap is not installed")
    return found
