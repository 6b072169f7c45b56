"""The words of robot-arm courses, in which equations are led to and spoken of: a sentence of others may say anything.

They are those that two or more of some 170 public documents on arms have beside their displays, and what goes with them, without
the words that deny, doubt, judge or tell of people. An English word of seven letters or more stands for all
that begin with the same seven, one of another language for those that begin with the same six.

`OF_GERMAN` are of a sentence in which nouns begin with capitals, `OF_ARM` those of which a sentence is that says something of the arm and not of the display, `GOES_ON` begin what goes on from
a display, and `LOADED` are those that a sentence of the display may deny it by, and others have often.
"""

ENGLISH = """
abbreviate ability able about above abscissa absolute accelerate according account accuracy achievable achieve achieving across acrylic act acting
action actions activates active activity actor acts actual actually actuated actuation actuator adaptive add added adding addition additive adds
adjacent adjoint adjugate adjust admissible advance advantage affect affine aforementioned after afterwards again against agree agrees algebra
algorithm align aligned all allow allowing allows alone along alpha already also alternate although always among amount amounts amplified amplify an
analogous analogue analysis analytic analyze analyzing anchor and angles angular animation anisotropy ankle ankles annotations announced annulus
another answer anthropomorphic anticlockwise any apart app appear appears appendix applications applied applies apply applying approach appropriate
approximately arbitrary architecture arcs arctan arctangent arduino are area aren argument arise arises arising arithmetic arms around array arrive
arrow articulated as asks aspects assembly assign assignment assigns associated assume assumed assumes assuming assumption asymptotic at atan attached
attachment attainable augmented automatically autonomous auxiliary available average avoid avoidance axis back background backlash backward balance
ball based basic basically basis battery be beam because become becomes been before beforehand begin behave behavior behind being believe belongs
below belt bench bend bending bends between beyond bibliography bicep big bigger bin bins biomechanical bisector bit black blackboard block blocks
blue bodies body bolt bolted book books boom both bottom bound boundary bounded bounding bounds box boxes brackets brakes braking branch branches
break breaks brevity briefly browser bucket building builds built but button by cable cables calculate calculus call called calls camera cameras can
cancel cancellation candidate cannot canonical capture carriage carries carry cart cartesian cascade case cases cauchy causes ceiling center centered
centers centimetres central centre centrifugal centripetal certain chain chaining chains change changes changing channel chapter characterized chart
check checked checking checks choice cholesky choose choosing chosen circle circles circular claim clarity classes classic classify claw clear clearly
click clock clockwise close closed closes closure cm code coefficient cofactor coincide col collaborative collecting college collision collocation
colored colors column columns columnwise combination combine combining comes command common commonly communicates compact companion compare comparing
compatible compensating compiled complete complex component compose composite compound computation compute computing concatenate concept concisely
conclude conclusion concrete condition cone cones confirm conjugate connect consecutive consequence conservation consider consist constant constraint
construct contact contain contents context continues contrast contributes control convenient converge conversely convert convex convexity conveyor
coordinated core coriolis cornerstone corollary correct corresponds cos cosine cosines cost counterclockwise coupled course courses covariance covers
craig crane crank create created creates creating creation critically cross crucial cubic cubing cumulative current curvature curve curved curves
custom cycle cycles cylinder cylindrical damped damping dark dashed dataset decay deceleration decide decides decision decomposing decreases deficient
defined defines defining definite deformation degenerate degree degrees delta demo demonstrate denavit denominator denote denoted denotes denoting
dense density depend dependent depending depends depicted derivation derive derived deriving descent describe description design designate designed
designing desirable desire desired desk desktop det detail detailed details detect detection determine developed deviation device dexterity diagonal
diagram did different difficulty dimension directions directly disc discrete discriminant discuss displacement display distal distribution diverges
divide dividing division docs document does dof dofs dog doing domain done dot dots dotted double down download downward draw drawing drawn draws
drill drilling drive driven drives driving drone drones dual duality duration during dynamic each earlier easier easiest easily easy edge edges
edition educational effect effective effector effects efficient effort efforts eigen eigenvalue eigenvector eight either elastic elbow elbows electric
elegant element elevator eliminate ellipsoid elsewhere embed embedded embedding emphasizes employed enables enabling encode encoded encoder encodes
encompassed end endpoint ends energy enforce enforcing engine engineering enough ensure ensures ensuring enter entire entirely entries entry entrywise
environment environments eq eqn eqs equal equality equals equate equated equating equation equilibrium equivalent especially essential establish
estimation etc euclidean euler evaluate even eventually every everything everywhere exact exactly example excavator execute exercise exerted exist
existence existing exists expand expanded expanding expansion expect expected experiment explain explicit exploration explore exponential express
extend extended extends extension external extra extract extremely face faces fact factor factoring factors factory facts familiar families family
famous far farther fashion fast faster fastest feasible feature feed feedback femur few field fields fifth fig figure figures file files fill filled
filter filtering finally find finding finds finger finger's fingers finite firmly firmware first fitting five fix fixed fixes fk flange flat flexible
flipped flipping floating floor flow focus focused fold folded folder folding folds follow followed following follows foot for force forced forces
forearm form formal formalism formally format formed former forming forms formulae forward found foundation four fourth fraction frame frames
framework free freedom frequency fresh friction frobenius from front full fully function fundamental further future gain gait gamma gantry gaps gazebo
gear gearbox general generate generic gently geometry get gets gimbal github give given gives giving global go goal goals good governed grabbing
gradient graph graphed graphical grasp gravitational gravity greater green grid gripper gripping ground group grouping grow grows guarantees had half
halfway hand handed handle handling handy happens hardware hartenberg has have having header headers heading heads heart heavier heel height helper
helpful hence here herein hertz hexapod high higher highly hinge hint hip hips historically history hobby hold holds hollow holonomic home homework
homogenous horizontal host hour hours how however humanoid hybrid hypotenuse hypothesis ideal identical identify identity if iff ik ill-conditioned
illustrate image images imaginary imagine immediately impedance implement implies implying important in include including incorporate incremental
indeed independent index indicate individual induced industrial inequality inertia infinity influence information initial inner input inputs inserted
inserting inside insight inspecting install instance instant instead integer integral intelligent interactive interested interface interior
intermediate internal interpolate interpret interrupt intersect interval into introduce intuitive invariant inverse inversion invert inverted
inverting inverts invoking involves is isolate isolating isotropic it iteration ith its itself jacobian jerk jib joint joints jordan joystick jth
julia just keep keeping keeps kept kernel key keyboard keys kinematic kinetic kit kitchen knee knees know knowing knowledge known kutta lab label
labeled labels laboratory lagrange language laplace laplacian large larger largest last later laterally latter law laws layout lead leading leads
learn learned learning least lecture left left-handed leg legged legible legs leibniz lemma length lengthen lengths lengthy lens less lesson lessons
let lets letters level lever leverage libraries library lidar lie lies life lift lifting lifts lighter lightweight like likewise limit limited limits
line linearise linearly lines link linkage links list listed listing little live lives living load loaded local locally located location lock log
logarithm logic long longer longest look looking looks loop loops loosely lower lowering lowers lyapunov machine machines made magnetic magnitude main
mainly maintaining make makes making manifold manipulate manual manually manufacturing many map mapping maps markers mass masses massive massless mast
master match matches matching materials math mathematica matlab matplotlib matter matters maximal maximise maximize maximum may mean meaning means
meant meanwhile measure mechanism meet meets memorise memorize meshes meter meters method methods metre metres metric metrics microcontroller middle
millimetres milling millisecond minimal minimise minimize minimum minor minors minus minute minutes mirror mirrors mm mobile mobility mode model
modeled modeling models modes modest modified modify modular module modules modulo moment moments momentum moore more morning most motion motions
motor motors mounted mounting mouse move moveit movements moves moving mth much multi multiple muscle muscles must mutually name named namely names
natural nature navigate navigation near neatly necessary need needed needs negated negative neglect neighborhood neither net neural new newton next nicely
nine node noise non nonconvex none nonlinear nonsingular nontrivial nonzero norm normal normalise norms note notebook notes notice noting notion
notions now nozzle null number numbers numerator numeric numpy object objective objects observation observe observing obstacles obtain obtained
obtaining obtains occur occurs of off offers offset offsets often onboard once one online onto open operate operates operation operator opposite
optimal optimise optimized optional or orange order ordered ordinate orientations oriented origin original origins orthogonal oscillates our out outer
outline output outputs outside outwards over overall overshoot overview own packages packing page pages painting pair pairs pallet palletizing panel
panning paper papers paragraph parallel parameter part partial particle particular partition parts pass passed passing passive passivity path paths
pattern payload peak peaks pedestal pen pencil pendulum penrose perfectly perform period periodic periods perpendicular perspective perturbations
pfaffian phase phi phone physical pi pick picking picks pictured piece pieces pieper pin pinned pipeline pitch pitching pivoting place places planar
plane planes planned planning plate plates platform plays plot plots plotted plotting plug plugged plugging plus pocket pointing polar
polar-coordinate polynomial poor popular portion portrait posed poses positional positive possibility possible post postmultiply postures potential
power powered powerful powers practice pre preceding precise precision predict preferable preferred premultiply prepare preparing prescribed present
preserves press prevent previous primary principal printed printer prism prismatic problem procedure proceeds process produce product profile program
project promised proof propagate proper properly property proportional proposition prototype prove proved provide providing proximal proximity pseudo
pseudoinverse published pulling pulls puma pure purely purposes push pushes pushing put puts putting pythagoras python quadrant quadratic quadruped
quantities quarter quasi quaternion query question quick quickly quintic quoted quotient rack radial radially radians radii radius rail raise raises
ram random range ranges rank rate rates ratio rational re reach reachable reached reaches reaching reactions read readability readable reader readers
reading readme ready real realistic realizing rearrange reason reasonable recall recalled recalling recalls recap recent recognise recommended record
recorded records recover rectangular recursion reduce reducer reduces redundant refer reference referred refers reflects regardless region regions
regrouping regular relabeling relate related relates relating relationship relative relevant remain remainder remaining remains remark remember
reminder remotely remove removed removes removing render rendered rendering repeat repeated repeats replace replay report repository represent
reprinted reproduced require requiring research reset resistance resolution resolving respect responsiveness rest restrict result resultant resulting
results retracting return returned returning returns review revolute rewrite rewriting rewritten rhs right right-handed rigid rigidly rigorous ring
robot's robotic robots robust robustness rodrigues roll rolling root roots rotary rotate rotated rotates rotating rotational roto rototranslation
roughly round routine rover row row-wise rows rpy rule run runge running runs rviz rx sac safety same sampled sampling satisfied satisfy saw say
scalar scale scaled scaling scara scenario scene schematic school schur schwarz science scipy scratch screen screw screws script scripts sec second
seconds section see seek seen select selecting selects self semester semi sense sensed sensing sensitive sensor sensors sent separate sequence
sequentially serial series serves servo servo-driven servomotors servos set sets setting settling setup seven several severity shall shank shape
shapes share shared sheet sheets shelf shifts shin shop short shortcut shorten shorter shortest shorthand shoulder show showed showing shown shows
side sides signal signed similar simple simpler simplest simplicity simplified simply simulated simulink simultaneous sin since sine sines single
singular sits situation sixth size skeleton sketch skew slice slide slider sliders slides slope slow slowest slowly small smaller smallest smooth
smoother smoothly smoothness smooths snippet so soft software solid solve solved solver solvers solves solving some sophisticated sort source sources
space spaced spaces span sparse spatial speak speaks special specific specify spectral speed speeds spelled sphere spheres spherical spider spin
spindle spinning spline splitting spoon spray spreadsheet spring square squared squares squaring stability stable stack stacking stage stages stand
standard standing stands start started starting starts state stated statement states static statics station stay steering step stepper steps stewart
stiffness still stop stops stored stores straight strategy stress stretch strictly strong strongly structural studied studies study studying sub
subject submatrix subscript subsection subsequent subset subspace substitute subtract success such suitable sum summarize summary summation summed
summing sums superscript supported suppose supposing sure surface sweep sweeping sweeps swept swing swinging swings switch switched swivelling
symbolic symbols symmetry sympy system systems table tables tabular take taken takes taking tall tangent target targets task tasks taylor tcp
technically techniques technology tedious telescoping ten tends tensor term term-by-term terms test text textbook th than that the their them then
theorem theoretical theory there thereby therefore therein these thesis theta they thigh thing things third this those though three three-dimensional
threshold thrice through thumb thus tibia tilting time timer times timing tip to toe together tolerances too tool toolbox tools top topology torch
torque torques torso total touch toward towards toy trace traced traces tracing track tracked tracking tracks traditional train training trajectory
transcendental transcription transfer transform transition translate transmitted transpose trapezoid traslation traveled traveling tray treat treated
treatment treats tree triangular trick trig trigonometry trivial true trunk turn turned turning turns turret tutorial twelve twice twist twists two
two-dimensional type types typical typing ultimate unattainable unchanged under underlying understand uniform unique uniquely unit units universal
unknown unreachable unstable until up update updated updates upon upper upward upwards urdf us usage use used useful uses using usual usually valid
value values vanish vanishes variable variance variation varies variety various vary varying vast vectors vehicle vehicles velocity verification
verified verify version vertical very via vice video videos view virtual viscous visible vision visual visualize visually voltage volume waist walker
walking wall wall-mounted want warehouse was way waypoint ways we web weight weighted weighting weights welded welding well were what wheel wheeled
wheels when whence whenever where whereas wherein which while white whiteboard whole whom whose why wide widely width will window with within word
words work workflow workpiece works workshop workspace workstation world worth wrap wrapped wrench wrenches wrist write writes writing written wrt xy
yaw yawing yellow yet yield yielding yields yoshikawa you your zero zeros zyx zyz
"""
FRENCH = """
a abord abordé aboutissons abrégée abréviation abscisse absolue accorde accélère accélération achève actionneur actionneurs addition adjointe affecte
affichage ai aide ailleurs ainsi aisée aisément ait ajout ajoutant ajoute algébriquement alignement aligné aller allongement alors altitude amortis
amène analogie analyse angle angles angulaire animation annexe annoncé annule antisymétrique apparaître appelant appelle appelons appelée application
applique apport approche appui après arc arrivons arrivée arrière arrête article articulaire arête asservir atelier atteignable atteignables atteindre
au au-dehors au-delà au-dessous auparavant aussi autant autour autre autrement autres aux avance avant avant-bras avec avoir avons axe axes baissent
banc barre barres bas base basse beaucoup besoin bibliothèque bien bientôt bleu bloc blocs bon bonne bonnes bons bord bords borne bornent boucle bouge
bougent bouger boule bout bouts bras broche buse butée butées bâti calcul caméra canonique capteur car caractérise carré carrée carrés carte cartésien
cas cauchy cause ce ceci cela celle celles celui centimètre cercle ces cet cette ceux chacun changement chapitre chaque charge chargé chariot chaîne
chemin cherche cheville chiffres choisit choix chose chuter ci ci-dessus cible cibles cinq cinquième cinématique classique code codeur coefficient
cofacteurs cohérente colinéaire colonne comatrice combien commande comme commence commode commune comparaison complète complément composante
comprendre compte comptée concourant conditionnement conduit configuration confirment confondus connaissant connaît connu connue connus considère
consigne constitue constructeur consulter conséquence contient continuons contribution convention conviennent convoyeur coordonnée coplanaire corps
correct correspond cosinus cote coude coudes coulisse coupent couple couramment courant courbe couronne cours court courte courts coïncide coûtent
crayon crochet croissent croît croître cuisse câble câbles côte côté côtés d d'où dans de degré degrés demande demi-tour depuis dernier dernière
derrière des descend dessin dessus deux deuxième devant devient devoir dextérité deçà di diagonale diapositive diffèrent différence dimension dire
direct dirigé discutez dispose disque distance dit divisant divise division doigt doigts doit donc donne donnent donnez donné donnée dont dos dossier
douze droit droite droits du durant durée dynamique débattement début débute décalage décide découle découplage décrit déduire déduisons déduit défini
déjà démarche démonstration démontrer dénominateur départ dépasse dépend déplace déplié déport dépôt dérivant dérivez dérivée désigne désormais
détaillé déterminer développant effecteur effet elle elles ellipse embase empattement empilant emploi employer en encore endroit enfin engrenage
ensemble ensuite entier entière entre enveloppe espace essai essais est est-à-dire et euler exact exacte examen excentricité exemple exercice existe
exposant expression exprime expérience extrémité extérieur facile facteur factorisant faire faisant fait faites faits famille faut façon façons ferme
feuille fiche fichier figure fin finalement fixe flèches fois fonction font force forces forcée forcément forme forment formes formule fort fourche
fourni frein freins frontière frottement gagne gagnent gauche genou glisse glissière godet grand grande graphe graphie gravitation grue grâce général
géométrie habituel hanche haut haute hautes hauteur histoire historiquement homogène horizontalement hors huit hypothèse hypoténuse ici identifiant il
ils image immobile immédiatement impair implantée implémenté important imprime inchangée inclinaison inconnues incrémental indication indice indique
indispensable industriel indépendamment inertie inférieur injectant interne interprétation interviennent intitulé introduire intuition intègre
intégrant intéressant intérieur inverse isolant jacobienne jambe jambes joint joue joule jusqu juste kilogramme l la laboratoire lacet lagrange
laissant laisse langage laquelle large laser le lecteur lectrice lecture lemme lente lentes lequel les lesquelles lettre leur leurs liaison liberté
libre libres lieu ligne lignes limite limités linéaire lire lisent lisons liste lit livre livres lié logiciel loi loin longs longue lors lorsqu lourd
lourde lue lui lui-même lus là là-bas léger légère machine maintenant maintient mais majuscule manipulabilité manière manuel marque masse masses
matlab matrice membre mesure mesurés mettent mettre mi-parcours mieux milieu millimètre milliseconde mince mineurs minuscules mise mobilité modèle
modélisation moindres moins moitié monte montre montrons moteur motif motivation mouvement moyen multipliant mutuellement mât mène mènent mètre mètres
mécanisme méthode même mêmes n naturel neuf newton nom nombre nommant nomme nommer nommé nommée noms normale norme normes nos notamment notation note
noter notons notre noté notée notées notés nous nouveau nouvel noyau nul nulle nulles nuls numérateur numériquement nécessaire négatif négligé nôtre
nôtres objet obtenir obtenons obtention obtenu obtiendra on ont opposée opérateur orange ordinaire ordonnée ordre organe orientation origine
orthogonale orthonormé ou oublier outil outils ouverte ouvrage où page pages paire panneau par par-dessus paragraphe parallèle paramètre paramétrage
parcourt pareillement parent parfois parler partent partie partir partout parvenons parvient passage passant passe passent passer passons patte pattes
peinture pelle penche pend pendant perd perdent perdu perdue permet perpendiculaire perçage pesanteur petit petite peut peuvent photo physiquement
pied pilotage piloter pince pinces pivot pivote pivots pièce pièces place placent placez plan planaire plane planification plans plateau plaçons plein
plie plié plupart plus plusieurs poids poignet point pointe points polaire polycopié polynôme porte porteur portique porté portée posant pose poser
position posons possède posture posé posée pour pourra pourrons poursuivons pourtant pousse poutre pouvez pouvons premier première prend prendre
prenons preuve primes pris prismatique processeur proche procédure produit programmation projection projet propre propriété prototype prouver près
précis précède précédent prédiction prédire prédisez préférée préhenseur prémisse présente publié puis puisqu python période pôles qu quand quart
quatre quatrième que quel quelconque quelle quels question qui quitte quoi quotient racine radian raison ramener rang rapide rappel rapport rarement
rassemble rayon rayons reconnaît recule redondance regroupant rejoignent relation remarquable remontant remplace remplies rencontre rend rendent
rentrée replier replié reportant repos repose représente repère respectifs restant reste restent retenir retenons retenue retourné retranchez retrouve
revenons revient rigide robot robotique rotation rotatoire rotoïde rotule roulis règle règles réalisé réciproque récurrence réducteur réduire réduite
réel réflexion référence région réglage régler réglée régulateur répond réponse répète répétabilité résolution résolvant résoudre résout résultat
résumé réuni réunissent rôle s s'écrit sa sait satisfont saute sautent savoir scalaire schéma se seconde secteur section segment selon semaine
semblable sens septième sera seront sert servent servira servomoteur servomoteurs ses seul seule si signe signification similaire simple
simplification simulateur singularité sinus six sixième socle soient soit solide solution sommant somme sommes sommet son sont sort sorte sortie
sortir soudure souhaite sous soustraction souvent spatiale sphère sphérique statique strictement structure stylo substituant successivement suffisant
suffit suit suite suivant suivent suivre supposant supérieur sur surface symbole symétrique système séance sécants sépare série t-elle t-il table
tableau tableur taille tandis tangage tangente tant tard technique tel telle tels temps tendu tenu terme termes terminal testez texte thèse théorème
tient tige tiges tire tirer titre tombe torche torse torseur torseurs torsion total totale toujours tour tournant tourne tourné tours tous tout toute
toutes tracé tracée traité trajectoire transformation translation transposer travail travers triangle trigonométrique trièdre trois troisième tronc
trop trouve trouvons trouvée tâche tâches télescopique tôt ultérieure un une unicité unitaire unité unités usine usuel usuelle utile utilise va vaille
valable valeur valoir variable varie vaut vecteur vectoriel ventouse verra verrons vers vert verte verticalement vides viennent vient virtuel visible
vissage vitesse voici voilà voir voit volume vont vrai vraie vu vue vérification vérin vérins y zone zéro à à-dire écart écarts échange
échantillonnage écrire écrit écriture écrivez écrivons édition égal égalant égale également égaler égales égalité égaux élevant élever éliminant
élongation élément élévation énergie énoncent énoncé épais épaule équation équivaut établi était étant étape étapes étend étendu étroit étude étudie
étudié été évaluation évaluer évident être
"""
GERMAN = """
ab abbildung aber abgeleitet abgeschlossen ableiten ablesen absatz abschnitt absolut abstand abszisse absätze abtastung achse achsen addieren addition
aktuell alle allem allen aller alles allgemein als also am an analog andere anfang angegeben angenommen angewendet anhand anhang annahme annehmen
anordnung ansatz anschließend anteil antrieb antwort anwenden arbeit arccos arctan arkustangens arm armes artikel auch auf aufgabe aufgelöst
aufgestellt auflösen aufstellen aus ausdruck ausführlich ausgangspunkt ausgedrückt ausgewertet ausklammern ausmultiplizieren auswerten auswirkung
auswählen außen bahn bahnen band basiert basis basiskoordinatensystem bauform bedeutet bedingung befinden beginn behandeln behauptung bei beide beiden
beider bein beispiel beitrag beiträge bekannt bekommt beliebig bemerkung benutzen benötigen berechnen bereit berücksichtigt beschleunigung beschreibt
besitzt besteht bestimmen bestätigt betrachte betrag bewegen bewegt bewegung beweis bewiesen bezeichnen bezogen bezug bezüglich bibliothek bild bilden
bilder bildet bildschirm bis boden bogenmaß brauchen bremse brenner buch bzw bücher code cosinus dabei dafür dagegen daher damit danach dann daran
darauf daraus darf dargestellt darin darstellung das dass datei dateien daten datenblatt davon dazu decke definiert dem demnach den denavit denn
denselben der derart deren derselbe des deshalb dessen detail determinante dh diagonal die dies diese dieselbe dieser dieses differenz dimension
direkt dividieren drehachse drehgelenk drehmatrix drehmoment drehung drehwinkel drei dreieck dritte durch dynamik düse ebene ebenen ebenfalls ebenso
echtzeit eigenschaft ein eindeutig eine einem einen einer eines einfach einfluss eingabe eingesetzt einheit einige einmal einsetzen eintrag einträge
einzelne elemente ellbogen encoder ende endeffektor endpunkt energie entfernen enthält entlang entnehmen entnommen entsprechend entsteht erfolgt
erfüllt ergab ergaben ergeben ergebnis ergibt erhalten erhält erinnerung ermitteln erreichbar erste ersten erster erstes erweitert erwähnt es etwa
experiment explizit faktor fall fertig fest feste festen figur finden findet flansch fläche folge folgen folglich folgt form formel frage frei freie
freien freiheit früher funktion fuß führt fünf für geben gegeben gegenüber gehabt geht gehört gelenk gelten gemessen gemäß genannt genau genügen
genügt geometrie geprüft gerade gerundet gesamt geschlossene geschrieben geschwindigkeit gespeichert gestell gesucht getriebe gewicht gewählt gezeigt
gibt gilt gleich glied glieder grad grafik greifer grundlage größe größen größer gültig haben halb hand handgelenk hat hatte hatten heißt hergeleitet
herleiten hersteller hier hieran hieraus hierbei hierfür hierzu hinten hinweis homogene horizontal hub hängen hängt höhe hüfte ihr ihre ihren ihrer
ihres im immer implementiert in indirekt industrie ingenieur innen insbesondere insgesamt inverse invertieren isolieren ist jacobi jede jedem jeden
jeder jedes jetzt jeweils kabel kamera kann kapitel kartesisch keine kette kilogramm kinematik kinetisch klassisch knie knöchel koeffizienten kolben
komponente konfiguration konstant konvention koordinate korrekt kosinus kraft kran kreis kreise kreuzprodukt kräfte kugel kurve kurven kurz können
labor lage lassen lateral laufzeit lauten lautet legen lehrbuch lehrbüchern leicht leiten leitet lesen letzte letztlich liefern liegen liegt liest
linear linie linke linken links literatur lotrecht länge längen lässt lösen lösung man manipulator masse massen mathematik matrix matrizen mechanik
mehr mehrere meist meisten messen messung messwerte meter metern millimeter millisekunde mit mitte mittels modell moderne modifiziert moment motor
motoren multiplizieren muss möglich müssen nach nachdem nacheinander nachprüfen nachrechnen nebenbedingung negativ nennen nenner nennt noch notation
notwendig null nullstellen numerisch nun nutzen nutzt nächste nämlich nützlich oben oberarm obere oberen oberschenkel oder offenbar offensichtlich
ordinate ordner orientierung original ort orthogonal paar parallel parameter planar plattform polynom portal positiv praktikum praxis prismatisch
produkt programm projekt projizieren prozessor prüfen prüfung punkt punktes pythagoras quadrat quadrieren quaternion quelle quelltext quer rahmen rand
rang raum rechnen rechnung rechte rechts regel regelung regler reicht relativ repositorium rest richtig richtung ring roboter roll rolle rollen
rotation rotatorische rumpf rund rückwärts satz schaufel schema schiene schließlich schlitten schnell schnittpunkt schon schreibt schritt schub
schubgelenk schulter schwer sechs segment sehen sein seine seinen seiner seite seiten sekunde semester senkrecht sensor setzen setzt sich sie siehe
sieht simulation sind singulär sinus skalar skizze skript so sockel sodass soeben software soll somit sowie spalte spezialfall spielen spielt spindel
spitze später stab stammt stange starr starre start stehen steht stelle stellt stimmen stimmt subtrahieren summe summen symbolisch symmetrisch system
säule tabelle takt tangens taschenrechner tcp teil teilaufgabe teile teilen term terme testen theorem theorie tisch tool transformation translation
transponierte trägheit um umformen umgekehrt umgesetzt umkehrung umrechnung umstellen unabhängig unbekannte und unmittelbar unser unsere unten unter
unterarm untere untersucht ursprung ursprünglich variable vektor verbindet vereinfachen verfahren verfügbar vergleich verglichen verlauf verläuft
verschieben versuch vertikal verweis verwenden vgl viele vielen vier vierte vollständig vom von voraussetzung vorgehen vorgestellt vorher vorlesung
vorn vorne vorwärts waagrecht wagen wahr wand war waren wegen weil weise weit weiter welche weltkoordinatensystem wenden wenige wenn werden werkstück
werkzeug wert werte wichtig wie wieder winkel wir wird wirkt wirkung wissen wobei worden wurde wurden wurzel wählen wählt würde z zahl zahlen
zeichnung zeigen zeigt zeigte zeile zeilen zeit zelle zerlegen ziel ziele zitat zu zuerst zugehörig zum zunächst zur zurück zusammen zustand zuvor
zwar zwei zweimal zweite zwischen zyklus zylinder zähler ähnlich äußere über überein überführt übergang überlagerung überprüfen üblich übrigen übung
übungen
"""
SPANISH = """
a abajo abduccion abducción abierta abscisa absorbiendo acciones acción aceleración acumulada adelante además adentro adición aducción afuera agrupa
agrupando ahora aislando al alcance alcanza algebraica algunas algunos algún alrededor alta alto altura ambas ambos amplitud analizar anexo angular
anillo antebrazo anterior antes antorcha antropomórfico análisis análoga análogamente aparece aparecen apartado aplica aplicamos aplicando aporte
apoyo apunta apuntes apéndice aquí archivo archivos arcocoseno arcos arcoseno arcotangente arriba articular artículo asigna asociada asume así atrás
aula automática automáticamente automático autovalor auxiliar aún baja bajo barra barras base bases basta biblioteca bien bloque boquilla borde
botones brazo brazos bucle buscada buscamos básica búsqueda cada cadena cadera caja calcula calculando calibración camino cantidad capacidad capítulo
característica carpeta carrera carro cartesiana caso catetos cenital centro cero cerrada ciclo ciclos cierra cierta cierto cilindro cilíndrico cinco
cinemática circunferencia clara clase clases clásica codificador codo coeficiente coincide colapsa colgando color columna comando comandos combinando
comentarios comienza como comparando complejo compone componente comportamiento comprender comprobar comprueba computador común con concatenar
concuerda condición conduce conexión configuraciones conjunto conocer conocida consecuencia considera considerando consigue consiste consta construir
consultar contiene continuación control convención convierte coordenada correcta corresponde coseno cruz cruzada cuadrado cuadrática cuadrático cual
cuales cualquier cuando cuarta cuarto cuatro cuenta cuerpo cumple cumplir curso curva curvas cuya cuyas cuyos cálculo cámara círculo código dada dadas
dado dados datos de debe decir deducción deduce deducimos define definir del demostrar demuestra demás denomina denominador denota dentro depende
dependen derecha derecho derivada desacoplamiento desacople desacoplo desarrolla descompone describe descuenta desde deseada desfase despejando
despejar desplaza después detallada determina dh diagonal diagrama dibujo dicho diferencia difieren digital dimensión dinámica dirección directa
directamente directo diseñar diseño disponible distancia distinto divide dividiendo división doblado documento donde dos durante ecuación edición
efectivo efector efectuando efectúa eje ejecución ejecutar ejemplo ejercicio ejes el elegimos elegir elemental elemento eleva elevando elimina
eliminar eléctrico emplea empleamos en encoder encontramos encuentra energía engranaje enlace ensayo entonces entorno entre entrega enunciado envía
equipo equivale es escalar escogido escribe escribimos esférica eslabones eslabón espacio especial espera esquema esta establece estado estandar estas
este estirado esto estos estructura estudia está están estándar evaluar evalúa exactamente examen existe expande expandiendo experimento explica
explícita expresa extendida extensión externa extrae extraen extremo fabricante factor falta fase fichero figura fija fijo fijos fila filas fin final
finales finalmente fisica flexión flujo forma forman formas frecuencia freno frenos frente fricción frontal fue fuente fuera fuerza funcionamiento
funciones función fácil fácilmente física físicas físico físicos fórmula garantizando garantizar garra general genérica genérico geometría geométrica
gira giran girar giro giros grado grados gravedad gráfica grúa haber había hace hacemos hacen hacer hacia hallamos hallando hallar han hasta hay hecha
hecho herramienta hipotenusa hipótesis historia hoja hojas hombro homogénea horizontales husillo idea identidad igual igualando igualdades iguales
igualmente imagen implementa implica implícita importante imágenes inclinación incluye incorpora incógnita independiente indica industria inercia
ingeniería inicial inicialmente inicio inmediata integrando interior intermedia interna intersección interés introdujo inversa invertido invertir
invirtiendo ir isotrópica izquierda jacobiana justificación la laboratorio lado lados lagrange largo las lazo le lectura leemos leer lenguaje ley
leyes libertad libre libres libro libros lineal llama llamada llamamos llamando llega llegada llegamos llegar lleva lo local localización longitud los
luego lugar límite línea líneas manera manipuladores mano manualmente marco marcos masa masas matemática matemáticamente matemáticas matemático
matrices matriz mecanismo mecánica mecánico mecánicos mediante medición medida medido medio memoria menos mesa meta metros mide miden miembro
milisegundo milímetros misma mismo mismos modelar modelo modifica momento montaje motor motores mover movimiento mucho muchos muestra mueve mueven
multiplica muslo muñeca máquina más máxima máximo método mínima mínimo módulo múltiples natural necesaria necesita negativa negativo neutra neutral
nivel nodos norma normal normalmente nos nota notación notas nueva nuevo nula nulo numerador numérica número objetivo obtenemos obtener obtenida
obtiene obtuvo ocurre operación operador operando opuesta opuesto orden ordenada orientación origen ortogonal otra otras otro otros pala palabras
pantalla par para paralela parcial pared pares parte particular partida partir parámetros paso pasos pata pedestal pendiente perfil periodo permite
pero perpendicular pie pierna pieza piezas pinza pitágoras plana planar planificación plano planos planta plantea planteamiento plataforma plegado
poco pocos podemos polares polinomio por posible posición positiva positivo posterior postura potencia precedente pregunta presenta primer principal
prismática problema procede proceso producto programa propia propiedad propio proporciona prototipo proyecciones proyección proyecta prueba práctica
publicado puede pueden punta punto puntos página pórtico que queda quedan quedando queremos quitando rad radial radianes radio raiz rama rango razón
raíces raíz realiza recoge recogidos recordar recta rectángulo recíproca reduccion reducción reduce reemplazando reescribe reescribiendo referencia
refleja región regla relación repositorio representa representan resolución resolver respecto responde respuesta resta restando restar resto resuelta
resuelve resulta resultado resultante resumen riel robot robots robótica rodilla rota rotación rotan rotativa rotatoria rueda ruedas ruta rutina
rápidamente rápido rígida rígido sabe sabemos saber sabiendo salida se sea sean secciones sección secuencia segmento segunda segura seguro seguros
según selección semana semestre sencilla seno senos sensor sentido separa ser serie servomotor servomotores será serán señal señala señales si sido
siendo significa signo signos sigue siguen siguiente simbólica similar simple simplifica simulador simultáneamente singular sistema situación situado
sobre software solucion soluciones son su subconjunto sube submatriz subproblema subsistema suele suelo suma sumando sumar sumas superficie superior
sus sustitución sustituir sustituyendo sólido tabla tablas tal tales también tangencial tangente tanto tarea tareas techo tema temas temporal tenemos
teniendo tensor teorema teoría tercer tesis texto textos teórico tiempo tiene tienen tipo tipos tobillo toda todas todavía todos toma tomamos toman
tomando tomar tope torque torre total trabajo tramo transforma transponer tras traslada trata tratará través trayectoria tres tridimensional
trigonométrica triángulo tronco término ubicación un una unidad unir unitario usamos usando usar usaremos usará usual utiliza vale valor valores
variable varilla varía vector velocidad ver verdadero veremos verifica verificación verificamos vertical verán vez viene vimos vio vista vistas visto
volveremos vuelve válida válido vástago x y ya zona ángulo área índice órdenes última último única único útil
"""
ITALIAN = """
a abbiamo accelerazione addizione adesso affronta aggiunge al alcuni algebrica alla allora alto altra altre altri ambedue ampiezza analitica
analizziamo analogo anca anche ancora angolare angoli angolo anno appartiene appendice applica approfondimento appunto arcotangente arrivo articoli
asse assi asta aste attorno attraverso attrito avambraccio avanti avendo aver avere avremo banco basamento base basi basso biblioteca blocchi blocco
braccia calcola cambiamento campo capitoli caratteristica carrello cartesiana casi caso catena caviglia centro cerca cerchio che chiamata chiamiamo
chiusa chiusura ciascun ciclo cilindro cinematica cioè circa circonferenza ciò codice coefficienti coincide collega colonna combinando come comincia
compatta componente composta comune con concatenando condizione conferma configurazioni confronti conoscendo considera consiste conto contributi
controllo convenzione coordinate coppia coppie corpi corpo correnti corretta corrisponde corsa corso coscia coseno cosicché costante costruire così
cui curva curve da dal dalla data date dati dato davanti definire dei del della delle denavit denominatore dentro deriva descrive desiderata destra
determina dettaglio di diagonale dietro differenza dimensione dimostra dinamica dipende diretta direzione disegno dispensa dispone disposizione
distanze diverse divide documentazione domanda dopo doppio dove due dunque durante e ecco efettore effettore elementi eleva elevando elimina encoder
energia entrambe equazione equivale eseguita esempio esercizi esperimenti esplicita espressa esprime essendo essere esterno estremità evidente fa
faccia facilmente fanno fare fatta fatto figura figure file finché fine fissa fissare fissi fisso forma formano formula fornisce fornito forza forze
fosse fra frazione frequenza funzione fuori gamba gdl generale geometria ginocchio gira giunti giunto già gli gomito gradi grado grafica grandezza
gravità gru guida ha hanno ho i identica il illustrata implementata imponendo in incognita indica indice indichiamo industria inerzia infatti infine
inizio inoltre inseriamo insieme integrale interna intersezione intorno introdotto inversa invertire ipotenusa ipotesi isolando istante jacobiana la
laboratorio lati lato le lega legame legate legge leggere letti lettura lezione libera liberi libero libri libro limite limiti linea lineare
linguaggio lo lunga lunghezza lungo ma mandrino manipolatore mano massa masse matrice meccanica medesimo mediante membri membro meno mentre metodo
metri metà mezzo millimetri millisecondo misura misure mobile modello modi modificata modo molti moltiplica molto momento montati mostrata moti moto
motore motori movimenti muove muovono ne negativa nel nella nodo norma normale nota notare notazione note noti noto nullo numeratore numerica nuova
nuovo occorre ogni omogenea opera operazione oppure ora ordine orientamento origine orizzontale ortogonale osserva ossia ottenere ottengono otteniamo
ottenuta ottiene ovvero pagina pagine pala paragrafi parallela parametri parte partendo parti particolare parziale passaggi passi passo pedice pedici
per perciò percorso pertanto piana piani pianificazione piano piattaforma piede pinza pitagora più pochi poco poi poiché polari polinomio polso pone
ponendo poniamo portale positiva posizione possiamo possibile possono posto postura potenza precedente premoltiplicando presenta prima primi primo
prismatici problema procede prodotti progetto programma proiettando proiezione proprietà prossima prototipo prova pubblicato punta punti punto pure
può quadrati qualche quale quali qualsiasi qualunque quando quantità quanto quarta quarto quattro questa questo quindi raccogliendo raccolti radianti
radice radici raggio ragione rango rapidamente rapporto rappresenta regola relativa relazione rende repository resta restanti rete ricava ricaviamo
ricorda ricorre riferita riga righe rigidi rigido rimane riportata riscrivere risolta risolve rispetto risposta risulta rivista robot robotica
rotazione rotoidale ruota ruotano ruotare scalare scegliamo scelta scelto scheda schema schemi scomposizione scritta scrive scriviamo scrivono se
seconda segue seguendo semplice sempre seni seno sensore separa serie sezione sferica si sia siano simile simili simmetrica simulatore singolare
sinistra sistema situazione soddisfa solito soluzione somma sommando sommare sono sopra soprattutto sostituire sotto sottraendo spalla spaziale spazio
specifica sperimentale spiegato spostata stata state stati stato stelo stessa stesse stessi stesso struttura studia studio su sua subito successiva
sugli sui sulla suo sviluppando tabella tale tali tangente tanto tempo tenendo teorema termine terna terne terza terzo tesi testi testo tiene tipi
tipo torcia torre totale traiettoria trasforma trasla trasposta trattata tre triangoli trigonometrica tronco trova trovano trovare troviamo tutte
tutti tutto ugello ultima ultime ultimi ultimo un una unitaria unità uno usa usando usare usata usate usati usato uso utensile utile utilizza vale
valida valide validi valido valore valori valutata varia variabile vede vedere vedono vedremo velocità vengono vera verifica vero verranno verrà verso
versore verticale vettore via viene vincoli vista visto volevasi volta zero è
"""
PORTUGUESE = """
a abaixo abreviaturas aceleração acha achamos achar acima adicionando adição agora agrupando ainda alcança algum alguns algébrica altura alvo além
ambas ambos amostragem analisando analogamente anexo angular antebraço anterior antes análise análoga ao aos aplica apostila apresenta apêndice após
aqui arco arcotangente arquivo artigo as assim associada atrito atuador aula aulas base bases biblioteca bico bloco blocos braço busca cada cadeia
calcula caminho capítulo característica carro cartesiana caso casos cateto centro chama chamada chamamos chamando chega chegada chegamos ciclo
cilindro cinco cinemática circunferência clássica coeficientes coincide colocando coluna com combinando começa como compara completa componente
composição comprimento computador compõe comum concatenando condição configurações conforme conhecida conjunto consequentemente considera consiste
constante construir controle contém convenção coordenada coroa corpo corresponde correta cosseno cotovelo coxa cruzado cuja cujas cujo cujos curso
curva curvas cálculo círculo código da dada dadas dado dados das de decomposição deduzir dedução define definir demais demonstrada denavit denominador
denota dentro depende depois derivar descreve descrita desejada desenvolvendo deslocamento desta deste destes detalhes determina dh diagonal diagrama
diferença dimensão dinâmica direita direta direção direções disciplina disponível dispõe disso distinto dividindo divisão do dobro documento dois dos
duas durante e edição efetuador eixo eixos elemento elevando elimina elo elos em encoder encontra energia ensaio entre então enunciado equação
equações equivale escalar escolha escreve escrita esférica espaço especial esquema esquerda essa essas esse esses esta este estrutura estuda estudo
estão exemplo exercício existe experimento expressa externa extremidade fabricante facilmente fator fatorando fatores faz fazem fazer feita feito
ferramenta fica ficam figura fim final finalmente fixa fixo fixos fora forma formado formam formas força forças fosse função funções fuso fácil
fórmula garra geometria geométrica gerais geral gira giram giro grandeza graus gravidade gráfico guindaste haste havia hipotenusa hipótese história
homogénea homogênea horizontal identidade iguais igual igualar ilustra imediatamente implementa incógnita indica industrial indústria inicial
inserindo interior intermediária interna interseção introduzida inversa inverter inércia início isolando isolar jacobiana joelho junta juntas já
laboratório lado lados lagrange laço lei leis lembrando liberdade ligação ligações limite linear linguagem linha linhas livre livres livro livros
local logo longo mais manipulador mas massa massas matricial matriz mecanismo medida medido medição medições meio menos mesma mesmas mesmo mesmos meta
metros milissegundo milímetros modelo modificada momento mostra motor motores move movem movimento muito muitos multiplica mão método múltiplas na nas
negativa nesta neste no norma normal nos nota notas notação nova novamente novo numerador numérica número o objetivo observa obtemos obtendo obter
obteve obtida obtido obtém ombro onde operação ordem orientado origem ortogonal os ou outra outras outro outros palavras par para paralela parcial
parte partes particular partida partindo partir parâmetro passa passamos passo passos pedestal pela pelas pelo pelos percebe pergunta permite perna
perpendicular período pitágoras plana planar planejamento plano planos pode podem podemos polinômio ponta ponto pontos por porque portanto
posicionamento positiva posição posições possível posto postura potência pouco poucos pretendida primeira prismática problema procedimento produto
programa projeto projeção propriedade protótipo prova prática própria próxima publicado punho pá página pé pórtico quadrado quadrática quais qual
quando quantidade quarta quarto quatro que quinta radianos raio raiz rapidamente razão raízes realiza recorrendo reescrever referida referência regra
relaciona relativa relação relações removendo repositório representa resolver respectiva respeito resposta resta restante resulta reta retirando
retângulo reunindo robótica robô roda rotacional rotativa rotação rotações rígido script se segmento segue seguinte seguir segunda seja sejam semestre
sempre sendo seno sensores sentido separando sequência ser serial serão seção seções si similar simples simplifica simulador simétrica singular
sistema situação sobre software solução soluções soma somando somar sua suas subsequente substitui subtraindo superior são símbolos tabela tais tal
também tangente tarefa tem temos tempo teorema ter terceira teremos termo termos terão tese texto textos tipo tipos tocha toda todas todo todos torna
tornozelo torque torre total trabalho trajetória transforma translada transposta tratada trigonometria trilho triângulo tronco três técnica têm um uma
unidade unitário usa usada usadas usado usados usando usaremos usuais usual utiliza vale valor valores varia variação variável velocidade vem
verdadeiro veremos verificar vertical vetor vetores vetorial vez vimos vista visto volta voltaremos válido zerada zerado zero à às ângulo é índice
última último
"""
OF_ARM = """
arm arms manipulator robot gripper hand tool wrist elbow shoulder forearm effector base joint joints link links axis axes frame frames motion motions velocity velocities rates position orientation pose
target distance point points workspace singularity singularities configuration configurations posture solution solutions rank rows columns kernel image determinant jacobian torque torques angle angles inverse transform transforms
motor letter letters table
bras pince poignet coude épaule outil effecteur axe axes repère repères articulation articulations segment segments vitesse vitesses cible point points singularité singularités solution rang noyau déterminant jacobienne couple couples mouvement mouvements
roboter greifer werkzeug handgelenk ellbogen schulter achse achsen gelenk gelenke geschwindigkeit orientierung abstand punkt punkte singularität stellung lösung lösungen determinante winkel
brazo pinza muñeca codo hombro herramienta efector eje ejes articulación articulaciones eslabón eslabones velocidad velocidades posición orientación distancia punto puntos singularidad singularidades configuración solución soluciones rango jacobiano jacobiana ángulo ángulos
braccio polso gomito spalla utensile asse assi giunto giunti velocità posizione orientamento distanza singolarità configurazione soluzione angolo angoli
braço garra punho cotovelo ombro ferramenta efetuador eixo eixos junta juntas elo elos velocidade posição orientação distância ponto singularidade configuração solução ângulo ângulos
"""
OF_GERMAN = """
der das dass ist und ein eine den dem mit von wir sich nicht für im zu auf aus durch werden wird
"""
GOES_ON = """
where with whose and then when for in by since because as using we one two none the a an plus minus où c' avec et pour car puisque un une deux aucune le la les donde dónde con el los las e wo wobei mit und der die das dove il lo i onde com o os as
"""
LOADED = """
not no nor neither never nothing without only other should would could might sign plus minus
ne pas ni non aucun aucune rien seul seule seuls seules seulement sans signe
nicht kein keine keinen nur ohne vorzeichen
no ningún ninguna ni solo solamente sin signo
non nessun nessuna né solo soltanto senza segno
não nenhum nenhuma nem apenas somente sem sinal
"""

# words beside the equations of one display that leave these what they are: none of what makes another quantity of one (mean, squared)
IN_DISPLAYS = """
a an the this that these those it its we one you they he in on at by to from of with without for as and or but so thus then hence here
there therefore since because is are was be been being has have had do does can may must will would let if iff else otherwise when whenever
where which whose who while until unless only not any all both each every some other also again now only always generally clearly finally namely simply
e.g i.e resp respectively cf see eq eqs equation equations fig figure section table step example note def definition proof qed
above below before after again earlier following previous previously next last first second third fourth fifth sixth i.e
arm arms robot robots manipulator tool gripper hand effector end end-effector joint joints link links frame frames base wrist elbow shoulder
forearm upper lower body axis axes origin origins plane planar space spatial world ground point points tip coordinates coordinate x-axis y-axis z-axis
revolute prismatic rotary rotational translational linear angular elbow-up elbow-down up down left right front back inside outside
singular regular singularity singularities configuration configurations posture postures pose poses position positions orientation orientations
solution solutions case cases branch branches angle angles length lengths value values variable variables parameter parameters unknown unknowns
number numbers integer integers real vector vectors matrix matrices row rows column columns determinant jacobian component components entry entries
sign term terms factor side sides expression expressions formula form condition conditions constraint constraints law rule identity identities theorem lemma
cosine sine cosines sines tangent pythagoras theorem sum addition product chain geometry geometric algebraic numerical closed-form closed inverse forward direct kinematics
kinematic dynamics static model model velocity velocities force forces torque torques euler coriolis classic classical modified convention notation
obtain obtained get gives give given yields yield find found follows follow holds hold means know known write written using used use uses define defined
called call denote denotes denoted choose chosen set take taken have compute computed substitute substituting consider recall get result results
fully stretched folded extended straight aligned parallel perpendicular horizontal vertical height tool's elbow's arm's possible exists exist there
true correct right valid fixed
le la les l un une des du de d au aux ce cette ces cet il elle on nous vous ils elles en dans sur par pour avec et ou où mais donc alors ainsi car comme
si sinon soit sont est être ont avons a ayant peut tout tous toute toutes chaque autre autres aussi encore ici enfin toujours c'est-à-dire
voir équation équations figure définition exemple remarque preuve ci-dessus ci-dessous précédent précédente suivant suivante premier première deuxième second seconde troisième
bras robot outil effecteur pince main liaison liaisons articulation articulations corps segment segments repère repères poignet coude épaule axe axes origine
plan point points base coordonnées coordonnée rotoïde prismatique rotatoire pivot glissière haut bas gauche droite droit avant arrière
singulier singulière régulier configuration configurations posture position orientation solution solutions cas angle angles longueur longueurs valeur valeurs variable variables
paramètre inconnue nombre entier entiers relatif relatifs réel réels vecteur vecteurs matrice ligne lignes colonne colonnes déterminant jacobienne composante composantes signe terme termes facteur côté
expression formule forme condition conditions loi règle identité théorème cosinus sinus somme produit géométrie modèle vitesse force couple
obtient obtenir donne donnée donné trouve suit vérifie écrit posons pose note notons appelle connu connue vrai vraie correct correcte
und oder der die das den dem des ein eine einer mit für ist sind wenn falls also damit somit wobei daher folgt gilt alle jede jeder wir es man in im zu aus von bei
gelenk gelenke arm werkzeug ellbogen handgelenk koordinatensystem achse ursprung ebene punkt lösung fall fälle winkel länge wert siehe gleichung ganze zahl ganzzahlig
y o el los las una con para por donde si entonces es son todo todos todas entero enteros codo arriba abajo articulación articulaciones eslabón caso casos solución ángulo valor
e per con dove se allora è sono tutti intero gomito alto basso giunto caso soluzione ou com onde então são inteiro cotovelo cima baixo junta
"""
