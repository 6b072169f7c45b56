"""`armproof verify --report DIR`: the pages beside the verdicts on standard output, and what the option refuses."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from armproof.verification.cli import app
from armproof.verification.report.html.site import INDEX, VERDICTS

RIGHT, WRONG = "$$ (a + b)^2 = a^2 + 2ab + b^2 $$\n", "$$ (a + b)^2 = a^2 + b^2 $$\n"


@pytest.mark.parametrize(("content", "code"), [(RIGHT, 0), (WRONG, 1)])
def test_the_report_is_written_whether_or_not_the_document_passes(tmp_path: Path, content: str, code: int) -> None:
    (tmp_path / "page.md").write_text(content, encoding="utf-8")
    target = tmp_path / "out" / "report"
    command = ["verify", str(tmp_path / "page.md"), "--report", str(target), "--format", "json"]
    result = CliRunner().invoke(app, command)
    assert result.exit_code == code
    assert sorted(path.name for path in target.iterdir()) == sorted([INDEX, "page.html", VERDICTS])
    assert json.loads(result.stdout) == json.loads((target / VERDICTS).read_text(encoding="ascii"))


def test_a_document_that_cannot_be_checked_does_not_cost_the_others_their_pages(tmp_path: Path) -> None:
    (tmp_path / "good.md").write_text(RIGHT, encoding="utf-8")
    (tmp_path / "bad.md").write_text(f"---\narm: nowhere\n---\n{RIGHT}", encoding="utf-8")
    result = CliRunner().invoke(app, ["verify", str(tmp_path), "--report", str(tmp_path / "report")])
    assert result.exit_code == 2
    index = (tmp_path / "report" / INDEX).read_text(encoding="utf-8")
    assert "Not checked" in index and "bad.md" in index and (tmp_path / "report" / "good.html").is_file()
    assert not (tmp_path / "report" / "bad.html").exists()


def test_a_folder_of_somebody_elses_is_refused_before_anything_is_checked(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text(RIGHT, encoding="utf-8")
    result = CliRunner().invoke(app, ["verify", str(tmp_path / "page.md"), "--report", str(tmp_path)])
    assert result.exit_code == 2 and "holds 'page.md', which is no part of a report" in result.stderr
    assert result.stdout == "" and [path.name for path in tmp_path.iterdir()] == ["page.md"]


def test_strict_counts_in_the_index_too(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text(
        "---\narm: scara\n---\n$$ p_4 = u + w $$\n$$ \\dot x + w = K $$\n", encoding="utf-8"
    )
    runs = {
        strict: CliRunner().invoke(
            app, ["verify", str(tmp_path / "page.md"), "--report", str(tmp_path / f"r{strict}"), *flag]
        )
        for strict, flag in ((0, []), (1, ["--strict"]))
    }
    index = [(tmp_path / f"r{strict}" / INDEX).read_text(encoding="utf-8") for strict in (0, 1)]
    assert [run.exit_code for run in runs.values()] == [0, 1]
    undecided = "2 of 2 equations not decided"
    assert f"Nothing wrong found; {undecided}" in index[0]
    assert f"1 document does not pass (--strict: {undecided})" in index[1]
