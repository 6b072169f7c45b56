# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "The SCARA's exercises by hand"
# source: F. Morbidi, TD 3, 2019 (document 000) and A. Beneult Lefaucheux, TD 1, 2014 (document 004)
# arm: scara
# transforms: upper
# quantities:
#   "z_3": {axis: 3}
#   "p_3": {origin: 3}
#   "p_4": {origin: 4}
# ---

# %% [markdown]
# # 18 · The SCARA's exercises by hand
#
# Lessons 12 and 14 took the long steps of two exercise sheets. Here are the short ones between, each by itself, as on paper. The
# parts can be done on different days.
#
# ## Document 000: poses, origins, axes
#
# Its SCARA has the tool pointing down.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch

lesson = open_lesson("scara_again")
lesson

# %%
sketch(load_arm("scara"))

# %% [markdown]
# Write $T^0_3 = A^0_1 A^1_2 A^2_3$, 4×4.

# %%
### BEGIN SOLUTION
T_03 = r"""\begin{bmatrix} c_{12} & s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & -c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\
0 & 0 & -1 & -d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.third_pose.check(T_03)

# %% [markdown]
# Then $T^0_4 = T^0_3 A^3_4$.


# %%
def pose(q, a_1, a_2, d_4):
    """Return the pose of frame 4 in frame 0, 4×4; q holds theta_1, theta_2, d_3, theta_4."""
    ### BEGIN SOLUTION
    theta_1, theta_2, d_3, theta_4 = q
    c, s = np.cos(theta_1 + theta_2 - theta_4), np.sin(theta_1 + theta_2 - theta_4)
    x = a_1 * np.cos(theta_1) + a_2 * np.cos(theta_1 + theta_2)
    y = a_1 * np.sin(theta_1) + a_2 * np.sin(theta_1 + theta_2)
    return np.array([[c, s, 0, x], [s, -c, 0, y], [0, 0, -1, -(d_3 + d_4)], [0, 0, 0, 1]])
    ### END SOLUTION


lesson.tool_down.check(pose)

# %%
lesson.tool_down.show(pose, theta_1=0.5, theta_2=0.8, d_3=0.1, theta_4=0.4)

# %% [markdown]
# Read $p_3$ off your first matrix.

# %%
### BEGIN SOLUTION
p_3 = r"\begin{bmatrix} a_1 c_1 + a_2 c_{12} \\ a_1 s_1 + a_2 s_{12} \\ -d_3 \end{bmatrix}"
### END SOLUTION
lesson.origins.check(p_3)

# %% [markdown]
# The axes $z_0$ to $z_3$ are vertical. Their third entries?

# %%
### BEGIN SOLUTION
third_entries = [1, 1, -1, -1]
### END SOLUTION
lesson.axes_down.check(third_entries)

# %% [markdown]
# Write the last lever, $p_4 - p_3$.

# %%
### BEGIN SOLUTION
lever = r"\begin{bmatrix} 0 \\ 0 \\ -d_4 \end{bmatrix}"
### END SOLUTION
lesson.last_lever.check(lever)

# %% [markdown]
# So a column of the Jacobian has zeros above:
#
# $$ z_3 \times (p_4 - p_3) = 0 $$
#
# Why? `a`: $p_4 = p_3$; `b`: both vectors are parallel; `c`: joint 4 is a slide; `d`: $z_3 = 0$.

# %%
### BEGIN SOLUTION
why = "b"
### END SOLUTION
lesson.parallel.check(why)

# %% [markdown]
# ## Document 000: the drawing
#
# Draw the arm from above at $\theta_1 = 90°$ and $\theta_2 = \pi$, one of its singular configurations, with $a_1 = 0.4$ m and $a_2 = 0.25$ m.
# Where are elbow and tool?

# %%
### BEGIN SOLUTION
drawn = [0, 0.4, 0, 0.15]
### END SOLUTION
lesson.folded.check(drawn)

# %% [markdown]
# ## Document 004: the model
#
# The same arm on a column of height $d_1$. The document's table is not printed; write the classic one, rows $(\theta_i, d_i, a_i, \alpha_i)$,
# from the matrices $H_1$ to $H_4$ of lesson 14.

# %%
### BEGIN SOLUTION
table = [
    ("theta_1", "d_1", "a_1", 0),
    ("theta_2", 0, "a_2", "pi"),
    (0, "d_3", 0, 0),
    ("theta_4", "d_4", 0, 0),
]
### END SOLUTION
lesson.column_table.check(table)

# %% [markdown]
# Write the product $H_0^4$.

# %%
### BEGIN SOLUTION
H = r"""\begin{bmatrix} \cos(\theta_1 + \theta_2 - \theta_4) & \sin(\theta_1 + \theta_2 - \theta_4) & 0 & a_1 C_1 + a_2 C_{12} \\
\sin(\theta_1 + \theta_2 - \theta_4) & -\cos(\theta_1 + \theta_2 - \theta_4) & 0 & a_1 S_1 + a_2 S_{12} \\
0 & 0 & -1 & d_1 - d_3 - d_4 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.whole_pose.check(H)

# %% [markdown]
# And the part for the orientation, MGDori.


# %%
def orientation(q):
    """Return the rotation of frame 4, 3×3."""
    ### BEGIN SOLUTION
    c, s = np.cos(q[0] + q[1] - q[3]), np.sin(q[0] + q[1] - q[3])
    return np.array([[c, s, 0], [s, -c, 0], [0, 0, -1]])
    ### END SOLUTION


lesson.orientation.check(orientation)

# %% [markdown]
# ## Document 004: the inverse, the short steps
#
# Expand $X^2 + Y^2$ until only $\theta_2$ is left.

# %%
### BEGIN SOLUTION
squares = r"a_1^2 + a_2^2 + 2 a_1 a_2 \cos\theta_2"
### END SOLUTION
lesson.squares.check(squares)

# %% [markdown]
# With $k_1 = a_1 + a_2\cos\theta_2$ and $k_2 = a_2\sin\theta_2$, write $X$ and $Y$ in $\theta_1$, $k_1$, $k_2$.

# %%
### BEGIN SOLUTION
collected = r"\begin{bmatrix} k_1 \cos\theta_1 - k_2 \sin\theta_1 \\ k_2 \cos\theta_1 + k_1 \sin\theta_1 \end{bmatrix}"
### END SOLUTION
lesson.collected.check(collected)

# %% [markdown]
# The document puts $k_1 = r\cos\alpha$, $k_2 = r\sin\alpha$. Write $r$ and $\alpha$.


# %%
def r_and_alpha(k_1, k_2):
    """Return r and alpha (rad)."""
    ### BEGIN SOLUTION
    return [np.sqrt(k_1**2 + k_2**2), np.arctan2(k_2, k_1)]
    ### END SOLUTION


lesson.amplitude.check(r_and_alpha)

# %% [markdown]
# So $X = r\cos(\theta_1 + \alpha)$ and $Y = r\sin(\theta_1 + \alpha)$, and $\theta_1$ is the angle of the target less $\alpha$.
#
# Links of 0.48 m and 0.2 m, target $X = 0.52$ m, $Y = 0$, $\psi = 0$. One posture has $\theta_2 = \pi/2$ and
# $\theta_1 = -\text{atan2}(0.2, 0.48)$. Give $[\theta_1, \theta_2, \theta_4]$ of the other.

# %%
### BEGIN SOLUTION
theta_1 = np.arctan2(0.2, 0.48)
other = [theta_1, -np.pi / 2, theta_1 - np.pi / 2]
### END SOLUTION
lesson.second_posture.check(other)

# %% [markdown]
# ## Document 001: solve its SCARA
#
# No source does this one: $x = a_2 C_1 + a_3 C_{12}$, $y = a_2 S_1 + a_3 S_{12}$, $z = -d_2$, $\phi = \theta_1 + \theta_2 + \theta_4$. Solve for
# the posture with $0 \le \theta_2 \le \pi$.


# %%
def inverse(x, y, z, phi, a_2, a_3):
    """Return theta_1, theta_2, d_2, theta_4."""
    ### BEGIN SOLUTION
    theta_2 = np.arccos((x**2 + y**2 - a_2**2 - a_3**2) / (2 * a_2 * a_3))
    k_1, k_2 = a_2 + a_3 * np.cos(theta_2), a_3 * np.sin(theta_2)
    theta_1 = np.arctan2(y, x) - np.arctan2(k_2, k_1)
    return [theta_1, theta_2, -z, phi - theta_1 - theta_2]
    ### END SOLUTION


lesson.upright_inverse.check(inverse)

# %% [markdown]
# ## Document 004: two questions for words
#
# Write an answer of your own to questions 3.1 and 3.2 on paper first: the principle of the polynomial of degree five, and why the motion
# starts and ends at rest. Then choose what belongs in it.
#
# 3.1, `a`: positions alone give a straight line in time; `b`: position, velocity and acceleration at both ends are six conditions; `c`: a
# polynomial of degree five has six coefficients; `d`: it is the fastest motion that there is; `e`: each joint needs the others' coefficients.

# %%
### BEGIN SOLUTION
principle = ["a", "b", "c"]
### END SOLUTION
lesson.principle.check(principle)

# %% [markdown]
# 3.2, `a`: the robot stands still before and after, and a velocity cannot jump; `b`: a jump of the velocity would need an infinite
# acceleration; `c`: a jump of the acceleration is a jump of the motors' torque; `d`: the velocity is zero during the whole motion;
# `e`: without it there are more equations than unknowns.

# %%
### BEGIN SOLUTION
rest = ["a", "b", "c"]
### END SOLUTION
lesson.rest.check(rest)

# %% [markdown]
# ## An arm that you have not seen
#
# A SCARA of another order: the slide comes first and lifts the arms by $d_1$, then joints 2 and 3 turn, arms $b$ and $c$ long, and the gripper points
# down. Modified rows: $(0, 0, d_1, 0)$, $(0, 0, 0, \theta_2)$, $(0, b, 0, \theta_3)$, $(\pi, c, 0, 0)$. Write the pose of its gripper.


# %%
def lift(q, b, c):
    """Return the pose of frame 4 in frame 0, 4×4, for q = [d_1, theta_2, theta_3]."""
    ### BEGIN SOLUTION
    C, S = np.cos(q[1] + q[2]), np.sin(q[1] + q[2])
    x, y = b * np.cos(q[1]) + c * C, b * np.sin(q[1]) + c * S
    return [[C, S, 0, x], [S, -C, 0, y], [0, 0, -1, q[0]], [0, 0, 0, 1]]
    ### END SOLUTION


lesson.transfer.check(lift)

# %% [markdown]
# ## Once more
#
# A task of lesson 15 comes back. Do it without looking.

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
# - A pose holds an axis in its third column, an origin in its fourth: every vector of a Jacobian is read, none is guessed.
# - Two postures differ in the sign of one angle; all that is computed from it changes too.
# - The same four steps solve a SCARA of other letters and other signs.
#
# Sheets: `scara-000.md`, `scara-004.md`, `quintic-004.md`.
