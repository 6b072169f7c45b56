"""Headings that are stages of one derivation: what the direct geometry of an arm defines, its inverse and its velocities use."""

from __future__ import annotations

import re

from armproof.verification.document.heading import encloses, sections_around
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

_is = WordLists("""
STAGE kinematic~ inverse inversion direct direkte vorwärtsrechnung rückwärtsrechnung vorwärtskinematik rückwärtskinematik rate rates kinemati~ cinémati~ cinemáti~ cinemati~ geometry geometric géométri~ geometr~ geometri~ geometrí~ dynamic~ static~ stati~ estáti~ dynami~ dinámi~ dinâmi~ dinami~ position~ posición posición~ posizion~ posiç~ lage orientation~ orientación orientamento orientierung pose poses posa velocity velocities speed~ vitesse~ geschwindigkeit~ velocidad~ velocità acceleration~ accélération~ beschleunigung~ aceleraci~ accelerazion~ aceleraç~ jacobian~ jacobien~ jacobi~ singular~ singulari~ singolar~ determinant~ déterminant~ force~ torque~ effort~ couple~ kräfte kraft drehmoment~ momente statik fuerza~ par pares esfuerzo~ forze coppie forças mgd mgi mcd mci dkm ikm fk ik differential~ différentiel~ differenti~ diferencia~ differenzial~ workspace reach espace atteignable arbeitsraum trabajo lavoro trabalho area volume check~ verification~ vérification~ probe kontrolle comprobación verifica~ numeric~ numéri~ numeri~ numéric~
FILLER the a an of and for to in by with at from its our arm robot manipulator mechanism leg tool hand gripper end effector tip wrist elbow analysis model modelling modeling problem problems solution solutions equations equation forward backward matrix matrices first second order derivation computation calculation formulas law laws closed form all joint angles angle coordinates le la les l' d' du de des et en au aux un une pour son ses notre bras manipulateur mécanisme jambe outil main pince effecteur organe terminal poignet coude analyse modèle modélisation problème problèmes directe directs inverses résolution équation équations matrice calcul ordre loi lois der die das dem den und für von im zu mit unser roboter werkzeug greifer modell lösung lösungen gleichungen vorwärts rückwärts direktes berechnung el los las del y para con nuestro brazo manipulador herramienta pinza análisis modelo problema solución directa directo inversa inverso matriz ecuaciones cálculo il lo i gli della dello dei delle dell' e per nostro braccio manipolatore analisi modello soluzione diretta diretto equazioni calcolo o os as do da dos com nosso braço robô garra análise solução direta direto equações
""").holds
_WORDS = regex(r"[^\W\d_]+'?")
_NUMBERED = regex(
    r"\s*(?:(?:step|étape|schritt|paso|passo|part|partie|teil|parte)\b\s*)?(?:\d+(?:\.\d+)*|[ivx]+|[a-z])\s*[.):–-]\s*",
    re.IGNORECASE,
)


def goes_on(outer: str, inner: str) -> bool:
    """Whether what one section defines holds in another: that is below it, or both are stages of one derivation under the same headings."""
    if encloses(outer, inner):
        return True
    around = sections_around(outer)
    beside = next((each for each in (inner, *sections_around(inner)) if sections_around(each) == around), None)
    return beside is not None and _is_stage(outer) and _is_stage(beside)


def _is_stage(section: str) -> bool:
    """Whether a heading is of a stage and says nothing else: "2. Inverse kinematics of the arm", but "The second robot: kinematics" is of another."""
    words = _WORDS.findall(_NUMBERED.sub("", section.replace("’", "'").lower(), count=1))
    are_stages = [_is(word, "STAGE") for word in words]
    return any(are_stages) and all(
        is_stage or _is(word, "FILLER") for word, is_stage in zip(words, are_stages, strict=True)
    )
