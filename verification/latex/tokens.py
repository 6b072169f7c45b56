"""The tokens of kinematic LaTeX: a lexer for the grammar in `kinematics.lark`.

Layout commands vanish here, scripts are taken whole (their text is read later, once it is known what they
are attached to), and each token keeps its place in the display so that every message can point at it.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache

from lark import Token
from lark.lexer import Lexer

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex.greek import LONG, one_of
from armproof.verification.latex.solids import ARROWS
from armproof.verification.latex.units import PER_CENT, UNIT, UNKNOWN, mark_of, read_unit
from armproof.verification.latex.vocabulary import (
    ACCENTS,
    ASKED,
    BARE_CONSTANTS,
    BARE_JOINING,
    BARE_WORDS,
    CHARACTERS,
    COMMANDS,
    CONNECTIVES,
    DRESSES,
    FUNCTIONS,
    JOINING,
    LAYOUTS,
    LETTERS,
    MATRICES,
    NO_LETTERS,
    NO_UNITS,
    OF_CLASSES,
    PUNCTUATION,
    QUANTITIES,
    RELATIONS,
    SAID_OF_VALUES,
    SPACES,
    STRIKES,
    STYLES,
    TRANSPARENT,
    UNIT_NAMES,
    UNWRITTEN,
    VARIANTS,
    WORD_STYLES,
)
from armproof.verification.patterns import regex

MAX_TOKENS = 20_000
MAX_DEPTH = 60

_MASTER = regex(
    r"""
    (?P<SPACE>(?:\s|~|\\[,;:!>\ ]|\\(?:%s)(?![A-Za-z])|\\(?=\n|\Z)|%%[^\n]*\n)+)
  | (?P<TAG>\\(?:color|hspace\*?|cline|cmidrule|rule|eqno)\s*\{[^{}]*\})
  | (?P<NEWLINE>\\\\\*?(?:\s*\[\s*-?[\d.]+\s*(?:ex|em|pt|mm|cm|in|\\baselineskip)\s*\])?|\\cr(?![A-Za-z])|\\newline(?![A-Za-z])|\\tabularnewline(?![A-Za-z]))
  | (?P<BEGIN>\\begin\s*\{\s*([A-Za-z]+)\*?\s*\})
  | (?P<END>\\end\s*\{\s*([A-Za-z]+)\*?\s*\})
  | (?P<SCRIPT>[_^])
  | (?P<NUMBER>\d+(?:(?:\.|\{,\})\d+)?|\.\d+)
  | (?P<BRACESPACE>\{\s*\})
  | (?P<FENCE>\\(?:left|right)\s*(?:\\[lr]?(?:brace|brack|vert|angle|Vert)|\\[{}|]|\\rangle|[][()|/<>.]))
  | (?P<MACRO>\\(?:[A-Za-z]+|[{}|&%%$\#_]))
  | (?P<BARE>%s)
  | (?P<LETTER>[A-Za-z])
  | (?P<ASSIGN>:=)
  | (?P<CHAR>.)
    """
    % (
        SPACES,
        r"(?<![A-Za-z\\])(?:%s)(?![A-Za-z])|WC(?=\s*(?:[-+_^=&)|]|\\\||$))|(?:EE|wc)(?=\s*_\s*\{?\s*[xyz](?![A-Za-z]))|%s"
        % ("|".join([*BARE_JOINING, *BARE_CONSTANTS]), "|".join([*BARE_WORDS, *LONG])),
    ),
    re.VERBOSE | re.DOTALL,
)
# what may follow a dot that is a product: not the end of a line, a word or a blank after a full stop
_FACTOR = regex(
    r"(?:\\[,;:! ]|[ \t])*(?:\\(?!(?:end|right|q?quad|text|textrm|tag|label|hspace|vspace|mbox|hbox|newline|cr|notag|nonumber|"
    r"Rightarrow|implies|iff|to|therefore|Leftrightarrow|dots|ldots|cdots)(?![A-Za-z]))[A-Za-z{]|[A-Za-z({\[^])"
)
_BRACED_SCRIPTS = regex(r"\{\s*(?:\{\s*\}\s*)?(?:[_^]\s*(?:\{[^{}]*\}|\\[A-Za-z]+|[^\s{}\\])\s*)+\}(?=\s*\S)")
_BRACED_OPERATOR = regex(r"\{\s*(?:[-+=]|\\(?:cdot|times|wedge|pm|mp)(?![A-Za-z]))\s*\}")  # θ_1{+}θ_2, set closely
_SCRIPT_BEFORE = regex(r"(?:^|[=&\s}])\^\s*(?:\{\s*\w\s*\}|\w)\s*\Z")  # ^{0}\text{WC}
_MARKED_RELATION = regex(r"\s*\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}\s*\{\s*(?:=|\\equiv|:=)\s*\}")  # \overset{!}{=}
_NO_CLAIM = regex(
    r"[!?]|\\(?:not|times|lnot)\b|\\\w+\s*\{\s*(?:no[nt]?|pas|faux|false|wrong|never|jamais)\b", re.IGNORECASE
)
_MARKUP = regex(
    r"\\(?:text[a-z]*|math(?:rm|bf|it)|mbox|small|tiny|scriptsize|scriptstyle|rm|(?:eq)?ref\s*\{[^{}]*\}|[,;:! ])|[(){}\[\]~]"
)
_REFERENCE = regex(  # what stands above = and says why, or that it defines: nothing, def, (1), Eq. 3
    r"\s*(?:(?:def|déf|defn|notation|définition|definition|\\triangle|\\Delta|\\wedge|\\ast|\*+|△|∆|[a-z]|[ivx]+)\.?\s*"
    r"|(?:(?:eqs?|éqs?|eqn|equations?|équations?|gl|gln|formulas?|formules?|fig|figure|table|step|étape|lemma|lemme|theorem|théorème|rule|see|voir|cf|by|par|from|using|with|and|et)\b\.?\s*"
    r"|[A-Z]?\d+(?:[.–-]\d+)*[a-z]?'?\s*|,\s*)*)",
    re.IGNORECASE,
)
_TAGS = regex(r"\*?\s*\{")
_DOTS_ABOVE = regex(r"\s*\{\s*((?:(?:\.|\\cdot)\s*){1,3})\}")  # \overset{\cdot}{\theta}
_SPACE_BEFORE = regex(r"\)\s*(?:\\[,;:! ]|~|\\(?:thinspace|enspace)(?![A-Za-z])\s*)\s*\Z")
_FRAME = regex(r"\s*(?:[0-9ijkn](?:\s*[+-]\s*\d)?|[BWEGS])\s*")
_TRANSFORM_BEHIND = regex(  # with another index, before it or behind
    r"\s*(?P<script>[_^]\s*(?:\{[^{}]*\}|\w)\s*)?(?:\\(?:mathbf|mathrm|mathit|boldsymbol|bm)(?![A-Za-z])\s*\{?\s*)?[TAHR](?![A-Za-z])(?(script)|[\s}]*_)"
)
_DOTS_BEFORE = regex(r"\\[cl]?dots(?:\\[,;:! ]|\s)*\Z")
_WIDE_SPACE = regex(
    r"\\hspace\*?\s*\{\s*(?:[1-9]\d*\.?\d*\s*(?:em|cm|in)|0?\.[5-9]\d*\s*(?:cm|in)|[5-9]\s*mm|\d\d+\.?\d*\s*(?:pt|mm|ex))\s*\}"
)
_ANY_WHOLE = regex(
    r"\(\s*\w\s*(?:\\in\s*\{?\s*\\?(?:math[a-z]+|Bbb|mathds)?\s*\{?\s*\\?[ZN]\s*\}?\s*\}?(?:_0|_\{0\})?"
    r"|=\s*0\s*,\s*(?:\\pm\s*)?1\s*,\s*(?:(?:\\pm\s*)?2\s*,\s*)?(?:(?:\\pm\s*)?3\s*,\s*)?(?:\\[lcd]?dots[cbm]?|\.\.\.|…))\s*\)"
)
_REMARK = regex(r"\(\s*([ijkmn])\s*(?:=|\\in|\\geq?|\\leq?|>|<)[^()&]{1,60}\)")
_CONDITION = regex(r"\((?!\s*\\text)[^()&=]{1,60}\\neq?(?![A-Za-z])[^()&=]{1,60}\)")
_VALUE_GIVEN = r"\s*\\?[A-Za-z]+(?:_(?:\{[^{}]*\}|\w))?\s*=[^()=<>&,;]{1,40}"
_AT_VALUES = regex(rf"\(({_VALUE_GIVEN}(?:[,;]{_VALUE_GIVEN})*)\)")  # x(θ_1 = 0, θ_2 = π)
_OF_ARM = regex(r"(?<![A-Za-z\\])[pPxyzXYJTRAHw]\}?(?:[_^](?:\{[^{}]*\}|\w))*$")  # what has a value at a configuration
_DECIMAL_COMMA = regex(r",(\d+)(?!\s*,\s*\d)")
_NEXT_BAR = regex(
    r"=|\\\\|&|[<>]|\\(?:q?quad|text|leq?|geq?|approx|neq?|in|Rightarrow|Leftrightarrow|implies|iff|to)(?![A-Za-z])"
)
_BARS = regex(r"\\(?:left|right)\s*\||\\\||\|\s*_|(?P<single>\||\\vert(?![A-Za-z]))")
_BRACED_FUNCTION = regex(r"\{\s*\\?([A-Za-z]+\d?)\s*\}")
_PLAIN_UNDER_HAT = regex(
    r"[\s{]*(?:\\(?:math(?:bf|rm|it)|boldsymbol|bm)[\s{]*)?(?:[xyzXYZijknsaouweTRAHJ]|\\omega)(?![A-Za-z])"
)
_LETTER_UNDER = regex(r"[\s{]*\\?([A-Za-z]+)(?![A-Za-z])")
_ANOTHER = regex(r"\s*[{\[]")
_LETTER_ALONE = regex(r"\s*\{\s*(?:[A-Za-z]|\\(?:%s))\s*\}(?!\s*[{\[])" % one_of(sorted(LETTERS)))
_COORDINATE_UNDER_HAT = regex(r"(?:\s*\{\s*[xyXY]\s*\}|\s*[xyXY])(?!\s*[_A-Za-z])")  # x estimated, and no axis x_1
_TWO = regex(r"\s*(?:_\s*\{?\s*2\s*\}?|2)(?=[\s&]*(?:\\left|\\[bB]ig|\(|\[|\{\s*\(|\\!|\\,))")  # of atan2
_POWER_OF_UNIT = regex(r"\s*\^\s*(?:\{\s*-?\d\s*\}|\d)")
_OF_FORCE = regex(  # N and N·m, and no letter N before another factor
    r"\s*\{\s*N\s*(?:(?:\{?\\cdot(?![A-Za-z])\s*\}?|\\,|[.~])?\s*m\s*)?\}(?!\s*(?:[A-Za-z(\d_^]|\\(?:sin|cos|theta|frac|dot)))"
)
_LETTER_BEHIND = regex(r"\s+([xyzijkuvw])(?![A-Za-z])")
_STYLED_WORD = regex(r"\s*\{\s*([^\W\d_][^{}\\$]*?)\s*\}")
_FENCES = {
    ".": ".", r"\{": "{", r"\lbrace": "{", r"\}": "{", r"\rbrace": "{",
    **dict.fromkeys(("|", r"\|", r"\lvert", r"\rvert", r"\vert", r"\Vert", r"\lVert", r"\rVert"), "|"),
}  # fmt: skip
_ENDS_OPERAND = frozenset(
    ["NUMBER", "LETTER", "RPAR", "RBRACE", "SUB", "SUP", "PRIME", "END", "DOTS", "CLOSE_SET", "CLOSE_BAR", "FUNC"]
)


_MEASURED = frozenset(["NUMBER", "RBRACE", "SUP", "RPAR", "END"])  # behind which a unit may stand
_ONE_WORD = regex(r"[^\W\d_]+(?:[./·^-]?(?:[^\W\d_]+|-?\d))*\.?")
_NUMBER_ENDS = regex(
    r"(?:\s|~|\\[,;:! ])*(?:[.,;&=)}\]]|\\(?:\\|[,;:}!]|(?:q?quad|end|right|text|approx|to|tag|hfill|[A-Z]\w*arrow|iff|implies)(?![a-z]))|\Z)"
)
_NUMBERS_END = regex(  # a column or a tuple of numbers, behind which \mathrm{m} is metres
    r"\((?:[^A-Za-z\\(),]|\\[,;!: ])*(?:,(?:[^A-Za-z\\(),]|\\[,;!: ])*)+(?:\\right\s*)?\)(?:\s|~|\\[,;:! ])*\Z|\\begin\s*\{(?P<matrix>[bpvBV]?matrix|array)\}(?:\{[clr|]*\})?(?:[^A-Za-z\\]|\\[\\,;!: ]|\\(?:[td]?frac|sqrt|hfill)(?![A-Za-z]))*"
    r"\\end\s*\{(?P=matrix)\}(?:\s*\\right\s*[\])])?(?:\s*\^\s*(?:T|\{\s*(?:T|\\top)\s*\}|\\top))?(?:\s|~|\\[,;:! ])*\Z"
)
_RUN = regex(r"(?=[A-Za-z]*[aeiouy])(?=[A-Za-z]*[^aeiouyA-Z])[A-Za-z][a-z]{3,}(?![A-Za-z])")
_PART_OF_MODEL = regex(r"([A-Z]{2,4})([a-z]{3,})(?=(?:\s|&)*=)")  # MGDpos = …
_SPELT_WITHIN = regex("|".join(word for word in (*BARE_WORDS, *LONG) if len(word) > 2))
_OPENS = regex(r"\s*\{")
_BLANK_LINE = regex(r"\n[ \t]*\n")
_NEW_EQUATION = regex(r"[A-Za-z{\\^](?:[^=\n&\\+]|\\[A-Za-z]){0,40}=")
_OVER_OR_BRACE = regex(r"\\over(?![A-Za-z])|\\.|[{}]", re.DOTALL)
_FRACTION = (("LBRACE", "{"), ("FRAC", "frac"), ("LBRACE", "{"))  # {\frac{ for the brace of {a \over b}
_UNWRITTEN = frozenset(["ast", "star", "times", "bullet"])  # alone in a cell
_CLOSES = regex(r"\s*(?:\\(?:right|[Bb]igg?r?)\s*)?\)")
_CELL_ENDS = regex(r"\s*(?:&|\\\\|\\cr(?![A-Za-z])|\\end(?![A-Za-z])|\})")
_OPENS_SPACED = regex(r"\s*\{(?:(?:\s|~|\\[ ,;:!])*[A-Za-z]{2,}(?:~|\\[ ,;:!])|(?:~|\\[ ,;:!])+\s*[A-Za-z]{2})")
_FORMULA = regex(r"\$([^$]*)\$")
_RELATES = regex(r"[=<>]|\\(?:approx|[lg]eq?|neq?|in)(?![A-Za-z])")
_BROKEN_FENCE = regex(  # \left( a \right. \\ & \left. b \right): one bracket over two lines
    r"\\right\s*\.(?:\s|&|\\\\|\\(?:q?quad|nonumber|notag)(?![A-Za-z])|\\[,;:! ])*\\left\s*\."
)
_PARENTHESIS = regex(r"[\s&]*(?:\\left|\\[bB]igg?l?)?\s*\(")
_TAN_TWO = regex(r"((?:\s|~|\\[,;:! ])*)\\?tan\s*_?\s*\{?\s*2\s*\}?")
_QUANTITY = regex(r"([+-]?)(\d{1,20}(?:[.,]\d{1,20})?|[.,]\d{1,20})(?:[eE]([+-]?\d))?")
_OUTSIDE = regex(
    r"(?P<open>\{|\\begin(?![A-Za-z]))|(?P<close>\}|\\end(?![A-Za-z]))|\\[{}]|=|&|\\\\|\\(?:approx|[lg]eq?|equiv)(?![A-Za-z])|\\.",
    re.DOTALL,
)
_TAKES_ARGUMENT = frozenset(["FRAC", "PARTIAL", "SQRT", "ACCENT", "BRACE", "OVERSET", "RBRACE", "FUNC"])
_BEGINS = frozenset(["", "NEWLINE", "AMP", "SEP", "COMMA", "CONN", "TEXT", "LBRACE", "BEGIN", "OPEN_EMPTY"])
_BEFORE_OPERAND = frozenset(["CDOT", "TIMES", "SLASH", "PLUS", "MINUS"])
_RELATION_NEXT = regex(r"(?:\s|\\[,;:! ]|&|:)*(?:=|\\(?:approx|equiv|[lg]eq?|simeq|triangleq)(?![A-Za-z]))")
_BEHIND_OPERAND = regex(r"\s*(?:[_^/*]|\+(?!\s*\\)|\\(?:times|cdot)(?![A-Za-z]))")


_PERIOD = regex(
    r"(?P<whole>\d{1,12})(?:\.|\{,\})(?P<fixed>\d{0,12})\s*\\(?:overline|bar|dot)\s*(?:\{\s*(?P<period>\d{1,12})\s*\}|(?P<one>\d))"
)


def _decimal(number: re.Match[str]) -> str:
    """Return the digits of a quantity such as 1.5e-3, its sign apart."""
    value = Decimal(number[2].replace(",", ".")).scaleb(int(number[3] or 0))
    return f"{value:f}"


_SCRIPT = r"\s*(?:\{[^{}]*\}|\w)\s*"
PRE_SCRIPTS = regex(
    rf"(?<![A-Za-z}}])(\{{\s*\}}\s*)([_^])({_SCRIPT})([_^])(?=({_SCRIPT})\{{*\s*(?:\\[a-z]+\s*\{{?\s*)?[A-Za-z])"
)


@dataclass(frozen=True)
class Spelling:
    """How a document spells: its names of several letters, letters that it tells apart, its decimal comma, its {}_0^1T."""

    words: frozenset[str] = frozenset()
    told_apart: frozenset[str] = frozenset()
    decimal_comma: bool = False
    variables: str = ""  # "both" where it has q_i beside θ_i, "told" where it says what θ_i is by q_i
    angle: str = "theta"  # what c_1 is the cosine of where there is no arm: q_1, where it has no θ_1
    sums: tuple[tuple[str, tuple[int, ...]], ...] = ()  # digits of θ_{34} = θ_3 - θ_4 → the signs that it says
    masses: frozenset[str] = frozenset()  # m_1, I_1, l_{c1} and g of a document that speaks of masses
    letters: frozenset[str] = frozenset()  # S and C that it gives a meaning: S(…) is a product
    reference_below: bool = False  # {}_0^1T is the pose of frame 1 in frame 0
    lengths: frozenset[str] = frozenset()  # p_1 of p_1 cos θ_1: p_1^2 is its square, and no point seen from frame 2
    screws: frozenset[str] = frozenset()  # the letters of twists in exponents: S of e^{[S_1]θ_1}, xi where it has a hat
    unit: str = ""  # mm or cm, in which it calculates: behind a number it says no more than m does in metres
    indices: frozenset[str] = frozenset()  # of θ, q, c and s, the first of several
    normals: str = "noa"  # its letters of the columns of the tool's rotation
    dressed: frozenset[str] = frozenset()  # letters that their dress tells from the plain one: cal D of \mathcal D
    starred: frozenset[str] = frozenset()  # the keys of names that a star tells from the plain one: l_2 of l_2^* = 2
    of_two: frozenset[str] = frozenset()  # subscripts of a J that it multiplies to ω and to another velocity: a of J_a
    loads: frozenset[str] = frozenset()  # the components of forces and moments that it writes anywhere: F_x, M_z, or M
    columns: frozenset[str] = frozenset()  # the keys of what it says to be the columns of J: J_1, J_2
    moving: frozenset[str] = frozenset()  # the letters whose rates it prints: alpha, where it has \\dot\\alpha
    of_quaternion: bool = False  # whether q_1 is the component of a quaternion, beside q_0
    scalars: frozenset[str] = frozenset()  # the keys of letters that its text calls a length, a weight or a moment: L
    moments: frozenset[str] = frozenset()  # those that it calls a moment
    first_solid: str = ""  # the smallest of the numbers that it gives solids, V_{B,2/0}: that of the base

    def joint_signs(self, digits: str) -> tuple[int, ...]:
        """Return the signs of the angles that the digits of c_{34} add: as the document says, else all are positive."""
        return dict(self.sums).get(digits, (1,) * len(digits))


def _turned(found: re.Match[str]) -> str:
    """Return scripts before a letter with the one below above, and the other way round."""
    empty, one, script, other = found.groups()[:4]
    return f"{empty}{other}{script}{one}" if one != other else found[0]


class _Scanner:
    """One pass over a display: the state that a token's meaning may depend on."""

    def __init__(self, text: str, spelling: Spelling) -> None:
        text = _BROKEN_FENCE.sub(lambda found: " " * len(found.group()), text) if "\\right" in text else text
        self.text = PRE_SCRIPTS.sub(_turned, text) if spelling.reference_below else text
        self.words = spelling.words
        self.spelling = spelling
        self.accent = ""  # that the next letter carries
        self.lists = 0  # the brackets that are open: a comma in them sets entries off
        self.fences: list[str] = []
        self.transparent_braces: set[int] = set()
        self.depth = 0
        self.before = self.previous = ""
        self.bar_open = self.double_bar = False  # |x|, ||x||
        self.member: tuple[int, list[int]] = -1, []  # where the member of the last bar ends, and its single bars
        self.plain_ends: dict[int, str] = {}  # where \matrix{…} and {… \over …} end, and what they are
        self.sentences: list[int] = []  # the ends of the \\text{…} in whose formulas we are

    def token(self, kind: str, value: str, start: int, end: int) -> Token:
        self.before, self.previous = self.previous, kind
        self.lists += (kind in ("LPAR", "OPEN_SET", "OPEN_EMPTY")) - (kind in ("RPAR", "CLOSE_SET", "CLOSE_EMPTY"))
        if kind == "LETTER" and self.accent:
            value, self.accent = f"{self.accent} {value}", ""
        return Token(kind, value, start_pos=start, end_pos=end)

    def scan(self) -> Iterator[Token]:
        text, position, count = self.text, 0, 0
        match = _MASTER.match
        while position < len(text):
            found = match(text, position)
            if found is None:  # the last alternative takes any character
                raise ReadError(say(Kind.CANNOT_READ, text=text[position]), position)
            kind = found.lastgroup or ""
            # the inner groups of BEGIN and END would hide the outer name
            if found.group("BEGIN"):
                kind = "BEGIN"
            elif found.group("END"):
                kind = "END"
            if kind in ("SPACE", "TAG"):
                if _WIDE_SPACE.match(found.group()) or self._begins_anew(found):
                    yield self.token("SEP", "\\quad", position, found.end())
                position = found.end()
                continue
            handler = getattr(self, "on_" + kind.lower())
            tokens, position = handler(found.group(kind), position, found.end())
            count += len(tokens)
            if count > MAX_TOKENS:
                raise ReadError(say(Kind.TOO_MANY_TOKENS, most=MAX_TOKENS), position)
            yield from tokens

    def _begins_anew(self, blank: re.Match[str]) -> bool:
        """Whether a blank line stands between two equations."""
        outside = self.depth == 0 and not self.fences and self.previous in _ENDS_OPERAND
        return outside and bool(_BLANK_LINE.search(blank.group()) and _NEW_EQUATION.match(self.text, blank.end()))

    # Each handler returns the tokens and where to go on.

    def on_newline(self, _value: str, start: int, end: int) -> tuple[list[Token], int]:
        return [self.token("NEWLINE", r"\\", start, end)], end

    def on_begin(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        name = value.partition("{")[2].rstrip("}").strip().rstrip("*")
        if name in TRANSPARENT:
            return [], end
        if name not in MATRICES and name not in LAYOUTS:
            known = ", ".join(sorted(MATRICES | LAYOUTS))
            raise ReadError(say(Kind.UNKNOWN_ENVIRONMENT, name=name, known=known), start)
        end = self._skip_arguments(end, braces=name in ("array", "alignat", "alignedat"))
        self._deeper(start)
        return [self.token("BEGIN", name, start, end)], end

    def on_end(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        name = value.partition("{")[2].rstrip("}").strip().rstrip("*")
        if name in TRANSPARENT:
            return [], end
        self.depth -= 1
        return [self.token("END", name, start, end)], end

    def _skip_arguments(self, position: int, *, braces: bool) -> int:
        """Skip `[t]` and, where the environment has one, the `{cc|c}` column specification."""
        option = re.compile(r"\s*\[[tbclrTBCLR]\]").match(self.text, position)
        position = option.end() if option else position
        if braces:
            specification = re.compile(r"\s*\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}").match(self.text, position)
            position = specification.end() if specification else position
        return position

    def _deeper(self, position: int) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise ReadError(say(Kind.NESTED_DEEPER, most=MAX_DEPTH), position)

    def on_script(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        argument, end = self._script_argument(start, end)
        kind = "SUB" if value == "_" else "SUP"
        primes = argument.replace("\\prime", "'").replace(" ", "")
        if kind == "SUP" and set(primes) == {"'"}:
            return [self.token("PRIME", "'", start, end)] * len(primes), end
        of_next = _DOTS_BEFORE.search(self.text, max(start - 20, 0), start)  # \cdots _3^2T: those of the letter behind
        of_next = of_next or (  # T_1(q_1)\;^1T_2: a blank has no scripts
            _FRAME.fullmatch(argument)
            and _TRANSFORM_BEHIND.match(self.text, end)
            and _SPACE_BEFORE.search(self.text, max(start - 20, 0), start)
        )
        before = [self.token("PRE", "{}", start, start)] if of_next else []
        return [*before, self.token(kind, argument, start, end)], end

    def _script_argument(self, start: int, position: int) -> tuple[str, int]:
        text = self.text
        while position < len(text) and text[position].isspace():
            position += 1
        if position >= len(text):
            raise ReadError(say(Kind.NO_SCRIPT_AT_END, text=text[start]), start)
        if text[position] == "{":
            close = self._matching_brace(position)
            return text[position + 1 : close], close + 1
        if text[position] == "\\":
            macro = re.compile(r"\\(?:[A-Za-z]+|.)", re.DOTALL).match(text, position)
            if macro is None:
                raise ReadError(say(Kind.NO_SCRIPT, text=text[start]), start)
            end = macro.end()
            if re.fullmatch(r"\\(?:%s)" % STYLES, macro.group()) and text[end : end + 1] == "{":
                end = self._matching_brace(end) + 1
            return text[position:end], end
        digits = re.compile(r"\d+" if text[start] == "_" else r"\d").match(text, position)
        if digits:
            return digits.group(), digits.end()
        return text[position], position + 1

    def _matching_brace(self, position: int) -> int:
        depth = 0
        for index in range(position, len(self.text)):
            character = self.text[index]
            if character == "{" and self.text[index - 1 : index] != "\\":
                depth += 1
                if depth > MAX_DEPTH:
                    raise ReadError(say(Kind.NESTED_DEEPER, most=MAX_DEPTH), index)
            elif character == "}" and self.text[index - 1 : index] != "\\":
                depth -= 1
                if depth == 0:
                    return index
        raise ReadError(say(Kind.BRACE_OPEN), position)

    def _over(self, start: int) -> bool:
        r"""Whether a brace holds a fraction of plain TeX, {a \over b}; its bar and its end are kept."""
        if "\\over" not in self.text:
            return False
        close, depth = self._matching_brace(start), 0
        for found in _OVER_OR_BRACE.finditer(self.text, start + 1, close):
            depth += {"{": 1, "}": -1}.get(found.group(), 0)
            if depth == 0 and found.group() == "\\over":
                self.plain_ends |= {found.start(): "over", close: "over"}
                return True
        return False

    def _plain_end(self, start: int, end: int) -> list[Token]:
        """Return the tokens that end a matrix or a fraction of plain TeX."""
        self.depth -= 1
        if (name := self.plain_ends[start]) == "struck":
            return [self.token("RBRACE", "}", start, end), self.token("SUP", f"{UNIT}{UNKNOWN}", start, end)]
        if name != "over":
            return [self.token("END", name, start, end)]
        return [self.token("RBRACE", "}", start, end), self.token("RBRACE", "}", start, end)]

    def _holds_equations(self, start: int) -> bool:
        """Whether a brace is but put round equations, and holds no part of one."""
        try:
            close = self._matching_brace(start)
        except ReadError:
            return False
        if re.compile(r"\s*[_^]").match(self.text, close + 1):
            return False
        depth = 0
        for found in _OUTSIDE.finditer(self.text, start + 1, close):
            if found["open"] or found["close"]:
                depth += 1 if found["open"] else -1
            elif depth == 0:
                return True
        return False

    def on_number(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        if self.previous == "FRAC" and len(value) > 1 and value.isdigit():  # \frac12 is one half
            return [self.token("NUMBER", value[k], start + k, start + k + 1) for k in (0, 1)], start + 2
        if self.before == "FRAC" and self.previous == "LETTER" and len(value) > 1 and value[0].isdigit():
            return [self.token("NUMBER", value[0], start, start + 1)], start + 1  # \frac r23 is 3 halves of r
        if (period := _PERIOD.match(self.text, start)) and self.previous != "FRAC":
            return self._periodic(period), period.end()
        comma = _DECIMAL_COMMA.match(self.text, end)
        if comma and self.previous != "COMMA" and self.previous != "FRAC" and value.isdigit() and not self.lists:
            mark = "." if self.spelling.decimal_comma else ","
            return [self.token("NUMBER", f"{value}{mark}{comma.group(1)}", start, comma.end())], comma.end()
        return [self.token("NUMBER", value, start, end)], end

    def _periodic(self, found: re.Match[str]) -> list[Token]:
        r"""Return 0.1\overline{6} as the fraction that it is."""
        period = found["period"] or found["one"]
        fixed = found["whole"] + found["fixed"]
        above = int(fixed + period) - int(fixed)
        below = (10 ** len(period) - 1) * 10 ** len(found["fixed"])
        parts = [
            ("FRAC", "\\frac"),
            *(
                ("LBRACE", "{"),
                ("NUMBER", str(above)),
                ("RBRACE", "}"),
                ("LBRACE", "{"),
                ("NUMBER", str(below)),
                ("RBRACE", "}"),
            ),
        ]
        return [self.token(kind, value, *found.span()) for kind, value in parts]

    def on_bracespace(self, _value: str, start: int, end: int) -> tuple[list[Token], int]:
        """`{}` carries pre-scripts where scripts follow; elsewhere it prints nothing."""
        if re.compile(r"(?:\s|\\!)*[_^]").match(self.text, end):
            return [self.token("PRE", "{}", start, end)], end
        if self.previous in ("FRAC", "SQRT", "ACCENT", "BRACE", "OVERSET"):  # an argument
            return [self.token("LBRACE", "{", start, start + 1), self.token("RBRACE", "}", end - 1, end)], end
        return [], end

    def on_fence(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        opening, mark = value.startswith("\\left"), re.sub(r"\\(?:left|right)\s*", "", value, count=1)
        sort = _FENCES.get(mark, "(")
        if opening:
            self.fences.append(sort)
            kind = {".": "OPEN_EMPTY", "{": "OPEN_EMPTY", "|": "OPEN_BAR", "(": "LPAR"}[sort]
        else:
            opened = self.fences.pop() if self.fences else sort
            kind = {"|": "CLOSE_BAR", "(": "RPAR"}.get(opened if sort == "." else sort, "CLOSE_EMPTY")
            kind = "CLOSE_EMPTY" if opened in ".{" else kind
        if mark == "\\rangle":  # ⟨x⟩, the mean of x, or a form of two: nobody knows its value
            return [self.token("RPAR", ")", start, end), self.token("SUP", f"{UNIT}{UNKNOWN}", start, end)], end
        shown = {"{": "{" if opening else "}", "|": "|"}.get(sort, mark)
        return [self.token(kind, shown, start, end)], end

    def on_macro(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        name = value[1:]
        if re.fullmatch(STYLES, name):
            return self._style(name, start, end)
        if name in ("left", "right"):
            raise ReadError(say(Kind.NO_DELIMITER, name=name), start)
        if name in ("overset", "stackrel", "underset") and (marked := _MARKED_RELATION.match(self.text, end)):
            mark = marked[1].strip()
            is_claim = _NO_CLAIM.match(mark) is None and _REFERENCE.fullmatch(_MARKUP.sub(" ", mark)) is not None
            return [self.token("REL", "=" if is_claim else ASKED, start, marked.end())], marked.end()
        if name in ("overset", "stackrel") and (dots := _DOTS_ABOVE.match(self.text, end)):
            count = len(re.findall(r"\.|cdot", dots[1]))
            return [self.token("ACCENT", "d" * count + "ot", start, dots.end())], dots.end()
        if name == "checkmark":
            return [], end
        if name in ("degree", "textdegree"):
            return [self.token("SUP", "\\circ", start, end)], end
        if name in STRIKES and (brace := _OPENS.match(self.text, end)):
            self.plain_ends[self._matching_brace(brace.end() - 1)] = "struck"
            self._deeper(start)
            return [self.token("LBRACE", "{", start, brace.end())], brace.end()
        if name == "tag" and (brace := _TAGS.match(self.text, end)):
            return self._tag(brace.end() - 1, start)
        if name == "textcolor":
            colour = re.compile(r"\s*\{[^{}]*\}").match(self.text, end)
            return [], colour.end() if colour else end
        if name == "operatornamewithlimits":
            return self._style("operatorname", start, end)
        if name in ("ref", "eqref", "cite", "autoref") and (of := re.compile(r"\s*\{[^{}]*\}").match(self.text, end)):
            return [self.token("TEXT", name, start, of.end())], of.end()
        if name in QUANTITIES:
            return self._quantity(name, start, end)
        if name == "angle":  # \angle ABC is one name
            of = re.compile(r"\s*\{?\s*([A-Z]{1,3})\s*\}?(?![_^A-Za-z])").match(self.text, end)
            after = of.end() if of else end
            return [self.token("LETTER", f"angle{of[1] if of else ''}", start, after)], after
        if name == "sqrt":
            return self._function(name, start, end)
        if name in ("matrix", "pmatrix") and (brace := _OPENS.match(self.text, end)):
            self.plain_ends[self._matching_brace(brace.end() - 1)] = name
            self._deeper(start)
            return [self.token("BEGIN", name, start, brace.end())], brace.end()
        if name == "over" and start in self.plain_ends:
            return [self.token("RBRACE", "}", start, end), self.token("LBRACE", "{", start, end)], end
        if name in _UNWRITTEN and self._fills_cell(end):
            return self._unwritten(start, end)
        if name in COMMANDS:
            kind = COMMANDS[name]
            is_cell = self.previous in _BEGINS and _CELL_ENDS.match(self.text, end)
            if name == "cdot" and (is_cell or (self.previous == "LPAR" and _CLOSES.match(self.text, end))):
                kind = "DOTS"  # one of the dots of a matrix, or what stands for an argument: arccos(·)
            if kind == "BAR":
                return self._bar(start, end)
            if kind == "LETTER":
                return self._letter(name, start, end)
            return [self.token(kind, name, start, end)], end
        if name in FUNCTIONS:
            return self._function(name, start, end)
        if name in LETTERS:
            return self._letter(self._variant(name), start, end)
        if name in RELATIONS:
            return [self.token("REL", RELATIONS[name], start, end)], end
        if name in CONNECTIVES:
            return [self.token("CONN", CONNECTIVES[name], start, end)], end
        if name == PER_CENT and self.previous in _MEASURED:
            return [self.token("SUP", f"{UNIT}{name}", start, end)], end
        if name in PUNCTUATION:
            return [self.token("TEXT", name, start, end)], end
        if name not in NO_LETTERS and _LETTER_ALONE.match(self.text, end):
            self.accent = name  # \est{q}, of a macro that nobody defines: a letter of its own
            return [], end
        raise ReadError(say(Kind.UNKNOWN_COMMAND, command=value), start)

    def _tag(self, brace: int, start: int) -> tuple[list[Token], int]:
        r"""Pass over a tag, \tag{2-15}; an equation and several words in it are read as behind a wide space."""
        close = self._matching_brace(brace)
        content = self.text[brace + 1 : close]
        separator = self.token("SEP", "\\quad", start, brace)
        if "$" in content or re.search(r"[^\W\d_]{2,}\s+[^\W\d_]{2,}", content):
            self.sentences.append(close)
            tokens, position = self._sentence_from(brace + 1, start)
            return [separator, *tokens], position
        if _RELATES.search(content):
            self.transparent_braces.add(close)
            return [separator], brace + 1
        return [], close + 1

    def _style(self, name: str, start: int, end: int) -> tuple[list[Token], int]:
        """`\\mathbf{J}` is J; `\\text{Atan2}` a function; `\\mathrm{tool}` a name; `\\text{if } x` words."""
        if name in OF_CLASSES and self._takes_several(end):  # \mat{T}{0}{1}: a macro of the author's own
            raise ReadError(say(Kind.UNKNOWN_COMMAND, command=f"\\{name}"), start)
        if name in ("boxed", "fbox", "ensuremath"):
            brace = self.text.find("{", end)
            if brace >= 0 and not self.text[end:brace].strip():
                self.transparent_braces.add(self._matching_brace(brace))
                return [], brace + 1
        unit = _OF_FORCE.match(self.text, end) if self.previous in ("NUMBER", "END") else None
        if unit is not None:
            return [], unit.end()
        self.accent = self._accent(name, end)
        word = _STYLED_WORD.match(self.text, end)
        if name in ARROWS and (letter := _LETTER_BEHIND.match(self.text, end)) is not None:
            return self._letter(letter[1], start, letter.end())  # \\vec x_1 keeps its arrow
        if word is None:
            words = (_OPENS if name in WORD_STYLES else _OPENS_SPACED).match(self.text, end)
            return self._sentence(start, self.text.index("{", end)) if words else ([], end)
        content, after = word.group(1), word.end()
        if name in ("mathrm", "text", "operatorname") and (
            (spelt := re.sub(r"[\s~]|\\[,;!: ]", "", content)) in FUNCTIONS or (" " in content and read_unit(spelt))
        ):
            content = spelt  # \mathrm{a t a n 2}, taken apart by a reader of images
        if self.previous in _MEASURED and content not in self.words and (measure := self._unit(name, content, after)):
            is_letter = content in ("m", "s") and self.previous != "NUMBER"
            if is_letter and not (
                content == "m" and name in (*WORD_STYLES, "mathrm") and _NUMBERS_END.search(self.text, 0, start)
            ):
                return [], end
            mark = mark_of(measure[0], self.spelling.unit)
            return ([self.token("SUP", mark, start, measure[1])] if mark else []), measure[1]
        if content in FUNCTIONS:
            return self._function(content, start, after)
        if content in LETTERS:
            return self._letter(self._variant(content), start, after)
        if name in WORD_STYLES and content not in self.words:
            if len(content) == 1 and content.isascii() and content != "a":
                return self._letter(content, start, after)
            if re.fullmatch(r"[a-zA-Z]_?\d+", content):
                return [], end
            return self._words(content, start, after)
        if re.search(r"[^\W\d_]{2,}\s|\s[^\W\d_]{2,}", content):
            return self._words(content, start, after)
        over_several = len(content) > 1 and name in ("vec", "overline", "bar", "hat")
        if re.fullmatch(r"[A-Za-z]+", content) and not over_several:
            return self._letter(content, start, after)
        return [], end

    def _takes_several(self, end: int) -> bool:
        """Whether a macro has another argument behind its first."""
        brace = _OPENS.match(self.text, end)
        return brace is not None and bool(_ANOTHER.match(self.text, self._matching_brace(brace.end() - 1) + 1))

    def _unit(self, style: str, content: str, after: int) -> tuple[str, int] | None:
        """Return the unit that a styled word behind a number is, with its power, and where it ends; None of another word.

        A word alone behind a number, of which nobody knows what it is, makes of it a number of nobody knows what.
        """
        power = _POWER_OF_UNIT.match(self.text, after)  # 5 m^2 is no square of 5, and 2 s^{-1} no half
        unit, end = (content + re.sub(r"[\s{}]", "", power.group()), power.end()) if power else (content, after)
        if content != "N" and read_unit(content) is not None:
            return unit, end
        first = re.match(r"[^\W\d_]+(?= [^\W\d_])", content)
        is_beside = first is not None and len(first[0]) > 1 and read_unit(first[0]) is not None  # 5 \text{ mm squared}
        words = {word.strip(".,;:").lower() for word in content.split()}
        alone = _ONE_WORD.fullmatch(content) and style in WORD_STYLES and self.previous == "NUMBER"
        if (is_beside and not words & JOINING) or (
            alone and not words & NO_UNITS and _NUMBER_ENDS.match(self.text, end)
        ):
            return f"{UNKNOWN}{unit}", end
        return None

    def _words(self, content: str, start: int, after: int) -> tuple[list[Token], int]:
        """Words are no product: a name where they stand as an operand does, else what is said between equations."""
        name = re.sub(r"[\W\d_]+", "", content)
        joins = {word.lower() for word in content.split()} & JOINING or not name
        is_term = self.previous in _BEFORE_OPERAND  # … + \text{const}: of whatever value, but a term
        joins = joins or (name.lower() in SAID_OF_VALUES and not is_term)
        begins = self.previous in _BEGINS or _SCRIPT_BEFORE.search(self.text, max(0, start - 12), start)
        heads = begins and _RELATION_NEXT.match(self.text, after)
        closing = {"LBRACE": "}", "LPAR": ")"}.get(self.previous, " ")  # in a fraction, in cos(…)
        alone = self.text[after : after + 1] == closing and (closing == "}" or self.before == "FUNC")
        if not joins and (
            heads or alone or self.previous in _BEFORE_OPERAND or _BEHIND_OPERAND.match(self.text, after)
        ):
            return [self.token("LETTER", name, start, after)], after
        return [self.token("TEXT", content, start, after)], after

    def _sentence(self, start: int, brace: int) -> tuple[list[Token], int]:
        r"""Return the words of \text{where $D > 0$}, up to an equation in them; what holds no word is a formula."""
        close = self._matching_brace(brace)
        content = self.text[brace + 1 : close]
        if not content.strip(" .,;:()"):
            return [], close + 1
        if "$" not in content and not re.search(r"[^\W\d_]{2}", re.sub(r"\\[A-Za-z]+", "", content)):
            return [], brace
        self.sentences.append(close)
        return self._sentence_from(brace + 1, start)

    def _sentence_from(self, position: int, start: int) -> tuple[list[Token], int]:
        """Return the words of a sentence from a place on, up to its next equation or to its end."""
        close = self.sentences[-1]
        equation = next((f for f in _FORMULA.finditer(self.text, position, close) if _RELATES.search(f[1])), None)
        if equation is None:
            self.sentences.pop()
        end = equation.start() if equation else close
        words = self.text[position:end].strip()
        return [self.token("TEXT", words, start, end)] if words.strip(" .,;:()") else [], end + 1

    def _quantity(self, name: str, start: int, end: int) -> tuple[list[Token], int]:
        r"""Return the number of \SI{500}{\milli\metre}, \qty, \num and \ang, with its unit as \text{mm} would be."""
        count = 1 if name in ("ang", "num", "si", "unit") else 2
        found = re.compile(r"(?:\s*\[[^][]{0,80}\])?" + r"\s*\{([^{}]{0,80})\}" * count).match(self.text, end)
        number = _QUANTITY.fullmatch("1" if name in ("si", "unit") else found[1].replace(" ", "")) if found else None
        if found is None or number is None:
            raise ReadError(say(Kind.CANNOT_READ, text=self.text[start:end]), start)
        places = (start, found.end())
        tokens = [] if name in ("si", "unit") else [self.token("NUMBER", _decimal(number), *places)]
        if number[1] == "-":
            tokens = [
                self.token("LPAR", "(", *places),
                self.token("MINUS", "-", *places),
                *tokens,
                self.token("RPAR", ")", *places),
            ]
        unit = re.sub(r"\\([A-Za-z]+)", lambda word: UNIT_NAMES.get(word[1], f"{word[1]}."), found[count])
        if name == "num" or not unit.strip():
            return tokens, found.end()
        mark = "\\circ" if name == "ang" else mark_of(unit, self.spelling.unit)
        return [*tokens, *([self.token("SUP", mark, *places)] if mark else [])], found.end()

    def _accent(self, name: str, end: int) -> str:
        """The accent that makes another name of a letter: a bar, a tilde, a hat but for that of a unit vector or a matrix.

        A dress does so where the document has the letter in others, too.
        """
        if name in DRESSES and self.spelling.dressed and (letter := _LETTER_UNDER.match(self.text, end)):
            dressed = f"{DRESSES[name]} {letter[1]}"
            if dressed in self.spelling.dressed:
                return DRESSES[name]
        accent = ACCENTS.get(name, "")
        is_plain = _PLAIN_UNDER_HAT.match(self.text, end) and not _COORDINATE_UNDER_HAT.match(self.text, end)
        return "" if accent == "hat" and is_plain else accent

    def _variant(self, name: str) -> str:
        return name if name in self.spelling.told_apart else VARIANTS.get(name, name)

    def _function(self, name: str, start: int, end: int) -> tuple[list[Token], int]:
        function = FUNCTIONS[name]
        if name == "sqrt" and _PARENTHESIS.match(self.text, end):  # \sqrt(…) is meant as a call
            return [self.token("FUNC", "sqrt", start, end)], end
        if function == "atan" and (two := _TWO.match(self.text, end)):
            return [self.token("FUNC", "atan2", start, two.end())], two.end()
        return [self.token("SQRT" if name == "sqrt" else "FUNC", function, start, end)], end

    def _letter(self, base: str, start: int, end: int) -> tuple[list[Token], int]:
        """A letter glued to digits is an indexed name: C12, l1, q3."""
        if (
            base in ("a", "A")
            and (two := _TAN_TWO.match(self.text, end))
            and (two[1] == "" or self._has_two(two.end()))
        ):
            return [self.token("FUNC", "atan2", start, two.end())], two.end()
        is_argument = self.previous == "FRAC"  # \frac\theta2 is a half of θ
        letter = self.token("LETTER", base, start, end)
        digits = re.compile(r"\d+(?!\.?\d)").match(self.text, end) if base != "pi" and not is_argument else None
        if digits is None:
            return [letter], end
        return [letter, self.token("SUB", digits.group(), end, digits.end())], digits.end()

    def _has_two(self, position: int) -> bool:
        """Whether two arguments in parentheses stand at a place: a \\tan 2(m, n) is atan2, a \\tan 2(m + n) a product."""
        opened = _PARENTHESIS.match(self.text, position)
        depth = 1
        for found in re.compile(r"[](){}[]|,").finditer(self.text, opened.end()) if opened else ():
            if found.group() == ",":
                if depth == 1:
                    return True
                continue
            depth += 1 if found.group() in "([{" else -1
            if depth == 0:
                break
        return False

    def on_bare(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        word = max(value, self._known_word(start), key=len)
        if word == value and value in BARE_JOINING:
            return [self.token("TEXT", value, start, end)], end
        if value in FUNCTIONS and word == value and value not in self.words:
            return self._function(value, start, end)
        return self._letter(word, start, start + len(word))

    def _known_word(self, start: int) -> str:
        return next((w for w in sorted(self.words, key=len, reverse=True) if self.text.startswith(w, start)), "")

    def on_letter(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        word = self._known_word(start) or value
        part = _PART_OF_MODEL.match(self.text, start) if word == value and self.previous in _BEGINS else None
        if part and not _SPELT_WITHIN.search(part.group()):
            middle, end = part.end(1), part.end()
            return [self.token("LETTER", part[1], start, middle), self.token("SUB", part[2], middle, end)], end
        run = (
            _RUN.match(self.text, start) if len(word) == 1 and self.text[start - 1 : start].isalpha() is False else None
        )
        if run and not _SPELT_WITHIN.search(run.group()):  # a word is no product of its letters
            return [self.token("LETTER", run.group(), start, run.end())], run.end()
        return self._letter(word, start, start + len(word))

    def on_assign(self, _value: str, start: int, end: int) -> tuple[list[Token], int]:
        return [self.token("REL", "=", start, end)], end

    def _bar(self, start: int, end: int) -> tuple[list[Token], int]:
        script = re.compile(r"\s*_").match(self.text, end)
        if script and self.previous in _ENDS_OPERAND and not self.bar_open:
            argument, end = self._script_argument(script.end() - 1, script.end())  # J|_{θ_2 = 0}
            return [self.token("AT", argument, start, end)], end
        opening = not self.bar_open and (self.previous not in _ENDS_OPERAND or self._has_partner(start, end))
        if not opening and not self.bar_open:
            return [self.token("TEXT", "|", start, end)], end
        self.bar_open = opening
        return [self.token("OPEN_BAR" if opening else "CLOSE_BAR", "|", start, end)], end

    def _has_partner(self, start: int, end: int) -> bool:
        """Whether a bar behind a factor opens: one more follows in the same member, as in l_1 |s_2|."""
        if self.text.startswith("\\mid", start):
            return False
        edge, bars = self._rest_of_member(end)
        for double in ("||", "\\|", "‖"):
            if self.text.startswith(double, start):
                return self.text.count(double, end, edge) % 2 == 1
        return (len(bars) - bisect_left(bars, end)) % 2 == 1

    def _rest_of_member(self, start: int) -> tuple[int, list[int]]:
        """Return where the member that stands here ends, and the places of its single bars; each member is searched once."""
        if start > self.member[0]:
            found = _NEXT_BAR.search(self.text, start)
            edge = found.start() if found else len(self.text)
            self.member = edge, [bar.start() for bar in _BARS.finditer(self.text, start, edge) if bar["single"]]
        return self.member

    def _ranges_over_all(self, remark: re.Match[str]) -> bool:
        """Whether a remark says that a whole number is any, k ∈ ℤ; one that is the index of a law may range as it will."""
        letter = remark[1]
        multiplies = re.compile(
            rf"(?<![A-Za-z\\_^{{]){letter}\s*(?:\\[,;:! ]\s*|\\cdot\s*)?(?:\\?pi(?![A-Za-z])|π|\\[td]?frac|\d)|\\pi\s*{letter}(?![A-Za-z])"
        )
        return (
            multiplies.search(self.text, 0, remark.start()) is None or _ANY_WHOLE.fullmatch(remark.group()) is not None
        )

    def _fills_cell(self, end: int) -> bool:
        """Whether what ends here stands in a cell of a matrix alone."""
        return self.previous in ("AMP", "NEWLINE", "BEGIN") and _CELL_ENDS.match(self.text, end) is not None

    def _unwritten(self, start: int, end: int) -> tuple[list[Token], int]:
        """A mark for an entry that its author does not write: a name that is met nowhere else."""
        return [self.token("LETTER", UNWRITTEN, start, end), self.token("SUB", str(start), end, end)], end

    def on_char(self, value: str, start: int, end: int) -> tuple[list[Token], int]:
        if value in "|‖":
            doubled = self.text.startswith("||", start) and self.double_bar == self.bar_open
            tokens, end = self._bar(start, end + doubled)
            self.double_bar = self.bar_open and doubled
            return tokens, end
        if value == "}" and start in self.plain_ends:
            return self._plain_end(start, end), end
        if value == "$" and self.sentences:
            return self._sentence_from(end, start)
        if value == "\u200b" or start in self.transparent_braces:
            return [], end
        if value == "&" and self.previous == "FUNC" and _PARENTHESIS.match(self.text, end):  # Atan2 & (y, x)
            return [], end
        if value in "?*" and self._fills_cell(end):
            return self._unwritten(start, end)
        kind = CHARACTERS.get(value)
        if kind is None:
            raise ReadError(say(Kind.CANNOT_READ, text=value), start)
        if kind == "LBRACE":
            if scripts := _BRACED_SCRIPTS.match(self.text, start):  # {^{i-1}}T and {_6^0}T
                self.transparent_braces.add(scripts.end() - 1)
                return [self.token("PRE", "{}", start, start + 1)], start + 1
            word = _BRACED_FUNCTION.match(self.text, start)
            if word and word.group(1) in FUNCTIONS and len(word.group(1)) > 2:
                return self._function(word.group(1), start, word.end())
            if self._over(start):
                self._deeper(start)
                return [self.token(kind, value, start, end) for kind, value in _FRACTION], end
            is_argument = self.previous in _TAKES_ARGUMENT or self.before == "FRAC"  # \frac{…} and \frac1{…}
            operator = _BRACED_OPERATOR.match(self.text, start)
            if not is_argument and (operator or self._holds_equations(start)):
                self.transparent_braces.add(self._matching_brace(start))
                return [], end
            self._deeper(start)
        elif kind in ("RBRACE", "RPAR"):
            self.depth -= 1
        elif kind == "LPAR":
            if value == "(" and (remark := _REMARK.match(self.text, start)):  # (i = 1, …, n)
                kind = "TEXT" if self._ranges_over_all(remark) else "UNREAD"
                return [self.token(kind, remark.group(), start, remark.end())], remark.end()
            given = _AT_VALUES.match(self.text, start) if value == "(" else None
            if given and _OF_ARM.search(self.text, 0, start):
                return [self.token("AT", given[1], start, given.end())], given.end()
            if value == "(" and (condition := given or _CONDITION.match(self.text, start)):  # (s_2 ≠ 0), (θ_2 = 0)
                self.transparent_braces.add(condition.end() - 1)
                return [self.token("TEXT", "if", start, end)], end
            self._deeper(start)
        elif kind in ("DOT", "STAR"):
            is_product = kind == "STAR" or (self.previous in _ENDS_OPERAND and _FACTOR.match(self.text, end))
            return ([self.token("CDOT", value, start, end)] if is_product else []), end  # else a full stop
        return [self.token(kind, RELATIONS.get(value, value), start, end)], end


_VARIANT = regex(r"\\var(?=%s)" % one_of(VARIANTS.values()))


@lru_cache(maxsize=4096)
def canonical_script(text: str) -> str:
    """Return a script's text without styles, braces, spaces and backslashes: `{\\text{tool}}` → `tool`.

    `\\theta_{1}` → `theta_1`, `i-1` → `i-1`, `0, G` → `0,G`, `*` → ``.
    """
    text = re.sub(r"\\(?:%s)(?![A-Za-z])" % STYLES, "", text)
    text = re.sub(r"\\[,;:!> ]|[{}\s$~]|\\left|\\right|\\quad", "", text)
    text = re.sub(r"\\(?:ast|star)(?![A-Za-z])", "*", text).replace("*", "")
    text = text.replace("\\prime", "'").replace("\\times", "x")
    text = _VARIANT.sub("", text)
    return text.replace("\\", "")


def span_of_token(token: Token) -> tuple[int, int]:
    """Return the place of a token in the display."""
    return token.start_pos or 0, token.end_pos or 0


class LatexLexer(Lexer):
    """Lark's lexer interface over `_Scanner`."""

    def __init__(self, lexer_conf: object) -> None:
        """Lark hands over its configuration; nothing of it is needed."""

    def lex(self, data: tuple[str, Spelling]) -> Iterator[Token]:  # type: ignore[override]
        """Yield the tokens of (display, how it spells)."""
        text, spelling = data
        return _Scanner(text, spelling).scan()
