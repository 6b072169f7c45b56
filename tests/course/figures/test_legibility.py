"""Every figure of every arm in both languages can be read: no text overlaps another, leaves the page or is too small.

Of each kind the French figure is drawn, whose words are longer; the sketch, and all in a sweep, in both languages.
"""

import pytest

from armproof.course.figures.registry import KINDS, caption_kind, draw_kind, find_kind
from armproof.models.arm import Arm
from armproof.models.language import languages
from tests.course.figures.legibility import illegible
from tests.laws import SWEEP


@pytest.mark.parametrize("kind", KINDS)
def test_every_figure_can_be_read(arm: Arm, kind: str) -> None:
    found = find_kind(kind)
    reason = found.applies(arm, "en")
    if reason is not None and not found.empty:
        pytest.skip(str(reason))
    for lang in languages() if SWEEP or kind == "sketch" else ("fr",):
        assert illegible(draw_kind(found, arm, lang)) == ()
        caption = caption_kind(found, arm, lang)
        assert caption.count("$") % 2 == 0
        assert "nan" not in caption
