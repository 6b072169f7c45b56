"""Our verdicts against the labels; what is not yet right stands in not_yet.txt, which can only shrink."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
import yaml

from tests.labelled.cases import ALLOWED, FALSE_PASS, FALSE_REFUTATION, HERE, UNDECIDED, Case, expand, load_cases
from tests.labelled.evaluator import evaluate
from tests.labelled.faults import Fault, faults_of_cases, faults_of_pages, mended, read_not_yet, unexpected
from tests.labelled.pages import load_pages
from tests.labelled.plant_truth import PlantTruth

TABLE = yaml.safe_load((HERE / "spellings.yaml").read_text("utf-8"))
ENTRIES = [(group, entry) for group in TABLE["groups"] for entry in group["cases"] if "truth" in entry]


def all_faults() -> tuple[Fault, ...]:
    return (*faults_of_cases(), *faults_of_pages())


def test_no_verdict_is_wrong_that_is_not_on_the_list():
    found = unexpected(all_faults(), read_not_yet())
    assert not found, "\n".join(f"{fault.line} ({fault.message})" for fault in found)


def test_what_is_mended_has_left_the_list():
    found = mended(all_faults(), read_not_yet())
    assert not found, f"mended: {', '.join(found)}; `python -m tests.labelled --update` takes them out"


def test_a_fault_that_is_not_listed_or_worse_than_listed_is_noticed():
    fault = Fault("00000000", FALSE_REFUTATION, "", "")
    assert unexpected([fault], {}) == [fault]
    assert unexpected([fault], {fault.key: UNDECIDED}) == [fault]
    assert not unexpected([fault], {fault.key: FALSE_REFUTATION})
    assert mended([fault], {fault.key: UNDECIDED, "ffffffff": FALSE_PASS}) == ["ffffffff"]


@pytest.mark.parametrize(
    ("label", "verdict", "fault"),
    [
        ("right", "proved", ""),
        ("right", "defined", UNDECIDED),
        ("right", "refuted", FALSE_REFUTATION),
        ("right?", "unchecked", ""),
        ("wrong", "refuted", ""),
        ("wrong", "defined", FALSE_PASS),
        ("open", "confirmed", FALSE_PASS),
        ("open", "refuted", FALSE_REFUTATION),
        ("remark", "defined", FALSE_PASS),
        ("data", "defined", ""),
        ("data", "proved", FALSE_PASS),
    ],
)
def test_a_label_allows_its_verdicts_only(label: str, verdict: str, fault: str):
    assert Case("", "", label, "", "x = 1", (), "").fault(verdict) == fault


def test_the_set_is_large_and_each_case_stands_in_it_once():
    cases, pages = load_cases(), Counter(page.kind for page in load_pages())
    assert set(ALLOWED) == {case.label for case in cases}
    assert min(Counter(case.file for case in cases).values()) >= 200
    assert len({case.key for case in cases}) == len(cases)
    assert pages["attack"] == pages["twin"] >= 40 and pages["stranger"] >= 12
    assert all(page.false for page in load_pages() if page.kind == "attack")


@pytest.mark.parametrize(("group", "entry"), ENTRIES, ids=lambda part: part.get("reads", part.get("about")))
def test_the_labels_of_the_spellings_are_what_the_plant_says(group: dict, entry: dict):
    truth = PlantTruth.of_catalogue(group["front"]["arm"])
    let = {**TABLE["let"], **group.get("let", {})}
    rng = np.random.default_rng(7)
    q, rates = rng.uniform(0.2, 1.2, len(truth.symbols)), rng.uniform(0.2, 1, len(truth.symbols))
    expected, values = truth.quantity(entry["truth"], q, rates), truth.values(q, rates)
    np.testing.assert_allclose(evaluate(expand(entry["right"], let), values), expected, atol=1e-12)
    for wrong in entry["wrong"]:
        assert np.abs(evaluate(expand(wrong, let), values) - expected).max() > 1e-3


@pytest.mark.parametrize(
    ("latex", "value"),
    [(r"-2 c_1 + \frac{1}{2}", -1.5), (r"|s_{12} - 3|", 3), (r"\sqrt{4} l_1^2", 18), (r"2 \cos(\theta_1) (1 + 1)", 4)],
)
def test_the_evaluator_reads_what_the_tables_are_written_in(latex: str, value: float):
    assert evaluate(latex, {"theta_1": 0.0, "theta_2": 0.0, "l_1": 3.0}) == pytest.approx(value)


@pytest.mark.parametrize("latex", ["c_1 +", r"\foo", "2 )", r"\frac{1}"])
def test_the_evaluator_reads_nothing_halfway(latex: str):
    with pytest.raises((ValueError, KeyError)):
        evaluate(latex, {"theta_1": 0.0})
