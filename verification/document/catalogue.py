"""The catalogue of a document: `translations/` stands beside the document's folder, with a folder a language."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from armproof.models.language import catalogue
from armproof.verification.document.prose import read_prose

Translate = Callable[
    [str], str
]  # a piece of prose, with placeholders, to its translation; to itself where there is none


def catalogue_file(document: Path, lang: str) -> Path:
    """Return the catalogue of a document in a language."""
    return document.resolve().parent.parent / "translations" / lang / f"{document.stem}.po"


def translation_of(document: Path, lang: str) -> Translate:
    """Return what translates the prose of a document; without a catalogue all stays as it is."""
    file = catalogue_file(document, lang)
    return catalogue(file).gettext if file.is_file() else str


def translated_sentence(sentence: str, translate: Translate) -> str:
    """Return a sentence, of Markdown on one line, in the language of a catalogue."""
    prose = read_prose(sentence)
    return prose.filled(translate(prose.text)) if prose.has_words else sentence
