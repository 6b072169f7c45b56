"""The documents that a command's paths name, and their results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.models.errors import ArmproofError
from armproof.verification.cli.progress import Progress
from armproof.verification.findings import Kind, say
from armproof.verification.running.batch import check_each
from armproof.verification.verdict import DocumentResult, Failure

if TYPE_CHECKING:
    from armproof.verification.running.batch import After


def check_paths(
    paths: Sequence[Path],
    *,
    prepare: Callable[[list[Path]], After] | None = None,
    correct: bool = False,
    jobs: int | None = None,
) -> list[DocumentResult | Failure]:
    """Return the result of each document that the paths name, in their order; a path that names none is a Failure.

    Args:
        prepare: given the documents before they are checked, returns what is to be done with each after its check.
        correct: whether to seek what mends each refuted display.
        jobs: the number of processes; by default one a core.
    """
    return list(check_each_path(paths, prepare=prepare, correct=correct, jobs=jobs))


def check_each_path(
    paths: Sequence[Path],
    *,
    prepare: Callable[[list[Path]], After] | None = None,
    correct: bool = False,
    jobs: int | None = None,
) -> Iterator[DocumentResult | Failure]:
    """Yield what `check_paths` returns, each result as soon as it is there; on a terminal, with a bar of how far it is."""
    found = named_documents(paths)
    documents = [each for each in found if isinstance(each, Path)]
    after = prepare(documents) if prepare is not None else None
    checked = check_each(documents, jobs, after=after, correct=correct)
    with Progress(len(documents)) as progress:
        for each in found:
            result = next(checked) if isinstance(each, Path) else each
            progress.clear()
            yield result
            progress.advance(isinstance(each, Path))


def named_documents(paths: Sequence[Path]) -> dict[Path | Failure, None]:
    """Return the documents that paths name, each once and in their order, and a Failure for a path that names none."""
    from armproof.verification.document import find_documents

    found: dict[Path | Failure, None] = {}
    for path in paths:
        try:
            if path.exists() and not (path.is_dir() or path.is_file()):  # a pipe or a device, which may never end
                found[Failure(str(path), say(Kind.NOT_A_FILE))] = None
            else:
                found.update(dict.fromkeys(find_documents([path])))
        except ArmproofError as error:
            found[Failure.of(path, error)] = None
        except OSError as error:
            found[Failure(str(path), say(Kind.FILE_UNREADABLE, reason=str(error.strerror)))] = None
    return found


def find_course() -> Path:
    """Return course/ of the working folder, else the folder of the installed course."""
    here = Path("course")
    spec = None if here.is_dir() else find_spec("armproof.course")
    return Path(next(iter(spec.submodule_search_locations))) if spec and spec.submodule_search_locations else here
