"""The arms, for people: one line each, or everything that a document may name on one of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, isfinite

from armproof.models.arm import Arm, Joint
from armproof.models.errors import written
from armproof.models.language import look_up, number_text
from armproof.verification.report.text import Line, Span


def list_arms(arms: Sequence[Arm]) -> Iterator[Line]:
    """Return, for each arm, its name and title, then its joints, lengths and frames."""
    for arm in arms:
        yield ((arm.name, "bold"), (f"  {look_up(arm.title)}", ""))
        joints = " ".join(joint.symbol for joint in arm.joints)
        lengths = " ".join(arm.lengths) or look_up("none")
        frames = " ".join(arm.frames)
        told = written(
            "joints {joints};  lengths {lengths};  frames {frames}", joints=joints, lengths=lengths, frames=frames
        )
        yield (("    " + told, "dim"),)


def describe_arm(arm: Arm) -> Iterator[Line]:
    """Return the title, the source, the zero pose, the joints with their limits, the lengths and the frames of an arm."""
    yield ((arm.name, "bold"), (f"  {look_up(arm.title)}", ""))
    labels = look_up("source"), look_up("model"), look_up("zero")
    for label, text in zip(labels, (look_up(arm.source), str(arm.path or ""), look_up(arm.zero)), strict=True):
        if text:
            yield (_label(label), (text, ""))
    for number, joint in enumerate(arm.joints):
        yield _joint(joint, number)
    for number, (symbol, value) in enumerate(arm.lengths.items()):
        yield (
            _label("" if number else look_up("lengths")),
            (f"{symbol:10}", "bold"),
            (f"{number_text(value, '.6g')} m", ""),
        )
    yield (_label(look_up("frames")), (", ".join(arm.frames), ""))


def _joint(joint: Joint, number: int) -> Line:
    label = _label("" if number else look_up("joints"))
    name = "  " + written("({name} in the model)", name=joint.name) if joint.name != joint.symbol else ""
    return (label, (f"{joint.symbol:10}", "bold"), (f"{look_up(joint.kind):10} {limits(joint, 'deg')}{name}", ""))


def _label(text: str) -> Span:
    return (f"{text:{max(9, len(look_up('joints')) + 1)}}", "dim")


def limits(joint: Joint, unit: str) -> str:
    """Return the limits of a joint in words, those of an angle in degrees, with their unit."""
    if not (isfinite(joint.lower) and isfinite(joint.upper)):
        return look_up("without limits")
    if joint.kind == "revolute":
        return written(
            "{lower:.4g} to {upper:.4g} {unit}", lower=degrees(joint.lower), upper=degrees(joint.upper), unit=unit
        )
    return written("{lower:.4g} to {upper:.4g} {unit}", lower=joint.lower, upper=joint.upper, unit="m")
