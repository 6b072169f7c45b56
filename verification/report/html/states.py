"""What a page says of a record: its verdict in one word, with a sign that tells it without colour."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from armproof.models.errors import written
from armproof.models.language import look_up, noted
from armproof.verification.verdict import DocumentResult, Record, Verdict


@dataclass(frozen=True)
class State:
    """A verdict as pages show it; an erratum that is refuted, as it must be, is a state of its own."""

    key: str
    sign: str
    word: str


STATES = {
    state.key: state
    for state in (
        State("refuted", "✗", "refuted"),
        State("unreadable", "!", "unreadable"),
        State("unchecked", "?", "unchecked"),
        State("proved", "✓", "proved"),
        State("confirmed", "≈", "confirmed"),
        State("defined", "≔", "defined"),
        State("beyond", "·", "remark"),
        State("accepted", "~", noted("accepted")),
        State("erratum", "†", noted("erratum, refuted")),
    )
}


def state_of(record: Record) -> State:
    """Return the state of a record; an erratum that is not refuted does not pass, whatever else it is."""
    if record.is_accepted:
        return STATES["accepted"]
    if record.erratum and record.passes:
        return STATES["erratum"]
    if record.erratum and record.verdict not in (Verdict.UNREADABLE, Verdict.UNCHECKED):
        return State("refuted", "✗", written("erratum, but {verdict}", verdict=look_up(record.verdict)))
    return STATES["beyond" if record.is_remark else record.verdict.value]


def count_states(records: Iterable[Record]) -> dict[str, int]:
    """Count records by the keys of their states, in the order of STATES."""
    counts = Counter(state_of(record).key for record in records)
    return {key: counts[key] for key in STATES if counts[key]}


def records_of(results: Sequence[DocumentResult]) -> list[Record]:
    """Return all that has a verdict."""
    return [record for result in results for record in result.records]
