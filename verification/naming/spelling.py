"""How a document spells: which letters it tells apart, and what a comma between digits is."""

from __future__ import annotations

import re

from armproof.verification.document import Document
from armproof.verification.latex.greek import VARIANTS
from armproof.verification.latex.tokens import Spelling


def spelling_of(document: Document, words: frozenset[str]) -> Spelling:
    """Return how a document spells: φ and ϕ are two letters where it uses both, a decimal comma is French or used before."""
    text = "\n".join(display.latex for display in document.displays)
    found = set(re.findall(r"\\([A-Za-z]+?)(?![A-Za-z])", text))
    bound = " ".join(str(key) for part in ("symbols", "quantities") for key in document.front.get(part) or ())
    apart = {variant for variant, plain in VARIANTS.items() if {variant, plain} <= found and plain not in bound}
    comma = document.front.get("lang") == "fr" or re.search(r"\d\{,\}\d", text) is not None
    return Spelling(words, frozenset(apart), comma)
