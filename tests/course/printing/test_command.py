"""`armproof handout`: files written as a whole, exit codes, messages."""

from __future__ import annotations

import html
import importlib.util
import os

import pytest
import typer
from typer.testing import CliRunner

from armproof.course.printing import pdf
from armproof.course.printing.command import handout

app = typer.Typer(pretty_exceptions_enable=False)
app.command()(handout)
PROVED = r"$$ \cos^2\theta_1 + \sin^2\theta_1 = 1 $$" + "\n"
WRONG = r"$$ \cos^2\theta_1 + \sin^2\theta_1 = 2 $$" + "\n"


def run(*arguments: object):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def test_several_documents_are_printed_at_once(document, tmp_path):
    first, second = document(PROVED, "first.md"), document(PROVED, "second.md")
    result = run(first, second, "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["first.html", "second.html"]
    assert result.stdout.split() == [str(tmp_path / "out" / "first.html"), str(tmp_path / "out" / "second.html")]


def test_one_that_does_not_pass_keeps_no_other_from_being_printed(document, tmp_path):
    good, bad = document(PROVED, "good.md"), document(WRONG, "bad.md")
    result = run(good, bad, "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 1
    assert "bad.md: not printed: 1 equation is not proved" in result.stderr
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["good.html"]


def test_a_draft_is_printed_with_draft_across_it(document, tmp_path):
    assert run(document(WRONG), "--draft", "--format", "html", "--out", tmp_path / "out").exit_code == 0
    page = (tmp_path / "out" / "sheet.html").read_text(encoding="utf-8")
    assert '<div class="across" aria-hidden="true">DRAFT</div>' in page
    assert run(document(PROVED), "--format", "html", "--out", tmp_path / "out").exit_code == 0
    assert "DRAFT" not in (tmp_path / "out" / "sheet.html").read_text(encoding="utf-8")


def test_the_two_editions_stand_side_by_side(document, tmp_path):
    path = document(PROVED)
    for options in ([], ["--solutions"]):
        assert run(path, "--format", "html", "--out", tmp_path / "out", *options).exit_code == 0
    assert sorted(each.name for each in (tmp_path / "out").iterdir()) == ["sheet-solutions.html", "sheet.html"]


def test_an_html_sheet_asks_nothing_of_the_network(document, tmp_path):
    run(document(PROVED + "[a page](https://example.org)\n"), "--format", "html", "--out", tmp_path / "out")
    page = (tmp_path / "out" / "sheet.html").read_text(encoding="utf-8")
    assert (
        "default-src 'none'" in html.unescape(page)
        and "<script" not in page
        and "<link" not in page
        and 'src="http' not in page
    )
    assert "<math" in page and "$$" not in page and "\\" not in page.partition("</style>")[2]


def test_without_typst_pdf_is_refused_before_anything_is_checked(document, tmp_path, monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(pdf, "find_spec", lambda name: None if name == "typst" else find_spec(name))
    result = run(document(PROVED), "--out", tmp_path / "out")
    assert result.exit_code == 2 and "pip install 'armproof[print]'" in result.stderr
    assert not (tmp_path / "out").exists()
    assert run(document(PROVED), "--format", "html", "--out", tmp_path / "out").exit_code == 0


def test_two_documents_that_would_be_one_file_are_refused(document, tmp_path):
    (tmp_path / "other").mkdir()
    first, second = document(PROVED), document(PROVED, "other/sheet.md")
    result = run(first, second, "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 2 and "would both be" in result.stderr


def test_a_document_that_cannot_be_read_is_named(tmp_path):
    result = run(tmp_path / "none.md", "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 2 and "none.md: no such file or folder" in result.stderr


@pytest.mark.parametrize(
    ("option", "value", "message"), [("--lang", "de", "no language 'de'"), ("--format", "docx", "docx")]
)
def test_an_unknown_language_or_format_is_refused(option, value, message, document, tmp_path):
    result = run(document(PROVED), option, value, "--out", tmp_path / "out")
    assert result.exit_code == 2 and message in result.stderr


def test_a_folder_that_is_a_file_is_refused(document, tmp_path):
    (tmp_path / "out").write_text("a file", encoding="utf-8")
    result = run(document(PROVED), "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 2 and "out: cannot be written" in result.stderr
    assert (tmp_path / "out").read_text(encoding="utf-8") == "a file"


@pytest.mark.skipif(os.geteuid() == 0, reason="whoever is root writes everywhere")
def test_an_unwritable_folder_is_refused(document, tmp_path):
    (tmp_path / "out").mkdir(mode=0o500)
    result = run(document(PROVED), "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 2 and "cannot be written" in result.stderr


def test_a_sheet_that_cannot_be_written_leaves_the_old_one(document, tmp_path, monkeypatch):
    path = document(PROVED)
    assert run(path, "--format", "html", "--out", tmp_path / "out").exit_code == 0
    before = (tmp_path / "out" / "sheet.html").read_bytes()

    def full(*arguments: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    result = run(path, "--format", "html", "--out", tmp_path / "out")
    assert result.exit_code == 2 and "cannot be written: No space left on device" in result.stderr
    assert [each.name for each in (tmp_path / "out").iterdir()] == ["sheet.html"]
    assert (tmp_path / "out" / "sheet.html").read_bytes() == before
