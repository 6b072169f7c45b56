"""Tasks of lesson 17, the orientation of the tool: s, n, a, RPY angles, and one SCARA in three documents (000, 001 and 004)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import Derivation, Formula, Lesson, Line, Number, Quantity, Table, Task, WithSympy, Wrong
from armproof.course.links import product, shift, turn

UP, DOWN = "scara_modified", "scara"  # the SCARA of document 001, all z up; that of document 000, with the tool down
MODIFIED = {  # the arm of document 000 in the other convention: the same tool frame
    "dh": "modified",
    "rows": [
        {"alpha": 0, "a": 0, "d": 0, "theta": "theta_1"},
        {"alpha": 0, "a": "a_1", "d": 0, "theta": "theta_2"},
        {"alpha": "pi", "a": "a_2", "d": "d_3", "theta": 0},
        {"alpha": 0, "a": 0, "d": "d_4", "theta": "theta_4"},
    ],
}
CLASSIC_ROWS = [("theta_1", 0, "a_1", 0), ("theta_2", 0, "a_2", "pi"), (0, "d_3", 0, 0), ("theta_4", "d_4", 0, 0)]
MODIFIED_ROWS = [(0, 0, 0, "theta_1"), (0, "a_1", 0, "theta_2"), ("pi", "a_2", "d_3", 0), (0, 0, "d_4", "theta_4")]
_ENTRIES = {  # with a positive common factor, in all quadrants
    "s_x": r"\rho\cos(5\beta)",
    "s_y": r"\rho\sin(5\beta)",
    "n_z": r"\rho\sin(3\gamma)",
    "a_z": r"\rho\cos(3\gamma)",
}
_AXES = ("n_x", "n_y", "n_z", "a_x", "a_y", "a_z")

# -- s, n, a and RPY ---------------------------------------------------------------------------------------------------


def sliding(n_x, n_y, n_z, a_x, a_y, a_z):
    """Return s = n × a."""
    return [n_y * a_z - n_z * a_y, n_z * a_x - n_x * a_z, n_x * a_y - n_y * a_x]


SLIDING = r"\begin{bmatrix} n_y a_z - n_z a_y \\ n_z a_x - n_x a_z \\ n_x a_y - n_y a_x \end{bmatrix}"


def _sliding_sympy(sp):
    n, a = sp.Matrix(sp.symbols("n_x n_y n_z")), sp.Matrix(sp.symbols("a_x a_y a_z"))
    return n.cross(a)


def rpy(phi, theta, psi):
    """Return Rot_z(φ) Rot_y(θ) Rot_x(ψ), 3×3."""
    cf, sf, ct, st, cp, sp = np.cos(phi), np.sin(phi), np.cos(theta), np.sin(theta), np.cos(psi), np.sin(psi)
    return np.array([
        [cf * ct, cf * st * sp - sf * cp, cf * st * cp + sf * sp],
        [sf * ct, sf * st * sp + cf * cp, sf * st * cp - cf * sp],
        [-st, ct * sp, ct * cp],
    ])  # fmt: skip


RPY = r"""\begin{bmatrix} C\varphi C\theta & C\varphi S\theta S\psi - S\varphi C\psi & C\varphi S\theta C\psi + S\varphi S\psi \\
S\varphi C\theta & S\varphi S\theta S\psi + C\varphi C\psi & S\varphi S\theta C\psi - C\varphi S\psi \\ -S\theta & C\theta S\psi & C\theta C\psi \end{bmatrix}"""
RPY = RPY.replace("varphi", "phi")


def _rpy_sympy(sp):
    phi, theta, psi = sp.symbols("phi theta psi")
    return (turn(sp, "z", phi) * turn(sp, "y", theta) * turn(sp, "x", psi))[:3, :3]


def _turned(*steps):
    """Return a product of rotations about x (0), y (1) or z (2)."""
    X = np.eye(3)
    for axis, angle in steps:
        c, s = np.cos(angle), np.sin(angle)
        k, m = (axis + 1) % 3, (axis + 2) % 3
        R = np.eye(3).astype(object)
        R[k, k], R[k, m], R[m, k], R[m, m] = c, -s, s, c
        X = X @ R
    return X


def angles(s_x, s_y, n_z, a_z):
    """Return φ and ψ where cos θ is positive."""
    return [np.arctan2(s_y, s_x), np.arctan2(n_z, a_z)]


ANGLES = r"\begin{bmatrix} \text{atan2}(s_y, s_x) \\ \text{atan2}(n_z, a_z) \end{bmatrix}"


def lock(phi, psi):
    """Return the rotation at θ = π/2: only ψ − φ is left."""
    c, s = np.cos(psi - phi), np.sin(psi - phi)
    return np.array([[0, s, c], [0, c, -s], [-1, 0, 0]])


LOCK = r"\begin{bmatrix} 0 & \sin(\psi - \phi) & \cos(\psi - \phi) \\ 0 & \cos(\psi - \phi) & -\sin(\psi - \phi) \\ -1 & 0 & 0 \end{bmatrix}"


def _lock_sympy(sp):
    return _rpy_sympy(sp).subs(sp.Symbol("theta"), sp.pi / 2)


# -- the SCARAs --------------------------------------------------------------------------------------------------------


def last_product(q, a_2, a_3):
    """Return U_0 = 0T1 U_1: three turns about parallel axes, and the slide."""
    theta_1, theta_2, d_2, theta_4 = q
    c, s = np.cos(theta_1 + theta_2 + theta_4), np.sin(theta_1 + theta_2 + theta_4)
    x = a_2 * np.cos(theta_1) + a_3 * np.cos(theta_1 + theta_2)
    y = a_2 * np.sin(theta_1) + a_3 * np.sin(theta_1 + theta_2)
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, -d_2], [0, 0, 0, 1]])


U_0 = r"""\begin{bmatrix} C_{124} & -S_{124} & 0 & a_2 C_1 + a_3 C_{12} \\ S_{124} & C_{124} & 0 & a_2 S_1 + a_3 S_{12} \\
0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def _last_sympy(sp):
    t1, t2, d2, t4, a2, a3 = sp.symbols("theta_1 theta_2 d_2 theta_4 a_2 a_3")
    X = turn(sp, "z", t1) * shift(sp, x=a2) * turn(sp, "z", t2) * shift(sp, x=a3, z=-d2) * turn(sp, "z", t4)
    return sp.simplify(X)


def upright(theta_1, theta_2, theta_4):
    """Return φ, θ, ψ of frame 4 of document 001."""
    return [theta_1 + theta_2 + theta_4, 0, 0]


UPRIGHT = r"\begin{bmatrix} \theta_1 + \theta_2 + \theta_4 \\ 0 \\ 0 \end{bmatrix}"


def down(theta_1, theta_2, theta_4):
    """Return φ, θ, ψ of frame 4 of document 000."""
    return [theta_1 + theta_2 - theta_4, 0, np.pi]


FLIPPED = r"\begin{bmatrix} \theta_1 + \theta_2 - \theta_4 \\ 0 \\ \pi \end{bmatrix}"


def conversion(theta_1, theta_2, d_2, theta_4):
    """Return the joint values of document 000 for those of document 001."""
    return [theta_1, theta_2, d_2, -theta_4]


CONVERSION = r"\begin{bmatrix} \theta_1 \\ \theta_2 \\ d_2 \\ -\theta_4 \end{bmatrix}"


def heights(d_1, d_3, d_4):
    """Return the height of the tool over frame 0 of the documents 001, 000 and 004."""
    return [-d_3, -d_3 - d_4, d_1 - d_3 - d_4]


HEIGHTS = r"\begin{bmatrix} -d_3 \\ -(d_3 + d_4) \\ d_1 - d_3 - d_4 \end{bmatrix}"


def _as_dicts(rows, *names):
    return [dict(zip(names, row, strict=True)) for row in rows]


LESSON = Lesson(
    number=17,
    name="tool_orientation",
    title="The orientation of the tool, and one SCARA in three documents",
    source="MECA 953 Robotique, MMT5, 2022 (document 001), with the SCARAs of documents 000 and 004",
    objectives=(
        "Read s, n and a off a pose, and give a gripper its frame.",
        "Go from RPY angles to a rotation and back, and know where this fails.",
        "Compare three descriptions of one SCARA, and write its table in both conventions.",
    ),
    tasks=(
        Task(
            name="unknowns",
            title="What the model takes and gives",
            text="The forward kinematics $X = f(q)$ of the SCARA: how many entries has $q$, how many has $X$ with position and direction cosines"
            " (all of $s, n, a$), and how many with position and RPY angles? Give three numbers.",
            asks=Number(
                (4, 12, 6),
                labels=(
                    "the number of entries of q",
                    "the number with direction cosines",
                    "the number with RPY angles",
                ),
                steps=("4", "3 + 9", "3 + 3"),
                beside=("[, 9 + 1,]", "[, 9 + 4,]", "[, 12 + 3,]", "[, , 3 + 6]", "[, , 2 + 3]"),
            ),
            hints=(
                "$q$ has one entry a joint.",
                "A position has three entries, a rotation nine direction cosines.",
                "Three angles are enough for a rotation: three and three.",
            ),
            right=([4, 12, 6], "4, 12, 6", np.array([4, 12, 6])),
            wrong=(
                Wrong([4, 16, 6], "the last row of the matrix is no unknown: 3 and 9 entries", own=True),
                Wrong(
                    [4, 9, 6],
                    "nine direction cosines are the orientation alone: the position belongs to X too",
                    own=True,
                ),
                Wrong([4, 12, 3], "three angles are the orientation alone: the position belongs to X too", own=True),
                Wrong([4, 9, 3], "this is the orientation alone: the position has three entries more", own=True),
                Wrong([6, 12, 6], "q has one entry a joint, and the SCARA has four joints", own=True),
                Wrong(
                    [4, 12, 4],
                    "three RPY angles and three coordinates, even where two of the angles are constant",
                    own=True,
                ),
                Wrong(
                    [4, 3, 6], "this is the position alone: the nine direction cosines belong to X as well", own=True
                ),
                Wrong([4, 12, 7], "four would be a quaternion: RPY angles are three", own=True),
                Wrong([3, 12, 6], "the slide is a joint, too: q has four entries", own=True),
                Wrong([4, 6, 6], "direction cosines are nine, not three: s, n and a have three entries each", own=True),
                Wrong([5, 12, 6], "the base is no joint: q has four entries", own=True),
            ),
        ),
        Task(
            name="columns",
            title="The approach vector",
            text="The rotation of a tool is $\\begin{bmatrix} 0 & -1 & 0 \\\\ 0 & 0 & -1 \\\\ 1 & 0 & 0 \\end{bmatrix}$, with the columns $s$, $n$, $a$."
            " Give $a$, the direction in which the gripper points, in frame 0: `[x, y, z]`.",
            asks=Number(
                (0, -1, 0),
                labels=("a_x", "a_y", "a_z"),
                beside=(
                    "s = [0, 0, 1]",
                    "n = [-1, 0, 0]",
                    "s + n = [-1, 0, 1]",
                    "s + a = [0, -1, 1]",
                    "n + a = [-1, -1, 0]",
                ),
            ),
            hints=(
                "$s$, $n$, $a$ (sliding, normal, approach) are the x, y and z axes of the tool, in frame 0.",
                "Axes are columns, not rows.",
                "The third column, from top to bottom.",
            ),
            right=([0, -1, 0], "0, -1, 0", np.array([0, -1, 0])),
            wrong=(
                Wrong([0, 0, 1], "this is s, the first column", own=True),
                Wrong([-1, 0, 0], "this is n, the second column", own=True),
                Wrong([1, 0, 0], "this is the third row: the tool's axes are columns", own=True),
                Wrong([0, 1, 0], "the sign: the entry in row 2 is −1", own=True),
                Wrong([0, 0, -1], "this is the second row: the tool's axes are columns", own=True),
                Wrong([0, -1, 1], "the entries belong to one column: the third", own=True),
            ),
        ),
        Task(
            name="gripper",
            title="The frame of a gripper",
            text="A gripper reaches forward for an object, along $[1, 0, 0]^T$; its jaws slide up and down, along $[0, 0, 1]^T$. By the rules of the"
            " slide ($Z_e$ towards the object, $Y_e$ in the plane in which the jaws slide), give $X_e$: `[x, y, z]`.",
            asks=Number(
                (0, 1, 0),
                labels=("x", "y", "z"),
                beside=(
                    "Y_e + Z_e = [1, 0, 1]",
                    "Z_e - Y_e = [1, 0, -1]",
                    r"(Y_e + Z_e)/\sqrt{2} = [1/\sqrt{2}, 0, 1/\sqrt{2}]",
                    "X_e + Z_e = [1, 1, 0]",
                    "X_e + Y_e = [0, 1, 1]",
                    "X_e - Y_e = [0, 1, -1]",
                    "X_e + Y_e + Z_e = [1, 1, 1]",
                ),
            ),
            hints=(
                "Which of the three vectors are given?",
                "$X_e = Y_e \\times Z_e$, since $X$, $Y$, $Z$ follow each other in a circle.",
                "$[0, 0, 1]^T \\times [1, 0, 0]^T$: the second entry is $1 \\cdot 1 - 0 \\cdot 0$.",
            ),
            right=([0, 1, 0], "0, 1, 0", np.array([0, 1, 0])),
            wrong=(
                Wrong([0, -1, 0], "this is Z_e × Y_e: the frame would be left-handed", own=True),
                Wrong([1, 0, 0], "this is Z_e, towards the object", own=True),
                Wrong([0, 0, 1], "this is Y_e, in the plane of the jaws", own=True),
                Wrong([0, 1, 1], "an axis has length one, and is at right angles to Y_e", own=True),
                Wrong([-1, 0, 0], "this is −Z_e, away from the object", own=True),
                Wrong([0, 0, -1], "this is −Y_e, in the plane of the jaws", own=True),
                Wrong(
                    [0, 0, 0],
                    "the dot product is zero; the cross product of two unit vectors at right angles has the length 1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="sliding",
            title="Two columns give the third",
            text="$n$ and $a$ are known. Write $s = n \\times a$ (3 rows) in `n_x`, `n_y`, `n_z`, `a_x`, `a_y`, `a_z`.",
            asks=Formula(SLIDING, _AXES),
            hints=(
                "The definition of the cross product: each row has the two other components.",
                "Row 1 has the components y and z.",
                "$n_y a_z - n_z a_y$; the next rows follow by moving all letters one on, $x \\to y \\to z \\to x$.",
            ),
            right=(sliding, SLIDING, WithSympy(_sliding_sympy)),
            wrong=(
                Wrong(
                    lambda *of: [-each for each in sliding(*of)],
                    "this is a × n: the order makes the sign",
                    own=True,
                ),
                Wrong(
                    SLIDING.replace("n_z a_x - n_x a_z", "n_x a_z - n_z a_x"),
                    "the middle row has the wrong sign: it begins with the z of n",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} n_x a_x \\ n_y a_y \\ n_z a_z \end{bmatrix}",
                    "these are products entry by entry: each row of a cross product has the two other components",
                    own=True,
                ),
                Wrong(SLIDING.replace("- n_z a_y", "+ n_z a_y"), "sign"),
            ),
        ),
        Task(
            name="rpy",
            title="From angles to a rotation",
            text="Write $\\mathbf{Rot}_z(\\phi)\\,\\mathbf{Rot}_y(\\theta)\\,\\mathbf{Rot}_x(\\psi)$, 3×3, in `phi`, `theta`, `psi`: the rotation of the RPY angles.",
            asks=Formula(RPY, ("phi", "theta", "psi")),
            hints=(
                "Multiply the last two first: $\\mathbf{Rot}_y(\\theta)\\,\\mathbf{Rot}_x(\\psi)$ has the last row $-S\\theta,\\ C\\theta S\\psi,\\ C\\theta C\\psi$.",
                "Its first row is $C\\theta,\\ S\\theta S\\psi,\\ S\\theta C\\psi$, its second $0,\\ C\\psi,\\ -S\\psi$.",
                "$\\mathbf{Rot}_z(\\phi)$ mixes these two rows and leaves the third.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The last two first.",
                        r"R_y(\theta) R_x(\psi) = \begin{bmatrix} C\theta & S\theta S\psi & S\theta C\psi \\ 0 & C\psi & -S\psi \\ -S\theta & C\theta S\psi & C\theta C\psi \end{bmatrix}",
                    ),
                    Line(
                        "A turn about $z$ mixes the first two rows.",
                        r"R_z(\phi) = \begin{bmatrix} C\phi & -S\phi & 0 \\ S\phi & C\phi & 0 \\ 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Multiply.",
                        r"R_z(\phi) R_y(\theta) R_x(\psi) = \begin{bmatrix} C\phi C\theta & C\phi S\theta S\psi - S\phi C\psi & C\phi S\theta C\psi + S\phi S\psi \\ S\phi C\theta & S\phi S\theta S\psi + C\phi C\psi & S\phi S\theta C\psi - C\phi S\psi \\ -S\theta & C\theta S\psi & C\theta C\psi \end{bmatrix}",
                    ),
                ),
                {"symbols": {"phi": "free", "theta": "free", "psi": "free"}},
            ),
            right=(rpy, RPY, WithSympy(_rpy_sympy)),
            wrong=(
                Wrong(
                    lambda phi, theta, psi: _turned((0, psi), (1, theta), (2, phi)),
                    "the factors stand in the reverse order: the turn about z is on the left",
                    own=True,
                ),
                Wrong(
                    lambda phi, theta, psi: rpy(psi, theta, phi),
                    "φ and ψ are exchanged: φ turns about z, ψ about x",
                    own=True,
                ),
                Wrong(
                    lambda phi, theta, psi: rpy(phi, -theta, psi),
                    "the turn about y has the signs of the others: about y, z turns towards x",
                    own=True,
                ),
                Wrong(lambda phi, theta, psi: rpy(phi, theta, psi).T, "transposed"),
                Wrong(
                    lambda phi, theta, psi: _turned((2, phi), (1, theta), (2, psi)),
                    "these are Euler angles z, y, z: the last turn of RPY is about x",
                    own=True,
                ),
            ),
        ),
        Task(
            name="pitch",
            title="From a rotation to its pitch",
            text="The first column of a rotation is $s = [0.768, 0.576, -0.28]^T$. With $\\cos\\theta > 0$, give $\\sin\\theta$, $\\cos\\theta$ and"
            " $\\tan\\phi$.",
            asks=Number(
                (0.28, 0.96, 0.75),
                labels=("sin θ", "cos θ", "tan φ"),
                steps=("s_x = 0.768", "s_y = 0.576", "s_z = -0.28", "-s_z", r"\sqrt{(s_x^2 + s_y^2)}", "s_y/s_x"),
                beside=(
                    "s = [0.768, 0.576, -0.28]",
                    r"[, \sqrt{(1 + s_z^2)},]",
                    r"\sqrt{(1 - s_x^2)}",
                    r"\sqrt{(1 - s_y^2)}",
                    "s_y/s_z",
                    "s_x/s_z",
                    "s_z/s_x",
                    r"\cos\phi = s_x/0.96",
                    r"\sin\phi = s_y/0.96",
                ),
            ),
            hints=(
                "Compare with the first column of your matrix: $[C\\phi C\\theta,\\ S\\phi C\\theta,\\ -S\\theta]^T$.",
                "$\\cos\\theta = \\sqrt{s_x^2 + s_y^2}$, where it is positive.",
                "$\\tan\\phi = s_y / s_x$: the factor $\\cos\\theta$ goes out.",
            ),
            right=([0.28, 0.96, 0.75], "0.28, 0.96, 0.75", np.array([0.28, 0.96, 0.75])),
            wrong=(
                Wrong([-0.28, 0.96, 0.75], "the third entry is −sin θ", own=True),
                Wrong([0.28, -0.96, 0.75], "cos θ is asked to be positive", own=True),
                Wrong([0.28, 0.96, 4 / 3], "tan φ is upside down: sine over cosine, s_y over s_x", own=True),
                Wrong([0.28, 0.9216, 0.75], "cos θ is the length of [s_x, s_y]: 0.9216 is its square", own=True),
                Wrong([0.28, 0.768, 0.75], "s_x is cos φ cos θ: cos θ is the length of [s_x, s_y]", own=True),
                Wrong([0.28, 0.96, 0.576], "tan φ is s_y / s_x: divide by s_x as well", own=True),
            ),
        ),
        Task(
            name="angles",
            title="The other two angles",
            text="With $\\cos\\theta > 0$, write $\\phi$ and $\\psi$ (2 rows, rad) by `atan2` of entries of the matrix: in `s_x`, `s_y`, `n_z`, `a_z`.",
            asks=Formula(
                ANGLES,
                ("s_x", "s_y", "n_z", "a_z"),
                given=_ENTRIES,
                symbols={"rho": "free", "beta": "free", "gamma": "free"},
                unit="rad",
            ),
            hints=(
                "Two entries of the first column have $\\phi$ in them, two of the last row $\\psi$.",
                "`atan2` takes what has the sine first. A positive common factor does no harm.",
                "$n_z = C\\theta S\\psi$ and $a_z = C\\theta C\\psi$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The first column of the rotation has $\\phi$ and $\\theta$ alone.",
                        r"R_z(\phi) R_y(\theta) R_x(\psi) \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} = \begin{bmatrix} \cos\phi\cos\theta \\ \sin\phi\cos\theta \\ -\sin\theta \end{bmatrix}",
                    ),
                    Line(
                        "Its upper two entries are cosine and sine of $\\phi$, times one factor.",
                        r"\begin{bmatrix} s_x \\ s_y \end{bmatrix} = \cos\theta \begin{bmatrix} \cos\phi \\ \sin\phi \end{bmatrix}",
                    ),
                    Line(
                        "That factor is positive: the angle of $(s_x, s_y)$ is $\\phi$, in all quadrants.",
                        r"\phi = \text{atan2}(s_y, s_x)",
                    ),
                    Line(
                        "The last row has $\\theta$ and $\\psi$ alone.",
                        r"\begin{bmatrix} 0 & 0 & 1 \end{bmatrix} R_z(\phi) R_y(\theta) R_x(\psi) = \begin{bmatrix} -\sin\theta & \cos\theta\sin\psi & \cos\theta\cos\psi \end{bmatrix}",
                    ),
                    Line(
                        "Its last two entries, in the same way.",
                        r"\psi = \text{atan2}(n_z, a_z)",
                    ),
                ),
                {"symbols": {"t": "free", "beta": "free", "gamma": "free"}},
                given=(
                    r"\theta = \arctan t",
                    r"\phi = \beta",
                    r"\psi = \gamma",
                    r"s_x = \cos\phi\cos\theta",
                    r"s_y = \sin\phi\cos\theta",
                    r"n_z = \cos\theta\sin\psi",
                    r"a_z = \cos\theta\cos\psi",
                ),
            ),
            right=(
                angles,
                ANGLES,
                WithSympy(lambda sp: sp.Matrix([sp.atan2(*sp.symbols("s_y s_x")), sp.atan2(*sp.symbols("n_z a_z"))])),
            ),
            wrong=(
                Wrong(
                    lambda s_x, s_y, n_z, a_z: [np.arctan2(s_x, s_y), np.arctan2(a_z, n_z)],
                    "the arguments are exchanged: atan2 takes the sine first",
                    own=True,
                ),
                Wrong(
                    lambda s_x, s_y, n_z, a_z: [np.arctan(s_y / s_x), np.arctan(n_z / a_z)],
                    "arctan of a quotient loses the quadrant: take atan2",
                    own=True,
                ),
                Wrong(
                    lambda s_x, s_y, n_z, a_z: [np.arctan2(n_z, a_z), np.arctan2(s_y, s_x)],
                    "the rows are exchanged: φ is in s, ψ in the last row",
                    own=True,
                ),
                Wrong(
                    lambda s_x, s_y, n_z, a_z: [np.degrees(each) for each in angles(s_x, s_y, n_z, a_z)],
                    "degrees",
                ),
            ),
        ),
        Task(
            name="lock",
            title="Limits: where two angles become one",
            text="Put $\\theta = \\pi/2$ and write the rotation, 3×3, in `phi` and `psi`, with one angle only.",
            asks=Formula(LOCK, ("phi", "psi")),
            hints=(
                "$C\\theta = 0$ and $S\\theta = 1$ in your matrix.",
                "Entry (1, 2) becomes $C\\phi S\\psi - S\\phi C\\psi$. You know that difference.",
                "Every entry has $\\psi - \\phi$ only: turning both by the same angle changes nothing.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Put the angle into your matrix: $C\\theta = 0$, $S\\theta = 1$.",
                        r"R_z(\phi) R_y(\tfrac{\pi}{2}) R_x(\psi) = \begin{bmatrix} 0 & C\phi S\psi - S\phi C\psi & C\phi C\psi + S\phi S\psi \\ 0 & S\phi S\psi + C\phi C\psi & S\phi C\psi - C\phi S\psi \\ -1 & 0 & 0 \end{bmatrix}",
                    ),
                    Line("The sine of a difference,", r"C\phi S\psi - S\phi C\psi = \sin(\psi - \phi)"),
                    Line("and its cosine.", r"C\phi C\psi + S\phi S\psi = \cos(\psi - \phi)"),
                    Line(
                        "One angle is left.",
                        r"R_z(\phi) R_y(\tfrac{\pi}{2}) R_x(\psi) = \begin{bmatrix} 0 & \sin(\psi - \phi) & \cos(\psi - \phi) \\ 0 & \cos(\psi - \phi) & -\sin(\psi - \phi) \\ -1 & 0 & 0 \end{bmatrix}",
                    ),
                ),
                {"symbols": {"phi": "free", "theta": "free", "psi": "free"}},
            ),
            right=(lock, LOCK, WithSympy(_lock_sympy)),
            wrong=(
                Wrong(
                    LOCK.replace(r"\psi - \phi", r"\psi + \phi"),
                    "the sum belongs to θ = −π/2: here the angles are subtracted",
                    own=True,
                ),
                Wrong(
                    LOCK.replace(r"\psi - \phi", r"\phi - \psi"),
                    "the difference is taken the other way round: look at entry (1, 2)",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & \cos(\psi - \phi) & -\sin(\psi - \phi) \\ 0 & \sin(\psi - \phi) & \cos(\psi - \phi) \end{bmatrix}",
                    "that turns about x; with θ = π/2 the first column is [0, 0, −1]",
                    own=True,
                ),
                Wrong(LOCK.replace(r"-1 & 0 & 0", r"1 & 0 & 0"), "sign"),
            ),
        ),
        Task(
            name="last_product",
            title="The product U₀ by hand",
            text="Write $U_0 = {}^0T_1\\,U_1$ of document 001's SCARA, 4×4, by hand. ($U_1$ is in lesson 6.) Letters: `a_2`, `a_3` and the joints.",
            asks=Quantity(UP, {"pose": 4}),
            hints=(
                "${}^0T_1$ is a turn by $\\theta_1$ about $z$: what does it do to the angle, and to the origin?",
                "Turns about parallel axes add up: $\\theta_1 + \\theta_2 + \\theta_4$.",
                "The origin of $U_1$ is $[a_2 + a_3 C_2,\\ a_3 S_2,\\ -d_2]^T$; turn it by $\\theta_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Row 1 of the table.",
                        r"{}^0T_1 = \begin{bmatrix} C_1 & -S_1 & 0 & 0 \\ S_1 & C_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "$U_1$, from lesson 6.",
                        r"{}^1T_4 = \begin{bmatrix} C_{24} & -S_{24} & 0 & a_2 + a_3 C_2 \\ S_{24} & C_{24} & 0 & a_3 S_2 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "The turn takes the origin with it.",
                        r"R_z(\theta_1) \begin{bmatrix} a_2 + a_3 C_2 \\ a_3 S_2 \\ -d_2 \end{bmatrix} = \begin{bmatrix} a_2 C_1 + a_3 C_{12} \\ a_2 S_1 + a_3 S_{12} \\ -d_2 \end{bmatrix}",
                    ),
                    Line(
                        "The angles add up.",
                        r"{}^0T_1 {}^1T_4 = \begin{bmatrix} C_{124} & -S_{124} & 0 & a_2 C_1 + a_3 C_{12} \\ S_{124} & C_{124} & 0 & a_2 S_1 + a_3 S_{12} \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara_modified"},
            ),
            right=(last_product, U_0, WithSympy(_last_sympy)),
            wrong=(
                Wrong(
                    lambda q, a_2, a_3: product([(a_2, 0, 0, q[1]), (a_3, 0, -q[2], 0), (0, 0, 0, q[3])]),
                    "this is U_1: joint 1 is missing",
                    own=True,
                ),
                Wrong(U_0.replace("& -d_2", "& d_2"), "sign"),
                Wrong(
                    U_0.replace("_{124}", "_{12}"),
                    "joint 4 is missing in the rotation: three angles add up",
                    own=True,
                ),
                Wrong(
                    U_0.replace("C_{12} ", "C_2 ").replace("S_{12} ", "S_2 "),
                    "the second arm is not turned by θ_1: C_12 and S_12",
                    own=True,
                ),
                Wrong(lambda q, a_2, a_3: last_product(q, a_3, a_2), "swapped"),
            ),
        ),
        Task(
            name="upright",
            title="Its RPY angles",
            text="Give the RPY angles $[\\phi, \\theta, \\psi]$ of frame 4 in $U_0$ (rad), in `theta_1`, `theta_2`, `theta_4`.",
            asks=Formula(UPRIGHT, ("theta_1", "theta_2", "theta_4"), arm=UP, unit="rad"),
            hints=(
                "The third column of $U_0$ is $[0, 0, 1]^T$: which angles are zero then?",
                "All turns are about $z$.",
                "The document calls the one angle $\\theta$; as an RPY angle it is $\\phi$.",
            ),
            right=(
                upright,
                UPRIGHT,
                WithSympy(lambda sp: sp.Matrix([sum(sp.symbols("theta_1 theta_2 theta_4")), 0, 0])),
            ),
            wrong=(
                Wrong(
                    lambda theta_1, theta_2, theta_4: [0, theta_1 + theta_2 + theta_4, 0],
                    "the document's letter θ is the angle about z: as an RPY angle that is φ, the first",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, theta_4: [0, 0, theta_1 + theta_2 + theta_4],
                    "ψ turns about x: the turns are about z, and that is φ, the first",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, theta_4: [theta_1 + theta_2 - theta_4, 0, 0],
                    "this is the sign of document 000, where the tool points down; here all axes point up",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, theta_4: [theta_1, theta_2, theta_4],
                    "the joint angles are no RPY angles: they all turn about z, and add up to φ",
                    own=True,
                ),
            ),
        ),
        Task(
            name="down",
            title="The same arm with the tool down",
            text="In document 000 the rotation of frame 4 is $\\mathbf{Rot}_z(\\theta_1 + \\theta_2 - \\theta_4)\\,\\mathbf{Rot}_x(\\pi)$. Give its RPY angles"
            " $[\\phi, \\theta, \\psi]$ (rad), with $\\cos\\theta > 0$.",
            asks=Formula(FLIPPED, ("theta_1", "theta_2", "theta_4"), arm=DOWN, unit="rad"),
            hints=(
                "Which of the three factors $\\mathbf{Rot}_z\\,\\mathbf{Rot}_y\\,\\mathbf{Rot}_x$ are there?",
                "No turn about $y$. About $x$ it is half a turn.",
                "$z_4$ points down, against $z_0$: that is $\\psi = \\pi$.",
            ),
            derivation=Derivation(
                (
                    Line("The rotation of the document.", r"{}^0R_4 = R_z(\theta_1 + \theta_2 - \theta_4) R_x(\pi)"),
                    Line(
                        "A turn by zero about $y$ may stand between.",
                        r"{}^0R_4 = R_z(\theta_1 + \theta_2 - \theta_4) R_y(0) R_x(\pi)",
                    ),
                    Line(
                        "The pitch is zero, as its cosine is positive: $z_4$ points down.",
                        r"{}^0R_4 \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} 0 \\ 0 \\ -1 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara"},
            ),
            right=(
                down,
                FLIPPED,
                WithSympy(
                    lambda sp: sp.Matrix([sp.Symbol("theta_1") + sp.Symbol("theta_2") - sp.Symbol("theta_4"), 0, sp.pi])
                ),
            ),
            wrong=(
                Wrong(
                    lambda theta_1, theta_2, theta_4: [theta_1 + theta_2 - theta_4, 0, 0],
                    "the half turn about x is missing: z_4 points down",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, theta_4: [theta_1 + theta_2 + theta_4, 0, np.pi],
                    "θ_4 turns about z_4, which points down: it counts against the others",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, theta_4: [theta_1 + theta_2 - theta_4, np.pi, 0],
                    "the half turn is about x, which is ψ; θ turns about y",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, theta_4: [theta_1 + theta_2 - theta_4, 0, np.pi / 2],
                    "a quarter turn would lay the tool level: it points down after half a turn",
                    own=True,
                ),
            ),
        ),
        Task(
            name="conversion",
            title="From document 001 to document 000",
            text="Both SCARAs are one arm, with the same $x_4$ and both slides at zero together. Document 001 has the joint values"
            " $[\\theta_1, \\theta_2, d_2, \\theta_4]$. Write those of document 000 for the same posture, 4 rows, in these letters.",
            asks=Formula(CONVERSION, ("theta_1", "theta_2", "d_2", "theta_4"), arm=UP),
            hints=(
                "Joints 1 and 2 turn about axes that point up in both.",
                "Lowering is positive in both: $z = -d_2$ there, $z = -(d_3 + d_4)$ here.",
                "$z_3$ points down in document 000: the same turn has the other sign.",
            ),
            right=(
                conversion,
                CONVERSION,
                WithSympy(lambda sp: sp.Matrix([*sp.symbols("theta_1 theta_2 d_2"), -sp.Symbol("theta_4")])),
            ),
            wrong=(
                Wrong(
                    lambda theta_1, theta_2, d_2, theta_4: [theta_1, theta_2, d_2, theta_4],
                    "θ_4 is left as it is, but it turns about an axis that points up in one and down in the other",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, d_2, theta_4: [theta_1, theta_2, -d_2, -theta_4],
                    "the slide is positive downwards in both documents",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, d_2, theta_4: [theta_1, -theta_2, d_2, -theta_4],
                    "joint 2 turns about an axis that points up in both: only what comes after the half turn changes its sign",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, d_2, theta_4: [theta_1, theta_2, d_2, np.pi - theta_4],
                    "the half turn is about x, and x_4 is the same in both: θ_4 changes its sign only",
                    own=True,
                ),
            ),
        ),
        Task(
            name="heights",
            title="Three places for frame 0",
            text="The slide is lowered by $d_3$. Give the height of the tool over frame 0 three times, as rows: in document 001 (frame 0 at the tool's"
            " height where the slide is at zero), 000 (at the height of the arms, $d_4$ above the tool then), 004 (at the foot of a column of"
            " height $d_1$ that carries the arms). Letters: `d_1`, `d_3`, `d_4`.",
            asks=Formula(HEIGHTS, ("d_1", "d_3", "d_4"), arm="scara_column", unit="m"),
            hints=(
                "The tool is the same point each time; only what is subtracted differs.",
                "At $d_3 = 0$: 0 in document 001, $-d_4$ in document 000.",
                "Document 004 looks from $d_1$ below document 000.",
            ),
            right=(
                heights,
                HEIGHTS,
                WithSympy(
                    lambda sp: sp.Matrix(
                        [
                            -sp.Symbol("d_3"),
                            -sp.Symbol("d_3") - sp.Symbol("d_4"),
                            sp.Symbol("d_1") - sp.Symbol("d_3") - sp.Symbol("d_4"),
                        ]
                    )
                ),
            ),
            wrong=(
                Wrong(
                    lambda d_1, d_3, d_4: [d_3, d_3 + d_4, d_1 + d_3 + d_4],
                    "the slide and the tool go down, and z_0 points up: minus signs",
                    own=True,
                ),
                Wrong(
                    lambda d_1, d_3, d_4: [-d_3 - d_4, -d_3 - d_4, d_1 - d_3 - d_4],
                    "frame 0 of document 001 is at the tool's own height: no d_4 there",
                    own=True,
                ),
                Wrong(
                    lambda d_1, d_3, d_4: [-d_3, -d_3, d_1 - d_3],
                    "the tool is d_4 below frame 3 in documents 000 and 004",
                    own=True,
                ),
                Wrong(
                    lambda d_1, d_3, d_4: [-d_3, -d_3 - d_4, -d_1 - d_3 - d_4],
                    "frame 0 of document 004 is at the foot of the column, below the arms: + d_1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="classic_table",
            title="One arm, classic",
            text="Write the classic table of document 000's SCARA: four rows $(\\theta_i, d_i, a_i, \\alpha_i)$ with the joints, `a_1`, `a_2`, `d_4`.",
            asks=Table(DOWN, "classic"),
            hints=(
                "Row $i$ leads to frame $i$: about and along $z_{i-1}$, then along and about $x_i$.",
                "Between which two frames does $z$ turn over?",
                "$z_1$ points up and $z_2$ down: $\\alpha_2 = \\pi$.",
            ),
            right=(
                CLASSIC_ROWS,
                _as_dicts(CLASSIC_ROWS, "theta", "d", "a", "alpha"),
                r"\begin{array}{cccc} \theta_1 & 0 & a_1 & 0 \\ \theta_2 & 0 & a_2 & \pi \\ 0 & d_3 & 0 & 0 \\ \theta_4 & d_4 & 0 & 0 \end{array}",
            ),
            wrong=(
                Wrong(
                    [CLASSIC_ROWS[0], ("theta_2", 0, "a_2", 0), *CLASSIC_ROWS[2:]],
                    "row 2: alpha is wrong",
                ),
                Wrong(
                    [("theta_1", 0, 0, 0), ("theta_2", 0, "a_1", 0), (0, "d_3", "a_2", "pi"), ("theta_4", "d_4", 0, 0)],
                    "lengths and twists stand one row too late: these are the modified parameters in classic columns",
                    own=True,
                ),
                Wrong(
                    [*CLASSIC_ROWS[:2], ("d_3", 0, 0, 0), CLASSIC_ROWS[3]],
                    "the slide stands in the column of the angles: its variable is the offset",
                    own=True,
                ),
                Wrong([*CLASSIC_ROWS[:3], ("theta_4", 0, 0, 0)], "row 4: d is wrong"),
                Wrong(CLASSIC_ROWS[:3], "4 rows"),
            ),
        ),
        Task(
            name="modified_table",
            title="The same arm, modified",
            text="Now the modified table of the same arm, with the same frames 0 and 4: four rows $(\\alpha_{i-1}, a_{i-1}, d_i, \\theta_i)$.",
            asks=Table(MODIFIED, "modified"),
            hints=(
                "Each length and each twist moves one row down; the offsets and angles stay in their rows.",
                "Row 1 has neither length nor twist. Which row has $\\alpha = \\pi$ now?",
                "Row 3: $(\\pi, a_2, d_3, 0)$.",
            ),
            right=(
                MODIFIED_ROWS,
                _as_dicts(MODIFIED_ROWS, "alpha", "a", "d", "theta"),
                r"\begin{array}{cccc} 0 & 0 & 0 & \theta_1 \\ 0 & a_1 & 0 & \theta_2 \\ \pi & a_2 & d_3 & 0 \\ 0 & 0 & d_4 & \theta_4 \end{array}",
            ),
            wrong=(
                Wrong(
                    [(0, "a_1", 0, "theta_1"), ("pi", "a_2", 0, "theta_2"), (0, 0, "d_3", 0), (0, 0, "d_4", "theta_4")],
                    "lengths and twists stand one row too early: this is the classic table in modified columns",
                    own=True,
                ),
                Wrong(
                    [*MODIFIED_ROWS[:2], (0, "a_2", "-d_3", 0), (0, 0, "-d_4", "theta_4")],
                    "this is document 001's way, with all axes up: its frame 4 is another one, since z_4 is to point down",
                    own=True,
                ),
                Wrong(
                    [*MODIFIED_ROWS[:2], ("pi", "a_2", "d_3", 0), (0, 0, 0, "theta_4")],
                    "row 4: d is wrong",
                ),
                Wrong(
                    [*MODIFIED_ROWS[:2], ("pi", "d_3", "a_2", 0), MODIFIED_ROWS[3]],
                    "in row 3 a and d are exchanged: the slide runs along z_3",
                    own=True,
                ),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A ram on a turning column has the orientation $R_z(\\theta_1) R_x(-\\frac{\\pi}{2})$. Give its roll, pitch and yaw at"
            " $\\theta_1 = 0.4$, three numbers in radians, $R = R_z(yaw) R_y(pitch) R_x(roll)$.",
            asks=Number(
                (-np.pi / 2, 0, 0.4),
                "rad",
                labels=("the roll", "the pitch", "the yaw"),
                steps=(r"\theta_1 = 0.4", r"-\frac{\pi}{2}", "0", r"\theta_1"),
            ),
            hints=(
                "Compare the two products factor by factor: which one is missing?",
                "There is no turn about $y$; the last factor is the roll.",
            ),
            right=([-np.pi / 2, 0, 0.4], (-np.pi / 2, 0.0, 0.4), np.array([-np.pi / 2, 0, 0.4])),
            wrong=(
                Wrong([0.4, 0, -np.pi / 2], "roll and yaw are exchanged: the roll turns about x", own=True),
                Wrong([np.pi / 2, 0, 0.4], "the ram is turned by −90° about x: mind the sign", own=True),
                Wrong([-90, 0, 0.4], "angles are in radians: −90° is −π/2", own=True),
                Wrong([0, -np.pi / 2, 0.4], "the turn by −90° is about x: it is the roll, not the pitch", own=True),
                Wrong([-np.pi / 2, 0, -0.4], "the yaw turns about z, as the column does: the same sign", own=True),
            ),
        ),
    ),
)
