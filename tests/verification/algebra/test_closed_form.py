"""What is written from an exact value is short, in the document's notation, and has that value when it is read again."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armproof.models.catalogue import arm_names, load_arm
from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.written import fold, write_scalar
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex.writer import Notation
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import read_names
from tests.laws import examples

NOTATIONS = {
    "C_{12}": Notation(style="index", cosine="C"),
    "c_{12}": Notation(style="index", cosine="c"),
    "C12": Notation(style="index", cosine="C", underscore=False),
    r"\cos()": Notation(style="macro()", cosine="\\cos"),
    r"C\theta_1": Notation(style="letter", cosine="C"),
    "c()": Notation(style="letter()", cosine="c"),
    r"c_{\theta_1}": Notation(style="script", cosine="c"),
}
every_notation = pytest.mark.parametrize("notation", NOTATIONS.values(), ids=NOTATIONS)


def rx90() -> tuple[Names, ExactAlgebra]:
    arm = load_arm("rx90")
    return read_names(arm, {}), ExactAlgebra(Ring(), arm)


NAMES, EXACT = rx90()


def value_of(latex: str) -> Scalar:
    return Evaluator(NAMES, EXACT).scalar(NAMES.reader.read_expression(latex))


angles = st.dictionaries(
    st.sampled_from(["theta_1", "theta_2", "theta_3"]), st.sampled_from([1, 1, -1, 2]), min_size=1, max_size=3
)
factors = st.tuples(st.sampled_from(["cos", "sin"]), angles)
terms = st.tuples(
    st.fractions(-3, 3, max_denominator=20),
    st.sampled_from(["", "a_3", "d_3", "a_3 d_3"]),
    st.lists(factors, max_size=2),
)


def scalar(parts: list[tuple[Fraction, str, list[tuple[str, dict[str, int]]]]]) -> Scalar:
    total = EXACT.ring.zero
    for coefficient, lengths, functions in parts:
        term = EXACT.rational(coefficient)
        for name in lengths.split():
            term = term * EXACT.symbol(name)
        for function, angle in functions:
            whole = EXACT.ring.zero
            for name, size in angle.items():
                whole = whole + EXACT.symbol(name) * size
            cosine, sine = EXACT.cos_sin(whole)
            term = term * (cosine if function == "cos" else sine)
        total = total + term
    return total


@every_notation
@given(parts=st.lists(terms, max_size=4), folded=st.booleans())
@examples(40)
def test_what_is_written_has_the_value(notation: Notation, parts: list, folded: bool) -> None:
    value = scalar(parts)
    text = write_scalar(value, notation, folded=folded)
    assert exactly_equal(value_of(text), value), text


@given(above=st.lists(terms, min_size=1, max_size=2), below=st.lists(terms, min_size=1, max_size=2))
@examples(40)
def test_a_written_quotient_has_the_value_and_no_fractions_inside(above: list, below: list) -> None:
    divisor = scalar(below)
    if divisor.is_zero():
        return
    value = scalar(above) / divisor
    text = write_scalar(value, NOTATIONS["C_{12}"])
    assert exactly_equal(value_of(text), value), text
    if not value.normal().denominator.is_one():
        assert text.count(r"\frac") == 1, text
        assert "." not in text


@pytest.mark.parametrize("arm", arm_names())
def test_every_entry_of_every_arm_is_written_as_it_is(arm: str) -> None:
    loaded = load_arm(arm)
    names, exact = read_names(loaded, {}), ExactAlgebra(Ring(), loaded)
    last = loaded.frames[-1]
    rows = [*trace_of(loaded).pose(last), *trace_of(loaded).jacobian(last)]
    for entry in (entry for row in rows for entry in row):
        value = exact.ring.from_entry(entry)
        for style in (r"\cos()", "C_{12}"):
            text = write_scalar(value, NOTATIONS[style])
            again = Evaluator(names, exact).scalar(names.reader.read_expression(text))
            assert exactly_equal(again, value), text


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        ("C_1 C_2 - S_1 S_2", "C_{12}"),
        ("S_1 C_2 - C_1 S_2", "S_{1-2}"),
        ("a_3 C_1 + d_3 (C_1 C_2 - S_1 S_2)", "d_3 C_{12} + a_3 C_1"),
        ("C_1 C_1 + S_1 S_1", "1"),
        ("C_1 C_1", "C_1^2"),
        ("-a_3 S_1", "-a_3 S_1"),
        ("C_1 - C_1", "0"),
        (r"-\frac{a_3 C_1}{2 d_3}", r"-\frac{a_3 C_1}{2 d_3}"),
        (r"\frac{1}{3} a_3", r"\frac{1}{3} a_3"),
        (r"\cos(\theta_1 + \frac{\pi}{2})", "-S_1"),
        (r"\cos\frac{\pi}{4}", r"\frac{1}{2} \sqrt{2}"),
        ("C_1 C_2 C_3 - C_1 S_2 S_3 - S_1 S_2 C_3 - S_1 C_2 S_3", "C_{123}"),
    ],
)
def test_what_is_written_is_short(latex: str, expected: str) -> None:
    assert write_scalar(value_of(latex), NOTATIONS["C_{12}"]) == expected


@pytest.mark.parametrize(
    ("style", "expected"),
    [
        ("C_{12}", "C_1^2"),
        ("C12", "C1^2"),
        (r"\cos()", r"\cos^2(\theta_1)"),
        (r"C\theta_1", r"(C\theta_1)^2"),
        ("c()", r"(c(\theta_1))^2"),
        (r"c_{\theta_1}", r"c_{\theta_1}^2"),
    ],
)
def test_a_square_is_written_in_each_style(style: str, expected: str) -> None:
    text = write_scalar(value_of("C_1^2"), NOTATIONS[style])
    assert text == expected
    assert exactly_equal(value_of(text), value_of("C_1^2"))


def test_the_documents_own_letters_are_used() -> None:
    notation = Notation(symbols={"a_3": "l_1", "theta_1": r"q_1"}, style="macro()", cosine=r"\cos")
    assert write_scalar(value_of("a_3 C_1"), notation) == r"l_1 \cos(q_1)"


def test_unfolded_terms_are_those_of_the_normal_form() -> None:
    assert write_scalar(value_of("C_{12}"), NOTATIONS["C_{12}"], folded=False) == "C_1 C_2 - S_1 S_2"


def test_folding_never_makes_a_sum_longer() -> None:
    one = (("theta_1", Fraction(1)),)
    two = (("theta_2", Fraction(1)),)
    mixed = {(("cos", one, 1), ("sin", two, 1)): Fraction(2), (("sin", one, 2),): Fraction(1)}
    assert len(fold(mixed)) <= len(mixed)
    assert fold({}) == {}
