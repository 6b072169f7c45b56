r"""Coordinates that add up links by their angles, l_1 \cos\theta_1 + l_2 \cos\theta_2, where the text measures \theta_2 from the link before."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.document.told_relative import RELATIVE
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict


def unless_relative(outcome: Outcome, meant: Sequence[str], names: Names) -> Outcome:
    """Leave open what adds up links by angles of their own, and the coordinate that it defines, where the text has an angle relative to the link before."""
    told = {names.reader.key_of(each.removeprefix(RELATIVE).strip()) for each in meant if each.startswith(RELATIVE)}
    if not told or names.arm is not None:
        return outcome
    by_own = next((key for node in outcome.nodes for key in _by_own_angles(node) if key in told), None)
    if by_own is None:
        return outcome
    doubt = say(Kind.MEANT_OTHERWISE, name=by_own)
    for key in {*outcome.defines, *filter(None, map(bare_key, outcome.nodes))}:
        names.doubt(key)
    return outcome if outcome.verdict is Verdict.UNCHECKED else outcome.left_open(doubt)


def _by_own_angles(node: n.Node) -> Iterator[str]:
    """Yield the angles by which a sum, or a row of a Jacobian, turns a link where it turns the link before by its angle alone."""
    for terms in (each for below in n.walk(node) for each in _terms(below)):
        alone = {key for term in terms if (key := _turned_by(term))}
        for key in alone:
            letter, _, number = key.rpartition("_")
            if number.isdigit() and f"{letter}_{int(number) - 1}" in alone:
                yield key


def _terms(node: n.Node) -> Iterator[Sequence[n.Node]]:
    if isinstance(node, n.Sum):
        yield [term for _, term in node.terms]
    elif isinstance(node, n.Matrix):
        yield from node.rows


def _turned_by(term: n.Node) -> str:
    """Return the one angle of which a term holds the sine or the cosine, and of no other: θ_2 of l_2 cos θ_2."""
    calls = [each for each in n.walk(term) if n.is_call(each, "cos", "sin")]
    inner = bare(calls[0].arguments[0]) if len(calls) == 1 else None  # type: ignore[attr-defined]
    if isinstance(inner, n.JointAngles) and [sign for sign, _ in inner.terms] == [1]:
        return f"theta_{inner.terms[0][1]}"
    return inner.key if isinstance(inner, n.Name) else ""
