"""Numbers at values that a document gives: in a worked example, in the text before, of rates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from math import log10
from operator import methodcaller

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.display.two_readings import Decide
from armproof.verification.equations.at_stated_values import MANY, is_mostly_right
from armproof.verification.equations.inequalities import is_numbers
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.under_rates import JACOBIAN, UnderRates
from armproof.verification.equations.worked_numbers import tells_values, unitless
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import DocumentState, Stated
from armproof.verification.verdict import HOLDS, Verdict

UNIT = 0.01  # of a power of ten: nearer to one, a number may be in another unit


def under_given_rates(
    state: DocumentState,
    decide: Decide,
    under: UnderRates,
    chain: n.Chain,
    before: DocumentState,
    equation: int,
    line: int,
) -> list[Outcome]:
    """Return what becomes of an equation under the rates or the velocity that are given, where it holds or is a slip away; else nothing."""
    for reading, meanings in under.readings(chain):
        after = state.copy()
        state.become(before)
        state.inferred |= meanings
        state.told = under.told_besides
        tried = decide(reading, equation, line, False)
        state.become(before)
        wrong = [each for each in tried if each.verdict not in HOLDS]
        is_meant = before.told.has_shown or before.told.line in (0, line)
        if tried and (not wrong or (is_meant and all(each.verdict is Verdict.REFUTED for each in wrong))):
            tried = [under.unless_data(each) for each in tried] if len(tried) == 1 else tried
            tried = [each.unless_slip(say(Kind.OTHER_AS_TOLD)) for each in tried]
            for each in tried:
                each.read_as = each.read_as if JACOBIAN.key not in each.read_as else ""
                if each.verdict in HOLDS:
                    each.also(say(Kind.UNDER_RATES))
            state.told = replace(before.told, has_shown=True)
            return tried
        state.become(after)
    return []


def _is_of_data(state: DocumentState, chain: n.Chain) -> bool:
    """Whether a display has given what a chain is about as numbers, P_y = 0.4: that it says so again is not decided by that."""
    before = state.definitions.get(n.bare_key(chain.members[0]) or "")
    return before is not None and before.node is not None and is_numbers(before.node)


def of_worked_example(state: DocumentState, decide: Decide, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
    """Return the outcomes of numbers that hold at the values given last, under whatever heading; [] where some do not.

    What is "Given" in centimetres is often worked out without a unit. Only one number of a matrix is refuted there, of which
    many others are right: else the numbers may be of other values.
    """
    if (
        not state.given_last
        or _is_of_data(state, chain)
        or set(chain.relations) != {"="}
        or not any(map(tells_values, chain.members))
    ):
        return []
    before = state.copy()
    for given in unitless(state.given_last):
        state.configuration = {key: replace(each, section=state.section) for key, each in given.items()}
        state.forget_consulted()
        steps = [replace(chain, members=pair, relations=("=",)) for pair in pairwise(chain.members)]
        outcomes = [o for k, step in enumerate(steps) for o in decide(step, equation + k, line, False)]
        held = [each for each in outcomes if each.verdict in HOLDS]
        slips = [each for each in outcomes if each not in held and is_mostly_right(each, MANY)]
        tells = any(each.tells(Kind.TO_DECIMALS_THERE) for each in held) or slips
        if outcomes and tells and len(held) + len(slips) == len(outcomes):
            state.configuration = before.configuration
            return outcomes
        state.become(before)
    return []


def _is_off(outcome: Outcome, number: Callable[[Scalar], float]) -> bool:
    """Whether a number alone is refuted at stated values, and is not 10, 100, … times what is right: in millimetres, where lengths are in metres."""
    if outcome.verdict is not Verdict.REFUTED or not outcome.there or outcome.pair is None:
        return False
    if not outcome.pair.is_scalar or symbols_in(outcome.pair.true.cells):
        return False
    ((_, *sides),) = outcome.pair.entries()
    true, printed = map(number, sides)
    powers = log10(abs(printed / true)) if true * printed > 0 else 0.5
    return abs(powers - round(powers)) > UNIT or abs(powers) < 0.5


def _has_formula(chain: n.Chain) -> bool:
    """Whether a number is what a formula comes to: det J = l_1 l_2 sin θ_2 = 0.1061."""
    return len(chain.members) > 2 and any(
        bare_key(each) is None and not is_numbers(each) for each in chain.members[:-1]
    )


def at_told_values(
    state: DocumentState,
    told: dict[str, Stated],
    decide: Decide,
    number: Callable[[Scalar], float],
    chain: n.Chain,
    equation: int,
    line: int,
) -> list[Outcome]:
    """Return what becomes of numbers at the values that the text before gives; [] where there are none.

    What is not decided there leaves no trace. Few numbers of many are refuted there, fewer still that do not stand right behind the text, unless a
    formula stands beside them and others hold there; a number alone is where the sentence leads to it, "For ¤ and ¤ we get", or where
    others hold there and it is what a formula comes to, unless it is in another unit.
    """
    speaks = state.told.standing or state.told_lengths
    if not speaks or _is_of_data(state, chain) or len(chain.members) < 2 or not any(map(is_numbers, chain.members)):
        return []
    before = state.copy()
    state.configuration = {**told, **state.configuration}
    outcomes = decide(chain, equation, line, False)
    wrong = [each for each in outcomes if each.verdict not in HOLDS]
    is_near = state.told.line == line
    is_worked = state.told.holds and _has_formula(chain) and not state.told.in_words
    times = 1 if is_near or is_worked else MANY
    is_led_to = (is_near or state.told.holds) and state.told.is_direct and not state.told.in_words
    is_led_to = is_led_to or is_worked
    if not wrong or all(is_mostly_right(each, times) or (is_led_to and _is_off(each, number)) for each in wrong):
        state.configuration = before.configuration
        state.told = replace(state.told, holds=state.told.holds or not wrong)
        return outcomes
    state.become(before)
    return [each.left_open(say(Kind.OTHER_AS_TOLD)) for each in wrong if each.verdict is Verdict.REFUTED]


def as_usual_at_told_values(
    names: Names, told: dict[str, Stated], decide: Decide, chain: n.Chain, equation: int, line: int
) -> list[Outcome]:
    """Return a matrix of numbers refuted where a name, as it is usually meant, has all of them but one at the values that the text gives; else nothing."""
    name, numbers, state = n.plain_name(chain.members[0]), bare(chain.members[-1]), names.state
    if name is None or len(chain.members) != 2 or not isinstance(numbers, n.Matrix) or not is_numbers(numbers):
        return []
    if state.told.in_words or not (state.told.standing and is_usual(name) and names.is_open(name)):
        return []
    before = state.copy()
    for quantity in names.usual(name):
        state.configuration = {**told, **before.configuration}
        names.define(name.key, methodcaller("quantity", quantity), line)
        outcomes = decide(chain, equation, line, False)
        state.become(before)
        if len(outcomes) == 1 and len(outcomes[0].wrong) == 1 and is_mostly_right(outcomes[0], MANY):
            state.infer_usual(name.key, quantity)
            return outcomes
    return []
