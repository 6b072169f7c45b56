"""Tasks of lesson 13, inverse velocity kinematics of the polar and the planar 2R arm (document 002, section 3.3)."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Task, WithSympy, Wrong
from armproof.course.feedback.answer import is_function, is_missing
from armproof.course.feedback.notebook import Shown
from armproof.models.errors import written
from armproof.models.language import look_up, number_text
from armproof.models.numeric.plant import NumericKinematics

ARM = "planar_2r"
SPEED = 0.1  # m/s, what show_rates asks of the gripper
_LIMIT = 4.0  # rad/s, of its plot
_JACOBIAN = {"J": {"jacobian": 2, "rows": [1, 2]}}
_POLAR = {"jacobian": 2, "rows": [1, 2], "columns": [2, 1]}
_POLAR_TALL = {"jacobian": 2, "rows": [1, 2, 6], "columns": [2, 1]}
_ANGLES = ("theta_1", "theta_2", "l_1", "l_2")


def show_rates(rates: Any, damping: float = 0.06) -> Any:
    """Return a plot of a student's joint rates over those of Drake's Jacobian, or a polite sentence.

    The gripper is to move at 0.1 m/s along the first link (θ_1 = 0), at elbow angles from −60° to 60°.

    Args:
        rates: the answer to the task `rates`.
        damping: λ of the damped rates that are drawn beside (m).
    """
    if is_missing(rates) or not is_function(rates):
        return Shown(written("`{task}`: no function yet, nothing to draw.", task="rates"))
    from armproof.models.catalogue import load_arm

    arm = load_arm(ARM)
    elbow = np.radians(np.linspace(-60, 60, 240))  # an even number: 0 is not among them
    try:
        with np.errstate(all="ignore"):
            found = [np.array(rates(0.0, t, arm.lengths["l_1"], arm.lengths["l_2"], SPEED, 0.0), float) for t in elbow]
    except Exception as problem:
        return Shown(written("`{task}`: the function stops with {type}: {reason}", task="rates", type=type(problem).__name__, reason=str(problem)))  # fmt: skip
    if all(rate.size == 1 and np.isnan(rate).all() for rate in found):  # what None becomes
        return Shown(written("`{task}`: no answer yet, nothing to draw.", task="rates"))
    values = np.array([rate.ravel() for rate in found if rate.size == 2])
    if values.shape != (len(elbow), 2):
        return Shown(look_up("`rates`: two joint rates are needed for the plot."))
    return _plot(arm, elbow, values, damping)


def _plot(arm, elbow, values, damping):
    """Plot both joint rates against θ_2: Drake's wide and grey, the student's over them, the damped ones dotted."""
    from armproof.course.figures.drawing.plots import plot_axes
    from armproof.course.figures.drawing.style import GREY, SMALL, STROKES, new_figure, styled
    from armproof.models.motion.inverse_velocity import joint_rates

    q = np.column_stack([np.zeros_like(elbow), elbow])
    jacobians = NumericKinematics(arm, q).jacobian("2")[:, :2, :]
    twists = np.broadcast_to([SPEED, 0.0], (len(elbow), 2))
    true = joint_rates(jacobians, twists).rates
    damped = joint_rates(jacobians, twists, damping=damping).rates
    with styled():
        figure = new_figure("column", 76.0)
        for k in range(2):
            below = 11.0 + 33.0 * (1 - k)
            label = rf"$\dot{{\theta}}_{k + 1}$ (rad/s)"
            axes = plot_axes(figure, (15.0, below, 64.0, 28.0), "", r"$\theta_2$ (°)" if k else "", label)
            degrees = np.degrees(elbow)
            for part in (elbow < 0, elbow > 0):
                axes.plot(degrees[part], true[part, k], color=GREY, linewidth=5, alpha=0.3)[0].set_gid("drake")
                axes.plot(degrees[part], values[part, k], color=STROKES[1].colour, linewidth=1.4)[0].set_gid("answer")
            axes.plot(degrees, damped[:, k], color=STROKES[0].colour, linestyle=":", linewidth=1.4)[0].set_gid("damped")
            axes.axhline(0, color=GREY, linewidth=0.4, zorder=1)
            axes.set(xlim=(-60, 60), ylim=(-_LIMIT, _LIMIT))
        axes = figure.axes[0]
        names = (
            ("Drake", GREY),
            (look_up("your answer"), STROKES[1].colour),
            (written("damped, {value} m", value=rf"$\lambda$ = {number_text(damping, 'g')}"), STROKES[0].colour),
        )
        for place, (name, colour) in enumerate(names):
            axes.text(0.02, 0.93 - 0.13 * place, name, transform=axes.transAxes, va="top", fontsize=SMALL, color=colour)
        return figure


def polar_inverse(theta, r):
    """Return the inverse of J_L, which gives [dr, dtheta] from [dX, dY]."""
    s, c = np.sin(theta), np.cos(theta)
    return np.array([[c, s], [-s / r, c / r]])


def determinant(theta_1, theta_2, l_1, l_2):
    """Return det J."""
    return l_1 * l_2 * np.sin(theta_2)


def adjugate(theta_1, theta_2, l_1, l_2):
    """Return the adjugate of J: the diagonal swapped, the other two with their signs turned."""
    s1, c1 = np.sin(theta_1), np.cos(theta_1)
    s12, c12 = np.sin(theta_1 + theta_2), np.cos(theta_1 + theta_2)
    return np.array([[l_2 * c12, l_2 * s12], [-l_1 * c1 - l_2 * c12, -l_1 * s1 - l_2 * s12]])


def rates(theta_1, theta_2, l_1, l_2, u, v):
    """Return [dtheta_1, dtheta_2] for the velocity [u, v] of the gripper."""
    return adjugate(theta_1, theta_2, l_1, l_2) @ np.array([u, v]) / (l_1 * l_2 * np.sin(theta_2))


def left_inverse(theta, r):
    """Return (JᵀJ)⁻¹Jᵀ of the tall Jacobian of the polar arm."""
    J = np.array([[np.cos(theta), -r * np.sin(theta)], [np.sin(theta), r * np.cos(theta)], [0, 1]])
    return np.linalg.inv(J.T @ J) @ J.T


def gain(sigma, damping):
    """Return the joint rate per unit of velocity."""
    return sigma / (sigma**2 + damping**2)


def bound(damping):
    """Return the largest value that σ / (σ² + λ²) takes, at σ = λ."""
    return 1 / (2 * damping)


def _jacobian(theta_1, theta_2, l_1, l_2):
    s1, c1 = np.sin(theta_1), np.cos(theta_1)
    s12, c12 = np.sin(theta_1 + theta_2), np.cos(theta_1 + theta_2)
    return np.array([[-l_1 * s1 - l_2 * s12, -l_2 * s12], [l_1 * c1 + l_2 * c12, l_2 * c12]])


def _rates_by_solve(theta_1, theta_2, l_1, l_2, u, v):
    return np.linalg.solve(_jacobian(theta_1, theta_2, l_1, l_2), np.array([u, v]))


def _determinant_by_rule(theta_1, theta_2, l_1, l_2):
    J = _jacobian(theta_1, theta_2, l_1, l_2)
    return J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]


def _adjugate_with_sympy(sp):
    t1, t2, l1, l2 = sp.symbols("theta_1 theta_2 l_1 l_2")
    p = sp.Matrix([l1 * sp.cos(t1) + l2 * sp.cos(t1 + t2), l1 * sp.sin(t1) + l2 * sp.sin(t1 + t2)])
    return p.jacobian([t1, t2]).adjugate()


def _polar_with_sympy(sp):
    t, r = sp.symbols("theta r")
    return sp.Matrix([r * sp.cos(t), r * sp.sin(t)]).jacobian([r, t]).inv()


def _left_with_sympy(sp):
    t, r = sp.symbols("theta r")
    J = sp.Matrix([[sp.cos(t), -r * sp.sin(t)], [sp.sin(t), r * sp.cos(t)], [0, 1]])
    return (J.T * J).inv() * J.T


POLAR = r"\frac{1}{r} \begin{bmatrix} r\cos\theta & r\sin\theta \\ -\sin\theta & \cos\theta \end{bmatrix}"
ADJUGATE = r"\begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\ -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}"
RATES = r"""\begin{bmatrix} \frac{u C_{12} + v S_{12}}{l_1 S_2} \\
-\frac{u (l_1 C_1 + l_2 C_{12}) + v (l_1 S_1 + l_2 S_{12})}{l_1 l_2 S_2} \end{bmatrix}"""
LEFT = r"""\begin{bmatrix} \cos\theta & \sin\theta & 0 \\
\frac{-r\sin\theta}{1 + r^2} & \frac{r\cos\theta}{1 + r^2} & \frac{1}{1 + r^2} \end{bmatrix}"""

_FORMS = {
    "right_wide": "right inverse of a wide J",
    "left_wide": "left inverse of a wide J",
    "right_tall": "right inverse of a tall J",
    "left_tall": "left inverse of a tall J",
}


def carriage_rates(theta, b, u, v):
    """Return the rates of the carriage and of the bar: v fixes the bar's, and the carriage makes up for the rest of u."""
    return [u + v * np.tan(theta), v / (b * np.cos(theta))]


CARRIAGE_RATES = r"\begin{bmatrix} u + \frac{v \sin\theta}{\cos\theta} \\ \frac{v}{b\cos\theta} \end{bmatrix}"


def _carriage_sympy(sp):
    theta, b, u, v = sp.symbols("theta b u v")
    J = sp.Matrix([[1, -b * sp.sin(theta)], [0, b * sp.cos(theta)]])
    return J.inv() * sp.Matrix([u, v])


LESSON = Lesson(
    number=13,
    name="inverse_velocity",
    title="Inverse velocity: the inverse, the pseudo-inverses, and what happens at a singularity",
    source="Université de Constantine 1, Modélisation cinématique, section 3.3 (document 002)",
    objectives=(
        "Invert the Jacobians of the polar and the planar 2R arm by adjugate and determinant.",
        "Choose the form of the pseudo-inverse that exists when the Jacobian is not square.",
        "Say what the joints do at and near a singular configuration, and what damping changes.",
    ),
    tasks=(
        Task(
            name="predict",
            title="What a stretched arm can do",
            text="The planar 2R arm is stretched along $x_0$ ($\\theta_1 = \\theta_2 = 0$). In which directions can it move its gripper at this "
            "moment? Choose `along` (along the links), `across` (across them), `both` or `none`.",
            asks=Choice(
                {"along": "along the links", "across": "across the links", "both": "both", "none": "neither"},
                right="across",
                because={
                    "along": "that is the direction that is lost: no joint rate lengthens a stretched arm",
                    "both": "turn each joint alone: both move the gripper in the same direction",
                    "none": "turn the first joint alone: the gripper does move",
                },
            ),
            hints=(
                "Move one joint at a time, the other at rest.",
                "A revolute joint moves the gripper at right angles to the line from its axis to the gripper.",
                "Both axes and the gripper are on one line, so both joints push it the same way, at right angles to that line.",
            ),
            right=("across", ["across"], ("across",)),
            wrong=(
                Wrong("along", "the direction that is lost"),
                Wrong("both", "both move the gripper in the same direction"),
                Wrong("none", "the gripper does move"),
                Wrong(["along", "across"], "one of them is asked for"),
            ),
        ),
        Task(
            name="polar_inverse",
            title="The polar arm: invert",
            text="Give $J_L^{-1}$ of the polar arm, $2 \\times 2$: it takes $[\\dot X, \\dot Y]^T$ to $[\\dot r, \\dot\\theta]^T$, in this order. "
            "A function takes `(theta, r)`; the letters are $\\theta$ and $r$.",
            asks=Formula("J_L^{-1}", ("theta", "r"), arm="polar_rp", quantities={"J_L": _POLAR}),
            hints=(
                "Differentiate $X = r\\cos\\theta$ and $Y = r\\sin\\theta$: the factors of $\\dot r$ are the first column, those of $\\dot\\theta$ the second.",
                "$J_L = \\begin{bmatrix} \\cos\\theta & -r\\sin\\theta \\\\ \\sin\\theta & r\\cos\\theta \\end{bmatrix}$, with the determinant $r$.",
                "Swap the diagonal, change the signs of the other two, divide all four by $r$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Differentiate $r\\cos\\theta$ and $r\\sin\\theta$, first by $r$, then by $\\theta$.",
                        r"J_L = \begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \end{bmatrix}",
                    ),
                    Line("The determinant.", r"\det J_L = r\cos^2\theta + r\sin^2\theta = r"),
                    Line(
                        "Exchange the diagonal, turn the signs beside it, divide.",
                        r"J_L^{-1} = \frac{1}{r} \begin{bmatrix} r\cos\theta & r\sin\theta \\ -\sin\theta & \cos\theta \end{bmatrix}",
                    ),
                    Line("Check.", r"J_L J_L^{-1} = I_2"),
                ),
                {"arm": "polar_rp", "quantities": {"J_L": {"jacobian": 2, "rows": [1, 2], "columns": [2, 1]}}},
            ),
            right=(polar_inverse, POLAR, WithSympy(_polar_with_sympy)),
            wrong=(
                Wrong(
                    r"\begin{bmatrix} r\cos\theta & r\sin\theta \\ -\sin\theta & \cos\theta \end{bmatrix}",
                    "this is the adjugate: divide it by the determinant r",
                    own=True,
                ),
                Wrong(lambda theta, r: polar_inverse(theta, r).T, "the matrix is transposed"),
                Wrong(
                    r"\frac{1}{r} \begin{bmatrix} -\sin\theta & \cos\theta \\ r\cos\theta & r\sin\theta \end{bmatrix}",
                    "the rows are swapped: the first one gives the rate of r",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \end{bmatrix}",
                    "this is J_L itself, not yet its inverse",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} \cos\theta & \sin\theta \\ -r\sin\theta & r\cos\theta \end{bmatrix}",
                    "the inverse is not the transpose: the second column of J_L has the length r, not 1",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: [[np.cos(theta), np.sin(theta)], [-np.sin(theta), np.cos(theta)]],
                    "that takes velocities to velocities: a turn about the axis at the rate 1 moves the gripper at r",
                    own=True,
                ),
                Wrong(
                    r"\frac{1}{r} \begin{bmatrix} r\cos\theta & r\sin\theta \\ \sin\theta & \cos\theta \end{bmatrix}",
                    "the off-diagonal entries change their signs: one of the two has not",
                    own=True,
                ),
            ),
        ),
        Task(
            name="polar_rate",
            title="The polar arm: near the axis",
            text="The gripper of the polar arm stands $r = 0.06$ m from the axis of its revolute joint and is to move across the arm at 0.15 m/s. "
            "How fast does the revolute joint turn, in rad/s (the amount)?",
            asks=Number(
                2.5,
                unit="rad/s",
                steps=("r = 0.06", "0.15/r"),
                beside=("0.15/(2 r)", "0.15/(r/2)", "0.15/r^2", "r/0.15^2", r"2 \pi", "0.15 r^2"),
            ),
            hints=(
                "Only the second row of $J_L^{-1}$ is needed.",
                "Across the arm is the direction $(-\\sin\\theta, \\cos\\theta)$; the second row of $J_L^{-1}$ is this direction divided by $r$.",
                "Divide the speed by the distance.",
            ),
            right=(2.5, "2.5", lambda: 0.15 / 0.06),
            wrong=(
                Wrong(0.009, "speed times distance: the rate falls as the arm grows longer, so divide", own=True),
                Wrong(
                    0.15,
                    "0.15 is the speed of the gripper in m/s; at 1 m from the axis it would be the rate too",
                    own=True,
                ),
                Wrong(0.4, "the other way round: the speed of the gripper is divided by the distance", own=True),
                Wrong(np.degrees(2.5), "that is in degrees per second", own=True),
                Wrong(-2.5, "the amount is asked for, without a sign", own=True),
                Wrong(0.15 / 0.06**2, "divided by the square of the distance: the determinant divides once", own=True),
            ),
        ),
        Task(
            name="determinant",
            title="Planar 2R: the determinant",
            text="Give $\\det J$ of the planar 2R arm, as short as you can. A function takes `(theta_1, theta_2, l_1, l_2)`.",
            asks=Formula(r"\det J", _ANGLES, arm=ARM, quantities=_JACOBIAN, unit="m²"),
            hints=(
                "The first column is the second plus $l_1 [-S_1, C_1]^T$. What does that do to the determinant?",
                "It is $\\det \\begin{bmatrix} -l_1 S_1 & -l_2 S_{12} \\\\ l_1 C_1 & l_2 C_{12} \\end{bmatrix}$.",
                "$l_1 l_2 (C_1 S_{12} - S_1 C_{12})$, and the bracket is the sine of a difference.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The Jacobian.",
                        r"J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}",
                    ),
                    Line(
                        "Column 1 less column 2: the determinant stays.",
                        r"\det J = \begin{vmatrix} -l_1 S_1 & -l_2 S_{12} \\ l_1 C_1 & l_2 C_{12} \end{vmatrix}",
                    ),
                    Line("Multiply crosswise.", r"\det J = l_1 l_2 (S_{12} C_1 - C_{12} S_1)"),
                    Line("The bracket is the sine of a difference.", r"\det J = l_1 l_2 \sin\theta_2"),
                ),
                {"arm": "planar_2r", "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}}},
            ),
            right=(
                determinant,
                r"l_1 l_2 \sin\theta_2",
                WithSympy(lambda sp: sp.Symbol("l_2") * sp.Symbol("l_1") * sp.sin(sp.Symbol("theta_2"))),
                _determinant_by_rule,
                r"l_1 l_2 (C_1 S_{12} - S_1 C_{12})",
            ),
            wrong=(
                Wrong(r"-l_1 l_2 \sin\theta_2", "wrong sign"),
                Wrong(
                    r"l_1 l_2 \cos\theta_2",
                    "the stretched arm is the singular one: this vanishes at a right angle instead",
                    own=True,
                ),
                Wrong(
                    r"l_1 l_2 \sin(\theta_1 + \theta_2)",
                    "turning the whole arm about its base cannot make it singular: θ_1 has to drop out",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2: l_1 * l_2 * np.sin(theta_1),
                    "turning the first joint alone does not change the shape of the arm: the angle of the elbow counts",
                    own=True,
                ),
                Wrong(r"l_1 l_2 S_2 + l_2^2 S_2", "the terms in l_2^2 cancel", own=True),
            ),
        ),
        Task(
            name="adjugate",
            title="Planar 2R: the adjugate",
            text="Give the adjugate of $J$, $2 \\times 2$: what is divided by $\\det J$ to give $J^{-1}$. A function takes `(theta_1, theta_2, l_1, l_2)`.",
            asks=Formula(r"\det(J) J^{-1}", _ANGLES, arm=ARM, quantities=_JACOBIAN, unit="m"),
            hints=(
                "For a $2 \\times 2$ matrix no cofactor has to be computed.",
                "The adjugate of $\\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}$ has $d$ and $a$ on its diagonal, and $-b$, $-c$ where $b$, $c$ were.",
                "First row: $l_2 C_{12}$, $l_2 S_{12}$. The second is the first column of $J$: its second entry with a minus, then its first.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The Jacobian.",
                        r"J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}",
                    ),
                    Line(
                        "Exchange the diagonal, turn the signs beside it.",
                        r"\det(J) J^{-1} = \begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\ -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}",
                    ),
                    Line(
                        "Check: the product is the determinant times $I_2$.",
                        r"\begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\ -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix} J = l_1 l_2 S_2 I_2",
                    ),
                ),
                {"arm": "planar_2r", "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}}},
            ),
            right=(adjugate, ADJUGATE, WithSympy(_adjugate_with_sympy)),
            wrong=(
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2: adjugate(theta_1, theta_2, l_1, l_2).T,
                    "the matrix is transposed",
                ),
                Wrong(
                    r"\begin{bmatrix} l_2 C_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}",
                    "wrong sign",
                ),
                Wrong(_jacobian, "this is J itself: swap its diagonal and change the signs of the other two", own=True),
                Wrong(
                    lambda *of: adjugate(*of) / determinant(*of),
                    "already divided by the determinant: this is the inverse",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} l_2 C_2 & l_2 S_2 \\ -l_1 C_1 - l_2 C_2 & -l_1 S_1 - l_2 S_2 \end{bmatrix}",
                    "the second link points along θ_1 + θ_2: C_12 and S_12, not C_2 and S_2",
                    own=True,
                ),
                Wrong(lambda *of: -adjugate(*of), "sign"),
            ),
        ),
        Task(
            name="rates",
            title="Planar 2R: the joint rates",
            text="The gripper is to move with $\\dot X = u$, $\\dot Y = v$. Give $[\\dot\\theta_1, \\dot\\theta_2]^T$ (rad/s). A function takes "
            "`(theta_1, theta_2, l_1, l_2, u, v)`.",
            asks=Formula(
                r"J^{-1} \begin{bmatrix} u \\ v \end{bmatrix}",
                (*_ANGLES, "u", "v"),
                arm=ARM,
                quantities=_JACOBIAN,
                unit="rad/s",
            ),
            hints=(
                "You have the adjugate and the determinant.",
                "Adjugate times $[u, v]^T$, divided by $l_1 l_2 S_2$.",
                "$\\dot\\theta_1 = (u C_{12} + v S_{12}) / (l_1 S_2)$; the second row has $l_1 l_2 S_2$ below it and a minus before it.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The inverse: the adjugate by the determinant.",
                        r"J^{-1} = \frac{1}{l_1 l_2 S_2} \begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\ -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}",
                    ),
                    Line(
                        "Times the velocity, row by row.",
                        r"J^{-1} \begin{bmatrix} u \\ v \end{bmatrix} = \frac{1}{l_1 l_2 S_2} \begin{bmatrix} l_2 (u C_{12} + v S_{12}) \\ -l_1 (u C_1 + v S_1) - l_2 (u C_{12} + v S_{12}) \end{bmatrix}",
                    ),
                    Line(
                        "Divide: in the first row $l_2$ cancels.",
                        r"J^{-1} \begin{bmatrix} u \\ v \end{bmatrix} = \begin{bmatrix} \frac{u C_{12} + v S_{12}}{l_1 S_2} \\ -\frac{l_1 (u C_1 + v S_1) + l_2 (u C_{12} + v S_{12})}{l_1 l_2 S_2} \end{bmatrix}",
                    ),
                ),
                {
                    "arm": "planar_2r",
                    "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}},
                    "symbols": {"u": "free", "v": "free"},
                },
            ),
            right=(rates, RATES, _rates_by_solve, lambda *of: np.linalg.inv(_jacobian(*of[:4])) @ np.array(of[4:])),
            wrong=(
                Wrong(
                    lambda *of: adjugate(*of[:4]) @ np.array(of[4:]),
                    "the determinant is still to be divided by",
                    own=True,
                ),
                Wrong(
                    lambda *of: _jacobian(*of[:4]) @ np.array(of[4:]),
                    "this goes the other way: J takes joint rates to the velocity",
                    own=True,
                ),
                Wrong(
                    lambda *of: _jacobian(*of[:4]).T @ np.array(of[4:]),
                    "the transpose of J takes forces to torques; velocities need the inverse",
                    own=True,
                ),
                Wrong(RATES.replace("-\\frac", "\\frac"), "entry (2, 1): wrong sign"),
                Wrong(
                    lambda *of: [rates(*of)[0], rates(*of)[0] + rates(*of)[1]],
                    "that is the rate of θ_1 + θ_2: joint 2 turns relative to the first link",
                    own=True,
                ),
                Wrong(
                    RATES.replace("l_1 S_2}", "l_1 C_2}").replace("l_2 S_2}", "l_2 C_2}"),
                    "the determinant has the sine of θ_2, not its cosine",
                    own=True,
                ),
                Wrong(
                    lambda *of: adjugate(*of[:4]).T @ np.array(of[4:]) / determinant(*of[:4]),
                    "transposed once too often: this is the inverse of the transpose",
                    own=True,
                ),
            ),
        ),
        Task(
            name="forms",
            title="Which form exists?",
            text="$J^T (J J^T)^{-1}$ is a right inverse, $(J^T J)^{-1} J^T$ a left one. Which exist, for a wide $J$ ($2 \\times 3$, more joints than "
            "velocities) and for a tall $J$ ($3 \\times 2$), of full rank? Choose two of `right_wide`, `left_wide`, `right_tall`, `left_tall`.",
            asks=Choice(
                _FORMS,
                right=frozenset({"right_wide", "left_tall"}),
                because={
                    "left_wide": "of a wide J the product J^T J is 3 × 3 but made of two rows only: it has no inverse",
                    "right_tall": "of a tall J the product J J^T is 3 × 3 but made of two columns only: it has no inverse",
                },
                missing={
                    "right_wide": "right for the tall one; a wide J has a pseudo-inverse too",
                    "left_tall": "right for the wide one; a tall J has a pseudo-inverse too",
                },
            ),
            hints=(
                "What is the size of the product that is to be inverted, and what rank can it have at most?",
                "The rank of a product is at most that of its factors, here 2.",
                "The product that is $2 \\times 2$ can be inverted, the one that is $3 \\times 3$ cannot.",
            ),
            right=(["right_wide", "left_tall"], "left_tall, right_wide", ("left_tall", "right_wide")),
            wrong=(
                Wrong(
                    ["left_wide", "right_tall"],
                    "the wrong way round: each of these two would invert a 3 × 3 matrix of rank 2",
                    own=True,
                ),
                Wrong(["right_wide", "right_tall"], "made of two columns only"),
                Wrong("right_wide", "a tall J has a pseudo-inverse too"),
                Wrong("left_tall", "a wide J has a pseudo-inverse too"),
                Wrong(["left_wide", "left_tall"], "made of two rows only"),
            ),
        ),
        Task(
            name="left_inverse",
            title="The polar arm with its angle",
            text="With the rate $\\omega$ of the gripper's angle as a third row, the polar arm's $J$ is $3 \\times 2$, rows $\\dot X, \\dot Y, \\omega$, "
            "columns $\\dot r, \\dot\\theta$. Give its pseudo-inverse, $2 \\times 3$. A function takes `(theta, r)`, with $r$ in metres.",
            asks=Formula("(J^T J)^{-1} J^T", ("theta", "r"), arm="polar_rp", quantities={"J": _POLAR_TALL}),
            hints=(
                "$J$ is tall. Which of the two forms is that?",
                "$J^T J$ is diagonal: the two columns of $J$ are at right angles.",
                "$J^T J = \\mathrm{diag}(1, 1 + r^2)$: divide the first row of $J^T$ by 1, the second by $1 + r^2$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Three rows, two columns: $J$ is tall.",
                        r"J = \begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \\ 0 & 1 \end{bmatrix}",
                    ),
                    Line("$J^T J$ is diagonal.", r"J^T J = \begin{bmatrix} 1 & 0 \\ 0 & r^2 + 1 \end{bmatrix}"),
                    Line(
                        "So each entry is inverted alone.",
                        r"(J^T J)^{-1} = \begin{bmatrix} 1 & 0 \\ 0 & \frac{1}{r^2 + 1} \end{bmatrix}",
                    ),
                    Line(
                        "Times $J^T$.",
                        r"(J^T J)^{-1} J^T = \begin{bmatrix} \cos\theta & \sin\theta & 0 \\ -\frac{r\sin\theta}{r^2 + 1} & \frac{r\cos\theta}{r^2 + 1} & \frac{1}{r^2 + 1} \end{bmatrix}",
                    ),
                ),
                {"arm": "polar_rp", "quantities": {"J": {"jacobian": 2, "rows": [1, 2, 6], "columns": [2, 1]}}},
            ),
            right=(left_inverse, LEFT, WithSympy(_left_with_sympy)),
            wrong=(
                Wrong(
                    lambda theta, r: [[np.cos(theta), np.sin(theta), 0], [-np.sin(theta) / r, np.cos(theta) / r, 0]],
                    "this inverts the first two rows and leaves out the angle: least squares weighs all three",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} \cos\theta & \sin\theta & 0 \\ -r\sin\theta & r\cos\theta & 1 \end{bmatrix}",
                    "this is the transpose of J; its rows are still to be divided by the entries of J^T J",
                    own=True,
                ),
                Wrong(
                    lambda theta, r: left_inverse(theta, r).T, "the pseudo-inverse of a 3 × 2 matrix is 2 × 3", own=True
                ),
                Wrong(
                    LEFT.replace("1 + r^2", "r^2"),
                    "the third row of J is missing in J^T J: its 1 adds to r^2",
                    own=True,
                ),
                Wrong(LEFT.replace("-r\\sin", "r\\sin"), "entry (2, 1): wrong sign"),
                Wrong(
                    lambda theta, r: left_inverse(theta, r)[::-1],
                    "the rows are swapped: the first one gives the rate of r",
                    own=True,
                ),
            ),
        ),
        Task(
            name="gain",
            title="Damping",
            text="One joint, one velocity: $v = \\sigma \\dot q$. Find the $\\dot q$ that makes $(\\sigma \\dot q - v)^2 + \\lambda^2 \\dot q^2$ smallest, and "
            "give the gain $\\dot q / v$ in $\\sigma$ and $\\lambda$. A function takes `(sigma, damping)`, where `damping` is $\\lambda$.",
            asks=Formula(r"\frac{\sigma}{\sigma^2 + \lambda^2}", ("sigma", "lambda")),
            hints=(
                "A smallest value has the derivative zero; differentiate with respect to $\\dot q$.",
                "$2\\sigma(\\sigma\\dot q - v) + 2\\lambda^2 \\dot q = 0$.",
                "Collect $\\dot q$: $(\\sigma^2 + \\lambda^2)\\,\\dot q = \\sigma v$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Differentiate by the joint rate, here $x$.",
                        r"\frac{\partial}{\partial x} \left( (\sigma x - v)^2 + \lambda^2 x^2 \right) = 2\sigma(\sigma x - v) + 2\lambda^2 x",
                    ),
                    Line(
                        "Collect what stands with $x$.",
                        r"2\sigma(\sigma x - v) + 2\lambda^2 x = 2 \left( (\sigma^2 + \lambda^2) x - \sigma v \right)",
                    ),
                    Line(
                        "The solution makes it zero.",
                        r"(\sigma^2 + \lambda^2) \frac{\sigma}{\sigma^2 + \lambda^2} v - \sigma v = 0",
                    ),
                ),
                {"symbols": {"sigma": "free", "lambda": "free", "x": "free", "v": "free"}},
            ),
            right=(
                gain,
                r"\frac{\sigma}{\sigma^2 + \lambda^2}",
                lambda sigma, damping: 1 / (sigma + damping**2 / sigma),
                WithSympy(lambda sp: sp.Symbol("sigma") / (sp.Symbol("sigma") ** 2 + sp.Symbol("lambda") ** 2)),
            ),
            wrong=(
                Wrong(r"\frac{1}{\sigma}", "this is the gain without damping", own=True),
                Wrong(
                    r"\frac{1}{\sigma} + \frac{1}{\lambda}",
                    "this is larger than the gain without damping, and grows without bound as σ goes to 0: damping is to prevent that",
                    own=True,
                ),
                Wrong(
                    r"\frac{1}{\sigma^2 + \lambda^2}",
                    "a factor σ is missing: the first term is differentiated through σ times the rate",
                    own=True,
                ),
                Wrong(
                    r"\frac{1}{\sigma + \lambda}",
                    "the squares do not go away with the derivative: both factors were squared before",
                    own=True,
                ),
                Wrong(r"\frac{\sigma}{\sigma^2 - \lambda^2}", "sign"),
                Wrong(r"\frac{\sigma}{\sigma^2 + \lambda}", "square"),
                Wrong(
                    r"\frac{\sigma^2}{\sigma^2 + \lambda^2}",
                    "this is the part of the velocity that is reached, σ times the gain",
                    own=True,
                ),
            ),
        ),
        Task(
            name="bound",
            title="The largest gain",
            text="Give the largest gain that any $\\sigma \\ge 0$ can have, in $\\lambda$. A function takes `(damping)`.",
            asks=Formula(r"\frac{1}{2\lambda}", ("lambda",)),
            hints=(
                "The gain is 0 at $\\sigma = 0$ and falls again for large $\\sigma$. Where is it largest?",
                "Differentiate, or look at $1/\\text{gain} = \\sigma + \\lambda^2 / \\sigma$, which is smallest where both terms are equal.",
                "At $\\sigma = \\lambda$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Differentiate the gain by $\\sigma$.",
                        r"\frac{\partial}{\partial \sigma} \left( \frac{\sigma}{\sigma^2 + \lambda^2} \right) = \frac{\lambda^2 - \sigma^2}{(\sigma^2 + \lambda^2)^2}",
                    ),
                    Line(
                        "It vanishes at $\\sigma = \\lambda$; there the gain is",
                        r"\left. \frac{\sigma}{\sigma^2 + \lambda^2} \right|_{\sigma = \lambda} = \frac{1}{2\lambda}",
                    ),
                    Line(
                        "No other gain is larger: a square is never negative.",
                        r"\frac{1}{2\lambda} - \frac{\sigma}{\sigma^2 + \lambda^2} = \frac{(\sigma - \lambda)^2}{2\lambda(\sigma^2 + \lambda^2)}",
                    ),
                ),
                {"symbols": {"sigma": "free", "lambda": "free"}},
            ),
            right=(
                bound,
                r"\frac{1}{2\lambda}",
                WithSympy(lambda sp: 1 / (2 * sp.Symbol("lambda"))),
                r"\frac{\lambda}{\lambda^2 + \lambda^2}",
            ),
            wrong=(
                Wrong(r"\frac{1}{\lambda}", "at σ = λ the two squares below the line add up", own=True),
                Wrong(
                    r"\frac{1}{\lambda^2}",
                    "a gain has the unit of 1/λ: put σ = λ into the whole fraction",
                    own=True,
                ),
                Wrong(r"\frac{\lambda}{2}", "upside down: σ stands above the line, the squares below", own=True),
                Wrong(r"\frac{1}{2\lambda^2}", "the σ above the line cancels one λ", own=True),
            ),
        ),
        Task(
            name="limit",
            title="Through the singularity",
            text="With damping, the 2R arm is asked for a velocity along its links and comes to $\\theta_2 = 0$. What do the joint rates do? Choose "
            "`infinite`, `bounded` (they stop growing and stay at their largest), `jump` (they grow, then jump to zero at $\\theta_2 = 0$), or `zero` (they come "
            "back to zero without a jump).",
            asks=Choice(
                {
                    "infinite": "grow without bound",
                    "bounded": "stay at their largest",
                    "zero": "go back to zero",
                    "jump": "grow, then jump to zero",
                },
                right="zero",
                because={
                    "infinite": "that is the inverse without damping; no gain is larger than the one you just found",
                    "jump": "the gain is a smooth function of σ as long as λ is not 0: nothing jumps",
                    "bounded": "the singular value of the lost direction goes to 0: put that into the gain",
                },
            ),
            hints=(
                "Along the links the singular value goes to 0 with $\\theta_2$.",
                "Follow the gain $\\sigma / (\\sigma^2 + \\lambda^2)$ from large $\\sigma$ down to 0.",
                "It rises to $1/(2\\lambda)$ at $\\sigma = \\lambda$, then falls; look at the dotted line in the plot.",
            ),
            right=("zero", ["zero"], ("zero",)),
            wrong=(
                Wrong("infinite", "without damping"),
                Wrong("bounded", "put that into the gain"),
                Wrong("jump", "nothing jumps"),
                Wrong(["infinite", "zero"], "one of them is asked for"),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A carriage slides by $d$ along $x_0$; a bar of length $b$ turns on it by $\\theta$, its end is at $[d + b\\cos\\theta,\\ b\\sin\\theta]^T$. The end is to"
            " move with $\\dot X = u$, $\\dot Y = v$. Give $[\\dot d, \\dot\\theta]^T$. A function takes `(theta, b, u, v)`.",
            asks=Formula(CARRIAGE_RATES, ("theta", "b", "u", "v")),
            hints=(
                "Derive the position first: $J$ is 2×2, and its first column is $[1, 0]^T$.",
                "The second row has one unknown only: $v = b\\cos\\theta\\,\\dot\\theta$.",
                "Put $\\dot\\theta$ into the first row: $u = \\dot d - b\\sin\\theta\\,\\dot\\theta$.",
            ),
            right=(carriage_rates, CARRIAGE_RATES, WithSympy(_carriage_sympy)),
            wrong=(
                Wrong(lambda theta, b, u, v: carriage_rates(theta, b, u, v)[::-1], "swapped"),
                Wrong(CARRIAGE_RATES.replace("u +", "u -"), "wrong sign of term 2"),
                Wrong(
                    r"\begin{bmatrix} u \\ \frac{v}{b\cos\theta} \end{bmatrix}",
                    "the turning bar moves its end along x too: the carriage has to make up for it",
                    own=True,
                ),
                Wrong(
                    lambda theta, b, u, v: [u, -b * np.sin(theta) * u + b * np.cos(theta) * v],
                    "this is the transpose of J times the velocity: the inverse is asked for",
                    own=True,
                ),
                Wrong(
                    lambda theta, b, u, v: [u - b * np.sin(theta) * v, b * np.cos(theta) * v],
                    "this is J itself, which takes joint rates to velocities: here the rates are asked for",
                    own=True,
                ),
                Wrong(CARRIAGE_RATES.replace(r"{b\cos\theta}", r"{\cos\theta}"), "b is missing"),
            ),
            derivation=Derivation(
                (
                    Line(
                        "The Jacobian and its determinant.",
                        r"\det\begin{bmatrix} 1 & -b\sin\theta \\ 0 & b\cos\theta \end{bmatrix} = b\cos\theta",
                    ),
                    Line(
                        "Its inverse: the diagonal exchanged, the other two negative, by the determinant.",
                        r"\begin{bmatrix} 1 & -b\sin\theta \\ 0 & b\cos\theta \end{bmatrix}^{-1} = \frac{1}{b\cos\theta} \begin{bmatrix} b\cos\theta & b\sin\theta \\ 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Times the velocity.",
                        r"\frac{1}{b\cos\theta} \begin{bmatrix} b\cos\theta & b\sin\theta \\ 0 & 1 \end{bmatrix} \begin{bmatrix} u \\ v \end{bmatrix} = \begin{bmatrix} u + \frac{v \sin\theta}{\cos\theta} \\ \frac{v}{b\cos\theta} \end{bmatrix}",
                    ),
                ),
            ),
        ),
    ),
)
