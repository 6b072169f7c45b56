"""What waits for the sweep, parameters that name another document or arm; and which cases `make test` leaves to the rest."""

import time
from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import pytest

from tests.conftest import (
    BOTH,
    LATER,
    LONG,
    SWEPT,
    TESTS,
    TOGETHER,
    of_part,
    pytest_runtest_protocol,
    pytest_runtest_setup,
    waits_for_the_sweep,
)

WRONG_ANSWERS = "tests/course/tasks/test_tasks.py::test_every_wrong_answer_gets_its_own_message"


@pytest.mark.parametrize(
    ("nodeid", "named", "waits"),
    [
        ("tests/course/figures/test_base.py::test_links", "kr210", True),
        ("tests/course/figures/test_base.py::test_links", "scara", False),
        ("tests/course/figures/test_base.py::test_links", "slanted", False),
        ("tests/course/figures/test_legibility.py::test_every_figure", "slanted-sketch", True),
        ("tests/course/figures/test_base.py::test_sizes", "poster", False),
        ("tests/course/figures/test_base.py::test_sizes", "", False),
        ("tests/course/printing/test_handouts.py::test_text", "scara-000", False),
        ("tests/course/printing/test_handouts.py::test_text", "scara-001", True),
        (
            "tests/verification/document/test_formats.py::test_a_handout_in_another_format_has",
            "as_tex-scara-000",
            False,
        ),
        ("tests/verification/document/test_formats.py::test_a_handout_in_another_format_has", "as_tex-rx90-001", True),
        ("tests/verification/report/test_in_browser.py::test_axe_finds_nothing_serious_in_the_course", "", True),
        ("tests/models/bulk/test_bulk.py::test_anything", "kr210", True),
        ("tests/models/bulk/test_bulk.py::test_anything", "slanted", False),
        ("tests/verification/inverse/test_proof.py::test_a_slip", "kr210", False),
        (f"{WRONG_ANSWERS}[scara_inverse-elbow]", "scara_inverse-elbow", False),
    ],
)
def test_what_waits_for_the_sweep(nodeid: str, named: str, waits: bool) -> None:
    assert waits_for_the_sweep(nodeid, named) == waits


def cases_of(*names: str) -> list[pytest.Item]:
    """Return tests of these names, those with brackets as cases of a law."""
    return [Mock(pytest.Function, nodeid=name, **({"callspec": Mock(id="x")} if "[" in name else {})) for name in names]


def numbers_in(part: str, *names: str) -> list[int]:
    items = cases_of(*names)
    return [items.index(item) for item in of_part(items, part)]


@pytest.mark.parametrize(
    ("names", "some"),
    [
        (["test_a.py::test_one", "test_a.py::test_two"], [0, 1]),
        ([f"test_a.py::test_one[{i}]" for i in range(4)], [0, 2]),
        ([f"test_a.py::test_one[{i}]" for i in range(10)], [0, 4, 8]),
        ([f"test_a.py::test_one[{i}]" for i in range(13)], [0, 6, 12]),
        ([f"test_a.py::test_one[{i}]" for i in range(40)], [0, 12, 24, 36]),
        (["a.md::a[1].md:3", "test_a.py::test_one[0]", "test_a.py::test_one[1]"], [0, 1]),
        ([f"tests/{LATER[0]}", f"tests/{LATER[0]}[0]", f"tests/{LATER[0]}[1]"], []),
    ],
)
def test_each_case_is_shown_in_one_part(names: list[str], some: list[int]) -> None:
    assert numbers_in("some", *names) == some
    assert numbers_in("rest", *names) == [i for i in range(len(names)) if i not in some]
    assert numbers_in("", *names) == [*range(len(names))]


def test_what_draws_by_itself_is_in_both_parts() -> None:
    assert numbers_in("some", f"tests/{BOTH[0]}") == numbers_in("rest", f"tests/{BOTH[0]}") == [0]


@pytest.mark.parametrize("start", sorted([*SWEPT, *LATER, *BOTH]))
def test_what_is_swept_exists(start: str) -> None:
    file, _, test = start.partition("::")
    assert (TESTS / file).exists()
    test = test.partition("[")[0]
    assert not test or f"def {test}" in (TESTS / file).read_text(encoding="utf-8")


def test_files_that_one_worker_runs_or_that_are_begun_first_exist() -> None:
    named = [place for files in (LONG, *TOGETHER.values()) for place in files if place not in TOGETHER]
    assert all((TESTS.parent / place).exists() for place in named)


@pytest.mark.parametrize(
    ("passed", "told"),
    [((True, True, True), ["call"]), ((False, True), ["setup"]), ((True, False, False), ["call", "teardown"])],
)
def test_a_worker_tells_the_call_and_every_phase_that_does_not_pass(
    monkeypatch: pytest.MonkeyPatch, passed: tuple[bool, ...], told: list[str]
) -> None:
    phases = ("setup", "call", "teardown") if len(passed) == 3 else ("setup", "teardown")
    reports = [SimpleNamespace(when=when, passed=each) for when, each in zip(phases, passed, strict=True)]
    monkeypatch.setattr("tests.conftest.runtestprotocol", lambda *_, **__: reports)
    sent: list[str] = []
    hook = SimpleNamespace(pytest_runtest_logreport=lambda report: sent.append(report.when))
    config = SimpleNamespace(workerinput={}, getoption=lambda name: 0)
    item: Any = SimpleNamespace(config=config, ihook=hook)
    assert pytest_runtest_protocol(item, None) and sent == told
    del config.workerinput  # in a process of its own pytest tells it all
    assert pytest_runtest_protocol(item, None) is None and sent == told


def test_nothing_is_begun_when_the_time_is_over(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest_runtest_setup()
    monkeypatch.setattr("tests.conftest.UNTIL", time.time() - 1)
    with pytest.raises(pytest.skip.Exception, match="the time was over"):
        pytest_runtest_setup()
