"""Write PGF for LaTeX without LaTeX: matplotlib asks a running LaTeX for the size of each text; here Agg measures them."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TextIO

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.backends.backend_mixed import MixedModeRenderer
from matplotlib.backends.backend_pgf import RendererPgf
from matplotlib.figure import Figure
from PIL import Image

_HEAD = """\
%% A picture for LaTeX: \\input{{{name}}} where \\usepackage{{pgf}} is in the preamble.
\\begingroup%
\\makeatletter%
\\begin{{pgfpicture}}%
\\pgfpathrectangle{{\\pgfpointorigin}}{{\\pgfqpoint{{{width:f}in}}{{{height:f}in}}}}%
\\pgfusepath{{use as bounding box, clip}}%
"""
_FOOT = """\
\\end{pgfpicture}%
\\makeatother%
\\endgroup%
"""


class _Renderer(RendererPgf):
    """Measures texts with matplotlib's own mathematics."""

    def __init__(self, figure: Figure, stream: TextIO) -> None:
        super().__init__(figure, stream)
        self._measure = RendererAgg(1, 1, figure.dpi)

    def get_text_width_height_descent(self, s: str, prop: Any, ismath: Any) -> tuple[float, float, float]:
        """Return the size of a text in display units."""
        return self._measure.get_text_width_height_descent(s, prop, ismath)

    def draw_image(self, gc: Any, x: float, y: float, im: np.ndarray, transform: Any = None) -> None:
        """Write an image as a PNG file beside the picture, and put it in by a command that pgf itself has."""
        path = Path(self.fh.name)
        name = f"{path.stem}-img{self.image_counter}.png"
        self.image_counter += 1
        Image.fromarray(im[::-1]).save(path.parent / name)
        inch = 1 / self.dpi
        width, height = im.shape[1] * inch, im.shape[0] * inch
        shift = f"\\pgfsys@transformshift{{{x * inch:f}in}}{{{y * inch:f}in}}"
        if transform is not None:
            a, b, c, d, e, f = transform.frozen().to_values()
            shift = f"\\pgfsys@transformcm{{{a * inch:f}}}{{{b * inch:f}}}{{{c * inch:f}}}{{{d * inch:f}}}"
            shift += f"{{{(e + x) * inch:f}in}}{{{(f + y) * inch:f}in}}"
            width = height = 1.0  # the transform holds the size
        self.fh.write("\\begin{pgfscope}%\n")
        self._print_pgf_clip(gc)
        size = f"interpolate={str(transform is None).lower()},width={width:f}in,height={height:f}in"
        self.fh.write(f"{shift}%\n\\pgftext[left,bottom]{{\\pgfimage[{size}]{{{name}}}}}%\n\\end{{pgfscope}}%\n")


def write_pgf(figure: Figure, path: Path) -> None:
    """Write a figure as a pgfpicture; images in it as PNG files beside it, in the same folder."""
    width, height = (float(side) for side in figure.get_size_inches())
    with path.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(_HEAD.format(name=path.name, width=width, height=height))
        renderer = _Renderer(figure, stream)
        figure.draw(MixedModeRenderer(figure, width, height, figure.dpi, renderer))
        stream.write(_FOOT)
