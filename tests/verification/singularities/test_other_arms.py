"""Singularities of arms that are not ours, given by DH tables: known results are found, hard ones end with a message."""

from __future__ import annotations

import time
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest

from armproof.models.catalogue import load_arm
from armproof.verification.singularities.analysis import analyse_singularities
from armproof.verification.singularities.families import SingularityAnalysis
from tests.laws import SWEEP
from tests.sweeps.singularities import sweep

UP, DOWN = "pi/2", "-pi/2"
TABLES: dict[str, list[tuple[str, str, str, str]]] = {  # a, alpha, d, theta, classic
    "puma 560": [("0", DOWN, "0", "theta_1"), ("a_2", "0", "d_2", "theta_2"), ("a_3", UP, "0", "theta_3"),
                 ("0", DOWN, "d_4", "theta_4"), ("0", UP, "0", "theta_5"), ("0", "0", "0", "theta_6")],
    "puma 560 in metres": [("0", DOWN, "0", "theta_1"), ("0.4318", "0", "0.15005", "theta_2"), ("0.0203", UP, "0", "theta_3"),
                           ("0", DOWN, "0.4318", "theta_4"), ("0", UP, "0", "theta_5"), ("0", "0", "0.1", "theta_6")],
    "ur5": [("0", UP, "d_1", "theta_1"), ("a_2", "0", "0", "theta_2"), ("a_3", "0", "0", "theta_3"),
            ("0", UP, "d_4", "theta_4"), ("0", DOWN, "d_5", "theta_5"), ("0", "0", "d_6", "theta_6")],
    "stanford": [("0", DOWN, "0", "theta_1"), ("0", UP, "d_2", "theta_2"), ("0", "0", "d_3", "0"),
                 ("0", DOWN, "0", "theta_4"), ("0", UP, "0", "theta_5"), ("0", "0", "d_6", "theta_6")],
    "planar 4R": [("l_1", "0", "0", "theta_1"), ("l_2", "0", "0", "theta_2"), ("l_3", "0", "0", "theta_3"),
                  ("l_4", "0", "0", "theta_4")],
    "orthogonal 3R": [("a_1", UP, "0", "theta_1"), ("a_2", UP, "d_2", "theta_2"), ("a_3", "0", "0", "theta_3")],
    "wrist with an offset": [("0", DOWN, "0", "theta_1"), ("a_2", "0", "0", "theta_2"), ("a_3", DOWN, "0", "theta_3"),
                             ("0", UP, "d_4", "theta_4"), ("0", DOWN, "d_5", "theta_5"), ("0", "0", "d_6", "theta_6")],
    "anthropomorphic 7R": [("0", DOWN, "0", "theta_1"), ("0", UP, "0", "theta_2"), ("0", UP, "d_3", "theta_3"),
                           ("0", DOWN, "0", "theta_4"), ("0", DOWN, "d_5", "theta_5"), ("0", UP, "0", "theta_6"),
                           ("0", "0", "d_7", "theta_7")],
}  # fmt: skip
ROWS = {"planar 4R": (1, 2), "orthogonal 3R": (1, 2, 3)}


@lru_cache(maxsize=16)
def analysis_of(name: str) -> SingularityAnalysis:
    keys = ("a", "alpha", "d", "theta")
    table: dict[str, object] = {"dh": "classic", "rows": [dict(zip(keys, row, strict=True)) for row in TABLES[name]]}
    if name == "stanford":
        table["joints"] = ["theta_1", "theta_2", "d_3", "theta_4", "theta_5", "theta_6"]
    return analyse_singularities(load_arm(table), rows=ROWS.get(name))


@pytest.mark.parametrize("name", sorted(TABLES))
def test_an_analysis_ends_in_time_and_says_what_it_left_out(name: str) -> None:
    started = time.process_time()
    analysis = analysis_of(name)
    assert time.process_time() - started < 60
    assert analysis.complete or analysis.message


@pytest.mark.parametrize(
    ("name", "families"),
    [
        ("puma 560", {r"\theta_5 = 0", r"\theta_5 = \pi", "a_3 S_3 - d_4 C_3 = 0", "a_2 C_2 + d_4 S_{23} + a_3 C_{23} = 0"}),
        ("stanford", {r"\theta_5 = 0", r"\theta_5 = \pi", r"\theta_2 = 0", r"\theta_2 = \pi", "d_3 = 0"}),
        ("planar 4R", {rf"\theta_4 = {a} \text{{ and }} \theta_3 = {b} \text{{ and }} \theta_2 = {c}"
                       for a in ("0", r"\pi") for b in ("0", r"\pi") for c in ("0", r"\pi")}),
        ("ur5", {r"\theta_3 = 0", r"\theta_3 = \pi", r"\theta_5 = 0", r"\theta_5 = \pi",
                 r"a_2 C_2 + a_3 C_{23} + d_5 S_{234} = 0"}),
    ],
)  # fmt: skip
def test_known_families_are_found(name: str, families: set[str]) -> None:
    analysis = analysis_of(name)
    assert {frozenset(family.conditions) for family in analysis.families} == {
        frozenset(text.split(r" \text{ and } ")) for text in families
    }


@pytest.mark.parametrize("name", sorted(TABLES))
def test_a_search_finds_none_off_the_families(name: str) -> None:
    analysis = analysis_of(name)
    if not analysis.complete:
        pytest.skip(analysis.message)
    found = sweep(name, analysis, 200 if SWEEP else 60, np.random.default_rng(21))
    assert not found.stray and not found.wrong_ranks, found


def test_the_seven_joints_are_singular_where_two_conditions_meet() -> None:
    """Kinematically redundant: no single angle makes the arm lose a direction, except the elbow (Burdick 1989)."""
    analysis = analysis_of("anthropomorphic 7R")
    assert analysis.complete and analysis.generic_rank == 6 and analysis.determinant is None
    single = {family.latex for family in analysis.families if family.codimension == 1}
    assert single == {r"\theta_4 = 0", r"\theta_4 = \pi"}
    assert all(family.codimension == 2 for family in analysis.families if family.latex not in single)


def test_one_hard_factor_is_one_family() -> None:
    analysis = analysis_of("wrist with an offset")
    assert analysis.complete and len(analysis.families) == 1 and analysis.families[0].rank == 5


SLANTED = """<robot name="slanted">
<link name="base"/><link name="upper"/><link name="lower"/><link name="tool"/>
<joint name="theta_1" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0.1 0 0.3"/>
  <axis xyz="0 0 -1"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="theta_2" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="0.3 0 0.1" rpy="0.3 0 0"/>
  <axis xyz="1 1 1"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
<joint name="fixed" type="fixed"><parent link="lower"/><child link="tool"/><origin xyz="0 0.4 0.12"/></joint>
</robot>"""


def test_a_resultant_beyond_reach_is_not_begun(tmp_path: Path) -> None:
    (tmp_path / "slanted.urdf").write_text(SLANTED, encoding="utf-8")
    started = time.process_time()
    analysis = analyse_singularities(load_arm(str(tmp_path / "slanted.urdf")))
    assert time.process_time() - started < 30
    assert not analysis.complete and "the resultant of polynomials of" in analysis.message
