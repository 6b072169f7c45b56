"""`armproof correct`: a document with each refuted term replaced by the right one."""

from __future__ import annotations

import re
import sys
from difflib import unified_diff
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from armproof.models.errors import written
from armproof.models.language import look_up, noted
from armproof.verification.cli.application import CANNOT_RUN, FAILS, PASSES, Language, complain, ending, tell

if TYPE_CHECKING:
    from armproof.verification.running.corrected_copy import CorrectedCopy

Source = Annotated[Path, typer.Argument(metavar="FILE", help="A document or a notebook.", show_default=False)]
Diff = Annotated[bool, typer.Option("--diff", help="Print what would change, as a unified diff.")]
Output = Annotated[Path | None, typer.Option("--output", metavar="FILE", help="Write the corrected copy to a file.")]
InPlace = Annotated[bool, typer.Option("--in-place", help="Overwrite the document itself.")]


def correct(
    path: Source, diff: Diff = False, output: Output = None, in_place: InPlace = False, lang: Language = ""
) -> None:
    """Print a document with each refuted term replaced by the right one.

    Nothing else changes, errata stay. Exit code 0: the copy passes; 1: something in it does not, as standard error says;
    2: the document cannot be checked or the copy cannot be written.
    """
    from armproof.verification.running.corrected_copy import correct_file, save

    if (problem := _conflict(path, diff, output, in_place)) is not None:
        tell(problem)
        raise typer.Exit(CANNOT_RUN)
    try:
        with ending():
            copy = correct_file(path)
            target = path if in_place else output
            if target is not None:
                save(copy, target)
    except OSError as error:
        tell("{path}: cannot be written: {reason}", path=output or path, reason=error.strerror)
        raise typer.Exit(CANNOT_RUN) from None
    if target is None:
        _write(_difference(copy) if diff else copy.after)
    complain(_what_remains(copy))
    raise typer.Exit(FAILS if copy.remaining else PASSES)


def _conflict(path: Path, diff: bool, output: Path | None, in_place: bool) -> str | None:
    """Return why the options do not go together, or None."""
    if sum((diff, output is not None, in_place)) > 1:
        return noted("give one of --diff, --output and --in-place, or none for standard output")
    if output is not None and output.exists() and path.exists() and output.samefile(path):
        return written("{output}: this is the document itself, which only --in-place overwrites", output=output)
    return None


def _difference(copy: CorrectedCopy) -> str:
    """Return what a correction changes as a unified diff, the lines' own ends kept."""
    before, after = (_lines(text) for text in (copy.before, copy.after))
    lines = unified_diff(before, after, str(copy.path), written("{path} (corrected)", path=copy.path), n=2)
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


def _lines(text: str) -> list[str]:
    """Return the lines of a text with their ends: other characters that Python takes for one end none."""
    return [line for line in re.split(r"(?<=\n)", text) if line]


def _write(text: str) -> None:
    """Write a text on standard output, byte for byte: lines end as they do in the document."""
    sys.stdout.flush()
    sys.stdout.buffer.write(text.encode("utf-8"))
    sys.stdout.buffer.flush()


def _what_remains(copy: CorrectedCopy) -> list[str]:
    from armproof.verification.document.front_matter import suffix_of
    from armproof.verification.report.text import describe_place

    notebook = suffix_of(copy.path) == ".ipynb"
    messages = []
    for record in copy.remaining:
        place = f"{copy.path}: {describe_place(record)}:" if notebook else f"{copy.path}:{record.line}:"
        template = noted("not corrected: {verdict}{reason}")
        if record.erratum:
            template = noted("not corrected: erratum not refuted but {verdict}{reason}")
        reason = f", {record.message}" if record.message else ""
        messages.append(f"{place} {written(template, verdict=look_up(record.verdict), reason=reason)}")
    return messages
