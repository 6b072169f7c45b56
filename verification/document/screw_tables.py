"""Tables of screw axes, ω_i beside v_i or q_i: what a document whose motions are exponentials of them says in a display, S_1 = (ω, v)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from armproof.verification.document.arrays import array_in
from armproof.verification.document.model import CODE, Display, Document, Table
from armproof.verification.patterns import regex

_MOTION = regex(  # e^{[\mathcal{S}_1]θ_1}, e^{\hat\xi_1 θ_1}, \exp([S_1]θ_1)
    r"(?:e\s*\^\s*\{|\\exp\s*(?:\\left)?\(?)\s*(?:\{\s*)?(?:\\left)?(?:\[\s*(?P<screw>(?:\\\w+\s*\{?\s*)*S)[\s}]*_|\\(?:wide)?hat\s*\{?\s*(?P<twist>\\xi)[\s}]*_)"
)
_COLUMNS = {"omega": "omega", "ω": "omega", "w": "omega", "v": "v", "q": "q", "s": "screw", "xi": "twist"}
_STYLE = regex(r"\\(?:math\w+|boldsymbol|bm|vec|hat|mathbf|text|left|right|,|;|!| )|[${}\\\s*]|_?i\b|_i")
_WORDS = regex(r"(?<![\\A-Za-z])(?!omega|xi)[A-Za-z]{3,}(?!_)")  # Screw axis S_i
_VECTOR = regex(r"[\[(]\s*(.*?)\s*[\])](?:\^(?:T|top))?")
_NUMBERS = frozenset(["0", "1", "-1", "+1"])
_ORDERS = {"screw": ("omega", "v"), "twist": ("v", "omega")}


def with_screws(document: Document) -> Document:
    """Return a document with a display for each table of screw axes, if its motions are the exponentials of these."""
    told = next(filter(None, (_MOTION.search(each.latex) for each in document.displays if each.opening != CODE)), None)
    if told is None:
        return document
    kind = "screw" if told["screw"] else "twist"
    letter = (told["screw"] or told["twist"]).replace(" ", "")
    letter += "}" * (letter.count("{") - letter.count("}"))
    displays: list[Display] = []
    for display in document.displays:
        array = array_in(display)
        said = _said(array.table, kind, letter) if array is not None else None
        displays.append(said or display)
    for said in filter(None, (_said(table, kind, letter) for table in document.tables)):
        behind = (k for k, each in enumerate(displays) if _place(each) >= _place(said))
        displays.insert(next(behind, len(displays)), said)
    return replace(document, displays=tuple(displays))


def _said(table: Table, kind: str, letter: str) -> Display | None:
    """Return the display that says the same as a table of screw axes, None of another table."""
    latex = _in_latex(table, kind, letter)
    if latex is None:
        return None
    return Display(table.line, latex, table.erratum, table.cell, table.section, file=table.file, opening="|")


def _place(display: Display) -> tuple[int, int]:
    return display.cell or 0, display.line


def _in_latex(table: Table, kind: str, letter: str) -> str | None:
    r"""Return \\mathcal{S}_1 = […], \\quad … of the rows of a table; None of another table."""
    heads = (_plain(_WORDS.sub("", head)).lower() for head in table.header)
    columns = {_COLUMNS[key]: k for k, key in enumerate(heads) if key in _COLUMNS}
    has_place = "v" in columns or "q" in columns
    if kind not in columns and not ("omega" in columns and has_place):
        return None
    equations = []
    for number, row in enumerate(table.rows, 1):
        cells = {key: _vector(row[k]) for key, k in columns.items() if k < len(row)}
        vector = _row(cells, kind)
        if vector is None:
            return None
        first = _plain(row[0])
        index = first if first.isdigit() and 0 not in columns.values() else str(number)
        column = r" \\ ".join(vector)
        equations.append(rf"{letter}_{{{index}}} = \begin{{bmatrix}} {column} \end{{bmatrix}}")
    return r", \quad ".join(equations) if equations else None


def _row(cells: dict[str, tuple[str, ...]], kind: str) -> tuple[str, ...] | None:
    """Return the six entries of a row, in the order of its kind; None where it lacks some."""
    if len(cells.get(kind, ())) == 6:
        return cells[kind]
    omega, v, point = (cells.get(key, ()) for key in ("omega", "v", "q"))
    if len(omega) == 3 and len(v) != 3 and len(point) == 3 and _NUMBERS.issuperset(omega) and {*omega} != {"0"}:
        v = _moment(omega, point)
    parts = {"omega": omega, "v": v}
    return tuple(cell for key in _ORDERS[kind] for cell in parts[key]) if len(omega) == 3 == len(v) else None


def _moment(omega: Sequence[str], point: Sequence[str]) -> tuple[str, ...]:
    """Return v = −ω × q, for an ω of zeros and ones."""
    axes = [((k + 1) % 3, (k + 2) % 3) for k in range(3)]
    pairs = [[(int(omega[b]), point[a]), (-int(omega[a]), point[b])] for a, b in axes]
    return tuple(_sum([(sign, entry) for sign, entry in pair if sign and entry != "0"]) for pair in pairs)


def _sum(terms: Sequence[tuple[int, str]]) -> str:
    return " ".join(f"{'-' if sign < 0 else '+'} ({entry})" for sign, entry in terms).removeprefix("+ ") or "0"


def _plain(text: str) -> str:
    return _STYLE.sub("", text)


def _vector(cell: str) -> tuple[str, ...]:
    """Return the entries of (0, 0, L_1), [0 0 1]^T or a printed column."""
    text = re.sub(r"(?<!\\)\\(?:left|right|[,;!: ])|[$~]", " ", cell).strip()
    printed = re.fullmatch(r"\\begin\{\w*matrix\}(.*)\\end\{\w*matrix\}", text, re.DOTALL)
    if printed is not None:
        return tuple(part.strip() for part in re.split(r"\\\\|&", printed[1]))
    found = _VECTOR.fullmatch(re.sub(r"\^\s*\{?\s*\\?(T|top)\s*\}?$", r"^\1", text))
    return tuple(_entries(found[1])) if found is not None else ()


def _entries(text: str) -> Iterator[str]:
    """Yield what commas part, or else blanks."""
    for part in re.split(r"\s*[,;]\s*", text) if re.search("[,;]", text) else text.split():
        yield part.strip()
