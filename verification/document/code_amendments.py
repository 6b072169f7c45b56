"""Statements in code that change a DH table which stands there: `dh[1][3] += pi/2`, `DH = DH[::-1]`, `table.loc[2, 'a'] = 0`.

Behind the rows, in the same piece of code, those of numbers and letters in one entry, row or column are carried out; of others it is told that they amend a table.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterator, Sequence

from armproof.verification.document.code_columns import NAMES, OF_A_TABLE
from armproof.verification.patterns import regex

MAY_AMEND = regex(r"\]\s*[-+*/]?=(?!=)|\)\s*=(?!=)|\.(?:append|insert|pop|reverse|remove|extend|offset)\b|=[^=\n]*\b(?:m?dh|DH|flip)|\bdel\b", re.IGNORECASE)  # fmt: skip
_ROW = 4  # entries
_HARMLESS = frozenset(
    "array asarray Matrix matrix ImmutableMatrix DataFrame copy deepcopy list tuple astype subs evalf xreplace simplify round nsimplify lambdify print display vpa double".split()
)  # what changes no entry, or gives letters numbers
_VARIABLE = regex(r"(?:q|th|theta|thetas|qs|joints?|joint_\w+|angles?|t|d|conf\w*)_?\d*(?:_\w+)?")
_EMPTY = frozenset(["zeros", "empty", "ones", "zeros_like", "dict", "list", "full", "DataFrame"])
_FRAME = regex(r"table|dh|param|tab\b", re.IGNORECASE)  # what a frame of pandas is called that is a table of an arm
_OF_PANDAS = frozenset(["loc", "iloc", "at", "iat"])
_METHODS = frozenset(["append", "insert", "pop", "reverse", "remove", "extend", "sort", "row_swap", "col_swap", "row_del", "drop", "row_op", "col_op"])  # fmt: skip
_OF_MATLAB = regex(
    r"^[ \t]*(?P<name>[A-Za-z]\w*)[ \t]*\((?P<place>[^()=\n]*)\)[ \t]*(?:\.(?P<field>offset|alpha|theta|a|d)[ \t]*)?=(?!=)|^[ \t]*(?P<whole>[A-Za-z]\w*)[ \t]*=(?P<value>[^=\n][^\n]*)",
    re.MULTILINE,
)


class CodeTables:
    """The tables in a tree of Python, by their names, as its statements leave them; what is not carried out stands in `amended`."""

    def __init__(self, tree: ast.Module) -> None:
        self.rows: dict[str, list[ast.expr]] = {}
        self.amended: list[tuple[str, str]] = []  # the name of a table, and the statement
        self._built: set[str] = set()  # names that begin empty
        self._links: set[str] = set()
        for statement in tree.body:
            self._follow(statement)

    def _follow(self, statement: ast.stmt) -> None:
        match statement:
            case ast.Assign([ast.Name(name)], value) if (rows := _rows(value)) is not None and not _mentions(
                value, name
            ):
                self.rows[name] = rows
            case ast.Assign([ast.Name(name)], ast.Call(function, _)) if _last(function) in _EMPTY:
                self._built.add(name)
            case ast.Assign([ast.Name(name)], ast.Call(function, _)) if _last(function).endswith(("Link", "DH")):
                self._links.add(name)
            case ast.Assign([ast.Name(name)], value) if self._is_table(name) and _mentions(value, name):
                self._transform(name, value, statement)
            case ast.Assign([ast.Tuple()] as targets, _):
                self._unless_harmless(targets[0], statement)
            case ast.Assign([target], value) if not isinstance(target, ast.Name):
                self._assign(target, value, None, statement)
            case ast.AugAssign(target, operator, value):
                self._assign(target, value, operator, statement)
            case ast.Expr(ast.Call(ast.Attribute(ast.Name(name), method), arguments)) if method in _METHODS:
                self._call(name, method, arguments, statement)
            case ast.Delete(targets):
                for target in targets:
                    self._unless_harmless(target, statement)
            case ast.For(ast.Name(row), ast.Name(name), body) if self._is_table(name):
                changing = [
                    each for one in body for each in ast.walk(one) if isinstance(each, ast.Assign | ast.AugAssign)
                ]
                if any(
                    _base(each) == row for one in changing for each in _targets(one) if not isinstance(each, ast.Name)
                ):
                    self.amended.append((name, ast.unparse(statement).split("\n")[-1].strip()))
            case ast.FunctionDef() | ast.ClassDef() | ast.AsyncFunctionDef():
                return  # what stands there is of its parameters
            case _:
                self._within(statement)

    def _within(self, statement: ast.stmt) -> None:
        """Follow what stands in a loop, or in what is done on a condition: nothing there is carried out."""
        for child in ast.walk(statement):
            if not isinstance(child, ast.Assign | ast.AugAssign) or _is_of_variables(child.value):
                continue
            for target in _targets(child):
                if isinstance(child, ast.AugAssign) or _base(target) not in self._built:
                    self._unless_harmless(target, child)

    def _is_table(self, name: str) -> bool:
        return bool(self.rows.get(name)) or OF_A_TABLE.fullmatch(name) is not None

    def _unless_harmless(self, target: ast.expr, statement: ast.stmt) -> None:
        places = target.elts if isinstance(target, ast.Tuple) else [target]
        names = [_base(each) for each in places if not isinstance(each, ast.Name)]
        self.amended += [(name, ast.unparse(statement)) for name in names if name and self._is_table(name)]

    def _assign(self, target: ast.expr, value: ast.expr, operator: ast.operator | None, statement: ast.stmt) -> None:
        name = _base(target)
        if isinstance(target, ast.Attribute) and name in self._links and target.attr in ("offset", *NAMES):
            self.amended.append(("", ast.unparse(statement)))
            return
        is_of_pandas = isinstance(target, ast.Subscript) and _of_pandas(target) and _FRAME.search(name) is not None
        if not name or not (self._is_table(name) or is_of_pandas) or (_is_of_variables(value) and not is_of_pandas):
            return
        if operator is None and name in self._built:
            return
        place = _place(target)
        rows = self.rows.get(name)
        if rows is None or place is None or not _carry_out(rows, place, value, operator):
            self.amended.append(("" if is_of_pandas else name, ast.unparse(statement)))

    def _transform(self, name: str, value: ast.expr, statement: ast.stmt) -> None:
        rows = self.rows.get(name)
        match value:
            case ast.Subscript(ast.Name(), ast.Slice(None, None, ast.UnaryOp(ast.USub(), ast.Constant(1)))) if rows:
                rows.reverse()
            case ast.Call(function, [ast.Name()]) if _last(function) == "flipud" and rows:
                rows.reverse()
            case ast.Call(function, _) if _last(function) in _HARMLESS:
                return
            case _:
                self.amended.append((name, ast.unparse(statement)))

    def _call(self, name: str, method: str, arguments: Sequence[ast.expr], statement: ast.stmt) -> None:
        rows = self.rows.get(name)
        if name in self._built or not self._is_table(name):
            return
        match (method, arguments):
            case ("append", [ast.List() | ast.Tuple() | ast.Call() as row]) if rows is not None:
                rows.append(row)
            case ("insert", [ast.Constant(int(place)), row]) if rows is not None and rows:
                rows.insert(place, row)
            case ("pop", []) if rows:
                rows.pop()
            case ("reverse", []) if rows:
                rows.reverse()
            case _:
                self.amended.append((name, ast.unparse(statement)))


def parsed_code(code: str) -> ast.Module | None:
    """Return the tree of a piece of Python, a notebook's commands left out; None of what cannot be parsed."""
    plain = "\n".join("" if line.lstrip().startswith(("%", "!")) else line for line in code.split("\n"))
    try:
        return ast.parse(plain)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def amended_in_matlab(code: str, tables: Collection[str]) -> Iterator[str]:
    """Yield the statements of Matlab that change tables of some names, or one that is called DH."""
    filled: set[str] = set()
    for found in _OF_MATLAB.finditer(code):
        name = found["name"] or found["whole"]
        statement = code[found.start() : code.find("\n", found.end()) if "\n" in code[found.end() :] else None].strip()
        if (found["field"] and found["field"] in ("offset", *NAMES)) or (
            found["whole"] and re.search(rf"\b{re.escape(name)}\b", found["value"]) and _is_named(name, tables)
        ):
            yield statement
        elif found["whole"]:
            filled |= {name} if found["value"].lstrip().startswith("[") and _is_named(name, tables) else set()
        elif name in filled and found["place"].strip():
            yield statement


def _is_named(name: str, tables: Collection[str]) -> bool:
    return name in tables or OF_A_TABLE.fullmatch(name) is not None


def _rows(value: ast.expr) -> list[ast.expr] | None:
    """Return the rows of what may be a table: a list, or what an array or a matrix is made of."""
    inner = value.args[0] if isinstance(value, ast.Call) and value.args and _last(value.func) in _HARMLESS else value
    if not isinstance(inner, ast.List):
        return None
    is_table = all(isinstance(each, ast.List | ast.Tuple) and len(each.elts) == _ROW for each in inner.elts)
    return inner.elts if is_table else None


def _carry_out(rows: list[ast.expr], place: tuple[int | None, int | None], value: ast.expr, operator: ast.operator | None) -> bool:  # fmt: skip
    """Whether an entry, or the same in all rows, was changed by a value that is of no other entries."""
    at, column = place
    if column is None or not all(isinstance(each, ast.List) for each in rows) or _has_subscript(value):
        return False
    if at is not None and not -len(rows) <= at < len(rows):
        return False
    for row in rows if at is None else [rows[at]]:
        entries = row.elts  # type: ignore[attr-defined]
        if not -len(entries) <= column < len(entries):
            return False
        entries[column] = value if operator is None else ast.BinOp(entries[column], operator, value)
    return operator is not None or at is not None


def _has_subscript(value: ast.expr) -> bool:
    return any(isinstance(each, ast.Subscript | ast.List | ast.ListComp) for each in ast.walk(value))


def _place(target: ast.expr) -> tuple[int | None, int | None] | None:
    """Return the row, None of all, and the column of dh[1][3], dh[1, 3] and dh[:, 3]."""
    match target:
        case ast.Subscript(ast.Subscript(ast.Name(), row), column) | ast.Subscript(
            ast.Name(), ast.Tuple([row, column])
        ):
            is_all = isinstance(row, ast.Slice) and row.lower is row.upper is row.step is None
            at, of = _number(row), _number(column)
            return (at, of) if of is not None and (is_all or at is not None) else None
    return None


def _number(node: ast.expr) -> int | None:
    match node:
        case ast.Constant(int(number)):
            return number
        case ast.UnaryOp(ast.USub(), ast.Constant(int(number))):
            return -number
    return None


def _targets(statement: ast.Assign | ast.AugAssign) -> list[ast.expr]:
    return statement.targets if isinstance(statement, ast.Assign) else [statement.target]


def _base(target: ast.expr) -> str:
    while isinstance(target, ast.Subscript | ast.Attribute | ast.Starred):
        target = target.value
    return target.id if isinstance(target, ast.Name) else ""


def _of_pandas(target: ast.Subscript) -> bool:
    """Whether a column of a table is meant by its name: table.loc[2, 'a'], df['theta']."""
    keys = target.slice.elts if isinstance(target.slice, ast.Tuple) else [target.slice]
    columns = [each.value for each in keys if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    is_placed = isinstance(target.value, ast.Attribute) and target.value.attr in _OF_PANDAS
    return any(each.lower() in NAMES for each in columns) and (is_placed or len(keys) == 1)


def _is_of_variables(value: ast.expr) -> bool:
    """Whether a value is the joints' variables alone: `q[i]`, `theta2`."""
    names = [each.id for each in ast.walk(value) if isinstance(each, ast.Name)]
    is_alone = isinstance(value, ast.Name | ast.Subscript)
    return is_alone and bool(names) and _VARIABLE.fullmatch(names[0]) is not None


def _mentions(value: ast.expr, name: str) -> bool:
    return any(isinstance(each, ast.Name) and each.id == name for each in ast.walk(value))


def _last(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""
