"""Words beside an equation that leave it what it is, and words that do not."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import DocumentResult

Check = Callable[..., DocumentResult]


@pytest.mark.parametrize(
    ("harmless", "open_"), [("exact", "exact?"), ("as expected", "not as expected"), ("well known", "no longer known")]
)
def test_words_beside_an_equation_are_known_to_leave_it_or_it_is_open(check: Check, harmless: str, open_: str) -> None:
    found = check(*(rf"c_{{12}} = c_1 c_2 - s_1 s_2 \quad \text{{{words}}}" for words in (harmless, open_)))
    assert [record.verdict.value for record in found.equations] == ["proved", "unchecked"]
