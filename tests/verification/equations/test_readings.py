"""Parts of the Jacobian by their place: which name means which column, block or entry, told by the size of the other side."""

from __future__ import annotations

from typing import Any

import pytest

from armproof.models.catalogue import load_arm
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring
from armproof.verification.equations.jacobian_rows import _likely_rows as likely_rows
from armproof.verification.equations.readings import _part_of_jacobian as part_of_jacobian
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import read_names
from armproof.verification.verdict import Verdict
from tests.labelled.judging import verify_text

RING = Ring()
SCALAR = RING.one
TOOL = {"J": {"jacobian": 4}}
SOME = {"J": {"jacobian": 4, "rows": [1, 3, 6], "columns": [2, 4]}}


def zeros(rows: int, columns: int = 1) -> Matrix:
    return Matrix(((RING.zero,) * columns,) * rows)


def part(latex: str, value: Any, quantities: dict[str, Any] = TOOL, arm: str | None = "scara") -> Quantity | None:
    names: Names = read_names(load_arm(arm) if arm else None, {"quantities": quantities} if arm else {})
    name = n.ungrouped(names.reader.read_expression(latex))
    assert isinstance(name, n.Name)
    return part_of_jacobian(name, value, names)


@pytest.mark.parametrize("rows", range(1, 8))
def test_a_column_has_two_three_four_or_six_rows(rows: int) -> None:
    found = part("J_2", zeros(rows))
    assert found == (Quantity("jacobian", "4", "0", columns=(2,)) if rows in (2, 3, 4, 6) else None)
    assert part("J_2", zeros(rows, 2)) is None


@pytest.mark.parametrize(("name", "rows"), [("J_{v1}", (1, 2, 3)), (r"J_{\omega 1}", (4, 5, 6))])
def test_a_block_of_a_column_has_three_rows(name: str, rows: tuple[int, ...]) -> None:
    assert part(name, zeros(3)) == Quantity("jacobian", "4", "0", rows=rows, columns=(1,))
    assert [part(name, zeros(count)) for count in (1, 2, 4, 6)] == [None] * 4
    assert part(name, SCALAR) is None


def test_an_entry_is_a_scalar_of_its_row_and_column() -> None:
    entry = Quantity("jacobian", "4", "0", rows=(6,), columns=(4,), scalar=True)
    assert part("J_{64}", SCALAR) == part("J_{6,4}", SCALAR) == entry
    assert part("J_{11}", SCALAR) == Quantity("jacobian", "4", "0", rows=(1,), columns=(1,), scalar=True)
    assert [part(name, SCALAR) for name in ("J_{71}", "J_{01}", "J_{15}", "J_{10}")] == [None] * 4
    assert part("J_{64}", zeros(6)) is None and part("J_4", SCALAR) is None


@pytest.mark.parametrize("name", ["J_0", "J_5", "K_1", "J_1'", r"\dot J_1", "J_{x1}", "J_a", "J"])
def test_another_name_is_the_documents_own(name: str) -> None:
    assert part(name, zeros(6)) is None
    assert part("J_1", zeros(6), arm=None) is None


def test_rows_and_columns_are_counted_in_what_the_front_matter_binds() -> None:
    assert part("J_{31}", SCALAR, SOME) == Quantity("jacobian", "4", "0", rows=(6,), columns=(2,), scalar=True)
    assert part("J_2", zeros(3), SOME) == Quantity("jacobian", "4", "0", rows=(1, 3, 6), columns=(4,))
    assert part("J_3", zeros(3), SOME) is None and part("J_{41}", SCALAR, SOME) is None
    assert part("J_1", zeros(3), {"J": {"origin": 4}}) is None


def test_a_reference_is_a_frame_of_the_arm() -> None:
    assert part("{}^2J_1", zeros(6)) == Quantity("jacobian", "4", "2", columns=(1,))
    assert part("{}^9J_1", zeros(6)) is None


def test_a_shorter_jacobian_holds_the_rows_that_are_usual() -> None:
    value = Matrix(((RING.zero,), (RING.one,), (RING.zero,), (RING.one,)))
    assert list(likely_rows(value)) == [(1, 2, 3), (1, 2), (2, 4), (4, 5, 6)]
    assert list(likely_rows(SCALAR)) == []


def test_a_jacobian_with_a_slip_is_of_the_frame_of_which_fewer_entries_are_wrong() -> None:
    front = "---\narm:\n  dh: modified\n  rows:\n  - {a: 0, alpha: 0, d: 0, theta: theta_1}\n  - {a: L_1, alpha: 0, d: 0, theta: theta_2}\n  joints: [theta_1, theta_2]\n  tool:\n    xyz: [L_2, 0, 0]\n---\n"
    rows = r"-L_1 s_1 - L_2 s_{12} & -L_2 s_{12} \\ L_1 c_1 + L_2 c_{12} & L_2 s_{12}"
    displays = rf"$$ J = \begin{{bmatrix}} {rows} \end{{bmatrix}} $$", r"$$ \det J = L_1 L_2 s_2 $$"
    jacobian, determinant = verify_text(front + "\n\n".join(displays) + "\n").equations
    assert jacobian.message.startswith("entry (2, 2): sine for cosine")
    assert determinant.verdict is Verdict.PROVED
