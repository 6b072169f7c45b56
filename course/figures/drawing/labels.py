"""How the figures say words, numbers, joint values and sums of symbols in English and French."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import degrees

import numpy as np

from armproof.course import words
from armproof.models.arm import Arm
from armproof.models.dh.entry import LinearForm
from armproof.models.errors import existing_language
from armproof.models.language import look_up, separator, use
from armproof.verification.latex.writer import symbol_as_latex

_DOTS = ("", r"\dot", r"\ddot")
_LONG = 6  # figures of a number that is written with a power of ten
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def say(key: str, lang: str, **values: object) -> str:
    """Return the words of a key, with the values put in for its placeholders.

    Raises:
        LanguageError: an unknown language.
    """
    return words.say(key, existing_language(lang), **values)


def arm_title(arm: Arm, lang: str) -> str:
    """Return the title of an arm."""
    with use(existing_language(lang)):
        return look_up(arm.title)


def number(value: float, lang: str, digits: int = 3, *, in_math: bool = False) -> str:
    """Return a number with that many significant digits: 0.45, in French 0,45; in mathematics 0{,}45; 1120, 5·10⁻⁵."""
    lang = existing_language(lang)
    if value == 0 or abs(value) < 1e-12:
        return "0"
    text = f"{float(f'{value:.12g}'):.{digits}g}"  # two ways to one value end in other last digits, and round alike
    if "e" in text:
        mantissa, _, power = text.partition("e")
        exponent = str(int(power))
        if 0 < int(power) < _LONG:
            text = f"{float(text):.0f}"
        else:
            text = rf"{mantissa}\times10^{{{exponent}}}" if in_math else f"{mantissa}·10{exponent.translate(_RAISED)}"
    text = text.replace("-", "-" if in_math else "−")
    if lang == "fr":
        text = text.replace(".", "{,}" if in_math else ",")
    return text


def with_unit(value: float, unit: str, lang: str, digits: int = 3) -> str:
    """Return a number with its unit: 0.45 m, 30°."""
    return f"{number(value, lang, digits)}{'' if unit == '°' else ' '}{unit}"


def length(value: float, lang: str) -> str:
    """Return a length with its unit: 0.45 m."""
    return with_unit(value, "m", lang)


def joint_value(value: float, kind: str, lang: str) -> str:
    """Return the value of a joint variable with its unit, degrees for a revolute joint."""
    return with_unit(round(degrees(value), 9), "°", lang) if kind == "revolute" else length(value, lang)


def axis_label(words: str, unit: str, symbol: str = "") -> str:
    """Return the label of an axis: words, symbol and unit, as "time $t$ (s)"; the unit may be left empty."""
    parts = [words, f"${symbol}$" if symbol else "", f"({unit})" if unit else ""]
    return " ".join(part for part in parts if part)


def math(symbol: str) -> str:
    r"""Return a symbol of an arm as mathematics within text: $\theta_{1}$."""
    return f"${symbol_as_latex(symbol)}$"


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


def joint_scales(arm: Arm) -> np.ndarray:
    """Return what the values of the joints are multiplied by for a reader: 180/π for angles, 1 for lengths, (n,)."""
    return np.array([180 / np.pi if joint.kind == "revolute" else 1.0 for joint in arm.joints])


def same_unit(arm: Arm) -> list[tuple[str, list[int]]]:
    """Return the places of the joints, from 0, that share a unit: the revolute ones, then the prismatic ones."""
    kinds = [joint.kind for joint in arm.joints]
    places = {kind: [k for k, found in enumerate(kinds) if found == kind] for kind in ("revolute", "prismatic")}
    return [(kind, found) for kind, found in places.items() if found]


def joint_unit(kind: str, order: int = 0) -> str:
    """Return the unit of joint values for a reader, or of a derivative of them: °, °/s, °/s², m, m/s, m/s²."""
    return ("°" if kind == "revolute" else "m") + ("", "/s", "/s²")[order]


def dotted(symbol: str, order: int) -> str:
    r"""Return a joint variable or a derivative of it as LaTeX: \dot{\theta}_1."""
    letter, underscore, index = symbol_as_latex(symbol).partition("_")
    return f"{_DOTS[order]}{{{letter}}}{underscore}{index}" if order else letter + underscore + index


def joint_texts(arm: Arm, values: np.ndarray, lang: str, order: int = 0) -> list[str]:
    """Return each of the joint values (n,), or velocities or accelerations, with its symbol and unit."""
    parts = []
    for joint, value in zip(arm.joints, joint_scales(arm) * values, strict=True):
        parts.append(
            f"${dotted(joint.symbol, order)}$ = {with_unit(round(value, 9), joint_unit(joint.kind, order), lang)}"
        )
    return parts


def values_text(arm: Arm, values: np.ndarray, lang: str, order: int = 0) -> str:
    """Return joint values (n,), or velocities or accelerations, with their symbols and units, as one text."""
    return listed(joint_texts(arm, values, lang, order), lang)


def listed(texts: Sequence[str], lang: str) -> str:
    """Return texts one after the other: with semicolons, where a comma may be that of a decimal number."""
    with use(lang):
        return separator(texts).join(texts)
