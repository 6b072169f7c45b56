"""The tool that changes our source code: what it changes, where, and which tests meet it."""

from __future__ import annotations

import ast
import os
from collections import Counter
from pathlib import Path

import pytest
from coverage import CoverageData

from tests.mutation.source import reach
from tests.mutation.source.__main__ import draw, report, tell
from tests.mutation.source.fates import KILLED, SURVIVED, Fate
from tests.mutation.source.labels import labelled
from tests.mutation.source.mutants import Mutant, mutants_of, mutate
from tests.mutation.source.trusted import ROOT, selection, trusted_files

SOURCE = '''
"""A module."""
from __future__ import annotations
LIMIT = 3
def f(x: int = 2) -> int:
    """Return it."""
    if x > LIMIT and not x == 7:
        x += 1
    return -x + 4
'''


def changed(index: int) -> str:
    return ast.unparse(mutate(SOURCE, index))


def test_each_mutant_is_one_change_of_the_file():
    found = mutants_of(SOURCE)
    texts = [changed(mutant.index) for mutant in found]
    assert len(set(texts)) == len(found) and ast.unparse(ast.parse(SOURCE)) not in texts
    assert {mutant.kind for mutant in found} == {"operator", "constant", "condition", "statement", "return"}


@pytest.mark.parametrize(
    "piece",
    [
        "LIMIT = 4",
        "x: int=3",
        "x >= LIMIT",
        "x > LIMIT or",
        "x != 7",
        "if not (x > LIMIT",
        "pass",
        "return None",
        "-x - 4",
        "+x + 4",
    ],
)
def test_what_is_changed(piece: str):
    assert any(piece in changed(mutant.index) for mutant in mutants_of(SOURCE))


def test_the_trusted_base_is_what_the_plan_names():
    """A room is all of its files but for what is excepted; a file named behind its room is one of it, or stands loose."""
    files = trusted_files()
    assert len(files) > 60
    assert {
        "models/exact/trace.py",
        "verification/algebra/ring.py",
        "verification/check/documents.py",
        "verification/display/claims.py",
        "verification/tables/arms/inference.py",
    } <= {*files}
    rooms = Counter(Path(file).parent.as_posix() for file in files)
    assert rooms["verification/conditions"] == len(list((ROOT / "verification/conditions").glob("[!_]*.py")))
    assert not {
        "verification/evaluation/sampled.py",
        "verification/latex/writer.py",
        "verification/algebra/written.py",
    } & {*files}


def test_a_bound_of_effort_is_no_law_and_a_small_number_is():
    assert {mutant.words for mutant in mutants_of("if size > 30:\n    f()")} == {"not (size > 30)", "f() dropped"}
    assert {"Gt → GtE", "3 → 4"} <= {mutant.words for mutant in mutants_of("if size > 3:\n    f()")}
    asked = "    budget.check()"
    assert {mutant.words for mutant in mutants_of(f"MOST = 30\nif size > MOST:\n{asked}")} == {"not (size > MOST)"}
    assert {"Gt → GtE", "3 → 4", "budget.checks() dropped"} <= {
        mutant.words for mutant in mutants_of(f"MOST = 3\nif size > MOST:\n{asked[:-2]}s()")
    }


def test_each_trusted_file_is_there_and_has_tests():
    for file in trusted_files():
        own, room, course = selection(file)
        assert (ROOT / file).exists() and all((ROOT / test).exists() for test in (*own, *room, *course)), file
    assert selection("models/loading/card.py")[0] == ["tests/models/loading/test_card.py"]
    assert "tests/verification/naming/test_quantities.py" in selection("verification/algebra/quantity_kinds.py")[0]
    assert not selection("verification/check/display_checker.py")[0]  # what all tests import, none is about


def test_a_sample_is_drawn_from_all_files():
    drawn = draw(["models/dh/*.py", "verification/algebra/*.py"], 40, 1)
    assert len(drawn) == 40 and len({file for file, _ in drawn}) > 6
    assert draw(["verification/verdict.py"], 0, 1)[0][0] == "verification/verdict.py"


def test_each_labelled_display_and_page_is_a_test():
    tests = dict(labelled())
    assert len(tests) == len(list(labelled())) > 3000
    assert next(iter(tests.values()))()


def test_a_share_below_what_is_wanted_is_a_failure(capsys: pytest.CaptureFixture[str]):
    mutant = Mutant(0, 1, "operator", "Add → Sub")
    killed, survived = Fate("a.py", mutant, KILLED, "test_a.py::test_a"), Fate("a.py", mutant, SURVIVED, imported=True)
    assert report([killed] * 19 + [survived]) == 0
    assert report([tell(killed)] * 18 + [tell(survived), survived]) == 1
    said = capsys.readouterr().out
    assert said.count("a.py:1: operator") == 1 and "test_a" not in said
    tell(killed, every=True)
    assert "killed test_a.py::test_a a.py:1: operator" in capsys.readouterr().out


def test_a_line_is_reached_by_the_tests_of_its_function_and_one_that_runs_at_import_by_those_of_its_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    file = tmp_path / "a.py"
    file.write_text(
        "LIMIT = 3\ndef f(x=2):\n    y = x\n    return y\ndef g():\n    return 1\ndef h():\n    return 2\n", "utf-8"
    )
    monkeypatch.setattr(reach, "ROOT", tmp_path)
    monkeypatch.setattr(reach, "RECORD", tmp_path / "reach.coverage")
    assert reach.reaching("a.py", 3) is None  # no record
    data = CoverageData(str(reach.RECORD))
    for test, lines in (
        ("test_a.py::test_f|run", [3]),
        ("test_b.py::test_f|setup", [3]),
        ("c.py::test_g|run", [6]),
        ("", [1]),
    ):
        data.set_context(test)
        data.add_lines({str(file): lines})
    data.write()
    of_f, of_g = {"test_a.py::test_f", "test_b.py::test_f"}, {"c.py::test_g"}
    assert [reach.reaching("a.py", line) for line in (3, 4, 6, 8)] == [of_f, of_f, of_g, set()]
    assert reach.reaching("a.py", 1) == reach.reaching("a.py", 2) == of_f | of_g
    os.utime(file, (2**31, 2**31))
    assert reach.reaching("a.py", 3) is None  # the file is newer
