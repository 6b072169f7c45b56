"""The operations of a graph's nodes: how many nodes each is made of, how NumPy does it, and what may not come near zero."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

TWO_PI = 2.0 * np.pi
Array = np.ndarray


@dataclass(frozen=True)
class Operation:
    """What a program does for a node.

    Attributes:
        run: takes the operands, the target, and then a row of scratch if it needs one; it may write the target only when it
            needs the operands no more, since the target may be the row of one.
        arity: the number of nodes that it is made of.
        has_number: whether its last operand is a number.
        has_scratch: whether it takes a row of scratch.
        guarded: what may not come near zero.
    """

    run: Callable[..., Any]
    arity: int
    has_number: bool = False
    has_scratch: bool = False
    guarded: Literal["", "left", "right", "result"] = ""


def _hypot(left: Array, right: Array, target: Array, scratch: Array) -> None:
    np.multiply(right, right, scratch)
    np.multiply(left, left, target)
    np.add(target, scratch, target)
    np.sqrt(target, target)


def _wrap(left: Array, target: Array, scratch: Array) -> None:
    """Take whole turns away: the angle in [−π, π]."""
    np.multiply(left, 1.0 / TWO_PI, scratch)
    np.rint(scratch, scratch)
    np.multiply(scratch, TWO_PI, scratch)
    np.subtract(left, scratch, target)


def _opposite(left: Array, target: Array, scratch: Array) -> None:
    np.copysign(np.pi, left, scratch)
    np.subtract(left, scratch, target)


def _mirrored(left: Array, target: Array, scratch: Array) -> None:
    np.copysign(np.pi, left, scratch)
    np.subtract(scratch, left, target)


OPERATIONS = {
    "add": Operation(np.add, 2),
    "subtract": Operation(np.subtract, 2),
    "multiply": Operation(np.multiply, 2),
    "scale": Operation(np.multiply, 1, has_number=True),
    "offset": Operation(np.add, 1, has_number=True),
    "divide": Operation(np.divide, 2, guarded="right"),
    "cosine": Operation(np.divide, 2),
    "sine": Operation(np.divide, 2),
    "atan2": Operation(np.arctan2, 2),
    "hypot": Operation(_hypot, 2, has_scratch=True, guarded="result"),
    "sqrt": Operation(np.sqrt, 1, guarded="left"),
    "cos": Operation(np.cos, 1),
    "sin": Operation(np.sin, 1),
    "absolute": Operation(np.absolute, 1),
    "wrap": Operation(_wrap, 1, has_scratch=True),
    "opposite": Operation(_opposite, 1, has_scratch=True),
    "mirrored": Operation(_mirrored, 1, has_scratch=True),
}
