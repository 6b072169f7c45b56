"""An arm in the student's hands: sliders move it, with the answer, the truth, what it can do there and det J in one picture."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from armproof.course.feedback.notebook import render
from armproof.course.feedback.outcome import pretty
from armproof.course.feedback.picture import claimed_jacobian, drawn_at
from armproof.course.figures.facts.moving import UNITS, Moving, columns_of, moving_of
from armproof.course.figures.facts.task import joint_ranges, volume_unit
from armproof.models.arm import Arm
from armproof.models.errors import ArmproofError, ModelError, written
from armproof.models.language import look_up, number_text, use
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.stage import Stage
from armproof.verification.functions.asked import read_asked
from armproof.verification.functions.returned import NotAttempted
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.report.html.figures import ArmPainter
from armproof.verification.verdict import Drawn

_Claim = tuple[
    Drawn | None, np.ndarray | None, str
]  # what is drawn of an answer, or its Jacobian, or why there is neither
_TURN = np.column_stack([np.cos(np.linspace(0, 2 * np.pi, 49)), np.sin(np.linspace(0, 2 * np.pi, 49))])


@dataclass(frozen=True, eq=False)
class HandsOn:
    """An arm that sliders move in a notebook.

    Attributes:
        arm: the arm.
        asked: what the answer is of, as a document's front matter writes it.
        answer: gives what the student has, as an array, of the joint values by their symbols; without one, the arm alone.
        in_3d: whether Drake's Meshcat viewer shows it too.
        lang: the language of its words.
    """

    arm: Arm
    asked: Mapping[str, Any] | None = None
    answer: Callable[[Mapping[str, float]], np.ndarray] | None = None
    in_3d: bool = False
    lang: str = ""

    @cached_property
    def moving(self) -> Moving:
        """What moves the arm."""
        return moving_of(self.arm)

    @cached_property
    def _painter(self) -> ArmPainter:
        return ArmPainter(self.arm, "yours")

    @cached_property
    def _quantity(self) -> Any:
        return None if self.asked is None else read_asked(self.arm, self.asked)[0].quantity

    @cached_property
    def _stage(self) -> Stage | str:
        """Drake's viewer, or why there is none."""
        try:
            return Stage(self.arm)
        except ModelError as problem:
            return str(problem)

    def picture(self, q: np.ndarray) -> str:
        """Return the arm at a configuration (n,), the answer beside the truth, as HTML."""
        return self._pictured(q, self._claimed(q))

    def _pictured(self, q: np.ndarray, claim: _Claim) -> str:
        task, (drawn, claimed, problem) = self.moving.task, claim
        J = NumericKinematics(self.arm, q[None]).jacobian(task.frame)[0]
        with use(self.lang):
            around = [(task.frame, "true", self._outline(J))]
            if claimed is not None:
                around.append((task.frame, "printed", self._outline(claimed)))
            svg = self._painter.moved(q, self.moving.window, drawn, around)
            told = [self._told(J), look_up("Shaded: the velocities of the tool for joint rates of norm 1.")]
            if claimed is not None or drawn is not None:
                told.append(look_up("Dashed: as you have it."))
            if claimed is not None:
                told.append(written("With yours: {values}.", values=self._told(claimed).rstrip(".")))
            return render("moved.html", "open", svg=svg, told=[*told, problem] if problem else told)

    def _claimed(self, q: np.ndarray) -> _Claim:
        """Return what the answer says at a configuration."""
        if self.answer is None or self.asked is None:
            return None, None, ""
        at = {joint.symbol: float(value) for joint, value in zip(self.arm.joints, q, strict=True)}
        try:
            obtained = self.answer(at)
            if self._quantity.kind != "jacobian" or self._quantity.frame != self.moving.task.frame:
                return drawn_at(self.arm, self.asked, obtained, at), None, ""
            true = NumericKinematics(self.arm, q[None]).jacobian(self._quantity.frame)[0]
            return None, claimed_jacobian(self._quantity, true, obtained), ""
        except NotAttempted:
            return None, None, ""
        except ArmproofError as reason:
            with use(self.lang):
                return None, None, written("Your answer cannot be drawn: {reason}", reason=str(reason))

    def _outline(self, J: np.ndarray) -> np.ndarray:
        U, sizes, _ = np.linalg.svd(self.moving.ellipse(J), full_matrices=False)
        return np.asarray(_TURN[:, : len(sizes)] @ (U * sizes).T)

    def _told(self, J: np.ndarray) -> str:
        """Return det J of a Jacobian (6, n) where it has one, and the manipulability w."""
        rows = self.moving.task.places
        J = J[
            :, columns_of(getattr(self._quantity, "columns", None), J.shape[1])
        ]  # as the answer has them: det J has its sign
        unit = volume_unit(self.arm, self.moving.task.rows, range(1, len(self.arm.joints) + 1))
        values = {"w": float(np.sqrt(max(np.linalg.det(J[rows] @ J[rows].T), 0.0)))}
        if len(rows) == len(self.arm.joints):
            values = {"det J": float(np.linalg.det(J[rows])), **values}
        texts = {name: number_text(round(value, 9) + 0.0, ".3g").replace("-", "−") for name, value in values.items()}
        return "; ".join(f"{name} = {text} {unit}".strip() for name, text in texts.items()) + "."

    def widget(self) -> Any:
        """Return the sliders with the picture, which every move of one of them draws anew."""
        import ipywidgets

        units, scales = zip(*(UNITS[joint.kind] for joint in self.arm.joints), strict=True)
        sliders = [
            ipywidgets.FloatSlider(
                value=scale * value, min=scale * low, max=scale * high, step=1.0, readout_format=".0f",
                description=f"{pretty(symbol_as_latex(joint.symbol))} ({unit})",
            )
            for joint, unit, scale, value, (low, high) in zip(
                self.arm.joints, units, scales, self.moving.start, joint_ranges(self.arm), strict=True
            )
        ]  # fmt: skip
        picture = ipywidgets.HTML()

        def move(_: Any = None) -> None:
            q = np.array([slider.value / scale for slider, scale in zip(sliders, scales, strict=True)])
            claim = self._claimed(q)
            picture.value = self._pictured(q, claim)
            self._show_in_space(q, claim[0])

        for slider in sliders:
            slider.observe(move, names="value")
        move()
        with use(self.lang):
            space = [ipywidgets.HTML(value=self._frame())] if self.in_3d else []
        return ipywidgets.VBox([*sliders, picture, *space])

    def _show_in_space(self, q: np.ndarray, drawn: Drawn | None) -> None:
        """Move the arm in Drake's viewer too, and the frame that the answer has."""
        if not self.in_3d or isinstance(self._stage, str):
            return
        self._stage.move(q)
        if drawn is not None and drawn.kind == "pose":
            self._stage.mark(np.array(drawn.printed), self._painter.reach / 6)

    def _frame(self) -> str:
        """Return Drake's viewer as a part of the page, or why there is none."""
        if isinstance(self._stage, str):
            return str(Markup("<p>{}</p>").format(self._stage))
        address = self._stage.meshcat.web_url()
        told = written(
            "If nothing is seen here: open {address} on the machine that runs the notebook.", address=address
        )
        frame = '<iframe src="{}" title="Meshcat" width="100%" height="400"></iframe><p>{}</p>'
        return str(Markup(frame).format(address, told))

    def _repr_mimebundle_(self, **_: Any) -> dict[str, Any]:
        """Return the sliders; where there are none, the picture and what is missing."""
        still = self.picture(self.moving.start)
        if importlib.util.find_spec("ipywidgets") is None:
            with use(self.lang):
                missing = written("The sliders need ipywidgets: {command}", command="pip install ipywidgets")
            return {"text/html": str(Markup("{}<p>{}</p>").format(Markup(still), missing)), "text/plain": missing}
        shown: dict[str, Any] = self.widget()._repr_mimebundle_()
        return {**shown, "text/html": still}
