"""Sketches: what is drawn is where the double plant has it, and the DH tables are those of the arms."""

import re
from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.facts.dh_rows import link_matrices, link_rows
from armproof.course.figures.facts.lengths import frame_lengths
from armproof.course.figures.kinds.sketch import caption, shown_frames, sketch, sketch_pose
from armproof.models.arm import Arm
from armproof.models.errors import LanguageError
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import choose_projection

TOLERANCE = 1e-9  # m
MODIFIED = ("rx90", "scara_modified")
NOT_DH = ("kr210", "polar_rp", "slanted")


@lru_cache(maxsize=32)
def figure_of(draw: Callable[[Arm], Figure], arm: Arm) -> Figure:
    """Draw a figure once for all tests that look at it."""
    return draw(arm)


def drawn(figure: Figure) -> dict[str, np.ndarray]:
    """The points of each line of a figure, by every name that its gid holds."""
    lines = {}
    for axes in figure.axes:
        assert isinstance(axes, Axes)
        for line in axes.lines:
            for name in (line.get_gid() or "").split("; "):
                lines[name] = np.column_stack(line.get_data())
    return lines


def frame_errors(arm: Arm, lines: dict[str, np.ndarray], q: np.ndarray) -> np.ndarray:
    """How far each arrow of a frame is from where the double plant has its origin, and from its direction."""
    projection, errors = choose_projection(arm), []
    numeric = NumericKinematics(arm, q[None])
    for frame in shown_frames(arm):
        X = numeric.pose(frame)[0]
        for k, letter in enumerate("xyz"):
            start, tip = lines[f"frame {frame} {letter}"]
            origin, way = projection.points(X[:3, 3]), projection.points(X[:3, k])
            turn = (tip - start)[0] * way[1] - (tip - start)[1] * way[0]
            backwards = max(0.0, -float((tip - start) @ way))
            errors.append(max(np.abs(start - origin).max(), abs(turn), backwards))
    return np.array(errors)


def test_frames_are_drawn_where_the_plant_has_them(arm: Arm) -> None:
    lines, q = drawn(figure_of(sketch, arm)), sketch_pose(arm)
    assert frame_errors(arm, lines, q).max() <= TOLERANCE
    assert frame_errors(arm, lines, q + 1e-3).max() > 1e-5  # at another pose they would not be


def test_symbols_stand_on_the_axes_that_the_plant_has(arm: Arm) -> None:
    """Joint i of a DH table turns about z of frame i − 1 (classic) or i (modified), which the plant gives."""
    rows = link_rows(arm)
    if rows is None:
        pytest.skip("no DH frames")
    lines, q = drawn(figure_of(sketch, arm)), sketch_pose(arm)
    projection, off = choose_projection(arm), []
    for row in rows.rows:
        X = NumericKinematics(arm, q[None]).pose(row.previous if rows.convention == "classic" else row.frame)[0]
        spot, way = lines[f"joint {row.joint}"][0], projection.points(X[:3, 2])
        from_origin = spot - projection.points(X[:3, 3])
        off.append(from_origin[0] * way[1] - from_origin[1] * way[0])
    assert np.abs(off).max() <= TOLERANCE


def test_the_tool_ends_the_last_link_of_planar_arms(arm: Arm) -> None:
    if not choose_projection(arm).planar:
        pytest.skip("its gripper may be drawn further out")
    lines, q = drawn(figure_of(sketch, arm)), sketch_pose(arm)
    end = choose_projection(arm).points(NumericKinematics(arm, q[None]).pose(arm.frames[-1])[0, :3, 3])
    assert np.abs(lines[f"link {len(arm.joints)}"][-1] - end).max() <= TOLERANCE


def test_the_table_is_the_arms(arm: Arm) -> None:
    rows = link_rows(arm)
    if arm.name in NOT_DH:
        assert rows is None
        return
    assert rows is not None
    assert rows.convention == ("modified" if arm.name in MODIFIED else arm.dh.convention if arm.dh else "classic")
    q = np.random.default_rng(3).uniform(-1, 1, len(arm.joints))
    symbols = {**arm.lengths, **arm.angles, **dict(zip((j.symbol for j in arm.joints), q, strict=True))}
    values = [[form.value(symbols) for form in (row.a, row.alpha, row.d, row.theta)] for row in rows.rows]
    X = np.array([NumericKinematics(arm, q[None]).pose(row.frame, row.previous)[0] for row in rows.rows])
    assert np.abs(link_matrices(np.array(values), rows.convention) - X).max() <= TOLERANCE
    other = "modified" if rows.convention == "classic" else "classic"
    if arm.name != "spherical_wrist":  # at most one of a, α in a row of which both conventions make the same of
        assert np.abs(link_matrices(np.array(values), other) - X).max() > 1e-3


def test_lengths_lead_from_frame_to_frame(arm: Arm) -> None:
    q = sketch_pose(arm)
    poses = {frame: NumericKinematics(arm, q[None]).pose(frame)[0] for frame in shown_frames(arm)}
    found = frame_lengths(arm, shown_frames(arm), poses)
    for frame in shown_frames(arm)[1:]:
        mine = [each for each in found if each.frame == frame]
        if mine:
            assert np.abs(mine[-1].end - poses[frame][:3, 3]).max() <= TOLERANCE


@pytest.mark.parametrize("arm", ["rx90"], indirect=True)
def test_a_length_is_as_long_as_it_says(arm: Arm) -> None:
    lines, projection = drawn(figure_of(sketch, arm)), choose_projection(arm)
    for gid, symbol, frames in (("length 2 3", "a_3", ("2", "3")), ("length 3 4", "d_3", ("3", "4"))):
        poses = [NumericKinematics(arm, sketch_pose(arm)[None]).pose(frame)[0, :3, 3] for frame in frames]
        assert np.linalg.norm(poses[1] - poses[0]) == pytest.approx(arm.lengths[symbol])
        expected = projection.points(poses[1] - poses[0])
        assert np.abs(lines[gid][1] - lines[gid][0] - expected).max() <= TOLERANCE


@pytest.mark.parametrize("arm", ["planar_2r", "rx90", "kr210"], indirect=True)
def test_captions_hold_the_numbers(arm: Arm) -> None:
    for symbol, value in arm.lengths.items():
        number = f"{value:.3g}"
        assert re.search(rf"{symbol[-1]}\}}?\$ = {re.escape(number)} m", caption(arm)), symbol
        assert number.replace(".", ",") in caption(arm, "fr")


def test_an_unknown_language_is_refused() -> None:
    from armproof.models.catalogue import load_arm

    with pytest.raises(LanguageError, match="no language 'it'"):
        sketch(load_arm("planar_2r"), "it")
