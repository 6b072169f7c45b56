"""An animation of an arm: it goes from one configuration to another, its tool drawing its path."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import arm_view
from armproof.course.figures.drawing.labels import number, say
from armproof.course.figures.drawing.scene import Scene, View
from armproof.course.figures.drawing.style import GREY, INK, SMALL, STROKES, WIDTHS, new_figure, styled
from armproof.course.figures.drawing.symbols import Look, draw_arm
from armproof.course.figures.errors import FigureError
from armproof.course.figures.facts.motions import Motion, motion_of
from armproof.course.figures.facts.task import tool_points
from armproof.course.figures.output.save import save_bytes
from armproof.models.arm import Arm
from armproof.models.motion.samples import sample_motion

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


def frames(arm: Arm, lang: str = "en", motion: Motion | None = None) -> Iterator[np.ndarray]:
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
    view = arm_view(arm, samples.q[places], (WIDTHS["column"], _HEIGHT), points=tool_points(arm, whole.q), margin=9.0)
    for time, q in zip(samples.times, samples.q, strict=True):
        path = np.vstack([whole.q[whole.times < time], q])
        text = say("time_is", lang, time=number(round(float(time), 2), lang))
        yield _pixels(frame_figure(arm, q, path, view, text))


def _pixels(figure: Figure) -> np.ndarray:
    figure.set_dpi(DOTS)
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())[:, :, :3]  # type: ignore[attr-defined]
    return picture[: len(picture) // 2 * 2, : picture.shape[1] // 2 * 2].copy()  # MP4 wants even sizes


def write_animation(arm: Arm, path: Path, lang: str = "en", motion: Motion | None = None) -> Path:
    """Write the animation of a motion, that which the figures of the arm show if not given, as .gif or .mp4.

    Raises:
        FigureError: another suffix, an MP4 without ffmpeg on this machine, or a folder that cannot be written.
    """
    path = Path(path)
    writers = {".gif": _gif, ".mp4": _mp4}
    if path.suffix not in writers:
        raise FigureError("{path}: an animation is written as gif or mp4, not as {found}",
            path=path.name, found=path.suffix.removeprefix(".") or "no format")  # fmt: skip
    return save_bytes(writers[path.suffix](frames(arm, lang, motion)), path)


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
    import shutil
    import subprocess
    import tempfile

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
        done = subprocess.run(
            command, input=b"".join(image.tobytes() for image in images), capture_output=True, check=False
        )
        if done.returncode:
            raise FigureError("ffmpeg fails: {reason}", reason=done.stderr.decode(errors="replace").strip()[:300])
        return target.read_bytes()
