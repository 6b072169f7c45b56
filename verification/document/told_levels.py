r"""Sentences of instruments that show how a link lies in space, and not against the link before: a pendulum, a spirit level or a gyroscope on each bar."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.word_lists import WordLists

# in small letters: what no such sentence lacks
MAY_READ_LEVEL = r"pend[uo]l|péndul|pêndul|pendel|inclinom|inclinóm|inclinôm|clinomet|neigungsmess|gyro|giro|giró|kreisel|spirit level|water level|bulle|burbuja|bolha|wasserwaage|livell|plumb|plomb|plomada|piombo|prumo|senklot|compass|boussole|kompass|brújula|bussola|bússola"
_NEAR = 3
_is = WordLists("""
SHOWS_LEVEL inclinomet~ inclinomèt~ inclinómet~ inclinômet~ clinomet~ neigungsmess~ gyro~ giroscop~ giróscop~ kreisel~ wasserwaage~ livell~ plumb plumb-line plomada prumo senklot~ spirit bulle burbuja bolha compass~ boussole~ kompass~ brújula~ bussol~ bússola~
SWINGS pendulum~ pendule~ pendel~ péndulo~ pendol~ pêndulo~
READS reading~ read reads scale~ show~ indicat~ measur~ display~ lecture~ cadran~ échelle indique~ mesure~ affiche~ zeig~ anzeig~ misst messen skala ablesung lectura~ escala indica~ muestra~ mide~ lettur~ scala misur~ mostra~ leitura~ mede medem
PLAIN double inverted inversé~ doppel~ doble invertido doppio inverso duplo simple single physical
NOT no not never without neither sans pas ohne kein~ nicht sin senza sem não non
""").holds


def reads_level(said: Sequence[str]) -> bool:
    """Whether a sentence is of an instrument on a link that shows its direction in space."""
    at = [place for place, word in enumerate(said) if _is(word, "SHOWS_LEVEL") or _is(word, "SWINGS")]
    if not at or any(_is(word, "NOT") for place in at for word in said[max(0, place - _NEAR) : place]):
        return False
    if any(_is(said[place], "SHOWS_LEVEL") for place in at):
        return True
    is_plain = any(_is(word, "PLAIN") for place in at for word in said[max(0, place - _NEAR) : place + 2])
    return not is_plain and any(_is(word, "READS") for word in said)
