"""Every figure of every arm in both languages can be read: no text overlaps another, leaves the page or is too small."""

import pytest

from armproof.course.figures.registry import KINDS, caption_kind, draw_kind, figures_for, find_kind
from armproof.models.arm import Arm
from armproof.models.language import languages
from tests.course.figures.legibility import illegible


@pytest.mark.parametrize("kind", KINDS)
def test_every_figure_can_be_read(arm: Arm, kind: str) -> None:
    found = find_kind(kind)
    if found not in figures_for(arm):
        pytest.skip(str(found.applies(arm, "en")))
    for lang in languages():
        assert illegible(draw_kind(found, arm, lang)) == ()
        caption = caption_kind(found, arm, lang)
        assert caption.count("$") % 2 == 0
        assert "nan" not in caption
