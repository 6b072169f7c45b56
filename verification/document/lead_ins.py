"""What words say of the display that they lead to, or follow: "Suppose that", "The elbow is at", "In general,", "to first order"."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.denials import denies_above, denies_below, last_sentence
from armproof.verification.document.model import INLINE, Display
from armproof.verification.document.postures import SINGULAR, is_of_singularities

DENIED_ABOVE, LIMITED_ABOVE = r"\text{denies above}", r"\text{limits above}"  # what a text says of the display above it
DENIED = r"\text{denies below}"  # and of the one that it leads to
GENERAL = r"\text{in general}"  # what ends a configuration
SUPPOSED = r"\text{under a hypothesis}"  # what is supposed, sought, of another case, or an approximation
OTHER_POINT = r"\text{of another point}"  # what is no coordinate of the tool in the base
OF_NEXT = (DENIED, SUPPOSED, OTHER_POINT)  # what is said of one display, and of no configuration

_GENERAL = re.compile(
    r"\b(?:in general|generally|(?:for|in|at|holds for|true for) (?:all|any|every|each|arbitrary) (?:possible )?(?:joint )?"
    r"(?:angles?|values?|configurations?|positions?|postures?|variables?)(?: of the (?:joints|arm|robot|angles))?"
    r"|en général|de (?:façon|manière) générale|(?:pour|dans|en) (?:toutes? (?:les )?)(?:configurations?|positions?|postures?)"
    r"|quel(?:le)?s? que soi(?:en)?t (?:la|les) (?:configuration|position|angles?|valeurs?))\b",
    re.IGNORECASE,
)
_PLACE = r"(?:positions?|coordinates?|heights?|abscissas?|ordinates?|location|velocity|speed|coordonnées|hauteur|abscisse|ordonnée|vitesse|posición|coordenadas|velocidad)"
_ELBOW = r"(?:elbow|coude|codo)"
_OTHER_POINT = re.compile(
    rf"\b(?:{_PLACE} (?:of (?:the )?|du |del ){_ELBOW}|{_ELBOW}['’]?s? (?:itself|{_PLACE}|is|lies|sits|has|moves|est|se trouve|se situe|a pour|está|tiene)(?! (?:up|down|bent|locked|haut|bas))|{_ELBOW}\s*:"
    r"|mid-?point|milieu d|(?:centre|center) of (?:mass|gravity|(?:the )?(?:\w+ )?(?:link|bar|rod))|centre de (?:masse|gravité|la (?:\w+ )?barre)|barycentre|centro de (?:masa|gravedad)"
    r"|(?:in|seen from|expressed in|with respect to|relative to|dans|vu(?:es?)? (?:de|depuis)|exprimée?s? dans|par rapport à) (?:the |le )?(?:frame|repère) \{?[1-9])(?!\w)",
    re.IGNORECASE,
)
_APPROXIMATION = (
    r"(?:(?:to|at|up to|in) (?:the )?(?:first|second|leading) order|au (?:premier|second) ordre|approximat\w+|linearis\w+|lineariz\w+|linéaris\w+"
    r"|neglect\w*|ignoring|néglige\w*|for small|small (?:angles?|motions?|displacements?)|petits (?:angles|mouvements|déplacements)|petites (?:variations|oscillations)"
    r"|up to (?:a|the) (?:sign|factor|constant)|au signe près|à une constante près|à un facteur près)"
)
_STILL = r"(?:locked|fixed|blocked|welded|frozen|at rest|bloquée?s?|fixée?s?|figée?s?|soudée?s?)"
_OF_A_PART = (
    r"(?:contributions?|due to|apports?|first (?:term|part)|second (?:term|part)|premier terme|second terme|without the|sans (?:le|la|les)"
    r"|(?:with|of|for) (?:one|a single) (?:link|joint)|avec une seule|only joint|joint \d (?:alone|only)"
    rf"|(?:joints?|elbow|shoulder|wrist|axis|axes|links?|articulations?|coude|épaule|poignet)(?: \d)? (?:is |are |being |est |sont )?{_STILL}"
    r"|(?:unit|equal|identical) (?:link )?lengths?|longueurs (?:unitaires?|égales)|equal links)"
)
_OF_NO_CLAIM = (
    r"(?:would|might|could|were|expected?|serait|aurait|pourrait|confuse[ds]?|confondre|confondu|never|not|don['’]t|jamais|il ne faut pas|instead of|rather than"
    r"|au lieu de|plutôt que|unlike|contrary to|contrairement|wrong|mistake|erreur|faux|fausse|student|élève|étudiante?|claims? that|prétend|on the other hand"
    r"|prove or disprove|true or false|vrai ou faux|which (?:one )?is (?:right|correct|true)|lequel est|laquelle est|as in the case|comme dans le cas)"
)
_LEADS = re.compile(rf"\b(?:{_APPROXIMATION}|{_OF_A_PART}|{_OF_NO_CLAIM})\b", re.IGNORECASE)
_FOLLOWS = re.compile(
    rf"\s*(?:(?:only |and |et )?(?:{_APPROXIMATION}|(?:if|when|whenever|provided|assuming|supposing|unless|except|as long as|instead of|rather than|with joint|for unit|for equal"
    r"|si|lorsque?|quand|pourvu que|à condition que|sauf|tant que|au lieu de|plutôt que|avec l['’]articulation)))\b"
)
_SUPPOSED = re.compile(
    r"(?:\b(?:suppos(?:e|ing)|assum(?:e|ing)|imagine|by contradiction|if (?:we|one) had|supposons|en supposant|admettons|en admettant|par l['’]absurde|si l['’]on avait|si on avait|on suppose)"
    r"(?:[ ,]+(?:that|by contradiction|for a moment|for now|que|par l['’]absurde|now|for contradiction))*"
    r"|\b(?:solv(?:e|ing)|solutions? (?:of|to)|roots? of|we (?:look|search) for|we (?:must|have to|need to|want to) (?:solve|find|have)|find [^.;]{0,60}such that|such that|so as to have"
    r"|satisfying|résou(?:dre|dons)|solutions? de|on (?:cherche|veut)|telle?s? que|vérifiant))\s*[:,]?\s*\Z"
    r"|\A\s*(?:(?:but|and|now|then|mais|et|or)[ ,]+)?(?:(?:if|when|whenever|si|quand|lorsque?)(?! (?:we|one|you|i|on|nous|l['’]on)\b(?! (?:assum|suppos|neglect|ignor|lock|fix|block|weld|had\b|bloqu|fig|soud|néglig|admet)))"
    r"|assuming|supposing|provided|unless|except|as long as|in the absence of|en supposant|à moins que|sauf|tant que)\b[^;:$`]*,\s*(?:then|alors|we (?:get|have|find|obtain)|on (?:a|obtient|trouve))?\s*:?\s*\Z",
    re.IGNORECASE,
)
_CASE = re.compile(
    r"\b(?:(?:special|particular|limit(?:ing)?|degenerate) cases?|cas (?:particuliers?|limites?|dégénérés?)|linearis\w+|lineariz\w+|linéaris\w+|small (?:angles?|motions?|displacements?)|petits (?:angles|mouvements|déplacements)"
    r"|only joint|joint \d (?:alone|only|locked|fixed|blocked)|(?:unit|equal|identical) (?:link )?lengths?|longueurs (?:unitaires?|égales)"
    r"|(?:common|typical|frequent) (?:mistakes?|errors?)|erreurs (?:fréquentes|courantes)|true or false|vrai ou faux)\b",
    re.IGNORECASE,
)
_ALTERNATIVES = re.compile(  # $s_3 = 0$ or
    r"(?:\s*(?:\$[^$]+\$|\\\(.+?\\\)|:math:`[^`]+`)\s*,?\s*(?:or|and|ou|et|o|y|oder|und)?)+\s*\Z"
)


def said_at_start(text: str, line: int, section: str, is_behind: bool = True) -> Iterator[Display]:
    """Yield what a text says of the display that it may stand right behind, and that it speaks of every configuration, as what stands between displays."""
    if is_behind and denies_above(text):
        yield Display(line, DENIED_ABOVE, section=section, opening=INLINE)
    plain = " ".join(text.split())
    if is_behind and _FOLLOWS.match(plain):
        yield Display(line, LIMITED_ABOVE, section=section, opening=INLINE)
    if _GENERAL.search(plain):
        yield Display(line, GENERAL, section=section, opening=INLINE)


def said_at_end(text: str, line: int, section: str) -> Iterator[Display]:
    """Yield what the last sentence of a text, formulas and all, says of the display that follows."""
    sentence = last_sentence(" ".join(text.split()))
    if denies_below(text):
        yield Display(line, DENIED, section=section, opening=INLINE)
    if _SUPPOSED.search(sentence) or (_LEADS.search(sentence) and not re.search(r"[.!]\W*\Z", sentence)):
        yield Display(line, SUPPOSED, section=section, opening=INLINE)
    if _OTHER_POINT.search(sentence):
        yield Display(line, OTHER_POINT, section=section, opening=INLINE)
    found = _ALTERNATIVES.search(sentence)
    if found is not None and is_of_singularities(sentence[: found.start()].rstrip()):
        yield Display(line, SINGULAR, section=section, opening=INLINE)


def is_of_a_case(section: str) -> bool:
    """Whether the heading of a section says that what stands there holds in one case alone."""
    return _CASE.search(section) is not None
