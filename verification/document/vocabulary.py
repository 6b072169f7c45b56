"""The words of robot-arm courses, in which equations are led to and spoken of: a sentence of others may say anything.

They are those that two or more of some 170 public documents on arms have beside their displays, and what goes with them, without
the words that deny, doubt, judge or tell of people. An English word of seven letters or more stands for all
that begin with the same seven, one of another language for those that begin with the same six.

`OF_GERMAN` are of a sentence in which nouns begin with capitals, `OF_ARM` those of which a sentence is that says something of the arm and not of the display, `GOES_ON` begin what goes on from
a display, and `LOADED` are those that a sentence of the display may deny it by, and others have often.
"""

ENGLISH = """
abbreviate ability able about above abscissa absolute accelerate accompanying according account accuracy achievable achieve achieving across acrylic
act acting action actions activates active activity actor acts actual actually actuated actuation actuator adaptive add added adding addition additive
adds adjacent adjoint adjugate adjust admissible advance advantage affect affine aforementioned after afternoon afterwards again against agenda agree
agrees ahead algebra algorithm align aligned all allow allowing allows alone along alpha already also alternate although altogether always among
amount amounts amplified amplify an analogous analogue analysis analytic analyze analyzing anchor and angles angular animation anisotropy ankle ankles
annotations announced annulus another answer anthropomorphic anticlockwise any anyway apart app appear appears appendix applet applications applied
applies apply applying approach appropriate approximately arbitrary architecture arcs arctan arctangent arduino are area aren argument arise arises
arising arithmetic arms around array arrive arrow articulated as asks aspects assembly assign assignment assigns assistant associated assume assumed
assumes assuming assumption asymptotic at atan attached attachment attainable auditorium augmented automatically autonomous auxiliary available
average avoid avoidance away axis back background backlash backward balance ball bar based basic basically basis battery be beam because become
becomes been before beforehand begin behave behavior behind being believe belongs below belt bench bend bending bends between beyond bibliography
bicep big bigger bin bins biomechanical bisector bit black blackboard block blocks blue bodies body bolt bolted bonus book books boom borrow both
bottom bound boundary bounded bounding bounds box boxes brackets brakes braking branch branches break breaks brevity briefly bring bringing browse
browser bucket building builds built but button by cable cables calculate calculus calibrate call called calls camera cameras campus can cancel
cancellation candidate cannot canonical capture carefully carriage carries carry cart cartesian cascade case cases cauchy causes ceiling center
centered centers centimetres central centre centrifugal centripetal certain chain chaining chains chalk chalkboard change changes changing channel
chapter characterized chart check checked checking checks choice cholesky choose choosing chosen circle circles circular claim clarity classes classic
classify classroom claw clear clearly click clip clock clockwise close closed closes closure cm code coefficient cofactor coincide col collaborative
collecting college collision collocation colored coloring colors colour coloured column columns columnwise combination combine combining come comes
command common commonly communicates compact companion compare comparing compatible compensating compiled complete complex component compose composite
compound computation compute computing concatenate concept concisely conclude conclusion concrete condition cone cones confirm conjugate connect
consecutive consequence conservation consider consist console constant constraint construct consult contact contain contents context continues
contrast contributes control convenient converge conversely convert convex convexity conveyor coordinated core coriolis cornerstone corollary correct
corresponds cos cosine cosines cost counterclockwise counting coupled course courses courseware covariance covers craig crane crank create created
creates creating creation critically cross crosses crucial cubic cubing cumulative current curvature curve curved curves custom cycle cycles cylinder
cylindrical damped damping dark dashed dataset deadline decay deceleration december decide decides decision decomposing decreases deficient defined
defines defining definite deformation degenerate degree degrees delta demo demonstrate denavit denominator denote denoted denotes denoting dense
density depend dependent depending depends depicted derivation derive derived deriving descent describe description design designate designed
designing desirable desire desired desk desktop det detail detailed details detect detection determine developed deviation device dexterity diagonal
diagram diary did different difficulty dimension directions directly disc discrete discriminant discuss displacement display distal distribution
diverges divide dividing division docs document does dof dofs dog doing domain done dot dots dotted double down download downward draw drawing drawn
draws drill drilling drive driven drives driving drone drones drop dropped drops dual duality duration during dynamic e-mail each earlier easier
easiest easily easy edge edges edition educational effect effective effector effects efficient effort efforts eigen eigenvalue eigenvector eight
either elastic elbow elbows electric elegant element elevator eliminate ellipsoid elsewhere email emails embed embedded embedding emphasizes employed
enables enabling encode encoded encoder encodes encompassed end endpoint ends energy enforce enforcing engine engineering enough ensure ensures
ensuring enter entire entirely entries entry entrywise environment environments eq eqn eqs equal equality equals equate equated equating equation
equilibrium equivalent erase especially essential establish estimation etc euclidean euler evaluate even evening eventually every everything
everywhere exact exactly example excavator execute exercise exerted exist existence existing exists expand expanded expanding expansion expect
expected experiment explain explicit exploration explore exponential express extend extended extends extension external extra extract extremely face
faces fact factor factoring factors factory facts familiar families family famous far farther fashion fast faster fastest feasible feature february
feed feedback femur fetch few field fields fifth fig figure figures file files fill filled filter filtering finally find finding finds finger finger's
fingers finish finished finite firmly firmware first fitting five fix fixed fixes fk flange flat flexible flipped flipping floating floor flow focus
focused fold folded folder folding folds follow followed following follows foot for force forced forces forearm form formal formalism formally format
formed former forming forms formulae forth forum forward found foundation four fourth fraction frame frames framework free freedom frequency fresh
friction friday friendly frobenius from front full fully function fundamental further future gain gait gamma gantry gaps gazebo gear gearbox general
generate generic gently geometry get gets gimbal github give given gives giving gladly glance global glossary go goal goals goes going good governed
grabbing gradient graph graphed graphical grasp gravitational gravity greater green grid gripper gripping ground group grouping grow grows guarantees
had half halfway hall hand handed handle handling handout handwritten handy hang hangs happens harder hardest hardware hartenberg has have having
header headers heading heads heart heavier heel height hello helper helpful hence here herein hertz hexapod high higher highlight highly hinge hint
hip hips historically history hobby hold holds hollow holonomic home homepage homework homogenous hope horizontal host hour hours how however humanoid
hybrid hypotenuse hypothesis icon ideal identical identify identity if iff ik ill-conditioned illustrate image images imaginary imagine immediately
impedance implement implies implying important in incidentally include including incorporate incremental indeed independent index indicate indirectly
individual induced industrial inequality inertia infinity influence information initial inner input inputs insert inserted inserting inside insight
inspecting inspired install instance instant instead integer integral intelligent interactive interested interface interior intermediate internal
interpolate interpret interrupt intersect interval into introduce intuitive invariant inverse inversion invert inverted inverting inverts invite
invited invoking involves is isolate isolating isotropic it iteration ith its itself jacobian january jerk jib jog jogging join joined joint joints
jordan joystick jth julia july june just keep keeping keeps kept kernel key keyboard keys kindly kinematic kinetic kit kitchen knee knees know knowing
knowledge known kutta lab label labeled labels laboratory lagrange language laplace laplacian laptop large larger largest last lastly lately later
laterally latter law laws layout lead leading leads learn learned learning learnt least lecture led left left-handed leg legged legible legs leibniz
lemma length lengthen lengths lengthy lens less lesson lessons let lets letters level lever leverage libraries library lidar lie lies life lift
lifting lifts lighter lightweight like likewise limit limited limits line linearise linearly lines link linkage links list listed listing lists
literally little live lives living load loaded local locally located location lock log logarithm logic long longer longest look looking looks loop
loops loosely lower lowering lowers lunch lyapunov machine machines made magnetic magnitude main mainly maintaining make makes making manifold
manipulate manual manually manufacturing many map mapping maps markers mass masses massive massless mast master match matches matching materials math
mathematica matlab matplotlib matter matters maximal maximise maximize maximum may mean meaning means meant meanwhile measure mechanism meet meets
memorise memorize meshes meter meters method methods metre metres metric metrics microcontroller middle millimetres milling millisecond minimal
minimise minimize minimum minor minors minus minute minutes mirror mirrors mm mobile mobility mode model modeled modeling models modes modest modified
modify modular module modules modulo moment moments momentum monday month months moore more moreover morning most motion motions motor motors mounted
mounting mouse move moveit movements moves moving mth much multi multiple muscle muscles must mutually name named namely names natural nature navigate
navigation near neatly necessary need needed needs negated negative neglect neighborhood neither net neural new newton next nicely nine node noise non
nonconvex none nonlinear nonsingular nontrivial nonzero norm normal normalise norms note notebook notes notice noting notion notions november now
nozzle null number numbers numerator numeric numpy object objective objects observation observe observing obstacles obtain obtained obtaining obtains
obviously occur occurs october of off offers office offset offsets often older oldest onboard once one online onto open opens operate operates
operation operator opposite optimal optimise optimized optional or orange order ordered ordinate orientations oriented origin original origins
orthogonal oscillates our out outer outline outlook output outputs outside outwards over overall overshoot overview own pace paced packages packing
page pages paint painting pair pairs pallet palletizing panel panning paper papers paragraph parallel parameter part partial particle particular
partition parts pass passed passing passive passivity paste path paths pattern pay payload pdf peak peaks pedestal peek pen pencil pencils pendulum
penrose perfectly perform period periodic periods perpendicular perspective perturbations pfaffian phase phi phone physical pi pick picking picks
pictured piece pieces pieper pin pinned pipeline pitch pitching pivoting place places plainly planar plane planes planned planning plate plates
platform play played playing plays please plot plots plotted plotting plug plugged plugging plus pocket podcast point pointing polar polar-coordinate
polynomial poor popular portion portrait posed poses positional positive possibility possible post poster postmultiply postures potential power
powered powerful powers practice pre preceding precise precision predict prefer preferable preferred premultiply preparation prepare preparing
prescribed present preserves press prevent previous primary principal print printed printer prints prism prismatic problem procedure proceeds process
produce product profile program project promised proof propagate proper properly property proportional proposition prototype prove proved provide
providing proximal proximity pseudo pseudoinverse published pulling pulls puma punch pure purely purposes push pushes pushing put puts putting
pythagoras python quadrant quadratic quadruped quantities quarter quasi quaternion query question quick quickly quintic quiz quizzes quote quoted
quotient rack radial radially radians radii radius rail raise raises ram random range ranges rank rate rates ratio rational re reach reachable reached
reaches reaching reactions read readability readable reader readers readily reading readme ready real realistic realizing rearrange reason reasonable
recall recalled recalling recalls recap recent recitation recognise recommended record recorded recording records recover rectangular recursion reduce
reducer reduces redundant refer reference referred refers refine reflects refresh regardless region regions registered regrouping regular rehearse
relabeling relate related relates relating relationship relative relevant remain remainder remaining remains remark remember reminder remotely remove
removed removes removing render rendered rendering repeat repeated repeats replace replay report repository represent reprinted reproduced require
requiring research reserve reset resistance resolution resolving respect responsiveness rest restrict result resultant resulting results retracting
retrieve return returned returning returns reveal review revisit revolute rewrite rewriting rewritten rhs right right-handed rigid rigidly rigorous
ring robot's robotic robots robust robustness rodrigues role roles roll rolling room root roots rotary rotate rotated rotates rotating rotational roto
rototranslation roughly round routine rover row row-wise rows rpy rule ruler run runge running runs rviz rx sac safety same sampled sampling sandbox
satisfied satisfy saturday save saved saw say scalar scale scaled scaling scan scara scenario scene schedule schematic school schur schwarz science
scipy scratch screen screw screws script scripts scroll seat sec second secondly seconds section see seek seen select selecting selects self semester
semi seminar send sends sense sensed sensing sensitive sensor sensors sent separate september sequence sequentially serial series serves servo
servo-driven servomotors servos session set sets setting settle settled settling setup seven several severity shade shall shank shape shapes share
shared sheet sheets shelf shifts shin shop short shortcut shorten shorter shortest shorthand shoulder show showed showing shown shows side sides
signal signed similar simple simpler simplest simplicity simplified simply simulated simulink simultaneous sin since sine sines single singular sit
sits situation sixth size skeleton sketch sketched skew skim slice slide slider sliders slides slope slow slowest slowly small smaller smallest smooth
smoother smoothly smoothness smooths snippet so soft software solid solve solved solver solvers solves solving some somewhat somewhere soon
sophisticated sort sorted source sources space spaced spaces span sparse spatial speak speaks special specific specify spectral speed speeds spelled
spend spent sphere spheres spherical spider spin spindle spinning spline splitting spoon spray spreadsheet spring square squared squares squaring
stability stable stack stacking stage stages stand standard standing stands start started starting starts state stated statement states static statics
station stay steering step stepper steps stewart stick stiffness still stop stops store stored stores straight strategy stress stretch strictly strong
strongly structural studied studies study studying sub subject submatrix subscript subsection subsequent subset subspace substitute subtract success
such suitable sum summarize summary summation summed summer summing sums sunday superscript supported suppose supposing sure surely surface sweep
sweeping sweeps swept swing swinging swings switch switched swivelling syllabus symbolic symbols symmetry sympy system systems table tables tablet
tabular take taken takes taking tall tangent tap target targets task tasks taylor tcp tea technically techniques technology tedious telescoping ten
tends tensor term term-by-term terms test text textbook th than thank thanks that the their them then theorem theoretical theory there thereafter
thereby therefore therein thereof these thesis theta they thigh thing things third thirdly this thoroughly those though three three-dimensional
threshold thrice through thumb thursday thus tibia ticket tidy tilting time timer times timetable timing tip to today toe together tolerances tomorrow
tonight too tool toolbox tools top topic topics topology torch torque torques torso total touch toward towards toy trace traced traces tracing track
tracked tracking tracks traditional train training trajectory transcendental transcription transfer transform transition translate transmitted
transpose trapezoid traslation traveled traveling tray treat treated treatment treats tree triangular trick trig trigonometry trivial true truly trunk
tuesday turn turned turning turns turret tutor tutorial twelve twice twist twists two two-dimensional type typed types typical typing ultimate
unattainable unchanged under underlying understand unfold uniform unique uniquely unit units universal unknown unreachable unroll unstable until up
update updated updates uploaded upon upper upward upwards urdf us usage use used useful usefully user uses using usual usually vacation valid value
values vanish vanishes variable variance variation varies variety various vary varying vast vectors vehicle vehicles velocity verification verified
verify version vertical very via vice video videos view virtual viscous visible visibly vision visit visited visual visualize visually voltage volume
waist wait waiting walk walker walking walkthrough wall wall-mounted want warehouse warm warm-up was watch watching way waypoint ways we web wednesday
week weekly weeks weight weighted weighting weights welcome welded welding well were what wheel wheeled wheels when whence whenever where whereas
wherein wherever which while white whiteboard whole whom whose why wide widely width will window winter with within wonder word words work workflow
workpiece works worksheet workshop workspace workstation world worth wrap wrapped wrench wrenches wrist write writes writing written wrt xy try tries corridor mail asked something spoil spoils yaw yawing
yellow yesterday yet yield yielding yields yoshikawa you young your zero zeros zoom zyx zyz
"""
FRENCH = """
a abonner abord abordé aboutissons abrégée abréviation abscisse absolue accorde accueil accélère accélération achève acquérir actionneur actionneurs
activité actualité addition adjointe affecte affichage agenda agréable ai aide ailleurs ainsi aisée aisément ait ajout ajoutant ajoute algébriquement
alignement aligné aller allongement allons alors altitude amortis amphi amphithéâtre amène analogie analyse angle angles angulaire animation annexe
annoncé annule antisymétrique apparaître appareil appel appelant appelle appelons appelée application applique apport apprendre approche appui après
après-midi arc arrivons arrivée arrière arrête article articulaire arête asservir atelier atteignable atteignables atteindre attention au au-dehors
au-delà au-dessous auparavant aura auront aussi autant automne autonomie autour autre autrement autres aux avance avant avant-bras avec avoir avons
avril axe axes baissent banc barre barres bas base basse beaucoup besoin bibliothèque bien bientôt bienvenue bleu bloc blocs bon bonjour bonne bonnes
bons bord bords borne bornent boucle bouge bougent bouger boule bout bouts bras brièvement broche brève bureau buse butée butées bâti cahier calcul
calendrier caméra canonique capteur car caractérise carnet carré carrée carrés carte cartésien cas cauchy cause ce ceci cela celle celles celui
centimètre cercle ces cet cette ceux chacun changement chapitre chaque charge chargé chariot chaîne chemin cherche cheville chiffres choisit choix
chose chronologie chuter ci ci-dessus cible cibles cinq cinquième cinématique classique clavier cliquer code codeur coefficient cofacteurs cohérente
colinéaire coller colonne comatrice combien commande comme commence commode commune comparaison complète complément composante comprendre compte
comptée concourant concret conditionnement conduit configuration confirment confondus connaissant connaît connu connue connus consacré considère
consigne constitue constructeur consulter conséquence contenu contient continuons contribution convention conviennent convoyeur coordonnée copier
coplanaire cordialement corps correct correspond cosinus cote coude coudes coulisse coupent couple couramment courant courbe couronne courriel cours
court courte courts coïncide coûtent craie crayon crochet croissent croît croître création cuisse cursus câble câbles côte côté côtés d d'où dans
davantage de degré degrés demain demande demi-tour depuis dernier dernière derrière des descend dessin dessus deux deuxième devant devient devoir
dextérité deçà di diagonale diaporama diapositive diffèrent différence dimanche dimension dire direct dirigé discutez dispose disque distance
distribué dit divisant divise division documents doigt doigts doit donc donne donnent donnez donné donnée dont dorénavant dos dossier doucement douze
droit droite droits du durant durer durée dynamique débattement début débute décalage décembre décide découle découplage découvrir décrit déduire
déduisons déduit défini déjà démarche démarrer démonstration démontrer dénominateur départ dépasse dépend déplace déplié déport dépôt dérivant dérivez
dérivée désigne désormais détaillé déterminer développant effecteur effet elle elles ellipse embase empattement empilant emploi employer en encore
endroit enfin engrenage enregistrer enseigne ensemble ensuite entier entière entraîner entre entre-temps enveloppe envoyer espace espérons essai
essais est est-à-dire et euler exact exacte examen excentricité exemple exercice existe explique exposant expression exprime expérience extrémité
extérieur facile facteur factorisant faculté faire faisant fait faite faites faits familier famille faut façon façons ferme feuille fiche fiches
fichier figure filmé fin finalement fixe flèches fois fonction font force forces forcée forcément forme forment formes formule fort forum foulée
fourche fourni frein freins frontière frottement férié février gagne gagnent gardons gauche genou glisse glissière godet gomme graduellement grand
grande graphe graphie gravitation groupement grue grâce général géométrie habituel hanche haut haute hautes hauteur heure heures heureusement hier
histoire historiquement hiver homogène horizontalement hors huit hypothèse hypoténuse ici identifiant idée idées il ils image immobile immédiatement
impair implantée implémenté important imprime inchangée inclinaison inconnues incrémental indication indice indique indispensable industriel
indépendamment inertie inférieur injectant inscrire installer instant interne interprétation interviennent intitulé introduire intuition intègre
intégrant intéressant intérieur inverse isolant jacobienne jambe jambes janvier jeu jeudi joint joue joule jour journée jours juillet juin jusqu juste
kilogramme l la laboratoire lacet lagrange laissant laisse langage langue laquelle large laser le lecteur lectrice lecture lemme lendemain lente
lentement lentes lequel les lesquelles lettre leur leurs leçon liaison liberté libre libres lien liens lieu ligne lignes limite limités linéaire lire
lisent lisons liste lit livre livres lié logiciel loi loin longs longue lors lorsqu lourd lourde lue lui lui-même lundi lus là là-bas léger légère
machine mai maintenant maintient mais majuscule manifestement manipulabilité manière manuel mardi marque mars masse masses matin matinée matlab
matrice matériel membre mentionner merci mercredi message mesure mesurés mettent mettre mi-parcours midi mieux milieu millimètre milliseconde mince
mineurs minuscules minute mise mobilité modèle modélisation moindres moins mois moitié monte montre montrons moodle mot moteur motif motivation mots
mouvement moyen multipliant mutuellement mât mène mènent mètre mètres mécanisme méthode même mêmes n naturel neuf newton nom nombre nommant nomme
nommer nommé nommée noms normale norme normes nos notamment notation note noter notons notre noté notée notées notés nous nouveau nouvel novembre
noyau nul nulle nulles nuls numérateur numériquement nécessaire négatif négligé nôtre nôtres objectif objet obtenir obtenons obtention obtenu
obtiendra octobre on ont opposée opérateur oral orange ordinaire ordonnée ordre organe orientation origine orthogonale orthonormé ou oublier outil
outils ouverte ouvrage ouvrez ouvrir où page pages paire panneau par par-dessus paragraphe parallèle paramètre paramétrage parcourt pareillement
parent parfois parler parlons partager partent partie partir partout parvenons parvient passage passant passe passent passer passons patience patte
pattes pause peinture pelle penche pend pendant perd perdent perdu perdue permet perpendiculaire perçage pesanteur petit petite peut peuvent photo
physiquement pied pilotage piloter pince pinces pivot pivote pivots pièce pièces place placent placez plan planaire plane planification planning plans
plateau plaçons plein plie plié plupart plus plusieurs poids poignet point pointe points polaire polycopié polynôme porte porteur portique porté
portée posant pose poser position posons possède posture posé posée pour pourra pourrons poursuivons pourtant pousse poutre pouvez pouvons premier
première prend prendre prenons preuve primes pris prismatique processeur prochain proche procédure produit programmation projection projet propre
propriété prototype prouver près précis précède précédent prédiction prédire prédisez préférée préhenseur prémisse préparer présente publié puis
puisqu python pédagogique période pôles qu quand quart quatre quatrième que quel quelconque quelle quelquefois quels question qui quinzaine quitte
quoi quotidien quotient raccourci racine radian raison ramener rang rapide rappel rapport rarement rassemble rayon rayons reconnaît recule redondance
regarder regroupant rejoignent relation remarquable remercier remise remontant remplace remplies rencontre rend rendent rendez-vous rentrée replier
replié reportant repos repose reprend représente repère respectifs ressource restant reste restent rester retenir retenons retenue retourné retranchez
retrouve revanche revenons revient rigide robot robotique rotation rotatoire rotoïde rotule roulis rubrique règle règles réalisé récapitulatif
récemment réciproque récréation récurrence réducteur réduire réduite réel réflexion référence région réglage régler réglée régulateur répond réponse
répète répétabilité réserver résolution résolvant résoudre résout résultat résumé réuni réunissent rôle s s'écrit sa sait salle samedi satisfont saute
sautent savoir scalaire schéma scolaire se seconde secteur section segment selon semaine semblable semestre sens septembre septième sera seront sert
servent servira servomoteur servomoteurs ses session seul seule si signe signification similaire simple simplification simulateur singularité sinus
six sixième socle soient soigneusement soir soit solide solution sommaire sommant somme sommes sommet son sont sort sorte sortie sortir soudain
soudure souhaite souris sous soustraction souvent spatiale sphère sphérique statique strictement structure stylo substituant successivement suffisant
suffit suit suite suivant suivent suivre support supposant supérieur sur surface surligner surtout symbole symétrique système séance sécants sépare
série t-elle t-il table tableau tablette tableur taille tandis tangage tangente tant tantôt tard tchat technique tel telle tels temporel temps tendu
tenu terme termes terminal testez texte thèse théorème tient tige tiges tire tirer titre tombe torche torse torseur torseurs torsion total totale
toujours tour tournant tourne tournons tourné tours tous tout toute toutes tracé tracée traité trajectoire transformation translation transposer
travail travaux travers triangle trigonométrique trimestre trièdre trois troisième tronc trop trouve trouvons trouvée tutorat tâche tâches
télescopique télécharger téléphone tôt ultérieure un une unicité unitaire unité unités université usine usuel usuelle utile utilise va vacances vaille
valable valent valeur valoir variable varie vaut vecteur vectoriel veille vendredi ventouse verra verrons vers vert verte verticalement vides vidéo
viennent vient virtuel visible visionner visite vissage vite vitesse voici voilà voir voit volontiers volume vont voyage vrai vraie vu vue
vérification vérin vérins week-end y zone zéro à à-dire écart écarts échange échantillonnage échéance écoute écran écrire écrit écriture écrivez
écrivons édition égal égalant égale également égaler égales égalité égaux élevant élever éliminant élongation élément élévation énergie énoncent
énoncé épais épaule équation équivaut établi était étant étape étapes étend étendre étendu étroit étude étudie étudié été évaluation évaluer évident
être
"""
GERMAN = """
hierhin bislang dorthin genauso ab abbildung abend abends aber abgabetermin abgeleitet abgeschlossen ablauf ableiten ablesen absatz abschließen abschnitt absolut abstand abszisse
absätze abtastung achse achsen addieren addition agenda aktualisiert aktuell alle allem allen aller alles allgemein allmählich als also am an analog
andere anfang angegeben angenehm angenommen angewendet anhalten anhand anhang ankündigung anleitung anmelden annahme annehmen anordnung ansatz
anschauen anschließend ansehen anteil antrieb antwort anwenden april arbeit arccos archiv arctan arkustangens arm armes artikel auch auf aufbau
aufgabe aufgelöst aufgestellt auflösen aufmerksam aufnahme aufschreiben aufstellen aufzeichnung august aus ausblick ausdruck ausführlich ausgangspunkt
ausgeben ausgedrückt ausgewertet ausklammern auslesen ausmultiplizieren ausprobieren auswerten auswirkung auswählen außen bahn bahnen band basiert
basis basiskoordinatensystem basissystem bauform beantworten bearbeiten bedeutet bedingung beenden befehl befinden beginn begrüßung behandeln
behauptung bei beiblatt beide beiden beider bein beispiel beitrag beiträge bekannt bekommt beliebig bemerkung benutzen benötigen berechnen bereit
berücksichtigt beschleunigung beschreibt besitzt besonders besprechen besteht bestimmen bestätigt besuchen betrachte betrag betreuer bewegen bewegt
bewegung beweis bewiesen bezeichnen bezogen bezug bezüglich bibliothek bild bilden bilder bildet bildschirm bis bitte blatt bleibt bleistift boden
bogenmaß brauchen bremse brenner buch bzw bücher code computer cosinus dabei dafür dagegen daher damit danach dank danke dann daran darauf daraus darf
dargestellt darin darstellung das dass datei dateien daten datenblatt datum dauer dauert davon dazu decke definiert dem demnach demnächst den denavit
denken denn denselben der derart deren derselbe des deshalb dessen detail determinante dezember dh diagonal die dienstag dies diese dieselbe dieser
dieses differenz dimension direkt dividieren dokument donnerstag drehachse drehgelenk drehmatrix drehmoment drehung drehwinkel drei dreieck dritte
drucken durch durchführen dynamik düse eben ebenda ebene ebenen ebenfalls ebenso echtzeit eigenschaft ein eindeutig eine einem einen einer eines
einfach einfluss eingabe eingeben eingesetzt einheit einige einleitung einmal einsetzen eintrag einträge einzelne elemente ellbogen empfehlen encoder
ende endeffektor endlich endpunkt energie entfernen enthält entlang entnehmen entnommen entsprechend entsteht erfahren erfolgt erfüllt ergab ergaben
ergeben ergebnis ergibt erhalten erhält erinnerung erklären erläutern ermitteln erreichbar erste ersten erster erstes erweitert erwähnt erzeugen es
etwa exkurs experiment explizit fahre fahren faktor fall februar feierabend ferien fertig fest feste festen figur finden findet flansch fläche folge
folgen folglich folgt folie folien form formel fortsetzen frage fragen frei freie freien freiheit freitag freiwillig freuen früh früher frühjahr
funktion fuß führt fünf für ganze geben gegeben gegenüber gehabt geht gehört gelegenheit gelenk gelten gemeinsam gemessen gemäß genannt genau genügen
genügt geometrie geprüft gerade gern gerne gerundet gesamt geschafft geschlossene geschrieben geschwindigkeit gespannt gespeichert gestell gestern
gestreckt gesucht getriebe gewicht gewählt gezeigt gibt gilt gleich glied glieder grad grafik greifer greift grundlage gruppenarbeit größe größen
größer gültig haben halb halten hand handgelenk handout hat hatte hatten hausaufgabe heft hefte heißt herbst hergeleitet herleiten hersteller
herunterladen heute hier hieran hieraus hierbei hierfür hierzu hilfe hilfreich hinten hinweis hinzu hoffen homogene horizontal hub hängen hängt höhe
hörsaal hüfte idee ihr ihre ihren ihrer ihres im immer implementiert in indirekt industrie info ingenieur inhalt innen insbesondere insgesamt
installieren interessant inverse invertieren isolieren ist jacobi januar jede jedem jeden jeder jedes jetzt jeweils juli juni kabel
kalender kamera kann kapitel kartesisch keine kennen kette kilogramm kinematik kinetisch klassisch klicken knie knöchel koeffizienten kolben
komponente konfiguration konstant konvention koordinate kopieren korrekt kosinus kraft kran kreide kreis kreise kreuzprodukt kräfte kugel kurs kurse
kurve kurven kurz können labor labortermin lage langsam laptop lassen lateral laufzeit lauten lautet legen lehrbuch lehrbüchern lehre lehrstuhl leicht
leiten leitet lernen lernziel lesen letzte letztlich liefern liegen liegt liest lineal linear linie link linke linken links liste literatur lotrecht
länge längen lässt lösen lösung mai man manipulator mappe markieren masse massen material mathematik matrix matrizen mechanik mehr mehrere meist
meisten messen messung messwerte meter metern millimeter millisekunde minute mit mittag mitte mittels mittwoch modell moderne modifiziert modul moment
monat monate montag morgen motivation motor motoren multiplizieren muss märz möglich mündlich müssen nach nachdem nacheinander nachlesen nachmittag
nachprüfen nachrechnen nachschlagen nacht nachweis neben nebenbedingung negativ nennen nenner nennt neu neue neuen noch nochmal notation notwendig
november null nullstellen numerisch nun nutzen nutzt nächste nämlich nützlich oben oberarm obere oberen oberschenkel oder offen offenbar
offensichtlich ohnehin oktober online ordinate ordnen ordner orientierung original ort orthogonal ostern paar parallel parameter pause plan planar
planen plattform polynom portal positiv praktikum praxis prismatisch probieren produkt programm projekt projizieren protokoll prozessor präsentation
prüfen prüfung punkt punktes pythagoras pünktlich quadrat quadrieren quaternion quelle quelltext quer quiz radiergummi rahmen rand rang raum rechnen
rechnung rechte rechts regel regelmäßig regelung regler reicht relativ repositorium rest richtig richtung ring roboter roll rolle rollen rotation
rotatorische ruhig rumpf rund rückblick rückmeldung rückwärts sammeln samstag satz schauen schaufel schema schicken schiene schlagwort schließlich
schlitten schnell schnittpunkt schon schreibt schritt schub schubgelenk schule schulter schwer schön sechs segment sehen sein seine seinen seiner
seite seiten sekunde selbst semester seminar senkrecht sensor september setzen setzt sich sie siehe sieht simulation simulieren sind singulär sinus
sitzung skalar skizze skript so sockel sodass soeben software soll somit sommer sonntag sowie spalte spannend spaß speichern spezialfall spielen
spielt spindel spitze sprechen später stab stammt stange starr starre start starten stehen steht stelle stellt stichwort stift stimmen stimmt studium
stunde subtrahieren suchen summe summen symbolisch symmetrisch system säule tabelle tafel tag tage tagesordnung takt tangens taschenrechner tastatur
taste tcp teil teilaufgabe teile teilen teilnehmer term terme termin testen thema themen theorem theorie tipp tipps tisch titel tool transformation
translation transponierte treffen trägheit tutorium uhr um umblättern umformen umgekehrt umgesetzt umkehrung umrechnung umstellen unabhängig
unbekannte und universität unmittelbar unser unsere unten unter unterarm untere unterlagen unterricht untersucht urlaub ursprung ursprünglich variable
vektor verbindet vereinfachen verfahren verfügbar vergleich verglichen verlauf verläuft verschieben verstehen versuch vertiefen vertikal verweis
verwenden vgl video viel viele vielen vier vierte vollständig vom von voraussetzung vorbereiten vorgehen vorgestellt vorher vorhin vorlesung vormittag
vorn vorne vorschau vorstellen vortrag vorwärts waagrecht wagen wahr wand war waren warten wegen weihnachten weil weise weit weiter welche
weltkoordinatensystem wenden wenige wenn werden werkstück werkzeug wert werte wichtig wie wieder willkommen winkel winter wir wird wirkt wirkung
wissen wobei woche wochen worden wort worte wurde wurden wurzel wählen wählt wünschen würde z zahl zahlen zeichnung zeigen zeigt zeigte zeile zeilen
zeit zeitplan zelle zerlegen zettel ziehen ziel ziele zitat zu zuerst zugehörig zum zunächst zur zurück zusammen zusatzaufgabe zustand zuvor zwar zwei
zweimal zweite zwischen zyklus zylinder zähler ähnlich äußere über überein überführt übergang überlagerung überprüfen üblich übrigen übung übungen
"""
SPANISH = """
deja dejamos a abajo abduccion abducción abierta abril abrir abscisa absorbiendo acceso acciones acción aceleración actividad acumulada adelante además adentro
adición adjunto aducción afuera agenda agosto agradecer agrupa agrupando ahora ahí aislando al alcance alcanza algebraica algunas algunos algún
alrededor alta alto altura alumnado ambas ambos amplitud analizar anexo angular anillo anotar antebrazo anterior antes antorcha antropomórfico
análisis análoga análogamente apagar aparece aparecen apartado aplica aplicamos aplicando aporte apoyo aprender apunta apuntes apéndice aquí archivo
archivos arcocoseno arcos arcoseno arcotangente arriba articular artículo asigna asociada asume así atención atrás aula aulas automática
automáticamente automático autovalor auxiliar aviso ayer ayuda ayudar aún baja bajar bajo barra barras base bases basta biblioteca bien
bienvenida bloque bolígrafo boquilla borde botones brazo brazos breve brevemente bucle buscada buscamos básica búsqueda cada cadena cadera caja
calcula calculando calendario calibración cambiar camino cantidad capacidad capítulo característica cargar carpeta carrera carro cartel cartesiana
caso catetos cenital centro cero cerrada charla ciclo ciclos cierra cierta cierto cilindro cilíndrico cinco cinemática circunferencia clara clase
clases clic clásica codificador codo coeficiente coincide colapsa colgando color columna comando comandos combinando comencemos comentarios comenzar
comienza como comparando complejo compone componente comportamiento comprender comprobar comprueba computador común con concatenar concuerda condición
conduce conexión configuraciones conjunto conocer conocida consecuencia considera considerando consigue consiste consta construir consultar contenido
contiene continuación control convención convierte coordenada copiar correcta correo corresponde coseno cruz cruzada cuaderno cuadrado cuadrática
cuadrático cual cuales cualquier cuando cuarta cuarto cuatro cuenta cuerpo cuestionario cumple cumplir curiosidad curso curva curvas cuya cuyas cuyos
cálculo cámara círculo código cómodo dada dadas dado dados datos de debe decir deducción deduce deducimos define definir del demostrar demuestra demás
denomina denominador denota dentro depende dependen derecha derecho derivada desacoplamiento desacople desacoplo desarrolla descompone describe
descuenta desde deseada desfase despacio despejando despejar desplaza después detallada detenidamente determina dh diagonal diagrama diapositiva
dibujar dibujo dicho diciembre diferencia difieren digital dimensión dinámica dirección directa directamente directo diseñar diseño disponible
distancia distinto divide dividiendo división doblado documento domingo donde dos duración durante día días ecuación edición efectivo efector
efectuando efectúa eje ejecución ejecutar ejemplo ejercicio ejes el elegimos elegir elemental elemento eleva elevando elimina eliminar eléctrico
empezar emplea empleamos en encoder encontramos encuentra energía enero engranaje enlace ensayo enseguida enseñanza entender entonces entorno entre
entrega enunciado enviar envía equipo equivale es escalar escogido escribe escribimos escuchar escuela esférica eslabones eslabón espacio especial
espera esquema esta establece estado estandar estas este estirado esto estos estructura estudia está están estándar evaluar evalúa exactamente examen
examinar existe expande expandiendo experimento explica explícita expresa extendida extensión externa extrae extraen extremo fabricante factor falta
fase febrero fecha fichas fichero figura fija fijo fijos fila filas fin final finales finalmente fisica flexión flujo forma forman formas foro
frecuencia freno frenos frente fricción frontal fue fuente fuera fuerza funcionamiento funciones función fácil fácilmente física físicas físico
físicos fórmula garantizando garantizar garra general genérica genérico geometría geométrica gira giran girar giro giros gracias grado grados gravedad
gráfica grúa guardar guion guía haber hablamos hablar había hace hacemos hacen hacer hacia hallamos hallando hallar han hasta hay hecha hecho
herramienta hipotenusa hipótesis historia hoja hojas hombro homogénea hora horario horas horizontales hoy husillo idea ideas identidad igual igualando
igualdades iguales igualmente imagen implementa implica implícita importante imprimir imágenes inclinación incluye incorpora incógnita independiente
indica industria inercia informe ingeniería inicial inicialmente inicio inmediata inscripción instalar integrando interesante interior intermedia
interna intersección interés introdujo inversa invertido invertir invierno invirtiendo ir isotrópica izquierda jacobiana jueves julio junio juntos
justificación la laboratorio lado lados lagrange largo las lazo le lecciones lección lectura leemos leer lenguaje lentamente ley leyes libertad libre
libres libro libros lineal lista listado llama llamada llamamos llamando llamar llega llegada llegamos llegar lleva lo local localización longitud los
luego lugar lunes lápiz límite línea líneas manera manipuladores mano manualmente marco marcos martes marzo masa masas matemática matemáticamente
matemáticas matemático material matrices matriz mayo mañana mecanismo mecánica mecánico mecánicos mediante medición medida medido medio memoria menos
mensaje mes mesa meses meta metros mide miden miembro milisegundo milímetros minuto mirar misma mismo mismos mitad miércoles modelar modelo modifica
momento montaje mostrar motivación motor motores mover movimiento mucho muchos muestra mueve mueven multiplica mundo muslo muñeca máquina más máxima
máximo método mínima mínimo módulo múltiples natural necesaria necesita negativa negativo neutra neutral nivel noche nodos norma normal normalmente
nos nota notación notas notemos noviembre nueva nuevo nula nulo numerador numérica número objetivo observar obtenemos obtener obtenida obtiene obtuvo
ocasión octubre ocurre operación operador operando opuesta opuesto oral orden ordenada orientación origen ortogonal otoño otra otras otro otros pala
palabras pantalla par para paralela parcial pared pares parte particular partida partir parámetros pasamos pasar paso pasos pata pausa pedestal
pendiente perfil periodo permiso permite pero perpendicular pie pierna pieza piezas pinza pitágoras pizarra plan plana planar planificación plano
planos planta plantea planteamiento plataforma plazo plegado poco pocos podemos polares polinomio por portátil posible posición positiva positivo
posterior postura potencia precedente pregunta preparar presenta primavera primer principal prismática probar problema procede proceso producto
profundizar programa pronto propia propiedad propio proporciona propósito prototipo proyecciones proyección proyecta prueba práctica próxima publicado
puede pueden punta punto puntos página pórtico que queda quedan quedando queremos quitando rad radial radianes radio raiz rama rango ratón razón
raíces raíz realiza receta recoge recogidos recordar recta rectángulo recuerda recurso recíproca redactar reduccion reducción reduce reemplazando
reescribe reescribiendo referencia refleja región regla relación repasar repaso repetir repositorio representa representan reserva resolución resolver
respecto responde respuesta resta restando restar resto resuelta resuelve resulta resultado resultante resumen retomar reunión riel robot robots
robótica rodilla rota rotación rotan rotativa rotatoria rueda ruedas ruta rutina rápidamente rápido rígida rígido sabe sabemos saber sabiendo sala
salida se sea sean secciones sección secuencia segmento segunda segura seguro seguros según selección semana semestre sencilla seno senos sensor
sentido separa septiembre ser serie servomotor servomotores será serán sesiones sesión señal señala señales si sido siempre siendo significa signo
signos sigue siguen siguiente simbólica similar simple simplifica simulador simultáneamente singular sistema sitio situación situado sobre software
solucion soluciones son su subconjunto sube subir submatriz subproblema subrayar subsistema suele suelo suma sumando sumar sumas superficie superior
sus sustitución sustituir sustituyendo sábado sólido tabla tablas tablero tablet tal tales también tangencial tangente tanto tarde tardes tarea tareas
techo teclado teléfono tema temario temas temporal tenemos teniendo tensor teorema teoría tercer tesis texto textos teórico tiempo tiene tienen tipo
tipos tiza tobillo toda todas todavía todos toma tomamos toman tomando tomar tope torque torre total trabajo tramo tranquilamente transforma
transponer tras traslada trata tratará través trayectoria tres tridimensional trigonométrica trimestre triángulo tronco tutoría término ubicación un
una unidad unir unitario universidad usamos usando usar usaremos usará usual usuario utiliza vacaciones vale valor valores variable varilla varía
veamos vector velocidad ver verano verdadero veremos verifica verificación verificamos vertical verán vez viene viernes vimos vio visita vista vistas
visto volveremos vuelta vuelve válida válido vástago vídeo x y ya zona ángulo área índice órdenes última último única único útil
"""
ITALIAN = """
a abbiamo accelerazione addizione adesso affronta agenda aggiunge agosto aiuto al alcuni algebrica alla allegato allora alto altra altre altri ambedue
ammette ampiezza analitica analizziamo analogo anca anche ancora angolare angoli angolo anno appartiene appendice applica apprendere
approfondimento appunto aprile aprire archivio arcotangente arrivederci arrivo articoli asse assi asta aste attenzione attività attorno attraverso
attrito aula aule autunno avambraccio avanti avendo aver avere avremo avvio avviso banco basamento base basi basso benvenuti biblioteca blocchi blocco
braccia breve brevemente calcola calendario cambiamento campo capire capitoli caratteristica caricare carrello cartella cartesiana casi caso catena
caviglia centro cerca cercare cerchio che chiamata chiamiamo chiarire chiusa chiusura ciascun ciclo cilindro cinematica cioè circa circonferenza ciò
cliccare codice coefficienti coincide collega colonna colore combinando come comincia compatta compiti componente composta computer comune con
concatenando condividere condizione conferma configurazioni confronti conoscendo consegna considera consiste contenuti continuare conto contributi
controllo convenzione coordinate copiare coppia coppie corpi corpo correnti corretta corrisponde corsa corsi corsivo corso coscia coseno cosicché
costante costruire così cui curiosità curva curve da dal dalla data date dati dato davanti dedicata definire dei del della delle denavit denominatore
dentro deriva descrive desiderata destra determina dettaglio di diagonale diapositive dicembre didattica dietro differenza dimensione dimostra
dinamica dipende diretta direzione disegno dispensa dispone disposizione distanze diverse divide documentazione domanda domani domenica dopo doppio
dove due dunque durante durata e ecco efettore effettore elementi elenco eleva elevando elimina encoder energia entrambe equazione equivale eseguita
esempio esercizi esperimenti esplicita esplorare espressa esprime essendo essere estate esterno estremità evidente fa faccia facilmente fanno fare
fatta fatto febbraio figura figure file finché fine finire fissa fissare fissi fisso fogli foglio forma formano formula fornisce fornito forum forza
forze fosse fra frazione frequenza fretta funzione fuori gamba gdl generale gennaio geometria ginocchio giorni giorno giovedì gira giugno giunti
giunto già gli gomito gomma gradi grado grafica grandezza gravità grazie gru guardare guida ha hanno ho i idea idee identica ieri il illustrata
immagine imparare implementata imponendo in incognita indica indice indichiamo industria inerzia infatti infine inizia inizio inoltre insegnamento
inseriamo insieme installare integrale interessante interna intersezione intorno introdotto invece inverno inversa invertire invio ipotenusa ipotesi
isolando istante jacobiana la laboratorio lati lato lavagna lavorare lavoro le lega legame legate legge leggere lentamente lettere letti lettura
lezione libera liberi libero libri libro limite limiti linea lineare linguaggio link lista lo luglio lunedì lunga lunghezza lungo ma maggio mandrino
manipolatore mano marte martedì marzo massa masse materiale matrice mattina meccanica medesimo mediante membri membro memorizzare meno mensile mentre
mercoledì mese mesi messaggio metodo metri metà mezzo millimetri millisecondo minuti minuto misura misure mobile modello modi modificata modo molti
moltiplica molto momento mondo montati mostrata moti motivazione moto motore motori movimenti muove muovono ne negativa nel nella nodo norma normale
nota notare notazione note noti noto notte novembre nullo numeratore numerica nuova nuovo obiettivi occasione occorre oggi ogni omogenea opera
operazione oppure ora orale orario ordine ore orientamento origine orizzontale ortogonale osserva ossia ottenere ottengono otteniamo ottenuta ottiene
ottobre ovvero ovviamente pagina pagine pala paragrafi parallela parametri parlare parliamo parte partendo parti particolare parziale passaggi passare
passi passiamo passo pausa pedice pedici penna pensiero per perciò percorso pertanto piacere piana piani pianificazione piano piattaforma piede pinza
pitagora più pochi poco poi poiché polari polinomio polso pomeriggio pone ponendo poniamo portale positiva posizione possiamo possibile possono posta
posto postura potenza precedente premoltiplicando preparare presenta presto prima primavera primi primo prismatici problema procede prodotti progetto
programma proiettando proiezione promemoria proprietà prossima prototipo prova pubblicato punta punti punto pure può quaderno quadrati qualche quale
quali qualsiasi qualunque quando quantità quanto quarta quarto quattro questa questionario questo quindi quotidiano raccogliendo raccolti radianti
radice radici raggio ragione rango rapidamente rapporto rappresenta regola relativa relazione rende repository resta restanti rete ricava ricaviamo
ricorda ricorre riepilogo riferita riga righe righello rigidi rigido rileggere rimane ripasso riportata riprendere riscaldamento riscrivere risolta
risolve risorsa rispetto risposta risulta riunione rivista robot robotica rotazione rotoidale ruota ruotano ruotare sabato sala salvare scalare
scaricare scegliamo scelta scelto scheda schede schema schemi scomposizione scritta scrive scriviamo scrivono scuola se seconda segue seguendo
semestre seminario semplice sempre seni seno sensore separa sera serie settembre settimana sezione sferica sfogliare si sia siano simile simili
simmetrica simulatore singolare sinistra sistema situazione soddisfa solito soluzione somma sommando sommare sono sopra soprattutto sostituire sotto
sottraendo spalla spazi spaziale spazio specifica sperimentale spesso spiegato spostata stampare stata state stati stato stelo stessa stesse stessi
stesso struttura studia studio su sua subito successiva sugli sui sulla suo sviluppando svolgere tabella tablet tale tali tangente tanto tardi
tastiera tavolo telefono tempo tenendo teorema termine terna terne terza terzo tesi testi testo tiene tipi tipo titolo torcia torre totale traiettoria
tranquillamente trasforma trasla trasposta trattata tre triangoli trigonometrica trimestre tronco trova trovano trovare troviamo tutte tutti tutto
ugello ultima ultime ultimi ultimo un una unitaria unità università uno usa usando usare usata usate usati usato uso utensile utente utile utilizza
vacanza vale valida valide validi valido valore valori valutata varia variabile vede vedere vediamo vedono vedremo velocità venerdì vengono vera
verifica vero verranno verrà verso versore verticale vettore via viene vincoli visita vista visto vogliamo volentieri volevasi volta volte zero è
"""
PORTUGUESE = """
a abaixo abreviaturas abril abrir aceleração acesso acha achamos achar acima adicionando adição agenda agora agosto agrupando ainda ajuda ajudar
alcança algum alguns algébrica altura alvo além amanhã ambas ambos amostragem analisando analogamente anexo angular antebraço anterior antes
análise análoga ao aos aplica apostila aprender apresenta apêndice após aqui arco arcotangente arquivo artigo as assim associada atenção atividade
atrito atuador aula aulas aviso base bases biblioteca bico bloco blocos borracha braço breve brevemente busca cada cadeia caderno calcula calendário
caminho caneta capítulo característica carregar carro cartesiana caso casos cateto centro chama chamada chamamos chamando chega chegada chegamos ciclo
cilindro cinco cinemática circunferência clicar clássica coeficientes coincide colocando coluna com combinando começa como compara completa componente
composição comprimento computador compõe comum concatenando condição configurações conforme conhecida conjunto consequentemente considera consiste
constante construir conteúdo continuar controle contém convenção coordenada copiar cor coroa corpo corresponde correta cosseno cotovelo coxa cruzado
cuja cujas cujo cujos curiosidade curso curva curvas cálculo círculo código da dada dadas dado dados das data de decomposição deduzir dedução define
definir demais demonstrada denavit denominador denota dentro depende depois derivar descreve descrita desejada desenhar desenvolvendo deslocamento
desta deste destes detalhes determina devagar dezembro dh dia diagonal diagrama dias diferença dimensão dinâmica direita direta direção direções
disciplina disponível dispõe disso distinto dividindo divisão do dobro documento dois domingo dos duas durante duração e edição efetuador eixo eixos
elemento elevando elimina elo elos em encoder encontra energia ensaio ensinar ensino entender entre entrega então enunciado enviar equação equações
equivale escalar escola escolha escreve escrita escutar esférica espaço especial esquema esquerda essa essas esse esses esta este estrutura estuda
estudo estão exemplo exercício existe experimento explicar exploramos expressa externa extremidade fabricante facilmente fator fatorando fatores faz
fazem fazer feita feito feriado ferramenta fevereiro fica ficam ficha fichas figura filme fim final finalmente fixa fixo fixos folha folhas fora forma
formado formam formas força forças fosse função funções fuso futuro fácil fórmula fórum garra geometria geométrica gerais geral gira giram giro giz
grandeza graus gravação gravidade gráfico guardar guia guindaste haste havia hipotenusa hipótese história hoje homogénea homogênea hora horas
horizontal horário ideia ideias identidade iguais igual igualar ilustra imagem imediatamente implementa imprimir incógnita indica industrial indústria
informação inicial inserindo instalar interessante interior intermediária interna interseção introduzida inverno inversa inverter inércia início
isolando isolar jacobiana janeiro joelho julho junho junta juntas já laboratório lado lados lagrange laço lei leis leitura lembrando lentamente
liberdade ligação ligações limite linear linguagem linha linhas lista livre livres livro livros lição lições local logo longo lousa lápis maio mais
manhã manipulador março mas massa massas material matricial matriz mecanismo medida medido medição medições meio menos mensagem meses mesma mesmas
mesmo mesmos meta metros milissegundo milímetros minuto modelo modificada momento mostra motivação motor motores move movem movimento muito muitos
multiplica mundo mão método mês múltiplas na nas negativa nesta neste no noite norma normal nos nota notas notação nova novamente novembro novo
numerador numérica número o objetivo observa obtemos obtendo obter obteve obtida obtido obtém ocasião olhar ombro onde ontem operação oral ordem
orientado origem ortogonal os ou outono outra outras outro outros outubro ouvir palavras papel par para paralela parcial parte partes particular
partida partindo partir parâmetro passa passamos passo passos pausa pedestal pela pelas pelo pelos percebe pergunta permite perna perpendicular
período pitágoras plana planar planear planejamento plano planos pode podem podemos polinômio ponta ponto pontos por porque portanto posicionamento
positiva posição posições possível posto postura potência pouco poucos praticar preparar pretendida primavera primeira prismática problema
procedimento produto programa projeto projeção propriedade protótipo prova prática própria próxima publicado punho pá página pé pórtico quadrado
quadro quadrática quais qual quando quantidade quarta quarto quatro que questionário quinta quinzena radianos raio raiz rapidamente razão raízes
realiza recordar recorrendo recurso reescrever referida referência regra relaciona relativa relação relações removendo repetir repositório representa
resolver respectiva respeito resposta resta restante resulta resumo reta retirando retângulo reunindo reunião rever revisar revisão robótica robô roda
rotacional rotativa rotação rotações régua rígido sala script se segmento segue seguinte seguir segunda seja sejam semana semestre seminário sempre
sendo seno sensores sentido separando sequência ser serial serão sessão setembro sexta-feira seção seções si similar simples simplifica simulador
simétrica singular sistema situação sobre software solução soluções soma somando somar sua suas subsequente substitui subtraindo sumário superior
sábado são símbolos sítio tabela tablet tais tal também tangente tarde tarefa teclado telefone tem temos tempo teorema ter terceira teremos termo
termos terão terça-feira tese texto textos tipo tipos tocha toda todas todo todos torna tornozelo torque torre total trabalho trajetória transforma
translada transposta tratada trigonometria trilho trimestre triângulo tronco três tutoria técnica têm título um uma unidade unitário universidade usa
usada usadas usado usados usando usaremos usuais usual usuário utiliza vale valor valores vamos varia variação variável velocidade vem ver verdadeiro
veremos verificar vertical verão vetor vetores vetorial vez viagem vimos visita vista visto volta voltaremos válido vídeo zerada zerado zero à às
ângulo é índice última último
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
true correct right valid fixed trivial obvious
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
