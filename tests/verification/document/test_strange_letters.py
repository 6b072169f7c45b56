"""What a sentence above says of a letter in words that are not known leaves open what is written with that letter, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import verify_text
from armproof.verification.findings import Kind
from armproof.verification.verdict import Verdict

PAGE = r"""# A planar arm

| $i$ | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | 0 | $l_1$ | 0 |
| 2 | $\theta_2$ | 0 | $l_2$ | 0 |

## First

SENTENCE The table is long.

So

$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2) $$

## Second

$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2) $$
"""
OF_LETTER = [
    "A camera watches the elbow, and it delivers the numbers $x$ and $y$.",
    "Une caméra suit le clou planté dans l'axe du coude et donne $x$ et $y$.",
    "Ein Lausbub hat $x$ neulich ganz frech umgetauft.",
    r"El ángulo $\theta_2$ lo chismea el zapatero.",
    "Na imagem da câmara, que olha por baixo, o eixo $x$ cresce para a esquerda.",
    r"Il pollivendolo ha rubacchiato $l_2$.",
]
HARMLESS = [
    "A camera watches the elbow, and it delivers the numbers $u$ and $v$.",  # of other letters
    "A camera watches the elbow.",
    "The camera measures $x$ and $y$ of the hand.",
    r"L'avant-bras, de longueur $l_2$, fait l'angle $\theta_2$ avec le prolongement du bras.",
    r"El segundo eslabón forma el ángulo $\theta_2$ con la prolongación del primero.",
    r"Der Winkel $\theta_2$ wird von der Verlängerung des Oberarms aus gezählt.",
    "Without $x$ the problem would be harder.",
]


def _verdicts(sentence: str, text: str = PAGE) -> list[Verdict]:
    return [each.verdict for each in verify_text(text.replace("SENTENCE", sentence), path=Path("x.md")).equations]


@pytest.mark.parametrize("sentence", OF_LETTER)
def test_a_letter_told_of_in_unknown_words_is_left_open_in_its_section(sentence: str) -> None:
    assert _verdicts(sentence) == [Verdict.UNCHECKED, Verdict.PROVED]
    assert _verdicts(sentence, PAGE.replace("+ l_2", "- l_2", 1)) == [Verdict.UNCHECKED, Verdict.PROVED]


@pytest.mark.parametrize("sentence", HARMLESS)
def test_words_that_are_known_or_of_other_letters_cost_nothing(sentence: str) -> None:
    assert _verdicts(sentence) == [Verdict.PROVED, Verdict.PROVED]
    assert _verdicts(sentence, PAGE.replace("+ l_2", "- l_2", 1)) == [Verdict.REFUTED, Verdict.PROVED]


def test_the_finding_names_the_letter_and_the_words() -> None:
    first = verify_text(PAGE.replace("SENTENCE", OF_LETTER[5]), path=Path("x.md")).equations[0]
    [found] = [each for each in first.findings if each.kind is Kind.STRANGE_LETTER]
    assert found.terms["name"] == "l_2" and found.terms["words"] == "pollivendolo, rubacchiato"
