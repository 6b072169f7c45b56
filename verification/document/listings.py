"""Values that stand in a document's code and at the end of what it works out: `l1 = 0.3;`, θ_1 = arctan(…) = 1.738 rad."""

from __future__ import annotations

import ast
import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from math import pi

from armproof.verification.document.heading import encloses
from armproof.verification.document.model import Display, Listing
from armproof.verification.document.moving_on import RESIZED
from armproof.verification.patterns import regex

_LETTERS = {"theta": r"\theta", "th": r"\theta", "alpha": r"\alpha", "beta": r"\beta", "phi": r"\phi"}
_LETTERS |= {letter: letter for letter in "adhlLqr"}
_ASSIGNED = regex(rf"(?<![\w.\[(])({'|'.join(sorted(_LETTERS, key=len, reverse=True))})_?(\d{{1,2}})\s*=(?!=)\s*(.+)")
_NAMED = regex(rf"(?<![\w.])({'|'.join(sorted(_LETTERS, key=len, reverse=True))})_?(\d{{1,2}})(?!\w)")
_GIVES = regex(r"(?P<names>[^=()<>!\[\]]*?)\s*(?:[-+*/]|\*\*|//)?=(?!=)")  # l1, l2 = …; l2 *= 2
_COMMENT = regex(r"[#%].*|//.*")
_PREFIX = regex(r"(?<![\w.])(?:numpy|np|math|sympy|sp)\.")
_DEGREES = regex(r"(?<!\w)(?:deg2rad|radians)\(")
_OPERATORS: dict[type[ast.operator], str] = {ast.Add: "{} + {}", ast.Sub: "{} - {}", ast.Mult: r"{} \cdot {}"}
NEAREST = 4  # pieces of code that are looked at for a display
MOST = 40  # assignments of a listing that are looked at
_WORKED = regex(
    r"\s*(\\theta|q)\s*_\s*\{?(\d)\}?\s*=(?P<between>[^,;&]*[^\W\d_][^,;&]*)=\s*(?P<number>-?\s*\d+\.\d+)\s*(?:\\[ ,;:]|~)*\s*"
    r"(?:(?:\\(?:text|mathrm|rm)\s*\{?\s*)?(?P<unit>rad|deg|°|\^\{?\\circ\}?|\^\{?°\}?)[a-zé]*\s*\}?)?\s*[.,;]?\s*",
    re.DOTALL,
)
_SEVERAL = regex(r"\\\\|\\q?quad|\\text|\\begin|\n\s*\n")  # no single chain
FEWEST_DECIMALS = {"rad": 3, "deg": 1}


def assignments(code: str) -> tuple[str, ...]:
    """Return the numbers that code gives to joints and lengths, as equations in LaTeX; none that it gives two of."""
    found: dict[str, set[str]] = {}
    for name, value in list(_assigned(code))[:MOST]:
        found.setdefault(name, set()).add(value)
    return tuple(f"{name} = {values.pop()}" for name, values in found.items() if len(values) == 1)


def assigned_in(code: str) -> frozenset[str]:
    """Return the joints and lengths to which code gives anything, a number or not, as LaTeX."""
    given = (found for each in _statements(code) if (found := _GIVES.match(each)) is not None)
    return frozenset(_in_letters(each) for found in given for each in _NAMED.finditer(found["names"]))


def _assigned(code: str) -> Iterator[tuple[str, str]]:
    for statement in _statements(code):
        found = _ASSIGNED.fullmatch(statement)
        if found and (value := _in_latex(found[3])) is not None:
            yield _in_letters(found), value


def _statements(code: str) -> Iterator[str]:
    for line in code.split("\n"):
        yield from (each.strip().rstrip(",") for each in _COMMENT.sub("", line).split(";"))


def _in_letters(found: re.Match[str]) -> str:
    return f"{_LETTERS[found[1]]}_{{{found[2]}}}"


def _in_latex(value: str) -> str | None:
    """Return a number of code as LaTeX, None for anything else."""
    plain = _DEGREES.sub("pi/180*(", _PREFIX.sub("", value)).strip()
    try:
        return _written(ast.parse(plain, mode="eval").body)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def _written(node: ast.expr) -> str:
    match node:
        case ast.Constant(value) if type(value) in (int, float):
            return f"{Decimal(repr(value)):f}"
        case ast.Name("pi"):
            return r"\pi"
        case ast.UnaryOp(ast.USub(), inner):
            return f"(-{_written(inner)})"
        case ast.BinOp(left, ast.Div(), right):
            return rf"\frac{{{_written(left)}}}{{{_written(right)}}}"
        case ast.BinOp(left, operator, right) if type(operator) in _OPERATORS:
            return f"({_OPERATORS[type(operator)].format(_written(left), _written(right))})"
    raise ValueError


def worked_value(latex: str) -> tuple[str, str] | None:
    r"""Return the joint and the number that a chain ends with, \theta_1 = \arctan(…) = 1.738; None where it ends otherwise."""
    plain = unicodedata.normalize("NFKC", latex).replace("θ", r"\theta").replace("\N{MINUS SIGN}", "-")
    found = _WORKED.fullmatch(plain)
    if found is None or _SEVERAL.search(found["between"]):
        return None
    in_degrees = (found["unit"] or "rad") != "rad"
    number = re.sub(r"\s", "", found["number"])
    if _decimals(number) < FEWEST_DECIMALS["deg" if in_degrees else "rad"]:
        return None
    return f"{found[1]}_{{{found[2]}}}", rf"{number} \cdot \frac{{\pi}}{{180}}" if in_degrees else number


def with_listings(displays: Iterable[Display], code: Sequence[Listing]) -> Iterator[Display]:
    """Yield displays with the values that code under their headings gives, the nearest first, and what is worked out above."""
    worked: dict[str, str] = {}
    for display in displays:
        if RESIZED in display.said:  # code above is of other lengths
            code = [each for each in code if each.place >= _place(display)]
        own = _as_it_runs([each for each in code if encloses(each.section, display.section)], _place(display))
        near = sorted(own, key=lambda each: (each.section != display.section, abs(each.line - display.line)))[:NEAREST]
        ends = tuple(f"{name} = {value}" for name, value in worked.items())
        above = [Listing(display.line, ends, off=max(map(_off, worked.values())))] if worked else []
        yield replace(display, listed=(*near, *above)) if near or above else display
        if (found := worked_value(display.latex)) is not None:
            worked[found[0]] = found[1]


def _place(display: Display) -> tuple[int, int]:
    return display.cell or 0, display.line


def _as_it_runs(code: Sequence[Listing], place: tuple[int, int]) -> list[Listing]:
    """Return pieces of code, those above a place as one: what one of them gives anew has the value before no longer."""
    above = [each for each in code if each.place < place]
    rest = [each for each in code if each.place >= place]
    values: dict[str, str] = {}
    for each in above:
        values = {name: value for name, value in values.items() if name not in each.assigned}
        values |= dict(value.split(" = ", 1) for value in each.values)
    told = tuple(f"{name} = {value}" for name, value in values.items())
    last = next((each for each in reversed(above) if each.values), None)
    return [*([replace(last, values=told)] if last is not None and told else []), *(e for e in rest if e.values)]


def _off(value: str) -> float:
    """Return how far a value may be from what it is rounded from."""
    return 0.5 * 10.0 ** -_decimals(value) * (pi / 180 if "pi" in value else 1.0)


def _decimals(value: str) -> int:
    return len(value.split(" ")[0].partition(".")[2])
