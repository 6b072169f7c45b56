"""Sums and products with limits are read as their terms, and left as they stand where that is not clear."""

import pytest

from armproof.models.catalogue import load_arm
from armproof.verification.check import verify_text
from armproof.verification.equations.series import MOST_READ, written_out
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

NAMES = Names(load_arm("planar_3r"))


def read(latex: str) -> n.Statement:
    (statement,) = Reader().read(latex)
    return written_out(statement, latex, NAMES)


@pytest.mark.parametrize(
    ("latex", "terms"),
    [
        (r"\sum_{i=1}^{2} l_i \cos\theta_i", r"l_1 \cos\theta_1 + l_2 \cos\theta_2"),
        (r"\sum\limits_{i=0}^{n-1} {l_{i+1}}", r"l_1 + l_2 + l_3"),
        (
            r"a \sum^2_{i=1} \cos\left(\sum_{j=1}^{i} \theta_j\right) b",
            r"a (\cos(\theta_1) b + \cos(\theta_1 + \theta_2) b)",
        ),
        (r"\prod_{i=1}^3 {}^{i-1}T_{i}", r"{}^0T_1 {}^1T_2 {}^2T_3"),
        (r"\sum_{k=1}^{2} z_{k-1} \times p_k", r"z_0 \times p_1 + z_1 \times p_2"),
        (r"\sum_{i=1}^{2} (i - 1) l_i / i", r"((1) - 1) l_1 / (1) + ((2) - 1) l_2 / (2)"),
    ],
)
def test_terms_are_those_of_each_number(latex: str, terms: str) -> None:
    assert not any(isinstance(below, n.Dots) for below in n.walk(read(latex)))
    assert written(read(latex)) == written(read(terms))


def written(node: n.Node) -> list[str]:
    """The letters and functions of a tree in their order, whatever brackets stand around them."""
    kept = (below for below in n.walk(node) if isinstance(below, n.Name | n.Call | n.Number))
    return [getattr(each, "key", None) or getattr(each, "function", None) or str(each.value) for each in kept]


@pytest.mark.parametrize(
    "latex",
    [
        r"\sum_i l_i", r"\sum_{i=1}^{m} l_i", r"\sum_{i=2}^{1} l_i", r"\sum_{i=1}^{2}", r"\sum_{i=1}^{2} l_{2i}",
        r"\sum_{i=1}^{2} \sum_{i=1}^{2} l_i", r"\prod_{i=1}^{2} l_i l_3", r"\prod_{i=1}^{2} z_i \times p", r"\int_0^1 x",
        r"\sum_{i=1}^{2} - l_i", r"\sum_{i=0}^{2} l_{i-1}", r"\sum_{i=1}^{99} i", r"\cos\sum_{i=1}^{2} \theta_i",
    ],
)  # fmt: skip
def test_what_is_not_clear_stays(latex: str) -> None:
    assert any(isinstance(below, n.Dots) for below in n.walk(read(latex)))


def test_sums_in_sums_have_a_bound() -> None:
    deep = "".join(rf"\sum_{{{letter}=1}}^{{12}} " for letter in "ijkm")
    assert len([*n.walk(read(f"{deep} i j k m"))]) < 20 * MOST_READ


def test_n_is_the_number_of_joints_unless_the_document_says_otherwise() -> None:
    page = "---\narm: planar_3r\n---\n\n{}$$ \\phi = \\sum_{{i=1}}^n \\theta_i $$\n"
    assert verify_text(page.format("")).equations[-1].verdict is Verdict.PROVED
    assert verify_text(page.format("$$ n = l_1 $$\n\n")).equations[-1].verdict is Verdict.UNCHECKED
