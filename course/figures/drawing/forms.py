"""Sums of symbols and numbers, as entries of DH tables are, written as mathematics."""

from __future__ import annotations

from fractions import Fraction

from armproof.course.figures.drawing.labels import number
from armproof.models.dh.entry import LinearForm
from armproof.verification.latex.writer import symbol_as_latex


def form_tex(form: LinearForm, lang: str) -> str:
    r"""Return a sum as LaTeX, angles in degrees: \theta_2 - 90^{\circ}, 2l_1 + 0.3."""
    terms = [(factor, symbol_as_latex(symbol)) for symbol, factor in form.symbols]
    if form.pi:
        terms.append((form.pi * 180, r"^{\circ}"))
    if form.number or not terms:
        terms.append((form.number, ""))
    text = ""
    for factor, symbol in terms:
        sign = "-" if factor < 0 else "+"
        size = _size(abs(factor), symbol, lang)
        text += (f" {sign} " if text else "-" if factor < 0 else "") + size + symbol
    return text


def _size(factor: Fraction, symbol: str, lang: str) -> str:
    is_degrees = symbol.startswith("^")
    if factor == 1 and symbol and not is_degrees:
        return ""
    if symbol and not is_degrees and factor.denominator != 1:
        return rf"\frac{{{factor.numerator}}}{{{factor.denominator}}}"
    return number(float(factor), lang, 4, in_math=True)
