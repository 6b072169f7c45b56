"""A few dozen of the random claims in every run; `make sweep` draws twenty thousand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.labelled.cases import FALSE_PASS, FALSE_REFUTATION
from tests.laws import SWEEP
from tests.sweeps.claims import NOT_YET, SEED, Trial, false_verdicts, trials_of
from tests.sweeps.generated.arms import random_arm
from tests.sweeps.generated.claims import Claim, Random

SEEDS = (*range(SEED, SEED + 7), SEED + 9) if SWEEP else (*range(SEED, SEED + 4), SEED + 9)


@pytest.fixture(scope="module")
def trials() -> list[Trial]:
    return [trial for seed in SEEDS for trial in trials_of(seed)]


def test_no_verdict_on_a_random_claim_is_false(trials: list[Trial]):
    false = [trial for trial in false_verdicts(trials) if trial.claim.role not in NOT_YET]
    assert not false, "\n".join(f"{t.seed} {t.claim.role} {t.fault}: {t.claim.latex} ({t.message})" for t in false)
    assert len(trials) >= 7 * len(SEEDS)
    assert 0.3 < sum(trial.claim.true for trial in trials) / len(trials) < 0.8


def test_a_role_that_is_not_yet_right_has_false_verdicts(trials: list[Trial]):
    mended = NOT_YET - {trial.claim.role for trial in false_verdicts(trials)}
    assert not mended, f"mended: take {', '.join(sorted(mended))} out of NOT_YET in tests/sweeps/claims.py"


@pytest.mark.parametrize(
    ("true", "verdict", "fault"),
    [(True, "refuted", FALSE_REFUTATION), (False, "defined", FALSE_PASS), (False, "refuted", ""), (True, "proved", "")],
)
def test_a_false_verdict_is_noticed(true: bool, verdict: str, fault: str):
    assert Trial(0, Claim("x = 1", "pose", true), verdict, "").fault == fault


@pytest.mark.parametrize("seed", SEEDS)
def test_the_printed_links_are_those_of_the_plant(seed: int):
    """The matrices that formulas are printed from agree with Drake's plant, of tables and of URDFs."""
    from tests.labelled.evaluator import evaluate
    from tests.sweeps.generated.claims import Claims

    rng = Random(seed)
    arm = random_arm(rng)
    claims = Claims(arm, rng)
    q = claims.points[0]
    for k, link in enumerate(arm.links):
        found = evaluate(claims.print(link), arm.truth.values(q, claims.rates[0]))
        np.testing.assert_allclose(found, arm.truth.pose(q, str(k + 1), str(k)), atol=1e-12)
