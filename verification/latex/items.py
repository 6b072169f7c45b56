"""The items of a juxtaposed run, one atom each with its scripts, and derivatives, whose marks ∂, d and δ are such items."""

from __future__ import annotations

import re
from collections.abc import Sequence as Seq
from dataclasses import dataclass, field
from itertools import pairwise

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.tokens import canonical_script

Script = tuple[str, str, tuple[int, int]]  # ("SUB" | "SUP" | "PRIME" | "DOT", text, span)

# what may stand above an operand and act on it: the spelling → the operator
OPERATORS = {"T": "T", "t": "T", "top": "T", "intercal": "T", "-1": "-1", "-T": "-T", "+": "+", "dagger": "+", "#": "+",
             "circ": "deg", "o": "deg"}  # fmt: skip


@dataclass
class Item:
    """One atom of a run with its scripts, before it is known what it is applied to."""

    kind: str  # letter, function, partial, number, list, braces, operator, node
    node: n.Node | None
    start: int
    end: int
    base: str = ""
    scripts: list[Script] = field(default_factory=list)
    pre: list[Script] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Differential(n.Node):
    """∂x, or ∂ alone, on its way into a Derivative."""

    operand: n.Node | None
    order: int = 1


@dataclass(frozen=True, slots=True)
class DerivativeOperator(n.Node):
    """∂/∂x, waiting for its operand."""

    variable: n.Node
    order: int = 1


def node_item(node: n.Node) -> Item:
    """Return an item that needs nothing of its neighbours."""
    return Item("node", node, *node.span)


def scripts_before(name: n.Name, span: tuple[int, int]) -> list[Script]:
    """Return the pre-scripts of a name, as an item carries them."""
    found: list[Script] = []
    if name.pre_sub:
        found.append(("SUB", name.pre_sub, span))
    if name.pre_sup:
        found.append(("SUP", name.pre_sup, span))
    return found


def span_of(items: Seq[n.Node]) -> tuple[int, int]:
    """Return the place of a row of nodes."""
    return (items[0].span[0], items[-1].span[1])


def argument_end(text: str, end: int) -> int:
    """The end of a command whose last argument's content ends at `end`: behind its closing brace."""
    found = re.compile(r"\s*\}").match(text, end)
    return found.end() if found else end


def attach_trailing(items: list[Item]) -> list[Item]:
    """Give scripts that an empty group sets off (R{}^T) to the item before."""
    result: list[Item] = []
    for item in items:
        if item.kind == "trailing":
            result[-1].scripts.extend(item.scripts)
            result[-1].end = item.end
        else:
            result.append(item)
    return result


def reassociate(items: list[Item]) -> list[Item]:
    """Glued pre-scripts: in ^0_1T^1_2T and ^0T_1^1T_2 what follows a T that has its own belongs to the next T."""
    for here, following in pairwise(items):
        if not here.pre or here.kind != "letter" or following.kind != "letter" or following.pre:
            continue
        kinds = {kind for kind, _, _ in here.pre}
        keep: list[Script] = []
        move: list[Script] = []
        for script in here.scripts:
            index_like = canonical_script(script[1]) not in OPERATORS and script[0] in ("SUB", "SUP")
            own = script[0] not in kinds and not any(kept[0] == script[0] for kept in keep) and len(kinds) != 2
            if index_like and (move or not own or (script[0] == "SUP")):
                move.append(script)
            else:
                keep.append(script)
        if move:
            here.scripts, following.pre = keep, move
            here.end = keep[-1][2][1] if keep else move[0][2][0]
            following.start = move[0][2][0]
    return items


def partial_derivative(above: Differential, below: Differential, span: tuple[int, int]) -> n.Node:
    """Return ∂f/∂x, or ∂/∂x still waiting for its operand."""
    if below.operand is None:
        raise ReadError(say(Kind.DERIVATIVE_BY_NOTHING), below.span[0])
    variable, order = below.operand, above.order
    if order > 1:
        if not (
            isinstance(variable, n.Power)
            and isinstance(variable.exponent, n.Number)
            and variable.exponent.value == order
        ):
            raise ReadError(say(Kind.HIGHER_DERIVATIVE), below.span[0])
        variable = variable.base
    if above.operand is None:
        return DerivativeOperator(variable, order, span=span)
    return n.Derivative(above.operand, variable, order, span=span)


def total_derivative(above: n.Node, below: n.Node, span: tuple[int, int]) -> n.Node | None:
    """dx/dθ and d/dt(…), written with letters (δ is also met for ∂)."""
    below_run = below.factors if isinstance(below, n.Product) else ()
    if len(below_run) != 2 or not isinstance(below_run[0], n.Name) or below_run[0].key not in ("d", "delta"):
        return None
    mark = below_run[0].key
    if isinstance(above, n.Name) and above.key == mark:
        return DerivativeOperator(below_run[1], span=span)
    if isinstance(above, n.Product) and isinstance(above.factors[0], n.Name) and above.factors[0].key == mark:
        operand = (
            above.factors[1]
            if len(above.factors) == 2
            else n.Product(above.factors[1:], above.operators[1:], span=above.span)
        )
        return n.Derivative(operand, below_run[1], span=span)
    return None
