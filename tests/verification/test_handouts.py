"""The handouts of the course: every display has its verdict, what is right is proved, what was printed wrongly is refuted."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

import armproof.course
from armproof.models.catalogue import arm_names
from armproof.verification.check import check_document, verify
from armproof.verification.document import Display, find_documents, read_document
from armproof.verification.verdict import DocumentResult, Record, Verdict

HANDOUTS = Path(armproof.course.__path__[0]) / "handouts"
DOCUMENTS = find_documents([HANDOUTS])
BEYOND = re.compile(r"arc(?:cos|sin|tan)|atan|\\pm|\\mp|\\le|\\ge|<|>|\\approx|\\sqrt|\|")
SIGN = re.compile(r"(?<=[\s&(=\]}\d])(?P<sign>[-+])(?=\s*[A-Za-z\\\d(])")


@cache
def result(path: Path) -> DocumentResult:
    return verify(path)


def everything(path: Path) -> tuple[Record, ...]:
    """Return the records of the displays and of the DH tables."""
    return (*result(path).equations, *result(path).tables)


handouts = pytest.mark.parametrize("path", DOCUMENTS, ids=[path.stem for path in DOCUMENTS])


def test_there_is_a_handout_for_every_arm() -> None:
    arms = {read_document(path).front.get("arm") for path in DOCUMENTS}
    assert set(arm_names()) <= arms


@handouts
def test_nothing_is_unreadable_or_unchecked(path: Path) -> None:
    left = [
        (r.line, r.verdict.value, r.message)
        for r in everything(path)
        if r.verdict in (Verdict.UNREADABLE, Verdict.UNCHECKED)
    ]
    assert not left


@handouts
def test_every_display_is_a_record(path: Path) -> None:
    document = read_document(path)
    assert [(r.line, r.latex) for r in result(path).equations] == [(d.line, d.latex) for d in document.displays]
    assert 2 * len(document.displays) == path.read_text(encoding="utf-8").count("$$")


@handouts
def test_what_stands_in_the_text_holds(path: Path) -> None:
    wrong = [(r.line, r.verdict.value, r.message) for r in everything(path) if not r.erratum and not r.passes]
    assert not wrong
    assert any(r.verdict is Verdict.PROVED and not r.erratum for r in everything(path))


@handouts
def test_every_erratum_is_refuted_and_explained(path: Path) -> None:
    for record in everything(path):
        if record.erratum:
            assert record.verdict is Verdict.REFUTED, record.line
            assert record.message or record.entries, record.line
    assert result(path).passed_strictly()


@handouts
def test_only_roots_arc_functions_and_inequalities_are_merely_confirmed(path: Path) -> None:
    for record in result(path).equations:
        if record.verdict is Verdict.CONFIRMED:
            assert BEYOND.search(record.latex), (record.line, record.message)


@handouts
def test_proofs_agree_with_the_double_plant(path: Path) -> None:
    errors = [
        (r.max_error, r.line) for r in result(path).equations if r.max_error is not None and r.verdict is Verdict.PROVED
    ]
    for error, line in errors:
        latex = next(r.latex for r in result(path).equations if r.line == line)
        assert error <= largest_error(latex), line


def largest_error(latex: str) -> float:
    """Return how far the double plant may be off a proved display: quotients and roots magnify its rounding."""
    return 1e-6 if BEYOND.search(latex) or "frac" in latex or "^{-1}" in latex else 1e-12


@handouts
def test_one_flipped_sign_in_a_proved_display_is_refuted(path: Path) -> None:
    document = read_document(path)
    displays: list[Display] = []
    for display, record in zip(document.displays, result(path).equations, strict=True):
        displays.append(display)
        if record.verdict is Verdict.PROVED and (flipped := flip_a_sign(display.latex)) is not None:
            displays.append(replace(display, latex=flipped, erratum=True, section="flipped"))
    flips = [display for display in displays if display.section == "flipped"]
    checked = check_document(replace(document, displays=tuple(displays), tables=()))
    survivors = [
        record for record in checked.equations if record.section == "flipped" and record.verdict is not Verdict.REFUTED
    ]
    for record in survivors:  # a sign before what is zero changes nothing: the double plant says so too
        assert record.verdict is Verdict.PROVED, record.latex
        assert record.samples == 1000 and record.max_error is not None, record.latex
        assert record.max_error <= largest_error(record.latex), record.latex
    assert len(flips) > 2 * len(survivors)


def flip_a_sign(latex: str) -> str | None:
    """Return the display with its last sign flipped, scripts apart; a display without a sign gets one after its last "="."""
    plain = re.sub(
        r"\\(?:text|mathrm|operatorname|begin|end)\{[^{}]*\}|[_^]\{[^{}]*\}",
        lambda match: " " * len(match.group()),
        latex,
    )
    if re.search(r"iff|Rightarrow|\\in\b", plain):
        return None
    if found := list(SIGN.finditer(plain)):
        place = found[-1].start("sign")
        return latex[:place] + ("+" if latex[place] == "-" else "-") + latex[place + 1 :]
    place = plain.rfind("=")
    return None if place < 0 else f"{latex[: place + 1]} -{latex[place + 1 :]}"
