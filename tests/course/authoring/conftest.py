"""A small lesson of the tests' own, with one function, one formula and one number to give."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from armproof.course.sources.places import Place

SOURCE = '''# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [raw]
# ---
# title: "Small"
# arm: planar_2r
# ---

# %% [markdown]
# # 3 · Small
#
# $$ \\cos^2\\theta_1 + \\sin^2\\theta_1 = 1 $$
#
# > **Erratum** (as printed)
# > $$ \\sin(-\\theta_1) = \\sin\\theta_1 $$

# %%
from armproof import open_lesson

lesson = open_lesson("small", folder="..")
lesson


# %%
def area(a, b):
    """Return the area of a rectangle with a corner cut off."""
    ### BEGIN SOLUTION
    corner = a**2 / 2
    return a * b - corner
    ### END SOLUTION


lesson.area.check(area)

# %%
### BEGIN SOLUTION
shift = 1
root = r"a + b"
### END SOLUTION
lesson.root.check(root)

# %%
### BEGIN SOLUTION
joints = 2
### END SOLUTION
lesson.joints.check(joints)
'''
TASKS = '''"""Tasks of the small lesson."""

from armproof.course.feedback import Formula, Lesson, Number, Task, Wrong


def area(a, b):
    return a * b - a**2 / 2


LESSON = Lesson(
    number=3,
    name="small",
    title="Small",
    objectives=("One.", "Two.", "Three."),
    tasks=(
        Task(
            name="area",
            title="Area",
            text="What is left?",
            asks=Formula(r"a b - \\frac{a^2}{2}", ("a", "b")),
            hints=("Half a square is cut off.",),
            right=(area, r"a (b - \\frac{a}{2})"),
            wrong=(Wrong(r"a b - a^2", "half a square", own=True),),
        ),
        Task(
            name="root",
            title="Root",
            text="The square root of a² + 2ab + b²?",
            asks=Formula(r"a + b", ("a", "b")),
            hints=(),
            right=("b + a",),
            wrong=(Wrong("a - b", "sign"),),
        ),
        Task(
            name="joints",
            title="Joints",
            text="How many?",
            asks=Number(2),
            hints=(),
            right=(2, "2"),
            wrong=(Wrong(3, "3"),),
        ),
    ),
)
'''


@pytest.fixture
def lesson(tmp_path: Path) -> Callable[..., tuple[Place, Path]]:
    """Write the small lesson, its source and its tasks changed as asked; return its place and its source."""

    def write(*changes: tuple[str, str], tasks: tuple[str, str] = ("", "")) -> tuple[Place, Path]:
        text = SOURCE
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        place = Place(tmp_path / "own")
        for folder in (place.lessons, place.tasks):
            folder.mkdir(parents=True, exist_ok=True)
        assert tasks[0] in TASKS
        (place.tasks / "small.py").write_text(TASKS.replace(*tasks, 1), encoding="utf-8")
        source = place.lessons / "03_small.py"
        source.write_text(text, encoding="utf-8")
        return place, source

    return write
