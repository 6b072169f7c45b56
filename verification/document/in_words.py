"""Names whose meaning words give: "where $c_{12}$ stands for $\\cos(\\theta_1 + \\theta_2)$", "on note $D$ pour …"."""

from __future__ import annotations

import re

from armproof.verification.document.postures import bent_to
from armproof.verification.patterns import regex

_FORMULA = r"(?:\$`?(?P<{0}>[^$`]{{1,200}})`?\$|\\\((?P<{0}_tex>.{{1,200}}?)\\\)|:math:`(?P<{0}_rst>[^`]{{1,200}})`)"
_WRITE = regex(
    r"\b(?:writ(?:e|ing|ten)|abbreviat(?:e|es|ing|ed)|denot(?:e|es|ing|ed)|use|using|not(?:e|ons|ant)|écri(?:t|vons|vant)|abr[eèé]g(?:e|eons|eant)|schreib(?:e|en)(?: wir)?|escrib(?:e|imos|iremos)|escreve(?:mos)?|scriv(?:e|iamo))\s*\Z",
    re.IGNORECASE,
)
_IS = (
    r"(?:(?:stands?|(?:is|are) (?:an abbreviation|abbreviations|a shorthand|shorthand|short|written)) for|(?:is|are) (?:an abbreviation|a shorthand) of|"
    r"denotes?|means?|represents?|abbreviates?|désigne(?:nt)?|signifie(?:nt)?|représente(?:nt)?|(?:est|sont) (?:mise?s?|écrite?s?|notée?s?) pour|"
    r"est l['’]abréviation de|abrège(?:nt)?|steht für|stehen für|bezeichne[tn]|bedeute[tn]|significan?|denotan?)"
)
_IS_WRITTEN = (  # what the name that comes behind it stands for
    r"(?:is|are|est|sont|wird|werden|se|si|è)\s+(?:here\s+|simply\s+)?(?:written|abbreviated|denoted|notée?s?|écrite?s?|abrégée?s?|geschrieben|abgekürzt|escriben?|abrevian?|scrive|indica)(?:\s+(?:as|to|by|par|als|mit|durch|como|come|con))?"
)
_AND = r"\s*(?:,|and|et|und|y)\s+"
_KIND = (  # of what a formula is: "the difference $\\theta_1 - \\theta_2$"
    r"(?:the|la|le|l['’]|die|den|der|das|el|il|lo|a|o)\s*(?:sum|difference|product|angle|somme|différence|produit|Summe|Differenz|Produkt|Winkel|suma|diferencia|producto|ángulo|somma|differenza|prodotto|angolo|soma|diferença|produto|ângulo)"
    r"(?: (?:angle|of the angles|des angles|der Winkel|de los ángulos))?,?\s+"
)
_TURN = r"(?:(?:the |le )?(?P<turn>cos|sin)(?:ine|inus|e|us) (?:of|de) (?:(?:the|the angle|the sum|la somme|l['’]angle) )?)?"
_SAID = regex(
    rf"{_FORMULA.format('name')}\s+(?:(?P<verb>{_IS}|(?P<behind>{_IS_WRITTEN})|is|est|ist|es|for|pour|für|para|per|by|par|as)\s+{_TURN}(?P<kind>{_KIND})?|{_KIND}){_FORMULA.format('value')}",
    re.DOTALL,
)
_TWO_SAID = regex(
    rf"{_FORMULA.format('name')}{_AND}{_FORMULA.format('other')}\s+{_IS}\s+{_FORMULA.format('value')}{_AND}{_FORMULA.format('second')}",
    re.DOTALL,
)
_BESIDE = regex(  # a shorthand and the sine or cosine that words join to it, whatever they are
    rf"{_FORMULA.format('name')}(?P<between>[^$`.;]{{1,40}}){_FORMULA.format('value')}", re.DOTALL
)
_THE = r"(?:(?:the|both|le|la|les|l['’]|der|die|das|den|dem|des|el|los|las|il|lo|gli|i|os?|as?)\s*)?"
_OF = r"(?:of|de|du|des|der|von|del|della|dell['’]|dei|di|da|do|dos)\s*"
_OF_TWO_ANGLES = regex(
    rf"{_FORMULA.format('name')}\s+(?:[\w'’]+\s+){{0,3}}?{_THE}(?P<factors>(?:product|produit|produkt|producto|prodotto|produto)\s+{_OF}{_THE})?"
    rf"(?P<turn>(?:cosine|sine|cosinus|kosinus|sinus|coseno|cosseno|seno|cosen|sen)\w{{0,2}})(?(factors)|\s+{_OF}{_THE}(?P<kind>difference|différence|differenz|diferencia|differenza|diferença|sum|somme|summe|suma|somma|soma)\b)",
    re.IGNORECASE,
)
_LISTS = regex(
    r"(?:\s|[,()])*(?:and|or|et|ou|und|oder|y|o|plus|minus|times|in|into|with|by|par|avec|then|[,()])(?:\s|[,()])*"
)
_SHORTHAND = regex(r"\s*[cCsS]\s*_\s*(?:\d|\{\s*[\dijk\s]+\}|[ijk])\s*")
_SECOND = regex(rf"[$)`]{_AND}\Z")
_ONE_NAME = regex(r"\s*\\?[A-Za-z]+(?:\s*_\s*(?:\{[\w\s,]+\}|\\?\w+))?\s*")


def said_in_words(text: str, at: int) -> str | None:
    """Return the equation that words make of the formula that begins at a place and of the next one, or the posture of its angle; None where they make none."""
    if (posture := bent_to(text, at)) is not None:
        return posture
    if (two := _TWO_SAID.match(text, at)) is not None:
        pairs = [(_formula(two, "name"), _formula(two, "value")), (_formula(two, "other"), _formula(two, "second"))]
        return (
            ", ".join(f"{name} = {value}" for name, value in pairs)
            if _are_names(*(name for name, _ in pairs))
            else None
        )
    if (turned := _of_two_angles(text, at)) is not None:
        return turned
    found = _SAID.match(text, at)
    is_own = found is not None and found["behind"]
    if not is_own and _SECOND.search(text, max(0, at - 10), at):  # the second of two: it was said with the first
        return None
    if found is None:
        return _of_shorthand(text, at)
    name, value, verb = _formula(found, "name"), _formula(found, "value"), found["verb"] or "for"
    if found["behind"] or verb in ("by", "par", "as"):
        name, value = value, name
    needs_turn = verb in ("is", "est", "ist", "es") and not found["kind"]
    needs_write = verb in ("for", "pour", "für", "para", "per", "by", "par", "as")
    if (needs_turn and not found["turn"]) or (needs_write and not _WRITE.search(text, max(0, at - 20), at)):
        return _of_shorthand(text, at)
    value = rf"\{found['turn']}({value})" if found["turn"] else value
    return f"{name} = {value}" if _are_names(name) else None


def _of_two_angles(text: str, at: int) -> str | None:
    """Return what words alone say of a shorthand of two angles, in the shorthands of each: "$c_{12}$ is the cosine of the difference of both angles"."""
    found = _OF_TWO_ANGLES.match(text, at)
    name = _formula(found, "name") if found is not None else ""
    numbers = re.fullmatch(r"\s*[cCsS]\s*_\s*\{\s*(\d)\s*(\d)\s*\}\s*", name)
    if found is None or numbers is None:
        return None
    one, other = numbers.groups()
    is_cosine = found["turn"].lower().startswith(("co", "ko"))
    if found["factors"]:
        letter = "c" if is_cosine else "s"
        return f"{name} = {letter}_{one} {letter}_{other}"
    is_sum = found["kind"].lower().startswith(("s", "ad"))
    first, second = (f"c_{one} c_{other}", f"s_{one} s_{other}") if is_cosine else (f"s_{one} c_{other}", f"c_{one} s_{other}")  # fmt: skip
    return f"{name} = {first} {'-' if is_sum is is_cosine else '+'} {second}"


def _of_shorthand(text: str, at: int) -> str | None:
    """Return what a shorthand and the sine or cosine beside it are said to be, where words stand between them that list nothing."""
    found = _BESIDE.match(text, at)
    if found is None or _LISTS.fullmatch(found["between"]):
        return None
    name, value = _formula(found, "name"), _formula(found, "value")
    if _SHORTHAND.fullmatch(value):
        name, value = value, name
    elif turn := re.search(r"\b(cos|sin)(?:ine|inus|us|e)\b", found["between"]):
        value = rf"\{turn[1]}({value})"
    is_turn = re.search(r"\\(?:cos|sin)(?![a-z])", value) is not None and "=" not in value
    return f"{name} = {value}" if _SHORTHAND.fullmatch(name) and is_turn else None


def _formula(found: re.Match[str], group: str) -> str:
    return next(filter(None, (found[f"{group}{kind}"] for kind in ("", "_tex", "_rst"))), "")


def _are_names(*names: str) -> bool:
    return all(map(_ONE_NAME.fullmatch, names))
