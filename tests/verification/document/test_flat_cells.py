"""A notebook's sentences are heard as those of one text, and hold as far as they do there."""

from __future__ import annotations

import json
from pathlib import Path

from armproof.verification.document import parse_document
from armproof.verification.document.flat_cells import as_one_text

CELLS = ["# A\n$$ a = b $$", "# B\nThe brake holds\nthe elbow.\n\n$$ c = d $$", "# C\n\n\n\n\n\n$$ e = f $$"]


def _notebook(cells: list[str]) -> str:
    found = [{"cell_type": "markdown", "metadata": {}, "source": each} for each in cells]
    return json.dumps({"cells": found, "metadata": {}, "nbformat": 4, "nbformat_minor": 4}, indent=1)


def test_a_sentence_holds_in_its_section_alone_as_in_one_text() -> None:
    notebook = parse_document(Path("a.ipynb"), _notebook(CELLS))
    markdown = parse_document(Path("a.md"), "\n\n".join(CELLS))
    assert [each.meant for each in notebook.displays] == [each.meant for each in markdown.displays]
    assert [each.meant for each in notebook.displays] == [(), ("locked",), ()]


def test_displays_keep_their_lines_of_their_cells() -> None:
    assert [(each.cell, each.line) for each in parse_document(Path("a.ipynb"), _notebook(CELLS)).displays] == [
        (0, 2),
        (1, 5),
        (2, 7),
    ]


def test_the_cells_stand_one_below_the_other() -> None:
    text, above = as_one_text(_notebook(["a\nb", "c"]), ".ipynb")
    assert (text, above) == ("a\nb\n\nc\n", {0: 0, 1: 3})


def test_a_percent_file_speaks_on_its_own_lines() -> None:
    assert as_one_text("# %% [markdown]\n# a\n# b\n\n# %%\nx = 1\n", ".py")[0] == "\na\nb\n\n\n\n"
