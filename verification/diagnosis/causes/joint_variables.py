"""Slips in a joint variable: its sign, its zero, its unit, another joint's, an angle counted from the base."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations, pairwise

import numpy as np

from armproof.models.arm import Joint
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import TOLERANCE, Candidate, Case
from armproof.verification.diagnosis.causes.varied import Values, evaluate_varied
from armproof.verification.findings import Finding, Kind, say

# the slip, the variables changed, the inner derivatives that go with it
Named = tuple[Finding, Values, np.ndarray | None]
_MOST_JOINTS = 6
_TURNS = (("π/2", np.pi / 2), ("-π/2", -np.pi / 2), ("π", np.pi))


def joint_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the quantity with a usual slip in one joint variable, or in all: a sign, a unit, an absolute angle."""
    yield from _varied(case, [*_on_one(case), *_on_all(case), *_between_neighbours(case)])


def offset_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the quantity with a joint variable counted from another zero, twice, or in another's place."""
    yield from _varied(
        case, [*_counted_otherwise(case), *_offsets(case), *_between_two(case), *_several_the_other_way(case)]
    )


def _varied(case: Case, named: list[Named]) -> Iterator[Candidate]:
    varied = evaluate_varied(case, [values for _, values, _ in named])
    for (finding, _, rates), values in zip(named, varied, strict=True):
        yield finding, values
        if rates is not None and case.quantity.kind == "jacobian":  # with the slip's own inner derivative
            yield finding, values * rates[kind_of(case.quantity).block(case.quantity, len(rates))[1]]


def _revolute(case: Case) -> list[Joint]:
    return [joint for joint in case.arm.joints if joint.kind == "revolute"]


def _of(case: Case, joint: Joint) -> np.ndarray:
    return np.asarray(case.q[:, joint.index - 1])


def _rates(case: Case, changed: dict[int, float]) -> np.ndarray:
    rates = np.ones(len(case.arm.joints))
    for index, rate in changed.items():
        rates[index - 1] = rate
    return rates


def _on_all(case: Case) -> Iterator[Named]:
    joints = _revolute(case)
    if not joints:
        return
    slips: list[tuple[Kind, Callable[[np.ndarray], np.ndarray], float]] = [
        (Kind.ANGLES_AS_DEGREES, np.radians, np.pi / 180),
        (Kind.ANGLES_TO_DEGREES, np.degrees, 180 / np.pi),
    ]
    if len(joints) < len(case.arm.joints):  # degrees made of all of q, slides included
        for kind, _, factor in slips:
            every_joint = {joint.symbol: factor * _of(case, joint) for joint in case.arm.joints}
            yield say(kind), every_joint, np.full(len(case.arm.joints), factor)
    if len(joints) > 1:
        slips.append((Kind.EXCHANGED_THROUGHOUT, lambda q: np.pi / 2 - q, -1.0))
        slips.append((Kind.EVERY_JOINT_THE_OTHER_WAY, np.negative, -1.0))
    for kind, slip, rate in slips:
        values = {joint.symbol: slip(_of(case, joint)) for joint in joints}
        yield say(kind), values, _rates(case, {joint.index: rate for joint in joints})
    yield from _absolute(case, joints)


def _absolute(case: Case, joints: list[Joint]) -> Iterator[Named]:
    """θ_k taken for the angle of its link from the base; or the sum of angles where θ_k alone belongs."""
    if len(joints) < 2:
        return
    q = [_of(case, joint) for joint in joints]
    absolute = {joint.symbol: q[k] - (q[k - 1] if k else 0) for k, joint in enumerate(joints)}
    summed = {joint.symbol: np.sum(q[: k + 1], axis=0) for k, joint in enumerate(joints)}
    yield say(Kind.ANGLES_ABSOLUTE), absolute, None
    yield say(Kind.ANGLES_SUMMED_TWICE), summed, None


def _on_one(case: Case) -> Iterator[Named]:
    for joint in case.arm.joints:
        symbol, q = joint.symbol, _of(case, joint)
        slips = [(Kind.JOINT_THE_OTHER_WAY, -q, -1.0)]
        if joint.kind == "revolute":
            slips.append((Kind.SINE_COSINE_OF_JOINT, np.pi / 2 - q, -1.0))
            slips.append((Kind.JOINT_AS_DEGREES, np.radians(q), np.pi / 180))
        for kind, values, rate in slips:
            yield say(kind, joint=symbol), {symbol: values}, _rates(case, {joint.index: rate})
        yield say(Kind.JOINT_MISSING, joint=symbol), {symbol: 0 * q}, None


def _offsets(case: Case) -> Iterator[Named]:
    for joint in case.arm.joints:
        symbol, q = joint.symbol, _of(case, joint)
        for name, turn in _TURNS if joint.kind == "revolute" else ():
            is_derivative = case.quantity.kind == "jacobian" and name == "-π/2"
            kind = Kind.OTHER_ZERO_OR_DERIVATIVE if is_derivative else Kind.OTHER_ZERO
            yield say(kind, joint=symbol, turn=name), {symbol: q + turn}, None
        yield say(Kind.JOINT_TWICE, joint=symbol), {symbol: 2 * q}, _rates(case, {joint.index: 2.0})


def _counted_otherwise(case: Case) -> Iterator[Named]:
    """q[1], q[2], … for q[0], q[1], …, in a program alone; and q[-1], q[0], … for them."""
    joints = case.arm.joints
    if case.is_printed or not case.fits or len(joints) < 3 or _joints_needed(case) < 2:  # one may stand for one other
        return
    q = [_of(case, joint) for joint in joints]
    yield say(Kind.JOINTS_COUNTED_FROM_ONE), {joint.symbol: q[min(k + 1, len(q) - 1)] for k, joint in enumerate(joints)}, None  # fmt: skip
    yield say(Kind.JOINTS_COUNTED_FROM_BEHIND), {joint.symbol: q[k - 1] for k, joint in enumerate(joints)}, None


def _joints_needed(case: Case) -> int:
    """Return on how many joints the quantity depends."""
    at_zero = evaluate_varied(case, [{joint.symbol: 0 * _of(case, joint)} for joint in case.arm.joints])
    return int((np.abs(at_zero - case.true) > TOLERANCE).any(axis=(1, 2, 3)).sum())


def _several_the_other_way(case: Case) -> Iterator[Named]:
    """Some joints whose axes were taken in the other sense, of an arm with more."""
    joints = _revolute(case)
    for count in range(2, len(joints)) if len(joints) <= _MOST_JOINTS else ():
        for chosen in combinations(joints, count):
            values = {joint.symbol: -_of(case, joint) for joint in chosen}
            rates = _rates(case, {joint.index: -1.0 for joint in chosen})
            yield say(Kind.JOINTS_THE_OTHER_WAY, joints=[*values]), values, rates


def _between_neighbours(case: Case) -> Iterator[Named]:
    for before, joint in pairwise(_revolute(case)):
        symbol, q, q_before = joint.symbol, _of(case, joint), _of(case, before)
        yield say(Kind.JOINT_ABSOLUTE, joint=symbol, before=before.symbol), {symbol: q - q_before}, None
        yield say(Kind.JOINT_SUMMED, joint=symbol, before=before.symbol), {symbol: q + q_before}, None


def _between_two(case: Case) -> Iterator[Named]:
    for i, one in enumerate(case.arm.joints):
        for other in case.arm.joints[i + 1 :]:
            if one.kind != other.kind:
                continue
            a, b = _of(case, one), _of(case, other)
            yield say(Kind.JOINTS_SWAPPED, one=one.symbol, other=other.symbol), {one.symbol: b, other.symbol: a}, None
            yield say(Kind.JOINT_FOR_JOINT, printed=other.symbol, correct=one.symbol), {one.symbol: b}, None
            yield say(Kind.JOINT_FOR_JOINT, printed=one.symbol, correct=other.symbol), {other.symbol: a}, None
