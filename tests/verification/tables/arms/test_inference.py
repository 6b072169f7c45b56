"""The arm of a document that names none: read from its DH table, in the reading under which most of its equations hold."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.told_convention import told_convention
from armproof.verification.verdict import DocumentResult, Role

ROWS = "| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ |\n"
PLAIN = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n" + ROWS
MODIFIED_HEADERS = PLAIN.replace("| a | alpha", "| $a_{i-1}$ | $\\alpha_{i-1}$")
FIRST, SECOND, WHOLE = "{}^0T_1", "{}^1T_2", "{}^0T_2"
LAST_ROWS = r"\\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$" + "\n\n"


def pose(name: str, cosine: str, sine: str, x: str, y: str) -> str:
    return f"$$ {name} = \\begin{{bmatrix}} {cosine} & -{sine} & 0 & {x} \\\\ {sine} & {cosine} & 0 & {y} {LAST_ROWS}"


def link(i: int, name: str, y: str = "") -> str:
    return pose(name, f"c_{i}", f"s_{i}", f"l_{i} c_{i}", y or f"l_{i} s_{i}")


def whole(name: str = WHOLE, y: str = "l_1 s_1 + l_2 s_{12}") -> str:
    return pose(name, "c_{12}", "s_{12}", "l_1 c_1 + l_2 c_{12}", y)


def craig(i: int, name: str) -> str:
    return pose(name, f"c_{i}", f"s_{i}", f"l_{i}", "0")


CLASSIC = link(1, FIRST) + link(2, SECOND) + whole()
CRAIG = craig(1, FIRST) + craig(2, SECOND)


def verdicts(result: DocumentResult) -> list[str]:
    return [record.verdict.value for record in result.equations]


def test_the_arm_of_a_table_is_data_and_proves_what_holds_on_it() -> None:
    result = verify_text(PLAIN + "\n" + CLASSIC)
    (arm,), (table,) = result.arms, result.tables
    assert (arm.source, arm.line, arm.convention, arm.transforms) == ("table", 1, "classic", "upper")
    assert table.verdict == "defined" and [each.role for each in table.outcomes] == [Role.DATA]
    assert verdicts(result) == ["proved"] * 3
    assert all("for the arm of the table at line 1" in record.message for record in result.equations)
    assert [record.arm_index for record in result.records] == [0] * 4
    assert (
        result.as_json()["arms"][0]["from"] == "table" and "dh: classic" in result.as_json()["arms"][0]["front_matter"]
    )


def test_what_a_wrong_entry_should_be_is_told_where_the_product_confirms_the_table() -> None:
    result = verify_text(PLAIN + "\n" + link(1, FIRST) + link(2, SECOND, "-l_2 s_2") + whole())
    assert verdicts(result) == ["proved", "refuted", "proved"]
    (entry,) = result.equations[1].entries
    assert (entry.row, entry.column, entry.correct) == (2, 4, "l_2 s_2")


def test_where_nothing_tells_table_and_matrix_apart_neither_is_refuted() -> None:
    other = link(2, SECOND).replace("l_2", "l_1")  # as another row would give it
    result = verify_text(PLAIN + "\n" + link(1, FIRST) + other)
    assert verdicts(result) == ["proved", "unchecked"]
    assert "differs from the table at line 1" in result.equations[1].message


def test_a_matrix_that_no_row_gives_is_refuted_beside_its_table() -> None:
    result = verify_text(PLAIN + "\n" + link(1, FIRST) + link(2, SECOND, "-l_2 s_2"))
    assert verdicts(result) == ["proved", "refuted"]
    assert [(entry.row, entry.column) for entry in result.equations[1].entries] == [(2, 4)]


def test_a_wrong_row_of_the_table_refutes_no_right_matrix() -> None:
    result = verify_text(PLAIN.replace("| 2 | $l_2$", "| 2 | $l_1$") + "\n" + CLASSIC)
    assert [arm.source for arm in result.arms] == ["matrices"] and set(verdicts(result)) == {"proved"}
    assert result.tables[0].verdict == "unchecked" and "which of the two is right" in result.tables[0].message
    assert [(entry.row, entry.printed, entry.correct) for entry in result.tables[0].entries] == [(2, "l_1", "l_2")]
    alone = verify_text(PLAIN.replace("| 2 | $l_2$", "| 2 | $l_1$") + "\n" + link(1, FIRST) + whole())
    assert "refuted" not in verdicts(alone)


@pytest.mark.parametrize("table", [PLAIN, MODIFIED_HEADERS], ids=["open headers", "modified headers"])
@pytest.mark.parametrize(("displays", "convention"), [(CLASSIC, "classic"), (CRAIG, "modified")])
def test_the_matrices_tell_the_convention_and_not_the_headers(table: str, displays: str, convention: str) -> None:
    rows = table.replace("| 1 | $l_1$", "| 1 | $l_1$")
    result = verify_text(rows + "\n" + displays)
    assert result.arms[0].convention == convention and set(verdicts(result)) == {"proved"}


def test_without_a_witness_no_convention_is_guessed() -> None:
    result = verify_text(PLAIN + "\n$$ l_1 > l_2 $$\n")
    assert result.arm == "" and result.arms == ()
    assert result.tables[0].verdict == "unchecked" and "write `convention: classic`" not in result.tables[0].latex
    assert "convention: modified" in result.tables[0].message


def test_the_author_breaks_a_tie() -> None:
    wrong = whole(y="l_1 s_1 - l_2 s_{12}")
    for convention, verdict in (("classic", "refuted"), ("modified", "unchecked")):  # one entry is wrong, or two are
        result = verify_text(f"---\nconvention: {convention}\n---\n{PLAIN}\n" + wrong)
        assert result.arms[0].convention == convention and result.equations[0].verdict == verdict


@pytest.mark.parametrize(
    ("text", "convention"),
    [
        ("The frames follow the modified DH convention.", "modified"),
        ("Les repères sont placés selon la convention de Craig.", "modified"),
        ("We use the standard Denavit-Hartenberg parameters.", "classic"),
        ("Wir verwenden die modifizierte Konvention von Craig.", "modified"),
        ("We use the classical, and not the modified convention.", ""),
        ("See W. Khalil, E. Dombre, Modélisation et commande.", ""),
        ("The parameters are modified below.", ""),
    ],
)
def test_the_text_names_a_convention(text: str, convention: str) -> None:
    assert told_convention(f"# Arm\n\n{text}\n\nThe arm has two joints.\n") == convention


def test_equations_that_speak_against_the_convention_of_the_text_decide_nothing() -> None:
    text = "The frames follow the modified DH convention of Craig.\n\n"
    of_both = CLASSIC + craig(1, FIRST) + craig(2, "T_2")
    assert "refuted" in verdicts(verify_text(PLAIN + "\n" + of_both))
    assert set(verdicts(verify_text(text + PLAIN + "\n" + of_both))) == {"unchecked"}
    assert verdicts(verify_text(text + PLAIN + "\n" + CRAIG)) == ["proved"] * 2
    assert set(verdicts(verify_text(text + PLAIN + "\n" + CLASSIC))) == {
        "unchecked"
    }  # nothing holds by that of the text
    assert "proved" in verdicts(
        verify_text(text.replace("modified DH convention of Craig", "classic DH convention") + PLAIN + "\n" + CLASSIC)
    )


SINGULAR = "$$ J = \\begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\\\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \\end{bmatrix} $$\n\n"


@pytest.mark.parametrize(
    ("zeros", "verdict"),
    [(r"\theta_2 = 0", "refuted"), (r"\theta_2 = 0 \text{ or } \theta_2 = \pi", "proved")],
)
def test_a_condition_is_no_evidence_and_is_refuted_where_the_jacobian_confirms_the_arm(
    zeros: str, verdict: str
) -> None:
    condition = f"$$ \\det J = 0 \\iff {zeros} $$\n"
    alone = verify_text(PLAIN + "\n" + condition)  # det J vanishes everywhere in the other convention
    assert verdicts(alone) == ["unchecked"]
    assert verdicts(verify_text(PLAIN + "\n" + SINGULAR + condition)) == ["proved", verdict]


def test_the_direction_of_the_indices_is_told_by_what_holds() -> None:
    displays = link(1, "T_0^1") + link(2, "T_1^2") + whole("T_0^2")
    result = verify_text(PLAIN + "\n" + displays)
    assert result.arms[0].transforms == "lower" and verdicts(result) == ["proved"] * 3
    turned = verify_text(PLAIN + "\n" + displays.replace("T_0^2", "T^0_2"))
    assert turned.equations[2].verdict != "proved"


def test_a_table_that_contradicts_most_of_the_document_is_no_arm_of_it() -> None:
    other = link(1, FIRST).replace(FIRST, "{}^0M_1") + whole(y="0") + whole(y="l_2 s_1") + craig(1, FIRST)
    result = verify_text(PLAIN + "\n" + other)
    assert result.arms == () and "fits 0" not in result.tables[0].message
    assert "contradicts" in result.tables[0].message


def test_an_arm_in_the_front_matter_is_the_authors() -> None:
    result = verify_text("---\narm: planar_2r\n---\n" + PLAIN + "\n" + CLASSIC)
    assert [arm.source for arm in result.arms] == ["front matter"] and result.arm == "planar_2r"
    assert result.tables[0].verdict == "proved"


def test_a_general_row_gives_no_arm() -> None:
    result = verify_text(
        "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| i | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n"
    )
    assert result.arm == "" and result.tables[0].verdict == "defined"


@pytest.mark.parametrize(
    "table",
    [
        "| Articulation | σ | Longueur | Angle de torsion | Décalage | Angle θ |\n|---|---|---|---|---|---|\n"
        "| 0→1 | 0 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 1→2 | 0 | $l_2$ | 0 | 0 | $\\theta_2$ |\n",
        "| θ (deg) | d (mm) | Link length | Twist |\n|---|---|---|---|\n| $\\theta_1^*$ | 0 | $l_1$ | 0 |\n| $\\theta_2^*$ | 0 | $l_2$ | 0 |\n",
        "| i | 1 | 2 |\n|---|---|---|\n| $\\alpha_i$ | 0 | 0 |\n| $a_i$ | $l_1$ | $l_2$ |\n| $\\theta_i$ | θ1 (variable) | var |\n| $d_i$ | 0 | 0 |\n",
        "$$\n\\begin{array}{c|cccc} i & a_i & \\alpha_i & d_i & \\theta_i \\\\ \\hline 1 & l_1 & 0 & 0 & \\theta_1 \\\\ 2 & l_2 & 0 & 0 & \\theta_2 \\end{array}\n$$\n",
        "| i | $a_i$ (\\si{\\milli\\metre}) | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n"
        "| 1 | $l_1$ | \\SI{0}{\\degree} | \\SI{0}{\\metre} | $\\theta_1$ |\n| 2 | $l_2$ | $\\ang{0}$ | 0 | $\\theta_2$ |\n",
        "<table>\n<tr><th>Link</th><th>a<sub>i</sub></th><th>&alpha;<sub>i</sub></th><th>d<sub>i</sub></th><th>&theta;<sub>i</sub></th></tr>\n"
        "<tr><td>1</td><td>l<sub>1</sub></td><td>0</td><td>0</td><td>&theta;<sub>1</sub></td></tr>\n"
        "<tr><td>2</td><td>l<sub>2</sub></td><td>0</td><td>0</td><td>&theta;<sub>2</sub></td></tr>\n</table>\n",
    ],
    ids=["French", "units and stars", "turned", "array", "siunitx", "HTML"],
)
def test_tables_are_read_as_they_are_written(table: str) -> None:
    result = verify_text(table + "\n" + CLASSIC)
    assert result.arms[0].source == "table" and verdicts(result)[-3:] == ["proved"] * 3
    assert verify_text(table + "\n" + CLASSIC.replace("l_2 s_2", "l_2 c_2")).equations[-2].verdict == "refuted"


def test_a_slide_is_told_by_its_letter_and_a_tool_is_none() -> None:
    table = "| a | alpha | d | theta |\n|---|---|---|---|\n| 0 | $90°$ | $d_1$ | $\\theta_1$ |\n| 0 | 0 | $d_2$ | 0 |\n"
    displays = "$$ {}^0T_2 = \\begin{bmatrix} c_1 & 0 & s_1 & d_2 s_1 \\\\ s_1 & 0 & -c_1 & -d_2 c_1 \\\\ 0 & 1 & 0 & d_1 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$\n"
    result = verify_text(table + "\n" + displays)
    assert "joints: [theta_1, d_2]" in result.arms[0].front_matter and verdicts(result) == ["proved"]
    assert verify_text(table.replace("$d_2$", "$h$") + "\n" + displays).arms == ()


def test_a_letter_with_a_digit_and_a_letter_in_its_index_is_one_letter() -> None:
    table = PLAIN.replace("l_1", "a_{4e2}").replace("l_2", "L_{1,2}")
    displays = CLASSIC.replace("l_1", "a_{4e2}").replace("l_2", "L_{1,2}")
    assert verdicts(verify_text(table + "\n" + displays)) == ["proved"] * 3


def test_latex_tables_give_an_arm_too() -> None:
    rows = "1 & $l_1$ & 0 & 0 & $\\theta_1$ \\\\ 2 & $l_2$ & 0 & 0 & $\\theta_2$ \\\\"
    tabular = f"\\begin{{tabular}}{{ccccc}} $i$ & $a_i$ & $\\alpha_i$ & $d_i$ & $\\theta_i$ \\\\ \\hline {rows} \\end{{tabular}}\n"
    result = verify_text(tabular + CLASSIC, "tex")
    assert result.arms[0].source == "table" and verdicts(result) == ["proved"] * 3


def test_beside_lengths_the_variable_is_what_is_named_so() -> None:
    table = "| a | alpha | d | theta |\n|---|---|---|---|\n| 0 | 0 | $h + q_1$ | 0 |\n| 0 | 0 | $d_0 + l_3$ | $\\beta_2 + \\theta_2$ |\n"
    display = "$$ p_2 = \\begin{bmatrix} 0 \\\\ 0 \\\\ h + q_1 + d_0 + l_3 \\end{bmatrix} $$\n"
    result = verify_text(table + "\n" + display)
    assert "joints: [q_1, theta_2]" in result.arms[0].front_matter and verdicts(result) == ["proved"]
    assert "proved" not in verdicts(verify_text(table + "\n" + display.replace("+ q_1", "- q_1")))


def test_merged_cells_of_html_are_no_table() -> None:
    merged = "<table>\n<tr><th>a</th><th>alpha</th><th colspan='2'>d and theta</th></tr>\n<tr><td>1</td><td>0</td><td>0</td><td>q1</td></tr>\n</table>\n"
    assert verify_text(merged).tables == ()


def test_a_fault_of_ours_while_readings_are_weighed_costs_no_document(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise IndexError("tuple index out of range")

    assert verify_text(PLAIN + "\n" + CLASSIC).arms
    monkeypatch.setattr("armproof.verification.tables.arms.witnesses._Trial._take_chain", fail)
    assert verify_text(PLAIN + "\n" + CLASSIC).arms == ()


WRIST = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 4 | 0 | -90° | 0 | θ_4 |\n| 5 | 0 | 90° | 0 | θ_5 |\n| 6 | 0 | 0 | d_6 | θ_6 |\n\n"


def test_the_frames_of_a_wrist_are_numbered_as_its_joints() -> None:
    result = verify_text(
        WRIST
        + "$$ p_6^3 = \\begin{bmatrix} c_4 s_5 d_6 \\\\ s_4 s_5 d_6 \\\\ c_5 d_6 \\end{bmatrix} $$\n\n$$ T_6^3 = A_4 A_5 A_6 $$\n"
    )
    assert "first: 3" in result.arms[0].front_matter
    assert verdicts(result) == ["proved", "proved"]
    assert not verify_text(WRIST.replace("θ_5", "θ_7") + "$$ T_6^3 = A_4 A_5 A_6 $$\n").arms


def test_a_pose_that_no_other_last_link_makes_right_is_refuted() -> None:
    """The first link is confirmed: l_2 c_2 beside c_12 is no turn of the second alone; another d_2 would be one."""
    last = [whole(y="l_1 s_1 + l_2 s_2"), whole().replace("& 0 & 1 & 0 \\\\ 0", "& 0 & 1 & d_2 \\\\ 0")]
    found = [verify_text(PLAIN + "\n" + link(1, FIRST) + text) for text in last]
    assert [result.equations[-1].verdict.value for result in found] == ["refuted", "unchecked"]


OFFSET = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | a_1 | 0 | 0 | q_1 |\n| 2 | a_2 | 0 | 0 | q_2 + 90° |\n\n"


def test_a_slip_beside_an_offset_is_no_other_reading_of_the_angles() -> None:
    x, y = "$$ x = a_1 \\cos q_1 - a_2 \\sin(q_1 + q_2) $$\n\n", "$$ y = a_1 \\sin q_1 + a_2 \\cos(q_1 + q_2) $$\n\n"
    assert verdicts(verify_text(OFFSET + x + y)) == ["proved", "proved"]
    assert verdicts(verify_text(OFFSET + x + y.replace("+ a_2", "- a_2"))) == ["proved", "refuted"]


def test_a_pose_tells_the_convention_rather_than_a_height_that_slips() -> None:
    table = (
        PLAIN.replace("| $l_2$ | 0 | 0 |", "| $l_2$ | $\\pi$ | 0 |").replace("| $l_1$ | 0 | 0 |", "| 0 | 0 | $h$ |")
        + "| 3 | 0 | 0 | $d_3$ | 0 |\n"
    )
    turned = "$$ T_3^0 = \\begin{bmatrix} c_{12} & s_{12} & 0 & l_2 c_{12} \\\\ s_{12} & -c_{12} & 0 & l_2 s_{12} \\\\ 0 & 0 & -1 & h - d_3 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$\n\n"
    for height, verdict in (("h - d_3", "proved"), ("h + d_3", "refuted")):
        assert verdicts(verify_text(f"{table}\n{turned}$$ p_z = {height} $$\n")) == ["proved", verdict]


NUMBERS = PLAIN.replace("$l_1$", "0.3").replace("$l_2$", "0.2")


@pytest.mark.parametrize(
    ("height", "verdict"), [("a_1 s_1 + a_2 s_{12}", "proved"), ("a_1 s_1 - a_2 s_{12}", "refuted")]
)
def test_a_letter_with_the_number_of_a_row_is_the_entry_of_a_table_of_numbers(height: str, verdict: str) -> None:
    shown = (link(1, FIRST) + link(2, SECOND)).replace("l_1", "0.3").replace("l_2", "0.2")
    whole_one = pose(WHOLE, "c_{12}", "s_{12}", "a_1 c_1 + a_2 c_{12}", height)
    assert verdicts(verify_text(NUMBERS + "\n" + shown + whole_one)) == ["proved", "proved", verdict]


def test_a_column_of_offsets_leaves_the_variable_out() -> None:
    head = "| i | $\\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\\theta_{offset}$ |\n|---|---|---|---|---|\n"
    table = head + "| 1 | 0 | 0 | $d_1$ | 0 |\n| 2 | 0 | $l_2$ | 0 | -90° |\n| 3 | 0 | $l_3$ | 0 | 0 |\n\n"
    said = r"\quad \theta_2 = q_2 - \frac{\pi}{2} $$" + "\n"
    last = craig(3, "{}^2T_3") + craig(2, SECOND).replace("$$\n", said)
    right = verify_text(table + last)
    assert right.arms[0].source == "table" and verdicts(right) == ["proved", "proved"]
    assert "proved" not in verdicts(verify_text(table + last.replace("q_2 -", "q_2 +")))


def test_an_equation_of_defined_names_is_evidence_for_an_arm() -> None:
    displays = "$$ k = l_1 c_1 $$\n\n$$ x = k + l_2 c_{12} $$\n"
    assert [arm.convention for arm in verify_text(PLAIN + "\n" + displays).arms] == ["classic"]


OFFSETS = r"""
| i | theta | d | a | alpha |
|---|---|---|---|---|
| 1 | q_1 | h | 0 | 90° |
| 2 | q_2 + 90° | 0 | b | 0 |
| 3 | q_3 - 90° | 0 | c | 0 |

$$ A_1 = \begin{bmatrix} \cos q_1 & 0 & \sin q_1 & 0 \\ \sin q_1 & 0 & -\cos q_1 & 0 \\ 0 & 1 & 0 & h \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""
OF_ROWS = r"$$ r = b\cos q_2 + c\cos(q_2 + q_3) $$" + "\n\n" + r"$$ x = r\cos q_1, \quad y = r\sin q_1 $$" + "\n\n"
OF_JOINTS = r"$$ r = -b\sin q_2 + c\cos(q_2 + q_3) $$" + "\n\n" + r"$$ x = r\cos q_1, \quad y = r\sin q_1 $$" + "\n\n"
HEIGHT_OF_ROWS = r"$$ z = h + b\sin q_2 + c\sin(q_2 + q_3) $$" + "\n\n"
HEIGHT_OF_JOINTS = r"$$ z = h + b\cos q_2 + c\sin(q_2 + q_3) $$" + "\n\n"


def test_one_equation_alone_tells_no_other_reading_of_angles_with_offsets():
    assert verdicts(verify_text("Classic DH.\n" + OFFSETS + HEIGHT_OF_JOINTS)) == ["proved", "proved"]
    assert verdicts(verify_text("Classic DH.\n" + OFFSETS + HEIGHT_OF_ROWS)) == [
        "proved",
        "unchecked",
    ]  # a slip, perhaps
    both = verify_text("Classic DH.\n" + OFFSETS + OF_ROWS + HEIGHT_OF_ROWS)
    assert verdicts(both) == ["proved", "defined", "proved", "proved"]


def test_what_rests_on_a_formula_of_angles_with_offsets_tells_how_they_are_read():
    right = verify_text("Classic DH.\n" + OFFSETS + OF_JOINTS + HEIGHT_OF_JOINTS)
    assert verdicts(right) == ["proved", "defined", "proved", "proved"]
    wrong = verify_text("Classic DH.\n" + OFFSETS + OF_JOINTS + HEIGHT_OF_ROWS)
    assert verdicts(wrong) == ["proved", "defined", "proved", "unchecked"]


def test_two_entries_of_a_point_tell_that_angles_are_those_of_the_table():
    head = "---\narm:\n  dh: classic\n  rows:\n    - {a: a_1, alpha: 0, d: 0, theta: theta_1 + pi/2}\n---\n\n"
    point = r"$$ p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \end{bmatrix} $$"
    assert verdicts(verify_text(head + point)) == ["proved"]
    assert verdicts(verify_text(head + r"$$ p_{1x} = a_1 c_1 $$")) == ["unchecked"]
    assert verdicts(verify_text(head + r"$$ p_{1x} = -a_1 s_1 $$")) == ["proved"]


def test_a_convention_that_no_reading_of_the_table_has_is_not_shown() -> None:
    """Of slides alone both conventions make the same arm, and one reading stands for both."""
    head = "The modified DH parameters are\n\n| $i$ | $a_{i-1}$ | $\\alpha_{i-1}$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n"
    rows = (
        "| 1 | $0$ | $0$ | $d_1$ | $\\theta_1$ |\n| 2 | $0$ | $0$ | $d_2$ | $0$ |\n| 3 | $0$ | $0$ | $d_3$ | $0$ |\n\n"
    )
    printed = r"$$ T_3^0 = \begin{bmatrix} c_1 & -s_1 & 0 & d_3 s_1 \\ s_1 & c_1 & 0 & -d_3 c_1 \\ 0 & 0 & 1 & d_1 + d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    assert [record.verdict.value for record in verify_text(head + rows + printed).equations] == ["unchecked"]
