"""The pictures of a document: files beside it or below it, of formats that hold nothing but a picture."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import unquote

SUFFIXES = (".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp")
MAX_BYTES = 20_000_000


def find_picture(target: str, folder: Path) -> Path | str:
    """Return the file of a picture that a document names, or why it is not printed."""
    name = unquote(target)
    if "://" in name or name.startswith(("//", "data:", "file:")):
        return "a sheet is made without the network; put the picture beside the document"
    if "\0" in name or Path(name).is_absolute() or "\\" in name:
        return "a picture is named by its path from the document's folder"
    path = (folder / name).resolve()
    if not path.is_relative_to(folder.resolve()):
        return "it does not stand in the document's folder"
    if path.suffix.lower() not in SUFFIXES:
        return f"pictures are {', '.join(SUFFIXES)} files"
    if not path.is_file():
        return "no such file"
    if path.stat().st_size > MAX_BYTES:
        return f"larger than {MAX_BYTES // 1_000_000} MB"
    return path
