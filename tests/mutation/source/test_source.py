"""The tool that changes our source code: what it changes, and that a change is noticed."""

from __future__ import annotations

import ast

import pytest

from tests.mutation.source.__main__ import ROOT, TRUSTED, draw, fate_of, report
from tests.mutation.source.mutants import Mutant, mutants_of, mutate
from tests.mutation.source.run import UNCHANGED

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


def test_the_trusted_base_is_there_and_has_mutants():
    for pattern in TRUSTED:
        assert draw([pattern], 0, 1), pattern
    assert len(draw(TRUSTED, 20, 1)) == 20


def test_a_killed_mutant_and_one_that_survives():
    """The hook hands out the changed file: a normal form that adds for subtracts is noticed, the file as it is survives."""
    file = "verification/equations/equality.py"
    found = mutants_of((ROOT / file).read_text("utf-8"))
    returns = next(mutant for mutant in found if mutant.kind == "return")
    assert fate_of((file, returns), [], 120).fate == "killed"


def test_a_share_below_what_is_wanted_is_a_failure(capsys: pytest.CaptureFixture[str]):
    from tests.mutation.source.__main__ import Fate

    mutant = Mutant(UNCHANGED, 1, "operator", "Add → Sub")
    assert report([Fate("a.py", mutant, "killed")] * 19 + [Fate("a.py", mutant, "survived")]) == 0
    assert report([Fate("a.py", mutant, "killed")] * 18 + [Fate("a.py", mutant, "survived")] * 2) == 1
    assert "a.py:1: operator" in capsys.readouterr().out
