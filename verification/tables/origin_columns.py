"""Which column of a table of joint origins holds what: the joint's name, its links, coordinates, angles, type and axis."""

from __future__ import annotations

import re

from armproof.verification.tables.columns import plain

XYZ, RPY = ("x", "y", "z"), ("roll", "pitch", "yaw")
_HEADERS = {
    "joint": r"(?:joint|liaison|articulation)s?(?: name)?|name|nom|",
    "parent": r"parent(?: link)?",
    "child": r"child(?: link)?",
    "type": r"(?:joint )?(?:type|kind)",
    "axis": r"(?:joint )?axis",
    **{letter: letter for letter in (*XYZ, *RPY)},
}
_UNIT = re.compile(r"\s*(?:[(\[].*[)\]]|,\s*\w+|\sin\s+\w+)$")


def origin_columns(header: tuple[str, ...]) -> dict[str, int] | None:
    """Return the column (from 0) of each role, or None where the header has no joint, x, y and z.

    A column of anything else makes x, y and z those of something else (masses), unless links or angles stand there too.
    """
    place: dict[str, int] = {}
    for k, text in enumerate(header):
        spelt = _UNIT.sub("", plain(text).lower()).strip()
        if role := next((role for role, words in _HEADERS.items() if re.fullmatch(words, spelt)), None):
            place.setdefault(role, k)
    only_origins = len(place) == len(header) or bool(place.keys() & {"parent", "child", *RPY})
    return place if {"joint", *XYZ} <= place.keys() and only_origins else None


def spelt_name(name: str) -> str:
    """Return a name without what makes no difference: its case, backslashes, and - or a blank for _."""
    return re.sub(r"[-_\s]+", "_", re.sub(r"[\\{}`*]", "", plain(name)).strip().lower())
