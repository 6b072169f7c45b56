"""The documents that paths name: files, and those in folders."""

from __future__ import annotations

import re
from pathlib import Path

from armproof.verification.document.formats import SUFFIXES, has_displays
from armproof.verification.document.text import read_text
from armproof.verification.errors import DocumentError


def find_documents(paths: list[Path]) -> list[Path]:
    """Return the documents named, and those in the folders named; raises DocumentError where there are none.

    In a folder, a file counts that has front matter with one of our keys or holds a display.
    """
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            documents = [child for child in _files_below(path) if _is_document(child)]
            if not documents:
                raise DocumentError(
                    f"{path}: no document in this folder; a document is a {', '.join(SUFFIXES)} file with displays"
                )
            found.extend(documents)
        elif not path.exists():
            raise DocumentError(f"{path}: no such file or folder")
        elif path.suffix not in SUFFIXES:
            raise DocumentError(f"{path}: '{path.suffix}' files are not read; those that are: {', '.join(SUFFIXES)}")
        else:
            found.append(path)
    return list(dict.fromkeys(found))


def _files_below(folder: Path) -> list[Path]:
    """Return the files of a folder that may be documents, hidden ones and those in hidden folders left out."""
    return [
        child
        for child in sorted(folder.rglob("*"))
        if child.suffix in SUFFIXES
        and child.is_file()
        and not any(part.startswith(".") for part in child.relative_to(folder).parts)
    ]


def _is_document(path: Path) -> bool:
    try:
        text = read_text(path)
    except DocumentError:
        return path.suffix != ".py"
    return has_displays(path.suffix, text) or _names_an_arm(text)


def _names_an_arm(text: str) -> bool:
    return bool(re.match(r"(?:---|%|\.\.|:)", text)) and bool(re.search(r"^[%:\s]*arm:", text, re.MULTILINE))
