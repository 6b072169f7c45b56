"""What a whole matrix that disagrees is instead: transposed, inverted, in another frame, of another convention."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Matrix, column
from armproof.verification.algebra.protocol import link_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.equations.alignment import equal_matrices
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.naming.quantities import numbered_frames


def explain_whole(checker: ChainChecker, outcome: Outcome) -> str | None:
    """Return in words which other usual matrix was printed, or None."""
    pair, true = outcome.pair, outcome.true
    if pair is None or true is None or outcome.sampled_only:
        return None
    try:
        if all(isinstance(cell, Scalar) and cell.is_zero() for row in pair.printed.rows for cell in row):
            return None  # zeros are everything's special case
        for words, candidate in _candidates(checker, outcome):
            if equal_matrices(candidate, pair.printed):
                return words
    except ArmproofError:
        pass
    return None


def _candidates(checker: ChainChecker, outcome: Outcome) -> Iterator[tuple[str, Matrix]]:
    pair = outcome.pair
    assert pair is not None and outcome.true is not None
    true = pair.true
    node = outcome.true.node
    general = isinstance(node, n.Name) and node.base == "link"
    quantity = Quantity("link", node.sub) if general else checker.quantity_of(node)  # type: ignore[attr-defined]
    if quantity is not None and quantity.kind in ("pose", "rotation"):
        yield _inverse(checker, quantity, outcome.true.node)
    if true.shape[0] == true.shape[1] > 1:
        yield "the matrix is transposed", true.transpose
    if not pair.is_scalar:
        yield "wrong sign of the whole", true.map(lambda cell: -cell)
    if quantity is None:
        if true.shape == (4, 4):
            yield "the inverse is printed", _inverse_pose(true)
        return
    if quantity.kind in ("pose", "rotation"):
        yield from _poses(checker, quantity)
    elif quantity.kind == "jacobian":
        yield from _jacobians(checker, quantity, pair.true_rows)
    elif quantity.kind == "link":
        other = "classic" if quantity.frame == "modified" else "modified"
        exact = checker.exact
        here, there = ("i-1", "i") if quantity.frame == "modified" else ("i", "i-1")
        renamed = {f"{letter}_{there}": exact.symbol(f"{letter}_{here}") for letter in ("a", "alpha")}
        words = f"this is the {other} link matrix, the {quantity.frame} one is meant"
        for matrix in (link_matrix(exact, other), exact.substitute(link_matrix(exact, other), renamed)):
            yield words, matrix
    elif quantity.kind in ("origin", "axis"):
        yield from _vectors(checker, quantity)


def _inverse_pose(pose: Matrix) -> Matrix:
    rotation = pose.block(range(3), range(3)).transpose
    origin = -(rotation @ pose.block(range(3), [3]))
    rows = [(*rotation.rows[k], origin.rows[k][0]) for k in range(3)]
    return Matrix((*rows, pose.rows[3]))


def _inverse(checker: ChainChecker, quantity: Quantity, node: n.Node) -> tuple[str, Matrix]:
    words = f"the inverse is printed: the pose of frame {quantity.reference} in frame {quantity.frame}"
    if isinstance(node, n.Name) and node.sub and node.sup:
        index = "lower" if checker.names.transforms == "upper" else "upper"
        words += f"; if the {index} index of {node.text} names the reference frame, say 'transforms: {index}' in the front matter"
    return words, checker.exact.quantity(Quantity(quantity.kind, quantity.reference, quantity.frame))


def _poses(checker: ChainChecker, quantity: Quantity) -> Iterator[tuple[str, Matrix]]:
    exact = checker.exact
    arm = checker.names.arm
    assert arm is not None
    for frame in arm.frames:
        if frame != quantity.frame:
            yield (
                f"this is the pose of frame {frame}, not {quantity.frame}",
                exact.quantity(Quantity(quantity.kind, frame, quantity.reference)),
            )
        if frame != quantity.reference:
            words = f"this is the pose in frame {frame}, not {quantity.reference}"
            yield words, exact.quantity(Quantity(quantity.kind, quantity.frame, frame))
    true = exact.quantity(quantity)
    for joint in arm.joints:  # a joint that turns the other way, or an angle counted from elsewhere
        for words, value in (
            (f"joint {joint.symbol} is taken the other way", -exact.symbol(joint.symbol)),
            *(
                [(f"{joint.symbol} is counted from another zero: off by {name}", exact.symbol(joint.symbol) + exact.pi() * turn)
                 for name, turn in (("π/2", _half(exact)), ("-π/2", -_half(exact)), ("π", exact.ring.one))]
                if joint.kind == "revolute" else []
            ),
        ):  # fmt: skip
            yield words, exact.substitute(true, {joint.symbol: value})
    if quantity.kind == "pose":
        yield from _other_convention(checker, quantity)


def _half(exact: object) -> Scalar:
    from fractions import Fraction

    return exact.ring.rational(Fraction(1, 2))  # type: ignore[attr-defined]


def _other_convention(checker: ChainChecker, quantity: Quantity) -> Iterator[tuple[str, Matrix]]:
    """A link matrix built from the right parameters in the other convention."""
    exact = checker.exact
    pose = exact.quantity(quantity)
    z, x = pose.block(range(3), [2]), pose.block(range(3), [0])
    rotation = pose.block(range(3), range(3))
    p = pose.block(range(3), [3]).vector()
    zero = exact.ring.zero
    # modified: R = Rx(α)Rz(θ): row 1 is (cθ, −sθ, 0), column 3 is (0, −sα, cα); classic: R = Rz(θ)Rx(α)
    if rotation.rows[0][2].is_zero():
        c_theta, s_theta = rotation.rows[0][0], -rotation.rows[0][1]
        s_alpha, c_alpha = -rotation.rows[1][2], rotation.rows[2][2]
        a = p[0]
        d = p[2] * c_alpha - p[1] * s_alpha
        rows = (
            (c_theta, -s_theta * c_alpha, s_theta * s_alpha, a * c_theta),
            (s_theta, c_theta * c_alpha, -c_theta * s_alpha, a * s_theta),
            (zero, s_alpha, c_alpha, d),
        )
        yield (
            "this is the classic link matrix, the arm's frames are those of the modified convention",
            Matrix((*rows, pose.rows[3])),
        )
    if rotation.rows[2][0].is_zero():
        c_theta, s_theta = rotation.rows[0][0], rotation.rows[1][0]
        s_alpha, c_alpha = rotation.rows[2][1], rotation.rows[2][2]
        a = p[0] * c_theta + p[1] * s_theta
        d = p[2]
        rows = (
            (c_theta, -s_theta, zero, a),
            (s_theta * c_alpha, c_theta * c_alpha, -s_alpha, -d * s_alpha),
            (s_theta * s_alpha, c_theta * s_alpha, c_alpha, d * c_alpha),
        )
        yield (
            "this is the modified link matrix, the arm's frames are those of the classic convention",
            Matrix((*rows, pose.rows[3])),
        )
    _ = z, x


def _jacobians(
    checker: ChainChecker, quantity: Quantity, reading: tuple[int, ...] | None
) -> Iterator[tuple[str, Matrix]]:
    exact = checker.exact
    arm = checker.names.arm
    assert arm is not None
    rows = [r - 1 for r in quantity.rows] if quantity.rows else list(reading or range(6))
    count = len(arm.joints)
    columns = [c - 1 for c in quantity.columns] if quantity.columns else list(range(count))

    def chosen(whole: Matrix) -> Matrix:
        return whole.block(rows, columns)

    whole = exact.quantity(Quantity("jacobian", quantity.frame, quantity.reference))
    swapped = whole.block([3, 4, 5, 0, 1, 2], range(count))
    yield "the blocks are swapped: the rows are [ω; v], [v; ω] is meant", chosen(swapped)
    yield "the Jacobian is transposed", chosen(whole).transpose
    for frame in arm.frames:
        if frame != quantity.reference:
            yield (
                f"it is expressed in frame {frame}, not {quantity.reference}",
                chosen(exact.quantity(Quantity("jacobian", quantity.frame, frame))),
            )
    for frame in arm.frames:
        if frame != quantity.frame:
            point = exact.quantity(Quantity("jacobian", frame, quantity.reference))
            yield (
                f"its linear part is that of the origin of frame {frame}, not {quantity.frame}",
                chosen(Matrix((*point.rows[:3], *whole.rows[3:]))),
            )
            yield f"this is the Jacobian of frame {frame}, not {quantity.frame}", chosen(point)
    yield from _other_axes(checker, quantity, whole, rows, columns)
    for k, joint in enumerate(arm.joints):
        turned = Matrix(tuple(tuple(-cell if c == k else cell for c, cell in enumerate(row)) for row in whole.rows))
        yield f"column {k + 1}: joint {joint.symbol} is taken the other way", chosen(turned)
    for i in range(count):
        for j in range(i + 1, count):
            order = list(range(count))
            order[i], order[j] = j, i
            yield f"columns {i + 1} and {j + 1} are swapped", chosen(whole.block(range(6), order))


def _other_axes(
    checker: ChainChecker, quantity: Quantity, whole: Matrix, rows: list[int], columns: list[int]
) -> Iterator[tuple[str, Matrix]]:
    """z_{i-1} on frames of the modified convention, or z_i on those of the classic one."""
    exact = checker.exact
    arm = checker.names.arm
    assert arm is not None
    frames = numbered_frames(arm)
    end = exact.quantity(Quantity("origin", quantity.frame, frames[0]))
    for shift, words in (
        (0, "z_{i-1} stands where z_i is the joint's axis (modified DH)"),
        (1, "z_i stands where z_{i-1} is the joint's axis (classic DH)"),
    ):
        built = []
        for k, joint in enumerate(arm.joints):
            if k + shift >= len(frames):
                return
            axis = exact.quantity(Quantity("axis", frames[k + shift], frames[0]))
            origin = exact.quantity(Quantity("origin", frames[k + shift], frames[0]))
            if joint.kind == "prismatic":
                built.append((*axis.vector(), *(exact.ring.zero,) * 3))
            else:
                arm_vector = column([a - b for a, b in zip(end.vector(), origin.vector(), strict=True)])
                built.append((*axis.cross(arm_vector).vector(), *axis.vector()))
        candidate = Matrix(tuple(zip(*built, strict=True)))
        if quantity.reference == frames[0] and not equal_matrices(candidate, whole):
            yield words, candidate.block(rows, columns)


def _vectors(checker: ChainChecker, quantity: Quantity) -> Iterator[tuple[str, Matrix]]:
    exact = checker.exact
    arm = checker.names.arm
    assert arm is not None
    if quantity.rows or quantity.scalar:
        return
    for frame in arm.frames:
        if frame != quantity.frame:
            yield (
                f"this is that of frame {frame}, not {quantity.frame}",
                exact.quantity(Quantity(quantity.kind, frame, quantity.reference, along=quantity.along)),
            )
        if frame != quantity.reference:
            yield (
                f"it is expressed in frame {frame}, not {quantity.reference}",
                exact.quantity(Quantity(quantity.kind, quantity.frame, frame, along=quantity.along)),
            )
    if quantity.kind == "axis":
        for other in "xyz":
            if other != quantity.along:
                yield (
                    f"this is the {other} axis",
                    exact.quantity(Quantity("axis", quantity.frame, quantity.reference, along=other)),
                )
