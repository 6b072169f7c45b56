"""The statements of a display as they are to be decided: without what every one says, equations and conditions apart."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeGuard

from armproof.verification.display.arc_ranges import is_range_of_arc
from armproof.verification.equations.index_ranges import without_index_range
from armproof.verification.evaluation.calls import WHOLE_VECTORS
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.latex.vocabulary import ASKED
from armproof.verification.naming.names import Names

WHOLE = ("Z", "N")  # the sets of k in θ = kπ
_ARCS_OF = {"acos": "cos", "asin": "sin", "atan": "tan"}
DEGREES = frozenset(range(30, 361, 15))  # without a mark
TURNS = ("cos", "sin", "tan")
VECTORS = ("\\mathbf", "\\boldsymbol", "\\bm", "\\vec", "\\overrightarrow", "\\underline", "\\textbf")
FOR_ALL = ("forall", "for all", "for every", "for any", "pour tout", "pour tous")


def prepared(statements: list[n.Statement], names: Names) -> list[n.Statement]:
    """Return the statements that are to be decided: without "for all", what vanishes at its end apart."""
    if len(statements) > 1:
        statements = _with_other_solutions(without_index_range(_of_spaced_factors(statements)))
        statements = _with_arguments_before(statements)
    statements = _with_degrees(statements, names)
    return [part for statement in _without_for_all(statements, names) for part in _without_vanishing_end(statement)]


def _with_degrees(statements: list[n.Statement], names: Names) -> list[n.Statement]:
    """Return θ_2 = 0 or 180 with the mark of degrees behind what nobody means in radians."""
    found, is_angle = [], False
    for each in statements:
        if isinstance(each, n.Chain):
            others = [member for member in each.members if not _is_angle(member, names)]
            is_angle = len(others) < len(each.members) or (is_angle and not each.relations)
            if is_angle and all(isinstance(_size(member), n.Number) for member in others):
                each = replace(each, members=tuple(map(_marked, each.members)))
        found.append(each)
    return found


def beside_arcs(statement: n.Statement) -> n.Statement:
    """Return a statement with the mark of degrees behind what nobody means in radians: 180 of 180 − arccos(…), cos(90)."""
    if not isinstance(statement, n.Chain):
        return statement
    calls = [b for m in statement.members for b in n.walk(m) if n.is_call(b, *TURNS)]
    inside: dict[int, n.Node] = {id(each.arguments[-1]): _marked_in(each.arguments[-1]) for each in calls}
    members = (n.substitute_each(m, inside) if inside else m for m in statement.members)
    return replace(statement, members=tuple(map(_marked_beside_arcs, members)))


def _marked_in(argument: n.Node) -> n.Node:
    """Return an argument of a cosine that is a number of degrees by itself, in parentheses or without, with its mark."""
    inner = argument.inner if isinstance(argument, n.Group) else argument
    marked = _marked(inner)
    return argument if marked is inner else marked


def _marked_beside_arcs(node: n.Node) -> n.Node:
    if not isinstance(node, n.Sum) or not any(n.is_call(term, *n.ARCS) for _, term in node.terms):
        return node
    return replace(node, terms=tuple((sign, _marked(term)) for sign, term in node.terms))


def _is_angle(node: n.Node, names: Names) -> bool:
    """Whether a side is a joint's angle; without an arm that is θ."""
    if not isinstance(node, n.Name) or node.dots:
        return False
    return names.is_angle(names.known_symbol(node.key)) if names.arm is not None else node.base == "theta"


def _size(node: n.Node) -> n.Node:
    """Return a number without its sign, anything else as it stands."""
    return node.terms[0][1] if isinstance(node, n.Sum) and len(node.terms) == 1 else node


def _marked(node: n.Node) -> n.Node:
    """Return a number of degrees that tells itself, ±90 or 180, with its mark; anything else as it stands."""
    size = _size(node)
    if not (isinstance(size, n.Number) and size.value in DEGREES):
        return node
    marked = n.Postfix(size, "deg", span=size.span)
    return replace(node, terms=((node.terms[0][0], marked),)) if isinstance(node, n.Sum) else marked


def _of_spaced_factors(statements: list[n.Statement]) -> list[n.Statement]:
    r"""Join {}^0_3R = {}^0_1R \quad {}^1_2R \quad {}^2_3R = […]: a transform that stands alone between two equations is a factor."""
    for at in range(1, len(statements) - 1):
        before, alone, behind = statements[at - 1 : at + 2]
        if not (isinstance(before, n.Chain) and isinstance(alone, n.Chain) and isinstance(behind, n.Chain)):
            continue
        factors = (before.members[-1], *alone.members, behind.members[0])
        if not before.relations or alone.relations or not behind.relations or not all(map(_is_transform, factors)):
            continue
        product = n.Product(factors, ("",) * (len(factors) - 1), span=(factors[0].span[0], factors[-1].span[1]))
        chain = n.Chain(
            (*before.members[:-1], product, *behind.members[1:]), (*before.relations, *behind.relations),
            span=(before.span[0], behind.span[1]),
        )  # fmt: skip
        return [*statements[: at - 1], chain, *_of_spaced_factors(statements[at + 2 :])]
    return statements


def _with_other_solutions(statements: list[n.Statement]) -> list[n.Statement]:
    """Return θ = arccos D or -arccos D as two equations; numbers that are joined so, and what arrows join, are conditions."""
    if not all(each.kind in ("or", "and", "words") for each in statements if isinstance(each, n.Connective)):
        return statements
    found: list[n.Statement] = []
    for each in statements:
        before, joined = found[-2:] if len(found) > 1 else (None, None)
        is_joined = isinstance(joined, n.Connective) and joined.kind == "or"
        if is_joined and _is_solution(before) and _is_formula(each):
            each = replace(each, members=(before.members[0], *each.members), relations=("=",))
        found.append(each)
    return found


def _with_arguments_before(statements: list[n.Statement]) -> list[n.Statement]:
    """Return cos θ = D, θ = ±arccos(·) with D for what the dot stands for: the cosine is equated to it just before."""
    found: list[n.Statement] = []
    for each in statements:
        before = next((one for one in reversed(found) if isinstance(one, n.Chain)), None)
        if isinstance(each, n.Chain) and before is not None and set(before.relations) == {"="}:
            first, last = bare(before.members[0]), before.members[-1]
            arcs = [arc for arc in _dots_in(each) if n.is_call(first, _ARCS_OF[arc.function]) and _is_of(first, each)]
            meant: dict[int, n.Node] = {id(arc): replace(arc, arguments=(last,)) for arc in arcs}
            members = (n.substitute_each(member, meant) for member in each.members)
            each = replace(each, members=tuple(members)) if meant else each
        found.append(each)
    return found


def _is_of(cosine: n.Call, chain: n.Chain) -> bool:
    """Whether a cosine is that of the name that a chain begins with."""
    key = bare_key(chain.members[0])
    return key is not None and [bare_key(each) for each in cosine.arguments] == [key]


def _dots_in(chain: n.Chain) -> list[n.Call]:
    """Return the arc functions of a chain whose argument is a dot."""
    calls = (below for member in chain.members for below in n.walk(member) if n.is_call(below, *_ARCS_OF))
    return [each for each in calls if len(each.arguments) == 1 and isinstance(bare(each.arguments[0]), n.Dots)]


def _is_solution(statement: n.Statement | None) -> TypeGuard[n.Chain]:
    """Whether a chain says by a formula what a name is."""
    is_equation = isinstance(statement, n.Chain) and statement.relations == ("=",)
    return is_equation and isinstance(statement.members[0], n.Name) and _has_letters(statement.members[1])  # type: ignore[union-attr]


def _is_formula(statement: n.Statement) -> TypeGuard[n.Chain]:
    """Whether a formula stands alone."""
    return isinstance(statement, n.Chain) and not statement.relations and _has_letters(statement)


def _has_letters(tree: n.Node) -> bool:
    return any(isinstance(below, n.Name) for below in n.walk(tree))


def _is_transform(node: n.Node) -> bool:
    """Whether a node is a transform by its two indices: {}^1_2R, T_2^1."""
    above_and_below = isinstance(node, n.Name) and (node.pre_sup or node.sup) and (node.pre_sub or node.sub)
    return bool(above_and_below) and node.base in "RTAH"  # type: ignore[attr-defined]


def asked(statement: n.Statement) -> n.Statement:
    """What is asked for, by an = with a mark above it, is a condition beside an arrow."""
    if not isinstance(statement, n.Chain):
        return statement
    return replace(statement, relations=tuple("=" if r == ASKED else r for r in statement.relations))


def of_all_joints(chain: n.Statement) -> n.Statement:
    """Return a chain with J for J(q), J(θ_1, θ_2): what every Jacobian is a function of tells none from another."""
    if not isinstance(chain, n.Chain) or "J" not in n.letters(chain):
        return chain
    applied = {id(below): below.arguments[0] for m in chain.members for below in n.walk(m) if _is_of_all_joints(below)}
    return replace(chain, members=tuple(n.substitute_each(m, applied) for m in chain.members)) if applied else chain


def with_bare_letters(chain: n.Statement) -> n.Statement:
    """Return a chain with a_{11} for a_{11}(q) in a matrix of letters alone, where p_1(q) is no point either."""
    matrices = map(bare, chain.members) if isinstance(chain, n.Chain) else ()
    cells = [each for m in matrices if isinstance(m, n.Matrix) and all(map(_is_letter, m.cells)) for each in m.cells]
    applied = {id(each): each.arguments[0] for each in map(bare, cells) if isinstance(each, n.Call)}
    if not isinstance(chain, n.Chain) or not applied:
        return chain
    return replace(chain, members=tuple(n.substitute_each(m, applied) for m in chain.members))


def _is_of_all_joints(node: n.Node) -> TypeGuard[n.Call]:
    if not n.is_call(node, "name"):
        return False
    name, *arguments = (each if isinstance(each, n.Name) else n.Name("") for each in node.arguments)
    joints = [each for each in arguments if each.base in ("q", "theta") and each.sub.isdigit() and not each.dots]
    is_whole = len(arguments) == 1 and arguments[0].key in WHOLE_VECTORS
    return name.base == "J" and (is_whole or (len(joints) == len(arguments) > 1))


def without_its_letters(chain: n.Statement) -> n.Statement:
    """Return 𝐱 = (x, y) = … without the vector, which is called by the letter of its first coordinate and so no other value of that."""
    if not isinstance(chain, n.Chain) or len(chain.members) < 3 or set(chain.relations) != {"="}:
        return chain
    vector, letters = map(bare, chain.members[:2])
    is_vector = isinstance(vector, n.Name) and vector.text.startswith(VECTORS) and isinstance(letters, n.Matrix)
    if not is_vector or not all(map(_is_letter, letters.cells)) or vector not in map(bare, letters.cells):  # type: ignore[attr-defined]
        return chain
    return replace(chain, members=chain.members[1:], relations=chain.relations[1:])


def _is_letter(node: n.Node) -> bool:
    """Whether a cell of a matrix is a number, a letter, or one that is applied to the vector of all joints."""
    node = bare(node)
    if isinstance(node, n.Call) and node.function == "name" and len(node.arguments) == 2:
        return bare_key(node.arguments[1]) in WHOLE_VECTORS
    return isinstance(node, n.Number | n.Name)


def _without_for_all(statements: list[n.Statement], names: Names) -> list[n.Statement]:
    """Leave out "for all θ_1, θ_2", which every equation says without it but that of a rank: alone it is the generic one."""
    has_rank = any(n.is_rank(below) for each in statements if isinstance(each, n.Chain) for below in n.walk(each))
    kept: list[n.Statement] = []
    index = 0
    while index < len(statements):
        after = index + 1
        statement = statements[index]
        if is_range_of_arc(statement, kept[-1] if kept else None):
            index = after
            continue
        if len(statements) > 1 and _is_whole_number(statement, names):
            if kept and isinstance(quantifier := kept[-1], n.Connective) and quantifier.text in ("exists", "forall"):
                kept.pop()
            index = after
            continue
        is_for_all = isinstance(statement, n.Connective) and statement.text.strip(" .,;:").lower() in FOR_ALL
        if is_for_all and not has_rank:
            while after < len(statements) and _is_any_configuration(statements[after], names):
                after += 1
        if after == index + 1:
            kept.append(statement)
        index = after
    return kept


def _is_whole_number(statement: n.Statement, names: Names) -> bool:
    """k ∈ ℤ: so it is read in θ = kπ without being said."""
    if not isinstance(statement, n.Chain) or statement.relations != ("∈",):
        return False
    k, numbers = (member.key if isinstance(member, n.Name) else "" for member in statement.members)
    return k in ("k", "n", "m") and numbers in WHOLE and names.known_symbol(k) is None


def _is_any_configuration(statement: n.Statement, names: Names) -> bool:
    node = statement.members[0] if isinstance(statement, n.Chain) and not statement.relations else None
    if names.arm is None or not isinstance(node, n.Name):
        return False
    return node.key in ("q", "theta") or names.known_symbol(node.key) in names.joints


def _without_vanishing_end(statement: n.Statement) -> list[n.Statement]:
    """det J = l_1 l_2 s_2 = 0 is an equation and a condition, and so is a derivative that is to vanish."""
    if not isinstance(statement, n.Chain) or len(statement.members) < 3 or set(statement.relations) != {"="}:
        return [statement]
    *first, last = statement.members
    if (
        not isinstance(last, n.Number)
        or last.value != 0
        or any(isinstance(member, n.Number | n.Matrix) for member in first)
    ):
        return [statement]
    determinant = isinstance(first[0], n.Call) and first[0].function in ("det", "abs")
    if not determinant and not isinstance(first[0], n.Derivative):
        return [statement]
    claim = replace(statement, members=tuple(first), relations=statement.relations[:-1])
    return [claim, replace(statement, members=(first[0], last), relations=("=",))]
