"""What a page says of a record: its verdict in one word, with a sign that tells it without colour."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

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
        State("erratum", "†", "erratum, refuted"),
    )
}


def state_of(record: Record) -> State:
    """Return the state of a record; an erratum that is not refuted does not pass, whatever else it is."""
    if record.erratum and record.passes:
        return STATES["erratum"]
    if record.erratum and record.verdict not in (Verdict.UNREADABLE, Verdict.UNCHECKED):
        return State("refuted", "✗", f"erratum, but {record.verdict.value}")
    return STATES[record.verdict.value]


def count_states(records: Iterable[Record]) -> dict[str, int]:
    """Count records by the keys of their states, in the order of STATES."""
    counts = Counter(state_of(record).key for record in records)
    return {key: counts[key] for key in STATES if counts[key]}


def records_of(results: Sequence[DocumentResult]) -> list[Record]:
    """Return all that has a verdict."""
    return [record for result in results for record in result.records]


def counted(number: int, noun: str) -> str:
    """Return "1 equation" or "3 equations"; "1 erratum" or "3 errata"."""
    plural = {"erratum": "errata"}.get(noun, f"{noun}s")
    return f"{number:,} {noun if number == 1 else plural}"


def answer(counts: dict[str, int], documents: int = 0) -> str:
    """Return the answer in a sentence: how many are proved, and what there is to correct."""
    total = sum(counts.values()) - counts.get("erratum", 0)
    where = f" in {counted(documents, 'document')}" if documents else ""
    sure = [f"{counts[key]:,} {word}" for key, word in _SURE if counts.get(key)]
    said = f"{counted(total, 'equation')}{where}: {', '.join(sure) or 'none decided'}."
    wrong = counts.get("refuted", 0)
    return f"{said} {counted(wrong, 'equation')} to correct." if wrong else f"{said} Nothing to correct."


_SURE = (
    ("proved", "proved"),
    ("confirmed", "confirmed"),
    ("defined", "give a name its meaning"),
    ("refuted", "refuted"),
    ("unchecked", "unchecked"),
    ("unreadable", "unreadable"),
)
