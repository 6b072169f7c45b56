"""Names that only their value binds: a quantity of the arm, nearly one, or several."""

from collections.abc import Callable

import pytest

from armproof.verification.verdict import Record, Role, Verdict

Judge = Callable[..., Record]
POINT = r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 %s l_2 s_{12} \\ 0 \end{bmatrix}"


def test_a_name_whose_value_is_a_quantity_is_defined_and_said_to_be_it(judge: Judge) -> None:
    record = judge(f"Q = {POINT % '+'}", arm="planar_2r")
    assert [(each.role, each.read_as) for each in record.outcomes] == [
        (Role.DEFINITION, "origin of frame 2 in frame 0")
    ]
    assert not record.is_decided
    assert judge(f"Q = {POINT % '+'}", "Q = p_2", arm="planar_2r").verdict is Verdict.PROVED


X, Y = r"-l_1 s_1 - l_2 s_{12} & -l_2 s_{12}", r"l_1 c_1 + l_2 c_{12} & l_2 c_{12}"


@pytest.mark.parametrize(
    ("rows", "part"),
    [
        ([X, Y], "rows 1, 2 of "),
        ([X, Y, "0 & 0"], "rows 1, 2, 3 of "),
        ([X, Y, "1 & 1"], "rows 1, 2, 6 of "),
        ([X, Y, "0 & 0", "0 & 0", "0 & 0", "1 & 1"], ""),
    ],
)
def test_each_usual_part_of_a_jacobian_is_known_as_it(judge: Judge, rows: list[str], part: str) -> None:
    right, turned = (
        judge(r"B = \begin{bmatrix} " + r" \\ ".join(lines) + r" \end{bmatrix}", arm="planar_2r")
        for lines in (rows, [rows[0].replace("& -l_2", "& l_2"), *rows[1:]])
    )
    assert right.outcomes[0].read_as == f"{part}the Jacobian of frame 2 in frame 0"
    assert turned.verdict is Verdict.UNCHECKED and not turned.outcomes[0].read_as


@pytest.mark.parametrize(
    ("display", "where", "line"),
    [
        (f"Q = {POINT % '-'}", "(2, 1)", '{"Q": {origin: 2}}'),
        (r"G = \begin{bmatrix} c_{12} & s_{12} & 0 \\ s_{12} & c_{12} & 0 \\ 0 & 0 & 1 \end{bmatrix}", "(1, 2)", '{"G": {rotation: 2}}'),
        (r"B = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & -l_2 c_{12} \end{bmatrix}", "(2, 2)", '{"B": {jacobian: 2, rows: [1, 2]}}'),
    ],
)  # fmt: skip
def test_a_value_near_a_quantity_is_not_decided(judge: Judge, display: str, where: str, line: str) -> None:
    record = judge(display, arm="planar_2r")
    assert record.verdict is Verdict.UNCHECKED
    assert f"but for entry {where}" in record.message and line in record.message
    left, _, value = display.partition(" = ")
    used = judge(display, f"3 {left} = 3 {value}", arm="planar_2r")
    assert used.verdict is Verdict.UNCHECKED and f"but for entry {where}" in used.message


@pytest.mark.parametrize(
    ("value", "says"),
    [
        (r"l_1 c_1 + l_2 c_{12}", ""),
        (r"l_1 c_1 - l_2 c_{12}", '{"k": {origin: 2, component: x}}'),
        (r"l_1 s_1 + l_2 c_{12}", '{"k": {origin: 2, component: x}}'),
        (r"l_1 + l_2 c_2", ""),
        (r"l_2 c_{12}", ""),
        (r"l_1^2 + l_2^2 + 2 l_1 l_2 c_2", ""),
    ],
)
def test_a_scalar_near_a_coordinate_is_not_decided(judge: Judge, value: str, says: str) -> None:
    record, used = judge(f"k = {value}", arm="planar_2r"), judge(f"k = {value}", f"2 k = 2 ({value})", arm="planar_2r")
    assert used.verdict is (Verdict.UNCHECKED if says else Verdict.PROVED)
    assert says in record.message and ("but for a term" in record.message) == bool(says)


@pytest.mark.parametrize(
    "display",
    [
        r"Q = \begin{bmatrix} l_1 & 0 \\ 0 & l_2 \end{bmatrix}",
        r"Q = \begin{bmatrix} s_1 \\ c_2 \\ 0 \end{bmatrix}",
        r"Q = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}",
        r"Q = J_v^T J_v",
        r"Q = l_1 c_1 + l_2 c_{12}",
    ],
)
def test_other_values_are_the_documents_own(judge: Judge, display: str) -> None:
    assert "but for entry" not in judge(display, arm="planar_2r").message


@pytest.mark.parametrize("left", ["p_2(q)", r"{}^0p_2(\theta_1, \theta_2)", "p_2"])
def test_a_name_with_its_arguments_is_read_as_the_name(judge: Judge, left: str) -> None:
    record = judge(f"{left} = {POINT % '+'}", arm="planar_2r")
    assert record.verdict is Verdict.PROVED and record.outcomes[0].read_as == "origin of frame 2 in frame 0"


def test_a_value_of_several_frames_is_to_be_bound(judge: Judge) -> None:
    turned = r"\begin{bmatrix} c_{12} & s_{12} & 0 \\ s_{12} & -c_{12} & 0 \\ 0 & 0 & -1 \end{bmatrix}"
    for display in (f"G = {turned}", f"G = {turned} = {turned}"):
        record = judge(display, arm="scara")
        assert record.verdict is Verdict.UNCHECKED
        assert "rotation of frame 2 in frame 0, rotation of frame 3 in frame 0: bind G" in record.message
