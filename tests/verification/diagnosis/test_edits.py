"""Small slips: each changes the formula, is spelled as a person would spell it, and can be taken back by another."""

from __future__ import annotations

import pytest

from armproof.verification.diagnosis.slips import Edit, Letters, single_edits
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.latex.writer import Notation, Writer

FORMULAS = [
    r"l_1 C_1 + l_2 C_{12}",
    r"-S_1(S_{23}d_3 - C_2a_3)",
    r"a_1 \cos\theta_1 + a_2 \cos(\theta_1 + \theta_2)",
    r"\frac{-r\sin\theta}{1 + r^2}",
    r"(l_1 l_2 \sin\theta_2)^2",
    r"c_{\theta_1} s_{\theta_2}",
    r"4 a_1^2 a_2^2 (\sin\theta_2)^2",
    r"\left. \frac{\partial p}{\partial t} \right|_{t = t_f}",
]
every_formula = pytest.mark.parametrize("latex", FORMULAS)


def read(latex: str) -> n.Node:
    return Reader().read_expression(latex)


def names(*latex: str) -> tuple[n.Name, ...]:
    nodes = [read(text) for text in latex]
    return tuple(node for node in nodes if isinstance(node, n.Name))


LETTERS = Letters((1, 2, 3), names(r"\theta_1", r"\theta_2", r"\theta_3"), names("l_1", "l_2", "a_3", "d_3"))


def edits(latex: str) -> list[Edit]:
    return list(single_edits(read(latex), LETTERS))


def written(latex: str) -> set[str]:
    """Return the LaTeX of every slip."""
    root = read(latex)
    return {Writer(latex, root, Notation()).write(edit.node) for edit in single_edits(root, LETTERS)}


@every_formula
def test_every_slip_changes_the_formula(latex: str) -> None:
    root = read(latex)
    found = edits(latex)
    assert found
    assert [str(edit.finding) for edit in found if edit.node == root] == []


@every_formula
def test_every_slip_can_be_read_again_as_it_was_meant(latex: str) -> None:
    root = read(latex)
    for edit in single_edits(root, LETTERS):
        text = Writer(latex, root, Notation()).write(edit.node)
        assert flat(read(text)) == flat(edit.node), (str(edit.finding), text)


@every_formula
def test_a_slip_leaves_the_original_alone(latex: str) -> None:
    root = read(latex)
    before = repr(root)
    list(single_edits(root, LETTERS))
    assert repr(root) == before


@pytest.mark.parametrize(
    ("latex", "slip", "kind"),
    [
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1 - l_2 C_{12}", "sign"),
        ("l_1 C_1 + l_2 C_{12}", "-l_1 C_1 - l_2 C_{12}", "sign"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 S_1 + l_2 C_{12}", "function"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1 + l_2 C_{13}", "index"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1 + l_2 C_2", "index"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1 + l_2 C_{123}", "index"),
        ("l_1 C_1 + l_2 C_{12}", "l_2 C_1 + l_1 C_{12}", "length"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1 + d_3 C_{12}", "length"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1 + C_{12}", "factor"),
        ("l_1 C_1 + l_2 C_{12}", "l_1 C_1", "term"),
        ("C_1 + l_2 C_{12}", "l_1 C_1 + l_2 C_{12}", "factor"),
        ("2 a_3", "4 a_3", "number"),
        ("r^2", "r", "number"),
        ("a_3", "a_3^{2}", "number"),
        (r"C_1", r"C_1^2", "number"),
        (r"\cos(\theta_1 + \theta_2)", r"\cos(\theta_1 - \theta_2)", "sign"),
        (r"\cos\theta_1", r"\cos\theta_2", "index"),
        (r"\cos\theta_1", r"\cos(\theta_1 + \theta_2)", "index"),
    ],
)
def test_the_usual_slips_are_among_them(latex: str, slip: str, kind: str) -> None:
    wanted = flat(read(slip))
    assert kind in {edit.kind for edit in edits(latex) if flat(edit.node) == wanted}


@pytest.mark.parametrize(
    ("right", "wrong"),
    [("l_1 C_1 + l_2 C_{12}", "l_1 C_1 + l_2 C_2"), ("-a_3 S_1", "a_3 S_1"), ("S_{23}d_3", "C_{23}d_3")],
)
def test_a_slip_is_mended_by_a_slip(right: str, wrong: str) -> None:
    assert flat(read(wrong)) in [flat(edit.node) for edit in edits(right)]
    assert flat(read(right)) in [flat(edit.node) for edit in edits(wrong)]


def test_no_angle_is_squared_and_none_is_multiplied_by_a_length() -> None:
    for edit in edits(r"l_1 \sin(\theta_1 + \theta_2)"):
        calls = [node for node in n.walk(edit.node) if isinstance(node, n.Call)]
        assert not any(
            isinstance(below, n.Power | n.Product) for call in calls for below in n.walk(call.arguments[0])
        ), str(edit.finding)


def test_a_sine_keeps_its_spelling() -> None:
    assert {r"\cos^{2}(\theta_2)", r"(\cos(\theta_2))^{2}"} & written(r"\sin^2(\theta_2)")
    assert r"S\theta_1" in written(r"C\theta_1")
    assert "C12" in written("S12")


def flat(node: n.Node) -> n.Node:
    """Return a tree without brackets that change nothing, products and sums in one level, numbers in front as factors."""
    if isinstance(node, n.Group):
        return flat(node.inner)
    if isinstance(node, n.Product):
        factors: list[n.Node] = []
        for factor in map(flat, node.factors):
            factors.extend(factor.factors if isinstance(factor, n.Product) else (factor,))
        return n.Product(tuple(factors), ("",) * (len(factors) - 1))
    if isinstance(node, n.Sum):
        terms: list[tuple[str, n.Node]] = []
        for sign, term in node.terms:
            inner = flat(term)
            below = inner.terms if isinstance(inner, n.Sum) else (("+", inner),)
            terms.extend((sign if s == "+" else {"+": "-", "-": "+"}[sign], t) for s, t in below)
        return terms[0][1] if len(terms) == 1 and terms[0][0] == "+" else n.Sum(tuple(terms))
    changes = {}
    for name in ("base", "exponent", "numerator", "denominator", "inner", "operand", "variable"):
        child = getattr(node, name, None)
        if isinstance(child, n.Node):
            changes[name] = flat(child)
    if isinstance(node, n.Call):
        changes["arguments"] = tuple(flat(argument) for argument in node.arguments)  # type: ignore[assignment]
    if isinstance(node, n.At):
        changes["values"] = tuple((flat(a), flat(b)) for a, b in node.values)  # type: ignore[assignment]
    if isinstance(node, n.Number) and node.value.denominator != 1:
        return n.Quotient(
            n.Number(node.value.__class__(node.value.numerator)), n.Number(node.value.__class__(node.value.denominator))
        )
    from dataclasses import replace

    return replace(node, **changes) if changes else node
