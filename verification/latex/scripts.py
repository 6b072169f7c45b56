"""What stands above and below an operand: powers, transposes, inverses, sizes."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Sequence as Seq
from dataclasses import replace

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import OPERATORS, Script
from armproof.verification.latex.tokens import canonical_script

MAX_EXPONENT = 24


class ScriptReader:
    """Applies scripts to operands; `parse` reads a piece of LaTeX, `is_bound` tells the names the front matter binds."""

    def __init__(self, text: str, is_bound: Callable[[str], bool], parse: Callable[[str, int], n.Node]) -> None:
        self.text = text
        self.is_bound = is_bound
        self.parse = parse

    def scripted(self, node: n.Node, scripts: Seq[Script], start: int) -> n.Node:
        """Apply what stands above an operand that is not a name: a power, a transpose, an inverse."""
        if isinstance(node, n.Dots):  # \\prod_{i=1}^{n}: which terms are meant is left to the reader
            return node
        for kind, text, span in scripts:
            if kind == "AT":
                if not (values := self.configuration(text, span)):
                    raise ReadError(say(Kind.NO_VALUES_SAID, text=text), span[0])
                node = n.At(node, values, span=(start, span[1]))
                continue
            if kind == "PRIME":
                raise ReadError(say(Kind.PRIME_ON_EXPRESSION), span[0])
            canonical = canonical_script(text)
            if kind == "SUB":
                size = re.fullmatch(r"\(?(\d)x(\d)\)?", canonical)
                if size and isinstance(node, n.Number) and node.value == 0:  # 0_{3×1}
                    node = n.Matrix(
                        ((node,) * int(size.group(2)),) * int(size.group(1)), "zeros", span=(start, span[1])
                    )
                    continue
                if isinstance(node, n.Matrix | n.Group | n.Sequence | n.Call | n.Number) or canonical.startswith("("):
                    continue  # a size or frame note under a matrix, such as _{3×1} or _{(0)}
                raise ReadError(say(Kind.SUBSCRIPT_ON_EXPRESSION, script=canonical), span[0])
            if canonical in ("T", "top", "t") and (row := _spaced_row(node)) is not None:
                node = row
            whole = (start, max(span[1], node.span[1]))  # \\sin^2(x): the power stands before the argument
            node = self._raise_to(node, text, canonical, whole, span)
        return node

    def configuration(self, text: str, span: tuple[int, int]) -> tuple[tuple[n.Node, n.Node], ...]:
        """Return the names and values of a configuration: θ_2 = 0, a_2 = a_1."""
        values: list[tuple[n.Node, n.Node]] = []
        offset = self.text.find(text, span[0])
        for part in re.split(r",|\\[,;]|\\quad|\\\\", text):
            if "=" in part:
                left, right = part.split("=", 1)
                values.append((self.parse(left, offset), self.parse(right, offset)))
        return tuple(values)

    def _raise_to(
        self, node: n.Node, text: str, canonical: str, whole: tuple[int, int], span: tuple[int, int]
    ) -> n.Node:
        if canonical == "":  # a star
            return replace(node, span=whole)
        if canonical in OPERATORS:
            return n.Postfix(node, OPERATORS[canonical], span=whole)
        exponent = self.parse(text, self.text.find(text, span[0]))
        if isinstance(exponent, n.Number) and exponent.value > MAX_EXPONENT:
            raise ReadError(say(Kind.LARGE_EXPONENT, exponent=exponent.text, most=MAX_EXPONENT), span[0])
        return n.Power(node, exponent, span=whole)


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
