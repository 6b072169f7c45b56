"""A search for documents in which a condition of the trusted base comes out as in few others.

Labelled displays, pages, handouts of the course, documents in the tests, and what was found before are changed at random: a
slip, a damage, the front matter, a heading or a display of another. What brings an outcome that fewer than three documents
have is kept. Mutants of the base live where few documents go; what is said of these is on record, and a mutant that says
another thing is killed by it.
"""

from __future__ import annotations

import ast
import re
import signal
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from random import Random

from armproof.models.errors import ArmproofError
from armproof.verification.check import verify_text
from tests.labelled import bare
from tests.labelled.cases import load_cases
from tests.labelled.pages import load_pages
from tests.mutation.source.trusted import ROOT
from tests.reached import documents
from tests.reached.documents import MARKDOWN, Text
from tests.reached.outcomes import NOTED, Outcome
from tests.sweeps.mutants_of_displays import mutate

ENOUGH = 3  # documents that have an outcome
LONGEST, SECONDS, PATIENCE = 6_000, 0.6, 3.0  # characters of a document, its time, and when it is given up
DISPLAY = re.compile(r"\$\$(.+?)\$\$", re.DOTALL)
FRONT = re.compile(r"\A---\n.*?\n---\n", re.DOTALL)
MARKS = {
    "rst": re.compile(r"\.\. math::"),
    "tex": re.compile(r"\\begin\{(?:document|equation|align|tabular)|\\documentclass|^% ---", re.MULTILINE),
    MARKDOWN: re.compile(r"\$\$|^\|.*\|", re.MULTILINE),
}
SLIPS = [
    ("+", "-"), ("-", "+"), ("c_", "s_"), ("s_", "c_"), (r"\cos", r"\sin"), (r"\sin", r"\cos"), ("1", "2"), ("2", "1"), ("2", "3"),
    ("3", "2"), ("=", r"\neq"), ("=", r"\approx"), ("=", r"\leq"), ("0", "1"), (r"\theta", "q"), ("l_", "a_"),
    (r"\Leftrightarrow", r"\Rightarrow"), ("J", "J_v"), ("x", "y"), ("^T", ""), (r"\dot", ""), (r"\pi", r"180^\circ"),
    (r"\quad", ","), (r"\pm", ""),
]  # fmt: skip


class TooSlowError(BaseException):
    """A document that takes longer than any on record may."""


@dataclass
class Search:
    """What is changed, how many documents have each outcome, and what was found."""

    rng: Random
    sources: Sequence[Text]
    unknown: Sequence[Text] = ()
    counts: Counter[Outcome] = field(default_factory=Counter)
    found: dict[Text, frozenset[Outcome]] = field(default_factory=dict)
    failed: list[tuple[str, Text]] = field(default_factory=list)

    @classmethod
    def begun(cls, seed: int) -> Search:
        """Return a search that knows the outcomes of what is labelled and of what was found before."""
        known = [*map(Text, labelled()), *(each.document for each in documents.load())]
        others = [*handouts(), *of_tests()]
        search = cls(Random(seed), [*known, *others], others)
        for document in known:
            search.counts.update(outcomes_of(document) or ())
        return search

    def run(self, seconds: float) -> None:
        """Try what is not known as it is, then change documents, for so long."""
        until = time.monotonic() + seconds
        for document in self.unknown:
            self.try_document(document)
        while time.monotonic() < until:
            recent = self.found and self.rng.random() < 0.4
            self.try_document(self.changed(self.rng.choice([*self.found] if recent else self.sources)))

    def try_document(self, document: Text) -> bool:
        """Keep a document that brings a rare outcome and can stand on record, and return whether it does."""
        try:
            noted = outcomes_of(document) if len(document.text) <= LONGEST and document.can_stand else None
        except Exception as error:
            self.failed.append((f"{type(error).__name__}: {error}", document))
            return False
        if not noted or not any(self.counts[outcome] < ENOUGH for outcome in noted):
            return False
        self.counts.update(noted)
        self.found[document] = noted
        return True

    def changed(self, document: Text) -> Text:
        """Return a document with one change, or two."""
        if document.format != MARKDOWN:
            text = self._with_other_parts(document) if self.rng.random() < 0.3 else self._damaged(document.text)
            return Text(text, document.format)
        head = FRONT.match(document.text)
        front, body = (head[0], document.text[head.end() :]) if head else ("", document.text)
        draw = self.rng.random()
        if draw < 0.08:
            other = FRONT.match(self.rng.choice(self.sources).text)
            return Text((other[0] if other else front) + body)
        if draw < 0.28 or len(document.text) > LONGEST:
            return Text(front + self._with_other_parts(Text(body)))
        displays = list(DISPLAY.finditer(body))
        if not displays:
            return Text(front + self._damaged(body))
        at = self.rng.choice(displays)
        return Text(f"{front}{body[: at.start()]}$${self._changed_display(at[1])}$${body[at.end() :]}")

    def _damaged(self, text: str) -> str:
        return slip(text, self.rng) if self.rng.random() < 0.5 else mutate(text, text, self.rng)

    def _with_other_parts(self, document: Text) -> str:
        """Return a body with a part dropped, moved, or of another document; of one that is too long, some that follow each other."""
        parts = document.text.split("\n\n")
        if len(document.text) > LONGEST:
            at = self.rng.randrange(len(parts))
            return "\n\n".join(parts[at : at + self.rng.randint(1, 12)]).rstrip("\n") + "\n"
        at, to = self.rng.randrange(len(parts)), self.rng.randrange(len(parts))
        match self.rng.randrange(3):
            case 0:
                parts.insert(to, parts.pop(at))
            case 1:
                parts.pop(at)
            case _:
                other = self.rng.choice([each for each in self.sources if each.format == document.format])
                others = FRONT.sub("", other.text).split("\n\n")
                begin = self.rng.randrange(len(others))
                parts[at:at] = others[begin : begin + self.rng.randint(1, 4)]
        return "\n\n".join(parts).rstrip("\n") + "\n"

    def _changed_display(self, latex: str) -> str:
        draw = self.rng.random()
        if draw < 0.45:
            return slip(latex, self.rng)
        other = self.rng.choice(DISPLAY.findall(self.rng.choice(self.sources).text) or [latex])
        if draw < 0.75:
            return mutate(latex, other, self.rng)
        left, right = latex.partition("=")[0], other.partition("=")[2]
        between = self.rng.choice([r",\quad ", r" \Rightarrow ", r" \Leftrightarrow ", r" \quad\text{if } ", " = "])
        return self.rng.choice([f"{left}= {right}", f"{latex}{between}{other}"])


def slip(latex: str, rng: Random) -> str:
    """Return a display with a slip as people make it, where one can be made."""
    right, wrong = rng.choice(SLIPS)
    places = [match.start() for match in re.finditer(re.escape(right), latex)]
    at = rng.choice(places) if places else len(latex)
    return latex[:at] + wrong * bool(places) + latex[at + len(right) :]


def labelled() -> Iterator[str]:
    """Yield what is labelled: displays with what stands before them, pages, and documents without front matter."""
    yield from (case.text for case in load_cases())
    yield from (page.text for page in load_pages())
    for document in bare.load():
        yield document.text()


def handouts() -> Iterator[Text]:
    """Yield the handouts of the course."""
    yield from (Text(path.read_text("utf-8")) for path in sorted((ROOT / "course/handouts").glob("*.md")))


def of_tests() -> Iterator[Text]:
    """Yield the documents that stand as texts in the tests, in whatever format."""
    for path in sorted((ROOT / "tests/verification").rglob("test_*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            text = node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""
            format = next((format for format, mark in MARKS.items() if mark.search(text)), None)
            if "\n" in text and format:
                yield Text(text.strip("\n") + "\n", format)


def outcomes_of(document: Text) -> frozenset[Outcome] | None:
    """Return what conditions come out as while a document is verified; None where that takes too long to be on record."""
    NOTED.clear()
    began = time.process_time()
    try:
        with _given_up_after(PATIENCE), suppress(ArmproofError):
            verify_text(document.text, document.format)
    except TooSlowError:
        return None
    return frozenset(NOTED) if time.process_time() - began < SECONDS else None


def fewest(found: Mapping[Text, frozenset[Outcome]], counts: Counter[Outcome]) -> list[Text]:
    """Return those of the documents that are needed to have each outcome often enough, given what has it already."""
    rare = {document: frozenset(o for o in noted if counts[o] < ENOUGH) for document, noted in found.items()}
    chosen = []
    for document in sorted(rare, key=lambda document: -len(rare[document]) / len(document.text)):
        if any(counts[outcome] < ENOUGH for outcome in rare[document]):
            counts.update(rare[document])
            chosen.append(document)
    return chosen


@contextmanager
def _given_up_after(seconds: float) -> Iterator[None]:
    def give_up(*_: object) -> None:
        raise TooSlowError

    before = signal.signal(signal.SIGALRM, give_up)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
