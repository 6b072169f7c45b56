"""IPython's own syntax is skipped; Python is left alone."""

import pytest

from armproof.course.grading.running.runner import without_magics


@pytest.mark.parametrize(
    ("source", "plain"),
    [
        ("%matplotlib inline\nx = 1", "pass\nx = 1"),
        ("if x:\n    !ls\ny = 2", "if x:\n    pass\ny = 2"),
        ("files = !ls\nx = 1", "files = None\nx = 1"),
        ("t = %timeit -o f()", "t = None"),
        ("lesson?", "pass"),
        ("%%time\nx = 1", "pass\nx = 1"),
        ("%%bash\nrm -rf x", ""),
    ],
)
def test_magics_are_skipped_with_a_note(source, plain):
    found, notes = without_magics(source)
    assert found == plain and len(notes) == 1


@pytest.mark.parametrize("source", ["x = (7\n% 2)", "text = '''\n%time\n'''", "x = = 1", "y = a if b else '?'"])
def test_python_and_what_is_neither_are_left_as_they_are(source):
    assert without_magics(source) == (source, [])
