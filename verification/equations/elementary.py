r"""The elementary rotations where a name does not say by which angle: R_x = [1, 0, 0; 0, c_γ, -s_γ; 0, s_γ, c_γ], R_{yaw} = […]."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.equations.compositions import index_before
from armproof.verification.equations.general_links import GeneralStatements
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.tokens import canonical_script
from armproof.verification.patterns import regex
from armproof.verification.verdict import Verdict

_AXES = {"x": "x", "X": "x", "roll": "x", "y": "y", "Y": "y", "pitch": "y", "z": "z", "Z": "z", "yaw": "z"}
_AXIS_OF_FRAME = regex(r"[xyz]_\{?([^{},\s]+)\}?", re.IGNORECASE)
_ANGLE = n.Name("alpha", text=r"\alpha")


def is_elementary_rotation(general: GeneralStatements, chain: n.Chain, equation: int, line: int) -> bool:
    """Whether a chain gives R_x or R_{roll} the rotation about that axis, by an angle that is not named there."""
    read = elementary_rotation(chain)
    found = general.identity(read, equation, line) if read is not None else None
    return bool(found) and all(outcome.verdict is Verdict.PROVED for outcome in found or ())


def elementary_rotation(chain: n.Chain) -> n.Chain | None:
    """Return R_x(α) = […α…] for a chain R_x = […] whose cosines and sines are of one and the same, else None.

    Where it is no identity nothing is wrong: the name may stand for the inverse, or for something else.
    """
    name, *others = map(bare, chain.members)
    axis = _AXES.get(name.sub) if isinstance(name, n.Name) and name.base == "R" and not name.sup else None
    if axis is None or len(others) != 1 or not isinstance(others[0], n.Matrix):
        return None
    calls = [each for each in n.walk(others[0]) if isinstance(each, n.Call)]
    if not calls or len({each.arguments for each in calls}) != 1 or {each.function for each in calls} != {"cos", "sin"}:
        return None
    turned = n.substitute_each(others[0], {id(each): replace(each, arguments=(_ANGLE,)) for each in calls})
    call = n.Call("Rot3", (n.Name(axis), _ANGLE), f"R_{axis}", "script")
    return replace(chain, members=(call, turned))


def axis_of_another_frame(chain: n.Chain) -> Finding | None:
    """Return the doubt where Rot_{x_k} or Trans_{x_k} is about an axis of neither frame of the one transform that a chain is about."""
    below = [each for member in chain.members for each in n.walk(member)]
    heads = [each.head for each in below if n.is_call(each, "Rot", "Trans")]
    axes = [canonical_script(head.partition("_")[2]) for head in heads]
    found = [match for axis in axes if (match := _AXIS_OF_FRAME.match(axis))]
    frames = [indices for each in below if isinstance(each, n.Name) and (indices := [*_frames_of(each)])]
    if len(frames) != 1:
        return None
    others = (match[0] for match in found if match[1] not in frames[0])
    return next((say(Kind.AXIS_OF_ANOTHER_FRAME, axis=axis) for axis in others), None)


def _frames_of(name: n.Name) -> Iterator[str]:
    """Yield the frames between which a transform leads by its indices: A_i leads from frame i-1."""
    indices = [index for index in (name.pre_sup, name.pre_sub, name.sup, name.sub) if index]
    if name.base not in "TAHR" or not indices:
        return
    yield from indices
    if len(indices) == 1:
        yield index_before(indices[0])
