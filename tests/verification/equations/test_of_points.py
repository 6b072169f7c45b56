r"""Where a document gives its point and no arm, what it derives from that point is decided: J, rates, determinants, letters of sentences."""

from __future__ import annotations

import pytest

from armproof import verify_text

PENDULUM = r"""
A carriage runs along $x$; its abscissa is $l$. It carries a link of length 1, inclined by $\theta$.

$$ x = l + \sin\theta, \qquad y = -\cos\theta $$
"""
SLIDER = r"""
The link of length $l$ makes the angle $\theta$ with the $x$-axis. A slider of extension $q$ goes off at a right angle.

$$ x_B = l\cos\theta - q\sin\theta, \qquad y_B = l\sin\theta + q\cos\theta $$
"""
BY_ANGLE_FIRST = r"$$ J_B = \begin{pmatrix} -l\sin\theta - q\cos\theta & -\sin\theta\\ l\cos\theta - q\sin\theta & \cos\theta \end{pmatrix} $$"
ABSOLUTE = r"""
$$ x = r_1\cos\theta_1 + r_2\cos\theta_2, \qquad y = r_1\sin\theta_1 + r_2\sin\theta_2 $$

"""
LIFT = r"""
$$ r = e + a\sin\alpha + b\cos\beta $$

$$ z = h + a\cos\alpha - b\sin\beta $$

"""


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


@pytest.mark.parametrize(
    ("text", "last"),
    [
        (PENDULUM + r"$$ J = \begin{pmatrix} 1 & \cos\theta \\ 0 & \sin\theta \end{pmatrix} $$", "proved"),
        (PENDULUM + r"$$ J = \begin{pmatrix} 1 & \cos\theta \\ 0 & -\sin\theta \end{pmatrix} $$", "unchecked"),
        (PENDULUM + r"$$ J = \begin{pmatrix} 0 & \cos\theta \\ 1 & \sin\theta \end{pmatrix} $$", "unchecked"),
        (SLIDER + BY_ANGLE_FIRST, "proved"),
        (SLIDER + BY_ANGLE_FIRST.replace("-q", "+q", 1), "proved"),
        (SLIDER + "\nWith the order $(\\theta, q)$,\n\n" + BY_ANGLE_FIRST, "proved"),
        (SLIDER + "\nWith the order $(q, \\theta)$,\n\n" + BY_ANGLE_FIRST, "unchecked"),
        (SLIDER + "\nDans l'ordre $(q, \\theta)$,\n\n" + BY_ANGLE_FIRST, "unchecked"),
        (ABSOLUTE + r"$$ J_{2R} = \begin{pmatrix} -r_1\sin\theta_1 & -r_2\sin\theta_2 \\ r_1\cos\theta_1 & r_2\cos\theta_2 \end{pmatrix} $$", "proved"),
        (ABSOLUTE + r"$$ J_{2R} = \begin{pmatrix} -r_2\sin\theta_2 & -r_1\sin\theta_1 \\ r_2\cos\theta_2 & r_1\cos\theta_1 \end{pmatrix} $$", "unchecked"),
        (ABSOLUTE + r"$$ J_{2R} = \begin{pmatrix} -r_1\sin\theta_1 & -r_2\sin\theta_2 \\ r_1\cos\theta_1 & -r_2\cos\theta_2 \end{pmatrix} $$", "unchecked"),
        (r"$$ p = (r\cos\theta,\; r\sin\theta,\; h) $$" "\n\n" r"$$ J = \begin{pmatrix} -r\sin\theta & 0 & \cos\theta \\ r\cos\theta & 0 & \sin\theta \\ 0 & 1 & 0 \end{pmatrix} $$", "proved"),
        (r"$$ p = (r\cos\theta,\; r\sin\theta,\; h) $$" "\n\n" r"$$ J = \begin{pmatrix} -r\sin\theta & 0 & \cos\theta \\ r\cos\theta & 0 & -\sin\theta \\ 0 & 1 & 0 \end{pmatrix} $$", "unchecked"),
        (r"$$ p = (\rho\cos\phi,\; \rho\sin\phi) $$" "\n\n" r"$$ \|p\|^2 = \rho^2 $$", "proved"),
        (r"$$ p = (\rho\cos\phi,\; \rho\sin\phi) $$" "\n\n" r"$$ \|p\|^2 = 2\rho^2 $$", "refuted"),
        (LIFT + "With $u = r - e$ and $w = z - h$:\n\n" + r"$$ u^2 + w^2 = a^2 + b^2 + 2ab\sin(\alpha - \beta) $$", "proved"),
        (LIFT + "With $u = r - e$ and $w = z - h$:\n\n" + r"$$ u^2 + w^2 = a^2 + b^2 + 2ab\cos(\alpha - \beta) $$", "refuted"),
        (LIFT + "With $u = r + e$ and $w = z - h$:\n\n" + r"$$ u^2 + w^2 = a^2 + b^2 + 2ab\sin(\alpha - \beta) $$", "unchecked"),
        (LIFT + "With $\\gamma = \\alpha - \\beta$:\n\n" + r"$$ (r-e)^2 + (z-h)^2 = a^2 + b^2 + 2ab\sin\gamma $$", "proved"),
        (LIFT + "With $\\gamma = \\alpha + \\beta$:\n\n" + r"$$ (r-e)^2 + (z-h)^2 = a^2 + b^2 + 2ab\sin\gamma $$", "unchecked"),
        (LIFT + "If $\\beta = \\alpha$:\n\n" + r"$$ (r-e)^2 + (z-h)^2 = a^2 + b^2 $$", "unchecked"),
        (LIFT + r"$$ \begin{pmatrix} \dot r \\ \dot z \end{pmatrix} = \begin{pmatrix} a\cos\alpha & -b\sin\beta \\ -a\sin\alpha & -b\cos\beta \end{pmatrix} \begin{pmatrix} \dot\alpha \\ \dot\beta \end{pmatrix} $$", "proved"),
        (LIFT + r"$$ \begin{pmatrix} \dot r \\ \dot z \end{pmatrix} = \begin{pmatrix} a\cos\alpha & -b\sin\beta \\ -a\sin\alpha & b\cos\beta \end{pmatrix} \begin{pmatrix} \dot\alpha \\ \dot\beta \end{pmatrix} $$", "unchecked"),
        ("$$ x = d\\cos\\alpha $$\n\n" + r"$$ \dot x = -d\sin\alpha\,\dot\alpha $$", "unchecked"),  # d may slide
    ],
)  # fmt: skip
def test_what_follows_from_the_documents_own_point_is_decided(text: str, last: str) -> None:
    assert verdicts(text)[-1] == last


POLAR = r"""
## The polar arm

$$ x = r\cos\theta, \qquad y = r\sin\theta $$

$$ \dot x = \dot r\cos\theta - r\sin\theta\,\dot\theta $$

## The elbow arm

{words}

$$ x = r_1\cos\theta_1 + r_2\cos\theta_2, \qquad y = r_1\sin\theta_1 + r_2\sin\theta_2 $$

$$ J = \begin{{pmatrix}} -r_1\sin\theta_1 & -r_2\sin\theta_2 \\ r_1\cos\theta_1 & {cell} \end{{pmatrix}} $$
"""
ANEW = r"Here $\theta_1$ and $\theta_2$ are the motor angles, both from the $x$ axis, and $r_1$ and $r_2$ the lengths of the links."


@pytest.mark.parametrize(
    ("words", "cell", "verdict"),
    [
        (ANEW, r"r_2\cos\theta_2", "proved"),
        (ANEW, r"r_2\sin\theta_2", "unchecked"),
        (ANEW, r"-r_2\cos\theta_2", "unchecked"),
    ],
)
def test_a_section_that_tells_its_letters_and_gives_its_point_anew_is_of_an_arm_of_its_own(
    words: str, cell: str, verdict: str
) -> None:
    text = POLAR.replace("{words}", words).replace("{cell}", cell).replace("{{", "{").replace("}}", "}")
    assert verdicts(text)[-1] == verdict


def test_without_a_word_of_its_letters_a_point_given_anew_is_of_the_arm_above() -> None:
    text = r"""
$$ x = l_1\cos\theta_1 + l_2\cos(\theta_1 + \theta_2), \qquad y = l_1\sin\theta_1 + l_2\sin(\theta_1 + \theta_2) $$

$$ \det J = l_1 l_2\sin\theta_2 $$

## Summary

$$ x = l_1\cos\theta_1 + l_2\cos\theta_2, \qquad y = l_1\sin\theta_1 + l_2\sin\theta_2 $$

$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2\cos(\theta_1 - \theta_2) $$
"""
    assert verdicts("# Planar arm\n" + text)[2] not in ("proved", "confirmed", "defined")


PLUMB = r"""
Both angles are measured from the upward vertical.

$$ x = a\sin\phi_1 + b\sin\phi_2, \qquad z = a\cos\phi_1 + b\cos\phi_2 $$

$$ x^2 + z^2 = a^2 + b^2 + 2ab\cos(\phi_2 - \phi_1) $$

**Numbers.** $a = 2$ m, $b = 1.5$ m, $\phi_1 = 30^\circ$, $\phi_2 = 120^\circ$:

"""


@pytest.mark.parametrize(
    ("numbers", "verdict"),
    [
        (r"$$ x = 2.299\ \text{m}, \qquad z = 0.982\ \text{m} $$", "confirmed"),
        (r"$$ x = 2(0.5) + 1.5(0.866) = 2.299\ \text{m} $$", "confirmed"),
        (r"$$ (x, z) = (2.299,\ 0.982) $$", "confirmed"),
        (r"$$ x = 2.399\ \text{m}, \qquad z = 0.982\ \text{m} $$", "unchecked"),
        (r"$$ x = 0.982\ \text{m} $$", "unchecked"),
        (r"$$ x = 0 $$", "unchecked"),
    ],
)
def test_numbers_of_the_documents_own_point_are_compared_at_the_values_of_the_text(numbers: str, verdict: str) -> None:
    assert verdicts(PLUMB + numbers)[-1] == verdict


def test_values_of_another_section_are_not_those_of_numbers() -> None:
    assert verdicts(PLUMB + "## Another arm\n\n" + r"$$ x = 2.299\ \text{m} $$")[-1] == "unchecked"


CRANE = r"""
The axis $z$ points down, and both angles are counted from the {vertical} vertical.

$$ x = s + l_1\sin\alpha_1 + l_2\sin\alpha_2 $$

$$ z = {sign}l_1\cos\alpha_1 {sign2} l_2\cos\alpha_2 $$

$$ J = \begin{pmatrix} 1 & l_1\cos\alpha_1 & l_2\cos\alpha_2 \\ 0 & {turned}l_1\sin\alpha_1 & {turned}l_2\sin\alpha_2 \end{pmatrix} $$
"""


@pytest.mark.parametrize(
    ("vertical", "sign", "sign2", "turned", "found"),
    [
        ("downward", "", "+", "-", ["defined", "defined", "proved"]),
        ("downward", "-", "-", "", ["defined", "unchecked", "unchecked"]),
        ("upward", "", "+", "-", ["defined", "unchecked", "unchecked"]),
    ],
)
def test_an_axis_that_points_down_is_followed_where_the_arm_hangs(
    vertical: str, sign: str, sign2: str, turned: str, found: list[str]
) -> None:
    text = CRANE
    for name, value in (("vertical", vertical), ("sign2", sign2), ("sign", sign), ("turned", turned)):
        text = text.replace("{" + name + "}", value)
    assert verdicts(text)[1:] == found[1:]


@pytest.mark.parametrize(("height", "verdict"), [(r"\rho\sin\varphi", "defined"), (r"-\rho\sin\varphi", "unchecked")])
def test_an_angle_of_elevation_lifts_the_documents_own_point(height: str, verdict: str) -> None:
    text = rf"""
Azimuth $\theta$, elevation $\varphi$ above the horizontal.

$$ p = (\rho\cos\varphi\cos\theta,\; \rho\cos\varphi\sin\theta,\; {height}) $$

$$ \|p\|^2 = \rho^2 $$
"""
    assert verdicts(text)[0] == verdict


ROWS = r"""
$$ M_1 = \begin{pmatrix} c_1 & s_1 & 0 \\ -s_1 & c_1 & 0 \\ a c_1 & a s_1 & 1 \end{pmatrix} $$

$$ M_2 = \begin{pmatrix} c_2 & s_2 & 0 \\ -s_2 & c_2 & 0 \\ b c_2 & b s_2 & 1 \end{pmatrix} $$

$$ M = M_2 M_1 = \begin{pmatrix} c_{12} & s_{12} & 0 \\ -s_{12} & c_{12} & 0 \\ a c_1 + b c_{12} & a s_1 + b s_{12} & 1 \end{pmatrix} $$

"""
TIP = r"$$ (x,\; y,\; 1) = (0,\; 0,\; 1)\,M = (a c_1 + b c_{12},\;\; a s_1 + b s_{12},\;\; 1) $$"
INVERSE = r"$$ (\dot\theta_1, \dot\theta_2) = (\dot x, \dot y)\,\frac{1}{a b s_2}\begin{pmatrix} b c_{12} & -a c_1 - b c_{12} \\ b s_{12} & -a s_1 - b s_{12} \end{pmatrix} $$"


@pytest.mark.parametrize(
    ("text", "last"),
    [
        (ROWS + TIP, "proved"),
        (ROWS + TIP + "\n\n$$ x^2 + y^2 = a^2 + b^2 + 2ab\\,c_2 $$", "proved"),
        (ROWS + TIP + "\n\n$$ x^2 + y^2 = a^2 + b^2 + 2ab\\,s_2 $$", "not passed"),
        (ROWS + TIP.replace("b s_{12}", "b c_{12}"), "not passed"),
        (ROWS + TIP + "\n\n" + INVERSE, "proved"),
        (ROWS + TIP + "\n\n" + INVERSE.replace("-a s_1", "a s_1"), "not passed"),
        (ROWS + TIP + "\n\n" + r"$$ \theta_1 = \operatorname{atan2}(y, x) - \operatorname{atan2}(b s_2,\; a + b c_2) $$", "proved"),
        (ROWS + TIP + "\n\n" + r"$$ \theta_1 = \operatorname{atan2}(y, x) + \operatorname{atan2}(b s_2,\; a + b c_2) $$", "not passed"),
    ],
)  # fmt: skip
def test_a_tuple_before_a_matrix_is_a_row(text: str, last: str) -> None:
    found = verdicts(text)[-1]
    assert found in ("refuted", "unchecked") if last == "not passed" else found == last
