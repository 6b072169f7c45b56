"""A name that a sentence defines otherwise than convention has no usual meaning; beside its usual definition it keeps it."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import HOLDS, Verdict

TIP = r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \\ 0 \end{bmatrix}"
ELBOW = r"\begin{bmatrix} l_1 c_1 \\ l_1 s_1 \\ 0 \end{bmatrix}"
SPIN = r"\begin{bmatrix} 0 \\ 0 \\ \dot\theta_1 + \dot\theta_2 \end{bmatrix}"
RATE = r"\begin{bmatrix} -l_1 s_1 \\ l_1 c_1 \\ 0 \end{bmatrix} \dot\theta_1"
DEFINED = (
    (r"Let $P_1$ be the {} of the first link.", "end", "middle", f"P_1 = {ELBOW}"),
    (r"On note $P_2$ {} du second segment.", "l'extrémité", "le milieu", f"P_2 = {TIP}"),
    (r"Sea $p_1$ el {} del primer eslabón.", "extremo", "punto medio", rf"\dot p_1 = {RATE}"),
    (r"$\omega_i$ bezeichnet die Winkelgeschwindigkeit des Glieds $i$ gegen {}.", "die Basis", "das vorige Glied", rf"\omega_2 = {SPIN}"),
    ("| name | meaning |\n|---|---|\n| $p_1$ | {} of bar 1 |", "end", "middle", f"p_1 = {ELBOW}"),
    ("- $p_2$ : position de la {}\n", "pince", "caméra", f"p_2 = {TIP}"),
    (r"We call $\varphi$ the {} angle of the tool.", "orientation", "polar", r"\varphi = \theta_1 + \theta_2"),
    (r"On note $\phi$ l'angle de {} avec l'axe $x$.", "la main", "l'avant-bras", r"\phi = \theta_1 + \theta_2"),
    (r"Mit $y$ bezeichnen wir die Höhe der Spitze über {}.", "dem Boden", "der Schulter", r"\dot y = l_1 c_1 \dot\theta_1 + l_2 c_{12} (\dot\theta_1 + \dot\theta_2)"),
)  # fmt: skip


def page(*parts: str) -> str:
    return "\n\n".join(("---\narm: planar_2r\n---", *parts))


def shown(latex: str) -> str:
    return f"$$\n{latex}\n$$"


def verdict_of(text: str, latex: str) -> Verdict:
    (record,) = (each for each in verify_text(text).equations if each.latex.strip() == latex)
    return record.verdict


@pytest.mark.parametrize("place", ["before", "behind", "far above"])
@pytest.mark.parametrize(("sentence", "usual", "other", "latex"), DEFINED)
def test_a_name_is_what_its_sentence_says(sentence: str, usual: str, other: str, latex: str, place: str) -> None:
    def written(words: str) -> str:
        said = sentence.format(words)
        parts = [said, shown(latex)] if place != "behind" else [shown(latex), said]
        return page(*parts) if place != "far above" else page(said, *["Words that say nothing."] * 9, shown(latex))

    assert verdict_of(written(usual), latex) in HOLDS
    assert verdict_of(written(other), latex) is Verdict.UNCHECKED


def test_what_the_front_matter_binds_is_checked() -> None:
    text = page("Let $P_1$ be the middle of the first link.", shown(f"P_1 = {ELBOW}"))
    bound = text.replace("arm: planar_2r", "arm: planar_2r\nquantities: {P_1: {origin: 1}}")
    assert verdict_of(bound, f"P_1 = {ELBOW}") in HOLDS


def test_a_name_has_its_usual_meaning_again_where_a_later_section_says_so() -> None:
    first = ("# One", "Let $P_1$ be the middle of the first link.", shown(f"P_1 = {ELBOW}"))
    latex = f"P_1 = {ELBOW} + 0"
    again = page(*first, "# Two", "Let $P_1$ be the end of the first link.", shown(latex))
    assert verdict_of(again, latex) in HOLDS
    assert verdict_of(page(*first, "# Two", "Differentiation is next.", shown(latex)), latex) is Verdict.UNCHECKED


def test_all_that_is_in_another_frame_is_open_on_the_whole_page() -> None:
    latex = r"v = \begin{bmatrix} -l_1 s_1 \dot\theta_1 - l_2 s_{12} (\dot\theta_1 + \dot\theta_2) \\ l_1 c_1 \dot\theta_1 + l_2 c_{12} (\dot\theta_1 + \dot\theta_2) \\ 0 \end{bmatrix}"
    for frame, wanted in (("base", HOLDS), ("tool", (Verdict.UNCHECKED,))):
        said = f"All vectors on this page are given in the frame of the {frame}."
        assert verdict_of(page(said, *["Words that say nothing."] * 9, shown(latex)), latex) in wanted


def test_a_rate_follows_the_name_that_has_no_value() -> None:
    of_error = page(shown("x_e = x_d - l_1 c_1 - l_2 c_{12}"), "The target is fixed.", shown(r"\dot x_e = \dot x"))
    assert verdict_of(of_error, r"\dot x_e = \dot x") is Verdict.UNCHECKED
    of_tool = page(shown("x_e = l_1 c_1 + l_2 c_{12}"), shown(r"\dot x_e = \dot x"))
    assert verdict_of(of_tool, r"\dot x_e = \dot x") in HOLDS


CYLINDER = """
| i | theta | d | a | alpha |
|---|---|---|---|---|
| 1 | $\\theta_1$ | $d_1$ | 0 | 0 |
| 2 | 0 | $q_2$ | 0 | $-90°$ |
| 3 | 0 | $q_3$ | 0 | 0 |

"""


def test_a_usual_name_is_not_usual_behind_a_formula_without_a_value() -> None:
    claim = "x^2 + y^2 = q_3^2"
    shifted = r"x = g\cos\theta_1 - q_3\sin\theta_1, \qquad y = g\sin\theta_1 + q_3\cos\theta_1"
    assert verdict_of(CYLINDER + shown(claim), claim) is Verdict.PROVED
    assert verdict_of(CYLINDER + shown(shifted) + "\n\n" + shown(claim), claim) is Verdict.UNCHECKED
