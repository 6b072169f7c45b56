"""An arm of the catalogue that the text names is compared with the document's table: a remark, and no verdict."""

from __future__ import annotations

import pytest

from armproof import verify_text

KHALIL = """# The Stäubli RX-90

| j | σ | α_j | d_j | θ_j | r_j |
|---|---|---|---|---|---|
| 1 | 0 | 0 | 0 | θ_1 | 0 |
| 2 | 0 | π/2 | 0 | θ_2 | 0 |
| 3 | 0 | 0 | D_3 | θ_3 | 0 |
| 4 | 0 | -π/2 | 0 | θ_4 | RL4 |
| 5 | 0 | π/2 | 0 | θ_5 | 0 |
| 6 | 0 | -π/2 | 0 | θ_6 | 0 |

$$ {}^2T_3 = \\begin{bmatrix} C3 & -S3 & 0 & D_3 \\\\ S3 & C3 & 0 & 0 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$

$$ {}^3T_4 = \\begin{bmatrix} C4 & -S4 & 0 & 0 \\\\ 0 & 0 & 1 & RL4 \\\\ -S4 & -C4 & 0 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$
"""
OTHER = KHALIL.replace("| 6 | 0 | -π", "| 6 | 0 | π")


def test_the_rows_that_differ_are_named_and_nothing_is_refuted_for_it() -> None:
    assert verify_text(KHALIL).remarks == ()
    result = verify_text(OTHER)
    (remark,) = result.remarks
    assert str(remark) == (
        "the text names 'rx90': rows of the table at line 3 that differ from that arm of the catalogue: 6"
    )
    assert [record.verdict.value for record in result.records] == ["proved", "proved", "defined"]


@pytest.mark.parametrize("text", [OTHER.replace("RX-90", "TX-90"), OTHER.replace("RX-90", "RX-901")])
def test_another_arm_is_not_the_one_of_the_catalogue(text: str) -> None:
    assert verify_text(text).remarks == ()


@pytest.mark.parametrize("name", ["RX90", "rx 90", "Rx-90"])
def test_a_type_is_found_as_it_is_spelt(name: str) -> None:
    assert len(verify_text(OTHER.replace("RX-90", name)).remarks) == 1


def test_a_length_of_several_letters_is_one_length() -> None:
    wrong = KHALIL.replace("1 & RL4", "1 & -RL4")
    assert verify_text(wrong).equations[1].verdict == "unchecked"  # which of the two is right nobody tells
    assert "RL_4: RL_4" in verify_text(KHALIL).arms[0].front_matter
