"""A DH table with a number for each joint's angle, and the arm's other parameters: it gives the configuration of what stands behind it."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.verification.document import Display, Document, Table
from armproof.verification.document.heading import encloses
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.patterns import regex
from armproof.verification.tables import check_table
from armproof.verification.tables.arms import Inference
from armproof.verification.tables.columns import read_columns
from armproof.verification.verdict import Record

_NUMBER = regex(r"[-+]?\s*(?:\d+(?:\.\d+)?|\.\d+)")
_ANGLE = regex(  # in degrees, a part of π, or none
    r"[-+]?\s*(?:(?:\d+(?:\.\d+)?|\.\d+)\s*(?:\^\s*\{?\s*\\circ\s*\}?|°)|0|(?:\d+\s*)?\\?pi(?:\s*/\s*\d+)?|\\frac\s*\{\s*\d*\s*\\pi\s*\}\s*\{\s*\d+\s*\})"
)


def values_of_tables(
    checker: ChainChecker, document: Document, inferred: Inference
) -> Iterator[tuple[Display, tuple[str, ...]]]:
    """Yield the first display behind each such table, under its heading, with the values that the table gives, as LaTeX."""
    arm, taken = checker.names.arm, inferred.arm
    if arm is None or any(joint.kind != "revolute" for joint in arm.joints):
        return
    for table in document.tables:
        if table.erratum or (taken is not None and (table.cell, table.line) in taken.lines):
            continue
        behind = (
            each for each in document.displays if each.line > table.line and encloses(table.section, each.section)
        )
        if (display := next(behind, None)) is not None and (values := _values(checker, table)):
            yield display, values


def _values(checker: ChainChecker, table: Table) -> tuple[str, ...]:
    """Return the values that a table gives the joints: where nothing else in it is other than the arm's."""
    columns, arm = read_columns(table.header), checker.names.arm
    if columns is None or arm is None or len(table.rows) != len(arm.joints):
        return ()
    angles = [row[columns.theta].replace("$", "").strip() for row in table.rows if columns.theta < len(row)]
    if columns.headers[columns.theta].unit == "deg":
        angles = [f"{each}^\\circ" if _NUMBER.fullmatch(each) else each for each in angles]
    if len(angles) != len(arm.joints) or not all(map(_ANGLE.fullmatch, angles)):
        return ()
    if not _is_arm_but_for(check_table(checker, table), columns.theta):
        return ()
    return tuple(f"{key_as_latex(joint.symbol)} = {angle}" for joint, angle in zip(arm.joints, angles, strict=True))


def _is_arm_but_for(record: Record | None, column: int) -> bool:
    """Whether the entries of one column alone are other than the arm's, all of them."""
    if record is None or not record.entries:
        return False
    wrong = [(each.row, each.column) for each in record.entries]
    return wrong == [(row, column + 1) for row in range(1, len(wrong) + 1)] and len(record.findings) == len(wrong)
