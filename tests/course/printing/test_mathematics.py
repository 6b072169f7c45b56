"""The mathematics of a sheet: what the tree says is what is typeset, and a wide matrix stays whole."""

from __future__ import annotations

import io

import pytest

from armproof.course.printing.mathematics import quoted, typst_mathematics
from armproof.verification.latex.mathml.display import pieces, write_display
from armproof.verification.latex.reader import Reader


def typeset(latex: str) -> str:
    return " ".join(typst_mathematics(piece.markup) for piece in pieces(write_display(latex, Reader().read)))


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\theta_1", 'attach(θ, b: "1")'),
        (r"{}^0T_4", 'attach(T, tl: "0", b: "4")'),
        (r"\frac{a}{b}", "frac(a, b)"),
        (r"\dot\theta_1", 'attach(accent(θ, dot), b: "1")'),
        (r"\vec{z}", "accent(z, arrow)"),
        (r"\mathbf{q}", 'bold(upright("q"))'),
        (r"J'_P", "attach(J, b: P, t: prime)"),
        (r"a \wedge b", "a∧b"),
        (r"\lVert x \rVert", "lr(‖x‖)"),
    ],
)
def test_a_formula_keeps_its_notation(latex: str, expected: str):
    assert typeset(latex) == expected


def test_two_letters_are_not_read_as_one_name():
    assert typeset("a b") == "a b"
    assert typeset("ab") == "a b"


def test_a_sign_that_typst_has_a_meaning_for_is_escaped():
    assert "/" not in typeset("a/b").replace("\\/", "")
    assert quoted('say "\\#x"\n') == '"say \\"\\\\#x\\" "'


def test_markup_that_the_tree_is_never_written_in_is_refused():
    with pytest.raises(ValueError, match="no <script> is known"):
        typst_mathematics("<script>x</script>")
    with pytest.raises(ValueError, match="not well-formed"):
        typst_mathematics("<mi>x")


def test_a_matrix_wider_than_the_page_is_made_smaller_and_stays_whole(document, pdf_text):
    entry = "a + b + c + d + e"
    row = " & ".join(f"{entry} + {k}" for k in range(11, 17))
    body = r"$$ M = \begin{bmatrix} %s \end{bmatrix} $$" % r" \\ ".join([row] * 6)
    text = pdf_text(document(body, front="---\ntitle: Wide\n---\n\n"))
    for k in range(11, 17):
        assert text.replace("\n", "").count(str(k)) >= 6


def test_what_is_scaled_would_else_be_cut_off(document, make, monkeypatch):
    pytest.importorskip("typst", reason="the extra 'print' is not installed")
    pypdf = pytest.importorskip("pypdf", reason="pypdf reads the sheets back")
    from armproof.course.printing.printing import render
    from tests.course.printing.test_handouts import off_the_page  # the same measure as for the handouts

    row = " & ".join(f"a + b + c + d + e + f + {k}" for k in range(11, 17))
    body = r"$$ M = \begin{bmatrix} %s \end{bmatrix} $$" % r" \\ ".join([row] * 6)
    pdf = render(make(document(body, front="---\ntitle: Wide\n---\n\n")), "pdf")
    assert len(pypdf.PdfReader(io.BytesIO(pdf)).pages) == 1
    assert off_the_page(pdf) == []
