"""Draw and write many figures, on several cores: an arm at a time, so that its figures share what is computed for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from armproof.course.errors import FigureError
from armproof.models.errors import ArmproofError
from armproof.verification.running.processes import share_out, usual_workers

HEAVY = ("kr210", "rx90")  # that take longest, begun first


@dataclass(frozen=True)
class Order:
    """Figures to be drawn of one arm.

    Attributes:
        arm: what `load_arm` takes: a name, a path or a DH table; a path is relative to `base`.
        name: what the files are called after.
        kinds: names of kinds; none for all that the arm has.
    """

    arm: Any
    name: str
    kinds: tuple[str, ...]
    base: str = "."


@dataclass(frozen=True)
class Delivery:
    """What became of an order: the files written, and what could not be drawn, a sentence each."""

    order: Order
    files: tuple[Path, ...] = ()
    problems: tuple[str, ...] = ()
    fatal: bool = False


def produce(
    orders: Sequence[Order], formats: Sequence[str], lang: str, out: Path, workers: int | None = None
) -> Iterator[Delivery]:
    """Draw figures and write them into a folder, with their captions; yields the deliveries in the order of the orders.

    Args:
        formats: of `save.FORMATS`, and of `films.FILMS` for a film of each arm's motion.
        workers: the number of processes; by default one a core, at most 4, and this one only where Drake is imported already.
    """
    workers = usual_workers() if workers is None else workers
    work = partial(deliver, formats=formats, lang=lang, out=out)
    yield from share_out(work, orders, workers, _ended, weight=lambda order: order.name in HEAVY)


def _ended(order: Order) -> Delivery:
    problem = f"{order.name}: the process that drew it ended; Drake may have aborted on its model"
    return Delivery(order, problems=(problem,))


def deliver(order: Order, formats: Sequence[str], lang: str, out: Path) -> Delivery:
    """Draw and write the figures of one arm; no exception leaves this function but an interrupt."""
    from armproof.course.figures.output.save import FORMATS
    from armproof.course.figures.registry import figures_for, find_kind
    from armproof.models.catalogue import load_arm

    try:
        arm = load_arm(order.arm, order.base)
        kinds = tuple(find_kind(name) for name in order.kinds) or figures_for(arm)
    except ArmproofError as error:
        return Delivery(order, problems=(str(error),), fatal=True)
    files: list[Path] = []
    problems: list[str] = []
    figures, films = ([suffix for suffix in formats if (suffix in FORMATS) is still] for still in (True, False))
    works = [(kind.name, partial(write_figure, arm, kind, lang, figures, out)) for kind in kinds if figures]
    works += [("motion", partial(write_films, arm, lang, films, out))] if films else []
    for name, work in works:
        try:
            files += work(order.name)
        except FigureError as error:
            return Delivery(order, tuple(files), (*problems, str(error)), fatal=True)
        except Exception as error:  # one figure that fails does not take the others with it
            problems.append(f"{order.name}-{name}: cannot be drawn: {type(error).__name__}: {error}")
    return Delivery(order, tuple(files), tuple(problems))


def write_figure(arm: Any, kind: Any, lang: str, formats: Sequence[str], out: Path, name: str) -> list[Path]:
    """Write one figure in several formats, and its caption beside it; returns the files of the figure."""
    from armproof.course.figures.output.save import save_bytes, save_figure
    from armproof.course.figures.registry import caption_kind, draw_kind

    stem = f"{name}-{kind.name}" + ("" if lang == "en" else f"-{lang}")
    figure = draw_kind(kind, arm, lang)
    files = [save_figure(figure, out / f"{stem}.{suffix}") for suffix in formats]
    save_bytes(f"{caption_kind(kind, arm, lang)}\n".encode(), out / f"{stem}.txt")
    return files


def write_films(arm: Any, lang: str, formats: Sequence[str], out: Path, name: str) -> list[Path]:
    """Write the motion of an arm as films in the formats that it has; returns the files."""
    from armproof.course.figures.output.films import film_reason, write_film

    stem = f"{name}-motion" + ("" if lang == "en" else f"-{lang}")
    having = [suffix for suffix in formats if film_reason(arm, suffix, lang) is None]
    return [write_film(arm, out / f"{stem}.{suffix}", lang) for suffix in having]
