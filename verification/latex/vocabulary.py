"""The vocabulary of kinematic LaTeX: letters, functions in all their spellings, relations, words, environments, styles."""

from __future__ import annotations

from armproof.verification.latex import greek

VARIANTS = {**greek.VARIANTS, "ell": "l", "emptyset": "varnothing"}
LETTERS = frozenset([*greek.GREEK, "ell", "varnothing", "emptyset", "nabla"])  # commands that are letters

# how the functions of kinematics are spelt: the spelling → the function
FUNCTIONS = {
    "cos": "cos", "sin": "sin", "tan": "tan", "cot": "cot", "sec": "sec", "csc": "csc",
    "arccos": "acos", "acos": "acos", "arcsin": "asin", "asin": "asin", "arctan": "atan", "atan": "atan",
    "Arccos": "acos", "Arcsin": "asin", "Arctan": "atan", "Acos": "acos", "Asin": "asin", "Atan": "atan", "ArcTan": "atan",
    "ArcCos": "acos", "ArcSin": "asin", "ATAN": "atan", "ACOS": "acos", "COS": "cos", "SIN": "sin", "arcos": "acos",
    "arcsen": "asin", "arctang": "atan", "Cos": "cos", "Sin": "sin", "Tan": "tan",
    "atan2": "atan2", "Atan2": "atan2", "ATAN2": "atan2", "arctan2": "atan2", "Arctan2": "atan2", "arctg": "atan",
    "tg": "tan", "sen": "sin", "Sen": "sin", "SEN": "sin",
    "det": "det", "Det": "det", "DET": "det", "rank": "rank", "rang": "rank", "rg": "rank", "rk": "rank", "adj": "adj", "com": "com",
    "cof": "com", "tr": "tr", "Tr": "tr", "trace": "tr", "sqrt": "sqrt", "Rot": "Rot", "rot": "Rot", "Trans": "Trans", "trans": "Trans",
    "diag": "diag", "exp": "exp", "ln": "ln", "log": "log", "sgn": "sgn", "sign": "sgn", "sinh": "sinh", "cosh": "cosh",
    "tanh": "tanh", "min": "min", "max": "max", "lim": "lim", "dim": "dim", "ker": "ker", "arg": "arg", "sup": "sup", "inf": "inf",
}  # fmt: skip
# bare letters are a product unless they spell one of these
BARE_WORDS = sorted(
    (
        set(FUNCTIONS)
        - {
            "tr",
            "com",
            "cof",
            "tg",
            "rg",
            "rk",
            "adj",
            "rot",
            "ln",
            "min",
            "max",
            "lim",
            "exp",
            "log",
            "sgn",
            "dim",
            "ker",
            "arg",
            "sup",
            "inf",
        }
    ),
    key=len,
    reverse=True,
)

UNWRITTEN = "?"  # the letter of an entry that is not written: ? or * alone in a cell of a matrix
ASKED = "≟"  # \\overset{!}{=}, \\overset{?}{=}, \\overset{\\text{no}}{=}: what is asked for, or denied, and not claimed
RELATIONS = {
    "=": "=", "equiv": "=", "triangleq": "=", "coloneqq": "=", ":=": "=", "approx": "≈", "simeq": "≈",
    "leq": "≤", "le": "≤", "leqslant": "≤", "geq": "≥", "ge": "≥", "geqslant": "≥", "<": "<", ">": ">",
    "neq": "≠", "ne": "≠", "in": "∈", "notin": "∉", "lt": "<", "gt": ">", "subset": "⊂", "propto": "∝",
}  # fmt: skip
CONNECTIVES = {
    "Rightarrow": "⇒", "implies": "⇒", "Longrightarrow": "⇒", "to": "⇒", "rightarrow": "⇒", "longrightarrow": "⇒",
    "iff": "⇔", "Leftrightarrow": "⇔", "Longleftrightarrow": "⇔", "Leftarrow": "⇐", "therefore": "⇒",
    "lor": "or", "vee": "or", "land": "and", "mapsto": "⇒", "longmapsto": "⇒",
}  # fmt: skip

MATRICES = {"matrix", "bmatrix", "pmatrix", "vmatrix", "Vmatrix", "Bmatrix", "smallmatrix", "array", "bsmallmatrix",
            "psmallmatrix"}  # fmt: skip
LAYOUTS = {"aligned", "align", "split", "gather", "gathered", "alignat", "alignedat", "eqnarray", "multline",
           "cases", "dcases", "rcases", "flalign"}  # fmt: skip
TRANSPARENT = {"equation", "displaymath", "math", "subequations", "small", "footnotesize", "center"}

# accents that make another name of a letter; vec, boldface and the like do not
ACCENTS = {"bar": "bar", "overline": "bar", "tilde": "tilde", "widetilde": "tilde", "hat": "hat", "widehat": "hat"}
# macros for bold, upright and script letters as classes and packages call them, wherever they are defined
OF_CLASSES = {
    **dict.fromkeys(("mcal", "mscr", "mathpzc", "symcal", "symscr"), "cal"),
    **dict.fromkeys(("mfrak", "symfrak"), "frak"),
    **dict.fromkeys(
        (
            "mat", "matr", "mtx", "bmat", "mbf", "mbs", "msf", "mrm", "mathbfit", "mathbfsf", "mathsfbf", "mathsfit", "mathbold",
            "symbfit", "symbfup", "symbfsf", "symsf", "symit", "symrm", "tens", "bmath", "bvec", "vecb", "vbf", "bs",
        ),
        "bold",
    ),
    **dict.fromkeys(("vect", "vector", "vecteur", "vv", "Vec", "vct"), "arrow"),
}  # fmt: skip
# what makes another name of a letter where a document has it in both (naming/dresses.py)
DRESSES = {
    **dict.fromkeys(("mathcal", "mathscr", "cal"), "cal"),
    **dict.fromkeys(("mathfrak", "frak"), "frak"),
    **dict.fromkeys(("mathbf", "boldsymbol", "bm", "pmb", "symbf", "bold", "vb", "bf", "boldvec"), "bold"),
    **dict.fromkeys(("vec", "overrightarrow", "va"), "arrow"),
    **dict.fromkeys(("hat", "widehat"), "hat"),
    **OF_CLASSES,
}
STYLES = (
    "mathbf|mathrm|mathit|mathsf|mathbb|mathcal|mathfrak|mathscr|mathtt|boldsymbol|bm|pmb|vec|overrightarrow|text|textbf|textit|textrm|"
    "textsf|texttt|operatorname|mathop|mbox|hbox|bf|rm|it|hat|widehat|bar|overline|underline|tilde|widetilde|mathnormal|emph|boxed|fbox|"
    "bold|symbf|symup|textup|textnormal|mathds|Bbb|frak|cal|sf|tt|vb|va|vu|uvec|boldvec|ensuremath|phantom|smash|mathstrut|mathord|mathbin|mathrel|"
    + "|".join(OF_CLASSES)
)
NO_LETTERS = frozenset(  # commands of LaTeX whose argument is no formula
    "input include includegraphics footnote footnotemark footnotetext caption url href cite index hyperref write nocite bibliography marginpar".split()
)
STRIKES = frozenset(["cancel", "bcancel", "xcancel", "sout"])  # whether a struck term counts nobody can tell
SPACES = (
    r"displaystyle|textstyle|scriptstyle|scriptscriptstyle|limits|nolimits|nonumber|notag|hline|hdashline|hfill|noindent|"
    r"normalsize|small|footnotesize|scriptsize|tiny|large|Large|centering|allowbreak|"
    r"thinspace|medspace|thickspace|negthinspace|space|middle|[bB]igg?[lrm]?|toprule|midrule|bottomrule|strut|relax|null"
)

# single characters and commands → the kind of token
CHARACTERS = {
    "+": "PLUS", "-": "MINUS", "/": "SLASH", "(": "LPAR", "[": "LPAR", ")": "RPAR", "]": "RPAR", "{": "LBRACE",
    "}": "RBRACE", "&": "AMP", ",": "COMMA", ";": "SEP", ":": "SEP", "=": "REL", "<": "REL", ">": "REL", "'": "PRIME",
    ".": "DOT", "*": "STAR",
}  # fmt: skip
COMMANDS = {
    "pm": "PM", "mp": "PM", "cdot": "CDOT", "times": "TIMES", "wedge": "TIMES", "ast": "CDOT", "star": "CDOT",
    "bullet": "CDOT", "circ": "CDOT", "div": "SLASH", "frac": "FRAC", "dfrac": "FRAC", "tfrac": "FRAC", "cfrac": "FRAC",
    "sqrt": "SQRT", "partial": "PARTIAL", "dots": "DOTS", "ldots": "DOTS", "cdots": "DOTS", "vdots": "DOTS",
    "ddots": "DOTS", "dotsc": "DOTS", "dotsb": "DOTS", "dotsm": "DOTS", "prod": "DOTS", "sum": "DOTS", "int": "DOTS", "oplus": "DOTS", "ominus": "DOTS", "underbrace": "BRACE", "overbrace": "BRACE",
    "overset": "OVERSET", "underset": "OVERSET", "stackrel": "OVERSET",
    "dot": "ACCENT", "ddot": "ACCENT", "dddot": "ACCENT", "quad": "SEP", "qquad": "SEP", "enskip": "SEP", "enspace": "SEP", "colon": "SEP",
    "{": "OPEN_SET", "}": "CLOSE_SET", "lbrace": "OPEN_SET", "rbrace": "CLOSE_SET", "|": "BAR", "vert": "BAR",
    "lvert": "OPEN_BAR", "rvert": "CLOSE_BAR", "lVert": "OPEN_BAR", "rVert": "CLOSE_BAR", "because": "TEXT", "Vert": "BAR", "mid": "BAR", "lbrack": "LPAR", "rbrack": "RPAR",
    "prime": "PRIME", "forall": "TEXT", "exists": "TEXT", "top": "LETTER", "infty": "LETTER",
    "imath": "LETTER", "jmath": "LETTER",
}  # fmt: skip
COMMANDS |= dict.fromkeys(("SE", "SO", "se", "so", "reals", "Reals", "Real"), "LETTER")
BARE_JOINING = tuple("and or if then where when with hence thus for avec donc alors soit pour".split())
# connectives in words, each alone between two statements
SPOKEN = {
    "or": ("or", "ou", "oder", "o", "或", "或者", "または", "또는", "или", "หรือ"),
    "and": ("and", "et", "und", "y", "e", "和", "且", "与", "と", "그리고", "и", "และ"),
    "⇔": ("if and only if", "iff", "si et seulement si", "ssi"),
    "if": ("if", "si", "at", "when", "whenever", "for", "for all", "pour", "lorsque", "provided", "wenn", "falls", "cuando",
           "若", "当", "如果", "если"),
}  # fmt: skip
QUANTITIES = frozenset(["SI", "qty", "ang", "num", "si", "unit"])  # of siunitx
UNIT_NAMES = {
    "micro": "µ",
    "milli": "m",
    "centi": "c",
    "deci": "d",
    "kilo": "k",
    "mega": "M",
    "metre": "m.",
    "meter": "m.",
    "gram": "g.",
    "newton": "N.",
    "degree": "deg.",
    "radian": "rad.",
    "per": "/",
    "second": "s.",
    "minute": "min.",
    "squared": "^2.",
    "cubed": "^3.",
    "percent": "%",
}
WORD_STYLES = frozenset(
    ["text", "textbf", "textit", "textrm", "textsf", "texttt", "textup", "textnormal", "mbox", "hbox", "emph"]
)
# words that join statements, and are the name of nothing
JOINING = frozenset(
    """and or if then where when with so thus hence therefore for from since because as is are we that which otherwise else i.e. e.g.
et ou où si alors avec donc ainsi d'où soit pour car sinon on und oder wenn also mit wobei für y o si entonces donde con e ou se então onde com""".split()
)
# words that say of what value something is, and are the name of nothing
SAID_OF_VALUES = frozenset(
    "const constant constante konstant cste cst cte konst costante zero zéro null nul nulle positive positif negative négatif nonzero finite infinite unknown independent dependent invariant".split()
)
BARE_CONSTANTS = ("cste", "cst", "cte", "Cste", "Cst", "Cte", "const", "konst")  # in letters that are no factors
# words behind a number that are no unit of it
NO_UNITS = (
    JOINING | frozenset(word for spoken in SPOKEN.values() for word in spoken) | {"mod", "modulo", "and", "etc", "only"}
)
PUNCTUATION = {"%": "TEXT", "$": "TEXT", "#": "TEXT", "&": "TEXT", "_": "TEXT"}
# words of a brace's label that name a part, and claim nothing of its value
LABEL_WORDS = frozenset(
    """the of first second third last term terms part sum joint link arm body frame tool gripper height width depth length distance angle rotation rotational
    translation translational position orientation linear angular matrix vector block column row radius reach point target known unknown given new old here
    coefficient coefficients lhs rhs left right hand side numerator denominator determinant square root radial planar horizontal vertical projection contribution
    le la les du de des premier deuxième troisième dernier terme partie somme liaison articulation corps segment bras repère outil pince hauteur largeur longueur
    rotation translation position orientation matrice vecteur bloc colonne ligne rayon point cible connu inconnu gauche droite membre coefficient
    höhe länge glied gelenk werkzeug drehung verschiebung""".split()
)
