"""What names, numbers and function calls stand for: the arm's quantities, frames that a document adds, trigonometry, determinants."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Identity, Matrix, column, stacked
from armproof.verification.algebra.protocol import OutsideAlgebra, Value, elementary, identity
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError, ShapeError, UnboundName
from armproof.verification.evaluation.arithmetic import multiply
from armproof.verification.evaluation.differentiation import time_derivative
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.evaluation.mass_matrix import entry_of_masses
from armproof.verification.evaluation.screws import HAT, exponential, jacobian_of_screws, twist_value
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, call_key, is_nought
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames, transform_pair

WHOLE_VECTORS = ("q", "t", "theta", "Theta")  # and time: what everything depends on
_MATRIX_CALLS: dict[str, Callable[[Matrix], Value]] = {
    "det": Matrix.determinant,
    "adj": Matrix.adjugate,
    "com": Matrix.cofactors,
    "tr": lambda m: sum((m.rows[k][k] for k in range(1, min(m.shape))), m.rows[0][0]),
    "rank": lambda m: m,
}


def number_value(evaluator: Evaluating, node: n.Number) -> Value:
    """Return a number as a constant of the algebra."""
    return evaluator.algebra.rational(node.value)


def name_value(evaluator: Evaluating, node: n.Name) -> Value:
    """Return what a name stands for; raises UnboundName where it stands for nothing."""
    algebra, names = evaluator.algebra, evaluator.names
    if node.base == "words":
        if node.sub:
            raise UnboundName(node.text, say(Kind.SUBSCRIPT_ON_EXPRESSION, script=node.sub))
        comma = node.text.replace(",", "").isdigit()
        raise UnboundName(node.text, say(Kind.DECIMAL_COMMA if comma else Kind.WORDS_FOR_VALUE))
    if (quantity := names.quantities.get(node.key)) is not None:
        return algebra.quantity(quantity)
    if (square := _square_of_defined(evaluator, node)) is not None:
        return square
    if node.dots:
        return time_derivative(evaluator, node)
    if (sign := names.state.signs.value(node.key)) is not None:
        return algebra.rational(Fraction(sign))
    symbol = names.known_symbol(node.key)
    if symbol is not None:
        return names.table_angle(symbol, algebra, node.key)
    if node.key in names.state.definitions:
        return names.defined_value(node.key, algebra)
    if (square := _power_of_length(node, names)) is not None:
        return evaluator.evaluate(square)
    if (quantity := names.quantity(node)) is not None:
        return algebra.quantity(quantity)
    if node.key == "pi":
        return algebra.pi()
    is_inertia = node.key in names.reader.spelling.masses  # I_1 beside m_1
    if node.base in ("I", "Id", "E") and not (node.pre_sub or node.pre_sup or node.sup or is_inertia):
        if (size := re.fullmatch(r"([1-9])(?:x\1)?", node.sub)) is not None:
            return identity(algebra, int(size.group(1)))
        if not node.sub and node.base != "E":
            return Identity(algebra.rational(Fraction(1)))
    if (entry := entry_of_masses(evaluator, node)) is not None:
        return entry
    if (component := names.component(node)) is not None:
        letter, row = component
        return names.defined_value(letter, algebra).rows[row][0]
    if names.is_free(node):
        names.used.add(node.key)
        return algebra.symbol(node.key)
    if node.key in ("q", "Theta") and names.arm is not None:
        return column([algebra.symbol(joint.symbol) for joint in names.arm.joints])
    if (angles := names.angle_sum(node)) is not None:
        return joint_angle_sum(evaluator, angles)
    if (added := names.added_frame(node)) is not None:
        return _to_added_frame(evaluator, node, *added)
    if (applied := names.applied_to_joints(node)) is not None:
        return names.defined_value(applied, algebra)
    _reject_unknown_frame(evaluator, node)
    if (of_screws := _of_screws(evaluator, node)) is not None:
        return of_screws
    raise UnboundName(node.key)


def _of_screws(evaluator: Evaluating, node: n.Name) -> Matrix | None:
    r"""Return the matrix of a twist, \hat\xi_1, or the Jacobian of a product of exponentials."""
    if not evaluator.names.reader.spelling.screws or evaluator.names.arm is not None:
        return None
    if node.base.startswith(HAT):
        twist = twist_value(evaluator, node)
        return twist.matrix(evaluator.algebra) if twist is not None else None
    return jacobian_of_screws(evaluator, node)


def _square_of_defined(evaluator: Evaluating, node: n.Name) -> Any:
    r"""Return the square that x_1^2 or \dot x_1^2 is where the document says of a number x_1 what it is; None of another name."""
    if node.sup != "2" or node.pre_sup or node.pre_sub:
        return None
    names, plain = evaluator.names, replace(node, sup="", dots=0)
    if plain.key not in names.state.definitions and plain.key not in names.quantities:
        return None
    if node.undotted.key in names.state.definitions or not _is_scalar(evaluator.evaluate(plain)):
        return None
    return evaluator.evaluate(n.Power(replace(node, sup=""), n.Number(Fraction(2), "2"), span=node.span))


def _is_scalar(value: Any) -> bool:
    return not isinstance(value, Matrix | list)


def _power_of_length(node: n.Name, names: Names) -> n.Power | None:
    """Return the power that p_1^2 is where p_1 is a length of the arm, and no point seen from frame 2."""
    if not node.sup.isdigit() or int(node.sup) < 2 or node.pre_sup or node.pre_sub:
        return None
    plain = replace(node, sup="")
    if names.known_symbol(plain.key) not in names.lengths:
        return None
    return n.Power(plain, n.Number(Fraction(node.sup), node.sup), span=node.span)


def joint_angle_sum(evaluator: Evaluating, node: n.JointAngles) -> Any:
    """Return the θ_1 + θ_2 of c_{12}."""
    total = evaluator.algebra.rational(Fraction(0))
    for sign, index in node.terms:
        symbol = evaluator.names.joint_angle(index)
        if symbol is None:
            raise ShapeError(say(Kind.NO_SUCH_ANGLE, index=index))
        if evaluator.names.arm is None:
            evaluator.names.used.add(symbol)  # θ_1 = … behind c_1 gives it no meaning
        angle = evaluator.names.table_angle(symbol, evaluator.algebra)
        total = total + angle if sign == 1 else total - angle
    return total


def _to_added_frame(evaluator: Evaluating, node: n.Name, reference: str, frame: str, key: str) -> Matrix:
    """The transform to a frame that the document fixed on one of the arm's, such as a tool."""
    fixed = evaluator.names.defined_value(key, evaluator.algebra)
    if not isinstance(fixed, Matrix) or fixed.shape != (4, 4):
        raise UnboundName(node.key)
    whole = evaluator.algebra.quantity(Quantity("pose", frame, reference)) @ fixed
    return whole.block(range(3), range(3)) if node.base == "R" else whole


def _reject_unknown_frame(evaluator: Evaluating, node: n.Name) -> None:
    """A transform between numbered frames that the arm does not have is a slip, not a new name."""
    arm = evaluator.names.arm
    if arm is None or node.base not in ("T", "A", "H", "R") or node.primes:
        return
    indices = [index for index in (node.pre_sup, node.pre_sub, node.sup, node.sub) if index]
    numbered = numbered_frames(arm)
    if transform_pair(node, arm, evaluator.names.transforms) == (numbered[-1], str(len(numbered))):
        return  # ^3_4T of an arm with three joints: the tool's frame, which the display may define
    if len(indices) == 2 and all(index in arm.frames or index.isdigit() for index in indices):
        missing = next((index for index in indices if index not in arm.frames), None)
        if missing is not None:
            raise EvaluationError(say(Kind.NO_SUCH_FRAME, frame=missing, arm=arm.name, frames=list(arm.frames)))


def ellipsis(evaluator: Evaluating, _node: n.Dots) -> Value:
    """Refuse an ellipsis."""
    raise UnboundName("…", say(Kind.TERMS_LEFT_OUT))


def layout(evaluator: Evaluating, _node: n.Layout) -> Value:
    """Refuse several equations in one place."""
    raise EvaluationError(say(Kind.SEVERAL_EQUATIONS))


def call_value(evaluator: Evaluating, node: n.Call) -> Value:
    """Return the value of a function, an elementary matrix or an applied name."""
    function = node.function
    if function == "name":
        return _applied_name(evaluator, node)
    if function in ("Rot", "Trans", "Rot3"):
        return _elementary(evaluator, node)
    if function in ("abs", "det", "tr") and (applied := _applied_to_one_value(node.arguments[0])) is not None:
        name, argument = applied  # det J(π/2), where det J depends on one joint and J on two
        return _at_one_value(evaluator, replace(node, arguments=(name,)), name, argument)
    if function == "diag":
        values = [evaluator.scalar(a) for a in node.arguments]
        zero = evaluator.algebra.rational(Fraction(0))
        return Matrix(tuple(tuple(v if r == c else zero for c in range(len(values))) for r, v in enumerate(values)))
    if function == "abs" and isinstance(matrix := stacked(evaluator.evaluate(node.arguments[0])), Matrix):  # |J|, |p|
        if matrix.shape[1] == 1:
            return evaluator.algebra.sqrt((matrix.transpose @ matrix).rows[0][0])
        return matrix.determinant()
    if function in ("norm", "frobenius"):
        return _norm(evaluator, node)
    if function == "det" and (squares := _square_factors(evaluator, node.arguments[0])) is not None:
        return squares[0].determinant() * squares[1].determinant()
    if function in _MATRIX_CALLS:
        value = evaluator.evaluate(node.arguments[0])
        if not isinstance(value, Matrix):
            if function in ("det", "tr"):
                return value
            raise EvaluationError(say(Kind.FUNCTION_OF_SCALAR, function=function))
        if function == "rank":
            return evaluator.algebra.rank(value)
        return _MATRIX_CALLS[function](value)
    if (
        function == "exp"
        and evaluator.names.reader.spelling.screws
        and (motion := exponential(evaluator, node.arguments[0])) is not None
    ):
        return motion
    arguments = [evaluator.scalar(argument) for argument in node.arguments]
    return _scalar_function(evaluator, function, arguments)


def _square_factors(evaluator: Evaluating, node: n.Node) -> tuple[Matrix, Matrix] | None:
    """Return the factors of a product whose determinant is that of theirs, as of J Jᵀ: two square matrices of one size."""
    product = bare(node)
    if not isinstance(product, n.Product) or len(product.factors) != 2:
        return None
    first = evaluator.evaluate(product.factors[0])
    if not isinstance(first, Matrix) or first.shape[0] != first.shape[1]:
        return None  # and the second one is evaluated with the product
    second = evaluator.evaluate(product.factors[1])
    return (first, second) if isinstance(second, Matrix) and second.shape == first.shape else None


def _may_be_entry(arguments: Sequence[n.Node]) -> bool:
    """Whether J(1, 2) may be a row and a column."""
    return len(arguments) == 2 and all(isinstance(a, n.Number) and a.value in range(1, 7) for a in arguments)


def _norm(evaluator: Evaluating, node: n.Call) -> Any:
    """Return the length of a column or a row, the size of a scalar; of a matrix ‖·‖_F alone is known."""
    value = stacked(evaluator.evaluate(node.arguments[0]))
    if not isinstance(value, Matrix):
        return evaluator.algebra.absolute(value)
    if node.function == "norm" and 1 not in value.shape:
        raise EvaluationError(say(Kind.NORM_OF_MATRIX))
    squares = [cell * cell for row in value.rows for cell in row]
    return evaluator.algebra.sqrt(sum(squares[1:], squares[0]))


def _scalar_function(evaluator: Evaluating, function: str, arguments: list[Any]) -> Any:
    wanted = 2 if function == "atan2" else 1
    if len(arguments) != wanted:
        kind = Kind.TAKES_TWO_ARGUMENTS if wanted == 2 else Kind.TAKES_ONE_ARGUMENT
        raise EvaluationError(say(kind, function=function, given=len(arguments)))
    if function in ("cos", "sin", "tan", "cot", "sec", "csc"):
        c, s = evaluator.algebra.cos_sin(arguments[0])
        one = evaluator.algebra.rational(Fraction(1))
        if function not in ("cos", "sin"):
            evaluator.algebra.divide_by(c if function in ("tan", "sec") else s)
        return {"cos": lambda: c, "sin": lambda: s, "tan": lambda: s / c, "cot": lambda: c / s, "sec": lambda: one / c,
                "csc": lambda: one / s}[function]()  # fmt: skip
    if function == "sqrt":
        return evaluator.algebra.sqrt(arguments[0])
    if function == "abs":
        return evaluator.algebra.absolute(arguments[0])
    if function in n.ARCS:
        return evaluator.algebra.arc(function, arguments)
    raise OutsideAlgebra(say(Kind.THE_FUNCTION, function=function))


def _applied_name(evaluator: Evaluating, node: n.Call) -> Value:
    key = call_key(node)
    names = evaluator.names
    if (quantity := names.quantities.get(key)) is not None:
        return evaluator.algebra.quantity(quantity)
    if key in names.state.definitions:
        return names.defined_value(key, evaluator.algebra)
    name, *arguments = node.arguments
    assert isinstance(name, n.Name)
    if names.arm is None and is_nought(arguments):  # g_{st}(0), a name that nothing gives a meaning
        raise UnboundName(key)
    if names.known_symbol(name.key) in names.lengths:  # what depends on joints is no length
        raise UnboundName(key)
    own = [*names.joints]
    letters = [a.key for a in arguments if isinstance(a, n.Name) and a.key != "pi"]
    given = [names.known_symbol(letter) for letter in letters]
    if len(letters) < len(arguments) or (given != own and set(given) == set(own)):
        if len(arguments) == len(own):
            if (
                _may_be_entry(arguments)
                and isinstance(matrix := evaluator.evaluate(name), Matrix)
                and 1 not in matrix.shape
            ):
                raise UnboundName(key, say(Kind.ENTRY_OR_VALUES))
            values = zip(own, arguments, strict=True)
            return evaluator.at_values({symbol: evaluator.scalar(argument) for symbol, argument in values}, name)
        if not letters and len(arguments) == 1:
            return _at_one_value(evaluator, name, name, arguments[0])
        if len(arguments) == 1:
            return multiply(evaluator.evaluate(name), "", evaluator.evaluate(arguments[0]))
        raise EvaluationError(say(Kind.WRONG_NUMBER_OF_VALUES, name=name.key, given=len(arguments), joints=len(own)))
    if all(is_variable(argument, names) for argument in arguments) and len({*letters}) == len(letters):
        value = evaluator.evaluate(name)
        if (problem := problem_of_arguments(value, node, names)) is not None:
            raise EvaluationError(problem)
        return value
    raise UnboundName(key)


def _applied_to_one_value(node: n.Node) -> tuple[n.Name, n.Node] | None:
    """Return the name and the value of J(π/2); None of anything else."""
    if not (n.is_call(node, "name") and len(node.arguments) == 2):
        return None
    name, argument = node.arguments
    return (name, argument) if isinstance(name, n.Name) and n.is_number(argument) else None


def _at_one_value(evaluator: Evaluating, whole: n.Node, name: n.Name, argument: n.Node) -> Value:
    """Return what a number in brackets behind a name makes of it: T(0) is T in the zero pose, w(π/2) of θ_2 alone its value there.

    A number is a factor behind what does not depend on joints, and T(2) is 2 T. What depends on several joints has no value at one.
    """
    names, exact = evaluator.names, evaluator.algebra.exact
    value = (evaluator if exact is None else evaluator.within(exact)).evaluate(whole)
    cells = [cell for cell in (value.cells if isinstance(value, Matrix) else (value,)) if isinstance(cell, Scalar)]
    moving, is_zero = symbols_in(cells) & names.joints.keys(), is_nought((argument,))
    is_factor = isinstance(bare(argument), n.Number) and not is_zero
    if (is_factor and whole is name) or not (moving or is_zero):
        return multiply(evaluator.evaluate(whole), "", evaluator.evaluate(argument))
    is_of_time = name.key in ("x", "y", "z", "p")
    is_value = not is_of_time and (moving or isinstance(value, Matrix) or whole is not name)
    if not is_value or is_factor or names.offset_joints or not (is_zero or len(moving) == 1):
        raise EvaluationError(say(Kind.WRONG_NUMBER_OF_VALUES, name=name.key, given=1, joints=len(names.joints)))
    given = names.joints if is_zero else moving
    return evaluator.at_values({joint: evaluator.scalar(argument) for joint in given}, whole)


def problem_of_arguments(value: Value, node: n.Call, names: Names) -> Finding | None:
    """Say that a value depends on a joint that is none of its variables: A_2^1(θ_3) of θ_2, J(θ_1) of θ_1 and θ_2."""
    name, *arguments = node.arguments
    if not isinstance(name, n.Name):
        return None
    letters = [each.key for each in arguments if isinstance(each, n.Name)]
    given = {symbol: letter for letter in letters if (symbol := names.known_symbol(letter)) is not None}
    if len(given) < len(arguments) or not given.keys() & names.joints.keys():  # all joints, a time or a length
        return None
    cells = [cell for cell in (value.cells if isinstance(value, Matrix) else (value,)) if isinstance(cell, Scalar)]
    own = symbols_in(cells)
    others = {symbol: letter for symbol, letter in given.items() if symbol not in own}
    for symbol, letter in others.items():
        base = symbol.partition("_")[0]
        instead = sorted(each for each in own - given.keys() if each.partition("_")[0] == base)
        if instead:  # of θ_3, where it depends on θ_2; or of a_3
            return say(Kind.OTHER_ARGUMENT, name=name.key, own=instead[0], given=letter)
    missing = sorted((own & names.joints.keys()) - given.keys())
    if missing and others:
        return say(Kind.OTHER_ARGUMENT, name=name.key, own=missing[0], given=next(iter(others.values())))
    return say(Kind.FURTHER_ARGUMENT, name=name.key, own=missing[0]) if missing else None


def is_variable(node: n.Node, names: Names) -> bool:
    r"""Whether an argument is one of joints and of lengths, or all joints, or their rates: the q and \dot q of \dot J(q, \dot q)."""
    plain = node.undotted if isinstance(node, n.Name) else None
    return plain is not None and (plain.key in WHOLE_VECTORS or names.known_symbol(plain.key) is not None)


def _elementary(evaluator: Evaluating, node: n.Call) -> Matrix:
    axis, amounts = "", []
    for argument in node.arguments:
        if not axis and isinstance(argument, n.Name) and argument.base.lower() in ("x", "y", "z"):
            axis = argument.base.lower()
        else:
            amounts.append(argument)
    if node.function == "Trans" and not axis and len(amounts) == 3:
        return _translation(evaluator, amounts)
    if node.function == "Trans" and axis and len(amounts) == 2 and len(node.arguments) == 3:
        return _translation(evaluator, node.arguments)
    if node.function == "Trans" and not axis and len(amounts) == 1:
        value = evaluator.evaluate(amounts[0])
        if isinstance(value, Matrix) and value.shape == (4, 4):  # p = trans(T), of a pose what it shifts by
            return value.block(range(3), [3])
    if not axis or len(amounts) != 1:
        raise EvaluationError(say(Kind.AXIS_AND_AMOUNT, function=node.function))
    kind = "Rot" if node.function == "Rot3" else node.function
    whole = elementary(evaluator.algebra, kind, axis, evaluator.scalar(amounts[0]))
    return whole.block(range(3), range(3)) if node.function == "Rot3" else whole


def _translation(evaluator: Evaluating, amounts: Sequence[n.Node]) -> Matrix:
    x, y, z = (
        elementary(evaluator.algebra, "Trans", k, evaluator.scalar(a)) for k, a in zip("xyz", amounts, strict=True)
    )
    return x @ y @ z
