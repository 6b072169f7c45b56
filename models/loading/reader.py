"""Read a URDF, SDF or Drake model directive into a MultibodyPlant, with the errors and warnings of Drake's parser."""

from __future__ import annotations

import logging
from pathlib import Path
from typing import Any
from xml.parsers import expat

from armproof.models.errors import ModelError

SUFFIXES = (".urdf", ".sdf", ".dmd.yaml")


class _Collector(logging.Handler):
    """Keep what Drake logs while a file is parsed."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.messages: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.messages.append(record.getMessage())


def read_model(path: Path) -> tuple[Any, tuple[str, ...]]:
    """Parse a model file into a MultibodyPlant that is not finalized yet.

    Visual and collision geometry is not read, so meshes need not be there. Packages below the folder of the file
    are found by their package.xml.

    Returns:
        The plant, and the parser's warnings ("file:line: warning: …").

    Raises:
        ModelError: the file is missing, of an unknown kind, or rejected by Drake's parser.
    """
    if not path.name.endswith(SUFFIXES):
        raise ModelError(f"{path}: a model file ends in {', '.join(SUFFIXES)}")
    if not path.is_file():
        raise ModelError(f"{path}: no such model file")
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    _check_markup(path)
    plant = MultibodyPlant(time_step=0.0)
    parser = Parser(plant)
    if path.name.endswith(".dmd.yaml"):
        parser.package_map().PopulateFromFolder(path.resolve().parent)
    logger, collector = logging.getLogger("drake"), _Collector()
    propagate, logger.propagate = logger.propagate, False
    logger.addHandler(collector)
    try:
        parser.AddModels(path.resolve())
    except (RuntimeError, ValueError) as error:
        raise ModelError(_parser_message(path, str(error))) from None
    finally:
        logger.removeHandler(collector)
        logger.propagate = propagate
    return plant, tuple(collector.messages)


def _check_markup(path: Path) -> None:
    """Refuse what Drake's parser does not: bad XML is given no line, macros are ignored, wrong limits end the process."""
    if path.name.endswith(".dmd.yaml"):
        return
    parser = expat.ParserCreate()
    bounds: dict[str, str] = {}
    text: list[str] = []

    def check() -> None:
        try:
            wrong = float(bounds.pop("lower")) > float(bounds.pop("upper"))
        except (KeyError, ValueError):  # what is missing or not a number, Drake's parser reports
            return
        if wrong:
            raise ModelError(f"{path}:{parser.CurrentLineNumber}: the lower limit of a joint is above its upper limit")

    def start(tag: str, attributes: dict[str, str]) -> None:
        text.clear()
        if tag.startswith("xacro:"):
            raise ModelError(f"{path}:{parser.CurrentLineNumber}: <{tag}> is a macro; expand the file with xacro first")
        if tag == "limit":
            bounds.clear()
            if path.suffix == ".urdf":
                bounds.update({"lower": "0", "upper": "0", **attributes})
                check()

    def end(tag: str) -> None:
        bounds[tag] = "".join(text)
        if tag == "limit" and path.suffix == ".sdf":
            check()

    parser.StartElementHandler, parser.EndElementHandler, parser.CharacterDataHandler = start, end, text.append
    try:
        parser.Parse(path.read_bytes(), True)
    except expat.ExpatError as error:
        raise ModelError(f"{path}:{error.lineno}: not well-formed XML: {expat.ErrorString(error.code)}") from None


def _parser_message(path: Path, message: str) -> str:
    """Return Drake's message with the file, and with the line of the value at fault where it names one."""
    message = message.replace(":0: ", ": ")
    if path.name in message:
        return message
    value = message.rpartition(" got ")[2]
    for line, text in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), start=1):
        if value != message and value in text:
            return f"{path}:{line}: {message}"
    return f"{path}: {message}"
