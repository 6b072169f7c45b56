"""Tasks of lesson 8, from a URDF offset table to a Denavit–Hartenberg table: the KUKA KR210 (document 001)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import (
    Choice,
    Derivation,
    Formula,
    Lesson,
    Line,
    Number,
    Quantity,
    Table,
    Task,
    WithSympy,
    Wrong,
)
from armproof.course.links import classic_link, product, shift, turn

DH = {  # the arm by its modified table; frame 6 sits in the wrist's centre
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "d_1 + d_2", "theta": "theta_1"},
        {"alpha": "-pi/2", "a": "a_1", "d": 0, "theta": "theta_2 - pi/2"},
        {"alpha": 0, "a": "a_2", "d": 0, "theta": "theta_3"},
        {"alpha": "-pi/2", "a": "-a_3", "d": "d_4 + d_5", "theta": "theta_4"},
        {"alpha": "pi/2", "a": 0, "d": 0, "theta": "theta_5"},
        {"alpha": "-pi/2", "a": 0, "d": 0, "theta": "theta_6"},
    ],
}
LENGTHS = {
    "a_1": 0.35,
    "a_2": 1.25,
    "a_3": 0.054,
    "d_1": 0.33,
    "d_2": 0.42,
    "d_4": 0.96,
    "d_5": 0.54,
    "d_6": 0.193,
    "d_G": 0.11,
}  # m


def table():
    """Return the rows (α_{i-1}, a_{i-1}, d_i, θ_i)."""
    return [
        (0, 0, "d_1 + d_2", "theta_1"),
        ("-pi/2", "a_1", 0, "theta_2 - pi/2"),
        (0, "a_2", 0, "theta_3"),
        ("-pi/2", "-a_3", "d_4 + d_5", "theta_4"),
        ("pi/2", 0, 0, "theta_5"),
        ("-pi/2", 0, 0, "theta_6"),
    ]


def urdf_link(q, a_1, d_2):
    """Return ¹T_2 of the URDF: the offset first, then the rotation about y."""
    c, s = np.cos(q[1]), np.sin(q[1])
    return np.array([[c, 0, s, a_1], [0, 1, 0, 0], [-s, 0, c, d_2], [0, 0, 0, 1]])


def dh_link(q, a_1):
    """Return ¹T_2 of the table: α = −π/2, a = a_1, d = 0, θ = θ_2 − π/2."""
    c, s = np.cos(q[1] - np.pi / 2), np.sin(q[1] - np.pi / 2)
    return np.array([[c, -s, 0, a_1], [0, 0, 1, 0], [-s, -c, 0, 0], [0, 0, 0, 1]])


def tool(d_6, d_G):
    """Return ⁶T_G: along z_6 to the gripper, x_G along z_6, y_G against y_6."""
    return np.array([[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, d_6 + d_G], [0, 0, 0, 1]])


def pose(q, d_1, d_2, a_1, a_2, a_3, d_4, d_5, d_6, d_G):
    """Return ⁰T_G, the product of the six link matrices of the table and of the tool's."""
    X = np.eye(4)
    for alpha, a, d, theta in (
        (0, 0, d_1 + d_2, q[0]),
        (-np.pi / 2, a_1, 0, q[1] - np.pi / 2),
        (0, a_2, 0, q[2]),
        (-np.pi / 2, -a_3, d_4 + d_5, q[3]),
        (np.pi / 2, 0, 0, q[4]),
        (-np.pi / 2, 0, 0, q[5]),
    ):
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        X = X @ np.array([[c, -s, 0, a], [s * ca, c * ca, -sa, -d * sa], [s * sa, c * sa, ca, d * ca], [0, 0, 0, 1]])
    return X @ np.array([[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, d_6 + d_G], [0, 0, 0, 1]])


def _rows(q, offset=-np.pi / 2, sign=-1):
    """Return the table (a, α, d, θ) in the arm's numbers, with an offset of θ_2 and a sign of a_3 of one's own."""
    right = np.pi / 2
    return [(0, 0, 0.75, q[0]), (0.35, -right, 0, q[1] + offset), (1.25, 0, 0, q[2]), (sign * 0.054, -right, 1.5, q[3]),
            (0, right, 0, q[4]), (0, -right, 0, q[5])]  # fmt: skip


_TOOL = np.array([[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, 0.303], [0, 0, 0, 1]])


def _in_numbers(q):
    return product(_rows(q)) @ _TOOL


def _no_offset(q):
    return product(_rows(q, offset=0)) @ _TOOL


def _forearm_up(q):
    return product(_rows(q, sign=1)) @ _TOOL


def _no_tool_rotation(q):
    return product(_rows(q)) @ np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.303], [0, 0, 0, 1]])


def _no_tool(q):
    return product(_rows(q))


def _no_gripper(q):
    return product(_rows(q)) @ np.array([[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, 0.193], [0, 0, 0, 1]])


def _classic_matrices(q):
    return product(_rows(q), classic_link) @ _TOOL


def _dh_link_without_offset(q, a_1):
    c, s = np.cos(q[1]), np.sin(q[1])
    return np.array([[c, -s, 0, a_1], [0, 0, 1, 0], [-s, -c, 0, 0], [0, 0, 0, 1]])


def _turn(axis, symbol, x, z):
    """Return the LaTeX of an offset (x, 0, z) and a rotation about an axis."""
    c, s = rf"\cos\theta_{symbol}", rf"\sin\theta_{symbol}"
    rows = {
        "x": f"1 & 0 & 0 & {x} \\\\ 0 & {c} & -{s} & 0 \\\\ 0 & {s} & {c} & {z}",
        "y": f"{c} & 0 & {s} & {x} \\\\ 0 & 1 & 0 & 0 \\\\ -{s} & 0 & {c} & {z}",
        "z": f"{c} & -{s} & 0 & {x} \\\\ {s} & {c} & 0 & 0 \\\\ 0 & 0 & 1 & {z}",
    }[axis]
    return rf"\begin{{bmatrix}} {rows} \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"


URDF_LINK = _turn("y", 2, "a_1", "d_2")
DH_LINK = r"\begin{bmatrix} S_2 & C_2 & 0 & a_1 \\ 0 & 0 & 1 & 0 \\ C_2 & -S_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
TOOL = r"\begin{bmatrix} 0 & 0 & 1 & 0 \\ 0 & -1 & 0 & 0 \\ 1 & 0 & 0 & d_6 + d_G \\ 0 & 0 & 0 & 1 \end{bmatrix}"
POSE = " ".join(
    [
        _turn("z", 1, "0", "d_1"), _turn("y", 2, "a_1", "d_2"), _turn("y", 3, "0", "a_2"), _turn("x", 4, "d_4", "-a_3"),
        _turn("y", 5, "d_5", "0"), _turn("x", 6, "d_6", "0"),
        r"\begin{bmatrix} 1 & 0 & 0 & d_G \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    ]
)  # fmt: skip
TABLE = r"""\begin{array}{cccc} 0 & 0 & d_1 + d_2 & \theta_1 \\ -\pi/2 & a_1 & 0 & \theta_2 - \pi/2 \\ 0 & a_2 & 0 & \theta_3 \\
-\pi/2 & -a_3 & d_4 + d_5 & \theta_4 \\ \pi/2 & 0 & 0 & \theta_5 \\ -\pi/2 & 0 & 0 & \theta_6 \end{array}"""


def _changed(number, *row):
    """Return the table with another row (from 1)."""
    rows = table()
    rows[number - 1] = row
    return rows


def _modified_link_sympy(sp):
    """Return Rot(x, −π/2) Trans(x, a_1) Rot(z, θ_2 − π/2)."""
    return turn(sp, "x", -sp.pi / 2) * shift(sp, x=sp.Symbol("a_1")) * turn(sp, "z", sp.Symbol("theta_2") - sp.pi / 2)


def _urdf_link_sympy(sp):
    t, a1, d2 = sp.symbols("theta_2 a_1 d_2")
    return shift(sp, x=a1, z=d2) * turn(sp, "y", t)


# A gantry in the manner of a URDF: a mast about z, a shoulder about x beside it, a quill along z.
GANTRY = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "h", "theta": "theta_1 + pi/2"},
        {"alpha": "pi/2", "a": "e", "d": 0, "theta": "theta_2"},
        {"alpha": "-pi/2", "a": 0, "d": "d_3 + b", "theta": 0},
    ],
}
GANTRY_ROWS = [(0, 0, "h", "theta_1 + pi/2"), ("pi/2", "e", 0, "theta_2"), ("-pi/2", 0, "d_3 + b", 0)]


LESSON = Lesson(
    number=8,
    name="kr210_table",
    title="From a URDF offset table to DH: the KUKA KR210",
    source="MECA 953 Robotique, MMT5, 2022, table of joint offsets (document 001)",
    objectives=(
        "Read a URDF's table of joint offsets: which transform is a row?",
        "Choose modified Denavit–Hartenberg frames on the same axes and write their table.",
        "Tie both descriptions together with a constant transform, and prove that they are one arm.",
    ),
    tasks=(
        Task(
            name="prediction",
            title="Predict the zero pose",
            text="All joint angles are zero, so all frames of the URDF are parallel. Where is the gripper? Give $[P_x, P_y, P_z]$ in frame 0, in metres, from "
            "the table of offsets.",
            asks=Number(
                (2.153, 0, 1.946),
                "m",
                ("P_x", "P_y", "P_z"),
                LENGTHS,
                steps=("a_1 + d_4 + d_5 + d_6 + d_G", "", "d_1 + d_2 + a_2 - a_3"),
            ),
            hints=(
                "Parallel frames: the offsets simply add up.",
                "Add the column x over all seven rows, then the column z. Mind one sign.",
                "$P_x = 0.35 + 0.96 + 0.54 + 0.193 + 0.11$ and $P_z = 0.33 + 0.42 + 1.25 - 0.054$.",
            ),
            right=(
                [2.153, 0, 1.946],
                "2.153, 0, 1.946",
                np.array([0.35 + 0.96 + 0.54 + 0.193 + 0.11, 0, 0.33 + 0.42 + 1.25 - 0.054]),
            ),
            wrong=(
                Wrong([2.153, 0, 2.054], "joint 4 lies below the elbow: its z offset counts negative", own=True),
                Wrong([2.043, 0, 1.946], "that is frame 6: the last row takes you on to the gripper", own=True),
                Wrong(
                    [1.803, 0, 1.946],
                    "the shoulder stands in front of the first axis: row 2 has an x offset as well",
                    own=True,
                ),
                Wrong([1.946, 0, 2.153], "x and z are swapped", own=True),
                Wrong([2.153, 0, 2.0], "row 4 has a z offset as well", own=True),
            ),
        ),
        Task(
            name="urdf_link",
            title="A row of the URDF",
            text="Write ${}^1T_2$ between the URDF's frames 1 and 2, 4×4: offset $(a_1, 0, d_2)$, joint axis $y$. Letters: $\\theta_2, a_1, d_2$. A function takes "
            "the joint vector `q` (six angles) and, by their names, the lengths that it needs.",
            asks=Quantity("kr210", {"pose": 2, "in": 1}),
            hints=(
                "The offset says where the joint sits on the link before it, so it does not depend on the joint's angle.",
                "Translate first, then rotate: $\\mathrm{Trans}(a_1, 0, d_2)\\,\\mathrm{Rot}(y, \\theta_2)$.",
                "$\\mathrm{Rot}(y, \\theta)$ has $S$ in its upper right corner and $-S$ in its lower left one; the offset is the fourth column.",
            ),
            right=(urdf_link, WithSympy(_urdf_link_sympy), URDF_LINK),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} C_2 & 0 & S_2 & a_1 C_2 + d_2 S_2 \\ 0 & 1 & 0 & 0 \\ -S_2 & 0 & C_2 & -a_1 S_2 + d_2 C_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "that rotates first: the joint itself would move as it turns; the offset comes before the rotation",
                    own=True,
                ),
                Wrong(
                    _turn("z", 2, "a_1", "d_2"),
                    "the axis of joint 2 is y: in the URDF, not every joint turns about z",
                    own=True,
                ),
                Wrong(
                    _turn("x", 2, "a_1", "d_2"),
                    "the axis of joint 2 is y: a rotation about x leaves the arm's plane",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_2 & 0 & -S_2 & a_1 \\ 0 & 1 & 0 & 0 \\ S_2 & 0 & C_2 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "the angle turns the wrong way: about y, z turns towards x, so that S stands in the upper right corner",
                    own=True,
                ),
                Wrong(_turn("y", 2, "a_1", "0"), "(3, 4)"),
                Wrong(lambda q, a_1, d_2: urdf_link(np.deg2rad(q), a_1, d_2), "degrees"),
            ),
        ),
        Task(
            name="wrist",
            title="Three axes, one point",
            text="Which three joint axes meet in one point, at every configuration? Give the list of their keys: `z1`, `z2`, `z3`, `z4`, `z5`, `z6`.",
            asks=Choice(
                {f"z{k}": f"the axis of joint {k}" for k in range(1, 7)},
                frozenset({"z4", "z5", "z6"}),
                because={
                    "z1": "axis 1 is vertical at the foot: the shoulder's axis passes 0.35 m in front of it",
                    "z2": "axes 2 and 3 are parallel, so that they never meet",
                    "z3": "the forearm's axis passes 0.054 m below axis 3: it does not meet it",
                },
            ),
            hints=(
                "An offset along its own axis does not move a line. Whose offsets are of that kind?",
                "Axis 4 is the forearm's own $x$; joint 5 sits on it, and so does joint 6.",
                "They are the three axes of the wrist (*poignet*).",
            ),
            right=(["z4", "z5", "z6"], "z4, z5, z6", {"z6", "z5", "z4"}),
            wrong=(
                Wrong(["z2", "z3"], "parallel"),
                Wrong(["z3", "z4", "z5"], "0.054 m below"),
                Wrong(["z4", "z6"], "there is more"),
                Wrong(["z1", "z2"], "0.35 m in front"),
                Wrong(["z5", "z6"], "there is more"),
            ),
        ),
        Task(
            name="merged",
            title="Offsets that merge",
            text="The origin of a DH frame need not sit at its joint: $O_1$ stands on axis 1 at the shoulder's height, $O_4$, $O_5$ and $O_6$ where the axes of the "
            "wrist meet. Give three distances in metres: from $O_0$ up to $O_1$; along axis 4 from the foot of the perpendicular from axis 3 to $O_4$; from $O_6$ to the gripper.",
            asks=Number(
                (0.75, 1.5, 0.303),
                "m",
                ("the first distance", "the second distance", "the third distance"),
                LENGTHS,
                steps=("d_1 + d_2", "d_4 + d_5", "d_6 + d_G"),
            ),
            hints=(
                "Each of them is the sum of two offsets along one line.",
                "Up the first axis: rows 1 and 2. Along the forearm: rows 4 and 5. Along the hand: the last two rows.",
                "$0.33 + 0.42$, $0.96 + 0.54$ and $0.193 + 0.11$.",
            ),
            right=([0.75, 1.5, 0.303], "0.75, 1.5, 0.303", (0.33 + 0.42, 0.96 + 0.54, 0.193 + 0.11)),
            wrong=(
                Wrong(
                    [0.33, 0.96, 0.193],
                    "these are the joints of the URDF: a DH origin need not sit at its joint",
                    own=True,
                ),
                Wrong(
                    [0.75, 1.5, 0.11],
                    "that starts at the joint 6 of the URDF: O_6 is 0.193 m behind it, in the wrist's centre",
                    own=True,
                ),
                Wrong(
                    [0.75, 1.25, 0.303],
                    "1.25 m is the upper arm, from axis 2 to axis 3: here the forearm counts",
                    own=True,
                ),
                Wrong(
                    [0.75, float(np.hypot(1.5, 0.054)), 0.303],
                    "this is the oblique distance from axis 3: along axis 4 it is a side of that triangle",
                    own=True,
                ),
                Wrong([0.75, 0.96, 0.303], "O_4 is not at joint 4: it is on axis 4 where axis 5 crosses it", own=True),
                Wrong(
                    [0.33, 1.5, 0.303], "O_1 stands at the height of axis 2, so that no d is left for row 2", own=True
                ),
                Wrong([750, 1500, 303], "these are millimetres", own=True),
            ),
        ),
        Task(
            name="table",
            title="The modified DH table",
            text="Write the table: six rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$. $z_i$ is the URDF's axis of joint $i$ (in the zero pose along $z, y, y, x, y, x$ of frame 0, each in the positive sense), $x_1$ points "
            'forward and all other $x_i$ up in the zero pose. Letters: $d_1, d_2, a_1, a_2, a_3, d_4, d_5$; a row may be `("-pi/2", "a_1", 0, "theta_2")`.',
            asks=Table(DH, "modified", measured="kr210"),
            hints=(
                "Row by row: turn $z_{i-1}$ into $z_i$ about $x_{i-1}$ ($\\alpha$), walk along $x_{i-1}$ ($a$), then along $z_i$ ($d$), then turn $x_{i-1}$ into $x_i$ about $z_i$ ($\\theta$).",
                "$x_1$ is horizontal and $x_2$ upright at zero: row 2 needs a constant in $\\theta$. Along $x_3$, which points up, the forearm's axis lies below.",
                "$\\alpha$: $0, -\\pi/2, 0, -\\pi/2, \\pi/2, -\\pi/2$. $a$: $0, a_1, a_2, -a_3, 0, 0$. Only rows 1 and 4 have a $d$, each a sum.",
            ),
            right=(
                table,
                table(),
                TABLE,
                [dict(zip(("alpha", "a", "d", "theta"), row, strict=True)) for row in table()],
            ),
            wrong=(
                Wrong(_changed(2, "-pi/2", "a_1", 0, "theta_2"), "row 2: theta is wrong (the constant offset)"),
                Wrong(_changed(1, 0, 0, "d_1", "theta_1"), "row 1: d is wrong (d_2 is missing)"),
                Wrong(_changed(2, "-pi/2", "a_1", "d_2", "theta_2 - pi/2"), "row 2: d is wrong (it should vanish)"),
                Wrong(_changed(4, "-pi/2", "a_3", "d_4 + d_5", "theta_4"), "row 4: a is wrong (the sign)"),
                Wrong(_changed(4, "-pi/2", "-a_3", "d_4", "theta_4"), "row 4: d is wrong (d_5 is missing)"),
                Wrong(_changed(5, "pi/2", 0, "d_5", "theta_5"), "row 5: d is wrong (it should vanish)"),
                Wrong(_changed(2, "pi/2", "a_1", 0, "theta_2 - pi/2"), "row 2: alpha is wrong (the sign)"),
                Wrong(
                    [
                        ("-pi/2", "a_1", "d_1 + d_2", "theta_1"),
                        (0, "a_2", 0, "theta_2 - pi/2"),
                        ("-pi/2", "-a_3", 0, "theta_3"),
                        ("pi/2", 0, "d_4 + d_5", "theta_4"),
                        ("-pi/2", 0, 0, "theta_5"),
                        (0, 0, 0, "theta_6"),
                    ],
                    "α and a stand one row too high: in the modified table row i holds those of link i − 1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="dh_link",
            title="A row of the DH table",
            text="Write ${}^1T_2$ once more, now between the DH frames: row 2 of the table put into the modified link matrix, 4×4. Letters: $\\theta_2, a_1$. A function takes `q` "
            "and, by their names, the lengths that it needs.",
            asks=Quantity(DH, {"pose": 2, "in": 1}),
            hints=(
                "$\\mathrm{Rot}(x, \\alpha_1)\\,\\mathrm{Trans}(x, a_1)\\,\\mathrm{Rot}(z, \\theta)\\,\\mathrm{Trans}(z, d)$ with $d = 0$.",
                "$\\cos\\alpha_1 = 0$ and $\\sin\\alpha_1 = -1$ leave only a few entries.",
                "$\\cos(\\theta_2 - \\pi/2) = S_2$ and $\\sin(\\theta_2 - \\pi/2) = -C_2$. Row 2 is $[0, 0, 1, 0]$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The two steps about and along $x$.",
                        r"\mathrm{Rot}_x(-\tfrac{\pi}{2})\,\mathrm{Trans}_x(a_1) = \begin{bmatrix} 1 & 0 & 0 & a_1 \\ 0 & 0 & 1 & 0 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The angle of the table is $\\theta_2 - \\frac{\\pi}{2}$: sine and cosine change places.",
                        r"\mathrm{Rot}_z(\theta_2 - \tfrac{\pi}{2}) = \begin{bmatrix} S_2 & C_2 & 0 & 0 \\ -C_2 & S_2 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply: the second row comes third, with a minus.",
                        r"{}^1T_2 = \begin{bmatrix} S_2 & C_2 & 0 & a_1 \\ 0 & 0 & 1 & 0 \\ C_2 & -S_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": DH},
            ),
            right=(dh_link, WithSympy(_modified_link_sympy), DH_LINK),
            wrong=(
                Wrong(_dh_link_without_offset, "theta_2 is counted from another zero: off by π/2"),
                Wrong(
                    r"\begin{bmatrix} S_2 & 0 & C_2 & a_1 S_2 \\ -C_2 & 0 & S_2 & -a_1 C_2 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "that is the classic link matrix: in the modified one a and α come before the joint turns",
                    own=True,
                ),
                Wrong(
                    DH_LINK.replace("0 & 0 & 1 & 0", "0 & 0 & -1 & 0").replace(
                        "C_2 & -S_2 & 0 & 0", "-C_2 & S_2 & 0 & 0"
                    ),
                    "that is α = +π/2: rows 2 and 3 have the other sign",
                    own=True,
                ),
                Wrong(
                    URDF_LINK.replace("d_2", "0"),
                    "that is the matrix of the URDF's frames: the DH frames 1 and 2 are not parallel in the zero pose",
                    own=True,
                ),
                Wrong(lambda q, a_1: dh_link(q, a_1).T, "transposed"),
                Wrong(
                    lambda q: dh_link(q, 0.35),
                    "the matrix is right for a_1 = 0.35 m only: make the letter a_1 an argument of your function",
                    own=True,
                ),
            ),
        ),
        Task(
            name="tool",
            title="From frame 6 to the gripper",
            text="The gripper's frame $G$ of the URDF is parallel to frame 0 in the zero pose; the DH frame 6 then has $x_6$ up and $z_6$ forward. Write the constant "
            "${}^6T_G$, 4×4, in $d_6$ and $d_G$. A function takes `(d_6, d_G)`.",
            asks=Formula(TOOL, ("d_6", "d_G"), arm="kr210"),
            hints=(
                "The columns of a rotation are the axes of the new frame, $x_G$, $y_G$, $z_G$, written in frame 6.",
                "$x_G$ points forward, as $z_6$ does; $z_G$ points up, as $x_6$ does. Which way is $y_6 = z_6 \\times x_6$ in the zero pose?",
                "The columns are $z_6$, $-y_6$, $x_6$; the gripper is $d_6 + d_G$ along $z_6$.",
            ),
            right=(
                tool,
                WithSympy(
                    lambda sp: sp.Matrix(
                        [[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, sp.Symbol("d_6") + sp.Symbol("d_G")], [0, 0, 0, 1]]
                    )
                ),
                TOOL,
            ),
            wrong=(
                Wrong(
                    TOOL.replace("0 & -1 & 0 & 0", "0 & 1 & 0 & 0"),
                    "that is no rotation, its determinant is −1: y_6 points the other way than y_G",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d_6 + d_G \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "the frames 6 and G are not parallel: x_G points along z_6",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} 0 & 0 & 1 & d_6 + d_G \\ 0 & -1 & 0 & 0 \\ 1 & 0 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "the way to the gripper is along z_6, the third coordinate: along x it is only in the URDF's frames",
                    own=True,
                ),
                Wrong(TOOL.replace("d_6 + d_G", "d_G"), "missing"),
                Wrong(
                    TOOL.replace("d_6 + d_G", "0.303"),
                    "the matrix is right for this arm, but its lengths are to stand as letters, not as numbers",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} 0 & 0 & -1 & 0 \\ 0 & 1 & 0 & 0 \\ 1 & 0 & 0 & d_6 + d_G \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "a quarter turn alone is not enough: z_G would point down",
                    own=True,
                ),
            ),
        ),
        Task(
            name="pose",
            title="One arm",
            text="Write ${}^0T_G$ of the gripper, 4×4, as the product of your six link matrices and ${}^6T_G$. It is compared with the URDF as Drake reads it. A function takes `q` and, by "
            "their names, the lengths that it needs, or has the numbers of the table in it.",
            asks=Quantity("kr210", {"pose": "G"}),
            hints=(
                "A loop over the rows, each put into the modified link matrix, and `X = X @ matrix`.",
                "Start with `np.eye(4)`, end with the constant matrix of the tool. Nothing is to be multiplied out by hand.",
                "If the position is right and the rotation is not, look at ${}^6T_G$; if the zero pose is wrong, at the offset of $\\theta_2$.",
            ),
            right=(pose, _in_numbers, POSE),
            wrong=(
                Wrong(_no_offset, "theta_2 is counted from another zero: off by π/2"),
                Wrong(
                    _no_tool_rotation,
                    "the position is right, but your last frame is the DH frame 6: turn it into the gripper's",
                    own=True,
                ),
                Wrong(
                    _no_tool, "this ends at the DH frame 6, in the wrist: the last factor, ⁶T_G, is missing", own=True
                ),
                Wrong(_forearm_up, "the sign of the length a_3 is wrong"),
                Wrong(_no_gripper, "this is that of frame 6, not G"),
                Wrong(
                    _classic_matrices, "the rows are of the modified table, the matrices of the classic one", own=True
                ),
                Wrong(lambda q: _in_numbers(np.deg2rad(q)), "degrees"),
            ),
        ),
        Task(
            name="aligned",
            title="At the wrist's singular configuration",
            text="Put $\\theta_5 = 0$. Give two numbers: the rank of the 6×6 Jacobian at a generic posture of the other joints, and the rate $\\dot\\theta_6$ that undoes $\\dot\\theta_4 = 1$, so that the gripper is at rest "
            "(joints 1, 2, 3, 5 rest too).",
            asks=Number((5, -1), labels=("the rank", "the rate of joint 6"), steps=("6 - 1", "-1")),
            hints=(
                "Where do the axes of joints 4 and 6 lie when $\\theta_5 = 0$?",
                "They are one line: the columns 4 and 6 of the Jacobian are then equal.",
                "Two equal columns: one direction fewer than six, and equal and opposite rates do nothing.",
            ),
            right=([5, -1], (5, -1), "5, -1"),
            wrong=(
                Wrong([6, -1], "two columns are equal, so they are not independent", own=True),
                Wrong([4, -1], "only one column is lost: the two equal ones still count as one", own=True),
                Wrong([5, 1], "both turning the same way, they turn the gripper twice as fast", own=True),
                Wrong([5, 0], "joint 4 alone turns the gripper about the forearm: something has to undo it", own=True),
                Wrong([3, -1], "the three joints of the arm and two of the wrist are still independent", own=True),
                Wrong(
                    [2, -1],
                    "this is the rank of the wrist's three columns alone: those of the arm count, too",
                    own=True,
                ),
                Wrong([1, -1], "two equal columns take away one direction, not all", own=True),
                Wrong([0, -1], "a determinant of zero takes away one direction, not all", own=True),
                Wrong([5, 0.5], "joint 6 turns backwards, and undoes all of it", own=True),
                Wrong([5, -2], "joint 6 turns back as fast as joint 4 forward, not twice as fast", own=True),
                Wrong([5, 2], "backwards, and as fast as joint 4: not twice as fast", own=True),
                Wrong([5, -0.5], "the axes are one line: joint 6 has to undo all of it, not half", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="In a URDF three joints have these offsets from one to the next and these axes: joint 1 $(0, 0, h)$, revolute about $z$; joint 2 $(0, e, 0)$,"
            " revolute about $x$; joint 3 $(0, 0, b)$, prismatic along $z$. All frames of the URDF are parallel at zero. Write the modified table: $z_i$ is the"
            " axis of joint $i$, frame 0 is on the floor with the axes of the URDF, $x_1$ and $x_2$ point along $y_0$ at zero. Letters: $h$, $e$, $b$ and the"
            " joints.",
            asks=Table(GANTRY, "modified"),
            hints=(
                "Where does the common normal of axes 1 and 2 lie? $x_1$ points along it: along $y_0$ at zero.",
                "$\\theta$ of row 1 is the angle from $x_0$ to $x_1$: a quarter turn when the joint stands at zero.",
                "Axes 2 and 3 meet, so $a_2 = 0$ and $O_2$, $O_3$ lie on that point and $d_3 + b$ above it. About $y$, which turn takes $z$ to $x$?",
            ),
            right=(
                GANTRY_ROWS,
                GANTRY["rows"],
                r"\begin{array}{cccc} 0 & 0 & h & \theta_1 + \pi/2 \\ \pi/2 & e & 0 & \theta_2 \\ -\pi/2 & 0 & d_3 + b & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [(0, 0, "h", "theta_1"), *GANTRY_ROWS[1:]],
                    "the offset of row 1 is missing: from x_0 to x_1, along y_0, is a quarter turn at zero",
                    own=True,
                ),
                Wrong(
                    [GANTRY_ROWS[0], ("pi/2", "e", 0, "theta_2"), ("-pi/2", 0, "d_3", 0)],
                    "b is missing: at d_3 = 0 the quill's frame is b above axis 2",
                    own=True,
                ),
                Wrong([GANTRY_ROWS[0], ("-pi/2", "e", 0, "theta_2"), GANTRY_ROWS[2]], "row 2: alpha is wrong"),
                Wrong(
                    [(0, "e", "h", "theta_1 + pi/2"), ("pi/2", 0, 0, "theta_2"), GANTRY_ROWS[2]],
                    "e stands one row too early: row 2 holds the length between axes 1 and 2",
                    own=True,
                ),
                Wrong([(0, 0, "h", "theta_1 - pi/2"), *GANTRY_ROWS[1:]], "row 1: theta is wrong"),
                Wrong(GANTRY_ROWS[:2], "3 rows"),
            ),
        ),
    ),
)
