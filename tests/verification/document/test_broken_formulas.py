"""Formulas that are broken over several pairs of dollars are one display, and what stands beside others is none."""

import pytest

from armproof.verification.check import verify_text
from armproof.verification.document.markdown import read_markdown
from armproof.verification.document.model import INLINE
from armproof.verification.document.sentences import PROSE

FRONT = "---\narm: planar_2r\n---\n\n"
BROKEN = {
    "a bold left side": "**$p_x =$** $l_1 c_1 {} l_2 c_{{12}}$",
    "an equals sign in the text": "$p_x$ = $l_1 c_1 {} l_2 c_{{12}}$.",
    "a sum in parts": "$p_x$ $= l_1 c_1$ ${}\\, l_2 c_{{12}}$",
    "a sign in the text": "$p_x = l_1 c_1$ {} $l_2 c_{{12}}$",
    "over two lines": "$p_x = l_1 c_1$\n${} l_2 c_{{12}}$",
    "an item": "Words:\n\n1. *$p_x$* = $l_1 \\cos\\theta_1 {} l_2 c_{{12}}$\n2. $l_1$ = $2$",
    "an item with a label": "Words:\n\n- **Abscissa:** $p_x = l_1 \\cos\\theta_1 {} l_2 c_{{12}}$\n- Length: $l_1 = 2$",
    "a line that a sentence leads to": "The abscissa of the tool is\n$p_x = l_1 c_1 {} l_2 c_{{12}}$\nin metres.",
}
NONE = ["Which can be written as: $p_x = l_1 c_1$", "- where, as is known from the lecture on arms: $p_x = l_1 c_1$", "- with $l_1$: $p_x = l_1 c_1$", "- Abscissa: $p_x = l_1 c_1$ and so on", "- $p_x$: $l_1 c_1$",
        "Words $p_x$ = $l_1 c_1$ and more", "$p_x$ of $l_1 c_1 = 1$", "- $l_1$ = $2$", "| $p_x$ = $l_1 c_1$ |\n|---|",
        "Let\n$p_x = l_1 c_1$\nbe wrong", "$p_x$ - $l_1 c_1$"]  # fmt: skip


@pytest.mark.parametrize("form", BROKEN)
def test_a_broken_formula_is_one_display_and_its_false_twin_is_refuted(form: str) -> None:
    for sign, verdict in (("+", "proved"), ("-", "refuted")):
        records = verify_text(FRONT + BROKEN[form].format(sign) + "\n").equations
        assert [record.verdict.value for record in records] == [verdict]


@pytest.mark.parametrize("text", NONE)
def test_formulas_among_words_or_beside_what_is_given_are_none(text: str) -> None:
    displays = [display for display in read_markdown(text + "\n", 1)[0] if display.latex != PROSE]
    assert {display.opening for display in displays} == {INLINE}


def test_equations_that_stand_beside_each_other_stay_apart() -> None:
    records = verify_text(FRONT + "$p_x = l_1 c_1 + l_2 c_{12}$, $p_y = l_1 s_1 - l_2 s_{12}$\n").equations
    assert [record.verdict.value for record in records] == ["proved", "refuted"]
