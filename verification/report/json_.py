"""The report for other programs: one JSON object."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator
from math import isfinite
from typing import Any

from armproof.verification.verdict import DocumentResult, Failure, summary


def json_report(results: Iterable[DocumentResult | Failure], *, strict: bool = False) -> str:
    """Return the verdicts as one JSON object in ASCII, ending in a newline.

    {"documents": [...], "summary": {...}}, and beside them "errors": [{"path", "line", "message", "findings"}] where a
    document could not be checked. With `strict`, "passed" counts an unchecked display as a failure.
    """
    return "".join(json_parts(results, strict=strict))


def json_parts(results: Iterable[DocumentResult | Failure], *, strict: bool = False) -> Iterator[str]:
    """Yield the pieces of the JSON report, one a document as it comes."""
    counts: Counter[str] = Counter(summary([]))
    failures: list[Failure] = []
    before = '{\n "documents": ['
    for result in results:
        if isinstance(result, Failure):
            failures.append(result)
            continue
        counts.update(summary([result]))
        passed = result.passed_strictly() if strict else result.passed
        yield before + "\n" + _indented({**result.as_json(), "passed": passed}, 2)
        before = ","
    report: dict[str, Any] = {"summary": dict(counts)}
    if failures:
        report["errors"] = [failure.as_json() for failure in failures]
    yield (before + "]" if before != "," else "\n ]") + "," + _indented(report, 0).removeprefix("{") + "\n"


def _indented(value: Any, depth: int) -> str:
    text = json.dumps(_finite(value), indent=1, allow_nan=False)
    return "\n".join(" " * depth + line for line in text.split("\n"))


def _finite(value: Any) -> Any:
    """Return the value with null for every number that JSON cannot write."""
    if isinstance(value, float):
        return float(value) if isfinite(value) else None
    if isinstance(value, dict):
        return {str(key): _finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return value
