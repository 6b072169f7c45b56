"""What is to be built, what became of it, and a lesson as the others refer to it: what the processes of a build tell each other."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from armproof.course.sources.places import COURSE, Place


@dataclass(frozen=True)
class Order:
    """What is to be built: sources in the order of the lessons, their place, the edition."""

    sources: tuple[Path, ...]
    place: Place = COURSE
    solutions: bool = False


@dataclass(frozen=True)
class Built:
    """What became of a lesson: what of it is not on its page, and why there is no page."""

    source: Path
    warnings: tuple[str, ...] = ()
    problem: str = ""


@dataclass(frozen=True)
class Neighbour:
    """A lesson as others refer to it: its number, its title as plain text, the stem of its files, and its arm, if that is one of the catalogue."""

    number: int
    title: str
    stem: str
    arm: str = ""

    @property
    def page(self) -> str:
        """The file of its page."""
        return f"{self.stem}.html"

    @property
    def notebook(self) -> str:
        """The file of the student's notebook."""
        return f"{self.stem}.ipynb"
