"""Documents checked on a Dask cluster: what a local run gives, byte for byte, whatever becomes of a worker; else nothing."""

from __future__ import annotations

import os
import shutil
import signal
import sys
from contextvars import copy_context
from multiprocessing import Pipe
from pathlib import Path
from types import SimpleNamespace

import pytest

from armproof.verification.cli.documents import check_and_report
from armproof.verification.errors import ClusterError
from armproof.verification.report.html.folder import new_report
from armproof.verification.report.html.site import page_names, page_writer, write_index
from armproof.verification.running import cluster as clusters
from armproof.verification.running import on_worker
from armproof.verification.running import servant as servants
from armproof.verification.running.cluster import Cluster, is_private
from armproof.verification.running.on_cluster import check_each_on, share
from armproof.verification.running.parcels import check_parcel, pack
from armproof.verification.running.processes import process_ended
from armproof.verification.running.servant import Servant, ServantEnded
from armproof.verification.verdict import DocumentResult, Failure
from tests.clusters import ROOT, Running
from tests.needs import needs

needs("distributed")
SHEETS = ("planar-2r-002", "polar-rp-002", "scara-000-cross-product")
WRONG = "---\narm: planar_2r\n---\n\n$$ p_2 = \\begin{bmatrix} l_1 C_1 + l_2 C_2 \\\\ l_1 S_1 + l_2 S_{12} \\\\ 0 \\end{bmatrix} $$\n"
MAIN = r"""% arm: planar_2r
\documentclass{article}
\usepackage{own}
\begin{document}
\input{parts/position}
\[ \reach = l_1 C_1 + l_2 C_{12} \]
\end{document}
"""
POSITION = r"\[ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 - l_2 S_{12} \\ 0 \end{bmatrix} \]" + "\n"
OWN_ARM = "---\narm: arms/own.urdf\n---\n\n$$ z_2 = \\begin{bmatrix} 1 \\\\ 0 \\\\ 0 \\end{bmatrix} $$\n"
UNREADABLE = "---\narm: [\n---\n\n$$ x = 1 $$\n"


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Twenty documents: right and wrong ones, one of several files, one with an arm of its own, one that cannot be read."""
    folder = tmp_path_factory.mktemp("corpus")
    for name in SHEETS:
        shutil.copy(ROOT / f"course/handouts/{name}.md", folder / f"0-{name}.md")
    (folder / "arms").mkdir()
    (folder / "parts").mkdir()
    shutil.copy(ROOT / "models/planar_2r/planar_2r.urdf", folder / "arms/own.urdf")
    (folder / "parts/position.tex").write_text(POSITION)
    (folder / "own.sty").write_text("\\newcommand{\\reach}{p_{2,x}}\n")
    for name, text in {"1-main.tex": MAIN, "2-own.md": OWN_ARM, "3-unreadable.md": UNREADABLE}.items():
        (folder / name).write_text(text)
    for k in range(14):
        (folder / f"4-wrong-{k:02}.md").write_text(WRONG.replace("C_2 ", f"C_2 + {k} l_1 "))
    return sorted(file for file in folder.iterdir() if file.suffix in (".md", ".tex"))


@pytest.fixture(scope="module")
def local(corpus: list[Path], tmp_path_factory: pytest.TempPathFactory) -> tuple[list[DocumentResult | Failure], Path]:
    """What this machine finds, and the folder of its report."""
    folder = tmp_path_factory.mktemp("local") / "report"
    return check_and_report(corpus, folder, jobs=1), folder


def test_the_report_is_that_of_this_machine_byte_for_byte_though_a_worker_is_killed_in_mid_run(
    running: Running, corpus: list[Path], local: tuple[list[DocumentResult | Failure], Path], tmp_path: Path
):
    here, there = local[1], tmp_path / "there"
    with new_report(there) as part, Cluster(running.address) as cluster:
        names = page_names(corpus)
        processes = cluster.on_each(os.getpid)
        checked = check_each_on(cluster, corpus, after=page_writer(part, names), correct=True)
        results = [next(checked)]
        busy, held = cluster._client.processing(), cluster._client.has_what()
        loaded = [worker for worker in processes if busy[worker] or held[worker]]  # they have what is not taken yet
        assert len(processes) == 2 and loaded
        os.kill(processes[loaded[-1]], signal.SIGKILL)
        results += checked
        assert len(corpus) == 20 and len(cluster.workers()) == 1
        write_index(part, names, results)
    pages = sorted(file.name for file in here.iterdir())
    assert len(pages) == 21 and pages == sorted(file.name for file in there.iterdir())  # of 19, an index, the verdicts
    assert all((here / name).read_bytes() == (there / name).read_bytes() for name in pages)


def test_the_documents_are_what_they_seem(local: tuple[list[DocumentResult | Failure], Path]):
    tex, own, unreadable = local[0][3:6]
    assert isinstance(tex, DocumentResult) and isinstance(own, DocumentResult) and isinstance(unreadable, Failure)
    assert [str(record.verdict) for record in tex.equations] == ["refuted", "proved"]
    assert [str(record.verdict) for record in own.equations] == ["refuted"]


def test_a_document_travels_with_what_it_inputs_or_not_at_all(corpus: list[Path], tmp_path: Path):
    _, tex, own, unreadable = (next(path for path in corpus if path.name.startswith(f"{k}-")) for k in range(4))
    parcel = pack(tex)
    assert parcel is not None and list(parcel.files) == ["1-main.tex", "own.sty", "parts/position.tex"]
    assert check_parcel(parcel, False)
    assert not check_parcel(pack(own), False)  # its arm is a file, which is another one elsewhere
    assert not check_parcel(pack(unreadable), False)
    assert pack(tmp_path / "none.md") is None
    (tmp_path / "a.tex").write_text("\\input{b}")
    (tmp_path / "b.tex").symlink_to(tex.parent / "parts/position.tex")
    assert pack(tmp_path / "a.tex").files.keys() == {"a.tex"}  # a link that leads out is not read here either
    (tmp_path / "c.tex").write_text("x")
    (tmp_path / "b.tex").unlink()
    (tmp_path / "b.tex").symlink_to(tmp_path / "c.tex")
    assert pack(tmp_path / "a.tex") is None


def test_portions_become_smaller_and_leave_nothing_out():
    paths = [Path(str(k)) for k in range(1000)]
    portions = list(share(paths, 2))
    sizes = [len(portion) for portion in portions]
    assert [path for portion in portions for path in portion] == paths
    assert sizes == sorted(sizes, reverse=True) and sizes[0] == 64 and sizes[-8:] == [1] * 8
    assert list(share([], 2)) == []


def test_a_servant_that_is_ended_serves_again(monkeypatch: pytest.MonkeyPatch):
    with Servant() as servant:
        with pytest.raises(ServantEnded):
            servant.ask(os._exit, 134)  # as Drake does when it aborts
        assert servant.ask(os.getpid) != os.getpid()
        process = servant._process
        monkeypatch.setattr(on_worker, "_idle", on_worker.SimpleQueue())
        monkeypatch.setattr(on_worker, "check_parcel", os._exit)
        on_worker._idle.put(servant)
        assert copy_context().run(on_worker.check_batch, False, "", "en", [None, None]) == [b"", b""]
        on_worker.dismiss()
    assert process.wait(5) and on_worker._idle.empty()
    assert str(process_ended(Path("a.md")).reason).startswith("the process that checked it ended")


def test_a_servant_of_whom_nothing_is_asked_ends_and_another_takes_its_place(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(servants, "IDLE", 0.0)
    pipe = Pipe()
    servants.serve(pipe[1])  # returns
    with Servant() as servant:
        first = servant.ask(os.getpid)
        servant._process.kill()
        servant._process.wait()
        assert servant.ask(os.getpid) != first


def test_a_worker_that_might_answer_otherwise_is_refused(running: Running, monkeypatch: pytest.MonkeyPatch):
    assert on_worker.guarded(on_worker.versions(), len, "abc") == 3
    other = on_worker.versions() | {"drake": "1.0"}
    with pytest.raises(ClusterError, match=r"drake [\d.]+ there, 1.0 here"):
        on_worker.guarded(other, len, "abc")  # one that comes later
    monkeypatch.setattr(clusters, "versions", lambda: other)
    cluster = Cluster(running.address)
    monkeypatch.undo()
    with pytest.raises(
        ClusterError, match=r"worker tls://127\.0\.0\.1:\d+: drake [\d.]+ there, 1.0 here; install the same"
    ):
        cluster.__enter__()


# -- what cannot be used -----------------------------------------------------------------------------------------------


def refusal(address: str) -> str:
    with pytest.raises(ClusterError) as problem, Cluster(address):
        pass
    return str(problem.value)


def test_an_address_where_nobody_answers_is_told(monkeypatch: pytest.MonkeyPatch):
    import dask
    import distributed  # noqa: F401 - its settings come with it, and would be lost with ours

    monkeypatch.setattr(clusters, "CONNECTING", 0.2)
    assert "no Dask scheduler at tcp://127.0.0.1:1: " in refusal("tcp://127.0.0.1:1")
    assert "is tcp://host:8786 or tls://host:8786, not host" in refusal("host")
    with dask.config.set({"distributed.comm.tls.ca-file": None, "distributed.comm.tls.client.cert": None}):
        assert "tls:// needs certificates: name them in DASK_DISTRIBUTED__COMM__TLS__CA_FILE" in refusal(
            "tls://127.0.0.1:1"
        )


def test_without_dask_it_is_said_how_to_install_it(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert refusal("tcp://127.0.0.1:1") == "--scheduler needs Dask: pip install 'armproof[cluster]'"


@pytest.mark.parametrize(
    ("status", "workers", "message"),
    [("running", {}, "has no workers"), ("closed", {"tcp://a:1": 1}, "does not answer any more"), ("running", {"tcp://a:1": 1}, "")],
)  # fmt: skip
def test_nobody_waits_for_a_cluster_that_is_gone(
    status: str, workers: dict, message: str, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(clusters, "PATIENCE", 0.0)
    monkeypatch.setattr(clusters, "LOOK", -1.0)
    cluster = Cluster("tcp://127.0.0.1:8786")
    cluster._client = SimpleNamespace(status=status, nthreads=lambda: workers)
    if message:
        with pytest.raises(ClusterError, match=message):
            cluster._look()
    else:
        cluster._seen = float("inf")
        cluster._look()


@pytest.mark.parametrize("address", ["tls://a.example:8786", "tcp://127.0.0.1:1", "127.8.0.1:1", "localhost:1", "tcp://[::1]:8786"])  # fmt: skip
def test_what_is_encrypted_or_stays_here_is_private(address: str):
    assert is_private(address)


@pytest.mark.parametrize("address", ["tcp://10.0.0.1:8786", "a.example:1", "tcp://localhost.a.example:1", "tcp://[::2]:1", "ws://10.0.0.1:1", "tcp://tls:1"])  # fmt: skip
def test_what_others_can_read_is_not(address: str):
    assert not is_private(address)


def test_the_command_refuses_what_does_not_go_with_a_cluster(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    from armproof.verification.cli import app

    (tmp_path / "a.md").write_text(WRONG)

    def said(*arguments: object) -> str:
        with pytest.raises(SystemExit) as end:
            copy_context().run(
                app, ["verify", str(tmp_path), *map(str, arguments)], prog_name="armproof"
            )  # it may speak French
        assert end.value.code == 2
        return capsys.readouterr().err

    assert "give --jobs or --scheduler" in said("--scheduler", "127.0.0.1:1", "--jobs", 2)
    assert said("--scheduler", "host").count("\n") == 1  # no traceback
    assert "l'adresse" in said("--scheduler", "host", "--lang", "fr")
