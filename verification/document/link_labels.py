"""Where the label of a link or an image ends: as markdown-it finds it, each bracket looked at once, so that no text takes minutes."""

from __future__ import annotations

from types import SimpleNamespace

from markdown_it import MarkdownIt, helpers
from markdown_it.rules_inline import StateInline

# opening bracket and end of the text → closing one, and whether a link stands between
Ends = dict[tuple[int, int], tuple[int, bool]]
NOWHERE = -1
UNKNOWN = (None, False)


def with_quick_labels(reader: MarkdownIt) -> MarkdownIt:
    """Return a reader that looks for the end of each label once, the reader itself."""
    quick = SimpleNamespace(**{name: getattr(helpers, name) for name in helpers.__all__})
    quick.parseLinkLabel = end_of_label
    reader.helpers = quick  # type: ignore[assignment]
    return reader


def end_of_label(state: StateInline, start: int, disableNested: bool = False) -> int:
    """Return the place of the bracket that closes a label, -1 where none does, or where a link stands in one that may hold none."""
    known: Ends = state.__dict__.setdefault("_ends_of_labels", {})
    if (start, state.posMax) not in known:
        before, state.pos = state.pos, start + 1
        _find(state, start, known)
        state.pos = before
    end, has_link = known[start, state.posMax]
    return -1 if has_link and disableNested else end


def _find(state: StateInline, start: int, known: Ends) -> None:
    """Put down where the label ends within which the state stands, and the brackets in it."""
    opened = [(start, False)]
    while opened and state.pos < state.posMax:
        at, mark = state.pos, state.src[state.pos]
        state.md.inline.skipToken(state)
        has_link = mark == "[" and state.pos != at + 1
        if mark == "]":
            start, has_link = opened.pop()
            known[start, state.posMax] = at, has_link
        elif mark == "[" and not has_link:
            end, has_link = known.get((at, state.posMax), UNKNOWN)
            if end == NOWHERE:
                break
            if end is None:
                opened.append((at, False))
            else:
                state.pos = end + 1
        if has_link and opened:
            opened[-1] = (opened[-1][0], True)
    known |= {(each, state.posMax): (NOWHERE, False) for each, _ in opened}
