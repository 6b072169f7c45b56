"""What is said of documents that are made of others, and what is heard in sentences, is what is on record."""

from __future__ import annotations

import pytest

from tests.laws import PART, SWEEP
from tests.reached import derived, documents, heard, in_full, kinds

GROUP = 50
ALL, ALL_IN_FULL = [*derived.read_record()], [*in_full.read_record()]
NAMES = ALL if SWEEP or not PART else ALL[::12]  # `python -m tests.reached` compares all, and so does the sweep
IN_FULL = ALL_IN_FULL if SWEEP or not PART else ALL_IN_FULL[::4]


@pytest.mark.parametrize("first", NAMES[::GROUP])
def test_what_is_said_is_what_is_on_record(first: str):
    begin = NAMES.index(first)
    documents = [derived.load()[name] for name in NAMES[begin : begin + GROUP]]
    changed = [each.document.text for each in documents if not each.is_said_as_ever]
    assert not changed, "\n".join(["look at each, then: python -m tests.reached --update", *changed])


@pytest.mark.parametrize("first", IN_FULL[::GROUP])
def test_what_is_said_in_full_is_what_is_on_record(first: str):
    begin = IN_FULL.index(first)
    changed = [name for name in IN_FULL[begin : begin + GROUP] if not in_full.is_said_as_ever(name)]
    assert not changed, "\n".join(["look at each, then: python -m tests.reached --update", *changed])


def test_what_is_heard_is_what_is_on_record():
    changed = [sentence for sentence in heard.known_sentences() if not heard.is_heard_as_ever(sentence)]
    assert not changed, "\n".join(["look at each, then: python -m tests.reached --update", *changed])
    assert {*heard.known_sentences()} == {*heard.read_record()}


@pytest.mark.parametrize("kind", kinds.words())
def test_what_is_heard_beside_a_word_of_a_class_is_what_is_on_record(kind: str):
    assert kinds.heard_with(kind) == kinds.read_record()[kind]


def test_nothing_is_on_record_that_is_not_made_and_little_is_left_out():
    made = [documents.Reached(document, "").name for document in derived.derived()]
    assert len({*made}) == len(made) and {*derived.read_record()} <= {*made}
    assert len(derived.load()) > 0.98 * len(made)
    assert [*in_full.load()] == ALL_IN_FULL


def test_a_sentence_heard_otherwise_is_noticed(monkeypatch: pytest.MonkeyPatch):
    sentence = "This is wrong."
    assert heard.is_heard_as_ever(sentence)
    monkeypatch.setitem(heard.ASKED, "denies above", lambda words: False)
    assert not heard.is_heard_as_ever(sentence)


def test_a_sentence_is_heard_in_each_of_its_ways():
    assert [*heard.ways("This is wrong.")] == [
        "This is wrong.",
        "This is wrong?",
        "This is wrong:",
        "(This is wrong.)",
        "this is wrong.",
    ]
