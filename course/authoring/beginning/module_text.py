"""Write the module of a lesson's tasks."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from armproof.course.authoring.beginning.code import raw, written
from armproof.course.authoring.beginning.drafts import Draft
from armproof.models.arm import Arm

_HEAD = '''"""Tasks of lesson {number}, {title}; begun by `armproof lesson new`."""

from __future__ import annotations

{imports}

ARM = {arm}

'''
_FUNCTION = '''
def _{name}(m, {arguments}):  # type: ignore[no-untyped-def]
    return {rows}


def {name}({arguments}):  # type: ignore[no-untyped-def]
    """Return what the task asks, in NumPy."""
{unpack}    return np.array(_{name}(np, {passed}))


def _{name}_in_sympy(sp):  # type: ignore[no-untyped-def]
    return sp.Matrix(_{name}(sp, *sp.symbols("{symbols}", seq=True)))

'''


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
    asked = sorted({draft.asks_text.partition("(")[0] for draft in drafts})
    names = ", ".join(sorted(["Lesson", "Task", "Wrong", *asked, *(["WithSympy"] if functions else [])]))
    imports = ("import numpy as np\n\n" if functions else "") + f"from armproof.course.feedback import {names}"
    text = _HEAD.format(number=heading.number, title=_plain(heading.title), imports=imports, arm=written(heading.spec))
    for draft in drafts:
        if draft.has_function:
            text += function_text(heading.arm, draft)
        text += f"\n{_constant(draft)} = {raw(draft.latex)}\n\n"
    return text + "\n".join(_lesson(heading, drafts)) + "\n"


def function_text(arm: Arm, draft: Draft) -> str:
    """Return the answer as three Python functions: of any module's cosine, in NumPy, in SymPy."""
    inner, outer = _arguments(arm, draft)
    unpack = f"    {', '.join(joints(arm))}{',' if len(arm.joints) == 1 else ''} = q\n"
    rows = python_rows(draft, "    ")
    return (
        _FUNCTION.replace("{arguments}", ", ".join(inner), 1)
        .replace("{arguments}", ", ".join(outer), 1)
        .format(name=draft.name, rows=rows, unpack=unpack, passed=", ".join(inner), symbols=" ".join(inner))
    )


def python_rows(draft: Draft, indent: str) -> str:
    """Return the answer as a list of rows of Python, of the functions of `m`."""
    assert draft.exact is not None and draft.exact.python is not None
    rows = "".join(f"{indent}    [{', '.join(row)}],\n" for row in draft.exact.python)
    return f"[\n{rows}{indent}]"


def joints(arm: Arm) -> list[str]:
    """Return the joint variables of an arm, from the base on."""
    return [joint.symbol for joint in arm.joints]


def lengths(arm: Arm, draft: Draft) -> list[str]:
    """Return the lengths that an answer is made of."""
    assert draft.exact is not None
    return [name for name in draft.exact.names if name not in joints(arm)]


def _arguments(arm: Arm, draft: Draft) -> tuple[list[str], list[str]]:
    own = lengths(arm, draft)
    return [*joints(arm), *own], ["q", *own]


def _constant(draft: Draft) -> str:
    return draft.name.upper()


def _lesson(heading: Heading, drafts: Sequence[Draft]) -> Iterator[str]:
    yield "\nLESSON = Lesson("
    yield f"    number={heading.number},"
    yield f"    name={written(heading.name)},"
    yield f"    title={written(heading.title)},"
    yield "    objectives=("
    yield from (f"        {written(_objective(draft))}," for draft in drafts[:3])
    yield "    ),"
    if heading.source:
        yield f"    source={written(heading.source)},"
    yield "    tasks=("
    for draft in drafts:
        yield from _task(draft)
    yield "    ),"
    yield ")"


def _objective(draft: Draft) -> str:
    return f"Work out {draft.title[0].lower()}{draft.title[1:]}."


def _task(draft: Draft) -> Iterator[str]:
    yield "        Task("
    yield f"            name={written(draft.name)},"
    yield f"            title={written(draft.title)},"
    yield f"            text={written(draft.text)},"
    yield f"            asks={draft.asks_text},"
    yield "            hints=("
    yield from (f"                {written(hint)}," for hint in _hints(draft))
    yield "            ),"
    yield "            right=("
    if draft.has_function:
        yield f"                {draft.name},"
        yield f"                WithSympy(_{draft.name}_in_sympy),"
    yield f"                {_constant(draft)},"
    yield from (f"                {raw(form)}," for form in draft.others)
    yield "            ),"
    yield "            wrong=("
    yield from (f"                Wrong({_changed(draft, latex)}, {written(words)})," for latex, words in draft.wrong)
    yield "            ),"
    yield "        ),"


def _hints(draft: Draft) -> Iterator[str]:
    if "jacobian" in draft.asks_text:
        yield "A revolute joint gives $v = z \\times (p_e - p)$ and $\\omega = z$, a slide $v = z$ and $\\omega = 0$."
    elif draft.exact is not None:
        yield "Write the link matrix of each joint, and multiply them from the base on."
    else:
        yield "Which formula of the course leads there? Write it down before putting in what this arm has."
    if draft.exact is not None:
        cells = [(r, c, cell) for r, row in enumerate(draft.exact.cells, 1) for c, cell in enumerate(row, 1)]
        row, column, cell = max(cells, key=lambda found: len(found[2]))
        yield f"The longest entry, ({row}, {column}), is ${cell}$."


def _changed(draft: Draft, latex: str) -> str:
    """Return a wrong answer as a change of the right one's entry, where that says it; else as it is."""
    before, after = _entries(draft.latex), _entries(latex)
    changed = [(old, new) for old, new in zip(before, after, strict=False) if old != new]
    if len(before) == len(after) and len(changed) == 1:
        (old, new) = changed[0]
        for left, right in (("", ""), ("& ", ""), ("", " &"), ("& ", " &"), (r"\\ ", ""), ("", r" \\")):
            if draft.latex.replace(f"{left}{old}{right}", f"{left}{new}{right}", 1) == latex and old != draft.latex:
                return f"{_constant(draft)}.replace({raw(left + old + right)}, {raw(left + new + right)}, 1)"
    return raw(latex)


def _entries(latex: str) -> list[str]:
    inside = re.sub(r"^\\begin\{\w+\} | \\end\{\w+\}$", "", latex)
    return re.split(r" & | \\\\ ", inside)


def _plain(title: str) -> str:
    return title.replace("\\", "").replace('"', "'")
