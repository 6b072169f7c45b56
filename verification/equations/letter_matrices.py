"""Matrices of letters beside a name that has no value yet: in R_t = [r_11 …] the letters are the entries of what R_t is said to be later."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.given_values import keys_alone, names_alone
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.errors import UnboundName
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.conventions import ENTRIES, is_entry
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.verdict import Verdict

FEWEST_LETTERS = 4  # of a matrix of letters: those of a rotation, and no column of lengths


def awaited(members: Sequence[Member]) -> tuple[str, n.Node] | None:
    """Return a name without a value that is equated to a matrix of a rotation's letters, and that matrix; else None."""
    for name, letters in _of_letters(members):
        if isinstance(name.problem, UnboundName):
            return str(bare_key(name.node)), letters.node
    return None


def stale(members: Sequence[Member]) -> n.Node | None:
    """Return a matrix of letters whose meaning is not known any more, beside a name with a value; else None."""
    pairs = (letters.node for name, letters in _of_letters(members) if name.known and letters.problem is not None)
    return next(pairs, None)


def entries_elsewhere(names: Names, chain: n.Chain) -> Iterator[dict[str, Quantity]]:
    """Yield what the r_{ij} of a chain may be of: the rotation that was printed last, or that of a wrist of three joints."""
    found = {each.key: each for m in chain.members for each in n.walk(m) if isinstance(each, n.Name) and is_entry(each)}
    if names.arm is None or not found:
        return
    frames = numbered_frames(names.arm)
    wrist = [Quantity("rotation", frames[-1], frames[-4])] if len(names.arm.joints) == len(frames) - 1 >= 6 else []
    for rotation in dict.fromkeys((*filter(None, [names.state.printed]), *wrist)):
        places = {key: ((int(each.sub[0]),), (int(each.sub[-1]),)) for key, each in found.items()}
        yield {key: replace(rotation, rows=r, columns=c, scalar=True) for key, (r, c) in places.items()}


def take_entries(names: Names, entries: Mapping[str, Quantity]) -> None:
    """Let r_{ij} be entries of a rotation."""
    names.forget(entries)
    names.state.inferred.update(entries)


def _of_letters(members: Sequence[Member]) -> Iterator[tuple[Member, Member]]:
    """Yield the name that stands alone, and the matrix of a rotation's letters that it is equated to."""
    for name, letters in (members, members[::-1]) if len(members) == 2 else ():
        entries = {each.key for each in names_alone(letters.node) if each.base in ENTRIES and each.sub}
        if bare_key(name.node) is not None and len(entries) >= FEWEST_LETTERS:
            yield name, letters


def await_value(names: Names, key: str, letters: n.Node, line: int) -> Outcome:
    """Let letters mean what stands in their places of a name from here on, which is not known yet."""
    keys = keys_alone(letters)
    forget_letters(names, letters)
    names.leave_unknown(keys, line)
    names.state.awaited[key] = letters, line
    return Outcome(Verdict.DEFINED, (say(Kind.DEFINES_ENTRIES, names=sorted(keys)),), defines=tuple(sorted(keys)))


def forget_letters(names: Names, letters: n.Node) -> None:
    """Take back what the letters of a matrix have meant so far, by convention or by another matrix."""
    keys = keys_alone(letters)
    names.forget(keys)
    names.state.usual = {place: each for place, each in names.state.usual.items() if place[0] not in keys}
