"""A correct value written for a report: in full where a reader could use it, else with an ellipsis."""

from __future__ import annotations

from typing import Any

from armproof.verification.algebra.clock import now
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.algebra.written import write_scalar
from armproof.verification.latex.writer import Notation

WRITTEN = 400  # terms: more are written as an ellipsis
FOLDED = 120  # terms: of so many, products of sines and cosines are written as those of sums of angles where shorter
LONGEST = 2000  # characters of a corrected term; what is longer is no correction that anybody could use


def write_bounded(value: Any, notation: Notation) -> str:
    """Return a value in LaTeX, in the document's notation; at most LONGEST characters of it."""
    if isinstance(value, Scalar):
        terms = _terms_to_write(value)
        if terms > WRITTEN:
            return r"\ldots"
        # folding into sums of angles takes its time, and makes no page of terms readable
        small = terms <= FOLDED and now() < value.ring.deadline
        text = write_scalar(value, notation, folded=small)
    else:
        text = str(value)
    return text if len(text) <= LONGEST else text[:LONGEST].rsplit(" ", 1)[0] + r" \ldots"


def _terms_to_write(value: Scalar) -> int:
    """How many terms a value is written with, those under its roots and in its arc functions included each time."""
    total = 0
    for part in (value.numerator, value.denominator):
        if len(part) > WRITTEN:
            return len(part)
        for powers, _ in value.ring.terms(part):
            total += 1
            for kind, name in powers:
                inner = (
                    [value.ring.radicand(name)] if kind == "radical" else value.ring.arcs[name] if kind == "arc" else ()
                )
                total += sum(_terms_to_write(below) for below in inner)
            if total > WRITTEN:
                return total
    return total
