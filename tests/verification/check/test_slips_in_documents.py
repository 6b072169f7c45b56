"""Slips in documents that show their own arm: each is refuted where its right twin is decided, and the twin never is."""

from __future__ import annotations

import re

import pytest

from armproof.verification.check import verify_text
from armproof.verification.verdict import Record

MARK = re.compile("«([^¦»]*)¦([^»]*)»")
TABLE = """# An arm
| $i$ | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |
|---|---|---|---|---|
| 1 | $\\theta_1$ | $d_1$ | $0$ | $\\pi/2$ |
| 2 | $\\theta_2$ | $0$ | $l_2$ | $0$ |
| 3 | $\\theta_3$ | $0$ | $l_3$ | $0$ |

"""
PLANAR = "$$ x = l_1 c_1 + l_2 c_{12} $$\n$$ y = l_1 s_1 + l_2 s_{12} $$\n"
LEG = (
    TABLE.replace("$d_1$ | $0$ | $\\pi/2$", "0 | $a_1$ | $-90°$")
    .replace("l_2", "a_2")
    .replace("$0$ | $l_3$", "$d_3$ | $a_3$")
    + r"""$$ p_x = c_1 (a_1 + a_2 c_2 + a_3 c_{23}) - d_3 s_1 $$
$$ p_y = s_1 (a_1 + a_2 c_2 + a_3 c_{23}) + d_3 c_1 $$
In the plane of the leg
$$ R = \sqrt{p_x^2 + p_y^2 - d_3^2} - a_1 $$
so that
"""
)
KHALIL = """Convention de Khalil-Kleinfinger.

| $j$ | $\\alpha_j$ | $d_j$ | $\\theta_j$ | $r_j$ |
|---|---|---|---|---|
| 1 | 0 | 0 | $\\theta_1$ | 0 |
| 2 | $-90°$ | $D_2$ | $\\theta_2$ | 0 |
| 3 | 0 | $D_3$ | $\\theta_3$ | 0 |

$$ {}^0T_1=\\begin{bmatrix} C_1 & -S_1 & 0 & 0 \\\\ S_1 & C_1 & 0 & 0 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$
"""
OF_THE_OTHER_CONVENTION = r"""$$ {}^2T_3=\begin{bmatrix} C_3 & -S_3 & 0 & D_3 C_3 \\ S_3 & C_3 & 0 & D_3 S_3 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
$$ {}^0\omega_3=\begin{bmatrix} -S_1 (\dot\theta_2+\dot\theta_3) \\ C_1 (\dot\theta_2+\dot\theta_3) \\ \dot\theta_1 \end{bmatrix} $$
"""
DOCUMENTS = {
    "a rotation of an arm that its table alone shows": TABLE
    + r"$$ {}^0R_3 = \begin{bmatrix} c_1c_{23} & -c_1s_{23} & s_1\\ s_1c_{23} & -s_1s_{23} & «-c_1¦c_1»\\ s_{23} & c_{23} & 0 \end{bmatrix} $$",
    "a pose of an arm that its table alone shows": TABLE
    + r"$$ T_2^0 = \begin{bmatrix} c_1c_2 & -c_1s_2 & s_1 & l_2 c_1 c_2 \\ s_1c_2 & -s_1 «s_2¦c_2» & -c_1 & l_2 s_1 c_2 \\ s_2 & c_2 & 0 & d_1 + l_2 s_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$",
    "an axis of an arm that its table alone shows": TABLE
    + r"$$ z_1 = \begin{bmatrix} s_1 \\ -c_1 \\ «0¦1» \end{bmatrix} $$",
    "a link that its row of a table alone shows, with its own letter": "| i | $\\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n| 1 | 0 | 0 | 0 | $\\theta_1$ |\n| 2 | $-90°$ | 0 | $d_2$ | $\\theta_2$ |\n\n"
    r"$$ {}^0_1T = \begin{bmatrix} C_1 & -S_1 & 0 & 0 \\ S_1 & C_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n"
    r"$$ {}^1_2T = \begin{bmatrix} C_2 & -S_2 & 0 & 0 \\ 0 & 0 & 1 & «d_2¦-d_2» \\ -S_2 & -C_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$",
    "numbers at the values of the text": TABLE.replace("l_2", "0.5").replace("l_3", "0.4").replace("d_1", "0.4")
    + "At $\\theta = (30^\\circ, 60^\\circ, -90^\\circ)$ the pose of the tool is\n\n"
    r"$$ T_3^0 = \begin{bmatrix} 0.750 & 0.433 & 0.500 & 0.517 \\ 0.433 & 0.250 & -0.866 & 0.298 \\ -0.500 & 0.866 & 0 & 0.633 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n\nand its Jacobian\n\n"
    r"$$ J = \begin{bmatrix} -0.298 & «-0.202¦0.202» & 0.173 \\ 0.517 & -0.117 & 0.100 \\ 0 & 0.596 & 0.346 \end{bmatrix} $$",
    "a divisor that a condition speaks of": PLANAR
    + r"$$ l_1 = \frac{x - l_2 c_{12}}{«c_1¦s_1»}, \quad \text{if } c_1 \neq 0 $$",
    "what stands below 'Solution'": "# Exercise\nFind the radius.\n\n" + PLANAR + "**Solution**:\n"
    r"$$ x^2 + y^2 = l_1^2 + l_2^2 «+¦-» 2 l_1 l_2 c_2 $$",
    "what stands above 'and for the height'": PLANAR.replace("$$\n$$ y", "$$\nand for the tool's height\n$$ y")
    + r"$$ x^2 + y^2 = l_1^2 + l_2^2 «+¦-» 2 l_1 l_2 c_2 $$" + "\nand for its angle\n$$ \\phi = \\theta_1 + \\theta_2 $$",
    "what stands above a determinant that 'vale'": PLANAR
    + r"$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & «l_2 c_{12}¦-l_2 c_{12}» \end{bmatrix} $$"
    "\nmentre il determinante vale\n"
    r"$$ \det J = l_1 l_2 s_2 $$",
    "what a question for its reason stands behind": PLANAR
    + r"$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 «c_2¦s_2» $$" + "\nWhy does $c_2$ appear? Because the triangle is known.\n",
    "what stands above a kind of joint": PLANAR
    + r"$$ x^2 + y^2 = l_1^2 + l_2^2 «+ 2 l_1 l_2 c_2¦» $$"
    "\nFor joint 1 (revolute joint) the column of the Jacobian is $z_0 \\times p_2$.\n",
    "a link of an arm of which another line is of the other convention": KHALIL
    + r"$$ {}^1T_2=\begin{bmatrix} C_2 & -S_2 & 0 & D_2 \\ 0 & 0 & 1 & 0 \\ -S_«2¦1» & -C_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n" + OF_THE_OTHER_CONVENTION,
    "an angular velocity of an arm of which another line is of the other convention": KHALIL
    + r"$$ {}^1T_2=\begin{bmatrix} C_2 & -S_2 & 0 & D_2 \\ 0 & 0 & 1 & 0 \\ -S_2 & -C_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n" + OF_THE_OTHER_CONVENTION.replace("-S_1 (", "«-S_1¦S_1» ("),
    "a height that the first joint moves": r"""$$ x = \cos\theta_1 (a \cos\theta_2 + b \cos(\theta_2+\theta_3)) $$
$$ y = \sin\theta_1 (a \cos\theta_2 + b \cos(\theta_2+\theta_3)) $$
$$ z = h + a \sin\theta_«2¦1» + b \sin(\theta_2+\theta_3) $$
$$ x^2 + y^2 + (z-h)^2 = a^2 + b^2 + 2ab\cos\theta_3 $$""",
    "an angle twice in a coordinate beside its Jacobian": r"""$$ p = \begin{bmatrix} L_1 \cos q_1 + L_2 \cos(q_1 + q_«2¦1») \\ L_1 \sin q_1 + L_2 \sin(q_1 + q_2) \end{bmatrix} $$
$$ J = \begin{bmatrix} -L_1 \sin q_1 - L_2 \sin(q_1 + q_2) & -L_2 \sin(q_1 + q_2) \\ L_1 \cos q_1 + L_2 \cos(q_1 + q_2) & L_2 \cos(q_1 + q_2) \end{bmatrix} $$""",
    "the letter of a joint that turns for one that slides": "| i | a | α | d | θ |\n|---|---|---|---|---|\n| 1 | 0 | 90° | 0 | $q_1$ |\n| 2 | 0 | 90° | 0 | $q_2$ |\n| 3 | 0 | 0 | $q_3$ | 0 |\n\n"
    r"$$ p_x = q_3 \cos q_1 \sin q_2 $$"
    "\n"
    r"$$ p_y = q_3 \sin q_1 \sin q_2 $$"
    "\n"
    r"$$ p_z = -q_«3¦2» \cos q_2 $$",
    "a coordinate of a velocity beside the other one": "| i | a | α | d | θ |\n|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |\n\n"
    r"$$ v_x = -l_1 s_1 \dot\theta_1 - l_2 s_{12} (\dot\theta_1 + \dot\theta_«2¦1») $$"
    "\n"
    r"$$ v_y = l_1 c_1 \dot\theta_1 + l_2 c_{12} (\dot\theta_1 + \dot\theta_2) $$",
    "what is said again of a letter that is a root": LEG + r"$$ R = a_2 c_2 + a_3 c_{«23¦13»} $$",
    "a rate beside a Jacobian whose columns may stand in another order": r"""$$ x = r \cos\theta, \quad y = r \sin\theta $$
$$ \dot x = \dot r \cos\theta - r \«sin¦cos»\theta \, \dot\theta $$
$$ \dot y = \dot r \sin\theta + r \cos\theta \, \dot\theta $$
$$ J = \begin{bmatrix} \cos\theta & -r \sin\theta \\ \sin\theta & r \cos\theta \end{bmatrix} $$""",
}  # fmt: skip
LEFT_OPEN = {
    "a reflection has no slip": TABLE
    + r"$$ {}^0R_3 = \begin{bmatrix} c_1c_{23} & -c_1s_{23} & -s_1\\ s_1c_{23} & -s_1s_{23} & c_1\\ s_{23} & c_{23} & 0 \end{bmatrix} $$",
    "another rotation than that of the table": TABLE
    + r"$$ {}^0R_3 = \begin{bmatrix} c_1c_{23} & c_1s_{23} & -s_1\\ s_1c_{23} & s_1s_{23} & c_1\\ s_{23} & -c_{23} & 0 \end{bmatrix} $$",
    "another meaning of a letter that is a root": LEG + r"$$ R = a_2 c_2 + d_3 s_1 $$",
    "what stands above a part of the arm that lies so": PLANAR
    + r"$$ x^2 + y^2 = l_1^2 + l_2^2 $$" + "\nwhen the second link lies perpendicular to the first.\n",
    "a student's answer": PLANAR + "A student's answer:\n" + r"$$ x^2 + y^2 = l_1^2 + l_2^2 - 2 l_1 l_2 c_2 $$",
    "a possible solution": PLANAR + "Possible solution:\n" + r"$$ x^2 + y^2 = l_1^2 + l_2^2 - 2 l_1 l_2 c_2 $$",
    "a question that doubts": PLANAR
    + r"$$ x^2 + y^2 = l_1^2 + l_2^2 - 2 l_1 l_2 c_2 $$" + "\nWhy can this not be so?\n",
}  # fmt: skip


LINKS = r"""$$ A_1 = \begin{bmatrix} c_1 & -s_1 & 0 & l_1 c_1 \\ s_1 & c_1 & 0 & l_1 s_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
$$ A_2 = \begin{bmatrix} c_2 & -s_2 & 0 & l_2 c_2 \\ s_2 & c_2 & 0 & l_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
$$ T_2^0 = A_1 A_2 = \begin{bmatrix} c_{12} & -s_{12} & 0 & «l_1 c_1 + l_2 c_{12}¦-l_1 c_1 - l_2 c_{12}» \\ s_{12} & c_{12} & 0 & «l_1 s_1 + l_2 s_{12}¦l_1 s_1 - l_2 s_{12}» \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"""


def last(marked: str, side: int = 1) -> Record:
    """Return the record of the display with the mark, as it is right or wrong; of the last where there is none."""
    text = MARK.sub(lambda match: match[side], marked)
    records = verify_text(text).equations
    at = MARK.search(marked)
    line = marked[: at.start()].count("\n") + 1 if at is not None else records[-1].line
    return next(record for record in reversed(records) if record.line <= line)


@pytest.mark.parametrize("document", DOCUMENTS.values(), ids=DOCUMENTS.keys())
def test_a_slip_is_refuted(document: str):
    assert last(document, 2).verdict.value == "refuted"


@pytest.mark.parametrize("document", DOCUMENTS.values(), ids=DOCUMENTS.keys())
def test_its_right_twin_is_decided(document: str):
    assert last(document, 1).verdict.value in ("proved", "confirmed")


@pytest.mark.parametrize("document", LEFT_OPEN.values(), ids=LEFT_OPEN.keys())
def test_what_may_be_meant_otherwise_is_left_open(document: str):
    assert last(document).verdict.value == "unchecked"


def test_a_rotation_that_either_of_two_entries_would_mend_is_refuted():
    wrong = r"{}^AR_B = \begin{bmatrix} \cos\phi & \sin\phi & 0 \\ \sin\phi & \cos\phi & 0 \\ 0 & 0 & 1 \end{bmatrix}"
    right, other = wrong.replace("& \\sin", "& -\\sin"), wrong.replace("\\\\ \\sin", "\\\\ -\\sin")
    verdicts = [verify_text(f"$$ {latex} $$").equations[0].verdict.value for latex in (wrong, right, other)]
    assert verdicts == ["refuted", "unchecked", "unchecked"]  # what nothing uses is defined by nothing


def test_a_link_matrix_is_in_doubt_where_its_product_is_wrong_in_several_entries():
    right, wrong = (verify_text(MARK.sub(lambda found, side=side: found[side], LINKS)) for side in (1, 2))
    assert [record.verdict.value for record in right.equations] == ["proved"] * 3
    assert [record.verdict.value for record in wrong.equations] == ["unchecked", "unchecked", "refuted"]


ELBOW = "| i | alpha | a | d | theta |\n|---|---|---|---|---|\n| 1 | 90° | 0 | d_1 | θ_1 |\n| 2 | 0 | a_2 | 0 | θ_2 |\n| 3 | 0 | a_3 | 0 | θ_3 |\n\n"


@pytest.mark.parametrize(
    ("x", "y", "z", "verdict"),
    [
        ("c_1 (a_2 c_2 + a_3 c_{23})", "s_1 (a_2 c_2 + a_3 c_{23})", "d_1 + a_2 s_2 + a_3 s_{23}", "proved"),
        ("c_1 (a_2 c_2 + a_3 c_{23})", "s_1 (a_2 c_2 + a_3 c_{23})", "d_1 + a_2 c_2", "refuted"),
        ("c_1 (a_2 c_2 + a_3 c_{23})", "s_1 (a_2 c_2 + a_3 c_{23})", "d_1 + h", "unchecked"),  # of another origin
        ("c_1 a_2 c_2", "s_1 (a_2 c_2 + a_3 c_{23})", "d_1 + a_2 c_2", "unchecked"),  # one beside it holds
    ],
)
def test_the_two_other_coordinates_of_a_point_show_what_the_third_one_is(x: str, y: str, z: str, verdict: str) -> None:
    text = rf"{ELBOW}$$ \begin{{cases}} x = {x} \\ y = {y} \\ z = {z} \end{{cases}} $$"
    assert verify_text(text).equations[0].outcomes[2].verdict.value == verdict
