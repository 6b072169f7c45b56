"""Tasks of lesson 16, proofreading a handout: a sheet on the planar 2R arm with planted errors, then any sheet."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from markupsafe import Markup

from armproof.course.feedback import (
    Choice,
    Derivation,
    Formula,
    Lesson,
    Line,
    Number,
    Quantity,
    Task,
    WithSympy,
    Wrong,
    picked,
)
from armproof.course.feedback.answer import is_missing
from armproof.course.feedback.notebook import Shown, render
from armproof.course.links import shift, turn
from armproof.models.errors import written
from armproof.models.language import look_up

ARM = "planar_2r"
_JACOBIAN = {"jacobian": 2, "rows": [1, 2]}
_ANGLES = ("theta_1", "theta_2", "l_1", "l_2")


class Report:
    """What `armproof verify` prints on a sheet."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __repr__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return render(
            "block.html", "open", content=Markup('<pre style="white-space:pre-wrap">{}</pre>').format(self.text)
        )


def show_sheet(text: str) -> Shown:
    """Return a sheet as a notebook typesets it, without its front matter."""
    parts = text.lstrip().split("---", 2)
    return Shown(parts[2].strip() if len(parts) == 3 and not parts[0].strip() else text)


def proofread(text: str, after: Any = True) -> Any:
    """Return the verdicts on a sheet, as `armproof verify` prints them, or a polite sentence.

    Args:
        text: a document in Markdown with its front matter.
        after: an answer that has to be there first.
    """
    if is_missing(after):
        return Shown(look_up("First find the wrong displays by hand; the tool answers when you have."))
    from armproof.models.errors import ArmproofError
    from armproof.verification.check import verify
    from armproof.verification.report.text import describe_document

    file = Path("sheet.md")
    try:
        with TemporaryDirectory(prefix="armproof-sheet-") as folder:
            file = Path(folder) / file.name
            file.write_text(str(text), encoding="utf-8")
            lines = describe_document(verify(file), strict=False)
            told = "\n".join("".join(words for words, _ in line) for line in lines)
            return Report(told.replace(str(file), "sheet.md"))
    except (ArmproofError, OSError) as problem:
        return Shown(
            written("The sheet cannot be checked: {reason}", reason=str(problem).replace(str(file), "sheet.md"))
        )


def jacobian(q, l_1, l_2):
    """Return the 2×2 Jacobian of the position, the derivatives of X and Y."""
    s1, c1 = np.sin(q[0]), np.cos(q[0])
    s12, c12 = np.sin(q[0] + q[1]), np.cos(q[0] + q[1])
    return np.array([[-l_1 * s1 - l_2 * s12, -l_2 * s12], [l_1 * c1 + l_2 * c12, l_2 * c12]])


def transform(q, l_2):
    """Return the pose of frame 2 in frame 1."""
    s, c = np.sin(q[1]), np.cos(q[1])
    return np.array([[c, -s, 0, l_2 * c], [s, c, 0, l_2 * s], [0, 0, 1, 0], [0, 0, 0, 1]])


def distance(theta_2, l_1, l_2):
    """Return X² + Y², by the law of cosines."""
    return l_1**2 + l_2**2 + 2 * l_1 * l_2 * np.cos(theta_2)


def inverse(theta_1, theta_2, l_1, l_2):
    """Return the inverse of the Jacobian."""
    s1, c1 = np.sin(theta_1), np.cos(theta_1)
    s12, c12 = np.sin(theta_1 + theta_2), np.cos(theta_1 + theta_2)
    adjugate = np.array([[l_2 * c12, l_2 * s12], [-l_1 * c1 - l_2 * c12, -l_1 * s1 - l_2 * s12]])
    return adjugate / (l_1 * l_2 * np.sin(theta_2))


def _inverse_by_numpy(theta_1, theta_2, l_1, l_2):
    return np.linalg.inv(jacobian((theta_1, theta_2), l_1, l_2))


def _jacobian_with_sympy(sp):
    t1, t2, l1, l2 = sp.symbols("theta_1 theta_2 l_1 l_2")
    p = sp.Matrix([l1 * sp.cos(t1) + l2 * sp.cos(t1 + t2), l1 * sp.sin(t1) + l2 * sp.sin(t1 + t2)])
    return p.jacobian([t1, t2])


def _transform_with_sympy(sp):
    t, a = sp.symbols("theta_2 l_2")
    return turn(sp, "z", t) * shift(sp, x=a)


def _distance_by_squares(theta_2, l_1, l_2):
    return (l_1 + l_2 * np.cos(theta_2)) ** 2 + (l_2 * np.sin(theta_2)) ** 2


JACOBIAN = r"\begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}"
TRANSFORM = r"""\begin{bmatrix} C_2 & -S_2 & 0 & l_2 C_2 \\ S_2 & C_2 & 0 & l_2 S_2 \\ 0 & 0 & 1 & 0 \\
0 & 0 & 0 & 1 \end{bmatrix}"""
INVERSE = r"""\frac{1}{l_1 l_2 S_2} \begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\
-l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}"""

_DISPLAYS = {
    "1": "the position p_2",
    "2": "the transform from frame 2 to frame 1",
    "3": "the squared distance",
    "4": "the Jacobian",
    "5": "its determinant",
    "6": "its inverse",
    "7": "the singular configurations",
    "8": "the x axis of frame 2",
}

# -- a sheet of one's own ------------------------------------------------------------------------------------------------

# What of a display may be printed wrongly, and whether it holds at the zero pose all the same; the usual sheet has the first.
# (6) is the same on all sheets: it is the one that equal links hide. (5) is right on the usual sheet.
SPOILED: dict[str, tuple[tuple[str, bool], ...]] = {
    "2": (
        (r"C_2 & S_2 & 0 & l_2 C_2 \\ -S_2 & C_2 & 0 & l_2 S_2", True),
        (r"C_2 & -S_2 & 0 & l_2 \\ S_2 & C_2 & 0 & 0", True),
        (r"C_2 & -S_2 & 0 & l_2 S_2 \\ S_2 & C_2 & 0 & l_2 C_2", False),
    ),
    "3": (
        (r"l_1^2 + l_2^2 + l_1 l_2 C_2 \tag{3}", False),
        (r"l_1^2 + l_2^2 - 2 l_1 l_2 C_2 \tag{3}", False),
        (r"l_1^2 + l_2^2 + 2 l_1 l_2 C_1 \tag{3}", True),
    ),
    "4": (
        (r"-l_1 S_1 - l_2 S_{12} & l_2 S_{12}", True),
        (r"-l_1 S_1 + l_2 S_{12} & -l_2 S_{12}", True),
        (r"l_1 S_1 - l_2 S_{12} & -l_2 S_{12}", True),
    ),
    "5": ((r"l_1 l_2 S_2 \tag{5}", True), (r"l_1 l_2 C_2 \tag{5}", False)),
    "8": (
        (r"C_2 \\ S_2 \\ 0 \end{bmatrix} \tag{8}", True),
        (r"-S_{12} \\ C_{12} \\ 0 \end{bmatrix} \tag{8}", False),
        (r"C_1 \\ S_1 \\ 0 \end{bmatrix} \tag{8}", True),
    ),
}


def _sheet(seed: str) -> dict[str, tuple[str, bool]]:
    """Return what the sheet of a seed prints of each display that may be spoiled."""
    return {number: picked(f"{seed}/proofread/{number}", several) for number, several in SPOILED.items()}


def _printed(seed: str) -> dict[str, str]:
    """Return what the sheet of a seed prints otherwise than the usual one, by what that prints."""
    return {SPOILED[number][0][0]: latex for number, (latex, _) in _sheet(seed).items()}


def _wrong_on(sheet: dict[str, tuple[str, bool]]) -> list[str]:
    return [number for number in "234568" if number != "5" or sheet["5"] == SPOILED["5"][1]]


def _without(numbers: list[str], number: str) -> list[str]:
    return [each for each in numbers if each != number]


def _own_wrong_displays(seed: str) -> Task:
    wrong = _wrong_on(_sheet(seed))
    more = {number: f"there is more: test ({number}) at a pose that you can draw" for number in wrong}
    fine = {number: f"({number}) is right on your sheet" for number in "1578" if number not in wrong}
    return Task(
        "wrong_displays",
        "Which displays are wrong?",
        'Give the numbers of all wrong displays of your sheet, as a list of texts such as `["1", "5"]`.',
        Choice(_DISPLAYS, frozenset(wrong), fine, more),
        (
            "Differentiate (1) and compare with (4). Draw the arm at $\\theta_1 = \\theta_2 = 90°$ for (2) and (8).",
            "Put $\\theta_2 = 0$ into (3) and (5): the stretched arm reaches $l_1 + l_2$ and is singular. Multiply (6) by the right Jacobian.",
        ),
        (wrong, ", ".join(wrong), set(wrong)),
        (
            Wrong([*wrong, "1"], "(1) is right"),
            Wrong([*wrong, "7"], "(7) is right"),
            *(Wrong(_without(wrong, number), f"test ({number}) at a pose") for number in wrong),
        ),
        own=_own_wrong_displays,
        printed=_printed(seed),
    )


def _own_zero_pose(seed: str) -> Task:
    sheet = _sheet(seed)
    wrong = _wrong_on(sheet)
    hidden = [number for number in wrong if number != "6" and sheet[number][1]]
    found = [number for number in wrong if number not in hidden]
    shows = {
        number: f"({number}) does not hold there: put the zeros into it and into its right form" for number in found
    }
    fine = {number: f"({number}) is not wrong" for number in "157" if number not in wrong}
    more = {number: f"there is more: put the zeros into ({number}) and into its right form" for number in hidden}
    return Task(
        "zero_pose",
        "The zero pose is not enough",
        "Which of the wrong displays hold at $\\theta_1 = \\theta_2 = 0$, so that a check there does not find them? Give their numbers.",
        Choice(_DISPLAYS, frozenset(hidden), shows | fine, more),
        (
            "All sines are 0 there and all cosines 1. Which errors sit beside a sine, or exchange two angles?",
            "Put the zeros into the printed and the right form of each. (6) has no value there.",
        ),
        (hidden, ",".join(hidden), set(hidden)),
        (
            *(Wrong([*hidden, number], f"({number}) does not hold there") for number in found),
            Wrong([*hidden, "1"], "(1) is not wrong"),
            Wrong([*hidden, "7"], "(7) is not wrong"),
            *(
                Wrong(_without(hidden, number), f"put the zeros into ({number})")
                for number in hidden
                if len(hidden) > 1
            ),
        ),
        own=_own_zero_pose,
        printed=_printed(seed),
    )


LESSON = Lesson(
    number=16,
    name="proofread",
    title="Proofread a handout",
    source="A sheet of our own; the first example is from document 002",
    objectives=(
        "Find wrong formulas on a sheet by hand, with checks that take seconds.",
        "Say which errors a check at one pose, or with equal links, cannot see.",
        "Run armproof on the sheet, and on one of your own, and know what it does not judge.",
    ),
    tasks=(
        Task(
            name="spot",
            title="A printed slip",
            text="One entry of the Jacobian that document 002 prints is wrong. Give its row and its column, counted from 1.",
            asks=Number((1, 2), labels=("the row", "the column")),
            hints=(
                "Column $k$ is the derivative of the position with respect to $\\theta_k$: how do the columns differ?",
                "From one column to the next, the terms of one link drop out; what stays keeps its sign.",
                "Compare the signs in the first row from left to right.",
            ),
            right=((1, 2), "1, 2", np.array([1.0, 2.0])),
            wrong=(
                Wrong((2, 1), "rows are counted downwards, columns from left to right: the row comes first", own=True),
                Wrong((2, 2), "the second row holds cosines, all of them positive: that is right", own=True),
                Wrong(
                    (1, 1),
                    "all three signs agree there, as the derivative of a sum of cosines should have it",
                    own=True,
                ),
                Wrong((0, 1), "count from 1, as on paper", own=True),
                Wrong((1, 3), "the Jacobian has two columns, one a joint", own=True),
                Wrong((3, 2), "the Jacobian has two rows, those of X and Y", own=True),
                Wrong((1, 0), "the column is counted from 1, too", own=True),
            ),
        ),
        Task(
            name="wrong_displays",
            title="Which displays are wrong?",
            text='Give the numbers of all wrong displays of the sheet, as a list of texts such as `["1", "5"]`.',
            own=_own_wrong_displays,
            asks=Choice(
                _DISPLAYS,
                right=frozenset({"2", "3", "4", "6", "8"}),
                because={
                    "1": "(1) is right: each link adds its length in the direction of the sum of the angles before it",
                    "5": "(5) is right: it follows from the Jacobian as it should be, not as it is printed in (4)",
                    "7": "(7) is right: stretched and folded",
                },
                missing={
                    "2": "there is more: turn the elbow by 90° in a drawing, and see where x_2 points",
                    "3": "there is more: how far does the stretched arm reach?",
                    "4": "there is more: take the derivative of (1)",
                    "6": "there is more: with the Jacobian as it should be, one product ought to be I",
                    "8": "there is more: both joints turn the last link",
                },
            ),
            hints=(
                "Differentiate (1) and compare with (4). Draw the arm at $\\theta_1 = \\theta_2 = 90°$ for (2) and (8).",
                "Put $\\theta_2 = 0$ into (3): the stretched arm reaches $l_1 + l_2$. Multiply (6) by the Jacobian as it should be.",
                "Five are wrong, three are right; (1) and (5) are among the right ones.",
            ),
            right=(["2", "3", "4", "6", "8"], "2, 3, 4, 6, 8", {"8", "6", "4", "3", "2"}),
            wrong=(
                Wrong(["2", "3", "4", "5", "6", "8"], "not as it is printed"),
                Wrong(["3", "4", "6", "8"], "see where x_2 points"),
                Wrong(["2", "3", "4", "6"], "both joints turn the last link"),
                Wrong(["1", "3", "4"], "(1) is right"),
                Wrong(
                    ["2", "3", "4", "8"],
                    "what you found is wrong indeed; one more error would show if the links had different lengths",
                    own=True,
                ),
            ),
        ),
        Task(
            name="zero_pose",
            title="The zero pose is not enough",
            text="Which of the wrong displays hold at $\\theta_1 = \\theta_2 = 0$, so that a check there does not find them? Give their numbers.",
            own=_own_zero_pose,
            asks=Choice(
                _DISPLAYS,
                right=frozenset({"2", "4", "8"}),
                because={
                    "3": "(3) gives l_1^2 + l_2^2 + l_1 l_2 there, and the stretched arm reaches l_1 + l_2: the check finds it",
                    "6": "at the zero pose the arm is stretched and J has no inverse: (6) does not hold there, it has no value",
                    "1": "(1) is not wrong",
                    "5": "(5) is not wrong",
                    "7": "(7) is not wrong",
                },
                missing={
                    "2": "there is more: a rotation by 0 is its own transpose",
                    "4": "there is more: the sign of a term that is 0 does not show",
                    "8": "there is more: which angles are left out does not show while all are 0",
                },
            ),
            hints=(
                "All sines are 0 there and all cosines 1. Which errors sit beside a sine, or exchange two angles?",
                "Put the zeros into the printed and the right form of each of the five.",
                "Three of the five hold; (3) does not, and (6) has no value.",
            ),
            right=(["2", "4", "8"], "2,4,8", ("8", "4", "2")),
            wrong=(
                Wrong(["2", "4"], "does not show while all are 0"),
                Wrong(["2", "3", "4", "8"], "the check finds it"),
                Wrong(["2", "4", "6", "8"], "it has no value"),
                Wrong(["4"], "its own transpose"),
                Wrong(["1", "4"], "(1) is not wrong"),
            ),
        ),
        Task(
            name="equal_links",
            title="Equal links hide one",
            text="A friend checks the sheet at random joint angles, but with $l_1 = l_2 = 1$. Which wrong display is not found?",
            asks=Choice(
                _DISPLAYS,
                right="6",
                because={
                    "2": "(2) has one length only; at random angles its error shows",
                    "3": "(3) is wrong in its last term, which numbers for the lengths do not mend",
                    "4": "(4) is wrong in a term, and that shows with any length",
                    "8": "(8) has no length at all; a random angle shows it",
                    "1": "(1) is not wrong",
                    "5": "(5) is not wrong",
                    "7": "(7) is not wrong",
                },
            ),
            hints=(
                "Look for an error that exchanges two lengths.",
                "It leaves the units as they should be.",
                "Multiply the printed $J^{-1}$ by $J$, once with different lengths and once with equal ones.",
            ),
            right=("6", ["6"], ("6",)),
            wrong=(
                Wrong("4", "shows with any length"),
                Wrong("3", "do not mend"),
                Wrong("2", "its error shows"),
                Wrong("8", "no length at all"),
                Wrong(["4", "6"], "one of them is asked for"),
            ),
        ),
        Task(
            name="jacobian",
            title="Correct (4)",
            text="Give the right Jacobian of the position $(X, Y)$, $2 \\times 2$, in frame 0. A function takes `q` and the lengths `l_1, l_2`.",
            asks=Quantity(ARM, _JACOBIAN),
            hints=(
                "Differentiate (1): it is right.",
                "The derivative of $l_2 C_{12}$ with respect to $\\theta_2$ is $-l_2 S_{12}$.",
                "Compare entry by entry: the first row of the printed matrix is wrong.",
            ),
            right=(jacobian, JACOBIAN, WithSympy(_jacobian_with_sympy)),
            wrong=(
                Wrong(JACOBIAN.replace("& -l_2 S_{12}", "& l_2 S_{12}"), "wrong sign"),
                Wrong(lambda q, l_1, l_2: jacobian(q, l_1, l_2).T, "transposed"),
                Wrong(lambda q, l_1, l_2: jacobian(q, l_2, l_1), "swapped"),
                Wrong(lambda q, l_1, l_2: jacobian((q[0], q[1] - q[0]), l_1, l_2), "absolute"),
                Wrong(lambda q, l_1, l_2: jacobian(np.deg2rad(q), l_1, l_2), "degrees"),
            ),
        ),
        Task(
            name="transform",
            title="Correct (2)",
            text="Give the right ${}^1T_2$, $4 \\times 4$: the pose of frame 2 in frame 1. A function takes `q` and the length `l_2`.",
            asks=Quantity(ARM, {"pose": 2, "in": 1}),
            hints=(
                "The columns of the rotation are the axes of frame 2, seen in frame 1.",
                "Turn $x_2$ by $\\theta_2$ from $x_1$: where does it point at $\\theta_2 = 90°$? And $y_2$?",
                "$x_2 = [C_2, S_2, 0]^T$, $y_2 = [-S_2, C_2, 0]^T$; write them as columns.",
            ),
            right=(transform, TRANSFORM, WithSympy(_transform_with_sympy)),
            wrong=(
                Wrong(
                    TRANSFORM.replace("C_2 & -S_2", "C_2 & S_2").replace("S_2 & C_2 & 0", "-S_2 & C_2 & 0"),
                    "the rotation is transposed: x_2 would turn against θ_2",
                    own=True,
                ),
                Wrong(lambda q, l_2: np.linalg.inv(transform(q, l_2)), "the inverse"),
                Wrong(
                    TRANSFORM.replace("l_2 C_2", "l_2").replace("l_2 S_2", "0"),
                    "the link is turned with the joint: its end is not at [l_2, 0]",
                    own=True,
                ),
                Wrong(
                    lambda q, l_2: transform((0, q[0] + q[1]), l_2),
                    "frame 2 in frame 1 turns with θ_2 alone",
                    own=True,
                ),
                Wrong(lambda q, l_2: transform(q, l_2)[:3, :3], "right, but only a part"),
            ),
        ),
        Task(
            name="distance",
            title="Correct (3)",
            text="Give $X^2 + Y^2$ in $\\theta_2, l_1, l_2$. A function takes `(theta_2, l_1, l_2)`.",
            asks=Formula(r"l_1^2 + l_2^2 + 2 l_1 l_2 C_2", ("theta_2", "l_1", "l_2"), arm=ARM, unit="m²"),
            hints=(
                "Put $\\theta_2 = 0$: what must it be?",
                "Square $X$ and $Y$ of (1) and add them.",
                "$(l_1 + l_2)^2$ at $\\theta_2 = 0$ has the cross term $2 l_1 l_2$.",
            ),
            derivation=Derivation(
                (
                    Line("The tool, $X$.", r"X = l_1 C_1 + l_2 C_{12}"),
                    Line("And $Y$.", r"Y = l_1 S_1 + l_2 S_{12}"),
                    Line("Square the first.", r"X^2 = l_1^2 C_1^2 + 2 l_1 l_2 C_1 C_{12} + l_2^2 C_{12}^2"),
                    Line("Square the second.", r"Y^2 = l_1^2 S_1^2 + 2 l_1 l_2 S_1 S_{12} + l_2^2 S_{12}^2"),
                    Line(
                        "Add: $C^2 + S^2 = 1$, twice.",
                        r"X^2 + Y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 (C_1 C_{12} + S_1 S_{12})",
                    ),
                    Line("The bracket is a cosine of a difference.", r"X^2 + Y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 C_2"),
                ),
                {
                    "arm": "planar_2r",
                    "quantities": {"X": {"origin": 2, "component": "x"}, "Y": {"origin": 2, "component": "y"}},
                },
            ),
            right=(
                distance,
                "l_1^2 + l_2^2 + 2 l_1 l_2 C_2",
                WithSympy(
                    lambda sp: (
                        sp.Symbol("l_1") ** 2
                        + 2 * sp.Symbol("l_1") * sp.Symbol("l_2") * sp.cos(sp.Symbol("theta_2"))
                        + sp.Symbol("l_2") ** 2
                    )
                ),
                _distance_by_squares,
            ),
            wrong=(
                Wrong(
                    "l_1^2 + l_2^2 + l_1 l_2 C_2",
                    "at θ_2 = 0 it is not the square of l_1 + l_2",
                    own=True,
                ),
                Wrong("l_1^2 + l_2^2 - 2 l_1 l_2 C_2", "sign"),
                Wrong(
                    "l_1^2 + l_2^2 + 2 l_1 l_2 S_2",
                    "at θ_2 = 0 the arm is stretched: the cross term needs the cosine",
                    own=True,
                ),
                Wrong("l_1^2 + l_2^2", "this is Pythagoras, right only where the elbow has a right angle", own=True),
                Wrong(
                    lambda theta_2, l_1, l_2: np.sqrt(distance(theta_2, l_1, l_2)),
                    "this is the distance; its square is asked for",
                    own=True,
                ),
            ),
        ),
        Task(
            name="inverse",
            title="Correct (6)",
            text="Give the right $J^{-1}$, $2 \\times 2$. A function takes `(theta_1, theta_2, l_1, l_2)`.",
            asks=Formula("J^{-1}", _ANGLES, arm=ARM, quantities={"J": _JACOBIAN}),
            hints=(
                "Invert your own Jacobian, not the printed one.",
                "Diagonal swapped, the other two with changed signs, divided by (5).",
                "The first row of the adjugate is $l_2 C_{12}$, $l_2 S_{12}$.",
            ),
            derivation=Derivation(
                (
                    Line(
                        "Your own Jacobian.",
                        r"J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}",
                    ),
                    Line(
                        "Its determinant, (5).",
                        r"\det J = l_1 l_2 S_2",
                    ),
                    Line(
                        "The adjugate: the diagonal swapped, the other two with changed signs. With $J$ it gives the determinant.",
                        r"J \begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\ -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix} = l_1 l_2 S_2 \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}",
                    ),
                    Line(
                        "Divide.",
                        r"J^{-1} = \frac{1}{l_1 l_2 S_2} \begin{bmatrix} l_2 C_{12} & l_2 S_{12} \\ -l_1 C_1 - l_2 C_{12} & -l_1 S_1 - l_2 S_{12} \end{bmatrix}",
                    ),
                ),
                {"arm": ARM, "quantities": {"J": _JACOBIAN}},
            ),
            right=(inverse, INVERSE, _inverse_by_numpy, WithSympy(lambda sp: _jacobian_with_sympy(sp).inv())),
            wrong=(
                Wrong(
                    INVERSE.replace("l_2 C_{12} & l_2 S_{12} \\", "l_1 C_{12} & l_1 S_{12} \\"),
                    "that is how the sheet prints it: with different lengths its product with J is not I",
                    own=True,
                ),
                Wrong(lambda *of: inverse(*of).T, "transposed"),
                Wrong(
                    lambda *of: inverse(*of) * of[2] * of[3] * np.sin(of[1]),
                    "still to be divided by the determinant",
                    own=True,
                ),
                Wrong(
                    lambda theta_1, theta_2, l_1, l_2: jacobian((theta_1, theta_2), l_1, l_2).T,
                    "the transpose is the inverse of a rotation, not of a Jacobian",
                    own=True,
                ),
                Wrong(
                    INVERSE.replace("-l_1 C_1 - l_2 C_{12}", "l_1 C_1 + l_2 C_{12}"),
                    "the adjugate changes the sign of both entries off the diagonal: one has kept its own",
                    own=True,
                ),
            ),
        ),
        Task(
            name="blind",
            title="What is not judged",
            text="Which errors of a sheet can armproof not find? Choose all of `lengths` (two lengths exchanged), `prose` (a false sentence between the "
            "formulas), `name` (a display that introduces a name, and gives it another value than the author means), `sign` (a sign wrong at few angles only), `picture` (a figure "
            "with a wrong axis).",
            asks=Choice(
                {
                    "lengths": "two lengths exchanged",
                    "prose": "a false sentence",
                    "name": "a new name with another value than meant",
                    "sign": "a sign wrong at few angles only",
                    "picture": "a figure with a wrong axis",
                },
                right=frozenset({"prose", "name", "picture"}),
                because={
                    "lengths": "lengths stay symbols in a proof: exchanging two of them is found whatever their values",
                    "sign": "a proof is for all joint values, not for a sample: no angle is left out",
                },
                missing={
                    "prose": "there is more: does it read what stands between the formulas?",
                    "name": "there is more: one kind of display is taken at its word",
                    "picture": "there is more: a sheet holds other things than text and formulas",
                },
            ),
            hints=(
                "It reads the displays and the tables, and compares them with the arm that the sheet names.",
                "What does it read that is no formula? What does it take your word for?",
                "Two of the five are formulas, and a proof settles those; the other three are yours to check.",
            ),
            right=(["prose", "name", "picture"], "picture, prose, name", ("name", "picture", "prose")),
            wrong=(
                Wrong(["prose", "picture"], "taken at its word"),
                Wrong(["prose", "name"], "other things than text and formulas"),
                Wrong(["lengths", "prose"], "lengths stay symbols"),
                Wrong(["sign", "prose", "name", "picture"], "no angle is left out"),
                Wrong(["name", "picture"], "between the formulas"),
            ),
        ),
        Task(
            name="transfer",
            title="Transfer: an arm that you have not seen",
            text="A carriage slides by $d$, on it a bar of length $b$ turns by $\\theta$. A sheet says: `1`: $X = d + b\\cos\\theta$, $Y = b\\sin\\theta$; `2`: $J ="
            " \\begin{bmatrix} 1 & -b\\sin\\theta \\\\ 0 & b\\cos\\theta \\end{bmatrix}$ for the rates $[\\dot d, \\dot\\theta]^T$; `3`: $\\det J = b\\sin\\theta$; `4`:"
            " $X^2 + Y^2 = d^2 + b^2 + 2 d b\\sin\\theta$; `5`: $J^{-1} = \\begin{bmatrix} 1 & \\tan\\theta \\\\ 0 & \\frac{1}{b\\cos\\theta} \\end{bmatrix}$; `6`: $J$ is singular"
            " at $\\theta = \\pi/2$. Which displays are wrong? Give a list.",
            asks=Choice(
                {
                    "1": "the position",
                    "2": "the Jacobian",
                    "3": "its determinant",
                    "4": "the square of the distance",
                    "5": "the inverse",
                    "6": "the singular configuration",
                },
                right=frozenset({"3", "4"}),
                because={
                    "1": "display 1 is right: the bar's end is b away from the carriage, in the direction θ",
                    "2": "display 2 is right: its columns are the derivatives of display 1 by d and by θ",
                    "5": "display 5 is right: multiply it by display 2",
                    "6": "display 6 is right: across the rails, both joints move the end along x only",
                },
                missing={
                    "3": "there is more: work out the determinant of display 2",
                    "4": "there is more: put θ = 0 into display 4, with the bar along the rails",
                },
            ),
            hints=(
                "Each display follows from the one before: derive, multiply, put in a simple configuration.",
                "Put $\\theta = 0$ into all of them: the end is $d + b$ away, and $J$ is $\\begin{bmatrix} 1 & 0 \\\\ 0 & b \\end{bmatrix}$.",
            ),
            right=(["3", "4"], "3, 4", {"4", "3"}),
            wrong=(
                Wrong(["3"], "put θ = 0 into display 4"),
                Wrong(["4"], "work out the determinant"),
                Wrong(["3", "4", "6"], "both joints move the end along x only"),
                Wrong(["2", "4"], "the derivatives of display 1"),
                Wrong(["4", "5"], "multiply it by display 2"),
            ),
        ),
    ),
)
