"""The base and the tool of an arm whose document prints their transforms beside its links."""

from __future__ import annotations

from armproof.verification.check import verify_text
from armproof.verification.verdict import DocumentResult


def matrix(*rows: str) -> str:
    return r"\begin{bmatrix} " + r" \\ ".join((*rows, "0 & 0 & 0 & 1")) + r" \end{bmatrix}"


def shift(x: str = "0", y: str = "0", z: str = "0") -> str:
    return matrix(f"1 & 0 & 0 & {x}", f"0 & 1 & 0 & {y}", f"0 & 0 & 1 & {z}")


def planar(angle: str, x: str, y: str) -> str:
    return matrix(f"c_{angle} & -s_{angle} & 0 & {x}", f"s_{angle} & c_{angle} & 0 & {y}", "0 & 0 & 1 & 0")


LINKS = {f"{{}}^{k - 1}T_{k}": planar(str(k), f"l_{k} c_{k}", f"l_{k} s_{k}") for k in (1, 2)}
WHOLE = {"{}^0T_2": planar("{12}", "l_1 c_1 + l_2 c_{12}", "l_1 s_1 + l_2 s_{12}")}


def verdicts(*displays: dict[str, str]) -> list[str]:
    return [record.verdict.value for record in result(*displays).equations]


def result(*displays: dict[str, str]) -> DocumentResult:
    return verify_text("\n\n".join(f"$$ {name} = {value} $$" for each in displays for name, value in each.items()))


def test_coordinates_behind_a_tool_are_those_of_its_frame() -> None:
    tool = {"{}^2T_G": shift("g")}
    right = {"x_G": "l_1 c_1 + (l_2 + g) c_{12}", "y_G": "l_1 s_1 + (l_2 + g) s_{12}"}
    assert verdicts(LINKS, tool, WHOLE, right) == ["proved"] * 6
    wrong = {**right, "y_G": "l_1 s_1 + (l_2 - g) s_{12}"}
    assert verdicts(LINKS, tool, WHOLE, wrong)[-1] == "refuted"


def test_coordinates_in_a_base_are_seen_from_its_frame() -> None:
    base = {"{}^BT_0": shift("b", z="h")}
    right = {
        "{}^BT_2": planar("{12}", "b + l_1 c_1 + l_2 c_{12}", "l_1 s_1 + l_2 s_{12}").replace("1 & 0 \\", "1 & h \\")
    }
    assert verdicts(base, LINKS, WHOLE, right) == ["proved"] * 5
    wrong = {"{}^BT_2": right["{}^BT_2"].replace("& h", "& -h")}
    assert verdicts(base, LINKS, WHOLE, wrong)[-1] == "refuted"


def test_a_tool_that_nothing_speaks_of_is_none_of_the_arm() -> None:
    [arm] = result(LINKS, {"{}^2T_G": shift("g")}, WHOLE).arms
    assert "frames" not in arm.front["arm"]


def test_a_transform_that_moves_is_no_base() -> None:
    moving = {"{}^BT_0": planar("5", "0", "0")}
    assert "refuted" not in verdicts(moving, LINKS, WHOLE, {"x": "l_1 c_1 + l_2 c_{12}"})


def test_a_base_may_be_turned() -> None:
    base = {"{}^WT_0": matrix("0 & -1 & 0 & b", "1 & 0 & 0 & e", "0 & 0 & 1 & h")}
    seen = {
        "{}^WT_2": matrix(
            "-s_{12} & -c_{12} & 0 & b - l_1 s_1 - l_2 s_{12}",
            "c_{12} & -s_{12} & 0 & e + l_1 c_1 + l_2 c_{12}",
            "0 & 0 & 1 & h",
        )
    }
    entries = [r"-l_1 c_1 - l_2 c_{12} & -l_2 c_{12}", r"-l_1 s_1 - l_2 s_{12} & -l_2 s_{12}"]
    jacobian = {"J": r"\begin{bmatrix} " + r" \\ ".join(entries) + r" \end{bmatrix}"}
    assert verdicts(base, LINKS, WHOLE, seen, jacobian) == ["proved"] * 6
    wrong = {"J": jacobian["J"].replace("-l_2 s_{12} \\end", "l_2 s_{12} \\end")}
    assert verdicts(base, LINKS, WHOLE, seen, wrong)[-1] == "refuted"
