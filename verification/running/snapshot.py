"""The state of a document's checker between two displays: taken, compared, and put back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

from armproof.verification.algebra.calculus import Ring
from armproof.verification.document import Document
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex.nodes import Node

# what never changes, and what only ever grows: the values that were met, the plant, the samples
_LASTING = (Document, Node, ExactAlgebra, Ring, SampledAlgebra)
_CONTAINERS = (dict, list, set)


class Snapshot:
    """The attributes of every object of ours that is reachable from a checker, its containers copied.

    The checker's own attributes are no part of it: they are its tools, and the document that it is at.
    """

    def __init__(self, checker: object) -> None:
        self._state = [
            (each, {name: _copied(value) for name, value in vars(each).items()}) for each in _objects(checker)
        ]

    def restore(self) -> None:
        """Give every object its attributes again."""
        for each, attributes in self._state:
            vars(each).clear()
            vars(each).update({name: _copied(value) for name, value in attributes.items()})

    def is_same(self, other: Snapshot) -> bool:
        """Whether two states of one checker are the same: their parts are identical, or equal."""
        return len(self._state) == len(other._state) and all(
            a is b and old.keys() == new.keys() and all(_same(old[name], new[name]) for name in old)
            for (a, old), (b, new) in zip(self._state, other._state, strict=True)
        )


def _objects(root: object) -> Iterator[Any]:
    """Yield the objects reachable by attributes whose attributes may change."""
    seen = {id(root)}
    stack = list(vars(root).values())
    while stack:
        each = stack.pop()
        if id(each) in seen or not _may_change(each):
            continue
        seen.add(id(each))
        yield each
        stack.extend(vars(each).values())


def _may_change(each: object) -> bool:
    kind = type(each)
    ours = (
        kind.__module__.startswith("armproof.verification.")
        and hasattr(each, "__dict__")
        and not isinstance(each, _LASTING)
    )
    return ours and not (is_dataclass(kind) and kind.__dataclass_params__.frozen)  # type: ignore[attr-defined]


def _copied(value: Any) -> Any:
    return value.copy() if isinstance(value, _CONTAINERS) else value


def _same(a: Any, b: Any) -> bool:
    if a is b:
        return True
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_same(a[key], b[key]) for key in a)
    if isinstance(a, list | tuple) and isinstance(b, list | tuple):
        return len(a) == len(b) and all(map(_same, a, b))
    if isinstance(a, str | int | float | set | frozenset | Node | None):
        return bool(a == b)
    if is_dataclass(a) and type(a) is type(b):
        return all(_same(getattr(a, field.name), getattr(b, field.name)) for field in fields(a))
    return False
