"""The command `armproof` in a process of its own that need not start: a copy of this one, with all that it has loaded.

Whoever tests the start itself, what it loads or how it is found, runs the program that is installed.
"""

import os
import signal
import subprocess
import sys
import traceback
from collections.abc import Mapping
from contextvars import copy_context
from functools import cache
from pathlib import Path
from tempfile import TemporaryFile
from typing import NoReturn

SECONDS = 120


@cache
def load() -> None:
    """Load the command, with those of the course, once: each copy would load it anew, which takes longer than most of them work."""
    from typer.testing import CliRunner

    from armproof.verification.cli import app

    copy_context().run(CliRunner().invoke, app, ["lesson", "no such command"])


def armproof(*arguments: str | Path, folder: Path, environment: Mapping[str, str]) -> subprocess.CompletedProcess[str]:
    """Run the command in a folder and an environment, with nothing to read; return what it wrote and its exit code."""
    given = [str(argument) for argument in arguments]
    load()
    with TemporaryFile() as out, TemporaryFile() as err:
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            os.dup2(out.fileno(), 1)
            os.dup2(err.fileno(), 2)
            _run(given, folder, environment)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        written = [file.seek(0) or file.read().decode() for file in (out, err)]
    return subprocess.CompletedProcess(given, code, *written)


def _run(arguments: list[str], folder: Path, environment: Mapping[str, str]) -> NoReturn:
    """Run the command, and end: nothing of the tests is run once more here."""
    code: object = 1
    try:
        from armproof.verification.cli import main

        signal.alarm(SECONDS)
        os.chdir(folder)
        os.environ.clear()
        os.environ.update(environment)
        sys.stdin = open(os.devnull, encoding="utf-8")  # noqa: SIM115 - open to the end
        sys.stdout, sys.stderr = (open(number, "w", encoding="utf-8", closefd=False) for number in (1, 2))  # noqa: SIM115
        sys.argv = ["armproof", *arguments]
        main()
    except SystemExit as end:
        code = end.code
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code if isinstance(code, int) else int(code is not None))
