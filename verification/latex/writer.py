"""Write terms in a document's own hand: its letters, its way with sines and cosines, its spelling of products."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from fractions import Fraction

from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import GREEK
from armproof.verification.latex.units import size_of

SWAPPED = {"cos": "sin", "sin": "cos", "\\cos": "\\sin", "\\sin": "\\cos", "C": "S", "S": "C", "c": "s", "s": "c", "Cos": "Sin",
           "Sin": "Cos", "\\mathrm{c}": "\\mathrm{s}", "\\mathrm{s}": "\\mathrm{c}"}  # fmt: skip


# letters whose superscript may be the name of a frame: T_1^2 is no square
SCRIPTED = frozenset(
    ["T", "A", "H", "R", "p", "P", "z", "Z", "O", "o", "x", "y", "X", "Y", "J", "v", "V", "omega", "Omega", "W", "w"]
)


@dataclass
class Notation:
    """How one display, or its document, writes symbols and trigonometric functions.

    symbols: model symbol → LaTeX; style and head of the first trigonometric function met, e.g. "index" and "C".
    """

    symbols: dict[str, str] = field(default_factory=dict)
    style: str = "macro()"
    cosine: str = "\\cos"
    underscore: bool = True
    braces: bool = True
    learnt: bool = False

    def learn(self, call: n.Call, text: str) -> None:
        """Take over the style of a trigonometric function as written."""
        if self.learnt or call.function not in ("cos", "sin"):
            return
        head = bare_head(call) if call.function == "cos" else SWAPPED.get(bare_head(call), bare_head(call))
        self.learnt = True
        self.style, self.cosine = call.style, head
        if call.style == "index":
            self.underscore = "_" in text
            self.braces = "{" in text or not self.underscore
        if call.style == "macro":
            self.style = "macro()"

    def symbol(self, name: str) -> str:
        """Return a model symbol in the document's letters."""
        return self.symbols.get(name) or symbol_as_latex(name)

    def trig(self, function: str, angle: Mapping[str, Fraction]) -> str:
        """Write cos or sin of a sum of angles."""
        head = self.cosine if function == "cos" else SWAPPED.get(self.cosine, self.cosine)
        digits = self._digits(angle)
        if self.style == "index" and digits is not None:
            if not self.underscore:
                return f"{head}{digits}" if re.fullmatch(r"\d+", digits) else f"{head}_{{{digits}}}"
            return f"{head}_{{{digits}}}" if len(digits) > 1 else f"{head}_{digits}"
        argument = self.angle(angle)
        if self.style == "letter" and len(angle) == 1 and argument.startswith("\\"):
            return f"{head}{argument}"
        if self.style == "script":
            return f"{head}_{{{argument}}}"
        if self.style in ("letter", "letter()"):
            return f"{head}({argument})" if len(angle) > 1 or self.style == "letter()" else f"{head}{argument}"
        if self.style == "index":
            head = "\\cos" if function == "cos" else "\\sin"
        return f"{head}({argument})"

    def angle(self, angle: Mapping[str, Fraction]) -> str:
        """Write a sum of angles."""
        parts: list[str] = []
        for name, coefficient in angle.items():
            size = "" if abs(coefficient) == 1 else number(abs(coefficient)) + " "
            text = f"{size}{self.symbol(name)}" if name != "pi" else _pi(abs(coefficient))
            parts.append(("-" if coefficient < 0 else "+") + " " + text)
        joined = " ".join(parts)
        return joined[2:] if joined.startswith("+ ") else "-" + joined[2:]

    def _digits(self, angle: Mapping[str, Fraction]) -> str | None:
        digits = ""
        for position, (name, coefficient) in enumerate(sorted(angle.items())):
            found = re.fullmatch(r"(?:theta|q)_(\d)", name)
            if found is None or abs(coefficient) != 1:
                return None
            digits += ("-" if coefficient < 0 else "+" if "-" in digits and position else "") + found.group(1)
        return digits


def symbol_as_latex(name: str) -> str:
    """Write a model symbol as LaTeX: theta_12 → \\theta_{12}, dot theta_1 → \\dot{\\theta}_1."""
    dots = 0
    while name.startswith("dot "):
        name, dots = name[4:], dots + 1
    base, _, index = name.partition("_")
    accent, _, base = base.rpartition(" ")
    letter = f"\\{base}" if base in GREEK else base
    if accent:
        letter = f"\\{accent}{{{letter}}}"
    if dots:
        letter = f"\\{'d' * dots}ot{{{letter}}}"
    return letter + (f"_{{{index}}}" if len(index) > 1 else f"_{index}" if index else "")


def number(value: Fraction) -> str:
    """Write a rational number."""
    if value.denominator == 1:
        return str(value.numerator)
    decimal = _decimal(value)
    if decimal is not None:
        return decimal
    sign = "-" if value < 0 else ""
    return f"{sign}\\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"


def _decimal(value: Fraction) -> str | None:
    """0.054 rather than 27/500, 1/2 rather than 0.5: decimals for what is not a plain fraction."""
    if value.denominator <= 12:
        return None
    denominator = value.denominator
    for factor in (2, 5):
        while denominator % factor == 0:
            denominator //= factor
    return f"{float(value):.12g}" if denominator == 1 else None


def _pi(coefficient: Fraction) -> str:
    if coefficient == 1:
        return "\\pi"
    above = "\\pi" if coefficient.numerator == 1 else f"{coefficient.numerator}\\pi"
    return above if coefficient.denominator == 1 else f"\\frac{{{above}}}{{{coefficient.denominator}}}"


def _read_apart(node: n.Node) -> tuple[n.Node, ...]:
    """Return the parts of a node that stand in its script: the values of a bar, the angle of c_{12} or c_{\\theta_1}."""
    if isinstance(node, n.At):
        return tuple(side for value in node.values for side in value)
    if isinstance(node, n.Call) and node.style in ("index", "script") and node.function in ("cos", "sin"):
        return node.arguments
    return ()


def _differs_below_only(node: n.Node, original: n.Node) -> bool:
    """Whether two nodes of one type have the same text around as many children."""
    if len(list(n.children(node))) != len(list(n.children(original))):
        return False
    return all(
        _shape(getattr(node, spec.name)) == _shape(getattr(original, spec.name))
        for spec in fields(node)
        if spec.name != "span"
    )


def _shape(value: object) -> object:
    """Replace the nodes in a field by their mere presence."""
    if isinstance(value, n.Node):
        return n.Node
    return tuple(_shape(item) for item in value) if isinstance(value, tuple) else value


def _binds(parent: n.Node, before: n.Node, after: n.Node) -> bool:
    """Whether a sum, product or quotient needs brackets in the place of what stood there."""
    if isinstance(after, n.Sum) and isinstance(parent, n.Sum | n.Product):
        return True
    if isinstance(parent, n.Product):
        if isinstance(after, n.Quotient):
            return after.style == "slash"
        return isinstance(after, n.Product) and "×" in parent.operators
    if isinstance(parent, n.Derivative):
        return True
    if isinstance(parent, n.Quotient) and parent.style == "slash":
        return True
    unbracketed = isinstance(parent, n.Call) and parent.style in ("letter", "macro")
    return unbracketed and type(after) is not type(before)


def _apart(before: str, text: str, after: str) -> str:
    """Set off letters that would run together with a macro or a name beside them."""
    front = " " if text[:1].isalpha() and re.search(r"\\[A-Za-z]+$", before) else ""
    back = " " if after[:1].isalpha() and re.search(r"\\[A-Za-z]+$", text) else ""
    return f"{front}{text}{back}"


def bare_head(call: n.Call) -> str:
    """Return the spelling of a function without the power in \\sin^2(\\theta), which is a node of its own."""
    if call.function in ("Rot", "Rot3", "Trans", "name", "asin", "acos", "atan"):  # \\tan^{-1} is no power
        return call.head
    return re.sub(r"\s*\^.*", "", call.head, flags=re.DOTALL)


class Writer:
    """Writes a tree; whatever comes unchanged from `source` is copied from it, spaces and brackets included."""

    def __init__(self, source: str, original: n.Node, notation: Notation) -> None:
        self.source = source
        self.notation = notation
        # what is read apart, such as the values under a bar, has no place of its own
        apart = {id(below) for node in n.walk(original) for part in _read_apart(node) for below in n.walk(part)}
        # ids stay valid while these live
        self.kept: dict[int, n.Node] = {id(node): node for node in n.walk(original) if id(node) not in apart}
        self.at: dict[tuple[type, tuple[int, int]], n.Node] = {}
        for node in self.kept.values():
            self.at.setdefault((type(node), node.span), node)

    def write(self, node: n.Node) -> str:
        """Return LaTeX for a tree, the spelling of the source wherever it was not changed."""
        if isinstance(node, n.Name) and node.text:
            return node.text
        if id(node) in self.kept:
            return self.source[node.span[0] : node.span[1]].strip()
        patched = self._patched(node)
        return self._anew(node) if patched is None else patched

    def _patched(self, node: n.Node) -> str | None:
        """Write a node of which only something below has changed: the source with that part replaced."""
        original = self.at.get((type(node), node.span))
        if original is None or isinstance(node, n.At) or not _differs_below_only(node, original):
            return None
        if isinstance(node, n.Call) and _read_apart(node):
            return None
        pieces: list[str] = []
        position, end = original.span
        for before, after in zip(n.children(original), n.children(node), strict=True):
            start, stop = before.span
            if not position <= start <= stop <= end:
                return None
            if before is not after:
                text = self._bracketed(node, before, after)
                if isinstance(node, n.Power) and before is original.exponent and self.source[start - 1] != "{":  # type: ignore[attr-defined]
                    text = f"{{{text}}}"
                pieces.append(self.source[position:start] + _apart(self.source[:start], text, self.source[stop:]))
                position = stop
        return ("".join(pieces) + self.source[position:end]).strip()

    def _bracketed(self, parent: n.Node, before: n.Node, after: n.Node) -> str:
        if isinstance(parent, n.Power | n.Postfix) and after is not getattr(parent, "exponent", None):
            return self._base(after)
        return self._tight(after) if _binds(parent, before, after) else self.write(after)

    def _anew(self, node: n.Node) -> str:
        if isinstance(node, n.Number):
            return node.text or number(node.value)
        if isinstance(node, n.Name):
            return node.text
        if isinstance(node, n.Sum):
            return self._sum(node)
        if isinstance(node, n.Product):
            return self._product(node)
        if isinstance(node, n.Call):
            return self._call(node)
        if isinstance(node, n.Group):
            opening, closing = ("{", "}") if node.brackets == "{}" else tuple(node.brackets)
            return f"{opening}{self.write(node.inner)}{closing}"
        if isinstance(node, n.Quotient):
            if node.style == "slash":
                return f"{self._tight(node.numerator)}/{self._tight(node.denominator)}"
            return f"\\frac{{{self.write(node.numerator)}}}{{{self.write(node.denominator)}}}"
        if isinstance(node, n.Power):
            return f"{self._base(node.base)}^{{{self.write(node.exponent)}}}"
        if isinstance(node, n.Postfix):
            if node.operator != "deg" and size_of(node.operator):
                style, unit = "mathrm" if node.operator in ("cm", "mm") else "text", node.operator.replace("%", "\\%")
                return f"{self._base(node.base)}\\,\\{style}{{{unit}}}"
            above = "\\circ" if node.operator == "deg" else node.operator
            return f"{self._base(node.base)}^{{{above}}}"
        if isinstance(node, n.Matrix):
            rows = r" \\ ".join(" & ".join(self.write(cell) for cell in row) for row in node.rows)
            return f"\\begin{{{node.environment}}} {rows} \\end{{{node.environment}}}"
        if isinstance(node, n.Sequence):
            opening, closing = ("\\{", "\\}") if node.brackets == "{}" else tuple(node.brackets)
            return f"{opening}{', '.join(self.write(item) for item in node.items)}{closing}"
        if isinstance(node, n.Labelled):
            return self.write(node.inner)
        if isinstance(node, n.Derivative):
            order = f"^{node.order}" if node.order > 1 else ""
            below = f"{self._tight(node.variable)}{order}"
            return f"\\frac{{\\partial{order} {self._tight(node.operand)}}}{{\\partial {below}}}"
        if isinstance(node, n.At):
            values = ", ".join(f"{self.write(left)} = {self.write(right)}" for left, right in node.values)
            return f"\\left. {self.write(node.inner)} \\right|_{{{values}}}"
        raise NotImplementedError(type(node).__name__)

    def _tight(self, node: n.Node) -> str:
        text = self.write(node)
        return f"({text})" if isinstance(node, n.Sum | n.Product | n.Quotient) else text

    def _base(self, node: n.Node) -> str:
        """Write what a script is set on; without brackets only where it cannot be read as part of the name."""
        text = self.write(node)
        if isinstance(node, n.Name):
            scripts = node.sup or node.pre_sub or node.pre_sup or node.dots or "^" in text
            plain = not scripts and node.base not in SCRIPTED
        elif isinstance(node, n.Call):
            closed = node.style in ("index", "script", "bars", "braces")
            plain = closed and node.function in ("cos", "sin", "sqrt", "abs", "norm", "det")
        else:
            plain = isinstance(node, n.Number | n.Group | n.Matrix | n.Sequence)
        return text if plain else f"({text})"

    def _sum(self, node: n.Sum) -> str:
        text = ""
        for sign, term in node.terms:
            written = self.write(term)
            if isinstance(term, n.Sum):
                written = f"({written})"
            mark = {"+": "+", "-": "-", "±": "\\pm", "∓": "\\mp"}[sign]
            if not text:
                text = written if mark == "+" else f"{mark} {written}" if mark.startswith("\\") else f"{mark}{written}"
            else:
                text += f" {mark} {written}"
        return text

    def _product(self, node: n.Product) -> str:
        marks = {"": " ", "⋅": " \\cdot ", "×": " \\times "}
        first, *others = (f"({self.write(f)})" if isinstance(f, n.Sum) else self.write(f) for f in node.factors)
        return first + "".join(marks[sign] + text for sign, text in zip(node.operators, others, strict=True))

    def _call(self, node: n.Call) -> str:
        head = bare_head(node)
        if node.function in ("cos", "sin") and isinstance(node.arguments[0], n.JointAngles):
            angle = node.arguments[0]
            digits = "".join(("-" if sign < 0 else "+" if k and any(s < 0 for s, _ in angle.terms) else "") + str(index)
                             for k, (sign, index) in enumerate(angle.terms))  # fmt: skip
            if digits.isdigit() and not self._has_underscore(node):
                return f"{head}{digits}"
            return f"{head}_{{{digits}}}" if len(digits) > 1 else f"{head}_{digits}"
        arguments = node.arguments
        if node.function in ("Rot", "Rot3", "Trans") and isinstance(arguments[0], n.Name) and not arguments[0].text:
            arguments = arguments[1:]  # the axis stands in the subscript of the head
        inside = ", ".join(self.write(argument) for argument in arguments)
        if node.function == "name":
            return f"{head}({', '.join(self.write(a) for a in node.arguments[1:])})"
        if node.style == "bars":
            bar, note = "\\|" if node.function != "abs" else "|", "_F" * (node.function == "frobenius")
            return f"\\left{bar}{inside}\\right{bar}{note}"
        if node.function == "sqrt":
            return f"\\sqrt{{{inside}}}"
        if node.style == "script" and node.function in ("cos", "sin"):
            return f"{head}_{{{inside}}}"
        if node.style == "letter" and isinstance(node.arguments[0], n.Name):
            return f"{head}{inside}"
        if node.style == "macro" and isinstance(node.arguments[0], n.Name | n.Matrix):
            return f"{head} {inside}" if inside[:1].isalnum() else f"{head}{inside}"
        return f"{head}({inside})"

    def _has_underscore(self, call: n.Call) -> bool:
        """Whether the source writes C_{12} and not C12, here or else in general."""
        original = self.at.get((n.Call, call.span))
        if original is not None and original.span != (0, 0):
            return "_" in self.source[original.span[0] : original.span[1]]
        return self.notation.underscore or self.notation.style != "index"
