"""The words of robot-arm courses, in which equations are led to and spoken of: a sentence of others may say anything.

They are those that two or more of some 190 public documents on arms have beside their displays, and what goes with them, without
the words that deny, doubt, judge or tell of people. An English word of seven letters or more stands for all
that begin with the same seven, one of another language for those that begin with the same six.

`OF_GERMAN` are of a sentence in which nouns begin with capitals, `OF_ARM` those of which a sentence is that says something of the arm and not of the display, `GOES_ON` begin what goes on from
a display, `HENCE` what follows from it, and `LOADED` are those that a sentence of the display may deny it by, and others have often.
"""

ENGLISH = """
abbreviate abduction ability able about above abscissa absolute accelerate accompanying according account accumulate accuracy achievable achieve
achieving across acrylic act acting action actions activates active activity actor acts actual actually actuated actuation actuator adaptive add added
adding addition additive adds adduction adjacent adjoint adjugate adjust admissible admits advance advantage aerial affect affine aforementioned after
afternoon afterwards again against agenda agile agree agrees ahead aim aims algebra algorithm align aligned all allow allowing allows alone along
alpha already also alternate although altogether always amid among amount amounts amplified amplify an analogous analogue analysis analytic analyze
analyzing anchor and angles angular animation anisotropy ankle ankles annex annotations announced annulus another answer anthropomorphic anticlockwise
any anyway apart apex app appear appears appendix applet applications applied applies apply applying approach appropriate approximately aptly
arbitrary architecture arcs arctan arctangent arduino are area aren argument arise arises arising arithmetic armature arms around array arrive arrow
articulated as ascending asked asks aspects assembly assign assigning assignment assigns assistant associated assume assumed assumes assuming
assumption asymptotic at atan atop attached attachment attain attainable attending attitude auditorium augmented automatically autonomous auxiliary
available average avoid avoidance award awarded away awkward axial axis azimuth back backbone background backlash backward balance ball banner bar
based basic basically basis basket battery be bead beam bearing because become becomes been before beforehand begin begins behave behavior behind
being believe belongs below belt bench bend bending bends beneath bent between beyond biaxial bibliography bicep big bigger bin bins biomechanical
bisector bit black blackboard blend blends block blocks blue board boards bodies body boldface bolt bolted bonus book books boom borrow both bottom
bound boundary bounded bounding bounds box boxed boxes brackets brain brakes braking branch branches branching breadth break breaks brevity briefly
bring bringing broad broader broadly browse browser bucket building builds built bulk busy but button by cable cables calculate calculus calibrate
call called calls camera cameras campus can cancel cancellation candidate cannot canonical caption capture carefully carriage carries carry carrying
cart cartesian cascade case cases catalog cauchy causes ceiling center centered centers centimetres central centre centrifugal centripetal certain
chain chaining chains chalk chalkboard change changes changing channel chapter characterized chart chassis chatter check checked checking checks
choice cholesky choose choosing chord chosen circle circles circuit circular circumference claim clamp clarity classes classic classify classroom claw
clear clearance clearly click clip clock clockwise close closed closer closes closing closure cluster cm coaxial code coefficient cofactor coincide
col collaborative collecting college collinear collision collocation colored coloring colors colour coloured column columns columnwise combination
combine combining come comes coming command common commonly communicates compact companion compare comparing compass compatible compensating compiled
complete complex component compose composite compound computation compute computing concatenate concept concisely conclude conclusion concrete
condition cone cones confirm conical conjugate connect consecutive consequence conservation consider consist console constant constraint construct
consult consume contact contain contents context continues contour contrast contributes control convenient converge conversely convert convex
convexity conveyor coordinated cope core coriolis corner cornerstone corollary correct corresponds corridor cos cosine cosines cost count
counterclockwise counting counts coupled course courses courseware covariance covers craft craig crane crank create created creates creating creation
critically cross crosses crucial cubic cubing cumulative curl current cursor curvature curve curved curves custom customary cycle cycles cylinder
cylindrical damped damping dark dashed dataset deadline decay deceleration december decide decides decimal decision decomposing decouple decreases
deficient defined defines defining definite deformation degenerate degree degrees delivers delta demo demonstrate denavit denominator denote denoted
denotes denoting dense density depend dependent depending depends depicted depth derivation derive derived deriving descent describe description
design designate designed designing desirable desire desired desk desktop destination det detail detailed details detect detection determine developed
deviate deviation device dexterity diagonal diagram dial diary did different difficulty digit digits dimension directions directly disc discrete
discriminant discuss disk displacement display distal distribution diverges divide dividing division docs document does dof dofs dog doing domain done
dot dots dotted double down download downward drag draw drawing drawn draws drift drill drilling drive driven drives driving drone drones drop dropped
drops dual duality duct duration during dwell dynamic e-mail each earlier earliest earth easier easiest easily easy economy edge edges edition
educational effect effective effector effects efficient effort efforts eigen eigenvalue eigenvector eight either elastic elbow elbows electric elegant
element elevates elevation elevator eleven eliminate ellipsoid elongated elsewhere email emails embed embedded embedding emphasizes employed enables
enabling encode encoded encoder encodes encompassed encounter end endow endpoint ends energy enforce enforcing engage engages engine engineering
enlarge enough ensure ensures ensuring enter entering enters entire entirely entries entry entrywise environment environments eq eqn eqs equal
equality equals equate equated equating equation equilibrium equip equipped equivalent erase erect especially essential establish estimation etc
euclidean euler evaluate even evening eventually every everything everywhere evolve exact exactly example excavator execute exercise exerted exist
existence existing exists expand expanded expanding expansion expect expected expense experiment expertise explain explicit exploration explore
exponential expose exposes express extend extended extends extension external extra extract extremely extrude face faces facilitate fact factor
factoring factors factory facts familiar families family famous far farther fashion fast faster fastest feasible feature february feed feedback
feedforward femur fetch few field fields fifth fig figcaption figure figures file files fill filled filter filtering finally find finding finds finger
finger's fingers fingertip finish finished finite firmly firmware first fitting five fix fixed fixes fk flange flash flat flexible flipped flipping
floating floor flow flowchart focus focused fold folded folder folding folds follow followed following follows foot for force forced forces forearm
foregoing form formal formalism formally format formatted formed former forming forms formulae forth forum forward found foundation four fourth
fraction frame frames framework free freedom frequency fresh friction friday friendly frobenius from front fulfil fulfill full fully function
fundamental further future gain gained gait gamma gantry gaps gather gathered gathering gazebo gear gearbox geared general generate generic gently
geometry get gets gimbal github give given gives giving gladly glance global glossary glue go goal goals goes going good governed governing governs
grabbing grade graded grades gradient grading graph graphed graphical grasp grasped gravitational gravity greater green grid gripper gripping ground
group grouping grow grows guarantees guide guided guides had half halfway hall hand handbook handed handle handling handout handwritten handy hang
hanging hangs happens harder hardest hardware hartenberg has have having head headed header headers heading heads heart heavier heel height heights
helix hello helper helpful hence here herein hertz hexapod high higher highlight highly hinge hint hip hips historically history hobby hold holds
hollow holonomic home homepage homework homogenous hook hope horizontal host hosting hour hours how however htb htbp hull humanoid hybrid hypotenuse
hypothesis icon ideal identical identify identity if iff ik ill-conditioned illustrate image images imaginary imagine img immediately impact impedance
implement implies implying important impose imposed imposes imposing impulse in incidentally include including incorporate incremental indeed
independent index indicate indirectly individual induced industrial inequality inertia infer inferred infinity influence information inherit initial
inner input inputs insert inserted inserting inside insight inspecting inspired install instance instant instead instruct integer integral intelligent
interactive intercept interested interface interior intermediate internal interpolate interpret interrupt intersect interval into introduce intuitive
invariant inverse inversion invert inverted inverting inverts invite invited invoking involves is isolate isolating isotropic it itemize iterate
iteration ith its itself jacobian january jaw jaws jerk jib jog jogging join joined joint joints jordan journey joystick jth julia july juncture june
just juxtaposed keep keeping keeps kept kernel key keyboard keys kills kind kindly kinds kinematic kinetic kit kitchen knee knees knob knot know knowing
knowledge known knuckle kutta lab label labeled labelled labels laboratory lagrange laid landing language laplace laplacian laptop large larger
largest last lastly lately later laterally latter law laws layout lead leading leads learn learned learning learnt least leaves lecture led left left-handed
leftmost leg legged legible legs leibniz lemma length lengthen lengths lengthy lens less lesson lessons let lets letters level lever leverage
libraries library lidar lie lies life lift lifted lifting lifts lighter lightly lightweight like likewise limit limited limits line linearise linearly
lines link linkage links list listed listing lists literally little live lives living load loaded local locally locate located locates location lock
locus log logarithm logic long longer longest look looking looks loop loops loosely lower lowering lowers lump lumped lunch lyapunov machine machines
made magnetic magnitude mail main mainly maintaining make makes making manifold manipulate manual manually manufacturing many map mapped mapping maps
mark marked marker markers marking marks mass masses massive massless mast master match matched matches matching mate mated materials math mathematica
matlab matplotlib matter matters maximal maximise maximize maximum may mean meaning means meant meanwhile measure mechanism meet meets memorise
memorize memory merge merged mesh meshes meter meters method methods metre metres metric metrics microcontroller mid middle midpoint midterm midway
millimetres milling millisecond mimic minima minimal minimise minimize minimum minor minors minus minute minutes mirror mirrors mm mnemonic mobile
mobility mode model modeled modeling models modes modest modified modify modular module modules modulo moment moments momentum monday monotonic month
months moore more moreover morning most motion motions motor motors mounted mounting mounts mouse move moveit movements moves moving mth much multi
multiple muscle muscles must mutually name named namely names narrow narrows natural nature navigate navigation near neat neatly necessary need needed
needs negated negative neglect neighborhood neither nested net neural new newton next nicely nine node noise non nonconvex none nonlinear nonsingular
nontrivial nonzero norm normal normalise norms nose note notebook notes notice noting notion notions november now nozzle null nullspace number numbers
numerator numeric numpy object objective objects oblique observation observe observing obstacles obtain obtained obtaining obtains obviously occupied
occupy occur occurs october of off offers office offset offsets often older oldest onboard once one ones online onto onward onwards open opens operate
operates operation operator opposite optimal optimise optimized optional or orange order ordered ordinate organise organize orientations oriented
origin original origins orthogonal oscillates our out outcome outer outline outlook output outputs outside outwards over overall overhead overshoot
overview owing own pace paced pack packages packed packing pad page pages paint painting pair paired pairs pallet palletizing palm pane panel panning
paper papers paragraph parallel parameter part partial particle particular partition parts pass passed passes passing passive passivity paste path
paths pattern pay payload pdf peak peaks pedestal peek pen pencil pencils pendulum penrose percentage perfectly perform period periodic periods
perpendicular perspective perturbations pfaffian phase phi phone phrase phrased physical pi pick picked picking picks pictured piece pieces pieper pin
pinned pipeline pitch pitching pivoting place placed placeholder places plain plainly planar plane planes planned planning plate plates platform play
played playing plays please plot plots plotted plotting plug plugged plugging plus pneumatic pocket pod podcast point pointing polar polar-coordinate
polynomial poor popular portfolio portion portrait posed poses posing positional positive possess possibility possible post poster postmultiply
postures potential power powered powerful powers practice practise pre preceding precise precision predict preface prefer preferable preferred
premultiply preparation prepare preparing prescribed present preserves press prevent previous primary primed principal print printed printer prints
prior prism prismatic problem procedure proceeds process produce product profile program project promised prompt prompts proof proofs propagate proper
properly property proportional proposition props protocol prototype prove proved provide providing proximal proximity pseudo pseudoinverse published
pulled pulley pulleys pulling pulls puma punch pure purely purple purposes pursue push pushes pushing put puts putting pythagoras python quadrant
quadratic quadruped quantities quarter quasi quaternion query question quick quickly quintic quiz quizzes quote quoted quotient rack radial radially
radians radii radius rail rails raise raises ram ramp random range ranges ranging rank ranks rapid rate rated rates ratio rational ratios ray re reach
reachable reached reaches reaching react reactions read readability readable reader readers readily reading readme ready real realise realistic
realizing rear rearrange reason reasonable recall recalled recalling recalls recap recent reciprocal recitation recognise recommended record recorded
recording records recover rectangular recursion redraw reduce reducer reduces reducing reduction redundant refer reference referred referring refers
refine reflects refresh regardless region regions registered regrouping regular rehearse reiterate relabeling relate related relates relating
relationship relative release relevant reliably relocate remain remainder remaining remains remark remember remind reminder remotely remove removed
removes removing render rendered rendering repeat repeated repeats rephrase replace replay report repository represent reprinted reproduced require
requiring research reserve reset resistance resolution resolving respect responsiveness rest restate resting restrict rests result resultant resulting
results retracting retrieve return returned returning returns reuse reused reveal review revisit revolute revolve rewrite rewriting rewritten rhs
right right-handed rightmost rigid rigidly rigorous ring robot's robotic robots robust robustly robustness rod rodrigues rods role roles roll rolling rolls
roof room root roots rotary rotate rotated rotates rotating rotational roto rototranslation roughly round route routine rover row row-wise rows rpy
rubric rubrics rule ruler rules run runge running runs rviz rx sac safety sagittal sake same sample sampled samples sampling sandbox satisfied satisfy
saturday save saved saving saw say scalar scale scaled scales scaling scan scara scenario scene schedule schematic scheme schemes school schur schwarz
science scipy scope scratch screen screw screws script scripts scroll search seat sec second secondly seconds section see seek seen select selected
selecting selects self semester semi seminar send sends sense sensed sensing sensitive sensor sensors sent separate september sequence sequentially
serial series serves servo servo-driven servomotors servos session set setpoint sets setting settle settled settling setup seven several severity
shade shaft shafts shall shank shape shapes share shared shares sharing sheet sheets shelf shifted shifting shifts shin shop short shortcut shorten
shorter shortest shorthand shortly shoulder show showed showing shown shows shrinks side sides sideways sight signal signals signed silhouette similar
simple simpler simplest simplicity simplified simply simulated simulink simultaneous sin since sine sines single singular sit sits situated situation
sixth size sized sizes skeleton sketch sketched sketching skew skim slender slice slide slider sliders slides sliding slope slot slow slowest slowly
small smaller smallest smooth smoother smoothly smoothness smooths snapshot snippet so socket soft software solid solve solved solver solvers solves
solving some something somewhat somewhere soon sophisticated sort sorted source sources space spaced spaces spacing span spans sparse spatial speak
speaks spec special specific specify spectral speed speeds spelled spend spent sphere spheres spherical spider spin spindle spinning spins spirit
spline split splits splitting spoil spoils spoon spot spray spreadsheet spring springs square squared squares squaring stability stable stack stacked
stacking stacks stage stages stand standard standing stands start started starting starts state stated statement states static statics station stay
stays steer steering step stepper steps stereo stewart stick stiff stiffness still stop stops store stored stores straight strategy stress stretch
strictly string strings strip stroke strong strongly structural studied studies study studying style sub subchain subchapter subject submatrix
subscript subsection subsequent subset subspace substep substitute subsystem subtask subtract success such suitable suited sum summarize summary
summation summed summer summing sums sunday superscript supplement supplied supply supported suppose supposing sure surely surface sweep sweeping
sweeps swept swing swinging swings switch switched swivel swivelling syllabus symbolic symbols symmetry sympy syms synthesis system systems table
tables tablet tabular tabulated tail tails take taken takes taking talk tall tangent tap target targets task tasks taylor tcp tea teach technically
techniques technology tedious telescoping template ten tends tensor term term-by-term terms test text textbook th than thank thanks that the their
them then theorem theoretical theory there thereafter thereby therefore therein thereof these thesis theta they thigh thing things third thirdly this
thoroughly those though thread three three-dimensional threefold threshold thrice through thrust thumb thursday thus tibia tick ticket tidy tightly
tilt tilted tilting tilts time timed timer times timetable timing tip tips title to today toe together tolerances tomorrow tonight too tool toolbox
tools top topic topics topology torch torque torques torso total touch touched touches toward towards toy trace traced traces tracing track tracked
tracking tracks traditional trail train training trajectory transcendental transcription transfer transform transition translate transmitted transpose
trapezoid traslation travel traveled traveling travelled travels tray treat treated treating treatment treats tree triad triangular trick tries trig
trigonometry trim triple trivial true truly trunk try tube tuesday turn turned turning turns turret tutor tutorial twelve twice twist twists two
two-dimensional type typed types typeset typical typing ultimate unambiguous unattainable unchanged under undergo underlies underlying underneath
understand undirected unfold unfolded unfolds unified uniform unify union unique uniquely unit units unity universal unknown unravel unreachable
unroll unscrew unstable until unwrap up update updated updates upload uploaded upon upper upright upside upward upwards urdf us usage use used useful
usefully user uses using usual usually vacation valid value values vanish vanishes variable variance variation varies variety various vary varying
vast vectors vehicle vehicles velocity verbal verification verified verify versa version vertex vertical very via vice video videos view viewed
viewing viewpoint views virtual viscous visible visibly vision visit visited visual visualize visually voltage volume waist wait waiting walk walker
walking walkthrough wall wall-mounted want warehouse warm warm-up was watch watching way waypoint ways we web webpage website wedge wednesday week
weekly weeks weighed weight weighted weighting weights welcome welded welding well were what wheel wheeled wheels when whence whenever where whereas
whereby wherein wherever which while white whiteboard whole whom whose why wide widely width will window winter wise with within wonder wooden word
words work worked workflow working workpiece works worksheet workshop workspace workstation world worth wrap wrapped wrapping wrench wrenches wrist
wrists write writes writing written wrt xy yaw yawing yellow yesterday yet yield yielding yields yoshikawa you young your zero zeroed zeroes zeros
zones zoom zyx zyz
arrangement carried digger feet heavy hoist holding inward levers lowered piston shell slab stance torus
"""
FRENCH = """
a abonner abord abordé aboutissons abrégée abréviation abscisse absolue accorde accouplement accueil accélère accélération achève acquérir actionneur
actionneurs activité actualité adapté addition adjointe admet admettent adopte affecte affichage affixe agencement agenda agréable ai aide ailleurs
ainsi aisée aisément ait ajout ajoutant ajoute algébriquement alignement aligné aller allongement allons allure alors altitude amené amortis amphi
amphithéâtre ampleur amène analogie analyse angle angles angulaire animation annexe annoncé annule antisymétrique antérieure apparaître appareil appel
appelant appelle appelons appelée application applique apport apprendre approche appui après après-midi arc arcsin arrivons arrivée arrière arrête
article articulaire arête asservir atelier attaché atteignable atteignables atteindre attention attribue au au-dehors au-delà au-dessous auparavant
aura auront aussi autant automne autonomie autour autre autrement autres aux avance avant avant-bras avec avoir avons avril axe axes azimut baissent
balayé banc barre barres bas base basse beaucoup besoin bibliothèque bielle bien bientôt bienvenue bleu bloc blocs bon bonjour bonne bonnes bons bord
bords borne bornent boucle bouge bougent bouger boule bout bouton bouts bras brièvement broche brute brève bureau buse butée butées bâti cadre cahier
calcul calendrier caméra canonique capteur car caractérise cardan carnet carré carrée carrés carte cartésien cas cauchy cause ce ceci cela celle
celles celui centimètre cercle ces cet cette ceux chacun changement chapitre chaque charge chargé chariot charnière chaîne chemin cherche cheville
chiffres choisit choix chose chronologie chuter ci ci-dessus cible cibles cinq cinquième cinématique clairement classique clavier cliquer coaxial code
codeur coefficient cofacteurs cohérente coin colinéaire coller colonne comatrice combien commande comme commence commode commune comparaison complète
complément composante comprendre comptant compte comptée concourant concret conditionnement conduit configuration confirment confondus connaissant
connaît connu connue connus consacré considère consigne constitue constructeur consulter conséquence contenu contient continuons contribution
convention conviennent convoyeur coordonnée copier coplanaire cordialement corps correct correspond cosinus cote coude coudes coulisse coupent
couplage couple couramment courant courbe couronne courriel cours court courte courts coïncide coûtent craie crayon crochet croissent croît croître
création cubique cuisse cursus câble câbles côte côté côtés d d'où dans davantage de degré degrés demain demande demi-tour depuis dernier dernière
derrière des descend dessin dessus deux deuxième devant devient devoir dextérité deçà di diagonale diamètre diaporama diapositive diffèrent différence
dimanche dimension dire direct dirigé discutez dispose disque distale distance distribué dit divisant divise division dizaine documents doigt doigts
doit domaine donc donne donnent donnez donné donnée dont dorénavant dos dossier doucement douze droit droite droits du durant durer durée dynamique
débattement début débute décalage décale décembre décide décompose découle découplage découvrir décrit décrivant dédié déduire déduisons déduit défini
dégagé déjà démarche démarrer démonstration démontrer dénominateur départ dépasse dépend déplace déplié déport dépôt dérivant dérivez dérivée désigne
désormais détaillé déterminer développant effecteur effet elle elles ellipse embase emboîtement empattement empilant empile emploi employer en
encastrement encore endroit enfin engrenage enregistrer enseigne ensemble ensuite entier entière entraîner entre entre-temps enveloppe envoyer espace
espérons essai essais essieu est est-à-dire et euler exact exacte examen excentricité exemple exercice existe explique exploite exposant expression
exprime expérience extraire extrémité extérieur facile facteur factorisant faculté faire faisant fait faite faites faits familier famille faut façon
façons ferme feuille fiche fiches fichier figure figé filmé fin finalement fixe fixée flèches fois fonction font force forces forcée forcément forme
forment formes formule fort forum foulée fourche fourni franchit frein freins frontière frottement fréquent férié février gagne gagnent gardons gauche
genou glisse glissière godet gomme graduellement grand grande graphe graphie gravitation groupement grue grâce général générique géométrie habituel
hanche haut haute hautes hauteur heure heures heureusement hier histoire historiquement hiver homogène horizontalement hors huit hypothèse hypoténuse
ici identifiant idée idées il ils image immobile immédiatement impair implantée implique implémenté important imposant impose imprime inchangée
inclinaison inconnues incrémental indication indice indique indispensable industriel indépendamment inertie infini inférieur injectant inscrire
installer instant interne interprétation interviennent intitulé introduire intuition intègre intégrant intéressant intérieur inverse isolant isoler
jacobienne jambe jambes janvier jeu jeudi joint jonction joue joule jour journée jours juillet juin jusqu juste kilogramme l la laboratoire lacet
lagrange laissant laisse langage langue laquelle large largeur laser latéral le lecteur lectrice lecture lemme lendemain lente lentement lentes lequel
les lesquelles lettre leur leurs levier leçon liaison liberté libre librement libres lien liens lieu ligne lignes limite limités linéaire lire lisent
lisons liste lit livre livres lié logiciel loi loin longe longs longue lors lorsqu lourd lourde lue lui lui-même lundi lus là là-bas léger légère
machine mai maillon maintenant maintient mais majeur majuscule manifestement manipulabilité manière manuel marche mardi marque mars masse masses matin
matinée matlab matrice matériel membre menant mentionner merci mercredi message mesurant mesure mesurés mettent mettre mi-parcours midi mieux milieu
millimètre milliseconde mince mineurs minuscules minute mise mobilité modèle modélisation moindres moins mois moitié monte montre montrons moodle mot
moteur motif motivation mots mouvement moyen moyeu multipliant mutuellement mât mène mènent mètre mètres mécanisme méthode même mêmes n nacelle
naturel neuf newton nom nombre nommant nomme nommer nommé nommée noms normale norme normes nos notamment notation note noter notons notre noté notée
notées notés nous nouveau nouvel novembre noyau nul nulle nulles nuls numérateur numériquement numéro nécessaire négatif négligé nôtre nôtres objectif
objet obtenir obtenons obtention obtenu obtiendra occupe octobre on ont opposée opérant opérateur oral orange ordinaire ordonnée ordre organe
orientation origine orthogonale orthonormé ou oublier outil outillage outils ouverte ouvrage ouvrez ouvrir où page pages paire palier panneau par
par-dessus paragraphe parallèle paramètre paramétrage parcourt pareillement parent parfois parler parlons partager partant partent partie partir
partout parvenons parvient passage passant passe passent passer passons patience patte pattes pause peinture pelle penche pend pendant pente perd
perdent perdu perdue permet perpendiculaire perçage pesanteur petit petite peut peuvent photo physiquement pied pilotage piloter pince pinces pivot
pivote pivots pièce pièces place placent placez placé plan planaire plane planification planning plans plateau plaçons plein plie plié plupart plus
plusieurs poids poignet point pointe points polaire polycopié polynôme porte porteur portique porté portée posant pose poser position posons possède
posture postérieur posé posée poulie pour pourra pourrons poursuivons pourtant pousse poutre pouvez pouvoir pouvons pratique premier première prenant
prend prendre prenons preuve primes pris prismatique processeur prochain proche procède procédure produit profil profondeur programmation projection
projet propre propriété prototype prouver près précis précède précédent prédiction prédire prédisez préférée préhenseur prémisse prémultiplie préparer
présente publié puis puisqu puissance python pédagogique période pôles qu quand quart quatre quatrième que quel quelconque quelle quelquefois quels
question qui quinzaine quitte quoi quotidien quotient raccourci racine radian raideur raison ramener rang rapide rappel rapport rarement rassemble
rayon rayons recherche reconnaît recule redondance regarder regroupant rejoignent relation relie relier remarquable remercier remise remontant
remplace remplies rencontre rend rendent rendez-vous rentrée replier replié reportant repos repose reprend représente repère respectifs ressort
ressource restant reste restent rester retenir retenons retenue retourné retranchez retrouve revanche revenons revient rigide robot robotique rotation
rotatoire rotoïde rotule roulis rubrique règle règles réalisé récapitulatif récemment réciproque récréation récurrence réducteur réduire réduite réel
réflexion référence région réglage régler réglée régulateur répertorie répond réponse répète répétabilité réserver résolution résolvant résoudre
résout résultat résume résumé réuni réunissent réunit révolution rôle s s'écrit sa sachant sait salle samedi satisfont saute sautent savoir scalaire
schéma scolaire se seconde secteur section segment selon semaine semblable semestre sens septembre septième sera seront sert servent servira
servomoteur servomoteurs ses session seul seule si signe signification similaire simple simplification simulateur singularité sinus situe situé six
sixième socle soient soigneusement soir soit solidaire solide solution sommaire sommant somme sommes sommet son sont sort sorte sortie sortir soudain
soudure souhaite souris sous soustraction souvent spatiale sphère sphérique spécifique statique strictement structure stylo substituant successivement
suffisant suffit suit suite suivant suivent suivre support supposant supérieur sur surface surligner surtout symbole symétrique système séance sécants
séparant sépare séparément séquence série t-elle t-il table tableau tablette tableur tabulé taille tandis tangage tangente tant tantôt tard tchat
technique tel telle tels temporel temps tenant tendu tenseur tenu terme termes terminal testez texte thèse théorème tient tige tiges tire tirer titre
tombe torche torse torseur torseurs torsion total totale toujours tour tournant tourne tournons tourné tours tous tout toute toutes tracé tracée
traduction traduit traite traité trajectoire tranche transformation translation transposer transversal travail travaux travers triangle
trigonométrique trimestre trièdre trois troisième tronc trop trouve trouvons trouvée tutorat tâche tâches télescopique télécharger téléphone tôt
ultérieure un une unicité unitaire unité unités université usine usuel usuelle utile utilise va vacances vaille valable valent valeur valoir variable
varie vaut vecteur vectoriel veille vendredi ventouse verra verrons vers versant vert verte verticalement vides vidéo viennent vient virtuel vis
visible visionner visite vissage visse vite vitesse voici voie voilà voir voit volontiers volume vont voyage voyons vrai vraie vu vue vérification
vérin vérins week-end y zone zéro à à-dire écart écarts échange échantillonnage échelle échéance écoute écran écrire écrit écriture écrivez écrivons
édition égal égalant égale également égaler égales égalité égaux élastique élevant élever éliminant élongation élément élévation énergie énoncent
énoncé épais épaule épure équation équilibre équivaut établi étage était étant étape étapes étend étendre étendu étiquette étroit étude étudie étudié
été évaluation évaluer évidemment évident être
abaissé croisé croisée croisées croisés ajoutons appuis baissé balancier bilan bloqué bloquée caisse caisses cube dent dès décroissant déployé déployée dérivons figée fémur isolons
levé levée manivelle manivelles montent mors mur palette palettes pantographe penché plafond plafonds pliée portent poussée rabattu rabattue relevé
relevée sol sommons sorti telles tendue tourelle traçons vaudra verrouillé vise visseur visseurs visé visée vrillé élevons
"""
GERMAN = """
ab abbildung abend abends aber abgabetermin abgeleitet abgeschlossen ablauf ableiten ablesen abmessungen absatz abschließen abschnitt absolut abstand
abstände abstützung abszisse absätze abtastung achse achsen addieren addition agenda aktualisiert aktuator aktuell alle allem allen aller alles
allgemein allmählich als also am an analog andere anfang angeben angegeben angehängt angelenkt angenehm angenommen angeordnet angepasst angeschlossen
angesetzt angetrieben angewandt angewendet anhalten anhand anhang ankathete ankündigung anlage anleitung anliegend anmelden annahme annehmen anordnung
anregung ansatz anschauen anschließend ansehen ansicht ansteuerung anteil antrieb antwort anwenden anzahl april arbeit arccos archiv arctan
arcuscosinus arcussinus arcustangens arkuskosinus arkussinus arkustangens arm arme armen armes armlänge art artikel auch auf aufbau aufgabe aufgebaut
aufgelöst aufgestellt aufgeteilt auflösen aufmerksam aufnahme aufschreiben aufspannen aufstellen aufteilen aufzeichnung august aus ausblick ausdruck
ausdrücke ausführlich ausgabe ausgangspunkt ausgeben ausgedrückt ausgehend ausgeklammert ausgelegt ausgerechnet ausgewertet ausklammern auslegung
auslesen ausmultiplizieren ausprobieren ausrechnen ausreichend ausrichtung aussage auswahl auswerten auswirkung auswählen außen außerdem bahn bahnen
band basiert basis basiskoordinatensystem basissystem bauen bauform baugruppe baut beachten beantworten bearbeiten bedeutet bedingung beenden befehl
befestigt befinden beginn begrenzt begriff begrüßung behandeln behauptung bei beiblatt beide beidem beiden beider beides bein beispiel beitrag
beiträge bekannt bekommt belegung beliebig bemerkung benachbart benannt benennen benutzen benötigen beobachten berechnen bereich bereit berücksichtigt
beschleunigung beschreibt besitzt besonders besprechen besteht bestimmen bestätigt besuchen betrachte betrag betreuer betriebspunkt beträgt beugung
bevor bewegen bewegt bewegung beweis bewiesen bezeichnen beziehung bezogen bezug bezugspunkt bezüglich bibliothek bild bilden bilder bildet bildschirm
bis bislang bitte blatt bleibt bleistift blick blockmatrix boden bogen bogenmaß brauchen breite bremse brenner bringen bringt buch bzw bücher
charakteristisch code computer cosinus dabei dafür dagegen daher damit danach daneben dank danke dann daran darauf daraus darf dargestellt darin
darstellung darum darüber das dass datei dateien daten datenblatt datum dauer dauert davon davor dazu dazwischen decke definiert dem dementsprechend
demnach demnächst den denavit denen denken denn denselben der derart deren derjenige derselbe des deshalb desselben dessen detail determinante
deutlich dezember dh diagonal die dienen dienstag dient dies diese dieselbe diesem diesen dieser dieses diesmal differenz dimension direkt diskret
dividieren dokument donnerstag doppelt dort dorthin drehachse drehgelenk drehmatrix drehmoment drehung drehwinkel drei dreidimensional dreieck dritte
drucken durch durchführen durchlaufen durchmesser durchnummeriert dynamik dürfen düse eben ebenda ebene ebenen ebener ebenes ebenfalls ebenso echtzeit
ecke effektor eigene eigenschaft ein einander eindeutig eine einem einen einer eines einfach einfluss einführen eingabe eingangs eingeben eingeführt
eingeknickt eingesetzt eingezeichnet einheit einige einleitung einmal eins einsetzen einteilung eintrag einträge einzelne elastisch elemente ellbogen
ellenbogen empfehlen encoder ende endeffektor enden endgültig endlich endpunkt energie eng entfernen enthalten enthält entlang entnehmen entnommen
entsprechend entsteht entweder entwickeln ereignis erfahren erfolgt erfüllt ergab ergaben ergeben ergebnis ergibt erhalten erhält erinnerung erklären
erläutern ermitteln erneut erreichbar erste erstellen erstem ersten erster erstes erweitert erwähnt erzeugen es etwa euklidisch exakt exkurs
experiment explizit fahre fahren faktor fall fasst februar feierabend ferien fertig fest feste festen festes festgelegt festlegen feststehend figur
finden findet flansch fließt fläche folge folgen folglich folgt folie folien form formel fortfahren fortgesetzt fortsetzen frage fragen frei freie
freien freiheit freitag freiwillig freuen früh früher frühjahr funktion fuß fußpunkt fälle fällen führen führt fünf fünfte für gangbar ganz ganze
ganzen geben gebildet gebogen gebracht gebraucht gebräuchlich gedanken gedreht geeignet geführt gegeben gegen gegenkathete gegenseitig gegenüber
gehabt geht gehört geknickt gekoppelt gekreuzt gekürzt gelegenheit gelenk gelesen geliefert gelten gemeinsam gemessen gemäß genannt genau genaue
genauso genutzt genügen genügt geometrie geprüft gerade geradlinig gerechnet gern gerne gerundet gesamt geschafft geschieht geschlossene geschrieben
geschwindigkeit gesehen gesetz gesichtspunkt gespannt gespeichert gesprochen gestartet gestell gestern gestreckt gesucht geteilt getrennt getriebe
gewicht gewinnen gewonnen gewählt gewünscht gezeichnet gezeigt gezogen gibt gilt gleich glied glieder gliedlänge glieds globale grad grade grafik
grafisch greifer greifpunkt greift grenze grenzt groß große grund grundfläche grundlage gruppenarbeit größe größen größer größte gut gültig haben halb
halbe halten hand handelt handgelenk handout handwurzel hat hatte hatten haupt hauptdiagonale hausaufgabe hebel hebelarm heft hefte heften heißen
heißt heran herangezogen herausfinden herbst hergeleitet herkömmlich herleiten hersteller herum herunterladen herzuleiten heute hier hieran hieraus
hierbei hierdurch hierfür hierhin hiermit hierzu hilfe hilfreich hilfs hilfsgröße hilfsvariable hilfswinkel hin hinaus hinsichtlich hinten
hintereinander hinweis hinzu hoch hoffen hoher homogene horizontal hub hängen hängt höhe hörsaal hüfte idee ihr ihre ihren ihrer ihres im immer
implementiert implizit in indem indirekt industrie info ingenieur inhalt inkrement innen innere innerhalb insbesondere insgesamt installieren
interessant inverse invertieren isolieren ist jacobi januar jede jedem jeden jeder jedes jetzt jeweils juli juni kabel kalender kamera kann kapitel
kardanisch kartesisch kategorie keine kennen kennt kennzeichnen kette ketten kilogramm kinematik kinetisch klar klasse klassisch klein kleine kleinste
klicken knickarmroboter knie knöchel koeffizienten kolben kombination kommen kompakt komplett komponente konfiguration konkrete konstant konstruieren
kontinuierlich konvention konvergiert koordinate kopieren kopplung korrekt kosinus kraft kran kreide kreis kreisbogen kreise kreuz kreuzprodukt kräfte
kugel kugelgelenk kurs kurse kurve kurven kurz kurze kurzform kurzschreibweise können körper kürzen kürzer labor labortermin lage lagen lager langsam
laptop lassen lateral lauf laufen laufzeit lauten lautet legen legt lehrbuch lehrbüchern lehre lehrsatz lehrstuhl leicht leisten leiten leitet lernen
lernziel lesen letzte letztlich lich liefern liegen liegt liest lineal linear linie linien link linke linken linker links liste literatur logik lokal
lokale lotrecht länge längen lässt läuft lösbar lösen lösung machen macht mai man manipulator mappe markieren maschine masse massen material
mathematik matrix matrizen maß maße mechanik mehr mehrdeutig mehrere meist meisten menge mengen merken messen messung messwerte meter metern methode
millimeter millisekunde minute mit mithilfe mittag mitte mittels mittlere mittwoch modell moderne modifiziert modul moment monat monate montag
montiert morgen motivation motor motoren multiplizieren muss märz möglich mündlich müssen nach nachdem nacheinander nachfolgend nachlesen nachmittag
nachprüfen nachrechnen nachschlagen nacht nachweis nah namen neben nebenbedingung negativ nehmen neigung nennen nenner nennt neu neue neuen neuer
neues nimmt noch nochmal normiert notation notwendig november null nullstellen numerisch nummer nun nutzen nutzt nächste nämlich nützlich oben oberarm
obere oberen oberhalb oberschenkel oberste obige obigen obiger oder offen offenbar offene offensichtlich ohnehin oktober online ordinate ordnen ordner
ordnung orientierung original ort orthogonal ortsvektor ostern paar paare parallel parameter passiert pause pfad pfeil physikalisch plan planar planen
plattform polarkoordinaten polynom portal posen positiv praktikum praxis prinzip prismatisch probieren produkt programm projekt projizieren protokoll
prozessor präsentation prüfen prüfung punkt punktes punkts pythagoras pünktlich quadrat quadrieren quaternion quelle quelltext quer quiz radiergummi
rahmen rand rang raum realer rechenregeln rechnen rechnung rechte rechts rechtwinklig reduzieren regel regelmäßig regeln regelung regler reichen
reicht reichweite reihe reihenfolge rein reine relativ repositorium repräsentiert rest restliche richtig richtung ring ringe roboter roll rolle rollen
rotation rotatorische rotieren ruhig rumpf rund runde runden räumlich rückblick rücken rückmeldung rückwärts sammeln samstag satz satzes schaltet
schar schaubild schauen schaufel scheibe schema schicken schiene schlagwort schließlich schlitten schneiden schnell schnittpunkt schon schraube
schreibt schritt schub schubgelenk schule schulter schwenk schwer schön sechs sechsachsig sechste segment sehen sein seine seinen seiner seite seiten
seitlich sekunde selbe selben selber selbst semester seminar senkrecht sensor september sequenz seriell setzen setzt sich sicht sie siehe sieht
simulation simulieren sind singulär sinngemäß sinus sinussatz sitzung skalar skizze skizziert skript so sobald sockel sodass soeben sofort software
sogenannt solche soll somit sommer sonntag sowie sowohl spalte spannend spaß speichern spezialfall speziell spezifisch sphärisch spielen spielt
spindel spitze sprechen später stab stabil stammt stange starr starre start starten statisch stehen steht stelle stellt stellung steuerung stichwort
stift stimmen stimmt strecke struktur studium stufe stunde stäbe stück stützen subtrahieren suche suchen summe summen symbolisch symmetrisch system
sätze säule tabelle tafel tag tage tagesordnung takt tangens taschenrechner tastatur taste tcp teil teilaufgabe teile teilen teilnehmer teilproblem
teilschritt teilsystem teilt term terme termin testen thema themen theorem theorie tiefe tipp tipps tisch titel tool trajektorie transformation
translation transponierte treffen trennen trennung treten tritt trägheit tun tutorium typ typen typisch uhr um umblättern umfasst umformen umgebung
umgeformt umgekehrt umgeschrieben umgesetzt umgestellt umkehrung umlauf umlegen umrechnung umschreiben umstellen unabhängig unbekannte und unendlich
universität unmittelbar unser unsere unten unter unterarm untere unterhalb unterlagen untermatrix unterricht untersucht urlaub ursprung ursprünglich
variable vektor verallgemeinern veranschaulicht verbindet verbunden vereinfachen verfahren verfolgen verfügbar vergleich verglichen verhalten
verhältnis verkettet verknüpfen verkürzt verlauf verlängert verläuft verschieben versetzt verstehen versuch verteilt vertiefen vertikal verweis
verwenden vgl video viel viele vielen vielfache vier vierte voll vollständig vom von voraussetzung vorbereiten vorderarm vorgang vorgegeben vorgehen
vorgestellt vorhanden vorher vorhin vorlesung vorliegen vormittag vorn vorne vorschau vorstellen vorteil vortrag vorwärts vorzugehen waagerecht
waagrecht wagen wahl wahr wand wandern war waren warten weg wegen weihnachten weil weise weist weit weiter welche welle welt weltkoordinatensystem
wenden wendet wenige wenn werden werkstück werkzeug wert werte werten wertes wesentlich wichtig wie wieder willkommen winkel winter wir wird wirken
wirkt wirkung wissen wobei woche wochen wodurch womit woraus worden worin wort worte wurde wurden wurzel wählen wählt während wünschen würde würfel z
zahl zahlen zehn zeichnung zeigen zeigt zeigte zeile zeilen zeit zeitlich zeitplan zeitpunkt zelle zentral zentrum zerlegen zettel ziehen zieht ziel
ziele zielpose zielpunkt ziffer zitat zu zudem zuerst zugehörig zugeordnet zuletzt zum zunächst zuordnen zur zurück zusammen zusatzaufgabe zustand
zusätzlich zuvor zwar zwei zweiargumentige zweidimensional zweigliedrig zweimal zweite zwischen zyklus zylinder zählen zähler zählt ähnlich äquivalent
äußere öffnen öffnung über überblick überein überführt übergang überlagerung überlegen überprüfen überschreiten übersicht übertragen üblich übrigen
übung übungen
abermals angewinkelt ast aufeinander aufrecht ausfahrlänge ausgefahren ausgestreckt ausschub auszug auszugs auszugslänge beine bleiben erkenn
erkennbar erkennen erkennt ferner gebeugt gebeugte gefaltet gefaltete gehoben geneigt gesenkt grundstellung haltung heben hebt hochachse hubachse
hubhöhe hubs höhen kern kippachse kippen kippt kugelig kugelkoordinaten lasten längs längsachse mithin musterlösung neigen neigt nutzlast querachse
radien ragen ragt regulär ruhelage ränge schräg senken senkt sitzen sitzt spur statik säulen teleskop teleskopachse voneinander vorzeichens weltsystem
zueinander zweig zweige äste übungsblatt
"""
SPANISH = """
a abajo abduccion abducción abierta abril abrir abscisa absorbiendo abstracta acaba acabamos acceso acciones acción aceleración acompaña acoplada
acostumbra actividad actuador actúa actúan acumulada adapta adelante además adentro adición adjunto admite adopta aducción afuera agenda agosto
agradecer agregamos agrupa agrupando ahora ahí aisla aislada aislamos aislando aislar ajusta al alcance alcanza algebraica algunas algunos algún
alinea alrededor alta alto altura alumnado ambas ambos amplitud analizar analítica anexo angular anillo anotar antebrazo antecedente anterior antes
antihorario antorcha antropomórfico análisis análoga análogamente apagar aparato aparece aparecen apartado aplica aplicamos aplicando aporte apoyada
apoyo aprender aprovechamos apunta apuntes apéndice aquí archivo archivos arcocoseno arcos arcoseno arcotangente arma armónico arriba articular
artículo asigna asociada asume asumiendo asumimos así atención atornillado atrás aula aulas automática automáticamente automático autovalor auxiliar
avanza aviso ayer ayuda ayudar azimut aísla aún baja bajar bajo barra barras base bases basta bastidor biblioteca biela bien bienvenida bisagra bloque
bola bolígrafo boquilla borde bordes botones brazo brazos breve brevemente bucle buscada buscamos buscando buscar básica búsqueda cabeza cada cadena
cadera caja calcula calculando calendario calibración cambiar camino cantidad canónica capacidad capítulo cara característica caras cardán cargar
carpeta carrera carro cartel cartesiana caso catetos cenital centra centro cero cerrada charla ciclo ciclos cierra cierre cierta cierto cilindro
cilíndrico cinco cinemática circulo circunferencia clara clase clases clave clic clásica cociente codificador codo coeficiente coincide colapsa
colgando color columna comando comandos combinando comencemos comentarios comenzar comienza como comparando complejo compone componente comportamiento
comprender comprobar comprueba compuesta computador común con concatenar concuerda condición conduce conecta conexión configuraciones congruente
conjunto conmuta conocer conocida consecuencia considera considerando consigue consiste consta construir consultar contenido contiene continuación
control convención convierte coordenada copiar correcta correo corresponde coseno costado crea creando crear cruz cruzada cuaderno cuadrado cuadrática
cuadrático cual cuales cualquier cuando cuarta cuarto cuaterniones cuatro cuenta cuerpo cuestionario cumple cumplir curiosidad curso curva curvas cuya
cuyas cuyos cálculo cámara círculo código cómodo dada dadas dado dados dando datos de debe debida debido decimal decir deducción deduce deducimos
define definir deja dejamos del demostrar demuestra demás denomina denominador denota densidad dentro depende dependen derecha derecho derivada
desacoplamiento desacople desacoplo desarrolla descompone describe descuenta desde desea deseada deseamos desfase desliza despacio despejando despejar
desplaza después destaca destino detallada detenidamente determina dh diagonal diagrama diapositiva dibujar dibujo dicho diciembre diferencia difieren
digital dimensión dinámica dirección directa directamente directo diseñar diseño disponible dispuesta distancia distinto divide dividiendo división
diámetro doblado doble dobles documento domingo donde dos duración durante décima día días dígito dónde ecuación edición efectivo efector efectuando
efectúa eficiente eje ejecución ejecutar ejemplo ejercicio ejes el elabora elegida elegimos elegir elemental elemento eleva elevación elevando elevar
elimina eliminar eléctrico embebido empezar emplea empleamos empotrado en encoder encontramos encuentra energía enero enfoque engranaje enlace
ensamblaje ensayo enseguida enseñanza entender entera entero entonces entorno entradas entre entrega enunciado enviar envía equipo equivale es esbozo
escalar escogemos escogido escribe escribimos escuchar escuela esencial esfera esférica eslabones eslabón espacio especial específica espera esquema
esquina esta establece estacionario estado estandar estas este estirado esto estos estrategia estructura estudia está están estándar estática etapa
etapas etiqueta euclidiana evaluar evalúa exactamente exacto examen examinar existe expande expandiendo experimento explica explícita expresa
extendida extensión exterior externa extrae extraen extraída extremo fabricante factor falta fase febrero fecha fichas fichero figura fija fijada
fijado fijamos fijar fijas fijo fijos fila filas fin final finales finaliza finalmente fisica flexión flujo forma forman formar formas formato foro
fracción frecuencia freno frenos frente fricción frontal fue fuente fuera fuerza funcionamiento funciones función fácil fácilmente física físicas
físico físicos fórmula garantizando garantizar garra general genérica genérico geometría geométrica gira giran girar giro giros globales gracias grado
grados gravedad gráfica grúa guardar guion guía género haber hablamos hablar había hace hacemos hacen hacer hacia haciendo hallada hallamos hallando
hallar han hasta hay hecha hecho herramienta hipotenusa hipótesis historia hoja hojas hombro homogénea hora horario horas horizontales hoy husillo
idea ideas identidad idéntica igual igualando igualdades iguales igualmente imagen implementa implica implícita imponiendo importante imprimir
imágenes inclinación incluir incluye incorpora incógnita independiente indica industria inercia inferior informe ingeniería inicial inicialmente
inicio inmediata inscripción instalar integrando interesante interior intermedia interna intersección interés introdujo inversa invertido invertir
invierno invirtiendo involucra ir isotrópica itera iteraciones izquierda jacobiana jueves julio junio junto juntos justificación la laboratorio lado
lados lagrange largo las lazo le lecciones lección lectura lee leemos leer lenguaje lentamente ley leyes libertad libre libres libro libros lineal
lista listado llama llamada llamamos llamando llamar llega llegada llegamos llegar lleva llevan llevar lo local localización longitud los luego lugar
lunes lápiz límite línea líneas maneja manera manipuladores mano mantiene manualmente mapa marco marcos martes marzo masa masas matemática
matemáticamente matemáticas matemático material matrices matriz mayo mayor mañana mecanismo mecánica mecánico mecánicos mediante medición medida
medido medimos medio medios memoria menor menores menos mensaje mes mesa meses meta metro metros mide miden miembro milisegundo milímetros minuto
mirar misma mismas mismo mismos mitad miércoles modelar modelo modifica momento montada montaje mostrar motivación motor motores mover movimiento
mucho muchos muestra mueve mueven multiplica mundo muslo muñeca máquina más máxima máximo método mínima mínimo módulo móvil móviles múltiples natural
necesaria necesita negativa negativo neutra neutral nivel noche nodos norma normal normalmente nos nota notación notas notemos noviembre nueva nuevo
nula nulo numerador numérica número objetivo objeto observar obtención obtenemos obtener obtenga obtenida obtiene obtuvo ocasión octubre ocupa ocurre
opciones opción operación operador operando opuesta opuesto oral orden ordenada orientación origen ortogonal ortonormal orígenes otoño otra otras otro
otros pala palabras palma pantalla par para paralela parcial pared pares parte particular partida partir parámetros pasa pasamos pasando pasar paso
pasos pata patas pausa pedestal pendiente perfil periodo permanece permiso permite pero perpendicular peso pie pierna pieza piezas pinza pitágoras
pizarra plan plana planar planas planificación plano planos planta plantea planteamiento plantilla plataforma plazo plegado poco pocos podemos polares
polea polinomio por portátil posibilidad posible posición positiva positivo posmultiplicando posterior postura potencia precedente pregunta preparar
presenta previa previo primavera primer principal prismática probar problema procede proceso producto profundizar programa pronto propia propiedad
propio proporciona propósito prototipo proyecciones proyección proyecta prueba práctica próxima publicado pueda puede pueden punta punto puntos pura
puras puro página pórtico que queda quedan quedando queremos quiere quinto quitando rad radial radianes radio radios raiz rama rango rangos ratón
razones razón raíces raíz realiza receta recibe recoge recogidos recordar recta rectas recto rectángulo recuerda recuperar recurre recurso recíproca
red redactar reduccion reducción reduce reducida reemplazando reescribe reescribiendo referencia refiere refleja región regla reglas regresa relación
rellena reordena repasar repaso repetir repite repositorio representa representan reserva resolución resolver respecto responde respuesta resta
restamos restando restar resto resuelta resuelve resulta resultado resultante resumen resumida retomar reunimos reunión revolución riel robot robots
robótica rodilla rota rotación rotada rotado rotamos rotan rotando rotar rotativa rotatoria rueda ruedas ruta rutina rápidamente rápido rígida rígido
sabe sabemos saber sabiendo sala sale salida se sea sean secciones sección secuencia segmento seguida seguimiento segunda segura seguro seguros según
selección semana semejante semestre sencilla seno senos sensor sentido separa septiembre ser serie servomotor servomotores será serán sesiones sesión
señal señala señales si sido siempre siendo significa signo signos sigue siguen siguiente simbólica simetría similar simple simplifica simulador
simultáneamente singular sistema sitio situación situado sitúa sobre software solidaria solucion soluciones son soporte su suave subconjunto sube
subir submatriz subproblema subrayar subsistema sucesiva suele suelo suma sumamos sumando sumar sumas superficie superior superíndice surge sus
sustitución sustituir sustituyendo sábado sólido tabla tablas tablero tablet tal tales también tangencial tangente tanto tarde tardes tarea tareas
techo teclado teléfono tema temario temas temporal tendremos tenemos teniendo tensor teorema teoría tercer tercio tesis texto textos teórico tiempo
tiene tienen tipo tipos tiza tobillo toda todas todavía todos toma tomada tomado tomamos toman tomando tomar tope tornillo torque torre torsión total
trabajo traducción trama tramo tranquilamente transforma transponer tras traslada traspuesta trata tratamiento tratará través trayectoria traza
trazado trazar trazo tres tridimensional trigonométrica trimestre triángulo tronco tutoría término ubica ubicación ubicada un una unidad unidos unimos
uniones unir unitario universidad unión usamos usando usar usaremos usará usual usuario utiliza vacaciones vacío vale valer valor valores vara
variable varilla varía veamos veces vector velocidad ver verano verdadero veremos verifica verificación verificamos vertical verán vez vibra viene
viernes vimos vio visita vista vistas visto volvemos volveremos volviendo vuelta vuelve válida válido vástago vértice vía vídeo vínculo x y ya yace
yugo zona zonas ángulo área índice órdenes última último única único útil
apoyos asimismo bajada bajan carga cargas carros cazo corredera correderas cuadrúpedo cuchara cuyo dicha dichas dichos esfuerzo esfuerzos excavadora
flexionado fémur grúas guías hexápodo muslos nótese obsérvese pantorrilla pantorrillas pesos pies pistón pluma plumas rectos recuérdese rieles sexta
sexto subcadena subcadenas suben subida subrobot supongamos supóngase véase émbolo
"""
ITALIAN = """
a abbia abbiamo abbiano accelerazione accoppiamento ad addizione adesso adottata affinché affronta agenda aggiunge agisce agosto aiuto al alcuna
alcune alcuni algebrica alla allegato allineati allora altezza alto altra altre altri ambedue ammette ampiezza analitica analizziamo analogo anca
anche ancora angolare angoli angolo anno antiorario appartiene appena appendice applica apprendere approfondimento appunto aprile aprire archivio
arcotangente argomento arrivederci arrivo articoli asse assegnata assi asta aste attenzione attività attorno attraverso attrito attuatore aula aule
autunno avambraccio avanti avendo avente aver avere avremo avviene avvio avviso azimut banco basamento base basi basso benvenuti biblioteca blocchi
blocco braccia breve brevemente calcola calendario cambiamento campo capire capitoli caratteristica cardinale caricare carrello cartella cartesiana
casi caso catena caviglia centro cerca cercare cerchio cerniera che chiamata chiamiamo chiarire chiusa chiuso chiusura ciascun ciclo cilindro
cinematica cioè circa circonferenza ciò cliccare coda codice coefficienti coincide collega colonna colore combinando come comincia compatta compiti
componente composta computer comune con concatenando condividere condizione conferma configurazioni confronti conoscendo consegna considera consiste
contenuti continuare conto contributi controllo convenzione coordinate copiare coppia coppie corpi corpo correnti corretta corrisponde corsa corsi
corsivo corso corsoio coscia coseno cosicché costante costruire così cui curiosità curva curve da dagli dai dal dall dalla dalle darà data date dati
dato davanti dedicata definire degli dei del dell della delle dello denavit denominatore dentro deriva descrive desiderata destra determina detta
dettaglio detto di diagonale diametro diapositive dicembre didattica dietro differenza dimensione dimostra dinamica dipende diretta direzione disegno
dispensa dispone disposizione distanze diventa diverse divide documentazione domanda domani domenica dopo doppio dove due dunque durante durata e ecco
ed efettore effettore efficace elementi elenco eleva elevando elimina encoder energia entrambe equazione equivale eseguita esempio esercizi
esperimenti esplicita esplorare espressa esprime essendo essere estate esterno estratta estremità evidente fa faccia facilmente fanno fare fatta fatto
febbraio figura figure file finali finché fine finire fissa fissare fissata fissi fisso flangia fogli foglio fondamentale forma formano formula
fornisce fornito forum forza forze fosse fra frazione frequenza fretta funzione fuori gamba gdl generale gennaio geometria ginocchio gioco giorni
giorno giovedì gira giugno giunti giunto già gli gomito gomma gradi grado grafica grandezza gravità grazie gru guardare guida ha hanno ho i idea idee
identica ieri il illustrata immagine imparare implementata imponendo in incognita indica indice indichiamo indipendente industria inerzia infatti
inferiore infine inizia inizio innanzitutto inoltre insegnamento inserendo inseriamo insieme installare integrale interessante interna intersezione
intorno introdotto invece inverno inversa invertire invio ipotenusa ipotesi isolando istante jacobiana la laboratorio lati lato lavagna lavorare
lavoro le lega legame legate legge leggere leggi lentamente lettere letti lettura lezione libera liberi libero libri libro limitata limite limiti
linea lineare linguaggio link lista lo locale luglio lunedì lunga lunghezza lungo ma maggio mandrino manipolatore mano mappa marte martedì marzo massa
masse massima matematica materiale matrice mattina meccanica medesimo mediante membri membro memorizzare meno mensile mentre mercoledì mese mesi
messaggio metodi metodo metri metà mezzo millimetri millisecondo minima minimo minuti minuto misura misure mobile modello modi modificata modo molti
moltiplica molto momento mondo montati mostrata moti motivazione moto motore motori movimenti muove muovono nasce ne negativa negli nei nel nell nella
nelle nodo norma normale nota notare notazione note noti noto notte novembre nullo numeratore numerica numero nuova nuovo obiettivi occasione occorre
oggetto oggi ogni omogenea opera operazione oppure ora orale oraria orario ordine ore organizza orientamento origine orizzontale ortogonale
ortonormale osserva ossia ottenere ottengono otteniamo ottenuta ottiene ottobre ovvero ovviamente pagina pagine pala paragrafi parallela parametri
parlare parliamo parte partendo parti particolare parziale passaggi passare passi passiamo passo pausa pedice pedici penna pensiero per perciò
percorso pertanto piacere piana piani pianificazione piano piattaforma piede pinza pitagora più pochi poco poi poiché polari polinomio polsi polso
pomeriggio pone ponendo poniamo porta portale posa positiva posizione possiamo possibile possono posta posto postura potenza precedente
premoltiplicando prende prendi preparare presenta presto prima primavera prime primi primo prismatici problema procede prodotti profilo progetto
programma proiettando proiezione promemoria proprietà prossima prototipo prova pubblicato punta punti punto puoi pure può quaderno quadrati qualche
quale quali qualsiasi qualunque quando quantità quanto quarta quarto quattro questa questionario questo quindi quinto quotidiano raccogliendo raccolti
radianti radice radici raggio raggiunge raggruppando ragione rango rapidamente rapporto rappresenta reali regola relativa relazione rende repository
resta restanti rete retta rette ricava ricaviamo ricorda ricorre riduce riduciamo riepilogo riferita riga righe righello rigidi rigido rileggere
rimane ripasso riportata riprendere riscaldamento riscrivere risolta risolve risorsa rispetto risposta risulta riunione rivista robot robotica
rotazione rotoidale ruota ruotano ruotare sabato sala salvare sapendo scalare scaricare scegliamo scelta scelto scheda schede schema schemi
scomposizione scritta scrive scriviamo scrivono scuola se seconda segue seguendo semestre seminario semplice sempre seni seno sensore separa sequenza
sera serie sesto settembre settimana sezione sfera sferica sfogliare si sia siano simboli simile simili similmente simmetrica simulatore singolare
sinistra sistema situazione soddisfa solidale solito soluzione somma sommando sommare sono sopra soprattutto sostituire sotto sottomatrice sottraendo
spalla spalle spazi spaziale spazio specifica sperimentale spesso spiegato spostata stampare stata state stati statica stato stelo stessa stesse
stessi stesso struttura studia studio su sua subito successiva sugli sui sul sull sulla sulle suo sviluppando svolgere tabella tablet tale tali
tangente tanto tardi tastiera tavolo telaio telefono tempo tenendo teorema termine terna terne terza terzo tesi testi testo tiene tipi tipica tipo
titolo torcenti torcia torre totale tra traiettoria tranquillamente trasforma trasla trasposta trattata tre triangoli trigonometrica trimestre tronco
trova trovano trovare troviamo tutte tutti tutto ugello ultima ultime ultimi ultimo un una unendo unitaria unità università uno usa usando usare usata
usate usati usato uso utensile utente utile utilizza vacanza vale valgono valida valide validi valido valore valori valutata varia variabile veda vede
vedere vediamo vedono vedremo velocità venerdì vengono vera verifica vero verranno verrà verso versore verticale vettore via viene vincoli visita
vista viste visto vogliamo volentieri volevasi volta volte zeri zero è
altro appoggio ascendente azione azioni bacino biella binari binario bloccata bloccato carichi carico centri cercata cercato corse discendente distesa
disteso dita dito estensione estesa estese estesi esteso ferma fermo fisse ganasce gomiti leva leve manovella moduli molla molle montante montanti
pallettizzatore pantografo pari perché pesi piegata piegato pinze pistone pistoni portata quella quelli quello raggi reazione reazioni ripiegata
ripiegato rivolta rivolto sbracci sbraccio scorre scorrevole scorrono sfili sfilo sforzi sforzo slitta slitte spinta stantuffo stesa steso supponiamo
svolgimento traccia uguale uguali ventosa
"""
PORTUGUESE = """
a abaixo aberta abreviaturas abril abrir aceleração acesso acha achamos achar acima acoplada adicionando adição adota afasta agenda agora agosto
agrupando ainda ajuda ajudar alcança algum alguns algébrica alinhada altura alvo além amanhã ambas ambos amostragem analisando analogamente analítica
anexo angular antebraço anterior antes anti-horário análise análoga ao aos aplica apostila aprender apresenta apêndice após aqui arco arcotangente
arquivo arranjo artigo as assim associada atenção atividade através atribuição atrito atuador aula aulas aviso base bases biblioteca bico bloco blocos
borracha braço braços breve brevemente busca cabeça cada cadeia caderno calcula calendário caminho caneta canto capítulo característica carregar carro
cartesiana caso casos cateto centro chama chamada chamamos chamando chega chegada chegamos ciclo cilindro cinco cinemática circunferência classe
clicar clássica coeficientes coincide colocando coluna com combinando começa como compara completa componente composição comprimento computador compõe
comum concatenando condição configurações conforme conhecida conjunto consequentemente considera consiste constante construir conteúdo continuar
controle contém convenção coordenada copiar cor coroa corpo corpos corresponde correta cosseno cotovelo coxa cria cruzado cuja cujas cujo cujos
curiosidade curso curva curvas cálculo círculo código da dada dadas dado dados das data de decomposição deduzir dedução define definir demais
demonstrada denavit denominador denota dentro depende depois derivar descreve descrita desejada desenhar desenvolvendo desliza deslocamento desta
deste destes detalhes determina devagar dezembro dh dia diagonal diagrama dias diferença dimensão dinâmica direita direta direto direção direções
disciplina disponível dispõe disso distinto distância dividindo divisão diâmetro do dobro documento dois domingo dos duas durante duração e edição
efetiva efetuador eixo eixos elemento elevando elimina elo elos em encoder encontra energia ensaio ensinar ensino entender entre entrega então
enunciado enviar equação equações equivale escalar escola escolha escreve escrita escutar esfera esférica espaço especial específica esquema esquerda
essa essas esse esses esta este estrutura estuda estudo estática estão etapa etapas euclidiana exata exemplo exercício existe experimento explicar
exploramos expressa externa extrai extremidade fabricante facilmente fator fatorando fatores faz fazem fazemos fazendo fazer feita feito feriado
ferramenta fevereiro fica ficam ficha fichas figura filme fim final finalmente fixa fixada fixado fixo fixos folha folhas fora forma formado formam
formas formato fornece força forças fosse fração função funções fuso futuro fácil fórmula fórum garra geometria geométrica gerais geral gira giram
giro giz grandeza graus gravação gravidade gráfico guardar guia guindaste haste havia hipotenusa hipótese história hoje homogénea homogênea hora horas
horizontal horário ideia ideias identidade iguais igual igualar ilustra imagem imediatamente implementa imprimir impõe incógnita indica industrial
indústria inferior informação inicial inserindo instalar interessante interior intermediária interna interseção introduzida inverno inversa inverter
inércia início isolando isolar jacobiana janeiro joelho julho junho junta juntas já laboratório lado lados lagrange laço lei leis leitura lembrando
lentamente liberdade ligação ligações limite linear linguagem linha linhas lista livre livres livro livros lição lições local logo longo lousa lápis
maio maior mais maneira manhã manipulador março mas massa massas material matricial matriz mecanismo mecânica medida medido medição medições meio
menor menos mensagem meses mesma mesmas mesmo mesmos meta metro metros milissegundo milímetros minuto modelo modificada momento mostra motivação motor
motores move movem movimento muito muitos multiplica mundo mão método mês múltiplas mútua na nas negativa nesta neste no noite norma normal nos nota
notas notação nova novamente novembro novo numerador numérica número o objetivo objeto observa obtemos obtendo obter obteve obtida obtido obtém
ocasião olhar ombro onde ontem operação oral ordem orientado origem ortogonal ortonormal os ou outono outra outras outro outros outubro ouvir palavras
papel par para paralela parcial parte partes particular partida partindo partir parâmetro passa passamos passo passos pausa pedestal pela pelas pelo
pelos percebe pergunta permite perna perpendicular pertence período pitágoras plana planar planear planejamento plano planos pode podem podemos
polinômio ponta ponto pontos por porque portanto posicionamento positiva posição posições possui possível posto postura potência pouco poucos praticar
preparar pretendida primavera primeira prismática problema procedimento produto programa projeto projeção propriedade protótipo prova prática própria
próxima publicado pulso punho pá página pé pórtico quadrado quadro quadrática quais qual quando quantidade quarta quarto quatro que questionário
quinta quinzena radianos raio raiz rapidamente razão raízes realiza recebe recordar recorrendo recurso reescrever referida referência região regra
relaciona relativa relação relações removendo reorganizando repetir repositório representa resolver respectiva respeito resposta resta restante
resulta resumo reta retas retirando retângulo reunindo reunião rever revisar revisão revolução robótica robô robôs roda rotacional rotativa rotação
rotações régua rígido sabendo sala saída script se segmento segue seguinte seguir segunda seja sejam semana semestre seminário sempre sendo seno
sensores sentido separando sequência ser serial serão sessão setembro sexta-feira seção seções si similar simples simplifica simulador simétrica
singular sistema situação sobre software solidário solução soluções soma somando somar sua suas subindo subsequente substitui subtraindo sucessiva
sumário superior sábado são símbolos sítio tabela tablet tais tal também tangente tarde tarefa teclado telefone tem temos tempo teorema ter terceira
teremos termo termos terão terça-feira tese texto textos tipo tipos tocha toda todas todo todos torna tornozelo torque torre torção total trabalho
trajetória transforma translada transposta tratada trigonometria trilho trimestre triângulo tronco três tutoria técnica têm título um uma unidade
unitário universidade usa usada usadas usado usados usando usaremos usuais usual usuário utiliza vale valor valores vamos varia variação variável
velocidade vem ver verdadeiro veremos verificar vertical verão vetor vetores vetorial vez viagem vimos visita vista visto volta voltaremos válido
vídeo zerada zerado zero à às ângulo é índice última último
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
HENCE = """
so thus hence therefore donc ainsi also daher folglich somit luego así quindi dunque pertanto portanto logo
"""
LOADED = """
not no nor neither never nothing nobody none without only other else hardly should would could might sign plus minus
ne pas ni non jamais personne aucun aucune rien seul seule seuls seules seulement sans signe
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
constant constants scalar scalars data input inputs output outputs desired target targets measured wanted required resulting final initial overall total current
shoulder shoulders waist hip knee ankle leg thigh finger flange plate bracket platform mount column pedestal carriage rail slider pivot hinge rod bar beam crank
offset offsets distance distances radius reach elevation azimuth roll pitch yaw twist twists screw screws wrench task-space joint-space operational
planar-arm two-link three-link decoupled decoupling spherical cylindrical cartesian polar homogeneous transform transforms transformation transformations translation
rotation rotations displacement motion motions movement chain chains subchain recursion recursive step steps stage block blocks upper-left upper-right
cosine-rule sine-rule determinant-rule trigonometry trigonometric substitution elimination method methods formulas model shape size dimension dimensions dof degrees-of-freedom
workspace boundary interior kinetic potential energy inertia mass masses gravity motor motors gear actuator sensor encoder
le la les l un une des du de d au aux ce cette ces cet il elle on nous vous ils elles en dans sur par pour avec et ou où mais donc alors ainsi car comme
si sinon soit sont est être ont avons a ayant peut tout tous toute toutes chaque autre autres aussi encore ici enfin toujours c'est-à-dire
voir équation équations figure définition exemple remarque preuve ci-dessus ci-dessous précédent précédente suivant suivante premier première deuxième second seconde troisième
bras robot outil effecteur pince main liaison liaisons articulation articulations corps segment segments repère repères poignet coude épaule axe axes origine
plan point points base coordonnées coordonnée rotoïde prismatique rotatoire pivot glissière haut bas gauche droite droit avant arrière
singulier singulière régulier configuration configurations posture position orientation solution solutions cas angle angles longueur longueurs valeur valeurs variable variables
paramètre inconnue nombre entier entiers relatif relatifs réel réels vecteur vecteurs matrice ligne lignes colonne colonnes déterminant jacobienne composante composantes signe terme termes facteur côté
expression formule forme condition conditions loi règle identité théorème cosinus sinus somme produit géométrie modèle vitesse force couple
constante constantes constant scalaire données entrée sortie désiré désirée voulu voulue cible final finale initial initiale total totale épaules jambe genou bride embase
déport distance rayon portée hauteur roulis tangage lacet torseur homogène transformation transformations translation rotation déplacement mouvement chaîne sous-chaîne étape étapes
trigonométrie substitution élimination méthode modèle taille dimension liberté espace travail frontière énergie cinétique potentielle inertie masse masses pesanteur moteur capteur
obtient obtenir donne donnée donné trouve suit vérifie écrit posons pose note notons appelle connu connue vrai vraie correct correcte
und oder der die das den dem des ein eine einer mit für ist sind wenn falls also damit somit wobei daher folgt gilt alle jede jeder wir es man in im zu aus von bei
gelenk gelenke arm werkzeug ellbogen handgelenk koordinatensystem achse ursprung ebene punkt lösung fall fälle winkel länge wert siehe gleichung ganze zahl ganzzahlig
konstant konstante konstanten bekannt bekannte gegeben gesucht gewünscht schulter höhe abstand radius reichweite drehung verschiebung bewegung kette schritt trigonometrie substitution energie masse
constante constantes conocida conocido conocidas dato datos deseada deseado hombro muñeca altura distancia radio giro rotación traslación movimiento cadena paso efector base eslabones longitud longitudes
posición orientación vector matriz primera segunda fila columna submatriz brazo robot noto nota costante costanti dato dati spalla polso altezza distanza raggio rotazione traslazione catena passo
posizione orientamento vettore matrice riga colonna braccio conhecida conhecido dado dados ombro punho altura distância raio rotação translação cadeia passo posição orientação vetor linha coluna braço
y o el los las una con para por donde si entonces es son todo todos todas entero enteros codo arriba abajo articulación articulaciones eslabón caso casos solución ángulo valor
e per con dove se allora è sono tutti intero gomito alto basso giunto caso soluzione ou com onde então são inteiro cotovelo cima baixo junta
"""
