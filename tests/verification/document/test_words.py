"""What words say of the displays around them: names and shorthands, denials, hypotheses, other points."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.document import Display, parse_document
from armproof.verification.document.denials import denied_in
from armproof.verification.document.in_words import said_in_words

SHORTHANDS = [
    (r"$c_{12}$ stands for $\cos(\theta_1)$", r"c_{12} = \cos(\theta_1)"),
    (r"$s_{23}$ means the product $s_2 s_3$", "s_{23} = s_2 s_3"),
    (r"$s_2 s_3$ is written $s_{23}$", "s_{23} = s_2 s_3"),
    (r"$c_2 c_3$ est noté $c_{23}$", "c_{23} = c_2 c_3"),
    (r"$c_1$ is the sine of $\theta_1$", r"c_1 = \sin(\theta_1)"),
    (r"$D$ denotes $x^2$", "D = x^2"),
    (r"\(c_i\) désigne \(\sin q_i\)", r"c_i = \sin q_i"),
    (r":math:`c_1` means :math:`\sin q_1`", r"c_1 = \sin q_1"),
    (r"$s_i$ and $c_i$ denote $\cos q_i$ and $\sin q_i$", r"s_i = \cos q_i, c_i = \sin q_i"),
    (r"$\cos q_1$ is written $c_1$", r"c_1 = \cos q_1"),
    (r"$c_1$ and $\cos q_2$ differ", None),
    (r"$x$ is $y$", None),
    (r"$x$ for $y$", None),
]
TEX = "\\documentclass{article}\n\\begin{document}\n%s\n\\end{document}\n"


@pytest.mark.parametrize(("text", "equation"), SHORTHANDS)
def test_words_between_two_formulas_make_an_equation(text: str, equation: str | None) -> None:
    assert said_in_words(text, 0) == equation


def test_what_is_written_for_another_is_that() -> None:
    text = r"We write $c_1$ for $\sin q_1$, and denote $\cos q_2$ by $c_2$."
    assert said_in_words(text, text.index("$c_1")) == r"c_1 = \sin q_1"
    assert said_in_words(text, text.index(r"$\cos")) == r"c_2 = \cos q_2"


def displays(text: str, name: str = "sheet.md") -> tuple[Display, ...]:
    return parse_document(Path(name), TEX % text if name.endswith("tex") else text).displays


@pytest.mark.parametrize("name", ["sheet.md", "sheet.tex"])
@pytest.mark.parametrize(
    ("text", "denied"),
    [
        ("It is not true that\n\n$$ a = b $$", True),
        ("$$ a = b $$\n\nThis is wrong.", True),
        ("The claim that\n\n$$ a = b $$\n\nest fausse.", True),
        ("$$ a = b $$\n\nThis fails where $s = 0$.", False),
        ("The first guess was wrong. We have\n\n$$ a = b $$", False),
        ("$$ a = b $$\n\nThis is impossible if $a > 1$.", False),
        ("$$ a = b $$\n\nThis is not so, nobody doubts it.", True),  # "not … doubt" would deny nothing
        ("$$ a = b $$\n\nNobody doubts that this is so.", False),
        ("$$ a = b $$\n\nThis does not hold in a new frame.", True),
        ("$$ a = b $$\n\nThis is not new.", False),
        ("$$ a = b $$\n\nThis must not be forgotten.", False),
        ("$$ a = b $$\n\nA sign was forgotten.", True),
        ("By no means\n\n$$ a = b $$", True),
        ("Viele denken, es gelte\n\n$$ a = b $$", True),
        ("İleri kinematik denklemleri şöyledir:\n\n$$ a = b $$", False),  # "the equations are"
        ("By no means easily we find\n\n$$ a = b $$", False),
    ],
)
def test_a_display_is_denied_by_the_text_beside_it(text: str, denied: bool, name: str) -> None:
    (display,) = displays(text, name)
    assert display.denied is denied


def test_a_display_denies_itself() -> None:
    assert denied_in(r"a = b \tag{wrong}")
    assert denied_in(r"\cancel{a = b}")
    assert denied_in(r"\underset{\text{wrong}}{a = b}")
    assert denied_in(r"a = \underbrace{b}_{\textbf{false!}}")
    assert not denied_in(r"a = b \tag{3.1}")
    assert not denied_in(r"a = \underbrace{b}_{\text{not trivial}}")


@pytest.mark.parametrize("name", ["sheet.md", "sheet.tex"])
@pytest.mark.parametrize(
    ("text", "supposed"),
    [
        ("Suppose that\n\n$$ a = b $$", True),
        ("If only joint 2 moves,\n\n$$ a = b $$", True),
        ("$$ a = b $$\n\nto first order.", True),
        ("We suppose that the links are rigid. Then\n\n$$ a = b $$", False),
        ("If we add both, we find\n\n$$ a = b $$", False),
        ("$$ a = b $$\n\nIf the arm moves, nothing changes.", False),
    ],
)
def test_a_display_is_supposed_by_the_words_beside_it(text: str, supposed: bool, name: str) -> None:
    (display,) = displays(text, name)
    assert display.supposed is supposed


def test_a_display_is_of_the_point_that_the_sentence_before_names() -> None:
    one, other = displays("The elbow is at\n\n$$ x = a $$\n\nThe elbow is up. The tip is at\n\n$$ x = b $$")
    assert one.of_other_point
    assert not other.of_other_point


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("\\[ a = b \\]\nThe choice $c = 0$ is impossible.", "sheet.tex"),
        (".. math:: a = b\n\nSo the choice of 0\nis impossible.\n", "sheet.rst"),
    ],
)
def test_what_goes_on_from_a_text_denies_no_display(text: str, name: str) -> None:
    (display,) = displays(text, name)
    assert not display.denied


def test_a_text_right_behind_a_display_denies_it_in_rst() -> None:
    (display,) = displays(".. math:: a = b\n\nThis is wrong.\n", "sheet.rst")
    assert display.denied


@pytest.mark.parametrize(
    ("text", "posture"),
    [
        (r"with the elbow at $90^\circ$", r"\text{there: elbow at}"),
        (r"le coude fait un angle de \(90^\circ\)", r"\text{coude fait un angle de}"),
        (r"with the elbow at $90$", None),
        (r"the joint axes are at $90^\circ$", None),
    ],
)
def test_an_angle_in_degrees_at_which_a_joint_stands_is_a_posture(text: str, posture: str | None) -> None:
    assert said_in_words(text, text.index("$" if "$" in text else "\\(")) == posture


@pytest.mark.parametrize(
    ("sentence", "harmless"),
    [
        ("The x-axis points down.", "The x-axis points along the first link."),
        ("The arm is mounted upside down.", "The arm is mounted on a table."),
        ("The arm hangs from the ceiling.", "The arm reaches for the ceiling."),
        ("The origin is at the tip of link 1.", "The origin of the base is at joint 1."),
        (r"$\dot\theta_2$ is the speed of the motor.", "The aim is to control the speed of the motor."),
        ("The second angle is absolute.", "The second angle is relative."),
        ("We number the joints from the hand.", "We number the joints from the base."),
        (r"$\theta_2$ is the interior angle at the elbow.", r"$\theta_2$ is the angle at the elbow."),
        (r"The angle $\theta_2$ is zero when the arm is folded.", r"The determinant is zero when the arm is folded."),
        ("$l_2$ is the total length.", "$l_1 + l_2$ is the total length."),
        ("$l_2$ is measured from the shoulder.", "$l_2$ is measured from joint to joint."),
    ],
)  # fmt: skip
def test_what_a_letter_or_a_place_is_otherwise_is_heard_where_the_text_says_it(sentence: str, harmless: str) -> None:
    page = "---\narm: planar_2r\n---\n{}\n\n$$ x = l_1 c_1 + l_2 c_{{12}} $$\n"
    found = [check_document(parse_document(Path("a.md"), page.format(each))).equations for each in (sentence, harmless)]
    assert [record.verdict.value for (record,) in found] == ["unchecked", "proved"]


@pytest.mark.parametrize(
    ("text", "name", "denied"),
    [
        ("~~$$ a = b $$~~", "sheet.md", True),
        ("a~~sum:\n\\[ a = b \\]\nand~~more", "sheet.tex", False),  # blanks
        ("<del>\n\n$$ a = b $$\n\n</del>", "sheet.md", True),
        ("<del>text</del>\n\n$$ a = b $$", "sheet.md", False),
        ("::: {.danger} Wrong\n$$ a = b $$\n:::", "sheet.md", True),
        ("::: {.tip} Not hard\n$$ a = b $$\n:::", "sheet.md", False),
        ('<div class="wrong">\n\n$$ a = b $$\n\n</div>', "sheet.md", True),
        ("<details><summary>A wrong solution</summary>\n\n$$ a = b $$\n\n</details>", "sheet.md", True),
        ("<details><summary>Solution</summary>\n\n$$ a = b $$\n\n</details>", "sheet.md", False),
        ("\\begin{wrong}\\[ a = b \\]\\end{wrong}", "sheet.tex", True),
        ("\\begin{proof}[A wrong one]\n\\[ a = b \\]\n\\end{proof}", "sheet.tex", True),
        ("\\begin{proof}[A short one]\n\\[ a = b \\]\n\\end{proof}", "sheet.tex", False),
        ("\\begin{conjecture}\nOf us.\n\\end{conjecture}\n\\[ a = b \\]", "sheet.tex", False),
        ("# Common mistakes\n\n## First\n\n$$ a = b $$", "sheet.md", True),
        ("# Common mistakes\n\n## What is right\n\n$$ a = b $$", "sheet.md", False),
        ("$$ a = b $$\n\nThe arm has two links. The formula above is wrong.", "sheet.md", True),
        ("$$ a = b $$\n\nThe arm has two links. The formula below is wrong.", "sheet.md", False),
    ],
)
def test_what_is_struck_out_or_in_a_box_that_says_so_is_denied(text: str, name: str, denied: bool) -> None:
    (display,) = displays(text, name)
    assert display.denied is denied


@pytest.mark.parametrize(
    ("heading", "is_below"),
    [("# Tool", False), ("## Tool", True), ("Tool\n====", False), ("Tool\n----", False)],
)
def test_what_a_sentence_says_of_a_point_holds_below_its_heading_alone(heading: str, is_below: bool) -> None:
    [display] = displays(f"# Elbow\n\nLet $P$ be the midpoint of the second link.\n\n{heading}\n\n$$ x = l_1 c_1 $$\n")
    assert display.of_other_point is is_below
