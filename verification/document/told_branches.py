r"""Sentences that tell which of several solutions is meant: "$\theta_2$ is never positive", "every target has a negative $x$", "we keep the negative root", "reaching backward".

Where a sentence says of which sign a letter is, what follows is compared where it has that sign; a posture or a root in words alone
tells that one is meant, and not which.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from armproof.verification.document.told_sides import LEFT_OF_LINE, MAY_TELL_SIDE, RIGHT_OF_LINE, UNCLEAR, told_side
from armproof.verification.patterns import regex

BRANCH = "branch"  # the comparison that the sentence makes, as LaTeX; without one nothing tells which branch it is
MINUS_ROOT, PLUS_ROOT = "root -", "root +"  # that of any root
ABOVE_ZERO, BELOW_ZERO = ">", "<"

MAY_TELL_BRANCH = regex(  # what no such sentence lacks, in small letters
    r"positi|negati|négati|sqrt|between|entre|zwischen|minus|moins|plus|flip|back|behind|other side|opposite side|(?:left|right)[- ]hand|lefty|righty|left|right|arrière|derrière|gauche|droit|retourn|above|below|over|under|dessus|dessous|über|unter|oberhalb|encima|debajo|sopra|sotto"
    rf"|elbow|wrist|shoulder|coude|épaule|poignet|ellbogen|codo|gomito|cotovelo|{MAY_TELL_SIDE}"
)
_ANGLE = r"(?:\\(?:var)?theta|\\(?:var)?phi|\\psi|q|d)\s*_\s*\{?\s*\w+\s*\}?"
_LETTER = regex(  # of which a branch has one sign: a joint, its sine or cosine, a coordinate of the target
    rf"(?:{_ANGLE}|(?:\\(?:sin|cos)\s*(?:\\left)?\(?\s*|(?:s|c|S|C)\s*_?\s*\{{?\s*\d\s*\}}?|sin |cos )(?:{_ANGLE})?\s*(?:\\right)?\)?|[xyz]|[xyz]_\{{?\w\}}?|[pP]_\{{?[xyz]\}}?)"
)
_EXTENT = regex(r"-?\s*(?:\d+(?:\.\d+)?\s*(?:\^\s*\{?\s*\\circ\s*\}?|°)?|(?:\d\s*)?\\pi(?:\s*/\s*\d)?)")
_OF_ROOT = regex(r"(?P<name>[^=]+)=\s*(?P<sign>[+-]?)\s*\\sqrt\b.*")
_COMPARED = regex(r"(?P<name>[^<>=]+?)\s*(?P<relation><|>|\\lt|\\gt|\\leq?(?:slant)?|\\geq?(?:slant)?)\s*0")
_BENT = r"elbow|wrist|shoulder|coude|épaule|poignet|ellbogen|codo|gomito|cotovelo"
_CALLED = regex(  # two branches exist: elbow-up (¤) and elbow-down (¤)
    rf"(?<!\S)(?P<label>(?:{_BENT})[ -](?:up|down|left|right|above|below|haut|bas|gauche|droite|oben|unten|links|rechts|arriba|abajo|alto|basso|cima|baixo)) (?:(?:solution|branch|configuration|posture|case) )?¤"
)
_ON_CONDITION = regex(
    r"(?<!\S)(?:if|when(?:ever)?|in case|si|s' il|quand|lorsque|lorsqu'|wenn|falls|cuando|quando|se) "
)
_POSITIVE = r"(?:positi(?:ve[rsnm]?|fs?|ves|v|v[oa]s?))"
_NEGATIVE = r"(?:n[eé]gati(?:ve[rsnm]?|fs?|ves|v|v[oa]s?))"
_SIGN = rf"(?:(?P<positive>{_POSITIVE})|{_NEGATIVE})"
_SIGN_WORD = rf"(?:{_POSITIVE}|{_NEGATIVE})"
_IS = r"(?:is|are|be|being|been|stays?|remains?|has|est|sont|reste|soit|être|ist|sind|bleibt|sei|es|è|sia|sea|must|shall|will|can|doit|taken|chosen|kept|pris|prise|choisi|choisie)"
_ADVERB = r"(?:always|thus|then|therefore|hence|here|now|also|only|toujours|donc|alors|ici|aussi|never|not|jamais|pas|immer|nie|nicht|stets|siempre|nunca|sempre|mai)"
_NO_SIGN = (  # "positive when it lifts", "positive counter-clockwise" tell how it is counted
    r"(?! (?:, )?(?:if|when(?:ever)?|for|in|to|towards?|about|around|along|counter|anti|clock|up|down|left|right|axis|direction|sense|values?|rotation|angles?|is|means|lowers?|lifts?|raises?|moves?|turns?|bends?|"
    r"dans|vers|si|quand|lorsque|pour|autour|le|en|à|au|sens|wenn|nach|im|gegen|cuando|si|hacia|verso|quando)\w*)"
)
_SAID_OF = regex(
    rf"¤ (?:, |(?:(?!¤|{_IS} |{_SIGN_WORD} |(?:and|et|or|ou|und|to|with|avec|from|than) )[^\s,.;:]+ ){{1,5}}(?={_IS} ))?(?P<verb>(?:(?:{_IS}|{_ADVERB}) )*)(?:a |un |une |ein )?(?:value |valeur |wert )?{_SIGN}(?=\s){_NO_SIGN}"
)
_SAID_BEFORE = regex(
    rf"(?P<article>(?:\A|[.,;:] |(?<!\S)))(?:(?:a|an|un|une|the|le|la|with|avec|has|have) )*(?:(?P<noun>valeurs?|valores?|valore) )?(?P<sign>{_SIGN}) (?:(?:values?|wert|werte) )?(?:of |for |de |du |pour |von )?¤ (?P<behind>\S*)"
)
_OF_DIRECTION = regex(
    r"(?:along|towards?|about|around|in|on|from|of the|sur|vers|autour|selon|le long|l'|des|axes?) (?:the |of |du |de |des |les? |la )*\Z"
)
_DENIES = regex(r"\b(?:never|not|jamais|pas|nie|nicht|nunca|mai)\b")
_BETWEEN = regex(r"¤ (?:\S+ ){0,3}?(?:between|entre|zwischen|tra|from|de|von) ¤ (?:and|et|und|y|e|to|à|bis) ¤")
_OPEN_END = regex(r"¤ (?:[,.;:] )?")
_WHICH = r"(?:negative|minus|positive|plus|other|opposite|lower|upper|n[eé]gati(?:ve|f)|positi(?:ve|f))"
_SIDE = r"(?:left|right|lefty|righty|gauche|droite?)"
_POSTURE = r"(?:posture|elbow|shoulder|wrist|coude|épaule|poignet|arm (?:posture|configuration|solution))"
_HANDED = r"(?:left|right)-(?:handed|arm) (?:\(\S+ )?(?:posture|configuration|solution|branch|arm|elbow|case)|(?:left|lefty|righty) (?:solution|configuration|branch)"
_ROOT = regex(  # "the negative root", « la racine négative »
    rf"(?<!\S)(?:{_SIGN_WORD}|minus|plus) (?:square )?(?:roots?|sign)(?! (?:comes|is due|arises|reflects|means|in|before|of)(?= ))|(?:racine|signe) (?:{_SIGN_WORD}|moins|plus)(?! (?:comes|is|arises|reflects|means|in|before|of|vient|provient|est|devant|dans|tient)(?= ))"
)
_MINUS = regex(rf"{_NEGATIVE}|minus|moins")
_UNCLEAR = regex(  # which solution is meant, in words that no formula says
    rf"(?<!\S)(?:{_WHICH} (?:branch|determination)|(?:branch|branche|solution|elbow|coude|épaule|poignet|shoulder|wrist)s? (?:is |est )?(?:{_WHICH}|moins)(?! (?:si|if|when|quand|lorsque|vers|to|up)(?= ))"
    rf"|(?:{_WHICH}|{_SIDE})[- ](?:elbow|shoulder|wrist|coude)|{_SIDE} {_POSTURE}|{_HANDED}|(?:coude|épaule|bras|poignet) (?:à )?{_SIDE}|{_SIDE}-(?:shoulder|elbow|arm)"
    r"|(?:no|non|with|without|wrist) flip|flipped (?:wrist|solution|posture|configuration)|(?:wrist|poignet) (?:is |est )?(?:flipped|retourné)(?= |\Z)"
    r"|(?:reach\w*|bend\w*|bent|lean\w*|fold\w*|tend\w*|atteint|penché\w*|replié\w*|tourné\w*) (?:\S+ ){0,2}?(?:backwards?|behind|back over|over (?:its|the) (?:head|back|shoulder)|en arrière|vers l' arrière)"
    r"|(?:behind|on the (?:other|opposite|far) side of) (?:the |its )?(?:robot|arm|base|shoulder|column|(?:first |vertical )?axis)|(?:derrière|de l' autre côté (?:de|du)) (?:le |la |l' |son )?(?:robot|bras|base|épaule|axe|colonne)) ?"
)
_OF_ELBOW = regex(  # on which side of the line to the tool the elbow is
    r"(?<!\S)(?:elbow|coude|ellbogen|ellenbogen|codo|gomito|cotovelo) (?:(?:is|lies|stays|stands|being|lying|est|reste|liegt|ist|bleibt|está|è|sta) )?(?:(?P<above>above|over|au-dessus|über|oberhalb|encima|por encima|sopra|acima)|below|under|underneath|au-dessous|en dessous|unter|unterhalb|debajo|sotto|abaixo)(?= )(?! \S*(?:table|floor|ground|shoulder|base))"
)
_ELBOW_IS = regex(  # "elbow-up": of a planar arm that reaches forward, its elbow above the line to the tool
    r"(?<!\S)(?:elbow|coude|ellbogen|ellenbogen|codo|gomito|cotovelo)(?: |-)(?:(?:is|est|ist|está|è|en|vers le|para|hacia|verso l'|in) )*(?:(?P<up>up|haut|oben|arriba|alto|cima)|down|bas|unten|abajo|basso|baixo)(?![\w])"
)
_LINE_TO_TOOL = regex(
    r"(?<!\S)(?:line|chord|segment|straight line) (?:from|between|joining|through|of) (?:the )?(?:base|shoulder|origin)"
)
_TOOL_SIDE = regex(r"(?<!\S)(?:to|on|at) the (?P<side>right|left)(?! (?:hand|of the line))(?= )")
_BOTH = regex(rf"{_POSITIVE}\b.{{0,60}}?\b{_NEGATIVE}|{_NEGATIVE}\b.{{0,60}}?\b{_POSITIVE}|\b(?:left|gauche)\b.{{0,40}}?\b(?:right|droite?)\b|\b(?:right|droite?)\b.{{0,40}}?\b(?:left|gauche)\b|\bsigne? (?:of|de|du) ¤|\bsign of\b|\bsigne de\b|\b(?:either|both|les deux) sign", re.IGNORECASE)  # fmt: skip


@dataclass(frozen=True)
class ToldBranch:
    """What a sentence says of branches: of which letter, with what comparison; without either in words alone.

    What is said of a root, or on a condition, is `brief`: it is said of what the sentence leads to.
    """

    letter: str = ""
    bound: str = ""
    is_brief: bool = False

    def as_meant(self) -> str:
        """Return it as what holds of a display."""
        return f"{BRANCH} {self.bound}".strip()


def told_branches(words: str, formulas: Sequence[str]) -> Iterator[ToldBranch]:
    """Yield which branch a sentence tells; of one that tells both signs, the letters alone."""
    small, plain = words.lower(), [each.strip() for each in formulas]
    if small.count("¤") != len(plain):
        return
    if _BOTH.search(small):
        yield from (ToldBranch(_key(each)) for each in plain if _LETTER.fullmatch(each))
        return
    is_brief = _ON_CONDITION.search(small) is not None
    compared = () if is_brief else _of_comparisons(plain)
    if both := called_branches(words, formulas):
        yield from (replace(each, bound="") for each in both.values())
        return
    found = [*_of_signs(small, plain), *_of_roots(plain), *_of_extents(small, plain), *compared]
    yield from (replace(each, is_brief=is_brief) for each in found)
    if not found and (root := _ROOT.search(small)) is not None:
        yield ToldBranch(bound=MINUS_ROOT if _MINUS.search(root.group()) else PLUS_ROOT, is_brief=True)
    elif not found and (elbow := _OF_ELBOW.search(small)) is not None:
        yield _of_elbow(elbow["above"] is not None, small)
    elif not found and not re.search(_SIGN_WORD, small) and (called := [*_ELBOW_IS.finditer(small)]):
        ups = {each["up"] is not None for each in called}
        yield from [ToldBranch("2", LEFT_OF_LINE if True in ups else RIGHT_OF_LINE, is_brief=True)] * (len(ups) == 1)
    elif not found and (side := told_side(words)):
        yield ToldBranch("2", side, is_brief=is_brief)
    elif not found and (_UNCLEAR.search(small) or side == UNCLEAR):
        yield ToldBranch(is_brief=is_brief)


def called_branches(words: str, formulas: Sequence[str]) -> dict[str, ToldBranch]:
    """Return the two branches that a sentence names, each by what it calls it: "elbow-up ($q_2 < 0$) or elbow-down ($q_2 > 0$)"."""
    small, plain = words.lower(), [each.strip() for each in formulas]
    found: dict[str, ToldBranch] = {}
    for called in _CALLED.finditer(small) if small.count("¤") == len(plain) else ():
        told = next(_of_comparisons(plain[small.count("¤", 0, called.start()) :][:1]), None)
        found |= {called["label"]: told} if told is not None else {}
    letters, signs = {each.letter for each in found.values()}, {each.bound[-3] for each in found.values()}
    return found if len(found) == len(signs) == 2 and len(letters) == 1 else {}


def _of_elbow(is_above: bool, words: str) -> ToldBranch:
    """Return the sign of the second angle with the elbow on one side of the line to a tool that is to the right, or to the left; unclear of another line."""
    sides = {found["side"] for found in _TOOL_SIDE.finditer(words)}
    if len(sides) != 1 or _LINE_TO_TOOL.search(words) is None:
        return ToldBranch(is_brief=True)
    is_below_zero = is_above is ("right" in sides)
    return ToldBranch("2", f"\\theta_2 {BELOW_ZERO if is_below_zero else ABOVE_ZERO} 0", is_brief=True)


def _of_signs(words: str, formulas: Sequence[str]) -> Iterator[ToldBranch]:
    """Yield the letters of which a sentence says that they are positive, or negative."""
    for found in _SAID_OF.finditer(words):
        if _OF_DIRECTION.search(words[: found.start()]):
            continue
        is_positive = (found["positive"] is not None) is not bool(_DENIES.search(found["verb"]))
        yield from _told(formulas[words[: found.start()].count("¤")], is_positive)
    for found in _SAID_BEFORE.finditer(words):
        before = words[: found.start("sign")]
        is_of_direction = _OF_DIRECTION.search(before) or (
            found["behind"].isalpha() and found["behind"] not in _GOES_ON
        )
        if not is_of_direction:
            yield from _told(formulas[before.count("¤")], found["positive"] is not None)


_GOES_ON = frozenset("and so or then we where with which hence et donc ou on où avec alors und also y e".split())


def _told(formula: str, is_positive: bool) -> Iterator[ToldBranch]:
    if _LETTER.fullmatch(formula):
        yield ToldBranch(_key(formula), f"{formula} {ABOVE_ZERO if is_positive else BELOW_ZERO} 0")


def _of_comparisons(formulas: Sequence[str]) -> Iterator[ToldBranch]:
    """Yield the letters that a sentence compares with zero itself: $\\theta_2 < 0$."""
    for each in formulas:
        found = _COMPARED.fullmatch(each)
        if found is not None:
            yield from _told(
                found["name"].strip(), found["relation"] != "<" and not found["relation"].startswith("\\l")
            )


def _of_roots(formulas: Sequence[str]) -> Iterator[ToldBranch]:
    r"""Yield the sign of what is said to be a root: \sin\theta_2 = -\sqrt{1 - c_2^2}."""
    for each in formulas:
        found = _OF_ROOT.fullmatch(each)
        if found is not None and _LETTER.fullmatch(found["name"].strip()):
            yield from _told(found["name"].strip(), found["sign"] != "-")


def _of_extents(words: str, formulas: Sequence[str]) -> Iterator[ToldBranch]:
    """Yield the range of a letter: "$\\theta_5$ between $-180^\\circ$ and $0$"."""
    for found in _BETWEEN.finditer(words):
        at = words[: found.start()].count("¤")
        letter, low, high = formulas[at], *formulas[at + 1 : at + 3]
        if _LETTER.fullmatch(letter) and _EXTENT.fullmatch(low) and _EXTENT.fullmatch(high):
            yield ToldBranch(_key(letter), f"{low} < {letter} < {high}")


def _key(letter: str) -> str:
    """Return what θ_2, q_2, s_2 and sin θ_2 have in common, the number; of a coordinate the letter."""
    number = re.search(r"\d", letter)
    return letter if number is None else number.group()
