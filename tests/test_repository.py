"""The promises that the repository makes before any robot moves: its rooms, its make targets, its README."""

import ast
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import warnings
from collections.abc import Iterator
from functools import cache
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest
from pydrake.common.deprecation import DrakeDeprecationWarning

from tests.forked import armproof
from tests.sources import nodes_in

ROOT = Path(__file__).resolve().parent.parent
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT = PYPROJECT["project"]
LAYERS = ("course", "verification", "models")  # each may import those to its right


@cache
def imports_of(source: str) -> tuple[ast.Import | ast.ImportFrom, ...]:
    """Return the import statements of a module, wherever in it."""
    return tuple(node for node in nodes_in(source) if isinstance(node, ast.Import | ast.ImportFrom))


def imported_packages(source: str) -> frozenset[str]:
    """Return the top-level packages that a module imports; of our own, the rooms."""
    found = set()
    for node in imports_of(source):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return frozenset(name.removeprefix("armproof.").partition(".")[0] for name in found)


def imports_against_the_arrows(room: str, source: str) -> frozenset[str]:
    """Return what a module of the room imports although it may not."""
    return imported_packages(source) & {*LAYERS[: LAYERS.index(room)], "sympy", "tests"}


def modules() -> Iterator[tuple[str, Path]]:
    """Yield every module of the three rooms with its room."""
    for room in LAYERS:
        for path in sorted((ROOT / room).rglob("*.py")):
            yield room, path


DECLARED_FOR = {  # extras that a place may need; whoever has not installed them is told so
    "verification/pytest_plugin.py": "test",
    "verification/cli/server.py": "lsp",
    "course/feedback/hands_on.py": "lab",
    "course/sources": "lab",
    "verification/running/cluster.py": "cluster",
    "course/grading": "lab",
    "course/printing": "print",
}


@cache
def distributions() -> dict[str, set[str]]:
    """Return which distributions each top-level package that is installed comes from."""
    return {name: {found.lower() for found in names} for name, names in packages_distributions().items()}


def undeclared_imports(place: str, source: str) -> set[str]:
    """Return what a module imports that neither Python has nor pyproject.toml declares for its place."""
    extras = [name for start, name in DECLARED_FOR.items() if place.startswith(start)]
    lines = [*PROJECT["dependencies"], *(line for name in extras for line in PROJECT["optional-dependencies"][name])]
    declared = {
        name.lower() for line in lines for name in re.findall(r"[\w.-]+", re.split(r"[<>=;]", line)[0])
    }  # dask[distributed]
    nodes = imports_of(source)
    found = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    found |= {node.module for node in nodes if isinstance(node, ast.ImportFrom) and node.level == 0 and node.module}
    foreign = {name.partition(".")[0] for name in found} - {*sys.stdlib_module_names, "armproof"}
    return {name for name in foreign if not distributions().get(name, {name}) & declared}


@pytest.fixture
def make(tmp_path: Path):
    """Run make with an environment and a build folder of its own, and no settings of the make that runs the tests."""
    inherited = {"MAKEFLAGS", "MAKEOVERRIDES", "MAKELEVEL", "MFLAGS"}
    environment = {name: value for name, value in os.environ.items() if name not in inherited}

    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        folders = [f"VENV={tmp_path / 'venv'}", f"BUILD={tmp_path / 'build'}"]
        command = ["make", "--no-print-directory", *folders, *arguments]
        return subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=60)

    return run


def write_script(path: Path, body: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{body}\n", encoding="utf-8")
    path.chmod(0o755)
    return path


@pytest.fixture
def pretend_command(tmp_path: Path):
    """Set up an environment that looks installed and whose `armproof` is the script given."""

    def write(body: str) -> None:
        for name in ("bin/python", "bin/pip", "bin/armproof"):
            write_script(tmp_path / "venv" / name, body if name == "bin/armproof" else "exit 99")
        stamp = tmp_path / "venv" / ".installed"
        stamp.touch()
        later = max(stamp.stat().st_mtime, (ROOT / "pyproject.toml").stat().st_mtime) + 10
        os.utime(stamp, (later, later))

    return write


def test_the_import_contract_is_course_over_verification_over_models():
    settings = PYPROJECT["tool"]["importlinter"]
    contracts = [contract for contract in settings["contracts"] if contract["type"] == "layers"]
    assert contracts[0]["layers"] == [f"armproof.{room}" for room in LAYERS]
    assert settings["root_package"] == "armproof"
    assert not any("ignore_imports" in contract for contract in contracts)


def test_no_module_imports_against_the_arrows():
    found = list(modules())
    assert {room for room, _ in found} == set(LAYERS)
    for room, path in found:
        assert not imports_against_the_arrows(room, path.read_text(encoding="utf-8")), path


@pytest.mark.parametrize(
    ("room", "source"),
    [
        ("models", "import armproof.verification.cli"),
        ("models", "def late():\n    from armproof.course import lessons"),
        ("models", "from armproof import verification"),
        ("verification", "import json, armproof.course"),
        ("course", "from sympy import simplify"),
    ],
)
def test_an_import_against_the_arrows_is_noticed(room: str, source: str):
    assert imports_against_the_arrows(room, source)


@pytest.mark.parametrize(
    ("room", "source"),
    [
        ("course", "import armproof.verification, armproof.models"),
        ("verification", "from . import course"),
        ("models", "import numpy"),
    ],
)
def test_an_import_along_the_arrows_is_allowed(room: str, source: str):
    assert not imports_against_the_arrows(room, source)


def test_every_import_is_declared() -> None:
    found = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for _, path in modules()}
    found["armproof/__init__.py"] = (ROOT / "armproof/__init__.py").read_text(encoding="utf-8")
    undeclared = {place: names for place, source in found.items() if (names := undeclared_imports(place, source))}
    assert undeclared == {}


def test_an_import_that_is_not_declared_is_noticed() -> None:
    assert undeclared_imports("models/x.py", "def f():\n    import pytest") == {
        "pytest"
    }  # declared for the plugin alone
    assert undeclared_imports("models/x.py", "from nowhere.inside import y") == {"nowhere"}
    assert undeclared_imports("models/x.py", "import yaml, flint, os.path\nfrom armproof.models import arm") == set()


@pytest.mark.parametrize("room", LAYERS)
def test_the_linter_refuses_a_room_under_a_second_name(room: str):
    """`import models` beside `import armproof.models` would make every class twice."""
    ruff = Path(sys.executable).with_name("ruff")
    if not ruff.exists():
        pytest.skip("needs ruff: make lint installs it")
    for source, refused in (
        (f"import {room}.x", True),
        (f"from {room} import x", True),
        (f"import armproof.{room}", False),
    ):
        command = [ruff, "check", "--select", "TID251", "--stdin-filename", "tests/test_x.py", "-"]
        run = subprocess.run(command, cwd=ROOT, input=source, capture_output=True, text=True, timeout=60)
        assert bool(run.returncode) == refused, run.stdout


def test_the_packages_installed_are_the_folders_with_code():
    kept = {path.parent for room in LAYERS for path in (ROOT / room).rglob("*.py")} - {ROOT / "course/lessons"}
    named = {"armproof", *(".".join(("armproof", *folder.relative_to(ROOT).parts)) for folder in kept)}
    assert PYPROJECT["tool"]["setuptools"]["packages"] == sorted(named)


def test_a_drake_deprecation_is_an_error():
    with pytest.raises(DrakeDeprecationWarning):
        warnings.warn("a name that Drake will remove", DrakeDeprecationWarning, stacklevel=1)


def test_this_python_is_one_that_the_project_supports():
    lowest, highest = re.fullmatch(r">=3\.(\d+),<3\.(\d+)", PYPROJECT["project"]["requires-python"]).groups()
    assert int(lowest) <= sys.version_info.minor < int(highest)
    check = re.search(r"\(3, (\d+)\) <= sys\.version_info\[:2\] <= \(3, (\d+)\)", (ROOT / "Makefile").read_text())
    assert (int(check[1]), int(check[2])) == (int(lowest), int(highest) - 1)


@pytest.mark.parametrize("target", ["report", "test", "lint", "mutation", "benchmark"])
def test_every_target_refuses_an_old_python_in_one_sentence(make, tmp_path: Path, target: str):
    old = write_script(tmp_path / "python3.9", '[ "$1" = --version ] && echo Python 3.9.2 && exit 0\nexit 1')
    run = make(target, f"PYTHON={old}")
    assert run.returncode != 0
    assert f"Armproof needs Python 3.11, 3.12 or 3.13, and '{old}' is Python 3.9.2." in run.stderr
    assert "Traceback" not in run.stderr
    assert not (tmp_path / "venv").exists()


def test_a_missing_python_is_named(make, tmp_path: Path):
    run = make("test", f"PYTHON={tmp_path / 'python3'}")
    assert run.returncode != 0
    assert f"there is no '{tmp_path / 'python3'}'" in run.stderr


@pytest.mark.parametrize("code", [0, 1, 2])
def test_report_writes_pages_and_passes_the_exit_code_on(make, pretend_command, tmp_path: Path, code: int):
    pretend_command(f'echo "$@" > {tmp_path}/called\necho 3 proved\nexit {code}')
    run = make("report")
    assert (run.returncode == 0) == (code == 0)
    assert "3 proved" in run.stdout
    assert (tmp_path / "called").read_text().split() == [
        "verify",
        "course/handouts",
        "course/lessons",
        "--report",
        str(tmp_path / "build/report"),
    ]
    assert (f"The pages: {tmp_path / 'build/report'}/index.html" in run.stdout) == (code < 2)


def test_continuous_integration_lints_before_it_tests(tmp_path: Path):
    write_script(tmp_path / "bin/make", f'echo "$1" >> {tmp_path}/calls')
    for browser in ("chromium", "chromedriver"):  # or it would be installed
        write_script(tmp_path / "bin" / browser, "exit 0")
    checkout = tmp_path / "checkout/.ci"
    checkout.mkdir(parents=True)
    shutil.copy(ROOT / ".ci/run", checkout)
    environment = os.environ | {"PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}"}
    subprocess.run([checkout / "run"], cwd=tmp_path, env=environment, check=True, timeout=60)
    assert (tmp_path / "calls").read_text().split() == ["lint", "report", "test", "test-rest"]


def test_the_readme_names_every_make_target():
    phony = re.search(r"^\.PHONY: (.+)$", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)[1].split()
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert [target for target in phony if f"| `{target}` |" not in readme] == []


def test_the_example_of_the_readme_has_one_wrong_sign(tmp_path: Path):
    example = re.search(r"^```markdown\n(---\n.*?)^```$", (ROOT / "README.md").read_text(), re.MULTILINE | re.DOTALL)[1]
    (tmp_path / "planar-2r.md").write_text(example, encoding="utf-8")
    document = tmp_path / "planar-2r.md"
    run = armproof("verify", document, "--format", "json", folder=ROOT, environment=os.environ)
    assert run.returncode == 1, run.stderr
    [document] = json.loads(run.stdout)["documents"]
    assert [record["verdict"] for record in document["equations"]] == ["proved", "refuted", "proved"]
    [entry] = document["equations"][1]["entries"]
    assert (entry["row"], entry["column"]) == (1, 2)
    assert re.sub(r"\s", "", entry["correct"]) == "-l_2S_{12}"
