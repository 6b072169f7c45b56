"""What may mend a display that has no wrong entry: another relation, size or label, or the square of a matrix."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.correction.alternatives import Corrections
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.patterns import regex
from armproof.verification.verdict import Correction

_RELATIONS = regex(r"\\(?:neq|ne|leq?|geq?|l[te]|g[te])(?![A-Za-z])|[<>]|\\not\s*=")
_OTHER = {"le": r"\geq", "leq": r"\geq", "lt": ">", "<": ">", "ge": r"\leq", "geq": r"\leq", "gt": "<", ">": "<"}
_SIZE = regex(r"\d+(?=\s*\\times)|(?<=\\times)\s*\d+")


def rephrasings(latex: str, statements: list[n.Statement], checker: ChainChecker) -> Iterator[Corrections]:
    """Yield what may mend a display as a whole, the smallest change first; places count in the normalised LaTeX."""
    yield from _other_relation(latex)
    for statement in statements:
        for below in n.walk(statement):
            if isinstance(below, n.Labelled):
                yield from _other_label(latex, below, checker)
    yield from _other_size(latex, statements, checker)
    yield from _coordinates(latex, statements, checker)
    if any(isinstance(statement, n.Connective) for statement in statements):  # elsewhere another determinant is meant
        yield from _gram(latex, statements, checker)
    yield from _left_inverse(latex, statements)
    yield from _pseudo_inverse(latex, statements)


def _other_relation(latex: str) -> Iterator[Corrections]:
    for found in _RELATIONS.finditer(latex):
        other = _OTHER.get(found.group().lstrip("\\"), "=")
        yield (Correction(found.start(), found.end(), other),)


def _value(node: n.Node, checker: ChainChecker) -> object:
    try:
        return checker.member(node).value
    except ArmproofError:
        return None


# -- labels and sizes --------------------------------------------------------------------------------------------------


def _other_label(latex: str, node: n.Labelled, checker: ChainChecker) -> Iterator[Corrections]:
    """The size that the braced matrix has; else the expression without its label."""
    start, end = node.span
    value = _value(node.inner, checker)
    if node.size is not None and isinstance(value, Matrix):
        yield _sized(latex, node.inner.span[1], end, value)
    if node.label is not None:
        yield (Correction(start, end, latex[slice(*node.inner.span)].strip()),)


def _other_size(latex: str, statements: list[n.Statement], checker: ChainChecker) -> Iterator[Corrections]:
    r"""The size after \in \mathbb{R}^{m \times n} that the matrix before it has."""
    for chain in statements:
        if isinstance(chain, n.Chain) and chain.relations == ("∈",):
            value = _value(chain.members[0], checker)
            if isinstance(value, Matrix):
                yield _sized(latex, *chain.members[1].span, value)


def _coordinates(latex: str, statements: list[n.Statement], checker: ChainChecker) -> Iterator[Corrections]:
    """[p; 1] and [p; 0] for each vector p of three coordinates, where it is equated to four."""
    for chain in statements:
        if not isinstance(chain, n.Chain):
            continue
        values = [_value(member, checker) for member in chain.members]
        shapes = [value.shape if isinstance(value, Matrix) else None for value in values]
        if set(shapes) != {(3, 1), (4, 1)}:
            continue
        short = [member.span for member, shape in zip(chain.members, shapes, strict=True) if shape == (3, 1)]
        for last in "01":
            yield tuple(
                Correction(*span, rf"\begin{{bmatrix}} {latex[slice(*span)].strip()} \\ {last} \end{{bmatrix}}")
                for span in short
            )


def _sized(latex: str, start: int, end: int, value: Matrix) -> Corrections:
    places = list(_SIZE.finditer(latex, start, end))
    if len(places) != 2:
        return ()
    return tuple(
        Correction(place.end() - len(place.group().strip()), place.end(), str(size))
        for place, size in zip(places, value.shape, strict=True)
        if place.group().strip() != str(size)
    )


# -- matrices that are not square --------------------------------------------------------------------------------------


def _gram(latex: str, statements: list[n.Statement], checker: ChainChecker) -> Iterator[Corrections]:
    """det(JᵀJ) for det(J) of a matrix with more rows than columns, det(JJᵀ) of one with fewer."""
    for below in (b for s in statements for b in n.walk(s)):
        if n.is_call(below, "det", "abs") and len(below.arguments) == 1:
            argument = below.arguments[0]
            value = _value(argument, checker)
            if isinstance(value, Matrix) and value.shape[0] != value.shape[1]:
                text = latex[slice(*argument.span)].strip()
                one = text if isinstance(bare(argument), n.Name | n.Matrix) else f"({text})"
                product = f"{one}^T {one}" if value.shape[0] > value.shape[1] else f"{one} {one}^T"
                start, end = argument.span
                bracketed = latex[end : end + 1] in (")", "|", "]") or latex[end:].lstrip().startswith("\\right")
                yield (Correction(start, end, product if bracketed else f"({product})"),)


def _left_inverse(latex: str, statements: list[n.Statement]) -> Iterator[Corrections]:
    """(AᵀA)⁻¹Aᵀ for Aᵀ(AAᵀ)⁻¹ and the other way round, the inverse that they are of written as a pseudo-inverse."""
    pseudo = tuple(change for changes in _pseudo_inverse(latex, statements) for change in changes)
    for below in (b for s in statements for b in n.walk(s)):
        if (text := _other_side(latex, below)) is not None:
            inside = Correction(*below.span, text)
            outside = tuple(c for c in pseudo if not (below.span[0] <= c.start and c.end <= below.span[1]))
            yield tuple(sorted((*outside, inside), key=lambda c: c.start))
            if outside:
                yield (inside,)


def _other_side(latex: str, node: n.Node) -> str | None:
    if not isinstance(node, n.Product) or len(node.factors) != 2:
        return None
    a, b = node.factors
    for transposed, inverse, left in ((a, b, False), (b, a, True)):
        if not (isinstance(inverse, n.Postfix) and inverse.operator == "-1" and isinstance(inverse.base, n.Group)):
            continue
        if not (isinstance(transposed, n.Postfix) and transposed.operator == "T"):
            continue
        base = latex[slice(*transposed.base.span)].strip()
        opening, closing = inverse.base.brackets[0], inverse.base.brackets[1]
        power, turned = latex[inverse.base.span[1] : inverse.span[1]], latex[slice(*transposed.span)].strip()
        if left:
            return f"{turned} {opening}{base} {turned}{closing}{power}"
        return f"{opening}{turned} {base}{closing}{power} {turned}"
    return None


def _pseudo_inverse(latex: str, statements: list[n.Statement]) -> Iterator[Corrections]:
    """J⁺ for J⁻¹ of a name."""
    found = [
        below
        for s in statements
        for below in n.walk(s)
        if isinstance(below, n.Postfix) and below.operator == "-1" and isinstance(below.base, n.Name)
    ]
    if found:
        yield tuple(Correction(*below.span, f"{latex[slice(*below.base.span)].strip()}^{{+}}") for below in found)
