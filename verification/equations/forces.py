"""Forces and moments that a document introduces by their components, F = (F_x, F_y): any numbers, as lengths are."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.equations.outcome import Outcome
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

_LETTERS = frozenset("FfM")  # N_x may be an entry of a rotation, m_x a mass
_LOADS = frozenset("FfHMNPQW")  # behind J^T, or in F = (0, 0, -W), where they can be nothing else
_WEIGHT = ("m", "g")
TORQUES = ("tau", "Gamma")
LETTERS = _LETTERS | _LOADS | {*TORQUES, "g"}  # one of them stands in whatever speaks of forces
_COMPONENT = regex(r"\w*,?[xyz]")


def heed_forces(names: Names, chain: n.Chain) -> None:
    """Take the components of a column for free symbols, until an equation says what they are: F_x = 10."""
    columns = [_components(cells_of(member)) for member in chain.members]
    is_force = any(map(_is_force, chain.members))
    columns = [
        column or (_loads(member) if is_force else []) for member, column in zip(chain.members, columns, strict=True)
    ]
    alone = [
        name for member, column in zip(chain.members, columns, strict=True) for name in column or _alone(member, names)
    ]
    introduced = all(column or isinstance(bare(m), n.Name) for m, column in zip(chain.members, columns, strict=True))
    balances = any(_is_torque(member, names) for member in chain.members)  # f_h = F_z says nothing of the force
    if alone and not (introduced and any(columns)) and not balances:
        names.state.adopted.difference_update(name.key for name in alone)
        return
    found = [name for below in _walked(chain) for name in (*_components(cells_of(below)), *_behind_transpose(below))]
    found += [name for column in columns for name in column]
    if balances:
        found += [name for below in _walked(chain) for name in _one(below) if name.base in "Ff"]
    names.state.adopted |= {name.key for name in found if names.is_open(name)}
    names.state.balanced |= {(base, names.state.exercise): product for base, product in _torques_in(chain)}


def with_components(chain: n.Chain, names: Names) -> n.Chain:
    """Return τ = J^T F = […] [F_x; F_y] with that column for F, or with that of the F_x and F_y in it: nothing else says what F is."""
    forces = [found for each in _walked(chain) if (found := _force_behind_transpose(each)) is not None]
    if (
        len(forces) != 1
        or not isinstance(name := bare(forces[0]), n.Name)
        or not _is_force(name)
        or not names.is_open(name)
    ):
        return chain
    letters = {part.key: part for each in _walked(chain) for part in _one(each) if part.base == name.base}
    cells = tuple((letters[key],) for key in sorted(letters))
    if [row[0].sub for row in cells] not in (["x", "y"], ["x", "y", "z"]):
        return chain
    members = (n.substitute_each(member, {id(name): n.Matrix(cells)}) for member in chain.members)
    return replace(chain, members=tuple(members))


def unless_left_out(outcome: Outcome, names: Names) -> Outcome:
    """Leave open what is refuted, and of which only one side holds a component: the other may hold its value."""
    if outcome.verdict is not Verdict.REFUTED or outcome.pair is None:
        return outcome
    keys = [symbols_in(side.cells) for side in (outcome.pair.true, outcome.pair.printed)]
    one, other = ({key for key in side if _is_key(key) or _is_load(key, names)} for side in keys)
    return outcome.left_open(say(Kind.FORCE_LEFT_OUT, names=sorted(one ^ other))) if one != other else outcome


def balanced_forces(names: Names) -> set[str]:
    """Return the letters of the forces of which the exercise says that the torques are J^T F: where the text gives one a value, it is of no other case."""
    exercises = ("", names.state.exercise)
    told = (product for (_, exercise), product in names.state.balanced.items() if exercise in exercises)
    forces = (_force_behind_transpose(each) for each in told if each is not None)
    return {key for each in forces if each is not None and (key := bare_key(each)) is not None}


def is_force_of_numbers(name: n.Name, value: n.Node) -> bool:
    """Whether a letter is said to be a force of which the components are numbers: F = (10, 5)."""
    cells = cells_of(value)
    return _is_force(name) and len(cells) > 1 and all(map(n.is_number, cells))


def _walked(chain: n.Chain) -> Iterator[n.Node]:
    return (below for member in chain.members for below in n.walk(member))


def _is_key(key: str) -> bool:
    base, _, sub = key.partition("_")
    return base in _LETTERS and _COMPONENT.fullmatch(sub) is not None


def _is_load(key: str, names: Names) -> bool:
    return key in names.state.adopted and key.partition("_")[0] in _LOADS


def _is_force(node: n.Node) -> bool:
    """Whether a side is the name of a force, F or f."""
    name = bare(node)
    return isinstance(name, n.Name) and name.base in ("F", "f") and not name.dots


def _is_torque(node: n.Node, names: Names) -> bool:
    """Whether a side is the torque of a joint, τ_2, or τ_θ of the joint θ, or τ of the one that turns; or the force f_r of a slide r."""
    name = bare(node)
    if not isinstance(name, n.Name) or not _is_plain(name):
        return False
    return (name.base in TORQUES and name.sub.isdigit()) or joint_of_effort(name, names) is not None


def joint_of_effort(name: n.Name, names: Names) -> str | None:
    """Return the joint whose torque or force a name is by its letters: τ_θ, f_r, τ or f where one joint alone turns or slides; None of another."""
    kind = "revolute" if name.base in TORQUES else "prismatic" if name.base in ("f", "F") else ""
    of_kind = [symbol for symbol, joint in names.joints.items() if joint.kind == kind]
    if not name.sub:
        return of_kind[0] if len(of_kind) == 1 else None
    return next((symbol for symbol in of_kind if symbol == name.sub and not symbol.isdigit()), None)


def _behind_transpose(node: n.Node) -> list[n.Name]:
    """Return the components of the column that J^T multiplies, each a letter or a letter with a minus, zeros beside them; those of F."""
    force = _force_behind_transpose(node)
    if isinstance(force, n.Name) and _is_force(force) and not force.sub:
        return [n.Name(force.base, axis) for axis in "xyz"]
    return _loads(force) if force is not None else []


def _force_behind_transpose(node: n.Node) -> n.Node | None:
    """Return the factor behind J^T."""
    if not isinstance(node, n.Product) or len(node.factors) < 2:
        return None
    first, second = map(bare, node.factors[:2])
    base = n.unapplied(bare(first.base)) if isinstance(first, n.Postfix) and first.operator == "T" else None
    return second if isinstance(base, n.Name) and base.base == "J" else None


def _torques_in(chain: n.Chain) -> Iterator[tuple[str, n.Node]]:
    """Yield the letter of torques that a chain says to be J^T F, and nothing else, with that product."""
    sides = [bare(member) for member in chain.members]
    products = [each for each in sides if _force_behind_transpose(each) is not None and len(each.factors) == 2]  # type: ignore[attr-defined]
    letters = [each.base for each in sides if _is_plain(each) and each.base in TORQUES and not each.sub]  # type: ignore[attr-defined]
    yield from ((letter, products[0]) for letter in letters if products)


def _loads(node: n.Node) -> list[n.Name]:
    """Return the letters of a column of such and of zeros, or nothing of another one."""
    cells = [_unsigned(cell) for cell in cells_of(node)]
    loads = [cell for cell in cells if not (isinstance(cell, n.Number) and cell.value == 0)]
    factors = [bare(factor) for load in loads for factor in (_weight(load) or _with_direction(load) or (load,))]
    return factors if all(map(_is_a_load, factors)) else []  # type: ignore[return-value]


def _is_a_load(node: n.Node) -> bool:
    return _is_plain(node) and (node.base in _LOADS or node.key in _WEIGHT)  # type: ignore[attr-defined]


def _with_direction(node: n.Node) -> Sequence[n.Node]:
    """Return the load of F c_1, which a sine or a cosine of joints turns."""
    factors = [bare(each) for each in node.factors] if isinstance(node, n.Product) else []
    loads = [each for each in factors if _is_a_load(each)]
    others = [each for each in factors if each not in loads]
    return loads if len(loads) == 1 and all(n.is_call(each, "cos", "sin") for each in others) else ()


def _weight(node: n.Node) -> Sequence[n.Node]:
    """Return the factors of m g."""
    is_weight = isinstance(node, n.Product) and [*map(bare_key, node.factors)] == [*_WEIGHT]
    return node.factors if is_weight else ()  # type: ignore[attr-defined]


def _unsigned(node: n.Node) -> n.Node:
    node = bare(node)
    return bare(node.terms[0][1]) if isinstance(node, n.Sum) and len(node.terms) == 1 else node


def _components(cells: Sequence[n.Node]) -> list[n.Name]:
    """Return the components of a force or of a moment that a column holds, zeros beside them; none of another one."""
    found = [name for cell in cells for name in _one(cell)]
    zeros = sum(isinstance(zero := bare(cell), n.Number) and zero.value == 0 for cell in cells)
    return found if len(found) > 1 and len(found) + zeros == len(cells) else []


def _one(node: n.Node) -> list[n.Name]:
    """Return a component that stands alone, in a list."""
    name = bare(node)
    return [name] if _is_plain(name) and _is_key(name.key) else []  # type: ignore[attr-defined, list-item]


def _alone(node: n.Node, names: Names) -> list[n.Name]:
    """Return a component that stands alone on a side: an equation says what it is."""
    name = bare(node)
    return _one(node) or ([name] if _is_plain(name) and _is_load(name.key, names) else [])  # type: ignore[attr-defined, list-item]


def _is_plain(node: n.Node) -> bool:
    return isinstance(node, n.Name) and not (node.dots or node.primes or node.sup or node.pre_sub or node.pre_sup)
