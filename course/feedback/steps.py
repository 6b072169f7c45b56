"""How numbers follow from what is given, line by line: a solution shows it, and what students do on the way is told from it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from armproof.course.feedback.guesses import Guess, instead, nearly
from armproof.course.feedback.worked import IN_RADIANS, LETTER, Worked
from armproof.models.errors import written
from armproof.models.language import look_up, noted
from armproof.verification.latex.plain import plain_text

_NUMBER = re.compile(r"(-?\d+(?:\.\d+)?)(\^\\circ)?")
_TIMES = {1.0: "", -1.0: "−", 2.0: "2 · ", -2.0: "−2 · ", 0.5: "1/2 · ", -0.5: "−1/2 · "}
_OTHER_SIGN = noted("this is {other}, but for its sign")
_SUMMED = re.compile(r" [-+−] ")
_LIST = re.compile(r"\[(.*)\]", re.DOTALL)


@dataclass(frozen=True)
class Equation:
    """One line of LaTeX, `v = \\omega r`: a name and what it is."""

    name: str
    latex: str

    @property
    def is_given(self) -> bool:
        """Whether it is a number, of which nothing is to be said but that it is so."""
        return bool(_NUMBER.fullmatch(self.latex))

    @property
    def cells(self) -> tuple[str, ...]:
        """The entries of a list, none of anything else."""
        found = _LIST.fullmatch(self.latex)
        return tuple(part.strip() for part in found[1].split(",")) if found else ()


def equation_of(text: str) -> Equation:
    """Return what is written as `name = formula`, or as a formula alone."""
    name, _, latex = text.rpartition(" = ")
    return Equation(name.strip(), latex.strip())


@dataclass(frozen=True)
class Steps:
    """The way to one number or several.

    Attributes:
        lines: what is given, `r = 0.05`; what follows on the way, `v = \\omega r`; last what is asked, in its order. A line may
            name what stands above it.
        asked: how many numbers are asked.
    """

    lines: tuple[str, ...]
    asked: int

    @cached_property
    def given(self) -> dict[str, float]:
        """The numbers that are given, by their letters; not angles in degrees."""
        return {name: value for name, (value, unit) in self._given.items() if not unit}

    @cached_property
    def angles(self) -> dict[str, float]:
        """The angles that are given in degrees, in radians, by their letters."""
        return {name: float(np.radians(value)) for name, (value, unit) in self._given.items() if unit}

    @cached_property
    def _given(self) -> dict[str, tuple[float, str]]:
        lines = map(equation_of, self.lines[: -self.asked])
        found = {_key(line.name): _NUMBER.fullmatch(line.latex) for line in lines}
        return {name: (float(number[1]), number[2] or "") for name, number in found.items() if number is not None}

    @cached_property
    def ways(self) -> tuple[str, ...]:
        """How each number follows from what is given, in one formula; "" where there is nothing to reckon."""
        return (
            tuple("" if line.is_given else line.latex for line in self._unfolded[-self.asked :]) if self.lines else ()
        )

    @cached_property
    def last(self) -> tuple[str, ...]:
        """The lines of what is asked; "" where there is nothing to reckon."""
        return (
            tuple("" if equation_of(text).is_given else text for text in self.lines[-self.asked :])
            if self.lines
            else ()
        )

    @cached_property
    def shown(self) -> tuple[str, ...]:
        """The lines that lead from what is given to what is asked, where there is one between them."""
        between = tuple(text for text in self.lines[: -self.asked] if not equation_of(text).is_given)
        return (*between, *filter(None, self.last)) if between else ()

    @cached_property
    def _unfolded(self) -> list[Equation]:
        """The lines with those above them put in, but for what is asked: it stays a letter."""
        found: list[Equation] = []
        for line in map(equation_of, self.lines):
            latex = line.latex
            for above in found[: len(self.lines) - self.asked]:
                if LETTER.fullmatch(_key(above.name)) and not above.is_given:
                    latex = re.sub(rf"(?<![A-Za-z\\]){re.escape(above.name)}(?!\w)", lambda _, above=above: f"({above.latex})", latex)  # type: ignore[misc]  # fmt: skip
            found.append(Equation(line.name, latex))
        return found


NO_STEPS = Steps((), 1)


def _key(name: str) -> str:
    return name.replace("\\", "").replace("{", "").replace("}", "")


@dataclass(frozen=True)
class Beside:
    """What students give instead: the formula of something near by, or a list where several numbers are asked.

    Attributes:
        lines: `x_1 = [\\cos 40^\\circ, \\sin 40^\\circ, 0]`, told by its name; `v r`, told as it is; `[, 2 \\cdot 3]`, of the second
            number alone.
        known: the values of their letters.
    """

    lines: tuple[str, ...]
    known: Mapping[str, float]

    def of_all(self, given: np.ndarray, often: Sequence[float] = tuple(_TIMES)) -> str:
        """Return which list the numbers are, as it is, doubled, halved or with the other sign; empty where they are none.

        Args:
            often: how many times the list may be taken.
        """
        for times in often:
            for line in map(equation_of, self.lines):
                if self._is_whole(line, given.size) and self._agree(line, given / times, range(given.size)):
                    return instead(_so_often(times, line.name))
                in_radians = Equation(line.name, line.latex.replace(r"^\circ", ""))
                if (
                    in_radians != line
                    and self._is_whole(line, given.size)
                    and self._agree(in_radians, given / times, range(given.size))
                ):
                    return instead(_so_often(times, line.name)) + look_up("; ") + look_up(IN_RADIANS)
        return ""

    def of_one(self, place: int, given: np.ndarray, wrong: Sequence[int]) -> Iterator[Guess]:
        """Yield what one of the numbers may be instead; of a list with a name, where all that are wrong are its."""
        others = [k for k in range(given.size) if k != place]
        for line in map(equation_of, self.lines):
            is_whole = self._is_whole(line, given.size)
            if is_whole and not self._agree(line, given, wrong if len(wrong) > 1 else range(given.size)):
                if len(wrong) == 1 and self._agree(line, given, others):
                    told = partial(written, _OTHER_SIGN, other=plain_text(line.name))
                    yield Guess(-self._value(line.cells[place]), told)
                continue
            latex = line.cells[place] if len(line.cells) == given.size > 1 else "" if line.cells else line.latex
            if latex and (line.name or not _NUMBER.fullmatch(latex)):
                yield Guess(self._value(latex), partial(_told, line.name, latex, self.known))

    @cached_property
    def formulas(self) -> tuple[Worked, ...]:
        """What stands there as a formula without a name."""
        lines = map(equation_of, self.lines)
        return tuple(Worked(line.latex, self.known) for line in lines if not (line.name or line.cells or line.is_given))

    def _is_whole(self, line: Equation, count: int) -> bool:
        return bool(line.name) and len(line.cells) == count and all(line.cells)

    def _agree(self, line: Equation, given: np.ndarray, places: Iterable[int]) -> bool:
        return all(nearly(float(given[k]), self._value(line.cells[k])) for k in places)

    def _value(self, latex: str) -> float:
        return Worked(latex, self.known).value


def _so_often(times: float, name: str) -> str:
    shown = plain_text(name)
    return _TIMES[times] + (f"({shown})" if _TIMES[times] and _SUMMED.search(shown) else shown)


def _told(name: str, latex: str, known: Mapping[str, float]) -> str:
    shown = latex if _NUMBER.fullmatch(latex) else Worked(latex, known).shown
    return instead(f"{plain_text(name)}: {shown}" if name else shown)
