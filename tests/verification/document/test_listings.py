"""Values of code are those that it has given last."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.listings import assigned_in, assignments
from armproof.verification.verdict import Verdict

PAGE = """```python
l1 = 0.6
l2 = 0.2
theta1 = 0.5
theta2 = 1.2
```

$$ x = l_1 c_1 + l_2 c_{12}, \\quad y = l_1 s_1 + l_2 s_{12} $$

%s

$$ \\det J = %s $$
"""


def test_code_gives_what_stands_before_its_signs_of_equality() -> None:
    code = "l1 = 0.3\nl2 *= 2\ntheta1, theta2 = solve(l3=1)\nif q1 == 2: pass\n"
    assert assigned_in(code) == {"l_{1}", "l_{2}", "\\theta_{1}", "\\theta_{2}"}
    assert assignments(code) == ("l_{1} = 0.3",)


@pytest.mark.parametrize(
    ("anew", "before", "now"),
    [
        ("", Verdict.CONFIRMED, Verdict.UNCHECKED),
        ("```python\nl1 = 0.7\n```", Verdict.UNCHECKED, Verdict.CONFIRMED),
        ("```python\nl1 *= 2\n```", Verdict.UNCHECKED, Verdict.UNCHECKED),
        ("```python\nsteps = 20\n```", Verdict.CONFIRMED, Verdict.UNCHECKED),
        ("Now both links are half as long.", Verdict.UNCHECKED, Verdict.UNCHECKED),
    ],
)
def test_a_value_that_code_gives_anew_is_the_one_before_no_longer(anew: str, before: Verdict, now: Verdict) -> None:
    verdicts = [verify_text(PAGE % (anew, number)).equations[-1].verdict for number in ("0.1118", "0.1305")]
    assert verdicts == [before, now]
