r"""Values that a text gives to joints in words, "with the second joint at 90°": `\text{joint 2} = 90^\circ` between displays."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from armproof.verification.patterns import regex

_BEGIN = r"\text{joint "  # and the joint's number, "last" or "all"
_VALUE = regex(re.escape(_BEGIN) + r"(?:\d|last|all)\} = ")
_ORDINALS = {
    "1": "first|premier|première", "2": "second|deuxième|seconde?", "3": "third|troisième", "4": "fourth|quatrième", "5": "fifth|cinquième",
    "6": "sixth|sixième", "last": "last|dernier|dernière", "all": "both|all|all the|(?:les )?deux|toutes les",
}  # fmt: skip
_HELD = r"held|kept|set|fixed|locked|blocked|clamped|turned|maintenue?s?|fixée?s?|bloquée?s?"
_AT_VALUE = regex(
    rf"\b(?:(?P<which>{'|'.join(_ORDINALS.values())}) (?:joints?|axes|axis|motors?|articulations?|liaisons?|axes?|moteurs?|one)"
    r"|(?:joint|axis|motor|articulation|axe) (?P<number>\d))"
    rf"(?: (?:is|are|being|est|sont|étant))?(?: (?:{_HELD}))? (?:at|to|by|à)"
    r" (?:(?P<zero>zero|zéro|0)|(?P<degrees>[-–−]?\d+(?:[.,]\d+)?) ?(?:°|degrees?\b|degrés?\b|deg\b))(?!\w)",
    re.IGNORECASE,
)


def joint_values(text: str) -> Iterator[str]:
    """Yield the values that a text on one line gives to joints in words, each as an equation."""
    for found in _AT_VALUE.finditer(text):
        number = found["number"] or _number_of(found["which"])
        degrees = re.sub("[–−]", "-", found["degrees"] or "").replace(",", ".")
        yield f"{_BEGIN}{number}}} = " + (rf"{degrees}^\circ" if degrees else "0")


def without_joint_values(text: str) -> str:
    """Return a text with blanks in the place of the values that it gives to joints in words."""
    return _AT_VALUE.sub(lambda found: " " * len(found.group()), text)


def is_joint_value(latex: str) -> bool:
    """Whether what stands between displays is the value of a joint in words; "joint is prismatic" tells a kind and no value."""
    return _VALUE.match(latex) is not None


def in_letters(latex: str, joints: Sequence[str]) -> list[str]:
    """Return the value of a joint in words as equations of the joints' own letters; none where the arm has no such joint."""
    which, _, value = latex.removeprefix(_BEGIN).partition("}")
    places = range(len(joints)) if which == "all" else [len(joints) - 1 if which == "last" else int(which) - 1]
    return [joints[place] + value for place in places if 0 <= place < len(joints)]


def _number_of(ordinal: str) -> str:
    return next(each for each, words in _ORDINALS.items() if re.fullmatch(words, ordinal, re.IGNORECASE))
