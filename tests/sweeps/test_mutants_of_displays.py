"""Over a hundred damaged displays in every run; `make sweep` tries a thousand and, beside these, twenty thousand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from armproof.verification.verdict import Verdict
from tests.laws import SWEEP
from tests.sweeps import mutants_of_displays as sweep

COUNT, PARTS = (1_000, 4) if SWEEP else (110, 1)


@pytest.mark.parametrize("part", range(PARTS))
def test_whatever_stands_in_a_display_is_borne(part: int):
    drawn = sweep.pages(COUNT, sweep.SEED)[part::PARTS]
    failures = [failure for page in drawn for failure in sweep.failures_of_page(page)]
    assert not failures, "\n".join(f"{f.handout}: {f.what}: {f.latex}" for f in failures)


@pytest.mark.parametrize("hard", sweep.HARD, ids=lambda hard: hard[0])
def test_a_hard_display_is_borne(hard: tuple[str, str]):
    assert not sweep.failures_of_hard(*hard)


def test_all_handouts_are_drawn_from_and_most_are_damaged():
    pages = sweep.pages(COUNT, sweep.SEED)
    assert len(pages) * sweep.ON_A_PAGE >= COUNT and len({name for name, _ in pages}) >= min(20, len(pages))
    rng = sweep.Random(1)
    damaged = [sweep.mutate(r"\det J = l_1 l_2 s_2", "P_x = l_1 c_1", rng) for _ in range(200)]
    assert len(set(damaged)) > 120


@pytest.mark.parametrize(("kind", "said"), [("error", "ValueError"), ("slow", "too slow"), ("lost", "costs another")])
def test_what_is_not_borne_is_noticed(monkeypatch: pytest.MonkeyPatch, kind: str, said: str):
    real = sweep.check_document
    name = "planar-2r-002.md"
    document, sentinel = sweep._handout(name)
    assert sentinel is not None

    def fails(page, **options):
        result = real(page, **options)
        if kind == "error":
            raise ValueError("a fault of ours")
        last = replace(result.equations[-1], verdict=Verdict.UNCHECKED) if kind == "lost" else result.equations[-1]
        return replace(result, equations=(*result.equations[:-1], last))

    monkeypatch.setattr(sweep, "check_document", fails)
    monkeypatch.setattr(sweep, "BOUND", -9.0 if kind == "slow" else 9.0)
    assert said in sweep._failure(document, sentinel, [replace(sentinel, latex="x = 1")])
