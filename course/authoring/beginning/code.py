"""Write values as Python."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any


def written(value: Any) -> str:
    """Return texts, numbers, lists and mappings as Python writes them, with double quotes."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{written(key)}: {written(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    if isinstance(value, tuple):
        return "(" + ", ".join(map(written, value)) + ("," if len(value) == 1 else "") + ")"
    return repr(value)


def raw(text: str) -> str:
    """Return LaTeX as a raw string where it can be one."""
    can_be = not (set(text) & {'"', "\n"}) and not text.endswith("\\")
    return f'r"{text}"' if can_be else written(text)
