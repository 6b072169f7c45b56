"""Where joints have stops, what leaves out a posture may leave out none that they reach."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.hearing import formulas_of, words_of
from armproof.verification.document.joint_limits import limits_joints
from armproof.verification.verdict import Verdict

LIMITING = [
    r"The mechanical stops let $\theta_3$ run from $-160^\circ$ to $160^\circ$.",
    r"As the elbow cannot fold back completely ($|q_2| \le 140^\circ$), this gives",
    r"Le coude ne se plie que d'un côté : $\theta_2 \in [0, \pi]$.",
    r"L'axe 5 a pour butées $\pm 110°$.",
    r"We have $-\frac{3\pi}{4} \le \theta_2 \le \frac{3\pi}{4}$.",
    "Die Anschläge erlauben mehr nicht.",
]
NOT_LIMITING = [
    "The robot has no joint limits.",
    r"The solution has $\theta_2 \in (-\pi, \pi]$.",
    r"The angles are $-180^\circ < \theta_2 \le 180^\circ$.",
    "The range of the Jacobian is its image.",
    "In the limit of small angles",
    "The inverse does not turn out well.",
]
ARM = "$$ x = l_1 c_1 + l_2 c_{12}, \\quad y = l_1 s_1 + l_2 s_{12} $$\n\n$$ \\det J = l_1 l_2 s_2 $$\n\n%s\n\n$$ \\det J = 0 \\iff \\theta_2 = %s $$\n"
TABLE = "| i | a | alpha | d | theta | %s |\n|---|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $\\theta_1$ | 170° |\n| 2 | $l_2$ | 0 | 0 | $\\theta_2$ | 150° |\n\n$$ \\det J = l_1 l_2 s_2 $$\n\n$$ \\det J = 0 \\iff \\theta_2 = %s $$\n"


@pytest.mark.parametrize(("text", "limits"), [*((e, True) for e in LIMITING), *((e, False) for e in NOT_LIMITING)])
def test_what_limits_joints_is_heard(text: str, limits: bool) -> None:
    assert limits_joints(words_of(text), formulas_of(text)) is limits


@pytest.mark.parametrize(
    ("page", "said", "angle", "verdict"),
    [
        (ARM, "The stops let the elbow bend to $150^\\circ$.", "0", Verdict.UNCHECKED),
        (ARM, "The stops let the elbow bend to $150^\\circ$.", "\\frac{\\pi}{2}", Verdict.REFUTED),
        (ARM, "The elbow turns all round.", "0", Verdict.REFUTED),
        (TABLE, "range", "0", Verdict.UNCHECKED),
        (TABLE, "butées", "0", Verdict.UNCHECKED),
        (TABLE, "speed", "0", Verdict.REFUTED),
        (TABLE, "range", "\\frac{\\pi}{2}", Verdict.REFUTED),
    ],
)
def test_a_posture_left_out_may_lie_beyond_the_stops(page: str, said: str, angle: str, verdict: Verdict) -> None:
    assert verify_text(page % (said, angle)).equations[-1].verdict is verdict
