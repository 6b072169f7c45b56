r"""Sentences that measure an angle from the link before: "$\theta_2$ is the angle between the second link and the first one", « $q_2$ mesure la rotation du deuxième segment par rapport au premier »."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.patterns import regex

RELATIVE = "relative angle"  # with its LaTeX

MAY_TELL_RELATIVE = regex(  # what no such sentence lacks, in small letters
    r"between|entre|relative|relatif|relation|respect|measured from|counted from|rapport|prolong|extension of|zwischen|gegenüber|respecto|rispetto"
)
_ANGLE = regex(r"(?:\\(?:var)?theta|\\(?:var)?phi|q)\s*_\s*\{?\s*([2-9])\s*\}?")
_LINK = r"(?:links?|segments?|bars?|arms?|rods?|members?|bras|barres?|corps|one|upper arm|avant-bras|forearm|celui)"
_BEFORE = r"(?:first|second|third|previous|preceding|last|upper|one before|premier|première|deuxième|second|précédente?|erste[nrsm]?|vorige[nrsm]?|primer[oa]?|prim[oa]|anterior|precedente)"
_FROM = r"(?:relative(?:ly)? to|with respect to|(?:measured|counted) from|par rapport (?:à|au|aux)|relativement (?:à|au)|from the (?:extension|prolongation|direction) of|gegenüber|respecto (?:de|a|al)|rispetto (?:a|al))"
_IS_RELATIVE = regex(
    rf"(?<!\S){_FROM} (?:\S+ ){{0,3}}?{_BEFORE}(?!\w)|(?<!\S)(?:between|entre|zwischen) (?:\S+ ){{0,4}}?{_BEFORE} (?:{_LINK} )?(?:\S+ ){{0,2}}?(?:and|et|und|y|e) (?:\S+ ){{0,3}}?(?:{_BEFORE}|{_LINK})(?!\w)"
    r"|(?<!\S)(?:the|les?|l') (?:\S+ )?(?:relative|relatif|relatifs) (?:joint )?angles?(?!\w)"
)


def relative_angles(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield the angles behind the first of which a sentence says that they are measured from the link before."""
    if _IS_RELATIVE.search(words.lower()):
        for each in formulas:
            if _ANGLE.fullmatch(each.strip()):
                yield f"{RELATIVE} {each.strip()}"
