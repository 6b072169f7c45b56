"""The link matrix of one convention, where the text of its section names the other."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

CLASSIC = r"{}^{i-1}T_i = Rot(z, \theta_i) \, Trans(z, d_i) \, Trans(x, a_i) \, Rot(x, \alpha_i)"
MODIFIED = r"{}^{i-1}T_i = Rot(x, \alpha_{i-1}) \, Trans(x, a_{i-1}) \, Rot(z, \theta_i) \, Trans(z, d_i)"
SENTENCES = (
    ("We follow the standard Denavit-Hartenberg convention.", CLASSIC, MODIFIED),
    ("With Craig's convention, the step from one frame to the next is", MODIFIED, CLASSIC),
    ("Nous suivons la convention de Khalil.", MODIFIED, CLASSIC),
    ("The modified link matrix, that of Craig, is", MODIFIED, CLASSIC),
)


def verdict(*parts: str) -> Verdict:
    return verify_text("\n\n".join(parts)).equations[-1].verdict


@pytest.mark.parametrize(("sentence", "own", "other"), SENTENCES)
def test_the_other_convention_than_the_one_that_is_named_is_left_open(sentence: str, own: str, other: str) -> None:
    assert verdict(sentence, f"$$ {own} $$") is Verdict.PROVED
    assert verdict(sentence, f"$$ {other} $$") is Verdict.UNCHECKED


@pytest.mark.parametrize("shown", [CLASSIC, MODIFIED])
def test_where_no_convention_or_both_are_named_either_is_meant(shown: str) -> None:
    both = "The convention of Denavit and Hartenberg in its classic form is as old as that of Craig is useful."
    assert verdict("The step is", f"$$ {shown} $$") is Verdict.PROVED
    assert verdict(both, f"$$ {shown} $$") is Verdict.PROVED
    assert (
        verdict("# Craig's convention\n\nBy Craig's convention:", "# The other one", f"$$ {shown} $$") is Verdict.PROVED
    )


def test_the_front_matter_is_no_sentence() -> None:
    rows = "[{a: l_1, alpha: pi/2, d: 0, theta: theta_1}, {a: l_2, alpha: 0, d: 0, theta: theta_2}]"
    assert verdict(f"---\narm: {{dh: classic, rows: {rows}}}\n---", f"$$ {MODIFIED} $$") is Verdict.PROVED
