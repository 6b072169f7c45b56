"""Matrices of letters beside a name that has no value yet: in R_t = [r_11 …] the letters are the entries of what R_t is said to be later."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from armproof.models.arm import Arm
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.given_values import keys_alone, names_alone
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.errors import UnboundName
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.conventions import ENTRIES, ENTRY, conventional, is_entry
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


def stale(members: Sequence[Member], names: Names) -> n.Node | None:
    """Return a matrix of letters whose meaning is not known any more, beside a name of the arm's; else None."""
    pairs = (
        letters.node
        for name, letters in _of_letters(members)
        if letters.problem is not None and (name.known or _is_usually_a_pose(name.node, names))
    )
    return next(pairs, None)


def _is_usually_a_pose(node: n.Node, names: Names) -> bool:
    """Whether a name without a value is that of a pose by convention, as T_6 is."""
    name = n.bare(node)
    if names.arm is None or not isinstance(name, n.Name) or not names.is_open(name):
        return False
    return any(each.kind == "pose" for each in conventional(name, names.arm, names.transforms))


def entries_elsewhere(names: Names, chain: n.Chain) -> Iterator[dict[str, Quantity]]:
    """Yield what the r_{ij} of a chain may be of: the rotation that was printed last, or that of a wrist of three joints."""
    found = {each.key: each for m in chain.members for each in n.walk(m) if isinstance(each, n.Name) and is_entry(each)}
    if names.arm is None or not found:
        return
    wrist = _of_wrist(names.arm)
    for rotation in dict.fromkeys((*filter(None, [names.state.printed]), *wrist)):
        places = {key: ((int(each.sub[0]),), (int(each.sub[-1]),)) for key, each in found.items()}
        yield {key: replace(rotation, rows=r, columns=c, scalar=True) for key, (r, c) in places.items()}


def with_small_letters(chain: n.Chain) -> n.Chain | None:
    """Return a chain with r_{13} for R_{13}, which is an entry where a rotation makes no sense; None where it has none."""
    found: dict[int, n.Node] = {}
    for each in (below for member in chain.members for below in n.walk(member) if isinstance(below, n.Name)):
        small = n.Name(ENTRY, each.sub, text=each.text, span=each.span)
        if each in (n.Name("R", each.sub), n.Name("R", each.sub, "2")) and is_entry(small):  # R_{13}^2 is its square
            found[id(each)] = n.Power(small, n.Number(Fraction(2), "2"), span=each.span) if each.sup else small
    return replace(chain, members=tuple(n.substitute_each(m, found) for m in chain.members)) if found else None


def _of_wrist(arm: Arm) -> list[Quantity]:
    """Return the rotation that the last three of six joints or more make, seen from before them; rows behind them are of a tool."""
    rows = arm.dh.rows if arm.dh is not None else ()
    of_tool = next((k for k, row in enumerate(reversed(rows)) if row.kind != "fixed"), 0)
    for frames, behind in ((numbered_frames(arm), 0), (arm.frames, of_tool)):
        if len(arm.joints) == len(frames) - 1 - behind >= 6:
            return [Quantity("rotation", frames[-1], frames[-4 - behind])]
    return []


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
