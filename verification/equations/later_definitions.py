r"""What a display lacks and the displays right behind it say: x = k_1 c_1 - k_2 s_1, where k_1 = …, k_2 = …."""

from __future__ import annotations

from collections.abc import Sequence, Set

from armproof.verification.document import Display
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.latex.reader import Reader
from armproof.verification.verdict import Record, Verdict

AHEAD = 6


def names_lacking(record: Record) -> frozenset[str]:
    """Return the names for which a display is unchecked."""
    findings = record.findings if record.verdict is Verdict.UNCHECKED else ()
    return frozenset(str(each.terms["name"]) for each in findings if each.kind is Kind.NOT_BOUND)


def definitions_behind(
    displays: Sequence[Display], display: Display, missing: Set[str], reader: Reader
) -> list[Display]:
    """Return the displays right behind one that say what names are; none where one between speaks of something else."""
    at = next((k for k, each in enumerate(displays) if each is display), len(displays))
    found: list[Display] = []
    told: set[str | None] = set()
    for later in displays[at + 1 : at + 1 + AHEAD]:
        chains = _chains_of(later, reader) if later.section == display.section and not later.erratum else []
        given = {bare_key(chain.members[0]) for chain in chains}
        spoken = {b.key for chain in chains for m in chain.members for b in n.names(m)}
        if given & missing:
            found.append(later)
            told |= given
        elif not spoken & missing:
            break
    return found if missing <= told else []


def _chains_of(display: Display, reader: Reader) -> list[n.Chain]:
    """Return the equations of a display; none of one that cannot be read."""
    try:
        return [each for each in reader.read(display.latex) if isinstance(each, n.Chain)]
    except (ReadError, RecursionError):
        return []
