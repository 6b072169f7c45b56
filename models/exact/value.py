"""An arm as a value: its names, and its exact kinematics link by link, written as JSON and read without Drake or NumPy.

The links are those that Drake's own kinematics gave when the value was written. `trace_of` of the arm that is read
multiplies them as polynomials, which in normal form are equal to those of the arm that was written.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial
from math import inf, isinf
from types import MappingProxyType
from typing import Any

from armproof.models.arm import Arm, Joint
from armproof.models.dh.table import read_table, write_table
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.chain import POLYNOMIALS, ChainKinematics, Link, traced_link
from armproof.models.exact.polynomial import Entry, Generator
from armproof.models.exact.trace import trace_of

FORMAT = 1
_TEXTS = ("name", "title", "source", "zero", "digest")


class WrittenKinematics(ChainKinematics[Entry]):
    """The exact kinematics of an arm that was read from a value (see ExactKinematics in models/exact/trace.py)."""

    def __init__(self, value: Mapping[str, Any]) -> None:
        links = {(link.before, link.after): link for link in map(_read_link, value["links"])}
        super().__init__(value["depths"], len(value["joints"]), lambda before, after: links[before, after], POLYNOMIALS)
        self.generators: set[Generator] = {(kind, name) for kind, name in value["generators"]}
        self.growth: Mapping[int, float] = dict(value["growth"])

    def depth(self, frame: str) -> int:
        """Return the number of moving joints between the base and a frame."""
        return self._depths[frame]


def write_value(arm: Arm) -> str:
    """Return an arm as JSON: its names, joints, lengths and frames, and the exact kinematics of its links.

    Raises:
        ModelError: two frames next to each other have too many joints with symbolic angles between them.
    """
    trace = trace_of(arm)
    depths = {frame: trace.depth(frame) for frame in arm.frames}
    pairs = ChainKinematics(depths, len(arm.joints), partial(traced_link, trace), POLYNOMIALS).pairs()
    value = {
        "armproof arm": FORMAT,
        **{key: getattr(arm, key) for key in _TEXTS},
        "warnings": arm.warnings,
        "joints": [_joint(joint) for joint in arm.joints],
        "lengths": dict(arm.lengths),
        "angles": dict(arm.angles),
        "dh": write_table(arm.dh) if arm.dh else None,
        "depths": depths,
        "generators": sorted(arm.exact.generators),
        "growth": sorted(arm.exact.growth.items()),
        "links": [_link(traced_link(trace, *pair)) for pair in pairs],
    }
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def read_value(text: str) -> Arm:
    """Return the arm that `write_value` wrote. It has an exact trace, but no plant and no model file.

    Raises:
        ModelError: the text is not such a value.
    """
    try:
        value = json.loads(text)
        if value["armproof arm"] != FORMAT:
            raise ValueError(f"its format is {value['armproof arm']!r}, not {FORMAT}")
        return _arm(value)
    except (ValueError, KeyError, TypeError, AttributeError, ZeroDivisionError, RecursionError) as error:
        raise ModelError(Fault.NOT_A_VALUE, type=type(error).__name__, reason=str(error)) from None


def _arm(value: Mapping[str, Any]) -> Arm:
    joints = tuple(_read_joint(index, joint) for index, joint in enumerate(value["joints"], start=1))
    return Arm(
        **{key: value[key] for key in _TEXTS},
        joints=joints,
        lengths=MappingProxyType(value["lengths"]),
        angles=MappingProxyType(value["angles"]),
        frames=tuple(value["depths"]),
        exact=WrittenKinematics(value),
        dh=read_table(value["dh"]) if value["dh"] else None,
        warnings=tuple(value["warnings"]),
    )


def _joint(joint: Joint) -> list[Any]:
    limits = [None if isinf(limit) else limit for limit in (joint.lower, joint.upper)]
    return [joint.name, joint.symbol, joint.kind, *limits]


def _read_joint(index: int, joint: Sequence[Any]) -> Joint:
    name, symbol, kind, lower, upper = joint
    return Joint(index, name, symbol, kind, -inf if lower is None else lower, inf if upper is None else upper)


def _link(link: Link) -> list[Any]:
    pose = [[_entry(entry) for entry in row] for row in link.pose]
    twists = [[joint, [_entry(entry) for entry in twist]] for joint, twist in link.twists.items()]
    return [link.before, link.after, link.point, link.axes, pose, twists]


def _read_link(link: Sequence[Any]) -> Link:
    before, after, point, axes, pose, twists = link
    rows = tuple(tuple(_read_entry(entry) for entry in row) for row in pose)
    columns = {joint: tuple(_read_entry(entry) for entry in twist) for joint, twist in twists}
    return Link(before, after, rows, point, axes, columns)


def _entry(entry: Entry) -> list[Any]:
    return [[str(coefficient), *([*gen, power] for gen, power in monomial)] for monomial, coefficient in entry.items()]


def _read_entry(entry: Sequence[Any]) -> Entry:
    terms = {}
    for coefficient, *monomial in entry:
        number = Fraction(*(int(part) for part in coefficient.split("/")))
        terms[tuple(((kind, name), int(power)) for kind, name, power in monomial)] = number
    return terms
