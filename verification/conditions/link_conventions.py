"""The convention that a text names beside a link matrix of any joint, and the one by which it holds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.document.sentences import quoted
from armproof.verification.document.told_convention import CONVENTION
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.verdict import HOLDS


def unless_of_other_convention(outcome: Outcome, told: Sequence[str]) -> Outcome:
    """Leave open a link matrix that is one by a convention of which its section does not speak, while it names the other."""
    shown = [str(each.terms["convention"]) for each in outcome.findings if each.kind is Kind.LINK_MATRIX]
    facts = [(fact, text) for fact, _, text in (each.partition("\n") for each in told) if fact.startswith(CONVENTION)]
    if not shown or not facts or outcome.verdict not in HOLDS or f"{CONVENTION} {shown[0]}" in dict(facts):
        return outcome
    text = quoted(facts[-1][1])
    return replace(outcome.left_open(say(Kind.OTHER_CONVENTION_TOLD, convention=shown[0], text=text)), defines=())
