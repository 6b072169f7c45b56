"""Tasks of lesson 15, the quintic joint trajectory (A. Beneult Lefaucheux, TD 1, 2014, section 3)."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.course.feedback import Choice, Derivation, Formula, Lesson, Line, Number, Task, WithSympy, Wrong
from armproof.course.feedback.answer import is_function, is_missing
from armproof.course.feedback.notebook import Shown
from armproof.models.errors import written
from armproof.models.language import look_up

ARM = "scara_column"
Q_0, Q_F = (0.0, 0.3, 0.05, 0.0), (1.2, 1.3, 0.2, 0.5)  # rad, m: the motion that is simulated
_PERIOD = 4e-3  # s, of the controller
_SAMPLES = 121
_ENDS = ("q_0", "q_f", "t_f")
_CASES = ({"q_0": 0.2, "q_f": 1.4, "t_f": 2.0},)  # rad, s


def show_motion(coefficients: Any, q_0: float = 0.0, q_f: float = 1.2, t_f: float = 0.8) -> Any:
    """Return q, its velocity and its acceleration with a student's coefficients over Drake's quintic, or a polite sentence.

    Args:
        coefficients: the answer to the task `coefficients`.
        q_0, q_f: the positions of one joint (rad).
        t_f: the duration (s).
    """
    found = _coefficients(coefficients, [q_0], [q_f], t_f)
    if isinstance(found, Shown):
        return found
    from armproof.course.figures.drawing.style import GREY, SMALL, STROKES, new_figure, styled
    from armproof.models.motion.quintic import quintic
    from armproof.models.motion.samples import sample_motion

    times = np.linspace(0.0, t_f, _SAMPLES)
    true, given = (sample_motion(motion, times) for motion in (quintic(q_0, q_f, t_f), _trajectory(found, t_f)))
    with styled():
        figure = new_figure("column", 92.0)
        names = ("$q$ (rad)", r"$\dot{q}$ (rad/s)", r"$\ddot{q}$ (rad/s²)")
        for k, (name, right, answer) in enumerate(
            zip(names, (true.q, true.v, true.w), (given.q, given.v, given.w), strict=True)
        ):
            axes = _panel(figure, k, name)
            axes.plot(times, right[:, 0], color=GREY, linewidth=5, alpha=0.3)[0].set_gid("drake")
            axes.plot(times, answer[:, 0], color=STROKES[1].colour, linewidth=1.4)[0].set_gid("answer")
            if k == 0:
                axes.text(0.02, 0.95, "Drake", transform=axes.transAxes, va="top", fontsize=SMALL, color=GREY)
                axes.text(
                    0.02,
                    0.78,
                    look_up("your answer"),
                    transform=axes.transAxes,
                    va="top",
                    fontsize=SMALL,
                    color=STROKES[1].colour,
                )
        return figure


def show_tracking(coefficients: Any, t_f: float = 0.8) -> Any:
    """Return how the simulated SCARA tracks a student's motion, a cubic and a straight line in time, or a polite sentence.

    The arm starts at rest; its controller has exact masses, and the drives have the limits of the model file.

    Args:
        coefficients: the answer to the task `coefficients`.
        t_f: the duration (s).
    """
    quintic = _coefficients(coefficients, Q_0, Q_F, t_f)
    if isinstance(quintic, Shown):
        return quintic
    from armproof.course.figures.drawing.style import SMALL, STROKES, new_figure, styled
    from armproof.models.catalogue import load_arm
    from armproof.models.errors import ModelError
    from armproof.models.motion.tracking import track

    arm, move = load_arm(ARM), np.subtract(Q_F, Q_0)
    none = np.zeros_like(move)
    line = np.column_stack([Q_0, move / t_f])
    cubic = np.column_stack([Q_0, none, 3 * move / t_f**2, -2 * move / t_f**3])
    motions = (
        (look_up("straight line in time"), line, STROKES[2]),
        (look_up("cubic"), cubic, STROKES[0]),
        (look_up("your answer"), quintic, STROKES[1]),
    )
    with styled():
        figure = new_figure("column", 74.0)
        panels = [
            _panel(figure, k, name)
            for k, name in enumerate((r"$\tau_1$ (N m)", look_up("error of $θ_1$ (mrad)")), start=1)
        ]
        for place, (name, values, stroke) in enumerate(motions):
            try:
                log = track(arm, _trajectory(values, t_f), period=_PERIOD, q_start=Q_0)
            except ModelError as problem:
                return Shown(written("`coefficients`: the motion cannot be simulated: {reason}", reason=str(problem)))
            style = {"color": stroke.colour, "linestyle": stroke.linestyle, "linewidth": 1.2}
            panels[0].step(log.times[:-1], log.torques[:-1, 0], where="post", **style)[0].set_gid(f"torque {name}")
            panels[1].plot(log.times, 1000 * (log.q_desired - log.q)[:, 0], **style)[0].set_gid(f"error {name}")
            panels[0].text(
                0.45, 1.42 - 0.16 * place, name, transform=panels[0].transAxes, fontsize=SMALL, color=stroke.colour
            )
        panels[0].set_ylim(-80, 80)
        panels[1].set_ylim(-10, 40)
        return figure


def _panel(figure, place, name):
    """Return one of three plots against time, one above the other."""
    from armproof.course.figures.drawing.plots import plot_axes

    time = "$t$ (s)" if place == 2 else ""
    return plot_axes(figure, (15.0, 11.0 + 27.0 * (2 - place), 64.0, 22.0), "", time, name)


def _coefficients(answer, q_0, q_f, t_f):
    """Return a student's coefficients, (n, 6), a row a joint, or a polite sentence."""
    if is_missing(answer) or not is_function(answer):
        return Shown(written("`{task}`: no function yet, nothing to draw.", task="coefficients"))
    try:
        rows = [np.array(answer(*ends, t_f), dtype=float).ravel() for ends in zip(q_0, q_f, strict=True)]
    except Exception as problem:
        return Shown(written("`{task}`: the function stops with {type}: {reason}", task="coefficients", type=type(problem).__name__, reason=str(problem)))  # fmt: skip
    if all(row.shape == (1,) and np.isnan(row).all() for row in rows):  # what None becomes
        return Shown(written("`{task}`: no answer yet, nothing to draw.", task="coefficients"))
    if any(row.shape != (6,) or not np.isfinite(row).all() for row in rows):
        return Shown(look_up("`coefficients`: six numbers are needed for the plot."))
    return np.array(rows)


def _trajectory(coefficients, t_f):
    """Return a Drake trajectory of polynomials, (n, 6) coefficients from a_0 on."""
    from pydrake.polynomial import Polynomial
    from pydrake.trajectories import PiecewisePolynomial

    column = np.array([[Polynomial(row)] for row in np.ascontiguousarray(coefficients, dtype=float)])
    return PiecewisePolynomial([column], [0.0, t_f])


def system(t_f):
    """Return M: rows q, v, w at t = 0, then at t = t_f; columns a_0 to a_5."""
    t = t_f
    return np.array([
        [1, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 2, 0, 0, 0],
        [1, t, t**2, t**3, t**4, t**5],
        [0, 1, 2 * t, 3 * t**2, 4 * t**3, 5 * t**4],
        [0, 0, 2, 6 * t, 12 * t**2, 20 * t**3],
    ])  # fmt: skip


def coefficients(q_0, q_f, t_f):
    """Return a_0 to a_5 of the motion from rest to rest."""
    d = q_f - q_0
    return np.array([q_0, 0, 0, 10 * d / t_f**3, -15 * d / t_f**4, 6 * d / t_f**5])


def velocity(t, q_0, q_f, t_f):
    """Return the velocity, in factors."""
    return 30 * (q_f - q_0) * t**2 * (t_f - t) ** 2 / t_f**5


def peak_speed(q_0, q_f, t_f):
    """Return the velocity half-way."""
    return 15 * (q_f - q_0) / (8 * t_f)


def peak_acceleration(q_0, q_f, t_f):
    """Return the acceleration where the jerk is zero for the first time."""
    return 10 / np.sqrt(3) * (q_f - q_0) / t_f**2


def durations(d, k_v, k_a):
    """Return the duration T_v for which the peak speed is k_v, and the square of T_a for which the peak acceleration is k_a."""
    return np.array([15 * d / (8 * k_v), 10 * d / (np.sqrt(3) * k_a)])


def _system_with_sympy(sp):
    t, t_f, *a = sp.symbols("t t_f a_0 a_1 a_2 a_3 a_4 a_5")
    q = sum(c * t**k for k, c in enumerate(a))
    rows = [sp.diff(q, t, order).subs(t, at) for at in (0, t_f) for order in (0, 1, 2)]
    return sp.Matrix(rows).jacobian(a)


def _coefficients_by_solve(q_0, q_f, t_f):
    return np.linalg.solve(system(t_f), np.array([q_0, 0, 0, q_f, 0, 0]))


def _coefficients_with_sympy(sp):
    q_0, q_f = sp.symbols("q_0 q_f")
    return _system_with_sympy(sp).LUsolve(sp.Matrix([q_0, 0, 0, q_f, 0, 0]))


def _velocity_with_sympy(sp):
    t, q_0, q_f, t_f = sp.symbols("t q_0 q_f t_f")
    s = t / t_f
    return sp.diff(q_0 + (q_f - q_0) * (10 * s**3 - 15 * s**4 + 6 * s**5), t)


def _halfway(q_0, q_f, t_f):
    return velocity(t_f / 2, q_0, q_f, t_f)


def _at_least_jerk(q_0, q_f, t_f):
    s = 1 / 2 - np.sqrt(3) / 6
    return (q_f - q_0) / t_f**2 * (60 * s - 180 * s**2 + 120 * s**3)


def _peak_with_sympy(sp):
    q_0, q_f, t_f = sp.symbols("q_0 q_f t_f")
    return 10 * sp.sqrt(3) * (q_f - q_0) / (3 * t_f**2)


SYSTEM = r"""\begin{bmatrix} 1 & 0 & 0 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 & 0 & 0 \\ 0 & 0 & 2 & 0 & 0 & 0 \\
1 & t_f & t_f^2 & t_f^3 & t_f^4 & t_f^5 \\ 0 & 1 & 2t_f & 3t_f^2 & 4t_f^3 & 5t_f^4 \\
0 & 0 & 2 & 6t_f & 12t_f^2 & 20t_f^3 \end{bmatrix}"""
COEFFICIENTS = r"""\begin{bmatrix} q_0 \\ 0 \\ 0 \\ \frac{10(q_f - q_0)}{t_f^3} \\ -\frac{15(q_f - q_0)}{t_f^4} \\
\frac{6(q_f - q_0)}{t_f^5} \end{bmatrix}"""
VELOCITY = r"\frac{30(q_f - q_0) t^2 (t_f - t)^2}{t_f^5}"
DURATIONS = r"\begin{bmatrix} \frac{15 d}{8 k_v} \\ \frac{10 d}{\sqrt{3} k_a} \end{bmatrix}"

LESSON = Lesson(
    number=15,
    name="quintic",
    title="Quintic trajectories: six conditions, peaks, limits",
    source="A. Beneult Lefaucheux, TD 1, Étude du robot Scara, 2014, section 3",
    objectives=(
        "Say which six conditions a smooth motion needs, and why.",
        "Solve them, and find the peak speed and the peak acceleration.",
        "Choose a duration that the drives allow, and watch the motion tracked in simulation.",
    ),
    tasks=(
        Task(
            name="predict",
            title="A straight line in time",
            text="The joint goes from $q_0$ to $q_f$ with constant velocity and stands still before and after. What would its acceleration have "
            "to be at the start? Choose `zero`, `constant`, `falling` (large, then falling to zero), or `infinite`.",
            asks=Choice(
                {
                    "zero": "zero, as on the way",
                    "constant": "constant, set by the velocity",
                    "falling": "large, then falling to zero",
                    "infinite": "infinite, for no time at all",
                },
                right="infinite",
                because={
                    "zero": "with zero acceleration a joint at rest stays at rest",
                    "falling": "while it falls the velocity would still change; the straight line has its full velocity at once",
                    "constant": "a constant acceleration needs some time to build the velocity up; the straight line gives it none",
                },
            ),
            hints=(
                "Draw the velocity against time, from a little before the start on.",
                "The acceleration is the slope of that curve.",
                "The velocity jumps from 0 to $(q_f - q_0)/t_f$ at one instant. What is the slope of a jump?",
            ),
            right=("infinite", ["infinite"], ("infinite",)),
            wrong=(
                Wrong("zero", "stays at rest"),
                Wrong("constant", "gives it none"),
                Wrong("falling", "at once"),
                Wrong(["constant", "infinite"], "one of them is asked for"),
            ),
        ),
        Task(
            name="conditions",
            title="Count the conditions",
            text="Position, velocity and acceleration are to be given at the start and at the end. Give two numbers: how many conditions these "
            "are, and the lowest degree of a polynomial that can meet them all, whatever values are given.",
            asks=Number(
                (6, 5),
                labels=("the number of conditions", "the degree"),
                steps=(r"2 \cdot 3", "6 - 1"),
                beside=(r"[2 \cdot 3 + 1,]", r"[2 \cdot 6, 2 \cdot 6 - 1]", r"[3 \cdot 3,]", r"[, 3 \cdot 3 - 1]"),
            ),
            hints=(
                "Count three at each end.",
                "Each condition is one linear equation for the coefficients. How many coefficients do you need?",
                "A polynomial of degree $n$ has $n + 1$ coefficients; do not forget $a_0$.",
            ),
            right=((6, 5), "6, 5", np.array([6, 5])),
            wrong=(
                Wrong((6, 6), "a polynomial of degree 6 has seven coefficients: one too many", own=True),
                Wrong(
                    (4, 3),
                    "positions and velocities alone are four; the accelerations are conditions of their own",
                    own=True,
                ),
                Wrong((2, 1), "the two positions alone give the straight line that you judged above", own=True),
                Wrong((3, 2), "these are the conditions at one end", own=True),
                Wrong((6, 3), "a cubic has four coefficients: too few for six conditions", own=True),
                Wrong((6, 4), "degree 4 has five coefficients: one too few for six conditions", own=True),
                Wrong((6, 7), "degree 7 has eight coefficients: two more than the conditions", own=True),
                Wrong((3, 5), "three conditions at each end make six", own=True),
                Wrong((5, 5), "five is the degree: three conditions at each end make six", own=True),
                Wrong((4, 5), "positions and velocities are four; the two accelerations count, too", own=True),
                Wrong((8, 5), "the jerk is not given: three conditions at each end", own=True),
                Wrong(
                    (6, 2),
                    "the degree is that of the position, whose coefficients are to meet all conditions",
                    own=True,
                ),
            ),
        ),
        Task(
            name="system",
            title="Six equations",
            text="Write the $6 \\times 6$ matrix $M$ of $[q(0), v(0), w(0), q(t_f), v(t_f), w(t_f)]^T = M\\,[a_0, \\dots, a_5]^T$, "
            "rows and columns in this order. A function takes `(t_f)`.",
            asks=Formula(SYSTEM, ("t_f",)),
            hints=(
                "One row a condition: put $t = 0$ or $t = t_f$ into $q$, $v$ or $w$, and read off what stands before each $a_k$.",
                "At $t = 0$ only one coefficient is left in each row; in the third it is $2 a_2$.",
                "The last row is $[0, 0, 2, 6 t_f, 12 t_f^2, 20 t_f^3]$.",
            ),
            right=(system, SYSTEM, WithSympy(_system_with_sympy)),
            wrong=(
                Wrong(SYSTEM.replace("0 & 0 & 2 & 0 & 0 & 0", "0 & 0 & 1 & 0 & 0 & 0"), "entry (3, 3)"),
                Wrong(lambda t_f: system(t_f).T, "the matrix is transposed"),
                Wrong(
                    lambda t_f: system(t_f)[:, ::-1],
                    "the columns go from a_5 to a_0, as np.polyval takes them; here a_0 comes first",
                    own=True,
                ),
                Wrong(
                    lambda t_f: system(t_f)[[0, 3, 1, 4, 2, 5]],
                    "the rows are ordered by quantity; here the start comes first, then the end",
                    own=True,
                ),
                Wrong(
                    SYSTEM.replace("3t_f^2 & 4t_f^3 & 5t_f^4", "t_f^2 & t_f^3 & t_f^4").replace("1 & 2t_f", "1 & t_f"),
                    "the powers were lowered without their factors: the derivative of t^3 is 3 t^2",
                    own=True,
                ),
                Wrong(
                    SYSTEM.replace("12t_f^2 & 20t_f^3", "12t_f^3 & 20t_f^4"),
                    "the last row is differentiated twice: its powers are two lower than those of q",
                    own=True,
                ),
            ),
        ),
        Task(
            name="cubic",
            title="Why not the cubic?",
            text="The cubic $u$ starts and ends at rest too. Give its acceleration at $t = 0$. A function takes `(q_0, q_f, t_f)`.",
            asks=Formula(r"\frac{6(q_f - q_0)}{t_f^2}", _ENDS, unit="rad/s²", cases=_CASES),
            hints=(
                "Differentiate $u$ twice, then put $t = 0$.",
                "Only the term in $t^2$ is left at $t = 0$.",
                "$2 \\cdot 3 (q_f - q_0)/t_f^2$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The first derivative.",
                        r"\frac{d}{dt}\left( 3\frac{t^2}{t_f^2} - 2\frac{t^3}{t_f^3} \right) = \frac{6 t}{t_f^2} - \frac{6 t^2}{t_f^3}",
                    ),
                    Line(
                        "The second.",
                        r"\frac{d}{dt}\left( \frac{6 t}{t_f^2} - \frac{6 t^2}{t_f^3} \right) = \frac{6}{t_f^2} - \frac{12 t}{t_f^3}",
                    ),
                    Line(
                        "At the start the term in $t$ is gone; the way $q_f - q_0$ is a factor.",
                        r"\left. (q_f - q_0) \left( \frac{6}{t_f^2} - \frac{12 t}{t_f^3} \right) \right|_{t = 0} = \frac{6(q_f - q_0)}{t_f^2}",
                    ),
                ),
                {"symbols": {"t": "free", "q_0": "free", "q_f": "free", "t_f": "free"}},
            ),
            right=(
                r"\frac{6(q_f - q_0)}{t_f^2}",
                lambda q_0, q_f, t_f: 6 * (q_f - q_0) / t_f**2,
                WithSympy(
                    lambda sp: (
                        6 * sp.Symbol("q_f") / sp.Symbol("t_f") ** 2 - 6 * sp.Symbol("q_0") / sp.Symbol("t_f") ** 2
                    )
                ),
            ),
            wrong=(
                Wrong("0", "at rest means a velocity of zero; the acceleration is a condition of its own", own=True),
                Wrong(r"\frac{3(q_f - q_0)}{t_f^2}", "the derivative of t^2 taken twice is 2, not 1", own=True),
                Wrong(r"-\frac{6(q_f - q_0)}{t_f^2}", "sign"),
                Wrong(r"\frac{6(q_f - q_0)}{t_f}", "square"),
            ),
        ),
        Task(
            name="coefficients",
            title="From rest to rest",
            text="With velocity and acceleration zero at both ends, give $[a_0, a_1, a_2, a_3, a_4, a_5]$. A function takes `(q_0, q_f, t_f)`.",
            asks=Formula(COEFFICIENTS, _ENDS, cases=_CASES),
            hints=(
                "The first three equations are solved already.",
                "Three unknowns are left: $a_3 t_f^3$, $a_4 t_f^4$, $a_5 t_f^5$; call them $x, y, z$ and $q_f - q_0 = d$.",
                "$x + y + z = d$, $3x + 4y + 5z = 0$, $6x + 12y + 20z = 0$ give $x = 10d$, $y = -15d$, $z = 6d$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "In multiples of $q_f - q_0$ the unknowns are 10, −15 and 6. They add up to 1,",
                        r"10 - 15 + 6 = 1",
                    ),
                    Line("leave no velocity at the end,", r"3 \cdot 10 - 4 \cdot 15 + 5 \cdot 6 = 0"),
                    Line("and no acceleration.", r"6 \cdot 10 - 12 \cdot 15 + 20 \cdot 6 = 0"),
                    Line(
                        "All six conditions at once.",
                        r"""\begin{bmatrix} 1 & 0 & 0 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 & 0 & 0 \\ 0 & 0 & 2 & 0 & 0 & 0 \\
1 & t_f & t_f^2 & t_f^3 & t_f^4 & t_f^5 \\ 0 & 1 & 2t_f & 3t_f^2 & 4t_f^3 & 5t_f^4 \\
0 & 0 & 2 & 6t_f & 12t_f^2 & 20t_f^3 \end{bmatrix} \begin{bmatrix} q_0 \\ 0 \\ 0 \\ \frac{10(q_f - q_0)}{t_f^3} \\ -\frac{15(q_f - q_0)}{t_f^4} \\
\frac{6(q_f - q_0)}{t_f^5} \end{bmatrix} = \begin{bmatrix} q_0 \\ 0 \\ 0 \\ q_f \\ 0 \\ 0 \end{bmatrix}""",
                    ),
                ),
                {"symbols": {"q_0": "free", "q_f": "free", "t_f": "free"}},
            ),
            right=(coefficients, COEFFICIENTS, _coefficients_by_solve, WithSympy(_coefficients_with_sympy)),
            wrong=(
                Wrong(
                    lambda q_0, q_f, t_f: coefficients(q_0, q_f, 1),
                    "the duration is missing: these are the coefficients for t_f = 1",
                    own=True,
                ),
                Wrong(COEFFICIENTS.replace("-\\frac{15", "\\frac{15"), "entry (5, 1): wrong sign"),
                Wrong(
                    lambda q_0, q_f, t_f: coefficients(q_0, q_f, t_f)[::-1],
                    "the order is turned round: a_0 comes first",
                    own=True,
                ),
                Wrong(
                    r"\begin{bmatrix} q_0 \\ 0 \\ \frac{3(q_f - q_0)}{t_f^2} \\ -\frac{2(q_f - q_0)}{t_f^3} \\ 0 \\ 0 \end{bmatrix}",
                    "this is the cubic: its velocities are zero at both ends, its accelerations are not",
                    own=True,
                ),
                Wrong(
                    lambda q_0, q_f, t_f: coefficients(0, q_f, t_f),
                    "this starts from 0, and moves by q_f instead of q_f - q_0",
                    own=True,
                ),
                Wrong(
                    lambda q_0, q_f, t_f: -coefficients(-q_0, q_f - 2 * q_0, t_f),
                    "this goes the other way: the distance is q_f - q_0",
                    own=True,
                ),
            ),
        ),
        Task(
            name="velocity",
            title="The velocity",
            text="Give the velocity of this motion in $t, q_0, q_f, t_f$; in factors it shows why the motion does not overshoot. A function takes "
            "`(t, q_0, q_f, t_f)`.",
            asks=Formula(VELOCITY, ("t", *_ENDS), unit="rad/s", cases=({"t": 0.5, **_CASES[0]},)),
            hints=(
                "Differentiate $10 t^3/t_f^3 - 15 t^4/t_f^4 + 6 t^5/t_f^5$.",
                "All three terms have $30 t^2$ in common.",
                "What is left, $t_f^2 - 2 t t_f + t^2$, is a square.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Differentiate each term.",
                        r"\frac{d}{dt}\left( 10\frac{t^3}{t_f^3} - 15\frac{t^4}{t_f^4} + 6\frac{t^5}{t_f^5} \right) = \frac{30 t^2}{t_f^3} - \frac{60 t^3}{t_f^4} + \frac{30 t^4}{t_f^5}",
                    ),
                    Line(
                        "Take out what all three have in common.",
                        r"\frac{30 t^2}{t_f^3} - \frac{60 t^3}{t_f^4} + \frac{30 t^4}{t_f^5} = \frac{30 t^2}{t_f^5} (t_f^2 - 2 t t_f + t^2)",
                    ),
                    Line("A square is left.", r"t_f^2 - 2 t t_f + t^2 = (t_f - t)^2"),
                ),
                {"symbols": {"t": "free", "q_0": "free", "q_f": "free", "t_f": "free"}},
            ),
            right=(
                velocity,
                VELOCITY,
                WithSympy(_velocity_with_sympy),
                r"(q_f - q_0) \left( \frac{30 t^2}{t_f^3} - \frac{60 t^3}{t_f^4} + \frac{30 t^4}{t_f^5} \right)",
            ),
            wrong=(
                Wrong(
                    r"(q_f - q_0) (30 s^2 - 60 s^3 + 30 s^4)".replace("s", r"\left(\frac{t}{t_f}\right)"),
                    "this is the derivative with respect to t/t_f: the chain rule divides by t_f once more",
                    own=True,
                ),
                Wrong(
                    r"(q_f - q_0) \left( \frac{30 t^2}{t_f^3} + \frac{60 t^3}{t_f^4} + \frac{30 t^4}{t_f^5} \right)",
                    "sign",
                ),
                Wrong(
                    lambda t, q_0, q_f, t_f: q_0 + velocity(t, q_0, q_f, t_f),
                    "the constant q_0 has no part in the velocity",
                    own=True,
                ),
                Wrong(
                    r"\frac{(q_f - q_0)(10 t^2 t_f^2 - 15 t^3 t_f + 6 t^4)}{t_f^5}",
                    "the exponents are lowered, but they do not stand before the powers as factors: of t^3 the derivative is 3 t^2",
                    own=True,
                ),
                Wrong(
                    r"\frac{60(q_f - q_0) t (t_f - t)(t_f - 2t)}{t_f^5}",
                    "this is the acceleration: differentiated once too often",
                    own=True,
                ),
                Wrong(r"\frac{6(q_f - q_0) t (t_f - t)}{t_f^3}", "this is the velocity of the cubic", own=True),
                Wrong(
                    r"q_0 + (q_f - q_0) \left(\frac{10t^3}{t_f^3} - \frac{15t^4}{t_f^4} + \frac{6t^5}{t_f^5}\right)",
                    "this is the position: its derivative is asked",
                    own=True,
                ),
            ),
        ),
        Task(
            name="peak_speed",
            title="Peak speed",
            text="Give the highest velocity on the way, for $q_f > q_0$ (so that no absolute value is needed). A function takes `(q_0, q_f, t_f)`.",
            asks=Formula(r"\frac{15}{8} \cdot \frac{q_f - q_0}{t_f}", _ENDS, unit="rad/s", cases=_CASES),
            hints=(
                "Where is $t(t_f - t)$ largest?",
                "Half-way, at $t = t_f/2$.",
                "$30 \\cdot (1/2)^2 \\cdot (1/2)^2$, over $t_f$, times the distance.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Half-way, the acceleration is zero: the two factors grow and fall alike.",
                        r"\left. \frac{d}{dt} \left( t^2 (t_f - t)^2 \right) \right|_{t = \frac{t_f}{2}} = 0",
                    ),
                    Line(
                        "Put half the time into the velocity.",
                        r"\left. \frac{30 (q_f - q_0) t^2 (t_f - t)^2}{t_f^5} \right|_{t = \frac{t_f}{2}} = \frac{15}{8} \cdot \frac{q_f - q_0}{t_f}",
                    ),
                    Line(
                        "No other velocity is higher: the difference is a square times what is positive on the way.",
                        r"\frac{15}{8} \cdot \frac{q_f - q_0}{t_f} - \frac{30 (q_f - q_0) t^2 (t_f - t)^2}{t_f^5} = \frac{15}{8} \cdot \frac{(q_f - q_0)(t_f - 2t)^2 \left( t_f^2 + 4t(t_f - t) \right)}{t_f^5}",
                    ),
                ),
                {"symbols": {"t": "free", "q_0": "free", "q_f": "free", "t_f": "free"}},
            ),
            right=(
                peak_speed,
                r"\frac{15}{8} \cdot \frac{q_f - q_0}{t_f}",
                _halfway,
                WithSympy(lambda sp: sp.Rational(15, 8) * (sp.Symbol("q_f") - sp.Symbol("q_0")) / sp.Symbol("t_f")),
            ),
            wrong=(
                Wrong(
                    r"\frac{q_f - q_0}{t_f}",
                    "this is the mean velocity, that of the straight line; starting and stopping costs speed half-way",
                    own=True,
                ),
                Wrong(r"\frac{3}{2} \cdot \frac{q_f - q_0}{t_f}", "this is the peak of the cubic", own=True),
                Wrong(
                    lambda q_0, q_f, t_f: 15 * abs(q_f - q_0) / (8 * t_f),
                    "for q_f > q_0 no absolute value is needed: leave it out",
                    own=True,
                ),
                Wrong(r"\frac{15}{8} (q_f - q_0)", "a velocity has to be divided by the duration", own=True),
                Wrong(
                    r"\frac{15}{2} \cdot \frac{q_f - q_0}{t_f}",
                    "half-way both squares give a quarter: 30 times 1/16",
                    own=True,
                ),
                Wrong(r"\frac{15}{8} \cdot \frac{q_0 - q_f}{t_f}", "sign"),
            ),
        ),
        Task(
            name="peak_acceleration",
            title="Peak acceleration",
            text="Give the highest acceleration on the way, exactly, for $q_f > q_0$. A function takes `(q_0, q_f, t_f)`.",
            asks=Formula(r"\frac{10}{\sqrt{3}} \cdot \frac{q_f - q_0}{t_f^2}", _ENDS, unit="rad/s²", cases=_CASES),
            hints=(
                "The acceleration is largest where its own derivative, the jerk, is zero.",
                "With $s = t/t_f$ the acceleration is $60 s (1 - s)(1 - 2s)$ times the distance over $t_f^2$, the jerk $60(1 - 6s + 6s^2)$ times the distance over $t_f^3$.",
                "$s = 1/2 - \\sqrt{3}/6$, where $s(1 - s) = 1/6$ and $1 - 2s = 1/\\sqrt{3}$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "The acceleration, in factors.",
                        r"\frac{d}{dt} \left( \frac{30 (q_f - q_0) t^2 (t_f - t)^2}{t_f^5} \right) = \frac{60 (q_f - q_0) t (t_f - t) (t_f - 2t)}{t_f^5}",
                    ),
                    Line(
                        "Its derivative is a square less a constant.",
                        r"\frac{d}{dt} \left( t (t_f - t) (t_f - 2t) \right) = 6 \left( t - \frac{t_f}{2} \right)^2 - \frac{t_f^2}{2}",
                    ),
                    Line(
                        "It vanishes here, before the middle.",
                        r"\left. 6 \left( t - \frac{t_f}{2} \right)^2 - \frac{t_f^2}{2} \right|_{t = t_f \left( \frac{1}{2} - \frac{\sqrt{3}}{6} \right)} = 0",
                    ),
                    Line(
                        "There the acceleration is",
                        r"\left. \frac{60 (q_f - q_0) t (t_f - t) (t_f - 2t)}{t_f^5} \right|_{t = t_f \left( \frac{1}{2} - \frac{\sqrt{3}}{6} \right)} = \frac{10}{\sqrt{3}} \cdot \frac{q_f - q_0}{t_f^2}",
                    ),
                ),
                {"symbols": {"t": "free", "q_0": "free", "q_f": "free", "t_f": "free"}},
            ),
            right=(
                peak_acceleration,
                r"\frac{10}{\sqrt{3}} \cdot \frac{q_f - q_0}{t_f^2}",
                r"\frac{10\sqrt{3}(q_f - q_0)}{3 t_f^2}",
                WithSympy(_peak_with_sympy),
                _at_least_jerk,
            ),
            wrong=(
                Wrong(
                    r"6 \cdot \frac{q_f - q_0}{t_f^2}", "this is the acceleration with which the cubic starts", own=True
                ),
                Wrong(
                    r"\frac{10}{\sqrt{3}} \cdot \frac{q_f - q_0}{t_f}",
                    "an acceleration falls with the square of the duration",
                    own=True,
                ),
                Wrong(
                    lambda q_0, q_f, t_f: 5.77 * (q_f - q_0) / t_f**2,
                    "close, but rounded: give the root, not its decimals",
                    own=True,
                ),
                Wrong(
                    lambda q_0, q_f, t_f: 5.7735 * (q_f - q_0) / t_f**2,
                    "close, but rounded: give the root, not its decimals",
                    own=True,
                ),
                Wrong(
                    r"\frac{10}{3} \cdot \frac{q_f - q_0}{t_f^2}", "1 - 2s is 1 over the root of 3, not 1/3", own=True
                ),
                Wrong(r"-\frac{10}{\sqrt{3}} \cdot \frac{q_f - q_0}{t_f^2}", "sign"),
                Wrong("0", "half-way the acceleration is zero: there the velocity is highest", own=True),
            ),
        ),
        Task(
            name="durations",
            title="The shortest duration",
            text="A joint has a highest speed $k_v$ and a highest acceleration $k_a$, and moves by $d > 0$. Its peak speed is $k_v$ for the duration $T_v$, "
            "its peak acceleration $k_a$ for the duration $T_a$. Give $[T_v, T_a^2]^T$ (mind the square: s, s²). A function takes `(d, k_v, k_a)`.",
            asks=Formula(DURATIONS, ("d", "k_v", "k_a")),
            hints=(
                "Put $q_f - q_0 = d$ into both peaks.",
                "Solve $\\frac{15}{8} d / T_v = k_v$ and $\\frac{10}{\\sqrt{3}} d / T_a^2 = k_a$.",
                "$T_v = 15 d / (8 k_v)$; the second is $10 d / (\\sqrt{3} k_a)$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Put $q_f - q_0 = d$ into the peak speed: at this duration it is $k_v$.",
                        r"\left. \frac{15 d}{8 T} \right|_{T = \frac{15 d}{8 k_v}} = k_v",
                    ),
                    Line(
                        "In the peak acceleration stands the square of the duration, $s = T^2$: at this square it is $k_a$.",
                        r"\left. \frac{10 d}{\sqrt{3} s} \right|_{s = \frac{10 d}{\sqrt{3} k_a}} = k_a",
                    ),
                    Line(
                        "Both in a column; without a root below the line it is the same.",
                        r"\begin{bmatrix} \frac{15 d}{8 k_v} \\ \frac{10 d}{\sqrt{3} k_a} \end{bmatrix} = \begin{bmatrix} \frac{15}{8} \cdot \frac{d}{k_v} \\ \frac{10\sqrt{3}}{3} \cdot \frac{d}{k_a} \end{bmatrix}",
                    ),
                ),
                {"symbols": {"d": "free", "k_v": "free", "k_a": "free", "T": "free", "s": "free"}},
            ),
            right=(
                durations,
                DURATIONS,
                WithSympy(
                    lambda sp: sp.Matrix(
                        [
                            sp.Rational(15, 8) * sp.Symbol("d") / sp.Symbol("k_v"),
                            10 * sp.sqrt(3) * sp.Symbol("d") / (3 * sp.Symbol("k_a")),
                        ]
                    )
                ),
            ),
            wrong=(
                Wrong(
                    lambda d, k_v, k_a: [d / k_v, d / k_a],
                    "these leave out the factors of the peaks: the quintic is faster half-way than on average",
                    own=True,
                ),
                Wrong(
                    lambda d, k_v, k_a: durations(d, k_v, k_a)[::-1], "the two are swapped: T_v comes first", own=True
                ),
                Wrong(
                    lambda d, k_v, k_a: [15 * d / (8 * k_v), np.sqrt(10 * d / (np.sqrt(3) * k_a))],
                    "this is T_a; its square is asked for",
                    own=True,
                ),
                Wrong(
                    lambda d, k_v, k_a: [8 * d / (15 * k_v), 10 * d / (np.sqrt(3) * k_a)],
                    "the factor 15/8 is upside down",
                    own=True,
                ),
                Wrong(lambda d, k_v, k_a: [3 * d / (2 * k_v), 6 * d / k_a], "these belong to the cubic", own=True),
            ),
        ),
        Task(
            name="quicker",
            title="Three times as fast",
            text="The same motion is to take a third of the time. By which factors do the peak speed and the peak acceleration grow? Give both, in this order.",
            asks=Number(
                (3, 9),
                labels=("the factor of the speed", "the factor of the acceleration"),
                steps=("3", "3^2"),
                beside=(r"[, 2 \cdot 3]", "[, 3 + 1]", "[3^2, 3^4]", r"[\sqrt{3}, 3]", "[1/3, 1/3]", "[3^3,]"),
            ),
            hints=(
                "Look at the power of $t_f$ in each peak.",
                "The speed has $t_f$ below the line, the acceleration $t_f^2$.",
                "Put $t_f/3$ for $t_f$ in both.",
            ),
            right=((3, 9), "3, 9", [3.0, 9.0]),
            wrong=(
                Wrong((3, 3), "the acceleration has the square of the duration below the line", own=True),
                Wrong((1 / 3, 1 / 9), "a shorter motion is faster, not slower", own=True),
                Wrong((9, 3), "the other way round: speed first", own=True),
                Wrong((9, 9), "the factor of the speed is not 9"),
                Wrong((2, 4), "this is for half the time: a third of it is asked", own=True),
                Wrong((3, 27), "that is the factor of the jerk", own=True),
                Wrong((1, 9), "the same way in a third of the time: the speed grows as well", own=True),
                Wrong(
                    (3, 1), "the acceleration has the square of the duration below the line: it grows most", own=True
                ),
                Wrong(
                    (1, 3),
                    "one power of the duration too few in both: it stands below the line once in the speed, squared in the acceleration",
                    own=True,
                ),
                Wrong(
                    (9, 27),
                    "one power of the duration too many in both: it stands below the line once in the speed, squared in the acceleration",
                    own=True,
                ),
                Wrong(
                    (15 / 8, 10 / np.sqrt(3)),
                    "these are the factors of the peaks: how do they change with the duration?",
                    own=True,
                ),
                Wrong((3, 3**0.5), "the square of 3, not its root", own=True),
                Wrong((1 / 3, 9), "a shorter motion is faster: the speed grows", own=True),
                Wrong((3, 1 / 9), "a shorter motion takes more acceleration, not less", own=True),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A ram goes out by 0.4 m in 5 s on a quintic that starts and ends at rest. Give its peak speed (m/s).",
            asks=Number(
                0.15,
                "m/s",
                labels=("the peak speed",),
                steps=("v_m = 0.4/5", r"v = 15/8 \cdot v_m"),
                beside=(
                    r"10/\sqrt{3} \cdot 0.4/5",
                    r"6 \cdot 0.4/5^2",
                    "0.4/5^2",
                    r"3/2 \cdot 0.4/5",
                    r"2 \cdot 0.4/5",
                    r"3 \cdot 0.4/5",
                    r"3/2 \cdot 0.4",
                    r"3/2 \cdot 0.4/5^2",
                    r"10/\sqrt{3} \cdot 0.4",
                    r"\pi/2 \cdot 0.4/5",
                    r"15/8 \cdot 0.4/5^2",
                ),
            ),
            hints=(
                "A slide moves as a turn does: put the distance where the angle stood.",
                "The peak is $\\frac{15}{8}$ of the mean speed, in the middle.",
            ),
            right=(0.15, "0.15", np.array([0.15])),
            wrong=(
                Wrong(0.08, "this is the mean speed: the peak of a quintic is 15/8 of it", own=True),
                Wrong(0.4, "this is the distance: a speed is asked", own=True),
                Wrong(2, "distance times time is no speed: divide, and the peak is 15/8 of that", own=True),
                Wrong(0.12, "this is the peak of the cubic, 3/2 of the mean speed", own=True),
                Wrong(10 / np.sqrt(3) * 0.4 / 5**2, "this is the peak acceleration, in m/s²", own=True),
                Wrong(15 / 8 * 0.4, "the time is 5 s: divide the distance by it", own=True),
                Wrong(15 / 8 * 0.4 * 5, "the distance is divided by the time, not multiplied", own=True),
                Wrong(0.075, "15/8 of the mean speed, which is 0.08 m/s", own=True),
            ),
        ),
    ),
)
