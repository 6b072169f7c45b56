# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "The KUKA KR210: the inverse, wrist apart"
# source: Our own derivation, for the arm of MECA 953 Robotique, MMT5, 2022, table of joint offsets (document 001)
# arm: kr210
# symbols:
#   L: free
# quantities:
#   "p_5": {origin: 5}
#   "p_G": {origin: G}
#   "s": {rotation: G, columns: [1]}
#   "{}^3R_6": {rotation: 6, in: 3}
# ---

# %% [markdown]
# # 19 · The KUKA KR210: the inverse, wrist apart
#
# Lesson 8 read this arm from its table of offsets. Six angles for a pose look like six equations in six unknowns; on an arm with a spherical
# wrist (*poignet sphérique*) they fall into three and three.
#
# ## The wrist's centre
#
# Axes 4, 5 and 6 meet in the origin of frame 5, the wrist's centre (*centre du poignet*), and the gripper stands $d_6 + d_G$ in front of it,
# along its own x axis $s$:
#
# $$ p_G = p_5 + (d_6 + d_G) s $$
#
# $$ \frac{\partial p_5}{\partial \theta_4} = \frac{\partial p_5}{\partial \theta_5} = \frac{\partial p_5}{\partial \theta_6} = 0 $$
#
# So the last three joints do not move the centre: the first three are found from it alone. Write it, given $P$ and $s$.

# %%
import numpy as np

from armproof import load_arm, open_lesson
from armproof.course.figures.kinds.sketch import sketch

lesson = open_lesson("kr210_inverse")
lesson

# %%
sketch(load_arm("kr210"), table=False)


# %%
def centre(P_x, P_y, P_z, s_x, s_y, s_z, d_6, d_G):
    """Return the wrist's centre in frame 0, three numbers."""
    ### BEGIN SOLUTION
    back = d_6 + d_G
    return [P_x - back * s_x, P_y - back * s_y, P_z - back * s_z]
    ### END SOLUTION


lesson.centre.check(centre)

# %% [markdown]
# ## Joint 1
#
# The centre is at $[p_x, p_y, p_z]^T$. Which $\theta_1$ makes the arm face it?

# %%
### BEGIN SOLUTION
theta_1 = r"\text{atan2}(p_y, p_x)"
### END SOLUTION
lesson.waist.check(theta_1)

# %% [markdown]
# ## Into the plane
#
# From here on the arm moves in a vertical plane. The shoulder is $a_1$ in front of axis 1 and $d_1 + d_2$ above the floor. How far out ($x$)
# and how high ($y$) is the centre, seen from the shoulder?


# %%
def from_shoulder(p_x, p_y, p_z, a_1, d_1, d_2):
    """Return x and y of the centre, seen from the shoulder."""
    ### BEGIN SOLUTION
    return [np.sqrt(p_x**2 + p_y**2) - a_1, p_z - d_1 - d_2]
    ### END SOLUTION


lesson.plane.check(from_shoulder)

# %% [markdown]
# At zero the upper arm is upright; the forearm goes $L = d_4 + d_5$ forward and $a_3$ down. Write $x$ and $y$ in the angles.

# %%
### BEGIN SOLUTION
x_and_y = r"\begin{bmatrix} a_2 S_2 + L C_{23} - a_3 S_{23} \\ a_2 C_2 - L S_{23} - a_3 C_{23} \end{bmatrix}"
### END SOLUTION
lesson.two_links.check(x_and_y)

# %% [markdown]
# ## The elbow
#
# As on the planar arm the sum of the squares frees $\theta_3$. Write $K = L\sin\theta_3 + a_3\cos\theta_3$ in $x$, $y$ and the lengths.

# %%
### BEGIN SOLUTION
K = r"\frac{a_2^2 + a_3^2 + L^2 - x^2 - y^2}{2 a_2}"
### END SOLUTION
lesson.elbow.check(K)

# %% [markdown]
# Test it before you go on: in the zero pose the centre is at $[1.85, 0, 1.946]$ m, with $a_1 = 0.35$, $d_1 + d_2 = 0.75$, $a_2 = 1.25$,
# $a_3 = 0.054$, $L = 1.5$ m. Give $x$, $y$, $K$.

# %%
### BEGIN SOLUTION
tested = [1.5, 1.196, 0.054]
### END SOLUTION
lesson.numbers.check(tested)

# %% [markdown]
# The bent forearm is a straight one of another length, seen under another angle: $L S_3 + a_3 C_3 = f \sin(\theta_3 + \beta)$. Write $f$ and
# $\beta$.

# %%
### BEGIN SOLUTION
f_and_beta = r"\begin{bmatrix} \sqrt{L^2 + a_3^2} \\ \text{atan2}(a_3, L) \end{bmatrix}"
### END SOLUTION
lesson.forearm.check(f_and_beta)

# %% [markdown]
# Solve for $\theta_3$, with $\cos(\theta_3 + \beta) \ge 0$. (The other sign is the other elbow.)


# %%
def theta_3(K, f, beta):
    """Return theta_3 (rad)."""
    ### BEGIN SOLUTION
    return np.arctan2(K, np.sqrt(f**2 - K**2)) - beta
    ### END SOLUTION


lesson.elbow_angle.check(theta_3)

# %% [markdown]
# ## Joint 2
#
# With $m = a_2 - L S_3 - a_3 C_3$ and $n = L C_3 - a_3 S_3$ the two equations are $x = m S_2 + n C_2$ and $y = m C_2 - n S_2$. Write
# $\theta_2$.


# %%
def theta_2(x, y, m, n):
    """Return theta_2 (rad)."""
    ### BEGIN SOLUTION
    return np.arctan2(x, y) - np.arctan2(n, m)
    ### END SOLUTION


lesson.shoulder.check(theta_2)

# %% [markdown]
# ## The wrist
#
# Three angles are known, so the forearm's rotation is, and what is left for the wrist:
#
# $$ {}^3R_6 = \begin{bmatrix} C_5 & S_5S_6 & S_5C_6 \\ S_4S_5 & C_4C_6 - S_4C_5S_6 & -C_4S_6 - S_4C_5C_6 \\ -C_4S_5 & S_4C_6 + C_4C_5S_6 & -S_4S_6 + C_4C_5C_6 \end{bmatrix} $$
#
# Write $\theta_4$, $\theta_5$, $\theta_6$ for $S_5 > 0$.

# %%
### BEGIN SOLUTION
wrist = r"\begin{bmatrix} \text{atan2}(r_{21}, -r_{31}) \\ \text{atan2}(\sqrt{r_{21}^2 + r_{31}^2}, r_{11}) \\ \text{atan2}(r_{12}, r_{13}) \end{bmatrix}"
### END SOLUTION
lesson.wrist.check(wrist)

# %% [markdown]
# ## Limits
#
# How many postures are there, joint limits aside and the centre well within reach? (At $S_5 = 0$ there are infinitely many: axes 4 and 6 are
# one line.)

# %%
### BEGIN SOLUTION
postures = 8
### END SOLUTION
lesson.count.check(postures)

# %% [markdown]
# ## An arm that you have not seen
#
# A turret turns by $\theta_1$; at the height $h$ its ram is raised by $\theta_2$ and goes out by $d_3 > 0$. Its end is at
# $[d_3 C_1 C_2,\ d_3 S_1 C_2,\ h + d_3 S_2]^T$. Solve it for a point $[p_x, p_y, p_z]^T$, with $\cos\theta_2 > 0$, in all quadrants.


# %%
def turret(p_x, p_y, p_z, h):
    """Return theta_1, theta_2 (rad) and d_3 (m)."""
    ### BEGIN SOLUTION
    out, up = np.sqrt(p_x**2 + p_y**2), p_z - h
    return [np.arctan2(p_y, p_x), np.arctan2(up, out), np.sqrt(out**2 + up**2)]
    ### END SOLUTION


lesson.transfer.check(turret)

# %% [markdown]
# ## Once more
#
# A task of lesson 16 comes back. Do it without looking.

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
# - A spherical wrist splits six equations into three and three: first the centre, then the wrist.
# - A bent forearm is a straight one of another length: $a_3$ costs one square root and one angle.
# - Each sign that you choose doubles the postures.
#
# Sheets: `kr210-inverse.md` has the whole way, `kr210-table-001.md` the table, `kr210-001.md` the Jacobian and its singular configurations.
