"""A wrong number is told from what it comes: the formula with one slip, its digits, another value; and seldom by chance."""

import random
from typing import Any

import numpy as np
import pytest

from armproof.course.feedback import Number, lessons
from armproof.course.feedback.guesses import Guess, explained
from armproof.course.feedback.number_slips import letters_of
from armproof.course.feedback.worked import Worked

SUM = Number((0.7, 0.0), "m/s", ("v", "w"), steps=(r"-1 \cdot 0.3 + 2 \cdot 0.5",))
REACH = Number((0.05, 0.55), "m", ("near", "far"), {"a": 0.3, "b": 0.25}, steps=("a - b", "a + b"))
ROOT = Number(0.6, "m", steps=(r"\sqrt{(0.48^2 + 0.36^2)}",))
TURN = Number(2.0, "m", steps=(r"2 \sin 90^\circ",))
PEAK = Number(0.375, "m/s", steps=(r"15/8 \cdot 0.4/2",)).told_in("0.4 m in 2 s")
LIFT = Number(
    (0.25, 0.3),
    "m",
    known={"a": 0.3, "b": 0.25, "d": 0.1},
    steps=("", r"a \sin 90^\circ + b \sin(90^\circ - 90^\circ)"),
)
SHOULDER = Number(0.75, "m", known={"a": 1.25, "b": 0.25, "d": 0.33, "f": 0.42}, steps=("d + f",))
HALF = Number(-0.8, "m/s", steps=(r"-2 \cdot 0.4",))
TANGENT = Number((0.6, 0.75), "–", ("cos θ", "tan φ"), steps=("", "0.36/0.48")).told_in("s = [0.48, 0.36, -0.8]")
ACROSS = Number(0.25, "m", known={"a": 0.3, "b": 0.25}, steps=(r"a \cos 90^\circ + b \cos(90^\circ - 90^\circ)",))
STACK = Number(1.946, "m", known={"a": 1.25, "b": 0.25, "d": 0.33, "e": 0.054, "f": 0.42}, steps=("d + f + a - e",))
TIPS = Number((0.25, 0.85), "m", ("near", "far"), {"a": 0.25, "b": 0.3}, (1.0,), ("a", "a + 2 b"))
RATES = Number((0.2, 0.7), "m/s", ("v", "w"), steps=(r"-1 \cdot (-0.4) + 2 \cdot (-0.1)", ""))
RATE = Number(2.0, "rad/s")
POLAR = Number(2.0, "rad/s", known={"r": 0.05}, steps=("0.1/r",))
COLUMN = Number(0.81, "m", known={"a": 0.45, "b": 0.36}, steps=("a + b",))
ALONG = Number((0.0, 2.0), "m", ("x", "y"), steps=(r"\theta = 90^\circ", r"2 \cos\theta", r"2 \sin\theta"))
HYPOTENUSE = Number(0.87, "m", known={"a": 0.45, "b": 0.42}, steps=("a + b",), beside=(r"\sqrt{(a^2 + b^2)}",))
SPEED = Number(
    0.5, "m/s", known={"a": 0.145, "b": 0.105}, steps=("r = a + b", r"2 \cdot r"), beside=(r"2 \cdot (a - b)",)
)
FOLDED = Number(0.15, "m", known={"a": 0.4, "b": 0.25}, steps=(r"\theta = 270^\circ", r"a + b \sin\theta"))
QUARTER = Number(2.0, "m", steps=(r"\theta = 90^\circ", r"2 \sin\theta"))
ROUND = Number(2 * np.pi, "m", steps=(r"2 \pi",))
HEIGHT = Number(1.946, "m", ("z",))
TURNED = Number((0.0, 2.0, 0.0), "m", ("x", "y", "z"))
COUNTS = Number((6, 7, 7, 1), labels=("rows of J", "columns of J", "rows of q̇", "columns of q̇"))
FRACTION = Number(0.054, "m", known={"a": 1.25, "b": 0.135}, steps=("b/(2 a)",))
TRIPLE = Number((0.8, 0.6, 0.75), labels=("sin θ", "cos θ", "tan φ"), steps=("", "", "0.36/0.48"))
CIRCLE = Number((0.8, 0.6), labels=("sin θ", "cos θ"))
SPEEDS = Number(
    (-1.2, 0.9, 0.0),
    "m/s",
    ("v_x", "v_y", "v_z"),
    beside=(r"\omega = [0, 0, 3]", r"[v_x, v_y, \omega] = [-1.2, 0.9, 3]"),
)
DOWN = Number(1.196, "m", known={"d + f": 0.75, "b": 0.25}, steps=("1.946 - 0.75",)).told_in("1.946 m")
MERGED = Number((1.5,), "m", known={"a": 0.96, "b": 0.54, "c": 0.42}, steps=("a + b",))
FACTORS = Number((3, 9), labels=("the factor of the speed", "the factor of the acceleration"), steps=("3", "3^2"))
AWAY = Number(500.0, "m", steps=("0.5/0.001",)).told_in("0.5 m and 0.001 rad")
SHORT = Number(0.3948, "rad", steps=(r"\text{atan2}(0.2, 0.48)",), beside=(r"\arcsin(0.2)",)).told_in(
    "0.2 m and 0.48 m"
)
BOTH = Number((0.0, 2.0), "m", ("x", "y"), beside=("a + b = [2, 2]",))
PLACE = Number((1.5, 1.196), "m", ("x", "y"), {"a": 0.35, "b": 1.25}, (1.85, 1.946, 0.75), ("1.85 - a", "1.946 - 0.75"))
ANGLES = Number((0.64, -1.57, -0.93), "rad", ("θ_1", "θ_2", "θ_4"), steps=("", "", r"\theta_1 + \theta_2"))


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [
        (SUM, [1.3, 0], "this is 1 · 0.3 + 2 · 0.5"),
        (SUM, [1.0, 0], "this is 2 · 0.5 alone"),
        (SUM, [0.2, 0], "this is -1 · 0.3 + 0.5"),
        (REACH, [0.05, 0.3], "this is a alone"),
        (REACH, [0.05, 0.45], "one digit is off by one: a slip in the reckoning?"),
        (REACH, [0.15, 0.55], "a one that is carried over or borrowed is lost"),
        (SHOULDER, 0.65, "one digit is off by one: a slip in the reckoning?"),
        (COLUMN, 0.63, "it would be right with 0.27 in place of a"),
        (COLUMN, 0.71, "a one that is carried over or borrowed is lost"),
        (ROOT, 0.84, "this is (0.48 + 0.36)"),
        (ROOT, 0.3175, "this is √(0.48^2 - 0.36^2)"),
        (TURN, 1.788, "an angle in degrees is taken as radians"),
        (PEAK, 1.5, "this is 15/8 · 0.4 · 2"),
        (PEAK, 0.36, "rounded too early: 1.8 in place of 15/8"),
        (PEAK, 0.37, "cut off"),
        (FOLDED, 0.16, "one digit is off by one"),
        (ALONG, [2.0, 2.0], "x is not 2: this is 2 sin θ or 2, which are the same here"),
        (TIPS, [0.3, 0.9], "rounded to too few digits"),
        (TIPS, [0.2, 0.8], "rounded to too few digits"),
        (TIPS, [0.2, 0.9], "far is not 0.9"),
        (ANGLES, [-0.64, -1.57, 2.21], "with your θ_1: this is -θ_1 - θ_2"),
        (ANGLES, [-0.64, -1.57, -2.21], "this follows from your θ_1"),
        (HYPOTENUSE, 0.615, "this is √(a^2 + b^2)"),
        (HYPOTENUSE, 0.614, "too small"),
        (QUARTER, 90, "this is θ = 90°"),
        (PEAK, 0.4688, "it would be right with 0.5 in place of 0.4"),
        (PEAK, 0.3949, "too large by less than a tenth"),
        (SPEED, 0.395, "this is (2 · a + b)"),
        (SPEED, 2.25, "this is (2 + (a + b))"),
        (TRIPLE, [0.8, 0.6, 0.44], "tan φ is not 0.44"),
        (POLAR, 0.02, "is a length in centimetres?"),
        (RATE, 0.02, "wrong by a factor of 100"),
        (REACH, [0.05, 0.05], "this is a - b"),
        (REACH, [0.05, 0.5], "far is not 0.5: this is 2 b"),
        (ACROSS, 0.55, "this is a + b"),
        (LIFT, [0.25, 0.2], "number 2 is not 0.2: is this a - d?"),
        (SHOULDER, 2.0, "a does not belong in it"),
        (HALF, -0.4, "this is -0.4 alone"),
        (TANGENT, [0.6, 0.48], "tan φ is not 0.48: 0.48 is given for something else"),
        (STACK, 2.276, "d is counted twice"),
        (STACK, 1.892, "e is counted twice"),
        (STACK, 2.0, "e is missing"),
        (STACK, 1.696, "b does not belong in it"),
        (STACK, 2.196, "b does not belong in it"),
        (STACK, -1.25, "this is -a"),
        (TIPS, [0.3, 0.8], "a and b are exchanged"),
        (RATES, [0.6, 0.7], "v is not 0.6: this is -1 · (-0.4) - 2 · (-0.1)"),
        (RATE, 2 / (2 * np.pi), "in turns a second?"),
        (RATE, 12.57, "a factor 2π is too much"),
        (PEAK, 0.006545, "off by a factor π / 180"),
        (HEIGHT, 1.964, "two neighbouring digits are exchanged"),
        (HEIGHT, 1.46, "one digit is missing"),
        (HEIGHT, 1.9946, "one digit is written twice"),
        (HEIGHT, 1.846, "all digits but one are right"),
        (Number(1.196, "m"), 1.1, "cut off where it is to be rounded"),
        (HEIGHT, 0.973, "half of what is asked"),
        (PEAK, 0.19, "about half of what is asked"),
        (TURNED, [1.414, 1.414, 0], "the direction is not: yours is turned by 45°"),
        (COUNTS, [6, 7, 6, 1], "rows of q̇ is not 6: this is rows of J"),
        (COUNTS, [6, 7, 7, 7], "columns of q̇ is not 7: this is columns of J, rows of q̇"),
        (TRIPLE, [0.8, 0.6, 0.8], "tan φ is not 0.8: this is sin θ"),
        (TURNED, [1.41, 1.41, 0], "yours is turned by 45°"),
        (COUNTS, [6, 7, 8, 1], "rows of q̇ is not 8: one too many"),
        (ANGLES, [-2.5016, -1.57, -0.93], "half a turn off"),
        (ANGLES, [0.9308, -1.57, -0.93], "the complement"),
        (ANGLES, [2.5016, -1.57, -0.93], "the supplement"),
        (ANGLES, [0.64, -0.5, -0.93], "a factor π is missing"),
        (ANGLES, [0.0112, -1.57, -0.93], "π / 180 is too much"),
        (CIRCLE, [0.8, 0.2], "cos θ is not 0.2: this is 1 − sin θ"),
        (PLACE, [1.1, 1.2], "x is not 1.1: it would be right with 0.75 in place of a"),
        (TURNED, [0, 200, 0], "y is not 200: in centimetres? Metres are asked for"),
        (SPEEDS, [0, 0, 1.5], "the size is right, the direction is not: all of it stands in v_z"),
        (SPEEDS, [0, 0, 3], "this is ω"),
        (SPEEDS, [-1.2, 0.9, -3], "this is [v_x, v_y, ω], but for its sign"),
        (DOWN, 1.946, "d + f is missing"),
        (DOWN, 0.446, "d + f is counted twice"),
        (POLAR, 6.283, "a factor π is too much"),
        (POLAR, 0.6366, "a factor π is missing"),
        (SPEEDS, [0, 0, 6], "this is 2 · ω"),
        (BOTH, [1.0, 1.0], "this is 1/2 · (a + b)"),
        (TRIPLE, [0.8, 0.6, 0.6], "tan φ is not 0.6: this is cos θ"),
        (SPEEDS, [-1.2, 0.9, 1.5], "v_z is not 1.5: this is the size of all of them together"),
        (MERGED, [0.42], "this is c alone; or: this is a - b"),
        (SHORT, 0.2, "0.2 is given for something else"),
        (SHORT, 0.2014, "this is arcsin(0.2)"),
        (ANGLES, [0.5, -1.57, -1.07], "θ_4: this follows from your θ_1: nothing else is wrong with it"),
    ],
)  # fmt: skip
def test_a_wrong_number_is_told_what_it_comes_from(asks: Any, answer: Any, words: str) -> None:
    assert words in asks.judge(answer).message


@pytest.mark.parametrize(
    ("asks", "answer", "words"),
    [(FACTORS, [1.5, 2.25], "whole number"), (AWAY, 500.25, "order"), (AWAY, 1000.5, "this is twice"), (LIFT, [0.25, 0.39], "size of all"), (REACH, [0.05, 0.4], "this is"), (HEIGHT, 1.896, "digit"), (ANGLES, [0.5, -1.57, -1.2], "follows"), (TURN, 1.7, "degrees"), (ROUND, 6.8, "in place of"), (Number(1.5, "m"), 1.50097, "rounded"), (RATES, [1.4, 0.7], "factor"), (STACK, 1.892, "missing"), (TURN, 1.41421, "square"), (TURNED, [1.2, 1.6, 0], "turned"), (TURNED, [1.0, 1.0, 0], "turned"), (REACH, [0.05, 0.5437], "in place of"), (HEIGHT, 1.7, "cut off"), (RATE, 12.0, "2π"), (STACK, 0.03396, "π / 180"), (FRACTION, -1.196, "missing"), (CIRCLE, [0.8, 0.3], "1 −"), (ANGLES, [0.64, 3.14, -0.93], "complement"), (CIRCLE, [0.8, 0.2], "factor"), (PEAK, 0.15, "in place of")],
)  # fmt: skip
def test_of_any_other_number_nothing_of_the_kind_is_said(asks: Any, answer: Any, words: str) -> None:
    assert words not in asks.judge(answer).message


def test_what_a_task_says_of_its_numbers_gives_them() -> None:
    ways = 0
    for task in (task for lesson in lessons() for task in lesson.tasks):
        asks = task.asks
        if not isinstance(asks, Number):
            continue
        asks, right = asks.told_in(task.text), np.atleast_1d(np.array(asks.value, dtype=float))
        labels = [asks.labels[k] if asks.labels else "" for k in range(right.size)]
        known = {**asks.known, **asks.way.angles, **letters_of(dict(zip(labels, right.tolist(), strict=True)))}
        for way, number in zip(asks.way.ways, right, strict=False):
            assert not way or np.isclose(Worked(way, known).value, number, atol=1e-12)
            ways += bool(way)
    assert ways > 20


def test_a_number_of_few_digits_is_seldom_explained() -> None:
    draw = random.Random(1)
    guesses = [Guess(draw.uniform(-2, 2), lambda: "by chance") for _ in range(500)]
    for decimals, most in ((1, 0.04), (2, 0.04), (3, 0.04)):
        numbers = [round(draw.uniform(-2, 2), decimals) for _ in range(3000)]
        told = [explained(number, 1.0, guesses) for number in numbers if number not in (0, 1)]
        assert sum(map(bool, told)) < most * len(told)
