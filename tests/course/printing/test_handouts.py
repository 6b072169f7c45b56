"""Every handout of the course as PDF: a clean text layer, every matrix whole and on the page, the same bytes twice."""

from __future__ import annotations

import io
import re
from functools import cache
from pathlib import Path

import pytest

from armproof.course.printing.document import Edition, make_sheet
from armproof.course.printing.printing import render
from armproof.course.sheet.model import Display, Sheet, walk
from armproof.verification.check import check_document
from armproof.verification.document import find_documents, read_document

typst = pytest.importorskip("typst", reason="the extra 'print' is not installed")
pypdf = pytest.importorskip("pypdf", reason="pypdf reads the sheets back")

HANDOUTS = find_documents([Path(__file__).resolve().parents[3] / "course" / "handouts"])
MARGIN = 18 / 25.4 * 72  # pt
WIDTH, HEIGHT = 595.28, 841.89
DEFECTS = re.compile(r"[\\&$\ufffd\x00-\x08\x0b\x0c\x0e-\x1f]")


@cache
def sheet_of(path: Path) -> Sheet:
    document = read_document(path)
    document.front["figures"] = []  # a figure has tests of its own
    return make_sheet(document, check_document(document, confirm=False), Edition(solutions=True), path.parent)


@cache
def printed(path: Path) -> bytes:
    return render(sheet_of(path), "pdf")


def defects(pdf: bytes) -> list[str]:
    """Return the signs of the text layer that are LaTeX or no text at all."""
    pages = pypdf.PdfReader(io.BytesIO(pdf)).pages
    return [found for page in pages for found in DEFECTS.findall(page.extract_text())]


def placed(pdf: bytes) -> list[tuple[float, float, float, str]]:
    """Return the places of all pieces of text: left, right (estimated by the size) and height above the page's foot."""
    found: list[tuple[float, float, float, str]] = []

    def visit(text: str, current: list[float], matrix: list[float], font: object, size: float) -> None:
        if text.strip():
            left = matrix[4] * current[0] + current[4]
            height = matrix[5] * current[3] + current[5]
            found.append((left, left + 0.25 * size * len(text.strip()), height, text))

    for page in pypdf.PdfReader(io.BytesIO(pdf)).pages:
        page.extract_text(visitor_text=visit)
    return found


def off_the_page(pdf: bytes) -> list[tuple[float, float, float, str]]:
    def inside(left: float, right: float, height: float) -> bool:
        return left >= MARGIN - 3 and right <= WIDTH - MARGIN + 3 and 20 <= height <= HEIGHT - 20

    return [place for place in placed(pdf) if not inside(*place[:3])]


@pytest.mark.parametrize("path", HANDOUTS, ids=lambda path: path.stem)
def test_the_text_layer_of_a_handout_is_clean_and_nothing_leaves_the_page(path: Path):
    assert defects(printed(path)) == []
    assert off_the_page(printed(path)) == []


@pytest.mark.parametrize("path", HANDOUTS, ids=lambda path: path.stem)
def test_every_display_of_a_handout_is_typeset_from_its_tree(path: Path):
    displays = [block for block in walk(sheet_of(path).blocks) if isinstance(block, Display)]
    assert [block.record.line for block in displays if not block.lines] == []
    assert len(sheet_of(path).records) >= len(read_document(path).displays)


def test_every_handout_is_among_them():
    assert {"scara-000", "scara-001", "planar-3r-002", "quintic-004"} <= {path.stem for path in HANDOUTS}


def test_two_runs_give_the_same_bytes():
    path = next(path for path in HANDOUTS if path.stem == "scara-000")
    assert render(sheet_of(path), "pdf") == printed(path)
    assert b"CreationDate" not in printed(path)
    assert b"D:20" not in printed(path)


# -- the checks can fail -----------------------------------------------------------------------------------------------


def compiled(body: str, tmp_path: Path) -> bytes:
    source = tmp_path / "main.typ"
    source.write_text(f'#set page(paper: "a4", margin: 18mm)\n{body}', encoding="utf-8")
    return typst.compile(str(source), format="pdf", ignore_system_fonts=True)


@pytest.mark.parametrize("sign", ["\\\\", "\\$", "\\&"])
def test_latex_in_the_text_layer_is_noticed(sign: str, tmp_path: Path):
    assert defects(compiled(f"a {sign} b", tmp_path))


def test_brackets_put_together_of_pieces_of_letters_are_noticed(tmp_path: Path):
    assert defects(compiled('$ mat(delim: "[", 1; 2; 3; 4; 5; 6; 7; 8; 9; 10; 11; 12) $', tmp_path))


def test_what_leaves_the_page_is_noticed(tmp_path: Path):
    assert off_the_page(compiled("#place(dx: 160mm)[cut off at the edge]", tmp_path))
    assert off_the_page(compiled("#place(dx: -15mm)[left]", tmp_path))
    assert not off_the_page(compiled("inside", tmp_path))
