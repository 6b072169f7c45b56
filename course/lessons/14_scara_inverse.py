# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "SCARA: inverse kinematics in two postures"
# source: A. Beneult Lefaucheux, TD 1, Étude du robot Scara, 2014 (document 004)
# arm: scara_column
# transforms: lower
# quantities:
#   "H_1": {pose: 1, in: 0}
#   "H_2": {pose: 2, in: 1}
#   "H_3": {pose: 3, in: 2}
#   "H_4": {pose: 4, in: 3}
#   "MGDori": {rotation: 4}
#   "X": {origin: 4, component: x}
#   "Y": {origin: 4, component: y}
# ---

# %% [markdown]
# # 14 · SCARA: inverse kinematics in two postures
#
# The forward kinematics (*modèle géométrique direct*, MGD) goes from joint values to the tool. Here you go back
# (*modèle géométrique inverse*, MGI). The arm is the SCARA of document 004 on a column of height $d_1$. In this lesson
# you
#
# 1. solve the position equations for the four joints, one joint at a time,
# 2. count the solutions of a target from one sign,
# 3. say what happens at the limits of the workspace, and above the first axis.
#
# An answer may be a Python function, a SymPy expression or LaTeX.
# `lesson.predict` shows the task in full,
# `lesson.predict.hint()` gives a hint, one more at each call.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.course.tasks.scara_inverse import show_inverse

lesson = open_lesson("scara_inverse")
lesson

# %% [markdown]
# Look at the axes first: $z_2$, $z_3$ and $z_4$ point down.

# %%
draw_kind(find_kind("sketch"), load_arm("scara_column"))

# %% [markdown]
# ## Predict: how many postures?
#
# The tool covers a ring about the first axis. Before any formula: how many pairs $(\theta_1, \theta_2)$ reach a target
# inside the ring, on its outer circle, and beyond that? The elbow is on two circles, one about the first axis, one about
# the target: draw them for each case. Write the three numbers.

# %%
### BEGIN SOLUTION
postures = [2, 1, 0]
### END SOLUTION
lesson.predict.check(postures)

# %% [markdown]
# The circles for a target inside the ring, seen from above. They meet twice: elbow up and elbow down. Where they only touch, the two postures are one.

# %%
draw_kind(find_kind("elbow"), load_arm("scara_column"))

# %% [markdown]
# ## The equations
#
# The document (section 1) multiplies four link transforms (*matrices de passage*); the lower index names the reference
# frame.
#
# $$ H_0^4 = H_1 H_2 H_3 H_4 $$
#
# $$
# H_1 = \begin{bmatrix} \cos\theta_1 & -\sin\theta_1 & 0 & a_1\cos\theta_1 \\
# \sin\theta_1 & \cos\theta_1 & 0 & a_1\sin\theta_1 \\ 0 & 0 & 1 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}, \qquad
# H_2 = \begin{bmatrix} \cos\theta_2 & \sin\theta_2 & 0 & a_2\cos\theta_2 \\
# \sin\theta_2 & -\cos\theta_2 & 0 & a_2\sin\theta_2 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}
# $$
#
# $$
# H_3 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}, \qquad
# H_4 = \begin{bmatrix} \cos\theta_4 & -\sin\theta_4 & 0 & 0 \\ \sin\theta_4 & \cos\theta_4 & 0 & 0 \\
# 0 & 0 & 1 & d_4 \\ 0 & 0 & 0 & 1 \end{bmatrix}
# $$
#
# Write the position of the tool, the right sides of the three equations that you are about to solve.


# %%
def position(q, a_1, a_2, d_1, d_4):
    """Return [X, Y, Z] of frame 4 in frame 0 (m); q holds theta_1, theta_2, d_3, theta_4."""
    ### BEGIN SOLUTION
    theta_1, theta_2, d_3, _ = q
    X = a_1 * np.cos(theta_1) + a_2 * np.cos(theta_1 + theta_2)
    Y = a_1 * np.sin(theta_1) + a_2 * np.sin(theta_1 + theta_2)
    return np.array([X, Y, d_1 - d_3 - d_4])
    ### END SOLUTION


lesson.position.check(position)

# %% [markdown]
# Your tool point over Drake's arm:

# %%
lesson.position.show(position, theta_1=0.6, theta_2=0.9, d_3=0.15)

# %% [markdown]
# ## One joint at a time
#
# Start with the equation that holds a single unknown. Write $d_3$ in $Z$, $d_1$ and $d_4$.

# %%
### BEGIN SOLUTION
d_3 = r"d_1 - d_4 - Z"
### END SOLUTION
lesson.slide.check(d_3)

# %% [markdown]
# Next the elbow. Find a combination of $X$ and $Y$ that does not change when the whole arm turns about the first axis,
# and write $\cos\theta_2$ in $X$, $Y$, $a_1$ and $a_2$.


# %%
def cos_theta_2(X, Y, a_1, a_2):
    """Return cos(theta_2)."""
    ### BEGIN SOLUTION
    return (X**2 + Y**2 - a_1**2 - a_2**2) / (2 * a_1 * a_2)
    ### END SOLUTION


lesson.elbow.check(cos_theta_2)

# %% [markdown]
# ## How many solutions
#
# The document answers "does this model have a unique solution?" with *two*, because of the sign of the arccos, and
# states no condition there. On the outer circle the two angles are one:
#
# > **Erratum** (document 004, section 2.1, in words: "two solutions", without a condition. As an equation: the two
# > angles differ on the outer limit too)
# >
# > $$ \left. \arccos\left(\frac{X^2+Y^2-a_1^2-a_2^2}{2a_1a_2}\right) \right|_{\theta_2 = 0} \neq \left. -\arccos\left(\frac{X^2+Y^2-a_1^2-a_2^2}{2a_1a_2}\right) \right|_{\theta_2 = 0} $$
#
# Write $4 a_1^2 a_2^2 \sin^2\theta_2$ as a polynomial in $X$, $Y$, $a_1$, $a_2$: its sign counts the postures. In
# factors it shows both limits of the workspace at a glance.

# %%
### BEGIN SOLUTION
room = r"\left((a_1 + a_2)^2 - X^2 - Y^2\right) \left(X^2 + Y^2 - (a_1 - a_2)^2\right)"
### END SOLUTION
lesson.reach.check(room)

# %% [markdown]
# ## The shoulder
#
# With $\theta_2$ known, collect what stands beside $\cos\theta_1$ and $\sin\theta_1$ (section 2 of the document):
#
# $$ k_1 = a_1 + a_2\cos\theta_2, \qquad k_2 = a_2\sin\theta_2 $$
#
# $$ X = k_1 \cos\theta_1 - k_2 \sin\theta_1 $$
#
# $$ Y = k_2 \cos\theta_1 + k_1 \sin\theta_1 $$
#
# So $(X, Y)$ is the vector $(k_1, k_2)$ turned by $\theta_1$, and both have the same length:
#
# $$ k_1^2 + k_2^2 = X^2 + Y^2 $$
#
# Write $\theta_1$ in $X$, $Y$, $k_1$, $k_2$. Mind the quadrants.


# %%
def theta_1_of(X, Y, k_1, k_2):
    """Return theta_1 (rad)."""
    ### BEGIN SOLUTION
    return np.arctan2(Y, X) - np.arctan2(k_2, k_1)
    ### END SOLUTION


lesson.shoulder.check(theta_1_of)

# %% [markdown]
# ## The wrist
#
# The tool's angle about the vertical is $\psi$:
#
# $$ \psi = \theta_1 + \theta_2 - \theta_4 $$
#
# $$ MGDori = \begin{bmatrix} \cos\psi & \sin\psi & 0 \\ \sin\psi & -\cos\psi & 0 \\ 0 & 0 & -1 \end{bmatrix} $$
#
# > **Erratum** (document 004, section 2, as printed: the brace marked $\psi$ covers the cosine, not its angle)
# >
# > $$ MGDori = \begin{bmatrix} \overbrace{\cos(\theta_1 + \theta_2 - \theta_4)}^{\psi} & \sin(\theta_1 + \theta_2 - \theta_4) & 0 \\ \sin(\theta_1 + \theta_2 - \theta_4) & -\cos(\theta_1 + \theta_2 - \theta_4) & 0 \\ 0 & 0 & -1 \end{bmatrix} $$
#
# Write $\theta_4$ in $\theta_1$, $\theta_2$ and $\psi$.

# %%
### BEGIN SOLUTION
theta_4 = r"\theta_1 + \theta_2 - \psi"
### END SOLUTION
lesson.wrist.check(theta_4)

# %% [markdown]
# ## All of it
#
# Put the four joints together, for the posture with $0 \le \theta_2 \le \pi$.


# %%
def inverse(X, Y, Z, psi, a_1, a_2, d_1, d_4):
    """Return [theta_1, theta_2, d_3, theta_4] (rad, m)."""
    ### BEGIN SOLUTION
    theta_2 = np.arccos((X**2 + Y**2 - a_1**2 - a_2**2) / (2 * a_1 * a_2))
    theta_1 = np.arctan2(Y, X) - np.arctan2(a_2 * np.sin(theta_2), a_1 + a_2 * np.cos(theta_2))
    return np.array([theta_1, theta_2, d_1 - d_4 - Z, theta_1 + theta_2 - psi])
    ### END SOLUTION


lesson.inverse.check(inverse)

# %% [markdown]
# Your posture over both of Drake's (grey), from above, with $a_1 = 0.4$ m and $a_2 = 0.3$ m. Move the target to the
# outer circle, then beyond it: the grey postures meet, then there are none.

# %%
show_inverse(inverse, X=0.35, Y=0.4, Z=0.25, psi=0.3)

# %% [markdown]
# ## The limits
#
# At both limits the two postures become one, and there the arm is singular:
#
# $$ \operatorname{rank} J = 3 \iff \theta_2 = 0 \text{ or } \theta_2 = \pi $$
#
# Now take links of the same length, and the target $X = Y = 0$. How many postures reach it: `"none"`, `"one"`, `"two"`
# or `"many"` (infinitely many)?

# %%
### BEGIN SOLUTION
number = "many"
### END SOLUTION
lesson.equal_links.check(number)

# %% [markdown]
# ## An arm that you have not seen
#
# The end of a column with a rising carriage and a ram is at $X = -d_3 S_1$, $Y = d_3 C_1$, $Z = d_2$, with $d_3 > 0$. Write $d_3$ in $X$ and $Y$.
# How many postures are there for one end?

# %%
### BEGIN SOLUTION
d_3 = r"\sqrt{X^2 + Y^2}"
### END SOLUTION
lesson.transfer.check(d_3)

# %% [markdown]
# ## Once more
#
# A task of lesson 11 comes back. Do it without looking.

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
# - Square and add: an angle goes, and a length stays.
# - The arctangent of two arguments knows the quadrant; the one of a quotient does not.
# - A square root is two postures; where it is zero, they meet.
#
# ## Further
#
# - `course/handouts/scara-004.md` proves that these two postures are all there are.
# - `inverse_of("scara_column").solve(targets)` from `armproof.course.inverse` returns every posture of many targets at once,
#   with a mark for targets on the edge, out of reach or degenerate.
