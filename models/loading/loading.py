"""Make an arm of a model file: with its convention card, or plain, with names counted along the chain."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from types import MappingProxyType
from typing import Any, Literal

from armproof.models.arm import Arm, Joint
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.numbers import TOLERANCE
from armproof.models.exact.offset import Offset, exact_offset, frames_of, nearly_right_angles
from armproof.models.exact.polynomial import generator, scale
from armproof.models.exact.symbolic import SymbolicPlant
from armproof.models.loading.card import Card, Place
from armproof.models.loading.chain import Chain, find_chain
from armproof.models.loading.reader import Model, read_model
from armproof.models.numeric.drake_arm import DrakeArm


def load_plain(path: Path, tip: str = "", lock: Mapping[str, float] = MappingProxyType({})) -> Arm:
    """Load a model file without a card.

    The joint variables are theta_i (revolute) and d_i (prismatic), counted over the moving joints; frame 0 is the base
    link, frame i the link that joint i carries, the last one the tip if there is one, and every link is a frame under its
    own name. `tip` and `lock` are those of `read_model`.

    Raises:
        ModelError: the file cannot be read, or is not one serial chain.
    """
    model, chain = _read_chain(path, tip, lock)
    plant = model.plant
    symbols = [
        f"{'theta' if joint.type_name() == 'revolute' else 'd'}_{i}" for i, joint in enumerate(chain.joints, start=1)
    ]
    numbered = [chain.base, *(joint.child_body() for joint in chain.joints)]
    numbered[-1] = plant.GetBodyByName(tip) if tip else numbered[-1]
    frames = {str(i): body.body_frame() for i, body in enumerate(numbered)}
    for frame in frames_of(plant):
        if frame.is_body_frame() and not frame.is_world_frame():
            frames.setdefault(frame.name(), frame)
    name = path.name.split(".")[0]
    texts: dict[str, Any] = {"name": name, "title": name, "source": path.name, "zero": ""}
    more: dict[str, Any] = {
        "path": path,
        "digest": _digest(path, settings=f"{tip} {dict(lock)}" if tip or lock else ""),
    }
    return _arm(plant, chain, frames, symbols, **texts, **more, warnings=model.warnings, model=model.text)


def load_card(card: Card, name: str) -> Arm:
    """Load the arm of a convention card.

    Raises:
        ModelError: the model file cannot be read, or the card names what the model does not have; with file and line.
    """
    model, chain = _read_chain(card.model)
    plant = model.plant
    names = [joint.name() for joint in chain.joints]
    if list(card.joints) != names:
        card.fail("joints", Fault.JOINTS_OF_CARD, joints=list(card.joints), names=names)
    lengths, offsets = _bind_lengths(card, plant)
    frames = {frame: _find_frame(card, plant, frame, place) for frame, place in card.frames.items()}
    symbols, digest = list(card.joints.values()), _digest(card.path, card.model)
    texts: dict[str, Any] = {"name": name, "title": card.title, "source": card.source, "zero": card.zero}
    more = {"path": card.model, "digest": digest, "warnings": model.warnings, "model": model.text}
    try:
        return _arm(plant, chain, frames, symbols, lengths, offsets, **texts, **more)
    except ModelError as error:
        raise ModelError(Fault.IN_MODEL, source=card.path, reason=error) from None


def _digest(*files: Path, settings: str = "") -> str:
    return sha256(b"".join(file.read_bytes() for file in files) + settings.encode()).hexdigest()


def _read_chain(path: Path, tip: str = "", lock: Mapping[str, float] = MappingProxyType({})) -> tuple[Model, Chain]:
    model = read_model(path, tip, lock)
    chain = find_chain(model.plant, str(path))
    return replace(model, warnings=model.warnings + nearly_right_angles(model.plant, str(path))), chain


def _arm(
    plant: Any,
    chain: Chain,
    frames: Mapping[str, Any],
    symbols: Sequence[str],
    lengths: Mapping[str, float] = MappingProxyType({}),
    offsets: Mapping[int, Offset] | None = None,
    **others: Any,
) -> Arm:
    """Return the arm of a plant, with the symbols of its joints, its lengths and the exact poses that these are in."""
    joints = _joints(chain, symbols)
    drake = DrakeArm(plant, chain.base, chain.joints, MappingProxyType(frames))
    return Arm(
        joints=joints,
        lengths=MappingProxyType(lengths),
        angles=MappingProxyType({}),
        frames=tuple(frames),
        exact=SymbolicPlant(others["name"], joints, drake, offsets),
        drake=drake,
        **others,
    )


def _joints(chain: Chain, symbols: Sequence[str]) -> tuple[Joint, ...]:
    joints = []
    for index, (joint, symbol) in enumerate(zip(chain.joints, symbols, strict=True), start=1):
        kind: Literal["revolute", "prismatic"] = "revolute" if joint.type_name() == "revolute" else "prismatic"
        lower, upper = float(joint.position_lower_limit()), float(joint.position_upper_limit())
        joints.append(Joint(index, joint.name(), symbol, kind, lower, upper))
    return tuple(joints)


def _model_joints(plant: Any) -> dict[str, Any]:
    return {joint.name(): joint for joint in (plant.get_joint(index) for index in plant.GetJointIndices())}


def _bind_lengths(card: Card, plant: Any) -> tuple[dict[str, float], dict[int, Offset]]:
    """Return the value of each length, and the exact poses of the joints that the lengths are bound to."""
    joints = _model_joints(plant)
    context = plant.CreateDefaultContext()
    lengths: dict[str, float] = {}
    offsets: dict[int, Offset] = {}
    bound: dict[tuple[str, int], str] = {}
    for symbol, places in card.lengths.items():
        for place in places:
            entry = f"lengths.{symbol}"
            text = _text(place)
            if place.joint not in joints:
                card.fail(entry, Fault.BOUND_TO_NO_JOINT, symbol=symbol, place=text, joints=list(joints))
            if (place.joint, place.axis) in bound:
                other = bound[place.joint, place.axis]
                card.fail(entry, Fault.BOUND_TWICE, symbol=symbol, other=other, place=text.lstrip("-"))
            bound[place.joint, place.axis] = symbol
            frame = joints[place.joint].frame_on_parent()
            X_PF = None if frame.is_body_frame() else frame.GetPoseInParentFrame(context)
            value = 0.0 if X_PF is None else place.sign * float(X_PF.translation()[place.axis])
            if X_PF is None or abs(value) <= TOLERANCE:
                card.fail(entry, Fault.BOUND_TO_ZERO, symbol=symbol, place=text, model=card.model.name)
            if abs(lengths.setdefault(symbol, value) - value) > TOLERANCE:
                card.fail(entry, Fault.BOUND_DIFFERENTLY, symbol=symbol, first=lengths[symbol], value=value, place=text)
            index = int(frame.index())
            offset = offsets.get(index) or exact_offset(X_PF)
            translation = list(offset.translation)
            translation[place.axis] = scale(generator("symbol", symbol), place.sign)
            offsets[index] = replace(offset, translation=tuple(translation))
    return lengths, offsets


def _text(place: Place) -> str:
    return f"{'-' if place.sign < 0 else ''}{place.joint}.{'xyz'[place.axis]}"


def _find_frame(card: Card, plant: Any, name: str, place: str) -> Any:
    """Return the Drake frame of a card's place: a link or frame of the model, or "<joint>.parent"."""
    joints = _model_joints(plant)
    joint, _, end = place.rpartition(".")
    if end == "parent" and joint in joints:
        return joints[joint].frame_on_parent()
    frames = {frame.name(): frame for frame in frames_of(plant)}
    if place in frames:
        return frames[place]
    links = [frame.name() for frame in frames.values() if frame.is_body_frame()]
    card.fail(f"frames.{name}", Fault.FRAME_NOWHERE, frame=name, place=place, links=links, joints=list(joints))
