"""The documents that were found, each with what we say of it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.check import verify_text
from tests.labelled.judging import said_of_document
from tests.labelled.pages import HEAD

HERE = Path(__file__).parent / "documents.txt"
MARKDOWN = "md"
HEADER = (
    "# Documents found by search, each with what we say of it; see search.py. Written by `python -m tests.reached`.\n"
)


@dataclass(frozen=True)
class Text:
    """The text of a document, and its format."""

    text: str
    format: str = MARKDOWN

    @property
    def can_stand(self) -> bool:
        """Whether it can stand in the file, between its headings."""
        return self.text.endswith("\n") and "\r" not in self.text and HEAD.search(self.text) is None

    def said(self) -> str:
        """Return what we say of it, or why it cannot be checked."""
        try:
            return said_of_document(verify_text(self.text, self.format))
        except ArmproofError as error:
            return " ".join(f"{type(error).__name__}: {error}".split()) + "\n"


@dataclass(frozen=True)
class Reached:
    """A document, and what is on record of it."""

    document: Text
    said: str

    @property
    def name(self) -> str:
        """A short name that does not change when others come or go, with the format of what is no Markdown."""
        name = hashlib.sha1(self.document.text.encode(), usedforsecurity=False).hexdigest()[:8]
        return name if self.document.format == MARKDOWN else f"{name} {self.document.format}"

    @property
    def is_said_as_ever(self) -> bool:
        """Whether we say of it what is on record; asked again where not: the clock may have cut a search short."""
        return any(self.document.said() == self.said for _ in range(2))


@lru_cache
def load() -> tuple[Reached, ...]:
    """Return the documents in their order."""
    _, *parts = HEAD.split(HERE.read_text("utf-8"))
    named = zip(parts[::4], parts[1::4], parts[3::4], strict=True)
    return tuple(Reached(Text(text, name.partition(" ")[2] or MARKDOWN), said) for name, text, said in named)


def write(documents: Iterable[Reached]) -> None:
    """Write them anew."""
    HERE.write_text(HEADER + "".join(_sections(documents)), "utf-8")
    load.cache_clear()


def _sections(documents: Iterable[Reached]) -> Iterator[str]:
    for each in documents:
        yield f"===== {each.name}\n{each.document.text}===== said of {each.name}\n{each.said}"
