"""Sections that speak of none of a document's arm, such as those on the angles of Euler: what is left open there is judged as it is without one."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from armproof.verification.document import Display
from armproof.verification.findings import Kind
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.inference import joints_used
from armproof.verification.tables.arms.settling import Inference
from armproof.verification.verdict import DocumentResult, Record, Verdict

Check = Callable[[Inference], DocumentResult]
_NAME = regex(r"[A-Za-z]+(?:_\w+)?")


def with_armless(part: Inference, result: DocumentResult, check: Check) -> DocumentResult:
    """Return the verdicts of a part whose arm was inferred, those left open in sections that speak of none of it as they are without an arm.

    Where the arm is that of a product of exponentials, whose factors tell the same by their definitions, so are all.
    """
    if part.arm is None:
        return result
    of_screws = part.arm.is_of_screws
    displays = part.document.displays if of_screws else _armless(part)
    places = {each.place for each in displays}
    if not any(_is_open(record) for record in result.equations if record.place in places):
        return result
    front = {key: value for key, value in part.document.front.items() if key not in part.arm.front}
    there = check(Inference(replace(part.document, front=front, displays=displays, tables=())))
    tell = {each.place: each for each in there.equations if each.is_decided or (of_screws and _tells_more(each))}
    return replace(
        result,
        equations=tuple(tell.get(each.place, each) if _is_open(each) else each for each in result.equations),
    )


def _is_open(record: Record) -> bool:
    return record.verdict is Verdict.UNCHECKED and not (record.is_remark or record.erratum)


def _tells_more(record: Record) -> bool:
    """Whether a display gives what is used, or what is printed elsewhere speaks against it."""
    kinds = {finding.kind for each in record.outcomes for finding in each.findings}
    return record.verdict is Verdict.DEFINED or not kinds.isdisjoint((Kind.OTHER_SCREWS, Kind.CONTRADICTED))


def _armless(part: Inference) -> tuple[Display, ...]:
    """Return the displays of the sections in which neither a joint of the arm nor one of its lengths is written."""
    sections: dict[str, list[Display]] = {}
    for display in part.document.displays:
        sections.setdefault(display.section, []).append(display)
    own = _letters_of(part)
    armless = {section for section, group in sections.items() if section and not _speaks_of_arm(group, own)}
    return tuple(each for each in part.document.displays if each.section in armless)


def _letters_of(part: Inference) -> re.Pattern[str]:
    """Return what finds the letters of an arm's rows: d_3 and l_2, and r and \\theta of joints without numbers."""
    rows = part.document.front["arm"]["rows"]
    names = {name for row in rows for entry in row.values() for name in _NAME.findall(str(entry))} - {"pi"}
    return re.compile("|".join(map(_written, sorted(names))) or r"(?!)")


def _written(name: str) -> str:
    letter, _, index = name.partition("_")
    begin = rf"(?<![A-Za-z\\]){letter}" if len(letter) == 1 else rf"(?<![A-Za-z])(?:var)?{letter}"
    return begin + (rf"\s*_\s*\{{?\s*{index}(?!\d)" if index else r"(?![A-Za-z]|\s*_)")


def _speaks_of_arm(displays: list[Display], own: re.Pattern[str]) -> bool:
    texts = [normalise_unicode(text) for each in displays for text in (each.latex, *each.said)]
    return bool(joints_used(displays)) or any(own.search(text) for text in texts)
