"""What a report says in all: everything passes only where every claim was decided, else what is not decided and why."""

from __future__ import annotations

from html import unescape
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof.verification.check import verify
from armproof.verification.cli import app
from armproof.verification.report.html.site import INDEX
from armproof.verification.report.totals import Totals
from armproof.verification.verdict import DocumentResult

FRONT = "---\narm: planar_2r\n---\n\n"
PROVED = "$$ p_2 = \\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\\\ l_1 S_1 + l_2 S_{12} \\\\ 0 \\end{bmatrix} $$\n\n"
UNBOUND = "$$ C_1 = k_9 + k_8 $$\n\n$$ S_1 = k_9 - k_8 $$\n\n"
UNUSED = "$$ B = C_1 + 7 $$\n\n"
REMARK = "$$ \\lVert J \\dot q - \\dot x \\rVert^2 $$\n\n"


def result(tmp_path: Path, *displays: str, name: str = "page.md", front: str = FRONT) -> DocumentResult:
    """Return the verdicts of a document with these displays."""
    path = tmp_path / name
    path.write_text(front + "".join(displays), encoding="utf-8")
    return verify(path)


def said(*results: DocumentResult, strict: bool = False) -> list[str]:
    """Return the lines of the total from the verdict on."""
    lines = Totals.of(results, strict).describe()
    return lines[1 + (len(lines) > 1 and lines[1].startswith("evaluated")) :]


def test_everything_passes_only_where_every_claim_is_decided(tmp_path: Path) -> None:
    assert said(result(tmp_path, PROVED)) == ["everything passes"]
    assert said(result(tmp_path, PROVED, UNUSED))[0] == "nothing wrong found; 1 of 2 equations not decided"


def test_causes_are_told_the_most_frequent_first_with_what_to_write(tmp_path: Path) -> None:
    verdict, *causes = said(result(tmp_path, UNUSED, PROVED, UNBOUND))
    assert verdict == "nothing wrong found; 3 of 4 equations not decided"
    assert causes == [
        "2 × a name is not bound: bind it in the front matter: quantities: …",
        "1 × no decided claim uses what is defined: bind the name in the front matter (quantities: …)",
    ]


def test_where_no_arm_is_known_that_is_what_is_missing(tmp_path: Path) -> None:
    unused = "$$ D = k_9 $$\n\n"
    _, *causes = said(result(tmp_path, "$$ p_2 = 2 p_1 $$\n\n", unused, front=""))
    assert causes == ["2 × no arm is known: name it in the front matter (arm: …), or print its DH table"]
    assert not any("no arm" in line for line in said(result(tmp_path, PROVED, unused)))


def test_each_equation_of_a_display_counts(tmp_path: Path) -> None:
    assert "1 of 2 equations" in said(result(tmp_path, "$$ C_1 = C_1 \\qquad B = C_1 + 7 $$\n"))[0]


def test_remarks_are_counted_apart_and_leave_the_rest_decided(tmp_path: Path) -> None:
    found = result(tmp_path, PROVED, REMARK)
    for strict in (False, True):
        assert said(found, strict=strict) == ["everything passes"]
        assert "2 displays: 1 proved, 1 remark" in Totals.of([found], strict).describe()[0]


def test_no_claim_at_all_is_said_and_fails_where_it_is_strict(tmp_path: Path) -> None:
    for displays in ((), (REMARK,)):
        found = result(tmp_path, *displays)
        assert said(found) == ["no claim was found"] and Totals.of([found]).passed
        assert said(found, strict=True) == [
            f"1 document does not pass (--strict: no claim was found in {tmp_path / 'page.md'})"
        ]


def test_the_largest_error_names_its_document(tmp_path: Path) -> None:
    small = result(tmp_path, "$$ C_1^2 + S_1^2 = 1 $$\n", name="small.md")
    large = result(tmp_path, PROVED, PROVED.replace("C_1 ", "C_1 + 1e5 l_1 C_1 - 1e5 l_1 C_1 "), name="large.md")
    for results in ((small, large), (large, small)):
        found = next(line for line in Totals.of(results).describe() if "largest error" in line)
        worst = max(results, key=lambda each: max(record.max_error or 0 for record in each.equations))
        assert found.endswith(f", in {worst.path}")
    assert ", in " not in Totals.of([small]).describe()[1]


@pytest.mark.parametrize("flags", [(), ("--strict",)])
def test_the_command_and_the_pages_count_alike(tmp_path: Path, flags: tuple[str, ...]) -> None:
    for name, displays in (("a.md", (PROVED,)), ("b.md", (PROVED, UNBOUND, REMARK)), ("c.md", (UNUSED,))):
        result(tmp_path, *displays, name=name)
    folder = tmp_path / "report"
    documents = [str(tmp_path / f"{each}.md") for each in "abc"]
    run = CliRunner().invoke(app, ["verify", *documents, *flags, "--report", str(folder)])
    page = unescape((folder / INDEX).read_text(encoding="utf-8"))
    total = run.stdout.rstrip().split("\n\n")[-1].splitlines()
    assert len(total) == 5 and "of 5 equations not decided" in total[2]
    for line in total:
        line = line.strip()
        assert line in page or line[0].upper() + line[1:] in page


def test_readings_are_told_on_pages_and_where_asked_for(tmp_path: Path) -> None:
    result(tmp_path, PROVED, UNUSED)
    page, folder = str(tmp_path / "page.md"), tmp_path / "report"
    plain = CliRunner().invoke(app, ["verify", page, "--report", str(folder)]).stdout
    told = CliRunner().invoke(app, ["verify", page, "--verbose"]).stdout
    written = unescape((folder / "page.html").read_text(encoding="utf-8"))
    for reading in ("claim, proved", "definition, unchecked"):
        assert reading in told and reading in written and reading not in plain
