"""What a sheet says of itself: its language, how many of its equations are proved, and which are not settled."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from armproof.course.errors import PrintError
from armproof.course.words import LANGUAGES, say
from armproof.verification.report.html.templating import version_of
from armproof.verification.verdict import Record, Verdict


def check_language(lang: str) -> str:
    """Return the language of a sheet: fr-FR is fr.

    Raises:
        PrintError: another language than English and French.
    """
    short = lang.strip().lower().replace("_", "-").partition("-")[0]
    if short not in LANGUAGES:
        raise PrintError("no language '{lang}'; a sheet is printed in {languages}", lang=lang, languages=list(LANGUAGES))  # fmt: skip
    return short


def proof_line(records: Iterable[Record], lang: str, arm: str) -> str:
    """Return how many equations are proved, and by what; errata are none of them, and none is against Drake without an arm."""
    counts = Counter(_kind(record) for record in records if not record.erratum)
    proved = counts["proved"]
    key = "no_equation" if not proved else "one_proved" if proved == 1 else "proved"
    against = say("against", lang) if arm and proved else ""
    first = f"{say(key, lang, count=proved)}{against}{say('by', lang, version=version_of('armproof'))}"
    rest = [say(kind, lang, count=counts[kind]) for kind in ("confirmed", "unchecked", "failed") if counts[kind]]
    return "; ".join([first, *rest])


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
