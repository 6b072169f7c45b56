"""The words of robot-arm courses, in which equations are led to and spoken of: a sentence of others may say anything.

They are those that two or more of some 170 public documents on arms have beside their displays, and what goes with them, without
the words that deny, doubt, judge or tell of people. An English word of seven letters or more stands for all
that begin with the same seven, one of another language for those that begin with the same six.

`OF_GERMAN` are of a sentence in which nouns begin with capitals, `OF_ARM` those of which a sentence is that says something of the arm and not of the display, `GOES_ON` begin what goes on from
a display, and `LOADED` are those that a sentence of the display may deny it by, and others have often.
"""

ENGLISH = """
abbreviate ability able about above absolute accelerate according account accuracy achievable achieve achieving across act acting action actions
activates actor acts actual actually actuated actuation actuator adaptive add added adding addition additive adds adjacent adjoint adjugate adjust
admissible advance advantage affect aforementioned after again against agree agrees algebra algorithm align aligned all allow allows alone along alpha
already also alternate although always among amount amounts amplified amplify an analogous analysis analytic analyzing anchor and angles angular
anisotropy announced annulus another answer anthropomorphic anticlockwise any apart appear appears appendix applications applied applies apply
applying approach appropriate arbitrary architecture arctan arctangent are area aren argument arise arises arising arithmetic arms around array arrive
arrow articulated as asks aspects assembly assign assignment assigns associated assume assumed assumes assuming assumption asymptotic at atan attached
attachment attainable augmented automatically available average avoid avoidance axis back backlash backward balance ball based basic basically basis
be because become becomes been before begin behavior behind being belongs below bench bend bends between beyond bibliography big bigger bisector bit
block blocks bodies body book books both bottom bound boundary bounded bounding bounds brackets braking branch branches break breaks brevity building
builds built but by calculate calculus call called calls camera can cancel cancellation candidate cannot canonical capture carriage carries carry cart
cartesian cascade case cases cauchy causes ceiling center centers centimetres central centre centrifugal certain chain chaining chains change changes
changing chapter characterized chart check checked checking checks choice cholesky choose choosing chosen circle circles circular claim clarity
classic classify clear clearly clockwise close closed closes closure cm code coefficient cofactor coincide col collaborative collecting collision
collocation column columns combination combine combining comes command common commonly communicates compact companion compare comparing compatible
compensating complete complex component compose composite compound computation compute computing concatenate concept conciseness conclude conclusion
concrete condition cone cones confirm conjugate connect consecutive consequence conservation consider consist constant constraint construct contact
contain context continues contrast contributes control convenient converge conversely convert convex convexity coordinated core coriolis cornerstone
corollary correct corresponds cos cosine cosines cost counterclockwise coupled course courses covariance covers craig crank create creates critically
cross crucial cubic cumulative current curve curves custom cycle cycles cylinder cylindrical damped damping dashed decay deceleration decide decides
decision decomposing decreases deficient defined defines defining definite deformation degenerate degree degrees delta demonstrate denavit denominator
denote denoted denotes denoting dense density depend dependent depending depends depicted derivation derive derived descent describe description
design designate designed desirable desire desired det detail detailed details detect detection determine deviation device dexterity diagonal diagram
did different difficulty dimension directions directly disc discrete discriminant discuss displacement display distal distribution diverges divide
dividing division document does dof dofs doing domain done dot dots double down download downward draw drawing drawn drive drives dual duality
duration during dynamic each earlier easier easiest easily easy edge edition effect effective effector effects efficient effort efforts eigen
eigenvalue eigenvector eight either elastic elbow elbows elegant element eliminate ellipsoid elsewhere embed embedded embedding emphasizes employed
enables enabling encode encoded encoder encodes encompassed end ends energy enforce enforcing engine engineering enough ensure ensures ensuring enter
entire entirely entries entry eq eqn eqs equal equality equals equate equated equating equation equilibrium equivalent especially essential establish
estimation etc euclidean euler evaluate even eventually every everywhere exact exactly example execute exercise exerted exist existence existing
exists expand expanded expanding expansion expect expected experiment explain explicit exponential express extend extended extends extension external
extra extract extremely face faces fact factor factoring factors facts families family far farther fashion fast faster fastest feasible feature feed
feedback few field fields fifth fig figure figures file files fill filter filtering finally find finding finds fingers finite firmware first five fix
fixed fixes fk flange flat flipped flipping floor flow focus fold folded folder folds follow followed following follows foot for force forced forces
forearm form formal formally format formed former forming forms formulae forward found foundation four fourth fraction frame frames framework free
freedom frequency fresh friction frobenius from front full fully function fundamental further future gain gamma gantry gear gearbox general generate
generic geometry get gets gimbal give given gives giving global go goal goals good governed gradient graph graphical grasp gravitational gravity
greater grid gripper ground group grouping grow grows guarantees had half halfway hand handed handle handling handy happens hartenberg has have having
header headers heading heads heavier height helper hence here hertz high higher highly historically history hold holds hollow holonomic homework
homogenous horizontal host how however hypothesis ideal identical identify identity if iff ik ill-conditioned illustrate image images imaginary
immediately impedance implement implies implying important in include including incorporate incremental indeed independent index indicate individual
induced industrial inequality inertia infinity influence information initial inner input inputs inside insight inspecting instance instant instead
integer integral interactive interested interface interior intermediate internal interpolate interpret interrupt intersect interval into introduce
intuitive invariant inverse inversion invert inverted inverting inverts invoking involves is isolate isotropic it iteration ith its itself jacobian
jerk joint joints jordan jth just kHz keep keeps kernel key keys khz kinematic kinetic know knowing knowledge known kutta lab label labeled labels
laboratory lagrange language laplace laplacian large larger largest last later latter law laws lead leading leads learn learned learning least lecture
left leg legible legs leibniz lemma length lengthen lengths less lesson lessons let lets letters level lever library lie lies lift lifts lighter like
limit limited limits line linearise linearly lines link linkage links list listed listing little load loaded local locally located location lock log
logarithm logic long longer longest look looking looks loop lower lowers lyapunov made magnitude main mainly maintaining make makes making manifold
manipulate many map mapping maps mass masses massive massless match matches matching math mathematica matlab matter matters maximal maximise maximize
maximum may mean meaning means meant measure mechanism meet meets memorise memorize meter meters method methods metre metres metric metrics
microcontroller middle millimetres millisecond minimal minimise minimize minimum minor minors minus mirror mirrors mm mobile mobility mode model
modeled modeling models modes modest modified modify module modulo moment moments momentum moore more most motion motions motor motors mounted move
movements moves moving mth much multi multiple must mutually name named namely names natural nature near necessary need needed needs negative neglect
neighborhood neither net new newton next nine node noise non nonconvex none nonlinear nonsingular nontrivial nonzero norm normal normalise norms
notebook notes notice noting notions now null number numbers numerator numeric object objective objects observation observe observing obstacles obtain
obtained obtaining obtains occur occurs of off offers offset offsets often once one online onto open operation operator opposite optimal optimise
optimized optional or order ordered orientations oriented origin original origins orthogonal our out outer outline output outputs outside outwards
over overall overshoot own packages page pages pair pairs panel paper papers parallel parameter part partial particle particular partition parts pass
passed passing passive passivity path paths pattern payload peak peaks pendulum penrose perfectly perform period periodic periods perpendicular
perspective perturbations pfaffian phase phi physical pi pick picks piece pieper pin pinned pipeline pitch pivoting place places planar plane planes
planned planning plate platform plays plot plots plotted plotting plus pointing polar polynomial poor portion portrait posed poses positional positive
possibility possible post postmultiply postures potential power powerful powers practice pre preceding precise precision predict preferable preferred
premultiply prepare preparing prescribed present preserves prevent previous primary principal printed prism prismatic problem procedure proceeds
process produce product profile program project promised proof propagate proper properly property proportional proposition prototype prove proved
provide providing proximal proximity pseudo pseudoinverse published puma pure purely purposes push put puts pythagoras python quadrant quadratic
quantities quarter quasi quaternion query question quintic quoted quotient radial radians radius rail raise raises ram random range ranges rank rate
rates ratio rational re reach reachable reached reaches reaching reactions read readability readable reader readers ready real realizing rearrange
reason reasonable recall recalled recalling recent recognizing recommended record recorded records rectangular recursion reduce reducer reduces
redundant refer reference referred refers reflects regardless region regions regrouping regular relabeling relate related relates relating
relationship relative relevant remain remainder remaining remains remark remember reminder remove removed removes removing render rendered repeat
repeated repeats replace replay report repository represent reprinted reproduced require requiring research reset resistance resolution resolving
respect responsiveness rest restrict result resultant resulting results return returned returning returns review revolute rewrite rewriting rewritten
rhs right rigid rigidly rigorous ring robotic robots robust robustness rodrigues roll rolling root roots rotary rotate rotated rotates rotating
rotational roto rototranslation round routines row rows rpy rule run runge running runs rx sac same sampled sampling satisfied satisfy saw say scalar scale scaled scaling
scara scene schematic schur schwarz science scratch screen screw screws script scripts sec second seconds section see seek seen select selecting
selects self semi sense sensitive sensor sent separate sequence sequentially serial series serves set sets setting settling setup seven several
severity shall shape share shared sheet shifts short shorten shorter shortest shorthand shoulder show showed showing shown shows side sides signal
signed similar simple simpler simplest simplicity simplify simply simulated simultaneous sin since sine sines single singular situation sixth size
sketch skew slice slide slider slides slow slowest small smaller smallest smooth smoother smoothly smoothness smooths so software solve solved solver
solvers solves solving some sophisticated sort source space spaces span sparse spatial speak speaks special specific specify spectral speed speeds
sphere spheres spherical spline splitting square squared squares squaring stability stable stack stacking stage stand standard stands start started
starting starts state stated statement states static statics stay step steps stewart still stop stops stored stores straight strategy stress stretch
strictly strong strongly structural studied studies study studying sub subject submatrix subscript subsection subsequent subset subspace substitute
subtract success such suitable sum summarize summary summing sums superscript supported suppose supposing sure surface sweep sweeping swing swings
symbolic symbols symmetry system systems table tables tabular take taken takes taking tall tangent target targets task tasks taylor tcp technically
techniques telescoping ten tends tensor term terms test text textbook th than that the their them then theorem theoretical theory there thereby
therefore these thesis theta they third this those though three threshold through thus time timer times tip to together tolerances too tool toolbox
tools top topology torque torques total toward towards trace traces tracking trajectory transcendental transcription transfer transform transition
translate transmitted transpose trapezoid traslation treat treated treatment treats tree triangular trig trigonometry trivial true turn turned turning turns
twelve twist twists two type types typical ultimate unattainable unchanged under underlying understand uniform unique uniquely unit units universal
unknown unreachable unstable until up update updated updates upon upper upward upwards us use used useful uses using usual usually valid value values
vanish vanishes variable variance variation varies various vary varying vectors velocity verification verified verify version vertical very via vice
view virtual viscous visualize volume wall want was way waypoint ways we weight weighted weighting weights well were what wheel wheels when whence
whenever where whereas wherein which while whole whom whose why wide widely width will with within word words work works workspace world wrap wrapped
wrench wrenches wrist write writes writing written wrt xy yaw yet yield yielding yields yoshikawa you your zero zeros zyx zyz
"""
FRENCH = """
a abord abordé abréviations absolue accorde accélère accélération achève addition adjointe affecte affichage ai ailleurs ainsi aisément ait ajoute
alignement aligné aller alors amortis amène analyse angle angles angulaire annexe annoncé annule antisymétrique apparaître appelle appelons appelée
application applique apporte approche après arrivée arrière arrête article articulaire asservissement atteindre au au-dehors au-delà au-dessous aussi
autant autour autre autres aux avance avant avant-bras avec avoir avons axe axes baissent banc barre barres bas base basse beaucoup bibliothèque bien
bloc blocs bon bonne bonnes bons bord bords borne bornent boucle bouger boule bras butée butées calcul car caractérise carré carrée carrés carte cas
cauchy cause ce ceci cela celle celles celui centimètre cercle ces cet cette ceux chacun changement chapitre chaque chaîne cherche chiffres choisit
choix chose chuter ci ci-dessus cible cibles cinq cinquième cinématique classique code codeur coefficients cofacteurs cohérente colonne comatrice
combien commande comme comment commune comparaison complète complément composante comprendre compte comptée concours conduit configuration confirment
connaissant connaît connu connue connus considère constitue constructeur consulter conséquence contient convention conviennent coordonnée corps
correct correspond cosinus coude coudes coupent couple courbe couronne cours court courte courts coïncident coûtent croissent croît croître côte côté
côtés d d'où dans de degré degrés demande demi-tour depuis dernier dernière derrière des dessin dessus deux deuxième devant devient deçà di
diapositive diffèrent différence dimension dire direct dirigé discutez dispose disque distance divise doit donc donne donnent donnez donné donnée dont
dos dossier douze droite du durée dynamique décalage décide découle découplage décrit déduire déduisons déduit défini démarche démonstration démontré
dénominateur départ dépasse dépend déplace déplié déport dépôt dérivant dérivez dérivée désigne détaillé déterminer développant effecteur effet elle
elles emploie employées en encore endroit enfin ensemble ensuite entier entière entre espace essai essais est est-à-dire et euler exact exacte
excentricité exemple exercice existe expression exprime expérience extrémité extérieur facile faire faisant fait faites faits famille faut façon ferme
fiche fichier figure fin finalement fixe flèches fois fonction font force forces forcée forcément forme forment formes formule fort fourche fourni
frottement gagne gagnent gauche grand grandeur graphe graphie gravité général géométrie habituel haut haute hautes hauteur histoire historiquement
homogène hors huit hypothèse hypoténuse ici identité il ils immobile immédiatement impair implantée implémenté imprime inchangée inconnues incrémental
indice indique industriel indépendamment inertie inférieur interne interviennent intitulé introduit intérieur inverse isolant jacobienne joint joue
joule jusqu juste kilogramme l la laboratoire lacet lagrange laissant laisse langage laquelle le lecteur lectrice lente lentes lequel les lesquelles
lettre leur leurs liaison liberté libre libres lieu ligne lignes limite limités linéaire lire liste lit livre livres lié logiciel loi loin longs
longueur lors lorsqu lue lui lui-même lus là là-bas maintenant maintient mais majuscule manipulateur manière manuel marque masse masses matlab matrice
membre mesure mesurés mettent mettre mi-parcours mieux milieu millimètre milliseconde mince mineurs minuscules mise modèle modélisation moindres moins
moitié montre montrons moteur mouvement multiplie mène mènent mètre mètres mécanisme méthode même mêmes n neuf newton nom nombre nomme nommer nommé
nommée noms normale norme normes nos notation note noter notons notre noté notée notées notés nous nouveau nouvel noyau nul nulle nulles nuls négatif
négligé nôtre nôtres objet obtenir obtenons obtention obtenu obtient on ont opposée opérateur ordre orientation origine orthogonale ou outil ouverte
ouvrage où paire par par-dessus parallèle paramètre paramétrage parcourt parent parler partent partie partir partout parvient passage passant passe
passent passons pend pendant perd perdent perdu perdue permet petit petite peut peuvent pince place placent placez plan plane planification plateau
plein plie plié plupart plus plusieurs poids poignet point pointe points polaire polycopié polynôme porte porteur porté portée posant pose poser
position posons possède posture posé posée pour pourra pourrons pourtant pousse pouvez pouvons premier première prend prendre prenons primes pris
prismatique processeur proche procédure produit programme projection projet propre prototype près précis précède précédent prédiction prédire prédisez
préférée prémisse présente publié puis puisqu python période pôles qu quand quart quatre quatrième que quel quelconque quelle quels qui quitte quoi
racine radian raison ramener rang rapide rappel rapport rassemble rayon redondant rejoignent relation remarque remontant remplaçant remplies rencontre
rend rendent replier replié repos repose représente repère respectivement restant reste restent retourné retranchez retrouve revient robot robotique
rotation rotatoire rotoïde roulis règle règles réalisé réciproque récurrence réduite réel réflexion référence régulateur répond répète résolution
résolvant résoudre résout résultat résumé réuni réunissent rôle s s'écrit sa sait satisfont saute sautent savoir schéma se seconde section segment
selon semaine sens septième sera seront sert servent servira ses seul seule si signifie simplement simulateur singulière sinus six sixième soient soit
solides solution sommant somme sommes son sont sort sorte sortir souhaite sous spatiale sphère sphérique statique strictement structure substituant
suffit suit suite suivant suivent suivre suppose supérieur sur symétrique système séance sépare série t-elle t-il tableau taille tandis tangage
tangente tant technique tel telle tels temps tendu tenu terme termes terminent testez texte thèse théorème tient tire tirer titre tombe torsion total
totale toujours tour tournant tourne tourné tours tous tout toute toutes tracé tracée traité transformation translation transposée travail travers
triangle trigonométrique trièdre trois troisième trop trouve trouvons trouvée tâches ultérieure un une unicité unitaire unité unités utile utilise va
vaille valable valeur valoir variable varie vaut vecteur vectoriel verra verrons vers vides viennent vient vitesse voici voilà voir voit vont vrai
vraie vu vue vérifie vérin y zéro à à-dire écart écarts échange échantillonnage écrire écrit écrivez écrivons édition égal égalant égale également
égales égalité égaux élevant élément énergie énoncent énoncé épaule équation équivaut établi était étant étape étapes étend étendu étude étudie étudié
été évident être
"""
GERMAN = """
ab abbildung aber abgeleitet abgeschlossen ableiten absatz abschnitt absolut abstand absätze abtastung achse achsen addieren addition aktuell alle
allem allen aller alles allgemein als also am an analog andere anfang angegeben angenommen angewendet anhand anhang annahme annehmen anordnung ansatz
anschließend anteil antrieb anwenden arbeit arccos arctan arkustangens arm armes artikel auch auf aufgabe aufgelöst aufgestellt auflösen aufstellen
aus ausdruck ausführlich ausgangspunkt ausgedrückt ausgewertet auswerten auswirkung auswählen außen bahn bahnen basiert basis basiskoordinatensystem
bauform bedeutet bedingung befinden beginn behandeln bei beide beiden beider beispiel beitrag bekannt bekommt beliebig benutzt benötigt berechnen
bereit berücksichtigt beschleunigung beschreibt besitzt besteht bestimmt bestätigt betrachte betrag bewegen bewegt bewegung bezeichnen bezogen bezug
bezüglich bibliothek bild bilden bilder bildet bildschirm bis bogenmaß buch bzw bücher code cosinus dabei dafür dagegen damit danach dann daran darauf
daraus dargestellt darin darstellung das dass datei dateien daten datenblatt davon dazu definiert dem den denavit denn denselben der derart deren
derselbe des deshalb dessen detail determinante dh diagonal die dies diese dieselbe dieser dieses differenz dimension direkt drehachse drehgelenk
drehmatrix drehmoment drehung drehwinkel drei dritte durch dynamik ebene ebenen ebenfalls ebenso echtzeit ein eindeutig eine einem einen einer eines
einfach einfluss eingabe eingesetzt einheit einige einmal einsetzen einzelne elemente ellbogen encoder ende endeffektor endpunkt energie enthält
entlang entnehmen entnommen entspricht entsteht erfolgt erfüllt ergab ergaben ergeben ergebnis ergibt erhalten erhält erinnerung erste ersten erster
erstes erweitert erwähnt es etwa experiment explizit faktor fall fertig fest feste festen figur finden findet flansch folge folgen folglich folgt form
formel frei freie freien freiheit früher funktion führt für geben gegeben gegenüber gehabt geht gehört gelenk gelten gemessen gemäß genannt genau
geometrie geprüft gerade gerundet gesamt geschlossene geschrieben geschwindigkeit gespeichert gesucht getriebe gewicht gewählt gezeigt gibt gilt
gleich glied glieder grad grafik greifer grundlage größe größen größer gültig haben halb handgelenk hat hatte hatten heißt hergeleitet herleitung
hersteller hier hieran hieraus hierbei hierfür hierzu hinten homogene horizontal hängen hängt höhe ihr ihre ihren ihrer ihres im immer implementiert
in indirekt industrie ingenieur innen insbesondere insgesamt inverse invertieren ist jacobi jede jedem jeden jeder jedes jetzt jeweils kann kapitel
kartesisch kette kilogramm kinematik kinetisch klassisch koeffizienten komponente konfiguration konstant konvention koordinaten korrekt kosinus kraft
kreuzprodukt kräfte kugel kurve kurven kurz können labor lage lassen lateral laufzeit lauten lautet legen lehrbuch lehrbüchern leicht leiten leitet
lesen letzte letztlich liefern liegen liegt liest linear linie linke linken links literatur lotrecht länge längen lässt lösen lösung man manipulator
masse massen mathematik matrix matrizen mechanik mehr mehrere meist meisten messen messung messwerte meter metern millimeter millisekunde mit mitte
mittels modell moderne modifiziert moment motor motoren multipliziert muss möglich müssen nach nachdem nachprüfen nachrechnen nebenbedingung negativ
nennen nenner nennt noch notation notwendig null nullstellen numerisch nun nutzen nutzt nächste nämlich oben obere oberen oder offenbar offensichtlich
ordner orientierung original ort orthogonal paar parallel parameter planar polynom positiv praktikum praxis prismatisch produkt programm projekt
prozessor prüfen punkt punktes pythagoras quadrat quadrieren quaternion quelle quelltext quer rahmen rand raum rechnen rechnung rechte rechts regel
regelung regler relativ repositorium rest richtig richtung roboter roll rotation rotatorische rund rückwärts satz schema schließt schnell schnittpunkt
schon schreibt schritt schub schubgelenk schulter schwer segment sehen sein seine seinen seiner seite seiten sekunde semester senkrecht setzen setzt
sich sie siehe sieht simulation sind singulär sinus skalar skizze so sodass soeben software soll somit sowie spalte spezialfall später stammt starr
starre start stehen steht stelle stellt stimmen stimmt summe summen symbolisch symmetrisch system tabelle takt tangens tcp teil teilaufgabe teile
teilen testen theorem theorie tool transformation translation transponierte trägheit um umformen umgekehrt umgesetzt umkehrung umrechnung unabhängig
unbekannte und unmittelbar unser unsere unten unter untere untersucht ursprung ursprünglich variable vektor verbindet vereinfacht verfahren verfügbar
vergleich verglichen verlauf verläuft verschieben versuch vertikal verweis verwenden vgl viele vielen vier vierte vollständig vom von voraussetzung
vorgehen vorgestellt vorher vorlesung vorn vorne vorwärts waagrecht wahr war waren wegen weil weise weiter welche weltkoordinatensystem wenden wenige
wenn werden werkzeug wert werte wichtig wie wieder winkel wir wird wirkt wirkung wissen wobei worden wurde wurden wurzel wählen wählt würde z zahl
zeichnung zeigen zeigt zeigte zeile zeilen zeit zerlegen ziel zitat zu zuerst zugehörig zum zunächst zur zurück zusammen zustand zuvor zwar zwei
zweimal zweite zwischen zyklus zähler ähnlich äußere über überein überführt übergang überlagerung überprüfen üblich übrigen übung übungen
"""
SPANISH = """
a abajo abierta acción aceleración acumulada además adición agrupando ahora al alcance alcanzar algebraica algunas algunos algún alrededor alto ambas
ambos amplitud analizar anexo angular antebrazo anterior antes antropomórfico análisis aparece apartado aplica aporte apoyo apéndice aquí arcotangente
arriba articular artículo asigna asociada asume así aula autovalor aún base bases biblioteca bien bloque brazo brazos bucle buscada buscamos básica
búsqueda cada cadena caja calcula camino cantidad capacidad capítulo característica carpeta cartesiana caso catetos centro cero cerrada ciclo ciclos
cierra cierta cierto cilíndrico cinco cinemática circunferencia clase clases clásica codo coeficientes coincide columna combinando comentarios
comienza como comparar complejo compone comprender comprobar comprueba computador común con concatenar concuerda condición conduce configuraciones
conjunto conocer conocida consecuencia considera consigue consiste consta construir consultar contiene continuación control convención coordenada
correcta corresponde coseno cruz cuadrado cuadrática cual cuales cualquier cuando cuarta cuarto cuatro cuenta cumple cumplir curso curva curvas cuya
cuyas cuyos cálculo código dada dado dados datos de debe decir deducción deduce deducir define definir del demostrar demás denominador denota dentro
depende derecha derivar desarrolla descompone describe desde deseada despejar desplaza después detallada determina dh diagonal diagrama dicho
diferencia difieren dimensión dinámica dirección directa diseñar diseño disponible distinto divide dividiendo división documento donde dos durante
ecuación edición efector efectuando efectúa eje ejecutar ejemplo ejercicio ejes el elegimos elegir elemento eleva elevando elimina eléctrico emplea en
encoder encontrar encuentra energía enlace ensayo entonces entre entrega equivale es escalar escogido escribe esférica eslabones eslabón espacio
especial esquema esta establece estas este esto estos estructura estudia está están evaluar evalúa exactamente existe experimento explica expresa
extendida externa extremo fabricante factor fichero figura fija fijo fijos fila filas fin final finales finalmente flexión flujo forma forman formas
fricción fue fuente fuera fuerza función fácil fácilmente fórmula garra generar geometría geométrica gira giran giro giros grado grados gravedad
gráfica haber había hace hacemos hacen hacer hacia hallamos hallar han hasta hay hecha hecho herramienta hipotenusa hipótesis historia hoja hojas
hombro homogénea horizontales identidad igual igualar igualdades iguales implementa implica inclinación incluye incógnita indica industria inercia
ingeniería inicial inicio inmediatamente interior intermedia interna intersección interés introdujo inversa invertir ir isotrópica izquierda jacobiana
la laboratorio lado lados lagrange las le lenguaje ley libertad libre libres libro libros lineal llama llamada llamamos llega llegada llegamos llegar
lleva lo local localización longitud los luego límite línea líneas manera manipuladores mano marco masa masas matrices matriz mecanismo mediante
medición medida medido medio memoria menos meta metros mide miden miembro milisegundo milímetros misma mismo modelo modifica momento montaje motor
motores movimiento mucho muchos muestra mueve mueven multiplica muñeca más máxima máximo método mínima mínimo módulo múltiples necesaria necesita
negativa norma normal nos notación notas nueva nuevo nula nulo numerador numérica número objetivo obtener obtenida obtiene obtuvo operación operador
operando orden orientación origen ortogonal otra otras otro otros palabras par para paralela parcial pares parte particular partida partir parámetros
paso pasos pendiente perfil periodo permite pero perpendicular pinza pitágoras plana planar planificación plano planos plantea plataforma poco pocos
podemos polares polinomio por posible posición positiva posterior postura potencia precedente presenta primer principal prismática problema procede
proceso producto programa propia propiedad propio proporciona prototipo proyecto práctica publicado puede pueden punto puntos página que queda quedan
queremos quitando rad radianes radio rama rango razón raíces raíz realiza recoge recogidos recta rectángulo recíproca reemplazar reescribe referencia
regla relación repositorio representa resolver respecto resta restando resto resuelve resulta resumen robot robots robótica rota rotación rotan
rotativa rotatoria rueda ruedas ruta rápidamente rígida rígido sabe sabemos saber sabiendo salida se sea sean secciones sección secuencia segmento
segunda según selección semana semestre seno senos sentido separa ser serie será serán señala si sido siendo significa sigue siguen siguiente
simbólica similar simple simplifica simulador singular sistema situación situado sobre software solución son su subconjunto subsistema suele suma
sumar superior sus sustituir tabla tablas tal tales también tangente tanto tarea tareas tema temas temporal tenemos teniendo tensor teorema teoría
tercer tesis texto textos teórico tiempo tiene tienen tipo tipos toda todas todavía todos toma tomamos toman tomando tomar torque total trabajo tramo
transforma transponer tras traslada trata tratará través trayectoria tres trigonométrica triángulo término un una unidad unitario usando usaremos
usará utiliza vale valor valores variable varía vector velocidad ver verdadero veremos verifica vertical verán vez viene vimos vio vista vistas visto
volveremos vuelve válida válido x y ya zona ángulo índice órdenes última último única único útil
"""
ITALIAN = """
a abbiamo accelerazione addizione adesso affronta aggiunge al alcuni algebrica alla allora alto altra altre altri ambedue ampiezza analitica
analizziamo analogo anche ancora angolare angoli angolo anno appartiene appendice applica approfondimento appunto arcotangente arrivo articoli asse
assi asta aste attorno attraverso attrito avambraccio avanti avendo aver avere avremo banco base basi basso biblioteca blocchi blocco braccia calcola
cambiamento campo capitoli caratteristica cartesiana casi caso catena centro cerca cerchio che chiamata chiamiamo chiusa chiusura ciascun ciclo
cinematica cioè circa circonferenza ciò codice coefficienti coincide collega colonna combinando come comincia compatta componente composta comune con
concatenando condizione conferma configurazioni confronti conoscendo considera consiste conto contributi controllo convenzione coordinate coppia
coppie corpi corpo correnti corretta corrisponde corso coseno cosicché costante costruire così cui curva curve da dal dalla data dati dato davanti
definire dei del della delle denavit denominatore dentro deriva descrive desiderata destra determina dettaglio di diagonale dietro differenza
dimensione dimostra dinamica dipende diretta direzione disegno dispensa dispone disposizione distanze diverse divide documentazione dopo doppio dove
due dunque durante e ecco efettore effettore elementi eleva elevando elimina encoder energia entrambe equazione equivale eseguita esempio esercizi
esperimenti esplicita espressa esprime essendo essere esterno estremità evidente fa faccia facilmente fanno fare fatta fatto figura figure file finché
fine fissa fissare fissi fisso forma formano formula fornisce fornito forza forze fosse fra frazione frequenza funzione fuori gdl generale geometria
gira giunti giunto già gli gradi grado grafica grandezza gravità ha hanno ho i identica il illustrata implementata imponendo in incognita indica
indice indichiamo industria inerzia infatti infine inizio inoltre inseriamo insieme integrale interna intersezione intorno introdotto inversa
invertire ipotenusa ipotesi isolando istante jacobiana la laboratorio lati lato le lega legame legate legge leggere letti lettura lezione libera
liberi libero libri libro limite limiti linea lineare linguaggio lo lunga lunghezza lungo ma manipolatore mano massa masse matrice meccanica medesimo
mediante membri membro meno mentre metodo metri metà mezzo millimetri millisecondo misura misure mobile modello modi modificata modo molti moltiplica
molto momento montati mostrata moti moto motore motori movimenti muove muovono ne negativa nel nella nodo norma normale nota notare notazione note
noti noto nullo numeratore numerica nuova nuovo occorre ogni omogenea opera operazione oppure ora ordine orientamento origine orizzontale ortogonale
osserva ossia ottenere ottengono otteniamo ottenuta ottiene ovvero pagina pagine paragrafi parallela parametri parte partendo parti particolare
parziale passaggi passi passo pedice pedici per perciò percorso pertanto piana piani pianificazione piano pinza pitagora più pochi poco poi poiché
polari polinomio polso pone ponendo poniamo positiva posizione possiamo possibile possono posto postura potenza precedente premoltiplicando presenta
prima primi primo prismatici problema procede prodotti progetto programma proiettando proiezione proprietà prossima prototipo pubblicato punti punto
pure può quadrati qualche quale quali qualsiasi qualunque quando quantità quanto quarta quarto quattro questa questo quindi raccogliendo raccolti
radianti radice radici raggio ragione rango rapidamente rapporto rappresenta regola relativa relazione rende repository resta restanti rete ricava
ricaviamo ricorda ricorre riferita riga righe rigidi rigido rimane riportata riscrivere risolta risolve rispetto risulta rivista robot robotica
rotazione rotoidale ruota ruotano ruotare scalare scegliamo scelta scelto scheda schema schemi scomposizione scritta scrive scriviamo scrivono se
seconda segue seguendo semplice sempre seni seno sensore separa serie sezione sferica si sia siano simile simili simmetrica simulatore singolare
sinistra sistema situazione soddisfa solito soluzione somma sommando sommare sono sopra soprattutto sostituire sotto spalla spaziale spazio specifica
sperimentale spiegato spostata stata state stati stato stessa stesse stessi stesso struttura studia studio su sua subito successiva sugli sui sulla
suo tabella tale tali tangente tanto tempo tenendo teorema termine terna terne terza terzo tesi testi testo tiene tipi tipo totale traiettoria
trasforma trasla trasposta trattata tre triangoli trigonometrica trova trovano trovare troviamo tutte tutti tutto ultima ultime ultimi ultimo un una
unitaria unità uno usa usando usare usata usate usati usato uso utensile utile utilizza vale valida valide validi valido valore valori valutata varia
variabile vede vedere vedono vedremo velocità vengono vera verifica vero verranno verrà verso versore verticale vettore via viene vincoli vista visto
volevasi volta zero è
"""
PORTUGUESE = """
a abaixo abreviaturas aceleração acha achamos achar acima adicionando adição agora agrupando ainda alcança algum alguns algébrica altura alvo além
ambas ambos amostragem analisando analogamente anexo angular antebraço anterior antes análise análoga ao aos aplica apresenta apêndice após aqui arco
arcotangente arquivo artigo as assim associada atrito atuador aula aulas base bases biblioteca bloco blocos braço busca cada cadeia calcula caminho
capítulo característica cartesiana caso casos cateto centro chamada chega chegada chegamos ciclo cinco cinemática circunferência clássica coeficientes
coincide colocando coluna com combinando começa como compara completa componente composição comprimento computador compõe comum concatenando condição
configurações conforme conhecida conjunto consequentemente considera consiste constante construir controle contém convenção coordenada coroa corpo
corresponde correta cosseno cotovelo cruzado cuja cujas cujo cujos curso curva curvas cálculo círculo código da dada dado dados das de decomposição
deduzir dedução define definir demais demonstrada denavit denominador denota dentro depende depois derivar descreve descrita desejada deslocamento
desta deste destes detalhes determina dh diagonal diagrama diferença dimensão dinâmica direita direta direção direções disciplina disponível dispõe
disso distinto dividindo divisão do dobro documento dois dos duas durante e edição efetuador eixo eixos elemento elevando elimina elo elos em encoder
encontra energia ensaio entre então equação equações equivale escalar escolha escreve escrita esférica espaço especial esquema esquerda essa essas
esse esses esta este estrutura estuda estudo estão exemplo exercício existe experimento expressa externa extremidade fabricante facilmente fator
fatores faz fazem fazer feita feito ferramenta fica ficam figura fim final finalmente fixa fixo fixos fora forma formado formam formas força forças
fosse função funções fácil fórmula garra geometria geométrica gerais geral gira giram giro grandeza graus gravidade gráfico havia hipotenusa hipótese
história homogénea homogênea horizontal identidade iguais igual igualar ilustra imediatamente implementa incógnita indica industrial indústria inicial
inserindo interior intermediária interna interseção introduzida inversa inverter inércia início isolando isolar jacobiana junta juntas já laboratório
lado lados lagrange laço lei leis lembrando liberdade ligação ligações limite linear linguagem linha linhas livre livres livro livros local logo longo
mais manipulador mas massa massas matricial matriz mecanismo medida medido medição medições meio menos mesma mesmas mesmo mesmos meta metros
milissegundo milímetros modelo modificada momento mostra motor motores move movem movimento muito muitos multiplica mão método múltiplas na nas
negativa nesta neste no norma normal nos nota notas notação nova novamente novo numerador numérica número o objetivo observa obtemos obtendo obter
obteve obtida obtido obtém onde operação ordem orientado origem ortogonal os ou outra outras outro outros palavras par para paralela parcial parte
partes particular partida partindo partir parâmetro passa passamos passo passos pela pelas pelo pelos percebe permite perpendicular período pitágoras
plana planar planejamento plano planos pode podem podemos polinômio ponto por porque portanto posicionamento positiva posição posições possível posto
postura potência pouco poucos pretendida primeira prismática problema procedimento produto programa projeto projeção propriedade protótipo prática
própria próxima publicado punho página quadrado quadrática quais qual quando quantidade quarta quarto quatro que quinta radianos raio raiz rapidamente
razão raízes realiza recorrendo reescrever referida referência regra relaciona relativa relação relações removendo repositório representa resolver
respectiva respeito resta restante resulta reta retirando retângulo reunindo robótica robô roda rotacional rotativa rotação rotações rígido script se
segmento segue seguinte seguir segunda seja sejam semestre sempre sendo seno sensores sentido separando sequência ser serial serão seção seções si
similar simples simplifica simulador simétrica singular sistema situação sobre software solução soluções soma somando somar sua suas subsequente
substitui subtraindo superior são símbolos tabela tais tal também tangente tarefa tem temos tempo teorema ter terceira teremos termo termos terão tese
texto textos tipo tipos toda todas todo todos torna torque total trabalho trajetória transforma translada transposta tratada trigonometria triângulo
três técnica têm um uma unidade unitário usa usada usadas usado usados usando usaremos usuais usual utiliza vale valor valores varia variação variável
velocidade vem verdadeiro veremos verificar vertical vetor vetores vetorial vez vimos vista visto volta voltaremos válido zerada zerado zero à às
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
