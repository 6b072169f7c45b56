"""Names that a display equates to a formula of which nothing has a value: W = P_x − a_x d_6. They are no new names any more."""

from __future__ import annotations

from collections.abc import Iterable

from armproof.verification.document.heading import encloses, sections_around
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names

_PLAIN = n.Name | n.Number | n.Sum | n.Product | n.Quotient | n.Power | n.Group | n.JointAngles


def heed_formula(names: Names, sides: Iterable[n.Node], line: int) -> None:
    """Remember what a name is equated to, where that is a formula of other names: what is unwritten, or a root, says less."""
    keys, formulas = [], list[n.Node]()
    for side in sides:
        key = bare_key(side)
        keys += [key] if key is not None else []
        formulas += [side] if key is None else []
    for key in keys if any(map(_is_formula, formulas)) else ():
        names.state.without_value.setdefault(key, (line, names.state.section))


def said_otherwise(names: Names, key: str, line: int) -> Finding | None:
    """Return the doubt where a display above says of a name what it is, by names without a value: another formula is no definition.

    That the two are equal is what is claimed then, and nobody can tell.
    """
    said, section = names.state.without_value.get(key, (line, ""))
    here = names.state.section
    steps = sections_around(section)[:1] == sections_around(here)[:1] != ()  # of one derivation
    if said == line or not (encloses(section, here) or steps):
        return None
    return say(Kind.SECOND_MEANING, name=key, line=said)


def _is_formula(node: n.Node) -> bool:
    """Whether a tree is a sum or a product of names, their sines and cosines among them, and no name alone."""
    below = [*n.walk(node)]
    return isinstance(bare(node), n.Sum | n.Product | n.Quotient) and all(
        isinstance(each, _PLAIN) or n.is_call(each, "cos", "sin") for each in below
    )
