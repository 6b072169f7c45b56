"""The face, `import armproof`: what a user needs, typed, and loaded when it is first asked for."""

import ast
import dataclasses
import doctest
import re
import subprocess
import sys
from enum import Enum
from importlib import import_module
from pathlib import Path

import pytest

import armproof

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
FACE = ast.parse(Path(armproof.__file__).read_text(encoding="utf-8"))
SHEET = "---\narm: planar_2r\n---\n\n$$ C_{12} = C_1 C_2 - S_1 S_2 $$\n\n$$ S_{12} = S_1 $$\n"
NOT_VALUES = {
    "Arm",
    "BulkKinematics",
    "InverseKinematics",
    "Lesson",
    "NumericKinematics",
    "Trace",
}  # they are given, and have methods that compute


def imports_for_types() -> dict[str, str]:
    """Return the names that the face imports for readers and type checkers, each with where it stands."""
    [block] = [node for node in FACE.body if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"]
    return {alias.name: node.module for node in block.body if isinstance(node, ast.ImportFrom) for alias in node.names}


def modules_after(*programs: str) -> list[set[str]]:
    """Return the modules that are loaded after each of some programs, which run one behind the other in a process of their own."""
    shown = "\n".join(f"{program}\nimport sys; print(*sys.modules)" for program in programs)
    run = subprocess.run([sys.executable, "-c", shown], capture_output=True, text=True, timeout=60, check=True)
    return [set(line.split()) for line in run.stdout.splitlines()]


def test_the_face_re_exports_and_does_nothing_else():
    assert {node.name for node in ast.walk(FACE) if isinstance(node, ast.ClassDef | ast.FunctionDef)} == {
        "__getattr__",
        "__dir__",
    }
    assert Path(armproof.__file__).with_name("py.typed").exists()
    assert {path.name for path in (ROOT / "armproof").iterdir()} - {"__pycache__"} == {"__init__.py", "py.typed"}


def test_readers_type_checkers_and_python_are_told_the_same():
    homes = {name: home for home, names in armproof._HOMES.items() for name in names}
    assert homes == imports_for_types()
    assert sorted(homes) == sorted(armproof.__all__)
    assert set(armproof.__all__) <= set(dir(armproof))


@pytest.mark.parametrize("name", armproof.__all__)
def test_a_name_is_that_of_its_room_and_documented(name: str):
    found = getattr(armproof, name)
    assert found is getattr(import_module(imports_for_types()[name]), name)
    assert found.__doc__
    if isinstance(found, type) and not issubclass(found, Enum | Exception) and name not in NOT_VALUES:
        assert dataclasses.is_dataclass(found) and found.__dataclass_params__.frozen


def test_a_name_that_the_face_has_not_is_refused():
    with pytest.raises(AttributeError, match="module 'armproof' has no attribute 'verifi'"):
        _ = armproof.verifi
    with pytest.raises(ImportError):
        from armproof import verifi  # noqa: F401


def test_importing_the_face_loads_nothing_heavy():
    heavy = {"numpy", "pydrake", "matplotlib", "flint", "lark", "yaml", "jinja2", "typer"}
    values = "from armproof import Verdict, DocumentError, WrongEntry"
    alone, light, loaded = modules_after("import armproof", values, "from armproof import load_arm; load_arm('scara')")
    assert not alone & heavy
    assert not light & {"pydrake", "matplotlib"}
    assert {"numpy", "pydrake"} <= loaded


def test_a_text_has_the_verdicts_of_its_file():
    path = ROOT / "course/handouts/planar-2r-002.md"
    text = path.read_text(encoding="utf-8")
    of_file, of_text = armproof.verify(str(path)), armproof.verify_text(text, path=path)
    assert dataclasses.replace(of_text, seconds=of_file.seconds) == of_file
    assert armproof.verify_text(text.replace("C_{12}", "S_{12}"), path=path).as_json() != of_file.as_json()


def test_a_plain_document_loads_no_more_than_it_needs():
    rooms = ("inverse", "inverse.proof", "singularities.analysis", "conditions.entailment", "report.html")
    unused = {"matplotlib", "jinja2", "armproof.course", *(f"armproof.verification.{name}" for name in rooms)}
    check = "from armproof import verify_text; verify_text({!r})"
    condition = SHEET + "\n$$ \\det J = 0 \\iff \\theta_2 = 0 $$\n"
    plain, with_condition = modules_after(check.format(SHEET), check.format(condition))
    assert not plain & unused
    assert "armproof.verification.conditions.entailment" in with_condition


@pytest.mark.parametrize(
    ("format", "text"),
    [
        ("md", SHEET),
        ("", "\ufeff" + SHEET),
        ("tex", "% arm: planar_2r\n\\[ C_{12} = C_1 C_2 - S_1 S_2 \\]\n\\[ S_{12} = S_1 \\]\n"),
        ("py", f"# %% [markdown]\n{re.sub('(?m)^', '# ', SHEET)}"),
    ],
)
def test_a_text_is_read_in_its_format(format: str, text: str):
    result = armproof.verify_text(text, format)
    assert [record.verdict for record in result.equations] == [armproof.Verdict.PROVED, armproof.Verdict.REFUTED]
    assert not result.passed


def test_a_text_names_its_document_and_finds_arms_beside_it(tmp_path: Path):
    text = f"---\narm: {ROOT.name}/models/scara/scara.urdf\n---\n$$ 1 = 1 $$\n"
    assert armproof.verify_text(text, path=ROOT.parent / "draft.md").arm == "scara"
    with pytest.raises(armproof.DocumentError, match=re.escape(f"{tmp_path / 'draft.md'}:2: ")):
        armproof.verify_text(text, path=tmp_path / "draft.md")
    with pytest.raises(armproof.DocumentError, match="no format 'docx'; the formats are md, ipynb, py, qmd, tex, rst"):
        armproof.verify_text(text, "docx")


def test_the_example_in_the_readme_says_what_it_is_said_to_say(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    sheet = re.search(r"^```markdown\n(---\n.*?)^```$", README, re.MULTILINE | re.DOTALL)[1]
    (tmp_path / "planar-2r.md").write_text(sheet, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    session = re.search(r"^```pycon\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)[1]
    example = doctest.DocTestParser().get_doctest(session, {}, "README.md", "README.md", 0)
    assert len(example.examples) >= 4
    assert doctest.DocTestRunner().run(example).failed == 0


def test_the_imports_in_the_readme_work_and_take_from_the_face_what_it_has():
    snippets = re.findall(r"^```python\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    taken = [node for text in snippets for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom)]
    assert len(taken) >= 4
    for node in taken:
        for alias in node.names:
            assert hasattr(import_module(node.module), alias.name)
            assert (node.module == "armproof") == (alias.name in armproof.__all__), alias.name
