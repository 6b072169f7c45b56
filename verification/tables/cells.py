"""The cells of a table: what is written in them, read as expressions."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from armproof.verification.algebra.protocol import Algebra
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import GREEK, SPELT, one_of
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.columns import plain

_BLANK = regex(r"(?:-|–|—|−|−−|--|---|/|\\times|×|\.|\\cdot|\\dots|\\ldots)?")
_KINDS = {
    "revolute": r"0|r|rev\w*|rot\w*|continuous|pivot|hinge|dreh\w*",
    "prismatic": r"1|p|t|pris\w*|trans\w*|gliss\w*|slid\w*|schub\w*",
    "fixed": r"f|fix\w*|weld",
}
_GLUED = regex(  # q1, but not in a script
    r"[_^]\s*\{[^{}]*\}|(?<![\\A-Za-z])(\\?(?:%s)|[A-Za-z])\s?(\d+)(?![\d.])" % one_of(GREEK.keys() - {"pi"})
)
_WORD = regex(r"([-+]?[adlhrADLHR])([A-Za-z]{1,3})")  # dg, -LT: a length with its index
_LETTERS = regex(r"(?<![\\A-Za-z{])([A-Z]{2,3})_?\{?(\d+)\}?")  # RL4: one length
_UNIT = regex(r"(?<![\d.])(\d+(?:\.\d+)?)\s*(mm|cm|m)(?![A-Za-z_]|\s*\^)")
_METRES = {"mm": Fraction(1, 1000), "cm": Fraction(1, 100), "m": Fraction(1)}
_COMMA = regex(r"(?<![\d_{,])(?:(\d+),(?!\d{3}\b)(\d+)|0,(\d+))(?![\d,}])")  # 1,250 may be a thousand
_VALUED = regex(
    r"([^=(\[:≈]*[A-Za-z][^=(\[:≈]*?)\s*(?:\(|\[|:|≈|\\approx(?![A-Za-z])|\\simeq(?![A-Za-z]))\s*([-+−]?\s*\d+(?:\.\d+)?)\s*[)\]]?"
)
_LONGEST_VALUED = 80  # a longer cell is none, and would take its time
_VARIABLE = regex(r"\(?(?:var(?:iable)?\.?|\\?\*|\\ast|\\star)\)?", re.IGNORECASE)

_RANGE = regex(r"[\[(][^\[\](),;]+[,;][^\[\](),;]+[\])]|(?:±|\\pm(?![A-Za-z]))[^=]*")  # [-π, π]: of what moves


@dataclass(frozen=True)
class Cell:
    """One entry: its LaTeX and the trees of the values that it states (two in `d_1 = 0.33`).

    `kind` is value, blank (nothing stands there) or variable (a word, a star or its range that says: the joint's variable).
    """

    text: str
    trees: tuple[n.Node, ...] = ()
    kind: str = "value"
    has_unit: bool = False  # its numbers are in metres

    @property
    def name(self) -> n.Name | None:
        """The one name that the cell consists of."""
        return self.trees[0] if len(self.trees) == 1 and isinstance(self.trees[0], n.Name) else None

    @property
    def has_letters(self) -> bool:
        """Whether a name occurs in the cell."""
        return any(isinstance(node, n.Name) for tree in self.trees for node in n.walk(tree))

    def values(self, names: Names, algebra: Algebra) -> list[Scalar]:
        """Return the values; raises EvaluationError."""
        evaluator = Evaluator(names, algebra)
        return [evaluator.scalar(tree) for tree in self.trees]


def nothing_stands_in(row: Iterable[Cell]) -> bool:
    """Whether all cells of a row are blank: it is left to be filled in."""
    return all(cell.kind == "blank" for cell in row)


class UnreadableCell(ReadError):
    """A cell that is not an expression."""


def read_cell(names: Names, text: str, row: int, column: int, in_metres: bool = True) -> Cell:
    """Return the cell of a row (from 1) and column (from 0) with its trees; raises UnreadableCell.

    A number with a unit of its own is taken in metres, or as it stands.
    """
    spelt = plain(text)
    if spelt == "0":
        return Cell("0", (n.Number(Fraction(0), "0"),))
    if _BLANK.fullmatch(spelt):
        return Cell(text.strip(), kind="blank")
    if _VARIABLE.fullmatch(spelt) or _RANGE.fullmatch(spelt):
        return Cell(text.strip(), kind="variable")
    spelt = re.sub(r"\s*[(\[]\s*var(?:iable)?\.?\s*[)\]]$", "", spelt)
    spelt = re.sub(r"(?<=[\w}])\s*\^?\s*\{?\*+\}?(?=\s*(?:$|[-+=)]))", "", spelt)  # θ_1*: the star of a variable
    spelt = _COMMA.sub(lambda number: f"{number[1] or 0}.{number[2] or number[3]}", spelt)
    spelt, units = _UNIT.subn(
        lambda found: _number(Fraction(found[1]) * (_METRES[found[2]] if in_metres else 1)), spelt
    )
    if len(spelt) < _LONGEST_VALUED and (valued := _VALUED.fullmatch(spelt)):  # l_1 (0.45)
        spelt = f"{valued[1]} = {valued[2]}"
    spelt = SPELT.sub(r"\\\1", spelt)
    if word := _WORD.fullmatch(spelt):
        spelt = f"{word[1]}_{{{word[2]}}}"
    spelt = _LETTERS.sub(r"\\mathrm{\1}_{\2}", spelt)
    spelt = _GLUED.sub(lambda found: f"{found[1]}_{{{found[2]}}}" if found[1] else found[0], spelt)
    spelt = re.sub(r"(?<=\d)\s*deg(?:rees)?\b", r"^\\circ", spelt)
    try:
        trees = tuple(names.reader.read_expression(part) for part in spelt.split("="))
        return Cell(text.strip(), trees, has_unit=units > 0)
    except ReadError as error:
        place = {"row": row, "column": column + 1, "cell": text.strip()}
        raise UnreadableCell(say(Kind.UNREADABLE_CELL, **place, problem=finding_of(error))) from None


def read_kind(text: str) -> str:
    """Return the kind of joint that a cell names by a word, an initial or σ (0: revolute), or an empty text."""
    return next((kind for kind, words in _KINDS.items() if re.fullmatch(words, plain(text).lower())), "")


def read_axis(text: str) -> tuple[float, ...]:
    """Return an axis written as x, -z or [0 0 1]; raises EvaluationError."""
    spelt = plain(text).lower()
    if letter := re.fullmatch(r"([-+]?)\s*([xyz])", spelt):
        return tuple(float(f"{letter.group(1)}{int(letter.group(2) == axis)}") for axis in "xyz")
    parts = tuple(float(part) for part in re.findall(r"[-+]?\d*\.?\d+", spelt))
    if len(parts) != 3:
        raise EvaluationError(say(Kind.NO_AXIS, cell=text))
    return parts


class Notation:
    """Writes values as the cells of a table do: its letters, its fractions, its degrees."""

    def __init__(self, names: Names, cells: Iterable[Cell]) -> None:
        cells = list(cells)
        nodes = (node for cell in cells for tree in cell.trees for node in n.walk(tree))
        keys = [node.key for node in nodes if isinstance(node, n.Name)]
        self._symbols: dict[str, str] = {}
        for key in (*keys, *names.symbols):
            if (symbol := names.known_symbol(key)) is not None:
                self._symbols.setdefault(symbol, key_as_latex(key))
        text = " ".join(cell.text for cell in cells)
        self._slash = re.search(r"(?:\\pi|π|\bpi\s*)/", text) is not None
        self._fraction = "\\dfrac" if "\\dfrac" in text else "\\frac"

    def symbol(self, name: str) -> str:
        """Return the document's spelling of a symbol of the arm."""
        return self._symbols.get(name) or key_as_latex(name)

    def value(self, value: Scalar, degrees: str | None = None) -> str:
        """Return a value; `degrees` is the sign after a number of degrees, or None for radians."""
        value = value.normal()
        if not value.denominator.is_one():
            return str(value)
        ring = value.ring
        terms = sorted(ring.terms(value.numerator), key=lambda term: _rank(term[0]))
        written = [self._term(dict(powers), coefficient, degrees) for powers, coefficient in terms]
        text = " + ".join(written).replace("+ -", "- ")
        return text or ("0" + degrees if degrees else "0")

    def _term(self, powers: dict[tuple[str, str], int], coefficient: Fraction, degrees: str | None) -> str:
        sign = "-" if coefficient < 0 else ""
        size = abs(coefficient)
        if degrees is not None and powers == {("pi", ""): 1}:
            return f"{sign}{_number(size * 180)}{degrees}"
        product = " ".join(
            self._generator(kind, name) + (f"^{power}" if power > 1 else "") for (kind, name), power in powers.items()
        )
        if ("pi", "") in powers and size.denominator > 1:
            above = product if size.numerator == 1 else f"{size.numerator}{product}"
            below = size.denominator
            return sign + (f"{above}/{below}" if self._slash else f"{self._fraction}{{{above}}}{{{below}}}")
        return sign + " ".join(
            [*([_number(size)] if size != 1 or not product else []), *([product] if product else [])]
        )

    def _generator(self, kind: str, name: str) -> str:
        if kind == "pi":
            return "\\pi"
        if kind == "sqrt":
            return f"\\sqrt{{{name}}}"
        if kind in ("cos", "sin"):
            return f"\\{kind} {self.symbol(name)}"
        return self.symbol(name)


def _rank(powers: dict[tuple[str, str], int]) -> tuple[int, str]:
    kinds = {kind for kind, _ in powers}
    return (2 if not kinds else 1 if kinds == {"pi"} else 0, " ".join(sorted(name for _, name in powers)))


def _number(value: Fraction) -> str:
    if value.denominator == 1:
        return str(value.numerator)
    if 10**6 % value.denominator == 0:
        return f"{float(value):.6f}".rstrip("0").rstrip(".")
    return f"{value.numerator}/{value.denominator}"
