r"""Statements with an index that stands for any joint, J_i = [z_{i-1} × (p_n - p_{i-1}); z_{i-1}]: they hold where they do for each one.

What does not hold, and does with one sign turned, or with J^T for J, is a law with a slip.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

_INDEX = regex(r"(?<![A-Za-z])([ijk])(?:([+-])1)?(?![A-Za-z])")
MOST_JOINTS = 8
_FLIPPED = {"+": "-", "-": "+"}
_TURNS = ("", "T", "-1", "-T")


def holds_for_each_joint(checker: ChainChecker, chain: n.Chain, equation: int, line: int, kind: str = "") -> bool:
    """Whether a chain is proved with its index for each joint of the arm, or of a kind; of one kind it is no law of all.

    A wrong one is not refuted here: the text beside it may say of which joints it is.
    """
    arm, letter = checker.names.arm, index_of(chain)
    if arm is None or not letter or not 1 < len(arm.joints) <= MOST_JOINTS or len(chain.members) < 2:
        return False
    ahead = _ahead(chain, letter)
    numbers = [number - ahead for number, joint in enumerate(arm.joints, 1) if kind in ("", joint.kind)]
    instances = [_instance(chain, letter, number) for number in numbers]
    if not all(_holds(checker, instance, equation, line) for instance in instances):
        return False
    return bool(numbers) and not any(_is_idle(checker, name, letter, numbers) for name in set(_names(chain)))


def without_letters(chain: n.Chain, is_open: Callable[[n.Name], bool]) -> n.Chain:
    """Return a chain without the columns that only give its parts letters: J_i = [J_{v_i}; J_{ω_i}] = [z_{i-1} × …; z_{i-1}]."""
    kept = [each for each in chain.members if not _is_of_letters(bare(each), is_open)]
    if len(kept) < 2 or len(kept) == len(chain.members) or set(chain.relations) != {"="}:
        return chain
    return replace(chain, members=tuple(kept), relations=("=",) * (len(kept) - 1))


def _is_of_letters(node: n.Node, is_open: Callable[[n.Name], bool]) -> bool:
    cells = [*map(bare, node.cells)] if isinstance(node, n.Matrix) else []
    return len(cells) > 1 and all(isinstance(each, n.Name) and is_open(each) for each in cells)


def _ahead(chain: n.Chain, letter: str) -> int:
    r"""Return how far the joint of a chain is ahead of its index: 1 for \dot\theta_{i+1} or v_{i+1}, which is said of link i + 1."""
    joints = (name.sub for name in _names(chain) if name.base in ("theta", "q", "d") and name.dots)
    told = {each[2] for sub in joints for each in _INDEX.finditer(sub) if each[1] == letter}
    spoken = {each[2] for name in _names(chain) for script in name.scripts for each in _INDEX.finditer(script)}
    return int(told == {"+"} or (not told and "+" in spoken and "-" not in spoken))


def _is_idle(checker: ChainChecker, name: n.Name, letter: str, numbers: list[int]) -> bool:
    """Whether what a name with the index stands for is zero for all joints: an arm whose origins are one tells no sign of p_{i-1}."""
    if not any(each[1] == letter for script in name.scripts for each in _INDEX.finditer(script)):
        return False
    values = [checker.member(_at(name, letter, number)).value for number in numbers]
    return all(isinstance(value, Matrix) and all(map(is_zero, value.cells)) for value in values)


def index_of(chain: n.Chain) -> str:
    """Return the one letter i, j or k that is an index of names in a chain, "" where there is none or several."""
    found = {each[1] for name in _names(chain) for script in name.scripts for each in _INDEX.finditer(script)}
    return found.pop() if len(found) == 1 else ""


def _names(chain: n.Chain) -> Iterator[n.Name]:
    yield from n.names(chain)


def _instance(chain: n.Chain, letter: str, number: int) -> n.Chain:
    """Return a chain with a number for its index."""
    for name in list(_names(chain)):
        changed = _at(name, letter, number)
        chain = n.substitute(chain, name, changed) if changed != name else chain  # type: ignore[assignment]
    return chain


def _at(name: n.Name, letter: str, number: int) -> n.Name:
    """Return a name with a number for its index."""

    def at(script: str) -> str:
        return _INDEX.sub(
            lambda found: str(number + int(f"{found[2]}1" if found[2] else 0)) if found[1] == letter else found[0],
            script,
        )

    sub, sup, pre_sub, pre_sup = map(at, name.scripts)
    return replace(name, sub=sub, sup=sup, pre_sub=pre_sub, pre_sup=pre_sup)


def _holds(checker: ChainChecker, chain: n.Chain, equation: int, line: int) -> bool:
    try:
        with checker.names.state.unchanged():
            outcomes = checker.check(chain, equation, line, define=False)
    except (EvaluationError, RecursionError):
        return False
    return bool(outcomes) and all(outcome.verdict is Verdict.PROVED for outcome in outcomes)


def slip_of_law(
    chain: n.Chain,
    holds: Callable[[n.Chain], bool],
    turns: bool = False,
    is_meant: Callable[[n.Sum], bool] = lambda _: True,
) -> Finding | None:
    """Return the change with which a chain is a law, of a sign or, where Jacobians may be turned, of J^T; None where none makes it one.

    A sign before all of a side, and an index, may be a convention.
    """
    changes = [*_signs(chain, is_meant), *(_turned(chain) if turns else ())]
    return next((finding for changed, finding in changes if holds(changed)), None)


def with_inverses(chain: n.Chain) -> n.Chain:
    """Return a chain with J^{-1} for J throughout: of a parallel robot J may be what a serial one's J^{-1} is."""
    other = {"": "-1", "-1": "", "T": "-T", "-T": "T"}
    changes = {
        id(whole): n.Postfix(node, turn) if (turn := other[printed]) else node
        for whole, node, printed in _jacobians(chain)
    }
    return replace(chain, members=tuple(n.substitute_each(member, changes) for member in chain.members))


def _signs(chain: n.Chain, is_meant: Callable[[n.Sum], bool]) -> Iterator[tuple[n.Chain, Finding]]:
    """Yield the chains with the sign of one of several terms turned."""
    for node in n.walk(chain):
        if not isinstance(node, n.Sum) or len(node.terms) == 1 or not is_meant(node):
            continue
        for k, (sign, term) in enumerate(node.terms):
            if sign in _FLIPPED:
                terms = (*node.terms[:k], (_FLIPPED[sign], term), *node.terms[k + 1 :])
                yield _with(chain, node, replace(node, terms=terms)), say(Kind.WRONG_SIGN_OF_TERM, term=k + 1)


def _turned(chain: n.Chain) -> Iterator[tuple[n.Chain, Finding]]:
    """Yield the chains with one J, J^T, J^{-1} or J^{-T} exchanged for another."""
    for whole, node, printed in _jacobians(chain):
        for operator in _TURNS:
            if operator != printed:
                other = n.Postfix(node, operator) if operator else node
                yield _with(chain, whole, other), say(Kind.INSTEAD_OF, correct=_text(operator), printed=_text(printed))


def _jacobians(chain: n.Chain) -> Iterator[tuple[n.Node, n.Node, str]]:
    """Yield each J with what stands above it, the J in it, and what turns it."""
    above = {id(node.base): node for node in n.walk(chain) if isinstance(node, n.Postfix)}
    called = {id(node.arguments[0]) for node in n.walk(chain) if n.is_call(node, "name")}
    for node in n.walk(chain):
        name = bare(node.arguments[0]) if n.is_call(node, "name") else node
        if isinstance(name, n.Name) and name.base == "J" and not name.dots and id(node) not in called:
            whole = above.get(id(node), node)
            printed = whole.operator if isinstance(whole, n.Postfix) else ""
            yield from [(whole, node, printed)] if printed in _TURNS else ()


def _with(chain: n.Chain, node: n.Node, changed: n.Node) -> n.Chain:
    return replace(chain, members=tuple(n.substitute_each(member, {id(node): changed}) for member in chain.members))


def _text(operator: str) -> str:
    return f"J^{{{operator}}}" if operator else "J"
