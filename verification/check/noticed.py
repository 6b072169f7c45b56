"""Definitions that no claim would notice a slip in: Q^T Q = I holds of Q transposed as well, ∂z/∂h = 1 of z = h + s and of z = h - s."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import islice

from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.check.limits import SECONDS_ON_SLIPS, WORK_ON_SLIPS
from armproof.verification.check.slips import Slips
from armproof.verification.equations.alignment import equal_matrices
from armproof.verification.errors import TooComplex
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.settled import Key, rests_through
from armproof.verification.naming.state import Told
from armproof.verification.patterns import regex
from armproof.verification.verdict import HOLDS, EquationResult, Record, Verdict

MOST_SLIPS = 8  # in one definition
_COORDINATE = regex(r"[xyzXYZ](?:_\w+)?")
_TURNED = {"+": "-", "-": "+"}


def settle_noticed(records: Sequence[Record], slips: Slips) -> tuple[Record, ...]:
    """Return the records of a document; a definition is left open where all that use it hold as well with a slip in it, a sign turned or rows for columns."""
    held = [each for each in records if not each.erratum]
    found: dict[Key, bool] = {}
    for result in (one for each in held for one in each.outcomes if _rests_on_use(one)):
        (key,) = result.defines
        with suppress(TooComplex), slips.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
            found[key] = _escapes_all(key, held, slips)
    unseen = {key for key, escapes in found.items() if escapes}
    return tuple(each if each.erratum else _without(each, unseen) for each in records) if unseen else tuple(records)


def _rests_on_use(result: EquationResult) -> bool:
    gives_arm = any(finding.kind is Kind.GIVES_ARM for finding in result.findings)
    return result.verdict is Verdict.DEFINED and len(result.defines) == 1 and not gives_arm


def _escapes_all(key: Key, records: Sequence[Record], slips: Slips) -> bool:
    """Whether there is a slip in a definition with which all holds that holds without it."""
    before = slips.names.state.definitions.get(key[0])
    if before is None or before.line != key[1] or before.node is None:
        return False
    if not (_COORDINATE.fullmatch(key[0]) or _moves(before.node, slips)):
        return False
    _, using = rests_through(key, [each for record in records for each in record.outcomes])
    displays = [each for each in records if any(one in using for one in each.outcomes if one.is_decided)]
    if not displays or any(each.verdict not in HOLDS for each in displays):
        return False  # what is refuted notices it, and of what is open in part nobody knows
    state = slips.names.state
    with state.unchanged():
        state.told, state.configuration, state.given_last = Told(), {}, {}  # at values that are given much is alike
        if not all(slips.holds_where(each, key[0], before) for each in displays):
            return False
        made = (
            replace(before, evaluate=slips.checker.members.meaning(each)) for each in _with_slips(before.node, slips)
        )
        return any(all(slips.holds_where(each, key[0], slip) for each in displays) for slip in made)


def _moves(formula: n.Node, slips: Slips) -> bool:
    """Whether a formula is written in joints, or in angles: one of other letters, u = t/t_f, says what its author calls so, but for a coordinate."""
    joints = slips.names.joints.keys()
    return any(
        isinstance(each, n.JointAngles)
        or n.is_call(each, "cos", "sin", "tan")
        or (isinstance(each, n.Name) and slips.names.known_symbol(each.key) in joints)
        for each in n.walk(formula)
    )


def _with_slips(formula: n.Node, slips: Slips) -> Iterator[n.Node]:
    """Yield a formula with the sign of one term turned, or a matrix transposed, where that is another value."""
    value = slips.checker.member(formula)
    for other in islice(_changed(bare(formula)), MOST_SLIPS):
        changed = slips.checker.member(other)
        if value.known and changed.known and not equal_matrices(as_matrix(value.value), as_matrix(changed.value)):
            yield other


def _changed(formula: n.Node) -> Iterator[n.Node]:
    if isinstance(formula, n.Matrix) and len({len(formula.rows), *map(len, formula.rows)}) == 1:
        yield replace(formula, rows=tuple(zip(*formula.rows, strict=True)))
    for node in n.walk(formula):
        if isinstance(node, n.Sum) and len(node.terms) > 1:
            for place, (sign, term) in enumerate(node.terms):
                if sign in _TURNED:
                    terms = (*node.terms[:place], (_TURNED[sign], term), *node.terms[place + 1 :])
                    yield n.substitute(formula, node, replace(node, terms=terms))


def _without(record: Record, unseen: set[Key]) -> Record:
    if not any(_rests_on_use(each) and each.defines <= unseen for each in record.outcomes):
        return record
    outcomes = (
        _left_open(each) if _rests_on_use(each) and each.defines <= unseen else each for each in record.outcomes
    )
    return record.with_outcomes(tuple(outcomes))


def _left_open(result: EquationResult) -> EquationResult:
    names = sorted(name for name, _ in result.defines)
    return replace(
        result,
        verdict=Verdict.UNCHECKED,
        findings=(*result.findings, say(Kind.NO_WITNESS, names=names).at(result.index)),
    )
