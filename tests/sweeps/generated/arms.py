"""Random arms of 2 to 7 joints: by a DH table or as a URDF, each with a plant of Drake's built here and nothing of ours in it."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from math import pi
from random import Random
from typing import Any

import numpy as np
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import FixedOffsetFrame, PrismaticJoint, RevoluteJoint, SpatialInertia

from tests.labelled.plant_truth import PlantTruth
from tests.sweeps.generated.polynomials import PolynomialMatrix, atom, constant, product

AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


@dataclass
class RandomArm:
    """An arm, its front matter, its plant, and the matrices of its links for printing."""

    front: str
    truth: PlantTruth
    links: list[PolynomialMatrix]
    joints: list[str]  # theta_1 or q_1, d_2 …
    angles: list[str]  # "1" for a revolute joint 1, "" for a prismatic one
    urdf: str = ""
    convention: str = ""
    lengths: list[str] = field(default_factory=list)

    def pose(self, reference: int, frame: int) -> PolynomialMatrix:
        """Return the pose of a later frame in an earlier one."""
        found = self.links[reference]
        for link in self.links[reference + 1 : frame]:
            found = product(found, link)
        return found


def random_arm(rng: Random) -> RandomArm:
    """Return a random arm."""
    return by_table(rng) if rng.random() < 0.8 else by_urdf(rng)


# -- DH tables -----------------------------------------------------------------------------------------------------------


def by_table(rng: Random) -> RandomArm:
    """Return an arm given by a DH table with lengths as letters."""
    convention, letter = rng.choice(["classic", "modified"]), rng.choice(["theta", "theta", "q"])
    rows, lengths = [], {}
    for i in range(1, rng.randint(2, 7) + 1):
        revolute = rng.random() < 0.8
        row = {"a": rng.choice(["0", f"a_{i}"]), "alpha": rng.choice([0, 0, 1, -1]), "revolute": revolute}
        row["d"] = rng.choice(["0", f"d_{i}"]) if revolute else f"d_{i}"
        row["joint"] = f"{letter}_{i}" if revolute else f"d_{i}"
        lengths.update(
            {name: rng.uniform(0.2, 0.9) for name in (row["a"], row["d"]) if name not in ("0", row["joint"])}
        )
        rows.append(row)
    text = "".join(
        f"    - {{a: {r['a']}, alpha: {_turns(r['alpha'])}, d: {r['d']}, theta: {r['joint'] if r['revolute'] else 0}}}\n"
        for r in rows
    )
    front = f"arm:\n  dh: {convention}\n  rows:\n{text}  joints: [{', '.join(r['joint'] for r in rows)}]\n"
    links = [_link(row, k, convention) for k, row in enumerate(rows, 1)]
    joints = [row["joint"] for row in rows]
    angles = [str(k) if row["revolute"] else "" for k, row in enumerate(rows, 1)]
    truth = _plant_of_table(rows, lengths, convention)
    return RandomArm(front, truth, links, joints, angles, "", convention, list(lengths))


def _turns(quarter: int) -> str:
    return {0: "0", 1: "pi/2", -1: "-pi/2"}[quarter]


def _link(row: dict[str, Any], k: int, convention: str) -> PolynomialMatrix:
    one, zero = constant(1), constant(0)
    turn = turned(2, f"{k}") if row["revolute"] else moved((0, 0, 0))
    lift = moved_by(2, row["d"])
    along, tilt = moved_by(0, row["a"]), quarter_turn(0, row["alpha"])
    parts = [turn, lift, along, tilt] if convention == "classic" else [tilt, along, turn, lift]
    found = [[one if r == c else zero for c in range(4)] for r in range(4)]
    for part in parts:
        found = product(found, part)
    return found


def _plant_of_table(rows: list[dict[str, Any]], lengths: dict[str, float], convention: str) -> PlantTruth:
    plant = MultibodyPlant(0.0)
    before = plant.world_frame()
    frames, joints = {"0": before}, []
    for k, row in enumerate(rows, 1):
        tilt = RigidTransform(RotationMatrix.MakeXRotation(row["alpha"] * pi / 2), [lengths.get(row["a"], 0.0), 0, 0])
        lift = RigidTransform([0, 0, lengths.get(row["d"], 0.0) if row["revolute"] else 0.0])
        link = plant.AddRigidBody(f"link{k}", SpatialInertia.SolidSphereWithMass(1.0, 0.1))
        ahead, behind = (RigidTransform(), lift @ tilt) if convention == "classic" else (tilt, lift)
        parent = plant.AddFrame(FixedOffsetFrame(f"before{k}", before, ahead))
        kind = RevoluteJoint if row["revolute"] else PrismaticJoint
        joints.append(plant.AddJoint(kind(f"joint{k}", parent, link.body_frame(), [0.0, 0.0, 1.0])))
        before = plant.AddFrame(FixedOffsetFrame(f"frame{k}", link.body_frame(), behind))
        frames[str(k)] = before
    plant.Finalize()
    return PlantTruth(plant, frames, joints, tuple(row["joint"] for row in rows), lengths)


# -- URDFs ---------------------------------------------------------------------------------------------------------------


def by_urdf(rng: Random) -> RandomArm:
    """Return an arm given by a URDF with numbers for its lengths."""
    text, links, joints, angles = "", [], [], []
    count = rng.randint(2, 5)
    for k in range(1, count + 1):
        shift = tuple(Fraction(rng.choice([0, 0, 15, 25, 40, -20]), 100) for _ in AXES)
        quarter, about, axis, revolute = (
            rng.choice([0, 0, 1, -1]),
            rng.randrange(3),
            rng.randrange(3),
            rng.random() < 0.8,
        )
        rpy = " ".join(str(quarter * pi / 2) if j == about else "0" for j in range(3))
        joints.append(f"theta_{k}" if revolute else f"d_{k}")
        angles.append(str(k) if revolute else "")
        motion = turned(axis, str(k)) if revolute else moved_by(axis, f"d_{k}")
        links.append(product(product(moved(shift), quarter_turn(about, quarter)), motion))
        text += _joint_of_urdf(k, shift, rpy, AXES[axis], revolute)
    bodies = "".join(_link_of_urdf(k) for k in range(count + 1))
    urdf = f'<robot name="random">{bodies}{text}</robot>\n'
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(urdf, "urdf")
    plant.WeldFrames(plant.world_frame(), plant.GetFrameByName("link0"))
    plant.Finalize()
    frames = {str(k): plant.GetFrameByName(f"link{k}") for k in range(count + 1)}
    drake_joints = [plant.GetJointByName(f"joint{k}") for k in range(1, count + 1)]
    truth = PlantTruth(plant, frames, drake_joints, tuple(joints), {})
    return RandomArm("arm: arm.urdf\n", truth, links, joints, angles, urdf)


def _link_of_urdf(k: int) -> str:
    inertia = '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
    return f'<link name="link{k}"><inertial><mass value="1"/>{inertia}</inertial></link>'


def _joint_of_urdf(k: int, shift: tuple[Fraction, ...], rpy: str, axis: tuple[int, ...], revolute: bool) -> str:
    xyz = " ".join(f"{float(part):g}" for part in shift)
    along = " ".join(map(str, axis))
    limit = '<limit lower="-3" upper="3" effort="9" velocity="9"/>'
    ends = f'<parent link="link{k - 1}"/><child link="link{k}"/>'
    kind = "revolute" if revolute else "prismatic"
    origin = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{along}"/>'
    return f'<joint name="joint{k}" type="{kind}">{ends}{origin}{limit}</joint>'


# -- elementary motions ----------------------------------------------------------------------------------------------------


def turned(axis: int, angle: str) -> PolynomialMatrix:
    """Return a turn about a coordinate axis by θ_angle."""
    return _turn(axis, atom(f"c{angle}"), atom(f"s{angle}"), {(f"s{angle}",): Fraction(-1)})


def quarter_turn(axis: int, quarter: int) -> PolynomialMatrix:
    """Return a turn about a coordinate axis by a multiple of 90°."""
    sine = int(np.round(np.sin(quarter * pi / 2)))
    return _turn(axis, constant(1 if quarter == 0 else 0), constant(sine), constant(-sine))


def _turn(axis: int, cosine: Any, sine: Any, minus: Any) -> PolynomialMatrix:
    found = moved((0, 0, 0))
    j, k = (axis + 1) % 3, (axis + 2) % 3
    found[j][j], found[j][k], found[k][j], found[k][k] = cosine, minus, sine, cosine
    return found


def moved(shift: tuple[Fraction | int, ...]) -> PolynomialMatrix:
    """Return a displacement by numbers."""
    found = [[constant(int(r == c)) for c in range(4)] for r in range(4)]
    for r, part in enumerate(shift):
        found[r][3] = constant(part)
    return found


def moved_by(axis: int, name: str) -> PolynomialMatrix:
    """Return a displacement along an axis by a letter; "0" is none."""
    found = moved((0, 0, 0))
    if name != "0":
        found[axis][3] = atom(name)
    return found
