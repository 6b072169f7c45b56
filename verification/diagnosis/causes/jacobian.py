"""Slips in a Jacobian as a matrix: its blocks, its columns, its rows, the frame and the point it is meant for."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from armproof.verification.diagnosis.causes.case import Candidate, Case

_SWAPPED = [3, 4, 5, 0, 1, 2]


def jacobian_candidates(case: Case) -> Iterator[Candidate]:
    """Yield what else a Jacobian could be taken for."""
    quantity = case.quantity
    if quantity.kind != "jacobian":
        return
    J = case.kinematics.jacobian(quantity.frame, quantity.reference, case.arm.frames[0])
    yield "the blocks are swapped: the rows are [ω; v], [v; ω] is meant", case.selected(J[:, _SWAPPED])
    yield "the Jacobian is transposed: its rows stand as columns", case.selected(J).transpose(0, 2, 1)
    yield from _transposed_too(case, J)
    yield from _blocks_of_rows(case, J)
    yield from _absolute_angles(case, J)
    yield from _in_other_frames(case, J)
    yield from _of_other_points(case, J)
    yield from _columns(case, J)
    yield from _scaled(case, J)
    yield from _rows(case, J)


def _transposed_too(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    for words, rows in (("its linear part alone", slice(0, 3)), ("its angular part alone", slice(3, 6))):
        yield f"the Jacobian is transposed, and is {words}", J[:, rows].transpose(0, 2, 1)


def _blocks_of_rows(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    """Rows of ω before those of v, where only some are asked for."""
    rows = [row - 1 for row in case.quantity.rows or ()]
    order = [row for row in rows if row >= 3] + [row for row in rows if row < 3]
    if order != rows:
        yield "the blocks are swapped: the rows of ω stand before those of v", case.selected_columns(J[:, order])


def _in_other_frames(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    frame, reference = case.quantity.frame, case.quantity.reference
    for other in case.arm.frames:
        if other == reference:
            continue
        tool = ", the tool's own" if other == frame else ""
        words = f"it is expressed in frame {other}{tool}, not {reference}"
        yield words, case.selected(case.kinematics.jacobian(frame, other, case.arm.frames[0]))
        R = case.kinematics.pose(other, reference)[:, :3, :3]
        yield (
            f"it is turned by the rotation of frame {other} where it should not be",
            case.selected(np.concatenate([R @ J[:, :3], R @ J[:, 3:]], axis=1)),
        )


def _of_other_points(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    quantity = case.quantity
    for other in case.arm.frames:
        if other == quantity.frame:
            continue
        point = case.kinematics.jacobian(other, quantity.reference, case.arm.frames[0])
        words = f"its linear part is that of the origin of frame {other}, not {quantity.frame}"
        yield words, case.selected(np.concatenate([point[:, :3], J[:, 3:]], axis=1))
        yield f"this is the Jacobian of frame {other}, not {quantity.frame}", case.selected(point)


def point_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the Jacobian of another point of the last body."""
    quantity = case.quantity
    if quantity.kind != "jacobian":
        return
    J = case.kinematics.jacobian(quantity.frame, quantity.reference, case.arm.frames[0])
    for other in case.arm.frames:
        shift = case.kinematics.pose(other, quantity.reference)[:, None, :3, 3]
        end = case.kinematics.pose(quantity.frame, quantity.reference)[:, None, :3, 3]
        moved = J.copy()  # v of the body's point at the origin of another frame
        moved[:, :3] = J[:, :3] + np.cross(J[:, 3:].transpose(0, 2, 1), shift - end).transpose(0, 2, 1)
        yield (
            f"its linear part is that of the body's point at the origin of frame {other}, not {quantity.frame}: "
            "z × (p_n - p) takes the wrong p_n",
            case.selected(moved),
        )


def _columns(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    joints = case.arm.joints
    n = len(joints)
    for k, joint in enumerate(joints):
        turned, gone = J.copy(), J.copy()
        turned[:, :, k] *= -1
        gone[:, :, k] = 0
        yield (
            f"column {k + 1}: joint {joint.symbol} is taken the other way, the sign of its column is wrong",
            case.selected(turned),
        )
        yield f"column {k + 1} is missing: zeros stand in its place", case.selected(gone)
    yield "the columns stand in the wrong order, from tool to base", case.selected(J[:, :, ::-1])
    for i in range(n):
        for j in range(i + 1, n):
            order = list(range(n))
            order[i], order[j] = j, i
            yield f"columns {i + 1} and {j + 1} are swapped", case.selected(J[:, :, order])
    for shift in range(1, n):
        yield "the columns stand in the wrong order: they are shifted", case.selected(np.roll(J, shift, axis=2))


def _absolute_angles(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    """Derivatives with respect to the angles of the links from the base: the inner derivative of θ_1 + θ_2 is missing.

    With φ_k = θ_1 + … + θ_k, column k is ∂x/∂φ_k = J_k − J_{k+1} where the chain rule makes it a sum of those from k on.
    """
    revolute = [k for k, joint in enumerate(case.arm.joints) if joint.kind == "revolute"]
    if len(revolute) < 2:
        return
    words = (
        "the chain rule is missing: the columns are derivatives with respect to absolute angles, "
        "θ_1 + θ_2 depends on both θ_1 and θ_2"
    )
    absolute, summed = J.copy(), J.copy()
    for k, after in pairwise(revolute):
        absolute[:, :, k] -= J[:, :, after]
    yield words, case.selected(absolute)
    yield words, case.selected(np.concatenate([absolute[:, :3], J[:, 3:]], axis=1))
    for k, after in pairwise(revolute):
        one = J.copy()
        one[:, :3, k] -= J[:, :3, after]
        symbol, other = case.arm.joints[k].symbol, case.arm.joints[after].symbol
        words = f"column {k + 1}: the chain rule is missing, {symbol} moves the links after joint {other} too"
        yield words, case.selected(one)
    for k in reversed(revolute[:-1]):
        summed[:, :, k] += summed[:, :, revolute[revolute.index(k) + 1]]
    yield "the columns are summed up twice: those of relative angles are sums already", case.selected(summed)


def _scaled(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    revolute = np.array([joint.kind == "revolute" for joint in case.arm.joints])
    for words, factor in (
        ("it is per degree: the columns of revolute joints are per radian", np.pi / 180),
        ("it is in degrees: the columns of revolute joints are multiplied by 180/π", 180 / np.pi),
    ):
        yield words, case.selected(np.where(revolute, J * factor, J))
    for words, factor in (("in millimetres", 1000.0), ("in kilometres", 0.001)):
        scaled = J.copy()
        scaled[:, :3] *= np.where(revolute, factor, 1.0)
        yield f"the lengths are {words}: they are in metres", case.selected(scaled)
        scaled = J.copy()
        scaled[:, :3] *= factor
        yield f"the linear part is {words}: lengths are in metres", case.selected(scaled)
    for words, factor in (("the sign of the whole is wrong", -1.0), ("the whole is doubled", 2.0)):
        yield words, case.selected(J * factor)


def _rows(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    for words, rows in (("linear", slice(0, 3)), ("angular", slice(3, 6))):
        gone, turned = J.copy(), J.copy()
        gone[:, rows] = 0
        turned[:, rows] *= -1
        yield f"the {words} part is missing: zeros stand in its place", case.selected(gone)
        yield f"the sign of the {words} part is wrong", case.selected(turned)
    for block, start in (("v", 0), ("ω", 3)):
        for i, j in ((0, 1), (0, 2), (1, 2)):
            order = list(range(6))
            order[start + i], order[start + j] = start + j, start + i
            yield (
                f"rows {start + i + 1} and {start + j + 1}, {'xyz'[i]} and {'xyz'[j]} of {block}, are swapped",
                case.selected(J[:, order]),
            )
    for i in range(6):
        turned = J.copy()
        turned[:, i] *= -1
        yield f"the sign of row {i + 1} is wrong", case.selected(turned)
