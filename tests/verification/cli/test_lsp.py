"""The language server, asked over standard input and output by a client of its own, as an editor does."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pygls")

from lsprotocol import types
from pygls.lsp.client import LanguageClient

FRONT = "---\narm: planar_2r\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n\n"
RIGHT = "$$ p_2 = [l_1 C_1 + l_2 C_{12}, l_1 S_1 + l_2 S_{12}, 0]^T $$\n\n"
WRONG = "$$ \\det J_v = l_1 l_2 \\cos\\theta_2 $$\n\n"


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


def run(work: Callable[[Editor], Awaitable[None]], path: Path) -> None:
    async def whole() -> None:
        async with editing(path) as editor:
            await work(editor)

    asyncio.run(asyncio.wait_for(whole(), 120))


def mended(text: str, action: types.CodeAction) -> str:
    """Return a text with the edits of an action."""
    lines = text.split("\n")
    assert action.edit is not None and action.edit.changes is not None
    (edits,) = action.edit.changes.values()
    for edit in sorted(edits, key=lambda each: -each.range.start.character):
        at, start, end = edit.range.start.line, edit.range.start.character, edit.range.end.character
        assert edit.range.end.line == at
        units = lines[at].encode("utf-16-le")
        lines[at] = (units[: 2 * start] + edit.new_text.encode("utf-16-le") + units[2 * end :]).decode("utf-16-le")
    return "\n".join(lines)


def test_a_wrong_entry_is_marked_hovered_and_mended_while_typing(tmp_path: Path) -> None:
    async def work(editor: Editor) -> None:
        assert await editor.write(FRONT + RIGHT) == []
        text = FRONT + RIGHT + "🦾 \n\n" + WRONG
        (wrong,) = await editor.write(text)
        line = text.split("\n").index(WRONG.strip())
        assert wrong.range.start.line == line and wrong.severity == types.DiagnosticSeverity.Error
        marked = text.split("\n")[line][wrong.range.start.character : wrong.range.end.character]
        assert "cos" in marked and "p_2" not in marked and wrong.code == "refuted"
        told = await editor.hover(line)
        assert "claim, refuted" in told and "for example at" in told and "sin" in told
        assert "claim, proved: origin of frame 2 in frame 0" in await editor.hover(6)
        assert await editor.hover(0) == ""
        (action,) = await editor.fixes(wrong.range)
        assert await editor.write(mended(text, action)) == []
        assert await editor.fixes(wrong.range) == []
        uses = "$$ K = \\cos\\theta_1 $$\n\n$$ p_2 = [l_1 K + l_2 C_{12}, l_1 S_1 + l_2 S_{12}, 0]^T $$\n\n"
        assert await editor.write(FRONT + uses) == []
        found = await editor.write(FRONT + uses.replace("K = \\cos", "K = 1 + \\sin"))
        assert 8 in {each.range.start.line for each in found}, "what depends on it"

    run(work, tmp_path / "a.md")
