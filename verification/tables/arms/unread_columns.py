"""Columns of a DH table that no parameter stands in, and that may change what the others say: home, zero, sense, ratio, a remark with a number.

What they do to an angle is told in words, if at all: no arm is taken from such a table.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from armproof.verification.document import Table
from armproof.verification.patterns import regex
from armproof.verification.tables.columns import Columns, plain

_HARMLESS = regex(  # bounds, names, and what dynamics or a drawing is about
    r"\b(?:limit\w*|l[ií]mit\w*|ranges?|min\w*|max\w*|bounds?|stops?|butées?|domaines?|domains?|plages?|courses?|strokes?|travel|bereich\w*|grenz\w*|anschl\w*|rangos?|intervall[eio]s?|intervalo?s?|amplitudes?|débattements?|corsa|recorrido"
    r"|types?|kinds?|nature|tipos?|art|variables?|variabel\w*|variabili|names?|noms?|bezeichnung|nombres?|nome|descriptions?|beschreibung|bedeutung|meaning|descripción|descrizione|units?|unités?|einheit\w*|unidad\w*"
    r"|mass\w*|weight\w*|poids|gewicht\w*|masas?|inerti\w*|trägheit\w*|centroid\w*|com|velocit\w*|vitesses?|speeds?|geschwindigkeit\w*|torques?|couples?|drehmoment\w*|colou?rs?|couleurs?|farbe|colores?|figures?|symbols?)\b"
)
_AMENDS = regex(  # words that say that an angle is not what its column says
    r"\b(?:weld\w*|lock\w*|glued?|fixed at|clamp\w*|revers\w*|invert\w*|invers\w*|opposite|negativ\w*|backwards?|flip\w*|coupled|geared|soudée?s?|bloquée?s?|verrouillée?s?|opposée?s?|couplée?s?|gesperrt|verriegelt|umgekehrt|gegensinnig|gekoppelt|soldad[oa]|bloquead[oa]|invertid[oa]|acoplad[oa]|saldat[oa]|bloccat[oa]|accoppiat[oa])\b"
)
_NOTHING = regex(
    r"(?:[-–—/]|0(?:\.0+)?\s*(?:\^?\{?\s*\\?circ\s*\}?|°|deg|rad)?|no|none|non|nein|keine?|aucune?|ninguno?|nessuno?|n/a)?",
    re.IGNORECASE,
)
_NUMBER = r"[-−+]?\s*\d+(?:[.,]\d+)?\s*(?:\^?\{?\s*\\?circ\s*\}?|°|deg|rad|mm|cm|m)?"
_RANGE = regex(  # bounds, whatever the header calls them: 0–170°, ±90°
    rf"[\[(]?\s*(?:(?:±|\\pm)\s*{_NUMBER}|{_NUMBER}\s*(?:[-–—,;]|\.\.+|…|\\l?dots|to|bis|à|a)\s*{_NUMBER})\s*[\])]?"
)
_SAYS_SIZE = regex(r"[\d$\\=+*]|theta|alpha|\bpi\b|[θαπ]")


def unread_column(table: Table, columns: Columns) -> str:
    """Return the header of the first column that may change what the others say, "" without one."""
    read = {columns.alpha, columns.theta, columns.offset, *(column for pair in columns.lengths for column in pair)}
    read |= {columns.first(role) for role in ("label", "sigma", "q")}
    others = (
        (header.text, [row[place] for row in table.rows if place < len(row)])
        for place, header in enumerate(columns.headers)
        if place not in read and (place or header.role) and header.role in ("", "theta")
    )
    return next((text.strip() for text, cells in others if _may_change(text, cells)), "")


def _may_change(header: str, cells: Sequence[str]) -> bool:
    texts = [plain(cell).strip() for cell in cells]
    if any(_AMENDS.search(text.lower()) for text in texts):
        return True
    if _HARMLESS.search(plain(header).lower()) or all(map(_says_nothing, texts)):
        return False
    return any(_SAYS_SIZE.search(cell) for cell, text in zip(cells, texts, strict=True) if not _says_nothing(text))


def _says_nothing(text: str) -> bool:
    return (_NOTHING.fullmatch(text) or _RANGE.fullmatch(text)) is not None
