"""The chain of joints that a URDF in a piece of code tells, from its base to its tool; nothing is loaded or expanded but the values of its properties."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from xml.etree import ElementTree

from armproof.verification.document.model import BuiltJoint, CodeRobot, Display
from armproof.verification.patterns import regex

LONGEST = 40_000  # characters of a piece of code
_TURNS, _SLIDES = ("revolute", "continuous"), ("prismatic",)
_PREFIX = regex(r"(?<=[</\s])(?:xacro|xi|gazebo):(?=\w)")
_DECLARED = regex(r"<\?xml.*?\?>|<!--.*?-->", re.DOTALL)
_OF_TOOL = regex(r"tool|tip|tcp|flange|ee\b|end_?eff|gripper|hand", re.IGNORECASE)
_ENTRY = regex(r"-?\$\{\s*-?\w+\s*\}|[-+\w.${}*/]+")
_NAMED = regex(r"(-?)\$\{\s*(-?)\s*([A-Za-z]\w*)\s*\}")
_ZERO = ("0", "0", "0")


def code_robots(displays: Iterable[Display]) -> Iterator[CodeRobot]:
    """Yield the robots of pieces of code that are URDF, each with one chain of joints to its tool."""
    for display in displays:
        if "<joint" not in display.latex or "<!DOCTYPE" in display.latex or len(display.latex) > LONGEST:
            continue
        text = _PREFIX.sub("", _DECLARED.sub("", display.latex))
        try:
            root = ElementTree.fromstring(f"<code>{text}</code>")
        except ElementTree.ParseError:
            continue
        joints = [*_joints(root)]
        if (chain := _chain(joints)) and sum(each.kind != "fixed" for each in chain) > 1:
            line = display.line + 1
            yield CodeRobot(line, tuple(chain), cell=display.cell, section=display.section)


def _joints(root: ElementTree.Element) -> Iterator[BuiltJoint]:
    """Yield the joints; one that is coupled, or of another kind, is of the kind ""."""
    values = {str(each.get("name")): str(each.get("value")) for each in root.iter("property")}
    for each in root.iter("joint"):
        kind = each.get("type", "")
        is_known = kind in (*_TURNS, *_SLIDES, "fixed") and each.find("mimic") is None
        parent, child, origin, axis = (each.find(name) for name in ("parent", "child", "origin", "axis"))
        if parent is None or child is None:
            continue  # of a transmission
        entries = [
            _triple(node, name, values, default)
            for node, name, default in (
                (origin, "xyz", _ZERO),
                (origin, "rpy", _ZERO),
                (axis, "xyz", ("1", "0", "0")),
            )
        ]
        told = "revolute" if kind in _TURNS else kind
        links = (parent.get("link", ""), child.get("link", ""))
        whole = [entry for entry in entries if entry is not None]
        if not is_known or len(whole) < len(entries):
            yield BuiltJoint(each.get("name", ""), "", *links, _ZERO, _ZERO, _ZERO)
        else:
            yield BuiltJoint(each.get("name", ""), told, *links, *whole)


def _triple(
    node: ElementTree.Element | None, name: str, values: Mapping[str, str], default: tuple[str, str, str]
) -> tuple[str, str, str] | None:
    """Return three entries, numbers or letters, None where there are not three."""
    text = node.get(name) if node is not None else None
    if text is None:
        return default
    found = [_entry(each.group(), values) for each in _ENTRY.finditer(text)]
    return (found[0], found[1], found[2]) if len(found) == 3 else None


def _entry(text: str, values: Mapping[str, str]) -> str:
    """Return an entry with the value of its property, -${l1} as -l1 where it has none."""
    named = _NAMED.fullmatch(text)
    if named is None:
        return text
    sign, value = named[1] + named[2], values.get(named[3], named[3])
    return f"{sign}{value}".replace("--", "")


def _chain(joints: list[BuiltJoint]) -> list[BuiltJoint]:
    """Return the joints from the base to the tool, none where they are not one chain: of several ends one must be called a tool."""
    children = {each.child for each in joints}
    roots = {each.parent for each in joints} - children
    if len(roots) != 1 or len(children) != len(joints):
        return []
    ends = [[*_up_to(each.child, joints)] for each in joints if each.child not in {other.parent for other in joints}]
    moving = {each.name for each in joints if each.kind != "fixed"}
    whole = [each for each in ends if {one.name for one in each if one.kind != "fixed"} == moving]
    named = [each for each in whole if _OF_TOOL.search(each[-1].child)] if len(whole) > 1 else whole
    chain = named[0] if len(named) == 1 else []
    return chain if all(each.kind for each in chain) else []


def _up_to(link: str, joints: list[BuiltJoint]) -> list[BuiltJoint]:
    above = {each.child: each for each in joints}
    found: list[BuiltJoint] = []
    while link in above and len(found) <= len(joints):
        found.insert(0, above[link])
        link = above[link].parent
    return found
