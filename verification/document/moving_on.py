r"""Sentences after which an arm is no longer where it was: "The elbow now turns by a quarter turn.", "Both bars are twice as long.".

What they make of it is not computed: numbers behind them are of no values that stood before, and are left open until values are given anew.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import FORMULA, words_of
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

MOVED = r"\text{moved}"  # joints have other values than before
MOVED_BEHIND = r"\text{moved behind}"  # and than the text gives before it says so
RESIZED = r"\text{resized}"  # lengths have
OF_MOTION = (MOVED, MOVED_BEHIND, RESIZED)

_lists = WordLists("""
PART joint joints elbow~ shoulder~ wrist~ forearm~ arm arms robot~ manipulator~ mechanism~ link links bar bars rod rods segment~ motor motors angle angles length lengths articulation~ liaison~ coude~ épaule~ poignet~ avant-bras bras manipulateur~ barre~ moteur~ longueur~ axe axes gelenk~ ellbogen~ ellenbogen~ schulter~ handgelenk~ unterarm~ oberarm~ roboter~ glied~ stab stäbe winkel~ länge~ achse~ articulaci~ codo~ hombro~ muñeca~ brazo~ eslab~ barra~ ángulo~ longitud~ ejes giunt~ gomito~ spalla~ polso braccio bracci motore motori angol~ lunghezz~ asta aste junta~ articulaç~ cotovelo~ ombro~ punho~ braço~ elo elos ângulo~ comprimento~
CHANGE turns turned turning rotate rotates rotated rotating swing~ swung move moves moved moving bends bending fold folds folding unfold~ straighten~ stretching extends extending retract~ lift lifts lifted lifting raises raised raising lowers lowered lowering releas~ unlock~ frees freed switch~ reversed reverses reversing flips flipped flipping mirrored doubl~ halv~ tripl~ twice increas~ decreas~ grow grows grew shrink~ shrunk lengthen~ shorten~ longer shorter replac~ exchang~ swap~ changes changed changing opposite backwards runs starts stops passes passing tourne tournent tourné tournée tournés tournées tournant tourner pivote pivotent pivoté pivotée pivotant pivoter déplace déplacent déplacé déplacée déplaçant bouge~ plie plient pliant plier plié pliée replie replient dépli~ étend~ étendu libère libèrent libéré libérée libérons libérer débloqu~ relâch~ retourné~ retourne double doublent doublé doublés doublées doublant doubler doublons triplé~ augment~ diminu~ allong~ raccourc~ remplac~ échang~ change changent changé changés changeant opposé~ lève relève baisse abaisse démarre~ marche inversé~ gedreht dreht drehen bewegt bewegen schwenk~ geschwenkt beugt beugen gebeugt gelöst verdoppel~ halbier~ verläng~ verkürz~ vergrößer~ verkleiner~ ersetz~ umgekehrt ändert ändern geändert wechselt entgegengesetzt~ gira giran girado girada girados girando girar mueve mueven movido movida mover dobla doblan doblado doblada doblando duplic~ aument~ invierte~ cambia cambian cambiado cambiando libera liberan liberado opuest~ alarga~ acorta~ ruota ruotano ruotato ruotata ruotando ruotare muove muovono mosso mossa piega piegano piegato piegando raddoppi~ dimezz~ inverte~ invertit~ cambiato cambiano allung~ accorci~ oppost~ giram girados movem movido dobra dobram dobrado dobrando muda mudam mudou mudado alonga~ encurta~ opost~
LENGTH link links bar bars rod rods segment~ length lengths longueur~ barre~ glied~ stab stäbe länge~ eslab~ barra~ longitud~ lunghezz~ asta aste bracci elo elos comprimento~
LIMB forearm~ avant-bras unterarm~ oberarm~ antebrazo avambraccio antebraço upper bras
SIZE doubl~ halv~ tripl~ twice longer shorter lengthen~ shorten~ replac~ exchang~ swap~ grow grows shrink~ remplac~ échang~ allong~ raccourc~ longs longues courts courtes verdoppel~ halbier~ verläng~ verkürz~ ersetz~ duplic~ alarga~ acorta~ reemplaz~ raddoppi~ dimezz~ allung~ accorci~ sostitui~ dobra~ alonga~ encurta~ substitu~
""")
_is, _has = _lists.holds, _lists.has
_NUMBER = r"(?:\d+(?:[.,]\d+)?|one|two|three|four|five|six|eight|ten|twenty|half a|un|une|deux|trois|quatre|cinq|six|huit|dix|vingt|eine?n?|zwei|drei|vier|fünf|acht|zehn|uno|una|dos|tres|cuatro|cinco|diez|due|tre|quattro|cinque|dieci|dois|duas|três|quatro|dez)"
_UNIT = r"(?:mm|cm|dm|m|meters?|metres?|inch(?:es)?|feet|foot|(?:centi|milli|déci)?mètres?|(?:zenti|milli)?metern?|(?:centi|mili)?metros?|(?:centi|milli)?metri|(?:centi|milli|deci)met(?:er|re)s?)"
_SIZED = regex(rf"(?<!\S){_NUMBER} {_UNIT} |(?<!\S)\d+(?:[.,]\d+)?{_UNIT} ")
_LINK = (
    r"(?:(?:links?|bars?|rods?|segments?|forearm|upper arm|limbs?|bras|avant-bras|barres?|corps|glied(?:er)?|stäbe?|unterarm|oberarm|arme?|eslabon(?:es)?|eslabón|barras?|brazo|antebrazo|asta|aste|bracci?o?|avambraccio|elos?|braço|antebraço|l' avant-bras)"
    r"|(?:lengths?|longueurs?|längen?|longitud(?:es)?|lunghezz[ae]|comprimentos?)|(?:arms?|robots?|manipulators?|manipulateurs?|roboter)(?:' s)?)"
)
_COMPARED = regex(  # how large something is, told by something else that is so large
    r"(?<!\S)(?:(?:as|equally) (?:long|large|big|short)|of (?:equal|the same) (?:length|size)|(?:the )?same (?:length|size)|(?:de |la |des )?mêmes? (?:longueurs?|tailles?)|(?:aussi|plus|moins) (?:longs?|longues?|courte?s?|grande?s?|petite?s?)"
    r"|(?:half|double|twice|thrice|\S+ times) (?:that|this|the|its|their|as|larger|bigger|longer|smaller|shorter)|(?:smaller|larger|bigger|shorter|longer) (?:sibling|brother|sister|version|copy|model|arm|robot|one|variant|link|bar|forearm|segment)s?"
    r"|(?:\S+ fois) (?:plus|moins|la|sa|leur)|(?:gleich|ebenso|halb|doppelt|\S+mal) so? ?(?:lang|groß|kurz)|(?:größer|kleiner|länger|kürzer)e?[rns]?|(?:más|mais|più) (?:grandes?|larg[oa]s?|cort[oa]s?|pequeñ[oa]s?|lungh?[oaie]|cort[oaie]|grandi|piccol[oaie]|comprid[oa]s?)|scaled|enlarged|reduced in size|agrandie?s?|réduite?s?) "
)
_LONG = regex(
    rf"(?<!\S)(?:lengths?|long|longueurs?|measures?|mesure(?:nt)?|längen?|misst|messen|longitud(?:es)?|miden?|lunghezz[ae]|comprimentos?) (?:(?:of|is|are|now|only|both|equal|to|de|plus|que|désormais|maintenant|von|ist|sind|jetzt|nur|es|son|è|sono|di) )*{_NUMBER} "
)
_IN_DIGITS = regex(  # $0.5$, $50\,\mathrm{cm}$
    r"\$\s*(\d+(?:(?:[.,]|\{,\})\d+)?)\s*(?:(?:\\[,;: ]|~)\s*)*(?:\\(?:mathrm|text|rm)\s*\{?\s*([a-z]+)\s*\}?)?\s*\$"
)
_OF_LINK = regex(rf"(?<!\S){_LINK} ")
_OF_REACH = regex(  # what has a size and is no link
    r"(?<!\S)(?:workspace|work space|torques?|forces?|speeds?|velocit\S+|errors?|angles?|radius|circle|distance|reach|manipulability|determinants?|espace|couples?|efforts?|vitesses?|erreurs?|rayon|cercle|portée|déterminant|arbeitsraum|momente?|fehler|winkel|radius|kreis) "
)
_GIVES_LENGTH = regex(r"(?<![A-Za-z\\])[dlarL](?:_|\b)[^=]*=")
_LATER = regex(
    r"(?<!\S)(?:(?:seconds?|minutes?|moments?|while|bit|steps?) later|halfway(?! between)|midway(?! between)|in the end|goes on to|(?:after|at the end of) (?:the|this|that) (?:motion|movement|move|turn)|(?:secondes?|minutes?|instants?) plus tard"
    r"|à mi-(?:chemin|course)|(?:après|à la fin de|au bout de) (?:le|la|ce|cette) (?:mouvement|rotation)|à la fin du mouvement|(?:sekunden?|minuten?|schritte?) später|nach der bewegung|auf halbem weg"
    r"|(?:segundos?|minutos?) (?:más|mais) tarde|(?:después|depois) del? movimiento|depois do movimento|(?:secondi|minuti) (?:più tardi|dopo)|dopo il movimento) "
)
_OTHER_POSTURE = regex(
    r"(?<!\S)(?:(?:another|other|second|third|next|new|mirrored|mirror|opposite|symmetric(?:al)?) (?:posture|configuration|pose)|(?:autre|deuxième|seconde|troisième|nouvelle|prochaine) (?:posture|configuration|pose)"
    r"|(?:posture|configuration|pose) (?:suivante|symétrique|opposée|miroir|finale)|(?:andere[nr]?|zweiten?|nächsten?|neuen?) (?:stellung|lage|konfiguration)|(?:otra|segunda|nueva|siguiente) (?:postura|configuración)"
    r"|(?:altra|seconda|nuova|prossima) (?:postura|configurazione)|(?:outra|segunda|nova|próxima) (?:postura|configuração)) "
)
_GIVES = regex(r"(?:\\(?:var)?(?:theta|phi|alpha|beta|gamma)|(?<![A-Za-z\\])[qdlarLt])(?![A-Za-z]).*=")
# before by how much, or from where
_BY = regex(r"(?<!\S)(?:by|from|de|d'|um|von|por|desde|di|da)\s*\Z", re.IGNORECASE)
_NEAR = 12  # characters before a formula in which such a word stands
_IDLE = regex(
    r"(?<!\S)(?:turn(?:s|ed)? out|in turn|half of|opposite (?:side|angle|direction) (?:of|to)"
    r"|(?:moves?|turns?|rotates?|bewegt sich|dreht sich|se déplace|se mueve|si muove) (?:only |nur |uniquement |sólo |solo )?(?:in|within|about|dans|en|nel|parallel to)"
    r" (?:the|a|one|this|its|der|einer|le|un|el|il|piano|plan)(?: \S+)?(?<!direction)(?= (?:plane|ebene|plan|plano|piano))) "
)
_STOP = regex(r"(?<!\\)[.;!?:](?=\s+\S)")


def said_of_motion(text: str) -> Iterator[str]:
    """Yield what a text says of values that were given before: that they are no longer those of the arm."""
    sentences = _STOP.split(" ".join(text.split()))
    gives = [any(map(_GIVES.search, _formulas(each))) for each in sentences]
    heard = [() if own else _moves(each) for each, own in zip(sentences, gives, strict=True)]
    last = max((place for place, own in enumerate(gives) if own), default=-1)
    if any(heard):
        yield MOVED_BEHIND if any(heard[last + 1 :]) and last >= 0 else MOVED
    if any(RESIZED in each for each in heard) or any(map(_resizes, sentences)):
        yield RESIZED


def _resizes(sentence: str) -> bool:
    """Whether a sentence says in words how large links are, or the arm, by a number or by what is so large: "Both links are two metres long."."""
    if any(map(_GIVES_LENGTH.search, _formulas(sentence))):
        return False
    words = words_of(_IN_DIGITS.sub(r"\1 \2", sentence)).lower()
    if words.endswith("? ") or not _OF_LINK.search(words) or _OF_REACH.search(words):
        return False
    of_links = any(_is(each, "LENGTH") or _is(each, "LIMB") for each in words.split())
    is_sized = _SIZED.search(words) or _LONG.search(words)
    return bool((of_links and is_sized) or _COMPARED.search(words))


def _formulas(sentence: str) -> Iterator[str]:
    """Yield the formulas of a sentence but those that tell by how much, or from where, something moves."""
    for found in FORMULA.finditer(sentence):
        if not _BY.search(sentence, max(0, found.start() - _NEAR), found.start()):
            yield found.group()


def _moves(sentence: str) -> tuple[str, ...]:
    """Return what a sentence says to have other values than before: joints, or lengths too; nothing of a question."""
    words = words_of(sentence).lower()
    if words.endswith("? "):
        return ()
    said = _IDLE.sub("", words).split()
    moves = _has(said, "CHANGE") and _has(said, "PART")
    if _has(said, "LENGTH") and _has(said, "SIZE"):
        return MOVED, RESIZED
    return (MOVED,) if moves or _LATER.search(words) or _OTHER_POSTURE.search(words) else ()
