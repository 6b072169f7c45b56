# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "From a URDF offset table to DH: the KUKA KR210"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# arm: kr210
# transforms: upper
# quantities:
#   "{}^{i-1}T_i": {link: modified}
# symbols: {d_i: free, theta_i: free, "a_{i-1}": free, "alpha_{i-1}": free}
# ---

# %% [markdown]
# # 8 · From a URDF offset table to DH: the KUKA KR210
#
# After the table at the head of MECA 953, *Robotique*, MMT5 (2022). In this lesson you
#
# 1. read a URDF's table of joint offsets: which transform is a row?
# 2. choose modified Denavit–Hartenberg frames (*convention de Khalil–Kleinfinger*, DH-KK) on the same axes and write
#    their table,
# 3. tie both descriptions together with a constant transform, and prove that they are one arm.

# %%
from armproof import open_lesson

lesson = open_lesson("kr210_table")
lesson

# %% [markdown]
# ## Two descriptions of an arm
#
# Robot software describes an arm by a URDF: for each joint its place on the link before it, and its axis. The source
# gives such a table under the heading "relative location of joint {i-1} to joint {i}". That can be read either way;
# the numbers decide: a row says where joint $i$ sits in the frame of joint $i-1$.
#
# | Joint Name | Parent Link | Child Link | x (m) | y (m) | z (m) | roll | pitch | yaw |
# |---|---|---|---|---|---|---|---|---|
# | joint_1 | base_link | link_1 | 0 | 0 | 0.33 | 0 | 0 | 0 |
# | joint_2 | link_1 | link_2 | 0.35 | 0 | 0.42 | 0 | 0 | 0 |
# | joint_3 | link_2 | link_3 | 0 | 0 | 1.25 | 0 | 0 | 0 |
# | joint_4 | link_3 | link_4 | 0.96 | 0 | -0.054 | 0 | 0 | 0 |
# | joint_5 | link_4 | link_5 | 0.54 | 0 | 0 | 0 | 0 | 0 |
# | joint_6 | link_5 | link_6 | 0.193 | 0 | 0 | 0 | 0 | 0 |
# | gripper-joint | link_6 | gripper_link | 0.11 | 0 | 0 | 0 | 0 | 0 |
#
# The numbers are those of a KUKA KR210 with a gripper. The axes are left out; the robot has them along
#
# $$ {}^0z_1 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix} \qquad {}^1y_2 = {}^2y_3 = {}^4y_5 = \begin{bmatrix} 0 \\
# 1 \\ 0 \end{bmatrix} \qquad {}^3x_4 = {}^5x_6 = \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} $$
#
# Our letters for the offsets are in the figure; all angles are zero there.

# %%
from armproof import load_arm
from armproof.course.figures.kinds.sketch import sketch

sketch(load_arm("kr210"))

# %% [markdown]
# ## Predict
#
# Where is the gripper in this pose? Write $[P_x, P_y, P_z]$ in metres, from the table alone.

# %%
### BEGIN SOLUTION
gripper = [0.35 + 0.96 + 0.54 + 0.193 + 0.11, 0, 0.33 + 0.42 + 1.25 - 0.054]
### END SOLUTION
lesson.prediction.check(gripper)

# %% [markdown]
# ## A row of the URDF
#
# A row holds an offset that never changes; its joint adds a turn about its own axis. Write ${}^1T_2$, 4×4: the offset is
# $(a_1, 0, d_2)$, the axis $y$. Which comes first? (`q` holds all six angles, `q[1]` is $\theta_2$.)

# %%
import numpy as np


def urdf_link(q, a_1, d_2):
    """Return ¹T_2 between the URDF's frames, 4×4."""
    ### BEGIN SOLUTION
    c, s = np.cos(q[1]), np.sin(q[1])
    offset = np.array([[1, 0, 0, a_1], [0, 1, 0, 0], [0, 0, 1, d_2], [0, 0, 0, 1]])
    turn = np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1]])
    return offset @ turn
    ### END SOLUTION


lesson.urdf_link.check(urdf_link)

# %% [markdown]
# ## DH frames on the same axes
#
# Denavit and Hartenberg need four numbers a joint instead of six, because their frames may not sit anywhere: $z_i$ is
# the axis of joint $i$, and $x_i$ runs along the common normal of $z_i$ and $z_{i+1}$. So look at the lines, not at
# the joints. Which three of the six axes meet in one point at every configuration? Write the list of their keys, of
# `"z1"`, `"z2"`, … `"z6"`.

# %%
### BEGIN SOLUTION
meeting = ["z4", "z5", "z6"]
### END SOLUTION
lesson.wrist.check(meeting)

# %% [markdown]
# An origin need not sit at its joint. $O_1$ moves up axis 1 to the height of the shoulder, and $O_4$, $O_5$, $O_6$
# all move to the wrist's centre. Offsets along one line then merge. Write a list of three distances in metres: from $O_0$
# up to $O_1$; along axis 4, from the foot of the perpendicular from axis 3 to $O_4$; and from $O_6$ to the gripper.

# %%
### BEGIN SOLUTION
distances = [0.33 + 0.42, 0.96 + 0.54, 0.193 + 0.11]
### END SOLUTION
lesson.merged.check(distances)

# %% [markdown]
# The frames of the modified convention, not to scale. $x_1$ points forward, all other $x_i$ up:

# %%
sketch(lesson.table.asks.loaded, table=False)

# %% [markdown]
# Write the table in our letters: a list of six rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$, entries as text or 0, angles in
# radians, as in `"pi/2"`. Mind where $x_1$ and $x_2$ point when all angles are zero.


# %%
### BEGIN SOLUTION
table = [
    (0, 0, "d_1 + d_2", "theta_1"),
    ("-pi/2", "a_1", 0, "theta_2 - pi/2"),
    (0, "a_2", 0, "theta_3"),
    ("-pi/2", "-a_3", "d_4 + d_5", "theta_4"),
    ("pi/2", 0, 0, "theta_5"),
    ("-pi/2", 0, 0, "theta_6"),
]
### END SOLUTION
lesson.table.check(table)

# %% [markdown]
# ## From the table to the matrices
#
# The modified link matrix (*matrice de passage*) of a row is
#
# $$ {}^{i-1}T_i = \begin{bmatrix} \cos\theta_i & -\sin\theta_i & 0 & a_{i-1} \\
# \sin\theta_i\cos\alpha_{i-1} & \cos\theta_i\cos\alpha_{i-1} & -\sin\alpha_{i-1} & -d_i\sin\alpha_{i-1} \\
# \sin\theta_i\sin\alpha_{i-1} & \cos\theta_i\sin\alpha_{i-1} & \cos\alpha_{i-1} & d_i\cos\alpha_{i-1} \\
# 0 & 0 & 0 & 1 \end{bmatrix} $$
#
# Put row 2 into it and write ${}^1T_2$ between the DH frames, in $\theta_2$ and the letter $a_1$. It is not the matrix of
# the URDF: the frames are different.


# %%
def dh_link(q, a_1):
    """Return ¹T_2 between the DH frames, 4×4."""
    ### BEGIN SOLUTION
    c, s = np.cos(q[1] - np.pi / 2), np.sin(q[1] - np.pi / 2)
    return np.array([[c, -s, 0, a_1], [0, 0, 1, 0], [-s, -c, 0, 0], [0, 0, 0, 1]])
    ### END SOLUTION


lesson.dh_link.check(dh_link)

# %% [markdown]
# The DH frame 6 sits in the wrist, $z_6$ along the hand and $x_6$ up in the zero pose; the URDF's gripper frame $G$
# is parallel to frame 0 there. Write the constant ${}^6T_G$ between them, 4×4, in the letters $d_6$ and $d_G$.


# %%
def tool(d_6, d_G):
    """Return ⁶T_G, 4×4."""
    ### BEGIN SOLUTION
    return [[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, d_6 + d_G], [0, 0, 0, 1]]
    ### END SOLUTION


lesson.tool.check(tool)

# %% [markdown]
# ## One arm
#
# Multiply all of it: six rows of your table, then ${}^6T_G$. The result is compared with the URDF as Drake reads it,
# for all joint angles. You may use the numbers, or name the lengths as arguments.


# %%
def pose(q):
    """Return ⁰T_G of the gripper, 4×4."""
    ### BEGIN SOLUTION
    right = np.pi / 2
    rows = [
        (0, 0, 0.75, q[0]),
        (-right, 0.35, 0, q[1] - right),
        (0, 1.25, 0, q[2]),
        (-right, -0.054, 1.5, q[3]),
        (right, 0, 0, q[4]),
        (-right, 0, 0, q[5]),
    ]
    X = np.eye(4)
    for alpha, a, d, theta in rows:
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        X = X @ np.array([[c, -s, 0, a], [s * ca, c * ca, -sa, -d * sa], [s * sa, c * sa, ca, d * ca], [0, 0, 0, 1]])
    return X @ np.array([[0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, 0.303], [0, 0, 0, 1]])
    ### END SOLUTION


lesson.pose.check(pose)

# %% [markdown]
# Your gripper frame, dashed, over that of the URDF:

# %%
lesson.pose.show(pose, theta_1=0.4, theta_2=0.3, theta_3=-0.2)

# %% [markdown]
# ## The limits
#
# Three axes in one point make an arm easy to invert, and they cost something. Put $\theta_5 = 0$. Write two numbers:
# the rank of the 6×6 Jacobian (at a generic posture of the other joints), and the rate $\dot\theta_6$ that undoes
# $\dot\theta_4 = 1$, so that the gripper is at rest.

# %%
### BEGIN SOLUTION
aligned = [5, -1]
### END SOLUTION
lesson.aligned.check(aligned)

# %% [markdown]
# ## An arm that you have not seen
#
# In a URDF three joints have these offsets and axes; all frames are parallel at zero:
#
# | joint | offset | axis | kind |
# |---|---|---|---|
# | 1 | $(0, 0, h)$ | $z$ | revolute |
# | 2 | $(0, e, 0)$ | $x$ | revolute |
# | 3 | $(0, 0, b)$ | $z$ | prismatic |
#
# Write the modified table. $z_i$ is the axis of joint $i$, frame 0 is on the floor with the axes of the URDF, $x_1$ and $x_2$ point along $y_0$ at
# zero. Rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$, with `h`, `e`, `b`, `theta_1`, `theta_2`, `d_3`.

# %%
### BEGIN SOLUTION
gantry = [(0, 0, "h", "theta_1 + pi/2"), ("pi/2", "e", 0, "theta_2"), ("-pi/2", 0, "d_3 + b", 0)]
### END SOLUTION
lesson.transfer.check(gantry)

# %% [markdown]
# ## Once more
#
# A task of lesson 5 comes back. Do it without looking.

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
# - A URDF puts each frame at its joint; DH puts it where the common normals meet the axes.
# - Offsets along one axis add up to one parameter.
# - A constant angle in the table is the price of another zero pose: leave it out, and the arm is bent.
#
# ## Further
#
# - `armproof view kr210` shows the arm in Drake's visualizer with its frames and joint sliders.
# - `armproof singularities kr210` has the other two families, elbow and shoulder.
# - Lesson 7: the spherical wrist (*poignet sphérique*) of the same source, whose printed table mixes two conventions.
