"""The language server of `armproof lsp`: it tells the verdicts while a document is typed."""

from __future__ import annotations

import asyncio
import threading
import time
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

from armproof.models.language import look_up, spoken, use
from armproof.verification.document import SUFFIXES
from armproof.verification.document.rewriting import Change, Place
from armproof.verification.running.editing import EditedDocument, Mark
from armproof.verification.verdict import Verdict

if TYPE_CHECKING:
    from lsprotocol import types
    from pygls.lsp.server import LanguageServer

SOON = 0.1  # seconds between two sets of diagnostics, but for the first


@dataclass(frozen=True)
class _Text:
    """A document as it is now, the number of its version, and the loop that its diagnostics are sent from."""

    uri: str
    source: str
    number: int | None
    loop: asyncio.AbstractEventLoop


class Desk:
    """The documents that are open, checked one after the other by one thread; a newer text takes the place of an older."""

    def __init__(self, server: LanguageServer) -> None:
        self.documents: dict[str, EditedDocument] = {}
        self._server, self._lang = server, spoken()
        self._waiting: dict[str, _Text] = {}
        self._work = threading.Condition()
        threading.Thread(target=self._serve, daemon=True).start()

    def take(self, uri: str) -> None:
        """Have a document checked as it is now; called in the server's loop."""
        text = self._server.workspace.get_text_document(uri)
        if Path(text.path).suffix in SUFFIXES:
            with self._work:
                self.documents.setdefault(uri, EditedDocument(Path(text.path)))
                self._waiting[uri] = _Text(uri, text.source, text.version, asyncio.get_running_loop())
                self._work.notify()

    def close(self, uri: str) -> None:
        """Forget a document."""
        with self._work:
            self.documents.pop(uri, None)
            self._waiting.pop(uri, None)

    def _serve(self) -> None:
        with use(self._lang):
            while True:
                with self._work:
                    self._work.wait_for(lambda: bool(self._waiting))
                    text = self._waiting.pop(next(reversed(self._waiting)))
                    edited = self.documents[text.uri]
                self._check(edited, text)

    def _check(self, edited: EditedDocument, text: _Text) -> None:
        told = 0.0
        for _ in edited.update(text.source):
            if text.uri in self._waiting:
                return
            if time.monotonic() - told > SOON:
                told = time.monotonic()
                self._tell(edited, text)
        self._tell(edited, text)

    def _tell(self, edited: EditedDocument, text: _Text) -> None:
        from lsprotocol import types

        lines = text.source.split("\n")
        found = [_diagnostic(mark, lines) for mark in edited.marks()]
        params = types.PublishDiagnosticsParams(text.uri, found, text.number)
        text.loop.call_soon_threadsafe(self._server.text_document_publish_diagnostics, params)


def make_server() -> LanguageServer:
    """Return the server, with its features."""
    from lsprotocol import types
    from pygls.lsp.server import LanguageServer

    server = LanguageServer("armproof", version("armproof"))
    desk = Desk(server)

    def changed(params: Any) -> None:
        desk.take(params.text_document.uri)

    def closed(params: types.DidCloseTextDocumentParams) -> None:
        desk.close(params.text_document.uri)

    def hover(params: types.HoverParams) -> types.Hover | None:
        edited = desk.documents.get(params.text_document.uri)
        told = edited.hover(params.position.line + 1) if edited is not None else ""
        return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, f"```text\n{told}\n```")) if told else None

    def fixes(params: types.CodeActionParams) -> list[types.CodeAction]:
        uri = params.text_document.uri
        edited = desk.documents.get(uri)
        changes = edited.fix(params.range.start.line + 1) if edited is not None else []
        return [_fix(uri, changes, server.workspace.get_text_document(uri).source.split("\n"))] if changes else []

    for feature in (types.TEXT_DOCUMENT_DID_OPEN, types.TEXT_DOCUMENT_DID_CHANGE, types.TEXT_DOCUMENT_DID_SAVE):
        server.feature(feature)(changed)
    server.feature(types.TEXT_DOCUMENT_DID_CLOSE)(closed)
    server.feature(types.TEXT_DOCUMENT_HOVER)(hover)
    server.feature(types.TEXT_DOCUMENT_CODE_ACTION)(fixes)
    return server


def _diagnostic(mark: Mark, lines: list[str]) -> types.Diagnostic:
    from lsprotocol import types

    levels = types.DiagnosticSeverity
    level = levels.Error if mark.fails else levels.Information if mark.verdict is Verdict.UNCHECKED else levels.Hint
    return types.Diagnostic(
        _range(mark.start, mark.end, lines), mark.message, level, mark.verdict.value, source="armproof"
    )


def _fix(uri: str, changes: list[Change], lines: list[str]) -> types.CodeAction:
    from lsprotocol import types

    edits = [types.TextEdit(_range(change.start, change.end, lines), change.text) for change in changes]
    return types.CodeAction(
        look_up("Write what is right"), types.CodeActionKind.QuickFix, edit=types.WorkspaceEdit({uri: edits})
    )


def _range(start: Place, end: Place, lines: list[str]) -> types.Range:
    """Return a place as the protocol counts: lines from 0, columns in units of UTF-16."""
    from lsprotocol import types

    def position(line: int, column: int) -> types.Position:
        before = lines[line - 1][:column] if line <= len(lines) else ""
        return types.Position(line - 1, len(before.encode("utf-16-le")) // 2)

    return types.Range(position(*start), position(*end))


if __name__ == "__main__":
    make_server().start_io()
