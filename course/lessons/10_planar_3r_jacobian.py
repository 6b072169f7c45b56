# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Planar 3R: the Jacobian by cross products and by derivatives"
# source: Modélisation et commande des robots de manipulation, chapter 3, Université de Constantine 1 (document 002)
# arm: planar_3r
# transforms: upper
# quantities:
#   "J": {jacobian: 3}
#   "J_L": {jacobian: 3, rows: [1, 2, 3]}
#   "J_r": {jacobian: 3, rows: [1, 2, 6]}
#   "J_{xy}": {jacobian: 3, rows: [1, 2]}
#   "P": {origin: 3}
#   "P_x": {origin: 3, component: x}
#   "P_y": {origin: 3, component: y}
#   "P_{0,G}": {difference: [3, 0]}
#   "P_{1,G}": {difference: [3, 1]}
#   "P_{2,G}": {difference: [3, 2]}
# ---

# %% [markdown]
# # 10 · Planar 3R: the Jacobian by cross products and by derivatives
#
# After *Modélisation et commande des robots de manipulation*, chapter 3, section 3.2 (Université de Constantine 1).
# In this lesson you
#
# 1. build the 6×3 Jacobian (*matrice jacobienne*) of a planar arm by cross products,
# 2. find its linear half a second time by derivatives, and use one way to test the other,
# 3. say when a Jacobian that is not square loses rank.
#
# The Jacobian is the forward differential kinematics (*modèle cinématique direct*, MCD): it takes joint rates to
# velocities.

# %%
from armproof import open_lesson

lesson = open_lesson("planar_3r_jacobian")
lesson

# %% [markdown]
# ## The arm
#
# Three revolute joints with parallel axes; the gripper $G$ sits at the origin of frame 3. Every $z$ points at you.

# %%
from armproof import load_arm
from armproof.course.figures.registry import draw_kind, find_kind

draw_kind(find_kind("sketch"), load_arm("planar_3r"))

# %% [markdown]
# Where the gripper is, with $C_{12}$ for $\cos(\theta_1 + \theta_2)$ and so on:
#
# $$ P = \begin{bmatrix} l_1 C_1 + l_2 C_{12} + l_3 C_{123} \\ l_1 S_1 + l_2 S_{12} + l_3 S_{123} \\
# 0 \end{bmatrix} $$
#
# ## Predict
#
# Look at the figure. Which of $v_x, v_y, v_z, \omega_x, \omega_y, \omega_z$ are zero, whatever the joints do? Write
# the list of their keys, such as `["vx", "wy"]`.

# %%
### BEGIN SOLUTION
zero_rows = ["vz", "wx", "wy"]
### END SOLUTION
lesson.prediction.check(zero_rows)

# %% [markdown]
# ## By cross products
#
# A revolute joint that turns at the rate $\dot\theta_i$ gives the gripper the velocity
# $\dot\theta_i \, z_{i-1} \times P_{i-1,G}$, where $P_{i-1,G}$ runs from the joint to the gripper. So
#
# $$ J = \begin{bmatrix} z_0 \times P_{0,G} & z_1 \times P_{1,G} & z_2 \times P_{2,G} \\
# z_0 & z_1 & z_2 \end{bmatrix} $$
#
# Here is what each joint does alone: its lever, called $p$, and the velocity across it. The shorter the lever, the slower the gripper.

# %%
draw_kind(find_kind("columns"), load_arm("planar_3r"))

# %% [markdown]
# Write the vector $P_{1,G}$ from joint 2 to the gripper, in frame 0.

# %%
import numpy as np


def lever(q, l_2, l_3):
    """Return P_{1,G}, 3 numbers."""
    ### BEGIN SOLUTION
    elbow, wrist = q[0] + q[1], q[0] + q[1] + q[2]
    return np.array([l_2 * np.cos(elbow) + l_3 * np.cos(wrist), l_2 * np.sin(elbow) + l_3 * np.sin(wrist), 0])
    ### END SOLUTION


lesson.lever.check(lever)

# %% [markdown]
# Now the cross product with $z_1 = [0, 0, 1]^T$, by hand. Write the second linear column $J_{L2}$; this time a LaTeX
# string: `r"\begin{bmatrix} … \\ … \\ … \end{bmatrix}"`.

# %%
### BEGIN SOLUTION
column = r"\begin{bmatrix} -l_2 S_{12} - l_3 S_{123} \\ l_2 C_{12} + l_3 C_{123} \\ 0 \end{bmatrix}"
### END SOLUTION
lesson.column.check(column)

# %% [markdown]
# The other two columns go the same way. Write all of $J$: 6×3, rows $[v;\ \omega]$, in frame 0.


# %%
def jacobian(q, l_1, l_2, l_3):
    """Return J, 6×3."""
    ### BEGIN SOLUTION
    angles = np.array([q[0], q[0] + q[1], q[0] + q[1] + q[2]])
    links = [length * np.array([np.cos(a), np.sin(a), 0]) for a, length in zip(angles, (l_1, l_2, l_3))]
    z = np.array([0, 0, 1])
    vectors = [links[0] + links[1] + links[2], links[1] + links[2], links[2]]
    return np.column_stack([np.concatenate([np.cross(z, vector), z]) for vector in vectors])
    ### END SOLUTION


lesson.jacobian.check(jacobian)

# %% [markdown]
# One column of yours as a velocity of the gripper, over that of the arm in Drake: the first that is wrong, else column 1.

# %%
lesson.jacobian.show(jacobian, theta_1=0.4, theta_2=0.9, theta_3=-0.7)

# %% [markdown]
# ## By derivatives
#
# The linear velocity is the derivative of the position, so column $i$ of $J_L$ is a derivative as well, with no cross
# product at all:
#
# $$ J_L = \begin{bmatrix} \frac{\partial P}{\partial \theta_1} & \frac{\partial P}{\partial \theta_2} &
# \frac{\partial P}{\partial \theta_3} \end{bmatrix} $$
#
# Write one entry by hand, $\partial P_y / \partial \theta_1$.

# %%
### BEGIN SOLUTION
derivative = r"l_1 C_1 + l_2 C_{12} + l_3 C_{123}"
### END SOLUTION
lesson.derivative.check(derivative)

# %% [markdown]
# The source drops a length here. A look at the units is enough to see it: m + 1 + m.
#
# > **Erratum** (slide of the partial derivatives, fourth line, as printed)
# >
# > $$ \frac{\partial P_y}{\partial \theta_1} = l_1 C_1 + C_{12} + l_3 C_{123} $$
#
# Write all of $J_L$, 3×3, by derivatives. If you have SymPy, `P.jacobian([...])` does it in a line; name its symbols
# `theta_1`, `l_1` and so on.

# %%
### BEGIN SOLUTION
linear = r"""\begin{bmatrix}
-l_1 S_1 - l_2 S_{12} - l_3 S_{123} & -l_2 S_{12} - l_3 S_{123} & -l_3 S_{123} \\
l_1 C_1 + l_2 C_{12} + l_3 C_{123} & l_2 C_{12} + l_3 C_{123} & l_3 C_{123} \\
0 & 0 & 0
\end{bmatrix}"""
### END SOLUTION
lesson.linear.check(linear)

# %% [markdown]
# Two ways to one matrix are a test of each other, and the source does not pass it. One sign slips on three slides,
# the last time right under derivatives that have it right, and the slide says that both ways agree:
#
# > **Erratum** (slides "Le Jacobien obtenu" and "La matrice Jacobéenne devient", as printed)
# >
# > $$ J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} - l_3 S_{123} & l_2 S_{12} - l_3 S_{123} & -l_3 S_{123} \\ l_1 C_1 + l_2 C_{12} + l_3 C_{123} & l_2 C_{12} + l_3 C_{123} & l_3 C_{123} \\ 0 & 0 & 0 \\ 0 & 0 & 0 \\ 0 & 0 & 0 \\ 1 & 1 & 1 \end{bmatrix} $$
#
# ## When does it lose rank?
#
# A 6×3 matrix has no determinant. Its three rows that are not zero, of $v_x$, $v_y$ and $\omega_z$, form a square matrix
# $J_r$, which has one. Write $\det J_r$, as short as you can.

# %%
### BEGIN SOLUTION
determinant = r"l_1 l_2 \sin\theta_2"
### END SOLUTION
lesson.determinant.check(determinant)

# %% [markdown]
# For any $J$ with more rows than columns there is another way to say it, which needs no choice of rows:
#
# $$ \det(J^T J) = 0 \iff \sin\theta_2 = 0 $$
#
# In each family, the second elbow cannot move along the first two links:

# %%
draw_kind(find_kind("singular"), load_arm("planar_3r"))

# %% [markdown]
# ## The limits
#
# A configuration is singular for a task. Position *and* angle of the gripper ask for $J$; the position alone asks for
# its first two rows, $J_{xy}$, and then one joint is spare:
#
# $$ \det(J_{xy} J_{xy}^T) = 0 \iff \sin\theta_2 = 0 \text{ and } \sin\theta_3 = 0 $$
#
# Let the first two links be in line and the third across them: $\theta_2 = 0$, $\theta_3 = \pi/2$. Give two numbers,
# the rank of $J$ and the rank of $J_{xy}$.

# %%
### BEGIN SOLUTION
ranks = [2, 2]
### END SOLUTION
lesson.rank.check(ranks)

# %% [markdown]
# ## An arm that you have not seen
#
# A column turns by $\theta_1$, a carriage rises by $d_2$, a ram goes out by $d_3$; its end is at $[-d_3 S_1, d_3 C_1, d_2]^T$. Write the Jacobian.


# %%
def cylinder(q):
    """Return the Jacobian of the ram's end, 6×3."""
    ### BEGIN SOLUTION
    c, s = np.cos(q[0]), np.sin(q[0])
    return [[-q[2] * c, 0, -s], [-q[2] * s, 0, c], [0, 1, 0], [0, 0, 0], [0, 0, 0], [1, 0, 0]]
    ### END SOLUTION


lesson.transfer.check(cylinder)

# %% [markdown]
# ## Once more
#
# A task of lesson 7 comes back. Do it without looking.

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
# - A column of a Jacobian is what one joint does to the tool: the cross product above, the axis below.
# - Derivatives of the position give the same upper half: two ways, one test.
# - Three joints in a plane have a square part; where it is singular, the arm is stretched or folded.
#
# ## Further
#
# - Lesson 11 does the same in space, where the axes are no longer parallel.
# - Lesson 13: this $J$ has no inverse. Which of the two pseudo-inverses exists?
# - `armproof singularities planar_3r --rows 1,2` states the families of the position alone.
