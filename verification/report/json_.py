"""The report for other programs: one JSON object."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import isfinite
from typing import Any

from verification.batch import Failure
from verification.verdict import DocumentResult, summary


def json_report(results: Sequence[DocumentResult | Failure], *, strict: bool = False) -> str:
    """Return the verdicts as one JSON object in ASCII, ending in a newline.

    {"documents": [...], "summary": {...}}, and beside them "errors": [{"path", "line", "message"}] where a document
    could not be checked. With `strict`, "passed" counts an unchecked display as a failure.
    """
    documents = [result for result in results if isinstance(result, DocumentResult)]
    failures = [result for result in results if isinstance(result, Failure)]
    report: dict[str, Any] = {
        "documents": [
            {**document.as_json(), "passed": document.passed_strictly() if strict else document.passed}
            for document in documents
        ],
        "summary": summary(documents),
    }
    if failures:
        report["errors"] = [
            {"path": failure.path, "line": failure.line, "message": failure.message} for failure in failures
        ]
    return json.dumps(_finite(report), indent=1, allow_nan=False) + "\n"


def _finite(value: Any) -> Any:
    """Return the value with null for every number that JSON cannot write."""
    if isinstance(value, float):
        return float(value) if isfinite(value) else None
    if isinstance(value, dict):
        return {str(key): _finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return value
