"""The page of one lesson: its text, its code and what running it gave, each task with its question and its hints."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.course.errors import SiteError
from armproof.course.feedback import Lesson
from armproof.course.sheet.proof import proof_line
from armproof.course.site.arms import arm_panel
from armproof.course.site.body import BodyWriter
from armproof.course.site.cells import Cell
from armproof.course.site.order import Neighbour, Order, switches
from armproof.course.site.reading import LessonReader
from armproof.verification.document import Document
from armproof.verification.report.html.prose import plain_title, title
from armproof.verification.report.html.templating import Shell, versions
from armproof.verification.verdict import DocumentResult

INDEX = "index"
SITE = Shell(
    "armproof.course.site",
    ("shell.css", "site.css"),
    ("site.js", "hands.js"),
    allowed="img-src data:; frame-src 'self'; ",
)


def write_page(
    lesson: Lesson,
    cells: tuple[Cell, ...],
    document: Document,
    result: DocumentResult,
    lessons: Sequence[Neighbour],
    order: Order,
) -> tuple[str, tuple[str, ...]]:
    """Return the page of a lesson that was checked and executed, and what of the lesson is not on it.

    Args:
        lesson: what it declares.
        cells: its cells, executed.
        document: its source as it was read, for its letters and its arm.
        result: the verdicts of its displays.
        lessons: all of the site in their order, this one among them.
        order: the languages of the site, and whether the solved cells were executed; their solutions are folded.

    Raises:
        SiteError: an equation of the lesson does not pass.
        PrintError: a display has no verdict.
    """
    _require_passed(result)
    place = [each.stem for each in lessons].index(document.path.stem)
    me, before, after = lessons[place], lessons[:place][-1:], lessons[place + 1 :][:1]
    others = [*lessons[:place], *lessons[place + 1 :]]
    pages = {name: each.page for each in others for name in (each.stem, each.stem.partition("_")[2], str(each.number))}
    reader = LessonReader(document, result, pages, order.solutions, order.lang)
    body = BodyWriter(lesson, reader, solutions=order.solutions)
    written = body.write(cells)
    reader.close()
    html = SITE.render(
        "lesson.html",
        styles=body.styles,
        lesson=lesson,
        title=title(lesson.title, reader.read),
        plain_title=plain_title(lesson.title),
        source=title(lesson.source, reader.read),
        objectives=[] if body.says_objectives else [body.inline(line) for line in lesson.objectives],
        solutions=order.solutions,
        switches=switches(order.langs, order.lang, me.stem),
        contents=[entry for entry in body.contents if entry.level <= 3],
        body=written,
        panel=arm_panel(reader.arm, reader.read, order.suffix),
        notebook=me.notebook,
        index=f"{INDEX}{order.suffix}.html",
        before=next(iter(before), None),
        after=next(iter(after), None),
        proof=proof_line(result.records, order.lang, result.arm),
        versions=versions(),
    )
    return html, tuple(reader.warnings)


def _require_passed(result: DocumentResult) -> None:
    wrong = [record for record in result.records if not record.passes]
    if wrong:
        more = f", and {len(wrong) - 1} more" if len(wrong) > 1 else ""
        raise SiteError("{path}:{line}: an equation does not pass{more}, so the page is not built; armproof verify {path} says what is wrong",
            path=result.path, line=wrong[0].line, more=more)  # fmt: skip
