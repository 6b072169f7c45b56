"""The documents that were found, each with what we say of it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from armproof.verification.check import verify_text
from tests.labelled.judging import said_of_document
from tests.labelled.pages import HEAD

HERE = Path(__file__).parent / "documents.txt"
HEADER = (
    "# Documents found by search, each with what we say of it; see search.py. Written by `python -m tests.reached`.\n"
)


@dataclass(frozen=True)
class Reached:
    """A document, and what is on record of it."""

    text: str
    said: str

    @property
    def name(self) -> str:
        """A short name that does not change when others come or go."""
        return hashlib.sha1(self.text.encode(), usedforsecurity=False).hexdigest()[:8]

    @property
    def is_said_as_ever(self) -> bool:
        """Whether we say of it what is on record."""
        return said_of(self.text) == self.said


def can_stand(text: str) -> bool:
    """Whether a document can stand in the file, between its headings."""
    return text.endswith("\n") and "\r" not in text and HEAD.search(text) is None


def said_of(text: str) -> str:
    """Return what we say of a document; an exception of its front matter in words."""
    try:
        return said_of_document(verify_text(text))
    except Exception as error:
        return f"{type(error).__name__}\n"


@lru_cache
def load() -> tuple[Reached, ...]:
    """Return the documents in their order."""
    _, *parts = HEAD.split(HERE.read_text("utf-8"))
    return tuple(Reached(text, said) for text, said in zip(parts[1::4], parts[3::4], strict=True))


def write(documents: Iterable[Reached]) -> None:
    """Write them anew."""
    HERE.write_text(HEADER + "".join(_sections(documents)), "utf-8")
    load.cache_clear()


def _sections(documents: Iterable[Reached]) -> Iterator[str]:
    for document in documents:
        yield f"===== {document.name}\n{document.text}===== said of {document.name}\n{document.said}"
