"""Patterns that are compiled when they are first used: of the hundreds that hear what a text says a document needs few, and to compile them all was half of a start."""

from __future__ import annotations

import re
from typing import Any, AnyStr, Generic, cast


class _Pattern(Generic[AnyStr]):
    """A pattern by its text: what is asked of it first has it compiled, and stays."""

    def __init__(self, pattern: AnyStr, flags: int) -> None:
        self.pattern: AnyStr = pattern
        self._flags = flags

    def __getattr__(self, name: str) -> Any:
        answer = getattr(re.compile(self.pattern, self._flags), name)
        setattr(self, name, answer)
        return answer

    def __reduce__(self) -> tuple[Any, ...]:
        return regex, (self.pattern, self._flags)


def regex(pattern: AnyStr, flags: int = 0) -> re.Pattern[AnyStr]:
    """Return what `re.compile` returns, compiled when it is first used: one that is wrong raises `re.error` only then, and the `re` of a match is the compiled one."""
    return cast("re.Pattern[AnyStr]", _Pattern(pattern, flags))
