r"""The numbers of a document's equations, and the references to them.

All displays are counted, those of solutions too, so that an equation has one number in every edition and language. What is
not counted: an erratum, which nobody is to quote, and a display with a number of its author's own, `\tag{3'}`.

A reference is `\ref{label}` or `\eqref{label}` (LaTeX, Jupyter), `@eq-label` (Quarto), or ``{eq}`label` `` (MyST); the label
stands in the display (`\label{…}`), behind it (`$$ {#eq-label}`, `$$ (label)`) or is an option of its directive (`:label: …`).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import count

from armproof.course.sheet.body import Body
from armproof.verification.verdict import Record

_TAG = re.compile(r"\\tag\*?\s*\{([^{}$\\]{1,20})\}")
_INSIDE = re.compile(r"\\label\s*\{([^{}]*)\}")
_BESIDE = re.compile(
    r"\$\$[ \t]*(?:\{#(eq-[\w:.-]+)[^\n]*\}|\(([\w:.-]+)\))[ \t]*$|^[ \t>]*:(?:label|name):[ \t]*(\S+)", re.MULTILINE
)
_REFERENCE = re.compile(
    r"\$\$.*?\$\$|\\begin\s*\{(?P<name>\w+\*?)\}.*?\\end\s*\{(?P=name)\}|^(?P<fence>`{3,}).*?^(?P=fence)"  # left as they are
    r"|\\(?:eq)?ref\s*\{(?P<latex>[^{}]*)\}|(?<![\w@])@(?P<quarto>eq-\w(?:[\w:.-]*\w)?)|\{eq\}`(?P<myst>[^`<>]+)`",
    re.MULTILINE | re.DOTALL,
)


@dataclass(frozen=True)
class Numbers:
    """The number of each display in its order (empty: none), and that of each label."""

    of_displays: tuple[str, ...] = ()
    of_labels: dict[str, str] = field(default_factory=dict)

    def referred(self, text: str) -> str:
        """Return Markdown with the numbers in place of the references to them; one that leads nowhere stays as it is."""
        return _REFERENCE.sub(self._number, text)

    def _number(self, found: re.Match[str]) -> str:
        label = found["latex"] or found["quarto"] or found["myst"] or ""
        number = self.of_labels.get(label.strip())
        return found[0] if number is None else number if found[0].startswith("\\ref") else f"({number})"


def tag_of(record: Record) -> str:
    """Return the number that the author gave a display; empty: none."""
    found = _TAG.search(record.latex)
    return found.group(1).strip() if found else ""


def number_equations(records: Sequence[Record], bodies: Sequence[Body]) -> Numbers:
    """Return the numbers of a document's displays; `bodies` are its texts."""
    own = [tag_of(record) for record in records]
    free = (str(number) for number in count(1) if str(number) not in own)
    numbers = tuple(tag or ("" if record.erratum else next(free)) for tag, record in zip(own, records, strict=True))
    labels = {
        label.strip(): number
        for record, number in zip(records, numbers, strict=True)
        for label in _INSIDE.findall(record.latex)
    }
    for body in bodies:
        for found in _BESIDE.finditer(body.text):
            line = body.line(body.text.count("\n", 0, found.start()))
            above = [k for k, record in enumerate(records) if record.cell == body.cell and record.line <= line]
            if above:
                labels[next(filter(None, found.groups()))] = numbers[above[-1]]
    return Numbers(numbers, {label: number for label, number in labels.items() if number})
