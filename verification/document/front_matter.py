"""The text of a file, of a bounded size and of one moment; and its front matter, in which other tools' keys are left alone."""

from __future__ import annotations

import codecs
import os
import re
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from armproof.models.dh.entry import as_typed
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.patterns import regex

MAX_BYTES = 20_000_000
ATTEMPTS = 5  # at a file that changes while it is read
PAUSE = 0.02
FRONT_MATTER_KEYS = (
    "title",
    "source",
    "arm",
    "convention",
    "symbols",
    "transforms",
    "quantities",
    "inverse",
    "tip",
    "lock",
    "arms",
)
_SHARED = ("title", "source")  # with other tools: any text will do
QUIET_KEYS = frozenset(["lang", "figures", "jupyter", "jupytext", "kernelspec"])  # read elsewhere, or a notebook's own
_OURS = regex(r"^[\s-]*[\"']?(?:%s)[\"']?\s*:" % "|".join(FRONT_MATTER_KEYS[2:]), re.MULTILINE)
_KEY = regex(r"[\"']?([^\s\"'#:{}\[\],&*-][^:]*?)[\"']?\s*:(?=\s|$)")
_TOML = regex(r"\+\+\+[ \t]*\n.*?^\+\+\+[ \t]*(?:\n|\Z)", re.DOTALL | re.MULTILINE)
_BINARY = regex("[\x00-\x08\x0e-\x1f]")


@dataclass(frozen=True)
class FrontMatter:
    """What the keys of a front matter say, the line of each key, and what there is to remark about it."""

    values: dict[str, Any] = field(default_factory=dict)
    lines: dict[str, int] = field(default_factory=dict)
    remarks: tuple[Finding, ...] = ()


def suffix_of(path: Path) -> str:
    """Return what the end of a file's name says of its format, .md of README.MD."""
    return path.suffix.lower()


def read_any_text(path: Path) -> tuple[str, tuple[Finding, ...]]:
    """Return the text of a file in UTF-8, in UTF-16 or, with a remark, in an old encoding of Western Europe; raises DocumentError."""
    data = read_bytes(path)
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", "replace"), ()
    try:
        return data.decode("utf-8-sig"), ()
    except UnicodeDecodeError:
        text = data.decode("utf-8-sig", _ANY_BYTE)
    return (text, (say(Kind.READ_AS_WESTERN),)) if not _BINARY.search(text) else (read_text(path), ())


def _as_western(error: UnicodeError) -> tuple[str, int]:
    assert isinstance(error, UnicodeDecodeError)
    return error.object[error.start : error.end].decode("cp1252", "replace"), error.end


_ANY_BYTE = "armproof-western"
codecs.register_error(_ANY_BYTE, _as_western)


def read_text(path: Path) -> str:
    """Return the text of a file; raises DocumentError where it is none, is too large, or never stays as it is."""
    data = read_bytes(path)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise DocumentError(say(Kind.NOT_UTF8, byte=error.start), path=path, line=line) from None


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file as they were at one moment; raises DocumentError."""
    try:
        for _ in range(ATTEMPTS):
            if path.stat().st_size > MAX_BYTES:
                raise DocumentError(say(Kind.FILE_TOO_LARGE, megabytes=MAX_BYTES // 1_000_000), path=path)
            if (data := _read_unchanged(path)) is not None:
                return data
            time.sleep(PAUSE)
    except OSError as error:
        raise DocumentError(say(Kind.FILE_UNREADABLE, reason=str(error.strerror)), path=path) from None
    raise DocumentError(say(Kind.FILE_CHANGES), path=path)


def _read_unchanged(path: Path) -> bytes | None:
    """Return the bytes of a file, or None where it changed meanwhile."""
    with path.open("rb") as file:
        before = os.fstat(file.fileno())
        data = file.read(MAX_BYTES + 1)
        after = os.fstat(file.fileno())
    same = (before.st_mtime_ns, before.st_size) == (after.st_mtime_ns, after.st_size)
    return data if same and len(data) == after.st_size else None


def split_front_matter(path: Path, text: str, first: int = 1) -> tuple[FrontMatter | None, str, int]:
    """Return front matter (None where there is none), the body and the body's first line.

    `first` is the line of the file on which the text begins. What stands between two rules and holds no keys is prose.
    """
    text = text.replace("\r\n", "\n")
    if toml := _TOML.match(text):
        remark = say(Kind.FOREIGN_FRONT_MATTER)
        return FrontMatter(remarks=(remark,)), text[toml.end() :], first + toml.group().count("\n")
    opened = re.match(r"---[ \t]*\n", text)
    if not opened:
        return None, text, first
    end = re.compile(r"^(?:---|\.\.\.)[ \t]*$", re.MULTILINE).search(text, opened.end())
    if end is None:
        if _OURS.search(text[opened.end() :].split("\n\n")[0]):
            raise DocumentError(say(Kind.FRONT_MATTER_OPEN), path=path, line=first)
        return None, text, first
    front = parse_front_matter(path, text[opened.end() : end.start()], first + 1)
    if front is None:
        return None, text, first
    body_start = end.end() + 1
    return front, text[body_start:], first + text.count("\n", 0, body_start)


def parse_front_matter(path: Path, block: str, first_line: int) -> FrontMatter | None:
    """Return what a YAML block says, or None where it is prose.

    A key of another tool never stops a document, not even where it is no YAML. Raises DocumentError at a key of ours.
    """
    try:
        front = _load(path, block, first_line)
    except DocumentError:
        front = dict(_read_key_by_key(path, block, first_line))
        if not front and _OURS.search(block):
            raise
    is_prose = not isinstance(front, dict) or "$$" in block or (not front and any(map(_is_text, block.split("\n"))))
    if is_prose and not (isinstance(front, dict) and _OURS.search(block)):
        if _OURS.search(block):
            raise DocumentError(say(Kind.FRONT_MATTER_NO_MAPPING), path=path, line=first_line)
        return None
    lines = _lines_of_keys(path, block, first_line)
    if "arm" in front and front["arm"] is None:
        raise DocumentError(say(Kind.ARM_EMPTY), path=path, line=lines.get("arm", first_line))
    foreign = [str(key) for key in front if key not in FRONT_MATTER_KEYS and key not in QUIET_KEYS]
    told = (say(Kind.FOREIGN_KEYS, keys=foreign, ours=list(FRONT_MATTER_KEYS)),) if foreign else ()
    return FrontMatter({k: v if k not in _SHARED else _as_text(v) for k, v in front.items()}, lines, told)


def _is_text(line: str) -> bool:
    return bool(line.strip()) and not line.lstrip().startswith("#")


def _as_text(value: Any) -> str:
    return "" if value is None or isinstance(value, dict | list) else str(value)


def _load(path: Path, block: str, first_line: int) -> Any:
    """Return what a YAML block holds, a mapping if it is empty; raises DocumentError."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        for event in yaml.parse(block, Loader=loader):
            if isinstance(event, yaml.AliasEvent):  # a few of them can stand for millions of entries
                line = first_line + (event.start_mark.line if event.start_mark else 0)
                raise DocumentError(say(Kind.FRONT_MATTER_ALIAS, anchor=event.anchor), path=path, line=line)
        front = yaml.load(block, Loader=loader)  # noqa: S506 - a safe loader
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = first_line + min(mark.line if mark else 0, block.rstrip().count("\n"))
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        raise DocumentError(say(Kind.FRONT_MATTER_NOT_YAML, reason=str(problem)), path=path, line=line) from None
    except (ValueError, RecursionError) as error:
        raise DocumentError(say(Kind.FRONT_MATTER_NOT_YAML, reason=str(error)), path=path, line=first_line) from None
    return {} if front is None else front


def _read_key_by_key(path: Path, block: str, first_line: int) -> Iterator[tuple[str, Any]]:
    """Yield the keys of a block that is no YAML as a whole, each read alone: a broken one of another tool has no value."""
    lines = block.split("\n")
    starts = [number for number, line in enumerate(lines) if _KEY.match(line)]
    for start, end in zip(starts, [*starts[1:], len(lines)], strict=False):  # there may be none
        key = (_KEY.match(lines[start]) or [""] * 2)[1]
        block = "\n".join(lines[start:end])
        try:  # braces of LaTeX are none of YAML's
            yield key, _load(path, as_typed(block) if key in ("arm", "arms") else block, first_line + start)[key]
        except (DocumentError, KeyError, TypeError):
            if key in FRONT_MATTER_KEYS[2:]:
                raise
            yield key, lines[start].partition(":")[2].strip()


def _lines_of_keys(path: Path, block: str, first_line: int) -> dict[str, int]:
    lines: dict[str, int] = {}
    for number, text in enumerate(block.split("\n")):
        if found := re.match(r"([A-Za-z_]+)\s*:", text):
            key, line = found.group(1), first_line + number
            if key in lines and key in FRONT_MATTER_KEYS:
                raise DocumentError(say(Kind.KEY_TWICE, key=str(key), first=lines[key]), path=path, line=line)
            lines[key] = line
    return lines
