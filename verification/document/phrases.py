"""Phrases by which sentences change what a display says, where its clauses (`clauses.py`) do not tell; each table by what they do there.

A line is a phrase in English, French, German or Spanish, its words as they stand. `a/b` is either word, `(a)` may be missing,
`~` ends or begins a word in any way, `…` is up to four words, `*` any, `%` any but formulas, `¤` a formula, `#` a digit, `&` what joins sentences ("but",
"mais"); `^` is the beginning of the sentence and `$` its end. A comma may stand behind each word, and an apostrophe ends one.
"""

# -- denials: see sentences.denies

NOT = """
not/never/nobody/nothing/none/neither/nor/cannot/hardly/no
can' t
~n' t
far from
no longer
pas/jamais/aucun/aucune/nullement/nicht/kein/keine/nie/niemals/nunca/jamás/non
"""
TRUE = """
true/right/correct/exact/so/valid/hold/holds
"""
HARMLESS = """
pas sorcier
étonn~/surprendra/doutera pas (de)
without/sans/sin/senza/sem/ohne (any/a/further/aucune) (the) loss/perte/pérdida/perdita/perda/doubt/duda/doute/dubbio/dúvida/ado/zweifel
unless/sauf otherwise/mention/indication (stated/noted/specified/mentioned) (contraire)
says/say/said/tells/tell (us) nothing/little about/of/on
ne dit/disent rien de/d'/du/sur/des
sagt/sagen nichts über
no dice/dicen nada de/sobre
on the contrary
au/im contraire/gegenteil
as it/they/one/this (indeed) must/should/may/can/need not
ne le/la/les/l'/en/y/lui change/changent/modifie/modifient/affecte/affectent/touche pas/rien
does/do/did/is not/n' depend/matter/involve/change/affect/enter/appear/contain/assume/presuppose/suppose/require
is/are not restricted/limited/confined/bound/tied to
ne dépend/change/contient/intervient/suppose/présuppose/exige/requiert/nécessite pas
n' est/sont pas limité~/restreint~/réservé~
no supone/requiere/exige
non suppone/presuppone/richiede
não supõe/requer/exige
same formula/formulas/equation/equations/expression/relation/result (is/are/can) (also) (be) found/used/given/derived/printed/appears/appear/stands in (many/most/several/all) (other) books/textbooks/texts/courses/sources/papers/articles/chapters
même formule/relation/équation/expression/résultat (se/est) (trouve/figure/trouvée/donnée) dans (beaucoup/la/tous/plusieurs) (plupart) (d'/de/des/les) (autres) ouvrages/livres/manuels/cours/textes/articles
gleiche/dieselbe/selbe formel/gleichung/beziehung (steht/findet) (sich) in (vielen/den/allen/mehreren) (meisten) (anderen) büchern/lehrbüchern/texten/vorlesungen
misma fórmula/ecuación/expresión/relación (se/está) (encuentra/aparece) en (muchos/varios/todos) (los) (otros) libros/textos/cursos/apuntes
stessa formula/equazione/espressione/relazione (si) (trova/ritrova) in (molti/altri/tutti) (i/altri) libri/testi/corsi
twice as fast/long/large/big/much/high/heavy/far/great/quick/quickly/wide
doppelt/halb so schnell/lang/groß/hoch/viel/schwer/weit
and/or the other way round/around
and/or/et/und/y/o/e/ou vice versa/viceversa/conversely/inversement/réciproquement/umgekehrt/inversamente/recíprocamente/vice-versa/viceversa
permutation~ circulaire/cyclique
circular/cyclic permutation~
zyklische/zyklischen/zyklischer vertauschung/permutation
permutación/permutazione/permutação cíclica/ciclica/circular
not/n'/ne/nicht need/require/take/brauche~ (…) more/much/anything/mehr than/als
has/have/contains/had no (…) term/terms/factor/part/component/dependence in/with/of/for/on
not/no/nothing/never/cannot (…) symmetric/interesting/inverted/invertible/expanded/memorise/memorised/memorize/simplify/simplified
nothing/little to do with
rien à voir avec
most/many/all/several/some/other/these books/textbooks/texts/courses/authors/lecture (notes) print/give/use/have/derive/write/contain (exactly) the same formula/formulas/equation/expression/relation/result
la plupart des livres/ouvrages/manuels/cours/auteurs donnent/impriment/écrivent/ont la même formule/équation/relation/expression
n'/ne oublier~/oubli~/manquer~ pas/jamais
personne ne s' étonn~
personne ne sera/doute~ (surpris)
ne/n' reste/restait/restera (donc/alors) (plus) qu'
no need
no hace/hará falta
no/non/não es/è/é necesario/necessario/necessário/preciso
non serve/occorre
nicht/n'/nul nötig/notwendig/besoin
what we wanted/expected/sought
wrong/incorrect to think/believe that % matters/depends/matter/depend
often/sometimes printed/written with a/the wrong sign
not/nicht/pas/non/no only/just/merely/seulement/uniquement/nur/solo
not/nicht/pas/no (so/too/very/si/très/sehr) difficult/hard/easy/surprising/difficile/facile/schwer/schwierig/difícil
nothing/rien (is) wrong/false/incorrect
no/not/without/sans/aucune/keine/sin (only/merely) (any/a/an/une) approximation/trivial/surprise/approximate
not surprisingly
no/not/kein/pas (a/an/un/une) (mere) slip/typo/misprint/oversight/accident/coquille/versehen/druckfehler
not/no/never/cannot (…) wrong/wrongly/false/incorrect/mistake/mistaken/impossible/absurd
pas/nicht/kein/no (…) faux/fausse/falsch/falscher/falso/incorrecto/inexact
avoid~/prevent~/remedy/without/éviter/évite~/sans/vermeide~/evitar (…) mistake~/error~/misconception~/erreur~/wrong/fehler
if/when/whenever/falls/si (something/anything/it/etwas/quelque) (chose/algo) goes/go/schiefgeht/va wrong/mal
^ a/any/one (wrong/false/single) sign/mistake/error/slip here would
false/wrong position/ground/side/way/hand
right inverse/angle/angles/side/hand/triangle
error metric/norm/signal/measure/model/bound/function
not/no/nobody/cannot/never/~n'/pas/nul/nulle/nicht/kein/keine/ohne/sans (…) doubt~/deny/denied/denies/dispute~/doute/difficult/difficulty/hard/surprise~/surprising/wonder~/secret/coincidence/accident/pity/forget/forgotten/overlook/hide/ignore/escape~/prevent~/exaggeration/étonn~/surpren~/oubli~/hasard/mal/peine/difficile/zweifel~/schwer/schwierig/vergessen/wunder~/mühe/repeat/mention/forgotten/obvious/trivial/clear/evident/évident/new/object
not/without/~n'/pas/nicht/ohne/sans (…) prove/proof/derive/démontrer
not without reason
never/nunca/jamais forget/oublier/olvidar
nothing/rien (…) neglected/négligé
no/sin es/hay/cabe duda/difícil/extraño
cannot but
"""
ABOVE = """
formula/formulas/equation/equations/expression/relation/result/line/one above
above/previous/preceding/last formula/formulas/equation/equations/expression/relation/result/line
formule/équation/relation/expression/égalité/ligne/résultat ci-dessus/précédente/précédent
obige/vorige/letzte gleichung/formel/beziehung/ausdruck
fórmula/ecuación/relación/expresión anterior
"""
DENIED_BEHIND = """
^ (which) (this) (it) (is) (holds) (true) (right) for/at/if/when ¤ alone/only
^ * read/lire/lisez/lies/lesen/léase/leer … instead/au/statt/anstatt/en of/lieu/lugar
^ * erreur/error/mistake/fehler/faute * ? $
^ no/non/nein/nope :/;/!/—
^ (well) (,) (not/pas/nicht/gar) at/du/tout/überhaupt (à) all/tout/fait/nicht . $
^ far from it
^ * sens dessus dessous
^ ne/n' * utilisez/utilisons/utiliser/copiez/écrivez/retenez pas
^ * correct/right/true/proper/corrected version/formula/expression/result/value/equation/relation (is/reads/has/would/can/should/follows/stands)
^ … needs/requires a/some correction
^ which/this/that/ce (qui) requires/assumes/presupposes/suppose/erfordert ¤
"""
DENIED_BEFORE = """
by no means (,) $
^ & (in/auf/en/de/in/em/under) no/keinen/keiner/aucun/aucune/ninguna/ningún/nessun/nessuna/nenhuma way/circumstances/fall/weise/cas/façon/manière/manera/modo/caso (,) $
further from the truth
no/zero/without/sans/aucun/keine/sin (obtenir/any) (de/receiving/getting) marks/points/credit/points/punkte/puntos
^ (…) nor/ni/noch/neither (…) is/are/does/do/est/ist/es
(this/that/it) (…) is not (…) the case
^ (it) (is) only/solely if/when/for/at/in/where ¤
^ (but) (please) avoid/éviter/évitez/évitons (:) (writing) $
"""
POINTS_BELOW = """
formula/line/equation/expression/relation/result that/which follows
what follows
ce/formule/ligne/relation/équation qui suit
was/formel/gleichung/zeile (,) die folgt
lo/fórmula/ecuación que sigue
following/below/underneath/suivante/suivant/ci-dessous/ci-après/folgende/folgenden/nachstehende/nachstehenden/siguiente
"""
THEN = """
^ then/alors/dann/entonces/allora/então/so/thus/hence/therefore/donc/also/ainsi/daher/así/luego/dunque/portanto (,) … (:) $
^ (in) (dans) (en) this/that/such/ce/in/im/ese/tal (a) (diesem) case/cas/fall/caso (,) … (:) $
^ this/it/cela/das/esto (then) gives/yields/leads/donne/ergibt/liefert/da/resulta … (:) $
"""
AND_ITS = """
^ (and/et/und/y/e) (the/its/one/whose/their/le/la/les/l'/son/sa/ses/dont/seine/ihre/die/der/das/dessen/deren/el/las/los/su/sus/cuyo/cuya/il/lo/i/gli/suo/sua) the/its/one/whose/their/le/la/les/l'/son/sa/ses/dont/seine/ihre/die/der/das/dessen/deren/el/las/los/su/sus/cuyo/cuya/il/lo/suo/sua
"""
LEADS_ON = """
is/are/reads/read/becomes/gives/get/have/obtain/obtains/then/with/by/at/that/as/equals/needs/est/sont/devient/donne/obtient/écrit/vaut/alors/par/que/ist/sind/lautet/ergibt/gilt/wird/es/son/queda/da/è/sono/diventa $
"""
OF_THE_ONE_BEFORE = """
it/he/she/il/elle/er/ella/esso/essa sees/moves/turns/travels/stands/lies/sits/describes/reaches/looks/voit/bouge/tourne/décrit/atteint/regarde/trouve/sieht/bewegt/dreht/liegt/steht/beschreibt/vede/muove/trova
its/whose/dessen/deren/cuyo/cuya (own) position/coordinates/velocity/speed/height/abscissa/ordinate/jacobian/koordinaten/geschwindigkeit/höhe/posición/coordenadas/velocidad/altura
(show/prove/check) (that) it is at/given (by) $
sa/ses position/coordonnées/vitesse/hauteur/jacobienne
su/sus/sua/sue/suas/seus/seine/ihre coordenadas/posición/velocidad/altura/koordinaten/lage/geschwindigkeit/höhe/coordinate/posizione/velocità/altezza/posição/velocidade
"""
DENYING_HEADING = """
common/frequent/typical/classic/usual/popular mistake~/error~/slip~/misconception~
^ (the) (some) (few) (a) error~/mistake~/pitfall~/misconception~/misprint~ $
^ (a) (some) wrong/false/incorrect/erroneous
what/how not to
find/spot/correct the error~/mistake~
erreur/erreurs fréquente~/courante~/classique~
formule/formules/solution/démonstration fausse~
häufige/häufiger/typische/typischer fehler
errores/error comunes/frecuentes/común/frecuente
blunder~/trap/traps/piège/pièges/fallen
faux raisonnement
wrong $
"""

# -- what supposes a display, asks for it, quotes it, or says that it is of a case or nearly so

CASE = """
special/particular/limiting/limit/degenerate case/cases
cas particulier~/limite~/dégénéré~
linearis~/lineariz~/linéaris~
small/petits/petites angles/motion~/displacement~/mouvements/déplacements/oscillations/variations
only joint
joint # alone/only/locked/fixed/blocked
unit/equal/identical (link) length/lengths
longueurs unitaire~/égale~
true/vrai or/ou false/faux
"""
OF_A_PART = """
part/portion/share/component/partie/teil/anteil/parte of/de/d'/der/del (the) (l') (joint) acceleration/accelerations/accélération/beschleunigung/aceleración/accelerazione
centripetal/centrifugal/coriolis/tangential/centripète/coriolis- part/term/terms/acceleration/component/accélération
contribution/apport
due to
first/second/premier/second term/part/terme
without/sans the/le/la/les
with/of/for one/a (single) link/joint
avec une seule
only joint
joint # alone/only
joint/joints/elbow/shoulder/wrist/axis/axes/link/links/articulation/articulations/coude/épaule/poignet (#) (is/are/being/est/sont) locked/fixed/blocked/welded/frozen/bloqué~/fixé~/figé~/soudé~
at rest
unit/equal/identical (link) length/lengths/links
longueurs unitaire~/égale~
"""
MAY_LIMIT = """
angle/angles/winkel/ángulo/ángulos/angolo/angoli/ângulo/ângulos/motor/motors/moteur/moteurs/motoren * (is/are/est/sont/ist/sind/es/son) absolute/absolu~/absolut~/assolut~
measured/counted/taken/reckoned/referred/given/mesuré~/compté~/pris/prise/repéré~/gemessen/gezählt/medido~/medida~/contado~/tomado~/misurat~/contat~/contada~ (with) (respect) from/to/against/with/depuis/à/par/desde/respecto/rapport/gegen/gegenüber/von/zur/zum/dall' (…) horizontal~/vertical~/orizzontal~/vertikal~/ground/floor/sol/suelo/boden/lotrecht~/waagrecht~/waagerecht~/senkrecht~
(all) lengths/longueurs/längen/longitudes/lunghezze (are/is/being/sont/werden/son/sono) doubled/halved/tripled/doublées/divisées/verdoppelt/halbiert/duplicadas/raddoppiate
in/to/into/from/of/dans/vers/du/im/in/en/desde/al the/le/l'/la/el/zum/dem/den/der (¤) second/third/moving/moved/rotating/tool/body/hand/gripper/wrist/elbow/forearm/local/new/own/last/other/deuxième/second/mobile/local/nouveau/outil/zweiten/mitbewegten/bewegten/móvil/segundo/herramienta frame/axes/coordinates/system/koordinatensystem/system/repère/sistema
frame/coordinates/system of/attached (to) (the) first/second/third/last/moving/tool/hand/gripper/elbow/forearm/wrist/end-effector (link)
seen/looked/viewed/observed/vu/vue/vista/visto/gesehen (at) from/by/depuis/desde/par/von
(first/second/third/other/last/¤) joint~/link/motor/axis/shoulder/elbow/forearm/¤ (does/do) not (move/turn/rotate)
articulation/liaison/axe/coude/épaule/segment/moteur (#) (est/étant/reste) bloqué~/fixe/fixé~/immobile/figé~/verrouillé~/arrêté~
articulación/eslabón/eje/codo/hombro (…) bloquead~/fij~/inmóvil/quiet~
parallelogram~/belt/belts/pulley/pulleys/pantograph/parallélogramme/courroie~/riemen/parallelogramm~/paralelogramo/correa~
held/kept/set/frozen/put/maintenu~/gehalten/mantenid~ (…) at/to/à/auf/bei/en zero/¤/zéro/null/cero
angle/angles/winkel/ángulo/ángulos * to/with/from/against/and/avec/à/par/et/gegen/zur/zum/und/con/desde/de/y (rapport) (the/à/l'/la/le/au/al) ground/horizontal~/vertical~/x-axis/y-axis/sol/boden/suelo
se/wird/werden (…) mide/miden/misst/mesure/mesurent (…) desde/von/ab/depuis
mesuré~ dans le repère/référentiel fixe/absolu/global
not/n'/nicht/no (t) (…) denote/mean/stand/represent/désigne/représente/bezeichnet/bedeutet/designa/representa
symbol/letter/abbreviation/notation/shorthand/symbole/lettre/abréviation/zeichen/abkürzung/símbolo/letra ¤ here/ici/hier/aquí
symbol/letter/abbreviation/notation/shorthand/symbole/lettre/abréviation/zeichen/abkürzung/símbolo/letra ¤ (here/ici/hier/aquí) is/means/denotes/stands/désigne/signifie/bezeichnet/steht/designa
inclination/inclinaison/neigung/inclinación
coordinate system/systems (…) fixed/attached/tied/of (rigidly) (to) (the) link/first/second/body/forearm
auxiliary/auxiliaire/intermediate/intermédiaire/internal/temporary/hilfs~/auxiliar/intermedia quantity/variable/grandeur/value/größe/magnitud
absolute/absolus/absoluten/absolutos (link/joint) angles/angle/winkel
base line
approché~/approchée~/angenähert~/aproximad~
point/place (here/considered/in) (question) (considered) is (not) (the)
convention/conventions of/du/des/de (the) (la) manufacturer/vendor/constructeur/fabricant/herstellers/fabricante/costruttore
conventions/convention … those/that/celles/celle of/de/d' (the) (another/second/other/un/une)
holds/valid/applies/written/vaut/valable/valide/écrite/gilt/gültig/vale/válida/valida/válido (only) for/in/with/pour/dans/avec/für/in/para/con/per (a/an/the/une/un/l'/eine/einen/einer/un') another/other/different/autre/andere/anderen/anderer/otro/otra/altra/altro convention/origin/choice/table/numbering/origine/choix/tableau/numérotation/konvention/wahl/ursprung/convención/origen/elección/convenzione/scelta
another/other/different/autre/anderen/anderer/otro/otra/altro/outro point/quantity/body/frame/joint/link/punkt/punktes/grandeur/größe/punto/magnitud
^ (…) find/determine/give/compute/state/trouver/trouvez/déterminer/déterminez/donner/donnez/bestimmen/finde/bestimme/hallar/determinar/encontrar … for/pour/für/para which/lesquelles/lesquels/laquelle/lequel/quelles/welche/los/las/qué
keeps/keep/kept (…) (its/the) orientation/direction/horizontal/vertical/level
after/après/nach/tras/después (a/the/une/un/la/einer/der/una) (first/…) turn/rotation/quarter/shift/translation/displacement/move/drehung/verschiebung/giro/rotación
base/frame/origin/axes (…) (has/have/is/are/was/were) (been) turned/rotated/shifted/displaced/moved/tilted/inclined/mirrored/flipped by/through/to/about
"""
NEARLY = """
first/second/leading/third/premier/deuxième/erster/zweiter order/ordre/ordnung
erster/primera näherung/aproximación
approximat~/linearis~/lineariz~/linéaris~/neglect~/néglige~/vernachlässig~/näherungsweise/roughly
à peu près
for/if/pour/für/para small/de/kleine/pequeños (petits/petites) (angles) (winkel) (ángulos)
angles are small
up to a/the/terms (of) (sign/factor/constant/second/third)
up to sign
au signe près
bis auf
salvo el signo
absolute value
either sign
from the sign
within (one/a/two/#) percent
≪
"""
OF_NO_CLAIM = """
would/might/could/were/expected/serait/aurait/pourrait/wäre/würde/sería
replace/remplacez/remplacer/ersetze
cross out
^ where * has $
leaflet/rumour/web
^ option/choice/candidate/choix/candidat/opción/opzione/opção (¤/a/b/c/d/e/i/ii/iii/iv/1/2/3/4/5) : $
(proposed/possible/candidate/first) answer/solution/proposition/propuesta/proposta/vorschlag (de/d'/di) (réponse/solution/respuesta/solución/risposta/lösung) (¤/a/b/c/d/1/2/3/4) : $
proposition/propuesta/proposta/proposal (de/d'/di) (réponse/solution/respuesta/solución/risposta)
lösungsvorschlag/antwortvorschlag
counterexample/counter-example/contre-exemple
dire/vérifiez/vérifier si
"""
ITS_ANSWER = """
^ (the/a/la/die/el/il) (full/complete/detailed/final/model/worked/short/complète/détaillée/vollständige/completa/detallada) answer/solution/réponse/solución/respuesta/soluzione/risposta/lösung/antwort/solução/resposta : $
"""
SUPPOSED = """
as a hypothesis
if we/one/it had/were
"""
JOINTS_FROM_ZERO = """
joints/angles/axes/motors (…) counted/numbered/indexed/number/count (…) from/at/with zero/0
numbering/counting/indices/index (of) (the) (joints/angles/axes/motors) starts/start/begins/begin (…) from/at/with zero/0
articulations/angles/axes/moteurs (…) numéroté~/compté~/indexé~ (à) (partir) de/depuis zéro/0
gelenke/winkel/achsen/motoren (…) (ab/von/bei) null/0 (an) gezählt/nummeriert/indiziert
articulaciones/ángulos/ejes/motores (…) numeran/cuentan/numerados/contados (…) desde/de/por cero/0
giunti/angoli/assi/motori (…) numerati/contati/numerano/contano (…) da zero/0
juntas/ângulos/eixos/motores (…) numerados/contados/numeradas (…) de/do/desde zero/0
"""
_SEEK = (
    "find/finds/determine/sketch/draw/compute/calculate/give/list/name/seek/look/search/solve/choose/want/sought/wanted/trouver/trouvez/trouve"
    "/cherche/chercher/cherchons/cherchez/déterminer/déterminez/calculer/calculez/esquisser/dessiner/dessinez/tracer/donner/donnez/bestimme"
    "/bestimmen/finde/finden/suche/suchen/gesucht/zeichne/zeichnen/skizziere/skizzieren/berechne/berechnen/ermittle/ermitteln/gib/halla/halle"
    "/hallar/encontrar/encuentre/encuentra/busca/buscamos/determinar/determine/calcular/calcule/dibuje/dibujar/trova/trovare/trovate/cercare"
    "/cerchiamo/determina/determinare/calcola/calcolare/disegna/disegnare/encontre/procure/calcule/esboce"
)
_UNKNOWNS = (
    "¤/angle/angles/configuration/configurations/posture/postures/pose/poses/value/values/lengths/solutions/places/instants/positions/arms"
    "/konfiguration/konfigurationen/stellung/stellungen/lage/lagen/winkel/werte/wert/längen/punkte/valeur/valeurs/longueurs/points/posición"
    "/posiciones/postura/posturas/configuración/configuraciones/ángulo/ángulos/valores/valor/posizione/posizioni/configurazione/configurazioni"
    "/angolo/angoli/valori/valore/configuração/configurações/posição/posições/ângulo/ângulos"
)
_POSTURES = (
    "posture/postures/configuration/configurations/pose/poses/angles/values/stellung/stellungen/konfiguration/konfigurationen/winkel/valeurs"
    "/posturas/configuraciones/ángulos/configurazioni/angoli/configurações/ângulos"
)
SOUGHT = f"""
{_SEEK} * {_UNKNOWNS} (¤) (,) with/where/satisfying/fulfilling/from/mit/wo/avec/où/vérifiant/satisfaisant/con/donde/dove/com/onde/at $
{_SEEK} * {_UNKNOWNS} (¤) (,) such/telle/telles/tel/tels/so/tal/tales/tale/tali/tais that/que/dass/che/qu' $
{_SEEK} * {_UNKNOWNS} (¤) (,) (and) that/which/qui/die/que/che satisfy/satisfies/fulfil/fulfils/fulfill/fulfills/make/makes/solve/solves/vérifient/vérifie/satisfont/erfüllen/erfüllt/cumplen/satisfacen/soddisfano/satisfazem $
{_SEEK} * {_UNKNOWNS} (¤) (,) for/at/pour/en/für/bei/in/an/para/per/nelle/nei (the/los/las/le/la) which/lesquelles/lesquels/lequel/laquelle/denen/der/die/das/dem/que/cuales/quali/quais (we) (on) (have/has/is/a/gilt/ist) $
{_POSTURES} (¤) (is/are/est/sont/ist/sind/es/son/è/sono) (,) such/telle/telles/tel/tels/so/tal/tales/tale/tali/tais (chosen) that/que/dass/che/qu' $
{_POSTURES} (¤) (,) that/which/qui/die/que/che satisfy/satisfies/fulfil/fulfils/fulfill/fulfills/vérifient/vérifie/satisfont/erfüllen/erfüllt/cumplen/satisfacen/soddisfano/satisfazem $
which/quels/quelles/quelle/quel/welche/welcher/welches/cuáles/qué/quali/quale/quais (…) {_UNKNOWNS} (…) (¤) satisfy/satisfies/fulfil/fulfils/solve/solves/give/gives/lead/vérifient/vérifie/donnent/erfüllen/erfüllt/ergeben/cumplen/soddisfano/satisfazem (to) $
until/bis/jusqu'/hasta/finché/fino/até (à/a) (ce) (que/qu'/che) $
how/wie/de/cuánto/quanto far/much/long/weit/combien … must/has/have/needs/muss/faut/debe/deve (…) (to) (have/haben/avoir/tener/avere) $
"""
ON_CONDITION = """
^ & if/when/whenever/si/quand/lorsque/lorsqu' % , (then/alors) (we/on) (get/have/find/obtain/a/obtient/trouve) $
"""
WE_DO = """
^ & if/when/whenever/si/quand/lorsque/lorsqu' we/one/you/i/on/nous/l'
"""
ASKED_BEHIND = """
true/false/right/wrong/correct/so/agree/think/it/case/vrai/faux/exact/juste/accord/richtig/falsch/das/cierto/verdadero/falso/correcto/why ? $
"""
OPEN_QUESTION = """
^ (and/but/so/et/mais/und/aber/y/e) what/how/where/when/who/whose/which/comment/que/qu'/quel/quelle/quels/quelles/où/quand/qui/wie/was/wo/wer/welche/welcher/welches/cómo/qué/dónde/cuál/cuáles/quién/come/che/cosa/dove/quale/quali/chi/como/onde/qual/quais/quem
^ why/pourquoi/warum/perché/porquê ?
^ por que/qué ?
"""
SINGULAR_ASKED = """
^ (and/but/so/et/mais/und/aber/y/e) at/in/for/pour/dans/en/à/bei/für/para/per/em which/what/quelle/quelles/welchen/welcher/welche/qué/cuáles/quali/quale/que/quais configuration~/configurac~/configuraç~/configuraz~/konfiguration~/posture~/pose~/position~/stellung~/lage~/posicion~/posizion~/posiç~ (…) singular/singulier/singulière/singulär/singolare
"""
REASON_ASKED = """
^ (and/but/so/et/mais/und/aber/y/e) why/pourquoi/warum/wieso/perché/porquê
^ (y/e) por que/qué
"""
SAYS_LIMITS = """
^ * counterexample/counter-example/contre-exemple/gegenbeispiel/contraejemplo/controesempio/contraexemplo
^ whether/if/si/ob (or) (not) (this/it/that/cela/c'/das/es/esto) (…) true/right/so/correct/holds/valid/exact/vrai/richtig/stimmt/cierto
^ * remains/remain/reste/bleibt/queda/resta/is/est/ist/es (yet/still/noch) (to/à/zu/por/da) (be/bewiesen) verified/proved/proven/checked/tested/seen/shown/vérifier/prouver/démontrer/voir/prüfen/zeigen/beweisen/comprobar/demostrar/verificare
^ * válida/válido/vale/vrai/vraie/valable/valida/valido (que) solo/sólo/solamente/seulement/apenas/somente/nur (para/pour/per/en/em)
^ * válida/válido/vale/vrai/vraie/valable/valida/valido (que) para/pour/per/en/em
"""
LIMITED_BEHIND = """
^ (only) (and) (et) if/when/whenever/provided/assuming/supposing/unless/except/lorsque/lorsqu'/quand/pourvu/sauf/si/falls/wenn/sofern/cuando
"""

AT_WORDS = """
^ & with/for/at/when/if/where/setting/putting/taking/pour/avec/si/quand/lorsque
"""
AT_VALUES = """
^ & with/for/at/when/if/in/where/setting/substituting/putting/taking/pour/avec/en/si/quand/lorsque/à/dans/für/mit/bei/wenn/para/con/cuando/per/quando/nel (the/this/that/both/all/la/le/les/l'/cette/deux/das/dem/der/den/el/il) (case/cas/fall/caso/pose/posture/position/configuration/stellung/konfiguration/configuración/configurazione) (of/where/when/in/which/où) ¤ * $
^ & with/if/when/where/while/avec/si/quand/lorsque/wenn/con/cuando/quando % (is) (are) (est) (ist) (está) (è) locked/held/fixed/blocked/frozen/kept/bloqué/bloquée/fixé/fixée/maintenu/maintenue/bloqueado/bloqueada/bloccato at/to/in/à/en/auf/bei/a ¤ * $
^ & (,) (c'/that/das/es/cioè/esto) est-à-dire/is/heißt/ist/es (,) ¤ * $
^ & (the/this/our/la/le/l'/die/das/el/il) jacobian/matrix/determinant/position/expression/result/jacobienne/matrice/déterminant/matriz/jacobi-matrix/jacobimatrix/determinante/jacobiano * becomes/reduces/simplifies/is/reads/devient/vaut/est/s'/wird/ist/lautet/es/queda/diventa (to/then/alors/écrit/simplifie/réduit) (to) for/at/when/if/with/pour/en/si/quand/lorsque/für/bei/wenn/para/cuando/per/quando ¤ $
^ & (the/first/second/third/1/2/3/4) case/cas/fall/caso/example/exemple/beispiel/ejemplo/esempio (#) (a/b/c/d/i/ii/iii/iv/one/two/three/un/deux) (:) (for/when/if/pour/si/quand/für/wenn/para) ¤ * $
^ & (in) (dans) (the/le/la/l'/im/en/el) first/second/third/latter/former/premier/deuxième/second/ersten/zweiten/primer/segundo (case/cas/fall/caso) ¤ * $
^ & (for/par/zum/por/per) example/exemple/beispiel/ejemplo/esempio/instance (at/for/with/pour/avec/bei/für/mit/para/con/per) (we/on/wir) (take/prend/nehmen) ¤ * $
^ & (now) (numbers) (we/on/wir/man) take/takes/put/prend/prenons/nehme/nehmen/nimmt ¤ * $
^ % ¤ (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) : $
"""
OF_A_POSTURE = """
(the/an/a/le/la/l'/der/die/das/el/il) (fully/completely/straight/special/particular/singular/complètement/ganz) arm/robot/manipulator/configuration/posture/pose/singularity/elbow/angle/value/bras/coude/valeur/singularité/brazo/braccio
(is/are/est/ist/está/è) (fully/completely/straight/complètement/ganz) stretched/extended/folded/straight/singular/tendu/replié/plié/déplié/gestreckt/extendido/estirado/disteso (out/back)
"""
GIVES_VALUES = """
^ & (from) (here/now) (on) (,) (we) let/suppose/assume/consider/take/set/put/fix/keep/hold/soit/supposons/prenons/posons/considérons/fixons/sei/setzen/sea/supongamos/tomemos/sia/supponiamo * ¤ (and/et/und/y/e) (¤) $
^ & (,) ¤ (and/et/und/y/e) (¤) $
^ & in/dans/en this/cette/ce/diesem/questo/este/esta section/subsection/paragraph/part/case/question/exercise/paragraphe/partie/cas/exercice/abschnitt/fall/sección/caso/sezione (,) (we) (have) (on) (a) ¤ (and/et/und/y/e) (¤) $
^ & (the/this/le/der/el/il) (is/est/ist/está/è) for/at/when/if/pour/en/si/quand/lorsque/für/bei/wenn/para/cuando/per/quando ¤ $
"""
OF_VALUES = """
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio/problem/problème/task/step/part/partie) (#) (.) (:) (the/a/le/la/l'/der/die/das/el/il) (#/first/second/third) (singular/special/particular/stretched/folded/extended/numerical) case/cas/fall/caso/example/exemple/beispiel/ejemplo/esempio/configuration/konfiguration/configuración/configurazione/posture/pose/singularity/singularité/singularität/singularidad (singulière/singulier/particulier/particulière) (#) (a/b/c/d/i/ii/iii/iv/one/two/three/un/deux) (:) (the/le/la/l') (where/où) (for/when/if/at/pour/si/quand/à/für/wenn/bei/para/en) ¤ (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) $
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio/problem/problème/task/step/part/partie) (#) (.) (:) (for/when/if/at/pour/si/quand/für/wenn/bei/para/per) ¤ (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) $
^ (#) (.) (the/a/le/la/l'/der/die/das) home/rest/zero/initial/upright/reference/vertical/horizontal pose/position/posture/configuration (:) (for/at/where) ¤ (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) (and/et/und/y/e) (¤) $
"""
GOAL = """
goal/target/aim/reach/reached/desired/wanted/cible/but/objectif/atteindre/atteint/souhaité~/voulu~/désiré~/visé~/consigne/ziel~/soll/sollwert~/erreicht~/gewünscht~/objetivo/meta/alcanzar/deseado~/deseada~/obiettivo/raggiungere/desiderat~/bersaglio/alvo/alcançar/desejad~
"""
NOT_THERE = """
away/other/others/otherwise/else/elsewhere/general/generally/generic/all/any/every/each/always/everywhere/anywhere/beyond/outside/except~/exclud~/avoid~/leave/leaves/leaving/left/unless/not/never/no/arbitrary/whatever/whether/regardless/without/until/before/after/unlike/contrary/instead/usual~/remaining/rest
ailleurs/autre/autres/général~/tout/toute/tous/toutes/chaque/toujours/partout/sauf/hors/hormis/exclu~/évit~/quelconque~/quel/quelle/quels/quelles/ne/n'/pas/jamais/sans/sinon/avant/après/contrairement
außer/außerhalb/sonst/allgemein~/alle~/jede~/immer/überall/nicht/kein~/beliebig~/ohne/vor/nach/anders/andere~/übrig~
siempre/todo/todos/toda/todas/general/cualquier~/salvo/excepto/no/otro~/otra~/fuera/sin/antes/después/nunca/demás
sempre/tutt~/ogni/generale/salvo/tranne/altr~/qualsiasi/qualunque/non/fuori/senza/prima/dopo/mai
todo~/toda~/qualquer/exceto/outro~/outra~/geral/não/fora/sem/depois/nunca
"""
BECOMES = """
^ & (the/this/our/la/le/l'/die/das/el/il) jacobian/matrix/determinant/position/expression/result/jacobienne/matrice/déterminant/matriz/jacobi-matrix/jacobimatrix/determinante/jacobiano * becomes/reduces/simplifies/devient/wird/queda/diventa
"""
# -- what is made of the arm, or of the formula, before what is printed holds

CHANGED_BEFORE = """
^ & (by/on/upon/when/after) turning/exchanging/swapping/interchanging/mirroring/reflecting/reversing/shifting/rotating/doubling/halving/flipping/inverting * angle/angles/link/links/bar/bars/joint/joints/arm/robot/lengths/elbow/picture/figure/whole/everything
^ & if/when we/one/you/i (…) turn/exchange/swap/interchange/mirror/reflect/reverse/shift/double/halve/flip/rotate * angle/angles/link/links/bar/bars/joint/joints/arm/robot/lengths/elbow/picture/figure/whole/everything
^ & si l' on/nous (…) échange/échangeons/permute/permutons/tourne/tournons/inverse/inversons/double/doublons/retourne/retournons * angles/angle/bras/segments/barres/longueurs/articulations/robot/coude
^ & en échangeant/permutant/tournant/inversant/doublant/retournant * angles/angle/bras/segments/barres/longueurs/articulations/robot/coude
^ & vertauscht/dreht/spiegelt/verdoppelt/halbiert man * winkel/glieder/stäbe/längen/gelenke/arm/roboter/ellbogen
^ & (al/si) (se/intercambiando/intercambiar/girando/girar/invirtiendo/invertir/intercambian/giran/invierten) ángulos/eslabones/barras/longitudes/brazo
^ & scambiando/ruotando/invertendo/raddoppiando/specchiando * angoli/bracci/aste/lunghezze/braccio/giunti
^ & trocando/girando/invertendo/dobrando/espelhando * ângulos/elos/barras/comprimentos/braço/juntas
* takes/turns/carries/changes/transforms/sends/brings/maps (all) this/it/that/these/them/everything (…) to/into $
^ & another/second/third/next/further (one/turn/step/half/quarter) (…) to/into $
"""
HELD_IN_WORDS = """
^ & (while/when/by) keeping/holding/leaving % fixed/constant/unchanged
% is/are/being (held/kept/left) fixed/constant/unchanged , $
at/with/for (a) fixed/constant/unchanged (…) direction/orientation/inclination/attitude
en gardant/maintenant/laissant % fixe/fixes/constant/constante/constantes/inchangé/inchangée
à direction/orientation/inclinaison % fixe/fixée/constante
bei/mit festgehaltener/fester/konstanter/gleicher richtung/orientierung/neigung/lage
manteniendo/tenendo/mantenendo/mantendo % fija/fijo/constante/fissa/fisso/costante/fixa/fixo/constante
"""
# -- how the joints move

EVEN_RATES = """
constant/uniform/steady/even/unchanging/fixed (and) (equal) joint/motor/axis/angular/articular (angular) rate/rates/speed/speeds/velocity/velocities
constant/uniform/steady/even/unchanging rates/speeds/velocities (of) (the) (joints/motors/axes)
(joint/motor/angular) rates/speeds/velocities (…) constant/uniform/steady/unchanging $
(joint/motor/angular) rates/speeds/velocities (of) (the) (joints/motors) is/are/being/remain/stay/remaining/kept (…) constant/uniform/steady
joints/motors/axes/links/both/all/arm (…) turn/turns/turning/run/runs/running/rotate/rotates/rotating/move/moving (…) evenly/uniformly/steadily
joints/motors/axes/links/both/all (…) turn/turning/run/running/rotate/rotating (…) at constant/uniform/steady rate/rates/speed/speeds/velocity
vitesse/vitesses articulaires/angulaires/articulaire/angulaire (…) constantes/constante/uniformes
vitesses constantes (des/de) (articulations/moteurs/rotation)
(articulations/moteurs/axes) tournent/tournant (…) uniformément/régulièrement
konstanten/konstanter/konstante/gleichbleibenden gelenkgeschwindigkeiten/gelenkgeschwindigkeit/winkelgeschwindigkeiten/winkelgeschwindigkeit/drehgeschwindigkeiten/gelenkraten/drehzahlen
(gelenkgeschwindigkeiten/winkelgeschwindigkeiten) … konstant/konstante
gelenke/motoren/achsen … gleichförmig/gleichmäßig
velocidades/velocidad articulares/articular/angulares/angular (…) constantes/constante
velocità (di/dei/articolari/angolari) (giunto/giunti) (…) costanti
velocidades das juntas/articulações (…) constantes
"""
NO_RATES = """
start/starts/started/starting/begin/begins/beginning/released/set/sets/leave/leaves (out/off) (moving) from rest
acceleration/accelerations … from rest
accélération/accélérations … du/au repos/départ/démarrage
beschleunigung/beschleunigungen … aus der ruhe
arm/joints/robot/motors/axes/links/manipulator/mechanism/everything (…) at rest
joints/motors/axes/links/arm/robot/manipulator (…) stand/stands/standing/is/are (all/both) still/motionless
in/at/from (the) (very) (first) moment/instant of starting/departure
(joint) velocities/rates/speeds (…) zero/nil/null/vanish/vanishing
zero/vanishing/no/without (any) (joint/initial/angular) rates/velocities/speeds
vitesses (articulaires/angulaires/initiales) (…) nulles
bras/articulations/robot/manipulateur (…) au repos
(part/partant/démarre/démarrant) (du/de) (l') repos/arrêt
à l' (instant) (du) démarrage
au (moment) (du) démarrage
aus der ruhe
aus dem stillstand
gelenkgeschwindigkeiten/geschwindigkeiten/winkelgeschwindigkeiten … null
(gelenke/arm/motoren) … (still) stillstehen/stillsteht/ruhen/ruht
velocidades (articulares) (…) nulas
brazo/articulaciones/robot (…) en reposo
parte/partiendo del reposo
velocità (di/dei/articolari) (giunto/giunti) (…) nulle
parte/partendo da fermo
parte/partindo do repouso
"""
EVENLY = """
evenly/uniformly/steadily
constant/uniform/steady/unchanging rate/speed/velocity
vitesse constante/uniforme
gleichförmig/gleichmäßig
konstanter/konstante geschwindigkeit
velocidad constante
velocità costante
velocidade constante
"""
OF_OTHER_MOTION = """
unless/except/whether/until/before/after/instead/unlike/were/would/ago/later/already/earlier/almost/nearly
moins/sauf/avant/après/presque/außer/bevor/nachdem/fast/salvo/excepto/antes/después/casi/tranne/prima/dopo/quasi/depois/exceto
first/second/third/fourth/last/one/single/only/alone/other/tool/tip/hand/gripper/end-effector/load joint/joints/motor/motors/axis/link/links/one/rate/rates/speed/velocity/moves/moving/turns/turning/runs/starts/stands/rests
only/seul/seule/seulement/nur/sólo/solo/apenas
rate/speed/velocity/motion of (the) first/second/third/last/tool/tip/hand/gripper/end-effector
premier/première/deuxième/second/seconde/dernier/dernière articulation/moteur/axe/liaison/bras
erste/ersten/zweite/zweiten/letzte/letzten/dritte gelenk/gelenks/motor/achse/glied
"""
# -- another point, frame, origin or axis than the tool's in the base

ASKED_FOR = """
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio) (#) (.) (:) give/find/compute/calculate/determine/derive/show/express/write/state
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio) (#) (.) (:) donner/donnez/calculer/calculez/déterminer/déterminez/montrer/montrez/exprimer/exprimez/trouver/trouvez/établir/écrire
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio) (#) (.) (:) bestimme/bestimmen/berechne/berechnen/zeige/zeigen/gib/ermitteln
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio) (#) (.) (:) calcular/calcule/hallar/halle/determinar/determine/demostrar/encontrar
^ (question/exercise/exercice/aufgabe/frage/ejercicio/esercizio) (#) (.) (:) calcolare/calcola/trovare/trova/determinare/determina/mostrare/ricavare
"""
OTHER_POINT = """
elbow/coude/codo/ellbogen/gomito/cotovelo at/in/bei/en/à/a $
height/heights/abscissa~/ordinate~/hauteur/abscisse/ordonnée of/du/del (the) elbow/coude/codo
elbow/elbow' (s) itself/position/coordinates/height/velocity/speed
elbow/coude/codo/ellbogen is/lies/sits/has/est/se/a/está/tiene/liegt at/bei/en/in/position/velocity/height/with/pour/by/trouve/situe/given
elbow/coude/codo/ellbogen is/lies/has/est/está $
^ (the/l'/le/el/and/now/next/then) (the/l'/le/el) elbow/coude/codo : $
for/of/at/to/with/pour/de/à/au/du/para/del/en (the/l'/le/el) elbow/coude/codo : $
for the elbow (joint) $
where the (two) links/bars meet
i . e . the end
is/be/est the/le elbow/coude $
end/ends of (the) first link
end of link 1
(of/for) (the) first link alone/only
midway/halfway along/between/down/up
à mi-chemin/mi-longueur
auf halbem weg
a mitad
centro/centre/mitte/meio/mezzo (del/de/du/della/do/da/des) (primer/segundo/tercer/último/premier/deuxième/second/dernier/primo/secondo/terzo/ersten/zweiten/letzten/primeiro) eslabón/segment/bras/corps/braccio/membro/gliedes/elo
position of joint #
midpoint/mid-point/milieu/barycentre
middle of (the) (first/second/third/last) link
camera/sensor/lamp/caméra/capteur/lampe/kamera/sensor/lampe/cámara/sensor/telecamera/câmera (is/sits/hangs/est/ist/sitzt/está/è/va/se/si/é) (trouve/encuentra/trova) bolted/mounted/fixed/attached/screwed/clamped/glued/welded/placed/fixée/fixé/montée/monté/vissée/montiert/befestigt/montada/montado/fijada/fijado/colocada/fissata/montata/fixada/from/on/auf/am/en/sur/sul/sulla
cent~ of mass/gravity
cent~ of (the) (first/second/third/last) link/bar/rod
centre de masse/gravité
centro de masa/gravedad
unit vector
vecteur unitaire
einheitsvektor
vector unitario
average/mean velocity/speed
prismatic/revolute (joint) instead/rather (of) (than)
prismatique/rotoïde au/plutôt (lieu) (que) (d') (de)
(to/for/of/pour/du/für/para/del/per) (an/the/un/l'/den/el/l') other/another/different/autre/anderen/otro/altro/outro arm/robot/manipulator/bras/roboter/brazo/braccio/braço
"""
OTHER_FRAME = """
resolved/expressed/components/decomposed/projected … along/onto/on (and) (across) (the/its) (first/second/third/last/upper) forearm/link/bar/rod/segment
exprimée/exprimées/composantes/décomposée/décomposées/projetée/projetées … selon/suivant/sur (l'/le/la) (premier/deuxième/second/dernier) avant-bras/segment/barre/bras
in/from/dans/relative/respect (to) (the/le) frame/repère 1/2/3/4/5/6/7/8/9
^ (expressed/written/resolved) in/with (respect) (to) (the/a) tool/tool'/body/moving/gripper/gripper'/end-effector/effector/effector'/hand/wrist (s) frame/coordinates/axes
expressed/resolved/written/given/computed/measured/represented/described/components/coordinates/vectors/quantities/everything … in/along/to (respect) (to) (the/a/its/their) (axes/frame) (of) (the) (end) tool/tool'/body/moving/gripper/gripper'/end-effector/effector/effector'/hand/wrist (s) (frame/coordinates/axes) $
expressed/resolved/written/given/computed/measured/represented/described/components/coordinates/vectors/quantities/everything … in/along/to (respect) (to) (the/a/its/their) tool/tool'/body/moving/gripper/end-effector/effector'/hand/wrist (s) frame/coordinates/axes
^ in/into/dans/im/en (the) frame of the (end) tool/gripper/hand/effector/end-effector
repère (de/du) (l'/la) (lié) (à) (l') outil/effecteur/pince/main
in/into/along (the/a/its) frame/axes/coordinates/basis (that) (is) (fixed/attached/bound/tied) (of/to/on/with) (the) (first/last/moving/end/second/third/upper) forearm/arm/tool/tip/hand/gripper/end-effector/effector/body/flange/wrist/link
body/spatial/body-frame/tool-frame/end-effector-frame (manipulator/geometric) jacobian/velocity/twist
in/into (the/a) moving/rotating/local frame/coordinates/axes
in/into (its/their) own frame/coordinates/axes
in body/tool/end-effector/gripper/effector (frame) coordinates/axes
dans son propre repère
passage du repère 1/2/3/4/5/6/7/8/9
nella/alla terna 1/2/3/4/5/6/7/8/9
im/in koordinatensystem/system 1/2/3/4/5/6/7/8/9
en el sistema/marco 1/2/3/4/5/6/7/8/9
repère mobile
dans (le/un/la) repère/base (lié/liée/attaché) (au/à/du/de/d') (l'/la/le) (premier/dernier/second/deuxième) avant-bras/outil/effecteur/pince/main/organe/corps/segment/poignet/solide
im/in werkzeugkoordinatensystem/effektorkoordinatensystem/endeffektorkoordinatensystem/greiferkoordinatensystem/tcp-koordinatensystem/werkzeugsystem/effektorsystem/endeffektorsystem/tcp-system/körperfesten
im/in koordinatensystem/system/bezugssystem des/vom (ersten/zweiten/dritten/letzten) unterarms/oberarms/gliedes/glieds/werkzeugs/endeffektors/effektors/greifers/handgelenks/tcp
en/al (el) sistema/marco/referencial (de) (coordenadas/referencia) (ligado/fijo/unido/solidario) (de/del/a/al) (la/el) (primer/segundo/tercer/último) eslabón/antebrazo/herramienta/efector/pinza/mano/muñeca
nella/nel/alla/al/in terna/sistema/riferimento (di) (riferimento) (solidale) (dell'/della/del/al/all'/alla/di) (primo/secondo/terzo/ultimo) braccio/membro/link/avambraccio/utensile/pinza/organo/end-effector/effettore/mano/polso
no/ao referencial/sistema/quadro (de) (coordenadas) (da/do) (primeiro/segundo/último) elo/antebraço/ferramenta/efetuador/garra/punho/mão
seen * from/on the tool/gripper/hand
frame/system/axes/repère/système/koordinatensystem/bezugssystem/sistema/marco/terna (,) (that) (which) (qui) (das) (que) (che) (is) turns/turning/moves/moving/rotates/rotating/carried/travels/tourne/bouge/dreht/bewegt/gira/mueve/ruota/muove (sich) (along) with/by/avec/mit/con/com
koordinatensystem/bezugssystem/system , das sich mit
^ & for/in/with/pour/dans/für/in/para/en (a/an/the/un/une/le/ein/einem/einen/das/el) frame/system/axes/repère/système/koordinatensystem/bezugssystem/sistema/marco (that) (which) (is) (das) (um) (¤) turned/rotated/tilted/shifted/tourné/incliné/décalé/gedreht~/gedrehtes/girado/rotado/ruotato
another/different/second/autre/anderes/anderen/otro/altro (coordinate) frame/system/repère/koordinatensystem/sistema turned/rotated/tilted/tourné/gedreht/girado/ruotato (by/through/de/um/di) (¤)
"""
ORIGIN_AT_SHOULDER = """
origin/origine/ursprung/nullpunkt/origen/origem … at/in/into/to/à/dans/an/auf/en/nella/no (the/l'/die/der/el/la/o) shoulder/épaule/schulter/hombro/spalla/ombro
as/comme/als/como/come (the) origin/origine/ursprung/origen/origem (the/l'/die/der/el/la/o) shoulder/épaule/schulter/hombro/spalla/ombro
shoulder/épaule/schulter/hombro/spalla/ombro as/comme/als/como/come (the) origin/origine/ursprung/origen/origem
"""
FROM_SHOULDER = """
counted/measured/relative/seen/viewed/reckoned/starting from/to the shoulder
^ & from/above/below/over the shoulder
height/altitude above/over/below the shoulder
^ & depuis l' épaule
^ & à partir de l' épaule
mesuré~/compté~/vue~/part/partant/partir depuis/de l' épaule
par rapport à l' épaule
hauteur/altitude au-dessus de l' épaule
^ & von der schulter (aus)
von der schulter (aus) gemessen/gezählt/gesehen
relativ zur schulter
medida~/vista~/contada~ desde el hombro
^ & desde el hombro
respecto al/del hombro
misurata~/vista~ dalla spalla
^ & dalla spalla
rispetto alla spalla
medida~/vista~ a partir do ombro
em relação ao ombro
"""
OTHER_ORIGIN = """
origin (of) (the) (base) (frame) (is/lies/sits/stands) (placed/taken/put/chosen) at/in/into/to (the) elbow
(seen/viewed/looked) (at) from the other/opposite/back side
(seen/viewed/looked) from behind/below/underneath
as/comme/als/como/come (the) origin/origine/ursprung/origen/origem (the/le/der/den/el/il/o) elbow/coude/ellbogen/codo/gomito/cotovelo/wrist/poignet
elbow/coude/codo/gomito/ellbogen/cotovelo (is/est/wird/es/è) (taken/chosen/pris/choisi) as/comme/als/como/come (the) origin/origine/ursprung/origen/origem
origin * at joint 2/3/4
origin lies ¤ below/above
counted/measured/relative/seen from/to the elbow
origine (est) (placée) au/à (l') coude/poignet
(is/stands) at (a) height ¤ above
base is raised/lifted
stands/mounted on a pedestal
base est surélevée/relevée
y-axis … down~/unten/bas/abajo
x-axis … left/down/downward/downwards/gauche/bas/unten/links/izquierda/abajo
arm/robot/manipulator/base/bras is/hangs/est (mounted/fixed/suspended/installed) upside down
arm/robot/manipulator is/hangs (mounted/fixed/suspended) (down) from/on the/a ceiling/wall
measured/given/expressed in pixels
image coordinates
^ * y (axis) points/pointing down~
origin is/lies (placed/taken) at/in the tip/end of
base/shoulder is/stands/lies/sits (placed/located) at (a/the) height
base/shoulder (is) displaced/shifted (by)
base/shoulder is offset (by)
base/shoulder offset by
after (a) (the) reflection
seen/viewed/looked in/through (a/the) mirror
mirrored/mirror-image/mirror image/version/arm
vu/vue/dans un miroir
en miroir
spiegelbildlich~/gespiegelt~
im spiegel
reflejado/especular/espejo
left and right (are) exchanged/swapped/interchanged
count/counts/counted/measured/reckoned (here) from where/wherever
¤ (are/is) count/counts/counted/measured/reckoned (here) from (the) (tool's) start/starting/initial (point/position/place/posture)
¤ (sont/est) compté~/mesuré~ (ici) depuis/à (partir) (de/du) (la/le/l') (point/position) (de) départ/initiale
¤ (werden/wird) (…) vom/ab (dem) startpunkt/anfangspunkt/ausgangspunkt (aus) gezählt/gemessen
¤ (se) (…) miden/cuentan/contano/misurano/contam/medem desde/dal/do (el) punto/ponto de/di partida/partenza/inicial
x-axis … vers la gauche
"""

# -- angles that are not those of the arm

LEVEL = """
motor/motors/moteur/moteurs/motoren/motores/motori/actuators … in/on/at/dans/sur/im/an/en/nella/na (the/le/la/der/dem/den/el) base/ground/bâti/socle/embase/basis/gestell/sockel/basamento
¤ * with/to/and/from (the/a) fixed direction/line/axis
¤ * avec/et/à (la/l'/une/un) direction/droite/axe fixe
¤ * mit/zur/und (der/einer) festen richtung/achse
¤ … over/by/via/with/through (a/the) belt/belts/parallelogram
¤ … par (une/un) courroie/parallélogramme
¤ is/are that/those/the (angle/direction/orientation/inclination) of (the) (first/second/third/last) forearm/link/bar/rod/segment in space
¤ est celui/celle/l' (angle/orientation/inclinaison) de (l'/la/le) (deuxième/dernier) avant-bras/segment/barre dans l' espace
angle/angles/winkel/ángulo/ángulos/both/all/each/¤ * to/from/with/against/of/and/à/depuis/desde/avec/et/l'/gegen/zur/zum/con/mit/und/la/die (the/l'/la/le/die/der) (fixed/base/world) horizontal/horizontale/horizontalen/ground/floor/sol/boden/suelo/x-axis
respect to (the) horizontal/ground/floor/x-axis
¤ * direction/orientation/inclination of * in the base frame
absolute (joint/link/bar/segment) angles/coordinates
angles/angle … as/comme/als/como/come (absolute/absolus/absolue/absolues/absoluten/absolutos) orientations/directions/inclinations/orientation/direction/inclinations (of/des/de/der) (the/los/les) links/segments/glieder/eslabones
angles/angle … as/comme/als/como/come absolute/absolus/absoluten/absolutos
angle/angles/ángulo/ángulos/winkel (¤) (and/et/y/und) (¤) (are/is/est/sont/son/sind) (all) absolu/absolus/absolute/absolut/absoluto/absolutos
¤ (and/et) (¤) (are/is/est/sont) (the) (an) (l') absolute/absolus/absolu
¤ est l' angle absolu
second/third/last/elbow/other angle is absolute/absolu
"""
NOT_RELATIVE = """
is/are not relative/measured (to/from) the first/previous link
"""
TURNED = """
measured/counted/mesuré~/compté~/gemessen/taken … from/depuis/desde/gegen/with (respect) (to) (the/la/die) vertical~/y-axis
measured/counted/taken/mesuré~/compté~/pris … par/à/respecto/rispetto (rapport/partir) (à/de) (a/alla) (la) vertical~/y-axis
counts/count/counting/measures/measure/measuring/compte/comptons/comptent/mesure/mesurons/zählt/zählen/cuenta/contamos/conta/contiamo … from/depuis/von/desde/dalla/da (the/la/der) vertical~/senkrechten/y-axis
points/pointing/lies/lying/pointe/pointant/zeigt/zeigend/apunta/punta … along/in/to/selon/suivant/vers/entlang/in/según/lungo (the/l'/der/el/la) (axe) y-axis/y-achse (,) (at/for/when/if/with/pour/quand/lorsque/für/bei/wenn/para/per/con) ¤
at/for/when/if/with/pour/quand/lorsque/für/bei/wenn/para/per/con ¤ (,) (the/it/le/il/der/er/el) (upper/first) (arm/link/bar/bras/barre/segment/stab/brazo/braccio) points/pointe/zeigt/apunta/punta … y-axis/y-achse
turns/turn/turned/rotates/rotate/rotated/turning/rotating (by) ¤ in (the) opposite/contrary/reverse sense/direction
¤ (is/are) counts/count/counted/measured/reckoned/positive in (the) opposite/contrary/reverse sense/direction
tourne/tournent/pivote/tournant de/d' ¤ (dans/en) (le) sens inverse/contraire/opposé
¤ (est/sont) (se) compte/compté/comptée/comptés/mesuré/mesurée/positif (dans/en) (le) sens inverse/contraire/opposé
dreht/drehen (sich) um ¤ in entgegengesetzter/umgekehrter richtung
¤ (wird) in entgegengesetzter/umgekehrter richtung gezählt/gemessen
gira/giran/ruota ¤ en/in/no (el) sentido/senso contrario/opuesto/opposto/inverso/contrário/oposto
measured/counted/taken clockwise
¤ … means/corresponds/signifies/signifie/correspond/bedeutet/entspricht/significa/corresponde … folded/replié~/gefaltet~/eingeklappt/plegado/ripiegato/hanging/upright/pendant
angle * with/between/and/avec/et (the/la) vertical/verticale/y-axis
miden/mide/misst/messen/gemessen/mesure/mesurent/misurano/misura/medem … desde/ab/von/depuis/dalla/da (la/der/a) vertical~/senkrechten/y-axis
clockwise
sens horaire
sens des aiguilles
im uhrzeigersinn
sentido horario
numbered * from the tip/tool/end/gripper/hand
number/count (the) joints/links/axes from the tip/tool/end/gripper/hand
numbered/counted (in) backwards/backward/reverse
roles of (the) sine/sines/cosine/cosines and (the) sine/sines/cosine/cosines (are/is)
¤ is/denotes/est (the/l') interior/internal/inner/included/intérieur angle
angle ¤ (is/vanishes) zero/0 when/if * folded
"""
# -- the rows of a Jacobian, or of a twist, in the other order

OMEGA_FIRST = """
angular/rotational (velocity/velocities/speed/part/block/component/components/rows/one) … top/above/first/uppermost
angular/rotational … before/over (the) linear/translational
angular/rotational (velocity/velocities/part/block/component/components/rows) (,) then/followed (by) (the) linear/translational
angular/rotational … first/upper/top three (rows/components/entries)
first/upper/top three rows/components/entries … angular/rotational/rotation/orientation
linear/translational (velocity/velocities/part/block/component/components/rows) … below/beneath/underneath/under/after (the) angular/rotational
first/zuerst/primero/prima come/comes/stand/stands … angular~/rotation~/winkel~/angolar~
on top stand/stands/come/comes/is/are (the) angular
rows 1 to/- 3 … angular/rotational/rotation
oben steht/stehen/ist/kommt/kommen (die) winkelgeschwindigkeit~/drehgeschwindigkeit~
en haut (se) est/trouve/figure/vient (la) (vitesse/partie) angulaire
arriba está/va/queda (la) (velocidad/parte) angular
in alto sta/è/va (la) (velocità/parte) angolare
angulaire~/rotation … haut/dessus/au-dessus/abord/premier/première/avant
angulaire~ (,) puis/ensuite/suivie/suivi (de/par/d') (la/les) (vitesse/vitesses/partie) linéaire~
trois premières/premiers lignes/composantes … angulaire~/rotation
zuerst … (die/der/den) winkelgeschwindigkeit~/drehgeschwindigkeit~/rotatorisch~/drehanteil
winkelgeschwindigkeit~/drehgeschwindigkeit~/rotatorisch~ … oben/zuerst/zuoberst
winkelgeschwindigkeit~/drehgeschwindigkeit~ (,) dann/gefolgt/danach
angular~ … arriba/encima/primero/cima/primeiro
angular~ (,) luego/después/seguida/depois (de/da) (la/a) (velocidad/velocidade/parte) lineal/linear
primero/primeiro (la/las/a/o) (velocidad/velocidade/parte) angular~
angolare … sopra/alto/prima/primo
angolare (,) poi/seguita (da/dalla) (la/quella) (velocità/parte) lineare
prima (la/quella) (velocità/parte) angolare
"""
# -- rotations one after another

TURNS = """
rotate~/rotation~/turn/turns/turned/turning/roll/tourn~/pivot~/drehung~/dreh~/gedreht/rota/rotar/giro/girar/gira/rotación/rotaciones/rotazione/rotazioni/ruota~
"""
AFTER_ONE_ANOTHER = """
then/followed/after/successive/successively/sequence/order/puis/ensuite/successives/successivement/ordre/dann/danach/anschließend/nacheinander/reihenfolge/luego/después/orden/poi/quindi/successive/ordine/successivamente
result/résultat/ergebnis/resultado/risultato is/est/wird/es/viene turned/rotated/tourné/gedreht/girado/ruotato
"""
FIXED_AXES = """
fixed/fixe/fixes/fest/feste/festen/raumfest/raumfeste/raumfesten/fijo/fijos/fisso/fissi/fisse/original/originale/initial/initiale/stationary/extrinsic/extrinsèque/extrinsèques/base/space/room/world/inertial/laboratory
"""
TURNED_AXES = """
moving/mobile/mobiles/current/courant/courants/new/nouvel/nouveau/nouveaux/turned/rotated/body-fixed/intrinsic/intrinsèque/intrinsèques/mitgedreht~/mitbewegt~/körperfest~/neue/neuen/móvil/móviles/nuevo/actual/corrente/correnti/nuovo/tourné/tournés/local/locaux
body axis/axes/frame/x-axis/y-axis/z-axis/¤
"""
# -- lengths and columns that are not those of the arm

OTHER_LENGTH = """
¤ is/denotes/est/ist (the) half/moitié/halbe
¤ (and/et/und/y/e) ¤ (be/are/denote/sont/désignent/sind/bezeichnen/son/sono) (each) (the/la/les/die) half/halves/moitié/moitiés/twice/double/doubles
¤ … half-length/half-lengths
¤ is/denotes the distance * (to) the middle/centre/center
¤ est la moitié
twice/double (as) (long) (as) ¤
double de ¤
¤ is/denotes/means/est/désigne (the/la/le) total/overall/whole/totale length/reach/longueur
¤ is/denotes/means/est/désigne (the/la/le) diameter/radius/width/diamètre/rayon/largeur
¤ is/denotes (being) (counted) measured from (the) shoulder/base
"""
OTHER_COLUMNS = """
columns belong to ¤ and ¤
first column belongs to ¤
"""
PASSIVE = """
passive/pasiva/passiva/passiven/passives/passivas rotation/rotations/transformation/transformations/matrix/drehung/drehungen/drehmatrix/rotation/rotations
rotation/rotations/rotación/rotaciones/rotazione/rotazioni/rotação/rotações passive/passives/pasiva/pasivas/passiva/passivas
counted/measured/reckoned/taken/positive % clockwise
clockwise % positive/counted
compté~/mesuré~/positi~/orienté~ % sens horaire
compté~/mesuré~/positi~ % sens des aiguilles
gemessen/gezählt/positiv % im uhrzeigersinn
im uhrzeigersinn % gemessen/gezählt/positiv
sentido horario % positiv~
positiv~/medid~ % sentido horario
old/former % to % new axes/basis/base/frame/coordinates/ones
ancienne/anciens/anciennes/ancien % nouvelle/nouveaux/nouveau/nouvelles base/repère/axes/coordonnées
alten % neuen basis/achsen/koordinaten/system
"""
OF_TWO_BASES = """
coordinates/components ¤ in/with ¤ and ¤ in/with ¤
coordonnées/composantes ¤ dans ¤ et ¤ dans ¤
koordinaten ¤ in ¤ und ¤ in ¤
"""
TURNS_AXES = """
turns/rotates/turning/rotating (only) the (coordinate) axes/frame (,) (and) not/rather
axes are/being turned/rotated (,) (and) not
tourne/tournent (seulement) les axes (,) (et) non
dreht die achsen (,) (und) nicht
"""
ROW_VECTORS = """
points/vectors/positions/coordinates are/as/is (written/taken/treated) (as) (row) rows/row-vectors
points/vectors/positions/coordinates are/as (written/taken/treated) (as) row vectors
we (use/work) (with) row vectors/row-vectors
points/vecteurs/positions sont (des/écrits/écrites/notés) (comme) (en) (vecteurs) lignes/ligne
punkte/vektoren/ortsvektoren sind/als zeilen/zeilenvektoren
puntos/vectores son/como (vectores) (fila) filas/fila
punti/vettori sono/come (vettori) riga/righe
pontos/vetores são/como (vetores) linha/linhas
"""
SEEN_FROM = """
frame/repère/system/koordinatensystem/sistema/referencial/marco ¤ … seen/viewed/described/expressed/given/relative/respect/vu/exprimé/rapport/gesehen/bezüglich/ausgedrückt/visto/respecto/rispetto/relação … (frame/repère/system/koordinatensystem/sistema/referencial/marco) ¤
coordinates/coordonnées/koordinaten/coordenadas/coordinate … ¤ … into/to/en/in/a … ¤
"""
ASKS_WHICH = """
true or false
right/correct or wrong/false
vrai~ (v) ou faux/fausse/fausses
juste~ (j) ou faux/fausse/fausses
richtig/wahr (oder) (r) oder falsch
verdadero~/verdadera~ (v) o falso~/falsa~
vero/vera (v) o falso/falsa
verdadeiro~/verdadeira~ (v) ou falso~/falsa~
which (one/ones) of (the/these) (two/three/four/five/following) (following/equations/formulas/expressions/statements/answers)
laquelle/lequel/lesquelles/lesquels des (…) suivantes/suivants/propositions/formules/réponses
welche/welcher/welches der folgenden/beiden/drei/vier
cuál/cuáles de las/los (…) siguientes
quale/quali delle/dei/tra (le/i) (…) seguenti
"""
EQUAL_LENGTHS = """
equal/identical/equally (long) link/links/bar/bars/length/lengths/segment/segments/arms
links/bars/segments/arms of (equal/the) (same) length
bras/segments/corps/maillons/liens/longueurs égaux/égales/identiques (longueurs)
gleich/gleiche lange/glieder/stäbe/längen/segmente (glieder/stäbe)
eslabones/brazos/longitudes/barras iguales
bracci/membri/lunghezze/aste uguali
"""
OF_COLUMNS = """
columns/colonnes/spalten/columnas/colonne/colunas (of/de/von/di) (¤) (are/be/called/named/denoted/by/as/sont/sind/seien/son/sono) ¤
¤ (,/and/et/und/y/e) ¤ (are/be/for/sont/sind/seien/son/sono) (the/its/les/ses/die/seine/las/sus/le) (two/deux/zwei/dos/due) columns/colonnes/spalten/columnas/colonne/colunas
"""
IN_ORDER = """
in/with/dans/en/mit/con (l'/the/this/that/der/dieser/cet/este/ese/questo/el) order/ordre/reihenfolge/orden/ordine
"""
OF_ROWS = """
rows/lignes/zeilen/filas/righe/linhas
in/dans/en (l'/the/this/that/der/dieser/cet/este/ese/questo) order/ordre/reihenfolge/orden/ordine
"""
COLUMNS_REVERSED = """
columns/columna~/colonnes/colonne/spalten … reverse/reversed/inverse/inversé/exchanged/swapped/interchanged/permuted/vertauscht/umgekehrt~/échangées/permutées/intercambiadas/invertidas/invertite/scambiate
columns/columna~/colonnes/spalten * (the) (an) other/another/autre/otro/altro/anderer order/ordre/orden/ordine/reihenfolge
joint/articulation/gelenk 2/3 first/zuerst/abord
second joint/articulation/gelenk first
first/première/erste/primera/prima column/colonne/spalte/columna/colonna … (second) joint/articulation/gelenk/giunto (2)
"""
SWAPPED = """
¤ … (the) (length/angle) (of/de) (the/du) second/elbow * (and/et) ¤ * first/premier/shoulder
¤ … (the) (length) (of) (the) first link , ¤ * second
¤ turns the first link and ¤ the second
"""
JOINING = "but and now then so thus hence mais et or donc aber und pero y".split()

# -- what holds without exception: a rank is then no generic one

EVERYWHERE = """
in/for/at/over every/all/any/each (the) (possible/admissible/single) (joint) posture~/configuration~/position~/pose~/angle~/point~/state~/value~
in/for/at every/all/any/each ¤
everywhere/always/invariably
without/sans/ohne/sin/senza/sem (any/aucune/jede/ninguna/alcuna) exception/exceptions/ausnahme/excepción/eccezione/exceção
whatever/regardless/irrespective/independent/independently (of) (the) (value~) (of) (the) (joint) posture~/configuration~/position~/pose~/angle~/¤
whatever ¤
never/nowhere … singular~/loses/degenerate~/vanishes
no singular (postures/configurations/positions)
has/have no singularit~
not singular anywhere
quel/quelle/quels/quelles que soit/soient
dans/en/pour/à toute/toutes/tout/tous/chaque (les/la/le) (possibles) configuration~/position~/posture~/pose~/angle~/valeur~/¤
partout/toujours
jamais … singuli~/dégénér~
ne perd/devient/s'annule jamais
in/für/bei allen/alle/aller/jeder/jede/jedem/jeden/sämtlichen (beliebigen/möglichen) stellung~/lage~/konfiguration~/position~/pose~/haltung~/winkel~/gelenkwinkel~/gelenkstellung~/¤
überall/stets/immer/ausnahmslos
nie/niemals/nirgends … singulär~
keine singulär~/singularität~
en/para todo/todos/toda/todas/cada/cualquier/cualquiera (los/las/la/el) (posibles) configuración/configuraciones/posición/posiciones/postura~/pose~/ángulo~/valor~/¤
siempre/nunca … singular~
siempre
sea/sean cual/cuales/cuáles sea/sean
in/per tutte/tutti/ogni/qualsiasi/qualunque/ciascuna (le/i/gli) (possibili) configurazion~/posizion~/postura/posture/angol~/valor~/¤
ovunque/sempre/dappertutto
em/para todas/todos/toda/todo/cada/qualquer/quaisquer (as/os/a/o) (possíveis) configuraç~/configuração/posiç~/posição/postura~/ângulo~/valor~/¤
"""
BUT_SOMEWHERE = """
almost/nearly/generically/generic/except/excepting/excluding/other/outside/away/but/unless/save/apart/non-singular/nonsingular/regular/sauf/hors/excepté/presque/régulièr~/außer/ausgenommen/ausser/fast/regulär~/nicht-singulär~/nichtsingulär~/salvo/excepto/menos/casi/fuera/regular~/tranne/eccetto/quasi/fuori/regolar~/exceto/fora/quase
hors de/des
"""
