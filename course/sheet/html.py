"""The blocks of a sheet as HTML: mathematics as MathML, pictures inside, no script, nothing from the network."""

from __future__ import annotations

import base64
from collections.abc import Callable, Sequence

from markupsafe import Markup, escape

from armproof.course.sheet import model as s
from armproof.course.sheet.proof import remark
from armproof.course.words import say
from armproof.models.language import look_up, use
from armproof.verification.latex.mathml.display import Line
from armproof.verification.verdict import Record

_TYPES = {".png": "png", ".jpg": "jpeg", ".jpeg": "jpeg", ".gif": "gif", ".svg": "svg+xml", ".webp": "webp"}
_PAGE = 46.0  # em of mathematics on a line of A4
NARROW = 16.0  # and on a phone


class HtmlWriter:
    """Writes the blocks of one sheet; `lang` is the language of the words that it adds."""

    def __init__(self, lang: str = "en") -> None:
        self.lang = lang
        self.blocks: dict[type, Callable[..., Markup]] = {
            s.Heading: self._heading,
            s.Paragraph: lambda block: Markup("<p>{}</p>").format(self.words(block.parts)),
            s.Display: self._display,
            s.Table: self._table,
            s.Listing: self._list,
            s.Quote: self._quote,
            s.Listed: lambda block: Markup("<pre><code>{}</code></pre>").format(block.text.strip("\n")),
            s.Picture: self._picture,
            s.Blank: lambda block: Markup('<div class="blank h{}"></div>').format(_tens(block.height)),
            s.Rule: lambda block: Markup("<hr>"),
        }

    def body(self, blocks: Sequence[s.Block]) -> Markup:
        """Return blocks as HTML."""
        return Markup("\n").join(self.blocks[type(block)](block) for block in blocks)

    # -- blocks -----------------------------------------------------------------------------------------------------

    def _heading(self, block: s.Heading) -> Markup:
        tag = Markup(f"h{min(6, max(2, block.level))}")
        return Markup("<{0}>{1}</{0}>").format(tag, self.words(block.parts))

    def _display(self, block: s.Display) -> Markup:
        return self._tagged(self._formulas(block), f"({block.number})" if block.number else "", block.own)

    def _tagged(self, written: Markup, number: str, own: bool) -> Markup:
        if not number and not own:
            return written
        mark = Markup('<abbr title="{}">†</abbr>').format(say("own", self.lang)) if own else ""
        return Markup('<div class="tagged">{}<span class="tag">{}{}</span></div>').format(written, number, mark)

    def _formulas(self, block: s.Display) -> Markup:
        note = self._note(block.record)
        if not block.lines:
            return Markup('<div class="source-only"><pre><code>{}</code></pre>{}</div>').format(
                block.record.latex.strip("\n"), note
            )
        widest = max((piece.width for line in block.lines for statement in line for piece in statement), default=0.0)
        fit = 100 if widest <= _PAGE else max(40, int(100 * _PAGE / widest) // 5 * 5)
        lines = Markup("").join(_line(line) for line in block.lines)
        written = Markup('<div class="display fit{}">{}{}</div>').format(fit, lines, note)
        with use(self.lang):
            return _focusable(written, look_up("Formula")) if widest > NARROW else written

    def _table(self, block: s.Table) -> Markup:
        def row(tag: str, cells: Sequence[tuple[s.Inline, ...]]) -> Markup:
            aligned = zip(block.columns, cells, strict=False)
            return Markup("<tr>{}</tr>").format(
                Markup("").join(
                    Markup("<{0} class={1}>{2}</{3}>").format(Markup(tag), side, self.words(cell), Markup(tag[:2]))
                    for side, cell in aligned
                )
            )

        rows = Markup("\n").join(row("td", cells) for cells in block.rows)
        written = Markup("<div class=table><table><thead>{}</thead>\n<tbody>{}</tbody></table>{}</div>").format(
            row('th scope="col"', block.header), rows, self._note(block.record)
        )
        with use(self.lang):
            return self._tagged(_focusable(written, look_up("Table")), "", block.own)

    def _note(self, record: Record | None) -> Markup:
        note = remark(record, self.lang)
        return Markup('<p class="note">{}</p>').format(note) if note else Markup("")

    def _list(self, block: s.Listing) -> Markup:
        items = Markup("\n").join(Markup("<li>{}</li>").format(self.body(item)) for item in block.items)
        if block.start is None:
            return Markup("<ul>{}</ul>").format(items)
        return Markup('<ol start="{}">{}</ol>').format(block.start, items)

    def _quote(self, block: s.Quote) -> Markup:
        label = Markup('<p class="label">✗ {}</p>').format(say("erratum", self.lang)) if block.kind == "erratum" else ""
        return Markup('<blockquote class="{}">{}{}</blockquote>').format(block.kind, label, self.body(block.blocks))

    def _picture(self, block: s.Picture) -> Markup:
        data = base64.b64encode(block.path.read_bytes()).decode()
        caption = Markup("<figcaption>{}</figcaption>").format(self.words(block.caption)) if block.caption else ""
        return Markup('<figure><img src="data:image/{};base64,{}" alt="{}">{}</figure>').format(
            _TYPES[block.path.suffix.lower()], data, s.plain(block.caption), caption
        )

    # -- words ------------------------------------------------------------------------------------------------------

    def words(self, parts: Sequence[s.Inline]) -> Markup:
        """Return inline parts as HTML."""
        return Markup("").join(self._part(part) for part in parts)

    def _part(self, part: s.Inline) -> Markup:
        if isinstance(part, s.Text):
            return escape(part.text)
        if isinstance(part, s.Styled):
            tag = Markup("strong" if part.kind == "strong" else "em")
            return Markup("<{0}>{1}</{0}>").format(tag, self.words(part.parts))
        if isinstance(part, s.Code):
            return Markup("<code>{}</code>").format(part.text)
        if isinstance(part, s.Formula):
            return Markup(" ").join(Markup(f"<math>{piece.markup}</math>") for piece in part.pieces)
        if isinstance(part, s.Link):
            return Markup('<a href="{}" rel="noreferrer">{}</a>').format(part.target, self.words(part.parts))
        return Markup("<br>")


def _focusable(block: Markup, label: str) -> Markup:
    """Return a block that may have to scroll, which then has to take the keyboard's focus."""
    return Markup(str(block).replace("<div class=", f'<div tabindex="0" role="group" aria-label="{label}" class=', 1))


def _line(line: Line) -> Markup:
    statements = ["".join(f'<math display="block">{piece.markup}</math>' for piece in statement) for statement in line]
    return Markup(f'<div class="line">{"".join(f"<div>{each}</div>" for each in statements)}</div>')


def _tens(height: float) -> int:
    return min(100, max(10, round(height / 10) * 10))
