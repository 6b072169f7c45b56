r"""Signs ± of equations one below the other: "$\theta_2 = \pm\arccos D$. With the signs taken together" leads to \theta_1 = … ∓ …"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from armproof.verification.document import Display
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.named_signs import clashes_with
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.patterns import regex
from armproof.verification.verdict import HOLDS

_SIGN = regex(r"\\pm(?![A-Za-z])|\\mp(?![A-Za-z])|[±∓]")


def has_sign(latex: str) -> bool:
    """Whether ± or ∓ stands in a formula."""
    return _SIGN.search(latex) is not None


def unless_signs_clash_above(
    outcome: Outcome, checker: ChainChecker, displays: Sequence[Display], display: Display
) -> Outcome:
    """Leave open an equation with ± that holds together with one above it only where one of them has ∓ instead."""
    if outcome.verdict not in HOLDS:
        return outcome
    for latex in _signed_above(displays, display):
        with suppress(ReadError, RecursionError):
            chains = [each for each in checker.names.reader.read(latex) if isinstance(each, n.Chain)]
            for chain in chains:
                if clashes_with(outcome, chain, checker.route.holds_everywhere):
                    return outcome.left_open(say(Kind.SIGNS_CLASH))
    return outcome


def _signed_above(displays: Sequence[Display], display: Display) -> Iterator[str]:
    """Yield the formulas with ± above a display, in its section: displays, and what the text says between them."""
    for each in displays:
        if each.section == display.section and each.file == display.file:
            own = (*each.said, each.latex) if each.place != display.place else each.said
            yield from filter(has_sign, own)
        if each.place == display.place:
            break
