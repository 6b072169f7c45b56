"""The story: a document to its verdicts, one record a display, one a DH table."""

from armproof.verification.check.document_checker import DocumentChecker, load_arm_of
from armproof.verification.check.documents import check_document, verify, verify_text
from armproof.verification.check.limits import SECONDS_TO_DECIDE, SECONDS_TO_EXPLAIN
from armproof.verification.check.parts import plainly

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
