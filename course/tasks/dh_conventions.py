"""Tasks of lesson 3, the two Denavit–Hartenberg conventions (MECA 953 Robotique, MMT5, 2022, document 001)."""

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
from armproof.course.links import classic_link, modified_link, product, shift, turn

# The arm of the lesson, a crane: a column, a horizontal axis e beside it at the height h, a slide. In both conventions.
MODIFIED = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "h", "theta": "theta_1"},
        {"alpha": "-pi/2", "a": "e", "d": 0, "theta": "theta_2"},
        {"alpha": "pi/2", "a": 0, "d": "d_3", "theta": 0},
    ],
}
CLASSIC = {
    "dh": "classic",
    "rows": [
        {"theta": "theta_1", "d": "h", "a": "e", "alpha": "-pi/2"},
        {"theta": "theta_2", "d": 0, "a": 0, "alpha": "pi/2"},
        {"theta": 0, "d": "d_3", "a": 0, "alpha": 0},
    ],
}

MODIFIED_ROWS = [(0, 0, "h", "theta_1"), ("-pi/2", "e", 0, "theta_2"), ("pi/2", 0, "d_3", 0)]
CLASSIC_ROWS = [("theta_1", "h", "e", "-pi/2"), ("theta_2", 0, 0, "pi/2"), (0, "d_3", 0, 0)]

# -- the general matrices ----------------------------------------------------------------------------------------------


def classic_matrix(a, alpha, d, theta):
    """Return Rot_z(θ) Trans_z(d) Trans_x(a) Rot_x(α): the origin is a along the turned x axis, and d up."""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([
        [ct, -ca * st, sa * st, a * ct],
        [st, ca * ct, -sa * ct, a * st],
        [0, sa, ca, d],
        [0, 0, 0, 1],
    ])  # fmt: skip


CLASSIC_MATRIX = r"""\begin{bmatrix} C\theta & -C\alpha S\theta & S\alpha S\theta & a\,C\theta \\
S\theta & C\alpha C\theta & -S\alpha C\theta & a\,S\theta \\ 0 & S\alpha & C\alpha & d \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _classic_sympy(sp):
    a, alpha, d, theta = sp.symbols("a alpha d theta")
    return turn(sp, "z", theta) * shift(sp, z=d) * shift(sp, x=a) * turn(sp, "x", alpha)


def modified_inverse(a, alpha, d, theta):
    """Return [Rᵀ, −RᵀO; 0, 1] of the modified matrix; −RᵀO is [−a Cθ, a Sθ, −d]."""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([
        [ct, st * ca, st * sa, -a * ct],
        [-st, ct * ca, ct * sa, a * st],
        [0, -sa, ca, -d],
        [0, 0, 0, 1],
    ])  # fmt: skip


MODIFIED_INVERSE = r"""\begin{bmatrix} C\theta & S\theta C\alpha & S\theta S\alpha & -a\,C\theta \\
-S\theta & C\theta C\alpha & C\theta S\alpha & a\,S\theta \\ 0 & -S\alpha & C\alpha & -d \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _inverse_sympy(sp):
    a, alpha, d, theta = sp.symbols("a alpha d theta")
    return turn(sp, "z", -theta) * shift(sp, z=-d) * turn(sp, "x", -alpha) * shift(sp, x=-a)


def _origin_only_negated(a, alpha, d, theta):
    forward = modified_link(a, alpha, d, theta)
    return np.vstack([np.column_stack([forward[:3, :3].T, -forward[:3, 3]]), [0, 0, 0, 1]])


# -- the tool of the crane ---------------------------------------------------------------------------------------------


def tool(q, h, e):
    """Return the origin of frame 3 in frame 0: the radius from axis 1, turned by θ_1, and the height."""
    theta_1, theta_2, d_3 = q
    radius = e + d_3 * np.sin(theta_2)
    return [radius * np.cos(theta_1), radius * np.sin(theta_1), h + d_3 * np.cos(theta_2)]


TOOL = r"\begin{bmatrix} (e + d_3 S_2) C_1 \\ (e + d_3 S_2) S_1 \\ h + d_3 C_2 \end{bmatrix}"


def _tool_sympy(sp):
    t1, t2, d3, h, e = sp.symbols("theta_1 theta_2 d_3 h e")
    x, y = (e * f + d3 * sp.sin(t2) * f for f in (sp.cos(t1), sp.sin(t1)))
    return sp.Matrix([x, y, h + d3 * sp.cos(t2)])


def _other_convention(q, h, e):
    """Return what the numbers of the modified table give when put into the classic matrix."""
    rows = [(0, 0, h, q[0]), (e, -np.pi / 2, 0, q[1]), (0, np.pi / 2, q[2], 0)]
    return product(rows, classic_link)[:3, 3]


# A wall crane: a carriage on a mast, a bar that turns on it, a ram across the bar. The task gives one table and asks for the other.
WALL_CRANE = {
    "dh": "classic",
    "rows": [
        {"theta": 0, "d": "d_1", "a": "b", "alpha": 0},
        {"theta": "theta_2", "d": 0, "a": 0, "alpha": "pi/2"},
        {"theta": 0, "d": "d_3", "a": 0, "alpha": 0},
    ],
}
WALL_CRANE_ROWS = [(0, "d_1", "b", 0), ("theta_2", 0, 0, "pi/2"), (0, "d_3", 0, 0)]


LESSON = Lesson(
    number=3,
    name="dh_conventions",
    title="The two Denavit–Hartenberg conventions",
    source="MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Place the frames of a new arm in eight steps, and fill in its table in both conventions.",
        "Write the general link matrix of each convention, and its inverse.",
        "Choose a check that finds the slip of a printed matrix, and know the checks that cannot.",
    ),
    tasks=(
        Task(
            name="origin",
            title="Prediction: where is the origin?",
            text="Modified convention. The motor of joint 1 stands on the floor; axis 1 is vertical. Axis 2 is horizontal, at the height $h$,"
            " and passes axis 1 at the distance $e$. Where is $O_1$? `a`: at the motor, on the floor; `b`: on axis 1, at the height $h$;"
            " `c`: on axis 2, nearest to axis 1; `d`: in the middle between the two axes.",
            asks=Choice(
                {"a": "at the motor", "b": "on axis 1, at the height h", "c": "on axis 2", "d": "between the axes"},
                right="b",
                because={
                    "a": "an origin need not sit at the joint: only the axis counts, and the common normal meets it elsewhere",
                    "c": "this is O_1 of the classic convention; in the modified one O_i lies on the axis of joint i",
                    "d": "an origin lies on an axis: where the common normal meets it",
                },
            ),
            hints=(
                "$O_1$ is where the common normal of axes 1 and 2 meets one of them.",
                "The common normal is horizontal, at right angles to both axes. At which height?",
                "Modified: $O_i$ lies on axis $i$.",
            ),
            right=("b", ["b"], {"b"}),
            wrong=(
                Wrong("a", "an origin need not sit at the joint"),
                Wrong("c", "classic convention"),
                Wrong("d", "an origin lies on an axis"),
                Wrong(["a", "b"], "one of them is asked for"),
            ),
        ),
        Task(
            name="modified_table",
            title="The modified table",
            text="Fill in the table of the crane in the modified convention: a list of three rows"
            ' $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$ with `theta_1`, `theta_2`, `d_3`, `h`, `e`; angles in radians, as in `"pi/2"`.',
            asks=Table(MODIFIED, "modified"),
            hints=(
                "Row $i$ leads from frame $i-1$ to frame $i$: first about and along $x_{i-1}$, then about and along $z_i$.",
                "For the twists, turn $z_{i-1}$ into $z_i$ about $x_{i-1}$ by the right-hand rule.",
                "Row 2 is $(-\\pi/2, e, 0, \\theta_2)$: $z_1$ points up, $z_2$ along $y_1$. Row 1 has the height, row 3 the slide.",
            ),
            right=(
                MODIFIED_ROWS,
                [dict(zip(("alpha", "a", "d", "theta"), row, strict=True)) for row in MODIFIED_ROWS],
                r"\begin{array}{cccc} 0 & 0 & h & \theta_1 \\ -\frac{\pi}{2} & e & 0 & \theta_2 \\ \frac{\pi}{2} & 0 & d_3 & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [(0, 0, "h", "theta_1"), ("pi/2", "e", 0, "theta_2"), ("-pi/2", 0, "d_3", 0)],
                    "rows 2, 3: alpha is wrong",
                ),
                Wrong(
                    [("-pi/2", "e", "h", "theta_1"), ("pi/2", 0, 0, "theta_2"), (0, 0, "d_3", 0)],
                    "lengths and twists stand one row too early: this is the classic table; a row of the modified one holds those of the link before",
                    own=True,
                ),
                Wrong(
                    [(0, 0, 0, "theta_1"), ("-pi/2", "e", "h", "theta_2"), ("pi/2", 0, "d_3", 0)],
                    "the height is measured along z_2; it lies along z_1, and belongs to row 1",
                    own=True,
                ),
                Wrong(
                    [(0, 0, "h", "theta_1"), ("-pi/2", "e", 0, "theta_2"), ("pi/2", "d_3", 0, 0)],
                    "the slide moves along z_3: its variable is an offset d, not a length a",
                    own=True,
                ),
                Wrong(MODIFIED_ROWS[:2], "3 rows"),
            ),
        ),
        Task(
            name="classic_table",
            title="The classic table",
            text="Fill in the table of the same crane in the classic convention: three rows $(\\theta_i, d_i, a_i, \\alpha_i)$.",
            asks=Table(CLASSIC, "classic"),
            hints=(
                "Row $i$ leads from frame $i-1$ to frame $i$: first about and along $z_{i-1}$, the axis of joint $i$, then along and about $x_i$.",
                "The lengths and twists are the same as before. In which row does each stand now?",
                "Row 1 is $(\\theta_1, h, e, -\\pi/2)$; the last row has no length and no twist.",
            ),
            right=(
                CLASSIC_ROWS,
                [dict(zip(("theta", "d", "a", "alpha"), row, strict=True)) for row in CLASSIC_ROWS],
                r"\begin{array}{cccc} \theta_1 & h & e & -\frac{\pi}{2} \\ \theta_2 & 0 & 0 & \frac{\pi}{2} \\ 0 & d_3 & 0 & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [("theta_1", "h", 0, 0), ("theta_2", 0, "e", "-pi/2"), (0, "d_3", 0, "pi/2")],
                    "lengths and twists stand one row too late: these are the modified parameters in classic columns",
                    own=True,
                ),
                Wrong(
                    [("theta_1", "h", "e", "pi/2"), ("theta_2", 0, 0, "pi/2"), (0, "d_3", 0, 0)],
                    "row 1: alpha is wrong (the sign)",
                ),
                Wrong(
                    [("theta_1", "e", "h", "-pi/2"), ("theta_2", 0, 0, "pi/2"), (0, "d_3", 0, 0)],
                    "d and a are exchanged in row 1, the slip of the slide: d is measured along z_{i-1}, a along x_i",
                    own=True,
                ),
                Wrong(
                    [("theta_1", "h", "e", "-pi/2"), ("theta_2", 0, 0, "pi/2"), ("d_3", 0, 0, 0)],
                    "the variable of the slide stands in the column of the angles: it is an offset, d_3",
                    own=True,
                ),
                Wrong(
                    [("theta_1", "h", "e", "-pi/2"), ("theta_2", "d_3", 0, "pi/2"), (0, 0, 0, 0)],
                    "d of row 2 and d of row 3 are exchanged",
                ),
            ),
        ),
        Task(
            name="tool",
            title="The tool of the crane",
            text="Write the origin of frame 3 in frame 0, three entries in metres. A function may be `def tool(q, h, e)` with"
            " `q` = $[\\theta_1, \\theta_2, d_3]$.",
            asks=Quantity(MODIFIED, {"origin": 3}),
            hints=(
                "Look at the crane from the side first, with $\\theta_1 = 0$: how far from axis 1, and how high, is the tool?",
                "At $\\theta_2 = 0$ the slide points up; at $90°$ it points away from the column.",
                "The distance from axis 1 is $e + d_3 S_2$, the height $h + d_3 C_2$; then turn by $\\theta_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Row 3: the slide moves along $z_3$, which is $-y_2$.",
                        r"{}^2T_3 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} 0 \\ -d_3 \\ 0 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 2 leans it by $\\theta_2$, at the distance $e$ from axis 1.",
                        r"{}^1T_3 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} e + d_3 S_2 \\ 0 \\ d_3 C_2 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 1 turns this by $\\theta_1$ and lifts it by $h$.",
                        r"p_3 = \begin{bmatrix} (e + d_3 S_2) C_1 \\ (e + d_3 S_2) S_1 \\ h + d_3 C_2 \end{bmatrix}",
                    ),
                ),
                {"arm": MODIFIED},
            ),
            right=(tool, TOOL, WithSympy(_tool_sympy)),
            wrong=(
                Wrong(
                    lambda q, h, e: tool([q[0], np.pi / 2 - q[1], q[2]], h, e),
                    "θ_2 is counted from the horizontal: at θ_2 = 0 the slide points up",
                    own=True,
                ),
                Wrong(lambda q, h, e: tool(q, e, h), "swapped"),
                Wrong(lambda q, h, e: tool(q, h, 0), "the distance e between axes 1 and 2 is missing", own=True),
                Wrong(
                    _other_convention,
                    "the numbers of the modified table stand in the classic matrix: the two do not mix",
                    own=True,
                ),
                Wrong(
                    lambda q, h, e: tool([q[0], -q[1], q[2]], h, e),
                    "θ_2 turns the slide towards the column: positive θ_2, about z_2 = y_1, leans it away",
                    own=True,
                ),
            ),
        ),
        Task(
            name="classic_matrix",
            title="The classic link matrix",
            text="Correct the slide: write the classic link matrix, 4×4, in `a`, `alpha`, `d`, `theta` (a function takes them in this order; indices are"
            " left out).",
            asks=Formula(CLASSIC_MATRIX, ("a", "alpha", "d", "theta")),
            hints=(
                "Put $\\theta = \\alpha = d = 0$: where should the origin be, and where does the slide put it?",
                "Multiply $\\mathbf{Rot}_z(\\theta)\\,\\mathbf{Trans}_z(d)\\,\\mathbf{Trans}_x(a)\\,\\mathbf{Rot}_x(\\alpha)$.",
                "The rotation is printed rightly; the last column is $[a\\,C\\theta, a\\,S\\theta, d, 1]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The two steps along and about $z$.",
                        r"\mathrm{Rot}_z(\theta)\,\mathrm{Trans}_z(d) = \begin{bmatrix} \cos\theta & -\sin\theta & 0 & 0 \\ \sin\theta & \cos\theta & 0 & 0 \\ 0 & 0 & 1 & d \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The two steps along and about $x$.",
                        r"\mathrm{Trans}_x(a)\,\mathrm{Rot}_x(\alpha) = \begin{bmatrix} 1 & 0 & 0 & a \\ 0 & \cos\alpha & -\sin\alpha & 0 \\ 0 & \sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply the two.",
                        r"\mathrm{Rot}_z(\theta)\,\mathrm{Trans}_z(d)\,\mathrm{Trans}_x(a)\,\mathrm{Rot}_x(\alpha) = \begin{bmatrix} \cos\theta & -\sin\theta\cos\alpha & \sin\theta\sin\alpha & a\cos\theta \\ \sin\theta & \cos\theta\cos\alpha & -\cos\theta\sin\alpha & a\sin\theta \\ 0 & \sin\alpha & \cos\alpha & d \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"symbols": {"theta": "free", "d": "free", "a": "free", "alpha": "free"}},
            ),
            right=(classic_matrix, CLASSIC_MATRIX, WithSympy(_classic_sympy)),
            wrong=(
                Wrong(
                    lambda a, alpha, d, theta: classic_matrix(d, alpha, a, theta),
                    "a and d are exchanged, as on the slide: a lies along x, d along z",
                    own=True,
                ),
                Wrong(modified_link, "this is the modified link matrix: here the steps about x come last", own=True),
                Wrong(
                    lambda a, alpha, d, theta: classic_matrix(a, -alpha, d, theta),
                    "the twist has the wrong sign: z_{i-1} turns into z_i about x_i",
                    own=True,
                ),
                Wrong(lambda a, alpha, d, theta: classic_matrix(a, alpha, d, theta).T, "transposed"),
                Wrong(
                    CLASSIC_MATRIX.replace(r"a\,C\theta", "a").replace(r"a\,S\theta", "0"),
                    "the move along x comes before the turn about z here: a must be turned by θ",
                    own=True,
                ),
            ),
        ),
        Task(
            name="modified_inverse",
            title="The inverse of the modified link matrix",
            text="Write ${}^iT_{i-1}$ of the modified convention, 4×4, in `a`, `alpha` (those of link $i-1$), `d`, `theta`.",
            asks=Formula(MODIFIED_INVERSE, ("a", "alpha", "d", "theta")),
            hints=(
                "Invert the four steps one by one. In which order?",
                "In blocks: $R^T$, and $-R^T O$ with $O = [a, -d\\,S\\alpha, d\\,C\\alpha]^T$.",
                "The last column is $[-a\\,C\\theta, a\\,S\\theta, -d, 1]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The link matrix has four steps. Undo each of them, the last one first.",
                        r"\left( \mathrm{Rot}_x(\alpha)\,\mathrm{Trans}_x(a)\,\mathrm{Rot}_z(\theta)\,\mathrm{Trans}_z(d) \right)^{-1} = \mathrm{Trans}_z(-d)\,\mathrm{Rot}_z(-\theta)\,\mathrm{Trans}_x(-a)\,\mathrm{Rot}_x(-\alpha)",
                    ),
                    Line(
                        "The two steps along and about $z$, undone.",
                        r"\mathrm{Trans}_z(-d)\,\mathrm{Rot}_z(-\theta) = \begin{bmatrix} \cos\theta & \sin\theta & 0 & 0 \\ -\sin\theta & \cos\theta & 0 & 0 \\ 0 & 0 & 1 & -d \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The two steps along and about $x$, undone.",
                        r"\mathrm{Trans}_x(-a)\,\mathrm{Rot}_x(-\alpha) = \begin{bmatrix} 1 & 0 & 0 & -a \\ 0 & \cos\alpha & \sin\alpha & 0 \\ 0 & -\sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply the two.",
                        r"\mathrm{Trans}_z(-d)\,\mathrm{Rot}_z(-\theta)\,\mathrm{Trans}_x(-a)\,\mathrm{Rot}_x(-\alpha) = \begin{bmatrix} \cos\theta & \sin\theta\cos\alpha & \sin\theta\sin\alpha & -a\cos\theta \\ -\sin\theta & \cos\theta\cos\alpha & \cos\theta\sin\alpha & a\sin\theta \\ 0 & -\sin\alpha & \cos\alpha & -d \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"symbols": {"theta": "free", "d": "free", "a": "free", "alpha": "free"}},
            ),
            right=(modified_inverse, MODIFIED_INVERSE, WithSympy(_inverse_sympy)),
            wrong=(
                Wrong(_origin_only_negated, "the origin is only negated: seen from frame i it is −RᵀO", own=True),
                Wrong(
                    lambda a, alpha, d, theta: modified_link(-a, -alpha, -d, -theta),
                    "the steps about x are undone first, as in the inverse of the classic matrix: the last steps made, those about z, are undone first",
                    own=True,
                ),
                Wrong(
                    lambda a, alpha, d, theta: modified_link(a, alpha, d, theta).T,
                    "the whole is transposed: only the rotation block is, and the last row stays 0 0 0 1",
                    own=True,
                ),
                Wrong(
                    modified_link,
                    "this is the matrix itself, the pose of i in i-1; what is asked is the pose of i-1 in i",
                    own=True,
                ),
                Wrong(MODIFIED_INVERSE.replace(r"& a\,S\theta", r"& -a\,S\theta"), "(2, 4)"),
            ),
        ),
        Task(
            name="checks",
            title="Which check would have caught it?",
            text="The slide exchanges $a_i$ and $d_i$ in the classic matrix and in its inverse. Which checks find that? `a`: the product of the two"
            " printed matrices is the identity; `b`: the determinant of the rotation block is 1; `c`: the origin at"
            " $\\theta_i = \\alpha_i = d_i = 0$; `d`: the pose in Drake, with different $a_i$ and $d_i$; `e`: the pose in Drake, with"
            " $a_i = d_i$. Give a list of letters.",
            asks=Choice(
                {
                    "a": "product",
                    "b": "determinant",
                    "c": "origin",
                    "d": "Drake, different lengths",
                    "e": "Drake, equal lengths",
                },
                right=frozenset({"c", "d"}),
                because={
                    "a": "the exchange was made in both matrices, so they are still inverse to each other",
                    "b": "the rotation does not contain a or d: it is right",
                    "e": "equal lengths hide an exchange of lengths at every configuration",
                },
            ),
            hints=(
                "A check that cannot fail is worth nothing: try each one on the wrong matrix.",
                "If the same slip is in a matrix and in its inverse, what is their product?",
                "Look for checks in which $a$ and $d$ are told apart.",
            ),
            right=(["c", "d"], "d, c", {"c", "d"}),
            wrong=(
                Wrong(["a", "c", "d"], "still inverse to each other"),
                Wrong(["c", "d", "e"], "equal lengths hide"),
                Wrong(["b"], "the rotation does not contain a or d"),
                Wrong("c", "there is more"),
            ),
        ),
        Task(
            name="parallel",
            title="Limits: axes that are nearly parallel",
            text="Two axes cross in a plane. They are meant to be parallel, 0.5 m apart, but one leans by 0.001 rad towards the other. How far away"
            " do they meet, in metres? (Six digits are not needed: take $\\tan x = x$.)",
            asks=Number(500, unit="m", steps=("0.5/0.001",), beside=("(0.5/2)/0.001",)),
            hints=(
                "Draw the triangle: the distance of the axes, one axis, the leaning one.",
                "$\\tan 0.001 = 0.5 / L$.",
                "$L = 0.5 / 0.001$ metres.",
            ),
            right=(500, "500", 0.5 / np.tan(0.001)),
            wrong=(
                Wrong(
                    0.5, "this is how far apart the axes are: the question is how far along them they meet", own=True
                ),
                Wrong(0.0005, "this is 0.5 · 0.001, the side across; the axes meet at 0.5 / 0.001", own=True),
                Wrong(0, "the axes are not parallel, so they meet somewhere, and far away", own=True),
                Wrong(0.5 / np.tan(np.deg2rad(0.001)), "the angle is in radians already", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A wall crane: a carriage slides up by $d_1$, a bar turns by $\\theta_2$ about an axis at the distance $b$, a ram goes out by $d_3$. Its"
            " **modified** table is $(0, 0, d_1, 0)$, $(0, b, 0, \\theta_2)$, $(\\frac{\\pi}{2}, 0, d_3, 0)$. Write its **classic** table: three rows"
            " $(\\theta_i, d_i, a_i, \\alpha_i)$.",
            asks=Table(WALL_CRANE, "classic"),
            hints=(
                "The joint variables stay in their rows. What belongs to a link, $a$ and $\\alpha$, has another row.",
                "A modified row holds $a$ and $\\alpha$ of the link before it, a classic row those of its own link: they move up by one row.",
                "Behind the last joint nothing is left: $a_3 = 0$ and $\\alpha_3 = 0$.",
            ),
            right=(
                WALL_CRANE_ROWS,
                WALL_CRANE["rows"],
                r"\begin{array}{cccc} 0 & d_1 & b & 0 \\ \theta_2 & 0 & 0 & \pi/2 \\ 0 & d_3 & 0 & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [(0, "d_1", 0, 0), ("theta_2", 0, "b", 0), (0, "d_3", 0, "pi/2")],
                    "the rows are only written in the other order: a and α stay one row too late for the classic convention",
                    own=True,
                ),
                Wrong(
                    [WALL_CRANE_ROWS[0], ("theta_2", 0, 0, "-pi/2"), WALL_CRANE_ROWS[2]],
                    "row 2: alpha is wrong (the sign)",
                ),
                Wrong(
                    [(0, "d_1", "b", "pi/2"), ("theta_2", 0, 0, 0), WALL_CRANE_ROWS[2]],
                    "the twist has moved two rows: it lies between axes 2 and 3, so it belongs to link 2",
                    own=True,
                ),
                Wrong([(0, "b", "d_1", 0), *WALL_CRANE_ROWS[1:]], "row 1: d and a are exchanged"),
                Wrong(
                    [("d_1", 0, "b", 0), WALL_CRANE_ROWS[1], ("d_3", 0, 0, 0)],
                    "a slide has its variable in the column of d, in both conventions",
                    own=True,
                ),
                Wrong(WALL_CRANE_ROWS[:2], "3 rows"),
            ),
        ),
    ),
)
