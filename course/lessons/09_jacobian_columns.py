# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Jacobian columns, one by one"
# source: Modélisation et commande des robots de manipulation, chapter 3, Université de Constantine 1 (document 002)
# arm: planar_3r
# quantities:
#   "J_1": {jacobian: 3, columns: [1]}
#   "J_2": {jacobian: 3, columns: [2]}
#   "J_3": {jacobian: 3, columns: [3]}
#   "z_0": {axis: 0}
#   "z_1": {axis: 1}
#   "z_2": {axis: 2}
#   "P_{0,G}": {difference: [3, 0]}
#   "P_{1,G}": {difference: [3, 1]}
#   "P_{2,G}": {difference: [3, 2]}
# ---

# %% [markdown]
# # 9 · Jacobian columns, one by one
#
# Lessons 10 to 12 state the rule of a column and apply it. Here you derive it, and write axes, levers and columns singly, as document 002
# does.
#
# ## Two models, and their sizes
#
# The direct velocity model (*modèle cinématique direct*) gives the velocity of the tool for joint rates, the inverse one the rates for a
# velocity. What must be given to find the rates: `q`, `v`, `rates`, `acc`?

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch
from armproof.course.figures.registry import draw_kind, find_kind

lesson = open_lesson("jacobian_columns")
lesson

# %%
### BEGIN SOLUTION
given = ["q", "v"]
### END SOLUTION
lesson.models.check(given)

# %% [markdown]
# An arm has 7 joints: rows and columns of $J$, and of $\dot q$?

# %%
### BEGIN SOLUTION
sizes = [6, 7, 7, 1]
### END SOLUTION
lesson.size.check(sizes)

# %% [markdown]
# Each joint contributes its column times its rate. $J_{L1} = [-0.8, 0.3, 0]^T$ and $J_{L2} = [-0.3, 0.5, 0]^T$; the rates are $-2$ and $3$.

# %%
### BEGIN SOLUTION
velocity = [0.7, 0.9, 0]
### END SOLUTION
lesson.contribution.check(velocity)

# %% [markdown]
# ## The cross product
#
# Write it (*produit vectoriel*) by its definition.

# %%
### BEGIN SOLUTION
product = r"\begin{bmatrix} v_2 w_3 - v_3 w_2 \\ v_3 w_1 - v_1 w_3 \\ v_1 w_2 - v_2 w_1 \end{bmatrix}"
### END SOLUTION
lesson.cross.check(product)

# %% [markdown]
# And as a matrix times $w$: which $S(v)$?


# %%
def S(v_1, v_2, v_3):
    """Return the skew-symmetric matrix of v, 3×3."""
    ### BEGIN SOLUTION
    return np.array([[0, -v_3, v_2], [v_3, 0, -v_1], [-v_2, v_1, 0]])
    ### END SOLUTION


lesson.antisymmetric.check(S)

# %% [markdown]
# ## Two kinds of joints
#
# A body turns about z at 3 rad/s. Which velocity has its point $[0.3, 0.4, 0.65]^T$?

# %%
### BEGIN SOLUTION
of_point = [-1.2, 0.9, 0]
### END SOLUTION
lesson.turning.check(of_point)

# %% [markdown]
# So a revolute joint (*rotoïde*) gives $z_{i-1} \times P_{i-1,G}$ above $z_{i-1}$: the velocity of the gripper's point, and the turn itself. A
# prismatic joint pushes all points alike: $z_{i-1}$ above zeros. Write the column of the slide of the polar arm.

# %%
### BEGIN SOLUTION
pushed = r"\begin{bmatrix} \cos\theta \\ \sin\theta \\ 0 \\ 0 \\ 0 \\ 0 \end{bmatrix}"
### END SOLUTION
lesson.slide.check(pushed)

# %% [markdown]
# Both kinds in one arm, each joint moving alone: $\theta$ turns the tool about $z$, at a right angle to the lever $p$; $r$ pushes it along its own axis.

# %%
draw_kind(find_kind("columns"), load_arm("polar_rp"))

# %% [markdown]
# ## Axes
#
# $z_{i-1}$ is the third column of the pose of frame $i-1$. Take $z_1$ from
# $T_0^1 = \begin{bmatrix} C_1 & 0 & S_1 & 0 \\ S_1 & 0 & -C_1 & 0 \\ 0 & 1 & 0 & l_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}$.

# %%
### BEGIN SOLUTION
z_1 = r"\begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix}"
### END SOLUTION
lesson.axes.check(z_1)

# %% [markdown]
# And $z_2$ of the planar 3R arm, at $\theta_1 = 40°$, $\theta_2 = 72°$?

# %%
sketch(load_arm("planar_3r"), table=False)

# %%
### BEGIN SOLUTION
z_2 = [0, 0, 1]
### END SOLUTION
lesson.planar_axes.check(z_2)

# %% [markdown]
# ## Planar 3R: levers
#
# All origins are fourth columns. Write $A_1 A_2 A_3$ first.

# %%
### BEGIN SOLUTION
T = r"""\begin{bmatrix} C_{123} & -S_{123} & 0 & l_1 C_1 + l_2 C_{12} + l_3 C_{123} \\
S_{123} & C_{123} & 0 & l_1 S_1 + l_2 S_{12} + l_3 S_{123} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.pose.check(T)

# %% [markdown]
# Then the levers (*bras de levier*) $P_{0,G} = P_G - P_0$ and $P_{2,G} = P_G - P_2$; the one between is in lesson 10.

# %%
### BEGIN SOLUTION
P_0G = r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} + l_3 C_{123} \\ l_1 S_1 + l_2 S_{12} + l_3 S_{123} \\ 0 \end{bmatrix}"
### END SOLUTION
lesson.first_lever.check(P_0G)

# %%
### BEGIN SOLUTION
P_2G = r"\begin{bmatrix} l_3 C_{123} \\ l_3 S_{123} \\ 0 \end{bmatrix}"
### END SOLUTION
lesson.third_lever.check(P_2G)

# %% [markdown]
# ## Planar 3R: columns
#
# Axis times lever, for joint 1: three rows.


# %%
def first_column(q, l_1, l_2, l_3):
    """Return z_0 × P_{0,G}, three numbers."""
    ### BEGIN SOLUTION
    t1, t12, t123 = q[0], q[0] + q[1], q[0] + q[1] + q[2]
    x = l_1 * np.cos(t1) + l_2 * np.cos(t12) + l_3 * np.cos(t123)
    y = l_1 * np.sin(t1) + l_2 * np.sin(t12) + l_3 * np.sin(t123)
    return np.cross([0, 0, 1], [x, y, 0])
    ### END SOLUTION


lesson.first_column.check(first_column)

# %% [markdown]
# And the whole third column, six rows.

# %%
### BEGIN SOLUTION
J_3 = r"\begin{bmatrix} -l_3 S_{123} \\ l_3 C_{123} \\ 0 \\ 0 \\ 0 \\ 1 \end{bmatrix}"
### END SOLUTION
lesson.third_column.check(J_3)

# %% [markdown]
# In one line each:
#
# $$ J_1 = \begin{bmatrix} z_0 \times P_{0,G} \\ z_0 \end{bmatrix}, \quad J_2 = \begin{bmatrix} z_1 \times P_{1,G} \\ z_1 \end{bmatrix}, \quad J_3 = \begin{bmatrix} z_2 \times P_{2,G} \\ z_2 \end{bmatrix} $$
#
# ## Alone: the planar 2R arm
#
# Document 002's question 1: the Jacobian of the planar 2R arm, 2×2.


# %%
def jacobian(q, l_1, l_2):
    """Return the linear Jacobian of the planar 2R arm, 2×2."""
    ### BEGIN SOLUTION
    t1, t12 = q[0], q[0] + q[1]
    return np.array([
        [-l_1 * np.sin(t1) - l_2 * np.sin(t12), -l_2 * np.sin(t12)],
        [l_1 * np.cos(t1) + l_2 * np.cos(t12), l_2 * np.cos(t12)],
    ])  # fmt: skip
    ### END SOLUTION


lesson.planar_2r.check(jacobian)

# %%
lesson.planar_2r.show(jacobian, theta_1=0.5, theta_2=0.8)

# %% [markdown]
# The two columns span an ellipse: the velocities of the tool when $\dot\theta_1^2 + \dot\theta_2^2 = 1$. Move the arm. At which $\theta_2$ are the columns parallel?

# %%
lesson.planar_2r.move(jacobian)

# %% [markdown]
# ## Alone: the polar arm
#
# The tool stands at $[r\cos\theta, r\sin\theta]^T$. Write its velocity for $\dot r = u$ and $\dot\theta = w$.

# %%
### BEGIN SOLUTION
polar_velocity = r"\begin{bmatrix} u \cos\theta - r w \sin\theta \\ u \sin\theta + r w \cos\theta \end{bmatrix}"
### END SOLUTION
lesson.polar_velocity.check(polar_velocity)

# %% [markdown]
# Read $J_L$ off it, columns $r$, $\theta$.

# %%
### BEGIN SOLUTION
J_L = r"\begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \end{bmatrix}"
### END SOLUTION
lesson.polar_linear.check(J_L)

# %% [markdown]
# Move this arm too. Its $\det J$ is one of its two joint variables: which?

# %%
lesson.polar_linear.move(J_L)

# %% [markdown]
# Then add the row of $\omega$.

# %%
### BEGIN SOLUTION
J = r"\begin{bmatrix} \cos\theta & -r\sin\theta \\ \sin\theta & r\cos\theta \\ 0 & 1 \end{bmatrix}"
### END SOLUTION
lesson.polar_whole.check(J)

# %% [markdown]
# ## An arm that you have not seen
#
# A column turns by $\theta_1$. On it, at the height $h$, a boom of length $b$ is raised by $\theta_2$ about the axis $[S_1, -C_1, 0]^T$; the boom's end is
# at $[b C_1 C_2, b S_1 C_2, h + b S_2]^T$. Write the whole column of joint 2.


# %%
def boom(q, b):
    """Return the column of joint 2 for the boom's end, six numbers [v; omega]."""
    ### BEGIN SOLUTION
    (c1, c2), (s1, s2) = np.cos(q), np.sin(q)
    return [-b * c1 * s2, -b * s1 * s2, b * c2, s1, -c1, 0]
    ### END SOLUTION


lesson.transfer.check(boom)

# %% [markdown]
# ## Once more
#
# A task of lesson 6 comes back. Do it without looking.

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
# - A column is what the tool does when one joint moves at rate one: velocity above, turn below.
# - Axis: third column. Origin: fourth column. Lever: tool less origin. Column: axis times lever.
# - Derivatives of the position give the same linear half, without any cross product.
#
# Lesson 10 puts the columns side by side. Sheets: `planar-3r-002.md`, `jacobian-revolute-002.md`, `scara-000-cross-product.md`.
