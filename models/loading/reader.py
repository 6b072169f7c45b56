"""Read a URDF, SDF or Drake model directive into a MultibodyPlant, with the errors and warnings of Drake's parser."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from dataclasses import dataclass
from logging.handlers import BufferingHandler
from pathlib import Path
from types import MappingProxyType
from typing import Any
from xml.parsers import expat

from armproof.models.errors import Fault, ModelError
from armproof.models.loading.urdf import made_ready

SUFFIXES = (".urdf", ".sdf", ".dmd.yaml")


@dataclass(frozen=True)
class Model:
    """What was read: the plant, not finalized yet, the text where it is not the file's own, and what is to be remarked."""

    plant: Any
    text: str
    warnings: tuple[str, ...]


def read_model(path: Path, tip: str = "", lock: Mapping[str, float] = MappingProxyType({})) -> Model:
    """Parse a model file into a MultibodyPlant that is not finalized yet.

    Visual and collision geometry is not read, so meshes need not be there. Packages below the folder of the file
    are found by their package.xml.

    Args:
        path: the file.
        tip: the link that the arm ends in; joints that do not carry it are fixed. Empty: all moving joints are the arm's.
        lock: joints that are fixed, each at its value (rad, m).

    Raises:
        ModelError: the file is missing, of an unknown kind, or rejected by Drake's parser; there is no such link or joint.
    """
    if not path.name.endswith(SUFFIXES):
        raise ModelError(Fault.MODEL_SUFFIX, path=path, suffixes=list(SUFFIXES))
    if not path.is_file():
        raise ModelError(Fault.NO_MODEL_FILE, path=path)
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    _check_markup(path)
    text, remarks = made_ready(path, tip, lock)
    plant = MultibodyPlant(time_step=0.0)
    parser = Parser(plant)
    if path.name.endswith(".dmd.yaml"):
        parser.package_map().PopulateFromFolder(path.resolve().parent)
    logger, collector = logging.getLogger("drake"), BufferingHandler(capacity=1_000_000)
    collector.setLevel(logging.WARNING)
    propagate, logger.propagate = logger.propagate, False
    logger.addHandler(collector)
    try:
        if text:
            parser.AddModelsFromString(text, "urdf")
        else:
            parser.AddModels(path.resolve())
    except (RuntimeError, ValueError) as error:
        raise _parser_error(path, _of_file(str(error), path)) from None
    finally:
        logger.removeHandler(collector)
        logger.propagate = propagate
    warnings = (_of_file(record.getMessage(), path) for record in collector.buffer)
    return Model(plant, text, (*remarks, *warnings))


def _of_file(message: str, path: Path) -> str:
    """Return a message on a text as one on its file."""
    return message.replace("<literal-string>.urdf", str(path.resolve()))


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
