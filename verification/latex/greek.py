"""The Greek letters, which everything else takes from here: their names in LaTeX and their characters."""

from __future__ import annotations

from collections.abc import Iterable

from armproof.verification.patterns import regex

SMALL = dict(
    zip(
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi omega".split(),
        "αβγδεζηθικλμνξπρστυφχψω",
        strict=True,
    )
)
CAPITAL = dict(zip("Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega".split(), "ΓΔΘΛΞΠΣΥΦΨΩ", strict=True))
VARIANTS = {"varepsilon": "epsilon", "vartheta": "theta", "varphi": "phi"}  # of the same letters
GREEK = {**SMALL, **CAPITAL, "varepsilon": "ε", "vartheta": "ϑ", "varphi": "φ"}

# characters → the name of the letter; "ϕ" is another form of φ
NAMES = {character: name for name, character in (SMALL | CAPITAL).items()} | {"ϑ": "theta", "ϕ": "phi", "ϵ": "epsilon"}

# that need no backslash within other letters: a shorter name may be a product, π that of p and i
LONG = tuple(name for name in (*SMALL, *CAPITAL) if len(name) > 3 or name in ("phi", "psi"))

ANGLES = ("theta", "alpha", "beta", "gamma", "phi", "psi")  # what documents call angles
TURNED = (
    *ANGLES,
    *VARIANTS,
    "delta",
    "epsilon",
    "zeta",
    "eta",
    "kappa",
    "mu",
    "nu",
    "xi",
    "chi",
    "sigma",
)  # and may call so
NUMBERS = (
    *ANGLES,
    *VARIANTS,
    "omega",
    "sigma",
    "lambda",
    "mu",
    "rho",
    "tau",
    "delta",
    "epsilon",
    "Delta",
)  # and numbers


def one_of(names: Iterable[str]) -> str:
    """Return the pattern of any of some names, the longest first."""
    return "|".join(sorted(names, key=len, reverse=True))


SPELT = regex(r"(?<![\\A-Za-z])(%s)(?![A-Za-z])" % one_of(GREEK))  # a letter that lacks its backslash
