"""Pictures of an arm: at its zero pose with its frames, and at a counterexample where the printed and the true differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup

from armproof.models.arm import Arm
from armproof.models.errors import written
from armproof.models.language import look_up, noted
from armproof.models.showing.projection import choose_projection
from armproof.models.showing.skeleton import Skeleton, place_skeleton
from armproof.verification.report.html.sketch import Sketch
from armproof.verification.report.html.templating import heading
from armproof.verification.verdict import Drawn, Record

_SEED = 5  # of the configurations that tell how far an arm reaches
_TOLD = {
    "pose": noted("the pose of frame {frame}"),
    "axis": noted("the axis at frame {frame}"),
    "difference": noted("the vector from frame {frame}"),
    "velocity": noted("the velocity of the origin of frame {frame} when joint {joint} alone moves at 1 {unit}"),
    "angular velocity": noted("the angular velocity of frame {frame} when joint {joint} alone moves at 1 {unit}"),
}


@dataclass(frozen=True)
class Figure:
    """A picture and the words below it."""

    svg: Markup
    caption: str


class ArmPainter:
    """Draws one arm, always from the side from which the figures of the course show it.

    `claimed` is what a side that is not the arm's is called: "printed" in a document, "yours" in a student's answer.
    """

    def __init__(self, arm: Arm, claimed: str = noted("printed")) -> None:
        self.arm = arm
        self.claimed = claimed
        self.last = arm.frames[-1]  # the tool
        rng = np.random.default_rng(_SEED)
        poses = [place_skeleton(arm, np.zeros(len(arm.joints)))]
        poses += [place_skeleton(arm, rng.uniform(0.2, 1.2, len(arm.joints))) for _ in range(3)]
        points = np.concatenate([pose.line(self.last) for pose in poses])
        self.projection = choose_projection(arm)
        self.reach = max(float(np.linalg.norm(np.ptp(points, axis=0))), 1e-3)

    def at_zero(self) -> Figure:
        """Return the arm at its zero pose, a triad at each of its frames."""
        pose = place_skeleton(self.arm, np.zeros(len(self.arm.joints)))
        sketch = self._sketch(pose, self.reach / 7)
        for names, frame in _by_place(pose, self.arm.frames):
            sketch.frame(
                frame, "frame", names[-1] if len(names) == 1 and names[0] in (self.arm.frames[0], self.last) else ""
            )
            sketch.text(frame[:3, 3], "{" + ", ".join(names) + "}", "label")
        words = written(
            "The arm {arm} at its zero pose, with its frames {frames}", arm=self.arm.name, frames=list(self.arm.frames)
        )
        return Figure(Markup(sketch.write(words)), look_up("Zero pose; each frame is drawn by its three axes."))

    def at_counterexample(self, record: Record) -> Figure | None:
        """Return the arm at the counterexample of a refuted record, the printed side dashed beside the true one."""
        q = [record.counterexample.get(joint.symbol) for joint in self.arm.joints]
        if not q or any(value is None for value in q):
            return None
        pose = place_skeleton(self.arm, np.array(q, dtype=float))
        drawn = record.discrepancy.drawn if record.discrepancy is not None else None
        size = max(self.reach / 4.5, 1e-3)
        sketch = self._sketch(pose, size)
        sketch.frame(pose.frames[self.arm.frames[0]], "frame", self.arm.frames[0])
        if drawn is None or drawn.frame not in pose.frames:
            sketch.frame(pose.frames[self.last], "true", self.last)
            words = written("The arm {arm} at the counterexample", arm=self.arm.name)
            return Figure(Markup(sketch.write(words)), look_up("The arm at the counterexample."))
        self._draw_both(sketch, drawn, pose)
        what, dashed = self._what(drawn), self._dashed()
        told = noted("The arm {arm} at the counterexample: {what}, as it is and {dashed}")
        words = written(told, arm=self.arm.name, what=what, dashed=dashed)
        return Figure(
            Markup(sketch.write(words)),
            written("{what}: solid as it is, dashed {dashed}.", what=heading(what), dashed=dashed),
        )

    def moved(
        self, q: np.ndarray, window: np.ndarray, drawn: Drawn | None, around: Sequence[tuple[str, str, np.ndarray]]
    ) -> Markup:
        """Return the arm at a configuration (n,) in a window that stays while it moves.

        Args:
            drawn: a side that is claimed, beside the true one.
            around: closed lines (K, 2) of the paper: each with the frame that it is drawn about, and true or printed.
        """
        pose = place_skeleton(self.arm, q)
        sketch = self._sketch(pose, self.reach / 6)
        sketch.window = window
        for frame, kind, line in around:
            sketch.outline(pose.frames[frame][:3, 3], line, kind)
        if drawn is not None:
            self._draw_both(sketch, drawn, pose)
        return Markup(sketch.write(written("The arm {arm} as its sliders have it", arm=self.arm.name)))

    def _what(self, drawn: Drawn) -> str:
        terms = {"frame": drawn.frame}
        if drawn.joint:
            joint = self.arm.joints[drawn.joint - 1]
            terms |= {"joint": str(drawn.joint), "unit": "rad/s" if joint.kind == "revolute" else "m/s"}
        return written(_TOLD[drawn.kind], **terms)

    def _dashed(self) -> str:
        return look_up("as printed") if self.claimed == "printed" else look_up("as you have it")

    def _draw_both(self, sketch: Sketch, drawn: Drawn, pose: Skeleton) -> None:
        true, printed = np.array(drawn.true), np.array(drawn.printed)
        if drawn.kind == "pose":
            sketch.line([true[:3, 3], printed[:3, 3]], "apart")
            sketch.frame(true, "true", drawn.frame)
            sketch.frame(printed, "printed", f"{drawn.frame}′")
            return
        origin = pose.frames[drawn.frame][:3, 3]
        longest = max(float(np.linalg.norm(true)), float(np.linalg.norm(printed)), 1e-9)
        size = 1.0 if drawn.kind == "difference" else 2 * sketch.triad / longest
        for side, kind, word in ((true, "true", look_up("true")), (printed, "printed", look_up(self.claimed))):
            sketch.arrow(origin, origin + size * side[:, 0], kind, word)

    def _sketch(self, pose: Skeleton, triad: float) -> Sketch:
        sketch = Sketch(self.projection, triad)
        sketch.line(pose.line(self.last), "link")
        for joint in pose.joints:
            if not self.projection.planar:
                reach = 0.4 * triad * np.array(joint.axis)
                sketch.line([np.array(joint.start) - reach, np.array(joint.start) + reach], "joint-axis")
            if joint.kind == "prismatic":
                sketch.line([joint.start, joint.end], "rail")
        for joint in pose.joints:
            sketch.dot(joint.start, joint.kind)
        return sketch


def _by_place(pose: Skeleton, names: tuple[str, ...]) -> list[tuple[list[str], np.ndarray]]:
    """Return the frames by the place of their origins, the last of each place for its axes."""
    places: dict[tuple[float, ...], tuple[list[str], np.ndarray]] = {}
    for name in names:
        frame: np.ndarray = pose.frames[name]
        key = tuple(np.round(frame[:3, 3], 6) + 0.0)
        together = places[key][0] if key in places else []
        places[key] = ([*together, name], frame)
    return list(places.values())


def painter_of(arm: Arm | None, claimed: str = "printed") -> ArmPainter | None:
    """Return the painter of an arm, None without one or where it has no joints to draw."""
    return ArmPainter(arm, claimed) if arm is not None and arm.joints else None
