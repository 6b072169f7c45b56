"""Slips in a Jacobian as a matrix: its blocks, its columns, its rows, the frame and the point it is meant for."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import Candidate, Case, changed
from armproof.verification.findings import Kind, say

_SWAPPED = [3, 4, 5, 0, 1, 2]


def other_jacobians(case: Case) -> Iterator[Candidate]:
    """Yield what else of the arm a Jacobian could be taken for."""
    J = case.whole
    yield say(Kind.BLOCKS_SWAPPED), case.selected(J[:, _SWAPPED])
    yield say(Kind.TRANSPOSED if case.is_printed else Kind.JACOBIAN_TRANSPOSED), case.selected(J).transpose(0, 2, 1)
    yield from _in_other_frames(case, J)
    yield from _of_other_points(case, J)


def jacobian_slips(case: Case) -> Iterator[Candidate]:
    """Yield a Jacobian with a slip in it as a matrix: its blocks, its columns, its rows, its units."""
    if case.quantity.kind != "jacobian":
        return
    J = case.whole
    yield from _transposed_too(case, J)
    yield from _blocks_of_rows(case, J)
    yield from _absolute_angles(case, J)
    yield from _columns(case, J)
    yield from _scaled(case, J)
    yield from _rows(case, J)


def _transposed_too(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    for part, rows in (("linear", slice(0, 3)), ("angular", slice(3, 6))):
        yield say(Kind.PART_TRANSPOSED, part=part), J[:, rows].transpose(0, 2, 1)


def _blocks_of_rows(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    """Rows of ω before those of v, where only some are asked for."""
    rows = [row - 1 for row in case.quantity.rows or ()]
    order = [row for row in rows if row >= 3] + [row for row in rows if row < 3]
    if order != rows:
        columns = kind_of(case.quantity).block(case.quantity, J.shape[2])[1]
        yield say(Kind.SOME_BLOCKS_SWAPPED), J[:, order][:, :, columns]


def _in_other_frames(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    frame, reference = case.quantity.frame, case.quantity.reference
    for other in case.arm.frames:
        if other == reference:
            continue
        kind = Kind.IN_TOOL_FRAME if other == frame and not case.is_printed else Kind.IN_OTHER_FRAME
        seen = case.kinematics.jacobian(frame, other, case.arm.frames[0])
        yield say(kind, other=other, reference=reference), case.selected(seen)
        R = case.kinematics.pose(other, reference)[:, :3, :3]
        turned = np.concatenate([R @ J[:, :3], R @ J[:, 3:]], axis=1)
        yield say(Kind.TURNED, other=other), case.selected(turned)


def _of_other_points(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    quantity = case.quantity
    for other in case.arm.frames:
        if other == quantity.frame:
            continue
        point = case.kinematics.jacobian(other, quantity.reference, case.arm.frames[0])
        frames = {"other": other, "frame": quantity.frame}
        linear = say(Kind.LINEAR_PART_OF_OTHER_FRAME, **frames)
        yield linear, case.selected(np.concatenate([point[:, :3], J[:, 3:]], axis=1))
        yield say(Kind.JACOBIAN_OF_OTHER_FRAME, **frames), case.selected(point)


def point_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the Jacobian of another point of the last body: with v of the point at the origin of another frame."""
    quantity, J = case.quantity, case.whole
    if quantity.kind != "jacobian":
        return
    end = case.kinematics.pose(quantity.frame, quantity.reference)[:, :3, 3:]
    for other in case.arm.frames:
        lever = case.kinematics.pose(other, quantity.reference)[:, :3, 3:] - end
        moved = changed(J, np.s_[:, :3], J[:, :3] + np.cross(J[:, 3:], lever, axis=1))
        yield say(Kind.OTHER_POINT, other=other, frame=quantity.frame), case.selected(moved)


def _columns(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    joints = case.arm.joints
    n = len(joints)
    for k, joint in enumerate(joints):
        place = np.s_[:, :, k]
        turned = changed(J, place, -J[place])
        number = case.column_of(k + 1)
        yield say(Kind.COLUMN_THE_OTHER_WAY, number=number, joint=joint.symbol), case.selected(turned)
        yield say(Kind.COLUMN_MISSING, number=number), case.selected(changed(J, place, 0))
    if (asked := case.quantity.columns) is not None and len(asked) == 1:
        for k in range(n):
            if k + 1 != asked[0]:
                yield (
                    say(Kind.OTHER_COLUMN, other=joints[k].symbol, joint=joints[asked[0] - 1].symbol),
                    case.selected(J[:, :, [k] * n]),
                )
        return
    yield say(Kind.COLUMNS_REVERSED), case.selected(J[:, :, ::-1])
    for i in range(n):
        for j in range(i + 1, n):
            order = list(range(n))
            order[i], order[j] = j, i
            yield say(Kind.COLUMNS_SWAPPED, one=i + 1, other=j + 1), case.selected(J[:, :, order])
    for shift in range(1, n):
        yield say(Kind.COLUMNS_SHIFTED), case.selected(np.roll(J, shift, axis=2))


def _absolute_angles(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    """Derivatives with respect to the angles of the links from the base: the inner derivative of θ_1 + θ_2 is missing.

    With φ_k = θ_1 + … + θ_k, column k is ∂x/∂φ_k = J_k − J_{k+1} where the chain rule makes it a sum of those from k on.
    """
    revolute = [k for k, joint in enumerate(case.arm.joints) if joint.kind == "revolute"]
    if len(revolute) < 2:
        return
    absolute, summed = J.copy(), J.copy()
    for k, after in pairwise(revolute):
        absolute[:, :, k] -= J[:, :, after]
    yield say(Kind.ABSOLUTE_DERIVATIVES), case.selected(absolute)
    yield say(Kind.ABSOLUTE_DERIVATIVES), case.selected(np.concatenate([absolute[:, :3], J[:, 3:]], axis=1))
    for k, after in pairwise(revolute):
        one = changed(J, np.s_[:, :3, k], J[:, :3, k] - J[:, :3, after])
        symbol, other = case.arm.joints[k].symbol, case.arm.joints[after].symbol
        yield say(Kind.CHAIN_RULE_IN_COLUMN, number=k + 1, joint=symbol, other=other), case.selected(one)
    for k in reversed(revolute[:-1]):
        summed[:, :, k] += summed[:, :, revolute[revolute.index(k) + 1]]
    yield say(Kind.COLUMNS_SUMMED_TWICE), case.selected(summed)


def _scaled(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    revolute = np.array([joint.kind == "revolute" for joint in case.arm.joints])
    for kind, factor in ((Kind.PER_DEGREE, np.pi / 180), (Kind.IN_DEGREES, 180 / np.pi)):
        yield say(kind), case.selected(np.where(revolute, J * factor, J))
    for unit, factor in (("millimetres", 1000.0), ("kilometres", 0.001)):
        for kind, factors in (
            (Kind.LENGTHS_IN_OTHER_UNIT, np.where(revolute, factor, 1.0)),
            (Kind.LINEAR_PART_IN_OTHER_UNIT, factor),
        ):
            yield say(kind, unit=unit), case.selected(changed(J, np.s_[:, :3], J[:, :3] * factors))
    for kind, factor in ((Kind.SIGN_OF_WHOLE, -1.0), (Kind.DOUBLED, 2.0)):
        yield say(kind), case.selected(J * factor)


def _rows(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    for part, rows in (("linear", np.s_[:, :3]), ("angular", np.s_[:, 3:])):
        yield say(Kind.PART_MISSING, part=part), case.selected(changed(J, rows, 0))
        yield say(Kind.SIGN_OF_PART, part=part), case.selected(changed(J, rows, -J[rows]))
    for block, start in (("v", 0), ("ω", 3)):
        for i, j in ((0, 1), (0, 2), (1, 2)):
            order = list(range(6))
            order[start + i], order[start + j] = start + j, start + i
            axes = {"axis": "xyz"[i], "other_axis": "xyz"[j], "part": block}
            finding = say(Kind.ROWS_OF_PART_SWAPPED, one=start + i + 1, other=start + j + 1, **axes)
            yield finding, case.selected(J[:, order])
    for i in range(6):
        yield say(Kind.SIGN_OF_ROW, number=i + 1), case.selected(changed(J, np.s_[:, i], -J[:, i]))
