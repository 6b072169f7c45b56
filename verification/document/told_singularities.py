r"""Sentences that say where an arm is singular, and end there: "The arm is singular if", "Les positions singulières sont donc celles où le bras est tendu :"."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import FORMULA, STOP
from armproof.verification.patterns import regex

SINGULAR = r"\text{singular}"  # what is said right before conditions of singularities
SINGULAR_TOO = r"\text{singular there, too}"  # and that there are others, of which the formulas before it tell
SINGULAR_ALONE = r"\text{singular there alone}"  # and that there are no others
SINGULAR_AMONG = r"\text{singular there, and elsewhere}"  # of one kind, or one place of several
VANISHES = r"\text{zero there}"  # that what stands above is zero there: the arm is singular if that is the determinant
TOLD_SINGULAR = (SINGULAR, SINGULAR_TOO, SINGULAR_ALONE, SINGULAR_AMONG, VANISHES)

_PLACE = r"(?:configuration|position|posture|pose)s?"
_ARM = r"(?:arm|leg|bras|jambe|manipulator|robot|mechanism|mécanisme|roboter|brazo|manipulador|braccio|manipolatore|braço|robô)"
_OF_ARM = rf"(?: (?:of|du|del|de la|des|dello) (?:the |this |a )?(?:planar |two-link )?(?:{_ARM}|Jacobian|jacobienne|jacobiano))?"
_JACOBIAN = r"(?:Jacobian|jacobienne|jacobiano|jacobiana|Jacobi-?Matrix)"
_OF_JACOBIAN = regex(
    r"\W*(?:\\(?:mathbf|boldsymbol|bm|mathrm)\W*)?J(?:\W*\((?:q|\\(?:theta|mathbf\{q\}|boldsymbol\{\w+\}))\))?\W*"
)
_DETERMINANT = rf"(?:(?:{_JACOBIAN} |jacobi-?)determinante?|déterminant de la (?:matrice )?{_JACOBIAN}|determinant of the {_JACOBIAN}(?: matrix)?)"
_ALSO = r"(?:also|aussi|auch|también|anche)"
_NOUGHT = r"(?:vanishes|(?:is|becomes|equals) (?:zero|0)|s['’]annule|est nul|vaut (?:zéro|0)|verschwindet|(?:ist|wird) (?:null|0)|se anula|si annulla)"
_ONLY = r"(?:(?:exactly|precisely|only|just|exactement|seulement|uniquement|genau dann|genau|nur|s[oó]lo|exactamente|solo) )"
_WHEN = (
    r"(?:when(?:ever)?|iff|if|where|lorsque|lorsqu['’]|quand|si|ssi|dès que|wenn|falls|cuando|quando|se)"
    r"(?: and only if| et seulement si| y s[oó]lo si| e solo se)?"
)
_WITH = r"(?:with|avec|con|mit|com)"
_WHERE = rf"(?:{_WHEN}|for|at|in|pour|für|bei|para|en|per)"
_ARE = (
    r"(?:are given by|is given by|(?:is|are) (?:obtained|reached|met)|est (?:obtenue|atteinte)|sont (?:obtenues|atteintes)|s['’]obtien(?:t|nent)|(?:wird|werden) (?:erreicht|angenommen)|se obtienen?|si ott(?:iene|engono)|are|is|(?:occurs?|arises?|appears?|lies?)|sont données? par|est donnée par|sont|est|(?:se produi(?:t|sent)|appara(?:ît|issent)|a lieu|ont lieu)"
    r"|sind|(?:liegt|liegen) vor|liegen|(?:tritt|treten) auf|ergeben sich|ist|son|es|ocurren?|sono|è)"
)
_THEN = r"(?:,? (?:then|thus|therefore|here|hence|donc|alors|also|daher|somit|por tanto|dunque|quindi|portanto),?)?"
_SINGULAR_WORD = r"(?:singular|singulier|singulière|singulär|singolare)"
_LOSES = (  # what the arm, J or its determinant do at a singularity
    rf"{_ARM}{_OF_ARM}{_THEN} (?:(?:is|becomes|gets|est|devient|ist|wird|es|è|é)(?: (?:in|at|dans|en))?(?: (?:a|une?))?(?: genau dann)?{_THEN} {_SINGULAR_WORD}(?: {_PLACE})?"
    rf"|est (?:dans|en) (?:une )?{_PLACE} singulière|loses (?:a|one) degree of freedom|perd un degré de liberté|pierde un grado de libertad|perde un grado di libertà|verliert (?:einen|seinen) freiheitsgrad)"
    rf"|{_JACOBIAN}(?: matrix)?{_THEN} (?:(?:is|becomes) (?:non-?invertible|not invertible|rank[ -]deficient|singular)(?: \(singular\))?|loses (?:its )?(?:full )?rank|(?:ist|wird) singulär|verliert (?:ihren |den )?(?:vollen )?rang|est singulière|es singular|è singolare)"
    rf"|{_DETERMINANT}{_THEN} {_NOUGHT}"
    rf"|(?:ist|wird|es|è|é) (?:der |die |das |el |il |o )?{_ARM}{_THEN} {_SINGULAR_WORD}|(?:es|è|é) {_SINGULAR_WORD} (?:el |il |o )?{_ARM}"
)
_NOUN = (
    rf"(?:(?:singularit(?:y|ies)|singularités?|singularidad(?:es)?|singolarità|singularität(?:en)?|singular {_PLACE}|{_PLACE} singulières?"
    r"|configuraci(?:ón|ones) singular(?:es)?|posici(?:ón|ones) singular(?:es)?|configurazion[ei] singolar[ei]|configuraç(?:ão|ões) singular(?:es)?|singuläre[nr]? (?:stellung|konfiguration|lage|position|pose|gelenkstellung)(?:en)?)"
    rf"{_OF_ARM})"
)
_THERE_IS = r"(?:there (?:is|are)|il y a|on a|hay|we have|one has|es gibt|c['’]è|ci sono|si ha|si hanno|se tienen?|existen?|on obtient|one finds|we find|we get)"
_THOSE = r"(?:those|that|the ones?|celles?|ceux|la|las|aquellas?|diejenigen?|die|quell[ae]) (?:with|where|in which|at which|for which|when|avec|où|pour lesquelles|con|donde|en las? que|en la cual|mit|(?:bei|in) (?:denen|der)|in cui)"
# what follows the place in words, "when it is stretched": a word that begins another clause is none of it
_NO_MORE = (
    r"(?:and|but|while|whereas|so|thus|hence|then|which|that|we|let|take|consider|choose|suppose|assume|say|like|as|such|example|instance|unless|because|since|for|when|if|where|with respect"
    r"|et|mais|tandis|alors|donc|qui|que|soit|prenons|comme|exemple|car|quand|lorsque|où"
    r"|und|aber|während|also|wir|etwa|wie|beispiel|weil|denn"
    r"|y|pero|mientras|entonces|como|ejemplo|porque|e|ma|mentre|come|esempio"
    r"|respect|rapport|respecto|rispetto|bezug|neglect\w*|ignor\w*|lock\w*|fixed|frozen|removed|small|equal|néglig\w*|bloqu\w*|égaux|égales|vernachlässig\w*|gesperrt|gleich|desprec\w*|fij\w*|iguales"
    r"|best|worst|radius|rayon|largest|smallest|farthest|nearest|maximal|minimal|near|close|almost|nearly|par|proche|presque|fast|nahe|casi|cerca|quasi|vicino)"
)
_IN_WORDS = rf"(?:,? (?!{_NO_MORE}\b)(?:[^\W\d_][\w'’-]*)){{1,12}}?"
_NAMELY = r"(?:,? (?:i\.\s?e\.|that is(?: to say)?|namely|in other words|c['’]est-à-dire|à savoir|autrement dit|d\.\s?h\.|das heißt|nämlich|es decir|o sea|cioè|ossia),?)"
_LEADS_ON = rf"(?:{_NAMELY}(?: {_WHERE})?|,? (?:for|at|pour|für|bei|para|per))?\s*[:,]?\s*\Z"


def _says(where: str) -> str:
    """Return the pattern of what leads to where the arm is singular, with the words that begin it."""
    return (
        rf"(?:(?:{_LOSES}),? {_ONLY}?{where}"
        rf"|(?:{_LOSES})[^.;:]{{1,60}}?,? (?:and |et |und |y )?{_ALSO}(?: \w+)?,? {where}"
        rf"|{_NOUN}{_THEN} {_ARE}(?:{_THEN} {_ONLY}?{where}|(?:{_THEN}| therefore| thus| donc| daher) {_THOSE})"
        rf"|{_NOUN}{_THEN} {_ONLY}?{where}"
        rf"|{_THERE_IS}{_THEN} (?:a |une |una |eine )?(?:\w+ )?{_NOUN},? {_ONLY}?{where}"
        rf"|{_NOUN},? (?:the|le|der|el|il) {_ARM} being(?: \w+){{1,4}},? {where})"
    )


_SINGULARITIES = regex(
    rf"\b(?:(?:{_says(_WHEN)}|(?:{_LOSES}),? {_WITH}|{_NOUN}\s*:){_IN_WORDS}|{_says(_WHERE)}|{_NOUN}{_THEN}(?:\s*:(?=\s*\Z)| {_ARE}(?: therefore| thus| donc| daher)?)){_LEADS_ON}",
    re.IGNORECASE,
)
_HAPPENS = regex(
    r"\b(?:this|that|it|which) (?:only )?(?:happens|occurs|is (?:so|the case))|\b(?:cela|ceci|ce qui) (?:n['’])?(?:se produit|arrive|a lieu)|\b(?:dies|das|was) (?:geschieht|passiert|ist der fall)|\b(?:esto|eso) (?:ocurre|sucede)",
    re.IGNORECASE,
)
_ENDS = regex(
    rf" {_ONLY}?{_WHERE}(?:{_IN_WORDS})?(?:(?: and)? (?:no|nowhere) (?:other|else))?{_NAMELY}?\s*[:,]?\s*\Z",
    re.IGNORECASE,
)
_AT_ITS_END = regex(rf"\b(?:{_LOSES})(?: {_WHERE}{_IN_WORDS})?[\s.]*\Z", re.IGNORECASE)
_NO_OTHER = regex(
    r",? (?:and )?(?:at |for |in )?(?:no other(?: \w+)?|nowhere else|none other|not elsewhere)\b|,? (?:et )?(?:nulle part ailleurs|aucune autre(?: \w+)?)\b|,? (?:und )?(?:nirgends sonst|sonst nirgends)\b",
    re.IGNORECASE,
)
_ALONE = regex(
    r"\b(?:if and only if|iff|exactly|precisely|only|just (?:when|for)|si et seulement si|ssi|exactement|seulement|uniquement|(?:la|les|le) seules?|genau dann|nur|einzige\w*|s[oó]lo|únic\w+|e solo se|exactamente)\b"
    rf"|\b{_THOSE}",
    re.IGNORECASE,
)
_ONE_WAY = regex(r"(?<!if and )\bonly if\b|(?<!si et )\bseulement si\b|(?<!si y )\bs[oó]lo si\b", re.IGNORECASE)
_DENIED = regex(
    r"\b(?:no|not|non|without|avoid\w*|away|except|unless|sans|hors|évit\w*|sauf|pas|sin|no hay|never|nor|neither|cannot|\w+n['’]t|hardly|nobody|jamais|aucune?|nunca|jamás|nie|niemals|kein\w*|nicht|far from|loin de|representation\w*|représentation\w*|algorithmic|constraint|euler|wrong\w*|false\w*|fals[oa]|falsch|faux)\b",
    re.IGNORECASE,
)
_OF_ONE_KIND = regex(  # of which there are others
    r"\b(?:shoulder|elbow|wrist|arm|boundary|interior|inner|internal|first|second|another|other|one) singularit|singularit\w+ (?:d['’](?:épaule|coude)|de (?:poignet|frontière)|del (?:codo|hombro))",
    re.IGNORECASE,
)
_HEAD = regex(rf"\b(?:{_LOSES}|{_NOUN})", re.IGNORECASE)
_TOO = regex(rf"\b{_ALSO}\b", re.IGNORECASE)
_BESIDE = regex(r"\s*\([^()]*\)")
_ASIDE = regex(  # "The singularities, for $d_3 > 0$, are", "The arm is singular, whatever $\\theta_1$ is, for"
    r",? (?:for|pour|para|für|with|avec|con|mit) ¤,"
    r"|,? (?:whatever|regardless of|independently of|for (?:any|all|every)|quels? que soi(?:t|ent)|quelles? que soi(?:t|ent)|unabhängig von|para cualquier|sea cual sea|qualunque sia|per ogni) (?:(?:the )?(?:value|values|valeur|valeurs) (?:of|de) )?¤(?:(?:,| and| et| und| y| e) ¤)*(?: (?:is|are|may be|takes?))?,?",
    re.IGNORECASE,
)
_EMPHASIS = regex(r"\\(?:emph|textbf|textit|underline|paragraph\*?)\s*\{([^{}]*)\}")
_LABEL = regex(  # a title, or a label: "Elbow singularity:", "Singularities."
    rf"(?:the |la |le |les |las |il |die )?(?:\w+ )?{_NOUN}(?: (?:of|du|de la|der|del) \w+)?\s*[.:]?", re.IGNORECASE
)
_IT_IS_NOUGHT = regex(  # "It vanishes for", "Le déterminant s'annule si": of what stands above
    r"(?:and |et |und |y |e )?(?:it|this|which|this expression|il|elle|ceci|celui-ci|cette expression|er|sie|esso|(?P<determinant>(?:this|the|ce|le|diese?|el|este|il|questo|o) d[eé]terminante?))"
    rf"(?: \(?¤\)?)?{_THEN} (?:(?:clearly|obviously|clairement|evidentemente) )?{_NOUGHT},? {_ONLY}?{_WHERE}{_LEADS_ON}",
    re.IGNORECASE,
)


def singularities_told(text: str) -> Iterator[str]:
    """Yield what the last sentence of a text says of the conditions behind it, if it does: SINGULAR, SINGULAR_TOO or SINGULAR_ALONE."""
    *before, last = STOP.split(_plain(" ".join(text.split())).strip(" *_"))
    sentence, is_alone = _NO_OTHER.subn("", last.strip())
    if _DENIED.search(sentence) or _ONE_WAY.search(sentence):
        return
    is_label = _LABEL.fullmatch(sentence.strip(" *_")) is not None
    if not is_label and (it := _IT_IS_NOUGHT.fullmatch(sentence)) and (not before or it["determinant"]):
        yield VANISHES
    elif is_label or is_of_singularities(sentence) or (before and _goes_on(sentence, before[-1])):
        is_alone = bool(is_alone or _ALONE.search(sentence))
        if _tells_others(sentence):
            yield SINGULAR_TOO
        elif _OF_ONE_KIND.search(sentence):
            yield SINGULAR_AMONG
        else:
            yield SINGULAR_ALONE if is_alone else SINGULAR


def is_of_singularities(sentence: str) -> bool:
    """Whether a sentence says where the arm is singular, and ends there: "The arm is singular if"."""
    return bool(_SINGULARITIES.search(sentence)) and not _DENIED.search(sentence)


def without_place(sentence: str) -> str:
    """Return a sentence without what it says of where the arm is singular: "when it is stretched" supposes nothing."""
    if not any(singularities_told(sentence)):
        return sentence
    found = _HEAD.search(sentence)
    return sentence if found is None else sentence[: found.end()]


def _tells_others(sentence: str) -> bool:
    """Whether a sentence tells of two places, and of nothing before the first: "a shoulder singularity at ¤, and an elbow singularity at"."""
    first, *others = [each.start() for each in _HEAD.finditer(sentence)] or [0]
    return "¤" not in sentence[:first] and bool(others or _TOO.search(sentence, first))


def _goes_on(sentence: str, before: str) -> bool:
    """Whether "This happens for", behind a sentence that says no more than that the arm is singular, or that det J vanishes."""
    happens = _HAPPENS.search(sentence)
    is_led = happens is not None and _ENDS.match(sentence, happens.end()) is not None
    return is_led and _AT_ITS_END.search(before) is not None and not _DENIED.search(before)


def _plain(sentence: str) -> str:
    """Return a text without emphasis and what stands beside it in parentheses or between commas, its formulas as ¤, J as what it is."""
    text = FORMULA.sub(lambda found: "Jacobian" if _OF_JACOBIAN.fullmatch(found.group()) else "¤", sentence)
    text = re.sub(r"(?<![\w*])[*_]{1,3}(?=\w)|(?<=[\w.:])[*_]{1,3}(?![\w*])", "", _EMPHASIS.sub(r"\1", text))
    return _ASIDE.sub("", _BESIDE.sub("", text))
