"""The value of an expression tree in an algebra, under a document's bindings."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from verification.algebras import Algebra, OutsideAlgebra, SampledAlgebra, Value, elementary
from verification.errors import EvaluationError, ShapeError, UnboundName
from verification.latex import nodes as n
from verification.matrix import Matrix, column
from verification.names import Names, call_key
from verification.quantities import Quantity, numbered_frames, transform_pair

MAX_DEPTH = 150


class Identity:
    """An identity matrix whose size is left to its surroundings."""


class Evaluator:
    """Evaluates nodes; `branch` is the sign that ± takes (∓ takes the other)."""

    def __init__(self, names: Names, algebra: Algebra, branch: int = 1) -> None:
        self.names = names
        self.algebra = algebra
        self.branch = branch
        self.depth = 0

    def evaluate(self, node: n.Node) -> Value:
        """Return the value; raises UnboundName, EvaluationError."""
        self.depth += 1
        try:
            self.algebra.check_time()
            if self.depth > MAX_DEPTH:
                raise EvaluationError("nested too deeply")
            method = _METHODS.get(type(node))
            if method is None:
                raise EvaluationError("a differential stands outside a derivative")
            return method(self, node)
        finally:
            self.depth -= 1

    def scalar(self, node: n.Node) -> Any:
        """Return the value of a node that must be a scalar."""
        value = as_scalar(self.evaluate(node))
        if isinstance(value, Matrix | Identity | list):
            raise EvaluationError("a scalar is expected where a matrix stands")
        return value

    # -- leaves ----------------------------------------------------------------------------------------------------

    def _number(self, node: n.Number) -> Value:
        return self.algebra.rational(node.value)

    def _name(self, node: n.Name) -> Value:
        algebra, names = self.algebra, self.names
        if node.base == "words":
            raise UnboundName(node.text, "words stand for a value")
        if (quantity := names.quantities.get(node.key)) is not None:
            return algebra.quantity(quantity)
        if node.dots:
            return self._time_derivative(node)
        symbol = names.known_symbol(node.key)
        if symbol is not None:
            return algebra.symbol(symbol)
        if node.key in names.definitions:
            return names.definitions[node.key].evaluate(algebra)
        if (quantity := names.quantity(node)) is not None:
            return algebra.quantity(quantity)
        if node.key == "pi":
            return algebra.pi()
        if node.base in ("I", "Id", "E") and not (node.pre_sub or node.pre_sup or node.sup):
            if (size := re.fullmatch(r"([1-9])(?:x\1)?", node.sub)) is not None:
                return identity(algebra, int(size.group(1)))
            if not node.sub and node.base != "E":
                return Identity()
        if names.is_free(node):
            names.used.add(node.key)
            return algebra.symbol(node.key)
        if node.key == "q" and names.arm is not None:
            return column([algebra.symbol(joint.symbol) for joint in names.arm.joints])
        if (angles := names.angle_sum(node)) is not None:
            return self._joint_angles(angles)
        if (added := names.added_frame(node)) is not None:
            return self._to_added_frame(node, *added)
        self._reject_unknown_frame(node)
        raise UnboundName(node.key)

    def _to_added_frame(self, node: n.Name, reference: str, frame: str, key: str) -> Matrix:
        """The transform to a frame that the document fixed on one of the arm's, such as a tool."""
        fixed = self.names.definitions[key].evaluate(self.algebra)
        if not isinstance(fixed, Matrix) or fixed.shape != (4, 4):
            raise UnboundName(node.key)
        whole = self.algebra.quantity(Quantity("pose", frame, reference)) @ fixed
        return whole.block(range(3), range(3)) if node.base == "R" else whole

    def _reject_unknown_frame(self, node: n.Name) -> None:
        """A transform between numbered frames that the arm does not have is a slip, not a new name."""
        arm = self.names.arm
        if arm is None or node.base not in ("T", "A", "H", "R") or node.primes:
            return
        indices = [index for index in (node.pre_sup, node.pre_sub, node.sup, node.sub) if index]
        numbered = numbered_frames(arm)
        if transform_pair(node, arm, self.names.transforms) == (numbered[-1], str(len(numbered))):
            return  # ^3_4T of an arm with three joints: the tool's frame, which the display may define
        if len(indices) == 2 and all(index in arm.frames or index.isdigit() for index in indices):
            missing = next((index for index in indices if index not in arm.frames), None)
            if missing is not None:
                raise EvaluationError(f"no frame '{missing}' on arm '{arm.name}'; its frames are {', '.join(arm.frames)}")

    def _joint_angles(self, node: n.JointAngles) -> Any:
        total = self.algebra.rational(Fraction(0))
        for sign, index in node.terms:
            symbol = self.names.joint_angle(index)
            if symbol is None:
                raise ShapeError(f"the arm has no joint angle {index}")
            angle = self.algebra.symbol(symbol)
            total = total + angle if sign > 0 else total - angle
        return total

    def _dots(self, _node: n.Dots) -> Value:
        raise UnboundName("…", "an ellipsis leaves terms to the reader")

    def _layout(self, _node: n.Layout) -> Value:
        raise EvaluationError("several equations stand where one value is expected")

    # -- arithmetic ------------------------------------------------------------------------------------------------

    def _sum(self, node: n.Sum) -> Value:
        total: Value = None
        for sign, term in node.terms:
            value = _stacked(as_scalar(self.evaluate(term)))
            if sign == "-" or (sign == "±" and self.branch < 0) or (sign == "∓" and self.branch > 0):
                value = -value if not isinstance(value, Identity) else _no_size()
            total = value if total is None else self._add(total, value)
        return total

    def _add(self, a: Value, b: Value) -> Value:
        if isinstance(a, Identity) and isinstance(b, Matrix):
            a = identity(self.algebra, b.shape[0])
        if isinstance(b, Identity) and isinstance(a, Matrix):
            b = identity(self.algebra, a.shape[0])
        if isinstance(a, Identity) or isinstance(b, Identity):
            _no_size()
        if isinstance(a, Matrix) != isinstance(b, Matrix):
            matrix, other = (a, b) if isinstance(a, Matrix) else (b, a)
            if is_zero(other):
                return matrix
            raise ShapeError(f"a sum of a scalar and a {matrix.size} matrix")
        return a + b

    def _product(self, node: n.Product) -> Value:
        if any(isinstance(factor, n.Call) and factor.function == "Trans" for factor in node.factors):  # R_z(θ) T_z(d), all 4×4
            whole = (replace(f, function="Rot") if isinstance(f, n.Call) and f.function == "Rot3" else f for f in node.factors)
            node = replace(node, factors=tuple(whole))
        result = self.evaluate(node.factors[0])
        for operator, factor in zip(node.operators, node.factors[1:], strict=True):
            result = self._multiply(result, operator, self.evaluate(factor))
        return result

    def _multiply(self, a: Value, operator: str, b: Value) -> Value:
        a, b = _stacked(a), _stacked(b)
        if isinstance(a, Identity) or isinstance(b, Identity):
            other = b if isinstance(a, Identity) else a
            return other if isinstance(other, Matrix | Identity) else _no_size()
        if isinstance(a, Matrix) and isinstance(b, Matrix):
            if operator == "×" and 1 in a.shape and 1 in b.shape and max(a.shape) == 3 and max(b.shape) == 3:
                return a.cross(b)
            if operator == "⋅" and a.shape[1] == b.shape[1] == 1 and a.shape == b.shape and a.shape[0] > 1:
                return (a.transpose @ b).rows[0][0]
            return as_scalar(a @ b)
        if isinstance(a, Matrix):
            return a.map(lambda cell: cell * b)
        if isinstance(b, Matrix):
            return b.map(lambda cell: a * cell)
        return a * b

    def _quotient(self, node: n.Quotient) -> Value:
        above = _sized(self.evaluate(node.numerator))
        below = self.scalar(node.denominator)
        self._divide_by(below)
        if isinstance(above, Matrix):
            return above.map(lambda cell: cell / below)
        return above / below

    def _ambiguous(self, node: n.Ambiguous) -> Value:
        raise EvaluationError(f"'{node.text}' has two readings: write \\frac{{…}}{{…}}, or parentheses")

    def _power(self, node: n.Power) -> Value:
        base = _stacked(as_scalar(self.evaluate(node.base)))
        exponent = _integer(node.exponent)
        if isinstance(base, Identity) and exponent is not None:
            return base
        if exponent is None:
            if _is_half(node.exponent) and not isinstance(base, Matrix | Identity):
                return self.algebra.sqrt(base)
            raise EvaluationError("a power whose exponent is not an integer")
        if isinstance(base, Matrix):
            if exponent < 0:
                base, exponent = self._inverse(base), -exponent
            if exponent == 0:
                return identity(self.algebra, base.shape[0])
            if base.shape[1] == 1 and exponent == 2:
                return (base.transpose @ base).rows[0][0]
            result = base
            for _ in range(exponent - 1):
                result = result @ base
            return result
        if exponent < 0:
            return self.algebra.rational(Fraction(1)) / base**-exponent
        return base**exponent

    def _postfix(self, node: n.Postfix) -> Value:
        if node.operator == "deg":
            return self.scalar(node.base) * self.algebra.pi() / self.algebra.rational(Fraction(180))
        value = as_scalar(self.evaluate(node.base))
        if node.operator == "-1":
            value = self._printed_rows(node.base, value)
        if isinstance(value, list):
            value = Matrix((tuple(value),))
        if isinstance(value, Identity):
            return value
        if not isinstance(value, Matrix):
            if node.operator == "T":
                return value
            if node.operator == "-1":
                return self.algebra.rational(Fraction(1)) / value
            raise EvaluationError(f"'{node.operator}' on a scalar")
        if node.operator == "T":
            return value.transpose
        if node.operator == "-1":
            return self._inverse(value)
        if node.operator == "-T":
            return self._inverse(value).transpose
        return self._pseudo_inverse(value)

    def _inverse(self, matrix: Matrix) -> Matrix:
        if matrix.shape[0] != matrix.shape[1]:
            raise ShapeError(f"a {matrix.size} matrix has no inverse")
        one = self.algebra.rational(Fraction(1))
        determinant = matrix.determinant()
        if is_zero(determinant):
            raise ShapeError(f"the {matrix.size} matrix has no inverse: its determinant is 0 for every configuration")
        self._divide_by(determinant)
        factor = one / determinant
        return matrix.adjugate().map(lambda cell: cell * factor)

    def _printed_rows(self, node: n.Node, value: Value) -> Value:
        """The determinant and the inverse of a Jacobian are of the square part that the document prints."""
        while isinstance(node, n.Group):
            node = node.inner
        if isinstance(node, n.Call) and node.function == "name":
            node = node.arguments[0]
        rows = self.names.shown.get(node.key) if isinstance(node, n.Name) and node.key not in self.names.quantities else None
        if rows is None or not isinstance(value, Matrix) or value.shape[0] != 6 or len(rows) != value.shape[1]:
            return value
        return value.block([row - 1 for row in rows], range(value.shape[1]))

    def _divide_by(self, denominator: Any) -> None:
        """Leave samples out at which a denominator is all but zero: rounding decides the quotient there."""
        if isinstance(self.algebra, SampledAlgebra):
            self.algebra.exclude_near_zeros(denominator)

    def _pseudo_inverse(self, matrix: Matrix) -> Matrix:
        """J^T (J J^T)^{-1} where J is wide, (J^T J)^{-1} J^T where it is tall (each for full rank)."""
        size, width = matrix.shape
        if size == width:
            return self._inverse(matrix)
        transposed = matrix.transpose
        if size < width:
            return transposed @ self._inverse(matrix @ transposed)
        return self._inverse(transposed @ matrix) @ transposed

    # -- structure -------------------------------------------------------------------------------------------------

    def _group(self, node: n.Group) -> Value:
        return self.evaluate(node.inner)

    def _sequence(self, node: n.Sequence) -> Value:
        values = [as_scalar(self.evaluate(item)) for item in node.items]
        if node.brackets == "[]" and not any(isinstance(value, Matrix | Identity) for value in values):
            return Matrix((tuple(values),))
        return values

    def _labelled(self, node: n.Labelled) -> Value:
        value = self.evaluate(node.inner)
        if node.size is not None and isinstance(value, Matrix) and value.shape != node.size:
            raise ShapeError(f"the matrix is {value.size}, the label says {node.size[0]}×{node.size[1]}")
        return value

    def _cases(self, _node: n.Cases) -> Value:
        raise UnboundName("cases", "a value that depends on words")

    def _at(self, node: n.At) -> Value:
        values: dict[str, Any] = {}
        for left, right in node.values:
            symbol = self.names.known_symbol(left.key) if isinstance(left, n.Name) else None
            if symbol is None and isinstance(left, n.Name) and self.names.is_free(left):
                symbol = left.key
            if symbol is None:
                raise EvaluationError("the configuration must give joint variables or lengths values")
            values[symbol] = self.scalar(right)
        return self._at_values(values, node.inner)

    def _at_values(self, values: dict[str, Any], node: n.Node) -> Value:
        """Return a tree's value where some joint variables or lengths have the values given."""
        if isinstance(self.algebra, SampledAlgebra):
            return Evaluator(self.names, self.algebra.at(values), self.branch).evaluate(node)
        return self.algebra.substitute(_sized(self.evaluate(node)), values)

    def _matrix(self, node: n.Matrix) -> Value:
        rows = [[as_scalar(self.evaluate(cell)) for cell in row] for row in node.rows]
        rows = [[cell for value in row for cell in (value if isinstance(value, list) else [value])] for row in rows]
        if not any(isinstance(cell, Matrix | Identity) for row in rows for cell in row):
            widths = {len(row) for row in rows}
            if len(widths) > 1:
                raise ShapeError(f"the rows of a matrix have {', '.join(map(str, sorted(widths)))} cells")
            whole = Matrix(tuple(tuple(row) for row in rows))
        else:
            whole = self._blocks(rows)
        return whole.determinant() if node.environment in ("vmatrix", "Vmatrix") else whole

    def _blocks(self, rows: list[list[Any]]) -> Matrix:
        """Assemble blocks: 0 and I take the size that their row and column leave them."""
        heights = [max([cell.shape[0] for cell in row if isinstance(cell, Matrix)], default=1) for row in rows]
        width_of: dict[int, int] = {}
        aligned = len({len(row) for row in rows}) == 1
        if aligned:
            for k in range(len(rows[0])):
                width_of[k] = max([row[k].shape[1] for row in rows if isinstance(row[k], Matrix)], default=0)
            for r, row in enumerate(rows):
                for k, cell in enumerate(row):
                    if isinstance(cell, Identity) and not width_of[k]:
                        width_of[k] = heights[r]
                    elif isinstance(cell, Identity) and heights[r] == 1:
                        heights[r] = width_of[k]
        assembled: list[tuple[Any, ...]] = []
        for r, row in enumerate(rows):
            blocks = [self._fit(cell, heights[r], (width_of.get(k) or 1) if aligned else 1) for k, cell in enumerate(row)]
            if any(block.shape[0] != heights[r] for block in blocks):
                raise ShapeError(f"blocks of {', '.join(b.size for b in blocks)} stand in one row")
            assembled.extend(tuple(cell for block in blocks for cell in block.rows[line]) for line in range(heights[r]))
        widths = {len(row) for row in assembled}
        if len(widths) > 1:
            raise ShapeError(f"the rows of a block matrix have {', '.join(map(str, sorted(widths)))} columns")
        return Matrix(tuple(assembled))

    def _fit(self, cell: Any, height: int, width: int) -> Matrix:
        if isinstance(cell, Matrix):
            return cell
        if isinstance(cell, Identity):
            return identity(self.algebra, height)
        if (height, width) == (1, 1) or is_zero(cell):
            return Matrix(tuple((cell,) * width for _ in range(height)))
        raise ShapeError(f"a scalar stands where a {height}×{width} block is expected")

    # -- functions -------------------------------------------------------------------------------------------------

    def _call(self, node: n.Call) -> Value:
        function = node.function
        if function == "name":
            return self._applied_name(node)
        if function in ("Rot", "Trans", "Rot3"):
            return self._elementary(node)
        if function == "diag":
            values = [self.scalar(a) for a in node.arguments]
            zero = self.algebra.rational(Fraction(0))
            return Matrix(tuple(tuple(v if r == c else zero for c in range(len(values))) for r, v in enumerate(values)))
        if function == "abs" and isinstance(matrix := self.evaluate(node.arguments[0]), Matrix):  # |J|, |p|
            if matrix.shape[1] == 1:
                return self.algebra.sqrt((matrix.transpose @ matrix).rows[0][0])
            return self._printed_rows(node.arguments[0], matrix).determinant()
        if function in _MATRIX_CALLS:
            value = self._printed_rows(node.arguments[0], self.evaluate(node.arguments[0]))
            if not isinstance(value, Matrix):
                if function in ("det", "tr"):
                    return value
                raise EvaluationError(f"{function} of a scalar")
            if function == "rank":
                return self.algebra.rank(value)
            return _MATRIX_CALLS[function](value)
        arguments = [self.scalar(argument) for argument in node.arguments]
        return self._scalar_function(function, arguments)

    def _scalar_function(self, function: str, arguments: list[Any]) -> Any:
        wanted = 2 if function == "atan2" else 1
        if len(arguments) != wanted:
            raise EvaluationError(f"{function} takes {wanted} argument{'s' * (wanted > 1)}, {len(arguments)} are given")
        if function in ("cos", "sin", "tan", "cot", "sec", "csc"):
            c, s = self.algebra.cos_sin(arguments[0])
            one = self.algebra.rational(Fraction(1))
            return {"cos": lambda: c, "sin": lambda: s, "tan": lambda: s / c, "cot": lambda: c / s, "sec": lambda: one / c,
                    "csc": lambda: one / s}[function]()  # fmt: skip
        if function == "sqrt":
            return self.algebra.sqrt(arguments[0])
        if function == "abs":
            return self.algebra.absolute(arguments[0])
        if function in ("acos", "asin", "atan", "atan2"):
            return self.algebra.arc(function, arguments)
        raise OutsideAlgebra(f"the function {function}")

    def _applied_name(self, node: n.Call) -> Value:
        key = call_key(node)
        names = self.names
        if (quantity := names.quantities.get(key)) is not None:
            return self.algebra.quantity(quantity)
        if key in names.definitions:
            return names.definitions[key].evaluate(self.algebra)
        name, *arguments = node.arguments
        assert isinstance(name, n.Name)
        joints = names.arm.joints if names.arm is not None else ()
        if arguments and not any(isinstance(a, n.Name) for a in arguments):
            if len(arguments) == len(joints):
                values = zip(joints, arguments, strict=True)
                return self._at_values({joint.symbol: self.scalar(argument) for joint, argument in values}, name)
            if len(arguments) == 1:
                return self._multiply(self.evaluate(name), "", self.evaluate(arguments[0]))
            raise EvaluationError(f"{name.key} is given {len(arguments)} values; the arm has {len(joints)} joints")
        ignorable = all(isinstance(a, n.Name) and (a.key in ("q", "t", "theta") or names.known_symbol(a.key)) for a in arguments)
        if ignorable or names.arm is not None:
            return self.evaluate(name)
        raise UnboundName(key)

    def _elementary(self, node: n.Call) -> Matrix:
        axis, amounts = "", []
        for argument in node.arguments:
            if not axis and isinstance(argument, n.Name) and argument.base.lower() in ("x", "y", "z"):
                axis = argument.base.lower()
            else:
                amounts.append(argument)
        if node.function == "Trans" and not axis and len(amounts) == 3:
            moved = [elementary(self.algebra, "Trans", k, self.scalar(a)) for k, a in zip("xyz", amounts, strict=True)]
            return moved[0] @ moved[1] @ moved[2]
        if node.function == "Trans" and axis and len(amounts) == 2 and len(node.arguments) == 3:
            moved = [elementary(self.algebra, "Trans", k, self.scalar(a)) for k, a in zip("xyz", node.arguments, strict=True)]
            return moved[0] @ moved[1] @ moved[2]
        if not axis or len(amounts) != 1:
            raise EvaluationError(f"{node.function} takes an axis (x, y or z) and an amount")
        whole = elementary(self.algebra, node.function[:3] if node.function == "Rot3" else node.function, axis, self.scalar(amounts[0]))
        return whole.block(range(3), range(3)) if node.function == "Rot3" else whole

    # -- derivatives -----------------------------------------------------------------------------------------------

    def _derivative(self, node: n.Derivative) -> Value:
        if isinstance(self.algebra, SampledAlgebra):
            return self.algebra.from_exact(Evaluator(self.names, self.algebra.exact, self.branch).evaluate(node))
        value = _sized(self.evaluate(node.operand))
        variable = node.variable
        for _ in range(node.order):
            value = self._differentiate(value, variable)
        return value

    def _differentiate(self, value: Value, variable: n.Node) -> Value:
        if self.names.arm is not None and isinstance(variable, n.Name) and variable.key == "t":
            return self._in_time(value)
        by = _sized(self.evaluate(variable))
        if isinstance(by, Matrix):  # ∂P/∂q: one column a variable
            cells = by.vector()
            value = value if isinstance(value, Matrix) else column([value])
            return Matrix(tuple(tuple(self.algebra.derivative(f, x) for x in cells) for f in value.vector()))
        if isinstance(value, Matrix):
            return value.map(lambda cell: self.algebra.derivative(cell, by))
        return self.algebra.derivative(value, by)

    def _time_derivative(self, node: n.Name) -> Value:
        """x-dot: a joint rate where x is a joint variable, else the derivative of what x stands for."""
        plain = replace(node, dots=0)
        symbol = self.names.known_symbol(plain.key)
        if symbol is not None and self._is_variable(symbol):
            return self.algebra.symbol(rate_symbol(symbol, node.dots))
        if self.names.is_free(plain) and plain.key not in self.names.definitions:
            return self.algebra.symbol(rate_symbol(plain.key, node.dots))
        if node.key in self.names.definitions:
            return self.names.definitions[node.key].evaluate(self.algebra)
        if isinstance(self.algebra, SampledAlgebra):
            return self.algebra.from_exact(Evaluator(self.names, self.algebra.exact, self.branch).evaluate(node))
        value = self.evaluate(plain)
        for order in range(node.dots):
            value = self._in_time(value, order)
        return value

    def _is_variable(self, symbol: str) -> bool:
        return self.names.arm is not None and any(joint.symbol == symbol for joint in self.names.arm.joints)

    def _in_time(self, value: Value, orders: int = 1) -> Value:
        if self.names.arm is None:
            raise EvaluationError("a time derivative in a document with no arm")
        if isinstance(value, Matrix):
            return value.map(lambda cell: self._in_time(cell, orders))
        algebra = self.algebra
        total = algebra.rational(Fraction(0))
        for joint in self.names.arm.joints:
            for order in range(orders + 1):
                variable = algebra.symbol(rate_symbol(joint.symbol, order))
                total = total + algebra.derivative(value, variable) * algebra.symbol(rate_symbol(joint.symbol, order + 1))
        return total


def rate_symbol(symbol: str, order: int) -> str:
    """The free symbol that stands for the order-th time derivative of a variable."""
    return f"{'dot ' * order}{symbol}"


def _no_size() -> Any:
    raise EvaluationError("an identity matrix whose size cannot be told")


def identity(algebra: Algebra, size: int) -> Matrix:
    """Return the identity matrix of a size."""
    one, zero = algebra.rational(Fraction(1)), algebra.rational(Fraction(0))
    return Matrix(tuple(tuple(one if r == c else zero for c in range(size)) for r in range(size)))


def _stacked(value: Value) -> Value:
    """Return a list of values as the column that it stands for."""
    if not isinstance(value, list):
        return value
    if any(isinstance(cell, Matrix | Identity | list) for cell in value):
        raise EvaluationError("a list of matrices stands where one value is expected")
    return column(value)


def _sized(value: Value) -> Value:
    """Return a value of which the size is known."""
    return _no_size() if isinstance(value, Identity) else _stacked(value)


def as_scalar(value: Value) -> Value:
    """Return the entry of a 1×1 matrix, anything else as it is."""
    return value.rows[0][0] if isinstance(value, Matrix) and value.shape == (1, 1) else value


def is_zero(value: Any) -> bool:
    """Whether a scalar of either algebra vanishes everywhere."""
    if hasattr(value, "is_zero"):
        return bool(value.is_zero())
    return bool((value == 0).all()) if hasattr(value, "all") else value == 0


def _integer(node: n.Node) -> int | None:
    sign = 1
    while isinstance(node, n.Group):
        node = node.inner
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        sign = -1 if node.terms[0][0] == "-" else 1
        node = node.terms[0][1]
    if isinstance(node, n.Number) and node.value.denominator == 1:
        return sign * int(node.value)
    return None


def _is_half(node: n.Node) -> bool:
    if isinstance(node, n.Number):
        return node.value == Fraction(1, 2)
    return isinstance(node, n.Quotient) and _integer(node.numerator) == 1 and _integer(node.denominator) == 2


_MATRIX_CALLS: dict[str, Callable[[Matrix], Value]] = {
    "det": Matrix.determinant,
    "adj": Matrix.adjugate,
    "com": Matrix.cofactors,
    "tr": lambda m: sum((m.rows[k][k] for k in range(1, min(m.shape))), m.rows[0][0]),
    "rank": lambda m: m,
}

_METHODS: dict[type[n.Node], Callable[[Evaluator, Any], Value]] = {
    n.Number: Evaluator._number,
    n.Name: Evaluator._name,
    n.JointAngles: Evaluator._joint_angles,
    n.Dots: Evaluator._dots,
    n.Layout: Evaluator._layout,
    n.Sum: Evaluator._sum,
    n.Product: Evaluator._product,
    n.Quotient: Evaluator._quotient,
    n.Ambiguous: Evaluator._ambiguous,
    n.Power: Evaluator._power,
    n.Postfix: Evaluator._postfix,
    n.Group: Evaluator._group,
    n.Sequence: Evaluator._sequence,
    n.Labelled: Evaluator._labelled,
    n.Cases: Evaluator._cases,
    n.At: Evaluator._at,
    n.Matrix: Evaluator._matrix,
    n.Call: Evaluator._call,
    n.Derivative: Evaluator._derivative,
}
