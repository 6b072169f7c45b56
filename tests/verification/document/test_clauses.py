"""Sentences are heard by their clauses: what they are of, and what kinds of words they have; each beside one that says nothing."""

from __future__ import annotations

import pytest

from armproof.verification.document.clauses import clauses, goes_on
from armproof.verification.document.denials import denies_behind, faults_another, heading_denies
from armproof.verification.document.denying_clauses import (
    denies_what_is_above,
    denies_what_is_below,
    judges_in_other_words,
)
from armproof.verification.document.hearing import words_of
from armproof.verification.document.limiting_clauses import is_whole, limits_what_is_above, limits_what_is_below


@pytest.mark.parametrize(
    ("sentence", "subjects"),
    [
        ("The units match, but the formula is not the right one.", ["letter", "display"]),
        ("In this line the sign is wrong.", ["part"]),
        ("The third column is right, and it is used below.", ["part", "part"]),
        ("Le signe du deuxième terme est faux.", ["part"]),
        ("Das Vorzeichen stimmt nicht.", ["part"]),
    ],
)
def test_a_clause_is_of_its_noun_or_of_what_the_one_before_it_is(sentence: str, subjects: list[str]) -> None:
    assert [each.subject for each in clauses(words_of(sentence))] == subjects


@pytest.mark.parametrize(
    ("denies", "says_nothing"),
    [
        ("The units match, but the formula is not the right one.", "This equation cannot be solved for both angles."),
        ("The second angle was not added to the first here.", "The second angle is not known."),
        ("The second link was forgotten.", "The second link was drawn in red."),
        ("The author later corrected this entry.", "The author derives this entry."),
        ("Il faut corriger le dernier indice.", "Il faut connaître le dernier indice."),
        ("Esta fórmula no es válida para este brazo.", "Esta fórmula no depende del brazo."),
        ("which holds only when it is fully retracted.", "so the arm loses rank only when it is fully retracted."),
        ("so only if $q_2 > 0$.", "so the arm is singular only if $q_2 = 0$."),
        ("nur mit höchstens einem Gelenk.", "Der Antrieb des Schubgelenks soll mit höchstens"),
        ("which was fully retracted.", "which is largest when it is fully retracted."),
        (
            "This is a common error: to write $x = 1$, which gives",
            "A common error is to write $x = 1$, which would give",
        ),
        (
            "Une erreur classique est dans cette formule, où",
            "Une erreur classique consiste à écrire $x = 1$, ce qui donne",
        ),
        ("Nobody can derive this.", "Nobody can see the axis."),
        ("if and only if $a = b$.", "for all angles."),
    ],
)
def test_a_clause_of_the_display_denies_what_stands_above_it(denies: str, says_nothing: str) -> None:
    assert denies_what_is_above(words_of(denies))
    assert not denies_what_is_above(words_of(says_nothing))


@pytest.mark.parametrize(
    ("denies", "says_nothing"),
    [
        ("It is not correct that", "It is easy to see that"),
        ("Several students have written", "Students should be able to write"),
        ("The old version of the script said", "The version of this script says"),
        ("Non bisogna confondere la posizione con", "Occorre ricordare che"),
        ("On croit souvent que", "Les termes croisés se regroupent :"),
    ],
)
def test_a_clause_denies_what_it_leads_to(denies: str, says_nothing: str) -> None:
    assert denies_what_is_below(words_of(denies))
    assert not denies_what_is_below(words_of(says_nothing))


@pytest.mark.parametrize(
    ("limits", "says_nothing"),
    [
        ("This is valid near the home position.", "This is valid for all postures."),
        ("The formula applies as long as the first joint is locked.", "The formula applies to all arms."),
        ("The terms of second order have been dropped.", "The terms of both links have been added."),
    ],
)
def test_a_condition_limits_what_stands_above_it_unless_it_is_general(limits: str, says_nothing: str) -> None:
    assert limits_what_is_above(words_of(limits))
    assert not limits_what_is_above(words_of(says_nothing))


@pytest.mark.parametrize(
    ("limits", "says_nothing"),
    [
        ("If the first link lies along the wall, then", "If we add both vectors, then"),
        ("In the frame of the second link, we have", "In the base frame, we have"),
        ("Assuming the shoulder locked, we obtain", "Assuming rigid links, we obtain"),
        ("Se il primo giunto è fermo,", "Con la somma dei vettori,"),
    ],
)
def test_a_circumstance_limits_what_it_leads_to(limits: str, says_nothing: str) -> None:
    assert limits_what_is_below(words_of(limits))
    assert not limits_what_is_below(words_of(says_nothing))


@pytest.mark.parametrize(
    ("denies", "says_nothing"),
    [
        ("A wrong solution", "A letter twice"),
        ("Sign errors", "Tracking error"),
        ("Erreur de signe", "Les termes oubliés par la linéarisation"),
        ("This sign is wrong", "The terms between left out"),
    ],
)
def test_a_heading_denies_by_what_it_calls_wrong(denies: str, says_nothing: str) -> None:
    assert heading_denies(denies)
    assert not heading_denies(says_nothing)


@pytest.mark.parametrize(
    ("judges", "says_nothing"),
    [
        ("This is a lie.", "This is the speed of the tip."),
        ("Das ist Schwindel.", "Das ist die Lage des Ursprungs."),
        ("Está patas arriba.", "Está en la posición de reposo."),
        ("Not even close.", "Not in the plane of the second link."),
    ],
)
def test_what_is_said_of_it_in_words_of_no_known_kind_may_deny_it(judges: str, says_nothing: str) -> None:
    assert judges_in_other_words(words_of(judges))
    assert not judges_in_other_words(words_of(says_nothing))


@pytest.mark.parametrize(
    ("of_this", "of_another"),
    [
        ("The index of the last term is wrong.", "A common mistake is to forget the last term."),
        ("a frequent mistake.", "A frequent mistake is to forget the sine."),
        ("The careful reader has found the mistake.", "Your code forgot the 90°."),
    ],
)
def test_what_is_wrong_is_this_or_something_else(of_this: str, of_another: str) -> None:
    denied = [denies_behind(each) and not faults_another(each) for each in map(words_of, (of_this, of_another))]
    assert denied == [True, False]


@pytest.mark.parametrize("said", ["The arm is singular if and only if", "Le bras est singulier si et seulement si"])
def test_if_and_only_if_denies_nothing(said: str) -> None:
    assert not denies_what_is_above(words_of(said))
    assert not denies_what_is_below(words_of(said))


@pytest.mark.parametrize("sentence", ["if the arm is straight and nothing else is in its way.", "d'où le reste."])
def test_a_sentence_goes_on_that_begins_with_a_small_letter_or_is_short(sentence: str) -> None:
    assert goes_on(words_of(sentence))
    assert not goes_on(f"(if the {'very ' * 20}long arm is straight) ")


def test_a_clause_of_one_article_leads_to_no_whole() -> None:
    assert is_whole("The full Jacobian would be ")
    assert not any(map(is_whole, ("The . ", "La : ", "the ", "Full Jacobian ")))
