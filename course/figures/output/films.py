"""Motions that move: an animation (GIF, MP4) and a page with Drake's Meshcat viewer (HTML), as files."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from armproof.course.figures.drawing.labels import check_language
from armproof.course.figures.errors import FigureError
from armproof.course.figures.output.animation import write_animation
from armproof.course.figures.output.meshcat import no_page, write_page
from armproof.models.arm import Arm

FILMS: Mapping[str, Callable[[Arm, Path, str], Path]] = MappingProxyType(
    {"gif": write_animation, "mp4": write_animation, "html": write_page}
)


def film_reason(arm: Arm, suffix: str, lang: str = "en") -> str | None:
    """Return why an arm has no film of a format, in a language; None if it has one."""
    return no_page(arm, lang) if suffix == "html" else None


def write_film(arm: Arm, path: Path | str, lang: str = "en") -> Path:
    """Write the motion that the figures of an arm show as a film in the format of the path's suffix: gif, mp4 or html.

    Raises:
        FigureError: another suffix, an MP4 without ffmpeg, or a folder that cannot be written.
        ModelError: a page of an arm that has no shape.
    """
    path = Path(path)
    check_language(lang)
    suffix = path.suffix.removeprefix(".")
    if suffix not in FILMS:
        raise FigureError("{path}: a film is written as {films}, not as {found}",
            path=path.name, films=list(FILMS), found=suffix or "no format")  # fmt: skip
    return FILMS[suffix](arm, path, lang)
