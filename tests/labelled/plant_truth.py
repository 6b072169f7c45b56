"""What is true of an arm, asked of Drake's plant directly: nothing of ours stands between."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydrake.multibody.tree import JacobianWrtVariable

from armproof.models.catalogue import load_arm
from armproof.models.numeric.drake_arm import drake_of, plant_of


@dataclass(frozen=True)
class PlantTruth:
    """A finalized plant with the document's frames, and its joints in order from base to tool."""

    plant: Any
    frames: Mapping[str, Any]
    joints: Sequence[Any]
    symbols: tuple[str, ...]
    lengths: Mapping[str, float]

    @classmethod
    def of_catalogue(cls, name: str) -> PlantTruth:
        arm = load_arm(name)
        symbols = tuple(joint.symbol for joint in arm.joints)
        return cls(plant_of(arm), drake_of(arm).frames, drake_of(arm).joints, symbols, arm.lengths)

    def context(self, q: np.ndarray) -> Any:
        context = self.plant.CreateDefaultContext()
        for joint, value in zip(self.joints, q, strict=True):
            positions = self.plant.GetPositions(context)
            positions[joint.position_start()] = value
            self.plant.SetPositions(context, positions)
        return context

    def pose(self, q: np.ndarray, frame: str, reference: str = "0") -> np.ndarray:
        context = self.context(q)
        return self.plant.CalcRelativeTransform(context, self.frames[reference], self.frames[frame]).GetAsMatrix4()

    def jacobian(self, q: np.ndarray, frame: str) -> np.ndarray:
        """Return the 6 × n Jacobian, rows [v; ω], in frame 0."""
        base = self.frames["0"]
        found = self.plant.CalcJacobianSpatialVelocity(
            self.context(q), JacobianWrtVariable.kV, self.frames[frame], np.zeros(3), base, base
        )
        columns = found[:, [joint.velocity_start() for joint in self.joints]]
        return np.vstack([columns[3:], columns[:3]])

    def values(self, q: np.ndarray, rates: np.ndarray) -> dict[str, float]:
        """The value of every letter, as the evaluator asks for it."""
        found = dict(self.lengths) | dict(zip(self.symbols, map(float, q), strict=True))
        return found | {f"dot{symbol}": float(rate) for symbol, rate in zip(self.symbols, rates, strict=True)}

    def quantity(self, spec: Mapping[str, Any], q: np.ndarray, rates: np.ndarray) -> np.ndarray:
        """Return the value of what a table's `truth` names."""
        (kind, what), *_ = spec.items()
        last = self.jacobian(q, spec.get("of", str(len(self.symbols))))
        if kind == "angle":
            return np.asarray(q[: int(what)].sum())  # planar arms
        if kind == "determinant":
            return np.asarray(np.linalg.det(last[[row - 1 for row in what]]))
        if kind == "manipulability":
            part = last[[row - 1 for row in what]]
            return np.asarray(np.sqrt(np.linalg.det(part @ part.T)))
        value = self._matrix(kind, str(what), str(spec.get("in", "0")), q, rates)
        if "component" in spec:
            return value["xyz".index(spec["component"]), 0]
        return value[[row - 1 for row in spec["rows"]]] if "rows" in spec else value

    def _matrix(self, kind: str, frame: str, reference: str, q: np.ndarray, rates: np.ndarray) -> np.ndarray:
        if kind in ("jacobian", "velocity"):
            return self.jacobian(q, frame) if kind == "jacobian" else self.jacobian(q, frame) @ rates[:, None]
        pose = self.pose(q, frame, reference)
        parts = {"pose": pose, "rotation": pose[:3, :3], "origin": pose[:3, 3:], "axis": pose[:3, 2:3]}
        return parts[kind]
