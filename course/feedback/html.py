"""What lessons show as HTML in a notebook: blocks with a style of their own, readable in light and dark, by more than colour."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from importlib import resources

from markupsafe import Markup

from armproof.verification.report.html.figures import Figure
from armproof.verification.report.html.sketch import sketch_style


def block(kind: str, *parts: Markup) -> Markup:
    """Return a block of the given kind (right, wrong, open, error, hint) with its style."""
    return Markup('<style>{}</style><div class="armproof ap-{}">{}</div>').format(
        Markup(_style()), kind, Markup("").join(parts)
    )


def small_print(text: str) -> Markup:
    """Return a sentence in small print."""
    return Markup('<p class="ap-note">{}</p>').format(text)


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Markup:
    """Return a table; the first cell of each row is its head."""
    cells = Markup("").join(Markup('<th scope="col">{}</th>').format(name) for name in head)
    lines = Markup("").join(
        Markup('<tr><th scope="row">{}</th>{}</tr>').format(
            first, Markup("").join(Markup("<td>{}</td>").format(cell) for cell in rest)
        )
        for first, *rest in rows
    )
    return Markup("<table><thead><tr>{}</tr></thead><tbody>{}</tbody></table>").format(cells, lines)


def captioned(figure: Figure) -> Markup:
    """Return a picture with its caption."""
    return Markup("<figure>{}<figcaption>{}</figcaption></figure>").format(figure.svg, figure.caption)


@cache
def _style() -> str:
    own = resources.files("armproof.course.feedback").joinpath("feedback.css").read_text(encoding="utf-8")
    return own + sketch_style()
