"""From displays to verdicts: each verdict of the design is reached, one record a display, whatever stands in it."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from armproof import verify_text
from armproof.models.errors import ArmproofError
from armproof.verification.check import check_document, verify
from armproof.verification.diagnosis.diagnosis import Diagnostician
from armproof.verification.display.statements import Statements
from armproof.verification.document import Display, Document
from armproof.verification.errors import DocumentError, TooComplex
from armproof.verification.findings import Kind, say
from armproof.verification.verdict import DocumentResult, Record, Verdict
from tests.laws import SWEEP

Judge = Callable[..., Record]
Check = Callable[..., DocumentResult]


@pytest.mark.parametrize(
    ("latex", "verdict", "message"),
    [
        (r"z_2 = \begin{bmatrix} 0 \\ 0 \\ -1 \end{bmatrix}", Verdict.PROVED, ""),
        (r"|c_1| = \sqrt{c_1^2}", Verdict.CONFIRMED, "an absolute value is not exact"),
        (r"u = a_1 c_1", Verdict.UNCHECKED, "gives u its meaning; no claim that is decided uses u"),
        (r"x = a_1 c_1", Verdict.UNCHECKED, "x is usually origin of frame 4 in frame 0, x"),
        (r"\theta_1 = 0", Verdict.UNCHECKED, "a configuration, not a claim"),
        (r"a_1 c_1", Verdict.UNCHECKED, "states no equation"),
        (r"z_2 = \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}", Verdict.REFUTED, "entry (3, 1): wrong sign"),
        (r"u + v = 3", Verdict.UNCHECKED, "'u' is not bound"),
        (r"c_1 = \frac{1}{2", Verdict.UNREADABLE, "line 1, column 17 of the display: the display ends too early"),
        (r"c_1 = \unknowncommand{3}", Verdict.UNREADABLE, r"'\unknowncommand' is not a command of kinematic LaTeX"),
    ],
)
def test_every_verdict_is_reached(judge: Judge, latex: str, verdict: Verdict, message: str) -> None:
    record = judge(latex)
    assert record.verdict is verdict and message in record.message
    assert (record.line, record.latex, record.erratum) == (1, latex, False)


def test_there_is_one_record_a_display_in_their_order(check: Check) -> None:
    displays = ["c_1 = c_1", r"\frac{", "c_1 = s_1", "u + v = 3", "w = c_1", r"\theta_1 = 0"]
    result = check(*displays, errata=("c_1 = s_2",))
    assert [record.latex for record in result.equations] == [*displays, "c_1 = s_2"]
    assert [record.line for record in result.equations] == list(range(1, 8))
    assert [record.erratum for record in result.equations] == [False] * 6 + [True]


def test_a_display_carries_the_worst_of_its_equations(judge: Judge) -> None:
    assert judge(r"c_1 = c_1, \quad u = c_1, \quad 2u = 2c_1").verdict is Verdict.PROVED
    assert judge(r"c_1 = c_1, \quad |c_1| = \sqrt{c_1^2}").verdict is Verdict.CONFIRMED
    assert judge(r"c_1 = c_1, \quad u + v = 1").verdict is Verdict.UNCHECKED
    record = judge(r"c_1 = c_1, \quad u + v = 1, \quad s_1 = c_1, \quad s_2 = c_2")
    assert record.verdict is Verdict.REFUTED
    assert [entry.equation for entry in record.entries] == [3, 4]


def test_equations_are_counted_through_every_layout(judge: Judge) -> None:
    for latex in (
        r"\begin{aligned} c_1 &= c_1 \\ s_1 &= c_1 \end{aligned}",
        r"\left\{ \begin{array}{l} c_1 = c_1 \\ s_1 = c_1 \end{array} \right.",
        r"\begin{cases} c_1 = c_1 \\ s_1 = c_1 \end{cases}",
        r"c_1 = c_1 \qquad s_1 = c_1",
        r"c_1 = c_1 \text{ and } s_1 = c_1",
    ):
        record = judge(latex)
        assert record.verdict is Verdict.REFUTED, latex
        assert [(entry.equation, entry.printed) for entry in record.entries] == [(2, "c_1")], latex


def test_a_display_may_go_on_with_the_subject_of_the_one_before(check: Check) -> None:
    result = check(r"p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \end{bmatrix}", r"= a_1 \begin{bmatrix} c_1 \\ s_1 \\ 0 \end{bmatrix}", r"= a_1 \begin{bmatrix} c_1 \\ c_1 \\ 0 \end{bmatrix}")  # fmt: skip
    assert [record.verdict for record in result.equations] == [Verdict.PROVED, Verdict.PROVED, Verdict.REFUTED]


def test_half_angles_start_the_document_again_with_finer_angles(check: Check) -> None:
    result = check("c_1 = c_1", r"c_1 = 1 - 2\sin^2\frac{\theta_1}{2}", r"s_2 = 2\sin\frac{\theta_2}{3}", r"p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \end{bmatrix}")  # fmt: skip
    assert [record.verdict for record in result.equations] == [
        Verdict.PROVED,
        Verdict.PROVED,
        Verdict.REFUTED,
        Verdict.PROVED,
    ]


def test_a_verdict_does_not_depend_on_what_is_confirmed_or_repeated(check: Check) -> None:
    displays = (
        r"p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 c_1 \\ 0 \end{bmatrix}",
        r"c_{12} = c_1 c_2 - s_1 s_2",
        "x = s_1",
        "x = c_1",
    )
    first, again, bare = check(*displays), check(*displays), check(*displays, confirm=False)
    assert [r.as_json() for r in first.equations] == [r.as_json() for r in again.equations]
    assert [r.verdict for r in first.equations] == [r.verdict for r in bare.equations]


def test_proofs_hold_on_the_double_plant_at_a_thousand_configurations_of_six_families(judge: Judge) -> None:
    record = judge(r"T^0_4 = A^0_1 A^1_2 A^2_3 A^3_4")
    assert record.samples == 1000 and record.max_error is not None and record.max_error <= 1e-12


# -- whatever is combined gets a verdict -----------------------------------------------------------------------------------

ATOMS = ["I", "2", "z_1", "T^0_1", "(1, 2)", r"\{1, 2\}", "[1, 2, 3]", "c_1", "J", r"\dot q", "|c_1|", "x", "f(q)", r"\operatorname{atan2}(s_1, c_1)", r"\sqrt{a_1^2 + a_2^2}", r"\cdots"]  # fmt: skip
UNARY = ["-{}", "{}^T", "{}^{{-1}}", "{}^2", "{}^{{1/2}}", r"{}^\circ", r"\det({})", r"\operatorname{{tr}}({})", r"\cos({})", r"\sqrt{{{}}}", r"\frac{{{}}}{{2}}", r"\frac{{1}}{{{}}}", r"\frac{{\partial {}}}{{\partial\theta_1}}", r"\frac{{\partial c_1}}{{\partial {}}}", r"\frac{{d}}{{dt}} {}", r"\left.{}\right|_{{\theta_1 = 0}}", r"\begin{{bmatrix}} {} & 1 \\ 0 & 1 \end{{bmatrix}}", r"Rot(z, {})", r"\underbrace{{{}}}_{{3\times 1}}", r"\arccos({})"]  # fmt: skip
BINARY = [
    "{} + {}",
    "{} {}",
    r"{} \times {}",
    r"{} \cdot {}",
    r"\frac{{{}}}{{{}}}",
    r"{} \pm {}",
    r"\begin{{bmatrix}} {} & {} \end{{bmatrix}}",
]
RELATIONS = [r"{} \le {}", r"{} \neq {}", r"{} \approx {}", r"{} \in {}", r"{} = 0 \iff {} = 0"]


def test_one_operation_on_anything_gets_a_verdict(check: Check) -> None:
    displays = [f"y = {form.format(atom)}" for form, atom in itertools.product(UNARY, ATOMS)]
    assert_each_has_a_record(check, displays)


def test_two_of_anything_get_a_verdict(check: Check) -> None:
    displays = [f"z_1 = {form.format(a, b)}" for form, a, b in of_each_pair(BINARY)]
    assert_each_has_a_record(check, displays)


def test_any_relation_between_anything_gets_a_verdict(check: Check) -> None:
    relations = [form.format(a, b) for form, a, b in of_each_pair(RELATIONS)]
    assert_each_has_a_record(check, relations)


def test_a_connective_may_stand_at_either_end(check: Check) -> None:
    words = (r"\Rightarrow", r"\iff", r"\vee", r"\land", r"\text{if}", r"\text{with}", r"\forall", r"\exists")
    claims = ("x = l_1", r"\theta_2 = 0", "C_1 C_2")
    assert_each_has_a_record(check, [f"{word} {claim}" for word in words for claim in claims])
    assert_each_has_a_record(check, [f"{claim} {word}" for word in words for claim in claims])
    assert_each_has_a_record(check, [f"{a} {b} x = l_1" for a in words for b in words])


def of_each_pair(forms: Sequence[str]) -> Iterator[tuple[str, str, str]]:
    """Yield each form with each pair of atoms in a sweep; else each form with each atom at each of its places."""
    for (k, form), (i, a), (j, b) in itertools.product(enumerate(forms), enumerate(ATOMS), enumerate(ATOMS)):
        if SWEEP or (i + j + k) % (2 * len(forms)) == 0:
            yield form, a, b


def assert_each_has_a_record(check: Check, displays: list[str]) -> None:
    """Check the displays together: each has its record, and none is a fault of ours."""
    with np.errstate(all="ignore"):
        records = check(*displays, confirm=False).equations
    assert len(records) == len(displays)
    faults = [f"{record.latex}: {record.message}" for record in records if "internal error" in record.message]
    assert not faults, f"{len(faults)} displays, such as {faults[:5]}"


# -- bounds ----------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "latex",
    [
        r"(\cos\theta_1 + \cos\theta_2 + \sin\theta_4 + a_1 + a_2 + d_3 + d_4)^{24} = 1",
        r"\cos(1000000\theta_1) = 1",
        r"\det(" + "T^0_4 " * 200 + ") = 1",
        "1 + " * 3000 + "1 = 3001",
    ],
    ids=["a large power", "a large multiple", "a long product", "a long sum"],
)
def test_no_display_takes_much_longer_than_two_seconds(judge: Judge, latex: str) -> None:
    start = time.process_time()
    record = judge(latex)
    assert time.process_time() - start < 4
    assert record.verdict in (Verdict.PROVED, Verdict.UNCHECKED, Verdict.UNREADABLE)
    assert record.verdict is Verdict.PROVED or record.message


def test_what_is_too_large_says_so_and_the_rest_is_checked(check: Check) -> None:
    result = check(r"(c_1 + c_2 + a_1 + a_2 + d_3 + d_4 + s_4)^{24} = 1", "c_1 = c_1", "c_1 = s_1")
    assert [record.verdict for record in result.equations] == [Verdict.UNCHECKED, Verdict.PROVED, Verdict.REFUTED]
    assert "too large to decide" in result.equations[0].message


def test_a_corrected_term_is_never_a_page_long(judge: Judge) -> None:
    record = judge(r"(c_1 + c_2 + a_1 + a_2 + d_3 + d_4 + s_4)^8 = c_1")
    assert record.verdict is Verdict.REFUTED
    assert len(record.message) < 5_000 and all(len(entry.correct) < 5_000 for entry in record.entries)


# -- documents that cannot be checked ----------------------------------------------------------------------------------------


def page(**front: Any) -> Document:
    return Document(Path("page.md"), front, (), (), lines={"arm": 4, "quantities": 9})


def test_an_unknown_arm_is_named_with_its_line() -> None:
    with pytest.raises(DocumentError, match=r"page\.md:4: .*no_such_arm"):
        check_document(page(arm="no_such_arm"))


def test_a_binding_that_means_nothing_is_named_with_its_line() -> None:
    with pytest.raises(
        DocumentError, match=r"page\.md:9: quantity 'X': no frame '9' on arm 'scara'; its frames are 0, 1, 2, 3, 4"
    ):
        check_document(page(arm="scara", quantities={"X": {"origin": 9}}))


def test_a_file_is_read_and_checked(tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text(
        "---\narm: planar_2r\n---\n\n$$ p_1 = l_1 \\begin{bmatrix} c_1 \\\\ s_1 \\\\ 0 \\end{bmatrix} $$\n",
        encoding="utf-8",
    )
    result = verify(path)
    assert (result.arm, result.passed, [r.line for r in result.equations]) == ("planar_2r", True, [5])
    assert result.equations[0].verdict is Verdict.PROVED
    with pytest.raises(ArmproofError, match=r"no_page\.md"):
        verify(tmp_path / "no_page.md")


def test_what_cannot_be_read_in_a_notebook_is_told_with_its_cell() -> None:
    displays = (Display(3, r"x = \foo", cell=2), Display(3, r"x = \foo"))
    in_cell, alone = check_document(Document(Path("page.md"), {"arm": "planar_2r"}, displays, ())).equations
    assert in_cell.says(Kind.UNREADABLE_IN_CELL) and "cell 2" in in_cell.message and "'\\foo'" in in_cell.message
    assert alone.says(Kind.UNREADABLE) and "cell" not in alone.message


@pytest.mark.parametrize(
    ("fault", "verdict", "says"),
    [
        (RecursionError(), Verdict.UNCHECKED, "nested too deeply"),
        (TooComplex(say(Kind.TOO_MANY_FRACTIONS)), Verdict.UNCHECKED, str(say(Kind.TOO_MANY_FRACTIONS))),
        (ZeroDivisionError("one over none"), Verdict.UNREADABLE, "please report it: ZeroDivisionError: one over none"),
    ],
)
def test_a_fault_of_ours_costs_one_display_its_verdict(
    check: Check, monkeypatch: pytest.MonkeyPatch, fault: Exception, verdict: Verdict, says: str
) -> None:
    judge_display = Statements.check

    def fail_on_line_2(self: Statements, statements: Any, line: int, **options: Any) -> Any:
        if line == 2:
            raise fault
        return judge_display(self, statements, line, **options)

    monkeypatch.setattr(Statements, "check", fail_on_line_2)
    records = check("s_1 = s_1", "s_1 = c_1", "s_1 = c_1").equations
    assert [record.verdict for record in records] == [Verdict.PROVED, verdict, Verdict.REFUTED]
    assert says in records[1].message


def test_what_cannot_be_explained_in_time_stays_refuted(judge: Judge, monkeypatch: pytest.MonkeyPatch) -> None:
    def too_large(*_: Any) -> Record:
        raise TooComplex(say(Kind.TOO_MANY_FRACTIONS))

    monkeypatch.setattr(Diagnostician, "diagnose", too_large)
    record = judge("s_1 = c_1")
    assert record.verdict is Verdict.REFUTED and record.says(Kind.TOO_LARGE_TO_TELL)


@pytest.mark.parametrize(("length", "corrected"), [("l_1", ["l_2"]), ("l_2", [])])
def test_an_array_is_corrected_where_that_is_asked_for(length: str, corrected: list[str]) -> None:
    rows = rf"1 & l_1 & 0 & 0 & \theta_1 \\ 2 & {length} & 0 & 0 & \theta_2"
    array = rf"\begin{{array}}{{c|cccc}} i & a & \alpha & d & \theta \\ {rows} \end{{array}}"
    (record,) = verify_text(f"---\narm: planar_2r\n---\n\n$$ {array} $$\n", correct=True).equations
    assert [mend.text for mend in record.corrections or ()] == corrected


def test_the_arm_of_the_front_matter_is_told_with_the_keys_that_name_it() -> None:
    (arm,) = verify_text("---\ntitle: A page\narm: scara\ntransforms: lower\nquantities: {}\n---\n\n$$ 1 = 1 $$\n").arms
    assert arm.front == {"arm": "scara", "transforms": "lower"}
    assert (arm.name, arm.line, arm.source, arm.transforms) == ("scara", 3, "front matter", "lower")


@pytest.mark.parametrize(
    ("behind", "verdict"),
    [("P_x = x_1 + x_2", Verdict.UNCHECKED), ("d = x_2 - x_1", Verdict.REFUTED), ("P_x = x_2", Verdict.REFUTED)],
)
def test_a_part_that_a_later_display_adds_to_a_coordinate_is_no_coordinate(behind: str, verdict: Verdict) -> None:
    displays = "".join(f"\n$$ {latex} $$\n" for latex in (r"x_1 = l_1 c_1, \quad x_2 = l_2 c_{12}", behind))
    found = verify_text(f"---\ntitle: Parts\narm: planar_2r\n---\n{displays}")
    assert found.equations[0].verdict is verdict
