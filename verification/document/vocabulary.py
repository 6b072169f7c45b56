"""The words of robot-arm courses, in which equations are led to and spoken of: a sentence of others may say anything.

They are those that two or more of some 190 public documents on arms have beside their displays, and what goes with them, without
the words that deny, doubt, judge or tell of people. An English word of seven letters or more stands for all
that begin with the same seven, one of another language for those that begin with the same six.

`OF_GERMAN` are of a sentence in which nouns begin with capitals, `OF_ARM` those of which a sentence is that says something of the arm and not of the display, `GOES_ON` begin what goes on from
a display, `HENCE` what follows from it, and `LOADED` are those that a sentence of the display may deny it by, and others have often;
by those of `OF_NO_LETTER` it may deny the display, too, and not say of a letter that it is something else.
"""

ENGLISH = """
climbs climb abbreviate abduction ability able about above abscissa absolute abundance academic accelerate access accommodate accompanying accomplish according
account accumulate accuracy achievable achieve achieving acquire across acrylic act acting action actions activates active activity actor acts actual
actually actuated actuation actuator adapter adaptive add added adding addition additive address adds adduction adjacent adjoint adjugate adjust
admissible admits adopt advance advantage advise aerial affect affine afford aforementioned after afternoon afterwards again against agenda agile
agree agrees ahead aim aims algebra algorithm align aligned all allow allowing allows alone along alpha already also alternate although altogether
aluminium aluminum always ambient amid amidst among amongst amount amounts ampere amplified amplify an analogous analogue analysis analytic analyze
analyzing anchor and anew angles angular animation anisotropy ankle ankles annex annotations announced annulus another answer antenna anthropomorphic
anticlockwise any anyway apart apex apiece app appear appears appendix applet applications applied applies apply applying approach appropriate
approximately aptly arbitrary arch architecture arcs arctan arctangent arduino are area aren argument arise arises arising arithmetic armature arms
around arrangement array arrival arrive arriving arrow articulated as ascending aside asked asks aspects assembly assign assigning assignment assigns
assistant assistive associated assume assumed assumes assuming assumption asymptotic at atan atom atop attached attachment attain attainable attend
attending attitude auditorium augmented automatically autonomous autumn auxiliary available average avoid avoidance award awarded away awkward axial
axially axiom axis axle axles azimuth back backbone background backlash backward bag bags balance ball banner bar based baseline basic basically basin
basis basket batteries battery be bead beam beams bearing because become becomes been before beforehand began begin begins begun behave behavior
behind being believe belongs below belt bench bend bending bends beneath bent between beyond biaxial bibliography bicep big bigger bilateral bin
binary bind bins biology biomechanical bisector bit black blackboard blade blades blend blends block blocks blue blueprint board boards boat bodies
body boldface bolt bolted bolts bonus book books boom borders borrow both bottom bound boundary bounded bounding bounds box boxed boxes brackets brain
brake brakes braking branch branches branching brand breadth break breaks brevity brick bridge bridges brief briefly bring bringing brings broad
broader broadly brought brown browse browser brush bucket builder building builds built bulb bulk bundle buses business busy but button by cab cable
cables calculate calculus calibrate call called calls calm came camera cameras campus can cancel cancellation candidate cannot canonical cap
capability capital caption capture cardboard careers carefully carriage carried carries carry carrying cars cart cartesian cascade case cases catalog
cauchy causes ceiling cell cells celsius center centered centers centimetres central centre centrifugal centripetal ceramic certain chain chaining
chains chair chairs chalk chalkboard change changes changing channel chapter characterized charging chart charts chassis chatter check checked
checking checks chemical chemistry chest chip chips choice cholesky choose choosing chord chosen circle circles circuit circular circumference claim
clamp clarity classes classic classify classroom claw clay clean cleaned cleaning clear clearance clearly click climb climbing clinic clip clock
clockwise close closed closer closes closing closure cluster clutch cm coach coaxial code coefficient cofactor coil coincide col collaborative collar
collecting college collinear collision collocation colored coloring colors colour coloured column columns columnwise combination combine combining
combo come comes coming command common commonly communicates commute compact companion compare comparing compass compatible compensating compiled
complete complex compliant component compose composite compound computation compute computing concatenate conceive concept concerning concisely
conclude conclusion concrete concurrently condition cone cones confirm conical conjugate connect consecutive consequence conservation consider consist
console constant constraint construct consult consume contact contain contents context continues contour contrast contributes control convenient
converge conversely convert convex convexity conveyor cook coordinated cope copper cord core coriolis corner cornerstone corollary correct corresponds
corridor cos cosine cosines cost count counterclockwise counting counts coupled course courses courseware covariance cover covered covering covers
craft craig crane crank create created creates creating creation critically cross crosses crucial crystal cubic cubing cumulative curl current cursor
curvature curve curved curves custom customary cycle cycles cyclic cylinder cylindrical daily damped damping dark dashed dataset day days deadline
deal decade decay deceleration december decide decides decimal decision deck decomposing decouple decreases deep deeper deeply deficient defined
defines defining definite deformation degenerate degree degrees delivers delta demo demonstrate denavit denominator denote denoted denotes denoting
dense density depend dependent depending depends depict depicted depicts deploy deposit depth derivation derive derived deriving descent describe
description design designate designed designing desirable desire desired desk desks desktop destination det detail detailed details detect detection
determine developed deviate deviation device dexterity diagonal diagram dial diary dictionary did different difficulty digger digging digit digits
dimension diode directions directly disc discrete discriminant discuss disk displacement display dissertation distal distribution dive diverges divide
dividing division docs doctoral document does dof dofs dog doing domain dome done door doors dose dot dots dotted double down download downward dozen
drag dragged draw drawing drawn draws drew drift drill drilling drive driven driver drives driving drone drones drop dropped drops drove drum dual
duality duct dug duration during duty dwell dynamic e-mail each earlier earliest earth easel easier easiest easily easy economy edge edges edition
edits educate educational effect effective effector effects efficient effort efforts eigen eigenvalue eigenvector eight eighty either elastic elbow
elbows electric electronic elegant element elevates elevation elevator eleven eleventh eliminate ellipsoid elliptic elongated elsewhere email emails
embark embed embedded embedding embrace emerge emphasizes employed empty enables enabling encode encoded encoder encodes encompassed encounter
encourage end endless endow endpoint ends energetic energy enforce enforcing engage engages engaging engine engineering enjoy enjoys enlarge enough
enrol enroll ensure ensures ensuring enter entering enters entire entirely entries entry entrywise enumerate environment environments eq eqn eqs equal
equality equals equate equated equating equation equator equilibrium equip equipped equivalent erase erect especially essential establish estimation
etc euclidean euler evaluate even evening event events eventually every everything everywhere evolve exact exactly example exams excavator excellent
exciting execute exercise exerted exist existence existing exists exit expand expanded expanding expansion expect expected expense experiment
expertise explain explicit exploration explore exponential expose exposes express extend extended extends extension external extra extract extremely
extrude face faces facilitate fact factor factoring factors factory facts familiar families family famous far farther fascinating fashion fast faster
fastest feasible feature february fed feed feedback feedforward feet femur fetch few fiber fibre field fields fifteen fifth fifthly fifty fig
figcaption figure figures file files filing fill filled film filter filtering filters finally find finding finds finely finer finger finger's fingers
fingertip finish finished finite firmly firmware first firstly fist fitted fitting five fix fixed fixes fk flange flash flat flexible flights flipped
flipping floating floor flow flowchart flows fluid focus focused fold folded folder folding folds follow followed following follows foot footing for
force forced forces forearm foregoing forklift forks form formal formalism formally format formatted formed former forming forms formulae forth forty
forum forward found foundation four fourth fourthly fraction fragment frame frames framework free freedom frequency fresh friction friday friendly
frobenius from front fuel fulfil fulfill fulfils full fully function fundamental funnel further fuse future gain gained gait gallery gamma gantry gaps
garage gas gather gathered gathering gauge gave gazebo gear gearbox geared general generate generic gently geography geology geometry get gets gimbal
github give given gives giving gladly glance glass glasses glide gliding global glossary glue go goal goals goes going gone good governed governing
governs grab grabbing grade graded grades gradient grading gradually graduate grain gram grammar grams graph graphed graphical grasp grasped
gravitational gravity greater green grew grid grind grinder grinding grip gripped gripper gripping grips groove ground group grouping grow grows
guarantees guide guided guides gyro gyroscope had half halfway hall hammer hand handbag handbook handed handle handles handling handout handwritten
handy hang hanging hangs happens harbour harder hardest hardware hartenberg has have having head headed header headers heading headlight heads heart
heat heated heater heating heavier heavy heel height heights helix hello helper helpful hence here herein hertz hexagonal hexapod high higher
highlight highly hinge hinges hint hip hips historically history hobby hoist hold holding holds hollow holonomic home homepage homework homogenous
hook hope horizontal hospital host hosting hour hours how however htb htbp hull humanoid hundred hung hybrid hydraulic hypotenuse hypothesis icon
icons ideal identical identify identity if iff ignition ik ill-conditioned illuminate illustrate image images imaginary imagine img immediately
immersed impact impedance implement implies implying important impose imposed imposes imposing impulse in inch inches incidentally include including
incorporate incremental indeed independent index indicate indirectly individual indoor induced industrial inequality inertia infer inferred infinity
inflate influence information inhabit inherit initial ink inlet inner input inputs inquiry insert inserted inserting inside insight inspecting
inspired install instance instant instead instruct instrument insulation intake integer integral intelligent interactive intercept interested
interface interior intermediate internal interpolate interpret interrupt intersect interval into introduce intuitive invariant inverse inversion
invert inverted inverting inverts investigate invite invited invites invoice invoking involves inward iron is isolate isolating isosceles isotropic it
item itemise itemize items iterate iteration ith its itself jacobian january jaw jaws jerk jib jog jogging join joined joint jointly joints jordan
joules journey joystick jth julia july juncture june just juxtaposed keep keeping keeps kelvin kept kernel key keyboard keypad keys kills kilometre
kilowatt kind kindly kinds kinematic kinetic kit kitchen knead knee knees knit knives knob knot know knowing knowledge known knuckle kutta lab label
labeled labelled labelling labels laboratory labour labs ladder lagrange laid lamp landing language laplace laplacian laptop large larger largest last
lastly latch lately later laterally latitude latter launch launcher law laws layer layers layout lead leading leads leaflets learn learned learning
learnt least leather leaves lecture led left left-handed leftmost leg legged legible legs leibniz lemma length lengthen lengths lengthy lens less
lesson lessons let lets letters level lever leverage levers libraries library lid lidar lie lies life lift lifted lifting lifts lighter lightly
lightweight like likewise limb limbs limit limited limits line linearise linearly lined liner lines link linkage links lip liquid list listed listing
lists liter literally litre little live lives living load loaded local locally locate located locates location lock locker locus log logarithm logic
long longer longest look looking looks loop loops loosely loudspeaker lower lowered lowering lowers lump lumped lunch lyapunov machine machines made
magnet magnetic magnets magnitude mail mailbox main mainly maintaining make makes making maneuver manifold manipulate manner manners manoeuvre manual
manually manufacturing many map mapped mapping maps marine mark marked marker markers marking marks mask mass masses massive massless mast master mat
match matched matches matching mate mated materials math mathematica matlab matplotlib matter matters maximal maximise maximize maximum may mean
meaning means meant meanwhile measure mechanism medium meet meeting meets membrane memorise memorize memory menu merge merged mesh meshes met metal
metals meter meters method methods metre metres metric metrics microcontroller microphone microscope microwave mid middle midpoint midterm midway mild
mile miles millimetres milling millisecond mimic mineral minima minimal minimise minimize minimum minor minors minus minute minutes mirror mirrors mm
mnemonic mobile mobility mode model modeled modeling models modes modest modified modify modular module modules modulo moment moments momentum monday
monitor monotonic month monthly months moore more moreover morning most motion motions motor motors mounted mounting mounts mouse move moveit
movements moves moving mth much multi multimeter multiple muscle muscles must mutual mutually nail nails name named namely names narrow narrows
natural nature navigate navigation near neat neatly necessary need needed needs negated negative neglect neighborhood neither nest nested net network
neural new newton next nicely nights nine nineteen ninety ninth node nodes noise non nonconvex none nonlinear nonsingular nontrivial nonzero noon norm
normal normalise norms north northern nose note notebook notes notice noting notion notions november now nozzle null nullspace number numbers
numerator numeric numpy nut nuts object objective objects oblique observation observe observing obstacles obtain obtained obtaining obtains obviously
occupied occupy occur occurs octagon october odometer of off offered offers office offset offsets often oil older oldest onboard once one ones oneself
online onto onward onwards open opening opens operate operates operation operator opposite optic optics optimal optimise optimized optional or orange
orbit orbits order ordered ordinate organise organize orientations oriented origin original origins ornament orthogonal oscillates oscilloscope our
ourselves out outcome outdoor outer outlet outlets outline outlook output outputs outside outwards oval over overall overhead overlay overshoot
overtake overview owing own pace paced pack packages packed packing pad paddle page pages paint painting pair paired pairs pairwise pallet palletizing
palm pane panel panels panning paper papers parachute paragraph parallel parameter parcel parking part partial particle particular partition parts
pass passed passes passing passive passivity paste path paths pattern pay payload pdf peak peaks pedal pedals pedestal peek peg pegs pen pencil
pencils pendulum penrose percentage perfectly perform period periodic periods perpendicular perspective perturbations pfaffian phase phases phi phone
phrase phrased physical physics pi pick picked picking picks pictured piece pieces pieper pier piles pillar pin pine pinned pipe pipeline pipes
pipette piston pitch pitching pivoting place placed placeholder places plain plainly planar plane planes plank planned planner planning plaster
plastic plate plates platform play played playing plays pleasant please plot plots plotted plotting plow plug plugged plugging plumb plunge plus
pneumatic pocket pod podcast point pointing polar polar-coordinate pole poles polygon polynomial poor popular portable portfolio portion portrait
ports posed poses posing positional positive possess possibility possible post poster postmultiply postures pot potential pound pouring powder power
powered powerful powers practice practise pre preceding precise precision predict preface prefer preferable preferred premultiply preparation prepare
preparing prescribed present preserves press pressure prevent previous primary primed principal print printed printer prints prior prism prismatic
problem procedure proceeds process produce product profile program progressively project promised prompt prompts proof proofs propagate propeller
proper properly property proportional proposition props prosthetic protocol prototype prove proved provide providing provinces proximal proximity
pseudo pseudoinverse published pulled pulley pulleys pulling pulls puma pump pumps punch pure purely purple purposes pursue push pushes pushing put
puts putting pyramid pythagoras python quadrant quadratic quadruped quantities quarter quasi quaternion query quest question quick quickly quintic
quiz quizzes quote quoted quotient rack radar radial radially radians radiator radii radius raft rail rails railway raise raises raising ram ramp ran
random range ranges ranging rank ranks rapid rate rated rates ratio rational ratios ray re reach reachable reached reaches reaching react reactions
read readability readable reader readers readily reading readme ready real realise realistic realizing rear rearrange reason reasonable reassemble
rebuild recall recalled recalling recalls recap received receiving recent recipe reciprocal recitation recognise recombine recommended reconstruct
record recorded recording records recover rectangular recursion redefine redraw reduce reducer reduces reducing reduction redundant refer reference
referred referring refers refine reflects reformulate refresh refrigerator regardless region regions registered regrouping regular rehabilitation
rehearse reiterate relabeling relate related relates relating relationship relative relay relays release relevant reliably relocate remain remainder
remaining remains remark remember remind reminder remotely remove removed removes removing render rendered rendering reopen reorient repeat repeated
repeats rephrase replace replay report repository represent reprinted reproduced request require requiring research reserve reset resin resistance
resistor resolution resolving resources respect responsiveness rest restate restaurant resting restore restrict rests result resultant resulting
results retina retracting retrieve return returned returning returns reuse reused reveal review revisit revolute revolve rewrite rewriting rewritten
rhs right right-handed rightmost rigid rigidly rigorous ring rings rise rises rising roads robot's robotic robots robust robustly robustness rock
rocket rod rode rodrigues rods role roles roll roller rollers rolling rolls roof room root roots rope ropes rose rotary rotate rotated rotates
rotating rotational roto rotor rotors rototranslation roughly round route routine rover row row-wise rows rpy rubber rubric rubrics rule ruler rules
run runge running runs rviz rx sac safety sagittal sake same sample sampled samples sampling sandbox sat satellite satisfied satisfy saturday save
saved saving saw say scaffold scalar scale scaled scales scaling scan scara scenario scene schedule schematic scheme schemes school schur schwarz
science scipy scissors scoop scooping scooter scope scraper scratch screen screw screws script scripts scroll search seat seated seats sec second
secondly seconds section see seed seek seen select selected selecting selects self semester semi semicircle seminar send sends senior sense sensed
sensing sensitive sensor sensors sent sentence separate september sequel sequence sequentially serial series serves servo servo-driven servomotors
servos session set setpoint sets setting settle settled settling setup seven seventeen seventy several severity shade shaft shafts shall shank shape
shapes share shared shares sharing sharp shear sheet sheets shelf shell shelves shield shifted shifting shifts shin ship shop short shortcut shorten
shorter shortest shorthand shortly shoulder shovel shoveling show showed showing shown shows shrinks shuttle side sides sideways sight signal signals
signed silhouette silicon similar simple simpler simplest simplicity simplified simply simulated simulink simultaneous sin since sine sines single
singular sit sits situated situation sixteen sixth sixty size sized sizes skeleton sketch sketched sketching skew skill skills skim slab sleeve
slender slice slid slide slider sliders slides sliding slim slope slot slots slow slowest slowly small smaller smallest smooth smoother smoothly
smoothness smooths snapshot snippet so socket soft software solar solder soldering solid solve solved solver solvers solves solving some something
somewhat somewhere soon sooner sophisticated sort sorted sound sounds source sources space spacecraft spaced spaces spacing spade span spans spare
spark sparse spatial speak speaker speaks spec special specific specify spectral spectrum speed speeds spelled spells spend spent sphere spheres
spherical spider spin spindle spinning spins spirit spline split splits splitting spoil spoils spool spoon spot spray spreadsheet spring springs spun
square squared squarely squares squaring stability stable stack stacked stacking stacks staff stage stages stair stairs stance stand standard standing
stands start started starting starts state stated statement states static statics station stay stays steady steel steep steer steering stem stems step
stepper steps stereo stewart stick stiff stiffness still stirring stone stood stool stop stops storage store stored stores straight strategy stream
stress stretch strictly string strings strip stroke strong strongly structural strut struts studied studies study studying style sub subchain
subchapter subject submatrix subscript subsection subsequent subset subspace substep substitute subsystem subtask subtract success such suitable
suited sum summarize summary summation summed summer summing sums sunday superscript supplement supplied supply supported suppose supposing sure
surely surface survey surveyed suspension swam sweep sweeping sweeps swept swing swinging swings switch switched swivel swivelling swung syllabi
syllabus symbolic symbols symmetry sympy syms synthesis syringe system systems table tables tablet tabular tabulated tackle tackled tackling tail
tails take taken takes taking talk tall tangent tank tanks tap tape target targets task tasks taught taylor tcp tea teach teaches technically
techniques technology tedious telephone telescoping temperature template ten tends tensor term term-by-term terms terrain test text textbook texture
th than thank thanks that the their them then theorem theoretical theory there thereafter thereby therefore therein thereof thermal these thesis theta
they thickness thigh thing things third thirdly thirty this thoroughly those though thousands thread three three-dimensional threefold threshold
thrice through thrust thumb thursday thus tibia tick ticket tidy tight tightened tightly tilt tilted tilting tilts time timed timer times timetable
timing tiny tip tips tissue title to today toe together tolerances tomorrow tonight too tool toolbox tools top topic topics topology torch torque
torques torso torus total touch touched touches toward towards tower toy trace traced traces tracing track tracked tracking tracks tractor traditional
trail trailer train training trajectory transcendental transcription transfer transform transistor transition translate transmitted transpose
trapezoid traslation travel traveled traveling travelled travels tray treat treated treating treatment treats tree triad triangular trick tries trig
trigonometry trim triple trivial trolley true truly trunk try tub tube tubes tuesday tunnel turbine turn turned turning turns turret tutor tutorial
tweezers twelfth twelve twenty twice twin twist twists two two-dimensional type typed types typeset typical typing tyre tyres ultimate unambiguous
unattainable unchanged under undergo underlies underlying underneath understand underwater undirected unfold unfolded unfolds unified uniform unify
union unique uniquely unit units unity universal unknown unload unloaded unloading unlock unlocked unpack unravel unreachable unroll unscrew unstable
until unwrap up update updated updates upload uploaded upon upper upright upside upstairs upward upwards urdf us usage use used useful usefully user
uses using usual usually utility vacation vacuum valid valley value values valve valves vanish vanishes vapor variable variance variation varies
variety various vary varying vast vectors vehicle vehicles velocity ventilator verbal verification verified verify versa version versus vertex
vertical very via vice video videos view viewed viewer viewing viewpoint views virtual viscous visible visibly vision visit visited visitors visual
visualize visually vocabulary volt voltage volts volume wafer wagon waist wait waiting walk walker walking walkthrough wall wall-mounted walls want
warehouse warm warm-up warmer was washer washing watch watching watt watts wave waves way waypoint ways we weave web webpage website wedge wednesday
week weekly weeks weighed weight weighted weighting weights welcome weld welded welder welders welding well were west what wheel wheelchair wheeled
wheels when whence whenever where whereas whereby wherein wherever which while whilst white whiteboard whole whom whose why wide widely width will
winding window windows winter wipe wire wires wiring wise with within wonder wooden word words work worked workflow working workout workpiece works
worksheet workshop workspace workstation world worth woven wrap wrapped wrapping wrench wrenches wrist wrists write writes writing written wrt xy
yards yaw yawing yearly yellow yesterday yet yield yielding yields yoshikawa you young your yourselves zero zeroed zeroes zeros zipper zones zoom zyx
zyz
bars
"""
FRENCH = """
abord jusqu
meuvent pistolet pinceau soudure a abaissé abonner abord abordant aborder abordons abordé aboutissons abrégée abréviation abscisse absolue accessible accolade accomplie accorde
accouplement accrocher accueil accélère accélération achevant achever achevons achevé achève acier acoustique acquérir actionneur actionneurs activant
activer activité activé actualité actuellement adapter adaptons adapté addition adjoignant adjointe admet admettent adopte affecte affichage affines
affixe afin agencement agenda agrandir agréable ai aidant aide aidons aidé aidée aidées aidés aie aies aille aillent ailleurs ainsi aire aires aisé
aisée aisément ait ajout ajoutant ajoute ajoutons ajustement ajusté alentour algébriquement alignant alignement aligné alimentation aller allez
allongement allons allumant allumer allumé allure alors alphabet altitude aluminium amenant amene amener amenez amenons amené amenée amenés amortis
amphi amphithéâtre ampleur amène amènent analogie analyse androïde angle angles angulaire animation annexant annexe annexé annoncé annule
antisymétrique antécédent antérieure apercevoir aperçoit aplati apparaître appareil apparition apparu appel appelant appeler appelle appelons appelée
application applique apport apprendre appris approche appui appuie appuis appuyant appuyer appuyons appuyé après après-midi arbre arbres arc arcsin
arrivant arrivons arrivée arrière arrondi arrêtant arrête arrêtons arrêté article articulaire arête arêtes aspect asseoir asservir assis assise
assister astuce atelier attaché attaque attardons atteignable atteignables atteindre attendre attention attrapé attribue au au-dehors au-delà
au-dessous aujourd auparavant auprès auquel aura auras aurez auriez aurons auront aussi aussitôt autant automne autonomie autour autre autrement
autres aux auxquels avance avancée avant avant-bras avantage avançant avançons avec avoir avons avril axe axes axiome ayez ayons azimut baissent
baissé balancier balançant balayé banc baptisé barre barres barycentre bas basculer base basse battements batterie battre beaucoup besoin bibliothèque
bielle bien bientôt bienvenue bijection bilan bissectrice blanc blanche blancs bleu bleue bleues bleus bloc blocs bloqué bloquée bois bon bonjour
bonne bonnes bons bord bords borne bornent bornier borné bornée boucle bouclons bouge bougent bouger boule boules boulons boussole bout bouton bouts
branché bras bref brefs brièvement broche brute brève bureau buse buts butée butées bâti bâtie bâties bâtir bâtis bâtissent bâtit cachée cachés
cadence cadran cadre cahier caisse caisses calcul calendrier came cames caméra canonique caoutchouc cap capteur capturés car caractérise cardan carnet
carré carrée carrés carte carter cartésien cas cauchy causant cause causent causer causez causons causé causée causés ce ceci cela celle celles celui
cent centimètre centrer centré cents cercle ces cet cette ceux chacun chaise changement chapitre chaque charge chargé chariot charnière chaude chaîne
chemin chenille cherche cheville chiffres chimique choisit choix chose choses chronologie chuter châssis ci ci-dessus cible cibles cinq cinquante
cinquième cinématique cinétiques cisaillement clairement classant classique classé clavier cliquant cliquer cliqué clé clôture coaxial codant code
codent coder codeur codé codée codées codés coefficient cofacteurs cohérente coin colinéaire collant colle collent coller collez collège collé collée
collés colonne comatrice combien commande comme commence commode commune comparaison compilé complète complément composante comprendre comptant compte
comptons comptée concentrons concernant concevoir concourant concret concrètement conditionnement conduit confie confier configuration confirment
confondus conjointement connaissant connaît connu connue connus consacré conseils considère consigne constitue constructeur consulter consécutives
conséquence contenu contient continuons contribution contrôle convention conviennent convoyeur conçu conçue coordonnée copier coplanaire cordialement
corps correct correspond cosinus cote couche coude coudes couleur coulisse coupant coupe coupent couper coupez couplage couple coupons coupé coupée
coupés couramment courant courbant courbe courbé couronne courriel courroies cours court courte courts couvrant couvre couvrir couvrons coïncide
coûtent craie crayon crochet croissent croisé croisée croisées croisés croît croître créant création crée créent créer créera créeront créez
crémaillère créons créé créée créées créés cube cubes cubique cuisse cuivre cursus câblage câble câbles célèbre cône cônes côte côté côtés d d'où dans
davantage de dedans degré degrés demain demande demeure demi demi-tour demie dent depuis dernier dernière derrière des descend desquels desservir
dessin dessous dessus deux deuxième devant devez devient devoir dextérité deçà di diagonale diamètre diaporama diapositive dictionnaire didacticiel
diffèrent différence dimanche dimension diminuer dira dire direct dirige dirigé discrète discutez dise dispose disque distale distance distribué dit
dites divisant divise division divisons divisé dix dixième dizaine documents doigt doigts doit domaine donc donne donnent donnez donné donnée dont
dorénavant dos dossier dotant dote dotent doter doté dotée dotées dotés doublant doublons doublé doucement douzaine douze droit droite droits du dues
duquel durant durer durée durées dynamique dès débattement débrancher début débute décalage décale décalé décembre décharge décide décompose découle
découplage découvrir décrit décrivant décroissant dédié déduire déduisons déduit défini dégager dégagé déjà délai démarche démarrer démonstration
démontrer dénombrable dénominateur dénotant dénote départ dépasse dépend déplace déplaçant dépliant déplier déplié déployé déployée déport déposant
déposer déposons déposé dépôt dérivant dérivez dérivons dérivée désactiver désigne désormais détaillé détecter détenir déterminer développant
déverrouiller dû effecteur effet elle elles ellipse embase emboîtement embrayer emmenant emmener emmenons emmené emmène empattement empilant empile
empilés emploi employer empoigne en encadré encastrement encerclé enchaîne encodé encore endroit enfin engendre englobe engrenage enregistrer enseigne
ensemble ensuite entamant entame entamons entamé entier entière entouré entrainer entrant entraîner entre entre-temps entrent entrepôt entrer entrez
entrons entré entrés enveloppe envisage envisager envoyer espace espérons esquisse essai essais essieu est est-à-dire et eu eue euler eurent eus
eussent eussions eut exact exacte examen excentricité exemple exercer exercice exercé exerçant exerçons existe exosquelette explique exploite exporter
exposant exposer exposons exposé expression exprime expérience extraire extrémité extérieur exécuter fabrique facette facile facteur factorisant
faculté faire faisable faisant faisons fait faite faites faits familier famille fasse fassent faut façon façons fenêtre fera fermant ferme ferment
fermer fermez fermons fermé fermée fermés ferons feront feuille fiche fiches fichier figure figuré figé figée fil filmant filment filmer filmez filmé
filmée filmés fils filtrant filtre filtré fin finalement fines fini finie finies finir finira finiront finis finissent finit fins fixant fixe fixent
fixer fixera fixez fixons fixé fixée fixées fixés flèches fléchés focalisons fois fonction font force forces forcée forcément forme forment formes
formez formons formule formé formée formés fort forum foulée fourche fourni fraiseuse franchit frein freinant freiner freins freiné froide frontière
frottement fréquent furent fus fut fémur férié février fûmes gagne gagnent garde garder gardons garni garnie garnir garnis garnit gauche gazeux genou
genoux genre gisement glissant glisse glissière glissé glossaire godet gomme graduellement graduée grand grande grandi grands graphe graphie
gravitation grecque gris groupant groupement groupés grue grâce gré gyroscope génère général générer générique généré géométrie habituel hanche hausse
haut haute hautes hauteur heure heures heureusement hexagone hier histogramme histoire historiquement hiver homogène homothétie horizontalement hors
hui huit huitième humanoïde hydraulique hyperbole hypothèse hypoténuse hélice ici icône identifiant idée idées il illimité ils image immobile
immédiatement impair implantée implique implémenté important imposant impose imprime inchangée inclinaison incluant incluent incluons inclure inclut
inconnues incrémental indication indice indique indispensable industriel indépendamment inertie infini infra inférieur initiant initier initié
injectant inscrire installer instant insère insérant insérer inséré interne interprétation interroger interviennent intitulé introduire intuition
intègre intégrant intéressant intérieur intérêt inverse invisible ira iras irons iront isocèle isolant isole isolent isoler isolons isolé isolée
isolés isométrie issu issue issus itinéraire jacobienne jambe jambes janvier jaune jaunes jeu jeudi joignant joignent joignons joindre joint jointe
jointure jonction joue joule jour journée jours juillet juin jusqu jusque juste kilogramme l la laboratoire lacet lagrange laissant laisse laissons
laissé lance lancent lancer lancez lancé lancée lancés langage langue lançons laquelle large larges largeur laser latéral le lecteur lectrice lecture
lemme lendemain lent lente lentement lentes lents lequel les lesquelles lettre leur leurs levant levent levez levier levons levé levée levées levés
leçon liaison liberté libre librement libres lien liens lier lieu lieux ligne lignes limite limités linéaire lira lire lirons lisant lise lisent lisez
lisible lisons lissant lisse lisser lisses lissé lissée lissés listant liste listent lister listes listé listées listés lisée lit livre livres lié
liée liées logiciel logiquement loi loin lois longe longeant longent longerons longs longue longé lors lorsqu losange lot lots lourd lourde lue lues
lui lui-même lundi lus lycée là là-bas lève lèvent léger légère machine magnétique mai maillon mains maintenant maintient mais majeur majuscule
manifestement manip manipulabilité manivelle manivelles manière manuel marche mardi marquant marque marquons marqué marron mars marteau masse masses
mathématiquement matin matinée matlab matrice matériel membre menant mene mener menez menons mentionner menu mené menée menées menés merci mercredi
message mesurant mesure mesurons mesurés mettant mettent mettez mettons mettra mettre mettrons mi-parcours midi mieux milieu mille milliers millimètre
million milliseconde mince minces mineurs minuscules minute mise mises mixte mixtes mobilité modèle modélisation moindres moins mois moitié monte
montent monter montez montons montrant montre montrons montré monté montée montés moodle morceaux morcelé mors mot moteur motif motivation motiver
motivé mots mouvement moyen moyens moyeu multipliant muni munie munier munies munir munis munissez munit mur mutuellement mât mène mènent mènera
mèneront mètre mètres mécanisme médiane médiatrice mémoire méthode même mêmes n nacelle naturel neuf neufs neuve neuvième newton niveau noir noire
noires noirs nom nombre nommant nomme nomment nommer nommez nommons nommé nommée nommés noms normale norme normes normé normés nos notamment notation
note noter notons notre noté notée notées notés nous nouveau nouvel novembre noyau nul nulle nulles nuls numérateur numériquement numéro nécessaire
négatif négligé nôtre nôtres objectif objet objets obtenant obtenir obtenons obtention obtenu obtiendra occupe octobre offre offrent offrir on ont
onze opposée optique opère opèrent opérant opérateur opérer opérons opéré opérée opérés oral orange ordinaire ordonnée ordre organe orientation
origine orthogonale orthonormé oscille ou oublier outil outillage outils outre ouverte ouvrage ouvrant ouvre ouvrent ouvrer ouvrez ouvrir ouvrons
ouvré ouvrées ouvrés où page pages paire paires palette palettes palier panneau pantographe par par-dessus parabole paragraphe parallèle paramètre
paramétrage parce parcourt pareillement parent parfaitement parfois parler parlons parmi partager partant partent partez partie partir partis partons
partout parvenons parvient passage passant passe passent passer passez passons patiemment patience patte pattes paume pause peindre peint peinture
pelle penchant penche penchons penché pend pendant pentagone pente perce percer perceuse percevoir percez percé percée percés perd perdent perdu
perdue permet perpendiculaire perçage perçant pesanteur pese peser pesez pesé pesée pesées pesés petit petite peut peuvent peux phases photo
photographie photos phrases physiquement pied pignon pile piles pilotage piloter piloté pince pinces piste pivot pivotant pivote pivots pièce pièces
place placent placer placez placé placée placés plafond plafonds plan planaire plane planification planning plans plastique plat plateau plats plaçons
plein pleinement pliant plie plient plier pliera pliez plié pliée pliées pliés plongeons plupart plus plusieurs poids poignet point pointant pointe
pointillés points pointé polaire polycopié polygone polynôme pondéré porte portent porter porteur portez portique portons porté portée portés posant
pose posent poser posera poseront posez position posons possède posséder posture postérieur posé posée posées posés pouce poulie pour pourquoi pourra
pourrons poursuivons pourtant poussant pousse poussons poussée poutre pouvant pouvez pouvoir pouvons pratique premier première prenant prend prendre
prenez prennent prenons pression preuve primaire primes primitive pris prises prismatique prisme problème processeur prochain proche procède procédure
produit profil profondeur programmation progressivement projection projet propre propriété prothèse prototype prouvant prouver prouvons prouvé
provoquer près préalable préambule précis précède précédent prédiction prédire prédisez préférée préhenseur prémisse prémultiplie préparer présente
prévaut pu publié puis puisqu puissance puisse puissions pulsation pyramide python pédagogique pédalant pédale période pôles qu quand quant quarante
quart quarts quatorze quatre quatrième que quel quelconque quelle quelquefois quels question qui quinzaine quitte quoi quotidien quotient rabattu
rabattue raccourci racine radian raideur raison ralentir ramasser ramenant ramener ramenons ramené ramènent rang rangeant rangent rangeons ranger
rangez rangé rangée rangés rapide rappel rapport rarement rassemble rayon rayons recevoir recherche reconnaît recouvre reculant recule reculons reculé
redondance reformuler regarder regroupant rejoignent rejoindre relais relation relever relevons relevé relevée reliant relie relient relier relire
relisez relié reliées reliés relu relâche relève remarquable remercier remis remise remontant remplace remplies rencontre rend rendement rendent
rendez-vous rendons rendus rentrant rentrer rentrons rentrée repliant replier replié reportant repos repose reprend repris représente repère repérant
repérer repéré requis respectifs ressort ressource restant reste restent rester restes restez restons resté restée restés retenir retenons retenue
retourné retranchez retrouve revanche revenons revenu revient revoyons reçoit reçoivent reçu rigide rivet robot robotique rond ronde rondes ronds
rotation rotatoire rotoïde rotule roue roues rougissant roulant roule roulement roulent rouler roulez roulis roulons roulé roulée roulés routes
rubrique rugueux règle règlent règles réalisé récapitulatif récemment réciproque récrit récréation récupère récupérer récurrence réducteur réduire
réduisant réduite réel réflexion réfléchir référence région réglage réglant régle régler réglez réglons réglé réglée réglés régulateur régulièrement
réitère réitérer répertorie répond réponse répète répétabilité répéter répétons répété réseau réserver résidant réside résidé résolution résolvant
résoudre résout résultat résumant résume résumons résumé rétablir réuni réunies réunion réunir réunissent réunit réussi révolution réécriture rôle
rôles s s'écrit sa sachant saisie sait salle samedi satisfont saura saurons saute sautent sauvegarde savez savoir savons scalaire scanner scanné
schéma scolaire se seconde secteur section segment seize selon semaine semblable semestre sens sentir sentons sept septembre septième sera seras serez
seront serrant serre serrent serrer serrez serrons serré serrée serrés sert servent servira servomoteur servomoteurs ses session seul seule si sienne
signe signification similaire simple simplification simulateur simuler simulé singularité sinus situe situer situé sitôt six sixième socle soient
soigneusement soin soins soir sois soit soixante sol solidaire solide solution sommaire sommant somme sommes sommet sommons son sons sont sors sort
sorte sortent sortes sorti sortie sortir sortons soudain soudant soude souder soudure soudé soudée soudés souhaite soulever souligne soulève soumis
souple souris sous souscrit soustraction souvent soyez soyons spatiale sphère sphérique spirale spécifique statique stockant stocker stocké stratégie
strictement structure stylo subdivise substituant successivement sues suffisant suffit suit suite suites suivant suivent suivez suivi suivie suivis
suivons suivra suivre suivrons sujet sujets superposés support supposant supra supérieur sur surface surjective surligner surtout surveiller svp
symbole symétrique synchronisée système séance sécants séjourné sélectionné séparant sépare séparons séparément séquence série séries t-elle t-il ta
table tableau tablette tableur tabulé taille tandis tangage tangente tant tantôt tard tas taux tchat te technique tel telle telles tels temporel temps
tenant tendant tende tender tendez tendons tendu tendue tenez tenons tenseur tension tenu terme termes terminal tes testez texte thermique thèse
théorie théorème tiendra tiennent tient tiers tige tiges tirant tire tirent tirer tirera tireront tiret tirez tirons tiré tirée tirées tirés titre toi
tombe ton torche tore torse torseur torseurs torsion total totale totalité touchant touche touchons touché toujours tour tourelle tournant tourne
tournons tourné tours tous tout toute toutes tracent tracer tracez traction tracé tracée tracés traduction traduit trait traitant traite traitons
traits traité trajectoire tranche transformation translation transmet transposer transversal trapèze travail travaux travers traçant traçons treize
trente triangle triant trie trient trier triez trigonométrique trimestre tripler triplé trièdre trié triée triées triés trois troisième tronc trop
trouve trouvons trouvée trucs tu tutorat tâche tâches télescopique télécharger téléphone tôle tôt ultrason ultérieure un une unes uni unicité unie
unies unira uniront unis unissant unissent unissons unitaire unité unités université uns usine usuel usuelle utile utiles utilise va vacances vaille
valable valant valent valeur valoir valons variable varie vas vaudra vaudront vaut vecteur vectoriel veille venant vendredi venez venir venons
ventouse venu venue venus verra verre verrez verrons verrouillé vers versant vert verte vertes verticalement verts veulent veut vibrant vibre vibrent
vibrer vibré vides vidéo vidéos viennent viens vient vingt violet virgule virtuel vis vise visible visionner visite vissage visse visser visseur
visseurs vissé vissée vissés visé visée vite vitesse vocabulaire voici voie voient voilà voir voire voit volontiers volume vont vos votre voudrons
voulez vouloir voulons voulue voyage voyez voyons vrai vraie vrillé vu vue vues vus vérification vérin vérins week-end y zone zoome zoomer zoomez zéro
à à-dire çà écart écarts échange échantillonnage échelle échéance école écoles écoutant écoute écoutons écouté écran écrire écrit écriture écrivez
écrivons écrou écrous édition éduquer éduqué égal égalant égale également égaler égales égalité égaux élaboré élargir élastique électrique élevant
élever élevons éliminant élongation élu élégante élément élévation énergie énoncent énoncé énumère énumérer épais épaisse épaule épure équation
équilatéral équilibre équipant équiper équipé équivaut établi étage étages étaient étais était étalonner étant étape étapes étau éteindre étend
étendons étendre étendu étions étiquette étirant étire étirent étirer étiré étirée étirés étroit étude étudie étudié été évaluation évaluer évaluons
évalué évidemment évident évolution êtes être
prolongement prolonge tibia
"""
GERMAN = """
er sehr vor
heraus hinein raus rein
auszug misst mißt höchstens mindestens ab abbaut abbildung abend abends aber abermals abgabetermin abgeben abgeleitet abgeschlossen abgleichen ablauf ablegen ablegt ablegung ableiten
ablesen abmessungen abnahme absatz abschließen abschnitt absolut abstand abstände abstützung abszisse absätze abtastung achse achsen acht achte achten
addieren addition agenda akku aktiviert aktualisiert aktuator aktuell alle allem allen aller alles allgemein allmählich alphabet als also aluminium am
an analog andere anfang angeben angegeben angehängt angelenkt angenehm angenommen angeordnet angepasst angeschlossen angesetzt angetrieben angewandt
angewendet angewinkelt angezeigt anhalten anhand anhang ankathete ankündigung anlage anleitung anliegend anmelden annahme annehmen anordnung anpassung
anregung ansatz anschauen anschließend ansehen ansetzen ansicht ansteuerung anteil antrieb antwort anwenden anzahl april arbeit arccos archiv arctan
arcuscosinus arcussinus arcustangens arkuskosinus arkussinus arkustangens arm arme armen armes armlänge art arten artikel aspekte ast auch auf aufbau
aufeinander aufgabe aufgebaut aufgelöst aufgenommen aufgestellt aufgeteilt auflösen aufmerksam aufnahme aufrecht aufschreiben aufspannen aufstellen
aufteilen aufzeichnung aufzählung augenblick august aus ausblick ausdruck ausdrücke ausfahrlänge ausführlich ausgabe ausgangspunkt ausgeben
ausgedrückt ausgefahren ausgehend ausgeklammert ausgelegt ausgerechnet ausgestreckt ausgewertet ausgleichen ausklammern ausladung auslegung auslesen
ausmultiplizieren ausprobieren ausrechnen ausreichend ausrichtung aussage ausschub auswahl auswerten auswirkung auswählen auszug auszugs auszugslänge
außen außerdem außerhalb axiom bachelorarbeit bahn bahnen bahnkurve bald band basiert basis basiskoordinatensystem basissystem basisvektoren batterie
baue bauen bauende bauform baugruppe baut baute bauten beachten beantworten bearbeiten bedeutet bedient bedingung beenden befasst befehl befestigt
befinden begannen beginn begleiten begonnen begrenzt begriff begrüßung behandeln behauptung bei beiblatt beide beidem beiden beider beides bein beine
beispiel beitrag beiträge bekannt bekommt belegung beliebig bemerkung benachbart benannt benennen benutzen benötigen beobachten bequem berechnen
bereich bereit berücksichtigt beschleunigung beschreibt beschäftigen besitzt besonders besprechen besteht bestimmen bestätigt besuchen betrachte
betrag betreuer betriebspunkt beträgt beugung bevor bewegen bewegt bewegung beweis bewiesen bezeichnen beziehung bezogen bezug bezugspunkt bezüglich
bibliothek biegen biegt biegung bijektiv bild bilde bilden bilder bildet bildschirm bildung bindestrich bis bislang bist bitte bitteschön blatt blau
blaue blauen bleiben bleibt bleistift blick blockmatrix blöcke boden bogen bogenlänge bogenmaß bohrmaschine bolzen brauchen braun breit breite bremse
brenner bringen bringt brust buch buchstaben bzw bücher charakteristisch chirurgie code computer cosinus dabei dafür dagegen daher dahin dahinter
damit danach daneben dank danke dann daran darauf daraus darf darfst dargestellt darin darstellung darum darunter darüber das dass datei dateien daten
datenblatt datum dauer dauert davon davor dazu dazwischen deaktiviert decke decken deckt deckte deckung definiert dehnen dehnte dehnung dein deine
deklariert dem dementsprechend demnach demnächst demontiert den denavit denen denken denn denselben der derart deren derjenige derselbe des deshalb
desselben dessen deswegen detail determinante deutlich dezember dh diagonal dich dick die dienen dienstag dient dies diese dieselbe diesem diesen
dieser dieses diesmal differenz dimension dir direkt diskret dividieren dokument donnerstag doppelt dort dorthin dran drauf draußen drehachse
drehgelenk drehmatrix drehmoment drehung drehwinkel drei dreibein dreidimensional dreieck dreifach dreizehn dreißig drin drinnen dritte drohne druck
drucken druckte drücken durch durchführen durchlaufen durchmesser durchnummeriert durchqueren dynamik dämpfer dünn dürfen düse eben ebenda ebene
ebenen ebener ebenes ebenfalls ebenso echtzeit ecke ecken editor effektor eigene eigenschaft eigenwerte ein einander einbauen einbettung eindeutig
eine einem einen einer eines einfach einfluss einfügen einführen eingabe eingangs eingeben eingeführt eingeknickt eingesetzt eingezeichnet einheit
einige einleitung einmal einpassen einrichtung eins einsetzen einteilung eintrag einträge einzelne elastisch elektrische elemente elf ellbogen
ellenbogen empfehlen encoder ende endeffektor enden endgültig endlich endpunkt endstück energie eng entfernen enthalten enthält entlang entnehmen
entnommen entsprechend entsteht entweder entwickeln ereignis erfahren erfolgt erfüllt ergab ergaben ergeben ergebnis ergibt ergänzt erhalten erhält
erhöhen erhöht erhöhung erinnerung erkenn erkennbar erkennen erkennt erklären erkunden erläutern ermitteln ermöglicht erneut erreichbar erste
erstellen erstem ersten erster erstes erweitert erwähnt erzeugen es etwa etwas euch euklidisch exakt exkurs exoskelett experiment explizit exportiert
extrahieren fabriken fach fachhochschule fahre fahren fahrgestell fahrt fahrten faktor fakultät fall falten faltung fand fanden fangen farbe farben
fasst februar feder federn feierabend fenster ferien ferner fertig fest feste festen festes festgelegt festlegen feststehend figur filtern finde
finden findet findung fingern flach flache flansch fließt fläche folge folgen folglich folgt folie folien form formel fortfahren fortgesetzt
fortsetzen foto fotos frage fragen fragestellungen fragt fragte frei freie freien freiheit freitag freiwillig freuen fräse früh früher frühjahr
funktion fuß fußboden fußes fußpunkt fächer fälle fällen führen führt fülle füllen füllt füllte füllung fünf fünfte fünfzig für füße gab gaben gangbar
ganz ganze ganzen geben gebeugt gebeugte gebildet gebogen gebracht gebraucht gebräuchlich gedanken gedreht geeignet gefaltet gefaltete gefundenen
geführt gegeben gegen gegend gegenkathete gegenseitig gegenüber gegliedert gehabt gehe gehen gehenden gehoben geht gehäuse gehört geknickt gekonnt
gekoppelt gekreuzt gekrümmt gekürzt gelb gelbe gelegenheit gelenk gelesen geliefert gelten gemeinsam gemessen gemischt gemäß genannt genau genaue
genauso geneigt genug genutzt genügen genügt geometrie geprüft gerade geradlinig gerechnet gern gerne gerundet gesamt geschafft geschieht geschlossene
geschrieben geschwindigkeit gesehen gesenkt gesetz gesichtspunkt gespannt gespeichert gesprochen gestartet gestell gestern gestreckt gesucht geteilt
getrennt getriebe gewesen gewicht gewinnen gewonnen geworden gewählt gewöhnliche gewünscht gezeichnet gezeigt gezogen gibst gibt gilt glas glatt
gleich glied glieder gliedlänge glieds globale glätten glättung grad grade grafik grafisch grau greifer greifpunkt greift grenze grenzt grenzwerte
griechischen groß großbuchstaben große großen großer großes grund grundfläche grundlage grundstellung gruppenarbeit größe größen größer größte grün
grüne grünen grüße gut gänzlich gültig habe haben habt halb halbe hallo halte halten haltung hand handbuch handelt handfläche handgelenk handout
handwurzel hat hatte hatten haupt hauptdiagonale hausaufgabe hebe hebel hebelarm heben hebt hebung heft hefte heften heißen heißt helfe helfen helft
herab heran herangezogen herauf herausfinden herbst hergeleitet herkömmlich herleiten hersteller herum herunterladen hervor herzlich herzuleiten heute
hier hieran hieraus hierbei hierdurch hierfür hierhin hiermit hierzu hilfe hilfreich hilfs hilfsgröße hilfsvariable hilfswinkel hin hinab hinauf
hinaus hindernis hinein hinsichtlich hinten hintereinander hinunter hinweis hinzu hoch hochachse hochschule hoffen hohe hohen hoher homogene
horizontal hub hubachse hubhöhe hubs hundert hydraulisch hyperbel hälfte hänge hängen hängt hängte hängung höhe höhen höre hören hörende hörsaal hört
hörte hörten hüfte hüften idee ihm ihn ihnen ihr ihre ihren ihrer ihres im immer implementiert implizit in inbetriebnahme indem indirekt industrie
info ingenieur inhalt injektiv inkrement innen innere innerhalb insbesondere insgesamt installieren interessant inverse invertieren inzwischen
isolieren ist jacobi januar jede jedem jeden jeder jedes jene jenen jener jenes jetzt jeweils juli juni justieren kabel kalender kalibrierung kam
kamen kamera kann kante kanten kapitel kardanisch karte kartesisch kategorie kegel kegels keine kennen kennt kennzeichnen kern kette ketten kilogramm
kinematik kinetisch kippachse kippen kippt klar klasse klassisch klein kleinbuchstaben kleine kleinste klicken knickarmroboter knicken knickt knie
knopf knöchel koeffizienten kolben kollinear kollision kombination komma komme kommen kompakt kompass kompensieren kompiliert komplett komponente
konfiguration konkrete konnte konsole konstant konstruieren kontinuierlich konvention konvergiert konzentrisch konzept koordinate kopieren kopplung
korollar korrekt kosinus kraft kran kreide kreis kreisbogen kreise kreislauf kreisring kreisringes kreisrings kreisscheibe kreuz kreuzprodukt kräfte
krümmen krümmt krümmung kugel kugelgelenk kugelig kugelkoordinaten kugeln kunststoff kupfer kurbeln kurs kurse kurve kurven kurz kurze kurzen kurzer
kurzform kurzschreibweise können körper kümmern künftig kürzen kürzer labor labore labortermin lage lagen lager lagerhalle lang lange langen langer
langsam laptop lassen lasten lateral lauf laufe laufen laufzeit lauten lautet leeren leerte legen legt lehrbuch lehrbüchern lehre lehren lehrsatz
lehrstuhl lehrt lehrte leicht leisten leistung leiten leitet lerne lernen lernt lernte lernziel lese lesen lesend lest lesung letzte letztlich lich
liefern liege liegen liegt liest ließen lineal linear linie linien link linke linken linker links liste listen literatur logik logischerweise lokal
lokale lokalisiert lotrecht läge länge längen längs längsachse längsrichtung lässt läuft lösbar löse lösen lösende löste lösten lösung machen macht
mai man manipulator mappe markieren maschine masse massen masterarbeit material mathematik matrix matrizen maximieren maß maße maßen mechanik mehr
mehrdeutig mehrere meist meisten menge mengen menü merkblatt merken messen messung messwerte meter metern methode mikrocontroller millimeter millionen
millisekunde minimieren minute mit mitarbeiten mithilfe mithin mitschrift mittag mitte mittels mittlere mittwoch modell moderne modifiziert modul
moment monat monate montag montiert morgen motivation motiviert motor motoren multiplizieren muss musterlösung märz möglich mündlich müssen nach
nachdem nacheinander nachfolgend nachlesen nachmittag nachprüfen nachrechnen nachschlagen nacht nachweis nah nahm nahmen namen natürlich navigieren
neben nebenbedingung negativ nehmen neige neigen neigt neigte neigung nenne nennen nenner nennt nennung netzteil netzwerk neu neue neuen neuer neues
neun neunte nimmt noch nochmal nocken normiert notation notwendig november null nullstellen numerisch nummer nun nunmehr nutzen nutzlast nutzt nächste
nämlich nötige nützlich oben oberarm obere oberen oberer oberes oberfläche oberhalb oberschenkel oberste obige obigen obiger objekt oder offen
offenbar offene offenkundig offensichtlich oft ohnehin oktober online optimierung optisch ordinate ordnen ordner ordnung orientierung original ort
orte orthogonal ortsvektor ostern paar paare paarweise parabel parallel parameter passiert pause pfad pfade pfeil pfeile phasen physikalisch plan
planar planen plattform platz platziert pleuel plätze polarkoordinaten polynom portal posen positiv praktikum praxis prinzip prismatisch probieren
produkt produziert programm projekt projizieren prothese protokoll prozessor präsentation prüfen prüfung punkt punktes punkts pyramide pythagoras
pünktlich quadrat quadrieren quaternion quelle quelltext quer querachse querrichtung quiz radien radiergummi ragen ragt rahmen rand rang raum raupe
realer realisiert rechenregeln rechnen rechnung rechte rechts rechtwinklig reduzieren regel regele regelmäßig regeln regelt regelung regler regulär
reibung reichen reicht reichweite reihe reihenfolge rein reine reinigung relais relativ repositorium repräsentiert respektive rest restliche reziprok
rhythmus richten richtig richtung rief riemenscheibe ring ringe ritzel roboter roll rolle rollen rosa rotation rotatorische rotieren ruhelage ruhig
rumpf rund runde runden räder ränge räumlich rüber rückblick rücken rückmeldung rückwärts sah sahen sammeln samstag samt satz satzes schaltet schar
scharnier schaubild schauen schaufel schaut scheibe schema scherung schicht schicken schieben schiene schlagwort schließlich schlitten schluss
schlüssel schmal schneiden schnell schnittpunkt schon schraube schreibt schritt schräg schub schubgelenk schule schulter schweißen schwenk schwer
schön sechs sechsachsig sechseck sechste segment sehe sehen sehenden seht sei seid seien sein seine seinen seiner seit seite seiten seitlich sekunde
selbe selben selber selbst semester seminar sende senden sendung senken senkrecht senkt senkte senkung sensor september sequenz seriell setzen setzt
sich sicht sie sieben siebten siehe sieht simulation simulieren sind singulär sinkende sinngemäß sinus sinussatz sitze sitzen sitzt sitzung skalar
skizze skizziert skript so sobald sockel sodass soeben sofort software sogenannt solche soll somit sommer sonntag sorten sowie sowohl spalte spannend
spannt spannung spaß speichern sperren sperrt sperrung spezialfall speziell spezifisch sphärisch spiegeln spielen spielt spindel spirale spitze
sprache sprechen spur später stab stabil stahl stammfunktion stammt standen stange stapeln starr starre start starten statik statisch stecker stehe
stehen steht steifigkeit steigen steigt steigung stelle stellt stellung stetig steuerung stichwort stift stimmen stimmt stoppen stoppt strecke strom
struktur ströme studium stufe stunde stäbe stück stückchen stückweise stützen subtrahieren suche suchen sucht suchte summe summen symbolisch
symmetrisch system sämtliche sätze säule säulen tabelle tafel tag tage tagesordnung takt tangens taschenrechner tastatur taste tausend tcp teil
teilaufgabe teile teilen teilnehmer teilproblem teilschritt teilstück teilsystem teilt teilte teilung teleskop teleskopachse term terme termin testen
thema themen theorem theorie thermisch tief tiefe tiefen tipp tipps tisch titel tool tragen trajektorie transformation translation transponierte
trapez treffen trennen trennt trennung trete treten tritt trägheit trägt tun tutorium typ typen typisch uhr ultraschall um umbauen umbauten umblättern
umdrehungen umfahren umfang umfasst umformen umgebung umgeformt umgekehrt umgeschrieben umgesetzt umgestellt umkehrung umlauf umlegen umrechnung
umschreiben umstellen umwandeln unabhängig unbekannte und unendlich universität unmittelbar uns unser unsere unten unter unterarm unterbrechung untere
unterhalb unterlagen untermatrix unterricht untersucht unterteilt urlaub ursprung ursprünglich variable vektor verallgemeinern veranschaulicht
verbindet verbunden vereinfachen verfahren verfolgen verformung verfügbar vergleich verglichen vergrößert verhalten verhältnis verkabelung verkettet
verkleinert verknüpfen verkürzt verlauf verlängert verläuft verringert verschieben versetzt verstehen versuch verteilt vertiefen vertikal verursacht
vervollständigt verweis verwenden verzeichnis verzögerung vgl vibriert video viel viele vieleck vielen vieles vielfache vier vierfach vierte vierzig
voll vollends vollständig vom von voneinander vorangehende voraussetzung vorbereiten vorderarm vorgang vorgeben vorgegeben vorgehen vorgestellt
vorhanden vorher vorhin vorlesung vorliegen vormittag vorn vorne vorschau vorstellen vorteil vortrag vorwort vorwärts vorzeichens vorzugehen völlig
waagerecht waagrecht wagen wahl wahr wand wandern wann war waren warten warum webseiten weg wege wegen weihnachten weil weise weisen weist weit weiter
weiß weiße welche welle wellen welt weltkoordinatensystem weltsystem wem wen wende wenden wendet wendt wendung wenige wenn werden werdet werkstück
werkzeug wert werte wertebereich werten wertes wesentlich wessen wichtig widmen widmung wie wieder wiege wiegen wiegt wiegte willkommen winkel winter
wir wird wirken wirkt wirkung wirst wissen wo wobei woche wochen wodurch wofür wogegen woher wohin wollen womit wonach woran worauf woraus worden
worin wort worte wortschatz worum worüber wovon wozu wurde wurden wurzel wähle wählen wählt wählte während wälzlager wörter wünschen würde würfel z
zahl zahlen zahnrad zahnriemen zahnräder zahnstange zehn zehnte zeichenkette zeichnung zeige zeigen zeigt zeigte zeile zeilen zeit zeitabhängig
zeitgleich zeitlich zeitplan zeitpunkt zeitraum zelle zentral zentrum zerlegen zerteilt zettel ziehe ziehen zieht ziehung ziel ziele zielen zielpose
zielpunkt zielsetzung zielt zielte ziffer zitat zitiert zog zu zuallererst zudem zueinander zuerst zugehörig zugeordnet zugänglich zuletzt zum zunahme
zunächst zuordnen zur zurück zusammen zusatzaufgabe zustand zusätzlich zuvor zuwendung zwanzig zwar zweck zwecke zwei zweiargumentige zweidimensional
zweig zweige zweigliedrig zweimal zweite zwischen zwölf zyklus zylinder zählen zähler zählt ähnlich äquivalent äste äußere öffne öffnen öffnung öfter
übe üben übenden über überblick überein überführt übergang übergehen überlagerung überlegen übernehmen übernommen überprüfen überschreiten übersicht
übertragen üblich übrigen übt übte übung übungen übungsblatt
verlängerung oberarms unterarms
"""
SPANISH = """
dan eso unas unos valen
complementarios suplementarios
angulo angulos numero posicion rotacion traslacion articulacion eslabon a abajo abarca abarcó abduccion abducción abierta abordar aborde abordo abordó abra abramos abran abre abren abriendo abril abrimos abrir abriremos
abrirá abrió abro abscisa absorbiendo abstracta acaba acabado acabamos acaban acabar acabe acabemos acaben acabo acabó accesible acceso acciones
acción aceleración acerca acero acimut acompaña acoplada acostumbra acotado activa activen actividad activo activó actuador actúa actúan acumulada
adapta adelante además adentro adición adjunto admite adonde adopta aducción adyacentes adónde afrontar afuera agarra agarre agarro agarró agenda
agosto agradecer agregamos agrego agregó agrupa agrupando agrupen agrupó ahora ahí aisla aislación aislada aislamos aislando aislar ajusta ajuste
ajusto ajustó al alcance alcanza alfabeto algebraica algunas algunos algún alimentación alinea almacenamiento almacén alrededor alta altas alto altos
altura aluminio alumnado amarillo ambas ambos amplitud analice analizar analítica ancha ancho androide anexo angular anillo anota anotaciones anotado
anotamos anotando anotar anoten anotó ante antebrazo antecedente anterior antes antihorario antorcha antropomórfico análisis análoga análogamente
apagar aparato aparece aparecen aparezca apartado aparte apilados apilan apilar aplica aplicamos aplicando aplico aplicó aplique aporte apoyada apoyo
apoyos aprender aprovechamos apunta apuntes apunto apuntó apéndice aquel aquellos aquél aquí archivo archivos arcocoseno arcos arcoseno arcotangente
aristas arma armónico arranca arriba articular artículo asigna asigne asigno asignó asimismo asistan asiste asistir asisto asociada asocie asocio
asoció aspectos asume asumiendo asumimos así asíntota atención atornillado atravesar atrás aula aulas aumento automática automáticamente automático
autovalor autovectores autómata auxiliar avanza avanzo avanzó aviso axioma ayer ayuda ayudado ayudamos ayudan ayudar ayude ayudemos ayuden ayudo ayudó
azimut azul azules aísla añadamos añadan añade añaden añadido añadiendo añadimos añadir añadió aún baja bajada bajado bajamos bajan bajando bajar
bajaremos bajaron bajará bajas baje bajemos bajen bajo bajos bajó baricentro barra barras base bases basta bastan bastidor batería biblioteca biela
bielas bien bienvenida bisagra bisectriz blanca blanco bloque bola bolígrafo boquilla borde bordes botones botón brazo brazos breve brevemente brújula
bucle bucles buscada buscamos buscando buscar busco buscó básica básicos búsqueda cabeza cableado cada cadena cadera caja calcula calculando
calendario calibración cambiar camino cantidad canónica capa capacidad capas capítulo cara característica caras carcasa cardán carga cargado cargamos
cargando cargar cargas cargo cargó carpeta carrera carro carros cartel cartesiana caso catetos cazo cenital centra centro centrémonos cero cerrada
cerramos cerrando cerrar cerremos cerro cerró charla chasis ciclo ciclos cien ciento cierra cierre cierro cierta cierto cifra cifras cilindro
cilíndrico cinco cincuenta cinemática cinética circulo circunferencia cita citación citada citado citamos citan citando citar citaremos citaron citará
cito citó cizalla clara claramente clase clases clasificación clave clic clásica cobre cociente codificador codo coeficiente coincide colaboración
colapsa colgando colineales colisión coloco colocó coloque color columna coma comando comandos comas combinando comencemos comentarios comenzar
comienza como comparando compilación complejo compone componente comportamiento comprender comprobar comprueba compuesta computador común con
concatenar concentremos concuerda concéntricos condición conduce conecta conexión configuraciones congruente conjunto conmigo conmuta cono conocer
conocida conos conque consecuencia considera considerando consigue consiste consola consta construir consultar contempla contenido contiene contigo
continuación control convención convierte coordenada copiar corchetes corolario corramos correas correcta corredera correderas correo correrá
corresponde corrida corriente corrimiento corta cortado cortamos cortan cortar cortas corte cortemos corten corto cortos cortó cosa cosas coseno
costado crea creación creada creado creamos crean creando crear crearemos crearon creará cremallera creó cronometrados croquis cruce crucemos crucen
cruz cruza cruzada cruzamos cruzando cruzar cruzó cuaderno cuadrado cuadriláteros cuadro cuadrática cuadrático cuadrúpedo cual cuales cualquier cuando
cuantas cuanto cuarenta cuarta cuarto cuaterniones cuatro cubo cubos cubra cubran cubre cubren cubria cubriendo cubrimos cubrir cubrió cuchara cuenta
cuerpo cuestionario cumple cumplir curiosidad curso cursos curva curvado curvas curvo cuya cuyas cuyo cuyos cuál cuáles cuándo cuántas cuánto cálculo
cámara círculo código cómo cómoda cómodo cómputo cónico dada dadas dado dados damos dando daremos dará datos de debajo debe debida debido decimal
decimos decir decremento dedo dedos deducción deduce deducimos defina define definir defino deja dejación dejada dejado dejamos dejan dejando dejar
dejaremos dejaron dejará deje dejemos dejen dejo dejó del delante delgado demos demostrar demuestra demás denomina denominador denota densidad dentro
depende dependen depositar derecha derecho derivada desacoplamiento desacople desacoplo desarrolla descargo descompone describe descuenta desde desea
deseada deseamos desfase designó desliza desmontar despacio despejando despejar desplaza después destaca destino destornillador detallada
detenidamente determina detrás dh diagonal diagrama diapositiva dibujar dibuje dibujo dibujó diccionario dicha dichas dicho dichos diciembre diciendo
diez diferencia difieren digamos digital dimensión dimos dinámica dio dirección directa directamente directo diremos dirige dirigido dirija dirije
dirijo dirá discos diseñar diseñe diseño diseñó disminución disponible dispuesta distancia distinto divida divide dividiendo divido división diámetro
dobla doblado doblamos doblando doblar doble doblen dobles doce docencia documento domingo dominio donde dos doy dron duración durante dé décima
décimo día días dígito dónde ecuación edición editor efectivo efector efectuando efectúa eficiente eje ejecución ejecutar ejemplo ejercicio ejes el
elabora elección electrónico elegida elegimos elegir elemental elemento eleva elevación elevado elevamos elevando elevar elevemos elevó elige eligen
eligiendo eligió elimina eliminar elipse ella ellas ello ellos eléctrico embebido empecemos empezar empezemos empezó empieza emplea empleamos emplee
empleo empleó empotrado empujar empuje empujo empujó en encendido enchufe encima encoder encogen encogió encontramos encuentra energía enero enfoque
enfrente engranaje enlace ensamblaje ensayo enseguida enseñanza enseñe enseño enseñó entender entera entero entiendo entonces entorno entra entradas
entran entrar entre entrega entremos entren entro entró enumera enunciado enviado enviamos enviando enviar enviemos envien envio envió envía equipo
equivale era eran eres es esa esas esbozo escalar escogemos escogido escribe escribimos escuchar escuela esencial esfera esfuerzo esfuerzos esférica
eslabones eslabón esos espacio especial específica espera espiral esquema esquina esta estaba establece estacionario estado estamos estandar estaremos
estará estas este estirado estire estiro estiró esto estos estoy estrategia estrecho estructura estudia estuvo está están estándar estática esté estén
etapa etapas etiqueta euclidiana evaluar evaluó evalúa evasión exactamente exacto examen examinar excavadora existe exoesqueleto expande expandiendo
experimento explica explícita exponer exportación expresa expuesto extendida extensión exterior externa extrae extraen extraída extremo fabricante
factor falta fase fases favor febrero fecha fichas fichero figura fija fijación fijada fijado fijamos fijan fijando fijar fijaremos fijaron fijará
fijas fije fijemos fijo fijos fijó fila filas filtrar filtre filtro filtró fin final finales finaliza finalmente finita finito fino fisica flecha
flexionado flexión flujo forma forman formar formas formato foro foto fotografía fotos fracción frase frases frecuencia freno frenos frente fresadora
fricción frontal fue fuente fuera fueron fuerza fuese fuimos funcionamiento funciones función fábrica fácil fáciles fácilmente fémur física físicas
físico físicos fórmula garantizando garantizar garra general genere genero generó genérica genérico geometría geométrica gira giran girar giro giros
globales goma gracias grado grados gravedad griega griego gris grueso gráfica grúa grúas guardar guarde guardo guardó guion gustado gustamos gustando
gustaron guste gusten guía guías género haber habiendo habla hablado hablamos hablando hablar hable hablemos hablen hablo habló habremos habrá habrán
había hace hacemos hacen hacer hacia haciendo haga hagamos hagan hago hagámoslo halla hallada hallamos hallando hallar halle hallemos hallen halló han
haremos hasta hay haya hayamos hayan hecha hechas hecho hechos herramienta hexágono hexápodo hiciera hicimos hidráulico hipotenusa hipérbola hipótesis
historia hizo hoja hojas hola hombro homogénea homotecia hora horario horas horizontales hoy husillo hélice icono idea ideas identidad idioma idéntica
igual igualando igualdades iguales igualmente igualó imagen implementa implica implícita imponiendo importante imprimir impuesto imágenes inclinación
incluir incluye incorpora incógnita independiente indica industria inercia inferior informe ingeniería inicial inicialmente inicie inicio inició
inmediata inscripción insertar instalar integrando interesante interior intermedia interna intersección interés introdujo inversa invertido invertir
invierno invirtiendo involucra inyectiva ir iremos isometría isotrópica itera iteraciones itinerario izquierda jacobiana jueves julio junio juntado
juntamos juntan juntar juntemos junten junto juntos justificación la laboratorio lado lados lagrange larga largas largo largos las latitud lazo le
lecciones lección lectura lee leemos leer lejos lema lenguaje lentamente letra letras levanta ley leyes liberen libertad liberó libre librería libres
libro libros ligada limpian limpie limpió lineal liso lista listado listan listar listas listen listo llama llamada llamamos llamando llamar llame
llamemos llamen llamo llamó llave llaves llega llegada llegamos llegan llegar llego llegue llegó llena llenado llenamos llenan llenar llene llenemos
llenen lleno llenó lleva llevado llevamos llevan llevar lleve llevemos lleven llevo llevó lo local localización logra logrado logramos logran lograr
logre logremos logren logro logró longitud los lote luego lugar lugares lunes lápiz láser límite línea líneas lógicamente madera magnético maneja
maneje manejo manejó manera manipuladores mano manos mantiene manualmente mapa marca marcación marcado marcamos marcan marcar marco marcos marcó
martes martillo marzo masa masas matemática matemáticamente matemáticas matemático material matrices matriz mayo mayor mayúsculas mañana mecanismo
mecánica mecánico mecánicos mediante mediatriz medición medida medido medimos medio medios memoria mencionar menor menores menos mensaje menú mes mesa
mesas meses meta metas metro metros mide miden miembro mil milisegundo millón milímetros minuto minúscula mira mirada mirado miramiento miramos miran
mirando mirar miraremos miraron mirará mire miremos miren miro miró misma mismas mismo mismos mitad mitades mixto mixtos miércoles modelar modelo
modifica modos momento monta montada montaje montamos montar monto montó montón mostrar mostremos mostro mostró motivación motive motivo motivó motor
motores mover movimiento mucha muchas mucho muchos muelle muestra mueve mueven multiplica mundo muslo muslos mutua mutuo muñeca máquina más máxima
máximo método mínima mínimo módulo móvil móviles múltiples naranja natural navegador necesaria necesita negativa negativo neumático neutra neutral
nivel niveles noche noción nodos nombrado nombró norma normal normalmente nos nosotras nota notación notas notemos noviembre nuestro nueva nuevo nula
nulo numerador numérica nótese número objetivo objeto oblicuo observar obstáculos obsérvese obtención obtenemos obtener obtenga obtenida obtiene
obtuvo obviamente ocasiona ocasión ocho octavo octubre ocupa ocurre opciones opción operable operación operador operamos operando operar operen
opuesta opuesto oral orden ordenada ordene ordeno ordenó orientación origen ortogonal ortonormal oruga orígenes oscila osciló otoño otra otras otro
otros oímos pala palabras palma pantalla pantorrilla pantorrillas par para parada parados paralela paramos paran parando parar pararemos pararon
parará parcial pared paremos pares paro parte particular partida partimos partir parto parábola parámetros paró pasa pasador pasamos pasan pasando
pasar pasaremos pasaron pasará pase pasemos pasen paso pasos pasó pata patas pausa pedazo pedestal pedir pendiente perfil periodo permanece permiso
permite perno pero perpendicular perímetro pesa pesada pesado pesan pesando pesaron pesará pese peso pesos pie pierna pies pieza piezas pila piloto
pinza pirámide piso pistón pitágoras pizarra piñón plan plana planar planas planificación plano planos planta plantea planteamiento plantilla
plataforma plazo plegable plegado plegamiento plegar plenamente pliegue pluma plumas plástico poca pocas poco pocos podemos podido podremos podrá
podrán polares polea poleas polinomio polígono pondremos pondrá ponemos ponen pongamos pongan pongo poniendo por portátil posee poseer posibilidad
posible posición positiva positivo posmultiplicando posterior postura potencia practique precedente pregunta preparar presenta presión previa previo
primario primavera primer primitiva principal prismática probado probamos probando probar probemos problema probó procede proceso producto produzca
profundizar programa progresivamente pronto propia propiedad propio propone proporciona propuesto propósito prototipo proyecciones proyección proyecta
prueba pruebe pruebo práctica prólogo prótesis próxima publicado pudiendo pudimos pudo pueda puedan puede pueden puedes puedo puerta pues puesta
puesto pulgar pulsación punta puntas punto puntos pura puras puro página párrafo pórtico que queda quedan quedando quedaron queremos querer querido
quiera quiere quiero quinto quisimos quitando qué químico rad radial radianes radio radios raiz rama rango rangos ratón razonamiento razones razón
raíces raíz reagrupación realiza receta recibe recoge recogidos reconocimiento recordar recta rectas recto rectos rectángulo recuerda recuperar
recurre recurso recuérdese recíproca red redactar redefinir reduccion reducción reduce reducida reductor reemplazando reescribe reescribiendo
referencia refiere refleja reflexión regiones región regla reglas regresa regulación regule reguló relación rellena relé remache rendimiento renglón
reordena repasar repasemos repaso repasó repetir repita repite repitiendo repito repositorio representa representan reserva resolución resolver
resorte respecto responde respuesta resta restamos restando restar resto resuelta resuelve resulta resultado resultante resuma resumen resumida
retardo retomar retroceder reunamos reunan reunen reunido reuniendo reunimos reunir reunión revolución riel rieles ritmo robot robots robótica
rodamientos rodea rodeado rodeamos rodean rodear rodeen rodeo rodilla rol rombo rosa rota rotación rotada rotado rotamos rotan rotando rotar rotativa
rotatoria rueda ruedas ruta rutina rápidamente rápido rígida rígido rótula sabe sabemos saber sabido sabiendo sabremos sabrá sabíamos sacamos sacar
sala sale salen salida salido saliendo salimos salir salió saludos se sea sean secciones sección secuencia secundaria segmento seguida seguimiento
segunda segura seguro seguros según seis selección semana semejante semestre sencilla sendas sendos seno senos sensor sentido sepa sepamos separa
separe separo separó septiembre ser serie servomotor servomotores será serán sesenta sesiones sesión sexta sexto señal señala señales señalo señaló si
sido siempre siendo siete sigamos significa signo signos sigue siguen siguiente siguió simbólica simetría similar simple simplifica simulador simule
simultáneamente simuló singular sintetizar sistema sitio sitios situación situado situar sitúa sobre software soldador soldando soldar solidaria
solucion soluciones somos son soporte soy su suave suavemente suavizar suba subamos suban subcadena subcadenas subconjunto subdivide sube suben
subespacio subida subido subiendo subimos subir subiremos subirá subió submatriz subo subproblema subrayar subrobot subsección subsistema sucesiva
suele suelo suficiente sujeta sujete sujeto sujetó suma sumada sumamos suman sumando sumar sumaron sumará sumas sumemos sumo sumó superen superficie
superior superíndice supongamos supóngase surge surgen surgido surgiendo surgimiento surgir surgió sus sustitución sustituir sustituyendo sábado sé
séptimo sólido tabla tablas tablero tablet tal taladro tales taller también tangencial tangente tanta tantas tanto tantos tarde tardes tarea tareas
tarjeta te techo teclado teléfono tema temario temas temporal tendremos tendrá tenemos tener tenga tengamos tengan tengo tenida tenidos teniendo
tensiones tensión tensor tenía teníamos teorema teoría tercer tercio tesis texto textos teórico ti tiempo tiene tienen tipo tipos tiza tobillo toda
todas todavía todos toma tomada tomado tomamos toman tomando tomar tomaremos tomaron tomará tome tomemos tomen tomo tomó tope tornillo torno torque
torre torsión total totalidad totalmente trabajo traducción trae traemos traer traigo trama tramo tranquilamente transforma transponer trapecio tras
traslada traspuesta trata tratamiento tratan tratará tratemos través trayectoria traza trazado trazamos trazando trazar trazo treinta tres
tridimensional triedro trigonométrica trimestre triples triángulo tronco trozo trozos tuerca tuercen tutoría tuvimos tuvo térmico término típicos tú
ubica ubicación ubicada ubicamos ubican ubicar ubicó ubique ultrasonido un una unamos unan unen unida unidad unidas unido unidos uniendo unimos
uniones unir uniremos unirá unirán unitario universidad unió unión usamos usando usar usaremos usará usual usuario utiliza vacaciones vaciado
vaciamiento vaciando vaciar vacio vacío vale valer valor valores van vara variable varilla varía vas vaya vayamos vea veamos vean veces vector veinte
velocidad vemos vendrá venga vengan venimos venir ventaja ventana veníamos veo ver verano verdadero veremos verifica verificación verificamos vertical
verán vez veámoslo vibra vibraciones vibrador vibrando vibrar vidrio viene viernes vimos viniendo vino vio visita vista vistas visto vocabulario
volvemos volveremos volviendo volúmenes vosotros voy vuelta vuelve válida válido vástago véase vértice vía vídeo vídeos vínculo x y ya yace yo yugo
zona zonas ángulo ánimo árbol árboles área áreas él émbolo éramos ésa ése ésos ésta éstas éste éstos índice óptico órdenes última último única único
útil útiles
prolongación prolonga
"""
ITALIAN = """
danno dà seguono
a abbia abbiamo abbiano abbracci abituale accanto accelerazione accendere accessibile acciaio accoppiamento accorciare accuratamente ad addizione
adesso adiacente adottata adotterà adotti adotto adottò afferrato affinché affronta agenda aggiunge agisce agosto aiuta aiutano aiutare aiutato
aiuterà aiuti aiutiamo aiutino aiuto al alberi albero alcuna alcune alcuni alfabeto algebrica alimentare alla allegato allineati allora alluminio
allungare altezza alti alto altra altre altresì altri altro alza alzando alzano alzare alzarono alzata alzate alzati alzato alzeranno alzerà alzi
alziamo alzino alzo ambedue ammette ammortizzatore ampiezza analitica analizziamo analogo anca anche ancora andando andare andiamo andremo androide
angolare angoli angolo anno annotazioni annoto annotò antiorario anzitutto appartiene appena appendice applica appoggio apprendere approfondimento
appunto apra aprano apre apriamo apribile aprile aprire aprirà aprite apriti apro aprono arancione archi archivio arcotangente aree argomento arresto
arretrati arrivare arrivederci arrivi arrivo arrivò articoli ascendente ascoltare asintoto aspetto asse assegnata assi assioma assistere asta aste
astratto attenzione attiva attiverà attività attivo attivò attorno attraverso attrito attuatore auguri aula aule aumento automa autovettori autunno
avambraccio avanti avanzerà avanzi avanzo avanzò avendo avente aver avere avranno avremmo avremo avrà avuta avuto avvia avviamento avviando avviare
avviato avviene avvierà avvio avviso avvitamento azimut azionare azione azioni bacino banco baricentro basamento base basi basilare bassa bassi basso
bastano batteria battezzato benvenuti bianca bianco biblioteca biella binari binario bisettrice bloccata bloccato blocchi blocco bloccò blu bottone
braccia breve brevemente bullone bussola cablaggio cacciavite calcola calendario cambiamento camma cammino campionato campo capire capisco capitoli
caratteristica carcassa cardinale caricare carichi carico caricò carrello cartella cartesiana casi caso catena cavi caviglia cavo cento centri centro
cerca cercando cercare cercata cercato cerchio cerco cercò cerniera che chiamata chiamerà chiamiamo chiamo chiamò chiaramente chiarire chiave chiavi
chieda chiedere chiediamo chiedo chimico chiuda chiudere chiudiamo chiudono chiusa chiuso chiusura ciao ciascun cicli ciclo cifra cifre cilindro
cinematica cinetica cinghia cingolo cinquanta cinque cioè circa circonferenza cita citando citano citare citata citate citati citato citazione citiamo
cito ciò cliccare coda codesto codice coefficienti coincide collega collocò colonna colore colori combinando come comincia comoda comodo compatta
compilare compiti componente composta computer comune comuni con concatenando concentriamoci concetto condividere condizione conferma configurazioni
confronti coni conico cono conoscendo consegna considera consiste consolle conta contabile contano contare contemporaneamente contenuti conterà conti
contiamo continuare conto contributi controllo convenzione converrà coordinate copiare coppia coppie coprano copre coprendo copriamo coprire coprite
coprono corpi corpo correnti corretta corrisponde corsa corse corsi corsivo corso corsoio corta corti corto coscia coseno cosicché costante
costituisce costruire così creano creare crearono creata creati creato creazione crei creiamo creino cremagliera creò cronometro cubi cubo cui
curiosità curva curvare curvato curve curvo cuscinetto da dagli dai dal dall dalla dalle dare daremo darà data date dati dato davanti decimo dedicata
deduco definire degli dei del dell della delle dello denavit denominatore dentro depose deriva descrive desiderata designò destra determina detta
dettaglio dette detti detto devi di diagonale diametro diamo diano diapositive dicembre dicendo diciamo didattica dieci dietro differenza dimensione
diminuzione dimostra dinamica dipende diremo diretta direzione diriga dirige dirigibile dirigono disattivato discendente dischi disegno dispensa
dispone disposizione distanze distesa disteso dita dito diventa diverse divida divide dividono dizionario dobbiamo documentazione dodici dolcemente
domanda domani domenica dominio dopo dopodiché doppi doppia doppio dov dove dritta dritto droni due dunque durante durata dà e ecco ed editor efettore
effettore efficace egli elementi elencati elenchi elenco elettrica eleva elevando elevata elevazione elica elimina ella ellisse encoder energia entra
entrambe entrano entrare entrata entrerà entri entriamo entrino entro entrò equazione equivale era erano eravamo esagono escano esce esco escono
esegua esegue eseguita eseguono esempio esercizi esoscheletro espandere esperimenti esplicita esplorare esponenziale esporre esportazioni esposto
espressa esprime essendo essere essi estate estende estensione esteriore esterno estesa estese estesi esteso estrae estraggo estrai estrarre estratta
estremità evidente fa fabbrica facce facci faccia faccino faccio facendo facili facilmente facoltà fanno fare faremo farà fasi fatta fatte fatti fatto
favore febbraio fece ferma fermano fermare fermato fermerà fermi fermiamo fermino fermo fermò figura figure file filtrare filtri filtro finali finché
fine finestra finire finisce finita finiti finito fino fissa fissando fissare fissata fissazione fisse fisserà fissi fissiamo fisso flangia flessione
fogli foglio fondamentale forma formano formula fornire fornisce fornito forum forza forze fosse fossero foto fotografia fra frase frasi frazione
frecce freccia frequenza fresatrice fretta fronte fu funzione fuori furono gamba gambe ganasce gdl generale genere generi genero generò gennaio
geometria giacché gialla giallo ginocchio gioco giorni giorno giovedì gira giugno giunti giunto già gli gomiti gomito gomma gradi grado grafica gran
grandezza grandi gravità grazie greca greche greci greco grigio gru guardare guarderà guardi guardo guardò guida ha hanno ho i icona idea idee
identica idraulico ieri il illustrata immagine imparare imparerà impariamo imparo imparò impiego impilati implementata imponendo imporre imposto in
includono incognita incontro incrociato indica indice indichiamo indietro indipendente indirizzo industria inerzia infatti inferiore infine ingranaggi
iniettiva inizia inizierà inizio iniziò innanzitutto inoltre insegnamento inserendo inseriamo insieme installare integrale interamente interessante
interna interrompere intersezione intorno introdotto invece inverno inversa invertire invia inviando inviare inviato invii invio inviò io iperbole
ipotenusa ipotesi isola isolamento isolando isolato isoliamo isometria istante istanza iterazione itinerario jacobiana la laboratorio laddove larga
lascia lasciando lasciare lati latitudine lato lavagna lavorare lavorerà lavori lavoro lavorò le lega legame legate legati legato legga leggano legge
leggere leggi leggiamo leggibile leggo leggono legno lentamente lettere letti lettura leva leve lezione libera libererà liberi libero liberò libreria
libri libro limitata limite limiti linea lineare linee linguaggio lingue link liscio lista livello lo locale logicamente loro lotto luglio lunedì
lunga lunghezza lunghi lungo ma magazzino maggio maiuscola mandrino mani maniera manipolatore mano manovella mappa marca marcano marcato marce
marciamo marcisce marte martedì martello marzo massa masse massima matematica materiale matrice mattina meccanica medesimo mediante membri membro
memorizzare meno mensile mentre menzionato mercoledì mese mesi messa messaggio messe messi messo metodi metodo metri mette mettere mettiamo metto
mettono metà mezzi mezzo milione mille millimetri millisecondo minima minimo minuti minuto misti misto misura misure misuri misuro misurò mobile
modello modi modificata modo moduli molla molle molta molte molti moltiplica molto momento mondo monta montante montanti montare montati monti
montiamo montino mostrata mostrerà mostri mostro mostrò moti motivazione motivi motivo moto motore motori movimenti muove muovono mutua mutuo nasce
navigazione navigo navigò ne necessita negativa negli nei nel nell nella nelle nodo noi nominare nono norma normale nostra nostre nostri nostro nota
notare notazione note noti noto notte novembre nozioni nullo numeratore numerica numero nuova nuovo obiettivi obliquo occasione occorre officina
oggetto oggi ogni omogenea opera operabile operare operata operazione opererà operiamo operino oppure ora orale oraria orario ordine ordini ordino
ordinò ore organizza orientamento origine orizzontale ortogonale ortonormale oscilli osserva ossia ostacoli ottavo ottenere ottengono otteniamo
ottenuta ottico ottiene ottimizzare otto ottobre ove ovvero ovviamente pagina pagine pala pallettizzatore palmo pantografo parabola paragrafi
parallela parametri pari parla parlando parlare parlato parli parliamo parlino parlo parlò parola parole parte partecipazione partendo parti
particolare parziale passaggi passare passatore passi passiamo passino passo passò pausa pavimento pedice pedici penna pensiero per perché perciò
percorso perfino perimetro pertanto pesa pesando pesano pesare pesata pesate pesati pesato peserà pesi pezzi pezzo piacere piana piani pianificazione
piano piattaforma piatto piede piega piegamento piegando piegare piegata piegato pieghe pieghi pienamente pignone pila piloti piloto pinza pinze
piramide pistone pistoni pitagora più plastica poca poche pochi poco poi poiché polari poligono polinomio pollice polsi polso pomeriggio pone ponendo
ponga pongono poniamo porre porta portabile portale portamento portare portata porterà porti portiamo portino porto portò posa positiva posizione
possa possano possiamo possibile posso possono posta poste posti posto postura potenza poteva potranno potremo potrà potuto precedente prefazione
premoltiplicando prenda prende prendi prendo preparare presenta pressione presso presto prima primario primavera prime primi primitiva primo
prismatici problema procede prodotti profilo progetto programma progressivamente proiettando proiezione promemoria propone proposta proprietà prosegue
prossima prototipo prova provano provare provato proverà provi proviamo provino provo provocare provò pubblicato puleggia pulsante pulsazione punta
puntamento puntando puntare puntata punte punterà punti puntiamo puntino punto puoi pure può quaderno quadrati qualche quale quali qualsiasi qualunque
quando quanta quante quantità quanto quaranta quarta quarti quarto quattro quegli quei quell quella quelli quello quesito questa queste questionario
questo quindi quinto quotidiano quoziente raccogliendo raccolti radianti radice radici raggi raggio raggiunge raggruppando ragione rame rango
rapidamente rapporto rappresenta reali reazione reazioni regione regola regolerà regoli relativa relazione relè rende rendimento repository resta
restanti rete retta rettangolare rette riassunto ricava ricaverà ricaviamo ricavo ricavò ricerca richiamo richiesta riconoscimento ricorda ricorre
ridefinire riduca riduce riduciamo riducono riduttore riempe riempire riempono riepilogo riesca riesce riesci riesco riferita riflessione riga righe
righello rigidi rigido riguardo rileggere rimanda rimane ripasso ripeta ripetere ripetiamo ripeto ripetuto ripiegata ripiegato riportata riprendere
riquadro riscaldamento riscrivere risolta risolve risorsa rispetto risposta risulta ritardo ritmo ritroviamo riunione riunisce rivetto rivista rivolta
rivolto robot robotica rombo rosa rotazione rotoidale rotondo rotore ruoli ruolo ruota ruotano ruotare sabato sala saldando saldare saldati salendo
saliamo salire salirà salita salite saliti salito saluti salvare sanno sapendo sapere sappiamo sapremo saprà saputo saranno saremo sarà sbloccare
sbracci sbraccio scalare scaricare scegliamo scelga scelgono scelta scelto scenda scendere scendiamo scendono scheda schede schema schemi schermo
schizzo scollegato scomposizione scopi scopo scorre scorrevole scorrono scritta scrive scriviamo scrivono scuola se seconda segna segnali segnano
segnare segnato segnerà segniamo segue seguendo seguito sei selezionati semestre seminario semplice sempre seni seno sensi senso sensore separa
separerà separi separo separò sequenza sera serie sessanta sesta sesto sette settembre settimana sezione sfera sfere sferica sfili sfilo sfogliare
sforzi sforzo sfruttare si sia siano siccome simboli simile simili similmente simmetrica simulatore singolare sinistra sino sintetizzare sistema
situazione slitta slitte smontare smonti smonto snodi snodo soddisfa solidale solito sollevato soluzione somma sommando sommare sommiamo sommo sono
sopra soprattutto sorge sorgendo sorgere sorgono sostituire sottile sotto sottomatrice sottraendo sovrappongono spalla spalle spazi spaziale spazio
specifica sperimentale spesso spiegato spieghi spiego spiegò spigoli spinga spinge spingiamo spingono spinta spirale spostata sposterà sposti sposto
spostò sta stampare stampi stampo stampò stando stanno stantuffo stare stata state stati statica stato stava stazione stelo stenda stendere stendiamo
stendo stesa steso stessa stesse stessi stesso stiamo strati strato stringa struttura studia studio su sua subito successiva suddividere sugli sui sul
sull sulla sulle suo supponiamo sviluppando svolgere svolgimento svuotare svuoti svuoto tabella tablet tale tali tangente tanta tante tanti tanto
tarata tarati tarato tardi tastiera tavola tavolo te tecnica telai telaio telecamere telefono tempo tenendo tenere tensione teorema teoria teorico
teorie termine terna terne terza terzi terzo tesi testi testo tetto ti tiene tieni tipi tipica tipici tipo titolo torcenti torcia tornio torre totale
totalità totalmente tra traccia trae traiamo traiettoria tramite tranquillamente trapano trapezio trarre trasforma trasla trasposta trasversale
trattata trattino tratto trazione tre trenta triangoli triedro trigonometrica trimestre tripla triplo tronco trova trovano trovare trovato troverà
trovi troviamo trovino trovo trovò tu tutte tutti tutto ugello uguale uguali ugualmente ultima ultime ultimi ultimo ultrasuoni umanoide un una undici
unendo uniamo unire uniremo unisca unisce unisci uniscono unita unitaria unite uniti unito unità università uno usa usando usare usata usate usati
usato uso utensile utente utenti utile utili utilizza vacanza vada vado vale valgono valida valide validi valido valore valori valutata valuterà
valuti valuto valutò vantaggio varia variabile veda vedano vede vedendo vedere vediamo vedo vedono vedremo veduta vedute veduto velocemente velocità
venendo venerdì vengo vengono veniamo venire venti ventosa venuta venuto vera verde verdi verifica vero verranno verremo verrà verso versore verticale
vetro vettore vi via vibrano vibrare vibratore vibrazioni viene vincoli viola virgola visita vista viste visto viti vocabolario vogliamo voglio voi
volentieri volevasi volta volte volumi voluto vorrà vuole zampa zampe zeri zero è
prolungamento prolungato quota
"""
PORTUGUESE = """
até dá dão há isto seu
cima claro contas ficamos fundo isto num numa olhamos prever
anti-horário horário a abaixo aberta abordar abordem abordou abra abram abrange abre abrem abreviaturas abril abrimos abrindo abrir abriremos abrirá abriu abro acabado
acabando acabar acabe acabem acabo acabou aceleração acenda acender acendimento acendo acerca acesso acessível acha achamos achando achar acima
acionar acione acionou acoplada acrescentou ademais adiante adicionando adição adota adotado adotam adotando adotar adotem adotou afasta agarrar
agarre agarrou agenda agora agosto agrupando ainda ajuda ajudado ajudam ajudando ajudar ajude ajudem ajudo ajudou ajustes ajustou ajustável alcança
alfabeto algarismos algum alguns algébrica alimentar alinhada alinhe alinhou altas altos altura alumínio alvo além amanhã amarelo ambas ambos
amortecedor amostragem analisando analogamente analítica andar androide anexo angular anotado anotando anotações anote anotem anotou antebraço
anterior antes anti-horário análise análoga ao aonde aos aplica aplicou aplicável aplique aponta aponte apontou apostila aprender apresenta aprofundar
apêndice após aquela aquele aqui aquilo arbitrária arco arcotangente arestas armazenamento armazém arquivo arrancar arranjo artigo as aspectos aspeto
assim assistir associada assíntota atenção atinge atingir atinja ativa ativado ativam ativando ativar ativação ativem atividade ativo ativou atraso
atravessar através atribuição atrito atuador aula aulas aumento autovetores autômato avaliação avalie avaliou avançar avanço aviso axioma azuis azul
aço baixa baixada baixam baixando baixar baixe baixem baixo baixos baixou baricentro base bases bastam bastará bateria batizado batizou biblioteca
bico bielas binário bissetriz bloco blocos borracha botão branca branco braço braços breve brevemente busca básico bússola cabeamento cabeça cabo
cabos cada cadeia caderno calcula calendário camada came caminho caneta canto capítulo característica carcaça carregar carro cartesiana caso casos
cateto cem cento centro chama chamada chamamos chamando chamar chame chamem chamo chamou chassi chave chaves chega chegada chegamos chegando chegar
chego chegou chegue ciclo cilindro cinco cinemática cinquenta cinza cinzento cinética circunferência cisalhamento cita citada citado citamos citando
citar citaram citação citações citou claramente classe clicar clássica cobra cobram cobre cobrem cobrimos cobrindo cobrir cobriu coeficientes coincide
coisa coisas colaboração colchetes colineares colisão colisões colocando colocou coloque coluna com combinando comecar comece comecou começa começe
começou como compara compilação completa componente composição comprimento computador compõe comum comuns concatenando conceito concêntricos condição
conduzir configurações conforme conhecida conjunto connosco consequentemente considera consiste constante construir conta contam contando contar
contação conte contempla conteúdo continuar contornar contou controle contém contínua convenção convém coordenada copiar cor cores coroa corolário
corpo corpos correias corresponde correta corta cortado cortam cortando cortar corte cortem corto cortou cosseno cotovelo coxa cremalheira cria criada
criado criam criamos criando criar criaram criaremos criará criarão criação criações crie criou cronometrado croqui cruza cruzado cruzamento cruzando
cruzar cruzem cruzou cubo cubos cuja cujas cujo cujos curiosidade curso cursos curta curtas curto curtos curva curvado curvam curvando curvar curvas
curvo curvou cálculo câmera círculo código cômodo cônico da dada dadas dado dados dali damos daqui dar daremos dará das data daí de decomposição dedo
dedos deduzem deduzir deduzo dedução defina define definir defino deixa deixamos deixando deixar dela delas dele deles demais demonstrada denavit
denominador denota dentro depende depois depositar derivar desce descem descerá desceu descida descreve descrita desejada desenhar desenvolvendo
desligar desliza deslocamento desmontar dessa dessas desse desses desta deste destes detalhes determina detrás deu devagar dever dez dezembro dh dia
diagonal diagrama diante dias dicionário diferença difíceis diga digamos dimensão diminuir dinâmica direita diremos direta direto diretório direção
direções dirige dirigir dirigível dirija dirijo disciplina discos dispomos disponível dispor dispõe disso distinto disto distância ditas ditos
divergência divida dividindo divido divisão dizemos dizendo diâmetro do dobra dobrado dobram dobrando dobrar dobro dobrou dobráveis documento dois
domingo domínio dos dou doze duas dupla duplas duplo durante duração décimo dê e editor edição efetiva efetuador efetuou eixo eixos elas elege elegem
elegendo eleger elegeu elegível elemento eles eletrónica eletrônica elevado elevam elevando elevação elevem elevou elimina elipse elo elos elétrica em
empilhados emprego empurrar encoder encolher encontra energia ensaio ensinar ensine ensino entender entra entrando entrar entre entrega entrem entro
entrou então enumerar enunciado envia enviado enviamos enviando enviar envie enviem envio enviou equação equações equivale era eram ergue erguem
erguendo erguer ergueu erguida escalar escola escolha escreve escrita escutar escute escuto esfera esforço esférica espaço especial específica espiral
esquema esquerda essa essas esse esses esta estabelecer estamos estaremos estará estava estação este esteira esteja estende estes esteve esticar
esticou estive estou estreito estrutura estuda estudo estática estão esvaziar etapa etapas eu euclidiana exata executar exemplo exercício existe
exoesqueleto experimento explicar exploramos expor exportação exposto expressa externa extrai extremidade fabricante facilmente faculdade faremos fará
farão fases fator fatorando fatores favor faz fazem fazemos fazendo fazer faça façam façamos faço fechado fechamento fechando fechar feche fechem
fecho fechou feita feito feriado ferramenta fevereiro fez fica ficam ficando ficar ficha fichas figura filme filtrar filtro fim final finalmente
finita finito fino fins fixa fixada fixado fixamos fixando fixar fixaram fixação fixações fixo fixos fizemos flexão foi folha folhas fomos fonte fora
foram forma formado formam formas formato fornece força forças fosse fossem foto fotografia fotos frase frases fração frações frequência fresadora fui
função funções furadeira fuso futuro fábrica fáceis fácil fórmula fórum garra geometria geométrica gera gerada gerado gerais geral geralmente geram
geramos gerando gerar geraram gerará gerarão geração gerações gere gerou gira giram giro giz grandeza grau graus gravação gravidade grega gregas grego
gregos gráfico guardar guarde guardo guia guias guindaste gênero haja haste havendo haverá havia hexágono hidráulico hipotenusa hipérbole hipótese
história hoje homogénea homogênea hora horas horizontal horário houve hélice hífen ideia ideias identidade ido idêntico iguais igual igualar igualou
ilustra imagem imediatamente implementa imprimir impõe inclua incluem incluo incógnita indica indo industrial indústria inferior informação inicial
inicie inserindo insira instalar instância inteiramente interessante interior intermediária interna interromper interseção introduzida inverno inversa
inverter inércia início iremos irá isolado isolamento isolando isolar isolação isolou isometria isso iteração itinerário jacobiana janeiro janela
joelho julho junho junta juntado juntam juntando juntar juntas junte juntem juntou já laboratório lado lados lagrange laranja larga latitude laço
laços lei leis leitura lema lembrando lembre lembro lentamente letra letras levam levamos levando levantar levar levaram levaremos levará levarão
levem levo levou lhe lhes liberdade liberem liga ligada ligado ligam ligamento ligamos ligando ligar ligaram ligará ligação ligações ligo ligou limite
linear linguagem linha linhas liso lista listam listando listar listas listou livre livres livro livros lição lições local logicamente logo longa
longas longo longos losango lote lousa lugares lápis língua madeira magnético maio maior mais maiúsculas maneira manhã manipulador manuais marca
marcado marcam marcando marcar marcação marcou martelo março mas massa massas material matricial matriz mecanismo mecânica mede medida medido medindo
medir medição medições medo meio meios memória mencionado menor menos mensagem menu meses mesma mesmas mesmo mesmos meta metade metas metro metros mil
milhão milissegundo milímetros minuto minúscula misto mistos modelo modificada modos mola molas momento monta montamos montar montem montou mostra
mostre mostrou motivação motive motivo motor motores move movem movimento muita muitas muito muitos multiplica mundo mão mãos método mês múltiplas
mútua mútuo na naquele naquilo nas navegador negativa nela nelas nele neles nessa nessas nesse nesses nesta neste nisso no noite nomeado nomeando
nomear nomeação nomeou nono norma normal nos nossa nossas nosso nossos nota notas notação nova novamente novembro novo noção noções numerador numérica
níveis nível número o objetivo objeto oblíquo obrigado observa obstáculos obtemos obtendo obtenha obter obteremos obterá obteve obtida obtido obtive
obtém obviamente ocasião oficina oitavo oito olhando olhar olá ombro onde ontem onze operam operar operação operem operou oral ordem ordene ordenou
orientado origem ortogonal ortonormal os oscilação oscilou otimização ou outono outra outras outro outros outubro ouve ouvir palavras papel par para
parafuso paralela parcial parte partes particular partida partilhar partimos partindo partir parábola parágrafo parâmetro passa passador passamos
passem passo passos passou pasta pastas pausa pedaço pedestal pedir pela pelas pelo pelos percebe percurso pergunta periódico permite perna pernas
perpendicular pertence perto perímetro período pesa pesada pesado pesando pesar pesaram pese pilha piloto pinhão pirâmide pistão pistões pitágoras
placa placas plana planar planear planejamento plano planos plenamente plástico pneumático pode podem podemos podendo poder poderemos poderá poderão
podes podido pois polegar polia polias polinômio polígono pomos pondo ponha ponho ponta pontas ponto pontos por poremos porque porquê portanto porá
posicionamento positiva posição posições possa possam posso possui possível postas posto postos postura potência pouca poucas pouco poucos praticar
preencher prefácio preparar pressão pretendida primavera primeira primitiva primário princípio prismática problema procedimento procura produto
produzir programa progressivamente projeto projeção proposta propriedade prosseguir protótipo prova provado provam provando provar provação provem
provocar provou prática prévia prévio própria prótese próxima publicado pudemos pulsação pulso punho puxa puxada puxado puxamos puxando puxar puxaram
puxará puxou pá página pé pórtico pôde pôr põe põem quadrado quadro quadrática quais qual quando quantas quantidade quarenta quarta quarto quatro que
queira quero questionário questão questões quinta quinzena quis quociente quê químico raciocínio radianos raio raiz rapidamente razão raízes reagrupar
realiza rebite recebe recolher reconhecimento recordar recorrendo recuado recuam recuando recuar recuo recuou recurso rede redefinir redor redutor
reduza reduzem reescrever referida referência reflexão região regiões regra regulamento regule regulável relaciona relativa relatório relação relações
relé removendo rendimento reorganizando repete repetir repositório representa resolver respectiva respeito respetivamente resposta resta restante
resulta resuma resumo reta retangular retas retirando reto retângulo reunem reunidos reunindo reunir reuniu reunião rever revisar revisão revolução
ritmo robótica robô robôs roda rodas rolamento rosa rotacional rotativa rotação rotações roxo régua rígido rótula sabem sabendo saberá sabido saia
saiam saiamos saiba saio sala saudações saída script se secundário secção secções segmento segue seguem seguinte seguir seguiu segunda segure sei seis
seja sejam selecionados semana semelhança semestre seminário sempre sendo seno sensores sentido separando separe separou sequência ser seremos serial
serão sessenta sessão seta setas sete setembro sexta-feira seção seções si sigamos similar simples simplifica simulador simulou simétrica singular
sintetizar sistema situar situação sob sobe sobem sobre sobrepõem software soldado soldar solidário solução soluções soma somam somamos somando somar
somaram somos somou sou soube sua suas suavemente suavizar subdividido subespaço subindo subsequente subseção substitui subtraindo sucessiva
suficiente sumário superior surgem surgido surgimento surgindo surgir surgiu sábado são séries sétimo símbolos sítio tabela tablet tais tal também
tangente tanta tantas tantos tarde tarefa te teclado tela telas telefone telhado tem temos tempo tendo tenha tenham tenho tensão tensões teorema
teoria teoricamente ter terceira terei teremos termo termos terão terça-feira tese teto teve texto textos tido tipo tipos tivemos tocha toda todas
todo todos tomemos torna torno tornozelo torque torre torção total totalidade totalmente trabalho trajetória transforma translada transposta trapézio
tratada traz trazemos trazer traça traçado traçam traçando traçar traço traçou tração trigonometria trilho trimestre trinta tripla triplo triângulo
tronco três tu tutoria tão técnica térmico têm típicos título ultrassom um uma unem unida unidade unidas unido unindo uniremos unitário uniu
universidade união usa usada usadas usado usados usando usaremos usuais usual usuário utiliza vai vale valor valores vamos vantagem varia variação
variável veem veio veja vejam vejamos vejo velocidade vem vemos venha venham ver verdadeiro verde verdes veremos verificar versões vertical verão
vetor vetores vetorial vez vezes viagem vibrador vibram vibrando vibrar vibração vibrou vidro vimos vinda vindo vinte viremos virá visita vista visto
vocabulário você vocês volta voltaremos voltas vos vou vá válido várias vários vão vêm vídeo vídeos vírgula zerada zerado zero à àquela àquele às
áreas árvore ângulo é éramos ícone índice óptico última último úteis
prolongamento prolongado
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

# words that judge, or compare, and tell of no letter what it is
OF_NO_LETTER = """
error errors mistake mistakes issue issues problem problems wrong false correct incorrect true reads read ask asks asked lost loses missing miss erratum errata slow slower slowest
fast faster fastest high higher highest low lower lowest better best worse worst important interesting easy easier hard harder difficult nice simple simpler careful beware attention
belong belongs alike sought depression dépression depresión depressione depressão depressionswinkel senkungswinkel would could should might hardly seldom rarely often always usually obviously clearly evidently why who whom whose whether
erreur erreurs faute fautes problème problèmes annule disparaît disparaissent faux fausse vrai vraie exact exacte perd perdu perdue perdent manque corrigé facile difficile important intéressant lent lente rapide rapidement meilleur meilleure
souvent toujours rarement évidemment clairement attention pourquoi qu'on dont lui eux celui-ci celle-ci
erscheint erscheinen fehler problem probleme falsch richtig wahr verliert verlieren verloren fehlt fehlen leicht schwer schwierig wichtig interessant langsam langsamer schnell schneller oft immer selten offenbar deutlich
warum weshalb wieso ich mich mir dich dir uns euch ihm ihn ihnen jener jene jenes
desaparece desaparecen error errores problema problemas falso falsa cierto cierta verdadero correcto incorrecto pierde pierden perdido falta fácil difícil importante interesante lento rápido aprecia apreciar claridad
a menudo siempre rara vez evidentemente claramente quien cuyo cuya aquel aquella
ignoto ignota ignote scompare scompaiono errore errori problema problemi falso falsa vero vera corretto errato perde perdono perso manca facile difficile importante interessante lento veloce rapido spesso sempre raramente chiaramente
agli anch anch' anche esso essa essi esse costui perché
desconhecido desconhecida erro erros problema problemas falso falsa certo verdadeiro correto incorreto perde perdem perdido falta fácil difícil importante interessante lento rápido muitas vezes sempre raramente claramente porquê quem cujo cuja
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
exact exacte exactly exactement exakt expected attendu erwartet well bien oben
"""
