"""Tables of screw axes are read as the display that would say the same, where the document's motions are exponentials of them."""

import pytest

from armproof.verification.check import verify_text

MOTION = r"""
$$ M = \begin{bmatrix} 1 & 0 & 0 & L_1 + L_2 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ T(\theta) = e^{TWIST1\theta_1} e^{TWIST2\theta_2} M $$

$$ T(\theta) = \begin{bmatrix} c_{12} & -s_{12} & 0 & L_1 c_1 + L_2 c_{12} \\ s_{12} & c_{12} & 0 & L_1 s_1 SIGN L_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""
TABLES = {
    "velocities": "| $i$ | $\\omega_i$ | $v_i$ |\n|---|---|---|\n| 1 | (0, 0, 1) | (0, 0, 0) |\n| 2 | $(0, 0, 1)$ | (0, $-L_1$, 0) |\n",
    "points": "| Joint | $\\boldsymbol{\\omega}_i$ | $q_i$ |\n|---|---|---|\n| 1 | $[0\\ 0\\ 1]^T$ | $[0\\ 0\\ 0]^T$ |\n| 2 | $[0\\ 0\\ 1]^T$ | $[L_1\\ 0\\ 0]^T$ |\n",
    "columns": "| $\\omega$ | $v$ |\n|---|---|\n| $\\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\end{bmatrix}$ | (0, 0, 0) |\n| (0, 0, 1) | (0, -L_1, 0) |\n",
    "whole": "| i | $\\mathcal{S}_i$ |\n|---|---|\n| 1 | (0, 0, 1, 0, 0, 0) |\n| 2 | (0, 0, 1, 0, $-L_1$, 0) |\n",
}


def verdicts(table: str, twist: str, sign: str = "+") -> list[str]:
    """Return the verdicts on a page whose exponents are a twist, its index for #."""
    motion = MOTION.replace("TWIST1", twist.replace("#", "1")).replace("TWIST2", twist.replace("#", "2"))
    return [record.verdict.value for record in verify_text(table + motion.replace("SIGN", sign)).equations]


@pytest.mark.parametrize("name", TABLES)
def test_a_table_of_screws_says_what_a_display_of_them_would(name: str) -> None:
    *given, motion, pose = verdicts(TABLES[name], r"[\mathcal{S}_#]")
    assert given == ["defined", "defined"] and motion in ("defined", "proved") and pose == "proved"
    assert verdicts(TABLES[name], r"[\mathcal{S}_#]", "-")[-1] in ("refuted", "unchecked")


@pytest.mark.parametrize("name", ["velocities", "points"])
def test_a_twist_has_its_velocity_first(name: str) -> None:
    assert verdicts(TABLES[name], r"\hat\xi_#")[-1] == "proved"


@pytest.mark.parametrize(
    "table",
    [
        TABLES["velocities"].replace("(0, $-L_1$, 0)", "see text"),
        TABLES["points"].replace("\\boldsymbol{\\omega}_i", "x_i"),
        TABLES["points"].replace("[0\\ 0\\ 1]^T$ | $[L_1", "[0\\ a\\ b]^T$ | $[L_1"),
    ],
    ids=["words", "no axes", "an axis that is turned"],
)
def test_a_table_of_anything_else_says_nothing(table: str) -> None:
    assert verdicts(table, "[S_#]")[-1] == "unchecked"


def test_without_exponentials_a_table_of_velocities_is_no_display() -> None:
    assert len(verify_text(TABLES["velocities"] + "\n$$ x = 1 $$\n").equations) == 1
