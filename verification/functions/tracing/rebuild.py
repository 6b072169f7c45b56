"""A function rebuilt on stand-ins for `math` and `numpy`: the same code, open to symbols; the original stays untouched."""

from __future__ import annotations

import copy
import functools
import inspect
import sysconfig
import types
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from armproof.verification.functions.tracing.arrays import as_objects
from armproof.verification.functions.tracing.replacements import Replacements

_INSTALLED = {"site-packages", "dist-packages"}
_ROOMS = Path(__file__).resolve().parents[3]


@cache
def is_library(filename: str) -> bool:
    """Whether a source file belongs to Python, to an installed package or to our own rooms, and not to a user."""
    if filename.startswith("<frozen"):
        return True
    path = str(Path(filename).resolve()) if not filename.startswith("<") else filename
    if not _INSTALLED.isdisjoint(Path(path).parts):  # in this environment, or in one that it reads from
        return True
    places = [sysconfig.get_paths()[name] for name in ("stdlib", "platstdlib")]
    places += [str(_ROOMS / room) for room in ("models", "verification")]
    return any(path.startswith(f"{Path(place).resolve()}/") for place in places)


class Rebuilder:
    """Rebuilds functions, and what they call, each once."""

    def __init__(self) -> None:
        self._stand_ins = Replacements()
        self._namespaces: dict[int, dict[str, Any]] = {}
        self._done: dict[int, Any] = {}
        self._kept: list[Any] = []

    def rebuild(self, value: Any) -> Any:
        """Return a value in which functions of the user are rebuilt and modules have their stand-ins."""
        found = self._stand_ins.find(value)
        if found is not None:
            return found
        if id(value) in self._done:
            return self._done[id(value)]
        if isinstance(value, types.FunctionType):
            return value if is_library(value.__code__.co_filename) else self._function(value)
        if isinstance(value, types.MethodType):
            return types.MethodType(self.rebuild(value.__func__), self._instance(value.__self__))
        if isinstance(value, functools.partial):
            return functools.partial(self.rebuild(value.func), *value.args, **value.keywords)
        if isinstance(value, np.ndarray):
            return self._remember(value, as_objects(value.copy()))
        if isinstance(value, types.ModuleType):
            return self._module(value)
        if isinstance(value, type):
            return self._class(value)
        wrapped = getattr(value, "__wrapped__", None)
        if isinstance(wrapped, types.FunctionType):  # functools.lru_cache
            return self.rebuild(wrapped)
        return self._instance(value)

    def _remember(self, value: Any, rebuilt: Any) -> Any:
        self._done[id(value)] = rebuilt
        self._kept.append(value)
        return rebuilt

    def _function(self, original: types.FunctionType) -> types.FunctionType:
        namespace = self._namespace(original.__globals__)
        cells = tuple(types.CellType() for _ in original.__closure__ or ())
        rebuilt = types.FunctionType(original.__code__, namespace, original.__name__, None, cells or None)
        self._remember(original, rebuilt)
        rebuilt.__kwdefaults__ = {name: self.rebuild(v) for name, v in (original.__kwdefaults__ or {}).items()}
        rebuilt.__defaults__ = tuple(self.rebuild(v) for v in original.__defaults__ or ()) or None
        for name, cell, old in zip(original.__code__.co_freevars, cells, original.__closure__ or (), strict=True):
            try:
                content = old.cell_contents
            except ValueError:  # not assigned yet
                continue
            cell.cell_contents = content if name == "__class__" else self.rebuild(content)
        for name in _global_names(original.__code__):
            if name in original.__globals__ and name not in namespace:
                namespace[name] = original.__globals__[name]  # a name that refers to itself ends here
                namespace[name] = self.rebuild(original.__globals__[name])
        return rebuilt

    def _namespace(self, original: dict[str, Any]) -> dict[str, Any]:
        if id(original) not in self._namespaces:
            names = {name: original.get(name) for name in ("__name__", "__package__", "__spec__")}
            self._namespaces[id(original)] = {**names, "__builtins__": self._stand_ins.builtins}
        return self._namespaces[id(original)]

    def _module(self, module: types.ModuleType) -> types.ModuleType:
        """Return a module of the user's with its functions rebuilt; any other as it is."""
        filename = getattr(module, "__file__", None)
        if not filename or is_library(filename):
            return module
        rebuilt = types.ModuleType(module.__name__)
        self._remember(module, rebuilt)
        for name, value in vars(module).items():
            if not name.startswith("__"):
                rebuilt.__dict__[name] = self.rebuild(value)
        return rebuilt

    def _class(self, original: type) -> type:
        """Return a subclass of a user's class with its methods rebuilt; any other class as it is."""
        if not _is_users(original):
            return original
        try:
            rebuilt: type = types.new_class(original.__name__, (original,))
        except TypeError:  # a class that may not be derived from
            return original
        self._remember(original, rebuilt)
        for owner in reversed(original.__mro__):
            if not _is_users(owner):
                continue
            for name, member in vars(owner).items():
                if (again := self._member(member)) is not None:
                    setattr(rebuilt, name, again)
        return rebuilt

    def _member(self, member: Any) -> Any | None:
        if isinstance(member, types.FunctionType):
            return self.rebuild(member)
        if isinstance(member, staticmethod | classmethod):
            return type(member)(self.rebuild(member.__func__))
        if isinstance(member, property):
            return property(*(get and self.rebuild(get) for get in (member.fget, member.fset, member.fdel)))
        return None

    def _instance(self, original: Any) -> Any:
        """Return a copy of an object of a user's class, with its methods rebuilt; any other object as it is."""
        if isinstance(original, type):
            return self._class(original)
        if not _is_users(type(original)):
            return original
        kind = self._class(type(original))
        try:
            rebuilt = copy.copy(original)
            rebuilt.__class__ = kind
        except Exception:  # an object that cannot be copied is used as it is
            return original
        self._remember(original, rebuilt)
        for name, value in getattr(rebuilt, "__dict__", {}).items():
            rebuilt.__dict__[name] = self.rebuild(value)
        return rebuilt


def _is_users(kind: type) -> bool:
    """Whether a class was written in Python by a user."""
    functions = [member for member in vars(kind).values() if isinstance(member, types.FunctionType)]
    files = {getattr(getattr(inspect.unwrap(f), "__code__", None), "co_filename", "<frozen") for f in functions}
    return bool(functions) and not any(is_library(name) for name in files)


def _global_names(code: types.CodeType) -> Iterator[str]:
    """Yield the names that a function, or one inside it, may look up in its module."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _global_names(constant)


def rebuild(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function with the same code that takes symbols where `math` and NumPy take floats only.

    Modules, functions and arrays that it refers to are replaced in a namespace of its own, and so are the functions of
    the user that it calls; no module is changed.
    """
    return Rebuilder().rebuild(function)  # type: ignore[no-any-return]
