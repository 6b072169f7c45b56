"""Functions and their arguments: cosines in all their spellings, elementary matrices, names applied to joint variables."""

from __future__ import annotations

import re
from collections.abc import Sequence as Seq
from dataclasses import replace

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES, VARIANTS, one_of
from armproof.verification.latex.indexed import TRANSFORM_LETTERS, NameReader, is_bracketed_index
from armproof.verification.latex.items import Item, Script
from armproof.verification.latex.tokens import canonical_script
from armproof.verification.patterns import regex

TRIG_LETTERS = {"c": "cos", "C": "cos", "s": "sin", "S": "sin"}
ANGLE_LETTERS = frozenset([*ANGLES, *VARIANTS, "q", "delta"])
_ANGLE = r"\\(?:var)?(?:%s)" % one_of(ANGLES)
POINTS = frozenset("pxyz")  # a point and its coordinates
MATRIX_LETTERS = TRANSFORM_LETTERS | {"J"}
MATRIX_FUNCTIONS = frozenset(["det", "rank", "adj", "com", "tr"])
_JOINT_DIGITS = regex(r"[+-]?\d(?:,?[+-]?\d)*")


class CallReader(NameReader):
    """Reads functions and what they are applied to."""

    def next_factor(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        """Return the factor that begins at an item, and where the next one does."""
        raise NotImplementedError

    def elementary_letter(self, item: Item) -> n.Node | None:
        """R_{z,\\theta} is the elementary rotation, 3×3."""
        subs = [script for script in item.scripts if script[0] == "SUB"]
        if item.base != "R" or item.pre or len(subs) != 1:
            return None
        _, text, span = subs[0]
        amount = self._elementary_amount(text, span)
        if amount is None or not any(map(_tells_angle, n.walk(amount))):
            return None
        axis = n.Name(canonical_script(text)[0].lower(), span=span)
        call = n.Call("Rot3", (axis, amount), self.text[item.start : span[1]], "script", span=(item.start, span[1]))
        return self.scripted(call, [script for script in item.scripts if script[0] != "SUB"], item.start)

    def application(self, node: n.Node, following: Item) -> n.Node | None:
        """Read `J(q)`, `A_1(\\theta_1)` and `f_1(x)` as names with arguments; `a_1(…)` of more than a letter stays a product."""
        if isinstance(node, n.Postfix) and isinstance(node.base, n.Name):  # J^T(q)
            applied = self.application(node.base, following) if not following.scripts else None
            return replace(node, base=applied) if applied is not None else None
        if not isinstance(node, n.Name):
            return None
        arguments = _arguments(following)
        one_letter = len(arguments) == 1 and isinstance(arguments[0], n.Name) and not following.scripts
        if not (self._is_application(node, arguments) or (one_letter and self._may_be_function(node, arguments[0]))):
            return None
        head = self.text[node.span[0] : node.span[1]]
        named = n.Call("name", (node, *arguments), head, "name", span=(node.span[0], following.end))
        return self.scripted(named, following.scripts, node.span[0])

    def _is_application(self, node: n.Name, arguments: tuple[n.Node, ...]) -> bool:
        letter, is_upper = node.base, node.base[:1].isupper()
        if letter in MATRIX_LETTERS and any(isinstance(a, n.Name) and a.base in MATRIX_LETTERS for a in arguments):
            return False  # R(R)^T, {}^0T_1({}^1T_2): matrices are multiplied
        is_point = letter in POINTS and all(map(_is_constant, arguments))
        if letter == "g" and node.sub and n.is_nought(arguments):
            return True  # g_{st}(0), the reference configuration
        may_be_applied = is_upper or (len(arguments) > 1 and (is_point or self.is_bound(node.key)))
        is_value_alone = len(arguments) == 1 and not isinstance(arguments[0], n.Number) and _is_constant(arguments[0])
        if letter == "w" and is_value_alone:
            return True  # w(\pi/2): nobody has π/2 behind the measure of manipulability as a factor
        is_value = _is_constant if len(arguments) == 1 else _is_of_angles
        if arguments and may_be_applied and letter not in TRIG_LETTERS and all(map(is_value, arguments)):
            return True  # {}^0T_3(0, 90^\\circ, 0), J(θ_1, 0), p(0, 0), and w(0, 0) of a w that is bound: the arm there
        names = [argument for argument in arguments if isinstance(argument, n.Name)]
        if len(names) < len(arguments):
            return False
        inside = ",".join(name.key for name in names)
        plain = all(name.base in ("t", "d") or name.base in ANGLE_LETTERS for name in names)
        is_function = (letter in "fgh" and not node.sub) or (is_upper and letter not in "CS")
        is_function = is_function or (len(letter) > 1 and letter not in ANGLE_LETTERS)
        return (
            self.is_bound(f"{node.key}({inside})")
            or (is_function and (plain or is_upper))
            or (plain and (inside in ("q", "t") or letter in POINTS))  # p_1(θ_1): nobody puts one factor in brackets
            or (len(names) > 1 and (plain or letter in POINTS))
            or (letter == "S" and not node.sub and not plain)  # S(v), the skew matrix, unless the argument is an angle
        )

    def _may_be_function(self, node: n.Name, argument: n.Node) -> bool:
        """Whether f_s(x) may be read as a value at x: nobody puts one factor in brackets, but for a matrix beside another."""
        letters = (node.base, argument.base) if isinstance(argument, n.Name) else (node.base,)
        return not any(letter in MATRIX_LETTERS or letter in TRIG_LETTERS for letter in letters)

    def trig_letter(self, item: Item, following: Item | None) -> tuple[n.Node, int] | None:
        """c_1, C_{12}, s_{\\theta_1}, C\\theta_1, S(\\theta_1+\\theta_2): unless the document binds that name."""
        function = TRIG_LETTERS.get(item.base)
        if (
            function is None
            or item.pre
            or item.base in self.spelling.screws
            or any(kind in ("PRIME", "DOT", "AT") for kind, _, _ in item.scripts)
        ):
            return None
        subs = [script for script in item.scripts if script[0] == "SUB"]
        sups = [script for script in item.scripts if script[0] == "SUP"]
        if subs:
            raw = subs[0][1]
            if self.is_bound(f"{item.base}_{canonical_script(raw)}"):
                return None
            argument = self._trig_index(raw, subs[0][2])
            if argument is None:
                return None
            style = "index" if isinstance(argument, n.JointAngles) else "script"
            end = subs[0][2][1]
            if isinstance(argument, n.JointAngles) and (mark := self._mark_of_solution(sups)) is not None:
                text, (_, end), style = canonical_script(mark[1]), mark[2], "script"
                argument = self._marked(argument, text, (item.start, end))
                sups = [script for script in sups if script is not mark]
            call = n.Call(function, (argument,), item.base, style, span=(item.start, end))
            return self.scripted(call, sups, item.start), 1
        is_own = self.is_bound(item.base) or item.base in self.spelling.letters
        if following is None or is_own or any(kind == "DOT" for kind, *_ in following.scripts):
            return None  # c \dot\theta is damping: a rate is no angle
        head, span = self.text[item.start : item.end], (item.start, following.end)
        if following.kind == "letter" and following.base in ANGLE_LETTERS and not following.pre:
            angle = self.name(Item("letter", None, following.start, following.end, following.base, following.scripts))
            if isinstance(angle, n.Name):
                return self.scripted(n.Call(function, (angle,), head, "letter", span=span), sups, item.start), 2
        group, scripts = following.node, [*sups, *following.scripts]
        if following.kind in ("list", "braces", "node") and isinstance(group, n.Group) and self._is_angle(group.inner):
            call = n.Call(function, (group.inner,), head, "letter()", span=span)
            return self.scripted(call, scripts, item.start), 2
        return None

    def _mark_of_solution(self, sups: Seq[Script]) -> Script | None:
        """Return what stands in brackets above a c_2: it tells whose cosine that is, and no power of it."""
        return next((script for script in sups if is_bracketed_index(canonical_script(script[1]))), None)

    def _marked(self, angles: n.JointAngles, mark: str, span: tuple[int, int]) -> n.Node:
        """Return the sum of the angles of one solution: θ_2^{(a)} + θ_3^{(a)} of c_{23}^{(a)}."""
        terms = [
            ("-" if sign < 0 else "+", n.Name(self.spelling.angle, str(index), mark, span=span))
            for sign, index in angles.terms
        ]
        return terms[0][1] if len(terms) == 1 and terms[0][0] == "+" else n.Sum(tuple(terms), span=span)

    def _trig_index(self, raw: str, span: tuple[int, int]) -> n.Node | None:
        canonical = canonical_script(raw)
        if _JOINT_DIGITS.fullmatch(canonical):
            found = re.findall(r"([+-]?),?(\d)", canonical)
            if not any(sign for sign, _ in found):
                digits = "".join(digit for _, digit in found)
                signs = self.spelling.joint_signs(digits)
                return n.JointAngles(tuple(zip(signs, map(int, digits), strict=True)), span=span)
            return n.JointAngles(tuple((-1 if sign == "-" else 1, int(digit)) for sign, digit in found), span=span)
        if canonical in ("i", "j", "k", "n", "i-1", "i+1", "n-1"):
            return n.Name("theta", sub=canonical, text=raw, span=span)
        spaced = re.sub(rf"({_ANGLE})\s*([a-z0-9](?:[-+]1)?)(?![A-Za-z])", r"\1_{\2}", raw)
        if not re.search(rf"{_ANGLE}|^\s*q", spaced):
            return None
        try:
            angle = self.parse(spaced, max(self.text.find(raw, span[0]), span[0]))
        except ReadError:
            return None
        if isinstance(angle, n.Product) and not any(angle.operators):  # c_{q_1 q_2} is c_{12}: angles are added
            angle = n.Sum(tuple(("+", factor) for factor in angle.factors), span=angle.span)
        return angle if self._is_angle(angle) else None

    def _is_angle(self, node: n.Node) -> bool:
        names = [*n.names(node)]
        calls = any(isinstance(below, n.Call | n.Matrix) for below in n.walk(node))
        angles = all(name.base in ANGLE_LETTERS or name.base == "pi" for name in names)
        return bool(names) and not calls and angles and not any(name.dots for name in names)  # a rate is no angle

    def call(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        """Return the call that begins with a function's name, and where the next factor does."""
        item = items[index]
        function = item.base
        powers: list[Script] = []
        unread: list[str] = []  # \det_2 J, \max_q f: nobody knows the value
        axis: n.Node | None = None
        for script in item.scripts:
            kind, text, span = script
            if kind == "SUP" and canonical_script(text) == "-1" and function in ("cos", "sin", "tan"):
                function = "a" + function
            elif kind == "SUP":
                powers.append(script)
            elif kind == "SUB" and function in ("Rot", "Trans"):
                axis = n.Name(canonical_script(text)[:1].lower(), span=span)
                if (amount := self._elementary_amount(text, span)) is not None:
                    return self._scripted_call(item, function, (axis, amount), script, "script"), index + 1
            elif kind == "SUB" and function in ("cos", "sin"):
                argument = self._trig_index(text, span)
                if argument is None:
                    raise ReadError(say(Kind.NO_ANGLE, text=self.text[item.start : item.end]), item.start)
                style = "index" if isinstance(argument, n.JointAngles) else "script"
                return self._scripted_call(item, function, (argument,), script, style), index + 1
            else:
                unread.append(text)
        if index + 1 >= len(items):
            raise ReadError(say(Kind.NO_ARGUMENT, text=self.text[item.start : item.end]), item.start)
        following = items[index + 1]
        head = self.text[item.start : item.end]
        if unread:
            _, after = self.next_factor(items, index + 1)
            span = (item.start, items[after - 1].end)
            return n.Name("words", canonical_script(unread[0]), text=self.text[slice(*span)], span=span), after
        if following.kind == "list" and not following.pre:
            arguments = _arguments(following)
            if function == "atan" and len(arguments) == 2:
                function = "atan2"
            elif function == "atan2" and len(arguments) == 1 and isinstance(n.bare(arguments[0]), n.Quotient):
                function = "atan"  # atan2(y/x): of two arguments nothing is left but their quotient
            if axis is not None:
                arguments = (axis, *arguments)
            made = n.Call(function, arguments, head, "macro()", span=(item.start, following.end))
            return self.scripted(self.scripted(made, following.scripts, item.start), powers, item.start), index + 2
        operand, after = self._bare_argument(items, index + 1, function)
        made = n.Call(function, (operand,), head, "macro", span=(item.start, operand.span[1]))
        return self.scripted(made, powers, item.start), after

    def _scripted_call(
        self, item: Item, function: str, arguments: tuple[n.Node, ...], subscript: Script, style: str
    ) -> n.Node:
        """A function whose argument stands in its subscript, with its other scripts applied."""
        end = subscript[2][1]
        head = self.text[item.start : subscript[2][0] if style != "script" or len(arguments) == 1 else end]
        made = n.Call(function, arguments, head, style, span=(item.start, end))
        return self.scripted(made, [script for script in item.scripts if script[0] != "SUB"], item.start)

    def _elementary_amount(self, subscript: str, span: tuple[int, int]) -> n.Node | None:
        """Return the angle or length of Rot_{z,\\theta_i} and Trans_{x,a_i}, or None where only the axis is given."""
        parts = re.fullmatch(
            r"\s*[xyzXYZ]\s*(?:_\s*(?:\{[^{}]*\}|\w))?\s*(?:,|;|\\[,;: ])\s*(\S.*)", subscript, re.DOTALL
        )
        return self.parse(parts.group(1), self.text.find(parts.group(1), span[0])) if parts else None

    def _bare_argument(self, items: Seq[Item], index: int, function: str) -> tuple[n.Node, int]:
        """cos θ_1 takes one operand; cos 2θ_1 a number and the operand after it."""
        first = items[index]
        if function in MATRIX_FUNCTIONS:
            return self.next_factor(items, index)
        node, after = self.next_factor(items, index)
        if isinstance(node, n.Number) and after < len(items) and items[after].kind in ("letter", "node", "list"):
            second, after = self.next_factor(items, after)
            return n.Product((node, second), ("",), span=(first.start, second.span[1])), after
        return node, after


def _tells_angle(node: n.Node) -> bool:
    """Whether a node shows that what it is part of is an angle, and no index: θ, π, 90°."""
    is_letter = isinstance(node, n.Name) and (node.base in ANGLE_LETTERS or node.key == "pi")
    return is_letter or (isinstance(node, n.Postfix) and node.operator == "deg")


def _arguments(item: Item) -> tuple[n.Node, ...]:
    """Return what stands in brackets, between the commas."""
    if isinstance(item.node, n.Sequence):
        return item.node.items
    return (item.node.inner,) if isinstance(item.node, n.Group) else ()


def _is_constant(node: n.Node) -> bool:
    """Whether a tree is made of numbers, π and degrees alone."""
    return _is_of_angles(node) and not any(isinstance(b, n.Name) and b.key != "pi" for b in n.walk(node))


def _is_of_angles(node: n.Node) -> bool:
    """Whether a tree is made of numbers, π, degrees and angles alone."""
    return all(
        isinstance(below, n.Number | n.Sum | n.Product | n.Quotient | n.Group)
        or (isinstance(below, n.Postfix) and below.operator == "deg")
        or (isinstance(below, n.Name) and (below.key == "pi" or (below.base in ANGLE_LETTERS and not below.dots)))
        for below in n.walk(node)
    )
