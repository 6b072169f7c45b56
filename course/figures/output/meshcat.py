"""A self-contained page in which an arm moves, to be turned and zoomed in any browser."""

from __future__ import annotations

from pathlib import Path

from armproof.course.figures.drawing.labels import say
from armproof.course.figures.facts.motions import Motion, motion_of
from armproof.course.figures.output.save import save_bytes
from armproof.models.arm import Arm
from armproof.models.showing.recording import record_page


def no_page(arm: Arm, lang: str = "en") -> str | None:
    """Return why an arm has no page, or None."""
    return say("no_shape", lang) if arm.path is None else None


def write_page(arm: Arm, path: Path, lang: str = "en", motion: Motion | None = None) -> Path:
    """Write the page of a motion, that which the figures of the arm show if not given; lang changes nothing.

    Raises:
        ModelError: an arm without a shape.
        FigureError: a folder that cannot be written.
    """
    motion = motion or motion_of(arm)
    return save_bytes(record_page(arm, motion.trajectory).encode("utf-8"), Path(path))
