"""Words with which names are defined, by their classes: verbs that define, the usual quantities, points and frames, and what is another one."""

from __future__ import annotations

import re
from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

holds = WordLists("""
NAMES let call called calls denote denoted denotes denoting write name named designate designated define defined soit soient note notons notera noté notée notés notées appelle appelons appelé appelée appelés nomme nommons nommé nommée désigne désignons désigné désignée définit définissons sei seien nennen nennt genannt heißt heißen heiße bezeichnen bezeichnet bezeichne bezeichnete sea sean llamamos llamaremos llamemos llamado llamada denotamos denota denotan denotado denotada denominamos denominado designamos sia siano chiamiamo chiamato chiamata indichiamo indica indicato indicata indicano denotiamo denotato denotata designiamo seja sejam chamamos chamado chamada denotado indicamos indicado indicada definimos definiamo
STANDS denotes denote stands represents represent designates describes désigne désignent représente représentent décrit bezeichnet bezeichnen bezeichne beschreibt sei seien steht stehen sea sean denota denotan representa representan designa describe sia siano indica indicano rappresenta rappresentano denotano seja sejam indica indicam
BE is are be was being est sont être soit soient ist sind wird war sei seien es son será é são è sono sia siano seja sejam sea sean
DEFINITE the that those this le la les l' un une celui celle ceux celles der die das dem den dessen deren ein eine einen el los las un una il lo gli i o a os as um uma quello quella quelli quelle aquel aquella
REACHES measured counted reckoned read seen what how driven given mesuré mesurée mesurés mesurées compté comptée comptés lu ce gemessen gezählt gerechnet abgelesen was wie medido medida medidos contado misurato misurata misurati contato medidos contados lido
COUNT two three both deux trois zwei drei dos tres due tre dois três
WHERE where wobei worin où donde dove onde with mit avec con com here hier ici
OF along around about entlang lungo largo longo suivant selon of in for from to at about de du des d' dans pour à au von in für nach zu bei del en para al di del della dell' dello nel per da do em and between zwischen entre through durch when if quand si wenn cuando se
BY by mit par con por com as
WE we us i one on nous wir man se si nosotros noi it
THAT that que dass daß che qu'
AT at from to through via à de par du au depuis vers jusqu'à von nach durch bei zu aus desde hasta en por a da per verso fino em até para
POINTS point points positions position poses punkte punkt punkten puntos punto punti pontos ponto posiciones posizioni posições
AFTERWARDS then finally puis ensuite enfin dann danach schließlich luego después poi quindi depois
MOVES start starts starting begin begins end ends stop stops pass passes goes go move moves moving travels travel arrive arrives reach reaches motion movement path trajectory part démarre commence passe va arrive termine s'arrête arrête trajectoire mouvement déplacement startet beginnt endet hält fährt geht bewegt läuft kommt bewegung bahn weg empieza comienza termina pasa va llega trayectoria movimiento inizia comincia finisce passa arriva traiettoria moto percorso começa chega trajetória
FRAME axis axes axe achse eje asse eixo line lines droite gerade plane frame frames repère repères koordinatensystem system systeme matrix matrice matriz transformation transform~ vector vecteur vektor vettore vetor referencia terna riferimento table tableau row
AND and et und y e ed sowie or ou oder o
WRIST wrist~ poignet~ handgelenk~ handwurzel~ muñeca polso pulso
INNER elbow~ knee~ coude~ genou ellbogen~ ellenbogen~ knie codo rodilla gomito ginocchio cotovelo
TOOL tip tool~ tcp effector end-effector endpoint hand gripper~ outil~ effecteur organe organo pince main endeffektor~ effektor~ werkzeug~ greifer~ spitze herramienta pinza efector utensile effettore ferramenta efetuador~ garra extremo terminal terminale
UNTOLD given known unknown arbitrary any some connu connue donné donnée quelconque gegeben bekannt beliebig dado dada conocido dato noto qualunque conhecido as follows following comme suit wie folgt como sigue come segue first
OTHERS middle midpoint~ mid-point~ midway halfway half-way half centre-of-mass mass masses gravity centroid~ barycent~ camera~ sensor~ error~ reference-point room cart counterweight payload load~ previous preceding before polar milieu mi-chemin mi-distance masse gravité inertie inertia inertial barycentre~ caméra capteur erreur désiré désirée  précédent précédente  polaire polaires mitte mittelpunkt~ schwerpunkt~ massenmittelpunkt~ halbe hälfte kamera~ fehler~ abweichung~ sollpunkt~ vorhergehend~ vorherig~ vorig~ raum~ wagen~ nutzlast~ medio medios mitad masa masas gravedad inercia cámara sensore error~   anterior polares mezzo baricentro massa masse telecamera errore  precedente  metà meio metade massa câmera erro  anterior origin-shifted zielpunkt~
RELATIVE above below over über unter oberhalb unterhalb gegen gegenüber encima sopra dessus au-dessus relative~ relatively relatif relativ~
WANTED desired wanted target~ goal~ commanded cible~ désirée désiré voulue voulu consigne soll~ ziel~ gewünscht~ deseado deseada objetivo desiderat~ obiettivo desejad~ alvo
COMPUTED product~ produit produkt producto prodotto produto column spalte colonne columna entry entries sum somme summe suma somma soma inverse inversa determinant~ déterminant determinante transpose~ identity step block first-column same value result solution derivative dérivée equation equations
FROM_AXIS x-axis x-achse horizontal~
ALSO_OTHER centre center centro zentrum mittel
USUAL position~ coordinate~ location~ velocit~ speed~ jacobi~ pose poses orientation~ rotation~ attitude~ twist~ transform~ homogeneous homogène homogenen homogene homogénea omogenea homogênea coordonnée~ vitesse~ lage koordinat~ geschwindigkeit~ winkelgeschwindigkeit~ orientierung~ stellung posición posiciones coordenada~ velocidad~ orientación rotación transformación posizione coordinat~ velocità orientamento rotazione trasformazione posição posições velocidade~ orientação rotação transformação matri~ vector~ vecteur~ vektor~ vettor~ vetor~ column spalte colonne columna cartesian cartésien~ kartesisch~ cartesian~ spatial geometric géométrique geometrisch~ analytic~ geometrico geométrico linear linéaire lineare angular angulaire angolare planar direct forward kinematics cinématique kinematik full complete overall model
PLACES point points punkt punkte punkto punto punti ponto place origin~ ursprung origen origine origem end ends ende bout extrémité~ extremo~ extremos estremo estremi estremità extremidad~ extremidade free libre freie freies freien libero livre effector end-effector effecteur organe organo órgano terminal terminale~ endeffektor~ effektor~ werkzeug~ greifer~ hand main tip tool~ tcp gripper flange flansch~ outil pince herramienta pinza spitze arm~ bras robot~ roboter~ manipulat~ brazo braccio braço mechanism~ endpoint elbow~ coude codo gomito cotovelo ellbogen~ ellenbogen~ knie knee wrist~ poignet~ handgelenk~ muñeca polso efector effettore efetuador
LINKS link links frame frames segment~ body bodies rod rods bar bars beam repère~ corps solide~ maillon~ barre~ glied~ gliedes glieds koordinatensystem~ system~ eslabón eslabones cuerpo marco sistema membro corpo terna elo joint joints articulation~ gelenk~ articulación articulaciones giunto giunti junta juntas axis axes axe achse~ eje ejes asse assi eixo eixos z-axis x-axis z-achse x-achse direction~ richtung dirección direzione direção unit einheits~ unitaire unitario variable~ variabl~ row rows reference referenz~ référence referencia riferimento referência
BASES floor boden~ sol suelo pavimento solo base basis socle sockel world ground fixed inertial-frame monde fixe welt mundo mondo base-frame basis~ feste~ festen absolute absolut~ absolu~ absoluta assoluta
ORDINALS first second third fourth fifth sixth last premier première deuxième seconde second troisième quatrième dernier dernière erste~ zweite~ dritte~ vierte~ letzte~ primer~ segundo segunda tercer~ último última primo prima secondo seconda terzo terza ultimo ultima primeiro primeira terceiro terceira whole complete
SMALL total totale overall gesamte gesamten qui que qu relie relient reliant lie verknüpft bildet abbildet relaciona lega collega bloc blocs block blocks blöcke bloque bloques parts part partie parties teil teile parte partes articulaire~ articular~ gelenkgeschwindigkeit~ positive positif positiv constant constante konstant manipulability manipulabilité manipulabilidad manipolabilità manipulierbarkeit~ measure mesure maß medida misura square carrée quadratische cuadrada quadrata is are est sont ist sind es son è sono é são wird passage passing one two three zwei drei deux trois dos tres due tre dois três both by partial derivatives approach normal sliding through durch all alle tous todas tutti the a an of in for from to at on with respect into and its it his by as that those which is are whose le la les l' du de des d' un une dans en pour à au aux et sa son ses par rapport avec celui celle ceux celles der die das dem den des ein eine einen einer eines von vom und im in am für zu zum zur bezüglich bezogen mit seine ihre el los las del al y su con respecto un una que por il lo gli i della dell' dello dei degli delle nel nella rispetto e ed al alla quello quella o a os as do da dos das no na ao à em um uma relação be hence also we wir on also um über here now expressed written seen relating relates mapping maps rates joint-space between
HEIGHTS height abscissa ordinate component~ horizontal vertical hauteur abscisse ordonnée composante~ höhe abszisse ordinate komponente~ altura abscisa ordenada componente~ altezza ascissa ordinata
ANGLES angle angles winkel angolo ângulo ángulo makes
""").holds  # fmt: skip
_KNOWN = (
    "USUAL",
    "PLACES",
    "LINKS",
    "BASES",
    "ORDINALS",
    "SMALL",
    "HEIGHTS",
    "ANGLES",
    "UNTOLD",
    "RELATIVE",
    "WRIST",
    "INNER",
    "ALSO_OTHER",
    "WANTED",
)
_BASES = ("BASES", "FROM_AXIS")
_IN_OTHER_FRAME = regex(
    r"(?<!\S)(?:in|into|dans|im|en|nel|no|al) (?:\S+ ){0,2}?(?:(?:frame|repère|koordinatensystem|systems?|sistema|terna) (?:[1-9]|outil|de l'outil)"
    r"|(?:body|tool|own|moving|effector|end-effector|hand|gripper)(?:'s)? (?:frame|coordinates|axes)|werkzeug(?:koordinaten)?system)\b"
)
_NUMBERED = frozenset("link frame body segment bar rod repère corps solide barre maillon glied glieds gliedes segments koordinatensystem koordinatensystems systems eslabón barra cuerpo terna corpo membro elo links frames bars".split())  # fmt: skip
_ORDINALS = (("first", "premier", "première", "erste", "ersten", "erstes", "primer", "primera", "primo", "prima", "primeiro", "primeira"), ("second", "deuxième", "seconde", "zweite", "zweiten", "zweites", "segundo", "segunda", "secondo", "seconda"), ("third", "troisième", "dritte", "dritten", "drittes", "tercer", "tercera", "terzo", "terza", "terceiro", "terceira"), ("fourth", "quatrième", "vierte", "vierten", "viertes", "cuarto", "cuarta", "quarto", "quarta"))  # fmt: skip


def is_told(word: str) -> bool:
    """Whether a word of a definition tells anything: no mark, no formula, no number."""
    return any(character.isalpha() for character in word) and word not in ("be", "as", "to", "we", "the", "wir", "on", "se", "si", "comme", "como", "come", "als")  # fmt: skip


def is_usual_word(word: str) -> bool:
    """Whether a word is one of the usual quantities, points and frames of an arm, or of no weight."""
    return len(word) < 2 or any(holds(word, kind) for kind in _KNOWN)


def is_other(phrase: Sequence[str]) -> bool:
    """Whether the words of a definition tell another thing than the usual ones: a middle, a mass, an error, a velocity in frame 2."""
    for place, word in enumerate(phrase):
        behind = phrase[place + 1 : place + 5]
        if holds(word, "OTHERS"):
            return True
        around = (*phrase[max(0, place - 2) : place], *behind)
        if holds(word, "ALSO_OTHER") and not any(holds(e, kind) for e in around for kind in ("WRIST", "TOOL")):
            return True  # the wrist has a centre, and "tool centre point" is a name
        if (
            holds(word, "RELATIVE")
            and any(map(is_told, behind))
            and not any(holds(e, kind) for e in behind for kind in _BASES)
        ):
            return True
    return _IN_OTHER_FRAME.search(" ".join(phrase)) is not None


def number_of(phrase: Sequence[str]) -> str:
    """Return the number of the one link or frame in a phrase: "the end of the second link"; "" of none or of several."""
    found = set[str]()
    for place, word in enumerate(phrase):
        if word not in _NUMBERED:
            continue
        behind, before = phrase[place + 1 : place + 2], phrase[place - 1 : place] if place else []
        if behind and re.fullmatch(r"\d", behind[0]):
            found.add(behind[0])
        found |= {str(k) for k, words in enumerate(_ORDINALS, 1) for each in (*before, *behind) if each in words}
        if behind == ["¤"]:
            found |= {"", "?"}
    return found.pop() if len(found) == 1 else ""
