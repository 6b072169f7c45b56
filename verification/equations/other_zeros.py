r"""Joints that a document counts from another zero: "with $\theta_1 = \theta_1' + 90^\circ$ the position is", and it goes on to write $\theta_1$.

Where it writes $\theta_1'$, that has the meaning that the equation gives it. Where it never does, the mark is left out: behind such an equation
$\theta_1$ is the one or the other, and what is printed there tells which.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from fractions import Fraction

from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import DocumentState, OtherZero
from armproof.verification.verdict import HOLDS, Role, Verdict


@dataclass(frozen=True)
class _Told:
    """θ_1 = θ_1' + 90°: the joint, the marked letter, and what that is."""

    symbol: str
    marked: n.Name
    meaning: n.Node
    turn: Fraction  # of half turns


class OtherZeros:
    """Heeds such equations of displays and of the text, and reads what is behind them."""

    def __init__(self, members: Members) -> None:
        self.members = members

    @property
    def names(self) -> Names:
        """The names of the document."""
        return self.members.names

    def heed(self, chain: n.Chain, line: int, in_text: bool) -> str:
        """Take what an equation says of a marked letter. Return that, empty where it says nothing of one."""
        if self.names.arm is None or (told := self._told(chain)) is None:
            return ""
        state, key = self.names.state, told.marked.key
        if key not in state.definitions:
            self.names.define(key, self.members.meaning(told.meaning), line, node=told.meaning, in_text=in_text)
        state.zeros = state.zeros | {told.symbol: OtherZero(told.turn, key, line)}
        return key

    def heed_display(self, chain: n.Chain, outcomes: list[Outcome], line: int) -> list[Outcome]:
        """Return the outcomes of a display, which says what a marked letter is and claims nothing."""
        if not (key := self.heed(chain, line, False)) or len(outcomes) != 1 or outcomes[0].verdict is Verdict.REFUTED:
            return outcomes
        said = say(Kind.DEFINES, name=key)
        return [replace(outcomes[0], verdict=Verdict.DEFINED, findings=(said,), defines=(key,), role=Role.DEFINITION)]

    def settled(
        self,
        chain: n.Chain,
        outcomes: list[Outcome],
        before: DocumentState,
        displays: Sequence[Display],
        again: Callable[[], list[Outcome]],
    ) -> list[Outcome]:
        """Return what holds with the marks left out, where it does not with the letters as they were; of two that do not, the nearer.

        What was defined by the letters as they were is taken back then: the state is what it was `before`. A formula in which such a joint stands
        but once may be right of the other zero by a slip, a cosine for a sine: it is left open unless another under its heading shows the marks left out.
        """
        verdicts = {each.verdict for each in outcomes}
        if not verdicts & {Verdict.REFUTED, Verdict.UNCHECKED} or any(map(self._is_written, displays)):
            return outcomes
        state = self.names.state
        after = state.copy()
        state.become(before)
        with self._counted_anew():
            second = again()
        consulted = state.consulted
        state.become(after)
        if not second or len(second) != len(outcomes):
            return outcomes
        wrong = [
            sum(len(each.wrong) or 1 for each in found if each.verdict is Verdict.REFUTED)
            for found in (outcomes, second)
        ]
        is_nearer = all(each.verdict is Verdict.REFUTED for each in outcomes) and 0 < wrong[1] < wrong[0]
        if not ({each.verdict for each in second} <= {*HOLDS} or is_nearer):
            return outcomes
        if not is_nearer and not self._tells(chain) and state.counts_anew_in != state.section:
            left_out = [
                say(Kind.MARK_LEFT_OUT, name=zero.key, symbol=key, line=zero.line) for key, zero in state.zeros.items()
            ]
            return [each.left_open(left_out[0]) if each.verdict is Verdict.REFUTED else each for each in outcomes]
        state.become(before)
        state.counts_anew_in = state.section
        state.consulted |= consulted
        for outcome in second:
            for symbol, zero in state.zeros.items():
                outcome.also(say(Kind.MARK_LEFT_OUT, name=zero.key, symbol=symbol, line=zero.line))
        return second

    def _is_written(self, display: Display) -> bool:
        """Whether a display has a marked letter, and not only to say what that is."""
        keys = {zero.key for zero in self.names.state.zeros.values()}
        try:
            found = [each for each in self.names.reader.read(display.latex) if isinstance(each, n.Chain)]
        except (ReadError, RecursionError):
            return False
        claims = (chain for chain in found if chain.relations and self._told(chain) is None)
        return any(below.key in keys for chain in claims for below in n.names(chain))

    def _tells(self, chain: n.Chain) -> bool:
        """Whether a joint that has a marked letter stands more than once in a chain."""
        symbols = [
            self.names.joint_angle(index)
            for each in n.walk(chain)
            if isinstance(each, n.JointAngles)
            for _, index in each.terms
        ]
        symbols += [self.names.known_symbol(each.key) for each in n.names(chain)]
        return any(symbols.count(key) > 1 for key in self.names.state.zeros)

    @contextmanager
    def _counted_anew(self) -> Iterator[None]:
        before, self.names.state.counts_anew = self.names.state.counts_anew, True
        try:
            yield
        finally:
            self.names.state.counts_anew = before

    def _told(self, chain: n.Chain) -> _Told | None:
        if chain.relations != ("=",):
            return None
        for name, other in (chain.members, chain.members[::-1]):
            found = self._of_sum(bare(name), bare(other))
            if found is not None:
                return found
        return None

    def _of_sum(self, name: n.Node, other: n.Node) -> _Told | None:
        if not (isinstance(name, n.Name) and isinstance(other, n.Sum)):
            return None
        terms = [(sign, bare(term)) for sign, term in other.terms]
        letters = [(sign, term) for sign, term in terms if isinstance(term, n.Name) and term.key != "pi"]
        if len(letters) != 1 or letters[0][0] == "-":
            return None
        letter = letters[0][1]
        rest = n.placed(n.Sum(tuple(each for each in other.terms if bare(each[1]) is not letter)), other.span)
        turn = self._half_turns(rest)
        if turn is None or not turn:
            return None
        symbols = [self._joint(each) for each in (name, letter)]
        if symbols[0] and _is_marked(letter, name) and not symbols[1]:  # θ_1 = θ_1' + 90°
            meaning = n.Sum((("+", name), ("-", n.Group(rest))))
            return _Told(symbols[0], letter, n.placed(meaning, other.span), turn)
        if symbols[1] and _is_marked(name, letter) and not symbols[0]:  # θ_1' = θ_1 - 90°
            return _Told(symbols[1], name, other, -turn)
        return None

    def _joint(self, name: n.Name) -> str:
        symbol = self.names.known_symbol(name.key)
        joint = self.names.joints.get(symbol or "")
        return symbol if symbol and joint is not None and joint.kind == "revolute" and not name.dots else ""

    def _half_turns(self, rest: n.Node) -> Fraction | None:
        """Return the constant that a sum of numbers is, in half turns."""
        if any(isinstance(below, n.Name) and below.key != "pi" for below in n.walk(rest)):
            return None
        value = self.members.evaluate(rest).value
        return (value / self.members.exact.pi()).as_fraction() if isinstance(value, Scalar) else None


def _is_marked(marked: n.Name, name: n.Name) -> bool:
    """Whether a letter is another with a mark: θ_1', \\bar θ_1, θ_{1,robot}."""
    has_mark = marked.primes > name.primes or marked.base != name.base or marked.sub != name.sub
    is_letter = marked.base.rpartition(" ")[2] == name.base and marked.sub.partition(",")[0] == name.sub
    return has_mark and is_letter and replace(marked, dots=0) == marked
