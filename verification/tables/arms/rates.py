"""Letters that move: those whose rates a document prints."""

from __future__ import annotations

import re
from collections.abc import Iterable

from armproof.verification.document import Display
from armproof.verification.latex.unicode import normalise_unicode

_RATE = re.compile(r"\\d{1,2}ot\s*\{?\s*\\?([A-Za-z]+)\s*\}?(?:\s*_\s*(?:\{\s*(\w+)\s*\}|(\w)))?")


def rates_in(displays: Iterable[Display]) -> set[str]:
    r"""Return the letters, as keys, whose rates stand in displays: d_2 of \dot{d}_2, theta_1 of \dot\theta_1."""
    texts = (normalise_unicode(each.latex) for each in displays if not (each.erratum or each.denied))
    found = (match for text in texts for match in _RATE.findall(text))
    return {f"{base}_{braced or index}" if braced or index else base for base, braced, index in found}
