"""The serial chain of an arm: its moving joints from the base to the tool, found in a MultibodyPlant."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from armproof.models.errors import Fault, ModelError

KINDS = {"revolute": "revolute", "prismatic": "prismatic"}
_FIXED = "weld"


@dataclass(frozen=True)
class Chain:
    """The moving joints of a plant, as Drake objects.

    Attributes:
        base: the body that carries the arm, welded to the world; the world itself if the first joint sits on it.
        joints: the moving joints, base to tool.
    """

    base: Any
    joints: tuple[Any, ...]


def find_chain(plant: Any, source: str) -> Chain:
    """Find the one serial chain of moving joints, weld its base to the world if it is free, and finalize the plant.

    Args:
        plant: a MultibodyPlant before Finalize().
        source: the file, for messages.

    Raises:
        ModelError: a joint of another kind, a mimic joint, a closed loop, several roots, several moving branches,
            or no moving joint.
    """
    inboard = _joint_to_each_body(plant, source)
    if plant.num_constraints():
        raise ModelError(Fault.COUPLED_JOINTS, source=source)
    bodies = [body for body in _bodies(plant) if body.index() != plant.world_body().index()]
    roots = [body for body in bodies if body.index() not in inboard]
    if len(roots) > 1:
        names = [body.name() for body in roots]
        raise ModelError(Fault.SEVERAL_BASES, source=source, names=names)
    for root in roots:
        plant.WeldFrames(plant.world_frame(), root.body_frame())
    joints = _serial_joints(plant, bodies, inboard, source)
    try:
        plant.Finalize()
    except RuntimeError as error:
        raise ModelError(Fault.IN_MODEL, source=source, reason=str(error)) from None
    base = joints[0].parent_body()
    while base.index() in inboard and _parent(base, inboard).index() != plant.world_body().index():
        base = _parent(base, inboard)
    return Chain(base, joints)


def _bodies(plant: Any) -> list[Any]:
    from pydrake.multibody.tree import BodyIndex

    return [plant.get_body(BodyIndex(i)) for i in range(plant.num_bodies())]


def _parent(body: Any, inboard: dict[Any, Any]) -> Any:
    return inboard[body.index()].parent_body()


def _joint_to_each_body(plant: Any, source: str) -> dict[Any, Any]:
    """Return the joint that carries each body, by the index of the body."""
    inboard: dict[Any, Any] = {}
    for index in plant.GetJointIndices():
        joint = plant.get_joint(index)
        if joint.type_name() not in (*KINDS, _FIXED):
            raise ModelError(Fault.JOINT_TYPE, source=source, joint=joint.name(), type=joint.type_name())
        child = joint.child_body()
        if child.index() in inboard:
            first = inboard[child.index()].name()
            raise ModelError(Fault.CLOSED_LOOP, source=source, joint=first, other=joint.name(), body=child.name())
        inboard[child.index()] = joint
    return inboard


def _serial_joints(plant: Any, bodies: list[Any], inboard: dict[Any, Any], source: str) -> tuple[Any, ...]:
    """Return the moving joints base to tool; every one of them must lie on the longest chain."""
    chains: list[tuple[Any, ...]] = []
    for body in bodies:
        chain: list[Any] = []
        visited: set[Any] = set()
        while body.index() in inboard:
            joint = inboard[body.index()]
            if body.index() in visited:
                raise ModelError(Fault.LOOP, source=source, joint=joint.name())
            visited.add(body.index())
            if joint.type_name() in KINDS:
                chain.append(joint)
            body = joint.parent_body()
        chains.append(tuple(reversed(chain)))
    longest: tuple[Any, ...] = max(chains, key=len, default=())
    if not longest:
        raise ModelError(Fault.NO_MOVING_JOINT, source=source)
    on_chain = {joint.index() for joint in longest}
    for moving in chains:
        branch = [joint.name() for joint in moving if joint.index() not in on_chain]
        if branch:
            trunk = [joint.name() for joint in longest]
            raise ModelError(Fault.BRANCHES, source=source, trunk=trunk, branch=branch)
    return longest
