"""`arms:` in the front matter: each section has the arm that its author gives it, and names of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.check import verify_text as verify_as
from armproof.verification.document import parse_document
from armproof.verification.errors import DocumentError
from armproof.verification.running.incremental import IncrementalChecker

FRONT = """---
arms:
  Exercise 1:
    dh: classic
    rows:
      - {a: l_1, alpha: 0, d: 0, theta: theta_1}
      - {a: l_2, alpha: 0, d: 0, theta: theta_2}
  exercise 2: {arm: scara, symbols: {b: a_2}}
---
"""
PLANAR = "$$ {}^0p_2 = \\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\\\ l_1 s_1 + l_2 s_{12} \\\\ 0 \\end{bmatrix} $$\n\n"
SCARA = "$$ {}^0p_4 = \\begin{bmatrix} a_1 c_1 + b c_{12} \\\\ a_1 s_1 + b s_{12} \\\\ -d_3 - d_4 \\end{bmatrix} $$\n\n"
BODY = f"# Sheet\n\n## Exercise 1\n\n{PLANAR}## Exercise 2: a SCARA\n\n### a)\n\n{SCARA}"


def verdicts(text: str, format: str = "") -> list[str]:
    return [record.verdict.value for record in verify_as(text, format).equations]


def test_each_section_has_its_own_arm() -> None:
    result = verify_text(FRONT + BODY)
    assert [record.verdict.value for record in result.equations] == ["proved", "proved"]
    assert [arm.name for arm in result.arms] == ["DH table", "scara"]
    assert [record.arm_index for record in result.equations] == [0, 1]


def test_what_is_wrong_there_is_refuted_and_the_arm_of_another_section_proves_nothing() -> None:
    assert verdicts(FRONT + BODY.replace("+ l_2 c", "- l_2 c")) == ["refuted", "proved"]
    assert verdicts(FRONT + BODY.replace("-d_3", "d_3")) == ["proved", "refuted"]
    exchanged = FRONT + f"## Exercise 1\n\n{SCARA}## Exercise 2\n\n{PLANAR}"
    assert not {"proved", "confirmed"} & set(verdicts(exchanged))


def test_what_stands_before_the_first_section_has_the_arm_of_the_whole() -> None:
    front = FRONT.replace("---\narms", "---\narm: planar_2r\narms")
    before = "$$ {}^0z_1 = \\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\end{bmatrix} $$\n\n"
    result = verify_text(front + before + BODY)
    assert [arm.name for arm in result.arms] == ["planar_2r", "DH table", "scara"]
    assert [record.verdict.value for record in result.equations] == ["proved"] * 3


def test_sections_of_latex_and_of_restructuredtext() -> None:
    latex = "".join(f"% {line}\n" for line in FRONT.rstrip().split("\n"))
    latex += f"\\section{{Exercise 1}}\n{PLANAR}\\section{{Exercise 2}}\n\\subsection{{a}}\n{SCARA}"
    assert verdicts(latex, "tex") == ["proved", "proved"]
    assert verdicts(latex.replace("-d_3", "d_3"), "tex") == ["proved", "refuted"]


def test_headings_are_marked_or_underlined_and_those_of_cells_are_none() -> None:
    text = FRONT.replace("\n", "\r\n") + "# One #\n\nTwo\n===\n\n~~~\n\\subsection*{Three}\nFour\n=-=\n"
    assert parse_document(Path("sheet.md"), text).headings == ((10, "One"), (12, "Two"), (16, "Three"))
    assert not parse_document(Path("sheet.md"), text.replace("arms:", "title:")).headings
    assert not parse_document(Path("sheet.py"), f"# %% [markdown]\n# {FRONT}# # One\n".replace("\n", "\n# ")).headings


@pytest.mark.parametrize(
    ("front", "message"),
    [
        (FRONT.replace("exercise 2", "Exercise 3"), "'Exercise 3' is no heading .* the headings are Sheet, Exercise 1"),
        ("---\narms: scara\n---\n", "not 'scara'"),
        (FRONT.replace("symbols", "colour"), "keys among arm, symbols"),
        (FRONT.replace("scara", "skara"), "no arm 'skara'"),
    ],
)
def test_an_arm_of_no_section_is_told(front: str, message: str) -> None:
    with pytest.raises(DocumentError, match=message):
        verify_text(front + BODY)


def test_a_number_is_not_the_beginning_of_another() -> None:
    with pytest.raises(DocumentError):
        verify_text(FRONT + BODY.replace("Exercise 1\n", "Exercise 12\n"))


def test_watching_says_what_checking_says() -> None:
    checker = IncrementalChecker(Path("sheet.md"))
    for text in (FRONT + BODY, FRONT + BODY.replace("-d_3", "d_3")):
        list(checker.update(parse_document(Path("sheet.md"), text)))
        assert checker.result is not None
        assert [each.verdict for each in checker.result.equations] == [
            each.verdict for each in verify_text(text).equations
        ]
