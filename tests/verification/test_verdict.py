"""Verdicts, their order, what passes, and the JSON that the design promises."""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.verdict import (
    DocumentResult,
    EquationResult,
    Failure,
    Record,
    Role,
    TakenArm,
    Verdict,
    WrongEntry,
    summary,
    worst,
)

ALL = list(Verdict)


def record(verdict: Verdict, **more: object) -> Record:
    return replace(Record(1, "a = b", verdict), **more)  # type: ignore[arg-type]


@pytest.mark.parametrize(("a", "b"), list(itertools.product(ALL, ALL)))
def test_the_worst_of_two_does_not_depend_on_their_order(a: Verdict, b: Verdict) -> None:
    assert worst([a, b]) is worst([b, a])
    assert worst([a, b]) in (a, b) and worst([a, a]) is a


def test_a_definition_yields_to_all_and_a_refutation_to_none() -> None:
    order = [Verdict.DEFINED, Verdict.PROVED, Verdict.CONFIRMED, Verdict.UNCHECKED, Verdict.UNREADABLE, Verdict.REFUTED]
    assert sorted(order) != order and set(order) == set(ALL)
    for better, worse in itertools.combinations(order, 2):
        assert worst([better, worse]) is worse
    assert worst([]) is Verdict.DEFINED


def test_an_erratum_passes_when_it_is_refuted_and_anything_else_when_it_is_not() -> None:
    for verdict in ALL:
        assert record(verdict, erratum=True).passes == (verdict is Verdict.REFUTED)
        assert record(verdict).passes == (verdict not in (Verdict.REFUTED, Verdict.UNREADABLE))


def test_strictness_fails_on_what_is_unchecked_and_on_nothing_else() -> None:
    for verdict in ALL:
        result = DocumentResult("page.md", "scara", (record(Verdict.PROVED), record(verdict)))
        assert result.passed_strictly() == (result.passed and verdict is not Verdict.UNCHECKED)
        beside = DocumentResult("page.md", "scara", (record(Verdict.PROVED),), (record(verdict),))
        assert (beside.passed, beside.passed_strictly()) == (result.passed, result.passed_strictly())


def test_the_summary_counts_every_display_once() -> None:
    results = [
        DocumentResult("a.md", "", tuple(map(record, ALL))),
        DocumentResult("b.md", "", (record(Verdict.PROVED),)),
    ]
    counts = summary(results)
    assert list(counts) == ["proved", "confirmed", "defined", "refuted", "unchecked", "unreadable", "beyond"]
    assert sum(counts.values()) == 7 and counts["proved"] == 2 and counts["refuted"] == 1
    assert summary([]) == dict.fromkeys(counts, 0)


def test_a_remark_is_unchecked_is_counted_apart_and_never_fails_strictness() -> None:
    remark, claim = (EquationResult(1, role, Verdict.UNCHECKED) for role in (Role.REMARK, Role.CLAIM))
    assert remark.is_remark and not claim.is_remark and not replace(remark, verdict=Verdict.PROVED).is_remark
    about_other_things = record(Verdict.UNCHECKED, outcomes=(remark, remark))
    mixed, none = record(Verdict.UNCHECKED, outcomes=(remark, claim)), record(Verdict.UNCHECKED)
    assert [each.is_remark for each in (about_other_things, mixed, none)] == [True, False, False]
    result = DocumentResult("a.md", "", (record(Verdict.PROVED), about_other_things))
    assert summary([result, result])["beyond"] == 2 and summary([result])["unchecked"] == 1
    assert result.passed_strictly() and not replace(result, equations=(record(Verdict.PROVED), mixed)).passed_strictly()


def test_a_record_is_written_as_the_design_says(judge: Callable[..., Record]) -> None:
    written = json.loads(json.dumps(judge(r"p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 c_1 \\ 0 \end{bmatrix}").as_json()))
    assert list(written) == [
        "line",
        "latex",
        "verdict",
        "erratum",
        "message",
        "findings",
        "outcomes",
        "entries",
        "counterexample",
        "samples",
        "max_error",
        "arm_index",
    ]
    assert (written["line"], written["verdict"], written["erratum"]) == (1, "refuted", False)
    (entry,) = written["entries"]
    assert (entry["equation"], entry["row"], entry["column"]) == (1, 2, 1)
    assert (entry["printed"], entry["correct"]) == ("a_1 c_1", "a_1 s_1")
    assert {"theta_1", "theta_2", "d_3", "theta_4"} <= set(written["counterexample"])
    assert all(isinstance(value, float) for value in written["counterexample"].values())


def test_a_proof_is_written_with_its_samples(judge: Callable[..., Record]) -> None:
    written = judge(r"c_{12} = c_1 c_2 - s_1 s_2").as_json()
    assert (written["verdict"], written["samples"], written["entries"], written["counterexample"]) == (
        "proved",
        1000,
        [],
        {},
    )
    assert 0 <= written["max_error"] < 1e-14


def test_a_cell_of_a_notebook_is_named() -> None:
    assert record(Verdict.PROVED, cell=3).as_json()["cell"] == 3 and "cell" not in record(Verdict.PROVED).as_json()


def test_a_wrong_entry_leaves_out_what_it_does_not_have() -> None:
    assert WrongEntry(2, None, None, "a", "b").as_json() == {"equation": 2, "printed": "a", "correct": "b"}
    entry = WrongEntry(1, 3, 4, "a", "b", say(Kind.WRONG_SIGN), (0, 1))
    assert entry.as_json() == {
        "equation": 1,
        "row": 3,
        "column": 4,
        "printed": "a",
        "correct": "b",
        "change": "wrong sign",
    }


def test_a_document_is_written_as_the_design_says(check: Callable[..., DocumentResult]) -> None:
    result = check("c_1 = c_1", errata=("c_1 = s_1",))
    written = result.as_json()
    assert list(written) == ["path", "arm", "arms", "passed", "equations"]
    assert (written["path"], written["arm"], written["passed"]) == ("page.md", "scara", True)
    assert [equation["erratum"] for equation in written["equations"]] == [False, True]
    assert check("c_1 = s_1").as_json()["passed"] is False
    assert check("c_1 = c_1", arm=None).as_json()["arm"] == ""


def test_each_equation_keeps_its_own_verdict_and_findings(judge: Callable[..., Record]) -> None:
    record = judge(r"p_2 = \begin{bmatrix} a_1 c_1 + a_2 c_{12} \\ a_1 s_1 + a_2 s_{12} \\ 0 \end{bmatrix}, \quad p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 c_1 \\ 0 \end{bmatrix}")  # fmt: skip
    right, wrong = record.outcomes
    assert (right.verdict, wrong.verdict) == (Verdict.PROVED, Verdict.REFUTED)
    assert not right.findings and wrong.findings == record.findings
    assert wrong.findings[0].kind is Kind.COSINE_FOR_SINE
    assert (wrong.findings[0].equation, wrong.findings[0].row, wrong.findings[0].column) == (2, 2, 1)


def test_an_arm_says_what_it_was_taken_from() -> None:
    arm = TakenArm("a", 7, "table", "classic", "upper", {})
    assert str(arm) == "arm of the table at line 7, classic DH"


def test_a_fault_of_a_document_has_its_line_where_it_is_that_document() -> None:
    error = DocumentError(say(Kind.PROBLEM, reason="odd"), path=Path("a.md"), line=7)
    assert Failure.of(Path("a.md"), error).line == 7
    assert Failure.of(Path("b.md"), error).line is None
    assert Failure.of(Path("a.md"), DocumentError(say(Kind.PROBLEM, reason="odd"))).line is None


@pytest.mark.parametrize("error", [OSError("no such disk"), ValueError("no such disk")])
def test_a_document_that_cannot_be_checked_says_why(error: Exception) -> None:
    failure = Failure.of(Path("a.md"), error)
    assert (failure.path, str(failure.finding), failure.line) == ("a.md", "no such disk", None)
