r"""Angles up to multiples: θ = 0 [π], θ ≡ π (2π), θ = 0 \pmod{2π} are read as θ = 0 + kπ; of 0, π, … the first are all, every character at its place."""

from __future__ import annotations

import re

from armproof.verification.patterns import regex

_GAP = r"(?:\\[,;:! ]|\\q?quad(?![A-Za-z])|~|\s)*"
_PI = r"(?:\\pi(?![A-Za-z])|π)"
_MODULUS = rf"(?:\d{{0,2}}\s*{_PI}(?:\s*/\s*\d)?|\\[dt]?frac\s*\{{\s*\d{{0,2}}\s*{_PI}\s*\}}\s*(?:\{{\s*\d\s*\}}|\d))"
_WORD = r"\\(?:text|textrm|mathrm|mbox|rm|operatorname)\s*\{?\s*mod(?:ulo)?\.?\s*\}?"
_CONSTANT = rf"(?P<constant>\s*(?:-|\\pm(?![A-Za-z]))?\s*(?:0|{_MODULUS}))"
_END = r"(?=\s*(?:[.,;&)\]]|\\\\|\Z|\\(?:q?quad|text|mbox|iff|implies|lor|vee|land|wedge|end|hbox|[,;: ]|(?:Left|Right|Leftright|Long|left|right)[a-z]*arrow)))"
_CONGRUENT = regex(
    rf"(?<![<>])(?:(?P<equal>=)|\\(?:equiv|cong)(?![A-Za-z])|≡){_CONSTANT}(?P<gap>{_GAP})"
    rf"(?P<modulus>\[\s*(?P<square>{_MODULUS})\s*\]|\(\s*(?P<round>{_MODULUS})\s*\)|\\pmod\s*(?:\{{\s*(?P<braced>{_MODULUS})\s*\}}|(?P<pi>\\pi(?![A-Za-z])))"
    rf"|\\(?:mod|bmod)(?![A-Za-z])\s*\{{?\s*(?P<bare>{_MODULUS})\s*\}}?|\({_GAP}{_WORD}{_GAP}(?P<said>{_MODULUS}){_GAP}\)"
    rf"|\[{_GAP}{_WORD}{_GAP}(?P<told>{_MODULUS}){_GAP}\]|{_WORD}{_GAP}(?P<spoken>{_MODULUS})){_END}"
)
_DEGREES = r"\s*(?:°|\^\s*\{?\s*\\circ\s*\}?)"
_TURNS = rf"(?:\\pm\s*)?(?:\d?\s*{_PI}|(?:360|540|720){_DEGREES})"
_AND_SO_ON = regex(  # 0, π, …: what goes on are whole turns more
    rf"(?P<listed>=\s*0(?:{_DEGREES})?\s*,\s*(?:\\pm\s*)?(?:{_PI}|180{_DEGREES})(?:\s*,\s*{_TURNS})*)(?P<dots>\s*,\s*(?:\\(?:[lc]?dots|dotsc)(?![A-Za-z])|…|\.\.\.))"
)
_BESIDE = regex(rf"(?<=[\w)}}\]])(?P<gap>{_GAP})(?P<last>\\[,;:! ]|[\s~])(?=\[\s*{_MODULUS}\s*\]{_END})")


def with_multiples(text: str) -> str:
    """Return a display with the integer multiples of π or 2π that its congruences mean, as long as it was.

    Behind what is no constant a modulus stands beside the equation.
    """
    text = _AND_SO_ON.sub(lambda found: found["listed"] + " " * len(found["dots"]), text)
    if "\\pi" not in text and "π" not in text:
        return text
    letter = next((each for each in "knm" if re.search(rf"(?<![A-Za-z\\]){each}(?![A-Za-z])", text) is None), "k")
    text = _CONGRUENT.sub(lambda found: _multiple(found, letter), text)
    return _BESIDE.sub(lambda found: found["gap"] + ";".ljust(len(found["last"])), text)


def _multiple(found: re.Match[str], letter: str) -> str:
    modulus = next(
        filter(None, (found[name] for name in ("square", "round", "braced", "pi", "bare", "said", "told", "spoken")))
    )
    digits, rest = re.fullmatch(r"(\d*\s*)(.*)", modulus, re.DOTALL).groups()  # type: ignore[union-attr]
    start = found.start("modulus") - found.start()
    return found.group()[:start] + f"+{digits.strip()}{letter}{rest}".ljust(len(found.group()) - start)
