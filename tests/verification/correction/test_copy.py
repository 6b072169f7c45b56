"""The corrected copy of a document: only what is wrong changes, in every format, and the file is written whole or not."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from armproof.verification.check import verify
from armproof.verification.cli import app
from armproof.verification.document import find_documents, parse_document
from armproof.verification.document.notebook_text import rewrite_cells
from armproof.verification.errors import DocumentError
from armproof.verification.running import atomic
from armproof.verification.running.atomic import write_atomically
from armproof.verification.running.corrected_copy import correct_file, correct_text, save
from tests.sweeps.correct import HANDOUTS, copies

FRONT = "---\narm: planar_2r\ntitle: Bras à deux axes\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n"
WRONG = (
    r"J_v = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & l_2 S_{12} \\"
    + "\n"
    + r"l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}"
)
RIGHT = WRONG.replace("& l_2 S_{12}", "& -l_2 S_{12}")
QUOTED = "> " + WRONG.replace("\n", "\n> ")
ERRATUM = "> **Erratum**\n> $$ C_{12} = S_{12} $$\n"
TABLE = "| i | a | α | d | θ |\n|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | 0 | 0 | 0 | $\\theta_2$ |\n"


@pytest.fixture
def correct(capfdbinary: pytest.CaptureFixture[bytes]) -> Callable[..., tuple[int, str, str]]:
    """Run `armproof correct` in this process; return its code and the two streams."""

    def run(*arguments: object) -> tuple[int, str, str]:
        with pytest.raises(SystemExit) as end:
            app(["correct", *map(str, arguments)], prog_name="armproof")
        captured = capfdbinary.readouterr()
        return int(end.value.code or 0), captured.out.decode(), captured.err.decode()

    return run


def write(path: Path, text: str) -> Path:
    path.write_bytes(text.encode("utf-8"))
    return path


def commented(text: str) -> str:
    return "".join(f"# {line}".rstrip() + "\n" for line in text.splitlines())


DOCUMENTS = {
    "page.md": f"{FRONT}\n# Étude\n\n$$ {WRONG} $$\n\n{ERRATUM}",
    "crlf.md": f"{FRONT}\n$$ {WRONG} $$\n".replace("\n", "\r\n"),
    "mark.md": f"\ufeff{FRONT}\n$$\n{WRONG}\n$$\n",
    "quote.md": f"{FRONT}\n> $$\n{QUOTED}\n> $$\n",
    "inline.md": f"{FRONT}\nAs in `$$ 1 = 2 $$` one has $$ C_1 = C_1 $$ and\n$$ {WRONG} $$ as above.",
    "list.md": f"{FRONT}\n- so\n\n  $$ {WRONG.replace(chr(10), ' ')} $$\n",
    "page.tex": "% ---\n" + "".join(f"% {line}\n" for line in FRONT.splitlines()[1:-1])
                + f"% ---\n\\begin{{document}}\n\\begin{{equation}} % so\n{WRONG}\n\\end{{equation}}\n\\end{{document}}",
    "macro.tex": "% arm: planar_2r\n% quantities: {J_v: {jacobian: 2, rows: [1, 2]}}\n\\newcommand{\\tool}{J_v}\n\\def\\s#1{S_{#1}}\n"
                 + f"\\[ {WRONG} % \\] \n\\]\n".replace("J_v =", "\\tool ="),
    "page.rst": "..\n" + "".join(f"  {line}\n" for line in FRONT.splitlines()[1:-1])
                + "\n.. math::\n\n   " + WRONG.replace("\n", "\n   ") + "\n",
    "myst.qmd": f"{FRONT}\n:::{{note}}\n```{{math}}\n:label: eq\n\n{WRONG}\n```\n:::\n",
    "lesson.py": "# %% [markdown]\n" + commented(FRONT) + "\n# %%\nx = 1\n\n# %% [markdown]\n"
                 + commented(f"So\n\n$$\n{WRONG}\n$$\n"),
    "lines.ipynb": json.dumps({"cells": [{"cell_type": "markdown", "source": FRONT}, {"cell_type": "code", "source": "é = 1"},
                              {"cell_type": "markdown", "source": f"Été 😀\n\n$$ {WRONG} $$ 😀".splitlines(keepends=True)}]}, indent=1),
    "one.ipynb": json.dumps({"cells": [{"source": f"{FRONT}\nÉté 😀 $$ {WRONG} $$", "cell_type": "markdown"}],
                             "metadata": {}}, ensure_ascii=False),
}  # fmt: skip


@pytest.mark.parametrize("name", DOCUMENTS)
def test_only_the_wrong_cell_of_a_file_changes(correct, tmp_path: Path, name: str) -> None:
    path = write(tmp_path / name, DOCUMENTS[name])
    assert not verify(path).passed
    code, out, err = correct(path)
    assert (code, err) == (0, "")
    assert path.read_bytes().decode() == DOCUMENTS[name]  # the original stays
    wrong, right = ("& l_2 S_{12}", "& -l_2 S_{12}")
    assert out.lstrip("\ufeff") == DOCUMENTS[name].lstrip("\ufeff").replace(wrong, right)
    copy = write(tmp_path / f"copy{path.suffix}", out)
    assert verify(copy).passed
    assert correct(copy) == (0, out, "")  # nothing more to correct


def test_a_table_is_corrected_in_its_cell(tmp_path: Path) -> None:
    text = f"{FRONT}\n{TABLE}"
    copy = correct_text(tmp_path / "page.md", text)
    assert copy.first.tables and not copy.first.tables[0].passes
    assert copy.after == text.replace("| 2 | 0 |", "| 2 | $l_2$ |")
    assert not copy.remaining


def test_a_table_without_bars_at_its_edges_is_corrected_in_its_first_cell(tmp_path: Path) -> None:
    rows = "a | alpha | d | theta | i\n--|--|--|--|--\nl_1 | 0 | 0 | \\theta_1 | 1\nl_1 | 0 | 0 | \\theta_2 | 2\n"
    copy = correct_text(tmp_path / "page.md", f"{FRONT}\n{rows}")
    assert copy.after == f"{FRONT}\n{'$l_2$'.join(rows.rsplit('l_1', 1))}"
    assert not copy.remaining


def test_what_builds_on_a_corrected_display_is_corrected_too(tmp_path: Path) -> None:
    text = f"{FRONT}\n$$ {WRONG} $$\n\n$$ \\det J_v = l_1 l_1 S_2 $$\n\n$$ J_v^T = \\begin{{bmatrix}} 1 & 0 \\\\ 0 & 1 \\end{{bmatrix}} $$\n"
    copy = correct_text(tmp_path / "page.md", text)
    assert not copy.remaining, copy.after


def test_a_difference_is_a_patch(correct, tmp_path: Path) -> None:
    path = write(tmp_path / "page.md", f"{FRONT}\n$$ {WRONG} $$")
    code, out, _ = correct(path, "--diff")
    assert code == 0
    changed = [line for line in out.splitlines() if re.match(r"[-+](?![-+])", line)]
    assert changed == [f"-$$ {WRONG.splitlines()[0]}", f"+$$ {RIGHT.splitlines()[0]}"]
    assert out.splitlines()[0] == f"--- {path}"
    assert "\\ No newline at end of file" in out
    assert correct(write(tmp_path / "right.md", f"{FRONT}\n$$ {RIGHT} $$"), "--diff") == (0, "", "")


def test_what_cannot_be_corrected_is_said(correct, tmp_path: Path) -> None:
    erratum = "> **Erratum**\n> $$ C_{12} = C_{12} $$\n"
    path = write(tmp_path / "page.md", f"{FRONT}\n$$ {WRONG} $$\n\n$$ C_1 = }} $$\n\n{erratum}")
    code, out, err = correct(path)
    assert code == 1
    assert "& -l_2 S_{12}" in out
    first, second = err.splitlines()
    assert first.startswith(f"armproof: {path}:11: not corrected: unreadable, line 11, column 8 of the display: ")
    assert second == f"armproof: {path}:14: not corrected: erratum not refuted but proved"
    notebook = {"cells": [{"cell_type": "markdown", "source": f"{FRONT}\n$$ C_1 = }} $$"}]}
    _, _, err = correct(write(tmp_path / "lesson.ipynb", json.dumps(notebook)))
    assert "lesson.ipynb: cell 0, line 8: not corrected: unreadable" in err


# -- writing -----------------------------------------------------------------------------------------------------------


def test_the_document_is_overwritten_only_when_asked(correct, tmp_path: Path) -> None:
    path = write(tmp_path / "page.md", DOCUMENTS["mark.md"])
    path.chmod(0o640)
    link = tmp_path / "link.md"
    link.symlink_to(path)
    code, _, err = correct(path, "--output", link)
    assert (code, err) == (2, f"armproof: {link}: this is the document itself, which only --in-place overwrites\n")
    assert correct(path, "--output", tmp_path / "copy.md") == (0, "", "")
    assert path.read_bytes().decode() == DOCUMENTS["mark.md"]
    assert correct(link, "--in-place") == (0, "", "")
    assert path.read_bytes() == (tmp_path / "copy.md").read_bytes()
    assert path.read_bytes().startswith(b"\xef\xbb\xbf---")
    assert (path.stat().st_mode & 0o777, link.is_symlink()) == (0o640, True)
    assert sorted(child.name for child in tmp_path.iterdir()) == ["copy.md", "link.md", "page.md"]


def test_a_right_document_is_not_written_again(correct, tmp_path: Path) -> None:
    path = write(tmp_path / "page.md", f"{FRONT}\n$$ {RIGHT} $$\n")
    before = path.stat()
    assert correct(path, "--in-place") == (0, "", "")
    assert (path.stat().st_mtime_ns, path.stat().st_ino) == (before.st_mtime_ns, before.st_ino)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--diff", "--in-place"], "give one of --diff, --output and --in-place"),
        (["--output", "missing/copy.md"], "missing/copy.md: cannot be written: No such file or directory"),
    ],
)
def test_what_cannot_be_done_is_refused(
    correct, tmp_path: Path, monkeypatch, arguments: list[str], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    path = write(Path("page.md"), DOCUMENTS["page.md"])
    code, out, err = correct(path, *arguments)
    assert (code, out) == (2, "")
    assert err.startswith(f"armproof: {message}")
    assert path.read_text(encoding="utf-8") == DOCUMENTS["page.md"]


@pytest.mark.parametrize(
    ("name", "message"),
    [("missing.md", "no such file"), (".", "not a file; one document is corrected at a time"), ("page.txt", "'.txt' files are not read")],
)  # fmt: skip
def test_what_is_no_document_is_refused(correct, tmp_path: Path, name: str, message: str) -> None:
    write(tmp_path / "page.txt", "x")
    code, out, err = correct(tmp_path / name)
    assert (code, out) == (2, "")
    assert err.startswith(f"armproof: {tmp_path / name}: {message}")


def test_a_document_that_was_saved_meanwhile_is_not_overwritten(tmp_path: Path) -> None:
    path = write(tmp_path / "page.md", DOCUMENTS["page.md"])
    copy = correct_file(path)
    write(path, DOCUMENTS["page.md"] + "\nOne more line.\n")
    with pytest.raises(DocumentError, match="it has changed since it was read"):
        save(copy, path)
    assert path.read_text(encoding="utf-8").endswith("One more line.\n")


def test_a_write_that_fails_leaves_the_file_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write(tmp_path / "page.md", "old")

    def fail(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic.os, "replace", fail)
    with pytest.raises(OSError, match="No space left"):
        write_atomically(path, b"new")
    assert path.read_text() == "old"
    assert [child.name for child in tmp_path.iterdir()] == ["page.md"]


def test_a_new_file_has_the_usual_mode(tmp_path: Path) -> None:
    previous = os.umask(0o027)
    try:
        write_atomically(tmp_path / "new.md", b"x")
    finally:
        os.umask(previous)
    assert (tmp_path / "new.md").stat().st_mode & 0o777 == 0o640


def test_the_strings_of_a_notebook_keep_their_escapes() -> None:
    text = '{"cells": [{"source": ["a\\u00e9\\ud83d\\ude00\\n", "\\\\alpha \\"x\\" b"]}], "é": 1}'
    assert json.loads(text)["cells"][0]["source"] == ["aé😀\n", '\\alpha "x" b']
    edits = [((1, 3), (1, 3), "Z"), ((2, 0), (2, 6), "\\beta"), ((2, 11), (2, 12), "c\té")]
    changed = rewrite_cells(text, {0: edits})
    assert changed == text.replace("\\ude00", "\\ude00Z").replace("\\\\alpha", "\\\\beta").replace(" b", " c\\té")


# -- the course --------------------------------------------------------------------------------------------------------

WITH_ERRATA = [
    path for path in find_documents([HANDOUTS]) if "errat" in (text := path.read_text("utf-8")).lower()
    and any(display.erratum for display in parse_document(path, text).displays)
]  # fmt: skip


@pytest.mark.parametrize("path", WITH_ERRATA, ids=[path.stem for path in WITH_ERRATA])
def test_a_handout_with_its_errata_put_back_is_corrected(path: Path) -> None:
    _, text, number = next(copies(path))
    copy = correct_text(path, text)
    assert number and copy.first.passed is False
    assert not copy.remaining
