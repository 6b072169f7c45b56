"""A class graded on a Dask cluster: the results of a local run, only where nobody reads along and the sandbox holds."""

from __future__ import annotations

import os
from pathlib import Path
from types import SimpleNamespace

import pytest

from armproof.course.errors import GradingError
from armproof.course.grading.grading import grade
from armproof.course.grading.pages import write_grades
from armproof.course.grading.running import on_workers
from armproof.course.grading.running.on_workers import OnWorkers
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import find_submissions
from armproof.verification.errors import ClusterError
from armproof.verification.running import cluster as clusters
from armproof.verification.running.cluster import Cluster
from tests.clusters import Running
from tests.course.grading.invented import write_class
from tests.needs import needs

needs("distributed")
CRASHES = "import os\nos._exit(3)"


@pytest.fixture
def group(tmp_path: Path, write) -> Path:
    """Five students of the invented class, and one whose notebook ends its process."""
    write_class(tmp_path / "class", 5)
    write("Zoé.ipynb", CRASHES)
    return tmp_path / "class"


def test_a_class_has_the_results_of_a_local_run_byte_for_byte_but_for_the_times(
    bwrap, running: Running, group: Path, tmp_path: Path
):
    limits, submissions = Limits(seconds=60), find_submissions(group)
    here, there = tmp_path / "here", tmp_path / "there"
    for out, address in ((here, ""), (there, running.address)):
        out.mkdir()
        grades = grade(submissions, limits, scheduler=address)
        assert all(grades.held.values()) and sorted({str(each.status) for each in grades.graded}) == [
            "crashed",
            "graded",
        ]
        write_grades(out, grades)
    names = sorted(path.name for path in here.iterdir())
    assert names == sorted(path.name for path in there.iterdir()) and "times.csv" in names
    assert [name for name in names if (here / name).read_bytes() != (there / name).read_bytes()] == ["times.csv"]


def hide_bubblewrap() -> None:
    os.environ["ARMPROOF_PATH"], os.environ["PATH"] = os.environ["PATH"], ""


def show_bubblewrap() -> None:
    os.environ["PATH"] = os.environ.pop("ARMPROOF_PATH")


def test_where_a_worker_has_no_sandbox_nothing_is_run(running: Running, group: Path):
    with Cluster(running.address) as cluster:
        cluster.on_each(hide_bubblewrap)
        try:
            with pytest.raises(GradingError, match=r"worker tls://127.*: grading needs bubblewrap"):
                grade(find_submissions(group), Limits(seconds=5), scheduler=running.address)
        finally:
            cluster.on_each(show_bubblewrap)


def test_students_work_is_not_sent_where_others_read_along(group: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(clusters, "_connected", lambda address: pytest.fail("it was connected"))
    with pytest.raises(
        ClusterError, match=r"tcp://10\.0\.0\.1:8786: students' work is sent only to an encrypted address"
    ):
        grade(find_submissions(group), Limits(), scheduler="tcp://10.0.0.1:8786")


@pytest.mark.parametrize(
    ("scheduler", "worker"), [("tcp://10.0.0.1:1", "tcp://127.0.0.1:2"), ("tcp://127.0.0.1:1", "tcp://10.0.0.1:2")]
)
def test_nor_where_a_cluster_at_this_machine_reaches_further(
    scheduler: str, worker: str, monkeypatch: pytest.MonkeyPatch
):
    client = SimpleNamespace(
        wait_for_workers=lambda *_, **__: None, nthreads=lambda: {worker: 1}, scheduler_info=lambda: {"address": scheduler},
        run=lambda *_, **__: {}, close=lambda **_: None,
    )  # fmt: skip
    monkeypatch.setattr(clusters, "_connected", lambda address: client)
    with pytest.raises(ClusterError, match=r"tcp://10\.0\.0\.1:"), Cluster("tcp://127.0.0.1:1", private=True):
        pass
    with Cluster("tcp://127.0.0.1:1"):  # documents may be read by others
        pass


def test_lessons_of_a_teachers_own_travel_without_notebooks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    files = {"tasks/own.py": b"x = 1", "lessons/01_own.py": b"# %%", "lessons/01_own.ipynb": b"{}", ".git/HEAD": b"ref"}
    for name, data in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(data)
    found = dict(on_workers._files_of(tmp_path))
    assert found == {name: files[name] for name in ("lessons/01_own.py", "tasks/own.py")}
    with on_workers.ExitStack() as opened:
        folder = on_workers._unpacked(found.items(), opened)
        assert (folder / "tasks/own.py").read_bytes() == b"x = 1"
    assert not folder.exists()
    monkeypatch.setattr(on_workers, "_LARGEST", 4)
    with pytest.raises(GradingError, match="is not sent to a cluster"):
        OnWorkers("tcp://127.0.0.1:1", Limits(), own=tmp_path)
