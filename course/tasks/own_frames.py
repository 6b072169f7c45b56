"""Tasks of the lesson on frames of one's own: z, O and x chosen on a drawing, step by step, and the table that follows."""

from __future__ import annotations

from typing import Any

from armproof.course.feedback import Lesson, Placement, Scheme, Task, Wrong, picked

SCARA = Scheme("scara", {"A": (0, 0, 0), "B": ("a_1", 0, 0), "C": ("a_1 + a_2", 0, 0), "D": ("a_1 + a_2", 0, "-d_4")})
RX90 = Scheme("rx90", {"A": (0, 0, 0), "B": ("a_3", 0, 0), "C": ("a_3", 0, "d_3")})
Z, ORIGINS, X, TABLE = "z", "O", "x", "table"
_DIRECTION = '`"x"`, `"-x"`, `"y"`, `"-y"`, `"z"`, `"-z"`, or three numbers such as `[0, 0, -1]`'
_TEXTS = {
    Z: f"Give the directions of $z_i$, one a joint. A direction is one of the drawing's, {_DIRECTION}.",
    ORIGINS: 'Give the origins $O_i$, one a joint. A point is a letter of the drawing, or three coordinates such as `["a_1", 0, 0.1]`.',
    X: "Give the directions of $x_i$, one a joint: a direction of the drawing, or two letters, `\"AB\"` from one point to another."
    " The answer holds your origins and your x axes.",
    TABLE: "Give the rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$ that follow from your own frames. The answer holds z, O, x and the rows.",
}  # fmt: skip
_HINTS = {
    Z: (
        "Whatever the joint moves turns about $z_i$, or slides along it.",
        "$z_i$ lies along the axis of joint $i$, which has the number $i$ on the drawing. Both senses are right.",
    ),
    ORIGINS: (
        "Look at the axes $i$ and $i+1$: do they intersect, are they parallel, or neither?",
        "Intersecting: their common point. Parallel, or behind the last joint: any point on axis $i$. A slide's axis may lie anywhere.",
    ),
    X: (
        "$x_i$ lies along the common normal of the axes $i$ and $i+1$.",
        "Parallel: from axis $i$ to axis $i+1$. Intersecting: at right angles to both, in either sense. The last one: across $z_n$.",
    ),
    TABLE: (
        "Read each row off your own axes: $\\alpha$ and $a$ about and along $x_{i-1}$, $\\theta$ and $d$ about and along $z_i$.",
        "Frame 0 lies on frame 1: the first row has zeros and the first variable. A sense that you turned changes signs.",
    ),
}  # fmt: skip
_TITLES = {Z: "The z axes", ORIGINS: "The origins", X: "The x axes", TABLE: "The table of your frames"}


def step(name: str, what: str, scheme: Scheme, usual: dict[str, Any], right: tuple[Any, ...], *wrong: Wrong) -> Task:
    """Return the task of one step on one arm."""
    frames = {key: usual[key] for key in (Z, ORIGINS, X)}
    return Task(name, _TITLES[what], _TEXTS[what], Placement(scheme, what, frames), _HINTS[what], right, wrong)


def _with(usual: dict[str, Any], **changed: Any) -> dict[str, Any]:
    return {**usual, **changed}


# -- the SCARA ---------------------------------------------------------------------------------------------------------

_SCARA: dict[str, Any] = {
    "z": ["z", "z", "z", "z"],
    "O": ["A", "B", "C", "C"],
    "x": ["AB", "BC", "x", "x"],
    "table": [(0, 0, 0, "theta_1"), (0, "a_1", 0, "theta_2"), (0, "a_2", "d_3", 0), (0, 0, 0, "theta_4")],
}
_SCARA_DOWN: dict[str, Any] = {
    "z": ["z", "z", "-z", "-z"],
    "O": ["A", "B", "C", "D"],
    "x": ["AB", "BC", "y", "y"],
    "table": [(0, 0, 0, "theta_1"), (0, "a_1", 0, "theta_2"), ("pi", "a_2", "d_3", "-pi/2"), (0, 0, "d_4", "theta_4")],
}


def _scara() -> tuple[Task, ...]:
    rows = _SCARA["table"]
    return (
        step("scara_z", Z, SCARA, _SCARA, (_SCARA["z"], tuple(_SCARA_DOWN["z"]), [[0, 0, 2]] * 4),
            Wrong(["x", "z", "z", "z"], "z_1 does not point along the axis about which joint 1 turns"),
            Wrong(["z", "x", "z", "z"], "joint 2 turns"),
            Wrong(["z", "z", "x", "z"], "along the slide of joint 3"),
            Wrong(["z", "z", "z", "y"], "joint 4 turns"),
            Wrong(["AB", "BC", "z", "z"], "the links are what x lies along: z lies along the axes of the joints", own=True),
        ),
        step("scara_origins", ORIGINS, SCARA, _SCARA, (_SCARA["O"], ("A", "B", "C", "D"), [[0, 0, 0.2], "B", "B", "C"]),
            Wrong(["B", "C", "C", "D"], "O_1 is on the axis of joint 2: it belongs on z_1"),
            Wrong(["A", "C", "C", "C"], "O_2 is on the axis of joint 3"),
            Wrong(["A", "A", "C", "C"], "O_2 is not on the axis of joint 2"),
            Wrong(["A", "B", "C", "B"], "O_4 is not on the axis of joint 4"),
            Wrong(["A", ["a_1/2", 0, 0], "C", "C"], "the middle of a link is on no axis: O_2 lies on the axis of joint 2", own=True),
        ),
        step("scara_x", X, SCARA, _SCARA,
            ({"O": _SCARA["O"], "x": _SCARA["x"]}, [_SCARA_DOWN["O"], _SCARA_DOWN["x"]], (["A", "B", "C", "C"], ["x", "x", "-y", [1, 1, 0]])),
            Wrong([_SCARA["O"], ["-x", "x", "x", "x"]], "x_1 points from axis 2 back to axis 1"),
            Wrong([_SCARA["O"], ["x", "y", "x", "x"]], "axes 2 and 3 are parallel: x_2 leads from one to the other"),
            Wrong([_SCARA["O"], ["x", "x", "z", "x"]], "x_3 is not at right angles to z_3"),
            Wrong([["A", "C", "C", "C"], _SCARA["x"]], "O_2 is on the axis of joint 3"),
            Wrong([_SCARA["O"], ["z", "x", "x", "x"]], "x_1 is not at right angles to z_1"),
        ),
        step("scara_table", TABLE, SCARA, _SCARA, (_SCARA, list(_SCARA_DOWN.values()), tuple(_SCARA.values())),
            Wrong(_with(_SCARA, table=[(0, "a_1", 0, "theta_1"), (0, "a_2", 0, "theta_2"), (0, 0, "d_3", 0), (0, 0, 0, "theta_4")]),
                "the lengths stand one row too early: a row holds that of the link before", own=True),
            Wrong(_with(_SCARA, table=[*rows[:2], (0, "d_3", "a_2", 0), rows[3]]), "row 3: a and d are exchanged"),
            Wrong(_with(_SCARA_DOWN, table=[*_SCARA_DOWN["table"][:2], (0, "a_2", "d_3", "-pi/2"), _SCARA_DOWN["table"][3]]),
                "row 3: alpha is wrong for the frames that you placed"),
            Wrong(_with(_SCARA_DOWN, table=[*_SCARA_DOWN["table"][:2], ("pi", "a_2", "d_3", "pi/2"), _SCARA_DOWN["table"][3]]),
                "row 3: theta is wrong"),
            Wrong(_with(_SCARA_DOWN, table=[*_SCARA_DOWN["table"][:3], (0, 0, 0, "theta_4")]), "row 4: d is wrong"),
            Wrong(_with(_SCARA, table=rows[:3]), "4 rows"),
        ),
    )  # fmt: skip


# -- the RX-90 ---------------------------------------------------------------------------------------------------------

_RX90: dict[str, Any] = {
    "z": ["z", "-y", "-y", "z", "-y", "z"],
    "O": ["A", "A", "B", "C", "C", "C"],
    "x": ["x", "AB", "x", "x", "x", "x"],
    "table": [
        (0, 0, 0, "theta_1"), ("pi/2", 0, 0, "theta_2"), (0, "a_3", 0, "theta_3"),
        ("-pi/2", 0, "d_3", "theta_4"), ("pi/2", 0, 0, "theta_5"), ("-pi/2", 0, 0, "theta_6"),
    ],
}  # fmt: skip
_RX90_OTHER: dict[str, Any] = {
    "z": ["z", "y", "y", "z", "y", "z"],
    "O": ["A", "A", "B", "C", "C", "C"],
    "x": ["-x", "x", "x", "x", "x", "x"],
    "table": [
        (0, 0, 0, "theta_1"), ("pi/2", 0, 0, "theta_2"), (0, "a_3", 0, "theta_3"),
        ("pi/2", 0, "d_3", "theta_4"), ("-pi/2", 0, 0, "theta_5"), ("pi/2", 0, 0, "theta_6"),
    ],
}  # fmt: skip


def _rx90() -> tuple[Task, ...]:
    rows, origins, x = _RX90["table"], _RX90["O"], _RX90["x"]
    return (
        step("rx90_z", Z, RX90, _RX90, (_RX90["z"], tuple(_RX90_OTHER["z"]), [[0, 0, 1], [0, 1, 0], "y", "-z", "-y", "CB"]),
            Wrong(["-y", "-y", "z", "-y", "z", "z"], "z_1 lies along the axis of joint 2, as in the classic convention"),
            Wrong(["z", "x", "-y", "z", "-y", "z"], "z_2 does not point along the axis about which joint 2 turns"),
            Wrong(["z", "-y", "x", "z", "-y", "z"], "joint 3 turns"),
            Wrong(["z", "-y", "-y", "-y", "z", "z"], "z_4 lies along the axis of joint 5"),
            Wrong(["z", "-y", "-y", "z", "x", "z"], "joint 5 turns"),
        ),
        step("rx90_origins", ORIGINS, RX90, _RX90, (origins, ("A", ["0", 0.2, 0], "B", "C", "C", ["a_3", 0, "d_3 + 0.1"]), ["A", "A", ["a_3", 0, 0], "C", "C", "C"]),
            Wrong([[0, 0, 0.2], "A", "B", "C", "C", "C"], "axes 1 and 2 intersect: O_1 is the point that they have in common"),
            Wrong(["A", "B", "B", "C", "C", "C"], "O_2 is on the axis of joint 3"),
            Wrong(["A", "A", ["a_3", 0.2, 0], "C", "C", "C"], "axes 3 and 4 intersect"),
            Wrong(["A", "A", "B", "B", "C", "C"], "axes 4 and 5 intersect: O_4"),
            Wrong(["A", "A", "C", "C", "C", "C"], "O_3 is on the axis of joint 4"),
        ),
        step("rx90_x", X, RX90, _RX90,
            ({"O": origins, "x": x}, [origins, _RX90_OTHER["x"]], (origins, ["-x", "x", "-x", "x", "-x", "y"])),
            Wrong([origins, ["y", "x", "x", "x", "x", "x"]], "x_1 is at right angles to z_1 but not to z_2"),
            Wrong([origins, ["x", "-x", "x", "x", "x", "x"]], "x_2 points from axis 3 back to axis 2"),
            Wrong([origins, ["x", "z", "x", "x", "x", "x"]], "axes 2 and 3 are parallel"),
            Wrong([origins, ["x", "x", "BC", "x", "x", "x"]], "x_3 is at right angles to z_3 but not to z_4"),
            Wrong([origins, ["x", "x", "x", "z", "x", "x"]], "x_4 is not at right angles to z_4"),
        ),
        step("rx90_table", TABLE, RX90, _RX90, (_RX90, list(_RX90_OTHER.values()), tuple(_RX90.values())),
            Wrong(_with(_RX90, table=_RX90_OTHER["table"]), "row 4: alpha has the wrong sign for your axes"),
            Wrong(_with(_RX90, table=[*rows[:2], (0, 0, "a_3", "theta_3"), *rows[3:]]), "row 3: a and d are exchanged"),
            Wrong(_with(_RX90, table=[*rows[:4], ("pi/2", 0, "d_3", "theta_5"), rows[5]]), "row 5: d is wrong"),
            Wrong(_with(_RX90, x=["x", "AB", "x", "x", "x", "y"], table=[*rows[:5], ("-pi/2", 0, 0, "theta_6 - pi/2")]), "row 6: theta is wrong"),
            Wrong(_with(_RX90, table=[(0, "a_3", 0, "theta_1"), *rows[1:]]), "row 1: a is wrong"),
        ),
    )  # fmt: skip


# -- an arm that nobody has seen ---------------------------------------------------------------------------------------

# A column, a shoulder across it at the distance b, beside it by c or not, and a ram across the shoulder: eight arms of one family.
FAMILY: list[tuple[int, int, Any]] = [
    (first, second, beside) for first in (-1, 1) for second in (1, -1) for beside in (0, "c")
]


def _angle(sign: int) -> str:
    return "pi/2" if sign > 0 else "-pi/2"


def _transfer(first: int = -1, second: int = 1, beside: Any = 0) -> Task:
    """Return the task on an arm of the family: its twists are right angles of these signs."""
    side, twists = ("b" if first < 0 else "-b"), (_angle(first), _angle(second))
    rows: list[Any] = [(0, 0, 0, "theta_1"), (twists[0], beside, "b", "theta_2"), (twists[1], 0, "d_3", 0)]
    spec = {"dh": "modified", "rows": [dict(zip(("alpha", "a", "d", "theta"), row, strict=True)) for row in rows]}
    points: dict[str, tuple[Any, ...]] = {"A": (0, 0, 0), "B": (0, side, 0)}
    if beside:
        points = {"A": (0, 0, 0), "B": (beside, 0, 0), "C": (beside, side, 0)}
    *_, foot, last = points
    across, up = ("y" if first < 0 else "-y"), ("z" if first != second else "-z")
    usual = {"z": ["z", across, up], "O": ["A", last, last], "x": ["x", "x", "x"], "table": rows}
    turned = [rows[0], (_angle(-first), beside, "-b", "theta_2"), (_angle(-second), 0, "d_3", 0)]
    other = _with(usual, z=["z", "-y" if across == "y" else "y", up], table=turned)
    task = step("transfer", TABLE, Scheme(spec, points), usual, (usual, list(other.values()), tuple(usual.values())),
        Wrong(_with(usual, O=["A", foot, last]), "axes 2 and 3 intersect: O_2"),
        Wrong(_with(usual, z=[across, across, up]), "z_1 lies along the axis of joint 2"),
        Wrong(_with(usual, x=["y", "x", "x"]), "x_1 is at right angles to z_1 but not to z_2"),
        Wrong(_with(usual, table=[rows[0], (twists[0], "b", beside, "theta_2"), rows[2]]), "row 2: a and d are exchanged"),
        Wrong(_with(usual, table=[rows[0], (_angle(-first), *rows[1][1:]), rows[2]]), "row 2: alpha has the wrong sign"),
    )  # fmt: skip
    task.own = _own_transfer
    return task


def _own_transfer(seed: str) -> Task:
    return _transfer(*picked(f"{seed}/own_frames", FAMILY))


LESSON = Lesson(
    number=5,
    name="own_frames",
    title="Frames of your own",
    source="MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Choose the z axes, the origins and the x axes of an arm on a drawing, each step checked by itself.",
        "Tell what is free at each step, and what is not.",
        "Write the table of your own frames, and see it beside the usual one.",
    ),
    tasks=(*_scara(), *_rx90(), _transfer()),
)
