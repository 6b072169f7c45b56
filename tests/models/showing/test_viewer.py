"""The picture of an arm: every document frame has its triad, every joint moves, and the base stands still."""

import numpy as np
import pytest
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.systems.framework import DiagramBuilder

from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.drake_arm import frame_of, plant_of
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.viewer import add_arm, view_arm

TABLE = {"dh": "classic", "rows": [{"a": "l_1", "alpha": 0, "d": 0, "theta": "theta_1"}]}


def scene(arm):
    """Return the finalized plant and the scene graph of the diagram that shows an arm, and the diagram."""
    builder = DiagramBuilder()
    plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 0.0)
    add_arm(Parser(plant, scene_graph), arm)
    plant.Finalize()
    return plant, scene_graph.model_inspector(), builder.Build()


def triads(inspector) -> dict[str, dict[str, object]]:
    """Return the geometry of each axis, by frame and axis."""
    found: dict[str, dict[str, object]] = {}
    for geometry in inspector.GetAllGeometryIds():
        name = inspector.GetName(geometry)
        if "_frames::" in name:
            *_, frame, axis = name.split("::")
            found.setdefault(frame.removeprefix("frame "), {})[axis[0]] = geometry
    return found


@pytest.mark.parametrize("name", arm_names())
def test_every_document_frame_has_its_triad_and_only_the_joints_move(name: str):
    arm = load_arm(name)
    plant, inspector, diagram = scene(arm)
    assert plant.num_positions() == len(arm.joints)
    assert inspector.num_geometries() > 3 * len(arm.frames), "the arm itself is not shown"
    found = triads(inspector)
    assert set(found) == set(arm.frames)
    q = np.linspace(0.1, 0.9, len(arm.joints))
    context = plant.GetMyContextFromRoot(diagram.CreateDefaultContext())
    plant.SetPositions(context, q)
    moved = plant_of(arm).CreateDefaultContext()
    plant_of(arm).SetPositions(moved, q)
    base = arm.frames[0]
    X_W0 = frame_of(arm, base).CalcPoseInWorld(moved).GetAsMatrix4()
    for frame, axes in found.items():
        X_WF = X_W0 @ NumericKinematics(arm, q[np.newaxis]).pose(frame, base)[0]
        for column, axis in enumerate("xyz"):
            length = inspector.GetShape(axes[axis]).length()
            middle = X_WF[:3, 3] + length / 2 * X_WF[:3, column]
            np.testing.assert_allclose(position(plant, inspector, context, axes[axis]), middle, atol=1e-9)


def position(plant, inspector, context, geometry) -> np.ndarray:
    """Return where the middle of a geometry is in the world."""
    body = plant.GetBodyFromFrameId(inspector.GetFrameId(geometry))
    return (plant.EvalBodyPoseInWorld(context, body) @ inspector.GetPoseInFrame(geometry)).translation()


def test_an_arm_without_a_shape_cannot_be_viewed():
    with pytest.raises(ModelError, match=r"was given by a DH table and has no shape"):
        view_arm(load_arm(TABLE))


def test_a_link_without_its_mesh_is_a_rod_to_the_next_joint(tmp_path):
    mesh = '<visual><geometry><mesh filename="package://nowhere/arm.obj"/></geometry></visual>'
    joints = "".join(
        f'<joint name="j{k}" type="revolute"><parent link="l{k}"/><child link="l{k + 1}"/><origin xyz="0.3 0 {k}"/>'
        '<axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>'
        for k in range(2)
    )
    links = f'<link name="l0">{mesh}{mesh.replace("visual", "collision")}</link><link name="l1">{mesh}</link><link name="l2"/>'
    path = tmp_path / "arm.urdf"
    path.write_text(f'<robot name="r">{links}{joints}</robot>')
    _, inspector, _ = scene(load_arm(path))
    shapes = [
        type(inspector.GetShape(geometry)).__name__
        for geometry in inspector.GetAllGeometryIds()
        if "_frames::" not in inspector.GetName(geometry)
    ]
    assert sorted(shapes) == ["Cylinder", "Cylinder", "Sphere", "Sphere"]
    path.write_text(
        f'<robot name="r">{links}{joints}</robot>'.replace(mesh, "").replace(mesh.replace("visual", "collision"), "")
    )
    assert scene(load_arm(path))[1].num_geometries() == 3 * len(load_arm(path).frames)
