"""A URDF as it is found, made ready for Drake: rounded right angles, joints that are locked, a tip."""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import pi
from pathlib import Path
from types import MappingProxyType
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from armproof.models.errors import Fault, ModelError, written
from armproof.models.exact.numbers import TOLERANCE

NEARLY = 2e-3  # rad; farther from it an angle is another one
_RPY = re.compile(r"""(\brpy\s*=\s*["'])([^"']*)""")
_JOINT = re.compile(r"<joint\b.*?</joint>", re.DOTALL)
_MOVES = ("revolute", "continuous", "prismatic")
_ONLY_MOVING = ("mimic", "limit", "axis", "dynamics", "safety_controller", "calibration")


def made_ready(
    path: Path, tip: str = "", lock: Mapping[str, float] = MappingProxyType({})
) -> tuple[str, tuple[str, ...]]:
    """Return the text of a URDF as Drake is to read it, empty where that is the file's own, and what is to be remarked.

    Raises:
        ModelError: it is no URDF that has a tip or locked joints, or there is no such link or joint.
    """
    if path.suffix != ".urdf":
        if tip or lock:
            raise ModelError(Fault.LOCKED_NO_URDF, path=path)
        return "", ()
    text = own = path.read_bytes().decode("utf-8", errors="replace")
    text, rounded = with_right_angles(text)
    told = written("{path}: angles are taken as the multiples of pi/4 that they round: {angles}",
                   path=path, angles=list(dict.fromkeys(rounded)))  # fmt: skip
    if tip or lock:
        text = with_locks(text, tip, lock, str(path))
    return "" if text == own else text, (told,) if rounded else ()


def with_right_angles(text: str) -> tuple[str, list[str]]:
    """Return a URDF whose joints turn by pi/2 where that is rounded to 1.5708, so for each multiple of pi/4, and the angles that were rounded."""
    found: list[str] = []

    def snapped(angle: str) -> str:
        exact = _right_angle(angle)
        if exact is None:
            return angle
        found.append(angle)
        return repr(exact)

    def all_snapped(origin: re.Match[str]) -> str:
        return origin[1] + " ".join(map(snapped, origin[2].split()))

    return _JOINT.sub(lambda joint: _RPY.sub(all_snapped, joint[0]), text), found


def _right_angle(angle: str) -> float | None:
    """Return the multiple of pi/4 that a decimal is to its last digit; None where it is another number, or exact."""
    if not re.fullmatch(r"[+-]?\d+\.\d{2,}", angle):
        return None
    value = float(angle)
    exact = round(value / (pi / 4)) * pi / 4
    digit = float(f"1e-{len(angle.partition('.')[2])}")  # which a decimal other than 0 is not below
    return exact if TOLERANCE < abs(value - exact) < min(digit, NEARLY) else None


def with_locks(text: str, tip: str, lock: Mapping[str, float], source: str) -> str:
    """Return a URDF in which some joints are fixed: those of `lock` at their values, and at 0 those that do not carry the tip.

    Raises:
        ModelError: there is no such link or joint.
    """
    root = ElementTree.fromstring(text)
    joints = {str(joint.get("name")): joint for joint in root.findall("joint")}
    for name in lock:
        if name not in joints:
            raise ModelError(Fault.NO_JOINT_TO_LOCK, source=source, joint=name, joints=list(joints))
    fixed = {**(dict.fromkeys(_beside(root, tip, joints, source), 0.0) if tip else {}), **lock}
    for name, value in fixed.items():
        _fix(joints[name], value)
    return ElementTree.tostring(root, encoding="unicode")


def _beside(root: Element, tip: str, joints: Mapping[str, Element], source: str) -> list[str]:
    """Return the moving joints that do not carry a link."""
    links = [str(link.get("name")) for link in root.findall("link")]
    if tip not in links:
        raise ModelError(Fault.NO_TIP, source=source, link=tip, links=links)
    inboard = {_link(joint, "child"): name for name, joint in joints.items()}
    carrying: list[str] = []
    while tip in inboard and inboard[tip] not in carrying:
        carrying.append(inboard[tip])
        tip = _link(joints[carrying[-1]], "parent")
    return [name for name, joint in joints.items() if joint.get("type") in _MOVES and name not in carrying]


def _fix(joint: Element, value: float) -> None:
    """Fix a joint where its variable has a value."""
    import numpy as np
    from pydrake.common.eigen_geometry import AngleAxis
    from pydrake.math import RollPitchYaw, RotationMatrix

    xyz, rpy = (np.array(_numbers(joint.find("origin"), key)) for key in ("xyz", "rpy"))
    axis = np.array(_numbers(joint.find("axis"), "xyz", (1.0, 0.0, 0.0)))
    if value:
        R = RollPitchYaw(rpy).ToRotationMatrix()
        direction = axis / np.linalg.norm(axis)
        if joint.get("type") == "prismatic":
            xyz = xyz + R.matrix() @ direction * value
        else:
            rpy = RollPitchYaw(R @ RotationMatrix(AngleAxis(value, direction))).vector()
        origin = joint.find("origin")
        origin = SubElement(joint, "origin") if origin is None else origin
        origin.attrib.update(xyz=_text(xyz), rpy=_text(rpy))
    joint.set("type", "fixed")
    for part in [part for part in joint if part.tag in _ONLY_MOVING]:
        joint.remove(part)


def _link(joint: Element, end: str) -> str:
    found = joint.find(end)
    return "" if found is None else str(found.get("link"))


def _numbers(element: Element | None, key: str, default: tuple[float, ...] = (0.0, 0.0, 0.0)) -> tuple[float, ...]:
    text = None if element is None else element.get(key)
    return default if text is None else tuple(map(float, text.split()))


def _text(values: object) -> str:
    return " ".join(repr(float(value)) for value in values)  # type: ignore[attr-defined]
