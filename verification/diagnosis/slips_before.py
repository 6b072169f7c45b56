"""A refuted equation may be right: what a display before it says of one of its names may hold the slip."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice, permutations

from armproof.verification.algebra.matrix import Matrix, as_matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.diagnosis.apart import Apart
from armproof.verification.diagnosis.mend import LearntNotation
from armproof.verification.diagnosis.slips import Edit, Letters, is_trigonometric, single_edits, with_sign_turned
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key, is_number
from armproof.verification.latex.writer import SWAPPED, Notation, Writer
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Definition
from armproof.verification.verdict import HOLDS, SlipBefore

MOST_EDITS = 250  # of one formula
MOST_SAMPLED_EDITS = 60  # of a side of an equation that is decided on samples
_OTHER = {Fraction(0): Fraction(1), Fraction(1): Fraction(0)}


def slip_before(
    checker: ChainChecker, learnt: LearntNotation, outcome: Outcome, again: Callable[[], bool]
) -> SlipBefore | None:
    """Return that an equation holds with one slip mended in what its document says of a name in it, or None.

    What is no equation of two values is decided `again`. A slip that an equation before needed is tried first.
    """
    made, met = checker.names.state.definitions, checker.names.state.slips
    for key, line in sorted(outcome.uses & met.keys()):
        definition, (finding, mended) = made.get(key), met[key, line]
        if definition is None or definition.line != line or definition.formula is None:
            continue
        if _holds_with(checker, key, definition, mended, outcome, again, Apart(checker, key)):
            return _slip(key, definition, finding, mended)
    return next(_mending(checker, learnt, outcome, again, outcome.uses - met.keys()), None)


def slips_before(checker: ChainChecker, learnt: LearntNotation, outcome: Outcome) -> Iterator[SlipBefore]:
    """Yield all slips in the definitions of its names with which an equation of two exact values holds; what was found of others stays as it is."""
    state = checker.names.state
    met = state.slips.copy()
    try:
        yield from _mending(checker, learnt, outcome, lambda: False, outcome.uses)
    finally:
        state.slips = met


def nothing_else_mends(
    checker: ChainChecker, learnt: LearntNotation, outcome: Outcome, found: SlipBefore, again: Callable[[], bool]
) -> bool:
    """Whether an equation that a slip in a definition of its own section mends holds with no slip in another one, and with none of its own."""
    state = checker.names.state
    if outcome.there or len(outcome.nodes) != 2 or state.definitions[found.name].section != state.section:
        return False
    others = {(key, line) for key, line in outcome.uses if key != found.name}
    if _is_a_case(state.definitions[found.name].formula, found.formula) or any(
        True for _ in _mending(checker, learnt, outcome, again, others)
    ):
        return False
    return not mends_itself(checker, learnt, outcome)


def mends_itself(checker: ChainChecker, learnt: LearntNotation, outcome: Outcome) -> bool:
    """Whether an equation of two sides holds with one slip of its own, made at one place or all through a side."""
    state = checker.names.state
    around = [
        *outcome.nodes,
        *filter(None, (state.definitions[key].formula for key, _ in outcome.uses if key in state.definitions)),
    ]
    is_exact = outcome.pair is not None and not any(map(_has_branches, outcome.nodes))
    for one, other in permutations(outcome.nodes):
        as_it_is = checker.member(other) if is_exact else None
        edits = chain(_throughout(one), (each.node for each in _edits(one, around, learnt.letters(one))))
        for edited in islice(edits, MOST_EDITS if is_exact else MOST_SAMPLED_EDITS):
            checker.exact.budget.check()
            if (
                _is_confirmed(checker, edited, other)
                if as_it_is is None
                else _is_equal(checker.member(edited), as_it_is)
            ):
                return True
    return False


def _throughout(side: n.Node) -> Iterator[n.Node]:
    """Yield a side with one sign turned wherever the same stands: in angles that are alike, before a term of several entries. What it was derived from had it."""
    arguments = [b.arguments[0] for b in n.walk(side) if isinstance(b, n.Call) and is_trigonometric(b) and b.arguments]
    angles = [each for each in map(n.ungrouped, arguments) if isinstance(each, n.Sum)]
    for angle in dict.fromkeys(each for each in angles if angles.count(each) > 1):
        for place in range(len(angle.terms)):
            turned = with_sign_turned(angle, place)
            yield n.substitute_each(side, {id(each): turned for each in angles if each == angle})
    sums = [each for each in n.walk(side) if isinstance(each, n.Sum) and each not in angles]
    alone = [each for below in n.walk(side) if isinstance(below, n.Matrix) for each in below.cells if each not in sums]
    held = [*alone, *(term for each in sums for _, term in each.terms)]
    for term in dict.fromkeys(each for each in held if held.count(each) > 1):
        turned_sums = {id(each): _with_term_turned(each, term) for each in sums}
        yield n.substitute_each(side, turned_sums | {id(each): n.Sum((("-", each),)) for each in alone if each == term})


def _with_term_turned(node: n.Sum, term: n.Node) -> n.Sum:
    return next((with_sign_turned(node, k) for k, (_, each) in enumerate(node.terms) if each == term), node)


def _is_a_case(printed: n.Node | None, mended: object) -> bool:
    """Whether a formula is another one without some of its letters: an equation about that case is no witness against it."""
    assert printed is not None and isinstance(mended, n.Node)
    return _keys(mended) < _keys(printed)


def _is_confirmed(checker: ChainChecker, one: n.Node, other: n.Node) -> bool:
    """Whether an equation that is decided on samples holds."""
    with checker.names.state.unchanged():
        tried = checker.check(n.Chain((one, other), ("=",)), 1, 0, define=False)
    return bool(tried) and all(each.verdict in HOLDS for each in tried)


def _is_equal(one: Member, other: Member) -> bool:
    """Whether two sides are exactly equal."""
    try:
        return one.known and other.known and _equal(as_matrix(one.value), as_matrix(other.value))
    except EvaluationError:
        return False


def _mending(
    checker: ChainChecker, learnt: LearntNotation, outcome: Outcome, again: Callable[[], bool], keys: Iterable[tuple[str, int]]
) -> Iterator[SlipBefore]:  # fmt: skip
    """Yield the slips in some definitions with which an equation holds."""
    made = checker.names.state.definitions
    for key, line in sorted(keys):
        definition = made.get(key)
        formula = definition.formula if definition is not None else None
        if definition is None or formula is None or names_alone(formula) or definition.line != line or line == 0:
            continue
        apart = Apart(checker, key)
        for edit in islice(_edits(formula, outcome.nodes, learnt.letters(formula)), MOST_EDITS):
            checker.exact.budget.check()
            new = (_keys(edit.node, checker.names) - _keys(formula)) & made.keys()
            if any(name == key or made[name].line >= line for name in new):  # it rests on itself, or on what follows
                continue
            if _holds_with(checker, key, definition, edit.node, outcome, again, apart):
                checker.names.state.slips[key, line] = edit.finding, edit.node
                yield _slip(key, definition, edit.finding, edit.node)


def _slip(key: str, definition: Definition, finding: Finding, formula: n.Node) -> SlipBefore:
    texts = (written(definition.formula), written(formula)) if definition.formula is not None else ("", "")
    return SlipBefore(key, definition.line, finding, formula, False, *texts)


def _edits(formula: n.Node, around: Iterable[n.Node], letters: Letters) -> Iterator[Edit]:
    """Yield a definition with a slip, of the letters and the sines that stand in it and around it; nobody turns all signs of a sum."""
    around = list(around)
    found = chain(
        _cells(formula), _with_a_term(formula, around), _with_an_angle(formula, around), _exchanged(formula, around),
        single_edits(formula, letters), _multiplied(formula),
    )  # fmt: skip
    is_sum = isinstance(formula, n.Sum) and len(formula.terms) > 1
    return (each for each in found if not (is_sum and each.finding == say(Kind.WRONG_SIGN)))


def _cells(formula: n.Node) -> Iterator[Edit]:
    """Yield a matrix with 1 where 0 stands, or 0 where 1 does, and with an entry of the other sign."""
    for cell in formula.cells if isinstance(formula, n.Matrix) else ():
        other = _OTHER.get(cell.value) if isinstance(cell, n.Number) else None
        if other is not None:
            changed = n.substitute(formula, cell, n.Number(other, str(other), span=cell.span))
            size = "small" if other else "large"
            yield Edit(changed, "number", say(Kind.WRONG_NUMBER, number=written(cell), size=size))
        yield Edit(n.substitute(formula, cell, n.Sum((("-", n.Group(cell)),))), "sign", say(Kind.WRONG_SIGN))


def _with_a_term(formula: n.Node, around: Iterable[n.Node]) -> Iterator[Edit]:
    """Yield a sum with one term more, like one of its own with another index, or one around it, with its sines for cosines or not: it was left out."""
    terms = formula.terms if isinstance(formula, n.Sum) else (("+", formula),)
    own = [term for _, term in terms if _is_length_and_turn(term)]
    indices = {b.sub for node in around for b in n.names(node) if b.sub.isdigit()}
    others = [each for node in around for each in n.walk(node) if _is_length_and_turn(each)]
    pool = [*_with_other_index(own, indices), *map(_turned, others), *others] if own else []
    spoken = {b.key for node in (formula, *around) for b in n.names(node)}
    for term in (each for each in dict.fromkeys(pool) if _keys(each) <= spoken):
        for sign in "+-" if term not in own else "":
            finding = say(Kind.MISSING_TERM, term=written(n.Sum(((sign, term),))))
            yield Edit(n.Sum((*terms, (sign, term)), span=formula.span), "term", finding)


def _is_length_and_turn(node: n.Node) -> bool:
    """Whether a node is a letter times a sine or a cosine: l_2 c_{12}."""
    return isinstance(node, n.Product) and sorted(map(is_trigonometric, node.factors)) == [False, True] and all(map(_stands_alone, node.factors))  # fmt: skip


def _with_other_index(terms: Iterable[n.Node], indices: Iterable[str]) -> Iterator[n.Node]:
    for term in terms:
        for index in sorted(indices):
            named = [b for b in n.names(term) if b.sub.isdigit()]
            if len({b.sub for b in named}) == 1 and named[0].sub != index:
                yield n.substitute_each(
                    term, {id(b): replace(b, sub=index, text=b.text.replace(b.sub, index)) for b in named}
                )


def _turned(term: n.Node) -> n.Node:
    """Return a term with a sine for its cosine, or a cosine for its sine."""
    calls = (b for b in n.walk(term) if isinstance(b, n.Call))
    return n.substitute_each(term, {id(b): replace(b, function=SWAPPED.get(b.function, b.function)) for b in calls})


def _with_an_angle(formula: n.Node, around: Iterable[n.Node]) -> Iterator[Edit]:
    """Yield a formula with an angle subtracted in a sine or a cosine, one of those around it: single edits add angles alone."""
    pool = {b for node in around for b in n.names(node) if b.base in ("theta", "q") and not b.dots}
    for call in [b for b in n.walk(formula) if isinstance(b, n.Call) and is_trigonometric(b) and b.arguments]:
        argument = n.ungrouped(call.arguments[0])
        held = {*n.names(argument)}
        for angle in sorted(pool - held if held else (), key=lambda each: each.key):
            terms = argument.terms if isinstance(argument, n.Sum) else (("+", argument),)
            longer = replace(call, arguments=(n.Sum((*terms, ("-", angle))),), style="macro()")
            yield Edit(n.substitute(formula, call, longer), "index", say(Kind.MISSING_ANGLE, angle=written(angle)))


def _exchanged(formula: n.Node, around: Iterable[n.Node]) -> Iterator[Edit]:
    """Yield a formula with another letter, or another sine or cosine, in the place of one, or a letter in that of its rate."""
    around = tuple(around)
    pool = dict.fromkeys(b for node in (formula, *around) for b in n.walk(node) if _stands_alone(b))
    pool |= dict.fromkeys(_angles_of(around)) if any(isinstance(b, n.Name) and b.base == "theta" for b in pool) else {}
    for node in filter(_stands_alone, n.walk(formula)):
        still = (
            [replace(node, dots=0, text=replace(node, dots=0).key)] if isinstance(node, n.Name) and node.dots else []
        )
        for other in (*pool, *still):
            if other != node and _is_like(node, other):
                finding = say(Kind.WRONG_NAME, printed=written(node), correct=written(other))
                yield Edit(n.substitute(formula, node, replace(other, span=node.span)), "name", finding)


def _angles_of(nodes: Iterable[n.Node]) -> Iterator[n.Name]:
    """Yield the angles of which c_4 and s_4 in formulas are the cosine and the sine."""
    for each in (below for node in nodes for below in n.walk(node) if isinstance(below, n.JointAngles)):
        if len(each.terms) == 1:
            index = str(each.terms[0][1])
            yield n.Name("theta", index, text=rf"\theta_{index}")


def _multiplied(formula: n.Node) -> Iterator[Edit]:
    """Yield a formula in which a letter alone has a sine or a cosine of the formula as a factor, or one of those a letter: it was left out."""
    pool = [below for below in dict.fromkeys(n.walk(formula)) if _stands_alone(below)]
    cells = formula.cells if isinstance(formula, n.Matrix) else (formula,)
    terms = (term for cell in cells for _, term in (cell.terms if isinstance(cell, n.Sum) else (("+", cell),)))
    for term in terms:
        for other in pool if _stands_alone(term) else ():
            if is_trigonometric(term) == is_trigonometric(other):
                continue
            finding = say(Kind.MISSING_FACTOR, factor=written(other))
            yield Edit(n.substitute(formula, term, n.Product((term, other), ("",))), "factor", finding)


def _is_like(node: n.Node, other: n.Node) -> bool:
    """Whether one may be written for the other: sines and cosines, names of one letter, or letters without an index."""
    if isinstance(node, n.Name) and isinstance(other, n.Name):
        return node.base == other.base or (node.key, other.key) == (node.base, other.base)
    return isinstance(node, n.Call) and isinstance(other, n.Call)


def _keys(node: n.Node, names: Names | None = None) -> set[str]:
    """Return the names in a formula, each as the T(θ) that names may say T to be."""
    found = n.names(node)
    return {(names.applied_to_joints(below) if names is not None else None) or below.key for below in found}


def names_alone(formula: n.Node) -> bool:
    """Whether a name is given a number, a name, or a vector or a matrix of names: F = (F_x, F_y) claims nothing."""
    cells = formula.cells if isinstance(formula, n.Matrix) else cells_of(formula) or (formula,)
    return is_number(formula) or all(bare_key(cell) is not None for cell in cells)


def written(node: n.Node) -> str:
    """Return a tree in plain LaTeX."""
    return Writer("", n.Number(Fraction(0), "0"), Notation()).write(node)


def _stands_alone(node: n.Node) -> bool:
    return (isinstance(node, n.Name) and node.key != "pi") or is_trigonometric(node)


def _holds_with(
    checker: ChainChecker, key: str, definition: Definition, formula: n.Node, outcome: Outcome,
    again: Callable[[], bool], apart: Apart,
) -> bool:  # fmt: skip
    """Whether an equation holds where a name has another formula."""
    state = checker.names.state
    state.definitions[key] = replace(definition, evaluate=checker.members.meaning(formula))
    try:
        others = (state.definitions[name].formula for name, _ in outcome.uses if name in state.definitions)
        nodes = (*outcome.nodes, formula, *filter(None, others))
        if outcome.pair is None or outcome.there or any(map(_has_branches, nodes)):
            return again()
        return _is_equal(*apart.sides(*outcome.nodes))
    except RecursionError:  # it rests on itself by another name: M on its entry m_11, r on X = r cos ψ
        return False
    finally:
        state.definitions[key] = definition  # the dictionary may be another one: what is tried puts a whole state back


def _has_branches(node: n.Node) -> bool:
    """Whether an equation holds on one branch of what stands in it: ±, or an angle by its sine or cosine."""
    return n.has_branches(node) or n.has_arcs(node)


def _equal(one: Matrix, other: Matrix) -> bool:
    cells = [*zip(one.cells, other.cells, strict=False)] if one.shape == other.shape else [(None, None)]
    return all(isinstance(a, Scalar) and isinstance(b, Scalar) and (a - b).is_zero() for a, b in cells)
