"""Indexed names and what stands above and below an operand: which scripts are part of a name, and which act on it."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Sequence as Seq
from dataclasses import replace
from fractions import Fraction

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import greek
from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import OPERATORS, Item, Script
from armproof.verification.latex.tokens import Spelling, canonical_script
from armproof.verification.latex.units import UNIT, UNKNOWN
from armproof.verification.patterns import regex

MAX_EXPONENT = 24
TRANSFORM_LETTERS = frozenset("TAHR")
VECTOR_LETTERS = frozenset(
    ["p", "P", "z", "Z", "O", "o", "x", "y", "X", "Y", "J", "v", "V", "omega", "Omega", "W", "w"]
)
_BRANCHES = ("(+)", "(-)", "(pm)", "(mp)")  # marks of a solution's branch: θ_2^{(+)}
_OF_TWO = regex(r"\d,?\d")
# of a frame, a solution, a step: no power
_IN_BRACKETS = regex(r"\((?:\d|[ijkn](?:[+-]\d)?|(?P<word>[A-Za-z]{1,10}))\)")
# in brackets too: the transpose, and an exponent that is a Greek letter
_ACTS = frozenset([*OPERATORS, "H", *greek.GREEK])
_CENTRES = ("cm", "mm")  # what would be units above a number
_PLACED = regex(r"(\w+)\((\d)\)")
_BETWEEN_VALUES = regex(r"(?:,|\\[,;]|\\quad|\\\\)(?![^(\[]*[)\]])")  # and not between those of (0, 0)
_FRAME_BEHIND = regex(r"[A-Zijkn\d]|[ijkn][-+]\d")
_SPELT_WORD = regex(r"(?=[A-Za-z]*[aeiouy])(?=[A-Za-z]*[^aeiouyA-Z])[A-Za-z][a-z]{3,9}")
_WORD = regex(r"\s*\\(?:text[a-z]*|mathrm|mathit|mathsf|operatorname)\s*\{\s*[A-Za-z]{2,}\s*\}\s*")
_SIZE = regex(r"\(?\dx[1-9n]\)?")
_MASS_CENTRE = r"(?:[cCgGmM]|cm|CM|com|COM)_?,?\d"
_AT_POINT = regex(r"\\end\s*\{(?:(?:[bpvV]?matrix|array)\}\s*(?:\\right\s*)?\\\}|Bmatrix\})\s*_\s*(?:\{[^{}]*\}|\w)\Z")
_NO_SIZE = regex(r"\(?(?:0x\d+|\d+x0)\)?")  # no matrix is 0×1
_NOTED_SIZE = regex(r"\(?(?:\dx[1-9nm]|[nm]x[1-9nm])\)?")
_NOTED_BASE = regex(r"[(/]?(?:[RFOKS]_?)?(?:0|b|B|w|W|base|world)\)?|\(?x,?y,?z\)?")
_JOINT_LETTERS = frozenset([*greek.ANGLES, "q"])
_SIZED = frozenset(["I", "Id", "E", "O", "J"])  # whose size is part of the name, or a claim


# a star marks a joint variable in a table, or its cosine; over another letter it makes another name
STARRED = frozenset(["theta", "q", "d", "r", "a", "alpha", "l", "L", "phi", "beta", "gamma", "c", "s", "C", "S"])


class NameReader:
    """Reads items with their scripts; `parse` reads a piece of LaTeX, `is_bound` tells the names the front matter binds."""

    def __init__(
        self, text: str, is_bound: Callable[[str], bool], parse: Callable[[str, int], n.Node], spelling: Spelling
    ) -> None:
        self.spelling = spelling
        self.text = text
        self.is_bound = is_bound
        self.parse = parse

    def scripted(self, node: n.Node, scripts: Seq[Script], start: int) -> n.Node:
        """Apply what stands above an operand that is not a name: a power, a transpose, an inverse."""
        if isinstance(node, n.Dots):  # \\prod_{i=1}^{n}: which terms are meant is left to the reader
            return node
        for kind, text, span in scripts:
            if kind == "AT":
                node = n.At(node, self.configuration(text, span), span=(start, span[1]))
                continue
            if kind == "PRIME":
                raise ReadError(say(Kind.PRIME_ON_EXPRESSION), span[0])
            if text.startswith(UNIT):
                node = self._measured(node, text.removeprefix(UNIT), (start, span[1]))
                continue
            canonical = canonical_script(text)
            if kind == "SUB":
                size = re.fullmatch(r"\(?([1-9])x([1-9])\)?", canonical)
                if size and isinstance(node, n.Number) and node.value == 0:  # 0_{3×1}
                    node = n.Matrix(
                        ((node,) * int(size.group(2)),) * int(size.group(1)), "zeros", span=(start, span[1])
                    )
                node = self.noted(node, canonical, (start, span[1]))
                continue
            if canonical in ("T", "top", "t") and (row := _spaced_row(node)) is not None:
                node = row
            whole = (start, max(span[1], node.span[1]))  # \\sin^2(x): the power stands before the argument
            node = self._raise_to(node, text, canonical, whole, span)
        return node

    def _measured(self, node: n.Node, unit: str, span: tuple[int, int]) -> n.Node:
        """Return a number with its unit: of one that is not known nobody knows the value."""
        if unit.startswith(UNKNOWN):
            return n.Name("words", text=self.text[slice(*span)], span=span)
        matrix = n.ungrouped(node)
        if isinstance(matrix, n.Matrix) and all(map(n.is_number, matrix.cells)):  # (600, 0) mm: each of its numbers
            rows = tuple(tuple(n.Postfix(cell, unit, span=cell.span) for cell in row) for row in matrix.rows)
            return replace(matrix, rows=rows, span=span)
        return n.Postfix(node, unit, span=span)

    def noted(self, node: n.Node, note: str, span: tuple[int, int]) -> n.Node:
        """Return an operand with a note under it: its size, its frame and ‖·‖_2 change nothing, of others nobody knows the value."""
        if isinstance(node, n.Power) and isinstance(node.base, n.Call) and node.base.function == "norm":
            return replace(node, base=self.noted(node.base, note, span), span=span)
        if _NO_SIZE.fullmatch(note):
            return n.Name("words", note, text=self.text[slice(*span)], span=span)
        if _AT_POINT.search(self.text, *span):  # a torsor in braces, and its point
            return n.Name("words", note, text=self.text[slice(*span)], span=span)
        is_printed = isinstance(n.ungrouped(node), n.Matrix) or isinstance(node, n.Sequence)
        is_zero = isinstance(node, n.Matrix) and node.environment == "zeros"
        if is_printed and not is_zero and (size := re.fullmatch(r"\(?([1-9])x([1-9])\)?", note)):  # a claim of its size
            return n.Labelled(node, None, (int(size[1]), int(size[2])), "", span=span)
        is_norm = n.is_call(node, "norm")
        if (is_norm and note == "2") or _NOTED_SIZE.fullmatch(note) or (is_printed and _NOTED_BASE.fullmatch(note)):
            return node
        if note == "(0)" or (isinstance(node, n.Number) and node.value == 0):  # seen from frame 0; 0_3, a zero vector
            return node
        if isinstance(node, n.Group) and node.brackets == "()" and note in tuple("xyz"):  # (ω_e)_x; [ω]_x is a matrix
            row = tuple(n.Number(Fraction(int(axis == note)), span=node.span) for axis in "xyz")
            return n.Product((n.Matrix((row,), span=node.span), node), ("", ""), span=span)
        if is_norm and note in ("F", "Fro"):
            return replace(node, function="frobenius", span=span)  # type: ignore[call-arg]
        return n.Name("words", note, text=self.text[slice(*span)], span=span)

    def configuration(self, text: str, span: tuple[int, int]) -> tuple[tuple[n.Node, n.Node], ...]:
        """Return the names and values of a configuration: θ_2 = 0, a_2 = a_1."""
        offset = self.text.find(text, span[0])
        values = [part.split("=") for part in _BETWEEN_VALUES.split(text) if part.strip()]
        if not values or any(len(sides) == 1 for sides in values):
            raise ReadError(say(Kind.NO_VALUES_SAID, text=text), span[0])
        return tuple(
            (self.parse(name, offset), self.parse(value, offset))
            for *names, value in values  # θ_1 = θ_2 = 0
            for name in names
        )

    def _raise_to(
        self, node: n.Node, text: str, canonical: str, whole: tuple[int, int], span: tuple[int, int]
    ) -> n.Node:
        if canonical == "" and (not isinstance(node, n.Call) or self.spelling.starred):
            raise ReadError(say(Kind.STAR_ON_EXPRESSION), span[0])
        if canonical == "":  # above a cosine: that of a joint variable
            return replace(node, span=whole)
        if canonical in OPERATORS:
            return n.Postfix(node, OPERATORS[canonical], span=whole)
        if canonical == "0" and isinstance(node, n.Call) and node.head == "s" and node.style == "index":
            angles = node.arguments[0]  # s_6^0 stands beside n_6^0 and a_6^0: no sine is raised to nothing
            digits = "".join(str(index) for _, index in angles.terms) if isinstance(angles, n.JointAngles) else ""
            return n.Name("s", digits, "0", text=self.text[whole[0] : whole[1]], span=whole)
        exponent = self.parse(text, self.text.find(text, span[0]))
        if isinstance(exponent, n.Number) and exponent.value > MAX_EXPONENT:
            raise ReadError(say(Kind.LARGE_EXPONENT, exponent=exponent.text, most=MAX_EXPONENT), span[0])
        return n.Power(node, exponent, span=whole)

    def name(self, item: Item) -> n.Node:
        """An indexed name with its scripts; what is an operator or a power above it is applied to it."""
        pre_sub = pre_sup = ""
        for kind, text, _ in item.pre:
            if kind == "SUB":
                pre_sub = canonical_script(text)
            else:
                pre_sup = canonical_script(text)
        sub = sup = ""
        primes = dots = 0
        end = self._end_of_base(item)
        above: list[Script] = []
        below = ",".join(canonical_script(text) for kind, text, _ in item.scripts if kind == "SUB")
        for kind, text, span in item.scripts:
            canonical = canonical_script(text)
            if kind == "SUB" and item.base in VECTOR_LETTERS and (placed := _PLACED.fullmatch(canonical)):
                canonical, pre_sup = placed[1], placed[2]  # z_{1(0)} is {}^0z_1
            if kind == "PRIME":
                primes += len(text)
            elif kind == "DOT":
                dots += 1
            elif kind == "AT":
                above.append((kind, text, span))
                continue
            elif kind == "SUB" and _SIZE.fullmatch(canonical) and item.base not in _SIZED:
                pass  # R_{3×3}: how large it is
            elif kind == "SUB":
                sub = f"{sub},{canonical}" if sub else canonical
            elif self._is_index(item.base, canonical, below, bool(item.pre)) or _is_word(text, canonical):
                sup = f"{sup},{canonical}" if sup else canonical
            elif canonical == "" and item.base in STARRED and not self._has_own_star(item.base, below):
                pass
            elif canonical == "":
                sup = "*"
            else:
                above.append((kind, text, span))
                continue
            end = max(end, span[1])
        if item.base in TRANSFORM_LETTERS and pre_sup and not (pre_sub or sup):
            sub = _without_reference(sub, pre_sup)
        end = max(end, item.end if not above else end)
        text = self.text[item.start : end]
        name: n.Node = n.Name(item.base, sub, sup, pre_sub, pre_sup, primes, dots, text, span=(item.start, end))
        return self.scripted(name, above, item.start)

    def _has_own_star(self, base: str, sub: str) -> bool:
        """Whether a star makes another name of this one in the document."""
        return (f"{base}_{sub}" if sub else base) in self.spelling.starred

    def _end_of_base(self, item: Item) -> int:
        """Return where an item's letter ends: before the mark of its first script, as \\lambda does in \\lambda^{2}."""
        if not item.scripts:
            return item.end
        head = self.text[item.start : item.scripts[0][2][0]]
        letter = re.sub(r"\s*(?:\{\s*\})?\s*[_^]?\s*\{?\s*$", "", head)
        return item.start + max(1, len(letter))

    def _is_index(self, base: str, canonical: str, sub: str, prescripted: bool) -> bool:
        """Whether what stands above a name is part of the name (T^0_1, P^0_{1,G}) and not a power or an operator."""
        if not canonical:
            return False
        key = f"{base}_{sub}^{canonical}" if sub else f"{base}^{canonical}"
        if self.is_bound(key):
            return True
        if base != "e" and is_bracketed_index(canonical):
            return True
        if canonical in _CENTRES or (sub and base in _JOINT_LETTERS and _is_spelt_word(canonical)):
            return True
        if canonical in OPERATORS:
            return False
        if base in TRANSFORM_LETTERS and sub and not prescripted and re.fullmatch(r"\w'+", canonical):
            return True  # T_i^{i'}: a frame between two
        if not re.fullmatch(r"[A-Za-z0-9_,]+(?:[-+]\d)?", canonical):
            return False
        if canonical == "0":
            return True
        digits = canonical.isdigit()
        if digits and (f"{base}_{sub}" in self.spelling.lengths or (base in tuple("xyz") and _OF_TWO.fullmatch(sub))):
            return False  # x_{14} names both frames: x_{14}^2 is its square
        if base in TRANSFORM_LETTERS and sub and not prescripted:
            return True
        if base in VECTOR_LETTERS and sub and not prescripted:
            of_frame = sub[:1].isdigit() or bool(re.match(r"[a-zA-Z]-\d", sub))
            of_frame = of_frame or (base in ("v", "V") and re.fullmatch(_MASS_CENTRE, sub) is not None)  # v_{c1}^2
            return not digits or (of_frame and not re.search(r"[xyzXYZ]$", sub))
        return not digits and bool(sub) and len(canonical) <= 3 and canonical not in ("n", "k", "m")


def _without_reference(sub: str, reference: str) -> str:
    """Return the frame of {}^0T_{04} and {}^{i-1}T_{i-1,i}, whose index tells once more from where it is seen."""
    frame = sub.removeprefix(reference)
    is_said_twice = frame != sub and (_FRAME_BEHIND.fullmatch(frame) is not None or frame[:1] == ",")
    return frame.lstrip(",") or sub if is_said_twice else sub


def is_bracketed_index(canonical: str) -> bool:
    """Whether what stands above a letter in brackets names a solution, a step or a frame: (2), (a), (II), (up), (+).

    Nobody puts an exponent of one letter in brackets; that of e, and the transpose, act as they do without.
    """
    found = _IN_BRACKETS.fullmatch(canonical)
    return canonical in _BRANCHES or (found is not None and found["word"] not in _ACTS)


def _is_spelt_word(canonical: str) -> bool:
    """Whether letters above an angle spell a word, and are no product of exponents: θ_2^{down}, q_1^{elbow}."""
    return canonical not in _ACTS and _SPELT_WORD.fullmatch(canonical) is not None


def _is_word(text: str, canonical: str) -> bool:
    """Whether a word in upright letters stands above a name, p^{\\text{des}}: no power, and no operator."""
    return canonical not in OPERATORS and _WORD.fullmatch(text) is not None


def _spaced_row(node: n.Node) -> n.Sequence | None:
    """[q_1 q_2]^T is a row of entries set off by blanks, for a product has no transpose."""
    if (
        not isinstance(node, n.Group)
        or node.brackets != "[]"
        or not isinstance(node.inner, n.Product)
        or any(node.inner.operators)
    ):
        return None
    plain = all(isinstance(factor, n.Name | n.Number | n.Call) for factor in node.inner.factors)
    return n.Sequence(node.inner.factors, "[]", span=node.span) if plain else None
