"""What the records of verdicts leave out of documents, on record: findings of tables, what a display rests on, counterexamples, corrections.

Much of that decides another verdict in some document, and words that people read in all.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.check import verify_text
from armproof.verification.verdict import DocumentResult, EquationResult, Record
from tests.labelled import bare
from tests.labelled.judging import said_of_finding
from tests.labelled.pages import HEAD, load_pages
from tests.reached.documents import Reached, Text
from tests.reached.search import of_tests

RECORD = Path(__file__).parent / "in_full.txt"
HEADER = "# What is said of documents in full; see in_full.py. Written by `python -m tests.reached --update`.\n"
FORMAT = "md"


@lru_cache
def load() -> Mapping[str, Text]:
    """Return the documents without front matter, the labelled pages, and the documents of the tests, by their names."""
    known = [Text(each.text(), each.path.suffix.removeprefix(".") or FORMAT) for each in bare.load()]
    known += [*(Text(page.text) for page in load_pages()), *of_tests()]
    return {Reached(document, "").name: document for document in known}


def said_in_full(document: Text) -> str:
    """Return what is said of a document besides what its record has, a line each."""
    try:
        result = verify_text(document.text, document.format)
    except ArmproofError as error:
        return f"{type(error).__name__}\n"
    return "".join(f"{line}\n" for line in _lines(result))


def _lines(result: DocumentResult) -> Iterator[str]:
    for record in result.records:
        told = [*_of_record(record), *(told for each in record.outcomes for told in _of_equation(each))]
        if told:
            yield " ".join(f"{record.line} {' | '.join(told)}".split())


def _of_record(record: Record) -> Iterator[str]:
    of_outcomes = [finding for each in record.outcomes for finding in each.findings]
    yield from (said_of_finding(each) for each in record.findings if each not in of_outcomes)
    yield from (f"by {said_of_finding(each.finding)}" for each in record.entries if each.finding is not None)
    if record.counterexample:
        yield "at " + ", ".join(f"{name} {value:.3g}" for name, value in sorted(record.counterexample.items()))
    yield from (f"write {each.text} at {each.start}" for each in record.corrections or ())
    if record.if_shown is not None:
        yield f"if shown {record.if_shown.record.verdict.value}"


def _of_equation(result: EquationResult) -> Iterator[str]:
    if result.samples:
        yield f"{result.samples} samples"
    for name in ("defines", "uses", "may_slip"):
        if found := getattr(result, name):
            yield f"{name} {', '.join(f'{key} {line}' for key, line in sorted(found))}"
    for name in ("links", "alone", "usual", "explained_by"):
        if found := getattr(result, name):
            yield f"{name} {', '.join(map(str, sorted(found)))}"
    if result.order:
        yield result.order


@lru_cache
def read_record() -> Mapping[str, str]:
    """Return what is said of each document in full, by its name."""
    _, *parts = HEAD.split(RECORD.read_text("utf-8"))
    return dict(zip(parts[::2], parts[1::2], strict=True))


def write_record() -> None:
    """Write the record anew."""
    RECORD.write_text(HEADER + "".join(f"===== {name}\n{said_in_full(text)}" for name, text in load().items()), "utf-8")
    read_record.cache_clear()


def is_said_as_ever(name: str) -> bool:
    """Whether of a document is said what is on record; asked again where not: the clock may have cut a search short."""
    return any(said_in_full(load()[name]) == read_record().get(name) for _ in range(2))
