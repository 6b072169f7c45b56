"""What typer says of a wrong use, in the language that is spoken: it says it in English, and leaves no template to look up."""

from __future__ import annotations

import re
import sys
from io import StringIO
from string import Formatter
from typing import Any

from armproof.models.language import look_up

SENTENCES = (
    "Usage: {usage}",
    "Try '{command}' for help.",
    "Error: {message}",
    "Invalid value for {param_hint}: {message}",
    "Invalid value: {message}",
    "Value error, {message}",
    "{value} is not one of {values}.",
    "Input should be a valid integer, unable to parse string as an integer",
    "Input should be greater than or equal to {least}",
    "Input should be less than or equal to {most}",
    "Missing argument {name}.",
    "Missing option {name}.",
    "No such option: {name} (Possible options: {possibilities})",
    "No such option: {name}",
    "{problem} Did you mean {possibilities}?",
    "Option {name} requires an argument.",
    "Option {name} does not take a value.",
    "Got unexpected extra argument(s) ({args})",
)


def show_translated(show: Any, file: Any = None) -> None:
    """Show what typer says, in the language that is spoken."""
    show(said := StringIO())
    (file or sys.stderr).writelines(f"{translated(line)}\n" for line in said.getvalue().splitlines())


def translated(said: str) -> str:
    """Return a sentence of typer, and the sentences in it, in the language that is spoken; another text as it is."""
    for sentence in SENTENCES:
        if found := re.fullmatch(_pattern(sentence), said):
            terms = {name: translated(text) for name, text in found.groupdict().items()}
            return look_up(sentence).format(**terms)
    return said


def _pattern(sentence: str) -> str:
    """Return the pattern of what a sentence says with its terms."""
    parts = Formatter().parse(sentence)
    return "".join(re.escape(text) + (f"(?P<{name}>.+)" if name else "") for text, name, *_ in parts)
