"""MathML from the expression tree: every type of node, every spelling, every character escaped, wrong parts marked."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest

from armproof.verification.document import read_document
from armproof.verification.latex import items
from armproof.verification.latex import nodes as n
from armproof.verification.latex.mathml.display import pieces, write_display
from armproof.verification.latex.mathml.marks import RIGHT, WRONG
from armproof.verification.latex.mathml.writer import WIDEST, MathWriter
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.reading import read_names
from tests.verification.latex.test_layouts import LAYOUTS

HANDOUTS = sorted((Path(__file__).resolve().parents[3] / "course" / "handouts").glob("*.md"))
READ = Reader().read


def markup(latex: str, **marked: object) -> str:
    return "".join(piece.markup for piece in pieces(write_display(latex, READ, **marked)))  # type: ignore[arg-type]


def text(latex: str) -> str:
    """Return what a display shows, without the elements."""
    return unescape(re.sub(r"<[^>]*>", "", markup(latex))).replace("\u2002", " ").strip()


def tree(written: str) -> ElementTree.Element:
    return ElementTree.fromstring(f"<m>{written}</m>")


def kinds(cls: type = n.Node) -> Iterator[type]:
    for kind in cls.__subclasses__():
        # a dataclass with slots is made anew: the first of that name is no type of the tree
        if any(vars(module).get(kind.__name__) is kind for module in (n, items)):
            yield kind
            yield from kinds(kind)


def test_every_type_of_node_is_written() -> None:
    found = set(kinds())
    assert {n.Matrix, n.At, n.Labelled, n.Cases, n.Connective, items.Differential} <= found
    assert found == set(MathWriter("", READ).methods)


def test_a_type_of_node_that_is_new_is_noticed() -> None:
    @dataclass(frozen=True)
    class Novelty(n.Node):
        pass

    with pytest.raises(KeyError):
        MathWriter("", READ).write(Novelty())


SHOWN = [
    (r"{}^0T_4 = A^0_1 A_2^{1}", "T40=A10A21"), (r"\dot\theta_1^2 \ddot{d}_3", "θ˙12d¨3"), (r"p_{4,x}'", "p′4,x"),
    (r"\cos\theta_1 \sin(\theta_1 + \theta_2)", "cosθ1sin(θ1+θ2)"), (r"\sin^2\theta_1 + \cos^{2}(\theta_1)", "sin2θ1+cos2(θ1)"),
    (r"c_{12} S_1 C_{1-2}", "c12S1C1−2"), (r"C\theta_1 S(\theta_1+\theta_2)", "Cθ1S(θ1+θ2)"), (r"c_{\theta_1}", "cθ1"),
    (r"\pm\sqrt{1 - D^2} \mp 1", "±1−D2∓1"), (r"\frac{a}{b} + a/b + \dfrac12", "ab+a/b+12"), (r"J^T J^{-1} J^{-T} J^{+}", "JTJ−1J−TJ+"),
    (r"\det(J) = |J| = \begin{vmatrix} a & b \\ c & d \end{vmatrix}", "det(J)=|J|=|abcd|"), (r"\operatorname{rank} J = 2", "rankJ=2"),
    (r"\theta_1 = \operatorname{atan2}(y, x)", "θ1=atan2(y,x)"), (r"\underbrace{J}_{6 \times 4}", "J⏟6×4"), (r"\overbrace{a + b}^{r}", "a+b⏞r"),
    (r"\left. J \right|_{\theta_2 = 0, a_1 = a_2}", "J|θ2=0,a1=a2"), (r"\frac{\partial p_x}{\partial\theta_1} = \frac{d}{dt}(x)", "∂px∂θ1=ddt(x)"),
    (r"0_{3\times 1}", "03×1"), (r"R_{z,\theta_1} R_x(\pi) \mathrm{Rot}(z, \theta_1)", "Rz,θ1Rx(π)Rot(z,θ1)"), (r"J(q) \dot{q}", "J(q)q˙"),
    (r"\{a, b\}", "{a,b}"), (r"[q_1 \; q_2]^T", "[q1q2]T"), (r"x \in [0, 1]", "x∈[0,1]"), (r"a_1 \neq a_2 \Rightarrow x > 0", "a1≠a2⇒x>0"),
    (r"\sin\theta_2 = 0 \iff \theta_2 = 0 \text{ or } \theta_2 = \pi", "sinθ2=0⇔θ2=0 or θ2=π"), (r"90^\circ", "90°"), (r"\prod_{i=1}^{n} A_i", "∏ i=1  n Ai"),
    (r"A_1 \cdots A_n \ddots", "A1⋯An⋱"), (r"x = \begin{cases} a & \text{if } \sigma_i = 0 \\ b & \sigma_i = 1 \end{cases}", "x={a if σi=0bσi=1"),
    (r"z \times p \cdot q", "z×p⋅q"), (r"0{,}5", "0,5"), (r"a/2b", "a/2b"), (r"\alpha_{i-1} T_{tool} q_{ij}", "αi−1Ttoolqij"), (r"\theta_1^* = 0", "θ1=0"),
]  # fmt: skip


@pytest.mark.parametrize(("latex", "shown"), SHOWN)
def test_a_display_shows_what_it_says(latex: str, shown: str) -> None:
    assert text(latex) == shown


def test_the_letters_of_a_matrix_stand_in_its_cells() -> None:
    root = tree(markup(r"T = \begin{bmatrix} a & b + c \\ 0 & 1 \end{bmatrix}"))
    cells = [["".join(cell.itertext()) for cell in row] for row in root.iter("mtr")]
    assert cells == [["a", "b+c"], ["0", "1"]]


@pytest.mark.parametrize("path", HANDOUTS, ids=lambda path: path.stem)
def test_every_display_of_the_handouts_is_well_formed_and_without_latex(path: Path) -> None:
    document = read_document(path)
    arm = document.front.get("arm")
    from armproof.models.catalogue import load_arm

    read = read_names(load_arm(arm, path.parent) if arm else None, document.front).reader.read
    assert document.displays or path.stem == "not-equations"
    for display in document.displays:
        for piece in pieces(write_display(display.latex, read)):
            root = tree(piece.markup)
            assert not re.search(r"[\\$&]|\bbegin\b", "".join(root.itertext())), display.line
            assert all(len(list(e)) == _CHILDREN[e.tag] for e in root.iter() if e.tag in _CHILDREN), display.line


_CHILDREN = {"msub": 2, "msup": 2, "msubsup": 3, "mfrac": 2, "munder": 2, "mover": 2, "munderover": 3}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_layout_is_written(layout: str) -> None:
    shown = text(layout % ("l_7", "l_8"))
    assert "x" in shown and "l7" in shown and "l8" in shown and not re.search(r"[\\$&]", shown)


@pytest.mark.parametrize(
    "latex",
    [
        r"\text{<script>alert(1)</script>} x = 1",
        r"x_{<b>} = 1",
        r'a = \text{" onload="x}',
        r"a < b > c",
        r"x = \text{a & b}",
    ],
)
def test_html_in_latex_is_text(latex: str) -> None:
    try:
        written = markup(latex)
    except Exception as error:
        assert type(error).__name__ == "ReadError"
        return
    root = tree(written)
    assert all(element.tag.startswith("m") for element in root.iter())
    assert all(name in _ATTRIBUTES for element in root.iter() for name in element.attrib)


_ATTRIBUTES = {"class", "aria-label", "mathvariant", "fence", "form", "stretchy", "accent", "width", "lspace", "rspace"}


def test_a_wrong_cell_carries_outline_sign_and_label() -> None:
    latex = r"J = \begin{bmatrix} a & b \\ c & d \end{bmatrix}"
    at = latex.index("b \\\\")
    root = tree(markup(latex, spans=[(at, at + 1)], mark=WRONG))
    (cell,) = root.iterfind(".//*[@class='wrong']")
    assert (cell.tag, cell.get("aria-label"), "".join(cell.itertext())) == ("mtd", "wrong entry", "b✗")
    assert not list(tree(markup(latex)).iterfind(".//*[@class='wrong']"))


def test_a_wrong_side_is_marked_as_a_whole_and_new_cells_each() -> None:
    root = tree(markup("x = a + b", spans=[(4, 9)], mark=WRONG))
    (side,) = root.iterfind(".//*[@class='wrong']")
    assert "".join(side.itertext()) == "a+b✗"
    latex = r"x = \begin{bmatrix} R & t \\ 0 & 1 \end{bmatrix}"
    span = (latex.index("t \\\\"), latex.index(" \\end"))
    root = tree(markup(latex, spans=[span], mark=RIGHT))
    assert ["".join(cell.itertext()) for cell in root.iterfind(".//*[@class='right']")] == ["t✓", "0✓", "1✓"]


def test_a_wide_matrix_breaks_its_long_sums_and_a_narrow_one_does_not() -> None:
    long = " + ".join(f"a_{k} b_{k} c_{k} d_{k}" for k in range(1, 9))
    wide = rf"x = \begin{{bmatrix}} {long} & {long} \\ 0 & 1 \end{{bmatrix}}"
    found = pieces(write_display(wide, READ))
    assert max(piece.width for piece in found) <= 1.3 * WIDEST
    assert sum(piece.markup.count("<mtable") for piece in found) > 1
    assert markup(r"x = \begin{bmatrix} a + b & c \end{bmatrix}").count("<mtable") == 1
    assert len(pieces(write_display(f"x = {long} + {long}", READ))) > 1
    assert text(f"x = {long}").replace(" ", "") == f"x={long}".replace(" ", "").replace("_", "")


def test_equations_side_by_side_are_statements_of_one_line_and_rows_are_lines() -> None:
    assert [len(line) for line in write_display(r"a = 1, \quad b = 2 \\ c = 3", READ)] == [2, 1]
