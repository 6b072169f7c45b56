"""Run the code cells of a notebook in this process, one after the other, and say what became of them.

It runs in the sandbox of one submission; what it reports is data that the teacher's side checks (see judging).
"""

from __future__ import annotations

import ast
import builtins
import contextlib
import linecache
import os
import re
import sys
import traceback
import types
from collections.abc import Callable, Sequence
from typing import Any

from armproof.course.grading.running.integrity import changes, snapshot

Send = Callable[[dict[str, Any]], None]
_LONGEST = 500  # characters of a message
_WHOLE = re.compile(r"%%(?!time\b|timeit\b|capture\b)(\w+)")
_LINE = re.compile(r"\s*(?:[%!]|\?|[^#'\"]*\w\?{1,2}\s*$)")
_ASSIGNED = re.compile(r"(\s*)([\w.,\s\[\]]+?)\s*=\s*[%!]")


def run_cells(cells: Sequence[str], results: Callable[[], list[dict[str, Any]]], send: Send) -> None:
    """Run the cells in one namespace; a cell that raises is reported, and the next one runs.

    Args:
        cells: their sources.
        results: what the checks have found so far.
        send: takes each report: a cell begun, a note, an error, the results when they changed, the end.
    """
    before = snapshot()
    namespace = _main_module()
    known: list[dict[str, Any]] = []
    process = os.getpid()
    for number, source in enumerate(cells, start=1):
        send({"cell": number})
        plain, notes = without_magics(source)
        for note in notes:
            send({"note": note, "in": number})
        if (error := run_cell(plain, number, namespace)) is not None:
            send({"error": error})
        if os.getpid() != process:  # a child that the cell forked: the rest is not its business
            os._exit(0)
        now = results()
        if new := [each for each in now if each not in known]:
            send({"results": new})
        known = now
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(Exception):  # it may be anything by now
            stream.flush()
    send({"done": True, "changed": changes(before)})


def run_cell(source: str, number: int, namespace: dict[str, Any]) -> dict[str, Any] | None:
    """Run one cell; returns what it raised, with the line in the cell."""
    name = f"cell {number}"
    linecache.cache[name] = (len(source), None, source.splitlines(keepends=True), name)
    try:
        exec(compile(source, name, "exec"), namespace)  # noqa: S102 - a student's own code, in its sandbox
    except BaseException as problem:
        return _describe(problem, number, name)
    return None


def _describe(problem: BaseException, number: int, name: str) -> dict[str, Any]:
    """Return an exception as data; its own text may raise as well."""
    line = problem.lineno or 0 if isinstance(problem, SyntaxError) and problem.filename == name else 0
    for frame in traceback.extract_tb(problem.__traceback__) if not line else ():
        line = frame.lineno or 0 if frame.filename == name else line
    try:
        message = str(problem)[:_LONGEST]
    except BaseException:
        message = "(its message cannot be shown)"
    if isinstance(problem, SystemExit):
        message = "the cell ends the program: it calls exit()"
    kind, out_of_memory = type(problem).__name__[:80], isinstance(problem, MemoryError)
    return {"cell": number, "line": line, "type": kind, "message": message, "memory": out_of_memory}


def _main_module() -> dict[str, Any]:
    """Return the namespace of a fresh `__main__`, with what a notebook has beside Python."""
    main = types.ModuleType("__main__")
    sys.modules["__main__"] = main
    sys.path.insert(0, "")
    builtins.display = _nothing  # type: ignore[attr-defined]
    for name in ("IPython", "IPython.display", "ipywidgets"):
        sys.modules[name] = _Stub(name)
    sys.modules["IPython"].version_info = (9, 0, 0)  # type: ignore[attr-defined]  # matplotlib asks for it
    main.__dict__["get_ipython"] = lambda: _Nothing()
    return main.__dict__


class _Nothing:
    """Takes every call and every attribute, and does nothing."""

    def __init__(self, *arguments: object, **named: object) -> None: ...

    def __call__(self, *arguments: object, **named: object) -> _Nothing:
        return self

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self


class _Stub(types.ModuleType):
    """A module of which every name is a class that does nothing: nobody looks at what is displayed."""

    __path__: list[str] = []  # noqa: RUF012 - a package, so that its modules can be imported

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return _nothing if name in ("display", "get_ipython") else _Nothing


def _nothing(*arguments: object, **named: object) -> None:
    """Stand in for `display`, and for `get_ipython` of a module, which finds no shell."""


def without_magics(source: str) -> tuple[str, list[str]]:
    """Return a cell as plain Python, its lines where they were, and a note for each thing that was skipped."""
    if _is_python(source):
        return source, []
    first = source.lstrip().split("\n", 1)[0]
    if whole := _WHOLE.match(first):
        return "", [f"%%{whole[1]}: the whole cell was skipped"]
    lines, notes = [], []
    for line in source.split("\n"):
        if assigned := _ASSIGNED.match(line):
            notes.append(f"skipped, and set to None: {line.strip()}")
            lines.append(f"{assigned[1]}{assigned[2]} = None")
        elif _LINE.match(line):
            notes.append(f"skipped: {line.strip()}")
            lines.append(re.match(r"\s*", line)[0] + "pass")  # type: ignore[index]
        else:
            lines.append(line)
    plain = "\n".join(lines)
    return (plain, notes) if _is_python(plain) else (source, [])


def _is_python(source: str) -> bool:
    try:
        ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True
