"""The names that a front matter binds, and how a document spells: read once, before its displays."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

from armproof.models.arm import Arm
from armproof.verification.document import Display, Document, Table
from armproof.verification.document.index_directions import LEFT_LOWER, LEFT_UPPER
from armproof.verification.document.other_meanings import COLUMNS
from armproof.verification.document.told_scalars import MOMENT
from armproof.verification.errors import DocumentError, ReadError
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import VARIANTS
from armproof.verification.latex.nodes import call_key
from armproof.verification.latex.reader import MAX_LENGTH, Reader, key_as_latex
from armproof.verification.latex.solids import first_solid
from armproof.verification.latex.tokens import PRE_SCRIPTS, Spelling, canonical_script
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.latex.vocabulary import FUNCTIONS, LETTERS
from armproof.verification.naming.conventions import NORMALS
from armproof.verification.naming.dresses import dressed_letters, starred_names
from armproof.verification.naming.moving import rates_in
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import read_quantity
from armproof.verification.patterns import regex

# words of a name that LaTeX reads without being told: letters, functions, accents and styles
READ_ALREADY = frozenset(
    [
        *LETTERS,
        *FUNCTIONS,
        *"dot ddot vec mathbf mathrm text prime hat bar operatorname mathcal boldsymbol star frac".split(),
    ]
)
FREE = "free"  # what `symbols` binds a letter to that is none of the arm's: a damping factor, a speed
_BETWEEN = regex(
    r"[\s{]*(?:\\[a-z]+\s*\{?\s*)?[TAHR][\s}]*(?:_\s*(?:\{[^{}]*\}|\w))?(?:\([^()=]*\))?(?:[\s}*.]|\\(?:times|cdot|[,;:!])|\\dot\{\})*"
)
_Scripts = tuple[str, str, int, int]
_TOLD = regex(
    r"theta_(\d+)=(?!q_\1(?:[^\d+-]|$))[^=,;]*q_\1(?!\d)|(?<![A-Za-z])q_(\d+)=(?!\\?theta_\2(?:[^\d+-]|$))[^=,;]*theta_\2(?!\d)"
)
_UNREAD = regex(r"\\(?:left|right|mathrm|operatorname|[,;! ])|[\s{}&\\]")
_OWN_SUM = regex(
    r"(?:^|[,;$])(?:theta|q|[cCsS])_(\d{2,4})=(?:(?:cos|sin|[cCsS])\(?)?(-?(?:theta|q)_\d(?:[+-](?:theta|q)_\d)+)(?![\d+*/-])"
)


# m_1, I_{zz_1}, l_{c1}, g: letter and subscript, and what the subscript may be
_OF_MASSES = regex(r"(?<![A-Za-z\\])([mgIlLra])(?![A-Za-z])(?:\s*_\s*(\{(?:[^{}]|\{[^{}]*\})*\}|\w))?")
_CENTRE = regex(r"(?:c|cm|g|G),?_?\d|\d,?c|c")
_SCRIPT_OF_MASSES = {
    "m": regex(r"\d"), "g": regex(""), "I": regex(r"(?:[xyz]{1,2}|c|C|G)?,?_?\d|\d(?:[xyz]{1,2})"),
    **dict.fromkeys("lLa", _CENTRE), "r": regex(rf"{_CENTRE.pattern}|\d"),
}  # fmt: skip


_WITH_COMMA = regex(  # = 0,4 and \\times 0,3; i = 0,1 lists two
    r"(?:(?<![ijkn\s])\s*=|[+]|\\times|\\cdot|\\d?frac\s*\{)\s*(0,\d+)(?![\d,;]|\s*[,;]\s*(?:\d|\\[lcd]?dots))"
)
_OWN_LETTER = regex(r"(?:^|[,;]|\\\\|quad|\\begin\{(?!\w*matrix)\w+\*?\})\s*([cCsS])\s*&?\s*:?=")  # S = sin(θ_1 + θ_2)

_LENGTH = regex(r"(?<![A-Za-z])([pP])_\{?(\d)\}?\s*(?:\\[,;!]\s*|\\cdot\s*)?(?:\\cos|\\sin|[cCsS]_)")  # p_1 cos θ_1


_NORMAL = regex(r"(?<![A-Za-z\\])([nsoa])\s*_\s*\{?\s*[xyz](?![A-Za-z])")
_ROW_OF_NORMALS = regex(  # x_x & y_x & z_x & p_x
    r"(?<![A-Za-z\\])([A-Za-z])_\{?x\}?\s*&\s*([A-Za-z])_\{?x\}?\s*&\s*([A-Za-z])_\{?x\}?\s*(?=&|\\\\)"
)
_LOAD = regex(r"(?<![A-Za-z\\])([FfM])\s*_\s*\{?\s*([xyz])(?![A-Za-z])")
_IN_COSINE = regex(
    r"\\(?:cos|sin|tan)\s*(?:\\left\s*)?[({]?\s*\\(eta|zeta|kappa|chi|nu|xi|upsilon)(?![A-Za-z])(?!\s*[_^])"
)
_MOMENT = regex(  # + M, & M \\: no mass matrix before accelerations
    r"(?:[-+=&]|\\\\)\s*M\s*(?=$|[-+,.;&}]|\\\\|\\end|\\q?quad|\\[,;])"
)
_SCREW = regex(  # e^{[S_1]θ_1}, exp([B_1]θ_1), e to a ξ_1 with a hat
    r"(?:(?<![A-Za-z\\])e\s*\^\s*\{|\\exp\s*(?:\\left)?\s*[({])\s*-?\s*(?:(?:\\left\s*)?\[|\\(?:wide)?hat\s*\{?)"
    r"\s*(?:\\(?:mathcal|mathbf|boldsymbol|bm)\s*\{?\s*)?\\?([A-Za-z]+)"
)
_TO_VELOCITY = regex(  # \omega = J_a \dot q
    r"(\\[A-Za-z]+|[A-Za-z])[\s}]*(?:[_^](?:\{[^{}]*\}|\w)\s*)*&?\s*=\s*&?\s*(?:\\[a-z]+\s*\{?\s*)?J[\s}]*(?:_\s*(\{[^{}]*\}|\w))?"
    r"\s*(?:\([^()]*\))?[\s{]*\\(?:dot|mathbf|boldsymbol|bm)(?![A-Za-z])"
)
_IN_UNIT = regex(
    r"(?<![\d.])(\d+(?:\.\d+)?)(?:[\s~]|\\[,;: ])*(?:\\(?:text|mathrm)\s*\{\s*)?(?<![A-Za-z\\])(mm|cm|m)(?![A-Za-z_^])"
)
_COLUMN = regex(r"J\s*_\s*\{?\s*(\d)\s*\}?")
_ROW_OF_COLUMNS = regex(  # [J_1 & J_2]
    rf"matrix\}}\s*({_COLUMN.pattern.replace('(', '(?:')}(?:\s*&\s*{_COLUMN.pattern.replace('(', '(?:')})+)\s*\\end"
)
_QUATERNION = {*"0123"}
_BARE = regex(r"(?<![\d.\w^{])[1-9]\d+(?:\.\d+)?(?![\d.]|\s*(?:\}?\s*\^|°|\\degree))")
_UNIT_OF_COLUMN = regex(r"(?<![A-Za-z])(mm|cm)(?![A-Za-z])")
_OF_ANGLES = frozenset("30 45 60 90 120 135 180 270 360".split())


def read_names(arm: Arm | None, front: Mapping[str, Any]) -> Names:
    """Return the bindings of a front matter; raises DocumentError with the key and the valid choices."""
    symbols_spec = front.get("symbols") or {}
    quantities_spec = front.get("quantities") or {}
    transforms = front.get("transforms", "")
    for key, value in (("symbols", symbols_spec), ("quantities", quantities_spec)):
        if not isinstance(value, Mapping):
            raise DocumentError(say(Kind.NO_MAPPING, key=key, value=repr(value)), key)
    if transforms not in ("", "upper", "lower"):
        raise DocumentError(say(Kind.UNKNOWN_TRANSFORMS, value=repr(transforms)), "transforms")
    found = (re.findall(r"^[A-Za-z]{2}(?=_\d|$)|[A-Za-z]{3,}", str(key)) for key in [*symbols_spec, *quantities_spec])
    words = frozenset(word for words in found for word in words) - READ_ALREADY
    plain = Reader(words=words)
    symbols: dict[str, str] = {}
    for key, value in symbols_spec.items():
        if not isinstance(value, str):
            raise DocumentError(say(Kind.SYMBOL_OF_NOTHING, symbol=str(key), value=repr(value)), "symbols")
        name = name_key(plain, str(key))
        if arm is not None and value != FREE and value not in (known := _scalars(arm)):
            unknown = say(Kind.UNKNOWN_SYMBOL, symbol=str(key), arm=arm.name, value=value, known=list(known), free=FREE)
            raise DocumentError(unknown, "symbols")
        if value == FREE and arm is not None and name in _scalars(arm):
            raise DocumentError(say(Kind.SYMBOL_NOT_FREE, symbol=str(key), arm=arm.name), "symbols")
        symbols[name] = name if value == FREE else value
    quantities = {
        name_key(plain, str(key)): read_quantity(str(key), spec, arm) for key, spec in quantities_spec.items()
    }
    bound = frozenset(symbols) | frozenset(quantities)
    # A trig letter bound with any index (s_x) or an applied name (J(q)) is bound as written.
    reader = Reader(lambda key: key in bound, words)
    return Names(arm, symbols, quantities, transforms, reader)


def spelling_of(document: Document, words: frozenset[str]) -> Spelling:
    """Return how a document spells: φ and ϕ are two letters where it uses both, a decimal comma is French or used before."""
    displays = [each for each in document.displays if len(each.latex) <= MAX_LENGTH]  # which can be read
    raw = "\n".join(display.latex for display in displays)
    text = normalise_unicode(raw)
    found = set(re.findall(r"\\([A-Za-z]+?)(?![A-Za-z])", raw))
    bound = " ".join(str(key) for part in ("symbols", "quantities") for key in document.front.get(part) or ())
    apart = {variant for variant, plain in VARIANTS.items() if {variant, plain} <= found and plain not in bound}
    texts = [normalise_unicode(each) for display in displays for each in (display.latex, *display.said)]
    said = "\n".join(texts)
    letters = (r"theta", r"(?<![A-Za-z])q", r"(?<![A-Za-z])[cCsS]")
    of_theta, of_q, of_cosine = (set(re.findall(rf"{letter}\s*_\s*\{{?\s*(\d)", said)) for letter in letters)
    both = of_theta and of_q
    variables = ("told" if _TOLD.search(re.sub(r"[\s{}&]", "", said)) else "both") if both else ""
    comma = document.front.get("lang") == "fr" or re.search(r"\d\{,\}\d", text) is not None or _has_commas(said)
    angle = "q" if of_q & of_cosine and not of_theta else "theta"
    sums = tuple(dict(_own_sums(texts)).items())
    own = frozenset(letter for each in texts for letter in _OWN_LETTER.findall(each))
    lengths = frozenset(f"{letter}_{index}" for letter, index in _LENGTH.findall(text))
    return Spelling(
        words, frozenset(apart), comma, variables, angle, sums, _masses(said), own, _refers_below(displays), lengths,
        frozenset(_SCREW.findall(text)), _own_unit(displays, document.tables), frozenset(of_theta | of_q | of_cosine), _normals(said),
        dressed_letters(texts), starred_names(texts), _of_two_velocities(texts),
        frozenset(f"{letter}_{axis}" for letter, axis in _LOAD.findall(said)) | _moments(texts),
        frozenset(_columns(displays)), frozenset(_as_read(each, apart) for each in rates_in(displays)), bool(of_theta) and of_q == _QUATERNION,
        *_told_scalars(document.scalars, said), first_solid((*texts, *(each for *_, each in document.figures))),
    )  # fmt: skip


def _has_commas(said: str) -> bool:
    """Whether a text writes decimals with a comma: several of them between signs, where nothing is listed, and none with a point."""
    return len({*_WITH_COMMA.findall(said)}) > 1 and not re.search(r"\d\.\d", said)


def _told_scalars(told: Iterable[str], said: str) -> tuple[frozenset[str], frozenset[str]]:
    r"""Return the keys of the letters that a text calls a size, and of those that it calls a moment; not of one whose components it writes.

    An η of which a cosine is taken is an angle, as θ is by itself.
    """
    loads = {letter for letter, _ in _LOAD.findall(said)}
    found = [each.split(" ") for each in sorted(told)]
    keys = frozenset(key for _, key in found if key not in loads) | frozenset(_IN_COSINE.findall(said))
    return keys, frozenset(key for kind, key in found if kind == MOMENT and key in keys)


def _as_read(key: str, apart: set[str]) -> str:
    """Return the key of a letter as it is read: phi of \\varphi, unless the document tells the two apart."""
    base, line, sub = key.partition("_")
    return f"{VARIANTS[base]}{line}{sub}" if base in VARIANTS.keys() - apart else key


def _columns(displays: Iterable[Display]) -> Iterator[str]:
    """Yield the keys of what a document says to be columns of J, in words or as [J_1 J_2]."""
    for display in displays:
        told = [each.removeprefix(COLUMNS) for each in display.meant if each.startswith(COLUMNS)]
        rows = [
            row for row in _ROW_OF_COLUMNS.findall(normalise_unicode(display.latex)) if len(_COLUMN.findall(row)) > 1
        ]
        yield from (f"J_{index}" for text in (*told, *rows) for index in _COLUMN.findall(text))


def _moments(texts: Iterable[str]) -> frozenset[str]:
    """Return the M that stands as a term beside torques: a moment of the load."""
    beside = (text for text in texts if "\\tau" in text)
    return frozenset({"M"} if any(_MOMENT.search(text.strip()) for text in beside) else ())


def _normals(said: str) -> str:
    """Return the letters of the columns of the tool's rotation: those of a row, x_x & y_x & z_x, else in the order in which s_x and n_x come first."""
    row = _ROW_OF_NORMALS.search(said)
    if row is not None and len(own := {*row.groups()}) == len(NORMALS) and (own <= {*"noas"} or own.isdisjoint("noas")):
        return "".join(row.groups())
    found = "".join(dict.fromkeys(_NORMAL.findall(said)))
    return f"{found.replace('a', '')}a" if set(found) in ({"s", "n"}, {"s", "n", "a"}) else NORMALS


def _of_two_velocities(texts: Iterable[str]) -> frozenset[str]:
    r"""Return the subscripts of Jacobians that are of ω and of another velocity, as a of ω = J_a \dot q and \dot p = J_a \dot q."""
    kinds: dict[str, set[bool]] = {}
    for text in texts:
        for letter, script in _TO_VELOCITY.findall(text):
            kinds.setdefault(canonical_script(script), set()).add(letter in ("\\omega", "\\Omega"))
    return frozenset(script for script, is_angular in kinds.items() if len(is_angular) > 1)


def _own_unit(displays: Sequence[Display], tables: Iterable[Table]) -> str:
    """Return mm where a document calculates in it: a number that it gives in mm, or that leads to one, stands without the unit."""
    measured: set[tuple[str, str]] = set()
    bare: set[str] = set()
    is_beside = False
    for display in displays:
        for latex in (display.latex, *display.said):
            found = set(_IN_UNIT.findall(latex))
            measured |= found
            alone = set(_BARE.findall(_IN_UNIT.sub("", latex))) - _OF_ANGLES if latex is display.latex else set()
            is_beside = is_beside or bool(found and alone)
            bare |= alone
    cells = (each for table in tables for each in cells_in_units(table))
    of_tables = {unit for cell, unit in cells if not bare.isdisjoint(_BARE.findall(cell))}
    if len(of_tables) == 1:  # then what a display gives in metres is not what it stands beside
        return of_tables.pop()
    units = {unit for _, unit in measured}
    return units.pop() if units in ({"mm"}, {"cm"}) and (is_beside or bare & {number for number, _ in measured}) else ""


def cells_in_units(table: Table) -> Iterator[tuple[str, str]]:
    """Yield the cells of a table whose header says that they are in mm or in cm, with that unit."""
    units = [_UNIT_OF_COLUMN.search(header) for header in table.header]
    for row in table.rows:
        yield from ((cell, unit[1]) for unit, cell in zip(units, row, strict=False) if unit is not None)


def _masses(said: str) -> frozenset[str]:
    """Return the keys of masses, moments of inertia, distances to centres of mass and g in a document that has masses."""
    found = ((base, canonical_script(script)) for base, script in _OF_MASSES.findall(said))
    keys = {f"{base}_{sub}" if sub else base for base, sub in found if _SCRIPT_OF_MASSES[base].fullmatch(sub)}
    if "I_1" not in keys:  # R R^T = I_3
        keys = {key for key in keys if not re.fullmatch(r"I_\d", key)}
    if any(key.startswith("I_zz") for key in keys):  # then I_{c1} is a matrix
        keys = {key for key in keys if not key.startswith(("I_c", "I_C", "I_G"))}
    return frozenset(keys) if any(key.startswith("m_") for key in keys) else frozenset()


def _own_sums(said: Iterable[str]) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Yield the digits of names that a document gives a sum of angles with a minus in it: S_{34} = sin(θ_3 - θ_4)."""
    for text in said:
        for digits, angles in _OWN_SUM.findall(_UNREAD.sub("", text.replace("quad", ","))):
            terms = re.findall(r"([+-]?)(?:theta|q)_(\d)", angles)
            if "-" in dict(terms) and "".join(digit for _, digit in terms) == digits:
                yield digits, tuple(-1 if sign == "-" else 1 for sign, _ in terms)


def _refers_below(displays: Sequence[Display]) -> bool:
    """Whether the products of a document show that the script below, before a letter, names the reference, {}_0^1T {}_1^2T, or its text alone says so."""
    told = {fact.partition("\n")[0] for display in displays for fact in display.directions} & {LEFT_LOWER, LEFT_UPPER}
    if told:
        return told == {LEFT_LOWER}
    joined = [pair for display in displays for pair in _joined(normalise_unicode(display.latex))]
    return any(a[1] == b[0] for a, b in joined) and not any(a[0] == b[1] for a, b in joined)


def _joined(text: str) -> Iterator[tuple[_Scripts, _Scripts]]:
    """Yield the scripts before the letters of each two factors that stand side by side."""
    found = [_scripts(one) for one in PRE_SCRIPTS.finditer(text)]
    yield from ((a, b) for a, b in pairwise(found) if _BETWEEN.fullmatch(text[a[2] : b[3]]))


def _scripts(found: re.Match[str]) -> _Scripts:
    """Return the scripts below and above, and where the last of them ends and the first begins."""
    one, other = (re.sub(r"[{}\s]", "", found[group]) for group in (3, 5))
    below, above = (one, other) if found[2] == "_" else (other, one)
    return below, above, found.end(5), found.start()


def _scalars(arm: Arm) -> list[str]:
    return [*(joint.symbol for joint in arm.joints), *arm.lengths, *arm.angles]


def name_key(reader: Reader, key: str) -> str:
    """Return the canonical key of a front-matter name, such as J(q), J'_P, {}^0P_{1,G} or theta_12."""
    latex = key_as_latex(key)
    probe = Reader(lambda _key: True, reader.words)
    try:
        node = probe.read_expression(latex)
    except ReadError as error:
        raise DocumentError(say(Kind.NO_NAME_BECAUSE, name=key, problem=finding_of(error))) from None
    if isinstance(node, n.Name):
        return node.key
    if n.is_call(node, "name"):
        return call_key(node)
    raise DocumentError(say(Kind.NO_NAME, name=key))
