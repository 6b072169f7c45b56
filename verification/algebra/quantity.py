"""A quantity of an arm, as data: which matrix of which frames, and which of its rows and columns."""

from __future__ import annotations

from dataclasses import dataclass

COMPONENTS = {"x": 0, "y": 1, "z": 2}


@dataclass(frozen=True)
class Quantity:
    """A matrix of an arm: `kind` of `frame` in `reference`, then the rows and columns that are meant (from 1).

    pose: 4×4 X_{reference,frame}; rotation: its 3×3 block; origin: 3×1, p of the frame's origin in the reference;
    axis: 3×1, the frame's x, y or z axis in the reference; difference: p_frame − p_start in the reference;
    jacobian: 6×n, rows [v; ω], of the frame's origin with respect to frame 0, expressed in the reference;
    link: the general link matrix of a convention in frame; joint: a joint's variable; vector: all of them;
    velocity: 6×1, the Jacobian times the joint rates, rows [v; ω]; angle: of a planar arm, the sum of its joints' angles up
    to the frame; task: 3×1, x, y and that angle; determinant, manipulability: det and √det(J Jᵀ) of the Jacobian's `rows`.
    """

    kind: str
    frame: str
    reference: str = "0"
    rows: tuple[int, ...] | None = None
    columns: tuple[int, ...] | None = None
    along: str = "z"
    start: str = "0"
    scalar: bool = False
    homogeneous: bool = False

    @property
    def words(self) -> str:
        """What it is, for a reader: "origin of frame 2 in frame 0, x"."""
        head = _WORDS.get(self.kind, self.kind).format(frame=self.frame, along=self.along, start=self.start)
        rows = self.rows
        if self.kind == "velocity" and rows is not None:
            head = ("linear " if max(rows) <= 3 else "angular ") + head
            rows = tuple((row - 1) % 3 + 1 for row in rows)
        where = f" in frame {self.reference}" if self.kind in _PLACED else ""
        if (
            self.scalar
            and rows is not None
            and self.columns is None
            and self.kind in ("origin", "difference", "velocity", "axis")
        ):
            return f"{head}{where}, {'xyz'[rows[0] - 1]}"
        if rows == (1, 2, 3) and self.kind == "velocity":
            rows = None
        return f"{_part('row', rows)}{_part('column', self.columns)}{head}{where}"

    @property
    def front_matter(self) -> str:
        """The front matter that gives a name this meaning, after its key; empty for what front matter does not know."""
        if self.kind not in ("pose", "rotation", "origin", "axis", "jacobian"):
            return ""
        options = [f"{self.kind}: {self.frame}"]
        options += [f"in: {self.reference}"] if self.reference != "0" else []
        options += [f"along: {self.along}"] if self.along != "z" else []
        if self.scalar and self.rows is not None and self.kind in ("origin", "axis"):
            options.append(f"component: {'xyz'[self.rows[0] - 1]}")
        elif self.rows is not None:
            options.append(f"rows: {list(self.rows)}")
        options += [f"columns: {list(self.columns)}"] if self.columns is not None else []
        return "{" + ", ".join(options) + "}"

    def places(self, width: int) -> tuple[list[int], list[int]]:
        """Return its rows and columns, from 0, in the 4×4 pose or the Jacobian of so many columns that it is a part of."""
        height, along = 4 if self.homogeneous else 3, COMPONENTS[self.along]
        parts = {
            "jacobian": (range(6), range(width)),
            "rotation": (range(3), range(3)),
            "axis": (range(height), range(along, along + 1)),
            "origin": (range(height), range(3, 4)),
            "difference": (range(height), range(3, 4)),
        }
        rows, columns = parts.get(self.kind, (range(4), range(4)))
        return (
            list(rows) if self.rows is None else [rows[row - 1] for row in self.rows],
            list(columns) if self.columns is None else [columns[column - 1] for column in self.columns],
        )


_PLACED = ("pose", "rotation", "origin", "axis", "difference", "jacobian", "velocity", "task")
_WORDS = {
    "pose": "pose of frame {frame}",
    "rotation": "rotation of frame {frame}",
    "origin": "origin of frame {frame}",
    "axis": "{along} axis of frame {frame}",
    "difference": "vector from the origin of frame {start} to that of frame {frame}",
    "jacobian": "the Jacobian of frame {frame}",
    "velocity": "velocity of frame {frame}",
    "task": "x, y and angle of frame {frame}",
    "angle": "angle of frame {frame} about z",
    "manipulability": "manipulability at frame {frame}",
    "determinant": "determinant of the Jacobian of frame {frame}",
    "link": "general link matrix, {frame}",
    "joint": "joint variable {frame}",
    "vector": "the joint variables",
}


def _part(what: str, indices: tuple[int, ...] | None) -> str:
    if indices is None:
        return ""
    return f"{what}{'s' if len(indices) > 1 else ''} {', '.join(map(str, indices))} of "
