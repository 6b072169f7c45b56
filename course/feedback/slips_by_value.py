"""The one or two slips in a written answer, sought by values: where a proof cannot tell, and where one change alone mends nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain, combinations, islice

import numpy as np

from armproof.course.feedback.claim import ANGLE, Claim
from armproof.course.feedback.outcome import ASKED, MOST_PLACES
from armproof.course.feedback.relation import ENOUGH, Letters, by_places, same, wrong_entries
from armproof.models.errors import written
from armproof.verification.diagnosis.diagnosis import find_cell
from armproof.verification.diagnosis.misconceptions import misconceptions
from armproof.verification.diagnosis.slips import Edit, function_pairs, renamed, sign_pairs, single_edits
from armproof.verification.diagnosis.slips import Letters as Drawn
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.findings.finding import Audience, write
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import symbol_as_latex

Value = Callable[[n.Node], np.ndarray | None]

_FIRST = 60  # changes from which a second one is tried
_EVALUATED = 30_000  # nodes, in all pairs of changes that are tried
_LONGEST = 60  # nodes of an entry in which two slips are sought


def slips_by_value(claim: Claim, latex: str, at: Letters) -> str:
    """Return the slip, or the two slips, after whose mend an answer is what is asked; of each wrong entry of a matrix."""
    node = claim.read(latex)
    true, obtained = claim.values_over(ASKED, at), claim.values_over(latex, at)
    if true.shape != obtained.shape:
        return ""
    value, letters = claim.evaluated_over(at), _letters(claim)
    said: dict[tuple[int, int], str] = {}
    for row, column in _places(true, obtained)[:MOST_PLACES]:
        cell = find_cell(node, row, column) if true[0].size > 1 else node
        found = _slips(cell, true[:, row, column], value, letters) if cell is not None else []
        if found:
            said[row, column] = _words(found)
    return next(iter(said.values()), "") if true[0].size == 1 else by_places(said)


def _places(true: np.ndarray, obtained: np.ndarray) -> list[tuple[int, int]]:
    """Return the entries that differ, or of which no sample tells since the answer has no value where what is asked has one."""
    differs = wrong_entries(true, obtained) | ((np.isfinite(true) & np.isfinite(obtained)).sum(axis=0) < ENOUGH)
    return [(int(row), int(column)) for row, column in np.argwhere(differs)]


def _slips(cell: n.Node, target: np.ndarray, value: Value, letters: Drawn) -> list[Finding]:
    """Return the one finding or the two whose changes give an entry the values that are asked; none where there are no such."""
    first = [edit for edit in islice(_edits(cell, letters), 3 * _FIRST) if not _is_bare(edit.node)]
    if one := next((edit for edit in first if _agrees(edit, target, value)), None):
        return [one.finding]
    if (nodes := sum(1 for _ in n.walk(cell))) > _LONGEST:
        return []
    pairs = ((one, other) for one in first[:_FIRST] for other in _edits(one.node, letters))
    for one, other in islice(pairs, _EVALUATED // nodes):
        if other.finding != one.finding and _agrees(other, target, value):
            return [one.finding, other.finding]
    return []


def _agrees(edit: Edit, target: np.ndarray, value: Value) -> bool:
    found = value(edit.node)
    return found is not None and same(found, target)


def _edits(cell: n.Node, letters: Drawn) -> Iterator[Edit]:
    """Yield the changes of one slip, mistakes of a rule first."""
    return chain(
        misconceptions(cell), _exchanged(cell), single_edits(cell, letters), sign_pairs(cell), function_pairs(cell)
    )


def _exchanged(cell: n.Node) -> Iterator[Edit]:
    """Yield the entry with two of its letters exchanged."""
    names = {name.key: name for name in n.walk(cell) if isinstance(name, n.Name)}
    for one, other in combinations(names.values(), 2):
        changed = renamed(cell, {one.key: other, other.key: one})
        yield Edit(changed, "length", say(Kind.SWAPPED_LENGTHS, one=one.text or one.key, other=other.text or other.key))


def _is_bare(node: n.Node) -> bool:
    """Whether nothing but a letter or a number is left of an entry, from which two changes make anything."""
    return isinstance(node, n.Name | n.Number)


def _words(findings: list[Finding]) -> str:
    one, *others = (write(finding, Audience.STUDENT) for finding in findings)
    return written("two slips: {one}; {other}", one=one, other=others[0]) if others else one


def _letters(claim: Claim) -> Drawn:
    """Return the letters that a slip may have confused: those of the task, angles apart."""
    nodes = [claim.read(symbol_as_latex(key)) for key in claim.letters]
    names = [node for node in nodes if isinstance(node, n.Name)]
    angles = tuple(name for name in names if ANGLE.match(name.key))
    joints = tuple(sorted(int(name.sub) for name in angles if name.sub.isdigit()))
    return Drawn(joints, angles, tuple(name for name in names if name not in angles))
