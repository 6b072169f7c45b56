r"""Put sentences round right and wrong formulas, and see that what is said of them is no more than was decided.

    python -m tests.sweeps.sentences [--seed 1] [--documents 3000]

The sentences stand in sentences.yaml, each with what it does to a display. What is then true is computed by NumPy alone, or known when the
document is made. Exit code 1 if a wrong display passes, a right one is refuted, or a harmless sentence costs a proof.
"""

from __future__ import annotations

import argparse
import math
import random
import re
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document

Point = tuple[float, float, float, float]  # θ_1, θ_2, l_1, l_2
X, Y = "l1*c1 + l2*c12", "l1*s1 + l2*s12"
FORMULAS: dict[str, list[list[str]]] = {  # the first is right
    "x": [[X], ["l1*c1 + l2*c2"], ["l1*c1 - l2*c12"], ["l1*c1 + l2*s12"], ["l1*c1"], ["l1*c1 + 2*l2*c12"], ["l2*c1 + l1*c12"], ["l1 + l2"]],
    "y": [[Y], ["l1*s1 + l2*s2"], ["-l1*s1 - l2*s12"], ["l1*s1 - l2*s12"], ["l1*s1"], ["l1*s1 + 2*l2*s12"], ["l2*s1 + l1*s12"]],
    "p": [[X, Y], ["l1*c1 + l2*c2", "l1*s1 + l2*s2"], ["l1*c1", "l1*s1"], [X, "l1*s1 - l2*s12"], ["l2*c12", "l2*s12"]],
    "J": [["-l1*s1 - l2*s12", "-l2*s12", X, "l2*c12"], ["-l1*s1", "-l2*s2", "l1*c1", "l2*c2"], ["-l2*s12", "-l1*s1 - l2*s12", "l2*c12", X], ["-l1*s1 - l2*s12", "l2*s12", X, "l2*c12"]],
    "det": [["l1*l2*s2"], ["l1*l2*c2"], ["-l1*l2*s2"], ["l1*l2*s1"], ["l1**2*s2"]],
    "r2": [["l1**2 + l2**2 + 2*l1*l2*c2"], ["l1**2 + l2**2 - 2*l1*l2*c2"], ["l1**2 + l2**2"], ["l1**2 + l2**2 + 2*l1*l2*s2"]],
}  # fmt: skip
LEFT = {"x": "x", "y": "y", "p": "p", "J": "J", "det": r"\det J", "r2": "x^2 + y^2"}
LETTERS = {
    "l1": "l_1",
    "l2": "l_2",
    "c1": "c_1",
    "s1": "s_1",
    "c2": "c_2",
    "s2": "s_2",
    "c12": "c_{12}",
    "s12": "s_{12}",
}
SPELT = LETTERS | {
    f"{t}{d}": rf"\{f}{'(' * (d == '12')}{a}{')' * (d == '12')}"
    for t, f in (("c", "cos"), ("s", "sin"))
    for d, a in (("1", r"\theta_1"), ("2", r"\theta_2"), ("12", r"\theta_1 + \theta_2"))
}
RIGHT_BESIDE = "x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2"
BEFORE = r"{}^0R_2 = \begin{bmatrix} c_{12} & -s_{12} & 0 \\ s_{12} & c_{12} & 0 \\ 0 & 0 & 1 \end{bmatrix}"
PASSES = frozenset(["proved", "confirmed", "defined"])


@dataclass(frozen=True)
class Trial:
    """A sentence at a place of a document, and the display there: whether that is true, and where the sentence is heard."""

    effect: str
    words: str
    place: str
    format: str
    arm: str
    latex: str
    is_right: bool
    is_true: bool
    verdict: str = ""
    alone: str = ""

    @property
    def fault(self) -> str:
        """What is wrong with the verdict, or ""."""
        passes, refuted = self.verdict in PASSES, self.verdict == "refuted"
        may_pass = {"denied": False, "only": False, "world": self.is_true, "where": self.is_right or self.is_true}
        if passes and not may_pass.get(self.effect, self.is_right):
            return "passes"
        never = {"asked": True, "denied": not self.is_right, "nothing": self.is_right}
        if refuted and never.get(self.effect, self.is_true):
            return "refuted"
        lost = self.effect == "nothing" and self.alone in PASSES and not passes
        return "lost" if lost else ""


def trials(seed: int, count: int) -> Iterator[Trial]:
    """Yield documents drawn at random, each sentence about as often, one of each effect first."""
    rng = random.Random(seed)
    drawn = [(group, words) for group in all_groups() for words in group["sentences"]]
    rng.shuffle(drawn)
    drawn = [*{group["effect"]: (group, words) for group, words in drawn}.values(), *drawn]
    for number in range(count):
        group, words = drawn[number % len(drawn)]
        yield _trial(rng, group, words)


def each_at_its_places() -> Iterator[Trial]:
    """Yield each sentence at each of its places, beside what these two let be drawn."""
    for group in all_groups():
        for words, place in product(group["sentences"], group["places"]):
            yield _trial(random.Random(f"{words} {place}"), {**group, "places": [place]}, words)


def _trial(rng: random.Random, group: dict[str, Any], words: str) -> Trial:
    name, place = rng.choice(group.get("of", [*FORMULAS])), rng.choice(group["places"])
    world, where = group.get("world", "usual"), group.get("where", "")
    there = [each for each in FORMULAS[name] if _holds(name, tuple(each), world, where)]
    shown = rng.choice([FORMULAS[name][0], rng.choice(FORMULAS[name]), *(rng.sample(there, 1) if there else ())])
    arms = ["front", "table"] + ["closed"] * (name not in ("x", "y") and group["effect"] != "world")
    latex = _formula(name, shown, rng.choice([LETTERS, SPELT]) if "c_{12}" not in words else LETTERS)
    is_right, is_true = _holds(name, tuple(shown), "usual", ""), _holds(name, tuple(shown), world, where)
    return Trial(group["effect"], words, place, rng.choice(["md", "tex"]), rng.choice(arms), latex, is_right, is_true)


def judged(trial: Trial) -> Trial:
    """Return a trial with the verdicts on its display: beside its sentence, and without it."""
    alone = "" if trial.effect != "nothing" else _verdict(trial, f"We have\n\n{_shown(trial, trial.latex)}")
    return replace(trial, verdict=_verdict(trial, placed(trial)), alone=alone)


@cache
def all_groups() -> tuple[dict[str, Any], ...]:
    """Return the sentences by what they do to a display."""
    return tuple(yaml.safe_load(Path(__file__).with_name("sentences.yaml").read_text(encoding="utf-8")))


def _verdict(trial: Trial, text: str) -> str:
    page = Path(f"page.{trial.format}")
    records = check_document(parse_document(page, document(trial, text))).equations
    printed = trial.latex.replace(" ", "")
    return next(each.verdict.value for each in records if printed in each.latex.replace(" ", "").replace("&=", "="))


def document(trial: Trial, text: str) -> str:
    """Return a document of a trial's arm and format with a text in its second section."""
    is_tex = trial.format == "tex"
    front = "% ---\n% arm: planar_2r\n% ---\n" if is_tex else "---\narm: planar_2r\n---\n"
    rows = [
        ["i", "$a_i$", r"$\alpha_i$", "$d_i$", r"$\theta_i$"],
        *([str(i), f"$l_{i}$", "0", "0", rf"$\theta_{i}$"] for i in (1, 2)),
    ]
    given = {
        "front": "",
        "closed": "\n\n".join(_shown(trial, _formula(each, FORMULAS[each][0], SPELT)) for each in "xy"),
    }
    given["table"] = _table(rows, is_tex)
    head, section = ("\\documentclass{article}\n\\begin{document}\n", "\\section{%s}") if is_tex else ("", "# %s")
    parts = [section % "Arm", given[trial.arm], "For the orientation,", _shown(trial, BEFORE)]
    parts += [section % "Kinematics", text] if trial.place != "head" else [section % trial.words, text]
    return front * (trial.arm == "front") + head + "\n\n".join(parts) + "\n" + "\\end{document}\n" * is_tex


def _table(rows: Sequence[Sequence[str]], is_tex: bool) -> str:
    if is_tex:
        lines = " \\\\\n".join(" & ".join(row) for row in rows)
        return f"\\begin{{tabular}}{{ccccc}}\n{lines} \\\\\n\\end{{tabular}}"
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join([lines[0], "|---" * len(rows[0]) + "|", *lines[1:]])


def _shown(trial: Trial, latex: str) -> str:
    return f"\\[ {latex} \\]" if trial.format == "tex" else f"$$ {latex} $$"


def placed(trial: Trial) -> str:
    """Return the display with the sentence at its place."""
    words, latex, is_tex = trial.words, trial.latex, trial.format == "tex"
    shown = _shown(trial, latex)
    aligned = rf"\begin{{align}} {RIGHT_BESIDE.replace('=', '&=')} \\ \intertext{{{words}}} {latex.replace('=', '&=', 1)} \end{{align}}"
    quoted = f"\\begin{{quote}}\n{words}\n{shown}\n\\end{{quote}}" if is_tex else f"> {words}\n>\n> {shown}"
    item, behind = (
        ("\\begin{itemize}\n\\item %s\n%s\n\\end{itemize}",) * 2 if is_tex else ("- %s\n\n  %s\n", "- %s\n\n  %s\n")
    )
    places = {
        "lead": f"{words}\n\n{shown}", "first": f"{words} We find the following.\n\n{shown}", "para": f"{words}\n\nWe have\n\n{shown}",
        "behind": f"{shown}\n\n{words}", "tight": f"{shown}\n{words}", "line": f"{shown} {words}", "head": f"We write\n\n{shown}",
        "paren": f"{shown}\n\n({words[:1].lower()}{words[1:].rstrip('.')}.)", "text": _shown(trial, rf"{latex} \quad \text{{({words})}}"),
        "tag": _shown(trial, rf"{latex} \tag{{{words}}}"), "inter": aligned if is_tex else f"$$\n{aligned}\n$$", "quote": quoted,
        "item": item % (words, shown), "itembehind": behind % ("We have", f"{shown}\n\n  {words}"),
    }  # fmt: skip
    return places[trial.place]


def _formula(name: str, entries: Sequence[str], letters: dict[str, str]) -> str:
    spelt = [
        re.sub(r"\b\w+\b", lambda found: letters.get(found[0], found[0]), each.replace("**2", "^2")).replace("*", " ")
        for each in entries
    ]
    rows = {1: [spelt], 2: [spelt[:1], spelt[1:]], 4: [spelt[:2], spelt[2:]]}[len(spelt)]
    value = (
        spelt[0] if len(spelt) == 1 else r"\begin{bmatrix} " + r" \\ ".join(map(" & ".join, rows)) + r" \end{bmatrix}"
    )
    return f"{LEFT[name]} = {value}"


def _tool(t1: float, t2: float, l1: float, l2: float) -> Any:
    return np.array([l1 * math.cos(t1) + l2 * math.cos(t1 + t2), l1 * math.sin(t1) + l2 * math.sin(t1 + t2)])


def _point(world: str, at: Point) -> Any:
    """Return the point that is meant, where letters and places are what a sentence says."""
    t1, t2, l1, l2 = at
    tool, turn = _tool(*at), t1 + t2
    return {
        "usual": lambda: tool, "swapq": lambda: tool, "abs2": lambda: _tool(t1, t2 - t1, l1, l2), "half2": lambda: _tool(t1, t2, l1, 2 * l2),
        "cw": lambda: _tool(-t1, -t2, l1, l2), "cw2": lambda: _tool(t1, -t2, l1, l2), "vert": lambda: _tool(t1 + math.pi / 2, t2, l1, l2),
        "swapl": lambda: _tool(t1, t2, l2, l1), "swapt": lambda: _tool(t2, t1, l1, l2), "elbow": lambda: _tool(t1, t2, l1, 0),
        "mid": lambda: _tool(t1, t2, l1, l2 / 2), "ydown": lambda: tool * [1, -1], "raised": lambda: tool + np.array([0, 0.37]),
        "fromelbow": lambda: tool - _tool(t1, t2, l1, 0),
        "tool": lambda: np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]]) @ tool,
    }[world]()  # fmt: skip


def _jacobian(world: str, at: Point) -> Any:
    if world == "tool":
        turn = at[0] + at[1]
        return np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]]) @ _jacobian("usual", at)
    step = 1e-6
    columns = [
        (_point(world, (at[0] + step * (k == 0), at[1] + step * (k == 1), *at[2:]))
         - _point(world, (at[0] - step * (k == 0), at[1] - step * (k == 1), *at[2:]))) / (2 * step)
        for k in ((1, 0) if world == "swapq" else (0, 1))
    ]  # fmt: skip
    return np.array(columns).T


@cache
def _holds(name: str, entries: tuple[str, ...], world: str, where: str) -> bool:
    """Whether a formula is true in a world, at a condition."""
    for seed in range(4):
        rng = random.Random(seed)
        t1, t2, l1, l2 = (rng.uniform(0.3, 1.3) for _ in range(4))
        values = {"theta_1 = 0": (0, t2, l1, l2), "theta_2 = 0": (t1, 0, l1, l2), "theta_2 = pi/2": (t1, math.pi / 2, l1, l2),
                  "l_2 = l_1": (t1, t2, l1, l1), "small": (1e-7, 1e-7, l1, l2)}  # fmt: skip
        at = values.get(where, (t1, t2, l1, l2))
        point, jacobian = _point(world, at), _jacobian(world, at)
        true = {
            "x": point[:1],
            "y": point[1:],
            "p": point,
            "J": jacobian.ravel(),
            "det": np.array([np.linalg.det(jacobian)]),
            "r2": np.array([point @ point]),
        }
        turns = {"1": at[0], "2": at[1], "12": at[0] + at[1]}
        letters = {f"c{key}": math.cos(turn) for key, turn in turns.items()} | {
            f"s{key}": math.sin(turn) for key, turn in turns.items()
        }
        printed = [eval(each, {}, letters | {"l1": at[2], "l2": at[3]}) for each in entries]  # noqa: S307 (our own formulas)
        if np.abs(true[name] - printed).max() > 1e-4:
            return False
    return True


def main() -> int:
    """Print what is wrong, and how many documents were judged; return 1 if something is."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.sweeps.sentences", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--documents", type=int, default=3000)
    options = parser.parse_args()
    with ProcessPoolExecutor() as pool:
        found = [*pool.map(judged, trials(options.seed, options.documents), chunksize=20)]
    faults = [each for each in found if each.fault]
    for each in faults:
        print(
            f"{each.fault} ({each.verdict}): {each.words} | {each.latex} | {each.effect} {each.place} {each.format} {each.arm}"
        )
    print(f"{len(found)} documents: {dict(Counter(each.fault for each in faults)) or 'nothing false'}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
