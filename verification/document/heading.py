"""Headings as a tree: what is said under one holds under those below it, and not under its siblings."""

from __future__ import annotations

from armproof.verification.patterns import regex

RULE = regex(r"([=\-`:'\"~^_*+#<>.])\1{2,}\s*$")


class Heading(str):
    """The text of a heading, which knows the headings that it stands under, the outermost first.

    "Solution" under one exercise is another section than "Solution" under the next.
    """

    level: float
    around: tuple[Heading, ...]

    def __new__(cls, text: str, level: float, around: tuple[Heading, ...] = ()) -> Heading:
        """Make a heading of a rank, the smaller the higher."""
        heading = super().__new__(cls, text)
        heading.level, heading.around = level, around
        return heading

    def __eq__(self, other: object) -> bool:
        """Whether another is the same text, under the same headings where it knows its own."""
        return str.__eq__(self, other) is True and (not isinstance(other, Heading) or self.around == other.around)

    def __ne__(self, other: object) -> bool:
        """Whether another is not the same."""
        return not self == other

    __hash__ = str.__hash__

    def __getnewargs__(self) -> tuple[str, float, tuple[Heading, ...]]:  # type: ignore[override]
        return str(self), self.level, self.around


def begin_section(before: str, text: str, level: float) -> Heading:
    """Return the heading that follows another section: those of it that are of a higher rank stand around it."""
    open_ones = (*before.around, before) if isinstance(before, Heading) else ()
    return Heading(text, level, tuple(each for each in open_ones if each.level < level))


def is_ruled(line: str, below: str) -> bool:
    """Whether a line is a heading by the rule that stands below it."""
    return bool(line.strip()) and not line[0].isspace() and bool(RULE.match(below)) and not RULE.match(line)


def encloses(outer: str, inner: str) -> bool:
    """Whether what is said in one section holds in another: the same one, one around it, or the document's head."""
    return outer in ("", inner) or outer in sections_around(inner)


def sections_around(section: str) -> tuple[str, ...]:
    """Return the sections around one, the innermost first."""
    return tuple(reversed(section.around)) if isinstance(section, Heading) else ()
