"""Write notebooks: those of the students beside their sources, the instructor's edition and nbgrader's elsewhere."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path

from armproof.course.errors import AuthoringError
from armproof.course.sources.editions import instructor_notebook, student_notebook
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.course.sources.nbgrader import nbgrader_notebook
from armproof.course.sources.places import Place
from armproof.models.language import ENGLISH, use
from armproof.verification.running.atomic import write_atomically

Files = dict[Path, bytes]


def student_files(place: Place, sources: Sequence[Path], lang: str = ENGLISH) -> Files:
    """Return the students' notebooks of sources, by their path."""
    with use(lang):
        return {place.notebook(source, lang): student_notebook(lesson) for source, lesson in _read(sources, lang)}


def instructor_files(out: Path, sources: Sequence[Path], lang: str = ENGLISH) -> Files:
    """Return the instructor's edition: DIR/12_scara_jacobian.ipynb."""
    return {out / f"{source.stem}.ipynb": instructor_notebook(lesson) for source, lesson in _read(sources, lang)}


def nbgrader_files(out: Path, sources: Sequence[Path], lang: str = ENGLISH) -> Files:
    """Return nbgrader's source version, an assignment a lesson: DIR/12_scara_jacobian/12_scara_jacobian.ipynb."""
    return {
        out / source.stem / f"{source.stem}.ipynb": nbgrader_notebook(lesson) for source, lesson in _read(sources, lang)
    }


def _read(sources: Sequence[Path], lang: str) -> Iterator[tuple[Path, LessonSource]]:
    for source in sources:
        yield source, read_lesson_source(source, lang)


def stale(files: Files) -> list[Path]:
    """Return the files that are missing or hold something else."""
    return [path for path, data in files.items() if not _holds(path, data)]


def orphans(place: Place, lang: str = ENGLISH) -> list[Path]:
    """Return the notebooks of a place that no source gives."""
    expected = {place.notebook(source, lang) for source in place.sources()}
    folder = place.notebook(Path("any"), lang).parent
    return sorted(path for path in folder.glob("*.ipynb") if path not in expected)


def refuse_worked_in(files: Files) -> None:
    """Raise AuthoringError where a file that would be written anew has been run: somebody's answers may be in it."""
    for path in stale(files):
        if _was_run(path):
            raise AuthoringError("{path}: somebody has worked in this notebook; move it away, or build with --force to lose what is in it",
                path=path)  # fmt: skip


def _was_run(path: Path) -> bool:
    """Whether a notebook has outputs or counts of execution, which none has that was built."""
    try:
        cells = json.loads(path.read_bytes())["cells"]
        return any(cell.get("outputs") or cell.get("execution_count") is not None for cell in cells)
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return False


def write_stale(files: Files) -> list[Path]:
    """Write those files that are missing or hold something else, each as a whole or not at all; return them."""
    written = stale(files)
    for path in written:
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(path, files[path])
        except OSError as error:
            raise AuthoringError("{path}: cannot be written: {reason}", path=path, reason=error.strerror) from None
    return written


def _holds(path: Path, data: bytes) -> bool:
    try:
        return path.read_bytes() == data
    except OSError:
        return False
