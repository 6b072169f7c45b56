# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "The orientation of the tool, and one SCARA in three documents"
# source: MECA 953 Robotique, MMT5, 2022 (document 001), with the SCARAs of documents 000 and 004
# arm: scara
# transforms: upper
# ---

# %% [markdown]
# # 17 · The orientation of the tool, and one SCARA in three documents
#
# A position has three numbers; an orientation has nine in a matrix, and needs three. Here you read both kinds, and compare three documents
# that describe one arm.
#
# ## What the model takes and gives
#
# The forward kinematics (*modèle géométrique direct*) gives the pose $X$ for the joint variables $q$. For the SCARA: how many entries has
# $q$, how many $X$ with direction cosines (*cosinus directeurs*), and how many with roll, pitch and yaw angles (RPY)?

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch

lesson = open_lesson("tool_orientation")
lesson

# %%
### BEGIN SOLUTION
sizes = [4, 12, 6]
### END SOLUTION
lesson.unknowns.check(sizes)

# %% [markdown]
# ## s, n, a
#
# The slides call the columns of the rotation $s$ (sliding), $n$ (normal) and $a$ (approach): the x, y and z axes of the tool, in frame 0.
# A tool has the rotation $\begin{bmatrix} 0 & -1 & 0 \\ 0 & 0 & -1 \\ 1 & 0 & 0 \end{bmatrix}$. Where does its gripper point?

# %%
### BEGIN SOLUTION
approach = [0, -1, 0]
### END SOLUTION
lesson.columns.check(approach)

# %% [markdown]
# ### Task: the frame of a gripper
#
# Rules for a gripper (*pince*): $O_e$ in its middle, $Z_e$ towards the object, $Y_e$ in the plane in which the jaws slide,
# $X_e = Y_e \times Z_e$. It reaches along $[1, 0, 0]^T$, and its jaws slide along $[0, 0, 1]^T$. Give $X_e$.

# %%
### BEGIN SOLUTION
x_e = [0, 1, 0]
### END SOLUTION
lesson.gripper.check(x_e)

# %% [markdown]
# ### Task: two columns give the third
#
# A program sends $n$ and $a$ only. Write $s = n \times a$.

# %%
### BEGIN SOLUTION
s = r"\begin{bmatrix} n_y a_z - n_z a_y \\ n_z a_x - n_x a_z \\ n_x a_y - n_y a_x \end{bmatrix}"
### END SOLUTION
lesson.sliding.check(s)

# %% [markdown]
# ## RPY angles
#
# Three turns, about x by $\psi$, then about the fixed y by $\theta$, then about the fixed z by $\phi$; a step about fixed axes stands on the
# left. Write $\mathbf{Rot}_z(\phi)\,\mathbf{Rot}_y(\theta)\,\mathbf{Rot}_x(\psi)$, 3×3.


# %%
def rpy(phi, theta, psi):
    """Return the rotation of the RPY angles, 3×3."""
    ### BEGIN SOLUTION
    cf, sf, ct, st, cp, sp = np.cos(phi), np.sin(phi), np.cos(theta), np.sin(theta), np.cos(psi), np.sin(psi)
    return np.array([
        [cf * ct, cf * st * sp - sf * cp, cf * st * cp + sf * sp],
        [sf * ct, sf * st * sp + cf * cp, sf * st * cp - cf * sp],
        [-st, ct * sp, ct * cp],
    ])  # fmt: skip
    ### END SOLUTION


lesson.rpy.check(rpy)

# %% [markdown]
# Now back. The first column is $s = [0.768, 0.576, -0.28]^T$, and $\cos\theta > 0$. Give $\sin\theta$, $\cos\theta$ and $\tan\phi$.

# %%
### BEGIN SOLUTION
pitch = [0.28, 0.96, 0.75]
### END SOLUTION
lesson.pitch.check(pitch)

# %% [markdown]
# Write $\phi$ and $\psi$ by atan2 of entries of the matrix, for $\cos\theta > 0$.


# %%
def phi_and_psi(s_x, s_y, n_z, a_z):
    """Return phi and psi (rad)."""
    ### BEGIN SOLUTION
    return [np.arctan2(s_y, s_x), np.arctan2(n_z, a_z)]
    ### END SOLUTION


lesson.angles.check(phi_and_psi)

# %% [markdown]
# ### Limits
#
# At $\theta = \pi/2$ all four of these entries are zero. Write the rotation there, with one angle only: the other is lost.

# %%
### BEGIN SOLUTION
locked = r"\begin{bmatrix} 0 & \sin(\psi - \phi) & \cos(\psi - \phi) \\ 0 & \cos(\psi - \phi) & -\sin(\psi - \phi) \\ -1 & 0 & 0 \end{bmatrix}"
### END SOLUTION
lesson.lock.check(locked)

# %% [markdown]
# ## The SCARA of document 001
#
# All its axes point up. Write the last product $U_0 = {}^0T_1\,U_1$, 4×4, by hand.

# %%
### BEGIN SOLUTION
U_0 = r"""\begin{bmatrix} C_{124} & -S_{124} & 0 & a_2 C_1 + a_3 C_{12} \\ S_{124} & C_{124} & 0 & a_2 S_1 + a_3 S_{12} \\
0 & 0 & 1 & -d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.last_product.check(U_0)

# %% [markdown]
# What are its RPY angles $[\phi, \theta, \psi]$?

# %%
### BEGIN SOLUTION
upright = r"\begin{bmatrix} \theta_1 + \theta_2 + \theta_4 \\ 0 \\ 0 \end{bmatrix}"
### END SOLUTION
lesson.upright.check(upright)

# %% [markdown]
# ## The SCARA of document 000
#
# The same arm with classic frames: $z_2$, $z_3$ and $z_4$ point down.

# %%
sketch(load_arm("scara"), table=False)

# %% [markdown]
# Its rotation is
#
# $$ R^0_4 = R_z(\theta_1 + \theta_2 - \theta_4) R_x(\pi) = \begin{bmatrix} \cos(\theta_1 + \theta_2 - \theta_4) & \sin(\theta_1 + \theta_2 - \theta_4) & 0 \\ \sin(\theta_1 + \theta_2 - \theta_4) & -\cos(\theta_1 + \theta_2 - \theta_4) & 0 \\ 0 & 0 & -1 \end{bmatrix} $$
#
# Give its RPY angles.

# %%
### BEGIN SOLUTION
down = r"\begin{bmatrix} \theta_1 + \theta_2 - \theta_4 \\ 0 \\ \pi \end{bmatrix}"
### END SOLUTION
lesson.down.check(down)

# %% [markdown]
# Document 001 has the joint values $[\theta_1, \theta_2, d_2, \theta_4]$. Which ones has document 000 for the same posture, with the same
# $x_4$?

# %%
### BEGIN SOLUTION
converted = r"\begin{bmatrix} \theta_1 \\ \theta_2 \\ d_2 \\ -\theta_4 \end{bmatrix}"
### END SOLUTION
lesson.conversion.check(converted)

# %% [markdown]
# The three documents put frame 0 at three heights: 001 at the tool's height where the slide is at zero, 000 at the height of the arms, which
# is $d_4$ above that, 004 at the foot of a column of height $d_1$. The slide is lowered by $d_3$: how high is the tool in each?

# %%
### BEGIN SOLUTION
heights = r"\begin{bmatrix} -d_3 \\ -(d_3 + d_4) \\ d_1 - d_3 - d_4 \end{bmatrix}"
### END SOLUTION
lesson.heights.check(heights)

# %% [markdown]
# ## One arm, two tables
#
# Write the classic table of document 000's arm, rows $(\theta_i, d_i, a_i, \alpha_i)$.

# %%
### BEGIN SOLUTION
classic = [
    ("theta_1", 0, "a_1", 0),
    ("theta_2", 0, "a_2", "pi"),
    (0, "d_3", 0, 0),
    ("theta_4", "d_4", 0, 0),
]
### END SOLUTION
lesson.classic_table.check(classic)

# %% [markdown]
# And the modified one, with the same frames 0 and 4, rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$.

# %%
### BEGIN SOLUTION
modified = [
    (0, 0, 0, "theta_1"),
    (0, "a_1", 0, "theta_2"),
    ("pi", "a_2", "d_3", 0),
    (0, 0, "d_4", "theta_4"),
]
### END SOLUTION
lesson.modified_table.check(modified)

# %% [markdown]
# ## An arm that you have not seen
#
# A ram on a turning column has the orientation $R_z(\theta_1) R_x(-\frac{\pi}{2})$. Give `[roll, pitch, yaw]` at $\theta_1 = 0.4$, in radians.

# %%
### BEGIN SOLUTION
roll_pitch_yaw = [-np.pi / 2, 0, 0.4]
### END SOLUTION
lesson.transfer.check(roll_pitch_yaw)

# %% [markdown]
# ## Once more
#
# A task of lesson 14 comes back. Do it without looking.

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
# - The columns of a rotation are the axes of the tool; the third is where it points.
# - RPY angles are found by atan2, but for $\cos\theta = 0$, where only one of two is left.
# - Two documents on one arm may differ in signs and heights, and both be right: compare the frames first.
#
# Lesson 18 takes the SCARA's exercises step by step. Sheets: `scara-001.md`, `scara-000.md`, `scara-004.md`.
