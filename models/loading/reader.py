"""Read a URDF, SDF or Drake model directive into a MultibodyPlant, with the errors and warnings of Drake's parser."""

from __future__ import annotations

import logging
from logging.handlers import BufferingHandler
from pathlib import Path
from typing import Any
from xml.parsers import expat

from armproof.models.errors import Fault, ModelError

SUFFIXES = (".urdf", ".sdf", ".dmd.yaml")


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
        raise ModelError(Fault.MODEL_SUFFIX, path=path, suffixes=list(SUFFIXES))
    if not path.is_file():
        raise ModelError(Fault.NO_MODEL_FILE, path=path)
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    _check_markup(path)
    plant = MultibodyPlant(time_step=0.0)
    parser = Parser(plant)
    if path.name.endswith(".dmd.yaml"):
        parser.package_map().PopulateFromFolder(path.resolve().parent)
    logger, collector = logging.getLogger("drake"), BufferingHandler(capacity=1_000_000)
    collector.setLevel(logging.WARNING)
    propagate, logger.propagate = logger.propagate, False
    logger.addHandler(collector)
    try:
        parser.AddModels(path.resolve())
    except (RuntimeError, ValueError) as error:
        raise _parser_error(path, str(error)) from None
    finally:
        logger.removeHandler(collector)
        logger.propagate = propagate
    return plant, tuple(record.getMessage() for record in collector.buffer)


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
            raise ModelError(Fault.LIMITS_REVERSED, path=path, line=parser.CurrentLineNumber)

    def start(tag: str, attributes: dict[str, str]) -> None:
        text.clear()
        if tag.startswith("xacro:"):
            raise ModelError(Fault.MACRO, path=path, line=parser.CurrentLineNumber, tag=tag)
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
        raise ModelError(Fault.NOT_XML, path=path, line=error.lineno, reason=expat.ErrorString(error.code)) from None


def _parser_error(path: Path, message: str) -> ModelError:
    """Return Drake's message as an error with the file, and with the line of the value at fault where it names one."""
    message = message.replace(":0: ", ": ")
    if path.name in message:
        return ModelError(Fault.DRAKE, reason=message)
    value = message.rpartition(" got ")[2]
    for line, text in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), start=1):
        if value != message and value in text:
            return ModelError(Fault.IN_MODEL_LINE, path=path, line=line, reason=message)
    return ModelError(Fault.IN_MODEL, source=path, reason=message)
