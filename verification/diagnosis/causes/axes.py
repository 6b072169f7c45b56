"""Slips in the geometric construction of a Jacobian, [z × (p_n − p); z] a revolute joint and [z; 0] a prismatic one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from armproof.verification.diagnosis.causes.case import Candidate, Case, changed
from armproof.verification.findings import Finding, Kind, say

_CLOSE = 1e-9


def stacked(v: np.ndarray, omega: np.ndarray, slide: np.ndarray, prismatic: np.ndarray) -> np.ndarray:
    """Return (N, 6, n) from v and ω of revolute joints and v of prismatic ones, (N, n, 3) each."""
    linear = np.where(prismatic[:, None], slide, v)
    angular = np.where(prismatic[:, None], 0.0, omega)
    return np.concatenate([linear, angular], axis=2).transpose(0, 2, 1)


@dataclass(frozen=True, eq=False)
class Construction:
    """The axis of each joint, fixed in a frame whose origin lies on it.

    Attributes:
        index: of that frame among the arm's, for each joint.
        local: the axis in that frame, (n, 3).
        poses: (N, frames, 4, 4), in the frame in which the Jacobian is expressed.
        end: p_n, (N, 3).
    """

    index: tuple[int, ...]
    local: np.ndarray
    poses: np.ndarray
    end: np.ndarray
    prismatic: np.ndarray

    def axes(self, shift: int = 0) -> np.ndarray:
        """Return z of each joint, (N, n, 3), as it is in the frame `shift` further."""
        R = self.poses[:, self._shifted(shift)][..., :3, :3]
        return np.einsum("nkij,kj->nki", R, self.local)

    def origins(self, shift: int = 0) -> np.ndarray:
        """Return p of each joint, (N, n, 3), the origin of the frame `shift` further."""
        return np.asarray(self.poses[:, self._shifted(shift)][..., :3, 3])

    def jacobian(self, z: np.ndarray, p: np.ndarray) -> np.ndarray:
        """Return [z × (p_n − p); z], (N, 6, n)."""
        return stacked(np.cross(z, self.end[:, None] - p), z, z, self.prismatic)

    def _shifted(self, shift: int) -> list[int]:
        return [min(max(index + shift, 0), self.poses.shape[1] - 1) for index in self.index]

    @cached_property
    def convention(self) -> str:
        """Classic where joint i is fixed in frame i − 1, modified where it is in frame i, else an empty text."""
        if not (self.local[:, :2] == 0).all():
            return ""
        n = len(self.index)
        return {tuple(range(n)): "classic", tuple(range(1, n + 1)): "modified"}.get(self.index, "")


def constructions(case: Case, J: np.ndarray) -> list[Construction]:
    """Return the ways in which a Jacobian is constructed of the arm's frames: by frame i − 1, by frame i, by either."""
    arm, reference = case.arm, case.quantity.reference
    prismatic = np.array([joint.kind == "prismatic" for joint in arm.joints])
    poses = np.stack([case.kinematics.pose(frame, reference) for frame in case.frames], 1)
    end = case.kinematics.pose(case.quantity.frame, reference)[:, :3, 3]
    fitting = [_frames_on_axis(J, poses, end, k, prismatic[k]) for k in range(len(arm.joints))]
    if not all(fitting):
        return []
    found: dict[tuple[int, ...], Construction] = {}
    for pick in (min, max):
        index = tuple(pick(on) for on in fitting)
        local = np.array([on[i] for i, on in zip(index, fitting, strict=True)])
        found.setdefault(index, Construction(index, local, poses, end, prismatic))
    return list(found.values())


def _frames_on_axis(
    J: np.ndarray, poses: np.ndarray, end: np.ndarray, k: int, prismatic: bool
) -> dict[int, np.ndarray]:
    """Return the frames k and k + 1, as far as the axis of joint k is fixed in them and passes through their origins."""
    axis = J[:, :3, k] if prismatic else J[:, 3:, k]
    found = {}
    for index in (k, k + 1):
        if index >= poses.shape[1]:
            continue
        local = np.einsum("nji,nj->ni", poses[:, index, :3, :3], axis)
        through = prismatic or np.abs(np.cross(axis, end - poses[:, index, :3, 3]) - J[:, :3, k]).max() < _CLOSE
        if through and np.ptp(local, axis=0).max() < _CLOSE:
            found[index] = np.where(np.abs(local[0]) < _CLOSE, 0.0, local[0])
    return found


def axis_candidates(case: Case) -> Iterator[Candidate]:
    """Yield Jacobians constructed with a usual slip."""
    if case.quantity.kind != "jacobian":
        return
    J = case.whole
    reaches = np.abs(J).max(axis=(0, 1)) > 0  # joints that move the frame at all
    ways = constructions(case, J)
    for search in (_by_formula, _by_neighbours, _by_z):
        for way in ways:
            for finding, built in search(way):
                yield finding, case.selected(np.where(reaches, built, 0.0))
                if not reaches.all():
                    yield finding, case.selected(built)
    yield from _by_kind(case, J)


def _by_formula(way: Construction) -> Iterator[Candidate]:
    z, p, end, prismatic = way.axes(), way.origins(), way.end[:, None], way.prismatic
    yield say(Kind.SIGN_OF_CROSS_PRODUCT), stacked(np.cross(z, p - end), z, z, prismatic)
    yield say(Kind.CROSS_OF_ORIGIN), stacked(np.cross(z, p), z, z, prismatic)
    yield say(Kind.CROSS_OF_END), stacked(np.cross(z, np.broadcast_to(end, p.shape)), z, z, prismatic)
    first, following = way.poses[:, :1, :3, 3], way.origins(1)
    yield say(Kind.CROSS_OF_LINKS_BEFORE), stacked(np.cross(z, following - first), z, z, prismatic)
    yield say(Kind.CROSS_OF_OWN_LINK), stacked(np.cross(z, following - p), z, z, prismatic)
    yield say(Kind.NO_CROSS_PRODUCT), stacked(end - p, z, z, prismatic)
    if prismatic.any():
        yield say(Kind.PRISMATIC_AS_REVOLUTE), stacked(np.cross(z, end - p), z, z, np.zeros_like(prismatic))
        v = np.where(prismatic[:, None], z, np.cross(z, end - p))
        yield say(Kind.PRISMATIC_TURNING), stacked(v, z, z, np.zeros_like(prismatic))
    yield say(Kind.REVOLUTE_AS_PRISMATIC), stacked(z, z, z, np.ones_like(prismatic))


def _by_neighbours(way: Construction) -> Iterator[Candidate]:
    """The axis, the origin, or both, of the frame after or before."""
    for shift in (1, -1):
        own, other, where = _names(way.convention, shift)
        z, p = way.axes(shift), way.origins(shift)
        finding = say(Kind.NEIGHBOURING_AXIS, other=other, own=own, where=where)
        yield finding, way.jacobian(z, p)
        yield finding, way.jacobian(z, way.origins())
        p_own, p_other = own.replace("z", "p"), other.replace("z", "p")
        finding = say(Kind.NEIGHBOURING_ORIGIN, other=p_other, own=p_own, where=where)
        yield finding, way.jacobian(way.axes(), p)


def _names(convention: str, shift: int) -> tuple[str, str, Finding]:
    number = {"classic": -1, "modified": 0}.get(convention)
    if number is None:
        return "z_i", "z_{i+1}" if shift > 0 else "z_{i-1}", say(Kind.OF_THE_NEIGHBOUR)
    names = {-2: "z_{i-2}", -1: "z_{i-1}", 0: "z_i", 1: "z_{i+1}"}
    return names[number], names[number + shift], say(Kind.OF_THE_CONVENTION, convention=convention)


def _by_z(way: Construction) -> Iterator[Candidate]:
    """The z axis of every frame, on an arm whose joints turn about other axes of their frames."""
    if (way.local[:, :2] == 0).all() and (way.local[:, 2] == way.local[0, 2]).all():
        z = np.broadcast_to(way.axes()[:, :1], way.axes().shape)
        yield say(Kind.FIRST_AXIS_FOR_ALL), way.jacobian(z, way.origins())
        return
    upright = Construction(way.index, np.tile([0.0, 0.0, 1.0], (len(way.index), 1)), way.poses, way.end, way.prismatic)
    for shift in (0, 1, -1):
        yield _taken_for_axis(way.convention, shift), way.jacobian(upright.axes(shift), way.origins(shift))


def _taken_for_axis(convention: str, shift: int) -> Finding:
    if not (shift and convention):
        return say(Kind.Z_FOR_ALL)
    own, other, where = _names(convention, shift)
    return say(Kind.NEIGHBOURING_AXIS, other=other, own=own, where=where)


def _by_kind(case: Case, J: np.ndarray) -> Iterator[Candidate]:
    """One prismatic joint treated as a revolute one, or the other way round."""

    def column(k: int, v: np.ndarray, omega: np.ndarray) -> np.ndarray:
        return case.selected(changed(J, np.s_[:, :, k], np.concatenate([v, omega], axis=1)))

    end = case.kinematics.pose(case.quantity.frame, case.quantity.reference)[:, :3, 3]
    for k, joint in enumerate(case.arm.joints):
        if joint.kind == "revolute":
            yield (
                say(Kind.COLUMN_AS_PRISMATIC, number=k + 1, joint=joint.symbol),
                column(k, J[:, 3:, k], 0 * J[:, 3:, k]),
            )
            continue
        z, place = J[:, :3, k], {"number": k + 1, "joint": joint.symbol}
        for sign in (1, -1):
            yield say(Kind.COLUMN_TURNING, **place), column(k, z, sign * z)
        for frame in case.arm.frames:
            point = case.kinematics.pose(frame, case.quantity.reference)[:, :3, 3]
            for sign in (1, -1):
                yield say(Kind.COLUMN_AS_REVOLUTE, **place), column(k, np.cross(sign * z, end - point), sign * z)
        yield say(Kind.COLUMN_AS_REVOLUTE, **place), column(k, 0 * z, z)
