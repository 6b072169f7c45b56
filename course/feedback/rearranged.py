"""What a matrix with two rows or columns exchanged, or on its side, is once they are back in place: what entry by entry is many slips."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from armproof.course.feedback.claim import Claim
from armproof.course.feedback.outcome import ASKED, Feedback
from armproof.course.feedback.relation import same, wrong_entries
from armproof.models.errors import ArmproofError, written
from armproof.models.language import look_up
from armproof.verification.findings import Kind, say
from armproof.verification.findings.finding import Audience, write
from armproof.verification.latex import nodes as n

_OTHER = {r"\sin": r"\cos", r"\cos": r"\sin", "S": "C", "C": "S", "s": "c", "c": "s"}
_FUNCTIONS = re.compile(r"\\(?:sin|cos)(?![A-Za-z])|(?<![A-Za-z\\])[SCsc](?=_\{?\d|\\(?:alpha|beta|phi|psi|theta))")
_MENDED = 3  # entries that an exchange explains at least, where something else is wrong too


@dataclass(frozen=True)
class Rearranged:
    """In which order the rows and the columns of an answer are those of what is asked.

    Attributes:
        words: what that says of the answer.
        rows, columns: from which place each comes; `is_turned`: of the transposed matrix.
    """

    words: str
    rows: tuple[int, ...]
    columns: tuple[int, ...]
    is_turned: bool = False

    def in_place(self, lines: np.ndarray) -> np.ndarray:
        """Return a matrix, or many, with its rows and columns in their places."""
        turned = lines.swapaxes(-1, -2) if self.is_turned else lines
        return np.asarray(turned[..., self.rows, :][..., self.columns])


def _functions_exchanged(claim: Claim, latex: str) -> str:
    """Say that all sines of an answer are cosines and all cosines sines; empty where that is not all."""
    other = _FUNCTIONS.sub(lambda found: _OTHER[found.group()], latex)
    with suppress(ArmproofError):
        if other != latex and same(claim.values(ASKED), claim.values(other)):
            return write(say(Kind.EXCHANGED_THROUGHOUT), Audience.STUDENT)
    return ""


def rearranged(
    claim: Claim, latex: str, true: np.ndarray, obtained: np.ndarray, judge: Callable[[str], Feedback]
) -> str:
    """Say which rows or columns of an answer are exchanged, and what is wrong in it besides; empty where none are.

    Args:
        true, obtained: what is asked and what is given, (samples, rows, columns).
        judge: what becomes of the answer once they are back in place.
    """
    if _is_unturned(true, obtained):
        return look_up("the rotation is the identity: the axes of the two frames are not the same")
    if words := _functions_exchanged(claim, latex) or _exchanged_with_a_sign(true, obtained):
        return words
    found = _best(true, obtained)
    if found is None:
        return ""
    if not wrong_entries(true, found.in_place(obtained)).any():
        return found.words
    cells = _cells(claim, latex)
    if cells is None or cells.shape != obtained.shape[1:]:
        return ""
    rows = (" & ".join(row) for row in found.in_place(cells).tolist())
    rest = judge(r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}")
    if rest.is_right or not rest.message:
        return found.words
    return written("{words}; once that is put right: {rest}", words=found.words, rest=rest.message)


def _exchanged_with_a_sign(true: np.ndarray, obtained: np.ndarray) -> str:
    """Say that two rows are exchanged in the columns that are wrong, and that a sign is wrong there: a quarter turn. Empty where that is not all."""
    wrong = wrong_entries(true, obtained)
    rows, columns = (np.flatnonzero(wrong.any(axis=axis)).tolist() for axis in (1, 0))
    if len(rows) != 2 or wrong.sum() != 2 * len(columns) or 1 < true.shape[2] == len(columns):
        return ""  # of whole rows the exchange is told, and what is left
    one, other = rows
    signs = [[_sign(obtained[:, here, column], true[:, there, column]) for here, there in ((one, other), (other, one))] for column in columns]  # fmt: skip
    if not all(all(pair) for pair in signs) or not any(pair in ([1, -1], [-1, 1]) for pair in signs):
        return ""
    if len(columns) == 1:
        (column,) = columns
        return written("entries ({row}, {column}) and ({other}, {column}) are exchanged, and the sign of one is wrong", row=one + 1, other=other + 1, column=column + 1)  # fmt: skip
    return written("in the columns {columns} the rows {one} and {other} are exchanged, and signs are wrong", columns=[column + 1 for column in columns], one=one + 1, other=other + 1)  # fmt: skip


def _sign(obtained: np.ndarray, true: np.ndarray) -> int:
    """Return 1 where values are the same, -1 where they have the other sign, else 0."""
    return 1 if same(obtained, true) else -1 if same(obtained, -true) else 0


def _is_unturned(true: np.ndarray, obtained: np.ndarray) -> bool:
    """Whether a pose is right but for its rotation, which is the identity."""
    if true.shape[1:] not in ((3, 3), (4, 4)) or true.shape != obtained.shape:
        return False
    wrong = wrong_entries(true, obtained)
    wrong[:3, :3] &= False
    return not wrong.any() and same(obtained[:, :3, :3], np.broadcast_to(np.eye(3), obtained[:, :3, :3].shape))


def _best(true: np.ndarray, obtained: np.ndarray) -> Rearranged | None:
    """Return the exchange that leaves the fewest entries wrong, if it explains most of them."""
    before = int(wrong_entries(true, obtained).sum())
    if before < 2 or true.shape != obtained.shape:
        return None
    left = {each: int(wrong_entries(true, each.in_place(obtained)).sum()) for each in _exchanges(true)}
    best = min(left, key=lambda each: left[each], default=None)
    if best is not None and (not left[best] or (before - left[best] >= _MENDED and 2 * left[best] <= before)):
        return best
    return _in_another_order(true, obtained) or _both_ways(true, obtained) or _from_the_end(true, obtained)


def _both_ways(true: np.ndarray, obtained: np.ndarray) -> Rearranged | None:
    """Return that two rows and two columns are exchanged, or two of either in a transposed matrix, which together explain all."""
    all_of_them = [*_exchanges(true)]
    single = [each for each in all_of_them if not each.is_turned]
    pairs = [_on_its_side(turned, each) for turned in all_of_them if turned.is_turned for each in single]
    for one, other in combinations(single, 2):
        rows, columns = (
            (other.rows, one.columns) if other.rows != tuple(sorted(other.rows)) else (one.rows, other.columns)
        )
        pairs.append(Rearranged(one.words + look_up("; ") + other.words, rows, columns))
    return next((both for both in pairs if not wrong_entries(true, both.in_place(obtained)).any()), None)


def _on_its_side(turned: Rearranged, other: Rearranged) -> Rearranged:
    """Return an exchange in a transposed matrix."""
    words = written("{words}; once that is put right: {rest}", words=turned.words, rest=other.words)
    return replace(other, words=words, is_turned=True)


def _exchanges(true: np.ndarray) -> Iterator[Rearranged]:
    height, width = true.shape[1:]
    rows, columns = tuple(range(height)), tuple(range(width))
    if height == width > 1:
        yield Rearranged(write(say(Kind.TRANSPOSED), Audience.STUDENT), rows, columns, is_turned=True)
    for one, other in combinations(columns, 2):
        words = write(say(Kind.COLUMNS_SWAPPED, one=one + 1, other=other + 1), Audience.STUDENT)
        yield Rearranged(words, rows, _exchanged(columns, one, other))
    for one, other in combinations(rows, 2):
        words = written("rows {one} and {other} are swapped", one=one + 1, other=other + 1)
        yield Rearranged(words, _exchanged(rows, one, other), columns)


def _exchanged(order: tuple[int, ...], one: int, other: int) -> tuple[int, ...]:
    return tuple({one: other, other: one}.get(place, place) for place in order)


def _in_another_order(true: np.ndarray, obtained: np.ndarray) -> Rearranged | None:
    """Return that all rows are those of what is asked, in another order."""
    left, order = list(range(true.shape[1])), []
    for row in range(true.shape[1]):
        found = next((k for k in left if same(obtained[:, k], true[:, row])), None)
        if found is None:
            return None
        left.remove(found)
        order.append(found)
    return Rearranged(look_up("the rows are right, their order is not"), tuple(order), tuple(range(true.shape[2])))


def _from_the_end(true: np.ndarray, obtained: np.ndarray) -> Rearranged | None:
    """Return that the columns are those of what is asked in the reverse order, and the rows in that or in another one."""
    columns, words = tuple(range(true.shape[2]))[::-1], look_up("the columns stand in the reverse order")
    if len(columns) < 3:
        return None
    if not wrong_entries(true, obtained[..., columns]).any():
        return Rearranged(words, tuple(range(true.shape[1])), columns)
    ordered = _in_another_order(true, obtained[..., columns])
    return ordered and Rearranged(words + look_up("; ") + ordered.words, ordered.rows, columns)


def _cells(claim: Claim, latex: str) -> np.ndarray | None:
    """Return the entries of a matrix as they are written; None of a formula that is no matrix."""
    matrix = n.ungrouped(claim.read(latex))
    if not isinstance(matrix, n.Matrix):
        return None
    return np.array([[latex[cell.span[0] : cell.span[1]] for cell in row] for row in matrix.rows], dtype=object)
