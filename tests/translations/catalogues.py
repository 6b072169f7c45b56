"""A catalogue of translations: brought up to date with what the sources say, and held against it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from io import BytesIO
from pathlib import Path
from string import Formatter

from babel.messages.catalog import Catalog
from babel.messages.pofile import read_po, write_po

NEVER = datetime(2026, 1, 1, tzinfo=UTC)  # a date of each run would make every catalogue differ


@dataclass(frozen=True)
class Message:
    """What is to be translated.

    Attributes:
        text: the source's words, with {fields} for what is put in.
        place: where it is said, a file; in a lesson, with the cell.
        many: the words for several things, where they have words of their own.
        context: what tells it from equal words that are translated otherwise.
        remarks: what a translator should know: what stands for each field.
    """

    text: str
    place: str
    many: str = ""
    context: str = ""
    remarks: tuple[str, ...] = ()

    @property
    def ids(self) -> str | tuple[str, str]:
        """Its words as gettext identifies them."""
        return (self.text, self.many) if self.many else self.text


def update(path: Path, lang: str, messages: Iterable[Message]) -> list[str]:
    """Bring a catalogue up to date, begin it where there is none; return what is to translate in it.

    What is new stands there empty. What changed keeps its old translation, marked fuzzy: it is not used until a person has
    read it and taken the mark away. What is no longer said is dropped.
    """
    messages = list(messages)
    found = _read(path, lang)
    found.update(_wanted(lang, messages), update_creation_date=False)
    found.obsolete.clear()
    _write(path, found)
    return problems(path, lang, messages)


def problems(path: Path, lang: str, messages: Iterable[Message]) -> list[str]:
    """Return what is wrong with a catalogue: missing, outdated, no longer said, or without the fields of the source."""
    found, wanted = _read(path, lang), _wanted(lang, messages)
    return list(_problems(path, found, wanted))


def entries(path: Path, lang: str) -> Iterator[tuple[tuple[str, ...], tuple[str, ...]]]:
    """Yield each entry of a catalogue that is used: its forms in the source, and those of the translation."""
    for entry in _read(path, lang):
        if entry.id and not entry.fuzzy and all(_forms(entry.string)):
            yield _forms(entry.id), _forms(entry.string)


def fields(text: str) -> Counter[str]:
    """Return the fields of a template with how often each stands there, and the marks of names and formulas."""
    try:
        named = Counter(f"{{{name}:{form}}}" for _, name, form, _ in Formatter().parse(text) if name is not None)
    except ValueError:  # no template: braces of LaTeX
        named = Counter(re.findall(r"\{\w*\}", text))
    return named + Counter({mark: text.count(mark) for mark in "`$" if mark in text})


def _problems(path: Path, found: Catalog, wanted: Catalog) -> Iterator[str]:
    for message in wanted:
        entry = found.get(message.id, message.context) if message.id else None
        if not message.id:
            continue
        told = f"{path.name}: {_forms(message.id)[0]!r} ({', '.join(place for place, _ in message.locations)})"
        if entry is None or not all(_forms(entry.string)):
            yield f"missing: {told}"
        elif entry.fuzzy:
            yield f"outdated (fuzzy): {told}"
        elif lost := sorted(_lost(_forms(message.id), _forms(entry.string))):
            yield f"other fields or marks, {' '.join(lost)}: {told}"
    gone = {(entry.id, entry.context) for entry in found if entry.id} - {(each.id, each.context) for each in wanted}
    yield from (f"no longer said: {path.name}: {_forms(ids)[0]!r}" for ids, _ in sorted(gone, key=str))


def _lost(source: Sequence[str], forms: Sequence[str]) -> set[str]:
    """Return what the last form has more or less of than that of the source; the form for one thing may leave its number out."""
    one, many = fields(source[0]), fields(source[-1])
    lost = set(((many - fields(forms[-1])) + (fields(forms[-1]) - many)).keys())
    for form in forms[:-1]:
        lost |= set(((one - fields(form)) + (fields(form) - (one | many))).keys())
    return lost


def _wanted(lang: str, messages: Iterable[Message]) -> Catalog:
    catalog = _new(lang)
    for message in messages:
        place, told = [(message.place, 0)], message.remarks
        catalog.add(message.ids, locations=place, auto_comments=told, context=message.context or None)
    return catalog


def _new(lang: str) -> Catalog:
    return Catalog(
        lang,
        header_comment="# The words of Armproof in another language: `make translations` keeps this file.",
        project="Armproof",
        version="-",
        last_translator="-",
        language_team="-",
        msgid_bugs_address="-",
        creation_date=NEVER,
        revision_date=NEVER,
        fuzzy=False,
    )


def _read(path: Path, lang: str) -> Catalog:
    if not path.exists():
        return _new(lang)
    with path.open("rb") as file:
        return read_po(file, locale=lang)


def _write(path: Path, catalog: Catalog) -> None:
    written = BytesIO()
    write_po(written, catalog, width=0, include_lineno=False, ignore_obsolete=True)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(re.sub(rb'"Generated-By: .*\n', b"", written.getvalue()))  # names the version of Babel


def _forms(text: str | Sequence[str]) -> tuple[str, ...]:
    return (text,) if isinstance(text, str) else tuple(text)
