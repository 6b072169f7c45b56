"""What a name means on an arm: poses, origins, axes and Jacobians, as the front matter lists or notation implies."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.algebra.quantity_kinds import KINDS, QuantityKind, kind_of
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare


def read_quantity(key: str, spec: object, arm: Arm | None) -> Quantity:
    """Return the quantity that a front-matter entry describes; raises DocumentError with the valid choices."""
    if not isinstance(spec, Mapping) or len(named := [kind for name, kind in KINDS.items() if name in spec]) != 1:
        raise DocumentError(say(Kind.QUANTITY_OF_NO_KIND, quantity=key, kinds=list(KINDS), value=repr(spec)))
    (kind,) = named
    unknown = set(map(str, spec)) - kind.options - {kind.name}
    if unknown:
        valid = ", ".join(sorted(kind.options)) or "none"
        found = {"options": sorted(unknown), "kind_name": kind.name, "valid": valid}
        raise DocumentError(say(Kind.UNKNOWN_OPTION, quantity=key, **found))
    if kind.name == "link":
        return _link(key, spec)
    if arm is None:
        raise DocumentError(say(Kind.QUANTITY_WITHOUT_ARM, quantity=key))
    if kind.name == "vector":
        return Quantity("vector", "q")
    if kind.name == "joint":
        return _joint(key, str(spec["joint"]), arm)
    quantity = _of_frame(key, spec, kind, arm)
    if (problem := kind.problem(quantity, arm)) is not None:
        raise DocumentError(say(Kind.IN_QUANTITY, quantity=key, problem=problem))
    return quantity


def _link(key: str, spec: Mapping) -> Quantity:
    if spec["link"] not in ("classic", "modified"):
        raise DocumentError(say(Kind.UNKNOWN_LINK, quantity=key, value=repr(spec["link"])))
    rows, columns = (_indices(key, spec, option) for option in ("rows", "columns"))
    return Quantity("link", str(spec["link"]), rows=rows, columns=columns)


def _joint(key: str, symbol: str, arm: Arm) -> Quantity:
    symbols = [joint.symbol for joint in arm.joints]
    if symbol not in symbols:
        raise DocumentError(say(Kind.UNKNOWN_JOINT, quantity=key, joint=symbol, joints=symbols))
    return Quantity("joint", symbol, scalar=True)


def _of_frame(key: str, spec: Mapping, kind: QuantityKind, arm: Arm) -> Quantity:
    start, frame = "0", spec[kind.name]
    if kind.name == "difference":
        if not (isinstance(frame, list) and len(frame) == 2):
            raise DocumentError(say(Kind.NOT_TWO_FRAMES, quantity=key, value=repr(frame)))
        start = frame_name(arm, str(frame[1]), key)
        frame = frame[0]
    reference = frame_name(arm, str(spec["in"]), key) if "in" in spec else arm.frames[0]
    rows, columns = _indices(key, spec, "rows"), _indices(key, spec, "columns")
    width = kind.width or len(arm.joints)
    for indices, most, beyond in ((rows, kind.height, Kind.NO_SUCH_ROW), (columns, width, Kind.NO_SUCH_COLUMN)):
        if indices and max(indices) > most:
            raise DocumentError(say(beyond, quantity=key, kind_name=kind.name, most=most, index=max(indices)))
    along = str(spec.get("along", "z"))
    if along not in COMPONENTS:
        raise DocumentError(say(Kind.UNKNOWN_AXIS, quantity=key, value=repr(spec["along"])))
    homogeneous = bool(spec.get("homogeneous", False))
    name = frame_name(arm, str(frame), key)
    quantity = Quantity(kind.name, name, reference, rows, columns, along, start, kind.scalar, homogeneous)
    return _component(key, quantity, spec["component"]) if "component" in spec else quantity


def _component(key: str, quantity: Quantity, component: object) -> Quantity:
    if quantity.kind == "pose":
        if not (isinstance(component, list) and len(component) == 2 and all(c in (1, 2, 3, 4) for c in component)):
            raise DocumentError(say(Kind.NO_ROW_AND_COLUMN, quantity=key, value=repr(component)))
        return replace(quantity, rows=(component[0],), columns=(component[1],), scalar=True)
    if component not in COMPONENTS:
        raise DocumentError(say(Kind.UNKNOWN_COMPONENT, quantity=key, value=repr(component)))
    return kind_of(quantity).component(quantity, str(component))


def _indices(key: str, spec: Mapping, option: str) -> tuple[int, ...] | None:
    value = spec.get(option)
    if value is None:
        return None
    if isinstance(value, int):
        value = [value]
    if not (isinstance(value, list) and value and all(type(i) is int and 1 <= i <= 64 for i in value)):
        raise DocumentError(say(Kind.NO_INDICES, quantity=key, option=option, value=repr(value)))
    return tuple(value)


def frame_name(arm: Arm, name: str, key: str = "") -> str:
    """Return the arm's frame of that name; `n` is the last where no frame is called so."""
    if name in arm.frames:
        return name
    if name in ("n", "N"):
        return numbered_frames(arm)[-1]
    unknown = say(Kind.NO_SUCH_FRAME, frame=name, arm=arm.name, frames=list(arm.frames))
    raise DocumentError(say(Kind.IN_QUANTITY, quantity=key, problem=unknown) if key else unknown)


def numbered_frames(arm: Arm) -> list[str]:
    """The frames 0…n of the document, in order."""
    return [frame for frame in arm.frames if frame.isdigit()] or list(arm.frames)


def implied_quantity(name: n.Name, arm: Arm, transforms: str) -> Quantity | None:
    """Return what `{}^iT_j`, `T^i_j`, `A_i`, `p_i`, `z_i`, `J` and their like mean without being listed, or None."""
    if name.primes or name.dots:
        return None
    base = name.base
    if base in ("T", "A", "H", "R"):
        return _implied_transform(name, arm, transforms)
    if base in ("p", "P", "o", "O", "d", "z", "Z", "x", "X", "y", "Y"):
        return _implied_vector(name, arm, transforms)
    if base == "J":
        return _implied_jacobian(name, arm)
    return None


def _frame(arm: Arm, text: str) -> str | None:
    if text in arm.frames:
        return text
    return numbered_frames(arm)[-1] if text in ("n", "N") else None


def transform_pair(name: n.Name, arm: Arm, transforms: str) -> tuple[str, str] | None:
    """Return (reference, frame) as the indices of a transform's name say, whether the arm has such frames or not."""
    if name.pre_sup and name.pre_sub and not name.sub and not name.sup:
        return (name.pre_sup, name.pre_sub)
    if name.pre_sup and name.sub and not name.sup and not name.pre_sub:
        return (name.pre_sup, name.sub)
    if name.sub and name.sup and not name.pre_sub and not name.pre_sup:
        return (name.sup, name.sub) if transforms == "upper" else (name.sub, name.sup)
    if name.sub and not (name.sup or name.pre_sub or name.pre_sup):
        two = re.fullmatch(r"(\w),?(\w)", name.sub)
        frame = _frame(arm, name.sub)
        if two and not (frame and name.base in "AH"):
            return (two.group(1), two.group(2))
        if name.base in ("A", "H") and frame and frame.isdigit():
            frames = numbered_frames(arm)
            index = frames.index(frame)
            return (frames[index - 1], frame) if index > 0 else None
    return None


def tells_frame(name: n.Name, quantity: Quantity) -> bool:
    """Whether the indices of a name say of which frame its quantity is: the 3 of p_3, the E of x_E; those of r_{13} are its place."""
    below = (
        () if quantity.rows and quantity.columns else (name.sub.partition("rows ")[0], name.pre_sub)
    )  # without those of J that are read
    scripts = (*below, name.sup, name.pre_sup)
    return quantity.frame in scripts or any(one.isdigit() for one in "".join(scripts))


def leads_outwards(name: n.Name, arm: Arm, transforms: str) -> bool:
    """Whether an index above and one below lead from a frame to one that is farther from the base, as link matrices do."""
    pair = transform_pair(name, arm, transforms) if name.sub and name.sup else None
    first, last = (_frame(arm, each) for each in pair) if pair is not None else (None, None)
    return first is not None and last is not None and arm.frames.index(first) < arm.frames.index(last)


def is_inverse_link(node: n.Node, transforms: str) -> bool | None:
    """Whether a tree is the inverse of a link matrix of any link, {}^{i-1}T_i, T_i^{i-1}, A_i; None where it is neither."""
    node = bare(node)
    if isinstance(node, n.Postfix) and node.operator == "-1":
        inner = is_inverse_link(node.base, transforms)
        return None if inner is None else not inner
    node = _of_its_parameters(node)
    if not isinstance(node, n.Name) or node.base not in ("T", "A", "H") or node.primes or node.dots:
        return None
    before, _, last = node.sub.rpartition(",")
    if node.pre_sup and (node.sub or node.pre_sub) and not node.sup:
        pair = (node.pre_sup, node.sub or node.pre_sub)
    elif node.sub and node.sup:
        pair = (node.sup, node.sub) if transforms == "upper" else (node.sub, node.sup)
    elif before and not (node.sup or node.pre_sup or node.pre_sub):  # T_{i-1,i}; T_{i,i-1} may be either
        pair = (before, last) if before.endswith("-1") else ("", "")
    else:
        pair = ("i-1", node.sub) if not node.sup and not node.pre_sup else ("", "")
    i = next((letter for letter in "jkn" if f"{letter}-1" in pair), "i")  # an A_n alone may be the last link's
    return {(f"{i}-1", i): False, (i, f"{i}-1"): True}.get(pair)


_ALL_JOINTS = ("q", "theta", "Theta")


def _of_its_parameters(node: n.Node) -> n.Node:
    """Return the A_i of A_i(θ_i, d_i, α_i, a_i), which is of all four, and of A_i(q_i), A_i(θ_i) and A_i(Θ): what is of some lengths is another matrix."""
    if not n.is_call(node, "name"):
        return node
    name, *given = node.arguments
    if len(given) == 1 and isinstance(given[0], n.Name) and given[0].key in _ALL_JOINTS:
        return name
    bases = sorted(each.base for each in given if isinstance(each, n.Name) and each.sub)
    return name if bases in (["a", "alpha", "d", "theta"], ["a", "alpha", "d", "q"], ["q"], ["theta"]) else node


def _implied_transform(name: n.Name, arm: Arm, transforms: str) -> Quantity | None:
    pair = transform_pair(name, arm, transforms)
    if pair is None:
        return None
    reference, frame = _frame(arm, pair[0]), _frame(arm, pair[1])
    if reference is None or frame is None:
        return None
    return Quantity("rotation" if name.base == "R" else "pose", frame, reference)


def _implied_vector(name: n.Name, arm: Arm, transforms: str) -> Quantity | None:
    if name.pre_sub or (name.pre_sup and name.sup):
        return None
    above, below = name.pre_sup or name.sup, re.sub(r"(?<=\w),?(?:ORG|org|orig)$", "", name.sub)  # Craig's P_{3ORG}
    reference, sub = (below, above) if name.sup and transforms == "lower" else (above, below)
    frame = _frame(arm, sub)
    if frame is None:
        return None
    first = numbered_frames(arm)[0]
    if not reference:
        if name.base not in ("p", "z", "o", "O") or first != arm.frames[0]:  # in frame 0, or in that of the base?
            return None
        resolved: str | None = first
    else:
        resolved = _frame(arm, reference)
    if resolved is None:
        return None
    if name.base in ("p", "P", "o", "O", "d"):
        return Quantity("origin", frame, resolved)
    return Quantity("axis", frame, resolved, along=name.base.lower())


LINEAR, ANGULAR = ("v", "L", "P", "p", "l", "lin"), ("omega", "A", "O", "o", "w", "ang", "a")


def _implied_jacobian(name: n.Name, arm: Arm) -> Quantity | None:
    frames = numbered_frames(arm)
    reference = name.pre_sup or name.sup
    if name.pre_sub or (name.pre_sup and name.sup):
        return None
    resolved = _frame(arm, reference) if reference else frames[0]
    if resolved is None or (not reference and frames[0] != arm.frames[0]):
        return None
    if not name.sub or (name.sub == "n" and "n" not in arm.frames):
        return Quantity("jacobian", frames[-1], resolved)
    if name.sub in LINEAR:
        return Quantity("jacobian", frames[-1], resolved, rows=(1, 2, 3))
    if name.sub in ANGULAR:
        return Quantity("jacobian", frames[-1], resolved, rows=(4, 5, 6))
    return None
