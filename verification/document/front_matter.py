"""The text of a file, UTF-8, of a bounded size and of one moment; and its front matter."""

from __future__ import annotations

import os
import re
import time
from pathlib import Path
from typing import Any

import yaml

from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say

MAX_BYTES = 20_000_000
ATTEMPTS = 5  # at a file that changes while it is read
PAUSE = 0.02
FRONT_MATTER_KEYS = ("title", "source", "arm", "convention", "symbols", "transforms", "quantities", "inverse")
# keys that notebook and site tools put into the same block, and `figures`, which the course's printing reads
FOREIGN_KEYS = frozenset(["author", "authors", "date", "lang", "language", "subtitle", "license", "jupyter", "jupytext",
                          "kernelspec", "format", "abstract", "keywords", "slug", "description", "execute", "engine", "bibliography",
                          "csl", "toc", "number-sections", "filters", "editor", "theme", "css", "categories", "image", "draft",
                          "output", "params", "knitr", "crossref", "header-includes", "documentclass", "classoption", "geometry",
                          "fontsize", "papersize", "figures", "project", "website", "order", "page-layout", "tags", "layout", "permalink",
                          "parent", "nav_order", "subject", "venue", "github", "exports", "downloads", "numbering", "math",
                          "settings", "doi", "copyright", "banner", "thumbnail", "short_title", "organization", "version",
                          "revision", "status", "contact", "orphan", "nocomments", "tocdepth"])  # fmt: skip


def read_text(path: Path) -> str:
    """Return the text of a file; raises DocumentError where it is none, is too large, or never stays as it is."""
    try:
        return read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
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


def split_front_matter(path: Path, text: str, first: int = 1) -> tuple[dict[str, Any] | None, dict[str, int], str, int]:
    """Return front matter (None where there is none), its keys' lines, the body and the body's first line.

    `first` is the line of the file on which the text begins.
    """
    text = text.replace("\r\n", "\n")
    if not re.match(r"---[ \t]*\n", text):
        return None, {}, text, first
    end = re.compile(r"^(?:---|\.\.\.)[ \t]*$", re.MULTILINE).search(text, text.index("\n") + 1)
    if end is None:
        raise DocumentError(say(Kind.FRONT_MATTER_OPEN), path=path, line=first)
    block = text[text.index("\n") + 1 : end.start()]
    front, lines = parse_front_matter(path, block, first + 1)
    body_start = end.end() + 1
    return front, lines, text[body_start:], first + text.count("\n", 0, body_start)


def parse_front_matter(path: Path, block: str, first_line: int) -> tuple[dict[str, Any], dict[str, int]]:
    """Return the mapping of a YAML block and the line of each top key; raises DocumentError."""
    front = _load(path, block, first_line)
    lines = _lines_of_keys(path, block, first_line)
    _validate(path, front, lines, first_line)
    return front, lines


def _load(path: Path, block: str, first_line: int) -> dict[str, Any]:
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        for event in yaml.parse(block, Loader=loader):
            if isinstance(event, yaml.AliasEvent):  # a few of them can stand for millions of entries
                line = first_line + (event.start_mark.line if event.start_mark else 0)
                raise DocumentError(say(Kind.FRONT_MATTER_ALIAS, anchor=event.anchor), path=path, line=line)
        front = yaml.load(block, Loader=loader)  # noqa: S506 - a safe loader
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = first_line + (mark.line if mark else 0)
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        raise DocumentError(say(Kind.FRONT_MATTER_NOT_YAML, reason=str(problem)), path=path, line=line) from None
    except (ValueError, RecursionError) as error:
        raise DocumentError(say(Kind.FRONT_MATTER_NOT_YAML, reason=str(error)), path=path, line=first_line) from None
    if front is None:
        front = {}
    if not isinstance(front, dict):
        raise DocumentError(say(Kind.FRONT_MATTER_NO_MAPPING), path=path, line=first_line)
    return front


def _lines_of_keys(path: Path, block: str, first_line: int) -> dict[str, int]:
    lines: dict[str, int] = {}
    for number, text in enumerate(block.split("\n")):
        if found := re.match(r"([A-Za-z_]+)\s*:", text):
            key, line = found.group(1), first_line + number
            if key in lines:
                raise DocumentError(say(Kind.KEY_TWICE, key=str(key), first=lines[key]), path=path, line=line)
            lines[key] = line
    return lines


def _validate(path: Path, front: dict[str, Any], lines: dict[str, int], first_line: int) -> None:
    for key in front:
        if key not in FRONT_MATTER_KEYS and key not in FOREIGN_KEYS:
            unknown = say(Kind.UNKNOWN_KEY, key=str(key), keys=list(FRONT_MATTER_KEYS))
            raise DocumentError(unknown, path=path, line=lines.get(str(key), first_line))
    if "arm" in front and front["arm"] is None:
        raise DocumentError(say(Kind.ARM_EMPTY), path=path, line=lines.get("arm", first_line))
    for key in ("title", "source"):
        if not isinstance(front.get(key, ""), str):
            other = say(Kind.KEY_NOT_TEXT, key=key, value=repr(front[key]))
            raise DocumentError(other, path=path, line=lines.get(key, first_line))
