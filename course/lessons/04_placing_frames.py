# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Placing frames in eight steps"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# symbols:
#   a: free
#   alpha: free
#   s: free
#   t: free
#   sigma: free
#   theta: free
#   d: free
# ---

# %% [markdown]
# # 4 · Placing frames in eight steps
#
# In lesson 3 the frames of the crane were given. Here you place those of an arm that you have not seen, step by step, in the modified
# convention.
# Source: MECA 953, *Robotique*, MMT5, 2022 (document 001), slides "Algorithme de paramétrage".

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.course.tasks.placing_frames import RIG

lesson = open_lesson("placing_frames")
lesson

# %% [markdown]
# ## The drill rig
#
# A column turns about a vertical axis ($\theta_1$). At the shoulder a boom of length $a_2$ is hinged; the hinge is horizontal and crosses the
# column's axis ($\theta_2$, zero where the boom is horizontal). At its end is the elbow, a second hinge parallel to the first ($\theta_3$). The
# elbow carries a ram, which slides by $d_4$ in a direction across the hinge and passes it at the distance $e$; at $\theta_2 = \theta_3 = 0$ it
# points down. Draw it, from the side and from above, before you go on.
#
# ## Steps 1 and 2: count, and lay the z axes
#
# Number the links from 0, the joints from 1, and lay $z_i$ along the axis of joint $i$. How many links, joints and rows?

# %%
### BEGIN SOLUTION
counted = [5, 4, 4]
### END SOLUTION
lesson.numbers.check(counted)

# %% [markdown]
# ## Step 3: the common normal
#
# Two successive axes intersect, are parallel, or are **skew** (*non coplanaires*). Which statements are true?
# `a`: axes 1 and 2 intersect; `b`: axes 1 and 2 are skew; `c`: axes 2 and 3 are parallel; `d`: axes 2 and 3 intersect;
# `e`: axes 3 and 4 are skew; `f`: axes 3 and 4 intersect.

# %%
### BEGIN SOLUTION
cases = ["a", "c", "e"]
### END SOLUTION
lesson.cases.check(cases)

# %% [markdown]
# The three cases side by side. Where $O_{i-1}$ and $x_{i-1}$ are yours to choose is what steps 3 and 4 are about.

# %%
draw_kind(find_kind("axes"), load_arm("planar_2r"))

# %% [markdown]
# The common normal (*normale commune*) of two lines carries the shortest segment between them. Let axis $i$ be the $z$ axis, and let axis
# $i+1$ go through $[a, 0, 0]^T$ with the direction $[0, -S\alpha, C\alpha]^T$. Write the square of the distance between the point at $s$ on the
# first axis and the point at $t$ on the second.


# %%
def squared_distance(s, t, a, alpha):
    """Return the square of the distance (m²)."""
    ### BEGIN SOLUTION
    return a**2 + (t * np.sin(alpha)) ** 2 + (s - t * np.cos(alpha)) ** 2
    ### END SOLUTION


lesson.distance.check(squared_distance)

# %% [markdown]
# Written as two squares more than $a^2$, it is smallest at $s = t = 0$; nothing else does for skew axes:
#
# $$ a^2 + s^2 + t^2 - 2 s t \cos\alpha = a^2 + (s - t\cos\alpha)^2 + t^2 \sin^2\alpha $$
#
# For parallel axes $\sin\alpha = 0$, and every pair with $s = t\cos\alpha$ is as good: the origin is free.
#
# ### Task: the origin
#
# Axis 1 is the $z$ axis; axis 2 goes through $[0.3, 0.4, 1]^T$, parallel to $y$ (metres). Give $O_1$ and the length of the normal, as
# `[x, y, z, a_1]`.

# %%
### BEGIN SOLUTION
origin_and_length = [0, 0, 1, 0.3]
### END SOLUTION
lesson.normal.check(origin_and_length)

# %% [markdown]
# ### Task: what parallel axes leave free
#
# $O_2$ moves by $u$ along $z_2$, parallel to $z_3$. Write the new $d_2$ and the new $d_3$.

# %%
### BEGIN SOLUTION
offsets = r"\begin{bmatrix} d_2 + u \\ d_3 - u \end{bmatrix}"
### END SOLUTION
lesson.freedom.check(offsets)

# %% [markdown]
# ### Task: what a slide leaves free
#
# What of the ram's axis may you choose without any change of the motion: `place`, `direction`, `twist` or `variable`? (We keep the ram's
# own line, and so the distance $e$.)

# %%
### BEGIN SOLUTION
free = "place"
### END SOLUTION
lesson.slide_freedom.check(free)

# %% [markdown]
# ## Step 4: the x axes
#
# Compare your drawing with these frames.

# %%
sketch(load_arm(RIG), table=False)

# %% [markdown]
# Intersecting axes: $x_1$ is at right angles to both, in a sense that you choose. With $z_1 = [0, 0, 1]^T$ and $z_2 = [S_1, -C_1, 0]^T$, write
# $x_1 = z_1 \times z_2$.


# %%
def x_1(q):
    """Return x_1 in frame 0, three numbers."""
    ### BEGIN SOLUTION
    return np.cross([0, 0, 1], [np.sin(q[0]), -np.cos(q[0]), 0])
    ### END SOLUTION


lesson.first_x.check(x_1)

# %% [markdown]
# Parallel axes: $x_2$ lies along the normal, from $O_2$ to $O_3$. Write it in frame 0.

# %%
### BEGIN SOLUTION
x_2 = r"\begin{bmatrix} C_1 C_2 \\ S_1 C_2 \\ S_2 \end{bmatrix}"
### END SOLUTION
lesson.second_x.check(x_2)

# %% [markdown]
# ## Step 5: the y axes
#
# Write $y_2 = z_2 \times x_2$ in frame 0.

# %%
### BEGIN SOLUTION
y_2 = r"\begin{bmatrix} -C_1 S_2 \\ -S_1 S_2 \\ C_2 \end{bmatrix}"
### END SOLUTION
lesson.second_y.check(y_2)

# %% [markdown]
# ## Steps 6 and 7: both ends
#
# Frame 0 is put on frame 1 at $q_1 = 0$. Which of `alpha_0`, `a_0`, `d_1`, `theta_1` are zero then, always?

# %%
### BEGIN SOLUTION
zero = ["alpha_0", "a_0", "d_1"]
### END SOLUTION
lesson.base.check(zero)

# %% [markdown]
# Behind the last joint there is no further axis. How is $x_4$ chosen? `a`: along $x_3$, so that $\theta_4 = 0$; `b`: along $z_3$, so that
# $\alpha_3 = 0$; `c`: along the ram, so that $d_4 = 0$; `d`: along $x_0$, so that the tool is level.

# %%
### BEGIN SOLUTION
last_x = "a"
### END SOLUTION
lesson.last.check(last_x)

# %% [markdown]
# ## Step 8: types, variables, table
#
# Give $[\sigma_1, \sigma_2, \sigma_3, \sigma_4]$, 0 for a revolute joint (*rotoïde*) and 1 for a prismatic one.

# %%
### BEGIN SOLUTION
types = [0, 0, 0, 1]
### END SOLUTION
lesson.types.check(types)

# %% [markdown]
# Write the joint variable $q_i$ of both types in one formula, linear in $\sigma$.

# %%
### BEGIN SOLUTION
q_i = r"(1 - \sigma)\theta + \sigma d"
### END SOLUTION
lesson.variable.check(q_i)

# %% [markdown]
# Now fill in the table: four rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$.

# %%
### BEGIN SOLUTION
table = [
    (0, 0, 0, "theta_1"),
    ("pi/2", 0, 0, "theta_2"),
    (0, "a_2", 0, "theta_3"),
    ("pi/2", "e", "d_4", 0),
]
### END SOLUTION
lesson.table.check(table)

# %% [markdown]
# ## The test
#
# Where is the tool? Write the origin of frame 4 in frame 0 from your drawing, without the table: if both agree, both are right.


# %%
def tool(q, a_2, e):
    """Return the origin of frame 4 in frame 0, three numbers in metres."""
    ### BEGIN SOLUTION
    theta_1, theta_2, theta_3, d_4 = q
    both = theta_2 + theta_3
    radius = a_2 * np.cos(theta_2) + e * np.cos(both) + d_4 * np.sin(both)
    height = a_2 * np.sin(theta_2) + e * np.sin(both) - d_4 * np.cos(both)
    return [radius * np.cos(theta_1), radius * np.sin(theta_1), height]
    ### END SOLUTION


lesson.tool.check(tool)

# %%
lesson.tool.show(tool, theta_1=0.4, theta_2=0.5, theta_3=-0.3, d_4=0.3)

# %% [markdown]
# ## An arm that you have not seen
#
# A stacker. A carriage slides along a vertical mast, $z_1$ up, by $d_1$. On it a boom of length $c$ pitches by $\theta_2$ about a horizontal axis
# that meets the mast, $z_2 = -y_1$. At the end of the boom a fork pitches by $\theta_3$ about the parallel axis $z_3$. Choose $x_1$ horizontal and
# $x_2$ along the boom; at zero all $x$ axes are parallel. Write the table.

# %%
### BEGIN SOLUTION
stacker = [(0, 0, "d_1", 0), ("pi/2", 0, 0, "theta_2"), (0, "c", 0, "theta_3")]
### END SOLUTION
lesson.transfer.check(stacker)

# %% [markdown]
# ## Once more
#
# A task of lesson 1 comes back. Do it without looking.

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
# - Skew axes fix origin and x axis; intersecting axes leave the sense of x; parallel axes and slides leave the origin.
# - Every choice is right if the table follows it. Good choices make zeros.
# - A table is tested by its product: compare one point with your drawing.
#
# Lesson 17 reads the other half of a pose, the orientation of the tool. Sheet `dh-modified-001.md` has the definitions as equations.
