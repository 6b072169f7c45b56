"""What a sentence says of the display beside it, by what its clauses are of and the kinds of their words: that it is denied, or limited.

"Not" denies unless what it denies says nothing of right and wrong ("does not depend on"); "only", conditions and circumstances limit
unless they are general. A clause of the arm judges no display. `denials.py` and `sentences.py` ask.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, takewhile

from armproof.verification.document.clauses import Clause, clauses

_OF_DISPLAY = ("this", "display", "part")
_FAR = 14  # words from a denial to the display that its sentence leads to
_LAST = 4  # words of a clause that lead to a display
_PARTICIPLES = ("ing", "ando", "endo", "ant", "ed")
_SHORT = 8  # words of what goes on from a display, and says little else than when it holds


def denies_what_is_above(words: str) -> bool:
    """Whether a sentence denies the display that it stands behind."""
    found = clauses(words)
    if not found or words.endswith("? "):
        return False
    is_of_another_case = found[0].begins("if") and not words[:1].islower() and found[0].subject not in _OF_DISPLAY
    if is_of_another_case:
        return False
    goes_on = words[:1].islower() or words.count(" ") <= _SHORT
    return (goes_on and any(map(_is_exclusive, found))) or any(map(_denies_above, found))


def denies_what_is_below(words: str) -> bool:
    """Whether a sentence denies the display that it leads to."""
    found = clauses(words)
    near = [each for place, each in enumerate(found) if sum(len(later.words) for later in found[place + 1 :]) < _FAR]
    is_wrong = any(_finds_fault(each) or _is_of_old_edition(each) or _is_quoted(each) for each in near)
    if is_wrong and not found[-1].has("remedy"):
        return True
    return any(_denies_below(each) or _is_to_be_changed(each) for each in _leading_clauses(found))


def limits_what_is_above(words: str) -> bool:
    """Whether a sentence says of the display that it stands behind when, or how nearly, that holds, or asks for it."""
    found = clauses(words.lower())
    if not found:
        return False
    if words[:1].isupper() and not words.endswith((". ", "? ", "! ")):
        return False  # it leads to what comes next
    asks = found[0].begins("ask") and any(each.has("good", "if", *_OF_DISPLAY) for each in found)
    goes_on = words[:1].islower() or words.count(" ") <= _SHORT
    if asks or (goes_on and _is_condition(found[0])):
        return True
    says_when = any(_says_that_it_holds(each) and _is_condition(then) for each, then in pairwise(found))
    return says_when or any(_limits_above(each) for each in found)


def limits_what_is_below(words: str) -> bool:
    """Whether a sentence says of the display that it leads to in what case, or how nearly, it holds, or asks for it."""
    found = clauses(words)
    if not found:
        return False
    asks = found[0].begins("ask") and not any(each.is_led_to for each in found) and "that" not in found[-1].kinds[-1]
    is_conditional = found[-1].has("would") or (words[:1].isupper() and found[0].begins("query", "instead"))
    return asks or is_conditional or any(map(_limits_below, found))


def limits_what_is_near(words: str) -> bool:
    """Whether a sentence that is over says that something is left out, supposed or held, or gives angles another meaning."""
    return any(_gives_other_angles(each) or (_limits_everywhere(each) and not each.has("general")) for each in clauses(words))


def _leading_clauses(found: Sequence[Clause]) -> Sequence[Clause]:
    """Return the last clause of a sentence, with those that lead to it by "that"."""
    led = len([*takewhile(lambda each: each.is_led_to, reversed(found))])
    return found[-led - 1 :]


def _is_of_display(clause: Clause) -> bool:
    return clause.subject in _OF_DISPLAY


def _finds_fault(clause: Clause) -> bool:
    """Whether a clause has a word for what is wrong, and no "not" before it."""
    place = min(clause.at("fault"), clause.at("error"))
    has_fault = clause.has("fault") or (clause.has("error") and _is_error_of_display(clause))
    return has_fault and clause.at("not") >= place


def _is_error_of_display(clause: Clause) -> bool:
    """Whether an error is one of the pen, and not the error of a position."""
    is_found = clause.has("contains", "old", "display", "ask") or "claim" in clause.kinds[-1]
    return is_found or clause.subject in ("this", "person")


def _denies_above(clause: Clause) -> bool:
    if clause.subject == "arm":
        return clause.has("lost") or (clause.has("not") and "this" in clause.kinds[-1])
    if _finds_fault(clause) or _is_quoted(clause) or _is_to_be_changed(clause) or _tells_what_is_right(clause):
        return True
    if _is_of_display(clause) and clause.has("differs"):
        return True
    return clause.has("not") and _is_denied(clause)


def _is_denied(clause: Clause) -> bool:
    """Whether "not" in a clause denies the display: all it can say of that, but what is neither right nor wrong."""
    if clause.has("good"):
        return True
    if clause.has("calm"):
        return False
    if clause.begins("there"):
        return False
    is_short = clause.subject == "" and len(clause.words) <= 2
    return _is_of_display(clause) or is_short or "this" in clause.kinds[-1] or (clause.subject == "letter" and clause.has("done"))


def _is_quoted(clause: Clause) -> bool:
    """Whether a clause says that people claim the display: those of the text are not among them."""
    of_people = clause.subject == "person" or (_is_of_display(clause) and clause.has("person"))
    return of_people and clause.has("claim", "not") and not clause.has("must", "calm") and "¤" not in clause.words


def _is_of_old_edition(clause: Clause) -> bool:
    return clause.has("edition") and clause.has("old") and not clause.has("must")


def _is_to_be_changed(clause: Clause) -> bool:
    """Whether a clause says, or orders, that the display or a part of it is replaced."""
    if not clause.has("change"):
        return False
    if clause.has("must"):
        return clause.subject in (*_OF_DISPLAY, "") or (clause.subject == "letter" and not clause.has("done"))
    is_order = clause.begins("change") and not clause.words[0].endswith(_PARTICIPLES)
    return is_order and clause.has("letter", *_OF_DISPLAY) and not clause.has("claim")


def _tells_what_is_right(clause: Clause) -> bool:
    """Whether a clause is of the right formula, and so of another than that above it: "The correct equation has a minus sign"."""
    if clause.subject != "display" or clause.has("this"):
        return False
    place = clause.at("display")
    return any("remedy" in each and "good" in each for each in clause.kinds[max(0, place - 1) : place + 2])


def _denies_below(clause: Clause) -> bool:
    """Whether the clause that leads to a display denies it: "not", or what people say or would, or one might think."""
    ends = clause.kinds[-_LAST:]
    if clause.has("not"):
        is_at_its_end = any("not" in each for each in ends)
        leads = not ends[-1].isdisjoint({"claim", "use", "that", "think", "good"})
        is_of_other = clause.subject in ("arm", "formula", "") or clause.begins("there")
        if leads or (not clause.has("calm") and (is_at_its_end or not is_of_other)):
            return True
    if clause.begins("avoid") and clause.has("claim", "use", "display"):
        return True
    of_people = clause.has("person") and clause.subject in ("person", "display", "this", "")
    return clause.has("think") or (of_people and clause.has("claim", "would") and not clause.has("must"))


def _is_exclusive(clause: Clause) -> bool:
    """Whether a clause says that something holds in a case only: a display that holds in all is denied."""
    is_case = any(not each.isdisjoint({"if", "of"}) for each in clause.kinds) or clause.begins("only")
    return clause.has("only") and is_case and not clause.has("calm")


def _says_that_it_holds(clause: Clause) -> bool:
    return _is_of_display(clause) and (clause.has("good") or len(clause.words) <= 3)


def _is_condition(clause: Clause) -> bool:
    """Whether a clause is a condition in words: one in a formula is decided elsewhere."""
    if clause.has("general", "calm", "given") or "¤" in clause.words:
        return False
    return clause.begins("if", "only") or (clause.begins("of") and not clause.begins("with", "inside"))


def _limits_above(clause: Clause) -> bool:
    if _gives_other_angles(clause):
        return True
    if clause.has("general"):
        return False
    if _limits_everywhere(clause):
        return True
    if not _is_of_display(clause) or clause.has("calm"):
        return False
    behind = clause.kinds[clause.at("good") + 1 :]
    is_bound = any(each & {"if", "of"} and "with" not in each for each in behind) and "¤" not in clause.words
    return is_bound or clause.has("only", "case", "would")


def _limits_everywhere(clause: Clause) -> bool:
    """Whether a clause says, beside whatever display, that something is left out, supposed or held, or in another frame."""
    if clause.has("not"):
        return False
    if clause.has("near", "suppose"):
        return True
    is_local = clause.has("inside") and clause.has("frame") and clause.has("local") and not clause.has("base")
    return is_local or (clause.has("fix") and clause.subject in ("arm", "letter", "writer"))


def _gives_other_angles(clause: Clause) -> bool:
    """Whether a clause says that angles are not those between links; the absolute angle that equals a formula is what it is."""
    is_other = clause.has("twist") or (clause.has("angle", "formula") and clause.has("level"))
    return is_other and not clause.has("not") and clause.words[-1] != "¤"


def _limits_below(clause: Clause) -> bool:
    if _gives_other_angles(clause):
        return True
    if clause.has("general"):
        return False
    if _limits_everywhere(clause) or clause.begins("only"):
        return True
    if clause.begins("if"):
        return clause.subject not in ("writer", "person") and not clause.has("given") and "¤" not in clause.words
    return clause.begins("of") and clause.has("case")
