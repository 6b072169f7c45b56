"""Velocities at rates that stand in a column behind the Jacobian."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n"
AT = r"$$ l_1 = 1, l_2 = 1, \theta_1 = 0, \theta_2 = \frac{\pi}{2} $$"
RATES = r"\begin{bmatrix} 0.1 \\ 0.2 \end{bmatrix}"
SPEED = r"\begin{bmatrix} -0.3 \\ 0.1 \\ 0 \end{bmatrix}"


def verdicts_of(*parts: str) -> list[str]:
    return [record.verdict.value for record in verify_text(FRONT + "\n\n".join(parts) + "\n").equations]


@pytest.mark.parametrize(
    ("before", "display", "verdict"),
    [
        ("", rf"\dot p_2 = J_v {RATES}", "confirmed"),
        ("", rf"v_2 = J_v \dot q = J_v {RATES}", "confirmed"),
        (AT, rf"\dot p_2 = J_v {RATES} = {SPEED}", "confirmed"),
        (AT, rf"\dot p_2 = J_v {RATES} = {SPEED.replace('0.1', '0.35')}", "refuted"),
        (AT, rf"\dot p_2 = J_v {RATES} = {SPEED.replace('-0.3', '0.5').replace('0.1', '0.9')}", "refuted"),
        ("", rf"\dot p_2 = J_v {RATES} = {SPEED}", "unchecked"),  # nobody knows the configuration
        (r"$$ \dot\theta_1 = 0.1, \dot\theta_2 = 0.2 $$", rf"\dot p_2 = J_v {RATES}", "confirmed"),
        (r"$$ \dot\theta_1 = 0.1, \dot\theta_2 = 0.5 $$", rf"\dot p_2 = J_v {RATES}", "refuted"),
        ("", r"\dot p_2 = J_v \begin{bmatrix} 0.1 \\ 0.2 \\ 0.3 \end{bmatrix}", "unchecked"),  # the arm has two joints
        ("", rf"\dot p_2 = 2 J_v {RATES}", "unchecked"),  # perhaps another velocity
        ("", r"\dot p_2 = J_v \begin{bmatrix} 0 \\ 0 \end{bmatrix}", "refuted"),
        ("", r"\dot p_2 = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} \\ 0 \end{bmatrix}", "refuted"),
    ],
)
def test_a_velocity_is_that_at_the_rates_of_the_column(before: str, display: str, verdict: str) -> None:
    assert verdicts_of(before, f"$$ {display} $$")[-1] == verdict


def test_the_rates_of_one_line_are_not_those_of_the_next() -> None:
    other = RATES.replace("0.2", "0.7")
    assert verdicts_of(rf"$$ \dot p_2 = J_v {RATES} $$", rf"$$ \dot p_2 = J_v {other} $$") == ["confirmed"] * 2
