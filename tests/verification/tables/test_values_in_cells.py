"""Numbers in the cells of a table: units, decimal commas, and the values of letters."""

from __future__ import annotations

import pytest

from armproof import verify_text

TABLE = """| i | a | alpha | d | theta |
|---|---|---|---|---|
| 1 | {} | 0 | 0 | $\\theta_1$ |
| 2 | {} | 0 | 0 | $\\theta_2$ |

"""
SHOWN = "$$ x = {} c_1 + {} c_{{12}} $$\n\n$$ y = {} s_1 + {} s_{{12}} $$\n"
LINK = "$$ T_2^1 = \\begin{{bmatrix}} c_2 & -s_2 & 0 & {0} c_2 \\\\ s_2 & c_2 & 0 & {0} s_2 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{{bmatrix}} $$\n\n"
FRONT = "---\narm:\n  dh: classic\n  rows:\n    - {a: l_1, alpha: 0, d: 0, theta: theta_1}\n    - {a: l_2, alpha: 0, d: 0, theta: theta_2}\n---\n"


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


@pytest.mark.parametrize(
    ("cells", "one", "two"),
    [
        (("450 mm", "300 mm"), "0.45", "0.3"),
        (("450 mm", "300 mm"), "450", "300"),
        (("45 cm", "0.3 m"), "0.45", "0.3"),
        (("0,45", "0,3"), "0.45", "0.3"),
        (("-0.45", "$300\\,\\text{mm}$"), "-0.45", "0.3"),
        (("l_1 (450 mm)", "l_2 (300 mm)"), "l_1", "l_2"),
        (("$l_1$ = 450 mm", "$l_2$: 300"), "l_1", "l_2"),
        (("l_1 ≈ -0.45", "l_2 [0.3]"), "l_1", "l_2"),
    ],
)
def test_a_length_is_read_with_its_unit_or_by_its_letter(cells: tuple[str, str], one: str, two: str) -> None:
    text = TABLE.format(*cells) + LINK.format(two)
    assert verdicts(text + SHOWN.format(one, two, one, two)) == ["proved"] * 3
    assert "proved" not in verdicts(text + SHOWN.format(two, one, two, one))[1:]


def test_a_column_in_millimetres_is_in_metres_where_the_displays_are() -> None:
    table = TABLE.replace("| a |", "| a (mm) |").format("450", "300")
    for one, two in (("0.45", "0.3"), ("450", "300")):
        text = table + LINK.format(two) + SHOWN.format(one, two, one, two)
        assert verdicts(text) == ["proved"] * 3
    assert "proved" not in verdicts(table + LINK.format("4.5"))


@pytest.mark.parametrize(("unit", "right", "wrong"), [("mm", "450", "400"), ("cm", "45", "40"), ("m", "0.45", "0.4")])
def test_a_wrong_length_is_corrected_in_the_unit_of_its_column(unit: str, right: str, wrong: str) -> None:
    table = TABLE.replace("| a |", f"| a ({unit}) |")
    front = FRONT.replace("l_1", "0.45").replace("l_2", "0.45")
    assert verify_text(front + table.format(right, right)).tables[0].verdict.value == "proved"
    [entry] = verify_text(front + table.format(right, wrong)).tables[0].entries
    assert (entry.row, entry.column, entry.correct) == (2, 2, right)


@pytest.mark.parametrize("cell", ["1,250", "l_1 (2 l_2)", "450 mm^2"])
def test_what_is_no_length_for_certain_gives_no_arm(cell: str) -> None:
    assert not verify_text(TABLE.format(cell, "l_2") + LINK.format("l_2")).arms


def test_a_value_beside_a_letter_of_the_front_matter_is_data() -> None:
    def verdict(*cells: str) -> str:
        return verify_text(FRONT + TABLE.format(*cells)).tables[0].verdict.value

    assert verdict("l_1 = 0.45", "l_2 = 300 mm") == "proved"
    assert verdict("l_2 = 0.45", "l_1 = 300 mm") == "refuted"
    assert verdict("450 mm", "l_2") == "unchecked"  # no number to compare it with
    assert verdict("0", "l_2") == "refuted"


PLACE = "$$ \\theta_1 = 30^\\circ, \\quad \\theta_2 = 60^\\circ $$\n\n"


@pytest.mark.parametrize("front", ["", FRONT])
@pytest.mark.parametrize(
    ("cells", "claim", "verdict"),
    [
        (("$l_1 = 0.45$", "l_2 (250 mm)"), r"\det J = 0.0974", "confirmed"),
        (("$l_1 = 0.45$", "l_2 (250 mm)"), r"\det J = 0.0974 + 0.02", "refuted"),
        (("$l_1 = 0.45$", "$l_2$"), r"\det J = 0.0974", "unchecked"),  # some length makes it right
        (("$l_1$", "$l_2$"), r"\det J = 0.0974", "unchecked"),
        (("$l_1$", "$l_2$"), r"\det J = 0.0974 \sqrt{3}", "unchecked"),
        (("$l_1$", "$l_2$"), r"\det J = \frac{\sqrt{3}}{2} l_1 l_2", "confirmed"),
        (("$l_1 = 0.45$", "$l_2 = 0.25$"), r"x = \frac{9}{20} c_1 + \frac{1}{4} c_{12}", "confirmed"),
        (("$l_1 = 0.45$", "$l_2 = 0.25$"), r"x = \frac{1}{4} c_1 + \frac{9}{20} c_{12}", "unchecked"),
    ],
)
def test_numbers_below_are_decided_with_the_lengths_of_the_table(
    cells: tuple[str, str], claim: str, verdict: str, front: str
) -> None:
    text = front + TABLE.format(*cells) + SHOWN.format("l_1", "l_2", "l_1", "l_2") + f"\n{PLACE}$$ {claim} $$\n"
    found = verdicts(text)[-1]
    assert (found == "refuted") is (verdict == "refuted") and (found in ("proved", "confirmed")) is (
        verdict == "confirmed"
    )


def test_two_values_of_one_length_tell_none() -> None:
    text = TABLE.format("$l_1 = 0.45$", "$l_2 = 0.25$") + SHOWN.format("l_1", "l_2", "l_1", "l_2")
    other = TABLE.format("$l_1 = 0.35$", "$l_2 = 0.25$")
    claims = f"\n{PLACE}$$ \\det J = 0.0974 $$\n"
    assert verdicts(text + "\n" + other + claims)[-1] == "unchecked"


def test_numbers_beside_letters_are_no_slip_where_no_arm_is_given() -> None:
    text = "$$ x = l_1 c_1 + l_2 c_{12} $$\n\n$$ y = 2 l_1 s_1 - 3 l_2 s_{12} $$\n\n"  # of no arm
    column = r"$$ \begin{bmatrix} x \\ y \end{bmatrix} = \begin{bmatrix} A \\ B \end{bmatrix} $$"
    assert verdicts(text + column.replace("A", "0.39").replace("B", "0.48"))[-1] == "unchecked"
    letters = column.replace("A", "l_1 c_1 + l_2 c_{12}").replace("B", "l_1 s_1 + l_2 s_{12}")
    assert (
        verdicts(
            text + "$$ x^2 = (l_1 c_1 + l_2 c_{12})^2 $$\n\n$$ y^2 = (2 l_1 s_1 - 3 l_2 s_{12})^2 $$\n\n" + letters
        )[-1]
        == "refuted"
    )


PLANAR = "---\narm: planar_2r\n---\n\n"
THIRD = FRONT.replace("{a: l_1,", "{a: l_1/3,") + "\n"
ROWS = ("1 | $l_1$ | 0 | 0 | $\\theta_1$", "2 | $l_2$ | 0 | 0 | $\\theta_2$")


@pytest.mark.parametrize(
    ("front", "rows", "verdict", "says"),
    [
        (PLANAR, ("0 | 0 | 0 | 0 | 0", *ROWS), "proved", "the rows hold in the classic one"),
        (PLANAR, ("0 | $l_1$ | 0 | 0 | 0", *ROWS), "refuted", ""),
        (PLANAR, ("1 | $l_1$ | 0 | 0 | $\\frac{1}{l_1} + 90$", ROWS[1]), "unchecked", "the cosine of a quotient"),
        (PLANAR, ("1 | $l_1$ | 0 | 0 | $l_1\\theta_1$", ROWS[1]), "unchecked", "something that is not a sum of angles"),
        (THIRD, ("1 | $l_1 / 3$ | 0 | 0 | $\\theta_1$", ROWS[1]), "proved", ""),
        (THIRD, ROWS, "refuted", "row 1: a is l_1, should be 1/3 l_1"),
    ],
)
def test_a_row_of_the_base_and_cells_of_any_value(front: str, rows: tuple[str, ...], verdict: str, says: str) -> None:
    header = TABLE.partition("| 1 |")[0]
    (record,) = verify_text(front + header + "".join(f"| {row} |\n" for row in rows)).tables
    assert (record.verdict, says in record.message) == (verdict, True), record.message


@pytest.mark.parametrize(("length", "verdict"), [("l_2", "proved"), ("l_1", "refuted")])
def test_a_cell_of_an_array_may_hold_an_environment(length: str, verdict: str) -> None:
    rows = rf"1 & l_1 & 0 & 0 & \theta_1 \\ 2 & {length} & 0 & \begin{{matrix}} 0 \end{{matrix}} & \theta_2"
    array = rf"\begin{{array}}{{c|cccc}} i & a & \alpha & d & \theta \\ {rows} \end{{array}}"
    assert verdicts(f"{PLANAR}$$ {array} $$\n") == [verdict]
