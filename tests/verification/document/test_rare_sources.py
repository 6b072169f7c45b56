"""What stands rarely in a source: every display is found at its line all the same, and keeps its verdict."""

from __future__ import annotations

import pytest

from armproof import verify_text

TEX = "% ---\n% arm: planar_2r\n% ---\n"
PERCENT = "# %% [markdown]\n# ---\n# arm: planar_2r\n# ---\n\n"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.tex", TEX + r"\newcommand{\by}{\cdot}" + "\n$$ l_1 \\by c_1 = l_1 c_1 $$\n$$ l_1 \\by c_1 = l_1 s_1 $$\n"),
        ("a.tex", TEX + r"\newcommand{\by}{\cdot" + "\n$$ l_1 c_1 = l_1 c_1 $$\n$$ l_1 c_1 = l_1 s_1 $$\n"),  # never closed
        ("a.tex", TEX + r"\newcommand{\by}[1]{\cdot#1}" + "\n$$ l_1 \\by{c_1} = l_1 c_1 $$\n$$ l_1 \\by{c_1} = l_1 s_1 $$\n"),
        ("a.rst", ":arm: planar_2r\n\n.. math::\n   c_1 = c_1\n\n   c_1 = s_1\n"),
        ("a.py", PERCENT + "# %% [markdown]\n\n\n# $$ c_1 = c_1 $$\n#\n# $$ c_1 = s_1 $$\n"),
        ("a.py", PERCENT + "# %% [markdown] tags=[1,]\n# $$ c_1 = c_1 $$\n\n# %% [markdown]\n# $$ c_1 = s_1 $$\n"),
    ],
)  # fmt: skip
def test_a_rare_source_hides_no_display(name: str, text: str) -> None:
    records = verify_text(text, path=name).equations
    assert [record.verdict.value for record in records] == ["proved", "refuted"]
    rows = text.split("\n")
    assert ["= " in rows[record.line - 1] or "math" in rows[record.line - 1] for record in records] == [True, True]
