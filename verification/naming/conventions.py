"""Names that handouts use for an arm's quantities without saying so: what each may stand for, by its letter and indices.

A letter with few indices has several meanings: x_2 is a coordinate or an axis, J_{v2} a block or a column. All are given
here, the likelier first; what the name is equated to chooses among them (equations/conventional.py).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import is_planar
from armproof.verification.latex import nodes as n
from armproof.verification.naming.quantities import ANGULAR, LINEAR, numbered_frames
from armproof.verification.patterns import regex

END = frozenset("e E ee EE ef EF eff eef tool Tool tcp TCP end hand terminal endeffector effector".split())
PERHAPS_END = frozenset("P T t G g h H OT ot tip Tip".split())
LAST = frozenset("n N".split())
INNER_POINTS = frozenset("wrist Wrist elbow Elbow coude codo gomito cotovelo".split())  # which frame's, the value tells
WRIST = frozenset("W w WC wc".split())
TARGETS = frozenset("target goal des desired sym symbolic num".split())
POSITIONS = frozenset("p P o O r d t X x c".split())
_VECTORS = ("\\hat", "\\widehat", "\\vec", "\\overrightarrow")
POSES = frozenset("T H A M X g".split())
FUNCTIONS = frozenset("f F FK fk fkine DK MGD DGM h k".split())  # of q: the pose or the position of the tool
MODELS = frozenset(each for each in FUNCTIONS if len(each) > 1)  # names of the direct model, of nothing else
PARTS_OF_MODELS = {
    **dict.fromkeys(("pos", "position", "posit"), "origin"),
    **dict.fromkeys(("ori", "orient", "orientation", "rot", "R"), "rotation"),
}
LINEAR_VELOCITIES, ANGULAR_VELOCITIES = frozenset("v V".split()), frozenset("omega w W Omega".split())
TWISTS = frozenset("V xi nu eta t".split())
ORIENTATIONS = frozenset("phi varphi psi alpha gamma theta Phi".split())
MANIPULABILITIES = frozenset("w mu m M".split())
SPACE, BODY = frozenset(("s", "S", "space", "spatial")), frozenset(("b", "B", "body"))
ORDERS = ((4, 5, 6, 1, 2, 3), (1, 2, 3, 4, 5, 6))  # of a twist: ω above v, or below
PLANAR = frozenset("planar plane plan pl".split())
WHOLE_JACOBIAN = frozenset("geo G g".split())
USUAL = frozenset(
    "p P x y z X Y Z R T H J v V omega Omega phi varphi WC wc EE".split()
)  # seldom anything else, of an arm
AXES = "xyz"
_ENTRY_OF = regex(r"(\w+),([123])([123])")
NORMALS = "noa"  # the columns of the tool's rotation, of which a document may have others
COLUMNS = {"n": "x", "s": "y", "o": "y", "a": "z"}  # of a rotation: n_6^0, s_6^0, a_6^0
ENTRY = "r"
ENTRIES = frozenset((ENTRY, *NORMALS, "s"))  # of a rotation: in a matrix they mean what stands in their place
LETTERS = POSITIONS | POSES | LINEAR_VELOCITIES | ANGULAR_VELOCITIES | TWISTS | ORIENTATIONS | MANIPULABILITIES
LETTERS |= FUNCTIONS | frozenset(
    "R J O P Delta x y z X Y Z r n s o a WC wc EE".split()
)  # with a meaning; no other has one


def is_usual(name: n.Name) -> bool:
    """Whether a name is so common for a quantity of the arm that another value for it is worth a word."""
    is_point = name.base in ("t", "O", *COLUMNS) and name.sup == "0" and name.sub.isdigit()  # t_2^0, seen from the base
    usual = USUAL | MODELS
    if name.base in ORIENTATIONS and name.sub in END - {"e"}:  # θ_E; an index e may be of an error
        return True
    return (name.base in usual and name.sub not in PERHAPS_END) or "to" in name.sub or is_entry(name) or is_point


def reads_as_length(letter: str) -> bool:
    """Whether a letter that nothing binds is a length by its look, and so positive: l, l_1, a_2, d_i, a radius r or ρ."""
    return letter[:1] in ("l", "L") or letter[:2] in ("a_", "d_") or letter in ("r", "rho")


def conventional(name: n.Name, arm: Arm, transforms: str, normals: str = NORMALS) -> tuple[Quantity, ...]:
    """Return what a name may stand for on an arm by convention, the likelier first; nothing where it is no usual name.

    `normals` are the document's letters of the columns of the tool's rotation: sna in France, nsa, noa.
    """
    if name.base in normals and name.sub in tuple(AXES):
        name = replace(name, base=NORMALS[normals.index(name.base)])
    if name.base == "WC" and (name.pre_sub, name.pre_sup, name.sup) == ("0", "", ""):  # {}_0WC_x: seen from the base
        name = replace(name, pre_sub="", pre_sup="0")
    if name.sub in TARGETS and name.pre_sub and name.pre_sup:  # {}^0_ET_{target}: that of the joint angles asked for
        name = replace(name, sub="")
    if name.primes or (name.pre_sub and name.sub):
        return ()
    if name.base in ("WC", "wc", "EE"):  # the centre of the wrist, its x: p_{WC}, p_{WC,x}
        name = replace(name, base="p", sub=f"{name.base.upper()},{name.sub}".rstrip(","))
    is_centre = name.base in AXES and name == n.Name(name.base, "c")
    if is_centre:  # (x_c, y_c, z_c) of the wrist; p_c may be a centre of mass
        name = replace(name, sub="w")
    placed = bool(name.pre_sup or name.sup)
    if not placed:
        bases = dict.fromkeys((numbered_frames(arm)[0], arm.frames[0]))
        found = dict.fromkeys(each for base in bases for each in _unplaced(name, base, arm))
        return tuple(each for each in found if not (each.scalar and _is_vector(name)))
    first, index = name.pre_sup or name.sup, name.pre_sub or name.sub
    if name.sup and name.sub and transforms == "lower":
        first, index = index, first
    reference = _frame(first, arm)
    if reference is None or (name.pre_sup and name.sup) or (index != first and _frame(index, arm) == reference):
        return ()  # {}^3T_E where frame 3 is the last: a tool beyond it
    return tuple(dict.fromkeys(_all(name.base, index, reference, arm, True)))


def _is_vector(name: n.Name) -> bool:
    r"""Whether a letter of a coordinate is written as a vector: \hat{Z}_1 is an axis, and no height."""
    return name.base.lower() in AXES and len(name.base) == 1 and bool(name.sub) and name.text.startswith(_VECTORS)


def seen_from_wrist(name: n.Name, arm: Arm, transforms: str) -> tuple[Quantity, ...]:
    """Return what a transform seen from the wrist may be, {}^{WC}R_E: of which frame that is, its value has to tell."""
    first = name.pre_sup or (name.sub if transforms == "lower" and name.sup else name.sup)
    if first not in WRIST or name.base not in "TR":
        return ()
    frames = _wrists(arm)
    if name.pre_sup == first:
        seen = [replace(name, pre_sup=frame) for frame in frames]
    else:
        seen = [replace(name, sup=frame) if name.sup == first else replace(name, sub=frame) for frame in frames]
    return tuple(dict.fromkeys(quantity for one in seen for quantity in conventional(one, arm, transforms)))


def _unplaced(name: n.Name, reference: str, arm: Arm) -> Iterator[Quantity]:
    """Yield what a name that tells no frame of reference may stand for in one."""
    yield from _twists(name, reference, arm)
    if name.base in MODELS:
        kinds = (PARTS_OF_MODELS[name.sub],) if name.sub in PARTS_OF_MODELS else () if name.sub else ("pose", "origin")
        yield from (
            Quantity(kind, each, reference) for each in dict.fromkeys((_tool(arm), _last(arm))) for kind in kinds
        )
        return
    if is_entry(name) or (name.base in NORMALS and name.sub in tuple(AXES)):
        row, column = (
            (int(name.sub[0]), int(name.sub[-1]))
            if is_entry(name)
            else (AXES.index(name.sub) + 1, NORMALS.index(name.base) + 1)
        )
        for each in dict.fromkeys((_tool(arm), _last(arm))):
            yield Quantity("rotation", each, reference, rows=(row,), columns=(column,), scalar=True)
        return
    yield from _all(name.base, name.pre_sub or name.sub, reference, arm, False)


def is_entry(name: n.Name) -> bool:
    """Whether a name is r_{13}, an entry of a rotation."""
    return name.base == ENTRY and re.fullmatch("[123],?[123]", name.sub) is not None


def applied(name: n.Name, arm: Arm) -> tuple[Quantity, ...]:
    """Return what f(q) or FK(q) may stand for: the tool's position, its pose, or its position and orientation in a plane."""
    if name.base not in FUNCTIONS or name != n.Name(name.base):  # f'(q) is another function
        return ()
    tools, bases = dict.fromkeys((_tool(arm), _last(arm))), dict.fromkeys((numbered_frames(arm)[0], arm.frames[0]))
    kinds = ("origin", "pose", "task") if is_planar(arm) else ("origin", "pose")
    return tuple(Quantity(kind, frame, base) for base in bases for frame in tools for kind in kinds)


def _all(base: str, index: str, reference: str, arm: Arm, placed: bool) -> Iterator[Quantity]:
    between = re.fullmatch(r"(\w+)to(\w+)", index)
    if (
        between is not None
        and base in "OPp"
        and (start := _frame(between[1], arm))
        and (end := _frame(between[2], arm))
    ):
        yield Quantity("difference", end, reference, start=start)
        return
    entry = _ENTRY_OF.fullmatch(index) if base in ("R", ENTRY) else None
    if entry is not None and (frame := _frame(entry[1], arm)):  # {}^1R_{4,21}
        rows, columns = (int(entry[2]),), (int(entry[3]),)
        yield Quantity("rotation", frame, reference, rows=rows, columns=columns, scalar=True)
    if base == "J":
        yield from _quarters(index, reference, arm)  # of a whole arm; J_{11} is hardly that of frame 1 in frame 1
    if index in INNER_POINTS and base in (*AXES, *AXES.upper()):
        inner = (frame for frame in _wrists(arm) if frame != _last(arm))
        yield from (_component(Quantity("origin", frame, reference), base.lower()) for frame in inner)
    for frame, component, given in _indices(index, reference, arm):
        origin = Quantity("origin", frame, given)
        if component is None:
            yield from _of_frame(base, index, origin, arm, placed)
        elif base in POSITIONS:
            yield _component(origin, component)
        if given == reference:  # ω_{12} is that of a link relative to another
            yield from _velocities(base, frame, given, component)
        if base in LINEAR_VELOCITIES and component is None and is_planar(arm):
            yield Quantity("velocity", frame, given, rows=(1, 2, 6))  # (v_x, v_y, ω)
    if base == "J":
        yield from _blocks(index, reference, arm)
    kind = "manipulability" if base in MANIPULABILITIES else "determinant" if base == "Delta" else ""
    if kind and not index and not placed:
        yield from (Quantity(kind, frame, reference, scalar=True) for frame in dict.fromkeys((_last(arm), _tool(arm))))


def _of_frame(base: str, index: str, origin: Quantity, arm: Arm, placed: bool) -> Iterator[Quantity]:
    if base.lower() in AXES and len(base) == 1:
        yield _component(origin, base.lower())
    if base in POSITIONS:
        yield origin
        if base in ("X", "x", "p") and is_planar(arm):
            yield replace(origin, kind="task")
    if base.lower() in AXES and len(base) == 1 and index:
        yield replace(origin, kind="axis", along=base.lower())
    if base in COLUMNS and index and placed:
        yield replace(origin, kind="axis", along=COLUMNS[base])
    if base in POSES and (index or base in "THA"):
        yield replace(origin, kind="pose")
    if base == "R":
        yield replace(origin, kind="rotation")
    if base == "J" and (index or arm.frames[0] != numbered_frames(arm)[0]):
        yield replace(origin, kind="jacobian")
    if base in ORIENTATIONS and not placed and is_planar(arm):
        yield replace(origin, kind="angle", scalar=True)


def _velocities(base: str, frame: str, reference: str, component: str | None) -> Iterator[Quantity]:
    """v_i and ω_i as J_i q̇, whole or one component; of a planar arm ω is its z component."""
    for letters, first in ((LINEAR_VELOCITIES, 1), (ANGULAR_VELOCITIES, 4)):
        if base not in letters:
            continue
        if component is None:
            yield Quantity("velocity", frame, reference, rows=(first, first + 1, first + 2))
        if component is not None or first == 4:
            row = first + AXES.index(component or "z")
            yield Quantity("velocity", frame, reference, rows=(row,), scalar=True)
    if (base in TWISTS or base == "v") and component is None:
        yield Quantity("velocity", frame, reference)


def _blocks(index: str, reference: str, arm: Arm) -> Iterator[Quantity]:
    """J_{v2}, J_{ω_2}, J_{P_2}: the rows of one velocity in the Jacobian of a frame."""
    ends = tuple(dict.fromkeys((_last(arm), _tool(arm))))
    if index in WHOLE_JACOBIAN:
        yield from (Quantity("jacobian", frame, reference) for frame in ends)
    for letters, rows in (*((each, (1, 2, 3)) for each in LINEAR), *((each, (4, 5, 6)) for each in ANGULAR)):
        behind = index.removeprefix(letters).lstrip("_,")
        frames = (_frame(behind, arm),) if behind else ends
        for frame in filter(None, frames if index.startswith(letters) else ()):
            yield Quantity("jacobian", frame, reference, rows=rows)


def _quarters(index: str, reference: str, arm: Arm) -> Iterator[Quantity]:
    """J_{11} … J_{22}: the quarters of the Jacobian, v above ω, the joints of the wrist apart; without a wrist J_{11} and J_{21} alone.

    With a wrist J_{11} may be of its centre, which the last three joints do not move.
    """
    if not re.fullmatch("[12]{2}", index) or (index[1] == "2" and len(arm.joints) < 6):
        return
    rows, columns = (((1, 2, 3), (4, 5, 6))[int(digit) - 1] for digit in index)
    has_wrist = len(arm.joints) == 6
    for frame in (_last(arm), *(_wrists(arm) if has_wrist and index == "11" else ())):
        yield Quantity("jacobian", frame, reference, rows=rows, columns=columns if has_wrist else None)


def _twists(name: n.Name, reference: str, arm: Arm) -> Iterator[Quantity]:
    """J_s, J_b and the twists V_s, V_b of the tool in space and in its own frame; J_{planar}, whose rows are ω, v_x and v_y in some order."""
    index = name.pre_sub or name.sub
    for kind, in_space, letters in (("jacobian", "spatial_jacobian", {"J"}), ("velocity", "spatial_velocity", TWISTS)):
        if name.base in letters and index in SPACE | BODY:
            last = _last(arm)
            of = Quantity(in_space, last, reference) if index in SPACE else Quantity(kind, last, last)
            yield from (replace(of, rows=rows) for rows in ORDERS)
    if name.base == "J" and index in PLANAR and is_planar(arm):
        orders = ((1, 2, 6), (6, 1, 2), (1, 2))
        yield from (Quantity("jacobian", _last(arm), reference, rows=rows) for rows in orders)


def _indices(index: str, reference: str, arm: Arm) -> Iterator[tuple[str, str | None, str]]:
    """Yield (frame, component or None, reference) for the readings of an index: "", "2", "e,x", "x2", "02", "0→2"."""
    tools = dict.fromkeys((_tool(arm), _last(arm)))
    plain = re.sub(r",?(?:ORG|org|orig)$", "", index)
    if not index or plain in END | PERHAPS_END or plain in AXES:
        yield from ((frame, plain if plain in AXES and plain else None, reference) for frame in tools)
        return
    if (frame := _frame(plain, arm)) is not None:
        yield frame, None, reference
        return
    for frame in _wrists(arm) if plain.rstrip(AXES).rstrip(",") in WRIST else []:
        yield frame, plain[-1] if plain[-1] in AXES else None, reference
    for first, second in _splits(plain):
        if second in AXES and (frame := _frame(first, arm)) is not None:
            yield frame, second, reference
        elif first in AXES and (frame := _frame(second, arm)) is not None:
            yield frame, first, reference
        elif (start := _frame(first, arm)) is not None and (frame := _frame(second, arm)) is not None:
            yield frame, None, start


def _wrists(arm: Arm) -> list[str]:
    """Return the frames that may be that of the wrist, the likeliest first.

    Mostly it is where the last joint but one is; of three joints that move a point in space, at the end.
    """
    joints, from_the_end = len(arm.joints), numbered_frames(arm)[:0:-1]
    likely = str(joints if joints == 3 and not is_planar(arm) else joints - 1)
    return sorted(from_the_end, key=lambda frame: frame != likely)


def _splits(index: str) -> Iterator[tuple[str, str]]:
    """Yield the ways to cut an index in two: at its separator, or between any two letters."""
    parts = re.split(r",|_|-|to(?=\w)", index, maxsplit=1)
    if len(parts) == 2 and all(parts):
        yield parts[0], parts[1]
        return
    for place in range(1, len(index)):
        yield index[:place], index[place:]


def _frame(text: str, arm: Arm) -> str | None:
    if text in arm.frames:
        return text
    if text in LAST:
        return _last(arm)
    return _tool(arm) if text in END else None


def _tool(arm: Arm) -> str:
    return arm.frames[-1]


def _last(arm: Arm) -> str:
    return numbered_frames(arm)[-1]


def _component(quantity: Quantity, axis: str) -> Quantity:
    return replace(quantity, rows=(AXES.index(axis) + 1,), scalar=True)
