"""What a function is to compute: a quantity as the front matter writes it, or a name such as {}^0T_4 or J."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from armproof.models.arm import Arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import DocumentError, ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.quantities import implied_quantity, read_quantity


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
        if quantity.kind == "link":
            raise QuestionError("a general link matrix is no quantity of an arm; ask for a pose, {pose: 1}")
        return Asked(label, quantity)
    raise QuestionError(
        f"a quantity is a name such as 'T^0_4' or 'J', or a mapping such as {{'pose': 4}}, not {asked!r:.60}"
    )


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple | range) else value


def _read_name(arm: Arm, text: str) -> Quantity:
    try:
        node = Reader().read_expression(text)
    except ReadError as error:
        raise QuestionError(f"the quantity '{text}' cannot be read: {error}") from None
    while isinstance(node, n.Call) and node.function == "name":  # J(q)
        node = node.arguments[0]
    quantity = implied_quantity(node, arm, "upper") if isinstance(node, n.Name) else None
    if quantity is None:
        raise QuestionError(
            f"no quantity '{text}' on arm '{arm.name}'; a quantity is a transform T^i_j, a rotation R^i_j, an origin p_i, "
            f"an axis z_i or a Jacobian J, J_v, J_omega, with the frames {', '.join(arm.frames)}"
        )
    return quantity
