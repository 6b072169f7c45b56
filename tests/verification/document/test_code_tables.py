"""DH tables that stand in code: read as data, whatever the code, and never run."""

from pathlib import Path

import pytest

from armproof.verification.document import Display, parse_document
from armproof.verification.document.code_tables import code_tables

TURN = r"\frac{\pi}{2}"
ELBOW = [("R", TURN, "0", "l_{1}", r"\theta_{1}"), ("R", "0", "l_{2}", "0", r"\theta_{2}")]


def rows(code: str) -> list[list[tuple[str, ...]]]:
    return [list(table.rows) for table in code_tables([Display(1, code, opening="```")])]


@pytest.mark.parametrize(
    "code",
    [
        "r = DHRobot([RevoluteDH(d=l1, alpha=pi/2), RevoluteDH(a=l2)])",
        "A = rtb.DHLink(d=l1, alpha=np.pi/2)\nB = rtb.DHLink(a=l2)\nr = rtb.DHRobot([A, B])",
        "%matplotlib inline\nlinks = [\n  RevoluteMDH(d=self.l1, alpha=np.deg2rad(90)),\n  RevoluteMDH(a=self.l2, qlim=[0, 1])]",
        "L(1) = Link([0 l1 0 pi/2]); % first\nL(2) = Link([0 0 l2 0]);\nr = SerialLink(L);",
        "L1 = Revolute('d', l1, 'a', 0, 'alpha', pi/2);\nL2 = Revolute('d', 0, 'a', l2, 'alpha', 0);",
    ],
    ids=["call", "names", "attributes", "matlab", "words"],
)
def test_links_are_the_rows_of_a_table(code: str) -> None:
    (found,) = rows(code)
    assert found == ELBOW or found[0][1] == r"90 \cdot \frac{\pi}{180}"


@pytest.mark.parametrize(
    "code",
    [
        "# a, alpha, d, theta\ndh = [[0, pi/2, l1, q1], [l2, 0, 0, q2]]",
        "dh = [{'a': 0, 'alpha': pi/2, 'd': l1, 'theta': q1}, {'a': l2, 'alpha': 0, 'd': 0, 'theta': q2}]",
        "% theta d a alpha\nDH = [q1 l1 0 pi/2; q2 0 l2 0];",
        "s = {alpha0: pi/2, a0: 0, d1: l1, q1: q1, alpha1: 0, a1: l2, d2: 0, q2: q2}",
    ],
    ids=["comment", "words", "matlab", "dictionary"],
)
def test_rows_are_those_of_named_columns(code: str) -> None:
    (found,) = rows(code)
    assert [row[1:] for row in found] == [(TURN, "0", "l_{1}", "q_{1}"), ("0", "l_{2}", "0", "q_{2}")]


@pytest.mark.parametrize(
    "code",
    [
        "points = [[0, pi/2, l1, q1], [l2, 0, 0, q2]]",
        "# x, y, z, w\ndh = [[0, pi/2, l1, q1], [l2, 0, 0, q2]]",
        "r = DHRobot([RevoluteDH(d=f(l1)), RevoluteDH(a=l2)])",
        "r = DHRobot([RevoluteDH(a=l2)])",
        "links = [RevoluteDH(0, l1), RevoluteDH(a=l2)]",
        "(" * 5000,
        "x = [" + "[0, 0, 0, 0]," * 9000 + "]",
    ],
    ids=["unnamed", "other names", "a call", "one link", "places", "deep", "long"],
)
def test_nothing_else_is_a_table(code: str) -> None:
    assert rows(code) == []


UNNAMED = {
    "a alpha d theta": "DH = [0 pi/2 d1 q1; a2 0 0 q2];",
    "theta d a alpha": "dh_params = [q1, d1, 0, pi/2;\n  q2, 0, a2, 0]",
    "alpha a d theta": "DHtable = np.array([[pi/2, 0, d1, q1], [0, a2, 0, q2]])",
    "alpha d a theta": "dh_table = [pi/2 d1 0 q(1)\n 0 0 a2 q(2)];",
    "d theta a alpha": "self.dh = [[d1, q1, 0, np.pi/2], [0, q2, a2, 0]]",
    "row by row": "DH = zeros(2, 4);\nDH(1,:) = [0 pi/2 d1 q(1)];\nDH(2,:) = [a2, 0, 0, q(2)]; % second",
    "in degrees": "MDH = [0 90 d1 th1; a2 0 0 th2];",
}


@pytest.mark.parametrize("order", UNNAMED)
def test_columns_without_names_are_told_by_what_stands_in_them(order: str) -> None:
    (found,) = rows(UNNAMED[order])
    plain = [tuple(cell.replace("theta", "q").replace("\\q", "q") for cell in row[1:]) for row in found]
    turn = r"90 \cdot \frac{\pi}{180}" if order == "in degrees" else TURN
    assert plain == [(turn, "0", "d_{1}", "q_{1}"), ("0", "a_{2}", "0", "q_{2}")]


@pytest.mark.parametrize(
    "code",
    [
        "DH = [pi/2 0.1 0.03 q1; 0 0.2 0.15 q2];",
        "DH = [0 pi/2 l1 q1; l2 0 0 q2];",
        "points = [0 pi/2 d1 q1; a2 0 0 q2];",
        "DH = [0 0 l1 q1; 0 0 0 q2];",
        "DH = [0 0 l1 l2; l2 0 0 l1];",
        "DH = [a1 pi/2 a2 q1; a3 0 0 q2];",
        "DH = [d1 0 a1 q1; a2 pi/2 0 q2];",
        "DH = [q1 pi/2 d1 q1; q2 0 0 q2];",
        "DH = [0 pi/2 d1; a2 0 0];",
        "DH(1,:) = [0 pi/2 d1 q1];\nDH(3,:) = [a2 0 0 q2];",
        "DH = [q1 pi/2 pi/3 d1; q2 0 0 a2];",
        "% x, y, z, w\nDH = [0 pi/2 d1 q1; a2 0 0 q2];",
    ],
    ids=["numbers", "lengths", "no table's name", "no twist", "no joints", "a for d", "d for a", "twice", "three", "a row left out", "in no order", "named"],
)  # fmt: skip
def test_columns_that_nothing_tells_are_none(code: str) -> None:
    assert rows(code) == []


def test_rows_handed_to_a_toolbox_have_the_columns_of_its_manual() -> None:
    code = "dhparams = [0 pi/2 0 0;\n 0.43 0 0 0];\nsetFixedTransform(jnt1,dhparams(1,:),'dh');"
    assert rows(code) == [[("R", TURN, "0", "0", r"\theta_{1}"), ("R", "0", "0.43", "0", r"\theta_{2}")]]
    assert rows(code + "\nj = rigidBodyJoint('j2', 'prismatic');") == []
    assert rows(code.replace("'dh'", "")) == []


def test_the_line_is_that_of_the_first_link() -> None:
    code = "import x\n\nr = DHRobot([\n  RevoluteDH(a=l1),\n  RevoluteDH(a=l2)])"
    (table,) = code_tables([Display(11, code, opening="```")])
    assert table.line == 14


MATRIX = "DH = [0 pi/2 d1 q1; a2 0 0 q2];"


@pytest.mark.parametrize(
    "text",
    [f"```matlab\n{MATRIX}\n```", f"~~~text\n{MATRIX}\n~~~", f"Code:\n\n    {MATRIX}", f"Words.\n\n{MATRIX}", "L(1) = Link('d', d1, 'alpha', pi/2);\nL(2) = Link('a', a2);"],
    ids=["fence", "text", "indented", "no fence", "links"],
)  # fmt: skip
def test_code_in_markdown_is_found_with_its_fence_or_without(text: str) -> None:
    (table,) = parse_document(Path("a.md"), text + "\n").in_code
    assert [row[1:4] for row in table.rows] == [(TURN, "0", "d_{1}"), ("0", "a_{2}", "0")]


@pytest.mark.parametrize(
    "text", ["Words on Link(s) and [0 0 1 2].", "The table DH = what $x = 1$ says", "x = [0 pi/2 l1 q1; l2 0 0 q2]"]
)
def test_words_are_no_code(text: str) -> None:
    assert not parse_document(Path("a.md"), text + "\n").in_code
