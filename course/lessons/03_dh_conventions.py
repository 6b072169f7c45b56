# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "The two Denavit–Hartenberg conventions"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# quantities:
#   "{}^{i-1}T_i": {link: modified}
#   "A_i": {link: classic}
# ---

# %% [markdown]
# # 3 · The two Denavit–Hartenberg conventions
#
# Two conventions are in use, and their tables look alike. The modified one (Khalil–Kleinfinger, DH-KK, 1986) has the axis of joint $i$ on
# $z_i$, the classic one (1955) on $z_{i-1}$. Here you use both on one arm.
# Source: MECA 953, *Robotique*, MMT5, 2022 (document 001).

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch
from armproof.course.tasks.dh_conventions import CLASSIC, MODIFIED

lesson = open_lesson("dh_conventions")
lesson

# %% [markdown]
# ## A new arm: the crane
#
# A motor on the floor turns a column about its vertical axis (angle $\theta_1$). At the height $h$ it carries a horizontal axis that
# passes the column at the distance $e$ (angle $\theta_2$). On it sits a slide (*articulation prismatique*) that crosses this axis at a
# right angle and extends by $d_3$; at $\theta_2 = 0$ it points up, at $\theta_2 = 90°$ away from the column.
#
# ## Predict
#
# In the modified convention: where is $O_1$? `a`: at the motor, on the floor; `b`: on axis 1, at the height $h$; `c`: on axis 2, nearest to
# axis 1; `d`: in the middle between the two axes. Write the letter, in quotes; a guess will do, the rule comes next.

# %%
### BEGIN SOLUTION
place_of_O_1 = "b"
### END SOLUTION
lesson.origin.check(place_of_O_1)

# %% [markdown]
# ## Eight steps (modified)
#
# 1. Number the links from 0 (base) to $n$, the joints from 1 to $n$.
# 2. Lay $z_i$ along the axis of joint $i$.
# 3. Find the common normal (*normale commune*) of $z_i$ and $z_{i+1}$. $O_i$ is where it meets $z_i$. Crossing axes: their point. Parallel
#    axes: choose it, so that a $d$ vanishes.
# 4. Lay $x_i$ along the normal, from $z_i$ to $z_{i+1}$; if they cross, at right angles to both.
# 5. $y_i$ completes a right-handed frame.
# 6. Choose frame 0: simplest on frame 1 at $q_1 = 0$. (Our crane keeps it on the floor instead, which costs the $h$ of row 1.)
# 7. Choose frame $n$: $x_n$ along $x_{n-1}$ where the joint is at zero.
# 8. Fill in the table, row by row.
#
# The normal of axes 1 and 2 is horizontal, so $O_1$ is at the height $h$, far from the motor: an origin need **not** sit at the joint, as the
# slides' own list of common mistakes says. Arcs in the figure are the twists, from $z_{i-1}$ to $z_i$.

# %%
sketch(load_arm(MODIFIED), table=False)

# %% [markdown]
# ### Task: the modified table
#
# For the frames in the figure: a list of three rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$; letters as text, angles in radians, as in
# `"pi/2"`.

# %%
### BEGIN SOLUTION
modified = [
    (0, 0, "h", "theta_1"),
    ("-pi/2", "e", 0, "theta_2"),
    ("pi/2", 0, "d_3", 0),
]
### END SOLUTION
lesson.modified_table.check(modified)

# %% [markdown]
# ## The same arm, classic
#
# Now $z_{i-1}$ is the axis of joint $i$ and $O_i$ lies on $z_i$, the next axis: frame 1 moves out to axis 2. Compare the two figures: the
# symbol of joint 1 changed its place, the arm did not.

# %%
sketch(load_arm(CLASSIC), table=False)

# %% [markdown]
# ### Task: the classic table
#
# For these frames: three rows $(\theta_i, d_i, a_i, \alpha_i)$, in this order.

# %%
### BEGIN SOLUTION
classic = [
    {"theta": "theta_1", "d": "h", "a": "e", "alpha": "-pi/2"},
    {"theta": "theta_2", "d": 0, "a": 0, "alpha": "pi/2"},
    {"theta": 0, "d": "d_3", "a": 0, "alpha": 0},
]
### END SOLUTION
lesson.classic_table.check(classic)

# %% [markdown]
# ### Task: where is the tool?
#
# Both tables lead to the same tool. Return the origin of frame 3 in frame 0: three numbers in metres, `q` = $[\theta_1, \theta_2, d_3]$.


# %%
def tool(q, h, e):
    """Return the origin of frame 3 in frame 0."""
    ### BEGIN SOLUTION
    theta_1, theta_2, d_3 = q
    radius = e + d_3 * np.sin(theta_2)
    return [radius * np.cos(theta_1), radius * np.sin(theta_1), h + d_3 * np.cos(theta_2)]
    ### END SOLUTION


lesson.tool.check(tool)

# %% [markdown]
# Your tool over Drake's:

# %%
lesson.tool.show(tool, theta_1=0.4, theta_2=0.9, d_3=0.3)

# %% [markdown]
# ## The general matrices
#
# Modified: about and along $x_{i-1}$ first, then about and along $z_i$ (slides "Matrice de passage homogène Denavit-Hartenberg", the homogeneous link matrix):
#
# $${}^{i-1}T_i = \mathbf{Rot}_x(\alpha_{i-1})\,\mathbf{Trans}_x(a_{i-1})\,\mathbf{Rot}_z(\theta_i)\,\mathbf{Trans}_z(d_i) = \begin{bmatrix} C\theta_i & -S\theta_i & 0 & a_{i-1} \\ S\theta_i C\alpha_{i-1} & C\theta_i C\alpha_{i-1} & -S\alpha_{i-1} & -d_i S\alpha_{i-1} \\ S\theta_i S\alpha_{i-1} & C\theta_i S\alpha_{i-1} & C\alpha_{i-1} & d_i C\alpha_{i-1} \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# Classic: about and along $z_{i-1}$ first, then along and about $x_i$. Call it $A_i$:
#
# $$A_i = \mathbf{Rot}_z(\theta_i)\,\mathbf{Trans}_z(d_i)\,\mathbf{Trans}_x(a_i)\,\mathbf{Rot}_x(\alpha_i)$$
#
# > **Erratum** (slide "Comparaisons des paramètres de Denavit-Hartenberg classiques et modifiés", classic column, as printed)
# > $$A_i = \begin{bmatrix} C\theta_i & -C\alpha_i S\theta_i & S\alpha_i S\theta_i & d_i C\theta_i \\ S\theta_i & C\alpha_i C\theta_i & -S\alpha_i C\theta_i & d_i S\theta_i \\ 0 & S\alpha_i & C\alpha_i & a_i \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# ### Task: the classic link matrix
#
# Find the slip, and write the right matrix in `a`, `alpha`, `d`, `theta`.


# %%
def classic_matrix(a, alpha, d, theta):
    """Return the classic link matrix, 4×4."""
    ### BEGIN SOLUTION
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    turn_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    turn_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    return turn_z @ turn_x
    ### END SOLUTION


lesson.classic_matrix.check(classic_matrix)

# %% [markdown]
# ### Task: the inverse, modified
#
# The slide "Transformation inverse" (the inverse transform) prints blocks that do not fit together. Write the inverse of the modified matrix in full, 4×4; `a` and
# `alpha` stand for $a_{i-1}$ and $\alpha_{i-1}$. LaTeX, or a function of `a`, `alpha`, `d`, `theta`.

# %%
### BEGIN SOLUTION
inverse = r"""\begin{bmatrix} C\theta & S\theta C\alpha & S\theta S\alpha & -a C\theta \\
-S\theta & C\theta C\alpha & C\theta S\alpha & a S\theta \\ 0 & -S\alpha & C\alpha & -d \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.modified_inverse.check(inverse)

# %% [markdown]
# With the rotation and the origin of the link matrix, the inverse is one transposed block, one column of three entries, one row:
#
# $${}^{i-1}R_i = \begin{bmatrix} C\theta_i & -S\theta_i & 0 \\ S\theta_i C\alpha_{i-1} & C\theta_i C\alpha_{i-1} & -S\alpha_{i-1} \\ S\theta_i S\alpha_{i-1} & C\theta_i S\alpha_{i-1} & C\alpha_{i-1} \end{bmatrix} \qquad {}^{i-1}O_i = \begin{bmatrix} a_{i-1} \\ -d_i S\alpha_{i-1} \\ d_i C\alpha_{i-1} \end{bmatrix}$$
#
# $${}^{i}T_{i-1} = \left({}^{i-1}T_i\right)^{-1} = \begin{bmatrix} {}^{i-1}R_i^T & -{}^{i-1}R_i^T\,{}^{i-1}O_i \\ 0 & 1 \end{bmatrix}$$
#
# > **Erratum** (slide "Transformation inverse", as printed: zeros beside the entries of the origin, a row too many)
# > $${}^{i}T_{i-1} = \begin{bmatrix} {}^{i-1}R_i^T & -a_{i-1} C\theta_i \\ 0 & a_{i-1} S\theta_i \\ 0 & -d_i \\ 0 & 0 & 1 \end{bmatrix}$$
#
# ### Task: which check would have caught it?
#
# The slide exchanges $a_i$ and $d_i$ in the classic matrix **and** in its inverse. Which checks find that? `a`: the product of the two printed
# matrices is the identity; `b`: the determinant of the rotation block is 1; `c`: the origin at $\theta_i = \alpha_i = d_i = 0$; `d`: the pose
# in Drake, with different $a_i$ and $d_i$; `e`: the pose in Drake, with $a_i = d_i$. Write a list of letters.

# %%
### BEGIN SOLUTION
checks = ["c", "d"]
### END SOLUTION
lesson.checks.check(checks)

# %% [markdown]
# ## Limits
#
# Axes meant to be parallel never are, quite. Two axes cross in a plane, 0.5 m apart, one leaning by 0.001 rad. How far away do they meet, in
# metres? There the rule puts the origin, outside the building; calibration therefore uses other parameters for parallel axes.

# %%
### BEGIN SOLUTION
distance = 0.5 / 0.001
### END SOLUTION
lesson.parallel.check(distance)

# %% [markdown]
# ## An arm that you have not seen
#
# A wall crane: a carriage slides up by $d_1$, a bar turns by $\theta_2$ about an axis at the distance $b$, a ram goes out by $d_3$. Its modified
# table has the rows $(0, 0, d_1, 0)$, $(0, b, 0, \theta_2)$, $(\frac{\pi}{2}, 0, d_3, 0)$.
#
# Write its classic table, three rows $(\theta_i, d_i, a_i, \alpha_i)$.

# %%
### BEGIN SOLUTION
crane = [(0, "d_1", "b", 0), ("theta_2", 0, 0, "pi/2"), (0, "d_3", 0, 0)]
### END SOLUTION
lesson.transfer.check(crane)

# %% [markdown]
# ## What you know now
#
# - Modified: $z_i$ is the axis of joint $i$, and its row holds $a$ and $\alpha$ of the link before. Classic: the axis of joint $i$ is $z_{i-1}$, and
#   its row holds those of its own link.
# - A table without its convention says nothing; the two link matrices do not mix.
# - A check finds an exchange of $a$ and $d$ only where the two differ.
#
# ## Further
#
# - `CONVENTIONS.md` has both matrices side by side; sheets `dh-classic-001.md` and `dh-modified-001.md` the definitions as equations.
# - The slides write $r_i$ and $d_i$ for one offset. Look up which letter your other courses use.
# - Lesson 8 reads a table from a URDF, which needs no convention at all.
