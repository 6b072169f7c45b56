# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "A warm-up: frames and table of the planar 2R arm"
# source: After MECA 953 Robotique, MMT5, 2022 (document 001)
# arm: planar_2r
# ---

# %% [markdown]
# # 2 · A warm-up: frames and table of the planar 2R arm
#
# Two bars in a plane, two frames, two rows: the smallest table of Denavit and Hartenberg. Here you place the frames yourself, in the modified
# convention of document 001, before lesson 3 compares it with the classic one.
#
# - $z_i$ lies along the axis of joint $i$.
# - $x_i$ lies along the common normal of $z_i$ and $z_{i+1}$, from the one to the other; the last one is free.
# - $O_i$ is where $x_i$ meets $z_i$. Parallel axes leave it free along $z_i$.
# - Row $i$: turn by $\alpha_{i-1}$ about $x_{i-1}$ and shift by $a_{i-1}$ along it, then turn by $\theta_i$ about $z_i$ and shift by $d_i$ along it.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.drawing.placed import draw_scheme
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.course.tasks.planar_dh import ARM, RAM

lesson = open_lesson("planar_dh")
lesson

# %% [markdown]
# The four parameters of one row, where the axes are neither parallel nor meet: read the modified one, on the right; lesson 3 comes to the other. In a
# plane arm all axes are parallel, and $\alpha_{i-1}$ and $d_i$ are zero.

# %%
draw_kind(find_kind("link"), load_arm("planar_2r"))

# %% [markdown]
# ## The drawing
#
# The axes of the joints have the numbers 1 and 2; you look along them. Frame 0 lies on frame 1 at $\theta_1 = 0$.

# %%
draw_scheme(ARM)

# %% [markdown]
# How do $z_1$ and $z_2$ point?

# %%
### BEGIN SOLUTION
z = ["z", "z"]
### END SOLUTION
lesson.z_axes.check(z)

# %% [markdown]
# Where are $O_1$ and $O_2$?

# %%
### BEGIN SOLUTION
origins = ["A", "B"]
### END SOLUTION
lesson.origins.check(origins)

# %% [markdown]
# How do $x_1$ and $x_2$ point? The answer holds your origins too.

# %%
### BEGIN SOLUTION
x = ["AB", "BC"]
### END SOLUTION
lesson.x_axes.check([origins, x])

# %% [markdown]
# Now the table: two rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$ with `"theta_1"`, `"theta_2"` and `"l_1"`. Where is $l_2$?

# %%
### BEGIN SOLUTION
table = [(0, 0, 0, "theta_1"), (0, "l_1", 0, "theta_2")]
### END SOLUTION
lesson.table.check([z, origins, x, table])

# %%
lesson.table.show([z, origins, x, table])

# %% [markdown]
# ## The tool
#
# The length $l_2$ is in no row: it lies behind the last joint, within frame 2. Where is the tool $C$ in frame 0?


# %%
def tool(q, l_1, l_2):
    """Return the position of the tool in frame 0, three numbers in metres."""
    ### BEGIN SOLUTION
    both = q[0] + q[1]
    return [l_1 * np.cos(q[0]) + l_2 * np.cos(both), l_1 * np.sin(q[0]) + l_2 * np.sin(both), 0]
    ### END SOLUTION


lesson.tool.check(tool)

# %% [markdown]
# Test it where you can see it, stretched along $x$:
#
# $$ \left. p_2 \right|_{\theta_1 = 0,\, \theta_2 = 0} = \begin{bmatrix} l_1 + l_2 \\ 0 \\ 0 \end{bmatrix} $$
#
# ## An arm that you have not seen
#
# A turntable carries a ram. Place both frames and write the table, all at once.

# %%
draw_scheme(RAM)

# %%
### BEGIN SOLUTION
z_ram, origins_ram, x_ram = ["z", "y"], ["A", "A"], ["x", "x"]
table_ram = [(0, 0, 0, "theta_1"), ("-pi/2", 0, "d_2", 0)]
### END SOLUTION
lesson.transfer.check([z_ram, origins_ram, x_ram, table_ram])

# %% [markdown]
# ## What you know now
#
# - A row leads from one frame to the next, and each joint has one.
# - Parallel axes have $\alpha = 0$ and a distance $a$; intersecting axes have $a = 0$ and a twist.
# - What lies behind the last joint is no row: it is a point of the last frame.
