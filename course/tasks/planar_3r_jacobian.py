"""Tasks of lesson 10, the Jacobian of the planar 3R arm by cross products and by derivatives (document 002)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Quantity, Task, WithSympy, Wrong
from armproof.course.tasks.scara_forward import CYLINDRICAL


def lever_2(q, l_2, l_3):
    """Return the vector from the second joint to the gripper: the links that lie behind that joint."""
    t12, t123 = q[0] + q[1], q[0] + q[1] + q[2]
    return np.array([l_2 * np.cos(t12) + l_3 * np.cos(t123), l_2 * np.sin(t12) + l_3 * np.sin(t123), 0])


def column_2(q, l_2, l_3):
    """Return J_L2 = z_1 × p_{1,G}; z_1 is [0, 0, 1]."""
    x, y, _ = lever_2(q, l_2, l_3)
    return np.array([-y, x, 0])


def jacobian(q, l_1, l_2, l_3):
    """Return J, 6×3: each column sums the links behind its joint."""
    angles = [q[0], q[0] + q[1], q[0] + q[1] + q[2]]
    x = [l_1 * np.cos(angles[0]), l_2 * np.cos(angles[1]), l_3 * np.cos(angles[2])]
    y = [l_1 * np.sin(angles[0]), l_2 * np.sin(angles[1]), l_3 * np.sin(angles[2])]
    return np.array([[-sum(y[i:]), sum(x[i:]), 0, 0, 0, 1] for i in range(3)]).T


def derivative(theta_1, theta_2, theta_3, l_1, l_2, l_3):
    """Return ∂P_y/∂θ_1: θ_1 is in all three angles, so every term stays, with its length."""
    return l_1 * np.cos(theta_1) + l_2 * np.cos(theta_1 + theta_2) + l_3 * np.cos(theta_1 + theta_2 + theta_3)


def linear(q, l_1, l_2, l_3):
    """Return J_L, 3×3, the derivatives of the position."""
    return jacobian(q, l_1, l_2, l_3)[:3]


def determinant(theta_1, theta_2, theta_3, l_1, l_2, l_3):
    """Return the determinant of the rows of v_x, v_y and ω_z."""
    return l_1 * l_2 * np.sin(theta_2)


LEVER = r"\begin{bmatrix} l_2 C_{12} + l_3 C_{123} \\ l_2 S_{12} + l_3 S_{123} \\ 0 \end{bmatrix}"
COLUMN = r"\begin{bmatrix} -l_2 S_{12} - l_3 S_{123} \\ l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}"
ROWS_XY = r"""-l_1 S_1 - l_2 S_{12} - l_3 S_{123} & -l_2 S_{12} - l_3 S_{123} & -l_3 S_{123} \\
l_1 C_1 + l_2 C_{12} + l_3 C_{123} & l_2 C_{12} + l_3 C_{123} & l_3 C_{123} \\ 0 & 0 & 0"""
LINEAR = rf"\begin{{bmatrix}} {ROWS_XY} \end{{bmatrix}}"
JACOBIAN = rf"\begin{{bmatrix}} {ROWS_XY} \\ 0 & 0 & 0 \\ 0 & 0 & 0 \\ 1 & 1 & 1 \end{{bmatrix}}"
PRINTED = JACOBIAN.replace("& -l_2 S_{12}", "& l_2 S_{12}")  # the document's slip, on three slides


def _symbols(sp):
    return sp.symbols("theta_1 theta_2 theta_3 l_1 l_2 l_3")


def _position(sp):
    t1, t2, t3, l1, l2, l3 = _symbols(sp)
    return sp.Matrix([
        l1 * sp.cos(t1) + l2 * sp.cos(t1 + t2) + l3 * sp.cos(t1 + t2 + t3),
        l1 * sp.sin(t1) + l2 * sp.sin(t1 + t2) + l3 * sp.sin(t1 + t2 + t3),
        0,
    ])  # fmt: skip


def _linear_sympy(sp):
    return _position(sp).jacobian(_symbols(sp)[:3])


def _jacobian_sympy(sp):
    return _linear_sympy(sp).col_join(sp.Matrix([[0, 0, 0], [0, 0, 0], [1, 1, 1]]))


def _lever_sympy(sp):
    return _position(sp).subs(_symbols(sp)[3], 0)


def _column_sympy(sp):
    return sp.Matrix([0, 0, 1]).cross(_lever_sympy(sp))


def _determinant_sympy(sp):
    return _jacobian_sympy(sp).extract([0, 1, 5], [0, 1, 2]).det()


def _expanded(theta_1, theta_2, theta_3, l_1, l_2, l_3):
    return l_1 * l_2 * (np.sin(theta_1 + theta_2) * np.cos(theta_1) - np.cos(theta_1 + theta_2) * np.sin(theta_1))


def _crossed(q, l_1, l_2, l_3):
    points = [np.zeros(3)]
    for k, length in enumerate((l_1, l_2, l_3)):
        angle = sum(q[: k + 1])
        points.append(points[-1] + length * np.array([np.cos(angle), np.sin(angle), 0]))
    z = np.array([0, 0, 1])
    return np.column_stack([np.concatenate([np.cross(z, points[3] - point), z]) for point in points[:3]])


def _own_column(q, l_1, l_2, l_3):
    """Return the Jacobian whose columns hold the link of their joint alone."""
    t1, t12, t123 = q[0], q[0] + q[1], q[0] + q[1] + q[2]
    x = [l_1 * np.cos(t1), l_2 * np.cos(t12), l_3 * np.cos(t123)]
    y = [l_1 * np.sin(t1), l_2 * np.sin(t12), l_3 * np.sin(t123)]
    return np.array([[-y[i], x[i], 0, 0, 0, 1] for i in range(3)]).T


def _to_joint(q, l_1, l_2, l_3):
    """Return the Jacobian with the vectors from the base to the joints in place of those to the gripper."""
    whole = jacobian(q, l_1, l_2, l_3)
    return np.array([whole[:, 0] * 0, whole[:, 0] - whole[:, 1], whole[:, 0] - whole[:, 2]]).T + np.array(
        [[0, 0, 0]] * 5 + [[1, 1, 1]]
    )


# -- an arm that nobody has seen: the cylindrical one of the lesson on the SCARA -------------------------------------------


def cylinder(q):
    """Return the Jacobian of the ram's end: the column turns, the carriage rises, the ram goes out."""
    c, s = np.cos(q[0]), np.sin(q[0])
    return np.array([[-q[2] * c, 0, -s], [-q[2] * s, 0, c], [0, 1, 0], [0, 0, 0], [0, 0, 0], [1, 0, 0]])


CYLINDER = r"""\begin{bmatrix} -d_3 C_1 & 0 & -S_1 \\ -d_3 S_1 & 0 & C_1 \\ 0 & 1 & 0 \\ 0 & 0 & 0 \\ 0 & 0 & 0 \\ 1 & 0 & 0 \end{bmatrix}"""


def _cylinder_sympy(sp):
    t, d2, d3 = sp.symbols("theta_1 d_2 d_3")
    above = sp.Matrix([-d3 * sp.sin(t), d3 * sp.cos(t), d2]).jacobian([t, d2, d3])
    return above.col_join(sp.Matrix([[0, 0, 0], [0, 0, 0], [1, 0, 0]]))


LESSON = Lesson(
    number=10,
    name="planar_3r_jacobian",
    title="Planar 3R: the Jacobian by cross products and by derivatives",
    source="Modélisation et commande des robots de manipulation, chapter 3, Université de Constantine 1 (document 002)",
    objectives=(
        "Build the 6×3 Jacobian of a planar arm by cross products.",
        "Find its linear half a second time by derivatives, and use one way to test the other.",
        "Say when a Jacobian that is not square loses rank.",
    ),
    tasks=(
        Task(
            name="prediction",
            title="Predict the zero rows",
            text="Three revolute joints, all axes along $z_0$. Which components of the gripper's velocity are zero whatever the joints do? Give the list "
            "of their keys: `vx`, `vy`, `vz`, `wx`, `wy`, `wz` (`w` for $\\omega$).",
            asks=Choice(
                {
                    "vx": "v along x_0",
                    "vy": "v along y_0",
                    "vz": "v along z_0",
                    "wx": "ω about x_0",
                    "wy": "ω about y_0",
                    "wz": "ω about z_0",
                },
                frozenset({"vz", "wx", "wy"}),
                because={
                    "vx": "the gripper moves in the plane of x_0 and y_0: v_x is not zero in general",
                    "vy": "the gripper moves in the plane of x_0 and y_0: v_y is not zero in general",
                    "wz": "every joint turns the gripper about z_0: ω_z is the sum of the rates",
                },
            ),
            hints=(
                "In which plane does the arm lie, and about which axis does each joint turn?",
                "A point never leaves the plane across the axes; a body that turns about $z_0$ alone turns about no other axis.",
                "Three of the six are zero: one of $v$, two of $\\omega$.",
            ),
            right=(["vz", "wx", "wy"], "vz, wx, wy", {"wy", "wx", "vz"}),
            wrong=(
                Wrong(["vz"], "there is more"),
                Wrong(["wx", "wy"], "there is more"),
                Wrong(["vz", "wz"], "every joint turns the gripper about z_0"),
                Wrong(["vx", "vy", "wz"], "the gripper moves in the plane"),
                Wrong("vy, wx, wz", "the gripper moves in the plane"),
            ),
        ),
        Task(
            name="lever",
            title="From joint 2 to the gripper",
            text="Write $P_{1,G} = P_G - P_1$ (3 rows, in frame 0, m) in $\\theta_1, \\theta_2, \\theta_3$ and $l_1, l_2, l_3$. A function takes the joint vector `q` "
            "and, by their names, the lengths that it needs.",
            asks=Quantity("planar_3r", {"difference": [3, 1]}),
            hints=(
                "Which links lie between joint 2 and the gripper?",
                "Links 2 and 3. Their directions from $x_0$ are the sums of all joint angles up to theirs.",
                "Link 2 points along $\\theta_1 + \\theta_2$ and link 3 along $\\theta_1 + \\theta_2 + \\theta_3$: cosines in row 1, sines in row 2.",
            ),
            right=(lever_2, WithSympy(_lever_sympy), LEVER),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} + l_3 C_{123} \\ l_1 S_1 + l_2 S_{12} + l_3 S_{123} \\ 0 \end{bmatrix}",
                    "that is the whole arm, from the base: the vector is to start at joint 2",
                    own=True,
                ),
                Wrong(r"\begin{bmatrix} l_3 C_{123} \\ l_3 S_{123} \\ 0 \end{bmatrix}", "missing"),
                Wrong(lambda q, l_2, l_3: -lever_2(q, l_2, l_3), "sign"),
                Wrong(
                    r"\begin{bmatrix} l_2 C_2 + l_3 C_{23} \\ l_2 S_2 + l_3 S_{23} \\ 0 \end{bmatrix}",
                    "that is in frame 1, where θ_1 does not appear: in frame 0 every direction starts with θ_1",
                    own=True,
                ),
                Wrong(lambda q, l_2, l_3: lever_2(q, l_3, l_2), "swapped"),
            ),
        ),
        Task(
            name="column",
            title="The second linear column",
            text="Carry out the cross product $J_{L2} = z_1 \\times P_{1,G}$ (3 rows, in frame 0, m). A function takes `q` and, by their names, the lengths "
            "that it needs.",
            asks=Quantity("planar_3r", {"jacobian": 3, "rows": [1, 2, 3], "columns": [2]}),
            hints=(
                "$z_1 = [0, 0, 1]^T$. Write the definition of the cross product down, row by row.",
                "$[0, 0, 1]^T \\times [x, y, 0]^T = [-y, x, 0]^T$.",
                "So row 1 is minus the whole second row of $P_{1,G}$: the minus goes to both terms.",
            ),
            derivation=Derivation(
                (
                    Line("The axis of joint 2.", r"z_1 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}"),
                    Line(
                        "From that axis to the gripper.",
                        r"p_3 - p_1 = \begin{bmatrix} l_2 C_{12} + l_3 C_{123} \\ l_2 S_{12} + l_3 S_{123} \\ 0 \end{bmatrix}",
                    ),
                    Line("The rule for a revolute joint.", r"J_{L2} = z_1 \times (p_3 - p_1)"),
                    Line(
                        "Crossing $[0, 0, 1]^T$ with $[x, y, 0]^T$ gives $[-y, x, 0]^T$.",
                        r"J_{L2} = \begin{bmatrix} -l_2 S_{12} - l_3 S_{123} \\ l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}",
                    ),
                ),
                {
                    "arm": "planar_3r",
                    "quantities": {
                        "J_{L2}": {"jacobian": 3, "rows": [1, 2, 3], "columns": [2]},
                        "J_P": {"jacobian": 3, "rows": [1, 2], "columns": [1, 2]},
                    },
                },
            ),
            right=(
                column_2,
                WithSympy(_column_sympy),
                COLUMN,
                r"\begin{bmatrix} -(l_2 S_{12} + l_3 S_{123}) \\ l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}",
            ),
            wrong=(
                Wrong(
                    COLUMN.replace("-l_2 S_{12}", "l_2 S_{12}"),
                    "the minus of −y goes to both terms: that is the slip of the document's slide",
                    own=True,
                ),
                Wrong(LEVER, "that is P_{1,G} itself: cross z_1 with it", own=True),
                Wrong(lambda q, l_2, l_3: -column_2(q, l_2, l_3), "sign"),
                Wrong(
                    r"\begin{bmatrix} -l_1 S_1 - l_2 S_{12} - l_3 S_{123} \\ l_1 C_1 + l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}",
                    "that is column 1: joint 2 does not move link 1",
                    own=True,
                ),
                Wrong(lambda q, l_2, l_3: column_2(np.deg2rad(q), l_2, l_3), "degrees"),
            ),
        ),
        Task(
            name="jacobian",
            title="The whole Jacobian",
            text="Write $J$ of the gripper, frame 3: 6×3, rows $[v;\\ \\omega]$ in frame 0. A function takes `q` and, by their names, the lengths that it needs.",
            asks=Quantity("planar_3r", {"jacobian": 3}),
            hints=(
                "One column a joint: $z_{i-1} \\times P_{i-1,G}$ above $z_{i-1}$. You have the second one.",
                "Column 1 has all three links behind it, column 3 only the last one. All axes are $[0, 0, 1]^T$.",
                "Row 1 of column $i$ is minus the sum of the $l S$ of links $i$ to 3, row 2 the sum of their $l C$; the last row is $1, 1, 1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "All three axes point out of the plane.",
                        r"z_0 = z_1 = z_2 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Column 1: the lever is the whole arm.",
                        r"z_0 \times (p_3 - p_0) = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} - l_3 S_{123} \\ l_1 C_1 + l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 2: without the first link.",
                        r"z_1 \times (p_3 - p_1) = \begin{bmatrix} -l_2 S_{12} - l_3 S_{123} \\ l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 3: the last link alone.",
                        r"z_2 \times (p_3 - p_2) = \begin{bmatrix} -l_3 S_{123} \\ l_3 C_{123} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Put them together, the axes below.",
                        r"J = \begin{bmatrix} z_0 \times (p_3 - p_0) & z_1 \times (p_3 - p_1) & z_2 \times (p_3 - p_2) \\ z_0 & z_1 & z_2 \end{bmatrix}",
                    ),
                ),
                {"arm": "planar_3r", "quantities": {"J": {"jacobian": 3}}},
            ),
            right=(jacobian, WithSympy(_jacobian_sympy), JACOBIAN, _crossed),
            wrong=(
                Wrong(
                    PRINTED,
                    "the sign of l_2 S_12 in row 1, column 2: the document prints it so three times; its own derivative says otherwise",
                    own=True,
                ),
                Wrong(_own_column, "each column holds one link only: a joint moves all links behind it", own=True),
                Wrong(
                    _to_joint,
                    "the vectors run from the base to the joints: they are to run from the joints to the gripper",
                    own=True,
                ),
                Wrong(JACOBIAN.replace("_{12}", "_2").replace("_{123}", "_3"), "each angle is taken as absolute"),
                Wrong(
                    lambda q, l_1, l_2, l_3: np.vstack(
                        [jacobian(q, l_1, l_2, l_3)[3:], jacobian(q, l_1, l_2, l_3)[:3]]
                    ),
                    "[ω; v]",
                ),
                Wrong(lambda q, l_1, l_2, l_3: jacobian(q, l_3, l_2, l_1), "swapped"),
                Wrong(lambda q, l_1, l_2, l_3: jacobian(q, l_1, l_2, l_3).T, "transposed"),
            ),
        ),
        Task(
            name="derivative",
            title="One derivative by hand",
            text="$P_y = l_1 S_1 + l_2 S_{12} + l_3 S_{123}$. Write $\\partial P_y / \\partial \\theta_1$. A function takes `(theta_1, theta_2, theta_3, l_1, l_2, l_3)`.",
            asks=Formula(
                r"\frac{\partial P_y}{\partial \theta_1}",
                ("theta_1", "theta_2", "theta_3", "l_1", "l_2", "l_3"),
                arm="planar_3r",
                quantities={"P_y": {"origin": 3, "component": "y"}},
                unit="m",
            ),
            hints=(
                "In how many of the three terms does $\\theta_1$ stand?",
                "In all three, since $S_{12}$ is $\\sin(\\theta_1 + \\theta_2)$. The derivative of that sum is 1.",
                "Each sine becomes the cosine of the same sum; each length stays in front.",
            ),
            right=(
                derivative,
                WithSympy(lambda sp: sp.diff(_position(sp)[1], _symbols(sp)[0])),
                r"l_1 C_1 + l_2 C_{12} + l_3 C_{123}",
                r"l_1 \cos\theta_1 + l_2(C_1 C_2 - S_1 S_2) + l_3 \cos(\theta_1 + \theta_2 + \theta_3)",
            ),
            wrong=(
                Wrong(r"l_1 C_1 + C_{12} + l_3 C_{123}", "l_2 is missing"),
                Wrong(r"l_1 C_1", "only the first term is differentiated: θ_1 is in S_12 and S_123 too", own=True),
                Wrong(r"-l_1 C_1 - l_2 C_{12} - l_3 C_{123}", "sign"),
                Wrong(r"l_1 S_1 + l_2 S_{12} + l_3 S_{123}", "that is P_y itself, with no derivative taken", own=True),
                Wrong(r"-l_1 S_1 - l_2 S_{12} - l_3 S_{123}", "that is the derivative of P_x", own=True),
                Wrong(r"l_2 C_{12} + l_3 C_{123}", "missing"),
            ),
        ),
        Task(
            name="linear",
            title="The linear half by derivatives",
            text="Write $J_L$, 3×3, rows $P_x, P_y, P_z$, column $i$ the derivative by $\\theta_i$, without any cross product: LaTeX, a function of `q` "
            "and the lengths, or SymPy's `P.jacobian([...])` with symbols named `theta_1`, …, `l_1`, …",
            asks=Quantity("planar_3r", {"jacobian": 3, "rows": [1, 2, 3]}),
            hints=(
                "Start from $P = [l_1 C_1 + l_2 C_{12} + l_3 C_{123},\\ l_1 S_1 + l_2 S_{12} + l_3 S_{123},\\ 0]^T$.",
                "$\\theta_3$ stands in the last term of $P_x$ and $P_y$ only, $\\theta_2$ in the last two.",
                "In SymPy: `P.jacobian([t1, t2, t3])`, with `P` a column `Matrix` and `t1 = symbols('theta_1')` and so on.",
            ),
            derivation=Derivation(
                (
                    Line("The first row of the position.", r"P_x = l_1 C_1 + l_2 C_{12} + l_3 C_{123}"),
                    Line(
                        "All three angles contain $\\theta_1$.",
                        r"\frac{\partial P_x}{\partial\theta_1} = -l_1 S_1 - l_2 S_{12} - l_3 S_{123}",
                    ),
                    Line(
                        "Two of them contain $\\theta_2$.",
                        r"\frac{\partial P_x}{\partial\theta_2} = -l_2 S_{12} - l_3 S_{123}",
                    ),
                    Line(
                        "Only the last one contains $\\theta_3$.",
                        r"\frac{\partial P_x}{\partial\theta_3} = -l_3 S_{123}",
                    ),
                    Line(
                        "The same for $P_y$: a sine becomes a cosine.",
                        r"\frac{\partial P_y}{\partial\theta_1} = l_1 C_1 + l_2 C_{12} + l_3 C_{123}",
                    ),
                    Line(
                        "Put the derivatives into their places.",
                        r"J_L = \begin{bmatrix} \frac{\partial P_x}{\partial\theta_1} & \frac{\partial P_x}{\partial\theta_2} & \frac{\partial P_x}{\partial\theta_3} \\ \frac{\partial P_y}{\partial\theta_1} & \frac{\partial P_y}{\partial\theta_2} & \frac{\partial P_y}{\partial\theta_3} \\ 0 & 0 & 0 \end{bmatrix}",
                    ),
                ),
                {
                    "arm": "planar_3r",
                    "quantities": {
                        "P_x": {"origin": 3, "component": "x"},
                        "P_y": {"origin": 3, "component": "y"},
                        "J_L": {"jacobian": 3, "rows": [1, 2, 3]},
                    },
                },
            ),
            right=(linear, WithSympy(_linear_sympy), LINEAR),
            wrong=(
                Wrong(LINEAR.replace("& -l_2 S_{12}", "& l_2 S_{12}"), "entry (1, 2)"),
                Wrong(LINEAR.replace("l_2 C_{12} + l_3 C_{123} &", "C_{12} + l_3 C_{123} &", 1), "l_2 is missing"),
                Wrong(lambda q, l_1, l_2, l_3: linear(q, l_1, l_2, l_3).T, "transposed"),
                Wrong(WithSympy(lambda sp: -_linear_sympy(sp)), "sign"),
                Wrong(
                    lambda q, l_1, l_2, l_3: _own_column(q, l_1, l_2, l_3)[:3],
                    "each column holds one term only: θ_1 is in all three sums, θ_2 in two of them",
                    own=True,
                ),
            ),
        ),
        Task(
            name="determinant",
            title="The square part",
            text="$J$ has three rows that are not zero, those of $v_x$, $v_y$ and $\\omega_z$. Give the determinant of that 3×3 part, as short as you can. "
            "A function takes `(theta_1, theta_2, theta_3, l_1, l_2, l_3)`.",
            asks=Formula(
                r"\det J_r",
                ("theta_1", "theta_2", "theta_3", "l_1", "l_2", "l_3"),
                arm="planar_3r",
                quantities={"J_r": {"jacobian": 3, "rows": [1, 2, 6]}},
                unit="m²",
            ),
            hints=(
                "Subtract columns from one another first: that leaves the determinant as it is.",
                "Column 1 − column 2 is $[-l_1 S_1, l_1 C_1, 0]^T$, and column 2 − column 3 is $[-l_2 S_{12}, l_2 C_{12}, 0]^T$.",
                "Expand along the last row, $0, 0, 1$: what is left is $l_1 l_2 (S_{12} C_1 - C_{12} S_1)$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The rows $v_x$, $v_y$ and $\\omega_z$.",
                        r"J_r = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} - l_3 S_{123} & -l_2 S_{12} - l_3 S_{123} & -l_3 S_{123} \\ l_1 C_1 + l_2 C_{12} + l_3 C_{123} & l_2 C_{12} + l_3 C_{123} & l_3 C_{123} \\ 1 & 1 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Column 1 less column 2, and column 2 less column 3: the determinant stays.",
                        r"\det J_r = \begin{vmatrix} -l_1 S_1 & -l_2 S_{12} & -l_3 S_{123} \\ l_1 C_1 & l_2 C_{12} & l_3 C_{123} \\ 0 & 0 & 1 \end{vmatrix}",
                    ),
                    Line("Expand along the last row.", r"\det J_r = -l_1 S_1 l_2 C_{12} + l_2 S_{12} l_1 C_1"),
                    Line(
                        "The bracket is the sine of a difference.",
                        r"\det J_r = l_1 l_2 (S_{12} C_1 - C_{12} S_1) = l_1 l_2 \sin\theta_2",
                    ),
                ),
                {"arm": "planar_3r", "quantities": {"J_r": {"jacobian": 3, "rows": [1, 2, 6]}}},
            ),
            right=(determinant, r"l_1 l_2 \sin\theta_2", WithSympy(_determinant_sympy), _expanded),
            wrong=(
                Wrong(r"-l_1 l_2 \sin\theta_2", "wrong sign"),
                Wrong(r"l_1 l_2 \cos\theta_2", "cosine for sine"),
                Wrong(
                    r"l_1 l_2 l_3 \sin\theta_2",
                    "the third link plays no part: it moves the gripper as it turns it, whatever the arm does",
                    own=True,
                ),
                Wrong(
                    r"l_1 l_2 \sin\theta_2 + l_1 l_3 S_{23}",
                    "that keeps the third link: column 3, subtracted from the others, takes it out",
                    own=True,
                ),
                Wrong(
                    r"l_2 l_3 \sin\theta_3",
                    "that is the arm seen from its end: links 1 and 2 decide, and the angle between them",
                    own=True,
                ),
            ),
        ),
        Task(
            name="rank",
            title="Two tasks, two ranks",
            text="Put $\\theta_2 = 0$ and $\\theta_3 = \\pi/2$, with any $\\theta_1$. Give two numbers: the rank of $J$ (position and angle of the gripper), and the "
            "rank of its first two rows (position only).",
            asks=Number((2, 2), labels=("the rank of J", "the rank of the first two rows")),
            hints=(
                "For the first number you have a determinant.",
                "For the second: do the three columns of the rows of $v_x$, $v_y$ all point one way?",
                "Put $\\theta_1 = 0$: column 1 is $[-l_3, l_1 + l_2]^T$, column 3 is $[-l_3, 0]^T$. Are they parallel?",
            ),
            right=([2, 2], (2, 2), "2, 2"),
            wrong=(
                Wrong([3, 2], "the determinant of the 3×3 part is zero at θ_2 = 0", own=True),
                Wrong(
                    [2, 1],
                    "the last link points across the two others: the gripper can still move both ways in the plane",
                    own=True,
                ),
                Wrong([3, 3], "two rows have at most rank 2, and the determinant of the 3×3 part is zero", own=True),
                Wrong([1, 1], "joints 1 and 3 move the gripper in different directions", own=True),
                Wrong([2, 3], "two rows have at most rank 2", own=True),
                Wrong([1, 2], "at θ_2 = 0 one direction is lost, not two: columns 1 and 3 are independent", own=True),
                Wrong([0, 2], "a determinant of zero takes away one direction of J, not all", own=True),
                Wrong([2, 0], "two rows that are not zero have not the rank 0", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A column turns by $\\theta_1$, a carriage rises by $d_2$, a ram goes out by $d_3$; its end is at $[-d_3 S_1, d_3 C_1, d_2]^T$."
            " Write its Jacobian, $6 \\times 3$. A function takes `q` = $[\\theta_1, d_2, d_3]$.",
            asks=Quantity(CYLINDRICAL, {"jacobian": 3}),
            hints=(
                "Column by column: a joint that turns gives $z \\times p$ and $z$, one that slides gives $z$ and zero.",
                "The carriage slides along $z_0$, the ram along $[-S_1, C_1, 0]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The axis of the column and the slide of the carriage are vertical.",
                        r"z_1 = z_2 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Joint 1 turns: its axis times the lever.",
                        r"z_1 \times \begin{bmatrix} -d_3 S_1 \\ d_3 C_1 \\ d_2 \end{bmatrix} = \begin{bmatrix} -d_3 C_1 \\ -d_3 S_1 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "The ram slides along its own axis.",
                        r"z_3 = \begin{bmatrix} -S_1 \\ C_1 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Only joint 1 turns the tool: the other two have zeros below.",
                        r"J = \begin{bmatrix} -d_3 C_1 & 0 & -S_1 \\ -d_3 S_1 & 0 & C_1 \\ 0 & 1 & 0 \\ 0 & 0 & 0 \\ 0 & 0 & 0 \\ 1 & 0 & 0 \end{bmatrix}",
                    ),
                ),
                {"arm": CYLINDRICAL, "quantities": {"J": {"jacobian": 3}}},
            ),
            right=(cylinder, CYLINDER, WithSympy(_cylinder_sympy)),
            wrong=(
                Wrong(
                    lambda q: np.vstack([cylinder(q)[:3], [[0, 0, 0], [0, 0, 0], [1, 1, 0]]]),
                    "a slide turns nothing: its lower half is zero",
                    own=True,
                ),
                Wrong(lambda q: cylinder(q) * np.array([-1, 1, 1]), "sign"),
                Wrong(lambda q: cylinder([np.deg2rad(q[0]), q[1], q[2]]), "degrees"),
                Wrong(
                    lambda q: cylinder([q[0], q[1], 1]),
                    "the lever is missing: the end is d_3 away from the column",
                    own=True,
                ),
                Wrong(
                    lambda q: cylinder(q)[:, [0, 2, 1]],
                    "columns 2 and 3 are exchanged: the carriage comes before the ram",
                    own=True,
                ),
            ),
        ),
    ),
)
