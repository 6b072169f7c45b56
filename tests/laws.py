"""How many examples a law is tried on: a quarter of them in `make test`, all in `make sweep`; the same ones at every run."""

import os

from hypothesis import settings

SWEEP = bool(os.environ.get("ARMPROOF_SWEEP"))


def examples(count: int) -> settings:
    """Return the settings of a law: none of its examples is timed, for it holds or it does not."""
    return settings(max_examples=count if SWEEP else -(-count // 4), derandomize=True, deadline=None, database=None)
