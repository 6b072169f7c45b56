r"""The letters that LaTeX sets by commands are those of words: what is heard in "für" is heard in f\"ur."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from armproof.verification.document.tex_accents import with_letters
from armproof.verification.verdict import Verdict

FRONT = "% ---\n% arm: planar_2r\n% ---\n"
WRITTEN = {
    r"F\"ur": "Für",
    r"r\"{u}ckw\"arts": "rückwärts",
    r"\'etape": "étape",
    r"{\'e}t{\'e}": "été",
    r"\`a la cr\^ete": "à la crête",
    r"na\"\i f, \^{\i}le": "naïf, île",
    r"gar\c{c}on": "garçon",
    r"se\~nal": "señal",
    r"gro{\ss}e, gro\ss{}": "große, groß",
}


@pytest.mark.parametrize("written", WRITTEN)
def test_the_letters_of_commands_are_read(written: str) -> None:
    assert with_letters(written) == WRITTEN[written]


@pytest.mark.parametrize("text", (r"a\\'b", r"\cos x", r"\sstyle", r"\ctext"))
def test_other_commands_are_left(text: str) -> None:
    assert with_letters(text) == text


@pytest.mark.parametrize(
    ("sentence", "wanted"),
    (
        (r"F\"ur alle Stellungen des Arms gilt f\"ur die Lage des Greifers", Verdict.PROVED),
        (r"F\"alschlich wird oft angenommen, dass", Verdict.UNCHECKED),
        (r"On a longtemps \'ecrit, \`a tort,", Verdict.UNCHECKED),
    ),
)
def test_what_a_sentence_says_is_heard_in_them(sentence: str, wanted: Verdict) -> None:
    text = f"{FRONT}\\begin{{document}}\n{sentence}\n\\[ x = l_1 c_1 + l_2 c_{{12}} \\]\n\\end{{document}}\n"
    [record] = check_document(parse_document(Path("arm.tex"), text)).equations
    assert record.verdict is wanted
