"""A coordinate beside the two others of its point, which hold: said otherwise it is left open, and what follows from it."""

from __future__ import annotations

from armproof.verification.check import verify_text

TEXT = r"""# An arm with a waist

| $j$ | $\alpha_{j-1}$ | $a_{j-1}$ | $d_j$ | $\theta_j$ |
|---|---|---|---|---|
| 1 | 0 | 0 | 0 | $\theta_1$ |
| 2 | $\pi/2$ | $a_1$ | 0 | $\theta_2$ |
| 3 | 0 | $a_2$ | 0 | $\theta_3$ |

The tool $E$ lies on the axis $x_3$ at the distance $a_3$ from $O_3$.

$$ {}^1T_2 = \begin{bmatrix} C_2 & -S_2 & 0 & a_1 \\ 0 & 0 & -1 & 0 \\ S_2 & C_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ {}^0T_3 = \begin{bmatrix} C_1 C_{23} & -C_1 S_{23} & S_1 & C_1 (a_1 + a_2 C_2) \\ S_1 C_{23} & -S_1 S_{23} & -C_1 & S_1 (a_1 + a_2 C_2) \\ S_{23} & C_{23} & 0 & a_2 S_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

\begin{align}
x_E &= C_1 (a_1 + a_2 C_2 + a_3 C_{23}) \\
y_E &= S_1 (a_1 + a_2 C_2 + a_3 C_{23}) \\
z_E &= a_2 S_2 + a_3 S_{23}
\end{align}

$$ \dot z_E = a_2 \dot\theta_2 C_2 + a_3 (\dot\theta_2 + \dot\theta_3) C_{23} $$

$$ \det J = -a_2 a_3 S_3 (a_1 + a_2 C_2 + a_3 C_{23}) $$
"""


def verdicts(text: str) -> list[str]:
    """Return what becomes of the displays behind the matrices."""
    return [each.verdict.value for each in verify_text(text).equations[2:]]


def test_a_height_beside_two_coordinates_that_hold_does_not_pass_though_its_rate_follows_from_it():
    assert verdicts(TEXT) == ["proved"] * 3
    wrong = TEXT.replace("a_3 S_{23}", "a_3 C_{23}")
    copied = wrong.replace(r"C_2 + a_3 (\dot\theta_2 + \dot\theta_3) C", r"C_2 - a_3 (\dot\theta_2 + \dot\theta_3) S")
    assert verdicts(copied) == ["refuted", "refuted", "proved"]
    assert verdicts(wrong)[0] in ("unchecked", "refuted")
