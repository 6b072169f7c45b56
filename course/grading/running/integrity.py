"""Whether a run changed what checks it: the functions of our packages, compared before and after.

This finds what is patched the easy way (`Task.check = ...`). It is no proof of honesty: all of it happens in the student's own
process, where whoever wants to can change anything, this module too.
"""

from __future__ import annotations

import sys
import types
from collections.abc import Iterator
from typing import Any

_OURS = "armproof."


def snapshot() -> dict[str, tuple[object, object]]:
    """Return each function and class of the modules loaded, by its name, and the code that it has."""
    return dict(_functions())


def changes(before: dict[str, tuple[object, object]]) -> list[str]:
    """Return the names of what is another function, or has other code, than before."""
    now = snapshot()
    return sorted(name for name, was in before.items() if now.get(name) is None or not _same(was, now[name]))


def _same(was: tuple[object, object], now: tuple[object, object]) -> bool:
    return was[0] is now[0] and was[1] is now[1]


def _functions() -> Iterator[tuple[str, tuple[object, object]]]:
    for module_name, module in list(sys.modules.items()):
        if not module_name.startswith(_OURS) or not isinstance(module, types.ModuleType):
            continue
        for name, value in list(vars(module).items()):
            if getattr(value, "__module__", None) == module_name:
                yield from _of(f"{module_name}.{name}", value)


def _of(name: str, value: Any) -> Iterator[tuple[str, tuple[object, object]]]:
    if isinstance(value, types.FunctionType):
        yield name, (value, value.__code__)
    elif isinstance(value, type):
        yield name, (value, None)
        for own, member in list(vars(value).items()):
            bare = getattr(member, "__func__", getattr(member, "fget", member))
            if isinstance(bare, types.FunctionType):
                yield f"{name}.{own}", (bare, bare.__code__)
