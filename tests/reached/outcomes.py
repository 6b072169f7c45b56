"""What the conditions of the trusted base come out as: its files are imported with each condition noting it.

A line that runs says little of a condition on it. Noted are each test, comparison and operand of *and* and *or* (one that
would not be asked for is asked, too, if that changes nothing: a mutant may ask), whether what is ordered is equal, and
whether what is returned is nothing, empty or something.
"""

from __future__ import annotations

import ast
import operator
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from tests.mutation.source.imports import Finder
from tests.mutation.source.trusted import ROOT, trusted_files

Outcome = tuple[object, ...]  # the place of a condition, and what it came out as
NOTED: set[Outcome] = set()
PURE = {"isinstance", "len", "set", "str", "any", "all"}
ORDERS = {"Lt": operator.lt, "LtE": operator.le, "Gt": operator.gt, "GtE": operator.ge}


def note() -> None:
    """Have the trusted base note its outcomes; to be called before any of it is imported."""
    assert not any(name.startswith(("armproof.verification", "armproof.models")) for name in sys.modules)
    codes = {(ROOT / file).resolve(): compile(noting(file), ROOT / file, "exec") for file in trusted_files()}
    sys.meta_path.insert(
        0, Finder(codes, {"_test": _test, "_all_of": _all_of, "_order": _order, "_returned": _returned})
    )
    sys.setrecursionlimit(6 * sys.getrecursionlimit())  # every condition is a call, and some are functions of their own


def noting(file: str) -> ast.Module:
    """Return the tree of a file whose functions note their outcomes."""
    tree = ast.parse((ROOT / file).read_text("utf-8"))
    return ast.fix_missing_locations(_Noting(file).visit(tree))


class _Noting(ast.NodeTransformer):
    """Puts a call round each condition of a function; what runs at import stays as it is."""

    def __init__(self, file: str) -> None:
        self.stem = str(Path(file).with_suffix(""))
        self.count = 0

    def _noted(self, function: str, node: ast.expr, *arguments: ast.expr) -> ast.expr:
        self.count += 1
        place = ast.Constant(f"{self.stem}:{node.lineno}:{self.count}")
        return ast.copy_location(ast.Call(ast.Name(function, ast.Load()), [place, *arguments], []), node)

    def _functions_of(self, node: ast.Module | ast.ClassDef) -> ast.AST:
        node.body = [self.visit(s) if isinstance(s, ast.FunctionDef | ast.ClassDef) else s for s in node.body]
        return node

    visit_Module = visit_ClassDef = _functions_of

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        node.body = [self.visit(statement) for statement in node.body]
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.AST:
        binds = any(isinstance(below, ast.NamedExpr) for below in ast.walk(node))
        pure = ast.Tuple([ast.Constant(_changes_nothing(value)) for value in node.values], ast.Load())
        self.generic_visit(node)
        if binds:  # what a function of its own binds is not bound here
            node.values = [self._noted("_test", value, value) for value in node.values]
            return node
        operands: list[ast.expr] = [ast.Lambda(ast.arguments([], [], None, [], [], None, []), v) for v in node.values]
        is_and = ast.Constant(isinstance(node.op, ast.And))
        return self._noted("_all_of", node, is_and, pure, ast.Tuple(operands, ast.Load()))

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        self.generic_visit(node)
        order = type(node.ops[0]).__name__
        if len(node.ops) == 1 and order in ORDERS:
            return self._noted("_order", node, ast.Constant(order), node.left, node.comparators[0])
        return self._noted("_test", node, node)

    def _with_test(self, node: ast.If | ast.While | ast.IfExp) -> ast.AST:
        self.generic_visit(node)
        node.test = self._noted("_test", node.test, node.test)
        return node

    visit_If = visit_While = visit_IfExp = _with_test

    def visit_comprehension(self, node: ast.comprehension) -> ast.AST:
        self.generic_visit(node)
        node.ifs = [self._noted("_test", test, test) for test in node.ifs]
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
        self.generic_visit(node)
        if node.value is not None:
            node.value = self._noted("_returned", node.value, node.value)
        return node


def _test(place: str, value: object) -> object:
    NOTED.add((place, _truth(value)))
    return value


def _truth(value: object) -> bool | None:
    """Return whether a value counts as true; None for an array of NumPy, which says it of each entry."""
    try:
        return bool(value)
    except ValueError:
        return None


def _returned(place: str, value: object) -> object:
    NOTED.add(
        (place, None if value is None else not isinstance(value, bool | int | str | tuple | list | dict) or bool(value))
    )
    return value


def _order(place: str, order: str, left: object, right: object) -> object:
    value = ORDERS[order](left, right)
    NOTED.add((place, _truth(value), _truth(left == right)))
    return value


def _changes_nothing(node: ast.expr) -> bool:
    """Whether asking an operand that is not due changes nothing: a parser's `take("-")` would."""
    calls = (below.func for below in ast.walk(node) if isinstance(below, ast.Call))
    return all(isinstance(function, ast.Name) and function.id in PURE for function in calls)


def _all_of(place: str, is_and: bool, pure: Sequence[bool], operands: Sequence[Callable[[], object]]) -> object:
    """Return what `and` or `or` of the operands is, and note what each of them is."""
    found, value, is_done = [], None, False
    for is_pure, operand in zip(pure, operands, strict=True):
        if is_done:
            found.append(_asked(operand) if is_pure else None)
            continue
        value = operand()
        found.append(bool(value))
        is_done = found[-1] != is_and
    NOTED.add((place, *found))
    return value


def _asked(operand: Callable[[], object]) -> bool | None:
    """Return what an operand is that was not to be asked; None where it cannot be."""
    try:
        return bool(operand())
    except Exception:
        return None
