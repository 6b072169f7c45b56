"""Films: each picture has the arm where the motion has it; the files are whole, repeat byte for byte, and say what is missing."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from armproof.course.errors import FigureError
from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.facts.motions import make_motion, motion_of
from armproof.course.figures.facts.task import tool_points
from armproof.course.figures.output import films
from armproof.course.figures.output.films import FILMS, RATE, film_reason, frame_figure, frames, write_film
from armproof.course.figures.output.production import Order, produce
from armproof.models.catalogue import load_arm
from armproof.models.errors import LanguageError, ModelError
from tests.course.figures.test_sketch import TOLERANCE, drawn
from tests.models.showing.test_rendering import TABLE


def test_a_picture_has_the_arm_where_the_plant_has_it() -> None:
    arm = load_arm("rx90")
    motion = motion_of(arm)
    q = np.array([motion.trajectory.value(time)[:, 0] for time in np.linspace(0, motion.duration, 5)])
    view = Fit(arm, q).view(84.0, 84.0)
    lines = drawn(frame_figure(arm, q[3], q[:4], view, "t"))
    points = view.projection.points(tool_points(arm, q))
    assert np.abs(lines["path"] - points[:4]).max() <= TOLERANCE
    assert np.abs(lines["path"][-1] - points[4]).max() > 1e-3  # the negative control


def test_a_gif_shows_the_whole_motion_and_repeats_byte_for_byte(tmp_path: Path) -> None:
    arm = load_arm("planar_2r")
    motion = make_motion(arm, np.array([0.0, 0.5]), np.array([0.1, 0.6]))
    one, other = (write_film(arm, tmp_path / name, motion=motion) for name in ("one.gif", "other.gif"))
    assert one.read_bytes() == other.read_bytes()
    pictures = list(frames(arm, motion=motion))
    assert len(pictures) == round(motion.duration * RATE) + 1
    assert not np.array_equal(pictures[0], pictures[-1])
    with Image.open(one) as film:
        assert film.n_frames == len(pictures)
        assert film.convert("RGB").getpixel((0, 0)) == (255, 255, 255)


def test_a_page_is_self_contained_and_repeats_byte_for_byte(tmp_path: Path) -> None:
    arm = load_arm("planar_2r")
    one, other = (write_film(arm, tmp_path / name) for name in ("one.html", "other.html"))
    page = one.read_text(encoding="utf-8")
    assert page == other.read_text(encoding="utf-8")
    assert 1_000_000 < len(page) < 8_000_000
    assert not re.search(r"<(?:script|link)[^>]+(?:src|href)=[\"']https?:", page)


def test_an_mp4_is_written_or_says_what_it_needs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    arm = load_arm("planar_2r")
    motion = make_motion(arm, np.array([0.0, 0.5]), np.array([0.2, 0.6]))
    if shutil.which("ffmpeg"):
        assert write_film(arm, tmp_path / "film.mp4", motion=motion).read_bytes()[4:8] == b"ftyp"
    monkeypatch.setenv("PATH", "")
    with pytest.raises(FigureError, match=r"an MP4 needs ffmpeg"):
        write_film(arm, tmp_path / "none.mp4", motion=motion)
    assert not (tmp_path / "none.mp4").exists()


def test_bad_input_is_named(tmp_path: Path) -> None:
    arm, table = load_arm("planar_2r"), load_arm(TABLE)
    with pytest.raises(FigureError, match=r"written as gif, mp4, html, not as avi"):
        write_film(arm, tmp_path / "film.avi")
    with pytest.raises(LanguageError, match=r"no language 'de'"):
        write_film(arm, tmp_path / "film.gif", "de")
    with pytest.raises(ModelError, match=r"has no shape"):
        write_film(table, tmp_path / "film.html")
    assert "no shape" in str(film_reason(table, "html")) and film_reason(table, "gif") is None
    assert set(FILMS) == {"gif", "mp4", "html"}
    blocked = tmp_path / "file"
    blocked.write_text("")
    with pytest.raises(FigureError, match=r"cannot be written"):
        write_film(arm, blocked / "film.html")


def test_the_command_writes_films_beside_figures_and_leaves_out_what_an_arm_has_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(films, "RATE", 4)  # which files there are is asked here, not what they show
    (delivery,) = produce([Order("planar_2r", "planar_2r", ("quintic",))], ("png", "gif", "html"), "fr", tmp_path, 1)
    assert not delivery.problems
    names = {file.name for file in delivery.files}
    assert names == {"planar_2r-quintic-fr.png", "planar_2r-motion-fr.gif", "planar_2r-motion-fr.html"}
    (delivery,) = produce([Order(TABLE, "table", ())], ("gif", "html"), "en", tmp_path, 1)
    assert [file.name for file in delivery.files] == ["table-motion.gif"] and not delivery.problems
