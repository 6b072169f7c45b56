"""Read the LaTeX of one display into statements."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from importlib import resources

from lark import Lark, Token, Tree
from lark.exceptions import UnexpectedInput, UnexpectedToken, VisitError

from armproof.models.errors import Sentence
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.builder import TreeBuilder
from armproof.verification.latex.equation_numbers import either_factor, without_numbers
from armproof.verification.latex.greek import SPELT
from armproof.verification.latex.preparing import prepared
from armproof.verification.latex.tokens import LatexLexer, Spelling
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.patterns import regex

MAX_LENGTH = 100_000
_WHOLE = regex("[0-9]{1,9}")
_READABLE = {
    "$END": Sentence("the end"), "REL": Sentence("a relation such as ="), "RPAR": "')'", "RBRACE": "'}'", "LPAR": "'('", "LBRACE": "'{'", "PLUS": "'+'",
    "MINUS": "'-'", "AMP": "'&'", "NEWLINE": r"'\\'", "LETTER": Sentence("a name"), "NUMBER": Sentence("a number"), "END": r"'\end{…}'", "FUNC": Sentence("a function"),
    "COMMA": "','", "CLOSE_BAR": "'|'", "CLOSE_SET": r"'\}'", "CLOSE_EMPTY": r"'\right'",
}  # fmt: skip


class Reader:
    """Reads displays; `is_bound` tells the names the front matter binds, `words` the multi-letter ones among them."""

    def __init__(
        self, is_bound: Callable[[str], bool] = lambda key: False, words: frozenset[str] = frozenset()
    ) -> None:
        self.is_bound = is_bound
        self.words = words
        self.spelling = Spelling(words)

    def read(self, latex: str) -> list[n.Statement]:
        """Return the statements of a display; raises ReadError with the place and the token."""
        if len(latex) > MAX_LENGTH:
            raise ReadError(say(Kind.TOO_LONG, length=len(latex), most=MAX_LENGTH))
        return self._parse(latex)

    def read_expression(self, latex: str, offset: int = 0) -> n.Node:
        """Return the one expression that a piece of LaTeX holds (a front-matter name, a subscript).

        `offset` is the piece's place in its display; leading blanks put the spans of the nodes there.
        """
        offset = max(offset, 0)
        if _WHOLE.fullmatch(latex):  # as most exponents are
            return n.Number(Fraction(latex), latex, span=(offset, offset + len(latex)))
        statements = self._parse(" " * offset + latex)
        if len(statements) != 1 or not isinstance(statements[0], n.Chain) or len(statements[0].members) != 1:
            raise ReadError(say(Kind.NOT_ONE_EXPRESSION, text=latex.strip()), offset)
        return statements[0].members[0]

    def key_of(self, latex: str) -> str:
        """Return the key of the name that a formula is, "" of another formula or of what cannot be read."""
        try:
            return n.bare_key(self.read_expression(latex)) or ""
        except ReadError:
            return ""

    def _parse(self, latex: str) -> list[n.Statement]:
        """Return the statements of a text; one that was read before is read anew only where another of its names is bound."""
        known = _known_readings(latex, self.spelling)
        for bound, statements in known:
            if all(self.is_bound(name) == said for name, said in bound.items()):
                return list(statements)
        asked: dict[str, bool] = {}

        def is_bound(name: str) -> bool:
            return asked.setdefault(name, self.is_bound(name))

        reader = Reader(is_bound, self.words)
        reader.spelling = self.spelling
        statements = reader._build(latex)
        known.append((asked, statements))
        return list(statements)

    def _build(self, latex: str) -> list[n.Statement]:
        text = prepared(normalise_unicode(latex))
        plain = without_numbers(text)
        if plain is None:
            return self._transformed(text)
        try:
            without = self._transformed(plain)
        except ReadError:  # what stands before it asks for what is in its brackets: \cos \, (2)
            return self._transformed(text)
        try:
            return either_factor(text, self._transformed(text), without)
        except ReadError:
            return without

    def _transformed(self, text: str) -> list[n.Statement]:
        try:
            tree: Tree = _grammar().parse((text, self.spelling))  # type: ignore[arg-type]
            return TreeBuilder(text, self.is_bound, self.read_expression, self.spelling).transform(tree)  # type: ignore[return-value]
        except UnexpectedToken as error:
            raise _unbalanced(text, self.spelling) or _unexpected(error, text) from None
        except UnexpectedInput as error:
            raise ReadError(str(error).splitlines()[0]) from None
        except VisitError as error:
            if isinstance(error.orig_exc, ReadError):
                raise error.orig_exc from None
            if isinstance(error.orig_exc, RecursionError):
                raise ReadError(say(Kind.NESTED)) from None
            raise
        except RecursionError:
            raise ReadError(say(Kind.NESTED)) from None


def _unbalanced(text: str, spelling: Spelling) -> ReadError | None:
    """Return where a parenthesis is that has no partner, if one has none: what was met only afterwards tells little."""
    opened: list[Token] = []
    for token in LatexLexer(None).lex((text, spelling)):
        if token.type in ("LPAR", "LBRACE", "BEGIN"):
            opened.append(token)
        elif token.type not in ("RPAR", "RBRACE", "END", "NEWLINE", "AMP"):
            continue
        elif opened and opened[-1].type == "LPAR" and token.type != "RPAR":
            break
        elif token.type == "RPAR" and not (opened and opened[-1].type == "LPAR"):
            return ReadError(say(Kind.PARENTHESIS_CLOSES_NOTHING, text=token.value), token.start_pos or 0)
        elif token.type in ("RPAR", "RBRACE", "END"):
            opened = opened[:-1]
    if not opened or opened[-1].type != "LPAR":
        return None
    return ReadError(say(Kind.PARENTHESIS_OPEN, text=opened[-1].value), opened[-1].start_pos or 0)


def _unexpected(error: UnexpectedToken, text: str) -> ReadError:
    token = error.token
    expected = sorted({_READABLE[name] for name in error.accepts if name in _READABLE})
    if token.type == "$END":
        early = say(Kind.ENDS_TOO_EARLY_BUT, expected=expected) if expected else say(Kind.ENDS_TOO_EARLY)
        return ReadError(early, len(text))
    found = text[token.start_pos : token.end_pos].strip() or token.value
    if len(found) > 40:
        found = found[:37] + "…"
    unexpected = (
        say(Kind.UNEXPECTED_BUT, text=found, expected=expected) if expected else say(Kind.UNEXPECTED, text=found)
    )
    return ReadError(unexpected, token.start_pos or 0)


@lru_cache(maxsize=1024)
def _known_readings(latex: str, spelling: Spelling) -> list[tuple[dict[str, bool], list[n.Statement]]]:
    """Return the list of what a text so spelt was read as, each with the names asked for and whether they were bound."""
    return []


@lru_cache(maxsize=1)
def _grammar() -> Lark:
    grammar = resources.files("armproof.verification.latex").joinpath("kinematics.lark").read_text(encoding="utf-8")
    return Lark(grammar, parser="lalr", lexer=LatexLexer)


def key_as_latex(key: str) -> str:
    """Write a front-matter name as LaTeX: `theta_12` → `\\theta_{12}`, `J'_P` as it stands, `T_w^tool` braced."""
    # pre-scripts are one digit, or braced
    return re.sub(r"(?<=[A-Za-z0-9'])([_^])([A-Za-z0-9]{2,})", r"\1{\2}", SPELT.sub(r"\\\1", key))
