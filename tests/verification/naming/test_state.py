"""What the displays of a document change: signs on their branches, free letters, meanings that are given and taken back."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from armproof import verify_text
from armproof.models.catalogue import load_arm
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.latex.tokens import Spelling
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import is_inverse_link
from armproof.verification.naming.reading import read_names
from armproof.verification.naming.settled import settle_definitions, settle_used, used_names
from armproof.verification.naming.state import (
    Definition,
    DocumentState,
    JacobianRows,
    NamedSigns,
)
from armproof.verification.verdict import EquationResult, Record, Role, Verdict, WrongEntry

A, B, C = ("a", 1), ("b", 2), ("c", 3)


def named(latex: str) -> n.Name:
    name = Reader().read_expression(latex)
    assert isinstance(name, n.Name)
    return name


def names_of(arm: Any = "planar_2r", **front: Any) -> Names:
    return read_names(None if arm is None else load_arm(arm), front)


# -- signs ---------------------------------------------------------------------------------------------------------------


def test_signs_that_were_met_have_each_value_on_both_branches_and_are_positive_again() -> None:
    signs = NamedSigns()
    for name in ("sigma", "u", "w"):
        signs.name(name, 1)
    assert signs.value("sigma") == signs.value("w") == 1 and signs.value("x") is None
    seen = [(branch, signs.values["sigma"], signs.values["u"], signs.values["w"]) for branch in signs.branches()]
    assert seen == [(b, s, 1, w) for s in (1, -1) for w in (1, -1) for b in (1, -1)]
    assert set(signs.values.values()) == {1} and list(signs.branches(several=False)) == [1]


def test_the_copy_of_signs_is_apart() -> None:
    signs = NamedSigns()
    signs.name("u", 3)
    other = signs.copy()
    other.name("u", 5), other.name("w", 5), other.value("u")
    assert (signs.values, signs.read, signs.lines) == ({"u": 1}, set(), {"u": 3})
    assert (other.read, other.lines) == ({"u"}, {"u": 3, "w": 5})


# -- the state -------------------------------------------------------------------------------------------------------------


def test_the_copy_of_a_state_is_apart_and_a_state_becomes_another() -> None:
    state = DocumentState(transforms="lower", used={"x"})
    state.infer_usual("p", Quantity("origin", "2"))
    other = state.copy()
    assert other == state
    other.used.add("y"), other.forget_usual(["p", "q"])
    assert state.used == {"x"} and state.conventional == set(state.inferred) == {"p"} and not other.inferred
    state.become(other)
    other.used.add("z")
    assert state.used == {"x", "y"} and not state.conventional


def test_an_exercise_lasts_to_the_next_one() -> None:
    state = DocumentState()
    for section, exercise in (
        ("Notation", ""),
        ("Exercise 1", "Exercise 1"),
        ("The elbow", "Exercise 1"),
        ("Problème 2", "Problème 2"),
    ):
        state.enter(section)
        assert (state.section, state.exercise) == (section, exercise)


def test_blocks_of_a_matrix_end_with_their_section_but_those_of_the_head() -> None:
    names = names_of()
    names.define("R", lambda _: 1, 2, of_section=True)
    names.state.enter("First")
    names.define("p", lambda _: 2, 5, of_section=True), names.define("k", lambda _: 3, 6)
    assert names.defined_value("p", None) == 2  # type: ignore[arg-type]
    names.state.enter("Second")
    assert names.defined_value("R", None) == 1 and names.defined_value("k", None) == 3  # type: ignore[arg-type]
    with pytest.raises(EvaluationError, match="another section, at line 5"):
        names.defined_value("p", None)  # type: ignore[arg-type]


def test_what_was_consulted_tells_where_its_meaning_comes_from() -> None:
    state = DocumentState(exercise="Exercise 2", consulted={A, B, C, ("gone", 4)})
    state.definitions = {
        "a": Definition(lambda _: 0, 1, exercise="Exercise 1"),
        "b": Definition(lambda _: 0, 2, in_text=True),
        "c": Definition(lambda _: 0, 3, exercise="Exercise 2", in_text=True),
    }
    assert state.foreign() == [A] and state.from_text() == ["b", "c"]


# -- which definitions count -----------------------------------------------------------------------------------------------


def result(
    verdict: Verdict, defines: set = frozenset(), uses: set = frozenset(), role: Role = Role.DEFINITION
) -> EquationResult:  # type: ignore[assignment]
    found = frozenset(uses)
    return EquationResult(1, role, verdict, defines=frozenset(defines), uses=found, may_slip=found)


def test_a_name_counts_where_a_claim_rests_on_it_through_others_too() -> None:
    claim, through, idle = (
        result(Verdict.PROVED, uses={A}),
        result(Verdict.DEFINED, {A}, {B}),
        result(Verdict.DEFINED, {C}, {("d", 4)}),
    )
    assert used_names([through, claim, idle]) == {A, B}
    assert used_names([through, idle]) == frozenset() == used_names([result(Verdict.UNCHECKED, uses={A})])


def test_a_definition_on_which_nothing_rests_is_unchecked() -> None:
    claim, used, idle, data = (
        Record(1, "", each.verdict, outcomes=(each,))
        for each in (
            result(Verdict.PROVED, uses={A}),
            result(Verdict.DEFINED, {A}),
            result(Verdict.DEFINED, {C}),
            result(Verdict.DEFINED, {C}, role=Role.DATA),
        )
    )
    settled = settle_used([claim, used, idle, data])
    assert settled[:2] == (claim, used)
    assert [record.verdict for record in settled[2:]] == [Verdict.UNCHECKED] * 2
    assert [[found.kind for found in record.findings] for record in settled[2:]] == [[Kind.NEVER_USED], []]


def test_a_definition_that_makes_more_lines_wrong_than_right_may_be_the_mistake_itself() -> None:
    define = Record(1, "", Verdict.DEFINED, outcomes=(result(Verdict.DEFINED, {A}, role=Role.DEFINITION),))
    right, *wrong = (
        Record(line, "", verdict, outcomes=(result(verdict, uses={A}),))
        for line, verdict in ((2, Verdict.PROVED), (3, Verdict.REFUTED), (4, Verdict.REFUTED), (5, Verdict.REFUTED))
    )

    def verdicts(*records: Record) -> list[Verdict]:
        return [record.verdict for record in settle_definitions([define, *records])]

    refuted, left_open = Verdict.REFUTED, Verdict.UNCHECKED
    by_a_slip = replace(wrong[0], entries=(WrongEntry(1, None, None, "a", "b", say(Kind.WRONG_SIGN)),))
    assert verdicts(wrong[0]) == [left_open] * 2  # nobody knows which of the two is wrong
    assert verdicts(by_a_slip) == [Verdict.DEFINED, refuted]
    assert verdicts(*wrong[:2]) == [left_open] * 3
    assert verdicts(right, *wrong[:1]) == [Verdict.DEFINED, Verdict.PROVED, refuted]
    assert verdicts(right, right, *wrong[:2]) == [Verdict.DEFINED, Verdict.PROVED, Verdict.PROVED, refuted, refuted]
    assert verdicts(right, *wrong) == [left_open, Verdict.PROVED, *[left_open] * 3]


K = r"With $k_1 = l_1 + l_2 c_2$ and $k_2 = l_2 s_2$ we have $$ x = k_1 c_1 - k_2 s_1, \quad y = k_1 s_1 + k_2 c_1 $$"


@pytest.mark.parametrize("slip", ["l_1 + l_2 c_1", "l_1^2 + l_2 c_2", "2 l_1 + l_2 c_2", "l_2 + l_1 c_2"])
def test_what_the_text_says_of_a_letter_may_hold_the_slip(slip: str) -> None:
    """Nothing else holds with k_1: neither its formula nor what is written with it is known to be right."""
    head = "---\narm: planar_2r\n---\n"
    assert [each.verdict for each in verify_text(head + K).equations] == [Verdict.PROVED]
    (record,) = verify_text(head + K.replace("l_1 + l_2 c_2", slip)).equations
    assert record.verdict is Verdict.UNCHECKED


def test_a_display_keeps_the_verdict_of_its_claim_beside_an_idle_definition() -> None:
    both = (result(Verdict.REFUTED), result(Verdict.DEFINED, {C}))
    (record,) = settle_used([Record(1, "", Verdict.REFUTED, outcomes=both)])
    assert record.verdict is Verdict.REFUTED and not record.findings
    assert [each.verdict for each in record.outcomes] == [Verdict.REFUTED, Verdict.UNCHECKED]
    (erratum, other) = settle_used(
        [
            Record(1, "", Verdict.PROVED, True, outcomes=(result(Verdict.PROVED, uses={A}),)),
            Record(2, "", Verdict.DEFINED, outcomes=(result(Verdict.DEFINED, {A}),)),
        ]
    )
    assert erratum.verdict is Verdict.PROVED and other.verdict is Verdict.UNCHECKED  # of an erratum nothing is taken


# -- names -----------------------------------------------------------------------------------------------------------------


def test_general_statements_have_free_letters_of_their_own() -> None:
    names = names_of(None)
    general = Names(None, state=names.state, general=True)
    names.used.add("x"), general.used.add("y")
    assert (names.state.used, names.state.used_in_general) == ({"x"}, {"y"})
    assert not names.is_new(named("x")) and general.is_new(named("x")) and names.is_new(named("y"))
    assert not names.is_new(named("{}^0x")) and not names.is_new(named("T^0_1"))


@pytest.mark.parametrize(
    ("latex", "terms"),
    [(r"\theta_{12}", [1, 2]), ("q_{12}", [1, 2]), (r"\theta_{11}", None), (r"\theta_{21}", None), (r"\theta_{13}", None), (r"\theta_1", None), (r"\theta_{12}^{(+)}", None),
     (r"\theta'_{12}", None), (r"{}^0\theta_{12}", None), ("a_{12}", None)],
)  # fmt: skip
def test_digits_that_rise_are_a_sum_of_angles(latex: str, terms: list[int] | None) -> None:
    found = names_of().angle_sum(named(latex))
    assert (found and [index for _, index in found.terms]) == terms
    assert names_of(None).angle_sum(named(latex)) is None


def test_a_transform_leads_to_a_frame_that_the_document_adds() -> None:
    names = names_of()
    for latex, adds in (
        ("T^2_3", True),
        ("{}^2T_E", True),
        ("T^1_2", False),
        ("T^3_4", False),
        ("R^2_3", False),
        ("p^2_3", False),
    ):
        assert names.adds_frame(named(latex)) is adds
    assert names.added_frame(named("T^0_3")) is None
    names.add_frame(named("T^2_3")), names.add_frame(named("T^1_3")), names.add_frame(named("T^0_1"))
    assert names.state.beyond == {"3": ("2", "T_3^2")}
    assert names.added_frame(named("T^0_3")) == names.added_frame(named("R^0_3")) == ("0", "2", "T_3^2")
    assert names.added_frame(named("T^2_3")) is None  # what defines it
    for other in ("p^0_3", "T'^0_3", r"\dot T^0_3", "T^4_3"):
        assert names.added_frame(named(other)) is None
    assert not names_of(None).adds_frame(named("T^2_3"))


def test_meanings_are_given_once_taken_back_and_left_unknown() -> None:
    names = names_of()
    for value in (1, 2):
        names.define("x", lambda algebra, value=value: value, value)
    assert names.defined_value("x", None) == 1 and names.state.consulted == {("x", 1)}  # type: ignore[arg-type]
    assert not names.is_open(named("x")) and names.is_open(named("y")) and not names.is_open(named("l_1"))
    names.state.infer_usual("p", Quantity("origin", "2"))
    names.leave_unknown(["x", "p", "z"], 7)
    assert names.defined_value("x", None) == 1 and "p" not in names.state.definitions  # type: ignore[arg-type]
    with pytest.raises(EvaluationError, match="line 7"):
        names.defined_value("z", None)  # type: ignore[arg-type]
    names.leave_open("x", say(Kind.NESTED)), names.leave_open("w", say(Kind.NESTED))
    with pytest.raises(EvaluationError, match="nested"):
        names.defined_value("x", None)  # type: ignore[arg-type]
    names.forget(["x", "p"])
    assert names.is_open(named("x")) and not names.state.inferred and not names.state.conventional


ROWS = [
    {"a": "l_1", "alpha": 0, "d": 0, "theta": "theta_1 + pi/2"},
    {"a": "l_2", "alpha": 0, "d": 0, "theta": "-theta_2"},
    {"a": "l_3", "alpha": 0, "d": 0, "theta": "theta_3"},
    {"a": 0, "alpha": 0, "d": "d_4", "theta": 0},
]


@pytest.mark.parametrize(
    ("variables", "joints"), [("", ["theta_1"]), ("both", ["theta_1", "theta_2"]), ("told", ["theta_1", "theta_2"])]
)
def test_a_joint_with_an_offset_or_a_minus_in_its_row_is_told_from_the_others(
    variables: str, joints: list[str]
) -> None:
    names = names_of({"dh": "classic", "rows": ROWS})
    names.reader.spelling = Spelling(variables=variables)
    assert list(names.offset_joints) == joints
    assert not names_of("planar_2r").offset_joints and not names_of(None).offset_joints


def test_a_letter_means_the_angle_of_the_table_where_that_is_shown() -> None:
    names = names_of({"dh": "classic", "rows": ROWS})
    assert names.table_row("theta_1") is None and names.turn_of("theta_1", "theta_1") == 1
    names.state.angles = "table"
    first, second = names.table_row("theta_1"), names.table_row("theta_2")
    assert first is not None and second is None and names.table_row("theta_3") is None
    names.reader.spelling = Spelling(variables="both")
    assert names.turn_of("theta_2", "theta_2") == -1


def test_beside_a_variable_q_the_letter_theta_is_the_angle_of_the_table() -> None:
    names = names_of({"dh": "classic", "rows": [{"a": "l_1", "alpha": 0, "d": 0, "theta": "q_1 + pi/2"}]})
    assert names.table_row("q_1", "theta_1") is None  # nothing tells the two apart
    names.reader.spelling = Spelling(variables="told")
    row = names.table_row("q_1", "theta_1")
    assert row is not None and row.joint == "q_1" and names.table_row("q_1", "q_1") is None
    names.state.angles = "loose"
    assert names.table_row("q_1", "theta_1") is None


def test_the_variable_is_got_back_from_the_angle_of_the_table() -> None:
    rows = [{**ROWS[0], "theta": "-theta_1 + pi/3"}, {**ROWS[1], "theta": "theta_2 + pi/2"}]
    names = names_of({"dh": "classic", "rows": rows})
    names.reader.spelling = Spelling(variables="both")
    exact = ExactAlgebra(Ring(), names.arm)
    theta = exact.symbol("theta_1"), exact.symbol("theta_2")
    assert (names.table_angle("theta_1", exact) - theta[0]).is_zero()
    names.state.angles = "table"
    angles = [names.table_angle(f"theta_{k}", exact) for k in (1, 2)]
    assert (angles[0] + theta[0] - exact.pi() / 3).is_zero() and (angles[1] - theta[1] - exact.pi() / 2).is_zero()
    for k in (1, 2):
        assert (names.variable_at(f"theta_{k}", angles[k - 1], exact) - theta[k - 1]).is_zero()


def test_a_jacobian_has_the_rows_in_which_the_document_shows_it() -> None:
    names = names_of()
    names.state.shown = {
        "J": JacobianRows((1, 2)),
        "T_1^0": JacobianRows((1, 2)),
        "J_v": JacobianRows((1, 2, 3, 4, 5, 6)),
    }
    assert names.rows_of("J") == (1, 2) and names.rows_of("p_1") is None
    assert names.quantity(named("J")) == Quantity("jacobian", "2", rows=(1, 2))
    assert names.quantity(named("T^0_1")) == Quantity("pose", "1") and names.quantity(named("x")) is None
    assert names.quantity(named("J_v")) == Quantity("jacobian", "2", rows=(1, 2, 3))


def test_where_a_row_has_no_joint_an_index_counts_rows() -> None:
    fixed = {"a": 0, "alpha": "pi/2", "d": "d_2", "theta": 0}
    names = names_of({"dh": "classic", "rows": [ROWS[0], fixed, ROWS[2]], "joints": ["theta_1", "theta_3"]})
    assert [names.known_symbol(f"q_{k}") for k in range(4)] == [None, "theta_1", None, "theta_3"]
    assert [names_of("polar_rp").known_symbol(f"q_{k}") for k in range(4)] == [None, "theta", "r", None]


LINKS = {
    "{}^{i-1}T_i": False, "{}^{i-1}_iT": False, "T_i^{i-1}": False, "A_i": False, "H_i": False, "{}^iT_{i-1}": True, "T_{i-1}^i": True,
    "A_i^{-1}": True, "(({}^iT_{i-1})^{-1})": False, "T_1^0": None, "A_1": None, "p_i": None, "A'_i": None, r"\dot A_i": None, "x^{-1}": None, "R_i": None, "{}^{i-1}T": None,
}  # fmt: skip


@pytest.mark.parametrize("latex", LINKS)
def test_the_link_matrix_of_any_link_is_told_from_its_inverse(latex: str) -> None:
    node = Reader().read_expression(latex)
    assert is_inverse_link(node, "upper") is LINKS[latex]


def test_the_lower_index_may_be_the_reference_of_any_link() -> None:
    assert (
        is_inverse_link(named("T_{i-1}^i"), "lower") is False and is_inverse_link(named("T_i^{i-1}"), "lower") is True
    )
    assert is_inverse_link(named("{}^{i-1}T_i"), "lower") is False


MASSES = r"""
$$ M = \begin{bmatrix} m_1 l_1^2 & 0 \\ 0 & m_2 l_2^2 FIRST \end{bmatrix} + \begin{bmatrix} m_2 l_1^2 & 0 \\ 0 & 0 \end{bmatrix} $$

$$ M = \begin{bmatrix} m_1 l_1^2 + m_2 l_1^2 & 0 \\ 0 & m_2 l_2^2 s_2 \end{bmatrix} $$

$$ M = \begin{bmatrix} (m_1 + m_2) l_1^2 & 0 \\ 0 & m_2 l_2^2 s_2 \end{bmatrix} $$
"""


def test_where_two_lines_say_otherwise_the_first_may_hold_the_slip() -> None:
    right = verify_text(MASSES.replace("FIRST", "s_2"))
    wrong = verify_text(MASSES.replace("FIRST", "c_2"))
    assert [str(record.verdict) for record in right.equations] == ["defined", "proved", "proved"]
    assert [str(record.verdict) for record in wrong.equations] == ["unchecked"] * 3
    assert "what is said elsewhere (lines 4, 6)" in wrong.equations[0].message
