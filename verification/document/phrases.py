"""The phrases by which sentences change what a display says, each table by what they do there; `sentences.py` reads them.

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
the case
what we want/need/mean
vrai/vraie/exact/exacte/correcte/juste/richtig/wahr/cierto/cierta/verdad/correcto/correcta/vero/vera/valable
"""
WRONG = """
wrong/wrongly/false/falsely/incorrect/incorrectly/untrue/erroneous/erroneously/mistaken/mistakenly/invalid/impossible/absurd/nonsense/mistake/mistakes/fallacy/fallacies/misconception~/misprint~/withdrawn
reject
common/frequent/typical/classic/classical/usual/sign/grave/bad/popular error~/slip~
error to
faux/fausse/fausses/faussement/erroné/erronée/erronés/incorrecte/inexact/inexacte/absurde
à tort
par erreur
erreur/erreurs fréquente~/courante~/classique~/répandue~
erreur de signe/calcul/frappe
erreur d'/de écrire/poser/croire/dire/prendre
falsch/falsche/falscher/falsches/fälschlich/fälschlicherweise/irrtümlich/unrichtig/falso/falsa/falsos/incorrecto/incorrecta/erróneo/errónea/sbagliato/sbagliata
häufiger/häufige/typischer/typische fehler
error/errores frecuente/frecuentes/común/comunes/típico/habitual
✗/✘/❌
blunder~/typo/typos/slip/untenable/meaningless/senseless/contradict~/errs/erred/nonsensical/bogus/flawed/faulty/inaccurate
makes no sense
index/sign/term/factor (is) missing
piège (classique) (est)
irrtum/denkfehler/trugschluss/unsinn/unzutreffend/widerspricht/contredit/contresens/bévue/aberrant/aberrante/equivocado/equivocada/disparate/contradice/errado/errada/errados/erradas/falsas
"""
DENIAL = """
not/never/nobody/cannot/~n'/no-one/neither (t) (…) have/get/obtain/find/equal/use/write/say/conclude/believe/think/mean/follow/possible (that) $
pas/jamais (…) écrire/avoir/conclure/croire/poser/dire (que) $
n' écrivez/écris pas/jamais $
nicht schreiben/setzen/sagen $
no hay/debe/se que/debe escribir/poner $
aurait/auriez/avez tort de/d'
further from the truth
n' a/ont/avons/aura pas/jamais $
no/nicht reason/grund why/for/warum $
tempted/tenté to/d'/de write/think/say/conclude/écrire
confuse/confused/confuses/confusing/confondre/confondu … with/avec/by
gardez-vous/garde-toi de
s' ensuit pas/nullement
(and) (but) not/non/nicht $
(was) stimmt nicht
nicht stimmt
not/never/nobody/nothing/neither/no/cannot/~n'/rien/pas/jamais/aucun/aucune/nicht/kein/keine/nie/nunca/jamás/non * that/que/qu'/dass/che/is/est/ist $
"""
HARMLESS = """
pas sorcier
étonn~/surprendra/doutera pas (de)
without/sans/sin/senza/sem/ohne (any/a/further/aucune) (the) loss/perte/pérdida/perdita/perda/doubt/duda/doute/dubbio/dúvida/ado/zweifel
unless/sauf otherwise/mention/indication (stated/noted/specified/mentioned) (contraire)
does/do/did/is not/n' depend/matter/involve/change/affect/enter/appear/contain
ne dépend/change/contient/intervient pas
no need
what we wanted/expected/sought
wrong/incorrect to think/believe that % matters/depends/matter/depend
often/sometimes printed/written with a/the wrong sign
not/nicht/pas/non/no only/just/merely/seulement/uniquement/nur/solo
not/nicht/pas/no (so/too/very/si/très/sehr) difficult/hard/easy/surprising/difficile/facile/schwer/schwierig/difícil
nothing/rien (is) wrong/false/incorrect
no/not/without/sans/aucune/keine/sin (any/a/an/une) approximation/trivial/surprise/approximate
not surprisingly
not/no/never/cannot (…) wrong/wrongly/false/incorrect/mistake/mistaken/impossible/absurd
pas/nicht/kein/no (…) faux/fausse/falsch/falscher/falso/incorrecto/inexact
avoid~/prevent~/remedy/without/éviter/évite~/sans/vermeide~/evitar (…) mistake~/error~/misconception~/erreur~/wrong/fehler
false/wrong position/ground/side/way/hand
right inverse/angle/angles/side/hand/triangle
error metric/norm/signal/measure/model/bound/function
not/no/nobody/cannot/never/~n'/pas/nul/nulle/nicht/kein/keine/ohne/sans (…) doubt~/deny/denied/denies/dispute~/doute/difficult/difficulty/hard/surprise~/surprising/wonder~/secret/coincidence/accident/pity/forget/forgotten/overlook/hide/ignore/escape~/prevent~/exaggeration/étonn~/surpren~/oublier/hasard/mal/peine/difficile/zweifel~/schwer/schwierig/vergessen/wunder~/mühe/repeat/mention/forgotten/obvious/trivial/clear/evident/évident/new/object
not/without/~n'/pas/nicht/ohne/sans (…) prove/proof/derive/démontrer
not without reason
never/nunca/jamais forget/oublier/olvidar
nothing/rien (…) neglected/négligé
no/sin es/hay/cabe duda/difícil/extraño
cannot but
"""
REMEDY = """
right/correct/corrected/correctly/instead/rather/but/remember/mais/plutôt/corrigé/corrigée/sondern/sino/richtig
should be
"""
LIGHT = """
a/above/again/alas/hélas/easy/easily/given/clear/first/second/third/such/make/makes/reader/attentive/says/say/book/textbook/author/spotted/rien/tout/leider/all/also/an/and/are/as/be/been/beginners/beware/but/can/certainly/classic/common/frequent/typical/usual/clearly/contains/could/course/definitely/do/does/did/find/for/has/have/he/here/however/i/in/is/it/its/just/last/line/many/may/might/must/never/no/note/now/
obviously/of/often/one/only/or/people/plainly/previous/printed/quite/really/see/seen/shall/should/simply/some/still/students/sure/surely/that/the/there/these/this/to/unfortunately/was/we/were/what/where/which/why/will/with/would/write/wrote/you/
claim/conclusion/display/entry/equality/equation/exponent/expression/factor/formula/formulae/formulas/identity/index/matrix/relation/result/sign/statement/term/
attention/aussi/bien/c'/ce/ceci/cela/cette/ci-dessus/clairement/dans/de/dernière/donc/elle/en/est/et/il/indice/l'/la/le/les/ligne/malheureusement/mais/n'/ne/on/ou/où/pourquoi/que/qui/résultat/signe/sont/terme/un/une/verra/voit/y/à/
fréquente/courante/affirmation/égalité/équation/expression/formule/identité/aber/das/der/die/dies/diese/ein/eine/es/formel/gleichung/hier/ist/jedoch/leider/sind/und/vorzeichen/
esta/este/esto/eso/ecuación/fórmula/lo/cual/pero/está/son/signo/el/questo/ciò/è
"""
ELSEWHERE = """
if/when/whenever/where/for/at/unless/that/to/si/quand/pour/que/lorsque/lorsqu'/de/où/wenn/falls/für/dass/para/cuando
"""
ABOVE = """
formula/formulas/equation/equations/expression/relation/result/line/one above
above/previous/preceding/last formula/formulas/equation/equations/expression/relation/result/line
formule/équation/relation/expression/égalité/ligne/résultat ci-dessus/précédente/précédent
obige/vorige/letzte gleichung/formel/beziehung/ausdruck
fórmula/ecuación/relación/expresión anterior
"""
DENIED_BEHIND = """
^ * ne/n' vaut/vaudra/tient (pas/rien/plus)
^ * ne/n' est pas/plus (…) valable/vraie/vrai/exacte/exact/correcte/correct/juste/bonne/bon
^ * ne/n' est (…) (valable/vraie/vrai/exacte/exact/correcte) que
^ * n' est pas/plus (du) (tout) (le) cas
^ * cannot/nobody/never … prove/proved/proven/derive/derived (this/it/that) . $
^ * no one can/has (ever) prove/proved/proven/derive/derived (this/it/that) . $
^ * wrong/false/incorrect/faux/fausse/falsch/falso/falsa/incorrecto/incorrecta/sbagliato/sbagliata/errato/errata/errado/errada (here/ici/hier/aquí/qui/aqui) . $
^ * formula/equation/relation/result/expression/claim/statement/line/identity/value/it/this/that (…) (does/do/is/can) not/n'/never/longer/cannot (longer) (t) (be) hold/apply/valid/usable/true/agree/match/fit/correspond/work/follow/stand/suffice/used/kept/trusted/right/correct/give/yield/describe/represent/express/reproduce/equal
^ * il/résultat/formule/relation/équation/expression/valeur/cela/ceci/ça ne/n' … correspond/convient/marche/suffit/concorde/donne/décrit/représente/exprime/fournit pas/plus
^ * ergebnis/formel/gleichung/beziehung/ausdruck/das/dies … stimmt/passt/gilt … nicht
^ * resultado/fórmula/ecuación/relación/expresión/esto/eso no (…) corresponde/coincide/concuerda/vale/sirve/cumple
we/i/author/authors no longer claim/claims/support/supports/maintain/maintains/defend/defends
we/i/author/authors/nous withdraw/withdraws/retract/retracts/reject/rejects/retirons/abandonnons/rejetons
refuted/disproved/disproven/démenti~/réfuté~/contredit~/infirmé~/widerlegt/desmentid~/refutad~ by/par/durch/por
there is/are/was/must (be) a/an/some/two/another (…) mistake~/error~/slip~ (in/here)
il y a/avait (…) (une/deux/des) (…) erreur~/faute~
es gibt/da ist (…) (ein/einen) (…) fehler
hay (…) un/unos/algún (…) error/errores
^ * faut/fallait/faudrait lire
^ * read/lire/lisez/lies/lesen/léase/leer … instead/au/statt/anstatt/en of/lieu/lugar
^ * erreur/error/mistake/fehler/faute * ? $
^ * gleichung/formel/beziehung (ist/gilt) … nicht/nur
^ * drawing board
^ no/non/nein/nope :/;/!/—
^ (well) (,) (not/pas/nicht/gar) at/du/tout/überhaupt (à) all/tout/fait/nicht . $
^ far from it
^ loin de là
^ if only . $
^ would (that) (it/this) (were) (so) . $
^ here * should/must/ought be
^ * too few/little . $
^ ne/n' * utilisez/utilisons/utiliser/copiez/écrivez/retenez pas
^ (the/quite) opposite/contrary/reverse/converse (is) (the) case/true/so/holds/right
^ le contraire est
^ das gegenteil ist
^ * (once/one) too often/many/much
^ * counted/taken/entered/added/has/have/had/compté/a/ont/hat/gezählt (with/avec/mit) (the/a/an/le/un/dem/einem/el) wrong/false/incorrect/opposite/mauvais/faux/falschem/falschen/equivocado
^ * sign/signe/term/terme/factor/facteur/index/indice/exponent/exposant/vorzeichen/signo/término (…) must/should/ought/doit/devrait/muss/müsste/sollte/debe/debería (to) (be/have/être/avoir/sein/ser) (…) preceded/minus/plus/opposite/other/another/negative/reversed/précédé/moins/opposé/autre/négatif/minus/umgekehrt/opuesto/menos
^ (…) statt/anstatt/anstelle/instead/lieu/lugar * must/should/doit/devrait/muss/müsste/sollte/gehört/debe
^ * counted/added/taken/entered twice
^ * went/gone/goes missing
^ * must/should/ought/needs/need/has/have (to) (still) (be) (have) (been) exchanged/changed/replaced/swapped/interchanged/switched/reversed/negated/removed/deleted/corrected/subtracted/flipped
^ * should/ought (to) (still) (be) (have) (been) multiplied/divided/added/squared/inverted/transposed/omitted/dropped/moved
^ * was/were/been/got … swapped/interchanged/exchanged/forgotten/overlooked/omitted/mistyped/miscopied
^ * sign/signs/index/indices/factor/factors/term/terms/angle/angles/letter/letters/length/lengths/row/rows/column/columns/sine/cosine/square swapped/interchanged/exchanged/forgotten/overlooked/omitted/mistyped/miscopied
^ (please) (now) change/correct/reverse/swap/exchange/interchange/flip/replace/drop/delete/remove/negate/remplacez/remplacer/changez/inversez/corrigez/supprimez/ersetze/ersetzen/streiche/streichen/sustituya/sustituir/cambie/corrija * . $
^ check/verify/recheck/re-check this/it again
to-do/todo/fixme/xxx
^ * is/are/needs/need/has/have/remains/remain (still) (to) (be) (yet) checked/verified/confirmed/proved/proven/rechecked/double-checked (again) . $
^ * reste/est/sont (encore) à vérifier/prouver/confirmer/contrôler/démontrer . $
^ * (noch) zu prüfen/überprüfen/kontrollieren/beweisen . $
^ * queda/está/falta por/sin verificar/comprobar/demostrar/confirmar . $
not/n't/pas/nicht/no (…) sure/certain/convinced/sûr/sûre/sûrs/certains/convaincu/sicher/überzeugt/seguro/seguros/convencido
i/we/nobody (do) (does) not/n't/knows (know) (t) whether/if
unsure/uncertain/doubtful/douteux/douteuse/fraglich/zweifelhaft/dudoso/dudosa
^ * (have/has) (been/was/were) left out/off/aside
^ * not/n't/cannot/never/pas/nicht/no (…) reach/do/obey/satisfy/use/reproduce/explain/confirm/follow/allow/support/supports/believe this/it/that/cela/ça/das/esto/eso . $
^ this/it/that cannot be ,/right/true/correct/so/the/valid/used
^ cela/ceci/ce/das/esto ne/n'/no (…) peut/kann/puede (pas/nicht) (être) ,/vrai/exact/juste/correct/richtig/stimmen/cierto
^ (please) replace the/a sine/cosine/sign/index/term/factor/exponent
^ * doit/doivent/devrait/devraient être remplacé~/changé~/corrigé~/inversé~/interverti~/permuté~/supprimé~/retiré~/soustrait~/échangé~
^ * est/sont à (nouveau) (être) corriger/remplacer/changer/inverser/revoir/reprendre/intervertir/supprimer
^ * a/ont été interverti~/inversé~/permuté~/oublié~/échangé~/omis/omise
^ * il faut/fallait/faudrait/convient/reste (de) (donc) (à) remplacer/changer/corriger/inverser/intervertir/soustraire/permuter/échanger/supprimer/retirer
^ * muss/müssen/sollte/sollten/soll/gehört/gehören … umgekehrt/vertauscht/ersetzt/geändert/korrigiert/gestrichen/weggelassen
^ * wurde/wurden/ist/sind … vertauscht/vergessen/verwechselt
^ * hay/habría/debe/deben/debería/deberían/tiene/tienen (que) (ser) cambiar/cambiarse/sustituir/sustituirse/corregir/corregirse/invertir/invertirse/quitar/intercambiar/intercambiarse/reemplazar/reemplazarse/cambiado/cambiada/sustituido/sustituida/corregido/corregida
^ * va/vanno/andrebbe/deve/devono/dovrebbe/bisogna/occorre (essere) corrett~/cambiat~/sostituit~/scambiat~/invertit~/correggere/cambiare/sostituire/scambiare/invertire
^ * deve/devem/deveria/deveriam/precisa/precisam/tem/têm/preciso/necessário (ser) (de/que) trocad~/substituíd~/corrigid~/invertid~/trocar/substituir/corrigir/mudar/inverter
^ * correct/right/true/proper/corrected version/formula/expression/result/value/equation/relation (is/reads/has/would/can/should/follows/stands)
^ * bonne/bon formule/version/expression/résultat/relation (est)
^ * formule/version/expression/résultat/relation correcte/exacte/exact/juste/corrigée est/se/a/figure
^ * richtig/korrekt ist/wäre/lautet/muss/heißt
^ * richtige/korrekte formel/gleichung/ausdruck/ergebnis
^ * fórmula/resultado/expresión/ecuación/relación correcto/correcta es/está/sería/se
^ * formula/risultato/espressione/relazione corretta/corretto/giusta è/sarebbe/si
^ * fórmula/resultado/expressão/equação/relação correta/correto é/está/seria
^ * sides/units/members/dimensions (of) (the) (two) (both) (sides) (do/does/don'/are) not/t/disagree/differ
^ * membres/unités/dimensions ne * pas
^ * seiten/einheiten … nicht
^ * lados/miembros/unidades/membri/membros/unità no/non/não
^ * belong/belongs/refer/refers (only) to another/other/a/the (different/other)
^ * appartient/appartiennent (à/aux) (un/une/d') autre/autres
^ … should/must/has/have/ought/doit/muss/debe (to) be corrected/replaced/withdrawn/remplacée
^ … should/must/doit (have/read/avoir) (an) (another) (a) (une) differently/sign/autre
^ … should/must read/say/have
^ … needs/requires a/some correction
^ … est à corriger
^ (what) (is) (what' s) wrong
^ correct/find/spot/mend/corrigez/corrige the/l'/el error/mistake/erreur
^ where/où is/est the/l' mistake/error/erreur
^ (and) (but) (this) (it) (that) (which) (is) (holds) (hold) (are) (true) (right) (correct) (valid) (exact) only/solely if/when/for/at/in/where/near/on
^ (and) (but) except/unless/nowhere/sauf/excepté/außer/excepto/salvo
^ (and) (this) (it) (that) (holds) (is) (true) if and only if
^ (mais) (ce) (qui) (cela) (ceci) (elle) (cette) (formule) (égalité) n'/ne est/vaut/tient (vraie) (vrai) (exacte) (valable) que
^ (mais) (et) (aber) (und) (gilt) (pero) seulement/uniquement/nur/solo/sólo für/wenn/falls/si/pour/en/quand/lorsque/para/cuando/bei
^ (which) (this) (it) (that) (is) (holds) (true) (right) for/at/if/when ¤ alone/only
^ (please) do not/never believe/use/write/trust/copy this/it/that
^ (please) don' t believe/use/write/trust/copy this/it/that
^ (please) delete/ignore/strike/forget/discard/disregard this/it/that/the
^ (and) (this) (that) (which) (is) (so) (holds) (but) for ¤ only/alone
^ (but) for no other
^ which/this/that/ce (qui) requires/assumes/presupposes/suppose/erfordert ¤
"""
DENIED_BEFORE = """
^ falsch/unrichtig/verkehrt wäre/ist es * $
^ (a/an/the/one/another) (very) common/frequent/classic/usual/typical/widespread misconception~/mistake~/error~/belief * $
* if/when/where * (is/are/was/were) (simply) forgotten/confused/overlooked/mixed/mistaken/miscounted/neglected/ignored (up/for) (:) $
* must/should/ought/needs/need/has/have (to) (still) be deleted/removed/struck/corrected/withdrawn/replaced/discarded/ignored (:) $
* doit/doivent/faut (être) supprimé~/corrigé~/retiré~/remplacé~/ignoré~/supprimer/corriger/retirer (:) $
* il (ne) faut (surtout/donc) pas/jamais écrire/utiliser/prendre/appliquer/employer/retenir/poser (la/cette/le) (relation/formule/expression) (:) $
no/zero/without/sans/aucun/keine/sin (obtenir/any) (de/receiving/getting) marks/points/credit/points/punkte/puntos
students/student/pupils/pupil/groups/group/candidates/étudiants/étudiant/élèves/élève/groupe/candidats/schüler/studenten/studierende/alumnos/estudiantes * wrote/answered/handed/claimed/submitted/concluded/répondu/écrit/conclu/rendu/schrieben/antworteten/abgegeben/escribieron/respondieron
* si/quand/lorsque * (est/sont) oublié~/confondu~/omis/omise/négligé~ $
* wenn * vergessen/verwechselt/vertauscht/übersehen (wird/werden/wurde/hat) $
* si/cuando * (se) olvida/olvidan/confunde/confunden * $
^ * old/older/previous/earlier/former/first/original/printed/preceding/last/outdated … version/edition/draft/printing/copy/attempt/guess/try/printout/handout * had/has/was/gave/gives/computed/used/read/reads/wrote/contained/contains/showed/states/stated (:) $
^ * ancienne/première/précédente … version/édition/ébauche/tentative/copie * avait/portait/donnait/donne/contenait/était/indiquait (:) $
^ * alte/alten/frühere/früheren/erste/ersten … fassung/ausgabe/version/auflage * stand/hatte/enthielt/lautete (:) $
^ * common/frequent/usual/typical/tempting/naive/hasty/careless/intuitive (but) (…) answer/answers/guess/attempt/try/shortcut/temptation/response
^ * réponse fréquente/courante/classique/habituelle/tentante/naïve
^ * häufige/typische/naheliegende antwort
^ * respuesta frecuente/común/habitual/típica
^ (…) (exercise/task/problem/exercice/aufgabe/ejercicio) (:) correct/mend/fix/repair/improve/corrigez/corriger/rectifiez/korrigiere/korrigieren/berichtigen/corrija/corregir/corrige (sie) the/this/la/l'/le/die/el (…) equation/formula/expression/line/matrix/relation/result/équation/formule/expression/ligne/relation/gleichung/formel/ecuación/fórmula
what/where/quelle/où/was/wo/cuál/dónde (…) (is/est/ist/es) (…) the/l'/la/der/el error/mistake/slip/fault/erreur/faute/fehler
^ * must/should/ought/needs/need/has/have (to) (still) be exchanged/changed/replaced/swapped/interchanged/reversed/negated/removed/deleted/corrected/flipped in (the/following/below/:) (following) (line/equation/formula/expression) (:) $
^ * doit/doivent/faut (être) (…) remplacé~/changé~/corrigé~/inversé~/interverti~/permuté~/changer/corriger/inverser/remplacer dans (la/l'/cette) (formule/équation/expression/relation/ligne) (suivante) (:) $
^ * following/next (line/equation/formula/expression/relation/result) (does/do/is/can) not/n't/cannot/never
^ * ligne/formule/équation/relation suivante/ci-dessous ne/n' … pas/plus
^ * folgende/siguiente ligne/gleichung/formel/fórmula/ecuación … nicht/no
contain/contains/enthält/enthalten/contient/contiennent/contiene/contienen (a/an/one/two/some/einen/ein/une/un/deux/des/algún) (…) error/errors/mistake/mistakes/slip/slips/fehler/erreur/erreurs/faute/errores
^ (…) find/spot/locate/trouver/trouvez/cherchez/finde/finden/suchen/encuentre/busque (sie) the/l'/la/den/der/el/den error/mistake/slip/erreur/faute/fehler
por/durch/par error/descuido/irrtum/versehen/erreur/mégarde/inadvertance
démenti~/démentent/refuted/disproved/widerlegt/desmentid~
^ cross/strike out/through
^ barrez/rayez/biffez
nothing/rien/nichts/nada … allows/permet/justifies/justifie/erlaubt/rechtfertigt/permite/justifica * $
^ (…) nor/ni/noch/neither (…) is/are/does/do/est/ist/es
(this/that/it) (…) is not (…) the case
instead/au/anstelle/statt/en of/lieu/des/der/lugar (de/du/del) (the/l'/la/le) correct/right/true/correcte/exacte/bonne/correcta/richtigen
^ * not/n't/cannot/never/pas/nicht/no (…) obey/satisfy/agree/match/fit/follow/yield/give/respect/fulfil/fulfill/comply/have/reproduce/equal (with) (the/this) (law/relation/formula/equation/rule) (:) $
^ * ne/n' obéit/vérifie/satisfait/respecte/suit/donne pas (à/la) (loi/relation/formule) (:) $
* if/when/who/by (you/one/we/they) forget/forgets/forgetting/confuse/confuses/confusing/mix/mixes/mixing * $
* en oubliant/confondant * $
* si/quand/lorsqu' on/l' (on) oublie/confond * $
^ (please) (do) not/never (t) use/trust/copy/apply the/this * $
^ it/this/that (do/does/is) not/n' (t) describe/hold/give/represent/agree/match/apply * $
^ (it) (is) only/solely if/when/for/at/in/where ¤
^ (it) (is) only/solely at/in/near
^ (c') (est) seulement/uniquement/nur/solo/sólo pour/si/quand/für/bei/para/en
^ except/excepté/sauf/außer/excepto for/at/if/when/pour/si/bei/für/para
one/we/you may/need not write
^ (but) (please) avoid/éviter/évitez/évitons (:) (writing) $
^ (but) (surely/surtout) not/pas/nicht/non/no (like/comme/wie/come/como) this/ceci/cela/ainsi/so/dies/questo/esto (:) $
by no means (,) $
^ & (in/auf/en/de/in/em/under) no/keinen/keiner/aucun/aucune/ninguna/ningún/nessun/nessuna/nenhuma way/circumstances/fall/weise/cas/façon/manière/manera/modo/caso (,) $
opposite/contrary/converse/negation/contraire/réciproque/gegenteil/contrario of/de/von (this) (is) (:) $
"""
NOT_AT_ITS_END = """
not/never/cannot/~n't/pas/jamais/nicht/kein/keine/nunca (…) $
no ¤ $
"""
POINTS_BELOW = """
following/below/underneath/suivante/suivant/ci-dessous/ci-après/folgende/folgenden/nachstehende/nachstehenden/siguiente
"""
THEN = """
^ then/alors/dann/entonces/allora/então/so/thus/hence/therefore/donc/also/ainsi/daher/así/luego/dunque/portanto (,) … (:) $
^ (in) (dans) (en) this/that/such/ce/in/im/ese/tal (a) (diesem) case/cas/fall/caso (,) … (:) $
^ this/it/cela/das/esto (then) gives/yields/leads/donne/ergibt/liefert/da/resulta … (:) $
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
contribution/contributions/apport/apports
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
SPECIAL = """
nowhere else
nulle part ailleurs
sonst nirgends
^ only/seulement/uniquement/nur/solo/sólo/soltanto/apenas/somente when/if/quand/si/wenn/cuando/quando/se
same/equal/identical (link) length/lengths/links
equally long
lengths/links are/were/being (here) equal/identical/the (same)
(segments/longueurs) de (la) même longueur
longueurs/segments égales/égaux
gleich lang/lange/langen
gleiche/gleicher/gleichen länge/längen
misma longitud
miden lo mismo
eslabones/longitudes iguales
stessa lunghezza
bracci/aste/lunghezze uguali
mesmo comprimento
elos/comprimentos iguais
special/particular/limiting/degenerate case
cas particulier/limite
spezialfall/sonderfall/grenzfall
caso particular/particolare/limite/límite/especial
set/put/taken/chosen/fixed (equal) (to/as/at) zero/one/unity
this/that/these … only/alone ,
gestreckt~/ausgestreckt~/eingeklappt~
extendido/extendida/estirado/estirada/plegado/plegada
disteso/distesa/esteso/estesa/ripiegato/ripiegata
esticado/esticada/estendido/estendida/dobrado/dobrada
"""
MAY_LIMIT = """
angle/angles/winkel/ángulo/ángulos/angolo/angoli/ângulo/ângulos/motor/motors/moteur/moteurs/motoren * (is/are/est/sont/ist/sind/es/son) absolute/absolu~/absolut~/assolut~
measured/counted/taken/reckoned/referred/given/mesuré~/compté~/pris/prise/repéré~/gemessen/gezählt/medido~/medida~/contado~/tomado~/misurat~/contat~/contada~ (with) (respect) from/to/against/with/depuis/à/par/desde/respecto/rapport/gegen/gegenüber/von/zur/zum/dall' (…) horizontal~/vertical~/orizzontal~/vertikal~/ground/floor/sol/suelo/boden/lotrecht~/waagrecht~/waagerecht~/senkrecht~
horizontal/vertical/ground/floor (line/axis) as/for (the) (a) reference/zero/origin
prenant/prend/tomando (l'/la/como) horizontal~/vertical~ (comme/como) (référence/origine/referencia)
nullstellung/nulllage/grundstellung/ruhelage/ausgangsstellung/referenzstellung/strecklage
posición/configuración/postura inicial/cero
posición/configuración/postura de reposo/referencia/casa
brazo/eslabones/codo (…) extendid~/estirad~/plegad~/alinead~
(all) lengths/longueurs/längen/longitudes/lunghezze (are/is/being/sont/werden/son/sono) doubled/halved/tripled/doublées/divisées/verdoppelt/halbiert/duplicadas/raddoppiate
in/to/into/from/of/dans/vers/du/im/in/en/desde/al the/le/l'/la/el/zum/dem/den/der (¤) second/third/moving/moved/rotating/tool/body/hand/gripper/wrist/elbow/forearm/local/new/own/last/other/deuxième/second/mobile/local/nouveau/outil/zweiten/mitbewegten/bewegten/móvil/segundo/herramienta frame/axes/coordinates/system/koordinatensystem/system/repère/sistema
repère/sistema/referencial/referencia (qui) mobile/lié/attaché/móvil/ligado/del (segundo/última)
frame/coordinates/system of/attached (to) (the) first/second/third/last/moving/tool/hand/gripper/elbow/forearm/wrist/end-effector (link)
frame/axes/coordinates/system that/which turns/turn/moves/move/rotates/rotate (with)
seen/looked/viewed/observed/vu/vue/vista/visto/gesehen (at) from/by/depuis/desde/par/von
(first/second/third/other/last/¤) joint~/link/motor/axis/shoulder/elbow/forearm/¤ (¤) (#) (is/are/was/being/be/held/kept/remains/stays/stay/stands) (kept/held) fixed/locked/blocked/clamped/frozen/still/constant/immobile/welded/brake~/switched
(first/second/third/other/last/¤) joint~/link/motor/axis/shoulder/elbow/forearm/¤ (does/do) not (move/turn/rotate)
locked/blocked/clamped/frozen/welded/fixed/stationary joint/link/axis/motor/shoulder/elbow/forearm/at
première/première/deuxième/seconde/dernière/premier/second articulation/liaison/axe/segment/moteur (est/étant/reste) bloqué~/fixe~/fixé~/immobile/figé~/verrouillé~/arrêté~
articulation/liaison/axe/coude/épaule/segment/moteur (#) (est/étant/reste) bloqué~/fixe/fixé~/immobile/figé~/verrouillé~/arrêté~
gelenk/achse/glied/motor/ellbogen/schulter (#) … festgehalten/blockiert/fest/gesperrt/verriegelt/stillsteht/arretiert
festgehaltenem/festem/blockiertem/gesperrtem/arretiertem/stillstehendem gelenk/glied/achse
articulación/eslabón/eje/codo/hombro (…) bloquead~/fij~/inmóvil/quiet~
parallelogram~/belt/belts/pulley/pulleys/pantograph/parallélogramme/courroie~/riemen/parallelogramm~/paralelogramo/correa~
chain drive
held/kept/set/frozen/put/maintenu~/gehalten/mantenid~ (…) at/to/à/auf/bei/en zero/¤/zéro/null/cero
no longer
ne/n' * plus la/le/l'/les/de/d'
acceptable/good/rough/crude/bonne approximation
close/near/proche/voisin~ to/de zero/zéro/¤
hypothèse/hypothesis de/working/of (travail) $
angle/angles/winkel/ángulo/ángulos * to/with/from/against/and/avec/à/par/et/gegen/zur/zum/und/con/desde/de/y (rapport) (the/à/l'/la/le/au/al) ground/horizontal~/vertical~/x-axis/y-axis/sol/boden/suelo
absoluten/absoluter/absolute/absolus/absolu/absoluto/absolutos/assoluti winkel/angle/angles/ángulo/ángulos/orientation
angle/angles/winkel/ángulo/ángulos absolu~/absolut~
von/ab/gegen/zu der/dem/einer horizontal~/vertikal~/waag~/senk~/lot~
se/wird/werden (…) mide/miden/misst/mesure/mesurent (…) desde/von/ab/depuis
mesuré~ dans le repère/référentiel fixe/absolu/global
not/n'/nicht/no (t) (…) denote/mean/stand/represent/désigne/représente/bezeichnet/bedeutet/designa/representa
symbol/letter/abbreviation/notation/shorthand/symbole/lettre/abréviation/zeichen/abkürzung/símbolo/letra ¤ (here/ici/hier/aquí) (is/means/denotes/stands/désigne/signifie/bezeichnet/steht/designa)
¤ is/stands (here) short for
inclination/inclinaison/neigung/inclinación
(in/to) world/global/room/earth-fixed coordinates/frame/axes
coordinate system/systems (…) fixed/attached/tied/of (rigidly) (to) (the) link/first/second/body/forearm
koordinatensystem/bezugssystem/system des/der ersten/zweiten/dritten/gliedes/arms
auxiliary/auxiliaire/intermediate/intermédiaire/internal/temporary/hilfs~/auxiliar/intermedia quantity/variable/grandeur/value/größe/magnitud
absolute/absolus/absoluten/absolutos (link/joint) angles/angle/winkel
encoder~/resolver~/codeur~ (…) deliver/deliver~/give/gives/measure/measures/mesure/mesurent
base line
effect/influence/rotation/motion/mass/contribution * (is/are/has/have/was/were) (been) neglected/ignored/disregarded/négligé~
approché~/approchée~/angenähert~/aproximad~
à l' arrêt
formula/equation/relation/formule/équation/elle/cela/this/it suppose/supposes/presupposes/assumes/suppose que/that/¤
(¤) (which/ici/here) denote/denotes/désigne/désignent/bezeichnet/denota (…) (the/le/la/l'/den/el) cosine/sine/sum/inclination/cosinus/sinus/somme/angle absolu~/kosinus/coseno/seno
point/place (here/considered/in) (question) (considered) is (not) (the)
rather/plutôt than/que the/la/le gripper/pince/tool/outil
conventions/convention … those/that/celles/celle of/de/d' (the) (another/second/other/un/une)
has no geometric/physical meaning
for what/which postures/configurations/angles/values
another/other/different/autre/anderen/anderer/otro/otra/altro/outro point/quantity/body/frame/joint/link/punkt/punktes/grandeur/größe/punto/magnitud
^ * is/are/est/ist/es (…) valid/exact/true/correct/satisfied/verified/valable/exacte/vraie/vérifiée/gültig/richtig/exakt/válida/exacta/cierta (only/seulement) for/if/when/in/at/where/as/pour/si/quand/lorsque/dans/für/wenn/falls/bei/para/cuando/en
^ * holds/gilt/vale (only/seulement/nur/solo) for/if/when/in/at/where/as/pour/si/quand/lorsque/dans/für/wenn/falls/bei/para/cuando/en
^ (…) find/determine/give/compute/state/trouver/trouvez/déterminer/déterminez/donner/donnez/bestimmen/finde/bestimme/hallar/determinar/encontrar … for/pour/für/para which/lesquelles/lesquels/laquelle/lequel/quelles/welche/los/las/qué
drive/drives/driven/motors/motor/actuators/moteurs/motores (…) (are/is/both) (mounted/placed/sits/sit/stands/stand/fixed) on/in/at/sur/en the/le/la/el base/frame/column/ground/pedestal/socle/bâti
orientation of (the) second/last/third/forearm/tool/hand/gripper (link) * constant/fixed/kept/same
keeps/keep/kept (…) (its/the) orientation/direction/horizontal/vertical/level
after/après/nach/tras/después (a/the/une/un/la/einer/der/una) (first/…) turn/rotation/quarter/shift/translation/displacement/move/drehung/verschiebung/giro/rotación
base/frame/origin/axes (…) (has/have/is/are/was/were) (been) turned/rotated/shifted/displaced/moved/tilted/inclined/mirrored/flipped by/through/to/about
(in) (for) the/this (special/…) case (where/in/when/that/of/with) $
case where/when/that/in (which) % , $
au cas où
dans le cas où/d'/de/des/du
für den/im fall
en el/caso caso de/que/en
is/was (only) the case (of/for/where/when/in) (a/the)
it/here/this is/was/has (been) (here/now/tacitly/implicitly) assumed/supposed/presumed
other/another/different/second (kind/type/version) (of) arm/robot/manipulator/crane/machine/mechanism/model/design
autre bras/robot/manipulateur/modèle/mécanisme
anderen/anderer/andere/zweiten roboter/arm/modell
otro brazo/robot/modelo
when/as/if/while/lorsque/quand/si/wenn/während/cuando/mientras only/seule/seul/nur/sólo/solo
neither/both/all/two joints/links/angles/motors … together/equal/equally/same/simultaneously
equal/same/identical/opposite angles/speeds/rates
neglecting/ignoring/disregarding/omitting/leaving/négligeant/ignorant/vernachlässig~/despreciando/ignorando/trascurando/without (out) (of) (the/a/any) (account) first/second/third/last/rotation/motion/movement/offset/angle/turn/contribution/contributions
"""
NEARLY = """
terms … (have) (has) (been/were/are) dropped/omitted/discarded/ignored
first/second/leading/third/premier/deuxième/erster/zweiter order/ordre/ordnung
erster/primera näherung/aproximación
approximat~/linearis~/lineariz~/linéaris~/neglect~/néglige~/vernachlässig~/näherungsweise/roughly
à peu près
as an approximation
good approximation
ignoring
for/if/pour/für/para small/de/kleine/pequeños (petits/petites) (angles) (winkel) (ángulos)
small/petits/petites/kleine angle/angles/motion/motions/displacement/displacements/mouvements/déplacements/variations/oscillations/winkel
angles are small
up to a/the/terms (of) (sign/factor/constant/second/third)
up to sign
au signe près
constante/facteur près
bis auf
salvo el signo
absolute value
either sign
from the sign
within (one/a/two/#) percent
≪
"""
OF_NO_CLAIM = """
demande/demander/demandons si
wonder/wonders/ask/asks/check/test/verify/decide/see if
preguntamos/pregunta/verificar/comprobar/chiede/chiediamo/verificare/perguntamos/verificar si/se
fragt/fragen/prüfen/prüft … ob
would/might/could/were/expected/serait/aurait/pourrait/wäre/würde/sería
never/jamais
don' t
il ne faut pas $
instead/rather of/than
in place of
au lieu de/d'
plutôt que
statt/anstatt
en lugar de
replace/remplacez/remplacer/ersetze
cross out
^ where * has $
unlike/contrary
contrairement
not to be
on the other hand
student/students/pupil/pupils/neighbour/élève/étudiant/étudiante/schüler/alumno/alumna/someone/somebody/copie/exam * write/writes/wrote/answers/answered/claims/says/écrit/lit/schreibt/escribe/read
claims/claimed/prétend/asserts/behauptet/afirma/answers/répond
according to
leaflet/rumour/web
someone/student/pupil/élève/étudiant/alumno
true/vrai/richtig/verdadero or/ou/oder/o false/faux/falsch/falso
which/lequel/laquelle (one) (of) (these) is/est right/correct/true
whether
counterexample/counter-example/contre-exemple
(discuss/comment) (on) the claim/statement $
are you sure
dire/vérifiez/vérifier si
does/is/are it/that/this/the * follow/true/right/correct (that) $
could it be
est-il/est-ce/a-t-on
ist/stimmt es/das
es cierto/verdad/correcto que
as in the case
comme dans le cas
"""
SUPPOSED = """
suppose/assume/imagine/pretend/supposons/admettons/imaginons/angenommen/supongamos/supponiamo/suponhamos * that/que/dass/che $
prove/show/verify/montrer/démontrer/montrez/démontrez/prouvez/beweisen/demuestre/dimostrare/demonstrar or/ou/oder/o/u disprove/refute/infirmer/infirmez/réfuter/réfutez/widerlegen/refute/confutare/refutar
^ & (or/ou/oder/o) (also/aussi/auch/también) when/whenever/if/for/at/lorsque/lorsqu'/quand/si/pour/wenn/falls/für/cuando/para $
suppose/assume/supposons/admettons/imaginons (…) that/que/qu' * $
suppose/supposing/assume/assuming/imagine/pretend/believe/supposons/supposant/admettons/admettant/angenommen/supongamos (,) (by) (contradiction) (for) (a) (the) (sake) (of) (argument) (moment) (now) (that) (que) (par) (l') (absurde) $
on suppose (que) $
contradiction , (let) $
as a hypothesis
supposedly/allegedly/purportedly/reportedly (,) $
^ & (can/could/may/might) it/this/that (really/ever) be that $
^ & (find/work) out if/whether $
^ (please) discuss/discutez/diskutieren (:) $
(you/one/we/students/some/many) may/might/can/could/will/often have read/heard/seen/met (that) $
^ (the/an/a/our) (last/old/previous/earlier/early/first/printed/original) (year/year') (s) version/solution/edition/draft/handout/sheet/printing * was/had/has/read/reads/gave/says/said (:) $
^ (many/some/most/other/several/a) (few) books/authors/textbooks/texts/notes/sites/pages have/write/print/give/say (that) (:) $
if we/one/it had/were
had/were it/we (found/the) (case) (that) $
par l' absurde
si l' on avait
si on avait
angenommen
solve/solving/résoudre/résolvons $
solution/solutions/root/roots of/to/de $
we look/search for $
we must (to) (solve/find/have) $
we have/need/want to (solve/find/have) $
find … such that
such that $
so as to have $
satisfying/vérifiant $
telle~/tel/tels que $
on cherche/veut $
^ & assuming/supposing/provided/unless/except/sauf % , $
^ & as long as % , $
^ & in the absence of % , $
^ & en supposant % , $
^ & à moins que % , $
^ & tant que % , $
^ & if/when/whenever/si/quand/lorsque/lorsqu' we/one/you/i/on/nous/l' (on) (now) assum~/suppos~/neglect~/ignor~/lock~/fix~/block~/weld~/had/bloqu~/fig~/soud~/néglig~/admet~ % , (then/alors) (we/on) (get/have/find/obtain/a/obtient/trouve) $
"""
ON_CONDITION = """
^ & if/when/whenever/si/quand/lorsque/lorsqu' % , (then/alors) (we/on) (get/have/find/obtain/a/obtient/trouve) $
"""
WE_DO = """
^ & if/when/whenever/si/quand/lorsque/lorsqu' we/one/you/i/on/nous/l'
"""
ASKED_BEHIND = """
^ * a/an/une/una/un/eine/uma/um (simple/mere/working) hypothesis/hypothèse/hipótesis/ipotesi/hipótese/conjecture/conjetura/congettura/conjetura/vermutung/annahme/guess
prove/show/verify/montrer/démontrer/montrez/démontrez/prouvez/beweisen/demuestre/dimostrare/demonstrar or/ou/oder/o/u disprove/refute/infirmer/infirmez/réfuter/réfutez/widerlegen/refute/confutare/refutar
^ (&) (or) does/do/did/is/are/can/could/will/would/should this/it/that/these/the * ? $
true/false/right/wrong/correct/so/agree/think/it/case/vrai/faux/exact/juste/accord/richtig/falsch/das/cierto/verdadero/falso/correcto/why ? $
true/false/right/wrong/correct/vrai/faux/exact/juste/richtig/falsch/verdadero/falso * ? $
est-ce/est-il * ? $
justify/justifiez
"""
OPEN_QUESTION = """
^ (and/but/so/et/mais/und/aber/y/e) what/how/where/when/who/whose/which/comment/que/qu'/quel/quelle/quels/quelles/où/quand/qui/wie/was/wo/wer/welche/welcher/welches/cómo/qué/dónde/cuál/cuáles/quién/come/che/cosa/dove/quale/quali/chi/como/onde/qual/quais/quem
"""
SAYS_LIMITS = """
^ outside/beyond (of) this/that/the
^ * terms * dropped/neglected/omitted/discarded/ignored
^ * applies/holds/valid/true (only) (to/for/in/at/within/on) (this/that/these) (one/single) configuration/case/posture/range/branch
^ * another/other/different expression/formula/equation/relation (has/must/is/should/applies/holds)
^ * válida/válido/vale/vrai/vraie/valable/valida/valido (que) (solo/sólo/solamente/seulement/apenas/somente/nur) (para/pour/per/en/em)
^ solo/sólo/solamente/apenas/somente/seulement/nur es/est/é/è/vale/gilt/válid~/valid~/valable
"""
LIMITED_BEHIND = """
^ at least when/if/for/in/as/where
^ du moins si/quand/lorsque/pour/en/dans
^ (only) (and) (et) if/when/whenever/provided/assuming/supposing/unless/except/lorsque/lorsqu'/quand/pourvu/sauf/si/falls/wenn/sofern/cuando
^ (only) (and) as long as
^ à condition que
^ tant que
^ instead/rather of/than
^ au lieu de
^ plutôt que
^ with joint
^ for unit/equal
^ avec l' articulation
^ this holds/is for the/a
"""

AT_WORDS = """
^ & with/for/at/when/if/where/setting/putting/taking/pour/avec/si/quand/lorsque
"""
AT_VALUES = """
^ & with/for/at/when/if/where/setting/substituting/putting/taking/pour/avec/en/si/quand/lorsque/à/für/mit/bei/wenn/para/con/cuando/per/quando (the/both/all/la/le/les/l'/deux/das/dem/el) ¤ * $
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
height/heights/abscissa~/ordinate~/hauteur/abscisse/ordonnée of/du/del (the) elbow/coude/codo
elbow/elbow' (s) itself/position/coordinates/height/velocity/speed
elbow/coude/codo/ellbogen is/lies/sits/has/est/se/a/está/tiene/liegt at/bei/en/in/position/velocity/height/with/pour/by/trouve/situe/given
elbow/coude/codo/ellbogen is/lies/has/est/está $
elbow/coude/codo : $
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
position of joint #
midpoint/mid-point/milieu/barycentre
middle of (the) (first/second/third/last) link
cent~ of mass/gravity
cent~ of (the) (first/second/third/last) link/bar/rod
centre de masse/gravité
centro de masa/gravedad
unit vector
vecteur unitaire
einheitsvektor
vector unitario
average/mean velocity/speed
"""
OTHER_FRAME = """
in/from/dans/relative/respect (to) (the/le) frame/repère 1/2/3/4/5/6/7/8/9
^ (expressed/written/resolved) in/with (respect) (to) (the/a) tool/tool'/body/moving/gripper/gripper'/end-effector/effector/effector'/hand/wrist (s) frame/coordinates/axes
expressed/resolved/written/given/computed/measured/represented/described/components/coordinates/vectors/quantities/everything … in/along/to (respect) (to) (the/a/its/their) (axes/frame) (of) (the) (end) tool/tool'/body/moving/gripper/gripper'/end-effector/effector/effector'/hand/wrist (s) (frame/coordinates/axes) $
expressed/resolved/written/given/computed/measured/represented/described/components/coordinates/vectors/quantities/everything … in/along/to (respect) (to) (the/a/its/their) tool/tool'/body/moving/gripper/end-effector/effector'/hand/wrist (s) frame/coordinates/axes
^ in/into/dans/im/en (the) frame of the (end) tool/gripper/hand/effector/end-effector
repère (de/du) (l'/la) (lié) (à) (l') outil/effecteur/pince/main
in/into/along (the/a/its) frame/axes/coordinates/basis (that) (is) (fixed/attached/bound) (of/to/on) (the) (last/moving/end/second/third) tool/tip/hand/gripper/end-effector/effector/body/flange/wrist/link
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
dans (le/un/la) repère/base (lié/liée/attaché) (au/à/du/de/d') (l'/la/le) (dernier/second/deuxième) outil/effecteur/pince/main/organe/corps/segment/poignet/solide
im/in werkzeugkoordinatensystem/effektorkoordinatensystem/endeffektorkoordinatensystem/greiferkoordinatensystem/tcp-koordinatensystem/werkzeugsystem/effektorsystem/endeffektorsystem/tcp-system/körperfesten
im/in koordinatensystem/system/bezugssystem des/vom werkzeugs/endeffektors/effektors/greifers/handgelenks/tcp
en/al (el) sistema/marco/referencial (de) (coordenadas/referencia) (ligado/fijo) (de/del/a/al) (la) herramienta/efector/pinza/mano/muñeca
nella/nel/alla/al/in terna/sistema/riferimento (di) (riferimento) (solidale) (dell'/della/del/al/all'/alla/di) utensile/pinza/organo/end-effector/effettore/mano/polso
no/ao referencial/sistema/quadro (de) (coordenadas) (da/do) ferramenta/efetuador/garra/punho/mão
seen * from/on the tool/gripper/hand
"""
OTHER_ORIGIN = """
origin (of) (the) (base) (frame) (is/lies) (placed) at/in (the) elbow
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
base/shoulder (is) displaced/shifted/offset (by)
after (a) (the) reflection
"""

# -- angles that are not those of the arm

LEVEL = """
angle/angles/winkel/ángulo/ángulos/both/all/each/¤ * to/from/with/against/of/and/à/depuis/desde/avec/et/l'/gegen/zur/zum/con/mit/und/la/die (the/l'/la/le/die/der) (fixed/base/world) horizontal/horizontale/horizontalen/ground/floor/sol/boden/suelo/x-axis
respect to (the) horizontal/ground/floor/x-axis
¤ * direction/orientation/inclination of * in the base frame
absolute (joint) angles/coordinates
angle/angles/ángulo/ángulos/winkel (¤) (and/et/y/und) (¤) (are/is/est/sont/son/sind) (all) absolu/absolus/absolute/absolut/absoluto/absolutos
¤ (and/et) (¤) (are/is/est/sont) (the) (an) (l') absolute/absolus/absolu
¤ est l' angle absolu
second/third/last/elbow/other angle is absolute/absolu
"""
NOT_RELATIVE = """
is/are not relative/measured (to/from) the first/previous link
"""
TURNED = """
measured/counted/mesuré~/compté~/gemessen/taken from/depuis/desde/gegen/with (respect) (to) (the/la/die) vertical~/y-axis
angle * with/between/and/avec/et (the/la) vertical/verticale/y-axis
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
angular/rotational … (first/upper/top) three (rows/components/entries)
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
"""
FIXED_AXES = """
fixed/fixe/fixes/fest/feste/festen/raumfest/raumfeste/raumfesten/fijo/fijos/fisso/fissi/fisse/original/originale/initial/initiale/stationary/extrinsic/extrinsèque/extrinsèques/base/space
"""
TURNED_AXES = """
moving/mobile/mobiles/current/courant/courants/new/nouvel/nouveau/nouveaux/turned/rotated/body/intrinsic/intrinsèque/intrinsèques/mitgedreht~/mitbewegt~/körperfest~/neue/neuen/móvil/móviles/nuevo/actual/corrente/correnti/nuovo/tourné/tournés/local/locaux
"""
# -- lengths and columns that are not those of the arm

OTHER_LENGTH = """
¤ is/denotes/est/ist (the) half/moitié/halbe
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
COLUMNS_REVERSED = """
columns/columna~/colonnes/colonne/spalten … reverse/reversed/inverse/inversé/exchanged/swapped/interchanged/permuted/vertauscht/umgekehrt~/other/échangées/permutées/intercambiadas/invertidas/invertite/scambiate
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
