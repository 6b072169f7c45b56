"""An arm on Meshcat's stage: it goes where it is told, and a machine without a server says so."""

import numpy as np
import pytest

from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.stage import Stage


def test_an_arm_goes_where_it_is_told_and_an_answer_is_marked():
    arm, q = load_arm("planar_2r"), np.array([0.4, -0.8])
    stage = Stage(arm)
    tool = NumericKinematics(arm, q[None]).pose("2")[0, :3, 3]
    assert np.linalg.norm(stage.move(q) - tool, axis=1).min() < 1e-12
    assert np.linalg.norm(stage.move(q + 0.5) - tool, axis=1).min() > 0.1
    assert not stage.meshcat.HasPath("answer/x")
    stage.mark(np.eye(4), 0.1)
    assert stage.meshcat.HasPath("answer/x") and stage.meshcat.HasPath("answer/z")


def test_a_machine_on_which_no_server_starts_says_so(monkeypatch):
    def none(parameters):
        raise RuntimeError("no port is free")

    monkeypatch.setattr("pydrake.geometry.Meshcat", none)
    with pytest.raises(ModelError, match="cannot be shown in Meshcat: no port is free"):
        Stage(load_arm("planar_2r"))
