"""What the processes of a build do: open the lessons, build one page, build the index and the 3D views."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.course.errors import SiteError
from armproof.course.sources.places import COURSE, Place
from armproof.models.errors import ArmproofError

if TYPE_CHECKING:
    from armproof.course.feedback import Lesson


@dataclass(frozen=True)
class Order:
    """What is to be built: sources in the order of the lessons, their place, the edition."""

    sources: tuple[Path, ...]
    place: Place = COURSE
    solutions: bool = False


@dataclass(frozen=True)
class Built:
    """What became of a lesson: what of it is not on its page, and why there is no page."""

    source: Path
    warnings: tuple[str, ...] = ()
    problem: str = ""


@dataclass(frozen=True)
class Described:
    """What every page needs to know of a lesson: its number, its plain title, and its arm, if that is one of the catalogue."""

    number: int
    title: str
    stem: str
    arm: str


def describe(order: Order) -> list[Described]:
    """Return what is known of each lesson before it is executed; raises SiteError."""
    from armproof.course.site.page import neighbour
    from armproof.models.catalogue import arm_names
    from armproof.verification.document import read_document

    found = []
    try:
        for source in order.sources:
            me = neighbour(_open(order, source), source)
            arm = read_document(source).front.get("arm")
            found.append(Described(me.number, me.title, me.stem, arm if arm in arm_names() else ""))
    except ArmproofError as error:
        raise SiteError(str(error)) from None
    return found


def build_lesson(order: Order, described: Sequence[Described], index: int, folder: Path) -> Built:
    """Write the page of a lesson and the student's notebook; no exception of ours leaves this function."""
    source = order.sources[index]
    try:
        return Built(source, _write_lesson(order, described, index, folder))
    except ArmproofError as error:
        return Built(source, problem=str(error))
    except Exception as error:  # one lesson that fails does not hide what is wrong with the others
        return Built(source, problem=f"{source}: internal error of Armproof: {type(error).__name__}: {error}")


def build_rest(order: Order, described: Sequence[Described], folder: Path) -> None:
    """Write the index and the 3D views of the arms."""
    from armproof.course.site.arms import write_views
    from armproof.course.site.index import Listed, write_index
    from armproof.course.site.page import INDEX, neighbour

    listed = [
        Listed(lesson, neighbour(lesson, source), each.arm)
        for source, each in zip(order.sources, described, strict=True)
        for lesson in [_open(order, source)]
    ]
    (folder / INDEX).write_text(write_index(listed, solutions=order.solutions), encoding="utf-8")
    write_views(sorted({each.arm for each in described if each.arm}), folder)


def _write_lesson(order: Order, described: Sequence[Described], index: int, folder: Path) -> tuple[str, ...]:
    from armproof.course.site.cells import execute
    from armproof.course.site.page import Neighbour, Surroundings, write_page
    from armproof.course.sources.editions import student_notebook
    from armproof.course.sources.lesson_source import read_lesson_source
    from armproof.verification.check import check_document
    from armproof.verification.document import read_document

    path = order.sources[index]
    source = read_lesson_source(path)
    cells = execute(source, order.place, solved=order.solutions)
    document = read_document(path)
    all_ = [Neighbour(each.number, each.title, each.stem) for each in described]
    others = [each for each in all_ if each.stem != path.stem]
    pages = {name: each.page for each in others for name in (each.stem, each.stem.partition("_")[2], str(each.number))}
    around = Surroundings(all_[index - 1] if index else None, all_[index + 1] if index + 1 < len(all_) else None, pages)
    written = write_page(
        _open(order, path), cells, document, check_document(document), around, solutions=order.solutions
    )
    (folder / all_[index].page).write_text(written.html, encoding="utf-8")
    (folder / all_[index].notebook).write_bytes(student_notebook(source))
    return written.warnings


def _open(order: Order, source: Path) -> Lesson:
    from armproof.course.feedback import open_lesson

    return open_lesson(source.stem.partition("_")[2], None if order.place.is_course else order.place.root)
