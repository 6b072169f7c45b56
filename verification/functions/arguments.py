"""How a function takes the joint values: as one vector, one by one, by name; and which lengths it takes."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import ArmproofError, Sentence

_ANGLES, _SLIDES = ("theta", "th", "t", "q"), ("d", "q", "r")


class ArgumentError(ArmproofError):
    """A function takes other arguments than joint values and lengths."""


@dataclass(frozen=True)
class Layout:
    """The arguments of a function.

    Attributes:
        joints: the joint symbols in the order of the arm.
        by_name: the parameter for each joint symbol that the function names; empty where it names none.
        vector: whether the joint values are one vector.
        lengths: the parameter for each length symbol that the function takes.
        defaults: the default value of those lengths that have one.
    """

    joints: tuple[str, ...]
    by_name: Mapping[str, str]
    vector: bool
    lengths: Mapping[str, str]
    defaults: Mapping[str, Any]

    def arguments(self, values: Callable[[str], Any], lengths: Iterable[str]) -> tuple[list[Any], dict[str, Any]]:
        """Return positional and named arguments, each made from the name of its symbol.

        Args:
            lengths: the symbols of the lengths that are passed; of the others the function has defaults.
        """
        named = {self.lengths[symbol]: values(symbol) for symbol in lengths}
        joints = [values(symbol) for symbol in self.joints]
        if self.by_name:
            taken = {self.by_name[s]: v for s, v in zip(self.joints, joints, strict=True) if s in self.by_name}
            return [], {**taken, **named}
        if not self.vector:
            return joints, named
        is_float = all(isinstance(value, float) for value in joints)
        return [np.array(joints, dtype=float if is_float else object)], named


def constants_of(arm: Arm) -> dict[str, float]:
    """Return the lengths (m) and the constant angles (rad) of an arm."""
    return {**arm.lengths, **arm.angles}


def read_layout(arm: Arm, function: Callable[..., Any]) -> Layout:
    """Return how a function takes the joint values and lengths of an arm.

    It takes one vector q, or n joint values; parameters named like lengths of the arm (a_1, a1, A1) take those.

    Raises:
        ArgumentError: it takes neither.
    """
    symbols = tuple(joint.symbol for joint in arm.joints)
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):  # a function written in C
        return Layout(symbols, {}, True, {}, {})
    lengths: dict[str, str] = {}
    defaults: dict[str, Any] = {}
    others = []
    for parameter in parameters:
        symbol = next((name for name in constants_of(arm) if _bare(name) == _bare(parameter.name)), None)
        if symbol is not None and parameter.kind in (parameter.POSITIONAL_OR_KEYWORD, parameter.KEYWORD_ONLY):
            lengths[symbol] = parameter.name
            if parameter.default is not parameter.empty:
                defaults[symbol] = parameter.default
        else:
            others.append(parameter)
    return Layout(symbols, *_joint_parameters(arm, function, others), lengths, defaults)


def _joint_parameters(
    arm: Arm, function: Callable[..., Any], parameters: list[inspect.Parameter]
) -> tuple[dict[str, str], bool]:
    """Return the parameter of each joint, where they are named, and whether they are one vector."""
    n = len(arm.joints)
    plain = [p for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY)]
    required = [p for p in plain if p.default is p.empty]
    named = {
        joint.symbol: p.name for joint in arm.joints for p in plain if _names_joint(p.name, joint.symbol, joint.kind)
    }
    positional_only = any(p.kind is p.POSITIONAL_ONLY for p in plain)
    if len(set(named.values())) == n > 1 and set(named.values()) >= {p.name for p in required} and not positional_only:
        return named, False
    some = {name for name in named.values() if name not in ("q", "x")}
    if required and {p.name for p in required} <= some and len(some) == len(named) and not positional_only:
        return named, False
    positional = [p for p in plain if p.kind is not p.KEYWORD_ONLY]
    if len(required) == n > 1 and len([p for p in required if p in positional]) == n:
        return {}, False
    one_joint_of_many = n > 1 and required and any(_names_joint(required[0].name, j.symbol, j.kind) for j in arm.joints)
    if len(required) <= 1 and positional and (not required or required[0] is positional[0]) and not one_joint_of_many:
        return {}, True
    if not required and any(p.kind is p.VAR_POSITIONAL for p in parameters):
        return {}, False
    names = ", ".join(p.name for p in required) or Sentence("no argument")
    known = ", ".join(constants_of(arm))
    lengths = Sentence(" (and, by their names, lengths: {known})", known=known) if known else ""
    raise ArgumentError("{function} takes {names}; it is to take one vector q, or the {n} joint values {joints}{lengths}",
        function=getattr(function, "__name__", Sentence("the function")), names=names, n=n, joints=[joint.symbol for joint in arm.joints], lengths=lengths)  # fmt: skip


def _bare(name: str) -> str:
    return name.replace("_", "").lower()


def _names_joint(name: str, symbol: str, kind: str) -> bool:
    if _bare(name) == _bare(symbol):
        return True
    found = re.fullmatch(r"([a-z]+)(\d+)", _bare(name))
    index = re.search(r"\d+$", symbol)
    letters = _ANGLES if kind == "revolute" else _SLIDES
    return found is not None and index is not None and found[1] in letters and found[2] == index[0]
