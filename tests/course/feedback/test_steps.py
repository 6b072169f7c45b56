"""The lines that lead to a number: each is true, the last give the answer, a solution opens them; what stands beside is something else."""

from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Number, Task, lessons
from armproof.course.feedback.number_slips import letters_of
from armproof.course.feedback.steps import Beside, Steps, equation_of
from armproof.course.feedback.worked import Worked

SEEDS = ("anna", "bob", "17")
TASKS = [task for lesson in lessons() for task in lesson.tasks if isinstance(task.asks, Number)]
OWN = [task.own(seed) for task in TASKS if task.own is not None for seed in SEEDS]
EVERY_NUMBER = pytest.mark.parametrize("task", [*TASKS, *OWN], ids=lambda task: task.name)

ARM = Number(
    (0.25, 0.3, -0.1),
    "m",
    ("x", "y", "z"),
    {"a": 0.3, "b": 0.25, "d": 0.1},
    steps=(
        r"\theta_1 = 90^\circ",
        r"\theta_2 = -90^\circ",
        r"x = a \cos\theta_1 + b \cos(\theta_1 + \theta_2)",
        r"y = a \sin\theta_1 + b \sin(\theta_1 + \theta_2)",
        "z = -d",
    ),
    beside=(r"-a y_0 = [0, -a, 0]", r"\sqrt{(a^2 + b^2)}"),
)
PEAK = Number(
    0.375, "m/s", steps=("v_m = 0.4/2", r"v = 15/8 \cdot v_m"), beside=(r"10/\sqrt{3} \cdot 0.4/2^2",)
).told_in("0.4 m in 2 s")
FACTORS = Number((2, 4), labels=("speed", "acceleration"), steps=("2", "2^2"), beside=(r"[, 2 \cdot 3]",))
RATE = Number(2.0, "rad/s", steps=("r = 0.05", "0.1/r")).told_in("0.1 m/s")
ROLL = Number(
    (-np.pi / 2, 0, 0.4), "rad", ("roll", "pitch", "yaw"), steps=(r"\theta_1 = 0.4", r"-\pi/2", "0", r"\theta_1")
)
TURN = Number((-0.8, 0.6, 0), "m/s", ("v_x", "v_y", "v_z"), stated=(0.5,), steps=(r"-2 \cdot 0.4", r"2 \cdot 0.3", "0"))


def known_of(asks: Number, place: int) -> dict[str, float]:
    """Return the values of the letters that the way to one of the numbers may name."""
    right = np.atleast_1d(np.array(asks.value, dtype=float)).tolist()
    others = {label: value for k, (label, value) in enumerate(zip(asks.labels, right, strict=False)) if k != place}
    return {**asks.known, **asks.way.angles, **letters_of(others)}


@EVERY_NUMBER
def test_the_last_lines_give_what_is_asked(task: Task) -> None:
    asks = task.asks.told_in(task.text)
    right = np.atleast_1d(np.array(asks.value, dtype=float)).tolist()
    last = [equation_of(line) for line in asks.steps[-len(right) :]]
    values = [number if not line.latex else float(line.latex) if line.is_given else Worked(way, known_of(asks, k)).value
              for k, (number, line, way) in enumerate(zip(right, last, asks.way.ways, strict=False))]  # fmt: skip
    assert np.allclose(values, right[: len(values)], atol=1e-12)


@EVERY_NUMBER
def test_every_line_on_the_way_is_needed(task: Task) -> None:
    asks = task.asks.told_in(task.text)
    for k, line in enumerate(map(equation_of, asks.steps[: -np.size(asks.value)])):
        assert line.name
        assert any(line.name in later for later in asks.steps[k + 1 :])


@EVERY_NUMBER
def test_what_stands_beside_is_something_else(task: Task) -> None:
    asks = task.asks.told_in(task.text)
    right = np.atleast_1d(np.array(asks.value, dtype=float))
    beside = Beside(asks.beside, known_of(asks, -1))
    lists = [line.cells for line in map(equation_of, asks.beside) if line.name and line.cells and all(line.cells)]
    assert not any(np.allclose([Worked(cell, beside.known).value for cell in cells], right) for cells in lists)
    guesses = [guess for k in range(right.size) for guess in beside.of_one(k, right, [])]
    assert all(np.isfinite(guess.value) and guess.words() for guess in guesses)
    assert all(len(equation_of(line).cells) in (0, right.size) for line in asks.beside)
    if right.size == 1:
        assert not any(np.isclose(guess.value, right[0]) for guess in guesses)


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (ARM, [0, 0.05, -0.1], "this is for θ_2 = 180°"),
        (ARM, [0, 0.55, -0.1], "this is for θ_2 = 0°"),
        (ARM, [0.55, 0, -0.1], "this is for θ_1 = 0°, θ_2 = 0°"),
        (ARM, [0.1156, 0.2682, -0.1], "an angle in degrees is taken as radians"),
        (ARM, [0.1768, 0.4768, -0.1], "this is for θ_2 = -45°"),
        (ARM, [0, -0.3, 0], "this is -a y_0"),
        (ARM, [0, 0.6, 0], "this is −2 · -a y_0"),
        (ARM, [0.25, 0.3, 0], "z is not 0: d is missing"),
        (ARM, [0, 0.3, -0.1], "b cos(θ_1 + θ_2) is missing"),
        (ARM, [0.3, 0.25, -0.1], "are exchanged"),
        (ARM, [0.3905, 0.3, -0.1], "this is √(a^2 + b^2)"),
        (PEAK, 3.0, "this is 15 · (0.4/2)"),
        (PEAK, 0.025, "this is (1/8) · (0.4/2)"),
        (PEAK, 0.2, "this is 0.4/2 alone"),
        (PEAK, 0.577, "this is 10/√3 · 0.4/2^2"),
        (FACTORS, [2, 6], "acceleration is not 6: this is 2 · 3"),
        (RATE, 0.2, "wrong by a factor of 10"),
        (RATE, 0.05, "this is r alone"),
        (RATE, 19.1, "in turns a minute?"),
        (RATE, 4.0, "this is twice what is asked"),
        (ROLL, [0, 0, 0.4], "π/2 is missing"),
        (ROLL, [-1.1708, 0, 0.4], "yaw does not belong in it"),
        (ROLL, [-np.pi / 2, 0.4, 0], "pitch and yaw are exchanged"),
        (ROLL, [-np.pi / 2, 0, 0.4 + np.pi / 2], "a quarter of a turn off"),
        (TURN, [-0.8, 0.6, 0.6], "v_z is not 0.6: this is v_y"),
        (TURN, [-0.8, 0.6, 0.5], "0.5 is given for something else"),
        (TURN, [-0.4, 0.6, 0], "this is -0.4 alone"),
    ],
)  # fmt: skip
def test_a_slip_on_the_way_is_told(asks: Any, answer: Any, words: str) -> None:
    assert words in asks.judge(answer).message


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (ARM, [0.25, 0.3, -0.1], "this is"),
        (ARM, [0.2, 0.31, -0.1], "this is for"),
        (ARM, [0.18, 0.47, -0.1], "this is for"),
        (ARM, [0.12, 0.25, -0.1], "radians"),
        (PEAK, 0.41, "15"),
        (FACTORS, [6, 4], "2 · 3"),
        (RATE, 19.6, "minute"),
        (ROLL, [-1.3, 0, 0.4], "yaw does not belong"),
        (TURN, [-0.8, 0.6, 0.7], "v_y"),
    ],
)
def test_of_any_other_number_no_slip_is_told(asks: Any, answer: Any, words: str) -> None:
    assert words not in asks.judge(answer).message


def test_lines_are_put_into_those_below_but_not_what_is_asked() -> None:
    way = Steps(("r = 0.05", r"u = 2 r", r"v = u \omega", r"w = v + u"), 2)
    assert way.given == {"r": 0.05}
    assert way.ways == (r"(2 r) \omega", "v + (2 r)")
    assert way.shown == ("u = 2 r", r"v = u \omega", "w = v + u")


def test_a_solution_opens_the_lines_on_the_way_one_by_one() -> None:
    task = Task("peak", "Peak", "0.4 m in 2 s", PEAK, ("mean", "peak"), (0.375,))
    task.check(1.0)
    first, second = str(task.solution()), str(task.solution())
    assert "$v_m = 0.4/2$" in first and "15/8" not in first
    assert r"$v = 15/8 \cdot v_m = 0.375$ m/s" in second


@EVERY_NUMBER
@pytest.mark.parametrize("number", [float("inf"), float("-inf"), float("nan"), "infinite", 0.0, 1e300, 1e-300])
def test_no_number_is_an_error(task: Task, number: Any) -> None:
    count = np.size(task.asks.value)
    told = task.check(number if count == 1 else [number] * count)
    assert told.message and not told.is_right
