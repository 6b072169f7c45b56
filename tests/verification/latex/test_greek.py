"""The Greek letters are the same ones wherever they are read or written."""

from __future__ import annotations

import io

import pytest

from armproof.course.feedback.answer import read_plain
from armproof.course.feedback.outcome import pretty
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES, CAPITAL, GREEK, LONG, NAMES, NUMBERS, SMALL, VARIANTS
from armproof.verification.latex.plain import plain_text
from armproof.verification.latex.reader import Reader, key_as_latex
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.naming.reading import READ_ALREADY, name_key
from armproof.verification.report.text import to_ascii, write_lines

LETTERS = SMALL | CAPITAL
read = Reader().read_expression


@pytest.mark.parametrize("name", LETTERS)
def test_a_letter_is_read_and_written_by_every_part(name: str):
    letter, character = n.Name(name, sub="1"), LETTERS[name]
    assert read(rf"\{name}_1") == read(f"{character}_1") == letter
    assert key_as_latex(f"{name}_1") == symbol_as_latex(f"{name}_1") == rf"\{name}_1"
    assert name_key(Reader(), f"{name}_1") == f"{name}_1"
    assert plain_text(rf"\{name}") == character
    assert to_ascii(character) == name
    assert pretty(f"{name}_1") == pretty(f"{character}_1") == f"{character}₁"
    assert read_plain(f"2 * {name}_1") is not None


def test_letters_and_powers_are_printed_and_names_of_code_are_left() -> None:
    assert pretty(r"-\psi, l_1^2 + r^2, T_0^1") == "-ψ, l₁² + r², T₀¹"
    assert pretty(r"(a_3S_2+d_3C_{23}) \sin(\theta_1)") == "(a₃S₂+d₃C₂₃) sin(θ₁)"
    assert pretty("p_0P, l_1**2, J^T J, z_{i-1}, 2^10") == "p_0P, l₁**2, J^T J, z_{i-1}, 2^10"


def test_variants_are_the_same_letters():
    for variant, name in VARIANTS.items():
        assert read(rf"\{variant}_2") == n.Name(name, sub="2")
        assert NAMES[GREEK[variant]] == name


@pytest.mark.parametrize("name", LONG)
def test_a_long_name_needs_no_backslash(name: str):
    assert read(f"{name}_1") == n.Name(name, sub="1")


def test_what_is_no_greek_letter_stays_what_it_is():
    assert isinstance(read("pi_1"), n.Product)
    assert symbol_as_latex("ell_1") == "ell_1"
    assert key_as_latex("sin_1") == "sin_1"
    assert "sin" not in GREEK and "sin" in READ_ALREADY
    assert set(ANGLES) < set(NUMBERS) < set(GREEK) and "pi" not in NUMBERS


def test_a_stream_of_ascii_gets_the_names():
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    write_lines([(("ζ_1 = Ω", ""),)], stream)
    stream.flush()
    assert stream.buffer.getvalue() == b"zeta_1 = Omega\n"  # type: ignore[attr-defined]
