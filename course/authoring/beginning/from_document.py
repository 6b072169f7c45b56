"""Make tasks of a document's displays: those that are proved, and say what something known is equal to."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from armproof.course.authoring.beginning.drafts import Draft, completed, draft_of_quantity
from armproof.course.authoring.beginning.python_text import written
from armproof.models.arm import Arm
from armproof.models.errors import written as sentence
from armproof.verification.algebra.quantity_kinds import as_front_matter, kind_of
from armproof.verification.check import DocumentChecker
from armproof.verification.document import Display, Document
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

SECONDS = 2.0
MOST = 6  # tasks of one lesson
_MEANING = {"symbols", "transforms"}


def drafts_of_document(document: Document, arm: Arm) -> list[Draft]:
    """Return tasks from the displays of a document, at most MOST; a display that makes none is left out."""
    return list(_drafts(document, arm, DocumentChecker(document, arm, confirm=False)))


def _drafts(document: Document, arm: Arm, checker: DocumentChecker) -> Iterator[Draft]:
    names: set[str] = set()
    for display in document.displays:
        record = checker.check_display(display)
        if record.verdict is not Verdict.PROVED or display.erratum or len(names) >= MOST:
            continue
        with checker.ring.budget.of(SECONDS):
            draft = _draft(document, arm, checker, display)
        if draft is None:
            continue
        name = draft.name if draft.name not in names else f"{draft.name}_of_line_{display.line}"
        names.add(name)
        yield replace(draft, name=name)


def _draft(document: Document, arm: Arm, checker: DocumentChecker, display: Display) -> Draft | None:
    statements = checker.names.reader.read(display.latex)
    chain = statements[0] if len(statements) == 1 else None
    if not isinstance(chain, n.Chain) or set(chain.relations) != {"="} or not _can_be_asked(chain):
        return None
    asked, answer = (_text_of(display, chain.members[index]) for index in (0, -1))
    name = _name_of(asked) or f"line_{display.line}"
    title, text = f"${asked}$", sentence("Give {asked}.", asked=f"${asked}$")
    front = {key: document.front[key] for key in _MEANING if key in document.front}
    quantity = checker.checker.quantity_of(chain.members[0])
    if quantity is not None:
        if quantity.frame not in arm.frames or not kind_of(quantity).of_joints:
            return None
        spec = as_front_matter(quantity)
        return draft_of_quantity(arm, document.front["arm"], spec, name, title, text, answer, **front)
    return _draft_of_formula(document, arm, checker.names, chain, (asked, answer), (name, title, text))


def _draft_of_formula(
    document: Document, arm: Arm, names: Names, chain: n.Chain, sides: tuple[str, str], told: tuple[str, str, str]
) -> Draft | None:
    from armproof.course.feedback import Formula

    asked, answer = sides
    arguments = tuple(sorted(_symbols(names, arm, chain.members[-1])))
    if not arguments:
        return None
    meaning = {key: document.front[key] for key in sorted(_MEANING) if key in document.front}
    if quantities := {key: spec for key, spec in document.front.get("quantities", {}).items() if key in asked}:
        meaning["quantities"] = quantities
    question = Formula(asked, arguments, arm=document.front["arm"], **meaning)
    said = "".join(f", {key}={written(value)}" for key, value in meaning.items())
    draft = Draft(*told, question, f'Formula(r"{asked}", {written(arguments)}, arm=ARM{said})', answer)
    try:
        return completed(draft, arm)
    except Exception:  # of a name that only the document gives a meaning
        return None


def _can_be_asked(chain: n.Chain) -> bool:
    """Whether the first side is a name, or a determinant, an inverse of one; nothing in the chain is a velocity."""
    nodes = [node for member in chain.members for node in n.walk(member)]
    is_named = isinstance(n.ungrouped(chain.members[0]), n.Name | n.Call | n.Postfix)
    return is_named and not any(isinstance(node, n.Name) and node.dots for node in nodes)


def _name_of(asked: str) -> str:
    """Return what is asked as the name of a task, `det_j` for \\det(J); empty where that makes none."""
    text = asked.replace("^{-1}", "_inverse").replace("^T", "_transposed")
    text = re.sub(r"\\(?:left|right|mathrm|operatorname|mathbf|bar|tilde)\b", "", text)
    name = re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")
    return name if re.fullmatch(r"[a-z]\w{0,23}", name) else ""


def _symbols(names: Names, arm: Arm, node: n.Node) -> Iterator[str]:
    """Yield the arm's joint variables and lengths that a formula is made of."""
    known = [*(joint.symbol for joint in arm.joints), *arm.lengths]
    found: set[str] = set()
    for below in n.walk(node):
        if isinstance(below, n.Name) and (symbol := names.known_symbol(below.key)) in known:
            found.add(str(symbol))
        if isinstance(below, n.JointAngles):
            found.update(f"theta_{index}" for _, index in below.terms if f"theta_{index}" in known)
    yield from found


def _text_of(display: Display, node: n.Node) -> str:
    return " ".join(display.latex[node.span[0] : node.span[1]].split())
