"""`armproof singularities`: the analysis as text and as JSON, and what it refuses."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner, Result

from armproof.verification.cli import app

runner = CliRunner()


def run(*arguments: str) -> Result:
    return runner.invoke(app, ["singularities", *arguments])


def test_the_text_tells_families_directions_and_where_they_lie() -> None:
    result = run("planar_2r")
    assert result.exit_code == 0
    for part in ("det J       l_1 l_2 S_2", "θ_2 = 0   rank 1", "θ_2 = π   rank 1", "q̇ = (l_2, -l_1 - l_2)", "boundary (confirmed)",
                 "if l_1 = l_2: inside (proved)"):  # fmt: skip
        assert part in result.output
    assert "\\" not in result.output


def test_the_json_holds_the_analysis() -> None:
    result = run("spatial_rrr", "--format", "json")
    report = json.loads(result.output)
    assert result.exit_code == 0 and report["complete"]
    assert report["determinant"] == r"l_2 l_3 C_3 \left(l_2 C_2 + l_3 S_{23}\right)"
    ranks = {tuple(family["conditions"]): family["rank"] for family in report["families"]}
    assert set(ranks.values()) == {2} and len(ranks) == 3
    shoulder = next(family for family in report["families"] if "l_2" in family["conditions"][0])
    assert shoulder["position"]["kind"] == "inside" and shoulder["null_motions"] == [["1", "0", "0"]]
    assert {family["rank"] for family in report["intersections"]} == {1}


def test_rows_and_axes_can_be_chosen() -> None:
    report = json.loads(run("planar_2r", "--rows", "1,2,6", "--in", "2", "--format", "json").output)
    assert (report["rows"], report["expressed_in"], report["families"]) == ([1, 2, 6], "2", [])
    assert "no configuration is singular" in run("planar_2r", "--rows", "1,2,6").output


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("planar_9r",), "planar_9r"),
        (("planar_2r", "--rows", "1;2"), "--rows is a list of numbers such as 1,2,6, not '1;2'"),
        (("planar_2r", "--rows", "7"), "rows of the Jacobian are different numbers from 1 to 6, not [7]"),
        (("planar_2r", "--frame", "5"), "no frame '5' on arm 'planar_2r'; its frames are 0, 1, 2"),
    ],
)
def test_what_cannot_run_is_said(arguments: tuple[str, ...], message: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2 and message in result.output + result.stderr
