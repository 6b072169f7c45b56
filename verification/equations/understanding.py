"""Whether an equation was understood: what notation leaves open is unchecked, and never refuted."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names

SIZES = (
    Kind.WRONG_SIZE, Kind.WRONG_SIZE_OF_VALUE, Kind.SUM_OF_SIZES, Kind.PRODUCT_OF_SIZES, Kind.SUM_WITH_SCALAR,
    Kind.NO_INVERSE_OF_SIZE, Kind.NO_DETERMINANT, Kind.NO_COFACTORS,
)  # fmt: skip
ELEMENTARY = ("Rot", "Rot3", "Trans")
TRIGONOMETRY = ("cos", "sin", "tan", "cot", "sec", "csc", "acos", "asin", "atan", "atan2", *ELEMENTARY)


def without_misreading(outcome: Outcome, chain: n.Chain, names: Names) -> Outcome:
    """Return a refuted outcome, or an unchecked one where it was not understood."""
    reason = (
        _rotation_for_pose(outcome, names) or _own_name(chain, names) or _sizes_of_convention(outcome, chain, names)
    )
    reason = reason or _nothing_to_compare(outcome, chain, names)
    if reason is None:
        return outcome
    return outcome.left_open(reason)


def _rotation_for_pose(outcome: Outcome, names: Names) -> Finding | None:
    """A 3×3 matrix without a translation may be the rotation of what convention calls a pose."""
    sides = [side.value if side is not None else None for side in (outcome.true, outcome.printed)]
    true, printed = sides
    if not (isinstance(true, Matrix) and isinstance(printed, Matrix) and outcome.true is not None):
        return None
    name = bare(outcome.true.node)
    by_convention = isinstance(name, n.Name) and _quantity(name, names) and name.key not in names.quantities
    if (
        not by_convention
        or (true.shape, printed.shape) != ((4, 4), (3, 3))
        or not all(is_zero(printed.rows[r][2]) for r in (0, 1))
    ):
        return None
    return say(Kind.SIZES_OF_CONVENTION, reason=say(Kind.WRONG_SIZE, printed=printed.size, correct=true.size))


def _own_name(chain: n.Chain, names: Names) -> Finding | None:
    """S_1 = π r²: a letter that is a sine elsewhere, equated to what is no expression of joints and has names of its own."""
    for member in chain.members:
        alone = bare(member)
        if not (isinstance(alone, n.Call) and alone.style == "index" and alone.head in ("s", "S", "c", "C")):
            continue
        others = [below for other in chain.members if other is not member for below in n.walk(other)]
        if any(isinstance(b, n.JointAngles) or (isinstance(b, n.Call) and b.function in TRIGONOMETRY) for b in others):
            continue
        unknown = [b for b in others if isinstance(b, n.Name) and b.key != "pi" and not _is_bound(b, names)]
        if unknown:
            return say(Kind.OWN_NAME, text=f"{alone.head}_{_digits(alone)}")
    return None


def _sizes_of_convention(outcome: Outcome, chain: n.Chain, names: Names) -> Finding | None:
    """Sizes that do not fit tell a slip where the front matter or explicit frames say what the names are, on both sides."""
    if not outcome.findings or outcome.findings[0].kind not in SIZES:
        return None
    held = [[b for b in n.walk(side) if isinstance(b, n.Name) and _quantity(b, names)] for side in chain.members]
    held = [side if len(side) == 1 else [b for b in side if not _is_scalar(b, names)] for side in held]
    by_convention = [name for side in held for name in side if replace(name, dots=0).key not in names.quantities]
    explicit = all(_is_explicit(name) for name in by_convention)
    points = outcome.findings[0].kind is Kind.PRODUCT_OF_SIZES  # O_0 O_2 is a vector between points, and no product
    elementary = any(isinstance(b, n.Call) and b.function in ELEMENTARY for m in chain.members for b in n.walk(m))
    understood = all(held) or elementary or _are_columns(outcome)
    if not by_convention or (explicit and not points and understood):
        return None
    return say(Kind.SIZES_OF_CONVENTION, reason=outcome.findings[0])


def _quantity(name: n.Name, names: Names) -> bool:
    """Whether a name stands for a quantity of the arm, by the front matter or by convention."""
    plain = replace(name, dots=0)
    return names.known_symbol(plain.key) is None and names.quantity(plain) is not None


def _is_scalar(name: n.Name, names: Names) -> bool:
    quantity = names.quantity(replace(name, dots=0))
    return quantity is not None and quantity.scalar


def _is_explicit(name: n.Name) -> bool:
    """Whether a name says of which frame it is."""
    return any(character.isdigit() for character in name.sub + name.sup + name.pre_sub + name.pre_sup)


def _are_columns(outcome: Outcome) -> bool:
    values = [side.value for side in (outcome.true, outcome.printed) if side is not None]
    return all(isinstance(value, Matrix) and value.shape[1] == 1 for value in values)


def _nothing_to_compare(outcome: Outcome, chain: n.Chain, names: Names) -> Finding | None:
    """Without an arm, only trigonometry, identities, sizes and what the document has defined can be wrong."""
    if names.arm is not None or names.state.consulted or (outcome.findings[:1] and outcome.findings[0].kind in SIZES):
        return None
    below = [each for member in chain.members for each in n.walk(member)]
    if any(isinstance(b, n.JointAngles) or (isinstance(b, n.Call) and b.function in TRIGONOMETRY) for b in below):
        return None
    if any(isinstance(b, n.Name) and b.pre_sup for b in below):  # a law of link matrices
        return None
    letters = [{b.key for b in n.walk(m) if isinstance(b, n.Name) and b.key not in ("pi", "I")} for m in chain.members]
    return say(Kind.NO_ARM_TO_COMPARE) if any(found != letters[0] for found in letters) else None


def _is_bound(name: n.Name, names: Names) -> bool:
    known = names.known_symbol(name.key) is not None or name.key in names.state.definitions
    return known or names.quantity(name) is not None


def _digits(call: n.Call) -> str:
    (angles,) = call.arguments
    return "".join(str(index) for _, index in angles.terms) if isinstance(angles, n.JointAngles) else ""
