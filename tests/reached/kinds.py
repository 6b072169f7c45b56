"""What is heard where two words of whatever classes stand in a sentence, on record: `clauses.py` decides by classes alone.

Sentences that people write hold few of the pairs that a rule tells apart; here each pair stands in some sentences, sense or not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from armproof.verification.document import word_classes
from armproof.verification.document.hearing import words_of
from tests.reached.heard import ASKED

RECORD = Path(__file__).parent / "kinds.txt"
HEADER = "# What is heard in sentences of two classes of words; see kinds.py. Written by `python -m tests.reached --update`.\n"
SENTENCES = (
    "This {} {}.",
    "The formula {} the {} one.",
    "{} the arm is {}, we have",
    "The angle {} {} ¤.",
    "{} {} this is right?",
    "We {} that the sign is {}",
)
LETTERS = dict(zip(ASKED, "ABHNabnsfg", strict=True))


@lru_cache
def words() -> Mapping[str, str]:
    """Return a word of each class: the last, which few other classes have."""
    found = {}
    for line in word_classes.ENGLISH.strip().replace("\n ", " ").split("\n"):
        kind, *those = line.split()
        found[kind] = those[-1].replace("_", " ").replace("~", "ed")
    return found


def heard_with(first: str) -> str:
    """Return what is heard in the sentences with a word of a class before one of each other class, in letters; - where nothing is."""
    return " ".join(f"{second}={','.join(_told(first, second))}" for second in words())


def _told(first: str, second: str) -> Iterator[str]:
    for sentence in SENTENCES:
        said = words_of(sentence.format(words()[first], words()[second]))
        said = said[:1].upper() + said[1:]
        yield "".join(LETTERS[name] for name, asked in ASKED.items() if asked(said)) or "-"


@lru_cache
def read_record() -> Mapping[str, str]:
    """Return what is heard with each class."""
    _, *lines = RECORD.read_text("utf-8").splitlines()
    return dict(line.split(": ", 1) for line in lines)  # type: ignore[misc]


def write_record() -> None:
    """Write the record anew."""
    RECORD.write_text(HEADER + "".join(f"{kind}: {heard_with(kind)}\n" for kind in words()), "utf-8")
    read_record.cache_clear()


def is_heard_as_ever(kind: str) -> bool:
    """Whether with a word of a class is heard what is on record."""
    return heard_with(kind) == read_record().get(kind)
