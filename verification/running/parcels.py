"""A document as it travels to another machine: its bytes and those of the files that it inputs; and its result on the way back.

What a worker cannot decide as this machine would is checked here: a document whose arm is a model file, one that cannot be
read, one that ends the process which checks it.
"""

from __future__ import annotations

import pickle
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from armproof.models.catalogue import arm_names
from armproof.verification.document import Document, read_document
from armproof.verification.document.front_matter import read_any_text, read_bytes, suffix_of
from armproof.verification.document.tex import inputs_of
from armproof.verification.errors import DocumentError
from armproof.verification.verdict import DocumentResult

NOT_THERE = b""  # what is sent back for a document that is to be checked on the machine that it comes from


@dataclass(frozen=True)
class Parcel:
    """A document's name on its own machine, and the bytes of its files by their names below its folder, its own first."""

    path: str
    files: Mapping[str, bytes]


def pack(path: Path) -> Parcel | None:
    """Return a document as it travels; None where it cannot: it is not readable, or one of its files is a link."""
    try:
        inputs = inputs_of(path, read_any_text(path)[0]) if suffix_of(path) == ".tex" else ()
        if any(file.resolve() != file for file in inputs):
            return None
        folder = path.parent.resolve()
        inside = {str(file.relative_to(folder)): read_bytes(file) for file in inputs}
        return Parcel(str(path), {path.name: read_bytes(path)} | inside)
    except DocumentError:
        return None


def check_parcel(parcel: Parcel, correct: bool) -> bytes:
    """Return the result of a document as it travels back, or `NOT_THERE`; no exception leaves this function."""
    from armproof.verification import check

    try:
        document = _unpacked(parcel)
        if names_a_file(document.front):
            return NOT_THERE
        result = check.check_document(document, correct=correct)
    except Exception:  # which its own machine meets again, and tells
        return NOT_THERE
    return zlib.compress(pickle.dumps(result), 1)


def result_of(data: bytes) -> DocumentResult:
    """Return the result that `check_parcel` sent back."""
    found: DocumentResult = pickle.loads(zlib.decompress(data))  # noqa: S301 - of a worker of the user's own
    return found


def names_a_file(front: Mapping[str, Any]) -> bool:
    """Whether a front matter names an arm by the path of a file, which is another one on another machine."""
    return any(isinstance(arm, str) and arm not in arm_names() for arm in _arms(front))


def _arms(front: Mapping[str, Any]) -> Iterator[object]:
    yield front.get("arm")
    sections = front.get("arms")
    for each in sections.values() if isinstance(sections, Mapping) else ():
        yield each.get("arm") if isinstance(each, Mapping) else each


def _unpacked(parcel: Parcel) -> Document:
    """Return the document of a parcel, under the name that it has at home."""
    with TemporaryDirectory(prefix="armproof-") as folder:
        for name, data in parcel.files.items():
            file = Path(folder) / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
        document = read_document(Path(folder) / next(iter(parcel.files)))
    return replace(document, path=Path(parcel.path))
