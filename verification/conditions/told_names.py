"""A name that the text defines in words: where they are not those of what convention takes it for, nothing is decided by it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.document.heading import encloses
from armproof.verification.document.told_names import INNER, LINK, OTHER, POINT, STRANGE, TOLD, TOOL, WANTED, WRIST
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import is_usual
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.patterns import regex
from armproof.verification.verdict import DECIDED, Role, Verdict

_RUNNING = regex(r"[ijkn](?:[+-]1)?")  # the index of ω_i, which is any number
_TRANSFORMS = ("T", "A", "H", "R")
_LONGEST = 80  # characters of what is quoted


class ToldNames:
    """Leaves open what rests on a name whose definition in words is not that of its usual meaning."""

    def __init__(self, names: Names, has_hand: Callable[[], bool]) -> None:
        self.names = names
        self.has_hand = has_hand

    def judge(self, outcome: Outcome, meant: Sequence[str]) -> Outcome:
        """Leave open what is decided, or could be, by a name that the text says to be something else than it usually is."""
        told = [each.split("\t")[1:] for each in meant if each.startswith(TOLD)]
        if not told or self.names.arm is None:
            return outcome
        if outcome.verdict is Verdict.UNCHECKED and outcome.as_usual is None:
            return outcome
        written = [*self._written(outcome)]
        for latex, place, words in told:
            name = self._name(latex)
            found = next((each for each in written if name is not None and _is(each, name)), None)
            if found is not None and self._is_otherwise(found, place):
                text = words if len(words) <= _LONGEST else f"{words[:_LONGEST]}…"
                doubt = say(Kind.TOLD_OTHERWISE, name=found.key, text=text)
                return replace(outcome.left_open(doubt), as_usual=None)
        return outcome

    def _written(self, outcome: Outcome) -> Iterator[n.Name]:
        """Yield the names that an equation rests on, without their dots: its own and those behind what the document defines."""
        own = [each.undotted for node in (*outcome.nodes, *outcome.conditions) for each in n.names(node)]
        yield from own
        for between in (each for each in own if "to" in each.sub):  # the points of O_0O_1
            yield from (replace(between, sub=index) for index in between.sub.split("to"))
        definitions = self.names.state.definitions
        for key in {each.key for each in own} & definitions.keys():
            if (node := definitions[key].node) is not None:
                yield from (each.undotted for each in n.names(node))

    def _name(self, latex: str) -> n.Name | None:
        try:
            name = bare(self.names.reader.read_expression(latex))
        except ReadError:
            return None
        return name.undotted if isinstance(name, n.Name) else None

    def _is_otherwise(self, name: n.Name, place: str) -> bool:
        """Whether a name is usually a quantity of the arm, and not that of the place at which the text has it."""
        if name.key in self.names.quantities or self.names.known_symbol(name.key) is not None:
            return False
        if name.key in self.names.state.definitions and name.key not in self.names.state.conventional:
            return False  # a display says what it is
        meaning = self.names.quantity(name)
        usual = (meaning,) if meaning is not None else self.names.usual(name)
        if not usual:
            return False
        which, _, number = place.partition(" ")
        if which == WANTED:  # a target with a number is one of several
            return name.sub.isdigit()
        if which == STRANGE and name.base in _TRANSFORMS and (name.pre_sup or name.sup) and (name.pre_sub or name.sub):
            return False  # its indices tell it
        if which == POINT:
            return any(each.kind == "origin" for each in usual)
        return which in (OTHER, STRANGE) or self._is_elsewhere(usual, which, number)

    def _is_elsewhere(self, usual: Sequence[Quantity], which: str, number: str) -> bool:
        """Whether none of the usual quantities is of the place of the arm that a definition names."""
        arm = self.names.arm
        assert arm is not None
        frames, last = {each.frame for each in usual}, {arm.frames[-1], numbered_frames(arm)[-1]}
        if which == TOOL:
            return frames.isdisjoint(last)
        if which == LINK:
            return number in arm.frames and number not in frames
        return (which == INNER or (which == WRIST and self.has_hand())) and frames <= last


def unless_of_valueless(names: Names, outcome: Outcome) -> Outcome:
    r"""Leave open what is decided by a name that a display equates to what has no value: it may not be what it usually is.

    By \dot x_e behind x_e = x_d - x; and by x behind x = e c_1 - q_3 s_1 under the same heading, where nobody knows e.
    """
    valueless = names.state.without_value.keys() - names.quantities.keys() - {key for key, _ in names.state.usual}
    if not valueless or outcome.verdict not in DECIDED:
        return outcome
    for name in (each for node in (*outcome.nodes, *outcome.conditions) for each in n.names(node)):
        key = name.undotted.key
        if key in valueless and (name.dots or (outcome.role is not Role.LAW and _is_by_convention(names, name))):
            return outcome.left_open(say(Kind.FOLLOWS_FROM_DOUBT, name=key, line=names.state.without_value[key][0]))
    return outcome


def _is_by_convention(names: Names, name: n.Name) -> bool:
    """Whether convention alone gives a name a meaning here, and the display that has none for it stands under a heading around."""
    _, section = names.state.without_value[name.key]
    is_taken = name.key in names.state.conventional or (is_usual(name) and names.is_open(name))
    return is_taken and encloses(section, names.state.section)


def _components(index: str) -> list[str]:
    return [f"{index}{comma}{axis}" for comma in ("", ",") for axis in "xyz"] if index else list("xyz")


def _is(name: n.Name, told: n.Name) -> bool:
    """Whether a name is the one that the text tells, or one of those that it tells by a running index."""
    is_coordinate = told.base in "pPO" and name.base in "xyzXYZ" and bool(told.sub) and name.sub == told.sub
    if name.key == told.key or is_coordinate or (name.base == told.base and name.sub in _components(told.sub)):
        return True
    is_any = bool(_RUNNING.fullmatch(told.sub)) and name.sub.isdigit()
    return is_any and replace(name, sub=told.sub).key == told.key
