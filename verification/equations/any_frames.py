"""The laws by which frames change coordinates, p^0 = R_1^0 p^1 + d_1^0 and blocks of poses: they hold of any frames, or of none."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial, reduce
from typing import Any

from armproof.verification.algebra.matrix import Matrix, column, pose_of
from armproof.verification.algebra.protocol import Value, elementary, identity
from armproof.verification.algebra.ring import Ring
from armproof.verification.equations.chain import ChainChecker, no_samples
from armproof.verification.errors import EvaluationError, NotSampled, TooComplex
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import read_names
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

_POSES, _ROTATIONS, _ORIGINS, _POINTS = "THAg", "R", "dpotP", "pPr"
_FRAME = regex(r"[0-6]|[A-Z]|i|j|k|[in][+-]1|n|[a-z]")
MOST_FRAMES = 3  # a product of more free rotations has thousands of terms
DIRECTIONS = ("upper", "lower")
SECONDS = 0.3


@dataclass(frozen=True)
class _Meaning:
    """What a name is of frames: its kind, the frame in which it is seen, and the frame or the point that is seen."""

    kind: str
    seen_from: str
    of: str

    @property
    def frames(self) -> tuple[str, ...]:
        """The frames that it speaks of."""
        return (self.seen_from,) if self.kind == "point" else (self.seen_from, self.of)


def direction_of_any_frames(names: Names, chain: n.Chain) -> str | None:
    """Return the index that names the reference where a chain then holds of any frames; None where none does.

    The first one that is told is that of all: a document that turns its indices round has slipped. Numbered frames are seen
    from the base, so that a name leads outwards at least; of others the upper index is the reference.
    """
    chain = replace(chain, members=tuple(map(_seen, chain.members)))
    if len(chain.members) < 2 or set(chain.relations) != {"="} or not any(map(_composes, chain.members)):
        return None
    below = (each for member in chain.members for each in n.names(member))
    written = {each.key: each for each in below if each.key != "I"}
    own = set(names.arm.frames) if names.arm is not None else set()
    for direction in [names.state.transforms] if names.state.transforms else DIRECTIONS:
        found = meanings(written, direction)
        frames = {frame for each in found.values() for frame in each.frames}
        is_read = len(found) == len(written) and 2 <= len(frames) <= MOST_FRAMES and not frames & own
        if is_read and _leads_outwards(written, found, direction) and _holds(chain, found, sorted(frames)):
            return direction
    return None


def _leads_outwards(written: Mapping[str, n.Name], found: Mapping[str, _Meaning], direction: str) -> bool:
    """Whether a name of numbered frames is seen from the one nearer to the base; names with scripts in front tell themselves."""
    pairs = [each.frames for key, each in found.items() if len(each.frames) == 2 and not written[key].pre_sup]
    numbered = [pair for pair in pairs if all(map(str.isdigit, pair))]
    return any(one < other for one, other in numbered) if numbered else not pairs or direction == "upper"


def _seen(node: n.Node) -> n.Node:
    """Return a side with p seen from frame 1 for each p^1, which is no power there."""
    for below in [*n.walk(node)]:
        if (
            isinstance(below, n.Power)
            and isinstance(name := bare(below.base), n.Name)
            and name.base in _POINTS + _ORIGINS
        ):
            above = bare(below.exponent)
            frame = above.text if isinstance(above, n.Number) else above.key if isinstance(above, n.Name) else ""
            if _FRAME.fullmatch(frame) and not (name.sup or name.pre_sup):
                node = n.substitute(node, below, replace(name, sup=frame))
    return node


def _composes(node: n.Node) -> bool:
    return isinstance(bare(node), n.Product | n.Sum | n.Matrix | n.Postfix | n.Power)


def meanings(written: Mapping[str, n.Name], direction: str) -> dict[str, _Meaning]:
    """Return what names are of frames, by their indices; those that are none of these are left out."""
    pairs = {key: pair for key, name in written.items() if (pair := _pair(name, direction)) is not None}
    turned = {frame for key, pair in pairs.items() if written[key].base in _POSES + _ROTATIONS for frame in pair}
    found = {
        key: _of_pair(name, pairs[key], turned) if key in pairs else _of_one(name, turned)
        for key, name in written.items()
    }
    return {key: each for key, each in found.items() if each is not None}


def _of_pair(name: n.Name, pair: tuple[str, str], turned: Set[str]) -> _Meaning | None:
    """Return what a name with two indices is: p_1^0 is the origin of a frame, r_P^G a point that is none."""
    if name.base in _POSES + _ROTATIONS:
        return _Meaning("pose" if name.base in _POSES else "rotation", *pair)
    if pair[1] in turned or pair[1].isdigit():
        return _Meaning("origin", *pair) if name.base in _ORIGINS else None
    return _Meaning("point", *pair) if name.base in _POINTS else None


def _of_one(name: n.Name, turned: Set[str]) -> _Meaning | None:
    """Return what a name is that tells where it is seen from alone: a point, or the origin of the only other frame."""
    seen, others = name.pre_sup or name.sup, turned - {name.pre_sup or name.sup}
    if name != n.Name(name.base, sup=name.sup, pre_sup=name.pre_sup) or not (_FRAME.fullmatch(seen)):
        return None
    if name.base in _POINTS:
        return _Meaning("point", seen, "")
    return _Meaning("origin", seen, *others) if name.base in _ORIGINS and len(others) == 1 and seen in turned else None


def _is_plain(name: n.Name) -> bool:
    return not (name.primes or name.dots)


def _pair(name: n.Name, direction: str) -> tuple[str, str] | None:
    """Return (seen from, frame) of a name with two indices."""
    above, below = name.pre_sup or name.sup, re.sub("ORG$", "", name.pre_sub or name.sub)
    if (name.pre_sup and name.sup) or (name.pre_sub and name.sub) or not _is_plain(name):
        return None
    if not (_FRAME.fullmatch(above) and _FRAME.fullmatch(below)):
        return None
    return (above, below) if name.pre_sup or direction == "upper" else (below, above)


def _holds(chain: n.Chain, found: Mapping[str, _Meaning], frames: Sequence[str]) -> bool:
    """Whether a chain is proved of frames that stand anywhere, each turned freely against the one before."""
    names, algebra = read_names(None, {}), ExactAlgebra(Ring(), None)
    checker = ChainChecker(names, algebra, no_samples)
    checker.confirm = False  # there is no plant of frames that stand anywhere
    try:
        with algebra.budget.of(SECONDS):
            any_frames = _AnyFrames(algebra, frames)
            for key, meaning in found.items():
                names.define(key, partial(_constant, any_frames.value(meaning)))
            outcomes = checker.check(chain, 1, 0, define=False)
    except (EvaluationError, NotSampled, TooComplex):
        return False
    return bool(outcomes) and all(outcome.verdict is Verdict.PROVED for outcome in outcomes)


def _constant(value: Value, _algebra: object) -> Value:
    return value


class _AnyFrames:
    """Frames that stand anywhere, and points that are anywhere, by letters that nothing else has."""

    def __init__(self, algebra: Any, frames: Sequence[str]) -> None:
        self.algebra = algebra
        turn, origin = identity(algebra, 3), column([algebra.rational(Fraction(0))] * 3)
        self.frames = {frames[0]: (turn, origin)}
        for frame in frames[1:]:
            origin = origin + turn @ self._letters(f"origin of {frame}")
            turn = turn @ self._turn(frame)
            self.frames[frame] = turn, origin

    def value(self, meaning: _Meaning) -> Value:
        """Return what a name is of these frames."""
        turn, origin = self.frames[meaning.seen_from]
        if meaning.kind == "point":
            return turn.transpose @ (self._letters(f"point {meaning.of}") + -origin)
        other_turn, other_origin = self.frames[meaning.of]
        rotation, place = turn.transpose @ other_turn, turn.transpose @ (other_origin + -origin)
        if meaning.kind != "pose":
            return rotation if meaning.kind == "rotation" else place
        one, zero = self.algebra.rational(Fraction(1)), self.algebra.rational(Fraction(0))
        return pose_of(rotation, place, zero, one)

    def _letters(self, what: str) -> Matrix:
        return column([self.algebra.symbol(f"{axis} of the {what}") for axis in "xyz"])

    def _turn(self, frame: str) -> Matrix:
        """Return any rotation: by three angles, about z, y and x."""
        angles = {axis: self.algebra.symbol(f"angle of {frame} about {axis}") for axis in "zyx"}
        turns = [
            elementary(self.algebra, "Rot", axis, angle).block(range(3), range(3)) for axis, angle in angles.items()
        ]
        return reduce(Matrix.__matmul__, turns)
