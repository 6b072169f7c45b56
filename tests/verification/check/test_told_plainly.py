r"""What plain words say of an arm, of its posture, of a force and of numbers: told otherwise nothing passes, and nothing right is refuted; the usual twin is decided."""

from __future__ import annotations

import pytest

from armproof import verify_text

TABLE = (
    "# Planar arm\n\n| $i$ | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |\n|---|---|---|---|---|\n"
    "| 1 | $\\theta_1$ | 0 | $l_1$ | 0 |\n| 2 | $\\theta_2$ | 0 | $l_2$ | 0 |\n\n"
    "The tool is at\n\n$$ x = l_1 c_1 + l_2 c_{12}, \\qquad y = l_1 s_1 + l_2 s_{12} $$\n\n## Here\n\n"
)
FORM = r"$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2), \qquad y = l_1 \sin\theta_1 + l_2 \sin(\theta_1+\theta_2) $$"
D = r"Put $D = \dfrac{x^2+y^2-l_1^2-l_2^2}{2 l_1 l_2}$. "
CASES = pytest.mark.parametrize


RATE = r"\dot x = -l_1 \dot\theta_1 \sin\theta_1 - l_2 (\dot\theta_1+\dot\theta_2)\sin(\theta_1+\theta_2)"


def _form(said: str, form: str = FORM, claim: str = RATE) -> str:
    text = f"# An arm\n\n{said}\n\nThe hand is at\n\n{form}\n\nIts rate is\n\n$$ {claim} $$\n"
    return verify_text(text).equations[-1].verdict.value


def _behind(said: str, latex: str) -> str:
    return verify_text(f"{TABLE}{said}\n\n$$ {latex} $$\n").equations[-1].verdict.value


@CASES(
    ("otherwise", "usual"),
    [
        (r"A pendulum on each bar shows $\theta_1$ and $\theta_2$.", r"A dial on each joint shows $\theta_1$ and $\theta_2$."),
        (r"Un inclinomètre sur chaque barre affiche $\theta_1$ et $\theta_2$.", r"Un cadran sur chaque articulation affiche $\theta_1$ et $\theta_2$."),
        (r"Eine Wasserwaage auf jeder Stange zeigt $\theta_1$ und $\theta_2$.", r"Eine Skala an jedem Gelenk zeigt $\theta_1$ und $\theta_2$."),
        (r"Un giróscopo en cada barra indica $\theta_1$ y $\theta_2$.", r"Un indicador en cada articulación muestra $\theta_1$ y $\theta_2$."),
        (r"A pendulum on each bar shows $\theta_1$ and $\theta_2$.", r"The arm is a double pendulum with scales; it shows $\theta_1$ and $\theta_2$."),
        (r"It has an upper arm (length $l_2$) and a forearm (length $l_1$).", r"It has an upper arm (length $l_1$) and a forearm (length $l_2$)."),
        (r"L'avant-bras a la longueur $l_1$.", r"L'avant-bras a la longueur $l_2$."),
        (r"Der Unterarm hat die Länge $l_1$.", r"Der Unterarm hat die Länge $l_2$."),
        ("With both scales at zero the hand is right under the shoulder.", "With both scales at zero the hand is level with the shoulder, as in the figure below."),
        ("Mit beiden Skalen auf null hängt die Hand am tiefsten, unter dem Gelenk.", "Mit beiden Skalen auf null liegt die Hand rechts von der Schulter."),
        ("Avec les deux cadrans à zéro, la main est sous l'épaule.", "Avec les deux cadrans à zéro, la main est à droite de l'épaule."),
    ],
)  # fmt: skip
def test_words_that_contradict_a_closed_form_leave_it_open(otherwise: str, usual: str) -> None:
    assert _form(otherwise) == "unchecked"
    assert _form(usual) == "proved"


@CASES(
    ("otherwise", "usual"),
    [
        (r"The telescope measures $a$ when it is pushed in, and $d_2$ is how far it has been pulled out.", r"The telescope measures $a$ when it is pushed in, and $d_2$ is its whole length."),
        (r"Rentré, le vérin mesure $a$, et $d_2$ dit de combien il est sorti.", r"Le vérin mesure $a$ au plus, et $d_2$ est sa longueur."),
        (r"Eingefahren misst der Auszug $a$, und $d_2$ ist er ausgefahren.", r"Der Auszug misst höchstens $a$, und $d_2$ ist seine Länge."),
    ],
)  # fmt: skip
def test_a_stroke_counts_from_the_length_at_rest(otherwise: str, usual: str) -> None:
    forms = [rf"$$ x = {way} \cos\theta_1, \qquad y = {way} \sin\theta_1 $$" for way in ("d_2", "(a + d_2)")]
    rates = [rf"\dot x = \dot d_2 \cos\theta_1 - {way} \dot\theta_1 \sin\theta_1" for way in ("d_2", "(a + d_2)")]
    assert _form(otherwise, forms[0], rates[0]) == "unchecked"
    assert _form(otherwise, forms[1], rates[1]) == "proved"
    assert _form(usual, forms[0], rates[0]) == "proved"


def test_a_zero_that_hangs_fits_a_closed_form_that_does() -> None:
    hangs = r"$$ x = l_1 \sin\theta_1 + l_2 \sin(\theta_1+\theta_2), \qquad y = -l_1 \cos\theta_1 - l_2 \cos(\theta_1+\theta_2) $$"
    rate = r"\dot x = l_1 \dot\theta_1 \cos\theta_1 + l_2 (\dot\theta_1+\dot\theta_2) \cos(\theta_1+\theta_2)"
    assert _form("With both scales at zero the hand is right under the shoulder.", hangs, rate) == "proved"


@CASES(
    ("otherwise", "usual"),
    [
        ("The wall pushes the hand away with the force $F$.", "The hand pushes the wall away with the force $F$."),
        ("Le mur repousse la main avec la force $F$.", "La main repousse le mur avec la force $F$."),
        ("Die Wand drückt die Hand mit der Kraft $F$ weg.", "Die Hand drückt die Wand mit der Kraft $F$ weg."),
        ("La parete spinge la mano con la forza $F$.", "La mano spinge la parete con la forza $F$."),
        ("A rope is tied to the hinge between the bars and pulls with the force $F$.", "A rope is tied to the hand and leads over the hinge of a door; the hand pulls with the force $F$."),
        ("Une corde est nouée au coude et tire avec la force $F$.", "Une corde est nouée à la main, qui tire avec la force $F$."),
        ("Ein Seil ist am Gelenk zwischen den Stangen befestigt und zieht mit der Kraft $F$.", "Ein Seil ist an der Hand befestigt, die mit der Kraft $F$ zieht."),
        ("Una cuerda está atada al codo y tira con la fuerza $F$.", "La lámpara está atada a la pared; la mano tira con la fuerza $F$."),
    ],
)  # fmt: skip
def test_a_force_that_is_not_the_hand_s_own_is_left_open(otherwise: str, usual: str) -> None:
    assert _behind(f"{otherwise} The motors give", r"\tau = J^T F") == "unchecked"
    assert _behind(f"{usual} The motors give", r"\tau = J^T F") == "proved"


@CASES(
    ("said", "latex"),
    [
        ("The two bars enclose an angle of 60 degrees.", "x^2 + y^2 = l_1^2 + l_2^2 - l_1 l_2"),
        (r"The two bars enclose an angle of $60^\circ$.", "x^2 + y^2 = l_1^2 + l_2^2 - l_1 l_2"),
        ("Les deux barres forment un angle de 60 degrés.", "x^2 + y^2 = l_1^2 + l_2^2 - l_1 l_2"),
        ("Die Stangen schließen einen Winkel von 60 Grad ein.", "x^2 + y^2 = l_1^2 + l_2^2 - l_1 l_2"),
        ("Shoulder, elbow and hand are the corners of an equilateral triangle.", "x^2 + y^2 = l_1^2"),
        ("Épaule, coude et main sont les sommets d'un triangle équilatéral.", "x^2 + y^2 = l_1^2"),
        ("Schulter, Ellbogen und Hand sind die Ecken eines gleichseitigen Dreiecks.", "x^2 + y^2 = l_1^2"),
        ("Las barras son los catetos de una escuadra.", "x^2 + y^2 = l_1^2 + l_2^2"),
        ("The bars are laid on the table like the legs of a set square.", "x^2 + y^2 = l_1^2 + l_2^2"),
        ("A water level shows that the string from the hand to the shoulder is horizontal.", r"x^2 = l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2"),
        ("La mano y el hombro están a la misma altura.", r"x^2 = l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2"),
    ],
)  # fmt: skip
def test_what_may_hold_in_a_posture_that_words_describe_is_not_refuted(said: str, latex: str) -> None:
    assert _behind(f"{said} Hence", latex) == "unchecked"
    assert _behind("The bars are long. Hence", latex) == "refuted"


@CASES(
    "said",
    [
        "The arm moves in a horizontal plane, with its hand and its elbow.",
        "Shoulder and elbow have vertical axes.",
        "The bars make an angle with one another, that of the elbow.",
        "Die Achsen von Schulter und Ellbogen sind senkrecht.",
        "L'épaule et le coude tournent dans un plan horizontal.",
    ],
)
def test_planes_and_axes_are_no_postures(said: str) -> None:
    assert _behind(f"{said} Hence", "x^2 + y^2 = l_1^2 + l_2^2") == "refuted"


@CASES(
    ("otherwise", "usual"),
    [
        ("$c_{12}$ is the cosine of the difference of both angles.", "$c_{12}$ is the cosine of the sum of both angles."),
        ("$c_{12}$ est le cosinus de la différence des angles.", "$c_{12}$ est le cosinus de la somme des angles."),
        ("$c_{12}$ ist der Kosinus der Differenz.", "$c_{12}$ ist der Kosinus der Summe."),
        ("$c_{12}$ es el producto de los cosenos.", "$c_{12}$ es el coseno de la suma."),
    ],
)  # fmt: skip
def test_a_shorthand_is_what_words_alone_say(otherwise: str, usual: str) -> None:
    assert _behind(f"{otherwise} It was printed in 1984. So", "x = l_1 c_1 + l_2 c_{12}") == "unchecked"
    assert _behind(f"{usual} It was printed in 1984. So", "x = l_1 c_1 + l_2 c_{12}") == "proved"


@CASES(
    ("reciprocal", "usual"),
    [
        ("An exponent $-1$ behind the name of a function means the reciprocal.", "An exponent $-1$ behind the name of a function means the inverse function."),
        ("Un exposant $-1$ derrière une fonction désigne l'inverse multiplicatif.", "Un exposant $-1$ derrière une fonction désigne la fonction réciproque."),
        ("Ein Exponent $-1$ hinter einer Funktion meint den Kehrwert.", "Ein Exponent $-1$ hinter einer Funktion meint die Umkehrfunktion."),
    ],
)  # fmt: skip
def test_an_exponent_is_a_reciprocal_where_the_text_says_so(reciprocal: str, usual: str) -> None:
    assert _behind(f"{reciprocal} So", r"\tan\theta_1 = \sin\theta_1 \cos^{-1}\theta_1") == "unchecked"
    assert _behind(f"{usual} So", r"\tan\theta_1 = \sin\theta_1 \cos^{-1}\theta_1") == "refuted"


@CASES(
    ("said", "is_minus"),
    [
        ("The elbow lies on the left of the line from the base to the hand.", True),
        ("The elbow lies on the right of the line from the base to the hand.", False),
        ("Il gomito sta a sinistra della retta che va dalla spalla alla mano.", True),
        ("Der Ellbogen liegt rechts der Linie von der Schulter zur Hand.", False),
        ("Le coude est à gauche de la ligne qui va de l'épaule à la main.", True),
        ("Of the two solutions we take that with the forearm turned clockwise against the upper arm.", True),
        ("Wir nehmen die Lösung, bei der der Unterarm gegenüber dem Oberarm gegen den Uhrzeigersinn gedreht ist.", False),
    ],
)  # fmt: skip
def test_the_side_of_the_elbow_tells_the_branch(said: str, is_minus: bool) -> None:
    told, other = (rf"\theta_2 = {sign}\arccos D" for sign in (("-", "") if is_minus else ("", "-")))
    assert _behind(f"{said} {D}Then", told) == "confirmed"
    assert _behind(f"{said} {D}Then", other) == "unchecked"


@CASES(
    ("said", "is_open"),
    [
        ("The window is to the left of the elbow. So it is on his right side.", True),
        ("Une autre solution prend la pièce derrière son dos.", True),
        ("Eine weitere Lösung greift über ihren Rücken nach hinten.", True),
        ("There is one more solution, in which the arm bends over and takes the part from behind its back.", True),
        ("The elbow makes a right angle with the window.", False),
        (r"We substitute the solution into the equation on the left.", False),
        (r"Angles are counted positive counter-clockwise, that of the forearm in this solution as well.", False),
    ],
)  # fmt: skip
def test_a_side_that_is_not_understood_leaves_the_branch_open(said: str, is_open: bool) -> None:
    assert _behind(f"{said} {D}Then", r"\theta_2 = \arccos D") == ("unchecked" if is_open else "confirmed")


@CASES("between", ["With the signs taken together", "Avec les mêmes signes", "Mit denselben Vorzeichen"])
@CASES("is_display", [False, True])
def test_signs_above_belong_to_those_below(between: str, is_display: bool) -> None:
    mark = "$$" if is_display else "$"
    said = rf"{D}Put {mark} \theta_2 = \pm\arccos D {mark} {between}"
    inverse = r"\theta_1 = \operatorname{{atan2}}(y,x) {} \operatorname{{atan2}}(l_2\sqrt{{1-D^2}},\, l_1 + l_2 D)"
    assert _behind(said, inverse.format(r"\mp")) == "proved"
    assert _behind(said, inverse.format(r"\pm")) == "unchecked"


@CASES(
    ("otherwise", "usual"),
    [
        ("The rates are given in degrees per second.", "The rates are given in radians per second."),
        ("Les vitesses sont données en degrés par seconde.", "Les vitesses sont données en radians par seconde."),
        ("Die Geschwindigkeiten stehen in Grad pro Sekunde.", "Die Geschwindigkeiten stehen in Radiant pro Sekunde."),
        ("Las velocidades se dan en grados por segundo.", "Las velocidades en grados por segundo se convierten."),
    ],
)
def test_rates_in_another_unit_give_no_number(otherwise: str, usual: str) -> None:
    values = r"Take $l_1 = 0.5$ m and $l_2 = 0.5$ m. For $\theta_1 = 0$, $\theta_2 = 0$, $\dot\theta_1 = 2$ and $\dot\theta_2 = 0$ the tool moves with"
    assert _behind(f"{otherwise} {values}", r"\dot y = 2~\text{m/s}") == "unchecked"
    assert _behind(f"{usual} {values}", r"\dot y = 2~\text{m/s}") == "confirmed"


@CASES(
    "scale",
    [
        "The drawing is at the scale {}, and we read $l_1 = 10$ cm and $l_2 = 10$ cm in it.",
        "Die Zeichnung hat den Maßstab {}. Wir lesen $l_1 = 10$ cm und $l_2 = 10$ cm ab.",
        "Le dessin est à l'échelle {}, on y lit $l_1 = 10$ cm et $l_2 = 10$ cm.",
    ],
)
def test_lengths_of_a_drawing_are_those_of_its_scale(scale: str) -> None:
    for ratio, verdict in (("1:5", "unchecked"), ("1:1", "confirmed")):
        said = rf"{scale.format(ratio)} For $\theta_2 = 90^\circ$ the hand has the distance"
        assert _behind(said, r"\sqrt{x^2+y^2} = 14.1~\text{cm}") == verdict


@CASES(
    ("lengths", "value", "verdict"),
    [
        (r"$l_1 = 1.000$ mm und $l_2 = 1.500$ mm", r"2{,}5~\text{mm}", "unchecked"),
        (r"$l_1 = 0.250$ m und $l_2 = 1.500$ m", r"1.75~\text{m}", "confirmed"),
        (r"$l_1 = 1{,}5$ mm und $l_2 = 1$ mm", r"2{,}5~\text{mm}", "confirmed"),
    ],
)
def test_a_point_may_part_thousands(lengths: str, value: str, verdict: str) -> None:
    said = rf"Die Stangen sind {lengths} lang. Der Arm liegt gestreckt, $\theta_1 = \theta_2 = 0$. Das Werkzeug ist bei"
    assert _behind(said, f"x = {value}") == verdict


@CASES(
    ("cites", "held"),
    [
        ("The parameters are those of the book [1].", 2),
        ("Die Tabelle folgt der Schreibweise aus [1].", 2),
        ("Les paramètres sont ceux de [1].", 2),
    ],
)
def test_a_cited_author_tells_the_convention(cites: str, held: int) -> None:
    rows = (
        r"| 1 | 0 | 0 | $\theta_1$ | $h$ |"
        "\n"
        r"| 2 | 90° | $b$ | $\theta_2$ | 0 |"
        "\n"
        r"| 3 | 0 | $l_2$ | $\theta_3$ | 0 |"
    )
    text = f"# Arm\n\n{cites}\n\n| $i$ | $\\alpha$ | $a$ | $\\theta$ | $d$ |\n|---|---|---|---|---|\n{rows}\n\nThe height is\n\n$$ z = h + l_2 \\sin\\theta_%d $$\n\n[1] J. J. Craig, *Robotics*.\n"
    assert verify_text(text % held).equations[-1].verdict.value == "proved"
    assert verify_text(text % 3).equations[-1].verdict.value == "unchecked"
    other = text.replace("J. J. Craig", "A. Author")
    assert verify_text(other % 3).equations[-1].verdict.value == "proved"


def test_a_heading_may_be_the_name_of_an_arm() -> None:
    head = "| $i$ | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |\n|---|---|---|---|---|\n| 1 | $\\theta_1$ | 0 | $l_1$ | 0 |\n"
    tables = f"Robot Anna:\n\n{head}| 2 | $\\theta_2$ | 0 | $l_2$ | 0 |\n\nRobot Berta:\n\n{head}| 2 | $\\theta_2 + 90°$ | 0 | $l_2$ | 0 |\n"
    wrong = r"$$ x = l_1 \cos\theta_1 - l_2\sin(\theta_1+\theta_2) $$"
    text = f"# Two robots\n\n{tables}\n## %s\n\nThe hand is at\n\n{wrong}\n"
    assert verify_text(text % "Anna").equations[-1].verdict.value == "unchecked"
    assert verify_text(text % "Berta").equations[-1].verdict.value == "proved"
