"""Tasks of lesson 11, the spatial RRR arm: the exercise left open in document 002, both readings of its tool point."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Quantity, Task, WithSympy, Wrong
from armproof.course.links import shift, turn


def elbow(q, l_1, l_2):
    """Return p_3, the last column of T_0^1 T_1^2 T_2^3: T_2^3 adds nothing to it."""
    return np.array([l_2 * np.cos(q[0]) * np.cos(q[1]), l_2 * np.sin(q[0]) * np.cos(q[1]), l_1 + l_2 * np.sin(q[1])])


def elbow_linear(q, l_2):
    """Return the derivatives of p_3; θ_3 is not in it."""
    s1, c1, s2, c2 = np.sin(q[0]), np.cos(q[0]), np.sin(q[1]), np.cos(q[1])
    return np.array([[-l_2 * s1 * c2, -l_2 * c1 * s2, 0], [l_2 * c1 * c2, -l_2 * s1 * s2, 0], [0, l_2 * c2, 0]])


def axis(q):
    """Return z_3, the third column of the product."""
    return np.array([np.cos(q[0]) * np.sin(q[1] + q[2]), np.sin(q[0]) * np.sin(q[1] + q[2]), -np.cos(q[1] + q[2])])


def point(q, l_1, l_2, l_3):
    """Return P = p_3 + l_3 z_3."""
    return elbow(q, l_1, l_2) + l_3 * axis(q)


def jacobian(q, l_2, l_3):
    """Return J of P: columns 2 and 3 turn about the same direction, [S1, −C1, 0]."""
    s1, c1, s23, c23 = np.sin(q[0]), np.cos(q[0]), np.sin(q[1] + q[2]), np.cos(q[1] + q[2])
    reach, rise = l_2 * np.cos(q[1]) + l_3 * s23, -l_2 * np.sin(q[1]) + l_3 * c23
    return np.array([
        [-s1 * reach, c1 * rise, l_3 * c1 * c23],
        [c1 * reach, s1 * rise, l_3 * s1 * c23],
        [0, reach, l_3 * s23],
        [0, s1, s1],
        [0, -c1, -c1],
        [1, 0, 0],
    ])  # fmt: skip


def determinant(theta_2, theta_3, l_2, l_3):
    """Return det J_L: bent at the elbow, and away from axis 1."""
    return l_2 * l_3 * np.cos(theta_3) * (l_2 * np.cos(theta_2) + l_3 * np.sin(theta_2 + theta_3))


ELBOW = r"\begin{bmatrix} l_2 C_1 C_2 \\ l_2 S_1 C_2 \\ l_1 + l_2 S_2 \end{bmatrix}"
ELBOW_LINEAR = r"\begin{bmatrix} -l_2 S_1 C_2 & -l_2 C_1 S_2 & 0 \\ l_2 C_1 C_2 & -l_2 S_1 S_2 & 0 \\ 0 & l_2 C_2 & 0 \end{bmatrix}"
AXIS = r"\begin{bmatrix} C_1 S_{23} \\ S_1 S_{23} \\ -C_{23} \end{bmatrix}"
POINT = r"\begin{bmatrix} C_1(l_2 C_2 + l_3 S_{23}) \\ S_1(l_2 C_2 + l_3 S_{23}) \\ l_1 + l_2 S_2 - l_3 C_{23} \end{bmatrix}"
JACOBIAN = r"""\begin{bmatrix} -S_1(l_2 C_2 + l_3 S_{23}) & C_1(-l_2 S_2 + l_3 C_{23}) & l_3 C_1 C_{23} \\
C_1(l_2 C_2 + l_3 S_{23}) & S_1(-l_2 S_2 + l_3 C_{23}) & l_3 S_1 C_{23} \\ 0 & l_2 C_2 + l_3 S_{23} & l_3 S_{23} \\
0 & S_1 & S_1 \\ 0 & -C_1 & -C_1 \\ 1 & 0 & 0 \end{bmatrix}"""


def _symbols(sp):
    return sp.symbols("theta_1 theta_2 theta_3 l_1 l_2 l_3")


def _transforms_sympy(sp):
    t1, t2, t3, l1, l2, _ = _symbols(sp)
    first = shift(sp, z=l1) * turn(sp, "z", t1) * turn(sp, "x", sp.pi / 2)
    return first * turn(sp, "z", t2) * shift(sp, x=l2) * turn(sp, "z", t3) * turn(sp, "x", sp.pi / 2)


def _point_sympy(sp):
    return (_transforms_sympy(sp) * sp.Matrix([0, 0, _symbols(sp)[5], 1]))[:3, 0]


def _linear_sympy(sp):
    return _point_sympy(sp).jacobian(_symbols(sp)[:3])


def _jacobian_sympy(sp):
    t1 = _symbols(sp)[0]
    return _linear_sympy(sp).col_join(
        sp.Matrix([[0, sp.sin(t1), sp.sin(t1)], [0, -sp.cos(t1), -sp.cos(t1)], [1, 0, 0]])
    )


def _crossed(q, l_1, l_2, l_3):
    z_0, z_1 = np.array([0, 0, 1]), np.array([np.sin(q[0]), -np.cos(q[0]), 0])
    P = point(q, l_1, l_2, l_3)
    vectors = [(z_0, P), (z_1, P - np.array([0, 0, l_1])), (z_1, P - elbow(q, l_1, l_2))]
    return np.column_stack([np.concatenate([np.cross(z, vector), z]) for z, vector in vectors])


def _expanded(theta_2, theta_3, l_2, l_3):
    sine = np.sin(theta_2) * np.cos(theta_3) + np.cos(theta_2) * np.sin(theta_3)
    return l_2**2 * l_3 * np.cos(theta_2) * np.cos(theta_3) + l_2 * l_3**2 * np.cos(theta_3) * sine


def _point_along_x(q, l_1, l_2, l_3):
    x_3 = np.array([np.cos(q[0]) * np.cos(q[1] + q[2]), np.sin(q[0]) * np.cos(q[1] + q[2]), np.sin(q[1] + q[2])])
    return elbow(q, l_1, l_2) + l_3 * x_3


def _all_about_z(q, l_2, l_3):
    wrong = jacobian(q, l_2, l_3)
    wrong[3:] = [[0, 0, 0], [0, 0, 0], [1, 1, 1]]
    return wrong


def _axis_turned(q, l_2, l_3):
    wrong = jacobian(q, l_2, l_3)
    wrong[:, 1:] = -wrong[:, 1:]
    return wrong


def _same_column(q, l_2, l_3):
    wrong = jacobian(q, l_2, l_3)
    wrong[:, 2] = wrong[:, 1]
    return wrong


def _of_the_elbow(q, l_2):
    return jacobian(q, l_2, 0)


def turret(theta_2, d_3):
    """Return det J_L of the turret's ram: nothing turns it at d_3 = 0, and upright joint 1 does not move it."""
    return d_3**2 * np.cos(theta_2)


def _turret_sympy(sp):
    t1, t2, d3 = sp.symbols("theta_1 theta_2 d_3")
    end = d3 * sp.Matrix([sp.cos(t1) * sp.cos(t2), sp.sin(t1) * sp.cos(t2), sp.sin(t2)])
    return sp.simplify(end.jacobian([t1, t2, d3]).det())


LESSON = Lesson(
    number=11,
    name="spatial_rrr",
    title="Spatial RRR: an exercise left open",
    source="Modélisation et commande des robots de manipulation, chapter 3, exercise, Université de Constantine 1 (document 002)",
    objectives=(
        "Read off link transforms which point they lead to, and see that the exercise leaves its tool point open.",
        "Work out position and Jacobian of an arm whose axes are not all parallel.",
        "Find its singular configurations from the factors of one determinant.",
    ),
    tasks=(
        Task(
            name="prediction",
            title="Predict what joint 3 moves",
            text="Look at the last transform, $T_2^3$. Joint 3 turns alone. What does the origin of frame 3 do? Give one key: `rest`, `circle`, `shoulder` or `line`.",
            asks=Choice(
                {
                    "rest": "it rests",
                    "circle": "it runs on a circle about axis 3",
                    "shoulder": "it runs on a circle about axis 2",
                    "line": "it runs along a line",
                },
                "rest",
                because={
                    "circle": "its distance from axis 3 would have to be in the last column of T_2^3: look at the entries there",
                    "line": "a revolute joint moves nothing along a line",
                    "shoulder": "joint 2 is at rest: whatever moves, moves about axis 3",
                },
            ),
            hints=(
                "The last column of a transform is where the new origin sits in the frame before.",
                "The last column of $T_2^3$ is $[0, 0, 0, 1]^T$: frames 2 and 3 have one origin.",
                "Frame 2 is before joint 3, so nothing that joint 3 does moves its origin.",
            ),
            right=("rest", ["rest"], {"rest"}),
            wrong=(
                Wrong("circle", "the last column of T_2^3"),
                Wrong("line", "moves nothing along a line"),
                Wrong(["shoulder"], "joint 2 is at rest"),
                Wrong(["rest", "circle"], "one of them is asked for"),
            ),
        ),
        Task(
            name="elbow",
            title="The first reading: the origin of frame 3",
            text="Write $p_3$, the origin of frame 3 in frame 0 (3 rows, m), in $\\theta_1, \\theta_2, \\theta_3$ and $l_1, l_2$. A function takes the joint vector `q` and, by their "
            "names, the lengths that it needs.",
            asks=Quantity("spatial_rrr", {"origin": 3}),
            hints=(
                "It is the last column of $T_0^1 T_1^2 T_2^3$, and $T_2^3$ leaves that column as it is.",
                "So multiply $T_0^1$ by the last column of $T_1^2$, $[l_2 C_2, l_2 S_2, 0, 1]^T$.",
                "Rows 1 and 2 are $l_2 C_2$ times $C_1$ and $S_1$; row 3 is the height of the shoulder plus $l_2 S_2$.",
            ),
            right=(elbow, WithSympy(lambda sp: _transforms_sympy(sp)[:3, 3]), ELBOW),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} l_2 C_{12} \\ l_2 S_{12} \\ l_1 \end{bmatrix}",
                    "that is a planar arm: axes 1 and 2 are not parallel here, so that θ_1 and θ_2 do not add",
                    own=True,
                ),
                Wrong(ELBOW.replace("l_1 + l_2 S_2", "l_2 S_2"), "l_1 is missing"),
                Wrong(
                    r"\begin{bmatrix} l_2 C_1 S_2 \\ l_2 S_1 S_2 \\ l_1 + l_2 C_2 \end{bmatrix}",
                    "sine and cosine of θ_2 are swapped: at θ_2 = 0 the upper arm is horizontal",
                    own=True,
                ),
                Wrong(ELBOW.replace("l_1 + l_2 S_2", "l_1 - l_2 S_2"), "wrong sign"),
                Wrong(
                    r"\begin{bmatrix} l_2 C_2 \\ l_2 S_2 \\ 0 \end{bmatrix}",
                    "that is in frame 1: multiply by T_0^1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="elbow_linear",
            title="Its linear Jacobian",
            text="Write the derivatives of $p_3$, 3×3, column $i$ with respect to $\\theta_i$. Letters: $l_2$. A function takes `q` and, by their names, the "
            "lengths that it needs.",
            asks=Quantity("spatial_rrr", {"jacobian": 3, "rows": [1, 2, 3]}),
            hints=(
                "Differentiate the three rows of $p_3$ one joint at a time.",
                "$\\theta_3$ does not occur in $p_3$. What is its column?",
                "Column 2: $C_2$ becomes $-S_2$, $S_2$ becomes $C_2$, and $C_1$, $S_1$ stay. Column 3 is zero.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "By $\\theta_1$: the first two rows change.",
                        r"\frac{\partial p_3}{\partial \theta_1} = \begin{bmatrix} -l_2 S_1 C_2 \\ l_2 C_1 C_2 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "By $\\theta_2$: all three rows.",
                        r"\frac{\partial p_3}{\partial \theta_2} = \begin{bmatrix} -l_2 C_1 S_2 \\ -l_2 S_1 S_2 \\ l_2 C_2 \end{bmatrix}",
                    ),
                    Line(
                        "By $\\theta_3$: it is in none.",
                        r"\frac{\partial p_3}{\partial \theta_3} = \begin{bmatrix} 0 \\ 0 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "The three columns.",
                        r"J_L = \begin{bmatrix} -l_2 S_1 C_2 & -l_2 C_1 S_2 & 0 \\ l_2 C_1 C_2 & -l_2 S_1 S_2 & 0 \\ 0 & l_2 C_2 & 0 \end{bmatrix}",
                    ),
                ),
                {"arm": "spatial_rrr", "quantities": {"J_L": {"jacobian": 3, "rows": [1, 2, 3]}}},
            ),
            right=(
                elbow_linear,
                WithSympy(lambda sp: _transforms_sympy(sp)[:3, 3].jacobian(_symbols(sp)[:3])),
                ELBOW_LINEAR,
            ),
            wrong=(
                Wrong(ELBOW_LINEAR.replace("-l_2 C_1 S_2", "l_2 C_1 S_2"), "wrong sign"),
                Wrong(ELBOW_LINEAR.replace("-l_2 S_1 C_2", "l_2 S_1 C_2"), "wrong sign"),
                Wrong(lambda q, l_2: elbow_linear(q, l_2).T, "transposed"),
                Wrong(
                    lambda q, l_2: np.column_stack([elbow_linear(q, l_2)[:, [0, 1]], elbow_linear(q, l_2)[:, 1]]),
                    "column 3 repeats column 2: p_3 does not depend on θ_3",
                    own=True,
                ),
                Wrong(lambda q, l_2: elbow_linear(np.deg2rad(q), l_2), "degrees"),
            ),
        ),
        Task(
            name="axis",
            title="The third axis of frame 3",
            text="For the second reading you need $z_3$, the third column of $T_0^3$, without its last element (3 rows), in $\\theta_1, \\theta_2, \\theta_3$.",
            asks=Quantity("spatial_rrr", {"axis": 3}),
            hints=(
                "Multiply $T_0^1 T_1^2$ by the third column of $T_2^3$, $[S_3, -C_3, 0, 0]^T$.",
                "$C_2 S_3 + S_2 C_3 = S_{23}$ and $S_2 S_3 - C_2 C_3 = -C_{23}$.",
                "In the vertical plane of the arm $z_3$ is $[S_{23}, -C_{23}]$; $\\theta_1$ turns that plane.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The third column of $T_2^3$: the axis in frame 2.",
                        r"T_2^3 \begin{bmatrix} 0 \\ 0 \\ 1 \\ 0 \end{bmatrix} = \begin{bmatrix} S_3 \\ -C_3 \\ 0 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "$T_1^2$ turns it by $\\theta_2$.",
                        r"T_1^3 \begin{bmatrix} 0 \\ 0 \\ 1 \\ 0 \end{bmatrix} = \begin{bmatrix} C_2 S_3 + S_2 C_3 \\ S_2 S_3 - C_2 C_3 \\ 0 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Sine and cosine of a sum.",
                        r"\begin{bmatrix} C_2 S_3 + S_2 C_3 \\ S_2 S_3 - C_2 C_3 \end{bmatrix} = \begin{bmatrix} S_{23} \\ -C_{23} \end{bmatrix}",
                    ),
                    Line(
                        "$T_0^1$ stands that plane upright and turns it by $\\theta_1$.",
                        r"z_3 = \begin{bmatrix} C_1 S_{23} \\ S_1 S_{23} \\ -C_{23} \end{bmatrix}",
                    ),
                ),
                {"arm": "spatial_rrr", "transforms": "lower"},
            ),
            right=(
                axis,
                WithSympy(lambda sp: _transforms_sympy(sp)[:3, 2]),
                AXIS,
                r"\begin{bmatrix} C_1(S_2C_3 + C_2S_3) \\ S_1(S_2C_3 + C_2S_3) \\ S_2S_3 - C_2C_3 \end{bmatrix}",
            ),
            wrong=(
                Wrong(AXIS.replace("-C_{23}", "C_{23}"), "wrong sign"),
                Wrong(
                    r"\begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix}",
                    "that is z_2, the axis of joint 3; z_3 is across it",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_1 C_{23} \\ S_1 C_{23} \\ S_{23} \end{bmatrix}",
                    "that is x_3, the first column",
                    own=True,
                ),
                Wrong(AXIS.replace("{23}", "3"), "theta_2 is missing"),
                Wrong(
                    r"\begin{bmatrix} S_3 \\ -C_3 \\ 0 \end{bmatrix}",
                    "that is in frame 2: multiply by T_0^1 T_1^2",
                    own=True,
                ),
            ),
        ),
        Task(
            name="point",
            title="The second reading: a point beyond the elbow",
            text="Write $P = p_3 + l_3 z_3$ in frame 0 (3 rows, m). Letters: $l_1, l_2, l_3$. A function takes `q` and, by their names, the lengths that it needs.",
            asks=Quantity("spatial_rrr", {"origin": "P"}),
            hints=(
                "You have both parts.",
                "Add them row by row; $C_1$ and $S_1$ can be taken out of rows 1 and 2.",
                "The reach in the arm's plane is $l_2 C_2 + l_3 S_{23}$, the height $l_1 + l_2 S_2 - l_3 C_{23}$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The elbow.", r"p_3 = \begin{bmatrix} l_2 C_1 C_2 \\ l_2 S_1 C_2 \\ l_1 + l_2 S_2 \end{bmatrix}"
                    ),
                    Line(
                        "The axis of the forearm.",
                        r"z_3 = \begin{bmatrix} C_1 S_{23} \\ S_1 S_{23} \\ -C_{23} \end{bmatrix}",
                    ),
                    Line(
                        "From the elbow $l_3$ along it.",
                        r"p_3 + l_3 z_3 = \begin{bmatrix} C_1(l_2 C_2 + l_3 S_{23}) \\ S_1(l_2 C_2 + l_3 S_{23}) \\ l_1 + l_2 S_2 - l_3 C_{23} \end{bmatrix}",
                    ),
                ),
                {"arm": "spatial_rrr"},
            ),
            right=(point, WithSympy(_point_sympy), POINT),
            wrong=(
                Wrong(_point_along_x, "that goes along x_3: the reading takes l_3 along z_3", own=True),
                Wrong(ELBOW, "that is the elbow, the first reading: P lies l_3 beyond it", own=True),
                Wrong(POINT.replace("- l_3 C_{23}", "+ l_3 C_{23}"), "wrong sign"),
                Wrong(POINT.replace("{23}", "3"), "theta_3 is taken as an absolute angle"),
                Wrong(lambda q, l_1, l_2, l_3: point(q, l_1, l_3, l_2), "swapped"),
                Wrong(
                    lambda q, l_1, l_2, l_3: elbow(q, l_1, l_2) - l_3 * axis(q),
                    "that goes the other way: l_3 counts along z_3, not against it",
                    own=True,
                ),
            ),
        ),
        Task(
            name="jacobian",
            title="The Jacobian of the point",
            text="Write $J$ of $P$: 6×3, rows $[v;\\ \\omega]$ in frame 0. Letters: $l_1, l_2, l_3$. A function takes `q` and, by their names, the lengths that it needs.",
            asks=Quantity("spatial_rrr", {"jacobian": "P"}),
            hints=(
                "$z_0$ is vertical; $z_1 = z_2$ is the third column of $T_0^1$. The angular half is done with that.",
                "The linear half: derivatives of $P$, or $z_{i-1} \\times (P - p_{i-1})$ with $p_0 = 0$, $p_1 = [0, 0, l_1]^T$, $p_2$ the elbow.",
                "With $\\rho = l_2 C_2 + l_3 S_{23}$: column 1 is $[-S_1\\rho, C_1\\rho, 0]$, row 3 is $[0, \\rho, l_3 S_{23}]$; the rest are derivatives of $\\rho$ times $C_1$, $S_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The axes: $z_0$ is vertical, the other two are level and parallel.",
                        r"z_0 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}, \qquad z_1 = z_2 = \begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "The point, from the task before.",
                        r"P = \begin{bmatrix} C_1(l_2 C_2 + l_3 S_{23}) \\ S_1(l_2 C_2 + l_3 S_{23}) \\ l_1 + l_2 S_2 - l_3 C_{23} \end{bmatrix}",
                    ),
                    Line(
                        "Column 1: the cross product of $z_0$ and the whole $P$.",
                        r"z_0 \times P = \begin{bmatrix} -S_1(l_2 C_2 + l_3 S_{23}) \\ C_1(l_2 C_2 + l_3 S_{23}) \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 2: the lever begins at the shoulder, $p_1 = [0, 0, l_1]^T$.",
                        r"z_1 \times (P - p_1) = \begin{bmatrix} C_1(-l_2 S_2 + l_3 C_{23}) \\ S_1(-l_2 S_2 + l_3 C_{23}) \\ l_2 C_2 + l_3 S_{23} \end{bmatrix}",
                    ),
                    Line(
                        "Column 3: the lever begins at the elbow; it is the forearm alone.",
                        r"P - p_2 = \begin{bmatrix} l_3 C_1 S_{23} \\ l_3 S_1 S_{23} \\ -l_3 C_{23} \end{bmatrix}",
                    ),
                    Line(
                        "The cross product with the axis.",
                        r"z_2 \times (P - p_2) = \begin{bmatrix} l_3 C_1 C_{23} \\ l_3 S_1 C_{23} \\ l_3 S_{23} \end{bmatrix}",
                    ),
                    Line(
                        "The three columns, each with its axis below.",
                        r"J = \begin{bmatrix} -S_1(l_2 C_2 + l_3 S_{23}) & C_1(-l_2 S_2 + l_3 C_{23}) & l_3 C_1 C_{23} \\ C_1(l_2 C_2 + l_3 S_{23}) & S_1(-l_2 S_2 + l_3 C_{23}) & l_3 S_1 C_{23} \\ 0 & l_2 C_2 + l_3 S_{23} & l_3 S_{23} \\ 0 & S_1 & S_1 \\ 0 & -C_1 & -C_1 \\ 1 & 0 & 0 \end{bmatrix}",
                    ),
                ),
                {"arm": "spatial_rrr", "quantities": {"P": {"origin": "P"}, "J": {"jacobian": "P"}}},
            ),
            right=(jacobian, WithSympy(_jacobian_sympy), JACOBIAN, _crossed),
            wrong=(
                Wrong(
                    _all_about_z,
                    "all three axes are taken vertical: z_1 and z_2 are the third column of T_0^1",
                    own=True,
                ),
                Wrong(
                    _axis_turned,
                    "joints 2 and 3 turn the wrong way: compare your z_1 with the third column of T_0^1",
                    own=True,
                ),
                Wrong(
                    _of_the_elbow,
                    "that is the Jacobian of the elbow, the first reading: l_3 does not occur in it",
                    own=True,
                ),
                Wrong(
                    _same_column,
                    "columns 2 and 3 are equal: joint 3 does not move the upper arm, so that l_2 is not in its column",
                    own=True,
                ),
                Wrong(JACOBIAN.replace("-l_2 S_2", "l_2 S_2"), "wrong sign"),
                Wrong(lambda q, l_2, l_3: np.vstack([jacobian(q, l_2, l_3)[3:], jacobian(q, l_2, l_3)[:3]]), "[ω; v]"),
                Wrong(lambda q, l_2, l_3: jacobian(q, l_2, l_3).T, "transposed"),
            ),
        ),
        Task(
            name="determinant",
            title="The determinant of its linear half",
            text="Give $\\det J_L$ of rows 1 to 3, factored if you can. Letters: $\\theta_2, \\theta_3, l_2, l_3$. A function takes `(theta_2, theta_3, l_2, l_3)`.",
            asks=Formula(
                r"\det J_L",
                ("theta_2", "theta_3", "l_2", "l_3"),
                arm="spatial_rrr",
                quantities={"J_L": {"jacobian": "P", "rows": [1, 2, 3]}},
                unit="m³",
            ),
            hints=(
                "It cannot depend on $\\theta_1$, so put $\\theta_1 = 0$.",
                "Then column 1 is $[0, \\rho, 0]^T$ with $\\rho = l_2 C_2 + l_3 S_{23}$: expand along it. Mind the sign of that place.",
                "What is left is $\\rho\\,(l_2 C_2\\, l_3 C_{23} + l_2 S_2\\, l_3 S_{23})$, and $C_2 C_{23} + S_2 S_{23}$ is one cosine.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The linear half at the point $P$.",
                        r"J_L = \begin{bmatrix} -S_1 (l_2 C_2 + l_3 S_{23}) & -C_1 (l_2 S_2 - l_3 C_{23}) & l_3 C_1 C_{23} \\ C_1 (l_2 C_2 + l_3 S_{23}) & -S_1 (l_2 S_2 - l_3 C_{23}) & l_3 S_1 C_{23} \\ 0 & l_2 C_2 + l_3 S_{23} & l_3 S_{23} \end{bmatrix}",
                    ),
                    Line(
                        "Turn the base: at $\\theta_1 = 0$ column 1 has one entry only. Expand along it.",
                        r"\det J_L = -(l_2 C_2 + l_3 S_{23}) \begin{vmatrix} -l_2 S_2 + l_3 C_{23} & l_3 C_{23} \\ l_2 C_2 + l_3 S_{23} & l_3 S_{23} \end{vmatrix}",
                    ),
                    Line(
                        "The products with $l_3^2$ cancel.",
                        r"\begin{vmatrix} -l_2 S_2 + l_3 C_{23} & l_3 C_{23} \\ l_2 C_2 + l_3 S_{23} & l_3 S_{23} \end{vmatrix} = -l_2 l_3 (S_2 S_{23} + C_2 C_{23})",
                    ),
                    Line("A cosine of a difference is left.", r"S_2 S_{23} + C_2 C_{23} = C_3"),
                    Line("Two minus signs make a plus.", r"\det J_L = l_2 l_3 C_3 (l_2 C_2 + l_3 S_{23})"),
                ),
                {"arm": "spatial_rrr", "quantities": {"J_L": {"jacobian": "P", "rows": [1, 2, 3]}}},
            ),
            right=(
                determinant,
                r"l_2 l_3 C_3 (l_2 C_2 + l_3 S_{23})",
                WithSympy(lambda sp: _linear_sympy(sp).det()),
                _expanded,
            ),
            wrong=(
                Wrong(r"-l_2 l_3 C_3 (l_2 C_2 + l_3 S_{23})", "sign"),
                Wrong(
                    r"l_2 l_3 S_3 (l_2 C_2 + l_3 S_{23})",
                    "cosine and sine of θ_3 are swapped: this arm is stretched at θ_3 = 90°, not at 0",
                    own=True,
                ),
                Wrong(
                    r"l_2 l_3 C_3 (l_2 C_2 + l_3 C_{23})",
                    "that has the reach of a point along x_3; P lies along z_3",
                    own=True,
                ),
                Wrong(
                    r"C_3 (l_2 C_2 + l_3 S_{23})",
                    "its unit is m: a determinant of three rows in m has the unit m³",
                    own=True,
                ),
                Wrong(r"l_2 l_3 C_3", "one factor is missing: the distance of P from axis 1", own=True),
                Wrong(r"0", "that is the first reading: the origin of frame 3 does not depend on θ_3", own=True),
            ),
        ),
        Task(
            name="limits",
            title="Stretched, and stretched upright",
            text="Give two ranks of $J_L$ (rows 1 to 3): with the arm stretched, $\\theta_3 = \\pi/2$, at a generic $\\theta_2$; and stretched straight up, $\\theta_2 = \\theta_3 = \\pi/2$.",
            asks=Number((2, 1), labels=("the first rank", "the second rank")),
            hints=(
                "Which factors of the determinant are zero in each of the two?",
                "Stretched, the point cannot move along the arm. Upright, what does joint 1 do to a point on its own axis?",
                "Upright, column 1 is zero and columns 2 and 3 point one way.",
            ),
            right=([2, 1], (2, 1), "2, 1"),
            wrong=(
                Wrong(
                    [2, 2],
                    "upright both factors vanish: the point stands on axis 1, so that joint 1 does not move it either",
                    own=True,
                ),
                Wrong([3, 2], "stretched, the determinant is zero already: C_3 = 0", own=True),
                Wrong([1, 1], "stretched at a generic θ_2, joint 1 still moves the point sideways", own=True),
                Wrong([2, 0], "upright, joints 2 and 3 still move the point, though in one direction only", own=True),
                Wrong([3, 3], "C_3 = 0 in both: the determinant vanishes", own=True),
                Wrong(
                    [2, 3], "upright even more is lost than stretched: both factors of the determinant vanish", own=True
                ),
                Wrong([0, 1], "a determinant of zero takes away one direction, not all", own=True),
                Wrong([3, 1], "stretched, one direction is lost already: the determinant is zero", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A turret turns by $\\theta_1$, rises by $\\theta_2$, and a ram goes out by $d_3$: its end is at"
            " $[d_3 C_1 C_2,\\ d_3 S_1 C_2,\\ h + d_3 S_2]^T$. Give the determinant of its linear Jacobian, 3×3, columns in the order $\\theta_1, \\theta_2, d_3$."
            " A function takes `(theta_2, d_3)`.",
            asks=Formula(r"d_3^2 \cos\theta_2", ("theta_2", "d_3")),
            hints=(
                "Derive the position three times. Turn the base: the determinant does not depend on $\\theta_1$, so take $\\theta_1 = 0$.",
                "At $\\theta_1 = 0$ column 1 is $[0, d_3 C_2, 0]^T$: expand along it.",
                "What is left is $-d_3 C_2$ times a 2×2 determinant, $-d_3 (S_2^2 + C_2^2)$.",
            ),
            right=(turret, r"d_3^2 \cos\theta_2", WithSympy(_turret_sympy)),
            wrong=(
                Wrong("-d_3^2 \\cos\\theta_2", "wrong sign"),
                Wrong("d_3^2 \\sin\\theta_2", "sine for cosine"),
                Wrong(
                    "d_3^2",
                    "upright, θ_2 = π/2, joint 1 does not move the ram's end: the determinant must vanish there",
                    own=True,
                ),
                Wrong(
                    "d_3 \\cos\\theta_2",
                    "both turns have the lever d_3: it stands there twice",
                    own=True,
                ),
                Wrong("\\cos\\theta_2", "the levers are missing: both turns move the end by d_3", own=True),
            ),
            derivation=Derivation(
                (
                    Line(
                        "The derivatives of the position.",
                        r"\frac{\partial}{\partial \theta_2} \begin{bmatrix} d_3 C_1 C_2 \\ d_3 S_1 C_2 \\ h + d_3 S_2 \end{bmatrix} = \begin{bmatrix} -d_3 C_1 S_2 \\ -d_3 S_1 S_2 \\ d_3 C_2 \end{bmatrix}",
                    ),
                    Line(
                        "At $\\theta_1 = 0$ column 1 has one entry: expand along it.",
                        r"\begin{vmatrix} 0 & -d_3 S_2 & C_2 \\ d_3 C_2 & 0 & 0 \\ 0 & d_3 C_2 & S_2 \end{vmatrix} = -d_3 C_2 \begin{vmatrix} -d_3 S_2 & C_2 \\ d_3 C_2 & S_2 \end{vmatrix}",
                    ),
                    Line(
                        "The small determinant.",
                        r"\begin{vmatrix} -d_3 S_2 & C_2 \\ d_3 C_2 & S_2 \end{vmatrix} = -d_3",
                    ),
                    Line("Together.", r"-d_3 C_2 \cdot (-d_3) = d_3^2 C_2"),
                ),
            ),
        ),
    ),
)
