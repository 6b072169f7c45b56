"""The convention card of an arm: arm.yaml, which binds a document's names to places in the model file."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import NoReturn

import yaml

from armproof.models.errors import Fault, ModelError

CARD_NAME = "arm.yaml"
KEYS = ("title", "source", "model", "joints", "lengths", "frames", "zero")
_REQUIRED = ("title", "joints", "frames")
_SYMBOL = re.compile(r"[A-Za-z]\w*'*")
_AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Place:
    """A coordinate of the origin of a joint in its parent link: sign × joint.axis."""

    joint: str
    axis: int
    sign: int


@dataclass(frozen=True)
class Card:
    """A validated convention card.

    Attributes:
        path: the file.
        model: the model file.
        joints: joint name in the model to joint variable, base to tool.
        lengths: length symbol to the places that it is bound to.
        frames: document frame to a link or frame of the model, or to "<joint>.parent"; the base frame first.
        lines: the line of each entry, by "section" or "section.key".
    """

    path: Path
    title: str
    source: str
    zero: str
    model: Path
    joints: Mapping[str, str]
    lengths: Mapping[str, tuple[Place, ...]]
    frames: Mapping[str, str]
    lines: Mapping[str, int]

    def fail(self, entry: str, kind: Fault, **terms: object) -> NoReturn:
        """Raise a ModelError at the line of an entry, given as "section" or "section.key"."""
        line = self.lines.get(entry) or self.lines.get(entry.partition(".")[0], 1)
        raise ModelError(Fault.IN_CARD, path=self.path, line=line, reason=ModelError(kind, **terms))


def read_card(path: Path) -> Card:
    """Read and validate a convention card.

    Raises:
        ModelError: not YAML, an unknown, repeated or missing key, or a value of the wrong form; with file and line.
    """
    try:
        root = yaml.compose(path.read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
    except (yaml.YAMLError, RecursionError) as error:
        mark = getattr(error, "problem_mark", None)
        line = f":{mark.line + 1}" if mark else ""
        raise ModelError(
            Fault.CARD_NOT_YAML, path=path, line=line, reason=str(getattr(error, "problem", error))
        ) from None
    except (OSError, UnicodeDecodeError) as error:
        raise ModelError(Fault.CARD_UNREADABLE, path=path, reason=str(error)) from None
    if root is None:
        raise ModelError(Fault.CARD_EMPTY, path=path, keys=list(KEYS))
    return _CardReader(path).read(root)


class _CardReader:
    """Turns YAML nodes, which know their lines, into a card."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.lines: dict[str, int] = {}

    def read(self, root: yaml.Node) -> Card:
        nodes = self.mapping(root, "the card", "")
        for key in nodes:
            if key not in KEYS:
                self.fail(nodes[key], Fault.UNKNOWN_CARD_KEY, key=key, keys=list(KEYS))
        for key in _REQUIRED:
            if key not in nodes:
                self.fail(root, Fault.CARD_KEY_MISSING, key=key, keys=list(_REQUIRED))
        joints = self.texts(nodes["joints"], "joints")
        for name, symbol in joints.items():
            self.symbol(nodes["joints"], symbol, f"joint '{name}'")
        frames = self.texts(nodes["frames"], "frames")
        if not frames:
            self.fail(nodes["frames"], Fault.NO_FRAMES)
        lengths = self.mapping(nodes["lengths"], "'lengths'", "lengths.") if "lengths" in nodes else {}
        for symbol in lengths:
            self.symbol(nodes["lengths"], symbol, "a length")
        places = {symbol: self.places(node, symbol) for symbol, node in lengths.items()}
        model = self.text(nodes["model"], "model") if "model" in nodes else f"{self.path.absolute().parent.name}.urdf"
        return Card(
            path=self.path,
            title=self.text(nodes["title"], "title"),
            source=self.text(nodes["source"], "source") if "source" in nodes else "",
            zero=self.text(nodes["zero"], "zero") if "zero" in nodes else "",
            model=self.path.parent / model,
            joints=MappingProxyType(joints),
            lengths=MappingProxyType(places),
            frames=MappingProxyType(frames),
            lines=MappingProxyType(self.lines),
        )

    def fail(self, node: yaml.Node, kind: Fault, **terms: object) -> NoReturn:
        line = node.start_mark.line + 1
        raise ModelError(Fault.IN_CARD, path=self.path, line=line, reason=ModelError(kind, **terms))

    def mapping(self, node: yaml.Node, what: str, prefix: str) -> dict[str, yaml.Node]:
        if not isinstance(node, yaml.MappingNode):
            self.fail(node, Fault.NO_MAPPING_IN_CARD, what=what, found=_kind(node))
        result: dict[str, yaml.Node] = {}
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                self.fail(key, Fault.KEY_NO_NAME, what=what, found=_kind(key))
            if key.value in result:
                self.fail(key, Fault.CARD_KEY_TWICE, key=key.value, what=what)
            result[key.value] = value
            self.lines[prefix + key.value] = key.start_mark.line + 1
        return result

    def texts(self, node: yaml.Node, key: str) -> dict[str, str]:
        return {name: self.text(value, name) for name, value in self.mapping(node, f"'{key}'", f"{key}.").items()}

    def text(self, node: yaml.Node, key: str) -> str:
        if not isinstance(node, yaml.ScalarNode) or not node.value:
            self.fail(node, Fault.NO_TEXT, key=key, found=_kind(node))
        return str(node.value)

    def symbol(self, node: yaml.Node, symbol: str, what: str) -> None:
        if not _SYMBOL.fullmatch(symbol):
            self.fail(node, Fault.NO_SYMBOL, what=what, symbol=symbol)

    def places(self, node: yaml.Node, symbol: str) -> tuple[Place, ...]:
        items = node.value if isinstance(node, yaml.SequenceNode) else [node]
        if not items:
            self.fail(node, Fault.NO_PLACES, symbol=symbol)
        return tuple(self.place(item, symbol) for item in items)

    def place(self, node: yaml.Node, symbol: str) -> Place:
        text = self.text(node, symbol)
        joint, _, axis = text.removeprefix("-").rpartition(".")
        if not joint or axis not in _AXES:
            self.fail(node, Fault.NO_PLACE, symbol=symbol, text=text)
        return Place(joint, _AXES.index(axis), -1 if text.startswith("-") else 1)


def _kind(node: yaml.Node) -> str:
    if isinstance(node, yaml.ScalarNode):
        return f"'{node.value}'" if node.value else "empty"
    return "a list" if isinstance(node, yaml.SequenceNode) else "a mapping"
