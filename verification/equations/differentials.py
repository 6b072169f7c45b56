r"""Displacements, \delta x = J \delta q, dx = J dq and \Delta x \approx J \Delta q: what holds of them is what holds of rates."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.latex import nodes as n
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.names import Names

_SIGNS = ("d", "delta")
_FINITE = "Delta"  # what is said of it is near at best


def of_small_ones(chain: n.Chain, names: Names) -> n.Chain | None:
    """Return what is near of changes, Δx ≈ J Δq, as an equation of small displacements; None where a side tells of none."""
    changes = [
        [each for each in n.names(member) if each.key == _FINITE and names.is_open(each)] for member in chain.members
    ]
    if set(chain.relations) != {"≈"} or not all(changes):
        return None
    members = tuple(
        n.substitute_each(member, {id(sign): replace(sign, base=_SIGNS[1]) for sign in signs})
        for member, signs in zip(chain.members, changes, strict=True)
    )
    return replace(chain, members=members, relations=("=",) * len(chain.relations))


def with_rates(chain: n.Chain, names: Names) -> n.Chain | None:
    """Return an equation of displacements as one of rates; None where a side has none, or d or δ may be a name."""
    if names.arm is None or set(chain.relations) != {"="}:
        return None
    members = tuple(_with_rates(member, names) for member in chain.members)
    told = all(_signs(member) for member in chain.members)
    left = any(_signs(member) for member in members)
    of_joints_alone = all(_is_joint(name, names) for member in members for name in _rates(member))
    return replace(chain, members=members) if told and not left and not of_joints_alone else None


def is_of_rates(chain: n.Chain, names: Names) -> bool:
    """Whether the rates of a side are those of joints alone: dx = dx_1 + dx_2 may be of parts that nobody names."""
    return any(all(_is_joint(name, names) for name in _rates(member)) for member in chain.members)


def _signs(node: n.Node) -> list[n.Name]:
    return [below for below in n.names(node) if below.key in _SIGNS]


def _rates(node: n.Node) -> list[n.Name]:
    return [below for below in n.names(node) if below.dots]


def _is_joint(name: n.Name, names: Names) -> bool:
    assert names.arm is not None
    symbol = names.known_symbol(replace(name, dots=0).key)
    return name.base in ("q", "theta") or symbol in names.joints


def _with_rates(node: n.Node, names: Names) -> n.Node:
    """Return a tree with \\dot q for each δ q, of a joint variable or of a quantity of the arm."""
    if isinstance(node, n.Product):
        factors, operators = [*node.factors], ["", *node.operators]
        for at in reversed(range(1, len(factors))):
            sign, name = factors[at - 1 : at + 1]
            if isinstance(name, n.Name) and operators[at] == "" and sign in _signs(sign) and _moves(sign, name, names):
                factors[at - 1 : at + 1] = [replace(name, dots=1, span=(sign.span[0], name.span[1]))]
                del operators[at]
        if len(factors) < len(node.factors):
            rates = factors[0] if len(factors) == 1 else replace(node, factors=(*factors,), operators=(*operators[1:],))
            return _with_rates(rates, names)
    return n.substitute_each(node, {id(below): _with_rates(below, names) for below in n.children(node)})


def _moves(sign: n.Node, name: n.Name, names: Names) -> bool:
    """Whether a letter before a name is the sign of its displacement: the letter means nothing, and the name moves."""
    is_length = names.known_symbol(name.key) is not None and not _is_joint(name, names)
    moves = _is_joint(name, names) or names.quantity(name) is not None or is_usual(name)
    return names.is_open(sign) and not name.dots and not is_length and moves  # type: ignore[arg-type]
