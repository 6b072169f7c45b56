"""What front matter and notation name on an arm: poses, origins, axes and Jacobians, in the frames that are meant."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import KINDS, as_front_matter, as_line, is_planar
from armproof.verification.errors import DocumentError
from armproof.verification.latex import nodes as n
from armproof.verification.naming.quantities import frame_name, read_quantity, tells_frame
from armproof.verification.naming.reading import read_names
from armproof.verification.verdict import Verdict

# notation → what it means on the SCARA; the upper index of T^i_j is the reference
IMPLIED = {
    r"{}^1T_3": Quantity("pose", "3", "1"),
    r"{}^1_3T": Quantity("pose", "3", "1"),
    r"^1T_3": Quantity("pose", "3", "1"),
    r"T^1_3": Quantity("pose", "3", "1"),
    r"\mathbf{T}_3^1": Quantity("pose", "3", "1"),
    r"A^1_3": Quantity("pose", "3", "1"),
    r"H^1_3": Quantity("pose", "3", "1"),
    r"T_{13}": Quantity("pose", "3", "1"),
    r"T_{1,3}": Quantity("pose", "3", "1"),
    r"A_3": Quantity("pose", "3", "2"),
    r"T^0_n": Quantity("pose", "4", "0"),
    r"R^1_3": Quantity("rotation", "3", "1"),
    r"p_3": Quantity("origin", "3", "0"),
    r"p_3^1": Quantity("origin", "3", "1"),
    r"{}^1p_3": Quantity("origin", "3", "1"),
    r"z_2": Quantity("axis", "2", "0"),
    r"z_2^1": Quantity("axis", "2", "1"),
    r"{}^1x_2": Quantity("axis", "2", "1", along="x"),
    r"J": Quantity("jacobian", "4", "0"),
    r"{}^4J": Quantity("jacobian", "4", "4"),
    r"J_v": Quantity("jacobian", "4", "0", rows=(1, 2, 3)),
    r"J_\omega": Quantity("jacobian", "4", "0", rows=(4, 5, 6)),
}
UNKNOWN = [
    r"T^1_7",
    r"T_3",
    r"p_x",
    r"J'",
    r"x_2",
    r"A_0",
    r"z_{12}",
    r"T'^1_3",
    r"{}_1T_{23}",
    r"{}_1p_2",
    r"{}^1p_2^0",
]


def meaning(latex: str, arm: str = "scara", **front: Any) -> Quantity | None:
    names = read_names(load_arm(arm), front)
    return names.quantity(names.reader.read_expression(latex))  # type: ignore[arg-type]


@pytest.mark.parametrize(("latex", "quantity"), IMPLIED.items(), ids=IMPLIED.keys())
def test_common_notation_needs_no_front_matter(latex: str, quantity: Quantity) -> None:
    assert meaning(latex) == quantity


@pytest.mark.parametrize("latex", UNKNOWN)
def test_what_notation_does_not_settle_is_left_unbound(latex: str) -> None:
    assert meaning(latex) is None


def test_transforms_lower_turns_the_indices_of_a_script_pair_only() -> None:
    assert meaning(r"T^1_3", transforms="lower") == Quantity("pose", "1", "3")
    assert meaning(r"T_1^3", transforms="lower") == Quantity("pose", "3", "1")
    assert meaning(r"R_1^3", transforms="lower") == Quantity("rotation", "3", "1")
    for latex in (r"{}^1T_3", r"{}^1_3T"):  # pre-scripts always name the reference above
        assert meaning(latex, transforms="lower") == Quantity("pose", "3", "1")


def test_frames_are_those_of_the_document() -> None:
    assert meaning("J", "spherical_wrist") == Quantity("jacobian", "6", "3")
    assert meaning("p_4", "spherical_wrist") == Quantity("origin", "4", "3")
    assert meaning("A_4", "spherical_wrist") == Quantity("pose", "4", "3")
    assert meaning("p_P", "spatial_rrr") == Quantity("origin", "P", "0")
    assert meaning("J", "spatial_rrr") == Quantity("jacobian", "3", "0")
    assert meaning("p_2", "spherical_wrist") is None


# -- the laws that tie them together, on every arm ---------------------------------------------------------------------------


def equal(a: Matrix, b: Matrix) -> bool:
    return a.shape == b.shape and all(
        (x - y).is_zero() for r, s in zip(a.rows, b.rows, strict=True) for x, y in zip(r, s, strict=True)
    )


def test_origins_axes_and_rotations_are_parts_of_poses(arm: Arm, workbench: Callable[..., Any]) -> None:
    of = workbench(arm.name).exact.quantity
    base, tool = arm.frames[0], arm.frames[-1]
    pose = of(Quantity("pose", tool, base))
    assert equal(of(Quantity("rotation", tool, base)), pose.block(range(3), range(3)))
    assert equal(of(Quantity("origin", tool, base)), pose.block(range(3), [3]))
    assert equal(of(Quantity("origin", tool, base, homogeneous=True)), pose.block(range(4), [3]))
    for k, along in enumerate("xyz"):
        assert equal(of(Quantity("axis", tool, base, along=along)), pose.block(range(3), [k]))
    assert of(Quantity("origin", tool, base, rows=(2,), scalar=True)) is not None


def test_a_jacobian_in_another_frame_is_the_rotated_one(arm: Arm, workbench: Callable[..., Any]) -> None:
    of = workbench(arm.name).exact.quantity
    base, tool = arm.frames[0], arm.frames[-1]
    rotation = of(Quantity("rotation", base, tool))
    there, here = of(Quantity("jacobian", tool, tool)), of(Quantity("jacobian", tool, base))
    count = range(len(arm.joints))
    for block in (range(3), range(3, 6)):
        assert equal(there.block(block, count), rotation @ here.block(block, count))


def test_a_difference_is_of_origins(arm: Arm, workbench: Callable[..., Any]) -> None:
    of = workbench(arm.name).exact.quantity
    base, middle, tool = arm.frames[0], arm.frames[1], arm.frames[-1]
    difference = of(Quantity("difference", tool, base, start=middle))
    assert equal(difference + of(Quantity("origin", middle, base)), of(Quantity("origin", tool, base)))


# -- front matter ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("spec", "quantity"),
    [
        ({"pose": 4}, Quantity("pose", "4")),
        ({"pose": "n", "in": 2}, Quantity("pose", "4", "2")),
        ({"pose": 4, "component": [1, 3]}, Quantity("pose", "4", rows=(1,), columns=(3,), scalar=True)),
        ({"origin": 4, "component": "y"}, Quantity("origin", "4", rows=(2,), scalar=True)),
        ({"origin": 3, "homogeneous": True}, Quantity("origin", "3", homogeneous=True)),
        ({"axis": 2, "along": "x", "in": 1}, Quantity("axis", "2", "1", along="x")),
        (
            {"jacobian": 4, "rows": [1, 2, 6], "columns": [2, 1]},
            Quantity("jacobian", "4", rows=(1, 2, 6), columns=(2, 1)),
        ),
        ({"jacobian": 4, "rows": 3}, Quantity("jacobian", "4", rows=(3,))),
        ({"difference": [4, 1]}, Quantity("difference", "4", start="1")),
        ({"joint": "d_3"}, Quantity("joint", "d_3", scalar=True)),
        ({"vector": "q"}, Quantity("vector", "q")),
        ({"velocity": 4, "rows": [4, 5, 6]}, Quantity("velocity", "4", rows=(4, 5, 6))),
        ({"velocity": 4, "component": "y"}, Quantity("velocity", "4", rows=(2,), scalar=True)),
        ({"velocity": 4, "rows": [4, 5, 6], "component": "z"}, Quantity("velocity", "4", rows=(6,), scalar=True)),
        ({"angle": 4}, Quantity("angle", "4", scalar=True)),
        ({"task": 4}, Quantity("task", "4")),
        (
            {"determinant": 4, "rows": [1, 2, 3, 6]},
            Quantity("determinant", "4", rows=(1, 2, 3, 6), scalar=True),
        ),
        (
            {"manipulability": 4, "in": 1, "rows": [1, 2, 3]},
            Quantity("manipulability", "4", "1", rows=(1, 2, 3), scalar=True),
        ),
    ],
)
def test_an_entry_of_the_front_matter_is_read(spec: dict[str, Any], quantity: Quantity) -> None:
    assert read_quantity("X", spec, load_arm("scara")) == quantity
    if quantity.kind not in ("joint", "vector"):
        assert read_quantity("X", as_front_matter(quantity), load_arm("scara")) == quantity


def test_rows_and_columns_stand_in_the_order_listed(workbench: Callable[..., Any]) -> None:
    of = workbench("scara").exact.quantity
    whole = of(Quantity("jacobian", "4"))
    assert equal(of(Quantity("jacobian", "4", rows=(6, 1), columns=(2, 1))), whole.block([5, 0], [1, 0]))


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        (3, "quantity 'X' must name one of pose, rotation, origin, axis, jacobian"),
        ({}, "quantity 'X' must name one of pose"),
        ({"pose": 1, "origin": 2}, "quantity 'X' must name one of pose"),
        (
            {"origin": 4, "along": "x"},
            "quantity 'X': unknown option along; valid with 'origin': component, homogeneous, in, rows",
        ),
        ({"origin": 9}, "quantity 'X': no frame '9' on arm 'scara'; its frames are 0, 1, 2, 3, 4"),
        ({"pose": 4, "in": "tool"}, "no frame 'tool' on arm 'scara'"),
        ({"origin": 4, "component": "w"}, "'component' must be x, y or z, not 'w'"),
        ({"pose": 4, "component": [5, 1]}, r"'component' of a pose is \[row, column\], not \[5, 1\]"),
        ({"axis": 4, "along": "w"}, "'along' must be x, y or z, not 'w'"),
        ({"jacobian": 4, "rows": [0]}, r"rows must be a list of indices counted from 1, not \[0\]"),
        ({"jacobian": 4, "rows": "all"}, "rows must be a list of indices counted from 1, not 'all'"),
        ({"jacobian": 4, "rows": [7]}, "a jacobian has 6 rows, there is no row 7"),
        ({"jacobian": 4, "columns": [5]}, "a jacobian has 4 columns, there is no column 5"),
        ({"difference": 4}, r"'difference' takes two frames, \[to, from\], not 4"),
        ({"joint": "theta_9"}, "no joint 'theta_9'; the arm's are theta_1, theta_2, d_3, theta_4"),
        ({"link": "khalil"}, "'link' must be classic or modified, not 'khalil'"),
        ({"determinant": 4}, "as many rows of the Jacobian as there are joints, 4, not of 6"),
        ({"determinant": 4, "rows": [1, 2, 3]}, "as many rows of the Jacobian as there are joints, 4, not of 3"),
        ({"manipulability": 4}, "of 6 rows of the Jacobian of 4 joints is 0: name at most 4"),
        ({"velocity": 4, "along": "x"}, "unknown option along; valid with 'velocity': component, in, rows"),
    ],
)
def test_an_entry_that_means_nothing_is_refused_with_the_choices(spec: object, message: str) -> None:
    with pytest.raises(DocumentError, match=message):
        read_quantity("X", spec, load_arm("scara"))


@pytest.mark.parametrize("kind", ["angle", "task"])
def test_the_angle_of_a_frame_is_that_of_an_arm_in_a_plane(kind: str) -> None:
    with pytest.raises(DocumentError, match="only an arm that moves in a plane has this"):
        read_quantity("X", {kind: 6}, load_arm("rx90"))


BOUND = {  # a name with its meaning → what it is on the planar arm with two links, and a false twin
    "velocity": ({"velocity": 2, "rows": [1, 2]}, r"\begin{bmatrix} -(l_1 S_1 + l_2 S_{12}) \dot\theta_1 - l_2 S_{12} \dot\theta_2 \\ "
                 r"(l_1 C_1 + l_2 C_{12}) \dot\theta_1 + l_2 C_{12} \dot\theta_2 \end{bmatrix}", (r"l_2 C_{12} \dot\theta_2", r"l_2 C_2 \dot\theta_2")),
    "spin": ({"velocity": 2, "rows": [4, 5, 6], "component": "z"}, r"\dot\theta_1 + \dot\theta_2", ("+", "-")),
    "angle": ({"angle": 2}, r"\theta_1 + \theta_2", ("+", "-")),
    "task": ({"task": 2}, r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ \theta_1 + \theta_2 \end{bmatrix}", ("S_{12}", "S_2")),
    "determinant": ({"determinant": 2, "rows": [1, 2]}, r"l_1 l_2 S_2", ("S_2", "C_2")),
    "square": ({"manipulability": 2, "rows": [1, 2]}, r"\sqrt{(l_1 l_2 S_2)^2}", ("S_2", "C_2")),
}  # fmt: skip


@pytest.mark.parametrize(("spec", "value", "slip"), BOUND.values(), ids=BOUND)
def test_a_name_bound_to_a_kind_is_a_claim(
    judge: Callable[..., Any], spec: dict[str, Any], value: str, slip: tuple[str, str]
) -> None:
    bound = {"arm": "planar_2r", "quantities": {"Q_Z": spec}}
    assert judge(f"Q_Z = {value}", **bound).verdict in (Verdict.PROVED, Verdict.CONFIRMED)
    assert judge(f"Q_Z = {value.replace(*slip)}", **bound).verdict is Verdict.REFUTED


def test_units_stand_with_the_kinds() -> None:
    arm = load_arm("planar_2r")
    units = {
        ("pose", 0, 3): "m", ("pose", 0, 0): "–", ("jacobian", 0, 0): "m/rad", ("jacobian", 5, 1): "–",
        ("velocity", 0, 0): "m/s", ("velocity", 5, 0): "rad/s", ("task", 2, 0): "rad", ("origin", 1, 0): "m",
    }  # fmt: skip
    for (kind, row, column), unit in units.items():
        assert KINDS[kind].unit(Quantity(kind, "2"), arm, row, column) == unit
    assert KINDS["jacobian"].unit(Quantity("jacobian", "2", rows=(6, 1)), arm, 1, 0) == "m/rad"


def test_a_quantity_of_an_arm_needs_one() -> None:
    with pytest.raises(DocumentError, match="quantity 'X' is of an arm, but the front matter names no arm"):
        read_quantity("X", {"origin": 3}, None)
    assert read_quantity("X", {"link": "classic"}, None).kind == "link"


def test_a_frame_called_n_outranks_the_last_frame() -> None:
    assert frame_name(load_arm("kr210"), "n") == "6"
    assert frame_name(load_arm("spherical_wrist"), "N") == "6"


def test_a_velocity_is_in_metres_a_second_and_a_rate_of_turn_in_radians() -> None:
    arm, velocity = load_arm("scara"), Quantity("velocity", "4", "0")
    assert [KINDS["velocity"].unit(velocity, arm, row, 0) for row in range(6)] == ["m/s"] * 3 + ["rad/s"] * 3
    turning = Quantity("velocity", "4", "0", rows=(4, 5, 6))
    assert [KINDS["velocity"].unit(turning, arm, row, 0) for row in range(3)] == ["rad/s"] * 3


@pytest.mark.parametrize(("row", "unit"), [(0, "rad"), (1, "rad"), (2, "m"), (3, "rad")])
def test_the_joint_variables_have_the_units_of_their_joints(row: int, unit: str) -> None:
    scara = load_arm("scara")
    assert KINDS["vector"].unit(Quantity("vector", ""), scara, row, 0) == unit
    assert KINDS["joint"].unit(Quantity("joint", scara.joints[row].symbol), scara, 0, 0) == unit


@pytest.mark.parametrize(
    ("quantity", "row", "column", "unit"),
    [
        (Quantity("pose", "4"), 2, 3, "m"), (Quantity("pose", "4"), 3, 3, "–"), (Quantity("pose", "4"), 2, 2, "–"), (Quantity("pose", "4", rows=(4, 1)), 0, 3, "–"),
        (Quantity("origin", "4", homogeneous=True), 2, 0, "m"), (Quantity("origin", "4", homogeneous=True), 3, 0, "–"), (Quantity("axis", "4"), 0, 0, "–"),
        (Quantity("difference", "4"), 0, 0, "m"), (Quantity("jacobian", "4"), 2, 2, "–"), (Quantity("jacobian", "4"), 3, 2, "rad/m"),
        (Quantity("jacobian", "4"), 3, 0, "–"), (Quantity("jacobian", "4", columns=(3, 1)), 0, 1, "m/rad"), (Quantity("task", "4"), 1, 0, "m"),
        (Quantity("task", "4"), 2, 0, "rad"), (Quantity("angle", "4"), 0, 0, "rad"), (Quantity("velocity", "4", rows=(3, 4)), 1, 0, "rad/s"),
    ],
)  # fmt: skip
def test_each_entry_has_the_unit_of_its_row_and_column(quantity: Quantity, row: int, column: int, unit: str) -> None:
    assert KINDS[quantity.kind].unit(quantity, load_arm("scara"), row, column) == unit


@pytest.mark.parametrize(
    ("quantity", "words"),
    [
        (Quantity("jacobian", "2", columns=(1, 2)), "columns 1, 2 of the Jacobian of frame 2 in frame 0"),
        (Quantity("jacobian", "2", rows=(4,), columns=(1,)), "row 4 of column 1 of the Jacobian of frame 2 in frame 0"),
        (Quantity("velocity", "2", rows=(3,), scalar=True), "linear velocity of frame 2 in frame 0, z"),
        (Quantity("velocity", "2", rows=(4,), scalar=True), "angular velocity of frame 2 in frame 0, x"),
        (Quantity("velocity", "2", rows=(1, 2)), "linear rows 1, 2 of velocity of frame 2 in frame 0"),
        (Quantity("velocity", "2"), "velocity of frame 2 in frame 0"),
        (Quantity("determinant", "2", rows=(1, 2)), "determinant of rows 1, 2 of the Jacobian of frame 2"),
        (Quantity("difference", "2", start="1"), "vector from the origin of frame 1 to that of frame 2 in frame 0"),
        (Quantity("axis", "2", "1", along="x", rows=(2,), scalar=True), "x axis of frame 2 in frame 1, y"),
    ],
)  # fmt: skip
def test_a_quantity_is_told_by_its_rows_and_columns(quantity: Quantity, words: str) -> None:
    assert str(KINDS[quantity.kind].tell(quantity)) == words


def test_a_component_of_a_velocity_is_written_as_front_matter() -> None:
    velocity = KINDS["velocity"]
    assert velocity.component(Quantity("velocity", "2", rows=(4,)), "x").rows == (4,)
    assert velocity.component(Quantity("velocity", "2", rows=(1, 2, 3)), "y").rows == (2,)
    of_x = Quantity("velocity", "2", rows=(4,), scalar=True)
    assert as_front_matter(of_x) == {"velocity": 2, "rows": [4, 5, 6], "component": "x"}
    assert as_front_matter(replace(of_x, rows=(3,))) == {"velocity": 2, "component": "z"}
    assert as_front_matter(Quantity("pose", "2", "1", (1,), (4,), scalar=True)) == {
        "pose": 2,
        "in": 1,
        "component": [1, 4],
    }
    assert (
        as_line("p", Quantity("origin", "P", "1", homogeneous=True))
        == 'quantities: {"p": {origin: P, in: 1, homogeneous: True}}'
    )


@pytest.mark.parametrize("turn", ["0", "pi/2"])
def test_an_arm_that_turns_about_another_axis_than_z_is_not_planar(turn: str) -> None:
    rows = [{"a": 0, "alpha": "pi/2", "d": 0, "theta": turn}, {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"}]
    assert not is_planar(load_arm({"dh": "classic", "rows": rows, "joints": ["theta_2"]}))
    assert is_planar(load_arm({"dh": "classic", "rows": rows[1:]}))
    slide = [{"a": 0, "alpha": 0, "d": "d_1", "theta": 0}]
    assert not is_planar(load_arm({"dh": "classic", "rows": slide}))  # nothing turns


def test_a_difference_is_rows_of_the_last_column_of_a_pose() -> None:
    assert KINDS["difference"].block(Quantity("difference", "2", rows=(2,))) == ([1], [3])


def test_an_entry_of_a_matrix_says_where_it_stands_and_not_of_which_frame() -> None:
    whole, rows = Quantity("jacobian", "3"), Quantity("jacobian", "3", rows=(1, 2))
    entry = replace(rows, columns=(1,))
    name = n.Name("J", "13")
    assert [tells_frame(name, each) for each in (whole, rows, entry)] == [True, True, False]
    assert tells_frame(n.Name("J", pre_sup="3"), entry) and not tells_frame(n.Name("J"), whole)


def test_two_digits_are_two_frames_unless_a_link_has_that_number() -> None:
    rows = [{"a": f"l_{k}", "alpha": 0, "d": 0, "theta": f"theta_{k}"} for k in range(1, 13)]
    names = read_names(load_arm({"dh": "classic", "rows": rows}), {})
    found = {latex: names.quantity(names.reader.read_expression(latex)) for latex in ("A_{12}", "T_{12}", "A_{45}")}  # type: ignore[arg-type]
    assert found == {
        "A_{12}": Quantity("pose", "12", "11"),
        "T_{12}": Quantity("pose", "2", "1"),
        "A_{45}": Quantity("pose", "5", "4"),
    }
