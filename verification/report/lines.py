"""Lines of styled text: coloured on a terminal, plain everywhere else, ASCII where nothing else can be written."""

from __future__ import annotations

import locale
import re
import sys
from collections.abc import Iterable
from typing import TextIO
from unicodedata import combining, normalize

from armproof.verification.latex.greek import NAMES

Span = tuple[str, str]  # a text and its style, "" for none
Line = tuple[Span, ...]

_ASCII = {
    **NAMES,
    **dict(zip("×·−–—…≤≥≠≈°′“”‘’∈±²³√", "x * - - - ... <= >= != ~ deg ' \" \" ' ' in +- ^2 ^3 sqrt".split(), strict=True)),
    "⇒": "=>", "⇐": "<=", "⇔": "<=>", "→": "->", "←": "<-",
    "₀": "_0", "₁": "_1", "₂": "_2", "₃": "_3", "₄": "_4", "₅": "_5", "₆": "_6", "₇": "_7", "₈": "_8", "₉": "_9",
}  # fmt: skip


def write_lines(lines: Iterable[Line], stream: TextIO | None = None) -> None:
    """Write styled lines to a stream, by default standard output; never wrapped, so that formulas can be copied."""
    stream = stream or sys.stdout
    if stream.isatty():
        from rich.console import Console
        from rich.text import Text

        console = Console(file=stream, highlight=False, markup=False, emoji=False, soft_wrap=True)
        for line in lines:
            console.print(Text.assemble(*((_printable(text, stream), style) for text, style in line)))
        return
    for line in lines:
        stream.write(_printable("".join(text for text, _ in line), stream) + "\n")


def _printable(text: str, stream: TextIO) -> str:
    """Return a text without control characters (a document may hold any), in the characters that the stream can write."""
    text = re.sub(r"\s+", " ", text) if re.search(r"[\t\n\r\f\v]", text) else text
    text = re.sub(r"[\x00-\x1f\x7f-\x9f]", "?", text)
    return text if _writes_unicode(stream) else to_ascii(text)


def to_ascii(text: str) -> str:
    """Spell a text in ASCII: θ as theta, ⇒ as =>, é as e, and what has no spelling as its code."""
    spelled = "".join(_ASCII.get(character, character) for character in text)
    spelled = "".join(character for character in normalize("NFKD", spelled) if not combining(character))
    return spelled.encode("ascii", "backslashreplace").decode("ascii")


def _writes_unicode(stream: TextIO) -> bool:
    """Whether the stream is meant for Unicode: Python writes UTF-8 in the C locale too, where nobody may read it."""
    encoding = (getattr(stream, "encoding", None) or "ascii").lower().replace("-", "")
    return encoding.startswith("utf") and locale.setlocale(locale.LC_CTYPE) not in ("C", "POSIX")
