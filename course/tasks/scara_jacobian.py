"""Tasks of lesson 12, the geometric Jacobian of the SCARA and where it is singular (document 000)."""

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
    Task,
    WithSympy,
    Wrong,
    drawn,
)
from armproof.course.links import turn


def rotation(q):
    """Return R^0_2 = R_z(θ_1) R_z(θ_2) R_x(π)."""
    s, c = np.sin(q[0] + q[1]), np.cos(q[0] + q[1])
    return np.array([[c, s, 0], [s, -c, 0], [0, 0, -1]])


def lever(q, a_2, d_4):
    """Return p_4 − p_1: along the second link, and down to the tool."""
    return np.array([a_2 * np.cos(q[0] + q[1]), a_2 * np.sin(q[0] + q[1]), -(q[2] + d_4)])


def jacobian(q, a_1, a_2):
    """Return J, rows [v; ω]: joints 1 and 2 turn about z up, the slide and joint 4 have z down."""
    s1, c1 = np.sin(q[0]), np.cos(q[0])
    s12, c12 = np.sin(q[0] + q[1]), np.cos(q[0] + q[1])
    return np.array([
        [-a_1 * s1 - a_2 * s12, -a_2 * s12, 0, 0],
        [a_1 * c1 + a_2 * c12, a_2 * c12, 0, 0],
        [0, 0, -1, 0],
        [0, 0, 0, 0],
        [0, 0, 0, 0],
        [1, 1, 0, -1],
    ])  # fmt: skip


def determinant(theta_1, theta_2, a_1, a_2):
    """Return the determinant of rows and columns 1 to 3."""
    return -a_1 * a_2 * np.sin(theta_2)


def null_motion(a_1, a_2):
    """Return the joint rates: v_x and v_y cancel at p_4, and joint 4 undoes the turn."""
    return [a_2, -(a_1 + a_2), 0, -a_1]


ROTATION = r"\begin{bmatrix} C_{12} & S_{12} & 0 \\ S_{12} & -C_{12} & 0 \\ 0 & 0 & -1 \end{bmatrix}"
LEVER = r"\begin{bmatrix} a_2 C_{12} \\ a_2 S_{12} \\ -(d_3 + d_4) \end{bmatrix}"
JACOBIAN = r"""\begin{bmatrix} -a_1 S_1 - a_2 S_{12} & -a_2 S_{12} & 0 & 0 \\ a_1 C_1 + a_2 C_{12} & a_2 C_{12} & 0 & 0 \\
0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 1 & 1 & 0 & -1 \end{bmatrix}"""


def _symbols(sp):
    return sp.symbols("theta_1 theta_2 d_3 theta_4 a_1 a_2 d_4")


def _rotation_sympy(sp):
    t1, t2, *_ = _symbols(sp)
    return (turn(sp, "z", t1) * turn(sp, "z", t2))[:3, :3] * sp.diag(1, -1, -1)


def _lever_sympy(sp):
    t1, t2, d3, _, _, a2, d4 = _symbols(sp)
    return sp.Matrix([a2 * sp.cos(t1 + t2), a2 * sp.sin(t1 + t2), -d3 - d4])


def _jacobian_sympy(sp):
    t1, t2, d3, t4, a1, a2, d4 = _symbols(sp)
    p = sp.Matrix([a1 * sp.cos(t1) + a2 * sp.cos(t1 + t2), a1 * sp.sin(t1) + a2 * sp.sin(t1 + t2), -d3 - d4])
    return p.jacobian([t1, t2, d3, t4]).col_join(sp.Matrix([[0, 0, 0, 0], [0, 0, 0, 0], [1, 1, 0, -1]]))


def _determinant_sympy(sp):
    return _jacobian_sympy(sp)[:3, :3].det()


def _crossed(q, a_1, a_2, d_4):
    """Return J by cross products, as the rule says."""
    down, up = np.array([0, 0, -1]), np.array([0, 0, 1])
    p_1 = np.array([a_1 * np.cos(q[0]), a_1 * np.sin(q[0]), 0])
    p_4 = p_1 + lever(q, a_2, d_4)
    columns = [[*np.cross(up, p_4), *up], [*np.cross(up, p_4 - p_1), *up], [*down, 0, 0, 0], [0, 0, 0, *down]]
    return np.array(columns).T


def _changed(*entries):
    """Return the Jacobian with other entries (row, column, value), counted from 0."""

    def wrong(q, a_1, a_2):
        result = jacobian(q, a_1, a_2)
        for row, column, value in entries:
            result[row, column] = value
        return result

    return wrong


def _same_lever(q, a_1, a_2):
    wrong = jacobian(q, a_1, a_2)
    wrong[:, 1] = wrong[:, 0]
    return wrong


def _omega_first(q, a_1, a_2):
    right = jacobian(q, a_1, a_2)
    return np.vstack([right[3:], right[:3]])


def _prediction(a_1=0.325, a_2=0.275):
    """Return the task `prediction` for an arm of these lengths (m)."""
    speed = 1.2 * (a_1 + a_2)
    return Task(
        name="prediction",
        title="Predict a velocity",
        text="The arm is stretched along $x_0$: $\\theta_1 = \\theta_2 = 0$. Joint 1 turns at 1.2 rad/s, the other joints rest. With "
        f"$a_1 = {a_1:g}$ m and $a_2 = {a_2:g}$ m, what is the velocity of the tool point? Give $[v_x, v_y, v_z]$ in m/s, in frame 0.",
        asks=Number(
            (0, speed, 0),
            "m/s",
            ("v_x", "v_y", "v_z"),
            steps=("r = a_1 + a_2", "0", r"1.2 \cdot r", "0"),
            beside=(
                r"1.2 \cdot \sqrt{(a_1^2 + a_2^2)}",
                r"\sqrt{(a_1^2 + a_2^2)}",
                r"1.2^2 \cdot (a_1 + a_2)",
                r"1.2 \cdot (a_1 + a_2)^2",
                r"1.2/(a_1 + a_2)",
                r"(a_1 + a_2)/1.2",
                r"-1.2 \cdot (a_1 + a_2) x_0 = [-1.2 \cdot (a_1 + a_2), 0, 0]",
                r"[v_x, v_y, \omega] = [0, 1.2 \cdot (a_1 + a_2), 1.2]",
            ),
        ),
        hints=(
            "The tool point runs on a circle about $z_0$. Which way does a circle run where it crosses the $x_0$ axis?",
            "Speed is rate times radius; the radius is the distance of the tool from $z_0$.",
            "The radius is $a_1 + a_2$ and the velocity is along $y_0$.",
        ),
        right=([0, speed, 0], f"0, {speed:.4g}, 0", np.array([0.0, speed, 0.0])),
        wrong=(
            Wrong(
                [speed, 0, 0],
                "that is along the arm: a point that turns about an axis moves across the line to the axis",
                own=True,
            ),
            Wrong([0, 1.2 * a_1, 0], "that is the elbow: the tool is one link further from the axis", own=True),
            Wrong([0, 1.2 * a_2, 0], "that is what joint 2 would give: joint 1 turns both links", own=True),
            Wrong([0, -speed, 0], "the right-hand rule about z_0 turns x_0 towards y_0, not away from it", own=True),
            Wrong(
                [0, 0, speed],
                "that is along the axis of joint 1: turning about an axis moves nothing along it",
                own=True,
            ),
            Wrong([0, 1.2, 0], "1.2 rad/s is the rate: a speed is the rate times the radius", own=True),
            Wrong([0, a_1 + a_2, 0], "this is the radius: a speed is the rate times the radius", own=True),
        ),
        own=drawn(_prediction, a_1=(0.3, 0.45), a_2=(0.15, 0.28)),
    )


LESSON = Lesson(
    number=12,
    name="scara_jacobian",
    title="SCARA: geometric Jacobian and singular configurations",
    source="F. Morbidi, TD 3, April 2019 (document 000)",
    objectives=(
        "Build the 6×4 geometric Jacobian column by column.",
        "Reduce it to a square block and read the singular configurations from its determinant.",
        "Say what is lost there, and where in the workspace it happens.",
    ),
    tasks=(
        _prediction(),
        Task(
            name="rotation",
            title="The rotation of frame 2",
            text="Work out $R^0_2 = R^0_1 R^1_2$, 3×3, in $\\theta_1$ and $\\theta_2$. Its third column is the axis $z_2$ of the slide. A function "
            "takes the joint vector `q` = $[\\theta_1, \\theta_2, d_3, \\theta_4]$.",
            asks=Quantity("scara", {"rotation": 2}),
            hints=(
                "$R^0_1 = R_z(\\theta_1)$. What is the rotation part of $A^1_2$?",
                "$R_z(\\theta_1) R_z(\\theta_2) = R_z(\\theta_1 + \\theta_2)$; then multiply by $R_x(\\pi) = \\mathrm{diag}(1, -1, -1)$ on the right.",
                "Multiplying by $\\mathrm{diag}(1, -1, -1)$ on the right changes the sign of columns 2 and 3 of $R_z(\\theta_1 + \\theta_2)$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "A turn about $z_0$.",
                        r"R^0_1 = \begin{bmatrix} C_1 & -S_1 & 0 \\ S_1 & C_1 & 0 \\ 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "A turn about $z_1$, then $R_x(\\pi)$: columns 2 and 3 change sign.",
                        r"R^1_2 = \begin{bmatrix} C_2 & S_2 & 0 \\ S_2 & -C_2 & 0 \\ 0 & 0 & -1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply.",
                        r"R^0_2 = R^0_1 R^1_2 = \begin{bmatrix} C_1 C_2 - S_1 S_2 & C_1 S_2 + S_1 C_2 & 0 \\ S_1 C_2 + C_1 S_2 & S_1 S_2 - C_1 C_2 & 0 \\ 0 & 0 & -1 \end{bmatrix}",
                    ),
                    Line(
                        "Each entry is the sine or the cosine of a sum.",
                        r"R^0_2 = \begin{bmatrix} C_{12} & S_{12} & 0 \\ S_{12} & -C_{12} & 0 \\ 0 & 0 & -1 \end{bmatrix}",
                    ),
                ),
                {
                    "arm": "scara",
                    "transforms": "upper",
                    "quantities": {
                        "J": {"jacobian": 4},
                        "J'_P": {"jacobian": 4, "rows": [1, 2, 3], "columns": [1, 2, 3]},
                    },
                },
            ),
            right=(rotation, WithSympy(_rotation_sympy), ROTATION),
            wrong=(
                Wrong(
                    ROTATION.replace("& S_{12}", "& -S_{12}").replace("& -C_{12}", "& C_{12}"),
                    "column 2 has the wrong sign, as in the document: the determinant is −1, so this is no rotation",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_{12} & -S_{12} & 0 \\ S_{12} & C_{12} & 0 \\ 0 & 0 & 1 \end{bmatrix}",
                    "R_x(π) is missing: link 2 also turns z over, from up to down",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_{12} & -S_{12} & 0 \\ -S_{12} & -C_{12} & 0 \\ 0 & 0 & -1 \end{bmatrix}",
                    "R_x(π) stands on the wrong side: it is the last factor, it changes the sign of columns, not of rows",
                    own=True,
                ),
                Wrong(ROTATION.replace("_{12}", "_2"), "that is R^1_2 alone: θ_1 turns the second link too", own=True),
                Wrong(lambda q: rotation(np.deg2rad(q)), "degrees"),
            ),
        ),
        Task(
            name="lever",
            title="From joint 2 to the tool",
            text="Write the vector $p_4 - p_1$ (3 rows, in frame 0, m) in $\\theta_1$, $\\theta_2$, $d_3$, $a_1$, $a_2$, $d_4$. A function takes `q` and, by "
            "their names, the lengths that it needs.",
            asks=Quantity("scara", {"difference": [4, 1]}),
            hints=(
                "The first link lies before $p_1$: it is in both points.",
                "In the plane it is the second link, whose direction from $x_0$ is $\\theta_1 + \\theta_2$.",
                "Vertically the tool is $d_3 + d_4$ below the arm; $z_0$ points up.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The tool.",
                        r"p_4 = \begin{bmatrix} a_1 C_1 + a_2 C_{12} \\ a_1 S_1 + a_2 S_{12} \\ -(d_3 + d_4) \end{bmatrix}",
                    ),
                    Line("The axis of joint 2.", r"p_1 = \begin{bmatrix} a_1 C_1 \\ a_1 S_1 \\ 0 \end{bmatrix}"),
                    Line(
                        "Subtract: the first link falls out.",
                        r"p_4 - p_1 = \begin{bmatrix} a_2 C_{12} \\ a_2 S_{12} \\ -(d_3 + d_4) \end{bmatrix}",
                    ),
                ),
                {
                    "arm": "scara",
                    "transforms": "upper",
                    "quantities": {
                        "J": {"jacobian": 4},
                        "J'_P": {"jacobian": 4, "rows": [1, 2, 3], "columns": [1, 2, 3]},
                    },
                },
            ),
            right=(
                lever,
                WithSympy(_lever_sympy),
                LEVER,
                r"\begin{bmatrix} a_2(C_1C_2 - S_1S_2) \\ a_2(S_1C_2 + C_1S_2) \\ -d_3 - d_4 \end{bmatrix}",
            ),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} a_1 C_1 + a_2 C_{12} \\ a_1 S_1 + a_2 S_{12} \\ -(d_3 + d_4) \end{bmatrix}",
                    "that is p_4, the vector from the base: take p_1 away",
                    own=True,
                ),
                Wrong(lambda q, a_2, d_4: -lever(q, a_2, d_4), "sign"),
                Wrong(LEVER.replace("_{12}", "_2"), "index 1 is missing"),
                Wrong(LEVER.replace("-(d_3 + d_4)", "-d_3"), "missing"),
                Wrong(
                    LEVER.replace("-(d_3 + d_4)", "d_3 + d_4"),
                    "the tool hangs below the arm and z_0 points up: the third row counts negative",
                    own=True,
                ),
            ),
        ),
        Task(
            name="jacobian",
            title="The geometric Jacobian",
            text="Write $J(q)$ of the tool, frame 4: 6×4, rows $[v;\\ \\omega]$ in frame 0, columns in the order $\\theta_1, \\theta_2, d_3, \\theta_4$. Letters: "
            "$a_1$, $a_2$, $d_4$. A function takes `q` and, by their names, the lengths that it needs.",
            asks=Quantity("scara", {"jacobian": 4}),
            hints=(
                "A revolute joint $i$ gives $v = z_{i-1} \\times (p_4 - p_{i-1})$ and $\\omega = z_{i-1}$; a slide gives $v = z_{i-1}$ and $\\omega = 0$.",
                "$z_0 = z_1 = [0, 0, 1]^T$ and $z_2 = z_3 = [0, 0, -1]^T$. Crossing $[0, 0, 1]^T$ with $[x, y, z]^T$ gives $[-y, x, 0]^T$.",
                "Column 1 is $[-y, x, 0, 0, 0, 1]^T$ with $x, y$ of $p_4$, column 2 the same with $x, y$ of $p_4 - p_1$; columns 3 and 4 hold a single $-1$ each.",
            ),
            derivation=Derivation(
                (
                    Line("The first two axes point up.", r"z_0 = z_1 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}"),
                    Line("The last two point down.", r"z_2 = z_3 = \begin{bmatrix} 0 \\ 0 \\ -1 \end{bmatrix}"),
                    Line(
                        "Column 1: the vector starts at the base.",
                        r"z_0 \times (p_4 - p_0) = \begin{bmatrix} -a_1 S_1 - a_2 S_{12} \\ a_1 C_1 + a_2 C_{12} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 2: it starts at $p_1$.",
                        r"z_1 \times (p_4 - p_1) = \begin{bmatrix} -a_2 S_{12} \\ a_2 C_{12} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 4: the tool lies on its axis.",
                        r"z_3 \times (p_4 - p_3) = \begin{bmatrix} 0 \\ 0 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Put them together; the slide gives its axis.",
                        r"J = \begin{bmatrix} z_0 \times (p_4 - p_0) & z_1 \times (p_4 - p_1) & z_2 & z_3 \times (p_4 - p_3) \\ z_0 & z_1 & 0_{3\times 1} & z_3 \end{bmatrix}",
                    ),
                ),
                {
                    "arm": "scara",
                    "transforms": "upper",
                    "quantities": {
                        "J": {"jacobian": 4},
                        "J'_P": {"jacobian": 4, "rows": [1, 2, 3], "columns": [1, 2, 3]},
                    },
                },
            ),
            right=(jacobian, WithSympy(_jacobian_sympy), JACOBIAN, _crossed),
            wrong=(
                Wrong(
                    JACOBIAN.replace("a_2 C_{12} & a_2 C_{12}", "a_2 C_{12} & -a_2 C_{12}"), "entry (2, 2): wrong sign"
                ),
                Wrong(
                    _changed((2, 2, 1), (5, 3, 1)),
                    "the axes z_2 and z_3 point down: the slide and the last joint count negative",
                    own=True,
                ),
                Wrong(
                    _changed((5, 3, 1)), "joint 4 turns about z_3, which points down: its ω_z counts negative", own=True
                ),
                Wrong(
                    _changed((2, 2, 0), (5, 2, -1)),
                    "joint 3 is a slide: its axis belongs in the rows of v, and it turns nothing",
                    own=True,
                ),
                Wrong(
                    _same_lever,
                    "columns 1 and 2 use the same vector: the one of joint 2 starts at p_1, not at the base",
                    own=True,
                ),
                Wrong(JACOBIAN.replace("S_{12}", "S_2").replace("C_{12}", "C_2"), "each angle is taken as absolute"),
                Wrong(_omega_first, "rows"),
                Wrong(lambda q, a_1, a_2: jacobian(q, a_1, a_2).T, "transposed"),
                Wrong(lambda q, a_1, a_2: jacobian(np.deg2rad(q), a_1, a_2), "degrees"),
            ),
        ),
        Task(
            name="determinant",
            title="The reduced determinant",
            text="$J'_P$ is made of rows 1, 2, 3 and columns 1, 2, 3 of $J$. Give its determinant as short as you can, in $\\theta_1$, $\\theta_2$, $a_1$, $a_2$. "
            "A function takes `(theta_1, theta_2, a_1, a_2)`.",
            asks=Formula(
                r"\det J'_P",
                ("theta_1", "theta_2", "a_1", "a_2"),
                arm="scara",
                quantities={"J'_P": {"jacobian": 4, "rows": [1, 2, 3], "columns": [1, 2, 3]}},
                unit="m²",
            ),
            hints=(
                "The block is block diagonal: a 2×2 block and the number in its corner.",
                "The determinant of the 2×2 block is $x_1 y_2 - x_2 y_1$ of its columns; the products with $a_2^2$ cancel.",
                "The block has $a_1 a_2 (S_{12} C_1 - C_{12} S_1)$. Which sine is that, and what does the corner do?",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Rows and columns 1 to 3.",
                        r"J'_P = \begin{bmatrix} -a_1 S_1 - a_2 S_{12} & -a_2 S_{12} & 0 \\ a_1 C_1 + a_2 C_{12} & a_2 C_{12} & 0 \\ 0 & 0 & -1 \end{bmatrix}",
                    ),
                    Line(
                        "Block diagonal: the corner, $-1$, times the 2×2 block.",
                        r"\det J'_P = -\begin{vmatrix} -a_1 S_1 - a_2 S_{12} & -a_2 S_{12} \\ a_1 C_1 + a_2 C_{12} & a_2 C_{12} \end{vmatrix}",
                    ),
                    Line(
                        "$x_1 y_2 - x_2 y_1$ of its columns.",
                        r"\det J'_P = -\left( (-a_1 S_1 - a_2 S_{12}) a_2 C_{12} + a_2 S_{12} (a_1 C_1 + a_2 C_{12}) \right)",
                    ),
                    Line("The products with $a_2^2$ cancel.", r"\det J'_P = -a_1 a_2 (S_{12} C_1 - C_{12} S_1)"),
                    Line("The bracket is the sine of a difference.", r"\det J'_P = -a_1 a_2 \sin\theta_2"),
                ),
                {
                    "arm": "scara",
                    "transforms": "upper",
                    "quantities": {
                        "J": {"jacobian": 4},
                        "J'_P": {"jacobian": 4, "rows": [1, 2, 3], "columns": [1, 2, 3]},
                    },
                },
            ),
            right=(
                determinant,
                WithSympy(_determinant_sympy),
                r"-a_1 a_2 \sin\theta_2",
                r"-a_2 C_{12}(-a_1 S_1 - a_2 S_{12}) - a_2 S_{12}(a_1 C_1 + a_2 C_{12})",
                lambda theta_1, theta_2, a_1, a_2: (
                    -a_1
                    * a_2
                    * (np.sin(theta_1 + theta_2) * np.cos(theta_1) - np.cos(theta_1 + theta_2) * np.sin(theta_1))
                ),
            ),
            wrong=(
                Wrong(
                    r"a_1 a_2 \sin\theta_2",
                    "that is the 2×2 block alone: multiply by the entry in the corner, −1",
                    own=True,
                ),
                Wrong(r"-a_1 a_2 \cos\theta_2", "cosine for sine"),
                Wrong(r"-a_1 \sin\theta_2", "factor a_2 is missing"),
                Wrong(lambda theta_1, theta_2, a_1, a_2: -a_1 * a_2 * np.sin(theta_1), "angle"),
                Wrong(
                    lambda theta_1, theta_2, a_1, a_2: -a_1 * a_2 * np.sin(theta_1 + theta_2),
                    "sin(α − β) is to be used: the difference of the two directions is θ_2 alone",
                    own=True,
                ),
            ),
        ),
        Task(
            name="rank",
            title="The rank when folded",
            text="What is the rank of the whole 6×4 matrix $J$ at $\\theta_2 = \\pi$, for every $\\theta_1$?",
            asks=Number(3),
            hints=(
                "The determinant says that it is not 4. Which columns are still independent?",
                "Columns 3 and 4 have a row of their own. At $\\theta_2 = \\pi$, which direction do the linear parts of columns 1 and 2 have?",
                "Column 2 has a linear part, and no other column can replace column 3 or 4. So three columns are left.",
            ),
            right=(3, "3", 3.0),
            wrong=(
                Wrong(4, "four columns are independent only where the determinant is not zero; here it is", own=True),
                Wrong(2, "too few: of columns 2, 3 and 4 none is made of the other two", own=True),
                Wrong(6, "the rank is at most the number of columns, four", own=True),
                Wrong(1, "the slide alone gives rank 1, and the other columns are not zero", own=True),
                Wrong(5, "the matrix has four columns: no rank is larger", own=True),
                Wrong(0, "a determinant of zero takes away one direction, not all", own=True),
                Wrong(8, "the rank is no product: it is at most the number of columns, four", own=True),
            ),
        ),
        Task(
            name="null_motion",
            title="Moving with the tool at rest",
            text="The arm is stretched, $\\theta_2 = 0$, and moves so that the tool neither moves nor turns, at least for an instant. Give the joint "
            "rates $[\\dot\\theta_1, \\dot\\theta_2, \\dot d_3, \\dot\\theta_4]$ (4 rows) with $\\dot\\theta_1 = a_2$, in $a_1$ and $a_2$. A function takes `(a_1, a_2)`.",
            asks=Formula(r"\begin{bmatrix} a_2 \\ -a_1 - a_2 \\ 0 \\ -a_1 \end{bmatrix}", ("a_1", "a_2"), arm="scara"),
            hints=(
                "Put $\\theta_2 = 0$ into $J \\dot q = 0$. How many different equations are left?",
                "Across the arm: $(a_1 + a_2)\\dot\\theta_1 + a_2\\dot\\theta_2 = 0$. Along $z$: $\\dot d_3 = 0$. About $z$: $\\dot\\theta_1 + \\dot\\theta_2 - \\dot\\theta_4 = 0$.",
                "With $\\dot\\theta_1 = a_2$ the first equation gives $\\dot\\theta_2 = -(a_1 + a_2)$; the last one then gives $\\dot\\theta_4$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Stretched, four rows of the Jacobian differ from zero.",
                        r"\left. J \right|_{\theta_2 = 0} = \begin{bmatrix} -(a_1 + a_2) S_1 & -a_2 S_1 & 0 & 0 \\ (a_1 + a_2) C_1 & a_2 C_1 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 1 & 1 & 0 & -1 \end{bmatrix}",
                    ),
                    Line(
                        "Across the arm the velocities of joints 1 and 2 must cancel.",
                        r"(a_1 + a_2) a_2 + a_2 (-(a_1 + a_2)) = 0",
                    ),
                    Line("Joint 4 undoes the turn that is left.", r"a_2 - (a_1 + a_2) - (-a_1) = 0"),
                    Line(
                        "The test: the tool neither moves nor turns.",
                        r"\left. J \begin{bmatrix} a_2 \\ -(a_1 + a_2) \\ 0 \\ -a_1 \end{bmatrix} \right|_{\theta_2 = 0} = \begin{bmatrix} 0 \\ 0 \\ 0 \\ 0 \\ 0 \\ 0 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara", "transforms": "upper", "quantities": {"J": {"jacobian": 4}}},
            ),
            right=(
                null_motion,
                r"\begin{bmatrix} a_2 \\ -(a_1 + a_2) \\ 0 \\ -a_1 \end{bmatrix}",
                WithSympy(
                    lambda sp: sp.Matrix([sp.Symbol("a_2"), -sp.Symbol("a_1") - sp.Symbol("a_2"), 0, -sp.Symbol("a_1")])
                ),
            ),
            wrong=(
                Wrong(
                    lambda a_1, a_2: [a_2, -(a_1 + a_2), 0, 0],
                    "the tool point rests, but the tool turns: joint 4 is to undo the turn of joints 1 and 2",
                    own=True,
                ),
                Wrong(
                    lambda a_1, a_2: [a_2, -(a_1 + a_2), 0, a_1],
                    "joint 4 turns about z_3, which points down: its rate has the other sign",
                    own=True,
                ),
                Wrong(
                    lambda a_1, a_2: [a_2, a_1 - a_2, 0, a_1],
                    "that is the folded arm, θ_2 = π; here it is stretched",
                    own=True,
                ),
                Wrong(
                    lambda a_1, a_2: [a_2, -a_1, 0, a_2 - a_1],
                    "the lever of joint 1 is the whole arm, a_1 + a_2, not link 1 alone",
                    own=True,
                ),
                Wrong(
                    lambda a_1, a_2: [a_2, a_1 + a_2, 0, a_1 + 2 * a_2],
                    "joint 2 is to turn against joint 1: the velocities of the tool are to cancel",
                    own=True,
                ),
            ),
        ),
        Task(
            name="equal_links",
            title="Where it happens",
            text="Take two equal links, $a_1 = a_2$, and leave the joint limits aside. Where in the workspace is the tool when the arm is folded, "
            "$\\theta_2 = \\pi$? Give one key: `outer`, `inner`, `inside` or `regular`.",
            asks=Choice(
                {
                    "outer": "on the outer limit of the workspace",
                    "inner": "on the inner limit, around a hole that the tool cannot enter",
                    "inside": "inside the workspace, with points that it reaches all around",
                    "regular": "inside, and the configuration is not singular any more",
                },
                "inside",
                because={
                    "outer": "on the outer limit the arm is stretched: the tool would be a_1 + a_2 from the first axis",
                    "inner": "the hole has the radius |a_1 − a_2|: what is left of it when the links are equal?",
                    "regular": "the determinant is zero at θ_2 = π whatever the lengths are",
                },
            ),
            hints=(
                "How far from the first axis is the tool of a folded arm?",
                "The distance is $|a_1 - a_2|$. Can the tool go to points around the place where it then is?",
                "With $a_1 = a_2$ the tool is on the first axis, in the middle of the disc that it reaches. The determinant is still zero.",
            ),
            right=("inside", ["inside"], {"inside"}),
            wrong=(
                Wrong("inner", "the hole has the radius"),
                Wrong("outer", "the arm is stretched"),
                Wrong("regular", "whatever the lengths are"),
                Wrong(["inside", "inner"], "one of them is asked for"),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="The end of a column with a rising carriage and a ram is at $[-d_3 S_1, d_3 C_1, d_2]^T$. Give the rank of its linear Jacobian"
            " $J_v$, $3 \\times 3$, at $d_3 = 0.4$ and at $d_3 = 0$: two numbers.",
            asks=Number((3, 2), labels=("the rank at d_3 = 0.4", "the rank at d_3 = 0")),
            hints=(
                "The first column is the lever turned by 90°: how long is it?",
                "$\\det J_v = d_3$ up to its sign; two columns never vanish.",
            ),
            right=([3, 2], "3, 2", np.array([3, 2])),
            wrong=(
                Wrong([3, 3], "at d_3 = 0 the end lies on the column's axis: turning does not move it", own=True),
                Wrong(
                    [2, 2],
                    "away from the column the three directions are at right angles to each other: rank 3",
                    own=True,
                ),
                Wrong([3, 1], "carriage and ram still move the end: only one direction is lost", own=True),
                Wrong([2, 3], "the two are exchanged: the rank falls where the lever is zero", own=True),
                Wrong([6, 5], "the linear part has three rows: no rank is larger", own=True),
                Wrong([3, 0], "a determinant of zero takes away one direction, not all", own=True),
                Wrong([4, 2], "J_v has three rows: no rank is larger", own=True),
                Wrong([0, 2], "turning, rising and going out move the end in three directions", own=True),
                Wrong([1, 2], "turning, rising and going out move the end in three directions", own=True),
            ),
        ),
    ),
)
