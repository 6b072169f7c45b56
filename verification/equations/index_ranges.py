r"""The range of an index behind a law, i = 1, …, n: what holds for any index holds for those, and the range claims nothing."""

from __future__ import annotations

from armproof.verification.equations.each_joint import index_of
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

FIRST = (0, 1)  # a range that begins later is of some links alone
OF_ALL = ("if", "words")  # for i = 1, 2, 3; ∀ i


def without_index_range(statements: list[n.Statement]) -> list[n.Statement]:
    """Leave out the range of the index of what stands before it; a law is proved of any index, and refuted of none."""
    letters: set[str] = set()  # of the chains before
    for place, statement in enumerate(statements):
        if not isinstance(statement, n.Chain):
            continue
        if len(letters) == 1 and _is_range(statement, *letters):
            after = place + 1
            while after < len(statements) and _goes_on(statements[after]):
                after += 1
            word = statements[place - 1]
            first = place - (isinstance(word, n.Connective) and word.kind in OF_ALL)
            return [*statements[:first], *without_index_range(statements[after:])]
        letters |= {index_of(statement)} - {""}
    return statements


def _is_range(chain: n.Chain, letter: str) -> bool:
    """Whether a chain is i = 1, i = 1..3, 1 ≤ i ≤ n, i ∈ {1, 2, 3}, or after ∀ the index alone."""
    keys = [node.key if isinstance(node := bare(each), n.Name) else "" for each in chain.members]
    if letter not in keys:
        return False
    ends = [bare(each) for each, key in zip(chain.members, keys, strict=True) if key != letter]
    if not all(isinstance(end, n.Number | n.Name | n.Sequence | n.Sum) for end in ends):
        return False
    first = ends[0] if ends else None
    first = bare(first.items[0]) if isinstance(first, n.Sequence) and first.items else first
    return first is None or (isinstance(first, n.Number) and first.value in FIRST)


def _goes_on(statement: n.Statement) -> bool:
    """Whether a statement is one more index of a range: 2, …, n - 1, or a word between two."""
    if isinstance(statement, n.Connective):
        return statement.kind == "words" and statement.text.strip().lower() in ("to", "à", "bis", "until")
    if not isinstance(statement, n.Chain) or statement.relations:
        return False
    end = bare(statement.members[0])
    name = end.key if isinstance(end, n.Name) else ""
    return isinstance(end, n.Number | n.Dots) or name in ("n", "N") or isinstance(end, n.Sum)
