"""What is heard in sentences, each said as it is, as a question, as one that leads on, and as one that goes on, on record.

They are those of `tests/sweeps/sentences.yaml`, of the labelled pages, and of the handouts. A sentence is heard in few documents
at one place; here each is asked of every place.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

from armproof.verification.document.clauses import clauses, goes_on
from armproof.verification.document.denying_clauses import (
    denies_as_heading,
    denies_beside,
    denies_what_is_above,
    denies_what_is_below,
)
from armproof.verification.document.hearing import STOP, words_of
from armproof.verification.document.limiting_clauses import (
    limits_what_is_above,
    limits_what_is_below,
    limits_what_is_near,
)
from armproof.verification.document.strange import is_strange_before, is_strange_behind, strange_words
from tests.labelled import bare
from tests.labelled.pages import load_pages
from tests.reached.search import handouts
from tests.sweeps import sentences

RECORD = Path(__file__).parent / "heard.txt"
HEADER = "# What is heard in sentences; see heard.py. Written by `python -m tests.reached --update`.\n"
NO_PROSE = re.compile(r"\A---\n.*?\n---\n|\$\$.*?\$\$|```.*?```|^[|#>].*$", re.DOTALL | re.MULTILINE)
LAYOUT = re.compile(r"\\(?:\[|begin|item|section)|.{400}")
ASKED: Mapping[str, Callable[[str], bool]] = {
    "denies above": denies_what_is_above,
    "denies below": denies_what_is_below,
    "denies beside": denies_beside,
    "denies as heading": denies_as_heading,
    "limits above": limits_what_is_above,
    "limits below": limits_what_is_below,
    "limits near": limits_what_is_near,
    "strange behind": is_strange_behind,
    "strange before": is_strange_before,
    "goes on": goes_on,
}


def known_sentences() -> Iterator[str]:
    """Yield sentences on one line, each once."""
    swept = (words for group in sentences.all_groups() for words in group["sentences"])
    texts = [*(page.text for page in load_pages()), *(document.text() for document in bare.load())]
    texts += [document.text for document in handouts()]
    paragraphs = (part for text in texts for part in NO_PROSE.sub("\n\n", text).split("\n\n"))
    told = (sentence for part in paragraphs for sentence in _sentences(" ".join(part.split())))
    yield from dict.fromkeys((*swept, *told))


def _sentences(line: str) -> list[str]:
    ends = [0, *(stop.end() for stop in STOP.finditer(line)), len(line)]
    found = (line[begin:end].strip() for begin, end in pairwise(ends))
    return [sentence for sentence in found if len(sentence.split()) > 2 and not LAYOUT.search(sentence)]


def heard(sentence: str) -> str:
    """Return what is heard in a sentence said in each way, on one line; = for a way in which it is heard as it is."""
    words, told = words_of(sentence), [*map(_told, ways(sentence))]
    others = ["=" if said == told[0] else said for said in told[1:]]
    return " | ".join([of_clauses(words), " ".join(strange_words(words)) or "-", told[0], *others])


def _told(sentence: str) -> str:
    words = words_of(sentence)
    return ", ".join(name for name, asked in ASKED.items() if asked(words)) or "nothing"


def ways(sentence: str) -> Iterator[str]:
    """Yield a sentence as it is, as a question, as one that leads to a display, in parentheses, and as one that goes on."""
    open_end = sentence.rstrip(" .:;,!?")
    yield sentence
    yield f"{open_end}?"
    yield f"{open_end}:"
    yield f"({sentence})"
    yield sentence[:1].swapcase() + sentence[1:]


def of_clauses(words: str) -> str:
    """Return the subjects of the clauses of a sentence, each with how many words it has."""
    return ", ".join(f"{each.subject or 'none'} {len(each.words)}" for each in clauses(words)) or "no clause"


@lru_cache
def read_record() -> Mapping[str, str]:
    """Return what is heard in each sentence."""
    _, *lines = RECORD.read_text("utf-8").splitlines()
    return dict(zip(lines[::2], (line.strip() for line in lines[1::2]), strict=True))


def write_record() -> None:
    """Write the record anew."""
    lines = (f"{sentence}\n    {heard(sentence)}\n" for sentence in known_sentences())
    RECORD.write_text(HEADER + "".join(lines), "utf-8")
    read_record.cache_clear()


def is_heard_as_ever(sentence: str) -> bool:
    """Whether in a sentence is heard what is on record."""
    return heard(sentence) == read_record().get(sentence)
