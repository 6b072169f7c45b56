"""Displays as people write them: escapes, layout, words, units and overlays are read; what is false in them is still refuted."""

import contextlib
import re
import time

import pytest

from armproof.verification.check import verify_text
from armproof.verification.errors import ReadError
from armproof.verification.latex.preparing import prepared
from armproof.verification.latex.reader import Reader
from armproof.verification.verdict import Verdict

FRONT = r"""---
arm: {dh: classic, rows: [{a: l_1, alpha: 0, d: 0, theta: theta_1}, {a: l_2, alpha: 0, d: 0, theta: theta_2}]}
quantities: {p_x: {origin: 2, component: x}, p_y: {origin: 2, component: y}}
---
"""


def verdict_of(latex: str) -> Verdict:
    (record,) = verify_text(f"{FRONT}\n$$\n{latex}\n$$\n").equations
    return record.verdict


# how it is written, what is true between « and », and what replaces it in a false twin
WRITTEN = {
    "escaped indices": (r"p\_x = l\_1 \cos\theta\_1 «+» l\_2\cos(\theta\_1+\theta\_2)", "-"),
    "escaped stars": (r"p_x = l_1\*\cos(\theta_1) «+» l_2 \* \cos(\theta_1+\theta_2)", "-"),
    "escaped parentheses": (r"p_x = l_1 \cos\(\theta_1\) «+» l_2\cos\left\(\theta_1+\theta_2\right\)", "-"),
    "four backslashes": (r"\begin{bmatrix} p_x \\\\ p_y \end{bmatrix} = \begin{bmatrix} l_1 c_1 + l_2 c_{12} \\\\ l_1 s_1 «+» l_2 s_{12} \end{bmatrix}", "-"),
    "every backslash twice": (r"\\begin{bmatrix} p_x \\\\ p_y \\end{bmatrix} = \\begin{bmatrix} l_1 c_1 «+» l_2 c_{12} \\\\ l_1 \\sin\\theta_1 + l_2 s_{12} \\end{bmatrix}", "-"),
    "a root of parentheses": (r"\sqrt(p_x^2+p_y^2) = \sqrt{l_1^2+l_2^2 «+» 2 l_1 l_2 \cos\theta_2}", "-"),
    "a root without index": (r"\sqrt[]{p_x^2+p_y^2} = \sqrt[2]{l_1^2+l_2^2 «+» 2 l_1 l_2 \cos\theta_2}", "-"),
    "a bold command": (r"\bold{p_x} = l_1 c_1 «+» l_2 c_{12}", "-"),
    "a bracket within an index": (r"p_x = l_1 c_1 «+» l_2 \cos(\theta_1 + \theta_{2)}", "-"),
    "braces round it": (r"{p_x = l_1 c_1 «+» l_2 c_{12}}", "-"),
    "braces round lines": (r"{\large \begin{aligned} p_x &= l_1 c_1 «+» l_2 c_{12} \\ p_y &= l_1 s_1 + l_2 s_{12} \end{aligned}}", "-"),
    "a colour": (r"\color{red}{p_x = l_1 c_1 «+» \textcolor{blue}{l_2 c_{12}}}", "-"),
    "blank lines": ("p_x = l_1 c_1\n\n «+» l_2 c_{12}\n", "-"),
    "spacing of columns": (r"\arraycolsep=1.4pt\def\arraystretch{2.2} p_x = l_1 c_1 «+» l_2 c_{12}", "-"),
    "a stretch": (r"\renewcommand{\arraystretch}{1.5} p_x = l_1 c_1 «+» l_2 c_{12}", "-"),
    "lengths of layout": (r"\newlength{\mine}\settowidth{\mine}{$-$}\setlength\arraycolsep{2pt} p_x = \hphantom{-}l_1 c_1 «+» l_2 c_{12}", "-"),
    "a box": (r"\resizebox{\textwidth}{!}{$ p_x = l_1 c_1 «+» l_2 c_{12} $}", "-"),
    "empty scripts": (r"p_{x}^{} = l_1 c_1 «+» l_2 c_{12}_{}", "-"),
    "atan2 in three parts": (r"\theta_1 = a \tan 2(p_y, p_x) «-» a \tan 2\left(l_2 s_2, l_1 + l_2 c_2\right)", "+"),
    "letters set apart": (r"\theta_1 + \theta_2 = \operatorname{A t a n} 2 (s_{12}, «+»c_{12})", "-"),
    "a cosine set apart": (r"p_x = l_1 \mathrm{c o s}(\theta_1) «+» l_2 c_{12}", "-"),
    "a brace of lines": (r"\left\{\begin{matrix} p_x = l_1 c_1 «+» l_2 c_{12} \\ p_y = l_1 s_1 + l_2 s_{12} \end{matrix}\right.", "-"),
    "frames in brackets": (r"R[0,1] R[1,2] = «»R[0,2]", "-"),
    "a vector of two points": (r"O_0O_{2(0)} = \begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 «+» l_2 s_{12} \\ 0 \end{bmatrix}", "-"),
    "an axis in a frame": (r"z_{1(0)} = \begin{bmatrix} 0 \\ 0 \\ «1» \end{bmatrix}", "-1"),
    "angles added below": (r"p_x = l_1 c_{q_1} «+» l_2 c_{q_1 q_2}", "-"),
    "a number before parentheses": (r"\sin 2 (\theta_1) = «+»2 \sin\theta_1\cos\theta_1", "-"),
    "a sentence with a formula": (r"p_x = l_1 c_1 + D \quad\text{with $D = «+»l_2 c_{12}$, where $l_1$ is a length}", "-"),
    "words between": (r"p_x = l_1 c_1 + l_2 c_{12} \\ \text{thus } = l_2 c_{12} «+» l_1 c_1", "-"),
    "bare words": (r"where p_x = l_1 c_1 «+» l_2 c_{12}", "-"),
    "degrees": (r"\cos(\theta_1 + \ang{90}) = «-»\sin\theta_1", ""),
    "quantities": (r"\SI{500}{\milli\metre} = \qty{«0».5}{m}", "1"),
    "numbers": (r"\cos\ang{60} = \num{«5»e-1}", "6"),
    "an overlay": (r"\only<1>{p_x = 3}\only<2->{p_x = l_1 c_1 «+» l_2 c_{12}}", "-"),
    "an overlay that ends": (r"\only<1-2>{p_x = 3}\only<3->{p_x = l_1 c_1 «+» l_2 c_{12}}", "-"),
    "an overlay that ends before another": (r"\only<1-2>{p_x = 3}\only<3-11>{p_x = l_1 c_1 «+» l_2 c_{12}}", "-"),
    "alternatives of an overlay": (r"p_x = \alt<2>{l_1 c_1}{?} \onslide<2-> «+» \uncover<2->{\alert<3>{l_2 c_{12}}} \pause", "-"),
    "French": (r"p_x = l_1 c_1 + D \text{ où } D = «+»l_2 c_{12}", "-"),
    "French conditions": (r"\text{si } \theta_2 = 0 \text{ alors } p_x = (l_1 «+» l_2) c_1", "-"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRITTEN)
def test_what_people_write_is_read_and_its_false_twin_refuted(name: str):
    latex, wrong = WRITTEN[name]
    before, right, after = re.split("[«»]", latex)
    assert verdict_of(before + right + after) is Verdict.PROVED
    assert verdict_of(before + wrong + after) is Verdict.REFUTED


OPEN = {
    "a name in words": r"\text{MGD}_{\text{pos}} = \begin{bmatrix} l_1 c_1 - l_2 c_{12} \\ 0 \end{bmatrix}",
    "a word before =": r"p_y = l_1 s_1 + l_2 s_{12} \\ \text{Position} = l_1 c_1",
    "words are no product": r"\text{mass} \times \text{acceleration} = \frac{\text{distance}}{\text{time}}",
    "a bare word": r"elbow = up",
    "an angle of points": r"\angle ABC = \theta_2",
    "a counted solution": r"\theta_2^{(2)} = -\theta_2^{(1)}",
    "a root of another order": r"\sqrt[3]{p_x^3} = p_y",
    "letters apart": r"p_x = m m m^2 + l_1 c_1",
}


@pytest.mark.parametrize("name", OPEN)
def test_what_cannot_be_known_is_neither_proved_nor_refuted(name: str):
    assert verdict_of(OPEN[name]) in (Verdict.UNCHECKED, Verdict.UNREADABLE)


@pytest.mark.parametrize(
    "latex", [r"\frac{}{2} = 1", r"x = \foo{1}", r"\num{abc} = 1", r"x = l_1\_ ", r"a = \sqrt[3](x)", r"\only<1>{x = 1"]
)
def test_what_is_no_formula_stays_unreadable(latex: str):
    with pytest.raises(ReadError):
        Reader().read(latex)


@pytest.mark.parametrize("latex", [*(latex for latex, _ in WRITTEN.values()), *OPEN.values(), "a\n\\phantom{\nb}\n c"])
def test_every_character_keeps_its_place(latex: str):
    found = prepared(latex)
    assert len(found) == len(latex)
    assert [k for k, c in enumerate(found) if c == "\n"] == [k for k, c in enumerate(latex) if c == "\n"]


@pytest.mark.parametrize(
    "latex",
    [r"\only<1>{" * 10_000 + "}" * 10_000, r"\alt<1>{a}{" * 5_000, r"\makebox[" * 10_000, r"\scalebox{" * 10_000,
     r"\text{a $" * 10_000, r"\text{" * 10_000, "{" * 20_000, r"{a=b}" * 10_000, r"\setlength{\x}{{" * 5_000, r"\abs{" * 20_000,
     r"\newcommand\x[" * 7_000, "_{" * 40_000, "a" * 90_000, r"\SI{" * 20_000],
)  # fmt: skip
def test_nothing_takes_long_to_be_refused(latex: str):
    started = time.process_time()
    with contextlib.suppress(ReadError):
        Reader().read(latex)
    assert time.process_time() - started < 2
