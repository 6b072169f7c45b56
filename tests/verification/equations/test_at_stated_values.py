"""Numbers are those at the values that displays state, and of no other configuration."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from armproof import verify_text
from armproof.models.catalogue import load_arm
from armproof.verification.check import DocumentChecker
from armproof.verification.document import Display, Document
from armproof.verification.verdict import DocumentResult, Record, Verdict

Judge = Callable[..., Record]
Check = Callable[..., DocumentResult]

PLANAR: dict[str, Any] = {
    "arm": "planar_2r",
    "quantities": {"P_x": {"origin": 2, "component": "x"}, "J": {"jacobian": 2, "rows": [1, 2]}},
}
STATED = (r"l_1 = l_2 = 1", r"\theta_1 = 0, \quad \theta_2 = \frac{\pi}{2}")


@pytest.mark.parametrize(("number", "verdict"), [("1", Verdict.CONFIRMED), ("0.5", Verdict.REFUTED)])
def test_a_number_is_that_at_the_configuration_stated(judge: Judge, number: str, verdict: Verdict) -> None:
    assert judge(rf"\det J = {number}", **PLANAR).verdict is Verdict.UNCHECKED
    assert judge(*STATED, rf"\det J = {number}", **PLANAR).verdict is verdict


def test_what_holds_there_is_evaluated_there_alone(judge: Judge) -> None:
    rates, unit = r"\dot\theta_1 = 0.2, \dot\theta_2 = 0", r"\dot P_x = -0.2 (l_1 s_1 + l_2 s_{12})"
    for displays in ((*STATED, r"\det J = 1"), (r"\theta_1 = 0, \theta_2 = 0", "P_x = l_1 + l_2"), (rates, unit)):
        record = judge(*displays, **PLANAR)
        assert (record.verdict, record.samples) == (Verdict.CONFIRMED, 1)


def test_what_is_wrong_there_is_told_with_the_values_stated(judge: Judge) -> None:
    record = judge(*STATED, r"p_2 = \begin{bmatrix} 1 \\ 2 \\ 0 \end{bmatrix}", **PLANAR)
    assert [(each.row, each.printed, each.correct) for each in record.entries] == [(2, "2", "1")]
    assert record.counterexample == pytest.approx({"l_1": 1, "l_2": 1, "theta_1": 0, "theta_2": 1.5707963})


def test_zeros_and_ones_do_not_tell_that_numbers_are_of_the_configuration_of_the_text() -> None:
    """At θ_2 = π/2 a rotation has them at many others, too; lengths it has there alone."""
    front = "---\narm: planar_2r\n---\n\n$$ l_1 = 0.5, \\; l_2 = 0.25 $$\n\n"
    said = front + "At $\\theta_1 = 0$ and $\\theta_2 = \\pi/2$ we get\n\n$$ %s $$\n"
    turned = r"R_2^0 = \begin{bmatrix} %s & -1 & 0 \\ 1 & 0 & 0 \\ 0 & 0 & 1 \end{bmatrix}"
    point = r"p_2 = \begin{bmatrix} 0.5 \\ 0.25 \\ %s \end{bmatrix}"
    verdicts = [
        verify_text(said % (form % entry)).equations[-1].verdict for form in (turned, point) for entry in ("0", "0.5")
    ]
    assert verdicts == [Verdict.CONFIRMED, Verdict.UNCHECKED, Verdict.CONFIRMED, Verdict.REFUTED]


@pytest.mark.parametrize(
    ("said", "verdict"), [("", Verdict.REFUTED), (r"Now $l_1 = \foo{3}$.", Verdict.UNCHECKED), ("Now $l_1 = 2$.", Verdict.CONFIRMED)]
)  # fmt: skip
def test_what_the_text_says_and_is_not_read_ends_what_was_stated_before_it(said: str, verdict: Verdict) -> None:
    page = f"---\narm: planar_2r\n---\n\n$$ l_1 = 1, \\; l_2 = 0.5 $$\n\n{said}\n\n$$ \\|p_1\\| = 2 $$\n"
    assert verify_text(page).equations[-1].verdict is verdict


def test_a_slip_is_in_a_few_entries_and_another_configuration_in_more(judge: Judge) -> None:
    rows = [["-1", "-1"], ["1", "0"]]

    def verdict(changed: int) -> Verdict:
        places = ((0, 0), (0, 1), (1, 0), (1, 1))
        cells = [[f"{cell}5" if (r, c) in places[:changed] and cell != "0" else "3" if (r, c) in places[:changed] else cell
                  for c, cell in enumerate(row)] for r, row in enumerate(rows)]  # fmt: skip
        return judge(
            *STATED, r"J = \begin{bmatrix}" + r"\\".join("&".join(row) for row in cells) + r"\end{bmatrix}", **PLANAR
        ).verdict

    assert [verdict(changed) for changed in range(5)] == [
        Verdict.CONFIRMED, Verdict.REFUTED, Verdict.REFUTED, Verdict.REFUTED, Verdict.UNCHECKED
    ]  # fmt: skip


def test_values_count_as_data_where_a_decided_claim_uses_them(check: Check) -> None:
    def verdicts(*displays: str) -> list[Verdict]:
        return [record.verdict for record in check(*displays, **PLANAR).equations]

    assert verdicts(*STATED, r"\det J = 1") == [Verdict.DEFINED, Verdict.DEFINED, Verdict.CONFIRMED]
    assert verdicts(*STATED, r"\det J = l_1 l_2 s_2") == [Verdict.UNCHECKED, Verdict.UNCHECKED, Verdict.PROVED]


def test_a_configuration_is_never_made_of_two(judge: Judge) -> None:
    assert judge(*STATED, r"\theta_1 = \frac{\pi}{2}", "P_x = -1", **PLANAR).verdict is Verdict.UNCHECKED
    assert judge(*STATED, r"\theta_1 = \frac{\pi}{2}", r"\det J = 1", **PLANAR).verdict is Verdict.UNCHECKED


def test_a_place_is_asked_for_where_the_tool_is_not_there(judge: Judge) -> None:
    assert judge(*STATED, "P_x = 1.0", **PLANAR).verdict is Verdict.CONFIRMED
    asked = judge(*STATED, "P_x = 0.8", **PLANAR)
    assert asked.verdict is Verdict.UNCHECKED and "configuration" in asked.message


def of_lengths(judge: Judge, *displays: str) -> Record:
    return judge("P_x = 0.5 c_1 + 0.3 c_{12}", *displays, **PLANAR)


def test_numbers_where_the_arm_has_lengths_are_their_values(judge: Judge) -> None:
    assert of_lengths(judge, r"\det J = 0.15 s_2").verdict is Verdict.CONFIRMED
    assert of_lengths(judge, r"\det J = 0.16 s_2").verdict is Verdict.REFUTED
    assert judge(r"\det J = 0.15 s_2", **PLANAR).verdict is Verdict.UNCHECKED
    assert judge(r"\det J = 0.15 c_2", **PLANAR).verdict is not Verdict.CONFIRMED


def test_a_length_may_be_said_in_centimetres(judge: Judge) -> None:
    stated = (r"l_1 = 50\,\text{cm}", r"l_2 = 300\,\text{mm}", r"\theta_1 = \theta_2 = 0")
    assert judge(*stated, r"P_x = 80\,\text{cm}", **PLANAR).verdict is Verdict.CONFIRMED
    assert judge(*stated, r"P_x = 80", **PLANAR).verdict is Verdict.UNCHECKED  # of which unit?


OFFSET: dict[str, Any] = {
    "arm": {
        "dh": "classic",
        "rows": [
            {"a": "a_1", "alpha": 0, "d": 0, "theta": "theta_1 + pi/2"},
            {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"},
        ],
    }
}


@pytest.mark.parametrize(
    ("place", "numbers", "verdict"),
    [
        (r"a_1 c_1 \\ a_1 s_1 \\ 0", r"0.5 \\ 0 \\ 0", Verdict.CONFIRMED),
        (r"a_1 c_1 \\ a_1 s_1 \\ 0", r"-0.5 \\ 0 \\ 0", Verdict.REFUTED),
        (r"-a_1 s_1 \\ a_1 c_1 \\ 0", r"0 \\ 0.5 \\ 0", Verdict.CONFIRMED),
        (r"-a_1 s_1 \\ a_1 c_1 \\ 0", r"0 \\ -0.5 \\ 0", Verdict.REFUTED),
        (r"0 \\ 0 \\ 0", r"0.5 \\ 0 \\ 0", Verdict.UNCHECKED),
    ],
)
def test_a_value_is_that_of_the_angle_that_the_document_means(
    judge: Judge, place: str, numbers: str, verdict: Verdict
) -> None:
    p_1 = r"p_1 = \begin{bmatrix} %s \end{bmatrix}"
    assert judge(p_1 % place, r"a_1 = 0.5, \; \theta_1 = 0", p_1 % numbers, **OFFSET).verdict is verdict


@pytest.mark.parametrize(
    ("number", "verdict", "says"),
    [("0.2", Verdict.UNCHECKED, "rounded?"), ("0.1", Verdict.UNCHECKED, "rounded?"), ("0.3", Verdict.REFUTED, "l_1 l_2 s_2"),
     ("0.154", Verdict.REFUTED, "l_1 l_2 s_2"), ("0.151", Verdict.REFUTED, "l_1 l_2 s_2"), ("0.150", Verdict.CONFIRMED, "")],
)  # fmt: skip
def test_a_number_within_a_unit_of_its_last_decimal_is_rounded_perhaps(
    judge: Judge, number: str, verdict: Verdict, says: str
) -> None:
    record = of_lengths(judge, rf"\det J = {number} s_2")
    assert (record.verdict, says in record.message) == (verdict, True), record.message


@pytest.mark.parametrize(
    ("displays", "verdict"),
    [
        ([r"\det J = 0.15 s_2"], Verdict.UNCHECKED),
        ([r"\det J = 15 s_2"], Verdict.REFUTED),
        ([r"\det J = 0.15 l_1 s_2"], Verdict.REFUTED),
        ([r"l_1 = 0.5", r"\det J = 0.15 s_2"], Verdict.REFUTED),
        ([r"l_1 c_1 = 0.5 c_1"], Verdict.REFUTED),
    ],
)
def test_in_a_task_decimals_are_of_lengths_that_nobody_gave(displays: list[str], verdict: Verdict) -> None:
    found = tuple(Display(line, latex) for line, latex in enumerate(displays, 1))
    checker = DocumentChecker(Document(Path("page.md"), PLANAR, found, ()), load_arm("planar_2r"))
    checker.checker.equality.stated.enabled = False
    assert checker.run().equations[-1].verdict is verdict
