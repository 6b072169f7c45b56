"""The page of one lesson: its text, its code and what running it gave, each task with its question and its hints."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from armproof.course.errors import SiteError
from armproof.course.feedback import Lesson
from armproof.course.sheet.proof import proof_line
from armproof.course.site.arms import arm_panel
from armproof.course.site.body import BodyWriter
from armproof.course.site.cells import Cell
from armproof.course.site.reading import LessonReader
from armproof.verification.document import Document
from armproof.verification.report.html.prose import plain_title, title
from armproof.verification.report.html.templating import Shell, versions
from armproof.verification.verdict import DocumentResult

INDEX = "index.html"
SITE = Shell("armproof.course.site", ("shell.css", "site.css"), "site.js", allowed="img-src data:; frame-src 'self'; ")


@dataclass(frozen=True)
class Neighbour:
    """A lesson as others refer to it: its number, its title as plain text, the stem of its files."""

    number: int
    title: str
    stem: str

    @property
    def page(self) -> str:
        """The file of its page."""
        return f"{self.stem}.html"

    @property
    def notebook(self) -> str:
        """The file of the student's notebook."""
        return f"{self.stem}.ipynb"


@dataclass(frozen=True)
class Surroundings:
    """Where a lesson stands in the site: the lessons before and after it, and the page of every lesson by its names."""

    before: Neighbour | None
    after: Neighbour | None
    pages: dict[str, str]


@dataclass(frozen=True)
class Written:
    """A page, and what of the lesson is not on it."""

    html: str
    warnings: tuple[str, ...] = ()


def neighbour(lesson: Lesson, path: Path) -> Neighbour:
    """Return a lesson as others refer to it."""
    return Neighbour(lesson.number, plain_title(lesson.title), path.stem)


def write_page(
    lesson: Lesson,
    cells: tuple[Cell, ...],
    document: Document,
    result: DocumentResult,
    around: Surroundings,
    *,
    solutions: bool = False,
) -> Written:
    """Return the page of a lesson that was checked and executed.

    Args:
        lesson: what it declares.
        cells: its cells, executed.
        document: its source as it was read, for its letters and its arm.
        result: the verdicts of its displays.
        around: its neighbours.
        solutions: whether the solved cells were executed; their solutions are folded.

    Raises:
        SiteError: an equation of the lesson does not pass.
        PrintError: a display has no verdict.
    """
    _require_passed(result)
    reader = LessonReader(document, result, around.pages, solutions)
    body = BodyWriter(lesson, reader, solutions=solutions)
    written = body.write(cells)
    reader.close()
    panel = arm_panel(reader.arm, reader.read)
    me = neighbour(lesson, document.path)
    html = SITE.render(
        "lesson.html",
        styles=body.styles,
        lesson=lesson,
        title=title(lesson.title, reader.read),
        plain_title=me.title,
        source=title(lesson.source, reader.read),
        objectives=[] if body.says_objectives else [body.inline(line) for line in lesson.objectives],
        solutions=solutions,
        contents=[entry for entry in body.contents if entry.level <= 3],
        body=written,
        panel=panel,
        notebook=me.notebook,
        index=INDEX,
        before=around.before,
        after=around.after,
        proof=proof_line(result.records, "en", result.arm),
        versions=versions(),
    )
    return Written(html, tuple(reader.warnings))


def _require_passed(result: DocumentResult) -> None:
    wrong = [record for record in result.records if not record.passes]
    if wrong:
        more = f", and {len(wrong) - 1} more" if len(wrong) > 1 else ""
        raise SiteError("{path}:{line}: an equation does not pass{more}, so the page is not built; armproof verify {path} says what is wrong",
            path=result.path, line=wrong[0].line, more=more)  # fmt: skip
