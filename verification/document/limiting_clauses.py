"""Sentences that limit the display beside them, by what their clauses are of and the kinds of their words; `sentences.py` asks.

A condition or a circumstance limits unless it is general, and so does what is neglected, supposed or held, another frame, or angles that are
not those between links. What limits leaves a wrong display open. "If we add both" is no condition, and one in a formula is decided elsewhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from armproof.verification.document.clauses import OF_DISPLAY, Clause, clauses, goes_on, says_what_would_be

_PLANE = frozenset("planar planaire plan eben ebener planare plano".split())
_WHOLE = frozenset("full complete whole entire complète complet vollständige komplette completa completo".split())
_ARTICLES = frozenset("the la le die das der il".split())
_AND = frozenset("and et und y e ed".split())
_WHICH_IS = ("which is : ", "which are : ")
_SHORT = 4  # words of "Discuss it.", with its stop


def limits_what_is_above(words: str) -> bool:
    """Whether a sentence says of the display that it stands behind when, or how nearly, that holds, or asks for it."""
    found = clauses(words)
    leads_on = words[:1].isupper() and not words.endswith((". ", "? ", "! "))
    if not found or leads_on:
        return False
    asks = found[0].begins("ask") and any(each.has("good", "if", *OF_DISPLAY) for each in found)
    asks = asks or (words.endswith("? ") and any(each.has("good", "fault", "error") for each in found))
    is_condition = (goes_on(words) and _is_condition(found[0]) and not _leads_to_another(words, found[0])) or (
        found[0].begins("near") and found[0].subject != "writer"
    )
    says_when = any(_says_that_it_holds(each) and _is_condition(then) for each, then in pairwise(found))
    return asks or is_condition or says_when or _is_supposed(found) or any(map(_limits_above, found))


def limits_what_is_below(words: str) -> bool:
    """Whether a sentence says of the display that it leads to in what case, or how nearly, it holds, or asks for it."""
    found = clauses(words)
    if not found:
        return False
    asks = found[0].begins("ask") and not (found[-1].ends("that") or any(each.is_led_to for each in found))
    is_asked = words[:1].isupper() and (
        (found[0].begins("query", "instead") and not _only_leads(words)) or any(each.has("inverted") for each in found)
    )
    would = says_what_would_be(words, at_its_end=True) and not is_whole(words)
    return asks or is_asked or would or _is_supposed(found) or any(map(_limits_below, found))


def _leads_to_another(words: str, first: Clause) -> bool:
    """Whether "and for the height" stands between two displays: that is of the one that it leads to, and no condition of the one above."""
    return words.partition(" ")[0] in _AND and not words.endswith((". ", "? ", "! ")) and first.begins("of")


def _only_leads(words: str) -> bool:
    """Whether "Which is:" leads to a display, and asks nothing."""
    return words.lower() in _WHICH_IS


def is_whole(words: str) -> bool:
    """Whether a sentence of one clause leads to all of what stands in part before: "The full Jacobian would be"."""
    found = clauses(words)
    if len(found) != 1 or found[0].has("person"):
        return False
    return [each in one for each, one in zip(found[0].words, (_ARTICLES, _WHOLE), strict=False)] == [True, True]


def limits_what_is_near(words: str) -> bool:
    """Whether a sentence that leads to no display limits those near it."""
    found = clauses(words)
    is_asked = bool(found) and found[0].begins("ask") and words.count(" ") <= _SHORT and found[0].has("this")
    return is_asked or _is_supposed(found) or any(map(_limits_near, found))


def _is_supposed(found: Sequence[Clause]) -> bool:
    """Whether a sentence supposes what may not be so: rigid links and known lengths are, and what a formula says is decided elsewhere."""
    for place, each in enumerate(found):
        what = [each, *(then for then in found[place + 1 : place + 2] if then.is_led_to)]
        if each.has("suppose") and not any(part.has("given", "formula", "general") for part in what):
            return True
    return False


def _limits_near(clause: Clause) -> bool:
    """Whether a clause says, beside whatever display, that something is neglected, supposed or held, or in another frame."""
    if clause.has("not"):
        return False
    if _gives_other_angles(clause):
        return True
    is_local = clause.has("inside") and clause.has("frame") and clause.has("local") and not clause.has("base")
    is_of_arm = clause.subject in ("arm", "letter", "writer") or (clause.begins("of") and clause.has("arm", "letter"))
    is_planar = clause.subject == "arm" and not _PLANE.isdisjoint(
        clause.words
    )  # what it moves in it moves in everywhere
    is_limited = (clause.has("neglect") and not is_planar) or is_local or (clause.has("held") and is_of_arm)
    return is_limited and not clause.has("general")


def _gives_other_angles(clause: Clause) -> bool:
    """Whether a clause says that angles are not those between links: the first is none, and an absolute one may equal a formula."""
    is_other = clause.has("absolute") or (clause.has("angle") and clause.has("level") and not clause.has("first"))
    return is_other and not clause.ends("formula")


def _limits_above(clause: Clause) -> bool:
    if _limits_near(clause):
        return True
    if not clause.is_of_display or clause.has("general", "neutral"):
        return False
    behind = clause.kinds[clause.at("good") + 1 :]
    is_bound = any(each & {"if", "of"} and "with" not in each for each in behind)
    return is_bound or clause.has("only", "case", "would")


def _limits_below(clause: Clause) -> bool:
    if _limits_near(clause):
        return True
    if clause.has("general"):
        return False
    if (clause.begins("only") and not clause.has("neutral") and not clause.ends("if")) or (
        clause.begins("of") and (clause.has("case") or clause.ends("only"))
    ):
        return True
    if "¤" in clause.words or clause.has("given"):
        return False
    return clause.begins("near") or (clause.begins("if") and clause.subject not in ("writer", "person"))


def _is_condition(clause: Clause) -> bool:
    """Whether a clause is a condition in words, and not in a formula."""
    if clause.has("general", "neutral", "given") or "¤" in clause.words:
        return False
    return clause.begins("if", "only") or (clause.begins("of") and not clause.begins("with", "inside"))


def _says_that_it_holds(clause: Clause) -> bool:
    """Whether a clause says of the display that it holds: "This is true", "It holds"."""
    return clause.is_of_display and (clause.has("good") or len(clause.words) <= 3)
