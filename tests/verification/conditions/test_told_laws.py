r"""What the text tells of a branch, of J, of the force and of an angle decides what is proved; its twin in other words is left as it was."""

from __future__ import annotations

import pytest

from armproof import verify_text

ARM = r"$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12} $$"
ACOS = r"$$ \theta_2 = \arccos\frac{x^2+y^2-l_1^2-l_2^2}{2 l_1 l_2} $$"
MINUS = ACOS.replace(r"\arccos", r"-\arccos")
SINE = r"$$ s_2 = -\sqrt{1 - \left(\frac{x^2+y^2-l_1^2-l_2^2}{2 l_1 l_2}\right)^2} $$"
SLIDE = r"$$ x = d_2\cos\theta_1, \quad y = d_2\sin\theta_1 $$"
RELATIVE = r"The angle $\theta_2$ is measured from the first link."
OWN = r"$$ x = l_1 \cos\theta_1 + l_2 \cos\theta_2, \quad y = l_1 \sin\theta_1 + l_2 \sin\theta_2 $$"
OWN_J = r"$$ J = \begin{bmatrix} -l_1 \sin\theta_1 & -l_2 \sin\theta_2 \\ l_1 \cos\theta_1 & l_2 \cos\theta_2 \end{bmatrix} $$"


def _last(*paragraphs: str) -> str:
    return verify_text("# A page\n\n" + "\n\n".join(paragraphs) + "\n").equations[-1].verdict.value


@pytest.mark.parametrize(
    ("paragraphs", "verdict"),
    [
        ((ARM, "The angle of the elbow is", ACOS), "confirmed"),
        ((ARM, r"Here $\theta_2$ is never positive.", ACOS), "unchecked"),
        ((ARM, r"Here $\theta_2$ is never positive.", MINUS), "confirmed"),
        ((ARM, r"Here $\theta_2$ is never negative.", ACOS), "confirmed"),
        ((ARM, r"Avec $\sin\theta_2$ négatif,", ACOS), "unchecked"),
        ((ARM, "For the left-handed posture", ACOS), "unchecked"),
        ((ARM, "The sine of the elbow is", SINE, ACOS), "unchecked"),
        ((ARM, "The sine of the elbow is", SINE, MINUS), "confirmed"),
        ((SLIDE, "Every target has a negative $x$.", r"$$ \theta_1 = \arctan\frac{y}{x} $$"), "unchecked"),
        ((SLIDE, "Every target has a negative $x$.", r"$$ \theta_1 = \arctan\frac{y}{x} + \pi $$"), "confirmed"),
        ((SLIDE, "Every target has a negative $x$.", r"$$ x = -\sqrt{d_2^2 - y^2} $$"), "confirmed"),
        ((SLIDE, "Every target has a negative $x$.", r"$$ x = \sqrt{d_2^2 - y^2} $$"), "unchecked"),
    ],
)
def test_what_holds_on_a_branch_is_compared_where_the_text_tells_one(paragraphs: tuple[str, ...], verdict: str) -> None:
    assert _last(*paragraphs) == verdict


@pytest.mark.parametrize(
    ("told", "latex", "verdict"),
    [
        (r"$J$ is a $2 \times 3$ matrix of rank 2.", r"J^+ = J^T (J J^T)^{-1}", "proved"),
        (r"$J$ is a $2 \times 3$ matrix of rank 2.", r"J^+ = (J^T J)^{-1} J^T", "unchecked"),
        (r"$J$ is a $3 \times 2$ matrix of rank 2.", r"J^+ = (J^T J)^{-1} J^T", "proved"),
        ("La jacobienne a six lignes et sept colonnes.", r"\dot q = J^{-1} \dot x", "unchecked"),
        ("La jacobienne a six lignes et six colonnes.", r"\dot q = J^{-1} \dot x", "proved"),
        ("La jacobienne a six lignes et sept colonnes.", r"\dot q = J^+ \dot x", "proved"),
        ("The rows of $J$ are those of the joints.", r"\tau = J^T F", "unchecked"),
        ("The rows of $J$ are those of the coordinates.", r"\tau = J^T F", "proved"),
        ("Here $J$ denotes the inverse Jacobian.", r"\dot x = J \dot q", "unchecked"),
        ("Here $J$ denotes the inverse Jacobian.", r"J^+ = J^T (J J^T)^{-1}", "proved"),
        (r"The matrix $J$ maps platform velocities to joint rates.", r"\dot x = J \dot q", "unchecked"),
        (r"The matrix $J$ maps joint rates to platform velocities.", r"\dot x = J \dot q", "proved"),
        ("A person pushes the hand with $F$; the motors resist with the torques", r"\tau = J^T F", "unchecked"),
        ("The rows of $J$ contain derivatives by the joints.", r"\tau = J^T F", "proved"),
        ("The hand pushes on the wall with $F$; the motors give the torques", r"\tau = J^T F", "proved"),
    ],
)
def test_a_law_is_asked_of_the_jacobian_and_the_force_that_are_told(told: str, latex: str, verdict: str) -> None:
    assert _last(told, f"$$ {latex} $$") == verdict


def test_a_printed_sum_of_both_works_is_no_slip_and_tells_the_sign() -> None:
    text = (
        "# A\n\nHere\n\n$$ \\dot x = J \\dot q $$\n\n$$ \\tau^T\\delta q + F^T\\delta x = 0 $$\n\n$$ \\tau = J^T F $$\n"
    )
    assert [each.verdict.value for each in verify_text(text).equations] == ["proved", "unchecked", "unchecked"]
    turned = text.replace("+ F", "- F")
    assert [each.verdict.value for each in verify_text(turned).equations][::2] == ["proved", "proved"]


@pytest.mark.parametrize(
    ("told", "verdict"), [(RELATIVE, "unchecked"), ("Both turns are measured from the axis.", "proved")]
)
def test_an_angle_from_the_link_before_adds_up_no_link_by_itself(told: str, verdict: str) -> None:
    assert _last(told, OWN, OWN_J) == verdict


@pytest.mark.parametrize(
    ("told", "latex", "verdict"),
    [
        (r"The height $h$ of the elbow is", r"h = l_1 \cos\theta_1", "unchecked"),
        ("We put", r"h = l_1 \cos\theta_1", "defined"),
    ],
)
def test_a_quantity_that_the_text_names_is_not_shown_by_its_derivative(told: str, latex: str, verdict: str) -> None:
    text = f"# A\n\n{ARM}\n\n{told}\n\n$$ {latex} $$\n\n$$ \\dot h = -l_1 \\sin\\theta_1 \\dot\\theta_1 $$\n"
    _, definition, rate = verify_text(text).equations
    assert definition.verdict.value == verdict
    assert rate.verdict.value == ("proved" if verdict == "defined" else "unchecked")
