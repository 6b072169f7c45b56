"""The joints of an arm in plots and captions: their units, and their values in words."""

from __future__ import annotations

import numpy as np

from armproof.course.figures.drawing.labels import math, number
from armproof.models.arm import Arm
from armproof.verification.latex.writer import symbol_as_latex

_DOTS = ("", r"\dot", r"\ddot")


def joint_scales(arm: Arm) -> np.ndarray:
    """Return what the values of the joints are multiplied by for a reader: 180/π for angles, 1 for lengths, (n,)."""
    return np.array([180 / np.pi if joint.kind == "revolute" else 1.0 for joint in arm.joints])


def same_unit(arm: Arm) -> list[tuple[str, list[int]]]:
    """Return the places of the joints, from 0, that share a unit: the revolute ones, then the prismatic ones."""
    kinds = [joint.kind for joint in arm.joints]
    places = {kind: [k for k, found in enumerate(kinds) if found == kind] for kind in ("revolute", "prismatic")}
    return [(kind, found) for kind, found in places.items() if found]


def joint_unit(kind: str, order: int = 0) -> str:
    """Return the unit of joint values for a reader, or of a derivative of them: °, °/s, °/s², m, m/s, m/s²."""
    return ("°" if kind == "revolute" else "m") + ("", "/s", "/s²")[order]


def dotted(symbol: str, order: int) -> str:
    r"""Return a joint variable or a derivative of it as LaTeX: \dot{\theta}_1."""
    letter, underscore, index = symbol_as_latex(symbol).partition("_")
    return f"{_DOTS[order]}{{{letter}}}{underscore}{index}" if order else letter + underscore + index


def values_text(arm: Arm, values: np.ndarray, lang: str, order: int = 0) -> str:
    """Return joint values (n,), or velocities or accelerations, as a list with symbols and units."""
    parts = []
    for joint, value in zip(arm.joints, joint_scales(arm) * values, strict=True):
        name = f"${dotted(joint.symbol, order)}$" if order else math(joint.symbol)
        unit = joint_unit(joint.kind, order)
        space = "" if unit == "°" else " "
        parts.append(f"{name} = {number(round(value, 9), lang)}{space}{unit}")
    return ", ".join(parts)
