r"""Equations that some configurations meet, and no arm everywhere: a_3 s_3 + d_4 c_3 = 0, \tan\theta_3 = -d_4 / a_3."""

from __future__ import annotations

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.sides import Members
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

_PLAIN = n.Name | n.Number | n.Sum | n.Product | n.Quotient | n.Power | n.Group | n.JointAngles | n.Call
_FUNCTIONS = ("cos", "sin", "tan", "cot", "sqrt", *n.ARCS)


def fixes_joints(chain: n.Chain, members: Members, names: Names) -> bool:
    """Whether one side is of lengths alone and the other moves with joints, and neither tells of anything else of the arm.

    What moves is no constant, so that nobody claims it everywhere: it says where the arm is. With numbers in place of lengths
    values are asked for, and behind values of all its joints it is a claim there.
    """
    if chain.relations != ("=",) or names.arm is None or not all(map(_is_plain, chain.members)):
        return False
    letters = [each for member in chain.members for each in n.names(member) if each.key != "pi"]
    known = {names.known_symbol(each.key) for each in letters if not each.dots}
    if len(letters) != sum(not each.dots for each in letters) or None in known or known.isdisjoint(names.lengths):
        return False
    if any(each.key in names.state.definitions for each in letters):
        return False
    values = [members.evaluate(member).value for member in chain.members]
    if not all(isinstance(value, Scalar) for value in values):
        return False
    moving = [symbols_in([value.normal()]) & names.joints.keys() for value in values if isinstance(value, Scalar)]
    where = next(filter(None, moving), set[str]())
    return moving.count(set()) == 1 and not where <= names.state.configuration.keys()


def _is_plain(node: n.Node) -> bool:
    return all(
        isinstance(each, _PLAIN) and (not isinstance(each, n.Call) or each.function in _FUNCTIONS)
        for each in n.walk(node)
    )
