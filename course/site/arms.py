"""The arms of the course on its pages: the convention card, the picture, and a page in which the arm turns and moves."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from markupsafe import Markup, escape

from armproof.course.figures.output.films import film_reason, write_film
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.report.html.card import ArmCard, arm_card
from armproof.verification.report.html.figures import Figure, painter_of
from armproof.verification.report.html.templating import GENERATOR


@dataclass(frozen=True)
class ArmPanel:
    """An arm on the page of a lesson: its card, and the file of its 3D view where it has a shape."""

    card: ArmCard
    view: str


def arm_panel(arm: Arm | None, read: Read) -> ArmPanel | None:
    """Return the panel of an arm; None without one, or where it has nothing to draw."""
    painter = painter_of(arm)
    if arm is None or painter is None:
        return None
    return ArmPanel(arm_card(arm, painter, read), view_name(arm))


def view_name(arm: Arm) -> str:
    """Return the file of an arm's 3D view; empty where the arm has no shape or is none of the catalogue."""
    named = re.fullmatch(r"[a-z][a-z0-9_]*", arm.name) is not None
    return f"{arm.name}-3d.html" if named and film_reason(arm, "html") is None else ""


def picture_of(arm: Arm) -> Figure | None:
    """Return the picture of an arm at its zero pose."""
    painter = painter_of(arm)
    return painter.at_zero() if painter is not None else None


def write_views(names: Iterable[str], folder: Path) -> list[Path]:
    """Write the 3D view of each arm that has one, by the names of the catalogue."""
    written = []
    for name in names:
        arm = load_arm(name)
        if view_name(arm):
            path = write_film(arm, folder / view_name(arm))
            path.write_text(_signed(path.read_text(encoding="utf-8"), arm), encoding="utf-8")
            written.append(path)
    return written


def _signed(page: str, arm: Arm) -> str:
    """Return Meshcat's page with its language, its maker and a title of its own."""
    head = Markup('<meta name="generator" content="{}">\n  <meta name="viewport" content="width=device-width">').format(
        GENERATOR
    )
    page = page.replace("<html>", '<html lang="en">', 1).replace("<head>", f"<head>\n  {head}", 1)
    return re.sub(r"<title>[^<]*</title>", lambda _: f"<title>{escape(arm.title)} in 3D</title>", page, count=1)
