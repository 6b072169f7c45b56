"""The writer changes what has changed and nothing else, and what it writes is read as it was meant."""

from __future__ import annotations

from fractions import Fraction

import pytest

from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.latex.writer import Notation, Writer, number, symbol_as_latex

LINES = [
    r"l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2)",
    r"\left( X^2 + Y^2 \right) \cdot \dfrac{1}{2a_1a_2}",
    r"\mathbf{Rot}_{x_i}(\alpha_i) \cdot \mathbf{Trans}_{z_i}(d_i)",
    r"{}^0\mathbf{T}_1 \, {}^1\mathbf{T}_2",
    r"\left. \det(J) \right|_{\theta_2 = 0, l_1 = l_2}",
    r"\underbrace{(a_1 + a_2 C_2)}_{k_1} S_1",
    r"\begin{bmatrix} C\theta_1 & -S\theta_1 \\ S\theta_1 & C\theta_1 \end{bmatrix}^T",
    r"\operatorname{atan2}(\sqrt{1 - c_2^2}, c_2)",
    r"\frac{\partial^2 u}{\partial t^2}",
    r"\frac{d^2u}{dt^2}",
    r"z_0 \times (p_4 - p_0)",
    r"4t_f^{3} - (8v_f + 12v_0)t_f",
]
every_line = pytest.mark.parametrize("latex", LINES)


def read(latex: str) -> n.Node:
    return Reader().read_expression(latex)


def changed(latex: str, old: str, new: n.Node) -> str:
    """Write a formula in which the part spelled `old` is replaced."""
    root = read(latex)
    target = next(node for node in n.walk(root) if latex[slice(*node.span)].strip() == old)
    return Writer(latex, root, Notation()).write(n.substitute(root, target, new))


@every_line
def test_an_unchanged_formula_is_copied(latex: str) -> None:
    root = read(latex)
    assert Writer(latex, root, Notation()).write(root) == latex


@every_line
def test_a_changed_leaf_leaves_the_rest_as_it_stands(latex: str) -> None:
    root = read(latex)
    moved = {id(side) for node in n.walk(root) if isinstance(node, n.At) for value in node.values for side in value}
    tried = 0
    for leaf in n.walk(root):
        if isinstance(leaf, n.Number) and id(leaf) not in moved:
            start, end = leaf.span
            other = n.Number(Fraction(7), "7", span=leaf.span)
            assert Writer(latex, root, Notation()).write(n.substitute(root, leaf, other)) in (
                f"{latex[:start]}7{latex[end:]}",
                f"{latex[:start]}{{7}}{latex[end:]}",
            )
            tried += 1
    assert tried or not any(isinstance(node, n.Number) for node in n.walk(root)) or moved


@pytest.mark.parametrize(
    ("latex", "old", "new", "expected"),
    [
        ("a_1 b_1", "b_1", "a_2 + a_3", "a_1 (a_2 + a_3)"),
        ("a_1 - b_1", "b_1", "a_2 + a_3", "a_1 - (a_2 + a_3)"),
        ("b_1^2", "b_1", "a_2 + a_3", "(a_2 + a_3)^2"),
        ("b_1^2", "b_1", "a_2 a_3", "(a_2 a_3)^2"),
        (r"\frac{b_1}{2}", "b_1", "a_2 + a_3", r"\frac{a_2 + a_3}{2}"),
        ("b_1/2", "b_1", "a_2 + a_3", "(a_2 + a_3)/2"),
        (r"z_0 \times b_1", "b_1", "a_2 a_3", r"z_0 \times (a_2 a_3)"),
        (r"\cos\theta_1", r"\theta_1", r"\theta_1 + \theta_2", r"\cos(\theta_1 + \theta_2)"),
        ("t^3", "3", r"\frac{1}{2}", r"t^{\frac{1}{2}}"),
        ("b_1^T", "b_1", "a_2 + a_3", "(a_2 + a_3)^T"),
    ],
)
def test_brackets_stand_where_they_are_needed(latex: str, old: str, new: str, expected: str) -> None:
    assert changed(latex, old, read(new)) == expected


@pytest.mark.parametrize(
    ("base", "expected"),
    [
        ("r", "r^{2}"),
        ("C_1", "C_1^{2}"),
        (r"c_{\theta_1}", r"c_{\theta_1}^{2}"),
        (r"C\theta_1", r"(C\theta_1)^{2}"),
        (r"\cos\theta_1", r"(\cos\theta_1)^{2}"),
        ("T_1", "(T_1)^{2}"),
        ("{}^0T_1", "({}^0T_1)^{2}"),
        ("d_3^*", "(d_3^*)^{2}"),
        ("a + b", "(a + b)^{2}"),
    ],
)
def test_a_square_is_no_index_and_no_angle_is_squared(base: str, expected: str) -> None:
    node = read(base)
    square = n.Power(node, n.Number(Fraction(2), "2"))
    text = Writer(base, node, Notation()).write(square)
    assert text == expected
    again = read(text)
    assert isinstance(again, n.Power)
    inner = again.base.inner if isinstance(again.base, n.Group) else again.base
    assert inner == node


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        ("C12 + S1", "S12 + S1"),
        ("C_{12} + S_1", "S_{12} + S_1"),
        (r"\sin^2(\theta_1)", r"(\cos(\theta_1))^{2}"),
        (r"s_{\theta_1}", r"c_{\theta_1}"),
    ],
)
def test_the_other_function_is_written_in_the_same_style(latex: str, expected: str) -> None:
    from armproof.verification.diagnosis.slips import Letters, single_edits

    root = read(latex)
    texts = [
        Writer(latex, root, Notation()).write(edit.node)
        for edit in single_edits(root, Letters((1, 2)))
        if edit.kind == "function"
    ]
    assert expected in texts


def test_a_letter_does_not_run_into_a_macro() -> None:
    assert read(changed(r"\dot\theta_1 b", "b", read("a"))) == read(r"\dot\theta_1 a")
    assert changed(r"2\pi a_1", r"\pi", read("r")) == "2r a_1"
    assert read(changed(r"r a_1", "r", read(r"\pi"))) == read(r"\pi a_1")


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (Fraction(3), "3"),
        (Fraction(-1, 2), r"-\frac{1}{2}"),
        (Fraction(27, 500), "0.054"),
        (Fraction(1, 3), r"\frac{1}{3}"),
        (Fraction(-7, 20), "-0.35"),
        (Fraction(22, 21), r"\frac{22}{21}"),
    ],
)
def test_numbers_are_written_as_people_write_them(value: Fraction, expected: str) -> None:
    assert number(value) == expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("theta_1", r"\theta_1"),
        ("theta_12", r"\theta_{12}"),
        ("a_3", "a_3"),
        ("dot theta_1", r"\dot{\theta}_1"),
        ("dot dot q_2", r"\ddot{q}_2"),
        ("r", "r"),
    ],
)
def test_symbols_are_written_in_latex(name: str, expected: str) -> None:
    assert symbol_as_latex(name) == expected


@pytest.mark.parametrize(
    ("latex", "cosine"),
    [
        ("C_{12}", "C_1"),
        ("s_{12}", "c_1"),
        ("S12", "C1"),
        (r"\cos(\theta_2)", r"\cos(\theta_1)"),
        (r"\sin\theta_2", r"\cos(\theta_1)"),
        (r"C\theta_2", r"C\theta_1"),
        (r"S(\theta_2)", r"C(\theta_1)"),
        (r"c_{\theta_2}", r"c_{\theta_1}"),
        (r"\sin^2(\theta_2)", r"\cos(\theta_1)"),
    ],
)
def test_a_notation_is_learnt_from_one_function(latex: str, cosine: str) -> None:
    root = read(latex)
    call = next(node for node in n.walk(root) if isinstance(node, n.Call))
    notation = Notation()
    notation.learn(call, latex)
    assert notation.trig("cos", {"theta_1": Fraction(1)}) == cosine


@pytest.mark.parametrize("style", ["index", "macro()", "letter", "letter()", "script"])
@pytest.mark.parametrize(
    "angle", [{"theta_1": 1}, {"theta_1": 1, "theta_2": 1}, {"theta_1": 1, "theta_2": -1}, {"theta_1": 2, "theta_3": 1}]
)
def test_a_function_of_any_angle_is_read_back(style: str, angle: dict[str, int]) -> None:
    notation = Notation(style=style, cosine="\\cos" if style == "macro()" else "C")
    text = notation.trig("sin", {name: Fraction(size) for name, size in angle.items()})
    node = read(text)
    assert isinstance(node, n.Call)
    assert node.function == "sin"


def test_a_derivative_of_higher_order_has_it_above_and_below() -> None:
    second = read(r"\frac{d^2u}{dt^2}")
    assert isinstance(second, n.Derivative) and second.order == 2
    for other in (r"\frac{d^2u}{dt^3}", r"\frac{du}{dt^2}", r"\frac{d^2u}{dt}", r"\frac{a^2u}{at^2}"):
        assert isinstance(read(other), n.Quotient)
