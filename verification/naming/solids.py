r"""Names of the kinematics of solids: \vec x_1, \overrightarrow{AB}, V_{B,2/0}, \Omega_{2/1}, where frame i moves with solid i."""

from __future__ import annotations

from collections.abc import Mapping

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.latex import nodes as n
from armproof.verification.latex.solids import ARROWS
from armproof.verification.patterns import regex

_AXES = {**dict(zip("xyz", "xyz", strict=True)), **dict(zip("ijk", "xyz", strict=True))}
_ARROWS = tuple(f"\\{arrow}" for arrow in ARROWS)
_OF_POINT = regex(r"(?P<torsor>t,)?(?:(?P<point>[A-Z](?:_\w)?),)?(?P<solid>\d)/(?P<seen>\d)")
_OF_PLACE = regex(r"(?P<point>[A-Z](?:_\w)?)/(?P<seen>\d)")
_TWO_POINTS = regex(r"[A-Z]{2}")
_TWO_ORIGINS = regex(r"(\d)to(\d)")


def solid_quantity(name: n.Name, arm: Arm, points: Mapping[str, Quantity]) -> Quantity | None:
    """Return what a name means where a document names solids by numbers, None where it is none of theirs; `points` are what it says of letters."""
    if name.sup or name.pre_sub or name.pre_sup or name.primes or name.dots:
        return None
    base = arm.frames[0]
    if name.base in _AXES and name.sub in arm.frames and name.text.startswith(_ARROWS):
        return Quantity("axis", name.sub, base, along=_AXES[name.base])
    if name.base in COMPONENTS and (place := _place(name.sub, arm, points)) is not None and not name.sub.isdigit():
        return Quantity("origin", place, base, rows=(COMPONENTS[name.base] + 1,), scalar=True)
    if _TWO_POINTS.fullmatch(name.base) and not name.sub:
        start, end = (_place(letter, arm, points) for letter in name.base)
        return Quantity("difference", end, base, start=start) if start is not None and end is not None else None
    if name.base == "O" and (two := _TWO_ORIGINS.fullmatch(name.sub)) and {*two.groups()} <= {*arm.frames}:
        return Quantity("difference", two[2], base, start=two[1])
    if name.base in ("V", "Omega", "omega") and "/" in name.sub:
        return _velocity(name, arm, points)
    return None


def _velocity(name: n.Name, arm: Arm, points: Mapping[str, Quantity]) -> Quantity | None:
    told = _OF_POINT.fullmatch(name.sub) or (_OF_PLACE.fullmatch(name.sub) if name.base == "V" else None)
    if told is None or (name.base == "V") != (told["point"] is not None):
        return None
    point = _place(told["point"], arm, points) if told["point"] else ""
    solid = told["solid"] if "solid" in told.re.groupindex else point
    if point is None or solid is None or solid not in arm.frames or told["seen"] not in arm.frames:
        return None
    rows: tuple[int, ...] = (1, 2, 3) if name.base == "V" else (4, 5, 6)
    if told.groupdict().get("torsor"):
        rows = (4, 5, 6, 1, 2, 3)
    return Quantity("solid_velocity", solid, arm.frames[0], rows=rows, start=told["seen"], point=point)


def _place(letter: str, arm: Arm, points: Mapping[str, Quantity]) -> str | None:
    """Return the frame at whose origin a point is: as the document says, that of O_2 else, and of O the first."""
    found = points.get(letter if letter.startswith("O") else f"O_{letter}")
    if found is not None:
        whole = found.kind == "origin" and found.rows is None and found.reference == arm.frames[0]
        return found.frame if whole else None
    if letter == "O":
        return arm.frames[0]
    index = letter.removeprefix("O_")
    return index if index != letter and index in arm.frames else None
