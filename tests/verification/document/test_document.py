"""Documents: every display is found, once, at its line, with its erratum mark; front matter; notebooks and lessons."""

import json
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armproof.verification.document import Display, Document, find_documents, read_document
from armproof.verification.errors import DocumentError

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def read(tmp_path: Path):
    """Write a file and read it as a document."""

    def read_text(text: str, name: str = "page.md") -> Document:
        path = tmp_path / name
        path.write_bytes(text.encode("utf-8"))
        return read_document(path)

    return read_text


def summary(displays: tuple[Display, ...]) -> list[tuple[int, str, bool]]:
    return [(display.line, display.latex.strip(), display.erratum) for display in displays]


# -- Markdown ----------------------------------------------------------------------------------------------------------

# A block of Markdown with its display k (None: what looks like one and is not), and whether it is an erratum.
BLOCKS = {
    "prose": ("Some prose with $a_{k}$ and a price of 3\\$.", False, False),
    "two lines of prose": ("One line\nand another, $b$.", False, False),
    "display": ("$$ a_{k} = 1 $$", True, False),
    "display on lines": ("$$\na_{k}\n= 1\n$$", True, False),
    "display with a blank line": ("$$\na_{k} =\n\n1\n$$", True, False),
    "display after prose": ("It follows that\n$$ a_{k} = 1 $$", True, False),
    "display within prose": ("The first\nline, $$ a_{k} = 1 $$ and more", True, False),
    "display in emphasis": ("The **equation $$ a_{k} = 1 $$** holds", True, False),
    "display in a list": ("- first\n\n  $$ a_{k} = 1 $$\n- second", True, False),
    "display in a numbered list": ("1. first\n   $$\n   a_{k} = 1\n   $$", True, False),
    "labelled display": ("$$ a_{k} = 1 $$ (eq:{k})", True, False),
    "heading": ("## Section {k}", False, False),
    "fence": ("```latex\n$$ a_{k} = 1 $$\n```", False, False),
    "tilde fence": ("~~~\n$$ a_{k} = 1 $$\n~~~", False, False),
    "indented code": ("    $$ a_{k} = 1 $$", False, False),
    "code span": ("The source is `$$ a_{k} = 1 $$` here", False, False),
    "comment": ("<!-- $$ a_{k} = 1 $$ -->", False, False),
    "quote": ("> A remark\n> $$ a_{k} = 1 $$", True, False),
    "erratum": ("> **Erratum** (as printed)\n> $$ a_{k} = 1 $$", True, True),
    "erratum on lines": ("> **Erratum.**\n>\n> $$\n> a_{k}\n> = 1\n> $$", True, True),
    "errata in italics": ("> *Errata*, line 3: $$ a_{k} = 1 $$", True, True),
    "erratum in a list": ("- item\n\n  > **Erratum**\n  > $$ a_{k} = 1 $$", True, True),
    "erratum in a quote": ("> > **Erratum**\n> > $$ a_{k} = 1 $$", True, True),
    "no erratum": ("> An erratum is marked like this\n> $$ a_{k} = 1 $$", True, False),
    "table": ("| i | a |\n|---|---|\n| 1 | $a_{k}$ |", False, False),
}  # fmt: skip
FRONTS = ["", "---\ntitle: x\n---\n", "---\narm: scara\ntitle: y\n---\n\n"]


@given(st.lists(st.sampled_from(sorted(BLOCKS)), max_size=12), st.sampled_from(FRONTS), st.sampled_from(["\n", "\r\n"]))
def test_every_display_is_found_once_at_its_line_with_its_mark(
    tmp_path_factory, names: list[str], front: str, newline: str
):
    text, expected = front, []
    for k, name in enumerate(names):
        block, holds_display, erratum = BLOCKS[name]
        line = text.count("\n") + 1 + block[: block.find("$$")].count("\n")
        if holds_display:
            expected.append((line, f"a_{{{k}}}=1", erratum))
        text += block.replace("{k}", f"{{{k}}}") + "\n\n<!-- -->\n\n"  # a comment ends a list
    path = tmp_path_factory.mktemp("documents") / "page.md"
    path.write_bytes(text.replace("\n", newline).encode())
    found = [
        (line, re.sub(r"\s", "", latex), erratum) for line, latex, erratum in summary(read_document(path).displays)
    ]
    assert found == expected


@pytest.mark.parametrize("path", sorted((ROOT / "course" / "handouts").glob("*.md")), ids=lambda path: path.stem)
def test_no_display_of_a_handout_is_dropped(path: Path):
    lines = path.read_text(encoding="utf-8").splitlines()
    document = read_document(path)
    assert 2 * len(document.displays) == sum(re.sub(r"`.*?`", "", line).count("$$") for line in lines)
    for display in document.displays:
        assert "$$" in lines[display.line - 1]
        assert display.latex.strip().splitlines()[0].strip() in "\n".join(lines[display.line - 1 : display.line + 1])


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("$$ 1 = 1", 1),
        ("\n\n$$\n1 = 1\n\nMore.", 3),
        ("text $$ 1 = 1\nmore", 1),
        ("$$ 1 = 1 $$\n\nand $$ 2\n", 3),
        ("> $$ 1\n\nx", 1),
    ],
)
def test_a_display_that_never_ends_is_not_dropped(read, text: str, line: int):
    *_, display = read(text).displays
    assert (display.line, display.closed) == (line, False)


def test_two_displays_in_one_line_are_two(read):
    assert summary(read("so $$ a = 1 $$ and $$ b = 2 $$.\n").displays) == [(1, "a = 1", False), (1, "b = 2", False)]


def test_a_display_deep_in_quotes_is_found(read):
    assert summary(read("> " * 20 + "$$ a = 1 $$\n").displays) == [(1, "a = 1", False)]


def test_a_display_knows_its_section(read):
    document = read("$$ 0 = 0 $$\n\n# First\n\n$$ 1 = 1 $$\n\nSecond, $z_2$\n---\n\n$$ 2 = 2 $$\n")
    assert [display.section for display in document.displays] == ["", "First", "Second, $z_2$"]


def test_a_table_keeps_its_latex_and_its_place(read):
    document = read(
        "A table.\n\n| $i$ | $\\alpha_i$ |\n|:--|---:|\n| 1 | $\\pi/2$ |\n| $2$ | 0 |\n\n> **Erratum**\n>\n> | a |\n> |---|\n> | 1 |\n"
    )
    first, erratum = document.tables
    assert (first.line, first.header, first.rows) == (3, ("i", r"\alpha_i"), (("1", r"\pi/2"), ("2", "0")))
    assert (erratum.line, erratum.erratum, erratum.rows) == (10, True, (("1",),))
    assert not first.erratum


# -- front matter ------------------------------------------------------------------------------------------------------


def test_front_matter_is_read_with_the_line_of_each_key(read):
    document = read("---\ntitle: x\n# a remark\narm: scara\nsymbols:\n  l_1: a_1\n---\n$$ 1 = 1 $$\n")
    assert document.front == {"title": "x", "arm": "scara", "symbols": {"l_1": "a_1"}}
    assert [document.at(key).rpartition(":")[2] for key in ("title", "arm", "symbols")] == ["2", "4", "5"]
    assert document.displays[0].line == 8


@pytest.mark.parametrize("text", ["$$ 1 = 1 $$\n", "---\n---\n$$ 1 = 1 $$\n", "\n---\n\n$$ 1 = 1 $$\n"])
def test_a_document_may_have_no_front_matter(read, text: str):
    document = read(text)
    assert document.front == {}
    assert len(document.displays) == 1


def test_the_keys_of_other_tools_are_left_alone(read):
    assert (
        read("---\njupytext: {text_representation: {}}\nkernelspec: {name: python3}\narm: rx90\n---\n").front["arm"]
        == "rx90"
    )


@pytest.mark.parametrize(
    ("front", "message"),
    [
        ("arm: scara\ntitle: x\narm: rx90", r":4: the front-matter key 'arm' stands twice, first in line 2"),
        ("arm:", r":2: 'arm' is empty; name an arm, a model file or a DH table, or leave the key out"),
        ("title: &x a\narm: *x", r":3: the front matter may not repeat a part by '\*x'; write it out"),
        ("title: 'x\nlayout: }\narm: [scara\ntags: x", r":\d: the front matter is not YAML: "),
        ("title: x: y\ntransforms: 'upper", r":\d: the front matter is not YAML: "),
        ("- arm: scara", r":2: the front matter must be a mapping of keys such as 'arm: scara'"),
    ],
)
def test_front_matter_at_fault_is_refused_at_its_line(read, front: str, message: str):
    with pytest.raises(DocumentError, match=rf"page\.md{message}"):
        read(f"---\n{front}\n---\n")


FOREIGN = {
    "Jekyll": "layout: post\npermalink: /x/\nexcerpt_separator: <!--more-->\nlast modified: today",
    "Quarto": "format:\n  html:\n    toc: true\nauthor:\n  - name: X\nexecute: {echo: false}",
    "Docusaurus": "id: x\nsidebar_position: 3\ntags: [a, b]",
    "no date": "date: 2020-13-45",
    "a colon": "description: a: b",
    "a template": "permalink: {{ page.url }}",
    "a tab": "tags:\n\t- a",
    "twice": "tags: a\ntags: b",
    "repeated": "x: &a [1]\ny: [*a, *a]",
    "left open": "summary: 'x",
}


@pytest.mark.parametrize("tool", FOREIGN)
@pytest.mark.parametrize("name", ["page.md", "page.tex", "page.rst"])
def test_the_keys_of_other_tools_never_stop_a_document_and_are_told_once(read, tool: str, name: str):
    block = f"title: On arms: a note\n{FOREIGN[tool]}\narm: scara"
    form = {"page.md": "---\n{}\n---\n\n$$ 1 = 1 $$\n", "page.tex": "% ---\n% {}\n% ---\n\\[ 1 = 1 \\]\n"}
    comment = {"page.md": "\n", "page.tex": "\n% ", "page.rst": "\n   "}[name]
    text = form.get(name, "..\n   ---\n   {}\n   ---\n\n.. math:: 1 = 1\n").format(block.replace("\n", comment))
    document = read(text, name)
    assert (document.front["arm"], document.front["title"]) == ("scara", "On arms: a note")
    (remark,) = document.remarks
    assert FOREIGN[tool].partition(":")[0] in str(remark) and "arm, convention, symbols" in str(remark)
    assert [display.latex.strip() for display in document.displays] == ["1 = 1"]


@pytest.mark.parametrize(
    "head", ["+++\ntitle = 'x'\narm = 3\n+++\n", "---\n\nWords, and more\n\n---\n", "---\n# Notes\n"]
)
def test_what_is_no_front_matter_of_ours_is_none(read, head: str):
    document = read(head + "\n$$ 1 = 1 $$\n")
    assert document.front == {} and len(document.remarks) == head.startswith("+++")
    assert [(display.line, display.latex.strip()) for display in document.displays] == [(head.count("\n") + 2, "1 = 1")]


def test_displays_between_two_rules_are_no_front_matter(read):
    assert len(read("---\nNote: this\n\n$$ 1 = 1 $$\n\n---\n\n$$ 2 = 2 $$\n").displays) == 2


# -- notebooks and lessons ---------------------------------------------------------------------------------------------


def notebook(*cells: tuple[str, str | list[str]]) -> str:
    return json.dumps({"nbformat": 4, "cells": [{"cell_type": kind, "source": source} for kind, source in cells]})


def test_the_markdown_cells_of_a_notebook_are_read_by_cell_and_line(read):
    document = read(
        notebook(
            ("raw", "---\narm: scara\n---"),
            ("code", "$$ 0 = 0 $$"),
            ("markdown", ["First.\n", "\n", "$$ 1 = 1 $$"]),
            ("markdown", "> **Erratum**\n> $$ 2 = 3 $$"),
        ),
        "lesson.ipynb",
    )
    assert document.front == {"arm": "scara"}
    assert [(display.cell, display.line, display.erratum) for display in document.displays] == [
        (2, 3, False),
        (3, 2, True),
    ]


def test_a_notebook_of_version_3_is_read_by_its_worksheets(read):
    heading = {"cell_type": "heading", "level": 2, "source": ["Arms"]}
    cells = [heading, {"cell_type": "code", "input": "x"}, {"cell_type": "markdown", "source": ["$$ 1 = 1 $$"]}]
    document = read(
        json.dumps({"nbformat": 3, "worksheets": [{"cells": cells[:2]}, {"cells": cells[2:]}]}), "old.ipynb"
    )
    assert [(display.cell, display.line, display.section) for display in document.displays] == [(2, 1, "")]


def test_an_empty_notebook_is_an_empty_document(read):
    assert read("", "empty.ipynb").displays == ()


def test_front_matter_may_share_a_cell_with_displays(read):
    document = read(notebook(("markdown", "---\narm: scara\n---\n\n$$ 1 = 1 $$")), "lesson.ipynb")
    assert document.front == {"arm": "scara"}
    assert [(display.cell, display.line) for display in document.displays] == [(0, 5)]


LESSON = """\
# %% [markdown]
# ---
# arm: scara
# title: x
# ---
#
# $$ 1 = 1 $$

# %%
text = "$$ 2 = 2 $$"

# %% [markdown] tags=["check"]
# > **Erratum**
# > $$
# > 3 = 4
# > $$
"""


def test_the_markdown_cells_of_a_lesson_are_read_at_the_lines_of_its_file(read):
    document = read(LESSON, "lesson.py")
    assert document.front == {"arm": "scara", "title": "x"}
    assert document.at("title").endswith("lesson.py:4")
    assert summary(document.displays) == [(7, "1 = 1", False), (14, "3 = 4", True)]


def test_a_fault_in_the_front_matter_of_a_lesson_is_at_the_line_of_its_file(read):
    with pytest.raises(DocumentError, match=r"lesson\.py:4: 'arm' is empty"):
        read(LESSON.replace("# arm: scara\n# title: x", "# title: x\n# arm:"), "lesson.py")


@pytest.mark.parametrize(
    "text", ["not JSON", "[]", "{}", '{"cells": 3}', '{"cells": [{"source": ""}]}', '{"cells": [[]]}']
)
def test_a_notebook_that_is_none_is_refused_with_its_line(read, text: str):
    with pytest.raises(DocumentError, match=r"lesson\.ipynb:1: not a notebook: "):
        read(text, "lesson.ipynb")


# -- folders -----------------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of documents among other files."""
    files = {
        "b.md": "$$ 1 = 1 $$",
        "a/c.ipynb": notebook(("markdown", "$$ 1 = 1 $$")),
        "a/lesson.py": LESSON,
        "a/module.py": 'PRICE = "$$"\n',
        "arm.md": "---\narm: scara\n---\nNo formula yet.",
        "notes.md": "No formula.",
        "figure.svg": "$$ 1 = 1 $$",
        ".hidden/d.md": "$$ 1 = 1 $$",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def test_the_documents_of_a_folder_are_found_in_order(folder: Path):
    found = [str(path.relative_to(folder)) for path in find_documents([folder])]
    assert found == ["a/c.ipynb", "a/lesson.py", "arm.md", "b.md"]


CELL = "# %% [markdown]\n# $$ a = b $$\n"


def test_what_stands_in_a_programs_strings_makes_it_no_document(tmp_path: Path):
    texts = {
        "lesson.py": CELL,
        "lesson_with_string.py": 'text = "a"\n' + CELL,
        "unfinished.py": "x = (\n" + CELL,
        "marker_in_string.py": f'LESSON = """\n{CELL}"""\n',
        "marker_behind_code.py": 'LESSON = "# %% [markdown]\\n# $$ a = b $$"\n',
    }
    for name, text in texts.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    found = find_documents([tmp_path])
    assert [path.name for path in found] == ["lesson.py", "lesson_with_string.py", "unfinished.py"]
    assert all(len(read_document(path).displays) == 1 for path in found)


def test_a_file_named_is_a_document_whatever_it_holds(folder: Path):
    paths = [folder / "notes.md", folder / "b.md", folder / "notes.md"]
    assert find_documents(paths) == paths[:2]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("missing.md", r"missing\.md: no such file or folder"),
        ("figure.svg", r"figure\.svg: '\.svg' files are not read; those that are: \.md, \.ipynb, \.py"),
        (".hidden/none", r"none: no such file or folder"),
    ],
)
def test_what_is_no_document_is_refused(folder: Path, name: str, message: str):
    with pytest.raises(DocumentError, match=message):
        find_documents([folder / name])


def test_a_folder_without_documents_is_refused(folder: Path):
    (folder / "empty").mkdir()
    with pytest.raises(
        DocumentError,
        match=r"empty: no document in this folder; a document is a \.md, \.ipynb, \.py, \.qmd, \.tex, \.rst file",
    ):
        find_documents([folder / "empty"])


WESTERN = ["Vitesse en rad/s, angle donné : \u2019\u2026", "é", "\u20ac"]


@pytest.mark.parametrize("text", WESTERN)
@pytest.mark.parametrize("encoding", ["cp1252", "utf-16", "utf-8"])
def test_old_encodings_are_read_with_a_remark(tmp_path: Path, text: str, encoding: str):
    (tmp_path / "page.md").write_bytes(f"{text}\n\n# {text}\n\n$$ 1 = 1 $$\n".encode(encoding))
    document = read_document(tmp_path / "page.md")
    assert [(display.line, display.section) for display in document.displays] == [(5, text)]
    assert len(document.remarks) == (encoding == "cp1252")


def test_one_wrong_byte_spoils_no_other_letter(tmp_path: Path):
    (tmp_path / "page.md").write_bytes("# é".encode() + b" \xe9\n\n$$ 1 = 1 $$\n")
    assert [display.section for display in read_document(tmp_path / "page.md").displays] == ["é é"]


@pytest.mark.parametrize("data", [b"\x00\x80", b"\x89PNG\r\n\x1a\n\xff"])
def test_a_file_that_is_not_text_is_refused(tmp_path: Path, data: bytes):
    (tmp_path / "page.md").write_bytes(data)
    with pytest.raises(DocumentError, match=r"page\.md:1: not a text file in UTF-8 \(byte [01]\)"):
        read_document(tmp_path / "page.md")


def test_a_byte_order_mark_is_no_text(tmp_path: Path):
    (tmp_path / "page.md").write_bytes(b"\xef\xbb\xbf---\narm: scara\n---\n")
    assert read_document(tmp_path / "page.md").front == {"arm": "scara"}
