"""The state of a document: all that its displays change, as one value."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation
from armproof.verification.naming.signs import NamedSigns


@dataclass(frozen=True)
class Definition:
    """A name's meaning: how to get its value in an algebra, and the display that gave it."""

    evaluate: Callable[[Any], Value]
    line: int = 0
    section: str = ""
    by_place: bool = False  # the entry or block of a matrix, not an equation of its own


@dataclass(frozen=True)
class PrintedError:
    """A refuted equation, kept to recognise its consequences."""

    line: int
    key: str
    node: n.Node
    cells: dict[tuple[int, int], str]


@dataclass
class DocumentState:
    """What the displays of a document have changed so far; two documents go on alike where it is equal.

    Attributes:
        section: the heading under which the display stands that is being checked.
        subject: the first member of the last display: one that begins with a relation goes on about it.
        definitions: what names mean.
        inferred: names whose meaning the other side of an equation told.
        used, used_in_general: free letters, of the displays and of the general statements among them.
        adopted: letters that only a frame the document adds brings in: a tool's length.
        beyond: a frame the document adds → (on which of the arm's, name).
        configuration: joint variables and lengths → the value that a display gave them.
        compares_lengths: whether a display says which lengths are larger.
        rounded: names made of rounded numbers → to how many decimals.
        shown: the rows (from 1) in which a Jacobian was printed.
        signs: the named signs.
        errors: the refuted equations.
        consulted: the definitions that evaluation has met since this was emptied, each with the line of its display.
        notation: how cosines, sums of angles, joints and lengths are written.
    """

    section: str = ""
    subject: n.Node | None = None
    definitions: dict[str, Definition] = field(default_factory=dict)
    inferred: dict[str, Quantity] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)
    used_in_general: set[str] = field(default_factory=set)
    adopted: set[str] = field(default_factory=set)
    beyond: dict[str, tuple[str, str]] = field(default_factory=dict)
    configuration: dict[str, float] = field(default_factory=dict)
    compares_lengths: bool = False
    rounded: dict[str, int] = field(default_factory=dict)
    shown: dict[str, tuple[int, ...]] = field(default_factory=dict)
    signs: NamedSigns = field(default_factory=NamedSigns)
    consulted: set[tuple[str, int]] = field(default_factory=set)
    errors: list[PrintedError] = field(default_factory=list)
    notation: Notation = field(default_factory=Notation)

    def copy(self) -> DocumentState:
        """Return the state as it is now."""
        return DocumentState(
            **{name: value.copy() if hasattr(value, "copy") else value for name, value in vars(self).items()}
        )

    def become(self, other: DocumentState) -> None:
        """Take over another state, which stays as it is: whoever holds this one goes on from there."""
        vars(self).update(vars(other.copy()))
