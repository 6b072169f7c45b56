"""How kinematics is written in the wild: every spelling of one matrix, one cosine, one arc function reads alike."""

from collections.abc import Callable
from typing import Any

import pytest

from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]

# An anthropomorphic arm: link 1 vertical, links 2 and 3 in its plane.
ARM: dict[str, Any] = {
    "dh": "classic",
    "rows": [
        {"a": 0, "alpha": "90deg", "d": "d_1", "theta": "theta_1"},
        {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"},
        {"a": "a_3", "alpha": 0, "d": 0, "theta": "theta_3"},
    ],
}
FIRST = (("{c}", "0", "{s}", "0"), ("{s}", "0", "-{c}", "0"), ("0", "1", "0", "d_1"), ("0", "0", "0", "1"))


def first(cosine: str = "c_1", sine: str = "s_1", *, cell: str = " & ", row: str = r" \\ ", slip: bool = False) -> str:
    """Return the cells of ^0T_1; with a slip, the sign of one sine."""
    rows = [[entry.format(c=cosine, s=sine) for entry in line] for line in FIRST]
    if slip:
        rows[1][0] = f"-{sine}"
    return row.join(cell.join(line) for line in rows)


def bmatrix(body: str) -> str:
    return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"


def assert_told_apart(judge: Judge, right: str, wrong: str, **front: Any) -> None:
    """The right display is proved, the one with a slip refuted in the cell that holds it."""
    front.setdefault("arm", ARM)
    assert judge(right, **front).verdict is Verdict.PROVED, judge(right, **front).message
    record = judge(wrong, **front)
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(2, 1)]


NAMES = [
    r"{}^0T_1", r"^0T_1", r"^0\mathbf{T}_1", r"{}^{0}\!T_1", r"{}^0_1T", r"_1^0T", r"{ }_{1}^{0} T", r"{}_{1}^{0}\textrm{T}", r"^{0}_{1}\mathrm{T}",
    r"T_{01}", r"T_{0,1}", r"T^0_1", r"T_1^0", r"{T}^0_1", r"\boldsymbol{T}_1^0", r"\mathbf{T}^{0}_{1}", r"A_1", r"H_1", r"A^0_1", r"H_1^0",
    r"{}^0A_1", r"{^0}T_1", r"{_1^0}T", r"{}^0T_1(\theta_1)", r"A_1(\theta_1)", r"\hat{T}_{01}", r"{}^{0}{T}_{1}", r"\,^0T_1",
]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_every_spelling_of_a_transform_names_it(judge: Judge, name: str) -> None:
    assert_told_apart(judge, f"{name} = {bmatrix(first())}", f"{name} = {bmatrix(first(slip=True))}")


@pytest.mark.parametrize("name", [r"T_0^1", r"A_0^1", r"H_0^1", r"{}^0T_1", r"{}^0_1T"])
def test_a_document_that_names_the_reference_below_says_so(judge: Judge, name: str) -> None:
    right, wrong = bmatrix(first()), bmatrix(first(slip=True))
    assert_told_apart(judge, f"{name} = {right}", f"{name} = {wrong}", transforms="lower")


ENVIRONMENTS = [
    r"\begin{bmatrix} %s \end{bmatrix}", r"\begin{pmatrix} %s \end{pmatrix}", r"\left[\begin{matrix} %s \end{matrix}\right]",
    r"\left[\begin{array}{cccc} %s \end{array}\right]", "\\left[\n\\begin{array}\n{cccc}\n%s\n\\end{array}\n\\right]",
    r"\left(\begin{array}{rrr|r} %s \end{array}\right)", r"[\begin{matrix} %s \end{matrix}]", r"\begin{bmatrix} %s \\ \end{bmatrix}",
    r"\big[\begin{matrix} %s \end{matrix}\big]", r"\left\lbrack\begin{array}{*{20}{c}} %s \end{array}\right\rbrack",
    r"\boxed{\begin{bmatrix} %s \end{bmatrix}}", r"\begin{bmatrix} %s \end{bmatrix}.", r"\begin{bmatrix} %s \end{bmatrix} \tag{3.4}",
    r"\displaystyle \begin{bmatrix} %s \end{bmatrix} \label{eq:t}", r"\left[ {\begin{array}{cccc} %s \end{array}} \right]",
]  # fmt: skip


@pytest.mark.parametrize("environment", ENVIRONMENTS)
def test_every_environment_holds_a_matrix(judge: Judge, environment: str) -> None:
    right, wrong = environment % first(), environment % first(slip=True)
    assert_told_apart(judge, f"{{}}^0T_1 = {right}", f"{{}}^0T_1 = {wrong}")


@pytest.mark.parametrize(
    "row",
    [
        r" \\ ",
        r"\\[1ex]",
        r"\\[4pt] ",
        r" \\\\ ",
        "\n\\\\\n",
        r"\\",
        r" \\ \hline ",
        r" \\ \hdashline ",
        r" \\ \\ ",
        r" \\*",
        r" \cr ",
    ],
)
@pytest.mark.parametrize("cell", [" & ", "&", " && ", " &\n "])
def test_rows_and_cells_may_be_set_off_in_any_way(judge: Judge, row: str, cell: str) -> None:
    names = {"cosine": r"\cos\theta_1", "sine": r"\sin\theta_1"}
    right, wrong = (bmatrix(first(**names, cell=cell, row=row, slip=slip)) for slip in (False, True))
    assert_told_apart(judge, f"{{}}^0T_1 = {right}", f"{{}}^0T_1 = {wrong}")


ANGLES = [
    ("c_1", "s_1"), ("C_1", "S_1"), ("c_{1}", "s_{1}"), ("{c}_1", "{s}_1"), ("C1", "S1"), (r"\mathrm{c}_1", r"\mathrm{s}_1"),
    (r"\cos\theta_1", r"\sin\theta_1"), (r"\cos(\theta_1)", r"\sin(\theta_1)"), (r"\cos\left(\theta_1\right)", r"\sin\left(\theta_1\right)"),
    (r"\cos{\left(\theta_{1} \right)}", r"\sin{\left(\theta_{1} \right)}"), (r"\cos{\theta_1}", r"\sin{\theta_1}"),
    (r"{\cos}{\theta_1}", r"{\sin}{\theta_1}"), (r"cos(\theta_1)", r"sin(\theta_1)"), (r"cos\theta_1", r"sin\theta_1"), ("cos(q_1)", "sin(q_1)"),
    ("cos(q1)", "sen(q1)"), (r"\cos q_1", r"\text{sen}\,q_1"), (r"\mathrm{cos}\,\theta_1", r"\operatorname{sen}\theta_1"),
    (r"c\theta_1", r"s\theta_1"), (r"C{\theta_1}", r"S{\theta_1}"), (r"C(\theta_1)", r"S(\theta_1)"), (r"c_{\theta_1}", r"s_{\theta_1}"),
    (r"C_{\theta_{1}}", r"S_{\theta_{1}}"), (r"c(\theta_1)", r"s(\theta_1)"), (r"\cos\theta_1^*", r"\sin\theta_1^{*}"), (r"c\vartheta_1", r"s\vartheta_1"),
    ("cos(θ₁)".replace("₁", "_1"), "sin(θ_1)"), (r"\cos(\theta_1^{\star})", r"\sin(\theta_1^\star)"), (r"\cos \theta_{\text{1}}", r"\sin \theta_{\mathrm 1}"),
]  # fmt: skip


@pytest.mark.parametrize(("cosine", "sine"), ANGLES)
def test_every_spelling_of_a_cosine_is_one(judge: Judge, cosine: str, sine: str) -> None:
    right, wrong = (bmatrix(first(cosine, sine, slip=slip)) for slip in (False, True))
    assert_told_apart(judge, f"{{}}^0T_1 = {right}", f"{{}}^0T_1 = {wrong}")


@pytest.mark.parametrize(
    "angle",
    [
        r"c_{23}", r"C_{23}", r"c_{2+3}", r"c_{2,3}", r"c23", r"\cos(\theta_2+\theta_3)", r"\cos (\theta_{2} + \theta_{3})", r"C(\theta_2+\theta_3)",
        r"c_{\theta_2+\theta_3}", r"cos(q_2+q_3)", r"(c_2c_3 - s_2s_3)", r"(c_2)(c_3) - (s_2)(s_3)", r"\cos\theta_{23}", r"\cos(\theta_{23})",
    ],
)  # fmt: skip
def test_sums_of_angles_are_read_in_every_spelling(judge: Judge, angle: str) -> None:
    lines = r"{}^1T_3 = \begin{bmatrix} %s & -s_{23} & 0 & a_2c_2 + a_3c_{23} \\ s_{23} & c_{23} & 0 & a_2s_2 + a_3s_{23} \\ 0&0&1&0 \\ 0&0&0&1 \end{bmatrix}"
    assert judge(lines % angle, arm=ARM).verdict is Verdict.PROVED
    wrong = judge(lines % angle.replace("2", "1", 1), arm=ARM)
    assert wrong.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in wrong.entries] == [(1, 1)]


@pytest.mark.parametrize(
    "degrees", [r"90^\circ", r"90^{\circ}", "90°", r"90^o", r"90\degree", r"\frac{\pi}{2}", r"\pi/2", r"90\text{ deg}"]
)
def test_constant_angles_are_in_degrees_or_radians(judge: Judge, degrees: str) -> None:
    lines = r"A_1 = \begin{bmatrix} c_1 & -\cos(%s)s_1 & \sin(%s)s_1 & 0 \\ s_1 & \cos(%s)c_1 & -\sin(%s)c_1 & 0 \\ 0 & %s\sin(%s) & \cos(%s) & d_1 \\ 0&0&0&1 \end{bmatrix}"
    angles = (degrees,) * 4
    assert judge(lines % (*angles, "", degrees, degrees), arm=ARM).verdict is Verdict.PROVED
    assert judge(lines % (*angles, "-", degrees, degrees), arm=ARM).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "product",
    [
        r"{}^0T_1\,{}^1T_2\,{}^2T_3", r"A_1A_2A_3", r"A_1 \cdot A_2 \cdot A_3", r"A_1 \times A_2 \times A_3", r"A_1 . A_2 . A_3", r"A_1.A_2.A_3",
        r"A_1 * A_2 * A_3", r"^0_1T^1_2T^2_3T", r"^0T_1^1T_2^2T_3", r"_1^0T\cdot_2^1T\cdot_3^2T", r"_1^0T_2^1T_3^2T", r"T_1^0T_2^1T_3^2",
        r"{ }_{1}^{0} T \cdot{ }_{2}^{1} T \cdot{ }{ }_{3}^{2} T", r"\left(A_1 A_2\right) A_3", r"[A_1][A_2][A_3]", r"{}^0T_2 \; {}^2T_3", r"T^0_1\ T^1_2\ T^2_3",
        r"\;^{0}T_{1}\;^{1}T_{2}\;^{2}T_{3}",
    ],
)  # fmt: skip
def test_products_of_transforms_are_read_in_every_spelling(judge: Judge, product: str) -> None:
    assert judge(rf"{{}}^0T_3 = {product}", arm=ARM).verdict is Verdict.PROVED
    assert judge(rf"{{}}^0T_2 = {product}", arm=ARM).verdict is Verdict.REFUTED


ATAN2 = [
    r"\operatorname{atan2}(p_y, p_x)", r"\text{Atan2}(p_y, p_x)", r"\mathrm{atan2}(p_y,p_x)", "atan2(p_y,p_x)", r"\arctan2(p_y, p_x)", r"\tan^{-1}(p_y, p_x)",
    r"a\tan 2(p_y, p_x)", r"a\tan2\left(p_y, p_x\right)", r"\text{arctan2}(p_y, p_x)", r"\operatorname{Atan} 2(p_y, p_x)", r"\operatorname{atan}_2(p_y, p_x)",
    r"\arctan(p_y, p_x)", r"\mathrm{ATAN2}(p_y, p_x)", r"\text{atan2}\left[p_y, p_x\right]", r"\operatorname{Atan2}\big(p_y, \; p_x\big)",
]  # fmt: skip
SOLVED = r"{}^0T_3 = \begin{bmatrix} n_x & o_x & a_x & p_x \\ n_y & o_y & a_y & p_y \\ n_z & o_z & a_z & p_z \\ 0&0&0&1 \end{bmatrix}"


@pytest.mark.parametrize("spelling", ATAN2)
def test_every_spelling_of_atan2_has_two_arguments_y_first(judge: Judge, spelling: str) -> None:
    right = judge(SOLVED, rf"\theta_1 = {spelling}", arm=ARM)
    assert right.verdict is Verdict.CONFIRMED
    assert "branch" in right.message
    swapped = spelling.replace("p_y", "p_z").replace("p_x", "p_y").replace("p_z", "p_x")
    assert judge(SOLVED, rf"\theta_1 = {spelling}", rf"\theta_1 = {swapped}", arm=ARM).verdict is Verdict.REFUTED
    alone = judge(SOLVED, rf"\theta_1 = {swapped}", arm=ARM)
    assert alone.verdict is Verdict.UNCHECKED and "atan2(x, y)" in alone.message


COSINE = r"\frac{p_x^2+p_y^2+(p_z-d_1)^2-a_2^2%sa_3^2}{2a_2a_3}"


@pytest.mark.parametrize(
    "formula",
    [
        r"\theta_3 = \pm\arccos\left(%s\right)", r"\theta_3 = \cos^{-1}\left(%s\right)", r"\theta_3 = acos\left(%s\right)", r"\theta_3 = \text{arccos}\,%s",
        r"\theta_3 = \operatorname{atan2}\left(\pm\sqrt{1-D^2}, D\right), \quad D = %s", r"\theta_3 = \tan^{-1}\frac{\pm\sqrt{1-D^2}}{D}, \text{ where } D = %s",
        r"\cos\theta_3 = %s", r"c_3 = %s := D", r"\boxed{\theta_3 = \pm \cos^{-1} \left[ %s \right]} \tag{7}",
    ],
)  # fmt: skip
def test_inverse_kinematics_holds_up_to_its_branches(judge: Judge, formula: str) -> None:
    assert judge(SOLVED, formula % (COSINE % "-"), arm=ARM).verdict in (Verdict.PROVED, Verdict.CONFIRMED)
    assert judge(SOLVED, formula % (COSINE % "+"), arm=ARM).verdict in (Verdict.REFUTED, Verdict.UNCHECKED)
    if "D =" not in formula:  # where D is defined by the display, its value is the document's own
        assert judge(SOLVED, formula % (COSINE % "+"), arm=ARM).verdict is Verdict.REFUTED
