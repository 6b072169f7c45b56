"""Arms for the tests of the figures: the whole catalogue, two DH tables and a model file without a card."""

from pathlib import Path

import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm

TABLES = {
    "puma table": {
        "dh": "classic",
        "rows": [
            {"a": 0, "alpha": "pi/2", "d": 0, "theta": "theta_1"},
            {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"},
            {"a": "a_3", "alpha": "-pi/2", "d": "d_3", "theta": "theta_3"},
            {"a": 0, "alpha": "pi/2", "d": "d_4", "theta": "theta_4"},
            {"a": 0, "alpha": "-pi/2", "d": 0, "theta": "theta_5"},
            {"a": 0, "alpha": 0, "d": "d_6", "theta": "theta_6"},
        ],
    },
    "odd table": {
        "dh": "modified",
        "rows": [
            {"a": 0, "alpha": 0, "d": "l_1", "theta": "q_1"},
            {"a": "l_2 + l_1", "alpha": "pi/2", "d": "d_2 - l_1", "theta": "-90°"},
            {"a": "-l_3", "alpha": "alpha_2 + pi", "d": "0.2", "theta": "beta - theta_3"},
        ],
    },
}
SLANTED = """\
<robot name="r">
<link name="base"/><link name="l1"/><link name="l2"/><link name="tool"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0.1 0 0.3"/>
<axis xyz="0 0 -1"/><limit lower="-2" upper="2.5" effort="1" velocity="1"/></joint>
<joint name="j2" type="continuous"><parent link="l1"/><child link="l2"/><origin xyz="0.3 0 0.1" rpy="0.3 0 0"/><axis xyz="0 1 0"/></joint>
<joint name="t" type="fixed"><parent link="l2"/><child link="tool"/><origin xyz="0 0.4 0.12"/></joint>
</robot>
"""
ARMS = (*arm_names(), *TABLES, "slanted")


def load(name: str, folder: Path) -> Arm:
    if name in TABLES:
        return load_arm(TABLES[name])
    if name != "slanted":
        return load_arm(name)
    path = folder / "slanted.urdf"
    if not path.exists():
        path.write_text(SLANTED, encoding="utf-8")
    return load_arm(path)


@pytest.fixture(scope="session")
def urdf_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("urdf")


@pytest.fixture(params=ARMS)
def arm(request: pytest.FixtureRequest, urdf_folder: Path) -> Arm:
    """Every arm of the catalogue, arms of DH tables, and a plain model file with slanted axes."""
    return load(request.param, urdf_folder)
