"""The wrong entries of which the words on an answer say nothing: a student shall not take them for right."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from armproof.course.feedback.outcome import MOST_PLACES, Feedback, Outcome, place
from armproof.course.feedback.relation import by_places
from armproof.models.errors import counted
from armproof.models.language import look_up

_PLACE = re.compile(r"\(\d+, \d+\)")
_CLAUSES = re.compile(r"\s*;\s")
_MORE = "), …"  # behind places that are not all of them


def has_place(words: str) -> bool:
    """Whether a sentence names an entry by its place."""
    return _PLACE.search(words) is not None


def told_of_the_rest(feedback: Feedback, shape: tuple[int, ...], relation: Callable[[np.ndarray], str]) -> Feedback:
    """Return feedback that says of the wrong entries too of which it says nothing yet how they relate to what is asked.

    Args:
        shape: of what is asked.
        relation: what is said of some entries, all others being right.
    """
    left = _left(feedback)
    if not left:
        return feedback
    places = [(row + 1, column + 1) for row in range(shape[0]) for column in range(shape[1])]
    words = relation(np.array([place(*at) in left for at in places]).reshape(shape))
    if words and not has_place(words):
        words = by_places({(row - 1, column - 1): words for row, column in places if place(row, column) in left})
    return replace(feedback, message=feedback.message + look_up("; ") + words) if words else feedback


def with_the_rest(feedback: Feedback) -> Feedback:
    """Return feedback that names some wrong entries with the others named too."""
    left = _left(feedback)
    if not left:
        return feedback
    if len(left) > MOST_PLACES:
        rest = counted("{number} more entry is wrong", "{number} more entries are wrong", len(left))
    else:
        places = ", ".join(left)
        rest = counted("entry {places} is wrong too", "entries {places} are wrong too", len(left), places=places)
    return replace(feedback, message=feedback.message + look_up("; ") + rest)


def _left(feedback: Feedback) -> list[str]:
    """Return the places of wrong entries that words on others leave out; a place behind a colon is what the words speak of."""
    named = [found for clause in _CLAUSES.split(feedback.message) for found in _PLACE.findall(clause.partition(":")[0])]
    if feedback.outcome is not Outcome.WRONG or not (feedback.findings and named) or _MORE in feedback.message:
        return []
    return [row.entry for row in feedback.rows if row.entry not in named]
