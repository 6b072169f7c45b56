"""From a checked document to its sheet: front matter, figures, the edition asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path

from armproof.course.errors import PrintError
from armproof.course.figures.drawing.style import MM
from armproof.course.figures.output.save import save_figure
from armproof.course.figures.registry import KINDS, caption_kind, draw_kind, find_kind
from armproof.course.printing.tex import tex_body
from armproof.course.sheet.body import Body
from armproof.course.sheet.editions import for_students, has_solutions, with_solutions
from armproof.course.sheet.inline import InlineReader
from armproof.course.sheet.model import Block, Heading, Inline, Picture, Sheet, Text, plain
from armproof.course.sheet.numbers import number_equations
from armproof.course.sheet.reading import BlockReader
from armproof.course.translation.documents import in_language
from armproof.course.words import say
from armproof.models.arm import Arm
from armproof.models.catalogue import arm_of, load_arm
from armproof.models.errors import existing_language, written
from armproof.verification.document import Document
from armproof.verification.document.catalogue import translated_sentence, translation_of
from armproof.verification.document.front_matter import read_any_text, read_text, split_front_matter
from armproof.verification.document.markdown import markdown_reader
from armproof.verification.document.notebook import read_cells, split_cells
from armproof.verification.naming.reading import read_names
from armproof.verification.verdict import DocumentResult

PRINTED = (".md", ".qmd", ".ipynb", ".tex", ".rst")
DEFAULT = "sketch"
_ANY = "planar_2r"  # what a figure that shows no arm in particular is given


@dataclass(frozen=True)
class Edition:
    """What is to be printed: a draft, the solutions, and the language (None: the document's own)."""

    draft: bool = False
    solutions: bool = False
    lang: str | None = None


def make_sheet(document: Document, result: DocumentResult, edition: Edition, figures: Path) -> Sheet:
    """Return the sheet of a document that was checked.

    Args:
        document: the document as read.
        result: its verdicts.
        edition: which of the editions.
        figures: a folder into which the arm's figures are drawn.

    Raises:
        PrintError: the document does not pass and no draft is asked for; it is of a format that is not printed; a display
            has no verdict; its language or its figures are unknown.
    """
    if not (result.passed or edition.draft):
        raise PrintError("{path}: it does not pass, so it is not printed; --draft prints it as a draft", path=document.path)  # fmt: skip
    lang = existing_language(edition.lang or str(document.front.get("lang") or document.front.get("language") or "en"))
    document = _in_language(document, lang)
    arm = arm_of(document.front, document.path.parent)
    inline = InlineReader(read_names(arm, document.front).reader.read, document.path.parent, lang)
    bodies = _bodies(document.path, lang)
    reader = BlockReader(inline, result, number_equations(result.equations, bodies))
    blocks = [block for body in bodies for block in reader.read(body)]
    reader.close()
    title, blocks = _titled(document, blocks, inline)
    warnings = [*reader.warnings, *(warning for body in bodies for warning in body.warnings)]
    if edition.solutions and not has_solutions(blocks):
        warnings.append(written(
            "{path}: no solution in it: one is a section or a block quote that begins with 'Solution'",
            path=document.path))  # fmt: skip
    chosen = with_solutions(blocks) if edition.solutions else for_students(blocks)
    drawn = draw_figures(document, arm, lang, lambda text: _inline(text, inline), figures, edition.solutions)
    illustrated = _with_figures(chosen, drawn, lang)
    source = _inline(str(document.front.get("source") or ""), inline)
    name = arm.name if arm is not None else ""
    return Sheet(title, source, lang, name, illustrated, edition.draft, edition.solutions, tuple(warnings))


def _in_language(document: Document, lang: str) -> Document:
    """Return a document whose title and source are in a language, as its catalogue has them."""
    translate = translation_of(document.path, lang)
    said = {key: document.front.get(key) for key in ("title", "source")}
    told = {key: translated_sentence(text, translate) for key, text in said.items() if isinstance(text, str)}
    return replace(document, front={**document.front, **told})


def _bodies(path: Path, lang: str) -> list[Body]:
    """Return the Markdown of a document in a language."""
    if path.suffix not in PRINTED:
        raise PrintError("{path}: '{suffix}' files are not printed; those that are: {printed}",
            path=path, suffix=path.suffix, printed=list(PRINTED))  # fmt: skip
    if path.suffix in (".tex", ".rst"):
        return [_made_body(path, read_any_text(path)[0])]
    text = read_text(path)
    if path.suffix != ".ipynb":
        _, body, first = split_front_matter(path, in_language(path, text, lang))
        return [Body(body, first)]
    return [Body(*part) for part in split_cells(path, read_cells(path, text))[1]]


def _made_body(path: Path, text: str) -> Body:
    """Return the Markdown that LaTeX or reStructuredText is made into."""
    try:
        return tex_body(path, text) if path.suffix == ".tex" else _rst_body(path, text)
    except RecursionError:
        raise PrintError("{path}: nested too deeply to be printed", path=path) from None


def _rst_body(path: Path, text: str) -> Body:
    if find_spec("docutils") is None:
        raise PrintError("reStructuredText is read by docutils, which is not installed: pip install 'armproof[print]'")
    from armproof.course.printing.rst import rst_body

    return rst_body(path, text)


def _titled(document: Document, blocks: list[Block], inline: InlineReader) -> tuple[tuple[Inline, ...], list[Block]]:
    """Return the title, and the blocks without the heading that repeats it."""
    first = next((block for block in blocks if isinstance(block, Heading)), None)
    heading = first if first is not None and first.level == 1 else None
    named = _inline(str(document.front.get("title") or ""), inline)
    title = heading.parts if heading is not None else named or (Text(document.path.stem),)
    if heading is not None and (not named or plain(heading.parts) == plain(named)):
        return title, [block for block in blocks if block is not heading]
    return named or title, blocks


def _inline(text: str, inline: InlineReader) -> tuple[Inline, ...]:
    tokens = markdown_reader().parseInline(text)
    return inline.parts(tokens[0].children or []) if tokens else ()


def _with_figures(blocks: tuple[Block, ...], drawn: list[Picture], lang: str) -> tuple[Block, ...]:
    """Return the blocks with the first figure behind the introduction and the others at the end."""
    if not drawn:
        return blocks
    at = next((k for k, block in enumerate(blocks) if isinstance(block, Heading) and block.level > 1), len(blocks))
    rest: tuple[Block, ...] = (Heading(2, (Text(say("figures", lang)),)), *drawn[1:]) if len(drawn) > 1 else ()
    return (*blocks[:at], drawn[0], *blocks[at:], *rest)


def figure_names(document: Document, arm: Arm | None, solutions: bool = False) -> dict[str, Arm]:
    """Return the names of a document's figures with their arms: `figures: [sketch, {quintic: scara}, {solutions: singular}]`.

    Without the key, the arm's sketch. A name stands for a figure of the document's arm, one with another arm for that
    arm's; what `solutions` names belongs to the edition with solutions. What shows no arm in particular needs none.

    Raises:
        PrintError: the key holds something else than names, or there is no arm to draw.
    """
    named = document.front.get("figures")
    if named is None and "figures" not in document.front:
        return {DEFAULT: arm} if arm is not None and find_kind(DEFAULT).applies(arm, "en") is None else {}
    entries = [] if named is None else named if isinstance(named, list) else [named]
    shown = [_entry(document, entry) for entry in entries]
    found: dict[str, Arm] = {}
    for name, spec, is_answer in shown:
        own = load_arm(spec or _ANY) if spec or find_kind(name).general else arm
        if own is None:
            raise PrintError("{place}: figures are drawn of an arm, and this document names none", place=document.at("figures"))  # fmt: skip
        if solutions or not is_answer:
            found.setdefault(name, own)
    return found


def _entry(document: Document, entry: object) -> tuple[str, str, bool]:
    """Return the name of a figure, the arm that is named for it, and whether it belongs to the solutions."""
    key, value = next(iter(entry.items())) if isinstance(entry, dict) and len(entry) == 1 else (entry, "")
    name, spec = (value, "") if key == "solutions" else (key, value)
    is_pair = isinstance(entry, dict) and (key == "solutions" or (key in KINDS and spec != ""))
    if not (isinstance(name, str) and isinstance(spec, str) and (is_pair or isinstance(entry, str))):
        raise PrintError("{place}: 'figures' is a list of names such as [sketch, {{solutions: singular}}], not {named}",
            place=document.at("figures"), named=repr(document.front.get("figures")))  # fmt: skip
    find_kind(name)
    return name, spec, key == "solutions"


def draw_figures(
    document: Document,
    arm: Arm | None,
    lang: str,
    words: Callable[[str], tuple[Inline, ...]],
    folder: Path,
    solutions: bool = False,
) -> list[Picture]:
    """Draw the figures of a document into a folder, and return them with their captions, in the order named.

    They lose the empty paper above and below the drawing.

    Raises:
        PrintError: see `figure_names`.
        FigureError: an unknown figure.
    """
    pictures = []
    for name, drawn in figure_names(document, arm, solutions).items():
        kind = find_kind(name)
        figure = draw_kind(kind, drawn, lang)
        path = save_figure(figure, folder / f"{kind.name}.svg", trimmed=True)
        pictures.append(Picture(path, figure.get_size_inches()[0] / MM, words(caption_kind(kind, drawn, lang))))
    return pictures
