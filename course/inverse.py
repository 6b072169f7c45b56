"""The closed-form inverses of the course: of each arm the one that its handout derives."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.document.front_matter import read_text, split_front_matter
from armproof.verification.inverse import InverseError, InverseKinematics, read_inverse

HANDOUTS = Path(__file__).resolve().parent / "handouts"


def inverse_of(arm: str) -> InverseKinematics:
    """Return the closed-form inverse of an arm, from the handout whose front matter has `inverse` for it.

    Args:
        arm: the name of a folder of models/.

    Raises:
        InverseError: no handout derives one for this arm.
    """
    handouts = _handouts()
    if arm not in handouts:
        raise InverseError("no handout derives an inverse for the arm '{arm}'; those it has: {handouts}",
            arm=arm, handouts=sorted(handouts))  # fmt: skip
    return _read(handouts[arm])


def arms_with_inverse() -> tuple[str, ...]:
    """Return the arms for which a handout derives an inverse."""
    return tuple(sorted(_handouts()))


@lru_cache(maxsize=1)
def _handouts() -> dict[str, Path]:
    found: dict[str, Path] = {}
    for path in sorted(HANDOUTS.glob("*.md")):
        try:
            front = split_front_matter(path, read_text(path))[0]
        except ArmproofError:  # the verdict of that handout says so
            continue
        if front and "inverse" in front.values and isinstance(arm := front.values.get("arm"), str):
            found.setdefault(arm, path)
    return found


_read = lru_cache(maxsize=32)(read_inverse)
