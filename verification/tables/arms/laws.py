"""The arm that a law of cosines pins: (x² + y² − l_1² − l_2²)/(2 l_1 l_2) is the cosine of the joint between two links."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import permutations, product

from armproof.verification.algebra.calculus import angles_in, derivative, substitute, symbols_in
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Display, Document
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.moving import place_of
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate, entry_text, renamed, symbol_of
from armproof.verification.tables.arms.letters import equations_of, value_in_letters

_JOINT = regex(r"(theta|q)_(\d+)")
_LENGTH = regex(r"[lLadr]_?\w+")
_COORDINATE = regex(r"(?:([A-Za-z]+)_(\w*?),?)?([xyzXYZ])(?:_(\w+))?('*)")
_PLAIN = ("x", "y", "z", "X", "Y", "Z", "p_x", "p_y", "p_z", "P_x", "P_y", "P_z")  # the tool's, by convention
_FLAT = {"a": "0", "alpha": "0", "d": "0"}
SECONDS = 0.3


@dataclass(frozen=True)
class _Law:
    """What a law says: which joint turns between which two links, and where these lead to.

    Attributes:
        point: the names of the coordinates of the second link's end, in the plane of the links or in space.
        height: that of the first link's beginning, in space.
        hand: the length of a third link behind the point, where the document tells one.
        tool: the names of that link's end and direction.
    """

    joint: str
    links: tuple[Scalar, Scalar]
    point: tuple[str, ...]
    height: Scalar
    display: Display
    hand: str = ""
    tool: tuple[str, ...] = ()


def candidate_of_law(document: Document, names: Names) -> Candidate | None:
    """Return the arm of the first law of cosines for one of a document's joints, or None."""
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        reader = _Reader(document, names, algebra)
        law = next(reader.laws(), None)
        law = reader.with_hand(law) if law is not None else None
    with suppress(EvaluationError):  # what is no length of a DH table: (z - h²)²
        return _arm(law) if law is not None else None
    return None


def with_point_of_law(found: Candidate, document: Document, names: Names) -> Candidate:
    """Return the arm of a closed form with the names that its law of cosines has for the tool: x_d where x is given.

    Names that stand beside those of the tool are another point's.
    """
    law = candidate_of_law(document, names)
    if law is None or found.frames or not law.quantities:
        return found
    links = {(row["a"], joint) for row, joint in zip(found.rows, found.joints, strict=True)}
    if not links >= {(row["a"], joint) for row, joint in zip(law.rows, law.joints, strict=True)}:
        return found
    for display in document.displays:
        used = {below.key for chain in equations_of(display, names) for m in chain.members for below in n.names(m)}  # fmt: skip
        if used & set(law.quantities) and used & {*_PLAIN, *found.quantities}:
            return found
    return replace(found, quantities={**law.quantities, **found.quantities})


def _arm(law: _Law) -> Candidate | None:
    letter, number = law.joint.split("_")
    in_space = len(law.point) == 3
    first = int(number) - (2 if in_space else 1)
    if first < 0:
        return None
    joints = [f"{letter}_{first + k}" for k in range(3 if in_space or law.hand else 2)]
    turned = [{**_FLAT, "d": entry_text(law.height), "alpha": "pi/2"}] if in_space else []
    lengths = [*map(entry_text, law.links), *map(symbol_of, filter(None, [law.hand]))]
    bodies = [*turned, *({**_FLAT, "a": length} for length in lengths)]
    rows = tuple({**body, "theta": joint} for body, joint in zip(bodies, joints, strict=True))
    last = max(first, 1) - 1 + len(rows)
    placed = [(key, axis, last - bool(law.hand)) for key, axis in zip(law.point, "xyz", strict=False)]
    placed += [(key, axis, last) for key, axis in zip(law.tool[:2], "xy", strict=False)]
    named: dict[str, dict[str, object]] = {
        key: {"origin": frame, "component": axis}
        for key, axis, frame in placed
        if key not in _PLAIN or key[-1].lower() != axis
    }
    named |= {key: {"angle": last} for key in law.tool[2:]}
    links = [*sorted(symbols_in(law.links), key=place_of), *filter(None, [law.hand])]
    letters = [n.Name(base, sub, text=link) for link in links for base, _, sub in [link.partition("_")]]
    place = (law.display.cell, law.display.line)
    return Candidate(
        "closed form", place[1], place[0], rows, tuple(joints), renamed(letters), ("classic",), (place,), (), named,
        told_by=joints[1 if in_space else 0],
    )  # fmt: skip


@dataclass
class _Reader:
    """The laws of cosines of a document, with what it says of the letters in them.

    Attributes:
        squares, letters: r² = x² + y², and s = z − d_1, by r and s.
        cosines: D → the joint that an equation gives by it.
        given: what equations say of names alone, joints and coordinates among them.
    """

    document: Document
    names: Names
    algebra: ExactAlgebra
    squares: dict[str, Scalar] = field(default_factory=dict)
    letters: dict[str, Scalar] = field(default_factory=dict)
    cosines: dict[str, str] = field(default_factory=dict)
    given: dict[str, list[Scalar]] = field(default_factory=dict)

    def with_hand(self, law: _Law) -> _Law:
        """Return a law in a plane with the link behind its point: x_w = x - l_3 cos φ, y_w = y - l_3 sin φ, θ_3 = φ - θ_1 - θ_2."""
        letter, number = law.joint.split("_")
        joints = [self.algebra.ring.symbol(f"{letter}_{int(number) + k}") for k in (-1, 0, 1)]
        values = [self.given.get(key, []) for key in law.point]
        if len(law.point) != 2 or any(len(each) != 1 for each in values):
            return law
        (u,), (v,) = values
        angles = angles_in(u) & angles_in(v)
        third = self.given.get(f"{letter}_{int(number) + 1}", [])
        for direction in angles if len(angles) == 1 and len(third) == 1 else ():
            angle = self.algebra.ring.symbol(direction)
            if self.given.get(direction) or not (third[0] + joints[0] + joints[1] - angle).normal().is_zero():
                continue
            for length, x, y in product(
                sorted(symbols_in([u]) & symbols_in([v]) - angles), symbols_in([u]), symbols_in([v])
            ):
                a, cosine, sine = self.algebra.ring.symbol(length), *self.algebra.cos_sin(angle)
                ends = (self.algebra.ring.symbol(x) - a * cosine - u, self.algebra.ring.symbol(y) - a * sine - v)
                if len({length, x, y}) == 3 and all(each.normal().is_zero() for each in ends):
                    return replace(law, hand=length, tool=(x, y, direction))
        return law

    def laws(self) -> Iterator[_Law]:
        """Yield the laws in their order."""
        chains = [(display, chain) for display in self.document.displays for chain in equations_of(display, self.names)]
        for _, chain in chains:
            self._heed(chain)
        for display, chain in chains:
            joint = self._joint_of(chain.members[0])
            for node in (each for member in chain.members[1:] for each in n.walk(member)) if joint else ():
                if isinstance(node, n.Quotient) and (found := self._law(node, joint, display)) is not None:
                    yield found

    def _heed(self, chain: n.Chain) -> None:
        """Remember what an equation says of a letter."""
        left, right = map(bare, chain.members[:2])
        if isinstance(left, n.Power) and isinstance(left.exponent, n.Number) and left.exponent.value == 2:
            if (key := bare_key(left.base)) and (value := self._value(right)) is not None:
                self.squares.setdefault(key, value)
            return
        key, joint = bare_key(left), self._joint(left)
        if key and len(chain.members) == 2 and (value := self._value(right)) is not None:
            self.given.setdefault(key, []).append(value)
        if joint:
            used = (bare_key(below) for below in n.names(right))
            self.cosines.update({each: joint for each in used if each and each not in self.cosines})
        elif key and _COORDINATE.fullmatch(key) is None and (value := self._value(right)) is not None:
            square = (value * value).normal()
            if not _is_polynomial(value) and _is_polynomial(square):
                self.squares.setdefault(key, square)
            elif _is_polynomial(value):
                self.letters.setdefault(key, value)

    def _joint_of(self, left: n.Node) -> str:
        """Return the joint of which a side is the angle, the cosine, or a letter for that."""
        return self._joint(bare(left)) or self.cosines.get(bare_key(left) or "", "")

    def _joint(self, node: n.Node) -> str:
        """Return the joint whose angle or cosine this is."""
        if n.is_call(node, "cos") and len(node.arguments) == 1:
            node = bare(node.arguments[0])
        if isinstance(node, n.JointAngles) and len(node.terms) == 1:
            return f"{self.names.reader.spelling.angle}_{node.terms[0][1]}"
        key = bare_key(node) or ""
        return key if _JOINT.fullmatch(key) else ""

    def _value(self, node: n.Node) -> Scalar | None:
        evaluated = value_in_letters(node, self.names, self.algebra)
        return evaluated[0].normal() if evaluated is not None and isinstance(evaluated[0], Scalar) else None

    def _law(self, node: n.Quotient, joint: str, display: Display) -> _Law | None:
        """Return the law that a quotient is: the square of a distance without those of two lengths, by twice their product."""
        value = self._value(node)
        lengths = self._lengths(node, value) if value is not None else []
        for a, b in permutations(lengths, 2):
            square = (value * a * b * 2 + a * a + b * b).normal() if value is not None else None
            if square is None or not _is_polynomial(square) or symbols_in([a, b]) & symbols_in([square]):
                continue
            square = self._with_meanings(square)
            if (found := self._point(square) or self._point_before_hand(square)) is not None:
                return _Law(joint, (a, b), *found, display)
        return None

    def _lengths(self, node: n.Quotient, value: Scalar) -> list[Scalar]:
        """Return what may be the length of a link: a letter, or a sum of letters by which is divided, l_3 + l_4."""
        letters = sorted(filter(_LENGTH.fullmatch, symbols_in([value])), key=place_of)
        below = bare(node.denominator)
        factors = [bare(each) for each in (below.factors if isinstance(below, n.Product) else ())]
        sums = [self._value(each) for each in factors if isinstance(each, n.Sum)]
        of_letters = [each for each in sums if each is not None and symbols_in([each]) <= set(letters)]
        return [*map(self.algebra.ring.symbol, letters), *of_letters]

    def _with_meanings(self, square: Scalar) -> Scalar:
        """Return the square of a distance with letters for what the document says they are: r² + s² = x² + y² + (z − d_1)²."""
        met: set[str] = set()
        while (new := symbols_in([square]) - met) and (key := min(new)):  # b² = e² + c², where e² = x² + y²
            met.add(key)
            letter = self.algebra.ring.symbol(key)
            rest = (square - letter * letter).normal()
            if key in self.squares and key not in symbols_in([rest]):
                square = (rest + self.squares[key]).normal()
            elif key in self.letters:
                square = substitute(square, {key: self.letters[key]}).normal()
        return square

    def _point_before_hand(self, square: Scalar) -> tuple[tuple[str, ...], Scalar] | None:
        """Return the letters of a wrist in the plane whose squares these are: e² + c², where e = P_x − l_3 cos φ."""
        ring, keys = self.algebra.ring, sorted(symbols_in([square]))
        total = sum((ring.symbol(key) * ring.symbol(key) for key in keys), ring.zero)
        given = {key: self.given.get(key, []) for key in keys}
        if len(keys) != 2 or any(len(each) != 1 for each in given.values()) or not (square - total).normal().is_zero():
            return None
        turned = {key: substitute(value, dict.fromkeys(angles_in(value), ring.zero)) for key, (value,) in given.items()}
        axes = [key for key in keys if not (turned[key] - given[key][0]).normal().is_zero()]
        along = [key for key in axes if len(symbols_in([turned[key]])) > 1]  # cos 0 leaves the length of the hand
        return (
            ((along[0], next(key for key in keys if key != along[0])), ring.zero)
            if len(along) == 1 == len(axes) - 1
            else None
        )

    def _point(self, square: Scalar) -> tuple[tuple[str, ...], Scalar] | None:
        """Return the names of the coordinates whose squares these are, and the height from which the last one counts."""
        found = {key: match for key in symbols_in([square]) if (match := _COORDINATE.fullmatch(key)) is not None}
        keys = sorted(found, key=lambda key: found[key][3].lower())
        axes = [found[key][3].lower() for key in keys]
        if len({found[key].group(1, 2, 4, 5) for key in keys}) != 1 or len(set(axes)) != len(axes):
            return None
        symbols = [self.algebra.ring.symbol(key) for key in keys]
        if len(keys) not in (2, 3) or not _is_polynomial(square):
            return None
        *level, last = symbols
        zero = self.algebra.ring.zero
        height = -substitute(derivative(square, last), dict.fromkeys(keys, zero)) / 2 if len(keys) == 3 else zero
        rest = square - sum((each * each for each in level), zero) - (last - height) * (last - height)
        return (tuple(keys), height.normal()) if rest.normal().is_zero() else None


def _is_polynomial(value: Scalar) -> bool:
    """Whether a value is a sum of products of letters."""
    return value.denominator.is_one() and all(kind == "symbol" for kind, _ in value.generators)
