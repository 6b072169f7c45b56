"""Slips in a joint variable: its sign, its zero, its unit, another joint's, an angle counted from the base."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from armproof.models.arm import Joint
from armproof.verification.diagnosis.causes.case import Candidate, Case
from armproof.verification.diagnosis.causes.varied import Values, evaluate_varied

Named = tuple[str, Values, np.ndarray | None]  # words, the variables changed, the inner derivatives that go with it
_TURNS = (("π/2", np.pi / 2), ("-π/2", -np.pi / 2), ("π", np.pi))


def joint_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the quantity with a usual slip in one joint variable, or in all: a sign, a unit, an absolute angle."""
    yield from _varied(case, [*_on_all(case), *_on_one(case), *_between_neighbours(case)])


def offset_candidates(case: Case) -> Iterator[Candidate]:
    """Yield the quantity with a joint variable counted from another zero, twice, or in another's place."""
    yield from _varied(case, [*_offsets(case), *_between_two(case)])


def _varied(case: Case, named: list[Named]) -> Iterator[Candidate]:
    varied = evaluate_varied(case, [values for _, values, _ in named])
    for (words, _, rates), values in zip(named, varied, strict=True):
        yield words, values
        if (
            rates is not None and case.quantity.kind == "jacobian"
        ):  # the derivative, with the slip's own inner derivative
            columns = [c - 1 for c in case.quantity.columns or range(1, len(case.arm.joints) + 1)]
            yield words, values * rates[columns]


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
    every = [joint.index for joint in joints]
    degrees = {joint.symbol: np.degrees(_of(case, joint)) for joint in joints}
    radians = {joint.symbol: np.radians(_of(case, joint)) for joint in joints}
    yield (
        "the angles are taken as degrees: q is in radians already",
        radians,
        _rates(case, dict.fromkeys(every, np.pi / 180)),
    )
    yield (
        "the angles are converted to degrees before sine and cosine, which take radians",
        degrees,
        _rates(case, dict.fromkeys(every, 180 / np.pi)),
    )
    if len(joints) < len(case.arm.joints):  # degrees made of all of q, slides included
        scale = np.pi / 180
        for words, factor in (("the angles are taken as degrees: q is in radians already", scale),
                              ("the angles are converted to degrees before sine and cosine, which take radians", 1 / scale)):  # fmt: skip
            every_joint = {joint.symbol: factor * _of(case, joint) for joint in case.arm.joints}
            yield words, every_joint, np.full(len(case.arm.joints), factor)
    if len(joints) > 1:
        yield (
            "sine and cosine are exchanged throughout",
            {joint.symbol: np.pi / 2 - _of(case, joint) for joint in joints},
            _rates(case, dict.fromkeys(every, -1.0)),
        )
        yield (
            "every joint is taken the other way: the sign of all angles is wrong",
            {joint.symbol: -_of(case, joint) for joint in joints},
            _rates(case, dict.fromkeys(every, -1.0)),
        )
    yield from _absolute(case, joints)


def _absolute(case: Case, joints: list[Joint]) -> Iterator[Named]:
    """θ_k taken for the angle of its link from the base; or the sum of angles where θ_k alone belongs."""
    if len(joints) < 2:
        return
    q = [_of(case, joint) for joint in joints]
    absolute = {joint.symbol: q[k] - (q[k - 1] if k else 0) for k, joint in enumerate(joints)}
    summed = {joint.symbol: np.sum(q[: k + 1], axis=0) for k, joint in enumerate(joints)}
    words = (
        "each angle is taken as absolute, from the base; it is relative to the link before: sums of angles are missing"
    )
    yield words, absolute, None
    yield "the angles are summed up twice: each is relative to the link before already", summed, None


def _on_one(case: Case) -> Iterator[Named]:
    for joint in case.arm.joints:
        symbol, q = joint.symbol, _of(case, joint)
        yield (
            f"joint {symbol} is taken the other way: the sign of {symbol} is wrong",
            {symbol: -q},
            _rates(case, {joint.index: -1.0}),
        )
        if joint.kind == "revolute":
            yield (
                f"sine and cosine of {symbol} are exchanged",
                {symbol: np.pi / 2 - q},
                _rates(case, {joint.index: -1.0}),
            )
            yield (
                f"{symbol} is taken as degrees: it is in radians already",
                {symbol: np.radians(q)},
                _rates(case, {joint.index: np.pi / 180}),
            )
        yield f"{symbol} is missing: it stands nowhere in the result", {symbol: 0 * q}, None


def _offsets(case: Case) -> Iterator[Named]:
    for joint in case.arm.joints:
        symbol, q = joint.symbol, _of(case, joint)
        for name, turn in _TURNS if joint.kind == "revolute" else ():
            words = f"{symbol} is counted from another zero: off by {name}"
            if case.quantity.kind == "jacobian" and name == "-π/2":
                words += ", or the derivatives of its sine and cosine are not taken"
            yield words, {symbol: q + turn}, None
        yield f"{symbol} is counted twice", {symbol: 2 * q}, _rates(case, {joint.index: 2.0})


def _between_neighbours(case: Case) -> Iterator[Named]:
    revolute = _revolute(case)
    for before, joint in pairwise(revolute):
        symbol = joint.symbol
        yield (
            f"{symbol} is taken as an absolute angle, from the base; it is relative to the link before: "
            f"{symbol} stands where {before.symbol} + {symbol} belongs",
            {symbol: _of(case, joint) - _of(case, before)},
            None,
        )
        yield (
            f"{before.symbol} + {symbol} stands where {symbol} belongs: the angle is relative to the link before already",
            {symbol: _of(case, joint) + _of(case, before)},
            None,
        )


def _between_two(case: Case) -> Iterator[Named]:
    for i, one in enumerate(case.arm.joints):
        for other in case.arm.joints[i + 1 :]:
            if one.kind != other.kind:
                continue
            a, b = _of(case, one), _of(case, other)
            yield f"{one.symbol} and {other.symbol} are swapped", {one.symbol: b, other.symbol: a}, None
            yield f"{other.symbol} stands where {one.symbol} belongs", {one.symbol: b}, None
            yield f"{one.symbol} stands where {other.symbol} belongs", {other.symbol: a}, None
