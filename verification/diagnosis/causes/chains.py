"""A Jacobian that is constructed rightly, of a chain of link matrices that is wrong."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from armproof.verification.diagnosis.causes.axes import constructions
from armproof.verification.diagnosis.causes.case import Candidate, Case
from armproof.verification.diagnosis.causes.frames import inverse
from armproof.verification.diagnosis.causes.links import (
    build,
    convention_of,
    link_name,
    link_slips,
    other_convention,
    parameters,
)
from armproof.verification.findings import Kind, say


def chain_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the Jacobian of a chain with a slip in one link matrix, or with all of them in the other convention."""
    frames, reference = case.frames, case.quantity.reference
    if case.quantity.kind != "jacobian" or reference != frames[0]:
        return
    J = case.kinematics.jacobian(case.quantity.frame, reference, frames[0])
    ways = constructions(case, J)
    poses = [case.kinematics.pose(frame, reference) for frame in frames]
    links = [inverse(before) @ after for before, after in pairwise(poses)]
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
        yield from ((finding, J) for J in jacobians(_chained(poses[0], rebuilt)))
    for k, true in enumerate(links):
        for slip, L in link_slips(true, convention_of(links)):
            before = poses[k] @ L @ inverse(poses[k + 1])
            finding = say(Kind.WRONG_LINK, link=link_name(frames, k), slip=slip)
            yield from ((finding, J) for J in jacobians([*poses[: k + 1], *(before @ pose for pose in poses[k + 1 :])]))


def _chained(first: np.ndarray, links: list[np.ndarray]) -> list[np.ndarray]:
    poses = [first]
    for link in links:
        poses.append(poses[-1] @ link)
    return poses
