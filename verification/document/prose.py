"""Prose as a translator sees it: formulas, code and the targets of links are {1}, {2}, … and come back as they were."""

from __future__ import annotations

import re
from dataclasses import dataclass

from armproof.verification.patterns import regex

KEPT = regex(
    r"(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`)"  # code
    r"|\$\$.+?\$\$|(?<!\\)\$(?:\\.|[^$\\])+\$"  # formulas
    r"|(?<=\]\()[^()\s]+(?=\))|<(?:https?:|mailto:)[^>\s]*>|https?://[^\s)>]+"  # where a link leads
    r"|<!--.*?-->|\{\d+\}",  # what would be taken for a placeholder
    re.DOTALL,
)
_PLACE = regex(r"\{(\d+)\}")
_WORD = regex(r"(?<![\w\\])[^\W\d_]{2,}(?!\w)")


@dataclass(frozen=True)
class Prose:
    """A piece of prose: `text` with placeholders, and what stands for each of them."""

    text: str
    kept: tuple[str, ...] = ()

    @property
    def has_words(self) -> bool:
        """Whether there is anything to translate."""
        return _WORD.search(_PLACE.sub("", self.text)) is not None

    def filled(self, translation: str) -> str:
        """Return a translation with what stands for its placeholders."""
        return _PLACE.sub(lambda found: self.kept[int(found[1]) - 1], translation)


def read_prose(source: str) -> Prose:
    """Return a piece of prose with placeholders; its lines are one."""
    kept: list[str] = []

    def put(found: re.Match[str]) -> str:
        kept.append(found[0])
        return f"{{{len(kept)}}}"

    text = KEPT.sub(put, " ".join(source.split()))
    return Prose(text, tuple(kept))
