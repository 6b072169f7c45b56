"""How the joints move where a display holds: at constant rates, "With the motors running evenly", or from rest, "while all joints stand still".

Then joint accelerations, or joint rates, are zero. What is said of one joint alone, or of the tool, says that of no others.
"""

from __future__ import annotations

from armproof.verification.document.hearing import hears, says
from armproof.verification.patterns import regex

EVEN, AT_REST = "motion even", "motion at rest"  # of the display that the sentence leads to
_HEARD = {EVEN: "EVEN_RATES", AT_REST: "NO_RATES"}
SINCE = "since "  # before either: of those behind it in its section, perhaps

MAY_TELL_MOTION = regex(  # what no such sentence lacks, in small letters
    r"constan|konstan|costan|unifor|stead|evenly|gleichf|gleichm|gleichbl|\brest\b|repos|ruhe|still|fermo|\bnil\b|zero|zéro|cero|null|nul[ao]|vanish|starting|démarr|motionless|immobil"
)
_FEW = 4  # words that lead to what is said of a motion: "In the instant in which"


def told_motion(words: str) -> str:
    """Return how a sentence has all joints move, EVEN or AT_REST; "" of one that tells neither, or both."""
    small = words.lower()
    if not MAY_TELL_MOTION.search(small) or hears("OF_OTHER_MOTION", small):
        return ""
    found = [motion for motion, name in _HEARD.items() if says(name, words)]
    return found[0] if len(found) == 1 else ""


def without_motion(words: str) -> str:
    """Return the words of a sentence without what they say of the motion of all joints: that is no case that nobody knows."""
    motion = told_motion(words)
    found = hears(_HEARD[motion], words) if motion else None
    if found is None:
        return words
    before, behind = words[: found.start()], words[found.end() :].removeprefix(", ")
    return behind if len(before.split()) <= _FEW else before + behind


def may_tell_motion(words: str) -> bool:
    """Whether a sentence says of something that it moves evenly or not at all, of what joints ever."""
    return MAY_TELL_MOTION.search(words.lower()) is not None and any(
        says(name, words) for name in ("EVEN_RATES", "NO_RATES", "EVENLY")
    )
