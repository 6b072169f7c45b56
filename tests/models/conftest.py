"""Arms for the tests of models/: the whole catalogue, and small arms with what the catalogue does not have."""

from collections.abc import Callable
from pathlib import Path

import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm

ORIGIN = '<origin xyz="{xyz}" rpy="{rpy}"/>'
LIMIT = '<limit lower="-2" upper="2.5" effort="1" velocity="1"/>'


def link(*names: str) -> str:
    return "".join(f'<link name="{name}"/>' for name in names)


def joint(
    name: str,
    parent: str,
    child: str,
    kind: str = "revolute",
    xyz: str = "0 0 0",
    rpy: str = "0 0 0",
    axis: str = "0 0 1",
    extra: str = LIMIT,
) -> str:
    origin = ORIGIN.format(xyz=xyz, rpy=rpy)
    axis = "" if kind in ("fixed", "floating") else f'<axis xyz="{axis}"/>'
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{origin}{axis}{extra}</joint>'


SLANTED = (
    link("base", "l1", "l2", "l3", "tool")
    + joint("j1", "base", "l1", axis="0 0 -1", xyz="0.1 0 0.3")
    + joint("j2", "l1", "l2", kind="continuous", axis="1 1 1", xyz="0.3 0 0.1", rpy="0.3 0 0", extra="")
    + joint("j3", "l2", "l3", kind="prismatic", axis="0 0.6 0.8", xyz="0.45 0 0", rpy="0.7853981633974483 0 0.5")
    + joint("t", "l3", "tool", kind="fixed", xyz="0 0.4 0.12", rpy="-1.5707963267948966 0 0", extra="")
)
TABLES = {
    "classic table": {
        "dh": "classic",
        "rows": [
            {"a": 0.3, "alpha": "alpha_1", "d": "l_1 + 2*l_2", "theta": "-theta_1 + pi/5"},
            {"a": "l_2/3", "alpha": "2*alpha_1 - 30deg", "d": "-d_2 - l_1", "theta": "beta + 0.3"},
            {"a": "l_3", "alpha": "-pi/2", "d": "3/4", "theta": "theta_3 - pi/2"},
        ],
    },
    "modified table": {
        "dh": "modified",
        "rows": [
            {"a": 0, "alpha": 0, "d": "l_1", "theta": "q_1"},
            {"a": "l_2 + l_1", "alpha": "pi/2", "d": "d_2 - l_1", "theta": "-90°"},
            {"a": "-l_3", "alpha": "alpha_2 + pi", "d": "0.2", "theta": "beta - theta_3"},
        ],
    },
}
AXES = ("1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 -1")
BOX = link(*(f"l{i}" for i in range(7))) + "".join(
    joint(f"j{i + 1}", f"l{i}", f"l{i + 1}", "prismatic" if i % 3 == 1 else "revolute", f"0.{i + 1} 0 -0.05", axis=axis)
    for i, axis in enumerate(AXES)
)
OWN = ("slanted", "box", *TABLES)


@pytest.fixture(scope="session")
def write_urdf(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Return a function that writes a URDF of the links and joints given."""

    def write(body: str, name: str = "arm") -> Path:
        path = tmp_path_factory.mktemp("urdf") / f"{name}.urdf"
        path.write_text(f'<robot name="r">\n{body}\n</robot>\n', encoding="utf-8")
        return path

    return write


@pytest.fixture(scope="session", params=[*arm_names(), *OWN])
def arm(request: pytest.FixtureRequest, write_urdf: Callable[..., Path]) -> Arm:
    """Every arm of the catalogue, and arms with slanted axes, axes of all signs, and symbolic DH tables."""
    name = request.param
    if name in TABLES:
        return load_arm(TABLES[name])
    if name in ("slanted", "box"):
        return load_arm(write_urdf(SLANTED if name == "slanted" else BOX, name))
    return load_arm(name)
