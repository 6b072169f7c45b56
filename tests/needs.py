"""Tests of what not every installation has: their files are collected without loading it, which takes seconds in each process."""

from importlib.util import find_spec

import pytest


def needs(package: str) -> None:
    """Skip a file of tests where a package is not installed."""
    if find_spec(package) is None:
        pytest.skip(f"{package} is not installed", allow_module_level=True)
