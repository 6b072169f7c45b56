"""The search for the likely mistake: the plain ones first, those that explain anything last."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import accumulate, chain, pairwise

import numpy as np

from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.axes import axis_candidates, constructions
from armproof.verification.diagnosis.causes.case import Candidate, Case, Explanation
from armproof.verification.diagnosis.causes.frames import (
    constant_offset,
    other_poses,
    permutation_cause,
    pose_slips,
    shape_candidates,
)
from armproof.verification.diagnosis.causes.jacobian import jacobian_slips, other_jacobians, point_candidates
from armproof.verification.diagnosis.causes.joint_variables import joint_candidates, offset_candidates
from armproof.verification.diagnosis.causes.lengths import length_cause, lengths_cause
from armproof.verification.diagnosis.causes.links import (
    build,
    convention_of,
    link_name,
    link_slips,
    other_convention,
    parameters,
    product_candidates,
    wrong_link,
)
from armproof.verification.findings import Kind, say

Search = Callable[[Case], Explanation]
FAR_FETCHED = 1000  # exceptions: what only bounds a mistake yields to any that names it


def chain_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the Jacobian of a chain with a slip in one link matrix, or with all of them in the other convention."""
    frames, reference = case.frames, case.quantity.reference
    if case.quantity.kind != "jacobian" or reference != frames[0]:
        return
    ways = constructions(case, case.whole)
    poses = [case.kinematics.pose(frame, reference) for frame in frames]
    links = [np.linalg.inv(before) @ after for before, after in pairwise(poses)]
    last = frames.index(case.quantity.frame)

    def jacobians(changed: list[np.ndarray]) -> Iterator[np.ndarray]:
        chain = np.stack(changed, 1)
        for way in ways:
            altered = replace(way, poses=chain, end=chain[:, last, :3, 3])
            yield case.selected(altered.jacobian(altered.axes(), altered.origins()))

    for convention in convention_of(links):
        other = other_convention(convention)
        rebuilt = [build(other, p) for L in links if (p := parameters(convention, L)) is not None]
        finding = say(Kind.LINKS_OF_OTHER_CONVENTION, other=other, convention=convention)
        yield from ((finding, J) for J in jacobians(list(accumulate(rebuilt, np.matmul, initial=poses[0]))))
    for k, true in enumerate(links):
        for slip, L in link_slips(true, convention_of(links)):
            before = poses[k] @ L @ np.linalg.inv(poses[k + 1])
            finding = say(Kind.WRONG_LINK, link=link_name(frames, k), slip=slip)
            yield from ((finding, J) for J in jacobians([*poses[: k + 1], *(before @ pose for pose in poses[k + 1 :])]))


def find_cause(case: Case) -> Explanation:
    """Return the likely mistake behind a wrong result; nothing where none explains it.

    A mistake explains a result if it turns the right values into those obtained, at every configuration, in each block of
    the matrix (rotation and origin; v and ω of each column) that is wrong.
    """
    return find_slip(case, find_other(case))


def find_other(case: Case) -> Explanation:
    """Return which other matrix of the arm was obtained: transposed, inverted, of another frame, in another frame."""
    if _has_no_cause(case):
        return Explanation()
    others = other_jacobians(case) if case.quantity.kind == "jacobian" else other_poses(case)
    return case.explained_by(others if case.fits else chain(shape_candidates(case), others))


def find_slip(case: Case, best: Explanation) -> Explanation:
    """Return the slip in the making of the right matrix, where it explains the result better than what was found."""
    in_entries = case.is_printed and case.quantity.kind == "difference"  # there a slip is told where it stands
    if _has_no_cause(case) or best.is_whole or in_entries:
        return best
    if not case.fits:
        return best.or_better(case.explained_by(jacobian_slips(case)))
    for search in _OF_JACOBIANS if case.quantity.kind == "jacobian" else _OF_POSES:
        best = best.or_better(search(case))
        if best.is_whole:
            return best
    return best if best.finding is not None else _rest(case)


def _has_no_cause(case: Case) -> bool:
    """Whether none is sought: of zeros, everything's special case; of values that are right; and of what is no pose, Jacobian or a part of one."""
    of_frames = kind_of(case.quantity).matrix or case.quantity.kind == "difference"
    return not of_frames or (case.fits and (not case.obtained.any() or not case.wrong))


def _rest(case: Case) -> Explanation:
    """Return what is less a mistake than a place: one wrong link, several lengths, a constant offset."""
    found = wrong_link(case) or lengths_cause(case) or constant_offset(case) or permutation_cause(case)
    return Explanation(found, FAR_FETCHED)


def _explained(*sources: Callable[[Case], Iterable[Candidate]]) -> Search:
    return lambda case: case.explained_by(chain.from_iterable(source(case) for source in sources))


def _length(case: Case) -> Explanation:
    return Explanation(length_cause(case))


_JOINTS, _OFFSETS = _explained(joint_candidates), _explained(offset_candidates, point_candidates)
_OF_POSES = (_explained(pose_slips), _JOINTS, _length, _OFFSETS, _explained(product_candidates))
_OF_JACOBIANS = (
    _explained(jacobian_slips), _JOINTS, _length, _explained(axis_candidates), _OFFSETS, _explained(chain_candidates)
)  # fmt: skip
