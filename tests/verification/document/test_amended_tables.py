"""Which sentences amend the table of an arm, and which tell what stands there."""

from __future__ import annotations

import pytest

from armproof.verification.document.amended_tables import Cells, amends_table, has_same_table
from armproof.verification.document.hearing import formulas_of, words_of

TABLE = Cells(3, 6, r"1 & l_1 & 0 & 0 & \theta_1 & 2 & l_2 & 0 & 0 & \theta_2")
AMENDS = [
    r"In the second row read $-\theta_2$ instead of $\theta_2$.",
    "* row 2: add 90° to the angle.",
    "† plus a right angle.",
    "The lengths in the table are to be taken negative.",
    "Our arm has half of these lengths.",
    r"The printer has swapped $l_1$ and $l_2$ in this table.",
    "Ignore the last row of the table.",
    r"The sign of $\alpha_1$ in the table is wrong.",
    "The first length of the table should be zero.",
    r"Unlike in the table, our $\theta_2$ is measured from the horizontal.",
    "Between rows 1 and 2 insert a fixed row.",
    r"À la deuxième ligne, il faut lire $-\theta_2$.",
    "In der zweiten Zeile ist zum Winkel noch 90° zu addieren.",
    "En la tabla hay una errata.",
    r"Nella tabella, all'angolo della seconda riga va aggiunto $\pi/2$.",
    "Os comprimentos da tabela devem ser multiplicados por dois.",
]
TELLS = [
    "The second row of the table describes the forearm.",
    "We read off the lengths in the table.",
    "Add the angles of rows 1 and 2 to get the orientation.",
    r"In row 2 the angle is $\theta_2$.",
    "* joint variable.",
    "The second row of the matrix should be zero.",
    "Is the table wrong?",
    "Errors in the table are common, check them.",
    "The table lists the parameters of the arm.",
    "La deuxième ligne du tableau est celle de l'avant-bras.",
    "Die Tabelle nennt die Parameter.",
]


@pytest.mark.parametrize("sentence", AMENDS)
def test_a_sentence_that_amends_the_table_is_heard(sentence: str) -> None:
    assert amends_table(words_of(sentence), formulas_of(sentence), TABLE, 8)


@pytest.mark.parametrize("sentence", TELLS)
def test_a_sentence_that_tells_of_the_table_amends_nothing(sentence: str) -> None:
    assert not amends_table(words_of(sentence), formulas_of(sentence), TABLE, 8)


def test_a_size_that_the_table_has_is_not_added() -> None:
    told = words_of("* The 90° in row 2 is added since the forearm is perpendicular.")
    assert amends_table(told, [], TABLE, 8)
    assert not amends_table(told, [], Cells(3, 6, r"\theta_2 + 90°"), 8)


def test_rows_far_from_the_table_are_not_its_own() -> None:
    assert not amends_table(words_of("In row 2 add 90° to the angle."), [], TABLE, 80)
    assert amends_table(words_of("In row 2 of the table add 90° to the angle."), [], TABLE, 80)


def test_another_arm_has_the_same_table_but_for_something() -> None:
    assert has_same_table(words_of("The second robot has the same table but with other lengths."))
    assert not has_same_table(words_of("Both robots have the same table."))
