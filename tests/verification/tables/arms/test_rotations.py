"""A wrist of which a document prints the rotations between its frames alone."""

from __future__ import annotations

from armproof.verification.check import verify_text

LINKS = [
    r"$$ {}^3R_4 = \begin{bmatrix} c_4 & 0 & -s_4 \\ s_4 & 0 & c_4 \\ 0 & -1 & 0 \end{bmatrix} $$",
    r"$$ {}^4R_5 = \begin{bmatrix} c_5 & 0 & s_5 \\ s_5 & 0 & -c_5 \\ 0 & 1 & 0 \end{bmatrix} $$",
    r"$$ {}^5R_6 = \begin{bmatrix} c_6 & -s_6 & 0 \\ s_6 & c_6 & 0 \\ 0 & 0 & 1 \end{bmatrix} $$",
]
WHOLE = r"$$ {}^3R_6 = \begin{bmatrix} c_4 c_5 c_6 - s_4 s_6 & -c_4 c_5 s_6 - s_4 c_6 & c_4 s_5 \\ s_4 c_5 c_6 + c_4 s_6 & -s_4 c_5 s_6 + c_4 c_6 & s_4 s_5 \\ -s_5 c_6 & s_5 s_6 & c_5 \end{bmatrix} $$"


def verdicts(*displays: str) -> list[str]:
    return [record.verdict.value for record in verify_text("\n".join(displays)).equations]


def test_their_product_is_decided() -> None:
    assert verdicts(*LINKS, WHOLE) == ["proved"] * 4
    assert verdicts(*LINKS, WHOLE.replace("s_4 s_5", "s_4 c_5"))[-1] == "refuted"


def test_what_is_the_link_of_no_joint_gives_no_arm() -> None:
    turned = r"$$ {}^0R_1 = \begin{bmatrix} c_\phi & -s_\phi & 0 \\ s_\phi & c_\phi & 0 \\ 0 & 0 & 1 \end{bmatrix} $$"
    about_y = r"$$ {}^1R_2 = \begin{bmatrix} c_\theta & 0 & s_\theta \\ 0 & 1 & 0 \\ -s_\theta & 0 & c_\theta \end{bmatrix} $$"
    assert not verify_text("\n".join((turned, about_y))).arms


def test_a_link_with_a_slip_gives_no_arm() -> None:
    assert not verify_text("\n".join((LINKS[0].replace("0 & -1 & 0", "0 & 1 & 0"), *LINKS[1:]))).arms
