r"""That what follows is written to first order: "to first order in the three errors", "On développe au premier ordre."."""

from __future__ import annotations

from armproof.verification.patterns import regex

FIRST_ORDER = "first order"

MAY_BE_FIRST_ORDER = regex(
    r"order|ordre|ordnung|orden|ordem|ordin|small|petit|klein|pequeñ|piccol|pequen|infinit|line|liné"
)
_TO_FIRST_ORDER = regex(
    r"(?<!\S)(?:first[ -]order|(?:au|du) premier ordre|à l' ordre (?:un|1|¤)|(?:in |von )?erster ordnung|(?:de |a )?primer orden|(?:al )?primo ordine|primeira ordem"
    r"|(?:second|higher)[ -]order (?:terms?|quantities)|terms? of (?:second|higher) order|(?:termes?|infiniment petits) d(?:u|' un) (?:second|deuxième) ordre|terme zweiter ordnung"
    r"|(?:very |sufficiently )?small (?:angles?|rotations?|errors?|motions?|displacements?|deviations?)|infinitesimal(?:ly)?|infinitésimale?s?|petits (?:angles|déplacements|mouvements)|petites (?:rotations|erreurs)|(?:très )?kleine[nr]? (?:winkel|drehungen|fehler)"
    r"|ángulos pequeños|piccoli angoli|pequenos ângulos|linear(?:is|iz)\S*|linéaris\S*|linealiz\S*) "
)
_DENIED = regex(r"(?<!\S)(?:not|no|without|beyond|neither|pas|sans|nicht|ohne|no|non|sin|senza) (?:\S+ ){0,2}\Z")


def is_to_first_order(words: str) -> bool:
    """Whether a sentence says that something is so to first order, or of small angles."""
    found = _TO_FIRST_ORDER.search(words.lower())
    return found is not None and _DENIED.search(words.lower()[: found.start()]) is None
