r"""The conditions in a brace of cases: values (θ_1 = θ_2 = 0), all else ("otherwise"), or what is not decided."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

REST = re.compile(
    r"(?:otherwise|else|elsewhere|in all other cases|sinon|autrement|ailleurs|sonst|andernfalls|altrimenti|si no)", re.I
)
CHANGES = re.compile(r"\b(?:not|unless|except|only|never|or|pas|sauf|ne|ou|jamais|nicht|außer|oder)\b", re.I)


@dataclass(frozen=True)
class Case:
    """A line of a brace: its value, the values of the names at which it holds, and whether it is for all else."""

    value: n.Node
    text: str
    at: tuple[tuple[n.Node, n.Node], ...] = ()
    is_rest: bool = False


def check_cases(checker: ChainChecker, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
    """Check each case under its condition where that gives values; what is said for all else holds of everything."""
    cases = next(member for member in chain.members if isinstance(member, n.Cases))
    read = read_cases(cases, checker.names)
    if not any(case.at for case in read):  # it may be a definition of its own
        return checker.check(chain, equation, line, define)
    others = [member for member in chain.members if member is not cases]
    return [outcome for case in read for outcome in _check_case(checker, case, others, equation, line)]


def _check_case(checker: ChainChecker, case: Case, others: list[n.Node], equation: int, line: int) -> list[Outcome]:
    sides = [n.At(side, case.at, span=side.span) if case.at else side for side in (*others, case.value)]
    outcomes = checker.check(n.Chain(tuple(sides), ("=",) * len(others), span=case.value.span), equation, line, False)
    generic = any(isinstance(below, n.Call) and below.function == "rank" for side in sides for below in n.walk(side))
    if case.at or (
        not generic and (case.is_rest or hold(outcomes))
    ):  # the rank of a generic configuration is not that of all
        return outcomes
    return [outcome.left_open(say(Kind.CASE_OPEN, text=case.text)) for outcome in outcomes]


def read_cases(cases: n.Cases, names: Names) -> list[Case]:
    """Return the cases of a brace; "otherwise" is all else where the others are for values of joint variables."""
    read = [_read(value, condition, names) for value, condition in cases.branches]
    variables = {joint.symbol for joint in names.arm.joints} if names.arm is not None else set()
    at_joints = all(case.is_rest or (case.at and _keys(case, names) <= variables) for case in read)
    return [Case(c.value, c.text, c.at, c.is_rest and at_joints) for c in read]


def _read(value: n.Node, condition: str, names: Names) -> Case:
    said = condition.strip(" .,;")
    if REST.fullmatch(re.sub(r"\\[A-Za-z]+\s*|[{}~]", " ", said).strip(" .,;")):
        return Case(value, said, is_rest=True)
    try:
        statements = names.reader.read(condition)
    except ReadError:
        return Case(value, said)
    chains = [each for each in statements if isinstance(each, n.Chain)]
    words = [each for each in statements if isinstance(each, n.Connective)]
    plain = all(each.kind in ("if", "and", "words") and not CHANGES.search(each.text) for each in words)
    if not plain or not chains or any(set(chain.relations) != {"="} for chain in chains):
        return Case(value, said)
    at = tuple(pair for chain in chains for pair in _values(chain))
    return Case(value, said, at if len({n.bare_key(name) for name, _ in at}) == len(at) else ())


def _values(chain: n.Chain) -> Iterator[tuple[n.Node, n.Node]]:
    """Yield the names of θ_1 = θ_2 = 0, each with the value."""
    *names, last = chain.members
    yield from ((name, last) for name in names)


def _keys(case: Case, names: Names) -> set[str | None]:
    return {names.known_symbol(name.key) if isinstance(name, n.Name) else None for name, _ in case.at}
