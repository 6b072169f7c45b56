"""What the text between displays says of those that follow: values, conditions, bounds, and what letters are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import pi

from armproof.verification.algebra.calculus import is_rate, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.holding_there import holds_where
from armproof.verification.document.heading import sections_around
from armproof.verification.document.joint_values import in_letters, is_joint_value
from armproof.verification.document.moving_on import MOVED_BEHIND, OF_MOTION, RESIZED
from armproof.verification.document.postures import STRETCHED, THERE, bent_as, kind_of_joints
from armproof.verification.document.sentences import FROM_VALUES, GENERAL, NOT_THERE, values_of
from armproof.verification.document.told_singularities import SINGULAR_TOO, TOLD_SINGULAR
from armproof.verification.equations.case_conditions import comparisons_of
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.definitions import angle_of_tangent, squared_name
from armproof.verification.equations.forces import heed_forces, is_force_of_numbers
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.equations.under_rates import UnderRates
from armproof.verification.errors import ReadError
from armproof.verification.evaluation.blocks import cells_of, rows_of_letters
from armproof.verification.findings import Kind, say
from armproof.verification.latex import greek
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.state import Stated, Told
from armproof.verification.patterns import regex

POSTURE = r"\text{posture}"  # one that the text names, and nobody can tell
_NEARLY = regex(r"[≈≃∼]|\\(?:approx|simeq|sim|to|rightarrow)(?![A-Za-z])")
_ANGLES = (*greek.ANGLES, *greek.VARIANTS, "delta", "epsilon")
_MATRICES = ("rotation", "pose")  # which a number that the text tells cannot be
_CLOSE = 1e-9
_HELD = regex(r"\s*(?:\\\{(?P<set>(?:(?!\\[{}]).)*=(?:(?!\\[{}]).)*)\\\}|\((?P<list>[^()]*=[^()]*)\))\s*")


@dataclass
class _Heard:
    """What a text says: the names that it equates, what it gives, and whether it names a posture in words."""

    names: set[str] = field(default_factory=set)
    conditions: list[n.Chain] = field(default_factory=list)
    velocities: list[n.Chain] = field(default_factory=list)
    bounds: list[n.Chain] = field(default_factory=list)
    in_words: bool = False
    kind: str = ""


class Heeding:
    """Takes what the text says into the document's state."""

    def __init__(self, checker: ChainChecker, given: GivenValues) -> None:
        self.checker = checker
        self.given = given
        self.names = checker.names

    def heed_words(self) -> None:
        """A text leads from the values given before to no more than its display, unless a heading gives them to all below it."""
        told = self.names.state.told
        self.names.state.told = replace(told, is_direct=told.is_direct and bool(values_of(told.section)))

    def heed(self, said: Sequence[str], above: int, outside: int, line: int) -> None:
        """The text before a display gives values or a condition: the configuration stated before it is over, perhaps.

        What stands `above` the last heading ends a configuration as well; below it holds what it says of lengths, unless
        it stands `outside`, in a section that is not around that of the display.
        """
        state = self.names.state
        self.heed_words()
        for is_outside, texts in ((True, said[:outside]), (False, said[outside:above])):
            if texts:
                before, around = state.told, sections_around(state.section)
                self._heed(texts, line)
                case = next((each for each in around if values_of(each) == _equations(texts)), None)
                told = before if is_outside else replace(state.told, section=case or next(iter(around), ""))
                told = _of_all_below(told) if case and not is_outside else told
                state.told = told if told.holds_below else Told()
        if below := said[above:]:
            values = values_of(state.section)
            if values:
                self._heed_below(values, below, line)
            else:
                self._heed(below, line)

    def _heed_below(self, values: tuple[str, ...], said: Sequence[str], line: int) -> None:
        """Take what a text says under a heading that gives values: a posture in words may say no more than these, "Here the arm is stretched."."""
        state, equations = self.names.state, _equations(said)
        postures = [each for each in said if _is_posture(each) and _words(each) not in state.section]
        if not (set(equations) <= {*values} and state.told.section == state.section and state.told.conditions):
            self._heed([each for each in said if each in values or not _is_posture(each)], line)
        told = _of_all_below(state.told) if values == equations[: len(values)] else state.told
        fits = all(THERE not in each or self.fits(told, bent_as(each)) for each in postures)
        state.told = replace(
            told,
            line=line,
            is_direct=told.is_direct and fits and {NOT_THERE, *OF_MOTION}.isdisjoint(said),
            in_words=told.in_words or bool(postures),
            begins_there=told.begins_there or any(THERE in each for each in postures),
            bent=_bent_as(postures) or told.bent,
        )

    def fits(self, told: Told, bent: str) -> bool:
        """Whether all joints that have values are bent so: stretched at 0, folded where one is half a turn."""
        given = [self.given.values_of(each) or {} for each in told.conditions]
        numbers = [
            self.given.number(node) for each in given for name, node in each.items() if name in self.given.joints
        ]
        angles = [abs(each) for each in numbers if each is not None]
        if not bent or not angles or len(angles) < len(numbers):
            return False
        return max(angles) < _CLOSE if bent == STRETCHED else any(abs(each - pi) < _CLOSE for each in angles)

    def _heed(self, said: Iterable[str], line: int) -> None:
        said = tuple(each for each in said if each != NOT_THERE)
        if not said:
            self.names.state.told = replace(self.names.state.told, is_direct=False)
            return
        heard = _Heard()
        for latex in self.in_letters(said):
            if latex in (*TOLD_SINGULAR, FROM_VALUES):
                continue
            if latex == GENERAL:
                self._end_configuration(line)
            elif latex in OF_MOTION:
                self._move_on(latex, heard)
            elif latex.startswith("\\text{") and (of_joints := kind_of_joints(latex)):
                heard.kind = of_joints
            else:
                self._hear(latex, heard, line)
        if MOVED_BEHIND in said and any(map(self.moves, heard.conditions)):
            heard.conditions, heard.in_words = [], True
        if self._stands_already(heard) or said[-1] == SINGULAR_TOO:  # the formulas before it are other places
            heard.conditions = []
        else:
            self._begin(heard.names, heard.conditions, heard.in_words, line)
        before = self.names.state.told
        singular = said[-1] if said[-1] in TOLD_SINGULAR else ""
        self.names.state.told = replace(
            before,
            singular=singular,
            begins_there=any(THERE in latex for latex in said),
            velocities=tuple(heard.velocities) or before.velocities,
            bounds=tuple(heard.bounds) or before.bounds,
            kind=heard.kind or before.kind,
            bent=_bent_as([each for each in said if _is_posture(each)]),
            is_direct=bool(heard.conditions) and FROM_VALUES in said and not any(map(_NEARLY.search, said)),
            line=line if heard.velocities or singular else before.line,
        )
        told = self._values(heard.conditions)
        self.names.state.given_last |= told
        self.names.state.told_lengths |= {name: told[name] for name in told if name in self.given.lengths}

    def _stands_already(self, heard: _Heard) -> bool:
        """Whether a text only says again what follows from the values that stand: "so that $c_3 = 0$"."""
        standing = self.names.state.told.standing
        given = self._values(standing)
        if not heard.conditions or heard.in_words or not given:
            return False
        told = self._values(heard.conditions).keys() & {*self.given.joints}
        if told and not given.keys() & {*self.given.joints} <= told:  # "For θ_1 = 30°": nobody knows what θ_2 is now
            return False
        return all(self._follows(each, standing, given) for each in heard.conditions)

    def _follows(self, condition: n.Chain, standing: Sequence[n.Chain], given: Mapping[str, Stated]) -> bool:
        if not (values := self._values([condition])):
            keys = {self.names.known_symbol(below.key) or below.key for below in n.names(condition)}
            keys |= {
                self.names.joint_angle(index) or ""
                for b in n.walk(condition)
                if isinstance(b, n.JointAngles)
                for _, index in b.terms
            }
            return keys <= given.keys() and holds_where(self.checker, standing, condition)
        return all(key in given and abs(given[key].value - each.value) < _CLOSE for key, each in values.items())

    def _move_on(self, said: str, heard: _Heard) -> None:
        """The arm has moved, or grown: values given before are no longer its own, and numbers behind are of a posture that nobody can tell."""
        state = self.names.state
        has_lengths = said == RESIZED and bool(state.told_lengths)
        if not (state.configuration or state.given_last or state.told.standing or has_lengths):
            return
        heard.in_words = True
        state.given_last = {}
        if said == RESIZED:
            state.told_lengths = {}
            state.configuration = {
                key: each for key, each in state.configuration.items() if key not in self.given.lengths
            }

    def _hear(self, latex: str, heard: _Heard, line: int) -> None:
        """Take an equation, a bound or a posture: what is none of the first two is one in words."""
        try:
            found = [each for each in self.names.reader.read(unbraced(latex)) if isinstance(each, n.Chain)]
            chains = [chain for chain in found if not self.given.repeats(chain)]
            self._hear_bounds([chain for chain in chains if _is_bound(chain)], heard)
            chains = [chain for chain in chains if not _is_bound(chain)]
            if found and not chains:
                return
        except ReadError:
            heard.names |= {*self.given.joints, *self.given.lengths}
            chains = []
        heard.names |= {name for chain in chains for name in _equated(chain)}
        if (
            self.names.arm is not None
        ):  # without one a letter of the text is any: it says where things hold, and no more
            heard.velocities += filter(UnderRates(self.checker.members, Told()).velocity_in, chains)
            for chain in chains:
                heed_forces(self.names, chain)
                self.checker.zeros.heed(chain, line, True)
                self._define(chain, line, heard.conditions)
        else:
            for chain in filter(self._introduces, chains):
                self._define(chain, line)
        chains = [self._without_letters(chain, line) for chain in chains]
        heard.conditions += [condition for chain in chains for condition in self.conditions_of(chain)]
        heard.in_words = heard.in_words or not chains

    def _hear_bounds(self, bounding: Sequence[n.Chain], heard: _Heard) -> None:
        for bound in bounding:
            self.names.state.compare(bound, self.given.lengths)
        if self.names.arm is not None:
            heard.bounds += (bound for bound in bounding if "≠" not in bound.relations)
            heard.bounds = [each for each in heard.bounds if _opposite(each) not in heard.bounds]  # both branches
        if any(map(self.moves, bounding)):  # where θ_2 ≠ 0, nothing is said of θ_2 = π any more
            heard.names |= {*self.given.joints}
            self.names.state.told = replace(self.names.state.told, conditions=(), earlier=())

    def in_letters(self, said: Iterable[str]) -> Iterator[str]:
        """Yield what a text says, the values of joints in words in the arm's letters; those of an arm that is not known as a posture."""
        joints = [] if self.names.arm is None else [key_as_latex(each.symbol) for each in self.names.arm.joints]
        for latex in said:
            yield from (in_letters(latex, joints) or [POSTURE]) if is_joint_value(latex) else [latex]

    def told_values(self) -> dict[str, Stated]:
        """Return the values that the text gives: of lengths, wherever above, and of joints, for the display at hand."""
        return self.names.state.told_lengths | self._values(self.names.state.told.standing)

    def _values(self, conditions: Iterable[n.Chain]) -> dict[str, Stated]:
        return self.given.stated(self.given.values_of_all(conditions))

    def heed_behind(self, said: Iterable[str], statements: Iterable[n.Statement], line: int) -> None:
        """The text behind a display says what a letter of it is: "p_x = ρ c_1", where ρ = …."""
        chains = [each for each in statements if isinstance(each, n.Chain)]
        alone = {bare_key(member) for chain in chains for member in chain.members}
        held = {b.key for chain in chains for b in n.names(chain) if self.names.is_open(b.undotted)}
        if not (held := held - alone):
            return
        for latex in said:
            with suppress(ReadError, RecursionError):
                for chain in self.names.reader.read(latex):
                    is_told = isinstance(chain, n.Chain) and bare_key(_of_root(chain).members[0]) in held
                    if isinstance(chain, n.Chain) and is_told and (self.names.arm or self._introduces(chain)):
                        self._define(chain, line)

    def _define(self, chain: n.Chain, line: int, conditions: Sequence[n.Chain] = ()) -> None:
        """x_p = x − l_3 cos α: a letter that has no meaning gets one, until a display gives it another."""
        chain = _of_constant(_of_root(chain))
        name = chain.members[0]
        if isinstance(name, n.Name) and self._is_rate_of_none(chain):
            self.names.define(name.key, self.checker.members.meaning(chain.members[1]), line, in_text=True)
        if chain.relations != ("=",) or not isinstance(name, n.Name) or name.dots:
            return
        if self.names.quantity(name) is not None and rows_of_letters(chain.members[1]):  # T = [s n a P; 0 0 0 1]
            self.checker.check(chain, 1, line)
            return
        if self._says_anew(name, chain.members[1]) and not (
            conditions and holds_where(self.checker, conditions, chain)
        ):
            before = self.names.state.definitions[name.key]
            if not before.in_text:
                self.names.leave_open(name.key, say(Kind.SECOND_MEANING, name=name.text or name.key, line=line))
                return
            del self.names.state.definitions[name.key]
        if not self.names.is_open(name) or self.names.angle_sum(name) is not None:  # θ_{23} is θ_2 + θ_3
            return
        members, value = self.checker.members, chain.members[1]
        usual = self.names.usual(name) if is_usual(name) else ()
        if any(self.names.quantity(each) in usual for each in n.names(value) if each.key != name.key):
            usual = ()  # z = P_z - h: who has another name for the coordinate means something else by this one
        is_speed = n.has_rates(value) and not any(each.scalar for each in usual[:1])  # ω_1 = \dot θ_1 is no vector
        is_name_of_other = isinstance(bare(value), n.Name) and not self._is_joint(bare(value))
        if not is_speed and (is_name_of_other or any(each.kind not in _MATRICES or each.scalar for each in usual)):
            return
        (found,) = self.checker.conventions.bind([members.evaluate(value)])
        told = as_scalar(found.value) if found.known else None
        cells = told.cells if isinstance(told, Matrix) and told.shape[1] == 1 else [told]
        scalars = [cell for cell in cells if isinstance(cell, Scalar)]
        is_usual_yet = bool(usual) and not is_speed and isinstance(told, Matrix)
        tells = bool(symbols_in(scalars)) or _is_worked_out(value) or is_force_of_numbers(name, value)
        if len(scalars) == len(cells) and tells and not is_usual_yet:
            self.names.define(name.key, members.meaning(value), line, node=value, in_text=True)

    def _is_joint(self, node: n.Node) -> bool:
        """Whether a name is that of a joint's variable: α = θ_1 says what α is, and a display that uses it none of its own."""
        return isinstance(node, n.Name) and not node.dots and self.names.known_symbol(node.key) in self.names.joints

    def _is_rate_of_none(self, chain: n.Chain) -> bool:
        r"""Whether the rate of a joint that the arm has not is said to be zero: "There is no joint 3: $\dot\theta_3 = 0$"."""
        name = chain.members[0]
        if (
            chain.relations != ("=",)
            or not isinstance(name, n.Name)
            or name.dots != 1
            or not n.is_nought(chain.members[1:])
        ):
            return False
        is_joint = name.base in ("theta", "q", "d") and name.sub.isdigit() and int(name.sub) > len(self.names.joints)
        return is_joint and name.key not in self.names.state.definitions and self.names.is_open(name.undotted)

    def _introduces(self, chain: n.Chain) -> bool:
        """Whether a text about no arm says what a letter is that stands nowhere above: a formula of what the document defines, or of angles."""
        name = chain.members[0]
        if chain.relations != ("=",) or not isinstance(name, n.Name) or name.key in self.names.used:
            return False
        if not self.names.is_open(name) or name.dots:
            return False
        below = [each for each in n.walk(chain.members[1]) if isinstance(each, n.Name | n.JointAngles | n.Call)]
        defined = self.names.state.definitions
        of_angles = any(isinstance(each, n.JointAngles) or n.is_call(each, "cos", "sin", "tan") for each in below)
        known = any(isinstance(each, n.Name) and each.key in defined for each in below)
        return of_angles or known or self._is_difference(name, chain.members[1])

    def _is_difference(self, name: n.Name, node: n.Node) -> bool:
        """Whether a Greek letter is said to be the sum or the difference of others that stand above, γ = α - β, or of those of its numbers."""
        letters = [*n.names(node)] if isinstance(bare(node), n.Sum) else []
        if len(letters) < 2 or not all(each.base in _ANGLES for each in (name, *letters)):
            return False
        if name.sub:  # θ_{12} = θ_1 + θ_2
            return name.sub == "".join(each.sub for each in letters) and {each.base for each in letters} == {name.base}
        return all(each.key in self.names.used for each in letters)

    def _says_anew(self, name: n.Name, node: n.Node) -> bool:
        """Whether a letter that the document has defined gets another meaning, a formula and no value: "Now let k_1 = l_1 - l_2 c_2"."""
        before = self.names.state.definitions.get(name.key)
        if before is None or before.by_place or before.by_table or isinstance(bare(node), n.Name):
            return False
        consulted = frozenset(self.names.state.consulted)
        values = [as_scalar(self.checker.members.evaluate(each).value) for each in (name, node)]
        self.names.state.consulted.intersection_update(consulted)
        scalars = [each for each in values if isinstance(each, Scalar)]
        return len(scalars) == 2 and bool(symbols_in(scalars[1:])) and not (scalars[0] - scalars[1]).normal().is_zero()

    def _without_letters(self, chain: n.Chain, line: int) -> n.Chain:
        """l_1 = l_2 = l relates lengths, and says what the letter l is; return the chain without it."""
        related = self.given.related(chain) if set(chain.relations) == {"="} else []
        if len(related) < 2 or len(related) == len(chain.members):
            return chain
        for letter in (bare_key(each) for each in chain.members if each not in related):
            meaning = self.checker.members.meaning(related[0])
            self.names.define(str(letter), meaning, line, node=related[0], in_text=True)
        return replace(chain, members=tuple(related), relations=("=",) * (len(related) - 1))

    def of_display(self, chain: n.Chain, *, holds_nowhere: bool = False) -> None:
        """A display that is a condition itself, c_1 = 1, l_1 = l_2, or P_y = 0 of a configuration that is not told, may limit those behind it."""
        if self.names.arm is None:
            return
        conditions = [*self.conditions_of(chain)]
        sides = [as_scalar(self.checker.member(node).value) for node in chain.members if holds_nowhere]
        if not conditions and chain.relations == ("=",) and sides and all(isinstance(each, Scalar) for each in sides):
            conditions = [chain]
        self._begin(set(), conditions, in_words=False)

    def _end_configuration(self, line: int) -> None:
        """ "In general": the configuration stated before is over. What holds there alone is not refuted behind it."""
        state = self.names.state
        ended = {key: state.configuration.pop(key) for key in {*state.configuration} - {*self.given.lengths}}
        given = tuple(value_of(key, each.node) for key, each in ended.items()) or state.told.conditions
        state.told = Told(conditions=given, line=line, section=state.section, is_over=True) if given else Told()
        state.given_last = {key: each for key, each in state.given_last.items() if key in self.given.lengths}

    def _begin(self, names: set[str], conditions: Sequence[n.Chain], in_words: bool, line: int = 0) -> None:
        """Forget what is given anew: a length by its name, a configuration as a whole."""
        state = self.names.state
        held = names | {b.key for each in conditions for b in n.names(each)}
        angles = any(isinstance(below, n.JointAngles) for each in conditions for below in n.walk(each))
        moves = in_words or angles or not held.isdisjoint((*self.given.joints, "q", "theta"))
        over = [key for key in state.configuration if key in names or (moves and key not in self.given.lengths)]
        ended = [(key, value_of(key, state.configuration.pop(key).node)) for key in over]
        if conditions and not in_words and self._are_of_rates(conditions):
            conditions = (*self._standing(conditions), *conditions)
        if conditions or in_words:
            earlier = tuple(value for key, value in ended if key not in names) + self._of_lengths(held)
            state.told = Told(
                tuple(conditions), earlier, in_words, line=line, section=state.section, holds_below=not moves
            )

    def _are_of_rates(self, conditions: Sequence[n.Chain]) -> bool:
        """Whether conditions say how fast joints move, and nothing else: the arm stays where it is."""
        return all(map(is_rate, self.given.values_of_all(conditions) or ("",)))

    def _standing(self, conditions: Sequence[n.Chain]) -> Iterator[n.Chain]:
        """Yield the values that the text gave under the same heading, but those that conditions give anew."""
        told, anew = self.names.state.told, self.given.values_of_all(conditions).keys()
        if told.section == self.names.state.section:
            yield from (each for each in told.standing if anew.isdisjoint(self.given.values_of(each) or {}))

    def _of_lengths(self, held: set[str]) -> tuple[n.Chain, ...]:
        """Return the conditions on lengths that the text gave before under the same heading, and does not give anew."""
        told = self.names.state.told
        if told.section != self.names.state.section:
            return ()
        found = (
            (each, {b.key for b in n.walk(each) if isinstance(b, n.Name)}) for each in (*told.earlier, *told.conditions)
        )
        return tuple(each for each, keys in found if keys.isdisjoint((*held, *self.given.joints, "q", "theta")))

    def conditions_of(self, chain: n.Chain) -> Iterator[n.Chain]:
        """Yield the values that an equation gives, or itself where it is one of joints and lengths that is no identity."""
        if set(chain.relations) - {"=", "≈"} or len(chain.members) < 2:
            return
        if values := self.given.values_of(chain):
            yield from (value_of(name, node) for name, node in values.items())
            return
        members = [self.checker.member(node) for node in chain.members]
        if any(self.checker.quantity_of(below) is not None for node in chain.members for below in n.walk(node)):
            return
        scalars = [value for member in members if isinstance(value := as_scalar(member.value), Scalar)]
        of_arm = {*self.given.joints, *self.given.lengths} if self.names.arm is not None else symbols_in(scalars)
        if len(scalars) < len(members) or of_arm.isdisjoint(symbols_in(scalars)):
            return
        apart = [difference for a, b in pairwise(scalars) if not (difference := a - b).is_zero()]
        if apart and all(symbols_in([difference.normal()]) for difference in apart):  # θ_3 = θ_3 - π/2 holds nowhere
            yield replace(chain, relations=("=",) * len(chain.relations))

    def moves(self, bound: n.Chain) -> bool:
        """Whether a bound is one of the configuration, and not of lengths or of other letters alone."""
        sides = [
            node for comparison in comparisons_of(bound) for node in (comparison[0], comparison[2])
        ] or bound.members
        members = [as_scalar(self.checker.member(node).value) for node in sides]
        return not symbols_in([each for each in members if isinstance(each, Scalar)]).isdisjoint(self.given.joints)


def _equations(said: Sequence[str]) -> tuple[str, ...]:
    """Return what a text says but for postures in words and that it leads to what comes: under a heading with values they say no more than these."""
    return tuple(each for each in said if not (each == FROM_VALUES or _is_posture(each)))


def _is_posture(latex: str) -> bool:
    """Whether what a text says is a posture in words."""
    is_told = latex in (FROM_VALUES, NOT_THERE, GENERAL, *TOLD_SINGULAR, *OF_MOTION) or is_joint_value(latex)
    return latex.startswith("\\text{") and not is_told


def _words(posture: str) -> str:
    return posture.removeprefix("\\text{").removeprefix(THERE).removesuffix("}")


def _bent_as(postures: Sequence[str]) -> str:
    found = {*map(bent_as, postures)}
    return found.pop() if len(found) == 1 else ""


def _of_all_below(told: Told) -> Told:
    """Return what a heading tells, "Case 1: θ_2 = 0", as what all below it follows from."""
    is_exact = not any(map(_NEARLY.search, values_of(told.section)))
    return replace(told, is_direct=is_exact and bool(told.conditions), holds_below=True)


def unbraced(latex: str) -> str:
    """Return the equations of {θ_1 = 30°, θ_2 = 60°}, which set braces or parentheses hold together."""
    found = _HELD.fullmatch(latex)
    return (found["set"] or found["list"]) if found is not None else latex


def _of_constant(chain: n.Chain) -> n.Chain:
    """Return R = 2.86^2 + 127^2 for R = 2.86^2 + 127^2 ≈ 16137.2: the formula tells the number."""
    is_number = (
        len(chain.members) == 3 and chain.relations[1] in ("=", "≈") and all(map(n.is_number, chain.members[1:]))
    )
    if not is_number or chain.relations[0] != "=" or not _is_worked_out(chain.members[1]):
        return chain
    return replace(chain, members=chain.members[:2], relations=chain.relations[:1])


def _is_worked_out(node: n.Node) -> bool:
    """Whether a formula is one of several numbers, of which some are squares: what a letter abbreviates, and no value that is given."""
    below = [*n.walk(node)] if n.is_number(node) else []
    return sum(isinstance(each, n.Number) for each in below) > 1 and any(isinstance(each, n.Power) for each in below)


def _of_root(chain: n.Chain) -> n.Chain:
    """r² = x² + y² says that r = √(x² + y²), which is a length and positive; tan β = y/x what β is."""
    if chain.relations == ("=",) and (turned := angle_of_tangent(*chain.members)) is not None:
        return replace(chain, members=turned)
    if chain.relations != ("=",) or squared_name(chain.members[0]) is None:
        return chain
    square, value = chain.members
    assert isinstance(square, n.Power)
    return replace(chain, members=(bare(square.base), n.placed(n.Call("sqrt", (value,), "\\sqrt"), value.span)))


def _is_bound(chain: n.Chain) -> bool:
    in_interval = chain.relations == ("∈",) and n.interval_of("∈", chain.members[1]) is not None
    return in_interval or (bool(chain.relations) and set(chain.relations).issubset("<>≤≥≠"))


def _opposite(bound: n.Chain) -> n.Chain | None:
    """Return the other sign than that which a bound tells: θ_3 > 0 of θ_3 < 0."""
    turned = {"<": ">", ">": "<"}.get(bound.relations[0]) if len(bound.relations) == 1 else None
    return replace(bound, relations=(turned,)) if turned is not None else None


def _equated(chain: n.Chain) -> Iterator[str]:
    """Yield the names that stand alone on a side, or in a list on one."""
    for side in chain.members if chain.relations else ():
        for cell in (side, *cells_of(side)):
            if isinstance(cell, n.Name):
                yield replace(cell, dots=0).key


def value_of(name: str, node: n.Node) -> n.Chain:
    """Return the equation that gives a joint, a length or a rate its value."""
    dots, _, letter = name.rpartition(" ")
    return n.Chain((n.Name(*letter.partition("_")[::2], dots=dots.count("dot")), node), ("=",))
