"""The singular configurations of every arm: families that are all there is, ranks and directions that hold on the double plant."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.singularities.analysis import analyse_singularities
from armproof.verification.singularities.factors import Factor
from armproof.verification.singularities.families import Family, SingularityAnalysis
from armproof.verification.singularities.variety import Variety
from tests.sweeps.singularities import refine, sweep

CASES = [(name, None) for name in arm_names()] + [("planar_3r", (1, 2))]
NAMES = [name if rows is None else f"{name}-{rows}" for name, rows in CASES]
cases = pytest.mark.parametrize(("name", "rows"), CASES, ids=NAMES)


@lru_cache(maxsize=32)
def analysis_of(name: str, rows: tuple[int, ...] | None = None) -> SingularityAnalysis:
    return analyse_singularities(load_arm(name), rows=rows)


def conditions(families: Any) -> set[str]:
    return {family.latex for family in families}


def values(family: Family, vectors: tuple[Matrix, ...], q: np.ndarray) -> list[np.ndarray]:
    """Each vector at N configurations, (N, length)."""
    sampled = SampledAlgebra(ExactAlgebra(family.variety.half.ring, family.arm), q)
    return [np.stack([np.broadcast_to(sampled.from_exact(c), (len(q),)) for c in v.vector()], axis=1) for v in vectors]


def jacobian(analysis: SingularityAnalysis, q: np.ndarray) -> np.ndarray:
    """J of the plant of doubles."""
    J = NumericKinematics(analysis.arm, q).jacobian(analysis.frame, analysis.expressed_in)
    return J[:, [r - 1 for r in analysis.rows]][:, :, [c - 1 for c in analysis.columns]]


# -- the families of each arm ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "rows", "families"),
    [
        ("planar_2r", None, {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("planar_3r", None, {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("polar_rp", None, {"r = 0"}),
        ("scara", None, {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("scara_column", None, {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("scara_modified", None, {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("spherical_wrist", None, {r"\theta_5 = 0", r"\theta_5 = \pi"}),
        ("spatial_rrr", None, {r"l_2 C_2 + l_3 S_{23} = 0", r"\theta_3 = \frac{\pi}{2}", r"\theta_3 = -\frac{\pi}{2}"}),
        (
            "rx90",
            None,
            {r"\theta_5 = 0", r"\theta_5 = \pi", r"\theta_3 = \frac{\pi}{2}", r"\theta_3 = -\frac{\pi}{2}",
             r"a_3 C_2 - d_3 S_{23} = 0"},
        ),
        (
            "kr210",
            None,
            {r"\theta_5 = 0", r"\theta_5 = \pi", r"a_3 S_3 - d_5 C_3 - d_4 C_3 = 0",
             r"a_1 + a_2 S_2 + d_5 C_{23} + d_4 C_{23} - a_3 S_{23} = 0"},
        ),
        (
            "planar_3r",
            (1, 2),
            {rf"\theta_3 = {a} \text{{ and }} \theta_2 = {b}" for a in ("0", r"\pi") for b in ("0", r"\pi")},
        ),
    ],
)  # fmt: skip
def test_the_families_are_these(name: str, rows: tuple[int, ...] | None, families: set[str]) -> None:
    analysis = analysis_of(name, rows)
    assert analysis.complete
    assert conditions(analysis.families) == families


@pytest.mark.parametrize(
    ("name", "factored"),
    [
        ("planar_2r", r"l_1 l_2 S_2"),
        ("spherical_wrist", "-S_5"),
        ("spatial_rrr", r"l_2 l_3 C_3 \left(l_2 C_2 + l_3 S_{23}\right)"),
        ("rx90", r"a_3 d_3 C_3 S_5 \left(a_3 C_2 - d_3 S_{23}\right)"),
    ],
)
def test_the_determinant_is_written_as_a_product(name: str, factored: str) -> None:
    assert analysis_of(name).factored == factored


@cases
def test_points_of_a_family_are_singular_with_the_rank_stated(name: str, rows: tuple[int, ...] | None) -> None:
    analysis, rng = analysis_of(name, rows), np.random.default_rng(5)
    for family in analysis.families:
        q = family.sample(rng, 50)
        assert q.shape == (50, len(analysis.arm.joints))
        assert family.contains(q, 1e-9).all()
        singular_values = np.linalg.svd(jacobian(analysis, q), compute_uv=False)
        assert (singular_values[:, family.rank :] < 1e-9).all()
        assert np.median(singular_values[:, family.rank - 1]) > 1e-4


@pytest.mark.parametrize("name", ["spatial_rrr", "rx90", "planar_3r"])
def test_intersections_have_the_rank_stated(name: str) -> None:
    analysis, rng = analysis_of(name), np.random.default_rng(6)
    for family in analysis.intersections:
        q = family.sample(rng, 20) if family.exists else np.zeros((0, len(analysis.arm.joints)))
        ranks = np.linalg.matrix_rank(jacobian(analysis, q), tol=1e-9) if len(q) else np.zeros(0)
        assert not len(q) or ranks.max() == family.rank


@cases
def test_generic_configurations_lie_on_no_family(name: str, rows: tuple[int, ...] | None) -> None:
    analysis = analysis_of(name, rows)
    q = analysis.sampler.draw(np.random.default_rng(7), 500)
    assert not analysis.contains(q, 1e-9).any()
    assert (np.linalg.matrix_rank(jacobian(analysis, q)) == analysis.generic_rank).all()


@cases
def test_lost_and_null_directions_are_annihilated(name: str, rows: tuple[int, ...] | None) -> None:
    analysis, rng = analysis_of(name, rows), np.random.default_rng(8)
    for family in analysis.families:
        q = family.sample(rng, 20)
        J = jacobian(analysis, q)
        lost, null = values(family, family.lost, q), values(family, family.null_motions, q)
        assert len(lost) == analysis.generic_rank - family.rank
        assert len(null) == len(analysis.columns) - family.rank
        for w in lost:
            assert np.abs(w).max() > 1e-3
            assert np.abs(np.einsum("ni,nij->nj", w, J)).max() < 1e-9 * max(1.0, np.abs(w).max())
        for motion in null:
            assert np.abs(motion).max() > 1e-3
            assert np.abs(np.einsum("nij,nj->ni", J, motion)).max() < 1e-9
        kept = analysis.columns.index(family.kept_columns[0])
        wrong = null[0] + np.eye(len(analysis.columns))[kept]  # the check can fail
        assert np.abs(np.einsum("nij,nj->ni", J, wrong)).max() > 1e-3


@cases
def test_kept_columns_span_what_is_left(name: str, rows: tuple[int, ...] | None) -> None:
    analysis, rng = analysis_of(name, rows), np.random.default_rng(9)
    for family in analysis.families:
        q = family.sample(rng, 20)
        kept = np.stack(values(family, family.kept, q), axis=2)
        assert kept.shape[2] == family.rank == len(family.kept_columns)
        J = jacobian(analysis, q)
        places = [analysis.columns.index(column) for column in family.kept_columns]
        np.testing.assert_allclose(kept, J[:, :, places], atol=1e-9)
        assert np.median(np.linalg.svd(kept, compute_uv=False)[:, -1]) > 1e-4


# -- the search that knows nothing of the families -----------------------------------------------------------------------------


@cases
def test_a_search_finds_no_singular_configuration_off_the_families(name: str, rows: tuple[int, ...] | None) -> None:
    found = sweep(name, analysis_of(name, rows), 150, np.random.default_rng(10))
    assert found.singular > 75
    assert found.passed, found


@pytest.mark.parametrize("name", ["planar_2r", "spatial_rrr", "rx90"])
def test_a_family_left_out_is_found_by_the_search(name: str) -> None:
    analysis = analysis_of(name)
    for left_out in analysis.families:
        fewer = replace(analysis, families=tuple(f for f in analysis.families if f is not left_out))
        assert sweep(name, fewer, 100, np.random.default_rng(11)).stray > 0


def test_a_family_that_is_not_singular_is_caught() -> None:
    analysis = analysis_of("rx90")
    wrist = next(family for family in analysis.families if family.latex == r"\theta_5 = 0")
    half = wrist.variety.half
    regular = Factor(half, half.pair("theta_4")[0], frozenset())
    wrong = replace(wrist, variety=Variety(half, (regular,)))
    found = sweep("rx90", replace(analysis, families=(*analysis.families, wrong)), 300, np.random.default_rng(13))
    assert not found.passed and found.wrong_ranks > 0 and found.largest_sigma > 1e-3


def test_a_wrong_rank_is_caught() -> None:
    analysis = analysis_of("spatial_rrr")
    for rank in (1, 3):
        wrong = replace(analysis.families[0], rank=rank)
        found = sweep(
            "rrr", replace(analysis, families=(wrong, *analysis.families[1:])), 100, np.random.default_rng(14)
        )
        assert found.wrong_ranks > 0


def test_refining_leads_to_singular_configurations() -> None:
    analysis = analysis_of("rx90")
    q, sigma = refine(analysis, analysis.sampler.draw(np.random.default_rng(12), 50))
    assert (sigma < 1e-9).mean() > 0.9
    assert analysis.contains(q[sigma < 1e-9], 1e-6).all()


# -- boundary or inside --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "condition", "kind", "evidence"),
    [
        ("planar_2r", r"\theta_2 = 0", "boundary", "confirmed"),
        ("planar_2r", r"\theta_2 = \pi", "boundary", "confirmed"),
        ("scara", r"\theta_2 = \pi", "boundary", "confirmed"),
        ("polar_rp", "r = 0", "inside", "proved"),
        ("spherical_wrist", r"\theta_5 = 0", "inside", "proved"),
        ("spatial_rrr", r"\theta_3 = \frac{\pi}{2}", "boundary", "confirmed"),
        ("spatial_rrr", r"l_2 C_2 + l_3 S_{23} = 0", "inside", "proved"),
        ("rx90", r"\theta_5 = \pi", "inside", "proved"),
        ("rx90", r"\theta_3 = -\frac{\pi}{2}", "boundary", "confirmed"),
        ("rx90", r"a_3 C_2 - d_3 S_{23} = 0", "inside", "proved"),
        ("kr210", r"a_3 S_3 - d_5 C_3 - d_4 C_3 = 0", "boundary in part", "confirmed"),
    ],
)
def test_where_a_family_lies(name: str, condition: str, kind: str, evidence: str) -> None:
    family = next(family for family in analysis_of(name).families if family.latex == condition)
    assert family.position is not None
    assert (family.position.kind, family.position.evidence) == (kind, evidence)


def test_the_planar_3r_bounds_its_reach_only_stretched() -> None:
    kinds = {
        family.latex: family.position.kind for family in analysis_of("planar_3r", (1, 2)).families if family.position
    }
    assert kinds.pop(r"\theta_3 = 0 \text{ and } \theta_2 = 0") == "boundary"
    assert set(kinds.values()) == {"inside"}


@pytest.mark.parametrize(
    ("name", "condition"), [("planar_2r", "l_1 = l_2"), ("scara", "a_1 = a_2"), ("rx90", "a_3 = d_3")]
)
def test_equal_links_put_the_folded_arm_inside(name: str, condition: str) -> None:
    special = [family for family in analysis_of(name).families if family.special]
    assert len(special) == 1
    position = special[0].special[condition]
    assert (position.kind, position.evidence) == ("inside", "proved")


def test_an_arm_with_equal_links_is_inside_when_folded() -> None:
    row = {"a": "1/2", "alpha": 0, "d": 0}
    arm = load_arm({"dh": "classic", "rows": [{**row, "theta": "theta_1"}, {**row, "theta": "theta_2"}]})
    families = {family.latex: family for family in analyse_singularities(arm).families}
    assert families[r"\theta_2 = 0"].position.kind == "boundary"  # type: ignore[union-attr]
    assert families[r"\theta_2 = \pi"].position.kind == "inside"  # type: ignore[union-attr]
    assert families[r"\theta_2 = \pi"].position.evidence == "proved"  # type: ignore[union-attr]


# -- solved forms and existence ------------------------------------------------------------------------------------------------


def test_a_condition_is_solved_and_its_lengths_are_told() -> None:
    shoulder, elbow = analysis_of("kr210").families[:2]
    assert shoulder.solved[0].startswith(r"\theta_2 = \operatorname{atan2}(") and r"\pm \arccos" in shoulder.solved[0]
    assert shoulder.existence == r"a_1 \le \sqrt{a_3^2 + d_5^2 + 2 d_4 d_5 + d_4^2} + a_2"
    assert elbow.solved == (r"\theta_3 = \operatorname{atan2}(d_5 + d_4, a_3) + k\pi",)
    assert elbow.existence == "" and elbow.exists


def test_a_family_that_the_lengths_forbid_has_no_configuration() -> None:
    rows = [
        {"a": 2, "alpha": "pi/2", "d": 0, "theta": "theta_1"},
        {"a": 1, "alpha": 0, "d": 0, "theta": "theta_2"},
        {"a": "1/2", "alpha": 0, "d": 0, "theta": "theta_3"},
    ]
    analysis = analyse_singularities(load_arm({"dh": "classic", "rows": rows}), rows=[1, 2, 3])
    offset = [family for family in analysis.families if not family.exists]
    assert len(offset) <= 1 and {family.latex for family in analysis.families if family.exists} == {
        r"\theta_3 = 0", r"\theta_3 = \pi"
    }  # fmt: skip


# -- intersections -------------------------------------------------------------------------------------------------------------


def test_two_conditions_of_the_rx90_need_not_cost_two_ranks() -> None:
    found = {frozenset(family.conditions): family.rank for family in analysis_of("rx90").intersections}
    elbow, wrist = r"\theta_3 = \frac{\pi}{2}", r"\theta_5 = 0"
    assert frozenset({elbow, wrist}) not in found
    assert found[frozenset({elbow, wrist, r"\theta_4 = 0"})] == 4
    assert found[frozenset({elbow, wrist, r"\theta_4 = 0", r"\theta_2 = \frac{\pi}{2}"})] == 3
    assert min(found.values()) == 3


# -- what is asked for ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"rows": [0, 1]}, r"rows of the Jacobian are different numbers from 1 to 6, not \[0, 1\]"),
        ({"rows": [1, 1]}, "rows of the Jacobian are different numbers"),
        ({"columns": [3]}, r"columns of the Jacobian are different numbers from 1 to 2, not \[3\]"),
        ({"rows": []}, "rows of the Jacobian are different numbers"),
        ({"frame": "9"}, "no frame '9' on arm 'planar_2r'; its frames are 0, 1, 2"),
        ({"expressed_in": "9"}, "no frame '9'"),
    ],
)
def test_a_wrong_choice_is_refused(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        analyse_singularities(load_arm("planar_2r"), **arguments)


def test_an_arm_that_is_never_singular_says_so() -> None:
    assert analyse_singularities(load_arm("planar_2r"), rows=[1, 2, 6]).always_regular
    assert not analysis_of("planar_2r").always_regular


@pytest.mark.parametrize("name", ["spatial_rrr", "spherical_wrist", "rx90"])
def test_the_choice_of_axes_changes_no_family(name: str) -> None:
    arm, analysis = load_arm(name), analysis_of(name)
    turned = analyse_singularities(arm, expressed_in=arm.frames[-1])
    words = [{frozenset(family.latex.split()) for family in found.families} for found in (turned, analysis)]
    assert words[0] == words[1]


def test_columns_of_the_scara_alone() -> None:
    analysis = analyse_singularities(load_arm("scara"), rows=[1, 2, 3], columns=[1, 2, 3])
    assert analysis.factored == "-a_1 a_2 S_2"
    assert conditions(analysis.families) == {r"\theta_2 = 0", r"\theta_2 = \pi"}


def test_rows_in_moving_axes_are_placed_nowhere() -> None:
    families = analyse_singularities(load_arm("planar_2r"), rows=[1, 2], expressed_in="1").families
    assert {family.position.kind for family in families if family.position} == {"not decided"}
