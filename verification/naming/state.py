"""The state of a document: all that its displays change, as one value."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import product
from typing import Any

from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.document.heading import encloses, sections_around
from armproof.verification.document.model import Listing
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation
from armproof.verification.patterns import regex
from armproof.verification.verdict import SlipBefore

Key = tuple[str, int]  # a name and the line of the display that defines it
_OF_ITS_OWN = r"exerci[sc]e|exercício|ejercicio|esercizio|problem|problema|problème|aufgabe|example|exemple|beispiel|ejemplo|esempio"
_KINDS = rf"{_OF_ITS_OWN}|question|task|tâche|part|partie"
_NUMBER = r"\s*(?:n[°o]\.?\s*)?(?:\d+|[ivx]+|[a-z])\b"
_COUNTS = {word: count for count, word in enumerate(("two", "three", "four", "five", "six", "seven"), 2)}
_OF_LINKS = regex(
    rf"\b(\d|{'|'.join(_COUNTS)})[- ]*(?:links?|dofs?|r|joints?|axis|axes|segments?|degrees?[ -]of[ -]freedom)\b", re.I
)
_STEP = regex(
    r"\W*(?:step|paso|passo|[eé]tape|schritt|ad[ıi]m|krok|bước|шаг|步骤?|단계|sub-?(?:problem|task|step)|sous-?(?:problème|tâche)|teil(?:problem|aufgabe|schritt)|sub-?problema|sottoproblema)\W*\d",
    re.I,
)  # for one arm: "Step 3: solve the 2R arm", "Subproblem 2: the planar 2R arm"
EXERCISE = regex(rf"\W*(?:{_KINDS}){_NUMBER}", re.I)
WITH_ITS_ARM = regex(rf"\W*(?:{_OF_ITS_OWN}){_NUMBER}", re.I)


def undecided(doubt: Finding) -> Callable[[Any], Value]:
    """Return what evaluates a name of which nobody can tell what it means."""

    def evaluate(_: Any) -> Value:
        raise EvaluationError(doubt)

    return evaluate


def links_told(section: str) -> int | None:
    """Return how many links or joints the arm of a section has, as its heading, or one around it, says: "For 2 Link"."""
    for heading in (section, *sections_around(section)):
        if not _STEP.match(heading) and (found := _OF_LINKS.search(heading)):
            return _COUNTS.get(found[1].lower()) or int(found[1])
    return None


@dataclass(frozen=True)
class Definition:
    """A name's meaning: how to get its value in an algebra, and the display that gave it."""

    evaluate: Callable[[Any], Value]
    line: int = 0
    section: str = ""
    by_place: bool = False  # the entry or block of a matrix, not an equation of its own
    node: n.Node | None = None  # what an equation of its own says that it is
    exercise: str = ""  # empty in the document's head, which holds for all of them
    has_two_meanings: bool = False  # a second equation of its section says that it is something else
    in_text: bool = False  # what the text between displays says: a display that gives the name a meaning goes before
    is_last: bool = False  # the last of two meanings that its section gives
    is_doubted: bool = False  # its equation is unchecked, for a usual name that it equates to something else
    is_given: bool = False  # a usual name that is equated to a number: what is to be reached under this heading
    by_table: bool = False  # the number in a row of the DH table, which its author never named
    of_section: bool = (
        False  # a block of a matrix that is not the tool's: R and p of other sections may be those of others
    )
    has_ended: bool = False  # with its section
    root: n.Node | None = None  # what a name is whose square an equation gives
    whole: n.Node | None = None  # what has it as an entry, by its place

    @property
    def formula(self) -> n.Node | None:
        """The formula that an equation of its own says that it is, solved for it."""
        return self.node or self.root


@dataclass(frozen=True)
class Stated:
    """The value that a display gives a joint variable, its rate or a length."""

    node: n.Node
    value: float
    line: int = 0
    section: str = ""


@dataclass(frozen=True)
class OtherZero:
    """The zero that an equation gives a joint's marked letter, θ_1 = θ_1' + 90°, in half turns."""

    turn: Fraction
    key: str
    line: int


@dataclass(frozen=True)
class Told:
    """What the text between displays says of a configuration, or of lengths, under the heading at hand.

    Attributes:
        conditions: equations that it gives.
        earlier: the values stated before it, that it may leave as they are.
        in_words: whether it names a posture without an equation; begins_there: and begins with it.
        singular: whether it ends with "the singularities are", and whether these are all (`told_singularities.py`).
        velocities: equations that may give how fast the tool moves.
        has_shown: whether an equation holds at the rates that it gives.
        bounds: where it says that something is positive, or larger than something else, or in an interval.
        kind: of which joints it speaks alone, "revolute" or "prismatic".
        line: of the display behind it.
        is_direct: whether the display follows from them in the sentence that leads to it: "For ¤ and ¤ we get".
        bent: how the posture in words bends the inner joints, "stretched" or "folded", where it tells nothing else.
        holds: whether a display of numbers holds at the values that it gives.
        is_over: whether the conditions are those of a configuration that the text ends: "In general,".
        section, holds_below: under which heading it says so, and whether it holds under those below it: of lengths alone.
    """

    conditions: tuple[n.Chain, ...] = ()
    earlier: tuple[n.Chain, ...] = ()
    in_words: bool = False
    begins_there: bool = False
    singular: str = ""
    velocities: tuple[n.Chain, ...] = ()
    has_shown: bool = False
    bounds: tuple[n.Chain, ...] = ()
    kind: str = ""
    line: int = 0
    section: str = ""
    holds_below: bool = False
    is_direct: bool = False
    bent: str = ""
    holds: bool = False
    is_over: bool = False

    @property
    def standing(self) -> tuple[n.Chain, ...]:
        """The conditions, unless the text has ended their configuration."""
        return () if self.is_over else self.conditions


@dataclass(frozen=True)
class PrintedError:
    """A refuted equation, kept to recognise its consequences."""

    line: int
    key: str
    node: n.Node
    cells: dict[tuple[int, int], str]


@dataclass(frozen=True)
class OnABranch:
    """At which samples the solution for a joint holds that a display gives under a heading."""

    line: int
    section: str
    where: frozenset[int]


@dataclass
class NamedSigns:
    """The named signs of a document, each with the value that it has on the branch at hand."""

    values: dict[str, int] = field(default_factory=dict)
    read: set[str] = field(default_factory=set)  # those that an evaluation has met since this was emptied
    lines: dict[str, int] = field(default_factory=dict)  # of the displays that name them

    def value(self, key: str) -> int | None:
        """Return the value of a sign, or None for another name."""
        if key in self.values:
            self.read.add(key)
        return self.values.get(key)

    def name(self, key: str, line: int) -> None:
        """Take a name for a sign, as a display says."""
        self.values[key] = 1
        self.lines.setdefault(key, line)

    def copy(self) -> NamedSigns:
        """Return the signs as they are now."""
        return NamedSigns(self.values.copy(), self.read.copy(), self.lines.copy())

    def branches(self, several: bool = True) -> Iterator[int]:
        """Yield the sign of ± on every branch, the signs that have been met having their values on it."""
        if not several:
            yield 1
            return
        met = sorted(self.read)
        for signs in product((1, -1), repeat=len(met)):
            self.values.update(zip(met, signs, strict=True))
            yield from (1, -1)
        self.values.update(dict.fromkeys(met, 1))


@dataclass(frozen=True)
class JacobianRows:
    """The rows (from 1) in which a Jacobian is read: since which section, and whether a matrix printed there shows them.

    And its columns, where those of the last joints are left out because they are zero.
    """

    rows: tuple[int, ...]
    section: str = ""
    printed: bool = True
    columns: tuple[int, ...] | None = None


@dataclass
class DocumentState:
    """What the displays of a document have changed so far; two documents go on alike where it is equal.

    Attributes:
        transforms: which index of T^i_j names the reference, where a link matrix of the document shows it.
        angles: what the letter of a joint with an offset in the DH table means, "variable" or "table", once that is shown.
        zeros: joints → the zero from which a marked letter of theirs is counted.
        counts_anew: whether their letters are read without the marks.
        counts_anew_in: the heading under which an equation has shown that they are.
        section: the heading under which the display stands that is being checked.
        exercise: that of the exercise to which it belongs.
        apart: how many exercises that mostly have an arm of their own have begun.
        has_open_determinant: whether the last determinant that is given is not decided.
        subject: the first member of the last display: one that begins with a relation goes on about it.
        definitions: what names mean.
        inferred: names whose meaning the other side of an equation told.
        conventional: those of them that only convention binds.
        placed: names of blocks that are what convention says, as their place in a matrix showed → the line and the section of its display.
        own_shorthands: sines and cosines by their indices, c_{12}, that the text says to be something else than they usually are.
        other_sizes: usual names that are printed as a matrix of another size, each with what was said there.
        without_value: a name → the line and the section of the display that equates it to a formula of names without a value.
        awaited: a name without a value → the matrix of letters that it is equated to, its entries once it has one, and the line.
        of_tool: a name that awaits its value → the lines that hold where the letters of its matrix are of the tool's pose.
        printed: the rotation that a matrix printed last was, or that of the pose: its entries may be the r_ij behind it.
        entries_held: the rotations of which the r_ij of equations were that hold, None as their matrix says, with the lines of those.
        usual: name and heading under which an equation was exactly what convention says, and what that is.
        has_capital_entries: whether a matrix [R_{11} R_{12} …; …] has shown that R_{ij} are its entries, and no rotations.
        used, used_in_general: free letters, of the displays and of the general statements among them.
        adopted: letters that only a frame the document adds brings in: a tool's length.
        balanced: letter of torques that are said, or shown, to be J^T F, and its exercise → that product, where it is written.
        beyond: a frame the document adds → (on which of the arm's, name).
        configuration: joint variables, rates and lengths → the value that a display gave them.
        listed: the values that code gives under the heading at hand, and those that are worked out above.
        omega_is_first: whether the text says that a Jacobian of six rows begins with those of ω.
        elsewhere: the lines of displays that are of another point than the tool, or may be.
        limits_joints: whether the text says that joints do not turn all round.
        task_rows: the rows of J of the task that the text tells, none where it is not known which they are, None without a task.
        told: what the text between displays says: no display is judged there, but what holds there is not refuted.
        told_lengths: lengths → the value that the text between displays gave them last.
        given_last: joint variables and lengths → the value that a display or the text gave them last, under whatever heading.
        held: the definitions on which something rests that holds, each with the line of its display.
        compares_lengths: whether a display says which lengths are larger.
        comparisons: what displays, and the text between them, say so.
        rounded: names made of rounded numbers → to how many decimals.
        shown: the rows in which a Jacobian is read that only convention binds.
        tells_jacobian: whether a law that holds told that J is no transpose.
        signs: the named signs.
        branches: joints whose solution holds on a branch → where that is.
        errors: the refuted equations.
        slips: definitions, each with its line and what it says with the one slip mended that an equation needed.
        met: the line of a display that does not hold → all slips in definitions before with which it does, of the first few.
        mended: definitions, each with its line → the formula that it is taken for instead of the printed one, and its value.
        consulted: the definitions that evaluation has met since this was emptied, each with the line of its display.
        notation: how cosines, sums of angles, joints and lengths are written.
    """

    transforms: str = ""
    angles: str = ""
    zeros: dict[str, OtherZero] = field(default_factory=dict)
    counts_anew: bool = False
    counts_anew_in: str = "nowhere yet"
    section: str = ""
    exercise: str = ""
    apart: int = 0
    has_open_determinant: bool = False
    subject: n.Node | None = None
    definitions: dict[str, Definition] = field(default_factory=dict)
    inferred: dict[str, Quantity] = field(default_factory=dict)
    conventional: set[str] = field(default_factory=set)
    placed: dict[str, tuple[int, str]] = field(default_factory=dict)
    own_shorthands: frozenset[tuple[str, object]] = frozenset()
    other_sizes: dict[str, Finding] = field(default_factory=dict)
    awaited: dict[str, tuple[n.Node, int]] = field(default_factory=dict)
    without_value: dict[str, tuple[int, str]] = field(default_factory=dict)
    of_tool: dict[str, frozenset[int]] = field(default_factory=dict)
    printed: Quantity | None = None
    entries_held: dict[Quantity | None, frozenset[int]] = field(default_factory=dict)
    usual: dict[tuple[str, str], Quantity] = field(default_factory=dict)
    has_capital_entries: bool = False
    used: set[str] = field(default_factory=set)
    used_in_general: set[str] = field(default_factory=set)
    adopted: set[str] = field(default_factory=set)
    balanced: dict[tuple[str, str], n.Node | None] = field(default_factory=dict)
    beyond: dict[str, tuple[str, str]] = field(default_factory=dict)
    configuration: dict[str, Stated] = field(default_factory=dict)
    told: Told = field(default_factory=Told)
    told_lengths: dict[str, Stated] = field(default_factory=dict)
    given_last: dict[str, Stated] = field(default_factory=dict)
    held: set[tuple[str, int]] = field(default_factory=set)
    listed: tuple[Listing, ...] = ()
    omega_is_first: bool = False
    elsewhere: set[int] = field(default_factory=set)
    limits_joints: bool = False
    task_rows: tuple[int, ...] | None = None
    compares_lengths: bool = False
    comparisons: list[n.Chain] = field(default_factory=list)
    rounded: dict[str, int] = field(default_factory=dict)
    shown: dict[str, JacobianRows] = field(default_factory=dict)
    tells_jacobian: bool = False
    signs: NamedSigns = field(default_factory=NamedSigns)
    branches: dict[str, OnABranch] = field(default_factory=dict)
    consulted: set[tuple[str, int]] = field(default_factory=set)
    errors: list[PrintedError] = field(default_factory=list)
    slips: dict[Key, tuple[Finding, n.Node]] = field(default_factory=dict)
    met: dict[int, list[SlipBefore]] = field(default_factory=dict)
    mended: dict[Key, tuple[n.Node, Callable[[Any], Value]]] = field(default_factory=dict)
    notation: Notation = field(default_factory=Notation)

    @property
    def stated(self) -> dict[str, float]:
        """The values that displays gave joint variables, rates and lengths."""
        return {name: stated.value for name, stated in self.configuration.items()}

    def enter(self, section: str) -> None:
        """Go on under a heading, in a new exercise where it says so."""
        if section == self.section:
            return
        begun = self._begun(section)
        self._leave_blocks(section)
        self.section = section
        self.told = self.told if self.told.holds_below and encloses(self.told.section, section) else Told()
        own = next(filter(None, map(WITH_ITS_ARM.match, begun)), None)
        self.apart += own is not None and own[0] != self.exercise
        head = next(filter(None, map(EXERCISE.match, begun)), None)
        self.exercise = head[0] if head is not None else self.exercise

    def _begun(self, section: str) -> tuple[str, ...]:
        """Return a heading, and those around it that were not around the one before."""
        before = (self.section, *sections_around(self.section))
        return (section, *(each for each in sections_around(section) if each not in before))

    def _leave_blocks(self, section: str) -> None:
        """Let nothing be decided any more by the blocks of matrices of the section that ends; what is around a section holds in it."""
        for key, each in self.definitions.items():
            if each.of_section and not encloses(each.section, section) and not each.has_ended:
                doubt = say(Kind.OTHER_SECTION, name=key, line=each.line)
                self.definitions[key] = replace(each, evaluate=undecided(doubt), has_ended=True)

    def foreign(self) -> list[Key]:
        """Return the names consulted whose definitions stand in another exercise, each with its line."""
        return sorted((key, each.line) for key, each in self._met() if each.exercise not in ("", self.exercise))

    def from_text(self) -> list[str]:
        """Return the names consulted whose meaning the text between displays gave."""
        return sorted(key for key, each in self._met() if each.in_text)

    def from_table(self) -> list[str]:
        """Return the names consulted that stand for numbers of the DH table by their indices alone, and with which nothing has held."""
        return sorted(key for key, each in self._met() if each.by_table and (key, each.line) not in self.held)

    def doubted(self) -> list[Key]:
        """Return the names consulted whose definitions may be mistakes, each with its line."""
        return sorted(
            (key, each.line)
            for key, each in self._met()
            if each.is_doubted or (each.is_given and not encloses(each.section, self.section))
        )

    def given(self) -> list[Key]:
        """Return the usual names consulted that a display gives numbers, each with its line."""
        return sorted((key, each.line) for key, each in self._met() if each.is_given)

    def with_two_meanings(self) -> list[Key]:
        """Return the names consulted that have the last of two meanings, each with its line."""
        return sorted((key, each.line) for key, each in self._met() if each.is_last)

    def _met(self) -> set[tuple[str, Definition]]:
        """Return the names consulted that the document defines, each with its definition."""
        return {(key, self.definitions[key]) for key, _ in self.consulted if key in self.definitions}

    def forget_consulted(self) -> None:
        """Forget which definitions and signs were met: what follows is another equation."""
        self.consulted.clear()
        self.signs.read.clear()

    def infer_usual(self, key: str, quantity: Quantity) -> None:
        """Give a name a meaning that only convention binds."""
        self.inferred[key] = quantity
        self.conventional.add(key)

    def forget_usual(self, keys: Iterable[str]) -> None:
        """Take meanings back that only convention binds."""
        for key in keys:
            self.inferred.pop(key, None)
            self.conventional.discard(key)

    def compare(self, chain: n.Chain, lengths: Iterable[str]) -> None:
        """Remember a comparison if it is one of lengths: l_1 > l_2."""
        names = {below.key for below in n.names(chain)}
        if names and names <= set(lengths) and set(chain.relations) <= {"<", "≤", ">", "≥"}:
            self.comparisons.append(chain)

    def copy(self) -> DocumentState:
        """Return the state as it is now."""
        return DocumentState(
            **{name: value.copy() if hasattr(value, "copy") else value for name, value in vars(self).items()}
        )

    @contextmanager
    def unchanged(self) -> Iterator[DocumentState]:
        """Let nothing stay of what is tried within, errors or not; yield the state that is put back."""
        before = self.copy()
        try:
            yield before
        finally:
            self.become(before)

    def become(self, other: DocumentState) -> None:
        """Take over another state, which stays as it is: whoever holds this one goes on from there."""
        vars(self).update(vars(other.copy()))
