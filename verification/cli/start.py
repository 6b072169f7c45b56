"""`armproof start`: the front matter that fixes what is inferred of a document's arm."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from armproof.models.language import look_up
from armproof.verification.cli.application import CANNOT_RUN, Language, ending, tell

if TYPE_CHECKING:
    from armproof.verification.verdict import TakenArm

Source = Annotated[Path, typer.Argument(metavar="FILE", help="A document or a notebook.", show_default=False)]
Write = Annotated[bool, typer.Option("--write", help="Insert it at the head of the document.")]


def start(path: Source, write: Write = False, lang: Language = "") -> None:
    """Print the front matter that fixes which arm a document is taken to be about.

    With --write it is inserted; keys that the document has stay as they are. Exit code 2: nothing was inferred.
    """
    from armproof.verification.document import parse_document
    from armproof.verification.document.front_matter import read_bytes
    from armproof.verification.document.head import head_of, with_front_matter
    from armproof.verification.running.atomic import write_atomically

    try:
        with ending():
            text = read_bytes(path).decode("utf-8")
            document = parse_document(path, text.removeprefix("\ufeff"))
            if not {"arm", "arms"}.isdisjoint(document.front):
                tell("{path}: its front matter names the arm already", path=path)
                return
            block = _inferred(path).front_matter
            if write:
                write_atomically(path, with_front_matter(document, text, block).encode("utf-8"))
            else:
                typer.echo(head_of(path.suffix, block), nl=False)
    except UnicodeDecodeError:
        tell("{path}: not UTF-8", path=path)
        raise typer.Exit(CANNOT_RUN) from None
    except OSError as error:
        tell("{path}: cannot be written: {reason}", path=path, reason=error.strerror)
        raise typer.Exit(CANNOT_RUN) from None


def _inferred(path: Path) -> TakenArm:
    """Return the one arm that a document shows; ends the command, with the reason, where it shows none or several."""
    from armproof.verification.document import read_document
    from armproof.verification.tables.arms import infer_arm, scopes

    found = [infer_arm(part) for part in scopes(read_document(path))]
    arms = [each.arm for each in found if each.arm is not None]
    if len(arms) == 1:
        tell(
            "{path}: taken from the {source} at line {line}",
            path=path,
            source=look_up(arms[0].source),
            line=arms[0].line,
        )
        return arms[0]
    if arms:
        tell("{path}: it shows {count} arms, at lines {lines}; front matter names one", path=path, count=len(arms),
             lines=", ".join(str(arm.line) for arm in arms))  # fmt: skip
    else:
        problems = [each for each in found if each.problem is not None] or found[:1]
        reason = problems[0].problem or look_up("it has no DH table and no link matrices that give one")
        tell("{path}: no arm is inferred: {reason}", path=path, reason=reason)
    raise typer.Exit(CANNOT_RUN)
