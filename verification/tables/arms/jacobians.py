"""The coordinates of the tool that a Jacobian is of: what turns about z has x = ∂y/∂θ_1 and y = -∂x/∂θ_1."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.algebra.calculus import angles_in, derivative, symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display, Document
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.moving import index_of, place_of
from armproof.verification.naming.names import Names
from armproof.verification.tables.arms.letters import equations_of, unapplied, value_in_letters

_SUBSCRIPTS = ("", "v", "P", "p", "L", "A", "a")

Found = dict[str, tuple[Scalar, Display]]


def coordinates_of_jacobian(
    document: Document, names: Names, algebra: ExactAlgebra, letters: dict[str, n.Name]
) -> tuple[list[Found], bool]:
    """Return x and y of the tool, with the display, by the one Jacobian of a planar arm that a document prints; nothing of another one.

    Also whether that, or where it is printed again one of the two, has an entry that is no derivative of them: then they may be several.
    """
    printed = list(_jacobians(document, names, algebra))
    told = [
        (_point(value), value, used, display) for value, used, display, _ in printed if any(map(angles_in, value.cells))
    ]
    named = [id(value) for value, *_, is_named in printed if is_named]
    found = [(point, used, display) for point, _, used, display in told if point is not None]
    wrong = [value for point, value, *_ in told if point is None]
    if not found and len(told) == 1:
        [(_, value, used, display)] = told
        found = [(point, used, display) for point in _points_with_a_slip(value)]
    elif found:
        first = found[0][0]
        if any(point is not None and id(value) in named for point, value, *_ in told):  # J^T and J^{-1} are made of it
            wrong = [value for value in wrong if id(value) in named]
        is_near = all(any(_is_same(point, first) for point in _points_with_a_slip(value)) for value in wrong)
        found = found[:1] if is_near and all(_is_same(point, first) for point, *_ in found) else []
    letters.update({name.key: name for _, used, _ in found for name in used})
    return [{axis: (value, display) for axis, value in zip("xy", point, strict=True)} for point, _, display in found], bool(wrong)  # fmt: skip


def _points_with_a_slip(jacobian: Matrix) -> list[tuple[Scalar, Scalar]]:
    """Return x and y of which all entries of a matrix but one are the derivatives, in each way in which they may be."""
    if jacobian.shape[0] not in (2, 3, 6):
        return []
    coordinates = _coordinates(jacobian)
    if any(not each.denominator.is_one() for each in coordinates):
        return []  # of an inverse with a slip, and of no arm
    found: list[tuple[Scalar, Scalar]] = []
    for row, column in jacobian.places:
        for letter in sorted(symbols_in(coordinates)) if row < len(coordinates) else ():
            entry = derivative(coordinates[row], jacobian.rows[0][0].ring.symbol(letter)).normal()
            cells = [
                [entry if (r, c) == (row, column) else jacobian.rows[r][c] for c in range(jacobian.shape[1])]
                for r in range(jacobian.shape[0])
            ]
            point = _point(Matrix(tuple(map(tuple, cells))))
            if point is not None and not any(_is_same(point, other) for other in found):
                found.append(point)
    return found


def _is_same(one: tuple[Scalar, Scalar], other: tuple[Scalar, Scalar]) -> bool:
    return all(map(_is_equal, one, other))


def _jacobians(
    document: Document, names: Names, algebra: ExactAlgebra
) -> Iterator[tuple[Matrix, tuple[n.Name, ...], Display, bool]]:
    """Yield the matrices that J, J_v, J^T or J^{-1} is equated to, as J, with the letters in them, and whether it is J itself."""
    for display in document.displays:
        for chain in equations_of(display, names) if "J" in display.latex else ():
            turned = _turned(chain.members[0])
            printed = n.Postfix(chain.members[-1], turned) if turned else chain.members[-1]
            evaluated = value_in_letters(printed, names, algebra) if turned is not None else None
            if evaluated is not None and isinstance(evaluated[0], Matrix):
                yield evaluated[0].map(lambda cell: cell.normal()), evaluated[1], display, turned == ""


def _turned(node: n.Node) -> str | None:
    """Return "" for a Jacobian by name, what turns J^T and J^{-1} into it, None for anything else."""
    node = bare(node)
    if isinstance(node, n.Postfix) and node.operator in ("T", "-1"):
        return node.operator if _turned(node.base) == "" else None
    name = unapplied(node)
    is_named = isinstance(name, n.Name) and name.base == "J" and name.sub in _SUBSCRIPTS and not name.dots
    return "" if is_named and {name.sup, name.pre_sup, name.pre_sub} <= {"", "0"} else None  # type: ignore[attr-defined]


def _point(jacobian: Matrix) -> tuple[Scalar, Scalar] | None:
    """Return x and y of which the first two rows are the derivatives by one letter a column, in the order of their numbers."""
    if jacobian.shape[0] not in (2, 3, 6) or jacobian.shape[1] < 2:
        return None
    x, y = _coordinates(jacobian)
    angles = sorted(angles_in(x) | angles_in(y), key=place_of)
    slides = sorted(symbols_in([x, y]) - set(angles), key=place_of)
    columns = [*zip(*jacobian.rows, strict=True)]
    moving = [next((v for v in (*angles, *slides) if _is_by(column, x, y, v)), "") for column in columns]
    is_whole = moving[0] in angles and all(moving) and set(angles) <= set(moving) and len({*moving}) == len(moving)
    in_order = [index_of(each) for each in moving] == sorted(map(index_of, moving))
    return (x, y) if is_whole and in_order and all(map(_is_level, columns, [v in angles for v in moving])) else None


def _coordinates(jacobian: Matrix) -> tuple[Scalar, Scalar]:
    """Return x and y of a tool that the first joint turns about the origin, by its first column."""
    return jacobian.rows[1][0].normal(), (-jacobian.rows[0][0]).normal()


def _is_by(column: Sequence[Scalar], x: Scalar, y: Scalar, letter: str) -> bool:
    """Whether a column holds the derivatives of x and y by a letter."""
    symbol = x.ring.symbol(letter)
    return all(_is_equal(derivative(value, symbol), cell) for value, cell in zip((x, y), column, strict=False))


def _is_equal(one: Scalar, other: Scalar) -> bool:
    return (one - other).normal().is_zero()


def _is_level(column: Sequence[Scalar], turns: bool) -> bool:
    """Whether what stands below \\dot x and \\dot y is that of a joint in the plane: no height, and a turn about z where it turns."""
    turn = [int(turns)]
    below = {2: [], 3: turn, 6: [0, 0, 0, *turn]}[len(column)]
    rows = [each.as_fraction() for each in column[2:]]
    return rows == below or (len(column) == 3 and set(rows) == {0})
