"""Derivatives as they are printed: ∂f/∂x, ∂/∂x(…), df/dt, and δ for ∂."""

from __future__ import annotations

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import DerivativeOperator, Differential


def partial_derivative(above: Differential, below: Differential, span: tuple[int, int]) -> n.Node:
    """Return ∂f/∂x, or ∂/∂x still waiting for its operand."""
    if below.operand is None:
        raise ReadError(say(Kind.DERIVATIVE_BY_NOTHING), below.span[0])
    variable, order = below.operand, above.order
    if order > 1:
        if not (
            isinstance(variable, n.Power)
            and isinstance(variable.exponent, n.Number)
            and variable.exponent.value == order
        ):
            raise ReadError(say(Kind.HIGHER_DERIVATIVE), below.span[0])
        variable = variable.base
    if above.operand is None:
        return DerivativeOperator(variable, order, span=span)
    return n.Derivative(above.operand, variable, order, span=span)


def total_derivative(above: n.Node, below: n.Node, span: tuple[int, int]) -> n.Node | None:
    """dx/dθ and d/dt(…), written with letters (δ is also met for ∂)."""
    below_run = below.factors if isinstance(below, n.Product) else ()
    if len(below_run) != 2 or not isinstance(below_run[0], n.Name) or below_run[0].key not in ("d", "delta"):
        return None
    mark = below_run[0].key
    if isinstance(above, n.Name) and above.key == mark:
        return DerivativeOperator(below_run[1], span=span)
    if isinstance(above, n.Product) and isinstance(above.factors[0], n.Name) and above.factors[0].key == mark:
        operand = (
            above.factors[1]
            if len(above.factors) == 2
            else n.Product(above.factors[1:], above.operators[1:], span=above.span)
        )
        return n.Derivative(operand, below_run[1], span=span)
    return None
