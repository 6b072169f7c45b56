"""What a document's front matter says of its inverse kinematics: the target, and the order of the joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.naming.names import Names, name_key
from armproof.verification.naming.quantities import read_quantity

OPTIONS = ("target", "solve")
_WHOLE = ("pose", "rotation", "origin")
_EXAMPLE = "target: [X, Y, psi], or target: {pose: 6}"


@dataclass(frozen=True)
class TargetPart:
    """One name of the target, or the quantity that is the whole of it.

    Attributes:
        name: as the front matter spells it.
        key: the name as displays are read, "" for a quantity without a name.
        quantity: what it is on the arm; None for a name that a display defines.
    """

    name: str
    key: str
    quantity: Quantity | None


@dataclass(frozen=True)
class InverseClaim:
    """The front matter's `inverse`: what is given, and which joints are solved in which order (empty: as displayed)."""

    target: tuple[TargetPart, ...]
    joints: tuple[str, ...] = ()


def read_claim(spec: object, arm: Arm | None, names: Names) -> InverseClaim:
    """Return the claim of a front-matter entry `inverse: {target: …, solve: …}`.

    Raises:
        DocumentError: an unknown key, target or joint, with the valid choices.
    """
    if arm is None:
        raise DocumentError(say(Kind.INVERSE_WITHOUT_ARM), "inverse")
    if not isinstance(spec, Mapping) or "target" not in spec:
        raise DocumentError(say(Kind.INVERSE_OF_NOTHING, example=_EXAMPLE, value=repr(spec)), "inverse")
    unknown = [str(key) for key in spec if key not in OPTIONS]
    if unknown:
        raise DocumentError(say(Kind.UNKNOWN_INVERSE_OPTION, unknown=unknown, options=list(OPTIONS)), "inverse")
    return InverseClaim(_read_target(spec["target"], arm, names), _read_order(spec.get("solve"), arm, names))


def _read_target(spec: object, arm: Arm, names: Names) -> tuple[TargetPart, ...]:
    if isinstance(spec, Mapping):
        if not any(kind in spec for kind in _WHOLE):
            raise DocumentError(say(Kind.UNKNOWN_TARGET, targets=list(_WHOLE)), "inverse")
        return (TargetPart("the target", "", _read_whole(spec, arm)),)
    listed = [spec] if isinstance(spec, str) else spec
    if not (isinstance(listed, list) and listed and all(isinstance(name, str) for name in listed)):
        raise DocumentError(say(Kind.NO_TARGET, example=_EXAMPLE, value=repr(spec)), "inverse")
    keys = [_key(names, str(name)) for name in listed]
    if len(set(keys)) < len(keys):
        raise DocumentError(say(Kind.NAME_TWICE, target=repr(listed)), "inverse")
    return tuple(TargetPart(str(name), key, names.quantities.get(key)) for name, key in zip(listed, keys, strict=True))


def _read_whole(spec: Mapping[Any, Any], arm: Arm) -> Quantity:
    try:
        return read_quantity("inverse", spec, arm)
    except DocumentError as error:
        raise DocumentError(finding_of(error), "inverse") from None


def _read_order(spec: object, arm: Arm, names: Names) -> tuple[str, ...]:
    if spec is None:
        return ()
    symbols = [joint.symbol for joint in arm.joints]
    if not (isinstance(spec, list) and all(isinstance(name, str) for name in spec)):
        raise DocumentError(say(Kind.NO_JOINTS_TO_SOLVE, joints=symbols, value=repr(spec)), "inverse")
    order = [names.known_symbol(_key(names, name)) or name for name in spec]
    if sorted(order) != sorted(symbols):
        given = [str(name) for name in spec]
        raise DocumentError(say(Kind.NOT_EACH_JOINT, arm=arm.name, joints=symbols, given=given), "inverse")
    return tuple(order)


def _key(names: Names, name: str) -> str:
    try:
        return name_key(names.reader, name)
    except DocumentError as error:
        raise DocumentError(say(Kind.OF_INVERSE, problem=finding_of(error)), "inverse") from None
