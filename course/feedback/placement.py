"""A task that asks for frames, placed on the drawing of an arm step by step; every admissible choice is right."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.answer import is_function, is_missing
from armproof.course.feedback.misplaced import in_other_rows, misplaced
from armproof.course.feedback.notebook import Portrait, Shown, as_picture
from armproof.course.feedback.outcome import Feedback, Outcome, nothing, pretty
from armproof.course.feedback.spelling import as_entry
from armproof.course.feedback.table import ORDER, TURN, no_such_letter
from armproof.course.figures.facts.dh_rows import LinkRow
from armproof.course.figures.facts.placing import (
    NEAR,
    Placed,
    Scheme,
    Vector,
    difference,
    directions,
    is_linear,
    places,
    table_of,
    vector,
)
from armproof.models.dh.entry import LinearForm, read_entry
from armproof.models.errors import ModelError, written
from armproof.models.language import look_up, spoken

STEPS = {"z": ("z",), "O": ("O",), "x": ("O", "x"), "table": ("z", "O", "x", "table")}
_AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
Answer = dict[str, Any]


@dataclass(frozen=True, eq=False)
class Placement:
    """A step of placing the frames 1 to n of an arm: its z axes, its origins, its x axes, its table.

    Attributes:
        scheme: the arm as it is drawn.
        step: "z", "O", "x" (an answer has O and x) or "table" (an answer has z, O, x and the rows).
        usual: frames with many zeros, which are shown beside a student's: z, O and x.
    """

    scheme: Scheme
    step: str
    usual: Mapping[str, Sequence[Any]]

    def judge(self, answer: Any) -> Feedback:
        """Return what becomes of a list, or of a mapping or a sequence of lists, one for each of the step's letters."""
        if is_missing(answer):
            return nothing()
        read = self._read(answer)
        problem = next(filter(None, self._problems(read)), "")
        return Feedback(Outcome.WRONG, problem) if problem else Feedback(Outcome.PROVED, "", notes=self._notes(read))

    def signature(self, answer: Any) -> np.ndarray:
        """Return the numbers of an answer, by which two answers are told apart."""
        read, values = self._read(answer), self.scheme.generic
        parts = [directions(read[key], values) for key in "zx" if key in read]
        parts += [places(read["O"], values)] if "O" in read else []
        parts += [
            np.array([row[name].value(self._generic) for name in ORDER["modified"]]) for row in read.get("table", ())
        ]
        return np.concatenate([part.ravel() for part in parts])

    def show(self, task: str, answer: Any, at: Mapping[str, float]) -> Shown | Portrait:
        """Return the frames of an answer drawn on the arm, with the table that follows, and beside it the usual choice."""
        read = self._read(answer)
        yours = self._drawing(read)
        if problem := next(filter(None, self._problems(read)), ""):
            return Portrait((as_picture(yours, pretty(problem)),))
        usual = {key: self._vectors(key, self.usual[key]) for key in STEPS["table"][:3] if key in read}
        return Portrait((
            as_picture(yours, look_up("Your frames")), as_picture(self._drawing(usual), look_up("The usual choice")),
        ))  # fmt: skip

    def _drawing(self, read: Answer) -> Any:
        from armproof.course.figures.drawing.placed import draw_scheme  # and with it matplotlib

        values = dict(self.scheme.arm.lengths)
        points, ways = self.scheme.axes(values)
        z = directions(read["z"], values) if "z" in read else ways
        origins = places(read["O"], values) if "O" in read else points
        x = directions(read["x"], values) if "x" in read else None
        frames = {str(k + 1): np.eye(4) for k in range(len(z))}
        for k, pose in enumerate(frames.values()):
            pose[:3, 2], pose[:3, 3] = z[k], origins[k]
            if x is not None:
                pose[:3, 0] = x[k]
        rows = table_of(self.scheme, self._placed(read))[0] if {"z", "O", "x"} <= set(read) else None
        return draw_scheme(self.scheme, spoken(), frames, rows, "z" if x is None else "xz")

    # -- what is wrong -------------------------------------------------------------------------------------------------

    def _problems(self, read: Answer) -> Iterator[str]:
        points, ways = self.scheme.axes(self.scheme.generic)
        if "z" in read:
            yield from self._of_z(directions(read["z"], self.scheme.generic), ways)
        if "O" in read:
            lines = places(read["O"], self.scheme.generic)
            yield from self._of_origins(lines, points, ways)
            if "x" in read:
                yield from _of_x(directions(read["x"], self.scheme.generic), lines, ways)
        if "table" in read:
            yield from self._of_table(read)

    def _of_z(self, z: np.ndarray, ways: np.ndarray) -> Iterator[str]:
        for k, way in enumerate(z):
            if _parallel(way, ways[k]):
                continue
            if k + 1 < len(z) and _parallel(way, ways[k + 1]):
                yield written("z_{i} lies along the axis of joint {j}, as in the classic convention: here z_{i} is the axis of joint {i} itself", i=k + 1, j=k + 2)  # fmt: skip
            elif self._slides(k):
                yield written("z_{i} does not point along the slide of joint {i}", i=k + 1)
            else:
                yield written("z_{i} does not point along the axis about which joint {i} turns", i=k + 1)

    def _of_origins(self, origins: np.ndarray, points: np.ndarray, ways: np.ndarray) -> Iterator[str]:
        for k, origin in enumerate(origins):
            if not self._slides(k) and not _on_line(origin, points[k], ways[k]):
                if k + 1 < len(origins) and _on_line(origin, points[k + 1], ways[k + 1]):
                    yield written("O_{i} is on the axis of joint {j}: it belongs on z_{i}, the axis of joint {i}", i=k + 1, j=k + 2)  # fmt: skip
                else:
                    yield written("O_{i} is not on the axis of joint {i}", i=k + 1)
        for k, ((origin, way), (other, next_way)) in enumerate(pairwise(zip(origins, ways, strict=True))):
            if _parallel(way, next_way) or abs((other - origin) @ _foot_test(way, next_way)) < NEAR:
                continue
            if abs((other - origin) @ np.cross(way, next_way)) < NEAR:
                yield written("axes {i} and {j} intersect: O_{i} is the point that they have in common", i=k + 1, j=k + 2)  # fmt: skip
            else:
                yield written("axes {i} and {j} are skew: O_{i} is where their common normal meets z_{i}", i=k + 1, j=k + 2)  # fmt: skip

    def _of_table(self, read: Answer) -> Iterator[str]:
        placed, given = self._placed(read), read["table"]
        rows, drawn = table_of(self.scheme, placed)
        if not is_linear(rows, drawn, placed, self.scheme.generic):
            raise AnswerError(
                "the lengths between these frames are no sums of the letters of the arm: lay the axis of the slide through a marked point"
            )
        if len(given) != len(rows.rows):
            yield written("a table has one row a joint: {wanted} rows, not {given}", wanted=len(rows.rows), given=len(given))  # fmt: skip
            return
        names = ORDER["modified"]

        def wrong_in(cells: Sequence[Sequence[LinearForm]]) -> list[tuple[int, int]]:
            return [
                (k, j)
                for k, right in enumerate(rows.rows)
                for j, name in enumerate(names)
                if not self._same(cells[k][j], right, name, drawn[right.joint])
            ]

        cells = [[row[name] for name in names] for row in given]
        wrong = wrong_in(cells)
        if len({k for k, _ in wrong}) > 1:
            yield misplaced(cells, wrong, names, LinearForm(), _negated, lambda other: not wrong_in(other))
            if len({j for _, j in wrong}) == 1:
                name = names[wrong[0][1]]
                wanted = [getattr(rows.rows[k], name) for k, _ in wrong]
                yield in_other_rows([cells[k][j] for k, j in wrong], wanted, name)
        for number, (row, right) in enumerate(zip(given, rows.rows, strict=True), 1):
            if astray := [names[j] for k, j in wrong if k == number - 1]:
                yield _of_row(number, row, right, astray, self._slides(number - 1))

    def _same(self, form: LinearForm, right: LinkRow, name: str, drawn: LinearForm) -> bool:
        """Whether an entry is right: a variable is counted from the common direction of both x axes, or from the drawing."""
        wanted: LinearForm = getattr(right, name)
        if wanted.coefficient(right.joint) and form.coefficient(right.joint) == 1:
            wanted, form = LinearForm(), form.without(right.joint)
            return self._equal(form, wanted, name) or self._equal(form, drawn, name)
        return self._equal(form, wanted, name)

    def _equal(self, form: LinearForm, wanted: LinearForm, name: str) -> bool:
        apart = form.value(self._generic) - wanted.value(self._generic)
        return bool(abs(np.sin(apart / 2) if name in ("alpha", "theta") else apart) < NEAR)

    def _notes(self, read: Answer) -> tuple[str, ...]:
        """Say which origins were free and make an offset that need not be."""
        if self.step != "O":
            return ()
        origins, (_, ways) = places(read["O"], self.scheme.generic), self.scheme.axes(self.scheme.generic)
        free = [k for k in range(1, len(ways))
                if not self._slides(k) and (k + 1 == len(ways) or _parallel(ways[k], ways[k + 1]))]  # fmt: skip
        return tuple(
            written("O_{i} is free along z_{i}; where you put it, d_{i} is not zero", i=k + 1)
            for k in free
            if abs((origins[k] - origins[k - 1]) @ ways[k]) > NEAR
        )

    @cached_property
    def _generic(self) -> dict[str, float]:
        """Lengths and joint values that no number and no sum of others equals by chance."""
        joints = {joint.symbol: float(np.sqrt(k + 20)) for k, joint in enumerate(self.scheme.arm.joints)}
        return {**self.scheme.generic, **joints}

    def _slides(self, k: int) -> bool:
        return self.scheme.arm.joints[k].kind == "prismatic"

    # -- what is given -------------------------------------------------------------------------------------------------

    def _read(self, answer: Any) -> Answer:
        if is_function(answer):
            answer = answer()
        keys = STEPS[self.step]
        if not isinstance(answer, Mapping):
            answer = {keys[0]: answer} if len(keys) == 1 else _in_order(answer, keys)
        if absent := [key for key in keys if is_missing(answer.get(key))]:
            raise AnswerError("{key} is missing; the answer has {keys}", key=absent[0], keys=list(keys))
        return {key: self._rows(answer[key]) if key == "table" else self._vectors(key, answer[key]) for key in keys}

    def _vectors(self, key: str, given: Any) -> tuple[Vector, ...]:
        count = len(self.scheme.arm.joints)
        given = given.tolist() if hasattr(given, "tolist") else given
        given = _listed(given, count) if isinstance(given, str) else given
        if not isinstance(given, list | tuple) or len(given) != count:
            raise AnswerError("{key} is a list of {count} entries, one a joint", key=key, count=count)
        read = self._point if key == "O" else self._direction
        return tuple(self._within(f"{key}_{number}", read, each) for number, each in enumerate(given, 1))

    def _within(self, name: str, read: Any, given: Any) -> Any:
        """Return an entry as it is read, or say which of them cannot be."""
        try:
            found: Vector = read(given)
            places([found], self.scheme.generic)
        except (ModelError, KeyError, TypeError, ValueError):
            raise AnswerError("{name}: {given} is no point and no direction of the drawing; its points are {points}, its directions x, -x, y, -y, z, -z, or three numbers",
                name=name, given=f"{given!r:.40}", points=list(self.scheme.points)) from None  # fmt: skip
        return found

    def _point(self, given: Any) -> Vector:
        if isinstance(given, str) and given.strip().upper() in self.scheme.points:
            return self.scheme.points[given.strip().upper()]
        return _triple(given)

    def _direction(self, given: Any) -> Vector:
        """Return a direction: "x", "-y", "AB" from one point to another, or three numbers that are not all zero."""
        found = _triple(given) if not isinstance(given, str) or "," in given else self._named(given.replace(" ", ""))
        if np.linalg.norm(places([found], self.scheme.generic)) < NEAR:
            raise ValueError
        return found

    def _named(self, text: str) -> Vector:
        sign, letters = (-1 if text.startswith("-") else 1), text.lstrip("+-")
        if letters.lower() in _AXES:
            return _triple([sign * part for part in _AXES[letters.lower()]])
        start, end = (self.scheme.points[letter] for letter in letters)
        return difference(end, start) if sign > 0 else difference(start, end)

    def _rows(self, given: Any) -> list[dict[str, LinearForm]]:
        order = ORDER["modified"]
        if not isinstance(given, list | tuple):
            raise AnswerError("a table is a list of rows, not a {type}", type=type(given).__name__)
        rows = [row if isinstance(row, Mapping) else dict(zip(order, row, strict=False)) for row in given]
        for number, row in enumerate(rows, 1):
            if set(row) != set(order):
                raise AnswerError("row {number} is to hold {count} entries: {order}", number=number, count=len(order), order=list(order))  # fmt: skip
        return [{name: self._entry(row[name], number, name) for name in order} for number, row in enumerate(rows, 1)]

    def _entry(self, cell: Any, number: int, name: str) -> LinearForm:
        try:
            form = read_entry(cell.item() if hasattr(cell, "item") else as_entry(cell))
        except ModelError as problem:
            place = written("row {row}: {name}", row=number, name=name)
            raise AnswerError("{place}: {cell} cannot be read: {reason}", place=place, cell=f"{cell!r:.40}", reason=str(problem)) from None  # fmt: skip
        letters = [*(joint.symbol for joint in self.scheme.arm.joints), *self.scheme.arm.lengths]
        bare = {letter.replace("_", ""): letter for letter in letters}  # l1 for l_1
        form = replace(
            form, symbols=tuple((bare.get(symbol.replace("_", ""), symbol), times) for symbol, times in form.symbols)
        )
        if unknown := [symbol for symbol, _ in form.symbols if symbol not in letters]:
            place = written("row {row}: {name}", row=number, name=name)
            raise no_such_letter(place, unknown[0], letters, self.scheme.arm)
        return form

    def _placed(self, read: Answer) -> Placed:
        return Placed(read["z"], read["O"], read["x"])


def _of_x(x: np.ndarray, origins: np.ndarray, ways: np.ndarray) -> Iterator[str]:
    """Yield which x axes are not along the common normal, from z_i to z_{i+1}."""
    for k, way in enumerate(x):
        i, j = k + 1, k + 2
        if abs(way @ ways[k]) > NEAR:
            yield written("x_{i} is not at right angles to z_{i}", i=i)
        elif k + 1 == len(x):
            continue
        elif abs(way @ ways[k + 1]) > NEAR:
            yield written(
                "x_{i} is at right angles to z_{i} but not to z_{j}: it is along the normal of both", i=i, j=j
            )
        else:
            normal = _normal(origins[k], ways[k], origins[k + 1], ways[k + 1])
            length = float(np.linalg.norm(normal))
            if length < NEAR:
                continue
            if not _parallel(way, normal / length):
                yield written("axes {i} and {j} are parallel: x_{i} leads from one to the other, at right angles", i=i, j=j)  # fmt: skip
            elif way @ normal < 0:
                yield written("x_{i} points from axis {j} back to axis {i}: step 4 wants it from z_{i} to z_{j}, so that a_{i} is a distance", i=i, j=j)  # fmt: skip


def _of_row(number: int, row: Mapping[str, LinearForm], right: LinkRow, wrong: Sequence[str], slides: bool) -> str:
    """Say what is wrong in a row, and the mistake where it is a known one."""
    if {"a", "d"} <= set(wrong) and (row["a"], row["d"]) == (right.d, right.a):
        return written("row {row}: a and d are exchanged: a runs along x_{before}, d along z_{row}", row=number, before=number - 1)  # fmt: skip
    variable = "d" if slides else "theta"
    astray = [name for name in ORDER["modified"] if name != variable and row[name].coefficient(right.joint)]
    if astray and not row[variable].coefficient(right.joint):
        return written("row {row}: {joint} stands in the column of {name}; joint {row} {moves}, so its variable is {variable}",
            row=number, joint=right.joint, name=astray[0], variable=variable, moves=look_up("slides") if slides else look_up("turns"))  # fmt: skip
    letters = [symbol for column in dict.fromkeys((variable, "theta")) for symbol, _ in row[column].symbols]
    if mixed := [symbol for symbol in letters if symbol.startswith(("theta", "q")) and symbol != right.joint]:
        return written("row {row}: {printed} is the variable of another joint; joint {row} has {joint}", row=number, printed=mixed[0], joint=right.joint)  # fmt: skip
    name = wrong[0]
    form, wanted = row[name], getattr(right, name)
    if name == "alpha" and form == LinearForm(pi=-wanted.pi):
        return written("row {row}: alpha has the wrong sign for your axes: turn z_{before} into z_{row} about x_{before}", row=number, before=number - 1)  # fmt: skip
    told = written("row {row}: {name} is wrong for the frames that you placed", row=number, name=name)
    if name in ("alpha", "theta") and (
        length := next((symbol for symbol, _ in form.symbols if not symbol.startswith(("theta", "q"))), "")
    ):
        return written("row {row}: {letter} is a length, and stands in the column of {name}", row=number, letter=length, name=name)  # fmt: skip
    if name == variable and form.coefficient(right.joint) == 1:
        form, wanted = form.without(right.joint), wanted.without(right.joint)
        if wanted == LinearForm() != form:
            return f"{told} ({_beside_variable(form)})"
    change = _change(form, wanted, is_angle=name in ("alpha", "theta"))
    return f"{told} ({change})" if change else told


def _beside_variable(form: LinearForm) -> str:
    """Return what stands beside a variable that is to stand alone."""
    letters = [symbol for symbol, _ in form.symbols]
    return written("{name} does not belong", name=letters[0]) if letters else look_up("the constant offset")


def _change(form: LinearForm, wanted: LinearForm, is_angle: bool) -> str:
    """Return what makes an entry wrong, beside its variable; empty where it is nothing short."""
    if form == wanted:
        return look_up("the variable")
    if form == LinearForm():
        return look_up("it is missing")
    if is_angle and not form.symbols and abs(form.number) > TURN:
        return look_up("in degrees? Radians are asked for")
    if wanted == LinearForm():
        return look_up("it should vanish")
    if form == _negated(wanted):
        return look_up("the sign")
    printed, correct = ([symbol for symbol, _ in each.symbols] for each in (form, wanted))
    if len(printed) == len(correct) == 1 and printed != correct:
        return written("{printed} for {correct}", printed=printed[0], correct=correct[0])
    if missing := sorted(set(correct) - set(printed)):
        return written("{name} is missing", name=missing[0])
    if extra := sorted(set(printed) - set(correct)):
        return written("{name} does not belong", name=extra[0])
    return ""


def _negated(form: LinearForm) -> LinearForm:
    return LinearForm(tuple((symbol, -coefficient) for symbol, coefficient in form.symbols), -form.pi, -form.number)


def _foot_test(way: np.ndarray, next_way: np.ndarray) -> np.ndarray:
    """Return the vector that is at right angles to what leads from the foot of the common normal to any point of the next axis."""
    return np.asarray(np.cross(next_way, np.cross(way, next_way)))


def _normal(origin: np.ndarray, way: np.ndarray, other: np.ndarray, next_way: np.ndarray) -> np.ndarray:
    """Return what leads from O_i to the next axis along the common normal: zero where they intersect or are one."""
    across = np.cross(way, next_way)
    between = other - origin
    if np.linalg.norm(across) < NEAR:
        return np.asarray(between - (between @ way) * way)
    return np.asarray((between @ across) * across / (across @ across))


def _parallel(one: np.ndarray, other: np.ndarray) -> bool:
    return bool(np.linalg.norm(np.cross(one, other)) < NEAR)


def _on_line(point: np.ndarray, on: np.ndarray, way: np.ndarray) -> bool:
    return _parallel(point - on, way)


def _listed(text: str, count: int) -> list[str] | str:
    """Return the entries of a text, "A, B" or "AB"; the text where it has not one a joint."""
    for entries in (re.split(r"[,;\s]+", text.strip(" []()")), re.findall(r"-?\w", text)):
        if len(entries) == count:
            return entries
    return text


def _triple(given: Any) -> Vector:
    parts = given.strip(" []()").split(",") if isinstance(given, str) else np.asarray(given, dtype=object).tolist()
    if len(parts) != 3:
        raise ValueError
    return vector(parts)


def _in_order(answer: Any, keys: Sequence[str]) -> Answer:
    if not isinstance(answer, list | tuple) or len(answer) != len(keys):
        raise AnswerError("the answer holds {count} lists: {keys}", count=len(keys), keys=list(keys))
    return dict(zip(keys, answer, strict=True))
