"""The index of the site: the lessons with their objectives, and the arms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from armproof.course.feedback import Lesson
from armproof.course.site.arms import picture_of, view_name
from armproof.course.site.glossary import glossary_page
from armproof.course.site.order import Neighbour, Order, switches
from armproof.course.site.page import INDEX, SITE
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.language import look_up
from armproof.verification.naming.reading import read_names
from armproof.verification.report.html.figures import Figure
from armproof.verification.report.html.prose import title
from armproof.verification.report.html.templating import versions


@dataclass(frozen=True)
class Row:
    """A lesson in the index."""

    number: int
    title: Markup
    objectives: tuple[Markup, ...]
    tasks: int
    effort: str
    arm: str
    source: Markup
    page: str
    notebook: str


@dataclass(frozen=True)
class ArmRow:
    """An arm in the index: its picture, the lessons about it, and the file of its 3D view."""

    title: str
    figure: Figure | None
    lessons: tuple[Row, ...]
    view: str


def write_index(listed: Sequence[tuple[Lesson, Neighbour]], order: Order) -> str:
    """Return the page that lists the lessons, each with its files and its arm."""
    arms = {files.arm: load_arm(files.arm) for _, files in listed if files.arm}
    rows = [(files.arm, _row(lesson, files, arms.get(files.arm))) for lesson, files in listed]
    return SITE.render(
        "index.html",
        rows=[row for _, row in rows],
        total=sum(row.tasks for _, row in rows),
        arms=[
            ArmRow(look_up(arm.title), picture_of(arm), tuple(row for of, row in rows if of == name), view)
            for name, arm in arms.items()
            for view in [view_name(arm, order.suffix)]
        ],
        solutions=order.solutions,
        switches=switches(order.langs, order.lang, INDEX),
        glossary=glossary_page(order),
        versions=versions(),
    )


def _row(lesson: Lesson, files: Neighbour, arm: Arm | None) -> Row:
    read, name = read_names(arm, {}).reader.read, look_up(arm.title) if arm is not None else ""
    objectives = tuple(title(line, read) for line in lesson.objectives)
    source, tasks = title(lesson.source, read), len(lesson.tasks)
    return Row(
        lesson.number,
        title(lesson.title, read),
        objectives,
        tasks,
        lesson.effort,
        name,
        source,
        files.page,
        files.notebook,
    )
