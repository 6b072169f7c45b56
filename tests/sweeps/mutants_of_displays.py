"""The course's displays with their LaTeX damaged: `python -m tests.sweeps.mutants_of_displays [COUNT] [SEED]`.

Tokens, braces, relations and arrows are deleted, doubled, swapped and replaced. Whatever comes of it, there is no internal
error, no display takes longer than its bound, and none costs another its verdict: every page of damaged displays begins
and ends with one display of its handout that is proved, and stays so.
"""

from __future__ import annotations

import os
import re
import sys
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from random import Random

import armproof.course
from armproof.verification.check import SECONDS_TO_DECIDE, SECONDS_TO_EXPLAIN, check_document
from armproof.verification.document import Display, Document, read_document
from armproof.verification.findings import Kind

HANDOUTS = Path(armproof.course.__path__[0]) / "handouts"
COUNT, SEED, ON_A_PAGE = 20_000, 2019, 12
PAGES_A_LINE = 1_000  # a sweep of a million takes the best part of an hour: it tells how far it is
TOO_SLOW = "too slow"
BOUND = SECONDS_TO_DECIDE + SECONDS_TO_EXPLAIN
TOKEN = re.compile(r"\\\|\\[a-zA-Z]+|\\.|\s+|[A-Za-z]|\d+|.", re.DOTALL)
RELATIONS = [
    "=",
    r"\neq",
    r"\in",
    r"\approx",
    r"\leq",
    r"\Rightarrow",
    r"\Leftrightarrow",
    r"\iff",
    r"\to",
    r"\quad",
    ",",
]
WRAPS = [(r"\arctan(", ")"), (r"\sqrt{", "}"), (r"\operatorname{rank}(", ")"), (r"\cos^{-1}(", ")"), (r"\underbrace{", "}_{x}"),
         (r"\left(", r"\right)^2"), (r"\det(", ")"), (r"|", "|"), (r"\frac{1}{", "}"), (r"\begin{bmatrix}", r"\end{bmatrix}")]  # fmt: skip
PIECES = [*RELATIONS, "{", "}", "(", ")", "|", "^", "_", "&", r"\\", r"\frac", r"\sqrt", r"\arctan", r"\det", r"\operatorname",
          r"\begin", r"\end", r"\left", r"\right", "-", "+", "0", "J", r"\theta", r"\dot", r"\pm", r"\sum", r"\underbrace", "'"]  # fmt: skip
# Displays that attacks found hard: an arm, and the display.
HARD = (
    ("rx90", r"\arctan(\arctan(\arctan(S_{23} + C_1))) = \arctan(\arctan(\frac{S_2}{C_3 + \arctan S_1}))"),
    (
        "kr210",
        r"\arctan\frac{\arctan\frac{S_2}{C_1}}{\arctan\frac{C_{23}}{S_4}} = \arctan\frac{\sqrt{1 - \sqrt{C_2}}}{\arctan S_5}",
    ),
    ("kr210", r"\operatorname{rank} J = 3 \iff \theta_5 = 0"),
    ("kr210", r"\operatorname{rank} J = 3 \iff \det J = 0"),
    ("kr210", r"n_z = C_6C_{23}(((S_4 + S_6(C_{23}C_4C_5 - S_{23}S_5))^2)^2)^2"),
)


@dataclass(frozen=True)
class Failure:
    """A damaged display that was not borne."""

    handout: str
    latex: str
    what: str


def main() -> int:
    """Sweep and print what failed; 0 if nothing did."""
    count, seed = (int(given) for given in (*sys.argv[1:3], *(str(n) for n in (COUNT, SEED)[len(sys.argv[1:3]) :])))
    started = time.perf_counter()
    found: list[Failure] = []
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        for done, failures in enumerate(pool.map(failures_of_page, pages(count, seed), chunksize=4), start=1):
            found += tell(failures)
            if done % PAGES_A_LINE == 0:
                print(f"{done * ON_A_PAGE} of {count}, {time.perf_counter() - started:.0f} s", flush=True)
    for hard in HARD:
        found += tell(failures_of_hard(*hard))
    kinds = ", ".join(f"{number} {kind}" for kind, number in Counter(f.what.partition(":")[0] for f in found).items())
    print(
        f"{count} damaged displays, {len(found)} failures{': ' if kinds else ''}{kinds}, {time.perf_counter() - started:.0f} s"
    )
    return 1 if found else 0


def tell(failures: list[Failure]) -> list[Failure]:
    """Print failures as soon as they are known."""
    for failure in failures:
        print(f"{failure.handout}: {failure.what}: {failure.latex}", flush=True)
    return failures


def pages(count: int, seed: int) -> list[tuple[str, int]]:
    """Return the pages to draw: as many of every handout, each with a seed; those of one handout beside each other."""
    names = sorted(path.name for path in HANDOUTS.glob("*.md") if "$$" in path.read_text("utf-8"))
    return sorted((names[k % len(names)], seed + k) for k in range(-(-count // ON_A_PAGE)))


@lru_cache(maxsize=2)
def _handout(name: str) -> tuple[Document, Display | None]:
    """Return a handout, and its first display that is proved by itself."""
    document = read_document(HANDOUTS / name)
    for display in document.displays:
        if not display.erratum and [verdict for _, verdict in _verdicts(document, [display])] == ["proved"]:
            return document, display
    return document, None


def _verdicts(document: Document, displays: list[Display]) -> list[tuple[str, str]]:
    """Return the displays of a page with their verdicts, in the order of their lines; raises RuntimeError where one hides an internal error."""
    front = {key: value for key, value in document.front.items() if key != "inverse"}  # it needs all its displays
    page = replace(document, front=front, displays=tuple(displays), tables=())
    records = check_document(page).equations
    for record in records:
        if record.says(Kind.INTERNAL_ERROR):
            raise RuntimeError(record.message)
    return [(record.latex, record.verdict.value) for record in records]


def failures_of_page(drawn: tuple[str, int]) -> list[Failure]:
    """Return what fails on one page of damaged displays; a page that fails is searched display by display."""
    name, seed = drawn
    document, sentinel = _handout(name)
    rng = Random(seed)
    damaged = [
        replace(d, latex=mutate(d.latex, rng.choice(document.displays).latex, rng))
        for d in rng.choices(document.displays, k=ON_A_PAGE)
    ]
    together = _failure(document, sentinel, damaged)
    if not together:
        return []
    alone = [(d, what) for d in damaged if (what := _failure(document, sentinel, [d]))]
    if not alone and not together.startswith(
        TOO_SLOW
    ):  # only together; that twelve take longer than one may is no failure
        alone = [(damaged[0], f"only on the page of seed {seed}: {together}")]
    return [Failure(name, " ".join(d.latex.split()), what) for d, what in alone]


def failures_of_hard(arm: str, latex: str) -> list[Failure]:
    """Return what fails of a hard display."""
    what = _failure(Document(Path("page.md"), {"arm": arm}, (), ()), None, [Display(1, latex)])
    return [Failure(arm, latex, what)] if what else []


def _failure(document: Document, sentinel: Display | None, damaged: list[Display]) -> str:
    """Return what fails of a page, or ""; a page of several is too slow where one of them could be."""
    ends = [sentinel] if sentinel else []
    started = time.thread_time()
    try:
        verdicts = _verdicts(document, [*ends, *damaged, *ends])
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    seconds = time.thread_time() - started
    if len(verdicts) != len(damaged) + 2 * len(ends):
        return f"{len(damaged)} displays have {len(verdicts)} verdicts"
    of_ends = [verdict for latex, verdict in verdicts if sentinel and latex == sentinel.latex]
    if ends and (len(of_ends) < 2 or set(of_ends) != {"proved"}):
        return f"costs another its verdict: {', '.join(of_ends)}"
    return f"{TOO_SLOW}: {seconds:.1f} s" if seconds > BOUND + 0.5 else ""


def mutate(latex: str, other: str, rng: Random) -> str:
    """Return LaTeX with one or two damages; `other` is a display that pieces are taken from."""
    tokens = TOKEN.findall(latex)
    for _ in range(rng.choice([1, 1, 1, 2])):
        tokens = _damaged(tokens, other, rng) or ["x"]
    return "".join(tokens)


def _damaged(tokens: list[str], other: str, rng: Random) -> list[str]:
    at = rng.choice([k for k, token in enumerate(tokens) if not token.isspace()] or [0])
    end = _balanced(tokens, at, rng.randint(1, 12))
    kinds = ["delete", "insert", "cut", "double", "paste", *["swap", "relation", "wrap", "join"] * 2]
    kind = rng.choice(kinds)
    if kind == "relation":
        at = rng.choice([k for k, token in enumerate(tokens) if token in RELATIONS] or [at])
        return [*tokens[:at], f" {rng.choice(RELATIONS)} ", *tokens[at + 1 :]]
    if kind == "wrap":
        before, after = rng.choice(WRAPS)
        depth = rng.choice([1, 1, 3])
        return [*tokens[:at], *[before] * depth, *tokens[at:end], *[after] * depth, *tokens[end:]]
    if kind == "join":
        return [*tokens, f" {rng.choice(RELATIONS)} ", *TOKEN.findall(other)]
    alike = [token for token in tokens if token.isalnum() == tokens[at].isalnum() and token[0] != "\\"]
    pieces = {
        "delete": [],
        "cut": [],
        "insert": [rng.choice(PIECES), *tokens[at:end]],
        "swap": [rng.choice(alike or ["x"])],
        "double": tokens[at:end] * 2,
        "paste": [*tokens[at:end], " ", *rng.choice([tokens, TOKEN.findall(other)])[at:end]],
    }
    return [*tokens[:at], *pieces[kind], *tokens[at + 1 if kind in ("delete", "swap") else end :]]


def _balanced(tokens: list[str], start: int, count: int) -> int:
    """Return the end of a piece of about so many tokens in which braces and environments are whole, if there is one."""
    depth = 0
    for end in range(start, len(tokens)):
        depth += (tokens[end] in ("{", "(", r"\left", r"\begin")) - (tokens[end] in ("}", ")", r"\right", r"\end"))
        if depth < 0:
            return max(end, start + 1)
        if depth == 0 and end - start >= count:
            return end + 1
    return len(tokens)


if __name__ == "__main__":
    sys.exit(main())
