"""Right functions are proved, whatever they are written in."""

from __future__ import annotations

import pytest

from armproof.models.catalogue import arm_names, load_arm
from armproof.verification.functions import FunctionVerdict, check_function
from tests.verification.functions.right import STYLES, last_frame, right


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("name", arm_names())
def test_a_right_function_is_proved(name: str, style: str) -> None:
    functions = right(name, style)
    if functions is None:
        pytest.skip("the arm's frames follow no Denavit–Hartenberg convention")
    frame = last_frame(load_arm(name))
    for function, kind in zip(functions, ("pose", "jacobian"), strict=True):
        check = check_function(name, function, {kind: frame}, seconds=30)  # a busy machine changes no verdict
        assert check.verdict is FunctionVerdict.PROVED, check
        assert check.exact and check.samples >= 6 and check.max_error < 1e-12
