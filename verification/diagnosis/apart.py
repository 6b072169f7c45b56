"""What does not rest on one definition has one value, whatever that definition is changed to: it is evaluated once."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.sides import Member
from armproof.verification.latex import nodes as n

T = TypeVar("T")


class Apart:
    """The exact values beside one definition, as long as nothing else changes in the document.

    It rests on the definition if that is consulted when it is evaluated, be it by way of others.
    """

    def __init__(self, checker: ChainChecker, key: str) -> None:
        self._checker, self._key = checker, key
        self._state = checker.names.state
        self._known: dict[Hashable, tuple[Any, set[tuple[str, int]]]] = {}

    def sides(self, *nodes: n.Node) -> list[Member]:
        """Return the exact values of formulas where the definition is what it is now."""
        made = self._state.definitions
        self._state.definitions = {
            name: each if name == self._key else replace(each, evaluate=partial(self._of, name, each.evaluate))
            for name, each in made.items()
        }
        try:
            return [self._once(id(node), partial(self._checker.member, node)) for node in nodes]
        finally:
            self._state.definitions = made

    def _of(self, name: str, evaluate: Callable[[Any], T], algebra: Any) -> T:
        known = algebra is self._checker.exact
        return self._once(name, partial(evaluate, algebra)) if known else evaluate(algebra)

    def _once(self, of: Hashable, evaluate: Callable[[], T]) -> T:
        """Return a value, kept where it does not rest on the definition; it is consulted for all that it rests on."""
        if of in self._known:
            value, met = self._known[of]
            self._state.consulted |= met
            return value
        before, self._state.consulted = self._state.consulted, set()
        try:
            value = evaluate()
            if all(name != self._key for name, _ in self._state.consulted):
                self._known[of] = value, self._state.consulted.copy()
            return value
        finally:
            self._state.consulted |= before
