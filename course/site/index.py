"""The index of the site: the lessons with their objectives, and the arms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from armproof.course.feedback import Lesson
from armproof.course.site.arms import picture_of, view_name
from armproof.course.site.page import SITE, Neighbour
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.naming.names import read_names
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


@dataclass(frozen=True)
class Listed:
    """What the index says of a lesson: what it declares, its files, and the name of its arm, empty without one of the catalogue."""

    lesson: Lesson
    files: Neighbour
    arm: str


def write_index(listed: Sequence[Listed], *, solutions: bool = False) -> str:
    """Return the page that lists the lessons."""
    arms = {each.arm: load_arm(each.arm) for each in listed if each.arm}
    rows = [(each.arm, _row(each, arms.get(each.arm))) for each in listed]
    return SITE.render(
        "index.html",
        rows=[row for _, row in rows],
        total=sum(row.tasks for _, row in rows),
        arms=[
            ArmRow(arm.title, picture_of(arm), tuple(row for of, row in rows if of == name), view_name(arm))
            for name, arm in arms.items()
        ],
        solutions=solutions,
        versions=versions(),
    )


def _row(listed: Listed, arm: Arm | None) -> Row:
    lesson, read = listed.lesson, _reader(arm)
    return Row(
        lesson.number,
        title(lesson.title, read),
        tuple(title(line, read) for line in lesson.objectives),
        len(lesson.tasks),
        arm.title if arm is not None else "",
        title(lesson.source, read),
        listed.files.page,
        listed.files.notebook,
    )


def _reader(arm: Arm | None) -> Read:
    return read_names(arm, {}).reader.read
