"""A document checked again after a change has the verdicts of one that is checked for the first time."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import fields, replace
from fractions import Fraction
from pathlib import Path

import pytest

import armproof.course
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.check import DocumentChecker, check_document, load_arm_of
from armproof.verification.document import Display, Document, find_documents, parse_document
from armproof.verification.document.model import Listing
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.latex.nodes import Chain, Name
from armproof.verification.latex.writer import Notation
from armproof.verification.naming.state import (
    Definition,
    DocumentState,
    JacobianRows,
    OnABranch,
    OtherZero,
    PrintedError,
    Stated,
    Told,
)
from armproof.verification.running.incremental import IncrementalChecker
from armproof.verification.verdict import DocumentResult, SlipBefore, Verdict

HANDOUTS = find_documents([Path(armproof.course.__path__[0]) / "handouts"])
SMALL = [path for path in HANDOUTS if path.stat().st_size < 4_000]
FRONT = "---\narm: planar_2r\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n"
PARTS = [
    "$$ a = l_1 C_1 + l_2 C_{12} $$",
    "$$ p_{2,x} = a $$",
    "$$ D = \\det J_v $$",
    "$$ D = l_1 l_2 \\sin\\theta_2 $$",
    "$$ C_{12} = C_1 C_2 - S_1 S_2 $$",
    "> **Erratum**\n> $$ D = l_1 l_2 \\cos\\theta_2 $$",
]


CHANGES: dict[str, Callable[[DocumentState], object]] = {
    "transforms": lambda state: setattr(state, "transforms", "lower"),
    "angles": lambda state: setattr(state, "angles", "table"),
    "branches": lambda state: state.branches.update({"theta_1": OnABranch(3, "", frozenset({1}))}),
    "section": lambda state: setattr(state, "section", "A title"),
    "exercise": lambda state: setattr(state, "exercise", "Exercise 1"),
    "has_open_determinant": lambda state: setattr(state, "has_open_determinant", True),
    "apart": lambda state: setattr(state, "apart", 1),
    "own_shorthands": lambda state: setattr(state, "own_shorthands", frozenset({("cos", 2)})),
    "other_sizes": lambda state: state.other_sizes.update(J=say(Kind.NO_EQUATION)),
    "subject": lambda state: setattr(state, "subject", Name("a")),
    "definitions": lambda state: state.definitions.update(a=Definition(float)),
    "inferred": lambda state: state.inferred.update(J=Quantity("jacobian", "2")),
    "conventional": lambda state: state.conventional.add("p_x"),
    "placed": lambda state: state.placed.update(R=(1, "")),
    "awaited": lambda state: state.awaited.update({"R_t": (Name("r", "11"), 3)}),
    "of_tool": lambda state: state.of_tool.update(T=frozenset({3})),
    "printed": lambda state: setattr(state, "printed", Quantity("rotation", "2")),
    "entries_held": lambda state: state.entries_held.update({Quantity("rotation", "2"): frozenset({1})}),
    "usual": lambda state: state.usual.update({("p_x", "A title"): Quantity("origin", "2")}),
    "used": lambda state: state.used.add("a"),
    "used_in_general": lambda state: state.used_in_general.add("a"),
    "listed": lambda state: setattr(state, "listed", (Listing(3, ("q_{1} = 0",)),)),
    "adopted": lambda state: state.adopted.add("L_3"),
    "zeros": lambda state: state.zeros.update(theta_1=OtherZero(Fraction(1, 2), "theta'_1", 3)),
    "counts_anew": lambda state: setattr(state, "counts_anew", True),
    "counts_anew_in": lambda state: setattr(state, "counts_anew_in", "A title"),
    "without_value": lambda state: state.without_value.update(W=(3, "A title")),
    "elsewhere": lambda state: state.elsewhere.add(3),
    "limits_joints": lambda state: setattr(state, "limits_joints", True),
    "task_rows": lambda state: setattr(state, "task_rows", (2, 6)),
    "balanced": lambda state: state.balanced.update({("tau", ""): None}),
    "beyond": lambda state: state.beyond.update(E=("2", "T_E")),
    "configuration": lambda state: state.configuration.update(theta_1=Stated(Name("a"), 0.5)),
    "told": lambda state: setattr(state, "told", Told(in_words=True)),
    "told_lengths": lambda state: state.told_lengths.update(l_1=Stated(Name("a"), 0.5)),
    "given_last": lambda state: state.given_last.update(l_1=Stated(Name("a"), 0.5)),
    "held": lambda state: state.held.add(("k", 3)),
    "rounded": lambda state: state.rounded.update(a=2),
    "shown": lambda state: state.shown.update(J=JacobianRows((1, 2))),
    "signs": lambda state: state.signs.values.update(sigma=1),
    "slips": lambda state: state.slips.update({("a", 1): (say(Kind.WRONG_SIGN), Name("a"))}),
    "met": lambda state: state.met.update({3: [SlipBefore("a", 1, say(Kind.WRONG_SIGN), Name("a"))]}),
    "mended": lambda state: state.mended.update({("a", 1): (Name("a"), float)}),
    "errors": lambda state: state.errors.append(PrintedError(1, "a", Name("a"), {(1, 1): "b"})),
    "compares_lengths": lambda state: setattr(state, "compares_lengths", True),
    "tells_jacobian": lambda state: setattr(state, "tells_jacobian", True),
    "comparisons": lambda state: state.comparisons.append(Chain((Name("l"), Name("a")), (">",))),
    "consulted": lambda state: state.consulted.add(("x", 1)),
    "has_capital_entries": lambda state: setattr(state, "has_capital_entries", True),
    "omega_is_first": lambda state: setattr(state, "omega_is_first", True),
    "notation": lambda state: setattr(state, "notation", Notation(cosine="C")),
}


def text_of(*parts: str) -> str:
    return FRONT + "".join(f"\n{part}\n" for part in parts)


def page(*parts: str) -> Document:
    return parse_document(Path("page.md"), text_of(*parts))


def without_time(result: DocumentResult | None) -> DocumentResult:
    assert result is not None
    return replace(result, seconds=0.0)


def assert_as_from_scratch(checker: IncrementalChecker, document: Document) -> list[int]:
    """Update to a document; return the lines that were told. The result is that of a check from scratch."""
    told = [record.line for record in checker.update(document)]
    assert without_time(checker.result) == without_time(check_document(document))
    return told


@pytest.fixture
def checker() -> IncrementalChecker:
    return IncrementalChecker(Path("page.md"))


def test_only_the_changed_display_is_checked_again(
    checker: IncrementalChecker, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert assert_as_from_scratch(checker, page(*PARTS)) == [7, 9, 11, 13, 15, 18]
    checked: list[int] = []
    check = DocumentChecker.check_display
    monkeypatch.setattr(
        DocumentChecker, "check_display", lambda self, display: checked.append(display.line) or check(self, display)
    )
    told = [record.line for record in checker.update(page(*PARTS[:4], PARTS[4].replace("-", "+"), PARTS[5]))]
    assert told == [15]
    assert checked[0] == 15  # and what follows it, as an error found may explain another
    checked.clear()
    assert [record.verdict for record in checker.update(page(*PARTS))] == [Verdict.PROVED]
    checked.clear()
    other = PARTS[4].replace("C_1 C_2", "C_2 C_1")
    assert [record.line for record in checker.update(page(*PARTS[:4], other, PARTS[5]))] == [15]
    assert checked == [15]
    assert list(checker.update(page(*PARTS[:4], other, PARTS[5]))) == []


@pytest.mark.parametrize(
    "change",
    [
        lambda parts: [parts[0].replace("C_{12}", "S_{12}"), *parts[1:]],  # a definition that others rest on
        lambda parts: parts[1:],
        lambda parts: parts[:-1],
        lambda parts: [*parts[:2], *parts[4:], *parts[2:4]],
        lambda parts: ["One line more.", *parts],
        lambda parts: [*parts, "$$ a = l_1 $$"],
        lambda parts: [*parts[:2], parts[0], *parts[2:]],
        lambda parts: ["# A title", *parts[:3], "# Another", *parts[3:]],
        lambda parts: [parts[0].replace("+", "+ }"), *parts[1:]],
        lambda parts: [*parts[:3], "$$ \\cos\\frac{\\theta_1}{2} = \\cos\\frac{\\theta_1}{2} $$", *parts[3:]],
        lambda _: [],
    ],
)
def test_every_kind_of_change_gives_the_verdicts_of_a_check_from_scratch(
    checker: IncrementalChecker, change: Callable[[list[str]], list[str]]
) -> None:
    assert_as_from_scratch(checker, page(*PARTS))
    assert_as_from_scratch(checker, page(*change(PARTS)))
    assert_as_from_scratch(checker, page(*PARTS))


def test_another_front_matter_begins_anew(checker: IncrementalChecker) -> None:
    document = page(*PARTS)
    assert_as_from_scratch(checker, document)
    other = parse_document(Path("page.md"), text_of(*PARTS).replace("rows: [1, 2]", "rows: [2, 1]"))
    assert_as_from_scratch(checker, other)
    with pytest.raises(DocumentError, match="no arm 'skara'"):
        list(checker.update(parse_document(Path("page.md"), text_of(*PARTS).replace("planar_2r", "skara"))))
    assert_as_from_scratch(checker, document)


TABLE = "| a | alpha | d | theta |\n|---|---|---|---|\n| $l_1$ | 0 | 0 | $\\theta_1$ |\n"
OF_TABLE = "$$ {}^0T_1 = \\begin{bmatrix} c_1 & -s_1 & 0 & l_1 c_1 \\\\ s_1 & c_1 & 0 & l_1 s_1 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$"


def test_another_table_gives_another_arm(checker: IncrementalChecker) -> None:
    texts = [TABLE, TABLE, "A line more.\n\n" + TABLE, TABLE.replace("| 0 | 0 |", "| pi/2 | d_1 |"), "No table.\n"]
    arms = []
    for text in texts:
        assert_as_from_scratch(checker, parse_document(Path("page.md"), f"{text}\n{OF_TABLE}\n"))
        assert checker.result is not None
        arms.append([arm.line for arm in checker.result.arms])
    assert arms == [[1], [1], [3], [], []]  # one link matrix is no arm


def spoilt(display: Display, rng: random.Random) -> Display:
    """Change one sign or one digit of a display."""
    places = [k for k, c in enumerate(display.latex) if c in "+-123"]
    if not places:
        return replace(display, latex=display.latex + " + 1")
    k = rng.choice(places)
    other = {"+": "-", "-": "+"}.get(display.latex[k], "2" if display.latex[k] != "2" else "1")
    return replace(display, latex=display.latex[:k] + other + display.latex[k + 1 :])


@pytest.mark.parametrize("path", SMALL, ids=[path.stem for path in SMALL])
def test_a_handout_changed_at_random_has_the_verdicts_of_a_check_from_scratch(path: Path) -> None:
    document = parse_document(path, path.read_text(encoding="utf-8"))
    checker, rng = IncrementalChecker(path), random.Random(path.name)
    list(checker.update(document))
    for _ in range(3):
        k = rng.randrange(len(document.displays))
        displays = [*document.displays[:k], spoilt(document.displays[k], rng), *document.displays[k + 1 :]]
        assert_as_from_scratch(checker, replace(document, displays=tuple(displays)))


def test_a_state_that_differs_is_noticed() -> None:
    document = page(*PARTS)
    checker = DocumentChecker(document, load_arm_of(document))
    state = checker.names.state
    before = state.copy()
    assert before == state
    checker.check_display(document.displays[0])
    after = state.copy()
    assert before != after
    state.become(before)
    assert before == state != after


def test_every_part_of_a_state_is_copied_compared_and_put_back() -> None:
    assert {field.name for field in fields(DocumentState)} == CHANGES.keys()
    for name, change in CHANGES.items():
        state = DocumentState()
        before = state.copy()
        change(state)
        changed = state.copy()
        assert state == changed != before, name
        state.become(before)
        assert state == before, name
        change(state)
        assert state == changed and before == DocumentState(), name


def test_nothing_stays_of_what_is_tried_though_it_fails() -> None:
    state = DocumentState()
    made = state.definitions
    with pytest.raises(DocumentError), state.unchanged() as before:
        made["a"] = Definition(float)
        state.used.add("a")
        before.consulted.add(("a", 1))  # what is put back may be told more
        raise DocumentError("no")
    assert (state.definitions, state.used, state.consulted) == ({}, set(), {("a", 1)})
