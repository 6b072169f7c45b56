"""What is confirmed at the arm's own lengths is tried at others, where the function takes lengths."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from armproof.verification.functions import check_function
from armproof.verification.functions.function_check import FunctionVerdict


def tool(forearm: Callable[[float, float], float]) -> Callable[..., Any]:
    def position(q: Any, l_1: float, l_2: float) -> Any:
        theta_1, theta_12 = (
            (q[0], q[0] + q[1]) if q[0] > -100 else (0.0, 0.0)
        )  # it cannot be traced: it branches on a value
        reach = forearm(l_1, l_2)
        return np.array(
            [l_1 * np.cos(theta_1) + reach * np.cos(theta_12), l_1 * np.sin(theta_1) + reach * np.sin(theta_12), 0]
        )

    return position


@pytest.mark.parametrize(
    ("forearm", "verdict"),
    [(lambda l_1, l_2: l_2, FunctionVerdict.CONFIRMED), (lambda l_1, l_2: l_1 - 0.1, FunctionVerdict.REFUTED)],
)
def test_what_is_confirmed_is_tried_at_other_lengths(
    forearm: Callable[[float, float], float], verdict: FunctionVerdict
) -> None:
    found = check_function("planar_2r", tool(forearm), {"origin": 2})
    assert found.verdict is verdict
    assert "own lengths only" in found.message or verdict is FunctionVerdict.CONFIRMED
