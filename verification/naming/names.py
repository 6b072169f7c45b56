"""What the names of a document mean: front matter first, then earlier displays, the arm, and common notation."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

from armproof.models.arm import Arm, Joint, once_per_arm
from armproof.models.dh.entry import LinearForm
from armproof.models.dh.table import DHRow
from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.document.stages import goes_on
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import NUMBERS, one_of
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.conventions import AXES, conventional
from armproof.verification.naming.quantities import implied_quantity, numbered_frames, tells_frame, transform_pair
from armproof.verification.naming.solids import solid_quantity
from armproof.verification.naming.state import Definition, DocumentState, undecided
from armproof.verification.patterns import regex

FREE_IN_GENERAL = regex(r"[a-z]|%s" % one_of(NUMBERS))
OF_SCREWS = regex(r"[LHWD](?:_\d)?")  # lengths beside twists, and what are motions, points and twists there
NO_NUMBERS = frozenset("g p v omega xi".split())
OF_JOINTS = r"(?:[tT]heta|q|(?:theta|q|d)_\d(?:,(?:theta|q|d)_\d)*)\)"
COMPONENT = regex(r"[xyz]|\w+,[xyz]")
MOVES = frozenset("RT")  # along or about the axis that stands below: R_x R_z is not R_z R_x


@once_per_arm  # asked for at every name of a tree
def _by_symbol(arm: Arm) -> Mapping[str, Joint]:
    return {joint.symbol: joint for joint in arm.joints}


@dataclass(frozen=True)
class Names:
    """The bindings of one document: those of its front matter, and in `state` those that its displays add.

    `general` marks the names of its general statements, which are about no arm; they share the state but have free letters
    of their own. `is_part`: whether the arm is only the first part of the one that the document is about;
    `lacks_base`: whether that has joints before the arm's first; `is_of_formulas`: whether coordinates gave the arm.
    """

    arm: Arm | None
    symbols: Mapping[str, str] = field(default_factory=dict)
    quantities: Mapping[str, Quantity] = field(default_factory=dict)
    stated_transforms: str = ""
    reader: Reader = field(default_factory=Reader)
    state: DocumentState = field(default_factory=DocumentState)
    general: bool = False
    is_part: bool = False
    lacks_base: bool = False
    is_of_formulas: bool = False

    @property
    def base(self) -> str:
        """The frame that the arm stands on."""
        assert self.arm is not None
        return self.arm.frames[0]

    @property
    def transforms(self) -> str:
        """Which index of T^i_j names the reference: as stated, else as the first link matrix shows, else the upper one."""
        return self.stated_transforms or self.state.transforms or "upper"

    @property
    def used(self) -> set[str]:
        """The free letters that displays have used so far."""
        return self.state.used_in_general if self.general else self.state.used

    @property
    def joints(self) -> Mapping[str, Joint]:
        """The arm's joints by their symbols, base to tool; none without an arm."""
        return _by_symbol(self.arm) if self.arm is not None else {}

    def is_angle(self, symbol: str | None) -> bool:
        """Whether a symbol is the variable of a joint that turns."""
        joint = self.joints.get(symbol or "")
        return joint is not None and joint.kind == "revolute"

    @property
    def lengths(self) -> Mapping[str, float]:
        """The arm's lengths with their values in the plant; none without an arm."""
        return self.arm.lengths if self.arm is not None else {}

    def known_symbol(self, key: str) -> str | None:
        """Return the model's symbol for a scalar name of the document, or None."""
        if key in self.symbols:
            return self.symbols[key]
        if self.arm is None:
            return None
        if key in self.joints or key in self.arm.lengths or key in self.arm.angles or key in self.state.adopted:
            return key
        found = re.fullmatch(r"(q|theta|d|r)_(\d+)", key)
        if found:
            letter, index = found.group(1), int(found.group(2))
            joint = self._joint_of_index(index)
            other = (
                letter == "q"
                and joint is not None
                and joint.symbol.startswith("theta")
                and (self.reader.spelling.variables == "told" or self.reader.spelling.of_quaternion)
            )
            if joint is not None and not other and (letter == "q" or (letter == "theta") == (joint.kind == "revolute")):
                return str(joint.symbol)
        return None

    def _joint_of_index(self, index: int) -> Any:
        """The joint whose symbol carries the index; else the index-th from the base, where no joint is called by its own."""
        assert self.arm is not None
        named = [joint for joint in self.arm.joints if joint.symbol.endswith(f"_{index}")]
        if len(named) > 1:  # an index that an angle and a slide share is the angle's
            named = [joint for joint in named if joint.kind == "revolute"]
        if len(named) == 1:
            return named[0]
        own = {joint.symbol.rpartition("_")[2] for joint in self.arm.joints}
        in_order = not named and own.isdisjoint(self.reader.spelling.indices)
        in_order = in_order and not (self.arm.dh is not None and self.arm.dh.has_fixed)  # else rows are counted
        return self.arm.joints[index - 1] if in_order and 1 <= index <= len(self.arm.joints) else None

    @property
    def offset_joints(self) -> dict[str, DHRow]:
        """The revolute joints whose angle in the DH table is their variable and an offset, by symbol.

        With a minus before the variable, in a document that tells it from the angle.
        """
        rows = self.arm.dh.rows if self.arm is not None and self.arm.dh is not None else ()
        turns = [row for row in rows if row.kind == "revolute" and not row.theta.without(row.joint).symbols]
        both = self.reader.spelling.variables
        return {
            row.joint: row
            for row in turns
            if (row.sign == -1 and both) or (row.sign == 1 and row.theta != LinearForm(((row.joint, Fraction(1)),)))
        }

    def table_row(self, symbol: str, key: str = "") -> DHRow | None:
        """Return the row of the DH table whose angle a joint's letter means; None where it means the variable.

        Beside q_i, θ_i is that angle; else an equation tells which of them the joint's letter means.
        """
        if key and self.reader.spelling.variables and self.state.angles != "loose" and not symbol.startswith("theta"):
            return self.offset_joints.get(symbol) if key.startswith("theta") else None
        return self.offset_joints.get(symbol) if self.state.angles == "table" else None

    def turn_of(self, symbol: str, key: str) -> int:
        """Return -1 where a joint's letter means the table's angle, and that is turned against the variable; else 1."""
        row = self.table_row(symbol, key)
        return 1 if row is None else row.sign

    def angle_offset(self, row: DHRow, algebra: Algebra) -> Any:
        """Return what the angle of a row holds beside the variable."""
        return algebra.pi() * algebra.rational(row.theta.pi) + algebra.rational(row.theta.number)

    def table_angle(self, symbol: str, algebra: Algebra, key: str = "") -> Any:
        """Return the angle that the letter of a joint means."""
        value, row = algebra.symbol(symbol), self.table_row(symbol, key)
        if self.state.counts_anew and symbol in self.state.zeros:
            zero = self.state.zeros[symbol]
            self.state.consulted.add((zero.key, zero.line))
            value = value - algebra.pi() * algebra.rational(zero.turn)
        return value if row is None else value * algebra.rational(Fraction(row.sign)) + self.angle_offset(row, algebra)

    def variable_at(self, symbol: str, angle: Any, algebra: Algebra, key: str = "") -> Any:
        """Return the value of a joint variable where its letter has a value."""
        if self.state.counts_anew and symbol in self.state.zeros:
            angle = angle + algebra.pi() * algebra.rational(self.state.zeros[symbol].turn)
        row = self.table_row(symbol, key)
        return (
            angle if row is None else (angle - self.angle_offset(row, algebra)) * algebra.rational(Fraction(row.sign))
        )

    def joint_angle(self, index: int) -> str | None:
        """Return the symbol of the angle that the digit in c_{12} names."""
        for key in (f"theta_{index}", f"q_{index}"):
            if key in self.symbols:
                return self.symbols[key]
        if self.arm is None:
            return f"{self.reader.spelling.angle}_{index}"
        joint = self._joint_of_index(index)
        return str(joint.symbol) if joint is not None and joint.kind == "revolute" else None

    def angle_sum(self, name: n.Name) -> n.JointAngles | None:
        """Return θ_2 + θ_3 for a θ_{23} that nothing else gives a meaning, or None."""
        if (
            name.base not in ("theta", "q")
            or not re.fullmatch(r"[1-9]{2,}", name.sub)
            or name.sup
            or name.pre_sup
            or name.primes
        ):
            return None
        digits = [int(digit) for digit in name.sub]
        rising = all(a < b for a, b in pairwise(digits))
        if self.arm is None or not rising or any(self.joint_angle(digit) is None for digit in digits):
            return None
        signs = self.reader.spelling.joint_signs(name.sub)
        return n.JointAngles(tuple(zip(signs, digits, strict=True)), span=name.span)

    def own_sum(self, node: n.Node) -> str:
        """Return the digits of a c_{34} or θ_{34} that the document says to be another sum of angles than usual, or nothing."""
        if isinstance(node, n.JointAngles):
            digits = "".join(str(index) for _, index in node.terms)
        else:
            digits = node.sub if isinstance(node, n.Name) and node.base in ("theta", "q") else ""
        return digits if digits in dict(self.reader.spelling.sums) else ""

    def added_frame(self, name: n.Name) -> tuple[str, str, str] | None:
        """Return (reference, frame of the arm, name of the transform from it) of a transform to a frame the document added."""
        if self.arm is None or name.base not in ("T", "A", "H", "R") or name.primes or name.dots:
            return None
        pair = transform_pair(name, self.arm, self.transforms)
        if pair is None or pair[1] not in self.state.beyond or pair[0] not in self.arm.frames:
            return None
        frame, key = self.state.beyond[pair[1]]
        return (pair[0], frame, key) if key != name.key else None

    def adds_frame(self, name: n.Name) -> bool:
        """Whether a transform leads from a frame of the arm to one that is not the arm's."""
        pair = (
            transform_pair(name, self.arm, self.transforms)
            if self.arm is not None and name.base in ("T", "A", "H")
            else None
        )
        return (
            pair is not None and self.arm is not None and pair[0] in self.arm.frames and pair[1] not in self.arm.frames
        )

    def adds_base(self, name: n.Name) -> bool:
        """Whether a transform leads from a frame that is not the arm's to its base: {}^B_0T, {}^WT_0."""
        arm = self.arm if name.base in ("T", "A", "H") else None
        pair = transform_pair(name, arm, self.transforms) if arm is not None else None
        return pair is not None and arm is not None and pair[0] not in arm.frames and pair[1] == arm.frames[0]

    def add_frame(self, name: n.Name) -> None:
        """Remember that a defined transform leads from a frame of the arm to one that is not the arm's."""
        pair = transform_pair(name, self.arm, self.transforms) if self.arm is not None else None
        if pair is not None and self.adds_frame(name):
            self.state.beyond.setdefault(pair[1], (pair[0], name.key))

    def quantity(self, name: n.Name) -> Quantity | None:
        """Return the arm's quantity that a name stands for, or None."""
        if name.key in self.quantities:
            return self.quantities[name.key]
        if self.arm is None or name.key in self.state.definitions:
            return None
        if (of_solid := self._of_solid(name)) is not None:
            return of_solid
        found = self.state.inferred.get(name.key) or implied_quantity(name, self.arm, self.transforms)
        if found is not None and not self.may_be(name, found):
            return None
        shown = self.state.shown.get(name.key)
        if shown is None or found is None or found.kind != "jacobian":
            return found
        read = replace(found, rows=shown.rows) if shown.rows != (1, 2, 3, 4, 5, 6) else found
        return read if shown.columns is None else replace(read, columns=shown.columns)

    def _of_solid(self, name: n.Name) -> Quantity | None:
        """Return what a name means where the document numbers solids from that of the arm's first frame on."""
        solid = self.reader.spelling.first_solid
        if self.arm is None or self.is_of_formulas or not solid or solid != self.arm.frames[0]:
            return None
        return solid_quantity(name, self.arm, self.quantities)

    def may_be(self, name: n.Name, quantity: Quantity) -> bool:
        """Whether a name can be that quantity: the tool of an arm of which only a part is known is none of its frames.

        Where joints before it are not known, what says no reference is not seen from the part's first frame.
        """
        of_base = self.arm is not None and quantity.reference == self.arm.frames[0]
        told = quantity.reference in (name.pre_sup, name.sup, name.pre_sub) or len(name.sub) > 1
        if self.lacks_base and of_base and not told and name.base != "A":
            return False
        return (
            not self.is_part or self.arm is None or quantity.frame != self.arm.frames[-1] or tells_frame(name, quantity)
        )

    def rows_of(self, key: str) -> tuple[int, ...] | None:
        """Return the rows (from 1) in which the document shows the Jacobian of a name, or None where it has not."""
        shown = self.state.shown.get(key)
        return shown.rows if shown is not None else None

    @property
    def has_tool(self) -> bool:
        """Whether the arm has a frame behind its last numbered one."""
        return self.arm is not None and self.arm.frames[-1] != numbered_frames(self.arm)[-1]

    def usual(self, name: n.Name) -> tuple[Quantity, ...]:
        """Return what a name may stand for by convention, the likelier first."""
        return conventional(name, self.arm, self.transforms, self.reader.spelling.normals) if self.arm else ()

    def is_free(self, name: n.Name) -> bool:
        """Whether an unbound name is a free scalar: in a document of general statements, a letter with indices."""
        if self.arm is not None or name.pre_sub or name.pre_sup:
            return False
        component = len(name.base) == 1 and name.base not in MOVES and bool(COMPONENT.fullmatch(name.sub))
        component = component or (name.base == "L" and name.sub.isdigit())  # a link's length; L alone is much else
        if self.reader.spelling.screws and (name.base in NO_NUMBERS or OF_SCREWS.fullmatch(name.key)):
            return name.base not in NO_NUMBERS
        component = component or name.key in self.reader.spelling.scalars
        return component or name.key in self.reader.spelling.masses or bool(FREE_IN_GENERAL.fullmatch(name.base))

    def applied_to_joints(self, name: n.Name) -> str | None:
        """Return the T(θ) that a document without an arm has defined around this place, which T alone then is; or None."""
        for key, definition in self.state.definitions.items() if self.arm is None and name.base in "TAHM" else ():
            head, _, variables = key.partition("(")
            around = goes_on(definition.section, self.state.section)
            if head == name.key and around and re.fullmatch(OF_JOINTS, variables):
                return key
        return None

    def component(self, name: n.Name) -> tuple[str, int] | None:
        """Return the column that a document without an arm prints for a letter, n = [..; ..; ..], and the row of it that n_x names; None of another name."""
        made = self.state.definitions.get(name.base) if self.arm is None and name.sub in tuple(AXES) else None
        column = n.bare(made.node) if made is not None and made.node is not None else None
        if name != n.Name(name.base, name.sub) or made is None or not isinstance(column, n.Matrix):
            return None
        own = any(below.base == name.base for below in n.names(column))  # n = [n_x; n_y; n_z]
        is_column = len(column.rows) in (2, 3) and all(len(row) == 1 for row in column.rows)
        around = goes_on(made.section, self.state.section) and name.key not in self.state.definitions
        row = AXES.index(name.sub)
        return (name.base, row) if is_column and not own and around and row < len(column.rows) else None

    def is_open(self, name: n.Name) -> bool:
        """Whether neither notation nor the document gives a name a meaning."""
        taken = name.key in self.quantities or name.key in self.state.definitions or name.key in self.state.inferred
        return not taken and self.known_symbol(name.key) is None and self.quantity(name) is None

    def defines_sign(self, key: str) -> bool:
        """Whether a display that gives a name both signs defines it: nothing else gives it a meaning."""
        return not (key in self.quantities or key in self.state.definitions or self.known_symbol(key) is not None)

    def is_new(self, name: n.Name) -> bool:
        """Whether a letter that could be free has not been used or defined: one side of an equation may define it.

        The rate of what is defined is no new name.
        """
        if self.component(name) is not None:
            return False
        taken = {name.key, name.undotted.key}
        return self.is_free(name) and name.key not in self.used and taken.isdisjoint(self.state.definitions)

    def defined_value(self, key: str, algebra: Algebra) -> Value:
        """Return the value of a name that a display has defined, and remember that it was asked for."""
        definition = self.state.definitions[key]
        self.state.consulted.add((key, definition.line))
        return definition.evaluate(algebra)

    def leave_open(self, key: str, doubt: Finding) -> None:
        """Let nothing be decided by a name's definition, of which nobody can tell whether it is meant so."""

        if key in self.state.definitions:
            self.state.definitions[key] = replace(self.state.definitions[key], evaluate=undecided(doubt))

    def doubt(self, key: str) -> None:
        """Let a name keep what a display says that it is, which may be a mistake."""
        if key in self.state.definitions:
            self.state.definitions[key] = replace(self.state.definitions[key], is_doubted=True)

    def keep_as_given(self, key: str) -> None:
        """Let a name have the number that a display gives it, and refute nothing under another heading."""
        if key in self.state.definitions:
            self.state.definitions[key] = replace(self.state.definitions[key], is_given=True)

    def forget(self, keys: Iterable[str]) -> None:
        """Take back what names have meant so far."""
        for key in keys:
            self.state.inferred.pop(key, None)
            self.state.definitions.pop(key, None)
            self.state.conventional.discard(key)

    def leave_unknown(self, keys: Iterable[str], line: int, kind: Kind = Kind.SECOND_MEANING) -> None:
        """Let names without a meaning have none by convention either: a display of this section gave them one that is not known."""
        for key in keys:
            if key not in self.state.definitions and key not in self.state.inferred:
                self.define(key, undecided(say(kind, name=key, line=line)), line)
                self.state.definitions[key] = replace(self.state.definitions[key], has_two_meanings=True)

    def define(
        self,
        key: str,
        evaluate: Callable[[Algebra], Value],
        line: int = 0,
        *,
        by_place: bool = False,
        node: n.Node | None = None,
        in_text: bool = False,
        by_table: bool = False,
        of_section: bool = False,
        root: n.Node | None = None,
        whole: n.Node | None = None,
    ) -> None:
        """Give a name its meaning, unless it has one: what an equation of its own says, or that with its slip mended."""
        if node is not None and (key, line) in self.state.mended:
            node, evaluate = self.state.mended[key, line]
        definition = Definition(
            evaluate,
            line,
            self.state.section,
            by_place,
            node,
            self.state.exercise,
            in_text=in_text,
            by_table=by_table,
            of_section=of_section,
            root=root,
            whole=whole,
        )
        self.state.definitions.setdefault(key, definition)
