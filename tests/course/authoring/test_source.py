"""Reading sources: as jupytext reads them, and a message with file and line for what is malformed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from armproof.course.errors import SourceError
from armproof.course.sources.lesson_source import parse_cells, read_lesson_source
from armproof.course.sources.places import COURSE
from armproof.verification.document import parse_document
from armproof.verification.document.cells import percent_cells

jupytext = pytest.importorskip("jupytext")


def as_jupytext_reads(text: str) -> list[tuple[str, str]]:
    return [(cell.cell_type, cell.source) for cell in jupytext.reads(text, fmt="py:percent").cells]


def as_we_read(text: str) -> list[tuple[str, str]]:
    return [(cell.kind, cell.source) for cell in parse_cells(Path("lesson.py"), text)]


def test_the_small_lesson_is_read_as_jupytext_reads_it(lesson):
    text = lesson()[1].read_text(encoding="utf-8")
    assert as_we_read(text) == as_jupytext_reads(text)


@pytest.mark.parametrize("source", COURSE.sources(), ids=lambda path: path.stem)
def test_every_lesson_is_read_as_jupytext_reads_it(source: Path):
    text = source.read_text(encoding="utf-8")
    assert as_we_read(text) == as_jupytext_reads(text)


@pytest.mark.parametrize(
    "text",
    [
        "# %%\nx = 1\n\n\n# %% [markdown]\n# a\n#\n#  b\n",
        "# %%\n# %matplotlib inline\n# !armproof arms\n",
        '# %% [markdown] tags=["wide"]\n# text\n\n# %% tags=["hide-input"]\nx = "# %% no cell"\n',
        "# %%\n# a comment\nx = 1  # another\n",
        "# %% [md]\n# short\n",
        "# %%\n# %%time\nx = 1\n",
        "#%%\nx = 1\n\n#%% [markdown]\n# text\n",
        "# %%\nx = 1\n\n# %%% [markdown]\n# text\n",
    ],
)
def test_spellings_of_cells_are_read_as_jupytext_reads_them(text: str):
    assert as_we_read(text) == as_jupytext_reads(text)


@pytest.mark.parametrize("line", ["# %%time", "# %%", "#%%", "# %% a title", "# %%% x", "# %%%", "# %% [markdown]"])
def test_a_line_opens_a_cell_for_verify_where_it_does_for_lessons_and_jupytext(line: str):
    text = f"# %%\nx = 1\n{line}\n# a\n\n# %% [markdown]\n# $$ x = x $$\n"
    number = len(as_jupytext_reads(text)) - 1
    assert len(parsed := percent_cells(text)) - 1 == number
    assert [display.cell for display in parse_document(Path("lesson.py"), text).displays] == [number]
    assert all(cell.kind == kind for cell, (kind, _) in zip(parsed, as_jupytext_reads(text), strict=True))


def test_a_magic_is_no_cell_and_a_marker_is_one():
    assert len(percent_cells("# %%\n# %%time\n")) == 1
    assert len(percent_cells("# %%\n# %% time\n")) == 2


def test_lines_and_metadata_are_those_of_the_file():
    text = '# ---\n# ---\n\n# %% tags=["wide"]\n\nx = 1\n'
    [cell] = parse_cells(Path("lesson.py"), text)
    assert (cell.line, cell.metadata) == (6, {"tags": ["wide"]})


def line_of(source: Path, text: str) -> int:
    return source.read_text(encoding="utf-8").split("\n").index(text) + 1


@pytest.mark.parametrize(
    ("old", "new", "at", "message"),
    [
        ("# %% [raw]", "# %% [markdown]", None, "first cell is no front matter; expected '# %% [raw]'"),
        ("    ### BEGIN SOLUTION\n", "", "    ### END SOLUTION", "'### END SOLUTION' without '### BEGIN SOLUTION'"),
        ("    ### END SOLUTION\n", "", "    ### BEGIN SOLUTION", "without '### END SOLUTION' behind it in the same cell"),
        ("    corner = a", "    ### BEGIN SOLUTION\n    corner = a", None, "a second '### BEGIN SOLUTION'"),
        ("    ### END SOLUTION", "### END SOLUTION", None, "not indented as its '### BEGIN SOLUTION'"),
        ("### BEGIN SOLUTION\njoints = 2", "# BEGIN SOLUTION\njoints = 2", "# BEGIN SOLUTION", "is no marker; expected"),
        ("joints = 2\n", "", None, "nothing between '### BEGIN SOLUTION' and '### END SOLUTION'"),
        ("    return a * b - corner\n    ### END SOLUTION", "    ### END SOLUTION\n    return (a", None, "not Python"),
        ("joints = 2\n### END SOLUTION\n", "joints = (2\n### END SOLUTION\n)\n", None, "in the middle of a statement"),
        ("### BEGIN SOLUTION\njoints = 2\n###", "if True:\n    ### BEGIN SOLUTION\n    joints = 2\n    ###", None, "outside a function"),
        ("# # 3 · Small", "# ### BEGIN SOLUTION", "# ### BEGIN SOLUTION", "in a text cell; solutions stand in code"),
        ("# # 3 · Small", "3 · Small", "3 · Small", "expected a comment: '# ' before every line"),
        ("# %% [markdown]", "# %% [markdwn]", "# %% [markdwn]", "'[markdwn]' in the head of a cell; expected [markdown]"),
        ('open_lesson("small"', 'open_lesson("large"', None, "opens the lesson 'large'; expected lesson = open_lesson(\"small\")"),
        ("lesson = open_lesson", "opened = open_lesson", None, "no cell opens the lesson"),
        ("# %% [raw]", "x = 1\n\n# %% [raw]", "x = 1", "'x = 1' stands before the first cell"),
    ],
)  # fmt: skip
def test_a_malformed_source_is_named_with_its_line(lesson, old: str, new: str, at: str | None, message: str):
    _, source = lesson((old, new))
    with pytest.raises(SourceError, match=re.escape(message)) as caught:
        read_lesson_source(source)
    assert re.match(rf"{re.escape(str(source))}:\d+: ", str(caught.value))
    if at is not None:
        assert caught.value.line == line_of(source, at)


def test_a_file_without_a_number_is_no_lesson(lesson):
    _, source = lesson()
    with pytest.raises(SourceError, match="is called NN_name"):
        read_lesson_source(source.rename(source.with_name("small.py")))


def test_a_well_formed_source_has_its_checks_and_blocks(lesson):
    _, source = lesson()
    read = read_lesson_source(source)
    assert (read.number, read.name) == (3, "small")
    assert [check.task for check in read.checks] == ["area", "root", "joints"]
    assert [block.names for blocks in read.blocks.values() for block in blocks] == [(), ("shift", "root"), ("joints",)]
    assert all(line_of(source, f"lesson.{check.task}.check({check.task})") == check.line for check in read.checks)
