"""Every classic mistake on every arm is refuted, and nearly all are named."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.diagnosis.causes.probes import probes
from armproof.verification.functions import FunctionVerdict, check_function
from tests.verification.functions.mistakes import Mistake, mistakes_of
from tests.verification.functions.right import last_frame

FEWEST = 12


def changing(arm: Arm) -> Iterator[Mistake]:
    """Yield the mistakes that change something on the arm; those that change it alike go by each other's names."""
    q = probes(arm).q
    true = {
        "pose": NumericKinematics(arm, q).pose(last_frame(arm)),
        "jacobian": NumericKinematics(arm, q).jacobian(last_frame(arm)),
    }
    found: list[tuple[Mistake, np.ndarray]] = []
    for mistake in mistakes_of(arm):
        values = np.array([mistake.function(row.copy()) for row in q])
        if not are_equal(values, true[mistake.quantity]):
            found.append((mistake, values))
    for mistake, values in found:
        alike = [m.words for m, other in found if m.quantity == mistake.quantity and are_equal(values, other)]
        yield replace(mistake, words=tuple(word for words in alike for word in words))


def are_equal(a: np.ndarray, b: np.ndarray) -> bool:
    return a.shape == b.shape and bool(np.abs(a - b).max() < 1e-9)


def is_named(mistake: Mistake, message: str) -> bool:
    return any(re.search(words if words.startswith("\\") else re.escape(words), message) for words in mistake.words)


@pytest.mark.parametrize("name", arm_names())
def test_classic_mistakes_are_refuted_and_named(name: str) -> None:
    arm = load_arm(name)
    mistakes = list(changing(arm))
    assert len(mistakes) >= FEWEST
    unnamed = []
    for mistake in mistakes:
        check = check_function(arm, mistake.function, {mistake.quantity: last_frame(arm)})
        assert check.verdict is FunctionVerdict.REFUTED, (mistake.name, check)
        assert not any("internal error" in note for note in check.notes), (mistake.name, check.notes)
        assert check.table or "×" in check.message, (mistake.name, check)
        if not is_named(mistake, check.message):
            unnamed.append(f"{mistake.quantity}, {mistake.name}: {check.message}")
    assert len(unnamed) <= 0.1 * len(mistakes), "\n".join(unnamed)
