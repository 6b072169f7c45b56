"""A chain of turns and shifts as rows of a classic DH table, with rows in which nothing moves where a slide needs them."""

from __future__ import annotations

from dataclasses import dataclass, field

_TURNED, _BACK = "pi/2", "-pi/2"


@dataclass
class Moves:
    """The rows of a chain that is built from the base: each move is one in the frame behind those before it."""

    rows: list[dict[str, str]] = field(default_factory=list)
    joints: list[str] = field(default_factory=list)
    turning: set[int] = field(default_factory=set)  # the rows that only turn the frame to where the next joint slides

    def add(self, column: str, value: str, joint: str = "") -> None:
        """Add one entry of a row: to the last row, where that leads to the same frame; a shift by nothing is none."""
        if value == "0" and not joint:
            return
        row = self.rows[-1] if self.rows else {column: value}
        is_behind = column in ("theta", "d") and (row.get("a", "0"), row.get("alpha", "0")) != ("0", "0")
        if row.get(column, "0") != "0" or is_behind or (joint and self.joints[-1]):
            self.rows.append({"a": "0", "alpha": "0", "d": "0", "theta": "0"})
            self.joints.append("")
        self.rows[-1][column] = value
        self.joints[-1] = joint or self.joints[-1]

    def slide(self, axis: str, value: str, joint: str) -> None:
        """Add a joint that slides along an axis; the frame keeps its orientation."""
        around = {"x": (("theta", _TURNED), ("alpha", _TURNED)), "y": (("alpha", _BACK),), "-z": (("alpha", "pi"),)}
        back = {"x": (("alpha", _BACK), ("theta", _BACK)), "y": (("alpha", _TURNED),), "-z": (("alpha", "pi"),)}
        count = len(self.rows)
        for column, angle in around.get(axis, ()):
            self.add(column, angle)
        self.turning |= {*range(count, len(self.rows))} if count else set()
        self.add("d", value, joint)
        for column, angle in back.get(axis, ()):
            self.add(column, angle)

    @property
    def frames(self) -> tuple[str, ...]:
        """The names of all frames, where something does not move: joint i moves frame i, the last one behind it."""
        if "" not in self.joints:
            return ()
        names = ["0"]
        for row, after in enumerate([*self.joints[1:], "end"]):
            count = sum(map(bool, self.joints[: row + 1]))
            is_last = (after or row + 1 in self.turning) and row not in self.turning
            names.append(str(count) if is_last and count else f"{count}{'abcdefgh'[row % 8]}")
        return tuple(names)
