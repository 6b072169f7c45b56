"""Letters beside × in a document without an arm: a × b may be of vectors, and a b of numbers."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from armproof.verification.algebra.matrix import column
from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import undecided
from armproof.verification.verdict import Verdict

SUFFIXES = ("xyz", "123")


def crossed_letters(names: Names, chain: n.Chain) -> frozenset[str]:
    """Return the free letters that are factors of a × in a chain of a document without an arm."""
    crossed = [below for below in n.walk(chain) if isinstance(below, n.Product) and "×" in below.operators]
    factors = [factor for product in crossed for factor in map(bare, product.factors) if isinstance(factor, n.Name)]
    return frozenset(each.key for each in factors if names.is_free(each) and each.key not in names.state.definitions)


def of_vectors(
    names: Names,
    chain: n.Chain,
    letters: frozenset[str],
    line: int,
    define: bool,
    check: Callable[[bool], list[Outcome]],
) -> list[Outcome]:
    """Return the outcomes of a chain with ×, of vectors or of numbers: what is so of one of them alone is left open.

    `check` checks the chain; what it is called with says whether names get a meaning by it, as they do where `define`.
    """
    doubt = say(Kind.CROSS_OF_LETTERS, letters=sorted(letters))
    of_numbers = check(define)
    if made := [key for outcome in of_numbers for key in outcome.defines]:
        names.forget(made if define else ())
        for key in made if define else ():
            names.define(key, undecided(doubt), line)
        return [outcome.left_open(doubt) for outcome in of_numbers]
    with names.state.unchanged():
        for letter in letters:
            components = [f"{letter}_{suffix}" for suffix in _suffixes(chain, letter)]
            names.define(letter, partial(_column, components), line)
        tried = check(False)
    others = {b.key for b in n.names(chain) if b.key != "pi"} - letters
    of_letters = {key for key in others if key.rpartition("_")[0] in letters}
    refuted = [any(o.verdict is Verdict.REFUTED for o in outcomes) for outcomes in (of_numbers, tried)]
    if hold(tried) or (all(refuted) and others == of_letters):
        return tried
    return [outcome.left_open(doubt) for outcome in of_numbers]


def _suffixes(chain: n.Chain, letter: str) -> str:
    """Return how the components of a vector are told in a chain: a_1, a_2, a_3, else a_x, a_y, a_z."""
    found = {b.key for b in n.names(chain)}
    return SUFFIXES[any(f"{letter}_{digit}" in found for digit in SUFFIXES[1])]


def _column(components: list[str], algebra: Algebra) -> Value:
    return column([algebra.symbol(each) for each in components])
