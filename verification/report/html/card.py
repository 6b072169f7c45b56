"""An arm's convention card on a page: where it comes from, its zero pose, joints, lengths, frames, its picture."""

from __future__ import annotations

from dataclasses import dataclass

from markupsafe import Markup

from armproof.models.arm import Arm, Joint
from armproof.models.errors import written
from armproof.models.language import look_up, number_text
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.report.arms import limits
from armproof.verification.report.html import prose
from armproof.verification.report.html.figures import ArmPainter, Figure


@dataclass(frozen=True)
class JointRow:
    """A joint: its variable, its kind and its limits in words."""

    symbol: Markup
    name: str  # the same for a screen reader, to which mathematics alone is no header
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
        Markup("{} = {} m").format(prose.symbol(name, read), number_text(value, ".6g").replace("-", "−"))
        for name, value in arm.lengths.items()
    ]
    return ArmCard(
        arm.name,
        look_up(arm.title),
        look_up(arm.source),
        prose.symbols_in(look_up(arm.zero), read),
        written("{convention} Denavit–Hartenberg", convention=look_up(arm.dh.convention)) if arm.dh is not None else "",
        tuple(
            JointRow(prose.symbol(each.symbol, read), each.symbol, look_up(each.kind), _limits(each))
            for each in arm.joints
        ),
        tuple(lengths),
        arm.frames,
        arm.warnings,
        painter.at_zero(),
    )


def _limits(joint: Joint) -> str:
    return limits(joint, "°").replace(" °", "°").replace("-", "−")
