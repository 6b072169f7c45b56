"""The arm of a document's link matrices: an exact fit of a DH link, with one joint variable, to each of them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import permutations

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Display, Document
from armproof.verification.equations.misreadings import ELEMENTARY
from armproof.verification.equations.readings import side_by_side
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.angles import angle_as_scalar
from armproof.verification.tables.arms.candidate import Candidate, entry_text, renamed, symbol_of
from armproof.verification.tables.arms.letters import equations_of, unapplied, value_in_letters
from armproof.verification.tables.arms.mends import mended
from armproof.verification.tables.arms.moves import Moves
from armproof.verification.tables.arms.other_links import Row, frames_of, rows_about, turned_about
from armproof.verification.tables.arms.poses import moves_with_pose
from armproof.verification.tables.arms.rotations import as_transforms, without_lengths
from armproof.verification.tables.arms.rows import joint_of
from armproof.verification.tables.columns import CONVENTIONS
from armproof.verification.tables.row import PARAMETERS, equal, right_row

_TRANSFORMS = "TAHM"
_JOINTS = regex(r"(?:theta|q|phi)_?\w*")  # names of angles that move
_SLIDES = regex(r"[dqr]_\d+")
_WRITTEN = regex(r"matri|array|R|T|𝑅|𝑇")  # a matrix, or Rot and Trans in one of their spellings
SECONDS = 0.5  # for all link matrices of a document


Place = tuple[int | None, int]
_Row = tuple[dict[str, Scalar], str]  # a, alpha, d, theta, and the joint variable among them


Links = dict[int, Matrix]


@dataclass(frozen=True)
class _Link:
    """The printed matrix of a link, counted from 1, its name and letters, its display, and whether a product shows it.

    Its index is 0 where its name is that of no link; it is misnamed where its place among the others tells the index.
    """

    index: int
    value: Matrix
    name: n.Name
    letters: tuple[n.Name, ...]
    display: Display
    in_product: bool
    misnamed: bool = False

    @property
    def place(self) -> Place:
        """The place of its display."""
        return self.display.place

    @property
    def is_constant(self) -> bool:
        """Whether it is one of numbers alone: a link in which nothing moves, or an example."""
        return all(cell.as_fraction() is not None for cell in self.value.cells)

    @property
    def is_spelt_as_pose(self) -> bool:
        """Whether its name is usually that of a pose in the base: T_2."""
        return self.name.base == "T" and not (self.name.pre_sup or self.name.pre_sub or self.name.sup)


def first_links(document: Document, names: Names) -> list[tuple[Display, Links]]:
    """Return the displays of first link matrices, each with the links from there to the next one; where there are several arms, several."""
    algebra = ExactAlgebra(Ring(), None)
    found: list[tuple[Display, Links]] = []
    with algebra.budget.of(SECONDS):
        for link in _links(document, names, algebra):
            if link.index == 1 and not link.is_constant:
                found.append((link.display, {}))
            if found and link.index and not link.is_constant:
                found[-1][1].setdefault(link.index, link.value)
    return found


def links_before_first(document: Document, names: Names) -> tuple[Display, Links] | None:
    """Return the link matrices of a chain that stand before its first one, or before that of another chain, with the display where they begin."""
    algebra, found = ExactAlgebra(Ring(), None), dict[int, _Link]()
    with algebra.budget.of(SECONDS):
        for link in _links(document, names, algebra):
            if link.index == 1 and not link.is_constant:
                break
            if link.index and not link.is_constant:
                found.setdefault(link.index, link)
    first = next(iter(found.values()), None)
    return (first.display, {index: link.value for index, link in found.items()}) if first is not None else None


def are_of_other_chain(links: Links, others: Links) -> bool:
    """Whether a link matrix among some is another than that of its number among others."""
    return any(index in others and not equal(others[index], link) for index, link in links.items())


def are_among(links: Links, others: Links) -> bool:
    """Whether all of some links are among others: a section that prints them again is about the same arm."""
    return all(index in others and equal(others[index], link) for index, link in links.items())


def candidates_of_matrices(document: Document, names: Names) -> list[Candidate]:
    """Return the arm of a document's link matrices, or those that it may be where one of them has a wrong entry.

    Raises EvaluationError where one fits no link, and none with another entry.
    """
    links: dict[int, _Link] = {}
    fixed: dict[int, _Link] = {}
    again: set[int] = set()  # given twice, of which one is the matrix of no link
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        for link in _by_place(_without_poses([*_links(document, names, algebra)]), document, names):
            if not link.is_constant and not equal(links.setdefault(link.index, link).value, link.value):
                links[link.index] = _one_that_is_a_link(links[link.index], link)
                again.add(link.index)
            if link.is_constant and not link.is_spelt_as_pose and link.index not in links:
                fixed.setdefault(link.index, link)
        if len(links) < 2:
            return []
        links = {**{index: fixed[index] for index in _between(links, fixed)}, **links}
        chain = [links[index] for index in sorted(links)]
        first = chain[0].index
        if [link.index for link in chain] != list(range(first, first + len(chain))):
            return []
        found = [each if each.frames else _by_own_index(each, chain, document) for each in _fit(chain)]
        doubtful = frozenset(index - first + 1 for index in again)
        found = [replace(each, mended=each.mended | doubtful) for each in found]
        return [each for each in found if each.first == first - 1 or "" in each.joints]


def _one_that_is_a_link(one: _Link, other: _Link) -> _Link:
    """Return that of two matrices of a link which is one of DH where the other is none; raises EvaluationError."""
    fits = [each for each in (one, other) if _is_link(each)]
    if len(fits) != 1:
        raise EvaluationError(say(Kind.LINK_AGAIN, number=other.index, line=other.display.line))
    return fits[0]


def candidate_of_rotations(document: Document, names: Names) -> list[Candidate]:
    """Return the wrist of which a document prints the rotations alone, {}^3R_4, {}^4R_5: links without lengths; nothing where one is no link of its joint."""
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        links: dict[int, _Link] = {}
        for link in _links(document, names, algebra, rotations=True):
            if link.index and not equal(links.setdefault(link.index, link).value, link.value):
                return []
        chain = [links[index] for index in sorted(links)]
        if len(chain) < 2 or [link.index for link in chain] != list(range(chain[0].index, chain[-1].index + 1)):
            return []
        fitted = ([_row_or_none(link, convention) for link in chain] for convention in CONVENTIONS)
        rows = next(((k, each) for k, each in enumerate(fitted) if None not in each), None)
        found = _candidate(chain, CONVENTIONS[rows[0]], rows[1]) if rows is not None else None
        is_wrist = found is not None and found.indices == tuple(link.index for link in chain)
        return [found] if found is not None and is_wrist else []


def poses_that_are_links(document: Document, names: Names) -> dict[str, dict[str, str]]:
    """Return the names that are usually poses, T_2, where the matrices that a document prints for them are those of links."""
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        found = [each for each in _links(document, names, algebra) if each.is_spelt_as_pose and each.index]
        behind = [each for each in found if each.index > 1]
        turns = [len(_angles_of(each)) < 2 for each in behind]
        slips = len(behind) // 3  # a slip in one of three
        if not behind or sum(turns) < len(turns) - slips or 2 * sum(map(_is_link, behind)) < len(behind):
            return {}
    return {each.name.key: {"pose": str(each.index), "in": str(each.index - 1)} for each in found}


def _by_own_index(found: Candidate, chain: Sequence[_Link], document: Document) -> Candidate:
    """Return an arm with the joint that one matrix alone names by another number, where the document writes its own: θ_1, d_1, d_3."""
    parted = [joint.rpartition("_") for joint in found.joints]
    strange = [place for place, (letter, _, digit) in enumerate(parted) if letter and digit != str(chain[place].index)]
    if len(strange) != 1 or len(chain) < 2 or found.mended:
        return found
    [place] = strange
    own = f"{parted[place][0]}_{chain[place].index}"
    if own in found.joints or not parted[place][2].isdigit() or not document.writes(own, chain[place].place):
        return found
    row = {name: re.sub(rf"\b{found.joints[place]}\b", own, entry) for name, entry in found.rows[place].items()}
    (cell, line), *more = (link.place for link in chain if link is not chain[place])
    return replace(
        found,
        line=line,
        cell=cell,
        rows=(*found.rows[:place], row, *found.rows[place + 1 :]),
        joints=(*found.joints[:place], own, *found.joints[place + 1 :]),
        more_lines=tuple(more),
        mended=frozenset({place + 1}),
    )


def _between(links: Mapping[int, _Link], fixed: Mapping[int, _Link]) -> Iterator[int]:
    """Yield the links in which nothing moves, between those that move and the one behind them."""
    yield from (index for index in range(min(links), max(links) + 2) if index in fixed and index not in links)


def _without_poses(links: list[_Link]) -> list[_Link]:
    """Return the links without T_6, the pose of the last one, where another letter is theirs: A_1, …, A_6."""
    own = {link.index for link in links if link.index and not link.is_spelt_as_pose}
    return [link for link in links if not (link.is_spelt_as_pose and link.index in own)]


def _by_place(links: list[_Link], document: Document, names: Names) -> list[_Link]:
    """Return the links, the one whose name is of none or of another where it stands between its neighbours: {}^1T_1 behind {}^0T_1."""
    found = [link for link in links if link.index]
    count = Counter(link.index for link in found if not link.is_constant)
    loose = [link for link in links if not link.is_constant and count[link.index] != 1]
    again = {
        link.index
        for link in loose
        for other in loose
        if link.index == other.index and not equal(link.value, other.value)
    }
    loose = [link for link in loose if _is_link(link) and (not link.index or link.index in again)]
    if not loose or not count:
        return found
    spoken = _frames_of(document, names)
    places = []
    for link in loose:
        frames = {0, *(spoken - Counter(_digits(link.name)))}  # as the others name them
        missing = [k for k in range(1, max(frames | count.keys()) + 1) if not count[k] and {k - 1, k} <= frames]
        places += [(link, k) for k in missing if len(missing) == 1 and _is_in_place(link, k, links)]
    if len(places) != 1:
        return found
    [(wrong, index)] = places
    own = (replace(link, index=index, misnamed=True) if link is wrong else link for link in links)
    return [link for link in own if link.index]


def _is_link(link: _Link) -> bool:
    """Whether a matrix is that of a DH link with one joint variable, whatever its number."""
    return any((row := _row_or_none(link, convention)) is not None and row[1] for convention in CONVENTIONS)


def _frames_of(document: Document, names: Names) -> Counter[int]:
    """Return the frames that the transforms in the equations of a document name, and how often."""
    chains = (chain for display in document.displays for chain in equations_of(display, names))
    nodes = (node for chain in chains for member in chain.members for node in n.walk(member))
    return Counter(k for node in nodes for k in _digits(node))


def _is_in_place(link: _Link, index: int, links: Sequence[_Link]) -> bool:
    """Whether a matrix stands where that of a link is looked for, under a name that one digit tells from its own."""
    at = next(place for place, each in enumerate(links) if each is link)
    before = [place for place, each in enumerate(links) if each.index == index - 1 > 0]
    behind = [place for place, each in enumerate(links) if each.index == index + 1 and each is not link]
    if not (all(place < at for place in before) and all(at < place for place in behind)):
        return False
    digits = _digits(link.name)
    own = ((index,),) if len(digits) == 1 else ((index - 1, index), (index, index - 1))
    return any(sum(one != other for one, other in zip(digits, each, strict=True)) == 1 for each in own)


def _links(document: Document, names: Names, algebra: ExactAlgebra, *, rotations: bool = False) -> Iterator[_Link]:
    """Yield the matrices of links; or of `rotations`, as those of links without lengths."""
    for display in document.displays:
        if _WRITTEN.search(display.latex):
            for chain in equations_of(display, names):
                for part in side_by_side(chain) or (chain,):
                    yield from _link_of(as_transforms(part) if rotations else part, names, algebra, display, rotations)


def _link_of(
    chain: n.Chain, names: Names, algebra: ExactAlgebra, display: Display, is_rotation: bool
) -> Iterator[_Link]:
    for name, printed, in_product in _printed(chain):
        index, evaluated = _index(name) or 0, value_in_letters(printed, names, algebra)
        value = evaluated[0] if evaluated is not None else None
        if evaluated is None or not isinstance(value, Matrix) or value.shape != ((3, 3) if is_rotation else (4, 4)):
            continue
        if isinstance(name, n.Name):
            whole = without_lengths(value) if is_rotation else value
            yield _Link(index, whole, name, evaluated[1], display, in_product)


def _printed(chain: n.Chain) -> Iterator[tuple[n.Node, n.Node, bool]]:
    """Yield names with what is printed for them: A_1 = […], R_z(θ_1) Trans(0, 0, d_1) or […] […]; T_0^1 T_1^2 = […] […]."""
    members = [unapplied(member) for member in chain.members]
    named = [member for member in members if _index(member) is not None or (len(members) == 2 and _digits(member))]
    written = [member for member in members if _is_written(member)]
    if written and len({_index(name) for name in named}) == 1:
        yield named[0], min(written, key=lambda one: (not isinstance(one, n.Matrix), _has_primes(one))), False
    products = [tuple(map(unapplied, member.factors)) for member in members if isinstance(member, n.Product)]
    for names, values in permutations(products, 2):
        are_named = all(_digits(name) or not isinstance(name, n.Name) for name in names)  # V T1 is the one name VT1
        if are_named and len(names) == len(values) and all(isinstance(value, n.Matrix) for value in values):
            yield from ((name, value, True) for name, value in zip(names, values, strict=True))


def _has_primes(node: n.Node) -> bool:
    """Whether a name with a prime stands in a matrix: A_2 = [cos θ' …] = [s_2 …], where θ' is another in each link."""
    return any(isinstance(below, n.Name) and below.primes for below in n.walk(node))


def _is_written(node: n.Node) -> bool:
    """Whether a matrix, or an elementary one, or a product of such is written out, and no other name stands for it."""
    factors = map(bare, node.factors) if isinstance(node, n.Product) else (node,)
    return all(isinstance(f, n.Matrix) or n.is_call(f, *ELEMENTARY) for f in factors)


def _index(node: n.Node) -> int | None:
    """Return i of a name of {}^{i-1}T_i, T^{i-1}_i, T_{i-1,i} or A_i."""
    digits = _digits(node)
    if len(digits) == 1:
        return digits[0]
    return digits[1] if len(digits) == 2 and digits[1] == digits[0] + 1 else None


def _digits(node: n.Node) -> tuple[int, ...]:
    """Return the one or two digits in the scripts of a transform's name, outwards where it does not say which is the reference."""
    if not isinstance(node, n.Name) or node.base not in _TRANSFORMS or node.primes or node.dots:
        return ()
    scripts = [part for part in (node.pre_sup, node.pre_sub, node.sup, node.sub) if part]
    digits = [int(digit) for part in scripts for digit in re.findall(r"\d", part) if re.fullmatch(r"\d(?:,?\d)?", part)]
    if len(digits) == 1 and len(scripts) > 1:
        return ()
    is_outward = not (node.pre_sup or node.pre_sub) and len(scripts) == 2
    return tuple(sorted(digits) if is_outward else digits) if len(digits) < 3 else ()


def _fit(chain: list[_Link]) -> list[Candidate]:
    """Return the links as rows of the first convention that fits them all, else of those that fit all but one with a wrong entry.

    Raises EvaluationError for the link that fits none.
    """
    fitted = {convention: [_row_or_none(link, convention) for link in chain] for convention in CONVENTIONS}
    for convention, rows in fitted.items():
        if None not in rows:
            return [_candidate(chain, convention, rows)]
    found = [each for convention, rows in fitted.items() for each in _with_mended(chain, convention, rows)]
    found = found or [*_about_axes(chain)]
    if not found:
        rows = max(fitted.values(), key=lambda rows: rows.index(None))  # the first of the best
        raise EvaluationError(say(Kind.NO_DH_LINK, line=chain[rows.index(None)].display.line))
    return found


def _about_axes(chain: list[_Link]) -> Iterator[Candidate]:
    """Yield the links as rows of the classic convention where some turn about another axis, or beside a point that no row reaches."""
    links: list[tuple[int, list[Row]]] = []
    joints: list[str] = []
    for link in chain:
        if (row := _row_or_none(link, "classic")) is not None:
            links.append((link.index, [_entries(row)]))
            joints.append(symbol_of(row[1]))
            continue
        angles = _angles_of(link)
        moving = [name for name in angles if _JOINTS.fullmatch(name)]
        if (about := turned_about(link.value, moving)) is None:
            if (made := _moved(link, moving)) is None:
                return
            links.append((link.index, made.rows))
            joints += made.joints
            continue
        axis, found = about
        ring = link.value.rows[0][0].ring
        theta = angle_as_scalar(ring, found.theta, [ring.symbol(name) for name in angles])
        if theta is None or len(own := symbols_in([theta]) & {*moving}) != 1:
            return
        rows = rows_about(axis, theta, [line[3] for line in link.value.rows[:3]])
        [joint] = own
        links.append((link.index, rows))
        joints += (symbol_of(joint) if joint in row["theta"] else "" for row in rows)
    lines = tuple(link.place for link in chain)
    yield Candidate(
        "matrices", lines[0][1], lines[0][0], tuple(row for _, rows in links for row in rows), tuple(joints),
        renamed(letter for link in chain for letter in link.letters), ("classic",), lines, frames=frames_of(links),
        products=tuple(link.place for link in chain if link.in_product),
    )  # fmt: skip


def _moved(link: _Link, turning: Sequence[str]) -> Moves | None:
    """Return the rows of a link whose joint turns or slides along an axis of the frame before it, and stands anywhere: Rot(z, θ) Trans(y, a)."""
    ring = link.value.rows[0][0].ring
    joints = turning or [name for name in sorted(symbols_in(link.value.cells)) if _SLIDES.fullmatch(name)]
    try:
        return moves_with_pose(link.value, joints, ExactAlgebra(ring, None)) if len(joints) == 1 else None
    except (EvaluationError, LookupError):
        return None


def _with_mended(chain: list[_Link], convention: str, rows: Sequence[_Row | None]) -> Iterator[Candidate]:
    """Yield the links where one alone fits no row, with each row that it fits with another entry."""
    if sum(row is None for row in rows) != 1:
        return
    place = rows.index(None)
    link, met = chain[place], set[str]()
    for value in mended(link.value, _angles_of(link)):
        row = _row_or_none(replace(link, value=value), convention)
        if row is None or not row[1] or (text := str(_entries(row))) in met or _runs_backwards(row):
            continue
        met.add(text)
        yield _candidate(chain, convention, [*rows[:place], row, *rows[place + 1 :]], place)


def _runs_backwards(row: _Row) -> bool:
    """Whether a joint turns by -θ."""
    return _entries(row)["theta"].startswith("-")


def _entries(row: _Row) -> dict[str, str]:
    return {name: entry_text(value) for name, value in row[0].items()}


def _candidate(chain: list[_Link], convention: str, rows: Sequence[_Row | None], slip: int | None = None) -> Candidate:
    """Return links as the rows of a table; one with a slip in its matrix is no source of it."""
    letters = [letter for link in chain for letter in link.letters]
    wrong = {place for place, link in enumerate(chain) if place == slip or link.misnamed}
    lines = tuple(link.place for place, link in enumerate(chain) if place not in wrong)
    quantities = {
        link.name.key: {"pose": str(link.index), "in": str(link.index - 1)}
        for link in chain
        if link.is_spelt_as_pose and not link.misnamed
    }
    entries = tuple(_entries(row) for row in rows if row is not None)
    joints = tuple(symbol_of(row[1]) for row in rows if row is not None)
    return Candidate(
        "matrices", lines[0][1], lines[0][0], entries, joints, renamed(letters), (convention,), lines,
        quantities=quantities, products=tuple(link.place for link in chain if link.in_product),
        mended=frozenset(place + 1 for place in wrong),
    )  # fmt: skip


def _row_or_none(link: _Link, convention: str) -> _Row | None:
    """Return the row of a link with its joint variable, or None."""
    try:
        return _row(link, convention)
    except EvaluationError:
        return None


def _row(link: _Link, convention: str) -> _Row:
    ring = link.value.rows[0][0].ring
    angles = _angles_of(link)
    found = right_row(link.value, convention, [name for name in angles if _JOINTS.fullmatch(name)])
    if found is None:
        raise EvaluationError(say(Kind.NO_DH_LINK, line=link.display.line))
    bases = [ring.symbol(name) for name in angles]
    theta, alpha = (angle_as_scalar(ring, angle, bases) for angle in (found.theta, found.alpha))
    if theta is None or alpha is None:
        raise EvaluationError(say(Kind.NO_DH_LINK, line=link.display.line))
    values = dict(zip(PARAMETERS, (found.a, alpha, found.d, theta), strict=True))
    _, joint = joint_of(values, link.index)
    return values, joint


def _angles_of(link: _Link) -> list[str]:
    return sorted({name for cell in link.value.cells for name in _angles_in(cell)})


def _angles_in(cell: Scalar) -> Iterator[str]:
    terms = [*cell.ring.terms(cell.numerator), *cell.ring.terms(cell.denominator)]
    return (name for powers, _ in terms for kind, name in powers if kind in ("cos", "sin"))
