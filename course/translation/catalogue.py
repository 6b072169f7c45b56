"""Catalogues of gettext, one a document: read, brought up to date with their source, and what they lack."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.course.translation.prose import Prose, misplaced
from armproof.verification.running.atomic import write_atomically

if TYPE_CHECKING:
    from babel.messages.catalog import Catalog

_HEAD = 'msgid ""\nmsgstr ""\n"Language: {lang}\\n"\n"Content-Type: text/plain; charset=utf-8\\n"\n"Content-Transfer-Encoding: 8bit\\n"\n\n'


def catalogue_file(document: Path, lang: str) -> Path:
    """Return the catalogue of a document: `translations/` stands beside the document's folder."""
    return document.resolve().parents[1] / "translations" / lang / f"{document.stem}.po"


def catalogue_of(document: Path, lang: str) -> Mapping[str, str]:
    """Return what a document's catalogue has of each piece of prose; nothing where there is no catalogue."""
    file = catalogue_file(document, lang)
    return _read(file, file.stat().st_mtime_ns) if file.is_file() else {}


@lru_cache(maxsize=64)
def _read(file: Path, _: int) -> Mapping[str, str]:
    return {str(m.id): str(m.string) for m in read_catalogue(file, "") if m.id and m.string and not m.fuzzy}


def read_catalogue(file: Path, lang: str) -> Catalog:
    """Return a catalogue, fuzzy entries included; an empty one where there is no such file."""
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import read_po

    return read_po(BytesIO(file.read_bytes()), ignore_obsolete=True) if file.is_file() else Catalog(lang or None)


def update(file: Path, lang: str, prose: Iterable[tuple[str, Prose]]) -> Catalog:
    """Bring a catalogue up to date with the prose of its source, each piece with where it stands; entries like new ones become fuzzy."""
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import write_po

    template = Catalog()
    for place, piece in prose:
        kept = [f"{{{number}}} = {text}" for number, text in enumerate(piece.kept, 1)]
        entry = template.add(piece.text, auto_comments=[*([place] if place else []), *kept])
        entry.flags.clear()  # of formats of Python, which these are not
    catalogue = read_catalogue(file, lang)
    catalogue.update(template, update_creation_date=False)
    written = BytesIO(_HEAD.format(lang=lang).encode())
    written.seek(0, 2)
    write_po(written, catalogue, width=0, omit_header=True, ignore_obsolete=True, no_location=True)
    if not file.is_file() or file.read_bytes() != written.getvalue():
        file.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(file, written.getvalue())
    return catalogue


def faults(catalogue: Catalog, prose: Iterable[Prose]) -> Iterator[str]:
    """Yield what is wrong with a catalogue: entries that are missing or fuzzy, and placeholders that do not stand once."""
    for piece in prose:
        entry = catalogue.get(piece.text)
        if entry is None or not entry.string:
            yield f"not translated: {piece.text}"
        elif entry.fuzzy:
            yield f"fuzzy: {piece.text}"
        elif wrong := misplaced(piece.text, str(entry.string)):
            yield f"{', '.join(wrong)} does not stand exactly once: {entry.string}"
