"""Check a document again after it was changed: only the displays that its verdicts can have changed of.

A display's verdict rests on the names that those before it define. The document's state is kept after each display; from
the first one that differs the displays are checked anew, until what follows is as it was and so is the state.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.check import DocumentChecker, check_document, load_arm_of, plainly
from armproof.verification.diagnosis.accepted import accepted, with_accepted
from armproof.verification.document import Display, Document
from armproof.verification.equations.later_definitions import AHEAD
from armproof.verification.naming.reading import spelling_of
from armproof.verification.naming.state import DocumentState
from armproof.verification.tables.arms import Inference, infer_arm, scopes, unless_disputed
from armproof.verification.verdict import DocumentResult, Record


@dataclass(frozen=True)
class _Checked:
    """A display with its verdict and the document's state behind it."""

    display: Display
    record: Record
    after: DocumentState


class IncrementalChecker:
    """The verdicts of one document, kept up to date; `result` is that of the last update."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.result: DocumentResult | None = None
        self._front: object = None
        self._checker: DocumentChecker | None = None
        self._before: DocumentState | None = None
        self._checked: list[_Checked] = []

    def update(self, document: Document) -> Iterator[Record]:
        """Yield the verdict of each display that is checked again; then `result` is that of the document as it is now.

        Raises DocumentError where the document as a whole cannot be checked; the next update then begins anew.
        """
        parts = scopes(document)
        if len(parts) > 1:  # each part has names of its own: all are checked again
            yield from self._begin_whole(document)
            return
        found = infer_arm(parts[0])
        document, checker = found.document, self._checker
        # a fraction of an angle changes in which generators values are written: what follows may be written otherwise
        fresh = checker is None or bool(checker.ring.parts) or (document.front, document.lines) != self._front
        if checker is not None and spelling_of(document, checker.names.reader.words) != checker.names.reader.spelling:
            fresh = True
        if checker is not None and not fresh:
            fresh = not checker.beforehand.is_shown_by(document)
        self.result = None
        if fresh:
            self._begin(found)
        yield from self._continue(found)

    def _begin_whole(self, document: Document) -> Iterator[Record]:
        before = self.result.records if self.result is not None else ()
        self._checker, self._checked = None, []
        self.result = check_document(document)
        yield from (record for record in self.result.equations if record not in before)

    def _begin(self, found: Inference) -> None:
        self._checker, self._checked, document = None, [], found.document
        checker = DocumentChecker(document, load_arm_of(document), inferred=found)
        self._checker, self._front = checker, (document.front, document.lines)
        self._before = checker.names.state.copy()

    def _continue(self, found: Inference) -> Iterator[Record]:
        assert self._checker is not None and self._before is not None
        document, checker, old = found.document, self._checker, self._checked
        kept = next(
            (k for k, (a, b) in enumerate(zip(document.displays, old, strict=False)) if not _alike(a, b.display)),
            min(len(document.displays), len(old)),
        )
        changed = kept
        kept = min((k for k in range(max(0, kept - AHEAD), kept) if checker.lacked(old[k].display)), default=kept)
        self._checked = checked = old[:kept]
        checker.names.state.become(checked[-1].after if checked else self._before)
        checker.go_on_with(document, found)
        known = {_key(each.display) for each in old}
        for index in range(kept, len(document.displays)):
            if index > kept and _goes_on_as_before(document.displays, index, old, checked[-1]):
                checked.extend(old[index:])
                checker.names.state.become(checked[-1].after)
                break
            display = document.displays[index]
            record = checker.check_display(display)
            checked.append(_Checked(display, record, checker.names.state.copy()))
            is_other = index < changed and record != old[index].record
            if _key(display) not in known or index == changed or is_other:
                yield accepted(document, record)
        result = checker.result_of(tuple(each.record for each in checked))
        self.result = with_accepted(document, unless_disputed(found, result, plainly))


def _key(display: Display) -> tuple[str, bool]:
    return display.latex, display.erratum


def _alike(display: Display, before: Display) -> bool:
    """Whether a display would get the record that it had: the same formula at the same place."""
    return display == before


def _goes_on_as_before(displays: tuple[Display, ...], index: int, old: list[_Checked], last: _Checked) -> bool:
    """Whether the displays from one on are those that were there, and the state before them is what it was."""
    return (
        len(displays) == len(old)
        and all(_alike(a, b.display) for a, b in zip(displays[index:], old[index:], strict=True))
        and last.after == old[index - 1].after
    )
