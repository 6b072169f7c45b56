"""Documents that the tests print, and PDF read back."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from armproof.course.printing.document import Edition, make_sheet
from armproof.course.printing.printing import render
from armproof.course.sheet.model import Sheet
from armproof.verification.check import check_document
from armproof.verification.document import read_document

FRONT = "---\ntitle: The planar arm\nsource: A test\narm: planar_2r\nfigures: []\n---\n\n"


@pytest.fixture
def document(tmp_path: Path) -> Callable[..., Path]:
    """Write a document on the planar 2R arm."""

    def write(body: str, name: str = "sheet.md", front: str = FRONT) -> Path:
        path = tmp_path / name
        path.write_text(front + body, encoding="utf-8")
        return path

    return write


@pytest.fixture
def make(tmp_path: Path) -> Callable[..., Sheet]:
    """Check a document and make its sheet."""

    def run(path: Path, **edition: object) -> Sheet:
        read = read_document(path)
        return make_sheet(read, check_document(read, confirm=False), Edition(**edition), tmp_path)  # type: ignore[arg-type]

    return run


@pytest.fixture
def pdf_text(make: Callable[..., Sheet]) -> Callable[..., str]:
    """Print a document as PDF and return its text layer."""
    pytest.importorskip("typst", reason="the extra 'print' is not installed")
    reader = pytest.importorskip("pypdf", reason="pypdf reads the sheets back")

    def run(path: Path, **edition: object) -> str:
        import io

        pages = reader.PdfReader(io.BytesIO(render(make(path, **edition), "pdf"))).pages
        return "\n".join(page.extract_text() for page in pages)

    return run
