"""The two editions of a sheet: the students', and the one with solutions.

A worked solution is a section whose heading is "Solution" (or "Corrigé"), up to the next heading of its level or above, or
a block quote that begins with **Solution**. On the students' sheet stands blank space in its place, about as much as the
solution takes in handwriting. Of an erratum the students' sheet keeps the words, which say where the source is wrong, and
leaves the formula to the edition with solutions: nobody is to learn a wrong one off a sheet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import zip_longest
from typing import TypeGuard

from armproof.course.sheet.model import (  # fmt: skip
    Blank,
    Block,
    Display,
    Heading,
    Listing,
    Paragraph,
    Picture,
    Quote,
    Table,
    inner,
    plain,
    with_inner,
)
from armproof.course.sheet.reading import opens_solution

_LINE = 7.0  # mm of a line in handwriting
_HIGHEST = 100.0  # mm, so that two with their questions fill a page
_LONG = 90  # characters a line


def with_solutions(blocks: Sequence[Block]) -> tuple[Block, ...]:
    """Return the blocks with each section that is a solution as one solution, on the page of the question before it."""
    gathered = [
        Quote("solution", tuple(part)) if is_one and len(part) > 1 else block
        for is_one, part in _parts(blocks)
        for block in ([part[0]] if is_one and len(part) > 1 else part)
    ]
    return tuple(
        replace(block, leads=True) if isinstance(block, Paragraph) and is_solution(after) else block
        for block, after in zip_longest(gathered, gathered[1:])
    )


def for_students(blocks: Sequence[Block]) -> tuple[Block, ...]:
    """Return the blocks without the formulas of errata, and with blank space for each solution."""
    kept: list[Block] = []
    for block in with_solutions(blocks):
        if is_solution(block):
            kept.append(Blank(_height(block.blocks)))
            continue
        block = with_inner(block, for_students)
        if isinstance(block, Quote) and block.kind == "erratum":
            block = replace(block, blocks=tuple(each for each in block.blocks if not isinstance(each, Display | Table)))
        kept.append(block)
    return tuple(kept)


def has_solutions(blocks: Sequence[Block]) -> bool:
    """Whether a document has a worked solution, by itself or in a list or a quote."""
    return any(is_solution(block) or any(map(has_solutions, inner(block))) for block in with_solutions(blocks))


def is_solution(block: Block | None) -> TypeGuard[Quote]:
    """Whether a block is a worked solution."""
    return isinstance(block, Quote) and block.kind == "solution"


def _parts(blocks: Sequence[Block]) -> list[tuple[bool, list[Block]]]:
    """Return the blocks in runs, each with whether it is a solution from its heading on."""
    runs: list[tuple[bool, list[Block]]] = [(False, [])]
    level = 0  # of the solution's heading; 0 outside one
    for block in blocks:
        if isinstance(block, Heading):
            if opens_solution(block.parts):
                level = min(level, block.level) if level else block.level
                runs.append((True, []))
            elif level and block.level <= level:
                level = 0
                runs.append((False, []))
        runs[-1][1].append(block)
    return runs


def _height(blocks: Sequence[Block]) -> float:
    """Return the space that blocks take in handwriting (mm)."""
    return min(_HIGHEST, max(2 * _LINE, sum(_LINE * _lines(block) for block in blocks)))


def _lines(block: Block) -> float:
    if isinstance(block, Display):
        source = block.record.latex
        return 1.5 * max(1, len(block.lines)) + source.count("\\\\") / max(1, source.count("\\begin"))
    if isinstance(block, Paragraph):
        return 1 + len(plain(block.parts)) // _LONG
    if isinstance(block, Table):
        return 1.0 + len(block.rows)
    if isinstance(block, Quote):
        return sum(map(_lines, block.blocks)) if block.kind != "erratum" else 0.0
    if isinstance(block, Listing):
        return sum(_lines(each) for item in block.items for each in item)
    return 8.0 if isinstance(block, Picture) else 0.0
