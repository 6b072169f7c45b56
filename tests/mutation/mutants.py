"""Mutants of a display: its LaTeX with one slip of the pen in it."""

from __future__ import annotations

import random
import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from armproof.verification.diagnosis.slips import Letters, single_edits
from armproof.verification.errors import ReadError
from armproof.verification.findings.finding import write
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation, Writer
from tests.mutation.place import Place
from tests.mutation.sites import Site, are_conditions, find_sites, letters_of

CELLS = 8  # of a display whose slips are tried
CONSTANT_CELLS = 3
SWAPS = 5
NAMES = 3
EDITS = 400


@dataclass(frozen=True)
class Slip:
    """A changed tree, the kind of change, and the change in words."""

    node: n.Node
    kind: str
    words: str


@dataclass(frozen=True)
class Mutant:
    """A display with one slip: `latex` as changed, `node` the changed cell's tree as it is meant to be read."""

    latex: str
    kind: str
    words: str
    site: Site
    node: n.Node | None
    text: str


def mutants_of(place: Place, seed: int = 0) -> Iterator[Mutant]:
    """Yield slips of a display, each kind at each of some cells; the same for the same seed."""
    chance = random.Random(f"{seed} {place.where}")
    latex = place.display.latex
    statements = place.read(latex)
    sites = find_sites(place, statements)
    conditions = are_conditions(statements)
    letters = letters_of(place)
    formulas = [site for site in sites if not _is_constant(site.node)]
    constants = [site for site in sites if _is_constant(site.node)]
    for site in chance.sample(formulas, min(CELLS, len(formulas))):
        for edit in _one_of_each_kind(_slips(site.node, letters), chance):
            if not conditions or edit.kind in ("function", "index"):  # a sign or a factor changes no condition
                yield _mutant(latex, site, edit)
    if conditions:
        return
    yield from _renumbered(place, statements, chance)
    for site in chance.sample(constants, min(CONSTANT_CELLS, len(constants))):
        lengths = letters.lengths if place.checker.names.arm is not None else ()  # elsewhere a letter may be new
        for edit in _one_of_each_kind(_slips_of_constants(site.node, lengths), chance):
            yield _mutant(latex, site, edit)
    cells = [site for site in sites if site.matrix is not None]
    for _ in range(min(SWAPS, len(cells) * (len(cells) - 1) // 2)):
        a, b = chance.sample(cells, 2)
        if a.matrix is b.matrix and not (_is_constant(a.node) and _is_constant(b.node) and a.node == b.node):
            yield _swapped(latex, *sorted((a, b), key=lambda site: site.node.span))


def _renumbered(place: Place, statements: list[n.Statement], chance: random.Random) -> Iterator[Mutant]:
    """Another frame or joint in the scripts of a name: {}^0T_2 for {}^0T_1."""
    latex = place.display.latex
    names = [
        (s, m, side, below)
        for s, statement in enumerate(statements)
        if isinstance(statement, n.Chain) and set(statement.relations) == {"="}
        for m, side in enumerate(statement.members)
        for below in n.walk(side)
        if isinstance(below, n.Name)
        and re.search(r"\d", below.text)
        and latex[slice(*below.span)] == below.text
        and place.member(below).known
    ]
    for s, m, side, name in chance.sample(names, min(NAMES, len(names))):
        texts = [name.text[: d.start()] + digit + name.text[d.end() :] for d in re.finditer(r"(?<![\d.])\d(?![\d.])", name.text)
                 for digit in "0123456" if digit != d.group()]  # fmt: skip
        bound = [text for text in texts if _is_bound(place, text)]
        if bound:
            text = chance.choice(bound)
            site = Site(name, side, s, m, whole=False)
            yield Mutant(_spliced(latex, *name.span, text), "index", f"{text} for {name.text}", site, None, text)


def _is_bound(place: Place, text: str) -> bool:
    names = place.checker.names
    try:
        node = names.reader.read_expression(text)
    except ReadError:
        return False
    return isinstance(node, n.Name) and not names.is_new(node) and place.member(node).known


def _is_constant(node: n.Node) -> bool:
    return isinstance(node, n.Number) or (
        isinstance(node, n.Sum) and all(isinstance(term, n.Number) for _, term in node.terms)
    )


def _one_of_each_kind(edits: Iterator[Slip], chance: random.Random) -> Iterator[Slip]:
    by_kind: dict[str, list[Slip]] = defaultdict(list)
    for count, edit in enumerate(edits):
        if count >= EDITS:
            break
        by_kind[edit.kind].append(edit)
    for kind in sorted(by_kind):
        yield chance.choice(by_kind[kind])


def _slips(node: n.Node, letters: Letters) -> Iterator[Slip]:
    for edit in single_edits(node, letters):
        yield Slip(edit.node, edit.kind, write(edit.finding))


def _slips_of_constants(node: n.Node, lengths: tuple[n.Name, ...]) -> Iterator[Slip]:
    """Nought and one for each other, a sign, a length or a number where a constant belongs."""
    for value in (Fraction(0), Fraction(1), Fraction(2)):
        if not (isinstance(node, n.Number) and node.value == value):
            yield Slip(n.Number(value, str(value)), "number", f"{value}")
    if not (isinstance(node, n.Number) and node.value == 0):
        yield Slip(n.Sum((("-", node),)), "sign", "the sign")
    for length in lengths:
        yield Slip(length, "length", f"{length.key} for a constant")


def _mutant(latex: str, site: Site, edit: Slip) -> Mutant:
    text = _Foreign(latex, site.node).write(edit.node)
    start, end = site.node.span
    return Mutant(_spliced(latex, start, end, text), edit.kind, edit.words, site, edit.node, text)


class _Foreign(Writer):
    """Writes a cell whose letters may come from elsewhere in the document."""

    def __init__(self, latex: str, cell: n.Node) -> None:
        super().__init__(latex, cell, Notation())


def _swapped(latex: str, a: Site, b: Site) -> Mutant:
    (a0, a1), (b0, b1) = a.node.span, b.node.span
    changed = f"{latex[:a0]}{latex[b0:b1]}{latex[a1:b0]}{latex[a0:a1]}{latex[b1:]}"
    return Mutant(
        changed, "cell", f"cells ({a.row}, {a.column}) and ({b.row}, {b.column}) swapped", a, None, latex[b0:b1]
    )


def _spliced(latex: str, start: int, end: int, text: str) -> str:
    before, after = latex[:start], latex[end:]
    glue = " " if before[-1:].isalpha() and text[:1].isalpha() else ""
    rest = " " if text[-1:].isalpha() and after[:1].isalpha() else ""
    return f"{before}{glue}{text}{rest}{after}"
