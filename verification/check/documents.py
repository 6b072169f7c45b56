"""From a document, a file or a text to its verdicts: one record a display, one a DH table."""

from __future__ import annotations

from pathlib import Path

from armproof.models.arm import Arm
from armproof.verification.check.document_checker import DocumentChecker, load_arm_of
from armproof.verification.check.parts import joined, plainly, unless_of_another_arm
from armproof.verification.diagnosis.accepted import with_accepted
from armproof.verification.document import Document, parse_document, read_document
from armproof.verification.tables.arms import Inference, infer_arm, scopes, unless_disputed, with_armless
from armproof.verification.verdict import DocumentResult


def verify(path: Path | str, *, confirm: bool = True, correct: bool = False) -> DocumentResult:
    """Return the verdicts of a document file; raises DocumentError where the document as a whole cannot be checked."""
    return check_document(read_document(Path(path)), confirm=confirm, correct=correct)


def verify_text(
    text: str, format: str = "", *, path: Path | str = "document.md", confirm: bool = True, correct: bool = False
) -> DocumentResult:
    """Return the verdicts of a document's text, as `verify` does of a file that holds it.

    Args:
        text: the document, front matter and all.
        format: how it is read: md, qmd, ipynb, py, tex or rst; by default as the name of `path` says.
        path: the file that it belongs to, which need not exist: it names the document in the result and in messages, and
            arms that are given by a relative path are sought from its folder.
        confirm, correct: as for `check_document`.

    Raises:
        DocumentError: the document as a whole cannot be checked.
    """
    return check_document(
        parse_document(Path(path), text.removeprefix("\ufeff"), format), confirm=confirm, correct=correct
    )


def check_document(
    document: Document, *, confirm: bool = True, correct: bool = False, arm: Arm | None = None, samples: bool = True
) -> DocumentResult:
    """Return the verdicts of a document.

    Args:
        document: what was read.
        confirm: also evaluate each proved equation on the double plant.
        correct: also seek what mends each refuted one.
        arm: the document's arm, such as one read from a value; by default the one that its front matter names.
        samples: whether samples may be taken. Without them neither NumPy nor Drake is needed, and what they alone
            decide is unchecked.
    """
    seeks = arm is None and ("arms" in document.front or (samples and "arm" not in document.front))
    parts = [infer_arm(part) for part in scopes(document)] if seeks else [Inference(document)]
    options = confirm and samples, correct and samples, samples
    results = [DocumentChecker(p.document, arm or load_arm_of(p.document), *options, p).run() for p in parts]
    results = [unless_of_another_arm(k, parts, result) for k, result in enumerate(results)] if samples else results
    if seeks and samples:
        results = [unless_disputed(part, result, plainly) for part, result in zip(parts, results, strict=True)]
        results = [with_armless(part, result, plainly) for part, result in zip(parts, results, strict=True)]
    result = results[0] if len(results) == 1 else joined(document, results)
    return with_accepted(document, result) if document.accepts else result
