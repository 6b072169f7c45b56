"""The labelled displays: what each says, whether it is right, and which verdicts are allowed.

The data are YAML, to be read and extended by hand (README.md beside them). A case is one small document: a front matter,
what stands before (displays, or lines of Markdown that begin with #), and the display that is judged.
"""

from __future__ import annotations

import hashlib
import json
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import yaml

from tests.laws import PART, SWEEP, is_in_part

HERE = Path(__file__).parent
FILES = ("displays.yaml", "spellings.yaml")
PASSES = ("proved", "confirmed", "defined")
DECIDED = ("proved", "confirmed")
# What each label allows. "right?" is right and may stay undecided; a definition or data is never proved.
ALLOWED = {
    "right": DECIDED,
    "right?": (*DECIDED, "unchecked"),
    "wrong": ("refuted", "unchecked", "unreadable"),
    "open": ("unchecked", "unreadable"),
    "remark": ("unchecked",),
    "data": ("defined", "unchecked"),
}
FALSE_PASS, FALSE_REFUTATION, UNDECIDED = "false pass", "false refutation", "undecided"


@dataclass(frozen=True)
class Case:
    """One display with its label, its reading and the document around it."""

    file: str
    about: str
    label: str
    reads: str
    latex: str
    before: tuple[str, ...]
    front: str  # the front matter as YAML

    @property
    def text(self) -> str:
        """The document as Markdown; the display that is judged comes last."""
        parts = [part if part.startswith("#") else f"$$ {part} $$" for part in (*self.before, self.latex)]
        return "\n\n".join([f"---\n{self.front}---", *parts]) + "\n"

    @property
    def key(self) -> str:
        """A short name that does not change when cases are added or moved."""
        return hashlib.sha1(f"{self.file}\n{self.label}\n{self.text}".encode(), usedforsecurity=False).hexdigest()[:8]

    @property
    def one_line(self) -> str:
        """The display on one line, for lists and tables."""
        return " ".join(self.latex.split())

    def fault(self, verdict: str) -> str:
        """Return what is wrong with a verdict of ours, or "" where the label allows it."""
        if verdict in ALLOWED[self.label]:
            return ""
        if verdict == "refuted":
            return FALSE_REFUTATION
        return FALSE_PASS if verdict in PASSES and self.label not in ("right", "right?") else UNDECIDED


@lru_cache
def load_cases(*files: str) -> tuple[Case, ...]:
    """Return the cases of the data files, by default of all."""
    return tuple(case for file in files or FILES for case in read_cases(file))


def drawn(cases: Sequence[Case], one_in: int, part: str = PART or "some") -> list[Case]:
    """Return one in so many cases of each kind and label, the first of each for certain; or the rest; in a sweep all of them."""
    alike: defaultdict[tuple[str, ...], list[Case]] = defaultdict(list)
    for case in cases:
        alike[case.file, case.about, case.front, case.label].append(case)
    return [case for group in alike.values() for i, case in enumerate(group) if SWEEP or is_in_part(i, one_in, part)]


def read_table(file: str) -> dict[str, Any]:
    """Return what stands in a data file; the loader in C takes a tenth of the time."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    found: dict[str, Any] = yaml.load((HERE / file).read_text("utf-8"), Loader=loader)  # noqa: S506 - a safe loader
    return found


def read_cases(file: str) -> Iterator[Case]:
    """Yield the cases of a data file, `<X>` replaced by what its `let` says."""
    data = read_table(file)
    for group in data["groups"]:
        let = {**data.get("let", {}), **group.get("let", {})}
        for entry in group["cases"]:
            yield from _of_entry(file, group, entry, let)


@cache
def _matter(front: str) -> str:
    """Return a front matter, given as JSON, in YAML; many cases have the same."""
    return yaml.safe_dump(json.loads(front), allow_unicode=True, sort_keys=False)  # type: ignore[no-any-return]


def _of_entry(file: str, group: Mapping[str, Any], entry: Mapping[str, Any], let: Mapping[str, str]) -> Iterator[Case]:
    front = {**(group.get("front") or {}), **(entry.get("front") or {})}
    matter = _matter(json.dumps(front)) if front else "title: A page\n"
    before = [*group.get("before", []), *entry.get("before", [])]
    said = [expand(part, let) for part in before]
    for label in ALLOWED:
        found = entry.get(label, [])
        for latex in [found] if isinstance(found, str) else found:
            for spelt, odd in _spelt(latex, entry):
                may = "right?" if odd and label == "right" else label
                yield Case(file, group["about"], may, entry.get("reads", ""), expand(spelt, let), tuple(said), matter)


def _spelt(latex: str, entry: Mapping[str, Any]) -> Iterator[tuple[str, bool]]:
    """Yield a display, or with `names` (and `odd` ones) one equation a name; and whether the name is an odd one."""
    if "names" not in entry:
        yield latex, False
    for key in ("names", "odd"):
        for name in entry.get(key, []):
            yield f"{name} = {latex}", key == "odd"


def expand(latex: str, let: Mapping[str, str]) -> str:
    """Replace `<X>` by its value; values may hold such names themselves."""
    for _ in range(3):
        for name, value in let.items():
            latex = latex.replace(f"<{name}>", value)
    return latex
