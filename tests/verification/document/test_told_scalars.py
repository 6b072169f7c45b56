"""Letters that a text calls a length, a weight or a moment are numbers in a document without an arm."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.told_scalars import told_scalars


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("A mast of height $K$ carries a boom of length $B$.", ["size K", "size B"]),
        ("Les longueurs $A$, $B$ et $L_1$ sont connues.", ["size A", "size B", "size L_1"]),
        ("Ein Gewicht $G$ hängt am Haken.", ["size G"]),
        ("$Q$ es la altura de la columna.", ["size Q"]),
        ("La mano ejerce el momento $N$.", ["moment N"]),
        ("The matrix $K$ has full rank.", []),
        ("The length of the boom in frame $K$ is known.", []),
        ("The radius $R$ and the torque $T$ are given.", []),  # rotations and poses, mostly
    ],
)
def test_a_noun_tells_what_letter_is_a_number(sentence: str, told: list[str]) -> None:
    assert [*told_scalars(sentence)] == told


def verdicts_of(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


HOIST = r"""
A crab runs along a rail by $q_1$ and hangs a rope of {noun} $B$ at the angle $\eta$; the rail has the height $K$.

$$ U = q_1 + B\sin\eta $$

$$ V = K - B\cos\eta $$

$$ (U - q_1)^2 + (V - K)^2 = B^2 $$

$$ \dot U = \dot q_1 + {rate} $$
"""


@pytest.mark.parametrize(
    ("noun", "rate", "verdict"),
    [
        ("length", r"B\dot\eta\cos\eta", "proved"),
        ("length", r"B\dot\eta\sin\eta", "refuted"),
        ("matrix", r"B\dot\eta\cos\eta", "unchecked"),
    ],
)
def test_a_told_length_is_a_number_that_stands(noun: str, rate: str, verdict: str) -> None:
    assert verdicts_of(HOIST.format(noun=noun, rate=rate))[-1] == verdict


POINTER = r"$$ k = \begin{pmatrix} \sin\eta\cos\varphi \\ \sin\eta\sin\varphi \\ \cos\eta \end{pmatrix} $$"


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"k_y = \sin\eta\sin\varphi", "proved"),
        (r"k_y = \sin\eta\cos\varphi", "unchecked"),  # no arm tells which of the two is meant
        (r"k_x^2 + k_y^2 = \sin^2\eta", "proved"),
        (r"k_x^2 + k_y^2 = \cos^2\eta", "unchecked"),
        (r"k_x \cos\varphi + k_y \sin\varphi = \sin\eta", "proved"),
        (r"k_x \cos\varphi - k_y \sin\varphi = \sin\eta", "unchecked"),
    ],
)
def test_a_component_is_that_of_the_column_that_is_printed(claim: str, verdict: str) -> None:
    assert verdicts_of(f"{POINTER}\n\n$$ {claim} $$\n")[-1] == verdict


def test_a_column_of_its_own_components_says_nothing_of_them() -> None:
    text = "$$ k = \\begin{pmatrix} k_x \\\\ k_y \\\\ k_z \\end{pmatrix} $$\n\n$$ k_x^2 + k_y^2 = k_x^2 $$\n"
    assert "proved" not in verdicts_of(text)
