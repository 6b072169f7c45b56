r"""What courses on the web write in derivations: the law of cosines behind a root less a length, [v; ω] of the plane, names of several letters."""

from __future__ import annotations

import pytest

from armproof import verify_text

YAWING = r"""
| $i$ | $\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\theta_i$ |
|---|---|---|---|---|
| 1 | 0 | 0 | $d_1$ | $\theta_1$ |
| 2 | 90° | $a_1$ | 0 | $\theta_2$ |
| 3 | 0 | $a_2$ | 0 | $\theta_3$ |
| 4 | 0 | $a_3$ | 0 | 0 |

"""
REACH = r"""
$$ \rho = \sqrt{p_x^2 + p_y^2} - a_1 $$

$$ h = p_z - d_1 $$
"""
PLANAR = "---\narm: planar_2r\n---\n# A page\n\n"
VELOCITY = r"-l_1 s_1\dot\theta_1 - l_2 s_{12}(\dot\theta_1 + \dot\theta_2) \\ l_1 c_1\dot\theta_1 + l_2 c_{12}(\dot\theta_1 + \dot\theta_2)"
RATE = r"\dot\theta_1 + \dot\theta_2"


def _last(text: str) -> str:
    return verify_text(text + "\n").equations[-1].verdict.value


@pytest.mark.parametrize("named", ["", r"D^2 = "])
@pytest.mark.parametrize(
    ("right", "verdict"),
    [
        (r"a_2^2 + a_3^2 + 2 a_2 a_3 \cos\theta_3", "confirmed"),
        (r"a_2^2 + a_3^2 - 2 a_2 a_3 \cos\theta_3", "unchecked"),  # or ρ, or h, has the slip
        (r"a_2^2 + a_3^2 + 2 a_2 a_3 \cos(\theta_2 + \theta_3)", "unchecked"),
    ],
)
def test_the_law_of_cosines_of_a_distance_less_a_length_holds_on_a_branch(named: str, right: str, verdict: str) -> None:
    assert _last(f"# A page\n{YAWING}{REACH}\n$$ {named}\\rho^2 + h^2 = {right} $$") == verdict


@pytest.mark.parametrize(
    ("printed", "verdict"),
    [
        (rf"\begin{{bmatrix}} {{}}^0v_2 \\ {{}}^0\omega_{{z_2}} \end{{bmatrix}} = \begin{{bmatrix}} {VELOCITY} \\ {RATE} \end{{bmatrix}}", "proved"),
        (rf"\begin{{bmatrix}} {{}}^0\omega_2 \\ {{}}^0v_2 \end{{bmatrix}} = \begin{{bmatrix}} {RATE} \\ {VELOCITY} \end{{bmatrix}}", "proved"),
        (rf"\begin{{bmatrix}} {{}}^0v_2 \\ {{}}^0\omega_{{z_2}} \end{{bmatrix}} = \begin{{bmatrix}} {VELOCITY} \\ \dot\theta_1 - \dot\theta_2 \end{{bmatrix}}", "refuted"),
    ],
)  # fmt: skip
def test_in_the_plane_a_velocity_of_two_components_stands_above_its_rate(printed: str, verdict: str) -> None:
    assert _last(f"{PLANAR}$$ {printed} $$") == verdict


@pytest.mark.parametrize(
    ("axis", "verdict"),
    [(r"+ \dot\theta_1 \hat{Z}_1", "proved"), (r"- \dot\theta_1 \hat{Z}_1", "refuted")],
)
def test_a_hatted_letter_of_a_coordinate_is_an_axis(axis: str, verdict: str) -> None:
    assert _last(rf"{PLANAR}$$ {{}}^1\omega_1 = {{}}^1_0R\,{{}}^0\omega_0 {axis} $$") == verdict


POINT = r"\begin{bmatrix} u \\ w \end{bmatrix} = \begin{bmatrix} q_2 \cos q_1 \\ q_2 \sin q_1 \end{bmatrix}"
DERIVED = r"J = \begin{bmatrix} \frac{\partial u}{\partial q_1} & \frac{\partial u}{\partial q_2} \\ \frac{\partial w}{\partial q_1} & \frac{\partial w}{\partial q_2} \end{bmatrix} = \begin{bmatrix} -q_2 \sin q_1 & \cos q_1 \\ q_2 \cos q_1 & SIGN\sin q_1 \end{bmatrix}"


@pytest.mark.parametrize("name", ["", "tip = ", "{}^{ground}tip_{end} = "])
def test_a_name_of_what_its_letters_are_is_used_with_them(name: str) -> None:
    first, second = verify_text(f"# A page\n\n$$ {name}{POINT} $$\n\n$$ {DERIVED.replace('SIGN', '')} $$\n").equations
    assert (first.verdict.value, second.verdict.value) == ("defined", "proved")
    first, second = verify_text(f"# A page\n\n$$ {name}{POINT} $$\n\n$$ {DERIVED.replace('SIGN', '-')} $$\n").equations
    assert second.verdict.value != "proved"


@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        (r"MT2 = A_1 A_2 = \begin{bmatrix} c_{12} & -s_{12} & 0 & l_1 c_1 + l_2 c_{12} \\ s_{12} & c_{12} & 0 & l_1 s_1 + l_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}", "proved"),
        (r"MT2 = A_1 A_2 = \begin{bmatrix} c_{12} & -s_{12} & 0 & l_1 c_1 - l_2 c_{12} \\ s_{12} & c_{12} & 0 & l_1 s_1 + l_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}", "refuted"),
        (r"M T_2 = A_1 A_2", "unchecked"),  # a product of what has no value
    ],
)  # fmt: skip
def test_letters_that_touch_and_end_with_a_digit_are_one_name(display: str, verdict: str) -> None:
    assert _last(f"{PLANAR}$$ {display} $$") == verdict


J = r"$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \\ 1 & 1 \end{bmatrix} $$"


@pytest.mark.parametrize(
    ("before", "display", "verdict"),
    [
        (J, r"m = \sqrt{\det(J J^T)}", "refuted"),
        (J, r"m = \sqrt{\det(J^T J)}", "defined"),
        ("", r"m = \sqrt{\det(J J^T)}", "defined"),  # J may have two rows
    ],
)
def test_a_determinant_that_the_shape_of_the_jacobian_makes_zero_measures_nothing(
    before: str, display: str, verdict: str
) -> None:
    found = _last(f"{PLANAR}{before}\n\n$$ {display} $$")
    assert (found == "refuted") is (verdict == "refuted")
