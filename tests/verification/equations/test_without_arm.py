"""Without an arm a slip is told where both sides share their letters; what may be meant otherwise is left open."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof import verify_text
from armproof.verification.verdict import DocumentResult


@pytest.mark.parametrize(
    ("displays", "verdicts"),
    [
        ([r"\cos^2\alpha + \sin^2\alpha = 1"], "proved"),
        ([r"\cos^2\alpha + \sin^2\alpha = 2"], "unchecked"),
        ([r"\cos^2\alpha - \sin^2\alpha = \cos(2\alpha)"], "proved"),
        ([r"\cos^2\alpha - \sin^2\alpha = \sin(2\alpha)"], "refuted"),
        ([r"\sin(a+b) = \sin a \cos b - \cos a \sin b"], "refuted"),
        ([r"\sin(a+b) = \sin a \cos b + \cos a \sin b"], "proved"),
        ([r"\sin a = \cos b"], "unchecked"),
        ([r"x = l \cos a"], "unchecked"),
        ([r"\cos a = 0.5"], "unchecked"),
        ([r"c^2 = a^2 + b^2 - 2ab\cos\gamma"], "unchecked"),
        (["(a+b)^2 = a^2 + 2ab + b^2"], "proved"),
        (["(a+b)^2 = a^2 + b^2"], "refuted"),
        (["a b = b c"], "unchecked"),
        (["F = m a"], "unchecked"),
        (["lcosa = l\\cos a"], "proved"),  # a function is spelt within
        (["lcosa = l\\sin a"], "refuted"),
        (["a + b = 0"], "unchecked"),
        ([r"R_z(\theta) = \begin{bmatrix}\cos\theta & -\sin\theta & 0\\ \sin\theta & \cos\theta & 0\\0&0&1\end{bmatrix}"], "proved"),
        ([r"R_z(\theta) = \begin{bmatrix}\cos\theta & \sin\theta & 0\\ \sin\theta & \cos\theta & 0\\0&0&1\end{bmatrix}"], "refuted"),
        ([r"\operatorname{Rot}_x(\alpha)\operatorname{Rot}_x(\beta) = \operatorname{Rot}_x(\alpha - \beta)"], "refuted"),
        ([r"\operatorname{Rot}_x(\alpha)\operatorname{Rot}_x(\beta) = \operatorname{Rot}_x(\alpha + \beta)"], "proved"),
        ([r"\begin{bmatrix}a & b\end{bmatrix}\begin{bmatrix}c\\ d\end{bmatrix} = ac + bd"], "proved"),
        ([r"\begin{bmatrix}a & b\end{bmatrix}\begin{bmatrix}c\\ d\end{bmatrix} = ac - bd"], "refuted"),
        ([r"u = l\cos a + m\sin a", r"u^2 = l^2\cos^2 a + m^2\sin^2 a"], "defined refuted"),
        ([r"u = l\cos a + m\sin a", r"u^2 = l^2\cos^2 a + m^2\sin^2 a + 2 l m \sin a\cos a"], "defined proved"),
        ([r"u = l\cos a", r"u = l\sin a"], "unchecked unchecked"),
        ([r"u = l\cos a", r"u = l\cos a"], "unchecked unchecked"),
        ([r"u = l\cos a", r"2u = 2l\sin a"], "unchecked unchecked"),
        ([r"u = l\cos a", r"2u = 2l\cos a", r"2u = 2l\sin a"], "defined proved refuted"),
        ([r"u = l\cos a", r"2u = 2l\cos a"], "defined proved"),
        ([r"u = l\cos a", "2u = 5"], "unchecked unchecked"),
        ([r"u = l \cos a", "u = 5"], "unchecked unchecked"),
        ([r"u = l\cos a", "u = 0"], "unchecked unchecked"),
        ([r"u = l\cos a", "u + w = 3 g"], "unchecked unchecked"),
        ([r"u = \cos a", r"u^2 + \sin^2 a = 1"], "defined proved"),
        ([r"u = \cos a", r"u^2 + \sin^2 a = 2"], "unchecked unchecked"),
        ([r"B = \begin{bmatrix}\cos a & -\sin a\\ \sin a & \cos a\end{bmatrix}", r"B^T B = \begin{bmatrix}1&0\\0&1\end{bmatrix}", r"B^T B = \begin{bmatrix}1&0\\0&2\end{bmatrix}", r"\det B = 1", r"\det B = 2", r"\det B = 0", r"B^2 = \begin{bmatrix}\cos 2a & -\sin 2a\\ \sin 2a & \cos 2a\end{bmatrix}", r"B^2 = \begin{bmatrix}\cos 2a & \sin 2a\\ \sin 2a & \cos 2a\end{bmatrix}"], "defined proved unchecked proved unchecked refuted proved refuted"),
        ([r"Q = \begin{bmatrix} n_x & o_x & a_x\\ n_y & o_y & a_y\\ n_z & o_z & a_z\end{bmatrix}", r"Q^T Q = \begin{bmatrix}1&0&0\\0&1&0\\0&0&1\end{bmatrix}", r"Q^{-1} = \begin{bmatrix} n_x & n_y & n_z\\ o_x & o_y & o_z\\ a_x & a_y & a_z\end{bmatrix}", r"\det Q = 1", r"\begin{bmatrix} n_x & o_x & a_x\\ n_y & o_y & a_y\\ n_z & o_z & a_z\end{bmatrix} = \begin{bmatrix} n_x & n_y & n_z\\ o_x & o_y & o_z\\ a_x & a_y & a_z\end{bmatrix}"], "unchecked unchecked unchecked unchecked refuted"),
        ([r"Q = \begin{bmatrix} r_{11} & r_{12} & r_{13}\\ r_{21} & r_{22} & r_{23}\\ r_{31}&r_{32}&r_{33}\end{bmatrix}", "Q^{-1} = Q^T", "Q Q = Q^T"], "unchecked unchecked unchecked"),
        ([r"Q = \begin{bmatrix} k_{11} & k_{12} & k_{13}\\ k_{21} & k_{22} & k_{23}\\ k_{31}&k_{32}&k_{33}\end{bmatrix}", "Q^{-1} = Q^T", "Q Q = Q^T"], "unchecked unchecked unchecked"),
        ([r"u = l\cos a", r"v = l\sin a", "u^2 + v^2 = l^2", "u^2 - v^2 = l^2", "u^2+v^2 = m^2", r"u v = l^2 \sin a\cos a", r"u v = l^2 \sin a\cos a = 2", "u = v = l", r"uv = l^2\cos a\cos a"], "defined defined proved unchecked unchecked proved unchecked unchecked unchecked"),
        ([r"x = l\cos a + m\cos(a+b)", r"x^2 = l^2 + m^2 + 2lm\cos b"], "unchecked unchecked"),
        ([r"\begin{bmatrix}\cos a\\ \sin a\end{bmatrix} = \begin{bmatrix}\sin a\\ \cos a\end{bmatrix}"], "refuted"),
        ([r"\begin{bmatrix} x\\ y\end{bmatrix} = \begin{bmatrix} l\cos a\\ l\sin a\end{bmatrix}", r"x = l \cos a", r"x = l \sin a", "x^2 + y^2 = l^2", "x^2 - y^2 = l^2"], "defined proved unchecked proved unchecked"),
        ([r"\begin{bmatrix} a\\ b\end{bmatrix} = \begin{bmatrix} b\\ a\end{bmatrix}"], "refuted"),
        ([r"\cos^2 a + \sin^2 a = 1 = 2"], "unchecked"),
        ([r"\tan a = \frac{\sin a}{\cos a}"], "proved"),
        ([r"\tan a = \frac{\cos a}{\sin a}"], "refuted"),
        (["{}^0T_2 = {}^0T_1 {}^1T_2"], "proved"),
        (["{}^0T_2 = {}^1T_2 {}^0T_1"], "unchecked"),
        ([r"u = \sqrt{a^2+b^2}", "u^2 = a^2 - b^2", "u^2 = a^2 + b^2"], "defined refuted proved"),
    ],
    ids=lambda part: part[-1] if isinstance(part, list) else "",
)  # fmt: skip
def test_only_a_slip_is_refuted_without_an_arm(
    check: Callable[..., DocumentResult], displays: list[str], verdicts: str
) -> None:
    assert " ".join(record.verdict.value for record in check(*displays, arm=None).equations) == verdicts


@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        (r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} = \begin{bmatrix} 1 & 2 \end{bmatrix}", "refuted"),
        (r"\cos(\alpha + \beta) = \cos\alpha \cos\beta + \sin\alpha \sin\beta", "refuted"),
        (r"\cos\theta - \sin\theta = 0", "unchecked"),
        (r"\begin{bmatrix} \cos\theta & \sin\theta \end{bmatrix} = \begin{bmatrix} 0 & 0 \end{bmatrix}", "unchecked"),
    ],
)
def test_an_erratum_is_said_to_be_more_than_a_slip_and_a_condition_is_none(display: str, verdict: str) -> None:
    (record,) = verify_text(f"> **Erratum**\n> $$ {display} $$\n").equations
    assert record.verdict.value == verdict


def test_an_erratum_whose_sizes_convention_alone_tells_is_left_open() -> None:
    text = "---\narm: planar_2r\n---\n> **Erratum**\n> $$ p_2 = J $$\n"
    assert verify_text(text).equations[0].verdict.value == "unchecked"


REACH = [r"r = e + a\cos\alpha + b\cos\beta", r"u = r\cos\psi", r"v = r\sin\psi"]


@pytest.mark.parametrize(
    ("root", "verdict"),
    [
        (r"r = \sqrt{u^2 + v^2}", "confirmed"),
        (r"r = \sqrt{u^2 - v^2}", "unchecked"),
        (r"r = -\sqrt{u^2 + v^2}", "unchecked"),
    ],
)
def test_a_reach_is_its_root_where_the_arm_reaches_forwards(root: str, verdict: str) -> None:
    text = "\n\n".join(f"$$ {each} $$" for each in (*REACH, root))
    found = [each.verdict.value for each in verify_text(text).equations]
    assert found[-1] == verdict and "refuted" not in found


@pytest.mark.parametrize(
    ("cosine", "side", "verdict"),
    [
        (r"\cos\eta = \frac{a^2 + D^2 - b^2}{2 a D}", r"b^2 = a^2 + D^2 - 2 a D\cos\eta", "proved"),
        (r"\cos\eta = \frac{a^2 + D^2 - b^2}{2 a D}", r"b^2 = a^2 + D^2 + 2 a D\cos\eta", "unchecked"),
        (r"\cos\zeta_1 = \frac{a^2 + D^2 - b^2}{2 a D}", r"b^2 = a^2 + D^2 - 2 a D\cos\zeta_1", "unchecked"),
    ],
)
def test_an_angle_that_stands_nowhere_above_is_defined_by_its_cosine(cosine: str, side: str, verdict: str) -> None:
    text = "\n\n".join(f"$$ {each} $$" for each in (r"D = \sqrt{u^2 + v^2}", cosine, side))
    assert verify_text(text).equations[-1].verdict.value == verdict


def test_a_law_of_any_frames_shows_no_matrix_to_be_right() -> None:
    printed = r"{}^bT_e(q) = \begin{bmatrix} 0 & s_1 & c_1 & a_1 c_1 \\ 0 & -c_1 & s_1 & a_1 + s_1 \\ 1 & 0 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    law = r"{}^bT_e(q) = {}^bT_0 {}^0T_n(q) {}^nT_e"
    records = verify_text(f"# One bar\n\n$$ {printed} $$\n\n$$ {law} $$\n").equations
    assert [record.verdict.value for record in records] == ["unchecked", "proved"]
