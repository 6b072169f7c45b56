"""The same display in another hand: other spellings of cosines, matrices, brackets, fractions, transforms."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from fractions import Fraction

from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation
from tests.mutation.place import Place

STYLES = {
    "C_{12}": Notation(style="index", cosine="C"),
    "c_{12}": Notation(style="index", cosine="c"),
    r"\cos(\theta_1 + \theta_2)": Notation(style="macro()", cosine=r"\cos"),
    r"C\theta_1": Notation(style="letter", cosine="C"),
    r"c(\theta_1 + \theta_2)": Notation(style="letter()", cosine="c"),
    r"c_{\theta_1}": Notation(style="script", cosine="c"),
    r"\mathrm{c}_{12}": Notation(style="index", cosine=r"\mathrm{c}"),
}
ENVIRONMENTS = (
    (r"\begin{pmatrix}", r"\end{pmatrix}"),
    (r"\left[\begin{matrix}", r"\end{matrix}\right]"),
    (r"\left(\begin{array}{*}", r"\end{array}\right)"),
    (r"\left[ \begin{array}{*}", r"\end{array} \right]"),
    (r"\begin{Bmatrix}", r"\end{Bmatrix}"),
    (r"\begin{bmatrix}", r"\end{bmatrix}"),
)


def allowed_styles(place: Place) -> dict[str, Notation]:
    """Return the spellings of cosines whose letters mean nothing else in the document."""
    names = place.checker.names
    taken = {
        *names.state.definitions,
        *names.used,
        *names.quantities,
        *names.symbols,
        *(names.arm.lengths if names.arm else ()),
    }
    letters = _letters(place)
    revolute = {joint.symbol for joint in names.arm.joints if joint.kind == "revolute"} if names.arm else set()
    usual = all(re.match(r"\\?(?:theta|q)", text) for symbol, text in letters.items() if symbol in revolute)
    free = {}
    for style, notation in STYLES.items():
        letter = notation.cosine[-2] if notation.cosine.endswith("}") else notation.cosine
        pair = {letter, {"C": "S", "c": "s"}.get(letter, letter)}
        if notation.style in ("letter", "letter()", "script") and not usual:
            continue  # c(t_1) is a product
        if letter.startswith("\\") or not any(
            re.match(rf"[{''.join(pair)}](?![A-Za-z])(?!_[a-z])", key) for key in taken
        ):
            free[style] = Notation(letters, notation.style, notation.cosine)
    return free


def symbol_of(place: Place, node: n.Name) -> str | None:
    """Return the arm's symbol that a name stands for; None where it is bound to something else."""
    names = place.checker.names
    return None if node.dots or node.key in names.quantities else names.known_symbol(node.key)


def _letters(place: Place) -> dict[str, str]:
    """Return the document's spelling of each symbol of the arm, as far as this display shows it."""
    found: dict[str, str] = {}
    for statement in place.read(place.display.latex):
        for node in n.walk(statement):
            if isinstance(node, n.Name) and node.text and (symbol := symbol_of(place, node)) is not None:
                found.setdefault(symbol, node.text)
    for letter, symbol in place.checker.names.symbols.items():
        found.setdefault(symbol, "\\" + letter if letter.startswith("theta") else letter)
    return found


def other_cosines(place: Place, latex: str, notation: Notation) -> str | None:
    """Write every cosine and sine of a display in another way."""
    calls = [
        below
        for statement in place.read(latex)
        for below in n.walk(statement)
        if isinstance(below, n.Call) and below.function in ("cos", "sin")
    ]
    changed = latex
    for call in sorted(calls, key=lambda call: -call.span[0]):
        angle = angle_of(place, call.arguments[0])
        start, end = call.span
        if angle is None or re.search(r"\^(?!\*|\{\*\})", latex[start:end]):
            continue
        text = notation.trig(call.function, angle)
        if re.match(r"\s*\^", latex[end:]):
            text = f"({text})"
        changed = f"{changed[:start]} {text} {changed[end:]}"
    return changed if changed != latex else None


def angle_of(place: Place, node: n.Node) -> dict[str, Fraction] | None:
    """Return an angle as a sum of symbols."""
    names = place.checker.names
    if isinstance(node, n.Group):
        return angle_of(place, node.inner)
    if isinstance(node, n.JointAngles):
        symbols = [(names.joint_angle(index), sign) for sign, index in node.terms]
        return (
            {symbol: Fraction(sign) for symbol, sign in symbols if symbol}
            if all(s for s, _ in symbols) and names.arm
            else None
        )
    if isinstance(node, n.Name):
        symbol = symbol_of(place, node)
        return {symbol: Fraction(1)} if symbol is not None else None
    if isinstance(node, n.Sum) and all(sign in "+-" for sign, _ in node.terms):
        total: dict[str, Fraction] = {}
        for sign, term in node.terms:
            part = angle_of(place, term)
            if part is None or len(part) != 1 or set(part) & set(total):
                return None
            total.update({name: (value if sign == "+" else -value) for name, value in part.items()})
        return total
    return None


def other_matrices(latex: str, chance: random.Random) -> str | None:
    opening, closing = chance.choice(ENVIRONMENTS)
    opening = opening.replace("{*}", "{" + "c" * 8 + "}")
    changed = latex.replace(r"\begin{bmatrix}", opening).replace(r"\end{bmatrix}", closing)
    return changed if changed != latex else None


def other_brackets(latex: str, chance: random.Random) -> str | None:
    opening, closing = chance.choice(
        ((r"\left(", r"\right)"), (r"\big(", r"\big)"), (r"\bigl(", r"\bigr)"), ("{(", ")}"))
    )
    if re.search(r"\\(?:left|right|[bB]ig+[lr]?)\s*[()]", latex) or (
        opening == "{(" and re.search(r"[A-Za-z}]\(|\)\^", latex)
    ):
        return None
    changed = latex.replace("(", opening).replace(")", closing)
    return changed if changed != latex else None


def other_fractions(latex: str, chance: random.Random) -> str | None:
    changed = latex.replace(r"\frac", chance.choice((r"\dfrac", r"\tfrac", r"\displaystyle\frac")))
    return changed if changed != latex else None


def other_transforms(place: Place, latex: str, chance: random.Random) -> str | None:
    """{}^0T_1 as {}^0_1T, {}_1^0T, ^0T_1 at the head of a product, or with a bold letter."""
    bound = {*place.checker.names.quantities, *place.checker.names.state.definitions}

    def other(found: re.Match[str]) -> str:
        upper, letter, lower = (found.group(k).strip("{}") if k != 2 else found.group(k) for k in (1, 2, 3))
        plain = re.sub(r"\\[a-z]+\{(\w)\}", r"\1", letter)
        if "{}" + f"^{upper}{plain}_{lower}" in bound:
            return found.group()
        return chance.choice(forms).format(upper, letter, lower)

    forms = (
        "{{}}^{{{0}}}_{{{2}}}{1}",
        "{{}}_{{{2}}}^{{{0}}}{1}",
        "{{}}^{{{0}}}{{{1}}}_{{{2}}}",
        "{{}}^{0}\\mathbf{{{1}}}_{2}",
    )
    changed = re.sub(r"\{\}\^(\d)\s*([TAHR]|\\math\w+\{[TAHR]\})_(\d)", other, latex)
    if chance.random() < 0.3:
        changed = re.sub(r"(^|=)(\s*)\{\}\^", r"\1\2^", latex)
    return changed if changed != latex else None


def other_layout(latex: str, chance: random.Random) -> str | None:
    if r"\begin{aligned}" in latex or latex.count("=") != 1:
        return chance.choice((rf"\displaystyle {latex} \tag{{1}}", f"{latex} .", rf"\boxed{{{latex}}}"))
    forms: tuple[Callable[[str, str], str], ...] = (
        lambda a, b: rf"\begin{{aligned}} {a} &= {b} \end{{aligned}}",
        lambda a, b: rf"\begin{{split}} {a} \\ &= {b} \end{{split}}",
        lambda a, b: rf"{a} \;=\; {b},",
    )
    left, right = latex.split("=")
    return chance.choice(forms)(left, right)


def sides_exchanged(place: Place, latex: str) -> str | None:
    if latex.count("=") != 1 or r"\begin{aligned}" in latex or place.checker.names.arm is None:
        return None
    left, right = latex.split("=")
    statements = place.read(latex)
    if len(statements) != 1 or any(
        mark in latex for mark in (",", r"\quad", r"\qquad", "cases", "underbrace", "overbrace", r"\right|")
    ):
        return None
    return f"{right.strip()} = {left.strip()}"
