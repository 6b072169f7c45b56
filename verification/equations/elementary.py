r"""The elementary rotations where a name does not say by which angle: R_x = [1, 0, 0; 0, c_γ, -s_γ; 0, s_γ, c_γ], R_{yaw} = […]."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.equations.general_links import GeneralStatements
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.verdict import Verdict

_AXES = {"x": "x", "X": "x", "roll": "x", "y": "y", "Y": "y", "pitch": "y", "z": "z", "Z": "z", "yaw": "z"}
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
