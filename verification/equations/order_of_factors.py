r"""Products of free letters: q_1 q_2 = q_2 q_1 holds of numbers, and letters that nothing tells of may be matrices, vectors or quaternions."""

from __future__ import annotations

from itertools import pairwise

from armproof.verification.equations.outcome import Outcome
from armproof.verification.evaluation.screws import HAT, is_exponential, split
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import reads_as_length
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

Letter = tuple[str, int, bool]  # its key, 1 or -1 where it is inverted, whether it is transposed
MOST = 6  # factors of one power
_HELD = (Verdict.PROVED, Verdict.CONFIRMED)
_OF_MATRICES = ("det", "tr", "trace", "rank")
_OF_ANY = (*_OF_MATRICES, "abs", "norm")


def unless_exchanged(outcomes: list[Outcome], chain: n.Chain, names: Names) -> list[Outcome]:
    """Leave open, where there is no arm, what is proved of free letters as numbers, and is no law of factors that may not be exchanged."""
    if all(each.verdict not in _HELD for each in outcomes):
        return outcomes
    if any("×" in below.operators for below in n.walk(chain) if isinstance(below, n.Product)):
        return outcomes  # the letters are vectors, and so they were taken
    words = [_word(member) for member in chain.members]
    if words[0] is not None and all(word == words[0] for word in words):
        return outcomes
    exchanged = any(are_exchanged(one, other, names) for one, other in pairwise(chain.members))
    if not exchanged and not _stand_both_ways(chain, names) and not _are_more_than_numbers(chain, names):
        return outcomes
    doubt = say(Kind.ORDER_OF_FACTORS)
    return [each.left_open(doubt) if each.verdict in _HELD else each for each in outcomes]


def _stand_both_ways(chain: n.Chain, names: Names) -> bool:
    """Whether two free letters are multiplied in one order and in the other: a (b + c) = b a + c a."""
    products = [below for below in n.walk(chain) if isinstance(below, n.Product)]
    numbers = _numbers(chain)
    pairs = {
        (one, other)
        for each in products
        for before, behind in pairwise(each.factors)
        for one in _letters(before, names) - numbers
        for other in _letters(behind, names) - numbers
        if one != other
    }
    return any((other, one) in pairs for one, other in pairs)


def _numbers(chain: n.Chain) -> set[str]:
    """Return the letters that a chain itself shows to be numbers: what divides, what a function is of, and what such a letter is added to."""
    nodes = [*n.walk(chain)]
    places = [below.denominator for below in nodes if isinstance(below, n.Quotient)]
    places += [
        each
        for below in nodes
        if isinstance(below, n.Call) and below.function not in _OF_ANY
        for each in below.arguments
    ]
    numbers = {below.key for place in places for below in n.names(place)}
    for below in nodes:
        if isinstance(below, n.Sum):
            named = (bare(term) for _, term in below.terms)
            terms = {each.key for each in named if isinstance(each, n.Name)}
            numbers |= terms if terms & numbers else set()
    return numbers


def _are_more_than_numbers(chain: n.Chain, names: Names) -> bool:
    """Whether free letters are transposed, have a determinant or a trace, or make a product with a dot whose size is taken."""
    for below in n.walk(chain):
        if isinstance(below, n.Postfix) and below.operator in ("T", "-T", "+") and _letters(below.base, names):
            return True
        if not isinstance(below, n.Call):
            continue
        inner = bare(below.arguments[0]) if below.arguments else below
        if below.function in _OF_MATRICES and _letters(inner, names):
            return True
        is_dotted = isinstance(inner, n.Product) and "⋅" in inner.operators and len(_letters(inner, names)) > 1
        if below.function in ("abs", "norm") and is_dotted:
            return True
    return False


def _letters(node: n.Node, names: Names) -> set[str]:
    """Return the free letters of a factor that are no lengths; what stands in a function, a motion or a printed matrix is a number."""
    node = bare(node)
    if isinstance(node, n.Name):
        return {node.key} if _is_untold(node, names) and not reads_as_length(node.key) else set()
    if isinstance(node, n.Call | n.Quotient | n.Matrix) or _is_motion(node):
        return set()
    return {key for below in n.children(node) for key in _letters(below, names)}


def _is_motion(node: n.Node) -> bool:
    r"""Whether a factor is the exponential of a twist that is written as a matrix, e^{\hat\xi_1θ_1} or e^{[S_1]θ_1}: θ_1 is a number there."""
    exponent = is_exponential(node)
    twist = split(exponent)[0] if exponent is not None else None
    is_hat = isinstance(twist, n.Name) and twist.base.startswith(HAT)
    return is_hat or (isinstance(twist, n.Group) and twist.brackets == "[]")


def are_exchanged(one: n.Node, other: n.Node, names: Names) -> bool:
    """Whether two sides, or the two terms of a side that is to vanish, are products of the same free letters in another order."""
    for side, rest in ((one, other), (other, one)):
        terms = [term for _, term in side.terms] if isinstance(side := bare(side), n.Sum) else []
        if len(terms) == 2 and isinstance(zero := bare(rest), n.Number) and not zero.value:
            one, other = terms
    words = [_word(one), _word(other)]
    if words[0] is None or words[1] is None or words[0] == words[1]:
        return False
    letters = [sorted(key for key, _, _ in word) for word in words if word is not None]
    return (
        letters[0] == letters[1] and len({*letters[0]}) > 1 and all(_is_untold(_name(key), names) for key in letters[0])
    )


def _is_untold(name: n.Name, names: Names) -> bool:
    """Whether nothing says what a letter is."""
    return names.is_free(name) and name.key not in names.symbols and name.key not in names.state.definitions


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
