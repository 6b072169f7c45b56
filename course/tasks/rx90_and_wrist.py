"""Tasks of lesson 7, the Stäubli RX-90 and the spherical wrist (MECA 953 Robotique, MMT5, 2022, document 001)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import (
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
    drawn,
)
from armproof.course.links import classic_link, modified_link, product, shift, turn

ARM, WRIST = "rx90", "spherical_wrist"
HALF = "pi/2"
ROWS = [
    (0, 0, 0, "theta_1"), (HALF, 0, 0, "theta_2"), (0, "a_3", 0, "theta_3"),
    ("-pi/2", 0, "d_3", "theta_4"), (HALF, 0, 0, "theta_5"), ("-pi/2", 0, 0, "theta_6"),
]  # fmt: skip


def _chain(q, a_3, d_3):
    """Return the six rows (a, α, d, θ) of the RX-90."""
    t, h = q, np.pi / 2
    return [(0, 0, 0, t[0]), (0, h, 0, t[1]), (a_3, 0, 0, t[2]), (0, -h, d_3, t[3]), (0, h, 0, t[4]), (0, -h, 0, t[5])]


def _without(q, *gone):
    """Return the joint values with some of them at zero."""
    return [0 if k + 1 in gone else value for k, value in enumerate(q)]


# -- the link matrix and the products ----------------------------------------------------------------------------------


def last_link(q):
    """Return 5T6 from row 6, α = −π/2: y and z of the turn go to −z and y."""
    c, s = np.cos(q[5]), np.sin(q[5])
    return np.array([[c, -s, 0, 0], [0, 0, 1, 0], [-s, -c, 0, 0], [0, 0, 0, 1]])


T_56 = r"\begin{bmatrix} C_6 & -S_6 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ -S_6 & -C_6 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
T_56_PRINTED = (
    r"\begin{bmatrix} C_6 & -S_6 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ S_6 & C_6 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
)


def fourth_product(q):
    """Return U_4 = 4T5 5T6."""
    c5, s5, c6, s6 = np.cos(q[4]), np.sin(q[4]), np.cos(q[5]), np.sin(q[5])
    return np.array([[c5 * c6, -c5 * s6, -s5, 0], [s6, c6, 0, 0], [s5 * c6, -s5 * s6, c5, 0], [0, 0, 0, 1]])


U_4 = r"""\begin{bmatrix} C_5 C_6 & -C_5 S_6 & -S_5 & 0 \\ S_6 & C_6 & 0 & 0 \\ S_5 C_6 & -S_5 S_6 & C_5 & 0 \\
0 & 0 & 0 & 1 \end{bmatrix}"""


def third_product(q, d_3):
    """Return U_3 = 3T4 U_4: row 1 is C_4 row 1 − S_4 row 2 of U_4, row 2 is row 3, row 3 is −S_4 row 1 − C_4 row 2."""
    c, s = np.cos(q[3]), np.sin(q[3])
    return np.array([[c, -s, 0, 0], [0, 0, 1, d_3], [-s, -c, 0, 0], [0, 0, 0, 1]]) @ fourth_product(q)


U_3 = r"""\begin{bmatrix} C_4 C_5 C_6 - S_4 S_6 & -C_4 C_5 S_6 - S_4 C_6 & -C_4 S_5 & 0 \\ S_5 C_6 & -S_5 S_6 & C_5 & d_3 \\
-S_4 C_5 C_6 - C_4 S_6 & S_4 C_5 S_6 - C_4 C_6 & S_4 S_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
U_3_PRINTED = r"""\begin{bmatrix} C_4 C_5 S_4 C_6 & -C_4 C_5 S_6 & -C_4 S_5 & 0 \\ S_5 C_6 & -S_5 S_6 & C_5 & d_3 \\
-S_4 S_5 S_6 - C_4 S_6 & S_4 C_5 S_6 & S_4 S_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _links_sympy(sp, first):
    """Return the product of the RX-90's link matrices from a row on."""
    X, h = sp.eye(4), sp.pi / 2
    twists, lengths, offsets = (
        (0, h, 0, -h, h, -h),
        (0, 0, sp.Symbol("a_3"), 0, 0, 0),
        (0, 0, 0, sp.Symbol("d_3"), 0, 0),
    )
    for alpha, a, d, t in list(zip(twists, lengths, offsets, sp.symbols("theta_1:7"), strict=True))[first - 1 :]:
        X *= turn(sp, "x", alpha) * shift(sp, x=a) * turn(sp, "z", t) * shift(sp, z=d)
    return X


# -- the position and the approach axis --------------------------------------------------------------------------------


def wrist_centre(q, a_3, d_3):
    """Return P: the radius a_3 C_2 − d_3 S_23 in the direction of θ_1, and the height."""
    t1, t2, t23 = q[0], q[1], q[1] + q[2]
    radius = a_3 * np.cos(t2) - d_3 * np.sin(t23)
    return np.array([radius * np.cos(t1), radius * np.sin(t1), a_3 * np.sin(t2) + d_3 * np.cos(t23)])


CENTRE = (
    r"\begin{bmatrix} C_1 (a_3 C_2 - d_3 S_{23}) \\ S_1 (a_3 C_2 - d_3 S_{23}) \\ a_3 S_2 + d_3 C_{23} \end{bmatrix}"
)


def approach(q):
    """Return a, the third column of the rotation."""
    c1, s1, c4, s4, c5, s5 = (f(q[k]) for k in (0, 3, 4) for f in (np.cos, np.sin))
    c23, s23 = np.cos(q[1] + q[2]), np.sin(q[1] + q[2])
    inner = c23 * c4 * s5 + s23 * c5
    return [-c1 * inner + s1 * s4 * s5, -s1 * inner - c1 * s4 * s5, -s23 * c4 * s5 + c23 * c5]


APPROACH = r"""\begin{bmatrix} -C_1 (C_{23} C_4 S_5 + S_{23} C_5) + S_1 S_4 S_5 \\
-S_1 (C_{23} C_4 S_5 + S_{23} C_5) - C_1 S_4 S_5 \\ -S_{23} C_4 S_5 + C_{23} C_5 \end{bmatrix}"""


# -- the spherical wrist -----------------------------------------------------------------------------------------------


def wrist(q, d_6):
    """Return 3T6, the product of the three classic link matrices."""
    (c4, c5, c6), (s4, s5, s6) = np.cos(q), np.sin(q)
    first = np.array([[c4, 0, -s4, 0], [s4, 0, c4, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
    second = np.array([[c5, 0, s5, 0], [s5, 0, -c5, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    third = np.array([[c6, -s6, 0, 0], [s6, c6, 0, 0], [0, 0, 1, d_6], [0, 0, 0, 1]])
    return first @ second @ third


T_36 = r"""\begin{bmatrix} c_4 c_5 c_6 - s_4 s_6 & -c_4 c_5 s_6 - s_4 c_6 & c_4 s_5 & c_4 s_5 d_6 \\
s_4 c_5 c_6 + c_4 s_6 & -s_4 c_5 s_6 + c_4 c_6 & s_4 s_5 & s_4 s_5 d_6 \\ -s_5 c_6 & s_5 s_6 & c_5 & c_5 d_6 \\
0 & 0 & 0 & 1 \end{bmatrix}"""


def _wrist_sympy(sp):
    t4, t5, t6, d6 = sp.symbols("theta_4 theta_5 theta_6 d_6")
    return turn(sp, "z", t4) * turn(sp, "y", t5) * turn(sp, "z", t6) * shift(sp, z=d6)


def _mirrored(q, d_6):
    """Return the product with the second matrix as the slide prints it."""
    (c4, c5, c6), (s4, s5, s6) = np.cos(q), np.sin(q)
    first = np.array([[c4, 0, -s4, 0], [s4, 0, c4, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
    second = np.array([[c5, 0, s5, 0], [s5, 0, -c5, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
    third = np.array([[c6, -s6, 0, 0], [s6, c6, 0, 0], [0, 0, 1, d_6], [0, 0, 0, 1]])
    return first @ second @ third


def _read_as_modified(q, d_6):
    h = np.pi / 2
    return product([(0, -h, 0, q[0]), (0, h, 0, q[1]), (0, 0, d_6, q[2])])


def aligned(theta_4, theta_6):
    """Return the rotation at θ_5 = 0: two turns about one axis add up."""
    c, s = np.cos(theta_4 + theta_6), np.sin(theta_4 + theta_6)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


ALIGNED = (
    r"\begin{bmatrix} C_4 C_6 - S_4 S_6 & -S_{46} & 0 \\ S_4 C_6 + C_4 S_6 & C_{46} & 0 \\ 0 & 0 & 1 \end{bmatrix}"
)


def _aligned_sympy(sp):
    t4, t6 = sp.symbols("theta_4 theta_6")
    return (turn(sp, "z", t4) * turn(sp, "z", t6))[:3, :3]


def _predict(a_3=0.45, d_3=0.42):
    """Return the task `predict` for an arm of these lengths (m)."""
    return Task(
        name="predict",
        title="Prediction: the arm upright",
        text=f"Upper arm $a_3 = {a_3:g}$ m, forearm $d_3 = {d_3:g}$ m. In the figure, at zero, the upper arm is horizontal and the forearm upright."
        " Where is the origin of frame 6 at $\\theta_2 = 90°$, $\\theta_3 = -90°$, all others 0? Give `[x, y, z]` in metres, in frame 0.",
        asks=Number(
            (0, 0, a_3 + d_3),
            unit="m",
            labels=("x", "y", "z"),
            steps=(
                r"\theta_2 = 90^\circ",
                r"\theta_3 = -90^\circ",
                r"x = a_3 \cos\theta_2 - d_3 \sin(\theta_2 + \theta_3)",
                "y = 0",
                r"z = a_3 \sin\theta_2 + d_3 \cos(\theta_2 + \theta_3)",
            ),
            beside=(r"\sqrt{(a_3^2 + d_3^2)}", "a_3 d_3", "(a_3 + d_3) y_0 = [0, a_3 + d_3, 0]"),
        ),
        hints=(
            "Start from the figure and turn the shoulder by 90°: where is the elbow now?",
            "The forearm was upright; the shoulder turned it by 90°, the elbow turns it back.",
            "Upper arm and forearm both point up, from the shoulder, where frame 0 is: add the lengths.",
        ),
        right=([0, 0, a_3 + d_3], f"0, 0, {a_3 + d_3:.4g}", (0, 0, a_3 + d_3)),
        wrong=(
            Wrong([-d_3, 0, a_3], "the elbow turns the forearm back by 90°: θ_3 counts from the upper arm", own=True),
            Wrong([a_3, 0, d_3], "this is the zero pose of the figure", own=True),
            Wrong([0, 0, a_3 - d_3], "upper arm and forearm point the same way here: the lengths add", own=True),
            Wrong([d_3, 0, a_3], "at zero the forearm is upright: it does not start along the upper arm", own=True),
            Wrong([a_3 + d_3, 0, 0], "at θ_2 = 90° the upper arm points up, along z_0", own=True),
        ),
        own=drawn(_predict, a_3=(0.43, 0.55), d_3=(0.3, 0.42)),
    )


# -- an arm that nobody has seen ---------------------------------------------------------------------------------------

HEAD = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "h", "theta": "theta_1"},
        {"alpha": "-pi/2", "a": "e", "d": 0, "theta": "theta_2"},
    ],
}


def head(q, h, e):
    """Return 0T2 of the camera's head: the pan, then the tilt about an axis e beside it."""
    (c1, c2), (s1, s2) = np.cos(q), np.sin(q)
    return np.array([[c1 * c2, -c1 * s2, -s1, e * c1], [s1 * c2, -s1 * s2, c1, e * s1], [-s2, -c2, 0, h], [0, 0, 0, 1]])


HEAD_POSE = r"""\begin{bmatrix} C_1 C_2 & -C_1 S_2 & -S_1 & e\,C_1 \\ S_1 C_2 & -S_1 S_2 & C_1 & e\,S_1 \\
-S_2 & -C_2 & 0 & h \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _head_of_links(q, h, e):
    return modified_link(0, 0, h, q[0]) @ modified_link(e, -np.pi / 2, 0, q[1])


LESSON = Lesson(
    number=7,
    name="rx90_and_wrist",
    title="Stäubli RX-90 and the spherical wrist",
    source="MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Write the table and the link matrices of a six-joint arm in the modified convention.",
        "Follow the products from the tool to the base, and find the slips of the printed ones.",
        "Say what makes a wrist spherical, and where it loses an orientation.",
    ),
    tasks=(
        _predict(),
        Task(
            name="table",
            title="The table of parameters",
            text="Fill in the modified table of the RX-90: six rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$ with `a_3`, `d_3`, `theta_1` …"
            ' `theta_6`; twists as in `"pi/2"`.',
            asks=Table(ARM, "modified"),
            hints=(
                "Only two lengths are not zero: one along an $x$ axis, one along a $z$ axis.",
                "The twist of row $i$ turns $z_{i-1}$ into $z_i$ about $x_{i-1}$. Two neighbouring axes are parallel, the others at right angles.",
                "Twists: $0, \\pi/2, 0, -\\pi/2, \\pi/2, -\\pi/2$. $a_3$ stands in row 3, $d_3$ in row 4.",
            ),
            right=(
                ROWS,
                [dict(zip(("alpha", "a", "d", "theta"), row, strict=True)) for row in ROWS],
                r"""\begin{array}{cccc} 0 & 0 & 0 & \theta_1 \\ \frac{\pi}{2} & 0 & 0 & \theta_2 \\ 0 & a_3 & 0 & \theta_3 \\
                -\frac{\pi}{2} & 0 & d_3 & \theta_4 \\ \frac{\pi}{2} & 0 & 0 & \theta_5 \\ -\frac{\pi}{2} & 0 & 0 & \theta_6 \end{array}""",
            ),
            wrong=(
                Wrong(
                    [*ROWS[:5], (HALF, 0, 0, "theta_6")],
                    "row 6: the twist from z_5 to z_6 has the wrong sign, the slip of the slide's last matrix",
                    own=True,
                ),
                Wrong(
                    [*ROWS[:2], (0, "a_3", "d_3", "theta_3"), ("-pi/2", 0, 0, "theta_4"), *ROWS[4:]],
                    "d_3 has the index 3 but belongs to row 4: it lies along z_4, the axis of the forearm",
                    own=True,
                ),
                Wrong(
                    [
                        (HALF, 0, 0, "theta_1"),
                        (0, "a_3", 0, "theta_2"),
                        ("-pi/2", 0, 0, "theta_3"),
                        (HALF, 0, "d_3", "theta_4"),
                        ("-pi/2", 0, 0, "theta_5"),
                        (0, 0, 0, "theta_6"),
                    ],
                    "lengths and twists stand one row too early: this is the classic order; here row i holds those of link i-1",
                    own=True,
                ),
                Wrong([ROWS[0], ("-pi/2", 0, 0, "theta_2"), *ROWS[2:]], "row 2: alpha is wrong"),
                Wrong([*ROWS[:2], (0, 0, "a_3", "theta_3"), *ROWS[3:]], "row 3: a and d are exchanged"),
                Wrong(ROWS[:5], "6 rows"),
            ),
        ),
        Task(
            name="last_link",
            title="The last link matrix",
            text="Write ${}^5T_6$, 4×4. The slide has the twist's sign of row 6 wrong here.",
            asks=Quantity(ARM, {"pose": 6, "in": 5}),
            hints=(
                "Put row 6 of the table into the general matrix: $\\alpha_5 = -\\pi/2$, $a_5 = d_6 = 0$.",
                "$C\\alpha = 0$ and $S\\alpha = -1$.",
                "Row 2 is $[0, 0, 1, 0]$, row 3 $[-S_6, -C_6, 0, 0]$.",
            ),
            right=(last_link, T_56, WithSympy(lambda sp: _links_sympy(sp, 6))),
            wrong=(
                Wrong(
                    T_56_PRINTED,
                    "this is what the slide prints, with the twist +π/2; row 6 of the table has −π/2",
                    own=True,
                ),
                Wrong(lambda q: last_link(q).T, "transposed"),
                Wrong(
                    lambda q: classic_link(0, -np.pi / 2, 0, q[5]),
                    "this is the classic link matrix with the same numbers; the arm's frames are modified ones",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_6 & -S_6 & 0 & 0 \\ S_6 & C_6 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "the twist is missing: this only turns about z",
                    own=True,
                ),
                Wrong(lambda q: last_link([0, 0, 0, 0, 0, q[4]]), "theta_6"),
            ),
        ),
        Task(
            name="fourth_product",
            title="The product U₄",
            text="Write $U_4 = {}^4T_5\\,{}^5T_6$, 4×4.",
            asks=Quantity(ARM, {"pose": 6, "in": 4}),
            hints=(
                "Write ${}^4T_5$ from row 5, $\\alpha_4 = +\\pi/2$, and multiply.",
                "Row 3 of ${}^4T_5$ is $[S_5, C_5, 0, 0]$; the second row of ${}^5T_6$ is $[0, 0, 1, 0]$.",
                "Row 3 of $U_4$ is $[S_5 C_6, -S_5 S_6, C_5, 0]$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Row 5 of the table, $\\alpha_4 = \\pi/2$.",
                        r"{}^4T_5 = \begin{bmatrix} C_5 & -S_5 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ S_5 & C_5 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 6, $\\alpha_5 = -\\pi/2$.",
                        r"{}^5T_6 = \begin{bmatrix} C_6 & -S_6 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ -S_6 & -C_6 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The second row of the first matrix takes the third row of the second, with a minus.",
                        r"\begin{bmatrix} 0 & 0 & -1 & 0 \end{bmatrix} {}^5T_6 = \begin{bmatrix} S_6 & C_6 & 0 & 0 \end{bmatrix}",
                    ),
                    Line(
                        "Rows 1 and 3 mix the first two rows of the second matrix.",
                        r"{}^4T_5 {}^5T_6 = \begin{bmatrix} C_5 C_6 & -C_5 S_6 & -S_5 & 0 \\ S_6 & C_6 & 0 & 0 \\ S_5 C_6 & -S_5 S_6 & C_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "rx90"},
            ),
            right=(fourth_product, U_4, WithSympy(lambda sp: _links_sympy(sp, 5))),
            wrong=(
                Wrong(U_4.replace("S_5 C_6 &", "S_5 S_6 &"), "entry (3, 1)"),
                Wrong(
                    lambda q: product([(0, np.pi / 2, 0, q[4]), (0, np.pi / 2, 0, q[5])]),
                    "the slide's ⁵T₆ is in it: its twist has the wrong sign",
                    own=True,
                ),
                Wrong(
                    lambda q: last_link(q) @ modified_link(0, np.pi / 2, 0, q[4]),
                    "the factors stand in the reverse order: ⁴T₅ is on the left",
                    own=True,
                ),
                Wrong(lambda q: fourth_product(q).T, "transposed"),
                Wrong(lambda q: fourth_product([0, 0, 0, 0, -q[4], q[5]]), "sign"),
            ),
        ),
        Task(
            name="third_product",
            title="The product U₃",
            text="Write $U_3 = {}^3T_4\\,U_4$, 4×4. On the slide four of its entries are wrong.",
            asks=Quantity(ARM, {"pose": 6, "in": 3}),
            hints=(
                "${}^3T_4$ has the rows $[C_4, -S_4, 0, 0]$, $[0, 0, 1, d_3]$, $[-S_4, -C_4, 0, 0]$.",
                "Each entry of the first row is $C_4$ times row 1 of $U_4$ minus $S_4$ times its row 2.",
                "Entry (1, 1) is $C_4 C_5 C_6 - S_4 S_6$, entry (3, 1) $-S_4 C_5 C_6 - C_4 S_6$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Row 4 of the table.",
                        r"{}^3T_4 = \begin{bmatrix} C_4 & -S_4 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ -S_4 & -C_4 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "$U_4$, from the task before.",
                        r"{}^4T_6 = \begin{bmatrix} C_5 C_6 & -C_5 S_6 & -S_5 & 0 \\ S_6 & C_6 & 0 & 0 \\ S_5 C_6 & -S_5 S_6 & C_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The second row of the first matrix takes the third row of the second, and $d_3$.",
                        r"\begin{bmatrix} 0 & 0 & 1 & d_3 \end{bmatrix} {}^4T_6 = \begin{bmatrix} S_5 C_6 & -S_5 S_6 & C_5 & d_3 \end{bmatrix}",
                    ),
                    Line(
                        "The other two mix its first two rows.",
                        r"{}^3T_4 {}^4T_6 = \begin{bmatrix} C_4 C_5 C_6 - S_4 S_6 & -C_4 C_5 S_6 - S_4 C_6 & -C_4 S_5 & 0 \\ S_5 C_6 & -S_5 S_6 & C_5 & d_3 \\ -S_4 C_5 C_6 - C_4 S_6 & S_4 C_5 S_6 - C_4 C_6 & S_4 S_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "rx90"},
            ),
            right=(third_product, U_3, WithSympy(lambda sp: _links_sympy(sp, 4))),
            wrong=(
                Wrong(
                    U_3_PRINTED,
                    "this is what the slide prints: the first two columns have lost terms, and are no unit vectors any more",
                    own=True,
                ),
                Wrong(U_3.replace("& d_3", "& -d_3"), "wrong sign"),
                Wrong(U_3.replace(r"C_5 & d_3 \\", r"C_5 & 0 \\"), "entry (2, 4)"),
                Wrong(lambda q, d_3: third_product(_without(q, 4), d_3), "theta_4"),
                Wrong(U_3.replace("-C_4 C_5 S_6 - S_4 C_6", "-C_4 C_5 S_6"), "the term -C_6 S_4 is missing"),
            ),
        ),
        Task(
            name="wrist_centre",
            title="The position",
            text="Write $[P_x, P_y, P_z]$, the origin of frame 6 in frame 0, in metres. A function may be `def centre(q, a_3, d_3)` with the six"
            " joint angles in `q`.",
            asks=Quantity(ARM, {"origin": 6}),
            hints=(
                "Origins 4, 5 and 6 are one point. On which joints does it depend?",
                "In the vertical plane of the arm: how far from axis 1, and how high, are the elbow and the wrist?",
                "The radius is $a_3 C_2 - d_3 S_{23}$, the height $a_3 S_2 + d_3 C_{23}$; then turn by $\\theta_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The elbow, in the plane of the arm.",
                        r"{}^1T_3 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} a_3 C_2 \\ 0 \\ a_3 S_2 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "And the forearm, at a right angle to the upper arm where $\\theta_3 = 0$.",
                        r"{}^1T_6 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} a_3 C_2 - d_3 S_{23} \\ 0 \\ a_3 S_2 + d_3 C_{23} \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Joint 1 turns the plane.",
                        r"p_6 = \begin{bmatrix} C_1 (a_3 C_2 - d_3 S_{23}) \\ S_1 (a_3 C_2 - d_3 S_{23}) \\ a_3 S_2 + d_3 C_{23} \end{bmatrix}",
                    ),
                ),
                {"arm": "rx90"},
            ),
            right=(wrist_centre, CENTRE, WithSympy(lambda sp: _links_sympy(sp, 1)[:3, 3])),
            wrong=(
                Wrong(
                    lambda q, a_3, d_3: wrist_centre([q[0], q[1], q[2] - q[1], *q[3:]], a_3, d_3),
                    "θ_3 is taken from the base; the forearm turns with the upper arm: S_23 and C_23",
                    own=True,
                ),
                Wrong(CENTRE.replace("- d_3 S_{23}", "+ d_3 S_{23}"), "wrong sign"),
                Wrong(
                    lambda q, a_3, d_3: wrist_centre([q[0], q[1], q[2] - np.pi / 2, *q[3:]], a_3, d_3),
                    "the forearm is taken in line with the upper arm at θ_3 = 0; there it stands at a right angle",
                    own=True,
                ),
                Wrong(lambda q, a_3, d_3: wrist_centre(q, d_3, a_3), "swapped"),
                Wrong(lambda q, a_3, d_3: wrist_centre(np.deg2rad(q), a_3, d_3), "degrees"),
            ),
        ),
        Task(
            name="approach",
            title="The approach axis",
            text="Write $\\vec a = [a_x, a_y, a_z]$, the $z$ axis of frame 6 in frame 0.",
            asks=Quantity(ARM, {"axis": 6}),
            hints=(
                "It is the third column of $U_0$: only the third columns of the partial products are needed.",
                "In frame 3 it is $[-C_4 S_5, C_5, S_4 S_5]^T$. Turn by $\\theta_2 + \\theta_3$, then by $\\theta_1$.",
                "In frame 1 it is $[-C_{23} C_4 S_5 - S_{23} C_5,\\ -S_4 S_5,\\ -S_{23} C_4 S_5 + C_{23} C_5]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The third column of $U_4$: the axis in frame 4.",
                        r"{}^4T_6 \begin{bmatrix} 0 \\ 0 \\ 1 \\ 0 \end{bmatrix} = \begin{bmatrix} -S_5 \\ 0 \\ C_5 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "${}^3T_4$ turns it by $\\theta_4$: the axis in frame 3.",
                        r"{}^3T_6 \begin{bmatrix} 0 \\ 0 \\ 1 \\ 0 \end{bmatrix} = \begin{bmatrix} -C_4 S_5 \\ C_5 \\ S_4 S_5 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Axes 2 and 3 are parallel: their angles add up.",
                        r"{}^1R_3 = \begin{bmatrix} C_{23} & -S_{23} & 0 \\ 0 & 0 & -1 \\ S_{23} & C_{23} & 0 \end{bmatrix}",
                    ),
                    Line(
                        "The axis in frame 1.",
                        r"{}^1T_6 \begin{bmatrix} 0 \\ 0 \\ 1 \\ 0 \end{bmatrix} = \begin{bmatrix} -C_{23} C_4 S_5 - S_{23} C_5 \\ -S_4 S_5 \\ -S_{23} C_4 S_5 + C_{23} C_5 \\ 0 \end{bmatrix}",
                    ),
                    Line(
                        "Joint 1 turns the first two rows.",
                        r"z_6 = \begin{bmatrix} -C_1 (C_{23} C_4 S_5 + S_{23} C_5) + S_1 S_4 S_5 \\ -S_1 (C_{23} C_4 S_5 + S_{23} C_5) - C_1 S_4 S_5 \\ -S_{23} C_4 S_5 + C_{23} C_5 \end{bmatrix}",
                    ),
                ),
                {"arm": "rx90"},
            ),
            right=(approach, APPROACH, WithSympy(lambda sp: _links_sympy(sp, 1)[:3, 2])),
            wrong=(
                Wrong(
                    lambda q: product(_chain(q, 1, 1))[:3, 0],
                    "this is s, the x axis of frame 6: the approach axis is the third column",
                    own=True,
                ),
                Wrong(
                    lambda q: product(_chain(q, 1, 1)[:5])[:3, 2],
                    "this is the axis of joint 5, z of frame 5",
                    own=True,
                ),
                Wrong(
                    lambda q: product([*_chain(q, 1, 1)[:5], (0, np.pi / 2, 0, q[5])])[:3, 2],
                    "the slide's ⁵T₆ is in it: the axis points the other way",
                    own=True,
                ),
                Wrong(APPROACH.replace(r"- C_1 S_4 S_5", r"+ C_1 S_4 S_5"), "wrong sign"),
                Wrong(
                    lambda q: approach([0, *q[1:]]), "the turn by θ_1 is missing: this is the axis in frame 1", own=True
                ),
            ),
        ),
        Task(
            name="mirror",
            title="A check in your head",
            text="The slide on the spherical wrist prints the rotation block of ${}^4T_5$ with the third row $[0, -1, 0]$. What is the determinant of"
            " that block?",
            asks=Number(-1, steps=("M = -1", r"-1 \cdot (-1) \cdot M")),
            hints=(
                "Expand along the third row: it has one entry that is not zero.",
                "The entry stands at (3, 2), so its cofactor has the sign $(-1)^{3+2} = -1$.",
                "$-1 \\cdot (-1) \\cdot (c_5 \\cdot (-c_5) - s_5 \\cdot s_5)$.",
            ),
            right=(-1, "-1", -1.0),
            wrong=(
                Wrong(1, "with the right entry, +1, it would be: mind the sign of the cofactor at (3, 2)", own=True),
                Wrong(
                    0, "the block is regular: the first and the third column are unit vectors at right angles", own=True
                ),
                Wrong(2, "the determinant of unit vectors at right angles is 1 or −1, nothing else", own=True),
                Wrong([-1, 1], "one number, not 2"),
                Wrong(
                    3,
                    "three is how many entries are not zero: the determinant of unit vectors at right angles is 1 or −1",
                    own=True,
                ),
                Wrong(
                    -3, "a determinant is no count of entries: of unit vectors at right angles it is 1 or −1", own=True
                ),
                Wrong(-2, "the determinant of unit vectors at right angles is 1 or −1, nothing else", own=True),
            ),
        ),
        Task(
            name="wrist",
            title="The spherical wrist",
            text="Write ${}^3T_6$ of the spherical wrist, 4×4: the product of the three matrices, with the right entry in the second. A function may be"
            " `def wrist(q, d_6)` with `q` = $[\\theta_4, \\theta_5, \\theta_6]$.",
            asks=Quantity(WRIST, {"pose": 6, "in": 3}),
            hints=(
                "Correct the sign in the second matrix first; then multiply from the right.",
                "The third column is ${}^3T_5$'s, $[c_4 s_5, s_4 s_5, c_5]^T$; the tool is $d_6$ along it.",
                "Rotation: $\\mathbf{Rot}_z(\\theta_4)\\,\\mathbf{Rot}_y(\\theta_5)\\,\\mathbf{Rot}_z(\\theta_6)$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The second matrix with the right entry: row 3 is $[0, 1, 0, 0]$.",
                        r"{}^4T_5 = \begin{bmatrix} c_5 & 0 & s_5 & 0 \\ s_5 & 0 & -c_5 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The third matrix: a turn about $z$, and the tool $d_6$ along it.",
                        r"{}^5T_6 = \begin{bmatrix} c_6 & -s_6 & 0 & 0 \\ s_6 & c_6 & 0 & 0 \\ 0 & 0 & 1 & d_6 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply these two first.",
                        r"{}^4T_5 {}^5T_6 = \begin{bmatrix} c_5 c_6 & -c_5 s_6 & s_5 & s_5 d_6 \\ s_5 c_6 & -s_5 s_6 & -c_5 & -c_5 d_6 \\ s_6 & c_6 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The first matrix mixes rows 1 and 3; its own row 3 takes row 2 with a minus.",
                        r"{}^3T_4 = \begin{bmatrix} c_4 & 0 & -s_4 & 0 \\ s_4 & 0 & c_4 & 0 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply.",
                        r"{}^3T_4 {}^4T_6 = \begin{bmatrix} c_4 c_5 c_6 - s_4 s_6 & -c_4 c_5 s_6 - s_4 c_6 & c_4 s_5 & c_4 s_5 d_6 \\ s_4 c_5 c_6 + c_4 s_6 & -s_4 c_5 s_6 + c_4 c_6 & s_4 s_5 & s_4 s_5 d_6 \\ -s_5 c_6 & s_5 s_6 & c_5 & c_5 d_6 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "spherical_wrist"},
            ),
            right=(wrist, T_36, WithSympy(_wrist_sympy)),
            wrong=(
                Wrong(_mirrored, "the slide's ⁴T₅ is in it, a reflection: entry (3, 2) of that matrix is +1", own=True),
                Wrong(
                    _read_as_modified,
                    "the numbers of the table are read as modified parameters, as the slide heads it; the matrices are classic ones",
                    own=True,
                ),
                Wrong(lambda q, d_6: wrist(q, 0), "the origin is missing"),
                Wrong(lambda q, d_6: wrist([q[0], -q[1], q[2]], d_6), "sign"),
                Wrong(lambda q, d_6: wrist([q[2], q[1], q[0]], d_6), "swapped"),
            ),
        ),
        Task(
            name="aligned",
            title="Limits: the wrist in line",
            text="Write the rotation ${}^3R_6$ of the spherical wrist at $\\theta_5 = 0$, 3×3, in `theta_4` and `theta_6`.",
            asks=Formula(ALIGNED, ("theta_4", "theta_6")),
            hints=(
                "Put $s_5 = 0$ and $c_5 = 1$ into your matrix.",
                "Entry (1, 1) becomes $c_4 c_6 - s_4 s_6$. You know that sum.",
                "It is a rotation about $z$ by $\\theta_4 + \\theta_6$.",
            ),
            right=(aligned, ALIGNED, WithSympy(_aligned_sympy)),
            wrong=(
                Wrong(
                    lambda theta_4, theta_6: aligned(theta_4, -theta_6),
                    "axes 4 and 6 point the same way here: the angles add, they do not subtract",
                    own=True,
                ),
                Wrong(lambda theta_4, theta_6: aligned(theta_4, 0), "θ_6 still turns the tool", own=True),
                Wrong(
                    lambda theta_4, theta_6: wrist([theta_4, np.pi, theta_6], 0)[:3, :3],
                    "this is the wrist at θ_5 = π",
                    own=True,
                ),
                Wrong(lambda theta_4, theta_6: aligned(theta_4, theta_6).T, "transposed"),
                Wrong(
                    lambda theta_4, theta_6: wrist([theta_4, np.pi / 2, theta_6], 0)[:3, :3],
                    "this is the wrist at θ_5 = 90°: at 0, s_5 vanishes and c_5 is 1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="The head of a camera pans by $\\theta_1$ at the height $h$ and tilts by $\\theta_2$ about an axis at the distance $e$: its modified table has the"
            " rows $(0, 0, h, \\theta_1)$ and $(-\\frac{\\pi}{2}, e, 0, \\theta_2)$. Write ${}^0T_2$, 4×4. A function takes `q` = $[\\theta_1, \\theta_2]$ and `h`,"
            " `e`.",
            asks=Quantity(HEAD, {"pose": 2}),
            hints=(
                "Two link matrices, and their product: start with the second, ${}^1T_2$.",
                "With $\\alpha_1 = -\\frac{\\pi}{2}$, ${}^1T_2$ has the rows $[C_2, -S_2, 0, e]$, $[0, 0, 1, 0]$, $[-S_2, -C_2, 0, 0]$.",
                "${}^0T_1$ turns the first two rows by $\\theta_1$ and adds $h$ to the height.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Row 2 of the table: the twist $-\\pi/2$, and $e$ along $x_1$.",
                        r"{}^1T_2 = \begin{bmatrix} C_2 & -S_2 & 0 & e \\ 0 & 0 & 1 & 0 \\ -S_2 & -C_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 1 turns about the vertical, at the height $h$.",
                        r"{}^0T_1 = \begin{bmatrix} C_1 & -S_1 & 0 & 0 \\ S_1 & C_1 & 0 & 0 \\ 0 & 0 & 1 & h \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply: rows 1 and 2 mix, row 3 is lifted.",
                        r"{}^0T_1 {}^1T_2 = \begin{bmatrix} C_1 C_2 & -C_1 S_2 & -S_1 & e C_1 \\ S_1 C_2 & -S_1 S_2 & C_1 & e S_1 \\ -S_2 & -C_2 & 0 & h \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": HEAD},
            ),
            right=(head, HEAD_POSE, _head_of_links),
            wrong=(
                Wrong(
                    lambda q, h, e: modified_link(0, 0, h, q[0]) @ modified_link(e, np.pi / 2, 0, q[1]),
                    "the twist has the wrong sign: with −π/2, z_2 is y_1",
                    own=True,
                ),
                Wrong(
                    lambda q, h, e: classic_link(0, 0, h, q[0]) @ classic_link(e, -np.pi / 2, 0, q[1]),
                    "the rows of a modified table stand in the classic matrix",
                    own=True,
                ),
                Wrong(
                    lambda q, h, e: modified_link(e, -np.pi / 2, 0, q[1]) @ modified_link(0, 0, h, q[0]),
                    "the factors are exchanged: the pan comes first, it carries the tilt",
                    own=True,
                ),
                Wrong(lambda q, h, e: head(q, e, h), "swapped"),
                Wrong(lambda q, h, e: head(np.deg2rad(q), h, e), "degrees"),
                Wrong(HEAD_POSE.replace(r"& -S_1 &", "& S_1 &"), "entry (1, 3): wrong sign"),
            ),
        ),
    ),
)
