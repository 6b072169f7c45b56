"""The folder of a report: written beside its place, then put there in one step, so that it is never half-written."""

from __future__ import annotations

import ctypes
import os
import re
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.patterns import regex
from armproof.verification.report.html.site import VERDICTS
from armproof.verification.report.html.templating import GENERATOR

_AT_FDCWD, _RENAME_EXCHANGE = -100, 2
_OURS = regex(rb'<meta name="generator" content="%s">' % GENERATOR.encode())
_HEAD = 1000  # bytes of a page in which it says whose it is


class ReportFolderError(ArmproofError):
    """The report cannot be written where it was asked for."""


def is_page(entry: Path) -> bool:
    """Whether a file is a page of ours."""
    if entry.suffix != ".html" or not entry.is_file():
        return False
    with entry.open("rb") as page:
        return bool(_OURS.search(page.read(_HEAD)))


def _is_of_report(entry: Path) -> bool:
    return entry.is_file() if entry.name in (VERDICTS, f"{VERDICTS}.part") else is_page(entry)


@dataclass(frozen=True)
class Kind:
    """What is written into a folder.

    Attributes:
        word: what it is called.
        option: the option that names the folder.
        is_ours: whether a file is part of an earlier one, and may be replaced.
    """

    word: str = "report"
    option: str = "--report"
    is_ours: Callable[[Path], bool] = _is_of_report


REPORT = Kind()


@contextmanager
def new_report(target: Path, kind: Kind = REPORT) -> Iterator[Path]:
    """Give an empty folder to write a report into; at the end it takes the place of `target`, whole.

    What is interrupted leaves the report that was there before. A report of ours is replaced; any other folder that holds
    something is not touched.

    Raises:
        ReportFolderError: `target` is no folder, holds other files, or cannot be written.
    """
    target = Path(os.path.realpath(target))
    _check(target, kind)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        _clear_leftovers(target)
        part = Path(tempfile.mkdtemp(prefix=f".{target.name}.", suffix=f".{os.getpid()}.part", dir=target.parent))
    except OSError as error:
        raise ReportFolderError(
            "{target}: the {kind} cannot be written: {reason}", target=target, kind=kind.word, reason=error.strerror
        ) from None
    try:
        yield part
        _check(target, kind)  # it may have changed since
        part.chmod(0o777 & ~_umask())
        _put(part, target)
    except OSError as error:
        raise ReportFolderError(
            "{target}: the {kind} cannot be written: {reason}", target=target, kind=kind.word, reason=error.strerror
        ) from None
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _check(target: Path, kind: Kind) -> None:
    """Refuse a place whose replacement would cost anything but an earlier one of ours."""
    if target.exists() and not target.is_dir():
        raise ReportFolderError("{target}: not a folder; {option} takes a folder, new, empty or with an earlier {kind}",
            target=target, option=kind.option, kind=kind.word)  # fmt: skip
    if target == Path.cwd() or target in Path.cwd().parents:
        raise ReportFolderError("{target}: the working folder; {option} takes a folder of its own, such as {kind}",
            target=target, option=kind.option, kind=kind.word)  # fmt: skip
    if not target.exists():
        return
    try:
        foreign = next((entry.name for entry in sorted(target.iterdir()) if not kind.is_ours(entry)), None)
    except OSError as error:
        raise ReportFolderError("{target}: cannot be read: {reason}", target=target, reason=error.strerror) from None
    if foreign is not None:
        raise ReportFolderError("{target}: holds '{foreign}', which is no part of a {kind}; {option} takes a folder of its own, new or empty",
            target=target, foreign=foreign, kind=kind.word, option=kind.option)  # fmt: skip


def _put(part: Path, target: Path) -> None:
    """Put the new folder in its place; the old one takes its name and is removed with it."""
    if not target.exists():
        part.rename(target)
    elif not _exchange(part, target):
        old = part.with_suffix(".old.part")
        target.rename(old)
        part.rename(target)
        shutil.rmtree(old, ignore_errors=True)


def _exchange(first: Path, second: Path) -> bool:
    """Exchange two folders in one step, where the system can."""
    rename = getattr(ctypes.CDLL(None, use_errno=True), "renameat2", None) if os.name == "posix" else None
    if rename is None:
        return False
    return bool(rename(_AT_FDCWD, os.fsencode(first), _AT_FDCWD, os.fsencode(second), _RENAME_EXCHANGE) == 0)


def _clear_leftovers(target: Path) -> None:
    """Remove what runs that were killed have left beside the target."""
    for left in target.parent.glob(f".{_literal(target.name)}.*.part"):
        owner = re.search(r"\.(\d+)(?:\.old)?\.part$", left.name)
        if owner is not None and not _is_running(int(owner.group(1))):
            shutil.rmtree(left, ignore_errors=True)


def _literal(name: str) -> str:
    return re.sub(r"([*?[])", r"[\1]", name)


def _is_running(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
