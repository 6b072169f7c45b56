"""What is said of the documents that were found is what is on record."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.laws import PART, SWEEP
from tests.mutation.source.trusted import ROOT
from tests.reached.documents import Reached, Text, load

GROUP = 50
FOUND = load() if SWEEP or not PART else load()[::4]  # `python -m tests.reached` compares all, and so does the sweep
GROUPS = [FOUND[at : at + GROUP] for at in range(0, len(FOUND), GROUP)]


@pytest.mark.parametrize("group", GROUPS, ids=lambda group: group[0].name)
def test_what_is_said_is_what_is_on_record(group: tuple[Reached, ...]):
    changed = [each.document.text for each in group if not each.is_said_as_ever]
    assert not changed, "\n".join(["look at each, then: python -m tests.reached --update", *changed])


def test_another_verdict_is_noticed():
    first = next(each for each in load() if "unchecked" in each.said)
    assert first.is_said_as_ever
    assert not Reached(first.document, first.said.replace("unchecked", "proved")).is_said_as_ever


def test_what_would_be_taken_for_a_heading_cannot_stand_on_record():
    assert all(each.document.can_stand for each in load())
    assert not any(Text(text).can_stand for text in ("$$ 1 = 1 $$", "===== a\n$$ 1 = 1 $$\n", "$$ 1 = 1 $$\r\n"))


def test_what_is_not_asked_for_is_noted_too():
    code = (
        "from tests.reached import outcomes; outcomes.note()\n"
        "from armproof.verification.check import verify_text\n"
        "verify_text('$$ 1 = 1 $$')\n"
        "noted = outcomes.NOTED; print(any(o[1:] == (False, True) for o in noted), len({o[0] for o in noted}) > 100)"
    )
    said = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert said == "True True\n"
