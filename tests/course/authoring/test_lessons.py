"""Every lesson of the course passes `armproof lesson check`."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.course.authoring.checking.lessons import check_lesson
from armproof.course.sources.places import COURSE


@pytest.mark.parametrize("source", COURSE.sources(), ids=lambda path: path.stem)
def test_a_lesson_of_the_course_passes(source: Path):
    assert check_lesson(COURSE, source).problems == ()
