"""Tasks of lesson 1, frames and homogeneous transforms (after MECA 953 Robotique, MMT5, 2022, document 001)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Quantity, Task, WithSympy, Wrong
from armproof.course.links import shift, turn

# -- a rotation about y ------------------------------------------------------------------------------------------------


def rotation_y(beta):
    """Return Rot_y(β): z turns towards x, so the sine below the diagonal is the negative one."""
    c, s = np.cos(beta), np.sin(beta)
    return np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1]])


ROTATION_Y = r"""\begin{bmatrix} \cos\beta & 0 & \sin\beta & 0 \\ 0 & 1 & 0 & 0 \\ -\sin\beta & 0 & \cos\beta & 0 \\
0 & 0 & 0 & 1 \end{bmatrix}"""


def _rotation_y_sympy(sp):
    return turn(sp, "y", sp.Symbol("beta"))


def _rotation_about_x(beta):
    c, s = np.cos(beta), np.sin(beta)
    return np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def _rotation_about_z(beta):
    c, s = np.cos(beta), np.sin(beta)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


# -- a composition -----------------------------------------------------------------------------------------------------


def composed(theta, d, a):
    """Return Rot_z(θ) Trans_z(d) Trans_x(a): each step stands to the right of the one before it."""
    c, s = np.cos(theta), np.sin(theta)
    turn = np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    rise = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    move = np.array([[1, 0, 0, a], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    return turn @ rise @ move


COMPOSED = r"""\begin{bmatrix} C\theta & -S\theta & 0 & a\,C\theta \\ S\theta & C\theta & 0 & a\,S\theta \\ 0 & 0 & 1 & d \\
0 & 0 & 0 & 1 \end{bmatrix}"""


def _composed_sympy(sp):
    theta, d, a = sp.symbols("theta d a")
    return turn(sp, "z", theta) * shift(sp, x=a, z=d)


# -- the inverse -------------------------------------------------------------------------------------------------------


def inverse(theta, x, y, z):
    """Return [Rᵀ, −Rᵀp; 0, 1]."""
    c, s = np.cos(theta), np.sin(theta)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    p = np.array([x, y, z])
    return np.vstack([np.column_stack([R.T, -R.T @ p]), [0, 0, 0, 1]])


INVERSE = r"""\begin{bmatrix} \cos\theta & \sin\theta & 0 & -x\cos\theta - y\sin\theta \\
-\sin\theta & \cos\theta & 0 & x\sin\theta - y\cos\theta \\ 0 & 0 & 1 & -z \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _inverse_sympy(sp):
    theta, x, y, z = sp.symbols("theta x y z")
    return (shift(sp, x, y, z) * turn(sp, "z", theta)).inv()


def _inverse_with(rotation, displacement):
    """Return a matrix of blocks made from R and p, to try what students put there."""

    def answer(theta, x, y, z):
        c, s = np.cos(theta), np.sin(theta)
        R, p = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), np.array([x, y, z])
        return np.vstack([np.column_stack([rotation(R), displacement(R, p)]), [0, 0, 0, 1]])

    return answer


def _transposed(theta, x, y, z):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, s, 0, 0], [-s, c, 0, 0], [0, 0, 1, 0], [x, y, z, 1]])


# -- the planar 2R arm -------------------------------------------------------------------------------------------------


def pose(q, l_1, l_2):
    """Return the pose of frame 2 in frame 0 as a product of two links, each a turn and a move along the new x."""

    def link(theta, length):
        c, s = np.cos(theta), np.sin(theta)
        return np.array([[c, -s, 0, length * c], [s, c, 0, length * s], [0, 0, 1, 0], [0, 0, 0, 1]])

    return link(q[0], l_1) @ link(q[1], l_2)


POSE = r"""\begin{bmatrix} C_{12} & -S_{12} & 0 & l_1 C_1 + l_2 C_{12} \\ S_{12} & C_{12} & 0 & l_1 S_1 + l_2 S_{12} \\
0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _pose_sympy(sp):
    t1, t2, l1, l2 = sp.symbols("theta_1 theta_2 l_1 l_2")
    x, y = l1 * sp.cos(t1) + l2 * sp.cos(t1 + t2), l1 * sp.sin(t1) + l2 * sp.sin(t1 + t2)
    return shift(sp, x, y) * turn(sp, "z", t1 + t2)


def _moves_first(q, l_1, l_2):
    """Return the product of links that move along x before they turn."""

    def link(theta, length):
        c, s = np.cos(theta), np.sin(theta)
        return np.array([[c, -s, 0, length], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])

    return link(q[0], l_1) @ link(q[1], l_2)


def point(theta_1, theta_2, l_1, l_2, h):
    """Return R p_2P + p_2: P stands h along y_2."""
    t12 = theta_1 + theta_2
    x = l_1 * np.cos(theta_1) + l_2 * np.cos(t12) - h * np.sin(t12)
    y = l_1 * np.sin(theta_1) + l_2 * np.sin(t12) + h * np.cos(t12)
    return np.array([x, y, 0])


POINT = r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} - h S_{12} \\ l_1 S_1 + l_2 S_{12} + h C_{12} \\ 0 \end{bmatrix}"


def _point_sympy(sp):
    return (_pose_sympy(sp) * sp.Matrix([0, sp.Symbol("h"), 0, 1]))[:3, 0]


# -- an arm that nobody has seen -----------------------------------------------------------------------------------------


def carriage(d, theta, b):
    """Return the pose of the end of a bar that turns on a carriage: a shift by d, a turn, a shift by b."""
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, d + b * c], [s, c, 0, b * s], [0, 0, 1, 0], [0, 0, 0, 1]])


CARRIAGE = r"""\begin{bmatrix} \cos\theta & -\sin\theta & 0 & d + b \cos\theta \\ \sin\theta & \cos\theta & 0 & b \sin\theta \\
0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _carriage_sympy(sp):
    d, theta, b = sp.symbols("d theta b")
    return shift(sp, x=d) * turn(sp, "z", theta) * shift(sp, x=b)


LESSON = Lesson(
    number=1,
    name="frames",
    title="Frames and homogeneous transforms",
    source="MECA 953 Robotique, MMT5, 2022 (document 001)",
    objectives=(
        "Write the elementary rotations and translations as 4×4 matrices, and chain them in the right order.",
        "Invert a transform without inverting a matrix.",
        "Read a pose in Drake, and move a point from one frame to another with it.",
    ),
    tasks=(
        Task(
            name="predict",
            title="Prediction: turn, then move",
            text="Frame $B$ starts on frame $A$. It turns by $90°$ about $z$, then moves 2 m along its **new** $x$ axis. Where is the"
            " origin of $B$? Give its three coordinates in frame $A$, in metres, as a list `[x, y, z]`.",
            asks=Number(
                (0, 2, 0),
                unit="m",
                labels=("x", "y", "z"),
                steps=(r"\theta = 90^\circ", r"2 \cos\theta", r"2 \sin\theta", "0"),
                beside=(
                    "2 x_A + 2 x_B = [2, 2, 0]",
                    "x_B = [0, 1, 0]",
                    r"[x, y, \theta] = [0, 2, 90]",
                    r"[x, y, \theta] = [0, 2, \pi/2]",
                    "[x, y, 1] = [0, 2, 1]",
                    r"2 \cdot \pi/2",
                ),
            ),
            hints=(
                "Take a pen as the x axis and turn it on the table.",
                "After the turn, in which direction of $A$ does the new $x$ axis point?",
                "A quarter turn about $z$ takes $x$ to the old $y$. The move is 2 m in that direction.",
            ),
            right=([0, 2, 0], "0, 2, 0", np.array([0.0, 2.0, 0.0])),
            wrong=(
                Wrong(
                    [2, 0, 0],
                    "this is a move along the old x axis: B moves along its own x, which has turned",
                    own=True,
                ),
                Wrong(
                    [0, -2, 0],
                    "this is a turn the other way: by the right-hand rule, a positive angle about z takes x to +y",
                    own=True,
                ),
                Wrong([-2, 0, 0], "x is not -2, y is not 0"),
                Wrong([0, 0, 2], "a turn about z leaves x and y in their plane: nothing moves along z", own=True),
                Wrong([0, 2], "3 numbers"),
            ),
        ),
        Task(
            name="rotation_y",
            title="The rotation about y",
            text="Write $\\mathbf{Rot}_y(\\beta)$ as a 4×4 matrix: a turn by `beta` (rad) about $y$. The slides give only $x$ and $z$.",
            asks=Formula(ROTATION_Y, ("beta",)),
            hints=(
                "The columns are the turned axes, in coordinates of the frame before. Which of them stays as it is?",
                "Turn by a small positive angle about $y$: $z$ leans towards $x$, and $x$ towards $-z$.",
                "The first column is $[\\cos\\beta, 0, -\\sin\\beta, 0]^T$.",
            ),
            right=(
                rotation_y,
                ROTATION_Y,
                WithSympy(_rotation_y_sympy),
            ),
            wrong=(
                Wrong(
                    lambda beta: rotation_y(-beta),
                    "the signs of the sines are those of Rot_x and Rot_z: about y, z turns towards x",
                    own=True,
                ),
                Wrong(
                    _rotation_about_x,
                    "this turns about x: about y, the second row and the second column stay those of the identity",
                    own=True,
                ),
                Wrong(
                    _rotation_about_z,
                    "this turns about z: about y, the second row and the second column stay those of the identity",
                    own=True,
                ),
                Wrong(
                    lambda beta: rotation_y(beta)[:3, :3],
                    "this is the 3×3 rotation: a homogeneous transform has a fourth column and the row 0 0 0 1",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} \sin\beta & 0 & \cos\beta & 0 \\ 0 & 1 & 0 & 0 \\ -\cos\beta & 0 & \sin\beta & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    "sine and cosine are exchanged: for β = 0 the matrix must be the identity",
                    own=True,
                ),
            ),
        ),
        Task(
            name="compose",
            title="A composition",
            text="Frame $B$ starts on frame $A$, turns by $\\theta$ about $z$, then moves $d$ along $z$, then $a$ along its own $x$. Write"
            " the pose ${}^AT_B$ as a 4×4 matrix in `theta`, `d`, `a` (a function takes them in this order).",
            asks=Formula(COMPOSED, ("theta", "d", "a")),
            hints=(
                "Each step is made in the frame that the steps before have reached.",
                "A step in the current frame is multiplied on the right: $\\mathbf{Rot}_z(\\theta)\\,\\mathbf{Trans}_z(d)\\,\\mathbf{Trans}_x(a)$.",
                "Last column: $[a\\cos\\theta, a\\sin\\theta, d, 1]^T$; it is where the origin of $B$ ends up.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Turn about $z$ and move along it: both steps keep to one axis.",
                        r"\mathrm{Rot}_z(\theta)\,\mathrm{Trans}_z(d) = \begin{bmatrix} \cos\theta & -\sin\theta & 0 & 0 \\ \sin\theta & \cos\theta & 0 & 0 \\ 0 & 0 & 1 & d \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Then move by $a$ along the new $x$: the first column, times $a$, is added to the last.",
                        r"\mathrm{Rot}_z(\theta)\,\mathrm{Trans}_z(d)\,\mathrm{Trans}_x(a) = \begin{bmatrix} \cos\theta & -\sin\theta & 0 & a\cos\theta \\ \sin\theta & \cos\theta & 0 & a\sin\theta \\ 0 & 0 & 1 & d \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"symbols": {"theta": "free", "d": "free", "a": "free"}},
            ),
            right=(composed, COMPOSED, WithSympy(_composed_sympy)),
            wrong=(
                Wrong(
                    COMPOSED.replace(r"a\,C\theta", "a").replace(r"a\,S\theta", "0"),
                    "the factors stand in the reverse order: this moves first, along the old x, and turns then",
                    own=True,
                ),
                Wrong(
                    COMPOSED.replace(r"a\,C\theta", r"a\,S\theta ").replace(r"& a\,S\theta \\ 0", r"& a\,C\theta \\ 0"),
                    "entries (1, 4) and (2, 4) are swapped",
                ),
                Wrong(lambda theta, d, a: composed(theta, d, a).T, "transposed"),
                Wrong(COMPOSED.replace("& d ", "& 0 "), "the factor with d is missing"),
                Wrong(lambda theta, d, a: composed(theta, a, d), "swapped"),
                Wrong(
                    lambda theta, d, a: composed(-theta, d, a),
                    "the turn is the wrong way round: Rot_z has its minus sign in the first row",
                    own=True,
                ),
            ),
        ),
        Task(
            name="order",
            title="What may change places",
            text="Which of these pairs give the same product in both orders, for all values? `a`: $\\mathbf{Rot}_x(\\alpha)$ and"
            " $\\mathbf{Trans}_x(a)$; `b`: $\\mathbf{Rot}_z(\\theta)$ and $\\mathbf{Trans}_x(a)$; `c`: $\\mathbf{Rot}_x(\\alpha)$ and"
            " $\\mathbf{Rot}_z(\\theta)$; `d`: $\\mathbf{Trans}_x(a)$ and $\\mathbf{Trans}_z(d)$. Give a list of letters.",
            asks=Choice(
                {
                    "a": "Rot_x and Trans_x",
                    "b": "Rot_z and Trans_x",
                    "c": "Rot_x and Rot_z",
                    "d": "Trans_x and Trans_z",
                },
                right=frozenset({"a", "d"}),
                because={
                    "b": "a turn about z changes the direction of x: compare your prediction with a move along the old x",
                    "c": "rotations about different axes do not commute: try two quarter turns with a book",
                },
                missing={
                    "a": "turn about an axis and move along the same one: does either step change the other?",
                    "d": "two translations add up: does their order matter?",
                },
            ),
            hints=(
                "Which of the steps changes the axis that the other one uses?",
                "A translation changes no direction; a rotation changes all but its own axis.",
                "Two steps along or about one axis commute, and so do two translations.",
            ),
            right=(["a", "d"], "a, d", {"d", "a"}),
            wrong=(
                Wrong(["a"], "two translations add up"),
                Wrong(["a", "b", "d"], "changes the direction of x"),
                Wrong(["a", "c", "d"], "two quarter turns with a book"),
                Wrong("d", "turn about an axis and move along the same one"),
            ),
        ),
        Task(
            name="inverse",
            title="The inverse",
            text="Let ${}^AT_B$ have the rotation $\\mathbf{Rot}_z(\\theta)$ and the origin $[x, y, z]^T$. Write ${}^BT_A$, the pose of $A$"
            " in $B$, as a 4×4 matrix in `theta`, `x`, `y`, `z`.",
            asks=Formula(INVERSE, ("theta", "x", "y", "z")),
            hints=(
                "If $p_A = R\\,p_B + t$, what is $p_B$?",
                "Block by block: $R^T$ on the left, $-R^T t$ on the right, $0\\ 0\\ 0\\ 1$ below.",
                "The last column begins with $-x\\cos\\theta - y\\sin\\theta$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The rotation is undone by its transpose.",
                        r"\begin{bmatrix} \cos\theta & -\sin\theta & 0 \\ \sin\theta & \cos\theta & 0 \\ 0 & 0 & 1 \end{bmatrix}^{-1} = \begin{bmatrix} \cos\theta & \sin\theta & 0 \\ -\sin\theta & \cos\theta & 0 \\ 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The origin of $A$, seen from $B$: go back along the turned axes.",
                        r"-\begin{bmatrix} \cos\theta & \sin\theta & 0 \\ -\sin\theta & \cos\theta & 0 \\ 0 & 0 & 1 \end{bmatrix} \begin{bmatrix} x \\ y \\ z \end{bmatrix} = \begin{bmatrix} -x\cos\theta - y\sin\theta \\ x\sin\theta - y\cos\theta \\ -z \end{bmatrix}",
                    ),
                    Line(
                        "Both blocks in one matrix.",
                        r"\begin{bmatrix} \cos\theta & -\sin\theta & 0 & x \\ \sin\theta & \cos\theta & 0 & y \\ 0 & 0 & 1 & z \\ 0 & 0 & 0 & 1 \end{bmatrix}^{-1} = \begin{bmatrix} \cos\theta & \sin\theta & 0 & -x\cos\theta - y\sin\theta \\ -\sin\theta & \cos\theta & 0 & x\sin\theta - y\cos\theta \\ 0 & 0 & 1 & -z \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"symbols": {"theta": "free", "x": "free", "y": "free", "z": "free"}},
            ),
            right=(inverse, INVERSE, WithSympy(_inverse_sympy)),
            wrong=(
                Wrong(
                    _inverse_with(lambda R: R.T, lambda R, p: -p),
                    "the origin is only negated: it must be expressed in B as well, −Rᵀp",
                    own=True,
                ),
                Wrong(
                    _inverse_with(lambda R: R.T, lambda R, p: -(R @ p)),
                    "the origin is turned the wrong way: R where Rᵀ belongs",
                    own=True,
                ),
                Wrong(
                    _inverse_with(lambda R: R.T, lambda R, p: R.T @ p),
                    "the minus sign of the origin is missing: −Rᵀp",
                    own=True,
                ),
                Wrong(
                    _inverse_with(lambda R: R, lambda R, p: -p),
                    "this negates the origin and leaves the rotation as it was",
                    own=True,
                ),
                Wrong(
                    _transposed,
                    "the whole is transposed: only the rotation block is, and the last row stays 0 0 0 1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="pose",
            title="The planar 2R arm",
            text="Write the pose of frame 2 in frame 0, ${}^0T_2$ (4×4), of the planar 2R arm: the bars are `l_1` and `l_2` long, frame 2"
            " sits at the tool. A function may be `def pose(q, l_1, l_2)` with `q` = $[\\theta_1, \\theta_2]$ in radians.",
            asks=Quantity("planar_2r", {"pose": 2}),
            hints=(
                "Each bar is a turn about $z$ and a move along the new $x$: you have written that matrix already.",
                "${}^0T_2 = {}^0T_1\\,{}^1T_2$, with ${}^0T_1 = \\mathbf{Rot}_z(\\theta_1)\\,\\mathbf{Trans}_x(l_1)$.",
                "$\\theta_2$ counts from bar 1, so the rotation of frame 2 is by $\\theta_1 + \\theta_2$; so is the direction of bar 2.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The first bar.",
                        r"T^0_1 = \begin{bmatrix} C_1 & -S_1 & 0 & l_1 C_1 \\ S_1 & C_1 & 0 & l_1 S_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The second bar is the same with index 2.",
                        r"T^1_2 = \begin{bmatrix} C_2 & -S_2 & 0 & l_2 C_2 \\ S_2 & C_2 & 0 & l_2 S_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line("Two sums are needed: the cosine of a sum,", r"C_1 C_2 - S_1 S_2 = C_{12}"),
                    Line("and the sine of a sum.", r"S_1 C_2 + C_1 S_2 = S_{12}"),
                    Line(
                        "Multiply.",
                        r"T^0_2 = T^0_1 T^1_2 = \begin{bmatrix} C_{12} & -S_{12} & 0 & l_1 C_1 + l_2 C_{12} \\ S_{12} & C_{12} & 0 & l_1 S_1 + l_2 S_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "planar_2r"},
            ),
            right=(pose, POSE, WithSympy(_pose_sympy)),
            wrong=(
                Wrong(lambda q, l_1, l_2: pose([q[0], q[1] - q[0]], l_1, l_2), "absolute"),
                Wrong(lambda q, l_1, l_2: pose(q, l_2, l_1), "swapped"),
                Wrong(
                    _moves_first,
                    "the bars move along x before they turn: the turn comes first, then the move along the new x",
                    own=True,
                ),
                Wrong(lambda q, l_1, l_2: np.linalg.inv(pose(q, l_1, l_2)), "inverse"),
                Wrong(lambda q, l_1, l_2: pose(np.deg2rad(q), l_1, l_2), "degrees"),
            ),
        ),
        Task(
            name="reading",
            title="Drake's order",
            text="`X_02` is Drake's pose of frame 2 in frame 0, and `p_0P` holds the coordinates of a point in frame 0. Which expression"
            " gives its coordinates in frame 2? `a`: `X_02 @ p_0P`; `b`: `X_02.inverse() @ p_0P`;"
            " `c`: `X_02.rotation().transpose() @ p_0P`; `d`: `p_0P - X_02.translation()`.",
            asks=Choice(
                {
                    "a": "X_02 @ p_0P",
                    "b": "X_02.inverse() @ p_0P",
                    "c": "rotation transposed",
                    "d": "difference of the origins",
                },
                right="b",
                because={
                    "a": "the indices do not meet: X_02 takes coordinates in frame 2, and p_0P has them in frame 0",
                    "c": "the axes are right, but the origin of frame 2 is not taken into account",
                    "d": "the origin is right, but the axes are still those of frame 0",
                },
            ),
            hints=(
                "In `X_AB @ p_BC` the inner letters meet, and `p_AC` is left.",
                "You need a transform whose name begins with 2 and ends with 0.",
                "The pose of 0 in 2 is the inverse of the pose of 2 in 0.",
            ),
            right=("b", ["b"], {"b"}),
            wrong=(
                Wrong("a", "the indices do not meet"),
                Wrong("c", "the origin of frame 2"),
                Wrong("d", "still those of frame 0"),
                Wrong(["a", "b"], "one of them is asked for"),
            ),
        ),
        Task(
            name="point",
            title="A point seen from frame 0",
            text="A camera on the tool stands at $[0, h, 0]^T$ in frame 2. Write its three coordinates in frame 0, in metres, in"
            " `theta_1`, `theta_2`, `l_1`, `l_2`, `h`.",
            asks=Formula(POINT, ("theta_1", "theta_2", "l_1", "l_2", "h"), arm="planar_2r", unit="m"),
            hints=(
                "The matrix that gives the pose of 2 in 0 also turns coordinates in 2 into coordinates in 0.",
                "Multiply ${}^0T_2$ by $[0, h, 0, 1]^T$ and leave the 1 out.",
                "The camera is $h$ times the second column of the rotation away from the tool.",
            ),
            right=(point, POINT, WithSympy(_point_sympy)),
            wrong=(
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2, h: point(theta_1, theta_2, l_1, l_2, 0) + np.array([0, h, 0]),
                    "h is added along the y axis of frame 0: the camera turns with the tool",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2, h: point(theta_1, theta_2, l_1, l_2, 0),
                    "the camera is missing: this is the tool itself",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2, h: point(theta_1, theta_2, l_1, l_2 + h, 0),
                    "h is put along x_2, in line with the bar: the camera stands along y_2",
                    own=True,
                ),
                Wrong(POINT.replace("- h S", "+ h S"), "entry (1, 1): wrong sign"),
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2, h: point(theta_1, theta_2, l_1, l_2, -h),
                    "the camera is on the other side of the bar: y_2 is [−sin, cos, 0]",
                    own=True,
                ),
            ),
        ),
        Task(
            name="freedom",
            title="Limits: sixteen entries, how many choices",
            text="A homogeneous transform has sixteen entries. How many independent numbers determine it?",
            asks=Number(
                6, steps=("3 + 3",), beside=("4 + 4", "12 - 1", "12 - 3", "1 + 1", "16 - 2", "16 - 3", r"6 \cdot 3")
            ),
            hints=(
                "The last row is always the same.",
                "Three numbers are the origin. The other nine are three unit vectors at right angles to each other.",
                "Three conditions of length, three of right angles: nine minus six, and the origin.",
            ),
            right=(6, "6", 6.0),
            wrong=(
                Wrong(16, "the last row is 0 0 0 1 in every one of them", own=True),
                Wrong(
                    12,
                    "twelve entries vary, but the nine of the rotation obey six equations: its columns are unit vectors at right angles",
                    own=True,
                ),
                Wrong(9, "these are the entries of the rotation alone, and they are not independent", own=True),
                Wrong(3, "three for the position, or three for the orientation; a pose has both", own=True),
                Wrong(7, "a quaternion has four numbers, but its length is 1: three for the orientation", own=True),
                Wrong(5, "three for the position; two would be a direction alone, a rotation takes three", own=True),
                Wrong(4, "one angle is enough in a plane: a rotation in space takes three", own=True),
                Wrong(15, "the whole last row is fixed, not its last entry alone", own=True),
                Wrong(10, "sixteen less the six equations of the rotation: the last row is fixed, too", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A carriage slides by $d$ along $x$ of frame A. On it a bar of length $b$ turns by $\\theta$ about $z$. Write the pose of the bar's"
            " end in frame A, $4 \\times 4$. A function takes `(d, theta, b)`.",
            asks=Formula(CARRIAGE, ("d", "theta", "b")),
            hints=(
                "Three steps, each on the frame that the one before made: multiply them from left to right.",
                "Shift by $d$, turn by $\\theta$, shift by $b$: the bar's end lies at $[d + b\\cos\\theta, b\\sin\\theta, 0]^T$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "First the carriage, then the turn on it.",
                        r"\mathrm{Trans}_x(d)\,\mathrm{Rot}_z(\theta) = \begin{bmatrix} \cos\theta & -\sin\theta & 0 & d \\ \sin\theta & \cos\theta & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Then $b$ along the turned bar.",
                        r"\mathrm{Trans}_x(d)\,\mathrm{Rot}_z(\theta)\,\mathrm{Trans}_x(b) = \begin{bmatrix} \cos\theta & -\sin\theta & 0 & d + b\cos\theta \\ \sin\theta & \cos\theta & 0 & b\sin\theta \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"symbols": {"theta": "free", "d": "free", "b": "free"}},
            ),
            right=(carriage, CARRIAGE, WithSympy(_carriage_sympy)),
            wrong=(
                Wrong(
                    lambda d, theta, b: carriage(0, theta, d + b),
                    "the carriage slides along x of frame A: the turn comes after it",
                    own=True,
                ),
                Wrong(
                    lambda d, theta, b: carriage(b, theta, d),
                    "the factors stand in the reverse order: the carriage slides first, then the bar turns on it",
                    own=True,
                ),
                Wrong(
                    lambda d, theta, b: carriage(d + b, theta, 0),
                    "the bar turns with the frame: its end is not b further along x",
                    own=True,
                ),
                Wrong(
                    lambda d, theta, b: np.linalg.inv(carriage(d, theta, b)),
                    "this is the pose of frame A in the bar's frame: the inverse",
                    own=True,
                ),
                Wrong(
                    lambda d, theta, b: carriage(d, -theta, b),
                    "the bar turns the other way: the sine is negative in row 1 of the rotation",
                    own=True,
                ),
                Wrong(
                    lambda d, theta, b: carriage(d, theta, 0),
                    "this is the foot of the bar: its length b is missing",
                    own=True,
                ),
            ),
        ),
    ),
)
