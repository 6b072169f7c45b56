"""The whole site: built at once or not at all, over nothing that is not its own, the same every time."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from armproof.course.errors import SiteError
from armproof.course.site import build, cells, command, work
from armproof.course.site.build import build_site
from armproof.course.site.cells import cells_of
from armproof.course.site.order import Built, Order
from armproof.course.sources.lesson_source import read_lesson_source
from armproof.verification.report.html.folder import ReportFolderError, new_report
from tests.course.site.conftest import SECRET
from tests.course.site.test_page import check_valid

app = typer.Typer(pretty_exceptions_enable=False)
app.command()(command.site)


def run(*arguments: object):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


@pytest.fixture(scope="module", autouse=True)
def loaded(lesson, tmp_path_factory) -> None:
    """Build once in this process what the processes of the builds, copies of it, would each load and trace anew."""
    source, place = lesson()
    order, folder = Order((source.path,), place), tmp_path_factory.mktemp("loaded")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cells, "execute", lambda source, place, *, solved: cells_of(source))
        described = work.describe(order)
        assert not work.build_lesson(order, described, 0, folder).problem
        work.build_rest(order, described, folder)


@pytest.fixture
def order(lesson) -> Order:
    source, place = lesson()
    return Order((source.path,), place)


@pytest.fixture
def no_kernel(monkeypatch):
    """Execute nothing; processes inherit it."""
    monkeypatch.setattr(cells, "execute", lambda source, place, *, solved: cells_of(source))


def content(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def test_a_lesson_is_executed_and_a_site_stands_on_its_own(order, tmp_path):
    told: list[Built] = []
    index = build_site(order, tmp_path / "out", done=told.append)
    stem = order.sources[0].stem
    files = content(tmp_path / "out")
    assert sorted(files) == sorted([f"{stem}.html", f"{stem}.ipynb", "files.json", "index.html", "planar_2r-3d.html"])
    assert index.is_file() and [(built.source, built.problem) for built in told] == [(order.sources[0], "")]
    for name in (f"{stem}.html", "index.html"):
        check_valid(files[name].decode())
    assert "rank: None" in files[f"{stem}.html"].decode()  # it was executed
    assert not any(SECRET.encode() in data for name, data in files.items() if name.endswith(".html"))
    notebook = json.loads(files[f"{stem}.ipynb"])
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert code and not any(cell["outputs"] or SECRET in "".join(cell["source"]) for cell in code)
    view = files["planar_2r-3d.html"].decode()
    assert view.startswith("<!DOCTYPE html>") and "<title>" in view[:600] and 'lang="en"' in view[:300]
    assert not re.search(r"""<(?:script|link|img)[^>]*(?:src|href)=["']?https?:""", view)


def test_a_lesson_that_does_not_run_is_named_with_cell_line_and_exception(order, tmp_path, monkeypatch):
    source = read_lesson_source(order.sources[0])
    fault = cells.Fault(4, 5, "ZeroDivisionError: division by zero\nand more")
    monkeypatch.setattr(cells, "run_cells", lambda *arguments: execution_run(fault))
    start = source.cells[4].line
    expected = rf"{source.path}:{start}: cell 4, line 5, does not run: ZeroDivisionError: division by zero"
    with pytest.raises(SiteError, match=f"^{re.escape(expected)}$"):
        cells.execute(source, order.place)
    with pytest.raises(
        SiteError, match=f":{start + 4}: cell 4, line 5"
    ):  # the line of the file, where that is what ran
        cells.execute(source, order.place, solved=True)
    with pytest.raises(SiteError, match="cell 4, line 5"):
        build_site(order, tmp_path / "out")
    assert not (tmp_path / "out").exists() and not list(tmp_path.glob(".out*"))


def execution_run(fault):
    from armproof.course.sources.kernel import Run

    return Run(1.0, fault=fault)


@pytest.mark.usefixtures("no_kernel")
def test_the_same_lessons_give_the_same_bytes(order, tmp_path):
    for name in ("one", "two"):
        build_site(order, tmp_path / name)
    assert content(tmp_path / "one") == content(tmp_path / "two")
    build_site(Order(order.sources, order.place, solutions=True), tmp_path / "two")  # a site takes the place of another
    assert content(tmp_path / "one") != content(tmp_path / "two")


@pytest.mark.usefixtures("no_kernel")
def test_what_fails_leaves_the_site_that_was_there_and_names_every_lesson_at_fault(lesson, tmp_path, monkeypatch):
    one, place = lesson()
    two, _ = lesson(place=place)
    build_site(Order((one.path,), place), tmp_path / "out")
    before = content(tmp_path / "out")
    for source in (one, two):
        text = source.path.read_text(encoding="utf-8")
        source.path.write_text(text.replace("l_1 S_1 + l_2 S", "l_1 S_1 - l_2 S"), encoding="utf-8")
    with pytest.raises(SiteError) as caught:
        build_site(Order((one.path, two.path), place), tmp_path / "out")
    assert [one.name in line for line in str(caught.value).splitlines()] == [True, False]
    assert two.name in str(caught.value) and content(tmp_path / "out") == before


@pytest.mark.usefixtures("no_kernel")
def test_a_notebook_that_someone_works_in_is_not_replaced(order, tmp_path):
    build_site(order, tmp_path / "out")
    build_site(order, tmp_path / "out")  # one that nobody changed is
    notebook = tmp_path / "out" / f"{order.sources[0].stem}.ipynb"
    notebook.write_text(notebook.read_text(encoding="utf-8").replace("your code", "my code"), encoding="utf-8")
    before = content(tmp_path / "out")
    with pytest.raises(ReportFolderError, match=rf"holds '{notebook.name}', which is no part of a site"):
        build_site(order, tmp_path / "out")
    assert content(tmp_path / "out") == before


@pytest.mark.parametrize("left", [{"thesis.tex": "mine"}, {"files.json": "{}"}, {"files.json": "["}, {"page.html": "<p>mine</p>"}])  # fmt: skip
def test_a_folder_that_holds_anything_else_is_refused_before_a_lesson_is_run(order, tmp_path, monkeypatch, left):
    monkeypatch.setattr(build, "_build_all", lambda *arguments: pytest.fail("a lesson was run"))
    (tmp_path / "out").mkdir()
    for name, text in left.items():
        (tmp_path / "out" / name).write_text(text, encoding="utf-8")
    with pytest.raises(ReportFolderError, match="which is no part of a site; --out takes a folder of its own"):
        build_site(order, tmp_path / "out")
    assert [path.name for path in (tmp_path / "out").iterdir()] == list(left)


def test_a_report_is_still_no_place_for_notebooks(tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "a.ipynb").write_text("{}", encoding="utf-8")
    with (
        pytest.raises(ReportFolderError, match="no part of a report; --report takes"),
        new_report(tmp_path / "out"),
    ):
        pass


# -- the command -------------------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("no_kernel")
def test_the_command_says_where_the_index_is(order, tmp_path):
    result = run("--folder", order.place.root, "--out", tmp_path / "site")
    assert (result.exit_code, result.stdout) == (0, f"{tmp_path / 'site' / 'index.html'}\n"), result.output
    assert re.search(r"1 lesson in \d+ s", result.stderr)


@pytest.mark.usefixtures("no_kernel")
def test_the_editions_go_into_folders_of_their_own(order, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("--folder", order.place.root).stdout == "build/site/index.html\n"
    assert run("--folder", order.place.root, "--solutions", "3").stdout == "build/site-solutions/index.html\n"


def test_an_unknown_lesson_is_answered_with_those_there_are(order, tmp_path):
    result = run("--folder", order.place.root, "scara", "--out", tmp_path / "site")
    assert result.exit_code == 2 and re.search(r"no lesson 'scara'; the lessons are 03_tiny_\d+", result.stderr)
    assert not (tmp_path / "site").exists()


@pytest.mark.usefixtures("no_kernel")
def test_a_lesson_that_does_not_pass_ends_the_command_with_1(order, tmp_path):
    path = order.sources[0]
    path.write_text(path.read_text(encoding="utf-8").replace("l_1 S_1 + l_2 S", "l_1 S_1 - l_2 S"), encoding="utf-8")
    result = run("--folder", order.place.root, "--out", tmp_path / "site")
    assert result.exit_code == 1 and "an equation does not pass" in result.stderr and result.stdout == ""


@pytest.mark.skipif(sys.platform == "win32", reason="a file where a folder should be")
def test_a_folder_that_cannot_be_written_is_named(order, tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    result = run("--folder", order.place.root, "--out", tmp_path / "file" / "site")
    assert result.exit_code == 2 and "the site cannot be written" in result.stderr and "Traceback" not in result.output


def test_without_jupyter_the_command_says_what_to_install(order, tmp_path, monkeypatch):
    monkeypatch.setattr("armproof.course.sources.kernel.find_spec", lambda name: None)
    result = run("--folder", order.place.root, "--out", tmp_path / "site")
    assert result.exit_code == 2 and "pip install" in result.stderr


def test_the_course_is_what_is_built_by_default(tmp_path):
    result = run("no_such_lesson", "--out", tmp_path / "site")
    assert result.exit_code == 2 and "12_scara_jacobian" in result.stderr
