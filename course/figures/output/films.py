"""Motions that move: an animation (GIF, MP4) in which the tool draws its path, and a page with Drake's Meshcat viewer (HTML)."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from armproof.course.errors import FigureError
from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import number, say
from armproof.course.figures.drawing.scene import Scene, View
from armproof.course.figures.drawing.style import GREY, INK, SMALL, STROKES, WIDTHS, new_figure, styled
from armproof.course.figures.drawing.symbols import Look, draw_arm
from armproof.course.figures.facts.motions import Motion, motion_of
from armproof.course.figures.facts.task import tool_points
from armproof.course.figures.output.save import save_bytes
from armproof.models.arm import Arm
from armproof.models.errors import existing_language
from armproof.models.motion.samples import sample_motion
from armproof.models.showing.recording import record_page

FILMS = ("gif", "mp4", "html")
RATE = 20  # frames a second
DOTS = 110  # an inch
_HEIGHT = 84.0  # mm
_HOLD = 0.6  # s at the end
_PATH = 121  # points of the whole path
_LONGEST = 600.0  # s
_NEARLY_WHITE = 244  # of 255


@styled()
def frame_figure(arm: Arm, q: np.ndarray, path: np.ndarray, view: View, time: str) -> Figure:
    """Return one picture: the arm at a configuration (n,), the tool's path so far, (K, n), and the time in words."""
    figure = new_figure("column", _HEIGHT)
    scene = Scene.show(figure, (0.0, 0.0, WIDTHS["column"], _HEIGHT), view)
    scene.line(tool_points(arm, path), gid="path", zorder=5, color=STROKES[0].colour, linewidth=1.4)
    draw_arm(scene, arm, q, Look(colour=INK))
    figure.text(0.03, 0.03, time, fontsize=SMALL, color=GREY)
    return figure


def frames(arm: Arm, lang: str = "", motion: Motion | None = None) -> Iterator[np.ndarray]:
    """Yield the pictures of a motion, (height, width, 3), 0 … 255, RATE a second and both ends included.

    Raises:
        FigureError: a motion of more than ten minutes.
    """
    motion = motion or motion_of(arm)
    if motion.duration > _LONGEST:
        raise FigureError("an animation is at most {longest:g} s long, not {duration:g} s", longest=_LONGEST, duration=motion.duration)  # fmt: skip
    count = round(motion.duration * RATE) + 1
    samples = sample_motion(motion.trajectory, np.linspace(0.0, motion.duration, max(count, 2)))
    whole = sample_motion(motion.trajectory, np.linspace(0.0, motion.duration, _PATH))
    places = np.linspace(0, len(samples.q) - 1, 5).astype(int)
    view = Fit(arm, samples.q[places], points=tool_points(arm, whole.q), margin=9.0).view(WIDTHS["column"], _HEIGHT)
    for time, q in zip(samples.times, samples.q, strict=True):
        path = np.vstack([whole.q[whole.times < time], q])
        text = say("time_is", lang, time=number(round(float(time), 2), lang))
        yield _pixels(frame_figure(arm, q, path, view, text))


def _pixels(figure: Figure) -> np.ndarray:
    figure.set_dpi(DOTS)
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())[:, :, :3]  # type: ignore[attr-defined]
    return picture[: len(picture) // 2 * 2, : picture.shape[1] // 2 * 2].copy()  # MP4 wants even sizes


def film_reason(arm: Arm, suffix: str, lang: str = "") -> str | None:
    """Return why an arm has no film of a format, in a language; None if it has one."""
    return say("no_shape", lang) if suffix == "html" and arm.path is None else None


def write_film(arm: Arm, path: Path | str, lang: str = "", motion: Motion | None = None) -> Path:
    """Write a motion as a film in the format of the path's suffix: gif, mp4, or html, a page to turn and zoom it in.

    Args:
        motion: that which the figures of the arm show, if not given.

    Raises:
        FigureError: another suffix, an MP4 without ffmpeg on this machine, or a folder that cannot be written.
        ModelError: a page of an arm that has no shape.
    """
    path = Path(path)
    lang = existing_language(lang)
    suffix = path.suffix.removeprefix(".")
    if suffix not in FILMS:
        raise FigureError("{path}: a film is written as {films}, not as {found}",
            path=path.name, films=list(FILMS), found=suffix or "no format")  # fmt: skip
    if suffix == "html":
        return save_bytes(record_page(arm, (motion or motion_of(arm)).trajectory).encode("utf-8"), path)
    return save_bytes((_gif if suffix == "gif" else _mp4)(frames(arm, lang, motion)), path)


def _gif(pictures: Iterator[np.ndarray]) -> bytes:
    """Return a GIF that repeats, the last picture held; all pictures in the colours of the last one, which has all."""
    from PIL import Image

    images = [Image.fromarray(picture) for picture in pictures]
    palette = images[-1].quantize(64, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    palette.putpalette(_whitened(palette.getpalette() or []))
    reduced = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    durations = [1000 // RATE] * (len(reduced) - 1) + [int(1000 * _HOLD)]
    file = BytesIO()
    reduced[0].save(file, "GIF", save_all=True, append_images=reduced[1:], duration=durations, loop=0, disposal=1)
    return file.getvalue()


def _whitened(palette: list[int]) -> list[int]:
    """Return a palette of red, green, blue, … with all that is nearly white made the white of the paper."""
    colours = np.array(palette).reshape(-1, 3)
    colours[colours.min(axis=1) > _NEARLY_WHITE] = 255
    return [int(part) for part in colours.ravel()]


def _mp4(pictures: Iterator[np.ndarray]) -> bytes:
    """Return an MP4 made by ffmpeg, which is given the pictures as raw pixels."""
    program = shutil.which("ffmpeg")
    if program is None:
        raise FigureError("an MP4 needs ffmpeg (on Debian: apt install ffmpeg); a GIF does without")
    images = list(pictures)
    height, width = images[0].shape[:2]
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "film.mp4"
        command = [
            program, "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", str(RATE), "-i", "-",
            "-pix_fmt", "yuv420p", "-fflags", "+bitexact", "-flags:v", "+bitexact", str(target),
        ]  # fmt: skip
        pixels = b"".join(image.tobytes() for image in images)
        done = subprocess.run(command, input=pixels, capture_output=True, check=False)
        if done.returncode:
            raise FigureError("ffmpeg fails: {reason}", reason=done.stderr.decode(errors="replace").strip()[:300])
        return target.read_bytes()
