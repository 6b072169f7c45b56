"""Write figures: the same figure gives the same bytes, and a file is there as a whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from armproof.course.errors import FigureError
from armproof.course.figures.drawing.ink import Ink
from armproof.course.figures.drawing.style import styled
from armproof.verification.running.atomic import write_atomically

FORMATS = ("pdf", "svg", "png", "pgf")
_FAINT = 0.02  # ink that is none
_AIR = 0.06  # inch, above and below what is trimmed
_METADATA: dict[str, dict[str, Any]] = {
    "pdf": {"Creator": "Armproof", "Producer": "Armproof", "CreationDate": None},
    "svg": {"Creator": "Armproof", "Date": None},
    "png": {"Software": "Armproof"},
    "pgf": {},
}


@styled()
def save_figure(figure: Figure, path: Path | str, *, trimmed: bool = False) -> Path:
    """Write a figure in the format of the path's suffix, and return the path; folders that are missing are made.

    Trimmed, it is as wide as it was, without the empty paper above and below.

    Text in a PGF file is LaTeX; it is measured here with matplotlib's own mathematics, so that no LaTeX is needed. A map
    in it stands in PNG files beside it, named after it.

    Raises:
        FigureError: a suffix of no format, or a folder that cannot be written.
    """
    path = Path(path)
    kind = path.suffix.removeprefix(".")
    if kind not in FORMATS:
        raise FigureError("{path}: a figure is written as {formats}, not as {found}",
            path=path.name, formats=list(FORMATS), found=kind or "no format")  # fmt: skip
    with _reported(path), tempfile.TemporaryDirectory(prefix=".figure-", dir=path.parent) as folder:
        _write(figure, Path(folder) / path.name, kind, _inked(figure) if trimmed else None)
        for part in sorted(Path(folder).iterdir(), key=lambda part: part.name == path.name):  # the whole last
            os.replace(part, path.parent / part.name)
    return path


def save_bytes(data: bytes, path: Path) -> Path:
    """Write a file as a whole or not at all.

    Raises:
        FigureError: a folder that cannot be written.
    """
    with _reported(path):
        write_atomically(path, data)
    return path


@contextmanager
def _reported(path: Path) -> Iterator[None]:
    """Make the folder of a file that is written within, and say so where it cannot be."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        yield
    except OSError as error:
        raise FigureError("{path}: cannot be written: {reason}", path=path, reason=error.strerror or error) from None


def _inked(figure: Figure) -> Bbox:
    """Return the part of a figure (inches) that has ink, over its whole width."""
    rows = np.flatnonzero(Ink(figure).darkness.max(axis=1) > _FAINT) / figure.dpi
    width, height = figure.get_size_inches()
    low, high = (rows[0], rows[-1]) if len(rows) else (0.0, height)
    return Bbox([[0.0, max(0.0, low - _AIR)], [width, min(height, high + _AIR)]])


def _write(figure: Figure, path: Path, kind: str, part: Bbox | None) -> None:
    if kind == "pgf":
        from armproof.course.figures.output.pgf import write_pgf

        write_pgf(figure, path)
        return
    faster = {"pil_kwargs": {"compress_level": 3}} if kind == "png" else {}  # a tenth larger, in two thirds of the time
    figure.savefig(path, format=kind, metadata=_METADATA[kind], bbox_inches=part, **faster)
