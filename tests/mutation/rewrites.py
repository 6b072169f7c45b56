"""Equivalent rewrites of the course's proved equations: every one must be proved again."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.written import write_scalar
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation, Writer
from armproof.verification.verdict import Verdict
from tests.mutation import spelling
from tests.mutation.algebraic import RULES, rewritten
from tests.mutation.place import Place, proved_places
from tests.mutation.sites import Site, find_sites

EACH = 10  # of a display


@dataclass(frozen=True)
class Rewrite:
    """An equal display: what was done, and its LaTeX."""

    kind: str
    latex: str


@dataclass(frozen=True)
class Answer:
    """The verdict of a rewrite; anything but proved is a false alarm."""

    where: str
    kind: str
    proved: bool
    latex: str
    verdict: str
    message: str


def answers(path: Path, seed: int = 0, each: int = EACH) -> Iterator[Answer]:
    """Yield the verdicts of rewrites of a document's proved equations."""
    for place in proved_places(path):
        yield from try_rewrites(place, chosen_rewrites(place, seed, each))


def try_rewrites(place: Place, rewrites: list[Rewrite]) -> Iterator[Answer]:
    """Yield the verdict of each rewrite, on the double plant as well."""
    for rewrite in rewrites:
        try:
            record = place.check(rewrite.latex, confirm=True)
            proved, verdict, message = record.verdict is Verdict.PROVED, record.verdict.value, record.message
        except Exception as error:  # a crash is a false alarm too
            proved, verdict, message = False, "crashed", repr(error)
        yield Answer(place.where, rewrite.kind, proved, rewrite.latex, verdict, message)


def chosen_rewrites(place: Place, seed: int = 0, each: int = EACH) -> list[Rewrite]:
    """Return up to `each` rewrites of a display, of different kinds where there are as many."""
    chance = random.Random(f"{seed} {place.where}")
    found = list(rewrites_of(place, chance))
    chance.shuffle(found)
    first = {rewrite.kind: rewrite for rewrite in reversed(found)}
    rest = [rewrite for rewrite in found if first[rewrite.kind] is not rewrite]
    kinds = list(first.values())
    chance.shuffle(kinds)
    return [*kinds, *rest][:each]


def rewrites_of(place: Place, chance: random.Random) -> Iterator[Rewrite]:
    """Yield one rewrite of each kind that applies, the algebraic ones at two places."""
    latex = place.display.latex
    sites = [
        site for site in find_sites(place, place.read(latex)) if not n.is_rank(site.node)
    ]  # k is that of one place
    for kind, rule in RULES.items():
        for _ in range(2):
            for site in chance.sample(sites, len(sites)):
                changed = rewritten(site.node, rule, chance, lambda node: _is_scalar(place, node))
                if changed is not None:
                    yield Rewrite(kind, _put(latex, site, Writer(latex, site.node, Notation()).write(changed)))
                    break
    styles = spelling.allowed_styles(place)
    for style, notation in styles.items():
        yield from _if_any(f"written as {style}", spelling.other_cosines(place, latex, notation))
    yield from _if_any("another matrix environment", spelling.other_matrices(latex, chance))
    yield from _if_any("other brackets", spelling.other_brackets(latex, chance))
    yield from _if_any("other fractions", spelling.other_fractions(latex, chance))
    yield from _if_any("other pre-scripts", spelling.other_transforms(place, latex, chance))
    yield from _if_any("another layout", spelling.other_layout(latex, chance))
    yield from _if_any("sides exchanged", spelling.sides_exchanged(place, latex))
    for notation, folded in zip(chance.sample(list(styles.values()), min(2, len(styles))), (True, False), strict=False):
        yield from _written_anew(place, latex, sites, notation, folded, chance)


def _written_anew(
    place: Place, latex: str, sites: list[Site], notation: Notation, folded: bool, chance: random.Random
) -> Iterator[Rewrite]:
    """A cell, or all cells of a matrix, from their exact values."""
    scalars = [
        site for site in sites if _is_scalar(place, site.node, roots=False) and not isinstance(site.node, n.Number)
    ]
    if not scalars:
        return
    first = chance.choice(scalars)
    together = [site for site in scalars if site.matrix is first.matrix and site.matrix is not None] or [first]
    for site in sorted(together, key=lambda site: -site.node.span[0]):
        value = place.member(site.node).value
        if isinstance(value, Matrix):
            value = value.rows[0][0]
        latex = _put(latex, site, write_scalar(value, notation, folded=folded))
    yield Rewrite("written from the exact value" if folded else "written out as a normal form", latex)


def _is_scalar(place: Place, node: n.Node, *, roots: bool = True) -> bool:
    """Whether a tree has a scalar value; without `roots`, one with no root or arc function, whose branch would be lost."""
    value = place.member(node).value
    if isinstance(value, Matrix) and value.shape == (1, 1):
        value = value.rows[0][0]
    if not isinstance(value, Scalar):
        return False
    kinds = {
        kind
        for part in (value.numerator, value.denominator)
        for powers, _ in value.ring.terms(part)
        for kind, _ in powers
    }
    return roots or not kinds & {"radical", "arc"}


def _put(latex: str, site: Site, text: str) -> str:
    start, end = site.node.span
    return f"{latex[:start]} {text} {latex[end:]}"


def _if_any(kind: str, latex: str | None) -> Iterator[Rewrite]:
    if latex is not None:
        yield Rewrite(kind, latex)
