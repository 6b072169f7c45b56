"""What a function is to compute: a quantity as the front matter writes it, or a name such as {}^0T_4 or J."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import ArmproofError, Sentence
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.errors import DocumentError, ReadError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.functions.function_check import FunctionVerdict
from armproof.verification.functions.returned import fit, shape_words
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.quantities import implied_quantity, read_quantity

TOLERANCE = 1e-6  # of the entries, scaled by 1 + size


class QuestionError(ArmproofError):
    """A function cannot be checked for what is asked: no such quantity, no such arm, no function."""


@dataclass(frozen=True)
class Asked:
    """One quantity, and the words in which it was asked for."""

    label: str
    quantity: Quantity


def read_asked(arm: Arm, asked: Any) -> tuple[Asked, ...]:
    """Return the quantities asked for: one, or one for each item of a tuple or list.

    Args:
        asked: {"pose": 4}, {"jacobian": 4, "rows": [1, 2, 3]}, {"origin": 3, "component": "x"}, …, as in the front matter of
            a document; or a name: "{}^0T_4", "T^0_4", "J", "J_v", "p_4", "z_2".

    Raises:
        QuestionError: it is none of these, or the arm has no such frame.
    """
    items = list(asked) if isinstance(asked, tuple | list) else [asked]
    if not items:
        raise QuestionError("a function computes at least one quantity, none is named")
    return tuple(_read_one(arm, item) for item in items)


def _read_one(arm: Arm, asked: Any) -> Asked:
    if isinstance(asked, Quantity):
        return Asked(f"{asked.kind} {asked.frame}", asked)
    if isinstance(asked, str):
        return Asked(asked, _read_name(arm, asked))
    if isinstance(asked, Mapping):
        label = ", ".join(f"{key}: {value}" for key, value in asked.items())
        try:
            quantity = read_quantity(label, {key: _plain(value) for key, value in asked.items()}, arm)
        except DocumentError as error:
            raise QuestionError(str(error)) from None
        if not kind_of(quantity).of_joints:
            raise QuestionError("a {kind} is no quantity of an arm that its joint values decide; ask for a pose, {{pose: 1}}, or a Jacobian, {{jacobian: 1}}",
                kind=quantity.kind)  # fmt: skip
        return Asked(label, quantity)
    raise QuestionError("a quantity is a name such as 'T^0_4' or 'J', or a mapping such as {{'pose': 4}}, not {asked}",
        asked=f"{asked!r:.60}")  # fmt: skip


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple | range) else value


def _read_name(arm: Arm, text: str) -> Quantity:
    try:
        node = Reader().read_expression(text)
    except ReadError as error:
        raise QuestionError("the quantity '{text}' cannot be read: {reason}", text=text, reason=str(error)) from None
    while n.is_call(node, "name"):  # J(q)
        node = node.arguments[0]
    quantity = implied_quantity(node, arm, "upper") if isinstance(node, n.Name) else None
    if quantity is None:
        raise QuestionError("no quantity '{text}' on arm '{arm}'; a quantity is a transform T^i_j, a rotation R^i_j, an origin p_i, an axis z_i or a Jacobian J, J_v, J_omega, with the frames {frames}",
            text=text, arm=arm.name, frames=list(arm.frames))  # fmt: skip
    return quantity


@dataclass
class Part:
    """A quantity with its true and its obtained values, (N, rows, columns), at the probes.

    `mismatch` says what is wrong with the shape; `obtained` then has the shape that was returned. `elsewhere` holds the
    values at more configurations, where the probes alone did not decide.
    """

    number: int
    asked: Asked
    true: np.ndarray
    obtained: np.ndarray
    note: str = ""
    mismatch: Finding | None = None
    verdict: FunctionVerdict = FunctionVerdict.REFUTED
    findings: tuple[Finding, ...] = ()
    wrong: list[tuple[int, int]] = field(default_factory=list)
    elsewhere: Part | None = None
    q: np.ndarray | None = None

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the quantity."""
        return self.true.shape[1], self.true.shape[2]

    def place(self, row: int, column: int) -> tuple[int | None, int | None]:
        """Return an entry's row and column from 1, given from 0; none of them where the quantity is one number."""
        return (None, None) if self.asked.quantity.scalar else (row + 1, column + 1)


def read_part(number: int, asked: Asked, true: np.ndarray, returned: np.ndarray) -> Part:
    """Return the part of what was returned at N configurations, (N, …), each brought into the quantity's shape."""
    shape = true.shape[1:]
    fitted = [fit(values, shape) for values in returned]
    if any(one is None for one in fitted):
        wanted = Sentence("a number") if shape == (1, 1) else "×".join(map(str, shape))
        mismatch = say(Kind.RESULT_SIZE, printed=shape_words(returned[0]), correct=wanted)
        return Part(number, asked, true, returned, mismatch=mismatch)
    first = fitted[0]
    assert first is not None
    part = Part(number, asked, true, np.array([one.values for one in fitted if one is not None]), first.note)
    part.wrong = wrong_entries(part.obtained, true)
    return part


def scaled_errors(obtained: np.ndarray, true: np.ndarray) -> np.ndarray:
    """Return |obtained − true|/(1 + |true|), infinite where the function has no value."""
    with np.errstate(all="ignore"):
        errors = np.abs(obtained - true) / (1 + np.abs(true))
    return np.where(np.isfinite(errors), errors, np.inf)


def wrong_entries(obtained: np.ndarray, true: np.ndarray) -> list[tuple[int, int]]:
    """Return the places (from 0) of the entries that differ at any of N configurations."""
    places = np.argwhere((scaled_errors(obtained, true) > TOLERANCE).any(axis=0))
    return [(int(r), int(c)) for r, c in places]
