"""What may stand for a member that is wrong: its mended entries, a small change of its form, the true value itself."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.algebra.matrix import Identity, Matrix, stacked
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.written import write_bounded
from armproof.verification.correction.record import ELLIPSIS
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.writer import Notation
from armproof.verification.patterns import regex
from armproof.verification.verdict import Correction, WrongEntry

IDENTITY = regex(r"(?P<letter>(?:\\math(?:bf|rm|bb)\s*)?\{?\s*(?:I|1)\s*\}?)\s*_\s*(?:\d|\{\d+\})")
Corrections = tuple[Correction, ...]


def alternatives(latex: str, outcome: Outcome, entries: Sequence[WrongEntry]) -> Iterator[Corrections]:
    """Yield what may mend a refuted equation, the smallest change first; places count in the normalised LaTeX."""
    if usable := _of_entries(latex, outcome, entries):
        yield usable
    if outcome.printed is not None and outcome.true is not None:
        yield from _of_form(latex, outcome.printed.node, outcome)
        if outcome.pair is None:
            yield from _other_products(latex, outcome.true.node)
            yield from ((row,) for side in (outcome.printed, outcome.true) if (row := _zeros_too_many(side.node)))


def true_value(latex: str, outcome: Outcome, notation: Notation) -> Iterator[Corrections]:
    """Yield the true value in the place of the whole printed member, if it can be written."""
    if outcome.printed is not None and outcome.true is not None and outcome.true.known:
        text = write_value(latex, outcome.true.value, notation)
        if text is not None:
            yield (Correction(*outcome.printed.node.span, text),)


def write_value(latex: str, value: Value, notation: Notation) -> str | None:
    """Return a value in LaTeX, a matrix in the environment that the display uses; None where it is too long."""
    if isinstance(value, Identity):
        return None
    value = stacked(value)
    if not isinstance(value, Matrix):
        text = write_bounded(value, notation)
        return None if ELLIPSIS in text else text
    rows = [[write_bounded(cell, notation) for cell in row] for row in value.rows]
    if any(ELLIPSIS in cell for row in rows for cell in row):
        return None
    found = re.search(r"\\begin\{([bpv]?matrix)\}", latex)
    environment = found.group(1) if found else "bmatrix"
    body = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{{environment}}} {body} \end{{{environment}}}"


def _of_entries(latex: str, outcome: Outcome, entries: Sequence[WrongEntry]) -> Corrections:
    """Return the wrong entries where they stand, or nothing where one has no place or cannot be written."""
    own = [entry for entry in entries if entry.equation == outcome.equation]
    if outcome.printed is not None and outcome.printed.node.span != (0, 0):
        sides = [node.span for node in outcome.nodes]  # of two formulas the slip may stand in either
        own = [entry for entry in own if entry.span is None or any(_holds(side, entry.span) for side in sides)]
    if any(entry.span is None or not entry.correct or ELLIPSIS in entry.correct for entry in own):
        return ()
    found = {trimmed(latex, Correction(*entry.span, entry.correct)) for entry in own if entry.span is not None}
    return tuple(sorted(found, key=lambda correction: correction.start))


def _holds(outer: tuple[int, int], inner: tuple[int, int]) -> bool:
    return outer[0] <= inner[0] <= inner[1] <= outer[1]


def trimmed(latex: str, correction: Correction) -> Correction:
    """Return a correction whose place neither begins nor ends with a blank."""
    start, end = correction.start, correction.end
    while end > start and latex[end - 1].isspace():
        end -= 1
    while start < end and latex[start].isspace():
        start += 1
    return Correction(start, end, correction.text)


# -- the form of a member ----------------------------------------------------------------------------------------------


def _of_form(latex: str, node: n.Node, outcome: Outcome) -> Iterator[Corrections]:
    """Yield small changes of a member whose size is wrong, or that has no value for the sizes in it."""
    true = outcome.true.value if outcome.true is not None else None
    if outcome.pair is not None or not isinstance(true, Matrix):
        return
    start, end = node.span
    if true.shape[0] == true.shape[1] and (found := IDENTITY.fullmatch(latex, start, end)):
        yield (Correction(start, end, f"{found.group('letter').strip()}_{true.shape[0]}"),)
    yield from _other_products(latex, node)
    if (row := _missing_row(node, outcome)) is not None:
        yield (row,)
    printed = outcome.printed.value if outcome.printed is not None else None
    if isinstance(printed, Matrix) and printed.shape == (true.shape[1], true.shape[0]):
        text = latex[start:end].strip()
        whole = text if isinstance(bare(node), n.Matrix | n.Name) else f"({text})"
        yield (Correction(start, end, f"{whole}^T"),)


def _other_products(latex: str, node: n.Node) -> Iterator[Corrections]:
    r"""Yield a cross product where a dot, or nothing, stands between two factors, and a dot for a cross."""
    for below in n.walk(node):
        if not isinstance(below, n.Product):
            continue
        for k, operator in enumerate(below.operators):
            gap = (below.factors[k].span[1], below.factors[k + 1].span[0])
            mark = r"\cdot" if operator == "×" else r"\times"
            if 0 < gap[0] <= gap[1]:
                yield (Correction(*gap, f" {mark} "),)


def _missing_row(node: n.Node, outcome: Outcome) -> Correction | None:
    r"""The row 0 … 0 1 of a transform, where a matrix [R p] is written without it."""
    node = bare(node)
    true = outcome.true.value if outcome.true is not None else None
    printed = outcome.printed.value if outcome.printed is not None else None
    if not (isinstance(node, n.Matrix) and isinstance(true, Matrix) and true.shape == (4, 4)):
        return None
    if isinstance(printed, Matrix) and printed.shape != (3, 4):
        return None
    *zeros, one = true.rows[3]
    if not (all(cell.is_zero() for cell in zeros) and (one - 1).is_zero()):
        return None
    last = node.rows[-1][-1].span[1]
    return Correction(last, last, r" \\ " + " & ".join(["0"] * (len(node.rows[-1]) - 1) + ["1"]))


def _zeros_too_many(node: n.Node) -> Correction | None:
    """The last row of zeros, where what stands above it has one already: [p 0] of a p with four rows."""
    node = bare(node)
    if not isinstance(node, n.Matrix) or len(node.rows) < 2:
        return None
    last = node.rows[-1]
    if not all(isinstance(cell, n.Number) and cell.value == 0 for cell in last):
        return None
    return Correction(node.rows[-2][-1].span[1], last[-1].span[1], "")
