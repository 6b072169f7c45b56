"""Exact entries as Drake's symbolic expressions, and back."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from armproof.models.arm import Joint
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.polynomial import Entry, Generator, Monomial, Rows, normal_form, number


class Expressions:
    """The variables that stand for the generators of one arm, and for rationals that a double cannot hold."""

    def __init__(self, name: str, joints: Sequence[Joint]) -> None:
        """Take the name of the arm, for messages, and its joints."""
        from pydrake.symbolic import SinCos, Variable

        self._name = name
        self._variables: dict[Generator | Fraction, Any] = {}
        self._meanings: dict[int, Generator | Fraction] = {}
        self._cosines_and_sines = {}
        self.joints = []
        for joint in joints:
            if joint.kind == "prismatic":
                self.joints.append(self._variable(("symbol", joint.symbol)))
                continue
            angle = Variable(joint.symbol)
            self.joints.append(angle)
            self._cosines_and_sines[angle] = SinCos(
                s=self._variable(("sin", joint.symbol)), c=self._variable(("cos", joint.symbol))
            )

    def entries(self, expressions: np.ndarray) -> Rows:
        """Return a matrix of expressions as exact entries in normal form."""
        from pydrake.symbolic import ExpressionKind, Polynomial, Substitute

        flat: Any = np.asarray(expressions).reshape(-1, 1)
        if self._cosines_and_sines:
            flat = Substitute(flat, self._cosines_and_sines)
        constant = ExpressionKind.Constant
        entries = [
            number(self._whole(each)) if each.get_kind() == constant else self._entry(Polynomial(each))
            for each in np.asarray(flat).ravel()
        ]
        width = expressions.shape[1]
        return tuple(tuple(entries[i : i + width]) for i in range(0, len(entries), width))

    def expression(self, entry: Entry) -> Any:
        """Return an exact entry as an expression."""
        from pydrake.symbolic import Expression

        total = Expression(0.0)
        for monomial, coefficient in entry.items():
            term = Expression(float(coefficient.numerator))
            if coefficient.denominator != 1:
                size = self._variable(abs(coefficient))
                term = Expression(size) if coefficient > 0 else -Expression(size)
            for generator, power in monomial:
                term = term * Expression(self._variable(generator)) ** power
            total = total + term
        return total

    def _variable(self, meaning: Generator | Fraction) -> Any:
        """Return the variable that stands for a generator, or for a rational that a double cannot hold."""
        if meaning not in self._variables:
            from pydrake.symbolic import Variable

            variable = Variable(str(meaning))
            self._variables[meaning] = variable
            self._meanings[variable.get_id()] = meaning
        return self._variables[meaning]

    def _entry(self, polynomial: Any) -> Entry:
        entry: dict[Monomial, Fraction] = {}
        for drake_monomial, factor in polynomial.monomial_to_coefficient_map().items():
            above, below = self._whole(factor), 1
            powers: dict[Generator, int] = {}
            for variable, power in drake_monomial.get_powers().items():
                meaning = self._meanings[variable.get_id()]
                if isinstance(meaning, tuple):
                    powers[meaning] = power
                else:
                    above, below = above * meaning.numerator**power, below * meaning.denominator**power
            monomial = tuple(sorted(powers.items()))
            coefficient = Fraction(above) if below == 1 else Fraction(above, below)
            entry[monomial] = entry[monomial] + coefficient if monomial in entry else coefficient
        return normal_form(entry)

    def _whole(self, expression: Any) -> int:
        """Return the whole number that an expression without variables is."""
        value = expression.Evaluate()
        if value != round(value):
            raise ModelError(Fault.TRACE_NOT_EXACT, arm=self._name, value=value)
        return round(value)
