"""What a name means: the front matter first, then the displays before, the arm, and common notation."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from armproof.models.catalogue import load_arm
from armproof.verification.check import load_arm_of
from armproof.verification.document import Document
from armproof.verification.errors import DocumentError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.reading import name_key, read_names
from armproof.verification.verdict import Record, Verdict
from tests.verification.conftest import check_displays

Judge = Callable[..., Record]


# -- scalars -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arm", "key", "symbol"),
    [
        ("scara", "theta_1", "theta_1"),
        ("scara", "q_3", "d_3"),  # q counts joints, whatever they are called
        ("scara", "theta_3", None),  # joint 3 slides
        ("scara", "a_2", "a_2"),
        ("scara", "a_3", None),
        ("scara", "q_5", None),
        ("scara_modified", "q_2", "theta_2"),  # theta_2 and d_2 share an index: the angle has it
        ("polar_rp", "q_1", "theta"),
        ("polar_rp", "q_2", "r"),
        ("spherical_wrist", "q_4", "theta_4"),  # by the index of the symbol, not by the place
        ("spherical_wrist", "theta_6", "theta_6"),
        ("kr210", "d_G", "d_G"),
    ],
)
def test_symbols_are_found_by_name_then_by_joint_index(arm: str, key: str, symbol: str | None) -> None:
    assert read_names(load_arm(arm), {}).known_symbol(key) == symbol


def test_the_documents_letters_are_the_models_by_the_front_matter(judge: Judge) -> None:
    symbols = {"l_1": "a_1", "L": "a_2", r"\beta_2": "theta_2"}
    latex = r"p_2 = \begin{bmatrix} l_1 c_1 + L\cos(\theta_1 + \beta_2) \\ l_1 s_1 + L\sin(\theta_1 + \beta_2) \\ 0 \end{bmatrix}"
    assert judge(latex, symbols=symbols).verdict is Verdict.PROVED
    swapped = judge(latex, symbols={**symbols, "l_1": "a_2", "L": "a_1"})
    assert swapped.verdict is Verdict.REFUTED


def test_a_free_letter_stands_for_any_value(judge: Judge) -> None:
    damped = r"J^T(J J^T + h^2 I)^{-1} = (J^T J + h^2 I)^{-1} J^T"
    front = {"symbols": {"h": "free"}, "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}}}
    assert judge(damped, arm="planar_2r").verdict is Verdict.UNCHECKED
    assert judge(damped, arm="planar_2r", **front).verdict is Verdict.PROVED
    assert judge(damped.replace("^{-1} J^T", "^{-1} 2J^T"), arm="planar_2r", **front).verdict is Verdict.REFUTED


def test_digits_of_an_index_are_angles_of_the_joints(workbench: Callable[..., Any]) -> None:
    names = workbench("scara", symbols={"theta_3": "theta_4"}).names
    assert [names.joint_angle(index) for index in (1, 2, 3, 4, 5)] == ["theta_1", "theta_2", "theta_4", "theta_4", None]
    assert workbench("scara").names.joint_angle(3) is None
    assert workbench(None).names.joint_angle(7) == "theta_7"


def test_letters_are_free_without_an_arm_and_beside_one_only_in_identities(judge: Judge) -> None:
    identity = r"\cos(\beta + \gamma) = \cos\beta\cos\gamma - \sin\beta\sin\gamma"
    false = identity.replace("- \\sin", "+ \\sin")
    assert judge(identity, arm=None).verdict is judge(identity).verdict is Verdict.PROVED
    assert judge(false, arm=None).verdict is Verdict.REFUTED
    record = judge(false)  # an arm's document may still say what they are
    assert (record.verdict, record.message) == (Verdict.UNCHECKED, "'beta' is not bound")


# -- what comes first ------------------------------------------------------------------------------------------------------


def test_the_front_matter_outranks_notation(judge: Judge) -> None:
    latex = r"J = \begin{bmatrix} -a_1 s_1 \\ a_1 c_1 \\ 0 \end{bmatrix}"
    assert judge(latex).verdict is Verdict.UNCHECKED  # a column is no whole Jacobian
    bound = {"J": {"jacobian": 1, "rows": [1, 2, 3], "columns": [1]}}
    assert judge(latex, quantities=bound).verdict is Verdict.PROVED


def test_notation_outranks_what_a_display_would_define(judge: Judge) -> None:
    assert judge(r"p_1 = \begin{bmatrix} 1 \\ 2 \\ 3 \end{bmatrix}").verdict is Verdict.REFUTED


def test_a_trig_letter_bound_in_the_front_matter_is_that_name(judge: Judge) -> None:
    bound = {"s_x": {"pose": 4, "component": [1, 1]}, "c": {"origin": 4, "component": "z"}}
    assert judge(r"s_x = c_{12} c_4 + s_{12} s_4", quantities=bound).verdict is Verdict.PROVED
    assert judge(r"c = -d_3 - d_4", quantities=bound).verdict is Verdict.PROVED


def test_names_of_several_letters_are_read_whole(judge: Judge) -> None:
    bound = {"MGDpos": {"origin": 4}}
    assert judge(r"MGDpos = p_4", quantities=bound).verdict is Verdict.PROVED
    assert judge(r"MGDpos = p_3", quantities=bound).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("key", "same"),
    [
        ("J(q)", "J(q)"),
        ("J'_P", "J'_{P}"),
        ("theta_12", r"\theta_{12}"),
        ("{}^0P_{1,G}", r"{}^0 P_{1,G}"),
        ("P_x", r"P_x"),
        ("T_w", r"\mathbf{T}_w"),
        (r"J_\omega", r"J_{\omega}"),
    ],
)
def test_a_name_has_one_key_however_it_is_spelt(key: str, same: str) -> None:
    reader = read_names(None, {}).reader
    assert name_key(reader, key) == name_key(reader, same)


@pytest.mark.parametrize(
    "latex", [r"\theta_1^*", r"\theta_1^\star", r"\mathrm{\theta}_1", r"{\theta_1}", r"\theta_{1}"]
)
def test_stars_fonts_and_braces_do_not_change_a_joint_variable(judge: Judge, latex: str) -> None:
    assert judge(rf"\cos({latex}) = c_1").verdict is Verdict.PROVED
    assert judge(rf"\cos({latex}) = c_2").verdict is Verdict.REFUTED


@pytest.mark.parametrize("cosine", [r"\cos\theta_1", r"\cos(\theta_1)", r"c_1", r"C_1", r"c_{1}", r"C1", r"c1", r"C\theta_1", r"C(\theta_1)", r"c_{\theta_1}", r"\mathrm{c}_1"])  # fmt: skip
def test_a_cosine_may_be_written_in_every_usual_way(judge: Judge, cosine: str) -> None:
    assert judge(rf"{cosine} = \sin(\theta_1 + \frac{{\pi}}{{2}})").verdict is Verdict.PROVED
    assert judge(rf"{cosine} = \sin\theta_1").verdict is Verdict.REFUTED


# -- refusals --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("front", "message"),
    [
        ({"symbols": ["l_1"]}, "'symbols' must be a mapping from names to meanings"),
        ({"symbols": {"l_1": 3}}, "symbol 'l_1' must be bound to a symbol of the arm, not 3"),
        (
            {"symbols": {"l_1": "b_9"}},
            "the arm 'scara' has no 'b_9'; it has theta_1, theta_2, d_3, theta_4, a_1, a_2, d_4",
        ),
        ({"symbols": {"a_1": "free"}}, "symbol 'a_1' is one of the arm 'scara': it cannot be free"),
        ({"quantities": 7}, "'quantities' must be a mapping from names to meanings, not 7"),
        ({"transforms": "left"}, "'transforms' must be upper or lower, not 'left'"),
        ({"quantities": {"1 + x": {"origin": 3}}}, "'1 \\+ x' is not a name; write it as in the displays"),
        ({"quantities": {"x_{": {"origin": 3}}}, "'x_{' is not a name"),
    ],
)
def test_a_front_matter_that_means_nothing_is_refused(front: dict[str, Any], message: str) -> None:
    with pytest.raises(DocumentError, match=message):
        read_names(load_arm("scara"), front)


def test_a_sign_is_a_name_that_nothing_else_gives_a_meaning() -> None:
    names = read_names(load_arm("planar_2r"), {"quantities": {"p": {"origin": 2}}})
    assert names.defines_sign("sigma") and names.defines_sign("u")
    assert not any(names.defines_sign(key) for key in ("p", "l_1", "theta_1"))
    names.define("u", lambda algebra: algebra.symbol("l_1"))
    assert not names.defines_sign("u")


@pytest.mark.parametrize(
    ("name", "free"),
    [("n_x", True), (r"\operatorname{ab}_x", False), ("a_1", True), ("R_12", False), ("{}^0n_x", False)],
)
def test_without_an_arm_a_letter_with_indices_is_free(name: str, free: bool) -> None:
    read = Reader().read_expression(name)
    assert isinstance(read, n.Name)
    assert read_names(None, {}).is_free(read) is free
    assert not read_names(load_arm("planar_2r"), {}).is_free(read)


@pytest.mark.parametrize("frame", ["7", "9"])
def test_a_frame_that_the_arm_lacks_is_told(frame: str) -> None:
    record = check_displays(rf"{{}}^0T_{frame} = I", arm="planar_2r").equations[0]
    assert record.message == f"no frame '{frame}' on arm 'planar_2r'; its frames are 0, 1, 2"
    assert "no frame" not in check_displays(rf"{{}}^0W_{frame} = I", arm="planar_2r").equations[0].message


@pytest.mark.parametrize(("index", "joint"), [(1, "theta_1"), (2, "d_4"), (4, "d_4"), (3, None)])
def test_an_index_is_that_of_the_joints_symbol_or_its_place(index: int, joint: str | None) -> None:
    row = {"a": 0, "alpha": 0}
    rows = [{**row, "d": 0, "theta": "theta_1"}, {**row, "d": "d_4", "theta": 0}]
    arm = load_arm_of(Document(Path("page.md"), {"arm": {"dh": "classic", "rows": rows}}, (), ()))
    assert read_names(arm, {}).known_symbol(f"q_{index}") == joint
