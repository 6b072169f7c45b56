"""Tasks of lesson 19, the inverse kinematics of the KUKA KR210: its wrist's centre first, then its wrist (document 001)."""

from __future__ import annotations

import numpy as np

from armproof.course.feedback import Derivation, Formula, Lesson, Line, Number, Task, WithSympy, Wrong

ARM = "kr210"
_FREE = {"rho": "free", "beta": "free", "gamma": "free"}
_TURNED = {  # two vectors of one length, in any directions
    "x": r"\rho\sin(5\beta + 3\gamma)",
    "y": r"\rho\cos(5\beta + 3\gamma)",
    "m": r"\rho\cos(3\gamma)",
    "n": r"\rho\sin(3\gamma)",
}
_SINE = r"\frac{8\rho}{1 + 16\rho^2}"  # of θ_5, which is between 0 and half a turn: the tangent of its half is 4ρ
_ENTRIES = {  # of the wrist's rotation
    "r_11": r"\frac{1 - 16\rho^2}{1 + 16\rho^2}",
    "r_12": rf"{_SINE}\sin(3\gamma)",
    "r_13": rf"{_SINE}\cos(3\gamma)",
    "r_21": rf"{_SINE}\sin(5\beta)",
    "r_31": rf"-{_SINE}\cos(5\beta)",
}


def centre(P_x, P_y, P_z, s_x, s_y, s_z, d_6, d_G):
    """Return the wrist's centre: back from the gripper along its x axis."""
    back = d_6 + d_G
    return [P_x - back * s_x, P_y - back * s_y, P_z - back * s_z]


CENTRE = r"\begin{bmatrix} P_x - (d_6 + d_G) s_x \\ P_y - (d_6 + d_G) s_y \\ P_z - (d_6 + d_G) s_z \end{bmatrix}"


def _centre_sympy(sp):
    P, s, back = sp.symbols("P_x P_y P_z"), sp.symbols("s_x s_y s_z"), sp.Symbol("d_6") + sp.Symbol("d_G")
    return sp.Matrix([each - back * along for each, along in zip(P, s, strict=True)])


def waist(p_x, p_y):
    """Return θ_1 of the arm that faces the centre."""
    return np.arctan2(p_y, p_x)


def plane(p_x, p_y, p_z, a_1, d_1, d_2):
    """Return the centre as seen from the shoulder: outwards and upwards."""
    return [np.sqrt(p_x**2 + p_y**2) - a_1, p_z - d_1 - d_2]


PLANE = r"\begin{bmatrix} \sqrt{p_x^2 + p_y^2} - a_1 \\ p_z - d_1 - d_2 \end{bmatrix}"


def _plane_sympy(sp):
    px, py, pz, a1, d1, d2 = sp.symbols("p_x p_y p_z a_1 d_1 d_2")
    return sp.Matrix([sp.sqrt(px**2 + py**2) - a1, pz - d1 - d2])


def two_links(theta_2, theta_3, a_2, a_3, L):
    """Return the centre from the shoulder: upper arm, forearm, and the step down between them."""
    both = theta_2 + theta_3
    x = a_2 * np.sin(theta_2) + L * np.cos(both) - a_3 * np.sin(both)
    y = a_2 * np.cos(theta_2) - L * np.sin(both) - a_3 * np.cos(both)
    return [x, y]


TWO_LINKS = r"\begin{bmatrix} a_2 S_2 + L C_{23} - a_3 S_{23} \\ a_2 C_2 - L S_{23} - a_3 C_{23} \end{bmatrix}"


def _two_links_sympy(sp):
    t2, t3, a2, a3, L = sp.symbols("theta_2 theta_3 a_2 a_3 L")
    turned = sp.Matrix([[sp.cos(t2 + t3), sp.sin(t2 + t3)], [-sp.sin(t2 + t3), sp.cos(t2 + t3)]])
    return sp.Matrix([a2 * sp.sin(t2), a2 * sp.cos(t2)]) + turned * sp.Matrix([L, -a3])


def elbow(x, y, a_2, a_3, L):
    """Return K = L sin θ_3 + a_3 cos θ_3, by the law of cosines."""
    return (a_2**2 + a_3**2 + L**2 - x**2 - y**2) / (2 * a_2)


ELBOW = r"\frac{a_2^2 + a_3^2 + L^2 - x^2 - y^2}{2 a_2}"


def _elbow_sympy(sp):
    x, y, a2, a3, L = sp.symbols("x y a_2 a_3 L")
    return sp.expand((a2**2 + a3**2 + L**2 - x**2 - y**2) / (2 * a2))


def forearm(a_3, L):
    """Return the straight length of the forearm, and the angle by which it hangs."""
    return [np.sqrt(L**2 + a_3**2), np.arctan2(a_3, L)]


FOREARM = r"\begin{bmatrix} \sqrt{L^2 + a_3^2} \\ \text{atan2}(a_3, L) \end{bmatrix}"


def _forearm_sympy(sp):
    a3, L = sp.symbols("a_3 L")
    return sp.Matrix([sp.sqrt(L**2 + a3**2), sp.atan2(a3, L)])


def elbow_angle(K, f, beta):
    """Return θ_3 of the elbow that is up: f sin(θ_3 + β) = K, the cosine positive."""
    return np.arctan2(K, np.sqrt(f**2 - K**2)) - beta


ELBOW_ANGLE = r"\text{atan2}(K, \sqrt{f^2 - K^2}) - \beta"


def _elbow_angle_sympy(sp):
    K, f, beta = sp.symbols("K f beta")
    return sp.atan2(K, sp.sqrt(f**2 - K**2)) - beta


def shoulder(x, y, m, n):
    """Return θ_2 from x = m S_2 + n C_2 and y = m C_2 − n S_2."""
    return np.arctan2(x, y) - np.arctan2(n, m)


SHOULDER = r"\text{atan2}(x, y) - \text{atan2}(n, m)"


def _shoulder_by_one_arc(x, y, m, n):
    return np.arctan2(m * x - n * y, n * x + m * y)


def wrist(r_11, r_12, r_13, r_21, r_31):
    """Return θ_4, θ_5, θ_6 of the wrist whose sine of θ_5 is positive."""
    return [np.arctan2(r_21, -r_31), np.arctan2(np.sqrt(r_21**2 + r_31**2), r_11), np.arctan2(r_12, r_13)]


WRIST = r"\begin{bmatrix} \text{atan2}(r_{21}, -r_{31}) \\ \text{atan2}(\sqrt{r_{21}^2 + r_{31}^2}, r_{11}) \\ \text{atan2}(r_{12}, r_{13}) \end{bmatrix}"


def _wrist_with_the_row(r_11, r_12, r_13, r_21, r_31):
    return [np.arctan2(r_21, -r_31), np.arctan2(np.sqrt(r_12**2 + r_13**2), r_11), np.arctan2(r_12, r_13)]


def _wrist_by_arccos(r_11, r_12, r_13, r_21, r_31):
    return [np.arctan2(r_21, -r_31), np.arccos(r_11), np.arctan2(r_12, r_13)]


def turret(p_x, p_y, p_z, h):
    """Return θ_1, θ_2 and d_3 of a turret whose ram reaches a point."""
    out, up = np.sqrt(p_x**2 + p_y**2), p_z - h
    return [np.arctan2(p_y, p_x), np.arctan2(up, out), np.sqrt(out**2 + up**2)]


TURRET = r"""\begin{bmatrix} \text{atan2}(p_y, p_x) \\ \text{atan2}(p_z - h, \sqrt{p_x^2 + p_y^2}) \\
\sqrt{p_x^2 + p_y^2 + (p_z - h)^2} \end{bmatrix}"""
_TARGET = {"p_x": r"\rho\cos(3\gamma)", "p_y": r"\rho\sin(3\gamma)"}  # a point in any direction about the turret


def _turret_by_norm(p_x, p_y, p_z, h):
    return [np.arctan2(p_y, p_x), np.arctan2(p_z - h, np.hypot(p_x, p_y)), (p_x**2 + p_y**2 + (p_z - h) ** 2) ** 0.5]


LESSON = Lesson(
    number=19,
    name="kr210_inverse",
    title="The KUKA KR210: the inverse, wrist apart",
    source="Our own derivation, for the arm of MECA 953 Robotique, MMT5, 2022, table of joint offsets (document 001)",
    objectives=(
        "Split the inverse of a six-joint arm in two: the wrist's centre, then the wrist.",
        "Solve the position like a planar arm of two links, the second of them bent.",
        "Read the wrist's angles off a rotation, and count the postures.",
    ),
    tasks=(
        Task(
            name="centre",
            title="The wrist's centre",
            text="The gripper stands at $P$; its x axis $s$ points along the gripper, and the axes 4, 5 and 6 meet at $d_6 + d_G$ behind it. Write the"
            " centre (3 rows, m) in `P_x`, `P_y`, `P_z`, `s_x`, `s_y`, `s_z`, `d_6`, `d_G`.",
            asks=Formula(CENTRE, ("P_x", "P_y", "P_z", "s_x", "s_y", "s_z", "d_6", "d_G"), arm=ARM, unit="m"),
            hints=(
                "From the centre you come to the gripper by a step along $s$.",
                "How long is that step? And back?",
                "$P - (d_6 + d_G)\\,s$, row by row.",
            ),
            right=(centre, CENTRE, WithSympy(_centre_sympy)),
            wrong=(
                Wrong(
                    lambda P_x, P_y, P_z, s_x, s_y, s_z, d_6, d_G: centre(P_x, P_y, P_z, s_x, s_y, s_z, -d_6, -d_G),
                    "this goes forward: the centre is behind the gripper",
                    own=True,
                ),
                Wrong(
                    lambda P_x, P_y, P_z, s_x, s_y, s_z, d_6, d_G: centre(P_x, P_y, P_z, s_x, s_y, s_z, d_6, 0),
                    "this starts at frame 6: the gripper is d_G further",
                    own=True,
                ),
                Wrong(
                    lambda P_x, P_y, P_z, s_x, s_y, s_z, d_6, d_G: [P_x - d_6 - d_G, P_y, P_z],
                    "this steps along x_0: the gripper points along s",
                    own=True,
                ),
                Wrong(
                    lambda P_x, P_y, P_z, s_x, s_y, s_z, d_6, d_G: [P_x, P_y, P_z],
                    "this is the gripper itself",
                    own=True,
                ),
            ),
        ),
        Task(
            name="waist",
            title="Joint 1",
            text="The centre is at $[p_x, p_y, p_z]^T$ in frame 0. Write $\\theta_1$ (rad) of the arm that faces it, in `p_x`, `p_y`, in all four quadrants.",
            asks=Formula(
                r"\text{atan2}(p_y, p_x)",
                ("p_x", "p_y"),
                given={"p_x": r"\rho\cos(5\beta)", "p_y": r"\rho\sin(5\beta)"},
                symbols=_FREE,
                unit="rad",
            ),
            hints=(
                "Look from above: the arm lies in a vertical plane through axis 1.",
                "The angle of a point $(x, y)$ is $\\text{atan2}(y, x)$.",
                "y first.",
            ),
            right=(waist, r"\text{atan2}(p_y, p_x)", WithSympy(lambda sp: sp.atan2(*sp.symbols("p_y p_x")))),
            wrong=(
                Wrong(lambda p_x, p_y: np.arctan2(p_x, p_y), "the arguments are exchanged: y is first", own=True),
                Wrong(
                    lambda p_x, p_y: np.arctan(p_y / p_x),
                    "arctan of a quotient cannot tell a target from the opposite one: take atan2",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y: np.arctan2(-p_y, -p_x),
                    "this arm faces away and reaches back: the other solution",
                    own=True,
                ),
                Wrong(lambda p_x, p_y: -np.arctan2(p_y, p_x), "sign"),
            ),
        ),
        Task(
            name="plane",
            title="Into the plane of the arm",
            text="The shoulder (axis 2) is $a_1$ in front of axis 1 and $d_1 + d_2$ above the floor. Write $x$ and $y$, how far out and how high the centre"
            " is, seen from the shoulder: 2 rows in `p_x`, `p_y`, `p_z`, `a_1`, `d_1`, `d_2`; the arm faces the centre.",
            asks=Formula(PLANE, ("p_x", "p_y", "p_z", "a_1", "d_1", "d_2"), arm=ARM, unit="m"),
            hints=(
                "How far is the centre from axis 1?",
                "$\\sqrt{p_x^2 + p_y^2}$, and the shoulder is $a_1$ nearer.",
                "For the height take both $d_1$ and $d_2$ away.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The shoulder: axis 2 is $a_1$ in front of axis 1, in the direction in which the arm faces.",
                        r"p_2 = \begin{bmatrix} a_1 C_1 \\ a_1 S_1 \\ d_1 + d_2 \end{bmatrix}",
                    ),
                    Line(
                        "The centre lies in the same upright plane: $x$ further out and $y$ higher.",
                        r"\begin{bmatrix} a_1 C_1 \\ a_1 S_1 \\ d_1 + d_2 \end{bmatrix} + \begin{bmatrix} x C_1 \\ x S_1 \\ y \end{bmatrix} = \begin{bmatrix} (a_1 + x) C_1 \\ (a_1 + x) S_1 \\ d_1 + d_2 + y \end{bmatrix}",
                    ),
                    Line(
                        "With $p_{cx}$, $p_{cy}$, $p_{cz}$ for the centre: square and add the first two rows, and $\\theta_1$ goes out.",
                        "p_{cx}^2 + p_{cy}^2 = (a_1 + x)^2",
                    ),
                    Line(
                        "So far out from axis 1, and $a_1$ less from the shoulder; the third row gives the height.",
                        r"\begin{bmatrix} \sqrt{p_{cx}^2 + p_{cy}^2} - a_1 \\ p_{cz} - d_1 - d_2 \end{bmatrix} = \begin{bmatrix} x \\ y \end{bmatrix}",
                    ),
                ),
                {"arm": ARM, "symbols": {"x": "free", "y": "free"}},
                given=(
                    "p_{cx} = (a_1 + x) C_1",
                    "p_{cy} = (a_1 + x) S_1",
                    "p_{cz} = d_1 + d_2 + y",
                ),
            ),
            right=(plane, PLANE, WithSympy(_plane_sympy)),
            wrong=(
                Wrong(
                    lambda p_x, p_y, p_z, a_1, d_1, d_2: plane(p_x, p_y, p_z, 0, d_1, d_2),
                    "this is seen from axis 1: the shoulder is a_1 in front of it",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, a_1, d_1, d_2: plane(p_x, p_y, p_z, a_1, d_1, 0),
                    "the shoulder is d_1 + d_2 above the floor",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, a_1, d_1, d_2: [p_x - a_1, p_z - d_1 - d_2],
                    "this holds at θ_1 = 0 only: the distance from axis 1 has p_y in it too",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, a_1, d_1, d_2: plane(p_x, p_y, p_z, -a_1, -d_1, -d_2),
                    "the offsets are taken away, not added",
                    own=True,
                ),
            ),
        ),
        Task(
            name="two_links",
            title="Two links, one bent",
            text="At $\\theta_2 = \\theta_3 = 0$ the upper arm ($a_2$) is upright and the forearm horizontal: $L = d_4 + d_5$ forward, $a_3$ down. Positive"
            " angles lean both forward. Write $x$ and $y$ of the centre (2 rows) in `theta_2`, `theta_3`, `a_2`, `a_3`, `L`.",
            asks=Formula(TWO_LINKS, ("theta_2", "theta_3", "a_2", "a_3", "L"), arm=ARM, unit="m"),
            hints=(
                "The upper arm: $a_2 S_2$ outwards, $a_2 C_2$ up.",
                "The forearm has turned by $\\theta_2 + \\theta_3$: its length $L$ gives $[C_{23}, -S_{23}]$.",
                "What points down at zero, $[0, -1]$, becomes $[-S_{23}, -C_{23}]$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The upper arm is upright at zero; $\\theta_2$ leans it forward.",
                        r"\begin{bmatrix} C_2 & S_2 \\ -S_2 & C_2 \end{bmatrix} \begin{bmatrix} 0 \\ a_2 \end{bmatrix} = \begin{bmatrix} a_2 S_2 \\ a_2 C_2 \end{bmatrix}",
                    ),
                    Line(
                        "The forearm goes $L$ forward and $a_3$ down at zero; $\\theta_2 + \\theta_3$ turns it.",
                        r"\begin{bmatrix} C_{23} & S_{23} \\ -S_{23} & C_{23} \end{bmatrix} \begin{bmatrix} L \\ -a_3 \end{bmatrix} = \begin{bmatrix} L C_{23} - a_3 S_{23} \\ -L S_{23} - a_3 C_{23} \end{bmatrix}",
                    ),
                    Line(
                        "Add the two.",
                        r"\begin{bmatrix} a_2 S_2 \\ a_2 C_2 \end{bmatrix} + \begin{bmatrix} L C_{23} - a_3 S_{23} \\ -L S_{23} - a_3 C_{23} \end{bmatrix} = \begin{bmatrix} a_2 S_2 + L C_{23} - a_3 S_{23} \\ a_2 C_2 - L S_{23} - a_3 C_{23} \end{bmatrix}",
                    ),
                    Line(
                        "A check: from the base, the centre of the whole arm has these two parts.",
                        r"p_5 = \begin{bmatrix} C_1 (a_1 + a_2 S_2 + L C_{23} - a_3 S_{23}) \\ S_1 (a_1 + a_2 S_2 + L C_{23} - a_3 S_{23}) \\ d_1 + d_2 + a_2 C_2 - L S_{23} - a_3 C_{23} \end{bmatrix}",
                    ),
                ),
                {"arm": ARM},
                given=("L = d_4 + d_5",),
            ),
            right=(two_links, TWO_LINKS, WithSympy(_two_links_sympy)),
            wrong=(
                Wrong(
                    lambda theta_2, theta_3, a_2, a_3, L: two_links(theta_2, theta_3 - theta_2, a_2, a_3, L),
                    "the forearm is carried by the upper arm: θ_2 + θ_3",
                    own=True,
                ),
                Wrong(
                    lambda theta_2, theta_3, a_2, a_3, L: two_links(theta_2, theta_3, a_2, 0, L),
                    "the step down, a_3, is missing",
                    own=True,
                ),
                Wrong(
                    lambda theta_2, theta_3, a_2, a_3, L: two_links(theta_2, theta_3, a_2, -a_3, L),
                    "a_3 goes down at zero, not up",
                    own=True,
                ),
                Wrong(
                    lambda theta_2, theta_3, a_2, a_3, L: two_links(-theta_2, -theta_3, a_2, a_3, L),
                    "positive angles lean forward: the upper arm goes outwards with sin θ_2",
                    own=True,
                ),
                Wrong(TWO_LINKS.replace("- a_3 S", "+ a_3 S"), "sign"),
            ),
        ),
        Task(
            name="elbow",
            title="The elbow's equation",
            text="Add the squares of $x$ and $y$; $\\theta_2$ goes out. Write $K = L\\sin\\theta_3 + a_3\\cos\\theta_3$ in `x`, `y`, `a_2`, `a_3`, `L`.",
            asks=Formula(ELBOW, ("x", "y", "a_2", "a_3", "L"), unit="m"),
            hints=(
                "Put $\\theta_2 = 0$ for the sum of the squares: it does not depend on it.",
                "$x^2 + y^2 = a_2^2 + a_3^2 + L^2 - 2 a_2 (L S_3 + a_3 C_3)$.",
                "Solve for the parenthesis.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Square both and add: only the angle between upper arm and forearm is left.",
                        r"x^2 + y^2 = a_2^2 + a_3^2 + L^2 - 2 a_2 (L\sin\theta_3 + a_3\cos\theta_3)",
                    ),
                    Line(
                        "Bring the parenthesis to the left.",
                        r"2 a_2 (L\sin\theta_3 + a_3\cos\theta_3) = a_2^2 + a_3^2 + L^2 - x^2 - y^2",
                    ),
                    Line("Divide.", r"L\sin\theta_3 + a_3\cos\theta_3 = \frac{a_2^2 + a_3^2 + L^2 - x^2 - y^2}{2 a_2}"),
                ),
                {"symbols": {"a_2": "free", "a_3": "free", "L": "free", "theta_2": "free", "theta_3": "free"}},
                given=(
                    r"x = a_2 \sin\theta_2 + L\cos(\theta_2 + \theta_3) - a_3\sin(\theta_2 + \theta_3)",
                    r"y = a_2 \cos\theta_2 - L\sin(\theta_2 + \theta_3) - a_3\cos(\theta_2 + \theta_3)",
                ),
            ),
            right=(elbow, ELBOW, WithSympy(_elbow_sympy)),
            wrong=(
                Wrong(
                    lambda x, y, a_2, a_3, L: -elbow(x, y, a_2, a_3, L),
                    "all signs are turned: the mixed term is −2 a_2 K",
                    own=True,
                ),
                Wrong(
                    lambda x, y, a_2, a_3, L: elbow(x, y, a_2, 0, L),
                    "a_3² is missing: the forearm is bent",
                    own=True,
                ),
                Wrong(
                    lambda x, y, a_2, a_3, L: elbow(x, y, a_2, a_3, L) / L,
                    "this is divided by 2 a_2 L: here the forearm's lengths stay in K",
                    own=True,
                ),
                Wrong(
                    lambda x, y, a_2, a_3, L: 2 * elbow(x, y, a_2, a_3, L),
                    "the factor 2 of the mixed term is forgotten: divide by 2 a_2",
                    own=True,
                ),
            ),
        ),
        Task(
            name="numbers",
            title="A check in numbers",
            text="In the zero pose the centre is at $[1.85, 0, 1.946]$ m. With $a_1 = 0.35$, $d_1 + d_2 = 0.75$, $a_2 = 1.25$, $a_3 = 0.054$, $L = 1.5$ m:"
            " give $x$, $y$ and $K$, in metres.",
            asks=Number(
                (1.5, 1.196, 0.054),
                unit="m",
                labels=("x", "y", "K"),
                steps=("1.85 - a_1", "1.946 - 0.75", "(a_2^2 + a_3^2 + L^2 - x^2 - y^2)/(2 a_2)"),
                beside=(
                    "(a_2^2 + a_3^2 + L^2 - x^2 - y^2)/(2 a_2 L)",
                    "(a_2^2 + L^2 - x^2 - y^2)/(2 a_2 L)",
                    r"\sqrt{(a_3^2 + L^2)}",
                    r"\sqrt{(x^2 + y^2)}",
                ),
            ),
            hints=(
                "$x = 1.85 - 0.35$, $y = 1.946 - 0.75$.",
                "$K$ two ways: by your formula, and by $L\\sin\\theta_3 + a_3\\cos\\theta_3$ at $\\theta_3 = 0$.",
                "At $\\theta_3 = 0$ only $a_3$ is left.",
            ),
            right=([1.5, 1.196, 0.054], "1.5, 1.196, 0.054", np.array([1.5, 1.196, 0.054])),
            wrong=(
                Wrong(
                    [1.85, 1.946, 0.054], "x and y are seen from the shoulder: take a_1 and d_1 + d_2 away", own=True
                ),
                Wrong([1.5, 1.196, 1.5], "K = L sin θ_3 + a_3 cos θ_3: at zero the sine is 0", own=True),
                Wrong([1.5, 1.196, 0], "at zero the cosine is 1: a_3 is left", own=True),
                Wrong([1.5, 1.196, -0.054], "the sign of K: a_3 cos 0 is positive", own=True),
            ),
        ),
        Task(
            name="forearm",
            title="The bent forearm as one link",
            text="$L\\sin\\theta_3 + a_3\\cos\\theta_3 = f\\sin(\\theta_3 + \\beta)$. Write $f > 0$ and $\\beta$ (2 rows) in `a_3`, `L`.",
            asks=Formula(FOREARM, ("a_3", "L")),
            hints=(
                "Expand $f\\sin(\\theta_3 + \\beta)$ and compare.",
                "$f\\cos\\beta = L$ and $f\\sin\\beta = a_3$.",
                "Length and angle of the vector $(L, a_3)$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Expand the sine of the sum.",
                        r"f \sin(\theta_3 + \beta) = f \cos\beta \sin\theta_3 + f \sin\beta \cos\theta_3",
                    ),
                    Line(
                        "Compare with $L\\sin\\theta_3 + a_3\\cos\\theta_3$: these are the factors.",
                        r"\begin{bmatrix} L \\ a_3 \end{bmatrix} = f \begin{bmatrix} \cos\beta \\ \sin\beta \end{bmatrix}",
                    ),
                    Line(
                        "Square both and add: $\\beta$ goes.",
                        "L^2 + a_3^2 = f^2",
                    ),
                    Line(
                        "A length is positive.",
                        r"f = \sqrt{L^2 + a_3^2}",
                    ),
                    Line(
                        "The angle of $(L, a_3)$.",
                        r"\beta = \text{atan2}(a_3, L)",
                    ),
                ),
                {"symbols": {"r": "free", "gamma": "free", "theta_3": "free"}},
                given=(
                    "f = r",
                    r"\beta = \gamma",
                    r"L = f\cos\beta",
                    r"a_3 = f\sin\beta",
                ),
            ),
            right=(forearm, FOREARM, WithSympy(_forearm_sympy)),
            wrong=(
                Wrong(
                    lambda a_3, L: [np.sqrt(L**2 + a_3**2), np.arctan2(L, a_3)],
                    "the arguments are exchanged: at a_3 = 0 the angle β must be zero",
                    own=True,
                ),
                Wrong(
                    lambda a_3, L: [L + a_3, np.arctan2(a_3, L)],
                    "the two parts are at right angles: Pythagoras",
                    own=True,
                ),
                Wrong(
                    lambda a_3, L: [np.sqrt(L**2 + a_3**2), -np.arctan2(a_3, L)],
                    "the sign of β: a_3 stands beside the cosine with a plus",
                    own=True,
                ),
                Wrong(lambda a_3, L: [L**2 + a_3**2, np.arctan2(a_3, L)], "this is f squared", own=True),
            ),
        ),
        Task(
            name="elbow_angle",
            title="Joint 3",
            text="Solve $f\\sin(\\theta_3 + \\beta) = K$ for $\\theta_3$ (rad), with $\\cos(\\theta_3 + \\beta) \\ge 0$: in `K`, `f`, `beta`.",
            asks=Formula(
                ELBOW_ANGLE,
                ("K", "f", "beta"),
                given={"K": r"f\sin(3\gamma)"},
                symbols={"gamma": "free"},
                unit="rad",
            ),
            hints=(
                "The sine of $\\theta_3 + \\beta$ is $K / f$. What is its cosine?",
                "$\\sqrt{1 - K^2 / f^2}$, where it is positive; times $f$: $\\sqrt{f^2 - K^2}$.",
                "atan2 of both, less $\\beta$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The sine is known.",
                        r"\sin(\theta_3 + \beta) = \frac{K}{f}",
                    ),
                    Line(
                        "Pythagoras gives the square of the cosine.",
                        r"f^2 \cos^2(\theta_3 + \beta) = f^2 - K^2",
                    ),
                    Line(
                        "The cosine is not negative: the root with the plus.",
                        r"f \cos(\theta_3 + \beta) = \sqrt{f^2 - K^2}",
                    ),
                    Line(
                        "Sine and cosine, both times $f$, give the angle; the sine first.",
                        r"\theta_3 + \beta = \text{atan2}(K, \sqrt{f^2 - K^2})",
                    ),
                    Line(
                        "Take $\\beta$ away.",
                        r"\theta_3 = \text{atan2}(K, \sqrt{f^2 - K^2}) - \beta",
                    ),
                ),
                {"symbols": {"rho": "free", "beta": "free", "t": "free"}},
                given=(
                    r"f = \rho",
                    r"\theta_3 = \arctan t - \beta",
                    r"K = f \sin(\theta_3 + \beta)",
                ),
            ),
            right=(elbow_angle, ELBOW_ANGLE, WithSympy(_elbow_angle_sympy)),
            wrong=(
                Wrong(
                    lambda K, f, beta: np.arctan2(K, -np.sqrt(f**2 - K**2)) - beta,
                    "this is the other elbow: the cosine is asked not to be negative",
                    own=True,
                ),
                Wrong(
                    lambda K, f, beta: np.arctan2(np.sqrt(f**2 - K**2), K) - beta,
                    "the arguments are exchanged: K is the sine, and stands first",
                    own=True,
                ),
                Wrong(
                    lambda K, f, beta: np.arctan2(K, np.sqrt(f**2 - K**2)) + beta,
                    "β is added to θ_3 in the equation: take it away at the end",
                    own=True,
                ),
                Wrong(
                    lambda K, f, beta: np.arctan2(K, np.sqrt(f**2 - K**2)),
                    "this is θ_3 + β: β is still to be taken away",
                    own=True,
                ),
                Wrong(
                    lambda K, f, beta: K / f - beta,
                    "K / f is the sine of θ_3 + β, not yet the angle: the arcsine, or atan2, is missing",
                    own=True,
                ),
            ),
        ),
        Task(
            name="shoulder",
            title="Joint 2",
            text="With $\\theta_3$ known, $m = a_2 - L S_3 - a_3 C_3$ and $n = L C_3 - a_3 S_3$ are known, and $x = m S_2 + n C_2$, $y = m C_2 - n S_2$. Write"
            " $\\theta_2$ (rad, up to whole turns) in `x`, `y`, `m`, `n`, in all quadrants.",
            asks=Formula(SHOULDER, ("x", "y", "m", "n"), given=_TURNED, symbols=_FREE, unit="rad"),
            hints=(
                "$(m, n)$ is where the centre would be, up and out, at $\\theta_2 = 0$.",
                "$\\theta_2$ counts from the vertical, forward: so the angle of the centre is $\\text{atan2}(x, y)$, x first.",
                "Take the angle $\\text{atan2}(n, m)$ at zero from it.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Write $(m, n)$, up and out, with its length $r$ and its angle $\\alpha$ from the vertical.",
                        r"\begin{bmatrix} n \\ m \end{bmatrix} = r \begin{bmatrix} \sin\alpha \\ \cos\alpha \end{bmatrix}",
                    ),
                    Line(
                        "Put this into $x$.",
                        r"x = r (\sin\theta_2 \cos\alpha + \cos\theta_2 \sin\alpha)",
                    ),
                    Line(
                        "The sine of a sum.",
                        r"x = r \sin(\theta_2 + \alpha)",
                    ),
                    Line(
                        "In the same way $y$ is a cosine.",
                        r"y = r \cos(\theta_2 + \alpha)",
                    ),
                    Line(
                        "So the angle of the centre, from the vertical, is the sum.",
                        r"\text{atan2}(x, y) = \theta_2 + \alpha",
                    ),
                    Line(
                        "The angle at $\\theta_2 = 0$ is known.",
                        r"\alpha = \text{atan2}(n, m)",
                    ),
                    Line(
                        "Take it away.",
                        r"\theta_2 = \text{atan2}(x, y) - \text{atan2}(n, m)",
                    ),
                ),
                {"symbols": {"r": "free", "beta": "free", "gamma": "free"}},
                given=(
                    r"\alpha = \beta",
                    r"\theta_2 = \gamma",
                    r"m = r\cos\alpha",
                    r"n = r\sin\alpha",
                    r"x = m\sin\theta_2 + n\cos\theta_2",
                    r"y = m\cos\theta_2 - n\sin\theta_2",
                ),
            ),
            right=(shoulder, SHOULDER, _shoulder_by_one_arc),
            wrong=(
                Wrong(
                    lambda x, y, m, n: np.arctan2(y, x) - np.arctan2(n, m),
                    "this counts from the horizontal: θ_2 counts from the vertical, so x is first",
                    own=True,
                ),
                Wrong(
                    lambda x, y, m, n: np.arctan2(x, y) + np.arctan2(n, m),
                    "the angle at θ_2 = 0 is taken away, not added",
                    own=True,
                ),
                Wrong(
                    lambda x, y, m, n: np.arctan2(x, y) - np.arctan2(m, n),
                    "m and n are exchanged: at θ_2 = 0 the height is m",
                    own=True,
                ),
                Wrong(
                    lambda x, y, m, n: np.arctan2(x, y),
                    "the direction of the centre is not θ_2 yet: the forearm adds its angle",
                    own=True,
                ),
                Wrong(
                    lambda x, y, m, n: np.arctan(x / y) - np.arctan(n / m),
                    "arctan of a quotient loses the quadrant: take atan2",
                    own=True,
                ),
            ),
        ),
        Task(
            name="wrist",
            title="The wrist",
            text="Three angles are known, so ${}^3R_6$ is, with the first column $[C_5,\\ S_4 S_5,\\ -C_4 S_5]^T$ and the first row $C_5,\\ S_5 S_6,\\ S_5 C_6$."
            " Write $\\theta_4$, $\\theta_5$, $\\theta_6$ (3 rows, rad) for $S_5 > 0$, in its entries `r_11`, `r_12`, `r_13`, `r_21`, `r_31`.",
            asks=Formula(
                WRIST,
                ("r_11", "r_12", "r_13", "r_21", "r_31"),
                given=_ENTRIES,
                symbols=_FREE,
                unit="rad",
            ),
            hints=(
                "$\\theta_4$ is in the first column, $\\theta_6$ in the first row; each has the factor $S_5 > 0$ twice.",
                "Mind the minus of $-C_4 S_5$.",
                "$S_5 = \\sqrt{r_{21}^2 + r_{31}^2}$, $C_5 = r_{11}$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The three turns of the wrist, in the forearm's frame: the first column has $\\theta_4$ and $\\theta_5$.",
                        r"R_x(\theta_4) R_y(\theta_5) R_x(\theta_6) \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} = \begin{bmatrix} \cos\theta_5 \\ \sin\theta_4 \sin\theta_5 \\ -\cos\theta_4 \sin\theta_5 \end{bmatrix}",
                    ),
                    Line(
                        "Mind the minus, and $\\theta_4$ is the angle of $(-r_{31}, r_{21})$: the common factor is positive.",
                        r"\theta_4 = \text{atan2}(r_{21}, -r_{31})",
                    ),
                    Line(
                        "That factor is the length of the same two entries.",
                        r"\sin\theta_5 = \sqrt{r_{21}^2 + r_{31}^2}",
                    ),
                    Line(
                        "With the cosine above them it gives the second angle.",
                        r"\theta_5 = \text{atan2}(\sqrt{r_{21}^2 + r_{31}^2}, r_{11})",
                    ),
                    Line(
                        "The first row has $\\theta_5$ and $\\theta_6$.",
                        r"\begin{bmatrix} 1 & 0 & 0 \end{bmatrix} R_x(\theta_4) R_y(\theta_5) R_x(\theta_6) = \begin{bmatrix} \cos\theta_5 & \sin\theta_5 \sin\theta_6 & \sin\theta_5 \cos\theta_6 \end{bmatrix}",
                    ),
                    Line(
                        "Its last two entries, in the same way.",
                        r"\theta_6 = \text{atan2}(r_{12}, r_{13})",
                    ),
                ),
                {"symbols": {"l": "free", "beta": "free", "gamma": "free"}},
                given=(
                    r"\theta_5 = 2 \arctan l",
                    r"\theta_4 = \beta",
                    r"\theta_6 = \gamma",
                    r"r_{11} = \cos\theta_5",
                    r"r_{12} = \sin\theta_5 \sin\theta_6",
                    r"r_{13} = \sin\theta_5 \cos\theta_6",
                    r"r_{21} = \sin\theta_4 \sin\theta_5",
                    r"r_{31} = -\cos\theta_4 \sin\theta_5",
                ),
            ),
            right=(wrist, WRIST, _wrist_with_the_row, _wrist_by_arccos),
            wrong=(
                Wrong(
                    lambda r_11, r_12, r_13, r_21, r_31: wrist(r_11, r_12, r_13, r_21, -r_31),
                    "the minus of −C_4 S_5 is lost: θ_4 is mirrored",
                    own=True,
                ),
                Wrong(
                    lambda r_11, r_12, r_13, r_21, r_31: [
                        np.arctan2(-r_21, r_31),
                        -np.arctan2(np.sqrt(r_21**2 + r_31**2), r_11),
                        np.arctan2(-r_12, -r_13),
                    ],
                    "this is the wrist turned over, with S_5 < 0: a solution, but not the one asked for",
                    own=True,
                ),
                Wrong(
                    lambda r_11, r_12, r_13, r_21, r_31: wrist(r_11, r_13, r_12, r_21, r_31),
                    "the arguments of θ_6 are exchanged: S_5 S_6 is first",
                    own=True,
                ),
                Wrong(
                    lambda r_11, r_12, r_13, r_21, r_31: wrist(r_11, r_12, r_13, r_21, r_31)[::-1],
                    "the rows are in the reverse order",
                    own=True,
                ),
                Wrong(
                    lambda r_11, r_12, r_13, r_21, r_31: [
                        np.arctan2(r_21, -r_31),
                        np.arcsin(np.sqrt(r_21**2 + r_31**2)),
                        np.arctan2(r_12, r_13),
                    ],
                    "entry (2, 1): the sine is right, the angle is not: `arcsin` gives no angle beyond a quarter turn",
                ),
            ),
        ),
        Task(
            name="count",
            title="How many postures?",
            text="Joint limits aside, and the centre well within reach: how many postures bring the gripper to one pose?",
            asks=Number(8, steps=(r"2 \cdot 2 \cdot 2",), beside=("2 + 2 + 1", r"8 \cdot 3", "2^3 + 2")),
            hints=(
                "How many signs have you chosen on the way?",
                "The arm may face the centre or reach back; the elbow has two sides; the wrist may be turned over.",
                "Two times two times two.",
            ),
            right=(8, "8", 8.0),
            wrong=(
                Wrong(1, "shoulder, elbow and wrist can each be on two sides", own=True),
                Wrong(2, "there are three choices with two sides each", own=True),
                Wrong(4, "one choice is missing: shoulder, elbow and wrist", own=True),
                Wrong(6, "the choices multiply: two times two times two", own=True),
                Wrong(16, "three choices, not four: θ_2, θ_4 and θ_6 follow from the others", own=True),
                Wrong(3, "these are the choices; each has two sides, and they multiply", own=True),
                Wrong(9, "three choices with two sides each make 2³, not 3²", own=True),
                Wrong(12, "each choice has two sides: 2 · 2 · 2, without a three", own=True),
                Wrong(64, "not every joint has a choice of its own: three choices decide all six", own=True),
                Wrong(
                    32,
                    "three choices, not five: once shoulder, elbow and wrist are chosen, all angles follow",
                    own=True,
                ),
                Wrong(7, "the posture that you have counts, too", own=True),
                Wrong(0, "the gripper's pose is given and within reach: there are postures", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A turret turns by $\\theta_1$; at the height $h$ its ram is raised by $\\theta_2$ and goes out by $d_3 > 0$: its end is at"
            " $[d_3 C_1 C_2,\\ d_3 S_1 C_2,\\ h + d_3 S_2]^T$. For a point $[p_x, p_y, p_z]^T$ write $[\\theta_1, \\theta_2, d_3]$ of the turret that faces it,"
            " $\\cos\\theta_2 > 0$: 3 rows in `p_x`, `p_y`, `p_z`, `h`, in all quadrants.",
            asks=Formula(TURRET, ("p_x", "p_y", "p_z", "h"), given=_TARGET, symbols={"rho": "free", "gamma": "free"}),
            hints=(
                "As for the KR210: first turn to face the point, then look at the vertical plane.",
                "In that plane the point is $\\sqrt{p_x^2 + p_y^2}$ out and $p_z - h$ up.",
                "Length and angle of that vector are $d_3$ and $\\theta_2$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Seen from above: the ram goes out by $d_3\\cos\\theta_2$, in the direction $\\theta_1$.",
                        r"\begin{bmatrix} p_x \\ p_y \end{bmatrix} = d_3 \cos\theta_2 \begin{bmatrix} \cos\theta_1 \\ \sin\theta_1 \end{bmatrix}",
                    ),
                    Line(
                        "That factor is positive: the angle from above.",
                        r"\theta_1 = \text{atan2}(p_y, p_x)",
                    ),
                    Line(
                        "And it is the distance from axis 1.",
                        r"d_3 \cos\theta_2 = \sqrt{p_x^2 + p_y^2}",
                    ),
                    Line(
                        "In the vertical plane the ram goes up by the rest of the height.",
                        r"d_3 \sin\theta_2 = p_z - h",
                    ),
                    Line(
                        "The angle there.",
                        r"\theta_2 = \text{atan2}(p_z - h, \sqrt{p_x^2 + p_y^2})",
                    ),
                    Line(
                        "And the length.",
                        r"d_3 = \sqrt{p_x^2 + p_y^2 + (p_z - h)^2}",
                    ),
                ),
                {"symbols": {"h": "free", "l": "free", "gamma": "free", "t": "free"}},
                given=(
                    r"\theta_1 = \gamma",
                    r"\theta_2 = \arctan t",
                    "d_3 = l",
                    r"p_x = d_3 \cos\theta_1 \cos\theta_2",
                    r"p_y = d_3 \sin\theta_1 \cos\theta_2",
                    r"p_z = h + d_3 \sin\theta_2",
                ),
            ),
            right=(turret, TURRET, _turret_by_norm),
            wrong=(
                Wrong(
                    lambda p_x, p_y, p_z, h: [np.arctan2(p_x, p_y), *turret(p_x, p_y, p_z, h)[1:]],
                    "atan2 takes the sine's side first: y, then x",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, h: turret(p_x, p_y, p_z, 0),
                    "the height h of the shoulder is missing: take it from p_z",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, h: [*turret(p_x, p_y, p_z, h)[:2], np.sqrt(p_x**2 + p_y**2)],
                    "this is how far out the point is: the ram goes up too",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, h: [np.arctan(p_y / p_x), *turret(p_x, p_y, p_z, h)[1:]],
                    "arctan of a quotient cannot tell opposite quadrants apart: take atan2",
                    own=True,
                ),
                Wrong(
                    lambda p_x, p_y, p_z, h: [
                        turret(p_x, p_y, p_z, h)[0],
                        np.arctan2(p_z - h, p_x),
                        turret(p_x, p_y, p_z, h)[2],
                    ],
                    "the angle θ_2 is seen in the vertical plane: the side along the floor is √(p_x² + p_y²), not p_x",
                    own=True,
                ),
            ),
        ),
    ),
)
