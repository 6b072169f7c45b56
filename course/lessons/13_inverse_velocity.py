# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Inverse velocity: the inverse, the pseudo-inverses, and what happens at a singularity"
# source: Université de Constantine 1, Modélisation et commande des robots de manipulation, section 3.3 (document 002)
# arm: planar_2r
# symbols: {a: free, b: free, c: free, d: free, lambda: free,
#   g_1: free, g_2: free, g_3: free, h_1: free, h_2: free, h_3: free}
# quantities:
#   "J": {jacobian: 2, rows: [1, 2]}
# ---

# %% [markdown]
# # 13 · Inverse velocity: the inverse, the pseudo-inverses, and what happens at a singularity
#
# The forward model (*modèle cinématique direct*, MCD) takes joint rates to the velocity of the gripper,
# $\dot x = J \dot q$. Here you go back (*modèle cinématique inverse*, MCI). After section 3.3 of document 002. In this
# lesson you
#
# 1. invert the Jacobians of the polar and the planar 2R arm by adjugate and determinant,
# 2. choose the pseudo-inverse that exists when the Jacobian is not square,
# 3. say what the joints do at and near a singular configuration (*configuration singulière*), and what damping
#    changes.
#
# An answer may be a Python function, a SymPy expression or LaTeX.
# `lesson.predict` shows the task in full,
# `lesson.predict.hint()` gives a hint, one more at each call.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.course.tasks.inverse_velocity import show_rates

lesson = open_lesson("inverse_velocity")
lesson

# %%
draw_kind(find_kind("sketch"), load_arm("planar_2r"))

# %% [markdown]
# ## Predict: the stretched arm
#
# Stretch the arm along $x_0$. How can the gripper move at this moment: `"along"` the links, `"across"` them, `"both"`
# or `"none"`?

# %%
### BEGIN SOLUTION
direction = "across"
### END SOLUTION
lesson.predict.check(direction)

# %% [markdown]
# ## The inverse of a 2 × 2 matrix
#
# Divide the transposed matrix of cofactors (*comatrice*) by the determinant:
#
# $$ A = \begin{bmatrix} a & b \\ c & d \end{bmatrix} $$
#
# $$ A^{-1} = \frac{1}{\det(A)} (\operatorname{com}(A))^T $$
#
# $$ \operatorname{com}(A) = \begin{bmatrix} d & -c \\ -b & a \end{bmatrix} $$
#
# The slide prints the transposed matrix, the *adjugate*, under the name of the comatrice. Transpose that once more and
# your inverse is wrong.
#
# > **Erratum** (slide "Pour déterminer la cinématique inverse", as printed)
# >
# > $$ \operatorname{com}(A) = \begin{bmatrix} d & -b \\ -c & a \end{bmatrix} $$
#
# ## The polar arm
#
# A revolute joint $\theta$ carries a slide $r$; the gripper is at $X = r\cos\theta$, $Y = r\sin\theta$. Differentiate,
# take $\dot r$ before $\dot\theta$ as the document does, and invert.


# %%
def polar_inverse(theta, r):
    """Return the 2×2 inverse of J_L: [dr, dtheta] from [dX, dY]."""
    ### BEGIN SOLUTION
    s, c = np.sin(theta), np.cos(theta)
    return np.array([[r * c, r * s], [-s, c]]) / r
    ### END SOLUTION


lesson.polar_inverse.check(polar_inverse)

# %% [markdown]
# The document states this inverse with no condition. Find out what it asks near the axis: the gripper is 0.06 m from
# it and moves across the arm at 0.15 m/s. How fast does the joint turn (rad/s)?

# %%
### BEGIN SOLUTION
rate = 0.15 / 0.06
### END SOLUTION
lesson.polar_rate.check(rate)

# %% [markdown]
# ## The planar 2R arm
#
# $$ J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix} $$
#
# Take its determinant first; simplify until one sine is left. Letters are $\theta_1, \theta_2, l_1, l_2$.

# %%
### BEGIN SOLUTION
determinant = r"l_1 l_2 \sin\theta_2"
### END SOLUTION
lesson.determinant.check(determinant)

# %% [markdown]
# Its absolute value, drawn over $\theta_2$ within the limits of the joint, is the *manipulability* (*manipulabilité*) of the arm: the nearer to zero, the faster the joints must turn.

# %%
draw_kind(find_kind("manipulability"), load_arm("planar_2r"))

# %% [markdown]
# Then the adjugate of $J$, $2 \times 2$, all that is left to write for the inverse.

# %%
### BEGIN SOLUTION
adjugate = r"""\begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\
    -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}"""
### END SOLUTION
lesson.adjugate.check(adjugate)

# %% [markdown]
# Put both together: the joint rates for the velocity $(u, v)$ of the gripper.


# %%
def rates(theta_1, theta_2, l_1, l_2, u, v):
    """Return [dtheta_1, dtheta_2] (rad/s) for the velocity (u, v) of the gripper (m/s)."""
    ### BEGIN SOLUTION
    c1, s1 = np.cos(theta_1), np.sin(theta_1)
    c12, s12 = np.cos(theta_1 + theta_2), np.sin(theta_1 + theta_2)
    rate_1 = (u * c12 + v * s12) / (l_1 * np.sin(theta_2))
    rate_2 = -(u * (l_1 * c1 + l_2 * c12) + v * (l_1 * s1 + l_2 * s12)) / (l_1 * l_2 * np.sin(theta_2))
    return np.array([rate_1, rate_2])
    ### END SOLUTION


lesson.rates.check(rates)

# %% [markdown]
# Your rates over Drake's (grey), for 0.1 m/s along the first link, as the elbow straightens. The dotted line is
# explained below.

# %%
show_rates(rates)

# %% [markdown]
# At $\theta_2 = 0$ the inverse does not exist, and the velocity along the links is lost:
#
# $$ \operatorname{rank} J = 1 \iff \theta_2 = k\pi $$
#
# $$ \left. \begin{bmatrix} C_1 & S_1 \end{bmatrix} J \right|_{\theta_2 = 0} = \begin{bmatrix} 0 & 0 \end{bmatrix} $$
#
# A velocity that is possible, but close to the lost one, asks for rates that no drive gives.
#
# ## Jacobians that are not square
#
# The document has one formula for them all. Here is a tall Jacobian (more velocities than joints), for which it fails:
#
# $$ J_t = \begin{bmatrix} g_1 & h_1 \\ g_2 & h_2 \\ g_3 & h_3 \end{bmatrix} $$
#
# $$ \det(J_t J_t^T) = 0 $$
#
# > **Erratum** (slide "Modèle cinématique inverse": printed for every $J$ that is not square, and as $J^{-1}$)
# >
# > $$ J_t^{-1} = J_t^T [J_t J_t^T]^{-1} $$
#
# $J^T (J J^T)^{-1}$ is a right inverse, $(J^T J)^{-1} J^T$ a left one. Which exist, for a wide $J$ ($2 \times 3$) and
# for a tall one ($3 \times 2$), of full rank? Write a list of two: `"right_wide"` or `"left_wide"`, and `"right_tall"`
# or `"left_tall"`.

# %%
### BEGIN SOLUTION
forms = ["right_wide", "left_tall"]
### END SOLUTION
lesson.forms.check(forms)

# %% [markdown]
# Ask the polar arm for the rate of its angle too. Its Jacobian grows a third row, $[0, 1]$. Write the pseudo-inverse.


# %%
def left_inverse(theta, r):
    """Return the 2×3 pseudo-inverse of the polar arm's 3×2 Jacobian."""
    ### BEGIN SOLUTION
    s, c = np.sin(theta), np.cos(theta)
    J = np.array([[c, -r * s], [s, r * c], [0, 1]])
    return np.linalg.inv(J.T @ J) @ J.T
    ### END SOLUTION


lesson.left_inverse.check(left_inverse)

# %% [markdown]
# ## Damping
#
# Damped least squares (*moindres carrés amortis*) trades an error in the velocity against the size of the rates. Both
# forms below are the same, and with $\lambda > 0$ they exist in every configuration:
#
# $$ J^T \left( J J^T + \lambda^2 I \right)^{-1} = \left( J^T J + \lambda^2 I \right)^{-1} J^T $$
#
# See what it does with one joint, $v = \sigma\dot q$: minimise $(\sigma\dot q - v)^2 + \lambda^2\dot q^2$ and give the
# gain $\dot q / v$.

# %%
### BEGIN SOLUTION
gain = r"\frac{\sigma}{\sigma^2 + \lambda^2}"
### END SOLUTION
lesson.gain.check(gain)

# %% [markdown]
# Every singular value $\sigma$ of $J$ gets this gain. Write the largest value that it can have, in $\lambda$.

# %%
### BEGIN SOLUTION
bound = r"\frac{1}{2\lambda}"
### END SOLUTION
lesson.bound.check(bound)

# %% [markdown]
# ## The limit
#
# With damping, what do the rates for a velocity along the links do as $\theta_2$ goes to 0? They become `"infinite"`,
# stay `"bounded"` at their largest, grow and `"jump"` to zero, or go back to `"zero"` smoothly. Compute before you
# look at the dotted line above.

# %%
### BEGIN SOLUTION
behaviour = "zero"
### END SOLUTION
lesson.limit.check(behaviour)

# %% [markdown]
# ## An arm that you have not seen
#
# A carriage slides by $d$ along $x_0$; a bar of length $b$ turns on it by $\theta$. Its end, at $[d + b\cos\theta,\ b\sin\theta]^T$, is to move with
# $\dot X = u$, $\dot Y = v$. Give $[\dot d, \dot\theta]^T$, and see where it has no value.


# %%
def carriage(theta, b, u, v):
    """Return the rates of the carriage (m/s) and of the bar (rad/s)."""
    ### BEGIN SOLUTION
    return [u + v * np.tan(theta), v / (b * np.cos(theta))]
    ### END SOLUTION


lesson.transfer.check(carriage)

# %% [markdown]
# ## Once more
#
# A task of lesson 10 comes back. Do it without looking.

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
# - A square Jacobian is inverted by its adjugate and its determinant; the determinant says where that ends.
# - A wide one has a right inverse, a tall one a left inverse.
# - Near a singular configuration rates grow without bound; damping bounds them, and costs accuracy everywhere.
#
# ## Further
#
# - `course/handouts/inverse-velocity.md`: damped least squares, with the error it costs everywhere.
# - `course/handouts/planar-3r-pseudo-inverse.md`: a wide Jacobian, and the joint motions that leave the gripper where
#   it is.
# - `armproof.models.motion.inverse_velocity` computes all of these from singular values, for one Jacobian or a million.
