"""The columns of rows of DH parameters in code: told by a comment, by the function that they are handed to, or by what stands in them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence

NAMES = {
    "alpha": "alpha",
    "twist": "alpha",
    "a": "a",
    "r": "a",
    "d": "d",
    "theta": "theta",
    "q": "theta",
    "th": "theta",
}
OF_A_TABLE = re.compile(  # what a table of DH parameters is called in code: DH, dh_params, MDHtable, robotDH
    r"_?(?:[a-z]+_?)?(?:m?dh|DH|MDH|Dh)(?:_?(?:param(?:s|eters?)?|table|tab|mat(?:rix)?|rows?))?\d?|denavit\w*",
    re.IGNORECASE,
)
_GREEK = str.maketrans({"α": "alpha", "θ": "theta"})
_TURNS = re.compile(r"(?:q|th|theta|t)_?\d{1,2}|(?:q|th|theta)")
_OF_MATHWORKS = re.compile(r"\bsetFixedTransform\s*\([^;\n]*'m?dh'", re.IGNORECASE)  # [a alpha d theta], by its manual
_SLIDES = re.compile(r"'prismatic'", re.IGNORECASE)
_FILLED = re.compile(
    r"^[ \t]*([A-Za-z]\w{0,30})[ \t]*(?:\([ \t]*\d+[ \t]*,[ \t]*:[ \t]*\))?[ \t]*=[ \t]*\[", re.MULTILINE
)
_LINKED = re.compile(r"\b(?:(?:DH)?Link|(?:Revolute|Prismatic)(?:M?DH)?)\(\s*(?:\[|'|[a-z]+\s*=)")
_FOUR = re.compile(r"[#%\s]*\w+(?:\s*[,|]\s*\w+){3}\s*[,|]?\s*")
_IN_DEGREES = frozenset([30, 45, 60, 90, 120, 135, 180, 270])


def shows_rows(text: str) -> bool:
    """Whether a paragraph is code that lost its fence: DH = [0 0 d1 q1; …], Link('d', 0.3, …)."""
    return any(map(OF_A_TABLE.fullmatch, _FILLED.findall(text))) or _LINKED.search(text) is not None


def named_columns(lines: Sequence[str], begin: int, end: int) -> tuple[str, ...]:
    """Return the columns that a comment names above rows, or between them."""
    for comment in _comments(lines, begin, end):
        words = re.findall(r"[a-z]+", re.sub("_?i(?:-1)?(?![a-z])", " ", comment.lower().translate(_GREEK)))
        found = tuple(NAMES[word] for word in words if word in NAMES)
        if sorted(found) == ["a", "alpha", "d", "theta"]:
            return found
    return ()


def names_others(lines: Sequence[str], begin: int, end: int) -> bool:
    """Whether a comment names four columns there, whatever they are."""
    return any(map(_FOUR.fullmatch, _comments(lines, begin, end)))


def _comments(lines: Sequence[str], begin: int, end: int) -> Iterator[str]:
    """Yield the comments in the first rows, then those above them, the nearest first."""
    for line in (*lines[begin : min(begin + 3, end)], *reversed(lines[max(0, begin - 3) : begin])):
        if comment := re.search(r"[#%].*", line):
            yield comment[0]


def columns_of_manual(code: str) -> tuple[str, ...]:
    """Return the columns that rows have which are handed to a function whose manual tells them: none where a joint slides."""
    return ("a", "alpha", "d", "theta") if _OF_MATHWORKS.search(code) and not _SLIDES.search(code) else ()


def columns_of_entries(rows: Sequence[Sequence[ast.expr]]) -> tuple[str, ...]:
    """Return the columns of rows of four entries, told by these: θ holds the joints' letters, α parts of π, and d stands beside θ.

    In every order that is in use, θ and d are one half of the row, a and α the other. Nothing where two columns may be one, or
    a letter such as d_1 stands where it is no d.
    """
    columns = [*zip(*rows, strict=True)]
    turning = [sum(any(map(_TURNS.fullmatch, _letters(entry))) for entry in column) for column in columns]
    theta = turning.index(max(turning))
    if turning.count(max(turning)) != 1 or 2 * max(turning) < len(rows):
        return ()
    half = (2, 3) if theta < 2 else (0, 1)
    alphas = [place for place in half if _are_twists(columns[place])]
    with_parts = [place for place in alphas if any(not _is_zero(entry) for entry in columns[place])]
    alpha = with_parts or (alphas if len(alphas) == 1 else [])
    lengths = [entry for place in (theta ^ 1, (alpha or [0])[0] ^ 1) for entry in columns[place]]
    if len(alpha) != 1 or any("pi" in _letters(entry) for entry in lengths):
        return ()
    found = {theta: "theta", theta ^ 1: "d", alpha[0]: "alpha", alpha[0] ^ 1: "a"}
    wrong = {"d": "a", "a": "d"}
    named = (
        (found[place], letter[0]) for place, column in enumerate(columns) for e in column for letter in _letters(e)
    )
    return () if any(wrong.get(key) == letter for key, letter in named) else tuple(found[place] for place in range(4))


def in_radians(rows: Sequence[Mapping[str, ast.expr]]) -> list[dict[str, ast.expr]]:
    """Return rows with the twists that are whole degrees, 90 or -180, as such."""
    degrees = [_number(row["alpha"]) for row in rows]
    if not all(number is not None and (number == 0 or abs(number) in _IN_DEGREES) for number in degrees):
        return [dict(row) for row in rows]
    turned = ast.Name("deg2rad")
    return [dict(row) | {"alpha": ast.Call(turned, [row["alpha"]], []) if number else row["alpha"]}
            for row, number in zip(rows, degrees, strict=True)]  # fmt: skip


def _are_twists(column: Sequence[ast.expr]) -> bool:
    """Whether a column holds nothing but zeros, parts of π and whole degrees."""
    return all(
        _is_zero(entry) or (_letters(entry) == ["pi"]) or abs(_number(entry) or 0) in _IN_DEGREES for entry in column
    )


def _letters(entry: ast.expr) -> list[str]:
    """Return the names in an entry, that of the module before np.pi left out; q(1) and q[0] have a number."""
    return [*_names(entry)]


def _names(node: ast.expr) -> Iterator[str]:
    match node:
        case ast.Attribute(_, name) | ast.Name(name):
            yield name
        case ast.Call(ast.Name(name), [ast.Constant(int())]) | ast.Subscript(ast.Name(name), ast.Constant(int())):
            yield name
        case ast.Call(_, arguments):
            for each in arguments:
                yield from _names(each)
        case _:
            for child in ast.iter_child_nodes(node):
                yield from _names(child) if isinstance(child, ast.expr) else ()


def _is_zero(entry: ast.expr) -> bool:
    return _number(entry) == 0


def _number(entry: ast.expr) -> float | None:
    """Return the number that an entry is, None of what is none."""
    match entry:
        case ast.Constant(int() | float() as value) if not isinstance(value, bool):
            return float(value)
        case ast.UnaryOp(ast.USub(), inner):
            number = _number(inner)
            return -number if number is not None else None
    return None
