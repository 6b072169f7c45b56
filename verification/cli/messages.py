"""What the commands say on standard error."""

from __future__ import annotations

import sys
from collections.abc import Iterable

from armproof.verification.report.lines import write_lines


def complain(messages: Iterable[str]) -> None:
    """Write each message on standard error, on one line."""
    write_lines((((f"armproof: {message}", ""),) for message in messages), sys.stderr)
