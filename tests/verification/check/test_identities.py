"""An equation that holds whatever its one name is confirms nothing of what defines that."""

from __future__ import annotations

from armproof.verification.check import verify_text

HEAD = r"""# Shoulder angle

$$ \alpha = \arctan\frac{c}{e} $$

$$ \theta_1 = \alpha + \varphi $$

"""


def verdict_of_definition(display: str) -> str:
    """Return what becomes of θ_1 = α + φ before a display."""
    return verify_text(f"{HEAD}$$ {display} $$\n").equations[1].verdict.value


def test_an_identity_of_one_angle_clears_no_definition_of_it():
    assert verdict_of_definition(r"\sin\theta_1 = \pm\sqrt{1 - \cos^2\theta_1}") == "unchecked"
    assert verdict_of_definition(r"\sin^2\theta_1 + \cos^2\theta_1 = 1") == "unchecked"


def test_an_equation_that_rests_on_the_definition_does():
    assert verdict_of_definition(r"\theta_1 - \alpha = \varphi") == "defined"
    assert verdict_of_definition(r"\sin(\theta_1 - \varphi) = \sin\alpha") == "defined"
