"""Files: the same bytes every time, embedded fonts, a whole file or none, and no LaTeX for PGF."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.image import imread

from armproof.course.errors import FigureError
from armproof.course.figures.drawing.style import mm_axes, new_figure, styled
from armproof.course.figures.kinds.sketch import sketch
from armproof.course.figures.output.production import Order, deliver
from armproof.course.figures.output.save import FORMATS, save_figure
from armproof.models.catalogue import load_arm

ROOT = Path(__file__).resolve().parents[3]
DRAW = "from armproof.course.figures.output.production import Order, deliver; from pathlib import Path; import sys; print(deliver(Order('planar_2r', 'planar_2r', ('singular',)), {formats!r}, 'fr', Path(sys.argv[1])).problems)"


@pytest.fixture(scope="module")
def figure() -> Figure:
    return sketch(load_arm("planar_3r"))


@pytest.mark.parametrize("suffix", FORMATS)
def test_the_same_figure_gives_the_same_bytes(suffix: str, tmp_path: Path, figure: Figure) -> None:
    first = save_figure(figure, tmp_path / f"first.{suffix}").read_bytes()
    again = save_figure(sketch(load_arm("planar_3r")), tmp_path / "folder" / f"first.{suffix}").read_bytes()
    assert first == again
    other = save_figure(sketch(load_arm("planar_3r"), "fr"), tmp_path / f"other.{suffix}").read_bytes()
    assert (
        save_figure(sketch(load_arm("planar_2r")), tmp_path / f"other.{suffix}").read_bytes() != other
    )  # it can differ


def test_another_process_at_another_time_gives_the_same_bytes(tmp_path: Path) -> None:
    assert deliver(Order("planar_2r", "planar_2r", ("singular",)), FORMATS, "fr", tmp_path / "one").problems == ()
    environment = {**os.environ, "PYTHONHASHSEED": "2", "TZ": "UTC-2"}
    environment.pop("SOURCE_DATE_EPOCH", None)
    command = [sys.executable, "-c", DRAW.format(formats=FORMATS), str(tmp_path / "two")]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "()"
    names = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert len(names) == len(FORMATS) + 1
    for name in names:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes(), name


def test_a_trimmed_figure_loses_nothing_but_empty_paper(tmp_path: Path) -> None:
    figure = sketch(load_arm("scara"))
    whole, trimmed = (
        imread(save_figure(figure, tmp_path / f"{flag}.png", trimmed=flag))[..., :3] for flag in (False, True)
    )
    assert trimmed.shape[1] == whole.shape[1] and trimmed.shape[0] < whole.shape[0]
    dark = [(image.min(axis=2) < 0.5).sum() for image in (whole, trimmed)]
    assert abs(dark[0] - dark[1]) <= 0.02 * dark[0]
    assert (trimmed[0] > 0.9).all() and (trimmed[-1] > 0.9).all()


def test_fonts_are_embedded_as_outlines(tmp_path: Path, figure: Figure) -> None:
    data = save_figure(figure, tmp_path / "sketch.pdf").read_bytes()
    assert b"/FontFile2" in data
    assert b"/Type3" not in data
    svg = save_figure(figure, tmp_path / "sketch.svg").read_text(encoding="utf-8")
    assert "<text" not in svg
    assert "<dc:date>" not in svg


def test_pgf_needs_no_latex(tmp_path: Path, figure: Figure, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    text = save_figure(figure, tmp_path / "sketch.pgf").read_text(encoding="utf-8")
    assert r"\begin{pgfpicture}" in text
    assert r"\theta_2" in text
    assert str(tmp_path) not in text


@styled()
def image_figure() -> Figure:
    figure = new_figure("column", 40)
    mm_axes(figure, 10, 10, 60, 25).imshow(np.arange(12).reshape(3, 4))
    return figure


def test_images_of_a_pgf_stand_beside_it(tmp_path: Path) -> None:
    path = save_figure(image_figure(), tmp_path / "map.pgf")
    images = [part.name for part in tmp_path.iterdir() if part.suffix == ".png"]
    assert images == ["map-img0.png"]
    assert images[0] in path.read_text(encoding="utf-8")


def test_a_file_that_cannot_be_drawn_leaves_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "old.pdf"
    path.write_bytes(b"old")
    broken = new_figure("column", 30)
    monkeypatch.setattr(broken, "savefig", lambda *_, **__: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        save_figure(broken, path)
    assert path.read_bytes() == b"old"
    assert [part.name for part in tmp_path.iterdir()] == ["old.pdf"]


@pytest.mark.parametrize("name", ["figure.gif", "figure"])
def test_unknown_formats_are_refused(name: str, tmp_path: Path, figure: Figure) -> None:
    with pytest.raises(FigureError, match="pdf, svg, png, pgf"):
        save_figure(figure, tmp_path / name)


def test_a_folder_that_cannot_be_written_is_told(tmp_path: Path, figure: Figure) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FigureError, match="cannot be written"):
        save_figure(figure, tmp_path / "file" / "figure.pdf")
