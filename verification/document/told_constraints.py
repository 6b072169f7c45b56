r"""That the tool is held to something, "slides along a wall", "$y$ is constant", or that a coordinate or an angle is always negative.

What follows from it is not computed: rates that the arm does not have freely are not refuted, and no sign of a root is chosen.
"""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.patterns import regex

CONSTRAINED = "constrained"  # the tool is: its rates are related
NEGATIVE = "negative"  # an angle or a coordinate is, wherever it goes

MAY_CONSTRAIN = regex(
    r"along|constant|konstant|costante|le long|entlang|negati|négati|between|from|entre|zwischen|da\b"
)
_SURFACE = r"(?:wall|floor|edge|table|ground|surface|ceiling|board|plate|window|mur|sol|bord|table|surface|plafond|tableau|plaque|wand|boden|kante|tisch|fläche|oberfläche|decke|tafel|pared|suelo|borde|mesa|superficie|techo|parete|pavimento|bordo|tavolo|soffitto|parede|chão)"
_SLIDES = regex(  # and not along an axis or a rail, as a joint does
    rf"(?<!\S)(?:slides?|glides?|sliding|drags?|moves?|runs?|travels?|moving|glissent?|glisse|gleitet|desliza|scivola) (?:\S+ ){{0,2}}?(?:along|on|down|up|over|long|sur|entlang|an|auf|por|sobre|lungo|largo) (?:\S+ ){{0,3}}?{_SURFACE} (?!(?:axis|axes|rails?|tracks?|direction) )"
)
_IS_CONSTANT = regex(
    r"¤ (?:is|stays|remains|est|reste|demeure|ist|bleibt|es|permanece|è|resta|é) (?:kept |held |maintenue? |mantenid[oa] )?(?:constante?|konstant|costante) "
)
_COORDINATE = regex(r"\s*(?:[xyzr]|[pP]_\{?\w\}?|\\(?:var)?(?:phi|rho))\s*(?:=[^=]*)?")
_NEGATIVE = regex(
    r"(?<!\S)(?:(?:is|are|stays?|remains?|has|have) (?:always |only |everywhere |here |throughout )*(?:an? |the )?negative|(?:est|sont|reste|restent|a|ont) (?:toujours |ici |partout )*(?:une? )?négati\S+|(?:ist|sind|bleibt) (?:immer |stets |hier )*negativ|(?:es|son|è|sono) (?:siempre |sempre )?negativ[oaie]s?) "
)
_CONDITIONAL = regex(
    r"(?<!\S)(?:if|when|where|whenever|unless|may|can|could|root|square|sign|signs|determinant|discriminant|argument|radicand|direction|sense|si|quand|lorsque|où|racine|signe|wenn|falls|wo|wurzel|or|ou|oder|positive|positif|positiv) "
)
_ANGLE_OR_COORDINATE = regex(r"\s*(?:\\(?:var)?(?:theta|phi|alpha|beta)|[qsxyz])(?:\s*_\s*\{?\s*\w+\s*\}?)?\s*")
_TO_NOUGHT = regex(r"(?<!\S)(?:between|from|entre|zwischen|von|de|da|tra) ¤ (?:and|to|et|à|und|bis|y|a|e) ¤ ")
_NOUGHT = regex(r"\s*0\s*(?:°|\^\s*\{?\s*\\circ\s*\}?)?\s*")


def constrains_tool(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence holds the tool to a line or a surface, or a coordinate to its value."""
    small = words.lower()
    if small.endswith("? "):
        return False
    found = _IS_CONSTANT.search(small)
    if found is not None:
        number = small.count("¤", 0, found.start())
        if number < len(formulas) and _COORDINATE.fullmatch(formulas[number]):
            return True
    return _SLIDES.search(small) is not None


def is_negative(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence says of an angle or a coordinate that it is always negative."""
    small = words.lower()
    if small.endswith("? ") or _CONDITIONAL.search(small):
        return False
    if _NEGATIVE.search(small) and any(map(_ANGLE_OR_COORDINATE.fullmatch, formulas)):
        return True
    found = _TO_NOUGHT.search(small)
    number = small.count("¤", 0, found.start()) if found is not None else len(formulas)
    bounds = formulas[number : number + 2]
    return len(bounds) == 2 and bounds[0].strip().startswith("-") and _NOUGHT.fullmatch(bounds[1]) is not None
