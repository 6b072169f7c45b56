"""The arms, for people: one line each, or everything that a document may name on one of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, isfinite

from armproof.models.arm import Arm, Joint
from armproof.verification.report.text import Line


def list_arms(arms: Sequence[Arm]) -> Iterator[Line]:
    """Return, for each arm, its name and title, then its joints, lengths and frames."""
    for arm in arms:
        yield ((arm.name, "bold"), (f"  {arm.title}", ""))
        joints = " ".join(joint.symbol for joint in arm.joints)
        lengths = " ".join(arm.lengths) or "none"
        yield ((f"    joints {joints};  lengths {lengths};  frames {' '.join(arm.frames)}", "dim"),)


def describe_arm(arm: Arm) -> Iterator[Line]:
    """Return the title, the source, the zero pose, the joints with their limits, the lengths and the frames of an arm."""
    yield ((arm.name, "bold"), (f"  {arm.title}", ""))
    for label, text in (("source", arm.source), ("model", str(arm.path or "")), ("zero", arm.zero)):
        if text:
            yield ((f"{label:9}", "dim"), (text, ""))
    for number, joint in enumerate(arm.joints):
        yield _joint(joint, number)
    for number, (symbol, value) in enumerate(arm.lengths.items()):
        yield (("lengths  " if not number else " " * 9, "dim"), (f"{symbol:10}", "bold"), (f"{value:.6g} m", ""))
    yield (("frames   ", "dim"), (", ".join(arm.frames), ""))


def _joint(joint: Joint, number: int) -> Line:
    label = "joints   " if not number else " " * 9
    name = f"  ({joint.name} in the model)" if joint.name != joint.symbol else ""
    return ((label, "dim"), (f"{joint.symbol:10}", "bold"), (f"{joint.kind:10} {_limits(joint)}{name}", ""))


def _limits(joint: Joint) -> str:
    if not (isfinite(joint.lower) and isfinite(joint.upper)):
        return "without limits"
    if joint.kind == "revolute":
        return f"{degrees(joint.lower):.4g} to {degrees(joint.upper):.4g} deg"
    return f"{joint.lower:.4g} to {joint.upper:.4g} m"
