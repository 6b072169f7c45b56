"""A compiled program gives what its terms mean: exact entries, sums, products and minors, at any number of configurations."""

from fractions import Fraction
from functools import partial
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armproof.models.arm import Joint
from armproof.models.bulk.graph import ONE, ZERO, Graph
from armproof.models.bulk.inputs import JointInputs
from armproof.models.bulk.jacobian_part import maximal_minors
from armproof.models.bulk.program import BLOCK, Program
from armproof.models.exact.numbers import constant_value
from armproof.models.exact.polynomial import Entry, Generator
from tests.laws import examples
from tests.models.evaluation import evaluate

JOINTS = (
    Joint(1, "j1", "theta_1", "revolute", -np.inf, np.inf),
    Joint(2, "j2", "d_2", "prismatic", -np.inf, np.inf),
    Joint(3, "j3", "theta_3", "revolute", -np.inf, np.inf),
)
INPUTS = partial(JointInputs, JOINTS)
SYMBOLS = [joint.symbol for joint in JOINTS]
VALUES = {"a_1": 0.45, "alpha_1": 0.7}
VARYING = [("cos", "theta_1"), ("sin", "theta_1"), ("symbol", "d_2"), ("cos", "theta_3"), ("sin", "theta_3")]
CONSTANT = [("symbol", "a_1"), ("cos", "alpha_1"), ("sin", "pi/5"), ("cos", "0.3"), ("sqrt", "2")]
COUNTS = (0, 1, 2, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK, 2 * BLOCK + 5)

monomials = st.dictionaries(st.sampled_from([*VARYING, *CONSTANT]), st.integers(1, 3), max_size=4).map(
    lambda powers: tuple(sorted(powers.items()))
)
coefficients = st.fractions(-5, 5, max_denominator=12).filter(bool)
entries = st.dictionaries(monomials, coefficients, max_size=6)


def new_graph() -> Graph:
    return Graph(lambda generator: None if generator[1] in SYMBOLS else constant_value(generator, VALUES))


def configurations(count: int) -> np.ndarray:
    return np.random.default_rng(count).uniform(-4.0, 4.0, (count, 3))


def direct(entry: Entry, q: np.ndarray) -> np.ndarray:
    """Return the value of an entry term by term, with NumPy's own cosines and sines."""

    def value(generator: Generator):
        kind, name = generator
        if name not in SYMBOLS:
            return constant_value(generator, VALUES)
        return {"cos": np.cos, "sin": np.sin, "symbol": np.asarray}[kind](q[:, SYMBOLS.index(name)])

    return np.broadcast_to(evaluate(entry, value), (len(q),))


def sizes(entry: Entry, q: np.ndarray) -> np.ndarray:
    """Return what the rounding of an entry is measured by: the sum of the sizes of its terms."""
    return 1 + sum((np.abs(direct({m: c}, q)) for m, c in entry.items()), np.zeros(len(q)))


@examples(150)
@given(st.lists(entries, min_size=1, max_size=5), st.integers(1, 40))
def test_a_program_gives_the_value_of_each_entry(some: list[Entry], count: int) -> None:
    graph, q = new_graph(), configurations(count)
    (values,) = Program(graph, INPUTS, [[graph.entry(entry) for entry in some]])(q)
    assert values.shape == (count, len(some))
    for column, entry in zip(values.T, some, strict=True):
        assert (np.abs(column - direct(entry, q)) <= 1e-13 * sizes(entry, q)).all()


@examples(100)
@given(entries, entries, st.floats(-3, 3))
def test_sums_and_products_of_terms_are_those_of_their_values(left: Entry, right: Entry, number: float) -> None:
    graph, q = new_graph(), configurations(9)
    a, b = graph.entry(left), graph.entry(right)
    made = [graph.add(a, b), graph.multiply(a, b), graph.scale(a, number), graph.dot([a, b], [b, a])]
    x, y = direct(left, q), direct(right, q)
    scale = sizes(left, q) * sizes(right, q)
    for column, expected in zip(
        Program(graph, INPUTS, [made])(q)[0].T, (x + y, x * y, number * x, 2 * x * y), strict=True
    ):
        assert (np.abs(column - expected) <= 1e-12 * scale).all()


@pytest.mark.parametrize("count", COUNTS)
def test_blocks_join_without_a_seam(count: int) -> None:
    graph, q = new_graph(), configurations(count)
    groups = [
        [graph.entry({((VARYING[0], 1), (VARYING[2], 1)): Fraction(1)}), ONE],
        [graph.entry({((VARYING[4], 1),): Fraction(-3)})],
    ]
    first, second = Program(graph, INPUTS, groups)(q)
    np.testing.assert_allclose(first[:, 0], np.cos(q[:, 0]) * q[:, 1], atol=1e-14)
    np.testing.assert_array_equal(first[:, 1], np.ones(count))
    np.testing.assert_allclose(second[:, 0], -3 * np.sin(q[:, 2]), atol=1e-14)
    assert first.flags.c_contiguous and first.shape == (count, 2) and second.shape == (count, 1)


def test_cosines_and_sines_are_right_at_every_angle() -> None:
    quarters = np.arange(-64, 65) * np.pi / 2
    angles = np.concatenate(
        [quarters, quarters + 1e-9, np.linspace(-50, 50, 9999), [1e-300, -0.0, 1e5, 1e15, np.nextafter(np.pi, 4)]]
    )
    q = np.zeros((len(angles), 3))
    q[:, 0] = angles
    graph = new_graph()
    cosine, sine = Program(graph, INPUTS, [[graph.entry({((g, 1),): Fraction(1)}) for g in VARYING[:2]]])(q)[0].T
    np.testing.assert_allclose(cosine, np.cos(angles), rtol=0, atol=1e-15)
    np.testing.assert_allclose(sine, np.sin(angles), rtol=0, atol=1e-15)


def test_the_same_expression_is_computed_once() -> None:
    graph = new_graph()
    c, s, d = (graph.entry({((generator, 1),): Fraction(1)}) for generator in VARYING[:3])
    assert graph.multiply(c, s) == graph.multiply(s, c)
    assert graph.add(c, s) == graph.add(s, c)
    difference = graph.add(c, graph.scale(s, -1))
    assert graph.add(s, graph.scale(c, -1)) == graph.scale(difference, -1)
    assert graph.add(difference, graph.scale(difference, -1)) == ZERO
    assert graph.multiply(d, ZERO) == ZERO and graph.multiply(d, ONE) == d
    program = Program(
        graph, INPUTS, [[difference, graph.scale(difference, 2.0), graph.multiply(difference, difference)]]
    )
    assert [instruction.operation for instruction in program.instructions].count(np.subtract) == 1


def test_what_no_output_needs_is_not_computed() -> None:
    graph = new_graph()
    c = graph.entry({((VARYING[0], 1),): Fraction(1)})
    graph.multiply(graph.add(c, ONE), c)
    assert len(Program(graph, INPUTS, [[graph.multiply(c, c)]]).instructions) == 1


@pytest.mark.parametrize("shape", [(1, 1), (2, 2), (3, 3), (4, 4), (1, 4), (2, 4), (3, 5), (4, 6)])
def test_minors_are_determinants(shape: tuple[int, int]) -> None:
    height, width = shape
    rng = np.random.default_rng(7)
    graph, q = new_graph(), configurations(11)
    # Entries a cos θ_1 + b sin θ_1 + c, one in four of them zero.
    weights = rng.normal(size=(height, width, 3)) * (rng.random((height, width, 1)) < 0.75)
    inputs = [*(graph.entry({((generator, 1),): Fraction(1)}) for generator in VARYING[:2]), ONE]
    matrix = [
        [graph.add(*(graph.scale(x, w) for x, w in zip(inputs, cell, strict=True))) for cell in row] for row in weights
    ]
    values = weights @ np.stack([np.cos(q[:, 0]), np.sin(q[:, 0]), np.ones(len(q))])
    values = values.transpose(2, 0, 1)
    minors = maximal_minors(graph, matrix)
    found = Program(graph, INPUTS, [minors])(q)[0]
    expected = np.stack([np.linalg.det(values[:, :, list(c)]) for c in combinations(range(width), height)], axis=1)
    np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize("slip", ["operation", "operand", "constant"])
def test_a_slip_in_one_instruction_changes_the_values(slip: str) -> None:
    graph, q = new_graph(), configurations(20)
    entry: Entry = {
        ((VARYING[0], 1), (VARYING[2], 1)): Fraction(2),
        ((VARYING[1], 1),): Fraction(1),
        (): Fraction(1, 3),
    }
    program = Program(graph, INPUTS, [[graph.entry(entry)]])
    kinds = {"operation": np.multiply, "operand": np.multiply, "constant": np.add}
    place = next(
        i
        for i, one in enumerate(program.instructions)
        if one.operation is kinds[slip] and isinstance(one.operands[1], int) == (slip != "constant")
    )
    old = program.instructions[place]
    program.instructions[place] = {
        "operation": lambda: old._replace(operation=np.subtract),
        "operand": lambda: old._replace(operands=(old.operands[1], *old.operands[1:])),
        "constant": lambda: old._replace(operands=(old.operands[0], np.array(0.3), old.operands[2])),
    }[slip]()
    assert (np.abs(program(q)[0][:, 0] - direct(entry, q)) > 1e-13 * sizes(entry, q)).any()
