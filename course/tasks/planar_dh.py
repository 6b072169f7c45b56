"""Tasks of the warm-up: the frames and the table of the planar 2R arm, its tool from the table, and an arm with a ram."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.course.feedback import Derivation, Lesson, Line, Quantity, Scheme, Task, WithSympy, Wrong
from armproof.course.tasks.own_frames import ORIGINS, TABLE, X, Z, step

ARM = Scheme("planar_2r", {"A": (0, 0, 0), "B": ("l_1", 0, 0), "C": ("l_1 + l_2", 0, 0)})
# A turntable with a ram along y, which ends l beyond the axis at d_2 = 0.
RAM = Scheme(
    {
        "dh": "modified",
        "rows": [
            {"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"},
            {"alpha": "-pi/2", "a": 0, "d": "d_2", "theta": 0},
            {"alpha": 0, "a": 0, "d": "l", "theta": 0},
        ],
        "joints": ["theta_1", "d_2"],
    },
    {"A": (0, 0, 0), "B": (0, "l", 0)},
)
_USUAL: dict[str, Any] = {
    "z": ["z", "z"],
    "O": ["A", "B"],
    "x": ["AB", "BC"],
    "table": [(0, 0, 0, "theta_1"), (0, "l_1", 0, "theta_2")],
}
_DOWN: dict[str, Any] = {
    "z": ["z", "-z"],
    "O": ["A", "B"],
    "x": ["AB", "BC"],
    "table": [(0, 0, 0, "theta_1"), ("pi", "l_1", 0, "theta_2")],
}
_RAM: dict[str, Any] = {
    "z": ["z", "y"],
    "O": ["A", "A"],
    "x": ["x", "x"],
    "table": [(0, 0, 0, "theta_1"), ("-pi/2", 0, "d_2", 0)],
}
_RAM_OTHER: dict[str, Any] = {
    "z": ["z", "-y"],
    "O": ["A", "B"],
    "x": ["x", "x"],
    "table": [(0, 0, 0, "theta_1"), ("pi/2", 0, "d_2", 0)],
}


def tool(q, l_1, l_2):
    """Return the tool's position: each bar adds its length in its own direction."""
    both = q[0] + q[1]
    return np.array([l_1 * np.cos(q[0]) + l_2 * np.cos(both), l_1 * np.sin(q[0]) + l_2 * np.sin(both), 0])


TOOL = r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}"


def _tool_sympy(sp):
    t1, t2, l1, l2 = sp.symbols("theta_1 theta_2 l_1 l_2")
    return sp.Matrix([l1 * sp.cos(t1) + l2 * sp.cos(t1 + t2), l1 * sp.sin(t1) + l2 * sp.sin(t1 + t2), 0])


_ROWS = _USUAL["table"]
LESSON = Lesson(
    number=2,
    name="planar_dh",
    title="A warm-up: frames and table of the planar 2R arm",
    source="After MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Place two frames on a drawing, one step at a time.",
        "Fill in a table of two rows, and find the tool with it.",
        "Do the same for an arm with a ram.",
    ),
    tasks=(
        step("z_axes", Z, ARM, _USUAL, (_USUAL["z"], ("z", "-z"), [[0, 0, 1], [0, 0, -1]]),
            Wrong(["x", "x"], "both bars turn in the plane: their axes stand on it, along z", own=True),
            Wrong(["y", "z"], "z_1 does not point along the axis about which joint 1 turns"),
            Wrong(["z", "x"], "z_2 does not point along the axis about which joint 2 turns"),
            Wrong([[1, 0, 1], "z"], "z is inclined: the axis stands on the plane", own=True),
        ),
        step("origins", ORIGINS, ARM, _USUAL, (_USUAL["O"], ("A", ["l_1", 0, 0.2]), [[0, 0, 0], "B"]),
            Wrong(["B", "C"], "O_1 is on the axis of joint 2: it belongs on z_1"),
            Wrong(["A", "C"], "O_2 is not on the axis of joint 2"),
            Wrong(["C", "B"], "O_1 is not on the axis of joint 1"),
            Wrong(["A", ["l_1/2", 0, 0]], "the middle of a bar is on no axis: O_2 lies on the axis of joint 2", own=True),
        ),
        step("x_axes", X, ARM, _USUAL, ([_USUAL["O"], _USUAL["x"]], {"O": ["A", "B"], "x": ["x", "-y"]}, (["A", "B"], ["AB", [1, 1, 0]])),
            Wrong([["A", "B"], ["-x", "x"]], "x_1 points from axis 2 back to axis 1"),
            Wrong([["A", "B"], ["y", "x"]], "axes 1 and 2 are parallel: x_1 leads from one to the other"),
            Wrong([["A", "B"], ["z", "x"]], "x_1 is not at right angles to z_1"),
            Wrong([["A", "B"], ["x", "z"]], "x_2 is not at right angles to z_2"),
            Wrong([["B", "C"], ["x", "x"]], "O_1 is on the axis of joint 2"),
        ),
        step("table", TABLE, ARM, _USUAL, (_USUAL, list(_DOWN.values()), tuple(_USUAL.values())),
            Wrong({**_USUAL, "table": [(0, "l_1", 0, "theta_1"), (0, "l_2", 0, "theta_2")]},
                "the lengths stand one row too early: a row holds that of the link before", own=True),
            Wrong({**_USUAL, "table": [_ROWS[0], (0, 0, "l_1", "theta_2")]}, "row 2: a and d are exchanged"),
            Wrong({**_DOWN, "table": _ROWS}, "row 2: alpha is wrong for the frames that you placed"),
            Wrong({**_USUAL, "table": [_ROWS[0], (0, "l_1", 0, "theta_1 + theta_2")]}, "each joint has its own angle: θ_2 is counted from the first bar", own=True),
            Wrong({**_USUAL, "table": [*_ROWS, (0, "l_2", 0, 0)]}, "2 rows"),
        ),
        Task(
            name="tool",
            title="The tool from the table",
            text="The tool $C$ lies at $[l_2, 0, 0]^T$ in frame 2. Write it in frame 0 (3 rows, m). A function takes `q` and the lengths `l_1, l_2`.",
            asks=Quantity("planar_2r", {"origin": 2}),
            hints=(
                "Each row of the table is one link matrix: ${}^0T_1\\,{}^1T_2\\,[l_2, 0, 0, 1]^T$.",
                "The second bar points along $[C_{12}, S_{12}, 0]^T$: both joints turn it.",
            ),
            derivation=Derivation(
                (
                    Line("Row 2: a move by $l_1$ along $x_1$, then a turn.", r"\begin{bmatrix} 1 & 0 & 0 & l_1 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \begin{bmatrix} C_2 & -S_2 & 0 & 0 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} = \begin{bmatrix} C_2 & -S_2 & 0 & l_1 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"),
                    Line("It takes the tool into frame 1.", r"\begin{bmatrix} C_2 & -S_2 & 0 & l_1 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \begin{bmatrix} l_2 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} l_1 + l_2 C_2 \\ l_2 S_2 \\ 0 \\ 1 \end{bmatrix}"),
                    Line("Row 1 only turns: it takes this into frame 0.", r"\begin{bmatrix} C_1 & -S_1 & 0 & 0 \\ S_1 & C_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \begin{bmatrix} l_1 + l_2 C_2 \\ l_2 S_2 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} l_1 C_1 + l_2 (C_1 C_2 - S_1 S_2) \\ l_1 S_1 + l_2 (S_1 C_2 + C_1 S_2) \\ 0 \\ 1 \end{bmatrix}"),
                    Line("The parentheses are the cosine and the sine of the sum.", r"p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}"),
                ),
                {"arm": "planar_2r"},
            ),
            right=(tool, TOOL, WithSympy(_tool_sympy)),
            wrong=(
                Wrong(lambda q, l_1, l_2: tool([q[0], q[1] - q[0]], l_1, l_2), "absolute"),
                Wrong(lambda q, l_1, l_2: tool(q, l_2, l_1), "swapped"),
                Wrong(lambda q, l_1, l_2: tool(np.deg2rad(q), l_1, l_2), "degrees"),
                Wrong(TOOL.replace("+ l_2 C_{12}", "- l_2 C_{12}"), "sign"),
                Wrong(lambda q, l_1, l_2: tool(q, l_1, 0), "the second bar is missing: this is the elbow", own=True),
            ),
        ),
        step("transfer", TABLE, RAM, _RAM, (_RAM, list(_RAM_OTHER.values()), tuple(_RAM.values())),
            Wrong({**_RAM, "z": ["z", "x"]}, "z_2 does not point along the slide of joint 2"),
            Wrong({**_RAM, "x": ["y", "x"]}, "x_1 is at right angles to z_1 but not to z_2"),
            Wrong({**_RAM, "table": [_ROWS[0], ("pi/2", 0, "d_2", 0)]}, "row 2: alpha has the wrong sign for your axes"),
            Wrong({**_RAM, "table": [_ROWS[0], ("-pi/2", "d_2", 0, 0)]}, "row 2: a and d are exchanged"),
            Wrong({**_RAM, "table": [_ROWS[0], ("-pi/2", 0, 0, "d_2")]}, "the ram slides: its variable is an offset, in the column of d", own=True),
        ),
    ),
)  # fmt: skip
