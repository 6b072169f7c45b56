"""The errata sheet: what is refuted and nothing else, the gravest first, in three formats, the same bytes each time."""

from __future__ import annotations

import io
import re
from contextvars import copy_context
from pathlib import Path

import pytest
from pypdf import PdfReader
from typer.testing import CliRunner

from armproof.verification.cli import app
from armproof.verification.report.errata import TEX

FRONT = "---\narm: planar_2r\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n\n"
RIGHT = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"
WRONG = (
    r"$$ J_v = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix} $$"
)
TWO_WRONG = r"$$ p_2 = \begin{bmatrix} l_1 S_1 + l_2 C_{12} \\ l_1 S_1 - l_2 S_{12} \\ 0 \end{bmatrix} $$"
ERRATUM = "> **Erratum** (slide 4, as *printed*, $l_1$ lost)\n> $$ \\det J_v = l_2 \\sin\\theta_2 $$\n"


def sheet(folder: Path, name: str, code: int, *options: str) -> str:
    """Return the errata sheet of the documents in a folder."""
    target = folder / name
    run = CliRunner().invoke(app, ["verify", str(folder), "--jobs", "1", "--errata", str(target), *options])
    assert run.exit_code == code, run.output
    if target.suffix == ".pdf":
        return " ".join(page.extract_text() for page in PdfReader(io.BytesIO(target.read_bytes())).pages)
    return target.read_text(encoding="utf-8")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Write two documents: one with a wrong sign, said twice; one with two wrong entries and an erratum."""
    (tmp_path / "a_b.md").write_text(f"{FRONT}# The Jacobian of $q$\n\n{RIGHT}{WRONG}\n\n", encoding="utf-8")
    (tmp_path / "c.md").write_text(f"{FRONT}{TWO_WRONG}\n\n{ERRATUM}", encoding="utf-8")
    return tmp_path


def test_the_sheet_says_where_what_is_printed_what_is_right_and_why(folder: Path) -> None:
    text = sheet(folder, "errata.md", 1)
    assert "Mistakes: 3; documents: 2." in text
    assert r"a\_b.md, line 11: The Jacobian of $q$" in text
    assert "entry (1, 2): printed: $l_2 S_{12}$, right: $-l_2 S_{12}$ (wrong sign)" in text
    assert "in the formula of $J_v$" in text
    assert "*slide 4, as printed, $l_1$ lost*" in text
    assert "line 9" not in text  # what is proved is no mistake


@pytest.mark.parametrize(
    ("display", "name"),
    [
        (r"x = l_1 C_1 + l_2 C_{12}, \qquad y = l_1 S_1 + l_2 S_2", "y"),
        (r"\begin{aligned} x &= l_1 C_1 + l_2 C_2 \\ y &= l_1 S_1 + l_2 S_{12} \end{aligned}", "x"),
        (r"p_2(\theta_1, \theta_2) = \begin{bmatrix} l_1 C_1 + l_2 C_2 \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}",
         r"p_2(\theta_1, \theta_2)"),
    ],
)  # fmt: skip
def test_the_formula_is_that_of_the_equation_with_the_mistake(tmp_path: Path, display: str, name: str) -> None:
    (tmp_path / "a.md").write_text(f"{FRONT}$${display}$$\n", encoding="utf-8")
    assert re.findall(r"in the formula of \$(.*)\$", sheet(tmp_path, "errata.md", 1)) == [name]


def test_more_wrong_entries_stand_first(folder: Path) -> None:
    text = sheet(folder, "errata.md", 1)
    assert text.index("1. c.md, line 7") < text.index("a\\_b.md, line 11")


def test_an_error_said_again_stands_with_the_first(folder: Path) -> None:
    (folder / "a_b.md").write_text(f"{FRONT}{WRONG}\n\n{WRONG}\n\n", encoding="utf-8")
    text = sheet(folder, "errata.md", 1)
    assert "1. a\\_b.md, line 7" in text and "the same error stands in line 9" in text
    assert "Mistakes: 3;" in text


def test_the_three_formats_say_the_same(folder: Path) -> None:
    tex, pdf = sheet(folder, "errata.tex", 1), sheet(folder, "errata.pdf", 1)
    assert r"a\_b.md, line 11" in tex and "$-l_2 S_{12}$" in tex and tex.endswith("\\end{document}\n")
    assert "a_b.md, line 11" in pdf and "wrong sign" in pdf and "slide 4" in pdf


def test_french_spaces_are_spaces_of_tex_and_no_formula() -> None:
    assert TEX.words("imprimé\u202f: 2\u00a0%") == r"imprimé\,: 2~\%"
    assert TEX.words("θ") == r"$\theta$"


@pytest.mark.parametrize("name", ["errata.md", "errata.tex", "errata.pdf"])
def test_the_same_verdicts_give_the_same_bytes_and_the_sheet_is_no_document(folder: Path, name: str) -> None:
    sheet(folder, name, 1)
    before = (folder / name).read_bytes()
    sheet(folder, name, 1)  # with the first one beside the documents
    assert (folder / name).read_bytes() == before


def test_without_a_mistake_the_sheet_says_so(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(FRONT + RIGHT, encoding="utf-8")
    assert "No mistake was found." in sheet(tmp_path, "errata.md", 0)


@pytest.mark.parametrize("name", ["a_b.md", "errata.docx", "none/errata.md"])
def test_no_document_is_overwritten_and_another_place_or_format_is_refused(folder: Path, name: str) -> None:
    before = (folder / "a_b.md").read_bytes()
    run = CliRunner().invoke(app, ["verify", str(folder), "--jobs", "1", "--errata", str(folder / name)])
    assert run.exit_code == 2 and name in run.output
    assert (folder / "a_b.md").read_bytes() == before and sorted(p.name for p in folder.iterdir()) == ["a_b.md", "c.md"]


def test_a_correction_of_a_whole_display_is_written_whole(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(f"{FRONT}$$ \\det J_v = 0 \\iff \\cos\\theta_2 = 0 $$\n", encoding="utf-8")
    text = sheet(tmp_path, "errata.md", 1)
    whole = r"- printed: $\det J_v = 0 \iff \cos\theta_2 = 0$" + "\n" + r"- right: $\det J_v = 0 \iff \sin\theta_2 = 0$"
    assert whole in text and r"for example at $\theta_2 = 0$" in text


def test_the_example_is_in_the_letters_of_formulas_with_the_comma_of_its_language(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(f"{FRONT}$$ x = l_1 c_1 - l_2 c_{{12}} $$\n", encoding="utf-8")
    arguments = ["verify", str(tmp_path), "--errata", str(tmp_path / "errata.md"), "--lang", "fr"]
    copy_context().run(CliRunner().invoke, app, arguments)  # the language that is asked for stays there
    text = (tmp_path / "errata.md").read_text(encoding="utf-8")
    assert re.search(r"\$\\theta_1 = -?\d\{,\}\d+\$\u00a0; \$\\theta_2 = ", text), text
