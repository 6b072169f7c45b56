# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Proofread a handout"
# source: A sheet of our own; the first example is from Université de Constantine 1 (document 002)
# arm: planar_3r
# quantities:
#   "J": {jacobian: 3, rows: [1, 2]}
# ---

# %% [markdown]
# # 16 · Proofread a handout
#
# Formulas that were derived by hand have slips, printed ones too. In this lesson you
#
# 1. find wrong formulas on a sheet by hand, with checks that take seconds,
# 2. say which errors a check at one pose, or with equal links, cannot see,
# 3. run `armproof` on the sheet, then on one of your own, and learn what it does not judge.
#
# `lesson.spot` shows a task in full,
# `lesson.spot.hint()` gives a hint, one more at each call.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.course.tasks.proofread import proofread, show_sheet

lesson = open_lesson("proofread")
lesson

# %% [markdown]
# ## A slip in print
#
# Document 002 prints the Jacobian of the planar 3R arm on two slides with the same wrong sign. Here are the rows of
# the position:
#
# > **Erratum** (slides "Le Jacobien obtenu est le suivant" and "La matrice Jacobéenne devient", as printed, first two
# > rows)
# >
# > $$ J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} - l_3 S_{123} & l_2 S_{12} - l_3 S_{123} & -l_3 S_{123} \\ l_1 C_1 + l_2 C_{12} + l_3 C_{123} & l_2 C_{12} + l_3 C_{123} & l_3 C_{123} \end{bmatrix} $$
#
# At the zero pose this matrix is exactly right, because every sine is 0 there:
#
# $$
# \left. J \right|_{\theta_1 = 0,\, \theta_2 = 0,\, \theta_3 = 0} = \begin{bmatrix} 0 & 0 & 0 \\
# l_1 + l_2 + l_3 & l_2 + l_3 & l_3 \end{bmatrix}
# $$
#
# Predict without computing: which entry is wrong? Compare the signs along a row. Write its row and its column, counted
# from 1.

# %%
### BEGIN SOLUTION
place = [1, 2]
### END SOLUTION
lesson.spot.check(place)

# %% [markdown]
# ## The sheet
#
# A colleague has typed a sheet on the planar 2R arm. Its front matter says which arm it is about, and what its names
# mean.

# %%
draw_kind(find_kind("sketch"), load_arm("planar_2r"))

# %%
sheet = r"""---
title: The planar 2R arm
arm: planar_2r
quantities:
  X: {origin: 2, component: x}
  Y: {origin: 2, component: y}
  J: {jacobian: 2, rows: [1, 2]}
  x_2: {axis: 2, along: x}
---

# The planar 2R arm

In frame 0 the gripper is at

$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} \tag{1} $$

and frame 2 stands in frame 1 as

$$
{}^1T_2 = \begin{bmatrix} C_2 & S_2 & 0 & l_2 C_2 \\ -S_2 & C_2 & 0 & l_2 S_2 \\
0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} \tag{2}
$$

Its distance from the first axis follows from

$$ X^2 + Y^2 = l_1^2 + l_2^2 + l_1 l_2 C_2 \tag{3} $$

and its velocity from the Jacobian

$$
J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & l_2 S_{12} \\
l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix} \tag{4}
$$

with the determinant

$$ \det J = l_1 l_2 S_2 \tag{5} $$

and the inverse

$$
J^{-1} = \frac{1}{l_1 l_2 S_2} \begin{bmatrix} l_1 C_{12} & l_1 S_{12} \\
-l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix} \tag{6}
$$

The arm is singular under one condition:

$$ \det J = 0 \iff \theta_2 = 0 \text{ or } \theta_2 = \pi \tag{7} $$

In frame 0 the last link points along

$$ x_2 = \begin{bmatrix} C_2 \\ S_2 \\ 0 \end{bmatrix} \tag{8} $$
"""
show_sheet(sheet)

# %% [markdown]
# ## By hand first
#
# Four checks that take seconds:
#
# - **A special pose.** Put in 90°, draw the arm, read the axes off the drawing.
# - **A limit.** Stretched, the arm must reach $l_1 + l_2$.
# - **A derivative.** A Jacobian (*jacobien*) is the derivative of a position that you trust.
# - **Units.** Each entry of a matrix has its own unit; a sum of unlike units is wrong.
#
# Which displays are wrong? Write a list of their numbers, such as `["1", "5"]`.

# %%
### BEGIN SOLUTION
found = ["2", "3", "4", "6", "8"]
### END SOLUTION
lesson.wrong_displays.check(found)

# %% [markdown]
# Which of them hold at the zero pose, $\theta_1 = \theta_2 = 0$, so that a check there finds nothing? Write a list.

# %%
### BEGIN SOLUTION
hidden = ["2", "4", "8"]
### END SOLUTION
lesson.zero_pose.check(hidden)

# %% [markdown]
# A random pose finds more. But the error in which display stays hidden if both links are given the same length? Write its
# number, such as `"1"`.

# %%
### BEGIN SOLUTION
still_hidden = "6"
### END SOLUTION
lesson.equal_links.check(still_hidden)

# %% [markdown]
# ## Correct it
#
# Correct the wrong displays before the tool does it for you. Start with (4), the derivative of (1).


# %%
def jacobian(q, l_1, l_2):
    """Return the right 2×2 Jacobian of display (4)."""
    ### BEGIN SOLUTION
    s1, c1 = np.sin(q[0]), np.cos(q[0])
    s12, c12 = np.sin(q[0] + q[1]), np.cos(q[0] + q[1])
    return np.array([[-l_1 * s1 - l_2 * s12, -l_2 * s12], [l_1 * c1 + l_2 * c12, l_2 * c12]])
    ### END SOLUTION


lesson.jacobian.check(jacobian)

# %% [markdown]
# The velocity that your Jacobian gives the gripper, over Drake's arm:

# %%
lesson.jacobian.show(jacobian, theta_1=0.4, theta_2=1.1)

# %% [markdown]
# Then the transform (2), the distance (3) and the inverse (6); for (8) a pencil will do.

# %%
### BEGIN SOLUTION
transform = r"""\begin{bmatrix} C_2 & -S_2 & 0 & l_2 C_2 \\ S_2 & C_2 & 0 & l_2 S_2 \\
    0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
### END SOLUTION
lesson.transform.check(transform)

# %%
### BEGIN SOLUTION
distance = r"l_1^2 + l_2^2 + 2 l_1 l_2 C_2"
### END SOLUTION
lesson.distance.check(distance)

# %%
### BEGIN SOLUTION
inverse = r"""\frac{1}{l_1 l_2 S_2} \begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\
    -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}"""
### END SOLUTION
lesson.inverse.check(inverse)

# %% [markdown]
# ## Then the tool
#
# `proofread` writes the sheet to a temporary file and has it verified. In a terminal you would type
# `armproof verify sheet.md`; in Python, `verify("sheet.md")` with `from armproof import verify`. It proves or refutes
# each display for all joint values and all lengths, so that neither a lucky pose nor equal links can
# hide an error. Are its corrections yours?

# %%
proofread(sheet, after=found)

# %% [markdown]
# ## A sheet of your own
#
# Replace the sheet below by yours: any arm of `models/`, or one given by its DH table (*table de Denavit–Hartenberg*)
# as here. Spoil a sign, and see whether it is found.

# %%
own_sheet = r"""---
title: A slide on a turntable
arm:
  dh: classic
  rows:
    - {a: 0, alpha: -pi/2, d: h, theta: theta_1}
    - {a: 0, alpha: 0, d: d_2, theta: 0}
---

$$ p_2 = \begin{bmatrix} -d_2 S_1 \\ d_2 C_1 \\ h \end{bmatrix} $$
"""
proofread(own_sheet)

# %% [markdown]
# ## The limits of the tool
#
# A display that only introduces a name is *defined*: there is nothing to compare it with. Which errors can the tool
# not find? Write a list of: `"lengths"` (two lengths exchanged), `"prose"` (a false sentence), `"name"` (a new name
# with another value than meant), `"sign"` (a sign wrong at few angles only), `"picture"` (a figure with a wrong axis).

# %%
### BEGIN SOLUTION
not_judged = ["prose", "name", "picture"]
### END SOLUTION
lesson.blind.check(not_judged)

# %% [markdown]
# ## An arm that you have not seen
#
# A carriage slides by $d$, on it a bar of length $b$ turns by $\theta$. Which displays of its sheet are wrong?

# %%
lesson.transfer

# %%
### BEGIN SOLUTION
carriage = ["3", "4"]
### END SOLUTION
lesson.transfer.check(carriage)

# %% [markdown]
# ## Once more
#
# A task of lesson 13 comes back. Do it without looking.

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
# - A simple configuration finds many errors, and misses those that vanish there; a generic one with different lengths finds them.
# - What a display says can be tested by another: a derivative, a product with the inverse, a determinant.
# - A proof covers formulas. Prose, new names and pictures stay yours.
#
# ## Further
#
# - `armproof correct sheet.md --diff` proposes the corrected terms; `armproof verify sheet.md --watch` checks at every
#   save.
# - The README lists the formats (Markdown, LaTeX, notebooks) and what the front matter can say.
# - `course/handouts/` keeps every error that was found in four real documents, each below the right formula.
