"""Postures of an arm in words, "when the arm is stretched out", and kinds of joints: what stands behind them may hold there alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

from armproof.verification.document.joint_values import joint_values, without_joint_values
from armproof.verification.document.model import INLINE, Display
from armproof.verification.document.told_shapes import LEADS_TO_ANGLE, shapes
from armproof.verification.patterns import regex

_PLACE = r"(?:configuration|position|posture|pose)"
_ARM = r"(?:arm|links?|segments?|bras|manipulator|robot|(?:first|second|third|last) joint|elbow|forearm)"
_LIES = r"(?:straight|vertical(?:e|es)?|verticaux|horizontal(?:e|es)?|horizontaux|aligned|collinear|upright|alignés?|colinéaires)"
_BENT = r"(?:elbow|shoulder|wrist|joints?|coude|épaule|poignet|articulations?)(?: (?!axe?s\b|axis)\w+){0,3} (?:at|to|by|à|de|makes?|forms?|fait|forme)"
_AN_ANGLE = r"(?:-?\d+(?:\.\d+)? ?(?:°|degrees|degrés)|(?:an? |un )?(?:right angles?|angle droit))"
_BENT_TO = regex(rf"\b(?:{_BENT}|{LEADS_TO_ANGLE})\s+\Z", re.IGNORECASE)
_DEGREES = regex(r"(?:\$`?|\\\(|:math:`)\s*-?\d+(?:\.\d+)?\s*(?:\^\s*\{?\s*\\circ|°)")
_WHERE = r"(?:when(?:ever)?|if|with|once|while|lorsque|quand|si|avec|wenn|mit|falls|liegt|steht|cuando|con|quando|se)"
_DIRECTED = (  # how a part of the arm lies: "with the upper arm vertical", "when it points backwards"
    r"(?:vertical(?:ly|e|es)?|horizontal(?:ly|e|es)?|perpendicular|parallel|(?:lies|lie|points?|stands?) (?:along|on|over|up|down|back|to|in)\w*|upwards?|downwards?|backwards?|forwards?"
    r"|at (?:a )?right angles?|perpendiculaires?|parallèles?|(?:pointe|dirigée?) vers|à angle droit|senkrecht|waagerecht|waagrecht|rechtwinklig|(?:oberarm|unterarm|arm|glied) (?:auf|entlang)"
    r"|perpendicular(?:es)?|paralel[oa]s?|verticale|orizzontale|perpendicolare|parallel[oa])"
)
_POSTURE = regex(
    rf"\b(?:(?:out)?stretched|(?:fully|completely|entirely) (?:extended|folded|retracted)|full extension|folded|"
    rf"(?:zero|home|rest|initial|reference|singular|upright|vertical|horizontal) {_PLACE}|at the origin|straight (?!links?\b|segments?\b){_ARM}|"
    rf"(?:boundary|edge|border|limits?|bord|limite|frontière) (?:of|de) (?:the |its |l['’])?(?:workspace|reach|espace)|"
    rf"(?:{_ARM}|elbow|coude)(?: (?:is|are|being|est|sont|étant))? {_LIES}|tendue?s?|en extension|repliée?s?|dépliée?s?|à l['’]origine|"
    rf"{_PLACE} (?:zéro|nulle|initiale|singulière|de repos|de référence|verticale|horizontale)|"
    r"(?:vanish(?:es)?|s['’]annule(?:nt)?|est nul(?:le)?) (?:when|if|iff|for|at|pour|si|quand|lorsque|ssi))\b"
    rf"|\b{_BENT} {_AN_ANGLE}"
    rf"|\b{_WHERE} (?:(?!ax[ei]s\b|axes\b|plane\b|plan\b|achsen?\b|ejes?\b|assi\b|project\w*|force\w*|load\w*)[\w'’]+ ){{1,6}}{_DIRECTED}\b"
    rf"|\b(?:first|second|third|last|upper|lower|premier|deuxième|troisième|dernier) {_ARM}(?: (?:is|lies|lying|points|pointing|est|étant))? (?:along|parallel to|le long de|parallèle à)\b(?!\W*\Z)",
    re.IGNORECASE,
)

_BASE = regex(
    r"\b(?:joint|base|pivot|hinge|shoulder|foot|articulation|liaison|épaule|pied)"
    r"(?:,? (?:\$[^$]*\$|\d|is|are|lies|sits|stands|of|the|robot|arm|located|placed|fixed|mounted|anchored|est|du|le|bras|fixée?|située?|placée?))*\s*\Z",
    re.IGNORECASE,
)
_SINGULAR_PLACE = regex(rf"singular {_PLACE}|{_PLACE} singulière", re.IGNORECASE)
STRETCHED, FOLDED = "stretched", "folded"
_BENT_AS = {
    STRETCHED: regex(
        r"stretched|straight|full extension|en extension|extended|tendu|dépli|aligned|alignés?", re.IGNORECASE
    ),
    FOLDED: regex(r"folded|retracted|repli", re.IGNORECASE),
}
_DIRECTION = regex(r"vertical|horizontal|verticaux|upright|along|at the origin|à l['’]origine|axis|axe", re.IGNORECASE)
FARTHEST = 60  # characters of the words that lead to an angle
THERE = "there: "  # before a posture with which its sentence begins: "With the elbow at 90°,", and not "it vanishes when stretched"
_BEGINS = regex(
    r"\W*(?:and |but |so |et |mais )?(?:at|on|in|with|for|when|if|à|au|aux|sur|en|dans|avec|pour|quand|lorsque)\b",
    re.IGNORECASE,
)
_STOPS = regex(r"[.;:!?]\s")

_NUMBER = r"-?\d+(?:\.\d+)?"
_RATES = regex(
    rf"\b(?:joint (?:rates|velocities|speeds)|vitesses articulaires)(?: (?:of|are|be|equal to|de|sont|sont de|valent))? "
    rf"({_NUMBER}(?:, {_NUMBER})*,? (?:and|et) {_NUMBER}) ?rad/s",
    re.IGNORECASE,
)

_KINDS = {
    "revolute": r"revolute|rotary|rotational|rotating|rotoïde|rotoide|pivot|rotative|revoluta|rotacional|rotativa|giratoria|rotoidale|rotatorisch",
    "prismatic": r"prismatic|sliding|translational|prismatique|glissière|translation|prismática|prismatica|prismático|prismatico|prismatisch",
}
_JOINT = r"joints?|axis|axes|articulations?|liaisons?|articulación|articulaciones|juntas?|giunt[oi]|gelenke?"
_OF_A_KIND = regex(
    rf"(?<!and )(?<!or )(?<!et )(?<!ou )\b(?:(?:{'|'.join(_KINDS.values())})e?s? (?:{_JOINT})|(?:{_JOINT}) (?:est |is )?(?:{'|'.join(_KINDS.values())})e?s?)\b",
    re.IGNORECASE,
)


def kind_of_joints(text: str) -> str:
    """Return of which kind of joints a text speaks, "revolute" or "prismatic"; "" where of none, or of both."""
    found = [kind for kind, words in _KINDS.items() if re.search(rf"\b(?:{words})", text, re.IGNORECASE)]
    return found[0] if len(found) == 1 else ""


def tells_kind(latex: str) -> bool:
    """Whether what a text says between displays is of which kind a joint is, and no posture: "(revolute joint)"."""
    words = latex.removeprefix("\\text{").removesuffix("}").removeprefix(THERE)
    return _OF_A_KIND.fullmatch(words) is not None


def names_singular_place(latex: str) -> bool:
    """Whether what a text says between displays is a singular configuration, as the noun of a sentence."""
    return _SINGULAR_PLACE.fullmatch(latex.removeprefix("\\text{").removesuffix("}")) is not None


def bent_as(latex: str) -> str:
    """Return how a posture in words bends the inner joints, STRETCHED or FOLDED; "" where it says both, neither, or of directions."""
    found = [kind for kind, words in _BENT_AS.items() if words.search(latex)]
    return found[0] if len(found) == 1 and _DIRECTION.search(latex) is None else ""


def postures(text: str, line: int, section: str, led_by: str = "") -> Iterator[Display]:
    """Yield the words of a text that name a posture, or a kind of joints, each as what stands in the text between displays.

    It may be `led_by` the words before the formula that it stands behind, and that.
    """
    plain = " ".join(text.split())
    rest = without_joint_values(plain)
    named = (each for each in _POSTURE.finditer(rest) if not _places_base(led_by, rest, each))
    for found in (*named, *_OF_A_KIND.finditer(rest)):
        there = THERE if _begins_there(plain, found.start()) else ""
        yield Display(line, rf"\text{{{there}{found.group()}}}", section=section, opening=INLINE)
    for at, words in shapes(rest):
        there = THERE if _begins_there(plain, at) else ""
        yield Display(line, rf"\text{{{there}{words}}}", section=section, opening=INLINE)
    for latex in joint_values(plain):
        yield Display(line, latex, section=section, opening=INLINE)
    for found in _RATES.finditer(plain):
        rates = ", ".join(re.findall(_NUMBER, found[1]))
        yield Display(line, rf"\dot q = [{rates}]^T", section=section, opening=INLINE)


def _places_base(led_by: str, text: str, found: re.Match[str]) -> bool:
    """Whether it is a joint or the base that is at the origin, which is no posture: "with one revolute joint $\\theta$ at the origin"."""
    at_origin = found.group().lower().endswith(("origin", "origine"))
    before = f"{led_by} {text[: found.start()]}"[-FARTHEST:]
    return at_origin and _BASE.search(" ".join(before.split())) is not None


def bent_to(text: str, at: int) -> str | None:
    """Return the words for a posture that lead to an angle in degrees at a place, "with the elbow at $90^\\circ$"; None elsewhere."""
    found = _BENT_TO.search(text, max(0, at - FARTHEST), at)
    if found is None or not _DEGREES.match(text, at):
        return None
    there = THERE if _begins_there(text, found.start()) else ""
    return rf"\text{{{there}{found.group().strip()}}}"


def _begins_there(text: str, at: int) -> bool:
    """Whether the sentence in which a posture stands begins with it: at, with, when, …"""
    stops = [each.end() for each in _STOPS.finditer(text, max(0, at - 3 * FARTHEST), at)]
    return _BEGINS.match(text, max(stops, default=max(0, at - 3 * FARTHEST))) is not None
