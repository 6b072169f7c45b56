# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "SCARA: forward kinematics by the modified convention"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# arm: scara_modified
# symbols:
#   "a_{i-1}": free
#   "alpha_{i-1}": free
#   d_i: free
#   theta_i: free
#   "q_1": theta_1
#   "q_2": theta_2
#   "q_4": theta_4
#   "l_12": a_2
#   "l_23": a_3
# quantities:
#   "{}^{i-1}T_i": {link: modified}
#   "q_3": {origin: 3, in: 2, component: z}
#   "U_4": {pose: 4, in: 4}
#   "U_3": {pose: 4, in: 3}
#   "U_2": {pose: 4, in: 2}
#   "U_1": {pose: 4, in: 1}
#   "U_0": {pose: 4, in: 0}
#   "x": {origin: 4, component: x}
#   "y": {origin: 4, component: y}
#   "z": {origin: 4, component: z}
#   '\mathrm{OA}': {origin: 2, component: x}
#   '\mathrm{OB}': {origin: 4, component: x}
#   '\mathrm{OC}': {origin: 2, component: y}
#   '\mathrm{OD}': {origin: 4, component: y}
#   "o_3": {origin: 3, in: 2, component: z}
# ---

# %% [markdown]
# # 6 · SCARA: forward kinematics by the modified convention
#
# Two arms in a horizontal plane, a quill that goes down and turns: four joints, four degrees of freedom (*degrés de liberté*, DDL). You
# write its forward kinematics (*modèle géométrique direct*, MGD), first by hand, then as a program.
# Source: MECA 953, *Robotique*, MMT5, 2022
# (document 001), slides "Exemple Robot SCARA" (an example).

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch

lesson = open_lesson("scara_forward")
lesson

# %% [markdown]
# ## The arm and its frames
#
# All frames are modified DH frames with $z$ up. The slides call the variable of the prismatic joint 3 $d_2$ and count it downwards; $a_2$ and
# $a_3$ are the arms.

# %%
sketch(load_arm("scara_modified"), table=False)

# %% [markdown]
# ## Predict
#
# With $a_2 = 0.3$ m and $a_3 = 0.25$ m, at $\theta_1 = 90°$, $\theta_2 = -90°$, $d_2 = 0.1$ m: draw the arm from above, and write the tool's
# `[x, y, z]` in frame 0.

# %%
### BEGIN SOLUTION
tool = [0.25, 0.3, -0.1]
### END SOLUTION
lesson.predict.check(tool)

# %% [markdown]
# ## The table
#
# Row $i$ holds $\alpha_{i-1}$ and $a_{i-1}$ of the link before, then $d_i$ and $\theta_i$.
#
# ### Task: four rows
#
# A list of $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$, letters as text.

# %%
### BEGIN SOLUTION
rows = [
    (0, 0, 0, "theta_1"),
    (0, "a_2", 0, "theta_2"),
    (0, "a_3", "-d_2", 0),
    (0, 0, 0, "theta_4"),
]
### END SOLUTION
lesson.table.check(rows)

# %% [markdown]
# Document 001 prints this table twice, and the second time a sign is lost. It is the offset of joint 3, $z$ of the origin of frame 3 in frame 2:
#
# > **Erratum** (slide "MGD – Exemple Robot SCARA", table, row 3, as printed; $o_3$ is our letter for that offset)
# > $$o_3 = d_2$$
#
# ## One function for all links
#
# $${}^{i-1}T_i = \begin{bmatrix} C\theta_i & -S\theta_i & 0 & a_{i-1} \\ S\theta_i C\alpha_{i-1} & C\theta_i C\alpha_{i-1} & -S\alpha_{i-1} & -d_i S\alpha_{i-1} \\ S\theta_i S\alpha_{i-1} & C\theta_i S\alpha_{i-1} & C\alpha_{i-1} & d_i C\alpha_{i-1} \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# The slides' program has it as a function `T(ai, alpha, di, theta)`.
#
# ### Task: the function
#
# Arguments: $a_{i-1}$, $\alpha_{i-1}$, $d_i$, $\theta_i$ in this order. Return a 4×4 array.


# %%
def link(a, alpha, d, theta):
    """Return the modified link matrix, 4×4."""
    ### BEGIN SOLUTION
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([
        [ct, -st, 0, a],
        [st * ca, ct * ca, -sa, -sa * d],
        [st * sa, ct * sa, ca, ca * d],
        [0, 0, 0, 1],
    ])  # fmt: skip
    ### END SOLUTION


lesson.link.check(link)

# %% [markdown]
# ## From the tool to the base
#
# The slides multiply backwards, and name each partial product:
#
# $$\begin{aligned} U_4 &= I_4 \\ U_3 &= {}^3T_4\,U_4 = {}^3T_4 \\ U_2 &= {}^2T_3\,U_3 = {}^2T_4 \\ U_1 &= {}^1T_2\,U_2 = {}^1T_4 \\ U_0 &= {}^0T_1\,U_1 = {}^0T_4 \end{aligned}$$
#
# $U_i$ is the pose of the tool in frame $i$, so each can be checked on its own.
#
# ### Task: $U_2$
#
# 4×4, as LaTeX: `r"\begin{bmatrix} … & … \\ … & … \end{bmatrix}"`; write `C_4` for the cosine of $\theta_4$.

# %%
### BEGIN SOLUTION
U_2 = r"\begin{bmatrix} C_4 & -S_4 & 0 & a_3 \\ S_4 & C_4 & 0 & 0 \\ 0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
### END SOLUTION
lesson.second_product.check(U_2)

# %% [markdown]
# ### Task: $U_1$
#
# `C_{24}` is the cosine of $\theta_2 + \theta_4$. Leave the products of sines and cosines as they come, or add the angles.

# %%
### BEGIN SOLUTION
U_1 = r"""\begin{bmatrix} C_{24} & -S_{24} & 0 & a_3 C_2 + a_2 \\ S_{24} & C_{24} & 0 & a_3 S_2 \\
0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.first_product.check(U_1)

# %% [markdown]
# ### Task: the whole model in Python
#
# Let the computer take the last step, and all the others: a loop over the rows, from the tool to the base. `q` is
# $[\theta_1, \theta_2, d_2, \theta_4]$; the lengths are arguments. Your function is proved for all joint values and all lengths.


# %%
def forward(q, a_2, a_3):
    """Return the pose of frame 4 in frame 0, 4×4."""
    ### BEGIN SOLUTION
    theta_1, theta_2, d_2, theta_4 = q
    U = np.eye(4)
    for row in [(0, 0, 0, theta_4), (a_3, 0, -d_2, 0), (a_2, 0, 0, theta_2), (0, 0, 0, theta_1)]:
        U = link(*row) @ U
    return U
    ### END SOLUTION


lesson.forward.check(forward)

# %% [markdown]
# Your frame 4 over Drake's:

# %%
lesson.forward.show(forward, theta_1=0.5, theta_2=0.9, d_2=0.12, theta_4=-0.6)

# %% [markdown]
# Move it yourself. `lesson.forward.move(forward, in_3d=True)` shows it in Drake's viewer too. Which slider
# turns the tool and leaves its point where it is?

# %%
lesson.forward.move(forward)

# %% [markdown]
# ### Task: the slide's own program
#
# In the zero pose the slide shows the output `[1.0*a2 + 1.0*a3, 0, -1.0*d2, 1.0]`. Its listing says `d3 = symbols('d2')`. What does it really
# print as the third number? `a`: `-1.0*d2`; `b`: `1.0*d2`; `c`: `0`; `d`: an error. Write the letter, in quotes.

# %%
### BEGIN SOLUTION
third = "b"
### END SOLUTION
lesson.listing.check(third)

# %% [markdown]
# ## Seen from above
#
# A geometric check, for which the slides write $q_i$ for the joint variables and $l_{12}$, $l_{23}$ for the arms. $A$, $B$ are the projections of elbow
# and tool on $x_0$, $C$, $D$ those on $y_0$:
#
# $$\mathrm{OA} = l_{12} \cos(q_1) \qquad \mathrm{OB} = x = l_{12} \cos(q_1) + l_{23} \cos(q_1 + q_2)$$
#
# $$\mathrm{OC} = l_{12} \sin(q_1) \qquad \mathrm{OD} = y = l_{12} \sin(q_1) + l_{23} \sin(q_1 + q_2)$$
#
# $$z = q_3 = -d_2$$
#
# and $\theta = q_1 + q_2 + q_4$. The third variable is the offset of the table's row 3, $q_3 = -d_2$. Whoever takes $d_2$ itself for it has the
# wrong sign, and a view from above does not show it: it says nothing about heights.
#
# ### Task: the distance from axis 1
#
# Write $x^2 + y^2$, the squared distance of the tool from axis 1, in `theta_2`, `a_2`, `a_3`, with $\theta_2$ as the only angle.

# %%
### BEGIN SOLUTION
distance_squared = r"a_2^2 + a_3^2 + 2 a_2 a_3 \cos\theta_2"
### END SOLUTION
lesson.above.check(distance_squared)

# %% [markdown]
# ## Limits
#
# Without joint limits the tool covers a ring around axis 1. Write `[nearest, farthest]` distance in metres, for $a_2 = 0.3$ and $a_3 = 0.25$.
# On both circles the arm is in a singular configuration: lesson 12.

# %%
### BEGIN SOLUTION
ring = [0.3 - 0.25, 0.3 + 0.25]
### END SOLUTION
lesson.reach.check(ring)

# %% [markdown]
# ## An arm that you have not seen
#
# A column turns by $\theta_1$, a carriage on it rises by $d_2$, and a ram goes out by $d_3$: the rows $(\alpha_{i-1}, a_{i-1}, d_i,
# \theta_i)$ are $(0, 0, 0, \theta_1)$, $(0, 0, d_2, 0)$, $(-\frac{\pi}{2}, 0, d_3, 0)$. Write ${}^0T_3$.


# %%
def cylinder(q):
    """Return the pose of frame 3 in frame 0, 4×4."""
    ### BEGIN SOLUTION
    c, s = np.cos(q[0]), np.sin(q[0])
    return [[c, 0, -s, -q[2] * s], [s, 0, c, q[2] * c], [0, -1, 0, q[1]], [0, 0, 0, 1]]
    ### END SOLUTION


lesson.transfer.check(cylinder)

# %% [markdown]
# ## Once more
#
# A task of lesson 3 comes back. Do it without looking.

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
# - A table is a product: one link matrix a row, multiplied from the base.
# - Parallel axes add their angles: one sum of angles turns the tool.
# - One pose that you can see tests a product of four matrices.
#
# ## Further
#
# - Sheets `scara-001.md` and `scara-python-001.md` hold all the slides' equations with their errata.
# - Documents 000 and 004 describe a SCARA with $z_3$ pointing down. Which entries of $U_0$ change? Lessons 12 and 14 use it.
# - Lesson 7 does the same for six joints.
