# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Frames and homogeneous transforms"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# arm: planar_2r
# symbols:
#   alpha: free
#   theta: free
#   a: free
#   d: free
#   x: free
#   y: free
#   z: free
# ---

# %% [markdown]
# # 1 · Frames and homogeneous transforms
#
# Every formula of this course is a product of a few 4×4 matrices. Here you write them, chain them, invert them, and read one in Drake.
# The matrices are those of MECA 953, *Robotique*, MMT5, 2022 (document 001), slides "Matrice de passage homogène Denavit-Hartenberg" (the homogeneous link matrix).
#
# An answer may be numbers, a Python function, a SymPy expression or LaTeX. `lesson.predict.hint()` gives a hint on the task `predict`, one
# more at each call;
# the same goes for every task.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch

lesson = open_lesson("frames")
lesson

# %% [markdown]
# ## The arm
#
# Two bars turn about parallel axes. Each carries a frame (*repère*): frame 0 stands on the ground, frame 1 at the end of bar 1, frame 2 at
# the tool. You will come back to it below.

# %%
arm = load_arm("planar_2r")
sketch(arm, table=False)

# %% [markdown]
# ## Predict
#
# Frame B starts on frame A, turns by 90° about z, then moves 2 m along its **new** x axis. Before any matrix: where is its origin, in
# frame A? Write `[x, y, z]` in metres.

# %%
### BEGIN SOLUTION
origin_of_B = [0, 2, 0]
### END SOLUTION
lesson.predict.check(origin_of_B)

# %% [markdown]
# ## The elementary transforms
#
# A homogeneous transform (*matrice de passage homogène*) holds the pose of one frame in another: three columns with the axes, one with the
# origin, and the row 0 0 0 1. The slides give two turns and two moves:
#
# $$\mathbf{Rot}_x(\alpha) = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & C\alpha & -S\alpha & 0 \\ 0 & S\alpha & C\alpha & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \qquad \mathbf{Trans}_x(a) = \begin{bmatrix} 1 & 0 & 0 & a \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# $$\mathbf{Rot}_z(\theta) = \begin{bmatrix} C\theta & -S\theta & 0 & 0 \\ S\theta & C\theta & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \qquad \mathbf{Trans}_z(d) = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# $C$ and $S$ stand for cosine and sine. In blocks, a move has the identity on the left, the displacement on the right, and a bottom row:
#
# $$\vec{t} = \begin{bmatrix} a \\ 0 \\ 0 \end{bmatrix} \qquad \mathbf{Trans}_x(a) = \begin{bmatrix} I_3 & \vec{t} \\ 0 & 1 \end{bmatrix}$$
#
# > **Erratum** (slide "Matrice de passage homogène Denavit-Hartenberg", first matrix: the blocks lack their bottom row, so they are 3×4)
# > $$\mathbf{Trans}_x(a) = \begin{bmatrix} I & \vec{t} \end{bmatrix} = \begin{bmatrix} 1 & 0 & 0 & a \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$
#
# Count rows and columns before you multiply: it finds this kind of slip at no cost.
#
# ### Task: the rotation about y
#
# Write the missing one as a 4×4 matrix in `beta` (radians).


# %%
def rotation_y(beta):
    """Return Rot_y(beta), 4×4."""
    ### BEGIN SOLUTION
    c, s = np.cos(beta), np.sin(beta)
    return np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1]])
    ### END SOLUTION


lesson.rotation_y.check(rotation_y)

# %% [markdown]
# ## Composition
#
# A step that is made in the **current** frame is multiplied on the right. (A step about the axes of the fixed frame would stand on the
# left.)
#
# ### Task: turn, rise, move
#
# Frame B starts on frame A, turns by `theta` about z, moves `d` along z, then `a` along its own x. Write its pose in A, 4×4: as LaTeX,
# `r"\begin{bmatrix} … & … \\ … & … \end{bmatrix}"` (the `r` matters), or as a function of `theta`, `d`, `a` in this order.

# %%
### BEGIN SOLUTION
T_AB = r"""\begin{bmatrix} \cos\theta & -\sin\theta & 0 & a\cos\theta \\ \sin\theta & \cos\theta & 0 & a\sin\theta \\
0 & 0 & 1 & d \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.compose.check(T_AB)

# %% [markdown]
# ### Task: what may change places
#
# Which pairs give the same product in both orders, for all values? `a`: Rot_x and Trans_x; `b`: Rot_z and Trans_x; `c`: Rot_x and Rot_z;
# `d`: Trans_x and Trans_z. Write a list of letters, in quotes: `["c"]`.

# %%
### BEGIN SOLUTION
commuting = ["a", "d"]
### END SOLUTION
lesson.order.check(commuting)

# %% [markdown]
# ## The inverse
#
# Never invert such a matrix as a 4×4 system. From
# $M = \begin{bmatrix} \cos\theta & -\sin\theta & 0 & x \\ \sin\theta & \cos\theta & 0 & y \\ 0 & 0 & 1 & z \\ 0 & 0 & 0 & 1 \end{bmatrix}$
# you get its inverse by transposing the rotation and by expressing the negated origin in the turned frame. On the arm, where the rotation
# and the origin of frame 2 are known, that reads
#
# $${}^2T_0 = \left({}^0T_2\right)^{-1} = \begin{bmatrix} {}^0R_2^T & -{}^0R_2^T p_2 \\ 0 & 1 \end{bmatrix}$$
#
# ### Task: the inverse of M
#
# Write it entry by entry, 4×4, in `theta`, `x`, `y`, `z`.


# %%
def inverse(theta, x, y, z):
    """Return the inverse of M, 4×4."""
    ### BEGIN SOLUTION
    R = np.array([[np.cos(theta), -np.sin(theta), 0], [np.sin(theta), np.cos(theta), 0], [0, 0, 1]])
    p = np.array([x, y, z])
    return np.vstack([np.column_stack([R.T, -R.T @ p]), [0, 0, 0, 1]])
    ### END SOLUTION


lesson.inverse.check(inverse)

# %% [markdown]
# ## The planar arm
#
# Bar $i$ is a turn by $\theta_i$ and a move by $l_i$ along the new x:
#
# $${}^0T_2 = {}^0T_1\,{}^1T_2 = \mathbf{Rot}_z(\theta_1)\,\mathbf{Trans}_x(l_1)\,\mathbf{Rot}_z(\theta_2)\,\mathbf{Trans}_x(l_2)$$
#
# ### Task: the pose of the tool
#
# Return the pose of frame 2 in frame 0, 4×4. `q` holds the two angles in radians, the lengths are in metres.


# %%
def pose(q, l_1, l_2):
    """Return the pose of frame 2 in frame 0, 4×4."""
    ### BEGIN SOLUTION
    first, both = q[0], q[0] + q[1]
    x = l_1 * np.cos(first) + l_2 * np.cos(both)
    y = l_1 * np.sin(first) + l_2 * np.sin(both)
    return np.array([
        [np.cos(both), -np.sin(both), 0, x],
        [np.sin(both), np.cos(both), 0, y],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
    ])  # fmt: skip
    ### END SOLUTION


lesson.pose.check(pose)

# %% [markdown]
# Your frame 2 over Drake's:

# %%
lesson.pose.show(pose, theta_1=0.5, theta_2=0.8)

# %% [markdown]
# Now with your own hands: a slider a joint. Where do the two frames part? The ellipse holds the velocities that the tool can have;
# bend the elbow until it is nearly round, stretch the arm until it is flat.

# %%
lesson.pose.move(pose)

# %% [markdown]
# ## Reading a pose in Drake
#
# Drake writes `X_AB` for the pose of B in A. The inner letters of a product meet: `X_AC = X_AB @ X_BC`, `p_AP = X_AB @ p_BP`. Change the
# two angles and compare with your matrix; Drake's arm has $l_1 = 0.45$ m and $l_2 = 0.35$ m.

# %%
from armproof.models.numeric.drake_arm import frame_of, plant_of

plant = plant_of(arm)
context = plant.CreateDefaultContext()
plant.SetPositions(context, [0.5, 0.8])
X_02 = frame_of(arm, 2).CalcPose(context, frame_of(arm, 0))
X_02.GetAsMatrix4().round(4)

# %% [markdown]
# ### Task: Drake's order
#
# `p_0P` holds a point in frame 0. What gives it in frame 2? `a`: `X_02 @ p_0P`; `b`: `X_02.inverse() @ p_0P`;
# `c`: `X_02.rotation().transpose() @ p_0P`; `d`: `p_0P - X_02.translation()`. Write the letter, in quotes.

# %%
### BEGIN SOLUTION
in_frame_2 = "b"
### END SOLUTION
lesson.reading.check(in_frame_2)

# %% [markdown]
# ### Task: a point seen from frame 0
#
# A camera stands at $[0, h, 0]^T$ in frame 2. Write its three coordinates in frame 0.


# %%
def camera(theta_1, theta_2, l_1, l_2, h):
    """Return the camera's coordinates in frame 0, three numbers in metres."""
    ### BEGIN SOLUTION
    t12 = theta_1 + theta_2
    x = l_1 * np.cos(theta_1) + l_2 * np.cos(t12) - h * np.sin(t12)
    y = l_1 * np.sin(theta_1) + l_2 * np.sin(t12) + h * np.cos(t12)
    return [x, y, 0]
    ### END SOLUTION


lesson.point.check(camera)

# %% [markdown]
# ## Limits
#
# Sixteen entries look like a lot of freedom. A rotation that comes out of many rounded products obeys its equations less and less, and
# its transpose is then no longer its inverse. How many independent numbers determine a homogeneous transform?

# %%
### BEGIN SOLUTION
independent = 6
### END SOLUTION
lesson.freedom.check(independent)

# %% [markdown]
# ## An arm that you have not seen
#
# A carriage slides by $d$ along $x$ of frame A; a bar of length $b$ on it turns by $\theta$ about $z$. Write the pose of the bar's end in A.


# %%
def carriage(d, theta, b):
    """Return the pose of the bar's end in frame A, 4×4."""
    ### BEGIN SOLUTION
    c, s = np.cos(theta), np.sin(theta)
    return [[c, -s, 0, d + b * c], [s, c, 0, b * s], [0, 0, 1, 0], [0, 0, 0, 1]]
    ### END SOLUTION


lesson.transfer.check(carriage)

# %% [markdown]
# ## What you know now
#
# - A transform is a turn and a shift; a chain of them is a product, read from left to right.
# - The inverse transposes the rotation and turns the shift back: $-R^T p$.
# - The columns of a pose are the axes of the moved frame and its origin.
#
# ## Further
#
# - Drake's page on multibody notation explains `X_AB`, `R_AB`, `p_AB`; `CONVENTIONS.md` maps them to the documents.
# - Sheet `dh-modified-001.md` has all four elementary transforms and the errata of the slide.
# - Lesson 3 makes one link matrix of four of these steps, in two conventions.
