"""What Armproof says to people, found in its sources: kinds of messages, sentences of commands and errors, helps, pages, arms."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from inspect import cleandoc
from pathlib import Path
from typing import Any

import yaml
from babel.messages.extract import extract_from_dir
from typer.main import get_command

from armproof.course.feedback.outcome import Outcome
from armproof.course.grading.results import Status
from armproof.course.words import words
from armproof.models.language import FOLDER
from armproof.verification.algebra.quantity_kinds import KINDS
from armproof.verification.cli.application import app, as_command, commands
from armproof.verification.cli.usage import SENTENCES
from armproof.verification.findings.finding import ORDINALS
from armproof.verification.findings.kinds import WORDS
from armproof.verification.verdict import Role, Verdict
from tests.models.test_errors import errors_of
from tests.sources import nodes_in
from tests.translations.catalogues import Message

ROOT = Path(__file__).resolve().parents[2]
OF_TYPER = (
    "Options",
    "Commands",
    "Arguments",
    "required",
    "default: {default}",
    "(dynamic)",
    "Missing command.",
    "No such command {name!r}.",
    "Show this message and exit.",
    "Aborted!",
    *SENTENCES,
)
OF_SINGULARITIES = ("inside", "boundary", "boundary in part", "not decided")  # what a Position is called
ROOMS = ("models", "verification", "course")
SAYS = {"tell", "written", "sentence", "look_up", "noted", "said", "Sentence"}
PLURALS = {"counted", "look_up_plural", "noted_plural"}


def catalogue_of_messages(lang: str) -> Path:
    return FOLDER / lang / "messages.po"


def said() -> Iterator[Message]:
    """Yield all that the catalogue of messages translates."""
    for message in (*of_modules(), *of_templates(), *of_commands(), *of_arms(), *of_words()):
        if re.search(r"[^\W\d_]|[:;?!]", re.sub(r"\{[^{}]*\}|\$[^$]*\$|`[^`]*`", "", message.text)):
            yield message


def of_modules() -> Iterator[Message]:
    """Yield what the modules say: the templates of kinds, of errors, and of what commands write."""
    modules = {path: nodes_in(path.read_text(encoding="utf-8")) for path in sources(".py")}
    names = SAYS | errors_of([node for nodes in modules.values() for node in nodes if isinstance(node, ast.ClassDef)])
    for path, nodes in modules.items():
        for texts in (found for node in nodes for found in _said_by(node, names)):
            yield Message(texts[0], place(path), *texts[1:])


def of_templates() -> Iterator[Message]:
    """Yield what the templates of pages say."""
    for room in ROOMS:
        found = extract_from_dir(
            str(ROOT / room),
            [("**/templates/**.html", "jinja2"), ("**/templates/**.jinja", "jinja2")],
            keywords={"_": None, "counted": (1, 2)},
        )
        for file, _, texts, _, _ in found:
            yield Message(
                (texts if isinstance(texts, str) else texts[0]),
                f"{room}/{file}",
                *texts[1:] if isinstance(texts, tuple) else (),
            )


def of_commands() -> Iterator[Message]:
    """Yield the helps of all commands, of their options and arguments."""
    yield from (Message(word, "typer") for word in OF_TYPER)
    yield from _helps(get_command(app), "armproof")
    for name, found in commands().items():
        yield from _helps(as_command(name, found.load()), f"armproof {name}")


def of_arms() -> Iterator[Message]:
    """Yield what the cards of the arms tell of them."""
    for path in sorted((ROOT / "models").glob("*/arm.yaml")):
        card = yaml.safe_load(path.read_text(encoding="utf-8"))
        yield from (
            Message(card[key], place(path)) for key in ("title", "zero", "source") if isinstance(card.get(key), str)
        )


def of_words() -> Iterator[Message]:
    """Yield the terms of findings that are words, and what verdicts and roles are called."""
    yield from (Message(word, "verification/findings/kinds.py") for word in (*sorted(WORDS), *ORDINALS))
    yield from (Message(word, "verification/verdict.py") for word in (*Verdict, *Role))
    yield from (Message(word, "verification/singularities/families.py") for word in OF_SINGULARITIES)
    yield from (Message(word, "course/feedback/outcome.py") for word in Outcome)
    yield from (Message(word, "course/grading/results.py") for word in Status)
    yield from (Message(text, "course/words.toml") for text in words().values())
    yield from (Message(kind.words, "verification/algebra/quantity_kinds.py") for kind in KINDS.values())
    yield from (Message(f"{{number}} {word}", "verification/verdict.py", f"{{number}} {word}") for word in Verdict)


def sources(suffix: str) -> list[Path]:
    """Return the files of the rooms that are ours: lessons and handouts have catalogues of their own."""
    found = [path for room in ROOMS for path in sorted((ROOT / room).rglob(f"*{suffix}"))]
    return [path for path in found if not {"lessons", "handouts"} & set(path.relative_to(ROOT).parts)]


def place(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def _said_by(node: ast.AST, names: set[str]) -> Iterator[tuple[str, ...]]:
    if isinstance(node, ast.ClassDef) and "MessageKind" in {ast.unparse(base) for base in node.bases}:
        members = [
            each.value.elts[1:]
            for each in node.body
            if isinstance(each, ast.Assign) and isinstance(each.value, ast.Tuple)
        ]
        yield from ((text,) for member in members for text in map(_constant, member) if text)
    elif isinstance(node, ast.Call):
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name in PLURALS:
            yield from [texts for texts in [tuple(map(_constant, node.args[:2]))] if all(texts)]
        elif name in names:
            yield from (
                (text,) for argument in node.args for text in _constants(argument) if " " in text or name in SAYS
            )


def _constants(node: ast.expr) -> Iterator[str]:
    """Yield the sentences of an argument: one, or one of two."""
    if isinstance(node, ast.IfExp):
        yield from (text for branch in (node.body, node.orelse) for text in _constants(branch))
    elif text := _constant(node):
        yield text


def _constant(node: ast.expr) -> str:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def _helps(command: Any, name: str) -> Iterator[Message]:
    texts = [command.help, *(getattr(each, "help", None) for each in command.params)]
    yield from (Message(cleandoc(text), name) for text in texts if text)
    for inner in getattr(command, "commands", {}).values():
        yield from _helps(inner, f"{name} {inner.name}")
