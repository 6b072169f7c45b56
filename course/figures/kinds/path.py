"""The tool's path of a motion, with the arm on its way: in joint space beside along a straight line."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import axis_label, length, math, number, say, values_text
from armproof.course.figures.drawing.placement import Label
from armproof.course.figures.drawing.plots import at_peak, plot_axes
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import GREY, PAPER, STROKES, Box, new_figure, stroke_of, styled
from armproof.course.figures.drawing.symbols import Look, draw_arm
from armproof.course.figures.facts.motions import Motion, motion_of
from armproof.course.figures.facts.task import task_of, tool_points
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.motion.joint_space import follow_path
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.samples import MotionSamples, sample_motion

SAMPLES = 121
SNAPSHOTS = 5
_WIDTH, _HEIGHT = 87.0, 78.0  # mm, of a drawing
_PLOT = 30.0  # mm
_BOTTOM = 10.0
_SIZE = 0.8  # of the symbols


def tool_motions(motion: Motion) -> dict[str, Any]:
    """Return the trajectories that are drawn: joint, and line where the arm can follow one; both take the same time."""
    found = {"joint": motion.trajectory}
    if motion.line is not None:
        found["line"] = follow_path(motion.line.path, motion.duration)
    return found


@styled()
def path_figure(arm: Arm, lang: str = "", motion: Motion | None = None) -> Figure:
    """Return the tool's path between two configurations, in joint space and on a straight line, with snapshots of the arm.

    Below are the joint velocities as parts of their limits, where the model file has some.

    Args:
        motion: the one that the figures of the arm show, if not given.
    """
    motion = motion or motion_of(arm)
    times = np.linspace(0.0, motion.duration, SAMPLES)
    samples = {name: sample_motion(trajectory, times) for name, trajectory in tool_motions(motion).items()}
    limits = read_rate_limits(arm).velocity
    plots = _PLOT + _BOTTOM if np.isfinite(limits).all() else 0.0
    figure = new_figure("page" if len(samples) > 1 else "column", _HEIGHT + plots)
    shown = np.vstack([found.q[_snapshots()] for found in samples.values()])
    points = np.vstack([tool_points(arm, found.q) for found in samples.values()])
    view = Fit(arm, shown, points=points, margin=7.0, size=_SIZE).view(84.0, _HEIGHT - 5)
    labels: list[Label] = []
    scenes = []
    for column, name in enumerate(samples):
        scene = Scene.show(figure, (column * _WIDTH, plots, 84.0, _HEIGHT - 5), view)
        scene.axes.set_title(_title(arm, name, lang), pad=2)
        _draw(scene, arm, samples, name)
        scenes.append(scene)
        if plots:
            box = (column * _WIDTH + 13, _BOTTOM, 84.0 - 13 - 8, _PLOT - 4)
            labels += _rates(figure, box, arm, samples, name, lang)
    return finish(figure, *scenes, extra=labels)


def _snapshots() -> np.ndarray:
    return np.linspace(0, SAMPLES - 1, SNAPSHOTS).astype(int)


def _title(arm: Arm, name: str, lang: str) -> str:
    return say("turn_motion" if name == "line" and task_of(arm).turns_only else f"{name}_motion", lang)


def _draw(scene: Scene, arm: Arm, samples: dict[str, MotionSamples], name: str) -> None:
    """Draw the arm at equal steps of time, the path of its tool, and dotted the path of the other motion."""
    q = samples[name].q
    for k, place in enumerate(_snapshots()):
        last = place == SAMPLES - 1
        pale = Look(GREY, 0.3 + 0.12 * k, 1.2, size=_SIZE, zorder=2 + 0.2 * k).bare()
        look = Look(size=_SIZE, zorder=2 + 0.2 * k) if last else pale
        draw_arm(scene, arm, q[place], look, name=f"{name} {k} ")
    for other, found in samples.items():
        path = tool_points(arm, found.q)
        if other != name:
            scene.line(path, gid=f"other path {other}", zorder=5, color=GREY, linewidth=0.8, linestyle=(0, (1, 1.6)))
    path = tool_points(arm, q)
    stroke = STROKES[0 if name == "joint" else 1]
    scene.line(path, gid=f"path {name}", zorder=6, color=stroke.colour, linewidth=1.5)
    marks = path[:: (SAMPLES - 1) // 12]
    scene.line(marks, gid=f"steps {name}", zorder=7, linestyle="none", marker="o", markersize=3.4, color=stroke.colour, markeredgecolor=PAPER, markeredgewidth=0.5)  # fmt: skip
    scene.label("$A$", path[0], path[0] - path[len(path) // 2], gap=1.0)
    scene.label("$B$", path[-1], path[-1] - path[len(path) // 2], gap=1.0)


def _rates(figure: Figure, box: Box, arm: Arm, samples: dict[str, MotionSamples], name: str, lang: str) -> list[Label]:
    """Plot the joint velocities as parts of their limits; returns the names of the joints, at their largest."""
    limits = read_rate_limits(arm).velocity
    axes = plot_axes(figure, box, lang, axis_label(say("time", lang), "s", "t"), axis_label("", "%", r"\dot{q}/k_v"))
    most = 130 * max(float(np.abs(found.v / limits).max()) for found in samples.values())
    axes.set_ylim(-most, most)
    times, rates = samples[name].times, 100 * samples[name].v / limits
    axes.set_xlim(0, times[-1])
    labels = []
    for k, joint in enumerate(arm.joints):
        axes.plot(times, rates[:, k], linewidth=1.0, gid=f"rate {name} {joint.symbol}", **stroke_of(k).line)
        labels.append(at_peak(axes, math(joint.symbol), times, rates[:, k], stroke_of(k)))
    return labels


def caption(arm: Arm, lang: str = "", motion: Motion | None = None) -> str:
    """Return the caption: both configurations, the time, how long each path is, how near the straight line is to a singularity."""
    motion = motion or motion_of(arm)
    start, end = (values_text(arm, q, lang) for q in (motion.q_0, motion.q_f))
    parts = [say("A_to_B", lang, start=start, end=end, t_f=number(motion.duration, lang), count=SNAPSHOTS)]
    lengths = {name: length(path_length(arm, trajectory), lang) for name, trajectory in tool_motions(motion).items()}
    if np.isfinite(read_rate_limits(arm).velocity).all():
        parts.append(say("below_rates", lang))
    if motion.line is None:
        return " ".join([*parts, say("no_line", lang, joint=lengths["joint"])])
    key = "turn_path" if task_of(arm).turns_only else "line_path"
    least = number(motion.line.least_singular_value, lang)
    return " ".join([*parts, say(key, lang, **lengths, least=least)])


def path_length(arm: Arm, trajectory: Any) -> float:
    """Return the length of the tool's path (m), as that of the chords between many points of it."""
    q = sample_motion(trajectory, np.linspace(0.0, trajectory.end_time(), 1001)).q
    return float(np.linalg.norm(np.diff(tool_points(arm, q), axis=0), axis=1).sum())


KIND = Kind("path", lambda arm, lang: None, path_figure, caption)
