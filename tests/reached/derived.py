"""Documents made of what stands elsewhere, each with what we say of it: few mutants make all of them come out as ever.

Sentences at each of their places, bare documents with each of their mistakes or with other data, labelled displays with a slip, everyday names,
and the documents that stand as texts in the tests, of which these ask one thing each. Each is made of its source alone, so that
a new source moves no other. What takes long is not on record: the clock may cut it short.
"""

from __future__ import annotations

import re
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import lru_cache
from pathlib import Path
from random import Random

from tests.labelled import bare
from tests.labelled.cases import Case, load_cases
from tests.labelled.pages import HEAD, load_pages
from tests.reached import documents
from tests.reached.documents import MARKDOWN, Reached, Text
from tests.reached.search import SECONDS, SLIPS, of_tests, slip
from tests.sweeps import sentences
from tests.sweeps.mutants_of_displays import mutate

RECORD = Path(__file__).parent / "derived.txt"
INDEX = re.compile(r"_(?:\d|\{[^{}]*\})")
OTHER_LETTERS = [
    (r"\theta", "q"),
    ("q_", r"\theta_"),
    ("c_", r"\cos\theta_"),
    ("d_", "a_"),
    ("a_", "l_"),
    ("l_", "L_"),
    ("L_", "d_"),
]
OTHER_LETTERS += [
    ("T", "A"),
    ("A", "T"),
    ("{}^0", "{}^1"),
    ("^0", "^1"),
    ("R", "Q"),
    ("J", "J_v"),
    ("p", "P"),
    ("x", "y"),
    ("z", "x"),
]
HEADER = "# What we say of each document that derived.py makes. Written by `python -m tests.reached --update`.\n"


def derived() -> Iterator[Text]:
    """Yield the documents, each once, but for those that were found by search."""
    found = [*of_sentences(), *of_mistakes(), *of_other_data(), *of_slips(), *of_spellings(), *of_tests()]
    known = {each.document for each in documents.load()}
    yield from dict.fromkeys(document for document in found if document.can_stand and document not in known)


def of_sentences() -> Iterator[Text]:
    """Yield each sentence at each of its places beside some display."""
    for trial in sentences.each_at_its_places():
        yield Text(sentences.document(trial, sentences.placed(trial)), trial.format)


def of_mistakes() -> Iterator[Text]:
    """Yield the documents without front matter with each of their mistakes."""
    for document in bare.load():
        for number, *_ in document.mistakes:
            yield Text(document.text(number), document.path.suffix.removeprefix(".") or MARKDOWN)


def of_other_data() -> Iterator[Text]:
    """Yield the documents without front matter and the pages otherwise: a table, a part less, two in the other order, an index or a letter in one display."""
    known = [Text(each.text(), each.path.suffix.removeprefix(".") or MARKDOWN) for each in bare.load()]
    for document in (*known, *(Text(page.text) for page in load_pages() if page.kind != "attack")):
        parts, rng = document.text.split("\n\n"), Random(Reached(document, "").name)
        for changed in (
            _with_a_slip_in_a_table,
            _with_a_part_less,
            _in_another_order,
            _with_another_index,
            _with_another_letter,
        ):
            if (other := changed(parts, rng)) != parts:
                yield Text("\n\n".join(other).rstrip("\n") + "\n", document.format)


def _with_a_slip_in_a_table(parts: list[str], rng: Random) -> list[str]:
    """Return the parts with a slip in the last row of a table, or in some part where there is none."""
    tables = [k for k, part in enumerate(parts) if part.count("|") > 8 or "tabular" in part]
    at = rng.choice(tables or range(len(parts)))
    before, line, behind = parts[at].rstrip("\n").rpartition("\n") if tables else ("", "", parts[at])
    right, wrong = next(each for each in [*rng.sample(SLIPS, len(SLIPS)), ("", "")] if each[0] in behind)
    place = rng.choice([found.start() for found in re.finditer(re.escape(right), behind)])
    changed = behind[:place] + wrong + behind[place + len(right) :]
    return [*parts[:at], f"{before}{line}{changed}", *parts[at + 1 :]]


def _with_a_part_less(parts: list[str], rng: Random) -> list[str]:
    at = rng.randrange(1, max(2, len(parts) - 1))
    return [*parts[:at], *parts[at + 1 :]]


def _in_another_order(parts: list[str], rng: Random) -> list[str]:
    at = rng.randrange(1, max(2, len(parts) - 2))
    return [*parts[:at], *reversed(parts[at : at + 2]), *parts[at + 2 :]]


def _with_another_index(parts: list[str], rng: Random) -> list[str]:
    """Return the parts with another digit for one in all the indices of a display, as where two joints are confused."""
    at = _of_a_display(parts, rng)
    digits = sorted({digit for index in INDEX.findall(parts[at]) for digit in index if digit.isdigit()})
    old, new = (rng.choice(digits), rng.choice("0123")) if digits else ("", "")
    changed = INDEX.sub(lambda found: found[0].replace(old, new) if old else found[0], parts[at])
    return [*parts[:at], changed, *parts[at + 1 :]]


def _with_another_letter(parts: list[str], rng: Random) -> list[str]:
    """Return the parts with another letter for one everywhere in a display."""
    at = _of_a_display(parts, rng)
    old, new = rng.choice([pair for pair in OTHER_LETTERS if pair[0] in parts[at]] or [("", "")])
    return [*parts[:at], parts[at].replace(old, new) if old else parts[at], *parts[at + 1 :]]


def _of_a_display(parts: list[str], rng: Random) -> int:
    return rng.choice([k for k, part in enumerate(parts) if INDEX.search(part)] or range(len(parts)))


def of_slips() -> Iterator[Text]:
    """Yield the labelled displays, each with a slip or a damage of its own."""
    for case in load_cases("displays.yaml"):
        yield Text(with_a_slip(case))


def with_a_slip(case: Case) -> str:
    """Return the document of a display with what its name lets happen to it."""
    rng = Random(case.key)
    changed = slip(case.latex, rng) if rng.random() < 0.5 else mutate(case.latex, case.latex, rng)
    before, _, behind = case.text.rpartition(case.latex)
    return f"{before}{changed}{behind}"


def of_spellings() -> Iterator[Text]:
    """Yield everyday names of quantities, of which the verdict alone is on the list of the labelled."""
    yield from (Text(case.text) for case in load_cases("spellings.yaml"))


@lru_cache
def load() -> Mapping[str, Reached]:
    """Return the documents that are on record, with what it says, by their names."""
    record = read_record()
    named = {Reached(document, "").name: document for document in derived()}
    return {name: Reached(named[name], said) for name, said in record.items() if name in named}


@lru_cache
def read_record() -> Mapping[str, str]:
    """Return what is said of each document, by its name."""
    _, *parts = HEAD.split(RECORD.read_text("utf-8"))
    return dict(zip(parts[::2], parts[1::2], strict=True))


def write_record(jobs: int | None = None) -> None:
    """Write the record anew."""
    with ProcessPoolExecutor(jobs) as pool:
        said = pool.map(_said_in_time, derived(), chunksize=20)
        lines = "".join(f"===== {each.name}\n{each.said}" for each in said if each is not None)
    RECORD.write_text(HEADER + lines, "utf-8")
    read_record.cache_clear()
    load.cache_clear()


def _said_in_time(document: Text) -> Reached | None:
    began = time.process_time()
    said = document.said()
    return Reached(document, said) if time.process_time() - began < SECONDS else None
