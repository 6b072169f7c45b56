"""What leaves a block is what has no value, and no other error."""

import pytest

from armproof.verification.errors import EvaluationError, NoValue, ReadError, TooComplex, WhereDefined


@pytest.mark.parametrize("error", [EvaluationError("1/0"), NoValue("1/0")], ids=lambda error: type(error).__name__)
def test_what_has_no_value_leaves_its_block(error: Exception) -> None:
    with WhereDefined():
        raise error


@pytest.mark.parametrize(
    "error", [TooComplex("long"), ReadError("("), KeyError("x")], ids=lambda error: type(error).__name__
)
def test_any_other_error_goes_on(error: Exception) -> None:
    with pytest.raises(type(error)), WhereDefined():
        raise error
