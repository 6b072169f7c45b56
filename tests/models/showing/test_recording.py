"""The page in which an arm moves: the arm is all in view, and fills it."""

import numpy as np
import pytest

from armproof.models.showing.stage import camera

HALF_ANGLE = np.radians(75.0) / 2  # of Meshcat's camera, from top to bottom


def angles(points: np.ndarray) -> np.ndarray:
    """Return how far from the middle of the view points are seen (rad)."""
    eye, target = camera(points)
    rays, ahead = points - eye, target - eye
    return np.arccos(rays @ ahead / np.linalg.norm(rays, axis=1) / np.linalg.norm(ahead))


@pytest.mark.parametrize("size", [0.6, 1.0, 5.0])
def test_every_point_is_in_view_and_some_far_from_its_middle(size):
    points = np.random.default_rng(3).uniform(-size, size, (200, 3)) + np.array([1.0, 0.0, size])
    assert angles(points).max() < HALF_ANGLE
    assert angles(points).max() > HALF_ANGLE / 3


def test_a_camera_too_near_is_noticed(monkeypatch):
    monkeypatch.setattr("armproof.models.showing.stage._DISTANCE", 0.8)
    assert angles(np.random.default_rng(3).uniform(-1, 1, (200, 3))).max() > HALF_ANGLE


def test_a_single_point_is_seen_from_a_distance():
    eye, target = camera(np.zeros((1, 3)))
    assert np.linalg.norm(eye - target) > 0.5
