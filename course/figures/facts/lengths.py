"""The lengths between the frames of an arm: along z and x where they are DH frames, along the axes of the frame before elsewhere."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from armproof.course.figures.facts.dh_rows import LinkRow, linear_form, link_rows
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.dh.entry import LinearForm

_SHORTEST = 1e-9  # m


@dataclass(frozen=True, eq=False)
class FrameLength:
    """A length on the way from one frame to the next.

    Attributes:
        previous, frame: their names.
        start, end: points (3,) in frame 0 (m).
        form: how long it is.
    """

    previous: str
    frame: str
    start: np.ndarray
    end: np.ndarray
    form: LinearForm


def frame_lengths(arm: Arm, names: Sequence[str], poses: Mapping[str, np.ndarray]) -> list[FrameLength]:
    """Return the lengths between successive frames, those that are zero left out.

    Args:
        names: the frames, base to tool.
        poses: of each, (4, 4) in frame 0.
    """
    rows = link_rows(arm)
    by_frame = {row.frame: row for row in rows.rows} if rows else {}
    found = []
    for previous, frame in pairwise(names):
        before, after = poses[previous], poses[frame]
        row = by_frame.get(frame)
        if row is None or rows is None:
            way = _along_axes(arm, previous, frame, before)
        else:
            way = _along_link(rows.convention, row, before, after)
        at = before[:3, 3]
        for axis, form in way:
            beyond = at + ((after[:3, 3] - at) @ axis) * axis
            if form != LinearForm() and np.linalg.norm(beyond - at) > _SHORTEST:
                found.append(FrameLength(previous, frame, at, beyond, form))
            at = beyond
    return found


def _along_link(
    convention: str, row: LinkRow, before: np.ndarray, after: np.ndarray
) -> list[tuple[np.ndarray, LinearForm]]:
    """Return the axes that d and a lie along, in the order in which the link matrix takes them."""
    if convention == "classic":
        return [(before[:3, 2], row.d), (after[:3, 0], row.a)]
    return [(before[:3, 0], row.a), (after[:3, 2], row.d)]


def _along_axes(arm: Arm, previous: str, frame: str, before: np.ndarray) -> list[tuple[np.ndarray, LinearForm]]:
    """Return the axes z, x, y of a frame, and how far along each the next frame's origin lies, as positive lengths."""
    at_zero, slopes = _origin_slopes(arm, previous, frame)
    forms = [linear_form(at_zero[k], {symbol: slope[k] for symbol, slope in slopes.items()}, arm) for k in range(3)]
    return [(before[:3, k], _positive(forms[k])) for k in (2, 0, 1)]


def _positive(form: LinearForm) -> LinearForm:
    """Return a sum or its opposite, so that its first term is positive: a dimension has no sense."""
    factors = [*(factor for _, factor in form.symbols), form.number]
    if next((factor for factor in factors if factor), 1) > 0:
        return form
    return LinearForm(tuple((symbol, -factor) for symbol, factor in form.symbols), -form.pi, -form.number)


def _origin_slopes(arm: Arm, previous: str, frame: str) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Return the origin of a frame in the one before at q = 0, and its slopes in the prismatic variables and lengths."""
    n = len(arm.joints)
    at_zero = bulk_of(arm).pose(np.zeros((1, n)), frame, previous)[0, :3, 3]
    slopes = {}
    for k, joint in enumerate(arm.joints):
        if joint.kind == "prismatic":
            slopes[joint.symbol] = bulk_of(arm).pose(np.eye(n)[k : k + 1], frame, previous)[0, :3, 3] - at_zero
    for symbol, value in arm.lengths.items():
        changed = bulk_of(arm).with_values({symbol: value + 1.0})
        slopes[symbol] = changed.pose(np.zeros((1, n)), frame, previous)[0, :3, 3] - at_zero
    return at_zero, slopes
