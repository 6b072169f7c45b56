"""What a document shows as a whole, before its displays are checked one by one: which index names the reference, lengths, shorthands."""

from __future__ import annotations

from contextlib import suppress
from operator import methodcaller

from armproof.models.arm import Arm
from armproof.verification.check.limits import SECONDS_TO_DECIDE
from armproof.verification.document import Document
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.index_direction import TWO_SCRIPTS, shown_direction
from armproof.verification.equations.shorthands import Shorthand, own_shorthands, shorthands_in_row
from armproof.verification.errors import TooComplex
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.state import Stated
from armproof.verification.tables import TWIST
from armproof.verification.tables.arms import (
    Inference,
    entries_by_place,
    joints_used,
    letters_of_numbers,
    stated_lengths,
)


def shown_transforms(inferred: Inference) -> str:
    """Return which index names the reference, as what the arm was taken from shows it; else an empty text."""
    return str(inferred.arm.front.get("transforms", "")) if inferred.arm is not None else ""


def lacks_base(document: Document, arm: Arm | None, inferred: Inference) -> bool:
    """Whether the arm was taken from the links behind the first ones, of which the document speaks, too."""
    if inferred.arm is None or arm is None:
        return False
    first = arm.frames[0]
    return first.isdigit() and any(0 < joint <= int(first) for joint in joints_used(document.displays))


class Beforehand:
    """What a document shows beforehand, taken into the state in which its first display is checked.

    Attributes:
        direction: which index names the reference, and the line that shows it; else ("", 0).
        lengths: the values of lengths that stand beside their letters in DH tables.
        shorthands: those that the text says to be something else than they usually are.
    """

    def __init__(self, checker: ChainChecker, document: Document, inferred: Inference) -> None:
        self.checker = checker
        self.names, self.budget = checker.names, checker.exact.budget
        self.shown_transforms = shown_transforms(inferred)
        state = self.names.state
        self.direction = self._direction_in(document)
        state.transforms = self.shown_transforms or self.direction[0]
        self.lengths = self._lengths_in(document)
        state.configuration.update(self.lengths)
        self._name_entries(document, inferred)
        state.own_shorthands = self.shorthands = self._shorthands_in(document)

    def is_shown_by(self, document: Document) -> bool:
        """Whether a document, as it is now, shows the same."""
        return (
            self._direction_in(document) == self.direction
            and self._lengths_in(document) == self.lengths
            and self._shorthands_in(document) == self.shorthands
        )

    def _direction_in(self, document: Document) -> tuple[str, int]:
        """Return which index names the reference, as a document's first link matrix shows it, and its line; else ("", 0)."""
        if self.shown_transforms:
            return "", 0
        displays = [display for display in document.displays if TWO_SCRIPTS.search(normalise_unicode(display.latex))]
        try:
            with self.budget.of(SECONDS_TO_DECIDE):
                return (shown_direction(self.checker, displays) if displays else None) or ("", 0)
        except TooComplex:
            return "", 0

    def _lengths_in(self, document: Document) -> dict[str, Stated]:
        """Return the values that a document's DH tables give lengths beside their letters."""
        if not document.tables and not any(TWIST.search(display.latex) for display in document.displays):
            return {}
        with self.budget.of(SECONDS_TO_DECIDE):
            return stated_lengths(document, self.names, self.checker.exact)

    def _name_entries(self, document: Document, inferred: Inference) -> None:
        """Let a_2 and d_3 be the numbers of the rows of the table that the arm was taken from."""
        taken = inferred.arm
        if taken is None:
            return
        with self.budget.of(SECONDS_TO_DECIDE):
            entries = dict(entries_by_place(document, taken, self.names, self.checker.exact))
            for key, value in {**dict(letters_of_numbers(document, taken, self.names)), **entries}.items():
                self.names.define(key, methodcaller("rational", value), taken.line, by_table=True)

    def _shorthands_in(self, document: Document) -> frozenset[Shorthand]:
        """Return the shorthands that the text of a document says to be something else than they usually are."""
        said = [text for display in document.displays for text in (*display.said, *display.said_behind)]
        said += [equation for table in document.tables for row in table.rows for equation in shorthands_in_row(row)]
        with suppress(TooComplex), self.budget.of(SECONDS_TO_DECIDE):
            return frozenset(own_shorthands(self.checker.members, said)) if said else frozenset()
        return frozenset()
