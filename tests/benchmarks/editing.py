"""An edit in a long document: how soon the language server tells its display, and what depends on it."""

from __future__ import annotations

import asyncio
import statistics
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from lsprotocol import types

from tests.verification.cli.editor import Editor, editing
from tests.verification.cli.test_lsp import FRONT

DISPLAYS, EDITED = 60, 30
ROUNDS = 7
VECTOR = "$$ p_2 = [l_1 {} + l_2 C_{{12}}, l_1 S_1 + l_2 S_{{12}}, 0]^T $$"


@dataclass(frozen=True)
class Times:
    """Seconds from an edit to the diagnostics of its display, and to those of all that depends on it."""

    own: float
    all: float


def measure() -> Times:
    """Return the medians of several edits of a definition in display 30 of 60, on which all displays behind it rest."""
    rounds = asyncio.run(_rounds())
    return Times(statistics.median(own for own, _ in rounds), statistics.median(last for _, last in rounds))


def text_with(definition: str) -> str:
    """Return the document with a definition in its display 30."""
    before = [VECTOR.format("C_1")] * (EDITED - 1)
    return FRONT + "\n\n".join([*before, f"$$ K = {definition} $$", *[VECTOR.format("K")] * (DISPLAYS - EDITED)]) + "\n"


async def _rounds() -> list[tuple[float, float]]:
    with tempfile.TemporaryDirectory() as folder:
        async with editing(Path(folder) / "a.md") as editor:
            await editor.write(text_with("\\cos\\theta_1"))
            wrong, right = text_with("\\sin\\theta_1"), text_with("\\cos\\theta_1")
            return [await _time(editor, wrong if k % 2 == 0 else right) for k in range(ROUNDS)]


async def _time(editor: Editor, text: str) -> tuple[float, float]:
    editor.number += 1
    document = types.VersionedTextDocumentIdentifier(editor.number, editor.uri)
    whole = types.TextDocumentContentChangeWholeDocument(text)
    started = time.perf_counter()
    editor.client.text_document_did_change(types.DidChangeTextDocumentParams(document, [whole]))
    times: list[float] = []
    while True:
        try:
            told = await asyncio.wait_for(editor.told.get(), 3.0)
        except TimeoutError:
            return times[0], times[-1]
        if told.version == editor.number:
            times.append(time.perf_counter() - started)
