"""The formats of documents: which reader takes which file, and which files of a folder are documents."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from armproof.models.catalogue import arm_names
from armproof.verification.document.accepts import MARK, with_accepts
from armproof.verification.document.amended_tables import AMENDED
from armproof.verification.document.arm_in_words import MAY_NAME, planar_arms
from armproof.verification.document.arms_called import CALLED
from armproof.verification.document.cells import notebook_cells, percent_cells
from armproof.verification.document.code_tables import amended_in_code, code_tables
from armproof.verification.document.code_urdf import code_robots
from armproof.verification.document.denials import (
    denied_in,
    denies_above,
    denies_below,
    heading_may_deny,
    is_denied_by_headings,
)
from armproof.verification.document.flat_cells import as_one_text, on_flat_lines
from armproof.verification.document.formula_links import shows_its_latex
from armproof.verification.document.front_matter import read_any_text, suffix_of
from armproof.verification.document.heading import encloses
from armproof.verification.document.hearing import words_of
from armproof.verification.document.index_directions import MAY_INDEX, told_indices
from armproof.verification.document.left_sides import MAY_LEAD, with_left_sides
from armproof.verification.document.listings import assigned_in, assignments, with_listings
from armproof.verification.document.markdown import read_markdown_file
from armproof.verification.document.model import CODE, INLINE, Called, Display, Document, Listing, ToldPart
from armproof.verification.document.moving_on import OF_MOTION
from armproof.verification.document.named_quantities import NAMED
from armproof.verification.document.notebook import read_notebook, read_percent
from armproof.verification.document.orientations import MAY_ORIENT, told_orientations
from armproof.verification.document.other_functions import OTHER_FUNCTION
from armproof.verification.document.other_meanings import (
    MAY_ASK,
    MAY_MEAN,
    sentences_with_lines,
    told_below,
    with_other_meanings,
)
from armproof.verification.document.rst import read_rst
from armproof.verification.document.screw_tables import with_screws
from armproof.verification.document.sentences import (
    ABOVE,
    DENIED,
    DENIED_ABOVE,
    FAULTED_ABOVE,
    FROM_VALUES,
    LIMITED_ABOVE,
    MEANT,
    NOT_THERE,
    OF_ABOVE,
    OF_NEXT,
    OTHER_FRAME,
    OTHER_POINT,
    PROSE,
    SAME_POINT,
    STRANGE,
    STRANGE_ABOVE,
    SUPPOSED,
    is_of_a_case,
    said_by_heading,
    said_within,
)
from armproof.verification.document.strange import is_in_known_language
from armproof.verification.document.struck_out import MAY_STRIKE, with_struck_out
from armproof.verification.document.subjects import ACCELERATION, OPERATED
from armproof.verification.document.tex import ENVIRONMENTS, read_tex
from armproof.verification.document.told_chains import MAY_TELL_CHAIN, MAY_TELL_SIZE, told_parts
from armproof.verification.document.told_convention import MAY_TELL, conventions_below, told_convention
from armproof.verification.document.told_ends import MAY_TELL_END, told_ends
from armproof.verification.document.told_figures import MAY_TELL_FIGURE, told_formulas
from armproof.verification.document.told_names import MAY_TELL_NAMES
from armproof.verification.document.told_notation import MAY_NOTE
from armproof.verification.document.told_origins import MAY_TELL_ORIGIN
from armproof.verification.document.told_scalars import MAY_CALL_SIZE, told_scalars
from armproof.verification.document.told_since import MAY_SAY_SINCE
from armproof.verification.document.told_variables import MAY_TELL_VARIABLE
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.patterns import regex

_WORDS = regex(r"(?<![_{^])\\(?:text\w*|mbox|tag)\*?\{([^{}]+)\}")  # that are no index
_READERS: dict[str, Callable[[Path, str], Document]] = {
    ".md": read_markdown_file,
    ".ipynb": read_notebook,
    ".py": read_percent,
    ".qmd": read_markdown_file,
    ".tex": read_tex,
    ".rst": read_rst,
}
_MARKS = {".tex": ("$$", "\\[", *(f"\\begin{{{name}" for name in ENVIRONMENTS)), ".rst": (".. math::",)}
_SAYS = regex(
    r"[=≈<>≠]|\\(?:approx|simeq|equiv|[lg]eq?|neq?)(?![A-Za-z])|(?:∈|\\in(?![A-Za-z]))\s*(?:\\left\s*)?[(\[]|^\\text\{"
)
_TELLS_LANGUAGE = 8000  # characters of a text
_EQUATION = r"[^\])\"'\s]{0,300}(?:equation|\beqn?s?[\d_-]|formula|formule|ecuaci|gleichung|latex|codecogs|render/math|matri[xcz])[^\])\"']*"
_DEFINES = regex(r"\\(?:(?:re|provide)?newcommand|def|let|DeclareMathOperator|newenvironment)(?![A-Za-z])")
_OPTION = regex(r"\s*\\(?:text\w*|mathrm|mbox)\s*\{\s*\(?([A-Za-z1-9])\s*[).:]")
_INTERTEXT = regex(r"\\(?:short)?intertext\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_IMAGE = regex(  # by what it is called or where it is made: ![equation 3](eq3.png), <img src="…codecogs.com…">
    rf"!\[(?=[^\])\"']{{1,2000}}\]\(){_EQUATION}\]\([^)\n]{{1,2000}}\)|!\[[^\]\n]{{0,200}}\]\({_EQUATION}\)|<img\b[^>]{{0,500}}?(?:src|alt)=\\?[\"']{_EQUATION}"
    rf"|\\includegraphics\s*(?:\[[^\]]{{0,200}}\])?\{{{_EQUATION}\}}",
    re.IGNORECASE,
)
_HEADING = regex(r"[ ]{0,3}#{1,6}[ \t]+(.*?)[ \t#]*$|[ \t]*\\(?:chapter|(?:sub)*section|paragraph)\*?\s*\{(.*)\}")
SUFFIXES = tuple(_READERS)
OF_QUANTITY = tuple(MEANT + each for each in (NAMED, OPERATED, ACCELERATION, OTHER_FUNCTION))


def read_document(path: Path) -> Document:
    """Return the document of a file; raises DocumentError with file and line where it is not one."""
    text, remarks = read_any_text(path)
    document = parse_document(path, text)
    return replace(document, remarks=(*remarks, *document.remarks))


def parse_document(path: Path, text: str, format: str = "") -> Document:
    """Return the document of a text, read as its format or else the name of `path` says; raises DocumentError."""
    if format and f".{format}" not in _READERS:
        formats = ", ".join(suffix.removeprefix(".") for suffix in SUFFIXES)
        raise DocumentError(say(Kind.UNKNOWN_FORMAT, format=format, formats=formats), path=path)
    suffix = f".{format}" if format else suffix_of(path)
    try:
        document = _READERS.get(suffix, read_markdown_file)(path, text)
    except RecursionError:
        raise DocumentError(say(Kind.NESTED), path=path) from None
    if suffix != ".tex" and any(_DEFINES.search(display.latex) for display in document.displays):
        from armproof.verification.document.markdown_macros import with_macros

        document = with_macros(document)
    if MAY_LEAD.search(text):
        document = with_left_sides(document, text)
    document = _with_what_is_said(with_screws(document))
    if suffix in (".ipynb", ".py") or MAY_STRIKE.search(text):
        document = with_struck_out(document, text, suffix)
    if any(display.strange for display in document.displays) and not is_in_known_language(
        words_of(text[:_TELLS_LANGUAGE])
    ):
        document = replace(document, displays=tuple(replace(each, strange="") for each in document.displays))
    flat, above = as_one_text(text, suffix)
    document = on_flat_lines(_with_what_is_told(on_flat_lines(document, above), flat), above, -1)
    small = flat.lower()
    if (images := sum(not shows_its_latex(each) for each in _IMAGE.findall(text))) and suffix != ".py":
        told = say(Kind.IMAGES, count=images) if images > 1 else say(Kind.IMAGE)
        document = replace(document, remarks=(*document.remarks, told))
    headings = tuple(_headings(text)) if "arms" in document.front and suffix not in (".ipynb", ".py") else ()
    planar = planar_arms(flat) if MAY_NAME.search(flat) else frozenset[int]()
    convention = told_convention(flat) if MAY_TELL.search(flat) else ""
    scalars = frozenset(each for each, *_ in told_below(flat, told_scalars)) if MAY_CALL_SIZE.search(small) else ()
    document = replace(document, named=named_arms(text), planar=planar, headings=headings, convention=convention)
    ends = tuple(_told_ends(flat)) if MAY_TELL_END.search(small) else ()
    document = replace(document, scalars=frozenset(scalars), ends=ends)
    if MAY_TELL_FIGURE.search(flat):
        document = replace(document, figures=tuple(_told_figures(text, suffix)))
    if MAY_TELL_CHAIN.search(small) or MAY_TELL_SIZE.search(small):
        document = replace(document, told=tuple(_told_parts(document, text, suffix)))
    return with_accepts(document, text.replace("\r\n", "\n"), suffix) if MARK in text else document


def _with_what_is_told(document: Document, text: str) -> Document:
    """Return a document whose displays know what the sentences of its text tell of letters, places, directions and arms."""
    small = text.lower()
    if any(
        each.search(small)
        for each in (MAY_MEAN, MAY_ASK, MAY_NOTE, MAY_TELL_NAMES, MAY_TELL_VARIABLE, MAY_TELL_ORIGIN, MAY_SAY_SINCE)
    ):
        document = with_other_meanings(document, text)
    tells = [(MAY_ORIENT, told_orientations), (MAY_INDEX, told_indices), (MAY_TELL, conventions_below)]
    if heard := [tell for may, tell in tells if may.search(small)]:
        document = with_directions(document, text, heard)
    return document


def _told_ends(text: str) -> Iterator[tuple[int, str]]:
    """Yield where the sentences of a text put the tool, each with its line."""
    yield from ((line, each) for line, sentence in sentences_with_lines(text) for each in told_ends(sentence))


def _told_figures(text: str, suffix: str) -> Iterator[tuple[int | None, int, str]]:
    """Yield the formulas of vectors in the sentences of a text, each with its cell and line."""
    for own, first, cell in _texts(text, suffix):
        for line, sentence in sentences_with_lines(own):
            yield from ((cell, line + first - 1, each) for each in told_formulas(sentence))


def _texts(text: str, suffix: str) -> list[tuple[str, int, int | None]]:
    """Return the texts of a document, with their first lines and cells."""
    cells = {".ipynb": notebook_cells, ".py": percent_cells}.get(suffix)
    if cells is None:
        return [(text, 1, None)]
    return [(each.text, each.line, k) for k, each in enumerate(cells(text)) if each.kind == "markdown"]


def _told_parts(document: Document, text: str, suffix: str) -> Iterator[ToldPart]:
    """Yield what the sentences of a text tell of an arm's build, each with the place of the display behind it."""
    places = sorted((each.cell or 0, each.line) for each in document.displays if not each.file)
    for own, first, cell in _texts(text, suffix):
        for line, sentence in sentences_with_lines(own) if places else ():
            if "$" in sentence or "\\(" in sentence or MAY_TELL_SIZE.search(sentence):
                at = (cell or 0, line + first - 1)
                behind = next((place for place in places if place > at), places[-1])
                yield from told_parts(sentence, (cell, at[1]), behind)


def with_directions(document: Document, text: str, tells: Sequence[Callable[[str], Iterable[str]]]) -> Document:
    """Return a document whose displays know what the text of their section tells of directions, of indices and of conventions."""
    told = [*told_below(text, *tells)]
    return replace(document, displays=tuple(_directed(each, told) for each in document.displays)) if told else document


def _directed(display: Display, told: Sequence[tuple[str, int, float]]) -> Display:
    own = [each for each, begin, end in told if begin <= display.line < end or display.file or display.cell is not None]
    return replace(display, directions=() if display.erratum else tuple(dict.fromkeys(own)))


def _headings(text: str) -> Iterator[tuple[int, str]]:
    """Yield the headings of a text with their lines: # of Markdown, sections of LaTeX, underlined lines."""
    plain = text.removeprefix("\ufeff").replace("\r\n", "\n")
    lines = re.sub(r"\A---.*?\n(?:---|\.\.\.)", lambda head: "\n" * head[0].count("\n"), plain, flags=re.DOTALL).split(
        "\n"
    )
    for number, (line, below) in enumerate(zip(lines, [*lines[1:], ""], strict=True), start=1):
        if found := _HEADING.match(line):
            yield number, found[1] or found[2]
        elif line.strip() and re.fullmatch(r"([=~^*-])\1{2,}[ ]*", below):
            yield number, line.strip()


def named_arms(text: str) -> tuple[str, ...]:
    """Return the arms of the catalogue that a text names by their type: RX-90, KR 210."""
    types = {name: re.fullmatch(r"([a-z]+)(\d+)", name) for name in arm_names()}
    patterns = {name: rf"(?<![a-z]){found[1]}[ ~_-]?{found[2]}(?!\d)" for name, found in types.items() if found}
    return tuple(name for name, pattern in patterns.items() if re.search(pattern, text, re.IGNORECASE))


def _with_what_is_said(document: Document) -> Document:
    """Give each display the equations and the postures of the text before it and behind it, which are no displays."""
    marked = {each.section for each in document.displays if each.erratum}  # where the reader is told which is wrong
    displays: list[Display] = []
    between: list[list[Display]] = [[]]  # what is said before each display, and behind the last
    led = frozenset[str]()  # what the sentence says that leads to the one at hand, and to those right behind it
    has_words = True
    for display in document.displays:
        if display.opening == CODE:
            continue
        if display.opening != INLINE:
            goes_on = not has_words and bool(displays) and _is_of_same_text(displays[-1], display)
            led = _inherited(led) if goes_on else _of_next(between[-1], display)
            one = _with_what_is_before(display, between[-1], led, display.section in marked)
            if SAME_POINT in one.meant:
                before = displays[-1].line if displays and _is_of_same_text(displays[-1], display) else 0
                one = replace(one, meant=(*one.meant, f"{SAME_POINT} {before}"))
            displays.append(replace(one, goes_on=goes_on))
            between.append([])
            has_words = display.erratum  # what leads to what is quoted leads to nothing else
        elif display.latex == PROSE:
            has_words = True
        elif display.latex.startswith(CALLED):
            continue
        elif display.latex.startswith(OF_ABOVE):
            displays[-1:] = [
                each if each.erratum else _with_what_is_above(each, display.latex) for each in displays[-1:]
            ]
        elif _SAYS.search(display.latex):
            between[-1].append(display)
        has_words |= display.opening == INLINE and not display.latex.startswith("\\text{")
    told = _with_options(tuple(_with_what_is_behind(displays, between[1:])))
    listings = [*_listings(document)]
    works_out = any(display.latex.count("=") > 1 for display in told)
    told = tuple(with_listings(told, listings)) if listings or works_out else told
    code = [each for each in document.displays if each.opening == CODE]
    amended = [f"{AMENDED} {said}" for said in amended_in_code(code)] if "arm" not in document.front else []
    if amended:
        told = tuple(each if each.erratum else replace(each, meant=(*each.meant, amended[0])) for each in told)
    in_code = tuple(code_tables(code)) if code and not amended else ()
    robots = tuple(code_robots(code))
    return replace(document, displays=told, called=tuple(_called(document)), in_code=in_code, robots=robots)


def _with_what_is_above(display: Display, latex: str) -> Display:
    """Return a display with what the text behind it is heard to say of it."""
    if latex.startswith(STRANGE_ABOVE):
        return replace(display, strange=latex.removeprefix(STRANGE_ABOVE))
    if latex.startswith(ABOVE + MEANT):
        return replace(display, meant=(*display.meant, latex.removeprefix(ABOVE + MEANT)))
    said: dict[str, Any] = {
        DENIED_ABOVE: {"denied": True},
        FAULTED_ABOVE: {"faulted": True},
        LIMITED_ABOVE: {"supposed": True},
        ABOVE + OTHER_POINT: {"of_other_point": True},
        ABOVE + OTHER_FRAME: {"in_other_frame": True},
    }
    return replace(display, **said[latex])


def _listings(document: Document) -> Iterator[Listing]:
    """Yield the values in the code of a document, each with its heading."""
    for display in document.displays:
        if display.opening == CODE and (assigned := assigned_in(display.latex)):
            values = assignments(display.latex)
            yield Listing(display.line, values, display.section, cell=display.cell, assigned=assigned)


def _called(document: Document) -> Iterator[Called]:
    """Yield what the sentences of a document call arms; one that begins on the line of a display stands behind it."""
    last = (0, 0)
    for each in document.displays:
        place = (each.cell or 0, each.line)
        if each.opening != INLINE:
            last = place
        elif each.latex.startswith(CALLED):
            place = (place[0], place[1] + (place == last))
            yield Called(place, each.section, frozenset(each.latex[len(CALLED) : -1].split()))


def _is_of_same_text(one: Display, other: Display) -> bool:
    return (one.section, one.cell, one.file) == (other.section, other.cell, other.file)


def _of_next(all_said: Sequence[Display], display: Display) -> frozenset[str]:
    return frozenset(each.latex for each in all_said if each.section == display.section)


def _inherited(led: frozenset[str]) -> frozenset[str]:
    """Return what holds of a second display of what a sentence says: not which quantity the first one is, nor that it is supposed."""
    return frozenset(each for each in led if each.startswith(OF_NEXT) and not each.startswith((*OF_QUANTITY, SUPPOSED)))


def _with_what_is_before(
    display: Display, all_said: Sequence[Display], led: frozenset[str], is_marked: bool
) -> Display:
    of_it = {*led}
    within = [each for found in _WORDS.finditer(display.latex) for each in said_within(found[1])]
    of_it |= {*within, *(said_by_heading(display.section) if display.section else ())}
    strange = [each.removeprefix(STRANGE) for each in of_it if each.startswith(STRANGE)]
    said = [each for each in all_said if not each.latex.startswith(OF_NEXT)]
    above = sum(each.section != display.section for each in said)
    outside = sum(not encloses(each.section, display.section) for each in said)
    return replace(
        display,
        latex=_INTERTEXT.sub(lambda found: " " * len(found.group()), display.latex),
        said=tuple(each.latex for each in said),
        said_above=above,
        said_outside=outside,
        denied=not display.erratum and (DENIED in of_it or _denies_itself(display, is_marked)),
        faulted=not (display.erratum or is_marked) and bool(display.section) and heading_may_deny(display.section),
        supposed=not display.erratum
        and (SUPPOSED in of_it or (bool(display.section) and is_of_a_case(display.section))),
        strange="" if display.erratum else " ".join(strange),
        of_other_point=not display.erratum and OTHER_POINT in of_it,
        in_other_frame=not display.erratum and OTHER_FRAME in of_it,
        meant=() if display.erratum else tuple(each.removeprefix(MEANT) for each in of_it if each.startswith(MEANT)),
    )


def _denies_itself(display: Display, is_marked: bool) -> bool:
    """Whether a display says that it is wrong, or its heading does and no display there is marked as an erratum."""
    between = _INTERTEXT.findall(display.latex) if "intertext" in display.latex else ()
    if any(denies_above(text) or denies_below(text) for text in between):
        return True
    has_words = "\\tag" in display.latex or "cancel" in display.latex or "text" in display.latex
    is_below = bool(display.section) and not is_marked
    return (has_words and denied_in(display.latex)) or (is_below and is_denied_by_headings(display.section))


def _with_what_is_behind(displays: Sequence[Display], behind: Sequence[Sequence[Display]]) -> Iterator[Display]:
    """Yield the displays with what the next text in their section says: "where ρ = …" is often told below several of them."""
    found: list[Display] = []
    for display, said in zip(reversed(displays), reversed(behind), strict=True):
        own = tuple(
            each.latex
            for each in said
            if each.section == display.section and not each.latex.startswith((*OF_NEXT, *OF_MOTION))
        )
        later = found[-1].said_behind if found and found[-1].section == display.section else ()
        says = any(each not in (FROM_VALUES, NOT_THERE) for each in own)
        found.append(replace(display, said_next=own, said_behind=own if says else later))
    yield from reversed(found)


def _with_options(displays: Sequence[Display]) -> tuple[Display, ...]:
    """Return displays of which (a) is supposed where (b) behind it is, and the other way round: what asks for the right one asks so of all."""
    found = list(displays)
    for places in (range(1, len(found)), range(len(found) - 1, 0, -1)):
        for at in places:
            pair = found[at - 1 : at + 1]
            if _are_options(*pair) and any(each.supposed for each in pair):
                found[at - 1 : at + 1] = [replace(each, supposed=not each.erratum) for each in pair]
    return tuple(found)


def _are_options(one: Display, other: Display) -> bool:
    """Whether two displays begin with a letter or a number in words and the next one: \\text{(a)}, \\text{(b)}."""
    marks = [found[1] for each in (one, other) if (found := _OPTION.match(each.latex)) is not None]
    return len(marks) == 2 and ord(marks[1]) - ord(marks[0]) == 1 and one.section == other.section


def find_documents(paths: list[Path]) -> list[Path]:
    """Return the documents named, and those in the folders named; raises DocumentError where there are none.

    In a folder, a file counts that has front matter with one of our keys or holds a display.
    """
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            documents = [child for child in _files_below(path) if _is_document(child)]
            if not documents:
                raise DocumentError(say(Kind.NO_DOCUMENT, suffixes=list(SUFFIXES)), path=path)
            found.extend(documents)
        elif not path.exists():
            raise DocumentError(say(Kind.NO_FILE_OR_FOLDER), path=path)
        elif suffix_of(path) not in SUFFIXES:
            raise DocumentError(say(Kind.UNKNOWN_SUFFIX, suffix=path.suffix, suffixes=list(SUFFIXES)), path=path)
        else:
            found.append(path)
    return list(dict.fromkeys(found))


def _files_below(folder: Path) -> list[Path]:
    """Return the files of a folder that may be documents, hidden ones and those in hidden folders left out."""
    return [
        child
        for child in sorted(folder.rglob("*"))
        if suffix_of(child) in SUFFIXES
        and child.is_file()
        and not any(part.startswith(".") for part in child.relative_to(folder).parts)
    ]


def _is_document(path: Path) -> bool:
    try:
        text, _ = read_any_text(path)
    except DocumentError:
        return suffix_of(path) != ".py"
    return _has_displays(suffix_of(path), text) or _names_an_arm(text)


def _has_displays(suffix: str, text: str) -> bool:
    """Whether a file's text is likely to hold displays."""
    if suffix == ".py":  # its text cells, not what stands in a program's strings
        return any(cell.kind == "markdown" for cell in percent_cells(text))
    return any(mark in text for mark in _MARKS.get(suffix, ("$$", "{math}")))


def _names_an_arm(text: str) -> bool:
    return bool(re.match(r"(?:---|%|\.\.|:)", text)) and bool(re.search(r"^[%:\s]*arm:", text, re.MULTILINE))
