r"""Products of free letters: q_1 q_2 = q_2 q_1 holds of numbers, and letters that nothing tells of may be matrices, vectors or quaternions."""

from __future__ import annotations

from itertools import pairwise

from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

Letter = tuple[str, int, bool]  # its key, 1 or -1 where it is inverted, whether it is transposed
MOST = 6  # factors of one power


def unless_exchanged(outcomes: list[Outcome], chain: n.Chain, names: Names) -> list[Outcome]:
    """Leave open what is proved of free letters as numbers, and is no law of factors that may not be exchanged."""
    if names.arm is not None or all(each.verdict is not Verdict.PROVED for each in outcomes):
        return outcomes
    if not any(are_exchanged(one, other, names) for one, other in pairwise(chain.members)):
        return outcomes
    doubt = say(Kind.ORDER_OF_FACTORS)
    return [each.left_open(doubt) if each.verdict is Verdict.PROVED else each for each in outcomes]


def are_exchanged(one: n.Node, other: n.Node, names: Names) -> bool:
    """Whether two sides, or the two terms of a side that is to vanish, are products of the same free letters in another order."""
    for side, rest in ((one, other), (other, one)):
        terms = [term for _, term in side.terms] if isinstance(side := bare(side), n.Sum) else []
        if len(terms) == 2 and isinstance(zero := bare(rest), n.Number) and not zero.value:
            one, other = terms
    words = [_word(one), _word(other)]
    if words[0] is None or words[1] is None:
        return False
    letters = {key for word in words for key, _, _ in word or ()}
    return words[0] != words[1] and len(letters) > 1 and all(names.is_free(_name(key)) for key in letters)


def _name(key: str) -> n.Name:
    base, _, sub = key.partition("_")
    return n.Name(base, sub)


def _word(node: n.Node) -> list[Letter] | None:
    """Return the letters of a product in their order, (a b)^{-1} as b^{-1} a^{-1}; None of what is no product of letters."""
    node = bare(node)
    if isinstance(node, n.Name):
        return [(node.key, 1, False)]
    if isinstance(node, n.Number):
        return []
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        return _word(node.terms[0][1])
    if isinstance(node, n.Postfix) and node.operator in ("T", "-1", "-T"):
        turned = _word(node.base)
        sign, is_transposed = (-1 if "-" in node.operator else 1), "T" in node.operator
        return turned and [(key, power * sign, flag != is_transposed) for key, power, flag in reversed(turned)]
    if isinstance(node, n.Power) and isinstance(node.exponent, n.Number) and node.exponent.value in range(1, MOST):
        repeated = _word(node.base)
        return repeated and repeated * int(node.exponent.value)
    if not isinstance(node, n.Product):
        return None
    word: list[Letter] = []
    for factor in node.factors:
        if (part := _word(factor)) is None:
            return None
        for letter in part:
            inverse = (letter[0], -letter[1], letter[2])
            word = word[:-1] if word and word[-1] == inverse else [*word, letter]
    return word
