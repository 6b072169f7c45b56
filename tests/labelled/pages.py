"""Whole pages: attacks with their true twins, and pages as strangers write them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache

from armproof.verification.document.formats import parse_document
from armproof.verification.verdict import DocumentResult
from tests.labelled.cases import FALSE_PASS, FALSE_REFUTATION, HERE, PASSES
from tests.labelled.judging import PAGE, verify_text

MARK = re.compile("«([^¦»]*)¦([^»]*)»")
HEAD = re.compile(r"^=====[ ]*(.+)\n", re.MULTILINE)
STRICT = "passes --strict"


@dataclass(frozen=True)
class Page:
    """A page, and the page that it must be told from: for an attack its true twin."""

    name: str
    text: str
    kind: str  # attack, twin or stranger
    twin: str = ""

    @cached_property
    def false(self) -> frozenset[str]:
        """The displays of an attack that its true twin does not hold."""
        mine, true = ({_said(d.latex) for d in parse_document(PAGE, text).displays} for text in (self.text, self.twin))
        return frozenset(mine - true) if self.kind == "attack" else frozenset()

    @property
    def title(self) -> str:
        """Its name with its kind."""
        return f"{self.name} ({self.kind})"

    @cached_property
    def result(self) -> DocumentResult:
        """Our verdicts on it."""
        return verify_text(self.text)

    def faults(self) -> Iterator[tuple[str, str, str]]:
        """Yield the faults of our verdicts on the page: the kind of fault, the display and our message."""
        try:
            result = self.result
        except Exception as error:
            yield "error", "", f"{type(error).__name__}: {error}"
            return
        for record in result.equations:
            said = _said(record.latex)
            if self.kind == "attack" and said in self.false and record.verdict.value in PASSES:
                yield FALSE_PASS, said, f"{record.verdict}: {record.message}"
            if self.kind != "attack" and record.verdict.value == "refuted":
                yield FALSE_REFUTATION, said, record.message
            if self.kind == "stranger" and record.verdict.value == "unreadable":
                yield "unread", said, record.message
        if self.kind == "attack" and result.passed_strictly():
            yield STRICT, "", ""


def _said(latex: str) -> str:
    return " ".join(latex.split())


@lru_cache
def load_pages() -> tuple[Page, ...]:
    """Return the pages of the two files: each attack, its true twin, and the strangers'."""
    pages = []
    for name, text in _sections("attacks.txt"):
        true, false = (MARK.sub(lambda match, side=side: match[side], text) for side in (1, 2))  # type: ignore[misc]
        pages += [Page(name, false, "attack", true), Page(name, true, "twin")]
    return (*pages, *(Page(name, text, "stranger") for name, text in _sections("strangers.txt")))


def _sections(file: str) -> Iterator[tuple[str, str]]:
    _, *parts = HEAD.split((HERE / file).read_text("utf-8"))
    yield from zip(parts[::2], (text.lstrip("\n") for text in parts[1::2]), strict=True)
