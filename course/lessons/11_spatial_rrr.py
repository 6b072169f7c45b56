# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Spatial RRR: an exercise left open"
# source: Modélisation et commande des robots de manipulation, chapter 3, Université de Constantine 1 (document 002)
# arm: spatial_rrr
# transforms: lower
# quantities:
#   "P": {origin: P}
#   "P_x": {origin: P, component: x}
#   "P_y": {origin: P, component: y}
#   "P_z": {origin: P, component: z}
#   "J": {jacobian: P}
#   "J_L": {jacobian: P, rows: [1, 2, 3]}
#   "J_{L3}": {jacobian: 3, rows: [1, 2, 3]}
# ---

# %% [markdown]
# # 11 · Spatial RRR: an exercise left open
#
# After the exercise of section 3.2 in *Modélisation et commande des robots de manipulation* (Université de
# Constantine 1). It has no printed solution. In this lesson you
#
# 1. read off link transforms which point they lead to, and see that the exercise leaves its tool point open,
# 2. work out position (*modèle géométrique direct*, MGD) and Jacobian of an arm whose axes are not all parallel,
# 3. find its singular configurations from the factors of one determinant.
#
# An answer may be a Python function, a SymPy expression or LaTeX. `lesson.prediction` shows the task in full,
# `lesson.prediction.hint()` gives a hint, one more at each call.

# %%
from armproof import open_lesson

lesson = open_lesson("spatial_rrr")
lesson

# %% [markdown]
# ## The exercise
#
# The source gives three transforms. Here the *lower* index names the reference: $T_0^1$ is the pose of frame 1 in
# frame 0.
#
# $$ T_0^1 = \begin{bmatrix} C_1 & 0 & S_1 & 0 \\ S_1 & 0 & -C_1 & 0 \\ 0 & 1 & 0 & l_1 \\
# 0 & 0 & 0 & 1 \end{bmatrix} $$
#
# $$ T_1^2 = \begin{bmatrix} C_2 & -S_2 & 0 & l_2 C_2 \\ S_2 & C_2 & 0 & l_2 S_2 \\ 0 & 0 & 1 & 0 \\
# 0 & 0 & 0 & 1 \end{bmatrix} $$
#
# $$ T_2^3 = \begin{bmatrix} C_3 & 0 & S_3 & 0 \\ S_3 & 0 & -C_3 & 0 \\ 0 & 1 & 0 & 0 \\
# 0 & 0 & 0 & 1 \end{bmatrix} $$
#
# It asks for the position of "the point $P$" in $R_0$ as a function of $\theta_1$, $\theta_2$ *and* $\theta_3$, and
# for the Jacobian. The figure that shows $P$ is missing in our copy. Ours has frame 3 in the elbow and a point $P$
# beyond it; which of the two is meant is the question.

# %%
from armproof import load_arm
from armproof.course.figures.kinds.sketch import sketch

sketch(load_arm("spatial_rrr"), table=False)

# %% [markdown]
# ## Predict
#
# Look at $T_2^3$ alone. Joint 3 turns, the others rest. What does the origin of frame 3 do: does it `"rest"`, run on a
# `"circle"` about axis 3, on one about axis 2 (`"shoulder"`), or along a `"line"`?

# %%
### BEGIN SOLUTION
motion = "rest"
### END SOLUTION
lesson.prediction.check(motion)

# %% [markdown]
# ## The first reading: $P$ is the origin of frame 3
#
# Write $p_3$ in frame 0, from the last column of $T_0^1 T_1^2 T_2^3$.

# %%
import numpy as np


def elbow(q, l_1, l_2):
    """Return p_3, 3 numbers."""
    ### BEGIN SOLUTION
    c1, s1, c2, s2 = np.cos(q[0]), np.sin(q[0]), np.cos(q[1]), np.sin(q[1])
    T_01 = np.array([[c1, 0, s1, 0], [s1, 0, -c1, 0], [0, 1, 0, l_1], [0, 0, 0, 1]])
    return (T_01 @ np.array([l_2 * c2, l_2 * s2, 0, 1]))[:3]
    ### END SOLUTION


lesson.elbow.check(elbow)

# %% [markdown]
# Write its linear Jacobian, the derivatives with respect to $\theta_1$, $\theta_2$, $\theta_3$, 3×3. A LaTeX string
# is the shortest.

# %%
### BEGIN SOLUTION
elbow_linear = r"""\begin{bmatrix}
-l_2 S_1 C_2 & -l_2 C_1 S_2 & 0 \\
l_2 C_1 C_2 & -l_2 S_1 S_2 & 0 \\
0 & l_2 C_2 & 0
\end{bmatrix}"""
### END SOLUTION
lesson.elbow_linear.check(elbow_linear)

# %% [markdown]
# With this reading joint 3 would be of no use for the position, and every configuration singular:
#
# $$ \det(J_{L3}) = 0 $$
#
# The exercise speaks of $\theta_3$, so that this cannot be what its author meant.
#
# ## The second reading: $P$ lies beyond the elbow
#
# A forearm is missing; its length $l_3$ is not among the data. The printed $T_2^3$ turns frame 3 by 90° about its first
# axis, as is usual for a forearm along the third one. Write $z_3$ in frame 0.


# %%
def axis(q):
    """Return z_3, 3 numbers."""
    ### BEGIN SOLUTION
    return [np.cos(q[0]) * np.sin(q[1] + q[2]), np.sin(q[0]) * np.sin(q[1] + q[2]), -np.cos(q[1] + q[2])]
    ### END SOLUTION


lesson.axis.check(axis)

# %% [markdown]
# Now the point:
#
# $$ P = p_3 + l_3 z_3 $$


# %%
def point(q, l_1, l_2, l_3):
    """Return P, 3 numbers."""
    ### BEGIN SOLUTION
    reach = l_2 * np.cos(q[1]) + l_3 * np.sin(q[1] + q[2])
    height = l_1 + l_2 * np.sin(q[1]) - l_3 * np.cos(q[1] + q[2])
    return np.array([np.cos(q[0]) * reach, np.sin(q[0]) * reach, height])
    ### END SOLUTION


lesson.point.check(point)

# %% [markdown]
# Your point, dashed, over the one of the arm in Drake:

# %%
lesson.point.show(point, theta_1=0.5, theta_2=0.6, theta_3=0.7)

# %% [markdown]
# Move it yourself; with `in_3d=True` Drake's viewer shows it too. Find two quite different ways to make the ellipse flat. Where does
# $\det J$ go then?

# %%
lesson.point.move(point)

# %% [markdown]
# ## The Jacobian
#
# Column $i$ is $[z_{i-1} \times (P - p_{i-1});\ z_{i-1}]$, as on the planar arm, but the axes are no longer parallel.
# Frame 1 turns with joint 1, and so do
#
# $$ z_1 = z_2 = \begin{bmatrix} S_1 \\ -C_1 \\ 0 \end{bmatrix} $$
#
# Write $J$ of $P$: 6×3, rows $[v;\ \omega]$, in frame 0.


# %%
def jacobian(q, l_1, l_2, l_3):
    """Return J, 6×3."""
    ### BEGIN SOLUTION
    c1, s1, c2, s2 = np.cos(q[0]), np.sin(q[0]), np.cos(q[1]), np.sin(q[1])
    c23, s23 = np.cos(q[1] + q[2]), np.sin(q[1] + q[2])
    z_0, z_1 = np.array([0, 0, 1]), np.array([s1, -c1, 0])
    p_1 = np.array([0, 0, l_1])
    p_2 = p_1 + l_2 * np.array([c1 * c2, s1 * c2, s2])
    P = p_2 + l_3 * np.array([c1 * s23, s1 * s23, -c23])
    columns = [[*np.cross(z_0, P), *z_0], [*np.cross(z_1, P - p_1), *z_1], [*np.cross(z_1, P - p_2), *z_1]]
    return np.array(columns).T
    ### END SOLUTION


lesson.jacobian.check(jacobian)

# %% [markdown]
# ## Where it is singular
#
# Three joints and three coordinates: the linear half $J_L$ is square. Give its determinant, factored. It does not
# depend on $\theta_1$, so put $\theta_1 = 0$ before you expand.

# %%
### BEGIN SOLUTION
determinant = r"l_2 l_3 C_3 (l_2 C_2 + l_3 S_{23})"
### END SOLUTION
lesson.determinant.check(determinant)

# %% [markdown]
# Each factor is a family of its own. The first says that forearm and upper arm are in line. The second is a distance:
#
# $$ P_x^2 + P_y^2 = \left( l_2 C_2 + l_3 S_{23} \right)^2 $$
#
# In both families a velocity is lost, along the arm in one and across its plane in the other:

# %%
from armproof.course.figures.registry import draw_kind, find_kind

draw_kind(find_kind("singular"), load_arm("spatial_rrr"))

# %% [markdown]
# ## The limits
#
# How far $P$ is from the shoulder depends on $\theta_3$ alone, and is largest and smallest with the elbow in line:
#
# $$ P_x^2 + P_y^2 + (P_z - l_1)^2 = l_2^2 + l_3^2 + 2 l_2 l_3 S_3 $$
#
# The two families meet. Give two ranks of $J_L$: stretched, $\theta_3 = \pi/2$, at a generic $\theta_2$; and
# stretched straight up, $\theta_2 = \theta_3 = \pi/2$.

# %%
### BEGIN SOLUTION
ranks = [2, 1]
### END SOLUTION
lesson.limits.check(ranks)

# %% [markdown]
# ## An arm that you have not seen
#
# A turret turns by $\theta_1$, rises by $\theta_2$, and a ram goes out by $d_3$; its end is at $[d_3 C_1 C_2,\ d_3 S_1 C_2,\ h + d_3 S_2]^T$. Give the
# determinant of its linear Jacobian, columns in the order $\theta_1, \theta_2, d_3$.

# %%
### BEGIN SOLUTION
turret = r"d_3^2 \cos\theta_2"
### END SOLUTION
lesson.transfer.check(turret)

# %% [markdown]
# ## Once more
#
# A task of lesson 8 comes back. Do it without looking.

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
# - A text that is unclear has readings: work each of them out, then one of them cannot be meant.
# - A determinant in factors names the singular configurations, one factor a family.
# - Where two families meet, the rank falls by two.
#
# ## Further
#
# - Take $l_2 = l_3$ and fold the arm: where is $P$, and what is the rank of $J_L$?
#   `armproof singularities spatial_rrr --frame P --rows 1,2,3` answers.
# - A third reading puts $P$ along $x_3$. What would change in the determinant?
# - Many industrial arms begin with these three joints. The KR210 of lesson 8 does, with two more offsets and a wrist.
