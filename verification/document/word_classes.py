"""The kinds of words that sentences about displays are made of, a table a language; `clauses.py` reads them.

A line is a class and its words, and goes on in the next where that begins with blanks: `~` ends a stem, `_` joins words that count as one.
The classes are closed, function words and few stems, and no list of sentences.

    language                      small words by which the language of a sentence is told
    split, that, pronoun          begin another clause; "that" leads to what is said, thought or true; "it" is what the clause before is of
    this, display, part, letter   what a clause about a display is of: it, the formula, its sign, an angle or a length in it
    person, writer, arm           and others: people, "we", the machine (`base`, `local` tell its frames apart, `angle` of the letters)
    not, only, general            turn what is said, restrict it, or undo a restriction
    if, of, near, inside          lead to a condition, a circumstance, a place, a frame; `with` and `where` to what goes with it
    there, must, would            "there is", what has to be, what would be
    good, fault, error, lost      tell that something is right, wrong, an error, left behind; `differs`, `contains` go with these
    change, remedy                what is done to what is wrong, and what is right instead; `turned` is what a sign in it is, `same` goes with what others have, too
    neglect, suppose, held        tell that something is left out, supposed, or held
    case, frame, level, absolute  words of one case, of frames, of directions in space, of angles that are not those between links
    claim, have, think, use       what people do who make a claim, `edition` and `old` where old claims stand
    ask, query, inverted          what a reader is told to find out, and words that begin a question
    erratum, article, first       begin what is of no display here; what is of a noun of its own; the first of several
    instead, avoid                "instead of this", "avoid writing"
    given, counted, neutral       what is known, what is added up, what denies nothing when denied
    topic                         what a display may be called, or its quantity, without a judgement
"""

ENGLISH = """
language the of and is are to in we that this it with by which be as from for has have not was do does will can its an at on you your or if these when
this this it that these which the_above all_this the_following
display formula formulas formulae equation~ expression~ relation~ result~ identity identities line lines statement~ answer~ solution~ version~
  derivation~ computation~ calculation~
part sign signs term terms factor factors index indices subscript~ superscript~ exponent~ sine sines cosine cosines entry entries row rows column
  columns bracket~ parenthes~ coefficient~
letter angle angles length lengths coordinate~ component~ sum unit units dimension~ sides letters symbol symbols
person others student~ pupil~ candidate~ beginner~ reader~ author~ colleague~ classmate~ neighbour~ someone somebody people many book books textbook~
  participant~ group groups lecturer~ teacher~ class student teacher pupils colleague classmate manufacturer~ chatgpt web rumour leaflet manual manuals data_sheet datasheet some pupil
  exam
writer we i one you
arm arm arms robot~ manipulator~ link links joint joints motor~ elbow~ shoulder~ wrist~ tool~ hand gripper~ base forearm~ controller~ encoder~ sensor~
  mechanism~ camera~ workspace axis axes drive~ machine~ shaft~ belt~
split , ; : . ! ? and but or because since although though so whereas yet however therefore thus hence then while who which
not not never no nobody nothing none neither nor cannot no_longer
only only solely exclusively merely unless except provided providing as_long_as so_long_as at_least at_best at_most nowhere
if if when whenever once while until as_soon_as in_case unless provided providing as_long_as so_long_as when_fully_retracted when_it_is_fully_retracted
  if_it_is_fully_retracted when_the_arm_is_fully_retracted when_the_link_is_fully_retracted when_the_slide_is_fully_retracted
of for at near in with within without under during before after beyond outside inside around about along on close_to just_before just_after away_from
  up_to to
general all any every each arbitrary always everywhere general generally whatever whichever regardless irrespective both
error error errors slip slips
fault wrong~ false~ incorrect~ mistake~ mistaken typo typos misprint~ blunder~ forgot forgets forget forgetting swap~ interchang~ confus~ contradict~
  disagree~ withdraw~ withdrawn reject~ refuse~ invalid~ untrue erroneous~ flaw~ nonsense defect~ outdated obsolete superseded disprove~ refuted
  mistyped miscopied misread~ miscount~ overlook~ faulty inaccurate~ fallac~ misconception~ bogus spurious inconsistent inconsistenc~ incompatible
  unjustified untenable meaningless absurd corrupt~ slipped tempt~ trap traps careless~ too_many too_few once_too twice doubtful unsure unverified
  needs_a_correction to-do todo fixme should_have_been should_read should_be_read must_read fails_the fail_the failed_the bug bugs buggy rules_out ruled_out slip_of_the_pen slips_of_the_pen by_mistake by_accident accidentally inadvertently not_so the_opposite_is the_contrary_is no_sense
  sign_error far_from_true far_from_right far_from_correct senseless nonsensical errs erred uncertain retract~ take_this_back take_that_back take_it_back abandon~ mixed_up mixes_up mixing_up
  oversight is_off are_off had_to_take lost_an_angle lost_a_sign lost_a_term lost_a_factor not_verified under_no_circumstances
good right correct~ true valid hold holds exact exactly accurate~ apply applies applicable agree agrees match matches fit fits works acceptable
  satisf~ usable appropriate what_we_want the_case so
change replace~ exchang~ swap~ interchang~ revers~ correct correcting corrected remov~ delet~ cancel~ negat~ subtract~ strike struck cross crossed ignore disregard different
  opposite other chang~ added differ flip~ revis~ amend~ rectif~ repair~ mend~ rewritten squared multiplied divided raised transposed doubled halved
  read reads checked verified rechecked confirmed withdrawn preceded_by another plus_sign minus_sign
must should must needs need has_to have_to had_to would_have is_to are_to need_to should_have ought_to_be
would would
neglect neglect~ ignor~ disregard~ dropped dropping approximat~ roughly linearis~ linearized linearize linearizing crude leaving_out left_out discard~
  negligible small_angle small_angles small_motion small_motions small_displacements small_rotations up_to_sign to_within omits omitted to_first_order
  to_second_order to_leading_order of_second_order of_higher_order in_first_order first-order_approximation simplified small_deflections
  apart_from_the_sign either_sign in_absolute_value restricted_to limited_to confined_to up_to_a_sign up_to_a_factor up_to_a_constant
suppose suppos~ assum~ imagine~ pretend~ hypothes~ presum~ conjectur~ guess guesses claims_that allegedly supposedly hypothesis
held lock~ blocked blocking clamp~ frozen freeze~ brake~ weld~ held immobil~ at_rest stopped standstill motionless stationary same_length equally_long
  equal_length equal_lengths unit_length unity
claim states stated wrote writes write written claim~ said says answer~ hand_in handed submitted think~ thought believ~ obtain~ got gets get conclude~ print~ found
  finds asserts gives hands equal answered read
ask check verify decide discuss test judge examine justify tick disprove refute correct find_the spot criticise criticize comment_on determine_whether
  find_out
case special particular degenerate limiting posture~ boundary edge limit parallel approximation~ simplified another other different middle centre
  center midpoint local moving body coupled uncoupled contact gravity-free equal unit in_the_case home rest_position zero_position initial_position
  reference_position special_case limiting_case the_case_where the_case_of the_case_that
neutral dropped_out show_up shows_up turn_up symmetric interesting weigh weighs weighed drops_out tool_at_rest gripper_at_rest hand_at_rest end-effector_at_rest nonzero zeros if_and_only_if iff depend~ contain~ involve~ matter~ change~ affect~ appear~ enter need~ necessary difficult hard easy surpris~ trivial obvious doubt~ forget
  vanish~ vary varies move~ moves turn~ rotate~ unique~ require~ influence~ exceed~ include~ help~ explain prove discuss~ repeat~ deriv~ mention~ constant linear
  singular zero new distinguish~ invertible square possible reachable expected wanted coincidence~ accident~ determin~ simplif~ simple simply similar
  analogous easily studied allow~ permit~ shown exist~ solv~ unknown~
counted added counted taken considered included subtracted multiplied
remedy right correct corrected correctly instead rather remember
query is are does do did can could was were will has have had am shall why
instead instead rather contrary unlike in_place according_to
use use used trust apply
frame frame frames coordinates axes
base 0 base world inertial fixed reference same ground
local link links tool moving attached local body gripper hand second last own forearm wrist elbow
angle angle angles
level horizontal horizontally ground floor vertical vertically absolute x-axis y-axis clockwise inclination world
absolute absolute inclination parallelogram pantograph belt belts pulley~ driven_from mounted_on_the_base mounted_at_the_base in_the_base_and
  both_motors motors_on_the_base motors_in_the_base
edition edition version draft printing attempt guess try handout copy copies printout year answer answers response shortcut sheet solution solutions
  submissions
old old older previous former first last earlier original outdated early common typical usual frequent classic naive tempting intuitive hasty
  last_year's year's submitted
that that
with with
inside in into relative_to with_respect_to refer_to refers_to referred_to
given known given measured computed rigid ideal frictionless massless positive
think think believe imagine suspect expect
lost forgotten missing omitted dropped twice left_out overlooked
contains make~ made contain~ there commit~
turned flipped reversed inverted
same same too also likewise
avoid avoid
there there there's
differs corrected differs fails failed impossible lacks lacking replaced superseded
near near close_to beyond outside except away_from just_before just_after
first first
erratum erratum errata corrigendum
pronoun it they
where where wherever
have have had has
article the a an
topic position~ location~ origin~ velocit~ speed~ acceleration~ force~ torque~ matri~ determinant~ jacobian~ kinematic~ dynamic~ product~ vector~
  orientation~ rotation~ translation~ pose~ transform~ singularit~ rank invers~ transpos~ projection~ law rule theorem~ definition~ convention~ notation~
  configuration~ circle~ triangle~ model~ system~ distance~ derivati~ gradient~ function~ minimi~ maximi~ norm height radius reach output input next step
"""

FRENCH = """
language le la les l' d' de des du un une est sont et en on que qui dans par pour avec sur ce cette ces au aux ne n' pas nous se s' il elle plus où à
this ceci cela ça ce c' il elle elles ils qui ce_qui_suit
display formule~ équation~ expression~ relation~ résultat~ égalité~ identité~ ligne~ réponse~ solution~ version~ écriture~ démonstration~ calcul
part signe~ terme~ facteur~ indice~ exposant~ sinus cosinus entrée~ colonne~ parenthèse~ coefficient~ crochet~
letter angle angles longueur~ coordonnée~ composante~ somme unité~ dimension~ membres lettres
person étudiant~ élève~ débutant~ lecteur~ auteur~ camarade~ collègue~ candidat~ beaucoup certains quelqu' copie~ livre~ manuel~ plusieurs groupe~
  professeur~ copie copies
writer on nous je vous
arm bras robot~ manipulateur~ segment~ articulation~ moteur~ coude~ épaule~ poignet~ outil~ pince~ main base capteur~ axe axes mécanisme~ corps
  effecteur~ codeur~ courroie~ liaison~
split , ; : . ! ? et mais ou or car puisque puisqu' donc alors cependant toutefois tandis qui dont
not pas jamais aucun aucune aucunement nullement rien personne ni non guère
only seulement uniquement exclusivement sauf excepté pourvu tant_que à_condition à_moins n'_que du_moins au_moins
if si quand lorsque lorsqu' dès dès_que une_fois tant_que pendant pourvu à_condition à_moins
of pour dans à au aux en avec sans sous près autour avant après hors pendant sur le_long chez vers loin au_voisinage juste_avant juste_après
general tout toute tous toutes chaque quelconque~ quel_que quelle_que quels_que quelles_que toujours partout général générale générales
error erreur erreurs
fault n'_importe_quoi faux fausse fausses faussement erron~ incorrect~ inexact~ faute~ coquille~ manque~ oubli~ échang~ interverti~ permut~ confond~ confus~ contredi~
  contradiction~ réfut~ rejet~ refus~ invalid~ absurd~ retir~ démenti~ périmé~ tort mauvais mauvaise~ impossible incohéren~ incompatible~ aberrant~
  bévue~ piège~ gardez-vous gardera garder_d' tenté~ en_trop par_erreur par_accident par_mégarde le_contraire_est erreur_de_signe loin_d'_être contresens douteu~
  infirm~ mégarde inadvertance abandonn~ faudrait aurait_fallu
good juste exact exacte correct correcte vrai vraie valable~ valide~ vaut tient applicable~ s'_applique convient concorde~ bon bonne le_cas
change remplac~ échang~ corrig~ invers~ supprim~ retir~ chang~ interverti~ intervertir permut~ soustrai~ ajouter ajouté~ différent~ opposé~ autre
  barre~ rayer rayez ignorez ignorer rectifi~ modifi~ revoir reprendre lire vérifier prouver démontrer précédé
must doit doivent devrait devraient faut fallait faudrait il_reste aurait auraient est_à sont_à ne_faut
would serait seraient pourrait obtiendrait trouverait donnerait vaudrait deviendrait changerait écrirait prendrait ferait
  viendrait placerait
neglect néglig~ approxim~ approch~ linéaris~ petits ignor~ grossièr~ petites_variations au_signe_près à_un_facteur_près omis omise omet simplifié
  simplifiée au_premier_ordre du_second_ordre au_second_ordre du_deuxième_ordre faibles_angles à_peu_près restreint~ limité~
suppose suppos~ admet~ imagin~ hypothèse~ conjectur~ présum~ admis si_l'_on_avait si_on_avait
held bloqu~ fixe fixé~ figé~ immobil~ verrouill~ arrêt arrêté~ soud~ maintenu~ repos nul nulle freiné~ à_l'_arrêt même_longueur longueurs_égales
claim écri~ prétend~ affirm~ répond~ dit disent lit obtien~ trouv~ conclu~ croit crois croire croient croir~ croyai~ croyant pens~ donn~ rendu rendent soutien~ poser égal~
ask coch~ vérifi~ décid~ discut~ justifi~ réfut~ corrig~ trouvez_l' test~ commentez jugez examin~
case particulier~ spécial~ limite~ bord posture~ milieu centre précédent autre autres voisinage parallèle~ simplifié~ contact dégénér~ frontière
  égales unitaires position_de_repos position_initiale position_zéro cas_particulier cas_limite cas_où cas_d' cas_de
neutral outil_au_repos décal~ déport symétrique~ intéressant~ pèse~ pèsent pince_au_repos effecteur_au_repos outil_immobile pince_immobile nul nulle nuls nulles zéro zéros si_et_seulement_si ssi dépend~ contien~ intervien~ import~ chang~ affect~ besoin nécessaire~ difficil~ étonn~ surpren~ évident~ trivial~ doute~ oubli~ annul~ vari~ boug~
  tourn~ unique~ exig~ influ~ dépass~ suffi~ aide~ hasard constant~ linéaire~ surprise peine nouveau démontr~ détermin~ simplifi~ simple semblable~
  analogue~ étudi~ intéress~ possèd~ permet~ exist~ résou~ résol~ inconnu~
counted ajouté~ compté~ pris prise considéré~ tenu inclus~ soustrait~
remedy correct~ exact~ plutôt corrig~ bonne bon
query est sont peut était pourquoi
inverted est-ce est-il a-t-on peut-on serait-ce a-t-il est-elle sont-elles sont-ils a-t-elle serait-elle
instead au_lieu plutôt contrairement
use utilis~ employ~ appliqu~ recopi~ serv~
frame repère référentiel
base 0 base fixe absolu galiléen terrestre même
local segment~ outil mobile lié attaché pince main local deuxième second dernier avant-bras poignet
angle angle angles
level horizontal~ vertical~ sol absolu~ inclinaison
absolute absolu~ inclinaison parallélogramme courroie~ moteurs_sur_la_base moteurs_dans_la_base
edition édition version ébauche tentative copie corrigé réponse
old ancien~ première précédente dernier premier fréquente courante classique naïve tentante l'_an_dernier rendues remises
that que qu'
with avec
inside dans par_rapport rapporté~ se_rapportent
given connu~ donné~ mesuré~ rigid~ idéa~ positi~
think croit crois croire croient croir~ croyai~ croyant pens~ imagin~
lost oublié~ omis omise manque
turned inversé~ retourné~
same même mêmes aussi également
contains contien~ comporte~ y_a commet~ fait font
avoid éviter évitez évitons
there il_n'_y_a il_y_a
differs corrigé corrigée diffère
near près proche_de autour au_voisinage juste_avant juste_après hors sauf
first premier première
erratum erratum errata
pronoun il elle ils elles
where où
have a ont avait avaient portait
article le la les l' un une
topic position~ origine~ vitesse~ accélération~ force~ couple~ matri~ déterminant~ jacobien~ cinémati~ dynami~ produit~ vecteur~ orientation~
  rotation~ translation~ pose transformation~ singularité~ rang inverse~ transposé~ projection~ loi règle théorème~ définition~ convention~ notation~
  configuration~ cercle~ triangle~ modèle~ système~ distance~ dérivé~ gradient~ fonction~ norme hauteur rayon portée but étape suite
"""

GERMAN = """
language der die das den dem des ein eine einen einer und ist sind nicht wir man mit von für im auf zu wird werden sich aus bei als auch dass diese
  dieser dieses zum zur wenn kein
this das dies es was diese dieser dieses das_folgende folgendes
display formel~ gleichung~ ausdruck~ beziehung~ ergebnis~ zeile~ aussage~ identität~ lösung~ antwort~ rechnung~ fassung~
part vorzeichen term~ faktor~ index~ indizes indices exponent~ sinus kosinus eintrag~ einträge spalte~ klammer~ koeffizient~ summand~
letter winkel~ länge~ koordinate~ komponente~ summe einheit~ dimension~ seiten
person student~ studierende~ schüler~ anfänger~ leser~ autor~ kommiliton~ viele manche jemand buch lehrbuch~ gruppe~ kandidat~ einige
writer wir man ich sie du
arm arm roboter~ glied~ gelenk~ motor~ ellbogen~ schulter~ handgelenk~ werkzeug~ hand greifer~ basis sensor~ achse~ geber~ antrieb~ mechanismus
  regler~ arbeitsraum~
split , ; : . ! ? und aber oder denn weil da sondern daher also jedoch doch obwohl
not nicht nie niemals kein keine keinen keiner keines nichts niemand weder noch keineswegs mitnichten
only nur lediglich ausschließlich außer sofern solange soweit vorausgesetzt höchstens allenfalls wenigstens
if wenn falls sobald sofern solange während bevor nachdem ob bis
of für bei in im mit ohne unter nahe vor nach außerhalb innerhalb während an am auf um entlang kurz_vor
general alle allen aller jede jeden jeder jedem jedes beliebig~ immer stets überall allgemein~
error fehler fehlern
fault falsch~ fehlerhaft~ tippfehler~ schreibfehler~ druckfehler~ vorzeichenfehler~ rechenfehler~ fehlt fehlen fehlte vergess~ vertausch~ verwechs~
  widerspr~ widerleg~ unrichtig~ inkorrekt~ irrtum~ irrtümlich~ fälschlich~ ungültig~ unsinn~ verworfen abgelehnt übersehen ausgelassen unmöglich
  versehentlich unzutreffend~ denkfehler~ trugschluss~ verkehrt~ mangelhaft~ irrig~ versuchung zu_viel zu_wenig das_gegenteil aus_versehen zweifelhaft
  fraglich versehen müsste_hier müsste_es sollte_hier
good richtig~ korrekt~ wahr exakt~ gilt gelten gültig~ stimmt stimmen passt zutreffend~ trifft zulässig~ brauchbar~
change ignorier~ ersetz~ vertausch~ korrigier~ geändert ändern umgekehrt umkehren streich~ gestrichen entfern~ berichtig~ verbesser~ anders andere~
  entgegengesetzt~ negativ~ addiert abgezogen lauten heißen stehen
must muss müssen müsste~ soll sollte~ gehört gehören wäre_zu ist_zu sind_zu
would würde würden wäre wären könnte~ hätte
neglect vernachlässig~ näherung~ angenähert~ ungefähr~ linearis~ kleine_winkel kleinen_winkeln kleiner_winkel bis_auf_das bis_auf_einen ignorier~
  grob~ weggelassen vereinfachte vereinfachten in_erster_ordnung zweiter_ordnung beschränkt
suppose angenommen annahme~ annehm~ voraussetz~ vermut~ hypothes~ nehmen_wir gesetzt
held fest~ blockier~ gesperrt~ verriegel~ arretier~ steht still~ ruh~ gehalten eingefroren gebremst~ null gleich_lang gleiche_länge gleich_lange
claim schreib~ schrieb~ behaupt~ sagt sagen antwort~ glaub~ denke denkst denkt denken meint meinen erhielt~ abgegeben folgert~ liest setzen
ask kreuze~ ankreuzen prüf~ entscheid~ überprüf~ untersuch~ begründ~ widerleg~ korrigier~ diskutier~ beurteil~ finde_den finden_sie_den kontrollier~
case fall falle sonderfall~ spezialfall~ grenzfall~ gestreckt~ strecklage~ mitte anderen anderer anderes rand parallel~ vereinfacht~ näherung~
  grundstellung~ nullstellung~ nulllage~ ruhelage~ ruhestellung~ ausgangsstellung~ referenzstellung~
neutral null nullen wiegt wiegen dann_und_nur_dann genau_dann hängt abhäng~ enthäl~ spielt rolle ändert nötig notwendig~ schwer schwierig~ überrasch~ trivial~ zweifel~ vergessen verschwind~ variier~ veränder~ beweg~ dreh~
  eindeutig~ erforder~ braucht brauchen benötig~ wunder~ schlimm vorkomm~ kommt auftret~ beeinfluss~ neu einfach leicht bestimm~ ähnlich~ analog~
  erlaub~ betracht~ existier~ gelöst auflös~ lösen löst unbekannt~
counted addiert gezählt berücksichtigt genommen subtrahiert multipliziert
remedy richtig~ korrekt~ stattdessen sondern vielmehr
query ist sind stimmt hat kann wird werden wäre gilt_für gilt_die gilt_das warum
instead statt anstatt anstelle
use verwend~ benutz~
frame koordinatensystem~ bezugssystem~ system
base 0 basis~ welt~ fest~ inertial~ basiskoordinatensystem weltkoordinatensystem
local glied~ gelenk~ werkzeug~ mitbeweg~ bewegt~ greifer~ zweiten letzten ersten werkzeugkoordinatensystem
angle winkel winkels winkeln
level horizontal~ vertikal~ waag~ senkrecht~ lot boden x-axis absolut~ neigung~
absolute absolut~ neigung~ parallelogramm~ riemen~
edition fassung~ auflage~ version~ ausgabe versuch~ antwort lösungen
old alte~ frühere~ erste~ ersten vorige~ letzte~ häufige~ typische~ naheliegende~ übliche~ abgegebenen
that dass
with mit
inside im in bezogen
given bekannt gegeben gemessen starr~ ideal~ positiv~
think glaub~ denke denkst denkt denken mein~
lost vergessen fehlt fehlen doppelt weggelassen
turned umgekehrt~ umgedreht~
same gleiche gleichen dieselbe~ denselben selbe auch ebenso
contains enthäl~ es_gibt steckt liegt mach~
avoid vermeiden vermeide
there es_gibt
differs korrigiert weicht
near nahe in_der_nähe kurz_vor außerhalb außer
first erste~
erratum erratum errata
pronoun es
where wo
have hat haben hatte hatten
article der die das ein eine
topic position~ lage ursprung~ geschwindigkeit~ beschleunigung~ kraft kräfte drehmoment~ matri~ determinante~ jacobi~ kinemat~ dynam~ produkt~ vektor~
  orientierung~ drehung~ rotation~ translation~ verschiebung~ pose transformation~ singularität~ rang inverse~ transponiert~ projektion~ satz regel definition~
  konvention~ schreibweise~ konfiguration~ kreis~ dreieck~ modell~ system~ abstand~ ableitung~ funktion~ norm höhe radius reichweite nächste schritt
"""

SPANISH = """
language el la los las de del en y que un una es se por con para al no su lo como está son esta este más si entre cuando esto sabe
this esto eso ello lo_cual lo_siguiente
display fórmula~ ecuación~ ecuaciones expresión~ expresiones relación~ resultado~ igualdad~ identidad~ línea~ respuesta~ solución~ versión~ cálculo~
part signo~ término~ factor~ índice~ subíndice~ exponente~ seno~ coseno~ elemento~ columna~ paréntesis coeficiente~ sumando~
letter ángulo~ longitud~ coordenada~ componente~ suma unidad~ dimensiones miembros
person alumno~ estudiante~ lector~ autor~ principiante~ compañero~ muchos algunos alguien libro~ grupo~ profesor~ candidato~
writer se nosotros uno usted
arm brazo~ robot~ manipulador~ eslabón~ eslabones articulación~ motor~ codo~ hombro~ muñeca~ herramienta~ mano pinza~ base sensor~ eje ejes encoder~
  mecanismo~
split , ; : . ! ? y e pero o porque pues ya_que sino aunque entonces luego
not no nunca jamás ningún ninguna ninguno nada nadie tampoco ni
only solo sólo solamente únicamente salvo excepto siempre_que mientras a_menos_que con_tal_de al_menos
if si cuando mientras siempre_que una_vez en_cuanto a_menos_que
of para en con sin bajo cerca antes después durante fuera dentro sobre alrededor desde hasta junto lejos
general todo toda todos todas cada cualquier~ siempre general generales
error error errores
fault falso falsa falsos falsas incorrect~ erróne~ equivoc~ errata~ falta faltan faltaba faltó olvid~ intercambi~ confund~ contradi~ rechaz~ inválid~
  absurd~ mal retir~ imposible desment~ refut~ permut~ fallo~ incoherent~ inexact~ tentación sobra por_error lo_contrario por_descuido error_de_signo
  dudos~ descuido disparate
good correct~ cierto cierta verdad verdader~ exact~ válid~ vale valen cumple sirve coincide concuerda aplica así
change tach~ ignore ignoren cambi~ sustitu~ reemplaz~ corrig~ correg~ invert~ intercambi~ quit~ suprim~ elimin~ restar sumar otro otra distint~ opuest~ negativ~
must debe deben debería~ tiene_que tienen_que que_cambiar que_corregir debería_haber hay_que
would sería~ podría~ obtendría~ daría
neglect despreci~ aproxim~ lineali~ pequeños_ángulos ángulos_pequeños ignor~ casi omit~ simplificado a_primer_orden de_segundo_orden restringid~
  limitad~
suppose supon~ supong~ supuest~ admit~ imagin~ hipótesis conjetur~ asum~
held bloque~ fija fijo fijas fijos fijad~ inmóvil~ quiet~ parad~ frenad~ cero reposo misma_longitud
claim escrib~ afirm~ dice dicen respond~ obtien~ cree~ piens~ concluy~ entreg~ sostien~ poner
ask marqu~ comprueb~ verifi~ verifiq~ decid~ discut~ justifi~ refut~ corrij~ encuentre_el busque_el compruebe examin~
case caso casos particular~ especial~ límite~ extendid~ estirad~ plegad~ centro mitad otro otra borde parale~ simplific~ posición_extendida
  posición_de_reposo posición_inicial
neutral nulo nula nulos nulas cero pesa pesan ceros si_y_solo_si si_y_sólo_si depend~ contien~ intervien~ import~ cambi~ afect~ hace_falta necesari~ difícil~ sorprend~ trivial~ duda~ olvid~ anul~ varía~ muev~ gir~ únic~
  requier~ influy~ aparec~ extrañ~ nuev~ determin~ simplific~ simple similar análog~ estudi~ permit~ exist~ resolv~ resuelv~ incógnit~ desconocid~
counted sumado~ contado~ tenido considerad~ incluid~ restad~
remedy correct~ sino corregid~ correctamente
instead en_lugar en_vez
use us~ utiliz~
frame sistema referencia marco
base 0 base fijo inercial
local eslabón~ eslabones herramienta móvil ligado primer segundo último pinza mano
angle ángulo~
level horizontal~ vertical~ suelo absolut~ inclinación
absolute absolut~ inclinación paralelogramo correa~
edition edición versión borrador intento respuesta
old antigu~ anterior primera primer última frecuente común habitual típica ingenua entregadas
that que
with con
inside en respecto referid~
given conocid~ dad~ medid~ rígid~ ideal~ positiv~
think cree~ creer pens~
lost olvid~ falta
query es_cierto es_verdad es_correcto es_válid~ será_cierto será_verdad
turned invertid~ cambiad~
same misma mismo mismas mismos también
contains contien~ hay tien~ comet~ comete~
avoid evite evitar evítese
there
differs corregid~ difiere
there no_hay_ningún no_hay_ninguna hay
near cerca fuera salvo excepto
first primer primera
erratum erratum
pronoun ello
where donde
have tiene tienen tenía
article el la los las un una
topic posición~ posicion~ origen velocidad~ aceleración~ fuerza~ par matri~ determinante~ jacobian~ cinemátic~ dinámic~ producto~ vector~ orientación~
  rotación~ traslación~ pose transformación~ singularidad~ rango invers~ traspuest~ transpuest~ proyección~ ley regla teorema~ definición~ convención~
  notación~ configuración~ círculo~ triángulo~ modelo~ sistema~ distancia~ derivad~ función~ norma altura radio alcance paso siguiente
"""

ITALIAN = """
language il lo la i gli le di del della dei delle è un una e che per con si in non da al alla nel nella sono questo questa più come dal dalla se
this questo questa ciò esso essa quanto_sopra il_che quanto_segue
display formula~ formule equazion~ espression~ relazion~ risultat~ uguaglianz~ identità riga righe rispost~ soluzion~ version~ calcolo
part segno~ segni termin~ fattor~ indic~ esponent~ seno coseno colonn~ parentesi coefficient~ addend~
letter angol~ lunghezz~ coordinat~ component~ somma unità dimensioni membri
person student~ alunn~ lettor~ autor~ compagn~ molti alcuni qualcuno libro libri grupp~ candidat~ docent~
writer si noi uno
arm bracci~ robot~ manipolator~ giunt~ motor~ gomit~ spall~ pols~ utensil~ mano pinz~ base sensor~ asse assi membro link
split , ; : . ! ? e ed ma o oppure perché poiché quindi dunque anche_se allora
not non mai nessun~ niente nulla né neppure
only solo soltanto solamente unicamente salvo tranne purché finché a_meno_che almeno
if se quando finché appena qualora purché a_meno_che
of per in nel nella con senza sotto vicino presso prima dopo durante fuori dentro su attorno a al sul lungo
general ogni tutti tutte tutto qualsiasi qualunque sempre generale generali
error errore errori
fault falso falsa sbaglia~ errat~ scorrett~ refus~ manca mancano dimentic~ scambia~ confond~ contraddi~ inesatt~ assurd~ impossibil~ rifiut~ ritir~
  errone~ smentit~ invalid~ svist~ per_errore il_contrario errore_di_segno dubbi~ svista
good corrett~ giust~ vero vera esatt~ valid~ vale valgono applica coincide concorda
change ignorate ignorare barrate cambi~ sostitu~ corregg~ corrett~ invert~ scambi~ toglie~ elimin~ sottra~ aggiun~ diverso diversa opposto opposta altro negativ~
must deve devono dovrebbe~ bisogna occorre va vanno andrebbe
would sarebbe~ potrebbe~ otterrebbe darebbe
neglect trascura~ approssim~ lineariz~ piccoli_angoli angoli_piccoli ignor~ omess~ omett~ semplificato al_primo_ordine del_secondo_ordine ristrett~
  limitat~
suppose suppon~ ipotesi ammett~ immagin~ assum~ congettur~ si_supponga
held fermo ferma fermi bloccat~ fisso fissa fissat~ immobil~ frenat~ nullo nulla_angolo riposo zero stessa_lunghezza
claim scriv~ scritt~ afferm~ dice dicono rispond~ ottien~ cred~ pens~ conclud~ consegn~ sostien~
ask barr~ verific~ controll~ decid~ discut~ giustific~ confut~ corregg~ trova_l' trovare_l' esamin~
case caso casi particolar~ special~ limit~ distes~ ripiegat~ centro metà altro bordo parallel~ semplificat~ esteso posizione_di_riposo
  posizione_iniziale
neutral nullo nulla nulli nulle zero pesa pesano se_e_solo_se dipend~ contien~ compare import~ cambi~ influen~ serve necessari~ difficil~ sorprend~ banal~ dubbi~ dimentic~ annull~ varia~ muov~ ruot~ unic~
  richied~ bisogno nuov~ determin~ semplific~ semplice simile~ analog~ studi~ permett~ esist~ risol~
counted sommat~ contat~ considerat~ inclus~ tenut~ sottratt~
remedy corrett~ giust~ invece piuttosto bensì
instead invece al_posto
use us~ utilizz~
frame sistema riferimento terna
base 0 base fisso fissa inerziale
local braccio link giunto utensile mobile solidale primo secondo ultimo pinza mano
angle angol~
level orizzontal~ vertical~ suolo assolut~ inclinazione
absolute assolut~ inclinazione parallelogramma cinghia~
edition edizione versione bozza tentativo risposta
old vecchi~ precedente prima primo frequente comune tipica ingenua consegnate
that che
with con
inside nel nella in rispetto riferit~
given not~ dat~ misurat~ rigid~ ideal~ positiv~
think cred~ pens~
lost dimenticat~ manca
query è_vero è_corretto è_giusto sarà_vero
turned invertit~ cambiat~
same stessa stesso stesse stessi anche
contains contien~ c' commett~ fa fanno
avoid evitare evitate
there non_c'_è c'_è
differs corrett~_da differisce
near vicino presso fuori tranne salvo
first primo prima
erratum erratum
pronoun esso essa
where dove
have ha hanno aveva
article il la lo i gli le un una
topic posizion~ origine velocità accelerazion~ forz~ coppi~ matric~ determinante jacobian~ cinematic~ dinamic~ prodott~ vettor~ orientament~ rotazion~
  traslazion~ posa trasformazion~ singolarità rango invers~ traspost~ proiezion~ legge regola teorema definizion~ convenzion~ notazion~ configurazion~ cerchi~
  triangol~ modell~ sistem~ distanz~ derivat~ funzion~ norma altezza raggio passo
"""

PORTUGUESE = """
language o a os as de do da dos das é um uma e que em no na nos nas para com se não por ao são esta este isto mais como pelo pela seu sua
this isto isso este esta ele ela o_que o_seguinte
display fórmula~ equação equações expressão expressões relação resultado~ igualdade~ identidade~ linha~ resposta~ solução versão cálculo
part sinal sinais termo~ fator~ índice~ expoente~ seno cosseno~ coluna~ parêntese~ coeficiente~ parcela~ entrada
letter ângulo~ comprimento~ coordenada~ componente~ soma unidades dimensões membros
person aluno~ estudante~ leitor~ autor~ colega~ muitos alguns alguém livro~ grupo~ professor~ candidato~
writer se nós
arm braço~ robô~ manipulador~ elo elos junta juntas articulação motor~ cotovelo~ ombro~ punho~ ferramenta~ mão garra~ base sensor~ eixo~
split , ; : . ! ? e mas ou porque pois então embora logo
not não nunca jamais nenhum nenhuma nada ninguém nem
only só somente apenas unicamente salvo exceto desde_que enquanto a_menos_que pelo_menos
if se quando enquanto caso assim_que desde_que a_menos_que
of para em no na com sem sob perto antes depois durante fora dentro sobre junto
general todo toda todos todas cada qualquer sempre geral gerais
error erro erros
fault falso falsa errad~ incorret~ equivoc~ falta faltam faltou esquec~ troc~ confund~ contradi~ rejeit~ inválid~ absurd~ impossível desment~ refut~
  gralha~ erroneament~ inexat~ por_erro o_contrário erro_de_sinal duvidos~ descuido
good certo certa corret~ verdadeir~ verdade exat~ válid~ vale valem aplica coincide concorda
change ignore ignorem risque risquem troc~ substitu~ corrig~ invert~ mudar mudad~ retir~ elimin~ subtra~ somar outro outra diferente~ oposto oposta negativ~
must deve devem deveria~ precisa~ tem_de tem_que é_preciso
would seria~ poderia~ obteria daria
neglect desprez~ aproxim~ lineariz~ pequenos_ângulos ângulos_pequenos ignor~ omit~ simplificado em_primeira_ordem de_segunda_ordem restrit~ limitad~
suppose supon~ supo~ suposto hipótese~ admit~ imagin~ assum~ conjetur~ conjectur~
held travad~ bloquead~ fixa fixo fixad~ imóvel parad~ fread~ nulo nula zero repouso mesmo_comprimento
claim escrev~ afirm~ diz dizem respond~ obtém obtiver~ acredit~ pens~ conclu~ entreg~
ask assinal~ marqu~ verifi~ decid~ discut~ justifi~ refut~ corrij~ encontre_o confira examin~
case caso casos particular~ especia~ limite~ estendid~ esticad~ dobrad~ centro meio outro outra borda paralel~ simplificad~ posição_de_repouso
  posição_inicial
neutral nulo nula nulos nulas zero se_e_somente_se se_e_só_se depend~ contém contêm aparec~ import~ mud~ afet~ necessári~ difícil~ surpreend~ trivial~ dúvida~ esquec~ anul~ varia~ mov~ gir~ únic~ requer~ precisa
  influ~ nov~ determin~ simplific~ simples semelhante~ análog~ estud~ permit~ exist~ resolv~
counted somad~ contad~ considerad~ incluíd~ subtraíd~ levad~
remedy corret~ certo invés
instead em_vez em_lugar
use us~ utiliz~
frame referencial sistema
base 0 base fixo inercial
local elo elos junta ferramenta móvel ligado primeiro segundo último garra mão
angle ângulo~
level horizontal~ vertical~ solo absolut~ inclinação
absolute absolut~ inclinação paralelogramo correia~
edition edição versão rascunho tentativa resposta
old antig~ anterior primeira primeiro frequente comum típica ingénua entregues
that que
with com
inside em no na relação referid~
given conhecid~ dad~ medid~ rígid~ idea~ positiv~
think acredit~ pens~
lost esquecid~ falta
query é_verdade é_certo é_correto é_válid~ será_verdade será_certo
turned invertid~ trocad~
same mesma mesmo mesmas mesmos também
contains contém contêm há comet~ faz fazem tem
avoid evite evitar
there há não_há
differs corrigid~ difere
near perto fora exceto salvo
first primeiro primeira
erratum erratum
pronoun ele ela
where onde
have tem têm tinha
article o a os as um uma
topic posiç~ origem velocidade~ aceleraç~ força~ torque~ matri~ determinante~ jacobian~ cinemátic~ dinâmic~ produto~ vetor~ orientaç~ rotaç~ translaç~
  pose transformaç~ singularidade~ posto invers~ transpost~ projeç~ lei regra teorema~ definiç~ convenç~ notaç~ configuraç~ círculo~ triângulo~ modelo~ sistema~
  distância~ derivad~ função norma altura raio alcance passo
"""
