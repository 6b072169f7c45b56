"""An arm's convention card on a page: where it comes from, its zero pose, joints, lengths, frames, its picture."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees, isfinite

from markupsafe import Markup

from armproof.models.arm import Arm, Joint
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.report.html import prose
from armproof.verification.report.html.figures import ArmPainter, Figure


@dataclass(frozen=True)
class JointRow:
    """A joint: its variable, its kind and its limits in words."""

    symbol: Markup
    kind: str
    limits: str


@dataclass(frozen=True)
class ArmCard:
    """What a page says of an arm."""

    name: str
    title: str
    source: str
    zero: Markup
    convention: str
    joints: tuple[JointRow, ...]
    lengths: tuple[Markup, ...]
    frames: tuple[str, ...]
    warnings: tuple[str, ...]
    figure: Figure


def arm_card(arm: Arm, painter: ArmPainter, read: Read) -> ArmCard:
    """Return the convention card of an arm."""
    lengths = [
        Markup("{} = {} m").format(prose.symbol(name, read), f"{value:.6g}".replace("-", "−"))
        for name, value in arm.lengths.items()
    ]
    return ArmCard(
        arm.name,
        arm.title,
        arm.source,
        prose.symbols_in(arm.zero, read),
        f"{arm.dh.convention} Denavit–Hartenberg" if arm.dh is not None else "",
        tuple(JointRow(prose.symbol(joint.symbol, read), joint.kind, _limits(joint)) for joint in arm.joints),
        tuple(lengths),
        arm.frames,
        arm.warnings,
        painter.at_zero(),
    )


def _limits(joint: Joint) -> str:
    if not (isfinite(joint.lower) and isfinite(joint.upper)):
        return "without limits"
    if joint.kind == "revolute":
        return f"{degrees(joint.lower):.4g}° to {degrees(joint.upper):.4g}°".replace("-", "−")
    return f"{joint.lower:.4g} m to {joint.upper:.4g} m".replace("-", "−")
