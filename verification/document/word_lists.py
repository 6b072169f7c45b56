"""Words by their classes, as a table in a module has them: a line is a class and its words, and goes on in the next where that begins with a blank; ~ ends a stem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property


def classes_of(lines: str) -> Iterator[tuple[str, list[str]]]:
    """Yield each class of a table with its words and stems."""
    for line in lines.strip().replace("\n ", " ").split("\n"):
        name, *words = line.split()
        yield name, words


class WordLists:
    """The classes of a table, read when the first word is looked up."""

    def __init__(self, lines: str) -> None:
        self._lines = lines

    @cached_property
    def _classes(self) -> dict[str, tuple[frozenset[str], tuple[str, ...]]]:
        """Of each class its whole words and its stems."""
        return {
            name: (frozenset(w for w in words if "~" not in w), tuple(w[:-1] for w in words if w.endswith("~")))
            for name, words in classes_of(self._lines)
        }

    def holds(self, word: str, kind: str) -> bool:
        """Whether a word is of a class, by itself or by a stem that it begins with."""
        whole, stems = self._classes[kind]
        return word in whole or (bool(stems) and word.startswith(stems))

    def has(self, words: Iterable[str], *kinds: str) -> bool:
        """Whether one of some words is of one of some classes."""
        return any(self.holds(word, kind) for word in words for kind in kinds)
