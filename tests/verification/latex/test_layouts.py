"""Displays that hold several equations, chains, words, and equations that begin or end in odd places."""

from collections.abc import Callable
from typing import Any

import pytest

from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]

ARM: dict[str, Any] = {
    "dh": "classic",
    "rows": [
        {"a": "a_1", "alpha": 0, "d": 0, "theta": "theta_1"},
        {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"},
    ],
}
BOUND = {"x": {"origin": 2, "component": "x"}, "y": {"origin": 2, "component": "y"}}
X, Y = r"a_1\cos\theta_1 + a_2\cos(\theta_1+\theta_2)", r"a_1\sin\theta_1 + a_2\sin(\theta_1+\theta_2)"
SLIP = r"a_1\sin\theta_1 - a_2\sin(\theta_1+\theta_2)"

LAYOUTS = [
    r"x = %s, \quad y = %s", r"x = %s \qquad y = %s", r"x = %s \\ y = %s", "x = %s\\\\\ny = %s", r"x = %s,\; y = %s", r"x=%s ; y=%s",
    r"\begin{aligned} x &= %s \\ y &= %s \end{aligned}", r"\begin{align} x = & %s, \\ y = & %s. \end{align}", r"\begin{align*} & x = %s \\ & y = %s \end{align*}",
    r"\begin{split} x &= %s \\ y &= %s \end{split}", r"\begin{gathered} x = %s \\ y = %s \end{gathered}", r"\begin{cases} x = %s \\ y = %s \end{cases}",
    r"\begin{equation} \begin{aligned} x &= %s \\ y &= %s \end{aligned} \end{equation}", r"\begin{equation*} x = %s, y = %s \end{equation*}",
    r"\left\{\begin{array}{l} x = %s \\ y = %s \end{array}\right.", r"\left\{ \begin{aligned} x &= %s \\ y &= %s \end{aligned} \right.",
    r"\left\{\begin{array}{rcl} x & = & %s \\ y & = & %s \end{array}\right.", r"\begin{array}{l} x = %s \\ \\ y = %s \end{array}",
    r"\begin{eqnarray} x &=& %s \\ y &=& %s \end{eqnarray}", r"\begin{cases} x = %s & (1) \\ y = %s & (2) \end{cases}",
    r"x = %s \quad \text{and} \quad y = %s", r"\boxed{x = %s} \quad \boxed{y = %s}", r"x = %s \tag{1} \\ y = %s \tag{2}", r"x = %s \hspace{2cm} y = %s",
    r"\begin{bmatrix} x \\ y \end{bmatrix} = \begin{bmatrix} %s \\ %s \end{bmatrix}", r"(x, y) = (%s, %s)", r"\begin{aligned}[t] x &= %s && \\ y &= %s && \end{aligned}",
    r"\begin{pmatrix} x \\[1em] y \end{pmatrix} = \begin{pmatrix} %s \\[1em] %s \end{pmatrix}", r"\therefore x = %s \text{ und } y = %s",
]  # fmt: skip


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_equation_of_a_display_is_checked(judge: Judge, layout: str) -> None:
    assert judge(layout % (X, Y), arm=ARM, quantities=BOUND).verdict is Verdict.PROVED
    assert judge(layout % (X, SLIP), arm=ARM, quantities=BOUND).verdict is Verdict.REFUTED


CHAINS = [
    r"{}^0T_2 = A_1 A_2 = %s", r"{}^0T_2 = A_1 A_2 \\ = %s", r"\begin{aligned} {}^0T_2 &= A_1 A_2 \\ &= %s \end{aligned}", r"A_1A_2 = %s",
    r"\begin{aligned} & A_1 A_2 \\ & = %s \end{aligned}", r"{}^0T_2 =& A_1 A_2 \\ =& %s", r"{}^0T_2 \equiv A_1 A_2 := %s", r"{}^0_2T=_1^0T_2^1T= %s",
    r"\begin{aligned} {}^0T_2 =& A_1 A_2 \\ &= %s \end{aligned}", r"\Rightarrow {}^0T_2 = %s", r"{}^0T_2 \triangleq %s", r"{}^0T_2 \overset{\text{def}}{=} %s",
    r"\to{}^0_2T = %s", r"%s = {}^0T_2",
]  # fmt: skip
POSE = r"\begin{bmatrix} c_{12} & -s_{12} & 0 & a_1c_1+a_2c_{12} \\ s_{12} & c_{12} & 0 & a_1s_1 + a_2%s_{12} \\ 0&0&1&0 \\ 0&0&0&1 \end{bmatrix}"


@pytest.mark.parametrize("chain", CHAINS)
def test_every_link_of_a_chain_is_checked(judge: Judge, chain: str) -> None:
    assert judge(chain % (POSE % "s"), arm=ARM).verdict is Verdict.PROVED
    record = judge(chain % (POSE % "c"), arm=ARM)
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(2, 4)]


def test_what_is_asked_for_claims_nothing(judge: Judge) -> None:
    for mark in "!?":
        for entry in "sc":
            display = rf"{{}}^0T_2 \overset{{{mark}}}{{=}} " + POSE % entry
            assert judge(display, arm=ARM).verdict is Verdict.UNCHECKED


def test_a_display_that_begins_with_a_relation_goes_on_with_the_one_before(judge: Judge) -> None:
    assert judge(r"{}^0T_2 = A_1 A_2", "= " + POSE % "s", arm=ARM).verdict is Verdict.PROVED
    assert judge(r"{}^0T_2 = A_1 A_2", "= " + POSE % "c", arm=ARM).verdict is Verdict.REFUTED


def test_a_line_that_begins_with_a_sign_goes_on_with_the_sum(judge: Judge) -> None:
    lines = r"\begin{aligned} x &= a_1\cos\theta_1 \\ &%s a_2\cos(\theta_1+\theta_2) \end{aligned}"
    assert judge(lines % "+", arm=ARM, quantities=BOUND).verdict is Verdict.PROVED
    assert judge(lines % "-", arm=ARM, quantities=BOUND).verdict is Verdict.REFUTED


def test_a_line_with_a_sign_and_a_relation_is_an_equation(judge: Judge) -> None:
    assert judge(rf"x = {X} \\ -y = -a_1s_1 - a_2s_{{12}}", arm=ARM, quantities=BOUND).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    "display",
    [
        r"\theta_1 = 0", r"\theta_1 = 30^\circ,\ \theta_2 = -45°", r"(\theta_1, \theta_2) = (-0.785, 5.498)", r"\theta_1 = 30^\circ = \frac{\pi}{6}\,\text{rad}",
        r"a_1 = 300\,\text{mm}", r"a_1 = 0.3 \text{ m}", r"\theta_2 = \cos^{-1}(0.5) = 60^\circ", r"x = 0.5, \quad y = 0.3", r"T = A_1 A_2 \cdots A_n",
        r"T^0_n = \prod_i A_i", r"{}^0T_6 = \sum_{i=1}^6 {^{i-1}}T_i", r"R \in SO(3)", r"T = e^{[S_1]\theta_1} e^{[S_2]\theta_2} M", r"-\pi \le \theta_1 \le \pi",
        r"{}^0T_2 = \begin{bmatrix} \cdots & a_1c_1 \\ \vdots & \ddots \end{bmatrix}", r"w = \sqrt{\det(J J^T)}", r"\text{where } \alpha_i \text{ is the twist}",
    ],
)  # fmt: skip
def test_data_patterns_and_words_claim_nothing(judge: Judge, display: str) -> None:
    assert not judge(display, arm=ARM, quantities=BOUND).is_decided


@pytest.mark.parametrize(
    "display",
    [
        r"\tau = J^T(q)\,\mathcal{F} + \lambda u", r"T(\theta) = \exp([S_1]\theta_1) M", r"\lim_{\theta_2 \to 0} \det J = 0", r"x \lVert r \rVert = 1",
        r"\theta_1 = \begin{cases} \operatorname{atan2}(y,x) & \text{if } x > 0 \\ \pi & \text{otherwise} \end{cases}", r"\delta Y = \frac{\partial F}{\partial \theta} \delta\theta",
        r"x + u = \max(u, v)",
    ],
)  # fmt: skip
def test_what_is_not_bound_is_read_and_left_open(judge: Judge, display: str) -> None:
    assert not judge(display, arm=ARM, quantities=BOUND).is_decided


@pytest.mark.parametrize(
    "marked", [r"{\color{red} c_1}", r"\color{blue}{c_1}", r"\textcolor{red}{c_1}", r"\underbrace{c_1}_{r}", r"\Large c_1", r"c_1\;\checkmark", r"c_1\phantom{-}"]
)  # fmt: skip
def test_decoration_changes_nothing(judge: Judge, marked: str) -> None:
    assert judge(rf"{marked} = \cos\theta_1", arm=ARM).verdict is Verdict.PROVED
    assert judge(rf"{marked} = \sin\theta_1", arm=ARM).verdict is Verdict.REFUTED


@pytest.mark.parametrize(("bound", "length"), [("0", 1), ("3 s_4", 2), ("2 a s_4", 3)])
def test_what_stands_before_a_brace_is_the_whole_bound(bound: str, length: int) -> None:
    brace = r"\left\{ \begin{aligned} \theta_4 &= a \\ \theta_6 &= b \end{aligned} \right."
    condition, _, first, again, *_ = Reader().read(rf"\text{{if }} s_5 < {bound} {brace}")
    assert isinstance(condition, n.Chain) and isinstance(again, n.Chain) and isinstance(first, n.Chain)
    for each in (condition, again):
        last = each.members[-1]
        assert len(last.factors if isinstance(last, n.Product) else [last]) == length
