"""Rendered pictures: the arm is where the plant has it, the camera projects as the renderer does; without EGL it is said."""

import ctypes

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.rendering import ArmRenderer, look_at, require_renderer

TABLE = {"dh": "classic", "rows": [{"a": "l_1", "alpha": 0, "d": 0, "theta": "theta_1"}]}


def can_render() -> bool:
    try:
        require_renderer()
    except ModelError:
        return False
    return True


renders = pytest.mark.skipif(not can_render(), reason="this machine has no EGL to render with")


def inked(image: np.ndarray) -> np.ndarray:
    return (image < 250).any(axis=2)


@renders
def test_a_picture_shows_the_arm_on_white_and_the_same_twice() -> None:
    arm = load_arm("planar_2r")
    renderer = ArmRenderer(arm)
    camera = look_at(np.zeros(3), np.array([0.0, 0.0, 1.0]), 4.0, 160, 120, 0.6)
    picture = renderer.image([0.3, 0.4], camera)
    assert picture.shape == (120, 160, 3) and picture.dtype == np.uint8
    assert 200 < inked(picture).sum() < 0.5 * 160 * 120
    assert np.array_equal(picture, renderer.image([0.3, 0.4], camera))
    assert not np.array_equal(picture, renderer.image([1.3, 0.4], camera))


@renders
@pytest.mark.parametrize("q", [[0.0, 0.0], [1.2, -0.8], [-2.0, 1.0]])
def test_the_tool_is_drawn_where_the_camera_has_the_plants_tool(q: list[float]) -> None:
    arm = load_arm("planar_2r")
    camera = look_at(np.zeros(3), np.array([0.0, 0.0, 1.0]), 4.0, 400, 400, 0.6)
    tool = NumericKinematics(arm, np.array([q])).pose("2")[0, :3, 3]
    column, row = camera.pixels(tool[None])[0]
    ink = np.argwhere(inked(ArmRenderer(arm).image(q, camera)))
    nearest = np.linalg.norm(ink - [row, column], axis=1).min()
    assert nearest <= 3
    opposite = camera.pixels(-tool[None])[0]
    assert np.linalg.norm(ink - opposite[::-1], axis=1).min() > 10  # the negative control


def test_the_camera_has_its_target_in_the_middle_and_z_upwards() -> None:
    camera = look_at(np.array([0.1, 0.2, 0.3]), np.array([1.0, -2.0, 0.5]), 3.0, 640, 480, 0.5)
    assert camera.pixels(np.array([[0.1, 0.2, 0.3]]))[0] == pytest.approx([319.5, 239.5])
    above = camera.pixels(np.array([[0.1, 0.2, 0.4]]))[0]
    assert above[0] == pytest.approx(319.5) and above[1] < 239.5
    assert camera.X_0C[:3, :3] @ camera.X_0C[:3, :3].T == pytest.approx(np.eye(3))
    assert np.linalg.det(camera.X_0C[:3, :3]) == pytest.approx(1)
    with pytest.raises(ModelError, match=r"from 1 to 8192 pixels"):
        look_at(np.zeros(3), np.ones(3), 1.0, 0, 100, 0.5)


def test_without_egl_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        raise OSError(f"{name}: cannot open shared object file")

    monkeypatch.setattr(ctypes, "CDLL", missing)
    with pytest.raises(ModelError, match=r"apt install libegl1 libgl1-mesa-dri"):
        require_renderer()
    with pytest.raises(ModelError, match=r"libEGL.so.1"):
        ArmRenderer(load_arm("planar_2r"))


def test_bad_input_is_named() -> None:
    arm: Arm = load_arm(TABLE)
    with pytest.raises(ModelError, match=r"was given by a DH table and has no shape"):
        ArmRenderer(arm)
    if can_render():
        camera = look_at(np.zeros(3), np.ones(3), 1.0, 20, 20, 0.5)
        with pytest.raises(ModelError, match=r"planar_2r"):
            ArmRenderer(load_arm("planar_2r")).image([1.0, 2.0, 3.0], camera)
