"""Feedback as HTML for a notebook: one block with its own style, readable in light and dark, by more than colour."""

from __future__ import annotations

import re
from functools import cache
from importlib import resources

from markupsafe import Markup

from armproof.course.feedback.outcome import Feedback, Outcome
from armproof.course.feedback.text import MARKS, MOST_ROWS, configuration, number, pretty, rest
from armproof.verification.report.html.templating import sketch_style

_KINDS = {
    Outcome.PROVED: "right",
    Outcome.CONFIRMED: "right",
    Outcome.NOT_ATTEMPTED: "open",
    Outcome.WRONG: "wrong",
    Outcome.ERROR: "error",
}


def write_html(feedback: Feedback) -> str:
    """Return the feedback as HTML: outcome, sentence, table, picture."""
    kind, mark = _KINDS[feedback.outcome], MARKS[feedback.outcome]
    name = Markup("<code>{}</code>: ").format(feedback.task) if feedback.task else Markup("")
    parts = [
        Markup('<p class="ap-head"><span aria-hidden="true">{}</span> {}<strong>{}</strong></p>').format(
            mark, name, feedback.outcome.value
        )
    ]
    if feedback.message:
        parts.append(Markup("<p>{}</p>").format(_sentence(feedback.message)))
    if feedback.rows:
        parts.append(_table(feedback))
    if feedback.picture is not None:
        parts.append(
            Markup("<figure>{}<figcaption>{}</figcaption></figure>").format(
                feedback.picture.svg, feedback.picture.caption
            )
        )
    parts += [Markup('<p class="ap-note">{}</p>').format(_sentence(note)) for note in feedback.notes]
    if feedback.error is not None and feedback.error.source:
        parts.append(
            Markup('<p class="ap-note">line {}: <code>{}</code></p>').format(feedback.error.line, feedback.error.source)
        )
    return str(block(kind, Markup("").join(parts)))


def block(kind: str, content: Markup) -> Markup:
    """Return a block of the given kind (right, wrong, open, error, hint) with its style."""
    return Markup('<style>{}</style><div class="armproof ap-{}">{}</div>').format(Markup(_style()), kind, content)


def _table(feedback: Feedback) -> Markup:
    rows = Markup("").join(
        Markup("<tr><th scope='row'>{}</th><td>{}</td><td>{}</td><td>{}</td></tr>").format(
            row.entry, number(row.expected), number(row.obtained), row.unit
        )
        for row in feedback.rows[:MOST_ROWS]
    )
    where = Markup("<p class='ap-note'>At {}</p>").format(pretty(configuration(feedback))) if feedback.at else ""
    return Markup(
        "{}<table><thead><tr><th scope='col'>entry</th><th scope='col'>expected</th>"
        "<th scope='col'>obtained</th><th scope='col'>unit</th></tr></thead><tbody>{}</tbody></table>{}"
    ).format(
        where, rows, Markup("<p class='ap-note'>{}</p>").format(rest(feedback.rows)) if rest(feedback.rows) else ""
    )


def _sentence(text: str) -> str:
    begins_with_word = re.match(r"[a-z]+(?!\w)", text) is not None  # theta_1 and θ stay as they are
    return pretty(text[:1].upper() + text[1:] if begins_with_word else text)


@cache
def _style() -> str:
    return (
        resources.files("armproof.course.feedback").joinpath("feedback.css").read_text(encoding="utf-8")
        + sketch_style()
    )
