"""What an author accepts with a reason: shown and counted apart in every report, never counted as right."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof import verify, verify_text
from armproof.verification.cli import app
from armproof.verification.document import parse_document, read_document
from armproof.verification.findings import Kind
from armproof.verification.running.corrected_copy import correct_text
from armproof.verification.running.incremental import IncrementalChecker
from armproof.verification.verdict import DocumentResult, summary

FRONT = "---\narm: planar_2r\n---\n\n"
RIGHT = "$$ p_2 = [l_1 C_1 + l_2 C_{12}, l_1 S_1 + l_2 S_{12}, 0]^T $$\n\n"
WRONG = "$$ p_2 = [l_1 C_1 - l_2 C_{12}, l_1 S_1 + l_2 S_{12}, 0]^T $$\n\n"
OPEN = "$$ p_2 = k_9 + k_8 $$\n\n"
ACCEPT = "<!-- armproof: accept: as the book has it -->\n"


def told(*arguments: object) -> tuple[int, str]:
    run = CliRunner().invoke(app, ["verify", "--jobs", "1", *map(str, arguments)])
    return run.exit_code, run.output


@pytest.mark.parametrize(
    ("name", "mark"),
    [
        ("a.md", "<!-- armproof: accept: {} -->"),
        ("a.tex", "% armproof: accept: {}"),
        ("a.rst", ".. armproof: accept: {}"),
        ("a.py", "# <!-- armproof: accept: {} -->"),
    ],
)
def test_each_comment_is_known_by_its_line(name: str, mark: str) -> None:
    head = "# %% [markdown]\n" if name == "a.py" else ""
    lines = (head + "\n\n# text\n\n" + mark.format("one") + "\n\n# text\n\n\n" + mark.format("two") + "\n").split("\n")
    found = [(each.line, each.reason) for each in parse_document(Path(name), "\n".join(lines)).accepts]
    assert found == [
        (number, text) for number, line in enumerate(lines, 1) for text in ("one", "two") if f": {text}" in line
    ]


def test_what_is_accepted_is_shown_and_does_not_fail_and_is_not_right(tmp_path: Path) -> None:
    path = tmp_path / "a.md"
    path.write_text(FRONT + RIGHT + ACCEPT + WRONG, encoding="utf-8")
    for options in ((), ("--strict",)):
        code, text = told(path, *options)
        assert code == 0
        assert "2 displays: 1 proved, 1 accepted" in text and "accepted: as the book has it" in text
        assert "refuted" in text and "everything passes" not in text
        assert "nothing else wrong found; 1 finding is accepted, not right" in text
    path.write_text(FRONT + RIGHT + WRONG, encoding="utf-8")
    assert told(path)[0] == 1


def test_the_json_keeps_the_verdict(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(FRONT + ACCEPT + WRONG + RIGHT, encoding="utf-8")
    report = json.loads(told(tmp_path / "a.md", "--format", "json")[1])
    wrong = report["documents"][0]["equations"][0]
    assert wrong["verdict"] == "refuted" and wrong["findings"][-1]["kind"] == "accepted"
    assert wrong["findings"][-1]["terms"] == {"reason": "as the book has it"}
    assert (report["summary"]["refuted"], report["summary"]["accepted"], report["summary"]["proved"]) == (1, 1, 1)


def test_an_annotation_of_what_is_accepted_is_a_notice(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(FRONT + ACCEPT + WRONG, encoding="utf-8")
    text = told(tmp_path / "a.md", "--format", "github")[1]
    assert "::notice " in text and "::error" not in text


def one(text: str, form: str = "md") -> DocumentResult:
    return verify_text(text, form, path=f"document.{form}")


def test_without_a_reason_nothing_is_accepted() -> None:
    result = one(FRONT + "<!-- armproof: accept -->\n" + WRONG)
    assert not result.passed and result.equations[0].says(Kind.ACCEPTED_WITHOUT_REASON)


@pytest.mark.parametrize("body", [ACCEPT + RIGHT, RIGHT + ACCEPT, ACCEPT + "\n\n\n\n\n\nText.\n\n" + RIGHT])
def test_a_comment_with_nothing_to_accept_any_more_is_said(body: str, tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(FRONT + body, encoding="utf-8")
    code, text = told(tmp_path / "a.md")
    assert code == 0 and ("there is nothing to accept any more" in text or "accepts nothing" in text)
    assert not any(record.is_accepted for record in verify(tmp_path / "a.md").records)


def test_it_is_about_the_next_display_alone() -> None:
    result = one(FRONT + ACCEPT + WRONG + WRONG)
    assert [record.is_accepted for record in result.equations] == [True, False] and not result.passed


@pytest.mark.parametrize(("lines", "accepted"), [(-1, True), (0, True), (2, True), (3, True), (4, False)])
def test_it_may_stand_beside_its_display_and_a_few_lines_before_it(lines: int, accepted: bool) -> None:
    """Behind it, on a line of its own, it is about the next one."""
    mark, wrong = "% armproof: accept: as the book has it", WRONG.strip()
    body = {-1: f"{mark}\n{wrong}", 0: f"{wrong} {mark}"}.get(lines, mark + "\n" * (lines + 1) + wrong)
    (record,) = one(f"% arm: planar_2r\n\\begin{{document}}\n{body}\n\\end{{document}}\n", "tex").equations
    assert record.is_accepted == accepted
    (record,) = one(f"% arm: planar_2r\n\\begin{{document}}\n{wrong}\n{mark}\n\\end{{document}}\n", "tex").equations
    assert not record.is_accepted


def test_an_unchecked_display_can_be_accepted_and_is_still_not_decided() -> None:
    result = one(FRONT + RIGHT + ACCEPT + OPEN)
    assert result.passed_strictly() and result.equations[1].verdict == "unchecked"
    assert not one(FRONT + RIGHT + OPEN).passed_strictly()


def test_alone_it_is_no_claim() -> None:
    assert one(FRONT + ACCEPT + WRONG).passed and not one(FRONT + ACCEPT + WRONG).passed_strictly()


TEX = "% arm: planar_2r\n\\begin{document}\n% armproof: accept: as the book has it\n" + WRONG + "\\end{document}\n"
RST = ".. arm: planar_2r\n\n.. armproof: accept: as the book has it\n\n.. math:: " + WRONG.strip(" $\n") + "\n\n"
PERCENT = "# %% [markdown]\n" + "".join(f"# {line}\n" for line in (FRONT + ACCEPT + WRONG).split("\n"))
CELL = {"cell_type": "markdown", "id": "a", "metadata": {}, "source": FRONT + ACCEPT + WRONG}
NOTEBOOK = json.dumps({"cells": [CELL], "metadata": {}, "nbformat": 4, "nbformat_minor": 5})


@pytest.mark.parametrize(
    ("form", "text"),
    [("tex", TEX), ("rst", RST), ("py", PERCENT), ("ipynb", NOTEBOOK), ("qmd", FRONT + ACCEPT + WRONG)],
)
def test_each_format_has_its_comment(form: str, text: str) -> None:
    (record,) = one(text, form).equations
    assert record.verdict == "refuted" and record.is_accepted
    (without,) = one(text.replace("armproof: accept", "armproof: except"), form).equations
    assert without.verdict == "refuted" and not without.is_accepted


def test_a_table_and_an_erratum_can_be_accepted() -> None:
    table = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | $l_2$ | 0 | 0 | $\\theta_1$ |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |\n"
    result = one(f"{FRONT}{ACCEPT}\n{table}\n> {ACCEPT}>\n> **Erratum**\n> {RIGHT}")
    assert [record.is_accepted for record in result.records] == [True, True] and result.passed
    assert not one(f"{FRONT}{table}\n").passed


def test_a_comment_in_a_listing_is_none() -> None:
    assert not one(f"{FRONT}```markdown\n{ACCEPT}```\n{WRONG}").passed


def test_what_is_accepted_is_not_corrected() -> None:
    text = FRONT + ACCEPT + WRONG
    assert correct_text(Path("a.md"), text).after == text
    assert correct_text(Path("a.md"), FRONT + WRONG).after != FRONT + WRONG


def test_a_watch_follows_the_comment(tmp_path: Path) -> None:
    path = tmp_path / "a.md"
    checker = IncrementalChecker(path)
    for body in (WRONG, ACCEPT + WRONG, ACCEPT + RIGHT, WRONG):
        path.write_text(FRONT + body, encoding="utf-8")
        list(checker.update(read_document(path)))
        assert checker.result is not None
        assert summary([checker.result]) == summary([verify(path)])
        assert checker.result.equations[0].findings == verify(path).equations[0].findings
