"""Armproof among the modules of others, and from a wheel: one import name takes nothing from them."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
ROOMS = ("models", "verification", "course")
SHEET = "---\narm: planar_2r\n---\n\n$$ C_{12} = C_1 C_2 - S_1 S_2 $$\n\n$$ S_{12} = S_1 $$\n"
# Hides the editable install: what is then imported comes from the folder that stands first on the path.
HIDDEN = """
import sys
sys.meta_path[:] = [finder for finder in sys.meta_path if "__editable__" not in getattr(finder, "__module__", "")]
sys.path[:] = [sys.argv[1], *(place for place in sys.path if place != sys.argv[2])]
"""


def run_python(folder: Path, *arguments: str | Path, **settings: str) -> subprocess.CompletedProcess[str]:
    """Run Python in a folder, in which no path of this repository is searched but that of the installation."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PYTEST"))}
    command = [sys.executable, *map(str, arguments)]
    return subprocess.run(
        command, cwd=folder, env=environment | settings, capture_output=True, text=True, timeout=120, check=False
    )


def test_a_notebook_stands_beside_modules_of_the_same_names(tmp_path: Path):
    """A kernel searches the notebook's folder first, as a script does."""
    for room in ROOMS:
        (tmp_path / f"{room}.py").write_text("whose = 'the student'\n")
    (tmp_path / "notebook.py").write_text(
        "import models, verification, course\n"
        "from armproof import open_lesson\n"
        "assert models.whose == verification.whose == course.whose == 'the student'\n"
        "lesson = open_lesson('scara_jacobian')\n"
        r"print(*(lesson.determinant.check(latex).outcome for latex in (r'-a_1 a_2 \sin\theta_2', r'a_1 a_2')))"
    )
    run = run_python(tmp_path, "notebook.py", ARMPROOF_PROGRESS="")
    assert run.stdout.split("\n")[-2:] == ["correct (proved) wrong", ""], run.stdout + run.stderr


def test_a_foreign_repository_with_packages_of_the_same_names_is_tested(tmp_path: Path):
    for room in ROOMS:
        (tmp_path / room).mkdir()
        (tmp_path / room / "__init__.py").write_text("")
        (tmp_path / room / "errors.py").write_text("whose = 'the teacher'\n")
    (tmp_path / "test_own.py").write_text(
        "from course import errors as ours\nfrom models import errors\nfrom verification import errors as third\n\n"
        "def test_names():\n    assert errors.whose == ours.whose == third.whose == 'the teacher'\n"
    )
    (tmp_path / "sheet.md").write_text(SHEET)
    run = run_python(tmp_path, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--tb=line", "-rA")
    ended = run.stdout.splitlines()
    assert run.returncode == 1, run.stdout + run.stderr
    assert {"PASSED test_own.py::test_names", "PASSED sheet.md::sheet.md:5"} <= set(ended)
    assert any(line.startswith("FAILED sheet.md::sheet.md:7") for line in ended)
    assert ended[-1].startswith("1 failed, 2 passed")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build a wheel of a copy of the sources, with the setuptools that is here: nothing is fetched."""
    pytest.importorskip("setuptools", minversion="77")
    copy = tmp_path_factory.mktemp("sources")
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, copy)
    for room in ("armproof", *ROOMS):
        shutil.copytree(ROOT / room, copy / room, ignore=shutil.ignore_patterns("__pycache__", ".*"))
    build = "from setuptools.build_meta import build_wheel; build_wheel('dist')"
    run = run_python(copy, "-c", build)
    assert run.returncode == 0, run.stderr
    [built] = (copy / "dist").glob("*.whl")
    return built


def missing_from(names: set[str]) -> set[str]:
    """Return the files of the rooms that are not in a wheel, by their names in it."""
    files = [path for room in ROOMS for path in (ROOT / room).rglob("*") if path.is_file()]
    ours = {f"armproof/{path.relative_to(ROOT).as_posix()}" for path in files if "__pycache__" not in path.parts}
    return (ours | {"armproof/__init__.py", "armproof/py.typed"}) - names


def test_the_wheel_holds_code_and_data(wheel: Path):
    names = set(zipfile.ZipFile(wheel).namelist())
    assert missing_from(names) == set()
    assert {name.partition("/")[0].partition("-")[0] for name in names} == {"armproof"}
    for name in ("models/scara/scara.urdf", "verification/latex/kinematics.lark", "course/lessons/01_frames.py"):
        assert missing_from(names - {f"armproof/{name}"}) == {f"armproof/{name}"}


def test_the_wheel_works_alone(wheel: Path, tmp_path: Path):
    site = tmp_path / "site"
    zipfile.ZipFile(wheel).extractall(site)
    uses = """
import armproof, armproof.course
from pathlib import Path
from armproof import inverse_of, open_lesson, verify
from armproof.verification.cli import main
course = Path(next(iter(armproof.course.__path__)))
print(verify(course / "handouts/planar-2r-002.md").passed, len(inverse_of("planar_2r").branches))
print(open_lesson("scara_jacobian").determinant.check(r"a_1 a_2 \\sin\\theta_2")._repr_html_().count("<style>"))
print(all(Path(m.__file__).is_relative_to(sys.argv[1]) for n, m in sys.modules.items() if n.startswith("armproof")))
sys.argv[1:] = ["verify", str(course / "handouts/planar-2r-002.md"), "--report", "pages"]
main()
"""
    run = run_python(tmp_path, "-c", HIDDEN + uses, site, ROOT)
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.splitlines()[:3] == ["True 2", "1", "True"], run.stdout
    assert (tmp_path / "pages/index.html").exists()
    (site / "armproof/models/scara/scara.urdf").unlink()
    broken = run_python(tmp_path, "-c", f"{HIDDEN}from armproof import load_arm; load_arm('scara')", site, ROOT)
    assert broken.returncode == 1 and "scara.urdf" in broken.stderr
