"""Drake's symbolic expressions as traced numbers."""

from __future__ import annotations

from typing import Any

from armproof.verification.functions.tracing.number import (
    FUNCTIONS,
    ONE,
    ZERO,
    TracedNumber,
    Untraceable,
    as_traced,
    divide,
    function,
    power,
)


class FromDrake:
    """Turns pydrake.symbolic.Expression into traced numbers; equal subexpressions become one node."""

    def __init__(self) -> None:
        self._variables: dict[int, TracedNumber] = {}
        self._known: dict[str, list[tuple[Any, TracedNumber]]] = {}

    def variable(self, name: str) -> Any:
        """Return the expression that stands for a symbol."""
        from pydrake.symbolic import Expression, Variable

        from armproof.verification.functions.tracing.number import symbol

        variable = Variable(name)
        self._variables[variable.get_id()] = symbol(name)
        return Expression(variable)

    def convert(self, expression: Any) -> TracedNumber:
        """Return the formula of an expression; raises Untraceable for a function that is not traced."""
        alike = self._known.setdefault(str(expression), [])  # Drake's expressions cannot be hashed
        for other, node in alike:
            if expression.EqualTo(other):
                return node
        alike.append((expression, self._convert(expression)))
        return alike[-1][1]

    def _convert(self, expression: Any) -> TracedNumber:
        from pydrake.symbolic import Expression, ExpressionKind, Variable

        kind = expression.get_kind()
        operation, arguments = expression.Unapply()
        if kind in (ExpressionKind.Var, ExpressionKind.Constant):
            (leaf,) = arguments
            return self._variables[leaf.get_id()] if isinstance(leaf, Variable) else as_traced(leaf)
        nodes = [self.convert(a) if isinstance(a, Expression) else as_traced(a) for a in arguments]
        if kind == ExpressionKind.Add:
            return sum(nodes, ZERO)
        if kind == ExpressionKind.Mul:
            product = ONE
            for node in nodes:
                product = product * node
            return product
        if kind == ExpressionKind.Div:
            return divide(*nodes)
        if kind == ExpressionKind.Pow:
            return power(*nodes)
        name = kind.name.lower()
        if name not in FUNCTIONS:
            raise Untraceable("Drake's {operation} cannot be traced", operation=operation)
        return function(name, *nodes)
