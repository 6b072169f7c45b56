"""The catalogue of classic mistakes: right functions of an arm made wrong, each with the words that name what is wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.polynomial import Entry, Rows
from armproof.verification.diagnosis.causes.links import CONVENTIONS, Parameters, build, parameters
from tests.verification.functions import right
from tests.verification.functions.right import Function, Link


@dataclass(frozen=True)
class Mistake:
    """A wrong function; `words` are patterns of which the message must match one."""

    name: str
    quantity: str
    function: Function
    words: tuple[str, ...]


def mistakes_of(arm: Arm) -> Iterator[Mistake]:
    """Yield the mistakes of an arm, those too that are no change on it."""
    fk, jacobian = right.by_products(arm)
    yield from _of_angles(arm, fk, "pose")
    yield from _of_angles(arm, jacobian, "jacobian")
    yield from _of_lengths(arm)
    yield from _of_poses(arm, fk)
    yield from _of_products(arm)
    yield from _of_links(arm)
    yield from _of_jacobians(arm, fk, jacobian)
    yield from _of_constructions(arm)
    yield from _of_entries(arm)


def _after(change: Callable[[np.ndarray], Any], function: Function) -> Function:
    return lambda q: function(change(q))


def _of_angles(arm: Arm, function: Function, quantity: str) -> Iterator[Mistake]:
    revolute = [k for k, joint in enumerate(arm.joints) if joint.kind == "revolute"]
    mask = np.array([joint.kind == "revolute" for joint in arm.joints])
    yield Mistake("degrees", quantity, lambda q: function(np.where(mask, np.deg2rad(q), q)), ("degrees",))
    yield Mistake("to degrees", quantity, lambda q: function(np.where(mask, np.rad2deg(q), q)), ("degrees",))
    for k, joint in enumerate(arm.joints):
        symbol = joint.symbol

        def one(q, k, change):
            q = np.array(q)
            q[k] = change(q[k])
            return q

        def changed(change, k=k):
            return lambda q: function(one(q, k, change))

        yield Mistake(f"sign of {symbol}", quantity, changed(lambda v: -v), ("sign", "other way"))
        if joint.kind == "revolute":
            yield Mistake(f"{symbol} + pi/2", quantity, changed(lambda v: v + np.pi / 2), ("off by π/2",))
            yield Mistake(f"sin for cos of {symbol}", quantity, changed(lambda v: np.pi / 2 - v), ("sine",))
            yield Mistake(
                f"{symbol} missing",
                quantity,
                changed(lambda v: 0 * v),
                (f"{symbol} is missing", "expressed in frame", "this is that of frame"),
            )
    for before, k in pairwise(revolute):

        def absolute(q, before=before, k=k):
            q = np.array(q)
            q[k] = q[k] - q[before]
            return q

        name = arm.joints[k].symbol
        yield Mistake(f"{name} absolute", quantity, _after(absolute, function), ("absolute",))
    if len(revolute) > 1:

        def all_absolute(q):
            q = np.array(q)
            q[revolute] = np.diff(q[revolute], prepend=0.0 * q[0])
            return q

        yield Mistake("all angles absolute", quantity, _after(all_absolute, function), ("absolute",))

        def swapped(q):
            q = np.array(q)
            q[[revolute[0], revolute[1]]] = q[[revolute[1], revolute[0]]]
            return q

        yield Mistake(
            "two joints swapped", quantity, _after(swapped, function), ("swapped", "multiplied in the wrong order")
        )


def _of_lengths(arm: Arm) -> Iterator[Mistake]:
    symbols = list(arm.lengths)
    for quantity in ("pose", "jacobian"):
        rows = right.exact_rows(arm, quantity)

        def with_lengths(rows=rows, **changed):
            other = replace(arm, lengths={**arm.lengths, **changed})
            return right.written_out(other, rows, np.cos, np.sin, np.sqrt, np.array)

        for symbol, value in arm.lengths.items():
            yield Mistake(f"{symbol} forgotten", quantity, with_lengths(**{symbol: 0.0}), (f"{symbol} is missing", "that of the origin of frame", "that of frame", "the origin is missing"))  # fmt: skip
            yield Mistake(f"sign of {symbol}", quantity, with_lengths(**{symbol: -value}), ("sign",))
            yield Mistake(
                f"{symbol} another number",
                quantity,
                with_lengths(**{symbol: value + 0.123}),
                (f"{symbol} is taken as",),
            )
        for a, b in pairwise(symbols):
            both = {a: arm.lengths[b], b: arm.lengths[a]}
            yield Mistake(f"{a} and {b} swapped", quantity, with_lengths(**both), ("swapped", "stands where"))


def _of_poses(arm: Arm, fk: Function) -> Iterator[Mistake]:
    def turned(q):
        T = fk(q)
        T[:3, :3] = T[:3, :3].T
        return T

    def rows_swapped(q):
        return fk(q)[[1, 0, 2, 3]]

    yield Mistake("T transposed", "pose", lambda q: fk(q).T, ("transposed",))
    yield Mistake("R transposed", "pose", turned, ("transposed",))
    yield Mistake("T inverted", "pose", lambda q: np.linalg.inv(fk(q)), ("inverse",))
    yield Mistake("rows of T swapped", "pose", rows_swapped, ("rows 1 and 2 are swapped",))
    yield Mistake("sign of the whole", "pose", lambda q: -fk(q), ("sign",))


def _of_products(arm: Arm) -> Iterator[Mistake]:
    links = right.read_links(arm)
    n = len(arm.joints)

    def chained(order):
        def fk(q):
            T = np.eye(4)
            for k in order:
                T = T @ links[k].at(q[k] if k < n else 0.0)
            return T

        return fk

    every = list(range(len(links)))
    yield Mistake("reversed product", "pose", chained(every[::-1]), ("wrong order",))
    for k in every:
        yield Mistake(f"link {k + 1} left out", "pose", chained(every[:k] + every[k + 1 :]),
                      ("is missing from the product", "this is that of frame", "expressed in frame", "is missing"))  # fmt: skip
    for k in every[:-1]:
        order = [*every[:k], k + 1, k, *every[k + 2 :]]
        yield Mistake(f"links {k + 1} and {k + 2} in the wrong order", "pose", chained(order), ("wrong order",))


def _of_links(arm: Arm) -> Iterator[Mistake]:
    """One link matrix, or all of them, by wrong Denavit–Hartenberg parameters or in the other convention."""
    links = right.read_links(arm)
    if len(links) != len(arm.joints):
        return
    for convention in CONVENTIONS:
        if not all(_numbers(link, convention) for link in links):
            continue
        other = CONVENTIONS[1 - CONVENTIONS.index(convention)]
        yield _with_links(
            arm,
            "other DH convention",
            [_rebuilt(link, convention, other) for link in links],
            ("convention", "modified", "classic"),
        )
        for k, link in enumerate(links):

            def only(changed, k=k):
                return [*links[:k], changed, *links[k + 1 :]]

            yield _with_links(
                arm, f"other convention in link {k + 1}", only(_rebuilt(link, convention, other)), ("convention",)
            )
            yield _with_links(
                arm, f"sign of alpha {k + 1}", only(_rebuilt(link, convention, convention, alpha=-1)), ("twist", "sign")
            )
            yield _with_links(
                arm,
                f"a of link {k + 1} forgotten",
                only(_rebuilt(link, convention, convention, a=0)),
                ("missing", "is that of"),
            )
        return


def _numbers(link: Link, convention: str) -> bool:
    q = np.array([0.0, 0.4])
    return parameters(convention, np.stack([link.at(value) for value in q])) is not None


def _rebuilt(link: Link, convention: str, written_in: str, alpha: int = 1, a: int = 1) -> Link:
    q = np.array([0.0, np.pi / 2, np.pi]) if link.kind == "revolute" else np.array([0.0, 1.0, 0.0])
    p = parameters(convention, np.stack([link.at(value) for value in q]))
    changed = Parameters(a * p.a, alpha * p.alpha, p.d, p.theta)
    first, second, third = np.round(build(written_in, changed), 12)
    zero = np.zeros((4, 4))
    if link.kind == "revolute":
        parts = ((first + third) / 2, (first - third) / 2, second - (first + third) / 2)
    else:
        parts = (first, second - first, zero)
    return Link(tuple(np.round(part, 12) for part in parts), link.kind)


def _with_links(arm: Arm, name: str, links: list[Link], words: tuple[str, ...]) -> Mistake:
    fk, _ = right.by_products(arm, links, right.axes_of(arm))
    return Mistake(name, "pose", fk, words)


def _of_jacobians(arm: Arm, fk: Function, jacobian: Function) -> Iterator[Mistake]:
    n = len(arm.joints)
    revolute = [k for k, joint in enumerate(arm.joints) if joint.kind == "revolute"]

    def tool(q, parts=(True, True)):
        R, J = fk(q)[:3, :3].T, jacobian(q)
        return np.vstack((R @ J[:3] if parts[0] else J[:3], R @ J[3:] if parts[1] else J[3:]))

    yield Mistake("J transposed", "jacobian", lambda q: jacobian(q).T, ("transposed",))
    yield Mistake("blocks swapped", "jacobian", lambda q: jacobian(q)[[3, 4, 5, 0, 1, 2]], ("blocks are swapped",))
    yield Mistake("tool-frame J", "jacobian", tool, ("expressed in frame",))
    yield Mistake(
        "linear part in the tool frame", "jacobian", lambda q: tool(q, (True, False)), ("expressed in frame",)
    )
    yield Mistake("columns reversed", "jacobian", lambda q: jacobian(q)[:, ::-1], ("columns",))
    yield Mistake("first two columns swapped", "jacobian", lambda q: jacobian(q)[:, [1, 0, *range(2, n)]], ("columns",))
    yield Mistake("x and y swapped", "jacobian", lambda q: jacobian(q)[[1, 0, 2, 3, 4, 5]], ("rows 1 and 2",))
    yield Mistake(
        "no angular part",
        "jacobian",
        lambda q: jacobian(q) * np.array([[1.0]] * 3 + [[0.0]] * 3),
        ("angular part is missing",),
    )
    yield Mistake(
        "no linear part",
        "jacobian",
        lambda q: jacobian(q) * np.array([[0.0]] * 3 + [[1.0]] * 3),
        ("linear part is missing", "frame"),
    )
    yield Mistake("rows of v alone", "jacobian", lambda q: jacobian(q)[:3], ("linear part alone",))
    degrees = np.array([np.pi / 180 if joint.kind == "revolute" else 1.0 for joint in arm.joints])
    yield Mistake("per degree", "jacobian", lambda q: jacobian(q) * degrees, ("per degree",))
    for k in range(n):
        signs = np.ones(n)
        signs[k] = -1
        yield Mistake(f"sign of column {k + 1}", "jacobian", lambda q, signs=signs: jacobian(q) * signs, ("sign",))

    def no_chain_rule(q):
        J = jacobian(q)
        for k, after in pairwise(revolute):
            J[:, k] = J[:, k] - J[:, after]
        return J

    yield Mistake("chain rule missing", "jacobian", no_chain_rule, ("chain rule",))


def _of_constructions(arm: Arm) -> Iterator[Mistake]:
    """The Jacobian constructed from axes and origins, with a slip."""
    links, axes = right.read_links(arm), right.axes_of(arm)
    kinds = [joint.kind for joint in arm.joints]

    def constructed(column, frame_shift=0):
        def jacobian(q):
            T = [np.eye(4)]
            for k, link in enumerate(links):
                T.append(T[-1] @ link.at(q[k] if k < len(q) else 0.0))
            J = np.zeros((6, len(q)))
            for k, (frame, axis) in enumerate(axes):
                shifted = min(max(frame + frame_shift, 0), len(T) - 1)
                z, p = T[shifted][:3, :3] @ axis, T[shifted][:3, 3]
                J[:, k] = column(kinds[k], z, p, T[-1][:3, 3])
            return J

        return jacobian

    def usual(kind, z, p, end):
        return np.hstack((np.cross(z, end - p), z)) if kind == "revolute" else np.hstack((z, 0 * z))

    def slip(v, kind, z):
        return np.hstack((v, z)) if kind == "revolute" else np.hstack((z, 0 * z))

    yield Mistake(
        "z x p_i", "jacobian", constructed(lambda kind, z, p, end: slip(np.cross(z, p), kind, z)), ("z × p_i stands",)
    )
    yield Mistake(
        "z x p_n", "jacobian", constructed(lambda kind, z, p, end: slip(np.cross(z, end), kind, z)), ("z × p_n stands",)
    )
    yield Mistake(
        "p - p_n", "jacobian", constructed(lambda kind, z, p, end: slip(np.cross(z, p - end), kind, z)), ("sign",)
    )
    yield Mistake(
        "no cross product", "jacobian", constructed(lambda kind, z, p, end: slip(end - p, kind, z)), ("cross product",)
    )
    yield Mistake("the neighbour's axis", "jacobian", constructed(usual, 1), ("z_i", "z_{i-1}"))
    yield Mistake("the axis before", "jacobian", constructed(usual, -1), ("z_i", "z_{i-1}"))
    if "prismatic" in kinds:
        yield Mistake(
            "prismatic as revolute",
            "jacobian",
            constructed(lambda kind, z, p, end: usual("revolute", z, p, end)),
            ("prismatic",),
        )
        yield Mistake("angular velocity of a slide", "jacobian",
                      constructed(lambda kind, z, p, end: np.hstack((usual(kind, z, p, end)[:3], z))), ("prismatic",))  # fmt: skip
    yield Mistake(
        "revolute as prismatic", "jacobian", constructed(lambda kind, z, p, end: np.hstack((z, 0 * z))), ("revolute",)
    )


def _of_entries(arm: Arm) -> Iterator[Mistake]:
    """One term of one entry written out, with a slip."""
    for quantity in ("pose", "jacobian"):
        rows = right.exact_rows(arm, quantity)
        places = [(r, c) for r, row in enumerate(rows) for c, entry in enumerate(row) if len(entry) > 1]
        for r, c in places[:: max(1, len(places) // 3)][:3]:
            for name, entry in _slips(rows[r][c]):
                changed: Rows = tuple(
                    tuple(entry if (i, j) == (r, c) else cell for j, cell in enumerate(row))
                    for i, row in enumerate(rows)
                )
                function = right.written_out(arm, changed, np.cos, np.sin, np.sqrt, np.array)
                place = rf"\({r + 1}, {c + 1}\)"
                yield Mistake(f"{name} in entry ({r + 1}, {c + 1})", quantity, function, (place,))


def _slips(entry: Entry) -> Iterator[tuple[str, Entry]]:
    first, *_ = entry
    yield "sign of a term", {m: -v if m == first else v for m, v in entry.items()}
    yield "a term missing", {m: v for m, v in entry.items() if m != first}
    for (kind, name), power in first:
        if kind in ("cos", "sin") and power == 1:
            other = "sin" if kind == "cos" else "cos"
            changed = tuple(sorted((((other, name), 1) if item == ((kind, name), 1) else item) for item in first))
            rest = {m: v for m, v in entry.items() if m != first}
            yield "sine and cosine exchanged", {**rest, changed: rest.get(changed, Fraction(0)) + entry[first]}
            break
