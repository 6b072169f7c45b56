"""What the processes of a build do: open the lessons, build one page, build the index and the 3D views."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.course.errors import SiteError
from armproof.course.site.order import Built, Neighbour, Order, ending_of
from armproof.models.errors import ArmproofError
from armproof.models.language import use

if TYPE_CHECKING:
    from armproof.course.feedback import Lesson


def describe(order: Order) -> list[Neighbour]:
    """Return what every page needs to know of each lesson before it is executed; raises SiteError."""
    from armproof.models.catalogue import arm_names
    from armproof.verification.document import read_document
    from armproof.verification.report.html.prose import plain_title

    found = []
    try:
        for source in order.sources:
            lesson, arm = _open(order, source), read_document(source).front.get("arm")
            title = plain_title(lesson.title)
            found.append(Neighbour(lesson.number, title, source.stem, arm if arm in arm_names() else "", order.suffix))
    except ArmproofError as error:
        raise SiteError(str(error)) from None
    return found


def build_lesson(order: Order, described: Sequence[Neighbour], index: int, folder: Path) -> Built:
    """Write the page of a lesson and the student's notebook; no exception of ours leaves this function."""
    source = order.sources[index]
    try:
        with use(order.lang):
            return Built(source, _write_lesson(order, described, index, folder))
    except ArmproofError as error:
        return Built(source, problem=str(error))
    except Exception as error:  # one lesson that fails does not hide what is wrong with the others
        return Built(source, problem=f"{source}: internal error of Armproof: {type(error).__name__}: {error}")


def build_rest(order: Order, described: Sequence[Neighbour], folder: Path) -> None:
    """Write the index, the glossary, and with the first language the 3D views of the arms in all."""
    from armproof.course.site.arms import write_views
    from armproof.course.site.glossary import GLOSSARY, write_glossary
    from armproof.course.site.index import write_index
    from armproof.course.site.page import INDEX

    lessons = [_open(order, source) for source in order.sources]
    with use(order.lang):
        index = write_index(list(zip(lessons, described, strict=True)), order)
        glossary = write_glossary(order)
    (folder / f"{INDEX}{order.suffix}.html").write_text(index, encoding="utf-8")
    if glossary:
        (folder / f"{GLOSSARY}{order.suffix}.html").write_text(glossary, encoding="utf-8")
    if not order.suffix:
        write_views(
            sorted({each.arm for each in described if each.arm}),
            folder,
            {lang: ending_of(lang, order.langs) for lang in order.langs},
        )


def _write_lesson(order: Order, described: Sequence[Neighbour], index: int, folder: Path) -> tuple[str, ...]:
    from armproof.course.site.cells import execute
    from armproof.course.site.page import write_page
    from armproof.course.sources.editions import student_notebook
    from armproof.course.sources.lesson_source import read_lesson_source
    from armproof.course.translation.documents import in_language
    from armproof.verification.check import check_document
    from armproof.verification.document import parse_document

    path, me = order.sources[index], described[index]
    source = read_lesson_source(path, order.lang)
    cells = execute(source, order.place, solved=order.solutions)
    document = parse_document(path, in_language(path, path.read_text(encoding="utf-8"), order.lang))
    html, warnings = write_page(_open(order, path), cells, document, check_document(document), described, order)
    (folder / me.page).write_text(html, encoding="utf-8")
    (folder / me.notebook).write_bytes(student_notebook(source))
    return warnings


def _open(order: Order, source: Path) -> Lesson:
    from armproof.course.feedback import open_lesson

    return open_lesson(source.stem.partition("_")[2], None if order.place.is_course else order.place.root, order.lang)
