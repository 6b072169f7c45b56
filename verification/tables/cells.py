"""The cells of a table: what is written in them, read as expressions."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from armproof.verification.algebra.protocol import Algebra
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import GREEK, one_of
from armproof.verification.naming.names import Names
from armproof.verification.tables.columns import plain

_BLANK = re.compile(r"(?:-|–|—|−|−−|--|---|/|\\times|×|\.|\\cdot|\\dots|\\ldots)?")
_KINDS = {
    "revolute": r"0|r|rev\w*|rot\w*|continuous|pivot|hinge|dreh\w*",
    "prismatic": r"1|p|t|pris\w*|trans\w*|gliss\w*|slid\w*|schub\w*",
    "fixed": r"f|fix\w*|weld",
}
_VARIABLE = re.compile(r"\(?(?:var(?:iable)?\.?|\\?\*|\\ast|\\star)\)?", re.IGNORECASE)


@dataclass(frozen=True)
class Cell:
    """One entry: its LaTeX and the trees of the values that it states (two in `d_1 = 0.33`).

    `kind` is value, blank (nothing stands there) or variable (a word or star that says: the joint's variable).
    """

    text: str
    trees: tuple[n.Node, ...] = ()
    kind: str = "value"

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


class UnreadableCell(ReadError):
    """A cell that is not an expression."""


def read_cell(names: Names, text: str, row: int, column: int) -> Cell:
    """Return the cell of a row (from 1) and column (from 0) with its trees; raises UnreadableCell."""
    spelt = plain(text)
    if spelt == "0":
        return Cell("0", (n.Number(Fraction(0), "0"),))
    if _BLANK.fullmatch(spelt):
        return Cell(text.strip(), kind="blank")
    if _VARIABLE.fullmatch(spelt):
        return Cell(text.strip(), kind="variable")
    spelt = re.sub(r"(?<=[\w}])\s*\^?\s*\{?\*+\}?(?=\s*(?:$|[-+=)]))", "", spelt)  # θ_1*: the star of a variable
    spelt = re.sub(r"(?<![\\A-Za-z])(%s)(?![A-Za-z])" % one_of(GREEK), r"\\\1", spelt)
    spelt = re.sub(
        r"(?<![\\A-Za-z])(\\?(?:%s)|[A-Za-z])\s?(\d+)(?![\d.])" % one_of(GREEK.keys() - {"pi"}), r"\1_{\2}", spelt
    )
    spelt = re.sub(r"(?<=\d)\s*deg(?:rees)?\b", r"^\\circ", spelt)
    try:
        return Cell(text.strip(), tuple(names.reader.read_expression(part) for part in spelt.split("=")))
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
