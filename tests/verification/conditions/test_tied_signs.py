"""Signs of an implication belong together: what follows for the upper ones, and what for the lower ones."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.findings import Kind
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]
HALF = r"\frac{\pi}{2}"
DECIDED = """
\\theta_5 = \\pm HALF \\Rightarrow s_5 = \\pm 1 | \\theta_5 = \\pm HALF \\Rightarrow s_5 = \\mp 1
\\theta_5 = \\mp HALF \\Rightarrow s_5 = \\mp 1 | \\theta_5 = \\mp HALF \\Rightarrow s_5 = \\pm 1
s_5 = \\mp 1 \\iff \\theta_5 = \\mp HALF | s_5 = \\mp 1 \\iff \\theta_5 = \\pm HALF
s_5 = \\mp 1 \\quad \\text{if } \\theta_5 = \\mp HALF | s_5 = \\mp 1 \\quad \\text{if } \\theta_5 = \\pm HALF
\\theta_4 = \\pm HALF, \\theta_6 = \\mp HALF \\Rightarrow \\sin(\\theta_4 + \\theta_6) = 0 | \\theta_4 = \\pm HALF, \\theta_6 = \\mp HALF \\Rightarrow \\cos(\\theta_4 - \\theta_6) = 1
\\theta_4 = \\pm HALF, \\theta_6 = \\mp HALF \\Rightarrow \\cos(\\theta_4 + \\theta_6) = 1 | \\theta_4 = \\pm HALF, \\theta_6 = \\mp HALF \\Rightarrow \\sin(\\theta_4) = \\mp 1
"""
PAIRS = [line.replace("HALF", HALF).split(" | ") for line in DECIDED.strip().splitlines()]


@pytest.mark.parametrize(("right", "wrong"), PAIRS)
def test_opposite_signs_belong_together(judge: Judge, right: str, wrong: str) -> None:
    assert judge(right, arm="spherical_wrist").verdict is Verdict.PROVED
    assert judge(wrong, arm="spherical_wrist").verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("latex", "is_proved"),
    [
        (rf"\theta_5 = \pm {HALF} \Rightarrow s_5 = \pm 1", True),
        (rf"\theta_5 = \pm {HALF} \Rightarrow -s_5 = \pm 1", False),
        (rf"\theta_4 = \pm {HALF}, \theta_6 = \pm {HALF} \Rightarrow \cos(\theta_4 - \theta_6) = 1", False),
        (r"0 < \theta_5 < \pi \Rightarrow s_5 > 0", True),
        (r"0 < \theta_5 < \pi \Rightarrow \pm s_5 > 0", False),
    ],
)
def test_signs_that_may_be_chosen_each_for_itself_are_left_open(judge: Judge, latex: str, is_proved: bool) -> None:
    record = judge(latex, arm="spherical_wrist")
    assert record.verdict is (Verdict.PROVED if is_proved else Verdict.UNCHECKED)
    assert is_proved or [each.kind for each in record.findings] == [Kind.SIGNS_UNTOLD]


def test_a_sign_of_one_side_alone_is_either_of_both(judge: Judge) -> None:
    assert judge(r"c_5 = 0 \Rightarrow s_5 = \mp 1", arm="spherical_wrist").verdict is Verdict.PROVED
    assert judge(r"c_5 = 0 \Rightarrow s_5 = \mp 2", arm="spherical_wrist").verdict is Verdict.REFUTED


def test_signs_reach_over_what_stands_between(judge: Judge) -> None:
    links = rf"\theta_5 = \pm {HALF} \Rightarrow c_5 = 0 \Rightarrow s_5 = "
    assert judge(links + r"\pm 1", arm="spherical_wrist").verdict is Verdict.PROVED
    assert judge(links + r"\mp 1", arm="spherical_wrist").verdict is Verdict.UNCHECKED
    both = r"c_2 = 0 \Rightarrow s_2 = \pm 1, \det J = "
    assert judge(both + r"\pm l_1 l_2", arm="planar_2r").verdict is Verdict.PROVED
    assert judge(both + r"\mp l_1 l_2", arm="planar_2r").verdict is not Verdict.PROVED
