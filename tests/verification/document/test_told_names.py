"""What sentences say names to be: a definition by other words than the usual ones leaves no usual meaning."""

from __future__ import annotations

import pytest

from armproof.verification.document.told_names import (
    OTHER,
    POINT,
    USUAL,
    WRIST,
    defined_in_rows,
    definitions,
    told_names,
)

OTHERS = (
    (r"Let $P_2$ be the middle of the second link.", "P_2"),
    (r"We call $p_1$ the position of the midpoint of the bar and $p_2$ that of the tool.", "p_1"),
    (r"We denote the middle of the first bar by $P_1$.", "P_1"),
    (r"The middle of the first bar is called $P_1$.", "P_1"),
    (r"where $P$ is the middle of the second bar.", "P"),
    (r"On note $O_1$ le milieu du premier segment et $O_2$ l'origine du repère 2.", "O_1"),
    (r"où $P_1$ désigne le barycentre de la barre.", "P_1"),
    (r"Mit $\omega_i$ bezeichnen wir die Winkelgeschwindigkeit gegen das vorhergehende Glied.", r"\omega_i"),
    (r"$v_2$ sei die Geschwindigkeit der Spitze, $v_1$ die der Mitte des ersten Glieds.", "v_1"),
    (r"Die Mitte des ersten Glieds wird mit $P_1$ bezeichnet.", "P_1"),
    (r"Sean $(x_1, y_1)$ las coordenadas de los centros de masa.", "x_1"),
    (r"Sia $p_1$ la posizione del punto medio del primo braccio.", "p_1"),
    (r"Seja $p_1$ a posição da câmera.", "p_1"),
    (r"Let $(r, \varphi)$ be the polar coordinates of the tool.", r"\varphi"),
    (r"The position error is $(x_e, y_e)$:", "x_e"),
    (r"- $x_2$, $y_2$ : coordonnées du centre de gravité de la barre", "x_2"),
)
USUALS = (
    r"Let $P_2$ be the end of the arm.",
    r"- $\phi$ is the total orientation relative to the base frame",
    r"On note $O$ l'origine du repère de base.",
    r"Mit $\omega_i$ bezeichnen wir die Winkelgeschwindigkeit gegen die Basis.",
    r"Let $\omega$ be the angular velocity of the tool relative to the base.",
    r"where $P$ is the position of the tool centre point in the base frame.",
    r"- $J$ : jacobienne géométrique du robot",
    r"Sea $p$ la posición del extremo.",
    r"where $T$ is the product of all the matrices printed above.",
)


@pytest.mark.parametrize(("sentence", "name"), OTHERS)
def test_a_name_defined_by_other_words_has_no_usual_meaning(sentence: str, name: str) -> None:
    assert name in {each.name for each in told_names(definitions(sentence)) if each.place == OTHER}


@pytest.mark.parametrize("sentence", USUALS)
def test_a_definition_by_the_usual_words_tells_nothing_new(sentence: str) -> None:
    assert all(each.place in (USUAL, "tool") for each in told_names(definitions(sentence)))


@pytest.mark.parametrize(
    "sentence",
    [
        r"The determinant of $J$ is the product of two lengths.",
        r"Note that $\theta_1 + \theta_2$ is the angle of the tool.",
        r"The vector from $O_0$ to $O_1$ is",
        r"$J$ is singular there.",
        r"The hand is the far end of the forearm, at $(x, y)$.",
        r"Note where $z_2$ points.",
        r"Regardons comment $\theta_2$ varie.",
    ],
)
def test_what_defines_no_name_tells_none(sentence: str) -> None:
    assert not [*told_names(definitions(sentence))]


def test_a_pose_beside_a_joint_angle_is_no_angle() -> None:
    sentence = (
        r"where $x_i$ is the $i$-th component of the pose $\boldsymbol{x}$, and $\theta_j$ is the $j$-th joint angle."
    )
    found = {name: each.phrase for each in definitions(sentence) for name in each.listed}
    assert "pose" in found[r"\boldsymbol{x}"]
    assert "angle" in found[r"\theta_j"]


def test_points_behind_a_comma_are_defined_with_those_before_it_or_in_a_clause_of_their_own() -> None:
    sentence = r"where $p_1$, and $p_2$ are the midpoints, and $p_3$ is the middle of the third bar."
    assert {each.name for each in told_names(definitions(sentence))} == {"p_1", "p_2", "p_3"}
    sentence = r"where $p_3$ is the position of the tool $p$, and $p_1$ is the middle of the first bar."
    assert {each.name for each in told_names(definitions(sentence)) if each.place == OTHER} == {"p_1"}


def test_points_of_a_path_are_those_where_a_motion_begins_and_ends() -> None:
    found = [*told_names(definitions("The tool starts at $p_1$ and ends at $p_2$."))]
    assert [(each.name, each.place) for each in found] == [("p_1", POINT), ("p_2", POINT)]
    assert not [*told_names(definitions("The frame moves from $O_0$ to $O_1$."))]


def test_rows_of_a_table_define_names() -> None:
    (at, row), *others = defined_in_rows(
        "| name | meaning |\n|---|---|\n| $p_1$ | middle of bar 1 |\n| 1 | $l_1$ | 0 |"
    )
    (told,) = told_names([row])
    assert (told.name, told.place) == ("p_1", OTHER)
    assert at == len("| name | meaning |\n|---|---|\n")
    assert not others


def test_a_wrist_is_told_from_the_tool() -> None:
    (told,) = told_names(definitions("We denote by $J_3$ the Jacobian of the wrist."))
    assert told.place == WRIST
