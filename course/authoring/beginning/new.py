"""Begin a lesson: a source and its tasks, for an arm and perhaps a document."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from armproof.course.authoring.beginning.drafts import Draft, drafts_of_arm
from armproof.course.authoring.beginning.from_document import drafts_of_document
from armproof.course.authoring.beginning.texts import Heading, write_module, write_source
from armproof.course.authoring.checking.building import student_files, write_stale
from armproof.course.errors import AuthoringError
from armproof.course.sources.lesson_source import FILE
from armproof.course.sources.places import Place
from armproof.models.catalogue import arm_names, load_arm
from armproof.verification.document import Document, read_document

RESERVED = ("lesson", "lessons", "tasks", "notebooks")


def new_lesson(place: Place, name: str, arm: str | None, document: Path | None = None, title: str = "") -> list[Path]:
    """Write the source, the tasks and the notebook of a new lesson; return the three files.

    Args:
        place: where it goes.
        name: a Python identifier in lower case.
        arm: an arm of `models/`; None takes the document's.
        document: a document whose proved displays become tasks.
        title: by default the document's, or the name in words.

    Raises:
        AuthoringError: a bad name, a lesson that there is already, no arm, an arm or document that does not serve.
        ArmproofError: the document cannot be read.
    """
    check_name(place, name)
    read = read_document(document) if document is not None else None
    spec = _arm_of(read, arm)
    loaded = load_arm(spec)
    drafts = (drafts_of_document(read, loaded) if read is not None else []) or drafts_of_arm(loaded, spec)
    if not drafts:
        raise AuthoringError("no task can be made for arm '{loaded}': what it would ask is too long to be typed", loaded=loaded.name)  # fmt: skip
    front = dict(read.front) if read is not None else {}
    heading = Heading(_next_number(place), name, title or str(front.get("title", "")) or _words(name), loaded, spec, str(front.get("source", "")))  # fmt: skip
    return _write(place, heading, drafts, front)


def check_name(place: Place, name: str) -> None:
    """Raise AuthoringError where a lesson cannot be called so, or is already."""
    rule = "a lesson is named by lower-case letters, digits and underscores, beginning with a letter"
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name) or name in RESERVED:
        likely = re.sub(r"[^a-z0-9]+", "_", re.sub(r"^\d+", "", name.lower()).removesuffix(".py")).strip("_0123456789")
        example = likely if likely and not keyword.iskeyword(likely) and likely not in RESERVED else "my_arm_jacobian"
        raise AuthoringError("'{name}' is no name for a lesson: {rule}, such as {example}", name=name, rule=rule, example=example)  # fmt: skip
    taken = [source for source in place.sources() if source.stem.partition("_")[2] == name]
    taken += [path for path in (place.tasks / f"{name}.py",) if path.exists()]
    if taken:
        raise AuthoringError("{place}: there is a lesson '{name}' already; remove it or choose another name", place=taken[0], name=name)  # fmt: skip


def _arm_of(document: Document | None, arm: str | None) -> Any:
    """Return how the lesson's tasks name their arm: a folder of models/, or a document's DH table."""
    spec = arm if arm is not None else document.front.get("arm") if document is not None else None
    known = ", ".join(arm_names())
    if spec is None:
        raise AuthoringError("which arm is the lesson about? Say --arm ARM, one of {known}", known=known)
    if document is not None and arm is not None and document.front.get("arm") not in (None, arm):
        raise AuthoringError("{path} is about another arm; leave --arm out", path=document.path)
    if isinstance(spec, str) and spec not in arm_names():
        raise AuthoringError("no arm '{spec}'; a lesson is about {known}, or the DH table of its document", spec=spec, known=known)  # fmt: skip
    return spec


def _next_number(place: Place) -> int:
    numbers = [int(found["number"]) for path in place.sources() if (found := FILE.fullmatch(path.name))]
    return max(numbers, default=0) + 1


def _words(name: str) -> str:
    return name.replace("_", " ").capitalize()


def _write(place: Place, heading: Heading, drafts: list[Draft], front: Mapping[str, Any]) -> list[Path]:
    kept = {key: front[key] for key in ("source", "symbols", "transforms", "quantities") if key in front}
    source = place.lessons / f"{heading.number:02}_{heading.name}.py"
    text = write_source(heading, drafts, {"arm": heading.spec, **kept}, "" if place.is_course else "..")
    tasks = place.tasks / f"{heading.name}.py"
    write_stale({tasks: write_module(heading, drafts).encode(), source: text.encode()})
    notebooks = student_files(place, [source])
    write_stale(notebooks)
    return [source, tasks, *notebooks]
