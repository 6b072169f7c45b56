"""The check of a function: what it takes, what it returns, what it raises; and that it can fail."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import FrozenInstanceError
from math import cos, sin
from typing import Any

import numpy as np
import pytest
import sympy

from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError, ModelError
from armproof.verification.functions import FunctionCheck, FunctionVerdict, check_function
from armproof.verification.functions.asked import QuestionError
from armproof.verification.verdict import Verdict

ARM = load_arm("planar_2r")
L1, L2 = ARM.lengths["l_1"], ARM.lengths["l_2"]
PROVED, CONFIRMED = FunctionVerdict.PROVED, FunctionVerdict.CONFIRMED
REFUTED, ERROR, STUB = FunctionVerdict.REFUTED, FunctionVerdict.ERROR, FunctionVerdict.NOT_ATTEMPTED
V = {"jacobian": 2, "rows": [1, 2]}


def p2(q):
    return [L1 * cos(q[0]) + L2 * cos(q[0] + q[1]), L1 * sin(q[0]) + L2 * sin(q[0] + q[1]), 0.0]


def j2(q):
    s1, c1, s12, c12 = sin(q[0]), cos(q[0]), sin(q[0] + q[1]), cos(q[0] + q[1])
    return np.array([[-L1 * s1 - L2 * s12, -L2 * s12], [L1 * c1 + L2 * c12, L2 * c12]])


def check(function: Callable[..., Any], quantity: Any = "p_2", **options: Any) -> FunctionCheck:
    return check_function(ARM, function, quantity, **options)


# -- what a function may take ------------------------------------------------------------------------------------------


def one_by_one(theta_1, theta_2):
    return p2([theta_1, theta_2])


def by_name(t2, t1):
    return p2([t1, t2])


def starred(*q):
    return p2(q)


def with_an_option(q, tool=0.0):
    return p2(q)


def with_lengths(q, l1, l_2):
    return [l1 * cos(q[0]) + l_2 * cos(q[0] + q[1]), l1 * sin(q[0]) + l_2 * sin(q[0] + q[1]), 0]


def with_defaults(q, *, l1=L1, l2=L2):
    return with_lengths(q, l1, l2)


@pytest.mark.parametrize("function", [p2, one_by_one, by_name, starred, with_an_option])
def test_joint_values_come_as_a_vector_or_one_by_one(function: Callable[..., Any]) -> None:
    found = check(function)
    assert found.verdict is PROVED
    assert found.message == f"proved for all joint values, at the arm's lengths l_1 = {L1}, l_2 = {L2}"


@pytest.mark.parametrize("function", [with_lengths, with_defaults])
def test_lengths_that_are_parameters_stay_symbols(function: Callable[..., Any]) -> None:
    assert check(function).message == "proved for all joint values and all lengths"


def test_a_formula_that_is_right_at_the_arms_lengths_alone_is_refuted() -> None:
    def by_chance(q, l1, l2):
        return with_lengths(q, l1, l1 - 0.1)

    def doubled(q, l1, l2):
        return with_lengths(q, l1 + (l1 - L1), l2)

    assert abs(L1 - 0.1 - L2) < 1e-12
    for function in (by_chance, doubled):
        found = check(function)
        assert found.verdict is REFUTED and found.message.startswith("right at the arm's own lengths only")
        assert [(entry.row, entry.column) for entry in found.entries] == [(1, 1), (2, 1)]
        assert all(entry.printed != entry.correct for entry in found.entries)


@pytest.mark.parametrize("largest", [10**400, -(10**400), np.longdouble("1e4000")])
def test_a_number_that_no_float_holds_is_an_error_and_no_crash(largest: Any) -> None:
    assert check(lambda q: [largest, 0, 0]).verdict in (ERROR, REFUTED)
    assert check(lambda q: [largest, 0.5, 0]).verdict in (ERROR, REFUTED)
    assert check(lambda q: [10**400, 0, 0]).verdict is ERROR


def test_what_a_function_makes_of_numpy_does_not_change_what_it_is_compared_with() -> None:
    def spoils(q):
        np.cos = np.sin
        return [L1 * np.cos(q[0]) + L2 * np.cos(q[0] + q[1]), L1 * sin(q[0]) + L2 * sin(q[0] + q[1]), 0]

    before = np.cos
    assert check(spoils).verdict is REFUTED and np.cos is before
    assert check(p2).verdict is PROVED


def test_a_length_that_the_function_does_not_take_may_be_a_number() -> None:
    found = check(lambda q, l1: with_lengths(q, l1, L2))
    assert found.message.startswith("proved for all joint values, at the arm's lengths")
    assert check(lambda q, l1: with_lengths(q, l1, L2 + 1e-3)).verdict is REFUTED


def test_a_wrong_default_is_told_apart_from_a_wrong_formula() -> None:
    found = check(lambda q, l1=0.2, l2=L2: with_lengths(q, l1, l2))
    assert found.verdict is REFUTED
    assert found.message == f"the formula is right, but the default value of l_1 is 0.2, the arm's is {L1}"


@pytest.mark.parametrize("function", [lambda a, b, c: 0, lambda: 0, lambda *, alpha: 0])
def test_other_arguments_are_an_error_of_the_function(function: Callable[..., Any]) -> None:
    found = check(function)
    assert found.verdict is ERROR and found.error is not None and found.error.type == "TypeError"
    assert "one vector q, or the 2 joint values theta_1, theta_2" in found.message
    assert found.error.line > 0


# -- what is asked for -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("quantity", "function"),
    [
        ("p_2", p2),
        ({"origin": 2}, p2),
        ({"origin": 2, "component": "y"}, lambda q: p2(q)[1]),
        ({"jacobian": 2, "rows": (1, 2)}, j2),
        ({"axis": 1, "along": "x"}, lambda q: [cos(q[0]), sin(q[0]), 0]),
        ("R^0_1", lambda q: [[cos(q[0]), -sin(q[0]), 0], [sin(q[0]), cos(q[0]), 0], [0, 0, 1]]),
        ({"difference": [2, 1]}, lambda q: np.subtract(p2(q), [L1 * cos(q[0]), L1 * sin(q[0]), 0])),
        ("J(q)", lambda q: np.vstack((j2(q), np.zeros((3, 2)), np.ones((1, 2))))),
    ],
)
def test_each_quantity_can_be_asked_for(quantity: Any, function: Callable[..., Any]) -> None:
    assert check(function, quantity).verdict is PROVED
    wrong = check(lambda q: np.multiply(function(q), 1.1), quantity)
    assert wrong.verdict is REFUTED and wrong.table


def test_a_joint_variable_has_no_cause_that_lies_in_frames() -> None:
    found = check_function("planar_2r", lambda q: 2 * q[0], {"joint": "theta_1"})
    assert found.verdict is REFUTED and not any("internal error" in note for note in found.notes)
    assert [(entry.printed, entry.correct) for entry in found.entries] == [("2 \\theta_1", "\\theta_1")]
    assert check_function("planar_2r", lambda q: q[0], {"joint": "theta_1"}).verdict is PROVED


def test_several_quantities_are_judged_one_by_one() -> None:
    found = check(lambda q: (p2(q), j2(q)), ("p_2", V))
    assert found.verdicts == (PROVED, PROVED) and found.quantities == ("p_2", "jacobian: 2, rows: [1, 2]")
    found = check(lambda q: (p2(q), j2(q).T), ("p_2", V))
    assert found.verdicts == (PROVED, REFUTED) and found.verdict is REFUTED
    assert found.message.startswith("jacobian: 2, rows: [1, 2]: the Jacobian is transposed")
    assert {row.quantity for row in found.table} == {2} == {entry.equation for entry in found.entries}
    assert (
        check(lambda q: p2(q)[0], ("p_2", V)).message
        == "the function returns a float; it is to return 2, one a quantity"
    )


@pytest.mark.parametrize(
    ("quantity", "message"),
    [
        ("p_7", "no quantity 'p_7' on arm 'planar_2r'; .* the frames 0, 1, 2"),
        ("}{", "cannot be read"),
        ({"pose": 9}, "no frame '9' on arm 'planar_2r'; its frames are 0, 1, 2"),
        ({"pose": 1, "colour": 2}, "unknown option colour"),
        ({"link": "classic"}, "no quantity of an arm"),
        (3, "a quantity is a name such as"),
        ((), "at least one quantity"),
    ],
)
def test_what_cannot_be_asked_is_refused(quantity: Any, message: str) -> None:
    with pytest.raises(QuestionError, match=message):
        check(p2, quantity)


def test_what_cannot_be_checked_is_refused() -> None:
    with pytest.raises(QuestionError, match="a function of q is expected, not 3"):
        check(3)  # type: ignore[arg-type]
    with pytest.raises(QuestionError, match="a positive time and at least one sample"):
        check(p2, seconds=0)
    with pytest.raises(ModelError, match="no arm 'nothing'"):
        check_function("nothing", p2, "p_2")
    assert issubclass(QuestionError, ArmproofError)


# -- what a function may return ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "function",
    [tuple, np.array, lambda p: np.array([p]).T, lambda p: np.matrix(p).T, iter, lambda p: np.array(p, np.float32)],
)
def test_a_vector_may_come_in_any_dress(function: Callable[..., Any]) -> None:
    found = check(lambda q: function(p2(q)))
    assert found.verdict is PROVED and not found.notes


def test_what_was_adapted_is_noted() -> None:
    assert check(lambda q: [p2(q)]).notes == ("the vector is returned as a row",)
    assert check(lambda q: [*p2(q), 1]).notes == ("the vector is returned in homogeneous coordinates",)


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (lambda q: "p", "the function returns a str, not a number"),
        (lambda q: {"x": 1}, "the function returns a dict, not a number"),
        (lambda q: [[1, 2], [3]], "the function returns rows of different lengths"),
        (lambda q: np.array(p2(q)) * 1j, "the function returns complex numbers; the entries are real"),
        (lambda q: sympy.Matrix([sympy.Symbol("x"), 0, 0]), "the function returns what is no number"),
        (lambda q: p2(q) if q[0] > 1 else p2(q)[:2], "results of different shapes at different q"),
        (lambda q: p2, "the function returns a function"),
    ],
)
def test_what_is_no_matrix_of_numbers_is_an_error(function: Callable[..., Any], message: str) -> None:
    found = check(function)
    assert found.verdict is ERROR and message in found.message
    assert found.error is not None and found.error.type == "TypeError" and found.error.file == __file__


@pytest.mark.parametrize(
    ("function", "quantity", "message"),
    [
        (lambda q: p2(q)[:2], "p_2", "the result is a vector of 2, it should be 3×1: the z coordinate is missing"),
        (lambda q: j2(q), "J", "the result is 2×2, it should be 6×2: it is the plane part of v alone"),
        (lambda q: np.vstack((j2(q), np.zeros((3, 2)), np.ones((1, 2)))).T, "J", "it should be 6×2: it is transposed"),
        (lambda q: p2(q), "T^0_2", "the result is a vector of 3, it should be 4×4: it is the origin alone"),
        (lambda q: np.ones((5, 5)), "T^0_2", "the result is 5×5, it should be 4×4"),
    ],
)
def test_a_result_of_another_shape_is_wrong(function: Callable[..., Any], quantity: str, message: str) -> None:
    found = check(function, quantity)
    assert found.verdict is REFUTED and message in found.message


def raises_not_implemented(q):
    raise NotImplementedError


@pytest.mark.parametrize(
    "function", [lambda q: None, lambda q: ..., lambda q: NotImplemented, lambda q: [None] * 3, raises_not_implemented]
)
def test_a_stub_is_not_attempted(function: Callable[..., Any]) -> None:
    found = check(function)
    assert found.verdict is STUB and found.error is None and not found.is_right


# -- proved, confirmed, refuted ----------------------------------------------------------------------------------------


def branching(q):
    return p2(q) if q[1] > 0 else list(p2(q))


def wrapping(q):
    return p2((q + np.pi) % (2 * np.pi) - np.pi)


def test_what_branches_on_values_is_confirmed() -> None:
    for function in (branching, wrapping):
        found = check(function)
        assert found.verdict is CONFIRMED and not found.exact and found.samples == 1000
        assert found.message == "equal at 1,000 configurations" and found.max_error < 1e-12
        assert found.notes[0].startswith("not traced: ")
    assert check(branching, samples=30).samples == 30


def test_a_wrong_branch_is_refuted_with_the_configuration() -> None:
    found = check(lambda q: p2(q) if abs(q[1]) > 1e-3 else [0, 0, 0])
    assert found.verdict is REFUTED and "right elsewhere" in found.message
    assert abs(found.counterexample["theta_2"]) <= 1e-3 and found.table


def test_a_difference_quotient_is_confirmed_and_no_more() -> None:
    def jacobian(q):
        steps = 1e-6 * np.eye(2)
        return np.array([np.subtract(p2(q + h), p2(q - h)) / 2e-6 for h in steps]).T[:2]

    found = check(jacobian, V)
    assert found.verdict is CONFIRMED and found.exact and "difference quotient" in found.message
    assert 0 < found.max_error < 1e-8


def test_rounded_results_and_constants_are_named() -> None:
    assert check(lambda q: np.round(p2(q), 3)).message == "the entries are rounded to 3 decimals"
    found = check(lambda q: p2([q[0] * 3.14 / math.pi, q[1]]))
    assert found.verdict is REFUTED and "a rounded constant (3.14 for π)" in found.message


def test_an_array_of_integers_is_found_out() -> None:
    def cut(q):
        T = np.array([0, 0, 0])
        T[:] = p2(10 * q)
        return T

    def cut_pose(q):
        T = np.eye(4, dtype=int)
        T[:2, :2] = [[cos(q[0]), -sin(q[0])], [sin(q[0]), cos(q[0])]]
        T[0, 3], T[1, 3] = L1 * cos(q[0]), L1 * sin(q[0])
        return T

    assert check(cut).verdict is REFUTED
    assert "an array made of integers" in check(cut_pose, "T^0_1").message


def test_chance_proves_nothing() -> None:
    rng = np.random.default_rng(0)
    found = check(lambda q: np.array(p2(q)) + 1e-3 * rng.random(3))
    assert found.verdict is REFUTED and found.message.startswith("two calls at the same q give different results")
    assert check(lambda q: np.array(p2(q)) + 1e-13 * rng.random(3)).verdict is CONFIRMED


def test_entries_that_are_no_numbers_are_wrong() -> None:
    found = check(lambda q: [math.nan, 0.0, math.inf])
    assert found.verdict is REFUTED and "not finite" in found.message
    assert math.isnan(found.table[0].obtained) and found.as_json()["table"][0]["obtained"] == "nan"
    found = check(lambda q: np.array(p2(q)) * (np.float64(q[0]) / q[0]))
    assert found.verdict is REFUTED and "not finite" in found.message and found.counterexample["theta_1"] == 0


def test_one_wrong_entry_is_shown_with_its_correction() -> None:
    def wrong(q):
        _, y, z = p2(q)
        return [L1 * cos(q[0]) - L2 * cos(q[0] + q[1]), y, z]

    found = check(wrong)
    [entry] = found.entries
    assert (entry.row, entry.column, entry.change) == (1, 1, "wrong sign of term 2")
    assert entry.printed == "l_1 C_1 - l_2 C_{12}" and entry.correct == "l_1 C_1 + l_2 C_{12}"
    [row] = found.table
    assert (row.row, row.column, row.unit) == (1, 1, "m")
    q = [found.counterexample[joint.symbol] for joint in ARM.joints]
    assert row.expected == pytest.approx(p2(q)[0]) and row.obtained == pytest.approx(wrong(q)[0])
    assert found.counterexample == {"theta_1": 0.0, "theta_2": 0.0}  # where one can reckon it in one's head


def test_the_table_has_units() -> None:
    found = check_function("scara", lambda q: np.full((6, 4), 7.0), "J")
    units = {(row.row, row.column): row.unit for row in found.table}
    assert units[1, 1] == "m/rad" and units[1, 3] == "–" and units[6, 1] == "–" and units[6, 3] == "rad/m"


# -- what a function does beside ---------------------------------------------------------------------------------------


def test_a_changed_argument_is_noted_and_hurts_nobody() -> None:
    def changing(q):
        q += 1.0
        return p2(q - 1.0)

    found = check(changing)
    assert found.verdict is PROVED
    assert found.notes == ("the function changes its argument q; work on a copy, q = q.copy()",)


def test_what_is_printed_is_kept(capsys: pytest.CaptureFixture[str]) -> None:
    found = check(lambda q: print("here", len(q)) or p2(q))
    assert found.verdict is PROVED and found.printed.startswith("here 2\n")
    assert capsys.readouterr().out == ""


def loops(q):
    while True:
        q = q + 1


def recurses(q):
    return recurses(q)


def misspells(q):
    return [cos(q[0]), undefined_name, 0]  # noqa: F821


@pytest.mark.parametrize(
    ("function", "type_", "source", "words"),
    [
        (loops, "Timeout", "", "did not end within 0.3 s"),
        (recurses, "RecursionError", "return recurses(q)", "calls itself without end"),
        (misspells, "NameError", "undefined_name", "name 'undefined_name' is not defined"),
        (lambda q: sys.exit(), "SystemExit", "sys.exit()", "calls exit()"),
        (lambda q: q[5], "IndexError", "q[5]", "at theta_1 ="),
    ],
)
def test_an_error_is_the_functions_own(function: Callable[..., Any], type_: str, source: str, words: str) -> None:
    found = check(function, seconds=0.3)
    assert found.verdict is ERROR and words in found.message
    assert found.error is not None and found.error.type == type_
    assert found.error.file == __file__ and source in found.error.source


def test_an_error_at_special_configurations_is_told_with_one() -> None:
    found = check(lambda q: p2(q) if q[0] else 1 / 0)
    assert found.verdict is ERROR and "ZeroDivisionError" in found.message and "theta_1 = 0" in found.message


def test_a_slow_function_is_confirmed_at_fewer_configurations() -> None:
    import time

    def slow(q):
        time.sleep(0.01)
        return branching(q)

    found = check(slow, seconds=0.6)
    assert found.verdict is CONFIRMED and 10 < found.samples < 100
    assert found.seconds < 3.0


def test_a_loop_that_hangs_at_one_configuration_is_told_with_it() -> None:
    def hangs(q):
        x = q[0]
        while abs(x) < 1e-9:
            x = 2 * x
        return p2(q)

    found = check(hangs, seconds=0.5)
    assert found.verdict is ERROR and "did not end" in found.message and "theta_1 = 0" in found.message


def test_a_function_too_slow_for_all_probes_is_judged_by_those_there_are() -> None:
    import time

    def slow(q):
        time.sleep(0.15)
        return branching(q)

    found = check(slow, seconds=0.4)
    assert found.verdict is CONFIRMED and 1 <= found.samples <= 3
    found = check(lambda q: np.multiply(slow(q), 1.1), seconds=0.4)
    assert found.verdict is REFUTED and found.table and found.counterexample


# -- the value ---------------------------------------------------------------------------------------------------------


def test_the_check_is_a_value() -> None:
    found = check(p2)
    with pytest.raises(FrozenInstanceError):
        found.verdict = REFUTED  # type: ignore[misc]
    assert found.is_right and found.seconds > 0
    as_json = found.as_json()
    assert as_json["verdict"] == "proved" == Verdict.PROVED and as_json["error"] is None


def test_two_checks_of_one_function_agree() -> None:
    first, second = (check(lambda q: j2(q).T, V).as_json() for _ in range(2))
    assert {**first, "seconds": 0} == {**second, "seconds": 0}
