"""Write the solved source of a new lesson, and what it says around its tasks."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import yaml

from armproof.course.authoring.beginning.drafts import Draft
from armproof.course.authoring.beginning.module_text import Heading, joints, lengths, python_rows
from armproof.course.sources.solutions import BEGIN, END

_JUPYTER = """# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---
"""


def write_source(heading: Heading, drafts: Sequence[Draft], front: Mapping[str, Any], folder: str = "") -> str:
    """Return the text of lessons/NN_name.py.

    Args:
        front: what the front matter says beside the title.
        folder: for `open_lesson`, where the lesson is none of the course.
    """
    cells = [
        _JUPYTER,
        "# %% [raw]\n" + _commented(f"---\n{_yaml({'title': heading.title, **front})}---"),
        _text(_opening(heading, drafts[0].name)),
        _opened(heading, folder),
        *_figure(heading, drafts),
        *(cell for draft in drafts for cell in _task(heading, draft)),
        _text(
            "## Limits\n\nWhere does what you have derived stop being true? For which joint values, for which lengths?"
        ),
        _text("## Further\n\nWrite here what a student may read next."),
    ]
    return "\n\n".join(cell.rstrip("\n") for cell in cells) + "\n"


def _opening(heading: Heading, first: str) -> str:
    source = f"\n\nSource: {heading.source}" if heading.source else ""
    return (
        f"# {heading.number} · {heading.title}{source}\n\n"
        "Predict before you compute: sketch the arm at a configuration of your own. Which entries of what is asked below will be "
        f"zero there?\n\nAn answer may be a Python function, a SymPy expression or a LaTeX string. `lesson.{first}.hint()` gives "
        "a hint, one more at each call."
    )


def _opened(heading: Heading, folder: str) -> str:
    where = f', folder="{folder}"' if folder else ""
    return f'# %%\nimport numpy as np\n\nfrom armproof import open_lesson\n\nlesson = open_lesson("{heading.name}"{where})\nlesson'


def _figure(heading: Heading, drafts: Sequence[Draft]) -> Iterator[str]:
    """Yield the cell that draws the arm with its frames, where a name or a task leads to the arm."""
    if isinstance(heading.spec, str):
        arm, imports = f'load_arm("{heading.spec}")', "from armproof import load_arm\n"
    elif asked := [draft.name for draft in drafts if draft.exact is not None]:
        arm, imports = f"lesson.{asked[0]}.asks.loaded", ""
    else:
        return
    yield _text("## The arm\n\nThe frames are those of the tasks below.")
    yield f"# %%\n{imports}from armproof.course.figures.kinds.sketch import sketch\n\nsketch({arm}, table=False)"


def _task(heading: Heading, draft: Draft) -> Iterator[str]:
    yield _text(f"## Task: {draft.title[0].lower()}{draft.title[1:]}\n\n{draft.text}")
    yield "# %%\n" + (_function(heading, draft) if draft.has_function else _formula(draft))
    if draft.exact is not None:
        yield f"# %%\nlesson.{draft.name}.show({draft.name})"


def _function(heading: Heading, draft: Draft) -> str:
    own = lengths(heading.arm, draft)
    variables = joints(heading.arm)
    rows = python_rows(draft, "    ").replace("m.", "np.")
    assert draft.exact is not None
    shape = f"{len(draft.exact.cells)} × {len(draft.exact.cells[0])}"
    return (
        f"def {draft.name}({', '.join(['q', *own])}):\n"
        f'    """Return what is asked, {shape}; q holds {", ".join(variables)}."""\n'
        f"    {BEGIN}\n"
        f"    {', '.join(variables)}{',' if len(variables) == 1 else ''} = q\n"
        f"    return np.array({rows})\n"
        f"    {END}\n\n\n"
        f"lesson.{draft.name}.check({draft.name})"
    )


def _formula(draft: Draft) -> str:
    return f'{BEGIN}\n{draft.name} = r"{draft.latex}"\n{END}\nlesson.{draft.name}.check({draft.name})'


def _text(markdown: str) -> str:
    return "# %% [markdown]\n" + _commented(markdown)


def _commented(text: str) -> str:
    return "\n".join(f"# {line}".rstrip() for line in text.split("\n"))


def _yaml(front: Mapping[str, Any]) -> str:
    """Return a front matter, each key on a line of its own."""
    return "".join(f"{key}: {_flow(value)}\n" for key, value in front.items())


def _flow(value: Any) -> str:
    if isinstance(value, str):
        return value if value.isidentifier() else json.dumps(value, ensure_ascii=False)
    return yaml.safe_dump(value, sort_keys=False, allow_unicode=True, width=10**6, default_flow_style=True).strip()
