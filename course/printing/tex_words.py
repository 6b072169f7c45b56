r"""The words of a LaTeX document as Markdown: styles, accents, formulas, references, footnotes."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from unicodedata import normalize

from armproof.course.sheet.body import escaped
from armproof.verification.document.tex_macros import closing_brace

TOKEN = re.compile(
    r"\\(?:verb|lstinline)\*?(?P<bar>[^\w\s*{\[])(?P<verb>.*?)(?P=bar)|\\begin\s*\{(?P<begin>\w+\*?)\}|\\end\s*\{(?P<end>\w+\*?)\}|(?<!\\)\$(?P<dollars>[^$]+)\$|\\\((?P<round>.+?)\\\)"
    r"|\\(?P<accent>['`^\"~=.]|[cvuHrk](?=\s*\{|\s+\w))\s*(?:\{\s*\\?(?P<braced>\w)\s*\}|\\?(?P<bare>[A-Za-z]))"
    r"|\\(?P<command>[A-Za-z]+)\*?|\\(?P<sign>.)|(?P<group>\{)|(?P<close>\})|(?P<gap>\n[ \t]*\n\s*)|(?P<typed>~|``|''|---?)",
    re.DOTALL,
)
_ACCENTS = dict(zip("'`^\"~=.cvuHrk", "\u0301\u0300\u0302\u0308\u0303\u0304\u0307\u0327\u030c\u0306\u030b\u030a\u0328", strict=True))  # fmt: skip
_TYPED = {"~": "\u00a0", "``": "“", "''": "”", "--": "–", "---": "—"}
_SIGNS = {"\\": "<br>", " ": " ", "/": "", ",": "\u202f", ";": " ", ":": " ", "!": "", "-": "", "@": ""}
_LETTERS = {
    "oe": "œ", "OE": "Œ", "ae": "æ", "AE": "Æ", "ss": "ß", "o": "ø", "O": "Ø", "aa": "å", "i": "i", "j": "j", "ldots": "…", "dots": "…",
    "textellipsis": "…", "og": "«\u00a0", "fg": "\u00a0»", "guillemotleft": "«", "guillemotright": "»", "S": "§", "P": "¶", "copyright": "©",
    "degree": "°", "textdegree": "°", "LaTeX": "LaTeX", "TeX": "TeX", "quad": " ", "qquad": " ", "enspace": " ", "newline": "<br>", "no": "n° ",
    "textbackslash": "\\\\", "textasciitilde": "\\~", "ier": "er", "iere": "re", "ieme": "e", "textendash": "–", "textemdash": "—", "today": "",
}  # fmt: skip
_STYLES = {  # and the marks of Markdown
    **dict.fromkeys("textbf bf bfseries".split(), "**"),
    **dict.fromkeys("textit emph textsl it itshape em sl".split(), "*"),
}
_DROPPED = {  # with the number of their arguments
    **dict.fromkeys("maketitle tableofcontents newpage clearpage pagebreak noindent indent centering raggedright raggedleft bigskip medskip smallskip "
        "hfill vfill hrule small footnotesize scriptsize tiny normalsize large Large LARGE huge Huge par protect relax appendix sloppy nobreak "
        "normalfont rm sf tt sffamily rmfamily upshape mdseries displaystyle null strut linebreak nolinebreak allowbreak break "
        "frontmatter mainmatter backmatter columnbreak pause selectfont boldmath unboldmath listoffigures listoftables".split(), 0),
    **dict.fromkeys("label vspace hspace pagestyle thispagestyle bibliographystyle bibliography usepackage index author date color phantom "
        "vphantom hphantom pagenumbering selectlanguage graphicspath hypersetup captionsetup nocite".split(), 1),
    **dict.fromkeys("setlength addtolength setcounter addtocounter rule fontsize".split(), 2),
    "addcontentsline": 3,
}  # fmt: skip
_KEPT = set(
    "text textrm textsf textnormal textup underline mbox hbox fbox makebox centerline textsc uline textsuperscript ensuremath".split()
)


@dataclass
class TexWords:
    """Reads words; `unknown` are the commands that mean nothing to it, each with the line where it was met first."""

    line: int = 1
    unknown: dict[str, int] = field(default_factory=dict)

    def read(self, text: str) -> str:
        """Return words without blocks as Markdown, on one line."""
        out, at = "", 0
        while (token := TOKEN.search(text, at)) is not None:
            out += escaped(text[at : token.start()])
            written, at = self.token(text, token)
            out += written
        return re.sub(r"\s+", " ", out + escaped(text[at:])).strip()

    def token(self, text: str, token: re.Match[str]) -> tuple[str, int]:
        """Return what one token of a paragraph is in Markdown, and the place behind it and its arguments."""
        at = token.end()
        if token["bar"]:
            return f"`{token['verb']}`", at
        if latex := token["dollars"] or token["round"]:
            return f"${' '.join(latex.split())}$", at
        if token["accent"]:
            return normalize("NFC", (token["braced"] or token["bare"]) + _ACCENTS[token["accent"]]), at
        if token["sign"]:
            end = option(text, at)[1] if token["sign"] == "\\" else at
            return _SIGNS.get(token["sign"], escaped(token["sign"])), end
        if token["typed"]:
            return _TYPED[token["typed"]], at
        if token["group"]:
            close = closing_brace(text, token.start())
            inside, at = (text[at:close], close + 1) if close >= 0 else (text[at:], len(text))
            return self._group(inside), at
        return self._command(token["command"], text, at) if token["command"] else (" ", at)

    def _group(self, inside: str) -> str:
        r"""Return the words of a group; one that begins with a style, {\bf so}, is in it."""
        found = re.match(r"\s*\\([A-Za-z]+)", inside)
        mark = _STYLES.get(found[1]) if found else None
        return _styled(mark, self.read(inside[found.end() :])) if found and mark else self.read(inside)

    def _command(self, name: str, text: str, at: int) -> tuple[str, int]:
        if name in _LETTERS:
            return _LETTERS[name], _swallowed(text, at)
        if name in _STYLES:
            words, end = argument(text, at) if name.startswith(("text", "emph")) else ("", at)
            return _styled(_STYLES[name], self.read(words)), end
        if name in ("ref", "eqref", "cref", "autoref", "Cref"):
            label, end = argument(text, at)
            return f"\\{'ref' if name == 'ref' else 'eqref'}{{{label.strip()}}}", end
        if name in ("texttt", "verb", "lstinline", "url", "path"):
            words, end = argument(text, at)
            return (f"<{words.strip()}>" if name == "url" else f"`{_plain(words)}`" if words else ""), end
        if name == "href":
            target, at = argument(text, at)
            words, end = argument(text, at)
            return f"[{self.read(words)}](<{target.strip()}>)", end
        if name in ("footnote", "thanks"):
            words, end = argument(text, at)
            return f" ({self.read(words)})", end
        if name.startswith("cite"):
            words, end = argument(text, option(text, at)[1])
            return f"\\[{self.read(words)}\\]", end
        if name in _DROPPED:
            at = option(text, at)[1] if _DROPPED[name] else _swallowed(text, at)
            for _ in range(_DROPPED[name]):
                _, at = argument(text, at)
            return " " if name.startswith("h") else "", at
        if name == "textcolor":
            at = argument(text, at)[1]
        elif name not in _KEPT:
            self.unknown.setdefault(f"\\{name}", self.line)
        words, end = argument(text, at, optional=True)
        return self.read(words), end


def argument(text: str, at: int, *, optional: bool = False) -> tuple[str, int]:
    r"""Return the argument of a command, {so} or the next sign, and the place behind it."""
    at = option(text, at)[1]
    found = re.compile(r"\s*\{").match(text, at)
    if found is None:
        bare = None if optional else re.compile(r"\s*(\\[A-Za-z]+|\S)").match(text, at)
        return (bare[1], bare.end()) if bare else ("", _swallowed(text, at))
    close = closing_brace(text, found.end() - 1)
    return (text[found.end() : close], close + 1) if close >= 0 else (text[found.end() :], len(text))


def option(text: str, at: int) -> tuple[str, int]:
    """Return the option of a command, [so], and the place behind it."""
    found = re.compile(r"[ \t]*\[((?:[^][{}]|\{[^{}]*\})*)\]").match(text, at)
    return (found[1], found.end()) if found else ("", at)


def _swallowed(text: str, at: int) -> int:
    """Return the place behind the blank that ends a command's name."""
    return at + 1 if text[at : at + 1] in (" ", "\n") and text[at : at + 2] != "\n\n" else at


def _styled(mark: str, words: str) -> str:
    return f"{mark}{words}{mark}" if words else ""


def _plain(code: str) -> str:
    r"""Return code without the backslashes of LaTeX before its signs: p\_2."""
    return re.sub(r"\\([_%&#${}])", r"\1", code)
