"""Where lessons are: those of the course, and those of a teacher in a folder of his or her own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from armproof.course.errors import AuthoringError
from armproof.course.sources.lesson_source import FILE
from armproof.models.language import ENGLISH, languages


@dataclass(frozen=True)
class Place:
    """A folder with `lessons/`, `tasks/` and `notebooks/`: the course's, or another."""

    root: Path

    @property
    def lessons(self) -> Path:
        """The folder of the sources."""
        return self.root / "lessons"

    @property
    def tasks(self) -> Path:
        """The folder of the tasks' modules."""
        return self.root / "tasks"

    @property
    def notebooks(self) -> Path:
        """The folder of the students' notebooks."""
        return self.root / "notebooks"

    @property
    def is_course(self) -> bool:
        """Whether this is the package `course`."""
        return self.root.resolve() == COURSE.root

    @property
    def languages(self) -> tuple[str, ...]:
        """The languages that the lessons are in: that of their sources, and those that have catalogues of them."""
        return tuple(lang for lang in languages() if lang == ENGLISH or (self.root / "translations" / lang).is_dir())

    def sources(self) -> list[Path]:
        """Return the sources, in the order of their numbers."""
        return sorted(path for path in self.lessons.glob("*.py") if FILE.fullmatch(path.name))

    def notebook(self, source: Path, lang: str = ENGLISH) -> Path:
        """Return the student's notebook of a source; those in other languages are in folders of their own."""
        return self.notebooks / ("" if lang == ENGLISH else lang) / f"{source.stem}.ipynb"

    def named(self, names: Sequence[str]) -> list[Path]:
        """Return the sources of the lessons named, all where none is; raises AuthoringError where there is no such lesson."""
        sources = self.sources()
        if not sources:
            raise AuthoringError("{lessons}: no lesson here; a lesson is a file such as 12_scara_jacobian.py", lessons=self.lessons)  # fmt: skip
        return [self._source(name, sources) for name in dict.fromkeys(names)] if names else sources

    def _source(self, name: str, sources: Sequence[Path]) -> Path:
        wanted = Path(name).stem if re.search(r"[/.]", name) else name
        for source in sources:
            if wanted in _spellings(source):
                return source
        valid = ", ".join(source.stem for source in sources)
        raise AuthoringError("no lesson '{name}'; the lessons are {valid}", name=name, valid=valid)


def _spellings(source: Path) -> Iterator[str]:
    """Yield what a lesson may be called: 12_scara_jacobian, scara_jacobian, 12."""
    number, _, name = source.stem.partition("_")
    yield from (source.stem, name, number, str(int(number)))


COURSE = Place(Path(__file__).resolve().parents[1])


def place_of(folder: Path | None) -> Place:
    """Return the course's place, or that of a folder."""
    if folder is not None and not folder.is_dir():
        raise AuthoringError("{folder}: no such folder", folder=folder)
    return COURSE if folder is None else Place(folder)
