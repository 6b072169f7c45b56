"""Where an arm is singular, in the words of several languages: the condition behind them is that of det J = 0, and no configuration."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from armproof.verification.verdict import Verdict

TOLD = (
    "La singularité est donc",
    "Die Jacobi-Matrix ist singulär, wenn",
    "Die Singularitäten liegen bei",
    "Der Arm ist genau dann singulär, wenn",
    "El brazo es singular cuando",
    "Il braccio è singolare per",
)
DENIED = (
    "Der Arm ist nicht singulär, wenn",
    "El brazo no es singular cuando",
    "Il braccio non è singolare se",
)


@pytest.mark.parametrize("sentence", TOLD)
def test_what_is_told_to_be_singular_is_decided(sentence: str) -> None:
    assert _verdict(sentence, r"\sin\theta_2 = 0") is Verdict.PROVED
    for wrong in (r"\cos\theta_2 = 0", r"\theta_1 = 0"):
        assert _verdict(sentence, wrong) in (Verdict.REFUTED, Verdict.UNCHECKED)


@pytest.mark.parametrize("sentence", DENIED)
def test_what_is_denied_is_not(sentence: str) -> None:
    for latex in (r"\sin\theta_2 = 0", r"\cos\theta_2 = 0"):
        assert _verdict(sentence, latex) is Verdict.UNCHECKED


def _verdict(sentence: str, latex: str) -> Verdict:
    text = f"---\narm: planar_2r\n---\n# Arm\n{sentence}\n\n$$ {latex} $$\n"
    [record] = check_document(parse_document(Path("arm.md"), text)).equations
    return record.verdict
