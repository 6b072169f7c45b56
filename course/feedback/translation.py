"""The words of a question in another language: those of its options and of its numbers; what it asks stays as it is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from armproof.course.feedback.choice import Choice, Number
from armproof.course.feedback.task import Task

Change = Callable[[str], str]


def changed_task(task: Task, change: Change) -> Task:
    """Return a task with its words changed, its answers as they are and no hint given."""
    wrong = tuple(replace(each, words=change(each.words)) if each.own else each for each in task.wrong)
    hints = tuple(map(change, task.hints))
    lines = tuple(replace(line, words=change(line.words)) for line in task.derivation.lines)
    derivation = replace(task.derivation, lines=lines)
    asks = _asked(task.asks, change)
    words = change(task.title), change(task.text)
    return Task(
        task.name, *words, asks, hints, task.right, wrong, derivation, task.own, task.numbers, task.usual, task.printed
    )


def _asked(asks: Any, change: Change) -> Any:
    """Return a question with its words changed: those of options and numbers."""
    if isinstance(asks, Choice):
        options, because, missing = (_changed(words, change) for words in (asks.options, asks.because, asks.missing))
        return replace(asks, options=options, because=because, missing=missing)
    return replace(asks, labels=tuple(map(change, asks.labels))) if isinstance(asks, Number) else asks


def _changed(words: Any, change: Change) -> dict[str, str]:
    return {key: change(text) for key, text in words.items()}
