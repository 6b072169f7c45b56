"""Sentences that deny the display beside them, by what their clauses are of and the kinds of their words; `denials.py` asks.

What is wrong, or "not", denies where a clause is of the display or a part of it, unless what is denied says nothing of right and wrong:
"does not depend on". So does what people claim, what is to be changed, and "only" of what holds in all cases. A clause of the arm judges no display.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, takewhile

from armproof.verification.document.clauses import OF_DISPLAY, Clause, clauses, goes_on
from armproof.verification.patterns import regex

_FAR = 14  # words from a denial to the display that its sentence leads to
_LAST = 3  # words of a clause that lead to a display
_INSERTION = (
    "substituição",
    "substituições",
    "sustitución",
    "sustituciones",
    "sostituzione",
    "sostituzioni",
)  # of values
_PARTICIPLES = ("ing", "ando", "endo", "ant", "ed")  # "changing the frame" is no order
_NONE = frozenset(
    "no aucun aucune kein keine keinen keiner ningún ninguna nessun nessuna nessuno nenhum nenhuma".split()
)
_NOBODY = frozenset("nobody personne niemand nadie nessuno ninguém".split())
_BARE = frozenset(
    "this that it these c' ceci cela ça das dies es sie esto eso está ciò questo è isto isso".split()
)  # what is of the display, without a noun
_SHORT = 9  # words of a sentence that says little else
_OTHERS = frozenset(
    "another other different opposite autre autres andere anderer anderes otro otra altro altra".split()
)
_HERE = frozenset("here ici hier aquí qui aqui".split())
_HENCE = frozenset(
    "so thus hence therefore donc ainsi also daher folglich somit luego así quindi dunque pertanto portanto logo".split()
)
_IT = frozenset("it il es".split())
_TO = frozenset("to de d' zu".split())
_PROGRAMS = frozenset(
    "code program programme script simulation simulator firmware spreadsheet notebook programm skript simulationsprogramm programa código simulación programma codice simulazione".split()
)
_PROVIDED = frozenset(
    "provided providing as_long_as so_long_as pourvu à_condition tant_que sofern vorausgesetzt solange siempre_que purché finché desde_que contanto".split()
)  # what begins a condition, and says nothing of other cases
_IF_AND_ONLY_IF = frozenset(
    "if_and_only_if iff si_et_seulement_si genau_dann dann_und_nur_dann si_y_solo_si sí_y_solo_si se_e_solo_se se_e_somente_se se_e_só_se".split()
)
_ONLY_SINGULAR = regex(  # "so the only singularity is at": what it says of the arm denies no display
    r"(?<!\S)(?:the only|la seule|l' unique|les seules|die einzige|la única|l' unica) (?:singularit|singular (?:configuration|posture|position)|(?:configuration|position)s? singuli|singularidad)"
)
_AND = frozenset("and et und y e ed sowie & plus".split())
_THE = frozenset("the l' la le der die den das el il lo o a".split())
_NEAR = 2  # words between which two are of one noun
_FEW = 3  # words of a clause in which its subject stands
_LEADS = frozenset(
    ["claim", "have", "use", "that", "think", "good"]
)  # kinds of a word that a display follows: "we do not have"


def denies_what_is_above(words: str) -> bool:
    """Whether a sentence denies the display that it stands behind; one that begins with "if" is of another case."""
    found = clauses(words)
    if words.endswith("? "):
        return any(finds_fault_in(each) and each.subject == "this" for each in found)
    if not found or leads_on(words) or found[0].begins("erratum"):
        return False
    if found[0].begins("if") and words[:1].isupper() and (found[0].subject != "this" or found[0].has("pronoun")):
        return False
    if len(found[0].words) == 1 and found[0].begins("not"):
        return True  # "No, …"
    may_limit = goes_on(words) and not _is_consequence(words, found[0])
    return (may_limit and any(map(_is_exclusive, found))) or any(map(_denies_above, found))


def judges_in_other_words(words: str) -> bool:
    """Whether little but a pronoun is said of a display, in words of no kind that is known: "This is a lie", "Not even close".

    What such words say is not understood, and may be that it is wrong.
    """
    found = clauses(words)
    if len(found) != 1 or not words.endswith((". ", "! ")):
        return False
    said = [kinds - {"language", "article", "query", "of"} for kinds in found[0].kinds[1:]]
    if len(found[0].words) > _SHORT or any(said):
        return False
    is_of_this = found[0].words[0] in _BARE and len(said) > 1
    return is_of_this or (found[0].begins("not") and len(said) in (1, _NEAR))


def finds_fault_with_another(words: str) -> bool:
    """Whether all that a sentence finds fault with, behind a display, is something else than that: "Your code forgot the 90°.", "A common mistake is to forget it.".

    What is there may still be meant: a display that is wrong is no claim.
    """
    found = clauses(words)
    denying = [each for each in found if _denies_above(each)]
    is_exclusive = goes_on(words) and any(map(_is_exclusive, found))
    goes_for_both = any(each.has("same") and each.has("display") for each in found) or " so does " in words
    return bool(denying) and not (is_exclusive or goes_for_both) and all(map(_is_fault_of_another, denying))


def _is_fault_of_another(clause: Clause) -> bool:
    is_of_program = not _PROGRAMS.isdisjoint(clause.words[:_FEW])
    is_common = clause.begins("article", "old") and _is_common_fault(clause)
    is_of_people = clause.subject == "person" and not (clause.has("claim") or _ends_with_its_fault(clause))
    is_of_another = is_of_program or is_common or is_of_people
    return finds_fault_in(clause) and (_is_of_a_deed(clause) or (is_of_another and not clause.has("this", "display")))


def _is_common_fault(clause: Clause) -> bool:
    """Whether a fault is called a common one: "A common mistake is", and not "The index of the last term is wrong", "a typical error."."""
    place = min(clause.at("error"), clause.at("fault"))
    return not clause.ends("error", "fault") and any(
        "old" in each for each in clause.kinds[max(0, place - _NEAR) : place]
    )


def _ends_with_its_fault(clause: Clause) -> bool:
    """Whether people find a fault that is known of: "The attentive reader will have spotted the mistake"."""
    return len(clause.words) > 1 and clause.ends("error", "fault") and clause.words[-2] in _THE


def _is_of_a_deed(clause: Clause) -> bool:
    """Whether what is wrong is to do something else than to claim: "It is a mistake to divide by the radius"."""
    place = next((at for at, word in enumerate(clause.words) if word in _TO and at > clause.at("fault")), None)
    is_it = clause.words[0] in _IT
    return (
        is_it
        and place is not None
        and not any(each & {"claim", "use", "display", "think"} for each in clause.kinds[place:])
    )


def _is_consequence(words: str, first: Clause) -> bool:
    """Whether a sentence says what follows for the arm, "so the arm loses rank only when it is folded", or leads to what does: "The slide moves at most by"."""
    leads = words[:1].isupper() and first.begins("article") and words.rstrip()[-1:] not in ".;!?"
    hence = words.split()[0].lower() in _HENCE
    return (first.subject == "arm" and (leads or hence)) or (hence and _ONLY_SINGULAR.search(words.lower()) is not None)


def leads_on(words: str) -> bool:
    """Whether a sentence leads to the next display, and is of nothing above: "A common error is to write"."""
    found = clauses(words)
    if not found:
        return False
    is_over = words.rstrip()[-1:] in ".;!?"
    if words[:1].isupper() and _is_common_error(found[0]) and not is_over:
        return True
    is_of_it = any(each.ends("this", "display") or each.begins("this") or _HERE & {*each.words} for each in found)
    if is_of_it or found[0].is_of_display or not words[:1].isupper():
        return words.endswith(": ") and not found[0].is_of_display
    claims = any("claim" in kinds for kinds in found[-1].kinds[-_LAST:])
    return words.endswith((": ", ", ")) or (claims and not is_over)


def _is_common_error(clause: Clause) -> bool:
    """Whether a clause is of a common error, and prints it: "A common error is to write ¤, which would give"."""
    printed = clause.words[-1] == "¤" and len(clause.kinds) > 1 and "claim" in clause.kinds[-2]
    return printed and clause.has("error") and clause.has("old")


def denies_what_is_below(words: str) -> bool:
    """Whether a sentence denies the display that it leads to."""
    found = clauses(words)
    if not found or found[0].begins("erratum"):
        return False
    near = [each for place, each in enumerate(found) if sum(len(later.words) for later in found[place + 1 :]) < _FAR]
    is_wrong = any(finds_fault_in(each) or _is_of_old_edition(each) or _is_quoted(each) for each in near)
    if is_wrong and not found[-1].has("remedy"):
        return True
    is_only = (found[0].begins("only") or found[-1].ends("only")) and _is_exclusive(found[0])
    return is_only or any(_denies_below(each) or _is_to_be_changed(each) for each in _leading(found))


def denies_beside(words: str) -> bool:
    """Whether words in a display say that something is wrong, or not right."""
    return any(map(_is_judged, clauses(words)))


def denies_as_heading(words: str) -> bool:
    """Whether a heading says that something is wrong; what is left out, or stands twice, may be what it is about."""
    return any(map(_is_judged_in_heading, clauses(words)))


def lists_mistakes(words: str) -> bool:
    """Whether a heading is of another thing, and, joined to that by "and", of mistakes."""
    said = words.lower().split()
    joins = [place for place, word in enumerate(said) if word in _AND]
    if not joins or not any(each.has("fault", "error") for each in clauses(_sentence(said[joins[-1] + 1 :]))):
        return False
    before = clauses(_sentence(said[: joins[-1]]))
    return bool(before) and not any(each.has("fault", "error", "lost", "not") for each in before)


def _sentence(said: Sequence[str]) -> str:
    return "".join(f"{word} " for word in said)


def _is_judged_in_heading(clause: Clause) -> bool:
    if clause.has("error") and clause.subject in ("part", "person", "display"):
        return True  # "Sign errors", and not "Tracking error"
    is_plain = any("fault" in kinds and "lost" not in kinds for kinds in clause.kinds)
    return _is_judged(clause) and (is_plain or not clause.has("lost"))


def _is_judged(clause: Clause) -> bool:
    return finds_fault_in(clause) or (clause.has("not") and clause.has("good", "that"))


def finds_fault_in(clause: Clause) -> bool:
    """Whether a clause has a word for what is wrong, and no "not" before it."""
    place = min(clause.at("fault"), clause.at("error"))
    is_lost = clause.has("lost") and clause.has("letter", "part")
    has_fault = clause.has("fault") or is_lost or (clause.has("error") and _is_slip(clause))
    return has_fault and _not_in(clause) >= min(place, clause.at("lost"))


def _not_in(clause: Clause) -> int:
    """Return the place of "not" in a clause, in French that of the "ne" before its "pas"."""
    place = clause.at("not")
    return next((at for at, word in enumerate(clause.words[:place]) if word in ("ne", "n'")), place)


def _is_slip(clause: Clause) -> bool:
    """Whether an error is one of the pen, and not the error of a position."""
    is_found = clause.has("contains", "old", "display", "ask") or clause.ends("claim")
    return is_found or clause.subject == "person" or (clause.subject == "this" and clause.ends("error"))


def _leading(found: Sequence[Clause]) -> Sequence[Clause]:
    """Return the last clause of a sentence, with those that lead to it by "that"."""
    led = len([*takewhile(lambda each: each.is_led_to, reversed(found))])
    return found[-led - 1 :]


def _denies_above(clause: Clause) -> bool:
    if clause.subject == "arm":
        is_lost = clause.has("lost") and not clause.is_led_to
        return is_lost or (clause.has("not") and _is_of_this_at_its_end(clause))
    if finds_fault_in(clause) or _is_quoted(clause) or _is_to_be_changed(clause) or _tells_what_is_right(clause):
        return True
    is_of_it = clause.is_of_display or (clause.subject == "person" and clause.has(*OF_DISPLAY))
    if clause.has("turned") and clause.has("part") and (clause.ends("this", "display") or _HERE & {*clause.words}):
        return True  # "The sign is flipped in this line"
    is_mended = clause.has("differs") and is_of_it and not clause.has("if", "where")
    return is_mended or (clause.has("not") and _is_denied(clause))


def _is_denied(clause: Clause) -> bool:
    """Whether "not" in a clause denies the display: all it can say of that, but what is neither right nor wrong."""
    if clause.has("good") or (clause.at("not") <= 1 and clause.has("use") and clause.ends("this", "display")):
        return True  # "Do not use this formula"
    if clause.words[0] in _NOBODY and clause.ends("this", "display"):
        return True  # "Nobody can prove this"
    if clause.has("neutral") or clause.begins("there") or (clause.has("use") and not clause.has("must")):
        return False
    if clause.begins("not") and clause.has("if"):
        return False  # "none if it is negative"
    if clause.begins("not") and clause.subject in ("part", "letter"):
        return len(clause.words) > _LAST  # "and not its sign", but "not the cosine of the second angle"
    is_not_counted = clause.subject == "letter" and clause.has("counted")
    return clause.is_of_display or is_not_counted or _is_of_this_at_its_end(clause)


def _is_of_this_at_its_end(clause: Clause) -> bool:
    """Whether a clause ends with the display: "We do not support this result"."""
    return clause.has("this") and clause.ends("this", "display") and not clause.ends("pronoun")


def _is_quoted(clause: Clause) -> bool:
    """Whether a clause says that people claim the display: those of the text are not among them."""
    of_people = clause.subject == "person" or (clause.is_of_display and clause.has("person"))
    return of_people and clause.has("claim", "not") and not clause.has("must", "neutral") and "¤" not in clause.words


def _is_of_old_edition(clause: Clause) -> bool:
    """Whether a clause is of an old edition, or a common answer: what stood there is not what holds."""
    beside = (first | then for first, then in pairwise(clause.kinds))
    return any({"edition", "old"} <= each for each in beside) and not clause.has("must")


def _is_to_be_changed(clause: Clause) -> bool:
    """Whether a clause says, or orders, that the display or a part of it is replaced."""
    is_too = clause.has("same") and not clause.has("this", "part", "letter")  # "Other versions should work, too"
    if not clause.has("change") or is_too or clause.at("not") < clause.at("change"):
        return False  # "We will not need the other entries"
    if not clause.has("must"):
        first = clause.words[0]
        is_order = clause.begins("change") and not first.endswith(_PARTICIPLES) and first not in (*_OTHERS, *_INSERTION)
        return is_order and clause.has("letter", *OF_DISPLAY) and not clause.has("claim")
    if clause.subject == "writer":
        return clause.has(*OF_DISPLAY)
    return clause.is_of_display or clause.subject == "" or (clause.subject == "letter" and not clause.has("counted"))


def _tells_what_is_right(clause: Clause) -> bool:
    """Whether a clause is of the right formula, and so of another than that above it: "The correct equation has a minus sign"."""
    if clause.subject != "display" or clause.has("this"):
        return False
    place = clause.at("display")
    return any({"remedy", "good"} <= each for each in clause.kinds[max(0, place - 1) : place + 2])


def _denies_below(clause: Clause) -> bool:
    """Whether the clause that leads to a display denies it: "not", or what people say or would, or one might think."""
    if (clause.has("not") and _is_not_so(clause)) or (clause.begins("avoid") and clause.has("claim", "use", "display")):
        return True
    of_people = clause.has("person") and clause.subject not in ("part", "letter", "arm", "formula")
    claims = clause.has("claim", "would") or clause.ends("have")
    return clause.has("think") or (of_people and claims and not clause.has("must"))


def _is_not_so(clause: Clause) -> bool:
    """Whether "not" in the clause that leads to a display denies that, and not something of the arm."""
    is_order = clause.subject == "" and clause.at("not") <= _NEAR and clause.has("use", "claim")
    if is_order or clause.ends(*_LEADS) or (clause.ends("query") and not clause.is_led_to):
        return True
    if clause.has("neutral") or (clause.begins("not") and clause.subject in ("part", "letter")):
        return False
    is_of_arm = clause.subject == "arm" and clause.at("not") < len(clause.words) - 1
    if clause.words[clause.at("not")] in _NONE and (is_of_arm or clause.ends("part", "letter")):
        return False  # "The speed has no mixed term", "This arm has no vertical slide"
    is_of_other = clause.subject in ("arm", "formula", "") or clause.begins("there")
    ends_so = (
        clause.subject in ("arm", "formula")
        and not (clause.begins("not") or clause.ends("pronoun") or clause.has("there"))
        and len(clause.words) - clause.at("not") <= _LAST
    )
    return ends_so or clause.has("must") or not is_of_other


def _is_exclusive(clause: Clause) -> bool:
    """Whether a clause says that something holds in a case only: a display that holds in all is denied, but for one that is so "provided" something holds."""
    if not _PROVIDED.isdisjoint(clause.words[:1]):
        return False
    if not _IF_AND_ONLY_IF.isdisjoint(clause.words[:1]):
        return True
    return clause.has("only") and (clause.has("if", "of") or clause.begins("only")) and not clause.has("neutral")
