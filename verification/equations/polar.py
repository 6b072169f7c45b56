r"""Polar coordinates, A = r \cos\varphi and B = r \sin\varphi: they give r ≥ 0 and φ their meaning, as Paul and Craig find the θ_1 of a PUMA."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.verdict import HOLDS, Role, Verdict


@dataclass(frozen=True)
class PolarPair:
    """Two equations A = r cos φ and B = r sin φ, in the order in which they stand."""

    chains: tuple[n.Chain, n.Chain]
    radius: n.Name
    angle: n.Name
    along: n.Node  # A
    across: n.Node  # B

    @property
    def squared(self) -> n.Node:
        """A² + B²."""
        return n.Sum(tuple(("+", n.Power(each, n.Number(Fraction(2)))) for each in (self.along, self.across)))

    @property
    def meanings(self) -> tuple[n.Chain, n.Chain]:
        """What it says of its letters: r = √(A² + B²) and φ = atan2(B, A)."""
        length = n.Call("sqrt", (self.squared,), "\\sqrt", "braces")
        direction = n.Call("atan2", (self.across, self.along), "\\operatorname{atan2}")
        said = (n.Chain((self.radius, length), ("=",)), n.Chain((self.angle, direction), ("=",)))
        return tuple(n.placed(each, chain.span) for each, chain in zip(said, self.chains, strict=True))  # type: ignore[return-value]


def polar_pair(first: n.Statement, second: n.Statement) -> PolarPair | None:
    """Return the pair that two statements are, or None."""
    found = [part for each in (first, second) if (part := _part(each)) is not None]
    if {function for function, *_ in found} != {"cos", "sin"} or found[0][1:3] != found[1][1:3]:
        return None
    sides = {function: other for function, _, _, other in found}
    assert isinstance(first, n.Chain) and isinstance(second, n.Chain)
    return PolarPair((first, second), *found[0][1:3], sides["cos"], sides["sin"])


def _part(statement: n.Statement) -> tuple[str, n.Name, n.Name, n.Node] | None:
    """Return "cos", r, φ and A of A = r cos φ."""
    if not isinstance(statement, n.Chain) or statement.relations != ("=",):
        return None
    for side, other in (statement.members, statement.members[::-1]):
        factors = [bare(each) for each in side.factors] if isinstance(side := bare(side), n.Product) else []
        names = [each for each in factors if isinstance(each, n.Name)]
        calls = [each for each in factors if n.is_call(each, "cos", "sin")]
        if len(factors) != 2 or not names or not calls or not isinstance(angle := bare(calls[0].arguments[0]), n.Name):
            continue
        letters = {each.key for each in n.names(other)}
        if letters and letters.isdisjoint((names[0].key, angle.key)):
            return calls[0].function, names[0], angle, other
    return None


def gives_meanings(checker: ChainChecker, pair: PolarPair, equation: int, line: int) -> list[Outcome] | None:
    """Let a pair give its letters their meaning. Return the two outcomes; None where it says something of what has one.

    A second pair of the same letters is meant where both of its equations fail, and are no slip of the first pair.
    """
    names, state = checker.names, checker.names.state
    letters = (pair.radius, pair.angle)
    if any(names.known_symbol(each.key) is not None or each.key in names.quantities for each in letters):
        return None
    had = {each.key: state.definitions[each.key] for each in letters if _has_value(checker, each)}
    here = [key for key, each in had.items() if each.section == state.section]
    if not _may_be_new(checker, pair, equation, line) if len(had) == 2 else here:
        return None
    before = state.copy()
    outcomes = []
    for at, said in enumerate(pair.meanings):
        if (outcome := _given(checker, said, equation + at, line)) is None:
            state.become(before)
            return None
        outcomes.append(outcome)
        (key,) = outcome.defines
        if key in here:
            outcome.also(say(Kind.SECOND_MEANING, name=key, line=had[key].line))
    return outcomes


def _has_value(checker: ChainChecker, letter: n.Name) -> bool:
    """Whether a definition gives a letter a value here: that of x may be one of another section."""
    with checker.names.state.unchanged():
        return letter.key in checker.names.state.definitions and checker.member(letter).known


def _given(checker: ChainChecker, said: n.Chain, equation: int, line: int) -> Outcome | None:
    """Give a letter its meaning, whatever it usually means; None where that has no value."""
    letter, formula = said.members
    assert isinstance(letter, n.Name)
    (true,) = checker.conventions.bind([checker.member(formula)])
    if not isinstance(true.value, Scalar):
        return None
    checker.names.forget((letter.key,))
    checker.names.define(letter.key, checker.members.meaning(formula), line, node=formula)
    told = (say(Kind.DEFINES, name=letter.key),)
    return Outcome(
        Verdict.DEFINED, told, equation, true, checker.member(letter), defines=(letter.key,), role=Role.DEFINITION
    )


def _may_be_new(checker: ChainChecker, pair: PolarPair, equation: int, line: int) -> bool:
    """Whether a pair of letters with a value is no claim: both equations fail, and no sign or exchange makes it the first pair.

    One that is the first pair again, of coordinates that have no meaning yet in this section, is none either.
    """
    with checker.names.state.unchanged():
        found = [each for chain in pair.chains for each in checker.check(chain, equation, line, False)]
        if any(each.verdict in HOLDS for each in found):
            return False
        turned = (n.Product((pair.radius, n.Call(function, (pair.angle,))), ("",)) for function in ("cos", "sin"))
        known, sides = _scalars(checker, turned), _scalars(checker, (pair.along, pair.across))
    if len(known) + len(sides) < 4 or all((one - other).is_zero() for one, other in zip(known, sides, strict=True)):
        return len(known) + len(sides) == 4
    return not any(all(map(_is_up_to_sign, sides, order)) for order in (known, known[::-1]))


def _scalars(checker: ChainChecker, nodes: Iterable[n.Node]) -> list[Scalar]:
    """Return the values of nodes, with usual names in their usual meaning; those that are no scalars left out."""
    values = (as_scalar(checker.conventions.bind([checker.member(each)])[0].value) for each in nodes)
    return [each for each in values if isinstance(each, Scalar)]


def _is_up_to_sign(one: Scalar, other: Scalar) -> bool:
    return (one - other).is_zero() or (one + other).is_zero()
