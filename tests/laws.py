"""How much of a law is tried: some in `make test`, the rest in `make test-rest`, all in `make sweep`; the same at every run."""

import os
from math import inf

from hypothesis import settings

SWEEP = bool(os.environ.get("ARMPROOF_SWEEP"))
PART = "" if SWEEP else os.environ.get("ARMPROOF_PART", "")  # "some", "rest", or both where pytest is called by hand
# Seconds of the clock, behind which nothing of the rest is begun.
UNTIL = float(os.environ.get("ARMPROOF_REST_UNTIL", "inf")) if PART == "rest" else inf


def examples(count: int) -> settings:
    """Return the settings of a law: none of its examples is timed, for it holds or it does not."""
    return settings(max_examples=count if SWEEP else -(-count // 4), derandomize=True, deadline=None, database=None)


def is_in_part(position: int, one_in: int, part: str = PART) -> bool:
    """Return whether what stands there among its like is in this part: the first of so many in some (of 0 none), the others in the rest."""
    return not part or (one_in > 0 and position % one_in == 0) == (part == "some")
