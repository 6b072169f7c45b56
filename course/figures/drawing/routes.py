"""How a link runs from one joint to the next: along the axis, along the common normal, along the next axis."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

_DETOUR = 2.0  # a link longer than so many times the direct way runs straight
_PARALLEL = 1e-6
_SAME = 1e-9  # m


def route(start: np.ndarray, axis: np.ndarray, end: np.ndarray, next_axis: np.ndarray) -> np.ndarray:
    """Return the way of a link from a point on one joint's axis to a point on the next one's, (k, 3).

    It follows d and a of Denavit and Hartenberg; of parallel axes the common normal through the end is taken.
    """
    across = np.cross(axis, next_axis)
    if np.linalg.norm(across) < _PARALLEL:
        way = [start, start + ((end - start) @ axis) * axis, end]
    else:
        s, t, _ = np.linalg.solve(np.column_stack([axis, -next_axis, across]), end - start)
        way = [start, start + s * axis, end + t * next_axis, end]
    length = sum(float(np.linalg.norm(one - other)) for one, other in pairwise(way))
    detour = length > _DETOUR * np.linalg.norm(end - start) + _SAME
    return simplify(np.array([start, end] if detour else way))


def route_to_point(start: np.ndarray, axis: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Return the way of the last link: along the joint's axis, then across it to a point, (k, 3)."""
    return simplify(np.array([start, start + ((point - start) @ axis) * axis, point]))


def simplify(points: np.ndarray) -> np.ndarray:
    """Return a polyline without points that repeat or lie on the line through their neighbours; at least two points."""
    kept = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - kept[-1]) > _SAME:
            kept.append(point)
    k = 1
    while k < len(kept) - 1:
        one, other = kept[k] - kept[k - 1], kept[k + 1] - kept[k]
        if np.linalg.norm(np.cross(one, other)) <= _SAME * np.linalg.norm(one) * np.linalg.norm(other) + _SAME**2:
            del kept[k]
            k = max(k - 1, 1)
        else:
            k += 1
    return np.array(kept if len(kept) > 1 else [kept[0], kept[0]])
