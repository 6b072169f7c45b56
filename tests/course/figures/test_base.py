"""The base of the figures: style, words, layouts, placement and what legibility finds."""

import re
from collections.abc import Iterator

import numpy as np
import pytest
from matplotlib import rcParams

from armproof.course import words
from armproof.course.errors import FigureError
from armproof.course.figures.drawing.fitting import SPACING, Fit
from armproof.course.figures.drawing.labels import arm_title, number, say
from armproof.course.figures.drawing.layout import lay_out
from armproof.course.figures.drawing.placement import LEADER, Label, place_labels
from armproof.course.figures.drawing.style import HIGHEST, MM, WIDTHS, mm_axes, new_figure, styled
from armproof.course.figures.facts.poses import showing_pose, zero_pose
from armproof.models.arm import Arm
from armproof.models.errors import LanguageError
from armproof.models.language import look_up, use
from armproof.models.numeric.joint_values import outside_limits
from armproof.models.showing.projection import choose_projection
from tests.course.figures.legibility import illegible

PLACEHOLDER = re.compile(r"\{(\w+)\}")


@pytest.fixture(autouse=True)
def style() -> Iterator[None]:
    with styled():
        yield


def test_the_style_restores_what_was_set_before() -> None:
    size = rcParams["font.size"]
    with styled():
        rcParams["font.size"] = 99
    assert rcParams["font.size"] == size


@pytest.mark.parametrize("size", WIDTHS)
def test_figures_are_as_wide_as_a_column_or_a_page(size: str) -> None:
    assert new_figure(size, 50).get_size_inches() / MM == pytest.approx([WIDTHS[size], 50])  # type: ignore[arg-type]


@pytest.mark.parametrize("arguments", [("poster", 50), ("column", HIGHEST + 1), ("column", 2)])
def test_sizes_that_no_page_has_are_refused(arguments: tuple[str, float]) -> None:
    with pytest.raises(FigureError, match=r"column or page|mm high"):
        new_figure(*arguments)  # type: ignore[arg-type]


def test_every_word_stands_in_both_languages_with_the_same_placeholders() -> None:
    for key, english in words.words().items():
        with use("fr"):
            french = look_up(english)
        assert sorted(PLACEHOLDER.findall(english)) == sorted(PLACEHOLDER.findall(french)), key


def test_an_unknown_language_is_told_which_are_known() -> None:
    with pytest.raises(LanguageError, match="'de'; the languages are en, fr"):
        say("target", "de")


def test_french_numbers_have_a_comma() -> None:
    assert (number(0.45, "en"), number(0.45, "fr"), number(0.45, "fr", in_math=True)) == ("0.45", "0,45", "0{,}45")


@pytest.mark.parametrize(
    ("value", "plain", "in_math"),
    [
        (-1118.5, "−1120", "-1120"),
        (95432.1, "95400", "95400"),
        (0.0000312, "3.12·10⁻⁵", r"3.12\times10^{-5}"),
        (2.5e9, "2.5·10⁹", r"2.5\times10^{9}"),
    ],
)
def test_large_and_small_numbers_are_written_without_a_caret(value: float, plain: str, in_math: str) -> None:
    assert (number(value, "en"), number(value, "en", in_math=True)) == (plain, in_math)


def test_every_arm_of_the_catalogue_has_a_french_title(arm: Arm) -> None:
    if arm.name not in ("slanted", "box"):
        assert arm_title(arm, "fr") != arm.title


def test_symbols_stand_on_their_axes_and_apart(arm: Arm) -> None:
    q = showing_pose(arm)
    spacing = Fit(arm, q).view(120, 90).metre * SPACING
    layout = lay_out(arm, q, spacing)
    for spot, joint in zip(layout.spots, layout.joints, strict=True):
        beside = np.cross(spot - joint.start, joint.axis)
        assert np.linalg.norm(beside) < 1e-9
    assert len(layout.links) == len(arm.joints) + 1
    if not choose_projection(arm).planar:
        gaps = np.linalg.norm(np.diff(layout.spots, axis=0), axis=1)
        assert gaps.min() > 0.3 * spacing
    off_axis = layout.spots[0] + 0.01 * np.cross(layout.joints[0].axis, [0.6, 0.0, 0.8])
    assert (
        np.linalg.norm(np.cross(off_axis - layout.joints[0].start, layout.joints[0].axis)) > 1e-3
    )  # the check can fail


def test_links_join_the_symbols(arm: Arm) -> None:
    layout = lay_out(arm, showing_pose(arm), 0.02)
    for link, spot, next_spot in zip(layout.links[1:-1], layout.spots, layout.spots[1:], strict=False):
        assert np.allclose(link[0], spot, atol=1e-9)
        assert np.allclose(link[-1], next_spot, atol=1e-9)


def test_poses_are_within_the_limits_and_always_the_same(arm: Arm) -> None:
    q = showing_pose(arm)
    assert not outside_limits(arm, q).any()
    assert not outside_limits(arm, zero_pose(arm)).any()
    showing_pose.cache_clear()
    assert np.array_equal(showing_pose(arm), q)


@pytest.mark.parametrize("arm", ["rx90"], indirect=True)
def test_an_arm_is_seen_whole(arm: Arm) -> None:
    figure = new_figure("column", 70)
    scene = Fit(arm, showing_pose(arm)).scene(figure, (0, 0, 84, 70))
    layout = lay_out(arm, showing_pose(arm), scene.metres(SPACING))
    for points in (*layout.links, layout.gripper[None]):
        at = scene.axes.transData.transform(scene.paper(points)) / figure.dpi / MM
        assert np.all(at > 9.9)
        assert np.all(at < np.array([84, 70]) - 9.9)


def test_labels_of_one_point_are_placed_beside_each_other() -> None:
    figure = new_figure("column", 40)
    axes = mm_axes(figure, 0, 0, 84, 40)
    axes.set_axis_off()
    axes.set_xlim(0, 1)
    axes.set_ylim(0, 1)
    texts = place_labels(figure, [Label(axes, f"label {k}", (0.5, 0.5)) for k in range(12)])
    assert illegible(figure) == ()
    assert any(line.get_gid() == LEADER for line in axes.lines)
    texts[0].set_position(texts[1].get_position())
    assert any("overlaps" in problem for problem in illegible(figure))


def test_labels_keep_off_the_ink_and_the_edge() -> None:
    figure = new_figure("column", 30)
    axes = mm_axes(figure, 0, 0, 84, 30)
    axes.set_axis_off()
    axes.set_xlim(0, 84)
    axes.set_ylim(0, 30)
    axes.fill_between([40, 60], 0, 30, color="black")
    (right, corner) = place_labels(figure, [Label(axes, "right", (39, 15), (1, 0)), Label(axes, "corner", (0, 0))])
    assert right.get_position()[0] < 39
    assert illegible(figure) == ()
    corner.set_position((0, 0))
    assert any("leaves the page" in problem for problem in illegible(figure))


def test_small_letters_are_found() -> None:
    figure = new_figure("column", 30)
    figure.text(0.5, 0.5, "small", fontsize=6)
    assert illegible(figure) == ("'small' is 6 pt",)
