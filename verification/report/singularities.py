"""The singular configurations of an arm, for people and for programs."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any

from armproof.models.errors import written
from armproof.models.language import look_up, noted
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.written import write_scalar
from armproof.verification.latex.plain import plain_text
from armproof.verification.report.text import Line
from armproof.verification.singularities.families import Family, Position, SingularityAnalysis
from armproof.verification.singularities.writing import compact_notation

MOST_INTERSECTIONS = 12  # as text; a program gets all


def singularity_lines(analysis: SingularityAnalysis) -> Iterator[Line]:
    """Return what J is, its determinant, each family with what is lost there and where it lies, and the intersections."""
    arm = analysis.arm
    yield ((arm.name, "bold"), (f"  {look_up(arm.title)}", ""))
    yield from _about(analysis)
    for family in analysis.families:
        yield from _family(analysis, family)
    yield from _intersections(analysis.intersections)
    if analysis.always_regular:
        yield ((look_up("no configuration is singular"), "bold"),)
    for message in filter(None, (analysis.message, analysis.left_out)):
        yield ((message, "yellow"),)


def _about(analysis: SingularityAnalysis) -> Iterator[Line]:
    rows, columns = ", ".join(map(str, analysis.rows)), ", ".join(map(str, analysis.columns))
    size = f"{len(analysis.rows)}×{len(analysis.columns)}"
    text = written(
        "{size}, frame {frame} in the axes of frame {axes}, rows {rows} of [v; ω], columns {columns}",
        size=size, frame=analysis.frame, axes=analysis.expressed_in, rows=rows, columns=columns)  # fmt: skip
    yield _labelled(look_up("Jacobian"), text)
    yield _labelled(look_up("rank"), written("{rank}, except for the families below", rank=analysis.generic_rank))
    if analysis.factored:
        yield _labelled("det J", plain_text(analysis.factored))


def _labelled(label: str, text: str) -> Line:
    return ((f"  {label:12}", "dim"), (text, ""))


def _family(analysis: SingularityAnalysis, family: Family) -> Iterator[Line]:
    yield ((plain_text(family.latex), "bold"), ("   " + written("rank {rank}", rank=family.rank), ""))
    for solved, condition in zip(family.solved, family.conditions, strict=True):
        if solved != condition:
            yield _labelled(look_up("solved"), plain_text(solved))
    yield _labelled(look_up("exists"), _existence(family))
    for w in family.lost_nearby:
        where = written("w = ({w}), in the axes of frame {axes} at the origin of frame {point}",
            w=_vector(w), axes=analysis.axes, point=analysis.point)  # fmt: skip
        yield _labelled(look_up("lost"), where)
    yield _labelled(look_up("kept"), written("columns {columns} of J", columns=list(family.kept_columns)))
    for motion in family.null_motions:
        yield _labelled(look_up("no motion"), f"q̇ = ({_vector(motion)})")
    if family.position is not None:
        yield _labelled(look_up("lies"), _position(family.position))
    for condition, position in family.special.items():
        told = written("if {condition}: {position}", condition=plain_text(condition), position=_position(position))
        yield _labelled("", told)


def _existence(family: Family) -> str:
    if family.existence is None:
        if family.exists:
            return look_up("yes, at the arm's own lengths; not known in closed form")
        return look_up("no, at the arm's own lengths; not known in closed form")
    if not family.existence:
        return look_up("for all lengths")
    template = noted("if {condition}; this is so at the arm's own lengths")
    if not family.exists:
        template = noted("if {condition}; this is not so at the arm's own lengths")
    return written(template, condition=plain_text(family.existence))


def _position(position: Position) -> str:
    return written(
        "{kind} ({evidence}): {statement}",
        kind=look_up(position.kind), evidence=look_up(position.evidence), statement=position.statement)  # fmt: skip


def _vector(vector: Matrix) -> str:
    return ", ".join(plain_text(write_scalar(cell, compact_notation())) for cell in vector.vector())


def _intersections(families: Sequence[Family]) -> Iterator[Line]:
    if not families:
        return
    yield ((look_up("where the rank is lower still"), "bold"),)
    for family in families[:MOST_INTERSECTIONS]:
        yield _labelled(written("rank {rank}", rank=family.rank), plain_text(family.latex))
    if len(families) > MOST_INTERSECTIONS:
        more = len(families) - MOST_INTERSECTIONS
        yield _labelled("", written("and {count} more (--format json has them)", count=more))


def singularity_json(analysis: SingularityAnalysis) -> str:
    """Return the analysis as one JSON object in ASCII, formulas as LaTeX, ending in a newline."""
    report = {
        "arm": analysis.arm.name,
        "frame": analysis.frame,
        "expressed_in": analysis.expressed_in,
        "rows": list(analysis.rows),
        "columns": list(analysis.columns),
        "joints": [joint.symbol for joint in analysis.arm.joints],
        "generic_rank": analysis.generic_rank,
        "determinant": analysis.factored or None,
        "families": [_as_json(family) for family in analysis.families],
        "intersections": [_as_json(family, directions=False) for family in analysis.intersections],
        "complete": analysis.complete,
        "message": analysis.message,
        "left_out": analysis.left_out,
    }
    return json.dumps(report, indent=1) + "\n"


def _as_json(family: Family, *, directions: bool = True) -> dict[str, Any]:
    found: dict[str, Any] = {
        "conditions": list(family.conditions),
        "lengths": list(family.lengths),
        "solved": list(family.solved),
        "existence": family.existence,
        "exists": family.exists,
        "rank": family.rank,
    }
    if not directions:
        return found
    return {
        **found,
        "lost": [_entries(w) for w in family.lost],
        "kept": [_entries(column) for column in family.kept],
        "kept_columns": list(family.kept_columns),
        "null_motions": [_entries(motion) for motion in family.null_motions],
        "position": None if family.position is None else _position_json(family.position),
        "special": {condition: _position_json(position) for condition, position in family.special.items()},
    }


def _entries(vector: Matrix) -> list[str]:
    return [write_scalar(cell, compact_notation()) for cell in vector.vector()]


def _position_json(position: Position) -> dict[str, str]:
    return {"kind": position.kind, "evidence": position.evidence, "statement": position.statement}
