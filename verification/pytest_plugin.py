"""Documents as tests: `pytest course/handouts` gives one test an equation, whose name is its place, handout.md:41.

A document is collected if it has front matter that names an arm or one of its companions; others only if they are named
on the command line. It is verified once a process, when the first of its equations runs.

    [tool.pytest.ini_options]
    armproof = false            # collect no documents
    armproof_strict = true      # unchecked equations fail too
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from textwrap import dedent
from typing import TYPE_CHECKING, Any

import pytest

from armproof.models.errors import ArmproofError

if TYPE_CHECKING:
    from armproof.verification.document import Document
    from armproof.verification.verdict import DocumentResult, Record

SUFFIXES = (
    ".md",
    ".ipynb",
    ".py",
    ".qmd",
    ".tex",
    ".rst",
)  # as armproof.verification.document has them, without its imports
OURS = ("arm:", "quantities:", "transforms:", "symbols:")  # in the front matter
RESULTS = pytest.StashKey[dict[Path, "DocumentResult | ArmproofError"]]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """Declare the settings."""
    parser.addini("armproof", "Collect the equations of documents as tests.", type="bool", default=True)
    parser.addini("armproof_strict", "Fail unchecked equations too.", type="bool", default=False)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Collect the documents that have front matter of ours, and those that are named on the command line."""
    if file_path.suffix not in SUFFIXES or not parent.config.getini("armproof"):
        return None
    named = file_path.suffix != ".py" and parent.session.isinitpath(file_path)
    if not named and not _may_be_ours(file_path):
        return None
    from armproof.verification.document import read_document

    found: Document | ArmproofError
    try:
        found = read_document(file_path)
    except ArmproofError as problem:
        found = problem
    if not named and not _is_ours(file_path, found):
        return None
    return DocumentFile.from_parent(parent, path=file_path, found=found)


def _may_be_ours(path: Path) -> bool:
    """Whether a file is worth reading as a document: of most files neither YAML nor Markdown is loaded."""
    try:
        head = path.read_bytes()
    except OSError:
        return False
    if not any(key.encode() in head for key in OURS):
        return False
    if path.suffix in (".md", ".qmd") and not head.startswith((b"---", b"\xef\xbb\xbf---")):
        return False  # where its front matter would stand
    # a lesson begins with a comment, its header or first cell; a program may hold one in its strings
    return path.suffix != ".py" or head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"#")


def _is_ours(path: Path, found: Document | ArmproofError) -> bool:
    """Whether a file is a document of ours: its front matter holds one of the keys that only we give a meaning."""
    if isinstance(found, ArmproofError):
        head = path.read_bytes().lstrip(b"\xef\xbb\xbf%. \t\r\n")
        return path.suffix != ".py" and head.startswith((b"---", b"arm:"))
    return not found.front.keys().isdisjoint(key.removesuffix(":") for key in OURS)


class DocumentFile(pytest.File):
    """A document: its equations and tables are its tests."""

    def __init__(self, *, found: Document | ArmproofError, **options: Any) -> None:
        super().__init__(**options)
        self.found = found

    def collect(self) -> Iterator[pytest.Item]:
        """Yield a test for each display and each table of the document; one that fails where it cannot be read."""
        if isinstance(self.found, ArmproofError):
            yield FaultItem.from_parent(self, name=self.path.name, problem=self.found)
            return
        for name, kind, index, cell, line in _places(self.found):
            yield EquationItem.from_parent(self, name=name, kind=kind, index=index, cell=cell, line=line)

    def result(self) -> DocumentResult:
        """Return the verdicts of the document; raises ArmproofError where it cannot be checked as a whole."""
        results = self.config.stash.setdefault(RESULTS, {})
        if self.path not in results:
            from armproof.verification.check import check_document

            assert not isinstance(self.found, ArmproofError)
            try:
                results[self.path] = check_document(self.found)
            except ArmproofError as problem:
                results[self.path] = problem
        found = results[self.path]
        if isinstance(found, ArmproofError):
            raise found
        return found


class FaultItem(pytest.Item):
    """A document that cannot be read."""

    def __init__(self, *, problem: ArmproofError, **options: Any) -> None:
        super().__init__(**options)
        self.problem = problem

    def runtest(self) -> None:
        """Fail: nothing in the document can be checked."""
        raise self.problem

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> str:
        """Return the message alone."""
        return str(excinfo.value)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """Return the file and what is wrong in it."""
        return self.path, None, self.name


class EquationItem(pytest.Item):
    """One display or one table."""

    def __init__(self, *, kind: str, index: int, cell: int | None, line: int, **options: Any) -> None:
        super().__init__(**options)
        self.kind, self.index, self.cell, self.line = kind, index, cell, line

    def runtest(self) -> None:
        """Fail where the equation does not pass; skip what claims nothing, such as a table of other things."""
        assert isinstance(self.parent, DocumentFile)
        result = self.parent.result()
        record = self._record(result)
        if record is None:
            pytest.skip("claims nothing about the arm")
        from armproof.verification.verdict import Verdict

        self.user_properties.append(("verdict", record.verdict.value))
        if record.is_accepted:
            pytest.xfail(record.message)  # known and counted apart, never as passed
        unchecked = record.verdict is Verdict.UNCHECKED and not record.is_remark
        strict = self.config.getini("armproof_strict") and unchecked
        if not record.passes or strict:
            raise Refuted(_described(record, self.kind, self.path))

    def _record(self, result: DocumentResult) -> Record | None:
        if not self.kind:
            return result.equations[self.index]
        return next((record for record in result.tables if (record.cell, record.line) == (self.cell, self.line)), None)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return what the report says of the equation; a fault of our own keeps its traceback."""
        if isinstance(excinfo.value, ArmproofError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """Return the place of the equation: file, line from 0, and the headline of its failure."""
        return self.path, self.line - 1, f"{self.kind or 'equation'} {self.name}"


class Refuted(ArmproofError):
    """An equation that does not pass; the message is the report's."""


def _places(document: Document) -> Iterator[tuple[str, str, int, int | None, int]]:
    """Yield name, kind, number, cell and line of each display and table: handout.md:41, lesson.ipynb:3:12 in a notebook."""
    found = [("", k, display.cell, display.line) for k, display in enumerate(document.displays)]
    found += [("table", k, table.cell, table.line) for k, table in enumerate(document.tables)]
    notebook = document.path.suffix == ".ipynb"
    taken: dict[str, int] = {}
    for kind, index, cell, line in sorted(found, key=lambda item: (item[2] or 0, item[3])):
        place = f"{cell}:{line}" if notebook else str(line)
        name = f"{document.path.name}:{place}"
        taken[name] = taken.get(name, 0) + 1
        yield (name if taken[name] == 1 else f"{name}#{taken[name]}"), kind, index, cell, line


def _described(record: Record, kind: str, path: Path) -> str:
    from armproof.verification.report.text import describe_record

    own = record if path.suffix == ".ipynb" else replace(record, cell=None)
    return dedent("\n".join("".join(text for text, _ in line).rstrip() for line in describe_record(own, kind)))
