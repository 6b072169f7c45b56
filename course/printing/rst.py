"""The text of a reStructuredText document as Markdown, for its sheet: read by docutils, no file included and nothing raw.

A directive that docutils does not know (of Sphinx, or of the author's own) is a quote under its name: the reader of the
verification finds displays in all of them.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.core import publish_doctree
from docutils.parsers.rst import Directive, directives, roles
from docutils.parsers.rst.languages import en

from armproof.course.sheet.body import Body, MarkdownLines, escaped
from armproof.models.errors import written
from armproof.verification.document.rst import is_whole

_SETTINGS = {
    "file_insertion_enabled": False,
    "raw_enabled": False,
    "report_level": 5,
    "halt_level": 5,
    "syntax_highlight": "none",
    "_disable_config": True,
}
_ERRATUM = re.compile(r"errat(?:um|a)\b", re.IGNORECASE)
_SOLUTION = re.compile(r"(?:worked[ -]?)?(?:solution|corrig[ée])s?\b", re.IGNORECASE)
_UNSEEN = ("comment", "docinfo", "substitution_definition", "target", "field_list", "pending", "decoration", "meta")
_DROPPED = (
    "toctree",
    "index",
    "contents",
    "sectnum",
    "include",
    "raw",
    "bibliography",
    "highlight",
    "default-role",
    "only",
)
_ADMONITIONS = ("attention", "caution", "danger", "error", "hint", "important", "note", "tip", "warning", "seealso")
_MARKS = {"strong": "**", "emphasis": "*", "title_reference": "*"}


def rst_body(path: Path, text: str) -> Body:
    """Return a reStructuredText document as Markdown."""
    directives.register_directive("math", _Math)
    for name in set(re.findall(r"^[ \t]*\.\. ([\w:-]+)::", text, re.MULTILINE)) - {*en.directives, "math"}:
        directives.register_directive(name, _Dropped if name in _DROPPED else _Named)
    roles.register_local_role("eq", _equation)  # type: ignore[arg-type]
    for name in ("ref", "numref", "doc", "term", "class", "func", "meth", "mod", "file"):
        roles.register_local_role(name, _words)  # type: ignore[arg-type]
    writer = _Writer()
    writer.block(publish_doctree(text, settings_overrides=_SETTINGS))
    return writer.out.body(
        [written("{path}:{line}: not printed: {reason}", path=path, line=line, reason=reason) for line, reason in writer.faults]
    )  # fmt: skip


# -- what docutils reads otherwise ---------------------------------------------------------------------------------


def _any_option() -> dict[str, Callable[[str], Any]]:
    return defaultdict(lambda: directives.unchanged, {"class": directives.unchanged})


class _Math(Directive):
    """Displays: blank lines stand between them, but not within an environment."""

    optional_arguments, final_argument_whitespace, has_content = 1, True, True
    option_spec = _any_option()

    def run(self) -> list[nodes.Node]:
        found = list(_equations(self.arguments[0].split("\n") if self.arguments else []))
        found += _equations(list(self.content))
        blocks = [nodes.math_block(latex, latex) for latex in found]
        for block in blocks:
            block.line = self.lineno
        if blocks:
            blocks[-1]["label"] = self.options.get("label") or self.options.get("name") or ""
        return [*blocks]


def _equations(lines: list[str]) -> Iterator[str]:
    group: list[str] = []
    for line in [*lines, ""]:
        if line.strip():
            group.append(line)
        elif group and is_whole("\n".join(group)):
            yield "\n".join(group)
            group = []
    if group:
        yield "\n".join(group)


class _Named(Directive):
    """A quote under the name of its directive."""

    optional_arguments, final_argument_whitespace, has_content = 1, True, True
    option_spec = _any_option()

    def run(self) -> list[nodes.Node]:
        node = nodes.admonition("", name=self.name, title=" ".join(self.arguments))
        node.line = self.lineno
        self.state.nested_parse(self.content, self.content_offset, node)
        return [node]


class _Dropped(_Named):
    """What stands for something else than words."""

    def run(self) -> list[nodes.Node]:
        return []


def _equation(name: str, raw: str, text: str, *_: Any, **__: Any) -> tuple[list[nodes.Node], list[Any]]:
    return [nodes.inline(raw, f"{{eq}}`{text}`", classes=["reference"])], []


def _words(name: str, raw: str, text: str, *_: Any, **__: Any) -> tuple[list[nodes.Node], list[Any]]:
    return [nodes.emphasis(raw, text.split("<")[0].strip() or text)], []


# -- Markdown ------------------------------------------------------------------------------------------------------


class _Writer:
    """Writes the blocks of a document; `faults` are what docutils does not understand, with the lines."""

    def __init__(self) -> None:
        self.out = MarkdownLines()
        self.faults: list[tuple[int, str]] = []
        self.level = 1

    def block(self, node: nodes.Node) -> None:
        """Write a block and those in it."""
        self.out.place = getattr(node, "line", None) or self.out.place
        kind = node.tagname if isinstance(node, nodes.Element) else "#text"
        if kind in _UNSEEN or not isinstance(node, nodes.Element):
            return
        own = getattr(self, f"_{kind}", None)
        if own is not None:
            own(node)
        elif kind in _ADMONITIONS:
            self._quote(node, f"**{kind.capitalize()}.**")
        elif isinstance(node, nodes.TextElement):
            self.out.write(self.inline(node))
        else:
            self._all(node)

    def _all(self, node: nodes.Element) -> None:
        for child in node.children:
            self.block(child)

    def _section(self, node: nodes.Element) -> None:
        self.level += 1
        self._all(node)
        self.level -= 1

    def _title(self, node: nodes.Element) -> None:
        self.out.write(f"{'#' * min(6, self.level)} {self.inline(node)}")

    def _math_block(self, node: nodes.Element) -> None:
        label = node.get("label")
        self.out.write(f"$$ {' '.join(node.astext().split())} $$" + (f" ({label})" if label else ""))

    def _literal_block(self, node: nodes.Element) -> None:
        self.out.write(f"```\n{node.astext()}\n```")

    _doctest_block = _literal_block

    def _bullet_list(self, node: nodes.Element, mark: str = "-") -> None:
        self.out.enter(mark)
        for item in node.children:
            self.out.mark()
            self.block(item)
        self.out.leave()

    def _enumerated_list(self, node: nodes.Element) -> None:
        self._bullet_list(node, f"{node.get('start', 1)}.")

    def _definition_list_item(self, node: nodes.Element) -> None:
        self.out.write(f"**{self.inline(node[0])}**")
        for child in node.children[1:]:
            self.block(child)

    def _block_quote(self, node: nodes.Element) -> None:
        self._quote(node, "")

    def _admonition(self, node: nodes.Element) -> None:
        name, title = str(node.get("name", "")), escaped(str(node.get("title", "")))
        if not name:  # `.. admonition:: Title`
            title = self.inline(node[0])
            node = nodes.admonition("", *node.children[1:])
        word = next((word for word, found in (("Erratum", _ERRATUM), ("Solution", _SOLUTION)) if found.match(name)), "")
        head = f"**{word}**{f' ({title})' if title else ''}" if word else f"**{title or escaped(name.capitalize())}**"
        self._quote(node, head)

    def _quote(self, node: nodes.Element, head: str) -> None:
        self.out.enter("> ")
        if head:
            self.out.write(head)
        self._all(node)
        self.out.leave()

    def _image(self, node: nodes.Element, caption: str = "") -> None:
        self.out.write(f"![{caption or escaped(node.get('alt', ''))}]({str(node['uri']).replace(' ', '%20')})")

    def _figure(self, node: nodes.Element) -> None:
        caption = next((self.inline(child) for child in node.children if isinstance(child, nodes.caption)), "")
        for child in node.children:
            if isinstance(child, nodes.image):
                self._image(child, caption)
            elif not isinstance(child, nodes.caption):
                self.block(child)

    def _table(self, node: nodes.Element) -> None:
        rows = [[cell for entry in row.children for cell in self._cells(entry)] for row in node.findall(nodes.row)]
        if not any(node.findall(nodes.thead)):
            rows.insert(0, [" "] * len(rows[0]))
        self.out.table(rows)
        if isinstance(node[0], nodes.title):
            self.out.write(f"*{self.inline(node[0])}*")

    def _cells(self, entry: nodes.Node) -> list[str]:
        assert isinstance(entry, nodes.Element)
        words = "<br>".join(self.inline(child) for child in entry.children)
        return [words or " ", *[" "] * int(entry.get("morecols", 0))]

    def _footnote(self, node: nodes.Element) -> None:
        self.out.write(
            f"\\[{escaped(node[0].astext())}\\] {' '.join(self.inline(child) for child in node.children[1:])}"
        )

    def _system_message(self, node: nodes.Element) -> None:
        self.faults.append((int(node.get("line", self.out.place)), " ".join(node[0].astext().split())))

    # -- words ------------------------------------------------------------------------------------------------------

    def inline(self, node: nodes.Node) -> str:
        """Return the words in a node as Markdown, on one line."""
        return " ".join("".join(map(self._part, node.children)).split(" ")).replace("\n", " ").strip()

    def _part(self, node: nodes.Node) -> str:
        if isinstance(node, nodes.Text):
            return escaped(node.astext())
        assert isinstance(node, nodes.Element)
        kind = node.tagname
        if kind == "math":
            return f"${' '.join(node.astext().split())}$"
        if kind == "literal":
            return f"`{node.astext()}`"
        if "reference" in node.get("classes", ()):
            return node.astext()
        if kind == "reference" and node.get("refuri"):
            return f"[{self.inline(node)}](<{node['refuri']}>)"
        if kind in ("footnote_reference", "citation_reference"):
            return f"\\[{self.inline(node)}\\]"
        if kind == "image":
            return escaped(str(node.get("alt", "")))
        mark = _MARKS.get(kind, "")
        return f"{mark}{self.inline(node)}{mark}"
