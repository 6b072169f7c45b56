r"""The conditions in a brace of cases: values (θ_1 = θ_2 = 0), signs (sin θ_5 < 0), all else ("otherwise"), or what is not decided."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from armproof.verification.document.postures import kind_of_joints
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.each_joint import holds_for_each_joint
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.errors import ReadError
from armproof.verification.evaluation.blocks import written_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED, Role, Verdict

REST = regex(
    r"(?:otherwise|else|elsewhere|in all other cases|sinon|autrement|ailleurs|sonst|andernfalls|altrimenti|si no)", re.I
)
COMPARISONS = frozenset("<>≤≥")
CHANGES = regex(r"\b(?:not|unless|except|only|never|or|pas|sauf|ne|ou|jamais|nicht|außer|oder)\b", re.I)


_SPACES_BEFORE = regex(r"\A(?:[\s.,;:]|\\[,;:! ]|\\q?quad(?![A-Za-z]))+")
Comparison = tuple[n.Node, str, n.Node]


@dataclass(frozen=True)
class Case:
    """A line of a brace: its value, the values of the names at which it holds, and whether it is for all else.

    `where` are comparisons that hold there; for all else the other way round than in the other line.
    """

    value: n.Node
    text: str
    at: tuple[tuple[n.Node, n.Node], ...] = ()
    is_rest: bool = False
    where: tuple[Comparison, ...] = ()


def check_cases(checker: ChainChecker, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
    """Check each case under its condition where that gives values; what is said for all else holds of everything."""
    cases = next(member for member in chain.members if isinstance(member, n.Cases))
    if of_kinds := _by_kind(checker, chain, cases, equation, line):
        return of_kinds
    read = read_cases(cases, checker.names)
    if not any(case.at or case.where for case in read):  # it may be a definition of its own
        return checker.check(chain, equation, line, define)
    others = [member for member in chain.members if member is not cases]
    return [outcome for case in read for outcome in _check_case(checker, case, others, equation, line)]


def _by_kind(checker: ChainChecker, chain: n.Chain, cases: n.Cases, equation: int, line: int) -> list[Outcome]:
    """Return what becomes of a law with a case for turning joints and one for sliding ones, where it holds; else nothing.

    A sliding joint gives [axis; 0] beside the [axis × arm; axis] of a turning one, also where the arm has none.
    """
    named = {kind_of_joints(text): value for value, text in cases.branches if not CHANGES.search(text)}
    arm, others = checker.names.arm, [member for member in chain.members if member is not cases]
    if arm is None or set(named) != {"revolute", "prismatic"} or len(cases.branches) != 2:
        return []
    kinds = {joint.kind for joint in arm.joints}
    laws = {kind: replace(chain, members=(*others, named[kind])) for kind in named if kind in kinds}
    if not all(holds_for_each_joint(checker, laws[kind], equation, line, kind) for kind in laws):
        return []
    if "prismatic" not in kinds and not _is_axis_alone(named["prismatic"], named["revolute"]):
        return []
    return [Outcome(Verdict.PROVED, (say(Kind.EACH_JOINT),), equation, role=Role.LAW)] if "revolute" in kinds else []


def _is_axis_alone(sliding: n.Node, turning: n.Node) -> bool:
    """Whether a column is [z_{i-1}; 0] beside [z_{i-1} × (p_n - p_{i-1}); z_{i-1}]."""
    axis, rest = [cells if len(cells := written_rows(each)) == 2 else ((), ()) for each in (sliding, turning)]
    if not all(len(cell) == 1 for cell in (*axis, *rest)):
        return False
    zero = bare(axis[1][0])
    return bare(axis[0][0]) == bare(rest[1][0]) and isinstance(zero, n.Number) and zero.value == 0


def _check_case(checker: ChainChecker, case: Case, others: list[n.Node], equation: int, line: int) -> list[Outcome]:
    sides = [n.At(side, case.at, span=side.span) if case.at else side for side in (*others, case.value)]
    outcomes = checker.check(n.Chain(tuple(sides), ("=",) * len(others), span=case.value.span), equation, line, False)
    generic = any(n.is_rank(below) for side in sides for below in n.walk(side))
    if case.where and not generic and all(outcome.verdict is not Verdict.PROVED for outcome in outcomes):
        return [_where(checker, case, outcome) for outcome in outcomes]
    if case.at or (
        not generic and (case.is_rest or hold(outcomes))
    ):  # the rank of a generic configuration is not that of all
        return outcomes
    return [outcome.left_open(say(Kind.CASE_OPEN, text=case.text)) for outcome in outcomes]


def _where(checker: ChainChecker, case: Case, outcome: Outcome) -> Outcome:
    """Return an equation that samples confirm where the comparisons of its case hold; else it is open."""
    left_open = outcome.left_open(say(Kind.CASE_OPEN, text=case.text))
    if outcome.true is None or outcome.printed is None or outcome.verdict not in DECIDED:
        return left_open
    sampled = checker.sampled()
    from armproof.verification.equations.sampled_relations import holds_where

    sides = outcome.true.node, outcome.printed.node
    with checker.exact.budget.paused():
        count = holds_where(checker, sampled, sides, outcome.pair, case.where)
    found = (say(Kind.HOLDS_WHERE, text=case.text, count=count),)
    return replace(outcome, verdict=Verdict.CONFIRMED, findings=found, samples=count, wrong=[]) if count else left_open


def read_cases(cases: n.Cases, names: Names) -> list[Case]:
    """Return the cases of a brace; "otherwise" is all else where the others are for values of joint variables."""
    read = [_read(value, condition, names) for value, condition in cases.branches]
    at_joints = all(case.is_rest or (case.at and _keys(case, names) <= names.joints.keys()) for case in read)
    others = [case for case in read if not case.is_rest]
    by_sign = len(others) == 1 and len(others[0].where) == 1  # what is not so is the other sign
    return [
        replace(
            c,
            is_rest=c.is_rest and (at_joints or by_sign),
            where=_turned(others[0]) if c.is_rest and by_sign else c.where,
        )
        for c in read
    ]


def _turned(case: Case) -> tuple[Comparison, ...]:
    return tuple((right, relation, left) for left, relation, right in case.where)


def _read(value: n.Node, condition: str, names: Names) -> Case:
    condition = _SPACES_BEFORE.sub("", condition)
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
    if plain and chains and all(set(c.relations) <= COMPARISONS and c.relations for c in chains):
        return Case(value, said, where=tuple(each for c in chains for each in comparisons_of(c)))
    if not plain or not chains or any(set(chain.relations) != {"="} for chain in chains):
        return Case(value, said)
    at = tuple(pair for chain in chains for pair in _values(chain))
    return Case(value, said, at if len({n.bare_key(name) for name, _ in at}) == len(at) else ())


def comparisons_of(chain: n.Chain) -> Iterator[Comparison]:
    """Yield what a chain compares, two by two: 0 < θ_2 < π, or θ_2 ∈ (0, π)."""
    for left, relation, right in zip(chain.members, chain.relations, chain.members[1:], strict=False):
        inner = bare(left)
        if n.is_call(inner, "abs") and relation in ("<", "≤"):  # |θ_2| < π/2
            yield from ((inner.arguments[0], relation, right), (n.Sum((("-", right),)), relation, inner.arguments[0]))
        elif relation in COMPARISONS:
            yield left, relation, right
        elif (interval := n.interval_of(relation, right)) is not None:
            order = "<" if interval.brackets == "()" else "≤"
            yield from ((interval.items[0], order, left), (left, order, interval.items[1]))


def _values(chain: n.Chain) -> Iterator[tuple[n.Node, n.Node]]:
    """Yield the names of θ_1 = θ_2 = 0, each with the value."""
    *names, last = chain.members
    yield from ((name, last) for name in names)


def _keys(case: Case, names: Names) -> set[str | None]:
    return {names.known_symbol(name.key) if isinstance(name, n.Name) else None for name, _ in case.at}
