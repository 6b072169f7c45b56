"""The columns of rows of DH parameters in code: told by a comment, by the function that they are handed to, or by what stands in them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence

from armproof.verification.patterns import regex

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
OF_A_TABLE = regex(  # what a table of DH parameters is called in code: DH, dh_params, MDHtable, robotDH
    r"_?(?:[a-z]+_?)?(?:m?dh|DH|MDH|Dh)(?:_?(?:param(?:s|eters?)?|table|tab|mat(?:rix)?|rows?))?\d?|denavit\w*",
    re.IGNORECASE,
)
_GREEK = str.maketrans({"α": "alpha", "θ": "theta"})
_TURNS = regex(r"(?:q|th|theta|t)_?\d{1,2}|(?:q|th|theta)")
_LENGTH = regex(r"[ad](?:_?\d{1,2})?")
_OF_MATHWORKS = regex(r"\bsetFixedTransform\s*\([^;\n]*'m?dh'", re.IGNORECASE)  # [a alpha d theta], by its manual
_SLIDES = regex(r"'prismatic'", re.IGNORECASE)
_FILLED = regex(r"^[ \t]*([A-Za-z]\w{0,30})[ \t]*(?:\([ \t]*\d+[ \t]*,[ \t]*:[ \t]*\))?[ \t]*=[ \t]*\[", re.MULTILINE)
_LINKED = regex(r"\b(?:(?:DH)?Link|(?:Revolute|Prismatic)(?:M?DH)?)\(\s*(?:\[|'|[a-z]+\s*=)")
_FOUR = regex(r"[#%\s]*\w+(?:\s*[,|]\s*\w+){3}\s*[,|]?\s*")
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
    """Return the columns of rows of four entries, told by these: θ holds the joints' letters, α parts of π, d a d_1 or a an a_2.

    Nothing where that is not told: both [α a d θ] and [α d a θ] are in use, and numbers or an l_1 may be either.
    """
    columns = [*zip(*rows, strict=True)]
    turning = [sum(any(map(_TURNS.fullmatch, _letters(entry))) for entry in column) for column in columns]
    theta = turning.index(max(turning))
    others = [place for place in range(4) if place != theta]
    twists = [place for place in others if _are_twists(columns[place])]
    alpha = [place for place in twists if not all(map(_is_zero, columns[place]))] or twists[:1]
    if turning.count(max(turning)) != 1 or 2 * max(turning) < len(rows) or len(alpha) != 1:
        return ()
    one, other = (place for place in others if place != alpha[0])
    told = _told_lengths(columns[one]), _told_lengths(columns[other])
    found = {
        ("d", "a"): "da",
        ("d", ""): "da",
        ("", "a"): "da",
        ("a", "d"): "ad",
        ("a", ""): "ad",
        ("", "d"): "ad",
    }.get(told)
    if found is None:
        return ()
    names = {theta: "theta", alpha[0]: "alpha", one: found[0], other: found[1]}
    return tuple(names[place] for place in range(4))


def _told_lengths(column: Sequence[ast.expr]) -> str:
    """Return whether the letters of a column are d_1 or a_2, "" where none is either, and "?" where it holds both or parts of π."""
    letters = {letter for entry in column for letter in _letters(entry)}
    kinds = {letter[0] for letter in letters if _LENGTH.fullmatch(letter)}
    return "?" if len(kinds) > 1 or "pi" in letters else "".join(kinds)


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
