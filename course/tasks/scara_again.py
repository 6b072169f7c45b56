"""Tasks of lesson 18, the SCARA's exercises by hand (documents 000 and 004), and the inverse of document 001's SCARA."""

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
from armproof.course.links import shift, turn

DOWN, COLUMN, UP = "scara", "scara_column", "scara_modified"
ROWS = [("theta_1", "d_1", "a_1", 0), ("theta_2", 0, "a_2", "pi"), (0, "d_3", 0, 0), ("theta_4", "d_4", 0, 0)]

# -- document 000 ------------------------------------------------------------------------------------------------------


def tool_down(q, a_1, a_2, d_4):
    """Return T^0_4: the angle θ_1 + θ_2 − θ_4, a mirror of y and z, the tool below the arms."""
    theta_1, theta_2, d_3, theta_4 = q
    c, s = np.cos(theta_1 + theta_2 - theta_4), np.sin(theta_1 + theta_2 - theta_4)
    x = a_1 * np.cos(theta_1) + a_2 * np.cos(theta_1 + theta_2)
    y = a_1 * np.sin(theta_1) + a_2 * np.sin(theta_1 + theta_2)
    return np.array([[c, s, 0, x], [s, -c, 0, y], [0, 0, -1, -(d_3 + d_4)], [0, 0, 0, 1]])


TOOL_DOWN = r"""\begin{bmatrix} c_{12}c_4 + s_{12}s_4 & -c_{12}s_4 + s_{12}c_4 & 0 & a_1 c_1 + a_2 c_{12} \\
s_{12}c_4 - c_{12}s_4 & -s_{12}s_4 - c_{12}c_4 & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & -(d_3 + d_4) \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def third_pose(q, a_1, a_2):
    """Return T^0_3: the angle θ_1 + θ_2, y and z turned over."""
    theta_1, theta_2, d_3, _ = q
    c, s = np.cos(theta_1 + theta_2), np.sin(theta_1 + theta_2)
    x, y = a_1 * np.cos(theta_1) + a_2 * c, a_1 * np.sin(theta_1) + a_2 * s
    return np.array([[c, s, 0, x], [s, -c, 0, y], [0, 0, -1, -d_3], [0, 0, 0, 1]])


THIRD_POSE = r"""\begin{bmatrix} c_{12} & s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & -c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\
0 & 0 & -1 & -d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def origin(q, a_1, a_2):
    """Return p_3, the fourth column of T^0_3."""
    theta_1, theta_2, d_3, _ = q
    x = a_1 * np.cos(theta_1) + a_2 * np.cos(theta_1 + theta_2)
    y = a_1 * np.sin(theta_1) + a_2 * np.sin(theta_1 + theta_2)
    return np.array([x, y, -d_3])


ORIGIN = r"\begin{bmatrix} a_1 c_1 + a_2 c_{12} \\ a_1 s_1 + a_2 s_{12} \\ -d_3 \end{bmatrix}"


def last_lever(q, d_4):
    """Return p_4 − p_3: the tool is d_4 below frame 3."""
    return np.array([0, 0, -d_4])


LAST_LEVER = r"\begin{bmatrix} 0 \\ 0 \\ -d_4 \end{bmatrix}"


def _chain_sympy(sp, last, height=0):
    t1, t2, d3, t4, a1, a2, d4 = sp.symbols("theta_1 theta_2 d_3 theta_4 a_1 a_2 d_4")
    X = (
        shift(sp, z=height)
        * turn(sp, "z", t1)
        * shift(sp, x=a1)
        * turn(sp, "z", t2)
        * shift(sp, x=a2)
        * turn(sp, "x", sp.pi)
    )
    X = X * shift(sp, z=d3)
    return X * turn(sp, "z", t4) * shift(sp, z=d4) if last == 4 else X


# -- document 004 ------------------------------------------------------------------------------------------------------


def whole_pose(q, a_1, a_2, d_1, d_4):
    """Return H_0^4: as in document 000, d_1 higher."""
    theta_1, theta_2, d_3, theta_4 = q
    c, s = np.cos(theta_1 + theta_2 - theta_4), np.sin(theta_1 + theta_2 - theta_4)
    x = a_1 * np.cos(theta_1) + a_2 * np.cos(theta_1 + theta_2)
    y = a_1 * np.sin(theta_1) + a_2 * np.sin(theta_1 + theta_2)
    return np.array([[c, s, 0, x], [s, -c, 0, y], [0, 0, -1, d_1 - d_3 - d_4], [0, 0, 0, 1]])


_ANGLE = r"(\theta_1 + \theta_2 - \theta_4)"
WHOLE_POSE = rf"""\begin{{bmatrix}} \cos{_ANGLE} & \sin{_ANGLE} & 0 & a_1 C_1 + a_2 C_{{12}} \\ \sin{_ANGLE} & -\cos{_ANGLE} & 0 & a_1 S_1 + a_2 S_{{12}} \\
0 & 0 & -1 & d_1 - d_3 - d_4 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"""


def orientation(q):
    """Return MGDori, the rotation of frame 4."""
    c, s = np.cos(q[0] + q[1] - q[3]), np.sin(q[0] + q[1] - q[3])
    return np.array([[c, s, 0], [s, -c, 0], [0, 0, -1]])


ORIENTATION = rf"\begin{{bmatrix}} \cos{_ANGLE} & \sin{_ANGLE} & 0 \\ \sin{_ANGLE} & -\cos{_ANGLE} & 0 \\ 0 & 0 & -1 \end{{bmatrix}}"


def squares(theta_2, a_1, a_2):
    """Return X² + Y²: the law of cosines."""
    return a_1**2 + a_2**2 + 2 * a_1 * a_2 * np.cos(theta_2)


SQUARES = r"a_1^2 + a_2^2 + 2 a_1 a_2 \cos\theta_2"


def _squares_sympy(sp):
    t1, t2, a1, a2 = sp.symbols("theta_1 theta_2 a_1 a_2")
    X, Y = a1 * sp.cos(t1) + a2 * sp.cos(t1 + t2), a1 * sp.sin(t1) + a2 * sp.sin(t1 + t2)
    return sp.simplify(sp.expand_trig(X**2 + Y**2))


def collected(theta_1, k_1, k_2):
    """Return X and Y: the vector (k_1, k_2) turned by θ_1."""
    return [k_1 * np.cos(theta_1) - k_2 * np.sin(theta_1), k_2 * np.cos(theta_1) + k_1 * np.sin(theta_1)]


COLLECTED = r"\begin{bmatrix} k_1 \cos\theta_1 - k_2 \sin\theta_1 \\ k_2 \cos\theta_1 + k_1 \sin\theta_1 \end{bmatrix}"


def _collected_sympy(sp):
    t, k1, k2 = sp.symbols("theta_1 k_1 k_2")
    return sp.Matrix([[sp.cos(t), -sp.sin(t)], [sp.sin(t), sp.cos(t)]]) * sp.Matrix([k1, k2])


def amplitude(k_1, k_2):
    """Return the length and the angle of (k_1, k_2)."""
    return [np.sqrt(k_1**2 + k_2**2), np.arctan2(k_2, k_1)]


AMPLITUDE = r"\begin{bmatrix} \sqrt{k_1^2 + k_2^2} \\ \text{atan2}(k_2, k_1) \end{bmatrix}"


def _amplitude_sympy(sp):
    k1, k2 = sp.symbols("k_1 k_2")
    return sp.Matrix([sp.sqrt(k1**2 + k2**2), sp.atan2(k2, k1)])


BEND = float(np.arctan2(0.2, 0.48))  # of the posture: links of 0.48 and 0.2, the tool 0.52 away


# -- the inverse of document 001's SCARA -------------------------------------------------------------------------------

_GIVEN = {
    "x": r"a_2 C_1 + a_3 C_{12}",
    "y": r"a_2 S_1 + a_3 S_{12}",
    "z": "-d_2",
    "phi": r"\theta_1 + \theta_2 + \theta_4",
    "D": r"\frac{x^2 + y^2 - a_2^2 - a_3^2}{2 a_2 a_3}",
    "k_1": "a_2 + a_3 D",
    "k_2": r"a_3 \sqrt{1 - D^2}",
}
_FIRST = r"\text{atan2}(y, x) - \text{atan2}(k_2, k_1)"
INVERSE = rf"\begin{{bmatrix}} {_FIRST} \\ \arccos D \\ -z \\ \phi - ({_FIRST}) - \arccos D \end{{bmatrix}}"


def inverse(x, y, z, phi, a_2, a_3):
    """Return [θ_1, θ_2, d_2, θ_4] of the posture whose θ_2 is not negative."""
    theta_2 = np.arccos((x**2 + y**2 - a_2**2 - a_3**2) / (2 * a_2 * a_3))
    k_1, k_2 = a_2 + a_3 * np.cos(theta_2), a_3 * np.sin(theta_2)
    theta_1 = np.arctan2(y, x) - np.arctan2(k_2, k_1)
    return np.array([theta_1, theta_2, -z, phi - theta_1 - theta_2])


def _spoiled(change):
    """Return the solution with a change."""

    def spoiled(x, y, z, phi, a_2, a_3):
        q = list(inverse(x, y, z, phi, a_2, a_3))
        return change(q, x, y, z, phi)

    return spoiled


def _inverse_with_tangent(x, y, z, phi, a_2, a_3):
    c = (x**2 + y**2 - a_2**2 - a_3**2) / (2 * a_2 * a_3)
    s = np.sqrt(1 - c**2)
    theta_1 = np.arctan2((a_2 + a_3 * c) * y - a_3 * s * x, (a_2 + a_3 * c) * x + a_3 * s * y)
    theta_2 = np.arctan2(s, c)
    return [theta_1, theta_2, -z, phi - theta_1 - theta_2]


# -- an arm that nobody has seen ---------------------------------------------------------------------------------------

LIFT = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "d_1", "theta": 0},
        {"alpha": 0, "a": 0, "d": 0, "theta": "theta_2"},
        {"alpha": 0, "a": "b", "d": 0, "theta": "theta_3"},
        {"alpha": "pi", "a": "c", "d": 0, "theta": 0},
    ],
    "joints": ["d_1", "theta_2", "theta_3"],
}


def lift(q, b, c):
    """Return the pose of the lift's gripper: two turns, y and z turned over, the height of the slide."""
    d_1, theta_2, theta_3 = q
    C, S = np.cos(theta_2 + theta_3), np.sin(theta_2 + theta_3)
    x, y = b * np.cos(theta_2) + c * C, b * np.sin(theta_2) + c * S
    return np.array([[C, S, 0, x], [S, -C, 0, y], [0, 0, -1, d_1], [0, 0, 0, 1]])


LIFT_POSE = r"""\begin{bmatrix} C_{23} & S_{23} & 0 & b\,C_2 + c\,C_{23} \\ S_{23} & -C_{23} & 0 & b\,S_2 + c\,S_{23} \\
0 & 0 & -1 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _lift_sympy(sp):
    d1, t2, t3, b, c = sp.symbols("d_1 theta_2 theta_3 b c")
    C, S = sp.cos(t2 + t3), sp.sin(t2 + t3)
    x, y = b * sp.cos(t2) + c * C, b * sp.sin(t2) + c * S
    return sp.Matrix([[C, S, 0, x], [S, -C, 0, y], [0, 0, -1, d1], [0, 0, 0, 1]])


LESSON = Lesson(
    number=18,
    name="scara_again",
    title="The SCARA's exercises by hand",
    source="F. Morbidi, TD 3, 2019 (document 000) and A. Beneult Lefaucheux, TD 1, 2014 (document 004)",
    objectives=(
        "Write poses, origins and axes of the SCARA singly, as the worked solution does.",
        "Derive the shoulder's equation and compute both postures of a target.",
        "Solve the SCARA of document 001, and say in your own words why a motion starts and ends at rest.",
    ),
    tasks=(
        Task(
            name="third_pose",
            title="Document 000: the pose of frame 3",
            text="Write $T^0_3 = A^0_1 A^1_2 A^2_3$ of document 000's SCARA, 4×4. A function takes `q` = $[\\theta_1, \\theta_2, d_3, \\theta_4]$, `a_1`, `a_2`.",
            asks=Quantity(DOWN, {"pose": 3}),
            hints=(
                "$A^0_1 A^1_2$ first: the angles add up, and $\\mathbf{Rot}_x(\\pi)$ turns y and z over.",
                "Then a move by $d_3$ along the new $z$, which points down.",
                "The rotation is $[c_{12}, s_{12}, 0;\\ s_{12}, -c_{12}, 0;\\ 0, 0, -1]$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The first arm: a turn, then a move by $a_1$ along the new $x$.",
                        r"T^0_1 = \begin{bmatrix} c_1 & -s_1 & 0 & a_1 c_1 \\ s_1 & c_1 & 0 & a_1 s_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The second arm too, and a half turn about $x$: its second and third column change their signs.",
                        r"T^1_2 = \begin{bmatrix} c_2 & s_2 & 0 & a_2 c_2 \\ s_2 & -c_2 & 0 & a_2 s_2 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply: the angles add up.",
                        r"T^0_2 = \begin{bmatrix} c_{12} & s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & -c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The slide only moves, along $z_2$.",
                        r"T^2_3 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "$z_2$ points down: the height falls by $d_3$.",
                        r"T^0_3 = \begin{bmatrix} c_{12} & s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & -c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & -d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": DOWN},
            ),
            right=(third_pose, THIRD_POSE, WithSympy(lambda sp: sp.simplify(_chain_sympy(sp, 3)))),
            wrong=(
                Wrong(
                    THIRD_POSE.replace("& -d_3", "& d_3"),
                    "z_3 points down: lowering by d_3 makes the height −d_3",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} c_{12} & -s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & 1 & -d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "the half turn about x is missing: the second and the third column change their signs",
                    own=True,
                ),
                Wrong(
                    THIRD_POSE.replace("c_{12} \\\\ s", "c_2 \\\\ s").replace("a_2 s_{12}", "a_2 s_2"),
                    "the second arm is carried by the first: a_2 c_12 and a_2 s_12",
                    own=True,
                ),
                Wrong(lambda q, a_1, a_2: third_pose(q, a_2, a_1), "swapped"),
                Wrong(
                    lambda q, a_1, a_2: tool_down(q, a_1, a_2, 0),
                    "this has joint 4 in it: frame 3 stands before it",
                    own=True,
                ),
            ),
        ),
        Task(
            name="tool_down",
            title="Document 000: the pose of the tool",
            text="Write $T^0_4 = T^0_3 A^3_4$, 4×4. A function takes `q`, `a_1`, `a_2`, `d_4`.",
            asks=Quantity(DOWN, {"pose": 4}),
            hints=(
                "$A^3_4$ turns by $\\theta_4$ about $z_3$ and moves by $d_4$ along it.",
                "Entry (1, 1) is $c_{12}c_4 + s_{12}s_4$: the cosine of a difference.",
                "$\\theta_4$ counts against the others, since $z_3$ points down.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The last link: a turn about $z_3$ and a move along it.",
                        r"T^3_4 = \begin{bmatrix} c_4 & -s_4 & 0 & 0 \\ s_4 & c_4 & 0 & 0 \\ 0 & 0 & 1 & d_4 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply the rotations: $c_{12}$ and $s_{12}$ meet $c_4$ and $s_4$.",
                        r"\begin{bmatrix} c_{12} & s_{12} \\ s_{12} & -c_{12} \end{bmatrix} \begin{bmatrix} c_4 & -s_4 \\ s_4 & c_4 \end{bmatrix} = \begin{bmatrix} c_{12}c_4 + s_{12}s_4 & -c_{12}s_4 + s_{12}c_4 \\ s_{12}c_4 - c_{12}s_4 & -s_{12}s_4 - c_{12}c_4 \end{bmatrix}",
                    ),
                    Line(
                        "They are the cosine and the sine of a difference: $\\theta_4$ counts against the others.",
                        r"\begin{bmatrix} c_{12}c_4 + s_{12}s_4 \\ s_{12}c_4 - c_{12}s_4 \end{bmatrix} = \begin{bmatrix} \cos(\theta_1 + \theta_2 - \theta_4) \\ \sin(\theta_1 + \theta_2 - \theta_4) \end{bmatrix}",
                    ),
                    Line(
                        "The move by $d_4$ goes along $z_3$, down.",
                        r"p_4 - p_3 = \begin{bmatrix} 0 \\ 0 \\ -d_4 \end{bmatrix}",
                    ),
                    Line(
                        "Together.",
                        r"T^0_4 = \begin{bmatrix} c_{12}c_4 + s_{12}s_4 & -c_{12}s_4 + s_{12}c_4 & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12}c_4 - c_{12}s_4 & -s_{12}s_4 - c_{12}c_4 & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & -(d_3 + d_4) \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": DOWN},
            ),
            right=(tool_down, TOOL_DOWN, WithSympy(lambda sp: sp.simplify(_chain_sympy(sp, 4)))),
            wrong=(
                Wrong(
                    lambda q, a_1, a_2, d_4: tool_down([*q[:3], -q[3]], a_1, a_2, d_4),
                    "θ_4 is added to the others: its axis points down, so it is subtracted",
                    own=True,
                ),
                Wrong(
                    lambda q, a_1, a_2, d_4: tool_down(q, a_1, a_2, 0),
                    "the move by d_4 is missing in the height",
                    own=True,
                ),
                Wrong(
                    lambda q, a_1, a_2, d_4: tool_down(q, a_1, a_2, -d_4),
                    "d_4 lies along z_3, which points down: −(d_3 + d_4)",
                    own=True,
                ),
                Wrong(
                    lambda q, a_1, a_2, d_4: tool_down([*q[:3], 0], a_1, a_2, d_4),
                    "the turn by θ_4 is missing in the rotation",
                    own=True,
                ),
                Wrong(lambda q, a_1, a_2, d_4: tool_down(q, a_2, a_1, d_4), "swapped"),
            ),
        ),
        Task(
            name="origins",
            title="Document 000: an origin read off",
            text="Write $p_3$ (3 rows, m), read off $T^0_3$.",
            asks=Quantity(DOWN, {"origin": 3}),
            hints=(
                "Which column holds the origin?",
                "The first three entries of the fourth column.",
                "The last entry is $-d_3$.",
            ),
            right=(origin, ORIGIN, WithSympy(lambda sp: sp.simplify(_chain_sympy(sp, 3))[:3, 3])),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} 0 \\ 0 \\ -1 \end{bmatrix}",
                    "this is z_3, the third column: an origin is the fourth",
                    own=True,
                ),
                Wrong(
                    lambda q, a_1, a_2, d_4: origin(q, a_1, a_2) - np.array([0, 0, d_4]),
                    "this is p_4, the tool: frame 3 is d_4 above it",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \end{bmatrix}",
                    "this is p_1, the elbow",
                    own=True,
                ),
                Wrong(ORIGIN.replace("-d_3", "d_3"), "sign"),
            ),
        ),
        Task(
            name="axes_down",
            title="Document 000: the axes",
            text="All axes $z_0$ to $z_3$ are vertical. Give their third entries in frame 0, four numbers, from the rotations $R^0_0$ to $R^0_3$.",
            asks=Number(
                (1, 1, -1, -1),
                labels=("z_0", "z_1", "z_2", "z_3"),
                steps=(r"\alpha_2 = 180^\circ", "1", "1", r"\cos\alpha_2", r"\cos\alpha_2"),
            ),
            hints=(
                "Each is the entry (3, 3) of its rotation.",
                "In which link is the half turn about $x$?",
                "It is in $A^1_2$: from $z_2$ on they point down.",
            ),
            right=([1, 1, -1, -1], "1, 1, -1, -1", np.array([1, 1, -1, -1])),
            wrong=(
                Wrong(
                    [1, 1, 1, 1], "the half turn in the second link is forgotten: from z_2 on they point down", own=True
                ),
                Wrong([1, -1, -1, -1], "the half turn is at the end of link 2: z_1 still points up", own=True),
                Wrong([1, 1, 1, -1], "the half turn comes with frame 2, not with frame 3", own=True),
                Wrong([1, 1, -1, 1], "joint 4 and the slide keep the direction: there is one half turn only", own=True),
                Wrong([-1, 1, -1, -1], "z_0 is the axis of the base, and points up", own=True),
            ),
        ),
        Task(
            name="last_lever",
            title="Document 000: the last lever",
            text="Write $p_4 - p_3$ (3 rows, in frame 0, m). A function takes `q` and `d_4`.",
            asks=Quantity(DOWN, {"difference": [4, 3]}),
            hints=(
                "You have both: $p_4$ is in $T^0_4$, $p_3$ in $T^0_3$.",
                "Their first two entries are equal.",
                "$-(d_3 + d_4) - (-d_3)$.",
            ),
            right=(last_lever, LAST_LEVER, WithSympy(lambda sp: sp.Matrix([0, 0, -sp.Symbol("d_4")]))),
            wrong=(
                Wrong(
                    lambda q, d_4: np.array([0, 0, d_4]),
                    "this is p_3 − p_4, or the lever in frame 3: the tool is lower",
                    own=True,
                ),
                Wrong(
                    lambda q, d_4: np.array([0, 0, -q[2] - d_4]),
                    "this is the height of the tool: take the height of frame 3 away, −d_3",
                    own=True,
                ),
                Wrong(
                    lambda q, d_4: np.array([0, 0, -1]), "this is the axis z_3: its lever has the length d_4", own=True
                ),
                Wrong(lambda q, d_4: np.array([d_4, 0, 0]), "the tool is below frame 3, not beside it", own=True),
            ),
        ),
        Task(
            name="parallel",
            title="Document 000: a product that is zero",
            text="Why is $z_3 \\times (p_4 - p_3) = 0$? `a`: $p_4 = p_3$; `b`: both vectors are parallel; `c`: joint 4 is a slide; `d`: $z_3 = 0$."
            " Write the letter.",
            asks=Choice(
                {"a": "p_4 = p_3", "b": "parallel", "c": "joint 4 is a slide", "d": "z_3 = 0"},
                right="b",
                because={
                    "a": "the tool is d_4 below frame 3: the points differ",
                    "c": "joint 4 turns; a slide would not have this product at all",
                    "d": "an axis has length one",
                },
            ),
            hints=(
                "Write both vectors down: $[0, 0, -1]^T$ and $[0, 0, -d_4]^T$.",
                "When is a cross product zero?",
                "The tool's point lies on the axis of joint 4, so that joint turns it without moving it.",
            ),
            right=("b", ["b"], {"b"}),
            wrong=(
                Wrong("a", "the points differ"),
                Wrong("c", "joint 4 turns"),
                Wrong("d", "length one"),
                Wrong(["a", "b"], "one of them is asked for"),
            ),
        ),
        Task(
            name="folded",
            title="Document 000: draw it folded",
            text="Draw the arm from above at $\\theta_2 = \\pi$ and $\\theta_1 = 90°$, with $a_1 = 0.4$ m and $a_2 = 0.25$ m. Where are the elbow and the"
            " tool? Give `[x, y]` of the elbow, then of the tool: four numbers in metres.",
            asks=Number(
                (0, 0.4, 0, 0.15),
                unit="m",
                labels=("x of the elbow", "y of the elbow", "x of the tool", "y of the tool"),
                steps=(
                    r"\theta_1 = 90^\circ",
                    r"\theta_2 = 180^\circ",
                    r"a_1 \cos\theta_1",
                    r"a_1 \sin\theta_1",
                    r"a_1 \cos\theta_1 + a_2 \cos(\theta_1 + \theta_2)",
                    r"a_1 \sin\theta_1 + a_2 \sin(\theta_1 + \theta_2)",
                ),
                beside=("a_1 + a_2", r"\sqrt{(a_1^2 + a_2^2)}"),
            ),
            hints=(
                "The first arm points along $y_0$.",
                "At $\\theta_2 = \\pi$ the second arm lies back on the first.",
                "From 0.4 back by 0.25.",
            ),
            right=([0, 0.4, 0, 0.15], "0, 0.4, 0, 0.15", np.array([0, 0.4, 0, 0.15])),
            wrong=(
                Wrong([0, 0.4, 0, 0.65], "this is the stretched arm, θ_2 = 0", own=True),
                Wrong([0.4, 0, 0.15, 0], "this is at θ_1 = 0: a quarter turn points the first arm along y_0", own=True),
                Wrong([0, 0.4, -0.25, 0.4], "this is θ_2 = π/2: at π the second arm lies back on the first", own=True),
                Wrong([0, 0.4, 0, -0.25], "the second arm starts at the elbow, not at axis 1", own=True),
            ),
        ),
        Task(
            name="column_table",
            title="Document 004: the table",
            text="The document uses a table that it does not print. Write it from $H_1$ to $H_4$, in the classic convention: four rows"
            " $(\\theta_i, d_i, a_i, \\alpha_i)$ with the joints, `d_1`, `a_1`, `a_2`, `d_4`.",
            asks=Table(COLUMN, "classic"),
            hints=(
                "A classic link matrix has $a\\,C\\theta$, $a\\,S\\theta$, $d$ in its last column.",
                "The twist is in the third row: $0, S\\alpha, C\\alpha$.",
                "Only $H_2$ has a $-1$ there: $\\alpha_2 = \\pi$.",
            ),
            right=(
                ROWS,
                [dict(zip(("theta", "d", "a", "alpha"), row, strict=True)) for row in ROWS],
                r"\begin{array}{cccc} \theta_1 & d_1 & a_1 & 0 \\ \theta_2 & 0 & a_2 & \pi \\ 0 & d_3 & 0 & 0 \\ \theta_4 & d_4 & 0 & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [("theta_1", "a_1", "d_1", 0), *ROWS[1:]],
                    "d and a are exchanged in row 1: d_1 is the column's height",
                    own=True,
                ),
                Wrong([ROWS[0], ("theta_2", 0, "a_2", 0), *ROWS[2:]], "row 2: alpha is wrong"),
                Wrong([("theta_1", 0, "a_1", 0), *ROWS[1:]], "row 1: d is wrong"),
                Wrong(
                    [*ROWS[:2], (0, 0, "d_3", 0), ROWS[3]],
                    "the slide moves along z: its variable is the offset d, not a length a",
                    own=True,
                ),
            ),
        ),
        Task(
            name="whole_pose",
            title="Document 004: the product",
            text="Write $H_0^4 = H_1 H_2 H_3 H_4$, 4×4. A function takes `q`, `a_1`, `a_2`, `d_1`, `d_4`.",
            asks=Quantity(COLUMN, {"pose": 4}, transforms="lower"),
            hints=(
                "$H_1 H_2$ adds two angles, and turns y and z over.",
                "$H_3 H_4$ is a turn by $\\theta_4$ with the move $d_3 + d_4$ along $z$.",
                "The same as in document 000, but for the height $d_1$ of the column.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The two arms: the angles add up, and $y$ and $z$ turn over.",
                        r"H_0^2 = \begin{bmatrix} C_{12} & S_{12} & 0 & a_1 C_1 + a_2 C_{12} \\ S_{12} & -C_{12} & 0 & a_1 S_1 + a_2 S_{12} \\ 0 & 0 & -1 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The slide and the tool: a move and a turn along one axis.",
                        r"H_2^4 = \begin{bmatrix} C_4 & -S_4 & 0 & 0 \\ S_4 & C_4 & 0 & 0 \\ 0 & 0 & 1 & d_3 + d_4 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply the first rows.",
                        r"\begin{bmatrix} C_{12} & S_{12} \end{bmatrix} \begin{bmatrix} C_4 & -S_4 \\ S_4 & C_4 \end{bmatrix} = \begin{bmatrix} \cos(\theta_1 + \theta_2 - \theta_4) & \sin(\theta_1 + \theta_2 - \theta_4) \end{bmatrix}",
                    ),
                    Line(
                        "The others in the same way; the move goes down.",
                        r"H_0^4 = \begin{bmatrix} \cos(\theta_1 + \theta_2 - \theta_4) & \sin(\theta_1 + \theta_2 - \theta_4) & 0 & a_1 C_1 + a_2 C_{12} \\ \sin(\theta_1 + \theta_2 - \theta_4) & -\cos(\theta_1 + \theta_2 - \theta_4) & 0 & a_1 S_1 + a_2 S_{12} \\ 0 & 0 & -1 & d_1 - d_3 - d_4 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara_column", "transforms": "lower"},
            ),
            right=(whole_pose, WHOLE_POSE, WithSympy(lambda sp: sp.simplify(_chain_sympy(sp, 4, sp.Symbol("d_1"))))),
            wrong=(
                Wrong(
                    lambda q, a_1, a_2, d_1, d_4: whole_pose(q, a_1, a_2, 0, d_4),
                    "the column is missing: the arms are d_1 above frame 0",
                    own=True,
                ),
                Wrong(
                    lambda q, a_1, a_2, d_1, d_4: whole_pose([*q[:3], -q[3]], a_1, a_2, d_1, d_4),
                    "θ_4 is added to the others: after the half turn it is subtracted",
                    own=True,
                ),
                Wrong(
                    lambda q, a_1, a_2, d_1, d_4: whole_pose([q[0], q[1], -q[2], q[3]], a_1, a_2, d_1, -d_4),
                    "slide and tool go down: their lengths are subtracted",
                    own=True,
                ),
                Wrong(lambda q, a_1, a_2, d_1, d_4: whole_pose(q, a_2, a_1, d_1, d_4), "swapped"),
                Wrong(
                    lambda q, a_1, a_2, d_1, d_4: np.linalg.inv(whole_pose(q, a_1, a_2, d_1, d_4)),
                    "inverse",
                ),
            ),
        ),
        Task(
            name="orientation",
            title="Document 004: MGDori",
            text="Write the orientation part of the model, 3×3, in $\\theta_1$, $\\theta_2$, $\\theta_4$.",
            asks=Quantity(COLUMN, {"rotation": 4}, transforms="lower"),
            hints=(
                "Which block of $H_0^4$ is it?",
                "The first three rows and columns.",
                "One angle only, $\\theta_1 + \\theta_2 - \\theta_4$.",
            ),
            right=(orientation, ORIENTATION, WithSympy(lambda sp: sp.simplify(_chain_sympy(sp, 4))[:3, :3])),
            wrong=(
                Wrong(
                    lambda q: orientation(q) * np.array([[1, -1, 1], [1, -1, 1], [1, 1, -1]]),
                    "this is a turn about z alone: the tool points down, so the second and third column change their signs",
                    own=True,
                ),
                Wrong(
                    lambda q: orientation([q[0], q[1], q[2], -q[3]]),
                    "θ_4 has the other sign: its axis points down",
                    own=True,
                ),
                Wrong(
                    lambda q: orientation([q[0], q[1], q[2], 0]),
                    "this is the rotation of frame 3: θ_4 is missing",
                    own=True,
                ),
                Wrong(
                    lambda q: orientation(q) * np.array([[1, 1, 1], [1, 1, 1], [1, 1, -1]]),
                    "the determinant is −1: with a third column that points up it is a mirror, no rotation",
                    own=True,
                ),
            ),
        ),
        Task(
            name="squares",
            title="Document 004: the sum of the squares",
            text="Expand $X^2 + Y^2$ until only $\\theta_2$ is left: in `theta_2`, `a_1`, `a_2`.",
            asks=Formula(SQUARES, ("theta_2", "a_1", "a_2"), arm=COLUMN, unit="m²"),
            hints=(
                "Square both, and add: which squares of sine and cosine go together?",
                "What is left over is $2 a_1 a_2 (C_1 C_{12} + S_1 S_{12})$.",
                "That is the cosine of the difference, $\\theta_2$.",
            ),
            derivation=Derivation(
                (
                    Line("The square of the first,", r"X^2 = a_1^2 C_1^2 + a_2^2 C_{12}^2 + 2 a_1 a_2 C_1 C_{12}"),
                    Line("and of the second.", r"Y^2 = a_1^2 S_1^2 + a_2^2 S_{12}^2 + 2 a_1 a_2 S_1 S_{12}"),
                    Line(
                        "Added: squares of sine and cosine make one, twice.",
                        r"X^2 + Y^2 = a_1^2 + a_2^2 + 2 a_1 a_2 (C_1 C_{12} + S_1 S_{12})",
                    ),
                    Line("The cosine of a difference is left.", r"X^2 + Y^2 = a_1^2 + a_2^2 + 2 a_1 a_2 \cos\theta_2"),
                ),
                {
                    "arm": "scara_column",
                    "quantities": {"X": {"origin": 4, "component": "x"}, "Y": {"origin": 4, "component": "y"}},
                },
            ),
            right=(squares, SQUARES, WithSympy(_squares_sympy)),
            wrong=(
                Wrong(SQUARES.replace("+ 2", "- 2"), "sign"),
                Wrong(r"a_1^2 + a_2^2 + a_1 a_2 \cos\theta_2", "factor"),
                Wrong(
                    r"a_1^2 + a_2^2",
                    "the mixed terms are missing: without them it is true only at θ_2 = ±π/2",
                    own=True,
                ),
                Wrong(r"a_1^2 + a_2^2 + 2 a_1 a_2 \sin\theta_2", "sine"),
                Wrong(
                    r"a_1^2 + a_2^2 + 2 a_1 a_2 \cos\theta_1",
                    "the whole arm may turn by θ_1 without a change: only θ_2 counts",
                    own=True,
                ),
            ),
        ),
        Task(
            name="collected",
            title="Document 004: collect",
            text="With $k_1 = a_1 + a_2 \\cos\\theta_2$ and $k_2 = a_2 \\sin\\theta_2$, write $X$ and $Y$ (2 rows) in `theta_1`, `k_1`, `k_2`.",
            asks=Formula(COLLECTED, ("theta_1", "k_1", "k_2"), unit="m"),
            hints=(
                "Expand $\\cos(\\theta_1 + \\theta_2)$ and $\\sin(\\theta_1 + \\theta_2)$.",
                "Put together what stands beside $\\cos\\theta_1$, and what beside $\\sin\\theta_1$.",
                "It is the vector $(k_1, k_2)$, turned by $\\theta_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Expand the cosine of the sum in $X$.",
                        r"X = a_1 \cos\theta_1 + a_2 (\cos\theta_1 \cos\theta_2 - \sin\theta_1 \sin\theta_2)",
                    ),
                    Line(
                        "Collect what stands beside $\\cos\\theta_1$ and beside $\\sin\\theta_1$.",
                        r"X = (a_1 + a_2 \cos\theta_2) \cos\theta_1 - a_2 \sin\theta_2 \sin\theta_1",
                    ),
                    Line(
                        "These are $k_1$ and $k_2$.",
                        r"X = k_1 \cos\theta_1 - k_2 \sin\theta_1",
                    ),
                    Line(
                        "The same with the sine of the sum in $Y$.",
                        r"Y = (a_1 + a_2 \cos\theta_2) \sin\theta_1 + a_2 \sin\theta_2 \cos\theta_1",
                    ),
                    Line(
                        "So $k_1$ stands beside the sine here.",
                        r"Y = k_2 \cos\theta_1 + k_1 \sin\theta_1",
                    ),
                ),
                {"symbols": {"a_1": "free", "a_2": "free", "theta_1": "free", "theta_2": "free"}},
                given=(
                    r"X = a_1 \cos\theta_1 + a_2 \cos(\theta_1 + \theta_2)",
                    r"Y = a_1 \sin\theta_1 + a_2 \sin(\theta_1 + \theta_2)",
                    r"k_1 = a_1 + a_2 \cos\theta_2",
                    r"k_2 = a_2 \sin\theta_2",
                ),
            ),
            right=(collected, COLLECTED, WithSympy(_collected_sympy)),
            wrong=(
                Wrong(
                    lambda theta_1, k_1, k_2: [
                        k_1 * np.cos(theta_1) + k_2 * np.sin(theta_1),
                        k_2 * np.cos(theta_1) - k_1 * np.sin(theta_1),
                    ],
                    "this turns by −θ_1: the minus belongs to the first row",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, k_1, k_2: [
                        k_1 * np.sin(theta_1) - k_2 * np.cos(theta_1),
                        k_2 * np.sin(theta_1) + k_1 * np.cos(theta_1),
                    ],
                    "sine and cosine are exchanged: at θ_1 = 0 it must be (k_1, k_2)",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, k_1, k_2: [k_1 * np.cos(theta_1), k_1 * np.sin(theta_1)],
                    "the terms of k_2 are missing: the elbow is bent",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, k_1, k_2: collected(theta_1, k_2, k_1),
                    "k_1 and k_2 are exchanged",
                    own=True,
                ),
                Wrong(COLLECTED.replace("- k_2", "+ k_2"), "sign"),
            ),
        ),
        Task(
            name="amplitude",
            title="Document 004: amplitude and phase",
            text="The document writes $k_1 = r\\cos\\alpha$ and $k_2 = r\\sin\\alpha$. Write $r > 0$ and $\\alpha$ (2 rows) in `k_1`, `k_2`.",
            asks=Formula(
                AMPLITUDE,
                ("k_1", "k_2"),
                given={"k_1": r"\rho\cos(3\gamma)", "k_2": r"\rho\sin(3\gamma)"},
                symbols={"rho": "free", "gamma": "free"},
            ),
            hints=(
                "$r$ and $\\alpha$ are length and angle of the vector $(k_1, k_2)$.",
                "Square both and add for $r$.",
                "The angle in all quadrants: atan2, with what has the sine first.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Square both and add: the angle goes.",
                        "k_1^2 + k_2^2 = r^2",
                    ),
                    Line(
                        "The amplitude is positive.",
                        r"r = \sqrt{k_1^2 + k_2^2}",
                    ),
                    Line(
                        "The quotient alone leaves two angles, half a turn apart.",
                        r"\frac{k_2}{k_1} = \tan\alpha",
                    ),
                    Line(
                        "atan2 of both, the one with the sine first, has the quadrant too.",
                        r"\alpha = \text{atan2}(k_2, k_1)",
                    ),
                ),
                {"symbols": {"rho": "free", "gamma": "free"}},
                given=(
                    r"r = \rho",
                    r"\alpha = \gamma",
                    r"k_1 = r\cos\alpha",
                    r"k_2 = r\sin\alpha",
                ),
            ),
            right=(amplitude, AMPLITUDE, WithSympy(_amplitude_sympy)),
            wrong=(
                Wrong(
                    lambda k_1, k_2: [np.sqrt(k_1**2 + k_2**2), np.arctan2(k_1, k_2)],
                    "the arguments of atan2 are exchanged: the sine, k_2, is first",
                    own=True,
                ),
                Wrong(
                    lambda k_1, k_2: [np.sqrt(k_1**2 + k_2**2), np.arctan(k_2 / k_1)],
                    "arctan of a quotient loses the quadrant, and k_1 can be negative: take atan2",
                    own=True,
                ),
                Wrong(
                    lambda k_1, k_2: [k_1**2 + k_2**2, np.arctan2(k_2, k_1)],
                    "this is r squared: take the root",
                    own=True,
                ),
                Wrong(
                    lambda k_1, k_2: [np.arctan2(k_2, k_1), np.sqrt(k_1**2 + k_2**2)],
                    "the rows are exchanged: r is first",
                    own=True,
                ),
            ),
        ),
        Task(
            name="second_posture",
            title="Document 004: the second posture",
            text="Links $a_1 = 0.48$ m and $a_2 = 0.2$ m, target $X = 0.52$ m, $Y = 0$, $\\psi = 0$. One posture has $\\theta_2 = +\\pi/2$ and $\\theta_1 ="
            " -\\text{atan2}(0.2, 0.48)$. Give $[\\theta_1, \\theta_2, \\theta_4]$ of the other, in radians.",
            asks=Number(
                (BEND, -np.pi / 2, BEND - np.pi / 2),
                unit="rad",
                labels=("θ_1", "θ_2", "θ_4"),
                steps=(r"\theta_1 = \text{atan2}(0.2, 0.48)", r"\theta_2 = -\pi/2", r"\theta_4 = \theta_1 + \theta_2"),
                beside=(r"\arctan 0.2", r"\arcsin 0.2", r"\arcsin(0.2/0.48)", r"\arccos(0.2/0.48)"),
            ),
            hints=(
                "The other sign of the arccos.",
                "Then $k_2$ changes its sign, and so does $\\text{atan2}(k_2, k_1)$.",
                "$\\theta_4 = \\theta_1 + \\theta_2 - \\psi$, with the new values.",
            ),
            right=(
                [BEND, -np.pi / 2, BEND - np.pi / 2],
                np.array([BEND, -np.pi / 2, BEND - np.pi / 2]),
                (np.arcsin(5 / 13), -np.arccos(0), np.arcsin(5 / 13) - np.arccos(0)),
            ),
            wrong=(
                Wrong([-BEND, -np.pi / 2, -BEND - np.pi / 2], "θ_1 changes as well: k_2 has the other sign", own=True),
                Wrong([-BEND, np.pi / 2, np.pi / 2 - BEND], "this is the posture that is given", own=True),
                Wrong(
                    [BEND, -np.pi / 2, np.pi / 2 - BEND],
                    "θ_4 = θ_1 + θ_2 − ψ has the new values: its sign is wrong",
                    own=True,
                ),
                Wrong(
                    list(np.degrees([BEND, -np.pi / 2, BEND - np.pi / 2])),
                    "these are degrees: the answer is in radians",
                    own=True,
                ),
                Wrong(
                    [BEND, np.pi / 2, BEND + np.pi / 2],
                    "θ_2 changes its sign too: that is what the other posture is",
                    own=True,
                ),
            ),
        ),
        Task(
            name="upright_inverse",
            title="Document 001: the inverse of its SCARA",
            text="Now alone. Document 001's SCARA has $x = a_2 C_1 + a_3 C_{12}$, $y = a_2 S_1 + a_3 S_{12}$, $z = -d_2$ and the angle $\\phi = \\theta_1 +"
            " \\theta_2 + \\theta_4$. Write `inverse(x, y, z, phi, a_2, a_3)`: $[\\theta_1, \\theta_2, d_2, \\theta_4]$ of the posture with $0 \\le \\theta_2 \\le"
            " \\pi$.",
            asks=Formula(INVERSE, ("x", "y", "z", "phi", "a_2", "a_3"), arm=UP, given=_GIVEN),
            hints=(
                "The slide stands alone in one equation.",
                "Elbow by the law of cosines, shoulder by atan2 less the angle that the elbow adds: as in document 004, with other letters.",
                "All axes point up here: $\\theta_4 = \\phi - \\theta_1 - \\theta_2$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The slide stands alone in one equation.",
                        "d_2 = -z",
                    ),
                    Line(
                        "Square the other two and add: the elbow's cosine; call it $D$.",
                        r"\cos\theta_2 = \frac{x^2 + y^2 - a_2^2 - a_3^2}{2 a_2 a_3}",
                    ),
                    Line(
                        "Between $0$ and $\\pi$ an angle is the arccosine of its cosine.",
                        r"\theta_2 = \arccos D",
                    ),
                    Line(
                        "Its sine is not negative there.",
                        r"\sin\theta_2 = \sqrt{1 - D^2}",
                    ),
                    Line(
                        "With $k_1 = a_2 + a_3 D$ and $k_2 = a_3\\sqrt{1 - D^2}$ the shoulder turns $(k_1, k_2)$ to $(x, y)$.",
                        r"\begin{bmatrix} x \\ y \end{bmatrix} = \begin{bmatrix} \cos\theta_1 & -\sin\theta_1 \\ \sin\theta_1 & \cos\theta_1 \end{bmatrix} \begin{bmatrix} k_1 \\ k_2 \end{bmatrix}",
                    ),
                    Line(
                        "So $\\theta_1$ is the angle of one less that of the other.",
                        r"\theta_1 = \text{atan2}(y, x) - \text{atan2}(k_2, k_1)",
                    ),
                    Line(
                        "All axes point up: the three angles add up to $\\phi$.",
                        r"\theta_4 = \phi - \theta_1 - \theta_2",
                    ),
                ),
                {
                    "symbols": {
                        "a_2": "free",
                        "a_3": "free",
                        "l": "free",
                        "beta": "free",
                        "gamma": "free",
                        "delta": "free",
                    }
                },
                given=(
                    r"\theta_2 = 2 \arctan l",
                    r"\theta_1 = \beta",
                    r"\theta_4 = \gamma",
                    r"d_2 = \delta",
                    r"x = a_2 \cos\theta_1 + a_3 \cos(\theta_1 + \theta_2)",
                    r"y = a_2 \sin\theta_1 + a_3 \sin(\theta_1 + \theta_2)",
                    "z = -d_2",
                    r"\phi = \theta_1 + \theta_2 + \theta_4",
                    r"D = \frac{x^2 + y^2 - a_2^2 - a_3^2}{2 a_2 a_3}",
                    "k_1 = a_2 + a_3 D",
                    r"k_2 = a_3 \sqrt{1 - D^2}",
                ),
            ),
            right=(inverse, INVERSE, _inverse_with_tangent),
            wrong=(
                Wrong(
                    _spoiled(lambda q, x, y, z, phi: [*q[:3], q[0] + q[1] - phi]),
                    "this is document 004's wrist, with the tool down: here φ is the sum of all three",
                    own=True,
                ),
                Wrong(
                    _spoiled(lambda q, x, y, z, phi: [*q[:2], z, q[3]]),
                    "z = −d_2: the slide has the other sign",
                    own=True,
                ),
                Wrong(
                    _spoiled(lambda q, x, y, z, phi: [np.arctan2(y, x), *q[1:]]),
                    "the direction of the target is not θ_1 yet: the bent elbow adds the angle atan2(k_2, k_1)",
                    own=True,
                ),
                Wrong(
                    _spoiled(
                        lambda q, x, y, z, phi: [
                            2 * np.arctan2(y, x) - q[0],
                            -q[1],
                            q[2],
                            phi - 2 * np.arctan2(y, x) + q[0] + q[1],
                        ]
                    ),
                    "this is the other posture, with θ_2 below zero: a solution, but not the one asked for",
                    own=True,
                ),
                Wrong(_spoiled(lambda q, x, y, z, phi: q[:3]), "three joint values: θ_4 is missing", own=True),
            ),
        ),
        Task(
            name="principle",
            title="Document 004, 3.1: the principle",
            text="Which sentences belong in an explanation of the trajectory of degree five? `a`: positions alone give a straight line in time;"
            " `b`: position, velocity and acceleration at both ends are six conditions; `c`: a polynomial of degree five has six coefficients;"
            " `d`: the polynomial is the fastest motion that there is; `e`: each joint needs the others' coefficients. Give a list.",
            asks=Choice(
                {
                    "a": "a straight line",
                    "b": "six conditions",
                    "c": "six coefficients",
                    "d": "the fastest motion",
                    "e": "the others' coefficients",
                },
                right=frozenset({"a", "b", "c"}),
                because={
                    "d": "the polynomial is smooth, not fastest: it takes about twice the peak velocity of the straight line",
                    "e": "each joint has its own six equations: q_i(t) stands alone",
                },
                missing={
                    "a": "why is a higher degree needed at all? Say what positions alone give",
                    "b": "where does the number of equations come from?",
                    "c": "why degree five, and not four or six? Count the unknowns",
                },
            ),
            hints=(
                "An explanation says what fails without it, how many conditions there are, and how many unknowns.",
                "Conditions and unknowns must be equally many.",
                "Three of the five.",
            ),
            right=(["a", "b", "c"], "a, b, c", {"c", "b", "a"}),
            wrong=(
                Wrong(["b", "c"], "what positions alone give"),
                Wrong(["a", "c"], "number of equations"),
                Wrong(["a", "b"], "Count the unknowns"),
                Wrong(["a", "b", "c", "d"], "smooth, not fastest"),
                Wrong(["a", "b", "c", "e"], "stands alone"),
            ),
        ),
        Task(
            name="rest",
            title="Document 004, 3.2: from rest to rest",
            text="Why are velocity and acceleration zero at both ends? `a`: the robot stands still before and after, and a velocity cannot jump;"
            " `b`: a jump of the velocity would need an infinite acceleration; `c`: a jump of the acceleration is a jump of the motors' torque;"
            " `d`: the velocity is zero during the whole motion; `e`: without it there are more equations than unknowns. Give a list.",
            asks=Choice(
                {
                    "a": "a velocity cannot jump",
                    "b": "an infinite acceleration",
                    "c": "a jump of the torque",
                    "d": "zero during the whole motion",
                    "e": "more equations than unknowns",
                },
                right=frozenset({"a", "b", "c"}),
                because={
                    "d": "then nothing would move: velocity and acceleration vary on the way",
                    "e": "six equations with other values at the ends are as solvable",
                },
                missing={
                    "a": "start with what the robot does before and after",
                    "b": "what would a jump of the velocity cost?",
                    "c": "the acceleration is asked to be zero as well: what would its jump do?",
                },
            ),
            hints=(
                "Separate two questions: why the velocity, and why the acceleration?",
                "The motors give accelerations. What can they not give?",
                "Three of the five.",
            ),
            right=(["a", "b", "c"], "a, b, c", {"c", "b", "a"}),
            wrong=(
                Wrong(["b", "c"], "before and after"),
                Wrong(["a", "c"], "cost"),
                Wrong(["a", "b"], "what would its jump do"),
                Wrong(["a", "b", "c", "d"], "nothing would move"),
                Wrong(["a", "e"], "as solvable"),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A SCARA of another order: the slide comes first and lifts the arms by $d_1$, then joints 2 and 3 turn, arms $b$ and $c$ long, and the gripper points"
            " down: modified rows $(0, 0, d_1, 0)$, $(0, 0, 0, \\theta_2)$, $(0, b, 0, \\theta_3)$, $(\\pi, c, 0, 0)$. Write ${}^0T_4$, 4×4. A function takes `q` ="
            " $[d_1, \\theta_2, \\theta_3]$, `b`, `c`.",
            asks=Quantity(LIFT, {"pose": 4}),
            hints=(
                "Two turns about parallel axes add up: $\\theta_2 + \\theta_3$.",
                "The last row is constant: half a turn about $x$ changes the signs of the columns $y$ and $z$.",
                "The origin: $b$ in the direction $\\theta_2$, $c$ in the direction $\\theta_2 + \\theta_3$, at the height $d_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The slide lifts, then $\\theta_2$ turns.",
                        r"{}^0T_2 = \begin{bmatrix} C_2 & -S_2 & 0 & 0 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 1 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "$b$ along the first arm, then $\\theta_3$: the axes are parallel, the angles add up.",
                        r"{}^0T_3 = \begin{bmatrix} C_{23} & -S_{23} & 0 & b C_2 \\ S_{23} & C_{23} & 0 & b S_2 \\ 0 & 0 & 1 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The last row: $c$ along the second arm, and half a turn about it.",
                        r"{}^3T_4 = \begin{bmatrix} 1 & 0 & 0 & c \\ 0 & -1 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply: the half turn changes the signs of the columns $y$ and $z$.",
                        r"{}^0T_3 {}^3T_4 = \begin{bmatrix} C_{23} & S_{23} & 0 & b C_2 + c C_{23} \\ S_{23} & -C_{23} & 0 & b S_2 + c S_{23} \\ 0 & 0 & -1 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": LIFT},
            ),
            right=(lift, LIFT_POSE, WithSympy(_lift_sympy)),
            wrong=(
                Wrong(
                    lambda q, b, c: lift(q, b, c) @ np.diag([1, -1, -1, 1]),
                    "the gripper points up: the half turn of the last row is missing",
                    own=True,
                ),
                Wrong(LIFT_POSE.replace("d_1", "-d_1"), "entry (3, 4): wrong sign"),
                Wrong(lambda q, b, c: lift(q, c, b), "swapped"),
                Wrong(
                    lambda q, b, c: lift([q[0], q[1], q[2] - q[1]], b, c),
                    "θ_3 is counted from the first arm: the second one stands at θ_2 + θ_3",
                    own=True,
                ),
                Wrong(lambda q, b, c: lift([q[0], *np.deg2rad(q[1:])], b, c), "degrees"),
            ),
        ),
    ),
)
