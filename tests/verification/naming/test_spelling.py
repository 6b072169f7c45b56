"""How a document spells: which script before a letter names the reference, as its products show."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.document import parse_document
from armproof.verification.naming.reading import spelling_of


@pytest.mark.parametrize(
    ("latex", "below"),
    [
        (r"{}_0^2T = {}_0^1T {}_1^2T", True),
        (r"{}_{0}^{EE}T = {}_{0}^{1}T \times {}_{1}^{EE}T", True),
        (r"{}^2_0\mathbf{T} = {}^1_0\mathbf{T} \cdot {}^2_1\mathbf{T}", True),
        (r"{}^0_2T = {}^0_1T {}^1_2T", False),
        (r"{}_2^0T = {}_1^0T {}_2^1T", False),
        (r"{}_0^1T = A", False),  # may be the pose of frame 0 in frame 1
        (r"{}_0^2T = {}_0^1T {}_1^2T, \quad {}^0_3T = {}^0_1T {}^1_3T", False),  # both
        (r"{}^0_2T = {}^0_1T(\theta_1) \cdot {}^1_2T(\theta_2)", False),
        (r"{}_0^2T = {}_0^1T(\theta_1) \cdot {}_1^2T(\theta_2)", True),
        ("{}^0_1T^{-1} \\cdot {}^0_2T = {}^1_2T $$\n\n$$ {}^0_1T \\cdot A = B", False),  # of two displays
    ],
)
def test_products_tell_which_script_names_the_reference(latex: str, below: bool) -> None:
    document = parse_document(Path("page.md"), f"$$ {latex} $$\n")
    assert spelling_of(document, frozenset()).reference_below is below


LINK = r"\begin{bmatrix} c_1 & -s_1 & 0 & l_1 c_1 \\ s_1 & c_1 & 0 & l_1 s_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"


@pytest.mark.parametrize(
    ("product", "verdict"), [("{}_0^2T = {}_0^1T {}_1^2T", "proved"), ("{}^0_2T = {}^0_1T {}^1_2T", "refuted")]
)
def test_a_link_matrix_is_read_as_the_products_show(product: str, verdict: str) -> None:
    text = f"---\narm: planar_2r\n---\n\n$$ {{}}_0^1T = {LINK} $$\n\n$$ {product} $$\n"
    first, second = verify_text(text).equations
    assert first.verdict == verdict
    assert second.verdict == "proved"


LETTERS = (
    r"\begin{bmatrix} r_{11} & r_{12} & r_{13} \\ r_{21} & r_{22} & r_{23} \\ r_{31} & r_{32} & r_{33} \end{bmatrix}"
)


@pytest.mark.parametrize(("claim", "verdict"), [("r_{11} = c_2", "proved"), ("r_{12} = s_2", "refuted")])
def test_letters_mean_the_entries_of_the_matrix_they_were_equated_to_last(claim: str, verdict: str) -> None:
    text = f"---\narm: planar_2r\n---\n\n$$ R_2^0 = {LETTERS} $$\n\n$$ r_{{11}} = c_{{12}} $$\n\n"
    result = verify_text(text + f"$$ R_2^1 = {LETTERS} $$\n\n$$ {claim} $$\n")
    assert [each.verdict for each in result.equations[1::2]] == ["proved", verdict]


def test_letters_of_an_unknown_matrix_mean_nothing_known() -> None:
    text = f"---\narm: planar_2r\n---\n\n$$ R_2^0 = {LETTERS} $$\n\n$$ W = 2 $$\n\n$$ W = {LETTERS} $$\n\n"
    (claim,) = verify_text(text + "$$ r_{12} = c_2 s_1 $$\n").equations[3:]
    assert claim.verdict == "unchecked"


@pytest.mark.parametrize(
    ("claim", "verdicts"),
    [
        (r"\theta_2 = \theta_2^{(+)}", {"confirmed"}),
        (r"\cos \theta_2^{(-)} = D", {"proved"}),
        (r"\cos \theta_2^{(-)} = -D", {"refuted"}),
        (r"\theta_1^{(+)} = \theta_1", {"defined", "unchecked"}),  # whose branch it is nobody says
    ],
)
def test_a_sign_in_parentheses_names_the_solution_of_a_branch(claim: str, verdicts: set[str]) -> None:
    solutions = (
        r"$$ D = \frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2} $$" + "\n\n"
        r"$$ \theta_2^{(+)} = \operatorname{atan2}(\sqrt{1 - D^2}, D), \quad \theta_2^{(-)} = -\theta_2^{(+)} $$"
        + "\n\n"
    )
    result = verify_text(f"---\narm: planar_2r\n---\n\n{solutions}$$ {claim} $$\n\n$$ q \\longmapsto (x, y) $$\n")
    assert result.equations[2].verdict.value in verdicts
    assert result.equations[3].verdict.value == "unchecked"
