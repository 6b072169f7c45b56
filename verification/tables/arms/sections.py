"""The arms that an author names by section: `arms: {Exercise 1: …, Exercise 2: …}`; each section is a part with names of its own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from armproof.verification.document import Display, Document, Table
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say

Place = tuple[int, int]  # cell (0 where there is none) and line
KEYS = ("arm", "symbols", "quantities", "transforms", "tip", "lock", "inverse")
_OF_ALL = ("arms", "inverse")  # what a section has not from the front matter of the whole


def named_sections(document: Document) -> list[tuple[Place, dict[str, Any]]]:
    """Return where each section with an arm of its own begins, in order, with its front matter; raises DocumentError."""
    arms = document.front["arms"]
    if not isinstance(arms, Mapping) or not arms:
        raise document.fault("arms", DocumentError(say(Kind.ARMS_NO_MAPPING, value=repr(arms))))
    headings = list(_headings(document))
    common = {key: value for key, value in document.front.items() if key not in _OF_ALL}
    found = []
    for section, spec in arms.items():
        keys = dict(spec) if isinstance(spec, Mapping) and "arm" in spec else {"arm": spec}
        place = next((place for place, heading in headings if _is_called(heading, str(section))), None)
        if place is None or spec is None or not set(keys) <= set(KEYS):
            names = list(dict.fromkeys(heading for _, heading in headings))
            problem = say(Kind.NO_SECTION, section=str(section), sections=names, keys=list(KEYS))
            raise document.fault("arms", DocumentError(problem))
        found.append((place, {**common, **keys}))
    return sorted(found, key=lambda one: one[0])


def _headings(document: Document) -> Iterator[tuple[Place, str]]:
    """Yield the headings as they stand in the text, then those above displays and tables: in notebooks there are only these."""
    yield from (((0, line), heading) for line, heading in document.headings)
    both: list[Display | Table] = [*document.displays, *document.tables]
    parts = sorted(both, key=lambda one: (one.cell or 0, one.line))
    yield from (((part.cell or 0, part.line), part.section) for part in parts)


def _is_called(heading: str, name: str) -> bool:
    """Whether a heading is a name, or begins with it: "Exercise 2: the SCARA" is called "Exercise 2"."""
    spelt, wanted = (" ".join(text.split()).casefold() for text in (heading, name))
    return spelt == wanted or re.match(re.escape(wanted) + r"(?!\w)", spelt) is not None


def without_arms(document: Document) -> Document:
    """Return a document without its `arms`: what stands before the first of their sections."""
    return replace(document, front={key: value for key, value in document.front.items() if key != "arms"})
