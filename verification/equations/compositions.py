"""The law by which transforms compose, {}^0T_2 = {}^0T_1 {}^1T_2: it holds of any frames, by the indices alone."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.patterns import regex

_TRANSFORMS = "TAHR"
_POINTS = ("P", "p")
_WHOLE = n.Name("R")
FEWEST = 3  # steps of a product that tell which index is the reference
_INDEX = regex(r"(?:(?P<digit>\d)|(?P<letter>[ijknN]))(?:(?P<sign>[+-])(?P<step>\d))?")
_FAR = 100  # ranks: of frame i, which is behind numbered ones,
_LAST = 2000  # of a tool,
_UNKNOWN = 10_000  # of what nothing tells
_ENDS = dict.fromkeys(("B", "b", "base"), -1) | dict.fromkeys(("G", "E", "e", "EE", "ee", "tool", "TCP"), _LAST)


@dataclass(frozen=True)
class _Step:
    """From which frame a factor leads to which; `open` where unwritten factors, …, stand before it."""

    start: str
    end: str
    open: bool = False


def is_composition(chain: n.Chain, frames: Collection[str]) -> bool:
    """Whether both sides of each equation lead from one frame to the same other, index by index.

    With one script above and one below, T_2^0 = T_1^0 T_2^1, the reference is that under which all names lead outwards. Where
    an arm has those frames, it is for the document to tell, and not for this law.
    """
    if len(chain.members) < 2 or set(chain.relations) != {"="} or _are_frames(chain, frames) or _mixes_kinds(chain):
        return False
    for reference in ("upper", "lower"):
        members = _with_whole(chain, reference)
        if not all(arguments_fit(member, reference) for member in members):
            continue
        ends = [_ends(member, reference) for member in members]
        tells = any(isinstance(bare(m), n.Product | n.Postfix) for m in chain.members)  # {}^B_AR = {}^A_BR^T
        if None not in ends and len(set(ends)) == 1 and tells:
            return True
    return False


def _with_whole(chain: n.Chain, reference: str) -> Sequence[n.Node]:
    """Return the members with R, the whole rotation that R_6^3 = (R_3^0)^T R is about, from the first frame named to the last."""
    named = [each for member in chain.members for each in n.names(member)]
    scripts = {script for each in named for script in each.scripts if script.isdigit()}
    if _WHOLE not in named or len(scripts) < FEWEST:
        return chain.members
    first, last = min(scripts, key=int), max(scripts, key=int)
    sup, sub = (first, last) if reference == "upper" else (last, first)
    whole: dict[int, n.Node] = {id(each): replace(each, sup=sup, sub=sub) for each in named if each == _WHOLE}
    return [n.substitute_each(member, whole) for member in chain.members]


def is_product_of_links(chain: n.Chain) -> bool:
    """Whether a name T^i_j is equated to a product A_1 A_2 of names with one index each, which tell of no direction themselves."""
    named = any(isinstance(node := bare(member), n.Name) and node.sub and node.sup for member in chain.members)
    return len(chain.members) == 2 and named and any(map(_is_of_links, chain.members))


def is_way_outwards(chain: n.Chain) -> bool:
    """Whether T_0^3 is equated to T_0^1 T_1^2 T_2^3: of three or more steps, each begins where the one before leads to."""
    sides = [[*_factors(member)] for member in chain.members]
    named = all(isinstance(each, n.Name) and each.sub and each.sup for side in sides for each in side)
    ends = {_ends(member, "lower") for member in chain.members}
    return (
        named
        and min(map(len, sides)) == 1
        and len(sides) == 2
        and max(map(len, sides)) >= FEWEST
        and len(ends - {None}) == 1 == len(ends)
    )


def _mixes_kinds(chain: n.Chain) -> bool:
    """Whether rotations, 3×3, stand among transforms, 4×4: no index tells what of their product is meant."""
    bases = {each.base for member in chain.members for each in n.names(member) if each.base in _TRANSFORMS}
    return "R" in bases and len(bases) > 1


def _is_of_links(node: n.Node) -> bool:
    factors = [*_factors(node)]
    plain = (isinstance(each, n.Name) and each.sub.isdigit() and not each.sup + each.pre_sup for each in factors)
    return len(factors) > 1 and all(plain)


def _are_frames(chain: n.Chain, frames: Collection[str]) -> bool:
    """Whether all names with one script above and one below are of frames that an arm has."""
    below = (each for member in chain.members for each in n.walk(member))
    scripts = [script for each in below if isinstance(each, n.Name) and each.sup for script in (each.sup, each.sub)]
    return bool(scripts) and all(script in frames for script in scripts)


def _ends(node: n.Node, reference: str) -> tuple[str, str] | None:
    """Return from which frame a product of transforms leads to which, None where its indices do not cancel."""
    steps = [*_steps([*_factors(node)], reference)]
    if None in steps or not steps:
        return None
    found = [step for step in steps if step is not None]
    turned = any(isinstance(below, n.Name) and below.base == "R" for below in n.walk(node))
    if turned and any(step.end in _POINTS for step in found):
        return None  # of a point a rotation alone does not tell where it is seen
    cancels = all(_follows(*pair) if pair[1].open else pair[0].end == pair[1].start for pair in pairwise(found))
    return (found[0].start, found[-1].end) if cancels and not found[0].open else None


def arguments_fit(node: n.Node, reference: str) -> bool:
    """Whether each letter that links are functions of is numbered as they are: not A_1^0(q_1) A_2^1(q_3)."""
    found = {*_numberings(node, reference)}
    return len(found) == len({letter for letter, _ in found})


def _numberings(node: n.Node, reference: str) -> Iterator[tuple[str, int]]:
    """Yield the letters that links are functions of, and how far their numbers are from those of the links."""
    for factor in map(bare, _factors(node)):
        pair = _pair(factor, reference)
        if pair is None or not isinstance(factor, n.Call) or _rank(pair[1]) != _rank(pair[0]) + 1:
            continue
        for each in factor.arguments[1:]:
            if isinstance(each, n.Name) and (rank := _rank(each.sub)) < _UNKNOWN:
                yield each.base, _rank(pair[1]) - rank


def _factors(node: n.Node) -> Iterator[n.Node]:
    """Yield the factors of a product from the left, those of {}^0T_1 × {}^1T_2 × {}^2T_3 as well."""
    node = bare(node)
    for each in node.factors if isinstance(node, n.Product) else ():
        yield from _factors(each)
    if not isinstance(node, n.Product):
        yield node


def _steps(factors: Sequence[n.Node], reference: str) -> Iterator[_Step | None]:
    is_open = False
    for factor in map(bare, factors):
        if isinstance(factor, n.Dots):
            is_open = True
            continue
        pair = _pair(factor, reference)
        yield _Step(*pair, is_open) if pair is not None else None
        is_open = False
    if is_open:
        yield None


def _follows(one: _Step, other: _Step) -> bool:
    """Whether factors between two links are those of the links between: T_0^1 T_1^2 … T_{n-1}^n."""
    ranks = [_rank(index) for index in (one.start, one.end, other.start, other.end)]
    return ranks[1] == ranks[0] + 1 <= ranks[2] and ranks[3] == ranks[2] + 1


def _pair(node: n.Node, reference: str) -> tuple[str, str] | None:
    """Return (reference, frame) of a transform or its inverse, with its joint variables or without: {}^0T_1(q_1)."""
    if n.is_call(node, "name"):
        node = node.arguments[0]
    if isinstance(node, n.Postfix) and node.operator in ("-1", "T"):
        inner = bare(node.base)
        of_rotation = isinstance(inner, n.Name) and inner.base == "R"
        is_point = isinstance(inner, n.Name) and inner.base in _POINTS
        pair = _pair(inner, reference) if (node.operator == "-1" and not is_point) or of_rotation else None
        return (pair[1], pair[0]) if pair is not None else None
    if (
        isinstance(node, n.Name)
        and node.base in _POINTS
        and node.pre_sup
        and node == n.Name(node.base, pre_sup=node.pre_sup)
    ):
        return node.pre_sup, node.base  # {}^0P = {}^0_3T {}^3P
    if not isinstance(node, n.Name) or node.base not in _TRANSFORMS or node.primes or node.dots:
        return None
    if node.pre_sup and not node.sup and bool(node.sub) != bool(node.pre_sub):
        return node.pre_sup, node.sub or node.pre_sub
    if node.pre_sup or node.pre_sub:
        return None
    if node.sup:
        pair = (node.sup, node.sub) if reference == "upper" else (node.sub, node.sup)
    elif (two := re.fullmatch(r"(\d),?(\d)", node.sub)) is not None:
        pair = two[1], two[2]
    else:
        pair = (
            (index_before(node.sub), node.sub) if node.base in "AH" and re.fullmatch(r"[1-9in]", node.sub) else ("", "")
        )
    return pair if _rank(pair[0]) < _rank(pair[1]) < _UNKNOWN else None


def index_before(index: str) -> str:
    """Return the index of the frame before: 1 of 2, i-1 of i."""
    return str(int(index) - 1) if index.isdigit() else f"{index}-1"


def _rank(index: str) -> int:
    """Return how far from the base a frame is, by its index: 0 < 1 < i < n-1 < n < E; _UNKNOWN where nothing tells."""
    if index in _ENDS:
        return _ENDS[index]
    found = _INDEX.fullmatch(index)
    if found is None:
        return _UNKNOWN
    first = int(found["digit"]) if found["digit"] else _FAR * " ijkn".index(found["letter"].lower())
    return first + int(f"{found['sign'] or '+'}{found['step'] or 0}")
