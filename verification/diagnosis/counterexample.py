"""Generic configurations at which a slip is looked for, and the one of them that refutes an equation: a counterexample."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from armproof.models.arm import Joint
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError, NoValue
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

PROBES = 12
SEED = 7
TIE = 1e-9
SAMPLED = 1_000  # terms that are evaluated for a counterexample: some hundredths of a second


class RoundSamples(SampledAlgebra):
    """Samples whose letters have two decimals, as a reader can put them in."""

    def symbol(self, name: str) -> np.ndarray:
        """Return the values of a symbol."""
        values = super().symbol(name)
        if name in self.free:
            values = self.free[name] = np.round(values, 2)
        return values


def _round_values(joint: Joint, generator: np.random.Generator) -> np.ndarray:
    """Return values of a joint of one decimal, of two between close limits; none of them zero, where the limits allow."""
    low, high = (-2.6, 2.6) if joint.kind == "revolute" else (0.1, 0.9)
    share = generator.random(PROBES)
    if low < joint.upper and joint.lower < high:
        low, high = max(low, joint.lower), min(high, joint.upper)
    unit = 10 if high - low > 1 else 100
    low, high = np.ceil(low * unit) / unit, np.floor(high * unit) / unit  # what is rounded stays between them
    values = np.round(low + (high - low) * share, 1 if unit == 10 else 2)
    return np.where(np.abs(values) < 0.05, 0.3, values) if high > 0.3 else values


class Remembering(Evaluator):
    """Evaluates a tree once, however many trees share it: the edits of a cell differ in one place."""

    def __init__(self, names: Names, algebra: SampledAlgebra) -> None:
        super().__init__(names, algebra)
        self._known: dict[int, tuple[n.Node, Value]] = {}

    def evaluate(self, node: n.Node) -> Value:
        """Return the value; raises as the evaluator does."""
        if (known := self._known.get(id(node))) is None:  # the node is kept, so that its id stays its own
            known = self._known[id(node)] = node, super().evaluate(node)
        return known[1]


class Probe:
    """A few generic configurations with round values, on the double plant."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names

    @cached_property
    def samples(self) -> SampledAlgebra:
        """The algebra of arrays over these configurations."""
        arm, generator = self.names.arm, np.random.default_rng(SEED)
        columns = [_round_values(joint, generator) for joint in arm.joints] if arm is not None else []
        q = np.array(columns).T if columns else np.zeros((PROBES, 0))
        return RoundSamples(self.checker.exact, q, SEED)

    def agreement(self, true: Scalar) -> Callable[[n.Node], bool] | None:
        """Return whether trees have the value of a scalar at these configurations; None where it has none itself."""
        try:
            with np.errstate(all="ignore"):  # what has no value at a probe agrees with nothing there
                target = self.samples.from_exact(true)
        except EvaluationError:
            return None
        tolerance = 1e-7 * (1.0 + np.abs(target))
        evaluator = Remembering(self.names, self.samples)

        def agrees(node: n.Node) -> bool:
            try:
                with np.errstate(all="ignore"):
                    value = as_scalar(evaluator.evaluate(node))
                    is_number = not isinstance(value, Matrix | Identity | list)
                    return is_number and bool(np.all(np.abs(value - target) < tolerance))
            except (ArmproofError, TypeError):
                return False

        return agrees

    def counterexample(self, outcome: Outcome, best: int) -> dict[str, float]:
        """Return the values of joints, lengths and letters (rad, m) at the worst sample."""
        assert outcome.true is not None and outcome.printed is not None
        probe = self.samples
        arm = self.names.arm
        values: dict[str, float] = {}
        depends = self._symbols_of(outcome)
        if arm is not None and (not depends or any(joint.symbol in depends for joint in arm.joints)):
            values = {joint.symbol: float(probe.q[best, k]) for k, joint in enumerate(arm.joints)}
        for member in (outcome.true, outcome.printed):
            for below in n.walk(member.node):
                symbol = self.names.known_symbol(below.key) if isinstance(below, n.Name) else None
                if symbol is None and isinstance(below, n.Name) and not depends and self._is_free_symbol(below):
                    symbol = below.key
                if symbol is not None:
                    values.setdefault(symbol, round(float(probe.symbol(symbol)[best]), 6))
        for symbol in depends:  # those that a defined name brings along
            values.setdefault(symbol, round(float(probe.symbol(symbol)[best]), 6))
        fixed = arm.lengths if arm is not None and not self._is_about_lengths(outcome) else {}
        told = {symbol: value for symbol, value in values.items() if symbol not in fixed}
        return told or values  # the arm's own lengths only where nothing else is chosen

    def worst_sample(self, outcome: Outcome) -> int:
        """Return at which of the configurations (from 0) the printed and the true value differ most: the counterexample."""
        with np.errstate(all="ignore"):
            try:
                worst = self._sampled_difference(outcome, self.samples)
            except EvaluationError:
                worst = np.zeros(self.samples.samples)
        if not np.isfinite(worst).any():
            return 0
        return int(
            np.argmax(worst >= (1 - TIE) * np.nanmax(worst))
        )  # of equal ones the first, however they were rounded

    def _symbols_of(self, outcome: Outcome) -> list[str]:
        """The symbols on which the wrong entries depend."""
        pair = outcome.pair
        if pair is None or outcome.sampled_only:
            return []
        cells = [side.rows[row][column] for row, column in outcome.wrong for side in (pair.true, pair.printed)]
        generators = {each for cell in cells if isinstance(cell, Scalar) for each in cell.generators}
        names = {name.split("/")[0] for kind, name in generators if kind in ("symbol", "cos", "sin")}
        return sorted(name for name in names if name != "pi" and not name[:1].isdigit())

    def _is_about_lengths(self, outcome: Outcome) -> bool:
        """Whether the wrong entries were right if all lengths were equal: lengths that are swapped, or one for another."""
        if outcome.pair is None or outcome.sampled_only or self.names.arm is None:
            return False
        one = self.checker.exact.ring.one
        equal = dict.fromkeys(self.names.arm.lengths, one)
        true, printed = outcome.pair.true.rows, outcome.pair.printed.rows
        try:
            return all(substitute(true[r][c] - printed[r][c], equal).is_zero() for r, c in outcome.wrong)
        except NoValue:  # with equal lengths a square is negative, or a divisor zero
            return False

    def _is_free_symbol(self, name: n.Name) -> bool:
        return self.names.is_free(name) and name.key in self.names.used and name.key not in self.names.state.definitions

    def _sampled_difference(self, outcome: Outcome, probe: SampledAlgebra) -> np.ndarray:
        assert outcome.true is not None and outcome.printed is not None
        if outcome.pair is not None and not outcome.sampled_only:
            rows, printed_rows = outcome.pair.true.rows, outcome.pair.printed.rows
            cells = _shortest([(rows[r][c], printed_rows[r][c]) for r, c in outcome.wrong])
            off = [np.abs(probe.from_exact(a - b)) for a, b in cells]
            return np.max(off, axis=0) if off else np.zeros(probe.samples)
        true, printed = (
            as_scalar(Evaluator(self.names, probe).evaluate(m.node)) for m in (outcome.true, outcome.printed)
        )
        if isinstance(true, Matrix) or isinstance(printed, Matrix):
            return np.zeros(probe.samples)
        return np.abs(true - printed)


def _shortest(cells: list[tuple[Scalar, Scalar]]) -> list[tuple[Scalar, Scalar]]:
    """Return the shortest wrong entries, one at least, of at most SAMPLED terms together: any of them refutes."""
    found: list[tuple[Scalar, Scalar]] = []
    total = 0
    for pair in sorted(cells, key=lambda pair: sum(map(count_terms, pair))):
        total += sum(map(count_terms, pair))
        if found and total > SAMPLED:
            break
        found.append(pair)
    return found


def count_terms(value: Scalar) -> int:
    """Return how many terms a scalar is made of."""
    return len(value.numerator) + len(value.denominator)
