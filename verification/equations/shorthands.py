"""Shorthands that a document gives a meaning of its own: c_{12} of a text that says `c_{12} = \\cos(\\theta_1 - \\theta_2)`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress

from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.sides import Members
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.patterns import regex

Shorthand = tuple[str, object]  # "cos" and the angles, or how many there are where it is said of any: c_i, c_{ij}

_MAY_BE = regex(r"(?<![A-Za-z\\])[cCsS]\s*_.*=|=\s*[cCsS]\s*_", re.DOTALL)
_ANY = regex(r"_\s*(?:\{\s*([ijk](?:\s*[ijk])*)\s*\}|([ijk])(?![A-Za-z]))")
_NUMBERS = str.maketrans("ijk", "123")


def own_shorthands(members: Members, said: Iterable[str]) -> Iterator[Shorthand]:
    """Yield the shorthands that the text between displays says to be something else than they are by convention.

    A condition says nothing of the kind: of c_2 = 0, c_1 = s_1 and c_2 = c_3 none says how a cosine is written.
    """
    for latex in filter(_MAY_BE.search, dict.fromkeys(said)):
        of_any = _ANY.search(latex) is not None
        numbered = _ANY.sub(lambda found: f"_{{{(found[1] or found[2]).translate(_NUMBERS)}}}", latex)
        with suppress(ReadError, EvaluationError, RecursionError):
            chains = [each for each in members.names.reader.read(numbered) if isinstance(each, n.Chain)]
            for chain in (each for each in chains if set(each.relations) in ({"="}, {"≡"})):
                for call in _said_otherwise(members, chain):
                    yield call.function, len(angles_of(call)) if of_any else angles_of(call)


def shorthands_in_row(cells: Iterable[str]) -> Iterator[str]:
    """Yield what a row of a table of symbols says of a shorthand: | c_{12} | cos(θ_1 + θ_2) |."""
    cells = list(cells)
    for name in cells:
        if re.fullmatch(r"[cCsS]\s*_\s*(?:\w|\{[\d\sijk]+\})", name.strip()):
            yield from (f"{name} = {other}" for other in cells if re.search(r"\\(?:cos|sin)(?![a-z])", other))


def is_among(call: n.Call, own: frozenset[Shorthand]) -> bool:
    """Whether a sine or cosine is one of some shorthands."""
    angles = angles_of(call)
    return bool(angles) and not own.isdisjoint({(call.function, angles), (call.function, len(angles))})


def angles_of(call: n.Call) -> tuple[tuple[int, int], ...]:
    """Return the angles in the index of a shorthand, with their signs; none of any other call."""
    angles = call.arguments[0] if call.arguments else None
    return angles.terms if isinstance(angles, n.JointAngles) else ()


def digits_of(call: n.Call) -> str:
    """Return the index of a shorthand: 12 of c_{12}."""
    return "".join(str(index) for _, index in angles_of(call))


def _said_otherwise(members: Members, chain: n.Chain) -> Iterator[n.Call]:
    for alone in map(bare, chain.members):
        if not isinstance(alone, n.Call) or not _is_shorthand(alone):
            continue
        for other in chain.members:
            if bare(other) is not alone and _defines(alone, other):
                one, found = members.evaluate(alone).value, members.evaluate(other)
                is_outside = isinstance(found.problem, OutsideAlgebra)  # the cosine of a product of angles
                both = isinstance(one, Scalar) and isinstance(found.value, Scalar)
                if is_outside or (both and not (one - found.value).is_zero()):  # type: ignore[operator]
                    yield alone


def _is_shorthand(node: n.Node) -> bool:
    return (
        isinstance(node, n.Call) and node.style == "index" and node.function in ("cos", "sin") and bool(angles_of(node))
    )


def _defines(call: n.Call, other: n.Node) -> bool:
    """Whether a side may say what a shorthand stands for: it holds a sine or a cosine that is written out, or a formula for one of several digits."""
    turns = [each for each in n.walk(other) if n.is_call(each, "cos", "sin")]
    is_formula = len(angles_of(call)) > 1 and not _is_shorthand(bare(other))
    return any(not _is_shorthand(each) or is_formula for each in turns)
