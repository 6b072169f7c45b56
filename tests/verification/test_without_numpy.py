"""What reads and proves a document needs no NumPy and no Drake: it works where importing them raises."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from collections.abc import Iterable
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

import pytest

import armproof.verification
from armproof.models.catalogue import load_arm
from armproof.models.exact.value import write_value
from armproof.verification.check import verify

PROGRAM = """
import importlib, sys
sys.modules.update(numpy=None, pydrake=None)
none = sys.argv[1] == "--none"
for name in sys.argv[1 + none:]:
    try:
        importlib.import_module(name)
    except ModuleNotFoundError:
        if none:
            continue
        raise
    assert not none, name
"""
ROOT = Path(armproof.verification.__path__[0]).parent


def modules_of(patterns: Iterable[str]) -> set[str]:
    """Return the names of the modules that names of modules and packages, or patterns of them, stand for."""
    roots = ROOT / "models", ROOT / "verification"
    files = [path.relative_to(ROOT).with_suffix("") for root in roots for path in root.rglob("*.py")]
    patterns = tuple(patterns)
    names = {f"armproof.{'.'.join(file.parts)}".removesuffix(".__init__") for file in files}
    return {name for name in names for pattern in patterns if fnmatch(name, pattern) or name.startswith(f"{pattern}.")}


def contract() -> dict[str, list[str]]:
    """Return the contract of pyproject.toml that the exact path stands alone."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text())
    (found,) = (c for c in settings["tool"]["importlinter"]["contracts"] if "stands alone" in c["name"])
    return dict(found)


CONTRACT = contract()
SAMPLING = modules_of(
    line.removesuffix(" -> numpy").removesuffix(".*") for line in CONTRACT["ignore_imports"] if line.endswith("numpy")
)

PROOF = """
import json, sys
sys.modules.update(numpy=None, pydrake=None)
from pathlib import Path
from armproof.models.exact.value import read_value
from armproof.verification.check import check_document
from armproof.verification.document import parse_document
order = json.load(sys.stdin)
document = parse_document(Path("handout.md"), order["text"])
result = check_document(document, arm=read_value(order["arm"]), samples=False)
told = [[(e.row, e.column, e.printed, e.correct) for e in record.entries] for record in result.records]
print(json.dumps([[r.verdict.value, [f.kind.value for f in r.findings], e] for r, e in zip(result.records, told)]))
"""


def imported(*names: str) -> subprocess.CompletedProcess[str]:
    """Return what became of importing modules where importing NumPy or Drake raises."""
    return subprocess.run([sys.executable, "-c", PROGRAM, *names], capture_output=True, text=True, check=False)


def test_what_reads_and_what_proves_imports_neither_numpy_nor_drake() -> None:
    exact = sorted(modules_of(CONTRACT["source_modules"]) - SAMPLING)
    assert len(exact) > 100
    found = imported(*exact)
    assert found.returncode == 0, found.stderr


def test_what_samples_imports_numpy() -> None:
    assert len(SAMPLING) > 15
    found = imported("--none", *sorted(SAMPLING))
    assert found.returncode == 0, found.stderr


# -- the exact path alone ---------------------------------------------------------------------------------------------


@cache
def value_of(arm: str) -> str:
    """Return an arm as its value."""
    return write_value(load_arm(arm))


def proved_alone(text: str, arm: str) -> list[list[object]]:
    """Return verdict, kinds of findings and wrong entries of each record, where importing NumPy or Drake raises."""
    order = json.dumps({"text": text, "arm": value_of(arm)})
    done = subprocess.run([sys.executable, "-c", PROOF], input=order, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return [list(record) for record in json.loads(done.stdout)]


def test_a_handout_is_proved_and_its_errata_refuted_without_numpy_and_drake() -> None:
    path = ROOT / "course/handouts/rx90-001.md"
    records = verify(path, confirm=False).records
    alone = proved_alone(path.read_text(), "rx90")
    assert [verdict for verdict, *_ in alone] == [record.verdict.value for record in records]
    assert sum(verdict == "proved" for verdict, *_ in alone) >= 46
    entries = [[[e.row, e.column, e.printed, e.correct] for e in record.entries] for record in records]
    assert [found for *_, found in alone] == entries
    assert sum(map(bool, entries)) >= 3


SAMPLED = [
    r"\sqrt{(a_3 - d_3)^2} = a_3 - d_3",  # the sign of a root, for the arm's lengths
    r"\arctan\frac{S_1}{C_1} = \theta_1",
    r"C_1 \le 2 + S_1",
    r"a_3 + d_3 \approx 0.9",
    r"C_1 = 0.5 \Rightarrow S_1 = S_2",
]


@cache
def left_open() -> list[list[object]]:
    """Return the records of displays that only samples decide, and of a solution of the inverse kinematics."""
    front = "---\narm: rx90\ninverse: {target: [P_x, P_y, P_z]}\n---\n"
    return proved_alone(front + "\n".join(f"$${display}$$\n" for display in SAMPLED), "rx90")


@pytest.mark.parametrize("number", range(len(SAMPLED)), ids=SAMPLED)
def test_what_only_samples_decide_is_left_open(number: int) -> None:
    kind = "numbers_of_nowhere" if "bmatrix" in SAMPLED[number] else "not_sampled"  # where it holds is found by samples
    assert left_open()[number] == ["unchecked", [kind], []]


def test_a_solution_of_the_inverse_kinematics_is_left_open() -> None:
    assert left_open()[len(SAMPLED) :] == [["unchecked", ["not_sampled"], []]]
