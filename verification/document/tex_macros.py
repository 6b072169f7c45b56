r"""The author's own macros in LaTeX: expanded a bounded number of times."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

from armproof.verification.document.model import Piece
from armproof.verification.patterns import regex

MOST_EXPANSIONS = 500  # in one display
LONGEST = 50_000  # characters of a display
_BOUNDARY = regex(r"\s*\\(begin|end)\s*\{(\w+\*?)\}\s*")
NEAR = 400  # characters within which most braces are closed
_BRACE = regex(r"\\.|[{}]", re.DOTALL)
_USE = regex(r"\\(?:begin|end)\s*\{\w+\*?\}|\\[A-Za-z]+")
Place = Callable[[int], tuple[int, int]]


@dataclass(frozen=True)
class Macro:
    """A macro: how many arguments it takes, the first one's default, and its body with #1, #2, …

    `delimiters` is what stands between the arguments of a macro that is called as \\C(x); it holds from offset `begin` to `end`,
    where its group is closed.
    """

    arguments: int
    default: str | None
    body: str
    delimiters: str = ""
    begin: int = -1
    end: int | None = None

    def holds_at(self, offset: int) -> bool:
        """Whether it is defined at a place of the file."""
        return self.begin <= offset and (self.end is None or offset < self.end)


@dataclass(frozen=True)
class _Character:
    """A character of an expanded display and the part of the file that it comes from, as offsets."""

    text: str
    start: int
    end: int


class Macros:
    """The macros of a document, each with its definitions in order."""

    def __init__(self, macros: Mapping[str, Sequence[Macro]]) -> None:
        self.macros = macros
        self._boundaries = {
            name: (found.group(1), found.group(2))
            for name, (*_, macro) in macros.items()
            if not macro.arguments and (found := _BOUNDARY.fullmatch(macro.body)) is not None
        }

    def opens(self, name: str) -> str | None:
        r"""Return the environment that a macro opens: \be for \begin{equation}."""
        boundary = self._boundaries.get(name)
        return boundary[1] if boundary is not None and boundary[0] == "begin" else None

    def closings(self, environment: str) -> str:
        """Return the pattern of what closes an environment."""
        names = [name for name, boundary in self._boundaries.items() if boundary == ("end", environment)]
        own = "|".join(re.escape(name) + "(?![A-Za-z])" for name in names)
        return rf"\\end\s*\{{{re.escape(environment)}\}}" + (f"|{own}" if own else "")

    def expanded(self, latex: str, offset: int, place: Place) -> tuple[str, tuple[Piece, ...]]:
        """Return a display with its macros expanded, and the places of its parts; `offset` is where it stands.

        What expands for ever, or past all bounds, is left as it stands.
        """
        used = any(_plain(found) in self.macros for found in _USE.finditer(latex))
        characters = [_Character(c, offset + k, offset + k + 1) for k, c in enumerate(latex)]
        characters = (_expand(self.at(offset), characters) or characters) if used else characters
        text = "".join(c.text for c in characters)
        return text, _pieces(characters, place)

    def at(self, offset: int) -> dict[str, Macro]:
        """Return what each macro is at a place: its last definition before, or the first behind."""
        holding = {name: [each for each in defined if each.holds_at(offset)] for name, defined in self.macros.items()}
        return {name: (holding[name] or defined[:1])[-1] for name, defined in self.macros.items()}


def _expand(macros: Mapping[str, Macro], characters: list[_Character]) -> list[_Character] | None:
    for _ in range(MOST_EXPANSIONS):
        text = "".join(c.text for c in characters)
        if len(text) > LONGEST:
            return None
        use = next((found for found in _USE.finditer(text) if _plain(found) in macros), None)
        if use is None:
            return characters
        replaced = _replaced(macros[_plain(use)], text, characters, use)
        if replaced is None:
            return None
        characters = replaced
    return None


def _replaced(macro: Macro, text: str, characters: list[_Character], use: re.Match[str]) -> list[_Character] | None:
    """Return the characters with one use of a macro replaced by its body; None where its arguments are not all there."""
    end = use.end()
    arguments: list[list[_Character]] = []
    if macro.delimiters:
        literals = map(re.escape, re.split(r"#\d", macro.delimiters))
        called = re.compile(r"\s*" + r"([^\n]{0,300}?)".join(literals)).match(text, end)
        if called is None:
            return None
        arguments, end = [characters[slice(*called.span(k + 1))] for k in range(macro.arguments)], called.end()
    if macro.default is not None:
        optional = re.compile(r"\s*\[([^\]]*)\]").match(text, end)
        here = characters[use.start()]
        if optional:
            arguments.append(characters[slice(*optional.span(1))])
            end = optional.end()
        else:
            arguments.append([_Character(c, here.start, here.end) for c in macro.default])
    while len(arguments) < macro.arguments:
        span = _argument(text, end)
        if span is None:
            return None
        arguments.append(characters[slice(*span[:2])])
        end = span[2]
    whole = (characters[use.start()].start, characters[end - 1].end)
    if not macro.arguments and text[end : end + 1] == " ":
        end += 1  # the blank that ends a command's name
    body = _filled(macro.body, arguments, whole)
    if text[end : end + 1].isalpha() and re.search(r"\\[A-Za-z]+$", macro.body):
        body.append(_Character(" ", *whole))
    return [*characters[: use.start()], *body, *characters[end:]]


def _plain(use: re.Match[str]) -> str:
    return re.sub(r"\s", "", use.group())


def blank(text: str) -> str:
    """Return blanks for a text, its lines kept."""
    return re.sub(r"[^\n]", " ", text)


def closing_brace(text: str, opening: int) -> int:
    """Return the place of the brace that closes the one at `opening`, or -1."""
    depth = 0
    for found in _BRACE.finditer(text, opening, opening + NEAR):
        depth += {"{": 1, "}": -1}.get(found.group(), 0)
        if depth == 0 and found.group() == "}":
            return found.start()
    return _far_braces(text).get(opening, -1)


@lru_cache(maxsize=4)
def _far_braces(text: str) -> dict[int, int]:
    """Return where each brace that opens is closed: of a text with thousands that are open, all are looked for at once."""
    partners: dict[int, int] = {}
    opened: list[int] = []
    for found in _BRACE.finditer(text):
        if found.group() == "{":
            opened.append(found.start())
        elif found.group() == "}" and opened:
            partners[opened.pop()] = found.start()
    return partners


def _argument(text: str, position: int) -> tuple[int, int, int] | None:
    """Return where an argument begins and ends, and the place behind it: a group, a command or one character."""
    while position < len(text) and text[position].isspace():
        position += 1
    if position >= len(text):
        return None
    if text[position] == "{":
        close = closing_brace(text, position)
        return None if close < 0 else (position + 1, close, close + 1)
    command = re.compile(r"\\(?:[A-Za-z]+|.)", re.DOTALL).match(text, position)
    end = command.end() if command else position + 1
    return position, end, end


def _filled(body: str, arguments: Sequence[list[_Character]], whole: tuple[int, int]) -> list[_Character]:
    filled: list[_Character] = []
    for found in re.finditer(r"#(\d)|.", body, re.DOTALL):
        if found.group(1) and int(found.group(1)) <= len(arguments):
            argument = arguments[int(found.group(1)) - 1]
            if argument and argument[0].text.isalpha() and re.search(r"\\[A-Za-z]+$", body[: found.start()]):
                filled.append(_Character(" ", *whole))  # \lVert#1 of x is no \lVertx
            filled.extend(argument)
        else:
            filled.append(_Character(found.group(), *whole))
    return filled


def _pieces(characters: Sequence[_Character], place: Place) -> tuple[Piece, ...]:
    """Return the parts that stand in the file as they are, line by line, and what macros stand for, as wholes."""
    pieces: list[Piece] = []
    k = 0
    while k < len(characters):
        first, start = characters[k], k
        k += 1
        if first.text == "\n" and first.end == first.start + 1:
            continue
        if first.end == first.start + 1:
            while k < len(characters) and characters[k].text != "\n" and _follows(characters[k - 1], characters[k]):
                k += 1
            pieces.append(Piece(start, k - start, *place(first.start)))
            continue
        while k < len(characters) and (characters[k].start, characters[k].end) == (first.start, first.end):
            k += 1
        pieces.append(Piece(start, k - start, *place(first.start), end=place(first.end)))
    return tuple(pieces)


def _follows(a: _Character, b: _Character) -> bool:
    return b.start == a.end and b.end == b.start + 1
