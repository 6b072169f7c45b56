"""Feedback as plain text, for a terminal."""

from __future__ import annotations

import re

from armproof.course.feedback.outcome import Feedback, Outcome, Row

MOST_ROWS = 8
_NOTHING = 1e-12
MARKS = {
    Outcome.PROVED: "✓",
    Outcome.CONFIRMED: "✓",
    Outcome.NOT_ATTEMPTED: "○",
    Outcome.WRONG: "✗",
    Outcome.ERROR: "!",
}
_GREEK = {"theta": "θ", "alpha": "α", "beta": "β", "gamma": "γ", "phi": "φ", "psi": "ψ", "omega": "ω"}
_SYMBOL = re.compile(rf"(?<![A-Za-z\\])\\?({'|'.join(_GREEK)}|[A-Za-z])_(?:(\d+)|\{{(\d+)\}})")
_BELOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def write_text(feedback: Feedback) -> str:
    """Return the feedback as lines: outcome and sentence, the configuration, the table."""
    lines = [headline(feedback)]
    if feedback.rows:
        lines += ["", f"    at {configuration(feedback)}" if feedback.at else "", *_table(feedback.rows)]
    lines += [f"    note: {note}" for note in feedback.notes]
    if feedback.error is not None and feedback.error.source:
        lines.append(f"    line {feedback.error.line}: {feedback.error.source}")
    return "\n".join(lines)


def headline(feedback: Feedback) -> str:
    """Return the outcome and the sentence in one line."""
    task = f"{feedback.task}: " if feedback.task else ""
    words = f" – {pretty(feedback.message)}" if feedback.message else ""
    return f"{MARKS[feedback.outcome]} {task}{feedback.outcome.value}{words}"


def pretty(text: str) -> str:
    """Return a text with its symbols as they are printed: theta_1 as θ₁, a_12 as a₁₂, S_{12} as S₁₂."""
    return _SYMBOL.sub(lambda found: _GREEK.get(found[1], found[1]) + (found[2] or found[3]).translate(_BELOW), text)


def configuration(feedback: Feedback) -> str:
    """Return the values of the configuration in words."""
    return pretty(", ".join(f"{name} = {value:.4g}" for name, value in feedback.at.items()))


def number(value: float | str) -> str:
    """Return a number as it is shown: four digits, what rounding left of a zero as 0, or the text as it is."""
    return value if isinstance(value, str) else f"{value if abs(value) > _NOTHING else 0:.4g}"


def rest(rows: tuple[Row, ...]) -> str:
    """Say how many rows are not shown."""
    return f"and {len(rows) - MOST_ROWS} more" if len(rows) > MOST_ROWS else ""


def _table(rows: tuple[Row, ...]) -> list[str]:
    cells = [("entry", "expected", "obtained", "unit")]
    cells += [(row.entry, number(row.expected), number(row.obtained), row.unit) for row in rows[:MOST_ROWS]]
    widths = [max(len(line[k]) for line in cells) for k in range(4)]
    lines = ["    " + "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)) for line in cells]
    return [line.rstrip() for line in lines] + ([f"    {rest(rows)}"] if rest(rows) else [])
