"""What a sheet says of itself: its language, how many of its equations are proved, and which are not settled."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from armproof.course.words import say
from armproof.models.errors import counted
from armproof.models.language import ENGLISH, use
from armproof.verification.report.html.templating import version_of
from armproof.verification.verdict import Record, Verdict


def proof_line(records: Iterable[Record], lang: str, arm: str) -> str:
    """Return how many equations are proved, and by what; errata are none of them, and none is against Drake without an arm."""
    counts = Counter(_kind(record) for record in records if not record.erratum)
    proved = counts["proved"]
    with use(lang):
        count = counted("{number} equation proved", "{number} equations proved", proved)
        rest = [
            counted("{number} confirmed by computation", "{number} confirmed by computation", counts["confirmed"]),
            counted("{number} not checked", "{number} not checked", counts["unchecked"]),
            counted("{number} not proved", "{number} not proved", counts["failed"]),
        ]
    against = say("against", lang) if arm and proved else ""
    first = f"{count if proved else say('no_equation', lang)}{against}{say('by', lang, version=version_of('armproof'))}"
    kinds = ("confirmed", "unchecked", "failed")
    return ("; " if lang == ENGLISH else "\u00a0; ").join(
        [first, *(text for text, kind in zip(rest, kinds, strict=True) if counts[kind])]
    )


def remark(record: Record | None, lang: str) -> str:
    """Return what is said beside a display of a draft that is not settled; empty for one that is."""
    if record is None:
        return ""
    if record.erratum:
        return "" if record.passes else say("erratum_holds", lang)
    words = {Verdict.REFUTED: "refuted", Verdict.UNREADABLE: "unreadable", Verdict.UNCHECKED: "unchecked_one"}
    return say(words[record.verdict], lang) if record.verdict in words else ""


def _kind(record: Record) -> str:
    return "failed" if record.verdict in (Verdict.REFUTED, Verdict.UNREADABLE) else record.verdict.value
