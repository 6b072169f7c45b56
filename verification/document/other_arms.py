"""Arms of which a sentence is, by their number of joints or their type: "For the SCARA robot we find", "the formula of the three-link arm".

Whether that is another arm than the document's, `is_other_arm` tells, which knows its joints.
"""

from __future__ import annotations

import re

from armproof.models.arm import Arm
from armproof.verification.patterns import regex

OF_ARM = "of the arm"  # with a number of joints, or a type

_NUMBERS = {
    word: number
    for number, words in enumerate(
        [
            "two deux zwei dos due dois 2",
            "three trois drei tres tre três 3",
            "four quatre vier cuatro quattro quatro 4",
            "five cinq fünf cinco cinque 5",
            "six sechs seis sei 6",
            "seven sept sieben siete sette sete 7",
        ],
        start=2,
    )
    for word in words.split()
}
_NUMBER = rf"({'|'.join(_NUMBERS)})"
_TYPE = r"(scara|cartesian|cartésien|cartesiano|kartesischen?|gantry|cylindrical|cylindrique|cilíndrico|cilindrico|delta|stanford)"
_ARM = r"(?:arm|robot|manipulator|bras|manipulateur|roboter|brazo|manipulador|braccio|manipolatore|braço|robô)"
_JOINTS = r"(?:links|joints|segments|axes|liaisons|articulations|eslabones|ejes|articulaciones|bracci|assi|giunti|elos|eixos|juntas|gelenken|achsen)"
_PLAIN = r"(?:planar |plan |spatial |serial )?"
_ARMS = regex(
    rf"(?<!\S)(?:{_NUMBER}[ -](?:link|joint|axis|dof|bar) {_PLAIN}{_ARM}|{_NUMBER}r {_PLAIN}{_ARM}|{_ARM} {_PLAIN}{_NUMBER}r"
    rf"|{_ARM} {_PLAIN}(?:with|of|à|a|con|com|de|mit) {_NUMBER} {_JOINTS}|{_TYPE}[ -]{_ARM}|{_ARM} {_TYPE}) ",
    re.IGNORECASE,
)
_OF = regex(  # what stands before an arm of which a sentence is
    r"(?<!\S)(?:for|of|describes|concerns|pour|de|du|d'|décrit|concerne|für|des|der|bei|beim|beschreibt|para|del|describe|per|descrive|do|descreve)"
    r" (?:(?:the|a|an|our|this|le|un|den|das|dem|einen|einem|el|il|uno|o|um) )?\Z",
    re.IGNORECASE,
)
_COMPARED = regex(
    r"(?<!\S)(?:as|like|unlike|than|same|similar\w*|analog\w*|compar\w*|also|too|not|comme|même|aussi|contrairement|pas|wie|auch|anders|nicht|como|igual|también|come|anche|também) ",
    re.IGNORECASE,
)


def arms_named(words: str) -> list[str]:
    """Return the numbers of joints and the types of the arms of which a sentence is; none where it compares."""
    if compares(words):
        return []
    found = [each for each in _ARMS.finditer(words) if _OF.search(words[: each.start()])]
    return [next(filter(None, each.groups())).lower() for each in found]


def compares(words: str) -> bool:
    """Whether a sentence speaks of an arm to compare with it: "as for the planar arm"."""
    return _COMPARED.search(words) is not None


def is_other_arm(named: str, arm: Arm) -> bool:
    """Whether an arm has not the number of joints, or cannot be of the type, that a text names."""
    if named in _NUMBERS:
        return _NUMBERS[named] != len(arm.joints)
    kinds = [joint.kind for joint in arm.joints]
    turning, sliding = kinds.count("revolute"), kinds.count("prismatic")
    if named.startswith(("cart", "kart", "gantry")):
        return turning > 0 and sliding < turning + 1
    return {"scara": turning < 2 or not sliding, "delta": True}.get(named, not sliding)
