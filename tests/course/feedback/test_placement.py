"""Every admissible choice of frames is accepted, and its table moves as the arm does; a choice that is not admissible is refused."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

from armproof.course.errors import AnswerError
from armproof.course.feedback import open_lesson
from armproof.course.feedback.notebook import Portrait
from armproof.course.feedback.outcome import Outcome
from armproof.course.feedback.placement import Placement
from armproof.course.figures.facts.placing import Placed, Scheme, table_of
from armproof.course.tasks.placing_frames import RIG
from armproof.models.bulk.bulk import bulk_of
from armproof.models.dh.table import read_table
from armproof.models.loading.dh_plant import build_arm
from tests.laws import SWEEP

SCHEMES = {
    "planar_2r": Scheme("planar_2r", {"A": (0, 0, 0), "B": ("l_1", 0, 0)}),
    "scara": Scheme("scara", {"A": (0, 0, 0), "B": ("a_1", 0, 0), "C": ("a_1 + a_2", 0, 0)}),
    "rx90": Scheme("rx90", {"A": (0, 0, 0), "B": ("a_3", 0, 0), "C": ("a_3", 0, "d_3")}),
    "rig": Scheme(RIG, {"A": (0, 0, 0), "B": ("a_2", 0, 0), "C": ("a_2 + e", 0, 0)}),
}
EVERY_ARM = pytest.mark.parametrize("scheme", SCHEMES.values(), ids=SCHEMES)
Chosen = dict[str, Any]


def step(scheme: Scheme, name: str) -> Placement:
    return Placement(scheme, name, {"z": [], "O": [], "x": []})


def message(scheme: Scheme, name: str, answer: Any) -> str:
    feedback = step(scheme, name).judge(answer)
    assert feedback.outcome is Outcome.WRONG
    return feedback.message


def is_crossed(one: np.ndarray, other: np.ndarray) -> bool:
    return bool(np.linalg.norm(np.cross(one, other)) > 1e-9)


def admissible(scheme: Scheme, rng: np.random.Generator) -> Chosen:
    """Return frames by the eight steps, drawn at random wherever these leave a choice."""
    points, ways = scheme.axes(scheme.generic)
    last = len(ways) - 1
    places, x = points.copy(), np.zeros_like(points)
    for k in reversed(range(last + 1)):
        if scheme.arm.joints[k].kind == "prismatic":
            places[k] += np.round(rng.uniform(-0.3, 0.3), 2) * np.array([1.0, 0, 0])  # any place will do for a slide
        across = np.cross(ways[k], ways[k + 1]) if k < last else np.zeros(3)
        if k < last and is_crossed(ways[k], ways[k + 1]):
            along = np.cross(ways[k + 1], across)
            places[k] += ((places[k + 1] - places[k]) @ along) / (ways[k] @ along) * ways[k]
            normal = (places[k + 1] - places[k]) @ across * across
            free = across * rng.choice([-1, 1])
        else:
            places[k] += np.round(rng.uniform(-0.3, 0.3), 2) * ways[k]
            between = places[k + 1] - places[k] if k < last else np.zeros(3)
            normal = between - (between @ ways[k]) * ways[k]
            free = np.cross(ways[k], rng.permuted(np.where(np.abs(ways[k]) > 0.5, 0.0, [1.0, 1.0, 1.0])))
            free = free if is_crossed(free, ways[k]) else np.roll(np.abs(ways[k]), 1)
        x[k] = normal if np.linalg.norm(normal) > 1e-9 else free
    senses = rng.choice([-1, 1], len(ways))
    origins = [[in_letters(part, scheme) for part in place] for place in places]
    return {"z": (senses[:, None] * ways).tolist(), "O": origins, "x": x.tolist()}


def in_letters(value: float, scheme: Scheme) -> str:
    """Return a coordinate as lengths of the arm and hundredths of a metre."""
    for factors in product((0, 1, -1), repeat=len(scheme.generic)):
        rest = value - sum(f * v for f, v in zip(factors, scheme.generic.values(), strict=True))
        if abs(rest - round(rest, 2)) < 1e-9:
            terms = [f"{f} * {symbol}" for f, symbol in zip(factors, scheme.generic, strict=True) if f]
            return " + ".join([*terms, f"{round(rest, 2):.2f}"])
    raise AssertionError(value)


def moves_as_the_arm(scheme: Scheme, chosen: Chosen) -> bool:
    """Whether the table of frames carries the last of them as the arm does, wherever the joints are."""
    read = step(scheme, "table")._vectors
    placed = Placed(*(read(key, chosen[key]) for key in ("z", "O", "x")))
    rows, drawn = table_of(scheme, placed)
    values, symbols = dict(scheme.arm.lengths), [joint.symbol for joint in scheme.arm.joints]
    written = [{name: str(getattr(row, name)) for name in ("alpha", "a", "d", "theta")} for row in rows.rows]
    assert step(scheme, "table").judge({**chosen, "table": written}).is_right
    yours = build_arm(read_table({"dh": "modified", "rows": written, "joints": symbols}), values)
    z, _, _ = placed.at(values)
    senses = np.einsum("ij,ij->i", z, scheme.axes(values)[1])
    start = np.array([drawn[symbol].value(values) for symbol in symbols])
    moved = np.vstack([np.zeros(len(symbols)), np.random.default_rng(5).uniform(-1, 1, (4, len(symbols)))])
    arms = bulk_of(scheme.arm).pose(moved, scheme.arm.frames[-1])
    tables = bulk_of(yours).pose(start + senses * moved, yours.frames[-1])
    poses = list(placed.poses(values).values())
    return np.allclose(poses[0] @ tables, arms @ np.linalg.inv(arms[0]) @ poses[-1], atol=1e-9)


@EVERY_ARM
def test_every_admissible_choice_is_accepted_and_its_table_moves_as_the_arm(scheme: Scheme) -> None:
    rng = np.random.default_rng(14)
    for _ in range(8 if SWEEP else 3):
        chosen = admissible(scheme, rng)
        for name in ("z", "O", "x"):
            answer = {key: chosen[key] for key in ("O", "x")} if name == "x" else chosen[name]
            feedback = step(scheme, name).judge(answer)
            assert feedback.outcome is Outcome.PROVED, (feedback.message, chosen)
        assert moves_as_the_arm(scheme, chosen)


@EVERY_ARM
def test_a_choice_that_is_moved_off_is_refused_or_its_table_still_moves_as_the_arm(scheme: Scheme) -> None:
    """What leaves the procedure's freedom is refused; the one refusal that is a rule and no geometry is the sense of x."""
    rng = np.random.default_rng(41)
    refused = 0
    for _ in range(12):
        chosen = admissible(scheme, rng)
        k, key = int(rng.integers(len(chosen["z"]))), str(rng.choice(["z", "O", "x"]))
        if key == "O":
            chosen["O"][k] = [
                f"{part} + {shift}" for part, shift in zip(chosen["O"][k], (0.07, 0.11, 0.05), strict=True)
            ]
        else:
            chosen[key][k] = (np.array(chosen[key][k]) + rng.normal(size=3)).tolist()
        whole = {**chosen, "table": [(0, 0, 0, 0)] * len(chosen["z"])}
        problems = step(scheme, "table")._problems(step(scheme, "table")._read(whole))
        if "for the frames that you placed" in (first := next(problems)) or "row" in first:
            assert moves_as_the_arm(scheme, chosen)
        else:
            refused += 1
    assert refused >= 8


def test_the_mistakes_of_each_step_are_named() -> None:
    rx90, rig, scara = SCHEMES["rx90"], SCHEMES["rig"], SCHEMES["scara"]
    z = ["z", "-y", "-y", "z", "y", "z"]
    assert step(rx90, "z").judge(z).is_right
    assert "as in the classic convention" in message(rx90, "z", ["-y", "-y", "z", "y", "z", "z"])
    assert "the axis about which joint 2 turns" in message(rx90, "z", ["z", "x", "-y", "z", "y", "z"])
    assert "the slide of joint 3" in message(scara, "z", ["z", "z", "x", "z"])
    assert "axes 1 and 2 intersect: O_1" in message(rx90, "O", [[0, 0, 0.1], "A", "B", "C", "C", "C"])
    assert "O_2 is on the axis of joint 3" in message(rx90, "O", ["A", "B", "B", "C", "C", "C"])
    assert "O_4 is not on the axis of joint 4" in message(rx90, "O", ["A", "A", "B", [0, 0, 1], "C", "C"])
    assert "axes 3 and 4 are skew" in message(rig, "O", ["A", "A", ["a_2", 0.1, 0], "C"])
    origins = ["A", "A", "B", "C", "C", "C"]
    shifted = [["A", "A", "B", "C", "C", "C"], ["y", "x", "x", "x", "x", "x"]]
    assert "x_1 is at right angles to z_1 but not to z_2" in message(rx90, "x", shifted)
    assert "x_3 is at right angles to z_3 but not to z_4" in message(rig, "x", [list("AABC"), ["x", "x", "z", "x"]])
    assert "not at right angles to z_1" in message(rx90, "x", [origins, ["z", "x", "x", "x", "x", "x"]])
    assert "x_2 points from axis 3 back to axis 2" in message(rx90, "x", [origins, ["x", "-x", "x", "x", "x", "x"]])
    assert "axes 2 and 3 are parallel: x_2 leads" in message(rx90, "x", [origins, ["x", "z", "x", "x", "x", "x"]])


def test_a_free_origin_that_makes_an_offset_is_right_with_a_note() -> None:
    feedback = step(SCHEMES["scara"], "O").judge(["A", ["a_1", 0, 0.2], "C", "C"])
    assert feedback.is_right
    assert feedback.notes == ("O_2 is free along z_2; where you put it, d_2 is not zero",)
    assert not step(SCHEMES["scara"], "O").judge(["A", "B", "C", "C"]).notes


def test_a_slide_is_free_in_place_even_where_its_table_has_no_linear_entries() -> None:
    scara = SCHEMES["scara"]
    beside = ["A", "B", ["a_1 + a_2", 0.1, 0], "C"]
    x = ["x", ["a_2", 0.1, 0], [0, -1, 0], "x"]
    assert step(scara, "O").judge(beside).is_right
    assert step(scara, "x").judge([beside, x]).is_right
    assert "axes 2 and 3 are parallel" in message(scara, "x", [beside, ["x", "x", "y", "x"]])
    with pytest.raises(AnswerError, match="no sums of the letters"):
        step(scara, "table").judge([["z"] * 4, beside, x, [(0, 0, 0, 0)] * 4])


def test_the_table_is_that_of_ones_own_frames() -> None:
    planar = SCHEMES["planar_2r"]
    up = {"z": ["z", "z"], "O": ["A", "B"], "x": ["x", "x"]}
    rows = [(0, 0, 0, "theta_1"), (0, "l_1", 0, "theta_2")]
    assert step(planar, "table").judge({**up, "table": rows}).is_right
    down = {**up, "z": ["z", "-z"]}
    assert "alpha" in message(planar, "table", {**down, "table": rows})
    assert step(planar, "table").judge({**down, "table": [rows[0], (r"\pi", "l_1", 0, "theta_2")]}).is_right
    turned = {**up, "x": ["x", "y"]}
    for theta in ("theta_2", "theta_2 + pi/2"):  # counted from x_1, or from where the arm is drawn
        assert step(planar, "table").judge({**turned, "table": [rows[0], (0, "l_1", 0, theta)]}).is_right
    assert "theta" in message(planar, "table", {**turned, "table": [rows[0], (0, "l_1", 0, "theta_2 - pi/2")]})
    assert "a and d are exchanged" in message(planar, "table", {**up, "table": [rows[0], (0, 0, "l_1", "theta_2")]})


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ((0, "l_2", 0, "theta_2"), "row 2: a is wrong for the frames that you placed (l_2 for l_1)"),
        ((0, "-l_1", 0, "theta_2"), "(the sign)"),
        ((0, "l_1 + l_2", 0, "theta_2"), "(l_2 does not belong)"),
        ((0, 0, 0, "theta_2"), "(it is missing)"),
        (("pi", "l_1", 0, "theta_2"), "(it should vanish)"),
        ((90, "l_1", 0, "theta_2"), "(in degrees? Radians are asked for)"),
        (("l_1", 0, 0, "theta_2"), "row 2: l_1 is a length, and stands in the column of alpha"),
        ((0, "theta_2", 0, "theta_2"), "row 2: a is wrong for the frames that you placed (theta_2 for l_1)"),
        ((0, "l_1", 0, "-theta_2"), "(the sign)"),
        (("theta_2", "l_1", 0, 0), "theta_2 stands in the column of alpha; joint 2 turns, so its variable is theta"),
        ((0, "l_1", 0, 0), "(it is missing)"),
        ((0, "2 l_1", 0, "theta_2"), "row 2: a is wrong for the frames that you placed"),
    ],
)
def test_what_is_wrong_in_a_row_is_named(row: tuple[object, ...], words: str) -> None:
    planar = SCHEMES["planar_2r"]
    frames = {"z": ["z", "z"], "O": ["A", "B"], "x": ["x", "x"]}
    assert message(planar, "table", {**frames, "table": [(0, 0, 0, "theta_1"), row]}).endswith(words)


def test_an_entry_may_be_in_greek_letters_small_digits_or_latex() -> None:
    planar = SCHEMES["planar_2r"]
    frames = {"z": ["z", "-z"], "O": ["A", "B"], "x": ["x", "x"]}
    for row in (("π", "l₁", 0, "θ₂"), (r"\pi", "l1", 0, "θ2"), (r"\frac{2\pi}{2}", "l_{1}", 0, r"\theta_2")):
        assert step(planar, "table").judge({**frames, "table": [(0, 0, 0, "θ1"), row]}).is_right
    assert "(l_2 for l_1)" in message(planar, "table", {**frames, "table": [(0, 0, 0, "θ1"), ("π", "l₂", 0, "θ₂")]})


def test_what_cannot_be_read_is_told() -> None:
    planar = SCHEMES["planar_2r"]
    for answer in (["w", "z"], ["z"], ["AA", "z"], [[0, 0, 0], "z"], "z"):
        with pytest.raises(AnswerError):
            step(planar, "z").judge(answer)
    with pytest.raises(AnswerError, match="x is missing"):
        step(planar, "x").judge({"O": ["A", "B"], "x": ...})
    assert step(planar, "x").judge([..., ...]).outcome is Outcome.NOT_ATTEMPTED


def test_the_arm_of_a_table_is_drawn_beside_the_true_one_whose_table_shows_once_it_is_found() -> None:
    task = open_lesson("placing_frames").table
    right, wrong = task.show(task.right[0]), task.show(task.wrong[1].answer)
    assert [picture.caption for picture in right.pictures] == ["The arm of your table", "The arm as it is"]
    assert len(right.pictures[1].svg) > 1.1 * len(wrong.pictures[1].svg)
    assert "cannot be drawn" in str(task.show([(0, 0, 0, 0)] * 4))
    assert "cannot be drawn" in str(task.show([(0, 0)]))


def test_frames_are_drawn_beside_the_usual_ones_once_they_are_right() -> None:
    usual = {"z": ["z", "z"], "O": ["A", "B"], "x": ["AB", "AB"]}
    asks = Placement(SCHEMES["planar_2r"], "x", usual)
    right = asks.show("x", {"O": ["A", "B"], "x": ["x", "-y"]}, {})
    wrong = asks.show("x", {"O": ["A", "B"], "x": ["-x", "x"]}, {})
    assert isinstance(right, Portrait) and isinstance(wrong, Portrait)
    assert [len(right.pictures), len(wrong.pictures)] == [2, 1]
    assert "back to axis 1" in repr(wrong)
    assert right._repr_html_().count("<img") == 2
