"""The function under check, called: at configurations of an arm with numbers, and once with symbols."""

from __future__ import annotations

import inspect
import linecache
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Sentence, written
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.functions.arguments import Layout, constants_of
from armproof.verification.functions.function_check import FunctionVerdict
from armproof.verification.functions.guarded_call import CallError, Guard
from armproof.verification.functions.returned import NotAttempted, NotNumbers, read_returned
from armproof.verification.functions.traced_function import trace_function

_HANGS = 20  # times as long as the calls before: a call that does not end, and no slow function


class Stopped(Exception):
    """A call gave no numbers: the function raised, did not end, is a stub, or returned something else.

    `is_exhausted` tells that the time ran out on a function that took about as long for each call before.
    """

    def __init__(
        self, verdict: FunctionVerdict, finding: Finding, error: CallError | None = None, is_exhausted: bool = False
    ) -> None:
        super().__init__(finding)
        self.verdict, self.finding, self.error, self.is_exhausted = verdict, finding, error, is_exhausted


class FunctionCaller:
    """Calls a function inside a guard; what its calls show beside results is kept in `notes`."""

    def __init__(self, arm: Arm, function: Callable[..., Any], layout: Layout, guard: Guard, count: int) -> None:
        self.arm = arm
        self.function = function
        self.layout = layout
        self.guard = guard
        self.count = count
        self.notes: dict[str, None] = {}
        self._calls, self._took = 0, 0.0
        self.constants: Mapping[str, float] = constants_of(arm)
        self.passed = [symbol for symbol in layout.lengths if symbol not in layout.defaults]

    def at(self, q: np.ndarray) -> list[np.ndarray]:
        """Return the results at one configuration, an array a quantity.

        Raises:
            Stopped: it has none.
        """
        numbers = {joint.symbol: float(value) for joint, value in zip(self.arm.joints, q, strict=True)}
        numbers |= {symbol: float(value) for symbol, value in self.constants.items()}
        args, kwargs = self.layout.arguments(numbers.__getitem__, self.passed)
        vector = args[0] if self.layout.vector else None
        before = None if vector is None else vector.copy()
        left = self.guard.left
        call = self.guard.call(lambda: self.function(*args, **kwargs))
        took, usual = left - self.guard.left, self._took / max(self._calls, 1)
        self._calls, self._took = self._calls + 1, self._took + took
        if vector is not None and before is not None and not np.array_equal(before, vector):
            self.notes["the function changes its argument q; work on a copy, q = q.copy()"] = None
        if call.error is not None:
            raise self._stopped(call.error, q, call.error.is_timeout and self._calls > 1 and took < _HANGS * usual)
        try:
            return read_returned(call.value, self.count)
        except NotAttempted as stub:
            raise Stopped(FunctionVerdict.NOT_ATTEMPTED, finding_of(stub)) from None
        except NotNumbers as problem:
            raise Stopped(
                FunctionVerdict.ERROR, finding_of(problem), at_definition(self.function, str(problem))
            ) from None

    def many(self, q: np.ndarray) -> list[np.ndarray]:
        """Return the results at configurations, an array (N, …) a quantity; at the first ones where the time is up."""
        results: list[list[np.ndarray]] = []
        for row in q:
            try:
                results.append(self.at(row))
            except Stopped as stop:
                if not results or not stop.is_exhausted:
                    raise
                break
        for items in zip(*results, strict=True):
            if len({item.shape for item in items}) > 1:
                raise Stopped(
                    FunctionVerdict.ERROR, say(Kind.SHAPES_DIFFER),
                    at_definition(self.function, written("results of different shapes")),
                )  # fmt: skip
        return [np.array(items) for items in zip(*results, strict=True)]

    def trace(self) -> list[np.ndarray] | str:
        """Return the formulas of the results, an array of traced numbers a quantity; or why there are none."""
        lengths = list(self.layout.lengths)

        def call(function: Callable[..., Any], make: Callable[[str], Any]) -> Any:
            args, kwargs = self.layout.arguments(make, lengths)
            return function(*args, **kwargs)

        traced = self.guard.call(lambda: trace_function(self.function, call))
        if traced.error is not None:
            return traced.error.message
        items = traced.value if self.count > 1 else [traced.value]
        return (
            [np.array(item, dtype=object) for item in items] if len(items) == self.count else Sentence("another result")
        )

    def with_lengths_of_the_arm(self, others: Mapping[str, float] | None = None) -> FunctionCaller:
        """Return a caller that passes the arm's lengths, or others, also where the function has defaults of its own."""
        other = FunctionCaller(self.arm, self.function, self.layout, self.guard, self.count)
        other.passed, other.constants = list(self.layout.lengths), {**self.constants, **(others or {})}
        return other

    def _stopped(self, error: CallError, q: np.ndarray, is_exhausted: bool) -> Stopped:
        if error.type == "NotImplementedError":
            return Stopped(FunctionVerdict.NOT_ATTEMPTED, say(Kind.NOT_IMPLEMENTED))
        where = say(Kind.IN_LINE, line=error.line) if error.line else ""
        if error.is_timeout:
            finding = say(Kind.DID_NOT_END, seconds=self.guard.seconds, where=where)
        elif error.type == "RecursionError":
            finding = say(Kind.CALLS_ITSELF, where=where)
        else:
            finding = say(Kind.RAISED, type=error.type, where=where, reason=error.message)
        if not (error.is_timeout and self._calls == 1):
            pairs = zip(self.arm.joints, q, strict=True)
            values = [say(Kind.VALUE, name=joint.symbol, value=float(value)) for joint, value in pairs]
            finding = say(Kind.AT_VALUES, what=finding, values=values)
        return Stopped(FunctionVerdict.ERROR, finding, error, is_exhausted)


def at_definition(function: Callable[..., Any], message: str) -> CallError:
    """Return a TypeError at the line in which a function begins."""
    code = getattr(inspect.unwrap(function), "__code__", None)
    if code is None:
        return CallError("TypeError", message)
    source = linecache.getline(code.co_filename, code.co_firstlineno).strip()
    return CallError("TypeError", message, code.co_filename, code.co_firstlineno, source)
