"""What running a cell gave, as HTML: of each output the richest form that is safe to show."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Iterable
from typing import Any

from markupsafe import Markup

from armproof.course.site.cells import Output
from armproof.course.site.cleaning import Shown, clean
from armproof.models.errors import written
from armproof.models.language import look_up

_ANSI = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")
_ADDRESS = re.compile(r"^<[\w.]+(?: object)? at 0x[0-9a-f]+>$|^<[\w.]+ object.*0x[0-9a-f]+.*>$")
_LONGEST = 20_000  # characters of a text


def show_outputs(
    outputs: Iterable[Output], prefix: str, words: str, markdown: Callable[[str], Markup] | None = None
) -> Shown:
    """Return outputs as HTML.

    Args:
        outputs: as a notebook holds them.
        prefix: what makes the ids in them unique on the page.
        words: what a picture without a title is called, for who cannot see it.
        markdown: writes Markdown as HTML.
    """
    parts: list[Markup] = []
    styles: list[str] = []
    for k, output in enumerate(_joined(outputs)):
        if output["output_type"] == "stream":
            parts.append(_text(_string(output["text"])))
            continue
        shown = _data(output.get("data", {}), f"{prefix}{k}-", words, markdown)
        parts.append(shown.html)
        styles += shown.styles
    return Shown(Markup("\n").join(part for part in parts if part), tuple(dict.fromkeys(styles)))


def _joined(outputs: Iterable[Output]) -> list[dict[str, Any]]:
    """Return outputs, the pieces of one stream as one; what went to standard error is left to who runs the lesson."""
    found: list[dict[str, Any]] = []
    for output in outputs:
        if output["output_type"] == "stream":
            if output.get("name") == "stderr":
                continue
            text = _string(output["text"])
            if found and found[-1]["output_type"] == "stream":
                found[-1]["text"] += text
            else:
                found.append({"output_type": "stream", "text": text})
        elif output["output_type"] in ("display_data", "execute_result"):
            found.append(dict(output))
    return found


def _data(data: dict[str, Any], prefix: str, words: str, markdown: Callable[[str], Markup] | None) -> Shown:
    if "text/html" in data:
        cleaned = clean(_string(data["text/html"]), prefix)
        scrolls = (
            Markup(' tabindex="0" role="group" aria-label="{}"').format(look_up("Output"))
            if "<table" in cleaned.html
            else ""
        )
        return Shown(Markup('<div class="rich"{}>{}</div>').format(scrolls, cleaned.html), cleaned.styles)
    if "image/svg+xml" in data:
        svg = _string(data["image/svg+xml"])
        return Shown(_picture("svg+xml", base64.b64encode(svg.encode()).decode(), _title(svg) or words))
    for kind in ("png", "jpeg"):
        if f"image/{kind}" in data:
            return Shown(_picture(kind, "".join(_string(data[f"image/{kind}"]).split()), words))
    if "text/markdown" in data and markdown is not None:
        return Shown(Markup('<div class="rich">{}</div>').format(markdown(_string(data["text/markdown"]))))
    text = _string(data.get("text/plain", ""))
    return Shown(Markup("") if _ADDRESS.match(text.strip()) else _text(text))


def _picture(kind: str, data: str, words: str) -> Markup:
    vector = Markup(' class="vector"') if kind == "svg+xml" else ""
    return Markup(
        '<figure class="picture" tabindex="0" role="group" aria-label="{0}"><img{1} src="data:image/{2};base64,{3}" alt="{0}"></figure>'
    ).format(words, vector, kind, data)


def _title(svg: str) -> str:
    found = re.search(r"<title>([^<]{1,300})</title>", svg) or re.search(r'<svg[^>]*aria-label="([^"]{1,300})"', svg)
    return found.group(1).strip() if found else ""


def _text(text: str) -> Markup:
    plain = _ANSI.sub("", text).strip("\n")
    if not plain.strip():
        return Markup("")
    if len(plain) > _LONGEST:
        more = written("… and {number:,} more characters", number=len(plain) - _LONGEST)
        plain = f"{plain[:_LONGEST]}\n{more}"
    return Markup('<pre class="out" tabindex="0" role="group" aria-label="{}"><samp>{}</samp></pre>').format(
        look_up("Output"), plain
    )


def _string(value: Any) -> str:
    return value if isinstance(value, str) else "".join(value)
