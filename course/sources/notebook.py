"""Notebooks as bytes: the same cells give the same bytes, on every machine."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from typing import Any

from armproof.verification.document.cells import Cell

KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}


def as_notebook(name: str, cells: Iterable[Cell]) -> dict[str, Any]:
    """Return cells as a notebook of format 4.5, without outputs; each cell's id is a digest of the name and its position."""
    return {
        "cells": [_as_json(cell, cell_id(name, position)) for position, cell in enumerate(cells)],
        "metadata": {"kernelspec": dict(KERNEL), "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }


def as_bytes(notebook: Mapping[str, Any]) -> bytes:
    """Return a notebook as Jupyter would write it: sorted keys, an indent of 1, a newline at the end."""
    return (json.dumps(notebook, ensure_ascii=False, indent=1, sort_keys=True) + "\n").encode("utf-8")


def cell_id(name: str, position: int) -> str:
    """Return the id of a lesson's cell."""
    return hashlib.sha256(f"{name}/{position}".encode()).hexdigest()[:12]


def _as_json(cell: Cell, identifier: str) -> dict[str, Any]:
    written: dict[str, Any] = {
        "cell_type": cell.kind,
        "id": identifier,
        "metadata": dict(cell.metadata),
        "source": cell.source.splitlines(keepends=True),
    }
    return written | {"execution_count": None, "outputs": []} if cell.kind == "code" else written
