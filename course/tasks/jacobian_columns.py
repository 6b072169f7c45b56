"""Tasks of lesson 9, Jacobian columns derived one by one (document 002, with the cross product of document 000)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Quantity, Task, WithSympy, Wrong

_SIX = ("v_1", "v_2", "v_3", "w_1", "w_2", "w_3")

# -- the cross product -------------------------------------------------------------------------------------------------


def cross(v_1, v_2, v_3, w_1, w_2, w_3):
    """Return v × w."""
    return [v_2 * w_3 - v_3 * w_2, v_3 * w_1 - v_1 * w_3, v_1 * w_2 - v_2 * w_1]


CROSS = r"\begin{bmatrix} v_2 w_3 - v_3 w_2 \\ v_3 w_1 - v_1 w_3 \\ v_1 w_2 - v_2 w_1 \end{bmatrix}"


def _cross_sympy(sp):
    return sp.Matrix(sp.symbols("v_1 v_2 v_3")).cross(sp.Matrix(sp.symbols("w_1 w_2 w_3")))


def antisymmetric(v_1, v_2, v_3):
    """Return S(v), for which S(v) w = v × w."""
    return np.array([[0, -v_3, v_2], [v_3, 0, -v_1], [-v_2, v_1, 0]])


ANTISYMMETRIC = r"\begin{bmatrix} 0 & -v_3 & v_2 \\ v_3 & 0 & -v_1 \\ -v_2 & v_1 & 0 \end{bmatrix}"


def _antisymmetric_sympy(sp):
    v = sp.Matrix(sp.symbols("v_1 v_2 v_3"))
    return sp.Matrix.hstack(*(v.cross(sp.eye(3)[:, k]) for k in range(3)))


# -- planar 3R ---------------------------------------------------------------------------------------------------------


def _ends(q, *lengths):
    """Return the vectors of the links in the plane."""
    angles = np.cumsum(np.array(q[: len(lengths)], dtype=object))
    return [
        np.array([each * np.cos(angle), each * np.sin(angle), 0]) for each, angle in zip(lengths, angles, strict=True)
    ]


def pose(q, l_1, l_2, l_3):
    """Return A_1 A_2 A_3: the sum of the angles, the sum of the links."""
    t1, t12, t123 = q[0], q[0] + q[1], q[0] + q[1] + q[2]
    x = l_1 * np.cos(t1) + l_2 * np.cos(t12) + l_3 * np.cos(t123)
    y = l_1 * np.sin(t1) + l_2 * np.sin(t12) + l_3 * np.sin(t123)
    c, s = np.cos(t123), np.sin(t123)
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]])


_X, _Y = r"l_1 C_1 + l_2 C_{12} + l_3 C_{123}", r"l_1 S_1 + l_2 S_{12} + l_3 S_{123}"
POSE = rf"\begin{{bmatrix}} C_{{123}} & -S_{{123}} & 0 & {_X} \\ S_{{123}} & C_{{123}} & 0 & {_Y} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"


def first_lever(q, l_1, l_2, l_3):
    """Return P_{0,G} = P_G − P_0: all three links."""
    t1, t12, t123 = q[0], q[0] + q[1], q[0] + q[1] + q[2]
    x = l_1 * np.cos(t1) + l_2 * np.cos(t12) + l_3 * np.cos(t123)
    y = l_1 * np.sin(t1) + l_2 * np.sin(t12) + l_3 * np.sin(t123)
    return np.array([x, y, 0])


FIRST_LEVER = rf"\begin{{bmatrix}} {_X} \\ {_Y} \\ 0 \end{{bmatrix}}"


def third_lever(q, l_3):
    """Return P_{2,G} = P_G − P_2: the last link."""
    t123 = q[0] + q[1] + q[2]
    return np.array([l_3 * np.cos(t123), l_3 * np.sin(t123), 0])


THIRD_LEVER = r"\begin{bmatrix} l_3 C_{123} \\ l_3 S_{123} \\ 0 \end{bmatrix}"


def first_column(q, l_1, l_2, l_3):
    """Return J_L1 = z_0 × P_{0,G}."""
    x, y, _ = first_lever(q, l_1, l_2, l_3)
    return np.array([-y, x, 0])


FIRST_COLUMN = rf"\begin{{bmatrix}} -({_Y}) \\ {_X} \\ 0 \end{{bmatrix}}"


def third_column(q, l_3):
    """Return z_2 × P_{2,G} above z_2."""
    t123 = q[0] + q[1] + q[2]
    return np.array([-l_3 * np.sin(t123), l_3 * np.cos(t123), 0, 0, 0, 1])


THIRD_COLUMN = r"\begin{bmatrix} -l_3 S_{123} \\ l_3 C_{123} \\ 0 \\ 0 \\ 0 \\ 1 \end{bmatrix}"


def _links_sympy(sp, first):
    """Return the sum of the links from one on, as SymPy has it."""
    angles = [sp.Symbol("theta_1")]
    angles += [angles[0] + sp.Symbol("theta_2"), angles[0] + sp.Symbol("theta_2") + sp.Symbol("theta_3")]
    lengths = sp.symbols("l_1 l_2 l_3")
    links = [sp.Matrix([each * sp.cos(t), each * sp.sin(t), 0]) for each, t in zip(lengths, angles, strict=True)]
    return sum(links[first:], sp.zeros(3, 1)), angles[2]


def _pose_sympy(sp):
    p, angle = _links_sympy(sp, 0)
    turned = sp.Matrix([[sp.cos(angle), -sp.sin(angle), 0], [sp.sin(angle), sp.cos(angle), 0], [0, 0, 1]])
    return sp.Matrix.vstack(sp.Matrix.hstack(turned, p), sp.Matrix([[0, 0, 0, 1]]))


def _column_sympy(sp, first):
    return sp.Matrix([0, 0, 1]).cross(_links_sympy(sp, first)[0])


# -- other arms --------------------------------------------------------------------------------------------------------


def axis(q):
    """Return z_1, the third column of T_0^1 of the spatial arm."""
    return np.array([np.sin(q[0]), -np.cos(q[0]), 0])


AXIS = r"\begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix}"


def slide(theta, r):
    """Return z of the slide above three zeros."""
    return np.array([np.cos(theta), np.sin(theta), 0, 0, 0, 0])


SLIDE = r"\begin{bmatrix} \cos\theta \\ \sin\theta \\ 0 \\ 0 \\ 0 \\ 0 \end{bmatrix}"


def planar_2r(q, l_1, l_2):
    """Return the linear Jacobian of the planar 2R arm, 2×2."""
    t1, t12 = q[0], q[0] + q[1]
    return np.array([
        [-l_1 * np.sin(t1) - l_2 * np.sin(t12), -l_2 * np.sin(t12)],
        [l_1 * np.cos(t1) + l_2 * np.cos(t12), l_2 * np.cos(t12)],
    ])  # fmt: skip


PLANAR_2R = r"\begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}"


def _planar_sympy(sp):
    t1, t2, l1, l2 = sp.symbols("theta_1 theta_2 l_1 l_2")
    p = sp.Matrix([l1 * sp.cos(t1) + l2 * sp.cos(t1 + t2), l1 * sp.sin(t1) + l2 * sp.sin(t1 + t2)])
    return p.jacobian([t1, t2])


def polar_velocity(r, theta, u, w):
    """Return the velocity of the polar arm's tool for the rates u of r and w of θ."""
    return [u * np.cos(theta) - r * w * np.sin(theta), u * np.sin(theta) + r * w * np.cos(theta)]


VELOCITY = r"\begin{bmatrix} u \cos\theta - r w \sin\theta \\ u \sin\theta + r w \cos\theta \end{bmatrix}"


def _velocity_sympy(sp):
    r, t, u, w = sp.symbols("r theta u w")
    p = sp.Matrix([r * sp.cos(t), r * sp.sin(t)])
    return p.diff(r) * u + p.diff(t) * w


def polar_linear(theta, r):
    """Return J_L of the polar arm, columns r and θ."""
    return np.array([[np.cos(theta), -r * np.sin(theta)], [np.sin(theta), r * np.cos(theta)]])


POLAR = r"\begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \end{bmatrix}"


def _polar_sympy(sp):
    r, t = sp.symbols("r theta")
    return sp.Matrix([r * sp.cos(t), r * sp.sin(t)]).jacobian([r, t])


def polar_whole(theta, r):
    """Return J of the polar arm with the row of ω, columns r and θ."""
    return np.array([[np.cos(theta), -r * np.sin(theta)], [np.sin(theta), r * np.cos(theta)], [0, 1]])


WHOLE = r"\begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \\ 0 & 1 \end{bmatrix}"


# -- an arm that nobody has seen ---------------------------------------------------------------------------------------

BOOM = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "h", "theta": "theta_1"},
        {"alpha": "pi/2", "a": 0, "d": 0, "theta": "theta_2"},
        {"alpha": 0, "a": "b", "d": 0, "theta": 0},
    ],
    "joints": ["theta_1", "theta_2"],
}


def boom_column(q, b):
    """Return z_2 × p above z_2: the boom's end moves across the boom, in its vertical plane."""
    (c1, c2), (s1, s2) = np.cos(q), np.sin(q)
    return np.array([-b * c1 * s2, -b * s1 * s2, b * c2, s1, -c1, 0])


BOOM_COLUMN = r"\begin{bmatrix} -b C_1 S_2 \\ -b S_1 S_2 \\ b C_2 \\ S_1 \\ -C_1 \\ 0 \end{bmatrix}"


def _boom_sympy(sp):
    t1, t2, b = sp.symbols("theta_1 theta_2 b")
    lever = b * sp.Matrix([sp.cos(t1) * sp.cos(t2), sp.sin(t1) * sp.cos(t2), sp.sin(t2)])
    axis = sp.Matrix([sp.sin(t1), -sp.cos(t1), 0])
    return axis.cross(lever).col_join(axis)


LESSON = Lesson(
    number=9,
    name="jacobian_columns",
    title="Jacobian columns, one by one",
    source="Modélisation et commande des robots de manipulation, chapter 3, Université de Constantine 1 (document 002)",
    objectives=(
        "Take a cross product by its definition and by a matrix.",
        "Derive the column of one joint: axis, lever, cross product.",
        "Write the Jacobians of the planar 2R and of the polar arm without help.",
    ),
    tasks=(
        Task(
            name="models",
            title="Two models",
            text="The inverse velocity model finds the joint rates $\\dot q$. What must be given? Keys: `q` (joint values), `v` (velocity of the"
            " tool), `rates` (joint rates), `acc` (acceleration of the tool). Give a list.",
            asks=Choice(
                {"q": "joint values", "v": "velocity of the tool", "rates": "joint rates", "acc": "acceleration"},
                right=frozenset({"q", "v"}),
                because={
                    "rates": "the rates are what is looked for; the direct model takes them",
                    "acc": "the model is one of velocities: no acceleration is in it",
                },
                missing={
                    "q": "the Jacobian depends on the configuration: it must be known",
                    "v": "without the velocity that is wanted there is nothing to solve for",
                },
            ),
            hints=(
                "Write $\\dot X = J(q)\\,\\dot q$. Which letters stand where?",
                "It is solved for $\\dot q$; everything else must be known.",
                "$\\dot X$, and what $J$ depends on.",
            ),
            right=(["q", "v"], "q, v", {"v", "q"}),
            wrong=(
                Wrong(["v"], "depends on the configuration"),
                Wrong(["q"], "nothing to solve for"),
                Wrong(["q", "rates"], "what is looked for"),
                Wrong(["q", "v", "acc"], "no acceleration is in it"),
            ),
        ),
        Task(
            name="size",
            title="Sizes",
            text="An arm has 7 joints. Give the rows and columns of $J$ (linear and angular part), then those of $\\dot q$: four numbers.",
            asks=Number(
                (6, 7, 7, 1),
                labels=(
                    "the number of rows of J",
                    "the number of columns of J",
                    "the number of rows of q̇",
                    "the number of columns of q̇",
                ),
                steps=("3 + 3", "7", "7", "1"),
                beside=("[6 + 7, , ,]",),
            ),
            hints=(
                "$[V; W] = J \\dot q$: how many entries has the left side?",
                "Six rows; one column a joint.",
                "$\\dot q$ is one column. (The slide writes $n \\times 6$ under it: a slip.)",
            ),
            right=([6, 7, 7, 1], "6, 7, 7, 1", np.array([6, 7, 7, 1])),
            wrong=(
                Wrong([6, 7, 7, 6], "this is the slip of the slide: the joint rates are one column", own=True),
                Wrong([7, 6, 7, 1], "J is on its side: six rows, one column a joint", own=True),
                Wrong([6, 6, 7, 1], "one column a joint: there are seven", own=True),
                Wrong([3, 7, 7, 1], "linear and angular part: three and three rows", own=True),
                Wrong(
                    [7, 7, 7, 1], "J is square for six joints only: it has six rows for any number of joints", own=True
                ),
                Wrong([6, 7, 6, 1], "the velocity of the tool has six entries; q̇ has one a joint", own=True),
                Wrong(
                    [4, 7, 7, 1],
                    "no fourth row as in a homogeneous vector: three linear rows and three angular ones",
                    own=True,
                ),
                Wrong([6, 8, 7, 1], "the base is no joint: one column a joint, seven", own=True),
                Wrong([6, 7, 8, 1], "the base has no rate: one entry a joint, seven", own=True),
                Wrong([6, 7, 1, 7], "q̇ is a column here, not a row", own=True),
                Wrong([6, 7, 7, 7], "q̇ is one column, and no square matrix", own=True),
                Wrong([12, 7, 7, 1], "six rows in all: three linear, three angular", own=True),
                Wrong([6, 1, 7, 1], "one column would be one joint: there is one a joint", own=True),
            ),
        ),
        Task(
            name="contribution",
            title="The joints add up",
            text="$J_{L1} = [-0.8, 0.3, 0]^T$ and $J_{L2} = [-0.3, 0.5, 0]^T$ (m). The rates are $\\dot q_1 = -2$ and $\\dot q_2 = 3$ rad/s. Give the"
            " velocity of the tool in m/s: `[v_x, v_y, v_z]`.",
            asks=Number(
                (0.7, 0.9, 0),
                unit="m/s",
                labels=("v_x", "v_y", "v_z"),
                steps=(r"-2 \cdot (-0.8) + 3 \cdot (-0.3)", r"-2 \cdot 0.3 + 3 \cdot 0.5", "0"),
                beside=(
                    r"[v_x, v_y, \omega_z] = [0.7, 0.9, 1]",
                    "J_{L1} = [-0.8, 0.3, 0]",
                    "J_{L2} = [-0.3, 0.5, 0]",
                    r"J_{L1} + J_{L2} = [-0.8 - 0.3, 0.3 + 0.5, 0]",
                    r"J_{L2} - J_{L1} = [-0.3 + 0.8, 0.5 - 0.3, 0]",
                    r"3 J_{L1} - 2 J_{L2} = [-3 \cdot 0.8 + 2 \cdot 0.3, 3 \cdot 0.3 - 2 \cdot 0.5, 0]",
                ),
            ),
            hints=(
                "Each joint adds its column times its rate.",
                "Joint 1 alone: $[1.6, -0.6, 0]^T$.",
                "Joint 2 alone: $[-0.9, 1.5, 0]^T$. Add both.",
            ),
            right=([0.7, 0.9, 0], "0.7, 0.9, 0", np.array([0.7, 0.9, 0])),
            wrong=(
                Wrong([-1.1, 0.8, 0], "the columns are added without their rates", own=True),
                Wrong([-2.5, 2.1, 0], "the sign of the first rate is lost: joint 1 turns backwards", own=True),
                Wrong([-0.9, 1.5, 0], "this is the contribution of joint 2 alone", own=True),
                Wrong([1.6, -0.6, 0], "this is the contribution of joint 1 alone", own=True),
                Wrong([-1.8, -0.1, 0], "the rates are exchanged", own=True),
                Wrong([2.5, -2.1, 0], "the sign of the second rate is wrong: joint 2 turns forwards", own=True),
            ),
        ),
        Task(
            name="cross",
            title="The cross product, by its definition",
            text="Write $v \\times w$ (3 rows) in `v_1`, `v_2`, `v_3`, `w_1`, `w_2`, `w_3`.",
            asks=Formula(CROSS, _SIX),
            hints=(
                "Row 1 has no component 1 in it.",
                "Row 1: $v_2 w_3 - v_3 w_2$. Move every index one on for row 2, 3 becoming 1.",
                "Row 2: $v_3 w_1 - v_1 w_3$.",
            ),
            right=(cross, CROSS, WithSympy(_cross_sympy)),
            wrong=(
                Wrong(lambda *of: [-each for each in cross(*of)], "this is w × v: the order makes the sign", own=True),
                Wrong(
                    CROSS.replace("v_3 w_1 - v_1 w_3", "v_1 w_3 - v_3 w_1"),
                    "the middle row has the wrong sign: it begins with the third component of v",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} v_1 w_1 \\ v_2 w_2 \\ v_3 w_3 \end{bmatrix}",
                    "products entry by entry are no cross product: row 1 has the components 2 and 3",
                    own=True,
                ),
                Wrong(CROSS.replace("- v_3 w_2", "+ v_3 w_2"), "sign"),
                Wrong(r"v_1 w_1 + v_2 w_2 + v_3 w_3", "this is the scalar product, one number", own=True),
            ),
        ),
        Task(
            name="antisymmetric",
            title="The cross product, by a matrix",
            text="Write the matrix $S(v)$, 3×3, for which $S(v)\\,w = v \\times w$ for every $w$: in `v_1`, `v_2`, `v_3`.",
            asks=Formula(ANTISYMMETRIC, ("v_1", "v_2", "v_3")),
            hints=(
                "Its columns are $v \\times x$, $v \\times y$, $v \\times z$ for the three unit vectors.",
                "Row 1 of $v \\times w$ is $-v_3 w_2 + v_2 w_3$: what stands beside $w_1$, $w_2$, $w_3$?",
                "Zeros on the diagonal, and $S^T = -S$.",
            ),
            right=(antisymmetric, ANTISYMMETRIC, WithSympy(_antisymmetric_sympy)),
            wrong=(
                Wrong(
                    lambda v_1, v_2, v_3: -antisymmetric(v_1, v_2, v_3),
                    "this gives w × v: all signs are turned",
                    own=True,
                ),
                Wrong(
                    lambda v_1, v_2, v_3: np.array([[0, v_3, v_2], [v_3, 0, v_1], [v_2, v_1, 0]]),
                    "this is symmetric: entries across the diagonal have opposite signs",
                    own=True,
                ),
                Wrong(
                    lambda v_1, v_2, v_3: np.array([[v_1, 0, 0], [0, v_2, 0], [0, 0, v_3]]),
                    "a diagonal matrix multiplies entry by entry: the diagonal is zero here",
                    own=True,
                ),
                Wrong(
                    ANTISYMMETRIC.replace("& v_2 ", "& -v_2 ").replace("-v_2 & v_1", "v_2 & v_1"),
                    "the sign of v_2 is turned: row 1 of v × w is + v_2 w_3",
                    own=True,
                ),
            ),
        ),
        Task(
            name="turning",
            title="A revolute joint: from a turn to a velocity",
            text="A body turns about the $z$ axis at 3 rad/s. Give the velocity of its point $[0.3, 0.4, 0.65]^T$ (m), in m/s: `[v_x, v_y, v_z]`.",
            asks=Number(
                (-1.2, 0.9, 0),
                unit="m/s",
                labels=("v_x", "v_y", "v_z"),
                steps=(r"-3 \cdot 0.4", r"3 \cdot 0.3", "0"),
                beside=(
                    r"3 x_0 \times{} p = [0, -3 \cdot 0.65, 3 \cdot 0.4]",
                    r"3 y_0 \times{} p = [3 \cdot 0.65, 0, -3 \cdot 0.3]",
                    r"z_0 \times{} p / 3 = [-0.4/3, 0.3/3, 0]",
                    r"3^2 z_0 \times{} p = [-3^2 \cdot 0.4, 3^2 \cdot 0.3, 0]",
                    r"3 p_{xy} = [3 \cdot 0.3, 3 \cdot 0.4, 0]",
                    r"-3^2 p_{xy} = [-3^2 \cdot 0.3, -3^2 \cdot 0.4, 0]",
                    r"\omega = [0, 0, 3]",
                    r"\omega |p_{xy}| y_0 = [0, 3 \cdot \sqrt{(0.3^2 + 0.4^2)}, 0]",
                    "p = [0.3, 0.4, 0.65]",
                    r"[v_x, v_y, \omega] = [-1.2, 0.9, 3]",
                    r"[-3 x, 3 y, 0] = [-3 \cdot 0.3, 3 \cdot 0.4, 0]",
                ),
            ),
            hints=(
                "$v = \\omega \\times r$: a cross product, although the slide writes a dot.",
                "$[0, 0, 1]^T \\times [x, y, z]^T = [-y, x, 0]^T$.",
                "Three times $[-0.4, 0.3, 0]^T$.",
            ),
            right=([-1.2, 0.9, 0], "-1.2, 0.9, 0", np.array([-1.2, 0.9, 0])),
            wrong=(
                Wrong(
                    [0.9, 1.2, 1.95], "this is ω times r: a velocity is at right angles to the lever, ω × r", own=True
                ),
                Wrong([1.2, -0.9, 0], "this is r × ω: by the right-hand rule x goes towards y", own=True),
                Wrong([-0.4, 0.3, 0], "this is for 1 rad/s", own=True),
                Wrong([-1.2, 0.9, 1.95], "a point stays at its height: v_z is zero", own=True),
            ),
        ),
        Task(
            name="slide",
            title="A prismatic joint: the whole column",
            text="Write the column of the slide $r$ of the polar arm, for its tool: 6 rows $[v; \\omega]$ in frame 0, in `theta`.",
            asks=Quantity("polar_rp", {"jacobian": 2, "columns": [2]}),
            hints=(
                "The slide extends at 1 m/s. In which direction does the tool move, and does it turn?",
                "Along the arm, which points along $\\theta$.",
                "$[\\cos\\theta, \\sin\\theta, 0]^T$ above three zeros.",
            ),
            right=(
                slide,
                SLIDE,
                WithSympy(lambda sp: sp.Matrix([sp.cos(sp.Symbol("theta")), sp.sin(sp.Symbol("theta")), 0, 0, 0, 0])),
            ),
            wrong=(
                Wrong(
                    lambda theta, r: np.array([np.cos(theta), np.sin(theta), 0, np.cos(theta), np.sin(theta), 0]),
                    "a slide does not turn the tool: the lower half is zero",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: np.array([r * np.cos(theta), r * np.sin(theta), 0, 0, 0, 0]),
                    "this is the position: its derivative by r has no r left",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: np.array([-np.sin(theta), np.cos(theta), 0, 0, 0, 0]),
                    "this is across the arm, where the turn moves it: the slide moves it along the arm",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: np.array([1, 0, 0, 0, 0, 0]),
                    "this is along x_0: the arm has turned by θ",
                    own=True,
                ),
                Wrong(lambda theta, r: -slide(theta, r), "sign"),
            ),
        ),
        Task(
            name="axes",
            title="An axis as a third column",
            text="The spatial arm of lesson 11 has $T_0^1 = \\begin{bmatrix} C_1 & 0 & S_1 & 0 \\\\ S_1 & 0 & -C_1 & 0 \\\\ 0 & 1 & 0 & l_1 \\\\ 0 & 0 & 0 & 1"
            " \\end{bmatrix}$. Write $z_1$ (3 rows) in frame 0: the axis of joint 2.",
            asks=Quantity("spatial_rrr", {"axis": 1}),
            hints=(
                "Multiply $T_0^1$ by $[0, 0, 1, 0]^T$.",
                "That takes its third column.",
                "Three rows: the zero below is left out.",
            ),
            right=(
                axis,
                AXIS,
                WithSympy(lambda sp: sp.Matrix([sp.sin(sp.Symbol("theta_1")), -sp.cos(sp.Symbol("theta_1")), 0])),
            ),
            wrong=(
                Wrong(r"\begin{bmatrix} C_1 \\ S_1 \\ 0 \end{bmatrix}", "this is x_1, the first column", own=True),
                Wrong(
                    r"\begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}",
                    "this is y_1, and z_0: joint 2 turns about a level axis",
                    own=True,
                ),
                Wrong(lambda q: -axis(q), "sign"),
                Wrong(
                    r"\begin{bmatrix} 0 \\ 0 \\ l_1 \end{bmatrix}",
                    "this is the fourth column, the origin: an axis is the third",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} 0 \\ 1 \\ 0 \end{bmatrix}", "this is the third row: axes are columns", own=True
                ),
            ),
        ),
        Task(
            name="planar_axes",
            title="Planar 3R: the axes",
            text="Give $z_2$ of the planar 3R arm in frame 0, at $\\theta_1 = 40°$ and $\\theta_2 = 72°$: `[x, y, z]`.",
            asks=Number(
                (0, 0, 1),
                labels=("x", "y", "z"),
                beside=(
                    r"\theta_1 = [, , 40]",
                    r"\theta_2 = [, , 72]",
                    r"\theta_1 + \theta_2 = [, , 40 + 72]",
                    r"\sin(\theta_1 + \theta_2) = [, , \sin 112^\circ]",
                    r"\cos(\theta_1 + \theta_2) = [, , \cos 112^\circ]",
                    r"\theta_1 + \theta_2 = [, , (40 + 72) \cdot \pi/180]",
                    "x_0 = [1, 0, 0]",
                    "y_0 = [0, 1, 0]",
                    r"x_1 = [\cos 40^\circ, \sin 40^\circ, 0]",
                    r"y_1 = [-\sin 40^\circ, \cos 40^\circ, 0]",
                    r"y_2 = [-\sin 112^\circ, \cos 112^\circ, 0]",
                    r"[\cos\theta_2, \sin\theta_2, 0] = [\cos 72^\circ, \sin 72^\circ, 0]",
                    r"[-\sin\theta_2, \cos\theta_2, 0] = [-\sin 72^\circ, \cos 72^\circ, 0]",
                    r"[\sin(\theta_1 + \theta_2), \cos(\theta_1 + \theta_2), 0] = [\sin 112^\circ, \cos 112^\circ, 0]",
                    r"[\sin\theta_1, \cos\theta_1, 0] = [\sin 40^\circ, \cos 40^\circ, 0]",
                    r"[\cos(\theta_1 - \theta_2), \sin(\theta_1 - \theta_2), 0] = [\cos 32^\circ, -\sin 32^\circ, 0]",
                    r"[\cos\theta_1, -\sin\theta_1, 0] = [\cos 40^\circ, -\sin 40^\circ, 0]",
                ),
            ),
            hints=(
                "The third column of $A_1 A_2$.",
                "All turns are about $z$: what do they do to the $z$ axis?",
                "The same for $z_0$, $z_1$ and $z_2$.",
            ),
            right=([0, 0, 1], "0, 0, 1", np.array([0, 0, 1])),
            wrong=(
                Wrong([1, 0, 0], "this is x_0; the axis of a joint is its z axis, across the plane", own=True),
                Wrong([0, 0, -1], "all z axes point out of the plane, like z_0", own=True),
                Wrong([0, 0, 3], "an axis has length one", own=True),
                Wrong(
                    [np.cos(np.deg2rad(112)), np.sin(np.deg2rad(112)), 0],
                    "this is the direction of link 2, x_2: the axis stands across the plane",
                    own=True,
                ),
            ),
        ),
        Task(
            name="pose",
            title="Planar 3R: the product",
            text="Write $A_1 A_2 A_3$ of the planar 3R arm, the pose of frame 3 in frame 0, 4×4.",
            asks=Quantity("planar_3r", {"pose": 3}),
            hints=(
                "Each $A_i$ turns by $\\theta_i$ and moves by $l_i$ along the new $x$.",
                "The angles add up; each link points along the sum of all angles up to its own.",
                "The origin: $l_1 C_1 + l_2 C_{12} + l_3 C_{123}$, and the same with sines.",
            ),
            right=(pose, POSE, WithSympy(_pose_sympy)),
            wrong=(
                Wrong(
                    POSE.replace("_{123} & -S", "_{12} & -S")
                    .replace("_{123} & 0", "_{12} & 0")
                    .replace("_{123} & C", "_{12} & C"),
                    "the rotation lacks θ_3: all three angles add up",
                    own=True,
                ),
                Wrong(
                    POSE.replace("l_2 C_{12}", "l_2 C_2").replace("l_2 S_{12}", "l_2 S_2"),
                    "link 2 is carried by link 1: its direction is θ_1 + θ_2",
                    own=True,
                ),
                Wrong(lambda q, l_1, l_2, l_3: pose(q, l_1, l_2, l_3).T, "transposed"),
                Wrong(
                    lambda q, l_1, l_2, l_3: pose(q, l_1, l_2, 0), "the last link is missing in the origin", own=True
                ),
                Wrong(lambda q, l_1, l_2, l_3: pose(np.deg2rad(q), l_1, l_2, l_3), "degrees"),
            ),
        ),
        Task(
            name="first_lever",
            title="Planar 3R: the first lever",
            text="Write $P_{0,G} = P_G - P_0$ (3 rows, m), from joint 1 to the gripper.",
            asks=Quantity("planar_3r", {"difference": [3, 0]}),
            hints=(
                "Joint 1 sits at the origin of frame 0.",
                "So it is the fourth column of $A_1 A_2 A_3$.",
                "All three links; the third row is zero.",
            ),
            right=(first_lever, FIRST_LEVER, WithSympy(lambda sp: _links_sympy(sp, 0)[0])),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} l_1 C_1 \\ l_1 S_1 \\ 0 \end{bmatrix}",
                    "this ends at joint 2: the lever ends at the gripper",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} l_2 C_{12} + l_3 C_{123} \\ l_2 S_{12} + l_3 S_{123} \\ 0 \end{bmatrix}",
                    "this is P_{1,G}, which starts at joint 2",
                    own=True,
                ),
                Wrong(lambda q, l_1, l_2, l_3: -first_lever(q, l_1, l_2, l_3), "sign"),
                Wrong(
                    lambda q, l_1, l_2, l_3: first_column(q, l_1, l_2, l_3),
                    "this is the velocity already, z_0 × P_{0,G}: the lever itself is asked",
                    own=True,
                ),
                Wrong(lambda q, l_1, l_2, l_3: first_lever(q, l_1, l_3, l_2), "swapped"),
            ),
        ),
        Task(
            name="third_lever",
            title="Planar 3R: the third lever",
            text="Write $P_{2,G} = P_G - P_2$ (3 rows, in frame 0, m).",
            asks=Quantity("planar_3r", {"difference": [3, 2]}),
            hints=(
                "Which links lie behind joint 3?",
                "Only the last one. In which direction does it point, seen from frame 0?",
                "Along $\\theta_1 + \\theta_2 + \\theta_3$.",
            ),
            right=(third_lever, THIRD_LEVER, WithSympy(lambda sp: _links_sympy(sp, 2)[0])),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} l_3 C_3 \\ l_3 S_3 \\ 0 \end{bmatrix}",
                    "this is in frame 2: in frame 0 the direction starts with θ_1 and θ_2",
                    own=True,
                ),
                Wrong(FIRST_LEVER, "this starts at joint 1: links 1 and 2 lie before joint 3", own=True),
                Wrong(
                    r"\begin{bmatrix} l_3 \\ 0 \\ 0 \end{bmatrix}",
                    "this is in frame 3: turn it by all three angles",
                    own=True,
                ),
                Wrong(lambda q, l_3: -third_lever(q, l_3), "sign"),
                Wrong(
                    lambda q, l_3: np.array([-l_3 * np.sin(q[0] + q[1] + q[2]), l_3 * np.cos(q[0] + q[1] + q[2]), 0]),
                    "this is z_2 × P_{2,G} already: the lever itself is asked",
                    own=True,
                ),
            ),
        ),
        Task(
            name="first_column",
            title="Planar 3R: the first column",
            text="Write $J_{L1} = z_0 \\times P_{0,G}$ (3 rows).",
            asks=Quantity("planar_3r", {"jacobian": 3, "rows": [1, 2, 3], "columns": [1]}),
            hints=(
                "$[0, 0, 1]^T \\times [x, y, 0]^T = [-y, x, 0]^T$.",
                "Row 1 is minus the second row of the lever: all of it.",
                "Row 2 is the first row of the lever.",
            ),
            right=(first_column, FIRST_COLUMN, WithSympy(lambda sp: _column_sympy(sp, 0))),
            wrong=(
                Wrong(FIRST_LEVER, "this is the lever: cross z_0 with it", own=True),
                Wrong(
                    lambda q, l_1, l_2, l_3: -first_column(q, l_1, l_2, l_3),
                    "this is P_{0,G} × z_0: the axis stands first",
                    own=True,
                ),
                Wrong(
                    FIRST_COLUMN.replace("-(l_1 S_1 + l_2", "(-l_1 S_1 + l_2"),
                    "the minus goes to all three terms of row 1",
                    own=True,
                ),
                Wrong(
                    lambda q, l_1, l_2, l_3: first_column(q, 0, l_2, l_3),
                    "this is column 2: joint 1 moves link 1 too",
                    own=True,
                ),
                Wrong(lambda q, l_1, l_2, l_3: first_column(q, l_1, l_2, 0), "frame 2, not 3"),
            ),
        ),
        Task(
            name="third_column",
            title="Planar 3R: the third column, whole",
            text="Write the whole third column of $J$: 6 rows, $z_2 \\times P_{2,G}$ above $z_2$.",
            asks=Quantity("planar_3r", {"jacobian": 3, "columns": [3]}),
            hints=(
                "You have the lever and the axis.",
                "Above: $[-y, x, 0]^T$ of the lever.",
                "Below: $[0, 0, 1]^T$.",
            ),
            right=(third_column, THIRD_COLUMN, WithSympy(lambda sp: sp.Matrix([*_column_sympy(sp, 2), 0, 0, 1]))),
            wrong=(
                Wrong(
                    lambda q, l_3: np.roll(third_column(q, l_3), 3),
                    "the halves are exchanged: the linear part stands above",
                    own=True,
                ),
                Wrong(
                    lambda q, l_3: third_column(q, l_3) * np.array([1, 1, 1, 0, 0, 0]),
                    "this would be a slide: a revolute joint turns the gripper, z_2 below",
                    own=True,
                ),
                Wrong(
                    lambda q, l_3: np.array(
                        [l_3 * np.cos(q[0] + q[1] + q[2]), l_3 * np.sin(q[0] + q[1] + q[2]), 0, 0, 0, 1]
                    ),
                    "the lever stands above: cross the axis with it",
                    own=True,
                ),
                Wrong(THIRD_COLUMN.replace("-l_3", "l_3"), "sign"),
                Wrong(
                    lambda q, l_3: third_column([0, 0, q[2]], l_3),
                    "the direction of link 3 is θ_1 + θ_2 + θ_3, not θ_3",
                    own=True,
                ),
            ),
        ),
        Task(
            name="planar_2r",
            title="Planar 2R: the Jacobian",
            text="Now alone: write the Jacobian of the planar 2R arm's tool, rows $v_x$, $v_y$, 2×2. A function takes `q` and the lengths `l_1`, `l_2`.",
            asks=Quantity("planar_2r", {"jacobian": 2, "rows": [1, 2]}),
            hints=(
                "Two ways: cross products with two levers, or derivatives of the position.",
                "Column 1 has both links, column 2 the second one.",
                "Row 1 is minus the sines, row 2 the cosines.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The tool.",
                        r"p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 1: the axis times the lever from the base.",
                        r"z_0 \times (p_2 - p_0) = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Column 2: the lever from the elbow.",
                        r"z_1 \times (p_2 - p_1) = \begin{bmatrix} -l_2 S_{12} \\ l_2 C_{12} \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "The rows of the plane, side by side.",
                        r"J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}",
                    ),
                ),
                {"arm": "planar_2r", "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}}},
            ),
            right=(planar_2r, PLANAR_2R, WithSympy(_planar_sympy)),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} -l_1 S_1 & -l_2 S_{12} \\ l_1 C_1 & l_2 C_{12} \end{bmatrix}",
                    "each column holds one link: joint 1 moves both",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} -l_1 S_1 - l_2 S_2 & -l_2 S_2 \\ l_1 C_1 + l_2 C_2 & l_2 C_2 \end{bmatrix}",
                    "θ_2 is taken from the base: link 2 points along θ_1 + θ_2",
                    own=True,
                ),
                Wrong(PLANAR_2R.replace("& -l_2", "& l_2"), "sign"),
                Wrong(lambda q, l_1, l_2: planar_2r(q, l_1, l_2).T, "transposed"),
                Wrong(
                    lambda q, l_1, l_2: planar_2r(q, l_1, l_2)[:, ::-1],
                    "the columns are exchanged: joint 1 is first",
                    own=True,
                ),
                Wrong(lambda q, l_1, l_2: planar_2r(q, l_2, l_1), "swapped"),
            ),
        ),
        Task(
            name="polar_velocity",
            title="Polar arm: the velocity",
            text="The tool of the polar arm stands at $[r\\cos\\theta, r\\sin\\theta]^T$. Let $\\dot r = u$ and $\\dot\\theta = w$. Write its velocity, 2 rows, in"
            " `r`, `theta`, `u`, `w`.",
            asks=Formula(VELOCITY, ("r", "theta", "u", "w"), arm="polar_rp", unit="m/s"),
            hints=(
                "A product and a chain: both $r$ and $\\theta$ depend on time.",
                "$\\frac{d}{dt}(r\\cos\\theta) = \\dot r\\cos\\theta - r\\dot\\theta\\sin\\theta$.",
                "Row 2 the same with sine for cosine, and a plus.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The place of the tool.", r"p_2 = \begin{bmatrix} r\cos\theta \\ r\sin\theta \\ 0 \end{bmatrix}"
                    ),
                    Line(
                        "Differentiated by $r$ alone: the direction of the slide.",
                        r"\frac{\partial}{\partial r} \begin{bmatrix} r\cos\theta \\ r\sin\theta \end{bmatrix} = \begin{bmatrix} \cos\theta \\ \sin\theta \end{bmatrix}",
                    ),
                    Line(
                        "Differentiated by $\\theta$ alone: across the arm, with the lever $r$.",
                        r"\frac{\partial}{\partial \theta} \begin{bmatrix} r\cos\theta \\ r\sin\theta \end{bmatrix} = \begin{bmatrix} -r\sin\theta \\ r\cos\theta \end{bmatrix}",
                    ),
                    Line(
                        "Each times its rate, $\\dot r = u$ and $\\dot\\theta = w$, and added.",
                        r"\frac{d}{dt} \begin{bmatrix} r\cos\theta \\ r\sin\theta \end{bmatrix} = \begin{bmatrix} \dot r\cos\theta - r\dot\theta\sin\theta \\ \dot r\sin\theta + r\dot\theta\cos\theta \end{bmatrix}",
                    ),
                ),
                {"arm": "polar_rp"},
            ),
            right=(polar_velocity, VELOCITY, WithSympy(_velocity_sympy)),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} u \cos\theta \\ u \sin\theta \end{bmatrix}",
                    "θ varies as well: the terms in w are missing",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} -r w \sin\theta \\ r w \cos\theta \end{bmatrix}",
                    "r varies as well: the terms in u are missing",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} -u w \sin\theta \\ u w \cos\theta \end{bmatrix}",
                    "the derivative of a product is no product of derivatives: two terms a row",
                    own=True,
                ),
                Wrong(VELOCITY.replace("- r w", "+ r w"), "sign"),
                Wrong(
                    VELOCITY.replace("r w", "w"), "the lever r is missing: the velocity across the arm is r w", own=True
                ),
            ),
        ),
        Task(
            name="polar_linear",
            title="Polar arm: its linear Jacobian",
            text="Write $J_L$ of the polar arm, 2×2: rows $\\dot X$, $\\dot Y$, columns $r$, $\\theta$ in this order.",
            asks=Quantity("polar_rp", {"jacobian": 2, "rows": [1, 2], "columns": [2, 1]}),
            hints=(
                "What stands beside $u$, and what beside $w$, in the velocity?",
                "Column 1 is along the arm, column 2 across it.",
                "Column 2 is $r$ times $[-\\sin\\theta, \\cos\\theta]^T$.",
            ),
            right=(polar_linear, POLAR, WithSympy(_polar_sympy)),
            wrong=(
                Wrong(
                    lambda theta, r: polar_linear(theta, r)[:, ::-1],
                    "the columns are exchanged: r is the first here",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: polar_linear(theta, 1),
                    "the lever r is missing in column 2",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: np.array(
                        [[np.cos(theta), np.sin(theta)], [-r * np.sin(theta), r * np.cos(theta)]]
                    ),
                    "rows and columns are exchanged: a column belongs to a joint",
                    own=True,
                ),
                Wrong(POLAR.replace(r"-r\sin", r"r\sin"), "sign"),
            ),
        ),
        Task(
            name="polar_whole",
            title="Polar arm: with the angular row",
            text="Add the row of $\\omega$, the rate of the tool's angle: 3×2, rows $\\dot X$, $\\dot Y$, $\\omega$, columns $r$, $\\theta$.",
            asks=Quantity("polar_rp", {"jacobian": 2, "rows": [1, 2, 6], "columns": [2, 1]}),
            hints=(
                "Which of the two joints turns the tool?",
                "A slide has a zero there, a revolute joint a one.",
                "The last row is $0, 1$.",
            ),
            right=(polar_whole, WHOLE, WithSympy(lambda sp: _polar_sympy(sp).col_join(sp.Matrix([[0, 1]])))),
            wrong=(
                Wrong(
                    WHOLE.replace("0 & 1", "1 & 0"),
                    "the slide does not turn the tool, the revolute joint does: 0, 1",
                    own=True,
                ),
                Wrong(WHOLE.replace("0 & 1", "1 & 1"), "only one of the joints turns the tool", own=True),
                Wrong(
                    lambda theta, r: polar_linear(theta, r),
                    "the row of ω is missing: three rows",
                    own=True,
                ),
                Wrong(WHOLE.replace("0 & 1", "0 & r"), "ω is the rate of θ itself, without a lever", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A column turns by $\\theta_1$; on it, at the height $h$, a boom of length $b$ is raised by $\\theta_2$ about the axis $[S_1, -C_1, 0]^T$. The"
            " boom's end is at $[b C_1 C_2, b S_1 C_2, h + b S_2]^T$. Write the whole column of joint 2: 6 rows $[v; \\omega]$ in frame 0. A function takes `q` and"
            " `b`.",
            asks=Quantity(BOOM, {"jacobian": 3, "columns": [2]}),
            hints=(
                "Axis times lever above, axis below. Where does the lever begin?",
                "The axis of joint 2 passes $[0, 0, h]^T$: the lever is $b\\,[C_1 C_2, S_1 C_2, S_2]^T$.",
                "Test it: the derivatives of the position with respect to $\\theta_2$ are the first three rows.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The axis of joint 2.",
                        r"z_2 = \begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "The lever begins on that axis, at the height $h$.",
                        r"p_3 - p_2 = \begin{bmatrix} b C_1 C_2 \\ b S_1 C_2 \\ b S_2 \end{bmatrix}",
                    ),
                    Line(
                        "Axis times lever: the velocity.",
                        r"z_2 \times (p_3 - p_2) = \begin{bmatrix} -b C_1 S_2 \\ -b S_1 S_2 \\ b C_2 \end{bmatrix}",
                    ),
                    Line(
                        "The derivatives of the position are the same.",
                        r"\frac{\partial p_3}{\partial \theta_2} = \begin{bmatrix} -b C_1 S_2 \\ -b S_1 S_2 \\ b C_2 \end{bmatrix}",
                    ),
                    Line(
                        "The whole column, with the axis below.",
                        r"J_2 = \begin{bmatrix} -b C_1 S_2 \\ -b S_1 S_2 \\ b C_2 \\ S_1 \\ -C_1 \\ 0 \end{bmatrix}",
                    ),
                ),
                {"arm": BOOM, "quantities": {"J_2": {"jacobian": 3, "columns": [2]}}},
            ),
            right=(boom_column, BOOM_COLUMN, WithSympy(_boom_sympy)),
            wrong=(
                Wrong(lambda q, b: -boom_column(q, b), "taken the other way"),
                Wrong(
                    lambda q, b: [-b * np.sin(q[0]) * np.cos(q[1]), b * np.cos(q[0]) * np.cos(q[1]), 0, 0, 0, 1],
                    "this is column 1, of the turning column: joint 2 has a horizontal axis",
                    own=True,
                ),
                Wrong(
                    lambda q, b: [*boom_column(q, b)[:3], 0, 0, 1],
                    "the lower half is axis 1, upright: joint 2 turns about its own axis",
                    own=True,
                ),
                Wrong(
                    lambda q, b: boom_column(q, b) * np.array([1, 1, 1, 0, 0, 0]),
                    "joint 2 turns the boom: the lower half is its axis",
                    own=True,
                ),
                Wrong(
                    lambda q, b: [
                        b * np.cos(q[0]) * np.cos(q[1]),
                        b * np.sin(q[0]) * np.cos(q[1]),
                        b * np.sin(q[1]),
                        *boom_column(q, b)[3:],
                    ],
                    "the upper half is the lever itself: the cross product with the axis is missing",
                    own=True,
                ),
                Wrong(lambda q, b: boom_column(q, b)[[3, 4, 5, 0, 1, 2]], "blocks are swapped"),
            ),
        ),
    ),
)
