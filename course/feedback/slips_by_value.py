"""The one or two slips in a written answer, sought by values: where a proof cannot tell, and where one change alone mends nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import chain, combinations, islice, pairwise, product
from typing import TypeVar

import numpy as np

from armproof.course.feedback.claim import ANGLE, Claim
from armproof.course.feedback.outcome import ASKED, MOST_PLACES
from armproof.course.feedback.relation import ENOUGH, Letters, by_places, same, wrong_entries
from armproof.course.feedback.rule_slips import rule_slips
from armproof.models.errors import written
from armproof.verification.diagnosis.diagnosis import find_cell
from armproof.verification.diagnosis.misconceptions import misconceptions
from armproof.verification.diagnosis.slips import (
    Edit,
    dropping_edits,
    function_pairs,
    is_scalar_product,
    plain_edits,
    renamed,
    sign_pairs,
    single_edits,
)
from armproof.verification.diagnosis.slips import Letters as Drawn
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.findings.finding import Audience, write
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.writer import symbol_as_latex

Item = TypeVar("Item")
Edits = Callable[[n.Node], Iterator[Edit]]
Value = Callable[[n.Node], np.ndarray | None]

_FIRST = 60  # changes from which a second one is tried
_EVALUATED = 20_000  # nodes, in all changes that are tried for an answer
_SINGLE, _PAIRS = 8_000, 6_000  # nodes in the changes that are tried of one tree, of one slip and of two
_CHANGED = 25  # nodes that a change makes anew, at most
_LONGEST = 60  # nodes of an entry in which two slips are sought
_MOST_TERMS = 12  # of an entry whose brackets are multiplied out


@dataclass
class _Budget:
    """How many nodes may still be evaluated for an answer, over all its entries."""

    left: int = _EVALUATED

    def spent_on(self, tree: n.Node, changes: Iterator[Item], most: int) -> Iterator[Item]:
        """Yield changes of a tree as long as there is something left, and no more than `most` nodes in all.

        What a change leaves as it is has its values already: of a large tree a part alone is evaluated.
        """
        nodes = min(_size(tree), _CHANGED)
        for change in islice(changes, max(min(self.left, most) // nodes, 0)):
            self.left -= nodes
            yield change


def slips_by_value(
    claim: Claim,
    latex: str,
    *samples: Letters,
    only: np.ndarray | None = None,
    with_turns: bool = False,
    most: int = 2,
    edits: Edits | None = None,
) -> str:
    """Return the slip, or the two slips, after whose mend an answer is what is asked; of each wrong entry of a matrix.

    Args:
        samples: values of the letters, one set after the other: at some an answer may have no value.
        only: the entries to tell of.
        with_turns: whether the entries are angles, of which whole turns too many are no mistake.
        most: how many slips an entry may have, one or two.
        edits: the changes that are tried, one slip alone; all if none are given.
    """
    node, letters, budget = claim.read(latex), _letters(claim), _Budget()
    sets = [(claim.values_over(ASKED, at), claim.values_over(latex, at), claim.evaluated_over(at)) for at in samples]
    sets = (
        sets[:1] if np.isfinite(sets[0][0]).all() else sets
    )  # what is asked has a value everywhere: no others are needed
    searches = (_one_slip, _two_slips)[:most] if edits is None else (partial(_one_slip, edits=edits),)
    for search in searches:
        for true, obtained, value in sets:
            if true.shape != obtained.shape:
                return ""
            said: dict[tuple[int, int], str] = {}
            cells = {at: find_cell(node, *at) if true[0].size > 1 else node for at in _places(true, obtained, only)}
            for (row, column), cell in sorted(cells.items(), key=lambda item: _size(item[1]))[:MOST_PLACES]:
                target = _Target(value, true[:, row, column], with_turns)
                if cell is not None and (found := search(cell, letters, target, budget)):
                    said[row, column] = _words(found)
            if said:
                return next(iter(said.values())) if true[0].size == 1 else by_places(dict(sorted(said.items())))
    return ""


def _size(node: n.Node | None) -> int:
    return 0 if node is None else sum(1 for _ in n.walk(node))


def _places(true: np.ndarray, obtained: np.ndarray, only: np.ndarray | None) -> list[tuple[int, int]]:
    """Return the entries that differ, or of which no sample tells since the answer has no value where what is asked has one."""
    differs = wrong_entries(true, obtained) | ((np.isfinite(true) & np.isfinite(obtained)).sum(axis=0) < ENOUGH)
    differs &= only if only is not None else True
    return [(int(row), int(column)) for row, column in np.argwhere(differs)]


@dataclass(frozen=True)
class _Target:
    """The values that an entry is to have."""

    value: Value
    true: np.ndarray
    with_turns: bool = False

    def is_met(self, edit: Edit) -> bool:
        """Whether a change gives the entry its values."""
        found = self.value(edit.node)
        return found is not None and (same(found, self.true) or (self.with_turns and self._is_turned(found)))

    def _is_turned(self, found: np.ndarray) -> bool:
        """Whether values differ by whole turns alone."""
        return same(np.exp(1j * found), np.exp(1j * self.true))


def _one_slip(
    cell: n.Node, letters: Drawn, target: _Target, budget: _Budget, edits: Edits | None = None
) -> list[Finding]:
    """Return the finding whose change mends an entry, as it stands or with its brackets multiplied out; none where none does."""
    for tree in (cell, *expanded(cell)) if edits is None else (cell,):
        changes = chain(_edits(tree, letters), _added_terms(tree, letters)) if edits is None else edits(tree)
        for edit in budget.spent_on(tree, changes, _SINGLE):
            if not _is_bare(edit.node) and target.is_met(edit):
                return [_of_brackets(edit.finding, cell, tree)]
    return []


def _of_brackets(finding: Finding, cell: n.Node, tree: n.Node) -> Finding:
    """Return a finding on an entry's own tree; of one whose brackets are multiplied out, that a factor before them is not that of all terms."""
    is_of_one_term = tree is not cell and finding.kind in (Kind.SINE_FOR_COSINE, Kind.COSINE_FOR_SINE)
    return say(Kind.WIDE_BRACKETS) if is_of_one_term else finding


def _two_slips(cell: n.Node, letters: Drawn, target: _Target, budget: _Budget) -> list[Finding]:
    """Return the two findings whose changes mend an entry, those that drop and add nothing first; none where none do."""
    trees = [tree for tree in (cell, *expanded(cell)) if _size(tree) <= _LONGEST]
    for edits in (plain_edits, dropping_edits, _added_terms, _any_edits):
        for tree in trees:
            first = [edit for edit in islice(edits(tree, letters), _FIRST) if not _is_bare(edit.node)]
            pairs = ((one, other) for one in first for other in edits(one.node, letters))
            for one, other in budget.spent_on(tree, pairs, _PAIRS):
                if target.is_met(other):
                    return [_of_brackets(each.finding, cell, tree) for each in (one, other)]
    return []


def _edits(cell: n.Node, letters: Drawn) -> Iterator[Edit]:
    """Yield the changes of one slip, mistakes of a rule first."""
    return chain(
        misconceptions(cell),
        rule_slips(cell),
        single_edits(cell, letters),
        sign_pairs(cell),
        function_pairs(cell),
        _exchanged(cell),
        _multiplied(cell),
    )


def _any_edits(cell: n.Node, letters: Drawn) -> Iterator[Edit]:
    """Yield the changes of one of two slips, letters exchanged first, mistakes of a rule last."""
    return chain(
        _exchanged(cell), single_edits(cell, letters), misconceptions(cell), sign_pairs(cell), function_pairs(cell)
    )


def _added_terms(cell: n.Node, letters: Drawn) -> Iterator[Edit]:
    """Yield the trees with a letter or its square added to a sum, under a root, below a line."""
    two = n.Number(Fraction(2), "2")
    of_squares = any(isinstance(node, n.Power) for node in n.walk(cell))
    inner = [part for node in n.walk(cell) for part in _places_of_terms(node)]
    for node, letter in product((cell, *inner), letters.lengths):
        name = letter.text or letter.key
        for shown, added in ((f"{name}^2", n.Power(letter, two)), (name, letter))[: 1 if of_squares else 2]:
            for sign in "+-":
                terms = (*(node.terms if isinstance(node, n.Sum) else (("+", node),)), (sign, added))
                finding = say(Kind.MISSING_TERM, term=f"-{shown}" if sign == "-" else shown)
                yield Edit(n.substitute(cell, node, n.Group(n.Sum(terms))), "term", finding)


def _places_of_terms(node: n.Node) -> tuple[n.Node, ...]:
    """Return the parts of a node at which a term may be missing."""
    if isinstance(node, n.Quotient):
        return (node.numerator, node.denominator)
    if n.is_call(node, "sqrt"):
        return (bare(node.arguments[0]),)
    return (bare(node.base),) if isinstance(node, n.Power) and isinstance(bare(node.base), n.Sum) else ()


def _multiplied(cell: n.Node) -> Iterator[Edit]:
    """Yield the entry with the two neighbours of a sum multiplied instead: l + cos θ for l cos θ."""
    for node in n.walk(cell):
        if not isinstance(node, n.Sum):
            continue
        for k, ((sign, one), (_, other)) in enumerate(pairwise(node.terms)):
            if isinstance(one, n.Number) or isinstance(other, n.Number):
                continue
            product_of = n.Product((n.Group(one), n.Group(other)), ("",))
            terms = (*node.terms[:k], (sign, product_of), *node.terms[k + 2 :])
            yield Edit(n.substitute(cell, node, n.Group(replace(node, terms=terms))), "term", say(Kind.SUM_FOR_PRODUCT))


def _exchanged(cell: n.Node) -> Iterator[Edit]:
    """Yield the entry with two of its letters exchanged."""
    names = {name.key: name for name in n.names(cell)}
    for one, other in combinations(names.values(), 2):
        changed = renamed(cell, {one.key: other, other.key: one})
        yield Edit(changed, "length", say(Kind.SWAPPED_LENGTHS, one=one.text or one.key, other=other.text or other.key))


def expanded(node: n.Node) -> Iterator[n.Node]:
    """Yield a sum of products with its brackets multiplied out, where it has any: (a + b) C as a C + b C."""
    terms = _terms(node)
    if 1 < len(terms) <= _MOST_TERMS and (len(terms) > len(node.terms) if isinstance(node, n.Sum) else True):
        yield n.Sum(
            tuple((sign, factors[0] if len(factors) == 1 else n.Product(factors, ("",) * (len(factors) - 1))) for sign, factors in terms),
            span=node.span,
        )  # fmt: skip


def _terms(node: n.Node) -> list[tuple[str, tuple[n.Node, ...]]]:
    """Return the terms of a node, each with its sign and its factors."""
    node = bare(node)
    if isinstance(node, n.Sum) and all(sign in "+-" for sign, _ in node.terms):
        return [(_times(sign, inner), factors) for sign, term in node.terms for inner, factors in _terms(term)]
    if is_scalar_product(node):
        parts = [_terms(factor) for factor in node.factors]
        if np.prod([len(part) for part in parts]) <= _MOST_TERMS:
            return [
                (
                    _times(*(sign for sign, _ in each)),
                    tuple(deepcopy(factor) for _, factors in each for factor in factors),
                )
                for each in product(*parts)
            ]
    return [("+", (node,))]


def _times(*signs: str) -> str:
    return "-" if signs.count("-") % 2 else "+"


def _is_bare(node: n.Node) -> bool:
    """Whether nothing but a letter or a number is left of an entry, from which two changes make anything."""
    return isinstance(node, n.Name | n.Number)


def _words(findings: list[Finding]) -> str:
    one, *others = (write(finding, Audience.STUDENT) for finding in findings)
    if others and others[0] == one:
        return written("{slip}, in two places", slip=one)
    return written("two slips: {one}; {other}", one=one, other=others[0]) if others else one


def _letters(claim: Claim) -> Drawn:
    """Return the letters that a slip may have confused: those of the task, angles apart."""
    nodes = [claim.read(symbol_as_latex(key)) for key in claim.letters]
    names = [node for node in nodes if isinstance(node, n.Name)]
    angles = tuple(name for name in names if ANGLE.match(name.key))
    joints = tuple(sorted(int(name.sub) for name in angles if name.sub.isdigit()))
    return Drawn(joints, angles, tuple(name for name in names if name not in angles))
