"""HTML that running a cell gave, made fit for a page: only what shows something is kept, and every element is closed.

The lessons are ours, so this guards against slips: a style is set apart, for the page has one of its own; an id is made
unique; a heading becomes a paragraph, for the headings are the lesson's; scripts, frames, forms and addresses are dropped.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from html.parser import HTMLParser

from markupsafe import Markup, escape

_HTML = """a abbr article b blockquote br caption code col colgroup dd details div dl dt em figcaption figure hr i img kbd li mark
ol p pre s samp section small span strong sub summary sup table tbody td tfoot th thead tr u ul var""".split()
_MATHML = """math mfrac mi mmultiscripts mn mo mover mpadded mphantom mprescripts mroot mrow ms mspace msqrt mstyle msub msubsup
msup mtable mtd mtext mtr munder munderover none""".split()
_SVG = """svg g path line polyline polygon circle ellipse rect text tspan title desc defs marker clippath lineargradient
radialgradient stop""".split()
KEPT = frozenset((*_HTML, *_MATHML, *_SVG))
HEADINGS = frozenset(f"h{level}" for level in range(1, 7))
VOID = frozenset("br col hr img".split())
_DROPPED = frozenset(
    "script iframe object embed template noscript head textarea select button form video audio".split()
)
_ATTRIBUTE = re.compile(
    r"class|role|title|lang|dir|open|tabindex|scope|colspan|rowspan|start|alt|src|href|id|width|height|aria-[a-z]+|"
    r"viewbox|d|points|x[12]?|y[12]?|cx|cy|r[xy]?|dx|dy|transform|fill|stroke|stroke-[a-z]+|fill-[a-z]+|opacity|text-anchor|"
    r"dominant-baseline|font-[a-z]+|marker-[a-z]+|markerwidth|markerheight|markerunits|refx|refy|orient|offset|stop-[a-z]+|"
    r"preserveaspectratio|gradientunits|gradienttransform|clip-path|display|columnalign|stretchy|fence|separator|accent|"
    r"mathvariant|lspace|rspace|minsize|maxsize|symmetric|largeop|movablelimits|linethickness|displaystyle|scriptlevel"
)
_POINTS = ("aria-labelledby", "aria-describedby", "aria-controls")
_PICTURE = re.compile(r"data:image/(?:png|jpeg|gif|webp|svg\+xml);base64,[A-Za-z0-9+/=\s]*")
_URL = re.compile(r"url\(\s*['\"]?(#?)([^'\")]*)['\"]?\s*\)", re.IGNORECASE)


@dataclass(frozen=True)
class Shown:
    """A piece of HTML that may stand on a page, and the styles that it brings along."""

    html: Markup
    styles: tuple[str, ...] = ()


def clean(html: str, prefix: str) -> Shown:
    """Return HTML with nothing in it but text, tables, pictures and formulas; each id begins with the prefix."""
    cleaner = _Cleaner(prefix)
    cleaner.feed(html)
    cleaner.close()
    return Shown(Markup("".join([*cleaner.parts, *(f"</{tag}>" for tag in reversed(cleaner.open))])), cleaner.found)


class _Cleaner(HTMLParser):
    """Writes down what is kept as it is read."""

    def __init__(self, prefix: str) -> None:
        super().__init__(convert_charrefs=True)
        self.prefix = prefix
        self.parts: list[str] = []
        self.open: list[str] = []
        self.found: tuple[str, ...] = ()
        self.hidden: list[str] = []  # elements whose text is not shown

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if self.hidden or tag == "style" or tag in _DROPPED:
            if tag not in VOID and tag not in ("input", "embed"):
                self.hidden.append(tag)
            return
        written = "p" if tag in HEADINGS else tag
        if written not in KEPT:
            return
        extra = ' class="heading"' if tag in HEADINGS else ""
        self.parts.append(f"<{written}{extra}{self._attributes(tag, attrs)}>")
        if written not in VOID:
            self.open.append(written)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if self.hidden or tag == "style" or tag in _DROPPED:
            return
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        if self.hidden:
            if tag in self.hidden:
                del self.hidden[self.hidden.index(tag) :]
            return
        written = "p" if tag in HEADINGS else tag
        if written in self.open:
            while self.open:
                last = self.open.pop()
                self.parts.append(f"</{last}>")
                if last == written:
                    break

    def handle_data(self, data: str) -> None:
        if not self.hidden:
            self.parts.append(str(escape(data)))
        elif self.hidden == ["style"] and data.strip():
            self.found = (*self.found, data.strip())

    def _attributes(self, tag: str, attrs: list[tuple[str, str | None]]) -> str:
        kept: dict[str, str] = {}
        for name, value in attrs:
            if name not in kept and _ATTRIBUTE.fullmatch(name) and not (name == "class" and tag in HEADINGS):
                safe = self._value(name, value or "")
                if safe is not None:
                    kept[name] = safe
        if tag == "img":
            kept.setdefault("alt", "")
        if tag == "pre":  # which scrolls
            kept = {"tabindex": "0", "role": "group", "aria-label": "Output", **kept}
        return "".join(f' {name}="{escape(value)}"' for name, value in kept.items())

    def _value(self, name: str, value: str) -> str | None:
        """Return the value that an attribute keeps; None for one that would lead away from the page."""
        if name == "id":
            return f"{self.prefix}{value}"
        if name in _POINTS:
            return " ".join(f"{self.prefix}{part}" for part in value.split())
        if name == "href":
            return f"#{self.prefix}{value[1:]}" if value.startswith("#") else None
        if name == "src":
            return value if _PICTURE.fullmatch(value) else None
        if "(" in value and (found := _URL.search(value)):
            return f"url(#{self.prefix}{found.group(2)})" if found.group(1) else None
        return value
