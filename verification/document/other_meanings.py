r"""What the text says a letter or a place to be that is not what the arm has for it: "where $\theta_2$ is measured from the horizontal".

It holds from the heading above it on. What frame or point a text speaks of, it says of the displays beside it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import islice, pairwise
from math import inf

from armproof.verification.document.amended_tables import cells_of_tables
from armproof.verification.document.clauses import mentions_only, says_what_would_be
from armproof.verification.document.heading import is_ruled
from armproof.verification.document.hearing import (
    DELIMITED,
    MOST_CHARACTERS,
    formulas_of,
    hears,
    hears_denied,
    says,
    with_axes,
    words_of,
)
from armproof.verification.document.lengths_in_units import lengths_in_two_units
from armproof.verification.document.letters_anew import MAY_RENAME, letters_anew
from armproof.verification.document.model import Display, Document
from armproof.verification.document.strange import is_in_known_language
from armproof.verification.document.strange_letters import strange_letters
from armproof.verification.document.subjects import OTHER_BASE, OTHER_PLACE, subjects, without_tool_frame
from armproof.verification.document.told_in_passing import (
    MAY_TELL_IN_PASSING,
    RELATIVE_NOT,
    REORDERED,
    told_in_passing,
)
from armproof.verification.document.told_names import (
    MAY_TELL_NAMES,
    STRANGE,
    USUAL,
    Definition,
    Told,
    defined_in_rows,
    definitions,
    told_names,
)
from armproof.verification.document.told_notation import MAY_NOTE, notations_told
from armproof.verification.document.told_origins import (
    LETTER_OF_HEIGHT,
    MAY_TELL_ORIGIN,
    is_from_elsewhere,
    shift_of_base,
)
from armproof.verification.document.told_since import Since, told_since
from armproof.verification.document.told_tasks import told_tasks
from armproof.verification.document.told_variables import MAY_TELL_VARIABLE, variables_defined, variables_told
from armproof.verification.patterns import regex

MAY_MEAN = regex(  # what no sentence that gives another meaning lacks, in small letters: alike of all sizes takes six times as long
    r"opposite|opuest|oppost|opost|entgegengesetzt|contrar|belt|courroie|motor|moteur|fixed|fixe\b|festen|horizontal|(?:then|and|last|puis|ensuite|dann|luego|poi) (?:about|autour|um|alrededor|intorno|attorno)|fixed ax|negati[vf]|négati[vf]|absolu|clockwise|horair|horari|uhrzeiger|vertical|[xy][$ -]*axis|axe|eje|achse|ground|first link|half|moiti|middle|belong|origin|raised|pedestal|origine?|sur[ée]lev|points?\b|pointing"
    r"|downward|frame|rep[eè]re|koordinaten|elbow|coude|codo|cent(?:re|er) of|second|premier|floor|(?:\\theta|q)_\{?[2-9]\}?\s*(?:,|&|\\\\|\\[;,: ]|\\q?quad)?\s*(?:\\theta|q)_\{?1|aiguille|twice|double|\$2 ?[al]_|number|gripper|tool|boden|suelo|inclination|direction of|image|reflection|shoulder|épaule|schulter|hombro|spalla|ombro|base|upside|ceiling|wall|pixels|transpos|invers|masse?\b|gravit|bar[iy]c|schwerp|acc[eé]l|beschl|jacobi|column|colonne|spalten|columna|joint|gelenk|articul|omega|angular|rotational|angulaire|rotation|winkelgeschw|drehgeschw|rotator|angolare|backward|in reverse|roles of|interior|internal|inner|included|folded|total|overall|diam[eè]t|radius|measured from|convention|mirror|miroir|spiegel|espejo|repli|gefalt|plegad|ripieg|eingeklappt|\border\b|\bordre\b|reihenfolge|\borden\b|\bordine\b|q\}*\s*=|\\omega_|passiv|pasiv|\brows?\b|lignes?\b|zeile|filas?\b|righ?[ae]\b|linha|\bold\b|\bformer\b|ancien|\balten\b|coord|compon|compos|equal (?:bar|link|length|segment|arm)|[ée]gaux|[ée]gales|gleiche|iguales|uguali|left and right|inches|feet|pouces|zoll|pulgadas|pollici"
)
MAY_ASK = regex(r"following|suivant|folgend|siguiente|seguent|seguinte|true|vrai|richtig|wahr|verdader|vero|verdadeir")
_SENTENCE = regex(  # an item of a list is one of its own
    r"(?:\$[^$\n]+\$|\\[;!]|[^.;!?\n]|[.;!?](?!\s)|\n(?![^\S\n]*(?:\n|[*+-][^\S\n]|\d+[.)][^\S\n])))+[.;!?]?"
)
_SHOWN = regex(  # what is no sentence
    r"\$\$.{0,MOST}?\$\$|\\\[.{0,MOST}?\\\]|\\begin\{((?:equation|align|gather|multline|eqnarray|flalign|alignat|displaymath|verbatim|lstlisting|tabular)\*?)\}.{0,MOST}?\\end\{\1\}"
    r"|<!--.{0,MOST}?-->|```.{0,MOST}?```|^%[^\n]*|^[ \t]{0,3}#[^\n]*|\\(?:sub)*section\*?\{[^\n]*".replace(
        "MOST", "4000"
    ),  # characters: what is not closed is looked through no further
    re.DOTALL | re.MULTILINE,
)
_HEADING = regex(r"\s*(?:(#{1,6})\s|\\((?:sub)*)section)")
_MARKS_OF_HEADING = regex(r"^\s*#+|\\(?:sub)*section\*?|[{}]")
_LETTER = regex(r"(?:\\?[A-Za-z]+)\s*_\s*(?:\{?\s*[\dijk]\s*\}?)")
_BARE_ANGLE = regex(r"\s*\\(?:alpha|beta|gamma|(?:var)?theta|(?:var)?phi|psi)\s*")
_OF_FRAME = regex(
    r"\b(?:origine? (?:of|de|du) (?:the )?(?:frame|repère)|Ursprung von System) \$?\\?\{?(\d)\b", re.IGNORECASE
)
_OF_Q = regex(r"(?:\\mathbf\{)?q\}?\s*=\s*\\?(?:left)?(?:[\[(]|\\begin\{[bp]matrix\})(.*)")
_ENTRIES = regex(  # (r, \theta)^T of a formula that is a tuple, or equates a name to one
    r"(?:^|(?P<name>[^=]*)=)\s*(?:\\left)?\s*(?:[\[(]|\\begin\{[bp]?matrix\})(?P<entries>[^()\[\]=]*?)(?:\\right)?\s*(?:[\])]|\\end\{)"
)
_DOT = regex(r"\\dot\s*(?:\{([^{}]*)\}|(?=[\\\s]))")
_NAME_OF_JOINTS = regex(r"[\s{]*(?:\\(?:mathbf|boldsymbol|vec|bm|underline|dot)\s*[\s{]*)*(?:q|\\[tT]heta)[\s}]*")
_ROW = regex(
    r"(?:[vV]_\{?|\\dot\s*\{?\s*)([xyz])\}?|\\omega_\{?([xyz])\}?|(\\omega|\\dot\s*\{?\s*\\(?:var)?(?:phi|psi|theta)\}?)"
)
_OF_TWO_FRAMES = regex(r"\s*(?:\\\w+\s*\{)?[TAHR]\}?\s*_\s*\{\s*([a-z0-9])\s*,?\s*([a-z0-9])\s*\}\s*")
_AXIS_TURNED = regex(  # about $x$, the z-axis, $\hat Y_A$, x'' and the angle of it
    r"\$\s*(?:\\(?:hat|vec|mathbf|boldsymbol|overrightarrow)\s*\{?\s*)?([xyzXYZ])\}?(?:_\{?\w+\}?|\^?\{?'*(?:\\prime)*\}?)*\s*\$|(?<!\w)([xyzXYZ])-(?:axis|achse|direction)"
)
_OMEGA_ABOVE = regex(  # (ω, v), [ω; v]
    r"(?:[(\[]|matrix\})\s*(?:\\(?:boldsymbol|mathbf|vec|bm)\s*\{?\s*)?\\omega\b(?:_\w)?\}?(?:\^T)?\s*(?:,|;|&|\\\\)\s*(?:\\[,;: ])?(?:\\(?:boldsymbol|mathbf|vec|bm|dot)\s*\{?\s*)?[vp]\b"
)
_LENGTH = regex(r"[lLaAdDhHrR]\s*_")  # which is no angle from anything
_SUM = regex(r"(?:\\theta|q)_\{?1\}?\s*\+\s*(?:\\theta|q)_\{?2")  # that turns the second link, as both are relative
_OF_A_SUM = regex(r"[^=]*=\s*" + _SUM.pattern)  # β = θ_1 + θ_2
_BESIDE = regex(  # "¤, the absolute angles", and no "the angles being absolute"
    r"¤ , (?:(?:the|an|les|l'|un|die|der|los|las|el|gli|le|i|os|as) )?(?=absol|angle|winkel|ángul|angol|ângul)(?:(?!being|are|is|étant|sont|est|sind|ist|siendo|son|essendo|sendo)[^\s¤,:;]+ )*\Z",
    re.IGNORECASE,
)
_OF_BOTH = regex(  # "Relative and absolute angles", of which a heading says nothing
    r"\brelativ\w* (?:and|or|versus|vs|to|et|ou|und|oder|y|e|o) (?:\S+ )?absol|\babsol\w* (?:and|or|versus|vs|to|et|ou|und|oder|y|e|o) (?:\S+ )?relativ",
    re.IGNORECASE,
)
_IS = regex(r"(?:is|ist|est|es|è|beträgt|vale|equals|thus|then|also|somit|damit|donc|simply|[,:\\ ])*¤ ")
_ANGLE = regex(r"\\(?!hat|vec)[a-z]+(?:_\{?\w\}?)?|(?:q|t)_\{?\d\}?")  # α, θ_1, q_2
_TELLS = regex(  # what a sentence begins with that is of the display beside it
    r"(?:where |here |où |wobei |donde |dove |onde )?(?:this|these|that|which|it|¤|ce|c'|cela|ceci|das|dies|esto|questo|isto)"
    r" (?:is|are|denotes|gives|est|sont|désigne|donne|ist|sind|es|son|è|sono|é)\b",
    re.IGNORECASE,
)
_BASE_AT = regex(
    r"(?<!\S)(?:base|shoulder|pedestal|first joint|basis|sockel|socle|embase|épaule|hombro|spalla) (?:is|stands|sits|lies|(?:is |stands )?(?:mounted|placed|located|fixed)|est|se trouve|steht|liegt|está|sta|è) (?:placed |located |placée |située )?(?:at|in|en|bei|a|au point|at the point) ¤ "
)
_OF_ALL = regex(  # what is printed from here on, and not the next display alone
    r"(?<!\S)(?:all|every|everything|throughout|tout(?:es?)?|tous|alle[nrs]?|sämtliche[nrs]?|tod[oa]s?|tutt[oiae]) ",
    re.IGNORECASE,
)
_IS_SIGNED = regex(  # d_2 is positive on one side and negative on the other
    r"\bpositi[vf]\w* .{0,60}?\bn[eé]gati[vf]|\bn[eé]gati[vf]\w* .{0,60}?\bpositi[vf]|\bpositiv[oa]\b.{0,60}?\bnegativ[oa]\b",
    re.IGNORECASE,
)
_MOST_BEFORE = 2  # sentences that name what one is of
_MOST_AGAIN = 50  # times that a name is said to be something, of which the next one below another heading counts
_ROW_OF_TABLE = regex(r"^[ \t]*\|.*$", re.MULTILINE)  # of a table, which is no sentence
_OF_ROW = regex(r"([adrlL])\s*_?\s*\{?\s*(\d)\s*\}?")
_TELLS_LANGUAGE = 8000  # characters of a text
_NOUGHT = regex(r"\(\s*0(?:\s*[,;]\s*0)*\s*\)")
_TUPLE = regex(r"\(\s*[^(),;]+(?:[,;]\s*[^(),;]+)+\)(?:\^\{?(?:T|\\top)\}?)?")
_UNIT = regex(
    r"(?<!\S)(?:in|en|into) (inch|feet|foot|pouce|zoll|pulgada|pollici|mm|millim|cm|centim|zentim|decim|met|mèt|m )"
)
_PLURAL = regex(
    r"\b(?:angles|(?:second|third|last|elbow|other) (?:angle|motor|encoder|drive|actuator|servo|sensor)|(?:second|deuxième|dernier) (?:moteur|codeur|capteur)|zweiter? (?:motor|encoder|antrieb|geber)"
    r"|(?:segundo|secondo) (?:motor|encoder|motore|actuador|attuatore)|both|all|each|every|chaque|rotations?|turns|positi[fv]e?|winkel|ángulos|deux|number(?:ed)?|roles)\b",
    re.IGNORECASE,
)
_OF_BOTH_KINDS = (
    regex(  # "Joint and segment angles are also called relative and absolute angles": those of the joints are relative
        r"(?i)(?<!\S)joint and (?:segment|link|limb) angles .*(?<!\S)relative and absolute\s"
        r"|(?<!\S)joint angles .*(?<!\S)relative\s.*(?<!\S)(?:segment|link|limb) angles .*(?<!\S)absolute\s"
    )
)
_OF_FIRST_ANGLE = regex(  # one that is no relative angle anyway: that of the shoulder
    r"(?<!\S)(?:shoulder angle|schulterwinkel|(?:angle|ángulo|angolo|ângulo|winkel) (?:of |at |d' |de |de l' |del |della |do |der )(?:the |l' |la )?(?:shoulder|épaule|schulter|hombro|spalla|ombro)) "
)
_VERTICAL = regex(r"(?<!\S)(?:vertical|senkrecht|lotrecht)", re.IGNORECASE)
_OTHERWISE = regex(  # what an angle from the vertical may be besides
    r"clockwise|horair|uhrzeiger|horari|orari|y-axis|downward|bas\b|number|from the (?:tip|tool|end|gripper|hand)|role|fold|interior|inner|intérieur|hang|pendant",
    re.IGNORECASE,
)
_IS_TURNED = regex(
    r"(?<!\S)(?:is|are|be|being|was|est|sont) (?:first |then |next |now |d'abord |ensuite |puis )?(?:turned|rotated|tournée?s?) ",
    re.IGNORECASE,
)
_NAMED_TURN = regex(r"(?<!\S)(roll|pitch|yaw|heading|bank)(?!\S)")
_OF_EULER = regex(  # angles of an orientation, and of no joint
    r"\beuler(?:ian)? angles?\b|\bangles? (?:of|d'|de|di) ?euler\b|\bángulos de euler\b|\beuler-?winkel\b",
    re.IGNORECASE,
)

TURNS = "turns"  # the order of the factors of rotations one after another, as their axes, and their angles where they are told: zyx α β γ
OMEGA_FIRST = "omega first"  # a Jacobian, or a twist, whose first rows are those of ω
ALL, BEHIND = "all", "behind"  # the angles of all joints; those that turn about the direction of one before
UPRIGHT = "upright"  # an angle from the vertical: what it moves stands up at 0
PASSIVE = "passive"  # R that turns axes
MAY_BE_PASSIVE = "may be passive"  # R that may lead from the coordinates in one basis to those in the other
OUTWARDS = "outwards"  # T_{ij} whose first index is the frame that the second sees
ASKED = "asked"  # what the reader is to call true or false
EQUAL = "equal"  # lengths that are, where two letters have two lengths elsewhere
SIGNED = "signed"  # a letter of the arm that may have either sign
COLUMNS = "columns"  # J_1, J_2 that are columns of J
FROM_SHOULDER = "from shoulder"  # seen from there, which an arm may have above its base
BASE_AT = "base at"  # the height of a shoulder, which an arm may have
ORDER = "order"  # the joint variables as q holds them
ANEW = "anew"  # a letter that is something else for a while
FRAME, JACOBIAN = "link", "J"  # the origin of one; that whose columns are those of joints in another order
_TURNED_ROWS = [3, 4, 5, 0, 1, 2]  # of (ω_x, ω_y, ω_z, v_x, v_y, v_z)
_MOST_OF_TASK = 5  # rows of a task
_NEAR_ABOVE, _NEAR_BELOW = 4, 8  # lines between a sentence and a display beside it


@dataclass(frozen=True)
class Meaning:
    """What a sentence says on a line: letters that have another meaning, the frame whose origin it is of, what it is of `beside`, another point, frame or origin; or that all is expressed in another frame, `is_frame`.

    Letters of what would be, under a heading or to be called true or false, have it within the lines of `reach` alone. Letters `anew` have it from the sentence on, to the end of its section where `is_of_section`, and only where they have stood above it.
    """

    line: int
    letters: tuple[str, ...] = ()
    frame: str = ""
    beside: str = ""
    is_place: bool = False
    is_origin: bool = False
    is_frame: bool = False
    anew: tuple[str, ...] = ()
    is_of_section: bool = False
    reach: tuple[int, float] | None = None


def with_other_meanings(document: Document, text: str) -> Document:
    """Return a document whose displays know which letters its text gives another meaning than usual, and where it is of another place."""
    tables = [*cells_of_tables(document)]
    since = [*told_since(text, document.displays, [*_sentences(text)], lambda line: _reach(line, text), tables)]
    found = [*_meanings(text), *_of_headings(text), *_in_strange_words(document, text), *_in_passing(document, text)]
    for display in document.displays:
        if letters := tuple(_orders([display.latex], "")):  # q = [r; θ]
            found.append(Meaning(display.line, letters))
    if not (found or since):
        return document
    said = [(each, *_reach(each.line, text)) for each in found]
    return replace(document, displays=tuple(_with(display, said, since) for display in document.displays))


def _reach(line: int, text: str) -> tuple[int, float]:
    """Return from the heading above a line to the next one that is not below that: lines, 0 and infinity where there is none."""
    headings = _headings(text)
    begin, level = next((each for each in reversed(headings) if each[0] <= line), (0, 0))
    return begin, next((at for at, own in headings if at > line and own <= level), inf)


def told_below(text: str, *tells: Callable[[str], Iterable[str]]) -> Iterator[tuple[str, int, float]]:
    """Yield what sentences tell, each with the lines of the section, from its heading on, of which it holds."""
    for found in _SENTENCE.finditer(_without_shown(text)):
        sentence = found.group()
        for each in (each for one in tells for each in one(sentence)) if len(sentence) <= MOST_CHARACTERS else ():
            line = text.count("\n", 0, found.start() + len(sentence) - len(sentence.lstrip())) + 1
            yield each, *_reach(line, text)


@lru_cache(maxsize=2)
def _headings(text: str) -> tuple[tuple[int, int], ...]:
    """Return the lines of the headings of a text and their levels; of those with a rule below, by the order in which the marks come."""
    lines, marks, found = text.split("\n"), list[str](), list[tuple[int, int]]()
    for at, (line, below) in enumerate(pairwise([*lines, ""]), start=1):
        if match := _HEADING.match(line):
            found.append((at, len(match[1]) if match[1] else 1 + len(match[2]) // len("sub")))
        elif is_ruled(line, below) and len(below.rstrip()) >= len(line.rstrip()):
            marks += [below[0]] * (below[0] not in marks)
            found.append((at, 1 + marks.index(below[0])))
    return tuple(found)


def _with(display: Display, said: Iterable[tuple[Meaning, int, float]], since: Iterable[Since]) -> Display:
    """Return a display with what holds of it: of a letter from the heading above on, of a place beside it alone."""
    if display.erratum:
        return display
    letters = [*display.meant]
    is_elsewhere = in_other_frame = False
    for each, begins, ends in said:
        is_near = each.line - _NEAR_ABOVE <= display.line <= each.line + _NEAR_BELOW
        is_near = is_near and begins <= display.line < ends
        if each.frame and is_near:
            letters.append(f"{FRAME} {each.frame}")
        if each.beside and is_near:
            letters.append(each.beside)
        first, last = (begins, ends) if each.is_of_section else (0, inf)
        if each.anew and max(first, each.line - _NEAR_ABOVE) <= display.line < last:
            letters += each.anew
        begin, end = each.reach or (begins, inf)
        if each.letters and (begin <= display.line <= end or (display.file and each.reach is None)):
            letters += each.letters
        is_elsewhere |= each.is_place and is_near
        is_elsewhere |= each.is_origin and display.line >= begins
        in_other_frame |= each.is_frame and begins <= display.line < ends
    letters += (each.said for each in since if each.begins <= display.line < each.ends)
    return replace(
        display,
        meant=tuple(dict.fromkeys(letters)),
        of_other_point=display.of_other_point or is_elsewhere,
        in_other_frame=display.in_other_frame or in_other_frame,
    )


def _sentences(text: str) -> Iterator[tuple[int, str]]:
    """Yield the sentences of a text, each with the place where it begins."""
    for found in _SENTENCE.finditer(_without_shown(text)):
        sentence = found.group()
        yield found.start() + len(sentence) - len(sentence.lstrip()), sentence.strip()


def sentences_with_lines(text: str) -> Iterator[tuple[int, str]]:
    """Yield the sentences of a text, each with the line on which it begins."""
    yield from ((text.count("\n", 0, at) + 1, sentence) for at, sentence in _sentences(text))


def _without_shown(text: str) -> str:
    return _SHOWN.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def _meanings(text: str) -> Iterator[Meaning]:
    """Yield what the sentences of a text say of letters and places that is not what an arm has for them."""
    shown = _without_shown(text)
    line, at = 1, 0
    defined = [(text.count("\n", 0, place) + 1, each) for place, each in defined_in_rows(text)]
    goes_on = ""  # what stands before a semicolon: "In this section …; $\\theta_3$ is then …"
    for found in _SENTENCE.finditer(shown):
        sentence = found.group()
        begins = found.start() + len(sentence) - len(sentence.lstrip())
        line, at = line + text.count("\n", at, begins), begins
        before, goes_on = goes_on, sentence if sentence.endswith(";") else ""
        small = (before + sentence).lower()
        if MAY_ASK.search(small) and says("ASKS_WHICH", words_of(sentence)):
            yield Meaning(line, (ASKED,), reach=(line, _reach(line, text)[1]))
        if len(sentence) <= MOST_CHARACTERS and MAY_NOTE.search(small):
            yield from (Meaning(line, (each,)) for each in notations_told(sentence))
        if _holds_formula(sentence):
            defined += ((line, each) for each in _defined_in(sentence))
        if len(sentence) <= MOST_CHARACTERS and MAY_TELL_VARIABLE.search(small):
            plain = with_axes(" ".join(sentence.split()))
            yield from (Meaning(line, (each,)) for each in variables_told(words_of(plain), formulas_of(plain)))
        if len(sentence) <= MOST_CHARACTERS and MAY_TELL_ORIGIN.search(small):
            plain = with_axes(" ".join(sentence.split()))
            if is_from_elsewhere(words_of(plain), formulas_of(plain)):
                yield Meaning(line, is_origin=True)
        if len(sentence) > MOST_CHARACTERS or not (MAY_MEAN.search(small) or MAY_RENAME.search(small)):
            continue
        plain = with_axes(" ".join(sentence.split()))
        words, formulas = _OF_EULER.sub("these", words_of(plain)), formulas_of(plain)
        if letters := () if _leads_to_sums(text, begins) else tuple(_letters(words, formulas)):
            is_here = says_what_would_be(words)
            yield Meaning(line, letters, reach=_paragraph(text, begins, found.end()) if is_here else None)
        renamed, is_of_section = letters_anew(words_of(before) + words, [*formulas_of(before), *formulas])
        above = _above_section(text, line, found.start()) if is_of_section else text[: found.start()]
        if renamed and (known := tuple(_that_stand_in(above, renamed))):
            yield Meaning(line, anew=known, is_of_section=is_of_section)
        whole = with_axes(" ".join((before + sentence).split()))  # "turned about x, then y; all axes are the base's"
        if not goes_on and (turns := _turns(whole, words_of(whole))):
            yield Meaning(line, beside=f"{TURNS} {turns}")
        yield from _of_places(line, plain, words, formulas, text)
    for line, each in defined:
        reach = _reach(line, text) if each.is_of_section else None
        yield from (Meaning(line, (told,), reach=reach) for told in variables_defined(each))
    yield from _of_names([(line, told) for line, each in defined for told in told_names([each])], text)


def _leads_to_sums(text: str, begins: int) -> bool:
    r"""Whether a sentence that begins there leads with "the absolute angles" to a display in which these are sums, \phi_2 = \theta_1 + \theta_2: the joints' are relative."""
    shown = _SHOWN.search(text, begins)
    if shown is None or "absol" not in " ".join(text[begins : shown.start()].lower().split()[-3:]):
        return False
    sides = re.sub(r"&|\\[,;: ]", " ", shown.group()).replace("\\\\", ",").split(",")
    return any(_OF_A_SUM.match(each) and not re.search(r"(?:\\theta|(?<![A-Za-z\\])q)[^=]*=", each) for each in sides)


def _holds_formula(sentence: str) -> bool:
    return "$" in sentence or "\\(" in sentence or ":math:" in sentence


def _in_strange_words(document: Document, text: str) -> Iterator[Meaning]:
    """Yield which letters a text tells of in words that are not known, behind their sentence up to the end of its section."""
    if _is_of_cells(document) or not is_in_known_language(words_of(text[:_TELLS_LANGUAGE])):
        return
    for line, sentence in sentences_with_lines(text):
        if _holds_formula(sentence) and len(sentence) <= MOST_CHARACTERS:
            yield from (
                Meaning(line, (told,), reach=(line, _reach(line, text)[1])) for told in strange_letters(sentence)
            )


def _is_of_cells(document: Document) -> bool:
    """Whether the lines of displays are those of their cells, and not of the text."""
    return any(display.cell is not None for display in document.displays)


def _in_passing(document: Document, text: str) -> Iterator[Meaning]:
    """Yield what sentences tell of letters in passing, behind them up to the end of their section."""
    if _is_of_cells(document) or not MAY_TELL_IN_PASSING.search(text.lower()):
        return
    before: list[tuple[str, int]] = []  # the words of the two sentences above, and where their sections begin
    for line, sentence in sentences_with_lines(text):
        if len(sentence) > MOST_CHARACTERS or not sentence or _ROW_OF_TABLE.search(sentence):
            continue
        begin, end = _reach(line, text)
        plain = with_axes(" ".join(sentence.split()))
        words = words_of(plain)
        above = "".join(each for each, section in before[-_MOST_BEFORE:] if section == begin)
        for which, letter in told_in_passing(words, formulas_of(plain), above):
            meant = JACOBIAN if which == REORDERED else f"{BEHIND if which == RELATIVE_NOT else ANEW} {letter}".rstrip()
            yield Meaning(line, (meant,), reach=(line, end))
        before.append((words, begin))


def _of_places(line: int, plain: str, words: str, formulas: Sequence[str], text: str) -> Iterator[Meaning]:
    """Yield what a sentence says of frames, points, units and signs."""
    if (frame := _OF_FRAME.search(words)) is not None:
        yield Meaning(line, frame=frame[1])
    if _TELLS.match(words):
        for heard in subjects(words, formulas):
            of_place = heard in (OTHER_PLACE, OTHER_BASE)
            yield Meaning(line, is_place=True) if of_place else Meaning(line, beside=heard)
    is_over = words.rstrip()[-1:] in ".!" and not mentions_only(words)
    if is_over and any(says(each, without_tool_frame(words)) for each in ("OTHER_POINT", "OTHER_FRAME")):
        yield Meaning(line, is_place=True)
    yield from (Meaning(line, (f"{ALL} {each}",)) for each in lengths_in_two_units(plain))
    if len({*_UNIT.findall(words.lower())}) > 1:  # lengths in inches, and what is printed in millimetres
        yield Meaning(line, is_place=True)
    if _OF_ALL.search(words) and says("OTHER_FRAME", words):
        yield Meaning(line, is_frame=True)
    if _IS_SIGNED.search(words):
        alone = tuple(f"{SIGNED} {each.strip()}" for each in formulas if _LETTER.fullmatch(each.strip()))
        yield Meaning(line, alone)
    if says("ORIGIN_AT_SHOULDER", words):
        yield Meaning(line, (FROM_SHOULDER,), reach=(line, _reach(line, text)[1]))
    elif says("FROM_SHOULDER", words):
        yield Meaning(line, (FROM_SHOULDER,), reach=(line, line + _NEAR_BELOW))
    by = shift_of_base(words, formulas)
    is_elsewhere = says("OTHER_ORIGIN", words) and not _is_in_a_row(by, text)
    if is_elsewhere and LETTER_OF_HEIGHT.fullmatch(by):
        yield Meaning(line, (f"{BASE_AT} {by}",))
    elif is_elsewhere or _has_base_elsewhere(words.lower(), formulas):
        yield Meaning(line, is_origin=True)


def _is_in_a_row(by: str, text: str) -> bool:
    """Whether a table of a text holds a letter: what it shifts is in its row."""
    letter = _OF_ROW.fullmatch(by)
    cell = rf"(?<![A-Za-z\\]){letter[1]}\s*_?\s*\{{?\s*{letter[2]}(?!\d)" if letter is not None else r"(?!)"
    return any(re.search(cell, row) for row in _ROW_OF_TABLE.findall(text))


def _defined_in(said: str) -> Iterator[Definition]:
    """Yield the definitions of names in a sentence."""
    sentence = _ROW_OF_TABLE.sub("", said)
    if len(sentence) <= MOST_CHARACTERS and MAY_TELL_NAMES.search(sentence.lower()):
        yield from definitions(with_axes(" ".join(sentence.split())))


def _of_names(named: Sequence[tuple[int, Told]], text: str) -> Iterator[Meaning]:
    """Yield which names have not their usual meaning, from the heading above on, up to one below which they are said to have it again."""
    is_read = all(told.place != STRANGE for _, told in named) or is_in_known_language(words_of(text[:_TELLS_LANGUAGE]))
    of_name: dict[str, list[tuple[int, Told]]] = {}
    for at, told in named:
        of_name.setdefault(told.name, []).append((at, told))
    for line, told in named:
        if told.place == USUAL or (told.place == STRANGE and not is_read):
            continue
        begin = line if told.is_anew else _reach(line, text)[0]
        again = islice((at for at, each in of_name[told.name] if at > line and each != told), _MOST_AGAIN)
        end = next((head for at in again if (head := _reach(at, text)[0]) > line), None)
        is_limited = told.is_anew or end is not None
        yield Meaning(line, (told.as_meant(),), reach=(begin, inf if end is None else end - 1) if is_limited else None)


def _of_headings(text: str) -> Iterator[Meaning]:
    """Yield what the headings of a text say of letters: "Absolute angles", "Equal bars"."""
    lines = text.split("\n")
    for line, _ in _headings(text):
        said = _MARKS_OF_HEADING.sub(" ", with_axes(lines[line - 1]))
        words, formulas = words_of(said), formulas_of(said)
        equal = (EQUAL,) if says("EQUAL_LENGTHS", words) else ()
        defined = [*definitions(said)]
        named = [each.as_meant() for each in told_names(defined)]
        variables = [*variables_told(words, formulas), *(told for each in defined for told in variables_defined(each))]
        own = () if _OF_BOTH.search(words) else _letters(words, formulas)
        if letters := (*own, *equal, *named, *variables):
            yield Meaning(line, letters, reach=_reach(line, text))


def _paragraph(text: str, start: int, end: int) -> tuple[int, int]:
    """Return the lines of the displays beside a sentence: those in its paragraph and right below, and right above where it goes on from them."""
    before, behind = text.rfind("\n\n", 0, start), text.find("\n\n", end)
    first, last = (text.count("\n", 0, at) + 1 for at in (before + 2, behind if behind >= 0 else len(text)))
    return first - _NEAR_ABOVE * text[before + 2 : before + 3].islower(), last + 2


def _above_section(text: str, line: int, place: int) -> str:
    """Return what stands above the section of a line: what a sentence says of its whole section changes no letter in it."""
    begin = _reach(line, text)[0]
    return text[:place] if begin == 0 else "".join(text.splitlines(keepends=True)[: begin - 1])


def _that_stand_in(text: str, letters: Sequence[str]) -> Iterator[str]:
    """Yield the letters that stand in the displays and formulas of a text, as what holds of a display."""
    displays = [found.group() for found in _SHOWN.finditer(text)]
    formulas = " ".join([*displays, *(found.group() for found in DELIMITED.finditer(_SHOWN.sub(" ", text)))])
    for letter in letters:
        index = re.fullmatch(r"(?:\\theta|q)\s*_\s*\{?\s*(\d)\s*\}?", letter)
        in_sine = rf"|(?<![A-Za-z])[cCsS]_?\{{?\d*{index[1]}" if index else ""  # θ_2 stands in c_{12}
        if re.search(rf"(?<![\\A-Za-z]){re.escape(letter)}(?![A-Za-z]){in_sine}", formulas):
            yield f"{ANEW} {letter}"


def _has_base_elsewhere(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence puts the base at a point whose coordinates are not all zero: "The base stands at $(0.2, 0)$"."""
    found = _BASE_AT.search(words)
    if found is None:
        return False
    point = formulas[words.count("¤", 0, found.end()) - 1].strip()
    return _TUPLE.fullmatch(point) is not None and _NOUGHT.match(point) is None


def _letters(words: str, formulas: Sequence[str]) -> Iterator[str]:
    r"""Yield the letters that a sentence gives another meaning; `ALL` for all angles, `BEHIND` for all but the first, `JACOBIAN`."""
    for name in ("LEVEL", "NOT_RELATIVE", "TURNED"):
        begin = hears(name, words)
        is_denied = name != "NOT_RELATIVE" and hears_denied(name, words)
        if begin is None or is_denied or words[: begin.start()].rstrip().endswith(("counter", "anti")):
            continue
        if name == "LEVEL" and "¤" not in words and _OF_BOTH_KINDS.search(words):
            continue
        place = words.count("¤", 0, begin.end())
        if name == "LEVEL" and _IS.match(words[begin.end() :]) and _SUM.match(formulas[place].strip()):
            continue  # "the angle of the second link to the x-axis is θ_1 + θ_2"
        if name == "LEVEL" and _is_of_a_sum(words[: begin.end()], formulas):
            continue
        subjects = [each for formula in formulas[:place] for each in _LETTER.findall(formula)]
        subjects += [each.strip() for each in formulas[:place] if _BARE_ANGLE.fullmatch(each)]
        subjects = [each for each in subjects if name == "TURNED" or not _LENGTH.match(each)]
        if name != "TURNED":
            yield from (f"{BEHIND} {each}" for each in subjects)
        else:
            which = UPRIGHT if _VERTICAL.search(words) and not _OTHERWISE.search(words) else ALL
            yield from (f"{which} {each}" for each in subjects)
        is_of_other = (
            "¤" in words[: begin.end()] and not subjects
        )  # "The angle φ is absolute, the joint angles are not"
        of_all = words[: begin.end()] if is_of_other or _OF_FIRST_ANGLE.search(begin.group()) else words
        is_named = any(re.search(r"\d", each) or _BARE_ANGLE.fullmatch(each) for each in subjects)
        if _PLURAL.search(of_all) and not is_named:  # all θ_i, too
            yield BEHIND if name != "TURNED" else ALL
    for name in ("OTHER_LENGTH", "SWAPPED"):
        if (half := hears(name, words)) is not None:
            first = words.count("¤", 0, half.start())
            within = formulas[first : first + (half.group().count("¤") or 1 if name == "OTHER_LENGTH" else 2)]
            yield from (f"{ALL} {each.strip()}" for each in within if _LETTER.fullmatch(each.strip()))
    yield from (
        f"{ALL} {letter}"
        for formula in formulas
        if "length" in words
        for letter in re.findall(r"^\s*2\s*(\w_\d)\s*$", formula)
    )
    yield from _orders(formulas, words)
    if hears("OF_COLUMNS", words) is not None:
        yield " ".join((COLUMNS, *(each.strip() for each in formulas if re.fullmatch(r"\s*J_\{?\d\}?\s*", each))))
    if says("PASSIVE", words) or hears("TURNS_AXES", words) or says("ROW_VECTORS", words):
        yield PASSIVE
    elif says("OF_TWO_BASES", words):
        yield MAY_BE_PASSIVE
    pairs = filter(None, map(_OF_TWO_FRAMES.fullmatch, formulas))
    if says("SEEN_FROM", words) and any(_are_indices(each, formulas) for each in pairs):
        yield OUTWARDS
    if says("OMEGA_FIRST", _with_velocities(words, formulas)) or any(map(_OMEGA_ABOVE.search, formulas)):
        yield OMEGA_FIRST


def _is_of_a_sum(before: str, formulas: Sequence[str]) -> bool:
    """Whether a phrase stands beside a letter that is defined as θ_1 + θ_2: "β = θ_1 + θ_2, the absolute angle of bar 2" makes θ_2 a relative one."""
    if _BESIDE.search(before) is None:
        return False
    defined = formulas[: before.count("¤")]
    others = [each.rpartition("=")[2] for each in defined if not _OF_A_SUM.match(each)]
    return _OF_A_SUM.match(defined[-1]) is not None and not any(
        re.search(r"_\s*\{?\s*[^1\s{]", each) for each in others
    )


def _are_indices(pair: re.Match[str], formulas: Sequence[str]) -> bool:
    """Whether the indices of T_{ij} stand alone in a sentence, in that order: frame i is the one that is seen from frame j."""
    alone = [formula.strip() for formula in formulas]
    return all(each in alone for each in pair.groups()) and alone.index(pair[1]) < alone.index(pair[2])


def _orders(formulas: Sequence[str], words: str) -> Iterator[str]:
    """Yield what formulas and the words around them say of the order of columns and rows: `JACOBIAN` of another than usual, `ORDER` and the joints."""
    tuples, listed = [*_tuples(formulas)], [formula.strip() for formula in formulas]
    orders = [_indices(at[1]) for formula in formulas if words for at in _OF_Q.finditer(formula)]
    if (columns := hears("OTHER_COLUMNS", words)) is not None:
        orders.append(_indices(" ".join(formulas[words.count("¤", 0, columns.start()) :])) + [1][: "first" in words])
    orders += [_rows(entries) for _, entries in tuples]
    orders += [_rows([*filter(_ROW.fullmatch, listed)])] * says("OF_ROWS", words)
    if _TURNED_ROWS in orders:
        yield OMEGA_FIRST
    orders = [indices for indices in orders if indices != _TURNED_ROWS]
    if any(told_tasks(words, formulas)):  # in whose rows J is read
        orders = [indices for indices in orders if len(indices) > _MOST_OF_TASK]
    if any(indices != sorted(indices) for indices in orders) or says("COLUMNS_REVERSED", words):
        yield JACOBIAN
    of_joints = [entries for name, entries in tuples if _NAME_OF_JOINTS.fullmatch(name)]
    in_brackets = [entries for name, entries in tuples if not name and len(entries) > 1]
    for entries in [*of_joints, *(in_brackets or [listed]) * says("IN_ORDER", words)]:
        yield " ".join((ORDER, *("".join(_DOT.sub(_undotted, each).split()) for each in entries)))


def _undotted(dotted: re.Match[str]) -> str:
    """Return the letter whose rate a formula has."""
    return dotted[1] or ""


def _tuples(formulas: Sequence[str]) -> Iterator[tuple[str, list[str]]]:
    """Yield the tuples and columns of formulas: the name that each is said to be, "" without one, and its entries without the dots of rates."""
    for formula in formulas:
        for found in _ENTRIES.finditer(formula) if len(formula) <= MOST_CHARACTERS else ():
            entries = [each.strip() for each in re.split(r",|;|&|\\\\", found["entries"])]
            if len(entries) > 1 and all(entries):
                yield found["name"] or "", entries


def _rows(entries: Sequence[str]) -> list[int]:
    """Return the rows of a Jacobian of which entries are, v_x the first and ω_z the sixth; [] where one is of none."""
    found = [_ROW.fullmatch(entry) for entry in entries]
    rows = ["xyz".index(each[1]) if each[1] else 3 + "xyz".index(each[2] or "z") for each in found if each is not None]
    return rows if len(rows) == len(entries) else []


def _with_velocities(words: str, formulas: Sequence[str]) -> str:
    r"""Return the words of a sentence with those for $\omega$ and $v$ in place of the letters."""
    said = iter(formulas)
    names = {"\\omega": "angular velocity", "v": "linear velocity"}
    return " ".join(names.get(next(said, "").strip(), each) if each == "¤" else each for each in words.split()) + " "


def _turns(plain: str, words: str) -> str:
    """Return the axes of the factors of rotations that a sentence has one after another: the last first about fixed axes, the first about those turned before."""
    if not (hears("TURNS", words) and hears("AFTER_ONE_ANOTHER", words)):
        return ""
    of_axes = _IS_TURNED.sub("", words)
    is_fixed, is_turned = hears("FIXED_AXES", words) is not None, hears("TURNED_AXES", of_axes) is not None
    axes = [next(filter(None, found.groups())).lower() for found in _AXIS_TURNED.finditer(plain)]
    if is_fixed == is_turned or not 2 <= len(axes) <= 3:
        return ""
    angles = [each for formula in formulas_of(plain) if _ANGLE.fullmatch(each := formula.strip())]
    places = _named_order(words.lower(), len(axes))
    axes, angles = ([each[k] for k in places] if len(each) == len(places) else each for each in (axes, angles))
    step = -1 if is_fixed else 1
    return " ".join(("".join(axes[::step]), *(angles[::step] if len(angles) == len(axes) else ())))


def _named_order(words: str, count: int) -> list[int]:
    """Return in which order turns are made that have names, by their places: "roll about ¤, yaw about ¤, in the order yaw, roll"."""
    before, _, behind = words.partition(" order ")
    names, order = ([*dict.fromkeys(_NAMED_TURN.findall(each))] for each in (before, behind))
    return [names.index(each) for each in order] if sorted(names) == sorted(order) and len(names) == count else []


def _indices(latex: str) -> list[int]:
    return [int(index) for index in re.findall(r"(?:\\(?:var)?theta|q)\s*_\s*\{?\s*(\d)", latex)]
