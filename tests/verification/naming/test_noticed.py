"""A use counts as a witness of a definition where it would notice a slip in it."""

import pytest

from armproof import verify_text
from armproof.verification.findings import Kind
from armproof.verification.verdict import Verdict

ROTATION = r"Q = \begin{bmatrix} \cos\alpha & -\sin\alpha & 0 \\ \sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 1 \end{bmatrix}"


def first_of(*displays):
    return verify_text("\n\n".join(f"$$ {each} $$" for each in displays) + "\n").equations[0]


@pytest.mark.parametrize(
    "displays",
    [
        (ROTATION, r"Q^T Q = I"),
        (ROTATION, r"Q^{-1} = Q^T", r"\det Q = 1", r"Q Q^T = I"),
        (r"z = h + s", r"\frac{\partial z}{\partial h} = 1"),
        (r"x = r \cos\theta + e \sin\theta", r"\frac{\partial x}{\partial r} = \cos\theta"),
        (r"x = s_1 (q_2 - d_0) + l_3 \cos(\theta_1 + \theta_3)", r"\frac{\partial x}{\partial q_2} = s_1"),
    ],
)
def test_what_holds_with_a_slip_as_well_is_no_witness(displays):
    record = first_of(*displays)
    assert record.verdict is Verdict.UNCHECKED
    assert Kind.NO_WITNESS in {finding.kind for finding in record.outcomes[0].findings}


@pytest.mark.parametrize(
    "displays",
    [
        (
            ROTATION,
            r"Q^T Q = I",
            r"Q \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} = \begin{bmatrix} \cos\alpha \\ \sin\alpha \\ 0 \end{bmatrix}",
        ),
        (r"x = r \cos\theta + e \sin\theta", r"\frac{\partial x}{\partial \theta} = -r \sin\theta + e \cos\theta"),
        (r"x = r \cos\theta", r"\frac{\partial x}{\partial r} = \cos\theta"),
        (r"k = a + b \cos\theta", r"k^2 = a^2 + 2 a b \cos\theta + b^2 \cos^2\theta"),
    ],
)
def test_what_notices_each_slip_is_one(displays):
    assert first_of(*displays).verdict is Verdict.DEFINED
