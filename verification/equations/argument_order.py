"""The order of the arguments of atan2: some books write atan2(x, y), and what then holds is refuted by nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import HOLDS, Record, Verdict

USUAL, OTHER = "atan2(y, x)", "atan2(x, y)"


def order_shown(outcome: Outcome, check: Callable[[n.Chain], Sequence[Outcome]]) -> str:
    """Return the order with which an equation holds, by `check` where that is not as it is read; else an empty text."""
    calls = [each for node in outcome.nodes for each in n.walk(node) if isinstance(each, n.Call)]
    calls = [each for each in calls if each.function == "atan2" and len(each.arguments) == 2]
    if not calls or outcome.verdict in HOLDS:
        return USUAL if calls else ""
    turned: dict[int, n.Node] = {id(each): replace(each, arguments=each.arguments[::-1]) for each in calls}
    one, other = (n.substitute_each(node, turned) for node in outcome.nodes)
    found = check(n.Chain((one, other), ("=",)))
    return OTHER if found and all(each.verdict in HOLDS for each in found) else ""


def settle_orders(records: Iterable[Record]) -> tuple[Record, ...]:
    """Return the records of a document; where nothing holds with the usual order, what holds with the other is left open."""
    records = tuple(records)
    if any(each.order == USUAL for record in records for each in record.outcomes):
        return records
    doubt = say(Kind.OTHER_ORDER)
    return tuple(
        record.left_open(doubt, lambda one: one.order == OTHER and one.verdict is Verdict.REFUTED)
        if not record.erratum
        else record
        for record in records
    )
