"""Names against the labels, and the labels against Drake's plant: each name is equated to right values and to wrong ones."""

from __future__ import annotations

import numpy as np
import pytest

from tests.labelled.cases import drawn, expand, load_cases, read_table
from tests.labelled.evaluator import evaluate
from tests.labelled.faults import faults_among, mended, read_not_yet, unexpected
from tests.labelled.judging import judge_all
from tests.labelled.plant_truth import PlantTruth

TABLE = read_table("spellings.yaml")
ENTRIES = [(group, entry) for group in TABLE["groups"] for entry in group["cases"] if "truth" in entry]
SPELT = load_cases("spellings.yaml")
DRAWN = drawn(SPELT, 4)  # one in four names of each value, the rest in `make test-rest`


def test_no_verdict_is_wrong_that_is_not_on_the_list_nor_one_on_it_mended():
    keys = {case.key for case in DRAWN}
    faults, listed = faults_among(judge_all(DRAWN)), read_not_yet()
    assert not unexpected(faults, listed)
    assert not mended(faults, {key: kind for key, kind in listed.items() if key in keys})


def test_what_is_drawn_has_right_and_wrong_values_of_each_group():
    kinds = [
        {(case.about, case.front, case.label) for case in cases if case.label != "right?"}
        for cases in (drawn(SPELT, 4, "some"), SPELT)
    ]
    assert kinds[0] == kinds[1] and len(kinds[0]) > 15


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
