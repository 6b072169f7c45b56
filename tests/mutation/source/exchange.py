"""A mutant in a process that has loaded its file already: the code of the one function that it changes is exchanged.

That takes milliseconds where an import takes seconds. What ran at import is done: constants, defaults, fields of classes and
whatever functions were called then. Such a mutant cannot be exchanged, and must be imported in a process of its own.
"""

from __future__ import annotations

import gc
import importlib
import inspect
import pkgutil
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import _lru_cache_wrapper
from types import CodeType, FrameType, FunctionType

from tests.mutation.source.mutants import mutate
from tests.mutation.source.trusted import ROOT

ROOMS = ("armproof.models", "armproof.verification")
Place = tuple[str, str, int]  # file, name and line of a function


class NotExchangeableError(Exception):
    """The mutant changes what was made when its file was imported."""


@dataclass(frozen=True)
class Loaded:
    """What a process has loaded of the rooms: its functions by file, and those among them that ran at import."""

    functions: Mapping[str, list[FunctionType]]
    ran: frozenset[Place]

    def exchange(self, file: str, index: int) -> None:
        """Put the code of a mutant into the functions that have the code which it changes."""
        source = (ROOT / file).read_text("utf-8")
        path = str(ROOT / file)
        for old, new in changed(compile(source, path, "exec"), compile(mutate(source, index), path, "exec")):
            having = [function for function in self.functions.get(path, []) if _is_of(function.__code__, old)]
            if not having or _place(old) in self.ran:
                raise NotExchangeableError(f"{file}: {old.co_qualname}")
            for function in having:
                function.__code__ = new


def load() -> Loaded:
    """Import every module of the rooms, and note which of their functions run meanwhile."""
    ran: set[Place] = set()
    start = str(ROOT)

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call" and frame.f_code.co_filename.startswith(start):
            ran.add(_place(frame.f_code))

    sys.setprofile(note)
    try:
        for name in _modules():
            importlib.import_module(name)
    finally:
        sys.setprofile(None)
    return Loaded(_functions(), frozenset(ran))


def _modules() -> Iterator[str]:
    for room in ROOMS:
        yield room
        for found in pkgutil.walk_packages(importlib.import_module(room).__path__, f"{room}."):
            if not found.name.endswith("__main__"):
                yield found.name


def _functions() -> dict[str, list[FunctionType]]:
    found = defaultdict(list)
    for each in gc.get_objects():
        if type(each) is FunctionType and each.__code__.co_filename.startswith(str(ROOT)):
            found[each.__code__.co_filename].append(each)
    return found


def _place(code: CodeType) -> Place:
    return code.co_filename, code.co_qualname, code.co_firstlineno


def _is_of(running: CodeType, compiled: CodeType) -> bool:
    """Whether a code that has run, and was adapted to what it met, is this one; two lambdas may stand on one line."""
    return _place(running) == _place(compiled) and running.co_code == compiled.co_code


def forget() -> None:
    """Empty the caches of the rooms: what the code as it is left there would hide a mutant."""
    gc.unfreeze()
    for each in gc.get_objects():
        if isinstance(each, _lru_cache_wrapper) and str(each.__module__).startswith(ROOMS):
            each.cache_clear()


def changed(old: CodeType, new: CodeType) -> Iterator[tuple[CodeType, CodeType]]:
    """Yield the functions that differ between two codes of a file, each with what it becomes."""
    if old == new:
        return
    if old.co_flags & inspect.CO_OPTIMIZED:  # a function; modules and bodies of classes are not
        yield old, new
    elif _own(old) != _own(new):
        raise NotExchangeableError(f"{old.co_filename}: {old.co_qualname}")
    else:
        for before, after in zip(_inside(old), _inside(new), strict=True):
            yield from changed(before, after)


def _own(code: CodeType) -> tuple[object, ...]:
    """Return what a code does itself, without the functions and classes inside it."""
    constants = [(type(value), "" if isinstance(value, CodeType) else repr(value)) for value in code.co_consts]
    return code.co_code, code.co_names, constants


def _inside(code: CodeType) -> list[CodeType]:
    return [value for value in code.co_consts if isinstance(value, CodeType)]
