"""Names of blocks: R and p in T = [R, p; 0, 1] are what stands in their places, and in another matrix or section something else."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace

from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict


def heed_places(names: Names, members: Sequence[Member], settled: Set[str], line: int) -> None:
    """Remember the names of blocks that are what convention says, as their places in a matrix show."""
    state = names.state
    cells = (bare_key(cell) for each in members for row in written_rows(each.node) for cell in row)
    for key in {key for key in cells if key is not None and key not in settled}:
        if key in state.inferred and key not in state.conventional and not state.inferred[key].scalar:
            state.placed[key] = line, state.section


def left_open_for_places(names: Names, outcome: Outcome, placed: Mapping[str, tuple[int, str]]) -> Outcome:
    """Leave open what does not fit with what the places in another matrix told of a name; nobody knows any more what it is."""
    letters = _placed_before(outcome) & placed.keys()
    if not letters:
        return outcome
    first = min(letters)
    line, section = placed[first]
    names.forget(letters)
    kind = Kind.SECOND_MEANING if section in ("", names.state.section) else Kind.OTHER_SECTION
    names.leave_unknown(letters, line, kind)
    return outcome.left_open(say(kind, name=first, line=line))


def forget_ended(names: Names, chain: n.Chain) -> dict[str, int]:
    """Forget what blocks of another section are that a chain is about: they get a meaning anew. Return their lines."""
    made = names.state.definitions
    cells = [cell for member in chain.members for row in written_rows(member) for cell in row]
    about = {key for node in (chain.members[0], *cells) if (key := bare_key(node)) is not None}
    ended = {key: made[key].line for key in about & made.keys() if made[key].has_ended}
    names.forget(ended)
    return ended


def left_open_for_section(names: Names, outcome: Outcome, ended: Mapping[str, int]) -> Outcome:
    """Leave open what is not so, of names that are blocks in another section: this one may be a part of that."""
    if outcome.verdict is not Verdict.REFUTED:
        return outcome
    first = min(ended)
    names.leave_unknown(ended, ended[first], Kind.OTHER_SECTION)
    return outcome.left_open(say(Kind.OTHER_SECTION, name=first, line=ended[first]))


def keep_printed(names: Names, outcome: Outcome) -> None:
    """Let the block of a matrix that is printed once more alone, R = […], be a name like others: it has its meaning in later sections, too."""
    if outcome.verdict is not Verdict.PROVED:
        return
    made = names.state.definitions
    for key in {bare_key(node) for node in outcome.nodes} & made.keys():
        if key is not None and made[key].of_section and not made[key].has_ended:
            made[key] = replace(made[key], of_section=False)


def _placed_before(outcome: Outcome) -> frozenset[str]:
    """Return the names of blocks that do not fit: T_2^0 = [R, p; 0, 1] behind T_1^0 = [R, p; 0, 1], a pattern or a mistake."""
    size = next((matrix.shape for matrix in outcome.matrices), (0, 1))
    if outcome.verdict is not Verdict.REFUTED or size[1] == 1:
        return frozenset()
    return frozenset(key for node in outcome.nodes for key in _pattern(node, size[0]))


def _pattern(node: n.Node, height: int) -> Iterator[str]:
    """Yield the names of a matrix of less than so many rows, that holds nothing but names and numbers."""
    cells = [bare(cell) for row in written_rows(node) for cell in row] if len(written_rows(node)) < height else []
    if all(isinstance(cell, n.Name | n.Number) for cell in cells):
        yield from (key for cell in cells if (key := bare_key(cell)) is not None)
