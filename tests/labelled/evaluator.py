"""An evaluator of LaTeX of its own: numbers for formulas in joint angles and lengths, nothing of ours.

It reads what the tables of this folder and the generated claims are written in: sums, juxtaposed products, fractions,
roots, powers, c_1, s_{12}, \\cos(…), \\dot\\theta_i and matrices. Everything else is an error.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:\.\d+)?)|(?P<begin>\\begin\{(?:b|p)matrix\})|(?P<end>\\end\{(?:b|p)matrix\})|(?P<row>\\\\)"
    r"|(?P<trig>(?:[csCS]_(?:\{\d+\}|\d)|[CS]\d+))|(?P<function>\\(?:cos|sin|sqrt|frac))"
    r"|(?P<name>(?:\\dot\s*)?(?:\\theta|\\lambda|[a-zA-Z])(?:_(?:\{\w+\}|\w))?)|(?P<mark>[-+*/^(){}&|]|\\,|\\cdot|\\[lr]vert))"
)


class Formula:
    """A recursive-descent reader that evaluates as it reads; angles are looked up as theta_i or q_i."""

    def __init__(self, latex: str, values: Mapping[str, float]) -> None:
        self.values = values
        self.tokens: list[tuple[str, str]] = []
        latex = latex.replace(r"\left", "").replace(r"\right", "").replace(r"\,", " ").replace(r"\cdot", " ").strip()
        at = 0
        while at < len(latex):
            match = TOKEN.match(latex, at)
            if match is None:
                raise ValueError(f"cannot read {latex[at : at + 20]!r} in {latex!r}")
            self.tokens.append((str(match.lastgroup), match.group(str(match.lastgroup))))
            at = match.end()
        self.at = 0
        self.bars = 0  # that are open

    def peek(self) -> tuple[str, str]:
        return self.tokens[self.at] if self.at < len(self.tokens) else ("", "")

    def take(self, text: str = "") -> str:
        kind, found = self.peek()
        if text and found != text:
            raise ValueError(f"expected {text!r}, found {found!r}")
        self.at += 1
        return found if kind else ""

    def whole(self) -> np.ndarray:
        value = self.sum()
        if self.at != len(self.tokens):
            raise ValueError(f"{self.peek()[1]!r} is left over")
        return value

    def sum(self) -> np.ndarray:
        sign = -1.0 if self.peek()[1] == "-" else 1.0
        if self.peek()[1] in ("-", "+"):
            self.take()
        value = sign * self.product()
        while self.peek()[1] in ("+", "-"):
            sign = 1.0 if self.take() == "+" else -1.0
            value = value + sign * self.product()
        return value

    def product(self) -> np.ndarray:
        value = self.power()
        while self.more_factors():
            if self.peek()[1] == "/":
                self.take()
                value = value / self.power()
                continue
            right = self.power()
            value = value @ right if np.ndim(value) == 2 and np.ndim(right) == 2 else value * right
        return value

    def more_factors(self) -> bool:
        kind, text = self.peek()
        ends = ("+", "-", ")", "}", "&", "|") if self.bars else ("+", "-", ")", "}", "&")
        return bool(kind) and text not in ends and kind not in ("row", "end")

    def power(self) -> np.ndarray:
        value = self.atom()
        if self.peek()[1] == "^":
            self.take()
            return value ** self.group()
        return value

    def group(self) -> np.ndarray:
        if self.peek()[1] != "{":
            return self.atom()
        self.take("{")
        value = self.sum()
        self.take("}")
        return value

    def atom(self) -> np.ndarray:
        kind, text = self.peek()
        self.take()
        if kind == "number":
            return np.asarray(float(text))
        if kind == "trig":
            angle = sum(self.angle(digit) for digit in re.findall(r"\d", text))
            return np.asarray(np.cos(angle) if text[0] in "cC" else np.sin(angle))
        if kind == "function":
            return self.function(text)
        if kind == "name":
            return np.asarray(self.values[re.sub(r"[{}\\ ]", "", text)])
        if kind == "begin":
            return self.matrix()
        if text == "(":
            value = self.sum()
            self.take(")")
            return value
        if text == "|":
            self.bars += 1
            value = np.abs(self.sum())
            self.bars -= 1
            self.take("|")
            return value
        raise ValueError(f"{text!r} stands where a factor is expected")

    def function(self, name: str) -> np.ndarray:
        if name == r"\frac":
            above = self.group()
            return above / self.group()
        if name == r"\sqrt":
            return np.sqrt(self.group())
        squared = self.peek()[1] == "^"
        if squared:
            self.take()
            self.take("2")
        argument = self.atom() if self.peek()[0] == "name" or self.peek()[1] == "(" else self.group()
        value = np.cos(argument) if name == r"\cos" else np.sin(argument)
        return value**2 if squared else value

    def matrix(self) -> np.ndarray:
        rows: list[list[float]] = [[]]
        while True:
            rows[-1].append(float(self.sum()))
            kind, text = self.peek()
            self.take()
            if kind == "end":
                return np.array(rows)
            if kind == "row":
                rows.append([])
            elif text != "&":
                raise ValueError(f"{text!r} in a matrix")

    def angle(self, digit: str) -> float:
        return self.values[f"theta_{digit}" if f"theta_{digit}" in self.values else f"q_{digit}"]


def evaluate(latex: str, values: Mapping[str, float]) -> np.ndarray:
    """Return the value of a formula, of shape () or (rows, columns); raises ValueError or KeyError on what it cannot read."""
    return Formula(latex, values).whole()
