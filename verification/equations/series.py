r"""Sums and products over an index with known limits: \sum_{i=1}^{2} l_i c_i is l_1 c_1 + l_2 c_2.

Both reach over all factors behind the sign, as far as the next + or −. Where the limits are not known, where a sign stands
in the index's way (2i in a script) or a product holds a factor without its index, the sign stays, and nothing is decided.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

MOST_TERMS = 12
MOST_READ = 200  # terms of a statement, with those of sums in sums
_SIGNS = {"\\sum": "+", "\\prod": ""}
_LIMIT = regex(r"\s*(?:\\limits(?![A-Za-z]))?\s*(?P<mark>[_^])\s*(?:\{(?P<braced>[^{}]*)\}|(?P<single>[^\\{}\s]))")
_FROM = regex(r"\s*([ijkm])\s*=\s*(\d)\s*")
_TO = regex(r"\s*(?:(\d{1,2})|([nN])\s*(?:([+-])\s*(\d))?)\s*")
_PRODUCT = regex(r"\\prod\s*_\{\s*(?P<index>[ijk])\s*=\s*1\s*\}\s*\^\{?\s*(?P<last>[nN])\s*\}?")
_SCRIPT = regex(r"[_^]\s*(?:\{(?P<braced>(?:[^{}]|\{[^{}]*\})*)\}|(?P<single>[A-Za-z0-9]))")


@dataclass(frozen=True)
class _Limits:
    """An index with its first and last number; `end` is where what the sign reaches over begins."""

    index: str
    numbers: range
    end: int


def written_out(statement: n.Statement, latex: str, names: Names) -> n.Statement:
    """Return a statement with the terms of its sums and products; `latex` is the display in which its nodes have their places."""
    if not isinstance(statement, n.Chain) or not any(isinstance(below, n.Dots) for below in n.walk(statement)):
        return statement
    terms = _Terms(latex, names, [])
    return replace(statement, members=tuple(map(terms.of, statement.members)))


def unless_added(outcome: Outcome, quantity_of: Callable[[n.Node], Quantity | None]) -> Outcome:
    """Leave open p_n = Σ p_i and ω_n = Σ ω_i where they are refuted: their terms may be what one link or one joint adds."""
    sides = outcome.nodes if outcome.verdict is Verdict.REFUTED else []
    for whole, terms in (sides, sides[::-1]) if len(sides) == 2 else ():
        meant = quantity_of(whole)
        names = n.names(terms)
        name = next((each for each in names if meant is not None and _is_alike(quantity_of(each), meant)), None)
        if name is not None:
            return outcome.left_open(say(Kind.MAY_BE_ADDED, name=name.text))
    return outcome


def _is_alike(one: Quantity | None, other: Quantity) -> bool:
    """Whether two quantities are of one kind and frame, and seen from one frame but for velocities."""
    same = one is not None and (one.kind, one.frame) == (other.kind, other.frame)
    return same and (other.kind == "velocity" or one.reference == other.reference)  # type: ignore[union-attr]


@dataclass(frozen=True)
class _Terms:
    """Writes the sums and products of a piece of LaTeX out; `read` are the terms so far, with those of sums in sums."""

    text: str
    names: Names
    read: list[str]

    def of(self, node: n.Node) -> n.Node:
        """Return a tree with its sums and products written out, those that are not clear as they stand."""
        if _open_sign(node)[1] is not None:
            return self._series(node) or node
        return n.substitute_each(node, {id(below): self.of(below) for below in n.children(node)})

    def _series(self, node: n.Node) -> n.Node | None:
        """Return l \\sum a_i b_i as l (a_1 b_1 + …); None where no sign stands open to its end, or it is not clear."""
        before, sign = _open_sign(node)
        limits = self._limits(sign) if sign is not None else None
        if sign is not None and limits is None and self.names.arm is None and not before:
            return self._of_any_length(sign, node)
        if sign is None or limits is None or limits.end >= node.span[1]:
            return None
        terms = self._instances(limits, node.span[1])
        operator = _SIGNS[self._mark(sign)]
        if terms is None or (not operator and not self._all_count(node, sign, limits)):
            return None
        whole: n.Node = n.Sum(tuple(("+", term) for term in terms)) if operator else _product(terms)
        whole = n.placed(whole, (sign.span[0], node.span[1]))
        return _product([*before, whole], node.span) if before else whole

    def _mark(self, sign: n.Dots) -> str:
        return self.text[slice(*sign.span)].strip()

    def _limits(self, sign: n.Dots) -> _Limits | None:
        if self._mark(sign) not in _SIGNS:
            return None
        said: dict[str, str] = {}
        end = sign.span[1]
        while (found := _LIMIT.match(self.text, end)) is not None and found["mark"] not in said:
            said[found["mark"]] = found["braced"] or found["single"] or ""
            end = found.end()
        first, last = _FROM.fullmatch(said.get("_", "")), self._last(said.get("^", ""))
        if first is None or last is None:
            return None
        numbers = range(int(first[2]), last + 1)
        return _Limits(first[1], numbers, end) if 0 < len(numbers) <= MOST_TERMS else None

    def _of_any_length(self, sign: n.Dots, node: n.Node) -> n.Node | None:
        """Return Π A_i^{i-1} from 1 to n as A_1^0 A_2^1 ⋯ A_n^{n-1}, as a document without an arm writes it out."""
        found = _PRODUCT.match(self.text, sign.span[0])
        text = self.text[found.end() : node.span[1]] if found is not None else ""
        terms = [self._instance(text, found["index"], number) for number in (1, 2)] if found is not None else []
        last = self._read(_letter(found["index"]).sub(found["last"], text)) if found is not None else None
        if found is None or last is None or None in terms or not isinstance(last, n.Name | n.Call):
            return None
        return _product([*terms, n.Dots(span=sign.span), last], (sign.span[0], node.span[1]))  # type: ignore[list-item]

    def _last(self, text: str) -> int | None:
        """Return the number that an upper limit is, n being the number of joints."""
        found = _TO.fullmatch(text)
        if found is None or found[1]:
            return int(found[1]) if found is not None else None
        count = _count_of_joints(self.names, found[2])
        return None if count is None else count + int(f"{found[3] or '+'}{found[4] or 0}")

    def _instances(self, limits: _Limits, end: int) -> list[n.Node] | None:
        """Return what stands behind a sign for each number of its index, or None where it is not clear."""
        text = self.text[limits.end : end]
        open_braces = text.count("{") - text.count("}")  # what stands in braces ends before they do
        text += "}" * open_braces
        read = [self._instance(text, limits.index, number) for number in limits.numbers]
        terms = [node for node in read if node is not None]
        return terms if len(terms) == len(read) else None

    def _instance(self, text: str, index: str, number: int) -> n.Node | None:
        spelt = _with_number(text, index, number)
        if spelt is None or len(self.read) >= MOST_READ:
            return None
        return self._read(spelt)

    def _read(self, spelt: str) -> n.Node | None:
        self.read.append(spelt)
        try:
            return _Terms(spelt, self.names, self.read).of(self.names.reader.read_expression(spelt))
        except ReadError:
            return None

    def _all_count(self, node: n.Node, sign: n.Dots, limits: _Limits) -> bool:
        """Whether each factor behind the sign of a product holds its index: nobody knows how far Π T_i p reaches."""
        factors = node.factors if isinstance(node, n.Product) and "×" not in node.operators else ()
        behind = factors[factors.index(sign) + 1 :] if sign in factors else ()
        spans = [slice(max(each.span[0], limits.end), each.span[1]) for each in behind]
        return bool(spans) and all(_letter(limits.index).search(self.text[span]) for span in spans)


def _open_sign(node: n.Node) -> tuple[list[n.Node], n.Dots | None]:
    """Return the factors before a sign that is open to the end of a tree, and the sign: in a product, a × or a slash behind it."""
    if isinstance(node, n.Product):
        if (at := next((k for k, each in enumerate(node.factors) if isinstance(each, n.Dots)), None)) is not None:
            between = node.operators[:at]
            return ([*node.factors[:at]], node.factors[at]) if "×" not in between else ([], None)  # type: ignore[return-value]
        return _open_sign(node.factors[0]) if node.operators == ("×",) else ([], None)
    if isinstance(node, n.Quotient) and node.style == "slash":
        return _open_sign(node.numerator)
    return [], None


def _product(factors: Sequence[n.Node], span: tuple[int, int] = (0, 0)) -> n.Node:
    return factors[0] if len(factors) == 1 else n.Product(tuple(factors), ("",) * (len(factors) - 1), span=span)


def _count_of_joints(names: Names, letter: str) -> int | None:
    """Return how many joints an arm has that is known as a whole, each with a frame; None where n may be something else."""
    arm = names.arm
    if arm is None or names.is_part or letter in names.state.definitions or names.known_symbol(letter) is not None:
        return None
    count = len(arm.joints)
    return count if numbered_frames(arm)[-1] == str(count) else None


def _letter(index: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![A-Za-z\\]){index}(?![A-Za-z])")


def _with_number(text: str, index: str, number: int) -> str | None:
    """Return LaTeX with a number for an index: in a script i - 1 becomes one number, elsewhere (1) - 1; None where that is not clear."""
    letter = _letter(index)
    if re.search(rf"(?<![A-Za-z\\]){index}\s*=", text):
        return None  # the index of a sum within
    shifted = re.compile(rf"{letter.pattern}\s*([+-])\s*(\d)(?!\d)")
    unclear = re.compile(
        rf"\d\s*{letter.pattern}|{letter.pattern}\s*\d|[A-Za-z]{index}(?![A-Za-z])|(?<![A-Za-z\\]){index}[A-Za-z]"
    )
    written: list[str] = []
    end = 0
    for found in _SCRIPT.finditer(text):
        script = found["braced"] if found["braced"] is not None else found["single"]
        if unclear.search(re.sub(r"\\[A-Za-z]+", " ", script)):
            return None
        numbers = [number + int(f"{each[1]}{each[2]}") for each in shifted.finditer(script)]
        if min(numbers, default=0) < 0:
            return None
        script = letter.sub(str(number), shifted.sub(lambda each: str(number + int(f"{each[1]}{each[2]}")), script))
        written += [letter.sub(f"({number})", text[end : found.start()]), f"{found.group()[0]}{{{script}}}"]
        end = found.end()
    return "".join([*written, letter.sub(f"({number})", text[end:])])
