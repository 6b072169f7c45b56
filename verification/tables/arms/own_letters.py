"""Slips in the one length of a link, which its row of a table tells: d_2 in row 2 is what the author calls that length."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from armproof.verification.findings import Kind
from armproof.verification.patterns import regex
from armproof.verification.verdict import TakenArm, WrongEntry

_LENGTH = regex(r"(?<![A-Za-z\\])([adlrADLR])_\{?(\d)\}?")


def is_index_slip(
    rows: Sequence[Mapping[str, Any]], link: int, column: str, lengths: tuple[str, str], convention: str
) -> bool:
    """Whether a row holds the length of another row, which has it too, where that of its own index stands in none: a_2 twice, and a_3 nowhere.

    The lengths are the one that is printed and the one that is meant.
    """
    found = [_LENGTH.fullmatch(each) for each in lengths]
    if column not in ("a", "d") or found[0] is None or found[1] is None or found[0][1] != found[1][1]:
        return False
    shift = 1 if column == "a" and convention == "modified" else 0
    elsewhere = {place: {str(row["a"]), str(row["d"])} for place, row in enumerate(rows, 1) if place != link}
    is_own = int(found[1][2]) == link - shift != int(found[0][2])
    is_of_other = lengths[0] in elsewhere.get(int(found[0][2]) + shift, ())
    return is_own and is_of_other and not any(lengths[1] in each for each in elsewhere.values())


def has_index_of_another(taken: TakenArm, link: int, wrong: WrongEntry) -> bool:
    """Whether the length is that of another row, d_6 for d_4, where the table has it, and in this row that of its own index."""
    rows = taken.front["arm"]["rows"]
    printed, correct = ({*_LENGTH.findall(text)} for text in (wrong.printed, wrong.correct))
    if link < 1 or not len(printed) == len(correct) == 1:
        return False
    (letter, index), (own_letter, own) = printed.pop(), correct.pop()
    own_indices = {link, link - 1} if own_letter == "a" and taken.convention == "modified" else {link}
    elsewhere = {str(row[role]) for place, row in enumerate(rows, 1) for role in "ad" if place != link}
    is_its_own = int(own) in own_indices and int(index) not in own_indices
    return letter == own_letter and is_its_own and f"{letter}_{index}" in elsewhere


def has_other_sign(taken: TakenArm, link: int, wrong: WrongEntry) -> bool:
    """Whether the length has the other sign of that in its row, where that holds its own letter alone."""
    arm = taken.front["arm"]
    row, rows = link - ("base" in arm), arm["rows"]  # a base of its own is no row
    lengths = {*_LENGTH.findall(wrong.correct)}
    is_sign = wrong.finding is not None and wrong.finding.kind is Kind.WRONG_SIGN
    if not 1 <= row <= len(rows) or not is_sign or len(lengths) != 1 or {*_LENGTH.findall(wrong.printed)} != lengths:
        return False
    ((letter, index),) = lengths
    own_indices = {row, row - 1} if letter in "alAL" and taken.convention == "modified" else {row}
    return int(index) in own_indices and f"{letter}_{index}" in {str(rows[row - 1][role]) for role in "ad"}
