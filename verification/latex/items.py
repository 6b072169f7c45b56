"""The items of a juxtaposed run, one atom each with its scripts, and derivatives, whose marks ∂, d and δ are such items."""

from __future__ import annotations

from dataclasses import dataclass, field

from armproof.verification.latex import nodes as n

Script = tuple[str, str, tuple[int, int]]  # ("SUB" | "SUP" | "PRIME" | "DOT", text, span)

# what may stand above an operand and act on it: the spelling → the operator
OPERATORS = {"T": "T", "t": "T", "top": "T", "intercal": "T", "-1": "-1", "-T": "-T", "+": "+", "-": "-", "dagger": "+", "#": "+",
             "circ": "deg", "o": "deg", "cm": "cm", "mm": "mm"}  # fmt: skip


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
