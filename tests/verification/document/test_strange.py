"""Sentences whose words no course has beside a display leave it open; those of courses do not."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from armproof.verification.document.strange import is_strange_before
from armproof.verification.findings import Kind
from armproof.verification.verdict import Verdict

RIGHT, WRONG = "x = l_1 c_1 + l_2 c_{12}", "x = l_1 c_1 + l_2 c_2"
STRANGE_ABOVE = (
    "which is a gem.",
    "This was my cousin's idea of a joke.",
    "It begs belief.",
    "The formula limps.",
    "Somebody ought to have drawn a picture first, and the referee ought to have noticed.",
    "One subscript got lost at the printer's.",
    "which has cost me a whole afternoon.",
    "Cela sent le roussi.",
    "La formule boite, et le correcteur n'y a vu que du feu.",
    "Das ist reine Dichtung.",
    "Esto huele a chamusquina.",
    "Die Formel geht ins Auge.",
    "Questa formula zoppica.",
    "It does the reader a disservice.",
    "There is a catch.",
    "Elle prend l'eau.",
    "C'est à refaire.",
    "Le correcteur a vu rouge.",
    "Hier lag der Autor daneben.",
    "El profesor puso una cruz.",
    "Es para tirar.",
    "È superata.",
    "Non sta in piedi.",
    "É um desatino.",
    "Faz água.",
    "Sie verliert ein Glied.",
    "It loses a term.",
    "It loses a sign, and the rank.",
    "La fórmula pierde un signo.",
    "Sonst stimmt die Formel.",
)
STRANGE_BELOW = (
    "In a dark corner of the archive I unearthed the following gem:",
    "The grapevine has it that",
    "Un confrère facétieux a griffonné sous la figure",
    "Mein Nachbar schwört Stein und Bein, dass",
    "A friend gave this:",
    "Mon voisin trouve :",
    "En gros, on a",
    "À vue de nez,",
    "Aus dem Bauch heraus:",
    "A ojo de buen cubero,",
    "Un amico trova:",
    "Everybody writes",
    "Quien corre escribe",
    "A olho,",
)
PLAIN_ABOVE = (
    "Interessant wird es, wo die Matrix $J$ den Rang verliert.",
    "Das Ziel liegt für größere Abstände außerhalb des Kreisrings.",
    "The arm is stretched where the matrix $J$ loses rank.",
    "There the arm loses one degree of freedom.",
    "Le bras perd alors un degré de liberté.",
    "En esta posición el brazo pierde un grado de libertad.",
    "In questa posizione il braccio perde un grado di libertà.",
    "Nessa posição o braço perde um grau de liberdade.",
    "Es wird interessant, wo $J$ den Rang verliert.",
    "Bedingung: $r \\le l_1 + l_2$, sonst liegt das Ziel außerhalb des Kreisrings.",
    "Otherwise the target lies outside the workspace.",
    "This gives the position without using inverse trigonometric functions.",
    "On obtient la position sans utiliser les fonctions inverses.",
    "Ove $c_1 = \\cos\\theta_1$ e $s_1 = \\sin\\theta_1$.",
    "Pour la suite, nous avons laissé à Python le soin de résoudre le système :",
    "On utilise ensuite la propriété cos² + sin² = 1.",
    "Deixando em função de $\\theta_1$, temos",
    "so $O_3$ never leaves the workspace.",
    "For the base the last joint turns the other way.",
    "This is the position of the gripper in the base frame.",
    "It follows that the arm reaches every point of the workspace.",
    "The second term is the contribution of the forearm.",
    "The gripper then stands in front of the base.",
    "where $l_1$ and $l_2$ are the lengths of the links.",
    "The velocities are found by differentiating with respect to time.",
    "Cette relation donne la position de l'outil dans le repère de base.",
    "La seconde coordonnée s'obtient de la même façon.",
    "Das ist die Position des Greifers im Basiskoordinatensystem.",
    "Esta es la posición de la pinza respecto a la base.",
    "Man erkennt Kugelkoordinaten um den Punkt $P$.",
    "mentre quella verticale è semplicemente",
    "por lo que las singularidades son las del subrobot 2R.",
    "The encoder readings are then stored in the microcontroller.",
    "Nous récupérons ensuite cette valeur dans le programme.",
    "Nous pouvons maintenant nous attaquer au reste.",
    "Die beiden Achsen werden über Zahnriemen angetrieben.",
    "En la práctica siguiente programaremos el microcontrolador.",
    "Nel prossimo paragrafo ricaveremo anche la velocità.",
    "Em seguida programaremos o microcontrolador no laboratório.",
)
PLAIN_BELOW = (
    "*Corrigé.* On calcule d'abord la position de l'outil :",
    "Dabei gilt ferner",
    "Il peso del braccio mobile richiede inoltre una forza costante, pari a",
    "La rodilla estirada y el pie en el suelo dan",
    "Multiplying the link matrices and reading the last column, we get",
    "The forward kinematics of the planar arm is therefore given by the equation",
    "En multipliant les matrices de passage, on obtient la position de l'outil :",
    "Durch Multiplikation der Matrizen ergibt sich",
    "Multiplicando las matrices de transformación se obtiene",
    "Moltiplicando le matrici si ottiene la posizione del polso:",
    "Multiplicando as matrizes obtemos a posição da garra:",
    "Reformulate as:",
    "On récupère ensuite la valeur",
    "Après avoir fini cela, nous pouvons nous attaquer au reste",
    "Avec tes lettres :",
    "Ausladung des Flansches:",
    "Para ello, partimos de la siguiente matriz",
    "Mentre ci troveremo di fronte al problema che",
    "Vejamos agora como chegaremos ao resultado:",
)


@pytest.mark.parametrize("sentence", STRANGE_ABOVE)
def test_a_strange_sentence_leaves_the_display_above_it_open(sentence: str) -> None:
    for latex in (RIGHT, WRONG):
        assert _told(f"$$ {latex} $$\n\n{sentence}\n") == (Verdict.UNCHECKED, [Kind.STRANGE_WORDS])


@pytest.mark.parametrize("sentence", STRANGE_BELOW)
def test_a_strange_sentence_leaves_the_display_below_it_open(sentence: str) -> None:
    for latex in (RIGHT, WRONG):
        assert _told(f"{sentence}\n\n$$ {latex} $$\n") == (Verdict.UNCHECKED, [Kind.STRANGE_WORDS])


@pytest.mark.parametrize("sentence", PLAIN_ABOVE)
def test_a_plain_sentence_leaves_the_verdict_above_it_as_it_is(sentence: str) -> None:
    assert _told(f"$$ {RIGHT} $$\n\n{sentence}\n") == (Verdict.PROVED, [])
    assert _told(f"$$ {WRONG} $$\n\n{sentence}\n")[0] is Verdict.REFUTED


@pytest.mark.parametrize("sentence", PLAIN_BELOW)
def test_a_plain_sentence_leaves_the_verdict_below_it_as_it_is(sentence: str) -> None:
    assert _told(f"{sentence}\n\n$$ {RIGHT} $$\n") == (Verdict.PROVED, [])
    assert _told(f"{sentence}\n\n$$ {WRONG} $$\n")[0] is Verdict.REFUTED


def test_the_words_that_are_not_known_are_told() -> None:
    (found,) = _check(f"$$ {RIGHT} $$\n\nThe grapevine has it that the arm limps.\n")
    (finding,) = found.outcomes[0].findings
    assert finding.terms["words"] == "grapevine, limps"


def test_a_long_formula_in_a_strange_sentence_is_not_quoted() -> None:
    long = "$" + " + ".join(f"l_{each} c_{each}" for each in range(1, 9)) + "$"
    (found,) = _check(f"$$ {RIGHT} $$\n\nThe grapevine has it that {long} limps and $c_1$ not.\n")
    (finding,) = found.outcomes[0].findings
    assert finding.terms["text"] == "The grapevine has it that … limps and $c_1$ not."


def test_a_strange_sentence_is_of_the_display_beside_it_alone() -> None:
    found = _check(f"$$ {RIGHT} $$\n\nIt limps.\n\n## Again\n\n$$ y = l_1 s_1 + l_2 s_{{12}} $$\n")
    assert [each.verdict for each in found] == [Verdict.UNCHECKED, Verdict.PROVED]


def test_a_language_whose_words_are_not_known_is_not_strange() -> None:
    polish = (
        "Ramię płaskie składa się z dwóch członów połączonych przegubami obrotowymi, a oba kąty mierzymy przeciwnie do ruchu "
        "wskazówek zegara. Drugi kąt mierzymy względem pierwszego członu. Macierze przejścia otrzymujemy z tabeli parametrów, "
        "mnożąc cztery przekształcenia elementarne. Położenie chwytaka w układzie podstawy wynika z iloczynu obu macierzy, "
        "którego ostatnia kolumna zawiera szukane współrzędne:"
    )
    assert _told(f"{polish}\n\n$$ {RIGHT} $$\n\nDruga współrzędna wynika stąd tak samo.\n")[0] is Verdict.PROVED


def _check(body: str) -> list:
    return check_document(parse_document(Path("page.md"), f"---\narm: planar_2r\n---\n\n{body}")).equations


def _told(body: str) -> tuple[Verdict, list[Kind]]:
    (found,) = _check(body)
    return found.verdict, [each.kind for each in found.outcomes[0].findings]


@pytest.mark.parametrize(
    "sentence",
    [
        "일반식은 다음과 같다.",
        "其中各参数如下：",
        "Матрица перехода записывается так.",
        "최종 end-effector의 위치벡터는",
    ],
)
def test_a_sentence_in_another_script_is_not_strange_in_a_document_in_it(sentence: str) -> None:
    for side in (f"{sentence}\n\n$$ {RIGHT} $$", f"$$ {RIGHT} $$\n\n{sentence}"):
        assert _told(side)[0] is Verdict.PROVED


@pytest.mark.parametrize(
    "sentence",
    [
        "次の式は正しくない。",
        "以下公式是错误的：",
        "Это неверно:",
        "Αυτό είναι λάθος:",
        "هذا غير صحيح",
        "זה לא נכון:",
        "이것은 틀렸다:",
    ],
)
def test_a_sentence_in_another_script_is_not_understood_among_ours(sentence: str) -> None:
    ours = "# The arm in the plane\n\nThe tool of the planar arm with two revolute joints has the coordinates below, as every course has them."
    for side in (f"{sentence}\n\n$$ {RIGHT} $$", f"$$ {RIGHT} $$\n\n{sentence}"):
        assert _told(f"{ours}\n\n{side}") == (Verdict.UNCHECKED, [Kind.STRANGE_WORDS])
    assert _told(f"{ours}\n\nWith the angles $\\alpha$ and β it is\n\n$$ {RIGHT} $$")[0] is Verdict.PROVED


def test_a_sentence_with_one_word_in_another_script_is_judged_by_the_others() -> None:
    assert _told(f"$$ {RIGHT} $$\n\nThis was my cousin 王's idea of a joke.")[0] is Verdict.UNCHECKED


def test_a_comment_is_no_sentence() -> None:
    for path, text in (
        ("page.rst", f".. arm: planar_2r\n\n.. My cousin swears by this joke.\n\n.. math:: {RIGHT}\n"),
        ("page.tex", f"% arm: planar_2r\n\n% My cousin swears by this joke.\n\\[ {RIGHT} \\]\n"),
        ("page.md", f"---\narm: planar_2r\n---\n\n<!-- My cousin swears by this joke. -->\n\n$$ {RIGHT} $$\n"),
    ):
        (found,) = check_document(parse_document(Path(path), text)).equations
        assert found.verdict is Verdict.PROVED, path


@pytest.mark.parametrize(
    ("words", "strange", "least"), [("the", 2, 18), ("the", 3, 27), ("the robot", 3, 15), ("the robot", 4, 20)]
)
def test_one_strange_word_in_nine_is_too_many_and_in_a_sentence_of_the_arm_one_in_five(
    words: str, strange: int, least: int
) -> None:
    known = [*words.split(), *["the"] * least]
    odd = ["zorple", "blixen", "quamble", "frotzen"][:strange]
    said, longer = (" ".join([*known[: count - strange], *odd]) + " " for count in (least, least + 1))
    assert is_strange_before(said) and not is_strange_before(longer)
