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
    "El robot es singular con el brazo estirado o plegado,",
    "Si hanno singolarità quando il braccio è disteso o ripiegato:",
    r"The arm is therefore singular, whatever $\theta_1$ is, for",
    "Singuläre Stellungen liegen vor bei",
    "Les singularités : le coude tendu ou replié,",
    "$J$ loses rank at",
    "**Singularities.**",
    "The arm is singular \\emph{if}",
)
OF_THE_DETERMINANT = (
    "It vanishes for",
    "Il s'annule pour",
    "which is zero when",
    "This is simple. The determinant vanishes when",
)
OF_ANOTHER = (
    "The first row of $J$ is not needed here. It vanishes for",
    "Representation singularity:",
    "The arm is singular with respect to the base frame, and we take",
)
EXHAUSTIVE = (
    "The arm is singular if and only if the elbow is straight:",
    "The singular positions are therefore those where the links are aligned,",
    "Il y a donc singularité si et seulement si",
    "so that the only singular configurations are those where the links are aligned:",
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


@pytest.mark.parametrize("sentence", OF_THE_DETERMINANT)
def test_it_is_the_determinant_that_stands_above(sentence: str) -> None:
    for above, right in ((r"\det J = l_1 l_2 s_2", True), (r"x = l_1 c_1 + l_2 c_{12}", False)):
        text = f"$$ {above} $$\n\n{sentence}"
        assert _verdict(text, r"\theta_2 = 0, \pi") is (Verdict.PROVED if right else Verdict.UNCHECKED)
        assert _verdict(text, r"\theta_2 = \pm\frac{\pi}{2}") is (Verdict.REFUTED if right else Verdict.UNCHECKED)


@pytest.mark.parametrize("sentence", OF_ANOTHER)
def test_what_is_of_another_is_left_open(sentence: str) -> None:
    for latex in (r"\theta_2 = 0, \pi", r"\theta_2 = \pm\frac{\pi}{2}"):
        assert _verdict(f"$$ \\det J = l_1 l_2 s_2 $$\n\n{sentence}", latex) is Verdict.UNCHECKED


@pytest.mark.parametrize(
    "sentence", ["*Elbow singularity*:", "The elbow singularity is met when the arm is stretched:"]
)
def test_of_one_kind_there_may_be_others(sentence: str) -> None:
    assert _verdict(sentence, r"c_3 = 0", "spatial_rrr") is Verdict.PROVED
    assert _verdict(sentence, r"c_1 = 0", "spatial_rrr") is Verdict.REFUTED


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\text{Singularities: } \theta_2 = 0 \text{ or } \theta_2 = \pi", Verdict.PROVED),
        (r"\text{Singularités : } \theta_2 = \pm\frac{\pi}{2}", Verdict.REFUTED),
        (r"\text{Singularités : } C_2 = 0 \iff \theta_2 = \pm 90^\circ", Verdict.REFUTED),
        (r"\text{Singularités : } S_2 = 0 \iff \theta_2 = \pm 90^\circ", Verdict.UNCHECKED),
        (r"\text{No singularity: } \theta_2 = \frac{\pi}{2}", Verdict.UNCHECKED),
    ],
)
def test_a_display_may_say_itself_that_it_is_of_singularities(latex: str, verdict: Verdict) -> None:
    assert _verdict("We get", latex) is verdict


def test_what_stands_in_parentheses_beside_a_condition_is_no_part_of_it() -> None:
    for right, verdict in ((r"\pi", Verdict.PROVED), (r"\frac{\pi}{2}", Verdict.REFUTED)):
        latex = rf"\theta_2 = 0 \quad\text{{(arm stretched)}}\quad\text{{or}}\quad \theta_2 = {right}"
        assert _verdict("Hence the singular configurations are", latex) is verdict


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


def _verdict(sentence: str, latex: str, arm: str = "planar_2r") -> Verdict:
    text = f"---\narm: {arm}\n---\n# Arm\n{sentence}\n\n$$ {latex} $$\n"
    *_, record = check_document(parse_document(Path("arm.md"), text)).equations
    return record.verdict
