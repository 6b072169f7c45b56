"""Mutants of a Python file, one small change each: operators, constants, conditions, statements, returned values."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass

SWAPS: dict[type[ast.AST], type[ast.AST]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Add, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult, ast.Mod: ast.Mult,
    ast.Pow: ast.Mult, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.Lt: ast.LtE,
    ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot,
    ast.IsNot: ast.Is, ast.And: ast.Or, ast.Or: ast.And, ast.USub: ast.UAdd,
}  # fmt: skip
BODIES = ("body", "orelse", "finalbody")
SILENT = (ast.JoinedStr, ast.Raise, ast.Import, ast.ImportFrom, ast.Assert)  # messages and imports decide nothing


@dataclass(frozen=True)
class Mutant:
    """One change of a file: its number, where it is and what it does."""

    index: int
    line: int
    kind: str
    words: str


@dataclass(frozen=True)
class _Site:
    """A node of the tree that can be changed: the path to it, and which of its changes."""

    path: tuple[tuple[str, int | None], ...]
    kind: str
    line: int
    words: str


def mutants_of(source: str) -> list[Mutant]:
    """Return the mutants of a source text, in its order."""
    return [Mutant(k, site.line, site.kind, site.words) for k, site in enumerate(_sites(ast.parse(source)))]


def mutate(source: str, index: int) -> ast.Module:
    """Return the tree of the mutant of that number."""
    tree = ast.parse(source)
    site = list(_sites(tree))[index]
    changed = copy.deepcopy(tree)
    parent: ast.AST = changed
    for step in site.path[:-1]:
        parent = _at(parent, step)
    field, position = site.path[-1]
    new = _changed(_at(parent, site.path[-1]), site.kind)
    if position is None:
        setattr(parent, field, new)
    else:
        getattr(parent, field)[position] = new
    return ast.fix_missing_locations(changed)


def _at(node: ast.AST, step: tuple[str, int | None]) -> ast.AST:
    value = getattr(node, step[0])
    return value if step[1] is None else value[step[1]]


def _sites(tree: ast.Module) -> Iterator[_Site]:
    bounds = {name for node in tree.body if (name := _named_bound(node)) is not None}
    yield from _below(tree, (), bounds)


def _below(node: ast.AST, path: tuple[tuple[str, int | None], ...], bounds: set[str]) -> Iterator[_Site]:
    for field, value in ast.iter_fields(node):
        if field in ("annotation", "returns", "decorator_list", "type_params", "ctx", "bases"):
            continue
        children = enumerate(value) if isinstance(value, list) else [(None, value)]
        for position, child in children:
            if not isinstance(child, ast.AST) or _decides_nothing(node, child, bounds):
                continue
            here = (*path, (field, position))
            line = getattr(child, "lineno", getattr(node, "lineno", 0))
            yield from (_Site(here, kind, line, words) for kind, words in _changes(node, field, child))
            if not _for_checkers(child):
                yield from _below(child, here, bounds)


def _changes(parent: ast.AST, field: str, node: ast.AST) -> Iterator[tuple[str, str]]:
    """Yield the changes of a node: kind and words."""
    if type(node) in SWAPS:
        yield "operator", f"{type(node).__name__} → {SWAPS[type(node)].__name__}"
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool | int | float):
        yield "constant", f"{node.value} → {_other(node.value)}"
    elif isinstance(node, ast.Return) and node.value is not None and not isinstance(node.value, ast.Constant):
        yield "return", f"return {ast.unparse(node.value)[:60]} → None"
    elif isinstance(node, ast.Expr | ast.AugAssign | ast.Continue | ast.Break | ast.Delete) and field in BODIES:
        yield "statement", f"{ast.unparse(node)[:60]} dropped"
    if field in ("test", "ifs") and isinstance(node, ast.expr) and not isinstance(parent, ast.Assert):
        yield "condition", f"not ({ast.unparse(node)[:60]})"


def _changed(node: ast.AST, kind: str) -> ast.AST:
    if kind == "operator":
        return SWAPS[type(node)]()
    if kind == "constant":
        assert isinstance(node, ast.Constant)
        return ast.copy_location(ast.Constant(_other(node.value)), node)
    if kind == "return":
        return ast.copy_location(ast.Return(ast.Constant(None)), node)
    if kind == "statement":
        return ast.copy_location(ast.Pass(), node)
    assert isinstance(node, ast.expr)
    return ast.copy_location(ast.UnaryOp(ast.Not(), node), node)


def _other(value: object) -> bool | int | float:
    if isinstance(value, bool):
        return not value
    assert isinstance(value, int | float)
    return value + 1 if isinstance(value, int) else value * 1000 if value else 1.0


def _decides_nothing(parent: ast.AST, node: ast.AST, bounds: set[str]) -> bool:
    """Whether a node is a message, a docstring, a guard against our own slips (zip(…, strict=True)), or a bound of effort."""
    is_docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    is_guard = isinstance(node, ast.keyword) and node.arg == "strict"
    asks_for_time = isinstance(node, ast.Expr) and ast.unparse(node).endswith("budget.check()")
    return isinstance(node, SILENT) or is_docstring or is_guard or asks_for_time or _is_a_bound(parent, node, bounds)


def _is_a_bound(parent: ast.AST, node: ast.AST, bounds: set[str]) -> bool:
    """Whether a node compares with, or is, a whole number from 10 on or a named bound: where one more is no other law."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int) and _named_bound(parent) is not None:
        return True
    sides = [parent.left, *parent.comparators] if isinstance(parent, ast.Compare) else []
    literal = any(isinstance(s, ast.Constant) and isinstance(s.value, int) and s.value >= 10 for s in sides)
    named = any(isinstance(below, ast.Name) and below.id in bounds for side in sides for below in ast.walk(side))
    is_order = isinstance(node, ast.Lt | ast.LtE | ast.Gt | ast.GtE)
    return (literal and (is_order or isinstance(node, ast.Constant))) or (named and is_order)


def _named_bound(node: ast.AST) -> str | None:
    """Return the name that a module gives a whole number from 10 on, or a tolerance, a time."""
    if not isinstance(node, ast.Assign) or not isinstance(node.value, ast.Constant) or len(node.targets) != 1:
        return None
    value, target = node.value.value, node.targets[0]
    is_bound = isinstance(value, float) or (isinstance(value, int) and value >= 10)
    return target.id if is_bound and isinstance(target, ast.Name) and target.id.isupper() else None


def _for_checkers(node: ast.AST) -> bool:
    """Whether a node is read by type checkers only: `if TYPE_CHECKING`, a type alias, __all__."""
    if isinstance(node, ast.If):
        return isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"
    return isinstance(node, ast.Assign) and any(isinstance(t, ast.Name) and t.id == "__all__" for t in node.targets)
