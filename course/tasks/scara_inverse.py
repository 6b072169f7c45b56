"""Tasks of lesson 14, the inverse kinematics of the SCARA on a column (A. Beneult Lefaucheux, TD 1, 2014)."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Quantity, Task, WithSympy, Wrong
from armproof.course.feedback.answer import is_function, is_missing
from armproof.course.feedback.notebook import Shown
from armproof.models.errors import written
from armproof.models.language import look_up

ARM = "scara_column"
_REACHED = {"X": r"a_1 C_1 + a_2 C_{12}", "Y": r"a_1 S_1 + a_2 S_{12}"}
_REST = {"Z": "d_1 - d_3 - d_4", "psi": r"\theta_1 + \theta_2 - \theta_4"}
_TURNED = {  # two vectors of one length in any directions; the factors take the angles through several turns
    "X": r"\rho\cos(5\beta + 3\gamma)",
    "Y": r"\rho\sin(5\beta + 3\gamma)",
    "k_1": r"\rho\cos(3\gamma)",
    "k_2": r"\rho\sin(3\gamma)",
}
_TARGETS = (
    {"X": 0.5, "Y": 0.2, "a_1": 0.4, "a_2": 0.3},
    {"X": 0.2, "Y": 0.4, "a_1": 0.4, "a_2": 0.3},
)  # m, within the ring
_COSINE = r"\frac{X^2 + Y^2 - a_1^2 - a_2^2}{2 a_1 a_2}"
_ROOM = r"\left( (a_1 + a_2)^2 - X^2 - Y^2 \right) \left( X^2 + Y^2 - (a_1 - a_2)^2 \right)"
_ANGLE = r"\text{atan2}(Y, X) - \text{atan2}(k_2, k_1)"


def show_inverse(inverse: Any, X: float, Y: float, Z: float, psi: float) -> Any:
    """Return a picture of a student's solution over the postures that Drake's arm has at a target, or a polite sentence.

    Args:
        inverse: the answer to the task `inverse`.
        X, Y, Z: the target of the tool in frame 0 (m).
        psi: the tool's angle about the vertical (rad).
    """
    if is_missing(inverse) or not is_function(inverse):
        return Shown(written("`{task}`: no function yet, nothing to draw.", task="inverse"))
    from armproof.models.catalogue import load_arm

    arm = load_arm(ARM)
    lengths = [arm.lengths[name] for name in ("a_1", "a_2", "d_1", "d_4")]
    try:
        with np.errstate(all="ignore"):
            q = np.array(inverse(X, Y, Z, psi, *lengths), dtype=float).ravel()
    except Exception as problem:
        return Shown(written("`{task}`: the function stops with {type}: {reason}", task="inverse", type=type(problem).__name__, reason=str(problem)))  # fmt: skip
    if q.shape == (1,) and np.isnan(q).all():  # what None becomes
        return Shown(written("`{task}`: no answer yet, nothing to draw.", task="inverse"))
    if q.shape != (4,) or not np.isfinite(q).all():
        return Shown(
            written(
                "`inverse`: nothing to draw; this takes four joint values, and yours are {q}. Is the target within reach?",
                q=str(q),
            )
        )
    return _draw(arm, q, np.array([X, Y, Z, psi]))


def _draw(arm, q, target):
    """Draw the answer in full over the two postures of the closed form, pale, seen from above."""
    from armproof.course.figures.drawing.fitting import Fit
    from armproof.course.figures.drawing.scene import finish
    from armproof.course.figures.drawing.style import GREY, STROKES, new_figure, styled
    from armproof.course.inverse import inverse_of
    from armproof.models.showing.projection import plane_projection
    from armproof.models.showing.skeleton import stick_points

    solved = inverse_of(ARM).solve(target[None])
    right = solved.q[0][solved.valid[0]]
    with styled():
        figure = new_figure("column", 72.0)
        shown = np.vstack([q[None], right])
        at = np.array([*target[:2], 0.0])
        scene = Fit(arm, shown, plane_projection(arm), at[None], margin=9.0).scene(figure, (0.0, 0.0, 84.0, 72.0))
        for k, posture in enumerate(right):
            scene.line(stick_points(arm, posture, "4"), gid=f"drake {k + 1}", color=GREY, linewidth=5.0, alpha=0.3)
        stroke = STROKES[1]
        points = stick_points(arm, q, "4")
        scene.line(points, gid="answer", color=stroke.colour, linewidth=1.4, marker="o", markersize=4, zorder=5)
        scene.circle(scene.paper(at), 1.6, zorder=8, facecolor="none", edgecolor=GREY, linewidth=1.0)
        scene.label(look_up("target"), scene.paper(at), gap=2.4)
        scene.label(look_up("your answer"), scene.paper(points[1:3].mean(axis=0)), colour=stroke.colour, gap=1.5)
        return finish(figure, scene)


def position(q, a_1, a_2, d_1, d_4):
    """Return X, Y and Z of the tool."""
    theta_1, theta_2, d_3, _ = q
    X = a_1 * np.cos(theta_1) + a_2 * np.cos(theta_1 + theta_2)
    Y = a_1 * np.sin(theta_1) + a_2 * np.sin(theta_1 + theta_2)
    return np.array([X, Y, d_1 - d_3 - d_4])


def slide(Z, d_1, d_4):
    """Return d_3 from the height of the tool."""
    return d_1 - d_4 - Z


def cosine(X, Y, a_1, a_2):
    """Return the cosine of the elbow's angle, by the law of cosines."""
    return (X**2 + Y**2 - a_1**2 - a_2**2) / (2 * a_1 * a_2)


def room(X, Y, a_1, a_2):
    """Return the distances to both limits, multiplied."""
    far, near = (a_1 + a_2) ** 2, (a_1 - a_2) ** 2
    return (far - X**2 - Y**2) * (X**2 + Y**2 - near)


def shoulder(X, Y, k_1, k_2):
    """Return θ_1: the direction of the target less the angle that the elbow adds."""
    return np.arctan2(Y, X) - np.arctan2(k_2, k_1)


def wrist(theta_1, theta_2, psi):
    """Return θ_4: the tool points down, so that its own joint counts against the others."""
    return theta_1 + theta_2 - psi


def inverse(X, Y, Z, psi, a_1, a_2, d_1, d_4):
    """Return [θ_1, θ_2, d_3, θ_4] of the posture whose θ_2 is not negative."""
    theta_2 = np.arccos((X**2 + Y**2 - a_1**2 - a_2**2) / (2 * a_1 * a_2))
    k_1 = a_1 + a_2 * np.cos(theta_2)
    k_2 = a_2 * np.sin(theta_2)
    theta_1 = np.arctan2(Y, X) - np.arctan2(k_2, k_1)
    return np.array([theta_1, theta_2, d_1 - d_4 - Z, theta_1 + theta_2 - psi])


def _position_with_sympy(sp):
    t1, t2, d3, a1, a2, d1, d4 = sp.symbols("theta_1 theta_2 d_3 a_1 a_2 d_1 d_4")
    return sp.Matrix([a1 * sp.cos(t1) + a2 * sp.cos(t1 + t2), a1 * sp.sin(t1) + a2 * sp.sin(t1 + t2), d1 - d3 - d4])


def _cosine_with_sympy(sp):
    X, Y, a1, a2 = sp.symbols("X Y a_1 a_2")
    return sp.expand((X**2 + Y**2 - a1**2 - a2**2) / (2 * a1 * a2))


def _room_with_sympy(sp):
    X, Y, a1, a2 = sp.symbols("X Y a_1 a_2")
    return sp.expand(4 * a1**2 * a2**2 - (X**2 + Y**2 - a1**2 - a2**2) ** 2)


def _room_as_product(X, Y, a_1, a_2):
    r = np.sqrt(X**2 + Y**2)
    return (a_1 + a_2 - r) * (a_1 + a_2 + r) * (r - a_1 + a_2) * (r + a_1 - a_2)


def _shoulder_by_one_arc(X, Y, k_1, k_2):
    return np.arctan2(k_1 * Y - k_2 * X, k_1 * X + k_2 * Y)


def _shoulder_by_arctan(X, Y, k_1, k_2):
    return np.arctan(Y / X) - np.arctan(k_2 / k_1)


INVERSE = (
    rf"""\begin{{bmatrix}} {_ANGLE} \\ \arccos D \\ d_1 - d_4 - Z \\ {_ANGLE} + \arccos D - \psi \end{{bmatrix}}"""
)
_INVERSE_LONG = (
    INVERSE.replace("k_2", r"a_2\sqrt{1-D^2}").replace("k_1", "(a_1 + a_2 D)").replace("D", f"\\left({_COSINE}\\right)")
)


def _inverse_with_elbow(X, Y, Z, psi, a_1, a_2, d_1, d_4):
    c = cosine(X, Y, a_1, a_2)
    s = np.sqrt(1 - c**2)
    theta_2 = np.arctan2(s, c)
    theta_1 = np.arctan2((a_1 + a_2 * c) * Y - a_2 * s * X, (a_1 + a_2 * c) * X + a_2 * s * Y)
    return [theta_1, theta_2, d_1 - Z - d_4, theta_1 + theta_2 - psi]


def _spoiled(row, change):
    """Return the solution with one joint changed."""

    def spoiled(X, Y, Z, psi, a_1, a_2, d_1, d_4):
        q = list(inverse(X, Y, Z, psi, a_1, a_2, d_1, d_4))
        q[row] = change(q, psi)
        return q

    return spoiled


def _without_elbow(X, Y, Z, psi, a_1, a_2, d_1, d_4):
    theta_2 = np.arccos(cosine(X, Y, a_1, a_2))
    theta_1 = np.arctan2(Y, X)
    return [theta_1, theta_2, d_1 - d_4 - Z, theta_1 + theta_2 - psi]


def _by_arctan(X, Y, Z, psi, a_1, a_2, d_1, d_4):
    theta_1, theta_2, d_3, theta_4 = inverse(X, Y, Z, psi, a_1, a_2, d_1, d_4)
    error = np.arctan(Y / X) - np.arctan2(Y, X)
    return [theta_1 + error, theta_2, d_3, theta_4 + error]


_OTHER_SIGN = (
    r"\begin{bmatrix} \text{atan2}(Y, X) + \text{atan2}(k_2, k_1) \\ -\arccos D \\ d_1 - d_4 - Z \\ "
    r"\text{atan2}(Y, X) + \text{atan2}(k_2, k_1) - \arccos D - \psi \end{bmatrix}"
)

# -- an arm that nobody has seen -----------------------------------------------------------------------------------------


def ram(X, Y):
    """Return how far the ram is out."""
    return np.sqrt(X**2 + Y**2)


def _ram_sympy(sp):
    X, Y = sp.symbols("X Y")
    return sp.sqrt(X**2 + Y**2)


LESSON = Lesson(
    number=14,
    name="scara_inverse",
    title="SCARA: inverse kinematics in two postures",
    source="A. Beneult Lefaucheux, TD 1, Étude du robot Scara, 2014",
    objectives=(
        "Solve the position equations for the four joints, one joint at a time.",
        "Count the solutions of a target from one sign, before solving anything.",
        "Say what happens at the limits of the workspace, and for a target on the first axis.",
    ),
    tasks=(
        Task(
            name="predict",
            title="How many postures?",
            text="The tool covers a ring about the first axis. How many postures $(\\theta_1, \\theta_2)$ bring it above a point $(X, Y)$ that lies "
            "(1) inside the ring, not on its edges, (2) on the outer circle, (3) beyond that? Give the three numbers in this order; joint limits "
            "do not count.",
            asks=Number(
                (2, 1, 0),
                labels=("the number inside the ring", "the number on the outer circle", "the number beyond it"),
                beside=("[2 + 1, ,]",),
            ),
            hints=(
                "Draw two circles: one of radius $a_1$ about the first axis, one of radius $a_2$ about the target. The elbow is on both.",
                "In how many points can two circles meet, and when do they touch?",
                "They meet in two points, touch in one when the arm is stretched, and miss each other when the target is too far.",
            ),
            right=([2, 1, 0], "2, 1, 0", np.array([2.0, 1.0, 0.0])),
            wrong=(
                Wrong([2, 2, 0], "stretched, the elbow cannot be on either side: +0 and -0 are one angle", own=True),
                Wrong([1, 1, 0], "inside the ring there is an elbow on each side of the line to the target", own=True),
                Wrong([2, 1, 1], "no posture reaches a point beyond the outer circle", own=True),
                Wrong([2, 1, 2], "an arccos of more than 1 has no value, with either sign", own=True),
                Wrong([4, 2, 0], "two elbows, not four"),
                Wrong(2, "3 numbers"),
                Wrong([4, 1, 0], "two elbows, not four: the arm has no wrist that could be turned over", own=True),
                Wrong([8, 1, 0], "eight has an arm of six joints: here the elbow alone has two sides", own=True),
                Wrong([2, 0, 0], "the stretched arm reaches the outer circle, in one way", own=True),
                Wrong(
                    [1, 1, 1],
                    "the arm reaches no point beyond the outer circle, and inside the ring two elbows lead to it",
                    own=True,
                ),
            ),
        ),
        Task(
            name="position",
            title="The equations to solve",
            text="Give the position $(X, Y, Z)$ of the origin of frame 4 in frame 0 as three numbers, in $\\theta_1, \\theta_2, d_3$ and the "
            "lengths $a_1, a_2, d_1, d_4$ (m): the last column of $H_1 H_2 H_3 H_4$. A function takes `q` $= [\\theta_1, \\theta_2, d_3, \\theta_4]$.",
            asks=Quantity(ARM, {"origin": 4}),
            hints=(
                "Multiply from the right: only the last column is needed, so start with that of $H_4$, $[0, 0, d_4, 1]^T$.",
                "$H_3 H_4$ moves it to $[0, 0, d_3 + d_4, 1]^T$. $H_2$ turns z over: its third row is $[0, 0, -1, 0]$.",
                "After $H_2$ it is $[a_2 C_2, a_2 S_2, -d_3 - d_4, 1]^T$. $H_1$ turns this by $\\theta_1$, moves it by $a_1$ along the first arm and up by $d_1$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The slide and the tool hang along one axis.",
                        r"{}^2T_4 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} 0 \\ 0 \\ d_3 + d_4 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "The second arm turns that axis over.",
                        r"{}^1T_4 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} a_2 C_2 \\ a_2 S_2 \\ -d_3 - d_4 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "The first arm turns all of it by $\\theta_1$ and lifts it by $d_1$.",
                        r"{}^0T_4 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} a_1 C_1 + a_2 (C_1 C_2 - S_1 S_2) \\ a_1 S_1 + a_2 (S_1 C_2 + C_1 S_2) \\ d_1 - d_3 - d_4 \\ 1 \end{bmatrix}",
                    ),
                    Line(
                        "Cosine and sine of a sum.",
                        r"p_4 = \begin{bmatrix} a_1 C_1 + a_2 C_{12} \\ a_1 S_1 + a_2 S_{12} \\ d_1 - d_3 - d_4 \end{bmatrix}",
                    ),
                ),
                {"arm": "scara_column"},
            ),
            right=(
                position,
                r"\begin{bmatrix} a_1 C_1 + a_2 C_{12} \\ a_1 S_1 + a_2 S_{12} \\ d_1 - d_3 - d_4 \end{bmatrix}",
                WithSympy(_position_with_sympy),
            ),
            wrong=(
                Wrong(
                    lambda q, a_1, a_2, d_1, d_4: [
                        a_1 * np.cos(q[0]) + a_2 * np.cos(q[1]),
                        a_1 * np.sin(q[0]) + a_2 * np.sin(q[1]),
                        d_1 - q[2] - d_4,
                    ],
                    "absolute",
                ),
                Wrong(lambda q, a_1, a_2, d_4: [*position(q, a_1, a_2, 0, d_4)], "d_1"),
                Wrong(lambda q, a_1, a_2, d_1, d_4: [*position(q, a_1, a_2, d_1, d_4)[:2], d_1 + q[2] - d_4], "sign"),
                Wrong(lambda q, a_1, a_2, d_1, d_4: position(q, a_2, a_1, d_1, d_4), "swapped"),
                Wrong(lambda q, a_1, a_2, d_1, d_4: position(np.deg2rad(q), a_1, a_2, d_1, d_4), "degrees"),
                Wrong(
                    r"\begin{bmatrix} a_1 C_1 + a_2 C_{12} \\ a_1 S_1 + a_2 S_{12} \\ d_1 - d_3 \end{bmatrix}", "d_4"
                ),
            ),
        ),
        Task(
            name="slide",
            title="The slide",
            text="Solve the third equation for $d_3$ (m), in $Z$, $d_1$ and $d_4$; a function takes `(Z, d_1, d_4)`.",
            asks=Formula("d_1 - d_4 - Z", ("Z", "d_1", "d_4"), arm=ARM, unit="m", cases=({"Z": 0.23},)),
            hints=(
                "No other joint enters $Z$, so this is one linear equation.",
                "Bring $d_3$ to the left of $Z = d_1 - d_3 - d_4$.",
                "The lower the tool, the larger $d_3$: $Z$ must come with a minus sign.",
            ),
            right=(
                slide,
                "d_1 - d_4 - Z",
                WithSympy(lambda sp: sp.Symbol("d_1") - (sp.Symbol("Z") + sp.Symbol("d_4"))),
            ),
            wrong=(
                Wrong("Z - d_1 + d_4", "a lower tool needs a longer slide: this d_3 has the opposite sign", own=True),
                Wrong("d_1 + d_4 - Z", "sign"),
                Wrong("d_1 - Z", "missing"),
                Wrong(lambda Z, d_1, d_4: -d_4 - Z, "missing"),
                Wrong(
                    "d_1 + d_4 + Z",
                    "bringing a term to the other side changes its sign: both Z and d_4 have kept theirs",
                    own=True,
                ),
            ),
        ),
        Task(
            name="elbow",
            title="The elbow",
            text="Give $\\cos\\theta_2$ in $X, Y, a_1, a_2$ alone; a function takes `(X, Y, a_1, a_2)`.",
            asks=Formula(_COSINE, ("X", "Y", "a_1", "a_2"), cases=_TARGETS),
            hints=(
                "Look for a combination of $X$ and $Y$ that $\\theta_1$ does not change.",
                "Square and add: $X^2 + Y^2$. With $C_1 C_{12} + S_1 S_{12} = C_2$ only one cosine is left.",
                "$X^2 + Y^2 = a_1^2 + a_2^2 + 2 a_1 a_2 \\cos\\theta_2$.",
            ),
            derivation=Derivation(
                (
                    Line("The first equation.", r"X = a_1 C_1 + a_2 C_{12}"),
                    Line("The second.", r"Y = a_1 S_1 + a_2 S_{12}"),
                    Line(
                        "Square both and add: $\\theta_1$ is left in one bracket only.",
                        r"X^2 + Y^2 = a_1^2 + a_2^2 + 2 a_1 a_2 (C_1 C_{12} + S_1 S_{12})",
                    ),
                    Line("That bracket is a cosine of a difference.", r"C_1 C_{12} + S_1 S_{12} = C_2"),
                    Line("So $\\theta_1$ is gone.", r"X^2 + Y^2 = a_1^2 + a_2^2 + 2 a_1 a_2 C_2"),
                    Line("Solve for the cosine.", r"\cos\theta_2 = \frac{X^2 + Y^2 - a_1^2 - a_2^2}{2 a_1 a_2}"),
                ),
                {
                    "arm": "scara_column",
                    "quantities": {"X": {"origin": 4, "component": "x"}, "Y": {"origin": 4, "component": "y"}},
                },
            ),
            right=(
                cosine,
                _COSINE,
                WithSympy(_cosine_with_sympy),
                r"\frac{(X^2 + Y^2 - (a_1 - a_2)^2) - 2 a_1 a_2}{2 a_1 a_2}",
            ),
            wrong=(
                Wrong(
                    r"\frac{a_1^2 + a_2^2 - X^2 - Y^2}{2 a_1 a_2}",
                    "this is the cosine of the angle inside the triangle, π minus θ_2",
                    own=True,
                ),
                Wrong(r"\frac{X^2 + Y^2 - a_1^2 + a_2^2}{2 a_1 a_2}", "sign"),
                Wrong(
                    r"\frac{X^2 + Y^2 - a_1^2 - a_2^2}{a_1 a_2}",
                    "the cross term of a square has a factor 2, and it goes below the line",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, a_1, a_2: np.arccos(cosine(X, Y, a_1, a_2)),
                    "this is the angle; what is asked is its cosine",
                    own=True,
                ),
                Wrong(
                    lambda *of: np.clip(cosine(*of), -1, 1),
                    "beyond the limits there is no θ_2, and clipping hides that: give the formula alone",
                    own=True,
                ),
                Wrong(
                    r"\frac{\sqrt{X^2 + Y^2} - a_1^2 - a_2^2}{2 a_1 a_2}",
                    "the squared distance is X^2 + Y^2, without a root",
                    own=True,
                ),
                Wrong(
                    r"\frac{X^2 + Y^2 - (a_1 + a_2)^2}{2 a_1 a_2}",
                    "(a_1 + a_2)^2 is more than a_1^2 + a_2^2: this is cos(θ_2) - 1",
                    own=True,
                ),
            ),
        ),
        Task(
            name="reach",
            title="The sign that counts the postures",
            text="Give $4 a_1^2 a_2^2 \\sin^2\\theta_2$ in $X, Y, a_1, a_2$ alone; a function takes `(X, Y, a_1, a_2)`. It is positive, zero or "
            "negative where the target has two postures, one, or none.",
            asks=Formula(_ROOM, ("X", "Y", "a_1", "a_2"), unit="m⁴", cases=_TARGETS),
            hints=(
                "$\\sin^2\\theta_2 = 1 - \\cos^2\\theta_2$, and you have the cosine.",
                "Multiplied out it is $4 a_1^2 a_2^2 - (X^2 + Y^2 - a_1^2 - a_2^2)^2$: a difference of two squares.",
                "One factor is $(a_1 + a_2)^2 - X^2 - Y^2$, the room up to the outer circle. The other is the room down to the inner one.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Begin with the squared sine.",
                        r"4 a_1^2 a_2^2 \sin^2\theta_2 = 4 a_1^2 a_2^2 - (2 a_1 a_2 \cos\theta_2)^2",
                    ),
                    Line("The cosine is known.", r"2 a_1 a_2 \cos\theta_2 = X^2 + Y^2 - a_1^2 - a_2^2"),
                    Line(
                        "A difference of two squares is a product.",
                        r"4 a_1^2 a_2^2 \sin^2\theta_2 = \left( 2 a_1 a_2 + X^2 + Y^2 - a_1^2 - a_2^2 \right) \left( 2 a_1 a_2 - X^2 - Y^2 + a_1^2 + a_2^2 \right)",
                    ),
                    Line(
                        "The second factor: the room up to the outer circle.",
                        r"2 a_1 a_2 - X^2 - Y^2 + a_1^2 + a_2^2 = (a_1 + a_2)^2 - X^2 - Y^2",
                    ),
                    Line(
                        "The first factor: the room down to the inner circle.",
                        r"2 a_1 a_2 + X^2 + Y^2 - a_1^2 - a_2^2 = X^2 + Y^2 - (a_1 - a_2)^2",
                    ),
                    Line(
                        "Together.",
                        r"4 a_1^2 a_2^2 \sin^2\theta_2 = \left( (a_1 + a_2)^2 - X^2 - Y^2 \right) \left( X^2 + Y^2 - (a_1 - a_2)^2 \right)",
                    ),
                ),
                {
                    "arm": "scara_column",
                    "quantities": {"X": {"origin": 4, "component": "x"}, "Y": {"origin": 4, "component": "y"}},
                },
            ),
            right=(room, _ROOM, WithSympy(_room_with_sympy), _room_as_product),
            wrong=(
                Wrong(
                    rf"1 - \left({_COSINE}\right)^2",
                    "this is the squared sine itself, without the factor 4 a_1^2 a_2^2",
                    own=True,
                ),
                Wrong(
                    r"4 a_1^2 a_2^2 - (X^2 + Y^2 + a_1^2 + a_2^2)^2",
                    "in the cosine a_1^2 and a_2^2 are taken off the squared distance, not added",
                    own=True,
                ),
                Wrong(_ROOM.replace("(a_1 - a_2)^2", "(a_1 + a_2)^2"), "sign"),
                Wrong(
                    r"(a_1 + a_2)^2 - X^2 - Y^2",
                    "this sees the outer limit only: a target can also be too near",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, a_1, a_2: (X**2 + Y**2 - a_1**2 - a_2**2) ** 2,
                    "this is 4 a_1^2 a_2^2 times the squared cosine",
                    own=True,
                ),
                Wrong(
                    r"(a_1^2 + a_2^2 - X^2 - Y^2)(X^2 + Y^2 - (a_1 - a_2)^2)",
                    "the outer circle has the radius a_1 + a_2, whose square is not a_1^2 + a_2^2",
                    own=True,
                ),
            ),
        ),
        Task(
            name="shoulder",
            title="The shoulder",
            text="With $\\theta_2$ known, so are $k_1$ and $k_2$. Give $\\theta_1$ (rad, up to whole turns) in $X, Y, k_1, k_2$; a function takes "
            "`(X, Y, k_1, k_2)`. It must hold in all four quadrants.",
            asks=Formula(
                _ANGLE,
                ("X", "Y", "k_1", "k_2"),
                given=_TURNED,
                symbols={"rho": "free", "beta": "free", "gamma": "free"},
                unit="rad",
                cases=({"rho": 0.5, "beta": 0.1, "gamma": 0.2}, {"rho": 0.5, "beta": 0.2, "gamma": 0.6}),
            ),
            hints=(
                "$(k_1, k_2)$ is where the tool would be with $\\theta_1 = 0$. The shoulder turns this vector until it is $(X, Y)$.",
                "Turning adds angles: the angle of $(X, Y)$ is $\\theta_1$ plus the angle $\\alpha$ of $(k_1, k_2)$.",
                "The angle of $(x, y)$ in all quadrants is $\\mathrm{atan2}(y, x)$, y first. Take one from the other.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Expand the sums in $X$: what stands before $C_1$ and $S_1$?",
                        r"X = (a_1 + a_2 C_2) C_1 - a_2 S_2 S_1",
                    ),
                    Line("The same in $Y$.", r"Y = (a_1 + a_2 C_2) S_1 + a_2 S_2 C_1"),
                    Line("With $k_1 = a_1 + a_2 C_2$ and $k_2 = a_2 S_2$ this is short.", r"X = k_1 C_1 - k_2 S_1"),
                    Line(
                        "$(X, Y)$ is $(k_1, k_2)$, turned by $\\theta_1$: the angle of one is that of the other plus $\\theta_1$.",
                        r"Y = k_1 S_1 + k_2 C_1",
                    ),
                    Line("Both vectors have the same length, as they should.", r"X^2 + Y^2 = k_1^2 + k_2^2"),
                ),
                {
                    "arm": "scara_column",
                    "quantities": {"X": {"origin": 4, "component": "x"}, "Y": {"origin": 4, "component": "y"}},
                },
                ("k_1 = a_1 + a_2 C_2", "k_2 = a_2 S_2"),
            ),
            right=(
                shoulder,
                _ANGLE,
                WithSympy(lambda sp: sp.atan2(*sp.symbols("Y X")) - sp.atan2(*sp.symbols("k_2 k_1"))),
                _shoulder_by_one_arc,
            ),
            wrong=(
                Wrong(r"\text{atan2}(Y, X) + \text{atan2}(k_2, k_1)", "sign"),
                Wrong(
                    r"\text{atan2}(X, Y) - \text{atan2}(k_1, k_2)",
                    "atan2 takes y first: with x first it measures from the y axis, and clockwise",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, k_1, k_2: np.arctan2(X, Y) - np.arctan2(k_2, k_1),
                    "of the two atan2 the first has its arguments swapped: Y stands for the y",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, k_1, k_2: np.arctan2(Y - k_2, X - k_1),
                    "the angles are subtracted, not the coordinates: one atan2 of the target, less one of k",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, k_1, k_2: np.arctan2(Y, X) - np.arctan(k_2 / k_1),
                    "arctan of k_2/k_1 holds only while k_1 is positive, and with a long second link it can be negative",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, k_1, k_2: np.arctan((k_1 * Y - k_2 * X) / (k_1 * X + k_2 * Y)),
                    "the quotient is right, but arctan knows only half of the angles: take atan2",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, k_1, k_2: np.arccos((k_1 * X + k_2 * Y) / (k_1**2 + k_2**2)),
                    "the arccos loses the sign: it is the angle between the two vectors, whichever way the shoulder turns",
                    own=True,
                ),
                Wrong(
                    _shoulder_by_arctan,
                    "arctan of a quotient cannot tell opposite quadrants apart: take atan2",
                    own=True,
                ),
                Wrong(
                    r"\text{atan2}(Y, X)",
                    "this turns the stretched arm at the target; the elbow adds an angle of its own",
                    own=True,
                ),
                Wrong(
                    r"\text{atan2}(Y, X) - \text{atan2}(k_1, k_2)",
                    "of the two atan2 the second has its arguments swapped: k_2 stands for the y",
                    own=True,
                ),
            ),
        ),
        Task(
            name="wrist",
            title="The wrist",
            text="Give $\\theta_4$ (rad) in $\\theta_1, \\theta_2$ and the angle $\\psi$ of the tool; a function takes `(theta_1, theta_2, psi)`.",
            asks=Formula(
                r"\theta_1 + \theta_2 - \psi",
                ("theta_1", "theta_2", "psi"),
                arm=ARM,
                unit="rad",
                cases=({"theta_1": 0.4, "theta_2": 0.9, "psi": 0.5},),
            ),
            hints=(
                "Read $\\psi$ off the rotation: it is the angle whose cosine stands in its first entry.",
                "$\\psi = \\theta_1 + \\theta_2 - \\theta_4$. The minus sign comes from $z_3$, which points down.",
                "Solve this line for $\\theta_4$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The turns about the vertical: the last axis points down.",
                        r"{}^0R_4 = R_z(\theta_1 + \theta_2 - \theta_4) R_x(\pi)",
                    ),
                    Line(
                        "Its first column has the angle of the tool.",
                        r"{}^0R_4 \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} = \begin{bmatrix} \cos(\theta_1 + \theta_2 - \theta_4) \\ \sin(\theta_1 + \theta_2 - \theta_4) \\ 0 \end{bmatrix}",
                    ),
                    Line("Call that angle $\\psi$.", r"\psi = \theta_1 + \theta_2 - \theta_4"),
                    Line("Solve for the last joint.", r"\theta_4 = \theta_1 + \theta_2 - \psi"),
                ),
                {"arm": "scara_column"},
            ),
            right=(
                wrist,
                r"\theta_1 + \theta_2 - \psi",
                WithSympy(lambda sp: -sp.Symbol("psi") + sp.Symbol("theta_2") + sp.Symbol("theta_1")),
            ),
            wrong=(
                Wrong(
                    r"\psi - \theta_1 - \theta_2",
                    "the tool points down: θ_4 counts against θ_1 and θ_2",
                    own=True,
                ),
                Wrong(r"\theta_1 + \theta_2 + \psi", "sign"),
                Wrong(r"\theta_2 - \psi", "missing"),
                Wrong(lambda theta_1, theta_2, psi: theta_1 + theta_2, "missing"),
                Wrong(
                    r"\theta_1 + \theta_2 - \cos\psi",
                    "the angle itself is ψ, not its cosine: the brace of the document covers too much",
                    own=True,
                ),
            ),
        ),
        Task(
            name="inverse",
            title="All four joints",
            text="Write `inverse(X, Y, Z, psi, a_1, a_2, d_1, d_4)`: the joint values $[\\theta_1, \\theta_2, d_3, \\theta_4]$ of the posture with "
            "$0 \\le \\theta_2 \\le \\pi$ (rad, m). The target can be reached; whole turns do not count.",
            asks=Formula(
                INVERSE,
                ("X", "Y", "Z", "psi", "a_1", "a_2", "d_1", "d_4"),
                arm=ARM,
                given={**_REACHED, **_REST, "D": _COSINE, "k_1": "a_1 + a_2 D", "k_2": r"a_2 \sqrt{1 - D^2}"},
                cases=(
                    {"theta_1": 0.4, "theta_2": 0.9, "d_3": 0.15, "theta_4": 0.3},
                    {"theta_1": 2.6, "theta_2": 0.9, "d_3": 0.15, "theta_4": 0.3},
                ),
            ),
            hints=(
                "You have every line already; only the order counts. Which joint has to be known before which?",
                "$\\theta_2$ first, then $k_1, k_2$, then $\\theta_1$, last $\\theta_4$; $d_3$ at any time.",
                "`theta_2 = np.arccos(...)` gives the value between 0 and π; `np.arctan2(Y, X) - np.arctan2(k_2, k_1)` follows.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The slide alone makes the height.",
                        "d_3 = d_1 - d_4 - Z",
                    ),
                    Line(
                        "The distance from axis 1 gives the elbow's cosine; call it $D$.",
                        r"\cos\theta_2 = \frac{X^2 + Y^2 - a_1^2 - a_2^2}{2 a_1 a_2}",
                    ),
                    Line(
                        "Between $0$ and $\\pi$ an angle is the arccosine of its cosine.",
                        r"\theta_2 = \arccos D",
                    ),
                    Line(
                        "Its sine is not negative there.",
                        r"\sin\theta_2 = \sqrt{1 - D^2}",
                    ),
                    Line(
                        "With $k_1 = a_1 + a_2 D$ and $k_2 = a_2\\sqrt{1 - D^2}$ the shoulder turns $(k_1, k_2)$ to $(X, Y)$.",
                        r"\begin{bmatrix} X \\ Y \end{bmatrix} = \begin{bmatrix} \cos\theta_1 & -\sin\theta_1 \\ \sin\theta_1 & \cos\theta_1 \end{bmatrix} \begin{bmatrix} k_1 \\ k_2 \end{bmatrix}",
                    ),
                    Line(
                        "So $\\theta_1$ is the angle of one less that of the other.",
                        r"\theta_1 = \text{atan2}(Y, X) - \text{atan2}(k_2, k_1)",
                    ),
                    Line(
                        "The angle of the tool gives the last joint.",
                        r"\theta_4 = \theta_1 + \theta_2 - \psi",
                    ),
                    Line(
                        "All four joints.",
                        r"\begin{bmatrix} \theta_1 \\ \theta_2 \\ d_3 \\ \theta_4 \end{bmatrix} = \begin{bmatrix} \text{atan2}(Y, X) - \text{atan2}(k_2, k_1) \\ \arccos D \\ d_1 - d_4 - Z \\ \text{atan2}(Y, X) - \text{atan2}(k_2, k_1) + \arccos D - \psi \end{bmatrix}",
                    ),
                ),
                {
                    "symbols": {
                        "a_1": "free",
                        "a_2": "free",
                        "d_1": "free",
                        "d_4": "free",
                        "l": "free",
                        "beta": "free",
                        "gamma": "free",
                        "delta": "free",
                    }
                },
                given=(
                    r"\theta_2 = 2 \arctan l",
                    r"\theta_1 = \beta",
                    r"\theta_4 = \gamma",
                    r"d_3 = \delta",
                    r"X = a_1 \cos\theta_1 + a_2 \cos(\theta_1 + \theta_2)",
                    r"Y = a_1 \sin\theta_1 + a_2 \sin(\theta_1 + \theta_2)",
                    "Z = d_1 - d_3 - d_4",
                    r"\psi = \theta_1 + \theta_2 - \theta_4",
                    r"D = \frac{X^2 + Y^2 - a_1^2 - a_2^2}{2 a_1 a_2}",
                    "k_1 = a_1 + a_2 D",
                    r"k_2 = a_2 \sqrt{1 - D^2}",
                ),
            ),
            right=(inverse, _INVERSE_LONG, INVERSE, _inverse_with_elbow),
            wrong=(
                Wrong(
                    _without_elbow,
                    "the direction of the target is not θ_1 yet: the bent elbow adds the angle atan2(k_2, k_1)",
                    own=True,
                ),
                Wrong(
                    _by_arctan,
                    "arctan(Y/X) cannot tell a target from the opposite one: take atan2",
                    own=True,
                ),
                Wrong(
                    lambda *of: np.degrees(inverse(*of)),
                    "the angles are in degrees (and so is the length d_3): leave them in rad",
                    own=True,
                ),
                Wrong(_spoiled(3, lambda q, psi: psi - q[0] - q[1]), "entry (4, 1): wrong sign"),
                Wrong(_spoiled(2, lambda q, psi: -q[2]), "entry (3, 1): wrong sign"),
                Wrong(
                    _OTHER_SIGN,
                    "this is the other posture, with θ_2 below zero: a solution, but not the one asked for",
                    own=True,
                ),
                Wrong(
                    lambda X, Y, Z, psi, a_1, a_2, d_1, d_4: inverse(X, Y, Z, psi, a_1, a_2, d_1, d_4)[:3],
                    "three joint values: θ_4 is missing",
                    own=True,
                ),
            ),
        ),
        Task(
            name="equal_links",
            title="A target on the first axis",
            text="An arm has $a_1 = a_2$, and the target is $X = Y = 0$. How many postures $(\\theta_1, \\theta_2)$ reach it? "
            "Choose `none`, `one`, `two` or `many`.",
            asks=Choice(
                {
                    "none": "none, it is too near",
                    "one": "one, folded",
                    "two": "two, one a sign",
                    "many": "infinitely many",
                },
                right="many",
                because={
                    "none": "with equal links the inner circle has the radius 0: the target is on it, not inside it",
                    "one": "that settles θ_2, but does θ_1 still move the tool?",
                    "two": "on a limit both signs of θ_2 give one angle; look at θ_1 instead",
                },
            ),
            hints=(
                "Compute $\\cos\\theta_2$ for this target, then $k_1$ and $k_2$.",
                "$\\theta_2 = \\pi$, so $k_1 = a_1 - a_2$ and $k_2 = 0$. What is the angle of the vector $(k_1, k_2)$?",
                "$k_1 = k_2 = 0$ and $X = Y = 0$: both atan2 have no value, and every $\\theta_1$ solves the equations.",
            ),
            right=("many", ["many"], ("many",)),
            wrong=(
                Wrong("none", "the radius 0"),
                Wrong("one", "does θ_1 still move the tool"),
                Wrong("two", "both signs of θ_2 give one angle"),
                Wrong(["two", "many"], "one of them is asked for"),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="The end of a column with a rising carriage and a ram is at $X = -d_3 S_1$, $Y = d_3 C_1$, $Z = d_2$, with $d_3 > 0$. Write $d_3$"
            " in `X` and `Y`. A function takes `(X, Y)`.",
            asks=Formula(r"\sqrt{X^2 + Y^2}", ("X", "Y")),
            hints=(
                "Square both equations and add them: the angle goes.",
                "$X^2 + Y^2 = d_3^2$, and $d_3$ is positive.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Square both and add: the angle goes.",
                        "X^2 + Y^2 = d_3^2",
                    ),
                    Line(
                        "The ram is out: the root with the plus.",
                        r"d_3 = \sqrt{X^2 + Y^2}",
                    ),
                ),
                {"symbols": {"rho": "free", "theta_1": "free"}},
                given=(
                    r"d_3 = \rho",
                    r"X = -d_3 \sin\theta_1",
                    r"Y = d_3 \cos\theta_1",
                ),
            ),
            right=(ram, r"\sqrt{X^2 + Y^2}", WithSympy(_ram_sympy)),
            wrong=(
                Wrong(r"X^2 + Y^2", "this is the square of d_3: a length is wanted", own=True),
                Wrong(r"-\sqrt{X^2 + Y^2}", "d_3 is positive: of the two roots the other one", own=True),
                Wrong(r"X + Y", "a root of a sum is not the sum of the roots", own=True),
                Wrong(r"\sqrt{X^2 - Y^2}", "both squares are added: sine and cosine squared make 1", own=True),
                Wrong(r"-X", "this holds at θ_1 = 90° only, where the sine is 1", own=True),
            ),
        ),
    ),
)
