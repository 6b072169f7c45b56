"""Headings of the same words are one section only under the same headings."""

from __future__ import annotations

from copy import deepcopy

from armproof.verification.document.heading import begin_section, encloses


def test_a_heading_is_told_by_those_around_it() -> None:
    first = begin_section("", "Question 1", 2)
    part = begin_section(first, "Part B", 3)
    other = begin_section(begin_section(part, "Question 2", 2), "Part B", 3)
    assert part == "Part B" == other and part != other
    assert part == begin_section(first, "Part B", 3) and {part: 1}.get(other) is None
    assert encloses(first, part) and encloses(part, part) and not encloses(part, other)
    assert deepcopy(part) == part != deepcopy(other)
