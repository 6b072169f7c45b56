"""The story: a document to its verdicts, one record a display, one a DH table."""

from armproof.verification.check.document import (
    DocumentChecker,
    check_document,
    load_arm_of,
    plainly,
    verify,
    verify_text,
)
from armproof.verification.check.limits import SECONDS_TO_DECIDE, SECONDS_TO_EXPLAIN

__all__ = [
    "SECONDS_TO_DECIDE",
    "SECONDS_TO_EXPLAIN",
    "DocumentChecker",
    "check_document",
    "load_arm_of",
    "plainly",
    "verify",
    "verify_text",
]
