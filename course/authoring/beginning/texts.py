"""Write a new lesson: its solved source, and the module of its tasks; what they look like is in the templates."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import yaml
from jinja2 import Environment, PackageLoader, StrictUndefined

from armproof.course.authoring.beginning.drafts import Draft
from armproof.course.authoring.beginning.python_text import raw_string, written
from armproof.course.sources.solutions import BEGIN, END
from armproof.models.arm import Arm
from armproof.models.errors import written as sentence
from armproof.models.language import ENGLISH, spoken


@dataclass(frozen=True)
class Heading:
    """What a new lesson is called and what it is about."""

    number: int
    name: str
    title: str
    arm: Arm
    spec: Any
    source: str = ""


def write_module(heading: Heading, drafts: Sequence[Draft]) -> str:
    """Return the text of tasks/<name>.py."""
    functions = any(draft.has_function for draft in drafts)
    asked = {draft.asks_text.partition("(")[0] for draft in drafts}
    names = sorted({"Lesson", "Task", "Wrong", *asked, *(["WithSympy"] if functions else [])})
    return _render("tasks.py.jinja", heading, drafts, functions=functions, names=names)


def write_source(heading: Heading, drafts: Sequence[Draft], front: Mapping[str, Any], folder: str = "") -> str:
    """Return the text of lessons/NN_name.py.

    Args:
        front: what the front matter says beside the title.
        folder: for `open_lesson`, where the lesson is none of the course.
    """
    lang = {} if spoken() == ENGLISH else {"lang": spoken()}
    matter = "\n".join(f"{key}: {_flow(value)}" for key, value in {"title": heading.title, **lang, **front}.items())
    return _render("lesson.py.jinja", heading, drafts, front=matter, folder=folder, begin=BEGIN, end=END)


def _render(template: str, heading: Heading, drafts: Sequence[Draft], **values: Any) -> str:
    variables = [joint.symbol for joint in heading.arm.joints]

    def lengths(draft: Draft) -> list[str]:
        return [name for name in draft.exact.names if name not in variables] if draft.exact is not None else []

    common = {
        "lang": "" if spoken() == ENGLISH else spoken(),
        "heading": heading,
        "drafts": drafts,
        "variables": variables,
        "lengths": lengths,
    }
    return _environment().get_template(template).render(**common, **values)


@cache
def _environment() -> Environment:
    environment = Environment(
        loader=PackageLoader("armproof.course.authoring.beginning"), undefined=StrictUndefined, trim_blocks=True,
        lstrip_blocks=True, keep_trailing_newline=True, autoescape=False,
    )  # fmt: skip
    environment.filters |= {"python": written, "raw_string": raw_string, "commented": _commented}
    environment.globals |= {"changed": _changed, "longest_entry": _longest_entry, "_": sentence}
    return environment


def _commented(text: str) -> str:
    return "\n".join(f"# {line}".rstrip() for line in text.split("\n"))


def _flow(value: Any) -> str:
    """Return a value of a front matter on one line."""
    if isinstance(value, str):
        return value if value.isidentifier() else json.dumps(value, ensure_ascii=False)
    return yaml.safe_dump(value, sort_keys=False, allow_unicode=True, width=10**6, default_flow_style=True).strip()


def _longest_entry(draft: Draft) -> str:
    assert draft.exact is not None
    cells = [(r, c, cell) for r, row in enumerate(draft.exact.cells, 1) for c, cell in enumerate(row, 1)]
    row, column, cell = max(cells, key=lambda found: len(found[2]))
    return sentence("The longest entry, {place}, is {entry}.", place=f"({row}, {column})", entry=f"${cell}$")


def _changed(draft: Draft, latex: str) -> str:
    """Return a wrong answer as a change of the right one's entry, where that says it; else as it is."""
    before, after = _entries(draft.latex), _entries(latex)
    changed = [(old, new) for old, new in zip(before, after, strict=False) if old != new]
    if len(before) == len(after) and len(changed) == 1:
        (old, new) = changed[0]
        for left, right in (("", ""), ("& ", ""), ("", " &"), ("& ", " &"), (r"\\ ", ""), ("", r" \\")):
            if draft.latex.replace(f"{left}{old}{right}", f"{left}{new}{right}", 1) == latex and old != draft.latex:
                sides = (raw_string(left + side + right) for side in (old, new))
                return f"{draft.name.upper()}.replace({', '.join(sides)}, 1)"
    return raw_string(latex)


def _entries(latex: str) -> list[str]:
    inside = re.sub(r"^\\begin\{\w+\} | \\end\{\w+\}$", "", latex)
    return re.split(r" & | \\\\ ", inside)
