# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Frames of your own"
# source: MECA 953 Robotique, MMT5, 2022 (document 001)
# arm: scara
# ---

# %% [markdown]
# # 5 · Frames of your own
#
# A drawing of an arm, and no frames on it: you choose them. Many choices are right, and every one that keeps the eight steps of the modified
# convention is accepted here. At the end you see your table beside the usual one.
#
# Axes have the numbers of their joints, points have letters, and the directions $x$, $y$, $z$ of the drawing stand in its corner. Frame 0
# lies on frame 1 when its joint is at zero (step 6), so you place the frames from 1 on.

# %%
from armproof import open_lesson
from armproof.course.figures.drawing.placed import draw_scheme
from armproof.course.tasks.own_frames import RX90, SCARA

lesson = open_lesson("own_frames")
lesson

# %% [markdown]
# ## The SCARA
#
# Two arms turn about vertical axes; a quill slides and turns in the third.

# %%
draw_scheme(SCARA)

# %% [markdown]
# Lay $z_1$ to $z_4$ (step 2). Write each as `"x"`, `"-x"`, …, or as three numbers.

# %%
### BEGIN SOLUTION
z = ["z", "z", "-z", "-z"]
### END SOLUTION
lesson.scara_z.check(z)

# %% [markdown]
# Now the origins (step 3): letters of the drawing, or coordinates such as `["a_1", 0, 0.1]`. Which of them are free, and why?

# %%
### BEGIN SOLUTION
origins = ["A", "B", "C", "D"]
### END SOLUTION
lesson.scara_origins.check(origins)

# %% [markdown]
# The x axes (step 4): directions as before, or from point to point, `"AB"`.

# %%
### BEGIN SOLUTION
x = ["AB", "BC", "x", "x"]
### END SOLUTION
lesson.scara_x.check([origins, x])

# %% [markdown]
# Step 8: read the rows $(\alpha_{i-1}, a_{i-1}, d_i, \theta_i)$ off your own frames; angles in radians, as in `"pi/2"`, lengths in letters.

# %%
### BEGIN SOLUTION
table = [(0, 0, 0, "theta_1"), (0, "a_1", 0, "theta_2"), ("pi", "a_2", "d_3", 0), (0, 0, "d_4", "theta_4")]
### END SOLUTION
lesson.scara_table.check([z, origins, x, table])

# %%
lesson.scara_table.show([z, origins, x, table])

# %% [markdown]
# Two tables, one arm: a sense that you turned changes a sign, an origin that you moved puts a length into another row. Whatever your choice,
# the tool is drawn at D:
#
# $$ \left. p_4 \right|_{\theta_1 = 0,\, \theta_2 = 0,\, d_3 = 0} = \begin{bmatrix} a_1 + a_2 \\ 0 \\ -d_4 \end{bmatrix} $$
#
# ## The RX-90
#
# A column, an upper arm, a forearm, and three axes that meet in the wrist. It is drawn with the upper arm along $x$ and the forearm upright.

# %%
draw_scheme(RX90)

# %% [markdown]
# Which successive axes intersect, which are parallel? Then place the six frames, one step after the other.

# %%
### BEGIN SOLUTION
z_rx = ["z", "-y", "-y", "z", "-y", "z"]
### END SOLUTION
lesson.rx90_z.check(z_rx)

# %%
### BEGIN SOLUTION
origins_rx = ["A", "A", "B", "C", "C", "C"]
### END SOLUTION
lesson.rx90_origins.check(origins_rx)

# %%
### BEGIN SOLUTION
x_rx = ["x", "AB", "x", "x", "x", "x"]
### END SOLUTION
lesson.rx90_x.check([origins_rx, x_rx])

# %%
### BEGIN SOLUTION
table_rx = [
    (0, 0, 0, "theta_1"),
    ("pi/2", 0, 0, "theta_2"),
    (0, "a_3", 0, "theta_3"),
    ("-pi/2", 0, "d_3", "theta_4"),
    ("pi/2", 0, 0, "theta_5"),
    ("-pi/2", 0, 0, "theta_6"),
]
### END SOLUTION
lesson.rx90_table.check([z_rx, origins_rx, x_rx, table_rx])

# %% [markdown]
# `lesson.rx90_table.show([z_rx, origins_rx, x_rx, table_rx])` draws your table beside the usual one here too.
#
# ## An arm that you have not seen
#
# A column turns; across it, at the distance $b$, a shoulder turns; it carries a ram, drawn upright. Place all frames at once and write the table.

# %%
draw_scheme(lesson.transfer.asks.scheme)

# %%
### BEGIN SOLUTION
z_ram, origins_ram, x_ram = ["z", "y", "z"], ["A", "B", "B"], ["x", "x", "x"]
table_ram = [(0, 0, 0, "theta_1"), ("-pi/2", 0, "b", "theta_2"), ("pi/2", 0, "d_3", 0)]
### END SOLUTION
lesson.transfer.check([z_ram, origins_ram, x_ram, table_ram])

# %% [markdown]
# ## Once more
#
# A task of lesson 2 comes back. Do it without looking.

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
# - The senses of all $z$ axes are free, and so is that of $x$ between intersecting axes; between parallel and skew axes it leads to the next.
# - Origins are free along parallel axes, and the axis of a slide in its place.
# - The table follows the frames: another choice gives other signs and lengths, and the same arm.
