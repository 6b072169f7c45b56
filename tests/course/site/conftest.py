"""A tiny course of one lesson, its page from ready-made outputs, and a browser."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import pytest

from armproof.course.feedback import open_lesson
from armproof.course.site.cells import cells_of, with_outputs
from armproof.course.site.order import Neighbour, Order
from armproof.course.site.page import write_page
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.course.sources.places import Place
from armproof.verification.check import check_document
from armproof.verification.document import read_document

SECRET = "a_1 a_2 sin(theta_2) is the secret"
TASKS = '''"""Tasks."""

from armproof.course.feedback import Lesson, Number, Task

LESSON = Lesson(
    number=3,
    name="{name}",
    title={title!r},
    objectives=({objective!r}, "Read $p_2$ off."),
    source="A source & its author",
    tasks=(
        Task("rank", "The rank of $J$", "What is the rank of $J$ at\\n\\n$$ \\\\theta_2 = 0 $$", Number(1),
             ("Look at $\\\\theta_2$.", "Two columns are parallel."), (1, 1.0, "1")),
        Task("length", "The length", "How long is link 1?", Number(0.45, "m"), (), (0.45, 9 / 20, "0.45")),
    ),
)
'''
LESSON = r'''# %% [raw]
# ---
# title: {title}
# arm: planar_2r
# quantities:
#   "p_2": {{origin: 2}}
# ---

# %% [markdown]
# # 3 · The planar arm
#
# A first paragraph with $\theta_1$ in it. {words}

# %%
from armproof import open_lesson

lesson = open_lesson("{name}", "..")
lesson

# %% [markdown]
# ## Where the tool is
#
# $$ p_2 = \begin{{bmatrix}} l_1 C_1 + l_2 C_{{12}} \\ l_1 S_1 + l_2 S_{{12}} \\ 0 \end{{bmatrix}} $$
#
# > **Erratum** (page 1)
# > $$ \cos(\theta_1 + \theta_2) = \cos\theta_1 + \cos\theta_2 $$
#
# | joint | kind |
# |---|---|
# | 1 | revolute |
#
# See [the next one](04_other.ipynb) and [a page](https://example.org/x).

# %%
def rank(q):  # a comment
    """Return the rank."""
    ### BEGIN SOLUTION
    found = 1  # {secret}
    return found
    ### END SOLUTION


print("rank:", rank(0) and 2 > 1)
lesson.rank.check(rank(0))

# %%
### BEGIN SOLUTION
answer = 0.45
### END SOLUTION
lesson.length.check(answer)

# %% [markdown]
# > **Solution**
# > {secret}, once more.
#
# ## Further
#
# ```python
# lesson.rank.hint()
# ```
'''
NOT_ATTEMPTED = {
    "output_type": "execute_result",
    "data": {
        "text/html": "<style>.ap{color:red}</style><div class='armproof'>not attempted</div>",
        "text/plain": "○ rank: not attempted – no answer yet",
    },
}
RIGHT = {
    "output_type": "execute_result",
    "data": {
        "text/html": "<style>.armproof { color: inherit; }</style><div class='armproof ap-right'><p>correct (proved)</p></div>",
        "text/plain": "✓ rank: correct (proved)",
    },
}
STREAM = {"output_type": "stream", "name": "stdout", "text": "rank: None\n"}
_names = (f"tiny_{number}" for number in itertools.count())  # a lesson is opened once in a process


@pytest.fixture(scope="session")
def lesson(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., tuple[LessonSource, Place]]:
    """Write a lesson and its tasks, into a place of its own or into one that there is."""

    def write(
        title: str = "The planar arm",
        words: str = "",
        objective: str = "Find $p_2$.",
        source: str = LESSON,
        place: Place | None = None,
    ) -> tuple[LessonSource, Place]:
        name = next(_names)
        place = place or Place(tmp_path_factory.mktemp("course"))
        for folder in (place.lessons, place.tasks):
            folder.mkdir(exist_ok=True)
        tasks = TASKS.format(name=name, title=title, objective=objective)
        (place.tasks / f"{name}.py").write_text(tasks, encoding="utf-8")
        path = place.lessons / f"03_{name}.py"
        text = source.format(name=name, title=repr(title).replace("\\", ""), words=words, secret=SECRET)
        path.write_text(text, encoding="utf-8")
        return read_lesson_source(path), place

    return write


@pytest.fixture(scope="session")
def page(lesson: Callable[..., tuple[LessonSource, Place]]) -> Callable[..., str]:
    """Return the page of the tiny lesson; its cells gave the outputs given, by their places."""

    def make(
        outputs: Mapping[int, Sequence[Mapping[str, Any]]] | None = None, *, solutions: bool = False, **changes: str
    ) -> str:
        source, place = lesson(**changes)
        cells = with_outputs(cells_of(source), outputs or {})
        document = read_document(source.path)
        me, other = Neighbour(3, "The planar arm", source.path.stem), Neighbour(4, "Another <lesson>", "04_other")
        result, opened = check_document(document, confirm=False), open_lesson(source.name, place.root)
        return write_page(opened, cells, document, result, (me, other), Order((source.path,), place, solutions))[0]

    return make
