"""Runs of juxtaposed items: which is a factor, which the function of the next, which the argument of the one before."""

from __future__ import annotations

import re
from collections.abc import Sequence as Seq
from itertools import pairwise

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.calls import CallReader
from armproof.verification.latex.greek import ANGLES
from armproof.verification.latex.indexed import TRANSFORM_LETTERS
from armproof.verification.latex.items import OPERATORS, DerivativeOperator, Differential, Item, Script
from armproof.verification.latex.tokens import canonical_script
from armproof.verification.latex.vocabulary import LABEL_WORDS
from armproof.verification.patterns import regex

_WHOLE = ("q", "theta", "Theta")  # all joint variables at once
_SIZE_BEHIND = regex(r"(?:\\[,;:! ]|\\q?quad|[,~\s])*(?:(?<=[,;])|\()\s*(\d)\s*\\times\s*(\d)\s*\)?\s*$")
_WORDS = regex(r"\s*\\(?:text[a-z]*|mbox|hbox|mathrm|mathit)\s*\{[^{}=\\$]*\}\s*")

_STYLED = regex(r"\\[A-Za-z]+")


class RunReader(CallReader):
    """Reads a run of items as factors."""

    def read(self, items: list[Item]) -> list[n.Node]:
        """Return the factors of a run."""
        items = reassociate([_named(item, self.text) for item in attach_trailing(items)])
        factors: list[n.Node] = []
        index = 0
        while index < len(items):
            node, index = self.next_factor(items, index)
            factors.append(node)
        return self._with_mixed(factors)

    def _with_mixed(self, factors: list[n.Node]) -> list[n.Node]:
        r"""Let 1\tfrac12 be one and a half, or a product."""
        if len(factors) < 2 or not _is_mixed(*factors[:2]):
            return factors
        whole, part = factors[:2]
        span = span_of(factors[:2])
        readings = (n.Group(n.Sum((("+", whole), ("+", part)), span=span), span=span), product(factors[:2]))
        sort = "mixed" if len(factors) == 2 else "mixed factor"
        return [n.Ambiguous(readings, self.text[slice(*span)], sort, span=span), *factors[2:]]

    def next_factor(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        """Return the factor that begins at an item, and where the next one does."""
        item = items[index]
        if item.kind == "function":
            return self.call(items, index)
        if item.kind == "partial":
            order = next((int(text) for kind, text, _ in item.scripts if kind == "SUP" and text in ("2", "3")), 1)
            if index + 1 == len(items):
                return Differential(None, order, span=(item.start, item.end)), index + 1
            operand, after = self.next_factor(items, index + 1)
            rest = [operand]
            while after < len(items):
                more, after = self.next_factor(items, after)
                rest.append(more)
            whole = product(rest)
            return Differential(whole, order, span=(item.start, whole.span[1])), after
        if item.kind == "letter":
            return self._letter_factor(items, index)
        if item.kind == "labelled":
            return self._labelled(item), index + 1
        if item.kind == "evaluated":
            return self._evaluated(item), index + 1
        assert item.node is not None
        if isinstance(item.node, DerivativeOperator):
            if index + 1 == len(items):
                raise ReadError(say(Kind.DERIVATIVE_OF_NOTHING), item.start)
            operand, after = self.next_factor(items, index + 1)
            return n.Derivative(operand, item.node.variable, item.node.order, span=(item.start, operand.span[1])), after
        following = items[index + 1] if index + 1 < len(items) else None
        if _is_applied(item, following):  # ∂x/∂q_1(q)
            assert item.node is not None
            return item.node, index + 2
        if isinstance(item.node, n.Name) and not item.scripts and following is not None and following.kind == "list":
            applied = self.application(item.node, following)  # {T_1^0}(θ_1)
            if applied is not None:
                return applied, index + 2
        return self.scripted(item.node, item.scripts, item.start), index + 1

    def _labelled(self, item: Item) -> n.Node:
        label: n.Node | None = None
        size: tuple[int, int] | None = None
        unread = ""
        for kind, text, span in item.scripts:
            if found := re.fullmatch(r"\(?(\d+)x(\d+)\)?", canonical_script(text)):
                size = (int(found.group(1)), int(found.group(2)))
                continue
            if found := _SIZE_BEHIND.search(text):  # {J \; (2 \times 3)}: a product of numbers stands behind no name
                size = (int(found.group(1)), int(found.group(2)))
                text = text[: found.start()]
            if kind in ("SUB", "SUP"):
                label, unread = self._label(text, span)
        assert item.node is not None
        return n.Labelled(item.node, label, size, unread, span=(item.start, item.end))

    def _label(self, text: str, span: tuple[int, int]) -> tuple[n.Node | None, str]:
        """Return what a brace's label equates to what it embraces, and the label that cannot be read; words and counts are neither."""
        plain = re.sub(r"^\s*(?:=|\\equiv(?![A-Za-z]))\s*", "", text)
        try:
            label = self.parse(plain, self.text.find(plain, span[0]))
        except ReadError:
            return None, "" if self._is_harmless(text) else text
        if _WORDS.fullmatch(text):
            return None, "" if self._is_harmless(text) else text
        number = n.ungrouped(label)
        if plain == text and isinstance(number, n.Number) and number.value != 0:
            return None, ""
        return label, ""

    def _is_harmless(self, text: str) -> bool:
        """Whether a brace's label is plain words for a part, "term 1", "height", that claim nothing of its value."""
        words = re.findall(r"[^\W\d_]{2,}", _STYLED.sub(" ", text).lower())
        return _WORDS.fullmatch(text) is not None and all(word in LABEL_WORDS for word in words)

    def _evaluated(self, item: Item) -> n.Node:
        """Read F|_{θ_2 = 0}; what else stands at a bar without a first one, as an integral's limits do, has no meaning here."""
        kinds = [kind for kind, *_ in item.scripts]
        if kinds != ["SUB"]:
            raise ReadError(say(Kind.NO_VALUES_SAID, text=self.text[item.start : item.end]), item.start)
        assert item.node is not None
        _, text, span = item.scripts[0]
        return n.At(item.node, self.configuration(text, span), span=(item.start, item.end))

    def _letter_factor(self, items: Seq[Item], index: int) -> tuple[n.Node, int]:
        item = items[index]
        following = items[index + 1] if index + 1 < len(items) else None
        trig = self.trig_letter(item, following)
        if trig is not None:
            return trig[0], index + trig[1]
        if (
            item.base in ("R", "T", "D", "Tr", "Ro")
            and following is not None
            and following.kind == "list"
            and not item.pre
        ):
            axis = next((canonical_script(text) for kind, text, _ in item.scripts if kind == "SUB"), "")
            if (
                re.fullmatch(r"[xyzXYZ](_.*)?|[xyz],.*", axis)
                and len(item.scripts) == 1
                and isinstance(following.node, n.Group)
                and not (item.base != "R" and _is_angle(following.node.inner))  # T_x(θ) is a name of the author's own
            ):
                function = "Rot3" if item.base == "R" else "Trans"
                axis_name = n.Name(axis[0].lower(), span=item.scripts[0][2])
                head = self.text[item.start : item.end]
                call = n.Call(
                    function, (axis_name, following.node.inner), head, "script", span=(item.start, following.end)
                )
                return self.scripted(call, following.scripts, item.start), index + 2
        elementary = self.elementary_letter(item)
        if elementary is not None:
            return elementary, index + 1
        if (between := _between_frames(item, following)) is not None:
            return self.name(between), index + 2
        name = self.name(item)
        if following is not None and following.kind == "list" and not following.pre:
            applied = self.application(name, following)
            if applied is not None:
                return applied, index + 2
        return name, index + 1


def _is_mixed(whole: n.Node, part: n.Node) -> bool:
    """Whether a whole number stands before a fraction of two that is less than one."""
    if not isinstance(part, n.Quotient) or part.style != "frac":
        return False
    numbers = [each for each in (whole, part.numerator, part.denominator) if isinstance(each, n.Number)]
    if len(numbers) < 3 or not all(each.text.isdigit() for each in numbers):
        return False
    return numbers[0].value > 0 and 0 < numbers[1].value < numbers[2].value


def _is_angle(node: n.Node) -> bool:
    return isinstance(node, n.Name) and node.base in ANGLES


def _named(item: Item, text: str) -> Item:
    """Return {}^0_3[T] as the name {}^0_3T: brackets around a bare letter are style where frames stand beside them.

    Of what else has a frame before it, {}^1(A_1 A_2), nobody knows the value; seen from the base is what all is.
    """
    inner = item.node.inner if isinstance(item.node, n.Group) and item.node.brackets == "[]" else None
    has_frames = bool(item.pre) or any(kind == "SUB" for kind, *_ in item.scripts)
    if item.kind == "list" and has_frames and isinstance(inner, n.Name) and inner == n.Name(inner.base):
        return Item("letter", None, item.start, item.end, inner.base, item.scripts, item.pre)
    is_seen_from_base = [(kind, canonical_script(frame)) for kind, frame, _ in item.pre] == [("SUP", "0")]
    if item.kind not in ("list", "node", "braces") or not item.pre or is_seen_from_base:
        return item
    return node_item(n.Name("words", text=text[item.start : item.end], span=(item.start, item.end)))


def _between_frames(item: Item, following: Item | None) -> Item | None:
    """Return R_{0,1} for R[0,1], or None where no such thing stands there."""
    frames = following.node if following is not None else None
    if item.base not in TRANSFORM_LETTERS or item.pre or item.scripts or not isinstance(frames, n.Sequence):
        return None
    if (
        frames.brackets != "[]"
        or len(frames.items) != 2
        or not all(isinstance(each, n.Number) for each in frames.items)
    ):
        return None
    assert following is not None
    index = ("SUB", ",".join(each.text for each in frames.items if isinstance(each, n.Number)), frames.span)
    return Item("letter", None, item.start, following.end, item.base, [index, *following.scripts])


def product(run: list[n.Node]) -> n.Node:
    """Return the one factor of a run, or the product of all."""
    if len(run) == 1:
        return run[0]
    return n.Product(tuple(run), ("",) * (len(run) - 1), span=span_of(run))


def node_item(node: n.Node) -> Item:
    """Return an item that needs nothing of its neighbours."""
    return Item("node", node, *node.span)


def scripts_before(name: n.Name, span: tuple[int, int]) -> list[Script]:
    """Return the pre-scripts of a name, as an item carries them."""
    found: list[Script] = []
    if name.pre_sub:
        found.append(("SUB", name.pre_sub, span))
    if name.pre_sup:
        found.append(("SUP", name.pre_sup, span))
    return found


def span_of(items: Seq[n.Node]) -> tuple[int, int]:
    """Return the place of a row of nodes."""
    return (items[0].span[0], items[-1].span[1])


def argument_end(text: str, end: int) -> int:
    """The end of a command whose last argument's content ends at `end`: behind its closing brace."""
    found = re.compile(r"\s*\}").match(text, end)
    return found.end() if found else end


def attach_trailing(items: list[Item]) -> list[Item]:
    """Give scripts that an empty group sets off (R{}^T) to the item before."""
    result: list[Item] = []
    for item in items:
        if item.kind == "trailing":
            result[-1].scripts.extend(item.scripts)
            result[-1].end = item.end
        else:
            result.append(item)
    return result


def reassociate(items: list[Item]) -> list[Item]:
    """Glued pre-scripts: in ^0_1T^1_2T and ^0T_1^1T_2 what follows a T that has its own belongs to the next T."""
    for here, following in pairwise(items):
        if not here.pre or here.kind != "letter" or following.kind != "letter" or following.pre:
            continue
        kinds = {kind for kind, _, _ in here.pre}
        keep: list[Script] = []
        move: list[Script] = []
        for script in here.scripts:
            index_like = canonical_script(script[1]) not in OPERATORS and script[0] in ("SUB", "SUP")
            own = script[0] not in kinds and not any(kept[0] == script[0] for kept in keep) and len(kinds) != 2
            if index_like and (move or not own or (script[0] == "SUP")):
                move.append(script)
            else:
                keep.append(script)
        if move:
            here.scripts, following.pre = keep, move
            here.end = keep[-1][2][1] if keep else move[0][2][0]
            following.start = move[0][2][0]
    return items


def _is_applied(item: Item, following: Item | None) -> bool:
    """Whether a derivative is said to be a function of all joint variables: the vector in brackets is no factor."""
    if not isinstance(item.node, n.Derivative) or item.scripts or following is None or following.kind != "list":
        return False
    inner = following.node.inner if isinstance(following.node, n.Group) else None
    return isinstance(inner, n.Name) and inner.key in _WHOLE and not following.scripts


def partial_derivative(above: Differential, below: Differential, span: tuple[int, int]) -> n.Node:
    """Return ∂f/∂x, or ∂/∂x still waiting for its operand."""
    if below.operand is None:
        raise ReadError(say(Kind.DERIVATIVE_BY_NOTHING), below.span[0])
    variables = [_powered(each) for each in _beside(below.operand)] if above.order > 1 else [(below.operand, 1)]
    if sum(order for _, order in variables) != above.order:
        raise ReadError(say(Kind.HIGHER_DERIVATIVE), below.span[0])
    if above.operand is None and len(variables) == 1:
        return DerivativeOperator(*variables[0], span=span)
    if above.operand is None:
        raise ReadError(say(Kind.HIGHER_DERIVATIVE), below.span[0])
    derived = above.operand
    for variable, order in reversed(variables):
        derived = n.Derivative(derived, variable, order, span=span)
    return derived


def _beside(node: n.Node) -> list[n.Node]:
    """Return the variables of ∂θ_1 ∂θ_2, each of which but the first stands behind a ∂ of its own."""
    last = node.factors[-1] if isinstance(node, n.Product) and not any(node.operators) else None
    if not isinstance(last, Differential) or last.operand is None or last.order != 1:
        return [node]
    return [*node.factors[:-1], *_beside(last.operand)]  # type: ignore[attr-defined]


def total_derivative(above: n.Node, below: n.Node, span: tuple[int, int]) -> n.Node | None:
    """dx/dθ, d²x/dt² and d/dt(…), written with letters (δ is also met for ∂)."""
    below_run = below.factors if isinstance(below, n.Product) else ()
    if len(below_run) != 2 or not isinstance(below_run[0], n.Name) or below_run[0].key not in ("d", "delta"):
        return None
    mark = below_run[0].key
    variable, order = _powered(below_run[1])
    if _is_mark(above, mark, order):
        return DerivativeOperator(variable, order, span=span)
    if isinstance(above, n.Product) and _is_mark(above.factors[0], mark, order):
        operand = (
            above.factors[1]
            if len(above.factors) == 2
            else n.Product(above.factors[1:], above.operators[1:], span=span_of(above.factors[1:]))
        )
        return n.Derivative(operand, variable, order, span=span)
    return None


def slashed_derivative(above: n.Node, run: Seq[n.Node], span: tuple[int, int]) -> n.Node | None:
    r"""Return the derivative in L dx/dt, with what stands before and behind it; None for another quotient."""
    factors = above.factors if isinstance(above, n.Product) else ()
    if len(factors) < 2 or any(above.operators) or len(run) < 2:  # type: ignore[attr-defined]
        return None
    begin, end = factors[-2].span[0], run[1].span[1]
    over = n.Product(factors[-2:], ("",), span=span_of(factors[-2:]))
    under = n.Product(tuple(run[:2]), ("",), span=span_of(run[:2]))
    derived = total_derivative(over, under, (begin, end))
    if derived is None:
        return None
    whole = (*factors[:-2], derived, *run[2:])
    return derived if len(whole) == 1 else n.Product(whole, ("",) * (len(whole) - 1), span=span)


def _is_mark(node: n.Node, mark: str, order: int) -> bool:
    """Whether a node is d, or d² above dt²."""
    base, power = _powered(node)
    return isinstance(base, n.Name) and base.key == mark and power == order


def _powered(node: n.Node) -> tuple[n.Node, int]:
    """Return the base and the order of x, x² or x³; of another power the node itself."""
    if isinstance(node, n.Power) and isinstance(node.exponent, n.Number) and node.exponent.value in (2, 3):
        return node.base, int(node.exponent.value)
    return node, 1
