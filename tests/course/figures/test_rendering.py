"""The 3D picture: its frames are drawn where the camera has those of the double plant; without EGL the rest is drawn."""

import numpy as np
import pytest

from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.kinds import rendering
from armproof.course.figures.kinds.rendering import applies, rendered, rendering_figure
from armproof.course.figures.registry import caption_kind, draw_kind, find_kind
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.plant import NumericKinematics
from tests.course.figures.test_sketch import drawn, figure_of
from tests.models.showing.test_rendering import TABLE, renders

PIXEL = 1e-6


@renders
@pytest.mark.parametrize("name", ["planar_2r", "scara", "rx90", "kr210"])
def test_frames_are_drawn_where_the_plant_has_them(name: str) -> None:
    arm = load_arm(name)
    q = showing_pose(arm)
    _, camera = rendered(arm, tuple(q.tolist()))
    lines = drawn(figure_of(rendering_figure, arm))
    numeric = NumericKinematics(arm, q[None])
    for frame in arm.frames:
        X = numeric.pose(frame)[0]
        origin = camera.pixels(X[None, :3, 3])[0]
        for column, axis in enumerate("xyz"):
            line = lines[f"frame {frame} {axis}"]
            assert np.abs(line[0] - origin).max() <= PIXEL
            ahead = camera.pixels(X[None, :3, 3] + 1e-3 * X[None, :3, column])[0] - origin
            along = line[1] - line[0]
            assert (
                abs(along[0] * ahead[1] - along[1] * ahead[0])
                <= 0.05 * np.linalg.norm(along) * np.linalg.norm(ahead) + 1e-3
            )
            assert along @ ahead >= -1e-3
    moved = camera.pixels(NumericKinematics(arm, q[None] + 0.3).pose(arm.frames[-1])[:, :3, 3])[0]
    assert np.abs(lines[f"frame {arm.frames[-1]} x"][0] - moved).max() > 1  # the negative control


@renders
def test_the_whole_arm_is_in_the_picture_and_a_pose_of_ones_own_is_drawn() -> None:
    arm = load_arm("spherical_wrist")
    image, _ = rendered(arm, tuple(showing_pose(arm).tolist()))
    border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
    assert (border > 250).all() and (image < 250).any()
    figure = rendering_figure(arm, q=np.zeros(3))
    assert not np.array_equal(figure.axes[0].images[0].get_array(), image)


def test_an_arm_without_a_shape_or_a_machine_without_egl_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "has no shape" in str(applies(load_arm(TABLE), "en"))
    assert "pas de forme" in str(applies(load_arm(TABLE), "fr"))

    def missing() -> None:
        raise ModelError("no EGL")

    monkeypatch.setattr(rendering, "require_renderer", missing)
    kind, arm = find_kind("rendering"), load_arm("planar_2r")
    assert "apt install libegl1 libgl1-mesa-dri" in str(applies(arm, "en"))
    assert draw_kind(kind, arm, "fr").texts and "libegl1" in caption_kind(kind, arm, "fr")
