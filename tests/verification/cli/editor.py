"""An editor for the tests: a client of the language server, over standard input and output."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from lsprotocol import types
from pygls.lsp.client import LanguageClient


class Editor:
    """A client with one document open: what it was told of it, and what it asks."""

    def __init__(self, client: LanguageClient, path: Path) -> None:
        self.client, self.uri, self.after, self.number = client, path.as_uri(), path.with_name("after.md").as_uri(), 0
        self.told: asyncio.Queue[types.PublishDiagnosticsParams] = asyncio.Queue()

        @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def told(params: types.PublishDiagnosticsParams) -> None:
            self.told.put_nowait(params)

    async def write(self, text: str) -> list[types.Diagnostic]:
        """Open the document or change it as a whole; return its diagnostics once they are settled."""
        self.number += 1
        self.put(self.uri, text)
        found = await self.next_told()
        self.put(
            self.after, "$$ 1 = 1 $$\n"
        )  # documents are checked one after the other: told of this one, the first is done
        while (told := await self.next_told()).uri != self.after:
            found = told
        return list(found.diagnostics)

    def put(self, uri: str, text: str) -> None:
        if self.number == 1:
            item = types.TextDocumentItem(uri, "markdown", self.number, text)
            self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
        else:
            document = types.VersionedTextDocumentIdentifier(self.number, uri)
            whole = types.TextDocumentContentChangeWholeDocument(text)
            self.client.text_document_did_change(types.DidChangeTextDocumentParams(document, [whole]))

    async def next_told(self) -> types.PublishDiagnosticsParams:
        """Return what is told next of a document as it is now."""
        while (told := await asyncio.wait_for(self.told.get(), 60)).version != self.number:
            pass
        return told

    async def ask(self, request: Callable[[Any], Awaitable[Any]], params: Any) -> Any:
        return await asyncio.wait_for(request(params), 30)

    async def hover(self, line: int) -> str:
        place = types.TextDocumentIdentifier(self.uri)
        found = await self.ask(self.client.text_document_hover_async, types.HoverParams(place, types.Position(line, 3)))
        return found.contents.value if found is not None else ""

    async def fixes(self, where: types.Range) -> list[types.CodeAction]:
        place, context = types.TextDocumentIdentifier(self.uri), types.CodeActionContext([])
        return (
            await self.ask(self.client.text_document_code_action_async, types.CodeActionParams(place, where, context))
            or []
        )


@asynccontextmanager
async def editing(path: Path) -> AsyncIterator[Editor]:
    client = LanguageClient("test", "1")
    await client.start_io(sys.executable, "-m", "armproof.verification.cli.server")
    try:
        await client.initialize_async(types.InitializeParams(types.ClientCapabilities()))
        client.initialized(types.InitializedParams())
        yield Editor(client, path)
    finally:
        await client.shutdown_async(None)
        client.exit(None)
        await client.stop()
