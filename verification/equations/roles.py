"""What an equation is, told from what was found out about it: a claim, a definition, data, a condition or a remark."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Role, Verdict

DEFINES = {Kind.DEFINES, Kind.DEFINES_ENTRIES, Kind.DEFINES_WITHOUT_VALUE, Kind.NUMBER_HERE, Kind.SIGN}


def with_role(outcome: Outcome, chain: n.Chain, names: Names) -> Outcome:
    """Give an outcome its role, which allows only some verdicts; what decides nothing is unchecked."""
    kinds = {finding.kind for finding in outcome.findings}
    if outcome.verdict is Verdict.DEFINED and kinds & DEFINES:
        outcome.role = Role.DEFINITION
    elif outcome.verdict is Verdict.DEFINED and Kind.CONFIGURATION in kinds:
        outcome.role = Role.DATA
    elif outcome.verdict is Verdict.DEFINED and Kind.NO_EQUATION in kinds:
        outcome.role, outcome.verdict = Role.REMARK, Verdict.UNCHECKED
    elif outcome.verdict is Verdict.DEFINED:
        outcome.role = Role.CONDITION if Kind.CONDITION in kinds else Role.CLAIM
        outcome.verdict = Verdict.UNCHECKED
    if outcome.verdict is Verdict.UNCHECKED and not is_kinematics(chain, names):
        outcome.role = Role.REMARK
        outcome.also(say(Kind.BEYOND))
    return outcome


def is_kinematics(chain: n.Chain, names: Names) -> bool:
    """Whether an equation holds anything of the arm's or of the document's kinematics, or could: a joint, a quantity, a name."""
    return any(_is_of_kinematics(below, names) for below in n.walk(chain))


def _is_of_kinematics(node: n.Node, names: Names) -> bool:
    if isinstance(node, n.JointAngles | n.Matrix):
        return True
    if isinstance(node, n.Call):
        return node.function not in ("name", "exp", "ln", "log", "min", "max", "sqrt", "abs")
    if not isinstance(node, n.Name) or node.base == "words":
        return False
    key = node.key
    plain = replace(node, dots=0)
    return (
        key in names.quantities
        or key in names.state.definitions
        or names.known_symbol(plain.key) is not None
        or names.quantity(plain) is not None
        or bool(node.pre_sub or node.pre_sup)
    )
