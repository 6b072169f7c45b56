"""Functions in MathML, as they were spelt: cos θ₁, c₁₂, C(θ₁ + θ₂), Rot(z, θ), J(q), |x|."""

from __future__ import annotations

import re
from collections.abc import Callable

from armproof.verification.latex import nodes as n
from armproof.verification.latex.mathml import box
from armproof.verification.latex.mathml.box import EMPTY, Box
from armproof.verification.latex.mathml.names import name_box, script_box
from armproof.verification.latex.tokens import canonical_script

Write = Callable[[n.Node], Box]


class CallWriter:
    """Writes calls; `text` is the LaTeX that the tree was read from, `write` writes an argument."""

    def __init__(self, text: str, write: Write) -> None:
        self.text = text
        self.write = write

    def call(self, call: n.Call, above: Box = EMPTY) -> Box:
        """Return a call; `above` is a power or an operator upon it."""
        if call.function == "sqrt":
            return box.scripted(box.root(self.write(call.arguments[0])), sup=above)
        if call.style == "bars":
            bar = "‖" if call.function in ("norm", "frobenius") else "|"
            sub = box.letter("F") if call.function == "frobenius" else EMPTY
            return box.scripted(box.fenced(bar, self.write(call.arguments[0]), bar), sub, above)
        if call.style == "index":
            return box.scripted(self._head(call), self._digits(call.arguments[0]), above)
        if call.function in ("cos", "sin") and call.style == "script":
            return box.scripted(self._head(call), self.write(call.arguments[0]), above)
        if call.function == "name":
            return self._applied_name(call, above)
        if call.function in ("Rot", "Rot3", "Trans"):
            return self._elementary(call, above)
        return self._applied(call, above)

    def joint_angles(self, angles: n.JointAngles) -> Box:
        """Return the angle that c_{12} names, where it stands by itself: θ₁ + θ₂."""
        parts: list[Box] = []
        for index, (sign, joint) in enumerate(angles.terms):
            if index or sign < 0:
                parts.append(box.operator("−" if sign < 0 else "+"))
            parts.append(box.scripted(box.letter("θ"), box.number(str(joint))))
        return box.row(*parts)

    def _applied(self, call: n.Call, above: Box) -> Box:
        """A function and its arguments, in brackets or not; the power stands where it was written: sin²θ, or (sin θ)²."""
        head = self._head(call)
        on_head = above if self._has_early_script(call) else EMPTY
        head = box.scripted(head, sup=on_head)
        if call.style in ("macro()", "letter()"):
            whole = box.row(head, self._brackets(call.arguments))
            return whole if on_head.markup else box.scripted(whole, sup=above)
        gap = EMPTY if call.style == "letter" else box.thin_space()
        whole = box.row(head, gap, self.write(call.arguments[0]))
        return whole if on_head.markup or not above.markup else box.scripted(box.fenced("(", whole, ")"), sup=above)

    def _applied_name(self, call: n.Call, above: Box) -> Box:
        name, *arguments = call.arguments
        early = above if "^" in self.text[name.span[1] : arguments[0].span[0]] else EMPTY
        head = name_box(name, early) if isinstance(name, n.Name) else self.write(name)
        whole = box.row(head, self._brackets(tuple(arguments)))
        return whole if early.markup else box.scripted(whole, sup=above)

    def _elementary(self, call: n.Call, above: Box) -> Box:
        """Rot(z, θ), Rot_z(θ), R_{z,θ}: what stands in the subscript, and what in brackets, as written."""
        letter, _, below = call.head.partition("_")
        head = box.letter(canonical_script(letter))
        end = call.span[0] + len(call.head)
        axis, *amounts = call.arguments
        inside = [part for part in amounts if part.span[1] <= end]
        outside = [part for part in amounts if part.span[1] > end]
        if inside:
            sub = box.row(self.write(axis), box.mark(","), *map(self.write, inside))
            return box.scripted(head, sub, above)
        if below:
            whole = box.row(box.scripted(head, script_box(canonical_script(below))), self._brackets(tuple(outside)))
        else:
            whole = box.row(head, self._brackets((axis, *outside)))
        return box.scripted(whole, sup=above)

    def _head(self, call: n.Call) -> Box:
        """Return the function's name as it was spelt, without the power that may stand on it."""
        spelt = re.split(r"\^", call.head or call.function, maxsplit=1)[0]
        name, _, below = canonical_script(spelt).partition("_")
        head = box.letter(name or call.function, upright=call.style not in ("index", "letter", "letter()", "script"))
        if call.function.startswith("a") and "-1" in call.head and "^" in call.head:  # \sin^{-1}
            return box.scripted(head, sup=box.row(box.mark("−"), box.number("1")))
        return box.scripted(head, script_box(below)) if below and call.style != "index" else head

    def _has_early_script(self, call: n.Call) -> bool:
        return "^" in self.text[call.span[0] : call.arguments[0].span[0]] and "-1" not in call.head

    def _digits(self, angles: n.Node) -> Box:
        if not isinstance(angles, n.JointAngles):
            return self.write(angles)
        signed = any(sign < 0 for sign, _ in angles.terms)
        parts: list[Box] = []
        for index, (sign, joint) in enumerate(angles.terms):
            if sign < 0 or (signed and index):
                parts.append(box.mark("−" if sign < 0 else "+"))
            parts.append(box.number(str(joint)))
        if not signed:
            return box.number("".join(str(joint) for _, joint in angles.terms))
        return box.row(*parts)

    def _brackets(self, arguments: tuple[n.Node, ...]) -> Box:
        parts: list[Box] = []
        for index, argument in enumerate(arguments):
            parts += [box.mark(","), self.write(argument)] if index else [self.write(argument)]
        return box.fenced("(", box.joined(parts), ")")
