"""Tasks of lesson 4, placing the frames of an arm in eight steps (MECA 953 Robotique, MMT5, 2022, document 001)."""

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

# The arm of the lesson, a drill rig: axes 1 and 2 cross, axes 2 and 3 are parallel, axes 3 and 4 are skew. Frame 0 at the shoulder.
RIG = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"},
        {"alpha": "pi/2", "a": 0, "d": 0, "theta": "theta_2"},
        {"alpha": 0, "a": "a_2", "d": 0, "theta": "theta_3"},
        {"alpha": "pi/2", "a": "e", "d": "d_4", "theta": 0},
    ],
}
ROWS = [(0, 0, 0, "theta_1"), ("pi/2", 0, 0, "theta_2"), (0, "a_2", 0, "theta_3"), ("pi/2", "e", "d_4", 0)]

# -- the common normal -------------------------------------------------------------------------------------------------


def distance(s, t, a, alpha):
    """Return the squared distance of the point s on one axis from the point t on the other."""
    return a**2 + (t * np.sin(alpha)) ** 2 + (s - t * np.cos(alpha)) ** 2


DISTANCE = r"a^2 + s^2 + t^2 - 2 s t \cos\alpha"


def _distance_sympy(sp):
    s, t, a, alpha = sp.symbols("s t a alpha")
    between = sp.Matrix([a, -t * sp.sin(alpha), t * sp.cos(alpha) - s])
    return between.dot(between)


def freedom(d_2, d_3, u):
    """Return both offsets after O_2 has moved by u along z_2."""
    return [d_2 + u, d_3 - u]


FREEDOM = r"\begin{bmatrix} d_2 + u \\ d_3 - u \end{bmatrix}"


def _freedom_sympy(sp):
    d2, d3, u = sp.symbols("d_2 d_3 u")
    return sp.Matrix([d2 + u, d3 - u])


# -- the axes of the frames --------------------------------------------------------------------------------------------


def first_x(q):
    """Return x_1 = z_1 × z_2 in frame 0."""
    z_1, z_2 = np.array([0, 0, 1]), np.array([np.sin(q[0]), -np.cos(q[0]), 0])
    return np.cross(z_1, z_2)


FIRST_X = r"\begin{bmatrix} C_1 \\ S_1 \\ 0 \end{bmatrix}"


def second_x(q):
    """Return the direction from O_2 to O_3 in frame 0."""
    return np.array([np.cos(q[0]) * np.cos(q[1]), np.sin(q[0]) * np.cos(q[1]), np.sin(q[1])])


SECOND_X = r"\begin{bmatrix} C_1 C_2 \\ S_1 C_2 \\ S_2 \end{bmatrix}"


def second_y(q):
    """Return y_2 = z_2 × x_2 in frame 0."""
    z_2 = np.array([np.sin(q[0]), -np.cos(q[0]), 0])
    x_2 = np.array([np.cos(q[0]) * np.cos(q[1]), np.sin(q[0]) * np.cos(q[1]), np.sin(q[1])])
    return np.cross(z_2, x_2)


SECOND_Y = r"\begin{bmatrix} -C_1 S_2 \\ -S_1 S_2 \\ C_2 \end{bmatrix}"


def _axes_sympy(sp):
    t1, t2 = sp.symbols("theta_1 theta_2")
    z_2 = sp.Matrix([sp.sin(t1), -sp.cos(t1), 0])
    x_2 = sp.Matrix([sp.cos(t1) * sp.cos(t2), sp.sin(t1) * sp.cos(t2), sp.sin(t2)])
    return sp.Matrix([0, 0, 1]).cross(z_2), x_2, z_2.cross(x_2)


# -- variable and tool -------------------------------------------------------------------------------------------------


def variable(sigma, theta, d):
    """Return the joint variable: θ where σ = 0, d where σ = 1."""
    return (1 - sigma) * theta + sigma * d


VARIABLE = r"(1 - \sigma)\theta + \sigma d"


def _variable_sympy(sp):
    sigma, theta, d = sp.symbols("sigma theta d")
    return theta + sigma * (d - theta)


def tool(q, a_2, e):
    """Return the origin of frame 4 in frame 0: the radius from axis 1, turned by θ_1, and the height."""
    theta_1, theta_2, theta_3, d_4 = q
    both = theta_2 + theta_3
    radius = a_2 * np.cos(theta_2) + e * np.cos(both) + d_4 * np.sin(both)
    height = a_2 * np.sin(theta_2) + e * np.sin(both) - d_4 * np.cos(both)
    return np.array([radius * np.cos(theta_1), radius * np.sin(theta_1), height])


TOOL = r"""\begin{bmatrix} (a_2 C_2 + e C_{23} + d_4 S_{23}) C_1 \\ (a_2 C_2 + e C_{23} + d_4 S_{23}) S_1 \\
a_2 S_2 + e S_{23} - d_4 C_{23} \end{bmatrix}"""


def _tool_sympy(sp):
    t1, t2, t3, d4, a2, e = sp.symbols("theta_1 theta_2 theta_3 d_4 a_2 e")
    radius = a2 * sp.cos(t2) + e * sp.cos(t2 + t3) + d4 * sp.sin(t2 + t3)
    height = a2 * sp.sin(t2) + e * sp.sin(t2 + t3) - d4 * sp.cos(t2 + t3)
    return sp.Matrix([radius * sp.cos(t1), radius * sp.sin(t1), height])


def _changed(number, *row):
    """Return the table with another row (from 1)."""
    return [*ROWS[: number - 1], row, *ROWS[number:]]


# A stacker: a carriage on a mast, a boom and a fork that pitch about parallel axes. Given in words; the table is asked.
STACKER = {
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": "d_1", "theta": 0},
        {"alpha": "pi/2", "a": 0, "d": 0, "theta": "theta_2"},
        {"alpha": 0, "a": "c", "d": 0, "theta": "theta_3"},
    ],
}
STACKER_ROWS = [(0, 0, "d_1", 0), ("pi/2", 0, 0, "theta_2"), (0, "c", 0, "theta_3")]


LESSON = Lesson(
    number=4,
    name="placing_frames",
    title="Placing frames in eight steps",
    source="MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Carry out the eight steps of the modified convention by hand on an arm that you have never seen.",
        "Tell the three cases of two axes, and say what each leaves free.",
        "Write joint types, joint variables and the table, and test them on the tool.",
    ),
    tasks=(
        Task(
            name="numbers",
            title="Steps 1 and 2: count",
            text="How many links has the drill rig (the base counts), how many joints, and how many rows has its table? Give the three numbers.",
            asks=Number(
                (5, 4, 4),
                labels=("the number of links", "the number of joints", "the number of rows"),
                steps=("4 + 1", "4", "4"),
                beside=("[4 - 1, ,]", r"[, , 4 \cdot 4]", r"[, , 4 \cdot 5]"),
            ),
            hints=(
                "Each joint stands between two links.",
                "The links are numbered 0, 1, … and link 0 is the base.",
                "Four motions, so four joints; one link more; one row a joint.",
            ),
            right=([5, 4, 4], "5, 4, 4", np.array([5, 4, 4])),
            wrong=(
                Wrong(
                    [4, 4, 4], "the base is a link too, link 0: an open chain has one link more than joints", own=True
                ),
                Wrong([5, 5, 5], "five links are joined by four joints", own=True),
                Wrong([5, 4, 5], "a row leads from one frame to the next, so there is one a joint: four", own=True),
                Wrong([4, 5, 4], "links and joints are exchanged: each joint stands between two links", own=True),
                Wrong([4, 3, 3], "the ram is a joint too, although it does not turn", own=True),
                Wrong([5, 4, 6], "six rows has a Jacobian: a table has one a joint", own=True),
                Wrong([5, 3, 4], "a joint may slide as well as turn: the ram counts", own=True),
                Wrong([6, 5, 5], "the tool is a part of the last link, not a link of its own", own=True),
                Wrong([5, 5, 4], "five links are joined by four joints", own=True),
                Wrong([5, 4, 3], "the ram has a row as well, although it does not turn", own=True),
                Wrong([6, 4, 4], "the tool is a part of the last link: the base and one link a joint", own=True),
            ),
        ),
        Task(
            name="cases",
            title="Step 3: three cases of two axes",
            text="Which statements are true? `a`: axes 1 and 2 intersect; `b`: axes 1 and 2 are skew; `c`: axes 2 and 3 are parallel; `d`: axes 2"
            " and 3 intersect; `e`: axes 3 and 4 are skew; `f`: axes 3 and 4 intersect. Give a list of letters.",
            asks=Choice(
                {
                    "a": "1 and 2 intersect",
                    "b": "1 and 2 are skew",
                    "c": "2 and 3 are parallel",
                    "d": "2 and 3 intersect",
                    "e": "3 and 4 are skew",
                    "f": "3 and 4 intersect",
                },
                right=frozenset({"a", "c", "e"}),
                because={
                    "b": "the shoulder's axis crosses the vertical one: their distance is zero",
                    "d": "axes 2 and 3 have the same direction: they never meet",
                    "f": "the ram passes axis 3 at the distance e: they do not meet, and they are not parallel",
                },
                missing={
                    "a": "one pair has a point in common: read the description of the shoulder again",
                    "c": "one pair has the same direction: shoulder and elbow",
                    "e": "one pair neither meets nor is parallel: that is called skew",
                },
            ),
            hints=(
                "For each pair ask two questions: is the direction the same? Is there a point in common?",
                "Shoulder and elbow both lie across the boom. The ram passes the elbow at the distance $e$.",
                "One pair of each kind: intersecting, parallel, skew.",
            ),
            right=(["a", "c", "e"], "a, c, e", {"e", "c", "a"}),
            wrong=(
                Wrong(["b", "c", "e"], "their distance is zero"),
                Wrong(["a", "d", "e"], "they never meet"),
                Wrong(["a", "c", "f"], "the ram passes axis 3"),
                Wrong(["a", "c"], "neither meets nor is parallel"),
                Wrong(["a", "e"], "shoulder and elbow"),
            ),
        ),
        Task(
            name="distance",
            title="Step 3: a segment between two axes",
            text="Axis $i$ is the $z$ axis. Axis $i+1$ goes through $[a, 0, 0]^T$ with the direction $[0, -\\sin\\alpha, \\cos\\alpha]^T$. Write the"
            " **square** of the distance between the point at $s$ on the first and the point at $t$ on the second, in `s`, `t`, `a`, `alpha`.",
            asks=Formula(DISTANCE, ("s", "t", "a", "alpha"), unit="m²"),
            hints=(
                "The first point is $[0, 0, s]^T$. What is the second?",
                "The second is $[a, -t\\sin\\alpha, t\\cos\\alpha]^T$. Take the difference, and add the squares of its entries.",
                "$a^2 + t^2\\sin^2\\alpha + (s - t\\cos\\alpha)^2$; the squares of sine and cosine add up to one.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "From the point at $s$ on the first axis to the point at $t$ on the second.",
                        r"\begin{bmatrix} a \\ 0 \\ 0 \end{bmatrix} + t \begin{bmatrix} 0 \\ -S\alpha \\ C\alpha \end{bmatrix} - \begin{bmatrix} 0 \\ 0 \\ s \end{bmatrix} = \begin{bmatrix} a \\ -t S\alpha \\ t C\alpha - s \end{bmatrix}",
                    ),
                    Line(
                        "Its square is the sum of the three squares.",
                        r"\begin{bmatrix} a & -t S\alpha & t C\alpha - s \end{bmatrix} \begin{bmatrix} a \\ -t S\alpha \\ t C\alpha - s \end{bmatrix} = a^2 + t^2 \sin^2\alpha + (t C\alpha - s)^2",
                    ),
                    Line(
                        "Multiplied out, sine and cosine of $\\alpha$ join.",
                        r"a^2 + t^2 \sin^2\alpha + (t C\alpha - s)^2 = a^2 + s^2 + t^2 - 2 s t \cos\alpha",
                    ),
                ),
                {"symbols": {"s": "free", "t": "free", "a": "free", "alpha": "free"}},
            ),
            right=(distance, DISTANCE, WithSympy(_distance_sympy)),
            wrong=(
                Wrong(
                    r"a^2 + s^2 + t^2", "the term in s t is missing: the two points move against each other", own=True
                ),
                Wrong(r"a^2 + s^2 + t^2 + 2 s t \cos\alpha", "sign"),
                Wrong(
                    r"\sqrt{a^2 + s^2 + t^2 - 2 s t \cos\alpha}",
                    "this is the distance itself; its square is asked, which is a polynomial in s and t",
                    own=True,
                ),
                Wrong(r"a^2 + (s - t)^2", "the directions are taken as parallel: α is missing", own=True),
                Wrong(
                    r"s^2 + t^2 - 2 s t \cos\alpha",
                    "a is missing: the axes do not meet, the second one is a away",
                    own=True,
                ),
                Wrong(r"a^2 + s^2 + t^2 - 2 s t \sin\alpha", "sine"),
            ),
        ),
        Task(
            name="normal",
            title="Step 3: the origin on the common normal",
            text="Axis 1 is the $z$ axis. Axis 2 goes through the point $[0.3, 0.4, 1]^T$ and is parallel to $y$. Give $O_1$ of the modified"
            " convention, and the length $a_1$ of the common normal: four numbers $[x, y, z, a_1]$, in metres.",
            asks=Number(
                (0, 0, 1, 0.3),
                unit="m",
                labels=("x", "y", "z", "a_1"),
                beside=(
                    "p = [0.3, 0.4, 1,]",
                    r"[, , , \sqrt{(0.3^2 + 0.4^2)}]",
                    r"[, , , \sqrt{(0.3^2 + 1^2)}]",
                    r"[, , , \sqrt{(0.4^2 + 1^2)}]",
                    r"[, , , \sqrt{(0.3^2 + 0.4^2 + 1^2)}]",
                    "[, , , 0.3^2 + 0.4^2]",
                    r"[, , , 0.3 \cdot 0.4]",
                    "[, , , 0.3 + 0.4]",
                    "[, , , 0.3 + 0.4 + 1]",
                    "[, , , (0.3 + 0.4)/2]",
                    "[0.3/2, 0.4/2, 1/2, 0.3/2]",
                ),
            ),
            hints=(
                "The common normal is at right angles to both axes. Along which direction does it lie?",
                "It lies along $x$, the only direction across $z$ and $y$. At which height does it touch axis 2?",
                "All of axis 2 is at the height 1 and at $x = 0.3$. $O_1$ lies on axis 1.",
            ),
            right=([0, 0, 1, 0.3], "0, 0, 1, 0.3", np.array([0, 0, 1, 0.3])),
            wrong=(
                Wrong(
                    [0.3, 0, 1, 0.3],
                    "this is the other end of the normal: in the modified convention O_1 lies on axis 1",
                    own=True,
                ),
                Wrong(
                    [0, 0, 0, 0.3],
                    "the normal leaves axis 1 at the height of axis 2, not at the base",
                    own=True,
                ),
                Wrong(
                    [0, 0, 1, 0.5],
                    "0.5 is the distance to the point that happens to be given; the least distance to the axis is 0.3",
                    own=True,
                ),
                Wrong([0.3, 0.4, 1, 0.3], "this is the point that happens to be given: O_1 lies on axis 1", own=True),
                Wrong([0.15, 0, 1, 0.3], "an origin lies on an axis, not in the middle of the normal", own=True),
                Wrong([0.3, 0.4, 1, 0.5], "the given point need not be the nearest one: slide along axis 2", own=True),
                Wrong([0, 0.4, 1, 0.3], "0.4 is the y of the given point: O_1 lies on axis 1, where y is 0", own=True),
                Wrong(
                    [0, 0, 1, 0.4],
                    "0.4 is how far along axis 2 the given point lies: across, the axes are 0.3 apart",
                    own=True,
                ),
                Wrong([0, 0, 1, 0], "the axes do not meet: axis 2 passes beside axis 1, 0.3 away", own=True),
                Wrong(
                    [0, 0, 1, 1],
                    "1 is the height of the normal: its length is the least distance of the axes",
                    own=True,
                ),
            ),
        ),
        Task(
            name="freedom",
            title="Step 3: parallel axes leave a choice",
            text="Axes 2 and 3 are parallel, and $O_2$ is moved by $u$ along $z_2$ (so does frame 2 with it). Write both offsets after that, as"
            " two rows, the new $d_2$ and the new $d_3$, in `d_2`, `d_3`, `u`.",
            asks=Formula(FREEDOM, ("d_2", "d_3", "u"), unit="m"),
            hints=(
                "$d_2$ is measured along $z_2$ **to** frame 2. What does it do when the frame moves by $u$?",
                "$d_3$ is measured from $x_2$, along the parallel $z_3$. Frame 3 stays where it is.",
                "One grows by $u$, the other shrinks by $u$: their sum stays, and one of them can be made zero.",
            ),
            right=(freedom, FREEDOM, WithSympy(_freedom_sympy)),
            wrong=(
                Wrong(
                    lambda d_2, d_3, u: [d_2 + u, d_3 + u],
                    "both grow: but frame 3 stays, so their sum must stay too",
                    own=True,
                ),
                Wrong(
                    lambda d_2, d_3, u: [d_2 - u, d_3 + u],
                    "the signs are exchanged: frame 2 moves forward along z_2, so d_2 grows",
                    own=True,
                ),
                Wrong(
                    lambda d_2, d_3, u: [d_2 + u, d_3],
                    "only d_2 has changed: d_3 is measured from frame 2, which has moved",
                    own=True,
                ),
                Wrong(
                    lambda d_2, d_3, u: [d_2, d_3 - u],
                    "only d_3 has changed: d_2 leads to frame 2, which has moved",
                    own=True,
                ),
                Wrong(
                    lambda d_2, d_3, u: [0, d_2 + d_3],
                    "that is one choice of u, the usual one, u = −d_2; here u is any length",
                    own=True,
                ),
            ),
        ),
        Task(
            name="slide_freedom",
            title="Step 3: a slide leaves a choice",
            text="Joint 4 is a slide. What of its axis may you choose, without any change of the motion? `place`: on which of the parallel lines"
            " $z_4$ lies; `direction`: the direction of $z_4$; `twist`: the angle $\\alpha_3$; `variable`: which parameter is the variable.",
            asks=Choice(
                {
                    "place": "the line, among parallel ones",
                    "direction": "the direction",
                    "twist": "the twist",
                    "variable": "the variable",
                },
                right="place",
                because={
                    "direction": "the slide moves along its axis: another direction is another motion",
                    "twist": "the twist is the angle from z_3 to z_4: it is given with the two directions",
                    "variable": "the twist and the angle of a slide are constant: its variable is d_4",
                },
            ),
            hints=(
                "What does a point do when the slide extends? Does it matter through which point the axis goes?",
                "All points of a sliding body move by the same vector.",
                "Only the direction of that vector is given by the joint.",
            ),
            right=("place", ["place"], {"place"}),
            wrong=(
                Wrong("direction", "another direction is another motion"),
                Wrong("twist", "given with the two directions"),
                Wrong("variable", "its variable is d_4"),
                Wrong(["place", "direction"], "one of them is asked for"),
            ),
        ),
        Task(
            name="first_x",
            title="Step 4: intersecting axes",
            text="$z_1 = [0, 0, 1]^T$ and $z_2 = [S_1, -C_1, 0]^T$ in frame 0. Write $x_1 = z_1 \\times z_2$ (3 rows). A function takes the joint"
            " vector `q`.",
            asks=Quantity(RIG, {"axis": 1, "along": "x"}),
            hints=(
                "At right angles to both axes: a cross product.",
                "$[0, 0, 1]^T \\times [x, y, 0]^T = [-y, x, 0]^T$.",
                "Row 1 is $-(-C_1)$. The other sense, $z_2 \\times z_1$, would be allowed as well; the table would have $-\\alpha_1$ then.",
            ),
            right=(first_x, FIRST_X, WithSympy(lambda sp: _axes_sympy(sp)[0])),
            wrong=(
                Wrong(
                    lambda q: -first_x(q),
                    "this is z_2 × z_1: a free choice for intersecting axes, but the drawing has x_1 = z_1 × z_2",
                    own=True,
                ),
                Wrong(
                    lambda q: np.array([np.sin(q[0]), -np.cos(q[0]), 0]),
                    "this is z_2 itself: x_1 is at right angles to it",
                    own=True,
                ),
                Wrong(lambda q: np.array([1, 0, 0]), "this is x_0: frame 1 turns with joint 1", own=True),
                Wrong(
                    lambda q: np.array([np.cos(q[0]), -np.sin(q[0]), 0]),
                    "the turn goes the wrong way: row 2 of the cross product is x, which is S_1",
                    own=True,
                ),
                Wrong(lambda q: first_x(np.deg2rad(q)), "degrees"),
            ),
        ),
        Task(
            name="second_x",
            title="Step 4: along the normal",
            text="Axes 2 and 3 are parallel; $x_2$ points along their common normal, from $O_2$ to $O_3$. Write it in frame 0 (3 rows), in"
            " $\\theta_1$ and $\\theta_2$.",
            asks=Quantity(RIG, {"axis": 2, "along": "x"}),
            hints=(
                "The normal is the boom. $\\theta_2$ is its elevation.",
                "Seen from the side: $C_2$ outwards, $S_2$ up.",
                "Outwards is $[C_1, S_1, 0]^T$.",
            ),
            right=(second_x, SECOND_X, WithSympy(lambda sp: _axes_sympy(sp)[1])),
            wrong=(
                Wrong(FIRST_X, "this is x_1: the boom is raised by θ_2", own=True),
                Wrong(
                    SECOND_X.replace(r"\\ S_2", r"\\ -S_2"),
                    "the boom goes down with positive θ_2: z_2 is −y_1 at θ_1 = 0, so x turns towards z",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_1 S_2 \\ S_1 S_2 \\ C_2 \end{bmatrix}",
                    "θ_2 is counted from the vertical: at θ_2 = 0 the boom is horizontal",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} C_{12} \\ S_{12} \\ 0 \end{bmatrix}",
                    "the two angles do not add up: their axes are at right angles",
                    own=True,
                ),
                Wrong(lambda q: -second_x(q), "sign"),
            ),
        ),
        Task(
            name="second_y",
            title="Step 5: the third axis",
            text="Complete frame 2: write $y_2 = z_2 \\times x_2$ in frame 0 (3 rows), in $\\theta_1$ and $\\theta_2$.",
            asks=Quantity(RIG, {"axis": 2, "along": "y"}),
            hints=(
                "$z_2 = [S_1, -C_1, 0]^T$, and you have $x_2$. Mind the order of the product.",
                "Third row of $v \\times w$: $v_1 w_2 - v_2 w_1$.",
                "The third row is $S_1 S_1 C_2 + C_1 C_1 C_2 = C_2$.",
            ),
            right=(second_y, SECOND_Y, WithSympy(lambda sp: _axes_sympy(sp)[2])),
            wrong=(
                Wrong(lambda q: -second_y(q), "this is x_2 × z_2: the order makes the sign", own=True),
                Wrong(SECOND_X, "this is x_2", own=True),
                Wrong(
                    r"\begin{bmatrix} -S_1 \\ C_1 \\ 0 \end{bmatrix}",
                    "this is y_1: frame 2 leans with the boom",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix}",
                    "this is z_2: y_2 is at right angles to it",
                    own=True,
                ),
                Wrong(r"\begin{bmatrix} -C_1 S_2 \\ -S_1 S_2 \\ -C_2 \end{bmatrix}", "sign"),
            ),
        ),
        Task(
            name="base",
            title="Step 6: the frame of the base",
            text="Frame 0 is put on frame 1 at $q_1 = 0$, and joint 1 is revolute. Which parameters of row 1 are zero then, always? Keys:"
            " `alpha_0`, `a_0`, `d_1`, `theta_1`. Give a list.",
            asks=Choice(
                {"alpha_0": "α_0", "a_0": "a_0", "d_1": "d_1", "theta_1": "θ_1"},
                right=frozenset({"alpha_0", "a_0", "d_1"}),
                because={"theta_1": "θ_1 is the variable: it is zero at one configuration only"},
                missing={
                    "alpha_0": "the two z axes are one line: what is the angle between them?",
                    "a_0": "the two z axes are one line: what is their distance?",
                    "d_1": "the two origins are one point, and a turn leaves it in place",
                },
            ),
            hints=(
                "Both frames are one at $q_1 = 0$. What does joint 1 change?",
                "It turns frame 1 about $z_1 = z_0$: neither the axis nor the origin moves.",
                "Three of the four are zero; the fourth is the variable.",
            ),
            right=(["alpha_0", "a_0", "d_1"], "alpha_0, a_0, d_1", {"d_1", "a_0", "alpha_0"}),
            wrong=(
                Wrong(["alpha_0", "a_0", "d_1", "theta_1"], "is the variable"),
                Wrong(["alpha_0", "a_0"], "the two origins are one point"),
                Wrong(["d_1", "a_0"], "the angle between them"),
                Wrong(["alpha_0", "d_1"], "their distance"),
            ),
        ),
        Task(
            name="last",
            title="Step 7: the last frame",
            text="Joint 4 is a slide. How is $x_4$ chosen, and what is gained? `a`: along $x_3$, so that $\\theta_4 = 0$; `b`: along $z_3$, so that"
            " $\\alpha_3 = 0$; `c`: along the ram, so that $d_4 = 0$; `d`: along $x_0$, so that the tool is level. Write the letter.",
            asks=Choice(
                {"a": "along x_3", "b": "along z_3", "c": "along the ram", "d": "along x_0"},
                right="a",
                because={
                    "b": "the twist lies between z_3 and z_4: no choice of x_4 changes it",
                    "c": "z_4 lies along the ram: x_4 is at right angles to it, and d_4 is the variable",
                    "d": "frame 4 moves with the ram: it cannot keep a direction of the base",
                },
            ),
            hints=(
                "Behind the last joint there is no further axis, so no common normal: $x_n$ is free. What is the simplest choice?",
                "$\\theta_4$ is the angle from $x_3$ to $x_4$ about $z_4$.",
                "A slide does not turn: let both point the same way.",
            ),
            right=("a", ["a"], {"a"}),
            wrong=(
                Wrong("b", "no choice of x_4 changes it"),
                Wrong("c", "at right angles to it"),
                Wrong("d", "moves with the ram"),
                Wrong(["a", "c"], "one of them is asked for"),
            ),
        ),
        Task(
            name="types",
            title="The types of the joints",
            text="$\\sigma_i$ is 0 for a revolute joint and 1 for a prismatic one. Give $[\\sigma_1, \\sigma_2, \\sigma_3, \\sigma_4]$.",
            asks=Number((0, 0, 0, 1), labels=("σ_1", "σ_2", "σ_3", "σ_4")),
            hints=(
                "Which of the four motions is no turn?",
                "Three turn, and the ram slides.",
                "Where $\\sigma_i = 0$, $\\theta_i$ varies and $d_i$ is fixed; where $\\sigma_i = 1$ it is the other way round.",
            ),
            right=([0, 0, 0, 1], "0, 0, 0, 1", np.array([0, 0, 0, 1])),
            wrong=(
                Wrong([1, 1, 1, 0], "0 and 1 are exchanged: σ counts slides", own=True),
                Wrong([0, 0, 0, 0], "the ram is taken as a joint that turns: it slides", own=True),
                Wrong([0, 0, 1, 1], "joint 3 is the elbow, and it turns", own=True),
                Wrong([0, 0, 1], "4 numbers"),
                Wrong([1, 0, 0, 1], "the column turns: joint 1 is revolute", own=True),
                Wrong([0, 1, 0, 1], "joint 2 is the shoulder, and it turns", own=True),
            ),
        ),
        Task(
            name="variable",
            title="One formula for both types",
            text="Write $q_i$ in `sigma`, `theta`, `d` (of joint $i$; indices are left out), so that it is $\\theta$ for $\\sigma = 0$ and $d$ for $\\sigma = 1$:"
            " one formula, linear in $\\sigma$. A function takes `(sigma, theta, d)`.",
            asks=Formula(VARIABLE, ("sigma", "theta", "d")),
            hints=(
                "Which factor is 1 for $\\sigma = 0$ and 0 for $\\sigma = 1$?",
                "$1 - \\sigma$ switches $\\theta$ on and off.",
                "$(1 - \\sigma)\\theta$, and a second term that is there for $\\sigma = 1$ only.",
            ),
            right=(variable, VARIABLE, WithSympy(_variable_sympy)),
            wrong=(
                Wrong(
                    r"\sigma\theta + (1 - \sigma) d",
                    "the switches are exchanged: σ = 0 is a revolute joint, whose variable is θ",
                    own=True,
                ),
                Wrong(r"(1 - \sigma)\theta - \sigma d", "sign"),
                Wrong(r"\theta + d", "this holds both at once: put σ = 0 and see", own=True),
                Wrong(r"\theta + \sigma d", "θ stays for σ = 1: it must be switched off", own=True),
                Wrong(r"(1 - \sigma)\theta", "for σ = 1 nothing is left: the offset d is missing", own=True),
            ),
        ),
        Task(
            name="table",
            title="Step 8: the table",
            text="Fill in the table of the rig: four rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$ with `theta_1`, `theta_2`, `theta_3`, `d_4`, `a_2`,"
            ' `e`; angles in radians, as in `"pi/2"`.',
            asks=Table(RIG, "modified"),
            hints=(
                "Row by row: twist and length belong to the link before, offset and angle to the joint itself.",
                "Crossing axes have $a = 0$, parallel axes $\\alpha = 0$; skew axes have both.",
                "Turn $z_1$ into $z_2$ about $x_1$: from $[0, 0, 1]$ to $[0, -1, 0]$ at $\\theta_1 = 0$ is $+\\pi/2$.",
            ),
            right=(
                ROWS,
                [dict(zip(("alpha", "a", "d", "theta"), row, strict=True)) for row in ROWS],
                r"\begin{array}{cccc} 0 & 0 & 0 & \theta_1 \\ \frac{\pi}{2} & 0 & 0 & \theta_2 \\ 0 & a_2 & 0 & \theta_3 \\ \frac{\pi}{2} & e & d_4 & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [
                        ("pi/2", 0, 0, "theta_1"),
                        (0, "a_2", 0, "theta_2"),
                        ("pi/2", "e", 0, "theta_3"),
                        (0, 0, "d_4", 0),
                    ],
                    "lengths and twists stand one row too early: this is the classic order; a row holds those of the link before",
                    own=True,
                ),
                Wrong(_changed(2, "-pi/2", 0, 0, "theta_2"), "row 2: alpha is wrong"),
                Wrong(
                    _changed(4, "pi/2", "e", 0, "d_4"),
                    "the variable of the slide stands in the column of the angles: it is an offset",
                    own=True,
                ),
                Wrong(
                    _changed(4, "pi/2", "d_4", "e", 0),
                    "in row 4 a and d are exchanged: e is the distance of the axes, d_4 runs along the ram",
                    own=True,
                ),
                Wrong(_changed(3, 0, 0, "a_2", "theta_3"), "row 3", own=False),
                Wrong(ROWS[:3], "4 rows"),
            ),
        ),
        Task(
            name="tool",
            title="The test: where is the tool?",
            text="A table is worth what its product says. Write the origin of frame 4 in frame 0 (3 rows, m). A function may be"
            " `def tool(q, a_2, e)` with `q` = $[\\theta_1, \\theta_2, \\theta_3, d_4]$.",
            asks=Quantity(RIG, {"origin": 4}),
            hints=(
                "Look at the rig from the side first, with $\\theta_1 = 0$: how far out and how high?",
                "The boom: $a_2$ along $[C_2, S_2]$. The distance $e$: along $[C_{23}, S_{23}]$. The ram: at right angles to it, downwards.",
                "Outwards $a_2 C_2 + e C_{23} + d_4 S_{23}$, up $a_2 S_2 + e S_{23} - d_4 C_{23}$; then turn by $\\theta_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Rows 1 and 2: the boom turns about $z_2$.",
                        r"{}^0T_2 = \begin{bmatrix} C_1 C_2 & -C_1 S_2 & S_1 & 0 \\ S_1 C_2 & -S_1 S_2 & -C_1 & 0 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 3 goes $a_2$ along the boom, and its angle adds up with the one before.",
                        r"{}^0T_3 = \begin{bmatrix} C_1 C_{23} & -C_1 S_{23} & S_1 & a_2 C_1 C_2 \\ S_1 C_{23} & -S_1 S_{23} & -C_1 & a_2 S_1 C_2 \\ S_{23} & C_{23} & 0 & a_2 S_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Row 4 goes $e$ along $x_3$ and $d_4$ along $z_4$, which is $-y_3$.",
                        r"{}^3T_4 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} e \\ -d_4 \\ 0 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Put it into frame 0.",
                        r"p_4 = \begin{bmatrix} (a_2 C_2 + e C_{23} + d_4 S_{23}) C_1 \\ (a_2 C_2 + e C_{23} + d_4 S_{23}) S_1 \\ a_2 S_2 + e S_{23} - d_4 C_{23} \end{bmatrix}",
                    ),
                ),
                {"arm": RIG},
            ),
            right=(tool, TOOL, WithSympy(_tool_sympy)),
            wrong=(
                Wrong(
                    lambda q, a_2, e: tool([q[0], q[1], q[2] - q[1], q[3]], a_2, e),
                    "θ_3 is taken from the horizontal: the elbow is carried by the boom, so C_23 and S_23",
                    own=True,
                ),
                Wrong(lambda q, a_2, e: tool(q, a_2, 0), "the distance e between elbow and ram is missing", own=True),
                Wrong(
                    lambda q, a_2, e: tool([*q[:3], -q[3]], a_2, e),
                    "the ram goes up: at θ_2 = θ_3 = 0 it points down",
                    own=True,
                ),
                Wrong(
                    lambda q, a_2, e: tool([q[0], q[1], q[2] + np.pi / 2, q[3]], a_2, e),
                    "the ram is taken in line with the boom: it stands across it at θ_3 = 0",
                    own=True,
                ),
                Wrong(lambda q, a_2, e: tool(q, e, a_2), "swapped"),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A stacker: a carriage slides along the vertical $z_1$ by $d_1$; on it a boom of length $c$ pitches by $\\theta_2$ about a horizontal axis that"
            " meets the mast, $z_2 = -y_1$; at its end a fork pitches by $\\theta_3$ about the parallel axis $z_3$. $x_1$ is horizontal, $x_2$ lies along the"
            " boom, and at zero all $x$ axes are parallel. Write the modified table, three rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$.",
            asks=Table(STACKER, "modified"),
            hints=(
                "Joint 1 slides: which of its four parameters is the variable?",
                "Axes 1 and 2 intersect: no length there. About $x_1$, which turn takes $z_1$, up, to $-y_1$?",
                "Axes 2 and 3 are parallel, $c$ apart: a length without a twist, in the row of joint 3.",
            ),
            right=(
                STACKER_ROWS,
                STACKER["rows"],
                r"\begin{array}{cccc} 0 & 0 & d_1 & 0 \\ \pi/2 & 0 & 0 & \theta_2 \\ 0 & c & 0 & \theta_3 \end{array}",
            ),
            wrong=(
                Wrong(
                    [STACKER_ROWS[0], ("-pi/2", 0, 0, "theta_2"), STACKER_ROWS[2]], "row 2: alpha is wrong (the sign)"
                ),
                Wrong(
                    [STACKER_ROWS[0], ("pi/2", "c", 0, "theta_2"), (0, 0, 0, "theta_3")],
                    "c stands one row too early: it lies between axes 2 and 3, and row 3 holds the length of link 2",
                    own=True,
                ),
                Wrong(
                    [(0, 0, 0, "d_1"), *STACKER_ROWS[1:]],
                    "joint 1 slides: its variable is an offset, in the column of d",
                    own=True,
                ),
                Wrong([*STACKER_ROWS[:2], (0, 0, "c", "theta_3")], "row 3: a and d are exchanged"),
                Wrong(
                    [*STACKER_ROWS[:2], (0, "c", 0, "theta_2 + theta_3")],
                    "each joint has its own angle: θ_3 is counted from the boom",
                    own=True,
                ),
            ),
        ),
    ),
)
