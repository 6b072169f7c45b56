r"""The general link matrix that a document prints, T_i = Rot_z(θ_i) … Rot_x(α_i): it shows the convention of the table beside it."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Ring
from armproof.verification.document import Document
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.letters import equations_of
from armproof.verification.tables.columns import CONVENTIONS
from armproof.verification.tables.row import PARAMETERS, equal, row_matrix

_SHOWS = regex(r"alpha.*(?:matri|array|Rot|R_|\\text)|(?:matri|array|Rot|R_|\\text).*alpha", re.DOTALL)
_OF_ANY_LINK = regex(r"(?:[ijkn](?:[-+]1)?)?")
_LETTERS = {"theta": "theta", "q": "theta", "alpha": "alpha", "a": "a", "d": "d"}
SECONDS = 0.3


def shown_convention(document: Document, names: Names) -> str:
    """Return the convention of the link matrix that a document prints for any link, "" where it prints none or both."""
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        shown = {
            convention
            for display in document.displays
            if _SHOWS.search(display.latex)
            for chain in equations_of(display, names)
            for member in chain.members
            for convention in _conventions(member, names, algebra)
        }
    return shown.pop() if len(shown) == 1 else ""


def _conventions(node: n.Node, names: Names, algebra: ExactAlgebra) -> list[str]:
    """Return the conventions whose link matrix a member is, in letters of no link's own."""
    letters = [below for below in n.names(node) if below.key not in ("pi", "x", "y", "z")]
    if not {"theta", "alpha", "a", "d"} <= {_LETTERS.get(each.base) for each in letters}:
        return []
    if any(each.base not in _LETTERS or not _OF_ANY_LINK.fullmatch(each.sub) for each in letters):
        return []
    bound = replace(names, symbols={each.key: _LETTERS[each.base] for each in letters})
    try:
        value = Evaluator(bound, algebra).evaluate(node)
    except (EvaluationError, RecursionError):
        return []
    if not isinstance(value, Matrix) or value.shape != (4, 4):
        return []
    parameters = {each: algebra.symbol(each) for each in PARAMETERS}
    return [each for each in CONVENTIONS if equal(value, row_matrix(algebra, each, **parameters))]
