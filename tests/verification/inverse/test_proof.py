"""A closed-form inverse is proved as a whole: FK(IK(x)) = x on every branch, and no solution left out."""

from collections.abc import Callable
from typing import Any

import pytest

from armproof.course.inverse import inverse_of
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.ring import Ring
from armproof.verification.inverse.completeness import ConfigurationRoots, OpenSign
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.inverse.substitution import returns_target, target_of_a_configuration
from armproof.verification.verdict import Record, Verdict

BRANCHES = {"planar_2r": 2, "planar_3r": 2, "polar_rp": 2, "spatial_rrr": 4, "spherical_wrist": 2, "rx90": 8, "scara_column": 2}  # fmt: skip
TWO_LINKS = {
    "dh": "classic",
    "rows": [
        {"a": "l_1", "alpha": 0, "d": 0, "theta": "theta_1"},
        {"a": "l_2", "alpha": 0, "d": 0, "theta": "theta_2"},
    ],
}
XY = {"X": {"origin": 2, "component": "x"}, "Y": {"origin": 2, "component": "y"}}
D = r"D = \frac{X^2 + Y^2 - l_1^2 - l_2^2}{2 l_1 l_2}"
ELBOW = r"\theta_2 = \pm \arccos D"
K = r"k_1 = l_1 + l_2 \cos\theta_2, \quad k_2 = l_2 \sin\theta_2"
SHOULDER = r"\theta_1 = \operatorname{atan2}(Y, X) - \operatorname{atan2}(k_2, k_1)"
SIGN = r"\sigma_1 = \pm 1"

Solve = Callable[..., Record]


@pytest.fixture(scope="session")
def solve(check: Callable[..., Any]) -> Solve:
    """Return a function: displays → the record of the inverse of the two-link arm that they derive."""

    def whole(
        *displays: str, arm: Any = TWO_LINKS, quantities: Any = XY, transforms: str = "upper", **inverse: Any
    ) -> Record:
        claim = {"target": ["X", "Y"], **inverse}
        record = check(*displays, arm=arm, quantities=quantities, transforms=transforms, inverse=claim).inverse
        assert record is not None
        return record

    return whole


@pytest.mark.parametrize("name", sorted(BRANCHES))
def test_every_inverse_of_the_course_is_proved_on_all_branches(name: str) -> None:
    inverse = inverse_of(name)
    proof = inverse.proof
    assert proof.verdict is Verdict.PROVED and proof.sound and proof.complete, proof.message
    assert len(inverse.branches) == len(proof.branches) == BRANCHES[name]
    assert proof.samples == 1000 and proof.max_error is not None and proof.max_error < 1e-12


@pytest.mark.parametrize("name", ["planar_2r", "polar_rp", "spherical_wrist", "scara_column"])
def test_it_is_proved_from_the_target_of_a_configuration_as_well(name: str) -> None:
    derivation = inverse_of(name).derivation
    roots = SubstitutionRoots(Ring(), inverse_of(name).arm.lengths)
    assert returns_target(derivation, target_of_a_configuration, dict.fromkeys(derivation.signs, 0), roots) == []


# -- notations of the same solution -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "displays",
    [
        (D, ELBOW, K, SHOULDER),
        (ELBOW.replace("D", rf"\left( {D[4:]} \right)"), K, SHOULDER),
        (D, r"c_2 = D, \quad s_2 = \pm \sqrt{1 - D^2}", r"\theta_2 = \operatorname{atan2}(s_2, c_2)", K, SHOULDER),
        (D, r"\theta_2 = \operatorname{atan2}(\pm\sqrt{1 - D^2}, D)", K, SHOULDER),
        (D, r"t = \pm \sqrt{\frac{1 - D}{1 + D}}", r"\theta_2 = 2 \arctan t", K, SHOULDER),
        (D, SIGN, r"\theta_2 = \sigma_1 \arccos D", K, SHOULDER),
        (D, r"\sigma_1 \in \{-1, 1\}", r"\theta_2 = \sigma_1 \arccos D", K, SHOULDER),
        (D, SIGN, r"\theta_2 = \sigma_1 \arccos D",
         r"\theta_1 = \operatorname{atan2}(Y, X) - \sigma_1 \operatorname{atan2}(l_2\sqrt{1 - D^2}, l_1 + l_2 D)"),
        (D, ELBOW, K, r"\theta_1 = \operatorname{atan2}(k_1 Y - k_2 X, k_1 X + k_2 Y)"),
        (r"\cos\theta_2 = D", D, ELBOW, K, SHOULDER),
        (K, SHOULDER, r"X^2 + Y^2 = (l_1 + l_2)^2 \iff \theta_2 = 0", D, ELBOW),
        (r"\begin{bmatrix} k_1 \\ k_2 \end{bmatrix} = \begin{bmatrix} l_1 + l_2 \cos\theta_2 \\ l_2 \sin\theta_2 \end{bmatrix}",
         D, ELBOW, SHOULDER),
    ],
)  # fmt: skip
def test_the_same_solution_is_proved_in_any_notation(solve: Solve, displays: tuple[str, ...]) -> None:
    record = solve(*displays)
    assert record.verdict is Verdict.PROVED, record.message
    assert "on each of 2 branches" in record.message and "no other solutions" in record.message


def test_displays_with_a_named_sign_are_proved(check: Callable[..., Any]) -> None:
    records = check(D, SIGN, r"\theta_2 = \sigma_1 \arccos D", arm=TWO_LINKS, quantities=XY).equations
    assert [record.verdict for record in records] == [Verdict.DEFINED, Verdict.DEFINED, Verdict.PROVED]


def test_a_wrong_display_with_a_named_sign_is_refuted(check: Callable[..., Any]) -> None:
    shown, wrong = r"2 l_1 l_2 D = X^2 + Y^2 - l_1^2 - l_2^2", r"\theta_2 = \sigma_1 \arccos (2D)"
    assert check(D, shown, SIGN, wrong, arm=TWO_LINKS, quantities=XY).equations[-1].verdict is Verdict.REFUTED


def test_an_erratum_is_no_step(check: Callable[..., Any]) -> None:
    wrong = r"\theta_1 = \operatorname{atan2}(X, Y) - \operatorname{atan2}(k_2, k_1)"
    claim = {"target": ["X", "Y"]}
    result = check(D, ELBOW, K, SHOULDER, errata=(wrong,), arm=TWO_LINKS, quantities=XY, inverse=claim)
    assert result.passed and result.inverse.verdict is Verdict.PROVED


# J. J. Craig, Introduction to Robotics, section 4.7: the PUMA 560 in closed form, the flipped wrist as a sign.
PUMA = {
    "dh": "modified",
    "rows": [
        {"a": 0, "alpha": 0, "d": 0, "theta": "theta_1"},
        {"a": 0, "alpha": "-pi/2", "d": 0, "theta": "theta_2"},
        {"a": "a_2", "alpha": 0, "d": "d_3", "theta": "theta_3"},
        {"a": "a_3", "alpha": "-pi/2", "d": "d_4", "theta": "theta_4"},
        {"a": 0, "alpha": "pi/2", "d": 0, "theta": "theta_5"},
        {"a": 0, "alpha": "-pi/2", "d": 0, "theta": "theta_6"},
    ],
}
PUMA_STEPS = [
    r"{}^0_6T = \begin{bmatrix} r_{11} & r_{12} & r_{13} & p_x \\ r_{21} & r_{22} & r_{23} & p_y \\"
    r" r_{31} & r_{32} & r_{33} & p_z \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) - \operatorname{Atan2}(d_3, \pm\sqrt{p_x^2 + p_y^2 - d_3^2})",
    r"K = \frac{p_x^2 + p_y^2 + p_z^2 - a_2^2 - a_3^2 - d_3^2 - d_4^2}{2 a_2}",
    r"\theta_3 = \operatorname{Atan2}(a_3, d_4) - \operatorname{Atan2}(K, \pm\sqrt{a_3^2 + d_4^2 - K^2})",
    r"\theta_{23} = \operatorname{Atan2}[(-a_3 - a_2 c_3) p_z - (c_1 p_x + s_1 p_y)(d_4 - a_2 s_3),"
    r" (a_2 s_3 - d_4) p_z + (a_3 + a_2 c_3)(c_1 p_x + s_1 p_y)]",
    r"\theta_2 = \theta_{23} - \theta_3",
    r"\sigma = \pm 1",
    r"\theta_4 = \operatorname{Atan2}(\sigma(-r_{13} s_1 + r_{23} c_1),"
    r" \sigma(-r_{13} c_1 c_{23} - r_{23} s_1 c_{23} + r_{33} s_{23}))",
    r"s_5 = -r_{13}(c_1 c_{23} c_4 + s_1 s_4) - r_{23}(s_1 c_{23} c_4 - c_1 s_4) + r_{33} s_{23} c_4",
    r"c_5 = -r_{13} c_1 s_{23} - r_{23} s_1 s_{23} - r_{33} c_{23}",
    r"\theta_5 = \operatorname{Atan2}(s_5, c_5)",
    r"s_6 = -r_{11}(c_1 c_{23} s_4 - s_1 c_4) - r_{21}(s_1 c_{23} s_4 + c_1 c_4) + r_{31} s_{23} s_4",
    r"c_6 = r_{11}((c_1 c_{23} c_4 + s_1 s_4) c_5 - c_1 s_{23} s_5) +"
    r" r_{21}((s_1 c_{23} c_4 - c_1 s_4) c_5 - s_1 s_{23} s_5) - r_{31}(s_{23} c_4 c_5 + c_{23} s_5)",
    r"\theta_6 = \operatorname{Atan2}(s_6, c_6)",
]


def test_a_solution_from_a_textbook_is_proved_as_printed(solve: Solve) -> None:
    record = solve(*PUMA_STEPS, arm=PUMA, quantities={}, target={"pose": 6})
    assert record.verdict is Verdict.PROVED, record.message
    assert "on each of 8 branches (theta_1, theta_3, sigma)" in record.message


@pytest.mark.parametrize(
    ("line", "old", "new"),
    [
        (2, r"\pm\sqrt", r"\sqrt"),
        (4, "(a_3, d_4)", "(d_4, a_3)"),
        (8, r"\sigma(-r_{13} c_1", r"(-r_{13} c_1"),
        (9, "+ s_1 s_4", "- s_1 s_4"),
        (13, "- c_1 s_{23} s_5", "+ c_1 s_{23} s_5"),
    ],
)
def test_a_slip_in_a_textbook_solution_is_refuted(solve: Solve, line: int, old: str, new: str) -> None:
    steps = list(PUMA_STEPS)
    assert old in steps[line - 1]
    steps[line - 1] = steps[line - 1].replace(old, new)
    assert solve(*steps, arm=PUMA, quantities={}, target={"pose": 6}).verdict is Verdict.REFUTED


def test_a_pose_with_fewer_joints_than_numbers_is_proved_for_what_the_arm_reaches(solve: Solve) -> None:
    record = solve(
        r"H_0^4 = \begin{pmatrix} n_x & o_x & a_x & p_x \\ n_y & o_y & a_y & p_y \\ n_z & o_z & a_z & p_z \\ 0 & 0 & 0 & 1 \end{pmatrix}",
        r"d_3 = d_1 - d_4 - p_z",
        r"\cos\theta_2 = \frac{p_x^2 + p_y^2 - a_1^2 - a_2^2}{2 a_1 a_2}",
        r"\sin\theta_2 = \pm\sqrt{1 - \cos^2\theta_2}",
        r"\theta_2 = \operatorname{atan2}(\sin\theta_2, \cos\theta_2)",
        r"\theta_1 = \operatorname{atan2}(p_y, p_x) - \operatorname{atan2}(a_2\sin\theta_2, a_1 + a_2\cos\theta_2)",
        r"\theta_4 = \theta_1 + \theta_2 - \operatorname{atan2}(n_y, n_x)",
        arm="scara_column",
        transforms="lower",
        quantities={},
        target={"pose": 4},
    )
    assert record.verdict is Verdict.PROVED, record.message


# -- what must be refuted ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("displays", "words"),
    [
        ((D, r"\theta_2 = \arccos D", K, SHOULDER), "no branch gives back theta_2 (line 2)"),
        ((D, ELBOW, K, SHOULDER.replace("(Y, X)", "(X, Y)")), "is not x on any branch"),
        ((D.replace("Y^2", "Y"), ELBOW, K, SHOULDER), "no branch gives back theta_2 (line 2)"),
        ((D, ELBOW, K, SHOULDER.replace(") -", ") +")), "is not x on any branch"),
        ((D, ELBOW, K, SHOULDER.replace("k_2, k_1", "k_1, k_2")), "is not x on any branch"),
        ((D, ELBOW.replace("D", "(-D)"), K, SHOULDER), "no branch gives back theta_2 (line 2)"),
        ((D, ELBOW, K.replace("l_2 \\sin", "l_1 \\sin"), SHOULDER), "no branch gives back theta_1 (line 4)"),
        ((D, ELBOW, K, r"\theta_1 = \arctan\frac{Y}{X} - \operatorname{atan2}(k_2, k_1)"), "no branch gives back theta_1"),
        ((D, SIGN, r"\theta_2 = \sigma_1 \arccos D", K, SHOULDER.replace("k_2, k_1", r"\sigma_1 k_2, k_1")),
         "is not x on the branch sigma_1 −"),
        ((D, ELBOW, K, SHOULDER.replace(") -", r") \mp")), "on the branch theta_2 −, theta_1 −"),
        ((D, ELBOW, r"\theta_1 = \operatorname{atan2}(Y, X) - \arctan\frac{l_2 \sin\theta_2}{l_1 + l_2 \cos\theta_2}"),
         "for the lengths of this arm only"),
    ],
)  # fmt: skip
def test_a_wrong_solution_is_refuted_by_name(solve: Solve, displays: tuple[str, ...], words: str) -> None:
    record = solve(*displays)
    assert record.verdict is Verdict.REFUTED and not record.passes
    assert words in record.message and set(record.counterexample) >= {"theta_1", "theta_2"}


def test_a_dropped_branch_is_sound_and_not_complete(solve: Solve) -> None:
    record = solve(D, r"\theta_2 = \arccos D", K, SHOULDER)
    assert "FK(IK(x)) is not x" not in record.message


def test_a_joint_without_a_step_leaves_the_inverse_unchecked(solve: Solve) -> None:
    record = solve(D, ELBOW, K)
    assert record.verdict is Verdict.UNCHECKED
    assert "no display solves for theta_1 by X, Y" in record.message


def test_a_step_that_uses_a_later_joint_is_named(solve: Solve) -> None:
    record = solve(D, ELBOW, K, SHOULDER, solve=["theta_1", "theta_2"])
    assert record.verdict is Verdict.UNCHECKED and "it uses theta_2, which is not solved before" in record.message


def test_a_name_that_is_defined_by_itself_is_no_step(solve: Solve) -> None:
    record = solve(r"\theta_2 = \pm \arccos D", "D = E + 1", "E = D - 1", K, SHOULDER)
    assert record.verdict is Verdict.UNCHECKED and "is defined by itself" in record.message


# -- roots -----------------------------------------------------------------------------------------------------------------


def test_the_root_of_a_square_keeps_both_signs_in_a_substitution() -> None:
    ring = Ring()
    sqrt = SubstitutionRoots(ring, ["l"]).sqrt
    length, other = ring.symbol("l"), ring.symbol("d")
    assert (sqrt(length * length) - length).is_zero()
    root = sqrt(other * other)
    assert not (root - other).is_zero() and not (root + other).is_zero() and (root * root - other * other).is_zero()


def test_a_root_is_found_behind_its_normal_form() -> None:
    ring = Ring()
    rule = ConfigurationRoots(ring, ["a", "b"])
    (c1, s1), (_, s2) = cos_sin(ring.symbol("theta_1")), cos_sin(ring.symbol("theta_2"))
    k = ring.symbol("a") * c1 - ring.symbol("b") * (s1 + s2)
    with pytest.raises(OpenSign) as found:
        rule.sqrt(k * k)
    roots = []
    for sign in (1, -1):
        rule.signs = {found.value.factor: sign}
        roots.append(rule.sqrt(k * k))
    assert (roots[0] + roots[1]).is_zero() and (roots[0] * roots[0] - k * k).is_zero()


def test_a_root_without_a_sign_is_taken() -> None:
    ring = Ring()
    rule = ConfigurationRoots(ring, ["a", "b"])
    c, _ = cos_sin(ring.symbol("theta_1"))
    a, b = ring.symbol("a"), ring.symbol("b")
    k = a * a + b * b + 2 * a * b * c  # the square of a distance
    assert (rule.sqrt(k * k) - k).is_zero()
