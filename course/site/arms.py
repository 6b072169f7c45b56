"""The arms of the course on its pages: the convention card, the picture, and a page in which the arm turns and moves."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from markupsafe import Markup, escape

from armproof.course.figures.output.films import film_reason, write_film
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import written
from armproof.models.language import look_up, noted, spoken, use
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.report.html.card import ArmCard, arm_card
from armproof.verification.report.html.figures import Figure, painter_of
from armproof.verification.report.html.templating import GENERATOR

_CONTROLS = (
    noted("Open Controls"), noted("Close Controls"), noted("Scene"), noted("Animations"), noted("Recording"),
    noted("Save / Load / Capture"), noted("No connection to server."),
)  # fmt: skip
_CONTROL = re.compile(rf"((?:addFolder\(|TEXT_OPEN=|TEXT_CLOSED=)\"|>\s*)({'|'.join(map(re.escape, _CONTROLS))})")

# Meshcat gives its controls no names and its page no heading: what the eye takes from their place is said to a screen reader.
_NAMES = """<script>
(() => {
  const pane = document.getElementById("meshcat-pane"), heading = document.createElement("h1");
  heading.textContent = document.title;
  heading.style.cssText = "position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%)";
  pane.setAttribute("role", "main");
  pane.prepend(heading);
  const named = () => {
    for (const each of document.querySelectorAll(".dg input, .dg select")) {
      const row = each.closest("li.cr") ?? each.closest(".dg"), words = row?.querySelector(".property-name, .title");
      if (!each.ariaLabel) each.ariaLabel = words?.textContent || document.title;
    }
    for (const each of document.querySelectorAll(".dg")) {
      if (each.parentElement.closest(".dg") || each.role) continue;
      each.role = "region";
      each.ariaLabel = "CONTROLS";
    }
  };
  named();
  new MutationObserver(named).observe(document.body, {childList: true, subtree: true});
})();
</script>
"""


@dataclass(frozen=True)
class ArmPanel:
    """An arm on the page of a lesson: its card, and the file of its 3D view where it has a shape."""

    card: ArmCard
    view: str


def arm_panel(arm: Arm | None, read: Read, suffix: str) -> ArmPanel | None:
    """Return the panel of an arm; None without one, or where it has nothing to draw."""
    painter = painter_of(arm)
    if arm is None or painter is None:
        return None
    return ArmPanel(arm_card(arm, painter, read), view_name(arm, suffix))


def view_name(arm: Arm, suffix: str) -> str:
    """Return the file of an arm's 3D view in the language of a suffix; empty where the arm has no shape or is none of the catalogue."""
    named = re.fullmatch(r"[a-z][a-z0-9_]*", arm.name) is not None
    return f"{arm.name}-3d{suffix}.html" if named and film_reason(arm, "html") is None else ""


def picture_of(arm: Arm) -> Figure | None:
    """Return the picture of an arm at its zero pose."""
    painter = painter_of(arm)
    return painter.at_zero() if painter is not None else None


def write_views(names: Iterable[str], folder: Path, suffixes: Mapping[str, str]) -> None:
    """Write the 3D view of each arm that has one, by the names of the catalogue, in each language with its suffix."""
    for arm in map(load_arm, names):
        if view_name(arm, ""):
            film = write_film(arm, folder / view_name(arm, "")).read_text(encoding="utf-8")
            for lang, suffix in suffixes.items():
                with use(lang):
                    (folder / view_name(arm, suffix)).write_text(_signed(film, arm), encoding="utf-8")


def _signed(page: str, arm: Arm) -> str:
    """Return Meshcat's page in the language that is spoken, with its maker and a title of its own."""
    title = written("{arm} in 3D", arm=look_up(arm.title))
    head = Markup('<meta name="generator" content="{}">\n  <meta name="viewport" content="width=device-width">').format(
        GENERATOR
    )
    page = _CONTROL.sub(lambda found: found[1] + look_up(found[2]), page)
    page = page.replace("<html>", f'<html lang="{spoken()}">', 1).replace("<head>", f"<head>\n  {head}", 1)
    page = re.sub(r"<title>[^<]*</title>", lambda _: f"<title>{escape(title)}</title>", page, count=1)
    before, end, behind = page.rpartition("</body>")
    return before + _NAMES.replace("CONTROLS", look_up("Controls")) + end + behind
