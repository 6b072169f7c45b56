"""The arms by name: the folders of models/, a model file of one's own, or a DH table."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from functools import cache, lru_cache
from math import isfinite
from pathlib import Path
from typing import Any

from armproof.models.arm import Arm
from armproof.models.dh.table import read_table
from armproof.models.errors import Fault, ModelError
from armproof.models.loading.card import CARD_NAME, read_card
from armproof.models.loading.reader import SUFFIXES

_MODELS = Path(__file__).resolve().parent


@cache
def arm_names() -> tuple[str, ...]:
    """Return the names of the arms of the catalogue, in alphabetical order."""
    return tuple(sorted(card.parent.name for card in _MODELS.glob(f"*/{CARD_NAME}")))


def load_arm(
    spec: str | Path | Mapping[str, Any],
    base_dir: Path | str = ".",
    *,
    tip: str | None = None,
    lock: Mapping[str, float] | Sequence[str] | str | None = None,
) -> Arm:
    """Load an arm; the same arm is loaded once, until its files change.

    Args:
        spec: the name of an arm of the catalogue; a path to a .urdf, .sdf or .dmd.yaml, or to a folder with an arm.yaml;
            or a DH table {dh: classic | modified, rows: [...], joints: [...]}.
        base_dir: the folder that a path is relative to, usually that of the document.
        tip: of a .urdf, the link that the arm ends in, its frame n; joints that do not carry it are fixed.
        lock: of a .urdf, joints that are fixed: at 0, or each at its value.

    Raises:
        ModelError: no such arm, or its files or its table cannot be read.
    """
    if tip or lock:
        return _load_with(spec, Path(base_dir), tip, lock)
    if isinstance(spec, Mapping):
        try:
            return _load_table(json.dumps(spec, default=_reject))
        except (TypeError, ValueError, RecursionError) as error:
            raise ModelError(Fault.TABLE_OF_OBJECTS, reason=str(error)) from None
    if not isinstance(spec, str | Path) or not str(spec):
        what = f"a {type(spec).__name__}" if isinstance(spec, list | dict) else repr(spec)[:40]
        raise ModelError(Fault.NOT_AN_ARM, given=what, arms=list(arm_names()))
    if len(str(spec)) > 1000 or "\0" in str(spec):
        raise ModelError(Fault.ARM_TOO_LONG, count=len(str(spec)))
    if str(spec).isidentifier() and (card := _MODELS / str(spec) / CARD_NAME).is_file():
        return _load_file(*_stamped(card))
    path = Path(base_dir) / spec
    if path.name.endswith(SUFFIXES):
        card = path.parent / CARD_NAME
        if card.is_file() and path.is_file() and read_card(card).model.resolve() == path.resolve():
            return _load_file(*_stamped(card))
        if path.is_file():
            return _load_file(*_stamped(path))
        raise ModelError(Fault.NO_MODEL_FILE, path=path)
    if (path / CARD_NAME).is_file():
        return _load_file(*_stamped(path / CARD_NAME))
    raise ModelError(Fault.NO_ARM, arm=str(spec), arms=list(arm_names()), suffixes=list(SUFFIXES))


def arm_of(front: Mapping[str, Any], base_dir: Path | str = ".") -> Arm | None:
    """Return the arm that a front matter names with `arm`, `tip` and `lock`; None where it names none."""
    spec = front.get("arm")
    return None if spec is None else load_arm(spec, base_dir, tip=front.get("tip"), lock=front.get("lock"))


def _load_with(spec: object, folder: Path, tip: object, lock: object) -> Arm:
    """Load a model file, whose card, if any, is for all its joints and not read."""
    given = {lock: 0.0} if isinstance(lock, str) else lock or {}
    values = (
        given if isinstance(given, Mapping) else dict.fromkeys(given, 0.0) if isinstance(given, list | tuple) else None
    )
    numbers = values is not None and all(type(value) in (int, float) and isfinite(value) for value in values.values())
    if values is None or not numbers or not all(isinstance(name, str) for name in values):
        raise ModelError(Fault.LOCK_FORM, given=repr(lock))
    if not isinstance(tip or "", str):
        raise ModelError(Fault.TIP_FORM, given=repr(tip))
    if not isinstance(spec, str | Path) or not str(spec).endswith(".urdf"):
        raise ModelError(Fault.LOCKED_NO_URDF, path=spec)
    if not (folder / spec).is_file():
        raise ModelError(Fault.NO_MODEL_FILE, path=folder / spec)
    return _load_file(
        *_stamped(folder / spec), str(tip or ""), tuple((name, float(values[name])) for name in sorted(values))
    )


def _stamped(path: Path) -> tuple[Path, tuple[int, ...]]:
    """Return a file with what changes when it, or a file beside it that it may refer to, changes."""
    path = path.resolve()
    beside = sorted(file for file in path.parent.iterdir() if file.name.endswith((*SUFFIXES, CARD_NAME)))
    return path, tuple(stamp for file in beside for stamp in (file.stat().st_mtime_ns, file.stat().st_size))


@lru_cache(maxsize=64)
def _load_file(path: Path, stamp: tuple[int, ...], tip: str = "", lock: tuple[tuple[str, float], ...] = ()) -> Arm:
    from armproof.models.loading.loading import load_card, load_plain  # and with them NumPy and Drake

    if path.name == CARD_NAME:
        return load_card(read_card(path), path.parent.name)
    return load_plain(path, tip, dict(lock))


@lru_cache(maxsize=64)
def _load_table(text: str) -> Arm:
    from armproof.models.loading.dh_plant import build_arm

    return build_arm(read_table(json.loads(text)))


def _reject(value: object) -> None:
    raise TypeError(f"{value!r}")
