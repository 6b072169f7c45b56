"""What names that handouts use may stand for, by their letters and indices alone."""

import pytest

from armproof import verify_text
from armproof.models.arm import Arm
from armproof.models.catalogue import arm_of, load_arm
from armproof.verification.algebra.quantity import Quantity
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
    for other in ("g_2", "f_2", "f^0", "f'", r"\dot f", "{}^0f", "{}_0f"):
        assert applied(read(other), load_arm("planar_2r")) == ()


def test_common_names_are_told_from_rare_ones() -> None:
    assert all(is_usual(read(latex)) for latex in (r"p_e", r"\varphi", "T", "x_2", "r_{12}", "q_{0to1}"))
    assert not any(is_usual(read(latex)) for latex in ("t", "c", "m", "x_P", "r_1", "k_{12}"))


def test_every_usual_meaning_may_stand_in_the_front_matter() -> None:
    arm = load_arm("planar_2r")
    for latex in (r"p", r"x_e", r"T", r"J_{v2}", r"v_2", r"\omega_z", r"\varphi", r"w"):
        (first, *_) = conventional(read(latex), arm, "upper")
        assert first.kind in as_front_matter(first)


def test_the_jacobian_is_bound_by_convention_where_its_base_has_a_name_of_its_own() -> None:
    """Where the base is frame 0, notation says what J is already."""
    assert "jacobian" in {quantity.kind for quantity in meanings("J", "named")}
    assert not list(conventional(read("J"), load_arm("planar_2r"), "upper"))


@pytest.mark.parametrize("arm", ["kr210", "rx90"])
def test_the_centre_of_a_wrist_is_where_the_last_joint_but_one_is(arm: str) -> None:
    assert told("WC_x", arm)[0] == told("p_{WC,x}", arm)[0] == "origin of frame 5 in frame 0, x"
    page = "---\narm: ARM\n---\n\n$$ \\theta_1 = \\operatorname{atan2}(Y, X) $$\n".replace("ARM", arm)
    for y, x, verdict in (("WC_y", "WC_x", "confirmed"), ("WC_x", "WC_y", "unchecked")):
        assert verify_text(page.replace("Y", y).replace("X", x)).equations[0].verdict == verdict


# a name  ⟶  what it may stand for: kind, frame | reference, rows × columns, and a point behind one entry
MEANINGS = {
    "planar_2r": r"""
p  ⟶  origin 2|0; task 2|0
p_1  ⟶  origin 1|0; task 1|0
p_{02}  ⟶  origin 2|0; task 2|0
p_{12}  ⟶  origin 2|1; task 2|1
p_e  ⟶  origin 2|0; task 2|0
p_{e,x}  ⟶  origin 2|0 1.
p_x  ⟶  origin 2|0 1.
p_{2y}  ⟶  origin 2|0 2.
p_{y2}  ⟶  origin 2|0 2.
p_{,x}  ⟶
x  ⟶  origin 2|0 1.; origin 2|0; task 2|0
x_1  ⟶  origin 1|0 1.; origin 1|0; task 1|0; x axis 1|0
y_e  ⟶  origin 2|0 2.; y axis 2|0
z  ⟶  origin 2|0 3.
z_1  ⟶  origin 1|0 3.; z axis 1|0
{}^1x_2  ⟶  origin 2|1 1.; origin 2|1; task 2|1; x axis 2|1
{}^1p_2  ⟶  origin 2|1; task 2|1
p_2^1  ⟶  origin 2|1; task 2|1
{}^1z_2  ⟶  origin 2|1 3.; z axis 2|1
O_2  ⟶  origin 2|0
r_{11}  ⟶  rotation 2|0 1 × 1.
r_{2,3}  ⟶  rotation 2|0 2 × 3.
r_{14}  ⟶
r_{1}  ⟶  origin 1|0
n_x  ⟶  rotation 2|0 1 × 1.
a_z  ⟶  rotation 2|0 3 × 3.
n  ⟶
T  ⟶  pose 2|0
T_1  ⟶  pose 1|0
T_{12}  ⟶  pose 2|1
{}^1T_2  ⟶  pose 2|1
{}^1_2T  ⟶  pose 2|1
T_2^1  ⟶  pose 2|1
{}^2T_e  ⟶
{}^0T_0  ⟶  pose 0|0
{}^1T  ⟶  pose 2|1
H  ⟶  pose 2|0
M  ⟶  manipulability 2|0.
g  ⟶
g_1  ⟶  pose 1|0
X_e  ⟶  origin 2|0 1.; origin 2|0; task 2|0; x axis 2|0; pose 2|0
R  ⟶  rotation 2|0
R_1  ⟶  rotation 1|0
R_{12}  ⟶  rotation 2|1
J  ⟶
J_1  ⟶  jacobian 1|0
J_v  ⟶  jacobian 2|0 123
J_{v1}  ⟶  jacobian 1|0 123
J_{\omega_1}  ⟶  jacobian 1|0 456
J_L  ⟶  jacobian 2|0 123
J_{A,1}  ⟶  jacobian 1|0 456
J_{geo}  ⟶  jacobian 2|0
J_{12}  ⟶  jacobian 2|1
{}^1J  ⟶
{}^1J_2  ⟶  jacobian 2|1
J_{v7}  ⟶
v  ⟶  velocity 2|0 123; velocity 2|0; velocity 2|0 126
v_1  ⟶  velocity 1|0 123; velocity 1|0; velocity 1|0 126
v_{2,x}  ⟶  velocity 2|0 1.
v_x  ⟶  velocity 2|0 1.
\omega  ⟶  velocity 2|0 456; velocity 2|0 6.
\omega_1  ⟶  velocity 1|0 456; velocity 1|0 6.
\omega_z  ⟶  velocity 2|0 6.
\omega_{1,y}  ⟶  velocity 1|0 5.
V  ⟶  velocity 2|0 123; velocity 2|0; velocity 2|0 126
V_x  ⟶  velocity 2|0 1.
\xi  ⟶  velocity 2|0
\xi_x  ⟶
t  ⟶  origin 2|0; velocity 2|0
{}^1v_2  ⟶  velocity 2|1 123; velocity 2|1; velocity 2|1 126
w  ⟶  velocity 2|0 456; velocity 2|0 6.; manipulability 2|0.
w_2  ⟶  velocity 2|0 456; velocity 2|0 6.
\mu  ⟶  manipulability 2|0.
\mu_1  ⟶
{}^1\mu  ⟶
\Delta  ⟶  determinant 2|0.
\Delta_1  ⟶
\varphi  ⟶  angle 2|0.
\phi_1  ⟶  angle 1|0.
{}^1\phi_2  ⟶
p_n  ⟶  origin 2|0; task 2|0
p_W  ⟶  origin 1|0; task 1|0; origin 2|0; task 2|0
p_{W,x}  ⟶  origin 1|0 1.; origin 2|0 1.
WC_x  ⟶  origin 1|0 1.; origin 2|0 1.
O_{1to2}  ⟶  1 to 2|0
T_{1to2}  ⟶  pose 2|1
p_{1to7}  ⟶
x_P  ⟶  origin 2|0 1.; origin 2|0; task 2|0; x axis 2|0
x_{max}  ⟶
p_{1ORG}  ⟶  origin 1|0; task 1|0
{}^0P_{2ORG}  ⟶  origin 2|0
p_7  ⟶
p_{1,2}  ⟶  origin 2|1; task 2|1
p_{1-2}  ⟶  origin 2|1; task 2|1
p_{x,y}  ⟶
T_0  ⟶  pose 0|0
{}^1p_1  ⟶  origin 1|1; task 1|1
c  ⟶  origin 2|0
d_1  ⟶  origin 1|0
l_1  ⟶
x_{2x}  ⟶  origin 2|0 1.
p'  ⟶
K  ⟶
{}^0_1T_2  ⟶
{}^1p^0  ⟶
""",
    "spatial_rrr": r"""
p  ⟶  origin P|0; origin 3|0
p_3  ⟶  origin 3|0
p_{3P}  ⟶  origin P|3
T  ⟶  pose P|0; pose 3|0
{}^3T_P  ⟶  pose P|3; pose 3|3
{}^3p  ⟶  origin P|3; origin 3|3
J_P  ⟶  jacobian P|0; jacobian 3|0; jacobian 3|0 123; jacobian P|0 123
v  ⟶  velocity P|0 123; velocity P|0; velocity 3|0 123; velocity 3|0
w  ⟶  velocity P|0 456; velocity P|0 6.; velocity 3|0 456; velocity 3|0 6.; manipulability 3|0.; manipulability P|0.
\varphi  ⟶
p_n  ⟶  origin 3|0
p_W  ⟶  origin 3|0; origin 2|0; origin 1|0
J_v  ⟶  jacobian 3|0 123; jacobian P|0 123
f  ⟶  origin P|0; pose P|0; origin 3|0; pose 3|0
""",
    "rx90": r"""
x  ⟶  origin 6|0 1.; origin 6|0
p_{56}  ⟶  origin 6|5
p_W  ⟶  origin 5|0; origin 6|0; origin 4|0; origin 3|0; origin 2|0; origin 1|0
p_{W,z}  ⟶  origin 5|0 3.; origin 6|0 3.; origin 4|0 3.; origin 3|0 3.; origin 2|0 3.; origin 1|0 3.
\varphi  ⟶
w  ⟶  velocity 6|0 456; velocity 6|0 6.; manipulability 6|0.
""",
    "spherical_wrist": r"""
p_6  ⟶  origin 6|3
J  ⟶
J_v  ⟶  jacobian 6|3 123
T_{36}  ⟶  pose 6|3
p_W  ⟶  origin 6|3; origin 5|3; origin 4|3
v_6  ⟶  velocity 6|3 123; velocity 6|3
""",
    "named": r"""
p  ⟶  origin 2|1; task 2|1; origin 2|B; task 2|B
T_2  ⟶  pose 2|1; pose 2|B
{}^BT_2  ⟶  pose 2|B
{}^1T_2  ⟶  pose 2|1
J  ⟶  jacobian 2|1; jacobian 2|B
J_v  ⟶  jacobian 2|1 123; jacobian 2|B 123
v_1  ⟶  velocity 1|1 123; velocity 1|1; velocity 1|1 126; velocity 1|B 123; velocity 1|B; velocity 1|B 126
p_{B2}  ⟶  origin 2|B; task 2|B
p_{12}  ⟶  origin 2|1; task 2|1
r_{12}  ⟶  rotation 2|1 1 × 2.; rotation 2|B 1 × 2.
n_x  ⟶  rotation 2|1 1 × 1.; rotation 2|B 1 × 1.
f  ⟶  origin 2|1; pose 2|1; task 2|1; origin 2|B; pose 2|B; task 2|B
""",
}


def arm_called(name: str) -> Arm:
    """Return an arm of the catalogue, or "named", whose base is called B."""
    if name != "named":
        return load_arm(name)
    rows = [{"a": a, "alpha": 0, "d": 0, "theta": theta} for a, theta in (("l_1", "theta_1"), ("l_2", "theta_2"))]
    arm = arm_of({"arm": {"dh": "classic", "rows": rows, "frames": ["B", "1", "2"]}})
    assert arm is not None
    return arm


def short(quantity: Quantity) -> str:
    """Return a quantity on half a line: "origin 2|0, x"."""
    what = {"axis": f"{quantity.along} axis", "difference": f"{quantity.start} to"}.get(quantity.kind, quantity.kind)
    parts = (quantity.rows or ()), (quantity.columns or ())
    chosen = " × ".join("".join(map(str, numbers)) for numbers in parts if numbers)
    return f"{what} {quantity.frame}|{quantity.reference}" + f" {chosen}" * bool(chosen) + "." * quantity.scalar


def meanings(latex: str, arm: str) -> tuple[Quantity, ...]:
    """Return what a name, or f as in f(q), may stand for on an arm."""
    name = Reader().read_expression(latex)
    assert isinstance(name, n.Name)
    return applied(name, arm_called(arm)) if name.base == "f" else conventional(name, arm_called(arm), "upper")


@pytest.mark.parametrize("arm", MEANINGS)
def test_a_name_may_stand_for_what_its_letter_and_indices_say(arm: str) -> None:
    for line in MEANINGS[arm].strip().splitlines():
        latex, _, expected = line.partition("⟶")
        assert "; ".join(map(short, meanings(latex, arm))) == expected.strip(), latex


WRIST = "{dh: classic, rows: [{a: a_1, alpha: pi/2, d: d_1, theta: theta_1}, {a: a_2, alpha: pi/2, d: 0, theta: theta_2}, {a: 0, alpha: 0, d: d_3, theta: theta_3}]}"


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        ("y_z = -s_2 s_3", "proved"),
        ("y_z = s_2 s_3", "refuted"),
        ("z_x = c_1 s_2", "proved"),
        ("z_x = x_z", "refuted"),
        (r"{}^1R_{2,13} = s_2", "proved"),
        (r"{}^1R_{2,13} = c_2", "unchecked"),
        (r"x_{12}^2 + y_{12}^2 = a_2^2", "proved"),
        (r"x_{12}^2 + y_{12}^2 = a_2", "unchecked"),
    ],
)
def test_the_letters_of_a_row_are_those_of_the_columns_and_two_frames_below_leave_a_power_above(
    formula: str, verdict: str
) -> None:
    pose = r"{}^0T_3 = \begin{bmatrix} x_x & y_x & z_x & p_x \\ x_y & y_y & z_y & p_y \\ x_z & y_z & z_z & p_z \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    result = verify_text(f"---\narm: {WRIST}\n---\n$$ {pose} $$\n\n$$ {formula} $$\n")
    assert result.equations[1].verdict.value == verdict, result.equations[1].message


@pytest.mark.parametrize(("size", "verdict"), [(r"\bigl| s_2 \bigr|", "confirmed"), (r"\bigl| c_2 \bigr|", "refuted")])
def test_bars_of_a_size_hold_what_stands_between_them(size: str, verdict: str) -> None:
    text = rf"---{chr(10)}arm: planar_2r{chr(10)}---{chr(10)}$$ \sqrt{{\det(J J^T)}} = l_1\,l_2\,{size} $$"
    assert verify_text(text).equations[0].verdict.value == verdict
