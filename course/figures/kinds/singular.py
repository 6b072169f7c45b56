"""The singular configurations of an arm: one panel a family beside a generic pose, with what is lost in each."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.ellipsoid import draw_ellipsoid
from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import say, values_text
from armproof.course.figures.drawing.panels import PanelTitle, columns_of, make_panels
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import STROKES, WIDTHS, styled
from armproof.course.figures.drawing.symbols import Look, draw_arm
from armproof.course.figures.facts.families import singularities_of
from armproof.course.figures.facts.lost import LostDirection, lost_direction, reachable_rates
from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.numeric.joint_values import outside_limits
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import Projection, choose_projection, plane_projection
from armproof.verification.singularities.families import Family, SingularityAnalysis

_ELLIPSE = 10.0  # mm: the longest half axis
_ARROW = 11.0  # mm
_MARGIN = 11.0  # mm
_HEIGHTS = (40.0, 62.0)  # mm, of a panel
_LOOK = Look(size=0.7, width=1.6)
_TRIED, _SEED = 60, 2019
_STEP = np.radians(15)
_CLEAR = 0.08  # of the largest singular value: the least that a rank needs
LETTERS = "abcdefghijklmnopqrstuvwxyz"
_LOST, _REACHED = STROKES[1], STROKES[0]


@dataclass(frozen=True, eq=False)
class SingularPose:
    """A configuration on a family, and what is lost at it.

    Attributes:
        q: (n,) joint values (rad, m), the nearest to the generic pose.
        within_limits: whether all joints are within theirs.
    """

    family: Family
    q: np.ndarray
    lost: LostDirection
    within_limits: bool


@lru_cache(maxsize=64)
def singular_poses(arm: Arm) -> tuple[SingularPose, ...]:
    """Return a configuration of each family of singular configurations that the arm has at its own lengths."""
    analysis = singularities_of(arm)
    generic = showing_pose(arm)
    found = []
    for family in analysis.families:
        q = _plainest(analysis, family, generic) if family.exists else None
        if q is not None:
            lost = lost_direction(arm, analysis.frame, analysis.rows, q, generic, family.rank)
            found.append(SingularPose(family, q, lost, not outside_limits(arm, q).any()))
    return tuple(found)


def _plainest(analysis: SingularityAnalysis, family: Family, generic: np.ndarray) -> np.ndarray | None:
    """Return a configuration of a family near a generic one where no other family meets it; None if it has none.

    The generic one is projected on the family, and then others around it, until one has the rank of the family by far.
    """
    polynomials = [factor.polynomial for factor in family.factors]
    rng = np.random.default_rng(_SEED)
    tried = generic + _STEP * np.vstack([np.zeros_like(generic), rng.integers(-2, 3, (_TRIED, len(generic)))])
    q, good = family.sampler.project(polynomials, tried)
    q = q[good] if good.any() else family.sample(rng, _TRIED)
    if not len(q):
        return None
    J = NumericKinematics(family.arm, q).jacobian(analysis.frame)[:, [row - 1 for row in analysis.rows]]
    sizes = np.linalg.svd(J, compute_uv=False)
    clear = sizes[:, max(family.rank, 1) - 1] / np.maximum(sizes[:, 0], 1e-300)
    best = q[int(np.argmax(np.minimum(clear, _CLEAR)))]  # the first of those that are clear enough
    best[np.abs(best) < 1e-15] = 0.0
    best[np.abs(best + np.pi) < 1e-12] = np.pi
    best.flags.writeable = False
    return np.asarray(best)


@styled()
def singular(arm: Arm, lang: str = "") -> Figure:
    """Return the arm at a generic pose and on each family of its singular configurations.

    Each panel has the condition, the rank of the Jacobian, the ellipsoid of the velocities that joint rates of norm 1 give
    at the point concerned, and as an arrow the direction that is lost (with two heads where it is a rotation).

    Raises:
        LanguageError: a language that the labels are not written in.
    """
    poses, analysis, generic = singular_poses(arm), singularities_of(arm), showing_pose(arm)
    titles = [PanelTitle(say("generic_pose", lang), [say("rank", lang, rank=analysis.generic_rank)])]
    titles += [_title(letter, pose, lang) for letter, pose in zip(LETTERS, poses, strict=False)]
    configurations = np.array([generic, *(pose.q for pose in poses)])
    width = WIDTHS["page"] / columns_of(len(titles))
    fit = Fit(arm, configurations, _projection(arm, poses), margin=_MARGIN, size=_LOOK.size)
    height = fit.height(width, _HEIGHTS)
    view = fit.view(width, height)
    figure, panels = make_panels(titles, height)
    sizes = _sizes(arm, poses, generic)
    scenes = []
    for panel, q in zip(panels, configurations, strict=True):
        scene = Scene.show(figure, panel.box, view)
        draw_arm(scene, arm, q, _LOOK)
        scenes.append(scene)
    _draw_generic(scenes[0], arm, poses, generic, sizes)
    for scene, pose in zip(scenes[1:], poses, strict=True):
        _draw_lost(scene, arm, pose, sizes[pose.lost.kind], lang)
    return finish(figure, *scenes)


def _title(letter: str, pose: SingularPose, lang: str) -> PanelTitle:
    family = pose.family
    facts = [say("rank", lang, rank=family.rank)]
    if family.position is not None and say(family.position.kind, lang):
        facts.append(say(family.position.kind, lang))
    if not pose.within_limits:
        facts.append(say("beyond_limits", lang))
    return PanelTitle(family.latex, facts, is_math=True, letter=letter)


def _projection(arm: Arm, poses: tuple[SingularPose, ...]) -> Projection:
    """Return the view along the parallel axes of an arm whose lost directions lie across them, else its own."""
    flat = plane_projection(arm)
    if flat is not None and all(abs(flat.along(pose.lost.direction)) < 1e-6 for pose in poses):
        return flat
    return choose_projection(arm)


def _sizes(arm: Arm, poses: tuple[SingularPose, ...], generic: np.ndarray) -> dict[str, float]:
    """Return how many mm a unit of velocity and of rotation is, the same in all panels."""
    longest = {"velocity": 1e-12, "rotation": 1e-12}
    for pose in poses:
        for q in (generic, pose.q):
            size = np.linalg.norm(rates_at(arm, pose.lost, q), 2)
            longest[pose.lost.kind] = max(longest[pose.lost.kind], float(size))
    return {kind: _ELLIPSE / size for kind, size in longest.items()}


def rates_at(arm: Arm, lost: LostDirection, q: np.ndarray) -> np.ndarray:
    """Return the matrix (3, k) whose image of the unit ball is drawn; see `reachable_rates`."""
    analysis = singularities_of(arm)
    return reachable_rates(arm, analysis.frame, analysis.rows, lost, q)


def _draw_generic(
    scene: Scene, arm: Arm, poses: tuple[SingularPose, ...], q: np.ndarray, sizes: dict[str, float]
) -> None:
    """Draw, at the generic pose, each ellipsoid that collapses in one of the panels."""
    kinds = {(pose.lost.kind, pose.lost.frame): pose.lost for pose in poses if pose.lost.frame is not None}
    for (kind, frame), lost in kinds.items():
        B = rates_at(arm, lost, q)
        centre = NumericKinematics(arm, q[None]).pose(str(frame))[0, :3, 3]
        stroke = _REACHED if kind == "velocity" else STROKES[2]
        draw_ellipsoid(scene, centre, B, scene.metres(sizes[kind]), stroke, gid=f"ellipsoid {kind}")


def _draw_lost(scene: Scene, arm: Arm, pose: SingularPose, size: float, lang: str) -> None:
    lost = pose.lost
    B = rates_at(arm, lost, pose.q)
    stroke = _REACHED if lost.kind == "velocity" else STROKES[2]
    draw_ellipsoid(scene, lost.point, B, scene.metres(size), stroke, gid=f"ellipsoid {lost.kind}")
    vector = scene.metres(_ARROW) * lost.direction
    for sign in (1, -1):
        tip = scene.arrow(
            lost.point, sign * vector, colour=_LOST.colour, width=1.4, zorder=7, gid="lost" if sign > 0 else "",
            double=lost.kind == "rotation",
        )  # fmt: skip
        if sign > 0:
            scene.label(say(f"lost_{lost.kind}", lang), tip, tip - scene.paper(lost.point), colour=_LOST.colour)
        if abs(scene.projection.along(lost.direction)) > 0.99:
            break


def reason(arm: Arm, lang: str) -> str | None:
    """Return why an arm has no such figure; None if it has a singular configuration."""
    analysis = singularities_of(arm)
    if singular_poses(arm):
        return None
    return say("always_regular", lang) if analysis.complete else say("not_analysed", lang, reason=analysis.message)


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the determinant, and each pose with its rank."""
    analysis = singularities_of(arm)
    parts = [say("determinant_is", lang, latex=analysis.factored)] if analysis.factored else []
    generic = values_text(arm, showing_pose(arm), lang)
    parts.append(say("generic_caption", lang, pose=generic, rank=analysis.generic_rank))
    for letter, pose in zip(LETTERS, singular_poses(arm), strict=False):
        words = {"letter": letter, "condition": pose.family.latex, "rank": pose.family.rank}
        parts.append(say("family_caption", lang, pose=values_text(arm, pose.q, lang), **words))
    return " ".join([*parts, say("ellipse_caption", lang)])


KIND = Kind("singular", reason, singular, caption, empty=True)
