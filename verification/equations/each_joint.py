r"""Statements with an index that stands for any joint, J_i = [z_{i-1} × (p_n - p_{i-1}); z_{i-1}]: they hold where they do for each one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

_INDEX = re.compile(r"(?<![A-Za-z])([ijk])(?:([+-])1)?(?![A-Za-z])")
MOST_JOINTS = 8


def holds_for_each_joint(checker: ChainChecker, chain: n.Chain, equation: int, line: int, kind: str = "") -> bool:
    """Whether a chain is proved with its index for each joint of the arm, or of a kind; of one kind it is no law of all.

    A wrong one is not refuted here: the text beside it may say of which joints it is.
    """
    arm, letter = checker.names.arm, index_of(chain)
    if arm is None or not letter or not 1 < len(arm.joints) <= MOST_JOINTS or len(chain.members) < 2:
        return False
    numbers = [number for number, joint in enumerate(arm.joints, 1) if kind in ("", joint.kind)]
    instances = [_instance(chain, letter, number) for number in numbers]
    if not all(_holds(checker, instance, equation, line) for instance in instances):
        return False
    return bool(numbers) and not any(_is_idle(checker, name, letter, numbers) for name in set(_names(chain)))


def _is_idle(checker: ChainChecker, name: n.Name, letter: str, numbers: list[int]) -> bool:
    """Whether what a name with the index stands for is zero for all joints: an arm whose origins are one tells no sign of p_{i-1}."""
    if not any(each[1] == letter for script in _scripts(name) for each in _INDEX.finditer(script)):
        return False
    values = [checker.member(_at(name, letter, number)).value for number in numbers]
    return all(isinstance(value, Matrix) and all(map(is_zero, value.cells)) for value in values)


def index_of(chain: n.Chain) -> str:
    """Return the one letter i, j or k that is an index of names in a chain, "" where there is none or several."""
    found = {each[1] for name in _names(chain) for script in _scripts(name) for each in _INDEX.finditer(script)}
    return found.pop() if len(found) == 1 else ""


def _names(chain: n.Chain) -> Iterator[n.Name]:
    yield from (below for member in chain.members for below in n.walk(member) if isinstance(below, n.Name))


def _scripts(name: n.Name) -> tuple[str, str, str, str]:
    return name.sub, name.sup, name.pre_sub, name.pre_sup


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

    sub, sup, pre_sub, pre_sup = map(at, _scripts(name))
    return replace(name, sub=sub, sup=sup, pre_sub=pre_sub, pre_sup=pre_sup)


def _holds(checker: ChainChecker, chain: n.Chain, equation: int, line: int) -> bool:
    try:
        with checker.names.state.unchanged():
            outcomes = checker.check(chain, equation, line, define=False)
    except (EvaluationError, RecursionError):
        return False
    return bool(outcomes) and all(outcome.verdict is Verdict.PROVED for outcome in outcomes)
