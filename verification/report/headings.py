"""What a document says of itself, its title and its headings, in the language that is spoken, where it has a catalogue."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from pathlib import Path

from armproof.models.language import ENGLISH, spoken
from armproof.verification.verdict import DocumentResult, Record


def sentences_of(path: str | Path) -> Callable[[str], str]:
    """Return what says a sentence of a document in the language that is spoken; without a catalogue as it stands."""
    if spoken() == ENGLISH:
        return str
    from armproof.verification.document.catalogue import translated_sentence, translation_of  # and so all formats

    return partial(translated_sentence, translate=translation_of(Path(path), spoken()))


def with_headings(result: DocumentResult) -> DocumentResult:
    """Return a result with its title and its headings in the language that is spoken."""
    say = sentences_of(result.path)

    def said(records: Iterable[Record]) -> tuple[Record, ...]:
        return tuple(replace(record, section=say(record.section)) for record in records)

    return replace(result, title=say(result.title), equations=said(result.equations), tables=said(result.tables))
