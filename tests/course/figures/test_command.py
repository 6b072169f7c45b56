"""`armproof figures`: what it writes, its exit codes, and how the command is found."""

import subprocess
import sys
from collections.abc import Callable
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from armproof.course.figures.registry import KINDS, figures_for, find_kind
from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names
from armproof.verification.cli import app, application

ROOT = Path(__file__).resolve().parents[3]
TABLE = """\
---
arm:
  dh: classic
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: theta_1}
    - {a: l_2, alpha: 0, d: 0, theta: theta_2}
---

$$ p_2 = p_2 $$
"""
Run = tuple[int, str, str]


@pytest.fixture
def armproof(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Callable[..., Run]:
    """Run the command in this process, its entry point as pyproject.toml has it."""
    point = EntryPoint("figures", "armproof.course.figures.output.command:figures", application.GROUP)
    monkeypatch.setattr(application, "commands", lambda: {"figures": point})

    def run(*arguments: object) -> Run:
        with pytest.raises(SystemExit) as end:
            app([str(argument) for argument in arguments], prog_name="armproof")
        captured = capsys.readouterr()
        return int(end.value.code or 0), captured.out, captured.err

    return run


def test_pyproject_has_the_entry_point() -> None:
    import tomllib

    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["entry-points"][application.GROUP]["figures"] == "armproof.course.figures.output.command:figures"


def test_it_writes_the_figures_asked_for(armproof: Callable[..., Run], tmp_path: Path) -> None:
    code, out, error = armproof("figures", "sketch", "--arm", "planar_2r", "--format", "pdf,svg", "--out", tmp_path)
    assert (code, error) == (0, "")
    assert out.splitlines() == [str(tmp_path / f"planar_2r-sketch.{suffix}") for suffix in ("pdf", "svg")]
    assert (
        (tmp_path / "planar_2r-sketch.txt").read_text(encoding="utf-8").startswith("Kinematic sketch: Planar 2R arm.")
    )


def test_french_files_stand_beside_the_english_ones(armproof: Callable[..., Run], tmp_path: Path) -> None:
    armproof("figures", "sketch", "--arm", "polar_rp", "--format", "svg", "--lang", "fr", "--out", tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["polar_rp-sketch-fr.svg", "polar_rp-sketch-fr.txt"]


def test_the_arm_of_a_document_is_drawn(armproof: Callable[..., Run], tmp_path: Path) -> None:
    (tmp_path / "sheet.md").write_text(TABLE, encoding="utf-8")
    code, out, _ = armproof("figures", "sketch", "--arm", tmp_path / "sheet.md", "--format", "svg", "--out", tmp_path)
    assert (code, out.strip()) == (0, str(tmp_path / "sheet-sketch.svg"))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("nonsense",), f"no figure 'nonsense'; the figures are {KINDS[0]}"),
        (("--arm", "nonsense"), f"no arm 'nonsense'; an arm is one of {arm_names()[0]}"),
        (("--lang", "de"), "no language 'de'; the languages are en, fr"),
        (("--format", "bmp"), "no format 'bmp'; figures are written as pdf, svg, png, pgf"),
        (("--format", ","), "--format is empty"),
        (("sketch", "--arm", "planar_2r", "--out", "/dev/null/x"), "cannot be written"),
    ],
)
def test_bad_input_lists_what_is_known(
    arguments: tuple[str, ...],
    message: str,
    armproof: Callable[..., Run],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, error = armproof("figures", *arguments)
    assert (code, out) == (2, "")
    assert message in error
    assert len(error.splitlines()) == 1


def test_a_figure_that_fails_does_not_take_the_others_with_it(
    armproof: Callable[..., Run], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from dataclasses import replace

    from armproof.course.figures import registry

    broken = replace(find_kind("sketch"), draw=lambda arm, lang: 1 / 0)  # type: ignore[arg-type,return-value]
    monkeypatch.setattr(registry, "KINDS", ("sketch", "postures"))
    monkeypatch.setattr(registry, "find_kind", {"sketch": broken, "postures": find_kind("postures")}.__getitem__)
    code, out, error = armproof("figures", "--arm", "polar_rp", "--format", "svg", "--out", tmp_path)
    assert code == 1
    assert "polar_rp-sketch: cannot be drawn: ZeroDivisionError" in error
    assert out.splitlines() == [str(tmp_path / "polar_rp-postures.svg")]


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from importlib.metadata import EntryPoint; from armproof.verification.cli import application, main;"
        f"application.commands = lambda: {{'figures': EntryPoint('figures', 'armproof.course.figures.output.command:figures', {application.GROUP!r})}};"
        "sys.argv = ['armproof', '--help']\ntry: main()\nexcept SystemExit: pass\n"
        "print([name for name in ('pydrake', 'numpy', 'matplotlib') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert "figures" in done.stdout
    assert done.stdout.splitlines()[-1] == "[]"


def loaded(*lines: str) -> list[set[str]]:
    """The modules of this project that are there after each line of some code that runs in a process of its own."""
    tell = "print(*(name for name in sys.modules if name.startswith('armproof.')))"
    code = "\n".join(["import sys", *(f"{line}\n{tell}" for line in lines)])
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    return [set(line.split()) for line in done.stdout.splitlines()]


def test_a_kind_is_found_without_the_others() -> None:
    find = "from armproof.course.figures.registry import KINDS, find_kind; KINDS"
    nothing, sketch, singular = loaded(find, "find_kind('sketch')", "find_kind('singular')")
    assert not {name for name in nothing if ".kinds" in name}
    assert {name for name in sketch if ".kinds." in name} == {"armproof.course.figures.kinds.sketch"}
    assert "armproof.verification.singularities" in singular - sketch
    assert {name for name in singular - sketch if ".kinds." in name} == {"armproof.course.figures.kinds.singular"}


def test_every_module_has_a_kind_with_a_title() -> None:
    assert sorted(KINDS) == sorted(path.stem for path in (ROOT / "course/figures/kinds").glob("[!_]*.py"))
    for name in KINDS:
        kind = find_kind(name)
        assert kind.name == name
        assert kind.title("en") != kind.title("fr") or name == "quintic"


def test_arms_have_their_figures(arm: Arm) -> None:
    names = {kind.name for kind in figures_for(arm)}
    assert {"sketch", "singular"} <= names
