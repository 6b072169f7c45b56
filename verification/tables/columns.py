"""Which column of a DH table holds which parameter: the headers, and the convention and units that they state."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.latex.vocabulary import STYLES
from armproof.verification.patterns import regex

XYZ, RPY = ("x", "y", "z"), ("roll", "pitch", "yaw")
_HEADERS = {
    "joint": r"(?:nom d[eu] (?:l['’]|la )?)?(?:joint|liaison|articulation)s?(?: name)?|name|nom|",
    "parent": r"(?:segment |corps )?parent(?: link)?",
    "child": r"child(?: link)?|(?:segment |corps )?enfant",
    "type": r"(?:joint )?(?:type|kind)",
    "axis": r"(?:joint )?axis|axe",
    **{letter: letter for letter in XYZ},
    **{name: rf"{name}|{french}" for name, french in zip(RPY, ("roulis", "tangage", "lacet"), strict=True)},
}
_LENGTH_UNIT = regex(r"\s*(?:[(\[].*[)\]]|,\s*\w+|\sin\s+\w+)$")
CONVENTIONS = ("classic", "modified")
_SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉ᵢⱼ₋", "0123456789ij-")
_SCRIPTS = regex("[₀₁₂₃₄₅₆₇₈₉ᵢⱼ₋]+")
_HTML_SCRIPTS = regex(r"<(sub|sup)>\s*([^<>{}]*?)\s*</\1>", re.IGNORECASE)

# a unit in a header: in brackets, or after "in"
_UNITS = {
    "deg": r"deg(?:rees?)?\.?|degr[eé]s?|grad[oi]s?|graus?|\^circ|\^\{circ\}|[°º˚]",
    "rad": r"rad(?:ians?|ianes?|ianos?)?\.?",
    "mm": r"mm|milli\w+",
    "cm": r"cm|centi\w+",
    "m": r"m|met(?:er|re)s?|m[eè]tres?|metros?",
}
_UNIT = regex(
    r"(?:[(\[]|,\s*|\bin\s+|\ben\s+)\s*(?:%s)\s*[)\]]?$" % "|".join(f"(?P<{k}>{v})" for k, v in _UNITS.items())
)
_BARE_DEGREES = regex(r"\s*(?:\^circ|[°º˚])$")

_SYMBOL = regex(
    r"(?<![A-Za-z])(?P<letter>alpha|theta|sigma|[adrqb])(?![A-Za-z])\s*(?:_?\s*\(?(?P<index>[ijkn](?:\s*-\s*1)?)\)?(?![A-Za-z]))?"
)
_WORDS = (
    (r"twist|torsion|torsión|torsione|torção|\w*verdrehung|\w*verwindung|verdrehwinkel|verwindungswinkel", "alpha"),
    (r"link length|longueur|longitud|comprimento|length|lunghezza|(?:arm|glied|armelement)?länge", "a"),
    (r"joint angle|rotation|angle|ángulo|angolo|ângulo|(?:gelenk|dreh)?winkel", "theta"),
    (r"offset|décalage|desplazamiento|deslocamento|scostamento|(?:gelenk|glied)?versatz|gelenkabstand", "d"),
    (r"type|kind|tipo", "sigma"),
    (r"variables?", "q"),
)
_OFFSET = regex(r"^[\s_,(]*(?:offset|off|0|décalage|desfase)\b")
_ADDED = regex(r"(?:joint |angle )?(?:offset|décalage|desfase)\s*(?:[(\[].*[)\]])?")
_LABEL = regex(
    r"(?:[ijkn](?:-1)?|n[°ºo]|no\.?|#|(?:the )?(?:links?|joints?|segments?|corps|liaisons?|articulations?|frames?|rep[eè]res?|row|ax[ie]s|axe|bod(?:y|ies)"
    r"|solide|eslab[oó]n|elo|articulaci[oó]n|juntas?|gelenk|glied|achse|step|transforms?|matri(?:x|ces))(?: (?:no\.?|number|n[°º]|#))?(?: ?[ijkn])?"
    r"|[ijkn][-–,/][ijkn](?:-1)?|[ijkn]-1[-–,/ ]*(?:to )?[ijkn]|\{?\}?\^?\{?[ijkn]-1\}?_?\{?[ijkn]?\}?[TAH](?:_?\{?[ijkn]\}?)?|[TAH]_?\{?[ijkn]\}?(?:\^\{?[ijkn]-1\}?)?|)"
)


@dataclass(frozen=True)
class Header:
    """What one header says. `role`: alpha, theta, sigma, a, d, r, q or b for a letter, label, or "" for anything else.

    `convention` is that of the letter's index (i-1: modified, i: classic), `unit` deg, rad, m, cm, mm or "". `is_offset`: of the
    angle without its variable, θ_offset.
    """

    text: str
    role: str
    convention: str = ""
    unit: str = ""
    is_offset: bool = False


@dataclass(frozen=True)
class Reading:
    """One way to read a table: the convention, and the column (from 0) of each parameter."""

    convention: str
    a: int
    alpha: int
    d: int
    theta: int

    @property
    def columns(self) -> dict[str, int]:
        """The columns by parameter."""
        return {"a": self.a, "alpha": self.alpha, "d": self.d, "theta": self.theta}


@dataclass(frozen=True)
class Columns:
    """The columns of a DH table; `stated` is the convention that its headers state, or ""."""

    headers: tuple[Header, ...]
    stated: str
    lengths: tuple[tuple[int, int], ...]  # the columns of (a, d), the likeliest first
    alpha: int
    theta: int
    contradictory: bool = False
    is_khalil: bool = False  # d for the length along x and r for the offset along z
    offset: int | None = None  # the column of what is added to the joint's variable

    def readings(self, conventions: Sequence[str]) -> Iterator[Reading]:
        """Yield the ways to read the table, by convention in the order given."""
        for convention in conventions:
            for a, d in self.lengths:
                yield Reading(convention, a, self.alpha, d, self.theta)

    def first(self, *roles: str) -> int | None:
        """Return the first column of one of these roles."""
        return next((k for k, header in enumerate(self.headers) if header.role in roles), None)


def plain(text: str) -> str:
    """Return a cell without dollars, emphasis, styles and spacing commands, its Unicode letters spelt in LaTeX."""
    text = _SCRIPTS.sub(lambda found: "_{" + found.group().translate(_SUBSCRIPTS) + "}", text)
    text = _HTML_SCRIPTS.sub(lambda found: f"{'_' if found[1].lower() == 'sub' else '^'}{{{found[2]}}}", text)
    text = normalise_unicode(text.replace("$", " ")).replace("\\(", " ").replace("\\)", " ")
    text = re.sub(r"\*\*|__", "", text)
    text = re.sub(
        r"\\(?:text\w*|%s)\s*(?![A-Za-z])(?:\{([^{}]*)\})?" % STYLES, lambda found: f" {found.group(1) or ''} ", text
    )
    text = re.sub(r"\\[,;:!> ]|\\q?quad(?![A-Za-z])|~", " ", text)
    return re.sub(r"(?<!\{)\\degree", r"^\\circ", text).strip()  # \SI{90}{\degree} is read as it stands


def read_header(text: str) -> Header:
    """Return what a header says."""
    spelt = re.sub(r"\s+", " ", plain(text).replace("\\", "").replace("−", "-")).strip()
    spelt = re.sub(r"\bvartheta(?![A-Za-z])", "theta", spelt)
    unit = ""
    if found := _UNIT.search(spelt):
        unit = next(name for name, value in found.groupdict().items() if value)
        spelt = spelt[: found.start()].strip()
    elif found := _BARE_DEGREES.search(spelt):
        unit, spelt = "deg", spelt[: found.start()].strip()
    bare = re.sub(r"(?<!\w)\*(\w+)\*(?!\w)", r"\1", re.sub(r"[{}]", "", spelt)).strip()  # Link *i*
    if _LABEL.fullmatch(bare.lower() if len(bare) > 3 else bare) or _LABEL.fullmatch(spelt):
        return Header(text, "label", "", unit)
    rest = re.sub(r"\^\s*(?:\*|ast|star)|\*|\(t\)", "", bare)
    symbols = list(_SYMBOL.finditer(rest))
    if len(symbols) == 1 and re.fullmatch(r"[^+=/0-9]*", rest[: symbols[0].start()] + rest[symbols[0].end() :]):
        index = re.sub(r"\s", "", symbols[0].group("index") or "")
        convention = "" if not index else "modified" if index.endswith("-1") else "classic"
        letter, beside = symbols[0].group("letter"), rest[symbols[0].end() :]
        return Header(text, letter, convention, unit, letter == "theta" and _OFFSET.search(beside.lower()) is not None)
    if not symbols:
        for words, role in _WORDS:
            if re.search(rf"\b(?:{words})\b", rest.lower()):
                return Header(text, role, "", unit)
    return Header(text, "", "", unit)


def read_columns(header: Sequence[str]) -> Columns | None:
    """Return the columns of a DH table, or None where the header is not that of one."""
    headers = tuple(read_header(text) for text in header)
    place: dict[str, int] = {}
    for k, one in enumerate(headers):
        place.setdefault(one.role, k)
    alpha, theta = place.get("alpha"), place.get("theta", place.get("q"))
    along_x = next((place[role] for role in "ad" if role in place), None)
    offset = next(
        (k for k, one in enumerate(headers) if one.role == "d" and _ADDED.fullmatch(plain(one.text).lower())), None
    )
    others = [k for k, one in enumerate(headers) if one.role == "d" and k != offset]
    if offset is not None and others:  # beside a column of d it is no length
        place["d"] = others[0]
    along_z = next((place[role] for role in "drb" if role in place and place[role] != along_x), None)
    if alpha is None or theta is None or along_x is None or along_z is None:
        return None
    is_khalil = headers[along_x].role == "d"
    stated = {headers[k].convention for k in (along_x, alpha)} - {""}
    if is_khalil and stated == {"classic"}:  # Khalil's d_j and α_j are the modified parameters
        stated = set()
    return Columns(
        headers,
        stated.pop() if len(stated) == 1 else "",
        ((along_x, along_z), (along_z, along_x))[: 1 + is_khalil],
        alpha,
        theta,
        contradictory=len(stated) > 1,
        is_khalil=is_khalil,
        offset=offset if others else None,
    )


def origin_columns(header: tuple[str, ...]) -> dict[str, int] | None:
    """Return the column (from 0) of each role, or None where the header has no joint, x, y and z.

    A column of anything else makes x, y and z those of something else (masses), unless links or angles stand there too.
    """
    place: dict[str, int] = {}
    for k, text in enumerate(header):
        spelt = _LENGTH_UNIT.sub("", plain(text).lower()).strip()
        if role := next((role for role, words in _HEADERS.items() if re.fullmatch(words, spelt)), None):
            place.setdefault(role, k)
    only_origins = len(place) == len(header) or bool(place.keys() & {"parent", "child", *RPY})
    return place if {"joint", *XYZ} <= place.keys() and only_origins else None


def spelt_name(name: str) -> str:
    """Return a name without what makes no difference: its case, backslashes, and - or a blank for _."""
    return re.sub(r"[-_\s]+", "_", re.sub(r"[\\{}`*]", "", plain(name)).strip().lower())
