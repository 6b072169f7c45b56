# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Quintic trajectories: six conditions, peaks, limits"
# source: A. Beneult Lefaucheux, TD 1, Étude du robot Scara, 2014, section 3 (document 004)
# ---

# %% [markdown]
# # 15 · Quintic trajectories: six conditions, peaks, limits
#
# Lesson 14 found joint values for a target. Now the arm has to get there (*trajectoire articulaire*). Section 3 of
# document 004 describes the method in words, without a formula; you write the formulas. In this lesson you
#
# 1. say which six conditions a smooth motion needs, and why,
# 2. solve them, and find the peak speed and the peak acceleration,
# 3. choose a duration that the drives allow, and watch Drake track the motion.
#
# $q$ is one joint variable, $t$ the time, $t_f$ the duration.
#
# An answer may be a Python function, a SymPy expression or LaTeX.
# `lesson.predict` shows the task in full,
# `lesson.predict.hint()` gives a hint, one more at each call.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.course.tasks.quintic import show_motion, show_tracking

lesson = open_lesson("quintic")
lesson

# %% [markdown]
# The arm that will move: the SCARA on its column.

# %%
draw_kind(find_kind("sketch"), load_arm("scara_column"))

# %% [markdown]
# ## Predict: a straight line
#
# With the two positions alone, two coefficients are enough, and the graph is a straight line (section 3.1):
#
# $$ q_\ell = q_0 + (q_f - q_0) \frac{t}{t_f} $$
#
# $$ \frac{dq_\ell}{dt} = \frac{q_f - q_0}{t_f} $$
#
# The joint stands still before the start. What would its acceleration have to be at the start: `"zero"`, `"constant"`,
# `"falling"` (large, then falling to zero) or `"infinite"`?

# %%
### BEGIN SOLUTION
acceleration = "infinite"
### END SOLUTION
lesson.predict.check(acceleration)

# %% [markdown]
# ## Six conditions
#
# The document gives position, velocity and acceleration at both ends. Write two numbers: how many conditions that is,
# and the lowest degree of a polynomial that can meet them all.

# %%
### BEGIN SOLUTION
count = [6, 5]
### END SOLUTION
lesson.conditions.check(count)

# %% [markdown]
# The polynomial with its velocity $v$ and its acceleration $w$:
#
# $$ q = a_0 + a_1 t + a_2 t^2 + a_3 t^3 + a_4 t^4 + a_5 t^5 $$
#
# $$ v = \frac{dq}{dt} = a_1 + 2a_2 t + 3a_3 t^2 + 4a_4 t^3 + 5a_5 t^4 $$
#
# $$ w = \frac{dv}{dt} = 2a_2 + 6a_3 t + 12a_4 t^2 + 20a_5 t^3 $$
#
# At the start only three coefficients are left:
#
# $$ \left. q \right|_{t = 0} = a_0, \qquad \left. v \right|_{t = 0} = a_1, \qquad \left. w \right|_{t = 0} = 2a_2 $$
#
# Section 3.3 sets up all six equations as one linear system,
# $[q(0), v(0), w(0), q(t_f), v(t_f), w(t_f)]^T = M [a_0, \dots, a_5]^T$. Write $M$.


# %%
def system(t_f):
    """Return the 6×6 matrix M: rows q, v, w at 0, then at t_f; columns a_0 to a_5."""
    ### BEGIN SOLUTION
    T = t_f
    return np.array(
        [
            [1, 0, 0, 0, 0, 0],
            [0, 1, 0, 0, 0, 0],
            [0, 0, 2, 0, 0, 0],
            [1, T, T**2, T**3, T**4, T**5],
            [0, 1, 2 * T, 3 * T**2, 4 * T**3, 5 * T**4],
            [0, 0, 2, 6 * T, 12 * T**2, 20 * T**3],
        ]
    )
    ### END SOLUTION


lesson.system.check(system)

# %% [markdown]
# ## Why zero, and why the accelerations too
#
# Section 3.2 says: the robot stands still before and after, so velocities and accelerations are zero there. Standing
# still settles the velocities only. This cubic starts and ends at rest:
#
# $$ u = q_0 + (q_f - q_0) \left( 3\frac{t^2}{t_f^2} - 2\frac{t^3}{t_f^3} \right) $$
#
# $$
# \left. \frac{du}{dt} \right|_{t = 0} = \left. \frac{du}{dt} \right|_{t = t_f} = 0
# $$
#
# Write its acceleration at $t = 0$ in $q_0$, $q_f$, $t_f$.

# %%
### BEGIN SOLUTION
cubic = r"\frac{6 (q_f - q_0)}{t_f^2}"
### END SOLUTION
lesson.cubic.check(cubic)

# %% [markdown]
# Before the start the acceleration is zero: it jumps, and with it the torque of the drive. The two conditions on the
# accelerations take this jump away. Solve the six equations, for a motion from rest to rest.


# %%
def coefficients(q_0, q_f, t_f):
    """Return [a_0, a_1, a_2, a_3, a_4, a_5], velocities and accelerations zero at both ends."""
    ### BEGIN SOLUTION
    d = q_f - q_0
    return np.array([q_0, 0, 0, 10 * d / t_f**3, -15 * d / t_f**4, 6 * d / t_f**5])
    ### END SOLUTION


lesson.coefficients.check(coefficients)

# %% [markdown]
# Your motion over Drake's (grey): position, velocity, acceleration of one joint.

# %%
show_motion(coefficients, q_0=0.0, q_f=1.2, t_f=0.8)

# %% [markdown]
# ## Peaks
#
# Write the velocity of your motion in $t$, $q_0$, $q_f$, $t_f$, and bring it into factors.

# %%
### BEGIN SOLUTION
velocity = r"\frac{30 (q_f - q_0) t^2 (t_f - t)^2}{t_f^5}"
### END SOLUTION
lesson.velocity.check(velocity)

# %% [markdown]
# It is a square times a constant, so it never changes its sign: no overshoot. Write the highest velocity, for
# $q_f > q_0$.

# %%
### BEGIN SOLUTION
peak_speed = r"\frac{15 (q_f - q_0)}{8 t_f}"
### END SOLUTION
lesson.peak_speed.check(peak_speed)

# %% [markdown]
# The peak acceleration is where the jerk, the next derivative, vanishes. Keep the root exact.


# %%
def peak_acceleration(q_0, q_f, t_f):
    """Return the highest acceleration on the way, for q_f > q_0."""
    ### BEGIN SOLUTION
    return 10 / np.sqrt(3) * (q_f - q_0) / t_f**2
    ### END SOLUTION


lesson.peak_acceleration.check(peak_acceleration)

# %% [markdown]
# Four joints that start and stop together, with their peaks: speeds half-way, accelerations before and behind. Angles and lengths stand on axes of their own.

# %%
draw_kind(find_kind("quintic"), load_arm("scara_column"))

# %% [markdown]
# ## Limits
#
# A drive has a highest speed $k_v$ and a highest acceleration $k_a$. A motion over $d$ just reaches $k_v$ if it takes
# the time $T_v$, and just reaches $k_a$ if it takes $T_a$. Write $T_v$ and $T_a^2$; the longer of the two times counts.


# %%
def durations(d, k_v, k_a):
    """Return [T_v, T_a**2] for a joint that moves by d > 0."""
    ### BEGIN SOLUTION
    return np.array([15 * d / (8 * k_v), 10 * d / (np.sqrt(3) * k_a)])
    ### END SOLUTION


lesson.durations.check(durations)

# %% [markdown]
# ## Tracked by Drake
#
# Now the whole arm follows your polynomials in simulation, by inverse dynamics (*couple calculé*), against the
# straight line and the cubic. Shown are the torque of the first drive and the error of its joint. Look at the start
# and the end of each curve.

# %%
show_tracking(coefficients, t_f=0.8)

# %% [markdown]
# The straight line asks for more torque than the plot shows. The cubic starts with the jump that you computed; your
# quintic starts from zero. Last question: by which factors do peak speed and peak acceleration grow if this motion is
# to take a third of the time? Write both.

# %%
### BEGIN SOLUTION
factors = [3, 9]
### END SOLUTION
lesson.quicker.check(factors)

# %% [markdown]
# ## An arm that you have not seen
#
# A ram goes out by 0.4 m in 5 s on a quintic that starts and ends at rest. How fast is it at its peak (m/s)?

# %%
### BEGIN SOLUTION
peak = 0.15
### END SOLUTION
lesson.transfer.check(peak)

# %% [markdown]
# ## Once more
#
# A task of lesson 12 comes back. Do it without looking.

# %%
lesson.review

# %%
### BEGIN SOLUTION
again = lesson.review.right[0]
### END SOLUTION
lesson.review.check(again)

# %% [markdown]
# ## What you know now
#
# - Six conditions, six coefficients: position, velocity and acceleration at both ends.
# - Peaks follow from distance and duration alone: 15/8 of the mean speed.
# - Half the time is twice the speed and four times the acceleration.
#
# ## Further
#
# - `course/handouts/quintic-004.md` proves the peaks, and finds the distance at which the acceleration stops being the
#   limit.
# - `armproof.models.motion.quintic` takes any velocities and accelerations at the ends; `armproof.models.motion.time_optimal` is faster,
#   and less smooth.
# - `track(..., mass_factor=0.8)` of `armproof.models.motion.tracking` gives the controller wrong masses: see what error that
#   makes.
