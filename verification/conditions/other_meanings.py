"""A letter that the text gives another meaning than the arm has for it: what is written with it is left open."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.quantity import COMPONENTS
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.named_quantities import ABSCISSA, DISTANCE, NAMED, ORDINATE, ORIENTATION, VELOCITY
from armproof.verification.document.other_arms import OF_ARM, is_other_arm
from armproof.verification.document.other_functions import OTHER_FUNCTION
from armproof.verification.document.other_meanings import (
    ALL,
    ANEW,
    ASKED,
    BEHIND,
    EQUAL,
    JACOBIAN,
    MAY_BE_PASSIVE,
    OMEGA_FIRST,
    ORDER,
    OUTWARDS,
    PASSIVE,
    SIGNED,
    TURNS,
    UPRIGHT,
)
from armproof.verification.document.sentences import not_known_in, quoted
from armproof.verification.document.strange_letters import STRANGE_LETTER
from armproof.verification.document.subjects import ACCELERATION, OPERATED
from armproof.verification.document.told_turns import OTHER_TURN
from armproof.verification.document.told_variables import (
    BENT,
    FROM_BASE,
    FROM_SPACE,
    OTHER_LINK,
    RAISED,
    STANDING,
    STROKE,
    VARIABLE,
)
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.conventions import ORIENTATIONS, is_entry
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED, Verdict

_VELOCITIES = ("v", "V")
_MOVING = (*_VELOCITIES, *"xyzpPXYZ")  # what has an acceleration
_TWIST = (6, 1)
_PAIR = regex(r"\w,?\w")
_IN_ORDER = ("J", "tau", "q")  # what has a column or an entry for each joint
_RUNNING = "ijkn"  # the index of θ_i, which is any number
_DOTS = regex(r"\\d?dot(?![A-Za-z])")
_TURNS = (*ORIENTATIONS, "omega", "Omega", "beta")
_OTHERS = {ABSCISSA: "yz", ORDINATE: "x", DISTANCE: "xyz", ORIENTATION: "xyz"}  # coordinates that are not what is named


class OtherMeanings:
    """Leaves open what is written with a letter that is meant otherwise."""

    def __init__(self, checker: ChainChecker, given: GivenValues) -> None:
        self.checker = checker
        self.given = given
        self.names = checker.names
        self.order_doubt: tuple[str, Finding] | None = None  # of rotations one after another, and the section

    def judge(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what is written with a letter that the text gives another meaning than the arm has for it."""
        if ASKED in meant:
            return outcome.left_open(say(Kind.IS_SUPPOSED))
        written = {below.undotted.key for node in outcome.nodes for below in n.names(node)}
        of_order = next((b for node in outcome.nodes for b in n.names(node) if self._is_in_order(b)), None)
        by = next((each.terms["letters"] for each in outcome.findings if each.kind is Kind.DERIVATIVES_OF_POINT), None)
        if of_order is not None and (JACOBIAN in meant or any(self._is_permuted(each, by) for each in meant)):
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=of_order.key))
        if (turned := self._turned_otherwise(outcome, meant)) is not None:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=turned))
        sides = (outcome.pair.true, outcome.pair.printed) if outcome.pair is not None else ()
        is_twist = any(side.shape == _TWIST for side in sides)  # a Jacobian is read in that order
        if OMEGA_FIRST in meant and is_twist and written.isdisjoint(self.names.quantities):
            return outcome.left_open(say(Kind.OMEGA_IS_FIRST))
        symbols = symbols_in(cell for side in sides for cell in side.cells if isinstance(cell, Scalar))
        written |= {each.rpartition(" ")[2] for each in symbols}  # dot d_3 is written with d_3
        lengths = {*self.given.lengths}
        if EQUAL in meant and outcome.verdict is Verdict.REFUTED and len(lengths) > 1 and written & lengths:
            return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=min(written & lengths)))
        signed = {self.names.reader.key_of(each.removeprefix(SIGNED)) for each in meant if each.startswith(SIGNED)}
        slides = {key for key in signed if key in self.given.joints and not self.names.is_angle(key)}
        if slides and outcome.tells(Kind.ON_A_BRANCH, Kind.TO_DECIMALS_ON_A_BRANCH):
            return outcome.left_open(say(Kind.POSITIVE_ALONE, letters=", ".join(sorted(slides))))
        for each in meant:
            letters = self._meant_by(each)
            if not written.isdisjoint(letters):
                return outcome.left_open(say(Kind.MEANT_OTHERWISE, name=min(written & letters)))
        return self._in_strange_words(self._of_variables(outcome, meant, written), meant, written)

    def _in_strange_words(self, outcome: Outcome, meant: Sequence[str], written: set[str]) -> Outcome:
        """Leave open what is written with a letter of which a sentence above tells in words that are not known."""
        for latex, text in (each.split("\t")[1:] for each in meant if each.startswith(STRANGE_LETTER)):
            key = self.names.reader.key_of(_DOTS.sub("", latex))
            if {key, self.names.known_symbol(key) or key} & written:
                words = ", ".join(not_known_in(text))
                return outcome.left_open(say(Kind.STRANGE_LETTER, name=key, text=quoted(text), words=words))
        return outcome

    def _of_variables(self, outcome: Outcome, meant: Sequence[str], written: set[str]) -> Outcome:
        """Leave open what is written with a joint variable or a length of which the text says what is not that of the arm."""
        if self.names.arm is None:
            return outcome
        told = (each.split("\t")[1:] for each in meant if each.startswith(VARIABLE))
        for which, latex, text in told:
            if self.names.is_of_formulas and not self._may_contradict(which):  # which fit any letters
                continue
            if (which in (BENT, RAISED) and self._is_bent()) or self._holds_rest(which):
                continue
            if letters := written & self._variables(which, latex):
                return outcome.left_open(say(Kind.VARIABLE_TOLD, name=min(letters), text=quoted(text)))
        return outcome

    def raised(self, meant: Sequence[str]) -> set[str]:
        """Return the joints of which the text says that the arm stands up at their zero, where it does."""
        told = [each.split("\t")[1:] for each in meant if each.startswith(VARIABLE)]
        letters = {self.names.reader.key_of(latex) for which, latex, _ in told if which == RAISED and latex}
        return {self.names.known_symbol(each) or "" for each in letters} & self._standing_up() if letters else set()

    def _may_contradict(self, which: str) -> bool:
        """Whether what a text says of a variable or a length is otherwise in the formulas that give the arm, and no name of it alone."""
        if which in (BENT, RAISED):
            return self._lies_along_x()
        return which in (OTHER_LINK, FROM_SPACE) or which.startswith(STROKE)

    def _holds_rest(self, which: str) -> bool:
        """Whether the arm has the length of what slides where it is pushed in, from which its stroke is counted."""
        rest = which.removeprefix(STROKE).strip() if which.startswith(STROKE) else ""
        return bool(rest) and self.names.known_symbol(self.names.reader.key_of(rest)) in {*self.given.lengths}

    def _lies_along_x(self) -> bool:
        """Whether the arm lies along the x-axis of the base, to no other side, where its angles are zero."""
        arm, exact = self.names.arm, self.checker.exact
        assert arm is not None
        values = {joint.symbol: exact.ring.rational(0) for joint in arm.joints if joint.kind == "revolute"}
        values |= dict.fromkeys(self.given.lengths, exact.ring.one)
        steps = [[substitute(each, values).normal() for each in step] for step in self._steps()]
        return all(y.is_zero() and z.is_zero() for _, y, z in steps)

    def _steps(self) -> list[list[Scalar]]:
        """Return from each frame of the arm to the next the way between their origins, in the base."""
        arm, exact = self.names.arm, self.checker.exact
        assert arm is not None
        poses = [exact.pose(frame, arm.frames[0]) for frame in arm.frames]
        places = [[row[-1] for row in pose.rows[:3]] for pose in poses]
        return [[b - a for a, b in zip(*pair, strict=True)] for pair in pairwise(places)]

    def _is_bent(self) -> bool:
        """Whether the links of the arm do not lie in one line where its angles are zero."""
        arm, exact = self.names.arm, self.checker.exact
        assert arm is not None
        at_zero = {joint.symbol: exact.ring.rational(0) for joint in arm.joints if joint.kind == "revolute"}
        steps = [[substitute(each, at_zero) for each in step] for step in self._steps()]
        along = {axis for step in steps for axis, each in enumerate(step) if not each.is_zero()}
        return len(along) > 1

    def _variables(self, which: str, latex: str) -> set[str]:
        r"""Return the joint variables and lengths that a letter of the text is of: \theta_i of all \theta_1, \theta_2, …; all angles without one."""
        is_of_space = which in (FROM_BASE, FROM_SPACE)
        turned = self._turned(is_of_space)
        of_arm = turned if is_of_space else {*self.given.joints, *self.given.lengths}
        standing = self._standing_up() if which in (STANDING, RAISED) else set[str]()
        if not latex:
            return set() if standing else turned
        base, _, index = self.names.reader.key_of(latex).partition("_")
        keys = (
            [f"{base}_{number}" for number in range(1, 10)]
            if index in (*_RUNNING,)
            else [f"{base}_{index}".rstrip("_")]
        )
        return {*keys, *(self.names.known_symbol(key) or "" for key in keys)} & (of_arm - standing)

    def _is_in_order(self, name: n.Name) -> bool:
        """Whether a name is of what has a column or an entry for each joint, and not a joint itself."""
        return name.base in _IN_ORDER and self.names.known_symbol(name.undotted.key) not in self.names.joints

    def _turned_otherwise(self, outcome: Outcome, meant: Sequence[str]) -> str | None:
        """Return a rotation that is written out where the text has passive ones, or a T_{ij} where i is the frame that j sees; None without one."""
        below = [each for node in outcome.nodes for each in n.walk(node)]
        may_be = MAY_BE_PASSIVE in meant and outcome.verdict is Verdict.REFUTED
        if (PASSIVE in meant or may_be) and any(isinstance(each, n.Matrix) for each in below):
            calls = (each.head for each in below if n.is_call(each, "Rot", "Rot3", "Trans"))
            names = (each.key for each in below if isinstance(each, n.Name) and each.base == "R")
            return next(iter((*calls, *names)), None)
        pairs = (each for each in below if isinstance(each, n.Name) and each.base in "TAHR" and not each.pre_sup)
        return next((each.key for each in pairs if OUTWARDS in meant and _PAIR.fullmatch(each.sub)), None)

    def _is_permuted(self, meant: str, by: Sequence[str] | None) -> bool:
        """Whether the text has all joint variables in a vector, in another order than the arm, or than a Jacobian that is of a point of the document's own."""
        which, _, latex = meant.partition(" ")
        keys = (
            [self.names.reader.key_of(re.sub(r"\\dot\b", "", each)) for each in latex.split()] if which == ORDER else []
        )
        if by is not None:
            return keys != [*by] and sorted(keys) == sorted(by)
        joints = [self.names.known_symbol(key) for key in keys]
        return joints != [*self.names.joints] and sorted(map(str, joints)) == sorted(self.names.joints)

    def in_order(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open a product of rotations whose factors stand in another order than the text has them, and the name that it defines."""
        for told in (each.removeprefix(TURNS) for each in meant if each.startswith(TURNS)):
            axes, *angles = told.split()
            order = [(axis, self.names.reader.key_of(angle)) for axis, angle in zip(axes, angles or axes, strict=True)]
            found = [product for node in outcome.nodes for product in _products_of_rotations(node)]
            if any(_are_otherwise(product, order, bool(angles)) for product in found):
                doubt = say(Kind.TURNED_IN_ORDER, order=" ".join(f"R_{axis}" for axis in axes))
                self.order_doubt = self.names.state.section, doubt
                for key in outcome.defines:
                    self.names.leave_open(key, doubt)
                return replace(outcome.left_open(doubt), defines=())
        return outcome

    def of_entries(self, outcome: Outcome) -> Outcome:
        """Leave open what is said of the entries r_{31} of rotations whose order is not decided, in their section."""
        if self.order_doubt is None or self.order_doubt[0] != self.names.state.section:
            return outcome
        written = [name for node in outcome.nodes for name in n.names(node)]
        if any(map(is_entry, written)) and (outcome.verdict in DECIDED or outcome.defines):
            for key in outcome.defines:
                self.names.leave_open(key, self.order_doubt[1])
            return replace(outcome.left_open(self.order_doubt[1]), defines=())
        return outcome

    def of_quantity(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what prints a quantity where the text names another one, or its transpose, inverse or derivative, or the acceleration."""
        sides = [bare(node) for node in outcome.nodes]
        alone = [side for side in sides if isinstance(side, n.Name) and not (side.pre_sup or side.pre_sub)]
        letters = "".join(each.removeprefix(OPERATED).strip() for each in meant if each.startswith(OPERATED))
        is_itself = any(side.base in letters and not side.dots and side.sup == "" for side in alone)
        orders = [side.dots + (side.base in _VELOCITIES) for side in alone if side.base in _MOVING]
        is_of_lower_order = ACCELERATION in meant and bool(orders) and max(orders) == 1
        named = {each.removeprefix(NAMED).strip() for each in meant if each.startswith(NAMED)}
        is_of_lower_order |= VELOCITY in named and bool(orders) and not max(orders)
        others = {letter for each in named for letter in _OTHERS.get(each, "")}
        is_other = not others.isdisjoint(_coordinate(side) for side in alone if not side.dots)
        is_other |= OTHER_TURN in meant and any(map(self._is_turn, alone))
        is_function = OTHER_FUNCTION in meant and (bool(alone) or any(n.is_call(side, "det") for side in sides))
        if is_itself or is_of_lower_order or is_other or is_function:
            return outcome.left_open(say(Kind.OF_OTHER_QUANTITY))
        return outcome

    def _is_turn(self, name: n.Name) -> bool:
        """Whether a name is of an angle or an angular velocity of the hand, or of a link, by convention alone."""
        key, state = name.undotted.key, self.names.state
        is_told = key in self.names.quantities or (key in state.definitions and key not in state.conventional)
        return name.base in _TURNS and not is_told and self.names.known_symbol(key) not in self.names.joints

    def of_arm(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what is decided where the text speaks of an arm that has not the joints of this one."""
        named = [each.removeprefix(OF_ARM).strip() for each in meant if each.startswith(OF_ARM)]
        if self.names.arm is not None and any(is_other_arm(each, self.names.arm) for each in named):
            return outcome.left_open(say(Kind.OF_OTHER_ARM))
        return outcome

    def _meant_by(self, meant: str) -> set[str]:
        r"""Return the names that a letter, or the word for all angles, is of, joints and lengths but for `ANEW`: of `BEHIND` those that are measured from a joint before them."""
        which, _, latex = meant.partition(" ")
        if which == ANEW:
            key = self.names.reader.key_of(latex)
            return {key, self.names.known_symbol(key) or key} - {""}
        if which == UPRIGHT:
            key = self.names.known_symbol(self.names.reader.key_of(latex)) or ""
            return {key} - {"", *self._standing_up()}
        if which not in (ALL, BEHIND):
            return set()
        of_arm = {*self.given.lengths} | self._turned(which == BEHIND)
        if not latex:
            return self._turned(which == BEHIND)
        return {self.names.reader.key_of(latex)} & of_arm

    def _standing_up(self) -> set[str]:
        """Return the joints whose angle is one from the vertical: about a horizontal axis, and at 0 the link that they move stands above it; in the plane of x and y it lies along y."""
        arm, exact = self.names.arm, self.checker.exact
        if arm is None:
            return set()
        base, found = arm.frames[0], set[str]()
        wholes = [exact.jacobian(frame, base) for frame in arm.frames[1:]]
        for joint in arm.joints:
            if joint.kind != "revolute":
                continue
            columns = ([row[joint.index - 1] for row in whole.rows] for whole in wholes)
            moves = next((each for each in columns if not all(cell.is_zero() for cell in each[:3])), None)
            at_zero = [substitute(each, {joint.symbol: exact.ring.rational(0)}) for each in moves or ()]
            if moves is not None and _stands_still(at_zero[2] if moves[5].is_zero() else at_zero[1], at_zero):
                found.add(joint.symbol)
        return found

    def _turned(self, only_behind: bool) -> set[str]:
        """Return the joints that turn; or those alone that a joint before them turns about the same direction."""
        if self.names.arm is None:
            return {*self.given.joints}
        turning = [joint for joint in self.names.arm.joints if joint.kind == "revolute"]
        if not only_behind:
            return {joint.symbol for joint in turning}
        whole = self.checker.exact.jacobian(self.names.arm.frames[-1], self.names.arm.frames[0])
        axes = {joint: [row[joint.index - 1] for row in whole.rows[3:]] for joint in turning}
        found = set()
        for before, joint in combinations(turning, 2):
            pairs = [*zip(axes[joint], axes[before], strict=True)]
            if all((a - b).is_zero() for a, b in pairs) or all((a + b).is_zero() for a, b in pairs):
                found.add(joint.symbol)
        return found


def _stands_still(up: Scalar, moves: Sequence[Scalar]) -> bool:
    """Whether what moves does so to the side alone, and not up."""
    return up.is_zero() and not (moves[0].is_zero() and moves[1].is_zero())


def _coordinate(name: n.Name) -> str:
    """Return which coordinate a name is, x, y or z, by its letter or its index: x, y_e, p_x; "" of none."""
    if name.base.lower() in COMPONENTS:
        return name.base.lower()
    return next((letter for letter in COMPONENTS if name.base in "pP" and letter in name.sub), "")


def _products_of_rotations(node: n.Node) -> Iterator[list[tuple[str, str]]]:
    """Yield the rotations about axes of coordinates that are multiplied in a tree, in their order: their axes and the keys of their angles."""
    for below in n.walk(node):
        factors = [bare(factor) for factor in below.factors] if isinstance(below, n.Product) else []
        calls = [each for each in factors if isinstance(each, n.Call) and each.function in ("Rot", "Rot3")]
        axes = [axis.base.lower() for each in calls if isinstance(axis := each.arguments[0], n.Name)]
        if axes and len(axes) == len(factors):
            yield [*zip(axes, (bare_key(each.arguments[1]) or "" for each in calls), strict=True)]


def _are_otherwise(found: Sequence[tuple[str, str]], told: Sequence[tuple[str, str]], with_angles: bool) -> bool:
    """Whether rotations are those that a text tells, in another order."""
    if not with_angles:
        found, told = ([(axis, "") for axis, _ in each] for each in (found, told))
    return sorted(found) == sorted(told) and found != told
