r"""Sentences after which an arm is no longer where it was: "The elbow now turns by a quarter turn.", "Both bars are twice as long.".

What they make of it is not computed: numbers behind them are of no values that stood before, and are left open until values are given anew.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.hearing import FORMULA, words_of
from armproof.verification.document.word_lists import WordLists

MOVED = r"\text{moved}"  # joints have other values than before
MOVED_BEHIND = r"\text{moved behind}"  # and than the text gives before it says so
RESIZED = r"\text{resized}"  # lengths have
OF_MOTION = (MOVED, MOVED_BEHIND, RESIZED)

_is = WordLists("""
PART joint joints elbow~ shoulder~ wrist~ forearm~ arm arms robot~ manipulator~ mechanism~ link links bar bars rod rods segment~ motor motors angle angles length lengths articulation~ liaison~ coude~ épaule~ poignet~ avant-bras bras manipulateur~ barre~ moteur~ longueur~ axe axes gelenk~ ellbogen~ ellenbogen~ schulter~ handgelenk~ unterarm~ oberarm~ roboter~ glied~ stab stäbe winkel~ länge~ achse~ articulaci~ codo~ hombro~ muñeca~ brazo~ eslab~ barra~ ángulo~ longitud~ ejes giunt~ gomito~ spalla~ polso braccio bracci motore motori angol~ lunghezz~ asta aste junta~ articulaç~ cotovelo~ ombro~ punho~ braço~ elo elos ângulo~ comprimento~
CHANGE turns turned turning rotate rotates rotated rotating swing~ swung move moves moved moving bends bending fold folds folding unfold~ straighten~ stretching extends extending retract~ lift lifts lifted lifting raises raised raising lowers lowered lowering releas~ unlock~ frees freed switch~ reversed reverses reversing flips flipped flipping mirrored doubl~ halv~ tripl~ twice increas~ decreas~ grow grows grew shrink~ shrunk lengthen~ shorten~ longer shorter replac~ exchang~ swap~ changes changed changing opposite backwards runs starts stops passes passing tourne tournent tourné tournée tournés tournées tournant tourner pivote pivotent pivoté pivotée pivotant pivoter déplace déplacent déplacé déplacée déplaçant bouge~ plie plient pliant plier plié pliée replie replient dépli~ étend~ étendu libère libèrent libéré libérée libérons libérer débloqu~ relâch~ retourné~ retourne double doublent doublé doublés doublées doublant doubler doublons triplé~ augment~ diminu~ allong~ raccourc~ remplac~ échang~ change changent changé changés changeant opposé~ lève relève baisse abaisse démarre~ marche inversé~ gedreht dreht drehen bewegt bewegen schwenk~ geschwenkt beugt beugen gebeugt gelöst verdoppel~ halbier~ verläng~ verkürz~ vergrößer~ verkleiner~ ersetz~ umgekehrt ändert ändern geändert wechselt entgegengesetzt~ gira giran girado girada girados girando girar mueve mueven movido movida mover dobla doblan doblado doblada doblando duplic~ aument~ invierte~ cambia cambian cambiado cambiando libera liberan liberado opuest~ alarga~ acorta~ ruota ruotano ruotato ruotata ruotando ruotare muove muovono mosso mossa piega piegano piegato piegando raddoppi~ dimezz~ inverte~ invertit~ cambiato cambiano allung~ accorci~ oppost~ giram girados movem movido dobra dobram dobrado dobrando muda mudam mudou mudado alonga~ encurta~ opost~
LENGTH link links bar bars rod rods segment~ length lengths longueur~ barre~ glied~ stab stäbe länge~ eslab~ barra~ longitud~ lunghezz~ asta aste bracci elo elos comprimento~
SIZE doubl~ halv~ tripl~ twice longer shorter lengthen~ shorten~ replac~ exchang~ swap~ grow grows shrink~ remplac~ échang~ allong~ raccourc~ longs longues courts courtes verdoppel~ halbier~ verläng~ verkürz~ ersetz~ duplic~ alarga~ acorta~ reemplaz~ raddoppi~ dimezz~ allung~ accorci~ sostitui~ dobra~ alonga~ encurta~ substitu~
""").holds
_LATER = re.compile(
    r"(?<!\S)(?:(?:seconds?|minutes?|moments?|while|bit|steps?) later|halfway(?! between)|midway(?! between)|(?:after|at the end of) (?:the|this|that) (?:motion|movement|move|turn)|(?:secondes?|minutes?|instants?) plus tard"
    r"|à mi-(?:chemin|course)|(?:après|à la fin de|au bout de) (?:le|la|ce|cette) (?:mouvement|rotation)|à la fin du mouvement|(?:sekunden?|minuten?|schritte?) später|nach der bewegung|auf halbem weg"
    r"|(?:segundos?|minutos?) (?:más|mais) tarde|(?:después|depois) del? movimiento|depois do movimento|(?:secondi|minuti) (?:più tardi|dopo)|dopo il movimento) "
)
_OTHER_POSTURE = re.compile(
    r"(?<!\S)(?:(?:another|other|second|third|next|new|mirrored|mirror|opposite|symmetric(?:al)?) (?:posture|configuration|pose)|(?:autre|deuxième|seconde|troisième|nouvelle|prochaine) (?:posture|configuration|pose)"
    r"|(?:posture|configuration|pose) (?:suivante|symétrique|opposée|miroir|finale)|(?:andere[nr]?|zweiten?|nächsten?|neuen?) (?:stellung|lage|konfiguration)|(?:otra|segunda|nueva|siguiente) (?:postura|configuración)"
    r"|(?:altra|seconda|nuova|prossima) (?:postura|configurazione)|(?:outra|segunda|nova|próxima) (?:postura|configuração)) "
)
_GIVES = re.compile(r"(?:\\(?:var)?(?:theta|phi|alpha|beta|gamma)|(?<![A-Za-z\\])[qdlarLt])(?![A-Za-z]).*=")
# before by how much, or from where
_BY = re.compile(r"(?<!\S)(?:by|from|de|d'|um|von|por|desde|di|da)\s*\Z", re.IGNORECASE)
_NEAR = 12  # characters before a formula in which such a word stands
_IDLE = re.compile(
    r"(?<!\S)(?:turn(?:s|ed)? out|in turn|half of|opposite (?:side|angle|direction) (?:of|to)"
    r"|(?:moves?|turns?|rotates?|bewegt sich|dreht sich|se déplace|se mueve|si muove) (?:only |nur |uniquement |sólo |solo )?(?:in|within|about|dans|en|nel|parallel to)"
    r" (?:the|a|one|this|its|der|einer|le|un|el|il|piano|plan)(?: \S+)?(?<!direction)(?= (?:plane|ebene|plan|plano|piano))) "
)
_STOP = re.compile(r"(?<!\\)[.;!?:](?=\s+\S)")


def said_of_motion(text: str) -> Iterator[str]:
    """Yield what a text says of values that were given before: that they are no longer those of the arm."""
    sentences = _STOP.split(" ".join(text.split()))
    gives = [any(map(_GIVES.search, _formulas(each))) for each in sentences]
    heard = [() if own else _moves(each) for each, own in zip(sentences, gives, strict=True)]
    last = max((place for place, own in enumerate(gives) if own), default=-1)
    if any(heard):
        yield MOVED_BEHIND if any(heard[last + 1 :]) and last >= 0 else MOVED
    if any(RESIZED in each for each in heard):
        yield RESIZED


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
    moves = any(_is(each, "CHANGE") for each in said) and any(_is(each, "PART") for each in said)
    if any(_is(each, "LENGTH") for each in said) and any(_is(each, "SIZE") for each in said):
        return MOVED, RESIZED
    return (MOVED,) if moves or _LATER.search(words) or _OTHER_POSTURE.search(words) else ()
