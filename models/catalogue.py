"""The arms by name: the folders of models/, a model file of one's own, or a DH table."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from armproof.models.arm import Arm
from armproof.models.dh.table import read_table
from armproof.models.errors import Fault, ModelError
from armproof.models.loading.card import CARD_NAME, read_card
from armproof.models.loading.reader import SUFFIXES

_MODELS = Path(__file__).resolve().parent


def arm_names() -> tuple[str, ...]:
    """Return the names of the arms of the catalogue, in alphabetical order."""
    return tuple(sorted(card.parent.name for card in _MODELS.glob(f"*/{CARD_NAME}")))


def load_arm(spec: str | Path | Mapping[str, Any], base_dir: Path | str = ".") -> Arm:
    """Load an arm; the same arm is loaded once, until its files change.

    Args:
        spec: the name of an arm of the catalogue; a path to a .urdf, .sdf or .dmd.yaml, or to a folder with an arm.yaml;
            or a DH table {dh: classic | modified, rows: [...], joints: [...]}.
        base_dir: the folder that a path is relative to, usually that of the document.

    Raises:
        ModelError: no such arm, or its files or its table cannot be read.
    """
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
    if str(spec) in arm_names():
        return _load_file(*_stamped(_MODELS / str(spec) / CARD_NAME))
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


def _stamped(path: Path) -> tuple[Path, tuple[int, ...]]:
    """Return a file with what changes when it, or a file beside it that it may refer to, changes."""
    path = path.resolve()
    beside = sorted(file for file in path.parent.iterdir() if file.name.endswith((*SUFFIXES, CARD_NAME)))
    return path, tuple(stamp for file in beside for stamp in (file.stat().st_mtime_ns, file.stat().st_size))


@lru_cache(maxsize=64)
def _load_file(path: Path, stamp: tuple[int, ...]) -> Arm:
    from armproof.models.loading.loading import load_card, load_plain  # and with them NumPy and Drake

    if path.name == CARD_NAME:
        return load_card(read_card(path), path.parent.name)
    return load_plain(path)


@lru_cache(maxsize=64)
def _load_table(text: str) -> Arm:
    from armproof.models.loading.dh_plant import build_arm

    return build_arm(read_table(json.loads(text)))


def _reject(value: object) -> None:
    raise TypeError(f"{value!r}")
