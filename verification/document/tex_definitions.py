r"""What an author defines in LaTeX: commands by `\newcommand`, `\def` and their like, environments, names for others."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from armproof.verification.document.tex_macros import Macro, Macros, blank, closing_brace
from armproof.verification.patterns import regex

_NAME = r"\s*(?:\{\s*(?P<braced>\\[A-Za-z]+)\s*\}|(?P<plain>\\[A-Za-z]+))\s*"
_COMMAND = regex(
    rf"\\(?P<kind>(?:(?:re)?new|provide)command|DeclareRobustCommand|(?:New|Renew|Provide|Declare)DocumentCommand|DeclareMathOperator|DeclarePairedDelimiter)\*?{_NAME}"
    r"(?:\[(?P<count>\d)\]\s*)?(?:\[(?P<default>[^\]]*)\]\s*)?(?=\{)"
    r"|\\def\s*(?P<defined>\\[A-Za-z]+)(?P<parameters>[^{}\\\n]{0,80})(?=\{)"
    r"|\\let\s*(?P<let>\\[A-Za-z]+)\s*=?\s*(?P<meaning>\\[A-Za-z]+)"
    r"|\\(?:re)?newenvironment\*?\s*\{\s*(?P<environment>\w+\*?)\s*\}\s*(?:\[(?P<size>\d)\]\s*)?(?:\[(?P<first>[^\]]*)\]\s*)?(?=\{)"
)
_GROUP = regex(
    r"(?P<opens>\\begin(?:group)?(?![A-Za-z])|\\bgroup(?![A-Za-z])|\{)"
    r"|(?P<closes>\\end(?:group)?(?![A-Za-z])|\\egroup(?![A-Za-z])|\})|\\.",
    re.DOTALL,
)
_PARAMETERS = regex(r"(?:O\{(?P<default>[^{}]*)\})?(?P<plain>[m\s]*)")


def places_of_definitions(text: str) -> list[tuple[int, int]]:
    """Return where the definitions in a text begin and end."""
    places: list[tuple[int, int]] = []
    position = 0
    while (found := _COMMAND.search(text, position)) is not None:
        position = _bodies(text, found)[1]
        places.append((found.start(), position))
    return places


def find_macros(text: str, packages: str = "") -> tuple[Macros, str]:
    """Return the macros that a text and its packages define, and the text with their definitions blank."""
    macros: dict[str, list[Macro]] = {}
    for source in (packages, text):
        letters = list(source)
        position = 0
        while (found := _COMMAND.search(source, position)) is not None:
            bodies, position = _bodies(source, found)
            if not found["let"] and not bodies:
                continue
            begin = position if source is text else -1
            for name, macro in _macros(found, bodies):
                if not ((found["kind"] or "").lower().startswith("provide") and name in macros):
                    macros.setdefault(name, []).append(replace(macro, begin=begin))
            letters[found.start() : position] = blank(source[found.start() : position])
        blanked = "".join(letters)
    several = {name: found for name, found in macros.items() if len(found) > 1}
    ends = _ends_of_groups(text, {each.begin for found in several.values() for each in found if each.begin >= 0})
    scoped = {
        name: [replace(each, end=ends.get(each.begin, each.end)) for each in found] for name, found in several.items()
    }
    return Macros({**macros, **scoped}), blanked


def _ends_of_groups(text: str, places: Iterable[int]) -> dict[int, int]:
    """Return where the groups end in which some places stand, of those that do, all in one pass."""
    waiting, depth = sorted(places, reverse=True), 0
    inside: list[tuple[int, int]] = []  # how deep the group of a place is
    ends: dict[int, int] = {}
    for found in _GROUP.finditer(text) if waiting else ():
        while waiting and waiting[-1] <= found.start():
            inside.append((depth, waiting.pop()))
        depth += 1 if found["opens"] else -1 if found["closes"] else 0
        while inside and depth < inside[-1][0]:
            ends[inside.pop()[1]] = found.start()
    return ends


def _bodies(text: str, found: re.Match[str]) -> tuple[list[str], int]:
    """Return the groups of a definition and where the last one ends."""
    has_two = found["environment"] or found["kind"] == "DeclarePairedDelimiter"
    return _groups(text, found.end(), 2 if has_two or (found["kind"] or "").endswith("DocumentCommand") else 1)


def _groups(text: str, position: int, count: int) -> tuple[list[str], int]:
    """Return the groups in braces that stand at a place and where the last one ends; none where they are not all there."""
    start, groups = position, []
    for _ in range(count):
        opened = re.compile(r"\s*\{").match(text, position)
        close = closing_brace(text, opened.end() - 1) if opened else -1
        if opened is None or close < 0:
            return [], start
        groups.append(text[opened.end() : close])
        position = close + 1
    return groups, position


def without_unprinted(text: str, macros: Macros) -> str:
    r"""Return a text with the arguments blank that macros do not print, as long as it was: \newcommand{\hide}[1]{}."""
    names = [name for name, defined in macros.macros.items() if name[1:].isalpha() and any(map(_unprinted, defined))]
    letters = list(text)
    for found in re.finditer(rf"(?:{'|'.join(map(re.escape, names))})(?![A-Za-z])", text) if names else ():
        macro = macros.at(found.start())[found.group()]
        position = _behind_option(text, found.end()) if macro.default is not None else found.end()
        for number in range(1 + (macro.default is not None), macro.arguments + 1):
            groups, end = _groups(text, position, 1)
            if not groups:
                break
            begin, position = end - 1 - len(groups[0]), end
            if number in _unprinted(macro):
                letters[begin : end - 1] = blank(groups[0])
    return "".join(letters)


def _unprinted(macro: Macro) -> list[int]:
    """Return the arguments of a macro that its body does not name."""
    if macro.delimiters:
        return []
    return [number for number in range(1, macro.arguments + 1) if f"#{number}" not in macro.body]


def _behind_option(text: str, position: int) -> int:
    option = re.compile(r"\s*\[[^\]]*\]").match(text, position)
    return option.end() if option else position


def _macros(found: re.Match[str], bodies: list[str]) -> Iterator[tuple[str, Macro]]:
    """Yield what one definition defines."""
    name, kind = found["braced"] or found["plain"] or "", found["kind"] or ""
    if found["let"]:
        yield found["let"], Macro(0, None, found["meaning"])
    elif found["environment"]:
        yield f"\\begin{{{found['environment']}}}", Macro(int(found["size"] or 0), found["first"], bodies[0])
        yield f"\\end{{{found['environment']}}}", Macro(0, None, bodies[1])
    elif found["defined"]:
        parameters = found["parameters"].strip()
        called = "" if re.fullmatch(r"(?:#\d\s*)*", parameters) else parameters
        yield found["defined"], Macro(parameters.count("#"), None, bodies[0], called)
    elif kind == "DeclareMathOperator":
        yield name, Macro(0, None, rf"\operatorname{{{bodies[0]}}}")
    elif kind == "DeclarePairedDelimiter":
        yield name, Macro(1, None, rf"\left{bodies[0]} #1 \right{bodies[1]}")
    elif kind.endswith("DocumentCommand"):
        if taken := _PARAMETERS.fullmatch(bodies[0].strip()):
            default = taken["default"]
            yield name, Macro(taken["plain"].count("m") + (default is not None), default, bodies[1])
    else:
        yield name, Macro(int(found["count"] or 0), found["default"], bodies[0])
