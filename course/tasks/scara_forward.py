"""Tasks of lesson 6, forward kinematics of the SCARA by modified DH (MECA 953 Robotique, MMT5, 2022, document 001)."""

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
    drawn,
)
from armproof.course.links import classic_link, product, shift, turn

ARM = "scara_modified"
ROWS = [(0, 0, 0, "theta_1"), (0, "a_2", 0, "theta_2"), (0, "a_3", "-d_2", 0), (0, 0, 0, "theta_4")]

# -- the function of the program ---------------------------------------------------------------------------------------


def link(a, alpha, d, theta):
    """Return the modified link matrix; a and α are those of the link before."""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([
        [ct, -st, 0, a],
        [st * ca, ct * ca, -sa, -d * sa],
        [st * sa, ct * sa, ca, d * ca],
        [0, 0, 0, 1],
    ])  # fmt: skip


LINK = r"""\begin{bmatrix} C\theta & -S\theta & 0 & a \\ S\theta C\alpha & C\theta C\alpha & -S\alpha & -d\,S\alpha \\
S\theta S\alpha & C\theta S\alpha & C\alpha & d\,C\alpha \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _link_sympy(sp):
    a, alpha, d, theta = sp.symbols("a alpha d theta")
    return turn(sp, "x", alpha) * shift(sp, x=a) * turn(sp, "z", theta) * shift(sp, z=d)


# -- the products ------------------------------------------------------------------------------------------------------


def _rows(q, a_2, a_3):
    t1, t2, d_2, t4 = q
    return [(0, 0, 0, t1), (a_2, 0, 0, t2), (a_3, 0, -d_2, 0), (0, 0, 0, t4)]


def pose_in_2(q, a_3):
    """Return U_2 = 2T3 U_3: the slide moves by a_3 and down, then joint 4 turns."""
    _, _, d_2, t4 = q
    c, s = np.cos(t4), np.sin(t4)
    return np.array([[c, -s, 0, a_3], [s, c, 0, 0], [0, 0, 1, -d_2], [0, 0, 0, 1]])


U_2 = r"\begin{bmatrix} C_4 & -S_4 & 0 & a_3 \\ S_4 & C_4 & 0 & 0 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"


def pose_in_1(q, a_2, a_3):
    """Return U_1 = 1T2 U_2: two turns about parallel axes add up."""
    _, t2, d_2, t4 = q
    c, s = np.cos(t2 + t4), np.sin(t2 + t4)
    return np.array([
        [c, -s, 0, a_2 + a_3 * np.cos(t2)],
        [s, c, 0, a_3 * np.sin(t2)],
        [0, 0, 1, -d_2],
        [0, 0, 0, 1],
    ])  # fmt: skip


U_1 = r"""\begin{bmatrix} C_2 C_4 - S_2 S_4 & -S_{24} & 0 & a_3 C_2 + a_2 \\ S_2 C_4 + C_2 S_4 & C_{24} & 0 & a_3 S_2 \\
0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def forward(q, a_2, a_3):
    """Return U_0, multiplied from the tool to the base."""
    t1, t2, d_2, t4 = q
    U = np.eye(4)
    for row in reversed([(0, 0, 0, t1), (a_2, 0, 0, t2), (a_3, 0, -d_2, 0), (0, 0, 0, t4)]):
        U = link(*row) @ U
    return U


U_0 = r"""\begin{bmatrix} C_{124} & -S_{124} & 0 & a_3 C_{12} + a_2 C_1 \\ S_{124} & C_{124} & 0 & a_3 S_{12} + a_2 S_1 \\
0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _turned(sp, angle, x, y):
    return shift(sp, x, y, -sp.Symbol("d_2")) * turn(sp, "z", angle)


def _forward_sympy(sp):
    t1, t2, t4, a2, a3 = sp.symbols("theta_1 theta_2 theta_4 a_2 a_3")
    x, y = (a2 * f(t1) + a3 * f(t1 + t2) for f in (sp.cos, sp.sin))
    return _turned(sp, t1 + t2 + t4, x, y)


def distance_squared(theta_2, a_2, a_3):
    """Return P_x² + P_y², by the law of cosines with the angle π − θ_2 at the elbow."""
    return a_2**2 + a_3**2 + 2 * a_2 * a_3 * np.cos(theta_2)


def _reach(a_2=0.3, a_3=0.25):
    """Return the task `reach` for an arm of these lengths (m)."""
    return Task(
        name="reach",
        title="Limits: the ring",
        text="Without joint limits, how near to axis 1 and how far from it can the tool be? Give `[nearest, farthest]` in metres, for"
        f" $a_2 = {a_2:g}$ and $a_3 = {a_3:g}$.",
        asks=Number(
            (a_2 - a_3, a_2 + a_3),
            unit="m",
            labels=("the nearest distance", "the farthest distance"),
            steps=("a_2 - a_3", "a_2 + a_3"),
            beside=(r"\sqrt{(a_2^2 + a_3^2)}", r"\sqrt{(a_2^2 - a_3^2)}", "(a_2 + a_3)/2"),
        ),
        hints=(
            "Which values does $\\cos\\theta_2$ take?",
            "Put $\\theta_2 = 0$ and $\\theta_2 = \\pi$ into the squared distance: both become squares.",
            "Folded: the difference of the lengths; stretched: their sum.",
        ),
        right=([a_2 - a_3, a_2 + a_3], f"{a_2 - a_3:.4g}, {a_2 + a_3:.4g}", (abs(a_2 - a_3), a_2 + a_3)),
        wrong=(
            Wrong([0, a_2 + a_3], "the arm cannot fold onto axis 1: the lengths differ", own=True),
            Wrong([a_2 + a_3, a_2 - a_3], "this is [farthest, nearest]", own=True),
            Wrong([a_2, a_2 + a_3], "folded, the second arm brings the tool back towards axis 1", own=True),
            Wrong([(a_2 - a_3) ** 2, (a_2 + a_3) ** 2], "these are the squares of the distances", own=True),
        ),
        own=drawn(_reach, a_2=(0.3, 0.45), a_3=(0.15, 0.28)),
    )


def _predict(a_2=0.3, a_3=0.25):
    """Return the task `predict` for an arm of these lengths (m)."""
    return Task(
        name="predict",
        title="Prediction: seen from above",
        text=f"The arms are $a_2 = {a_2:g}$ m and $a_3 = {a_3:g}$ m long. At $\\theta_1 = 90°$, $\\theta_2 = -90°$ and with the quill lowered by"
        " $d_2 = 0.1$ m: where is the tool, in frame 0? Give `[x, y, z]` in metres; $z_0$ points up.",
        asks=Number(
            (a_3, a_2, -0.1),
            unit="m",
            labels=("x", "y", "z"),
            steps=(
                r"\theta_1 = 90^\circ",
                r"\theta_2 = -90^\circ",
                r"x = a_2 \cos\theta_1 + a_3 \cos(\theta_1 + \theta_2)",
                r"y = a_2 \sin\theta_1 + a_3 \sin(\theta_1 + \theta_2)",
                "z = -d_2",
            ),
            beside=(r"\sqrt{(a_2^2 + a_3^2)}",),
        ),
        hints=(
            "Draw the arm from above: the first arm along which axis?",
            "$\\theta_2$ counts from the first arm. The second arm's direction is $\\theta_1 + \\theta_2$.",
            "The first arm lies along $y_0$, the second along $x_0$; lowering counts negative along $z_0$.",
        ),
        right=([a_3, a_2, -0.1], f"{a_3:g}, {a_2:g}, -0.1", np.array([a_3, a_2, -0.1])),
        wrong=(
            Wrong([a_3, a_2, 0.1], "z_0 points up, and d_2 lowers the quill: the sign of z", own=True),
            Wrong(
                [0, a_2 - a_3, -0.1],
                "θ_2 is taken from the base; it counts from the first arm, so the second arm points along θ_1 + θ_2",
                own=True,
            ),
            Wrong([a_2, a_3, -0.1], "the two arms have changed places: the first one points along y_0 here", own=True),
            Wrong([0, a_2 + a_3, -0.1], "θ_2 is forgotten: this is the arm stretched along y_0", own=True),
            Wrong([a_2 + a_3, 0, -0.1], "both angles are forgotten: this is the arm stretched along x_0", own=True),
            Wrong([-a_3, a_2, -0.1], "θ_2 is negative: seen from above, the elbow bends to the right", own=True),
            Wrong([a_3, a_2], "3 numbers"),
        ),
        own=drawn(_predict, a_2=(0.3, 0.45), a_3=(0.15, 0.28)),
    )


# An arm of no document: a column turns by θ_1, a carriage goes up by d_2, and a ram goes out by d_3 along y of the carriage.
CYLINDRICAL = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"},
        {"alpha": 0, "a": 0, "d": "d_2", "theta": 0},
        {"alpha": "-pi/2", "a": 0, "d": "d_3", "theta": 0},
    ],
}


def cylinder(q):
    """Return the pose of the ram's end: the product of the three link matrices."""
    c, s = np.cos(q[0]), np.sin(q[0])
    return np.array([[c, 0, -s, -q[2] * s], [s, 0, c, q[2] * c], [0, -1, 0, q[1]], [0, 0, 0, 1]])


CYLINDER = r"""\begin{bmatrix} C_1 & 0 & -S_1 & -d_3 S_1 \\ S_1 & 0 & C_1 & d_3 C_1 \\ 0 & -1 & 0 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _cylinder_sympy(sp):
    t, d2, d3 = sp.symbols("theta_1 d_2 d_3")
    return turn(sp, "z", t) * shift(sp, z=d2) * turn(sp, "x", -sp.pi / 2) * shift(sp, z=d3)


LESSON = Lesson(
    number=6,
    name="scara_forward",
    title="SCARA: forward kinematics by the modified convention",
    source="MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Fill in the modified table of the SCARA, signs included.",
        "Multiply the link matrices from the tool to the base, by hand and in Python.",
        "Check the result from above, and say how far the arm reaches.",
    ),
    tasks=(
        _predict(),
        Task(
            name="table",
            title="The table of parameters",
            text="Fill in the modified table: a list of four rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$ with `a_2`, `a_3`, `theta_1`,"
            " `theta_2`, `d_2`, `theta_4`. All $z$ axes point up; $d_2$ counts downwards.",
            asks=Table(ARM, "modified"),
            hints=(
                "All axes are parallel and point the same way. What does that say of the twists?",
                "A row of the modified convention holds the length of the link before: where does $a_2$ stand?",
                "Row 3: the length $a_3$, no angle, and an offset along $z_3$, which points up while $d_2$ goes down.",
            ),
            right=(
                ROWS,
                [
                    {"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"},
                    {"alpha": 0, "a": "a_2", "d": 0, "theta": "theta_2"},
                    {"alpha": 0, "a": "a_3", "d": "-d_2", "theta": 0},
                    {"alpha": 0, "a": 0, "d": 0, "theta": "theta_4"},
                ],
                r"\begin{array}{cccc} 0 & 0 & 0 & \theta_1 \\ 0 & a_2 & 0 & \theta_2 \\ 0 & a_3 & -d_2 & 0 \\ 0 & 0 & 0 & \theta_4 \end{array}",
            ),
            wrong=(
                Wrong(
                    [*ROWS[:2], (0, "a_3", "d_2", 0), ROWS[3]],
                    "the minus sign of the offset is lost, as on the second slide: d_2 counts downwards, z_3 points up",
                    own=True,
                ),
                Wrong(
                    [(0, "a_2", 0, "theta_1"), (0, "a_3", 0, "theta_2"), (0, 0, "-d_2", 0), (0, 0, 0, "theta_4")],
                    "the lengths stand one row too early: this is the classic order; here row i holds the length of link i-1",
                    own=True,
                ),
                Wrong(
                    [*ROWS[:2], ("pi", "a_3", "d_2", 0), ROWS[3]],
                    "z_3 is turned over: in this document all z axes point up, so that every twist is 0",
                    own=True,
                ),
                Wrong(
                    [ROWS[0], (0, "a_3", 0, "theta_2"), (0, "a_2", "-d_2", 0), ROWS[3]],
                    "a_2 and a_3 are exchanged",
                    own=True,
                ),
                Wrong([*ROWS[:2], (0, "a_3", 0, "theta_4")], "4 rows"),
            ),
        ),
        Task(
            name="link",
            title="The function of the program",
            text="Write the general modified link matrix as a function `link(a, alpha, d, theta)`, 4×4; `a` and `alpha` belong to link $i-1$.",
            asks=Formula(LINK, ("a", "alpha", "d", "theta")),
            hints=(
                "Copy the display above entry by entry, row by row.",
                "Each entry is a product of `np.cos` and `np.sin`; the third row has $S\\alpha$ where the second has $C\\alpha$.",
                "Last column: `a`, `-d * np.sin(alpha)`, `d * np.cos(alpha)`, `1`.",
            ),
            right=(link, LINK, WithSympy(_link_sympy)),
            wrong=(
                Wrong(
                    classic_link,
                    "this is the classic link matrix: in the modified one the steps about x come first",
                    own=True,
                ),
                Wrong(lambda a, alpha, d, theta: link(d, alpha, a, theta), "swapped"),
                Wrong(
                    lambda a, alpha, d, theta: link(a, -alpha, d, theta),
                    "the twist has the wrong sign: check the entries with a minus in rows 2 and 3",
                    own=True,
                ),
                Wrong(LINK.replace(r"-d\,S\alpha", r"d\,S\alpha"), "wrong sign"),
                Wrong(
                    lambda a, alpha, d, theta: link(a, theta, d, alpha),
                    "θ and α are exchanged: check the order in which the function takes its arguments",
                    own=True,
                ),
            ),
        ),
        Task(
            name="second_product",
            title="The product U₂",
            text="Write $U_2 = {}^2T_3\\,U_3 = {}^2T_4$, the pose of frame 4 in frame 2, 4×4.",
            asks=Quantity(ARM, {"pose": 4, "in": 2}),
            hints=(
                "Write ${}^2T_3$ and ${}^3T_4$ from rows 3 and 4 of the table.",
                "Joint 3 turns nothing: ${}^2T_3$ is a pure translation.",
                "The rotation is that of $\\theta_4$, the last column $[a_3, 0, -d_2, 1]^T$.",
            ),
            right=(pose_in_2, U_2, WithSympy(lambda sp: _turned(sp, sp.Symbol("theta_4"), sp.Symbol("a_3"), 0))),
            wrong=(
                Wrong(U_2.replace("-d_2", "d_2"), "wrong sign"),
                Wrong(U_2.replace("& a_3 ", "& a_2 "), "entry (1, 4)"),
                Wrong(
                    U_2.replace("a_3", "a_3 C_4").replace(r"& 0 & 0 \\ 0 & 0 & 1", r"& 0 & a_3 S_4 \\ 0 & 0 & 1"),
                    "the turn by θ_4 comes after the move along a_3, so it does not turn it: ²T₃ stands on the left",
                    own=True,
                ),
                Wrong(lambda q, a_3: pose_in_2(q, a_3).T, "transposed"),
                Wrong(lambda q, a_3: pose_in_2([0, 0, q[2], q[1]], a_3), "theta"),
            ),
        ),
        Task(
            name="first_product",
            title="The product U₁",
            text="Write $U_1 = {}^1T_2\\,U_2 = {}^1T_4$, 4×4.",
            asks=Quantity(ARM, {"pose": 4, "in": 1}),
            hints=(
                "Multiply ${}^1T_2$, from row 2 of the table, by your $U_2$.",
                "Turns about parallel axes add up: $C_2 C_4 - S_2 S_4 = C_{24}$.",
                "The last column is $[a_2 + a_3 C_2,\\ a_3 S_2,\\ -d_2,\\ 1]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Row 2 of the table.",
                        r"{}^1T_2 = \begin{bmatrix} C_2 & -S_2 & 0 & a_2 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Your $U_2$ stands to its right.",
                        r"{}^2T_4 = \begin{bmatrix} C_4 & -S_4 & 0 & a_3 \\ S_4 & C_4 & 0 & 0 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply.",
                        r"{}^1T_4 = {}^1T_2 {}^2T_4 = \begin{bmatrix} C_2 C_4 - S_2 S_4 & -C_2 S_4 - S_2 C_4 & 0 & a_2 + a_3 C_2 \\ S_2 C_4 + C_2 S_4 & C_2 C_4 - S_2 S_4 & 0 & a_3 S_2 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Sines and cosines of a sum.",
                        r"{}^1T_4 = \begin{bmatrix} C_{24} & -S_{24} & 0 & a_2 + a_3 C_2 \\ S_{24} & C_{24} & 0 & a_3 S_2 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara_modified"},
            ),
            right=(
                pose_in_1,
                U_1,
                WithSympy(
                    lambda sp: _turned(
                        sp,
                        sp.Symbol("theta_2") + sp.Symbol("theta_4"),
                        sp.Symbol("a_2") + sp.Symbol("a_3") * sp.cos(sp.Symbol("theta_2")),
                        sp.Symbol("a_3") * sp.sin(sp.Symbol("theta_2")),
                    )
                ),
            ),
            wrong=(
                Wrong(lambda q, a_2, a_3: pose_in_1(q, a_3, a_2), "swapped"),
                Wrong(U_1.replace("a_3 C_2 + a_2", "a_3 C_2"), "entry (1, 4)"),
                Wrong(U_1.replace("C_2 C_4 - S_2 S_4", "C_2 C_4 + S_2 S_4"), "entry (1, 1)"),
                Wrong(forward, "in frame 0"),
                Wrong(lambda q, a_2, a_3: pose_in_1([q[0], q[1], -q[2], q[3]], a_2, a_3), "sign"),
            ),
        ),
        Task(
            name="forward",
            title="The whole model in Python",
            text="Write `forward(q, a_2, a_3)`, the pose of frame 4 in frame 0 (4×4), with `q` = $[\\theta_1, \\theta_2, d_2, \\theta_4]$: a loop"
            " over the rows of your table, from the tool to the base.",
            asks=Quantity(ARM, {"pose": 4}),
            hints=(
                "Start with `U = np.eye(4)`, and multiply a link matrix to its left, row 4 first.",
                "`for row in reversed(rows): U = link(*row) @ U`, with rows in the order in which `link` takes its arguments.",
                "The result is a turn by $\\theta_1 + \\theta_2 + \\theta_4$ with the origin $[a_2 C_1 + a_3 C_{12},\\ a_2 S_1 + a_3 S_{12},\\ -d_2]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The loop begins at the tool, with row 4.",
                        r"{}^3T_4 = \begin{bmatrix} C_4 & -S_4 & 0 & 0 \\ S_4 & C_4 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 3 comes to its left.",
                        r"{}^2T_4 = {}^2T_3 {}^3T_4 = \begin{bmatrix} C_4 & -S_4 & 0 & a_3 \\ S_4 & C_4 & 0 & 0 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Then row 2.",
                        r"{}^1T_4 = {}^1T_2 {}^2T_4 = \begin{bmatrix} C_{24} & -S_{24} & 0 & a_2 + a_3 C_2 \\ S_{24} & C_{24} & 0 & a_3 S_2 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 1 comes last.",
                        r"{}^0T_4 = {}^0T_1 {}^1T_4 = \begin{bmatrix} C_{124} & -S_{124} & 0 & a_2 C_1 + a_3 C_{12} \\ S_{124} & C_{124} & 0 & a_2 S_1 + a_3 S_{12} \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara_modified"},
            ),
            right=(forward, U_0, WithSympy(_forward_sympy)),
            wrong=(
                Wrong(
                    lambda q, a_2, a_3: forward([q[0], q[1], -q[2], q[3]], a_2, a_3),
                    "the quill goes up: row 3 has the offset -d_2, not d_2 as in the slide's listing",
                    own=True,
                ),
                Wrong(
                    lambda q, a_2, a_3: product(_rows(q, a_2, a_3)[::-1]),
                    "the factors stand in the reverse order: link 1 is the leftmost one",
                    own=True,
                ),
                Wrong(
                    lambda q, a_2, a_3: product(_rows(q, a_2, a_3), classic_link),
                    "the numbers of the modified table stand in the classic matrix: the two do not mix",
                    own=True,
                ),
                Wrong(
                    lambda q, a_2, a_3: forward([q[0], q[1] - q[0], q[2], q[3]], a_2, a_3),
                    "θ_2 is taken from the base; it counts from the first arm: C_12 and S_12",
                    own=True,
                ),
                Wrong(lambda q, a_2, a_3: forward(q, a_3, a_2), "swapped"),
                Wrong(lambda q, a_2, a_3: forward(np.deg2rad(q), a_2, a_3), "degrees"),
            ),
        ),
        Task(
            name="listing",
            title="The program of the slide",
            text="The slide's listing has `d3 = symbols('d2')` in row 3, and the slide shows `-1.0*d2` as the third number of its output, in the zero"
            " pose. What does the listing print there? `a`: `-1.0*d2`; `b`: `1.0*d2`; `c`: `0`; `d`: an error.",
            asks=Choice(
                {"a": "-1.0*d2", "b": "1.0*d2", "c": "0", "d": "an error"},
                right="b",
                because={
                    "a": "this is what the slide shows, not what its listing gives: follow d3 into the entry (3, 4)",
                    "c": "substituting zero for the angles leaves d2 as it is",
                    "d": "a letter for an offset is no error: the program computes with symbols",
                },
            ),
            hints=(
                "Which entry of the link matrix holds `di`?",
                "All twists are zero: `cos(alpha)*di` is `di`.",
                "Nothing in the listing makes a minus.",
            ),
            right=("b", ["b"], {"b"}),
            wrong=(
                Wrong("a", "not what its listing gives"),
                Wrong("c", "leaves d2 as it is"),
                Wrong("d", "computes with symbols"),
                Wrong(["a", "b"], "one of them is asked for"),
            ),
        ),
        Task(
            name="above",
            title="The distance from axis 1",
            text="Write $x^2 + y^2$, the squared distance of the tool from axis 1, with one angle only: in `theta_2`, `a_2`, `a_3`.",
            asks=Formula(r"a_2^2 + a_3^2 + 2 a_2 a_3 \cos\theta_2", ("theta_2", "a_2", "a_3"), arm=ARM, unit="m²"),
            hints=(
                "Seen from above, axis 1, the elbow and the tool form a triangle. Which angle is at the elbow?",
                "The angle inside the triangle is $\\pi - \\theta_2$; use the law of cosines.",
                "$\\cos(\\pi - \\theta_2) = -\\cos\\theta_2$: the last term is $+2 a_2 a_3 \\cos\\theta_2$.",
            ),
            derivation=Derivation(
                (
                    Line("Seen from above, $x$ of the tool.", r"x = a_2 C_1 + a_3 C_{12}"),
                    Line("And $y$.", r"y = a_2 S_1 + a_3 S_{12}"),
                    Line(
                        "Square and add: $C_1^2 + S_1^2 = 1$, twice.",
                        r"x^2 + y^2 = a_2^2 + a_3^2 + 2 a_2 a_3 (C_1 C_{12} + S_1 S_{12})",
                    ),
                    Line(
                        "The bracket is the cosine of the difference of the two angles.",
                        r"x^2 + y^2 = a_2^2 + a_3^2 + 2 a_2 a_3 \cos\theta_2",
                    ),
                ),
                {
                    "arm": "scara_modified",
                    "quantities": {"x": {"origin": 4, "component": "x"}, "y": {"origin": 4, "component": "y"}},
                },
            ),
            right=(
                distance_squared,
                r"(a_2 + a_3 C_2)^2 + (a_3 S_2)^2",
                WithSympy(
                    lambda sp: sp.expand_trig(
                        (sp.Symbol("a_2") + sp.Symbol("a_3")) ** 2
                        - 4 * sp.Symbol("a_2") * sp.Symbol("a_3") * sp.sin(sp.Symbol("theta_2") / 2) ** 2
                    )
                ),
            ),
            wrong=(
                Wrong(
                    r"a_2^2 + a_3^2 - 2 a_2 a_3 \cos\theta_2",
                    "the angle at the elbow inside the triangle is π − θ_2, not θ_2: at θ_2 = 0 the arm is stretched",
                    own=True,
                ),
                Wrong(r"a_2^2 + a_3^2 + 2 a_2 a_3 \sin\theta_2", "cos"),
                Wrong(
                    r"a_2^2 + a_3^2",
                    "this is the distance at a right angle only: the term with θ_2 is missing",
                    own=True,
                ),
                Wrong(
                    r"\sqrt{(a_2^2 + a_3^2 + 2 a_2 a_3 \cos\theta_2)}",
                    "this is the distance; its square is asked",
                    own=True,
                ),
                Wrong(r"a_2^2 + a_3^2 + a_2 a_3 \cos\theta_2", "the factor 2 of the mixed term is missing", own=True),
            ),
        ),
        _reach(),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A column turns by $\\theta_1$, a carriage rises by $d_2$, a ram goes out by $d_3$: the modified table has the rows $(0, 0, 0, \\theta_1)$,"
            " $(0, 0, d_2, 0)$, $(-\\frac{\\pi}{2}, 0, d_3, 0)$. Write ${}^0T_3$. A function takes `q` = $[\\theta_1, d_2, d_3]$.",
            asks=Quantity(CYLINDRICAL, {"pose": 3, "in": 0}),
            hints=(
                "Three link matrices; the first two make a turn and a rise.",
                "$R_x(-\\frac{\\pi}{2})$ lays $z_3$ along $y_2$: the ram's end is at $[-d_3 S_1, d_3 C_1, d_2]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The first two rows: a turn and a rise along one axis.",
                        r"{}^0T_2 = \begin{bmatrix} C_1 & -S_1 & 0 & 0 \\ S_1 & C_1 & 0 & 0 \\ 0 & 0 & 1 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 3: $R_x(-\\frac{\\pi}{2})$ lays the ram along $y_2$.",
                        r"{}^2T_3 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply.",
                        r"{}^0T_2 {}^2T_3 = \begin{bmatrix} C_1 & 0 & -S_1 & -d_3 S_1 \\ S_1 & 0 & C_1 & d_3 C_1 \\ 0 & -1 & 0 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": CYLINDRICAL},
            ),
            right=(cylinder, CYLINDER, WithSympy(_cylinder_sympy)),
            wrong=(
                Wrong(lambda q: np.linalg.inv(cylinder(q)), "the inverse"),
                Wrong(lambda q: cylinder([np.deg2rad(q[0]), q[1], q[2]]), "degrees"),
                Wrong(
                    lambda q: cylinder([q[0], q[2], q[1]]),
                    "rise and ram are exchanged: d_2 goes up the column, d_3 goes out",
                    own=True,
                ),
                Wrong(
                    lambda q: cylinder(q) @ np.diag([1, -1, -1, 1]),
                    "the third row turns by −90° about x: with +90° the ram points the other way",
                    own=True,
                ),
                Wrong(lambda q: cylinder([q[0], q[1], 0]), "the ram is missing: d_3 shifts along z_3", own=True),
            ),
        ),
    ),
)
