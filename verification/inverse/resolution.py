"""The values of a document's names on one branch of its solution, in whichever algebra asks."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, say
from armproof.verification.inverse.derivation import Derivation, Meaning, Signs, UnsolvedJoint
from armproof.verification.inverse.formulas import Formula, joint_function_key
from armproof.verification.inverse.given_target import GivenTarget
from armproof.verification.inverse.target import Slot, Target
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition

_SIGN = "sign "


def solve_branch(derivation: Derivation, algebra: GivenTarget, signs: Signs) -> dict[str, Value]:
    """Return the value of each joint on a branch, in order; `algebra` holds the target, and none is solved in it.

    A sign of 0 is one that the algebra has as a symbol: all branches at once.
    """
    resolution = Resolution(derivation, algebra, signs)
    for step in derivation.steps:
        algebra.solve(step.joint, resolution.variable(step.formula))
    return algebra.solved


class Resolution:
    """The values of a document's names in one algebra, on one branch; remembers which meaning each name took."""

    def __init__(self, derivation: Derivation, algebra: GivenTarget, signs: Signs) -> None:
        self.derivation = derivation
        self.algebra = algebra
        self.signs = signs
        self.choice: dict[str, Meaning] = dict(derivation.choice)
        self.branching: list[str] = []  # the ± met on the way
        self._values: dict[str, Value] = {}
        self._active: set[str] = set()
        self.names = self._rebound()

    def _rebound(self) -> Names:
        """The document's names, with those that formulas define read by the formula that can be computed."""
        names, formulas = self.derivation.names, self.derivation.formulas
        given = {slot.key for slot in self.derivation.target.slots if slot.is_name}
        kept = {key: quantity for key, quantity in names.quantities.items() if key not in formulas}
        definitions = {key: Definition(partial(self._value_in, key)) for key in {*formulas, *given}}
        definitions |= {_SIGN + sign: Definition(partial(_sign_in, sign)) for sign in self.derivation.signs}
        state = replace(names.state, definitions=definitions, used=set(), inferred={}, beyond={})
        return replace(names, quantities=kept, state=state)

    def _value_in(self, key: str, _algebra: Any) -> Value:
        return self.value(key)

    def value(self, key: str) -> Value:
        """Return the value of a name; raises EvaluationError where no meaning of it can be computed."""
        if (known := getattr(self.algebra, "given", {}).get(key)) is not None:
            return known
        if key in self._values:
            return self._values[key]
        if key in self._active:
            raise EvaluationError(say(Kind.DEFINED_BY_ITSELF, name=key))
        self._active.add(key)
        try:
            value, meaning = self._first(self._meanings(key))
        finally:
            self._active.remove(key)
        self.choice[key] = meaning
        self._values[key] = self.algebra.named(key, value)
        return self._values[key]

    def _meanings(self, key: str) -> list[Meaning]:
        if key in self.choice:
            return [self.choice[key]]
        formulas = self.derivation.formulas.get(key, [])
        names = self.derivation.names
        quantity = names.quantities.get(key)
        if quantity is None and (name := next((f.name for f in formulas if f.name is not None), None)) is not None:
            quantity = names.quantity(name)
        return [*([quantity] if quantity is not None else []), *formulas]

    def _first(self, meanings: list[Meaning]) -> tuple[Value, Meaning]:
        problem: EvaluationError | None = None
        for meaning in meanings:
            try:
                return self._of(meaning), meaning
            except TooComplex:
                raise
            except EvaluationError as error:
                problem = error if problem is None or isinstance(problem, UnsolvedJoint) else problem
        raise problem or EvaluationError("no display gives it a value")

    def _of(self, meaning: Meaning) -> Value:
        if isinstance(meaning, Quantity):
            return self.algebra.quantity(meaning)
        node, sign = self._with_names_of_functions(meaning.node), 1
        if meaning.branching:
            sign = self.signs.get(meaning.key, 1)
            if meaning.key not in self.branching:
                self.branching.append(meaning.key)
            if not sign:
                node = with_named_sign(node, meaning.key)
        return replace(meaning, node=node).value(Evaluator(self.names, self.algebra, sign))

    def scalar(self, formula: Formula) -> Any:
        """Return the value of a formula that is a scalar."""
        value = as_scalar(self._of(formula))
        if hasattr(value, "rows") or isinstance(value, list):
            raise EvaluationError(say(Kind.JOINT_IS_SCALAR))
        return value

    def variable(self, formula: Formula) -> Any:
        """Return the value of the joint variable that a formula solves for: its letter may mean the angle of the DH table."""
        letter = formula.name.key if formula.name is not None else formula.key
        return self.names.variable_at(formula.key, self.scalar(formula), self.algebra, letter)

    def part(self, formula: Formula, node: n.Node) -> Any:
        """Return the value of a part of a formula."""
        return self.scalar(replace(formula, node=node, place=None))

    def _with_names_of_functions(self, node: n.Node) -> n.Node:
        """Replace the sine and cosine of a joint that is not solved by their names, where displays give them values."""
        for below in list(n.walk(node)):
            key = joint_function_key(below, self.derivation.names)
            if key is None or key not in self.derivation.formulas or key.partition(" ")[2] in self.algebra.solved:
                continue
            node = n.substitute(node, below, n.Name(key, span=below.span))
        return node


def _sign_in(sign: str, algebra: Any) -> Any:
    return algebra.sign(sign)


def with_named_sign(node: n.Node, sign: str) -> n.Node:
    """Return a tree in which ±x is σx, and ∓x is −σx, with the name of a sign for σ."""
    for below in list(n.walk(node)):
        if isinstance(below, n.Sum) and any(mark in "±∓" for mark, _ in below.terms):
            terms = tuple(
                (mark, term)
                if mark in "+-"
                else (
                    "+" if mark == "±" else "-",
                    n.Product((n.Name(_SIGN + sign), with_named_sign(term, sign)), ("",)),
                )
                for mark, term in below.terms
            )
            node = n.substitute(node, below, n.Sum(terms, span=below.span))
    return node


def forward_values(derivation: Derivation, algebra: GivenTarget) -> list[Any]:
    """Return each slot of the target as a value of the algebra, in which every joint must have one.

    Raises:
        EvaluationError: a name of the target that no display gives a value by the joints.
    """
    free = replace(derivation, target=Target((), (0,), ()), choice={})
    resolution = Resolution(free, algebra, {})
    return [_value(slot, resolution, algebra) for slot in derivation.target.slots]


def _value(slot: Slot, resolution: Resolution, algebra: GivenTarget) -> Any:
    if not slot.is_name:
        quantity = Quantity("pose", slot.frame, slot.reference, (slot.row + 1,), (slot.column + 1,), scalar=True)
        return algebra.quantity(quantity)
    try:
        return resolution.value(slot.key)
    except EvaluationError as error:
        raise EvaluationError("'{label}' of the target is neither in `quantities` nor defined by a display: {reason}",
            label=slot.label, reason=str(error)) from None  # fmt: skip
