r"""The conditionals of TeX: \iffalse … \fi, \if0 … \else … \fi, the switches of \newif, each within another.

A switch is followed from its \newif on. What else decides a conditional, a macro or a package, is not known here.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from armproof.verification.document.tex_definitions import places_of_definitions
from armproof.verification.document.tex_macros import blank
from armproof.verification.patterns import regex

_MARK = regex(
    r"\\newif\s*\\if(?P<new>[A-Za-z]+)|\\let\s*\\if(?P<let>[A-Za-z]+)\s*=?\s*\\if(?P<as>true|false)(?![A-Za-z])"
    r"|\\(?:(?:re)?new|provide)command\*?\s*\{?\s*\\if(?P<own>[A-Za-z]*)|\\def\s*\\if(?P<defined>[A-Za-z]*)"
    r"|\\if(?P<opens>[A-Za-z]*)(?P<test>(?<=\\if)\s*[0-9A-Za-z](?:[0-9A-Za-z]|\s)|(?<=\\ifnum)\s*\d+\s*[<=>]\s*\d+(?:\s|(?=\D)))?"
    r"|\\(?P<turns>else|or|fi)(?![A-Za-z])|\\(?P<switch>[A-Za-z]+?)(?P<value>true|false)(?![A-Za-z])|\\.|(?P<brace>[{}])",
    re.DOTALL,
)
_NO_CONDITIONAL = frozenset("f star thenelse".split())  # \iff, and what takes groups
_NUMBERS = regex(r"\s*(\d+)\s*([<=>])\s*(\d+)")
_GROUP = regex(r"\s*\{")


@dataclass
class _Open:
    """A conditional that is open: where its branch at hand began and what that is (None: nobody here knows)."""

    begin: int
    branch: int
    prints: bool | None


@dataclass
class Branches:
    r"""What conditionals leave of a text: `hidden` does not print, `unclear` may not; a text never closes some of them.

    `follows`: whether the switches of \newif are followed, which may be set in another file.
    """

    follows: bool = True
    hidden: list[tuple[int, int]] = field(default_factory=list)
    unclear: list[tuple[int, int]] = field(default_factory=list)
    switches: dict[str, bool | None] = field(default_factory=dict)
    own: set[str] = field(default_factory=set)  # macros of the author's own that are called as conditionals are
    stack: list[_Open] = field(default_factory=list)
    depth: int = 0
    bodies: list[tuple[int, int]] = field(default_factory=list)  # of macros, last first

    def read(self, text: str) -> Branches:
        """Read a text; the switches that were set before stay so."""
        self.stack, self.depth = [], 0
        self.bodies = places_of_definitions(text)[::-1] if "\\if" in text else []
        for found in _MARK.finditer(text) if "\\if" in text or "\\newif" in text else ():
            if found["brace"]:
                self.depth += 1 if found["brace"] == "{" else -1
            elif found["turns"]:
                self._turn(found)
            elif found["opens"] is not None:
                self._enter(found, text)
            else:
                self._set(found)
        return self

    def _enter(self, found: re.Match[str], text: str) -> None:
        name = found["opens"]
        takes_groups = name not in self.switches and _GROUP.match(text, found.end()) is not None
        if name in _NO_CONDITIONAL or name in self.own or takes_groups:
            return
        while self.bodies and self.bodies[-1][1] <= found.start():
            self.bodies.pop()
        is_in_body = bool(self.bodies) and self.bodies[-1][0] < found.start()
        self.stack.append(_Open(found.start(), found.end(), self._decided(name, found["test"], is_in_body)))

    def _decided(self, name: str, test: str | None, is_in_body: bool) -> bool | None:
        """Return what a conditional comes to; in the body of a macro a switch is what it will be where that is used."""
        if name in ("true", "false"):
            return name == "true"
        if test is None:
            return self.switches.get(name) if self.follows and not is_in_body else None
        if (found := _NUMBERS.match(test)) is not None:
            left, right = int(found[1]), int(found[3])
            return {"<": left < right, "=": left == right, ">": left > right}[found[2]]
        pair = test.lstrip()
        return pair[0] == pair[1]

    def _turn(self, found: re.Match[str]) -> None:
        if not self.stack:
            return
        last = self.stack[-1]
        if last.prints is None:
            self.unclear.append((last.branch, found.start()))
        elif last.prints:
            self.hidden += [(last.begin, last.branch), found.span()]
        else:
            self.hidden.append((last.begin, found.end()))
        if found["turns"] == "fi":
            self.stack.pop()
        else:
            last.begin, last.branch = found.span()
            last.prints = None if last.prints is None else not last.prints

    def _set(self, found: re.Match[str]) -> None:
        r"""Follow \newif\ifold, \oldtrue and \let\ifold\iftrue, where they are not skipped."""
        if (own := found["own"] or found["defined"]) is not None:
            self.own.add(own)
        name = found["new"] or found["let"] or found["switch"]
        if name is None or any(each.prints is False for each in self.stack):
            return
        is_new = found["new"] is not None or found["let"] is not None
        if not is_new and name not in self.switches:
            return
        value = (found["as"] or found["value"]) == "true"
        is_sure = (
            self.depth <= 0 and all(each.prints for each in self.stack) and self.switches.get(name, True) is not None
        )
        self.switches[name] = value if is_sure else None


def without_branches(text: str, packages: str = "", follows: bool = True) -> tuple[str, list[tuple[int, int]]]:
    """Return a text with what its conditionals hide blank, as long as it was, and the stretches that may not print."""
    switches = Branches().read(packages).switches if packages else {}
    branches = Branches(follows, switches=switches).read(text)
    letters = list(text)
    for begin, end in branches.hidden:
        letters[begin:end] = blank(text[begin:end])
    return "".join(letters), branches.unclear
