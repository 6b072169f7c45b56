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
    found = check(_turned(outcome.nodes))
    return OTHER if found and all(each.verdict in HOLDS for each in found) else ""


def as_told(outcome: Outcome, check: Callable[[n.Chain], Sequence[Outcome]]) -> Outcome | None:
    """Return an equation that does not hold as it is read, and does with x before y, as the text says; None of another."""
    if outcome.verdict is not Verdict.REFUTED or len(outcome.nodes) != len(("left", "right")):
        return None
    found = check(_turned(outcome.nodes))
    holds = len(found) == 1 and found[0].verdict in HOLDS
    return replace(found[0], equation=outcome.equation, uses=outcome.uses) if holds else None


def _turned(nodes: Sequence[n.Node]) -> n.Chain:
    """Return an equation with the arguments of each atan2 in the other order."""
    calls = [each for node in nodes for each in n.walk(node) if n.is_call(each, "atan2") and len(each.arguments) == 2]
    turned: dict[int, n.Node] = {id(each): replace(each, arguments=each.arguments[::-1]) for each in calls}
    one, other = (n.substitute_each(node, turned) for node in nodes)
    return n.Chain((one, other), ("=",))


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
