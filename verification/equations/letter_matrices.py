"""Matrices of letters beside a name that has no value yet: in R_t = [r_11 …] the letters are the entries of what R_t is said to be later."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import combinations, permutations
from typing import Any

from armproof.models.arm import Arm
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.given_values import keys_alone, names_alone
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.conventions import ENTRIES, ENTRY, is_entry
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

_ROTATION = regex(r"(?:\{\}(?:\^\w+)?(?:_\w+)?)?R(?![a-z])")
_TARGETS = frozenset(["d", "D", "des", "desired", "target", "goal", "ref"])
FEWEST_SHOWN = 2  # equations that show of which rotation r_{ij} are
POSE = 4  # rows and columns
FEWEST_LETTERS = 4  # of a matrix of letters: those of a rotation, and no column of lengths


def awaited(members: Sequence[Member]) -> tuple[str, n.Node] | None:
    """Return a name without a value that is equated to a matrix of a rotation's letters, and that matrix; else None."""
    for name, letters in _of_letters(members):
        if isinstance(name.problem, UnboundName):
            return str(bare_key(name.node)), letters.node
    return None


def target_pose(members: Sequence[Member], names: Names) -> tuple[str, Quantity] | None:
    """Return the name of the pose that is to be reached, {}^0_5T_D beside a matrix of letters, and that of the arm's tool; else None."""
    for name, _ in _of_letters(members):
        node = n.bare(name.node)
        if names.arm is None or not isinstance(name.problem, UnboundName) or not isinstance(node, n.Name):
            continue
        if node.sub not in _TARGETS or node.sup or names.is_free(node):
            continue
        plain = replace(node, sub="")
        known = names.quantity(plain)
        ends = (names.arm.frames[0], names.arm.frames[-1])
        for each in (known,) if known is not None else names.usual(plain):
            if each.kind == "pose" and (each.reference, each.frame) == ends and each.rows is None:
                return node.key, each
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
    return any(each.kind == "pose" for each in names.usual(name))


def _entries_in(chain: n.Chain) -> dict[str, n.Name]:
    return {each.key: each for m in chain.members for each in n.names(m) if is_entry(each)}


def entries_elsewhere(names: Names, chain: n.Chain) -> Iterator[dict[str, Quantity]]:
    """Yield what the r_{ij} of a chain may be of: the rotation that was printed last, or that of a wrist of three joints."""
    found = _entries_in(chain)
    if names.arm is None or not found:
        return
    frames, is_taken = names.arm.frames, found.keys() & names.state.inferred.keys()
    tool = [Quantity("rotation", frames[-1], frames[0])] if is_taken else []  # as before an equation was of another
    for rotation in dict.fromkeys((*filter(None, [names.state.printed]), *_of_wrist(names.arm), *tool)):
        places = {key: ((int(each.sub[0]),), (int(each.sub[-1]),)) for key, each in found.items()}
        yield {key: replace(rotation, rows=r, columns=c, scalar=True) for key, (r, c) in places.items()}


def with_small_letters(chain: n.Chain) -> n.Chain | None:
    """Return a chain with r_{13} for R_{13}, which is an entry where a rotation makes no sense; None where it has none."""
    found: dict[int, n.Node] = {}
    for each in (below for member in chain.members for below in n.names(member)):
        small = n.Name(ENTRY, each.sub, text=each.text, span=each.span)
        if each in (n.Name("R", each.sub), n.Name("R", each.sub, "2")) and is_entry(small):  # R_{13}^2 is its square
            found[id(each)] = n.Power(small, n.Number(Fraction(2), "2"), span=each.span) if each.sup else small
    return replace(chain, members=tuple(n.substitute_each(m, found) for m in chain.members)) if found else None


def with_entries_of_capitals(chain: n.Chain, names: Names) -> n.Chain:
    """Return a chain with r_{ij} for R_{ij} where a matrix, in it or before, has these in their places: they are no rotations."""
    is_shown = any(_has_capitals_in_place(below) for member in chain.members for below in n.walk(member))
    names.state.has_capital_entries |= is_shown
    if not (is_shown or (names.state.has_capital_entries and not _holds_a_matrix(chain))):
        return chain
    return with_small_letters(chain) or chain


def with_last_row(chain: n.Chain) -> n.Chain:
    """Return a chain with the row [0 0 0 1] below a matrix of a pose's letters that is printed without it."""
    found: dict[int, n.Node] = {}
    for matrix in filter(_is_upper_part, map(n.bare, chain.members)):
        assert isinstance(matrix, n.Matrix)
        zero, one = (n.Number(Fraction(digit), str(digit)) for digit in (0, 1))
        found[id(matrix)] = replace(matrix, rows=(*matrix.rows, (zero, zero, zero, one)))
    return replace(chain, members=tuple(n.substitute_each(m, found) for m in chain.members)) if found else chain


def _is_upper_part(node: n.Node) -> bool:
    """Whether a tree is three rows of four letters, most of them those of a rotation."""
    rows = written_rows(node) if isinstance(node, n.Matrix) else ()
    is_whole = [len(row) for row in rows or ()] == [POSE] * (POSE - 1)
    names = names_alone(node) if is_whole else ()
    return sum(each.base in ENTRIES and bool(each.sub) for each in names) >= FEWEST_LETTERS


def are_of_no_other(names: Names, members: Members, chain: n.Chain, readings: Iterable[Mapping[str, Quantity]]) -> bool:
    """Whether r_{ij} = f(q) is of the matrix that gave it its meaning: f moves with joints that turn none of the other rotations.

    Nor is f the entry of a rotation between any two frames.
    """
    arm, sides = names.arm, permutations(chain.members) if len(chain.members) == 2 else ()
    entry, other = next(((a, b) for a, b in sides if isinstance(a, n.Name) and is_entry(a)), (None, None))
    if arm is None or entry is None or other is None:
        return False
    made, value = names.state.definitions.get(entry.key), members.evaluate(other).value
    if made is None or not made.by_place or not isinstance(value, Scalar):
        return False
    joints = symbols_in([value]) & {*names.joints}
    wholes = (members.exact.quantity(_whole(entries[entry.key])) for entries in readings)
    if any(joints <= symbols_in(whole.cells) for whole in wholes):
        return False
    rows, columns = (int(entry.sub[0]),), (int(entry.sub[-1]),)
    turns = (
        Quantity("rotation", last, first, rows, columns, scalar=True) for first, last in combinations(arm.frames, 2)
    )
    return all(_differ(members.exact.quantity(each), value) for each in turns)


def _differ(entry: Value, value: Scalar) -> bool:
    return isinstance(entry, Scalar) and not (entry - value).normal().is_zero()


def _has_capitals_in_place(node: n.Node) -> bool:
    """Whether R_{ij} stands in row i and column j of a matrix, as most of its cells do."""
    cells = written_rows(node) if isinstance(node, n.Matrix) else ()
    places = [(n.bare(cell), f"{i}{j}") for i, row in enumerate(cells or (), 1) for j, cell in enumerate(row, 1)]
    return sum(cell == n.Name("R", place) for cell, place in places) >= FEWEST_LETTERS


def _holds_a_matrix(chain: n.Chain) -> bool:
    return any(isinstance(below, n.Matrix) for member in chain.members for below in n.walk(member))


def _of_wrist(arm: Arm) -> list[Quantity]:
    """Return the rotation that the last three of six joints or more make, seen from before them; rows behind them are of a tool."""
    rows = arm.dh.rows if arm.dh is not None else ()
    of_tool = next((k for k, row in enumerate(reversed(rows)) if row.kind != "fixed"), 0)
    for frames, behind in ((numbered_frames(arm), 0), (arm.frames, of_tool)):
        if len(arm.joints) == len(frames) - 1 - behind >= 6:
            return [Quantity("rotation", frames[-1], frames[-4 - behind])]
    return []


def of_defined_rotation(names: Names, chain: n.Chain, algebra: Any, line: int) -> Callable[[], None] | None:
    """Return what lets the r_{ij} of a chain be entries of the rotation that a document without an arm gave last; None without one."""
    found = _entries_in(chain)
    if not found or found.keys() & names.state.definitions.keys() or any(map(keys_alone, chain.members)):
        return None  # R = [r_{ij}] is no claim
    angles = {b.key for m in chain.members for b in n.names(m)} - found.keys()
    for key, definition in reversed(names.state.definitions.items()):
        with suppress(EvaluationError):
            value = definition.evaluate(algebra) if _ROTATION.match(key) else None
            if isinstance(value, Matrix) and value.shape == (3, 3):
                return partial(_define_entries, names, key, tuple(found.values()), angles, line)
    return None


def _define_entries(names: Names, rotation: str, entries: Iterable[n.Name], angles: Set[str], line: int) -> None:
    names.used.update(angles)  # none of them is a new name for what stands beside it
    for entry in entries:
        row, column = int(entry.sub[0]) - 1, int(entry.sub[-1]) - 1
        names.define(entry.key, partial(_entry, names, rotation, row, column), line, by_place=True)


def _entry(names: Names, rotation: str, row: int, column: int, algebra: Any) -> Value:
    return names.defined_value(rotation, algebra).rows[row][column]


def hold_entries(names: Names, entries: Mapping[str, Quantity], line: int) -> None:
    """Remember of which rotation the r_{ij} of an equation were that holds."""
    for rotation in {_whole(each) for each in entries.values()}:
        _hold(names, rotation, line)


def entries_before(names: Names, readings: Iterable[Iterable[str]]) -> dict[str, int]:
    """Return the r_{ij} of a chain, where an equation before was of such of another rotation, each with the line of the first."""
    lines = frozenset[int]().union(*names.state.entries_held.values())
    return {key: min(lines) for entries in readings for key in entries} if lines else {}


def hold_as_defined(names: Names, chain: n.Chain, line: int) -> None:
    """Remember that an equation holds with its r_{ij} as a matrix gave them their meaning."""
    if _lines_of(names, _entries_in(chain)):
        _hold(names, None, line)


def _hold(names: Names, rotation: Quantity | None, line: int) -> None:
    names.state.entries_held[rotation] = names.state.entries_held.get(rotation, frozenset()) | {line}


def is_shown_to_be(names: Names, entries: Mapping[str, Quantity]) -> bool:
    """Whether r_{ij} are of the one rotation of which equations behind the matrix that gave them their meaning show them to be."""
    return {_whole(each) for each in entries.values()} == _shown(names, entries)


def is_shown_as_defined(names: Names, chain: n.Chain) -> bool:
    """Whether equations behind the matrix that gave r_{ij} their meaning show that they have it."""
    return _shown(names, _entries_in(chain)) == {None}


def _shown(names: Names, entries: Iterable[str]) -> set[Quantity | None]:
    """Return the rotations of which equations behind the matrix of r_{ij} show these to be; nothing where too few do."""
    begun = max(_lines_of(names, entries), default=0)
    behind = {rotation: sum(line > begun for line in lines) for rotation, lines in names.state.entries_held.items()}
    shown = {rotation: count for rotation, count in behind.items() if count}
    return {*shown} if sum(shown.values()) >= FEWEST_SHOWN else set()


def _lines_of(names: Names, entries: Iterable[str]) -> list[int]:
    """Return the lines of the matrices that gave r_{ij} their meaning."""
    made = names.state.definitions
    return [made[key].line for key in entries if key in made and made[key].by_place]


def _whole(entry: Quantity) -> Quantity:
    return replace(entry, rows=None, columns=None, scalar=False)


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


def are_shown_of_tool(names: Names, met: Mapping[str, n.Node], line: int) -> bool:
    """Remember that an equation holds with the letters of matrices as entries of the tool's pose; say whether two do now."""
    shown = names.state.of_tool
    for key in met:
        shown[key] = shown.get(key, frozenset()) | {line}
    are_shown = all(len(shown[key]) >= FEWEST_SHOWN for key in met)
    for key in met if are_shown else ():
        del names.state.awaited[key]
    return are_shown


def is_of_pose(letters: n.Node) -> bool:
    """Whether a matrix of letters is a whole pose: a rotation alone may be that of any frame."""
    return [len(row) for row in written_rows(letters) or ()] == [POSE] * POSE


def name_of_tool(names: Names) -> n.Name:
    """Return a name of the tool's pose."""
    assert names.arm is not None
    return n.Name("T", names.arm.frames[-1], pre_sup=names.arm.frames[0])


def forget_letters_of(names: Names, matrices: Iterable[n.Node]) -> None:
    """Take back what the letters of matrices have meant so far."""
    for letters in matrices:
        forget_letters(names, letters)


def forget_letters(names: Names, letters: n.Node) -> None:
    """Take back what the letters of a matrix have meant so far, by convention or by another matrix."""
    keys = keys_alone(letters)
    names.forget(keys)
    names.state.usual = {place: each for place, each in names.state.usual.items() if place[0] not in keys}
