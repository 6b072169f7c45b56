# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "SCARA: geometric Jacobian and singular configurations"
# source: F. Morbidi, Robotique industrielle, TD 3, exercises 2 and 3, April 2019 (document 000)
# arm: scara
# transforms: upper
# quantities:
#   "J(q)": {jacobian: 4}
#   "J'_P(q)": {jacobian: 4, rows: [1, 2, 3], columns: [1, 2, 3]}
#   "J_O(q)": {jacobian: 4, rows: [4, 5, 6]}
#   "p_{4,x}": {origin: 4, component: x}
#   "p_{4,y}": {origin: 4, component: y}
# ---

# %% [markdown]
# # 12 · SCARA: geometric Jacobian and singular configurations
#
# After F. Morbidi, *Robotique industrielle*, TD 3, exercises 2 and 3 (2019). In this lesson you
#
# 1. build the 6×4 geometric Jacobian (*jacobien géométrique*) column by column,
# 2. reduce it to a square block and read the singular configurations from its determinant,
# 3. say what is lost there, and where in the workspace it happens.
#
# An answer may be a Python function, a SymPy expression or a LaTeX string. `lesson.rotation.hint()` gives a hint, one
# more at each call.

# %%
from armproof import open_lesson

lesson = open_lesson("scara_jacobian")
lesson

# %% [markdown]
# ## The arm
#
# The SCARA has four degrees of freedom (*degrés de liberté*, DDL): two parallel revolute joints, a slide and a
# revolute joint that turns the tool, so $q = [\theta_1, \theta_2, d_3, \theta_4]^T$. The frames follow the classic
# convention: joint $i$ moves about or along $z_{i-1}$. Note where $z_2$ points.

# %%
from armproof import NumericKinematics, load_arm
from armproof.course.figures.registry import draw_kind, find_kind

draw_kind(find_kind("sketch"), load_arm("scara"))

# %% [markdown]
# The source recalls four link transforms (*matrices de passage*); these two are the ones you need now. The upper
# index names the reference frame.
#
# $$
# A^0_1 = \begin{bmatrix} \cos\theta_1 & -\sin\theta_1 & 0 & a_1\cos\theta_1 \\
# \sin\theta_1 & \cos\theta_1 & 0 & a_1\sin\theta_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}
# $$
#
# $$
# A^1_2 = \begin{bmatrix} \cos\theta_2 & \sin\theta_2 & 0 & a_2\cos\theta_2 \\
# \sin\theta_2 & -\cos\theta_2 & 0 & a_2\sin\theta_2 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}
# $$
#
# ## Predict
#
# Before any formula: stretch the arm along $x_0$ and turn joint 1 alone at 1.2 rad/s. Take $a_1 = 0.325$ m and
# $a_2 = 0.275$ m. Write the velocity of the tool point, $[v_x, v_y, v_z]$ in m/s.

# %%
### BEGIN SOLUTION
velocity = [0, 1.2 * (0.325 + 0.275), 0]
### END SOLUTION
lesson.prediction.check(velocity)

# %% [markdown]
# ## One column a joint
#
# A revolute joint (*rotoïde*) contributes the column $[z_{i-1} \times (p_4 - p_{i-1});\ z_{i-1}]$, a prismatic one
# (*prismatique*) $[z_{i-1};\ 0]$. Side by side:
#
# $$
# J(q) = \begin{bmatrix} z_0 \times (p_4 - p_0) & z_1 \times (p_4 - p_1) & z_2 & z_3 \times (p_4 - p_3) \\ z_0 &
# z_1 & 0_{3\times 1} & z_3 \end{bmatrix}
# $$
#
# The axis $z_{i-1}$ is the third column of $R^0_{i-1}$, and $p_{i-1}$ is in the fourth column of $T^0_{i-1}$. So two
# ingredients are needed, axes and vectors.
#
# Write $R^0_2 = R^0_1 R^1_2$, whose third column is $z_2$. A function of $q$ or a LaTeX matrix will do.

# %%
import numpy as np


def rotation(q):
    """Return R^0_2, 3×3."""
    ### BEGIN SOLUTION
    angle = q[0] + q[1]
    return np.array([[np.cos(angle), np.sin(angle), 0], [np.sin(angle), -np.cos(angle), 0], [0, 0, -1]])
    ### END SOLUTION


lesson.rotation.check(rotation)

# %% [markdown]
# The determinant of a rotation is 1. Try that test on what the source prints:
#
# > **Erratum** (exercise 1, matrix $R^0_2$, as printed)
# >
# > $$ R^0_2 = \begin{bmatrix} \cos(\theta_1+\theta_2) & -\sin(\theta_1+\theta_2) & 0 \\ \sin(\theta_1+\theta_2) & \cos(\theta_1+\theta_2) & 0 \\ 0 & 0 & -1 \end{bmatrix} $$
#
# The third column is right, so that the slip does no harm further on.
#
# Now the vectors. Write the one from joint 2 to the tool, $p_4 - p_1$, in frame 0. Lengths that your function needs
# are arguments of their names.


# %%
def lever(q, a_2, d_4):
    """Return p_4 − p_1, 3 numbers."""
    ### BEGIN SOLUTION
    angle = q[0] + q[1]
    return np.array([a_2 * np.cos(angle), a_2 * np.sin(angle), -q[2] - d_4])
    ### END SOLUTION


lesson.lever.check(lever)

# %% [markdown]
# ## The Jacobian
#
# Put the four columns together: rows $[v;\ \omega]$, in frame 0. `np.cross` may do the products for you. Which rows
# do you expect to be zero?


# %%
def jacobian(q, a_1, a_2, d_4):
    """Return J, 6×4."""
    ### BEGIN SOLUTION
    t1, t12 = q[0], q[0] + q[1]
    up, down = np.array([0, 0, 1]), np.array([0, 0, -1])
    p_1 = np.array([a_1 * np.cos(t1), a_1 * np.sin(t1), 0])
    p_4 = p_1 + np.array([a_2 * np.cos(t12), a_2 * np.sin(t12), -q[2] - d_4])
    columns = [[*np.cross(up, p_4), *up], [*np.cross(up, p_4 - p_1), *up], [*down, 0, 0, 0], [0, 0, 0, *down]]
    return np.array(columns).T
    ### END SOLUTION


lesson.jacobian.check(jacobian)

# %% [markdown]
# One column of yours as a velocity at the tool, over that of the arm in Drake: the first that is wrong, else column 1.

# %%
lesson.jacobian.show(jacobian, theta_1=0.6, theta_2=0.9, d_3=0.1)

# %% [markdown]
# All columns at once: the ellipse of your $J$, dashed, and that of the arm. Which of the four sliders change $\det J$? Keep the answer for the next tasks.

# %%
lesson.jacobian.move(jacobian)

# %% [markdown]
# ## Reduce and take the determinant
#
# The rows of $\omega_x$ and $\omega_y$ are zero: a SCARA never tilts its tool.
#
# $$ J_O(q) \begin{bmatrix} \dot\theta_1 \\ \dot\theta_2 \\ \dot d_3 \\ \dot\theta_4 \end{bmatrix} =
# \begin{bmatrix} 0 \\ 0 \\ \dot\theta_1 + \dot\theta_2 - \dot\theta_4 \end{bmatrix} $$
#
# Joint 4 gives $\omega_z$ and nothing else, so the source studies the block $J'_P$ of the first three rows and
# columns. Its determinant decides whether the arm is singular (*configuration singulière*). Give it, as short as you
# can.

# %%
### BEGIN SOLUTION
determinant = r"-a_1 a_2 \sin\theta_2"
### END SOLUTION
lesson.determinant.check(determinant)

# %% [markdown]
# The links' directions do not matter one by one, only the angle between them:
#
# $$ \det(J'_P(q)) = 0 \iff \theta_2 = 0 \text{ or } \theta_2 = \pi $$
#
# The full matrix is 6×4. What is its rank when the arm is folded, $\theta_2 = \pi$?

# %%
### BEGIN SOLUTION
rank = 3
### END SOLUTION
lesson.rank.check(rank)

# %% [markdown]
# ## What is lost, and what moves in vain
#
# Stretched or folded, the tool cannot move along the links. A force along them does no work, whatever the joints do:
#
# $$ \left. \begin{bmatrix} C_1 & S_1 & 0 & 0 & 0 & 0 \end{bmatrix} J(q) \right|_{\theta_2 = 0} = \begin{bmatrix} 0 &
# 0 & 0 & 0 \end{bmatrix} $$
#
# What the tool loses, the joints gain: there are joint rates with which it neither moves nor turns. Write them for the
# stretched arm, with $\dot\theta_1 = a_2$.


# %%
def null_motion(a_1, a_2):
    """Return the four joint rates."""
    ### BEGIN SOLUTION
    return [a_2, -(a_1 + a_2), 0, -a_1]
    ### END SOLUTION


lesson.null_motion.check(null_motion)

# %% [markdown]
# The arm in both families, beside a generic pose. The ellipse is what the tool's velocity can be with joint rates of
# norm 1; where it is flat, a direction is lost.

# %%
draw_kind(find_kind("singular"), load_arm("scara"))

# %% [markdown]
# The ellipse does not become flat at once. The smallest singular value of the upper left 2×2 block, from Drake's own
# Jacobian, on the way to the stretched arm (in m, the speed per unit of joint rates in the worst direction):

# %%
arm = load_arm("scara")
for theta_2 in (1.5, 0.5, 0.1, 0.01, 0):
    J = NumericKinematics(arm, np.array([[0, theta_2, 0, 0]])).jacobian("4")[0]
    print(f"theta_2 = {theta_2:4.2f}:  {np.linalg.svd(J[:2, :2])[1].min():.5f}")

# %% [markdown]
# ## The limits
#
# The source says that both families lie at the limits of the workspace ("type 1"). The distance of the tool from the
# first axis decides:
#
# $$ p_{4,x}^2 + p_{4,y}^2 = a_1^2 + a_2^2 + 2a_1a_2\cos\theta_2 $$
#
# Take equal links, $a_1 = a_2$, and fold the arm. Where is the tool: on the `"outer"` limit, on the `"inner"` one,
# `"inside"` (and singular), or `"regular"` (inside, not singular)?

# %%
### BEGIN SOLUTION
place = "inside"
### END SOLUTION
lesson.equal_links.check(place)

# %% [markdown]
# ## An arm that you have not seen
#
# The end of a column with a rising carriage and a ram is at $[-d_3 S_1, d_3 C_1, d_2]^T$. Which rank has $J_v$ at $d_3 = 0.4$, and which at
# $d_3 = 0$?

# %%
### BEGIN SOLUTION
ranks = [3, 2]
### END SOLUTION
lesson.transfer.check(ranks)

# %% [markdown]
# ## Once more
#
# A task of lesson 9 comes back. Do it without looking.

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
# - A slide adds its axis to the velocity and nothing to the rotation.
# - The determinant of the whole says where directions are lost; the rank says how many.
# - A null motion moves the joints and leaves the tool.
#
# ## Further
#
# - `armproof singularities scara` states both families with rank, lost direction and null motion.
# - Lesson 13: how large the joint rates become near $\theta_2 = 0$, and what damping does.
# - Lesson 14: the two postures of the SCARA meet exactly in its singular configurations. Why?
