"""A length or a joint that the arm does not have, a_3 of a 2R arm: a slip where one that it has, a_2, makes the equation hold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TypeGuard

from armproof.verification.document import Display, Document
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.names import Names
from armproof.verification.verdict import HOLDS, Verdict

Check = Callable[[n.Chain], list[Outcome]]


def of_foreign_index(
    chain: n.Chain, names: Names, first_equation: int, check: Check
) -> tuple[list[Outcome], n.Chain] | None:
    """Return the outcomes of a chain that holds with another index of one name in it, and with no second one, and that chain; else None.

    `check` decides another chain and leaves nothing behind.
    """
    if (name := _foreign(chain, names)) is None:
        return None
    read = ((own, _with(chain, name, own)) for own in _alike(name, names))
    holding = [(own, meant, outcomes) for own, meant in read if _hold(outcomes := check(meant))]
    if len(holding) != 1:
        return None
    [(own, meant, outcomes)] = holding
    wrong = [k for k, member in enumerate(chain.members) if any(_is(below, name) for below in n.walk(member))]
    slip = say(Kind.NO_SUCH_LENGTH, name=name.key, length=own)
    refuted = [
        replace(each, verdict=Verdict.REFUTED, findings=(slip,), pair=None, samples=0, max_error=None)
        if {max(0, k - 1) for k in wrong} & {each.equation - first_equation}
        else each
        for each in outcomes
    ]
    return refuted, meant


def unless_written_elsewhere(outcome: Outcome, display: Display, document: Document) -> Outcome:
    """Leave open what another index would mend, where the name stands in the document once more: it may be one of its own."""
    names = [str(each.terms["name"]) for each in outcome.findings if each.kind is Kind.NO_SUCH_LENGTH]
    other = next((name for name in names if document.writes(name, display.place)), None)
    if outcome.verdict is not Verdict.REFUTED or other is None:
        return outcome
    opened = outcome.left_open(say(Kind.NOT_BOUND, name=other))
    opened.also(outcome.findings[0])
    return opened


def _foreign(chain: n.Chain, names: Names) -> n.Name | None:
    """Return the one name with a digit that nothing binds inside the formulas of a chain, where the arm has its letter."""
    alone = {each.key for each in map(bare, chain.members) if isinstance(each, n.Name)}
    inside = [below for member in chain.members for below in n.names(member)]
    plain = {each.key: each for name in inside if (each := name.undotted).key not in alone}
    unbound = [name for name in plain.values() if names.is_open(name) and not is_usual(name)]
    if len(unbound) != 1:
        return None
    (name,) = unbound
    has_digit = name.sub.isdigit() and not (name.sup or name.pre_sub or name.pre_sup or name.primes)
    return name if has_digit and any(_alike(name, names)) else None


def _alike(name: n.Name, names: Names) -> Iterator[str]:
    """Yield the lengths and joints of the arm that have the letter of a name, and another digit."""
    if (arm := names.arm) is None:
        return
    for symbol in (*arm.lengths, *(joint.symbol for joint in arm.joints), *names.symbols):
        letter, _, digit = symbol.partition("_")
        if letter == name.base and digit.isdigit() and digit != name.sub:
            yield symbol


def _with(chain: n.Chain, name: n.Name, own: str) -> n.Chain:
    sub = own.partition("_")[2]
    below = [each for member in chain.members for each in n.walk(member)]
    others: dict[int, n.Node] = {id(each): replace(each, sub=sub) for each in below if _is(each, name)}
    return replace(chain, members=tuple(n.substitute_each(member, others) for member in chain.members))


def _is(node: n.Node, name: n.Name) -> TypeGuard[n.Name]:
    """Whether a node is a name, or its rate."""
    return isinstance(node, n.Name) and node.undotted.key == name.key


def _hold(outcomes: Sequence[Outcome]) -> bool:
    return bool(outcomes) and all(outcome.verdict in HOLDS for outcome in outcomes)
