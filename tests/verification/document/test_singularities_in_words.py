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
    "Por tanto, el brazo pierde un grado de libertad cuando está estirado o plegado:",
    "Le bras est singulier lorsque le déterminant s'annule, c'est-à-dire pour",
)
EXHAUSTIVE = (
    "The arm is singular if and only if the elbow is straight:",
    "The singular positions are therefore those where the links are aligned,",
    "Il y a donc singularité si et seulement si",
    "The arm loses a degree of freedom when the determinant vanishes. This happens for these elbow angles and no other, namely",
)
SUPPOSED = (
    "Suppose that the arm is singular when it is stretched:",
    "For small angles the arm is singular if and only if",
    "A student says that the arm is singular only when",
    "The arm is singular when the second joint is locked, for",
    "The arm is singular when it is stretched, and its manipulability is largest for",
    "The arm is singular only if",
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


@pytest.mark.parametrize("sentence", EXHAUSTIVE)
def test_a_place_that_is_left_out_refutes_what_is_said_to_be_all(sentence: str) -> None:
    assert _verdict(sentence, r"\theta_2 = 0, \pi") is Verdict.PROVED
    assert _verdict(sentence, r"\theta_2 = 0") is Verdict.REFUTED
    assert _verdict("The arm is singular for", r"\theta_2 = 0") is Verdict.UNCHECKED  # for one


def test_a_place_beyond_what_the_text_bounds_is_not_left_out() -> None:
    assert _verdict(r"For $0 \le \theta_2 < \pi$ the arm is singular only for", r"\theta_2 = 0") is Verdict.UNCHECKED
    assert _verdict(r"For $-\pi < \theta_2 \le \pi$ the arm is singular only for", r"\theta_2 = 0") is Verdict.REFUTED


def test_a_second_place_holds_beside_the_first() -> None:
    sentence = r"There is a singularity of the arm at $\theta_2 = 0$, and another singularity at"
    assert _verdict(sentence, r"\theta_2 = \pi / 2") is Verdict.REFUTED
    assert _verdict(sentence, r"\theta_2 = \pi") is Verdict.UNCHECKED


@pytest.mark.parametrize("sentence", SUPPOSED)
def test_what_is_supposed_or_of_another_is_not_refuted(sentence: str) -> None:
    assert _verdict(sentence, r"\theta_2 = \pi / 2") is Verdict.UNCHECKED


def _verdict(sentence: str, latex: str) -> Verdict:
    text = f"---\narm: planar_2r\n---\n# Arm\n{sentence}\n\n$$ {latex} $$\n"
    [record] = check_document(parse_document(Path("arm.md"), text)).equations
    return record.verdict
