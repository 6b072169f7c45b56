"""The language server, asked over standard input and output by a client of its own, as an editor does."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import TYPE_CHECKING

from tests.needs import needs

if TYPE_CHECKING:
    from lsprotocol import types

    from tests.verification.cli.editor import Editor

needs("pygls")
FRONT = "---\narm: planar_2r\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n\n"
RIGHT = "$$ p_2 = [l_1 C_1 + l_2 C_{12}, l_1 S_1 + l_2 S_{12}, 0]^T $$\n\n"
WRONG = "$$ \\det J_v = l_1 l_2 \\cos\\theta_2 $$\n\n"


def run(work: Callable[[Editor], Awaitable[None]], path: Path) -> None:
    from tests.verification.cli.editor import editing

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
        assert wrong.range.start.line == line and wrong.severity == 1  # an error
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
