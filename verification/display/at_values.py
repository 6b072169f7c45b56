"""Numbers at values that a document gives: in a worked example, in the text before, of rates."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from armproof.verification.display.two_readings import Decide
from armproof.verification.equations.at_stated_values import MANY, is_mostly_right
from armproof.verification.equations.inequalities import is_numbers
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.under_rates import JACOBIAN, UnderRates
from armproof.verification.equations.worked_numbers import tells_values, unitless
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.state import DocumentState, Stated
from armproof.verification.verdict import HOLDS, Verdict


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


def of_worked_example(state: DocumentState, decide: Decide, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
    """Return the outcomes of numbers that hold at the values given last, under whatever heading; [] where some do not.

    What is "Given" in centimetres is often worked out without a unit. Only one number of a matrix is refuted there, of which
    many others are right: else the numbers may be of other values.
    """
    if not state.given_last or set(chain.relations) != {"="} or not any(map(tells_values, chain.members)):
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


def at_told_values(
    state: DocumentState, told: dict[str, Stated], decide: Decide, chain: n.Chain, equation: int, line: int
) -> list[Outcome]:
    """Return what becomes of numbers at the values that the text before gives; [] where there are none.

    What is not decided there leaves no trace. Only few numbers of many are refuted there, and fewer still that do not stand right behind the text.
    """
    speaks = state.told.standing or state.told_lengths
    if not speaks or len(chain.members) < 2 or not any(map(is_numbers, chain.members)):
        return []
    before = state.copy()
    state.configuration = {**told, **state.configuration}
    outcomes = decide(chain, equation, line, False)
    wrong = [each for each in outcomes if each.verdict not in HOLDS]
    times = 1 if state.told.line == line else MANY
    if not wrong or all(is_mostly_right(each, times) for each in wrong):
        state.configuration = before.configuration
        return outcomes
    state.become(before)
    return [each.left_open(say(Kind.OTHER_AS_TOLD)) for each in wrong if each.verdict is Verdict.REFUTED]
