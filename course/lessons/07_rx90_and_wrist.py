# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Stäubli RX-90 and the spherical wrist"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# arm: rx90
# quantities:
#   "U_6": {pose: 6, in: 6}
#   "U_5": {pose: 6, in: 5}
#   "U_4": {pose: 6, in: 4}
#   "U_3": {pose: 6, in: 3}
#   "U_2": {pose: 6, in: 2}
#   "U_1": {pose: 6, in: 1}
#   "U_0": {pose: 6, in: 0}
# ---

# %% [markdown]
# # 7 · Stäubli RX-90 and the spherical wrist
#
# Six joints: three carry the wrist to a point, three turn the tool about that point. You follow the products of the slides from the tool to the
# base, and correct them on the way.
# Source: MECA 953, *Robotique*, MMT5, 2022 (document 001), slides "Stäubli RX-90" and "Poignet sphérique" (the spherical wrist).

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch

lesson = open_lesson("rx90_and_wrist")
lesson

# %% [markdown]
# ## The arm and its frames
#
# The zero pose: upper arm ($a_3$) horizontal, forearm ($d_3$) upright. Frames are modified DH frames; frame 0 lies in the shoulder.

# %%
sketch(load_arm("rx90"), table=False)

# %% [markdown]
# ## Predict
#
# With $a_3 = 0.45$ m and $d_3 = 0.42$ m: where is the origin of frame 6 at $\theta_2 = 90°$, $\theta_3 = -90°$, all others 0? Write `[x, y, z]`
# in metres.

# %%
### BEGIN SOLUTION
upright = [0, 0, 0.45 + 0.42]
### END SOLUTION
lesson.predict.check(upright)

# %% [markdown]
# ## The table
#
# ### Task: six rows
#
# A list of $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$, letters as text, angles as in `"pi/2"`; read each twist off the figure by the right-hand
# rule. Beware: the slides' $d_3$ is not the offset of row 3.

# %%
### BEGIN SOLUTION
rows = [
    (0, 0, 0, "theta_1"),
    ("pi/2", 0, 0, "theta_2"),
    (0, "a_3", 0, "theta_3"),
    ("-pi/2", 0, "d_3", "theta_4"),
    ("pi/2", 0, 0, "theta_5"),
    ("-pi/2", 0, 0, "theta_6"),
]
### END SOLUTION
lesson.table.check(rows)

# %% [markdown]
# ## The link matrices
#
# Rows 1 to 5, as the slide has them:
#
# $${}^0T_1 = \begin{bmatrix} C\theta_1 & -S\theta_1 & 0 & 0 \\ S\theta_1 & C\theta_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \quad {}^1T_2 = \begin{bmatrix} C\theta_2 & -S\theta_2 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ S\theta_2 & C\theta_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \quad {}^2T_3 = \begin{bmatrix} C\theta_3 & -S\theta_3 & 0 & a_3 \\ S\theta_3 & C\theta_3 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# $${}^3T_4 = \begin{bmatrix} C\theta_4 & -S\theta_4 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ -S\theta_4 & -C\theta_4 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \quad {}^4T_5 = \begin{bmatrix} C\theta_5 & -S\theta_5 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ S\theta_5 & C\theta_5 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# The sixth contradicts the table above it:
#
# > **Erratum** (slide "MGD robot Stäubli RX-90", last matrix, as printed: the twist's sign of row 6 lost)
# > $${}^5T_6 = \begin{bmatrix} C\theta_6 & -S\theta_6 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ S\theta_6 & C\theta_6 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# ### Task: the last link matrix
#
# Write it as row 6 has it, 4×4: LaTeX with `C_6` and `S_6`, or a function of `q`, which holds all six angles.

# %%
### BEGIN SOLUTION
T_56 = r"\begin{bmatrix} C_6 & -S_6 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ -S_6 & -C_6 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
### END SOLUTION
lesson.last_link.check(T_56)

# %% [markdown]
# ## From the tool to the base
#
# $$U_6 = I_4 \qquad U_5 = {}^5T_6\,U_6 \qquad U_4 = {}^4T_5\,U_5 \qquad U_3 = {}^3T_4\,U_4$$
#
# $$U_2 = {}^2T_3\,U_3 \qquad U_1 = {}^1T_2\,U_2 \qquad U_0 = {}^0T_1\,U_1$$
#
# > **Erratum** (same slides, as printed: the start of the recursion has the size of the number of joints)
# > $$U_6 = I_6$$
#
# ### Task: $U_4$
#
# 4×4, in Python this time; `q` holds all six angles, `q[4]` is $\theta_5$. In a rotation all rows and columns are unit vectors: the printed third row,
# $[S_5 S_6, -S_5 S_6, C_5]$, fails that test.


# %%
def fourth_product(q):
    """Return the pose of frame 6 in frame 4, 4×4."""
    ### BEGIN SOLUTION
    c5, s5, c6, s6 = np.cos(q[4]), np.sin(q[4]), np.cos(q[5]), np.sin(q[5])
    T_45 = np.array([[c5, -s5, 0, 0], [0, 0, -1, 0], [s5, c5, 0, 0], [0, 0, 0, 1]])
    T_56 = np.array([[c6, -s6, 0, 0], [0, 0, 1, 0], [-s6, -c6, 0, 0], [0, 0, 0, 1]])
    return T_45 @ T_56
    ### END SOLUTION


lesson.fourth_product.check(fourth_product)

# %% [markdown]
# ### Task: $U_3$
#
# Four entries of the slide's matrix are wrong. Write the right one, 4×4, by hand.
#
# > **Erratum** (same slide, as printed)
# > $$U_3 = {}^3T_6 = \begin{bmatrix} C\theta_4 C\theta_5 S\theta_4 C\theta_6 & -C\theta_4 C\theta_5 S\theta_6 & -C\theta_4 S\theta_5 & 0 \\ S\theta_5 C\theta_6 & -S\theta_5 S\theta_6 & C\theta_5 & d_3 \\ -S\theta_4 S\theta_5 S\theta_6 - C\theta_4 S\theta_6 & S\theta_4 C\theta_5 S\theta_6 & S\theta_4 S\theta_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$

# %%
### BEGIN SOLUTION
U_3 = r"""\begin{bmatrix} C_4 C_5 C_6 - S_4 S_6 & -C_4 C_5 S_6 - S_4 C_6 & -C_4 S_5 & 0 \\
S_5 C_6 & -S_5 S_6 & C_5 & d_3 \\
-S_4 C_5 C_6 - C_4 S_6 & S_4 C_5 S_6 - C_4 C_6 & S_4 S_5 & 0 \\
0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.third_product.check(U_3)

# %% [markdown]
# ## The pose
#
# The slides name the columns of the result $U_0$, above its last row: $\vec s$, $\vec n$, $\vec a$ and $P$.
#
# You need not multiply everything: one column asks for one column of each product.
#
# ### Task: the position
#
# Return $P$ in frame 0, three numbers in metres.


# %%
def centre(q, a_3, d_3):
    """Return the origin of frame 6 in frame 0."""
    ### BEGIN SOLUTION
    radius = a_3 * np.cos(q[1]) - d_3 * np.sin(q[1] + q[2])
    height = a_3 * np.sin(q[1]) + d_3 * np.cos(q[1] + q[2])
    return [radius * np.cos(q[0]), radius * np.sin(q[0]), height]
    ### END SOLUTION


lesson.wrist_centre.check(centre)

# %% [markdown]
# Your point over Drake's arm:

# %%
lesson.wrist_centre.show(centre, theta_1=0.4, theta_2=0.9, theta_3=-0.7)

# %% [markdown]
# ### Task: the approach axis
#
# Write $\vec a = [a_x, a_y, a_z]^T$ in frame 0: LaTeX, where `C_{23}` is the cosine of $\theta_2 + \theta_3$, or a function of `q`.

# %%
### BEGIN SOLUTION
a = r"""\begin{bmatrix} -C_1 (C_{23} C_4 S_5 + S_{23} C_5) + S_1 S_4 S_5 \\
-S_1 (C_{23} C_4 S_5 + S_{23} C_5) - C_1 S_4 S_5 \\ C_{23} C_5 - S_{23} C_4 S_5 \end{bmatrix}"""
### END SOLUTION
lesson.approach.check(a)

# %% [markdown]
# ## The spherical wrist
#
# A wrist is spherical (*poignet sphérique*) if its three axes meet in one point. The slides give one as an example, with a table of modified
# parameters; but the matrices below it are classic ones:
#
# $$\mathbf{Rot}_z(\theta_4)\,\mathbf{Rot}_x(-\tfrac{\pi}{2}) = \begin{bmatrix} c4 & 0 & -s4 & 0 \\ s4 & 0 & c4 & 0 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# > **Erratum** (slide "Poignet sphérique", second matrix, as printed)
# > $$\mathbf{Rot}_z(\theta_5)\,\mathbf{Rot}_x(\tfrac{\pi}{2}) = \begin{bmatrix} c5 & 0 & s5 & 0 \\ s5 & 0 & -c5 & 0 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# The third turns by $\theta_6$ about $z$ and moves by $d_6$ along it.
#
# ### Task: a check in your head
#
# What is the determinant of the 3×3 block of the matrix in the erratum?

# %%
### BEGIN SOLUTION
determinant = -1
### END SOLUTION
lesson.mirror.check(determinant)

# %% [markdown]
# ### Task: the wrist's matrix
#
# Return ${}^3T_6$, 4×4; `q` is $[\theta_4, \theta_5, \theta_6]$.


# %%
def wrist(q, d_6):
    """Return the pose of frame 6 in frame 3, 4×4."""
    ### BEGIN SOLUTION
    (c4, c5, c6), (s4, s5, s6) = np.cos(q), np.sin(q)
    T_34 = np.array([[c4, 0, -s4, 0], [s4, 0, c4, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
    T_45 = np.array([[c5, 0, s5, 0], [s5, 0, -c5, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    T_56 = np.array([[c6, -s6, 0, 0], [s6, c6, 0, 0], [0, 0, 1, d_6], [0, 0, 0, 1]])
    return T_34 @ T_45 @ T_56
    ### END SOLUTION


lesson.wrist.check(wrist)

# %% [markdown]
# Your frame 6 over Drake's:

# %%
lesson.wrist.show(wrist, theta_4=0.4, theta_5=0.8, theta_6=-0.5)

# %% [markdown]
# ## Limits
#
# At $\theta_5 = 0$ axes 4 and 6 lie in one line. Write the wrist's rotation ${}^3R_6$ there, 3×3, in `theta_4` and `theta_6`, and look at what is
# left of the three angles.


# %%
def in_line(theta_4, theta_6):
    """Return the rotation of frame 6 in frame 3 at theta_5 = 0, 3×3."""
    ### BEGIN SOLUTION
    c, s = np.cos(theta_4 + theta_6), np.sin(theta_4 + theta_6)
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]
    ### END SOLUTION


lesson.aligned.check(in_line)

# %% [markdown]
# ## An arm that you have not seen
#
# The head of a camera pans by $\theta_1$ at the height $h$ and tilts by $\theta_2$ about an axis at the distance $e$. Its modified table has the rows
# $(0, 0, h, \theta_1)$ and $(-\frac{\pi}{2}, e, 0, \theta_2)$. Write its pose.


# %%
def head(q, h, e):
    """Return the pose of frame 2 in frame 0, 4×4."""
    ### BEGIN SOLUTION
    (c1, c2), (s1, s2) = np.cos(q), np.sin(q)
    return [[c1 * c2, -c1 * s2, -s1, e * c1], [s1 * c2, -s1 * s2, c1, e * s1], [-s2, -c2, 0, h], [0, 0, 0, 1]]
    ### END SOLUTION


lesson.transfer.check(head)

# %% [markdown]
# ## Once more
#
# A task of lesson 4 comes back. Do it without looking.

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
# - A long product is worked out from the tool to the base, one link matrix at a time.
# - The determinant of a rotation is 1: a mirror is found at once.
# - Where two axes of a wrist are one line, their angles only count together.
#
# ## Further
#
# - Sheets `rx90-001.md` and `spherical-wrist-001.md`: all twelve components, the Jacobians, the singular configurations.
# - `armproof singularities rx90` names three families; which one have you just met?
# - A spherical wrist lets the inverse split in two: `rx90-inverse.md` has all eight solutions.
