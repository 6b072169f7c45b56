"""The entries of a DH table: sums of rational multiples of symbols, pi and degrees, read without eval."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite, pi

from armproof.models.errors import Fault, ModelError

FORMS = "0, 0.75, 3/4, pi/2, -pi, 90deg, l_1, -d_2, d_1 + d_4, theta_2 - pi/2"
_TOKEN = re.compile(
    r"\s*(?:(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)|(deg\b|°)|(π|[A-Za-z]\w*'*)|([-+*/()]))"
)
_FUNCTIONS = frozenset(
    ["sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "arcsin", "arccos", "arctan", "exp", "ln", "log"]
)
_MAX_DEPTH = 20
_LONGEST = 60


_LATEX = (
    (re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}"), r"(\1)/(\2)"),
    (re.compile(r"\s*\^\s*(?:\{\s*(?:\\circ|\*|\\ast|\\star)\s*\}|\\circ|\*|\\ast|\\star)"), lambda mark: "deg" if "circ" in mark[0] else ""),
    (re.compile(r"\s*_\s*\{\s*([\w\s,]*?)\s*\}"), lambda index: "_" + re.sub(r"[\s,]", "", index[1])),
    (re.compile(r"\\(?:cdot|times)(?![A-Za-z])"), "*"),
    (re.compile(r"\\(?:left|right|,|;|!|:)|\$|~|\\(?=[A-Za-z])"), ""),
    (re.compile(r"(\d+(?:\.\d+)?)\s*(?:(mm)|(cm)|m)(?![A-Za-z_])"), lambda length: f"{length[1]}{'/1000' if length[2] else '/100' if length[3] else ''}"),
)  # fmt: skip


def as_typed(text: str) -> str:
    r"""Return entries in LaTeX as they are typed: `\theta_{1} - \frac{\pi}{2}` as theta_1 - (pi)/(2), 350 mm as 350/1000."""
    text = text.replace("\theta", "theta").replace("\alpha", "alpha")  # what YAML makes of "\theta" between quotes
    for pattern, plain in _LATEX:
        text = pattern.sub(plain, text)
    return text


@dataclass(frozen=True)
class LinearForm:
    """A sum: coefficients of symbols, a rational multiple of pi, and a rational number (m in a length, rad in an angle)."""

    symbols: tuple[tuple[str, Fraction], ...] = ()
    pi: Fraction = Fraction(0)
    number: Fraction = Fraction(0)

    def coefficient(self, symbol: str) -> Fraction:
        """Return the coefficient of a symbol, 0 if it does not occur."""
        return dict(self.symbols).get(symbol, Fraction(0))

    def without(self, symbol: str) -> LinearForm:
        """Return the form less its term in a symbol."""
        return LinearForm(tuple(term for term in self.symbols if term[0] != symbol), self.pi, self.number)

    def value(self, values: dict[str, float]) -> float:
        """Return the number that the form is for values of its symbols."""
        terms = (float(coefficient) * values[symbol] for symbol, coefficient in self.symbols)
        return sum(terms, float(self.pi) * pi + float(self.number))

    def __str__(self) -> str:
        terms = [*self.symbols, ("pi", self.pi)]
        products = [f"({coefficient}) * {symbol}" for symbol, coefficient in terms if coefficient]
        return " + ".join([*products, f"({self.number})"])

    @property
    def is_number(self) -> bool:
        """Whether the form is a plain rational number."""
        return not self.symbols and not self.pi


def read_entry(value: object) -> LinearForm:
    """Read an entry of a DH table: a number, or text such as "theta_2 - pi/2".

    Raises:
        ModelError: not such an entry; the message says what was met.
    """
    finite = isinstance(value, str) or (isinstance(value, int | float) and isfinite(value))
    if isinstance(value, bool) or not finite:
        raise ModelError(Fault.ENTRY_NOT_FINITE, value=repr(value), forms=FORMS)
    return _Reader(repr(value) if isinstance(value, float) else as_typed(str(value))).read()


class _Reader:
    """A recursive-descent reader: sum of terms, term of factors, factor a number, a symbol or a sum in parentheses."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens: list[str] = []
        self.position = 0
        self.depth = 0
        end = 0
        while text[end:].strip():
            match = _TOKEN.match(text, end)
            if not match:
                raise self.error(Fault.NO_CHARACTER, found=text[end:].strip()[0])
            self.tokens.append(next(group for group in match.groups() if group is not None))
            end = match.end()

    def error(self, kind: Fault, **terms: str) -> ModelError:
        text = self.text if len(self.text) <= _LONGEST else f"{self.text[:_LONGEST]}…"
        return ModelError(Fault.ENTRY_UNREADABLE, text=text, reason=ModelError(kind, **terms), forms=FORMS)

    def read(self) -> LinearForm:
        if not self.tokens:
            raise self.error(Fault.ENTRY_EMPTY)
        form = self.sum()
        if self.peek():
            raise self.error(Fault.UNEXPECTED_HERE, found=self.peek())
        return form

    def peek(self) -> str:
        return self.tokens[self.position] if self.position < len(self.tokens) else ""

    def next(self) -> str:
        token = self.peek()
        self.position += 1
        return token

    def sum(self) -> LinearForm:
        total = self.term()
        while self.peek() in ("+", "-"):
            sign = 1 if self.next() == "+" else -1
            total = _add(total, _scale(self.term(), Fraction(sign)))
        return total

    def term(self) -> LinearForm:
        product = self.factor()
        while self.peek() and self.peek() not in ("+", "-", ")"):
            if self.peek() == "/":
                self.next()
                divisor = self.factor()
                if not divisor.is_number or not divisor.number:
                    raise self.error(Fault.NO_DIVISOR)
                product = _scale(product, 1 / divisor.number)
                continue
            if self.peek() == "*":
                self.next()
            elif self.peek()[0].isdigit() or self.peek()[0] == ".":
                raise self.error(Fault.UNEXPECTED_HERE, found=self.peek())
            right = self.factor()
            if product.is_number:
                product = _scale(right, product.number)
            elif right.is_number:
                product = _scale(product, right.number)
            else:
                raise self.error(Fault.PRODUCT)
        return product

    def factor(self) -> LinearForm:
        token = self.next()
        if token in ("+", "-", "("):
            self.depth += 1
            if self.depth > _MAX_DEPTH:
                raise self.error(Fault.TOO_DEEP)
            form = self.sum() if token == "(" else _scale(self.factor(), Fraction(-1 if token == "-" else 1))
            self.depth -= 1
            if token == "(" and self.next() != ")":
                raise self.error(Fault.NOT_CLOSED)
        elif token in ("pi", "π"):
            form = LinearForm(pi=Fraction(1))
        elif token and (token[0].isdigit() or token[0] == "."):
            form = LinearForm(number=self.number(token))
        elif token in _FUNCTIONS:
            raise self.error(Fault.UNEXPECTED_HERE, found=token)
        elif token and token[0].isalpha() and token != "deg":
            form = LinearForm(symbols=((token, Fraction(1)),))
        else:
            raise self.error(Fault.TERM_EXPECTED if token else Fault.BREAKS_OFF, found=token)
        if self.peek() in ("deg", "°"):
            if not form.is_number:
                raise self.error(Fault.NO_DEGREES)
            self.next()
            form = LinearForm(pi=form.number / 180)
        return form

    def number(self, token: str) -> Fraction:
        mantissa, _, exponent = token.lower().partition("e")
        if len(mantissa) > 40 or abs(int(exponent or 0)) > 30:
            raise self.error(Fault.OUT_OF_RANGE)
        return Fraction(token)


def _add(left: LinearForm, right: LinearForm) -> LinearForm:
    terms = dict(left.symbols)
    for symbol, coefficient in right.symbols:
        terms[symbol] = terms.get(symbol, Fraction(0)) + coefficient
    symbols = tuple((symbol, coefficient) for symbol, coefficient in terms.items() if coefficient)
    return LinearForm(symbols, left.pi + right.pi, left.number + right.number)


def _scale(form: LinearForm, factor: Fraction) -> LinearForm:
    symbols = tuple((symbol, coefficient * factor) for symbol, coefficient in form.symbols if factor)
    return LinearForm(symbols, form.pi * factor, form.number * factor)
