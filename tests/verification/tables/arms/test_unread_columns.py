"""A column that no parameter stands in may change what the others say: then a table gives no arm."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

TIP = (r"$$ x = b_1 \cos q_1 + b_2 \cos(q_1 + q_2) $$", r"$$ \dot x = -b_1 \sin q_1 \dot q_1 - b_2 \sin(q_1 + q_2) (\dot q_1 + \dot q_2) $$")  # fmt: skip


def verdicts(header: str, *cells: str) -> set[Verdict]:
    rows = (f"| {k} | $b_{k}$ | 0 | 0 | $q_{k}$ | {cell} |" for k, cell in enumerate(cells, start=1))
    table = "\n".join(
        (f"| $i$ | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ | {header} |", "|---|---|---|---|---|---|", *rows)
    )
    text = f"Classic Denavit-Hartenberg parameters:\n\n{table}\n\n" + "\n\n".join(TIP)
    return {record.verdict for record in verify_text(text).equations}


@pytest.mark.parametrize(
    ("header", "cells"),
    [
        ("home", ("0", "90")),
        ("zero", (r"$q_1$", r"$q_2 - 90^\circ$")),
        (r"$\varepsilon_i$", ("$+1$", "$-1$")),
        ("gear", ("1:1", "1:2")),
        ("remark", ("0–170°", "170°")),
        ("remark", ("", r"bolted at $30^\circ$")),
        ("Bemerkung", ("", "umgekehrt")),
        ("posture", ("", "welded")),
    ],
)
def test_what_may_change_an_angle_gives_no_arm(header: str, cells: tuple[str, str]) -> None:
    assert verdicts(header, *cells) == {Verdict.UNCHECKED}


@pytest.mark.parametrize(
    ("header", "cells"),
    [
        ("limits", (r"$\pm 90^\circ$", r"$0 \ldots 150^\circ$")),
        ("Bereich", ("-170..170", "-120..120")),
        ("mass", ("2.5 kg", "1.5 kg")),
        ("home", ("0", "0")),
        ("remark", ("0–170°", r"$\pm 90^\circ$")),
        ("remark", ("shoulder", "elbow")),
        ("remark", ("", "")),
        ("variable", ("$q_1$", "$q_2$")),
    ],
)
def test_bounds_names_and_masses_change_none(header: str, cells: tuple[str, str]) -> None:
    assert verdicts(header, *cells) == {Verdict.PROVED}


def test_a_table_is_known_by_its_german_and_italian_words() -> None:
    rows = "|---|---|---|---|\n| $\\theta_1$ | $d_1$ | 0 | 90° |\n| $\\theta_2$ | 0 | $a_2$ | 0° |\n\n$$ z = d_1 + a_2 \\sin\\theta_2 $$\n\n$$ x = a_2 \\cos\\theta_1 \\cos\\theta_2 $$\n"
    for header in (
        "| Gelenkwinkel | Gelenkabstand | Armlänge | Verdrehwinkel |\n",
        "| Angolo | Scostamento | Lunghezza | Torsione |\n",
    ):
        (arm,) = verify_text("\n" + header + rows).arms
        assert arm.source == "table"
        assert verify_text("\n" + header + rows.replace("d_1 +", "d_1 -")).equations[0].verdict.value == "refuted"
