"""A closed-form solution as a derivation: which formula gives each joint, each name on the way, and where it branches."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import EvaluationError
from armproof.verification.inverse.formulas import Formula
from armproof.verification.inverse.target import Target
from armproof.verification.naming.names import Names

Meaning = Formula | Quantity
Signs = Mapping[str, int]


class UnsolvedJoint(EvaluationError):
    """A formula uses a joint that has no value yet."""

    def __init__(self, joint: str) -> None:
        super().__init__("it uses {joint}, which is not solved before", joint=joint)
        self.joint = joint


@dataclass(frozen=True)
class Step:
    """A joint and the formula that solves for it."""

    joint: str
    formula: Formula


@dataclass(frozen=True)
class Derivation:
    """The steps of a solution in order, what its names mean, and its independent signs.

    Attributes:
        choice: the meaning taken for each name on the way.
        signs: the name of each independent sign: "sigma_1" for a sign that has a name, else the joint or name whose
            formula holds the ±.
    """

    names: Names
    target: Target
    formulas: Mapping[str, list[Formula]]
    steps: tuple[Step, ...] = ()
    choice: Mapping[str, Meaning] = field(default_factory=dict)
    signs: tuple[str, ...] = ()

    @property
    def arm(self) -> Arm:
        """The arm."""
        assert self.names.arm is not None
        return self.names.arm

    @property
    def branches(self) -> tuple[dict[str, int], ...]:
        """Every choice of signs, + before −."""
        return tuple(dict(zip(self.signs, signs, strict=True)) for signs in product((1, -1), repeat=len(self.signs)))
