"""What a refuted display says: every wrong entry, the term that belongs there in the document's own hand, why, and where it shows."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest

from armproof.models.catalogue import load_arm
from armproof.verification.verdict import DocumentResult, Record, Verdict

Judge = Callable[..., Record]
Check = Callable[..., DocumentResult]

# How documents write cos θ1, sin θ1, cos(θ1+θ2), sin(θ1+θ2), and the lengths.
NOTATIONS: dict[str, dict[str, str]] = {
    "macro": {"c1": r"\cos\theta_1", "s1": r"\sin\theta_1", "c12": r"\cos(\theta_1+\theta_2)", "s12": r"\sin(\theta_1+\theta_2)"},
    "macro with brackets": {"c1": r"\cos(\theta_1)", "s1": r"\sin(\theta_1)", "c12": r"\cos(\theta_1 + \theta_2)", "s12": r"\sin(\theta_1 + \theta_2)"},
    "c_1": {"c1": "c_1", "s1": "s_1", "c12": "c_{12}", "s12": "s_{12}"},
    "C_1": {"c1": "C_1", "s1": "S_1", "c12": "C_{12}", "s12": "S_{12}"},
    "C1": {"c1": "C1", "s1": "S1", "c12": "C12", "s12": "S12"},
    "Cθ": {"c1": r"C\theta_1", "s1": r"S\theta_1", "c12": r"C(\theta_1+\theta_2)", "s12": r"S(\theta_1+\theta_2)"},
    "c_θ": {"c1": r"c_{\theta_1}", "s1": r"s_{\theta_1}", "c12": r"c_{\theta_1+\theta_2}", "s12": r"s_{\theta_1+\theta_2}"},
    "starred": {"c1": r"\cos\theta_1^*", "s1": r"\sin\theta_1^*", "c12": r"\cos(\theta_1^*+\theta_2^*)", "s12": r"\sin(\theta_1^*+\theta_2^*)"},
}  # fmt: skip
RIGHT = "a_1 {c1} + a_2 {c12}"
SLIPS = {
    "a sign": ("a_1 {c1} - a_2 {c12}", "wrong sign of term 2"),
    "a function": ("a_1 {c1} + a_2 {s12}", "sine for cosine"),
    "a length": ("a_2 {c1} + a_2 {c12}", "length a_2 where a_1 belongs"),
    "a factor dropped": ("a_1 {c1} + {c12}", "a factor a_2 is missing"),
    "a factor too many": ("a_1 {c1} + a_2 {c1} {c12}", "factor"),
    "a term dropped": ("a_1 {c1}", "is missing"),
    "a term too many": ("a_1 {c1} + a_2 {c12} + a_1", "does not belong"),
    "an index dropped": ("a_1 {c1} + a_2 {c1}", "missing"),
    "swapped lengths": ("a_2 {c1} + a_1 {c12}", "lengths a_1 and a_2 are swapped"),
    "a number": ("a_1 {c1} + 2 a_2 {c12}", ""),
}


def put_back(record: Record) -> str:
    """Return the display with every wrong entry replaced by what is offered for it."""
    latex = record.latex
    for entry in sorted(record.entries, key=lambda each: each.span or (0, 0), reverse=True):
        assert entry.span is not None
        assert latex[slice(*entry.span)].strip() == entry.printed
        latex = latex[: entry.span[0]] + entry.correct + latex[entry.span[1] :]
    return latex


@pytest.mark.parametrize("notation", NOTATIONS.values(), ids=NOTATIONS.keys())
@pytest.mark.parametrize(("wrong", "words"), SLIPS.values(), ids=SLIPS.keys())
def test_a_slip_is_named_and_mended_in_the_documents_own_hand(
    judge: Judge, notation: dict[str, str], wrong: str, words: str
) -> None:
    matrix = r"p_4 = \begin{{bmatrix}} {cell} \\ a_1 {s1} + a_2 {s12} \\ -d_3 - d_4 \end{{bmatrix}}"
    assert judge(matrix.format(cell=RIGHT.format(**notation), **notation), confirm=False).verdict is Verdict.PROVED
    record = judge(matrix.format(cell=wrong.format(**notation), **notation), confirm=False)
    assert record.verdict is Verdict.REFUTED
    (entry,) = record.entries
    assert (entry.equation, entry.row, entry.column, entry.printed) == (1, 1, 1, wrong.format(**notation))
    assert notation["c12"].replace(" ", "") in entry.correct.replace(" ", "")
    assert words in entry.change and entry.change in record.message
    assert judge(put_back(record), confirm=False).verdict is Verdict.PROVED


@pytest.mark.parametrize("notation", NOTATIONS.values(), ids=NOTATIONS.keys())
def test_what_no_small_change_mends_is_written_anew_in_the_same_hand(judge: Judge, notation: dict[str, str]) -> None:
    record = judge(
        f"a_1 {notation['c1']} = \\text{{words}}".replace(r"\text{words}", f"a_2 {notation['s12']} + 5 a_1^3"),
        confirm=False,
    )
    assert record.verdict is Verdict.REFUTED
    whole = judge(
        rf"p_4 = \begin{{bmatrix}} 7 {notation['c1']} {notation['s1']} a_1^2 \\ a_1 {notation['s1']} + a_2 {notation['s12']} \\ -d_3-d_4 \end{{bmatrix}}",
        confirm=False,
    )
    (entry,) = whole.entries
    assert not entry.change and f"should be {entry.correct}" in whole.message
    assert judge(put_back(whole), confirm=False).verdict is Verdict.PROVED
    plain = entry.correct.replace(" ", "")
    assert notation["c12"].replace(" ", "").replace("^*", "") in plain.replace("^*", "")


def test_an_expanded_document_is_corrected_in_expanded_form(judge: Judge) -> None:
    record = judge(r"c_{12} = c_1 c_2 + s_1 s_2")
    assert [(entry.row, entry.column, entry.correct) for entry in record.entries] == [(None, None, "c_1 c_2 - s_1 s_2")]


@pytest.mark.parametrize(
    ("printed", "correct"),
    [
        (r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 1 & 1 \end{bmatrix}", "0"),
        (r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & a_1 c_1 & 1 \end{bmatrix}", "0"),
        (r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 2 \end{bmatrix}", "1"),
        (r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 0 \end{bmatrix}", "1"),
        (r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & -1 \end{bmatrix}", "1"),
    ],
)
def test_a_constant_is_corrected_to_a_constant(judge: Judge, printed: str, correct: str) -> None:
    record = judge(f"R^1_1 = {printed}")
    assert [entry.correct for entry in record.entries] == [correct]


def test_a_wrong_scalar_has_no_row_and_column(judge: Judge) -> None:
    (entry,) = judge(r"\det(R^0_4) = -1").entries
    assert (entry.row, entry.column, entry.printed, entry.correct) == (None, None, "-1", "1")
    assert "row" not in entry.as_json() and "column" not in entry.as_json()


def test_rows_and_columns_are_those_of_the_printed_matrix(judge: Judge) -> None:
    transposed = judge(r"p_1 = \begin{bmatrix} a_1 c_1 & -a_1 s_1 & 0 \end{bmatrix}^T")
    assert [(e.row, e.column, e.printed, e.correct) for e in transposed.entries] == [(2, 1, "-a_1 s_1", "a_1 s_1")]
    blocks = judge(
        r"T^0_1 = \begin{bmatrix} \begin{matrix} c_1 & s_1 & 0 \\ s_1 & c_1 & 0 \\ 0 & 0 & 1 \end{matrix} & p_1 \\ 0 & 1 \end{bmatrix}"
    )
    assert [(e.row, e.column, e.printed, e.correct) for e in blocks.entries] == [(1, 2, "s_1", "-s_1")]


def test_in_a_matrix_of_named_blocks_the_entry_printed_is_the_blocks_entry(judge: Judge) -> None:
    record = judge(r"J = \begin{bmatrix} J_v \\ -J_\omega \end{bmatrix}")
    assert [(entry.row, entry.column) for entry in record.entries] == [(6, 1), (6, 2), (6, 4)]
    assert [(entry.printed, entry.correct) for entry in record.entries] == [("-1", "1"), ("-1", "1"), ("1", "-1")]


def test_every_wrong_entry_is_listed(judge: Judge) -> None:
    record = judge(r"p_4 = \begin{bmatrix} a_1 c_1 - a_2 c_{12} \\ a_1 s_1 \\ d_3 \end{bmatrix}")
    assert [(entry.row, entry.column) for entry in record.entries] == [(1, 1), (2, 1), (3, 1)]
    assert judge(put_back(record)).verdict is Verdict.PROVED
    for place in ("(1, 1)", "(2, 1)", "(3, 1)"):
        assert f"entry {place}" in record.message


def test_a_sum_over_the_printed_lengths_of_another_arm_is_written_in_the_documents_letters(judge: Judge) -> None:
    record = judge(
        r"P_x = \ell_1 c_1", quantities={"P_x": {"origin": 4, "component": "x"}}, symbols={r"\ell_1": "a_1", "L": "a_2"}
    )
    (entry,) = record.entries
    assert r"\ell_1" in entry.correct and "L" in entry.correct and "a_" not in entry.correct


# -- counterexamples -----------------------------------------------------------------------------------------------------------


def test_the_counterexample_shows_the_difference(judge: Judge, workbench: Callable[..., Any]) -> None:
    printed, true = r"a_1 c_1 - a_2 c_{12}", r"a_1 c_1 + a_2 c_{12}"
    record = judge(rf"{true} = {printed}")
    bench = workbench("scara")
    assert set(record.counterexample) == {
        "theta_1",
        "theta_2",
        "d_3",
        "theta_4",
    }  # no lengths: the claim is not about them
    at = {**load_arm("scara").lengths, **record.counterexample}
    values = {name: bench.exact.rational(Fraction(value)) for name, value in at.items()}
    difference = bench.exact.substitute(bench.value(f"{true} - ({printed})"), values)
    assert abs(float(bench.sampled.from_exact(difference)[0])) > 0.1


def test_a_counterexample_is_generic_even_where_zero_would_hide_the_slip(judge: Judge) -> None:
    record = judge(r"s_{12} = s_1 c_2 - c_1 s_2")  # right at zero
    assert all(abs(record.counterexample[name]) > 0.05 for name in ("theta_1", "theta_2"))


def test_lengths_in_counterexamples_are_pairwise_different(judge: Judge) -> None:
    record = judge(r"a_1 c_1 + a_2 c_{12} = a_2 c_1 + a_1 c_{12}")
    assert record.counterexample["a_1"] != record.counterexample["a_2"]


def test_letters_have_few_decimals_and_joints_stay_within_their_limits(judge: Judge) -> None:
    record = judge(r"\cos(\alpha_i + \beta_i) = \cos\alpha_i + \cos\beta_i", arm=None)
    assert record.counterexample and all(value == round(value, 2) for value in record.counterexample.values())
    for name in ("scara", "kr210", "rx90"):
        arm = load_arm(name)
        at = judge(r"s_1 = c_1", arm=name).counterexample
        assert all(joint.lower <= at[joint.symbol] <= joint.upper for joint in arm.joints)
        assert all(value == round(value, 2) for value in at.values())


# -- causes and consequences ---------------------------------------------------------------------------------------------------

LINK = r"A^1_2 = \begin{bmatrix} c_2 & s_2 & 0 & a_2 c_2 \\ s_2 & c_2 & 0 & a_2 s_2 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
CARRIED = r"""T^0_2 = \begin{bmatrix} c_1 c_2 - s_1 s_2 & c_1 s_2 - s_1 c_2 & 0 & a_1 c_1 + a_2 c_{12} \\
s_{12} & s_1 s_2 + c_1 c_2 & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def test_an_error_is_reported_once_as_a_cause_and_then_as_its_consequence(check: Check) -> None:
    cause, again, carried = check(LINK, LINK, CARRIED).equations
    assert cause.message == "entry (2, 2): wrong sign"
    assert again.message == "entry (2, 2): wrong sign; the same error as in line 1"
    assert carried.message.endswith("follows from line 1")
    assert [(entry.row, entry.column) for entry in carried.entries] == [(1, 2), (2, 2)]


def test_what_an_error_was_made_of_may_have_no_meaning_later(check: Check) -> None:
    """A letter in the entry of a wrong matrix, and a product of that matrix printed behind it."""
    wrong = r"U_4 = {}^4T_6 = \begin{bmatrix} C_5 C_6 & -C\theta_{5,5} S_6 & -S_5 & 0 \\ S_6 & C_6 & 0 & 0 \\ S_5 S_6 & -S_5 S_6 & C_5 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    product = r"""{}^3T_6 = \begin{bmatrix} C_4C_5C_6 - S_4S_6 & -C_4C_5S_6 - S_4C_6 & -C_4S_5 & 0 \\ S_5C_6 & -S_5S_6 & C_5 & d_3 \\
    -S_4C_5C_6 - C_4S_6 & S_4C_5S_6 - C_4C_6 & S_4S_5 & 1 \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
    found = check(wrong, product, arm="rx90").equations
    assert [record.verdict for record in found] == [Verdict.REFUTED, Verdict.REFUTED]
    assert found[1].message == "entry (3, 4): is 1, should be 0"


def test_the_upper_rows_of_a_wrong_matrix_are_multiplied_by_nothing(check: Check) -> None:
    upper = LINK.replace(r" \\ 0 & 0 & 0 & 1", "")
    found = check(upper, CARRIED).equations
    assert [record.verdict for record in found] == [Verdict.REFUTED, Verdict.REFUTED]
    assert "follows" not in found[1].message


def test_an_error_of_its_own_follows_from_nothing(check: Check) -> None:
    assert "follows" not in check(CARRIED).equations[0].message
    other = CARRIED.replace("a_2 s_{12}", "a_2 c_{12}")
    assert "follows" not in check(LINK, other).equations[1].message
    another = LINK.replace("c_2 & s_2 & 0", "-c_2 & s_2 & 0").replace("s_2 & c_2 & 0", "s_2 & -c_2 & 0")
    assert "same error" not in check(LINK, another).equations[1].message


POINT = r"x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12}"
FORMULAS = [  # the side of an angle, the formula printed for it, what stands there instead
    ("c_2", r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}", "- l_2^2", "+ l_2^2"),
    ("s_1", r"\frac{(l_1 + l_2 c_2) y - l_2 s_2 x}{x^2 + y^2}", "c_2", "s_2"),
    ("s_1", r"\frac{(l_1 + l_2 c_2) y - l_2 s_2 x}{x^2 + y^2}", "s_2 x", "s_2 y"),
    (r"l_1 l_2 c_2", r"\frac{x^2 + y^2 - l_1^2 - l_2^2}{2}", "x^2 + y^2", "x^2 - y^2"),
]


@pytest.mark.parametrize(("side", "formula", "right", "wrong"), FORMULAS)
@pytest.mark.parametrize("turned", [False, True])
def test_of_two_formulas_the_one_that_a_slip_mends_is_wrong(
    check: Check, side: str, formula: str, right: str, wrong: str, turned: bool
) -> None:
    printed = formula.replace(right, wrong, 1)
    said = [f"{one} = {other}" for one, other in ([(printed, side)] if turned else [(side, printed)])]
    _, record = check(POINT, *said, arm="planar_2r", confirm=False).equations
    [entry] = record.entries
    assert (record.verdict, entry.printed, entry.correct) == (Verdict.REFUTED, printed, formula)
    assert check(POINT, f"{side} = {formula}", arm="planar_2r", confirm=False).equations[1].verdict is Verdict.PROVED


def test_a_formula_that_no_slip_mends_is_not_what_the_angle_is(check: Check) -> None:
    [entry] = check(POINT, r"c_2 = \frac{x + y}{l_1}", arm="planar_2r", confirm=False).equations[1].entries
    assert (entry.printed, entry.correct, entry.finding) == (r"\frac{x + y}{l_1}", "c_2", None)


def test_quantities_alone_are_no_formula_that_is_wrong(check: Check) -> None:
    [entry] = check(POINT, r"x^2 + y^2 = c_2", arm="planar_2r", confirm=False).equations[1].entries
    assert entry.printed == "c_2"


def test_a_slip_is_told_where_its_letters_are_only_usual(check: Check) -> None:
    """Nothing says that x is the tool's: the equation is left open, and what would be wrong in it is said."""
    wrong, other = r"c_2 = \frac{x^2 + y^2 - l_1^2 + l_2^2}{2 l_1 l_2}", r"c_2 = \frac{x + y}{l_1}"
    near, far = (check(latex, arm="planar_2r").equations[0] for latex in (wrong, other))
    assert near.verdict is far.verdict is Verdict.UNCHECKED
    assert "x is usually" in near.message and near.message.endswith(r"- l_2^2}{2 l_1 l_2}: wrong sign of term 4")
    assert "x is usually" in far.message and "should be" not in far.message
