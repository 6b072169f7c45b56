"""A sheet as PDF, typeset by Typst: offline, with the fonts that come with it, the same bytes every time."""

from __future__ import annotations

import shutil
import tempfile
from importlib import resources
from importlib.util import find_spec
from pathlib import Path

from armproof.course.errors import PrintError
from armproof.course.printing.typst_writer import TypstWriter
from armproof.course.sheet import model as s

MISSING = "a PDF sheet is typeset by Typst, which is not installed: pip install 'armproof[print]'; --format html needs nothing"


def check_installed() -> None:
    """Raise PrintError where Typst is not installed."""
    if find_spec("typst") is None:
        raise PrintError(MISSING)


def write_pdf(sheet: s.Sheet) -> bytes:
    """Return a sheet as PDF.

    Typst sees a folder of its own with the source, the template and the pictures, and nothing else.

    Raises:
        PrintError: Typst is not installed, or cannot typeset the sheet (a picture that is none).
    """
    check_installed()
    import typst

    with tempfile.TemporaryDirectory(prefix="armproof-sheet-") as name:
        folder = Path(name)
        names = _copy_pictures(sheet, folder)
        template = resources.files("armproof.course.printing").joinpath("templates", "sheet.typ")
        (folder / "sheet.typ").write_text(template.read_text(encoding="utf-8"), encoding="utf-8")
        main = folder / "main.typ"
        main.write_text(TypstWriter(sheet, names).source(), encoding="utf-8")
        try:
            pdf = typst.compile(str(main), root=str(folder), ignore_system_fonts=True, format="pdf", timestamp=0)
        except typst.TypstError as error:
            raise PrintError("it cannot be typeset: {reason}", reason=str(error).strip().splitlines()[0]) from None
    return bytes(pdf)


def _copy_pictures(sheet: s.Sheet, folder: Path) -> dict[Path, str]:
    names: dict[Path, str] = {}
    for block in s.walk(sheet.blocks):
        if isinstance(block, s.Picture) and block.path not in names:
            names[block.path] = f"picture-{len(names) + 1}{block.path.suffix.lower()}"
            shutil.copyfile(block.path, folder / names[block.path])
    return names
