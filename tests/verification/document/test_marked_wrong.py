"""Marks that say that a display is wrong, or one answer of several, in all formats."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from armproof.verification.document import parse_document

DENIED = [
    "👎\n\n$$ a = b $$",
    "❌ $$ a = b $$",
    "$$ a = b $$ ✗",
    ":x:\n$$ a = b $$",
    "- [x] $$ c = d $$\n- [ ] $$ a = b $$",
    "- [x] $$ c = d $$\n- [ ]\n  $$ a = b $$",
    "A) $$ a = b $$\nB) $$ a = c $$",
    "Which of these is it?\n\n1. $$ a = b $$\n2. $$ a = c $$",
    "~~$$ a = b $$~~",
    "~~\n$$ a = b $$\n~~",
    '!!! failure "What is often written"\n\n    $$ a = b $$\n\nWords.',
    '=== "A common mistake"\n\n    Words.\n\n    $$ a = b $$',
    "<del>\n\n$$ a = b $$\n\n</del>",
    '<span style="text-decoration: line-through">$$ a = b $$</span>',
    '::: {.callout-note title="Do not copy"}\n$$ a = b $$\n:::',
    '<div class="alert">Do not copy\n\n$$ a = b $$\n\n</div>',
    "## Nicht abschreiben\n\n$$ a = b $$",
    "## ❌ What many write\n\n$$ a = b $$",
]
CLAIMED = [
    "✅ $$ a = b $$",
    "👍\n\n$$ a = b $$",
    "- [x] $$ a = b $$",
    "- [ ] to be typeset\n\nSo we have\n\n$$ a = b $$",
    "a) $$ a = b $$\nb) $$ c = d $$",
    "1. $$ a = b $$\n2. $$ a = c $$",
    "~~old~~\n\n$$ a = b $$",
    "$$ c = d ~~\\to~~ e = f $$\n\n$$ a = b $$",
    '!!! failure "What is often written"\n\n    $$ c = d $$\n\n$$ a = b $$',
    "$x~~y$\n\n$$ a = b $$\n\n$x~~y$",
    "## What is to be copied\n\n$$ a = b $$",
]


def _denied(name: str, text: str) -> bool:
    displays = parse_document(Path(name), text).displays
    return next(each.denied for each in displays if each.latex.strip() == "a = b")


def _notebook(text: str) -> str:
    cells = [{"cell_type": "markdown", "metadata": {}, "source": each} for each in ("# A", text)]
    return json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 4})


@pytest.mark.parametrize("text", DENIED)
def test_a_mark_denies_its_display(text: str) -> None:
    assert _denied("a.md", text)
    assert _denied("a.ipynb", _notebook(text))
    assert _denied("a.py", "# %% [markdown]\n" + "\n".join(f"# {line}" for line in text.split("\n")))


@pytest.mark.parametrize("text", CLAIMED)
def test_what_bears_no_such_mark_is_claimed(text: str) -> None:
    assert not _denied("a.md", text)
    assert not _denied("a.ipynb", _notebook(text))


def test_a_distractor_is_denied_and_the_correct_choice_is_not() -> None:
    items = "\\choice \\[ a = b \\]\n\\CorrectChoice \\[ a = c \\]\n"
    text = f"\\documentclass{{exam}}\\begin{{document}}\n\\begin{{choices}}\n{items}\\end{{choices}}\n\\end{{document}}"
    assert [each.denied for each in parse_document(Path("a.tex"), text).displays] == [True, False]
