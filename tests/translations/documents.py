"""What lessons, their tasks and handouts say, found in their sources: a catalogue each."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from armproof.course.feedback import Lesson, open_lesson
from armproof.course.feedback.slope import REVIEW
from armproof.course.feedback.translation import changed_task
from armproof.course.sources.places import COURSE
from armproof.course.translation.documents import prose_of
from armproof.verification.document.catalogue import catalogue_file
from armproof.verification.document.prose import Prose, read_prose
from tests.translations.catalogues import Message

DOCUMENTS = (*COURSE.sources(), *sorted((COURSE.root / "handouts").glob("*.md")))


def said_in(document: Path) -> list[Message]:
    """Return what a document says, and the tasks of a lesson: each piece of prose once."""
    found = [(document.name, piece) for piece in prose_of(document, document.read_text(encoding="utf-8"))]
    if document.suffix == ".py":
        found += _said_by(open_lesson(document.stem.partition("_")[2], lang="en"))
    messages: dict[str, Message] = {}
    for place, piece in found:
        remarks = tuple(f"{{{number}}} = {text}" for number, text in enumerate(piece.kept, 1))
        messages.setdefault(piece.text, Message(piece.text, place, remarks=remarks))
    return list(messages.values())


def catalogue_of(document: Path, lang: str) -> Path:
    return catalogue_file(document, lang)


def _said_by(lesson: Lesson) -> Iterator[tuple[str, Prose]]:
    """Yield what a lesson's tasks say: all that would be changed for another language."""
    found: list[tuple[str, str]] = [("the lesson", text) for text in (lesson.title, *lesson.objectives, lesson.source)]
    said = [task for task in lesson.tasks if task.name != REVIEW]  # which speaks in its own lesson
    for task in (*said, *(task.own(str(seed)) for task in said if task.own for seed in range(12))):
        changed_task(task, lambda text, place=f"task {task.name}": found.append((place, text)) or text)  # type: ignore[misc]
    for place, text in found:
        if (piece := read_prose(text)).has_words:
            yield re.sub(r"\W+", "_", place), piece
