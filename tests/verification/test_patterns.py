"""Patterns are compiled when they are first used, all of them are good, and a start compiles few."""

import ast
import copy
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

from armproof.verification.patterns import regex

ROOM = Path(__file__).resolve().parents[2] / "verification"


def test_a_pattern_is_what_re_compiles() -> None:
    late, compiled = regex(r"(?P<word>[a-z]+)", re.IGNORECASE), re.compile(r"(?P<word>[a-z]+)", re.IGNORECASE)
    assert (late.sub("-", "Ab1c"), late.pattern, late.flags) == ("-1-", compiled.pattern, compiled.flags)
    assert late.groupindex == compiled.groupindex
    assert copy.copy(regex("[a-z]+")).fullmatch("ab")


def test_a_pattern_that_is_wrong_says_so_when_it_is_used() -> None:
    late = regex("(")
    with pytest.raises(re.error):
        late.search("")


def _patterns_of(value: object) -> Iterator[object]:
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, (list, tuple, set, frozenset)):
        for each in value:
            yield from _patterns_of(each)
    elif type(value) is type(regex("")):
        yield value


def test_all_patterns_of_the_room_are_good() -> None:
    places = [path.relative_to(ROOM).with_suffix("").parts for path in ROOM.rglob("*.py") if path.stem[0] != "_"]
    modules = [import_module(".".join(("armproof.verification", *parts))) for parts in places]
    found = {id(each): each for module in modules for each in _patterns_of([*vars(module).values()])}
    assert len(found) > 500
    assert all(each.groups >= 0 for each in found.values())


def test_no_module_compiles_a_pattern_when_it_is_imported() -> None:
    inside = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
    for path in ROOM.rglob("*.py"):
        tree = ast.parse(path.read_text("utf-8"))
        within = {
            id(node) for function in ast.walk(tree) if isinstance(function, inside) for node in ast.walk(function)
        }
        now = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and id(node) not in within]
        assert not [node.lineno for node in now if ast.unparse(node.func) == "re.compile"], path
