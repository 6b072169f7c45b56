"""What names that handouts use may stand for, by their letters and indices alone."""

import pytest

from armproof import verify_text
from armproof.models.catalogue import arm_of, load_arm
from armproof.verification.algebra.quantity_kinds import as_front_matter, kind_of
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.conventions import applied, conventional, is_planar, is_usual


def read(latex: str) -> n.Name:
    name = Reader().read_expression(latex)
    assert isinstance(name, n.Name)
    return name


def told(latex: str, arm: str = "planar_2r", transforms: str = "upper") -> list[str]:
    found = conventional(read(latex), load_arm(arm), transforms)
    return [kind_of(quantity).tell(quantity) for quantity in found]


@pytest.mark.parametrize(
    ("latex", "likeliest"),
    [
        (r"p", "origin of frame 2 in frame 0"),
        (r"\mathbf{p}_{tool}", "origin of frame 2 in frame 0"),
        (r"p_{02}", "origin of frame 2 in frame 0"),
        (r"p_{12}", "origin of frame 2 in frame 1"),
        (r"{}^1P_2", "origin of frame 2 in frame 1"),
        (r"x_e", "origin of frame 2 in frame 0, x"),
        (r"p_{2,y}", "origin of frame 2 in frame 0, y"),
        (r"p_{y2}", "origin of frame 2 in frame 0, y"),
        (r"T_e", "pose of frame 2 in frame 0"),
        (r"R_1", "rotation of frame 1 in frame 0"),
        (r"J_{v2}", "rows 1, 2, 3 of the Jacobian of frame 2 in frame 0"),
        (r"J_{\omega 1}", "rows 4, 5, 6 of the Jacobian of frame 1 in frame 0"),
        (r"v_2", "linear velocity of frame 2 in frame 0"),
        (r"\omega", "angular velocity of frame 2 in frame 0"),
        (r"\varphi_e", "angle of frame 2 about z"),
    ],
)
def test_the_likeliest_meaning_comes_first(latex: str, likeliest: str) -> None:
    assert told(latex)[0] == likeliest


@pytest.mark.parametrize(
    "latex", [r"p'", r"k", r"K_1", r"p_7", r"J_{v7}", r"l_1", r"b_2", r"\lambda", r"x_{max}", r"R_{xy}"]
)
def test_other_names_have_no_usual_meaning(latex: str) -> None:
    assert told(latex) == []


def test_a_letter_with_several_meanings_has_them_all() -> None:
    assert told("x_2")[:2] == ["origin of frame 2 in frame 0, x", "origin of frame 2 in frame 0"]
    assert "x axis of frame 2 in frame 0" in told("x_2")
    assert told("w", "polar_rp") and told("w")[-1].startswith("manipulability")


def test_the_lower_index_may_name_the_reference() -> None:
    assert told("p^1_2")[0] == told("p_1^2", transforms="lower")[0] == "origin of frame 2 in frame 1"
    assert told("T_1^2", transforms="lower")[0] == "pose of frame 2 in frame 1"


def test_the_tool_comes_before_the_last_frame() -> None:
    assert told("p", "spatial_rrr") == ["origin of frame P in frame 0", "origin of frame 3 in frame 0"]
    assert told("p_n", "spatial_rrr") == ["origin of frame 3 in frame 0"]
    assert told("J_{vP}", "spatial_rrr")[0] == "rows 1, 2, 3 of the Jacobian of frame P in frame 0"


def test_angles_of_the_tool_are_those_of_planar_arms() -> None:
    assert is_planar(load_arm("scara")) and not is_planar(load_arm("rx90"))
    assert told(r"\varphi") and not told(r"\varphi", "rx90")


def test_functions_of_the_joints_are_direct_kinematics() -> None:
    kinds = [quantity.kind for quantity in applied(read("f"), load_arm("planar_2r"))]
    assert kinds == ["origin", "pose", "task"]
    first, second, *_ = applied(read(r"\operatorname{FK}"), load_arm("rx90"))
    assert (first.kind, second.kind) == ("origin", "pose")
    assert applied(read("g_2"), load_arm("planar_2r")) == ()


def test_common_names_are_told_from_rare_ones() -> None:
    assert all(is_usual(read(latex)) for latex in (r"p_e", r"\varphi", "T", "x_2"))
    assert not any(is_usual(read(latex)) for latex in ("t", "c", "m", "x_P"))


def test_every_usual_meaning_may_stand_in_the_front_matter() -> None:
    arm = load_arm("planar_2r")
    for latex in (r"p", r"x_e", r"T", r"J_{v2}", r"v_2", r"\omega_z", r"\varphi", r"w"):
        (first, *_) = conventional(read(latex), arm, "upper")
        assert first.kind in as_front_matter(first)


def test_the_jacobian_is_bound_by_convention_where_its_base_has_a_name_of_its_own() -> None:
    """Where the base is frame 0, notation says what J is already."""
    rows = [{"a": a, "alpha": "0", "d": "0", "theta": theta} for a, theta in (("l_1", "theta_1"), ("l_2", "theta_2"))]
    named = arm_of({"arm": {"dh": "classic", "rows": rows, "frames": ["B", "1", "2"]}})
    assert named is not None and "jacobian" in {quantity.kind for quantity in conventional(read("J"), named, "upper")}
    assert not list(conventional(read("J"), load_arm("planar_2r"), "upper"))


@pytest.mark.parametrize("arm", ["kr210", "rx90"])
def test_the_centre_of_a_wrist_is_where_the_last_joint_but_one_is(arm: str) -> None:
    assert told("WC_x", arm)[0] == told("p_{WC,x}", arm)[0] == "origin of frame 5 in frame 0, x"
    page = "---\narm: ARM\n---\n\n$$ \\theta_1 = \\operatorname{atan2}(Y, X) $$\n".replace("ARM", arm)
    for y, x, verdict in (("WC_y", "WC_x", "confirmed"), ("WC_x", "WC_y", "unchecked")):
        assert verify_text(page.replace("Y", y).replace("X", x)).equations[0].verdict == verdict
