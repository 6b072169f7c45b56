"""The reader says where and at which token it gives up; nothing is executed, nothing hangs."""

import time
from collections.abc import Callable

import pytest

from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.preparing import prepared
from armproof.verification.latex.reader import Reader, key_as_latex
from armproof.verification.latex.tokens import Spelling
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]


def read(latex: str) -> list[n.Statement]:
    return Reader().read(latex)


@pytest.mark.parametrize(
    ("latex", "offset", "message"),
    [
        (r"a + = b", 4, "unexpected '='; expected"),
        (r"/ a = b", 0, "unexpected '/'; expected"),
        (r"(a + b", 0, r"'\(' is opened here and never closed"),
        (r"a = b \left( c + d \\ e = f", 6, r"'\(' is opened here and never closed"),
        (r"\begin{bmatrix} (a & b \\ c & d \end{bmatrix}", 16, r"'\(' is opened here and never closed"),
        (r"\begin{bmatrix} a & b] \\ c & d \end{bmatrix}", 21, r"unexpected '\]': it closes what was never opened"),
        (r"a + b)", 5, r"unexpected '\)'"),
        (r"\begin{bmatrix} 1 & 2", 21, "the display ends too early"),
        (r"x = \begin{bmatrix} 1 \end{pmatrix}", 22, r"'\\begin\{bmatrix\}' is closed by '\\end\{pmatrix\}'"),
        (r"x = \begin{tikzpicture} 1 \end{tikzpicture}", 4, "environment 'tikzpicture' is not read; those that are:"),
        (r"x = \input{/etc/passwd}", 4, r"'\\input' is not a command of kinematic LaTeX"),
        (r"x = \write18{ls}", 4, r"'\\write' is not a command"),
        (r"x = {a", 6, "the display ends too early; expected '}'"),
        (r"x_", 1, "'_' at the end of the display has no script"),
        (r"x = \cos", 4, r"'\\cos' has no argument"),
        (r"x = \sqrt[3]{a}", 4, "only square roots are read"),
        (r"x = a^{99}", 5, "the exponent 99 is larger than 24"),
        (r"x = \frac{}{2}", 9, "an argument is empty"),
        (r"x == y", 3, "two relations one after the other at '='"),
        (
            r"\begin{bmatrix} a & \\ 1 & 2 \end{bmatrix}",
            0,
            "a cell of a matrix is empty: write 0 where a zero is meant",
        ),
    ],
)
def test_an_error_names_the_place_and_the_token(latex: str, offset: int, message: str) -> None:
    with pytest.raises(ReadError, match=message) as caught:
        read(latex)
    assert caught.value.offset == offset


def test_cells_left_empty_between_dots_are_dots() -> None:
    (chain,) = read(r"J = \begin{bmatrix} a & \cdots & b \\ \vdots & & \vdots \\ c & \cdots & d \end{bmatrix}")
    assert isinstance(chain, n.Chain)
    matrix = chain.members[1]
    assert isinstance(matrix, n.Matrix) and all(isinstance(cell, n.Dots) for cell in matrix.rows[1])
    with pytest.raises(ReadError, match="empty"):
        read(r"D = \begin{bmatrix} a & 0 \\ \ddots & \end{bmatrix} + \begin{bmatrix} a & \\ 1 & \ddots \end{bmatrix}")


@pytest.mark.parametrize("blank", [r"\,", r"\;", r"\ ", "~"])
def test_scripts_behind_a_blank_are_those_of_the_transform_that_follows(blank: str) -> None:
    (chain,) = read(rf"^{{0}}T_2 = ^{{0}}T_1(q_1){blank}^{{1}}\mathbf T_2(q_2)")
    assert [each.pre_sup for each in n.names(chain) if each.base == "T"] == ["0", "0", "1"]
    (square,) = read(rf"x = (a + b){blank}^2 T")
    assert not any(each.pre_sup for each in n.names(square))
    (transposed,) = read(rf"x = (R_1){blank}^T R_2")
    assert not any(each.pre_sup for each in n.names(transposed))


@pytest.mark.parametrize("primes", [r"q^{\prime\prime}", r"q^{\prime \prime}", r"q^{''}", "q''"])
def test_a_prime_is_a_prime_however_it_is_set(primes: str) -> None:
    (chain,) = read(primes)
    assert isinstance(chain, n.Chain)
    (name,) = chain.members
    assert isinstance(name, n.Name) and (name.primes, name.sup) == (2, "")


def test_what_prints_nothing_leaves_every_character_at_its_place() -> None:
    for latex in (r"a \not= b", r"a \not = b", r"\{a\}", r"\displaystyle a"):
        assert len(prepared(latex)) == len(latex)
    assert prepared(r"a \not= b").split() == ["a", r"\ne", "b"]


def test_a_cell_of_two_expressions_is_told_at_the_second() -> None:
    latex = r"\begin{bmatrix} a & b : cd \\ 0 & 1 \end{bmatrix}"
    with pytest.raises(ReadError) as caught:
        read(latex)
    assert latex[caught.value.offset :].startswith((":", "cd"))


def test_a_place_is_told_by_line_and_column(judge: Judge) -> None:
    record = judge("\\begin{aligned}\nx &= 1 \\\\\ny &= \\foo\n\\end{aligned}")
    assert record.verdict is Verdict.UNREADABLE
    assert record.message.startswith("line 4, column 6 of the display: '\\foo' is not a command")


@pytest.mark.parametrize(
    "latex",
    [
        "__import__('os').system('true')", "x = " + "{" * 10_000 + "1" + "}" * 10_000, "x = " + "(" * 5_000, "a+" * 40_000 + "a", "x = " + "9" * 5_000,
        "\\left(" * 500, "\\frac{1}" * 200, "^" * 1000, "\\begin{bmatrix}" * 100, "x" + "'" * 2000, "{}^0" * 300, "x = " + "a |b| " * 3_500, "\x00\x01", "x = {^{^{^{^a}}}}T",
    ],
)  # fmt: skip
def test_hostile_displays_end_quickly_and_without_a_traceback(judge: Judge, latex: str) -> None:
    started = time.thread_time()
    assert judge(latex).verdict in (Verdict.UNREADABLE, Verdict.UNCHECKED, Verdict.DEFINED)
    assert time.thread_time() - started < 2.0


@pytest.mark.parametrize(
    ("latex", "key"),
    [
        (r"{}^0T_1", "{}^0T_1"), (r"{}^{0}_{1}T", "{}^0_1T"), (r"T^0_1", "T_1^0"), (r"J'_P", "J'_P"), (r"J_{\omega}", "J_omega"), (r"P_{0,G}^0", "P_0,G^0"),
        (r"\dot{q}_1", "dot q_1"), (r"\mathbf{J}_v", "J_v"), (r"\vec{p}_3", "p_3"), (r"p_{x}", "p_x"), (r"{}^0P_{3ORG}", "{}^0P_3ORG"), (r"\bm{R}_{3\times 3}", "R"),
        (r"\theta_1^*", "theta_1"), (r"\varphi", "phi"), (r"\ell_2", "l_2"), (r"T_{\text{tool}}", "T_tool"), (r"{\bf z}_0", "z_0"), (r"z_{n-1}", "z_n-1"),
    ],
)  # fmt: skip
def test_a_name_has_one_key_in_every_style(latex: str, key: str) -> None:
    node = Reader().read_expression(latex)
    assert isinstance(node, n.Name)
    assert node.key == key


@pytest.mark.parametrize(
    ("key", "latex"),
    [
        ("theta_12", r"\theta_{12}"),
        ("T_w^tool", "T_w^{tool}"),
        ("J'_P", "J'_P"),
        ("{}^0P_{1,G}", "{}^0P_{1,G}"),
        ("{}^0P", "{}^0P"),
        ("p_x", "p_x"),
    ],
)
def test_a_front_matter_name_is_written_as_latex(key: str, latex: str) -> None:
    assert key_as_latex(key) == latex


@pytest.mark.parametrize(
    ("latex", "verdict", "message"),
    [
        (r"c_2 = 2a_1c_2/2a_1", Verdict.PROVED, "all that follows the slash taken as the denominator"),
        (r"c_2s_2 = 2c_2/2 s_2", Verdict.PROVED, "the slash dividing by the next factor alone"),
        (r"c_1 = s_1/2a_1", Verdict.REFUTED, "is s_1/2a_1, should be c_1"),
    ],
)
def test_a_slash_before_a_product_has_two_readings_and_the_message_names_the_choice(
    judge: Judge, latex: str, verdict: Verdict, message: str
) -> None:
    record = judge(latex)
    assert record.verdict is verdict
    assert message in record.message


@pytest.mark.parametrize(
    ("latex", "name"),
    [
        (r"\lambda^2", r"\lambda"),
        (r"\lambda^{2}", r"\lambda"),
        (r"\lambda ^ 2", r"\lambda"),
        (r"\lambda_1^2", r"\lambda_1"),
        (r"\mathbf{T}^T", r"\mathbf{T}"),
        (r"{}^0R^T", "{}^0R"),
        ("{}^0R_4^T", "{}^0R_4"),
        ("x''", "x''"),
        ("R{}^T", "R"),
    ],
)
def test_the_place_of_a_name_ends_before_what_is_applied_to_it(latex: str, name: str) -> None:
    (found,) = (node for node in n.walk(Reader().read_expression(latex)) if isinstance(node, n.Name))
    start, end = found.span
    assert found.text == latex[start:end] == name


def test_a_correction_spells_a_greek_letter_in_full(judge: Judge) -> None:
    front = {"arm": "planar_2r", "symbols": {r"\lambda": "free"}}
    record = judge(r"(\lambda + a_1)^2 = \lambda^2 - 2\lambda a_1 + a_1^2".replace("a_1", "l_1"), **front)
    assert record.verdict is Verdict.REFUTED
    assert r"\lambda^2 + 2\lambda l_1" in record.entries[0].correct.replace(r" \lambda", r"\lambda")


def test_a_text_read_before_is_read_anew_where_its_names_or_its_spelling_are_others() -> None:
    def first(reader: Reader, latex: str) -> n.Node:
        [statement] = reader.read(latex)
        assert isinstance(statement, n.Chain)
        return statement.members[0]

    latex, bound, apart = r"w(0, 0) = \varphi", Reader(lambda name: True), Reader()
    assert isinstance(first(Reader(), latex), n.Product)
    assert isinstance(first(bound, latex), n.Call)
    assert isinstance(first(Reader(), latex), n.Product)
    assert first(Reader(), latex) is first(Reader(), latex)  # from memory, and not to be changed by who takes the list
    Reader().read(latex).clear()
    assert Reader().read(latex)
    apart.spelling = Spelling(told_apart=frozenset({"varphi"}))
    letters = [reader.read_expression(r"\varphi") for reader in (Reader(), apart, Reader())]
    assert [letter.base for letter in letters if isinstance(letter, n.Name)] == ["phi", "varphi", "phi"]


def test_a_function_is_the_same_however_it_is_written() -> None:
    def side(latex: str) -> n.Node:
        (chain,) = read(latex)
        assert isinstance(chain, n.Chain)
        return n.bare(chain.members[0])

    assert all(side(latex) == side(r"\cos\theta_1") for latex in (r"C\theta_1", r"c\theta_1", r"\cos(\theta_1)"))
    assert side("C_1") == side("c_1") != side("s_1")
