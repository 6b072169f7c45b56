"""`armproof lsp`: a language server on standard input and output; an entry point, loaded when it is called."""

from __future__ import annotations

from importlib.util import find_spec

import typer

from armproof.verification.cli.application import CANNOT_RUN, Language, tell


def lsp(lang: Language = "") -> None:
    """Serve an editor: verdicts while typing, readings on hover, corrections as quick fixes.

    Needs an extra: pip install 'armproof[lsp]'. Exit code 2: it is not installed.
    """
    if find_spec("pygls") is None:
        tell("the language server needs pygls: pip install 'armproof[lsp]'")
        raise typer.Exit(CANNOT_RUN)
    from armproof.verification.cli.server import make_server

    make_server().start_io()
